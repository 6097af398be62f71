"""Types of arrays, and numbers that are one for each of a stack."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Values = NDArray[np.floating[Any]]
"""Of float32 or float64."""
Numbers = np.float64 | NDArray[np.float64]


def largest(values: Values) -> float:
    """Return the largest value; of a single one without the cost of a reduction."""
    return float(values.item() if values.size == 1 else values.max())


def numbers(values: object, shape: tuple[int, ...]) -> Numbers:
    """Return an array of this shape, or the number of one without axes."""
    found: Numbers = np.asarray(values, dtype=np.float64).reshape(shape)[()]
    return found
