"""Obstructions of the aperture: vanes, vignetting, and masks of any transmission.

Lengths are over the radius of the aperture; x rises with the columns of the image, y with the rows, angles are from x
to y. `margin` of a shape is positive where light passes and changes by at most the distance between two points.
"""

from __future__ import annotations

import base64
import hashlib
import math
import sys
import zlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Json
from lommel.base.cached import EqualByContent

MAX_VANES = 64
MAX_SIDE = 8192


@dataclass(frozen=True)
class Spider:
    """Straight vanes from the axis to the edge of the aperture, as of the spider of a secondary mirror.

    A vane blocks the half strip ``abs(across) < width / 2, along > 0`` of its direction; two opposite ones make a
    bar across the aperture. Where vanes overlap, near the axis, light is blocked once.

    Parameters
    ----------
    width : float
        Width of each vane divided by the radius of the aperture, above 0 and below 2.
    angles : sequence of float
        Direction of each vane, radians from x (columns) to y (rows); 1 to 64 of them.

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
        angles = validation.real_array("angles", self.angles)
        if angles.ndim != 1 or not 1 <= angles.size <= MAX_VANES:
            raise ValueError(
                f"angles must be a sequence of 1 to {MAX_VANES} numbers, "
                f"got {validation.shown(self.angles)} of shape {angles.shape}"
            )
        vars(self).update(width=width, angles=tuple(angles.tolist()))

    @classmethod
    def equal(cls, count: int, width: float, first: float = 0.0) -> Spider:
        """Return `count` vanes of a `width` at equal angles from `first`, radians; TypeError or ValueError."""
        number = validation.integer("count", count, least=1, most=MAX_VANES)
        start = validation.real("first", first)
        return cls(width, tuple(start + 2.0 * math.pi * k / number for k in range(number)))

    def margin(self, x: Array, y: Array) -> Array:
        """Return the distance of points (`x`, `y`) from the nearest vane; negative inside one."""
        least = np.full(np.broadcast_shapes(x.shape, y.shape), np.inf)
        for angle in self.angles:
            c, s = math.cos(angle), math.sin(angle)
            np.minimum(least, np.maximum(np.abs(y * c - x * s) - 0.5 * self.width, -(x * c + y * s)), out=least)
        return least

    def to_dict(self) -> Json:
        """Return the vanes in plain types."""
        return {"width": self.width, "angles": list(self.angles)}

    @classmethod
    def from_dict(cls, description: Mapping[str, Any]) -> Spider:
        """Rebuild a spider from a `description` by :meth:`to_dict`."""
        return cls(**description)


@dataclass(frozen=True)
class Ellipse:
    """Elliptical aperture: a simple model of vignetting towards the edge of the field.

    Parameters
    ----------
    a, b : float
        Semi-axes over the radius of the aperture, above 0, at most 1.
    angle : float, default 0
        Direction of the semi-axis a, radians from x to y.

    Raises
    ------
    TypeError, ValueError
        If an argument is not a finite number in range.
    """

    a: float
    b: float
    angle: float = 0.0

    def __post_init__(self) -> None:
        for name in ("a", "b"):
            size = validation.real(name, getattr(self, name), above=0.0, most=1.0, unit="radii of the aperture")
            object.__setattr__(self, name, size)
        object.__setattr__(self, "angle", validation.real("angle", self.angle))

    @property
    def frame(self) -> Array:
        """The matrix from the unit disc to the ellipse, shape (2, 2)."""
        c, s = math.cos(self.angle), math.sin(self.angle)
        return np.array([[self.a * c, -self.b * s], [self.a * s, self.b * c]])

    def margin(self, x: Array, y: Array) -> Array:
        """Return a lower bound on the distance of points (`x`, `y`) from the edge; negative outside the ellipse."""
        c, s = math.cos(self.angle), math.sin(self.angle)
        scaled = np.hypot((x * c + y * s) / self.a, (y * c - x * s) / self.b)
        return np.asarray(min(self.a, self.b) * (1.0 - scaled))

    def to_dict(self) -> Json:
        """Return the ellipse in plain types, with its name."""
        return {"name": "Ellipse", "a": self.a, "b": self.b, "angle": self.angle}


@dataclass(frozen=True)
class CatEye:
    """Cat's-eye vignetting: the overlap of the aperture with a second circle, as at the edge of the field.

    Parameters
    ----------
    shift : (float, float)
        Centre (x, y) of the second circle, over the radius of the aperture.
    radius : float, default 1
        Radius of the second circle relative to that of the aperture; above 0, at most 1000.

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
                f"shift must be shorter than 1 + radius = {1.0 + radius:g}, or the circles do not overlap, "
                f"got {validation.shown(self.shift)}"
            )
        vars(self).update(shift=(x, y), radius=radius)

    def margin(self, x: Array, y: Array) -> Array:
        """Return the distance of points (`x`, `y`) from the edge of the second circle; negative outside of it."""
        return np.asarray(self.radius - np.hypot(x - self.shift[0], y - self.shift[1]))

    def to_dict(self) -> Json:
        """Return the circle in plain types, with its name."""
        return {"name": "CatEye", "shift": list(self.shift), "radius": self.radius}


def vignetting_from_dict(description: Mapping[str, Any]) -> Ellipse | CatEye:
    """Rebuild what `to_dict` of `Ellipse` or `CatEye` describes; ValueError if it is neither."""
    parts = dict(description)
    name = validation.choice("vignetting", parts.pop("name", None), ("Ellipse", "CatEye"))
    return Ellipse(**parts) if name == "Ellipse" else CatEye(**parts)


