r"""The depth of the parts of a scene from several photographs of it: what is searched, and how sure the answer is.

Photographs y_i of one texture x are ``y_i = h_i(u) x + n_i`` at each frequency, h_i the transfer function at the
vergence u = 1 / depth, n_i noise. Whatever x is, at the right u what is orthogonal to h in the vector y is noise: of
two photographs, ``(h_2 y_1 - h_1 y_2) / sqrt(h_1^2 + h_2^2)``. Its energy within a window, less that of noise, is
least there on average, of every texture, and half of it is minus the logarithm of the likelihood. Frequencies that
noise hides get the weight ``S |h|^2 / (1 + S |h|^2)``, S the power of texture over that of noise, which makes the
least variance: a wrong S makes the answer less exact, not wrong.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.estimation.pixel_transfer import multiplicity, squared_frequency

_LEVELS = (0.1, 0.005)
"""Powers of texture that weights are made for, over that of the tile; a factor of ten more or less costs little.

Less than there is, for filters then end sooner, and so do the errors of what changes with the depth.
"""
_BETWEEN = 0.03
"""Below this power over that of the tile a window is served by the second."""
_COARSE = 4
"""At every so many candidates is the texture measured."""
_FEW = 0.01
"""Less than this share of a tile is served by the first level whatever its texture."""
_PART = 64
"""Pixels down or across whose windows are computed by one product."""
_SURE = 4.0
"""Texture is what exceeds noise by so many standard deviations of its energy."""

Floats = NDArray[np.floating[Any]]


@dataclass(frozen=True, eq=False)
class Transform:
    """Several images of one channel at the frequencies of their transfer functions, in both halves.

    Attributes
    ----------
    shape : (int, int)
        Of the images.
    top, bottom : ndarray, shape (images, height // 2 + 1, width // 2 + 1)
        At rising and at falling frequencies down.
    """

    shape: tuple[int, int]
    top: NDArray[np.complex64]
    bottom: NDArray[np.complex64]

    @classmethod
    def of(cls, images: Floats) -> Transform:
        """Transform images of shape (images, height, width)."""
        from scipy.fft import rfft2

        made = rfft2(images.astype(np.float32, copy=False))
        rows = np.arange(images.shape[1] // 2 + 1)
        return cls(images.shape[1:], made[:, rows], made[:, -rows])

    def sum(self, filters: Floats) -> NDArray[np.float32]:
        """Return the sum of the images, each through an even filter of the shape of `top`."""
        from scipy.fft import irfft2

        height, width = self.shape
        half, rest = len(filters[0]), height - len(filters[0])
        out = np.empty((height, width // 2 + 1), dtype=np.complex64)
        np.multiply(filters[0], self.top[0], out=out[:half])
        np.multiply(filters[0][rest:0:-1], self.bottom[0, rest:0:-1], out=out[half:])
        for one, top, bottom in zip(filters[1:], self.top[1:], self.bottom[1:], strict=True):
            out[:half] += one * top
            out[half:] += one[rest:0:-1] * bottom[rest:0:-1]
        made: NDArray[np.float32] = irfft2(out, s=self.shape, overwrite_x=True)
        return made

    def level(self, transfers: Floats) -> float:
        """Return the power S of texture over that of noise at 1 cycle a pixel, the same all over, ``S / f^2``."""
        times, square = multiplicity(self.shape), squared_frequency(self.shape)
        square[0, 0] = np.inf
        size = self.shape[0] * self.shape[1]

        def excess(log_level: float, hh: Floats, power: Floats) -> float:
            return float((times * power / (1.0 + np.exp(log_level) / square * hh)).sum()) - 1.0

        found = []
        for h in np.moveaxis(transfers[:, :: 3 * _COARSE], 1, 0):
            hh = (h**2).sum(axis=0) + 1e-12
            halves = [np.abs((h * part).sum(axis=0)) ** 2 for part in (self.top, self.bottom)]
            power = 0.5 * (halves[0] + halves[1]) / (hh * size)
            power[0, 0] = 0.0
            low, high = -23.0, 46.0
            for _ in range(40):
                middle = 0.5 * (low + high)
                low, high = (middle, high) if excess(middle, hh, power) > 0.0 else (low, middle)
            found.append(low)
        return float(np.exp(np.median(found)))


def residuals(h: Floats) -> Iterator[Floats]:
    """Return filters that take from images what is orthogonal to their transfer functions, by Givens' rotations.

    Parameters
    ----------
    h : ndarray, shape (images, ...)
        Transfer functions over the rms noise of each image.

    Yields
    ------
    ndarray, shape (images, ...)
        Unit vectors orthogonal to `h` and to one another, one less than there are images.
    """
    # Signed, for a filter whose sign jumps from frequency to frequency spreads over the image.
    length, unit = h[0], np.ones_like(h[:1])
    for k in range(1, len(h)):
        more = np.sqrt(length**2 + h[k] ** 2 + np.float32(1e-12))
        out = np.zeros_like(h)
        out[:k] = unit * (h[k] / more)
        out[k] = -length / more
        yield out
        unit = np.concatenate([unit * (length / more), [h[k] / more]])
        length = more


class Weights(NamedTuple):
    """Windows of Gaussian weight, as products with narrow matrices on either side.

    Attributes
    ----------
    down, across : list of (slice, ndarray)
        For some pixels that a tile answers for after the others, which pixels with its margins they are made of, and
        how much of each; rows sum to 1.
    """

    down: list[tuple[slice, NDArray[np.float32]]]
    across: list[tuple[slice, NDArray[np.float32]]]

    @classmethod
    def of(cls, sides: tuple[int, int], margin: int, core: tuple[int, int], window: float) -> Weights:
        """Return windows of an rms width, which end after five of it, and with the tile."""
        reach = math.ceil(5.0 * window)

        def matrices(side: int, inner: int) -> list[tuple[slice, NDArray[np.float32]]]:
            out = []
            for first in range(margin, margin + inner, _PART):
                last = min(first + _PART, margin + inner)
                taken = slice(max(first - reach, 0), min(last + reach, side))
                away = np.arange(taken.start, taken.stop) - np.arange(first, last)[:, None]
                made = np.exp(-0.5 * (away / window) ** 2)
                out.append((taken, np.asarray(made / made.sum(axis=1, keepdims=True), dtype=np.float32)))
            return out

        return cls(matrices(sides[0], core[0]), matrices(sides[1], core[1]))

    @property
    def shape(self) -> tuple[int, int]:
        """How many pixels the tile answers for, down and across."""
        rows, columns = (sum(len(matrix) for _, matrix in side) for side in self)
        return rows, columns

    def __call__(self, image: Floats) -> NDArray[np.float32]:
        """Return the weighted mean round each pixel that the tile answers for."""
        rows = np.concatenate([matrix @ image[taken] for taken, matrix in self.down])
        return np.concatenate([rows[:, taken] @ matrix.T for taken, matrix in self.across], axis=1)


def whitened(images: Floats, variances: Floats, transfers: Floats) -> tuple[Transform, Floats, Floats]:
    """Return images and transfer functions over the noise of each image, and where there is how much of it.

    The noise of one photograph over that of another is taken to be the same all over; how much there is, is not.
    Over the root of the mean of the last, the first is white.
    """
    ratio = variances.mean(axis=(1, 2))
    ratio = ratio / ratio.mean()
    local = (variances / ratio[:, None, None]).mean(axis=0)
    scale = 1.0 / np.sqrt(ratio * local.mean())
    transform = Transform.of((images - images.mean(axis=(1, 2), keepdims=True)) * scale[:, None, None])
    return transform, transfers * (1.0 / np.sqrt(ratio)).astype(np.float32)[:, None, None, None], local


class Costs:
    """The costs of all candidates in one channel of a tile, by the weights for each level of texture.

    Attributes
    ----------
    power : float
        Of the texture of the tile at 1 cycle a pixel, over that of noise.
    values : list of ndarray, shape (candidates, height, width)
        For each level that has been computed, half of the energy that is left, less that of noise.
    known, spread : ndarray, shape (levels, candidates)
        The energy of noise, and the variance of a cost by noise for one independent pixel.
    curvature, by_texture, by_noise : ndarray, shape (levels, candidates)
        What is expected of texture as strong as that of the tile: the second derivative of the cost by the candidate,
        the variance of the first for one independent pixel, and the part of that by noise, which is always there.
    coverage : ndarray, shape (height, width)
        Share of each window that is known.
    """

    def __init__(self, images: Floats, variances: Floats, valid: Floats, transfers: Floats, weigh: Weights) -> None:
        self._images, h, local = whitened(images, variances, transfers)
        self._trust = (valid * (float(local.mean()) / local)).astype(np.float32)
        self._weigh, self.coverage = weigh, np.maximum(weigh(valid), 1e-6)
        self.power = self._images.level(h)
        self._times = multiplicity(self._images.shape).astype(np.float32)
        square = squared_frequency(self._images.shape).astype(np.float32)
        square[0, 0] = np.inf
        count = h.shape[1]
        self._h, self._slopes, self._spectrum = h, np.gradient(h, axis=1), self.power / square
        self.known, self.spread, self.curvature, self.by_texture, self.by_noise = np.empty((5, len(_LEVELS), count))
        self._of_texture = np.empty((3, len(_LEVELS), -(-count // _COARSE)))
        self.values: list[NDArray[np.float32]] = []
        self._textures: list[NDArray[np.float32]] = []
        self._level()

    def _level(self) -> None:
        """Compute all candidates by the weights of the next level."""
        k, count = len(self.values), self._h.shape[1]
        self.values.append(np.empty((count, *self._weigh.shape), dtype=np.float32))
        self._textures.append(np.empty((self._of_texture.shape[2], *self._weigh.shape), dtype=np.float32))
        for c in range(count):
            self._candidate(k, c, self._h[:, c], self._slopes[:, c])

    def _candidate(self, k: int, c: int, h: Floats, slope: Floats) -> None:
        """Compute all of one candidate, from its transfer functions and their slope."""
        hh = (h * h).sum(axis=0) + np.float32(1e-12)
        across = np.maximum((slope * slope).sum(axis=0) - (h * slope).sum(axis=0) ** 2 / hh, 0.0)
        filters = list(residuals(h))
        full = self._spectrum * hh
        signal = np.float32(_LEVELS[k]) * full
        weight = signal / (1.0 + signal)
        root = np.sqrt(weight)
        self.known[k, c] = len(filters) * self._mean(weight)
        self.spread[k, c] = 0.5 * len(filters) * self._mean(weight**2)
        energy = sum(self._energy(one * root) for one in filters)
        self.values[k][c] = 0.5 * (energy - self.known[k, c])
        moved = weight * across
        self.curvature[k, c] = self._mean(moved * self._spectrum)
        self.by_texture[k, c] = self._mean(moved * weight * self._spectrum)
        self.by_noise[k, c] = self._mean(moved * weight / hh)
        if c % _COARSE == 0:
            filtered = signal / (1.0 + signal) ** 2  # of the least variance for texture of this level
            self._textures[k][c // _COARSE] = self._energy(h * np.sqrt(filtered / hh))
            self._of_texture[:, k, c // _COARSE] = [
                self._mean(values) for values in (filtered, filtered * full, filtered**2)
            ]

    def _mean(self, values: Floats) -> float:
        """Return the mean over all frequencies."""
        return float(np.vdot(self._times, values))

    def _energy(self, filters: Floats) -> Floats:
        """Return the energy of the sum of the images through filters, over that of white noise, in each window."""
        values = self._images.sum(filters)
        values *= values
        values *= self._trust
        return np.asarray(self._weigh(values) / self.coverage)

    def choose(self, at: NDArray[np.int64], independent: Floats) -> NDArray[np.int64]:
        """Return the level that serves each pixel, and compute its costs; the second for few pixels is not worth it.

        Parameters
        ----------
        at : ndarray of int, shape (height, width)
            Of each pixel, the candidate.
        independent : ndarray
            How many independent pixels there are in each window.
        """
        weak = self._texture(0, at, 1.0, independent)[0] < _BETWEEN
        if weak.mean() < _FEW:
            return np.zeros(at.shape, dtype=np.int64)
        self._level()
        return weak.astype(np.int64)

    def texture(
        self, at: NDArray[np.int64], level: NDArray[np.int64], misfit: Floats, independent: Floats
    ) -> tuple[Floats, NDArray[np.bool_]]:
        """Return the power of the texture over that of the tile, and where it is more than noise.

        Parameters
        ----------
        at, level : ndarray of int, shape (height, width)
            Of each pixel, the candidate and the level.
        misfit : ndarray
            Energy of noise over what it should be.
        independent : ndarray
            How many independent pixels there are in each window.
        """
        found = [self._texture(k, at, misfit, independent) for k in range(len(self.values))]
        power, sure = (np.choose(level, each) for each in zip(*found, strict=True))
        return power, sure

    def _texture(
        self, k: int, at: NDArray[np.int64], misfit: Floats | float, independent: Floats
    ) -> tuple[Floats, NDArray[np.bool_]]:
        """Return power and certainty by the weights of one level."""
        place = np.minimum((at + _COARSE // 2) // _COARSE, len(self._textures[k]) - 1)
        noise, signal, spread = (each[place] for each in self._of_texture[:, k])
        energy = np.take_along_axis(self._textures[k], place[None], axis=0)[0]
        mean = misfit * noise
        # The quantile of chi squared, by Wilson and Hilferty.
        part = 2.0 / 9.0 * spread / (noise**2 * independent)
        return np.maximum(energy - mean, 0.0) / signal, energy > mean * (1.0 - part + _SURE * np.sqrt(part)) ** 3

    def of_level(self, level: NDArray[np.int64]) -> Floats:
        """Return the costs, shape (candidates, height, width), each pixel's by the weights of its level."""
        return self.values[0] if len(self.values) == 1 else np.where(level, self.values[1], self.values[0])


_STENCIL = 7
"""Candidates that the polynomial goes through whose minimum is sought."""
_DROP = 9.0
"""Depth is known where the best candidate is better than the mean of all by so much of a logarithm of likelihood."""
_SURE_OF_BEST = 3.0
"""And by so many standard deviations of what noise makes of a cost."""
_CLEAR = 100.0
"""From so much on there is no doubt of a minimum."""
_NOISIER = 2.0
"""What is left may be noise that was stated too low by so much; more is depth that changes, or edges."""


class Found(NamedTuple):
    """What a tile tells, each of shape (height, width).

    Attributes
    ----------
    position : ndarray
        Of the least cost, candidates from the first; where that lies at either end, there is none, NaN.
    variance : ndarray
        Of the position, in candidates squared; infinite where nothing is known.
    misfit : ndarray
        Energy left over that of noise, 1 where the model holds.
    level : ndarray
        Power of the texture at 1 cycle a pixel over that of noise.
    """

    position: Floats
    variance: Floats
    misfit: Floats
    level: Floats


class Tile(NamedTuple):
    """Photographs of a part of a scene.

    Attributes
    ----------
    images : ndarray, shape (channels, photographs, height, width)
        Electrons of equal exposures, with margins.
    variances : ndarray, of that shape
        Of each pixel's noise.
    valid, own : ndarray of float32, shape (height, width)
        1 where pixels are to be believed, and where they are of the image rather than mirrored; 0 elsewhere.
    """

    images: Floats
    variances: Floats
    valid: NDArray[np.float32]
    own: NDArray[np.float32]


def search(tile: Tile, transfers: list[NDArray[np.float32]], weigh: Weights, window: float) -> Found:
    """Find the depth of each pixel that a tile answers for.

    Parameters
    ----------
    tile : Tile
    transfers : list of ndarray, shape (photographs, candidates, height // 2 + 1, width // 2 + 1)
        Of each channel.
    weigh : Weights
    window : float
        The rms width of the windows, pixels.

    Returns
    -------
    Found
    """
    channels = [
        Costs(images, variances, tile.valid, transfer, weigh)
        for images, variances, transfer in zip(tile.images, tile.variances, transfers, strict=True)
    ]
    share = channels[0].coverage
    independent = 4.0 * np.pi * window**2 * share
    levels = [one.choose(_least(one.values[0]), independent) for one in channels]
    parts = [one.of_level(level) for one, level in zip(channels, levels, strict=True)]
    cost = parts[0] if len(parts) == 1 else np.sum(parts, axis=0)
    at = _least(cost)
    position, curvature, least = _minimum(cost, at)
    noise = sum(one.known[level, at] for one, level in zip(channels, levels, strict=True))
    misfit = np.maximum(1.0 + 2.0 * least / np.maximum(noise, 1e-30), 0.0)
    worse = np.maximum(misfit, 1.0)
    # How much better the best candidate is than the mean of all, as the logarithm of a likelihood.
    drop = (cost.mean(axis=0) - least) * independent / worse
    clear = drop > _CLEAR
    sure = clear.copy()
    slope, expected, power = np.zeros((3, *at.shape))
    steepest = sum(one.curvature[level, at] for one, level in zip(channels, levels, strict=True))
    for one, level in zip(channels, levels, strict=True):
        texture, more = one.texture(at, level, np.minimum(worse, _NOISIER), independent)
        # Where the minimum is clear it tells the texture better than the texture does.
        texture = np.where(clear, np.maximum(curvature / steepest, 0.0), texture)
        sure |= more
        expected += texture * one.curvature[level, at]
        slope += texture * one.by_texture[level, at] + one.by_noise[level, at]
        power += texture * one.power / len(channels)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        variance = slope / (np.minimum(curvature, 2.0 * expected) ** 2 * independent) * worse**2
    # One narrow minimum among others that are nearly as low is chance.
    variance = np.maximum(variance, _spread(cost, at, independent / worse))
    chance = sum(one.spread[level, at] for one, level in zip(channels, levels, strict=True))
    enough = np.maximum(_DROP, _SURE_OF_BEST * np.sqrt(chance * independent))
    # Less than half of what a window has of the image is not to be believed.
    whole = share >= 0.5 * weigh(tile.own)
    known = sure & whole & (curvature > 0.0) & np.isfinite(variance) & (drop >= enough)
    variance[~known] = np.inf
    outside = (at == 0) | (at == len(cost) - 1)
    variance[outside], position[outside] = np.inf, np.nan
    return Found(position, variance, misfit, power)


def _least(cost: Floats) -> NDArray[np.int64]:
    """Return the place of the least along the first axis, as argmin does ten times as slowly."""
    at, least = np.zeros(cost.shape[1:], dtype=np.int64), cost[0].copy()
    for c, one in enumerate(cost[1:], 1):
        less = one < least
        at[less] = c
        np.minimum(least, one, out=least)
    return at


def _spread(cost: Floats, at: NDArray[np.int64], independent: Floats) -> Floats:
    """Return the mean square distance from the least candidate and its neighbours, each being as likely as it costs.

    In candidates; a minimum between two of them is no doubt.
    """
    least = np.take_along_axis(cost, at[None], axis=0)[0]
    scale = independent.astype(np.float32)
    total, moment = np.zeros((2, *at.shape), dtype=np.float32)
    for c, one in enumerate(cost):
        chance = np.exp((least - one) * scale)
        total += chance
        moment += chance * (np.maximum(np.abs(at - c) - 1, 0) ** 2).astype(np.float32)
    return np.asarray(moment / total)


def _minimum(cost: Floats, at: NDArray[np.int64]) -> tuple[Floats, Floats, Floats]:
    """Return place, curvature and value of the minimum next to the least candidate, by a polynomial through seven."""
    start = np.clip(at - _STENCIL // 2, 0, len(cost) - _STENCIL)
    index = start + np.arange(_STENCIL).reshape(-1, *([1] * at.ndim))
    values = np.take_along_axis(cost, index, axis=0).astype(np.float64)
    nodes = np.arange(_STENCIL) - _STENCIL // 2
    inverse = np.linalg.inv(np.vander(nodes, increasing=True).astype(np.float64))
    terms = np.tensordot(inverse, values, axes=1)
    middle = (at - start - _STENCIL // 2).astype(np.float64)
    x = middle.copy()

    def derivative(order: int) -> Floats:
        total = np.zeros_like(x)
        for power in range(_STENCIL - 1, order - 1, -1):
            total = total * x + terms[power] * np.prod(np.arange(power, power - order, -1))
        return total

    for _ in range(4):
        bend = derivative(2)
        with np.errstate(divide="ignore", invalid="ignore"):
            step = np.where(bend > 0.0, -derivative(1) / bend, 0.0)
        x = np.clip(x + np.clip(step, -0.5, 0.5), middle - 1.0, middle + 1.0)
    return start + _STENCIL // 2 + x, derivative(2), derivative(0)


def sharpen(
    images: Floats,
    variances: Floats,
    transfers: Floats,
    position: Floats,
    level: float,
    inner: tuple[slice, slice],
) -> NDArray[np.float64]:
    """Return the scene of one channel in focus, by Wiener's filter at the depth of each pixel.

    Parameters
    ----------
    images, variances : ndarray, shape (photographs, height, width)
    transfers : ndarray, shape (photographs, candidates, height // 2 + 1, width // 2 + 1)
    position : ndarray
        Of each pixel that the tile answers for, candidates from the first.
    level : float
        Power of the texture at 1 cycle a pixel over that of noise.
    inner : (slice, slice)
        Where these pixels are in the images.
    """
    transform, h, local = whitened(images, variances, transfers)
    spectrum = squared_frequency(transform.shape).astype(np.float32)
    spectrum[0, 0] = np.inf
    spectrum = level / spectrum
    count = h.shape[1]
    place = np.clip(position, 0.0, count - 1.0)
    out = np.zeros(position.shape)
    for c in np.unique(np.concatenate([np.floor(place), np.ceil(place)])).astype(int):
        part = h[:, c]
        filters = spectrum * part / (1.0 + spectrum * (part * part).sum(axis=0))
        near = np.maximum(1.0 - np.abs(place - c), 0.0)
        out += near * transform.sum(filters)[inner]
    weight = 1.0 / variances.mean(axis=(1, 2))
    mean = float((images.mean(axis=(1, 2)) * weight).sum() / weight.sum())
    return out * math.sqrt(float(local.mean())) + mean
