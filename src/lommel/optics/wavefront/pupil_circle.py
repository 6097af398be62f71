"""The circle of the pupil on the grid of an OPD map: as stated, or from the outline of the samples."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.special import zernike

# An outline is a circle if at most this fraction of its ends of rows and columns contradicts it (vanes, lost
# pixels), and the standard errors of centre and radius are at most this many pixels.
_MAX_CONTRADICTED, _MAX_ERROR = 0.2, 0.25
_TRIM, _STEPS = 3.0, 20
_SHARED = 1.25  # factor of standard errors, since ends of rows are also ends of columns; from 400 drawn circles


class Circle(NamedTuple):
    """Centre and radius, pixels."""

    row: float
    column: float
    radius: float

    def __str__(self) -> str:
        return f"radius={self.radius:.5g} about center=({self.row:.5g}, {self.column:.5g})"

    def coordinates(self, shape: tuple[int, int]) -> tuple[Array, Array]:
        """Return x and y of the pixel centres relative to the centre, divided by the radius."""
        with np.errstate(over="ignore"):  # pixels far outside a tiny pupil; clipped below, so that squares are finite
            sides = [(np.arange(count) - place) / self.radius for count, place in zip(shape, self[:2], strict=True)]
        y, x = np.meshgrid(*(np.clip(side, -1e150, 1e150) for side in sides), indexing="ij")
        return x, y


class Outline(NamedTuple):
    """Circle around samples, and the standard errors of row, column and radius in pixels."""

    circle: Circle
    errors: Array


def stated_circle(
    shape: tuple[int, int], center: tuple[float, float] | None, radius: float | None
) -> tuple[Circle, NDArray[np.bool_]]:
    """Return the circle with the defaults of :func:`lommel.fit_opd`, and which of its values are defaults."""
    height, width = shape
    row, column = ((height - 1) / 2, (width - 1) / 2) if center is None else validation.position("center", center)
    pupil = 0.5 * min(shape) if radius is None else validation.real("radius", radius, above=0.0, unit="pixels")
    return Circle(row, column, pupil), np.array([center is None, center is None, radius is None])


def outline(valid: NDArray[np.bool_], stated: Circle, free: NDArray[np.bool_]) -> Outline | None:
    """Return the circle that the samples fill, None if their outline is not a circle; values not `free` are stated.

    Values are multiples of half a pixel, and exact, if that circle contradicts no pixel more than the best one.
    """
    inside, outside = _ends(valid)
    # Between the last sample and the next pixel the position of the edge is uniformly distributed.
    points, values = 0.5 * (inside + outside), np.array(stated, dtype=np.float64)
    if len(points) < 4 * free.sum():
        return None
    if free[0]:
        values[:2] = 0.5 * (points.min(axis=0) + points.max(axis=0))
    if free[2]:
        values[2] = np.median(np.hypot(*(points - values[:2]).T))
    for _ in range(_STEPS):
        offsets = points - values[:2]
        distances = np.hypot(*offsets.T)
        misfit = distances - values[2]
        near = (np.abs(misfit) <= max(1.0, _TRIM * float(np.median(np.abs(misfit))))) & (distances > 0.0)
        slopes = np.column_stack([offsets[near] / distances[near, None], np.ones(near.sum())])[:, free]
        normal = slopes.T @ slopes
        if len(slopes) < 4 * free.sum() or np.linalg.cond(normal) > 1e6:
            return None
        values[free] += np.linalg.solve(normal, slopes.T @ misfit[near])
    errors = np.zeros(3)
    errors[free] = _SHARED * np.sqrt(np.diag(np.linalg.inv(normal)) * np.mean(misfit[near] ** 2))
    contradicted = _contradicted(values, inside, outside)
    if contradicted > _MAX_CONTRADICTED or errors.max() > _MAX_ERROR or not values[2] > 0.5:
        return None
    halves = np.where(free, np.round(2.0 * values) / 2.0, values)
    if _contradicted(halves, inside, outside) <= contradicted:
        values, errors = halves, np.zeros(3)
        # Of small grids circles that differ by half a pixel may hold the same samples.
        steps = 0.5 * np.concatenate([np.eye(3)[free], -np.eye(3)[free]])
        if any(_contradicted(halves + step, inside, outside) <= contradicted for step in steps):
            return None
    return Outline(Circle(*values.tolist()), errors)


def _ends(valid: NDArray[np.bool_]) -> tuple[Array, Array]:
    """Return the outermost samples of rows and columns, shape (k, 2), and the missing pixels next to them."""
    inside: list[NDArray[np.int64]] = []
    outside: list[NDArray[np.int64]] = []
    for grid, order in ((valid, 1), (valid.T, -1)):
        lines = np.flatnonzero(grid.any(axis=1))
        last = grid.shape[1] - 1
        for ends, step in ((grid[lines].argmax(axis=1), -1), (last - grid[lines, ::-1].argmax(axis=1), 1)):
            kept = (ends + step >= 0) & (ends + step <= last)
            for places, found in ((ends, inside), (ends + step, outside)):
                found.append(np.column_stack([lines, places])[kept, ::order])
    return np.concatenate(inside).astype(np.float64), np.concatenate(outside).astype(np.float64)


def _contradicted(values: Array, inside: Array, outside: Array) -> float:
    """Return the fraction of ends of rows and columns that contradict a circle; samples may lie on it."""
    beyond = np.hypot(*(inside - values[:2]).T) > values[2] * (1.0 + 1e-9)
    within = np.hypot(*(outside - values[:2]).T) < values[2] * (1.0 - 1e-9)
    return float((beyond | within).mean())


def blank_area(clear: NDArray[np.bool_], samples: NDArray[np.bool_]) -> float:
    """Return the fraction of `clear` pixels in areas without samples; not single pixels, thin lines or the rim."""

    def any_near(pixels: NDArray[np.bool_]) -> NDArray[np.bool_]:
        padded = np.pad(pixels, 1)
        return pixels | padded[:-2, 1:-1] | padded[2:, 1:-1] | padded[1:-1, :-2] | padded[1:-1, 2:]

    blank = clear & ~samples
    inner = blank & ~any_near(clear & samples)
    return float((any_near(any_near(inner)) & blank).sum() / clear.sum())


def conversion(terms: list[tuple[int, int]], old: Circle, new: Circle) -> Array:
    """Return the matrix that converts coefficients over one circle to those of the same wavefront over another."""
    highest = max(n for n, _ in terms)
    nodes, weights = np.polynomial.legendre.leggauss(highest + 1)
    angles = np.arange(2 * highest + 2) * (math.pi / (highest + 1))
    rho, theta = (grid.ravel() for grid in np.meshgrid(np.sqrt(0.5 * (nodes + 1.0)), angles, indexing="ij"))
    x = (new.column - old.column + new.radius * rho * np.cos(theta)) / old.radius
    y = (new.row - old.row + new.radius * rho * np.sin(theta)) / old.radius
    mean = np.repeat(0.5 * weights / len(angles), len(angles))
    found = zernike.normalized(terms, rho, theta) * mean
    return np.asarray(found @ zernike.normalized(terms, np.hypot(x, y), np.arctan2(y, x)).T)
