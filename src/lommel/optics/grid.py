"""Pixels, and the optical coordinate of their centres."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.cached import cached_property
from lommel.core import engine
from lommel.optics.pupil import Pupil


@dataclass(frozen=True, init=False)
class Grid:
    """Square pixels around the optical axis.

    Parameters
    ----------
    shape : int or (int, int)
        Side of a square, or height and width, each 1 to 16384.
    pixel : float
        Pixel pitch: metres where the pupil has a wavelength, else units of lambda*N.
    center : (float, float), optional
        Row and column of the optical axis, in pixels, 0 being the middle of the first; by default the middle of
        pixel ``(height // 2, width // 2)``.
    integrate : bool, default False
        Whether pixels average the intensity over their area instead of sampling it at their centre.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.
    """

    height: int
    width: int
    pixel: float
    center: tuple[float, float]
    integrate: bool

    def __init__(self, shape: Any, pixel: float, *, center: Any = None, integrate: bool = False) -> None:
        height, width = validation.image_shape(shape)
        middle = (float(height // 2), float(width // 2))
        pitch = validation.real("pixel", pixel, above=0.0)
        center = middle if center is None else validation.position("center", center)
        integrate = validation.truth("integrate", integrate)
        vars(self).update(height=height, width=width, pixel=pitch, center=center, integrate=integrate)

    @property
    def symmetric(self) -> bool:
        """Whether all pixels at one distance have one value: sampled, with the axis in the default place."""
        return not self.integrate and self.centered

    @property
    def centered(self) -> bool:
        """Whether the axis is in the default place."""
        return self.center == (self.height // 2, self.width // 2)

    @cached_property
    def shape(self) -> tuple[int, int]:
        """Height and width."""
        return self.height, self.width

    @property
    def x(self) -> Array:
        """Column positions, in the unit of `pixel`; 0 at the axis, rising to the right."""
        return self.pixel * (np.arange(self.width, dtype=np.float64) - self.center[1])

    @property
    def y(self) -> Array:
        """Row positions, in the unit of `pixel`; 0 at the axis, rising downwards."""
        return self.pixel * (np.arange(self.height, dtype=np.float64) - self.center[0])

    @property
    def radii(self) -> Array:
        """Distinct distances of pixel centres from a centred axis, rising, in the unit of `pixel`."""
        return np.sqrt(_quadrant(*self.shape)[0]) * self.pixel

    @property
    def multiplicity(self) -> NDArray[np.int64]:
        """How many pixels there are at each of the distinct :attr:`radii`."""
        ranks = self.unfold(_quadrant(*self.shape)[1])
        return np.bincount(ranks.ravel())

    def step(self, pupil: Pupil) -> float:
        """Return the pixel pitch in v of a `pupil`, ``pi pixel / (lambda N)``."""
        return math.pi * self.pixel / pupil.scale

    def require_reach(self, pupil: Pupil) -> None:
        """Raise ValueError if pixels are farther from the axis than a `pupil` sends light that is worth computing."""
        v = self._farthest * self.step(pupil)
        if not v <= validation.MAX_REACH:
            center = "" if self.centered else f" around center={self.center}"
            what = f"pixel={self.pixel:g} with shape={self.shape}{center}"
            validation.reach(what, v, pupil.scale, pupil.unit)

    @cached_property
    def _farthest(self) -> float:
        """Distance of the farthest point of a pixel from the axis, in pixels."""
        half = 0.5 if self.integrate else 0.0
        sides = zip(self.center, self.shape, strict=True)
        return math.hypot(*(max(abs(c), abs(side - 1 - c)) + half for c, side in sides))

    def v(self, pupil: Pupil) -> Array:
        """Return the optical coordinate v, for a `pupil`, of the distinct :attr:`radii`."""
        return pupil.v(self.radii)

    def unfold(self, quadrant: NDArray[Any]) -> NDArray[Any]:
        """Return images from a `quadrant` of each, ``(..., height // 2 + 1, width // 2 + 1)`` from the axis on."""
        rows = np.abs(np.arange(self.height) - self.height // 2)
        columns = np.abs(np.arange(self.width) - self.width // 2)
        return quadrant[..., rows[:, None], columns]

    def paint(self, values: Array, scale: Array, out: NDArray[Any]) -> None:
        """Write a stack of images, each multiplied by its scale.

        Parameters
        ----------
        values : ndarray
            Either ``(n, len(radii))``, values at the distinct radii, or ``(n, height, width)``.
        scale : ndarray, shape (n,)
        out : ndarray of float32 or float64, shape (n, height, width)
        """
        if values.ndim == 3:
            out[:] = values * scale[:, None, None]
        else:
            engine.scatter(np.ascontiguousarray(values), scale, _quadrant(*self.shape)[1], out)


@lru_cache(maxsize=8)
def _quadrant(height: int, width: int) -> tuple[NDArray[np.int64], NDArray[np.int32]]:
    squares, index = engine.distinct_radii(height // 2, width // 2)
    squares.flags.writeable = index.flags.writeable = False
    return squares, index
