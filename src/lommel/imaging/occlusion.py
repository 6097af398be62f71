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
from lommel.deconvolve.linear import LinearBlur
from lommel.imaging.bank import Bank
from lommel.imaging.blur import DepthBlur, Points, parts
from lommel.imaging.sensor_light import sums_of_quarters
from lommel.optics.pupil import ray_height


class Group(NamedTuple):
    """Points that spread windows of one bank."""

    sources: list[tuple[int, Points]]  # 0: light of the scene, 1: light behind it
    bank: Bank | None = None  # if different from that of the channel
    hidden: bool = True  # whether occlusion applies
    taken_off: bool = False  # whether the result is subtracted


def spread_groups(
    blur: DepthBlur, channel: int, planes: Sequence[Values], seen: Values, groups: list[Group]
) -> Values:
    """Return the image, in one channel, of the light of a scene and of the light behind it."""
    total = np.zeros(blur.shape, dtype=blur.dtype)
    for group in groups:
        given = [(planes[behind], points) for behind, points in group.sources]
        made = blur.spread(channel, given, seen if group.hidden else None, bank=group.bank)
        total += -made if group.taken_off else made
    # Light beyond windows is not occluded: it is far from any edge (certificate, section 13, last paragraph).
    if blur.beyond is not None:
        total += blur.beyond.act(blur, [channel], [planes[0]])[0]
    return total


MOST_LAYERS = 64  # layers become thicker than a pixel of blur if there would be more of them

# Share of its sharp light that each point keeps, so that no divisor is 0.
_TRACE = 1e-9


