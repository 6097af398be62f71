"""Turbulence: its kernel, halos, mixtures of Gaussians, fading, and read-out of samples."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mpmath import mp
from scipy.integrate import quad
from scipy.optimize import brentq

import lommel as lm
from lommel.blur.blurs import FWHM, KOLMOGOROV
from lommel.blur.convolution import Gate, Halo, between, table
from lommel.blur.mixtures import OUTER, BlurProfile, turbulence
from lommel.blur.transfer_integral import FURTHER, Fading

GATE = Gate.of(0.8, 1e-10)
STRONG = Halo((lm.Seeing(0.05),), 1.0, None, GATE)
KINDS = {
    "strong": STRONG,
    "weak": Halo((lm.Seeing(2.0),), 1.0, None, GATE),
    "outer scale": Halo((lm.Seeing(0.2, outer_scale=3.0),), 1.0, None, GATE),
    "two": Halo((lm.Seeing(0.3), lm.Seeing(0.5, outer_scale=10.0)), 1.0, None, GATE),
}


def hankel(r: float, ratio: float) -> float:
    """Return ``(1 / 2 pi) int exp(-3.44 (ratio w / 2)^(5/3)) J0(w r) w dw`` in mpmath."""
    mp.dps = 20
    a = mp.mpf(KOLMOGOROV) * mp.mpf(ratio / 2) ** (mp.mpf(5) / 3)
    ends = [0, *(mp.mpf(k) / 40 for k in range(1, 21))]
    return float(
        mp.quad(
            lambda u: 3 * u**5 * mp.exp(-a * u**5) * mp.besselj(0, u**3 * r), [e ** (mp.mpf(1) / 3) for e in ends]
        )
        / (2 * mp.pi)
    )


@pytest.mark.parametrize("r", [0.0, 7.0, 40.0, 150.0])
def test_the_kernel_is_the_transform_of_fried_s_exponential(r):
    # By w = 0.5 nothing is left of it, and the gate is open.
    assert float(STRONG.at(np.array([r]))[0]) == pytest.approx(hankel(r, 20.0), rel=1e-9, abs=1e-17)


def test_the_width_of_the_image_of_a_star_is_what_monitors_divide_by():
    half = 0.5 * float(STRONG.at(np.zeros(1))[0])
    radius = brentq(lambda r: float(STRONG.at(np.array([r]))[0]) - half, 1.0, 100.0, xtol=1e-9)
    # v = pi r / (lambda N): r0 = D / 20.
    assert 2.0 * radius / np.pi / 20.0 == pytest.approx(FWHM, rel=1e-5)
    air = lm.Seeing.from_fwhm(4.848e-6, focal_length=8.0, wavelength=550e-9)
    assert air.r0 == pytest.approx(FWHM * 550e-9 / 4.848e-6)


@pytest.mark.parametrize("kind", KINDS)
def test_a_table_is_within_its_error_of_the_kernel(kind):
    halo = KINDS[kind]
    filtered, step, off = table(halo, 80.0, 1e-11)
    r = np.linspace(0.0, 80.0, 1003)
    exact = halo.at(r)
    assert np.abs(between(filtered, step, 1e-11, r) - exact).max() <= (off + 1e-15) * exact.max()


@pytest.mark.parametrize(("outer", "terms"), [*((outer, 6) for outer in OUTER), (None, 3), (15.0, 8), (2.0, 8)])
def test_mixtures_are_within_their_error_of_the_transfer_function(outer, terms):
    made = turbulence(outer, terms)
    q = np.linspace(0.0, 20.0, 9001)
    exact = lm.Seeing(1.0, outer_scale=outer).transfer(q)
    found = np.exp(-np.multiply.outer(q * q, made.rates)) @ made.weights
    assert np.abs(found - exact).max() < 1.05 * made.error
    assert made.error < {3: 2.5e-3, 6: 3e-4, 8: 9e-5 if outer == 2.0 else 3.2e-4}[terms]
    assert (made.weights > 0.0).all()
    assert made.weights.sum() == pytest.approx(1.0, abs=1e-6)


def test_the_width_of_seeing_is_its_fwhm():
    pixel, air = 2e-6, lm.Seeing.from_fwhm(5e-6, 1.0, 600e-9)
    shape = BlurProfile.turbulent()
    variances = shape.variances(np.array([(5e-6 / pixel / 2.354820) ** 2, 0.09]))
    f = np.linspace(0.0, 2e5, 200)
    found = np.exp(-2.0 * np.multiply.outer((math.pi * pixel * f) ** 2, variances)) @ shape.weights
    exact = air.transfer(f, wavelength=600e-9) * lm.Jitter(0.3 * pixel).transfer(f)
    np.testing.assert_allclose(found, exact, atol=2e-4)


def test_known_blurs_are_multiplied():
    several = lm.Seeing(0.1, 2.0, 500e-9, 12.0), lm.Jitter(3e-6), lm.Jitter(2e-6)
    shape = BlurProfile.known(several, 2e-6, 700e-9)
    f = np.linspace(0.0, 2e5, 200)
    found = np.exp(-2.0 * np.multiply.outer((math.pi * 2e-6 * f) ** 2, shape.fixed)) @ shape.weights
    exact = np.prod([each.transfer(f, wavelength=700e-9) for each in several], axis=0)
    np.testing.assert_allclose(found, exact, atol=2e-4)
    assert shape.unknown == 0


def test_blur_with_a_direction_has_none():
    assert Fading.of((lm.Motion(1.0),), 1.0, None) is None
    assert Fading.of((lm.Seeing(1.0), lm.Jitter(0.3, 0.2)), 1.0, None) is None
    assert Fading.of((lm.Motion(0.0), lm.Jitter(0.3, 0.3, 0.7)), 1.0, None) is not None


def test_blur_in_any_direction_is_nowhere_above_the_isotropic_one():
    several = (lm.Seeing(0.4), lm.Motion(2.0, 0.7), lm.Jitter(0.6, 0.2, 0.4), lm.Jitter(0.1, 0.5, -0.2))
    fading, rng = Fading.above(several, 1.0, None), np.random.default_rng(5)
    f, angle = rng.uniform(0.0, 2.0, 400), rng.uniform(0.0, 2.0 * np.pi, 400)
    product = np.prod([blur.transfer(f * np.cos(angle), f * np.sin(angle)) for blur in several], axis=0)
    above = fading.at(f)
    assert np.all(np.abs(product) <= above * (1.0 + 1e-12))
    assert np.all(above <= several[0].transfer(f))
    end, left = fading.end(1e-6, FURTHER)
    assert quad(lambda f: float(fading.at(np.array(f))) * f, end, 4.0, limit=400)[0] <= left <= 1e-6
