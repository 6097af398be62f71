"""Types of arrays and of plain data (JSON), and conversion of results to plain data."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping, Sequence
from enum import Enum
from types import EllipsisType
from typing import TYPE_CHECKING, Any, SupportsIndex

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

Array = NDArray[np.float64]
Values = NDArray[Any]
"""Arrays of float32 or float64, for which NumPy has no common type."""
Numbers = np.float64 | NDArray[np.float64]
_Index = SupportsIndex | slice | EllipsisType | Sequence[int] | NDArray[np.integer[Any]] | NDArray[np.bool_] | None
Index = _Index | tuple[_Index, ...]
"""Index of an array, as NumPy accepts it."""
Json = dict[str, Any]
"""Object in plain types, as JSON represents it."""


def largest(values: Values) -> float:
    """Return the largest value."""
    # Single PSFs are frequent, and reading a value is faster than a reduction.
    return float(values.item() if values.size == 1 else values.max())


def numbers(values: object, shape: tuple[int, ...]) -> Numbers:
    """Return `values` as an array of this shape, or as a number if the shape is ()."""
    result: Numbers = np.asarray(values, dtype=np.float64).reshape(shape)[()]
    return result


def plain(value: object) -> Any:
    """Return a value as plain data.

    Dataclasses become dictionaries of the public fields that their repr shows, and named tuples dictionaries of their
    fields. Arrays and sequences become lists, tuple keys text such as "2,0", and numbers that are not finite None.
    """
    if hasattr(value, "to_dict"):
        return plain(value.to_dict())
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return plain(fields_of(value))
    if hasattr(value, "_asdict"):
        # JSON has only string keys, and neither infinity nor NaN.
        return {name: plain(each) for name, each in value._asdict().items()}
    if isinstance(value, Mapping):
        return {_key(name): plain(each) for name, each in value.items()}
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, tuple | list):
        return [plain(each) for each in value]
    if isinstance(value, Enum):
        return plain(value.value)
    if isinstance(value, float | np.floating):
        return float(value) if math.isfinite(value) else None
    return value.item() if isinstance(value, np.generic) else value


def fields_of(value: DataclassInstance) -> Json:
    """Return the public fields of a dataclass that its repr shows."""
    names = (item.name for item in dataclasses.fields(value) if item.repr and not item.name.startswith("_"))
    return {name: getattr(value, name) for name in names}


def _key(name: object) -> str:
    return ",".join(map(str, name)) if isinstance(name, tuple) else str(name)
