"""Gauss-Legendre quadrature (compiled)."""

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

    Newton's method in extended precision: nodes are correct to rounding, and so is any weighted sum of order one.
    """
    nodes, weights = _rule(n)
    half = 0.5 * (high - low)
    return low + half * (1.0 + nodes), half * weights
