"""Validation of arguments: each error message names the argument, its value and the allowed values."""

from __future__ import annotations

import math
import numbers
import operator
import os
import reprlib
import sys
import warnings
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TYPE_CHECKING, Any, SupportsIndex, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base.arrays import Array, Values
from lommel.base.quantities import BARE, in_unit

if TYPE_CHECKING:
    from pathlib import Path


def tell(note: str, category: type[Warning] = UserWarning) -> None:
    """Issue a warning that refers to the line outside this package from which the package was called."""
    if category is UserWarning and (notes := _collected.get()) is not None:
        notes[0].append(notes[1] + note)
        return
    # A fixed stacklevel would refer to a line of this package, since the number of frames varies.
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_globals.get("__name__", "").startswith("lommel."):
        level, frame = level + 1, frame.f_back
    warnings.warn(note, category, stacklevel=level)


class Early(UserWarning):
    """Warning before a computation that takes long, of what the findings of its result repeat."""


_collected: ContextVar[tuple[list[str], str] | None] = ContextVar("collected", default=None)


@contextmanager
def collected(notes: list[str], prefix: str) -> Iterator[None]:
    """Add the warnings of :func:`tell` in this thread, after a prefix, to a list instead of issuing them."""
    token = _collected.set((notes, prefix))
    try:
        yield
    finally:
        _collected.reset(token)


MAX_SIDE = 16384
"""Largest image side, in pixels."""

MAX_VALUES = 2**31
"""Largest number of values of one result (8 GiB of float32)."""

MAX_REACH = 1e6
"""Largest distance from the axis in v = pi r / (lambda N); in focus, I / peak is below 1e-17 at this distance."""


_MAX_CHARACTERS = 120  # maximum number of characters of a value in a message
_brief = reprlib.Repr()
_brief.maxstring = _brief.maxother = _brief.maxlong = _MAX_CHARACTERS
_brief.maxlevel = 3

_Value = TypeVar("_Value")


def shown(value: object) -> str:
    """Return a value as text for a message: on one line; the middle of a long text is omitted."""
    try:
        text = " ".join(_brief.repr(readable(value) if isinstance(value, str) else value).split())
    except ValueError:  # Python does not convert integers of more than 4300 digits to text
        text = f"<{type(value).__name__}>"
    return brief(text)


def brief(text: str, limit: int = _MAX_CHARACTERS) -> str:
    """Return a text, whose middle is omitted if it has more than `limit` characters."""
    return text if len(text) <= limit else f"{text[: limit - 20]}...{text[-17:]}"


def key(text: str) -> str:
    """Return a key or column name of a file as text for a message: on one line, at most 60 characters."""
    return brief(line(text), 60)


def line(text: object) -> str:
    """Return a text, such as a file name, with line breaks and control characters escaped."""
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in readable(str(text)))


def readable(text: str) -> str:
    """Return a file name in which bytes that the locale cannot decode are read as UTF-8."""
    # Python represents such bytes as lone surrogates (PEP 383), which no output accepts.
    if text.isascii() or not any("\udc80" <= c <= "\udcff" for c in text):
        return text
    try:
        return os.fsencode(text).decode(errors="replace")
    except UnicodeEncodeError:  # other surrogates, which do not occur in file names
        return text


def instance(name: str, value: _Value, kind: type[object]) -> _Value:
    """Return `value` if it is an instance of `kind`; TypeError otherwise."""
    if not isinstance(value, kind):
        article = "an" if kind.__name__[0] in "AEIOU" else "a"
        raise TypeError(f"{name} must be {article} {kind.__name__}, got {shown(value)}")
    return value


def optional(name: str, value: object, *kinds: type[object]) -> None:
    """Raise TypeError for a value that is neither None nor an instance of one of `kinds`."""
    if value is not None and not isinstance(value, kinds):
        allowed = " or ".join(kind.__name__ for kind in kinds)
        raise TypeError(f"{name} must be of the type {allowed}, or None, got {shown(value)}")


def path(name: str, value: object) -> Path:
    """Return `value` as a path; TypeError or ValueError if it is not a path."""
    from pathlib import Path  # late: its imports would slow down `import lommel`

    if not isinstance(value, str | os.PathLike) or isinstance(os.fspath(value), bytes):
        raise TypeError(f"{name} must be a path, got {shown(value)}")
    if "\0" in os.fspath(value):
        raise ValueError(f"{name} must be a path without null characters, got {shown(value)}")
    if not os.fspath(value):
        raise ValueError(f"{name} must be a path, got an empty text")
    return Path(value)


