"""Spectra are weighted sums, whatever else is asked."""

from __future__ import annotations

import numpy as np
import pytest

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
