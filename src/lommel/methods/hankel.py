r"""Hankel transform by direct quadrature (the reference for all other methods), and its number of nodes.

In t = rho^2 the integrand ``exp(i Phi(t)) J0(v sqrt t)`` is entire. On the ellipse
``t = c + h cos(theta + i eta)`` around ``[c - h, c + h]`` its modulus is at most ``exp(g(eta))`` with
``g = max_theta (abs(Im Phi) + v abs(Im sqrt t))``. The error of n Gauss nodes has a bound proportional to
``exp(g(eta) - 2 n eta)`` for every eta > 0; the smallest bound is used. Certificate, "Differentiable PSFs".

References
----------
L. N. Trefethen, *Approximation Theory and Approximation Practice* (SIAM, 2013), Theorem 19.3.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core import engine
from lommel.core.answers import Declined, FieldValues
from lommel.methods.method import FieldMethod
from lommel.optics.aperture.apodization import Apodization
from lommel.optics.pupil import Pupil
from lommel.special.legendre import gauss_legendre

# Every eta > 0 gives a bound; the smallest bound for these values of eta is used.
_ETA = np.geomspace(1e-3, 4.0, 96)
_STEPS = 128  # intervals of theta on half an ellipse

UNIT_ROUNDOFF = 2.0**-53
_UNIFORM = Apodization()


def growth(terms: Array, low: float, v: float, illumination: Apodization = _UNIFORM) -> Array:
    """Bound ``log(abs(A exp(i Phi) J0(v sqrt t)))`` on each ellipse around ``[low, 1]``, for a whole stack.

    `terms` are the coefficients of R_2^0, R_4^0, ... (P_1(2t - 1), P_2, ...), shape ``(n, terms)``; the bound holds
    in the whole bounding box of the stack. The maximum over theta is computed on a grid. For `low` = 0, the sum is a
    trigonometric polynomial of theta / 2, at most ``1 / cos(degree step / 2)`` times its largest grid value (Ehlich
    and Zeller, 1964). Otherwise each interval between grid points is bounded separately: see :func:`rise`.
    """
    degree = terms.shape[1]
    # Bounding box of the stack in the space of coefficients.
    middle = 0.5 * (terms.max(axis=0) + terms.min(axis=0))
    half_width = 0.5 * (terms.max(axis=0) - terms.min(axis=0))
    t = ellipses(_ETA, low, _STEPS)
    # Im Phi is linear in the coefficients: its maximum over the box is the value at the centre plus a sum over sides.
    x = 2.0 * t - 1.0
    phase, sides, previous, current = np.zeros(t.shape), np.zeros(t.shape), np.zeros_like(t), np.ones_like(t)
    for j, (c, s) in enumerate(zip(middle, half_width, strict=True), 1):
        previous, current = current, ((2 * j - 1) * x * current - (j - 1) * previous) / j
        phase += c * current.imag
        sides += s * np.abs(current.imag)
    largest = between(np.abs(phase) + sides, v * rise(_ETA, low, _STEPS), degree, low)
    return np.asarray(largest + illumination.growth(np.cosh(_ETA), low))


def ellipses(eta: Array, low: float, steps: int) -> NDArray[np.complex128]:
    """Return points on half of each ellipse around ``[low, 1]``, shape ``(ellipses, steps + 1)``."""
    # The other half has conjugate points, at which the moduli are equal.
    theta = np.linspace(0.0, math.pi, steps + 1)
    half_length = 0.5 * (1.0 - low)
    ellipse = np.cos(theta) * np.cosh(eta)[:, None] - 1j * np.sin(theta) * np.sinh(eta)[:, None]
    return np.asarray(0.5 * (1.0 + low) + half_length * ellipse)


def rise(eta: Array, low: float, steps: int) -> Array:
    r"""Return abs(Im sqrt t) at the points of :func:`ellipses` for `low` = 0, else its maximum on each interval."""
    # With ``x = cos(theta)`` and ``z = h x + c cosh(eta)``, c and h the middle and half of ``[low, 1]``, abs(t) is
    # ``sqrt(z^2 - low sinh(eta)^2)``, so that ``(Im sqrt t)^2 = (abs(t) - Re t) / 2`` is a concave function of x. In
    # an interval it is therefore at most the larger value at the two ends, except in the interval around its only
    # maximum, at ``x = -cosh(eta) (1 - sqrt(low)) / (1 + sqrt(low))``.
    values = np.asarray(np.abs(np.sqrt(ellipses(eta, low, steps)).imag))
    if low == 0.0:
        return values
    cosh, root, step = np.cosh(eta), math.sqrt(low), math.pi / steps
    top = np.arccos(np.maximum(-1.0, -cosh * (1.0 - root) / (1.0 + root)))
    half_length = 0.5 * (1.0 - low)
    t = 0.5 * (1.0 + low) + half_length * (np.cos(top) * cosh - 1j * np.sin(top) * np.sinh(eta))
    between_two = np.maximum(values[:, :-1], values[:, 1:])
    is_maximum = np.abs((np.arange(steps) + 0.5) * step - top[:, None]) <= step * (0.5 + 1e-9)
    return np.asarray(np.where(is_maximum, np.abs(np.sqrt(t).imag)[:, None], between_two))


def between(phase: Array, kernel: Array, degree: int, low: float) -> Array:
    """Bound the maximum over theta of the sum of a phase at grid points and a kernel as returned by :func:`rise`."""
    # If the kernel is bounded on intervals (low > 0): between two points a trigonometric polynomial exceeds linear
    # interpolation by at most ``(degree step)^2 / 8`` times its maximum, since its second derivative is at most
    # ``degree^2`` times its maximum (Bernstein).
    steps = phase.shape[1] - 1
    # Ehlich and Zeller: maximum of a trigonometric polynomial from its values at sufficiently many equal steps.
    widening = 1.0 / math.cos(0.5 * degree * math.pi / steps)
    if low == 0.0:
        return np.asarray((phase + kernel).max(axis=1) * widening)
    curved = (degree * math.pi / steps) ** 2 / 8.0 * widening
    return np.asarray((np.maximum(phase[:, :-1], phase[:, 1:]) + kernel).max(axis=1) + curved * phase.max(axis=1))


def quadrature_error(g: Array, n: int, low: float) -> float:
    """Bound the error of n-point Gauss-Legendre quadrature over ``[low, 1]``, from the :func:`growth` `g`."""
    # The limit of 700 prevents overflow; a bound this large has no use.
    return math.exp(min(float((_quadrature_log(g, low) - 2.0 * n * _ETA).min()), 700.0))


def quadrature_nodes(g: Array, error: float, low: float) -> int:
    """Return the smallest number of nodes for which :func:`quadrature_error` is at most `error`."""
    # The bound is solved for n at each eta.
    counts = (_quadrature_log(g, low) - math.log(error)) / (2.0 * _ETA)
    return max(1, math.ceil(float(counts.min())))


def _quadrature_log(g: Array, low: float) -> Array:
    # The factor is 64/15 (Theorem 19.3) times half the length of the interval.
    return np.asarray(math.log(32.0 / 15.0 * (1.0 - low)) + g - np.log(-np.expm1(-2.0 * _ETA)))


def rounding_error(terms: Array, low: float, nodes: int) -> Array:
    """Estimate (not bound) the rounding error of U: ``Phi 2^-53`` from phases Phi, ``sqrt(n) 2^-53`` from sums."""
    size = np.abs(terms).sum(axis=1)
    return np.asarray((2.0 * size + 4.0 * math.sqrt(nodes) + 16.0) * UNIT_ROUNDOFF * (1.0 - low))


_BLOCK = 2**21  # values of J0 in memory at a time: 16 MiB
_MAX_NODES = 16_000


@dataclass(frozen=True)
class Hankel(FieldMethod[Pupil]):
    r"""Gauss-Legendre quadrature of ``U(v) = int exp(i Phi) J0(v sqrt t) dt`` in t = rho^2, at every radius.

    Supports radially symmetric pupils. Each distinct radius is integrated separately, without interpolation.

    Parameters
    ----------
    tol : float, default 1e-14
        The number of nodes is the smallest whose proven quadrature error in U (relative to U(0) = 1 of the
        unaberrated aperture) is below `tol`, 1e-15 to 1e-2. Rounding errors add about ``2^-53`` times the phase.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    In t a quartic phase is exactly quadratic and ``J0(v sqrt t)`` is entire, so convergence is geometric once n
    exceeds about half the bandwidth ``max(sqrt(t (1-t)) abs(Phi'(t)) + v sqrt(1-t) / 2)``. The bound is
    Theorem 19.3 of Trefethen, *Approximation Theory and Approximation Practice* (2013).
    """

    apodized = True
    keeps_tol = False
    least_tol = 1e-15
    most_tol = 1e-2
    tol: float = 1e-14

    def evaluate(self, pupil: Pupil, v: Array) -> FieldValues:
        """Return U at rising v, with the sum of the quadrature error bound and an estimate of the rounding error."""
        low = pupil.obscuration**2
        terms = pupil.radial_terms()
        largest_v = float(v[-1]) if v.size else 0.0
        g = growth(terms, low, largest_v, pupil.illumination)
        # Errors are relative to U(0) = 1 - eps^2 of the unaberrated annulus.
        n = quadrature_nodes(g, self.tol * (1.0 - low), low)
        if n > _MAX_NODES:
            raise Declined(
                f"phases of {np.abs(terms).max():.3g} rad and v up to {largest_v:.3g} need {n:.3g} quadrature nodes, "
                f"more than the limit of {_MAX_NODES}; leave method out"
            )
        t, weights = gauss_legendre(n, low, 1.0)
        integrand = weights * pupil.illumination.at(t) * np.exp(1j * pupil.radial_phase(t))
        # One thread: if channels are computed in parallel, OpenBLAS threads would busy-wait for one another.
        parts = [np.ascontiguousarray(part) for part in (integrand.real, integrand.imag)]
        values = np.empty((len(terms), v.size), dtype=np.complex128)
        root = np.sqrt(t)[:, None]
        rows = max(1, _BLOCK // n)
        for start in range(0, v.size, rows):
            block = slice(start, start + rows)
            kernel = scipy.special.j0(root * v[block])
            values[:, block].real, values[:, block].imag = (engine.product(part, kernel, 1) for part in parts)
        error = quadrature_error(g, n, low) + rounding_error(terms, low, n)
        return FieldValues(values, error)