def _is_quantity(value: object) -> bool:
    """Return True for text that begins with a digit, such as "550 nm"."""
    return isinstance(value, str) and value.strip()[:1].isdigit()


def real(
    name: str,
    value: object,
    *,
    above: float = -math.inf,
    least: float = -math.inf,
    below: float = math.inf,
    most: float = math.inf,
    infinite: bool = False,
    unit: str = "",
) -> float:
    """Return `value` as a finite float, ``> above``, ``>= least``, ``< below`` and ``<= most``; or raise an error."""
    # The common case is tested first, since isinstance with an abstract class such as numbers.Real is slow.
    if type(value) not in BARE:
        value = in_unit(name, value, unit)
    if isinstance(value, float):
        number = float(value)
    elif isinstance(value, numbers.Real | np.ndarray | np.generic) and _is_real_scalar(value):
        try:
            number = float(value)
        except OverflowError:
            raise ValueError(f"{name} must be finite, got an integer beyond the range of numbers") from None
    else:
        hint = ": text with a unit is for files and the command line" if _is_quantity(value) else ""
        raise TypeError(f"{name} must be a real number, got {shown(value)}{hint}")
    if math.isnan(number) or (math.isinf(number) and not infinite):
        raise ValueError(f"{name} must be finite, got {number}")
    if not (above < number < below and least <= number <= most) and not (infinite and math.isinf(number)):
        bounds = ((">", above), (">=", least), ("<", below), ("<=", most))
        limits = [f"{sign} {bound:g}" for sign, bound in bounds if math.isfinite(bound)]
        suffix = f" {unit}" if unit else ""
        raise ValueError(f"{name} must be {' and '.join(limits)}{suffix}, got {number:g}")
    if math.isinf(number) and number < 0:
        raise ValueError(f"{name} must not be -infinity")
    return number


def _is_real_scalar(value: object) -> bool:
    if isinstance(value, np.ndarray | np.generic):
        return value.ndim == 0 and value.dtype.kind in "iuf" and not _is_masked(value)
    return not isinstance(value, bool)


_TWO_TURNS = 4.0 * math.pi + 1e-9  # radians, with a tolerance; sums of angles may exceed one turn


def angles(name: str, value: float | ArrayLike) -> Array:
    """Return angles in radians, within two turns, as a read-only array: larger numbers are probably degrees."""
    radians = real_array(name, value, unit="radians")
    if (beyond := radians[np.abs(radians) > _TWO_TURNS]).size:
        raise ValueError(
            f"{name} must be in radians and within two turns, 4 pi, got {beyond[0]:g}; "
            f"for degrees give math.radians({beyond[0]:g})"
        )
    return radians


def angle(name: str, value: object) -> float:
    """Return an angle in radians, within two turns; TypeError or ValueError otherwise."""
    return float(angles(name, real(name, value, unit="radians")))


def integer(name: str, value: object, *, least: int, most: int) -> int:
    """Return `value` as an int in ``[least, most]``; TypeError or ValueError otherwise."""
    if isinstance(value, bool | np.bool_):
        raise TypeError(f"{name} must be an integer, got {shown(value)}")
    try:
        number = operator.index(cast(SupportsIndex, value))
    except TypeError:
        raise TypeError(f"{name} must be an integer, got {shown(value)}") from None
    if not least <= number <= most:
        raise ValueError(f"{name} must be from {least} to {most}, got {shown(number)}")
    return number


def truth(name: str, value: object) -> bool:
    """Return `value` if it is True or False; TypeError otherwise."""
    if not isinstance(value, bool):
        raise TypeError(f"{name} must be True or False, got {shown(value)}")
    return value


def function(name: str, value: object, *, required: bool = True) -> None:
    """Raise TypeError for a value that cannot be called; None is allowed unless `required`."""
    if (required or value is not None) and not callable(value):
        raise TypeError(f"{name} must be callable, got {shown(value)}")


def choice(name: str, value: object, allowed: Iterable[str]) -> str:
    """Return `value` if it is one of `allowed`; ValueError otherwise."""
    options = list(allowed)
    if not isinstance(value, str) or value not in options:
        raise ValueError(f"{name} must be one of {', '.join(map(repr, options))}, got {shown(value)}")
    return value


def array(name: str, value: ArrayLike, unit: str = "") -> Values:
    """Return `value` in `unit` as an array; TypeError if some are masked, since plain arrays would lose the mask."""
    values: Any = value
    if type(value) not in BARE:
        values = computed(in_unit(name, value, unit))
        refuse_masked(name, values)
    try:
        return np.asarray(values)
    except (ValueError, TypeError, OverflowError):  # ragged sequences and objects: later checks refuse the dtype
        return np.asarray(None)


