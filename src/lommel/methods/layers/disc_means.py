r"""Means of radial intensities over discs, from few samples, with a proven error bound.

An intensity between 0 and 1 whose spatial frequencies end at 2 (in v) is within 1/2 of a constant, and its
continuation to complex places ``x + i y`` within ``exp(2 abs(y)) / 2`` of it (Plancherel and Polya). That bounds:

- the mean over a circle by m points, ``exp(2 s sinh eta) / (exp(m eta) - 1)`` for every eta > 0;
- the mean over radii by n Gauss points in their squares, ``2 exp(2 a sinh(eta / 2)) rho^(1 - 2 n) / (rho - 1)`` with
  ``rho = exp(eta)``, since on Bernstein's ellipse around [0, 1] no imaginary part of ``sqrt(t)`` is above
  ``sinh(eta / 2)``;
- values between those of an even table of step h, by polynomials of degree 11:
  ``(2 h)^12 max(abs(omega)) / (2 * 12!)`` (Bernstein's inequality).

Of light ``sum_m F_m(r) exp(i m phi)`` all three can be done to each order apart: a disc is its own mirror image at
the line from the axis to its middle, so the mean of an order has that order, and along a line through the axis F_m at
negative r is ``(-1)^m`` times that at positive r. What is done to the orders sums to the same rule done to the light
itself, which the bounds are of.

References
----------
L. N. Trefethen, *Approximation Theory and Approximation Practice* (SIAM, 2013), theorem 8.2.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.special.legendre import gauss_legendre

HALF = 6  # half of the points that an interpolation takes
_OMEGA = math.prod(k + 0.5 for k in range(HALF)) ** 2 / math.factorial(2 * HALF)
_APART = np.array([math.prod(k - j for j in range(2 * HALF) if j != k) for k in range(2 * HALF)], np.float64)
_STEP_MOST = 0.5
ETA = np.geomspace(0.02, 12.0, 96)  # of Bernstein's ellipses, through ``cosh(eta)``, that bounds are looked for on
_ROUNDING = 2.0**-46  # of sums of at most some thousand products, whose weights sum to a few


Values = NDArray[np.float64] | NDArray[np.complex128]  # orders of the azimuth, real where the order 0 is alone


class DiscMeans(NamedTuple):
    """Radii where an intensity has to be known, and the weights of its means over discs."""

    places: Array  # rising v
    weights: tuple[Any, ...]  # sparse (places, radii), of the orders m and -m for each m
    gain: float  # factor by which errors of the values may grow
    error: float  # of the means, over the peak of the intensity without aberration

    def of(self, values: Values) -> Values:
        """Return the means of the orders -M to M, ``(n, 2 M + 1, radii)``, of ``(n, 2 M + 1, places)``."""
        middle = values.shape[1] // 2
        made = [values[:, middle + m] @ self.weights[abs(m)] for m in range(-middle, middle + 1)]
        return np.stack(made, axis=1)


def disc_means(v: Array, radius: float, error: float, order: int = 0) -> DiscMeans:
    """Return how to average an intensity over discs around points at radii `v`."""
    from scipy.sparse import coo_array

    step = table_step(error / 3.0)
    (x, y), w = _points(radius, error / 1.5)
    along = v[:, None] + x
    first, shares = between(np.hypot(along, y) / step)
    row = first[..., None] + np.arange(2 * HALF)
    away = np.abs(row)
    is_known = np.zeros(away.max(initial=0) + 1, np.bool_)
    is_known[away] = True
    known, place = np.flatnonzero(is_known), np.cumsum(is_known)[away] - 1
    column = np.broadcast_to(np.arange(v.size)[:, None, None], row.shape).ravel()
    data, shape, made = w[:, None] * shares, (known.size, v.size), []
    for m in range(order + 1):
        around = np.cos(m * np.arctan2(y, along))[..., None] * np.where(row < 0, (-1.0) ** m, 1.0) if m else 1.0
        made.append(coo_array(((data * around).ravel(), (place.ravel(), column)), shape=shape).tocsr())
    gain = float((w * np.abs(shares).sum(axis=-1)).sum(axis=-1).max(initial=1.0))
    return DiscMeans(np.asarray(step * known), tuple(made), gain, error + _ROUNDING)


def table_step(error: float) -> float:
    """Return how far apart even places may be for :func:`between` to err by `error`."""
    return float(min(_STEP_MOST, 0.5 * (2.0 * error / _OMEGA) ** (0.5 / HALF)))


def growth() -> float:
    """Return how much errors of even values may grow between them: it is most midway."""
    return float(np.abs(between(np.array([0.5]))[1]).sum())


def between(at: Array) -> tuple[NDArray[np.int64], Array]:
    """Return how values `at` any places are made of those at whole ones: the first of twelve, and their weights."""
    below = np.floor(at).astype(np.int64)
    away = (at - below)[..., None] - np.arange(1 - HALF, HALF + 1)
    weights = np.ones(away.shape)
    weights[..., 1:] = np.cumprod(away[..., :-1], axis=-1)
    weights[..., :-1] *= np.cumprod(away[..., :0:-1], axis=-1)[..., ::-1]
    return below + (1 - HALF), weights / _APART


def _points(radius: float, error: float) -> tuple[Array, Array]:
    """Return points (x, y) of half a disc, shape (2, points), and weights; their sum errs by at most `error`."""
    around, across = 2, 1
    while _circle_error(radius, around) > 0.5 * error:
        around += 2
    while gauss_error(2.0 * radius * np.sinh(0.5 * ETA) - math.log(2.0), across) > 0.5 * error:
        across += 1
    t, w = gauss_legendre(across)
    theta = math.pi * (2 * np.arange(around // 2) + 1) / around
    r = radius * np.sqrt(t)[:, None]
    points = np.stack([r * np.cos(theta), r * np.sin(theta)]).reshape(2, -1)
    return points, np.repeat(w * (2.0 / around), around // 2)


def _circle_error(radius: float, around: int) -> float:
    with np.errstate(over="ignore"):
        return float((np.exp(2.0 * radius * np.sinh(ETA) - around * ETA) / -np.expm1(-around * ETA)).min())


def gauss_error(growth: Array, nodes: int) -> float:
    """Bound the error of a mean by a Gauss rule of an analytic function."""
    with np.errstate(over="ignore"):
        return float((4.0 * np.exp(growth - (2 * nodes - 1) * ETA) / np.expm1(ETA)).min())
