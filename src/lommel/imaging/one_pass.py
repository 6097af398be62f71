r"""Deblurring in one pass: the Wiener filter of each depth, for the texture and the noise of the photograph.

With the transfer function h of optics and pixel at a depth, the pixel's own P, white noise of nu times the stated
variance and a texture of power ``S(f) = c f^-s``, the pixel-averaged scene is estimated by ``P S h / (S h^2 + nu)``:
polynomials of one small filter (:mod:`lommel.imaging.focal_tables`), mixed by depth for each pixel.

Power, slope and noise are the most likely ones for the photograph's power in rings of frequency,
``c f^-s <h^2> + nu`` with the mean of h^2 over all depths (Whittle 1953, doi:10.1007/BF02590998). More
noise than stated can be told from texture only at frequencies that no depth transmits; without such nu is at most 1.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.deconvolve.algorithms import ONE_PASS, ProgressCallback, silent
from lommel.deconvolve.iterations import Solution
from lommel.deconvolve.linear import LinearBlur
from lommel.deconvolve.poisson_counts import PhotographCounts
from lommel.estimation.focal_model import LARGEST, Band, FocalLight, FocalModel, transfer_curve
from lommel.imaging.blur import DepthBlur
from lommel.imaging.focal_engine import processors
from lommel.imaging.focal_tables import SharpTables, Taps
from lommel.imaging.occlusion import Occlusion

_STEP = 0.75  # radians of defocus between tables
_MOST_TABLES = 961
_DEGREES, _ENOUGH = (12, 24, 48), 0.1  # degrees of the polynomials, and the loss in decibels that is small enough
_LEAST_ERROR = 0.01  # squared error over the variance of a pixel, below which losses do not matter
_BLOCK, _BLOCKS = 256, 8  # side in pixels of the blocks whose spectra are averaged, and their number along an axis
_RINGS, _LOWEST = 14, 3.0  # number of rings of frequency, the first at so many periods a block
_BAND = 48  # frequencies along half an axis
_SLOPES = (2.0, 1.0, 3.0, 0.0)  # slopes of the power spectrum, the usual one first
_MORE_LIKELY = 5.0  # gain in log-likelihood for which another slope is taken
_DARK, _MOST_NOISE = 1e-2, 8.0  # transmitted power below which noise may exceed the stated one, and by what factor
_EDGES = 4.0  # power of texture at depth edges over that elsewhere
_UNLIKE = 1.5  # difference of `places`, in tables, above which a filter mixes in light of another blur
_LOCAL = 3.0  # rms width in pixels of local averages of residuals
_AWAY = (2, 6, 16)  # distances in pixels over which a filter collects light of other depths
_LEAST_SIDE, _WHOLE = 160, 16  # least side in pixels of a filtered image, and the multiple that sides must be


class Texture(NamedTuple):
    """Power spectrum ``power f^-slope`` of the texture, and variance of the noise; both over the stated variance."""

    power: float  # at one cycle per pixel
    slope: float
    noise: float  # 1 if as stated

    def over_noise(self, f: Array) -> Array:
        """Return the power over that of the noise, at frequencies in cycles per pixel."""
        return np.asarray(self.power / self.noise * _falling(f, self.slope))


@dataclass(frozen=True)
class _Light(FocalLight):
    """Light whose noise has the variance 1 in each pixel; the power of the texture is in units of it."""

    texture: Texture

    def binned(self, pixels: int) -> Self:
        """Return itself: pixels are not binned."""
        return self

    def power(self, f: Array) -> Array:
        """Return the power of the texture over the variance."""
        return self.texture.over_noise(f)


@dataclass(frozen=True, kw_only=True)
class OnePass:
    """Wiener's filter of each depth, in one pass, for the texture and the noise that the photograph shows.

    The filters are those of :class:`lommel.imaging.LiveSharpen`: polynomials of one small filter, mixed by depth,
    which takes a small part of the time of the iterations. There is no occlusion. The result estimates the scene as
    averaged by the pixels, with its mean. The pupil must be circular or annular.

    Parameters
    ----------
    loss : float, default 1.0
        Largest loss of the polynomials against the exact Wiener filter of any distance, decibels. Wider blur than
        they reach is refused.
    textures : tuple, optional
        Power, slope and noise of each channel; by default measured.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.
    """

    loss: float = 1.0
    textures: tuple[Texture, ...] | None = None

    def __post_init__(self) -> None:
        validation.real("loss", self.loss, above=0.0, infinite=True)

    def solve(self, observed: PhotographCounts, tell: ProgressCallback) -> Solution:
        """Return the sharp light behind the counts `observed`; `tell` gets one step. ValueError for other blurs."""
        blur = lens_blur(observed.blur)
        if blur is None:
            raise ValueError(
                "method=OnePass() needs a lens with a circular or annular pupil and a depth map, got the blur "
                f"{type(observed.blur).__name__}; RichardsonLucy() takes any"
            )
        scene = _Scene(observed, blur)
        light = np.empty((*blur.shape, blur.channels), dtype=blur.dtype)
        textures = self.textures or tuple(scene.texture(c) for c in range(blur.channels))
        for c, texture in enumerate(textures):
            tables = self._tables(scene.model(c, texture))
            light[..., c] = _filtered(tables, scene.planes[c], scene.places, blur.threads)
        # Light is not negative; the linear filter does not know that.
        done = np.maximum(light, 0.0).reshape(observed.counts.shape)
        # Filters are made for one depth: near depth edges they mix in light of another blur.
        at_edges = _near_edges(scene.places)
        if at_edges.any():
            done = _mixed_at_edges(observed, done, at_edges, [texture.noise for texture in textures])
        tell(1, math.nan, 0.0)
        same = replace(self, textures=textures)
        return Solution(done, 1, ONE_PASS, lambda other: same.solve(other, silent).light)

    def _tables(self, model: FocalModel) -> SharpTables:
        """Return the filters of the lowest degree with nearly Wiener's error; ValueError if none has."""
        for degree in _DEGREES:
            tables = SharpTables(model, Taps.of(5), degree)
            exact, made = tables.errors(tables.pixel)
            losses = 10.0 * np.log10((made + _LEAST_ERROR) / (exact + _LEAST_ERROR))
            if losses.max() <= _ENOUGH:
                return tables
        if losses.max() > self.loss:
            worst = int(np.argmax(losses))
            with np.errstate(divide="ignore"):
                distance = 1.0 / model.vergence[worst]
            raise ValueError(
                f"method=OnePass() loses {losses[worst]:.2g} dB at {distance:.4g} m, more than loss={self.loss:g}, "
                "as the blur is wider than its polynomials reach; take RichardsonLucy()"
            )
        return tables


