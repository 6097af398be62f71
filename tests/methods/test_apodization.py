"""Gaussian illumination: a beam that the aperture clips more or less."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import lommel as lm
from lommel.methods import METHODS

V = np.linspace(0.0, 60.0, 241)


def test_a_beam_much_narrower_than_the_aperture_stays_gaussian():
    # int_0^inf exp(-g t) J0(v sqrt t) dt = exp(-v^2 / 4g) / g; the rim cuts off exp(-g).
    g = 30.0
    pupil = lm.Pupil(apodization=g)
    exact = np.exp(-(V**2) / (4 * g)) / g
    for method in (lm.NijboerZernike(1e-10), lm.Hankel()):
        assert np.abs(method.field(pupil, V) - exact).max() <= np.exp(-g) / g + 1e-14


def test_defocus_widens_a_gaussian_beam_as_the_formula_says():
    # With exp(2i C t) the width g becomes g - 2i C.
    g, c = 30.0, 12.0
    width = g - 2j * c
    exact = np.exp(-(V**2) / (4 * width)) / width
    field = lm.NijboerZernike(1e-10).field(lm.Pupil(lm.Wavefront(c), apodization=g), V)
    assert np.abs(field - exact).max() <= np.exp(-g) / g + 1e-13


@given(st.floats(-80, 80), st.floats(-80, 80), st.floats(0, 20), st.sampled_from([0.0, 0.33, 0.8]), st.floats(3, 8))
def test_the_contract_holds_for_apodized_pupils(defocus, spherical, apodization, obscuration, digits):
    pupil = lm.Pupil(lm.Wavefront(defocus, spherical), obscuration=obscuration, apodization=apodization)
    # Where next to no light passes, rounding may exceed a small tolerance, and is refused.
    assume(pupil.amplitude > 1e-3)
    tol = 10.0**-digits
    answer = lm.psf(pupil, (21, 90), 0.4, method=lm.NijboerZernike(tol), dtype=np.float64)
    exact = lm.psf(pupil, (21, 90), 0.4, method=lm.Hankel())
    assert lm.peak_error(answer, exact) <= answer.error_bound <= tol


def test_a_tolerance_below_the_rounding_of_a_nearly_dark_pupil_is_refused():
    dark = lm.Pupil(lm.Wavefront(), obscuration=0.9, apodization=40.0)
    with pytest.raises(lm.ToleranceError, match="tol=1e-08 cannot be met"):
        lm.psf(dark, 33, 0.4, method=lm.NijboerZernike(1e-8))


def test_a_stack_of_apodized_pupils_keeps_the_contract():
    stack = lm.Pupil(lm.Wavefront(np.linspace(-20, 20, 33)), apodization=1.5)
    answer = lm.psf(stack, 33, 0.5, dtype=np.float64)
    for i in (0, 7, 32):
        exact = lm.psf(stack[i], 33, 0.5, method=lm.Hankel())
        assert lm.peak_error(answer[i], exact) <= answer.error_bound


@pytest.mark.parametrize("obscuration", [0.0, 0.4])
@pytest.mark.parametrize("apodization", [1e-13, 0.5, 3.0])
def test_light_is_counted_as_it_passes(apodization, obscuration):
    pupil = lm.Pupil(lm.Wavefront(2.0), obscuration=obscuration, apodization=apodization)
    t = np.linspace(obscuration**2, 1.0, 20_001)
    amplitude = np.exp(-apodization * t)
    assert pupil.amplitude == pytest.approx(np.trapezoid(amplitude, t), rel=1e-8)
    assert pupil.transmission == pytest.approx(np.trapezoid(amplitude**2, t), rel=1e-8)
    answer = lm.psf(pupil, 301, 0.5, dtype=np.float64)
    assert answer.energy == pytest.approx(answer.values.sum(), abs=3e-4)
    assert 0.97 < answer.energy < 1.0
    perfect = lm.psf(pupil.unaberrated(), 9, 0.5, normalize="strehl", dtype=np.float64)
    assert perfect.values.max() == pytest.approx(1.0, abs=1e-6)
    assert perfect.strehl == pytest.approx(1.0, abs=1e-6)


def test_a_wide_beam_is_uniform_illumination():
    uniform = lm.psf(lm.Pupil(lm.Wavefront(7.0, 3.0)), 33, 0.5, dtype=np.float64)
    wide = lm.psf(lm.Pupil(lm.Wavefront(7.0, 3.0), apodization=1e-9), 33, 0.5, dtype=np.float64)
    assert lm.peak_error(wide, uniform) < 1e-8


def test_derivatives_of_apodized_pupils_are_the_limits_of_differences():
    def at(defocus: float, **more: object) -> lm.PSF:
        pupil = lm.Pupil(lm.Wavefront(defocus, 4.0), apodization=2.0, obscuration=0.2)
        return lm.psf(pupil, 31, 0.5, method=lm.NijboerZernike(1e-9), normalize="strehl", **more)

    h, answer = 1e-4, at(6.0, derivatives=("defocus",))
    difference = (at(6.0 + h).values - at(6.0 - h).values) / (2 * h)
    assert np.abs(answer.derivatives["defocus"] - difference).max() < 1e-5 * answer.values.max()


@pytest.mark.parametrize("name", METHODS)
def test_methods_for_uniform_illumination_refuse_any_other(name):
    kind = METHODS[name]
    lens = lm.Lens(focal_length=0.05, f_number=8.0, wavelength=5e-7)
    pupil = lm.Pupil(wavelength=5e-7, f_number=8.0, apodization=1.0, geometry=lens.pupil().geometry)
    if kind.apodized:
        every = (lm.NijboerZernike, lm.Hankel, lm.ChordalGauss, lm.Fraunhofer, lm.MatrixFourier, lm.NonuniformFFT)
        every += (lm.HuygensFresnel,)
        assert kind in every
        assert lm.psf(pupil, 5, 1e-6, method=kind()).values.shape == (5, 5)
    else:
        with pytest.raises(ValueError, match=f"{kind.__name__} supports uniform illumination only"):
            lm.psf(pupil, 5, 1e-6, method=kind())


def test_a_spectrum_can_be_apodized_if_its_method_can(tmp_path):
    pupil = lm.Pupil(wavelength=5e-7, f_number=8.0, apodization=1.0)
    answer = lm.psf(pupil, 9, 1e-6, method=lm.Polychromatic([5e-7, 6e-7], [1, 1]), normalize="strehl")
    assert answer.strehl == pytest.approx(1.0, abs=2e-6)
    answer.save(tmp_path / "a.npy")
    assert lm.PSF.load(tmp_path / "a.npy").pupil.apodization == 1.0
    with pytest.raises(ValueError, match="uniform illumination only"):
        lm.psf(pupil, 9, 1e-6, method=lm.Polychromatic([5e-7], [1], lm.LommelSeries()))


@pytest.mark.parametrize("value", [-1.0, np.nan, 101.0, np.inf])
def test_an_apodization_out_of_range_is_refused(value):
    with pytest.raises(ValueError, match="apodization must be"):
        lm.Pupil(apodization=value)
