"""Depth from defocus by maximum likelihood: the cost of each candidate depth in each window, by tiles."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.estimation.pixel_transfer import half_window, multiplicity, squared_frequency
from lommel.optics.lens import Lens

# Powers of texture that weights are made for, over that of the tile; a factor of ten more or less costs little. Less
# than there is, for filters then end sooner, and so do the errors where the depth changes.
_LEVELS = (0.1, 0.005)
_BETWEEN = 0.03  # power over that of the tile below which a window is served by the second level
_COARSE = 4  # candidates from one at which the texture is measured to the next
_FEW = 0.01  # share of a tile below which the first level serves whatever the texture
_PART = 64  # pixels down or across whose windows are computed by one product
_SURE = 4.0  # standard deviations of the energy of noise above which there is texture


# Photographs y_i of one texture x are y_i = h_i(u) x + n_i at each frequency, h_i the transfer function at the
# vergence u = 1 / depth, n_i noise. Whatever x is, at the right u what is orthogonal to h in the vector y is noise:
# of two photographs, (h_2 y_1 - h_1 y_2) / sqrt(h_1^2 + h_2^2). Its energy within a window, less that of noise, is
# least there on average, of every texture, and half of it is minus the logarithm of the likelihood. Frequencies that
# noise hides get the weight S |h|^2 / (1 + S |h|^2), S the power of texture over that of noise, which makes the
# least variance: a wrong S makes the answer less exact, not wrong.
class Transform:
    """Several images of one channel at the frequencies of their transfer functions, in both halves."""

    def __init__(self, images: Values) -> None:
        from scipy.fft import rfft2

        made = rfft2(images.astype(np.float32, copy=False))
        rows = np.arange(images.shape[1] // 2 + 1)
        self.shape: tuple[int, int] = images.shape[1:]
        # Of shape (images, height // 2 + 1, width // 2 + 1), at rising frequencies down, and at falling ones.
        self.top, self.bottom = made[:, rows], made[:, -rows]

    def sum(self, filters: Values) -> NDArray[np.float32]:
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

    def level(self, transfers: Values) -> float:
        """Return the power S of texture over that of noise at 1 cycle a pixel, of a spectrum ``S / f^2``."""
        times, square = multiplicity(self.shape), squared_frequency(self.shape)
        square[0, 0] = np.inf
        size = self.shape[0] * self.shape[1]

        def excess(log_level: float, hh: Values, power: Values) -> float:
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


def residuals(h: Values) -> Iterator[Values]:
    """Yield filters, unit vectors orthogonal to the transfer functions and to one another, by Givens rotations."""
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


class Weights:
    """Gaussian windows of an rms width, as products with narrow matrices on either side.

    They end after five of that width, and with the tile.
    """

    def __init__(self, sides: tuple[int, int], margin: int, core: tuple[int, int], window: float) -> None:
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

        # Which pixels, with margins, a part of the tile is made of, and how much of each; rows sum to 1.
        self._down, self._across = (matrices(*side) for side in zip(sides, core, strict=True))

    def __call__(self, image: Values) -> NDArray[np.float32]:
        """Return the weighted mean round each pixel that the tile answers for."""
        rows = np.concatenate([matrix @ image[taken] for taken, matrix in self._down])
        return np.concatenate([rows[:, taken] @ matrix.T for taken, matrix in self._across], axis=1)


def whitened(images: Values, variances: Values, transfers: Values) -> tuple[Transform, Values, Values]:
    """Return images and transfer functions over the noise of each image, and the map of the noise."""
    ratio = variances.mean(axis=(1, 2))
    ratio = ratio / ratio.mean()
    local = (variances / ratio[:, None, None]).mean(axis=0)
    scale = 1.0 / np.sqrt(ratio * local.mean())
    transform = Transform((images - images.mean(axis=(1, 2), keepdims=True)) * scale[:, None, None])
    return transform, transfers * (1.0 / np.sqrt(ratio)).astype(np.float32)[:, None, None, None], local


class Costs:
    """The costs of all candidates in one channel of a tile, by the weights for each level of texture."""

    def __init__(self, images: Values, variances: Values, valid: Values, transfers: Values, weigh: Weights) -> None:
        self._images, h, local = whitened(images, variances, transfers)
        self._trust = (valid * (float(local.mean()) / local)).astype(np.float32)
        self._weigh, self.coverage = weigh, np.maximum(weigh(valid), 1e-6)
        self.power = self._images.level(h)
        self._times = multiplicity(self._images.shape).astype(np.float32)
        square = squared_frequency(self._images.shape).astype(np.float32)
        square[0, 0] = np.inf
        count = h.shape[1]
        self._h, self._slopes, self._spectrum = h, np.gradient(h, axis=1), self.power / square
        # Of each level and candidate: the energy of noise, and the variance of a cost by noise for one independent
        # pixel. And for texture as strong as that of the tile the second derivative of the cost by the candidate, the
        # variance of the first for one independent pixel, and the part of that by noise, which is always there.
        self.known, self.spread, self.curvature, self.by_texture, self.by_noise = np.empty((5, len(_LEVELS), count))
        self._of_texture = np.empty((3, len(_LEVELS), -(-count // _COARSE)))
        self.values: list[NDArray[np.float32]] = []  # of each level half of the energy left, less that of noise
        self._textures: list[NDArray[np.float32]] = []
        self._level()

    def _level(self) -> None:
        """Compute all candidates by the weights of the next level."""
        k, count = len(self.values), self._h.shape[1]
        self.values.append(np.empty((count, *self.coverage.shape), dtype=np.float32))
        self._textures.append(np.empty((self._of_texture.shape[2], *self.coverage.shape), dtype=np.float32))
        for c, (h, slope) in enumerate(zip(self._h.swapaxes(0, 1), self._slopes.swapaxes(0, 1), strict=True)):
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

    def _mean(self, values: Values) -> float:
        """Return the mean over all frequencies."""
        return float(np.vdot(self._times, values))

    def _energy(self, filters: Values) -> Values:
        """Return the energy of the sum of the images through filters, over that of white noise, in each window."""
        values = self._images.sum(filters)
        values *= values
        values *= self._trust
        return np.asarray(self._weigh(values) / self.coverage)

    def choose(self, at: NDArray[np.int64], independent: Values) -> NDArray[np.int64]:
        """Return the level that serves each pixel, and compute its costs; the second level not for few pixels."""
        weak = self._texture(0, at, 1.0, independent)[0] < _BETWEEN
        if weak.mean() < _FEW:
            return np.zeros(at.shape, dtype=np.int64)
        self._level()
        return weak.astype(np.int64)

    def texture(
        self, at: NDArray[np.int64], level: NDArray[np.int64], misfit: Values, independent: Values
    ) -> tuple[Values, NDArray[np.bool_]]:
        """Return the power of the texture over that of the tile, and where it exceeds noise."""
        found = [self._texture(k, at, misfit, independent) for k in range(len(self.values))]
        power, sure = (np.choose(level, each) for each in zip(*found, strict=True))
        return power, sure

    def _texture(
        self, k: int, at: NDArray[np.int64], misfit: Values | float, independent: Values
    ) -> tuple[Values, NDArray[np.bool_]]:
        """Return power and certainty by the weights of one level."""
        place = np.minimum((at + _COARSE // 2) // _COARSE, len(self._textures[k]) - 1)
        noise, signal, spread = (each[place] for each in self._of_texture[:, k])
        energy = np.take_along_axis(self._textures[k], place[None], axis=0)[0]
        mean = misfit * noise
        # The quantile of chi squared, by Wilson and Hilferty.
        part = 2.0 / 9.0 * spread / (noise**2 * independent)
        return np.maximum(energy - mean, 0.0) / signal, energy > mean * (1.0 - part + _SURE * np.sqrt(part)) ** 3

    def of_level(self, level: NDArray[np.int64]) -> Values:
        """Return the costs, shape (candidates, height, width), each pixel's by the weights of its level."""
        return self.values[0] if len(self.values) == 1 else np.where(level, self.values[1], self.values[0])


