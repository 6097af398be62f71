"""Interpolation of equally spaced, band-limited samples by Kaiser-Bessel kernels with proven error bounds.

A sum of waves ``a exp(i w x)``, ``abs(w) <= band``, is interpolated as the weighted sum of a few samples; the weights
("taps") are values of a kernel. Each wave must first be divided by the transform of the kernel at w: exactly for the
orders of a circle, otherwise approximately, by a filter of neighbouring samples. If the relative error of each wave
is at most eps, the error of the sum is at most eps times the sum of abs(a).
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array

MAX_TAPS, MAX_NEIGHBOURS = 16, 30  # largest number of taps, and of filter weights on each side of the middle
_DEGREE = 16  # degree of the polynomials that approximate taps
_TWO_PI = 2.0 * math.pi
_SQRT_2 = math.sqrt(2.0)
_CHECK_POINTS = 80  # number of Chebyshev points between two samples at which errors and gains are evaluated
# A polynomial of degree d is at most 1 / cos(pi d / 2n) times its largest modulus at n Chebyshev points: Ehlich and
# Zeller, Math. Z. 86, 41 (1964).
_BETWEEN_POINTS = 1.0 / math.cos(0.5 * math.pi * _DEGREE / _CHECK_POINTS)


class Taps(NamedTuple):
    """Interpolation kernel: an even number `size` of taps, each a polynomial of ``2 t - 1`` (highest power first).

    t from 0 to 1 is the position between the two middle samples. Columns of `polynomials` beyond `size` are zero.
    `gain` bounds the sum of the moduli of the taps, and `slope_gain` the same sum for their derivatives by t.
    """

    polynomials: Array
    size: int
    gain: float
    slope_gain: float

    def at(self, t: Array) -> Array:
        """Return the weights of the samples for positions t, shape ``(len(t), size)``."""
        return _evaluate(self.polynomials[::-1, : self.size], t)

    def slopes(self, t: Array) -> Array:
        """Return the derivatives of the weights by t, shape ``(len(t), size)``."""
        return _evaluate(np.asarray(2.0 * np.polynomial.polynomial.polyder(self.polynomials[::-1, : self.size])), t)

    def weighted(self, times: Array) -> float:
        """Return a bound, for all t, on the sum over the taps of ``abs(weight) * times``; `times` (size,)."""
        return _BETWEEN_POINTS * float((np.abs(self.at(_check_positions())) * times).sum(axis=1).max())

    @property
    def places(self) -> Array:
        """Positions of the samples of the taps, in steps."""
        return np.arange(1.0 - self.size // 2, self.size // 2 + 1)


class FilteredTaps(NamedTuple):
    """Taps to be applied after a symmetric `filter`, whose weights are given from the middle outwards.

    `error` bounds the error of ``exp(i w t)`` for w in the band. `gain` bounds the sum of the moduli of the combined
    weights of taps and filter. `slope_error` and `slope_gain` are these bounds for derivatives by t.
    """

    taps: Taps
    filter: Array
    error: float
    gain: float
    slope_error: float
    slope_gain: float


class CircularTaps(NamedTuple):
    """Taps around a circle, with the factor (`gains`) and the error bound of each order 0, 1, ..."""

    taps: Taps
    gains: Array
    errors: Array


@lru_cache(maxsize=64)
def filtered_taps(band: float, error: float, width: int = 0) -> FilteredTaps:
    """Return the fewest taps within `error` for a `band` below pi radians per step; ValueError if 16 do not suffice.

    If `width` is not 0, the taps interpolate averages over `width` steps instead of point values.
    """
    # Within 1e-17 the error is a polynomial of degree 40 in t and ``1.18 n band + 48`` in w, with n = taps + 2
    # neighbours + width. It is at most sqrt(2) times its maximum at twice as many Chebyshev points, for t and for w.
    # Sums of moduli are, for fixed signs, polynomials of degree 16: at most 1.06 times their maximum at 80 points.
    # Taps take time for every interpolated value, the filter only once. The number of taps is therefore minimized
    # first, with the largest filter, and then the number of neighbours in the filter.
    for count in range(4, MAX_TAPS + 1, 2):
        if _fit_filter(count, band, MAX_NEIGHBOURS, width).error <= error:
            for neighbours in range(2, MAX_NEIGHBOURS + 1, 4):
                if (fit := _fit_filter(count, band, neighbours, width)).error <= error:
                    return fit
    raise ValueError(f"{MAX_TAPS} taps do not reach an error of {error:.2g}: the band {band:.3g} is too wide")


@lru_cache(maxsize=64)
def circular_taps(max_order: int, steps: int, error: float) -> CircularTaps:
    """Return the fewest taps within `error`, for orders up to `max_order` on `steps` samples; or ValueError."""
    frequencies: Array = np.arange(max_order + 1, dtype=np.float64) * (_TWO_PI / steps)
    for count in range(4, MAX_TAPS + 1, 2):
        taps = _kaiser_bessel(count, max(float(frequencies[-1]), 0.1))
        gains = 1.0 / _mean_response(taps, frequencies)
        errors = _wave_errors(taps, frequencies, gains, taps.at(_check_positions()), np.ones(1)).max(axis=1)
        if errors.max() <= error:
            return CircularTaps(taps, gains, errors)
    raise ValueError(f"{MAX_TAPS} taps do not reach an error of {error:.2g} for order {max_order} on {steps} samples")


@lru_cache(maxsize=256)
def _fit_filter(count: int, band: float, neighbours: int, width: int = 0) -> FilteredTaps:
    """Return the kernel of `count` taps with a filter of `neighbours` on each side, fitted by least squares."""
    taps, distance = _kaiser_bessel(count, band), np.arange(neighbours + 1)
    times, extent = np.where(distance > 0, 2.0, 1.0), count + 2 * neighbours + width

    def response(w: Array) -> Array:
        return np.sinc(w * (width / _TWO_PI))

    fit = _chebyshev(4 * extent, band)[: 2 * extent]
    # The response of an even filter is a sum of cosines of w times the distance.
    factors = np.cos(np.outer(fit, distance)) * times
    weights, *_ = np.linalg.lstsq(factors * _mean_response(taps, fit)[:, None], response(fit), rcond=1e-15)
    # The error is evaluated at other frequencies than the fit.
    w = _chebyshev(2 * math.ceil(1.18 * extent * band + 48), band)
    gains = np.cos(np.outer(w, distance)) @ (weights * times)
    symmetric, positions = np.concatenate([weights[:0:-1], weights]), _check_positions()

    def bounds(rows: Array, target: Array | NDArray[np.complex128]) -> tuple[float, float]:
        sums = max(np.abs(np.convolve(row, symmetric)).sum() for row in rows)
        rounding = (
            2.0**-53 * (2 * neighbours + 8) * _SQRT_2 * np.abs(rows).sum(axis=1).max() * np.abs(symmetric).sum()
        )
        error = _wave_errors(taps, w, gains, rows, target).max() + rounding
        return _SQRT_2 * float(error), _BETWEEN_POINTS * float(sums)

    # Errors at points bound the errors between them: certificate, section 16, "Between circles".
    error, gain = bounds(taps.at(positions), response(w))
    return FilteredTaps(taps, weights, error, gain, *bounds(taps.slopes(positions), np.asarray(1j * w * response(w))))


def _kaiser_bessel(count: int, band: float) -> Taps:
    """Return a Kaiser-Bessel kernel of `count` taps for a band (radians per step), as polynomials."""
    t = 0.5 * (1.0 + _chebyshev(_DEGREE + 1))
    # The main lobe of the kernel's transform ends near 2 pi - band, where the first alias of the band begins.
    beta = 0.975 * math.pi * count * (1.0 - 0.5 * band / math.pi)
    z = (t[:, None] - np.arange(1.0 - count // 2, count // 2 + 1)) * (2.0 / count)
    values = np.i0(beta * np.sqrt(np.maximum(0.0, 1.0 - z * z))) / np.i0(beta)
    # Polynomials in t approximate the weights, so that interpolation evaluates no Bessel functions.
    series = np.linalg.solve(np.polynomial.chebyshev.chebvander(2.0 * t - 1.0, _DEGREE), values)
    powers = np.zeros((_DEGREE + 1, MAX_TAPS))
    powers[:, :count] = (chebyshev_powers(_DEGREE + 1) @ series)[::-1]
    taps = Taps(powers, count, 0.0, 0.0)
    gains = (_BETWEEN_POINTS * float(np.abs(f(_check_positions())).sum(axis=1).max()) for f in (taps.at, taps.slopes))
    return Taps(powers, count, *gains)


@lru_cache(maxsize=4)
def chebyshev_powers(count: int) -> Array:
    """Return the power coefficients of the first `count` Chebyshev polynomials, shape ``(powers, polynomials)``."""
    rows = [np.polynomial.chebyshev.cheb2poly(row[: k + 1]) for k, row in enumerate(np.eye(count))]
    return np.stack([np.pad(row, (0, count - 1 - k)) for k, row in enumerate(rows)], axis=1)


def _mean_response(taps: Taps, w: Array) -> Array:
    """Return the response of a kernel to frequencies `w`, averaged over positions t: the transform of the kernel."""
    t = 0.5 * (1.0 + _chebyshev(9))
    waves = np.exp(1j * w[:, None, None] * (taps.places - t[:, None]))
    return np.asarray(np.einsum("wtk,tk->w", waves.real, taps.at(t)) / t.size)


def _wave_errors(taps: Taps, w: Array, gains: Array, weights: Array, target: Array | NDArray[np.complex128]) -> Array:
    """Return bounds on the error of the interpolation of ``target exp(i w t)``, shape ``(len(w), positions)``."""
    waves = np.exp(1j * np.outer(w, _check_positions()))
    error = np.abs(target[:, None] * waves - gains[:, None] * (np.exp(1j * np.outer(w, taps.places)) @ weights.T))
    # Rounding: one error for each power in the polynomial of a tap, and one error for each tap.
    rounding = 2.0**-53 * (taps.size + _DEGREE) * _SQRT_2 * np.abs(weights).sum(axis=1).max() * np.abs(gains)
    return np.asarray(_SQRT_2 * (error + rounding[:, None]))


def _evaluate(polynomials: Array, t: Array) -> Array:
    return np.asarray(np.polynomial.polynomial.polyval(2.0 * t - 1.0, polynomials).T)


def _check_positions() -> Array:
    return np.asarray(0.5 * (1.0 + _chebyshev(_CHECK_POINTS)))


def _chebyshev(count: int, band: float = 1.0) -> Array:
    """Return `count` Chebyshev points from band down to -band."""
    return np.asarray(band * np.cos((np.arange(count) + 0.5) * (math.pi / count)), dtype=np.float64)
