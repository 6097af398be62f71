"""Grids of pixels, and the optical coordinate of the pixel centres."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import lru_cache
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Index
from lommel.base.cached import EqualByContent, cached_property
from lommel.core import engine
from lommel.optics.base_pupil import BasePupil

_Number = TypeVar("_Number", bound=np.generic)


@dataclass(frozen=True, init=False, eq=False)
class Grid(EqualByContent):
    """Grid of pixels around the optical axis, square or rectangular.

    Parameters
    ----------
    shape : int or (int, int)
        Side of a square, or height and width, each 1 to 16384.
    pixel : float or (float, float)
        Pixel pitch, or the pitches of rows and columns: metres if the pupil has a wavelength, else units of lambda*N.
    center : (float, float) or (array_like, array_like), optional
        Row and column of the optical axis in pixels, 0 being the centre of the first pixel; by default the centre of
        pixel ``(height // 2, width // 2)``. Arrays, which broadcast, are the axes of the pupils of a stack.
    integrate : bool, default False
        True: values are pixel-integrated. False: they are point-sampled at the pixel centres.
    fill : float or (float, float), default 1
        Fill factor: active fraction of the area of a pixel, around its centre, or active fractions of its height and
        width. Above 0 and at most 1.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Attributes
    ----------
    center : (float, float) or (ndarray, ndarray)
        Read-only arrays of equal shape if there are several axes.
    stack : tuple of int
        Shape of these arrays; ``()`` if all pupils have one axis.
    """

    height: int
    width: int
    pixel: float | tuple[float, float]
    center: tuple[float, float] | tuple[Array, Array]
    integrate: bool
    stack: tuple[int, ...] = field(repr=False)
    fill: tuple[float, float]

    def __init__(
        self,
        shape: int | tuple[int, int],
        pixel: float | tuple[float, float],
        *,
        center: tuple[ArrayLike, ArrayLike] | None = None,
        integrate: bool = False,
        fill: float | tuple[float, float] = 1.0,
    ) -> None:
        height, width = validation.image_shape(shape)
        default_center = (float(height // 2), float(width // 2))
        pitch = validation.pitch("pixel", pixel)
        # The default needs no check: a grid is made for every PSF without a plan.
        fill = (1.0, 1.0) if isinstance(fill, float) and fill == 1.0 else validation.fill("fill", fill)
        center = default_center if center is None else validation.positions("center", center)
        integrate = validation.truth("integrate", integrate)
        if fill != (1.0, 1.0) and not integrate:
            raise ValueError(f"fill must be 1 for pixels that sample their centres, got {fill}; use integrate=True")
        stack = () if isinstance(center[0], float) else center[0].shape
        # Like object.__setattr__ for each field of a frozen dataclass, but in one step, which is faster.
        vars(self).update(height=height, width=width, pixel=pitch, center=center, integrate=integrate, stack=stack)
        vars(self)["fill"] = fill

    def _content(self) -> tuple[object, ...]:
        # Arrays are not hashable, but their bytes are.
        center = tuple(part.tobytes() for part in np.asarray(self.center)) if self.stack else self.center
        return self.height, self.width, self.pixel, self.integrate, self.stack, center, self.fill

    def __getitem__(self, index: Index) -> Grid:
        """Return the grid with a part of the axes, indexed as an array of the shape `stack`."""
        if not self.stack:
            raise TypeError("a grid around one axis cannot be indexed")
        return self._with_center(*(np.asarray(part)[index] for part in self.center))

    def broadcast(self, shape: tuple[int, ...]) -> Grid:
        """Return the grid around the axes broadcast to `shape`."""
        if self.stack == shape:
            return self
        return self._with_center(*(np.broadcast_to(part, shape) for part in self.center))

    def _with_center(self, row: ArrayLike, column: ArrayLike) -> Grid:
        return Grid(self.shape, self.pixel, center=(row, column), integrate=self.integrate, fill=self.fill)

    @property
    def axes(self) -> Array:
        """Row and column of the axis of each pupil, shape (n, 2), or (1, 2) if all pupils have one axis."""
        return np.stack([np.ravel(part) for part in self.center], axis=1)

    @property
    def axis(self) -> tuple[float, float]:
        """The axis of all pupils, as ``center``; ValueError if there are several."""
        self.require_one_axis()
        row, column = self.center
        return float(row), float(column)

    def require_one_axis(self) -> None:
        """Raise ValueError if each pupil has its own axis."""
        if self.stack:
            raise ValueError(
                f"center must be one (row, column) for this method, got arrays of shape {self.stack}; compute each "
                "pupil with its own center, or use NijboerZernike or ChordalGauss for a circular or annular aperture"
            )

    @property
    def sampled(self) -> Grid:
        """The same pixels, point-sampled at their centres."""
        # The fields are checked already.
        grid = object.__new__(Grid)
        vars(grid).update(self._fields() | {"integrate": False})
        return grid

    def _fields(self) -> dict[str, object]:
        return {name: vars(self)[name] for name in ("height", "width", "pixel", "center", "stack", "fill")}

    @property
    def square(self) -> bool:
        """True if pixels are square with a fill factor of 1, as methods require."""
        return isinstance(self.pixel, float) and not self.partly

    @property
    def partly(self) -> bool:
        """True if the fill factor is below 1."""
        return self.fill != (1.0, 1.0)

    @property
    def pitch(self) -> tuple[float, float]:
        """Pitches of rows and columns."""
        return (self.pixel, self.pixel) if isinstance(self.pixel, float) else self.pixel

    @property
    def named(self) -> str:
        """Text of the pitch for messages."""
        return f"{self.pixel:g}" if isinstance(self.pixel, float) else "({:g}, {:g})".format(*self.pixel)

    @property
    def active(self) -> tuple[float, float]:
        """Height and width of the active area; 0 and 0 for point-sampled pixels."""
        (height, width), (height_fill, width_fill) = self.pitch, self.fill
        return (height * height_fill, width * width_fill) if self.integrate else (0.0, 0.0)

    @property
    def symmetric(self) -> bool:
        """True if pixels are point-sampled and centered, so that values at equal distances are equal."""
        return not self.integrate and self.centered

    @property
    def centered(self) -> bool:
        """True if the axis is at the default position."""
        return not self.stack and self.center == (self.height // 2, self.width // 2)

    @property
    def mirrored(self) -> bool:
        """True if there is one axis, in the window, and in x and in y at a pixel centre or midway between two."""
        return not self.stack and all(
            0.0 <= c <= side - 1 and 2.0 * c % 1.0 == 0.0 for c, side in zip(self.axis, self.shape, strict=True)
        )

    @cached_property
    def shape(self) -> tuple[int, int]:
        """Height and width."""
        return self.height, self.width

    @property
    def x(self) -> Array:
        """Column positions in the unit of `pixel`, rising to the right, 0 at the axis; shape ``stack + (width,)``."""
        return self._positions(1)

    @property
    def y(self) -> Array:
        """Row positions in the unit of `pixel`, rising downwards, 0 at the axis; shape ``stack + (height,)``."""
        return self._positions(0)

    def positions(self, stack: tuple[int, ...]) -> tuple[Array, Array]:
        """Return x and y for each image of a flattened `stack`, shapes ``(n, width)`` and ``(n, height)``."""
        count = math.prod(stack)
        x, y = (np.broadcast_to(part, (*stack, part.shape[-1])).reshape(count, -1) for part in (self.x, self.y))
        return x, y

    def _positions(self, side: int) -> Array:
        pixels = np.arange(self.shape[side], dtype=np.float64)
        return np.asarray(self.pitch[side] * (pixels - np.asarray(self.center[side])[..., None]))

    @property
    def radii(self) -> Array:
        """Distinct distances of pixel centres from a centred axis, rising, in the unit of `pixel`."""
        return np.sqrt(_quadrant(*self.shape)[0]) * self.side

    @property
    def multiplicity(self) -> NDArray[np.int64]:
        """Number of pixels at each of the distinct :attr:`radii`."""
        ranks = self.unfold(_quadrant(*self.shape)[1])
        return np.bincount(ranks.ravel())

    def step(self, pupil: BasePupil) -> float:
        """Return the pitch of square pixels in v of a `pupil`, ``pi pixel / (lambda N)``."""
        return math.pi * self.side / pupil.scale

    def cell(self, pupil: BasePupil) -> float:
        """Return the area of a pixel in v^2 of a `pupil`, including the inactive part."""
        if isinstance(self.pixel, float):
            return self.step(pupil) ** 2
        row_pitch, column_pitch = self.pixel
        return math.pi * row_pitch / pupil.scale * (math.pi * column_pitch / pupil.scale)

    @property
    def side(self) -> float:
        """Pitch of square pixels; ValueError for rectangular pixels, which methods do not support."""
        if not isinstance(self.pixel, float):
            raise ValueError(f"pixel must be one number for a Method, got {self.named}; lommel.psf accepts two")
        return self.pixel

    def reach(self, pupil: BasePupil) -> float:
        """Return a bound on the distance of the pixels from the axis, in v of a `pupil`."""
        return self._farthest * math.pi * max(self.pitch) / pupil.scale

    def require_reach(self, pupil: BasePupil) -> None:
        """Raise ValueError if pixels are beyond the largest radius that can be computed for a `pupil`."""
        v = self.reach(pupil)
        if not v <= validation.MAX_REACH:
            center = (
                "" if self.centered else f" around {'the farthest ' if self.stack else ''}center={self._far_center}"
            )
            label = f"pixel={self.named} with shape={self.shape}{center}"
            validation.reach(label, v, pupil.scale, pupil.unit)

    @cached_property
    def _farthest(self) -> float:
        """Largest distance of a point of a pixel from the axis, in pixels."""
        # Averages extend to the corners of pixels.
        half_pixel = 0.5 if self.integrate else 0.0
        sides = zip(self._far_center, self.shape, strict=True)
        return math.hypot(*(max(abs(c), abs(side - 1 - c)) + half_pixel for c, side in sides))

    @cached_property
    def _far_center(self) -> tuple[float, float]:
        """The axis with the largest distance to a corner of the window."""
        if not self.stack:
            return self.axis
        (row, column), (half_height, half_width) = self.center, (0.5 * (side - 1) for side in self.shape)
        # Distance of the farthest corner of the window from each axis.
        distances = np.hypot(np.abs(row - half_height) + half_height, np.abs(column - half_width) + half_width)
        return self[np.unravel_index(int(distances.argmax()), self.stack)].axis

    def v(self, pupil: BasePupil) -> Array:
        """Return the optical coordinate v, for a `pupil`, of the distinct :attr:`radii`."""
        return math.pi / pupil.scale * self.radii

    def unfold(self, quadrant: NDArray[_Number]) -> NDArray[_Number]:
        """Return images from one quadrant each, ``(..., height // 2 + 1, width // 2 + 1)`` from the axis outwards."""
        rows = np.abs(np.arange(self.height) - self.height // 2)
        columns = np.abs(np.arange(self.width) - self.width // 2)
        return quadrant[..., rows[:, None], columns]

    def paint(self, values: Array, scale: Array, out: NDArray[np.float32] | Array, threads: int = 0) -> None:
        """Write images times `scale` to `out`; `values` are images, or at the distinct radii ``(n, radii)``."""
        if values.ndim == 3:
            np.multiply(values, scale[:, None, None], out=out, casting="same_kind")
        else:
            engine.scatter(np.ascontiguousarray(values), scale, threads, out)


@lru_cache(maxsize=8)
def _quadrant(height: int, width: int) -> tuple[NDArray[np.int64], NDArray[np.int32]]:
    # Squared distances are integers, so that equal distances are exactly equal.
    squares, index = engine.distinct_radii(height // 2, width // 2)
    squares.flags.writeable = index.flags.writeable = False
    return squares, index
