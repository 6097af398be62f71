"""Bessel functions of the first kind (compiled), and the approximations of J0 in the paper of docs/paper.md."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from lommel.base.arrays import Array
from lommel.base.validation import MAX_REACH
from lommel.core import engine


def bessel_sequence(v: ArrayLike, count: int) -> Array:
    """Return ``J_0(v), ..., J_{count-1}(v)`` for ``0 <= v <= 1e6``.

    Computed by Miller's backward recurrence (DLMF 3.6(vi)), with an absolute error of a few units of 2^-53.

    Parameters
    ----------
    v : array_like, shape (n,)
    count : int

    Returns
    -------
    ndarray, shape (n, count)
    """
    return engine.bessel_sequence(_radii(v), count)


def j0_series(a: ArrayLike, terms: int = 3) -> Array:
    """Return a polynomial approximation of J0: the first terms of its power series (paper, Eq. 6; DLMF 10.2.2).

    Parameters
    ----------
    a : array_like
    terms : int, default 3

    Returns
    -------
    ndarray
    """
    # J0(a) = sum (-a^2 / 4)^m / m!^2.
    q = -0.25 * np.asarray(a, dtype=np.float64) ** 2
    return np.asarray(np.polynomial.polynomial.polyval(q, [1.0 / math.factorial(m) ** 2 for m in range(terms)]))


def j0_asymptotic(a: ArrayLike) -> Array:
    """Return ``sqrt(2 / (pi a)) cos(a - pi/4)`` for a > 0 (paper, Eq. 7; DLMF 10.17.3, leading term).

    Parameters
    ----------
    a : array_like

    Returns
    -------
    ndarray
    """
    x = np.asarray(a, dtype=np.float64)
    return np.asarray(np.sqrt(2 / (np.pi * x)) * np.cos(x - np.pi / 4))


def tangent_line(center: float) -> tuple[float, float]:
    """Return A and B of ``1/sqrt(a) ~ A a + B + 1/a``, where ``A a + B`` is the tangent at `center` (Eq. 9-11).

    Parameters
    ----------
    center : float
        Above 0.

    Returns
    -------
    A, B : float
    """
    return -0.5 * center**-1.5, 1.5 * center**-0.5


def _radii(v: ArrayLike) -> Array:
    radii = np.ascontiguousarray(v, dtype=np.float64)
    invalid = ~(np.isfinite(radii) & (radii >= 0))
    if radii.ndim != 1 or invalid.any():
        value = f"shape {radii.shape}" if radii.ndim != 1 else radii[invalid][0]
        raise ValueError(f"v must be a one-dimensional array of finite numbers >= 0, got {value}")
    # At larger v there is less than 1e-17 of the light: certificate, section 3.
    if radii.size and radii.max() > MAX_REACH:
        raise ValueError(f"v must be at most {MAX_REACH:.0e}, got {radii.max():g}")
    return radii