def refuse_masked(name: str, value: object) -> None:
    """Raise TypeError for an array or container (NumPy, astropy) in which values are masked."""
    if _is_masked(value):
        raise TypeError(f"{name} must not be masked; fill the masked values, or omit them")


def parted(name: str, value: object, unit: str = "") -> tuple[Values, NDArray[np.bool_] | None]:
    """Return (1) the numbers of a container or a list of these, in `unit`, (2) their mask (True: masked) or None.

    TypeError if it does not hold numbers, ValueError if masked containers in a list have different shapes.
    """
    if type(value) not in BARE:
        value = computed(in_unit(name, value, unit))
    if not _is_masked(value):
        return number_array(name, cast(ArrayLike, value), unit), None
    if isinstance(value, list | tuple):
        parts = [parted(f"{name}[{k}]", item, unit) for k, item in enumerate(value)]
        if len(shapes := {data.shape for data, _ in parts}) > 1:
            raise ValueError(f"{name} must have one shape, got {', '.join(map(str, sorted(shapes)))}")
        masks = [np.zeros(data.shape, dtype=bool) if mask is None else mask for data, mask in parts]
        return np.stack([data for data, _ in parts]), np.stack(masks)
    data = value if isinstance(value, np.ndarray) else getattr(value, "data", value)
    numbers = number_array(name, np.array(data, subok=False), unit)
    return numbers, np.broadcast_to(np.asarray(getattr(value, "mask", False)) != 0, numbers.shape)


def computed(value: object) -> Any:
    """Return the array of a container, dask and xarray of dask computed, or any other value unchanged."""
    if type(value) in BARE or isinstance(value, np.ndarray):
        return value
    if isinstance(value, list | tuple):
        return value if all(type(part) in BARE for part in value) else [computed(part) for part in value]
    if getattr(value, "mask", None) is not None or type(value).__module__.partition(".")[0] == "lommel":
        return value
    data = getattr(value, "data", None)
    for lazy in (value, data):  # dask, and xarray of dask, whose conversion to an array may lose the mask
        if callable(compute := getattr(lazy, "compute", None)) and hasattr(lazy, "dask"):
            return compute()
    values = None if hasattr(value, "__array__") else data  # astropy's NDData
    return values if isinstance(values, np.ndarray) and hasattr(value, "mask") else value


def _is_masked(value: object) -> bool:
    if type(value) in BARE:
        return False
    if isinstance(value, list | tuple):
        return any(_is_masked(part) for part in value if type(part) not in BARE)
    if type(value).__module__.partition(".")[0] == "lommel":  # the `mask` of an aperture is an optical element
        return False
    mask = getattr(value, "mask", None)
    if mask is None or callable(mask):  # in pandas `mask` is a method
        return False
    mask_array = np.asarray(mask)
    return bool(mask_array.dtype.kind in "biu" and mask_array.any()) or (
        mask_array.dtype.names is not None and bool(np.ma.is_masked(value))  # structured arrays
    )


def number_array(name: str, value: ArrayLike, unit: str = "") -> Values:
    """Return `value` in `unit` as an array of integers or floats; TypeError otherwise."""
    values = array(name, value, unit)
    if values.dtype.kind not in "iuf":
        raise TypeError(f"{name} must hold real numbers, got {shown(value)}")
    return values


def real_array(
    name: str, value: float | ArrayLike, *, least: float = -math.inf, most: float = math.inf, unit: str = ""
) -> Array:
    """Return `value` in `unit` as a read-only float64 array of finite numbers ``>= least`` and ``<= most``."""
    if isinstance(value, float) and math.isfinite(value) and least <= value <= most:
        result = np.array(value, dtype=np.float64)  # a single number: checks of arrays are slow
    else:
        with np.errstate(over="ignore"):  # a long double beyond the range of float64 becomes infinite: refused below
            result = np.array(number_array(name, value, unit), dtype=np.float64, subok=False)
        invalid = ~(np.isfinite(result) & (result >= least))
        if most < math.inf:
            invalid |= result > most
        if invalid.any():
            limits = [f" and {sign} {x:g}" for sign, x in ((">=", least), ("<=", most)) if math.isfinite(x)]
            raise ValueError(f"{name} must be finite{''.join(limits)}, got {result[invalid].flat[0]}")
    # The array is read-only, since pupils and grids cache values computed from it.
    result.flags.writeable = False
    return result