class Layering(NamedTuple):
    """Layers of points by depth, and the light that they occlude."""

    layers: NDArray[np.uint8]  # layer of each point, 0 the nearest
    behind: NDArray[np.int32] | None  # flat index of the representative of the points that each occludes, -1: none
    number: int  # number of layers

    @property
    def level(self) -> int:
        """Number of the first layer, counted from the middle one; smaller numbers are rounded less."""
        return -(self.number // 2)

    def edges(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Return flat indices of occluding points, and of the representatives of what they occlude."""
        if self.behind is None:
            return (np.empty(0, dtype=np.int64),) * 2
        points = np.flatnonzero(self.behind >= 0)
        return points, self.behind.reshape(-1)[points].astype(np.int64)


class Shares(NamedTuple):
    """What the pixels of one channel see, determined by the depth alone."""

    seen: (
        Values  # the layers that each pixel sees, from the front: of the last one in part, of those behind it nothing
    )
    total: Values  # image of a white scene


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

    # For the current defocus and banks: layers, and for each bank what pixels see and the groups of points.
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
                if again:  # most depth maps are used once: their shares are kept from the second time on
                    known[bank] = shares
            spread += _TRACE * plane
            # Division by the image of a white scene: partly occluded neighbourhoods keep their brightness.
            spread /= shares.total + _TRACE
            return spread

        return self.by_channel(image, make)

    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward` of an `image`: see :meth:`lommel.imaging.LinearBlur.adjoint`."""
        points, sources = self._kept()[0].edges()

        def make(channel: int, plane: Values) -> Values:
            shares, groups = self._shares(channel), self._groups(channel)
            even = plane / (shares.total + _TRACE)
            # The transpose of `spread_groups`, for the scene and for the light behind it.
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
            # One point may represent several occluded ones: add.at sums repeated indices.
            np.add.at(scene.reshape(-1), sources, taken[1].reshape(-1)[points])
            return scene

        return self.by_channel(image, make)

    def _current(self) -> bool:
        """Return whether the kept data belong to the current defocus and banks."""
        made = self._made
        return made is not None and made[0] is self.blur.defocus and made[1] is self.blur.banks

    def _kept(self) -> tuple[Layering, dict[Bank, Shares], dict[Bank, list[Group]]]:
        """Return the layers and the data of each bank, kept for one depth map."""
        if not self._current():
            self._made = self.blur.defocus, self.blur.banks, _layering(self.blur, self._reach), {}, {}
        assert self._made is not None
        return self._made[2:]

    def _shares(self, channel: int) -> Shares:
        """Return what the pixels of a channel see; kept."""
        blur, bank, known = self.blur, self.blur.banks[channel], self._kept()[1]
        if bank not in known and blur.beyond is None:
            known[bank] = self._composite(channel)
        elif bank not in known:
            # Windows that hold the whole PSF: occlusion acts on light, not on light less a remainder.
            within, _ = bank.apart()
            seen, total = self._composite(
                channel, bank=replace(within, energies=sums_of_quarters(within.windows[:-1]))
            )
            groups = self._groups(channel, seen)
            behind, cover = np.zeros(blur.shape, dtype=blur.dtype), copy.copy(blur)
            behind.reshape(-1)[self._kept()[0].edges()[0]] = 1.0
            # Darkness beyond the edges must not appear as a hole: it is taken to be as far as the outermost points.
            cover.border = "extend" if blur.border == "zero" else blur.border
            total = spread_groups(cover, channel, (np.ones_like(behind), behind), seen, groups)
            known[bank] = Shares(seen, total)
        return known[bank]

    def _groups(self, channel: int, seen: Values | None = None) -> list[Group]:
        """Return the groups of points of a channel; kept. Without truncation they depend on what is `seen`."""
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
        """Return what pixels see (computed unless in `shares`), and add what they see of a `plane` to `out`."""
        blur, layering = self.blur, self._kept()[0]
        used, known = bank or blur.banks[channel], shares is not None
        margin = 0 if blur.border == "reflect" else used.half
        rows, columns = (np.pad(np.arange(side, dtype=np.int64), margin, mode="edge") for side in blur.shape)
        if shares is None:
            nothing = np.full(blur.shape, layering.number + layering.level, dtype=blur.dtype)
            shares = Shares(nothing, np.zeros_like(nothing))
        # Layer by layer if progress is watched.
        each = [(0, layering.number)] if blur.watch is None else [(k, k + 1) for k in range(layering.number)]
        for first, last in each:
            engine.composite(
                parts(used),
                (blur.positions(channel), rows, columns),
                (layering.layers, layering.behind, layering.number),
                blur.border,
                plane,
                (first, last),
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

    Windows hold the PSF less the remainder, which is never occluded. So a point that some pixel of its window
    does not see spreads its whole PSF with occlusion, less the remainder within the window without.
    """
    from scipy.ndimage import minimum_filter

    within, filled = blur.banks[channel].apart()
    scene, *behind = sources
    assert scene.layers is not None
    # The least layer seen within a window: a point in front of it is seen by every pixel that it reaches.
    least = minimum_filter(seen, 2 * within.half + 1, mode="reflect" if blur.border == "reflect" else "nearest")
    free = least >= scene.layers + 1
    groups = [Group([(0, Points(np.where(free, scene.positions, -1.0)))], hidden=False)]
    if behind or not free.all():
        hidden = np.where(free, -1.0, scene.positions)
        groups.append(Group([(0, Points(hidden, scene.layers)), *((1, points) for points in behind)], within))
        groups.append(Group([(0, Points(hidden))], filled, hidden=False, taken_off=True))
    return groups


def reach_behind(blur: DepthBlur, reach: tuple[float, float]) -> int:
    """Return the largest distance in pixels of an occluded point from the occluding edge."""
    return math.ceil(2.0 * float(np.ptp(_radii(blur, reach)[1])))


def _radii(blur: DepthBlur, reach: tuple[float, float]) -> tuple[Array, Array]:
    """Return values of defocus over a range, and the signed radii of the circle of confusion in pixels."""
    # The marginal ray meets the sensor at v = 4 C_d for a paraxial lens, nearly in proportion for others. Near points
    # have the largest (signed) radii.
    defocus = np.linspace(*reach, 129)
    rim = ray_height(blur.lens.phase(defocus).edge, np.ones(1))[:, 0]
    return defocus, blur.lens.wavelength * blur.lens.working_f_number / (math.pi * blur.pixel) * rim


def _layering(blur: DepthBlur, reach: tuple[float, float] | None = None) -> Layering:
    """Return the layers of a scene, over the defocus in `reach` or its own, and the points that they occlude."""
    # A point occludes another that the lens can see if a farther point is closer than the difference of their radii:
    # marginal rays then pass the edge between them. The nearest such point marks the edge. Diffraction reaches a
    # little beyond the geometric rim; that per cent of light is restored by the division.
    defocus, radii = _radii(blur, reach or (float(blur.defocus.min()), float(blur.defocus.max())))
    thickness = max(0.5, float(np.ptp(radii)) / MOST_LAYERS)
    layers, behind = np.empty(blur.shape, dtype=np.uint8), np.empty(blur.shape, dtype=np.int32)
    low, high = float(defocus[0]), float(defocus[-1])
    count, hiding = engine.depth_layers(
        blur.defocus, low, high, radii, thickness, MOST_LAYERS, blur.threads, layers, behind
    )
    return Layering(layers, behind if hiding else None, count)
