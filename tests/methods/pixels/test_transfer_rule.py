"""What bounds the mean modulus of an error: against closed forms and adaptive quadrature."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import beta

from lommel.core.engine import band_points, transfer_rule


def chords(w: float) -> float:
    """Return the autocorrelation of the chords of the disc, whose integral is 1."""

    def product(turn: float) -> float:
        s = 0.5 * w + (1.0 - 0.5 * w) * math.sin(turn)
        both = max(0.0, 1.0 - s * s) * max(0.0, 1.0 - (s - w) ** 2)
        return math.sqrt(both) * (1.0 - 0.5 * w) * math.cos(turn)

    return 4.0 / math.pi**2 * quad(product, -0.5 * math.pi, 0.5 * math.pi, epsabs=1e-13)[0]


def test_the_autocorrelation_of_chords_is_below_its_majorant():
    w = np.concatenate([np.linspace(0.0, 1.999, 400), 2.0 - np.geomspace(1e-3, 1e-6, 20)])
    m = np.array([chords(each) for each in w])
    most = 16.0 / (3.0 * math.pi**2) * (1.0 - 0.25 * w * w) ** 2
    assert (m <= most * (1.0 + 1e-9)).all()
    assert m[0] == pytest.approx(most[0], rel=1e-12)
    assert 2.0 * quad(chords, 0.0, 2.0, epsabs=1e-11)[0] == pytest.approx(1.0, abs=1e-9)


@pytest.mark.parametrize("degree", [2, 5, 32, 257, 700])
def test_squares_of_polynomials_have_their_integral(degree):
    w, weights = transfer_rule(degree)
    assert weights.min() > 0.0
    assert (np.abs(w) < 2.0).all()
    assert (w > 0.0).all()
    for power in {0, 1, degree // 2, degree}:
        # Of w^(2 p) times (1 - w^2 / 4)^(7 / 2), by Euler's integral.
        exact = 2.0 * beta(power + 0.5, 4.5)
        assert weights @ (0.5 * w) ** (2 * power) == pytest.approx(
            (16.0 / (3.0 * math.pi**2)) ** 2 * math.pi * exact, rel=1e-11
        )


@pytest.mark.parametrize("odd", [False, True])
@pytest.mark.parametrize("reach", [3.0, 20.0, 90.0])
def test_the_bound_is_above_the_mean_modulus_and_not_far(odd, reach):
    rng = np.random.default_rng(4)
    wave = np.sin if odd else np.cos
    x, c = np.linspace(0.0, reach, 24)[odd:], rng.normal(size=24 - odd)
    fine = np.linspace(0.0, 2.0, 4001)
    m = np.interp(fine, at := np.linspace(0.0, 2.0, 401), [chords(each) for each in at])
    w, weights = transfer_rule(band_points(reach).size)
    mean = 2.0 * np.trapezoid(np.abs(wave(np.outer(fine, x)) @ c) * m, fine)
    bound = math.sqrt(float(weights @ (wave(np.outer(w, x)) @ c) ** 2))
    assert mean <= bound <= 2.2 * mean
