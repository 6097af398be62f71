r"""How many nodes or terms an accuracy takes: bounds on Bernstein ellipses.

In t = rho^2 the integrand ``exp(i Phi(t)) J0(v sqrt t)`` is entire. On the ellipse
``t = c + h cos(theta + i eta)`` around ``[c - h, c + h]`` it is at most ``exp g(eta)`` with
``g = max_theta (abs(Im Phi) + v abs(Im sqrt t))``, and Gauss quadrature and Legendre series converge like
``exp(-2 n eta)`` and ``exp(-n eta)`` for every eta > 0; the best eta is taken.

References
----------
L. N. Trefethen, *Approximation Theory and Approximation Practice* (SIAM, 2013), Theorem 19.3.
H. Wang and S. Xiang, "On the convergence rates of Legendre approximation", Math. Comp. 81, 861 (2012),
doi:10.1090/S0025-5718-2011-02549-4.
"""

from __future__ import annotations

import itertools
import math

import numpy as np
from numpy.typing import NDArray

_ETA = np.geomspace(1e-3, 4.0, 96)
_STEPS = 128
_THETA = np.linspace(0.0, math.pi, _STEPS + 1)
_COSH, _SINH = np.cosh(_ETA)[:, None], np.sinh(_ETA)[:, None]

UNIT_ROUNDOFF = 2.0**-53


def growth(coefficients: NDArray[np.float64], low: float, v: float) -> NDArray[np.float64]:
    """Bound ``log|exp(i Phi) J0(v sqrt t)|`` on each ellipse around ``[low, 1]``, for a whole stack.

    The bound is convex in the coefficients, so the corners of their box bound the stack. The maximum over
    theta is taken on a grid and raised by ``1 / cos(degree step / 2)``, which bounds a trigonometric
    polynomial between grid points (Ehlich and Zeller, 1964).
    """
    half = 0.5 * (1.0 - low)
    t = 0.5 * (1.0 + low) + half * (np.cos(_THETA) * _COSH - 1j * np.sin(_THETA) * _SINH)
    degree = coefficients.shape[1]
    corners = itertools.product(*({float(c.min()), float(c.max())} for c in coefficients.T))
    exponent = np.zeros(t.shape)
    for corner in corners:
        phase = np.zeros_like(t)
        for c in reversed(corner):
            phase = (phase + c) * t
        np.maximum(exponent, np.abs(phase.imag), out=exponent)
    exponent += v * np.abs(np.sqrt(t).imag)
    return np.asarray(exponent.max(axis=1) / math.cos(0.5 * degree * math.pi / _STEPS))


def quadrature_error(g: NDArray[np.float64], n: int, low: float = 0.0) -> float:
    """Bound the error of n-point Gauss-Legendre quadrature over ``[low, 1]``, given :func:`growth`."""
    return _exp_min(_quadrature_log(g, low) - 2.0 * n * _ETA)


def quadrature_nodes(g: NDArray[np.float64], error: float, low: float = 0.0) -> int:
    """Return the fewest nodes for which :func:`quadrature_error` is at most `error`."""
    needed = (_quadrature_log(g, low) - math.log(error)) / (2.0 * _ETA)
    return max(1, math.ceil(float(needed.min())))


def _quadrature_log(g: NDArray[np.float64], low: float) -> NDArray[np.float64]:
    return np.asarray(math.log(32.0 / 15.0 * (1.0 - low)) + g - np.log(-np.expm1(-2.0 * _ETA)))


def series_error(g: NDArray[np.float64], terms: int, v: float) -> float:
    r"""Bound the tail ``sum_{n >= terms} |beta_n| |2 J_{2n+1}(v) / v|`` of the Legendre-Bessel series on [0, 1].

    The smaller of two bounds. By the ellipse: ``|beta_n| <= (2n+1) l M e^{-(n+1) eta} / (pi (1 - e^{-2 eta}))``
    with the perimeter ``l <= pi sqrt(2 cosh 2 eta)``, and ``|2 J_{2n+1}(v)/v| <= 1/sqrt(2n+1)``. By the window:
    ``|beta_n| <= sqrt(2n+1)`` (Parseval) and ``|2 J_{2n+1}(v)/v| <= (v/2)^{2n} / (2n+1)!``.
    """
    order = 2.0 * terms + 1.0
    decay = np.exp(-_ETA)
    sums = 1.0 / (1.0 - decay) + decay / (order * (1.0 - decay) ** 2)
    front = np.sqrt(2.0 * np.cosh(2.0 * _ETA)) * math.sqrt(order) * sums / -np.expm1(-2.0 * _ETA)
    ellipse = _exp_min(g + np.log(front) - (terms + 1.0) * _ETA)
    # Ratio of successive terms of the second bound; it falls with n, so the tail is geometric.
    ratio = (0.5 * v) ** 2 / ((order + 1.0) * (order + 2.0)) * math.sqrt((order + 2.0) / order)
    if ratio >= 0.5:
        return ellipse
    log_first = 0.5 * math.log(order) - math.lgamma(order + 1.0)
    if v > 0:
        log_first += 2.0 * terms * math.log(0.5 * v)
    elif terms > 0:
        return 0.0
    return min(ellipse, 2.0 * math.exp(min(log_first, 700.0)))


def series_terms(g: NDArray[np.float64], v: float, error: float) -> int:
    """Return the fewest terms for which :func:`series_error` is at most `error`."""
    few, many = 0, 8
    while series_error(g, many, v) > error:
        few, many = many, 2 * many
    while many - few > 1:
        middle = (few + many) // 2
        if series_error(g, middle, v) > error:
            few = middle
        else:
            many = middle
    return many


def coefficient_nodes(g: NDArray[np.float64], terms: int, error: float) -> int:
    """Return how many Gauss nodes give the first `terms` Legendre coefficients to `error` in U.

    On the ellipse ``|P_n| <= e^{n eta}``; the errors of the beta_n are summed with their transforms.
    """
    growths = math.log(math.sqrt(2.0 * terms + 1.0)) + terms * _ETA - np.log(np.expm1(_ETA))
    needed = (_quadrature_log(g, 0.0) + growths - math.log(error)) / (2.0 * _ETA)
    return max(terms, math.ceil(float(needed.min())))


def rounding_error(coefficients: NDArray[np.float64], low: float, terms: int) -> NDArray[np.float64]:
    """Estimate the rounding error of U (not a proof): phases of size Phi lose ``Phi 2^-53``, sums ``sqrt(n)``."""
    size = np.abs(coefficients).sum(axis=1)
    return np.asarray((2.0 * size + 4.0 * math.sqrt(terms) + 16.0) * UNIT_ROUNDOFF * (1.0 - low))


def _exp_min(logarithms: NDArray[np.float64]) -> float:
    return math.exp(min(float(logarithms.min()), 700.0))
