"""Bessel functions against mpmath and their identities, and the forms of J0 that the paper joins."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import special

from lommel._core import legendre_transforms
from lommel.special.bessel import bessel_sequence, j0_asymptotic, j0_series, tangent_line


@pytest.mark.parametrize("count", [1, 2, 7, 60])
@pytest.mark.parametrize("v", [0.0, 1e-300, 1e-9, 9.99e-4, 1e-3, 0.5, 1.0, 10.0, 50.5, 200.0, 800.0, 1e4, 1e5])
def test_the_sequence_agrees_with_mpmath(v: float, count: int) -> None:
    values = bessel_sequence([v], count)
    assert values.shape == (1, count)
    exact = [float(mp.besselj(n, mp.mpf(v))) for n in range(count)]
    assert np.abs(values[0] - exact).max() <= 4 * 2.0**-53


@pytest.mark.parametrize("v", [1e-3, 1.0, 30.0])
def test_orders_far_beyond_the_argument_vanish_without_harm(v: float) -> None:
    j = bessel_sequence([v], 3000)[0]
    assert np.all(np.isfinite(j))
    assert np.all(j[1000:] == 0)


@pytest.mark.parametrize("v", [0.0, 1e-9, 0.3, 4.0, 31.0, 250.0])
def test_a_transform_is_the_integral_of_its_legendre_polynomial(v: float) -> None:
    """``int_0^1 P_n(2 t - 1) J0(v sqrt t) dt``, by quadrature."""
    x, w = np.polynomial.legendre.leggauss(20)
    rho = ((np.arange(60)[:, None] + 0.5 * (1 + x)) / 60).ravel()
    kernel = np.tile(w / 60, 60) * rho * special.j0(v * rho)
    exact = [np.sum(kernel * special.eval_legendre(n, 2 * rho**2 - 1)) for n in range(100)]
    assert np.abs(legendre_transforms(np.array([v], float), 100)[0] - exact).max() <= 1e-14


@pytest.mark.parametrize("v", [0.0, 5e-324, 1e-310, 1e-300, 1e-20, 1e-8])
def test_on_the_axis_only_the_mean_of_a_polynomial_counts(v: float) -> None:
    transforms = legendre_transforms(np.array([v], float), 5)[0]
    assert transforms[0] == pytest.approx(1.0, rel=1e-15)
    assert np.abs(transforms[1:]).max() <= 1e-16


@given(st.floats(0, 2), st.integers(1, 12))
def test_the_power_series_is_wrong_by_less_than_its_next_term(a: float, terms: int) -> None:
    left_out = (a * a / 4) ** terms / math.factorial(terms) ** 2
    assert abs(float(j0_series(a, terms)) - special.j0(a)) <= left_out + 1e-15


@given(st.floats(0.5, 1e4))
def test_the_asymptotic_form_is_wrong_by_less_than_its_next_term(a: float) -> None:
    """DLMF 10.17(iii): the remainder is bounded by the first terms left out, one of sine and one of cosine."""
    left_out = math.sqrt(2 / (math.pi * a)) * (1 / (8 * a) + 9 / (128 * a * a))
    assert abs(float(j0_asymptotic(a)) - special.j0(a)) <= left_out + 1e-15 * math.sqrt(a)


@given(st.floats(1, 1000), st.floats(0.01, 1e4))
def test_the_line_touches_the_inverse_square_root_at_its_centre_and_nowhere_exceeds_it(
    center: float, a: float
) -> None:
    slope, offset = tangent_line(center)
    assert slope * center + offset == pytest.approx(center**-0.5, rel=1e-14)
    assert slope == pytest.approx(-0.5 * center**-1.5, rel=1e-14)
    assert slope * a + offset <= a**-0.5 * (1 + 1e-13)
