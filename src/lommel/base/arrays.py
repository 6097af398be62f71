"""What is a number, or an array of them: one for each of a stack."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Numbers = np.float64 | NDArray[np.float64]


def largest(values: NDArray[Any]) -> float:
    """Return the largest of some values; of one, as of most answers, without what a reduction costs."""
    return float(values.item() if values.size == 1 else values.max())


def numbers(values: Any, shape: tuple[int, ...]) -> Numbers:
    """Return an array of this shape, or the number that one without axes holds."""
    found: Numbers = np.asarray(values, dtype=np.float64).reshape(shape)[()]
    return found
