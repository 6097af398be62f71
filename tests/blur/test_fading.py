"""The transfer function of isotropic blur off the real axis: below its bound, and what is left beyond a frequency."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mpmath import mp
from scipy.integrate import quad

import lommel as lm
from lommel.blur.blurs import KOLMOGOROV
from lommel.blur.transfer_integral import FURTHER, Fading

KINDS = {
    "kolmogorov": (lm.Seeing(0.05),),
    "weak": (lm.Seeing(3.0), lm.ChargeDiffusion(0.3)),
    "outer scale": (lm.Seeing(0.1, outer_scale=3.0),),
    "short outer scale": (lm.Seeing(0.2, outer_scale=0.3), lm.Jitter(0.2)),
    "two": (lm.Seeing(0.2), lm.Seeing(0.3, outer_scale=20.0)),
}


def transfer(blurs: tuple, x: complex, end: float) -> float:
    """Return the logarithm of the modulus of the transfer function at ``f = end x^3``, in mpmath."""
    total, x = mp.mpf(0), mp.mpc(x)
    for blur in blurs:
        if not isinstance(blur, lm.Seeing):
            total -= mp.re(2 * mp.pi**2 * blur.covariance[0, 0] * end**2 * x**6)
            continue
        power = (mp.mpf(end) / blur.r0) ** (mp.mpf(5) / 3) * x**5  # q^(5/3)
        if blur.outer_scale is None:
            total -= mp.re(KOLMOGOROV * power)
            continue
        # The structure function as Gamma(nu) / 2^(1/6) less z^nu K_nu(z), along x: K from both series of I.
        scales, nu = mp.mpf(blur.outer_scale) / blur.r0, mp.mpf(5) / 6
        z = 2 * mp.pi / scales * end / blur.r0 * x**3
        to_z = (2 * mp.pi / scales) ** (mp.mpf(5) / 3)

        def series(order: mp.mpf, s: mp.mpc) -> mp.mpc:
            return mp.hyp0f1(1 + order, s) / mp.gamma(1 + order)

        both = 2**nu * series(-nu, z * z / 4) - 2 ** (-nu) * to_z * power * series(nu, z * z / 4)
        bessel = mp.pi / 2 / mp.sin(mp.pi * nu) * both
        size = mp.mpf(KOLMOGOROV) / 2 * scales ** (mp.mpf(5) / 3) * mp.mpf(2) ** (mp.mpf(1) / 6)
        size *= mp.gamma(mp.mpf(11) / 6) / mp.pi ** (mp.mpf(8) / 3)
        total -= mp.re(size * (mp.gamma(nu) / mp.mpf(2) ** (mp.mpf(1) / 6) - bessel))
    return float(total)


@pytest.mark.parametrize("kind", KINDS)
def test_on_the_axis_the_reference_is_the_transfer_function(kind):
    fading = Fading.of(KINDS[kind], 1.0, None)
    for x in (0.1, 0.5, 0.9):
        assert math.exp(transfer(KINDS[kind], x, 0.2)) == pytest.approx(
            float(fading.at(np.array(0.2 * x**3))), rel=1e-9
        )


@pytest.mark.parametrize("kind", KINDS)
def test_no_point_of_a_disc_is_above_the_bound_and_some_are_near_it(kind):
    rng, fading = np.random.default_rng(3), Fading.of(KINDS[kind], 1.0, None)
    near = 0
    for end in (0.05, 0.3, 1.0):
        for _ in range(25):
            x = complex(rng.uniform(0.0, 1.2), rng.uniform(-0.4, 0.4))
            radius = float(10.0 ** rng.uniform(-4.0, -1.0))
            bound = float(fading.log_bound(np.array([x]), np.array([radius]), end)[0])
            for angle in (0.0, *rng.uniform(0.0, 2.0 * np.pi, 4)):
                found = transfer(KINDS[kind], x + radius * np.exp(1j * angle), end)
                assert found <= bound + 1e-9 * (1.0 + abs(bound))
                near += found > bound - 0.1 - 0.01 * abs(bound)
    assert near > 50


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("left", [1e-4, 1e-8, 1e-13])
def test_beyond_the_end_is_less_than_is_left(kind, left):
    fading = Fading.of(KINDS[kind], 1.0, None)
    end, bound = fading.end(left)
    assert bound <= left
    there = quad(lambda f: float(fading.at(np.array(f))) * f, end, 1.0, limit=400, epsabs=1e-3 * left)[0]
    assert there <= bound * (1.0 + 1e-9)
    if end < 1.0:
        # Two hundredths nearer there is more.
        assert (
            quad(lambda f: float(fading.at(np.array(f))) * f, 0.95 * end, 1.0, limit=400, epsabs=1e-3 * left)[0]
            > left
        )
    assert fading.light >= quad(lambda f: float(fading.at(np.array(f))) * f, 0.0, 1.0, limit=400)[0]
    assert fading.light <= 0.51


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
