"""Encoding of light in stored values: sRGB or linear, integers or floats."""

from __future__ import annotations

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Values

ENCODINGS = ("linear", "srgb")

_MAX_LIGHT = 10.0  # times white; larger values are probably integer levels that were converted to floats

_BLOCK = 2**16  # number of values encoded together, so that intermediate arrays stay in the cache of a processor


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
        If `values` are neither unsigned integers nor floats, are not finite, or are negative with "srgb".
    """
    validation.choice("encoding", encoding, ENCODINGS)
    validation.kind("dtype", dtype, np.float32, np.float64)
    if values.dtype.kind == "u":
        white = int(np.iinfo(str(values.dtype)).max)
        if values.size > white + 1:  # a table with one entry per level is faster
            levels = np.arange(white + 1, dtype=values.dtype)
            return np.asarray(to_light(name, levels, encoding, dtype)[values])
        light = values.astype(dtype) / np.asarray(white, dtype=dtype)
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
        # Up to 0.04045 sRGB is linear: encoding by the power alone would have an infinite slope at 0.
        is_linear = light <= 0.04045
        light = np.asarray(np.where(is_linear, light / 12.92, ((light + 0.055) / 1.055) ** 2.4), dtype=dtype)
    return np.asarray(light)


def scene_light(name: str, values: NDArray[np.generic], encoding: str, dtype: DTypeLike) -> Values:
    """Return linear light as :func:`to_light`, and issue a UserWarning if it exceeds ten times white."""
    light = to_light(name, values, encoding, dtype)
    warn_if_bright(light)
    return light


def warn_if_bright(light: Values) -> None:
    """Issue a UserWarning if light exceeds ten times white."""
    if light.size and (peak := float(np.max(light))) > _MAX_LIGHT:
        validation.tell(f"there is light of {peak:.4g} times white, which is 1 in floats; divide by the white level")


def from_light(light: Values, encoding: str, dtype: DTypeLike) -> Values:
    """Return stored values of `dtype` from light; the inverse of :func:`lommel.base.encoding.to_light`.

    Integer types are clipped at white and at 0, as on a saturated sensor;
    :func:`lommel.base.encoding.clipped_fraction` returns the clipped fraction.

    Parameters
    ----------
    light : ndarray of float
        1 is white.
    encoding : {"srgb", "linear"}
    dtype : dtype
        Type of the stored values: an unsigned integer or a float.

    Returns
    -------
    ndarray, of the shape of `light`
    """
    kind, flat_light = np.dtype(dtype), light.reshape(-1)
    stored_values = np.empty(flat_light.shape, dtype=kind)
    for part in (slice(start, start + _BLOCK) for start in range(0, flat_light.size, _BLOCK)):
        values = flat_light[part]
        if encoding == "srgb":
            power = 1.055 * np.maximum(values, 0.0) ** (1.0 / 2.4) - 0.055
            values = np.where(values <= 0.0031308, 12.92 * values, power)
        if kind.kind == "u":
            white = np.iinfo(kind).max
            # In float64, because float32 cannot represent all levels of 32-bit integers.
            values = np.clip(np.rint(values.astype(np.float64) * white), 0, white)
        stored_values[part] = values
    return stored_values.reshape(light.shape)


def clipped_fraction(light: Values, dtype: DTypeLike) -> float:
    """Return the fraction of values that an integer type clips (by more than rounding); 0 for floats.

    Parameters
    ----------
    light : ndarray of float
        1 is white.
    dtype : dtype
        Type of the stored values.

    Returns
    -------
    float
        0 to 1.
    """
    kind = np.dtype(dtype)
    if kind.kind != "u" or light.size == 0:
        return 0.0
    # Light up to one level outside the range counts as rounded, not as clipped.
    level = 1.0 / np.iinfo(kind).max
    return float(np.mean((light > 1.0 + level) | (light < -level)))
