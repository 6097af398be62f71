"""Array types, and parameters with one value for each PSF of a stack."""

from __future__ import annotations

from collections.abc import Sequence
from types import EllipsisType
from typing import Any, SupportsIndex

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Values = NDArray[Any]
"""Arrays of float32 or float64, for which NumPy has no common type."""
Numbers = np.float64 | NDArray[np.float64]
_Index = SupportsIndex | slice | EllipsisType | Sequence[int] | NDArray[np.integer[Any]] | NDArray[np.bool_] | None
Index = _Index | tuple[_Index, ...]
"""Index of an array, as NumPy takes it."""
Json = dict[str, Any]
"""Object in plain types, as JSON represents it."""


def largest(values: Values) -> float:
    """Return the largest value."""
    # Single PSFs are frequent, and reading a value is faster than a reduction.
    return float(values.item() if values.size == 1 else values.max())


def numbers(values: object, shape: tuple[int, ...]) -> Numbers:
    """Return an array of this shape, or the number of one without axes."""
    found: Numbers = np.asarray(values, dtype=np.float64).reshape(shape)[()]
    return found
