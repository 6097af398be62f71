"""Units and labelled axes of what is given as a number or an array: converted, put in order, or refused by name."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

POWERS = {"m": 0, "km": 3, "cm": -2, "mm": -3, "um": -6, "µm": -6, "μm": -6, "nm": -9, "pm": -12, "angstrom": -10}
LENGTHS = {unit: float(f"1e{power}") for unit, power in POWERS.items()} | {"in": 25.4e-3, "inch": 25.4e-3}
"""Metres of each unit of length."""
ANGLES = {
    "rad": 1.0,
    "mrad": 1e-3,
    "deg": math.pi / 180,
    "arcmin": math.pi / 10800,
    "arcsec": math.pi / 648000,
    "mas": math.pi / 648000000,
}
"""Radians of each unit of angle."""

# Units of length in files, in metres, as OME, OME-Zarr, ImageJ and xarray name them.
_PREFIXES = {"": 0, "centi": -2, "milli": -3, "micro": -6, "nano": -9, "pico": -12}
_METRES = LENGTHS | {
    "\\u00B5m": 1e-6,
    "micron": 1e-6,
    "microns": 1e-6,
    "Å": 1e-10,
    "\u212b": 1e-10,
    "inches": 25.4e-3,
}
_METRES |= {
    f"{prefix}{metre}{s}": float(f"1e{power}")
    for prefix, power in _PREFIXES.items()
    for metre in ("meter", "metre")
    for s in ("", "s")
}
# By the symbol of astropy and unyt, what the units that a text may state are in it.
_TEXTS = {
    "m": _METRES,
    "rad": ANGLES | {"radian": 1.0, "radians": 1.0, "degree": math.pi / 180, "degrees": math.pi / 180},
    "s": {"s": 1.0, "ms": 1e-3, "us": 1e-6, "second": 1.0, "seconds": 1.0, "millisecond": 1e-3, "min": 60.0},
    "electron": dict.fromkeys(("electron", "electrons", "e-"), 1.0),
    "pixel": dict.fromkeys(("pixel", "pixels", "pix", "px"), 1.0),
    "": {"": 1.0, "1": 1.0, "dimensionless": 1.0, "percent": 1e-2, "%": 1e-2},
}
_TEXTS["1/m"] = {f"1/{unit}": 1.0 / size for unit, size in _METRES.items()}
# The unit of an argument, as messages name it: its symbol, and its size in the unit of the symbol.
_SYMBOLS = {
    "metres": "m",
    "radians": "rad",
    "1/metres": "1/m",
    "seconds": "s",
    "electrons": "electron",
    "electrons per count": "electron/adu",
    "pixels": "pixel",
}
_UNITS = {word: (symbol, 1.0) for word, symbol in _SYMBOLS.items()} | {"": ("", 1.0), "meters": ("m", 1.0)}
_UNITS |= {unit: ("m", size) for unit, size in LENGTHS.items()}
_LEVELS = ("adu", "ct", "count", "counts", "dn")
_COUNTS = {"counts": (*_LEVELS, "electron", "electrons", "ph", "photon"), "levels of the camera": _LEVELS}
AXES = {"T": ("t", "time", "frame"), "C": ("c", "channel"), "Z": ("z", "plane"), "Y": ("y", "row", "rows", "height")}
AXES |= {"X": ("x", "col", "column", "columns", "width")}
"""Names of the axes of images by their letter, in the order of arrays; axes of other names come first."""
LETTERS = {name: letter for letter, names in AXES.items() for name in names}
"""The letter of each name of an axis."""
EVEN = 0.02
"""Relative difference up to which steps of coordinates, and sizes that are stated twice, agree."""
BARE = (float, int, np.ndarray, np.float64, str, bool, type(None))
"""Types without unit, labels or mask, tested first because they are frequent."""


def metres_of(unit: str) -> float:
    """Return the metres of a unit as files name it; KeyError for others."""
    # Short names are case-sensitive ("Mm" is not "mm"); long names are not.
    return _METRES[unit.lower() if unit not in _METRES and len(unit) > 3 else unit]


def in_unit(name: str, value: Any, unit: str = "") -> Any:
    """Return a number, array or list without units and labels, in the unit of an argument.

    Parameters
    ----------
    name : str
        Argument, for messages.
    value : object
        What has no unit and no labels is returned as it is. Units are those of astropy (arrays, columns, NDData),
        pint, unyt, and the attribute ``units`` of xarray; labels are the dimensions of xarray.
    unit : str
        Unit of the argument: "metres", "radians", "1/metres", "seconds", "electrons", "pixels", a unit of length, ""
        (none), "counts" (what a camera recorded, in its own unit), or another that none knows, such as "lambda*N".

    Raises
    ------
    ValueError
        If the unit cannot be converted, or if labels contradict the order of axes: rows before columns.
    """
    if type(value) in BARE:
        return value
    if isinstance(value, list | tuple):
        if all(type(part) in BARE for part in value):
            return value
        parts = [in_unit(f"{name}[{k}]", part, unit) for k, part in enumerate(value)]
        same = all(new is old for new, old in zip(parts, value, strict=True))
        return value if same else parts if isinstance(value, list) else tuple(parts)
    if type(value).__module__.partition(".")[0] in ("builtins", "lommel"):
        return value
    if isinstance(dims := getattr(value, "dims", None), tuple) and hasattr(value, "transpose"):
        return _unlabelled(name, value, dims, unit)
    columns = getattr(value, "columns", None)  # of pandas
    if columns is not None and getattr(columns, "dtype", np.dtype(int)).kind in "OUT":
        raise ValueError(
            f"{name} has columns named {_listed(columns)}, which no argument has; give {name}.to_numpy()"
        )
    stated = stated_unit(value)
    return value if stated is None else _converted(name, value, stated, unit)


def stated_unit(value: Any) -> Any:
    """Return the unit that a value, or the first of a list, states, in the form of its library; None without one."""
    if isinstance(value, list | tuple) and value:
        return stated_unit(value[0])
    if type(value) in BARE:
        return None
    attributes = value.attrs if isinstance(getattr(value, "dims", None), tuple) else {}  # of xarray
    held = (value, getattr(value, "data", None))
    stated = [attributes.get("units"), attributes.get("unit")]
    stated += [getattr(part, key, None) for part in held for key in ("unit", "units")]
    # Other libraries have functions and pairs of these names.
    return next((unit for unit in stated if not (unit is None or callable(unit) or isinstance(unit, tuple))), None)


def is_angle(stated: Any) -> bool:
    """Whether a stated unit is one of angle."""
    return str(stated) in _TEXTS["rad"]


def refuse_electrons(name: str, value: Any) -> None:
    """Raise ValueError for an array in electrons, or a list of such, where a noise states electrons per count."""
    for part in value if isinstance(value, list | tuple) else [value]:
        if str(stated_unit(part)).lower() in ("electron", "electrons"):
            raise ValueError(
                f"{name} must be in counts with a noise that states white, got electrons: leave white out"
            )


def _unlabelled(name: str, value: Any, dims: tuple[Any, ...], unit: str) -> Any:
    """Return what a labelled array holds, its axes in order: rows before columns, and these behind all others."""
    letters = [LETTERS.get(str(dim).lower(), "") for dim in dims]
    if len(dims) > 1 and any(letters):
        if letters.count("Y") != 1 or letters.count("X") != 1:
            raise ValueError(f"{name} must have one axis of rows and one of columns, got the axes {_listed(dims)}")
        value = value.transpose(*in_order(dims))
    elif len(dims) > 1 and not all(str(dim).startswith("dim_") for dim in dims):
        raise ValueError(
            f"{name} must have axes named y and x, or row and column, behind all others, got {_listed(dims)}; "
            f"give {name}.values if its axes are in order"
        )
    (y, of_y), (x, of_x) = (spacings(name, value).get(letter, (1.0, None)) for letter in "YX")
    if unit not in _COUNTS and of_x == of_y and abs(y - x) > EVEN * x:  # cameras have pixels of any sides
        raise ValueError(f"{name} must have square pixels, got coordinates in steps of {y:g} (y) and {x:g} (x)")
    stated = stated_unit(value)
    return value.data if stated is None else _converted(name, value.data, stated, unit)


def spacings(name: str, value: Any) -> dict[str, tuple[Any, Any]]:
    """Return the step of the coordinates along Z, Y and X of a labelled array, and its unit or None, by letter.

    The step of uneven planes is a text. ValueError if rows or columns do not rise in equal steps.
    """
    found: dict[str, tuple[Any, Any]] = {}
    for dim in value.dims if hasattr(value, "coords") and len(value.dims) > 1 else ():
        letter, axis = LETTERS.get(str(dim).lower(), "?"), value.coords.get(dim)
        if letter not in "ZYX" or axis is None or axis.dtype.kind not in "iuf" or axis.size < 2:
            continue
        steps = np.diff(np.asarray(axis, np.float64))
        mean, text = float(steps.mean()), f"{steps.min():g} to {steps.max():g}"
        is_even = np.abs(steps - mean).max() <= EVEN * abs(mean)
        if letter != "Z" and not (is_even and mean > 0.0):
            raise ValueError(
                f"{name} must have coordinates {dim} that rise in equal steps, got steps of {text}: resample or sort "
                "it (sortby), or drop them (drop_vars)"
            )
        found[letter] = mean if is_even else text, stated_unit(axis)
    return found


def in_order(dims: Sequence[Any]) -> list[Any]:
    """Return names of axes in the order of those of arrays: others, time, channel, z, y, x."""
    return sorted(dims, key=lambda dim: "TCZYX".find(LETTERS.get(str(dim).lower(), "?")))


def _listed(names: Any) -> str:
    return ", ".join(map(str, names))[:80]


def _converted(name: str, value: Any, stated: Any, unit: str) -> Any:
    """Return the numbers of a quantity in the unit of the argument."""
    if unit in _COUNTS:
        if str(stated).lower().strip() not in _COUNTS[unit]:
            raise ValueError(f"{name} must be in {unit} ({', '.join(_COUNTS[unit])}), got the unit {stated}")
        factor = 1.0
    else:
        try:
            symbol, size = _UNITS[unit]
            factor = _factor(stated, symbol) / size
        except Exception:  # each library raises errors of its own, and this table KeyError
            wanted = "metres" if unit == "m" else unit or "no unit"
            hint = "" if unit in _UNITS else "; give a number"
            raise ValueError(f"{name} must be in {wanted}, got the unit {str(stated) or 'none'}{hint}") from None
    held = (getattr(value, key, None) for key in ("magnitude", "value"))  # pint; astropy and unyt
    values = next((part for part in held if part is not None), value)
    if factor == 1.0:
        return values  # lazy arrays stay lazy
    data = values if isinstance(values, np.ndarray) else getattr(values, "data", values)  # NDData
    scaled, mask = factor * np.array(data, subok=False), getattr(value, "mask", None)
    return scaled[()] if mask is None else np.ma.masked_array(scaled, mask)


def _factor(stated: Any, symbol: str) -> float:
    """Return what numbers in a unit are multiplied by for another; an error of any kind if there is nothing."""
    if isinstance(stated, str):
        return _TEXTS[symbol][stated.replace(" ", "")] if symbol != "m" else metres_of(stated.strip())
    if symbol == "1/m" and any(word in str(stated) for word in ("cycle", "turn")):
        symbol = "cycle/m"  # a cycle is an angle, of 2 pi: cycles per metre are meant here
    if hasattr(stated, "dimensionality"):  # pint
        return float((1.0 * stated).to(symbol or "dimensionless").magnitude)
    if hasattr(stated, "get_conversion_factor"):  # unyt
        factor, offset = stated.get_conversion_factor(
            type(stated)(symbol or "dimensionless", registry=stated.registry)
        )
        if offset:
            raise ValueError
        return float(factor)
    return float(stated.to(symbol))
