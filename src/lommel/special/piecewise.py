"""Approximation of a phase by piecewise quadratic functions: Eq. (17) of the paper in docs/paper.md."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise, product

import numpy as np
import scipy
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array

SPLITS = ("linear", "sqrt", "log", "optimal")
FITS = ("interpolation", "least-squares")

_SAMPLES = 96  # samples of each segment for the mean error


@dataclass(frozen=True, eq=False)
class PiecewiseQuadratic:
    """``alpha_i rho^2 + beta_i rho + gamma_i`` on ``[edges_i, edges_{i+1})``.

    Attributes
    ----------
    edges : ndarray, shape (segments + 1,)
        From 0 to 1, rising.
    alpha, beta, gamma : ndarray, shape (segments,)
        Radians; gamma is 0 without piston.
    bound : float or None
        Proven bound on the error of the phase; None if the fit has no bound.
    """

    edges: Array
    alpha: Array
    beta: Array
    gamma: Array
    bound: float | None

    def phase(self, rho: ArrayLike) -> Array:
        """Return the phase at pupil radii `rho` (0 to 1)."""
        radii = np.asarray(rho, dtype=np.float64)
        i = np.clip(np.searchsorted(self.edges, radii, side="right") - 1, 0, self.alpha.size - 1)
        return np.asarray((self.alpha[i] * radii + self.beta[i]) * radii + self.gamma[i])

    def mse(self, coefficients: Sequence[float]) -> float:
        """Return the mean of ``abs(exp(i fit) - exp(i phase))^2`` over the radius, as the paper reports it.

        The phase has the `coefficients` of :func:`lommel.special.piecewise.fit_quadratics`.
        """
        # The paper averages over the radius, not the area.
        rho = (np.arange(20_000) + 0.5) / 20_000
        return float(np.mean(2.0 - 2.0 * np.cos(self.phase(rho) - _derivative(coefficients, rho, 0))))


def split_edges(segments: int, split: str = "optimal") -> Array:
    r"""Return the edges of segments of [0, 1].

    "linear": ``i/S``. "sqrt": ``sqrt(i/S)``. "log": ``log(1 + (e-1) i/S)``. "optimal":
    ``((i - 0.123) / (S - 0.123))^(3/4)`` for i > 0, which equalizes the errors of a quartic phase. Errors are
    proportional to ``rho h^3``, but to ``0.625 h^4`` in the first segment; hence the shift by 0.123.

    Parameters
    ----------
    segments : int
        Number S of segments, 1 to 4096.
    split : {"optimal", "linear", "sqrt", "log"}

    Returns
    -------
    ndarray, shape (segments + 1,)

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.
    """
    count = validation.integer("segments", segments, least=1, most=4096)
    validation.choice("split", split, SPLITS)
    x = np.linspace(0.0, 1.0, count + 1)
    shifted = np.maximum(count * x - 0.123, 0.0) / (count - 0.123)
    forms = {"linear": x, "sqrt": np.sqrt(x), "log": np.log1p((math.e - 1.0) * x), "optimal": shifted**0.75}
    edges = forms[split]
    edges[-1] = 1.0
    return edges


def fit_quadratics(
    coefficients: Sequence[float],
    segments: int = 5,
    *,
    split: str = "optimal",
    fit: str = "interpolation",
    piston: bool = True,
) -> PiecewiseQuadratic:
    r"""Approximate the phase ``c_1 rho^2 + c_2 rho^4 + ...`` by quadratics on segments (paper, Eq. 17).

    Parameters
    ----------
    coefficients : sequence of float
        c_1 = 2 C_d, c_2 = C_s, ... in radians.
    segments : int, default 5
        Number of segments, 1 to 4096.
    split : {"optimal", "linear", "sqrt", "log"}
        See :func:`split_edges`.
    fit : {"interpolation", "least-squares"}
        "interpolation": of the phase at three Chebyshev points of each segment; the error bound is about
        ``max abs(phi''') h^3 / 192``. Without piston: match of the value (up to whole turns) and the slope of the
        phase in the middle of each segment, without a bound. "least-squares": fit of ``exp(i phase)`` that starts
        from the result of "interpolation".
    piston : bool, default True
        True if each segment has a constant gamma_i, which Eq. (17) omits.

    Returns
    -------
    PiecewiseQuadratic

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.
    """
    c = validation.real_array("coefficients", coefficients)
    if c.ndim != 1 or c.size == 0:
        raise ValueError(f"coefficients must be a sequence of numbers, got {validation.shown(coefficients)}")
    validation.choice("fit", fit, FITS)
    validation.truth("piston", piston)
    edges, rows = fit_stack(c[None], segments, split, fit, piston)
    alpha, beta, gamma = rows[0].T
    bound = None
    if piston and fit == "interpolation":
        bound = float(_interpolation_error(np.abs(c), edges).max())
    return PiecewiseQuadratic(edges, alpha, beta, gamma, bound)


def fit_stack(c: Array, segments: int, split: str, fit: str, piston: bool) -> tuple[Array, Array]:
    """Return the edges, and alpha, beta and gamma of each phase of a stack in each segment, ``(n, segments, 3)``."""
    edges, coefficients = _interpolation_matrix(c.shape[-1], segments, split)
    rows = (c @ coefficients).reshape(len(c), segments, 3) if piston else _match_value_and_slope(c, edges)
    if fit == "least-squares":
        for k, (i, (low, high)) in product(range(len(c)), enumerate(pairwise(edges.tolist()))):
            rows[k, i] = _least_squares(c[k], low, high, rows[k, i], piston)
    return edges, rows


def _derivative(coefficients: ArrayLike, rho: ArrayLike, order: int) -> Array:
    """Return a derivative by rho of each phase of a stack, coefficients ``(..., terms)``, at all `rho`."""
    c, radii = np.asarray(coefficients, dtype=np.float64), np.asarray(rho, dtype=np.float64)
    powers = [2 * k for k in range(1, c.shape[-1] + 1)]
    # (d/drho)^k of rho^p has the factor p! / (p - k)!.
    factors = np.array([math.perm(p, order) for p in powers], dtype=np.float64)
    return np.asarray(np.tensordot(c * factors, np.stack([radii ** (p - order) for p in powers]), axes=1))


def _interpolation_error(c: Array, edges: Array) -> Array:
    """Bound the error on each segment: h^3 / 32 times the third divided difference of the phase."""
    low, high = edges[:-1], edges[1:]
    # Third divided differences of rho^p are at most C(p, 3) high^(p - 3); for rho^4 the exact value is used.
    difference = np.zeros(low.size)
    # c_1 rho^2 is quadratic, and has no error.
    for k, size in enumerate(c[1:], 2):
        difference += size * (1.5 * (low + high) + high if k == 2 else math.comb(2 * k, 3) * high ** (2 * k - 3))
    return np.asarray((high - low) ** 3 / 32.0 * difference)


@lru_cache(maxsize=8)
def _interpolation_matrix(terms: int, segments: int, split: str) -> tuple[Array, Array]:
    """Return the edges, and coefficients that interpolate each term at the Chebyshev points of each segment."""
    edges = split_edges(segments, split)
    # Interpolation at Chebyshev points of each segment has the smallest error bound.
    middle, half_width = 0.5 * (edges[:-1] + edges[1:]), 0.5 * np.diff(edges)
    x = middle + half_width * np.cos(np.pi * np.array([5, 3, 1]) / 6)[:, None]
    value = np.moveaxis(_derivative(np.eye(terms), x, 0), -2, 0)
    # Newton's divided differences.
    slope = [(value[k + 1] - value[k]) / (x[k + 1] - x[k]) for k in (0, 1)]
    alpha = (slope[1] - slope[0]) / (x[2] - x[0])
    beta = slope[0] - alpha * (x[0] + x[1])
    coefficients = np.stack([alpha, beta, value[0] - (alpha * x[0] + beta) * x[0]], axis=-1).reshape(terms, -1)
    edges.flags.writeable = coefficients.flags.writeable = False
    return edges, coefficients


def _match_value_and_slope(c: Array, edges: Array) -> Array:
    """Return alpha and beta with the value (modulo 2 pi) and slope of the phase in the middle of each segment."""
    middle = 0.5 * (edges[:-1] + edges[1:])
    value, slope, curvature = (_derivative(c, middle, k) for k in range(3))
    # The number of whole turns is the one for which the curvature is closest to the curvature of the phase.
    whole_turns = np.round((slope * middle - value - 0.5 * curvature * middle**2) / (2.0 * math.pi))
    alpha = (slope * middle - value - 2.0 * math.pi * whole_turns) / middle**2
    return np.stack([alpha, slope - 2.0 * alpha * middle, np.zeros_like(alpha)], axis=-1)


def _least_squares(c: Array, low: float, high: float, start: Array, piston: bool) -> Array:
    rho = low + (high - low) * (np.arange(_SAMPLES) + 0.5) / _SAMPLES
    phase = _derivative(c, rho, 0)
    # With powers of the distance from the middle of a segment, which are nearly orthogonal, the search converges.
    count, m = (3, 0.5 * (low + high)) if piston else (2, 0.0)
    powers = np.vander(rho - m, 3)[:, :count]

    def residual(p: Array) -> Array:
        # The squares sum to abs(exp(i fit) - exp(i phase))^2, which does not change with whole turns.
        error = powers @ p - phase
        return np.concatenate([np.cos(error) - 1.0, np.sin(error)])

    a, b, g = start
    initial = np.array([a, b + 2 * a * m, g + (a * m + b) * m])[:count]
    optimum = scipy.optimize.least_squares(residual, initial, x_scale="jac", xtol=1e-14, ftol=1e-14, gtol=1e-14).x
    a, b, g = np.append(optimum, np.zeros(3 - count))
    return np.array([a, b - 2 * a * m, g - (b - a * m) * m])
