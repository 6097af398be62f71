"""What the compiled bounds promise of the Legendre-Bessel series is compared with measured errors."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial.legendre import legval, legvander
from numpy.typing import NDArray

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
