"""The growth, the roundings and the integrals of the amplitude, a second time: mpmath, docs/certificate.md 5."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import lommel as lm
from core_tests import _core_tests
from log_amplitudes import log_amplitude

few = settings(max_examples=25)
# g_0, g_1, ...: of every sign, up to the ten powers that there may be.
exponents = st.lists(st.floats(-2.0, 2.0), min_size=1, max_size=11)
shares = st.floats(0.05, 1.0)


def terms(powers, cosh=(), t=(), obscuration=0.0, raised=1.0, area=1.0):
    arrays = (np.array(x, dtype=float) for x in (powers, cosh, t))
    return _core_tests.amplitude_bounds(*arrays, obscuration, raised, area)


def exponent(powers, t):
    return sum(mp.mpf(g) * t**k for k, g in enumerate(powers))


def mean(powers):
    """Return the first Chebyshev coefficient: the mean of t^k over the angle is C(2k, k) / 4^k."""
    return sum(g * mp.binomial(2 * k, k) / mp.mpf(4) ** k for k, g in enumerate(powers))


@few
@given(exponents, st.floats(1.0, 30.0), st.floats(0.5, 2.0), shares)
@example([0.0, 3.0], 4.0, 1.0, 1.0)
def test_growth_and_roundings(powers, cosh, raised, area):
    found = terms(powers, [cosh], [0.0, 0.4, 1.0], raised=raised, area=area)
    made = [mp.mpf(g) * raised * mp.mpf(area) ** k for k, g in enumerate(powers)]
    size = 1 + sum(abs(g) * mp.mpf(cosh) ** k for k, g in enumerate(made))
    assert abs(found["growth"][0] - log_amplitude(made, mp.mpf(cosh))) <= 1e-12 * size
    sensitivity = sum((3 * k + 1) * abs(g) for k, g in enumerate(made))
    assert found["sensitivity"] == pytest.approx(float(sensitivity), rel=1e-12, abs=1e-300)
    for t, value in zip((0.0, 0.4, 1.0), found["values"], strict=True):
        assert value == pytest.approx(float(mp.exp(-exponent(made, mp.mpf(t)))), rel=1e-13)
    first = mean(made)
    size = log_amplitude(made, mp.mpf(1)) + first + abs(first)
    assert found["size"] == pytest.approx(float(size), rel=1e-12, abs=1e-13)


@few
@given(exponents, st.floats(0.01, 1.5))
def test_nothing_grows_faster_on_any_of_the_curves(powers, b):
    """On the ellipse itself, on the chords of the disk, and on the ellipse around what an obscuration leaves."""
    angle, cosh = np.linspace(0.0, math.pi, 301), math.cosh(2 * b)
    ellipse = 0.5 + 0.5 * np.cos(angle + 2j * b)
    eta = np.linspace(-1.0, 1.0, 11)[:, None]
    chords = np.cos(angle + 1j * b) ** 2 + eta**2 * np.sin(angle + 1j * b) ** 2
    bound = terms(powers, [cosh])["growth"][0]
    rounding = 1e-13 * sum(abs(g) * cosh**k for k, g in enumerate(powers)) + 1e-13
    for t in (ellipse, chords):
        assert (-np.polynomial.polynomial.polyval(t, powers).real).max() <= bound + rounding
    made, low = lm.Apodization(tuple(0.5 * g for g in powers[1:])), 0.3
    part = low + (1.0 - low) * ellipse
    assert (-made.exponent_at(part).real).max() <= float(made.growth(np.array(cosh), low)) + rounding
    assert made.growth(np.array(cosh)) == pytest.approx(terms(made.exponent, [cosh])["growth"][0], abs=rounding)


@pytest.mark.parametrize("k", [1, 2, 5, 10])
def test_the_growth_is_reached_by_every_chebyshev_polynomial(k):
    powers = (
        -np.polynomial.chebyshev.Chebyshev.basis(k, domain=[0, 1])
        .convert(kind=np.polynomial.Polynomial, domain=[-1, 1])
        .coef
    )
    for cosh in (1.0, 1.1, 3.0):
        found = terms(powers, [cosh])["growth"][0]
        assert found == pytest.approx(math.cosh(k * math.acosh(cosh)), rel=1e-9)


@few
@given(exponents, st.sampled_from([0.0, 0.3, 0.9]))
@example([0.0], 0.4)
@example([0.0, 1e-9], 0.4)
@example([0.0, -1e-6], 0.4)
@example([0.0, -1e-310], 0.9)
@example([0.7, 2.0], 0.4)
@example([0.7, -0.7], 0.0)
def test_the_peak_without_aberration(powers, obscuration):
    """A closed form or a good estimate; what serves as the largest |U| is not below the true one, nor far above."""
    powers = [0.5 * g for g in powers]
    lowest = min(float(exponent(powers, mp.mpf(j) / 200)) for j in range(201))
    powers[0] -= min(lowest, 0.0) - 1e-3  # at most 1, as all pupils are
    exact = float(mp.quad(lambda t: mp.exp(-exponent(powers, t)), [mp.mpf(obscuration) ** 2, 1]))
    found = terms(powers, obscuration=obscuration)
    assert found["integral"] == pytest.approx(exact, rel=1e-6)
    assert found["passive"]
    assert exact * (1 - 1e-14) <= found["area"] <= min(1.0 - obscuration**2, exact * (1 + 1e-6)) * (1 + 1e-14)


def test_what_is_brighter_than_1_is_seen():
    assert not terms([0.0, -1e-3])["passive"]
    assert not terms([0.2, -1.0, 1.0])["passive"]
    assert terms([0.25, -1.0, 1.0])["passive"]
