"""Likelihood of a blur by the power spectrum; textures are filtered noise, without this package."""

from __future__ import annotations

import numpy as np
import pytest
import scipy
from scipy.special import j1

from lommel.imaging.blur_spectrum import FREQUENCIES, BlurSpectrum
from lommel.imaging.blur_verdict import BlurVerdict, compare_blurs, estimate_blur


def disc(f: np.ndarray, diameter: np.ndarray | float) -> np.ndarray:
    """Return the transfer function of a uniform disc."""
    x = np.pi * f * diameter
    return 2.0 * j1(x) / x


def test_window_does_not_bias_the_likeliest_diameter():
    """The window and the rings fill the zeros of the spectrum, which without their average gave 7.92 pixels."""
    side, count, diameter = 96, 4, 8.0
    draw = np.random.default_rng(0)
    sides = (side * count, side * count)
    fy, fx = np.fft.fftfreq(sides[0])[:, None], np.fft.rfftfreq(sides[1])
    f = np.maximum(np.hypot(fy, fx), 0.5 / side)
    spectrum = np.fft.rfft2(draw.standard_normal(sides)) * disc(f, diameter) * np.sinc(fy) * np.sinc(fx) / f**1.25
    texture = np.fft.irfft2(spectrum, sides)
    photo = texture / texture.std() * 30.0 + draw.standard_normal(sides)
    diameters = np.linspace(7.7, 8.3, 25)
    curves, unit = disc(FREQUENCIES, diameters[:, None]), np.ones((1, side, side))
    likelihood = np.zeros(len(diameters))
    for tile in photo.reshape(count, side, count, side).swapaxes(1, 2).reshape(-1, 1, side, side):
        likelihood += BlurSpectrum.windowed(tile, unit).likelihood(curves, 0, 1.0)
    assert abs(diameters[np.argmax(likelihood)] - diameter) < 0.04


def test_sharpening_is_that_of_the_best_mask_alone():
    rng = np.random.default_rng(4)
    noise = rng.normal(size=(96, 96))
    plane = noise + 0.8 * (noise - scipy.ndimage.gaussian_filter(noise, 1.5, mode="wrap"))
    curves = np.exp(-np.square(8.0 * FREQUENCIES))[None] * np.ones((2, 1))
    masks = [(0.4, 0.7), (0.8, 1.5), (1.5, 2.5)]
    gains = []
    for amounts, widths in [*(((a,), (w,)) for a, w in masks), tuple(zip(*masks, strict=True))]:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr("lommel.imaging.blur_spectrum._AMOUNTS", amounts)
            patch.setattr("lommel.imaging.blur_spectrum._MASKS", widths)
            rings = BlurSpectrum.windowed(plane[None], np.ones((1, 96, 96)))
            gains.append(rings.sharpening(curves, 0, 1.0))
    assert np.argmax(gains[:3]) == 1
    assert gains[1] > 100.0
    assert gains[3] == pytest.approx(max(gains[:3]))


@pytest.mark.parametrize(("seed", "blur"), [(1, "Gaussian"), (4, "Gaussian"), (1, "disc"), (3, "disc")])
def test_light_beyond_the_first_zero_tells_a_disc_from_a_steep_soft_scene(seed, blur):
    draw, side, white = np.random.default_rng(seed), 96, 20000.0
    f = np.hypot(np.fft.fftfreq(4 * side)[:, None], np.fft.rfftfreq(4 * side))
    f[0, 0] = 1.0
    fall = disc(f, 6.0) if blur == "disc" else np.exp(-0.5 * np.square(2.0 * np.pi * 1.5 * f))
    spectrum = np.fft.rfft2(draw.normal(size=(4 * side, 4 * side))) * f**-1.5 * fall * (f < 0.5)
    texture = np.fft.irfft2(spectrum)[:side, :side]
    light = draw.poisson(white * (0.4 + 0.1 * (texture - texture.mean()) / texture.std())) / white
    found = estimate_blur(lambda d: disc(FREQUENCIES, d[:, None]), True, 1.0, light, light / white)
    assert found.known == (blur == "disc")
    if found.known:
        assert abs(np.log(found.diameter / 6.0)) < 3.0 * found.error


