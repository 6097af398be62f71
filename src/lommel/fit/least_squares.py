"""Generalised least squares, and a scatter of the data that their stated errors do not explain."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.fit import goodness_of_fit
from lommel.fit.findings import Finding

_HALVINGS = 40
_OUTLIER, _NEAREST = 10.0, 0.03  # times the median distance, or this one
_MOST_OUTLIERS = 0.2  # of the data


class LinearFit(NamedTuple):
    """Parameters (p,) of generalised least squares, their covariance (p, p), and chi2 per degree of freedom."""

    values: Array
    covariance: Array
    chi2: float


def least_squares(design: Array, data: Array, weight: Array, prior: Array, mean: Array, freedom: int) -> LinearFit:
    """Return the parameters x that minimise ``sum_i |design_i x - data_i|^2 + |x - mean|^2``.

    Squares of `data` (n, a) are weighted by `weight` (n, a, a), the inverse covariance of each datum, and those of
    the parameters by `prior` (p, p), their information before. `design` is (n, a, p). Parameters that nothing
    determines are 0.
    """
    weighted = weight @ design
    normal = np.tensordot(design, weighted, ([0, 1], [0, 1])) + prior
    scale = 1.0 / np.sqrt(np.maximum(np.diag(normal), 1e-300))
    scales = np.outer(scale, scale)
    inverse = np.linalg.pinv(normal * scales, rcond=1e-13, hermitian=True) * scales
    values = inverse @ (np.tensordot(weighted, data, ([0, 1], [0, 1])) + prior @ mean)
    off, moved = design @ values - data, values - mean
    total = float(np.einsum("ni,nij,nj->", off, weight, off) + moved @ prior @ moved)
    return LinearFit(values, inverse, total / freedom)


def fit_scatter(fit: Callable[[float], LinearFit], most: float) -> tuple[LinearFit, float, float]:
    """Return the fit whose scatter makes chi2 1, this scatter, at most `most`, and chi2 without it.

    `fit` gets the standard deviation of the scatter. It is 0 where chi2 is below 1 without.
    """
    found = fit(0.0)
    scatter, chi2 = 0.0, found.chi2
    if chi2 > 1.0:
        low, high = 0.0, most
        for _ in range(_HALVINGS):
            scatter = 0.5 * (low + high)
            found = fit(scatter)
            low, high = (scatter, high) if found.chi2 > 1.0 else (low, scatter)
    return found, scatter, chi2


def scatter_findings(what: str, unit: str, scatter: float, chi2: float, freedom: int) -> list[Finding]:
    """Return the finding of a scatter, in words, where noise does not explain chi2 without it."""
    limit = float(goodness_of_fit.most(math.sqrt(2.0 / freedom)))
    text = f"{what} scatter by {scatter:.2g} {unit} beside noise, which standard errors include"
    numbers = {"scatter": scatter, "chi2": chi2, "limit": limit}
    return [Finding("scatter", "note", text, numbers)] if chi2 > limit else []


def inliers(distance: Array) -> NDArray[np.bool_] | None:
    """Return which distances from a robust fit are not far; None where too many are, as of too plain a model."""
    near = distance <= _OUTLIER * max(1.4826 * float(np.median(distance)), _NEAREST)
    return near if near.mean() >= 1.0 - _MOST_OUTLIERS else None
