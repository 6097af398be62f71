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

from lommel.base.arrays import Array

TAPS_MOST = 16
NEIGHBOURS_MOST = 30
_DEGREE = 16
_TURN = 2.0 * math.pi


class Taps(NamedTuple):
    """A kernel: polynomials of ``2 t - 1`` (highest power first), an even number of taps, a bound on their sum.

    t from 0 to 1 is the position between the two middle taps; columns beyond `size` are zero.
    """

    polynomials: Array
    size: int
    gain: float

    def at(self, t: Array) -> Array:
        """Return the weights at places t, shape ``(len(t), count)``."""
        return np.asarray(np.polynomial.polynomial.polyval(2.0 * t - 1.0, self.polynomials[::-1, : self.size]).T)

    @property
    def places(self) -> Array:
        """Where the taps are."""
        return np.arange(1.0 - self.size // 2, self.size // 2 + 1)


class Steps(NamedTuple):
    """Taps after a symmetric filter, with bounds on the error of ``exp(i w t)`` and on the sum of the moduli."""

    taps: Taps
    filter: Array
    error: float
    gain: float


class Orders(NamedTuple):
    """Taps around a circle, with factors and error bounds of orders 0, 1, ..."""

    taps: Taps
    gains: Array
    errors: Array


@lru_cache(maxsize=64)
def steps(band: float, error: float) -> Steps:
    """Return the fewest taps within `error` for a `band` below pi radians a step; ValueError if there are none.

    The error is bounded by sqrt(2) times its values at enough Chebyshev points: it is a polynomial of degree 40 in t
    and, within 1e-17, of degree ``1.18 n band + 48`` in w, n being the number of neighbours.
    """
    for count in range(4, TAPS_MOST + 1, 2):
        if _filtered(count, band, NEIGHBOURS_MOST).error <= error:
            for neighbours in range(2, NEIGHBOURS_MOST + 1, 4):
                if (made := _filtered(count, band, neighbours)).error <= error:
                    return made
    raise ValueError(f"no {TAPS_MOST} taps are off by at most {error:.2g}: the band {band:.3g} is too wide")


@lru_cache(maxsize=64)
def orders(most: int, steps: int, error: float) -> Orders:
    """Return the fewest taps on `steps` of a circle within `error` for orders up to `most`; ValueError if none."""
    frequencies: Array = np.arange(most + 1, dtype=np.float64) * (_TURN / steps)
    for count in range(4, TAPS_MOST + 1, 2):
        taps = _kernel(count, max(float(frequencies[-1]), 0.1))
        gains = 1.0 / _transform(taps, frequencies)
        errors = _off(taps, frequencies, gains).max(axis=1)
        if errors.max() <= error:
            return Orders(taps, gains, errors)
    raise ValueError(f"no {TAPS_MOST} taps are off by at most {error:.2g} of the order {most} on {steps} steps")


@lru_cache(maxsize=256)
def _filtered(count: int, band: float, neighbours: int) -> Steps:
    """Return the least-squares filter of a kernel, at Chebyshev points of the band."""
    taps, each = _kernel(count, band), np.arange(neighbours + 1)
    twice = np.where(each > 0, 2.0, 1.0)
    fit = _chebyshev(4 * (count + 2 * neighbours), band)[: 2 * (count + 2 * neighbours)]
    factors = np.cos(np.outer(fit, each)) * twice
    weights, *_ = np.linalg.lstsq(factors * _transform(taps, fit)[:, None], np.ones(fit.size), rcond=1e-15)
    # Where the error is judged.
    w = _chebyshev(2 * math.ceil(1.18 * (count + 2 * neighbours) * band + 48), band)
    error = _off(taps, w, np.cos(np.outer(w, each)) @ (weights * twice)).max()
    whole = np.concatenate([weights[:0:-1], weights])
    sums = [np.abs(np.convolve(row, whole)).sum() for row in taps.at(_places())]
    error += 2.0**-53 * (2 * neighbours + 8) * taps.gain * np.abs(whole).sum()
    return Steps(taps, weights, math.sqrt(2.0) * float(error), math.sqrt(2.0) * float(max(sums)))


def _kernel(count: int, band: float) -> Taps:
    """Return the Kaiser-Bessel kernel for a band."""
    t = 0.5 * (1.0 + _chebyshev(_DEGREE + 1))
    beta = 0.975 * math.pi * count * (1.0 - 0.5 * band / math.pi)
    z = (t[:, None] - np.arange(1.0 - count // 2, count // 2 + 1)) * (2.0 / count)
    values = np.i0(beta * np.sqrt(np.maximum(0.0, 1.0 - z * z))) / np.i0(beta)
    series = np.linalg.solve(np.polynomial.chebyshev.chebvander(2.0 * t - 1.0, _DEGREE), values)
    powers = np.zeros((_DEGREE + 1, TAPS_MOST))
    powers[:, :count] = (_powers() @ series)[::-1]
    made = Taps(powers, count, 0.0)
    return made._replace(gain=math.sqrt(2.0) * float(np.abs(made.at(_places())).sum(axis=1).max()))


@lru_cache(maxsize=1)
def _powers() -> Array:
    """Return the powers of each Chebyshev polynomial, shape ``(powers, polynomials)``."""
    each = [np.polynomial.chebyshev.cheb2poly(row[: k + 1]) for k, row in enumerate(np.eye(_DEGREE + 1))]
    return np.stack([np.pad(row, (0, _DEGREE - k)) for k, row in enumerate(each)], axis=1)


def _transform(taps: Taps, w: Array) -> Array:
    """Return the response of a kernel to frequencies, the mean over all positions."""
    t = 0.5 * (1.0 + _chebyshev(9))
    turned = np.exp(1j * w[:, None, None] * (taps.places - t[:, None]))
    return np.asarray(np.einsum("wtk,tk->w", turned.real, taps.at(t)) / t.size)


def _off(taps: Taps, w: Array, gains: Array) -> Array:
    """Return the error bound of each frequency, shape ``(len(w), positions)``."""
    t = _places()
    waves = np.exp(1j * np.outer(w, taps.places)) @ taps.at(t).T
    off = np.abs(np.exp(1j * np.outer(w, t)) - gains[:, None] * waves)
    rounding = 2.0**-53 * (taps.size + _DEGREE) * taps.gain * np.abs(gains)
    return np.asarray(math.sqrt(2.0) * (off + rounding[:, None]))


def _places() -> Array:
    return np.asarray(0.5 * (1.0 + _chebyshev(80)))


def _chebyshev(count: int, band: float = 1.0) -> Array:
    """Return Chebyshev points of -band to band, from the highest down."""
    return np.asarray(band * np.cos((np.arange(count) + 0.5) * (math.pi / count)), dtype=np.float64)
