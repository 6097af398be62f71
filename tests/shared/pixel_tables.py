"""A window as the core averages it, and the terms of its error in docs/certificate.md 9: for both tests of these."""

from __future__ import annotations

from typing import NamedTuple

import mpmath as mp
import numpy as np

from lommel import _core

U = mp.mpf(2) ** -53


class Window(NamedTuple):
    height: int
    width: int
    row: float
    column: float
    step: float
    integrate: bool

    @property
    def side(self) -> float:
        return self.step if self.integrate else 0.0

    def distances(self) -> np.ndarray:
        y, x = np.arange(self.height) - self.row, np.arange(self.width) - self.column
        return np.sort(self.step * np.hypot(y[:, None], x).ravel())

    def radii(self, level: int) -> np.ndarray:
        return _core.pixel_radii(*self, level, 1)[0]

    def values(self, level: int, profile: np.ndarray) -> tuple[np.ndarray, mp.mpf]:
        """Return the pixels, and what evaluating their harmonics rounds."""
        out = np.empty((1, self.height, self.width))
        rounded = _core.pixel_values(profile[None], *self[2:], level, 1, out)
        return out[0], mp.mpf(float(rounded[0]))


class Table(NamedTuple):
    error: mp.mpf
    of_nodes: mp.mpf
    of_grid: mp.mpf
    rounding: mp.mpf

    @property
    def magnification(self) -> mp.mpf:
        return self.of_grid * self.of_nodes

    def window(
        self, reach: float, size: float, given: mp.mpf, slope: mp.mpf, swing: mp.mpf, rounded: mp.mpf
    ) -> mp.mpf:
        """Return the bound on the error of the values of a window."""
        places = mp.mpf(reach) * slope * (3 * self.magnification + 6 * self.of_grid + 4)
        return self.magnification * given + self.error * swing + U * (self.rounding * mp.mpf(size) + rounded + places)
