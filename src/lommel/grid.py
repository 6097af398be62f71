"""Pixels, and the optical coordinate of their centres."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel import _core, validation
from lommel.pupil import Pupil


@dataclass(frozen=True, init=False)
class Grid:
    """An image of square pixels, centred on the middle of pixel ``(height // 2, width // 2)``.

    Parameters
    ----------
    shape : int or (int, int)
        Side of a square, or height and width, each 1 to 16384.
    pixel : float
        Pixel pitch: metres where the pupil has a wavelength, else units of lambda*N.
    """

    height: int
    width: int
    pixel: float

    def __init__(self, shape: Any, pixel: float) -> None:
        height, width = validation.image_shape(shape)
        object.__setattr__(self, "height", height)
        object.__setattr__(self, "width", width)
        object.__setattr__(self, "pixel", validation.real("pixel", pixel, above=0.0))

    @property
    def shape(self) -> tuple[int, int]:
        """Height and width."""
        return self.height, self.width

    @property
    def x(self) -> NDArray[np.float64]:
        """Column positions, in the unit of `pixel`; 0 at the centre, rising to the right."""
        return self.pixel * np.arange(-(self.width // 2), self.width - self.width // 2, dtype=np.float64)

    @property
    def y(self) -> NDArray[np.float64]:
        """Row positions, in the unit of `pixel`; 0 at the centre, rising downwards."""
        return self.pixel * np.arange(-(self.height // 2), self.height - self.height // 2, dtype=np.float64)

    @property
    def radii(self) -> NDArray[np.float64]:
        """Distinct distances of pixel centres from the centre, rising, in the unit of `pixel`."""
        return np.sqrt(_quadrant(*self.shape)[0]) * self.pixel

    def step(self, pupil: Pupil) -> float:
        """Return the pixel pitch in v, ``pi pixel / (lambda N)``."""
        return math.pi * self.pixel / pupil.scale

    def v(self, pupil: Pupil) -> NDArray[np.float64]:
        """Return the optical coordinate of the distinct :attr:`radii`."""
        return pupil.v(self.radii)

    def paint(self, values: NDArray[np.float64], scale: NDArray[np.float64], dtype: DTypeLike) -> NDArray[Any]:
        """Return a stack of images, each multiplied by its scale.

        Parameters
        ----------
        values : ndarray
            Either ``(n, len(radii))``, values at the distinct radii, or ``(n, height, width)``.
        scale : ndarray, shape (n,)
        dtype : float32 or float64
        """
        if values.ndim == 3:
            return (values * scale[:, None, None]).astype(dtype)
        out = np.empty((values.shape[0], *self.shape), dtype=dtype)
        _core.scatter(np.ascontiguousarray(values), scale, _quadrant(*self.shape)[1], out)
        return out


@lru_cache(maxsize=8)
def _quadrant(height: int, width: int) -> tuple[NDArray[np.int64], NDArray[np.int32]]:
    squares, index = _core.distinct_radii(height // 2, width // 2)
    squares.flags.writeable = index.flags.writeable = False
    return squares, index
