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
from lommel.imaging.bank import Bank
from lommel.imaging.blur import DepthBlur, Points
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


class _Edges(NamedTuple):
    """Flat indices of points that hide something the lens sees, and of the points that stand for it."""

    points: NDArray[np.int64]
    sources: NDArray[np.int64]

    def behind(self, plane: Values) -> Values:
        """Return the values behind each point that hides something; elsewhere zeros."""
        behind = np.zeros(plane.shape, dtype=plane.dtype)
        behind.reshape(-1)[self.points] = plane.take(self.sources)
        return behind


# Of one channel, from the depth alone: the layers that each pixel sees, from the front (of the last one in part, of
# those behind it nothing); the image of a white scene; the groups of points.
_Shares = tuple[Values, Values, list[Group]]


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
    that fills it: one real number per pixel, the number of visible layers, holds them all, and light is blurred once,
    whatever the number of layers. The occlusion depends on the depth alone: it is computed at the first call, layer
    by layer, and again when `blur` is placed at other depths. After that a call takes 1.4 times as long as
    :meth:`lommel.imaging.DepthBlur.forward` where few points occlude others, 1.7 to 2.7 times where most do.

    With ``energy=1`` this applies to the windows; the light beyond them, one percent, is not occluded. Points that
    are partly hidden cost twice as much.

    Memory: 8 bytes per point, 16 per point and channel (16 and 24 in float64) and 16 for each point with a hidden one
    behind it; with ``energy=1`` 16 more per point and channel.

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

    # For the defocus and the banks that come first.
    _made: tuple[Array, tuple[Bank, ...], _Edges, tuple[_Shares, ...]] | None = None

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

        def make(channel: int, plane: Values) -> Values:
            edges, (seen, total, groups) = self._looked(channel)
            spread = spread_groups(self.blur, channel, (plane, edges.behind(plane)), seen, groups)
            spread += _TRACE * plane
            spread /= total + _TRACE
            return spread

        return self.by_channel(image, make)

    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward` of an `image`: see :meth:`lommel.imaging.LinearBlur.adjoint`."""

        def make(channel: int, plane: Values) -> Values:
            edges, (seen, total, groups) = self._looked(channel)
            even = plane / (total + _TRACE)
            # The transpose of `spread_groups`: for the scene, and for the light behind it.
            taken = np.zeros((2, *self.shape), dtype=self.dtype)
            for group in groups:
                points, shown = [each for _, each in group.sources], seen if group.hidden else None
                given = self.blur.collect(channel, even, points, shown, bank=group.bank)
                for (behind, _), more in zip(group.sources, given, strict=True):
                    taken[behind] += -more if group.taken_off else more
            scene: Values = taken[0]
            if self.blur.beyond is not None:
                scene += self.blur.beyond.act(self.blur, [channel], [even], transposed=True)[0]
            scene += _TRACE * even
            # One point may stand for several.
            np.add.at(scene, np.unravel_index(edges.sources, scene.shape), taken[1].reshape(-1)[edges.points])
            return scene

        return self.by_channel(image, make)

    def _looked(self, channel: int) -> tuple[_Edges, _Shares]:
        """Return the edges and the shares of a channel, kept for one depth map."""
        blur, made = self.blur, self._made
        if made is None or made[0] is not blur.defocus or made[1] is not blur.banks:
            layer, radius = _layers(blur, self._reach)
            behind = _behind(layer, radius).reshape(-1)
            points = np.flatnonzero(behind >= 0)
            edges = _Edges(points, behind[points])
            # Of the layers that there are, from their middle: what is seen of them is then rounded less.
            levels, number = np.unique(layer, return_inverse=True)
            centred = (number.reshape(layer.shape) - levels.size // 2).astype(blur.dtype)
            channels = {bank: index for index, bank in enumerate(blur.banks)}
            shares = {bank: _shares(blur, index, centred, edges) for bank, index in channels.items()}
            self._made = made = blur.defocus, blur.banks, edges, tuple(shares[bank] for bank in blur.banks)
        return made[2], made[3][channel]


def _shares(blur: DepthBlur, channel: int, layer: Values, edges: _Edges) -> _Shares:
    """Return the layers that each pixel sees until its aperture is full, and the light of a white scene."""
    positions = blur.positions(channel)
    sources = [Points(positions, layer)]
    if edges.points.size:
        behind = np.full(blur.shape, -1.0)
        behind.reshape(-1)[edges.points] = positions.reshape(-1)[edges.sources]
        sources.append(Points(behind, edges.behind(layer)))
    covering, cover = None, copy.copy(blur)
    if blur.beyond is not None:
        # Windows that hold all of the aperture.
        within, _ = blur.banks[channel].apart()
        covering = replace(within, energies=sums_of_quarters(within.windows[:-1]))
    # Darkness beyond the edges is no hole: it is as far away as the last points are.
    cover.border = "extend" if blur.border == "zero" else blur.border
    white, beyond = np.ones(blur.shape, dtype=blur.dtype), layer.max() + 1
    total, seen = np.zeros_like(white), np.full_like(white, beyond)
    rounding = 16.0 * float(np.finfo(blur.dtype).eps)
    for level in np.unique(layer):
        # What is hidden is in a farther layer than what hides it, so no pixel has two points in one.
        here = np.full(blur.shape, -1.0)
        for points in sources:
            np.copyto(here, points.positions, where=(points.layers == level) & (points.positions >= 0.0))
        covered = cover.spread(channel, [(white, Points(here))], bank=covering)
        left, wanted = 1.0 - total, seen == beyond
        full = wanted & (covered > left - rounding)
        part = np.divide(left, covered, out=np.ones_like(white), where=full & (covered > left + rounding))
        np.copyto(seen, level + part, where=full)
        np.copyto(total, total + part * covered, where=wanted)
        if np.all(seen < beyond):
            break
    groups = [Group(list(enumerate(sources)))]
    if blur.beyond is not None:
        groups = _groups_of_whole(blur, channel, sources, seen)
        whites = [(points.positions >= 0.0).astype(blur.dtype) for points in sources]
        total = spread_groups(cover, channel, whites, seen, groups)
    return seen, total, groups


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


def _layers(blur: DepthBlur, reach: tuple[float, float] | None = None) -> tuple[NDArray[np.int64], Array]:
    """Return the layer of each point, 0 the nearest, over the defocus in `reach`, and its circle of confusion."""
    defocus, radii = _radii(blur, reach or (float(blur.defocus.min()), float(blur.defocus.max())))
    radius = np.interp(blur.defocus, defocus, radii)
    depth = radii.max() - radius
    thickness = max(0.5, float(np.ptp(radii)) / MOST_LAYERS)
    return np.minimum((depth / thickness).astype(np.int64), MOST_LAYERS - 1), radius


def _behind(layer: NDArray[np.int64], radius: Array) -> NDArray[np.int64]:
    """Return for each point the flat index of the one that stands for the light it hides, or -1.

    A point hides something that the lens can see if a farther one is closer than their radii differ: rays through the
    rim of the aperture then pass the edge between them. The nearest such point marks the edge. (Diffraction reaches a
    little beyond the rim; the percent of light there is filled by dividing.)
    """
    behind = np.full(layer.shape, -1, dtype=np.int64)
    # Radii that differ by more than the distance of points anywhere do so, but for 8 %, between neighbours: paths
    # over neighbours are at most so much longer than straight.
    limit, root = math.cos(math.pi / 8.0), math.sqrt(2.0)
    steps = [(radius[1:], radius[:-1], 1.0), (radius[:, 1:], radius[:, :-1], 1.0)]
    steps += [(radius[1:, 1:], radius[:-1, :-1], root), (radius[1:, :-1], radius[:-1, 1:], root)]
    if not any(bool(np.any(np.abs(a - b) > limit * step)) for a, b, step in steps):
        return behind
    from scipy.ndimage import distance_transform_edt

    (height, width), (y, x) = layer.shape, np.indices(layer.shape)
    for index in np.unique(layer)[1:]:
        far = layer >= index
        row, column = distance_transform_edt(~far, return_distances=False, return_indices=True)
        near = np.hypot(row - y, column - x) < radius - radius[row, column]
        found = near & ~far & (behind < 0)
        y2, x2 = 2 * row - y, 2 * column - x
        inside = (y2 >= 0) & (y2 < height) & (x2 >= 0) & (x2 < width)
        mirrored = np.where(inside, y2 * width + x2, 0)
        mirrored = np.where(inside & far.ravel()[mirrored], mirrored, row * width + column)
        behind = np.where(found, mirrored, behind)
    return behind
