"""Gauss-Legendre rules correct to rounding."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core_tests import _core_tests
from lommel.special.legendre import gauss_legendre

# Made with wider numbers than double; where there are none, weights are as good for a sum, not one by one.
WIDER = _core_tests.window_bounds(1, 1.0)["spacing"] < 2.0**-52
OFF, RELATIVE = (2.0**-53, 4e-16) if WIDER else (2.0**-52, 1e-14)


def _exact_rule(n: int, guess: float) -> tuple[float, float]:
    """Return the node on [0, 1] next to `guess` and its weight, by Newton's method with 40 digits."""
    with mp.workdps(40):
        x = 2 * mp.mpf(guess) - 1
        for _ in range(3):
            before, value = mp.mpf(1), x
            for k in range(2, n + 1):
                before, value = value, ((2 * k - 1) * x * value - (k - 1) * before) / k
            slope = n * (x * value - before) / (x * x - 1)
            x -= value / slope
        return float((1 + x) / 2), float(1 / ((1 - x * x) * slope**2))


@pytest.mark.parametrize("n", [2, 3, 10, 33, 64, 257])
def test_nodes_and_weights_are_correct_to_rounding_even_at_the_ends(n: int) -> None:
    nodes, weights = gauss_legendre(n)
    for i in {0, 1, n // 3, n // 2, n - 2, n - 1}:
        node, weight = _exact_rule(n, float(nodes[i]))
        assert abs(nodes[i] - node) <= OFF
        assert weights[i] == pytest.approx(weight, rel=RELATIVE, abs=0)


@pytest.mark.parametrize("n", [1000, 4001])
def test_the_many_nodes_of_a_great_phase_are_as_good_for_a_sum_of_order_one(n: int) -> None:
    nodes, weights = gauss_legendre(n)
    for i in (0, 1, n // 3):
        node, weight = _exact_rule(n, float(nodes[i]))
        assert abs(nodes[i] - node) <= OFF
        assert abs(weights[i] - weight) <= (2.0**-60 if WIDER else 2.0**-57)


@given(st.integers(1, 40), st.lists(st.floats(-1, 1), min_size=1, max_size=80), st.floats(0, 0.9))
def test_polynomials_up_to_degree_2n_minus_1_are_integrated_exactly(
    n: int, coefficients: list[float], low: float
) -> None:
    nodes, weights = gauss_legendre(n, low)
    c = np.array(coefficients[: 2 * n])
    k = np.arange(c.size)
    exact = np.sum(c * (1 - low ** (k + 1.0)) / (k + 1))
    assert weights @ (nodes[:, None] ** k @ c) == pytest.approx(exact, rel=0, abs=1e-14 * c.size)
