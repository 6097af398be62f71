"""Errors of images against a reference."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array


def mse(values: ArrayLike, reference: ArrayLike) -> float:
    """Return the mean squared error relative to the squared peak of the reference, as the paper reports it.

    Parameters
    ----------
    values, reference : array_like
        Arrays of one shape, or :class:`lommel.PSF`.

    Returns
    -------
    float

    Raises
    ------
    TypeError, ValueError
        If these are not finite numbers of one shape, the reference has no positive peak, or the error exceeds the
        range of numbers.
    """
    return _finite(lambda a, b: np.mean(((a - b) / b.max()) ** 2), values, reference)


def peak_error(values: ArrayLike, reference: ArrayLike) -> float:
    """Return the largest absolute error relative to the peak of the reference.

    Parameters
    ----------
    values, reference : array_like
        Arrays of one shape, or :class:`lommel.PSF`.

    Returns
    -------
    float

    Raises
    ------
    TypeError, ValueError
        As :func:`mse`.
    """
    return _finite(lambda a, b: np.abs(a - b).max() / b.max(), values, reference)


def _finite(error: Callable[[Array, Array], float], values: ArrayLike, reference: ArrayLike) -> float:
    a, b = validation.real_array("values", values), validation.real_array("reference", reference)
    if a.shape != b.shape:
        raise ValueError(f"values and reference must have the same shape, got {a.shape} and {b.shape}")
    if not b.size or not b.max() > 0:
        raise ValueError("values and reference must be finite, and the reference have a positive peak")
    # An overflow becomes infinite, and is refused below.
    with np.errstate(over="ignore"):
        found = float(error(a, b))
    if not math.isfinite(found):
        raise ValueError(
            "values and reference differ by more than the range of numbers, got a largest of "
            f"{np.abs(a).max():g} and {b.max():g}"
        )
    return found