def rising(name: str, value: float | ArrayLike, *, count: int = 1, unit: str = "") -> Array:
    """Return at least `count` strictly increasing numbers as a read-only 1-D array; ValueError otherwise."""
    result = np.atleast_1d(real_array(name, value, unit=unit))
    if result.ndim != 1 or result.size < count or not np.all(np.diff(result) > 0.0):
        raise ValueError(f"{name} must rise, and be {count} or more, got {shown(value)}")
    return result


def broadcast(names: str, *arrays: Values) -> tuple[Array, ...]:
    """Return arrays broadcast to a common shape; ValueError with their `names` ("x and y") if impossible."""
    try:
        return np.broadcast_arrays(*arrays)
    except ValueError:
        shapes = " and ".join(str(part.shape) for part in arrays)
        raise ValueError(f"{names} must broadcast, got shapes {shapes}") from None


def axes(name: str, value: object) -> None:
    """Raise TypeError for a value that is neither None nor matplotlib axes (recognised without importing it)."""
    if value is not None and not callable(getattr(value, "imshow", None)):
        raise TypeError(f"{name} must be axes of matplotlib or None, got {shown(value)}")


def kind(name: str, value: object, *allowed: type[np.generic]) -> np.dtype[Any]:
    """Return the dtype that `value` specifies; TypeError if it is not one of `allowed`."""
    options = [np.dtype(item) for item in allowed]
    try:
        dtype: np.dtype[Any] = np.dtype(cast(DTypeLike, value))
    except Exception:  # NumPy raises errors of many types for an invalid dtype
        dtype = np.dtype(object)
    is_number = isinstance(value, np.generic) and not isinstance(value, str)  # a NumPy number is not a dtype
    if value is None or is_number or dtype not in options:
        *other_names, last_name = map(str, options)
        raise TypeError(f"{name} must be {', '.join(other_names)} or {last_name}, got {shown(value)}")
    return dtype


def image_shape(shape: object, name: str = "shape") -> tuple[int, int]:
    """Return ``(height, width)`` from an int (a square) or a pair of ints, each 1 to `MAX_SIDE`."""
    if (pixels := in_unit(name, shape, "pixels")) is not shape:  # floats, as those of astropy are
        stated = [int(side) if side.is_integer() else side for side in np.ravel(pixels).astype(np.float64).tolist()]
        shape = stated if np.ndim(pixels) else stated[0]
    if isinstance(shape, tuple | list) or (isinstance(shape, np.ndarray) and shape.ndim > 0):
        sides = tuple(shape)
    else:
        sides = shape, shape
    if len(sides) != 2:
        raise ValueError(f"{name} must be an integer or (height, width), got {shown(shape)}")
    height, width = (integer(name, side, least=1, most=MAX_SIDE) for side in sides)
    return height, width


def stack_shape(shape: object, stack: tuple[int, ...]) -> tuple[int, ...]:
    """Return `shape` if a stack of shape `stack` can be broadcast to it; TypeError or ValueError otherwise."""
    if not isinstance(shape, tuple | list):
        raise TypeError(f"shape must be a tuple of integers, got {shown(shape)}")
    sides = tuple(integer("shape", side, least=0, most=MAX_VALUES) for side in shape)
    if math.prod(sides) > MAX_SIDE**2:
        raise ValueError(f"shape must hold at most {MAX_SIDE**2} pupils, got {shown(sides)}")
    try:
        fits = np.broadcast_shapes(stack, sides) == sides
    except ValueError:
        fits = False
    if not fits:
        raise ValueError(f"shape must be one that {stack} broadcasts to, got {shown(sides)}")
    return sides


def position(name: str, value: object) -> tuple[float, float]:
    """Return ``(row, column)`` from a pair of numbers with absolute values below 1e6 pixels."""
    value = in_unit(name, value, "pixels")
    if not isinstance(value, tuple | list | np.ndarray) or getattr(value, "ndim", 1) == 0 or len(value) != 2:
        raise ValueError(f"{name} must be (row, column), got {shown(value)}")
    row, column = (real(name, part, above=-1e6, below=1e6, unit="pixels") for part in value)
    return row, column


