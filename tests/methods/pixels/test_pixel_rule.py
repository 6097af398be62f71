"""Averages over pixels, against radial functions whose averages are known."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.special import j0, j1

import lommel as lm
from lommel.measures.energy import ensquared_energy
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.methods.pixel_rule import octant, pixel_rule, quarters, sums_of_windows


def bessel_means(x: np.ndarray, y: np.ndarray, kappa: float) -> np.ndarray:
    """The means of J0(kappa r): it is the mean of plane waves over their direction, and theirs are sincs."""
    count = 2 * int(kappa * (np.hypot(x, y).max() + 1.0)) + 60
    angle = (np.arange(count) + 0.5) * (2.0 * np.pi / count)
    a, b = kappa * np.cos(angle), kappa * np.sin(angle)
    waves = np.cos(np.multiply.outer(x, a) + np.multiply.outer(y, b))
    return (waves * np.sinc(a / (2.0 * np.pi)) * np.sinc(b / (2.0 * np.pi))).mean(axis=-1)


def unfolded(means: np.ndarray, half: int) -> np.ndarray:
    """Windows of 2 half + 1 pixels a side from the pixels of the octant."""
    distance = np.abs(np.arange(-half, half + 1))
    return quarters(means, half)[:, distance[:, None], distance]


@pytest.mark.parametrize("half", [0, 1, 5, 17])
@pytest.mark.parametrize("step", [0.01, 0.7, 3.0, 21.0])
def test_the_means_of_bessel_functions_up_to_the_band_limit_are_exact(half, step):
    rule = pixel_rule(half, step)
    x, y = octant(half)
    # I is of exponential type 2 in v, 2 step in pixels.
    for kappa in (0.0, 0.3 * step, step, 2.0 * step):
        means = j0(kappa * rule.radii) @ rule.matrix
        assert np.abs(means - bessel_means(x, y, kappa)).max() < 2e-12


@given(half=st.integers(0, 12), step=st.floats(1e-3, 5.0), power=st.integers(0, 2))
def test_the_means_of_low_powers_of_the_radius_are_exact(half, step, power):
    rule = pixel_rule(half, step)
    x, y = (part.astype(float) for part in octant(half))
    exact = [np.ones_like(x), x**2 + y**2 + 1 / 6][power] if power < 2 else None
    if exact is None:
        fourth = [a**4 + a**2 / 2 + 1 / 80 for a in (x, y)]
        exact = fourth[0] + fourth[1] + 2 * (x**2 + 1 / 12) * (y**2 + 1 / 12)
    means = (rule.radii ** (2 * power)) @ rule.matrix
    assert np.abs(means - exact).max() < 1e-12 * exact.max()


def test_windows_hold_each_cell_as_often_as_its_share_of_the_sums_says():
    means = np.random.default_rng(0).random((3, 28))
    windows, sums = unfolded(means, 6), sums_of_windows(means, 6)
    for half in range(7):
        middle = windows[:, 6 - half : 7 + half, 6 - half : 7 + half]
        assert np.allclose(sums[:, half], middle.sum(axis=(1, 2)), rtol=1e-13)
        assert np.array_equal(unfolded(means, half), middle)


@pytest.mark.parametrize("threads", [1, 2, 3])
def test_the_compiled_product_is_the_product_with_the_profile(threads):
    method = NijboerZernike(1e-9)
    pupils = lm.Pupil(lm.Wavefront(np.linspace(-30.0, 40.0, 11), 3.0), obscuration=0.3)
    v = np.linspace(0.0, 60.0, 37)
    matrix = np.random.default_rng(1).standard_normal((37, 21))
    expected = method.profile(pupils, v).values @ matrix
    assert np.abs(method.means(pupils, v, matrix, threads) - expected).max() < 1e-13


def airy(v: np.ndarray) -> np.ndarray:
    safe = np.where(v == 0.0, 1.0, v)
    return np.where(v == 0.0, 1.0, (2.0 * j1(safe) / safe) ** 2)


@pytest.mark.parametrize("pixel", [0.3, 1.0, 4.0])
@pytest.mark.parametrize("wave", [lm.Wavefront(0.0), lm.Wavefront(12.0, 5.0)])
def test_means_are_the_pixel_averages_of_psf(pixel, wave):
    pupil, half = lm.Pupil(wave, obscuration=0.2), 6
    rule = pixel_rule(half, math.pi * pixel)
    means = lm.methods.Hankel().profile(pupil, math.pi * pixel * rule.radii).values @ rule.matrix
    window = unfolded(means, half)[0]
    exact = lm.psf(pupil, 13, pixel, integrate=True, method="hankel", normalize="strehl", dtype=np.float64).values
    unaberrated = float(np.asarray(lm.methods.Hankel().unaberrated_peak(pupil)))
    assert np.abs(window / unaberrated - exact).max() <= 1e-10 * exact.max()


@pytest.mark.parametrize("pixel", [0.1, 1.0, 10.0, 100.0])
@pytest.mark.parametrize("half", [0, 2, 9])
def test_the_light_of_a_window_is_the_ensquared_energy(pixel, half):
    step = math.pi * pixel
    rule = pixel_rule(half, step)
    total = unfolded(airy(step * rule.radii)[None] @ rule.matrix, half).sum() * step**2 / (4.0 * math.pi)
    answer = lm.psf(lm.Pupil(), 3, 1.0, method="hankel", dtype=np.float64)
    assert total == pytest.approx(ensquared_energy(answer, (half + 0.5) * pixel), abs=1e-10)
