"""The kernel of seeing: its Hankel transform, its table, and the bound on its halo."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import mp
from scipy.optimize import brentq

import lommel as lm
from lommel.blur.blurs import FWHM, KOLMOGOROV
from lommel.blur.turbulence import Gate, Halo, between, table

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


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("far", [25.0, 60.0, 200.0, 800.0])
def test_the_bound_on_a_halo_is_above_it_and_falls_as_it_does(kind, far):
    halo = KINDS[kind]
    beyond = float(np.abs(halo.at(np.linspace(far, 3.0 * far, 301))).max())
    bound = halo.gated_bound(far)
    assert beyond <= bound
    if far >= 200.0:  # nearer, what the gate smears is felt
        assert bound <= 20.0 * beyond


@pytest.mark.parametrize("far", [12.0, 30.0, 100.0, 400.0])
@pytest.mark.parametrize("ratio", [20.0, 50.0])
def test_the_bound_on_the_density_is_hardly_above_it(far, ratio):
    there = hankel(far, ratio)
    bound = Halo((lm.Seeing(1.0 / ratio),), 1.0, None, GATE).bound(far)
    assert there <= bound <= 1.15 * there


def test_the_gate_is_open_up_to_two_and_closed_where_copies_begin():
    w = np.linspace(0.0, 2.0, 101)
    assert np.abs(GATE.round(w) - 1.0).max() <= GATE.error
    copies = np.linspace(2.0 * np.pi / GATE.h - 2.0, 20.0, 101)
    assert GATE.round(copies).max() <= GATE.error
    assert GATE.round(np.array([GATE.end]))[0] < 1e-30
