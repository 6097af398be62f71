"""What the compiled bounds promise of the Legendre-Bessel series is compared with measured errors."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial.legendre import legval, legvander
from numpy.typing import NDArray
from scipy import special

from core_tests import _core_tests
from lommel._core import legendre_transforms
from lommel.special.legendre import gauss_legendre

# Rounding of the measurement itself: a few units for each of some hundred radians.
FLOOR = 1e-13

sizes = st.sampled_from([0.01, 1.0, 30.0, 400.0])
pupils = st.builds(
    lambda size, parts: size * np.array(parts), sizes, st.lists(st.floats(-1, 1), min_size=1, max_size=4)
)
powers = st.sampled_from([0, 0, 0, 1, 2, 4])
radii = st.one_of(st.just(0.0), st.floats(0.01, 20), st.floats(20, 700))


def _coefficients(coefficients: NDArray[np.float64], power: int, terms: int, nodes: int) -> NDArray[np.complex128]:
    t, weights = gauss_legendre(nodes)
    phase = legval(2 * t - 1, [0.0, *coefficients])
    return (2 * np.arange(terms) + 1) * ((weights * t**power * np.exp(1j * phase)) @ legvander(2 * t - 1, terms - 1))


@given(pupils, powers, radii, st.integers(3, 12))
def test_the_series_ends_as_promised_with_few_terms_to_spare(
    coefficients: NDArray[np.float64], power: int, v: float, digits: int
) -> None:
    error = 10.0**-digits
    made = _core_tests.series_bounds(coefficients, np.zeros(1), power, v, error)
    terms, promised = made["terms"], made["truncation"]
    many = terms + 60
    beta = _coefficients(coefficients, power, many, 2 * many + 200)
    transforms = np.abs(legendre_transforms(np.linspace(0.0, v, 41), many))
    tails = np.cumsum((transforms * np.abs(beta))[:, ::-1], axis=1)[:, ::-1].max(axis=0)
    assert tails[terms] <= promised + FLOOR
    assert promised <= error
    failing = np.flatnonzero(tails > error)
    smallest = int(failing[-1]) + 1 if failing.size else 1
    # The window and the phase end the series together where neither does so alone.
    assert terms <= 1.5 * smallest + 14


@given(pupils, powers, radii, st.integers(3, 12))
def test_the_coefficients_are_as_accurate_as_promised(
    coefficients: NDArray[np.float64], power: int, v: float, digits: int
) -> None:
    error = 10.0**-digits
    made = _core_tests.series_bounds(coefficients, np.zeros(1), power, v, error)
    terms, nodes, promised = made["terms"], made["nodes"], made["quadrature"]
    assert promised <= error
    ours = _coefficients(coefficients, power, terms, nodes)
    missed = np.abs(ours - _coefficients(coefficients, power, terms, 3 * nodes + 20))
    transforms = np.abs(legendre_transforms(np.linspace(0.0, v, 41), terms))
    assert (transforms @ missed).max() <= promised + FLOOR


@pytest.mark.parametrize("size", [1e-163, 1e-300, 5e-324])
def test_phases_whose_squares_vanish_are_no_phases(size: float) -> None:
    assert _core_tests.series_bounds(np.array([size, -size]), np.zeros(1), 0, 10.0, 1e-6)["nodes"] < 32


@given(st.floats(0.01, 700), st.integers(0, 400))
def test_no_transform_of_a_polynomial_exceeds_the_bounds_used(v: float, n: int) -> None:
    transforms = np.abs(legendre_transforms(np.array([v], float), n + 1))[0]
    orders = 2 * np.arange(n + 1) + 1.0
    assert np.all(transforms <= 1 / np.sqrt(orders) + 1e-15)
    # Kapteyn's inequality beyond the turning point.
    beyond = orders > v
    x = v / orders[beyond]
    root = np.sqrt(1 - x * x)
    kapteyn = np.exp(orders[beyond] * (root + np.log(x / (1 + root))))
    assert np.all(transforms[beyond] <= 2 / v * kapteyn * (1 + 1e-9) + 1e-300)


@pytest.mark.parametrize("v", [0.1, 3.0, 500.0])
def test_the_identity_behind_the_bounds_holds(v: float) -> None:
    # sum (2n+1) f_n(v)^2 = int_0^1 J0(v sqrt t)^2 dt = J0^2 + J1^2
    orders = 2 * np.arange(600) + 1
    total = (orders * legendre_transforms(np.array([v], float), 600)[0] ** 2).sum()
    assert total == pytest.approx(special.j0(v) ** 2 + special.j1(v) ** 2, rel=1e-12)
