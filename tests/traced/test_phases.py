"""Phases in turns: what is rounded of them is less than what is said, also where they are large."""

from __future__ import annotations

import math

import numpy as np
import pytest

from lommel.traced import phases
from lommel.traced.namespaces import Namespace


@pytest.mark.parametrize("pupils_last", [False, True])
@pytest.mark.parametrize("precision", ["float32", "float64"])
@pytest.mark.parametrize("largest", [1.0, 40.0, 900.0])
def test_turns_are_off_by_no_more_than_is_said(largest, precision, pupils_last):
    draw = np.random.default_rng(int(largest))
    basis = draw.uniform(-1.0, 1.0, (6, 500))
    rule, tables = phases.make(basis, 16, largest, precision, pupils_last=pupils_last)
    c = draw.normal(size=(60, 6))
    c *= (largest / (np.abs(c) @ np.abs(basis).max(axis=1)))[:, None]
    size = np.abs(c) @ np.abs(basis).max(axis=1)
    made = {name: np.asarray(table, dtype=precision) for name, table in tables.items()}
    first, *rest = phases.turns(Namespace.of(None), rule, made, c)
    total = (first - np.round(first)) + rest[0] if rest else first
    assert total.dtype == precision
    off = (total.T if pupils_last else total) - (c @ basis) / math.tau
    off = math.tau * np.abs(off - np.round(off)).max(axis=1)
    said = rule.each * size + rule.fixed
    assert np.all(off <= said)
    # Of 900 rad that float32 rounds as a whole, 5e-5 would be lost.
    assert np.all(said <= (1e-11 if precision == "float64" else 2e-6))
