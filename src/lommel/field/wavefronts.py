"""Wavefronts all over a part of the sensor: between positions that they are known at, or by Seidel's polynomials."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special import zernike

MAX_SCATTERED = 4000
"""Most scattered positions: the interpolation solves a dense system of this size."""

_ROUNDING = 1e-9  # of the size of the map: positions this far outside count as on its edge
_AXIS = 1e-6  # radians that a wavefront on the axis may depend on the direction, from rounding in what made it


class WavefrontsOnSensor(ABC):
    """Wavefronts at any position of a part of the sensor."""

    reach: float
    """Distance from the axis of the farthest position."""

    def contains(self, x: Array, y: Array) -> NDArray[np.bool_]:
        """Return which positions are in the part: of a circle around the axis, if it is no other."""
        return np.asarray(np.hypot(x, y) <= self.reach * (1.0 + _ROUNDING))

    def limits(self, unit: str) -> str:
        """Return what the part is, in words."""
        return f"which reaches {self.reach:.6g} {unit} from the axis"

    @abstractmethod
    def wavefront(self, x: Array, y: Array) -> Wavefront:
        """Return the wavefronts at positions of the part, of their shape."""


class OnGrid(WavefrontsOnSensor):
    """Bicubic splines through a rectangular grid (FITPACK, not-a-knot)."""

    def __init__(self, x: ArrayLike, y: ArrayLike, wavefront: Wavefront) -> None:
        from scipy.interpolate import RectBivariateSpline

        self.x, self.y = _rising("x", x), _rising("y", y)
        values, self.terms = _known(wavefront, (self.y.size, self.x.size), "(len(y), len(x))")
        degrees = {"kx": min(3, self.y.size - 1), "ky": min(3, self.x.size - 1)}
        # Over positions from 0 to 1, because FITPACK compares with absolute tolerances.
        down, across = self._scaled(self.x, self.y)[::-1]
        columns = np.moveaxis(values, -1, 0)
        self.splines = [RectBivariateSpline(down, across, column, **degrees, s=0) for column in columns]
        self.reach = float(np.hypot(np.abs(self.x).max(), np.abs(self.y).max()))

    def _scaled(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Return positions over the extent of the grid, those outside by rounding moved in."""
        pairs = ((x, self.x), (y, self.y))
        across, down = (np.clip((part - k[0]) / (k[-1] - k[0]), 0.0, 1.0) for part, k in pairs)
        return across, down

    def contains(self, x: Array, y: Array) -> NDArray[np.bool_]:
        """Return which positions are in the rectangle."""
        inside = np.ones(x.shape, dtype=np.bool_)
        for part, known in ((x, self.x), (y, self.y)):
            slack = _ROUNDING * (known[-1] - known[0])
            inside &= (part >= known[0] - slack) & (part <= known[-1] + slack)
        return inside

    def limits(self, unit: str) -> str:
        """Return the sides of the rectangle."""
        return f"x from {_span(self.x)} and y from {_span(self.y)} {unit}"

    def wavefront(self, x: Array, y: Array) -> Wavefront:
        """Return the wavefronts, of the shape of x and y."""
        across, down = self._scaled(x, y)
        return Wavefront.trusted(self.terms, np.stack([s.ev(down, across) for s in self.splines], axis=-1))


class Scattered(WavefrontsOnSensor):
    """Cubic radial basis functions with a quadratic (or linear) polynomial, within the convex hull."""

    def __init__(self, x: ArrayLike, y: ArrayLike, wavefront: Wavefront) -> None:
        from scipy.interpolate import RBFInterpolator
        from scipy.spatial import ConvexHull, QhullError

        across, down = validation.real_array("x", x), validation.real_array("y", y)
        if across.ndim != 1 or across.shape != down.shape:
            raise ValueError(f"x and y must be of one shape (n,), got {across.shape} and {down.shape}")
        count = validation.integer("the number of positions", across.size, least=3, most=MAX_SCATTERED)
        values, self.terms = _known(wavefront, (count,), "of x and y")
        order = np.lexsort((down, across))
        same = (np.diff(across[order]) == 0.0) & (np.diff(down[order]) == 0.0)
        if same.any():
            at = order[np.flatnonzero(same)[0]]
            raise ValueError(f"positions must all be different, got ({across[at]:.6g}, {down[at]:.6g}) twice")
        self.x, self.y = across, down
        self.middle = np.array([across.mean(), down.mean()])
        self.size = float(max(np.ptp(across), np.ptp(down)))
        points = self._scaled(across, down)
        try:
            self.edges = ConvexHull(points).equations
        except QhullError:
            raise ValueError(f"positions must not all lie on one line, got {count} that do") from None
        quadratic = np.stack([np.ones(count), *points.T, *points.T**2, points[:, 0] * points[:, 1]], axis=1)
        degree = 2 if np.linalg.matrix_rank(quadratic, tol=1e-6) == 6 else 1
        self.interpolate = RBFInterpolator(points, values, kernel="cubic", degree=degree)
        self.reach = float(np.hypot(across, down).max())

    def _scaled(self, x: Array, y: Array) -> Array:
        return np.asarray((np.stack([x.ravel(), y.ravel()], axis=1) - self.middle) / self.size)

    def contains(self, x: Array, y: Array) -> NDArray[np.bool_]:
        """Return which positions are in the convex hull."""
        beyond = self._scaled(x, y) @ self.edges[:, :2].T + self.edges[:, 2]
        return np.asarray((beyond <= _ROUNDING).all(axis=1).reshape(x.shape))

    def limits(self, unit: str) -> str:
        """Return what the hull spans."""
        x, y = np.sort(self.x), np.sort(self.y)
        return f"the convex hull of {x.size} positions with x from {_span(x)} and y from {_span(y)} {unit}"

    def wavefront(self, x: Array, y: Array) -> Wavefront:
        """Return the wavefronts, of the shape of x and y."""
        values = self.interpolate(self._scaled(x, y))
        return Wavefront.trusted(self.terms, values.reshape(*x.shape, -1))


