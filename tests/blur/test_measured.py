"""What is measured, saved and drawn of images on oblong pixels and through blur."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm

CAMERA = lm.Pupil(lm.Wavefront(1.0), wavelength=500e-9, f_number=4.0)
SPREAD = {"pixel": (1.1e-6, 0.7e-6), "fill": (0.9, 0.7), "blur": [lm.Jitter(0.5e-6), lm.Motion(1e-6, 0.2)]}


@pytest.fixture(scope="module")
def answer() -> lm.PSF:
    return lm.psf(CAMERA, (41, 61), **SPREAD)


@pytest.mark.parametrize("suffix", ["npz", "npy", "tif"])
def test_files_bring_back_pixels_and_blur(answer, tmp_path, suffix):
    answer.save(tmp_path / f"psf.{suffix}")
    back = lm.PSF.load(tmp_path / f"psf.{suffix}")
    assert back.grid == answer.grid
    assert back.grid.fill == (0.9, 0.7)
    assert back.blur == answer.blur
    assert np.abs(back.values - answer.values).max() <= 2e-5 * answer.values.max()


def test_the_transfer_function_of_an_image_is_the_product_of_all_factors(answer):
    wide = lm.psf(CAMERA, (257, 401), dtype="float64", **SPREAD)
    f = np.array([0.0, 5e4, 1.5e5])
    for fx, fy in ((f, 0.0), (0.0, f), (0.6 * f, 0.6 * f)):
        expected = lm.otf(CAMERA, fx, fy, **SPREAD)
        # What lies outside of the window is missing.
        assert wide.otf(fx, fy) == pytest.approx(expected, abs=1.5 * (1.0 - float(wide.energy)))
    assert answer.pixel == (1.1e-6, 0.7e-6)


def test_factors_of_the_transfer_function_multiply():
    f = np.array([1e5, 2e5])
    plain, whole = lm.mtf(CAMERA, f), lm.mtf(CAMERA, f, **SPREAD)
    factor = np.sinc(0.49e-6 * f) * np.prod([blur.transfer(f) for blur in SPREAD["blur"]], axis=0)
    assert whole == pytest.approx(np.abs(plain * factor))
    level = float(lm.mtf_frequency(CAMERA, 0.3, **SPREAD))
    assert float(lm.mtf(CAMERA, level, **SPREAD)) == pytest.approx(0.3, abs=1e-8)


def test_lengths_are_measured_along_both_sides_of_a_pixel():
    oblong = lm.psf(lm.Pupil(), (61, 91), (0.3, 0.2), blur=lm.Jitter(0.3), center=(28.4, 44.7))
    square = lm.psf(lm.Pupil(), 91, 0.2, blur=lm.Jitter(0.3))
    assert oblong.centroid == pytest.approx(np.zeros(2), abs=5e-3)
    for along in ("x", "y"):
        assert float(oblong.fwhm(along)) == pytest.approx(float(square.fwhm(along)), rel=2e-3)
    for radius in (0.5, 1.0, 3.0):  # sums over pixels, as if each held its value all over
        for measure in (lm.PSF.encircled_energy, lm.PSF.ensquared_energy):
            assert float(measure(oblong, radius)) == pytest.approx(float(measure(square, radius)), abs=2e-2)
    assert float(oblong.energy_diameter(0.5)) == pytest.approx(float(square.energy_diameter(0.5)), rel=2e-2)


def test_energy_in_a_circle_of_a_radial_pupil_is_exact_whatever_the_pixels():
    plain, oblong = lm.psf(lm.Pupil(), 9, 0.5), lm.psf(lm.Pupil(), 9, (0.5, 0.8))
    assert float(oblong.encircled_energy(2.0)) == pytest.approx(float(plain.encircled_energy(2.0)), abs=1e-6)
    wide = lm.psf(lm.Pupil(), (21, 33), (0.5, 0.3), integrate=True)
    assert float(wide.energy) == pytest.approx(float(wide.values.sum()), abs=1e-5)


@pytest.mark.parametrize("blur", [(), lm.Jitter(0.6)], ids=["sharp", "blurred"])
@pytest.mark.parametrize("coma", [{}, {(3, 1): 0.3}], ids=["radial", "coma"])
def test_energy_is_the_light_in_the_window_and_values_times_the_fill_that_on_active_parts(coma, blur):
    pupil = lm.Pupil(lm.Wavefront(np.array([1.5, 2.0]), nonradial=coma))
    ask = {"blur": blur, "dtype": np.float64, "tol": 1e-7}
    half = lm.psf(pupil, (9, 10), 2.4, fill=0.25, **ask)
    whole = lm.psf(pupil, (9, 10), 2.4, integrate=True, **ask)
    # Quarters of pixels, of which the inner ones are active.
    fine = lm.psf(pupil, (36, 40), 0.6, integrate=True, center=(4 * 4 + 1.5, 4 * 5 + 1.5), **ask)
    assert np.asarray(half.energy) == pytest.approx(whole.values.sum(axis=(1, 2)), abs=1e-5)
    assert np.asarray(half.energy) == pytest.approx(fine.values.sum(axis=(1, 2)), abs=1e-5)
    active = fine.values.reshape(2, 9, 4, 10, 4)[:, :, 1:3, :, 1:3].sum(axis=(2, 4))
    assert half.values * 0.25 == pytest.approx(active, abs=1e-6)
    # What makes the two worth telling apart.
    assert np.all(np.abs(half.values.sum(axis=(1, 2)) - half.energy) > 1e-3)


def test_profiles_and_gradients_say_that_there_are_none(answer):
    with pytest.raises(ValueError, match="for a PSF with blur"):
        answer.profile([0.0])
    with pytest.raises(ValueError, match="square pixels without fill and blur"):
        answer.pullback(np.ones(answer.shape))
