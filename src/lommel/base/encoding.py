"""Encoding of light in stored values: sRGB or linear, integers or floats."""

from __future__ import annotations

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Values

ENCODINGS = ("linear", "srgb")

_BRIGHT = 10.0  # times white; more is rare in scenes, and common where integer levels were converted to floats

_PART = 2**16  # values encoded at a time, so that intermediate arrays stay in a cache


def to_light(name: str, values: NDArray[np.generic], encoding: str, dtype: DTypeLike) -> Values:
    """Return linear light (1 is white) from stored values: integers (white is their maximum) or floats.

    "srgb" is the transfer function of IEC 61966-2-1.

    Parameters
    ----------
    name : str
        Name of the values in error messages.
    values : ndarray
        Unsigned integers or floats.
    encoding : {"srgb", "linear"}
    dtype : float32 or float64
        Type of the result.

    Returns
    -------
    ndarray, of the shape of `values`

    Raises
    ------
    TypeError, ValueError
        If `values` are neither integers nor floats, or not finite, or negative where they must be sRGB.
    """
    validation.choice("encoding", encoding, ENCODINGS)
    validation.kind("dtype", dtype, np.float32, np.float64)
    if values.dtype.kind == "u":
        most = int(np.iinfo(str(values.dtype)).max)
        if values.size > most + 1:  # by a table with one entry for each level
            levels = np.arange(most + 1, dtype=values.dtype)
            return np.asarray(to_light(name, levels, encoding, dtype)[values])
        light = values.astype(dtype) / np.asarray(most, dtype=dtype)
    elif values.dtype.kind == "f":
        with np.errstate(over="ignore", invalid="ignore"):
            light = values.astype(dtype)
        if not np.all(np.isfinite(light)):
            raise ValueError(f"{name} must be finite, got {values[~np.isfinite(light)].flat[0]}")
    else:
        raise TypeError(f"{name} must hold unsigned integers or floats, got {values.dtype}")
    if encoding == "srgb":
        if light.size and float(light.min()) < 0.0:
            raise ValueError(f"{name} must be >= 0 to be sRGB, got {light.min()}; give encoding='linear'")
        # Below 0.04045 sRGB is linear, since the slope of the power would be infinite in light at 0 (IEC 61966-2-1).
        low = light <= 0.04045
        light = np.asarray(np.where(low, light / 12.92, ((light + 0.055) / 1.055) ** 2.4), dtype=dtype)
    return np.asarray(light)


def scene_light(name: str, values: NDArray[np.generic], encoding: str, dtype: DTypeLike) -> Values:
    """Return linear light as :func:`to_light`, with a UserWarning if it exceeds ten times white."""
    light = to_light(name, values, encoding, dtype)
    tell_of_light(light)
    return light


def tell_of_light(light: Values) -> None:
    """Give a UserWarning if light exceeds ten times white."""
    if light.size and (peak := float(np.max(light))) > _BRIGHT:
        validation.tell(f"there is light of {peak:.4g} times white, which is 1 in floats; divide them by their white")


def from_light(light: Values, encoding: str, dtype: DTypeLike) -> Values:
    """Return stored values of `dtype` from light; the inverse of :func:`lommel.base.encoding.to_light`.

    Integer types are clipped at white and at 0, as on a saturated sensor;
    :func:`lommel.base.encoding.clipped_share` returns the clipped fraction.

    Parameters
    ----------
    light : ndarray of float
        1 is white.
    encoding : {"srgb", "linear"}
    dtype : dtype
        An unsigned integer or a float.

    Returns
    -------
    ndarray, of the shape of `light`
    """
    kind, flat = np.dtype(dtype), light.reshape(-1)
    stored = np.empty(flat.shape, dtype=kind)
    for part in (slice(first, first + _PART) for first in range(0, flat.size, _PART)):
        values = flat[part]
        if encoding == "srgb":
            curved = 1.055 * np.maximum(values, 0.0) ** (1.0 / 2.4) - 0.055
            values = np.where(values <= 0.0031308, 12.92 * values, curved)
        if kind.kind == "u":
            most = np.iinfo(kind).max
            # In float64: float32 cannot hold the levels of 32-bit integers.
            values = np.clip(np.rint(values.astype(np.float64) * most), 0, most)
        stored[part] = values
    return stored.reshape(light.shape)


def clipped_share(light: Values, dtype: DTypeLike) -> float:
    """Return the fraction of values that an integer type clips (by more than rounding); 0 for floats.

    Parameters
    ----------
    light : ndarray of float
        1 is white.
    dtype : dtype
        Of the values stored.

    Returns
    -------
    float
        0 to 1.
    """
    kind = np.dtype(dtype)
    if kind.kind != "u" or light.size == 0:
        return 0.0
    # One level beyond the range is rounding, not clipping.
    level = 1.0 / np.iinfo(kind).max
    return float(np.mean((light > 1.0 + level) | (light < -level)))
