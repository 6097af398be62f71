"""Occlusion: the scene is divided into layers of similar defocus, which are composited from front to back."""

from __future__ import annotations

import math
from functools import reduce
from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.core import engine
from lommel.deconvolve.linear import LinearBlur, folded
from lommel.imaging.bank import Bank
from lommel.imaging.blur import DepthBlur, Points, parts
from lommel.optics.pupil import ray_height

MAX_LAYERS = 64  # largest number of layers; for a larger range of blur, layers are thicker

# Fraction of the sharp image that is added to the blurred image: it keeps divisors above 0.
_SHARP_FRACTION = 1e-9

_QUIET = 4.0  # least contrast of a point / range of light of the darkest 22 of the 25 pixels around it
_FAINT = (0.003, 0.03)  # least contrast of a point: of white or the brightest pixel, and of its surroundings


class Layering(NamedTuple):
    """Layers of points by depth, and the light that they occlude."""

    layers: NDArray[np.uint8]  # layer of each point, 0 the nearest
    behind: NDArray[np.int32] | None  # for each point, flat index of the point whose light is behind it; -1: none
    number: int  # number of layers
    range: int  # range of blur radii in pixels, rounded up

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

    Memory: 5 bytes per point, and 8 bytes per point and channel (16 in float64) during a call, which are kept after
    the second call; :meth:`adjoint` needs up to 32 bytes more.

    Parameters
    ----------
    blur : DepthBlur

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

    # Cache for one defocus map and its banks: the layers, and for each bank the visibility and the points.
    _cache: tuple[Array, tuple[Bank, ...], Layering, dict[Bank, Shares], dict[Bank, list[Points]]] | None = None

    # Smallest and largest defocus C_d of the whole scene, which determine the layers, if `blur` holds a part of it.
    reach: tuple[float, float] | None = None

    def __init__(self, blur: DepthBlur) -> None:
        if not isinstance(blur, DepthBlur):
            raise TypeError(f"blur must be a DepthBlur, got {type(blur).__name__}")
        self.blur = blur
        self.channels, self.dtype = blur.channels, blur.dtype

    @property
    def shape(self) -> tuple[int, int]:  # type: ignore[override]  # changes with ``blur.place``
        """Height and width of the images."""
        return self.blur.shape

    def forward(self, image: Values, *, copies: bool = True) -> Values:
        """Return the blurred `image`: see :meth:`lommel.imaging.LinearBlur.forward`.

        Without `copies`, hidden points do not copy points of light (isolated bright pixels), and the light of such
        points beside edges is the part that passes the nearer surfaces. The result is then not linear in the image.
        """
        second_call, (layering, shares_of, _) = self._current(), self._cached_data()

        def render(channel: int, plane: Values) -> Values:
            bank, blurred = self.blur.banks[channel], np.zeros(self.shape, dtype=self.dtype)
            far = max(bank.half, layering.range)
            points = np.zeros(1) if copies or layering.behind is None else self._points_beside_edges(plane, far)
            plane = plane - points if points.any() else plane
            shares = self._composite(channel, plane, blurred, shares_of.get(bank))
            if second_call:  # most depth maps are used once: `shares` are cached only from the second call on
                shares_of[bank] = shares
            blurred += _SHARP_FRACTION * plane
            # Division by the image of a white scene: partly occluded neighbourhoods keep their brightness.
            blurred /= shares.total + _SHARP_FRACTION
            if points.any():
                self._draw(points, bank, far, shares.seen, blurred)
            return blurred

        return self.by_channel(image, render)

    def _points_beside_edges(self, plane: Values, far: int) -> Values:
        """Return the points of light with hidden points up to `far` rows and columns away; 0 elsewhere."""
        layering, width = self._cached_data()[0], self.shape[1]
        assert layering.behind is not None
        # A quick test: a point exceeds a neighbour along both axes by a quarter, and by 3 % of white.
        flat, floor = plane.reshape(-1), 0.03 * min(1.0, float(plane.max()))
        near = np.flatnonzero(flat[1:-1] > 1.25 * np.minimum(flat[:-2], flat[2:])) + 1
        light, *others = (flat.take(near + step, mode="clip") for step in (0, width, -width))
        near = near[light > 1.25 * np.minimum(*others) + floor]
        starts = [(k, max(0, k // width - far), max(0, k % width - far)) for k in near.tolist()]
        side = 2 * far + 1
        near = np.array([k for k, y, x in starts if layering.behind[y : y + side, x : x + side].max() >= 0], np.intp)
        if not near.size:
            return np.zeros(1)
        # A point is compared with the background only, and with the light that stands for it behind the edge.
        filled, (hidden, sources) = plane.copy(), layering.edges()
        filled.put(hidden, plane.take(sources))
        near = near[filled.take(near) == plane.take(near)]
        return points_of_light(filled, plane.size, np.unravel_index(near, self.shape))

    def _draw(self, points: Values, bank: Bank, far: int, seen: Values, out: Values) -> None:
        """Add points of light to `out`, each with the light that passes nearer surfaces up to `far` pixels away."""
        layering, table = self._cached_data()[0], _radii(self.blur, self.reach)
        planes = self.blur.defocus, seen, np.zeros_like(seen)
        defocus, seen, drawn = (np.pad(plane, far, mode="symmetric") for plane in planes)
        # A point does not hide itself.
        distance = np.maximum(np.hypot(*np.ogrid[-far : far + 1, -far : far + 1]), 0.5)
        for y, x in np.argwhere(points):
            around = np.s_[y : y + 2 * far + 1, x : x + 2 * far + 1]
            nearer = np.interp(defocus[around], *table) - np.interp(defocus[y + far, x + far], *table)
            # A nearer point blocks the rays through the part of the aperture that it covers, seen from (y, x).
            covered = np.clip(nearer - distance + 0.5, 0.0, 1.0) / (math.pi * np.maximum(nearer, 0.5) ** 2)
            visible = np.clip(seen[around] - (float(layering.layers[y, x]) + layering.level), 0.0, 1.0)
            light = np.pad(bank.window(defocus[y + far, x + far]), far - bank.half) * visible
            drawn[around] += light * (points[y, x] * max(0.0, 1.0 - covered.sum()) / max(light.sum(), 1e-9))
        out += folded(drawn, (far, far), out.shape)

    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward` of `image`: see :meth:`lommel.imaging.LinearBlur.adjoint`."""
        layering, shares_of, _ = self._cached_data()
        points, sources = layering.edges()

        def transpose(channel: int, plane: Values) -> Values:
            bank = self.blur.banks[channel]
            if bank not in shares_of:
                shares_of[bank] = self._composite(channel)
            shares = shares_of[bank]
            normalised = plane / (shares.total + _SHARP_FRACTION)
            scene, *hidden = self.blur.collect(channel, normalised, self._points(channel), shares.seen)
            scene += _SHARP_FRACTION * normalised
            for behind in hidden:
                # One point may be the source of several hidden points: add.at sums repeated indices.
                np.add.at(scene.reshape(-1), sources, behind.reshape(-1)[points])
            return scene

        return self.by_channel(image, transpose)

    def _current(self) -> bool:
        """Return True if the cached data belong to the current defocus map and banks."""
        return self._cache is not None and self._cache[0] is self.blur.defocus and self._cache[1] is self.blur.banks

    def _cached_data(self) -> tuple[Layering, dict[Bank, Shares], dict[Bank, list[Points]]]:
        """Return the layers, the visibility by bank, and the points by bank; cached for one depth map."""
        if self._cache is None or not self._current():
            self._cache = self.blur.defocus, self.blur.banks, _layering(self.blur, self.reach), {}, {}
        return self._cache[2:]

    def _points(self, channel: int) -> list[Points]:
        """Return the visible points of a channel and, if there are any, the points hidden behind its edges."""
        blur, (layering, _, points_of) = self.blur, self._cached_data()
        bank = blur.banks[channel]
        if bank not in points_of:
            positions, (points, sources) = blur.positions(channel), layering.edges()
            layers = (layering.layers.astype(np.int8) + layering.level).astype(blur.dtype)
            points_of[bank] = [Points(positions, layers)]
            if points.size:
                behind, layers_behind = np.full(blur.shape, -1.0), np.zeros(blur.shape, dtype=blur.dtype)
                behind.reshape(-1)[points] = positions.take(sources)
                layers_behind.reshape(-1)[points] = layers.take(sources)
                points_of[bank].append(Points(behind, layers_behind))
        return points_of[bank]

    def _composite(
        self,
        channel: int,
        plane: Values | None = None,
        out: Values | None = None,
        shares: Shares | None = None,
    ) -> Shares:
        """Add the blurred visible light of `plane` to `out`; return `shares`, which are computed if None."""
        blur, layering = self.blur, self._cached_data()[0]
        has_shares = shares is not None
        if shares is None:
            all_visible = np.full(blur.shape, layering.number + layering.level, dtype=blur.dtype)
            shares = Shares(all_visible, np.zeros_like(all_visible))
        # All layers in one call, or one layer per call if `watch` is set.
        ranges = [(0, layering.number)] if blur.watch is None else [(k, k + 1) for k in range(layering.number)]
        for first, last in ranges:
            engine.composite(
                parts(blur.banks[channel]),
                blur.positions(channel),
                (layering.layers, layering.behind, layering.number),
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


def reach_behind(blur: DepthBlur, reach: tuple[float, float]) -> int:
    """Return the largest distance in pixels between a hidden point and the edge of the surface that hides it."""
    return math.ceil(2.0 * float(np.ptp(_radii(blur, reach)[1])))


def _radii(blur: DepthBlur, reach: tuple[float, float] | None) -> tuple[Array, Array]:
    """Return values of C_d over a range (None: of `blur`), and the signed radii of circles of confusion in pixels."""
    # The marginal ray meets the sensor at v = 4 C_d for a paraxial lens, and nearly in proportion to C_d for other
    # lenses. The nearest points have the largest signed radius.
    defocus = np.linspace(*(reach or (float(blur.defocus.min()), float(blur.defocus.max()))), 129)
    rim = ray_height(blur.lens.phase(defocus).edge, np.ones(1))[:, 0]
    return defocus, blur.lens.wavelength * blur.lens.working_f_number / (math.pi * blur.pixel) * rim


def _layering(blur: DepthBlur, reach: tuple[float, float] | None = None) -> Layering:
    """Return the layers of a scene and its hidden points; `reach` is the range of C_d, by default that of `blur`."""
    # There is hidden light behind a point if the image distance to a farther point is below the difference between
    # the radii of their circles of confusion: marginal rays then pass the edge. The nearest farther point marks the
    # edge. Diffraction spreads about 1 % of the light outside the geometric radius; division by `total` restores it.
    defocus, radii = _radii(blur, reach)
    thickness = max(0.5, float(np.ptp(radii)) / MAX_LAYERS)
    layers, behind = np.empty(blur.shape, dtype=np.uint8), np.empty(blur.shape, dtype=np.int32)
    low, high = float(defocus[0]), float(defocus[-1])
    count, has_hidden = engine.depth_layers(
        blur.defocus, low, high, radii, thickness, MAX_LAYERS, blur.threads, layers, behind
    )
    return Layering(layers, behind if has_hidden else None, count, math.ceil(float(np.ptp(radii))))


def points_of_light(plane: Values, most: int, among: tuple[NDArray[np.intp], ...] | None = None) -> Values:
    """Return the light by which isolated pixels, up to three in 5 x 5, exceed those around them; 0 elsewhere.

    If there are more than `most` points, they are the brightest. Only pixels `among` these rows and columns are
    examined; None for all.
    """
    floor, points = _FAINT[0] * min(1.0, float(plane.max())), np.zeros_like(plane)
    around = sliding_window_view(np.pad(plane, 2, mode="reflect"), (5, 5))
    indices = np.broadcast_arrays(*np.ogrid[: plane.shape[0], : plane.shape[1]])
    # Few rows at a time: their light stays in the cache.
    for part in [np.s_[first : first + 32] for first in range(0, len(plane), 32)] if among is None else [among]:
        ring = [around[..., 1 + k // 3, 1 + k % 3][part] for k in range(9)]  # 3 x 3 pixels, the middle one ring[4]
        # A quick test: two other points are on at most two of the four pairs of opposite neighbours.
        a, b, c, d = (np.maximum(ring[k], ring[8 - k]) for k in range(4))
        second = np.maximum(np.minimum(a, b), np.minimum(c, d))
        second = np.minimum(second, np.minimum(np.maximum(a, b), np.maximum(c, d)))
        darkest = reduce(np.minimum, ring[:4] + ring[5:])
        stands_out = ring[4] - second > _QUIET * (second - darkest)
        places = tuple(index[part][stands_out] for index in indices)
        ordered = np.sort(around[places].reshape(-1, 25), axis=1)
        light, quiet = plane[places] - ordered[:, -4], ordered[:, -4]
        bright = (light > _QUIET * (quiet - ordered[:, 0])) & (light > floor + _FAINT[1] * np.abs(quiet))
        points[places] = np.where(bright, light, 0.0)
    if most < plane.size and np.count_nonzero(points) > most:
        points[points <= np.partition(points, -most - 1, axis=None)[-most - 1]] = 0.0
    return points