class _Scene:
    """A photograph through a lens: its channels, and the distances for which tables are made."""

    def __init__(self, observed: PhotographCounts, blur: DepthBlur) -> None:
        self._blur = blur
        self.vergence, self.places = _vergences(blur)
        shape = (*blur.shape, blur.channels)
        known = (observed.weight > 0.0).reshape(shape)
        added = np.broadcast_to(observed.added, observed.counts.shape).reshape(shape)
        # Not clipped at 0: negative noise is information, too.
        light = observed.counts.reshape(shape) - added
        self.planes = [_filled(light[..., c], known[..., c]) for c in range(blur.channels)]
        self._variances = [
            # Poisson variance: the mean count and the variance of reading, in units of light.
            float(np.mean(plane) + np.mean(added[..., c])) / observed.white
            for c, plane in enumerate(self.planes)
        ]
        self._neighbour_shares = _neighbour_shares(self.places, len(self.vergence))
        curves = {
            spectrum: transfer_curve(blur.lens, self.vergence, spectrum, blur.pixel) for spectrum in set(blur.spectra)
        }
        self._curves = [curves[spectrum] for spectrum in blur.spectra]

    def texture(self, channel: int) -> Texture:
        """Return the texture and the noise of a channel."""
        return _measured(self.planes[channel], self._passed(channel), self._variances[channel])

    def _passed(self, channel: int) -> _Passed:
        return _Passed.of(self._curves[channel], self.places, len(self.vergence))

    def model(self, channel: int, texture: Texture) -> FocalModel:
        """Return the model of a channel, in which light from other depths counts as noise."""
        blur, curve = self._blur, self._curves[channel]
        given = [blur.lens], self.vergence, blur.spectra[channel], blur.pixel, _Light(1.0, 0.0, (1.0,), 0.0, texture)
        model = FocalModel.of(*given, transfer=lambda *_: curve)
        stray = _stray_power(model.transfer[:, 0], model.texture, self._neighbour_shares)[:, None]
        return replace(model, noise=model.noise + stray)

    def target(self, channel: int) -> float:
        """Return the discrepancy that the filter leaves: the residual power of a channel over the stated noise."""
        texture, passed = self.texture(channel), self._passed(channel)
        seen = texture.power * passed.seen(texture.slope)
        return float((texture.noise**2 / (texture.noise + seen)) @ passed.band.share)


