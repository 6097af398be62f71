"""Interpolation and least squares."""

from __future__ import annotations

import numpy as np
import pytest

from lommel import _core
from lommel.core.engine import least_squares
from lommel.special import interpolation


@pytest.mark.parametrize("band", [0.7, 1.1, 1.6])
@pytest.mark.parametrize("error", [1e-3, 1e-6, 1e-10])
def test_each_wave_of_the_band_is_within_the_error(band, error):
    steps = interpolation.filtered_taps(band, error)
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
    made = interpolation.circular_taps(most, count, error)
    t = np.append([0.0, 1.0], np.random.default_rng(1).random(300))
    waves = np.exp(2j * np.pi / count * np.outer(np.arange(most + 1), made.taps.places))
    exact = np.exp(2j * np.pi / count * np.outer(np.arange(most + 1), t))
    off = np.abs(exact - made.gains[:, None] * (waves @ made.taps.at(t).T)).max(axis=1)
    assert (off <= made.errors).all()
    assert made.errors.max() <= error
    assert off[most] >= 0.1 * made.errors[most] or error < 1e-11


def test_what_few_neighbours_cannot_tell_is_said():
    with pytest.raises(ValueError, match=r"16 taps do not reach an error of 1e-08: the band 3 is too wide"):
        interpolation.filtered_taps(3.0, 1e-8)
    with pytest.raises(ValueError, match=r"16 taps do not reach an error of 1e-08 for order 45 on 96 samples"):
        interpolation.circular_taps(45, 96, 1e-8)


@pytest.mark.parametrize("level", ["portable", "avx2"])
@pytest.mark.parametrize(("rows", "unknowns", "sides"), [(1, 1, 1), (7, 7, 3), (40, 9, 2), (131, 60, 33)])
def test_solutions_are_those_of_a_library(rows, unknowns, sides, level):
    rng = np.random.default_rng(rows)
    matrix, wanted = rng.normal(size=(rows, unknowns)), rng.normal(size=(rows, sides))
    try:
        _core.limit_instructions(level)
        found = least_squares(matrix, wanted)
    finally:
        _core.limit_instructions("avx512")
    np.testing.assert_allclose(found, np.linalg.lstsq(matrix, wanted, rcond=None)[0], atol=1e-10 * rows)


def test_directions_that_the_matrix_lacks_do_not_make_solutions_large():
    rng = np.random.default_rng(2)
    factors = rng.normal(size=(60, 10)) @ rng.normal(size=(10, 30))  # of rank 10
    wanted = factors @ rng.normal(size=(30, 4))
    found = least_squares(factors, wanted)
    least = np.linalg.lstsq(factors, wanted, rcond=1e-10)[0]
    assert np.abs(factors @ found - wanted).max() <= 1e-11 * np.abs(wanted).max()
    assert np.abs(found).max() <= 1.01 * np.abs(least).max()


def test_columns_of_zeros_have_no_share():
    matrix = np.array([[1.0, 0.0], [2.0, 0.0], [2.0, 0.0]])
    np.testing.assert_allclose(least_squares(matrix, np.array([[3.0], [6.0], [6.0]])), [[3.0], [0.0]], atol=1e-14)
    np.testing.assert_array_equal(least_squares(np.zeros((3, 2)), np.ones((3, 1))), 0.0)


@pytest.mark.parametrize("half", [20, 26])
def test_columns_that_nearly_depend_on_others_leave_as_little_as_they_can(half):
    # Cosines along a band of which samples are close together, as of filters of averages.
    frequencies = 2.0 * np.cos(np.pi * (np.arange(200) + 0.5) / 400)
    matrix = np.cos(np.outer(frequencies, np.pi / 4 * np.arange(half + 1)))
    wanted = np.sinc(frequencies / 4)[:, None]
    found = least_squares(matrix, wanted)
    assert np.abs(matrix @ found - wanted).max() <= 1e-14
    assert np.abs(found).sum() < 3.0
