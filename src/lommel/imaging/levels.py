"""Light as values that are stored, in threads where that is worth it."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base.encoding import clipped_share, from_light, to_light
from lommel.core import engine


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
