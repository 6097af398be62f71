"""Where windows end: enough is held, in between too, by rings that count in part."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from lommel.imaging.sensor_light import cut, find_cuts, ring_shares, shares_used, sums_of_quarters
from lommel.methods.pixels.rule import octant, sums_of_windows


def octants(seed: int, count: int = 9, half: int = 8) -> np.ndarray:
    """Windows of noise that falls outwards at a rate of its own each, of the sum 1."""
    rng = np.random.default_rng(seed)
    column, row = octant(half)
    falls = rng.uniform(0.2, 1.5, (count, 1))
    values = rng.uniform(0.5, 1.5, (count, column.size)) * np.exp(-falls * np.hypot(column, row))
    return values / sums_of_windows(values, half)[:, -1:]


@given(st.integers(0, 2**32 - 1), st.floats(0.5, 0.999))
def test_every_window_holds_what_was_asked_for(seed, energy):
    values = octants(seed)
    cuts = find_cuts(values, 8, energy)
    assert np.all((cuts >= 0.0) & (cuts <= 8.0))
    assert np.all(sums_of_quarters(cut(values, cuts)) >= energy - 1e-12)


@given(st.integers(0, 2**32 - 1))
def test_a_window_alone_holds_just_that_much(seed):
    values = octants(seed, count=1)
    energy = max(0.9, float(values[0, 0]))
    held = sums_of_quarters(cut(values, find_cuts(values, 8, energy)))
    np.testing.assert_allclose(held, energy, rtol=1e-12)


def test_cuts_reach_as_far_as_those_of_the_neighbours():
    values = octants(3)
    alone = np.array([find_cuts(values[i : i + 1], 8, 0.9)[0] for i in range(len(values))])
    padded = np.pad(alone, 1, mode="edge")
    np.testing.assert_array_equal(find_cuts(values, 8, 0.9), np.max([padded[:-2], padded[1:-1], padded[2:]], axis=0))


def test_rings_count_as_the_cuts_of_three_windows_say():
    shares = ring_shares(np.array([2.0, 2.0, 3.5, 2.25]), 5)
    np.testing.assert_allclose(shares[0], [1.0, 1.0, 1.0, 0.0, 0.0, 0.0])
    np.testing.assert_allclose(shares[1], [1.0, 1.0, 1.0, 1.0 / 6.0, 0.5 / 6.0, 0.0])
    np.testing.assert_allclose(shares[2], [1.0, 1.0, 1.0, (4.0 + 0.25) / 6.0, 2.0 / 6.0, 0.0])
    np.testing.assert_array_equal(shares_used(np.array([1.5]), 2)[0], [[1, 1, 0.5], [1, 1, 0.5], [0.5, 0.5, 0.5]])