def wiener_target(observed: PhotographCounts) -> tuple[float, float] | None:
    """Return the discrepancy expected of a good result from texture and noise, and the noise over the stated one.

    None if the blur is too wide for the transfer functions.
    """
    blur = lens_blur(observed.blur)
    if blur is None:
        return None
    try:
        scene = _Scene(observed, blur)
    except ValueError:
        return None
    noise = [scene.texture(c).noise for c in range(blur.channels)]
    return observed.mean(np.array([scene.target(c) for c in range(blur.channels)])), observed.mean(np.array(noise))


def lens_blur(blur: LinearBlur) -> DepthBlur | None:
    """Return the blur by lens and depth of an operator, if it is one."""
    return blur if isinstance(blur, DepthBlur) else blur.blur if isinstance(blur, Occlusion) else None


def _vergences(blur: DepthBlur) -> tuple[Array, NDArray[np.float32]]:
    """Return 1 / distance of each table, and the position of each pixel between tables."""
    # C_d is linear in 1 / distance (paper, Eq. 3): two distances determine the line.
    at_half_metre, at_metre = (float(defocus) for defocus in blur.lens.defocus([0.5, 1.0]))
    slope = at_half_metre - at_metre  # C_d per unit of vergence
    low, high = float(blur.defocus.min()), float(blur.defocus.max())
    count = min(max(2, math.ceil((high - low) / _STEP) + 1), _MOST_TABLES)
    defocus = np.linspace(low, max(high, low + 1e-3), count)
    # Rounding must not lead beyond infinity, to a negative vergence.
    vergence = np.maximum(1.0 + (defocus - at_metre) / slope, 0.0)
    return vergence, np.asarray((blur.defocus - low) / (defocus[1] - low), dtype=np.float32)


def _neighbour_shares(places: NDArray[np.float32], count: int) -> Array:
    """Return the matrix [table of a pixel, table of a neighbour that filters reach], as shares of each row."""
    at = np.rint(places).astype(np.int64)
    pairs = np.zeros((count, count))
    for away in _AWAY:
        for one, other in ((at[away:], at[:-away]), (at[:, away:], at[:, :-away])):
            flat = np.bincount((one * count + other).ravel(), minlength=count**2)
            pairs += flat.reshape(count, count)
    pairs += pairs.T
    # Tables without pixels are taken to have neighbours as the whole photograph.
    pairs[pairs.sum(axis=1) == 0.0] = np.bincount(at.ravel(), minlength=count)
    return np.asarray(pairs / pairs.sum(axis=1, keepdims=True))


