"""Averages over pixels of any pupil: the filter, its bound, and what the best placed pixel holds."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm
from lommel._core import average_samples, limit_instructions
from lommel.methods import averaging
from lommel.methods.averaging import filtered_by, least_average


@given(st.floats(-2.0, 2.3), st.floats(-12.0, -2.0))
def test_the_response_of_a_filter_agrees_with_the_pixel_over_the_whole_band(pitch, digits):
    step, error = 10.0**pitch, 10.0**digits
    taps = filtered_by(step, error)
    k = np.arange(taps.weights.size) - taps.weights.size // 2
    w = np.linspace(0.0, 2.0, 4001)
    response = np.cos(np.outer(w, k * step / taps.stride)) @ taps.weights
    assert np.abs(response - np.sinc(0.5 * step * w / math.pi)).max() <= taps.error <= error
    assert np.abs(taps.weights).sum() == pytest.approx(taps.gain)
    assert 1.0 - 2.0 * error <= taps.gain <= 1.5


@pytest.mark.parametrize("step", [0.1, 0.785, 1.6, 3.0, 11.0])
def test_the_bound_on_a_response_is_nearly_reached(step):
    taps = filtered_by(step, 1e-7)
    k = np.arange(taps.weights.size) - taps.weights.size // 2
    w = np.linspace(0.0, 2.0, 20001)
    response = np.cos(np.outer(w, k * step / taps.stride)) @ taps.weights
    assert np.abs(response - np.sinc(0.5 * step * w / math.pi)).max() > 0.5 * taps.error


@pytest.mark.parametrize("wave", [0.0, 0.3, 1.1, 2.0])
def test_waves_within_the_band_are_averaged_over_each_pixel(wave):
    grid, step = lm.Grid((5, 4), 1.0, center=(1.3, 2.2)), 3.7
    taps = filtered_by(step, 1e-9)
    sizes = []

    def samples(fine: lm.Grid) -> list[np.ndarray]:
        sizes.append(fine.shape)
        return [1.0 + np.cos(wave * step * fine.x + 0.4) * np.cos(0.7 * wave * step * fine.y[:, None])[None]]

    found = averaging.filtered(samples, np.empty((1, 1, *grid.shape)), grid, taps)[0, 0]
    across = np.sinc(0.5 * wave * step / math.pi) * np.cos(wave * step * grid.x + 0.4)
    down = np.sinc(0.35 * wave * step / math.pi) * np.cos(0.7 * wave * step * grid.y)
    assert found == pytest.approx(1.0 + down[:, None] * across, abs=6e-9)
    assert len(sizes) == 1


@pytest.mark.parametrize("level", ["portable", "avx2", "avx512"])
@pytest.mark.parametrize("kind", [np.float32, np.float64])
@pytest.mark.parametrize(
    ("stride", "taps", "shape"),
    [(1, 1, (3, 2)), (1, 13, (5, 40)), (3, 7, (4, 129)), (3, 29, (7, 70)), (3, 29, (8, 3)), (5, 31, (2, 64))],
)
def test_the_core_filters_as_numpy_does(level, kind, stride, taps, shape):
    random = np.random.default_rng(5)
    weights = random.normal(size=taps)
    fine = tuple((n - 1) * stride + taps for n in shape)
    samples = random.normal(size=(2, *fine)).astype(kind)
    seen = np.lib.stride_tricks.sliding_window_view(samples.astype(float), (taps, taps), axis=(1, 2))
    expected = np.einsum("nyxab,a,b->nyx", seen[:, ::stride, ::stride], weights, weights)
    images = np.full((2, shape[0] + 1, shape[1]), np.nan)
    limit_instructions(level)
    try:
        average_samples(samples, weights, stride, 1, images[:, :-1])
    finally:
        limit_instructions("avx512")
    assert images[:, :-1] == pytest.approx(np.maximum(expected, 0.0), abs=1e-13 * taps**2)
    assert np.isnan(images[:, -1]).all()


@pytest.mark.parametrize(
    "method", [None, lm.Fraunhofer(), lm.Hankel(), lm.NonuniformFFT(), lm.ChordalGauss(), lm.NijboerZernike(1e-3)]
)
def test_no_average_is_negative(method):
    # Rings darker than what each method is off by.
    for wavefront in (lm.Wavefront(), lm.Wavefront(nonradial={(3, 1): 0.0, (2, 2): 1e-3})):
        if method is None or method.nonradial or wavefront.radial:
            answer = lm.psf(lm.Pupil(wavefront), 33, 0.15, integrate=True, method=method, center=(5.0, 110.0))
            assert answer.values.min() >= 0.0


def test_tiles_change_nothing(monkeypatch):
    pupil = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 1.0}))
    whole = lm.psf(pupil, (9, 14), 1.5, integrate=True, dtype=np.float64)
    monkeypatch.setattr(averaging, "_VALUES", 1)
    tiled = lm.psf(pupil, (9, 14), 1.5, integrate=True, dtype=np.float64)
    assert tiled.values == pytest.approx(whole.values, abs=2e-6 * whole.values.max())
    assert tiled.error_bound <= 1e-6


@given(st.floats(0.01, 40.0), st.floats(0.0, 12.0), st.floats(-8.0, 8.0))
def test_a_pixel_around_the_peak_averages_as_much_as_is_promised(step, defocus, spherical):
    pupil = lm.Pupil(lm.Wavefront(defocus, spherical))
    v = np.linspace(0.0, 60.0, 3001)
    peak = (np.abs(lm.NijboerZernike().field(pupil, v)) ** 2).max()
    at = v[int(np.argmax(np.abs(lm.NijboerZernike().field(pupil, v))))]
    pixel = step / math.pi
    around = lm.psf(pupil, 1, pixel, center=(0.0, at / step), integrate=True, normalize="strehl", dtype=np.float64)
    assert around.values[0, 0] >= (1.0 - 1e-4) * least_average(step) * peak


def test_half_of_what_is_promised_of_the_best_placed_pixel_would_be_too_little_to_ask():
    # A wave of the largest frequency is the worst case, and meets the promise for a disc-shaped pixel.
    step = 1.0
    x = (np.arange(400) + 0.5) / 400 - 0.5
    s = np.hypot(x, x[:, None]) * step
    disc = np.where(s <= 0.5 * step, np.cos(s) ** 2, 0.0).mean()
    assert disc == pytest.approx(least_average(step), rel=1e-3)


def test_pixels_too_wide_for_a_filter_are_refused_with_a_way_out():
    pupil = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 1.0}))
    with pytest.raises(ValueError, match=r"pixel must be at most 171 lambda\*N .* got 200 lambda\*N; take smaller"):
        lm.psf(pupil, 3, 200.0, integrate=True)


def test_a_tolerance_that_samples_cannot_meet_is_told_as_it_was_given():
    pupil = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 1.0}))
    with pytest.raises(lm.ToleranceError, match=r"tol=1e-11 cannot be met by averages over pixels of 20 lambda\*N"):
        lm.psf(pupil, 3, 20.0, integrate=True, method=lm.NijboerZernike(1e-11))
