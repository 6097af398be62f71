"""Gauss-Legendre quadrature and Legendre polynomials on [0, 1] and its parts (compiled)."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from lommel import _core


@lru_cache(maxsize=64)
def _rule(n: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    nodes, weights = _core.gauss_legendre(n)
    nodes.flags.writeable = weights.flags.writeable = False
    return nodes, weights


def gauss_legendre(n: int, low: float = 0.0, high: float = 1.0) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the nodes (rising) and weights of the n-point Gauss-Legendre rule on ``[low, high]``.

    Newton's method in extended precision; nodes and weights are correct to double rounding.
    """
    nodes, weights = _rule(n)
    half = 0.5 * (high - low)
    return low + half * (1.0 + nodes), half * weights


def shifted_legendre(t: NDArray[np.float64], terms: int) -> NDArray[np.float64]:
    """Return ``P_0(2t - 1) .. P_{terms-1}(2t - 1)``, shape ``(len(t), terms)``."""
    return _core.legendre_sequence(np.ascontiguousarray(2.0 * t - 1.0), terms)
