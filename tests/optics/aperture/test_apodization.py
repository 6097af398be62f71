"""Amplitudes across the pupil: their largest value, the powers of cosines, integrals, and what is no amplitude."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import lommel as lm

T = np.linspace(0.0, 1.0, 4001)
amplitudes = st.lists(st.floats(-4.0, 4.0), max_size=8).map(lm.Apodization)


@given(amplitudes)
def test_the_largest_value_is_1_wherever_it_is(light):
    largest = light.value(np.sqrt(T)).max()
    # A maximum between two points of the lattice is missed by the curvature.
    assert 1.0 - 1e-4 <= largest <= 1.0 + 1e-15
    assert np.log(light.value(np.sqrt(T))) == pytest.approx(
        -light.exponent[0] - sum(g * T**k for k, g in enumerate(light.powers, 1)), abs=1e-12
    )


@settings(max_examples=60)
@given(st.floats(0.01, 0.97), st.floats(-6.0, 6.0).filter(lambda p: abs(p) > 0.01))
def test_what_the_powers_leave_of_a_cosine_is_bounded(sine, power):
    light = lm.Apodization.cosine(sine, power)
    with mpmath.workdps(30):
        square = mpmath.mpf(sine) ** 2
        exact = [float(mpmath.mpf(power) / 2 * mpmath.log(1 - square * mpmath.mpf(t))) for t in T[::40]]
    # But for a constant factor: half of the range of the difference.
    missed = 0.5 * np.ptp(np.log(light.value(np.sqrt(T[::40]))) - exact)
    rounding = 1e-14 * (1.0 + np.abs(light.powers).sum())
    assert missed <= light.error + rounding
    assert light.error <= 3.0 * missed + 2.0 * rounding
    assert light.value([0.0, 1.0][power < 0]) == pytest.approx(1.0, abs=1e-13 * light.slope + 1e-15)


@given(st.dictionaries(st.sampled_from([2, 4, 6, 8]), st.floats(-0.5, 0.5).filter(lambda b: abs(b) > 1e-3)))
def test_radial_terms_are_zernike_polynomials_of_the_logarithm(terms):
    light = lm.Apodization.zernike(terms)
    rho = np.linspace(0.0, 1.0, 21)
    radial = {2: 2 * rho**2 - 1, 4: 6 * rho**4 - 6 * rho**2 + 1, 6: 20 * rho**6 - 30 * rho**4 + 12 * rho**2 - 1,
              8: 70 * rho**8 - 140 * rho**6 + 90 * rho**4 - 20 * rho**2 + 1}  # fmt: skip
    exponent = sum((b * math.sqrt(n + 1.0) * radial[n] for n, b in terms.items()), np.zeros(21))
    off = np.log(light.value(rho)) - exponent
    assert np.ptp(off) < 1e-11
    again = light.to_zernike()
    assert all(again.get(n, 0.0) == pytest.approx(b, abs=1e-11) for n, b in terms.items())
    assert all(abs(b) < 1e-11 for n, b in again.items() if n not in terms)


@given(amplitudes, st.sampled_from([0.0, 0.3, 0.9]), st.sampled_from([1.0, 2.0]))
def test_integrals_are_those_of_quadrature(light, obscuration, power):
    nodes, weights = np.polynomial.legendre.leggauss(100)
    low = obscuration**2
    t = low + (1.0 - low) * 0.5 * (nodes + 1.0)
    exact = 0.5 * (1.0 - low) * weights @ light.at(t) ** power
    assert light.integral(obscuration, power) == pytest.approx(exact, rel=1e-12)


@given(amplitudes, st.floats(0.1, 1.0))
def test_the_middle_of_an_aperture_has_the_amplitude_of_its_radii(light, ratio):
    rho = np.linspace(0.0, 1.0, 11)
    inner = light.scaled(ratio).value(rho)
    outer = light.value(ratio * rho)
    assert inner / inner[0] == pytest.approx(outer / outer[0], rel=1e-12)


def test_a_number_stays_a_number_and_means_a_gaussian(tmp_path):
    pupil = lm.Pupil(apodization=2)
    assert type(pupil.apodization) is float
    assert pupil.apodization == 2.0
    assert pupil.illumination == lm.Apodization.gaussian(2.0)
    # As files have had it.
    assert pupil.to_dict()["apodization"] == 2.0
    for apodization in (2.0, lm.Apodization([1.0, -0.5])):
        answer = lm.psf(lm.Pupil(apodization=apodization), 5, 0.5)
        answer.save(tmp_path / "a.npz")
        assert lm.PSF.load(tmp_path / "a.npz").pupil == answer.pupil


@pytest.mark.parametrize(("sine", "power"), [(0.95, 0.5), (0.95, -1.0), (0.3, 2.0), (0.02, 0.5)])
def test_the_error_of_a_cosine_is_that_of_its_tail_and_of_roundings(sine, power):
    found = lm.Apodization.cosine(sine, power)
    n = len(found.powers)
    cosine = math.sqrt(1.0 - sine**2)
    q = (1.0 - cosine) / (1.0 + cosine)
    tail = abs(power) * q ** (n + 1) / ((n + 1) * (1.0 - q))
    constant = sum((-1) ** k * power * q**k / k for k in range(1, n + 1))
    sizes = abs(constant) + sum(map(abs, found.powers))
    assert found.error == pytest.approx(math.expm1(tail + 2.0**-47 * sizes), rel=1e-6)


def test_errors_are_kept_and_are_not_negative():
    assert lm.Apodization((1.0,)).error == 0.0
    assert lm.Apodization((1.0, 2.0), error=0.25).scaled(0.5) == lm.Apodization((0.25, 0.125), error=0.25)
    assert lm.Apodization.zernike({2: 0.5}).powers == pytest.approx((-math.sqrt(3.0),), rel=1e-12)
    with pytest.raises(ValueError, match="error must be"):
        lm.Apodization((1.0,), error=-1e-300)
    with pytest.raises(TypeError):
        lm.Apodization((1.0,), 0.25)
