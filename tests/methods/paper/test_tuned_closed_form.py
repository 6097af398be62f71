"""The closed form, finished: within its bound, and its bound within the tolerance."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm
from core_tests import _core_tests
from lommel.paper import TunedClosedForm
from lommel.special.erf import fresnel_auxiliary

CASES = [(0.0, 0.0), (1.0, 0.0), (10.0, 0.0), (50.0, 0.0), (-50.0, 0.0), (20.0, 10.0), (-50.0, 50.0), (0.0, 200.0)]


@pytest.mark.parametrize("obscuration", [0.0, 0.33])
@pytest.mark.parametrize(("defocus", "spherical"), CASES)
def test_it_reaches_1e_4_of_the_peak_and_proves_it(defocus, spherical, obscuration):
    pupil = lm.Pupil(lm.Wavefront(defocus, spherical), obscuration=obscuration)
    for shape in (97, 5):
        answer = lm.psf(pupil, shape, 0.5, method="tuned-closed-form", dtype=np.float64)
        exact = lm.psf(pupil, shape, 0.5, method="hankel")
        assert lm.peak_error(answer, exact) <= answer.error_bound <= 1.0001e-4


@given(st.floats(-60, 60), st.floats(-60, 60), st.floats(2, 4.5), st.floats(0.1, 3))
def test_the_contract_holds_for_any_pupil_and_tolerance(defocus, spherical, digits, pixel):
    tol, pupil = 10.0**-digits, lm.Pupil(lm.Wavefront(defocus, spherical))
    answer = lm.psf(pupil, (3, 17), pixel, method=TunedClosedForm(tol), dtype=np.float64)
    exact = lm.psf(pupil, (3, 17), pixel, method="hankel")
    assert lm.peak_error(answer, exact) <= answer.error_bound <= tol * (1 + 1e-9)


def test_what_it_cannot_prove_it_says():
    with pytest.raises(lm.ToleranceError, match="tol=1e-06 cannot be met"):
        lm.psf(lm.Pupil(lm.Wavefront(200.0)), 65, 0.5, method=TunedClosedForm(1e-6))
    with pytest.raises(ValueError, match="quadratic phases, more than the limit of 4096"):
        lm.psf(lm.Pupil(lm.Wavefront(0.0, 3000.0)), 9, 0.5, method=TunedClosedForm(1e-6))


def test_the_kernel_is_the_fresnel_integral_to_rounding():
    """By a polynomial, and from s = 8 on by the asymptotic series."""
    s = np.concatenate([np.linspace(0.0, 12.0, 3001), np.geomspace(12.0, 1e8, 500)])
    assert np.abs(_core_tests.fresnel_auxiliary(s) - fresnel_auxiliary(s)).max() <= 2e-15
