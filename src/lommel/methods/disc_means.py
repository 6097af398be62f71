r"""Means over discs of light that is known along the radius, from few of its values, with a proven error.

A radial intensity between 0 and 1 whose spatial frequencies end at 2 (in v) is within 1/2 of a constant, and its
continuation to complex places ``x + i y`` within ``exp(2 abs(y)) / 2`` of it (Plancherel and Polya). That bounds:

- the mean over a circle by m points, ``exp(2 s sinh eta) / (exp(m eta) - 1)`` for every eta > 0;
- the mean over radii by n Gauss points in their squares, ``2 exp(2 a sinh(eta / 2)) rho^(1 - 2 n) / (rho - 1)`` with
  ``rho = exp(eta)``, since on Bernstein's ellipse around [0, 1] no imaginary part of ``sqrt(t)`` is above
  ``sinh(eta / 2)``;
- values between those of an even table of step h, by polynomials of degree 11:
  ``(2 h)^12 max(abs(omega)) / (2 * 12!)`` (Bernstein's inequality).

References
----------
L. N. Trefethen, *Approximation Theory and Approximation Practice* (SIAM, 2013), theorem 8.2.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.special.legendre import gauss_legendre

_HALF = 6
"""Half of the points that an interpolation takes."""
_OMEGA = math.prod(k + 0.5 for k in range(_HALF)) ** 2 / math.factorial(2 * _HALF)
_STEP_MOST = 0.5
_ETA = np.geomspace(0.02, 12.0, 96)
_ROUNDING = 2.0**-46  # of sums of at most some thousand products, whose weights sum to a few


class DiscMeans(NamedTuple):
    """Where to know an intensity, and what to make of it.

    Attributes
    ----------
    places : ndarray, shape (places,)
        Rising v.
    weights : scipy.sparse array, shape (places, radii)
        ``values @ weights`` are the means, for values of shape ``(n, places)``.
    gain : float
        How much errors of the values may grow.
    error : float
        Of the means, over the peak that the intensity would have without aberration.
    """

    places: Array
    weights: Any
    gain: float
    error: float


def disc_means(v: Array, radius: float, error: float) -> DiscMeans:
    """Return how to average an intensity over discs around points at radii `v`.

    Parameters
    ----------
    v : ndarray, shape (radii,)
    radius : float
        Of the discs, in v.
    error : float
        At most so much.

    Returns
    -------
    DiscMeans
    """
    from scipy.sparse import coo_array

    step = min(_STEP_MOST, 0.5 * (error / (1.5 * _OMEGA)) ** (0.5 / _HALF))  # a third of the error
    (x, y), w = _points(radius, error / 1.5)
    away = np.hypot(v[:, None] + x, y) / step
    first = np.floor(away).astype(np.int64)
    offsets = np.arange(1 - _HALF, _HALF + 1)
    known, row = np.unique(np.abs(first[..., None] + offsets), return_inverse=True)
    column = np.broadcast_to(np.arange(v.size)[:, None, None], (*away.shape, offsets.size))
    data = w[:, None] * _lagrange(away - first)
    made = coo_array((data.ravel(), (row.ravel(), column.ravel())), shape=(known.size, v.size)).tocsr()
    gain = float(np.abs(made).sum(axis=0).max(initial=1.0))
    return DiscMeans(step * known, made, gain, error + _ROUNDING)


def _lagrange(offset: Array) -> Array:
    """Return the weights of twelve even places for a value `offset` beyond the sixth."""
    away = offset[..., None] - np.arange(1 - _HALF, _HALF + 1)
    out = np.empty(away.shape)
    for k in range(2 * _HALF):
        out[..., k] = np.delete(away, k, axis=-1).prod(axis=-1)
        out[..., k] /= math.prod(k - j for j in range(2 * _HALF) if j != k)
    return out


def _points(radius: float, error: float) -> tuple[Array, Array]:
    """Return points (x, y) of half a disc, shape (2, points), and weights; their sum errs by at most `error`."""
    around, across = 2, 1
    while _circle_error(radius, around) > 0.5 * error:
        around += 2
    while _radius_error(radius, across) > 0.5 * error:
        across += 1
    t, w = gauss_legendre(across)
    theta = math.pi * (2 * np.arange(around // 2) + 1) / around
    r = radius * np.sqrt(t)[:, None]
    points = np.stack([r * np.cos(theta), r * np.sin(theta)]).reshape(2, -1)
    return points, np.repeat(w * (2.0 / around), around // 2)


def _circle_error(radius: float, around: int) -> float:
    with np.errstate(over="ignore"):
        return float((np.exp(2.0 * radius * np.sinh(_ETA) - around * _ETA) / -np.expm1(-around * _ETA)).min())


def _radius_error(radius: float, across: int) -> float:
    growth = 2.0 * radius * np.sinh(0.5 * _ETA)
    return gauss_error(growth - math.log(2.0), across)


def gauss_error(growth: Array, nodes: int) -> float:
    """Bound the error of a mean by a Gauss rule of an analytic function.

    Parameters
    ----------
    growth : ndarray
        Logarithms of bounds on its modulus, on the ellipses of :func:`ellipses`.
    nodes : int

    Returns
    -------
    float
        The rule is exact for degree ``2 nodes - 1``, and its weights are positive and sum to 1.
    """
    with np.errstate(over="ignore"):
        return float((4.0 * np.exp(growth - (2 * nodes - 1) * _ETA) / np.expm1(_ETA)).min())


def ellipses() -> Array:
    """Return the eta of Bernstein's ellipses, through ``cosh(eta)``, that bounds are looked for on."""
    return _ETA
