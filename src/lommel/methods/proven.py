"""Intensities that are made of others, to a tolerance over what their peak turns out to be."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Intensities
from lommel.methods.layered import BRIGHT_RING, settled
from lommel.methods.stratified import Stratified
from lommel.optics.objective_pupil import ObjectivePupil

_LEAST = 1e-13
_FINEST = 0.05
_BRIGHT = (0.0, BRIGHT_RING)  # where something is bright in most planes


def light(pupil: ObjectivePupil, v: Array, asked: float, tol: float) -> tuple[Array, Array]:
    """Return the intensity of a pupil at rising v and what it is off by at most, ``(n,)``.

    Its error is `asked` of its own peak, or 0.05 `tol`, which does where errors relate to that peak as those that are
    asked about do, and which double precision can hold.
    """
    made = Stratified(max(asked, _FINEST * tol, Stratified.least_tol)).profile(pupil, v)
    assert made.error is not None
    peak = made.values.max(axis=1) if made.peak is None else made.peak
    return made.values, made.error * peak


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
    made = settled(lambda asked: made_of(at, asked), tol, first=0.1 * tol, least=_LEAST, named=tol)
    return made._replace(values=made.values[:, where[: v.size]])
