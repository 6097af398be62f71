"""Positions over a sensor: rows and columns, distances from the axis, and what polynomials are of."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from lommel.base.arrays import Array


@dataclass(frozen=True)
class Sensor:
    """Rows and columns of a sensor, in whose middle the axis is, and its pixel pitch."""

    shape: tuple[int, int]
    pixel: float

    @property
    def axis(self) -> tuple[float, float]:
        """Row and column of the middle."""
        rows, columns = self.shape
        return (rows - 1) / 2.0, (columns - 1) / 2.0

    def positions(self, places: Array) -> tuple[Array, Array]:
        """Return x and y of rows and columns (n, 2)."""
        y, x = ((places[:, i] - self.axis[i]) * self.pixel for i in (0, 1))
        return np.asarray(x), np.asarray(y)

    def relative(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Return positions over the sensor, from -1 to 1."""
        row, column = (part / self.pixel + at for part, at in zip((y, x), self.axis, strict=True))
        v, u = (2.0 * (part + 0.5) / side - 1.0 for part, side in zip((row, column), self.shape, strict=True))
        return np.asarray(u), np.asarray(v)

    def grid(self, count: int) -> tuple[Array, Array]:
        """Return x and y of so many positions from edge to edge."""
        y, x = (
            (np.linspace(-0.5, side - 0.5, count) - at) * self.pixel
            for side, at in zip(self.shape, self.axis, strict=True)
        )
        return np.asarray(x), np.asarray(y)
