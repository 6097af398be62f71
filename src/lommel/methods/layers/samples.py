r"""Light of microscopes with aberrations at the centres of pixels, and its means over discs, with error bounds.

Such light has too many orders of the azimuth for :mod:`lommel.methods.layers.scanning`. Its mean over a disc
multiplies the transfer function by

.. math:: \frac1\pi \iint e^{i s (w_x x + w_y y)} dx\, dy
    \approx \frac{2}{N + 1} \sum_i \sin^2 a_i \cos(s\, w_x \cos a_i)\, \mathrm{sinc}(s\, w_y \sin a_i),
    \quad a_i = \frac{i \pi}{N + 1} ,

the sum over chords of :class:`lommel.ChordalGauss`, within ``(1 + exp(-4 b)) exp(2 s sinh(b) - 2 N b)`` over ``1 -
exp(-2 (N + 1) b)`` for ``abs(w) <= 2`` and every b > 0. Each factor is the response of a filter of samples.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Declined, Images, Wanted
from lommel.methods.choice import candidates, first_proven
from lommel.methods.method import Method
from lommel.methods.pixels.averaging import Taps, finer, fitted, samples_across, weighed
from lommel.optics.grid import Grid
from lommel.optics.layers.objective_pupil import ObjectivePupil

_B = np.geomspace(0.02, 6.0, 96)
_CHORDS_MOST = 200
_LEAST = 1e-12  # of methods
_ROUNDING = 2.0**-50


class Samples(NamedTuple):
    """Light of some planes at the centres of pixels."""

    values: Array  # (n, height, width)
    error: Array  # (n,), absolute bound

    @property
    def most(self) -> Array:
        """The largest value of each plane."""
        return np.asarray(np.abs(self.values).max(axis=(1, 2)))

    def times(self, other: Samples | Array) -> Samples:
        """Return the product with other light, or with a factor of each plane."""
        if isinstance(other, np.ndarray):
            return Samples(self.values * other[:, None, None], self.error * np.abs(other))
        sizes = self.most, other.most
        error = self.error * sizes[1] + other.error * (sizes[0] + self.error) + _ROUNDING * sizes[0] * sizes[1]
        return Samples(self.values * other.values, error)


def light_samples(pupil: ObjectivePupil, grid: Grid, asked: float, threads: int = 0) -> Samples:
    """Return the intensity of a pupil, relative to the light collected in each plane; off by `asked` of its peak."""
    tol = max(asked, _LEAST)

    def ask(way: Method) -> Images:
        return way.images(pupil, grid, Wanted(1.0, np.dtype(np.float64), threads=threads))

    made = first_proven(candidates(pupil, grid, tol), ask)[1]
    left = pupil.left_out[0]
    off = made.bound * made.brightest + left * (2.0 * np.sqrt(made.brightest) + left)
    return Samples(made.values.reshape(-1, *grid.shape), np.broadcast_to(off, (math.prod(pupil.shape),)))


class DiscFilter(NamedTuple):
    """Filters of rows and of columns whose results sum to means over discs, of as many weights each."""

    parts: tuple[tuple[Taps, Taps], ...]
    error: float  # of the response
    gain: float  # what it multiplies errors of samples by

    @property
    def taps(self) -> Taps:
        """One that has the samples of all."""
        return self.parts[0][0]

    def samples(self, grid: Grid) -> Grid:
        """Return the samples that means around the centres of pixels take."""
        return finer(grid, self.taps)

    def of(self, given: Samples, threads: int = 0) -> Samples:
        """Return means of samples of light, whose transfer function has a modulus of integral 1 at most."""
        total = sum((weighed(given.values, rows, columns, threads) for rows, columns in self.parts), np.zeros(()))
        rounded = (4.0 * self.taps.weights.size + len(self.parts) + 16.0) * 2.0**-53 * given.most
        return Samples(np.asarray(total), self.error + self.gain * (given.error + rounded))


@lru_cache(maxsize=64)
def disc_filter(step: float, radius: float, error: float, least: int = 0) -> DiscFilter:
    """Return the filter for means over discs of a `radius` around pixels of pitch `step`, in v, off by `error`.

    With `least` weights on either side at the least. Declined where it would take too many chords.
    """
    chords = chords_for(radius, 0.5 * error)
    stride = samples_across(step)
    h, each = step / stride, error / 8.0
    angles = np.pi / (chords + 1) * np.arange(1, chords // 2 + 1)
    found: list[tuple[float, Array, Array, float, float]] = []
    half = max(least, stride // 2 + 2, math.ceil(radius / h) + 2)
    for angle in angles:
        across, along = radius * math.cos(angle), radius * math.sin(angle)
        weight = 4.0 / (chords + 1) * math.sin(angle) ** 2
        columns, off, gain = _response(half, h, each, across, mean=False)
        rows, off_rows, gain_rows = _response(half, h, each, along, mean=True)
        found.append((weight, rows, columns, off_rows * (1.0 + off) + off, gain * gain_rows))
        half = max(half, rows.size, columns.size)
    size = max(max(rows.size, columns.size) for _, rows, columns, _, _ in found)

    def taps(weights: Array, factor: float) -> Taps:
        padded = np.pad(factor * weights, (0, size - weights.size))
        return Taps(stride, np.concatenate([padded[:0:-1], padded]), 0.0, 1.0)

    parts = tuple((taps(rows, weight), taps(columns, 1.0)) for weight, rows, columns, _, _ in found)
    total = 0.5 * error + sum(weight * off for weight, _, _, off, _ in found)
    return DiscFilter(parts, total, sum(weight * gain for weight, _, _, _, gain in found))


def _response(half: int, h: float, error: float, length: float, *, mean: bool) -> tuple[Array, float, float]:
    """Return weights from the middle on whose response is ``cos(length w)``, or its mean over smaller lengths."""
    most = half + 60
    while True:
        weights, off, gain = fitted(
            lambda w: np.sinc(length / math.pi * w) if mean else np.cos(length * w), np.cos, h * np.arange(half + 1)
        )
        if off <= error or half >= most:
            return weights, off, gain
        half += max(2, half // 16)


def chords_for(radius: float, error: float) -> int:
    """Return an even number of chords of a disc that sums over these need to err by `error` at most."""
    for chords in range(2, _CHORDS_MOST + 1, 2):
        if chord_error(radius, chords) <= error:
            return chords
    raise Declined(
        "with aberrations means are over discs of 15 Airy units at most; ask for a smaller pinhole or bead"
    )


def chord_error(radius: float, chords: int) -> float:
    """Bound the error of the response of a sum over chords of a disc."""
    grown = np.exp(np.minimum(2.0 * radius * np.sinh(_B) - 2.0 * chords * _B, 600.0))
    return float(((1.0 + np.exp(-4.0 * _B)) * grown / -np.expm1(-2.0 * (chords + 1) * _B)).min())
