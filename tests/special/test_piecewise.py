"""Piecewise quadratic phases (Eq. 17): bounds hold, fits reach what they can, bad input is named."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lommel.special.piecewise import SPLITS, fit_quadratics

RHO = np.linspace(0.0, 1.0, 4001)
amounts = st.floats(-200, 200)


def phase(coefficients) -> np.ndarray:
    return sum(c * RHO ** (2 * k + 2) for k, c in enumerate(coefficients))


@given(st.lists(amounts, min_size=1, max_size=4), st.integers(1, 60), st.sampled_from(SPLITS))
def test_the_error_of_interpolation_stays_below_its_bound(coefficients, segments, split):
    fit = fit_quadratics(coefficients, segments, split=split)
    error = np.abs(fit.phase(RHO) - phase(coefficients)).max()
    assert error <= fit.bound * (1 + 1e-9) + 1e-11 * (1 + sum(map(abs, coefficients)))


def test_the_optimal_split_needs_the_fewest_segments_and_makes_the_errors_equal():
    coefficients = (0.0, 100.0)
    bounds = {split: fit_quadratics(coefficients, 24, split=split).bound for split in SPLITS}
    assert bounds["optimal"] == min(bounds.values())
    fit = fit_quadratics(coefficients, 24)
    errors = np.abs(fit.phase(RHO) - phase(coefficients))
    largest = [errors[(low <= RHO) & (high >= RHO)].max() for low, high in itertools.pairwise(fit.edges)]
    assert max(largest) / min(largest) < 1.2


@pytest.mark.parametrize("spherical", [5.0, 8.0, 10.0])
def test_five_pieces_without_a_piston_reach_what_the_paper_reports(spherical):
    # The paper: 0.000137.
    pieces = fit_quadratics((0.0, spherical), 5, split="linear", fit="least-squares", piston=False)
    assert np.all(pieces.gamma == 0.0)
    assert pieces.mse((0.0, spherical)) <= 1.4e-4


def test_with_a_piston_five_pieces_do_ten_times_better():
    for fit, limit in (("interpolation", 1.5e-5), ("least-squares", 1.0e-5)):
        assert fit_quadratics((0.0, 10.0), 5, fit=fit).mse((0.0, 10.0)) <= limit


@pytest.mark.parametrize("coefficients", [(20.0, 10.0), (-20.0, 20.0)])
def test_least_squares_is_no_worse_than_where_it_starts_from(coefficients):
    for piston in (True, False):
        start = fit_quadratics(coefficients, 6, piston=piston).mse(coefficients)
        best = fit_quadratics(coefficients, 6, fit="least-squares", piston=piston).mse(coefficients)
        assert best <= start * (1 + 1e-9)


def test_the_mse_is_that_of_the_complex_exponentials():
    pieces = fit_quadratics((0.0, 10.0), 3)
    direct = np.mean(np.abs(np.exp(1j * pieces.phase(RHO)) - np.exp(1j * phase((0.0, 10.0)))) ** 2)
    assert pieces.mse((0.0, 10.0)) == pytest.approx(direct, rel=1e-2)
