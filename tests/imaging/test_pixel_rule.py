"""Averages over pixels, against radial functions whose averages are known."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm
from lommel.imaging.pixel_rule import pixel_rule
from lommel.methods.nijboer_zernike import NijboerZernike


def bessel_means(x: np.ndarray, y: np.ndarray, kappa: float) -> np.ndarray:
    """The means of J0(kappa r): it is the mean of plane waves over their direction, and theirs are sincs."""
    count = 2 * int(kappa * (np.hypot(x, y).max() + 1.0)) + 60
    angle = (np.arange(count) + 0.5) * (2.0 * np.pi / count)
    a, b = kappa * np.cos(angle), kappa * np.sin(angle)
    waves = np.cos(np.multiply.outer(x, a) + np.multiply.outer(y, b))
    return (waves * np.sinc(a / (2.0 * np.pi)) * np.sinc(b / (2.0 * np.pi))).mean(axis=-1)


@pytest.mark.parametrize("half", [0, 1, 5, 17])
@pytest.mark.parametrize("step", [0.01, 0.7, 3.0, 21.0])
def test_the_means_of_bessel_functions_up_to_the_band_limit_are_exact(half, step):
    from scipy.special import j0

    rule = pixel_rule(half, step)
    x, y = rule.cells.T
    # I is of exponential type 2 in v, 2 step in pixels.
    for kappa in (0.0, 0.3 * step, step, 2.0 * step):
        means = j0(kappa * rule.radii) @ rule.matrix
        assert np.abs(means - bessel_means(x, y, kappa)).max() < 2e-12


@given(half=st.integers(0, 12), step=st.floats(1e-3, 5.0), power=st.integers(0, 2))
def test_the_means_of_low_powers_of_the_radius_are_exact(half, step, power):
    rule = pixel_rule(half, step)
    x, y = rule.cells.T.astype(float)
    exact = [np.ones_like(x), x**2 + y**2 + 1 / 6][power] if power < 2 else None
    if exact is None:
        fourth = [a**4 + a**2 / 2 + 1 / 80 for a in (x, y)]
        exact = fourth[0] + fourth[1] + 2 * (x**2 + 1 / 12) * (y**2 + 1 / 12)
    means = (rule.radii ** (2 * power)) @ rule.matrix
    assert np.abs(means - exact).max() < 1e-12 * exact.max()


def test_windows_hold_each_cell_as_often_as_its_share_of_the_sums_says():
    rule = pixel_rule(6, 1.0)
    means = np.random.default_rng(0).random((3, len(rule.cells)))
    windows, sums = rule.unfold(means, 6), rule.sums(means)
    for half in range(7):
        middle = windows[:, 6 - half : 7 + half, 6 - half : 7 + half]
        assert np.allclose(sums[:, half], middle.sum(axis=(1, 2)), rtol=1e-13)
        assert np.array_equal(rule.unfold(means, half), middle)


@pytest.mark.parametrize("threads", [1, 2, 3])
def test_the_compiled_product_is_the_product_with_the_profile(threads):
    method = NijboerZernike(1e-9)
    pupils = lm.Pupil(lm.Wavefront(np.linspace(-30.0, 40.0, 11), 3.0), obscuration=0.3)
    v = np.linspace(0.0, 60.0, 37)
    matrix = np.random.default_rng(1).standard_normal((37, 21))
    expected = method.profile(pupils, v).values @ matrix
    assert np.abs(method.means(pupils, v, matrix, threads) - expected).max() < 1e-13
