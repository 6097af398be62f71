"""Occlusion: the scene is divided into layers of similar defocus, which are composited from front to back."""

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
    """Points that spread light by the windows of one bank."""

    sources: list[tuple[int, Points]]  # 0: visible points of the scene; 1: hidden points, behind its edges
    bank: Bank | None = None  # None: the bank of the channel
    occluded: bool = True  # nearer layers occlude the light of the points
    negative: bool = False  # the image of the group is subtracted


def spread_groups(
    blur: DepthBlur, channel: int, planes: Sequence[Values], seen: Values, groups: list[Group]
) -> Values:
    """Return the blurred image of `groups` in one channel; `planes` are the light of visible and of hidden points."""
    total = np.zeros(blur.shape, dtype=blur.dtype)
    for group in groups:
        sources = [(planes[kind], points) for kind, points in group.sources]
        image = blur.spread(channel, sources, seen if group.occluded else None, bank=group.bank)
        total += -image if group.negative else image
    # Light outside the windows is not occluded: certificate, section 13, last paragraph.
    if blur.beyond is not None:
        total += blur.beyond.act(blur, [channel], [planes[0]])[0]
    return total


MAX_LAYERS = 64  # largest number of layers; for a larger range of blur, layers are thicker

# Fraction of the sharp image that is added to the blurred image: it keeps divisors above 0.
_SHARP_FRACTION = 1e-9


