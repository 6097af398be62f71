"""Bad input that would make a wrong number: units, shapes and kinds of objects; and how errors read."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from cases import each
from lommel.measures.errors import mse
from lommel.methods import METHODS

BAD = (ValueError, TypeError)
CAMERA = lm.Lens(focal_length=50e-3, f_number=2.0, focus_distance=2.0, wavelength=500e-9)
PUPIL = CAMERA.pupil(1.9)
SPHERICAL = lm.Pupil(lm.Wavefront(spherical=1.0))
OBJECTIVE = lm.Objective(
    NA=1.4,
    magnification=63,
    immersion=1.518,
    working_distance=0.19e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.33,
)


@each(
    ("call", "told"),
    [
        (lambda: lm.psf(PUPIL, 9, 3.45), "3.45e-6"),
        (lambda: lm.psf(PUPIL, 9, "4 um"), "text with a unit is for files and the command line"),
        (lambda: lm.psf(PUPIL, 9, 1e-6, center=np.zeros((5, 2))), "give tuple(center.T)"),
        (lambda: lm.psf([PUPIL, PUPIL], 9, 0.5), "a stack is one Pupil of a Wavefront whose coefficients are arrays"),
        (lambda: lm.psf(PUPIL, 9, 1e-6, derivatives="defocus"), "got 'defocus'"),
        (lambda: lm.Pupil(wavelength=550, f_number=2.0), "550e-9"),
        (lambda: lm.Pupil(wavelength=0.55, f_number=2.0), "0.55e-6"),
        (lambda: lm.Pupil(wavelength=5e-7), "f_number=None"),
        (lambda: lm.Pupil(f_number=2.0), "wavelength=None"),
        (lambda: lm.Pupil().in_light(5e-7), "wavelength and f_number of the pupil must be given"),
        (lambda: lm.Wavefront([0.0, 1.0], [0.0, 1.0, 2.0]), "must broadcast"),
        (lambda: lm.Wavefront.zernike(np.zeros(12), order="noll"), "such as zip(range(4, 16), coefficients), got"),
        (lambda: lm.Wavefront.zernike({11: 1e308}, order="noll"), "must be finite"),
        (lambda: OBJECTIVE.pupil(depth=-1e-6, z=0.0, wavelength=520e-9), "depth is in metres and must be at least 0"),
        (lambda: OBJECTIVE.pupil(depth=2.0, z=0.0, wavelength=520e-9), "for 2 um give 2e-6, for 2 mm 2e-3"),
        (lambda: OBJECTIVE.pupil(depth=0.0, z=0.0, wavelength=520), "for 520 nm give 520e-9"),
        (lambda: OBJECTIVE.pupil(depth=0.0, z=1e-3, wavelength=520e-9), "must be at most 190 um, where the"),
        (lambda: lm.Layer(1.5, 170), "for 170 um give 170e-6, for 170 mm 170e-3"),
        (lambda: lm.mtf(OBJECTIVE.pupil(depth=0.0, z=0.0, wavelength=520e-9), 0.1), "has no single wavefront"),
        (lambda: lm.psf(lm.Pupil(), 3, 0.5, normalize="emitted"), 'for a lens use "energy"'),
        (lambda: lm.psf(lm.Pupil(wavelength=5e-7, f_number=2.0), 5, 1e-6, method="huygens-fresnel"),
         "HuygensFresnel needs the physical distances"),
        (lambda: mse(np.full((3, 3), 1.7e308), np.ones((3, 3))), "values and reference must not differ so much"),
    ],
)  # fmt: skip
def test_input_that_could_be_misread_is_refused_with_the_way_out(call, told):
    with pytest.raises(BAD) as caught:
        call()
    assert told in str(caught.value)


@each("method", [kind() for kind in METHODS.values()])
@each("defocus", [1e12, 1e300])
def test_a_phase_that_a_method_cannot_carry_is_refused_in_one_short_line(method, defocus):
    pupil = lm.Pupil(lm.Wavefront(defocus), wavelength=5e-7, f_number=2.0, geometry=PUPIL.geometry)
    message = ""
    try:
        assert np.all(np.isfinite(lm.psf(pupil, 3, 1e-6, method=method).values))
    except (ValueError, ArithmeticError) as error:
        message = str(error)
    assert len(message) < 250


def test_errors_of_large_values_are_those_of_small_ones():
    rng = np.random.default_rng(3)
    a, b = rng.random((2, 5, 5))
    for scale in (1e300, 1e-200):
        assert mse(scale * a, scale * b) == pytest.approx(mse(a, b), rel=1e-12)


def test_no_radii_give_no_energies():
    assert lm.psf(SPHERICAL, 3, 0.5).encircled_energy([]).shape == (0,)
    assert lm.measures.energy.encircled(SPHERICAL, []).fraction.shape == (0,)


@each("value", [np.ones((50, 50)), [1.0] * 5000, "x" * 5000, "a\nb", {str(k): k for k in range(999)}, 10**400])
def test_a_message_is_one_line_and_short_whatever_is_given(value):
    for call in (lambda: lm.psf(value, 5, 0.5), lambda: lm.Pupil(obscuration=value), lambda: lm.Spider(0.1, value)):
        with pytest.raises(BAD) as caught:
            call()
        assert len(str(caught.value).splitlines()) == 1
        assert len(str(caught.value)) < 300
