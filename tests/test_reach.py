"""Far from the axis: the cost is that of what is asked, and there is a limit, told in what the user gave."""

from __future__ import annotations

import time

import mpmath
import numpy as np
import pytest
from scipy.special import j0, j1

import lommel as lm
from lommel import _core
from lommel.methods import Hankel, NijboerZernike
from lommel.paper import ClosedForm
from lommel.special.legendre import gauss_legendre

PLAIN = lm.Pupil(lm.Wavefront(1.0))
COMA = lm.Pupil(lm.Wavefront(1.0, nonradial={(3, 1): 0.5}))
METRES = lm.Pupil(lm.Wavefront(1.0), wavelength=550e-9, f_number=2.0)


@pytest.mark.parametrize("obscuration", [0.0, 0.4])
def test_far_radii_are_right_alone_and_in_a_crowd(obscuration):
    pupil = lm.Pupil(lm.Wavefront(2.0, 1.0), obscuration=obscuration)
    method = NijboerZernike(1e-9)
    crowd = np.linspace(5000.0, 5010.0, 300)
    field, bound = method.evaluate(pupil, crowd)
    for i in (0, 151, 299):
        alone, own = method.evaluate(pupil, crowd[i : i + 1])
        truth = Hankel().field(pupil, crowd[i])
        assert abs(alone[0, 0] - truth) <= own[0]
        assert abs(field[0, i] - truth) <= bound[0]


def test_far_values_of_an_aperture_in_focus_are_those_of_airy():
    v = np.array([50.0, 4000.0, 4100.0, 3e4, 3e5, 1e6])
    values = NijboerZernike(1e-12).field(lm.Pupil(), v)
    # By its size: light is weak there.
    assert np.abs(values - 2 * j1(v) / v).max() < 1e-15
    assert np.abs(values[3:] - 2 * j1(v[3:]) / v[3:]).max() < 1e-11 * 2e-7


def test_bessel_functions_of_far_arguments_and_many_orders():
    for v in (100.0, 1234.5, 99_999.25, 1e6):
        found = _core.bessel_sequence(np.array([v]), int(0.5 * v) if v < 2000 else 900)[0]
        for n in {0, 1, 2, 17, len(found) // 2, len(found) - 1}:
            with mpmath.workdps(40):
                assert abs(found[n] - float(mpmath.besselj(n, mpmath.mpf(v)))) < 8 * 2.0**-53


QUICK = {
    "samples": lambda x: lm.psf(PLAIN, 5, x),
    "coma": lambda x: lm.psf(COMA, 5, x),
    "profile": lambda x: lm.psf(PLAIN, 5, 1.0).profile(x),
    "encircled": lambda x: lm.psf(PLAIN, 5, 1.0).encircled_energy(x),
    "ensquared": lambda x: lm.psf(PLAIN, 5, 1.0).ensquared_energy(x),
    "center": lambda x: lm.psf(COMA, 5, 1.0, center=(x, 0.0)),
    "closed form": lambda x: lm.psf(PLAIN, 5, x, method="closed-form"),
    "tuned": lambda x: lm.psf(PLAIN, 5, x, method="tuned-closed-form"),
}


@pytest.mark.parametrize("asked", QUICK)
def test_a_few_pixels_cost_little_wherever_they_are(asked):
    QUICK[asked](30.0)
    start = time.thread_time()
    for x in (1_000.0, 3_000.0, 10_000.0, 20_000.0):
        QUICK[asked](x)
    assert time.thread_time() - start < 1.0


def test_a_long_row_of_far_pixels_costs_what_its_pixels_do():
    start = time.thread_time()
    answer = lm.psf(PLAIN, (1, 16384), 30.0, threads=1)
    assert time.thread_time() - start < 3.0
    v = 30.0 * np.pi * 8000
    field = Hankel().field(PLAIN, [30.0 * np.pi * 200])[0]
    near = float(answer.values[0, 8192 + 200] / answer.scale)
    assert abs(near - abs(field) ** 2) <= answer.error_bound
    assert answer.values[0, 8192 + 8000] / answer.scale < 8 / v**3


REFUSED = {
    "pixel=1e\\+06 with shape=\\(5, 5\\) reaches v = 8.89e\\+06": lambda: lm.psf(PLAIN, 5, 1e6),
    "pixel=0.1 with shape=\\(65, 65\\) reaches .* the limit is 1e\\+06, here 0.35 m": lambda: lm.psf(METRES, 65, 0.1),
    "around center=\\(900000.0, 0.0\\) reaches v": lambda: lm.psf(PLAIN, 5, 1.0, center=(9e5, 0.0)),
    "radius=1e\\+25 reaches v = 3.14e\\+25": lambda: lm.psf(PLAIN, 5, 1.0).profile(1e25),
    "radius=1e\\+300 reaches": lambda: lm.psf(PLAIN, 5, 1.0).encircled_energy([1.0, 1e300]),
    "half_width=1e\\+300 reaches": lambda: lm.psf(PLAIN, 5, 1.0).ensquared_energy(1e300),
    "radius=1e\\+30 reaches": lambda: lm.best_focus(PLAIN, 1e30),
    "v must be at most 1e\\+06, got 1e\\+300": lambda: NijboerZernike().field(PLAIN, [1e300]),
    "pixel=1e\\+300 .* reaches": lambda: ClosedForm.best(PLAIN, 5, 1e300),
    "pixel must be from 1e-4 to 1e6": lambda: lm.psf(PLAIN, 5, 1e300),
    "quadrature nodes, more than the limit of 16000": lambda: Hankel().field(PLAIN, [9e4]),
    "30000 nodes, more than 20000": lambda: gauss_legendre(30_000),
}


@pytest.mark.parametrize("message", REFUSED)
def test_what_is_out_of_reach_is_refused_at_once_in_the_terms_of_the_question(message):
    with pytest.raises(ValueError, match=message):
        REFUSED[message]()  # and imports what it needs
    start = time.thread_time()
    with pytest.raises(ValueError, match=message):
        REFUSED[message]()
    assert time.thread_time() - start < 0.5


@pytest.mark.parametrize("v", [1.0001e6, 1e10, 1e25, 1e300, np.inf, np.nan])
def test_the_core_itself_refuses_what_no_integer_holds(v):
    one, at = np.array([[1.0]]), np.array([v])
    for call in (
        lambda: _core.field((one, 0.0, np.zeros(1)), at, 1e-6),
        lambda: _core.profile((one, 0.3, np.zeros(1)), at, 1e-6),
        lambda: _core.bessel_sequence(at, 5),
    ):
        with pytest.raises(ValueError, match="v"):
            call()


def test_light_within_a_far_circle_is_that_of_rayleigh():
    answer, far = lm.psf(lm.Pupil(), 5, 1.0), np.array([40.0, 900.0, 30_000.0])
    v = np.pi * far
    assert np.abs(answer.encircled_energy(far) - (1 - j0(v) ** 2 - j1(v) ** 2)).max() < 1e-8
