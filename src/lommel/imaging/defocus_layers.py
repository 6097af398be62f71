"""Layers of defocus, in each of which all PSF windows are sums of few, with polynomials of C_d as weights."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array

_NODES = 16, 1.1  # Chebyshev nodes of a layer: of one of no width, and for each radian
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
    windows : ndarray, shape (rank, parts, cells)
    """

    low: float
    high: float
    nodes: Array
    weights: Array
    windows: Array


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
    windows: Callable[[Array], Array], low: float, high: float, tol: float, width: float, rate: float, most: int
) -> list[DefocusLayer]:
    """Return the layers of a range of C_d, of about `width` radians or less each, at the shortest wavelength.

    `windows` returns the windows at values of C_d, about `most` at once, shape (n, parts, cells); all parts share the
    weights. Between them no cell is off by more than about `tol` times the peak of its window. `rate` is the C_d at
    the shortest wavelength over that given. ValueError if it takes too many layers.
    """
    count = max(1, math.ceil(rate * (high - low) / width))
    edges = np.linspace(low, high, count + 1)
    wanted = list(zip(edges[-2::-1].tolist(), edges[:0:-1].tolist(), strict=True))
    together = max(1, most // len(_nodes(*wanted[-1], rate)))
    made: list[DefocusLayer] = []
    while wanted:
        some = wanted[: -together - 1 : -1]
        nodes = [_nodes(*ends, rate) for ends in some]
        known = np.split(windows(np.concatenate(nodes)), np.cumsum([len(at) for at in nodes])[:-1])
        found = [_layer(*ends, *each, tol) for ends, each in zip(some, zip(nodes, known, strict=True), strict=True)]
        good = next((k for k, layer in enumerate(found) if layer is None), len(found))
        made += [layer for layer in found[:good] if layer is not None]
        del wanted[len(wanted) - good :]
        if good < len(found):
            begin, end = wanted.pop()
            middle = 0.5 * (begin + end)
            wanted += [(middle, end), (begin, middle)]
            if len(made) + len(wanted) > _MOST:
                raise ValueError(
                    f"distances span {high - low:.4g} rad of C_d and take more than {_MOST} layers; ask for a "
                    "smaller range, or for a larger tol"
                )
    return made


def _nodes(low: float, high: float, rate: float) -> Array:
    """Return the C_d that one layer is made from."""
    x, _ = chebyshev_nodes(math.ceil(_NODES[0] + _NODES[1] * rate * (high - low)))
    return 0.5 * (low + high) + 0.5 * (high - low) * x


# A polynomial through the windows at Chebyshev nodes converges, as they are entire in C_d but for the division by
# their light. Fewer windows span the same: those that QR with pivoting finds, an interpolative decomposition
# (H. Cheng, Z. Gimbutas, P. G. Martinsson, V. Rokhlin, SIAM J. Sci. Comput. 26, 1389 (2005),
# doi:10.1137/030602678), which keeps windows as windows, so that they can be computed anew for another lens.
def _layer(low: float, high: float, nodes: Array, windows: Array, tol: float) -> DefocusLayer | None:
    """Return one layer from its windows at nodes, or None if its polynomial does not converge."""
    count = len(nodes)
    _, transform = chebyshev_nodes(count)
    at = (windows / windows.max(axis=2).min(axis=0)[:, None]).reshape(count, -1)  # over the least of the peaks
    coefficients = transform @ at
    tail = np.cumsum(np.abs(coefficients).max(axis=1)[::-1])[::-1]
    if tail[-2] > 0.2 * tol:
        return None
    degrees = max(2, int((tail > 0.1 * tol).sum()))
    polynomials = chebyshev(np.cos(np.linspace(0.0, math.pi, 2 * count + 1)), degrees)
    truth = polynomials @ coefficients[:degrees]
    flat = at
    if at.shape[1] > 4 * count:
        flat = at @ np.random.default_rng(0).standard_normal((at.shape[1], 4 * count))
    order, upper = _pivoted(flat)
    diagonal = np.abs(upper[np.arange(count), order])
    for rank in range(max(1, int((diagonal > tol * diagonal[0]).sum())), count + 1):
        mixture = np.linalg.solve(upper[:rank, order[:rank]], upper[:rank]).T
        weights = transform[:degrees] @ mixture
        if np.abs(polynomials @ weights @ at[order[:rank]] - truth).max() <= 0.5 * tol:
            break
    chosen = order[:rank]
    return DefocusLayer(low, high, nodes[chosen], np.ascontiguousarray(weights.T), windows[chosen])


def _pivoted(rows: Array) -> tuple[NDArray[np.int64], Array]:
    """Return the pivots of a QR decomposition of the transpose, and R with the columns where they were."""
    # Of so few rows, LAPACK takes longer to start its threads.
    rest, order, upper = rows.copy(), np.empty(len(rows), dtype=np.int64), np.empty((len(rows), len(rows)))
    for k in range(len(rows)):
        squares = (rest * rest).sum(axis=1)
        squares[order[:k]] = -1.0
        order[k] = squares.argmax()
        size = math.sqrt(squares[order[k]])
        direction = rest[order[k]] / size if size > 0.0 else rest[order[k]]
        upper[k] = rest @ direction
        rest -= upper[k][:, None] * direction
    return order, upper
