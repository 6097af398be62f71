r"""Light of microscopes with aberrations at the centres of pixels, and its means over discs, with error bounds.

Such light has too many orders of the azimuth for :mod:`lommel.methods.layers.scanning`. Its mean over a disc
multiplies the transfer function by

.. math:: \frac1\pi \iint e^{i s (w_x x + w_y y)} dx\, dy
    \approx \frac{2}{N + 1} \sum_i \sin^2 a_i \cos(s\, w_x \cos a_i)\, \mathrm{sinc}(s\, w_y \sin a_i),
    \quad a_i = \frac{i \pi}{N + 1} ,

the sum over chords of :class:`lommel.ChordalGauss`, within ``(1 + exp(-4 b)) exp(2 s sinh(b) - 2 N b)`` over ``1 -
exp(-2 (N + 1) b)`` for ``abs(w) <= 2`` and every b > 0. Each factor is the response of a filter of samples.

References
----------
L. N. Trefethen, *Approximation Theory and Approximation Practice* (SIAM, 2013), theorem 8.2.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Images, Wanted
from lommel.methods.averaging import Taps, filter_axes, fit_taps, sample_grid, samples_across
from lommel.methods.choice import candidates, first_within_tolerance
from lommel.methods.layers.chordal_debye import chords_for
from lommel.methods.method import Method
from lommel.optics.grid import Grid
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.special.legendre import gauss_legendre

if TYPE_CHECKING:
    from scipy.sparse import csr_array

# Means of radial intensities over discs, from few samples, with a proven error bound (certificate, "Means over a
# disc"). An intensity between 0 and 1 whose spatial frequencies end at 2 (in v) is within 1/2 of a constant, and its
# continuation to complex places ``x + i y`` within ``exp(2 abs(y)) / 2`` of it (Plancherel and Polya). That bounds
# the mean over a circle by m points, ``exp(2 s sinh eta) / (exp(m eta) - 1)`` for every eta > 0; the mean over radii
# by n Gauss points in their squares, ``2 exp(2 a sinh(eta / 2)) rho^(1 - 2 n) / (rho - 1)`` with ``rho = exp(eta)``,
# since on Bernstein's ellipse around [0, 1] no imaginary part of ``sqrt(t)`` is above ``sinh(eta / 2)``; and values
# between those of an even table of step h, by polynomials of degree 11, ``(2 h)^12 max(abs(omega)) / (2 * 12!)``
# (Bernstein's inequality).
#
# Of light ``sum_m F_m(r) exp(i m phi)`` all three can be done to each order apart: a disc is its own mirror image at
# the line from the axis to its middle, so the mean of an order has that order, and along a line through the axis F_m
# at negative r is ``(-1)^m`` times that at positive r. What is done to the orders sums to the same rule done to the
# light itself, which the bounds are of.

HALF = 6  # half of the points that an interpolation takes
_OMEGA = math.prod(k + 0.5 for k in range(HALF)) ** 2 / math.factorial(2 * HALF)
_APART = np.array([math.prod(k - j for j in range(2 * HALF) if j != k) for k in range(2 * HALF)], np.float64)
_STEP_MOST = 0.5
ETA = np.geomspace(0.02, 12.0, 96)  # of Bernstein's ellipses, through ``cosh(eta)``, that bounds are looked for on
_DISC_ROUNDING = 2.0**-46  # of sums of at most some thousand products, whose weights sum to a few


Values = NDArray[np.float64] | NDArray[np.complex128]  # orders of the azimuth, real where the order 0 is alone


class DiscMeans(NamedTuple):
    """Radii where an intensity has to be known, and the weights of its means over discs."""

    places: Array  # rising v
    weights: tuple[csr_array, ...]  # sparse (places, radii), of the orders m and -m for each m
    gain: float  # factor by which errors of the values may grow
    error: float  # of the means, over the peak of the intensity without aberration

    def of(self, values: Values) -> Values:
        """Return the means of the orders -M to M, ``(n, 2 M + 1, radii)``, of ``(n, 2 M + 1, places)``."""
        middle = values.shape[1] // 2
        made = [values[:, middle + m] @ self.weights[abs(m)] for m in range(-middle, middle + 1)]
        return np.stack(made, axis=1)


def disc_means(v: Array, radius: float, error: float, order: int = 0) -> DiscMeans:
    """Return how to average an intensity over discs around points at radii `v`."""
    from scipy.sparse import coo_array

    # A third for the table, and a third each for circles and radii: certificate, "Means over a disc".
    step = table_step(error / 3.0)
    (x, y), w = _points(radius, error / 1.5)
    along = v[:, None] + x
    first, shares = between(np.hypot(along, y) / step)
    row = first[..., None] + np.arange(2 * HALF)
    away = np.abs(row)
    is_known = np.zeros(away.max(initial=0) + 1, np.bool_)
    is_known[away] = True
    known, place = np.flatnonzero(is_known), np.cumsum(is_known)[away] - 1
    column = np.broadcast_to(np.arange(v.size)[:, None, None], row.shape).ravel()
    data, shape, made = w[:, None] * shares, (known.size, v.size), []
    for m in range(order + 1):
        around = np.cos(m * np.arctan2(y, along))[..., None] * np.where(row < 0, (-1.0) ** m, 1.0) if m else 1.0
        made.append(coo_array(((data * around).ravel(), (place.ravel(), column)), shape=shape).tocsr())
    gain = float((w * np.abs(shares).sum(axis=-1)).sum(axis=-1).max(initial=1.0))
    return DiscMeans(np.asarray(step * known), tuple(made), gain, error + _DISC_ROUNDING)


def table_step(error: float) -> float:
    """Return how far apart even places may be for :func:`between` to err by `error`."""
    return float(min(_STEP_MOST, 0.5 * (2.0 * error / _OMEGA) ** (0.5 / HALF)))


def growth() -> float:
    """Return how much errors of even values may grow between them: it is most midway."""
    return float(np.abs(between(np.array([0.5]))[1]).sum())


def between(at: Array) -> tuple[NDArray[np.int64], Array]:
    """Return how values `at` any places are made of those at whole ones: the first of twelve, and their weights."""
    below = np.floor(at).astype(np.int64)
    away = (at - below)[..., None] - np.arange(1 - HALF, HALF + 1)
    weights = np.ones(away.shape)
    weights[..., 1:] = np.cumprod(away[..., :-1], axis=-1)
    weights[..., :-1] *= np.cumprod(away[..., :0:-1], axis=-1)[..., ::-1]
    return below + (1 - HALF), weights / _APART


def _points(radius: float, error: float) -> tuple[Array, Array]:
    """Return points (x, y) of half a disc, shape (2, points), and weights; their sum errs by at most `error`."""
    around, across = 2, 1
    while _circle_error(radius, around) > 0.5 * error:
        around += 2
    while gauss_error(2.0 * radius * np.sinh(0.5 * ETA) - math.log(2.0), across) > 0.5 * error:
        across += 1
    # In the squares of radii, which weighs by area.
    t, w = gauss_legendre(across)
    theta = math.pi * (2 * np.arange(around // 2) + 1) / around
    r = radius * np.sqrt(t)[:, None]
    points = np.stack([r * np.cos(theta), r * np.sin(theta)]).reshape(2, -1)
    return points, np.repeat(w * (2.0 / around), around // 2)


def _circle_error(radius: float, around: int) -> float:
    with np.errstate(over="ignore"):
        return float((np.exp(2.0 * radius * np.sinh(ETA) - around * ETA) / -np.expm1(-around * ETA)).min())


def gauss_error(growth: Array, nodes: int) -> float:
    """Bound the error of a mean by a Gauss rule of an analytic function."""
    with np.errstate(over="ignore"):
        return float((4.0 * np.exp(growth - (2 * nodes - 1) * ETA) / np.expm1(ETA)).min())


_LEAST = 1e-12  # of methods
_ROUNDING = 2.0**-50


class SampledLight(NamedTuple):
    """Light of some planes at the centres of pixels."""

    values: Array  # (n, height, width)
    error: Array  # (n,), absolute bound

    @property
    def most(self) -> Array:
        """Largest value of each plane."""
        return np.asarray(np.abs(self.values).max(axis=(1, 2)))

    def times(self, other: SampledLight | Array) -> SampledLight:
        """Return the product with other light, or with a factor of each plane."""
        if isinstance(other, np.ndarray):
            return SampledLight(self.values * other[:, None, None], self.error * np.abs(other))
        sizes = self.most, other.most
        error = self.error * sizes[1] + other.error * (sizes[0] + self.error) + _ROUNDING * sizes[0] * sizes[1]
        return SampledLight(self.values * other.values, error)


def light_samples(pupil: ObjectivePupil, grid: Grid, asked: float, threads: int = 0) -> SampledLight:
    """Return the intensity of a pupil over the light collected in each plane, off by `asked` of its peak."""
    tol = max(asked, _LEAST)

    def ask(way: Method) -> Images:
        return way.images(pupil, grid, Wanted(1.0, np.dtype(np.float64), threads=threads))

    made = first_within_tolerance(candidates(pupil, grid, tol), ask)[1]
    # A phase error changes a field by as much; the intensity follows as in section 6.
    left = pupil.left_out[0]
    off = made.bound * made.brightest + left * (2.0 * np.sqrt(made.brightest) + left)
    return SampledLight(made.values.reshape(-1, *grid.shape), np.broadcast_to(off, (math.prod(pupil.shape),)))


class DiscFilter(NamedTuple):
    """Pairs of filters of rows and columns, of equal length, whose results sum to means over discs."""

    parts: tuple[tuple[Taps, Taps], ...]
    error: float  # of the response
    gain: float  # factor of the errors of samples

    @property
    def taps(self) -> Taps:
        """A filter that needs the samples of all."""
        return self.parts[0][0]

    def samples(self, grid: Grid) -> Grid:
        """Return the grid of samples for means around pixel centres."""
        return sample_grid(grid, self.taps)

    def of(self, given: SampledLight, threads: int = 0) -> SampledLight:
        """Return means of samples of light whose transfer function has a modulus of integral at most 1."""
        total = sum((filter_axes(given.values, rows, columns, threads) for rows, columns in self.parts), np.zeros(()))
        rounded = (4.0 * self.taps.weights.size + len(self.parts) + 16.0) * 2.0**-53 * given.most
        return SampledLight(np.asarray(total), self.error + self.gain * (given.error + rounded))


@lru_cache(maxsize=64)
def disc_filter(step: float, radius: float, error: float, least: int = 0) -> DiscFilter:
    """Return the filter for means over discs of `radius` around pixels of pitch `step` (v), with error `error`.

    It has at least `least` weights on either side. Declined if it would take too many chords.
    """
    chords = chords_for(radius, 0.5 * error)
    # Samples as dense as for averages over pixels: section 10.
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
    """Return weights from the middle on with the response ``cos(length w)``, or its mean over smaller lengths."""
    most = half + 60
    while True:
        weights, off, gain = fit_taps(
            lambda w: np.sinc(length / math.pi * w) if mean else np.cos(length * w), np.cos, h * np.arange(half + 1)
        )
        if off <= error or half >= most:
            return weights, off, gain
        half += max(2, half // 16)
