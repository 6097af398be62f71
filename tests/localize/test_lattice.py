"""Indices of points of a square grid that a lens has bent."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm


def bent(angle, missing=(), stray=0):
    """Return indices and places of a grid of 9 x 12 points through a lens, in random order."""
    draw = np.random.default_rng(3)
    true = np.stack(np.meshgrid(np.arange(9), np.arange(12), indexing="ij"), axis=-1).reshape(-1, 2).astype(float)
    true = np.delete(true, list(missing), axis=0)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    at = 40.0 * (true - [4.0, 5.5]) @ turn.T
    at *= 1.0 - 1.5e-6 * (at**2).sum(axis=1, keepdims=True)
    at += draw.normal(size=at.shape)
    extra = 200.0 * np.ones((stray, 2)) + [57.0, 61.0]
    order = draw.permutation(len(true) + stray)
    return np.concatenate([true, np.full((stray, 2), np.nan)])[order], np.concatenate([at, extra])[order] + 500.0


@pytest.mark.parametrize("angle", [0.0, -0.3, 0.7])
def test_points_have_their_row_and_column_from_the_first_on(angle):
    true, at = bent(angle, missing=(40, 41, 55))
    np.testing.assert_array_equal(lm.grid_indices(at), true)


def test_points_beside_the_grid_have_none():
    true, at = bent(0.1, stray=1)
    found = lm.grid_indices(at)
    assert np.isnan(true).any()
    np.testing.assert_array_equal(found, true)


@pytest.mark.parametrize(
    ("places", "message"),
    [
        (np.zeros((3, 2)), "at least 4 points"),
        (np.column_stack([np.zeros(8), np.arange(8.0)]), "places must be of a square grid"),
    ],
)
def test_what_is_no_grid_is_told(places, message):
    with pytest.raises(ValueError, match=message):
        lm.grid_indices(places)
