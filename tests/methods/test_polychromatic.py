"""Spectra are weighted sums, whatever else is asked."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import j0, j1

import lommel as lm

WAVES, WEIGHTS = (450e-9, 550e-9, 650e-9), (1.0, 2.0, 1.0)


def lens(wavelength: float = 550e-9) -> lm.Lens:
    aberrations = (550e-9 / wavelength) * lm.Wavefront.from_seidel(W040=0.5)
    return lm.Lens(focal_length=20e-3, f_number=4.0, wavelength=wavelength, aberrations=aberrations)


def test_a_spectrum_is_the_sum_of_what_each_wavelength_makes():
    answer = lm.psf(lens().pupil(3.0), 41, 2e-6, method=lm.Polychromatic(WAVES, WEIGHTS))
    parts = [lm.psf(lens(w).pupil(3.0), 41, 2e-6, method=lm.Hankel()).values for w in WAVES]
    expected = sum(w / 4.0 * p for w, p in zip(WEIGHTS, parts, strict=True))
    assert lm.peak_error(answer, expected) <= answer.error_bound <= 1.1e-6


def test_a_single_wavelength_is_the_reference_itself():
    plain = lm.psf(lens().pupil(3.0), 41, 2e-6, dtype=np.float64)
    answer = lm.psf(lens().pupil(3.0), 41, 2e-6, dtype=np.float64, method=lm.Polychromatic([550e-9], [7.0]))
    assert lm.peak_error(answer, plain) < 2e-6
    assert answer.strehl == pytest.approx(plain.strehl, abs=1e-6)


def test_without_aberration_the_strehl_ratio_is_one():
    perfect = lm.Pupil(wavelength=550e-9, f_number=4.0)
    answer = lm.psf(perfect, 21, 1e-6, method=lm.Polychromatic(WAVES, WEIGHTS), normalize="strehl", integrate=False)
    assert answer.strehl == pytest.approx(1.0, abs=2e-6)
    assert answer.values.max() == pytest.approx(1.0, abs=2e-6)


def test_energies_pixel_averages_and_files_work_as_of_any_method(tmp_path):
    method = lm.Polychromatic(WAVES, WEIGHTS, lm.NijboerZernike(1e-7))
    answer = lm.psf(lens().pupil(3.0), 60, 3e-6, method=method, integrate=True, dtype=np.float64)
    assert answer.sampling == "pixel"
    assert answer.values.sum() == pytest.approx(answer.energy, abs=1e-6)
    answer.save(tmp_path / "p.npz")
    assert lm.PSF.load(tmp_path / "p.npz").encircled_energy(9e-6) == answer.encircled_energy(9e-6)


def test_what_makes_no_spectrum_is_refused():
    with pytest.raises(ValueError, match="weights"):
        lm.Polychromatic(WAVES, (1.0, 2.0))
    with pytest.raises(ValueError, match="weights"):
        lm.Polychromatic(WAVES, (0.0, 0.0, 0.0))
    with pytest.raises(ValueError, match="weights"):
        lm.Polychromatic(WAVES, (1.0, -1.0, 1.0))
    with pytest.raises(ValueError, match=r"550e-9"):
        lm.Polychromatic((550,), (1.0,))
    with pytest.raises(TypeError, match="method must be a Method of one wavelength"):
        lm.Polychromatic(WAVES, WEIGHTS, "fft")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="method must be a Method of one wavelength"):
        lm.Polychromatic(WAVES, WEIGHTS, lm.Polychromatic(WAVES, WEIGHTS))
    with pytest.raises(ValueError, match="needs a pupil with a wavelength"):
        lm.psf(lm.Pupil(), 21, 0.5, method=lm.Polychromatic(WAVES, WEIGHTS))


def test_a_spectrum_of_a_wavefront_that_depends_on_the_direction_is_the_sum_of_its_parts():
    pupil = lm.Pupil(lm.Wavefront(2.0, nonradial={(3, 1): 3.0, (2, -2): 1.0}), wavelength=550e-9, f_number=4.0)
    answer = lm.psf(
        pupil, (21, 24), 1e-6, method=lm.Polychromatic(WAVES, WEIGHTS), normalize="strehl", dtype=np.float64
    )
    total, whole = np.zeros((21, 24)), 0.0
    for wave, weight in zip(WAVES, WEIGHTS, strict=True):
        scale = 550e-9 / wave
        part = lm.Pupil(scale * pupil.wavefront, wavelength=wave, f_number=4.0)
        one = lm.psf(part, (21, 24), 1e-6, normalize="strehl", method=lm.NijboerZernike(1e-9), dtype=np.float64)
        total += weight * scale**2 * one.values
        whole += weight * scale**2
    assert np.abs(answer.values - total / whole).max() <= answer.error_bound * answer.values.max()
    assert answer.error_bound <= 1e-6 + 1e-15
    with pytest.raises(ValueError, match="sums Hankel, which supports radially symmetric"):
        lm.psf(pupil, 21, 1e-6, method=lm.Polychromatic(WAVES, WEIGHTS, lm.Hankel()))


@pytest.mark.parametrize(
    ("reference", "waves", "pixel"),
    [
        (700e-9, (400e-9, 550e-9, 700e-9), 6.3 * 400e-9),
        (850e-9, (450e-9, 850e-9), 6.1 * 450e-9),
        (1000e-9, (400e-9,), 5.0 * 400e-9),
        (2000e-9, (400e-9,), 5.0 * 400e-9),
    ],
)
@pytest.mark.parametrize("center", [None, (3.3, 5.1)])
@pytest.mark.parametrize("integrate", [True, False])
def test_the_bound_holds_however_far_the_spectrum_is_from_the_reference(reference, waves, pixel, center, integrate):
    pupil = lm.Pupil(lm.Wavefront(2.0), wavelength=reference, f_number=2.0)
    asked = {"integrate": integrate, "center": center, "dtype": "float64"}
    answer = lm.psf(pupil, 9, 2.0 * pixel, method=lm.Polychromatic(waves, [1] * len(waves)), **asked)
    exact = np.zeros((9, 9))
    for wave in waves:
        part = lm.Pupil(reference / wave * lm.Wavefront(2.0), wavelength=wave, f_number=2.0)
        exact += lm.psf(part, 9, 2.0 * pixel, method=lm.Hankel(1e-11), **asked).values / len(waves)
    assert np.abs(answer.values - exact).max() / exact.max() <= answer.error_bound <= 1e-6 + 2.0**-53


def test_the_energy_of_white_light_within_any_radius_is_that_of_its_parts():
    pupil = lm.Pupil(wavelength=550e-9, f_number=2.8)
    waves = [400e-9, 550e-9, 700e-9]
    answer = lm.psf(pupil, 33, 1e-6, method=lm.Polychromatic(waves, [1, 1, 1]))
    for radius in (20e-6, 200e-6, 1e-3):
        v = np.pi * radius / (np.array(waves) * 2.8)
        exact = np.mean(1.0 - j0(v) ** 2 - j1(v) ** 2)
        assert answer.encircled_energy(radius) == pytest.approx(exact, abs=1e-7)
    far = lm.psf(lm.Pupil(wavelength=1e-6, f_number=2.8), 257, 1e-6, method=lm.Polychromatic([400e-9], [1]))
    alone = lm.psf(lm.Pupil(wavelength=400e-9, f_number=2.8), 257, 1e-6)
    assert far.energy == pytest.approx(alone.energy, abs=1e-7)
    assert far.fwhm() == pytest.approx(alone.fwhm(), rel=1e-7)
    assert far.energy_diameter(0.9) == pytest.approx(alone.energy_diameter(0.9), rel=1e-6)


def test_white_light_of_any_aperture_takes_the_method_of_each_wavelength():
    pupil = lm.Pupil(lm.Wavefront(1.0), spider=lm.Spider.equal(4, width=0.1), wavelength=550e-9, f_number=4.0)
    answer = lm.psf(pupil, (9, 8), 2e-6, method=lm.Polychromatic(WAVES, WEIGHTS))
    exact = np.zeros((9, 8))
    for wave, weight in zip(WAVES, WEIGHTS, strict=True):
        part = lm.Pupil(550e-9 / wave * lm.Wavefront(1.0), spider=pupil.spider, wavelength=wave, f_number=4.0)
        exact += 0.25 * weight * lm.psf(part, (9, 8), 2e-6, dtype="float64").values
    assert lm.peak_error(answer, exact) < 1e-6
    assert answer.error_bound is None
    with pytest.raises(ValueError, match="Polychromatic sums NijboerZernike, which supports plain discs and annuli"):
        lm.psf(pupil, 9, 2e-6, method=lm.Polychromatic(WAVES, WEIGHTS, lm.NijboerZernike()))


def test_a_sum_dimmer_than_its_parts_together_is_still_within_the_tolerance():
    # A ring for each colour, far from each other and from the window.
    pupil = lm.Pupil(lm.Wavefront(40.0), wavelength=1e-6, f_number=2.0)
    method = lm.Polychromatic([400e-9, 1e-6, 5e-6], [1, 1, 1], lm.NijboerZernike(1e-7))
    answer = lm.psf(pupil, 33, 2e-6, method=method, dtype="float64", center=(300.0, 200.0), integrate=False)
    assert answer.error_bound <= 1e-7 + 2.0**-53
