"""Least squares of the core: against NumPy's, of full rank and of less."""

from __future__ import annotations

import numpy as np
import pytest

from lommel import _core
from lommel.core.engine import least_squares


@pytest.mark.parametrize("level", ["portable", "avx2"])
@pytest.mark.parametrize(("rows", "unknowns", "sides"), [(1, 1, 1), (7, 7, 3), (40, 9, 2), (131, 60, 33)])
def test_solutions_are_those_of_a_library(rows, unknowns, sides, level):
    rng = np.random.default_rng(rows)
    matrix, wanted = rng.normal(size=(rows, unknowns)), rng.normal(size=(rows, sides))
    try:
        _core.limit_instructions(level)
        found = least_squares(matrix, wanted)
    finally:
        _core.limit_instructions("avx512")
    np.testing.assert_allclose(found, np.linalg.lstsq(matrix, wanted, rcond=None)[0], atol=1e-10 * rows)


def test_directions_that_the_matrix_lacks_do_not_make_solutions_large():
    rng = np.random.default_rng(2)
    factors = rng.normal(size=(60, 10)) @ rng.normal(size=(10, 30))  # of rank 10
    wanted = factors @ rng.normal(size=(30, 4))
    found = least_squares(factors, wanted)
    least = np.linalg.lstsq(factors, wanted, rcond=1e-10)[0]
    assert np.abs(factors @ found - wanted).max() <= 1e-11 * np.abs(wanted).max()
    assert np.abs(found).max() <= 1.01 * np.abs(least).max()


def test_columns_of_zeros_have_no_share():
    matrix = np.array([[1.0, 0.0], [2.0, 0.0], [2.0, 0.0]])
    np.testing.assert_allclose(least_squares(matrix, np.array([[3.0], [6.0], [6.0]])), [[3.0], [0.0]], atol=1e-14)
    np.testing.assert_array_equal(least_squares(np.zeros((3, 2)), np.ones((3, 1))), 0.0)


def test_matrices_of_other_heights_are_refused():
    with pytest.raises(ValueError, match="as many rows"):
        least_squares(np.ones((3, 2)), np.ones((4, 1)))


@pytest.mark.parametrize("half", [20, 26])
def test_columns_that_nearly_depend_on_others_leave_as_little_as_they_can(half):
    # Cosines along a band of which samples are close together, as of filters of averages.
    frequencies = 2.0 * np.cos(np.pi * (np.arange(200) + 0.5) / 400)
    matrix = np.cos(np.outer(frequencies, np.pi / 4 * np.arange(half + 1)))
    wanted = np.sinc(frequencies / 4)[:, None]
    found = least_squares(matrix, wanted)
    assert np.abs(matrix @ found - wanted).max() <= 1e-14
    assert np.abs(found).sum() < 3.0