@pytest.mark.parametrize(
    ("slope", "gain", "sharpness", "expected"),
    [(1.75, 0.0, 1.0, True), (2.0, 0.0, 1.0, False), (1.5, 2.5, 0.9, False), (1.5, 5.0, 1.1, False)],
)
def test_a_weak_blur_of_a_flat_texture_is_told(slope, gain, sharpness, expected):
    verdict = BlurVerdict(1.0, 0.0, gain, sharpness, 0.0, 1.0, 0.0, slope, weak=True, edges=0.5)
    assert verdict.flat == expected
    assert not verdict._replace(weak=False).flat


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        ({}, True), ({"slope": 1.0}, False), ({"weak": True}, False), ({"gain": 7.0}, False),
        ({"gain": 7.0, "sharpness": 0.9}, False), ({"noise_gain": 7.0}, False), ({"sharpening": 4.0}, False),
    ],
)  # fmt: skip
def test_a_blur_is_as_stated_where_none_is_likelier_and_scenes_explain_the_detail(change, expected):
    verdict = BlurVerdict(0.9, 0.0, 2.0, 1.1, 0.0, 1.0, 0.0, 1.25)
    assert verdict._replace(**change).as_stated == expected


@pytest.mark.parametrize(("diameter", "weak"), [(2.0, True), (3.0, False)])
def test_a_blur_without_zeros_at_the_frequencies_of_pixels_is_weak(diameter, weak):
    light = np.random.default_rng(0).normal(0.5, 0.1, (48, 48))
    curves = lambda factors: disc(FREQUENCIES, diameter * factors[:, None])  # noqa: E731
    assert compare_blurs(curves, None, light, np.full(light.shape, 1e-4), light).weak == weak


@pytest.mark.parametrize(("slope", "edges", "expected"), [(3.0, 0.7, False), (3.0, 0.76, True), (1.5, 0.76, True)])
def test_edges_that_restoration_makes_ring_are_told(slope, edges, expected):
    verdict = BlurVerdict(1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, slope, weak=True, edges=edges)
    assert verdict.ringing == expected
    assert not verdict._replace(weak=False).ringing
    assert not verdict._replace(gain=10.0, sharpness=1.2).ringing  # is told by the likelier blur


@pytest.mark.parametrize(("weak", "edges", "expected"), [(True, 0.3, False), (True, 0.5, True), (False, 0.0, True)])
def test_of_a_weak_blur_edges_must_agree_that_it_is_stated_too_wide(weak, edges, expected):
    verdict = BlurVerdict(0.6, 0.0, 20.0, 1.2, 0.0, 1.0, 0.0, 2.5, weak=weak, edges=edges)
    assert verdict.sharper
    assert verdict.doubtful == expected
    assert verdict.implausible == (weak and expected)


def test_total_variation_rises_by_restoration_of_a_sharp_photograph():
    squares = np.kron(np.random.default_rng(1).uniform(0.2, 0.8, (8, 8)), np.ones((12, 12)))
    f = np.hypot(np.fft.fftfreq(96)[:, None], np.fft.rfftfreq(96))
    f[0, 0] = 1e-6
    transfer = disc(f, 2.0)
    blurred = np.fft.irfft2(np.fft.rfft2(squares) * transfer)
    ringing = np.fft.irfft2(np.fft.rfft2(squares) * transfer / (transfer**2 + 1e-3))
    curves = lambda factors: disc(FREQUENCIES, 2.0 * factors[:, None])  # noqa: E731
    right, wrong = (
        compare_blurs(curves, None, light, np.full(light.shape, 1e-4), restored).edges
        for light, restored in ((blurred, squares), (squares, ringing))
    )
    assert abs(right) < 0.1
    assert wrong > 0.9
