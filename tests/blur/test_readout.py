"""Pixels from samples: each wave comes back averaged, within what is claimed."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.blur.convolution import ends, gained, readout
from lommel.blur.turbulence import Gate

PLACES = np.sort(np.random.default_rng(3).uniform(-30.0, 40.0, 9))


@pytest.mark.parametrize("error", [1e-4, 1e-7, 1e-10, 1e-13])
@pytest.mark.parametrize("active", [0.0, 0.3, 2.7, 40.0, 400.0])
def test_waves_of_the_band_are_averaged_over_pixels_anywhere(error, active):
    gate = Gate.of(0.8, error)
    made = readout(tuple(PLACES), active, gate)
    at = gate.h * (made.first + np.arange(made.samples))
    w = np.linspace(0.0, 2.0, 301)
    found = made.matrix @ np.exp(1j * np.outer(at, w))
    expected = np.exp(1j * np.outer(PLACES, w)) * np.sinc(0.5 * active * w / np.pi)
    worst = np.abs(found - expected).max()
    assert worst <= made.error
    assert made.error < 4.0 * error
    assert np.abs(made.matrix).sum(axis=1).max() == pytest.approx(made.gain)
    assert made.gain <= gained(gate)


@pytest.mark.parametrize("error", [1e-4, 1e-9])
def test_beyond_the_ends_of_a_gate_little_is_left(error):
    gate = Gate.of(0.8, error)
    far, cut = ends(gate)
    k = np.arange(-4000, 4001)
    for shift in np.linspace(0.0, gate.h, 17):
        x = shift - gate.h * k
        g = np.sinc(x / gate.h) / gate.h * np.exp(-0.25 * (gate.width * x) ** 2)
        assert gate.h * np.abs(g[np.abs(x) > far]).sum() <= cut


@pytest.mark.parametrize("error", [1e-4, 1e-13])
def test_the_largest_gain_of_samples_anywhere_is_bounded_and_nearly_reached(error):
    gate = Gate.of(0.8, error)
    largest = readout(tuple(np.linspace(0.0, gate.h, 1001)), 0.0, gate).gain
    assert largest <= gained(gate) <= 1.05 * largest
