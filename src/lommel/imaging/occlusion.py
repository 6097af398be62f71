"""Occlusion: the scene is divided into layers of similar defocus, which are composited from front to back."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.core import engine
from lommel.deconvolve.linear import LinearBlur
from lommel.imaging.bank import Bank
from lommel.imaging.blur import DepthBlur, Points, parts
from lommel.optics.pupil import ray_height

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

    def forward(self, image: Values) -> Values:
        """Return the blurred `image`: see :meth:`lommel.imaging.LinearBlur.forward`."""
        second_call = self._cache is not None and self._current()
        _, shares_of, _ = self._cached_data()

        def render(channel: int, plane: Values) -> Values:
            bank, blurred = self.blur.banks[channel], np.zeros(self.shape, dtype=self.dtype)
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
        cache = self._cache
        return cache is not None and cache[0] is self.blur.defocus and cache[1] is self.blur.banks

    def _cached_data(self) -> tuple[Layering, dict[Bank, Shares], dict[Bank, list[Points]]]:
        """Return the layers, the visibility by bank, and the points by bank; cached for one depth map."""
        if not self._current():
            self._cache = self.blur.defocus, self.blur.banks, _layering(self.blur, self.reach), {}, {}
        assert self._cache is not None
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
