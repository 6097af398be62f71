"""A window as the core averages it, and the terms of its error in docs/certificate.md 9: for all tests of these."""

from __future__ import annotations

from typing import Any, NamedTuple

import mpmath as mp
import numpy as np
from scipy.special import j0

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


def interpolation(half: float, n: int) -> mp.mpf:
    w = mp.mpf(half)
    bound = 2 * w**n / mp.factorial(n)
    if n > 2 * w:
        eta = mp.acosh(n / (2 * w))
        bound = min(bound, 4 * mp.exp(2 * w * mp.sinh(eta) - n * eta) / (1 - mp.exp(-eta)))
    return bound


def gauss(side: float, q: int) -> mp.mpf:
    a = mp.mpf(side)
    return 2 * mp.mpf(2) ** (2 * q) * a ** (2 * q) * mp.factorial(q) ** 4 / ((2 * q + 1) * mp.factorial(2 * q) ** 3)


def harmonics(side: float, angles: int) -> mp.mpf:
    a = mp.sqrt(2) * mp.mpf(side)
    if 4 * angles <= a:
        return mp.inf
    b = mp.acosh(4 * angles / a)
    return 4 * mp.exp(a * mp.sinh(b) - 4 * angles * b) / (1 - mp.exp(-4 * b))


def lebesgue(n: int) -> mp.mpf:
    return 1 + 2 / mp.pi * mp.log(n)


def fewest(count: int, allowed: mp.mpf, error: Any, side: float) -> bool:
    near = allowed * 1e-9
    return bool(error(side, count) <= allowed + near and (count == 1 or error(side, count - 1) > allowed - near))


def averages(x: np.ndarray, y: np.ndarray, side: float, kappa: float) -> np.ndarray:
    """Return the averages of J0(kappa v) over squares around places."""
    nodes, weights = np.polynomial.legendre.leggauss(24)
    s, w = 0.5 * side * nodes, 0.5 * weights
    far = np.hypot(x[..., None, None] + s, y[..., None, None] + s[:, None])
    return np.einsum("...ab,a,b->...", j0(kappa * far), w, w)
