"""Interpolation of band-limited functions between equal steps, by Kaiser-Bessel kernels with proven errors.

A sum of ``exp(i w x)``, ``abs(w) <= band``, is interpolated by few taps of a kernel after division by the transform
of the kernel: exactly for known frequencies around a circle, by a filter of neighbours elsewhere. An error eps of
each frequency is eps times the sum of the moduli.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array

TAPS_MOST = 16
NEIGHBOURS_MOST = 30
_DEGREE = 16
_TURN = 2.0 * math.pi
_ROOT = math.sqrt(2.0)
_PLACES = 80  # Chebyshev points between two taps, at which errors and gains are evaluated
_BETWEEN = 1.0 / math.cos(0.5 * math.pi * _DEGREE / _PLACES)  # largest value of such a polynomial over that there
# Ehlich and Zeller, Math. Z. 86, 41 (1964): degree d at n Chebyshev points, 1 / cos(pi d / 2n).


class Taps(NamedTuple):
    """Interpolation kernel: an even number of taps, polynomials of ``2 t - 1`` (highest power first).

    t from 0 to 1 is the position between the two middle taps; columns beyond `size` are zero. `gain` and `slope_gain`
    bound the sums of moduli of the taps and of their slopes.
    """

    polynomials: Array
    size: int
    gain: float
    slope_gain: float

    def at(self, t: Array) -> Array:
        """Return the weights at positions t, shape ``(len(t), size)``."""
        return _values(self.polynomials[::-1, : self.size], t)

    def slopes(self, t: Array) -> Array:
        """Return their derivatives by t."""
        return _values(np.asarray(2.0 * np.polynomial.polynomial.polyder(self.polynomials[::-1, : self.size])), t)

    def weighted(self, times: Array) -> float:
        """Bound the sum of the moduli of the taps, each multiplied by its entry of `times`."""
        return _BETWEEN * float((np.abs(self.at(_places())) * times).sum(axis=1).max())

    @property
    def places(self) -> Array:
        """Positions of the taps, in steps."""
        return np.arange(1.0 - self.size // 2, self.size // 2 + 1)


class Steps(NamedTuple):
    """Taps after a symmetric filter, with bounds on the error of ``exp(i w t)`` and on the sum of moduli.

    `slope_error` and `slope_gain` are those of the derivatives by t.
    """

    taps: Taps
    filter: Array
    error: float
    gain: float
    slope_error: float
    slope_gain: float


class Orders(NamedTuple):
    """Taps around a circle, with factors and error bounds of orders 0, 1, ..."""

    taps: Taps
    gains: Array
    errors: Array


@lru_cache(maxsize=64)
def steps(band: float, error: float, width: int = 0) -> Steps:
    """Return the fewest taps within `error` for a `band` below pi radians a step; ValueError if there are none.

    With `width` they interpolate averages over that many steps, whose response the filter includes.
    """
    # The error is bounded by sqrt(2) times its values at enough Chebyshev points: it is a polynomial of degree 40 in
    # t and, within 1e-17, of degree ``1.18 n band + 48`` in w, n being the number of neighbours. Sums of moduli are,
    # for given signs, polynomials of degree 16, at most 1.06 times as large as at these points.
    # Taps cost time at every interpolated value, the filter only once: the most neighbours are tried for each number
    # of taps, then the fewest that suffice.
    for count in range(4, TAPS_MOST + 1, 2):
        if _filtered(count, band, NEIGHBOURS_MOST, width).error <= error:
            for neighbours in range(2, NEIGHBOURS_MOST + 1, 4):
                if (made := _filtered(count, band, neighbours, width)).error <= error:
                    return made
    raise ValueError(f"no {TAPS_MOST} taps are off by at most {error:.2g}: the band {band:.3g} is too wide")


@lru_cache(maxsize=64)
def orders(most: int, steps: int, error: float) -> Orders:
    """Return the fewest taps on `steps` of a circle within `error` for orders up to `most`; ValueError if none."""
    frequencies: Array = np.arange(most + 1, dtype=np.float64) * (_TURN / steps)
    for count in range(4, TAPS_MOST + 1, 2):
        taps = _kernel(count, max(float(frequencies[-1]), 0.1))
        gains = 1.0 / _transform(taps, frequencies)
        errors = _off(taps, frequencies, gains, taps.at(_places()), np.ones(1)).max(axis=1)
        if errors.max() <= error:
            return Orders(taps, gains, errors)
    raise ValueError(f"no {TAPS_MOST} taps are off by at most {error:.2g} of the order {most} on {steps} steps")


@lru_cache(maxsize=256)
def _filtered(count: int, band: float, neighbours: int, width: int = 0) -> Steps:
    """Return the least-squares filter of a kernel, fitted at Chebyshev points of the band."""
    taps, each = _kernel(count, band), np.arange(neighbours + 1)
    twice, reach = np.where(each > 0, 2.0, 1.0), count + 2 * neighbours + width

    def response(w: Array) -> Array:
        return np.sinc(w * (width / _TURN))

    fit = _chebyshev(4 * reach, band)[: 2 * reach]
    # Even filters have real responses: cosines of the distance of neighbours.
    factors = np.cos(np.outer(fit, each)) * twice
    weights, *_ = np.linalg.lstsq(factors * _transform(taps, fit)[:, None], response(fit), rcond=1e-15)
    # Points at which the error is evaluated, independent of those of the fit.
    w = _chebyshev(2 * math.ceil(1.18 * reach * band + 48), band)
    gains = np.cos(np.outer(w, each)) @ (weights * twice)
    whole, places = np.concatenate([weights[:0:-1], weights]), _places()

    def judged(of: Array, wanted: Array | NDArray[np.complex128]) -> tuple[float, float]:
        sums = max(np.abs(np.convolve(row, whole)).sum() for row in of)
        rounding = 2.0**-53 * (2 * neighbours + 8) * _ROOT * np.abs(of).sum(axis=1).max() * np.abs(whole).sum()
        return _ROOT * float(_off(taps, w, gains, of, wanted).max() + rounding), _BETWEEN * float(sums)

    # Errors are judged, not derived: certificate, section 16, "Between circles".
    error, gain = judged(taps.at(places), response(w))
    return Steps(taps, weights, error, gain, *judged(taps.slopes(places), np.asarray(1j * w * response(w))))


def _kernel(count: int, band: float) -> Taps:
    """Return the Kaiser-Bessel kernel for a band, as polynomials."""
    t = 0.5 * (1.0 + _chebyshev(_DEGREE + 1))
    # The main lobe of the window's transform ends near the copy of the band, at 2 pi - band.
    beta = 0.975 * math.pi * count * (1.0 - 0.5 * band / math.pi)
    z = (t[:, None] - np.arange(1.0 - count // 2, count // 2 + 1)) * (2.0 / count)
    # The Kaiser-Bessel window.
    values = np.i0(beta * np.sqrt(np.maximum(0.0, 1.0 - z * z))) / np.i0(beta)
    # Between two taps each weight is close to a polynomial: products of a few powers, without Bessel functions.
    series = np.linalg.solve(np.polynomial.chebyshev.chebvander(2.0 * t - 1.0, _DEGREE), values)
    powers = np.zeros((_DEGREE + 1, TAPS_MOST))
    powers[:, :count] = (chebyshev_powers(_DEGREE + 1) @ series)[::-1]
    made = Taps(powers, count, 0.0, 0.0)
    gains = (_BETWEEN * float(np.abs(of(_places())).sum(axis=1).max()) for of in (made.at, made.slopes))
    return Taps(powers, count, *gains)


@lru_cache(maxsize=4)
def chebyshev_powers(count: int) -> Array:
    """Return the power coefficients of the first `count` Chebyshev polynomials, shape ``(powers, polynomials)``."""
    each = [np.polynomial.chebyshev.cheb2poly(row[: k + 1]) for k, row in enumerate(np.eye(count))]
    return np.stack([np.pad(row, (0, count - 1 - k)) for k, row in enumerate(each)], axis=1)


def _transform(taps: Taps, w: Array) -> Array:
    """Return the response of a kernel to frequencies `w`, averaged over all positions."""
    t = 0.5 * (1.0 + _chebyshev(9))
    turned = np.exp(1j * w[:, None, None] * (taps.places - t[:, None]))
    return np.asarray(np.einsum("wtk,tk->w", turned.real, taps.at(t)) / t.size)


def _off(taps: Taps, w: Array, gains: Array, weights: Array, wanted: Array | NDArray[np.complex128]) -> Array:
    """Return the error bound of each frequency, shape ``(len(w), positions)``, for a `wanted` response."""
    turned = np.exp(1j * np.outer(w, _places()))
    off = np.abs(wanted[:, None] * turned - gains[:, None] * (np.exp(1j * np.outer(w, taps.places)) @ weights.T))
    # Weights are sums of 16 powers, with one rounding each.
    rounding = 2.0**-53 * (taps.size + _DEGREE) * _ROOT * np.abs(weights).sum(axis=1).max() * np.abs(gains)
    return np.asarray(_ROOT * (off + rounding[:, None]))


def _values(polynomials: Array, t: Array) -> Array:
    return np.asarray(np.polynomial.polynomial.polyval(2.0 * t - 1.0, polynomials).T)


def _places() -> Array:
    return np.asarray(0.5 * (1.0 + _chebyshev(_PLACES)))


def _chebyshev(count: int, band: float = 1.0) -> Array:
    """Return Chebyshev points of -band to band, from the highest down."""
    return np.asarray(band * np.cos((np.arange(count) + 0.5) * (math.pi / count)), dtype=np.float64)
