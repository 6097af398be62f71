r"""Values between equal steps, of what oscillates no faster than some bound: by a kernel and a filter, both proven.

What is a sum of ``exp(i w x)``, ``abs(w) <= band``, is interpolated by few taps of a kernel phi once it has been
divided by the transform of phi. Where its frequencies are known, orders around a circle, they are; elsewhere a filter
of some neighbours does that. What is off by eps for each frequency is off by eps times the sum of the moduli.
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
    """A kernel, by its weights at neighbours.

    Attributes
    ----------
    polynomials : ndarray, shape (degree + 1, TAPS_MOST)
        Of ``2 t - 1``, the highest power first, t from 0 to 1 being the place between the two taps in the middle;
        those beyond `size` are zero.
    size : int
        An even number.
    gain : float
        Bound on the sum of the moduli of the weights.
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
    """Taps after a filter.

    Attributes
    ----------
    taps : Taps
    filter : ndarray
        Weights of a value, of those a step away on either side, of those two away, ...
    error : float
        Bound on how far ``exp(i w t)`` is off.
    gain : float
        Bound on the sum of the moduli of what each value counts after both.
    """

    taps: Taps
    filter: Array
    error: float
    gain: float


class Orders(NamedTuple):
    """Taps around a circle.

    Attributes
    ----------
    taps : Taps
    gains : ndarray
        What orders 0, 1, ... are to be multiplied by.
    errors : ndarray
        Bound on how far each is off.
    """

    taps: Taps
    gains: Array
    errors: Array


@lru_cache(maxsize=64)
def steps(band: float, error: float) -> Steps:
    """Return the fewest taps that err by at most `error`, for a `band` below pi radians a step.

    ValueError if there are none.

    The error is a polynomial in w, but for 1e-17 of it, of a degree ``M = 1.18 n band + 48``, n as many as there are
    neighbours of both (its Chebyshev series falls below ``e^-48`` there), and one of degree 40 in t. As in
    :mod:`lommel.methods.pixels.averaging` it is at most sqrt(2) times as large as at 2 M Chebyshev points of either.
    """
    for count in range(4, TAPS_MOST + 1, 2):
        if _filtered(count, band, NEIGHBOURS_MOST).error <= error:
            for neighbours in range(2, NEIGHBOURS_MOST + 1, 4):
                if (made := _filtered(count, band, neighbours)).error <= error:
                    return made
    raise ValueError(f"no {TAPS_MOST} taps are off by at most {error:.2g}: the band {band:.3g} is too wide")


@lru_cache(maxsize=64)
def orders(most: int, steps: int, error: float) -> Orders:
    """Return the fewest taps around a circle of so many `steps` that err by at most `error` in orders up to `most`.

    ValueError if there are none. The error is a polynomial in t as above.
    """
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
    """Return the filter that serves a kernel best, by least squares at Chebyshev points of the band."""
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
    """Return the window of Kaiser and Bessel that is best for a band."""
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
    """Return what each Chebyshev polynomial is in powers, shape ``(powers, polynomials)``."""
    each = [np.polynomial.chebyshev.cheb2poly(row[: k + 1]) for k, row in enumerate(np.eye(_DEGREE + 1))]
    return np.stack([np.pad(row, (0, _DEGREE - k)) for k, row in enumerate(each)], axis=1)


def _transform(taps: Taps, w: Array) -> Array:
    """Return what a kernel makes of frequencies, the mean over all places."""
    t = 0.5 * (1.0 + _chebyshev(9))
    turned = np.exp(1j * w[:, None, None] * (taps.places - t[:, None]))
    return np.asarray(np.einsum("wtk,tk->w", turned.real, taps.at(t)) / t.size)


def _off(taps: Taps, w: Array, gains: Array) -> Array:
    """Return how far each frequency is off at most at any place, shape ``(len(w), places)``."""
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
