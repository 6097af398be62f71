r"""Point samples of the light of microscopes with aberrations, and their means over discs, with error bounds.

Light with aberrations has too many azimuthal orders for :mod:`lommel.methods.layers.scanning`. A mean over a disc of
radius s multiplies the transfer function by

.. math:: \frac1\pi \iint e^{i s (w_x x + w_y y)} dx\, dy
    \approx \frac{2}{N + 1} \sum_i \sin^2 a_i \cos(s\, w_x \cos a_i)\, \mathrm{sinc}(s\, w_y \sin a_i),
    \quad a_i = \frac{i \pi}{N + 1} ,

the sum over N chords of :class:`lommel.methods.ChordalGauss`. For ``abs(w) <= 2`` and every b > 0 its error is at
most ``(1 + exp(-4 b)) exp(2 s sinh(b) - 2 N b) / (1 - exp(-2 (N + 1) b))``. The cosine and the sinc are responses of
filters of columns and rows.

References
----------
L. N. Trefethen, *Approximation Theory and Approximation Practice* (SIAM, 2013), theorem 8.2.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Samples, Wanted
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
# disc"). An intensity between 0 and 1 with spatial frequencies up to 2 (in v) differs from a constant by at most 1/2,
# and at complex positions ``x + i y`` by at most ``exp(2 abs(y)) / 2`` (Plancherel and Polya). This bounds three
# errors, for every eta > 0 and ``rho = exp(eta)``:
# - mean over a circle of radius s from m points: ``exp(2 s sinh eta) / (exp(m eta) - 1)``,
# - mean over radii up to a from n Gauss points in the squared radius, with ``abs(Im sqrt(t)) <= sinh(eta / 2)`` on
#   Bernstein's ellipse around [0, 1]: ``2 exp(2 a sinh(eta / 2)) rho^(1 - 2 n) / (rho - 1)``,
# - interpolation in an equally spaced table of step h by polynomials of degree 11, by Bernstein's inequality:
#   ``(2 h)^12 max(abs(omega)) / (2 * 12!)``.
#
# For light ``sum_m F_m(r) exp(i m phi)`` each order m is treated separately. A disc is symmetric about the line from
# the axis to its centre; the mean of an order over the disc is therefore of the same order. Along a line through the
# axis, F_m extends to negative radii by ``F_m(-r) = (-1)^m F_m(r)``. The sum over the orders equals the same rule
# applied to the whole light, for which the bounds are proven.

HALF = 6  # half the number of points of an interpolation
_OMEGA = math.prod(k + 0.5 for k in range(HALF)) ** 2 / math.factorial(2 * HALF)
_DENOMINATORS = np.array([math.prod(k - j for j in range(2 * HALF) if j != k) for k in range(2 * HALF)], np.float64)
_MAX_STEP = 0.5  # largest step of a table in v
ETA = np.geomspace(0.02, 12.0, 96)  # logarithms of the parameters of Bernstein's ellipses; each one gives a bound
_DISC_ROUNDING = 2.0**-46  # rounding error of sums of some thousand products, with a sum of weights of a few units


Values = NDArray[np.float64] | NDArray[np.complex128]  # values of azimuthal orders; real if there is only order 0


class DiscMeans(NamedTuple):
    """Radii at which an intensity is needed, and weights from intensities at these radii to means over discs."""

    places: Array  # the radii, rising v
    weights: tuple[csr_array, ...]  # for each m >= 0, a sparse matrix (places, means) for the orders m and -m
    gain: float  # largest factor by which means multiply errors of the values
    error: float  # bound on the error of the means, relative to the unaberrated peak

    def of(self, values: Values) -> Values:
        """Return the means of orders -M to M, ``(n, 2 M + 1, means)``, from values ``(n, 2 M + 1, places)``."""
        middle = values.shape[1] // 2
        means = [values[:, middle + m] @ self.weights[abs(m)] for m in range(-middle, middle + 1)]
        return np.stack(means, axis=1)


def disc_means(v: Array, radius: float, error: float, order: int = 0) -> DiscMeans:
    """Return the rule for means of an intensity over discs of `radius`, centred at distances `v` from the axis."""
    # The table, the circles and the radii each use a third of the error: certificate, "Means over a disc".
    step = table_step(error / 3.0)
    (x, y), w = _points(radius, error / 1.5)
    x_distance = v[:, None] + x
    start, node_weights = between(np.hypot(x_distance, y) / step)
    row = start[..., None] + np.arange(2 * HALF)
    index = np.abs(row)
    is_used = np.zeros(index.max(initial=0) + 1, np.bool_)
    is_used[index] = True
    indices, column_of_use = np.flatnonzero(is_used), np.cumsum(is_used)[index] - 1
    column = np.broadcast_to(np.arange(v.size)[:, None, None], row.shape).ravel()
    data, shape, matrices = w[:, None] * node_weights, (indices.size, v.size), []
    for m in range(order + 1):
        factor = np.cos(m * np.arctan2(y, x_distance))[..., None] * np.where(row < 0, (-1.0) ** m, 1.0) if m else 1.0
        matrices.append(
            scipy.sparse.coo_array(((data * factor).ravel(), (column_of_use.ravel(), column)), shape=shape).tocsr()
        )
    gain = float((w * np.abs(node_weights).sum(axis=-1)).sum(axis=-1).max(initial=1.0))
    return DiscMeans(np.asarray(step * indices), tuple(matrices), gain, error + _DISC_ROUNDING)


def table_step(error: float) -> float:
    """Return the largest table step for which the interpolation error of :func:`between` is at most `error`."""
    return float(min(_MAX_STEP, 0.5 * (2.0 * error / _OMEGA) ** (0.5 / HALF)))


def growth() -> float:
    """Return the largest factor by which :func:`between` multiplies errors of table values; it is reached midway."""
    return float(np.abs(between(np.array([0.5]))[1]).sum())


def between(positions: Array) -> tuple[NDArray[np.int64], Array]:
    """Return the interpolation at `positions` (in steps) of a table: the first of 12 indices, and 12 weights."""
    lower = np.floor(positions).astype(np.int64)
    distance = (positions - lower)[..., None] - np.arange(1 - HALF, HALF + 1)
    weights = np.ones(distance.shape)
    weights[..., 1:] = np.cumprod(distance[..., :-1], axis=-1)
    weights[..., :-1] *= np.cumprod(distance[..., :0:-1], axis=-1)[..., ::-1]
    return lower + (1 - HALF), weights / _DENOMINATORS


def _points(radius: float, error: float) -> tuple[Array, Array]:
    """Return points (x, y) of half a disc, shape (2, points), and weights of a mean with this error at most."""
    angles, radii = 2, 1
    while _circle_error(radius, angles) > 0.5 * error:
        angles += 2
    while gauss_error(2.0 * radius * np.sinh(0.5 * ETA) - math.log(2.0), radii) > 0.5 * error:
        radii += 1
    # Gauss rule in the squared radius, to which the area is proportional.
    t, w = gauss_legendre(radii)
    theta = math.pi * (2 * np.arange(angles // 2) + 1) / angles
    r = radius * np.sqrt(t)[:, None]
    points = np.stack([r * np.cos(theta), r * np.sin(theta)]).reshape(2, -1)
    return points, np.repeat(w * (2.0 / angles), angles // 2)


def _circle_error(radius: float, angles: int) -> float:
    with np.errstate(over="ignore"):
        return float((np.exp(2.0 * radius * np.sinh(ETA) - angles * ETA) / -np.expm1(-angles * ETA)).min())


def gauss_error(growth: Array, nodes: int) -> float:
    """Bound the error of a mean by a Gauss rule, for a function of modulus at most exp(`growth`) on the ellipses."""
    with np.errstate(over="ignore"):
        return float((4.0 * np.exp(growth - (2 * nodes - 1) * ETA) / np.expm1(ETA)).min())


_LEAST = 1e-12  # smallest tolerance of methods
_ROUNDING = 2.0**-50


class SampledLight(NamedTuple):
    """Intensity of some planes at the centres of pixels."""

    values: Array  # (n, height, width)
    error: Array  # (n,), absolute bound

    @property
    def largest(self) -> Array:
        """Largest value of each plane."""
        return np.asarray(np.abs(self.values).max(axis=(1, 2)))

    def times(self, other: SampledLight | Array) -> SampledLight:
        """Return the product with other light, or with a factor of each plane."""
        if isinstance(other, np.ndarray):
            return SampledLight(self.values * other[:, None, None], self.error * np.abs(other))
        bounds = self.largest, other.largest
        error = self.error * bounds[1] + other.error * (bounds[0] + self.error) + _ROUNDING * bounds[0] * bounds[1]
        return SampledLight(self.values * other.values, error)


def light_samples(pupil: ObjectivePupil, grid: Grid, fraction: float, threads: int = 0) -> SampledLight:
    """Return the intensity of a pupil, for unit collected light in each plane, to `fraction` of the peak."""
    tol = max(fraction, _LEAST)

    def compute(method: Method) -> Samples:
        return method.images(pupil, grid, Wanted(1.0, np.dtype(np.float64), threads=threads))

    images = first_within_tolerance(candidates(pupil, grid, tol), compute)[1]
    # A phase error changes a field by at most the same amount; section 6 bounds the change of the intensity.
    omitted = pupil.left_out[0]
    error = images.bound * images.brightest + omitted * (2.0 * np.sqrt(images.brightest) + omitted)
    return SampledLight(images.values.reshape(-1, *grid.shape), np.broadcast_to(error, (math.prod(pupil.shape),)))


class DiscFilter(NamedTuple):
    """Pairs of a row filter and a column filter, all of equal length; their sum computes means over discs."""

    parts: tuple[tuple[Taps, Taps], ...]
    error: float  # bound on the error of the response
    gain: float  # largest factor by which errors of samples grow

    @property
    def taps(self) -> Taps:
        """One of the filters: all filters need the same samples."""
        return self.parts[0][0]

    def samples(self, grid: Grid) -> Grid:
        """Return the grid of samples for means around pixel centres."""
        return sample_grid(grid, self.taps)

    def of(self, light: SampledLight, threads: int = 0) -> SampledLight:
        """Return means of samples of an intensity; the integral of the modulus of its OTF must be at most 1."""
        total = sum((filter_axes(light.values, rows, columns, threads) for rows, columns in self.parts), np.zeros(()))
        rounding = (4.0 * self.taps.weights.size + len(self.parts) + 16.0) * 2.0**-53 * light.largest
        return SampledLight(np.asarray(total), self.error + self.gain * (light.error + rounding))


@lru_cache(maxsize=64)
def disc_filter(step: float, radius: float, error: float, least: int = 0) -> DiscFilter:
    """Return the filter, to `error`, for means over discs of `radius` around pixels of pitch `step` (both in v).

    The filter has at least `least` weights on either side. Raises Declined if it needs too many chords.
    """
    chords = chords_for(radius, 0.5 * error)
    # The sample density is that of averages over pixels: section 10.
    stride = samples_across(step)
    h, filter_error = step / stride, error / 8.0
    angles = np.pi / (chords + 1) * np.arange(1, chords // 2 + 1)
    responses: list[tuple[float, Array, Array, float, float]] = []
    side = max(least, stride // 2 + 2, math.ceil(radius / h) + 2)
    for angle in angles:
        x_length, y_length = radius * math.cos(angle), radius * math.sin(angle)
        weight = 4.0 / (chords + 1) * math.sin(angle) ** 2
        columns, fit_error, gain = _response(side, h, filter_error, x_length, mean=False)
        rows, row_error, row_gain = _response(side, h, filter_error, y_length, mean=True)
        responses.append((weight, rows, columns, row_error * (1.0 + fit_error) + fit_error, gain * row_gain))
        side = max(side, rows.size, columns.size)
    size = max(max(rows.size, columns.size) for _, rows, columns, _, _ in responses)

    def taps(weights: Array, factor: float) -> Taps:
        padded = np.pad(factor * weights, (0, size - weights.size))
        return Taps(stride, np.concatenate([padded[:0:-1], padded]), 0.0, 1.0)

    parts = tuple((taps(rows, weight), taps(columns, 1.0)) for weight, rows, columns, _, _ in responses)
    total = 0.5 * error + sum(weight * fit_error for weight, _, _, fit_error, _ in responses)
    return DiscFilter(parts, total, sum(weight * gain for weight, _, _, _, gain in responses))


def _response(side: int, h: float, error: float, length: float, *, mean: bool) -> tuple[Array, float, float]:
    """Return the weights of a symmetric filter, from the centre outward, its error and its gain.

    The response is ``cos(length w)``, or its mean over lengths from 0 to `length` if `mean`.
    """
    longest = side + 60
    while True:
        weights, fit_error, gain = fit_taps(
            lambda w: np.sinc(length / math.pi * w) if mean else np.cos(length * w),
            np.cos,
            h * np.arange(side + 1),
        )
        if fit_error <= error or side >= longest:
            return weights, fit_error, gain
        side += max(2, side // 16)
