"""Moments of a linear chirp against quadrature of their integrands."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from numpy.typing import NDArray

from lommel import _core
from lommel.paper import AbramowitzErf, FresnelErf, TableErf
from lommel.special.erf import Erf

ArrayLike = float | NDArray[np.float64]
NODES, WEIGHTS = np.polynomial.legendre.leggauss(20)


def chirp_moments(
    a: float,
    b: ArrayLike,
    low: ArrayLike,
    high: ArrayLike,
    erf: Erf = FresnelErf(),  # noqa: B008
) -> NDArray[np.complex128]:
    """Return ``int_low^high R^m exp(i (a R^2 + b R)) dR`` for m = 0, 1, 2."""
    parts = np.broadcast_arrays(*(np.asarray(x, dtype=np.float64) for x in (b, low, high)))
    flat = (np.ascontiguousarray(x).ravel() for x in parts)
    return _core.chirp_moments(a, *flat, *erf.compiled).reshape(3, *parts[0].shape)


def _by_panels(a: float, b: float, low: float, high: float) -> NDArray[np.complex128]:
    """Return the moments by a composite rule: 20 points for every two radians of phase."""
    rate = 2 * abs(a) * max(abs(low), abs(high)) + abs(b)
    edges = np.linspace(low, high, 3 + int(rate * (high - low) / 2))
    half = 0.5 * np.diff(edges)[:, None]
    r = edges[:-1, None] + half * (1 + NODES)
    wave = half * WEIGHTS * np.exp(1j * r * (a * r + b))
    return np.array([np.sum(wave), np.sum(wave * r), np.sum(wave * r * r)])


@pytest.mark.parametrize(
    ("a", "b", "low", "high"),
    [
        (0.0, 0.0, 0.0, 1.0),
        (0.0, 7.0, 0.25, 1.0),
        (1e-9, -30.0, 0.0, 1.0),
        (2.0, 0.0, 0.0, 1.0),
        (20.0, -20.0, 0.05, 1.0),
        (20.0, 30.0, 0.05, 1.0),
        (-20.0, 20.0, 0.0, 0.7),
        (-5.0, -9.0, 0.1, 2.0),
        (100.0, -100.0, -1.0, 1.5),
    ],
)
def test_the_moments_are_the_integrals(a: float, b: float, low: float, high: float) -> None:
    panels = mp.linspace(low, high, 3 + int((2 * abs(a) + abs(b)) * (high - low) / 10))
    for m, value in enumerate(chirp_moments(a, b, low, high)):
        exact = mp.quad(lambda r, m=m: r**m * mp.expj(r * (a * r + b)), panels)
        assert abs(complex(value) - complex(exact)) <= 1e-14 * max(1.0, high - low)


curvatures = st.one_of(st.floats(-400, 400), st.floats(-1, 1), st.floats(-1e-6, 1e-6))
slopes = st.one_of(st.floats(-800, 800), st.floats(-1, 1))


@given(curvatures, slopes, st.floats(0, 1), st.floats(0, 1))
@example(0.3125, 77.0, 0.0, 1.0)
def test_the_moments_are_the_integrals_for_any_curvature_slope_and_limits(
    a: float, b: float, one: float, other: float
) -> None:
    low, high = min(one, other), max(one, other)
    errors = np.abs(chirp_moments(a, b, low, high) - _by_panels(a, b, low, high))
    assert errors[:2].max() <= 2e-14
    # By parts, M_2 is the difference of terms of the size b / (2 a)^2, at a no less than 0.1.
    assert errors[2] <= 2e-14 + 1.2e-14 * (1 + abs(b)) / max(2 * abs(a), 0.2) ** 2


@pytest.mark.parametrize("b", [0.0, 30.0, -200.0, 800.0])
@pytest.mark.parametrize("a", [1e-9, 1e-5, 1e-3, 0.03, 0.0999])
def test_where_the_phase_is_nearly_linear_nothing_cancels(a: float, b: float) -> None:
    for low in (0.0, 0.01, 0.3):
        assert np.abs(chirp_moments(a, b, low, 1.0) - _by_panels(a, b, low, 1.0)).max() <= 1e-14


@pytest.mark.parametrize("place", [-3.0, 0.0, 0.1, 0.35, 0.6, 1.0, 1.1, 40.0])
@pytest.mark.parametrize("a", [-200.0, -3.0, 0.11, 3.0, 200.0, 1e4])
def test_the_stationary_point_may_lie_before_in_or_beyond_the_interval(a: float, place: float) -> None:
    b = -2 * a * place
    moments = chirp_moments(a, b, 0.1, 0.6)
    assert np.abs(moments - _by_panels(a, b, 0.1, 0.6)).max() <= 1e-13 * max(1.0, place**2)
    if a >= 3 and place == 0.35:
        # Inside, it contributes sqrt(pi / a): the method of stationary phase.
        wave = math.sqrt(math.pi / a) * np.exp(1j * (math.pi / 4 - b * b / (4 * a)))
        assert abs(moments[0] - wave) <= 2 / (a * 0.25)


def test_the_error_function_that_is_given_is_the_one_that_is_used() -> None:
    b = np.linspace(-60.0, 60.0, 121)
    exact = chirp_moments(20.0, b, 0.0, 1.0, erf=FresnelErf())
    assert np.array_equal(exact, chirp_moments(20.0, b, 0.0, 1.0))
    for form in (TableErf(64), AbramowitzErf(10)):
        assert 1e-9 < np.abs(chirp_moments(20.0, b, 0.0, 1.0, erf=form) - exact).max() < 0.1
