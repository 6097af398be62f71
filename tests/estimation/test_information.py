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
