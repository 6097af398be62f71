"""Quadrature over the transfer function of a disc: against closed forms and adaptive quadrature."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import j1

from lommel.methods.pixels.transfer_rule import modulus_rule, transfer_rule


def chords(w: float) -> float:
    """Return the autocorrelation of the chords of the disc, whose integral is 1."""

    def product(turn: float) -> float:
        s = 0.5 * w + (1.0 - 0.5 * w) * math.sin(turn)
        both = max(0.0, 1.0 - s * s) * max(0.0, 1.0 - (s - w) ** 2)
        return math.sqrt(both) * (1.0 - 0.5 * w) * math.cos(turn)

    return 4.0 / math.pi**2 * quad(product, -0.5 * math.pi, 0.5 * math.pi, epsabs=1e-13)[0]


@pytest.mark.parametrize("degree", [2, 32, 64, 128, 256])
def test_waves_have_the_image_of_a_point_as_their_mean(degree):
    """The transform of the transfer function, along one axis, as long as waves are polynomials of the degree."""
    w, weights = transfer_rule(degree)
    assert weights.min() > 0.0
    assert w.size == degree // 2 + 1
    for x in np.linspace(0.1, max(0.1, (2 * degree - 48) / 2.36), 7):
        assert weights @ np.cos(x * w) == pytest.approx((2.0 * j1(x) / x) ** 2, abs=1e-2 if degree == 2 else 2e-14)


def test_powers_have_their_moments():
    w, weights = transfer_rule(4)
    for power in (0, 2, 4, 6, 8):
        expected = 2.0 * quad(lambda x, k=power: x**k * chords(x), 0.0, 2.0, epsabs=1e-12)[0]
        assert weights @ w**power == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("power", [0, 1, 2])
def test_the_mean_of_a_modulus_is_bounded_and_hardly_more(power):
    """Of errors that rise towards the end of the band, as those of filters do."""
    w, weights = modulus_rule(32)
    bound = math.sqrt(weights @ (w**power) ** 2)
    mean = 2.0 * quad(lambda x: x**power * chords(x), 0.0, 2.0, epsabs=1e-12)[0]
    assert mean <= bound <= 1.6 * mean


def test_the_bound_is_reached_by_what_it_is_made_for():
    """By an error proportional to 1 over the weight q, by the constant, which is the integral of m / q."""
    share = 2.0 * quad(lambda x: chords(x) / (1.0 - 0.25 * x * x) ** 2, 0.0, 2.0, epsabs=1e-9)[0]
    w, weights = modulus_rule(32)
    of_q = weights / transfer_rule(34)[1]
    assert of_q == pytest.approx(1.69766 * (1.0 - 0.25 * w * w) ** 2)
    assert 0.0 < 1.69766 - share < 1e-4