def positions(name: str, value: object) -> tuple[float, float] | tuple[Array, Array]:
    """Return ``(row, column)``, or read-only arrays ``(rows, columns)`` of a common shape if `value` has arrays."""
    value = in_unit(name, value, "pixels")
    if not isinstance(value, tuple | list | np.ndarray) or getattr(value, "ndim", 1) == 0 or len(value) != 2:
        hint = f": give tuple({name}.T)" if isinstance(value, np.ndarray) and value.shape[1:] == (2,) else ""
        raise ValueError(f"{name} must be (row, column), or (rows, columns) of several, got {shown(value)}{hint}")
    if all(np.isscalar(part) or getattr(part, "shape", None) == () for part in value):
        return position(name, value)
    parts = (real_array(f"{name}[{k}]", part) + 0.0 for k, part in enumerate(value))  # turns -0 into 0
    rows, columns = (np.array(part) for part in broadcast(f"{name}[0] and {name}[1]", *parts))
    if rows.size == 0:
        raise ValueError(f"{name} must not be empty, got shape {rows.shape}")
    for part in (rows, columns):
        if not np.abs(part).max() < 1e6:
            raise ValueError(f"{name} must be within 1e6 pixels, got {part.flat[np.abs(part).argmax()]:g}")
        part.flags.writeable = False
    return rows, columns


def wavelength(value: object, name: str = "wavelength") -> float:
    """Return a wavelength in metres; the error message has a hint if the number is probably in nm or um."""
    metres = real(name, value, above=0.0, unit="metres")
    if not 1e-12 <= metres <= 1e-2:
        hint = ""
        # The number is probably in nanometres or micrometres.
        if 100 <= metres <= 20000:
            hint = f"; for {metres:g} nm give {metres:g}e-9"
        elif 0.05 <= metres < 100:
            hint = f"; for {metres:g} um give {metres:g}e-6"
        raise ValueError(f"{name} is in metres and must be from 1e-12 to 1e-2, got {metres:g}{hint}")
    return metres


def pixel(value: object, *, metric: bool) -> float:
    """Return a pixel pitch, in metres (at most 0.1) if `metric`, else in units of lambda*N."""
    pitch = real("pixel", value, above=0.0, unit="metres" if metric else "lambda*N")
    if metric and pitch > 0.1:
        raise ValueError(
            f"pixel is in metres for a pupil with a wavelength and must be at most 0.1, got {pitch:g}; "
            f"for {pitch:g} um give {pitch:g}e-6"
        )
    return pitch


EITHER = "metres or lambda*N"
"""Unit of lengths on the sensor, for messages: which of both is known with the pupil."""


def pitch(name: str, value: object) -> float | tuple[float, float]:
    """Return the side of a square pixel, or (height, width) if these differ; ValueError unless positive."""
    if not isinstance(value, tuple | list):
        return real(name, value, above=0.0, unit=EITHER)
    if len(value) != 2:
        raise ValueError(f"{name} must be one number, or (height, width), got {shown(value)}")
    height, width = (real(f"{name}[{k}]", side, above=0.0, unit=EITHER) for k, side in enumerate(value))
    return height if height == width else (height, width)


def fill(name: str, value: object) -> tuple[float, float]:
    """Return the active fractions of a pixel's height and width, from two fractions or a fraction of the area."""
    if not isinstance(value, tuple | list):
        side = math.sqrt(_part(name, value))
        return side, side
    if len(value) != 2:
        raise ValueError(f"{name} must be one number, or fractions (of height, of width), got {shown(value)}")
    return _part(f"{name}[0]", value[0]), _part(f"{name}[1]", value[1])


def _part(name: str, value: object) -> float:
    part = real(name, value, above=0.0)
    if part > 1.0:
        raise ValueError(f"{name} must be at most 1, got {part:g}")
    return part


def reach(name: str, v: float, scale: float, unit: str) -> None:
    """Raise ValueError if what `name` names extends beyond MAX_REACH, to `v`; `scale` is lambda*N in `unit`."""
    if not v <= MAX_REACH:
        limit = f"{MAX_REACH / math.pi * scale:.3g} {unit}"
        raise ValueError(f"{name} reaches v = {v:.3g} from the axis; the limit is {MAX_REACH:.0e}, here {limit}")


def pixel_on(pitch: float, scale: float, *, metric: bool) -> None:
    """Raise ValueError for a pixel pitch out of range; `scale` is lambda*N in the unit of `pitch`."""
    if metric and pitch > 0.1:
        pixel(pitch, metric=True)
    if not 1e-4 <= pitch / scale <= 1e6:
        metres = f"{pitch:g} m, that is " if metric else ""
        hint = "" if metric or pitch > 1e-4 else "; for metres give the pupil a wavelength and an f_number"
        raise ValueError(f"pixel must be from 1e-4 to 1e6 lambda*N, got {metres}{pitch / scale:.3g}{hint}")
