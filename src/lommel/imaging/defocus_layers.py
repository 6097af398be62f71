"""Layers of defocus, in each of which all PSF windows are sums of few, with polynomials of C_d as weights."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array

_NODES = 44  # Chebyshev nodes of a layer
_MOST = 512  # layers


class DefocusLayer(NamedTuple):
    """A range of C_d, radians, with the windows and weights that interpolate there.

    Attributes
    ----------
    low, high : float
    nodes : ndarray, shape (rank,)
        C_d of the windows.
    weights : ndarray, shape (rank, degrees)
        Coefficients of each weight for Chebyshev polynomials of the defocus, from -1 at `low` to 1 at `high`.
    """

    low: float
    high: float
    nodes: Array
    weights: Array


def chebyshev(x: Array, count: int) -> Array:
    """Return the Chebyshev polynomials of the degrees below `count` at `x` in -1 to 1, shape (len(x), count)."""
    return np.asarray(np.cos(np.outer(np.arccos(np.clip(x, -1.0, 1.0)), np.arange(count))))


def chebyshev_nodes(count: int) -> tuple[Array, Array]:
    """Return nodes in -1 to 1, and the matrix from values there to Chebyshev coefficients."""
    angle = (np.arange(count) + 0.5) * (math.pi / count)
    transform = np.cos(np.outer(np.arange(count), angle)) * (2.0 / count)
    transform[0] *= 0.5
    return np.cos(angle), transform


def defocus_layers(
    windows: Callable[[Array], Array], low: float, high: float, tol: float, width: float
) -> list[DefocusLayer]:
    """Return the layers of a range of C_d, of about `width` radians or less each.

    `windows` returns the windows at values of C_d, shape (n, parts, cells); all parts share the weights. Between them
    the root of the sum over cells of squared errors is about `tol` at most. ValueError if that takes too many layers.
    """
    count = max(1, math.ceil((high - low) / width))
    edges = np.linspace(low, high, count + 1)
    wanted = list(zip(edges[-2::-1].tolist(), edges[:0:-1].tolist(), strict=True))
    made: list[DefocusLayer] = []
    while wanted:
        begin, end = wanted.pop()
        found = _layer(windows, begin, end, tol)
        if found is None:
            middle = 0.5 * (begin + end)
            wanted += [(middle, end), (begin, middle)]
            if len(made) + len(wanted) > _MOST:
                raise ValueError(
                    f"distances span {high - low:.4g} rad of C_d and take more than {_MOST} layers; ask for a "
                    "smaller range, or for a larger tol"
                )
        else:
            made.append(found)
    return made


# A polynomial through the windows at Chebyshev nodes converges, as they are entire in C_d but for the division by
# their light. Fewer windows span the same: those that QR with pivoting finds, an interpolative decomposition
# (H. Cheng, Z. Gimbutas, P. G. Martinsson, V. Rokhlin, SIAM J. Sci. Comput. 26, 1389 (2005),
# doi:10.1137/030602678), which keeps windows as windows, so that they can be computed anew for another lens.
def _layer(windows: Callable[[Array], Array], low: float, high: float, tol: float) -> DefocusLayer | None:
    """Return one layer, or None if its polynomial does not converge."""
    from scipy.linalg import qr, solve_triangular

    x, transform = chebyshev_nodes(_NODES)
    at = windows(0.5 * (low + high) + 0.5 * (high - low) * x)
    parts = at.shape[1]
    coefficients = (transform @ at.reshape(_NODES, -1)).reshape(at.shape)
    size = np.linalg.norm(coefficients, axis=2).max(axis=1)
    tail = np.cumsum(size[::-1])[::-1]
    if tail[-2] > 0.2 * tol:
        return None
    degrees = max(2, int((tail > 0.1 * tol).sum()))
    polynomials = chebyshev(np.cos(np.linspace(0.0, math.pi, 2 * _NODES + 1)), degrees)
    truth = polynomials @ coefficients[:degrees].reshape(degrees, -1)
    flat = at.reshape(_NODES, -1)
    if flat.shape[1] > 4 * _NODES:
        flat = flat @ np.random.default_rng(0).standard_normal((flat.shape[1], 4 * _NODES))
    _, upper, order = qr(flat.T, mode="economic", pivoting=True)
    diagonal = np.abs(np.diag(upper))
    for rank in range(max(1, int((diagonal > 10.0 * tol * diagonal[0]).sum())), _NODES + 1):
        mixture = np.empty((_NODES, rank))
        mixture[order] = solve_triangular(upper[:rank, :rank], upper[:rank]).T
        weights = transform[:degrees] @ mixture
        off = polynomials @ weights @ at[order[:rank]].reshape(rank, -1) - truth
        if np.linalg.norm(off.reshape(len(truth), parts, -1), axis=2).max() <= 0.5 * tol:
            break
    nodes = 0.5 * (low + high) + 0.5 * (high - low) * x[order[:rank]]
    return DefocusLayer(low, high, nodes, np.ascontiguousarray(weights.T))