_STENCIL = 7  # candidates that the polynomial goes through whose minimum is sought
_DROP = 9.0  # depth is known where the best candidate is better than the mean by so much of a log-likelihood
_SURE_OF_BEST = 3.0  # and by so many standard deviations of the noise of a cost
_CLEAR = 100.0  # from so much on there is no doubt of a minimum
_NOISIER = 2.0  # more than this is no noise stated too low, but depth that changes, or edges


class Found(NamedTuple):
    """The depth of a tile, each array of shape (height, width)."""

    position: Values  # of the least cost among the candidates; NaN at either end, where there is none
    variance: Values  # of the position, in candidates squared; infinite where nothing is known
    misfit: Values  # energy left over that of noise, 1 where the model holds
    level: Values  # power of the texture at 1 cycle a pixel over that of noise


def _least(cost: Values) -> NDArray[np.int64]:
    """Return the place of the least along the first axis, as argmin does ten times as slowly."""
    at, least = np.zeros(cost.shape[1:], dtype=np.int64), cost[0].copy()
    for c, one in enumerate(cost[1:], 1):
        less = one < least
        at[less] = c
        np.minimum(least, one, out=least)
    return at


def _spread(cost: Values, at: NDArray[np.int64], independent: Values) -> Values:
    """Return the mean square distance from the least candidate and its neighbours, weighted by likelihood."""
    least = np.take_along_axis(cost, at[None], axis=0)[0]
    scale = independent.astype(np.float32)
    total, moment = np.zeros((2, *at.shape), dtype=np.float32)
    for c, one in enumerate(cost):
        chance = np.exp((least - one) * scale)
        total += chance
        moment += chance * (np.maximum(np.abs(at - c) - 1, 0) ** 2).astype(np.float32)
    return np.asarray(moment / total)


