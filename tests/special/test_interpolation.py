"""Values between equal steps: taps and filters against waves of any frequency of the band, and their bounds."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.special import interpolation


@pytest.mark.parametrize("band", [0.7, 1.1, 1.6])
@pytest.mark.parametrize("error", [1e-3, 1e-6, 1e-10])
def test_each_wave_of_the_band_is_within_the_error(band, error):
    steps = interpolation.steps(band, error)
    rng = np.random.default_rng(3)
    t = np.append([0.0, 1.0, 0.5], rng.random(200))
    w = np.append([band, -band, 0.0], band * rng.uniform(-1.0, 1.0, 400))
    # A wave is filtered step by step, then interpolated.
    away, beyond = np.arange(1, steps.filter.size), steps.filter.size
    places = np.arange(steps.taps.places[0] - beyond, steps.taps.places[-1] + beyond + 1)
    waves = np.exp(1j * np.outer(w, places))
    middle = slice(beyond, places.size - beyond)
    filtered = steps.filter[0] * waves[:, middle]
    for k in away:
        filtered += steps.filter[k] * (
            waves[:, beyond - k : middle.stop - k] + waves[:, beyond + k : middle.stop + k]
        )
    weights = steps.taps.at(t)
    off = np.abs(np.exp(1j * np.outer(w, t)) - filtered @ weights.T).max()
    assert off <= steps.error <= error
    assert off >= 0.1 * steps.error or steps.error < 1e-12
    assert np.abs(weights).sum(axis=1).max() <= steps.taps.gain <= 1.06 * np.abs(weights).sum(axis=1).max() + 1e-3
    times = np.arange(steps.taps.size) ** 2.0
    assert (
        (np.abs(weights) @ times).max() <= steps.taps.weighted(times) <= 1.06 * (np.abs(weights) @ times).max() + 1e-3
    )
    whole = np.concatenate([steps.filter[:0:-1], steps.filter])
    assert max(np.abs(np.convolve(row, whole)).sum() for row in weights) <= steps.gain < 4.5


@pytest.mark.parametrize("error", [1e-3, 1e-6, 1e-9, 1e-12])
def test_each_order_of_a_circle_is_within_its_error(error):
    most, count = 20, 96
    made = interpolation.orders(most, count, error)
    t = np.append([0.0, 1.0], np.random.default_rng(1).random(300))
    waves = np.exp(2j * np.pi / count * np.outer(np.arange(most + 1), made.taps.places))
    exact = np.exp(2j * np.pi / count * np.outer(np.arange(most + 1), t))
    off = np.abs(exact - made.gains[:, None] * (waves @ made.taps.at(t).T)).max(axis=1)
    assert (off <= made.errors).all()
    assert made.errors.max() <= error
    assert off[most] >= 0.1 * made.errors[most] or error < 1e-11


def test_taps_and_neighbours_are_the_fewest():
    found = interpolation.steps(1.2, 1e-8)
    fewer = interpolation._filtered(found.taps.size - 2, 1.2, interpolation.NEIGHBOURS_MOST)
    assert fewer.error > 1e-8 >= found.error
    assert interpolation._filtered(found.taps.size, 1.2, found.filter.size - 5).error > 1e-8
    around = interpolation.orders(20, 96, 1e-8)
    assert interpolation.orders(20, 96, around.errors.max()).taps.size == around.taps.size
    assert interpolation.orders(20, 96, 0.9 * around.errors.max()).taps.size == around.taps.size + 2


def test_what_few_neighbours_cannot_tell_is_said():
    with pytest.raises(ValueError, match=r"no 16 taps are off by at most 1e-08: the band 3 is too wide"):
        interpolation.steps(3.0, 1e-8)
    with pytest.raises(ValueError, match=r"no 16 taps are off by at most 1e-08 of the order 45 on 96 steps"):
        interpolation.orders(45, 96, 1e-8)
