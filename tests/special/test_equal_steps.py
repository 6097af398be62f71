"""Values between equal steps: the weights against waves of any frequency of the band, and their bounds."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.special import equal_steps


@pytest.mark.parametrize("band", [0.05, 0.7, 1.4, 1.8])
@pytest.mark.parametrize("error", [1e-2, 1e-5, 1e-8])
def test_each_wave_of_the_band_is_within_the_error(band, error):
    steps = equal_steps.steps(band, error)
    places = np.arange(steps.taps) - (steps.taps // 2 - 1)
    rng = np.random.default_rng(3)
    t = np.append([0.0, 1.0, 0.5], rng.random(200))
    weights = steps.at(t)
    w = np.append([band, -band, 0.0], band * rng.uniform(-1.0, 1.0, 400))
    off = np.abs(np.exp(1j * np.outer(w, t)) - np.exp(1j * np.outer(w, places)) @ weights.T).max()
    assert off <= steps.error <= error
    assert off >= 0.1 * steps.error or steps.error < 1e-12
    assert np.abs(weights).sum(axis=1).max() <= steps.gain < 4.0


def test_the_weights_are_the_fewest():
    for taps in (8, 12):
        error = equal_steps._fitted(taps, 1.0).error
        assert equal_steps.steps(1.0, error).taps == taps
        assert equal_steps.steps(1.0, 0.99 * error).taps == taps + 2


def test_what_few_neighbours_cannot_tell_is_said():
    with pytest.raises(ValueError, match=r"no 36 neighbours are off by at most 1e-08: the band 3.1 is too wide"):
        equal_steps.steps(3.1, 1e-8)
