"""Chebyshev polynomials, and their coefficients from values at the Chebyshev nodes."""

from __future__ import annotations

import math

import numpy as np

from lommel.base.arrays import Array


def chebyshev(x: Array, count: int) -> Array:
    """Return the Chebyshev polynomials of degrees below `count` at `x` in -1 to 1, shape (len(x), count)."""
    # T_n(x) = cos(n arccos x).
    return np.asarray(np.cos(np.outer(np.arccos(np.clip(x, -1.0, 1.0)), np.arange(count))))


def chebyshev_nodes(count: int) -> tuple[Array, Array]:
    """Return the Chebyshev nodes in -1 to 1, and the matrix from values at the nodes to Chebyshev coefficients."""
    angle = (np.arange(count) + 0.5) * (math.pi / count)
    transform = np.cos(np.outer(np.arange(count), angle)) * (2.0 / count)
    # The coefficient of order 0 is the mean of the values: its factor is 1 / count, not 2 / count.
    transform[0] *= 0.5
    return np.cos(angle), transform
