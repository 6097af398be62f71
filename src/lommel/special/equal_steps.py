r"""Values between equal steps, of what oscillates no faster than some bound: by few neighbours, with a proven error.

Weights ``c_k(t)`` that serve each ``exp(i w t)``, ``abs(w) <= band``, serve every sum of these: what is off by eps
for each is off by eps times the sum of the moduli. The weights are least squares over the band at Chebyshev points of
t, and polynomials in t between them.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array

_DEGREE = 20
TAPS_MOST = 36


class Steps(NamedTuple):
    """Weights of neighbours.

    Attributes
    ----------
    polynomials : ndarray, shape (degree + 1, taps)
        Chebyshev coefficients of each weight over the step between the two taps in the middle.
    error : float
        Bound on how far ``exp(i w t)`` is off.
    gain : float
        Bound on the sum of the moduli of the weights.
    """

    polynomials: Array
    error: float
    gain: float

    @property
    def taps(self) -> int:
        """How many neighbours, half of them on either side."""
        return int(self.polynomials.shape[1])

    def at(self, t: Array) -> Array:
        """Return the weights for places from 0 to 1 between the taps in the middle, shape ``(len(t), taps)``."""
        return np.asarray(np.polynomial.chebyshev.chebvander(2.0 * t - 1.0, _DEGREE) @ self.polynomials)


@lru_cache(maxsize=64)
def steps(band: float, error: float) -> Steps:
    """Return the fewest weights that err by at most `error`, for a `band` below pi radians a step.

    ValueError if there are none.

    The error is a polynomial in w, but for 1e-17 of it, of a degree ``M = 1.18 taps band + 48`` (its Chebyshev series
    falls below ``e^-48`` there), and one of degree 40 in t. As in :mod:`lommel.methods.averaging` it is at most
    sqrt(2) times as large as at 2 M Chebyshev points of either.
    """
    for taps in range(4, TAPS_MOST + 1, 2):
        made = _fitted(taps, band)
        if made.error <= error:
            return made
    raise ValueError(f"no {TAPS_MOST} neighbours are off by at most {error:.2g}: the band {band:.3g} is too wide")


def _fitted(taps: int, band: float) -> Steps:
    places = np.arange(1.0 - taps // 2, taps // 2 + 1)
    fit, t = _chebyshev(4 * taps), 0.5 * (1.0 + _chebyshev(_DEGREE + 1))
    basis, wanted = (_waves(band * fit[fit > 0.0], at) for at in (places, t))
    weights, *_ = np.linalg.lstsq(basis, wanted, rcond=1e-14)
    polynomials = np.linalg.solve(np.polynomial.chebyshev.chebvander(2.0 * t - 1.0, _DEGREE), weights.T)
    # Where the error is judged.
    w, t = band * _chebyshev(2 * math.ceil(1.18 * taps * band + 48)), 0.5 * (1.0 + _chebyshev(80))
    found = Steps(polynomials, 0.0, 0.0)
    at = found.at(t)
    gain = math.sqrt(2.0) * float(np.abs(at).sum(axis=1).max())
    off = np.exp(1j * np.outer(w, t)) - np.exp(1j * np.outer(w, places)) @ at.T
    error = 2.0 * (float(np.abs(off).max()) + 2.0**-52 * (taps + 4) * gain) + 1e-17 * gain
    return Steps(polynomials, error, gain)


def _waves(w: Array, places: Array) -> Array:
    return np.concatenate([np.cos(np.outer(w, places)), np.sin(np.outer(w, places))])


def _chebyshev(count: int) -> Array:
    return np.asarray(np.cos((np.arange(count) + 0.5) * (math.pi / count)))
