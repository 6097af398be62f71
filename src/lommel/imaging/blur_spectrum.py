r"""Likelihood of a blur: the power spectrum of a photograph against that of a blurred texture.

The expected power at the frequency f, in units of the noise variance of a pixel, is

    m(f) = c sum over k of |f - k|^-s h(f - k)^2 sinc(f - k)^2 + nu ,

with the transfer function h of the lens, that of the pixel (sinc), the power ``c f^-s`` of the texture, the noise nu,
and the frequency and its eight nearest aliases ``f - k``. It is averaged over rings, and over the transform of the
window of the measurement, which fills the zeros of h. The likelihood of the measured power P is Whittle's: minus the
sum of ``n (ln m + P / m)`` over rings, each with n independent values (Whittle 1953, doi:10.1007/BF02590998). It is
maximised over c and s for each blur. Gains in likelihood are divided by the dispersion of P / m, if that is above 1.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from functools import cache, lru_cache
from typing import NamedTuple, Self

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values

_RINGS = 96  # rings of spatial frequency from 0 to sqrt(1/2) cycles per pixel
_WIDTH = np.sqrt(0.5) / _RINGS  # width of a ring, cycles per pixel
_LARGEST = 1.6  # largest alias frequency, cycles per pixel
_GRID = 128  # frequencies along each axis of a quadrant, of which the shares of rings are computed
_SLOPES = np.arange(0.0, 4.01, 0.25)  # exponents s of the texture
# Soft scenes behind an unknown blur: rms widths (pixels) of their Gaussians, each for every second exponent.
SOFT = np.array([0.35, 0.5, 0.7, 0.9, 1.2, 1.6, 2.2, 3.0, 4.0])
_MIN_PERIODS = 2.5  # smallest frequency that is compared, periods per side of the photograph
_NOISES = np.geomspace(0.5, 2.0, 13)  # noise variance in units of the stated variance
_MORE_NOISES = 2.0, 2.8, 4.0, 5.7, 8.0  # the same, of noise that is stated too low
_MIN_NOISE_GAIN = 5.0  # gain in log-likelihood that another noise variance than the stated one needs
_JOINED = 8  # rings whose mean power limits the noise
_FEW_SLOPES = np.arange(0.5, 3.6, 0.5)  # exponents of the textures of parts
_TINY, _TINY_SINGLE = 1e-300, 1e-30
# Steps of the fit of the power, the longest of its logarithm, and the least excess over noise from which it starts.
_SCORINGS, _LONGEST, _LEAST_EXCESS = 5, 2.0, 1e-3
# Unsharp masks, amounts and rms widths (pixels) of their Gaussians, that are compared with none.
_AMOUNTS, _MASKS = (0.4, 0.8, 1.5), (0.7, 1.0, 1.5, 2.5)
_OPAQUE_POWER = 1e-2  # transmitted power below which more noise is distinguishable from texture


class Texture(NamedTuple):
    """Power spectrum ``power f^-slope`` of a texture, and the noise variance, in units of the stated variance."""

    power: float
    slope: float
    noise: float

    def spectrum(self, f: Array) -> Array:
        """Return the power at frequencies above 0 (cycles per pixel)."""
        return np.asarray(self.power * f**-self.slope)


FREQUENCIES: Array = (np.arange(int(_LARGEST / _WIDTH)) + 0.5) * _WIDTH
"""Frequencies (cycles per pixel) at which the transfer functions of blurs are given."""


def cosine_axes(shape: tuple[int, ...]) -> tuple[Array, Array]:
    """Return the frequencies (cycles per pixel) of a cosine transform down and across an image."""
    return np.arange(shape[0])[:, None] / (2.0 * shape[0]), np.arange(shape[1]) / (2.0 * shape[1])


@cache
def _shares() -> Array:
    """Return the mean power in each ring of a unit power at each of FREQUENCIES, with its aliases and the pixel."""
    axis = (np.arange(_GRID) + 0.5) / (2 * _GRID)
    ring = _ring_of(np.hypot(axis[:, None], axis))
    shares = np.zeros(_RINGS * len(FREQUENCIES))
    for down in (0.0, 1.0, -1.0):
        for across in (0.0, 1.0, -1.0):
            y, x = axis[:, None] - down, axis - across
            place = (np.hypot(y, x) / _WIDTH).astype(np.intp)
            near = place < len(FREQUENCIES)
            index = ring[near] * len(FREQUENCIES) + place[near]
            shares += np.bincount(index, (np.sinc(y) * np.sinc(x))[near] ** 2, shares.size)
    counts = np.bincount(ring.ravel(), minlength=_RINGS)
    return np.asarray(shares.reshape(_RINGS, -1) / np.maximum(counts, 1)[:, None])


def _ring_of(f: Array) -> NDArray[np.intp]:
    return np.asarray(np.minimum((f / _WIDTH).astype(np.intp), _RINGS - 1))


def _expected(curves: Array, slopes: Array, spread: float) -> Array:
    """Return the expected power of textures of power 1 in a window, (..., blurs, slopes, rings)."""
    power = np.square(curves)[..., None, :] * FREQUENCIES ** -slopes[:, None]
    # Averages of a ring, and over a narrow window in two dimensions, add half of a variance times derivatives.
    bent = (power[..., 2:] - 2.0 * power[..., 1:-1] + power[..., :-2]) / _WIDTH**2
    slope = (power[..., 2:] - power[..., :-2]) / (2.0 * _WIDTH * FREQUENCIES[1:-1])
    power[..., 1:-1] += 0.5 * ((spread + _WIDTH**2 / 12.0) * bent + spread * slope)
    return np.asarray(np.maximum(power, 0.0) @ _shares().T)


@lru_cache(maxsize=4)
def _soft_expected(curves: bytes, blurs: int, spread: float) -> Array:
    """Return the same for textures that also fall as Gaussians; all parts of a photograph have the first stack."""
    falls = np.exp(-0.5 * np.square(2.0 * np.pi * SOFT[:, None, None] * FREQUENCIES))
    return _expected(np.frombuffer(curves).reshape(blurs, -1) * falls, _SLOPES[::2], spread)


def _periodogram(planes: Array, variances: Array) -> tuple[Array, Array, Array, float]:
    """Return the arguments of a `BlurSpectrum` of planes in a Hann window."""
    sides = planes.shape[1:]
    window = np.outer(*(np.hanning(side + 2)[1:-1] for side in sides))
    squares = np.square(window)
    means = (planes * window).sum((1, 2)) / window.sum()
    noise = (variances * squares).sum((1, 2))
    spectra = np.fft.rfft2((planes - means[:, None, None]) * window)
    power = (np.square(spectra.real) + np.square(spectra.imag)) / np.maximum(noise, _TINY)[:, None, None]
    fx = np.fft.rfftfreq(sides[1])
    f = np.hypot(np.fft.fftfreq(sides[0])[:, None], fx)
    # All but the first and last column of half a spectrum stand for two; a real image has equal values at f and
    # -f; and the window correlates neighbours.
    counts = np.where((fx > 0.0) & (fx < 0.5), 1.0, 0.5) * (f >= _MIN_PERIODS / min(sides))
    counts *= squares.sum() ** 2 / (np.square(squares).sum() * planes[0].size)
    # The mean square of the slope of a Hann window is that of its values times 4 pi^2 / (3 side^2).
    return power, f, counts, sum(1.0 / (3.0 * side**2) for side in sides) / 2.0


class BlurSpectrum:
    """Power spectra of the channels of a photograph in rings, in units of the noise variance.

    Parameters
    ----------
    power : ndarray, shape (channels, ...)
        Power spectra in units of the noise variance.
    f : ndarray
        Frequencies, cycles per pixel.
    counts : ndarray
        Number of independent complex values at each frequency, 0 where the power is ignored.
    spread : float
        Variance of the power spectrum of the window along each axis, (cycles per pixel)^2.
    """

    def __init__(self, power: Array, f: Array, counts: Array, spread: float = 0.0) -> None:
        self._spread = spread
        ring = _ring_of(f).ravel()
        sums = np.bincount(ring, counts.ravel(), _RINGS).astype(np.float64)
        self._known = sums > 0.0
        self._counts = sums[self._known]
        rings = np.array([np.bincount(ring, (counts * p).ravel(), _RINGS) for p in power])
        self._power = rings[:, self._known] / self._counts

    @classmethod
    def windowed(cls, planes: Array, variances: Array) -> Self:
        """Return the spectra of planes (channels, height, width) in a Hann window, by the variance of their pixels.

        Without a window the jump between opposite edges would appear as a texture of slope 2.
        """
        return cls(*_periodogram(planes, variances))

    @classmethod
    def sectors(cls, plane: Array, variance: Array, number: int) -> list[Self]:
        """Return the spectra of a plane in sectors of half a turn of frequencies, from rows towards lower ones."""
        power, f, counts, spread = _periodogram(plane[None], variance[None])
        angle = np.arctan2(np.fft.fftfreq(plane.shape[0])[:, None], np.fft.rfftfreq(plane.shape[1]))
        sector = (angle % np.pi * (number / np.pi)).astype(np.intp) % number
        return [cls(power[:, part], f[part], counts[part], spread) for part in (sector == k for k in range(number))]

    def mean_powers(self, edges: Sequence[float]) -> Array:
        """Return the mean power of the first channel between frequencies, cycles per pixel, at least 1e-3."""
        starts = np.searchsorted((np.flatnonzero(self._known) + 0.5) * _WIDTH, edges)
        means = [self._power[0, low:high] @ self._counts[low:high] for low, high in itertools.pairwise(starts)]
        sums = [self._counts[low:high].sum() for low, high in itertools.pairwise(starts)]
        return np.asarray(np.maximum(means, 1e-3) / np.maximum(sums, 1e-3))

    @staticmethod
    def of_parts(parts: Sequence[BlurSpectrum], curves: Array, every: int = 1) -> tuple[Array, Array]:
        """Return the log-likelihood of blurs in each part of a spectrum, and the dispersion of the best of each.

        Parts have textures of their own; `every` is the stride of their exponents. The log-likelihood is not divided
        by the dispersion.
        """
        slopes = _FEW_SLOPES[::every]
        expected = _expected(curves, slopes, parts[0]._spread)
        fits = [_Fit.of(part._power[0], part._counts, expected[..., part._known], slopes, 1.0) for part in parts]
        return np.array([-f.cost for f in fits]), np.array([f.dispersion[f.cost.argmin()] for f in fits])

    @classmethod
    def cosine(cls, planes: Values, variances: Array) -> Self:
        """Return the spectra of planes that are mirrored at their edges, by the variances of their channels."""
        power = np.square(scipy.fft.dctn(planes, axes=(1, 2), norm="ortho"), dtype=np.float64)
        f = np.hypot(*cosine_axes(planes.shape[1:]))
        # The values of cosine transforms are real.
        counts = np.where(f >= _MIN_PERIODS / min(f.shape), 0.5, 0.0)
        return cls(power / np.maximum(variances, _TINY).reshape(-1, 1, 1), f, counts)

    def texture(self, curve: Array, channel: int) -> Texture:
        """Return the most likely texture of a channel and its noise, for the transfer `curve` at FREQUENCIES."""
        measured = self._power[channel]
        if not measured.size or not measured.max() > 0.0:
            return Texture(0.0, 2.0, 1.0)
        shapes = self._shapes(curve[None])
        best, texture_noise = self._fit(shapes, channel, 1.0), 1.0
        least = best.cost[0] - _MIN_NOISE_GAIN
        most = self._most_noise(channel)
        for noise in _NOISES[(most >= _NOISES if most < 1.0 else _NOISES > 1.0)]:
            # Beyond the stated noise only where the lens transmits nothing, which texture might be.
            if noise > 1.0 and np.square(curve[: _RINGS // 2]).min() > _OPAQUE_POWER:
                break
            fit = self._fit(shapes, channel, noise)
            if fit.cost[0] < least:
                least, best, texture_noise = fit.cost[0], fit, float(noise)
        return best.texture(texture_noise)

    def residual(self, curve: Array, texture: Texture) -> float:
        """Return the residual power expected of the Wiener filter, in units of the stated noise variance."""
        power = np.square(curve) * texture.spectrum(FREQUENCIES)
        signal = _shares()[self._known] @ power
        return float(self._counts @ (texture.noise**2 / (texture.noise + signal)) / self._counts.sum())

    def _most_noise(self, channel: int) -> float:
        """Return the largest noise that the weakest frequencies allow, within three standard errors."""
        starts = np.arange(0, len(self._counts), _JOINED)
        counts = np.add.reduceat(self._counts, starts)
        means = np.add.reduceat(self._power[channel] * self._counts, starts) / counts
        return float((means * (1.0 + 3.0 / np.sqrt(counts))).min())

    def likelihood(self, curves: Array, channel: int, noise: float) -> Array:
        """Return the log-likelihood of blurs with the transfer `curves` (blurs, frequencies) at FREQUENCIES.

        It is divided by the dispersion of the best blur, if that is above 1.
        """
        fit = self._fit(self._shapes(curves), channel, noise)
        return np.asarray(-fit.cost / max(float(fit.dispersion[fit.cost.argmin()]), 1.0))

    def soft_likelihood(self, curves: Array, channel: int) -> tuple[Array, Array, Array]:
        """Return the log-likelihood of blurs, that where the texture may also fall as a Gaussian, and its exponents.

        Only zeros of the transfer functions tell blurs from soft scenes. The exponents are those without a Gaussian.
        """
        plain = self._fit(self._shapes(curves), channel, 1.0)
        stack = self._soft_shapes(curves)
        soft = _Fit.of(self._power[channel], self._counts, stack, _SLOPES[::2], 1.0)
        costs, scatters = (np.concatenate([x[None], y]) for x, y in zip(plain[::3], soft[::3], strict=True))
        scale = max(float(scatters.ravel()[costs.argmin()]), 1.0)
        return -plain.cost / scale, -costs.min(axis=0) / scale, plain.slope

    def more_noise(self, curve: Array, channel: int, assumed: float) -> tuple[float, float, float]:
        """Return the most likely noise of 2 to 8 times the stated variance, and its gains in log-likelihood.

        These are over the stated noise, and over that of `assumed` times its variance.
        """
        if self._most_noise(channel) < _MORE_NOISES[0]:
            return 1.0, 0.0, 0.0
        noises, shapes = (1.0, assumed, *_MORE_NOISES), self._shapes(curve[None])
        fits = [self._fit(shapes, channel, noise) for noise in noises]
        costs = [float(fit.cost[0]) for fit in fits]
        best = 2 + int(np.argmin(costs[2:]))
        scale = max(float(fits[best].dispersion[0]), 1.0)
        return noises[best], (costs[0] - costs[best]) / scale, (costs[1] - costs[best]) / scale

    def sharpening(self, curves: Array, channel: int, noise: float) -> float:
        """Return the gain in log-likelihood of an unsharp mask, which also sharpens noise, over a photograph without.

        The blur is the first or the best of `curves`; the `noise` is that without a mask, and at most 1 with one.
        """
        shapes, power = self._shapes(curves), self._power[channel]
        fit = self._fit(shapes, channel, noise)
        best = int(np.argmin(fit.cost))
        f = (np.flatnonzero(self._known) + 0.5) * _WIDTH
        masks = [
            1.0 + amount * (1.0 - np.exp(-2.0 * np.square(np.pi * rms * f)))
            for amount, rms in itertools.product(_AMOUNTS, _MASKS)
        ]
        raised = np.square(masks)
        first = shapes[[0, best] if best else [0]]
        masked = _Fit.of((power / raised)[:, None, None], self._counts, first, _SLOPES, 1.0)
        gains = fit.cost[best] - masked.cost - (np.log(raised) @ self._counts)[:, None]
        each = np.arange(len(masks)), masked.cost.argmin(axis=1)
        return float((gains[each] / np.maximum(masked.dispersion[each], 1.0)).max())

    def _shapes(self, curves: Array) -> Array:
        """Return the expected power of textures of power 1, (blurs, slopes, rings)."""
        return _expected(curves, _SLOPES, self._spread)[..., self._known]

    def _soft_shapes(self, curves: Array) -> Array:
        """Return the same for soft textures, (widths, blurs, slopes, rings)."""
        return _soft_expected(curves.tobytes(), len(curves), self._spread)[..., self._known]

    def _fit(self, shapes: Array, channel: int, noise: float) -> _Fit:
        return _Fit.of(self._power[channel], self._counts, shapes, _SLOPES, noise)


class _Fit(NamedTuple):
    """Most likely textures for several blurs: minus log-likelihood, power, exponent and dispersion of each."""

    cost: Array
    power: Array
    slope: Array
    dispersion: Array

    @classmethod
    def of(cls, power: Array, counts: Array, shapes: Array, slopes: Array, noise: float) -> Self:
        """Return the fits of shapes (..., slopes, rings) to the measured `power`, which has as many axes, or one."""
        peaks = np.maximum(shapes.max(axis=-1), _TINY)
        unit = shapes / peaks[..., None]
        excess = np.maximum((power - noise) @ counts, _LEAST_EXCESS * counts.sum())
        level = np.log(excess / np.maximum(unit @ counts, _LEAST_EXCESS))
        short, brief, weights = (np.asarray(values, np.float32) for values in (unit, power, counts))
        for _ in range(_SCORINGS):  # Fisher's: the derivative by the level, divided by the information
            signal = np.exp(level)[..., None].astype(np.float32) * short
            model = signal + np.float32(noise)
            share = signal / model
            slope, information = (share * (brief / model - 1.0)) @ weights, np.square(share) @ weights
            level = level + np.clip(slope / np.maximum(information, _TINY_SINGLE), -_LONGEST, _LONGEST)
        model = np.exp(level)[..., None] * unit + noise
        ratio = power / model
        cost = (np.log(model) + ratio) @ counts
        dispersion = np.square(ratio - 1.0) @ counts / max(power.shape[-1] - 3, 1)
        best = cost.argmin(axis=-1)[..., None]
        found = (np.take_along_axis(values, best, -1)[..., 0] for values in (cost, np.exp(level) / peaks, dispersion))
        least, factor, scatter = found
        return cls(least, factor, slopes[best[..., 0]], scatter)

    def texture(self, noise: float) -> Texture:
        """Return the texture of the first blur."""
        return Texture(float(self.power[0]), float(self.slope[0]), noise)