@dataclass(frozen=True, eq=False)
class Mask(EqualByContent):
    """Amplitude transmission sampled over the square around the aperture: apodizers, segmented mirrors.

    Images are sums over the samples, each weighted by the part of its cell inside the aperture. They repeat at
    ``pi * side`` in v, and a window that a repetition would reach is refused.

    Parameters
    ----------
    values : array_like, shape (side, side)
        Amplitudes from 0 to 1 at the centres ``(2 i + 1 - side) / side`` of the cells of the square [-1, 1] x
        [-1, 1]; rows rise with y, columns with x. side is 2 to 8192.

    Raises
    ------
    TypeError, ValueError
        If the array is not square, holds anything but numbers from 0 to 1, or holds zeros only.

    Examples
    --------
    >>> Mask.sample(lambda x, y: x > 0, side=4).values[0]
    array([0., 0., 1., 1.])
    """

    values: Array
    _digest: bytes = field(init=False, repr=False)

    def __post_init__(self) -> None:
        given = validation.array("values", self.values)
        if given.dtype == np.bool_:
            given = given.astype(np.float64)
        if given.ndim != 2 or given.shape[0] != given.shape[1] or not 2 <= given.shape[0] <= MAX_SIDE:
            raise ValueError(f"values must be a square array with a side of 2 to {MAX_SIDE}, got shape {given.shape}")
        self._keep(np.ascontiguousarray(validation.real_array("values", given, least=0.0)) + 0.0)

    def _keep(self, values: Array) -> None:
        """Keep values of the right shape, >= 0 and finite, without a copy."""
        if values.max() > 1.0:
            raise ValueError(f"values must be from 0 to 1, got {values.max():g}")
        if values.max() == 0.0:
            raise ValueError("values must not be 0 throughout: no light would pass")
        values.flags.writeable = False
        digest = hashlib.sha256(repr(values.shape).encode())
        digest.update(values.data)
        vars(self).update(values=values, _digest=digest.digest())

    @classmethod
    def sample(cls, function: Callable[[Array, Array], ArrayLike], side: int) -> Mask:
        """Return the mask of ``function(x, y)`` at the centres of `side` x `side` cells, `side` from 2 to 8192.

        `function` takes arrays of shapes (1, side) and (side, 1) and returns amplitudes or booleans. TypeError or
        ValueError if it does not, or `side` is out of range.
        """
        n = validation.integer("side", side, least=2, most=MAX_SIDE)
        validation.function("function", function)
        at = cell_centers(n)
        return cls(np.broadcast_to(validation.array("function", function(at[None, :], at[:, None])), (n, n)))

    @property
    def side(self) -> int:
        """Samples along each side."""
        return len(self.values)

    def at(self, x: Array, y: Array) -> Array:
        """Return the amplitude of the cell that each point (`x`, `y`) lies in, 0 outside of the square.

        TypeError or ValueError if these are not real and finite.
        """
        x, y = (np.clip(validation.real_array(name, part), -2.0, 2.0) for name, part in (("x", x), ("y", y)))
        row, column = (np.floor(0.5 * (part + 1.0) * self.side) for part in (y, x))
        # The far edge belongs to the last cell.
        row, column = np.where(y == 1.0, self.side - 1, row), np.where(x == 1.0, self.side - 1, column)
        inside = (row >= 0) & (row < self.side) & (column >= 0) & (column < self.side)
        places = (np.where(inside, part, 0).astype(np.int64) for part in (row, column))
        return np.asarray(np.where(inside, self.values[tuple(places)], 0.0))

    def _content(self) -> bytes:
        """Return a digest of the values."""
        return self._digest

    def __repr__(self) -> str:
        return f"Mask(<{self.side} x {self.side} amplitudes, mean {self.values.mean():.4g}>)"

    def to_dict(self) -> Json:
        """Return the values in plain types: little-endian float64, deflated, as base64."""
        data = zlib.compress(self.values.astype("<f8").tobytes(), 6)
        return {"side": self.side, "values": base64.b64encode(data).decode("ascii")}

    @classmethod
    def from_dict(cls, description: Mapping[str, Any]) -> Mask:
        """Rebuild a mask from a `description` by :meth:`to_dict`; KeyError, TypeError or ValueError if it is none."""
        side = validation.integer("side", description["side"], least=2, most=MAX_SIDE)
        packed = base64.b64decode(description["values"], validate=True)
        # Unpacked in place: with a copy beside it a small file would take a gigabyte.
        values, unpack, at = np.empty((side, side)), zlib.decompressobj(), 0
        place = values.data.cast("B")
        while part := unpack.decompress(packed, 2**20):
            if at + len(part) > len(place):
                raise ValueError(f"values must be {side} x {side}, got more")
            place[at : at + len(part)] = part
            at, packed = at + len(part), unpack.unconsumed_tail
        if at != len(place):
            raise ValueError(f"values must be {side} x {side}, got {at} bytes")
        if sys.byteorder == "big":
            values = values.byteswap()
        if not values.min() >= 0.0:
            raise ValueError(f"values must be >= 0, got {values.min():g}")
        made = object.__new__(cls)
        values += 0.0  # no -0
        made._keep(values)
        return made


def cell_centers(side: int) -> Array:
    """Return the centres of `side` equal cells of [-1, 1]."""
    return (2.0 * np.arange(side) + 1.0 - side) / side
