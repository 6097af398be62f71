"""Nodes along an axis, over the field or over defocus, and splines through the values at them."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import scipy

from lommel.base.arrays import Array, Values
from lommel.base.cached import cached_property

if TYPE_CHECKING:
    from scipy.interpolate import BSpline
    from scipy.sparse import csr_array

MAX_NODES = 513  # largest number of nodes along one axis

ERROR_RATIO = 1.2  # largest error of a spline anywhere / largest error half-way between nodes

# Spacings of the nodes near the ends / spacing elsewhere, by degree of the spline: with equal spacings the errors
# near the ends would be five times as large.
_END_SPACINGS = {3: (0.5, 0.8), 5: (0.35, 0.6, 0.8)}


@dataclass(frozen=True)
class Nodes:
    """Nodes along an axis from `first` to `last`, denser at the ends, and not-a-knot splines through them."""

    first: float
    last: float
    count: int
    degree: int = 3

    @property
    def places(self) -> Array:
        """Positions of the nodes, shape (count,)."""
        return np.asarray(self.first + (self.last - self.first) * self._along)

    @property
    def between(self) -> Array:
        """Positions half-way between nodes, shape (count - 1,)."""
        return np.asarray(0.5 * (self.places[1:] + self.places[:-1]))

    @cached_property
    def _along(self) -> Array:
        """Positions of the nodes on [0, 1]."""
        spacings, end_spacings = np.ones(max(0, self.count - 1)), _END_SPACINGS[self.degree]
        if len(spacings) > 2 * len(end_spacings):
            spacings[: len(end_spacings)] = end_spacings
            spacings[-len(end_spacings) :] = end_spacings[::-1]
        positions = np.concatenate([[0.0], np.cumsum(spacings)])
        return np.asarray(positions / max(1.0, positions[-1]))

    @cached_property
    def _spline(self) -> BSpline:
        """Cardinal splines: 1 at one node and 0 at all others."""
        return scipy.interpolate.make_interp_spline(
            self._along, np.eye(self.count), k=min(self.degree, self.count - 1)
        )

    @property
    def knots(self) -> tuple[Array, int]:
        """Knots from 0 to 1 of the splines, and their degree."""
        return self._spline.t, self._spline.k

    def coefficients(self, values: Values, axis: int) -> Values:
        """Return the coefficients of splines from values at the nodes, which lie along `axis`."""
        if self.count == 1:
            return values
        return np.moveaxis(np.tensordot(self._spline.c, values, axes=(1, axis)), 0, axis)

    def weights(self, places: Array) -> Array:
        """Return the weight of each coefficient at places (n,), shape (n, count), constant beyond the ends."""
        return np.ones((len(places), 1)) if self.count == 1 else np.asarray(self._matrix(places).toarray())

    def nonzero_weights(self, places: Array) -> list[tuple[int, Array]]:
        """Return the nodes with a nonzero weight at any place, each with its weights in the shape of places.

        The weight of a single node is the scalar 1.
        """
        if self.count == 1:
            return [(0, np.ones(()))]
        # Only columns of the sparse matrix with entries are returned: few nodes have nonzero weights.
        matrix = self._matrix(places.ravel()).tocsc()
        nodes = np.flatnonzero(np.diff(matrix.indptr)).tolist()
        return [(node, matrix[:, [node]].toarray().reshape(places.shape)) for node in nodes]

    def _matrix(self, places: Array) -> csr_array:
        """Return the sparse matrix of weights, shape (places, nodes)."""
        positions = np.clip((places - self.first) / (self.last - self.first), 0.0, 1.0)
        return scipy.interpolate.BSpline.design_matrix(positions, self._spline.t, self._spline.k)

    def finer(self, factor: float) -> Nodes:
        """Return nodes with the number of gaps multiplied by `factor`, and at least one more node."""
        gaps = max(1, self.count - 1)
        return replace(self, count=max(self.count, math.ceil(gaps * factor)) + 1)


def window_difference(windows: Values, reference: Values) -> float:
    """Return the largest sum over pixels of absolute differences between two windows (..., side, side)."""
    return float(np.abs(windows - reference).sum(axis=(-2, -1)).max(initial=0.0))


def sufficient_nodes(
    sample: Callable[[Array], Array], first: float, last: float, tol: float, degree: int
) -> Nodes | None:
    """Return nodes whose splines differ from ``sample(places)`` by at most `tol`; None if `MAX_NODES` is not enough.

    `sample` returns windows at places along the axis, shape (lines, places, side, side); see `window_difference`.
    """
    if first == last:
        return Nodes(first, first, 1, degree)
    nodes = Nodes(first, last, 3, degree)
    coarse_windows = sample(nodes.places)
    if window_difference(coarse_windows, coarse_windows[:, :1]) <= tol:
        return replace(nodes, count=1)

    def spacing_ratio(nodes: Nodes) -> float:
        """Return (spacing of the nodes) / (spacing with an error of `tol`)."""
        windows = interpolated(nodes, sample(nodes.places), nodes.between)
        # The error of splines is proportional to spacing^(degree + 1).
        error = ERROR_RATIO * window_difference(windows, sample(nodes.between))
        return float((error / tol) ** (1.0 / (degree + 1)))

    while (ratio := spacing_ratio(nodes)) > 1.0:
        nodes = replace(nodes, count=2 * nodes.count - 1)
        if nodes.count > MAX_NODES:
            return None
    # Doubling may exceed the required number of nodes: reduce the number as far as `tol` allows.
    reduced = replace(nodes, count=math.ceil((nodes.count - 1) * max(0.5, ratio)) + 1)
    while reduced.count < nodes.count and (ratio := spacing_ratio(reduced)) > 1.0:
        reduced = replace(reduced, count=max(reduced.count + 1, math.ceil((reduced.count - 1) * ratio) + 1))
    return reduced if reduced.count < nodes.count else nodes


def interpolated(nodes: Nodes, values: Values, places: Array) -> Array:
    """Return splines through `values`, at `nodes` along the second axis, evaluated at `places` along this axis."""
    result = np.tensordot(nodes.weights(places), nodes.coefficients(values, 1), axes=(1, 1))
    return np.moveaxis(result, 0, 1)
