"""What is said about a lens whose wavefront depends on the direction, against exact values."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.special import j1

import lommel as lm
from lommel import report


@given(st.floats(0.01, 30.0), st.floats(-3, 3), st.sampled_from([0.0, 0.4]))
def test_the_strehl_ratio_of_a_tilt_is_the_airy_pattern_beside_its_middle(tilt, angle, eps):
    wavefront = lm.Wavefront(nonradial={(1, 1): tilt}).rotated(angle)
    airy = 2 * j1(tilt) / tilt - (2 * eps * j1(eps * tilt) / tilt if eps else 0.0)
    expected = (airy / (1 - eps**2)) ** 2
    assert report.on_axis(lm.Pupil(wavefront, obscuration=eps)) == pytest.approx(expected, abs=1e-9)


def test_a_vanishing_term_changes_no_strehl_ratio():
    radial = lm.Wavefront(7.0, -3.0)
    tiny = radial + lm.Wavefront(nonradial={(3, 1): 1e-12})
    for eps in (0.0, 0.3):
        one, two = (report.on_axis(lm.Pupil(w, obscuration=eps)) for w in (radial, tiny))
        assert one == pytest.approx(two, abs=1e-9)


def test_a_small_aberration_of_any_kind_costs_its_variance():
    rng = np.random.default_rng(3)
    terms = {(n, m): 0.01 * rng.normal() for n in range(1, 7) for m in range(-n, n + 1, 2)}
    variance = sum(c**2 for c in terms.values())
    strehl = report.on_axis(lm.Pupil(lm.Wavefront.zernike(terms)))
    assert 1.0 - strehl == pytest.approx(variance, rel=0.01)


def test_a_phase_that_turns_too_often_is_told():
    pupil = lm.Pupil(lm.Wavefront(1e6, nonradial={(3, 1): 1.0}))
    with pytest.raises(lm.ToleranceError, match="turns too often"):
        report.on_axis(pupil)
    assert math.isfinite(report.on_axis(lm.Pupil(lm.Wavefront(500.0, nonradial={(3, 1): 1.0}))))
