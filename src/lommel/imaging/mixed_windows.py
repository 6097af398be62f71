"""Blur by windows that are mixed for each point in the compiled core, and its transpose."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.core import engine
from lommel.imaging.linear import gathered

LARGEST = {1: 19, 2: 31}  # side of windows, by whether defocus varies: of larger ones, transforms are quicker
_STEP = 16  # pixels that windows are padded to multiples of, and that are loaded beyond rows
_MOST_TILES = 32
_ORDERS = (1, 4, 6)  # nodes over defocus that count for one point


class Nodes(Protocol):
    """Places along an axis, and the splines through values at them: see :mod:`lommel.imaging.field_blur`."""

    @property
    def first(self) -> float:
        """Where the axis begins."""

    @property
    def last(self) -> float:
        """Where it ends."""

    @property
    def count(self) -> int:
        """How many there are."""

    @property
    def knots(self) -> tuple[Array, int]:
        """Knots from 0 to 1, and the degree."""

    def weights(self, places: Array) -> Array:
        """Return the weight of each coefficient at places (n,), shape (n, count)."""


class WindowBlur:
    """Blur by windows mixed for each point, as :class:`lommel.imaging.field_blur.MixedBlur`.

    ``out[q] = sum_p x[p] sum_kli D_k(p_y) A_l(p_x) F_i(p) W[k, l, i, q - p]``. Splines across the image are replaced
    by parabolas in so many tiles that `error` is at most what is allowed.

    Parameters
    ----------
    windows : ndarray, shape (y, x, defocus, side, side)
        Coefficients of splines.
    axes : three Nodes
        To which they belong.
    y, x : ndarray
        Places of the rows and columns.
    defocus : ndarray, shape (height, width)
    border : {"reflect", "extend", "zero"}
    threads : int
    allowed : float
        Largest sum of absolute differences to the windows of the splines, each of sum 1.

    Raises
    ------
    ArithmeticError
        If it takes too many tiles.
    """

    def __init__(
        self,
        windows: Values,
        axes: Sequence[Nodes],
        y: Array,
        x: Array,
        defocus: Array,
        *,
        border: str,
        threads: int,
        allowed: float,
    ) -> None:
        kind, side = windows.dtype, windows.shape[-1]
        down, above = _used(axes[0].weights(y))
        across, left = _used(axes[1].weights(x))
        along, breaks, powers = _pieces(axes[2], defocus)
        used, front = _used_pieces(along, breaks)
        order = powers.shape[1]
        part = windows[above, left, front : front + len(used) - 2 + order]
        count = len(used) - 2 + order
        padded = np.zeros((*part.shape[:2], count, -(-side * side // _STEP) * _STEP), dtype=kind)
        padded[:, :, : part.shape[2], : side * side] = part.reshape(*part.shape[:3], -1)
        tiles, places, shares, self.error = _parabolas(across, axes[1], x, left, part, allowed)
        powers = powers[front : front + len(used) - 1]
        given = {"windows": padded, "down": down, "places": places, "shares": shares, "powers": powers}
        self._given: dict[str, Any] = {
            name: np.ascontiguousarray(values, dtype=kind) for name, values in given.items()
        }
        self._given |= {"tiles": tiles, "defocus": along, "breaks": used, "threads": threads, "side": side}
        self._side, self._margin, self._border = side, 0 if border == "zero" else side // 2, border
        self._shape = defocus.shape

    @cached_property
    def _places(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        rows, columns = (copies(count, self._margin, self._border) for count in self._shape)
        return rows, columns

    @property
    def _inside(self) -> tuple[slice, slice]:
        """Where the image is, in what the core makes."""
        first = self._margin + self._side // 2
        rows, columns = (slice(first, first + count) for count in self._shape)
        return rows, columns

    def _room(self, kind: np.dtype[Any]) -> Values:
        rows, columns = self._places
        beyond = self._side - 1
        return np.zeros((len(rows) + beyond, len(columns) + beyond + _STEP), dtype=kind)

    def spread(self, plane: Values) -> Values:
        """Return the blurred image of a plane of light."""
        rows, columns = self._places
        light, out = plane[rows[:, None], columns], self._room(plane.dtype)
        engine.field_spread(rows=rows, columns=columns, image=light, out=out, **self._given)
        return out[self._inside]

    def collect(self, plane: Values) -> Values:
        """Return the transpose of :meth:`spread` applied to an image."""
        rows, columns = self._places
        room, taken = self._room(plane.dtype), np.empty((len(rows), len(columns)), dtype=plane.dtype)
        room[self._inside] = plane
        engine.field_spread(rows=rows, columns=columns, image=room, out=taken, transposed=True, **self._given)
        # What points beyond the edges took goes to those that they are copies of.
        return gathered(gathered(taken, rows, plane.shape[0]).T, columns, plane.shape[1]).T


def copies(count: int, margin: int, border: str) -> NDArray[np.int64]:
    """Return which row or column each of those is a copy of that spread light, the ones beyond the edges too."""
    mode: Any = "symmetric" if border == "reflect" else "edge"
    return np.pad(np.arange(count, dtype=np.int64), margin, mode=mode)


def _used(weights: Array) -> tuple[Array, slice]:
    """Return the columns between the first and the last that is not 0, and which they are."""
    used = np.flatnonzero(weights.any(axis=0))
    part = slice(int(used[0]), int(used[-1]) + 1)
    return weights[:, part], part


def _pieces(nodes: Nodes, places: Array) -> tuple[Array, Array, Array]:
    """Return places along an axis of splines from 0 to 1, where its pieces begin and end, and their coefficients.

    These are [piece][power][node]: of the share of the piece, the weight of node ``piece + node``.
    """
    if nodes.count == 1:
        return np.zeros(places.shape), np.array([0.0, 1.0]), np.ones((1, 1, 1))
    from scipy.interpolate import BSpline

    knots, degree = nodes.knots
    count = nodes.count
    splines = BSpline(knots, np.eye(count), degree)
    order = next(order for order in _ORDERS if order > degree)
    breaks = np.ascontiguousarray(knots[degree : count + 1])
    powers = np.zeros((count - degree, order, order))
    for power in range(degree + 1):
        known = splines(breaks[:-1], power) * np.diff(breaks)[:, None] ** power / math.factorial(power)
        for piece, weights in enumerate(known):
            powers[piece, power, : degree + 1] = weights[piece : piece + degree + 1]
    return np.clip((places - nodes.first) / (nodes.last - nodes.first), 0.0, 1.0), breaks, powers


def _used_pieces(along: Array, breaks: Array) -> tuple[Array, int]:
    """Return where the pieces begin and end that places lie in, and the number of the first."""
    pieces = len(breaks) - 1
    first, last = (
        int(np.clip(np.searchsorted(breaks, end, side="right") - 1, 0, pieces - 1))
        for end in (along.min(), along.max())
    )
    return np.ascontiguousarray(breaks[first : last + 2]), first


def _parabolas(
    across: Array, nodes: Nodes, x: Array, left: slice, windows: Values, allowed: float
) -> tuple[NDArray[np.int64], Array, Array, float]:
    """Return the tile of each column, the weights of nodes at places, the shares of these in columns, and the error.

    Weights are shares of one, and so is what is between places: the error of windows anywhere is at most the largest
    of those at the nodes down the image and over defocus.
    """
    count, tiles = len(x), 1
    at = np.arange(count) / max(1, count - 1)
    while tiles <= _MOST_TILES:
        places = nodes.weights(x[0] + (x[-1] - x[0]) * np.linspace(0.0, 1.0, 2 * tiles + 1))[:, left]
        tile = np.minimum((at * tiles).astype(np.int64), tiles - 1)
        u = 2.0 * (at * tiles - tile) - 1.0
        shares = np.stack([0.5 * u * (u - 1.0), 1.0 - u * u, 0.5 * u * (u + 1.0)], axis=1)
        off = across - sum(shares[:, k, None] * places[2 * tile + k] for k in range(3))
        size = np.abs(off).sum(axis=1)
        worst = [int(np.flatnonzero(tile == k)[size[tile == k].argmax()]) for k in np.unique(tile)]
        made = np.tensordot(off[worst], windows.astype(np.float64, copy=False), axes=(1, 1))
        error = float(np.abs(made).sum(axis=(-2, -1)).max())
        if error <= allowed:
            return tile, places, shares, error
        # It falls by 8 where tiles are half as wide.
        tiles = max(tiles + 1, math.ceil(tiles * (error / allowed) ** (1.0 / 3.0)))
    raise ArithmeticError(f"parabolas in {_MOST_TILES} tiles are not close enough to the windows across the image")
