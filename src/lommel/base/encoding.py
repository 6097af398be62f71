"""Encoding of light in stored values, integers or floats: sRGB, linear, a power, or the curves of an ICC profile."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.cached import cached_property

CLOSE = 5e-4
"""Largest difference in light, relative to white, up to which two encodings count as one."""

LEVELS = np.linspace(0.0, 1.0, 65536)
"""Stored values at which curves are tabulated: every level of 8 and of 16 bits."""
_MAX_LIGHT = 10.0  # times white; larger values are probably integer levels that were converted to floats

_BLOCK = 2**16  # number of values encoded together, so that intermediate arrays stay in the cache of a processor


@dataclass(frozen=True)
class ToneCurves:
    """Curves of an ICC profile, from stored values to light.

    Attributes
    ----------
    profile : bytes
        The ICC profile, which identifies the curves.
    light : ndarray, shape (1, 65536) or (3, 65536)
        Light at evenly spaced stored values from 0 to 1, for all channels or for red, green and blue.
    """

    profile: bytes = field(repr=False)
    light: Array = field(repr=False, compare=False)

    def decoded(self, name: str, values: Values) -> Values:
        """Return light from stored values; ValueError beyond 0 and 1, for which a profile states no light."""
        if (beyond := values[(values < 0.0) | (values > 1.0)]).size:
            raise ValueError(f"{name} must be from 0 to 1 for the curves of an ICC profile, got {beyond[0]}")
        return _by_channel(values, list(self.light), lambda part, light: np.interp(part, LEVELS, light))

    def encoded(self, light: Values) -> Values:
        """Return stored values from light, clipped to 0 and 1."""

        def stored(part: Values, inverse: Array) -> Array:
            place = np.sqrt(np.clip(part, 0.0, 1.0)) * (LEVELS.size - 1)
            node = place.astype(np.intp)
            return np.asarray(inverse[node] + (place - node) * (inverse[node + 1] - inverse[node]))

        return _by_channel(light, self._inverses, stored)

    @cached_property
    def _inverses(self) -> list[Array]:
        """Stored values at nodes even in the root of light, along which common ones are nearly straight."""
        rising = (np.unique(curve, return_index=True) for curve in self.light)  # a curve may have level parts
        return [np.interp(np.append(LEVELS, 1.0) ** 2, light, LEVELS[first]) for light, first in rising]


def _by_channel(values: Values, tables: Sequence[Array], convert: Callable[[Values, Array], Array]) -> Values:
    """Return values converted by the table of all channels, or each channel by its own."""
    if len(tables) == 1:
        return np.asarray(convert(values, tables[0]))
    if values.shape[-1:] != (3,):
        raise ValueError(f"encoding has curves of red, green and blue, got values of the shape {values.shape}")
    return np.stack([convert(values[..., k], table) for k, table in enumerate(tables)], axis=-1)


Encoding: TypeAlias = str | float | ToneCurves
"""A name ("srgb" or "linear"), a number (light = value ** number), or the curves of an ICC profile."""


def checked(encoding: Any) -> Encoding:
    """Return an encoding; TypeError or ValueError if it is none."""
    if isinstance(encoding, ToneCurves):
        return encoding
    if isinstance(encoding, str):
        if encoding in ("srgb", "linear"):
            return encoding
        names = "'srgb', 'linear' or a number from 0.1 to 10 (light = value ** number)"
        raise ValueError(f"encoding must be one of {names}, got {validation.shown(encoding)}")
    number = validation.real("encoding", encoding, least=0.1, most=10.0)
    return "linear" if number == 1.0 else number


def parsed(text: str) -> Encoding:
    """Return the encoding of a text; ValueError if it is none."""
    try:
        return checked(float(text))
    except ValueError:
        return checked(text)


def named(encoding: Encoding) -> str:
    """Return the name of an encoding in messages."""
    if isinstance(encoding, ToneCurves):
        return "encoded by the curves of their ICC profile"
    if isinstance(encoding, str):
        return {"srgb": "sRGB"}.get(encoding, encoding)
    return f"light = value ** {encoding:.4g}"


def as_json(encoding: Encoding) -> str | float:
    """Return an encoding for JSON: a name or number, "icc" for curves."""
    return "icc" if isinstance(encoding, ToneCurves) else encoding


def agree(first: Encoding, second: Encoding) -> bool:
    """Return True if two encodings differ by at most :data:`CLOSE` of white."""
    levels = np.repeat(LEVELS[::257, None], 3, axis=1)
    lights = [to_light("levels", levels, encoding, np.float64) for encoding in (first, second)]
    return float(np.abs(lights[0] - lights[1]).max()) <= CLOSE


def to_light(name: str, values: NDArray[np.generic], encoding: Encoding, dtype: DTypeLike) -> Values:
    """Return linear light (1 is white) from stored values: integers (white is their maximum) or floats.

    "srgb" is the transfer function of IEC 61966-2-1.

    Parameters
    ----------
    name : str
        Name of the values in error messages.
    values : ndarray
        Unsigned integers or floats.
    encoding : {"srgb", "linear"}, float or ToneCurves
        A number states ``light = value ** number``.
    dtype : float32 or float64
        Type of the result.

    Returns
    -------
    ndarray, of the shape of `values`

    Raises
    ------
    TypeError, ValueError
        If `values` are neither unsigned integers nor floats, are not finite, are negative unless "linear", or
        exceed 1 with curves.
    """
    encoding = checked(encoding)
    validation.kind("dtype", dtype, np.float32, np.float64)
    if values.dtype.kind == "u":
        white = int(np.iinfo(str(values.dtype)).max)
        is_one_curve = not isinstance(encoding, ToneCurves) or len(encoding.light) == 1
        if values.size > white + 1 and is_one_curve:  # a table with one entry per level is faster
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
    if isinstance(encoding, ToneCurves):
        return encoding.decoded(name, light).astype(dtype)
    if encoding != "linear" and light.size and float(light.min()) < 0.0:
        raise ValueError(f"{name} must be >= 0 to be {named(encoding)}, got {light.min()}; give encoding='linear'")
    if encoding == "srgb":
        # Up to 0.04045 sRGB is linear: encoding by the power alone would have an infinite slope at 0.
        is_linear = light <= 0.04045
        light = np.asarray(np.where(is_linear, light / 12.92, ((light + 0.055) / 1.055) ** 2.4), dtype=dtype)
    elif not isinstance(encoding, str):
        light = light**encoding
    return np.asarray(light)


def scene_light(name: str, values: NDArray[np.generic], encoding: Encoding, dtype: DTypeLike) -> Values:
    """Return linear light as :func:`to_light`, and issue a UserWarning if it exceeds ten times white."""
    light = to_light(name, values, encoding, dtype)
    warn_if_bright(light)
    return light


def warn_if_bright(light: Values) -> None:
    """Issue a UserWarning if light exceeds ten times white."""
    if light.size and (peak := float(np.max(light))) > _MAX_LIGHT:
        validation.tell(f"there is light of {peak:.4g} times white, which is 1 in floats; divide by the white level")


def from_light(light: Values, encoding: Encoding, dtype: DTypeLike) -> Values:
    """Return stored values of `dtype` from light; the inverse of :func:`lommel.base.encoding.to_light`.

    Integer types are clipped at white and at 0, as on a saturated sensor;
    :func:`lommel.base.encoding.clipped_fraction` returns the clipped fraction.

    Parameters
    ----------
    light : ndarray of float
        1 is white.
    encoding : {"srgb", "linear"}, float or ToneCurves
        The curves clip floats, too.
    dtype : dtype
        Type of the stored values: an unsigned integer or a float.

    Returns
    -------
    ndarray, of the shape of `light`
    """
    kind, encoding = np.dtype(dtype), checked(encoding)
    if isinstance(encoding, ToneCurves):
        light, encoding = encoding.encoded(light), "linear"
    flat_light = light.reshape(-1)
    stored_values = np.empty(flat_light.shape, dtype=kind)
    for part in (slice(start, start + _BLOCK) for start in range(0, flat_light.size, _BLOCK)):
        values = flat_light[part]
        if encoding == "srgb":
            power = 1.055 * np.maximum(values, 0.0) ** (1.0 / 2.4) - 0.055
            values = np.where(values <= 0.0031308, 12.92 * values, power)
        elif not isinstance(encoding, str):
            values = np.maximum(values, 0.0) ** (1.0 / encoding)
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
