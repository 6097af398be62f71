"""Minima of costs between candidates, and what chance makes of them."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.imaging.defocus_depth import _minimum, _spread


@pytest.mark.parametrize("where", [6.0, 6.3, 6.5, 1.2, 10.9])
def test_the_minimum_of_a_smooth_cost_is_found_between_candidates(where):
    c = np.arange(13.0)
    cost = np.cosh(0.4 * (c - where)) + 0.02 * (c - where) ** 3
    position, curvature, least = _minimum(cost[:, None, None], cost.argmin()[None, None])
    assert position[0, 0] == pytest.approx(where, abs=1e-3)
    assert curvature[0, 0] == pytest.approx(0.16, rel=2e-2)
    assert least[0, 0] == pytest.approx(1.0, abs=1e-4)


def test_each_pixel_has_its_own_minimum():
    c = np.arange(13.0)[:, None, None]
    where = np.random.default_rng(0).uniform(3.0, 9.0, (4, 5))
    cost = (c - where) ** 2
    position, curvature, least = _minimum(cost, cost.argmin(axis=0))
    assert position == pytest.approx(where, abs=1e-9)
    assert curvature == pytest.approx(2.0)
    assert least == pytest.approx(0.0, abs=1e-9)


def test_the_spread_over_candidates_is_that_of_their_likelihood():
    c = np.arange(41.0)[:, None, None]
    cost = ((c - 20.0) ** 2 / (2.0 * 3.0**2)).astype(np.float32) / 200.0
    at = np.array([[20]])
    x = c - 20.0
    beyond, chance = np.maximum(np.abs(x) - 1.0, 0.0), np.exp(-(x**2) / 18.0)
    assert _spread(cost, at, np.array([[200.0]])) == pytest.approx(float((beyond**2 * chance).sum() / chance.sum()))
    # Two next to each other are one minimum between them; one as good far away makes half of the square.
    two = np.full((41, 1, 1), 1.0, dtype=np.float32)
    two[[5, 6]] = 0.0
    assert _spread(two, np.array([[5]]), np.array([[200.0]])) == pytest.approx(0.0, abs=1e-9)
    two = np.full((41, 1, 1), 1.0, dtype=np.float32)
    two[[5, 35]] = 0.0
    assert _spread(two, np.array([[5]]), np.array([[200.0]])) == pytest.approx(420.5)
