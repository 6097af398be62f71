"""Errors of images relative to a reference image."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array


def mse(values: ArrayLike, reference: ArrayLike) -> float:
    """Return the mean squared error divided by the squared peak of the reference, as in Wei et al. (lommel.paper).

    Parameters
    ----------
    values, reference : array_like
        Arrays or :class:`lommel.PSF`, of equal shape.

    Returns
    -------
    float
        Mean of ``(values - reference)^2`` divided by ``max(reference)^2``.

    Raises
    ------
    TypeError, ValueError
        If the values are not finite or the shapes differ, if the reference has no positive value, or if the error
        overflows.
    """
    return _relative_error(lambda a, b: np.mean(((a - b) / b.max()) ** 2), values, reference)


def peak_error(values: ArrayLike, reference: ArrayLike) -> float:
    """Return the largest absolute error divided by the peak of the reference.

    Parameters
    ----------
    values, reference : array_like
        Arrays or :class:`lommel.PSF`, of equal shape.

    Returns
    -------
    float
        Largest ``abs(values - reference)`` divided by ``max(reference)``.

    Raises
    ------
    TypeError, ValueError
        On the conditions of :func:`~lommel.measures.errors.mse`.
    """
    return _relative_error(lambda a, b: np.abs(a - b).max() / b.max(), values, reference)


def _relative_error(error: Callable[[Array, Array], float], values: ArrayLike, reference: ArrayLike) -> float:
    a, b = validation.real_array("values", values), validation.real_array("reference", reference)
    if a.shape != b.shape:
        raise ValueError(f"values and reference must have the same shape, got {a.shape} and {b.shape}")
    if not b.size or not b.max() > 0:
        raise ValueError(f"reference must have a positive value, got an array of shape {b.shape} without one")
    with np.errstate(over="ignore"):  # an infinite result is rejected below
        result = float(error(a, b))
    if not math.isfinite(result):
        raise ValueError(
            "values and reference must not differ so much that the error overflows, got largest values of "
            f"{np.abs(a).max():g} and {b.max():g}"
        )
    return result
