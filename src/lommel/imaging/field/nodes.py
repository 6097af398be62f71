"""Nodes along an axis, close enough for splines between them, and what a value at any place takes of each."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base.cached import cached_property

MOST = 513
"""Most nodes along one axis."""

UNEVEN = 1.2
"""A spline errs most half-way between nodes, or, near the ends, by at most so much more elsewhere."""

_ENDS = {3: (0.5, 0.8), 5: (0.35, 0.6, 0.8)}
"""Distances near the ends over those elsewhere, by the degree: splines err by five times as much there without."""


@dataclass(frozen=True)
class Nodes:
    """Places along an axis, closer at its ends, and the splines through values at them, not-a-knot.

    Attributes
    ----------
    first, last : float
        The outermost places; the same if there is one only.
    count : int
    degree : int, default 3
        3 or 5, of the splines; of fewer places they are of what degree these allow.
    """

    first: float
    last: float
    count: int
    degree: int = 3

    @property
    def places(self) -> NDArray[np.float64]:
        """Where the nodes are, shape (count,)."""
        return np.asarray(self.first + (self.last - self.first) * self._along)

    @property
    def between(self) -> NDArray[np.float64]:
        """The places half-way, shape (count - 1,)."""
        return np.asarray(0.5 * (self.places[1:] + self.places[:-1]))

    @cached_property
    def _along(self) -> NDArray[np.float64]:
        """Where the nodes are, from 0 to 1."""
        cells, closer = np.ones(max(0, self.count - 1)), _ENDS[self.degree]
        if len(cells) > 2 * len(closer):
            cells[: len(closer)] = closer
            cells[-len(closer) :] = closer[::-1]
        ends = np.concatenate([[0.0], np.cumsum(cells)])
        return np.asarray(ends / max(1.0, ends[-1]))

    @cached_property
    def _spline(self) -> Any:
        """Splines that are 1 at one node and 0 at all others."""
        from scipy.interpolate import make_interp_spline

        return make_interp_spline(self._along, np.eye(self.count), k=min(self.degree, self.count - 1))

    def coefficients(self, values: NDArray[Any], axis: int) -> NDArray[Any]:
        """Return coefficients of splines from values at the nodes, which lie along `axis`.

        Parameters
        ----------
        values : ndarray
        axis : int

        Returns
        -------
        ndarray
            Of the shape of `values`.
        """
        if self.count == 1:
            return values
        return np.moveaxis(np.tensordot(self._spline.c, values, axes=(1, axis)), 0, axis)

    def weights(self, places: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return how much each coefficient counts at some places, which sums to 1.

        Parameters
        ----------
        places : ndarray, shape (n,)
            Between the first and the last node; what is beyond them counts as at these.

        Returns
        -------
        ndarray, shape (n, count)
            At most ``degree + 1`` of a row are not 0.
        """
        return np.ones((len(places), 1)) if self.count == 1 else np.asarray(self._matrix(places).toarray())

    def shares(self, places: NDArray[np.float64]) -> list[tuple[int, NDArray[np.float64]]]:
        """Return the columns of :meth:`weights` that are not 0, each with its number.

        Parameters
        ----------
        places : ndarray
            Of any shape.

        Returns
        -------
        list of (int, ndarray)
            The arrays are of the shape of `places`.
        """
        if self.count == 1:
            return [(0, np.ones(places.shape))]
        matrix, found = self._matrix(places.ravel()).tocsc(), []
        for node in range(self.count):
            part = slice(matrix.indptr[node], matrix.indptr[node + 1])
            if part.stop > part.start:
                column = np.zeros(places.size)
                column[matrix.indices[part]] = matrix.data[part]
                found.append((node, column.reshape(places.shape)))
        return found

    def _matrix(self, places: NDArray[np.float64]) -> Any:
        from scipy.interpolate import BSpline

        along = np.clip((places - self.first) / (self.last - self.first), 0.0, 1.0)
        return BSpline.design_matrix(along, self._spline.t, self._spline.k)

    def finer(self, times: float) -> Nodes:
        """Return nodes that are closer, and at least one more of them.

        Parameters
        ----------
        times : float
            How much smaller their distances are.

        Returns
        -------
        Nodes
        """
        cells = max(1, self.count - 1)
        return replace(self, count=max(self.count, math.ceil(cells * times)) + 1)


def off(one: NDArray[Any], other: NDArray[Any]) -> float:
    """Return the largest sum of absolute differences between windows, which are the last two axes."""
    return float(np.abs(one - other).sum(axis=(-2, -1)).max(initial=0.0))


def enough(
    sample: Callable[[NDArray[np.float64]], NDArray[np.float64]],
    first: float,
    last: float,
    tol: float,
    degree: int = 3,
) -> Nodes | None:
    """Return nodes from `first` to `last` for splines to err by no more than `tol` along some lines.

    Parameters
    ----------
    sample : callable
        From places, shape (n,), to windows at them, shape (lines, n, height, width).
    first, last : float
    tol : float
        Bound on the sum of absolute differences of a window, half-way between nodes.
    degree : int, default 3
        Of the splines.

    Returns
    -------
    Nodes or None
        None if it takes more than :data:`MOST`.
    """
    if first == last:
        return Nodes(first, first, 1, degree)
    nodes = Nodes(first, last, 3, degree)
    known = sample(nodes.places)
    if off(known, known[:, :1]) <= tol:
        return replace(nodes, count=1)

    def over(nodes: Nodes) -> float:
        """Return how far from close enough nodes are, over their distance."""
        made = interpolated(nodes, sample(nodes.places), nodes.between)
        # The error falls by 2^(degree + 1) where nodes are twice as close.
        return float((UNEVEN * off(made, sample(nodes.between)) / tol) ** (1.0 / (degree + 1)))

    while (ratio := over(nodes)) > 1.0:
        nodes = replace(nodes, count=2 * nodes.count - 1)
        if nodes.count > MOST:
            return None
    # They need not be closer than enough.
    fewer = replace(nodes, count=math.ceil((nodes.count - 1) * max(0.5, ratio)) + 1)
    while fewer.count < nodes.count and (ratio := over(fewer)) > 1.0:
        fewer = replace(fewer, count=max(fewer.count + 1, math.ceil((fewer.count - 1) * ratio) + 1))
    return fewer if fewer.count < nodes.count else nodes


def interpolated(nodes: Nodes, values: NDArray[Any], places: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return what splines along the second axis make of values at nodes."""
    made = np.tensordot(nodes.weights(places), nodes.coefficients(values, 1), axes=(1, 1))
    return np.moveaxis(made, 0, 1)
