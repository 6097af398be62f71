"""Rows that stand for others: against lists of which stand for which."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.imaging.linear import folded, gathered


@pytest.mark.parametrize(("beyond", "count"), [(0, 3), (2, 5), (5, 5), (7, 5), (13, 4), (6, 1)])
def test_mirrors_fold_what_leaves_as_they_unfold_what_is_seen(beyond, count):
    """The transpose of an image with its mirrored copies around it."""
    room = np.random.default_rng(beyond).integers(0, 99, (count + 2 * beyond, 3)).astype(np.float64)
    seen = np.pad(np.eye(count), ((0, 0), (beyond, beyond)), mode="symmetric")
    wanted = seen @ room
    assert np.array_equal(folded(room, beyond, count), wanted)


@pytest.mark.parametrize("places", [[0, 0, 0, 1, 2, 2], [1, 0, 2, 2, 2, 1, 0], [0, 1, 2]])
def test_copies_give_what_they_took_to_what_they_are_copies_of(places):
    taken = np.random.default_rng(0).integers(0, 99, (len(places), 4)).astype(np.float64)
    wanted = np.eye(3)[:, places] @ taken
    assert np.array_equal(gathered(taken, np.array(places), 3), wanted)
