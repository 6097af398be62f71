"""Images from intensities: averages over pixels, and windows mirrored from a quadrant."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.methods.pixels.rule import octant, pixel_rule
from lommel.optics.grid import Grid
from lommel.special.legendre import gauss_legendre
from lommel.traced.namespaces import Namespace, Tables, Tensor

_RULE_ERROR = 1e-11  # of PixelRule over the largest intensity: ten times the largest measured
_MOST_SAMPLES = 24  # a side of each pixel


class Pixels(NamedTuple):
    """Pixel averages and mirrored quadrants: how intensities become images.

    Attributes
    ----------
    height, width : int
    mirrored : bool
        Whether values are those of a quadrant, each at an indexed radius.
    growth : float
        Largest factor by which averages multiply errors; 0 for point samples.
    added : float
        Error of the averages: over the largest intensity of a radial pupil, absolute of any other.
    samples : int
        A side of each pixel, of pupils that are not radial, and of averages off the axis; else 0.
    """

    height: int
    width: int
    mirrored: bool
    growth: float
    added: float
    samples: int = 0

    def means(
        self, ns: Namespace, tables: Tables, values: Tensor, error: Tensor, unit: float
    ) -> tuple[Tensor, Tensor]:
        """Return the averages of intensities over pixels, and bounds on their errors."""
        xp = ns.xp
        if self.samples > 1:
            if "index" in tables:
                values = xp.take(values, tables["index"], axis=-1)
            shape = (self.width, self.samples, self.height, self.samples, values.shape[0])
            values = xp.sum(xp.reshape(xp.permute_dims(values, (1, 0)), shape) * tables["share"], axis=(1, 3))
            error = error + self.added + 2.0 * self.samples**2 * unit * xp.max(ns.stop(values), axis=(0, 1))
            return xp.permute_dims(xp.reshape(values, (-1, values.shape[-1])), (1, 0)), error
        if self.growth:
            most = xp.max(ns.stop(values), axis=-1)
            lost = (values.shape[-1] + 2) * unit + 2.0 * ns.coarseness(unit)
            return ns.matmul(values, tables["matrix"]), self.growth * (error + lost * most) + self.added * most
        return values, error

    def unfold(self, ns: Namespace, tables: Tables, values: Tensor) -> Tensor:
        """Return images ``(n, height, width)`` from values at distinct radii, of cells, or of pixels by columns."""
        xp = ns.xp
        if self.samples:
            by_column = xp.reshape(xp.permute_dims(values, (1, 0)), (self.width, self.height, values.shape[0]))
            return ns.turned(by_column)
        values = xp.take(values, tables["index"], axis=-1)
        if not self.mirrored:
            return xp.reshape(values, (values.shape[0], self.height, self.width))
        down, across = self.height // 2, self.width // 2
        quarter = xp.reshape(values, (values.shape[0], down + 1, across + 1))
        right = quarter[..., : across + 1 - (self.width + 1) % 2]
        half = xp.concat([xp.flip(quarter[..., 1:], axis=-1), right], axis=-1) if across else right
        lower = half[..., : down + 1 - (self.height + 1) % 2, :]
        return xp.concat([xp.flip(half[..., 1:, :], axis=-2), lower], axis=-2) if down else lower


def of_radii(
    grid: Grid, step: float, stretch: float, allowed: float
) -> tuple[Pixels, Array, dict[str, NDArray[Any]]]:
    """Return the pixels of a radial pupil, the radii in v of its samples, and tables.

    `step` is the pitch in v, `stretch` its factor at the shortest wavelength, `allowed` the error of averages.
    """
    height, width = grid.shape
    if grid.integrate and not grid.centered:
        pixels, (rows, cols), shared = of_lattice(grid, step, stretch, allowed)
        radii, index = np.unique(np.hypot(cols[:, None], rows), return_inverse=True)
        return pixels, radii, shared | {"index": _places(index)}
    if grid.integrate:
        half = max(1, height // 2, width // 2)
        rule = pixel_rule(half, step * stretch)
        column, row = octant(half)
        cell = np.empty((half + 1, half + 1), dtype=np.int64)
        cell[row, column] = cell[column, row] = np.arange(row.size)
        used, index = np.unique(cell[: height // 2 + 1, : width // 2 + 1].ravel(), return_inverse=True)
        matrix = np.ascontiguousarray(rule.matrix[:, used])
        pixels = Pixels(height, width, True, float(np.abs(matrix).sum(axis=0).max()), _RULE_ERROR)
        return pixels, step * rule.radii, {"matrix": matrix, "index": _places(index)}
    middle = grid.axis
    down, across = np.arange(height) - middle[0], np.arange(width) - middle[1]
    if grid.centered:
        down, across = down[height // 2 :: -1], across[width // 2 :: -1]
    squares, index = np.unique(down[:, None] ** 2 + across**2, return_inverse=True)
    return Pixels(height, width, grid.centered, 0.0, 0.0), step * np.sqrt(squares), {"index": _places(index)}


def _places(index: NDArray[Any]) -> NDArray[np.int32]:
    return index.ravel().astype(np.int32)


def of_lattice(
    grid: Grid, step: float, stretch: float, allowed: float
) -> tuple[Pixels, tuple[Array, Array], dict[str, NDArray[Any]]]:
    """Return the pixels of any pupil, the rows and columns in v of its samples, and tables."""
    # I(v) = U(v) conj(U(conj(v))) is entire in either coordinate, and at most exp(2 |Im v|) times the square of the
    # amplitude of the pupil. On the ellipse of b round a pixel that is exp(step sinh b), so that p Gauss nodes a side
    # err by at most 2 (32/15) exp(step sinh b - 2 p b) / (1 - exp(-2 b)).
    grid.require_one_axis()
    rows, cols = step / grid.side * grid.y, step / grid.side * grid.x
    if not grid.integrate:
        return Pixels(grid.height, grid.width, False, 0.0, 0.0, 1), (rows, cols), {}
    b = np.linspace(0.05, 5.0, 200)
    for count in range(2, _MOST_SAMPLES + 1):
        exponent = stretch * step * np.sinh(b) - 2.0 * count * b - np.log(-np.expm1(-2.0 * b))
        error = 64.0 / 15.0 * math.exp(min(float(exponent.min()), 600.0))
        if error <= allowed:
            break
    else:
        raise ValueError(
            f"pixel must be smaller where wavefronts depend on the direction: {stretch * step:g} in v is too large"
        )
    nodes, weights = gauss_legendre(count, -0.5 * step, 0.5 * step)
    share = (weights[:, None, None, None] * weights[:, None]) / step**2
    lattice = (rows[:, None] + nodes).ravel(), (cols[:, None] + nodes).ravel()
    return Pixels(grid.height, grid.width, False, 1.0, error, count), lattice, {"share": share}
