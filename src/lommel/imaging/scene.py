"""What a photograph is made from and what it is: the checks that all ways to make one share."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import validation
from lommel.base.encoding import clipped_share, from_light, to_light
from lommel.core import engine
from lommel.imaging.blur import DepthBlur
from lommel.imaging.settings import MISSING


@dataclass(frozen=True, eq=False)
class Photograph:
    """What :func:`lommel.imaging.depth_of_field` returns; an array where one is wanted.

    Attributes
    ----------
    values : ndarray
        Of the shape, type and encoding of the image that was given.
    lost : float
        Largest share of the light of a point that its window did not hold, and that was spread over the window; 0
        with ``energy=1``.
    error : float
        Largest error of interpolated windows over their peak that was found. With ``energy=1`` the sum over
        all pixels of the most that the PSF of a point is off there, at any depth and in any channel: where light is
        only added, no pixel is off by more than this times the brightest point of the scene, in light. It is what was
        found at all windows and half-way between them, with an estimate of what is off far away, and of rounding.
        Levels of integers come on top.
    window : int
        Side of the largest window, pixels.
    clipped : float
        Share of values that were above white and are white now, as on a sensor; 0 where the type holds them.
    """

    values: NDArray[Any]
    lost: float
    error: float
    window: int
    clipped: float = 0.0

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        """Return the values."""
        return np.array(self.values, dtype=dtype, copy=copy)


def photograph(values: NDArray[Any], blur: DepthBlur, clipped: float) -> Photograph:
    """Return values as a photograph, with what is known of their error and the share that was clipped."""
    half = max(bank.half for bank in blur.banks)
    return Photograph(values, blur.lost, blur.error, 2 * half + 1, clipped)


def fill_missing(depth: ArrayLike, missing: str) -> NDArray[Any]:
    """Return depths whose NaNs are filled as `missing` says."""
    validation.choice("missing", missing, MISSING)
    distances = validation.array("depth", depth)
    if distances.dtype.kind != "f" or missing == "raise" or not np.isnan(distances).any():
        return distances
    unknown = np.isnan(distances)
    if missing == "infinity":
        return np.where(unknown, np.inf, distances)
    if unknown.all():
        raise ValueError("depth is NaN everywhere")
    from scipy.ndimage import distance_transform_edt

    nearest = distance_transform_edt(unknown, return_distances=False, return_indices=True)
    return np.asarray(distances[tuple(nearest)])


def stored(light: NDArray[Any], encoding: str, dtype: DTypeLike, threads: int = 0) -> tuple[NDArray[Any], float]:
    """Return finite light as stored values, and the share of them that an integer type clips.

    Parameters
    ----------
    light : ndarray of float
        1 is white.
    encoding : {"srgb", "linear"}
    dtype : dtype
        An unsigned integer or a float.
    threads : int
        At most so many, 0 for as many as there are processors.

    Returns
    -------
    values : ndarray
        As :func:`lommel.base.encoding.from_light`, but for rounding between two levels.
    clipped : float
        As :func:`lommel.base.encoding.clipped_share`.
    """
    if light.dtype != np.float32 or dtype != np.uint8 or light.size == 0:
        return from_light(light, encoding, dtype), clipped_share(light, dtype)
    values = np.empty(light.shape, dtype=np.uint8)
    level = 1.0 / 255.0
    flat = np.ascontiguousarray(light).reshape(-1)
    beyond = engine.levels(flat, _edges(encoding), -level, 1.0 + level, threads, values.reshape(-1))
    return values, beyond / light.size


@lru_cache
def _edges(encoding: str) -> NDArray[np.float32]:
    """Return the light half-way between the levels of a byte, as that is stored."""
    return to_light("edges", (np.arange(255) + 0.5) / 255.0, encoding, np.float64).astype(np.float32)
