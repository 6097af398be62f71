"""Occlusion: a scene cut into layers of similar defocus, composited from front to back."""

from __future__ import annotations

import copy
import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.core import engine
from lommel.imaging.bank import Bank
from lommel.imaging.blur import DepthBlur, Points, parts
from lommel.imaging.linear import LinearBlur
from lommel.imaging.sensor_light import sums_of_quarters
from lommel.optics.pupil import ray_height


class Group(NamedTuple):
    """Points that spread windows of one bank."""

    sources: list[tuple[int, Points]]  # 0 for light of the scene, 1 for light behind it
    bank: Bank | None = None  # if another than that of the channel
    hidden: bool = True  # whether pixels see only some of it
    taken_off: bool = False  # whether it is subtracted


def spread_groups(
    blur: DepthBlur, channel: int, planes: Sequence[Values], seen: Values, groups: list[Group]
) -> Values:
    """Return the image of light of a scene, and of light behind it, in one channel."""
    total = np.zeros(blur.shape, dtype=blur.dtype)
    for group in groups:
        given = [(planes[behind], points) for behind, points in group.sources]
        made = blur.spread(channel, given, seen if group.hidden else None, bank=group.bank)
        total += -made if group.taken_off else made
    if blur.beyond is not None:
        total += blur.beyond.act(blur, [channel], [planes[0]])[0]
    return total


MOST_LAYERS = 64  # layers are made thicker than a pixel of blur where there would be more of them

# The share of a point's sharp light that it keeps, so that what is divided by is never 0.
_TRACE = 1e-9


