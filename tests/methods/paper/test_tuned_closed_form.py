"""The closed form, finished: within its bound, and its bound within the tolerance."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm
from core_tests import _core_tests
from lommel import _core
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


@pytest.mark.parametrize("tol", [0.0, 1e-7, 0.1, np.nan])
def test_a_tolerance_out_of_range_is_refused(tol):
    with pytest.raises(ValueError, match="tol must be"):
        TunedClosedForm(tol)


def test_the_kernel_is_the_fresnel_integral_to_rounding():
    """By a polynomial, and from s = 8 on by the asymptotic series."""
    s = np.concatenate([np.linspace(0.0, 12.0, 3001), np.geomspace(12.0, 1e8, 500)])
    assert np.abs(_core_tests.fresnel_auxiliary(s) - fresnel_auxiliary(s)).max() <= 2e-15


def test_the_core_refuses_what_it_cannot_carry():
    two, one, v = np.array([0.0, 1.0]), np.ones((1, 1)), np.linspace(0.0, 5.0, 3)
    start, quadratic, nothing = np.ones(1), np.ones((1, 3), complex), np.zeros(0, complex)
    good = (two, one, one, one + 0j, start, quadratic, 3, 0, nothing, v, 1)

    def fields(given: tuple[object, ...]) -> np.ndarray:
        return _core.closed_form_fields(given[:4], given[4:7], given[7:9], *given[9:])

    assert fields(good).shape == (1, 3)
    for place, value, message in (
        (0, np.ones(1), "one value a piece"),
        (2, np.ones((2, 1)), "as many pupils"),
        (3, np.ones((1, 2), complex), "one value a piece"),
        (4, np.zeros(1), "starts"),
        (4, np.ones(2), "each start"),
        (5, np.ones((1, 2), complex), "each start"),
        (6, 0, "a term of the series"),
        (8, np.ones(1, complex), "two samples"),
        (9, -v, "v must be"),
        (9, np.array([np.nan]), "v must be"),
    ):
        with pytest.raises(ValueError, match=message):
            fields((*good[:place], value, *good[place + 1 :]))
    with pytest.raises(ValueError, match="s must be"):
        _core_tests.fresnel_auxiliary(-np.ones(1))
    with pytest.raises(ValueError, match="b, low and high"):
        _core.chirp_moments(1.0, np.ones(2), np.ones(1), np.ones(2), 0, nothing)
    with pytest.raises(ValueError, match="a piece, and a coefficient"):
        _core.polynomial_fields(np.ones((1, 0, 3), complex), 0.0, 1.0, v, 1)
    with pytest.raises(ValueError, match="width"):
        _core.polynomial_fields(np.ones((1, 1, 3), complex), 0.0, 0.0, v, 1)
