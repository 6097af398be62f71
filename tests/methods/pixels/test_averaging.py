"""Averages over pixels of any pupil: the filter, its bound, and what the best placed pixel holds."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import lommel as lm
from disk_quadrature import exact_lattice
from lommel._core import average_samples, limit_instructions
from lommel.core.engine import least_average
from lommel.methods import ChordalGauss, Hankel, NijboerZernike, NonuniformFFT, averaging, chordal_gauss
from lommel.methods.averaging import averaging_filter, fit_pair_weights
from lommel.optics.grid import Grid
from lommel.paper import Fraunhofer


@given(st.floats(-2.0, 2.3), st.floats(-12.0, -2.0))
def test_the_response_of_a_filter_agrees_with_the_pixel_over_the_whole_band(pitch, digits):
    step, error = 10.0**pitch, 10.0**digits
    taps = averaging_filter(step, error)
    k = np.arange(taps.weights.size) - taps.weights.size // 2
    w = np.linspace(0.0, 2.0, 4001)
    response = np.cos(np.outer(w, k * step / taps.stride)) @ taps.weights
    assert np.abs(response - np.sinc(0.5 * step * w / math.pi)).max() <= taps.error <= error
    assert np.abs(taps.weights).sum() == pytest.approx(taps.gain)
    assert 1.0 - 2.0 * error <= taps.gain <= 1.5


@pytest.mark.parametrize("wave", [0.0, 0.3, 1.1, 2.0])
def test_waves_within_the_band_are_averaged_over_each_pixel(wave):
    grid, step = Grid((5, 4), 1.0, center=(1.3, 2.2)), 3.7
    taps = averaging_filter(step, 1e-9)
    sizes = []

    def samples(fine: Grid) -> list[np.ndarray]:
        sizes.append(fine.shape)
        return [1.0 + np.cos(wave * step * fine.x + 0.4) * np.cos(0.7 * wave * step * fine.y[:, None])[None]]

    found = np.empty(grid.shape)
    averaging.average_strips(samples, found[None, None], grid, taps)
    across = np.sinc(0.5 * wave * step / math.pi) * np.cos(wave * step * grid.x + 0.4)
    down = np.sinc(0.35 * wave * step / math.pi) * np.cos(0.7 * wave * step * grid.y)
    assert found == pytest.approx(1.0 + down[:, None] * across, abs=6e-9)
    assert len(sizes) == 1


@pytest.mark.parametrize("level", ["portable", "avx2", "avx512"])
@pytest.mark.parametrize("kind", [np.float32, np.float64])
@pytest.mark.parametrize(
    ("pixels", "stride", "taps", "shape"),
    [
        (1, 1, 1, (3, 2)),
        (1, 1, 13, (5, 40)),
        (1, 3, 7, (4, 129)),
        (1, 3, 29, (7, 70)),
        (1, 3, 29, (8, 3)),
        (1, 5, 31, (2, 64)),
        (2, 3, 36, (7, 141)),
        (2, 5, 63, (9, 1)),
        (2, 5, 9, (5, 70)),
    ],
)
def test_the_core_filters_as_numpy_does(level, kind, pixels, stride, taps, shape):
    random = np.random.default_rng(5)
    weights = random.normal(size=(pixels, taps))
    samples = random.normal(size=(2, *((n - 1) // pixels * stride + taps for n in shape))).astype(kind)
    seen = np.lib.stride_tricks.sliding_window_view(samples.astype(float), (taps, taps), axis=(1, 2))
    each = np.einsum("nyxab,pa,qb->nypxq", seen[:, ::stride, ::stride], weights, weights)
    _, down, _, across, _ = each.shape
    expected = each.reshape(2, down * pixels, across * pixels)[:, : shape[0], : shape[1]]
    images = np.full((2, shape[0] + 1, shape[1]), np.nan)
    limit_instructions(level)
    try:
        average_samples(samples, weights, stride, 1, images[:, :-1])
        assert np.isnan(images[:, -1]).all()
        exact = images[:, :-1].copy()
        # As large as the largest sample, or nothing is dark.
        for dark, rounding in ((float(samples.max()), 2.0**-24), (0.99 * float(samples.max()), 2.0**-24)):
            average_samples(samples, weights, stride, 1, images[:, :-1], dark=dark)
            gain = np.abs(weights).sum(axis=1).max() ** 2
            assert np.abs(images[:, :-1] - exact).max() <= 2 * (taps + 4) * rounding * gain * np.abs(samples).max()
    finally:
        limit_instructions("avx512")
    assert exact == pytest.approx(np.maximum(expected, 0.0), abs=1e-13 * taps**2)


def test_dark_samples_alone_are_summed_in_single_precision():
    random, weights = np.random.default_rng(1), np.full((1, 19), 1.0 / 19.0)
    dark = random.uniform(0.0, 0.1, (1, 200, 200)).astype(np.float32)
    bright = np.concatenate([dark, dark + np.float32(1.0)], axis=1)

    def averages(samples, limit):
        out = np.empty((1, samples.shape[1] - 18, 182))
        average_samples(samples, weights, 1, 1, out, dark=limit)
        return out

    for samples, clear, seen in (
        (bright, slice(0, 176), slice(188, None)),
        (bright[:, ::-1], slice(206, None), slice(0, 196)),
    ):
        exact, found = (averages(np.ascontiguousarray(samples), limit) for limit in (0.0, 0.1))
        assert np.abs(found - exact)[:, clear].max() > 0.0
        assert np.array_equal(found[:, seen], exact[:, seen])
    assert np.array_equal(averages(bright.astype(float), 2.0), averages(bright.astype(float), 0.0))


@given(st.floats(0.02, 2.3), st.floats(-12.0, -2.0), st.integers(0, 3))
def test_the_responses_of_two_pixels_that_share_samples_agree_with_the_pixel(pitch, digits, more):
    step, error = 10.0**pitch, 10.0**digits
    s = math.ceil(2.0 * step / 1.27) // 2 * 2 + 1 + 2 * more
    weights, claimed, gain = fit_pair_weights(lambda w: np.sinc(0.5 * step / math.pi * w), step, error, s)
    middle = (weights.shape[1] - s // 2 - 1) // 2
    w = np.linspace(0.0, 2.0, 4001)
    for k, of in enumerate(weights):
        x = (np.arange(of.size) - middle - 0.5 * s * k) * 2.0 * step / s
        missed = np.abs(np.exp(1j * np.outer(w, x)) @ of - np.sinc(0.5 * step * w / math.pi)).max()
        assert missed <= claimed + 1e-14 * gain
        assert np.abs(of).sum() <= gain * (1.0 + 1e-12)
    assert claimed <= error
    assert gain <= 1.5


def _transfer(w: np.ndarray) -> np.ndarray:
    """Return the transfer function of a disc at frequencies of modulus w, whose integral is 1."""
    share = np.clip(0.5 * w, 0.0, 1.0)
    return (np.arccos(share) - share * np.sqrt(1.0 - share**2)) * 2.0 / math.pi / math.pi


@given(st.floats(0.1, 6.5), st.floats(-8.0, -3.0), st.integers(3, 40))
@settings(max_examples=20)
def test_what_a_filter_makes_of_the_light_of_a_disc_is_off_by_less_than_it_claims(step, digits, side):
    """In the mean over the transfer function, by a sum over a lattice of frequencies."""
    taps = averaging._cheapest_filter(step, 10.0**digits, (side, side), in_mean=True)
    one = np.linspace(-2.0, 2.0, 401)
    weigh = _transfer(np.hypot(one[:, None], one)) * (one[1] - one[0]) ** 2
    assert weigh.sum() == pytest.approx(1.0, rel=1e-4)
    middle = taps.margin
    for pixel in range(taps.pixels):
        x = (
            (np.arange(taps.weights.shape[-1]) - middle - 0.5 * taps.stride * pixel)
            * taps.pixels
            * step
            / taps.stride
        )
        response = np.exp(1j * np.outer(one, x)) @ np.reshape(taps.weights, (taps.pixels, -1))[pixel]
        mean = np.sinc(0.5 * step * one / math.pi)
        missed = np.abs(np.outer(response, response) - np.outer(mean, mean))
        assert (missed * weigh).sum() <= (2.0 + taps.error) * taps.error
    assert taps.error <= 10.0**digits
    assert taps.gain <= 1.5


@given(
    st.sampled_from([3, 5, 7]),
    st.floats(0.35, 1.27),
    st.lists(st.floats(-1.5, 1.5), min_size=4, max_size=4),
    st.tuples(st.floats(1.0, 3.0), st.floats(1.0, 4.0)),
    st.sampled_from([(1e-4, np.float32), (1e-6, np.float32), (1e-6, np.float64), (1e-9, np.float64)]),
)
@settings(max_examples=12)
def test_averages_of_pixels_that_share_samples_agree_with_quadrature(s, h, sizes, center, asked):
    step, (tol, dtype) = 0.5 * s * h, asked
    pupil = lm.Pupil(lm.Wavefront(sizes[0], nonradial=dict(zip([(3, 1), (2, -2), (3, 3)], sizes[1:], strict=True))))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(averaging, "pair_stride", lambda *_, **__: s)
        found = lm.psf(
            pupil, (5, 6), step / math.pi, center=center, integrate=True, tol=tol, dtype=dtype, normalize="strehl"
        )
    x, w = np.polynomial.legendre.leggauss(7 + int(0.8 * step))
    vy, vx = (step * (np.arange(n)[:, None] + 0.5 * x - at).ravel() for n, at in zip((5, 6), center, strict=True))
    values = np.abs(exact_lattice(pupil, vx, vy, 40 + int(0.6 * step * 9), 160 + int(2.5 * step * 9))) ** 2
    exact = 0.25 * np.einsum("yaxb,a,b->yx", values.reshape(5, x.size, 6, x.size), w, w)
    assert found.error_bound <= tol
    # Which is over the largest average anywhere: of so little aberration hardly more than the largest of these.
    assert np.abs(found.values - exact).max() <= 1.1 * found.error_bound * exact.max()


@pytest.mark.parametrize(
    "method", [None, Fraunhofer(), Hankel(), NonuniformFFT(), ChordalGauss(), NijboerZernike(1e-3)]
)
def test_no_average_is_negative(method):
    # Rings darker than what each method is off by.
    for wavefront in (lm.Wavefront(), lm.Wavefront(nonradial={(3, 1): 0.0, (2, 2): 1e-3})):
        if method is None or method.nonradial or wavefront.radial:
            answer = lm.psf(lm.Pupil(wavefront), 33, 0.15, integrate=True, method=method, center=(5.0, 110.0))
            assert answer.values.min() >= 0.0


@pytest.mark.parametrize("s", [8, 9])
def test_tiles_change_nothing(monkeypatch, s):
    pupil = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 1.0}))
    monkeypatch.setattr(chordal_gauss, "disk_averages", lambda *_, **__: None)  # as of windows that have no nodes
    monkeypatch.setattr(averaging, "pair_stride", lambda *_, **__: s)
    whole = lm.psf(pupil, (9, 14), 1.5, integrate=True, dtype=np.float64)
    monkeypatch.setattr(averaging, "_BLOCK_SAMPLES", 1)
    tiled = lm.psf(pupil, (9, 14), 1.5, integrate=True, dtype=np.float64)
    assert tiled.values == pytest.approx(whole.values, abs=2e-6 * whole.values.max())
    assert tiled.error_bound <= 1e-6


@given(st.floats(0.01, 40.0), st.floats(0.0, 12.0), st.floats(-8.0, 8.0))
def test_a_pixel_around_the_peak_averages_as_much_as_is_promised(step, defocus, spherical):
    pupil = lm.Pupil(lm.Wavefront(defocus, spherical))
    v = np.linspace(0.0, 60.0, 3001)
    peak = (np.abs(NijboerZernike().field(pupil, v)) ** 2).max()
    at = v[int(np.argmax(np.abs(NijboerZernike().field(pupil, v))))]
    pixel = step / math.pi
    around = lm.psf(pupil, 1, pixel, center=(0.0, at / step), integrate=True, normalize="strehl", dtype=np.float64)
    assert around.values[0, 0] >= (1.0 - 1e-4) * least_average(step) * peak


def test_a_tolerance_beyond_double_precision_names_one_that_is_met():
    coma = lm.Wavefront.zernike({7: 0.1, 8: 0.05}, order="noll", unit="waves")
    lens = lm.Lens(focal_length=6e-3, f_number=2.8, focus_distance=1.0, wavelength=550e-9, aberrations=coma)
    pupil, window = lens.pupil(5e-3), (3, 701)  # nearer than the focal length: C_d of 1300 rad
    with pytest.raises(lm.ToleranceError) as refused:
        lm.psf(pupil, window, 1.4e-6, tol=1e-6)
    assert str(refused.value).count("tol=") == 2
    advised = float(re.search(r"give tol=(\S+)$", str(refused.value))[1])
    assert refused.value.bound < advised == float(f"{advised:.2g}") <= 2.2 * refused.value.bound
    fine, coarse = (lm.psf(pupil, window, 1.4e-6, tol=tol, dtype="float64") for tol in (advised, 1e-4))
    assert fine.error_bound <= advised
    assert lm.peak_error(coarse.values, fine.values) <= fine.error_bound + coarse.error_bound
