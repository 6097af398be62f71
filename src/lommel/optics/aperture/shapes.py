"""Shapes of apertures: ellipses, convex polygons, and their unions, intersections and differences.

Lengths are divided by the radius of the aperture. x increases with the columns of the image and y with the rows;
angles are measured from x to y. The `margin` of a shape is positive inside, and its gradient is at most 1.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from typing import Any, NamedTuple, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Json
from lommel.base.cached import cached_property
from lommel.core import engine

MAX_VANES = 64
_TURN = 2.0 * math.pi
_MAX_SIZE = 1000.0  # largest radius, semi-axis or coordinate of a shape
_MAX_SHIFT = _MAX_SIZE + 1.0  # largest coordinate of a centre: a disc of the largest radius may reach the aperture
_MAX_CORNERS = 256
_MAX_SEGMENTS = 4096
_MAX_CELL_PARTS = 2**24  # largest number of cells times number of parts in memory at a time
_AREA_ERROR = 1e-10  # error of areas / pi
_INTERSECTION, _UNION, _DIFFERENCE = -1, -2, -3  # codes of the compiled core for intersection, union and difference
_PLANE = np.array([[-2.0, -2.0], [2.0, -2.0], [2.0, 2.0], [-2.0, 2.0]])  # square that contains every aperture
_Part = TypeVar("_Part")
_STEPS = {"&": _INTERSECTION, "|": _UNION, "-": _DIFFERENCE}


class Shape:
    """A region of the pupil plane; ``a | b`` is a union, ``a & b`` an intersection, ``a - b`` a difference."""

    def __or__(self, other: Shape) -> Shape:
        return Combined("|", self, shape("other", other))

    def __and__(self, other: Shape) -> Shape:
        return Combined("&", self, shape("other", other))

    def __sub__(self, other: Shape) -> Shape:
        return Combined("-", self, shape("other", other))

    def margin(self, x: Array, y: Array) -> Array:
        """Return a lower bound on the distance of points (`x`, `y`) from the edge; negative outside."""
        raise NotImplementedError

    def outline(self, points: int) -> list[Array]:
        """Return about this number of `points` (x, y) along the edge of each part, shape (points, 2)."""
        raise NotImplementedError

    def _covered(self, x: Array, y: Array, half: float) -> Array:
        """Return the fraction of cells around (`x`, `y`), as of :func:`covered`, or NaN without a closed form."""
        return np.full(x.shape, np.nan)

    def to_dict(self) -> Json:
        """Return the shape in plain types, with its name."""
        return {"name": type(self).__name__, **asdict(cast("Any", self))}

    @property
    def parts(self) -> tuple[Shape, ...]:
        """Discs, ellipses and polygons that compose the shape."""
        parts: list[Shape] = []
        self._append_to(parts, [])
        return tuple(parts)

    def turned(self, angle: float) -> Shape:
        """Return the shape rotated about the axis by an `angle`, radians from x to y; TypeError or ValueError."""
        return self._rotate(validation.angle("angle", angle))

    def _rotate(self, angle: float) -> Shape:
        raise NotImplementedError

    def _append_to(self, parts: list[Shape], steps: list[int]) -> None:
        """Append the ellipses and polygons of the shape to `parts`, and the postfix operations to `steps`."""
        steps.append(len(parts))
        parts.append(self)


def shape(name: str, value: object) -> Shape:
    """Return `value` if it is a shape; otherwise raise TypeError with the `name` of the argument."""
    if isinstance(value, Shape):
        return value
    raise TypeError(
        f"{name} must be a shape (Disc, Ellipse, Polygon, or a combination), got {validation.shown(value)}"
    )


class Listed(NamedTuple):
    """A region in the layout of the compiled core; see :func:`lommel.core.engine.row_rule`."""

    ellipses: Array  # x, y, semi-axes, angle of each ellipse
    polygons: tuple[Array, ...]  # corners of each part; empty for an ellipse
    steps: tuple[int, ...]  # postfix order: index of a part, or code of an operation

    def rule(self, degree: int, error: float) -> engine.RowRule:
        """Return a rule with at most this `error` for polynomials of a `degree` and modulus <= 1 on the unit disc."""
        return engine.row_rule(self.ellipses, self.polygons, self.steps, degree, error)

    def mapped(self, matrix: Array, shift: Array) -> Listed:
        """Return the image of the region under ``matrix @ point + shift``; the matrix must not mirror."""
        x, y, a, b, angle = self.ellipses.T
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]).transpose(2, 0, 1)
        # The image of the unit circle under a matrix has the singular values as semi-axes, and the left singular
        # vectors as axes.
        axes, sizes, _ = np.linalg.svd(matrix @ turn * np.stack([a, b], axis=-1)[:, None, :])
        centers = np.stack([x, y], axis=-1) @ matrix.T + shift
        ellipses = np.column_stack([centers, sizes, np.arctan2(axes[:, 1, 0], axes[:, 0, 0])])
        return self._replace(
            ellipses=ellipses,
            polygons=tuple(corners @ matrix.T + shift if len(corners) else corners for corners in self.polygons),
        )

    def combined(
        self,
        parts: Sequence[_Part],
        intersect: Callable[[_Part, _Part], _Part],
        unite: Callable[[_Part, _Part], _Part],
        subtract: Callable[[_Part, _Part], _Part],
    ) -> _Part:
        """Combine values of the parts by the given operations, as the region combines the parts."""
        # Postfix order: operands first, then the operation on the last two operands.
        operations, stack = {_INTERSECTION: intersect, _UNION: unite, _DIFFERENCE: subtract}, []
        for step in self.steps:
            if step >= 0:
                stack.append(parts[step])
            else:
                second = stack.pop()
                stack.append(operations[step](stack.pop(), second))
        return stack.pop()

    def reduced(self, pattern: Sequence[int]) -> Listed:
        """Return the region without the parts that cover none or all of a cell; `pattern`: coverage by each part."""
        stack: list[int | list[int]] = []
        for step in self.steps:
            if step >= 0:
                stack.append([step] if pattern[step] == _CUT else pattern[step])
                continue
            second, first = stack.pop(), stack.pop()
            if step == _DIFFERENCE and isinstance(second, int):
                # a - b = a and not b: a constant b is replaced by its complement.
                second, step = _FULL - second, _INTERSECTION
            # A constant operand may determine the result: a union with everything, an intersection with nothing.
            decisive = _FULL if step == _UNION else _NONE
            if decisive in (first, second):
                stack.append(decisive)
            elif isinstance(second, int):
                stack.append(first)
            elif isinstance(first, int) and step != _DIFFERENCE:
                stack.append(second)
            else:
                # "Everything minus a cut part" requires a first operand: the plane, as an additional polygon.
                stack.append([*([len(pattern)] if isinstance(first, int) else first), *second, step])
        steps = cast("list[int]", stack.pop())
        used_parts = sorted({step for step in steps if step >= 0})
        polygons = (*self.polygons, _PLANE)
        ellipse_indices = np.cumsum([len(corners) == 0 for corners in polygons]) - 1
        return Listed(
            self.ellipses[[ellipse_indices[part] for part in used_parts if len(polygons[part]) == 0]],
            tuple(polygons[part] for part in used_parts),
            tuple(used_parts.index(step) if step >= 0 else step for step in steps),
        )

    def __and__(self, other: Listed) -> Listed:
        """Return the intersection of two regions."""
        other_steps = tuple(step + len(self.polygons) if step >= 0 else step for step in other.steps)
        return Listed(
            np.concatenate([self.ellipses, other.ellipses]),
            self.polygons + other.polygons,
            (*self.steps, *other_steps, _INTERSECTION),
        )


# Coverage of a cell by a part, ordered: an intersection is the minimum, and a union the maximum.
_NONE, _CUT, _FULL = 0, 1, 2


def covered(region: Shape, x: Array, y: Array, half: float) -> Array:
    """Return the fraction of square cells that a region covers, exact up to rounding.

    Parameters
    ----------
    region : Shape
    x, y : ndarray, shape (n,)
        Centres of the cells.
    half : float
        Half of the side of the cells.
    """
    parts = region.parts
    # Computation in bands of cells limits the memory.
    if x.size * len(parts) > _MAX_CELL_PARTS and x.size > 1:
        pieces = -(-x.size * len(parts) // _MAX_CELL_PARTS)
        bands = zip(np.array_split(x, pieces), np.array_split(y, pieces), strict=True)
        return np.concatenate([covered(region, *band, half) for band in bands])
    layout, reach = listed(region), math.sqrt(2.0) * half * (1.0 + 1e-9)
    # An edge that is farther from the centre of a cell than the corners of the cell does not cross the cell.
    margins = (part.margin(x, y) for part in parts)
    coverage = np.array([np.where(m > reach, _FULL, np.where(m < -reach, _NONE, _CUT)) for m in margins], np.int8)
    state = layout.combined(list(coverage), np.minimum, np.maximum, lambda a, b: np.minimum(a, _FULL - b))
    fraction: Array = np.where(state == _FULL, 1.0, 0.0)
    cut = np.flatnonzero(state == _CUT)
    if not cut.size:
        return fraction
    # Cells with equal coverage by each part share one reduced region.
    patterns, index = np.unique(coverage[:, cut], axis=1, return_inverse=True)
    square = half * np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    for k, pattern in enumerate(patterns.T):
        cells = cut[index == k]
        if (pattern == _CUT).sum() == 1:
            # One part cuts these cells: what it covers is clear, or blocked.
            part = int(np.flatnonzero(pattern == _CUT)[0])
            whole = layout.combined(
                list(np.where(pattern == _CUT, _FULL, pattern)), min, max, lambda a, b: min(a, _FULL - b)
            )
            own = parts[part]._covered(x[cells], y[cells], half)
            fraction[cells] = own if whole == _FULL else 1.0 - own
            cells = cells[np.isnan(own)]
        remainder = layout.reduced(pattern.tolist())
        for i in cells:
            cell = Listed(np.zeros((0, 5)), (np.add(square, (x[i], y[i])),), (0,))
            fraction[i] = (cell & remainder).rule(0, 1e-17).weight * math.pi / (4.0 * half * half)
    return np.asarray(np.clip(fraction, 0.0, 1.0))


def listed(region: Shape) -> Listed:
    """Return a region in the layout of the compiled core."""
    parts: list[Shape] = []
    steps: list[int] = []
    region._append_to(parts, steps)
    ellipses = [
        (*part.center, part.radius, part.radius, 0.0)
        if isinstance(part, Disc)
        else (*part.center, part.a, part.b, part.angle)
        for part in parts
        if isinstance(part, Disc | Ellipse)
    ]
    polygons = (np.array(part.corners if isinstance(part, Polygon) else ()) for part in parts)
    return Listed(np.array(ellipses).reshape(-1, 5), tuple(polygons), tuple(steps))


def _point(name: str, value: ArrayLike) -> tuple[float, float]:
    if not isinstance(value, tuple | list | np.ndarray) or validation.array(name, value).shape != (2,):
        raise TypeError(f"{name} must be a pair (x, y), got {validation.shown(value)}")
    x, y = (validation.real(f"{name}[{i}]", part, least=-_MAX_SHIFT, most=_MAX_SHIFT) for i, part in enumerate(value))
    return x, y


def _rotate_point(point: tuple[float, float], angle: float) -> tuple[float, float]:
    c, s = math.cos(angle), math.sin(angle)
    return c * point[0] - s * point[1], s * point[0] + c * point[1]


@dataclass(frozen=True)
class Combined(Shape):
    """The union (`kind` "|"), the intersection ("&") or the difference ("-") of two shapes."""

    kind: str
    first: Shape
    second: Shape

    def margin(self, x: Array, y: Array) -> Array:
        """Return a lower bound on the distance of points (`x`, `y`) from the edge; negative outside."""
        a, b = self.first.margin(x, y), self.second.margin(x, y)
        return np.asarray(np.maximum(a, b) if self.kind == "|" else np.minimum(a, b if self.kind == "&" else -b))

    def outline(self, points: int) -> list[Array]:
        """Return points along the edges of both shapes."""
        return self.first.outline(points) + self.second.outline(points)

    def _rotate(self, angle: float) -> Shape:
        return Combined(self.kind, self.first._rotate(angle), self.second._rotate(angle))

    def to_dict(self) -> Json:
        """Return both shapes in plain types."""
        return {"name": self.kind, "first": self.first.to_dict(), "second": self.second.to_dict()}

    def _append_to(self, parts: list[Shape], steps: list[int]) -> None:
        self.first._append_to(parts, steps)
        self.second._append_to(parts, steps)
        steps.append(_STEPS[self.kind])


@dataclass(frozen=True)
class Ellipse(Shape):
    """Ellipse; as `vignetting` of a pupil, a simple model of vignetting towards the edge of the field.

    Parameters
    ----------
    a, b : float
        Semi-axes divided by the radius of the aperture, above 0, at most 1000.
    angle : float, default 0
        Direction of the semi-axis a, radians from x to y.
    center : (float, float), default (0, 0)
        Centre (x, y) divided by the radius of the aperture.

    Raises
    ------
    TypeError, ValueError
        If an argument is not a finite number in range.
    """

    a: float
    b: float
    angle: float = 0.0
    center: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        for name in ("a", "b"):
            size = validation.real(name, getattr(self, name), above=0.0, most=_MAX_SIZE, unit="radii of the aperture")
            object.__setattr__(self, name, size)
        angle, center = validation.angle("angle", self.angle), _point("center", self.center)
        vars(self).update(angle=angle, center=center)

    def margin(self, x: Array, y: Array) -> Array:
        """Return a lower bound on the distance of points (`x`, `y`) from the edge; negative outside the ellipse."""
        # Scaling to the unit circle multiplies distances by at most 1 / min(a, b), hence a lower bound.
        c, s, x, y = math.cos(self.angle), math.sin(self.angle), x - self.center[0], y - self.center[1]
        scaled = np.hypot((x * c + y * s) / self.a, (y * c - x * s) / self.b)
        return np.asarray(min(self.a, self.b) * (1.0 - scaled))

    def outline(self, points: int) -> list[Array]:
        """Return points along the edge."""
        t = np.arange(points) * (2.0 * math.pi / points)
        u, v, c, s = self.a * np.cos(t), self.b * np.sin(t), math.cos(self.angle), math.sin(self.angle)
        return [np.stack([self.center[0] + c * u - s * v, self.center[1] + s * u + c * v], axis=-1)]

    def _rotate(self, angle: float) -> Shape:
        return Ellipse(self.a, self.b, math.fmod(self.angle + angle, _TURN), _rotate_point(self.center, angle))

    def to_dict(self) -> Json:
        """Return the ellipse in plain types, with its name."""
        return {name: value for name, value in super().to_dict().items() if value != (0.0, 0.0)}


@dataclass(frozen=True)
class Disc(Shape):
    """Disc, with any centre.

    Parameters
    ----------
    radius : float, default 1
        Radius divided by the radius of the aperture; above 0, at most 1000.
    center : (float, float), default (0, 0)
        Centre (x, y) divided by the radius of the aperture.

    Raises
    ------
    TypeError, ValueError
        If an argument is not a finite number in range.
    """

    radius: float = 1.0
    center: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        radius = validation.real("radius", self.radius, above=0.0, most=_MAX_SIZE)
        vars(self).update(radius=radius, center=_point("center", self.center))

    def margin(self, x: Array, y: Array) -> Array:
        """Return the distance of points (`x`, `y`) from the edge; negative outside."""
        return np.asarray(self.radius - np.hypot(x - self.center[0], y - self.center[1]))

    def _covered(self, x: Array, y: Array, half: float) -> Array:
        x, y = x - self.center[0], y - self.center[1]
        return disk_overlap(self.radius, x - half, x + half, y - half, y + half) / (4.0 * half * half)

    def outline(self, points: int) -> list[Array]:
        """Return points along the edge."""
        t = np.arange(points) * (2.0 * math.pi / points)
        return [np.array(self.center) + self.radius * np.stack([np.cos(t), np.sin(t)], axis=-1)]

    def _rotate(self, angle: float) -> Shape:
        return Disc(self.radius, _rotate_point(self.center, angle))


@dataclass(frozen=True)
class Polygon(Shape):
    """Convex polygon; other polygons are unions or differences of convex polygons.

    Parameters
    ----------
    corners : sequence of (float, float)
        Corners (x, y) divided by the radius of the aperture, in either sense of rotation; 3 to 256 corners.

    Raises
    ------
    TypeError, ValueError
        If corners are not 3 to 256 pairs of numbers within 1000, lie on a line or are not convex.

    Examples
    --------
    >>> Polygon.regular(6, radius=0.5).corners[0]
    (0.5, 0.0)
    """

    corners: tuple[tuple[float, float], ...]

    def __post_init__(self) -> None:
        array = validation.real_array("corners", self.corners)
        if array.ndim != 2 or array.shape[1] != 2 or not 3 <= len(array) <= _MAX_CORNERS:
            raise ValueError(
                f"corners must be 3 to {_MAX_CORNERS} pairs (x, y), got {validation.shown(self.corners)} "
                f"of shape {array.shape}"
            )
        if np.abs(array).max() > _MAX_SIZE:
            raise ValueError(f"corners must be within {_MAX_SIZE:g} radii of the axis, got {np.abs(array).max():g}")
        edge = np.roll(array, -1, axis=0) - array
        next_edge = np.roll(edge, -1, axis=0)
        turn = edge[:, 0] * next_edge[:, 1] - edge[:, 1] * next_edge[:, 0]
        length = np.hypot(*edge.T)
        # At corners on a straight side, `turn` is a rounding error.
        tolerance = 1e-12 * length * np.roll(length, -1)
        sign = math.copysign(1.0, turn.sum())
        # A convex polygon turns in one direction, and once around.
        total = np.arctan2(turn, (edge * next_edge).sum(axis=1)).sum()
        line = np.all(np.abs(turn) <= tolerance)
        if length.min() < 1e-12 or line or np.any(sign * turn < -tolerance) or abs(abs(total) - 2.0 * math.pi) > 1e-6:
            raise ValueError(
                "corners must be the corners of a convex polygon, not on a line, in order and without repetition; "
                f"join convex polygons by |, got {validation.shown(self.corners)}"
            )
        # Stored counter-clockwise, as margin() requires.
        object.__setattr__(self, "corners", tuple((float(x), float(y)) for x, y in array[:: int(sign)]))

    @classmethod
    def regular(
        cls, sides: int, radius: float, center: tuple[float, float] = (0.0, 0.0), angle: float = 0.0
    ) -> Polygon:
        """Return a regular polygon of `sides` corners at `radius` from `center`, the first one at the `angle`.

        TypeError or ValueError if an argument is out of range.
        """
        count = validation.integer("sides", sides, least=3, most=_MAX_CORNERS)
        size, start = validation.real("radius", radius, above=0.0, most=_MAX_SIZE), validation.angle("angle", angle)
        x, y = _point("center", center)
        t = [start + 2.0 * math.pi * k / count for k in range(count)]
        return cls(tuple((x + size * math.cos(a), y + size * math.sin(a)) for a in t))

    @classmethod
    def strip(cls, start: tuple[float, float], end: tuple[float, float], width: float) -> Polygon:
        """Return the rectangle of a `width` around the line from `start` to `end`, as of a vane.

        TypeError or ValueError if the points are invalid or too close, or the width is not above 0.
        """
        (x, y), (u, v) = _point("start", start), _point("end", end)
        length, size = math.hypot(u - x, v - y), validation.real("width", width, above=0.0, most=_MAX_SIZE)
        if length < 1e-9:
            raise ValueError(f"end must differ from start, got {start} and {end}")
        p, q = 0.5 * size * (y - v) / length, 0.5 * size * (u - x) / length
        return cls(((x + p, y + q), (x - p, y - q), (u - p, v - q), (u + p, v + q)))

    @classmethod
    def half_plane(cls, angle: float, offset: float = 0.0) -> Polygon:
        """Return the half plane of points whose coordinate in the direction `angle` is at most `offset`.

        ``half_plane(0.0, 0.2)`` as a `stop` transmits x <= 0.2: a knife edge that enters from large x. TypeError or
        ValueError if `offset` is not from -2 to 2.
        """
        turn, limit = validation.angle("angle", angle), validation.real("offset", offset, least=-2.0, most=2.0)
        # A square that extends beyond the aperture for every offset: only one side of it crosses the aperture.
        far = 4.0
        corners = ((limit, -far), (limit, far), (-far, far), (-far, -far))
        return cls(tuple(_rotate_point(corner, turn) for corner in corners))

    @property
    def center(self) -> tuple[float, float]:
        """Mean of the corners."""
        x, y = np.mean(self.corners, axis=0)
        return float(x), float(y)

    def margin(self, x: Array, y: Array) -> Array:
        """Return a lower bound on the distance of points (`x`, `y`) from the edge; negative outside."""
        least = np.full(np.broadcast_shapes(np.shape(x), np.shape(y)), np.inf)
        for (px, py), (qx, qy) in zip(self.corners, (*self.corners[1:], self.corners[0]), strict=True):
            length = math.hypot(qx - px, qy - py)
            # Signed distance to the line of each side; the smallest one is, inside the polygon, the distance to the
            # edge.
            np.minimum(least, ((qx - px) / length) * (y - py) - ((qy - py) / length) * (x - px), out=least)
        return least

    def _covered(self, x: Array, y: Array, half: float) -> Array:
        # Cells that one side cuts: the fraction on one side of a line is linear in its distance from the middle, but
        # where the line cuts off a corner.
        fraction, cuts = np.ones(x.shape), np.zeros(x.shape, np.intp)
        for (px, py), (qx, qy) in zip(self.corners, (*self.corners[1:], self.corners[0]), strict=True):
            length = math.hypot(qx - px, qy - py)
            a, b = half * abs(qy - py) / length, half * abs(qx - px) / length
            inside = ((qx - px) / length) * (y - py) - ((qy - py) / length) * (x - px)
            near = np.minimum(np.abs(inside), a + b)
            corner = (a + b - near) ** 2 / max(8.0 * a * b, 1e-300)
            less = np.where(near > abs(a - b), corner, 0.5 - 0.5 * near / max(a, b))
            fraction = np.minimum(fraction, np.where(inside > 0.0, 1.0 - less, less))
            cuts += np.abs(inside) < a + b
        return np.where(cuts > 1, np.nan, fraction)

    def outline(self, points: int) -> list[Array]:
        """Return points along the edge, including the corners."""
        corners = np.array(self.corners)
        t = np.linspace(0.0, 1.0, max(2, points // len(corners)), endpoint=False)[:, None, None]
        return [(corners + t * (np.roll(corners, -1, axis=0) - corners)).reshape(-1, 2)]

    def _rotate(self, angle: float) -> Shape:
        return Polygon(tuple(_rotate_point(corner, angle) for corner in self.corners))


@dataclass(frozen=True)
class Spider(Shape):
    """Straight vanes from the axis to the edge of the aperture, as of the spider of a secondary mirror.

    All vanes have one width and start at the axis. For other vanes, which miss the axis or differ in width, subtract
    :meth:`lommel.Polygon.strip` from a stop: ``Pupil(stop=Disc() - Polygon.strip((0.1, 0), (2, 1), 0.01))``.

    A vane blocks the half strip ``abs(across) < width / 2, along > 0`` of its direction; two opposite vanes make a
    bar across the aperture. Vanes may overlap near the axis.

    Parameters
    ----------
    width : float
        Width of each vane divided by the radius of the aperture, above 0 and below 2.
    angles : sequence of float
        Direction of each vane, radians from x (columns) to y (rows); 1 to 64 vanes.

    Raises
    ------
    TypeError, ValueError
        If the width or an angle is not a finite number in range.

    Examples
    --------
    >>> Spider.equal(4, width=0.02).angles[:2]
    (0.0, 1.5707963267948966)
    """

    width: float
    angles: tuple[float, ...]

    def __post_init__(self) -> None:
        width = validation.real("width", self.width, above=0.0, below=2.0)
        angles = validation.angles("angles", self.angles)
        if angles.ndim != 1 or not 1 <= angles.size <= MAX_VANES:
            raise ValueError(
                f"angles must be a sequence of 1 to {MAX_VANES} numbers, "
                f"got {validation.shown(self.angles)} of shape {angles.shape}"
            )
        vars(self).update(width=width, angles=tuple(angles.tolist()))

    @classmethod
    def equal(cls, count: int, width: float, first: float = 0.0) -> Spider:
        """Return `count` vanes of equal `width` at equal angles from `first`, radians; TypeError or ValueError."""
        number = validation.integer("count", count, least=1, most=MAX_VANES)
        start = validation.angle("first", first)
        return cls(width, tuple(math.fmod(start, _TURN) + _TURN * k / number for k in range(number)))

    def vanes(self) -> tuple[Shape, ...]:
        """Return each vane, from the axis to beyond the rim."""
        ends = ((3.0 * math.cos(angle), 3.0 * math.sin(angle)) for angle in self.angles)
        return tuple(Polygon.strip((0.0, 0.0), end, self.width) for end in ends)

    def margin(self, x: Array, y: Array) -> Array:
        """Return a lower bound on the distance of points (`x`, `y`) from the edges; negative outside of the vanes."""
        largest = np.full(np.broadcast_shapes(np.shape(x), np.shape(y)), -np.inf)
        for angle in self.angles:
            c, s = math.cos(angle), math.sin(angle)
            np.maximum(largest, np.minimum(0.5 * self.width - np.abs(y * c - x * s), x * c + y * s), out=largest)
        return largest

    def outline(self, points: int) -> list[Array]:
        """Return points along the edges."""
        return [line for vane in self.vanes() for line in vane.outline(points)]

    def _rotate(self, angle: float) -> Shape:
        return Spider(self.width, tuple(math.fmod(direction + angle, _TURN) for direction in self.angles))

    def _append_to(self, parts: list[Shape], steps: list[int]) -> None:
        for i, vane in enumerate(self.vanes()):
            vane._append_to(parts, steps)
            steps += [_UNION] if i else []


@dataclass(frozen=True)
class CatEye(Shape):
    """Cat's-eye vignetting: the intersection of the aperture with a second circle, as at the edge of the field.

    Parameters
    ----------
    shift : (float, float)
        Centre (x, y) of the second circle, divided by the radius of the aperture.
    radius : float, default 1
        Radius of the second circle divided by the radius of the aperture; above 0, at most 1000.

    Raises
    ------
    TypeError, ValueError
        If an argument is not a finite number in range, or if the two circles do not overlap.
    """

    shift: tuple[float, float]
    radius: float = 1.0

    def __post_init__(self) -> None:
        pair = isinstance(self.shift, tuple | list | np.ndarray)
        if not pair or validation.array("shift", self.shift).shape[:1] != (2,):
            raise TypeError(f"shift must be a pair (x, y), got {validation.shown(self.shift)}")
        x, y = (validation.real(f"shift[{i}]", part) for i, part in enumerate(self.shift))
        radius = validation.real("radius", self.radius, above=0.0, below=1000.0 + 1e-9)
        if math.hypot(x, y) >= 1.0 + radius:
            raise ValueError(
                f"shift must be shorter than 1 + radius = {1.0 + radius:g}, since the circles must overlap, "
                f"got {validation.shown(self.shift)}"
            )
        vars(self).update(shift=(x, y), radius=radius)

    def margin(self, x: Array, y: Array) -> Array:
        """Return the distance of points (`x`, `y`) from the edge of the second circle; negative outside of it."""
        return np.asarray(self.radius - np.hypot(x - self.shift[0], y - self.shift[1]))

    @property
    def disc(self) -> Disc:
        """The second circle."""
        return Disc(self.radius, self.shift)

    def outline(self, points: int) -> list[Array]:
        """Return points along the edge of the second circle."""
        return self.disc.outline(points)

    def _rotate(self, angle: float) -> Shape:
        return CatEye(_rotate_point(self.shift, angle), self.radius)

    def _append_to(self, parts: list[Shape], steps: list[int]) -> None:
        self.disc._append_to(parts, steps)


@dataclass(frozen=True)
class Segments:
    """Segments of a mirror, each a shape with its own phase.

    ``segments - a`` are the segments without the shape a, such as the vanes in front of them; ``segments & a`` are
    the parts within it. Segments that vanish are dropped with their phases.

    Parameters
    ----------
    shapes : sequence of Shape
        The segments, 1 to 4096 shapes. A :class:`Pupil` raises ValueError for segments that overlap or lie wholly
        beyond its rim; parts of a segment beyond the rim transmit no light.
    piston, tip, tilt : sequence of float, optional
        Phase of each segment in radians (2 pi are a wavelength of path): at the centre of the segment, and its slopes
        along x and y per radius of the aperture. 0 by default.

    Raises
    ------
    TypeError, ValueError
        If arguments are not shapes and finite numbers.

    Examples
    --------
    >>> len(Segments.hexagonal(rings=2, gap=0.01).shapes)
    18
    """

    shapes: tuple[Shape, ...]
    piston: tuple[float, ...] = ()
    tip: tuple[float, ...] = ()
    tilt: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        if not isinstance(self.shapes, Sequence) or not 1 <= len(self.shapes) <= _MAX_SEGMENTS:
            raise ValueError(f"shapes must be 1 to {_MAX_SEGMENTS} shapes, got {validation.shown(self.shapes)}")
        shapes = tuple(shape(f"shapes[{i}]", part) for i, part in enumerate(self.shapes))
        vars(self).update(shapes=shapes)
        for name in ("piston", "tip", "tilt"):
            array = validation.real_array(name, getattr(self, name))
            if array.size and array.shape != (len(shapes),):
                raise ValueError(f"{name} must have one number for each of {len(shapes)} segments, got {array.shape}")
            vars(self)[name] = tuple(array.tolist()) if array.size else (0.0,) * len(shapes)

    @classmethod
    def hexagonal(cls, rings: int, gap: float = 0.0, *, middle: bool = False, angle: float = 0.0) -> Segments:
        """Return equal hexagons in `rings` around the axis, with the farthest corners on the rim of the aperture.

        The order of `shapes`, :attr:`centers` and phases is by columns of increasing x, and by increasing y within a
        column, before the rotation by `angle`.

        Parameters
        ----------
        rings : int
            Number of rings, 1 to 32, of 6, 12, 18, ... hexagons; 2 for JWST, 3 for Keck.
        gap : float, default 0
            Gap between neighbours, divided by the radius of the aperture.
        middle : bool, default False
            True for a hexagon on the axis.
        angle : float, default 0
            Rotation of all hexagons, radians from x to y. At 0 some sides are parallel to x.

        Returns
        -------
        Segments

        Raises
        ------
        TypeError, ValueError
            If an argument is out of range, or if the gap leaves no segment.
        """
        count, spacing = validation.integer("rings", rings, least=1, most=32), validation.real("gap", gap, least=0.0)
        has_center, rotation = validation.truth("middle", middle), validation.angle("angle", angle)
        # Centres a e_1 + b e_2 of a lattice of spacing 1, with hexagons of the inner radius (1 - gap) / 2.
        places = [
            (a * math.sqrt(0.75), b + 0.5 * a)
            for a in range(-count, count + 1)
            for b in range(-count, count + 1)
            if abs(a + b) <= count and (has_center or a or b)
        ]

        max_gap = 1.0 / count
        if spacing > (1.0 - 1e-9) * max_gap:
            raise ValueError(
                f"gap must leave some area of the segments: with rings={count} it must be below {max_gap:.4g}, "
                f"got {spacing:g}"
            )
        # The farthest corners, 30 degrees beside the direction of a corner of the lattice, lie on the rim:
        # (count p + (p - gap) / 2)^2 + (p - gap)^2 / 12 = 1, a quadratic equation of the pitch p.
        square, linear = (count + 0.5) ** 2 + 1.0 / 12.0, (0.5 * (count + 0.5) + 1.0 / 12.0) * spacing
        pitch = (linear + math.sqrt(linear**2 + square * (1.0 - spacing**2 / 3.0))) / square
        size = (pitch - spacing) / math.sqrt(3.0)
        shapes = (Polygon.regular(6, size, (pitch * x, pitch * y)) for x, y in places)
        return cls(tuple(part.turned(rotation) for part in shapes))

    @cached_property
    def centers(self) -> Array:
        """Centre (x, y) of each segment, to which slopes refer, shape (n, 2): the mean of points on its edge.

        Subtraction of another shape, for example a vane, does not move the centre of a segment.
        """
        return np.array([np.concatenate(_uncut(part).outline(48)).mean(axis=0) for part in self.shapes])

    @cached_property
    def phases(self) -> Array:
        """Phase of each segment extrapolated to the axis, and its slopes along x and y, radians, shape (n, 3)."""
        tip, tilt, centers = np.array(self.tip), np.array(self.tilt), self.centers
        # Slopes refer to the centre of each segment; phases are stored as linear functions about the axis.
        return np.stack([np.array(self.piston) - tip * centers[:, 0] - tilt * centers[:, 1], tip, tilt], axis=-1)

    def phased(
        self, piston: ArrayLike = 0.0, tip: ArrayLike = 0.0, tilt: ArrayLike = 0.0, *, unit: str = "radians"
    ) -> Segments:
        """Return the segments with other `piston`, `tip` and `tilt`: numbers, or one number for each segment.

        The `unit` is "radians" or "waves". TypeError or ValueError if they are not finite or do not match.
        """
        factor = 1.0 if validation.choice("unit", unit, ("radians", "waves")) == "radians" else 2.0 * math.pi
        phases = {"piston": piston, "tip": tip, "tilt": tilt}
        array = [validation.real_array(name, value) for name, value in phases.items()]
        for name, part in zip(phases, array, strict=True):
            if part.shape not in ((), (len(self.shapes),)):
                raise ValueError(
                    f"{name} must be a number, or one for each of {len(self.shapes)} segments, got shape {part.shape}"
                )
        return Segments(
            self.shapes, *(tuple(np.broadcast_to(factor * part, len(self.shapes)).tolist()) for part in array)
        )

    def scaled(self, factor: float) -> Segments:
        """Return the same segments with phases times a `factor`; TypeError or ValueError if it is not finite."""
        value = validation.real("factor", factor)
        return Segments(self.shapes, *(tuple(value * x for x in part) for part in (self.piston, self.tip, self.tilt)))

    def __sub__(self, other: Shape) -> Segments:
        return self._cut(shape("other", other), _difference)

    def __and__(self, other: Shape) -> Segments:
        return self._cut(shape("other", other), _intersection)

    def _cut(self, other: Shape, operation: Callable[[Shape, Shape], Shape | None]) -> Segments:
        """Return the remaining parts of the segments, without segments that vanish."""
        require_reach("other", other)
        rest = [operation(part, other) for part in self.shapes]
        # Margins identify some of the vanished segments, and areas identify the others.
        pairs = zip(rest, self.shapes, strict=True)
        rest = [None if part is not old and part is not None and not _in_rim(part) else part for part, old in pairs]
        indices = [i for i, part in enumerate(rest) if part is not None]
        if not indices:
            raise ValueError(f"other must leave some area of the segments, got {validation.shown(other)}")
        phases = ([part[i] for i in indices] for part in (self.piston, self.tip, self.tilt))
        return Segments(tuple(part for part in rest if part is not None), *map(tuple, phases))

    def margin(self, x: Array, y: Array) -> Array:
        """Return a lower bound on the distance of points (`x`, `y`) from the edges; negative outside."""
        largest = np.full(np.broadcast_shapes(np.shape(x), np.shape(y)), -np.inf)
        for part in self.shapes:
            np.maximum(largest, part.margin(x, y), out=largest)
        return largest

    def to_dict(self) -> Json:
        """Return the segments in plain types, with the name."""
        numbers = {name: list(getattr(self, name)) for name in ("piston", "tip", "tilt") if any(getattr(self, name))}
        return {"name": "Segments", "shapes": [part.to_dict() for part in self.shapes], **numbers}


def _in_rim(part: Shape) -> bool:
    """Return whether a part has points inside the rim of the aperture."""
    return listed(Disc() & part).rule(0, _AREA_ERROR).weight > 0.0


_MAX_MARGIN = 1.5  # largest margin of a part at the axis; with a larger margin its edge is far beyond the rim


def require_reach(name: str, region: Shape) -> None:
    """Raise ValueError if the edge of a part, or the part itself, lies far beyond the rim of the aperture."""
    middle = np.zeros(1)
    for part in region.parts:
        if part.margin(middle, middle)[0] > _MAX_MARGIN:
            raise ValueError(
                f"{name} must be made of parts with edges across the aperture or near its rim, got "
                f"{validation.shown(part)} far around all of it; lengths are divided by the radius of the aperture"
            )
        edge = np.concatenate(part.outline(48))
        if not (edge**2).sum(axis=1).min() < 1.0 and not _in_rim(part):
            raise ValueError(
                f"{name} must be made of parts that reach the aperture, got {validation.shown(part)} wholly beyond "
                "its rim; lengths are divided by the radius of the aperture"
            )


def _uncut(part: Shape) -> Shape:
    """Return a shape before intersections with, and subtractions of, other shapes."""
    return _uncut(part.first) if isinstance(part, Combined) and part.kind != "|" else part


def _margin_bounds(part: Shape, other: Shape) -> tuple[float, float]:
    """Return a lower and an upper bound on the margin of `other` at all points of a `part`."""
    edge = np.concatenate(_uncut(part).outline(48))
    x, y = edge.mean(axis=0)
    # The circle contains the whole part, with 2 % for arcs between points of its edge.
    radius = float(np.hypot(edge[:, 0] - x, edge[:, 1] - y).max()) * 1.02
    margin = float(other.margin(np.array([x]), np.array([y]))[0])
    return margin - radius, margin + radius


def _difference(part: Shape, other: Shape) -> Shape | None:
    """Return a part minus another shape: the same object if they do not overlap, None if no area is left."""
    if isinstance(other, Combined) and other.kind == "|":
        remaining = _difference(part, other.first)
        return None if remaining is None else _difference(remaining, other.second)
    least, most = _margin_bounds(part, other)
    return part if most < 0.0 else None if least > 0.0 else part - other


def _intersection(part: Shape, other: Shape) -> Shape | None:
    """Return a part within another shape: the same object if it is entirely inside, None if it is outside."""
    least, most = _margin_bounds(part, other)
    return None if most < 0.0 else part if least > 0.0 else part & other


_KINDS: dict[str, Callable[..., Shape]] = {
    "Disc": Disc,
    "Ellipse": Ellipse,
    "Polygon": Polygon,
    "CatEye": CatEye,
    "Spider": Spider,
}


def shape_from_dict(description: Json, depth: int = 0) -> Shape | Segments:
    """Rebuild a shape or segments from a `description` by `to_dict`; KeyError, TypeError or ValueError if invalid."""
    parts = dict(description)
    name = validation.choice("name", parts.pop("name", None), (*_KINDS, *_STEPS, "Segments"))
    if depth > 64:
        raise ValueError("shapes must be combined at most 64 deep")
    if name == "Segments":
        listed = [shape("shapes", shape_from_dict(part, depth + 1)) for part in parts.pop("shapes")]
        return Segments(tuple(listed), **parts)
    if name in _STEPS:
        first, second = (shape(key, shape_from_dict(parts[key], depth + 1)) for key in ("first", "second"))
        return Combined(name, first, second)
    return _KINDS[name](**parts)


def disk_overlap(radius: ArrayLike, left: ArrayLike, right: ArrayLike, low: ArrayLike, high: ArrayLike) -> Array:
    """Return the area of ``[left, right] x [low, high]`` inside a disk around the origin.

    Exact to rounding, by inclusion and exclusion of rectangles with one corner at the centre.

    Parameters
    ----------
    radius : array_like
        Radius of the disk, >= 0.
    left, right, low, high : array_like
        Sides of the rectangle, ``left <= right`` and ``low <= high``.

    Returns
    -------
    ndarray
        Area, with the shape to which all arguments broadcast.
    """
    r = np.asarray(radius, dtype=np.float64)
    x0, x1, y0, y1 = (np.asarray(e, dtype=np.float64) for e in (left, right, low, high))
    return _corner(r, x1, y1) - _corner(r, x0, y1) - _corner(r, x1, y0) + _corner(r, x0, y0)


def _corner(r: Array, x: Array, y: Array) -> Array:
    """Return the area of the disk within the rectangle from the origin to (x, y), signed like x y."""
    # A disk that contains the rectangle is replaced by a smaller one, so that squares do not overflow.
    r = np.minimum(r, 2.0 * (np.abs(x) + np.abs(y)))
    a, b = np.minimum(np.abs(x), r), np.minimum(np.abs(y), r)
    # Beyond this x the circle, not the far side of the rectangle, is the boundary.
    crossing = np.minimum(a, np.sqrt((r - b) * (r + b)))
    area = crossing * b + _under_arc(r, a) - _under_arc(r, crossing)
    return np.asarray(np.sign(x) * np.sign(y) * area)


def _under_arc(r: Array, x: Array) -> Array:
    """Return ``int_0^x sqrt(r^2 - s^2) ds``."""
    height = np.sqrt((r - x) * (r + x))
    # The arctangent, since an arcsine would lose half of the digits near x = r.
    return np.asarray(0.5 * (x * height + r * r * np.arctan2(x, height)))
