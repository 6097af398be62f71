"""Gauss-Legendre quadrature (compiled)."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from lommel.base.arrays import Array
from lommel.core import engine

_MAX_NODES = 20_000  # largest number of nodes; Newton's method needs half a second for them, and time grows like n^2
# A panel of 256 nodes replaces 200 nodes of one rule: for the same degree, shorter intervals need more nodes in all.
_PANEL, _PANEL_NODES = 200, 256


@lru_cache(maxsize=64)
def _rule(n: int) -> tuple[Array, Array]:
    if n > _MAX_NODES:
        raise ValueError(f"phases and radii must be smaller: they need {n:.6g} nodes, more than {_MAX_NODES}")
    nodes, weights = engine.gauss_legendre(n)
    nodes.flags.writeable = weights.flags.writeable = False
    return nodes, weights


def gauss_legendre(n: int, low: float = 0.0, high: float = 1.0) -> tuple[Array, Array]:
    """Return the nodes (rising) and weights of the n-point Gauss-Legendre rule on ``[low, high]``.

    Nodes are computed by Newton's method in extended precision, and are correct to rounding.

    Parameters
    ----------
    n : int
    low, high : float, default 0, 1

    Returns
    -------
    nodes, weights : ndarray, shape (n,)
    """
    nodes, weights = _rule(n)
    half_length = 0.5 * (high - low)
    return low + half_length * (1.0 + nodes), half_length * weights


def gauss_panels(n: int, low: float = 0.0, high: float = 1.0) -> tuple[Array, Array]:
    """Return the n-point Gauss rule or, for many nodes, a composite rule with 256 nodes per 200 of `n`."""
    # The time for the nodes of one rule grows with the square of their number.
    panels = math.ceil(n / _PANEL)
    if n <= _PANEL_NODES:
        return gauss_legendre(n, low, high)
    x, w = gauss_legendre(_PANEL_NODES)
    width = (high - low) / panels
    return (low + width * (np.arange(panels)[:, None] + x)).ravel(), np.tile(width * w, panels)
