"""Sums over a symmetric rule, folded: they are what all nodes make at all places."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.traced import chordal
from lommel.traced.namespaces import Namespace

STEP = 0.7
PLACES = {
    "odd": np.arange(-3, 4) * STEP,
    "even": np.arange(-3, 3) * STEP,
    "samples of pixels": (np.arange(-2, 2)[:, None] + [-0.3, 0.3]).ravel(),
    "off the middle": np.arange(-3, 4) - 0.3,
    "on one side": np.arange(2, 5) * STEP,
    "one": np.zeros(1),
}


@pytest.mark.parametrize("columns", PLACES.values(), ids=PLACES)
@pytest.mark.parametrize("rows", PLACES.values(), ids=PLACES)
def test_a_folded_sum_is_that_over_all_nodes(columns, rows):
    draw = np.random.default_rng(3)
    x, y, weights = draw.uniform(0, 1, 4), draw.uniform(0, 1, (4, 3)), draw.uniform(0, 1, (4, 3))
    phase = draw.uniform(0, 6, (len(chordal.IMAGES), 4, 3, 2))
    exact = 0.0
    for (right, below), one in zip(chordal.IMAGES, phase, strict=True):
        across = np.exp(-1j * right * np.multiply.outer(columns, x))
        down = np.exp(-1j * below * np.multiply.outer(rows, y))
        exact = exact + np.einsum("ck,rkl,kl,kln->ncr", across, down, weights, np.exp(1j * one))
    (over, kept), (along, held) = chordal.axis_of(columns), chordal.axis_of(rows)
    waves = [(np.cos(one).reshape(12, 2), np.sin(one).reshape(12, 2)) for one in phase]
    kernels = chordal.folded_tables(x, y, weights, kept, held)
    found = chordal.folded_intensity(Namespace.of(None), kernels, waves, (over, along))
    assert np.abs(found - np.abs(exact).reshape(2, -1) ** 2).max() < 1e-13 * np.abs(exact).max() ** 2


@pytest.mark.parametrize("name", ["odd", "even", "samples of pixels"])
def test_of_a_window_about_its_middle_half_the_places_are_kept(name):
    axis, kept = chordal.axis_of(PLACES[name])
    assert len(kept) <= len(PLACES[name]) // 2 + 1
    assert axis.negative > 0
