"""Blur by windows that vary over the field and with defocus, mixed for each point in the compiled core."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.core import engine
from lommel.core.answers import DType
from lommel.deconvolve.linear import copies, folded

if TYPE_CHECKING:
    from lommel.imaging.spline_nodes import Nodes

LARGEST = {1: 19, 2: 31}  # largest side of windows for direct sums, for constant or varying defocus
_STEP = 16  # windows are padded to a multiple of this size; the core reads up to _STEP pixels beyond a row
_MAX_TILES = 32
_ORDERS = (1, 4, 6)  # supported numbers of defocus nodes per point


class WindowBlur:
    """Space-variant blur by interpolated PSF windows; see :class:`lommel.imaging.field_blur.MixedBlur`.

    ``out[q] = sum_p x[p] sum_kli D_k(p_y) A_l(p_x) F_i(p) W[k, l, i, q - p]``, W being windows and D, A and F the
    spline weights of row, column and defocus. Splines along x are replaced by parabolas, one for each tile of
    columns. The number of tiles is increased until `error` is at most `allowed`.

    Parameters
    ----------
    windows : ndarray, shape (y, x, defocus, side, side)
        Spline coefficients W of the windows.
    axes : three Nodes
        Interpolation nodes of y, x and defocus.
    y, x : ndarray
        Positions of the rows and columns.
    defocus : ndarray, shape (height, width)
        Defocus of each point.
    allowed : float
        Largest sum of absolute differences from the spline-interpolated windows, whose sum is 1.
    threads : int
        Maximum number of threads; 0 for all processors.

    Raises
    ------
    ArithmeticError
        If too many tiles are needed.
    """

    def __init__(
        self,
        windows: Values,
        axes: Sequence[Nodes],
        y: Array,
        x: Array,
        defocus: Array,
        *,
        allowed: float,
        threads: int = 0,
    ) -> None:
        kind, side = windows.dtype, windows.shape[-1]
        row_weights, rows = _nonzero_columns(axes[0].weights(y))
        column_weights, columns = _nonzero_columns(axes[1].weights(x))
        positions, breaks, powers = _pieces(axes[2], defocus)
        used_breaks, first_piece = _used_pieces(positions, breaks)
        order = powers.shape[1]
        part = windows[rows, columns, first_piece : first_piece + len(used_breaks) - 2 + order]
        count = len(used_breaks) - 2 + order
        padded = np.zeros((*part.shape[:2], count, -(-side * side // _STEP) * _STEP), dtype=kind)
        padded[:, :, : part.shape[2], : side * side] = part.reshape(*part.shape[:3], -1)
        tiles, point_nodes, point_weights, self.error = _parabolas(column_weights, axes[1], x, columns, part, allowed)
        powers = powers[first_piece : first_piece + len(used_breaks) - 1]
        row_weights, point_nodes, point_weights, powers = (
            np.ascontiguousarray(values, dtype=kind) for values in (row_weights, point_nodes, point_weights, powers)
        )
        self._side, self._margin, self._threads, self._shape = side, side // 2, threads, defocus.shape
        # Of the image with its mirrored border.
        down, along = self._places
        self._splines = padded, side, row_weights[down], point_nodes, point_weights[along]
        self._defocus = tiles[along], positions[down[:, None], along], used_breaks, powers

    @cached_property
    def _places(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        rows, columns = (copies(count, self._margin) for count in self._shape)
        return rows, columns

    @property
    def _inside(self) -> tuple[slice, slice]:
        """Position of the image in the padded result."""
        start = self._margin + self._side // 2
        rows, columns = (slice(start, start + count) for count in self._shape)
        return rows, columns

    def _empty_padded(self, kind: DType) -> Values:
        rows, columns = self._places
        extent = self._side - 1
        return np.zeros((len(rows) + extent, len(columns) + extent + _STEP), dtype=kind)

    def forward(self, plane: Values) -> Values:
        """Return the blurred image of a plane of light."""
        rows, columns = self._places
        source, padded = plane[rows[:, None], columns], self._empty_padded(plane.dtype)
        engine.field_spread(self._splines, self._defocus, source, self._threads, padded)
        return padded[self._inside]

    def adjoint(self, plane: Values) -> Values:
        """Return the transpose of :meth:`forward` applied to an image."""
        rows, columns = self._places
        padded, padded_light = self._empty_padded(plane.dtype), np.empty((len(rows), len(columns)), dtype=plane.dtype)
        padded[self._inside] = plane
        engine.field_spread(self._splines, self._defocus, padded, self._threads, padded_light, transposed=True)
        return folded(padded_light, (self._margin,) * 2, self._shape)


def _nonzero_columns(weights: Array) -> tuple[Array, slice]:
    """Return the columns from the first to the last nonzero one, and their slice."""
    columns = np.flatnonzero(weights.any(axis=0))
    part = slice(int(columns[0]), int(columns[-1]) + 1)
    return weights[:, part], part


def _pieces(nodes: Nodes, places: Array) -> tuple[Array, Array, Array]:
    """Return positions scaled to [0, 1], the breaks of the spline pieces, and their coefficients.

    Coefficients [piece][power][node] are the weight of node ``piece + node``, a polynomial of the position in the
    piece.
    """
    if nodes.count == 1:
        return np.zeros(places.shape), np.array([0.0, 1.0]), np.ones((1, 1, 1))
    knots, degree = nodes.knots
    count = nodes.count
    splines = scipy.interpolate.BSpline(knots, np.eye(count), degree)
    order = next(order for order in _ORDERS if order > degree)
    breaks = np.ascontiguousarray(knots[degree : count + 1])
    powers = np.zeros((count - degree, order, order))
    for power in range(degree + 1):
        # Taylor coefficients of each spline at the start of a piece, for positions in units of its length.
        derivatives = splines(breaks[:-1], power) * np.diff(breaks)[:, None] ** power / math.factorial(power)
        for piece, weights in enumerate(derivatives):
            powers[piece, power, : degree + 1] = weights[piece : piece + degree + 1]
    return np.clip((places - nodes.first) / (nodes.last - nodes.first), 0.0, 1.0), breaks, powers


def _used_pieces(positions: Array, breaks: Array) -> tuple[Array, int]:
    """Return the breaks of the pieces that contain positions `along`, and the index of the first piece."""
    pieces = len(breaks) - 1
    first, last = (
        int(np.clip(np.searchsorted(breaks, end, side="right") - 1, 0, pieces - 1))
        for end in (positions.min(), positions.max())
    )
    return np.ascontiguousarray(breaks[first : last + 2]), first


def _parabolas(
    weights: Array, nodes: Nodes, x: Array, used_nodes: slice, windows: Values, allowed: float
) -> tuple[NDArray[np.int64], Array, Array, float]:
    """Return (1) each column's tile, (2) node weights at points of parabolas, (3) weights of points, (4) the error.

    Interpolation along y and defocus has weights of sum 1. The error of any window is therefore at most the largest
    error at the nodes of y and defocus.
    """
    count, tiles = len(x), 1
    fractions = np.arange(count) / max(1, count - 1)
    while tiles <= _MAX_TILES:
        node_weights = nodes.weights(x[0] + (x[-1] - x[0]) * np.linspace(0.0, 1.0, 2 * tiles + 1))[:, used_nodes]
        tile = np.minimum((fractions * tiles).astype(np.int64), tiles - 1)
        u = 2.0 * (fractions * tiles - tile) - 1.0
        point_weights = np.stack([0.5 * u * (u - 1.0), 1.0 - u * u, 0.5 * u * (u + 1.0)], axis=1)
        difference = weights - sum(point_weights[:, k, None] * node_weights[2 * tile + k] for k in range(3))
        size = np.abs(difference).sum(axis=1)
        # The error is computed for one column of each tile, the one with the largest error of the weights.
        columns = [int(np.flatnonzero(tile == k)[size[tile == k].argmax()]) for k in np.unique(tile)]
        window_errors = np.tensordot(difference[columns], windows.astype(np.float64, copy=False), axes=(1, 1))
        error = float(np.abs(window_errors).sum(axis=(-2, -1)).max())
        if error <= allowed:
            return tile, node_weights, point_weights, error
        # The error of parabolas is proportional to the cube of the tile width.
        tiles = max(tiles + 1, math.ceil(tiles * (error / allowed) ** (1.0 / 3.0)))
    raise ArithmeticError(f"parabolas in {_MAX_TILES} tiles are not close enough to the windows across the image")