class Layering(NamedTuple):
    """Layers of points by depth, and the light that they occlude."""

    layers: NDArray[np.uint8]  # layer of each point, 0 the nearest
    behind: NDArray[np.int32] | None  # for each point, flat index of the point whose light is behind it; -1: none
    number: int  # number of layers

    @property
    def level(self) -> int:
        """Index of the first layer, counted from the middle layer: small indices have small rounding errors."""
        return -(self.number // 2)

    def edges(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Return the flat indices of the points with hidden light behind them, and of the sources of this light."""
        if self.behind is None:
            return (np.empty(0, dtype=np.int64),) * 2
        points = np.flatnonzero(self.behind >= 0)
        return points, self.behind.reshape(-1)[points].astype(np.int64)


class Shares(NamedTuple):
    """Visibility of the layers in one channel; it depends on the depth alone."""

    seen: Values  # number of layers that each pixel sees, from the front; a fraction if the last is partly visible
    total: Values  # image of a white scene


class Occlusion(LinearBlur):
    r"""Blur by depth with occlusion of far points by near points: a linear operator, with its transpose.

    Points are sorted into layers. Within a layer the diameter of the circle of confusion varies by one pixel, or by
    1/64 of its range over the scene if that is more. Each point is blurred by its own PSF: B is the blurred light of
    a layer, and A, the coverage, is B for a white scene. From the nearest layer to the farthest, light is added while
    nearer layers leave part of the aperture open: ``out = sum w B / A``, where the weight of a layer is
    ``w = min(A, 1 - sum of the weights of nearer layers)``.

    Coverages are added, up to the full aperture. For independent screens they would be multiplied (``T *= 1 - A``),
    but the points of one slanted surface lie in many layers and cover disjoint parts of the aperture. The product
    would make this surface transparent and increase the weight of its near points. With the sum, the result equals
    :meth:`lommel.imaging.DepthBlur.forward` wherever nothing is occluded, except for a normalisation that keeps a
    white scene white where the blur varies. Two separate screens cover slightly too much of a third surface.

    Near the edge of a foreground surface, the lens sees background points that the sharp image does not show: points
    closer to the edge than the difference between the radii of the two circles of confusion. Behind these foreground
    pixels, hidden points are added, with the light and defocus of the background mirrored at the edge. Division by
    the coverage alone would leave a sharp line in the blurred edge of a near object; repeating the last background
    point would turn highlights into streaks. Gaps that remain, behind two foreground surfaces or at steep slopes of
    depth, are filled by division by the sum of w.

    The ratio w / A is 1 for layers in front of the layer that fills the aperture, a fraction for this layer, and 0
    for layers behind it. One real number per pixel, the number of visible layers, therefore describes the occlusion,
    which depends on the depth alone. The first call for a depth map computes it together with the image, and takes
    1.3 to 2.7 times as long as :meth:`lommel.imaging.DepthBlur.forward`. The second call, or :meth:`adjoint`, stores
    it; later calls take 1.1 to 1.5 times as long. All calls return the same image to the last bit.

    With ``energy=1`` light inside the windows is occluded; light outside them, about one percent, is not. Partly
    occluded points then take twice as long.

    Memory: 5 bytes per point, and 8 bytes per point and channel (16 in float64) during a call, which are kept after
    the second call; :meth:`adjoint` and ``energy=1`` need up to 32 bytes more.

    Parameters
    ----------
    blur : DepthBlur
    reach : (float, float), optional
        Smallest and largest defocus C_d (radians) of the whole scene, if `blur` holds only part of it. The range
        determines the layers.

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

    # Cache for one defocus map and its banks: the layers, and for each bank the visibility and the groups of points.
    _cache: tuple[Array, tuple[Bank, ...], Layering, dict[Bank, Shares], dict[Bank, list[Group]]] | None = None

    def __init__(self, blur: DepthBlur, reach: tuple[float, float] | None = None) -> None:
        if not isinstance(blur, DepthBlur):
            raise TypeError(f"blur must be a DepthBlur, got {type(blur).__name__}")
        self.blur, self._reach = blur, reach
        self.channels, self.dtype = blur.channels, blur.dtype

    @property
    def shape(self) -> tuple[int, int]:  # type: ignore[override]  # changes with ``blur.place``
        """Height and width of the images."""
        return self.blur.shape

    def forward(self, image: Values) -> Values:
        """Return the blurred `image`: see :meth:`lommel.imaging.LinearBlur.forward`."""
        whole_psf, second_call = self.blur.beyond is not None, self._cache is not None and self._current()
        layering, shares_of, _ = self._cached_data()

        def render(channel: int, plane: Values) -> Values:
            if whole_psf:
                shares, groups = self._shares(channel), self._groups(channel)
                points, sources = layering.edges()
                blurred = spread_groups(
                    self.blur, channel, (plane, _copy_values(plane, points, sources)), shares.seen, groups
                )
            else:
                bank = self.blur.banks[channel]
                blurred = np.zeros(self.shape, dtype=self.dtype)
                shares = self._composite(channel, plane, blurred, shares_of.get(bank))
                if second_call:  # most depth maps are used once: `shares` are cached only from the second call on
                    shares_of[bank] = shares
            blurred += _SHARP_FRACTION * plane
            # Division by the image of a white scene: partly occluded neighbourhoods keep their brightness.
            blurred /= shares.total + _SHARP_FRACTION
            return blurred

        return self.by_channel(image, render)

    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward` of `image`: see :meth:`lommel.imaging.LinearBlur.adjoint`."""
        points, sources = self._cached_data()[0].edges()

        def transpose(channel: int, plane: Values) -> Values:
            shares, groups = self._shares(channel), self._groups(channel)
            normalised = plane / (shares.total + _SHARP_FRACTION)
            # The transpose of `spread_groups`: sums for the visible points and for the hidden points.
            sums = np.zeros((2, *self.shape), dtype=self.dtype)
            for group in groups:
                layers = shares.seen if group.occluded else None
                transposes = self.blur.collect(
                    channel, normalised, [part for _, part in group.sources], layers, bank=group.bank
                )
                for (kind, _), part_sum in zip(group.sources, transposes, strict=True):
                    sums[kind] += -part_sum if group.negative else part_sum
            scene: Values = sums[0]
            if self.blur.beyond is not None:
                scene += self.blur.beyond.act(self.blur, [channel], [normalised], transposed=True)[0]
            scene += _SHARP_FRACTION * normalised
            # One point may be the source of several hidden points: add.at sums repeated indices.
            np.add.at(scene.reshape(-1), sources, sums[1].reshape(-1)[points])
            return scene

        return self.by_channel(image, transpose)

    def _current(self) -> bool:
        """Return True if the cached data belong to the current defocus map and banks."""
        cache = self._cache
        return cache is not None and cache[0] is self.blur.defocus and cache[1] is self.blur.banks

    def _cached_data(self) -> tuple[Layering, dict[Bank, Shares], dict[Bank, list[Group]]]:
        """Return the layers, the visibility by bank, and the groups by bank; cached for one depth map."""
        if not self._current():
            self._cache = self.blur.defocus, self.blur.banks, _layering(self.blur, self._reach), {}, {}
        assert self._cache is not None
        return self._cache[2:]

    def _shares(self, channel: int) -> Shares:
        """Return the visibility of layers in a channel; cached."""
        blur, bank, shares_of = self.blur, self.blur.banks[channel], self._cached_data()[1]
        if bank not in shares_of and blur.beyond is None:
            shares_of[bank] = self._composite(channel)
        elif bank not in shares_of:
            # Coverage follows from windows of the whole PSF, not of the PSF minus the remainder.
            whole_psf, _ = bank.split()
            seen, total = self._composite(
                channel, bank=replace(whole_psf, energies=sums_of_quarters(whole_psf.windows[:-1]))
            )
            groups = self._groups(channel, seen)
            hidden_light, covered = np.zeros(blur.shape, dtype=blur.dtype), copy.copy(blur)
            hidden_light.reshape(-1)[self._cached_data()[0].edges()[0]] = 1.0
            # A dark border counts as covered: it has the depth of the outermost points of the image.
            covered.border = "extend" if blur.border == "zero" else blur.border
            total = spread_groups(covered, channel, (np.ones_like(hidden_light), hidden_light), seen, groups)
            shares_of[bank] = Shares(seen, total)
        return shares_of[bank]

    def _groups(self, channel: int, seen: Values | None = None) -> list[Group]:
        """Return the groups of points of a channel; cached.

        With ``energy=1`` the first call requires `seen`, the number of layers that each pixel sees.
        """
        blur, (layering, _, groups_of) = self.blur, self._cached_data()
        bank = blur.banks[channel]
        if bank not in groups_of:
            positions, (points, sources) = blur.positions(channel), layering.edges()
            layers = (layering.layers.astype(np.int8) + layering.level).astype(blur.dtype)
            kinds = [Points(positions, layers)]
            if points.size:
                behind = np.full(blur.shape, -1.0)
                behind.reshape(-1)[points] = positions.reshape(-1)[sources]
                kinds.append(Points(behind, _copy_values(layers, points, sources)))
            if seen is None:
                groups_of[bank] = [Group(list(enumerate(kinds)))]
            else:
                groups_of[bank] = _split_by_visibility(blur, channel, kinds, seen)
        return groups_of[bank]

    def _composite(
        self,
        channel: int,
        plane: Values | None = None,
        out: Values | None = None,
        shares: Shares | None = None,
        bank: Bank | None = None,
    ) -> Shares:
        """Add the blurred visible light of `plane` to `out`; return `shares`, which are computed if None."""
        blur, layering = self.blur, self._cached_data()[0]
        bank_used, has_shares = bank or blur.banks[channel], shares is not None
        margin = 0 if blur.border == "reflect" else bank_used.half
        rows, columns = (np.pad(np.arange(side, dtype=np.int64), margin, mode="edge") for side in blur.shape)
        if shares is None:
            all_visible = np.full(blur.shape, layering.number + layering.level, dtype=blur.dtype)
            shares = Shares(all_visible, np.zeros_like(all_visible))
        # All layers in one call, or one layer per call if `watch` is set.
        ranges = [(0, layering.number)] if blur.watch is None else [(k, k + 1) for k in range(layering.number)]
        for first, last in ranges:
            engine.composite(
                parts(bank_used),
                (blur.positions(channel), rows, columns),
                (layering.layers, layering.behind, layering.number),
                blur.border,
                plane,
                (first, last),
                has_shares,
                blur.threads,
                *shares,
                out,
            )
            if blur.watch is not None:
                blur.watch(int(np.count_nonzero(layering.layers == first)))
        return shares


def _copy_values(plane: Values, points: NDArray[np.int64], sources: NDArray[np.int64]) -> Values:
    """Return zeros, except for ``plane[sources]`` at the flat indices `points`."""
    behind = np.zeros(plane.shape, dtype=plane.dtype)
    behind.reshape(-1)[points] = plane.take(sources)
    return behind


def _split_by_visibility(blur: DepthBlur, channel: int, sources: list[Points], seen: Values) -> list[Group]:
    """Return the groups of points for ``energy=1``.

    Windows hold the PSF minus the remainder, and the remainder is never occluded. A point that is hidden from a pixel
    of its window therefore spreads the whole PSF with occlusion, minus the remainder in the window without occlusion.
    """
    from scipy.ndimage import minimum_filter

    whole, remainder = blur.banks[channel].split()
    scene, *hidden = sources
    assert scene.layers is not None
    # A point in a layer before the minimum of `seen` over its window is visible in the whole window.
    min_seen = minimum_filter(seen, 2 * whole.half + 1, mode="reflect" if blur.border == "reflect" else "nearest")
    visible = min_seen >= scene.layers + 1
    groups = [Group([(0, Points(np.where(visible, scene.positions, -1.0)))], occluded=False)]
    if hidden or not visible.all():
        positions = np.where(visible, -1.0, scene.positions)
        groups.append(Group([(0, Points(positions, scene.layers)), *((1, points) for points in hidden)], whole))
        groups.append(Group([(0, Points(positions))], remainder, occluded=False, negative=True))
    return groups


def reach_behind(blur: DepthBlur, reach: tuple[float, float]) -> int:
    """Return the largest distance in pixels between a hidden point and the edge of the surface that hides it."""
    return math.ceil(2.0 * float(np.ptp(_radii(blur, reach)[1])))


def _radii(blur: DepthBlur, reach: tuple[float, float]) -> tuple[Array, Array]:
    """Return values of C_d over a range, and the signed radii of the circles of confusion in pixels."""
    # The marginal ray meets the sensor at v = 4 C_d for a paraxial lens, and nearly in proportion to C_d for other
    # lenses. The nearest points have the largest signed radius.
    defocus = np.linspace(*reach, 129)
    rim = ray_height(blur.lens.phase(defocus).edge, np.ones(1))[:, 0]
    return defocus, blur.lens.wavelength * blur.lens.working_f_number / (math.pi * blur.pixel) * rim


def _layering(blur: DepthBlur, reach: tuple[float, float] | None = None) -> Layering:
    """Return the layers of a scene and its hidden points; `reach` is the range of C_d, by default that of `blur`."""
    # There is hidden light behind a point if the image distance to a farther point is below the difference between
    # the radii of their circles of confusion: marginal rays then pass the edge. The nearest farther point marks the
    # edge. Diffraction spreads about 1 % of the light outside the geometric radius; division by `total` restores it.
    defocus, radii = _radii(blur, reach or (float(blur.defocus.min()), float(blur.defocus.max())))
    thickness = max(0.5, float(np.ptp(radii)) / MAX_LAYERS)
    layers, behind = np.empty(blur.shape, dtype=np.uint8), np.empty(blur.shape, dtype=np.int32)
    low, high = float(defocus[0]), float(defocus[-1])
    count, has_hidden = engine.depth_layers(
        blur.defocus, low, high, radii, thickness, MAX_LAYERS, blur.threads, layers, behind
    )
    return Layering(layers, behind if has_hidden else None, count)