def _stray_power(transfer: Array, power: Array, shares: Array) -> Array:
    """Return the power of light from other depths in the filters, over that of the noise, (c, frequencies)."""
    # Mean of (h_other - h)^2 over the neighbours, expanded.
    difference = shares @ transfer**2 - 2.0 * transfer * (shares @ transfer) + transfer**2
    return np.asarray(_EDGES * power * np.maximum(difference, 0.0))


def _near_edges(places: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Return where filters collect light of other depths."""
    from scipy.ndimage import maximum_filter, minimum_filter

    side = 2 * _AWAY[-1] + 1
    return np.asarray(maximum_filter(places, side) - minimum_filter(places, side) > _UNLIKE)


def _mixed_at_edges(
    observed: PhotographCounts, light: Values, at_edges: NDArray[np.bool_], noise: list[float]
) -> Values:
    """Return light mixed with the photograph near depth edges, where that explains the counts better.

    Only the part of the residual beyond the noise of each channel is corrected.
    """
    from scipy.ndimage import gaussian_filter

    shape = (*observed.blur.shape, -1)
    photo = observed.image
    model = observed.model(light)
    scale = np.sqrt(observed.weight * observed.white / model)
    off = (observed.counts - model) * scale
    # A saturated pixel says only that at least so much light arrived: a brighter model does not contradict it.
    if observed.full is not None:
        off = np.where(observed.full, np.maximum(off, 0.0), off)
    change = (observed.model(photo) - model) * scale

    def local(values: Values) -> Values:
        return np.asarray(gaussian_filter(values.reshape(shape), (_LOCAL, _LOCAL, 0.0)))

    # Least-squares share of the photograph, locally: projection of the residual on the change.
    own, along, across = local(off**2), local(off * change), local(change**2)
    share = np.clip(along / np.maximum(across, 1e-30), 0.0, 1.0)
    share *= at_edges[..., None] * np.maximum(1.0 - np.asarray(noise) / np.maximum(own, 1e-30), 0.0)
    share = share.reshape(light.shape)
    return np.asarray(light + share * (photo - light), dtype=light.dtype)


def _filled(plane: Values, known: NDArray[np.bool_]) -> Array:
    """Return a plane with unknown pixels set to the nearest known one."""
    if known.all():
        return np.asarray(plane, dtype=np.float64)
    from scipy.ndimage import distance_transform_edt

    nearest = distance_transform_edt(~known, return_distances=False, return_indices=True)
    return np.asarray(plane[tuple(nearest)], dtype=np.float64)


def _spectrum(plane: Array) -> tuple[Array, Array]:
    """Return ``|f|`` in cycles per pixel, and the power spectrum of a plane averaged over windowed blocks."""
    sides = [min(side, _BLOCK) for side in plane.shape]
    starts = [
        np.unique(np.linspace(0, whole - side, min(-(-whole // side), _BLOCKS)).astype(int))
        for whole, side in zip(plane.shape, sides, strict=True)
    ]
    # Hann windows: without them the jump between opposite edges would appear as texture of slope 2.
    window = np.outer(*(np.hanning(side + 2)[1:-1] for side in sides))
    window /= math.sqrt(np.square(window).sum())
    total = np.zeros((sides[0], sides[1] // 2 + 1))
    for top in starts[0]:
        for left in starts[1]:
            part = plane[top : top + sides[0], left : left + sides[1]]
            total += np.square(np.abs(np.fft.rfft2((part - part.mean()) * window)))
    f = np.hypot(np.fft.fftfreq(sides[0])[:, None], np.fft.rfftfreq(sides[1]))
    return f, total / (len(starts[0]) * len(starts[1]))


class _Passed(NamedTuple):
    """Power that the lens transmits, averaged over all pixels, in the band and its aliases, (9, frequencies)."""

    band: Band
    f: Array
    power: Array

    @classmethod
    def of(cls, curve: Callable[[Array], Array], places: NDArray[np.float32], count: int) -> Self:
        """Return the transmitted power for the transfer function of each table."""
        band = Band.of(_BAND)
        weights = np.bincount(np.rint(places).astype(int).ravel(), minlength=count) / places.size
        fs, powers = [], []
        # Pixels sample: the nearest eight aliases fold back into the band.
        for across in (0.0, -1.0, 1.0):
            for down in (0.0, -1.0, 1.0):
                x, y = band.fx - across, band.fy - down
                fs.append(np.hypot(x, y))
                powers.append(weights @ np.square(curve(fs[-1])) * np.square(np.sinc(x) * np.sinc(y)))
        return cls(band, np.array(fs), np.array(powers))

    def seen(self, slope: float) -> Array:
        """Return the power spectrum of a photograph of a texture with a slope, without its factor."""
        return np.asarray((self.power * _falling(self.f, slope)).sum(axis=0))


def _falling(f: Array, slope: float) -> Array:
    return np.asarray(np.maximum(f, 1.0 / LARGEST) ** -slope)


def _measured(plane: Array, passed: _Passed, variance: float) -> Texture:
    """Return texture and noise of a plane of the stated `variance`; power 0 if too few rings hold frequencies."""
    f, power = _spectrum(plane)
    edges = np.append(np.geomspace(_LOWEST / min(*plane.shape, _BLOCK), 0.5, _RINGS), 0.75)
    ring_of_f, ring_of_band = np.digitize(f, edges), np.digitize(passed.f[0], edges)
    rings = [k for k in range(1, len(edges)) if (ring_of_f == k).sum() > 8 and (ring_of_band == k).any()]
    count = np.array([float((ring_of_f == k).sum()) for k in rings])
    seen = np.array([power[ring_of_f == k].mean() for k in rings]) / max(variance, 1e-300)
    if len(rings) < 3 or not seen.max() > 0.0:
        return Texture(0.0, _SLOPES[0], 1.0)
    share = passed.band.share

    def ring_means(values: Array) -> Array:
        return np.array([(values * share)[ring_of_band == k].sum() / share[ring_of_band == k].sum() for k in rings])

    # Whittle's likelihood in rings: sum of n (log S + P / S), S the model and P the measured power.
    least = min(1.0, float(seen.min()))
    most = _MOST_NOISE if ring_means(passed.power[0]).min() < _DARK else 1.0
    noise = np.geomspace(least, max(most, least * 1.0001), 40)[:, None, None]
    best, found = math.inf, Texture(0.0, _SLOPES[0], 1.0)
    for slope in _SLOPES:
        shape = ring_means(passed.seen(slope))
        factors = np.geomspace(1e-4, 1e6, 120)[:, None] / max(shape.max(), 1e-300)
        whole = factors * shape + noise
        cost = (count * (np.log(whole) + seen / whole)).sum(axis=2)
        a, b = np.unravel_index(np.argmin(cost), cost.shape)
        # The commonest slope is tried first: another must be clearly more likely.
        if cost[a, b] < best - _MORE_LIKELY:
            best, found = float(cost[a, b]), Texture(float(factors[b, 0]), slope, float(noise[a, 0, 0]))
    return found


def _filtered(tables: SharpTables, plane: Array, places: NDArray[np.float32], threads: int) -> Values:
    """Return a plane filtered according to depth."""
    sides = [max(_LEAST_SIDE, -(-side // _WHOLE) * _WHOLE) for side in plane.shape]
    more = [(0, side - own) for side, own in zip(sides, plane.shape, strict=True)]
    stream = tables.stream((sides[0], sides[1]), threads or processors())
    gains = np.array([[1.0, 0.0, 0.0, 0.0, 0.0, 0.0]], dtype=np.float32)
    stream.take([np.pad(plane.astype(np.float32), more, mode="symmetric")], gains, 0.0, math.inf, None)
    made = np.empty(sides, dtype=np.float32)
    factors = np.ascontiguousarray(tables.mixes(tables.pixel), dtype=np.float32)
    stream.mix(np.pad(places, more, mode="edge"), 1, factors, made)
    return made[: plane.shape[0], : plane.shape[1]]
