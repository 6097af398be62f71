"""Intensities that are made of others, to a tolerance over what their peak turns out to be."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Intensities, not_met

LEAST = 1e-13
_BRIGHT = (0.0, 1.8412)  # the axis, and the maximum of J1: where something is bright in most planes


def proven(v: Array, made_of: Callable[[Array, float], tuple[Array, Array]], tol: float) -> Intensities:
    """Return intensities whose error is at most `tol` of the peak that is found.

    Parameters
    ----------
    v : ndarray, shape (radii,)
    made_of : callable
        From rising radii and an accuracy to values, shape ``(n, radii)``, and what they are off by at most, ``(n,)``.
    tol : float

    Returns
    -------
    Intensities

    Raises
    ------
    ToleranceError
        If it cannot be met.
    """
    at, where = np.unique(np.append(v, _BRIGHT), return_inverse=True)
    asked = 0.1 * tol
    while True:
        values, error = made_of(at, asked)
        least = values.max(axis=1) - error
        relative = np.divide(error, least, out=np.full(least.shape, np.inf), where=least > 0.0)
        if (worst := float(relative.max(initial=0.0))) <= tol:
            return Intensities(values[:, where[: v.size]], relative, least)
        if asked <= LEAST:
            raise not_met(tol, worst, "the peak")
        asked = max(LEAST, asked * max(1e-4, min(0.5, 0.5 * tol / worst)))