class Layering(NamedTuple):
    """Layers of points by depth, and what they hide."""

    layers: NDArray[np.uint8]  # of each point, 0 the nearest that there is
    behind: NDArray[np.int32] | None  # flat index of the point that stands for what each point hides, or -1; or none
    number: int  # of layers

    @property
    def level(self) -> int:
        """Number of the first layer, counted from the middle one: what is seen of layers is then rounded less."""
        return -(self.number // 2)

    def edges(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Return flat indices of the points that hide something, and of those that stand for it."""
        if self.behind is None:
            return (np.empty(0, dtype=np.int64),) * 2
        points = np.flatnonzero(self.behind >= 0)
        return points, self.behind.reshape(-1)[points].astype(np.int64)


class Shares(NamedTuple):
    """What pixels see in one channel, from the depth alone."""

    seen: (
        Values  # the layers that each pixel sees, from the front: of the last one in part, of those behind it nothing
    )
    total: Values  # the image of a white scene


class Occlusion(LinearBlur):
    r"""Blur by depth with occlusion, near points before far ones: a linear operator, with its transpose.

    Points are sorted into layers, within each of which the circle of confusion changes by a pixel (or by a 64th of
    its range over the scene, if that is more). From the nearest layer to the farthest, the light B and the coverage A
    (the same for a white scene) are blurred, each point by its own PSF, and added as far as nearer layers have left
    the aperture open: ``out = sum w B / A``, ``w = min(A, 1 - sum of w before)``.

    Coverages are added, up to the full aperture, rather than multiplied as for independent screens (``T *= 1 - A``):
    points of one slanted surface lie in many layers and cover disjoint parts of the aperture. A product would leave
    such a surface transparent and weigh its near points more; with the sum, the result is that of
    :meth:`lommel.imaging.DepthBlur.forward` wherever nothing is occluded, except for a normalisation that keeps a
    white scene white where the blur varies. Two separate screens in front of a third surface cover slightly too much
    of it.

    Where a near surface ends in front of a far one, the lens sees some points behind it that the image does not show:
    those closer to the edge than the difference of the radii of their circles of confusion. There a second, hidden
    point is added, with the light and defocus of the far surface mirrored at the edge. Dividing by the coverage
    instead would leave a sharp line in the blurred edge of a near object, at the last pixel where the far surface is
    known; repeating its last point would draw streaks out of highlights. The remaining gaps, behind surfaces that are
    hidden twice or at steep slopes of depth, are filled by dividing by the sum of w.

    The ratio w / A is 1 for the layers before the aperture is full, 0 for those after it, and a fraction for the one
    that fills it: one real number per pixel, the number of visible layers, holds them all. The occlusion depends on
    the depth alone. At the first call for a depth map it is computed together with the image, which takes 1.3 to 2.7
    times as long as :meth:`lommel.imaging.DepthBlur.forward`; from the second call or the first :meth:`adjoint` on it
    is kept, and a call takes 1.1 to 1.5 times as long. Results are the same to the last bit.

    With ``energy=1`` this applies to the windows; the light beyond them, one percent, is not occluded, and points
    that are partly hidden cost twice as much.

    Memory: 5 bytes per point; 8 per point and channel (16 in float64) during the first call, kept from the second on;
    with :meth:`adjoint` or ``energy=1`` up to 32 more.

    Parameters
    ----------
    blur : DepthBlur
    reach : (float, float), optional
        Smallest and largest defocus C_d (radians) of the whole scene, where `blur` has only part of it; defines the
        layers.

    Raises
    ------
    TypeError
        If `blur` is not a DepthBlur.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    >>> depth = np.full((40, 60), 4.0)
    >>> depth[:, 20:] = 1.6
    >>> seen = Occlusion(DepthBlur(depth, lens, 8e-6, dtype=np.float64))
    >>> a, b = np.random.default_rng(0).random((2, 40, 60))
    >>> bool(np.isclose(np.vdot(seen.forward(a), b), np.vdot(a, seen.adjoint(b)), rtol=1e-12))
    True
    """

    # Of the defocus and the banks that come first: layers, and by bank what pixels see and the groups of points.
    _made: tuple[Array, tuple[Bank, ...], Layering, dict[Bank, Shares], dict[Bank, list[Group]]] | None = None

    def __init__(self, blur: DepthBlur, reach: tuple[float, float] | None = None) -> None:
        if not isinstance(blur, DepthBlur):
            raise TypeError(f"blur must be a DepthBlur, got {type(blur).__name__}")
        self.blur, self._reach = blur, reach
        self.channels, self.dtype = blur.channels, blur.dtype

    @property
    def shape(self) -> tuple[int, int]:  # type: ignore[override]  # `blur` may be placed on another one
        """Height and width of the images."""
        return self.blur.shape

    def forward(self, image: Values) -> Values:
        """Return the image that the lens makes of an `image`: see :meth:`lommel.imaging.LinearBlur.forward`."""
        whole, again = self.blur.beyond is not None, self._made is not None and self._current()
        layering, known, _ = self._kept()

        def make(channel: int, plane: Values) -> Values:
            if whole:
                shares, groups = self._shares(channel), self._groups(channel)
                points, sources = layering.edges()
                spread = spread_groups(
                    self.blur, channel, (plane, _moved(plane, points, sources)), shares.seen, groups
                )
            else:
                bank = self.blur.banks[channel]
                spread = np.zeros(self.shape, dtype=self.dtype)
                shares = self._composite(channel, plane, spread, known.get(bank))
                if again:  # Many depth maps are met once.
                    known[bank] = shares
            spread += _TRACE * plane
            spread /= shares.total + _TRACE
            return spread

        return self.by_channel(image, make)

    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward` of an `image`: see :meth:`lommel.imaging.LinearBlur.adjoint`."""
        points, sources = self._kept()[0].edges()

        def make(channel: int, plane: Values) -> Values:
            shares, groups = self._shares(channel), self._groups(channel)
            even = plane / (shares.total + _TRACE)
            # The transpose of `spread_groups`: for the scene, and for the light behind it.
            taken = np.zeros((2, *self.shape), dtype=self.dtype)
            for group in groups:
                given = [each for _, each in group.sources]
                found = self.blur.collect(
                    channel, even, given, shares.seen if group.hidden else None, bank=group.bank
                )
                for (behind, _), more in zip(group.sources, found, strict=True):
                    taken[behind] += -more if group.taken_off else more
            scene: Values = taken[0]
            if self.blur.beyond is not None:
                scene += self.blur.beyond.act(self.blur, [channel], [even], transposed=True)[0]
            scene += _TRACE * even
            # One point may stand for several.
            np.add.at(scene.reshape(-1), sources, taken[1].reshape(-1)[points])
            return scene

        return self.by_channel(image, make)

    def _current(self) -> bool:
        """Return whether what is kept is of this defocus and of these banks."""
        made = self._made
        return made is not None and made[0] is self.blur.defocus and made[1] is self.blur.banks

    def _kept(self) -> tuple[Layering, dict[Bank, Shares], dict[Bank, list[Group]]]:
        """Return the layers, and what is known of each bank, kept for one depth map."""
        if not self._current():
            self._made = self.blur.defocus, self.blur.banks, _layering(self.blur, self._reach), {}, {}
        assert self._made is not None
        return self._made[2:]

    def _shares(self, channel: int) -> Shares:
        """Return what pixels see in a channel; kept."""
        blur, bank, known = self.blur, self.blur.banks[channel], self._kept()[1]
        if bank not in known and blur.beyond is None:
            known[bank] = self._composite(channel)
        elif bank not in known:
            # Windows that hold all of the aperture.
            within, _ = bank.apart()
            seen, total = self._composite(
                channel, bank=replace(within, energies=sums_of_quarters(within.windows[:-1]))
            )
            groups = self._groups(channel, seen)
            behind, cover = np.zeros(blur.shape, dtype=blur.dtype), copy.copy(blur)
            behind.reshape(-1)[self._kept()[0].edges()[0]] = 1.0
            # Darkness beyond the edges is no hole: it is as far away as the last points are.
            cover.border = "extend" if blur.border == "zero" else blur.border
            total = spread_groups(cover, channel, (np.ones_like(behind), behind), seen, groups)
            known[bank] = Shares(seen, total)
        return known[bank]

    def _groups(self, channel: int, seen: Values | None = None) -> list[Group]:
        """Return the groups of points of a channel; kept. Of the whole PSF they depend on what is `seen`."""
        blur, (layering, _, known) = self.blur, self._kept()
        bank = blur.banks[channel]
        if bank not in known:
            positions, (points, sources) = blur.positions(channel), layering.edges()
            layers = (layering.layers.astype(np.int8) + layering.level).astype(blur.dtype)
            given = [Points(positions, layers)]
            if points.size:
                behind = np.full(blur.shape, -1.0)
                behind.reshape(-1)[points] = positions.reshape(-1)[sources]
                given.append(Points(behind, _moved(layers, points, sources)))
            if seen is None:
                known[bank] = [Group(list(enumerate(given)))]
            else:
                known[bank] = _groups_of_whole(blur, channel, given, seen)
        return known[bank]

    def _composite(
        self,
        channel: int,
        plane: Values | None = None,
        out: Values | None = None,
        shares: Shares | None = None,
        bank: Bank | None = None,
    ) -> Shares:
        """Return what pixels see, which is found unless `shares` has it; add what they see of a `plane` to `out`."""
        blur, layering = self.blur, self._kept()[0]
        used, known = bank or blur.banks[channel], shares is not None
        margin = 0 if blur.border == "reflect" else used.half
        rows, columns = (np.pad(np.arange(side, dtype=np.int64), margin, mode="edge") for side in blur.shape)
        if shares is None:
            nothing = np.full(blur.shape, layering.number + layering.level, dtype=blur.dtype)
            shares = Shares(nothing, np.zeros_like(nothing))
        # One after another where somebody watches.
        each = [(0, layering.number)] if blur.watch is None else [(k, k + 1) for k in range(layering.number)]
        for first, last in each:
            engine.composite(
                *parts(used),
                blur.positions(channel),
                layering.layers,
                layering.behind,
                layering.number,
                rows,
                columns,
                blur.border == "reflect",
                blur.border == "zero",
                plane,
                first,
                last,
                known,
                blur.threads,
                *shares,
                out,
            )
            if blur.watch is not None:
                blur.watch(int(np.count_nonzero(layering.layers == first)))
        return shares


def _moved(plane: Values, points: NDArray[np.int64], sources: NDArray[np.int64]) -> Values:
    """Return a plane with the values at `sources` at each of the `points`; elsewhere zeros."""
    behind = np.zeros(plane.shape, dtype=plane.dtype)
    behind.reshape(-1)[points] = plane.take(sources)
    return behind


def _groups_of_whole(blur: DepthBlur, channel: int, sources: list[Points], seen: Values) -> list[Group]:
    """Return the groups of points for a blur that does not truncate the PSF.

    The remainder must show nothing hidden: a window holds the PSF less the remainder there, which is never occluded.
    A point that some pixel in its window does not see spreads its PSF, occluded, less the remainder within the
    window.
    """
    from scipy.ndimage import minimum_filter

    within, filled = blur.banks[channel].apart()
    scene, *behind = sources
    assert scene.layers is not None
    least = minimum_filter(seen, 2 * within.half + 1, mode="reflect" if blur.border == "reflect" else "nearest")
    free = least >= scene.layers + 1
    groups = [Group([(0, Points(np.where(free, scene.positions, -1.0)))], hidden=False)]
    if behind or not free.all():
        hidden = np.where(free, -1.0, scene.positions)
        groups.append(Group([(0, Points(hidden, scene.layers)), *((1, points) for points in behind)], within))
        groups.append(Group([(0, Points(hidden))], filled, hidden=False, taken_off=True))
    return groups


def reach_behind(blur: DepthBlur, reach: tuple[float, float]) -> int:
    """Return the largest distance in pixels of an occluded point from the edge that hides it."""
    return math.ceil(2.0 * float(np.ptp(_radii(blur, reach)[1])))


def _radii(blur: DepthBlur, reach: tuple[float, float]) -> tuple[Array, Array]:
    """Return defocus over a range, and the signed radii of its circle of confusion in pixels."""
    # Where a ray from the edge of the pupil meets the sensor, at v = 4 C_d if paraxial, else nearly in proportion to
    # C_d. Near points have the largest.
    defocus = np.linspace(*reach, 129)
    rim = ray_height(blur.lens.phase(defocus).edge, np.ones(1))[:, 0]
    return defocus, blur.lens.wavelength * blur.lens.working_f_number / (math.pi * blur.pixel) * rim


def _layering(blur: DepthBlur, reach: tuple[float, float] | None = None) -> Layering:
    """Return the layers of a scene over the defocus in `reach`, by default its own, and what they hide.

    A point hides something that the lens can see if a farther one is closer than their radii differ: rays through the
    rim of the aperture then pass the edge between them. The nearest such point marks the edge. (Diffraction reaches a
    little beyond the rim; the percent of light there is filled by dividing.)
    """
    defocus, radii = _radii(blur, reach or (float(blur.defocus.min()), float(blur.defocus.max())))
    thickness = max(0.5, float(np.ptp(radii)) / MOST_LAYERS)
    layers, behind = np.empty(blur.shape, dtype=np.uint8), np.empty(blur.shape, dtype=np.int32)
    low, high = float(defocus[0]), float(defocus[-1])
    count, hiding = engine.depth_layers(
        blur.defocus, low, high, radii, thickness, MOST_LAYERS, blur.threads, layers, behind
    )
    return Layering(layers, behind if hiding else None, count)
