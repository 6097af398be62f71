"""Channels and spectra."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel.optics.colour import spectrum
from lommel.optics.colour.spectrum import Spectrum, fit_wavelengths
from lommel.optics.wavefront.wavefront import same_path

WAVES = np.arange(400, 701, 10) * 1e-9


def bell(center: float, width: float) -> np.ndarray:
    return np.exp(-0.5 * ((WAVES * 1e9 - center) / width) ** 2)


CURVES = np.stack([bell(600, 30) + 0.05 * bell(450, 40), 2.0 * bell(535, 38), bell(460, 28)])


def test_weights_of_each_channel_sum_to_one_and_its_light_is_kept():
    made = lm.Channels([450e-9, 600e-9], [[0.0, 3.0], [1.0, 5.0]], ["r", "g"])
    assert made.weights == (pytest.approx((0.0, 1.0)), pytest.approx((1 / 6, 5 / 6)))
    assert made.light == (0.5, 1.0)
    assert dict(made)["r"] == ((600e-9, 1.0),)
    assert lm.Channels.from_dict(made.to_dict()) == made


def test_red_green_and_blue_are_those_of_photographs():
    assert lm.Channels.rgb().wavelengths == lm.imaging.RED_GREEN_BLUE
    assert lm.Channels.rgb().names == ("red", "green", "blue")


def test_a_band_has_the_moments_of_an_even_one():
    for name, pairs in lm.Channels.rgb(80e-9, count=4):
        waves, weights = np.array(pairs).T
        middle = dict(zip(lm.Channels.rgb().names, lm.imaging.RED_GREEN_BLUE, strict=True))[name]
        for k, expected in enumerate((1.0, 0.0, 1 / 3, 0.0, 1 / 5, 0.0, 1 / 7)):
            assert weights @ ((waves - middle) / 40e-9) ** k == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize(("paths", "tol"), [(8e-6, 1e-2), (1e-6, 0.4)])
def test_few_wavelengths_are_off_by_what_they_are_at_samples_of_the_path_and_between(paths, tol, monkeypatch):
    sampled, whole = [], spectrum._waves
    monkeypatch.setattr(spectrum, "_waves", lambda *given: sampled.append(given[1]) or whole(*given))
    nodes, weights, error = fit_wavelengths(WAVES, CURVES, paths, tol)
    path = max(sampled, key=len)
    # By the rule of Simpson, with 40 steps in each of the 30 intervals of the table.
    dense = np.linspace(WAVES[0], WAVES[-1], 30 * 40 + 1)
    light = np.stack([np.interp(dense, WAVES, curve) for curve in CURVES]) * np.tile([2.0, 4.0], 601)[:-1]
    light[:, [0, -1]] *= 0.5
    light /= light.sum(axis=1, keepdims=True)
    exact = (light / dense**2) @ np.exp(2j * math.pi * np.outer(1.0 / dense, path))
    sums = (weights / nodes**2) @ np.exp(2j * math.pi * np.outer(1.0 / nodes, path))
    largest = np.abs((sums - exact) / (light @ dense**-2.0)[:, None]).max()
    # Half of the phases between two samples: (2 + tol) / 8 of its square, and a little more.
    phase = math.pi * (1.0 / WAVES[0] - 1.0 / WAVES[-1]) * paths / (len(path) - 1)
    between = 0.25 * (1.0 + tol) * phase**2
    assert error == pytest.approx(largest + between, abs=2e-3 * between)
    assert between <= 0.1 * (1.0 + tol) * tol
    assert (path[0], path[-1], error <= tol, largest > 0.01 * tol) == (0.0, paths, True, True)


def test_limits_of_tolerances_and_the_scale_of_curves():
    assert [spectrum.checked_paths(1e-6, tol)[1] for tol in (1e-6, 0.4999)] == [1e-6, 0.4999]
    for tol in (0.999e-6, 0.5):
        with pytest.raises(ValueError, match="tol must be"):
            spectrum.checked_paths(1e-6, tol)
    made = lm.Channels.from_curves(WAVES, CURVES[1:], paths=1e-6)
    assert made == lm.Channels.from_curves(WAVES, CURVES[1:], paths=1e-6, tol=1e-3)
    assert lm.Channels.from_curves(WAVES, 1e-200 * CURVES[1:], paths=1e-6).error == pytest.approx(
        made.error, rel=1e-6
    )
    assert lm.Channels([550e-9], [[1.0]]).error == 0.0


def test_a_psf_by_few_wavelengths_is_that_of_the_whole_spectrum():
    lens = lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
    pupil, dense = lens.pupil(1.95), np.linspace(400e-9, 700e-9, 301)
    channels = lm.Channels.from_curves(WAVES, CURVES)
    found = lm.colour_psf(pupil, 15, 2e-6, channels, normalize="strehl", dtype=np.float64)
    for curve, answer in zip(CURVES, found, strict=True):
        light = lm.methods.Polychromatic(dense, np.interp(dense, WAVES, curve))
        exact = lm.psf(pupil, 15, 2e-6, method=light, normalize="strehl", dtype=np.float64)
        assert np.abs(answer.values - exact.values).max() <= channels.error <= 1e-3


def test_channels_of_curves_keep_what_each_counts():
    made, light = lm.Channels.from_curves(WAVES, CURVES), np.trapezoid(CURVES, WAVES, axis=1)
    assert made.light == pytest.approx(tuple(light / light[1]), rel=1e-12)
    assert made.error > 0.0
    assert made.paths == 5e-6
    assert lm.Channels.from_dict(made.to_dict()) == made


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([550e-9, 550e-9], np.eye(2)), "wavelengths must all be different"),
        (([550], [[1.0]]), "550e-9"),
    ],
)
def test_what_are_no_channels_is_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        lm.Channels(*arguments)


def test_photographs_take_channels():
    image, depth = np.zeros((24, 24, 3)), np.full((24, 24), 1.8)
    image[12, 12] = 1.0
    lens = lm.Lens(focal_length=8e-3, f_number=2.0, focus_distance=2.0, wavelength=550e-9)
    blur = lm.imaging.Occlusion(lm.imaging.DepthBlur(depth, lens, 3e-6, channels=lm.Channels.rgb()))
    found = lm.imaging.depth_of_field(image, depth, lens, 3e-6, encoding="linear")
    np.testing.assert_allclose(found.values, blur.forward(image), atol=1e-6)


@pytest.mark.parametrize("model", ["paraxial", "aplanatic"])
def test_a_lens_in_other_light_is_the_lens_of_that_wavelength(model):
    """The distances of the lens say what its path differences are, at any wavelength."""
    lens = {"focal_length": 50e-3, "f_number": 2.8, "focus_distance": 2.0, "model": model}
    known = lm.Lens(**lens, wavelength=550e-9, spider=lm.Spider.equal(3, 0.1)).pupil([1.7, 2.5])
    for wave in (400e-9, 700e-9):
        there, other = lm.Lens(**lens, wavelength=wave).pupil([1.7, 2.5]), known.in_light(wave)
        rho = np.linspace(0.0, 1.0, 9)
        # What the terms of an aplanatic phase leave out differs.
        left = 2.0 * (known.wavefront.left_out + there.wavefront.left_out) + 1e-9
        np.testing.assert_allclose(other.wavefront.phase(rho, 0.3), there.wavefront.phase(rho, 0.3), atol=left)
        assert (other.wavelength, other.f_number, other.scale) == (wave, there.f_number, there.scale)
        assert other.spider == known.spider
        assert other.geometry == there.geometry


def test_a_path_is_as_long_in_any_light():
    wavefront = lm.Wavefront(2.0, 1.0, nonradial={(3, 1): 0.5})
    found = same_path(wavefront, 500e-9, 400e-9).to_zernike(unit="metres", wavelength=400e-9)
    expected = wavefront.to_zernike(unit="metres", wavelength=500e-9)
    assert list(found) == list(expected)
    np.testing.assert_allclose(list(found.values()), list(expected.values()), rtol=1e-12)


def test_components_share_the_light_and_are_brighter_where_they_are_narrower():
    spectrum = Spectrum([400e-9, 800e-9], [3.0, 1.0])
    parts = spectrum.components(lm.Pupil(lm.Wavefront(2.0), wavelength=600e-9, f_number=4.0))
    assert [part.share for part in parts] == [0.75, 0.25] == list(spectrum.weights)
    assert [part.stretch for part in parts] == pytest.approx([1.5, 0.75])
    assert [part.weight for part in parts] == pytest.approx([0.75 * 1.5**2, 0.25 * 0.75**2])
    assert [float(part.pupil.wavefront.defocus) for part in parts] == pytest.approx([3.0, 1.5])
    with pytest.raises(ValueError, match="a spectrum needs a pupil with a wavelength"):
        spectrum.components(lm.Pupil())


@pytest.mark.parametrize("weights", [[1.0], [0.0, 0.0], [1.0, -1.0], [1.0, np.nan], [[1.0, 1.0]]])
def test_weights_that_share_no_light_are_refused(weights):
    with pytest.raises(ValueError, match="weights"):
        Spectrum([400e-9, 500e-9], weights)
