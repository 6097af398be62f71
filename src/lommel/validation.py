"""Checks shared by every public entry: each names the argument, the value and what is allowed."""

from __future__ import annotations

import math
import operator
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

MAX_SIDE = 16384
"""Largest image side, in pixels."""

MAX_VALUES = 2**31
"""Largest number of values in one answer (8 GiB of float32)."""


def real(
    name: str,
    value: Any,
    *,
    above: float = -math.inf,
    least: float = -math.inf,
    below: float = math.inf,
    infinite: bool = False,
    unit: str = "",
) -> float:
    """Return `value` as a float that is ``> above``, ``>= least`` and ``< below``.

    Raises
    ------
    TypeError
        If `value` is not a real number.
    ValueError
        If it is NaN, infinite (unless `infinite`) or out of range.
    """
    if isinstance(value, bool | str | bytes) or np.ndim(value) != 0:
        raise TypeError(f"{name} must be a real number, got {value!r}")
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a real number, got {value!r}") from None
    if math.isnan(number) or (math.isinf(number) and not infinite):
        raise ValueError(f"{name} must be finite, got {number}")
    if not (number > above and number >= least and number < below) and not (infinite and math.isinf(number)):
        limits = []
        if above > -math.inf:
            limits.append(f"> {above:g}")
        if least > -math.inf:
            limits.append(f">= {least:g}")
        if below < math.inf:
            limits.append(f"< {below:g}")
        suffix = f" {unit}" if unit else ""
        raise ValueError(f"{name} must be {' and '.join(limits)}{suffix}, got {number:g}")
    if math.isinf(number) and number < 0:
        raise ValueError(f"{name} must not be -infinity")
    return number


def integer(name: str, value: Any, *, least: int, most: int) -> int:
    """Return `value` as an int in ``[least, most]``; TypeError or ValueError otherwise."""
    if isinstance(value, bool):
        raise TypeError(f"{name} must be an integer, got {value!r}")
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} must be an integer, got {value!r}") from None
    if not least <= number <= most:
        raise ValueError(f"{name} must be from {least} to {most}, got {number}")
    return number


def choice(name: str, value: Any, allowed: Iterable[str]) -> str:
    """Return `value` if it is one of `allowed`; ValueError otherwise."""
    options = list(allowed)
    if not isinstance(value, str) or value not in options:
        raise ValueError(f"{name} must be one of {', '.join(map(repr, options))}, got {value!r}")
    return value


def real_array(name: str, value: ArrayLike, *, least: float = -math.inf) -> NDArray[np.float64]:
    """Return `value` as a read-only float64 array of finite numbers ``>= least``."""
    given = np.asarray(value)
    if given.dtype.kind not in "iuf":
        raise TypeError(f"{name} must hold real numbers, got {value!r}")
    array = np.array(given, dtype=np.float64)
    bad = ~(np.isfinite(array) & (array >= least))
    if bad.any():
        limit = f" and >= {least:g}" if least > -math.inf else ""
        raise ValueError(f"{name} must be finite{limit}, got {array[bad].flat[0]}")
    array.flags.writeable = False
    return array


def image_shape(shape: Any) -> tuple[int, int]:
    """Return ``(height, width)`` from an int (a square) or a pair of ints, each 1 to `MAX_SIDE`."""
    sides = tuple(shape) if isinstance(shape, tuple | list | np.ndarray) else (shape, shape)
    if len(sides) != 2:
        raise ValueError(f"shape must be an integer or (height, width), got {shape!r}")
    height, width = (integer("shape", side, least=1, most=MAX_SIDE) for side in sides)
    return height, width


def wavelength(value: Any) -> float:
    """Return a wavelength in metres; a number that was meant in nm or um is refused with a hint."""
    metres = real("wavelength", value, above=0.0, unit="metres")
    if not 1e-12 <= metres <= 1e-2:
        hint = ""
        if 100 <= metres <= 20000:
            hint = f"; for {metres:g} nm give {metres:g}e-9"
        elif 0.05 <= metres < 100:
            hint = f"; for {metres:g} um give {metres:g}e-6"
        raise ValueError(f"wavelength is in metres and must be from 1e-12 to 1e-2, got {metres:g}{hint}")
    return metres


def pixel(value: Any, *, metric: bool) -> float:
    """Return a pixel pitch, in metres if `metric` (at most 0.1 m), else in units of lambda*N."""
    pitch = real("pixel", value, above=0.0, unit="metres" if metric else "lambda*N")
    if metric and pitch > 0.1:
        raise ValueError(
            f"pixel is in metres for a pupil with a wavelength and must be at most 0.1, got {pitch:g}; "
            f"for {pitch:g} um give {pitch:g}e-6"
        )
    return pitch
