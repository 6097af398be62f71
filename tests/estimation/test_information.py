"""What a square root of Fisher's matrix says: standard errors, and what cannot be known."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lommel.estimation.fisher import Information

DRAW = np.random.default_rng(1922)


def told(root, error=1e-9, units=None):
    """Information of parameters a, b, ..., whose columns are wrong by no more than some part of their length."""
    root = np.asarray(root, dtype=float)
    names = tuple("abcdefgh"[: root.shape[-1]])
    length = np.sqrt((root**2).sum(axis=-2))
    return Information.of_root(names, units or dict.fromkeys(names, ""), root, error * length)


def test_what_can_be_known_has_the_inverse_of_the_matrix_for_its_covariance():
    root = DRAW.normal(size=(5, 2, 9, 4)) * [1.0, 1e-9, 1e6, 3.0]
    found = told(root)
    matrix = np.swapaxes(root, -1, -2) @ root
    assert found.matrix == pytest.approx(matrix, rel=1e-12)
    unit = np.sqrt(np.diagonal(matrix, axis1=-2, axis2=-1))
    scale = unit[..., None] * unit[..., None, :]
    assert found.covariance * scale == pytest.approx(np.linalg.inv(matrix / scale), abs=1e-11)
    assert found.unidentifiable == ()
    errors = np.stack(list(found.errors.values()), axis=-1)
    assert errors == pytest.approx(np.sqrt(np.diagonal(found.covariance, axis1=-2, axis2=-1)), rel=1e-14)
    assert found.covariance == pytest.approx(found.correlation * errors[..., None] * errors[..., None, :], rel=1e-12)


def test_a_column_within_its_error_is_unknown_and_touches_nothing_else():
    root = DRAW.normal(size=(9, 4))
    without = told(np.delete(root, 1, axis=1))
    root[:, 1] *= 1e-12
    error = np.array([1e-12, 1.01 * np.linalg.norm(root[:, 1]), 1e-12, 1e-12])
    found = Information.of_root(tuple("abcd"), dict.fromkeys("abcd", ""), root, error)
    assert found.unidentifiable == ("b",)
    assert found.errors["b"] == math.inf
    assert np.delete(np.delete(found.covariance, 1, 0), 1, 1) == pytest.approx(without.covariance, rel=1e-9)
    assert found.correlation[1] == pytest.approx([0, 1, 0, 0])
    # Of one like no other it is its own error alone that decides.
    root = np.linalg.qr(root)[0] * [1.0, 1e-12, 1.0, 1.0]
    for error[1], unknown in ((1.01e-12, ("b",)), (0.99e-12, ())):
        found = Information.of_root(tuple("abcd"), dict.fromkeys("abcd", ""), root, error)
        assert found.unidentifiable == unknown
    assert found.errors["b"] == pytest.approx(1e12, rel=1e-9)


def test_two_of_which_the_sum_alone_is_known_are_unknown_and_correlate_at_minus_one():
    root = DRAW.normal(size=(9, 3))
    root[:, 2] = 5e4 * root[:, 0] * (1.0 + 1e-12 * DRAW.normal(size=9))
    found = told(root, 1e-11)
    assert found.unidentifiable == ("a", "c")
    assert found.correlation[0, 2] == pytest.approx(-1.0, abs=1e-9)
    assert found.covariance[0, 2] == -math.inf
    assert found.covariance[0, 0] == found.covariance[2, 2] == math.inf
    # What the sum leaves free of b.
    rest = told(root[:, :2])
    assert found.errors["b"] == pytest.approx(float(rest.errors["b"]), rel=1e-9)


def test_two_that_differ_by_more_than_their_errors_are_known():
    root = DRAW.normal(size=(9, 3))
    root[:, 2] = root[:, 0] + 1e-6 * DRAW.normal(size=9)
    assert told(root, 1e-5).unidentifiable == ("a", "c")
    found = told(root, 1e-8)
    assert found.unidentifiable == ()
    assert -1.0 <= found.correlation[0, 2] < -0.999999


def test_all_with_a_part_in_what_is_unknown_are_unknown_and_no_others():
    unit = np.linalg.qr(DRAW.normal(size=(9, 4)))[0]
    # Moving by (0.1, 0.7, -0.7) in the first three changes nothing; the fifth changes nothing by itself.
    third = (0.1 * unit[:, 0] + 0.7 * unit[:, 1]) / 0.7
    root = np.stack([unit[:, 0], unit[:, 1], third, unit[:, 2], 0.0 * third], axis=1)
    assert told(root).unidentifiable == ("a", "b", "c", "e")


def test_one_of_large_error_does_not_hide_what_is_unknown_without_it():
    unit = np.linalg.qr(DRAW.normal(size=(9, 2)))[0]
    root = np.stack([unit[:, 0], unit[:, 0], unit[:, 1]], axis=1)
    found = Information.of_root(tuple("abc"), dict.fromkeys("abc", ""), root, np.array([1e-6, 1e-6, 0.9]))
    assert found.unidentifiable == ("a", "b")


@given(st.integers(1, 6), st.integers(0, 3), st.integers(0, 2**32 - 1))
def test_no_unit_changes_what_is_known_and_deviations_have_it(known, more, seed):
    draw = np.random.default_rng(seed)
    # Of all, some are sums of others, exact but for rounding.
    count = known + more
    root = draw.normal(size=(count + 4, known)) @ draw.normal(size=(known, count))
    units = np.exp(draw.uniform(-40.0, 40.0, count))
    length = np.linalg.norm(root, axis=0)
    names = tuple("abcdefghi"[:count])
    plain, scaled = (
        Information.of_root(names, dict.fromkeys(names, ""), root * by, 1e-7 * length * by) for by in (1.0, units)
    )
    assert plain.unidentifiable == scaled.unidentifiable
    assert bool(plain.unidentifiable) == (more > 0)
    for name, unit in zip(names, units, strict=True):
        assert scaled.errors[name] * unit == pytest.approx(plain.errors[name], rel=1e-4)
    assert not np.isnan(scaled.covariance).any()
    assert scaled.correlation == pytest.approx(scaled.correlation.T, abs=1e-12)
    assert (np.linalg.eigvalsh(plain.matrix) >= -1e-12 * np.trace(plain.matrix)).all()


def test_it_can_be_read():
    root = np.zeros((2, 4, 3))
    root[:, 0, 0], root[1, 1, 1], root[:, 2, 2] = 1e4, 3.0, [4.0, 2.0]
    units = {"depth": "m", "defocus": "rad", "f_number": ""}
    one = Information.of_root(tuple(units), units, root[0], np.full(3, 1e-6))
    assert repr(one) == ("<Information\n  depth    +- 100 um\n  defocus  unidentifiable\n  f_number +- 0.25>")
    both = Information.of_root(tuple(units), units, root, np.full((2, 3), 1e-6))
    assert repr(both) == (
        "<Information of a stack of (2,)\n  depth    +- 100 um\n"
        "  defocus  +- 0.333 rad, unidentifiable in 1 of 2\n  f_number +- 0.25 to 0.5>"
    )