def _minimum(cost: Values, at: NDArray[np.int64]) -> tuple[Values, Values, Values]:
    """Return place, curvature and value of the minimum next to the least candidate, by a polynomial through seven."""
    start = np.clip(at - _STENCIL // 2, 0, len(cost) - _STENCIL)
    index = start + np.arange(_STENCIL).reshape(-1, *([1] * at.ndim))
    values = np.take_along_axis(cost, index, axis=0).astype(np.float64)
    nodes = np.arange(_STENCIL) - _STENCIL // 2
    inverse = np.linalg.inv(np.vander(nodes, increasing=True).astype(np.float64))
    terms = np.tensordot(inverse, values, axes=1)
    middle = (at - start - _STENCIL // 2).astype(np.float64)
    x = middle.copy()

    def derivative(order: int) -> Values:
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


_CORE = 256  # most that a tile answers for, pixels a side
_LEAST_MARGIN = 24

Window = tuple[slice, slice]
Places = tuple[NDArray[np.int64], ...]
Transfer = Callable[[Lens, Array, Sequence[tuple[float, float]], float, tuple[int, int], int], NDArray[np.float32]]


class Exposures(NamedTuple):
    """Several photographs of one scene, as electrons."""

    images: NDArray[np.float32]  # (channels, photographs, height, width): over the relative exposure of each
    variances: NDArray[np.float32]  # of the noise of each pixel, from the light around it
    valid: NDArray[np.bool_]  # pixels known in all photographs and channels
    exposures: tuple[float, ...]  # light of each photograph over that of the first


class Tiling:
    """Photographs cut into tiles, with the transfer functions of all lenses at all candidates in all channels."""

    def __init__(
        self,
        exposed: Exposures,
        lenses: Sequence[Lens],
        distances: Array,
        spectra: Sequence[Sequence[tuple[float, float]]],
        pixel: float,
        window: float,
        transfer: Transfer,
    ) -> None:
        from scipy.fft import next_fast_len
        from scipy.ndimage import distance_transform_edt

        blur = max(float(lens.pupil(distances).geometric_radius().max()) for lens in lenses) / pixel
        half, margin = half_window(lenses, distances, pixel), max(_LEAST_MARGIN, math.ceil(2.0 * blur + 3.0 * window))
        # The pixels that a tile answers for, and those of its transforms, which have margins.
        height, width = (math.ceil(side / math.ceil(side / _CORE)) for side in exposed.valid.shape)
        rows, columns = (next_fast_len(max(side + 2 * margin, 2 * half + 1), real=True) for side in (height, width))
        self._window, self._margin, self._core, self._sides = window, margin, (height, width), (rows, columns)
        self._weigh = Weights(self._sides, margin, self._core, window)

        @cache
        def transfers(spectrum: tuple[tuple[float, float], ...]) -> NDArray[np.float32]:
            return np.stack([transfer(lens, distances, spectrum, pixel, self._sides, half) for lens in lenses])

        self._transfers = [transfers(tuple(spectrum)) for spectrum in spectra]
        self._shape = exposed.valid.shape
        around = [
            (margin, (whole - 1) // core * core + side - margin - whole)
            for whole, core, side in zip(self._shape, self._core, self._sides, strict=True)
        ]
        self._images, self._variances = (
            np.pad(part, [(0, 0), (0, 0), *around], mode="symmetric") for part in (exposed.images, exposed.variances)
        )
        # 1 where pixels are of the image rather than mirrored, and where they are known as far as light is spread.
        known = exposed.valid if exposed.valid.all() else distance_transform_edt(exposed.valid) > blur + 1.0
        self._own, self._trusted = (np.pad(part.astype(np.float32), around) for part in (np.ones(self._shape), known))

    def search(self, progress: Callable[[int, int], object] | None = None) -> Found:
        """Return the depth of all tiles."""
        out = Found(*(np.empty(self._shape, dtype=np.float64) for _ in Found._fields))
        tiles = list(self._tiles())
        for done, (inside, at) in enumerate(tiles, 1):
            for whole, part in zip(out, self._found(at), strict=True):
                height, width = whole[inside].shape
                whole[inside] = part[:height, :width]
            if progress is not None:
                progress(done, len(tiles))
        return out

    def _found(self, at: Places) -> Found:
        """Return the depth of each pixel that a tile answers for."""
        channels = [
            Costs(images, variances, self._trusted[at], transfer, self._weigh)
            for images, variances, transfer in self._channels(at)
        ]
        share = channels[0].coverage
        independent = 4.0 * np.pi * self._window**2 * share
        levels = [one.choose(_least(one.values[0]), independent) for one in channels]
        parts = [one.of_level(level) for one, level in zip(channels, levels, strict=True)]
        cost = parts[0] if len(parts) == 1 else np.sum(parts, axis=0)
        best = _least(cost)
        position, curvature, least = _minimum(cost, best)
        noise = sum(one.known[level, best] for one, level in zip(channels, levels, strict=True))
        misfit = np.maximum(1.0 + 2.0 * least / np.maximum(noise, 1e-30), 0.0)
        worse = np.maximum(misfit, 1.0)
        # How much better the best candidate is than the mean of all, as the logarithm of a likelihood.
        drop = (cost.mean(axis=0) - least) * independent / worse
        clear = drop > _CLEAR
        sure = clear.copy()
        slope, expected, power = np.zeros((3, *best.shape))
        steepest = sum(one.curvature[level, best] for one, level in zip(channels, levels, strict=True))
        for one, level in zip(channels, levels, strict=True):
            texture, more = one.texture(best, level, np.minimum(worse, _NOISIER), independent)
            # Where the minimum is clear its curvature is the better estimate of the texture.
            texture = np.where(clear, np.maximum(curvature / steepest, 0.0), texture)
            sure |= more
            expected += texture * one.curvature[level, best]
            slope += texture * one.by_texture[level, best] + one.by_noise[level, best]
            power += texture * one.power / len(channels)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            variance = slope / (np.minimum(curvature, 2.0 * expected) ** 2 * independent) * worse**2
        # One narrow minimum among others that are nearly as low is chance.
        variance = np.maximum(variance, _spread(cost, best, independent / worse))
        chance = sum(one.spread[level, best] for one, level in zip(channels, levels, strict=True))
        enough = np.maximum(_DROP, _SURE_OF_BEST * np.sqrt(chance * independent))
        # Less than half of what a window has of the image is not to be believed.
        whole = share >= 0.5 * self._weigh(self._own[at])
        known = sure & whole & (curvature > 0.0) & np.isfinite(variance) & (drop >= enough)
        variance[~known] = np.inf
        outside = (best == 0) | (best == len(cost) - 1)
        variance[outside], position[outside] = np.inf, np.nan
        return Found(position, variance, misfit, power)

    def sharp(self, position: Array, level: float) -> Array:
        """Return the electrons of the scene in focus, (channels, height, width), at positions of candidates."""
        out = np.empty((len(self._transfers), *position.shape))
        square = squared_frequency(self._sides).astype(np.float32)
        square[0, 0] = np.inf
        spectrum, count = level / square, self._transfers[0].shape[1]
        for inside, at in self._tiles():
            place = np.clip(position[inside], 0.0, count - 1.0)
            rows, columns = (slice(self._margin, self._margin + side) for side in place.shape)
            for channel, (images, variances, transfers) in enumerate(self._channels(at)):
                transform, h, local = whitened(images, variances, transfers)
                made = np.zeros(place.shape)
                for c in np.unique(np.concatenate([np.floor(place), np.ceil(place)])).astype(int):
                    # Wiener's filter of one candidate.
                    filters = spectrum * h[:, c] / (1.0 + spectrum * (h[:, c] * h[:, c]).sum(axis=0))
                    made += np.maximum(1.0 - np.abs(place - c), 0.0) * transform.sum(filters)[rows, columns]
                weight = 1.0 / variances.mean(axis=(1, 2))
                mean = float((images.mean(axis=(1, 2)) * weight).sum() / weight.sum())
                out[channel][inside] = made * math.sqrt(float(local.mean())) + mean
        return out

    def _tiles(self) -> Iterator[tuple[Window, Places]]:
        """Yield where each tile answers, and the pixels of the mirrored photographs that it is made of."""
        (height, width), (rows, columns) = self._core, self._sides
        for top in range(0, self._shape[0], height):
            for left in range(0, self._shape[1], width):
                inside = slice(top, min(top + height, self._shape[0])), slice(left, min(left + width, self._shape[1]))
                yield inside, np.ogrid[top : top + rows, left : left + columns]

    def _channels(self, at: Places) -> Iterator[tuple[Values, Values, Values]]:
        """Yield the photographs of each channel in a tile, the variances of their noise, and transfer functions."""
        for images, variances, transfer in zip(self._images, self._variances, self._transfers, strict=True):
            yield images[:, *at], variances[:, *at], transfer