class Radial(WavefrontsOnSensor):
    """Cubic splines along the height, and rotation: the field of a rotationally symmetric lens."""

    def __init__(self, height: ArrayLike, wavefront: Wavefront, azimuth: float) -> None:
        from scipy.interpolate import CubicSpline

        self.height, self.azimuth = _rising("height", height), validation.real("azimuth", azimuth)
        if self.height[0] != 0.0:
            raise ValueError(f"height must begin with 0, the axis, got {self.height[0]:g}")
        values, self.terms = _known(wavefront, self.height.shape, "of height")
        orders = np.array([m for _, m in self.terms])
        if np.any(np.abs(values[0, orders != 0]) > _AXIS):
            raise ValueError(
                "the wavefront at height 0, on the axis of a rotationally symmetric lens, must not depend on the "
                f"direction, got {validation.shown(wavefront[0])}"
            )
        # Half a turn maps the height to its negative and a term to (-1)^m times itself.
        parity = np.where(orders % 2, -1.0, 1.0)
        middle = np.where(orders == 0, values[:1], 0.0)
        mirrored = np.concatenate([parity * values[:0:-1], middle, values[1:]])
        self.reach = float(self.height[-1])
        scaled = self.height / self.reach
        self.spline = CubicSpline(np.concatenate([-scaled[:0:-1], scaled]), mirrored)

    def wavefront(self, x: Array, y: Array) -> Wavefront:
        """Return the wavefronts, of the shape of x and y."""
        along = self.spline(np.minimum(np.hypot(x, y) / self.reach, 1.0))
        turn = np.arctan2(y, x) - self.azimuth
        turned = zernike.rotated({term: along[..., k] for k, term in enumerate(self.terms)}, turn)
        return Wavefront.from_edge(turned)


class Seidel(WavefrontsOnSensor):
    """Seidel's polynomials of the field and the pupil."""

    def __init__(self, edge: float, waves: Mapping[str, float]) -> None:
        self.reach = validation.real("edge", edge, above=0.0)
        self.waves = {name: validation.real(name, value) for name, value in waves.items()}

    def wavefront(self, x: Array, y: Array) -> Wavefront:
        """Return the wavefronts, of the shape of x and y."""
        made = Wavefront.from_seidel(**self.waves, field=(x / self.reach, y / self.reach))
        # Without a term that depends on the field, a single one stands for all.
        return made if made.shape == x.shape else Wavefront(np.zeros(x.shape)) + made


def _rising(name: str, value: ArrayLike) -> Array:
    array = validation.real_array(name, value)
    if array.ndim != 1 or array.size < 2:
        raise ValueError(f"{name} must be of shape (n,) with n at least 2, got shape {array.shape}")
    steps = np.diff(array)
    if not np.all(steps > 0.0):
        k = int(np.argmin(steps > 0.0))
        raise ValueError(f"{name} must rise, got {array[k]:g} followed by {array[k + 1]:g}")
    return array


def _span(known: Array) -> str:
    return f"{known[0]:.6g} to {known[-1]:.6g}"


def _known(wavefront: Wavefront, shape: tuple[int, ...], what: str) -> tuple[Array, tuple[tuple[int, int], ...]]:
    """Return the coefficients of the terms at the edge, shape ``shape + (k,)``, and (n, m) of each."""
    if validation.instance("wavefront", wavefront, Wavefront).shape != shape:
        raise ValueError(f"wavefront must have the shape {what}, {shape}, got {wavefront.shape}")
    return wavefront.edge, wavefront.terms
