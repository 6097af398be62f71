r"""How many quadrature nodes an accuracy takes: bounds on Bernstein ellipses.

In t = rho^2 the integrand ``exp(i Phi(t)) J0(v sqrt t)`` is entire. On the ellipse
``t = c + h cos(theta + i eta)`` around ``[c - h, c + h]`` it is at most ``exp g(eta)`` with
``g = max_theta (abs(Im Phi) + v abs(Im sqrt t))``, and Gauss quadrature converges like
``exp(-2 n eta)`` for every eta > 0; the best eta is taken.

References
----------
L. N. Trefethen, *Approximation Theory and Approximation Practice* (SIAM, 2013), Theorem 19.3.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from lommel.optics.apodization import Apodization

_ETA = np.geomspace(1e-3, 4.0, 96)
_STEPS = 128
_THETA = np.linspace(0.0, math.pi, _STEPS + 1)
_COSH, _SINH = np.cosh(_ETA)[:, None], np.sinh(_ETA)[:, None]

UNIT_ROUNDOFF = 2.0**-53
_EVEN = Apodization()


def growth(terms: NDArray[np.float64], low: float, v: float, light: Apodization = _EVEN) -> NDArray[np.float64]:
    """Bound ``log|A exp(i Phi) J0(v sqrt t)|`` on each ellipse around ``[low, 1]``, for a whole stack.

    `terms` are the coefficients of R_2^0, R_4^0, ..., that is of P_1(2t - 1), P_2, ..., shape ``(n, terms)``; the box
    around them bounds the stack. The maximum over theta is taken on a grid, times ``1 / cos(degree step / 2)``,
    which bounds a trigonometric polynomial between grid points (Ehlich and Zeller, 1964).
    """
    half = 0.5 * (1.0 - low)
    t = 0.5 * (1.0 + low) + half * (np.cos(_THETA) * _COSH - 1j * np.sin(_THETA) * _SINH)
    degree = terms.shape[1]
    middle = 0.5 * (terms.max(axis=0) + terms.min(axis=0))
    spread = 0.5 * (terms.max(axis=0) - terms.min(axis=0))
    # Im Phi is linear in the coefficients: its largest over a box is that in the middle and what the sides add.
    x = 2.0 * t - 1.0
    phase, sides, before, here = np.zeros(t.shape), np.zeros(t.shape), np.zeros_like(t), np.ones_like(t)
    for j, (c, s) in enumerate(zip(middle, spread, strict=True), 1):
        before, here = here, ((2 * j - 1) * x * here - (j - 1) * before) / j
        phase += c * here.imag
        sides += s * np.abs(here.imag)
    exponent = np.abs(phase) + sides
    exponent += v * np.abs(np.sqrt(t).imag)
    phase_and_kernel = np.asarray(exponent.max(axis=1) / math.cos(0.5 * degree * math.pi / _STEPS))
    return phase_and_kernel + light.growth(_COSH[:, 0], low)


def quadrature_error(g: NDArray[np.float64], n: int, low: float = 0.0) -> float:
    """Bound the error of n-point Gauss-Legendre quadrature over ``[low, 1]``, given :func:`growth`."""
    return _exp_min(_quadrature_log(g, low) - 2.0 * n * _ETA)


def quadrature_nodes(g: NDArray[np.float64], error: float, low: float = 0.0) -> int:
    """Return the fewest nodes for which :func:`quadrature_error` is at most `error`."""
    needed = (_quadrature_log(g, low) - math.log(error)) / (2.0 * _ETA)
    return max(1, math.ceil(float(needed.min())))


def _quadrature_log(g: NDArray[np.float64], low: float) -> NDArray[np.float64]:
    return np.asarray(math.log(32.0 / 15.0 * (1.0 - low)) + g - np.log(-np.expm1(-2.0 * _ETA)))


def rounding_error(terms: NDArray[np.float64], low: float, nodes: int) -> NDArray[np.float64]:
    """Estimate the rounding error of U (not a proof): phases of size Phi lose ``Phi 2^-53``, sums ``sqrt(n)``."""
    size = np.abs(terms).sum(axis=1)
    return np.asarray((2.0 * size + 4.0 * math.sqrt(nodes) + 16.0) * UNIT_ROUNDOFF * (1.0 - low))


def _exp_min(logarithms: NDArray[np.float64]) -> float:
    return math.exp(min(float(logarithms.min()), 700.0))
