"""Isotropic blurs as mixtures of Gaussians, beside their transfer functions."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel.blur.mixtures import OUTER, Shape, isotropic, turbulence


@pytest.mark.parametrize(("outer", "terms"), [*((outer, 6) for outer in OUTER), (None, 3), (15.0, 8), (2.0, 8)])
def test_mixtures_are_within_their_error_of_the_transfer_function(outer, terms):
    made = turbulence(outer, terms)
    q = np.linspace(0.0, 20.0, 9001)
    exact = lm.Seeing(1.0, outer_scale=outer).transfer(q)
    found = np.exp(-np.multiply.outer(q * q, made.rates)) @ made.weights
    assert np.abs(found - exact).max() < 1.05 * made.error
    assert made.error < {3: 3e-3, 6: 3e-4, 8: 5e-4}[terms]
    assert (made.weights > 0.0).all()
    assert made.weights.sum() == pytest.approx(1.0, abs=1e-6)


def test_the_width_of_seeing_is_its_fwhm():
    pixel, air = 2e-6, lm.Seeing.from_fwhm(5e-6, 1.0, 600e-9)
    shape = Shape.turbulent()
    variances = shape.variances(np.array([(5e-6 / pixel / 2.354820) ** 2, 0.09]))
    f = np.linspace(0.0, 2e5, 200)
    found = np.exp(-2.0 * np.multiply.outer((math.pi * pixel * f) ** 2, variances)) @ shape.weights
    exact = air.transfer(f, wavelength=600e-9) * lm.Jitter(0.3 * pixel).transfer(f)
    np.testing.assert_allclose(found, exact, atol=2e-4)


def test_known_blurs_are_multiplied():
    several = lm.Seeing(0.1, 2.0, 500e-9, 12.0), lm.Jitter(3e-6), lm.ChargeDiffusion(2e-6)
    shape = Shape.known(several, 2e-6, 700e-9)
    f = np.linspace(0.0, 2e5, 200)
    found = np.exp(-2.0 * np.multiply.outer((math.pi * 2e-6 * f) ** 2, shape.fixed)) @ shape.weights
    exact = np.prod([each.transfer(f, wavelength=700e-9) for each in several], axis=0)
    np.testing.assert_allclose(found, exact, atol=2e-4)
    assert shape.unknown == 0


def test_blurs_along_a_direction_are_not_isotropic():
    several = lm.Jitter(1.0), lm.Jitter(1.0, 2.0), lm.Motion(1.0), lm.Motion(0.0), lm.ChargeDiffusion(1.0)
    assert isotropic(several).tolist() == [True, False, False, True, True]
