"""Averages of radial intensities over pixels, against quadrature in two dimensions and energies in closed form."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import j0, j1

import lommel as lm
from lommel.imaging.pixel_rule import pixel_rule
from lommel.metrics import ensquared_energy
from lommel.special.legendre import gauss_legendre

# Pixels in units of lambda*N; v = pi times that.
PIXELS = [0.1, 0.3, 1.0, 3.0, 10.0, 31.0, 100.0]


def airy(v: np.ndarray) -> np.ndarray:
    safe = np.where(v == 0.0, 1.0, v)
    return np.where(v == 0.0, 1.0, (2.0 * j1(safe) / safe) ** 2)


@pytest.mark.parametrize("pixel", PIXELS)
def test_means_are_those_of_dense_quadrature_over_each_pixel(pixel):
    half, step = 2, math.pi * pixel
    rule = pixel_rule(half, step)
    window = rule.unfold(rule.means(airy(rule.v)[None]), half)[0]
    # Over quarters of the pixels, I of exponential type 2 in either direction.
    nodes, weights = gauss_legendre(math.ceil(0.5 * step) + 24, -0.5, 0.5)
    weights = weights / weights.sum()
    dense = np.empty((5, 5))
    for row in range(-2, 3):
        for column in range(-2, 3):
            r = step * np.hypot(row + nodes[:, None], column + nodes)
            dense[row + 2, column + 2] = weights @ airy(r) @ weights
    assert np.abs(window - dense).max() <= 1e-10 * dense.max()


@pytest.mark.parametrize("pixel", [0.3, 1.0, 4.0])
@pytest.mark.parametrize("wave", [lm.Wavefront(0.0), lm.Wavefront(12.0, 5.0)])
def test_means_are_the_pixel_averages_of_psf(pixel, wave):
    pupil, half = lm.Pupil(wave, obscuration=0.2), 6
    rule = pixel_rule(half, math.pi * pixel)
    means = rule.means(lm.Hankel().profile(pupil, rule.v).values)
    window = rule.unfold(means, half)[0]
    exact = lm.psf(pupil, 13, pixel, integrate=True, method=lm.Hankel(), normalize="strehl", dtype=np.float64).values
    unaberrated = float(np.asarray(lm.Hankel().unaberrated_peak(pupil)))
    assert np.abs(window / unaberrated - exact).max() <= 1e-10 * exact.max()


@pytest.mark.parametrize("pixel", PIXELS)
@pytest.mark.parametrize("half", [0, 1, 7])
def test_polynomials_have_the_means_of_calculus(pixel, half):
    step = math.pi * pixel
    rule = pixel_rule(half, step)
    column, row = rule.cells.T
    one, square = rule.means(np.stack([np.ones_like(rule.v), rule.v**2]))
    assert one == pytest.approx(1.0, rel=1e-13)
    assert square == pytest.approx(step**2 * (column**2 + row**2 + 1.0 / 6.0), rel=1e-12)


@pytest.mark.parametrize("pixel", [0.1, 1.0, 10.0, 100.0])
@pytest.mark.parametrize("half", [0, 2, 9])
def test_the_light_of_a_window_is_the_ensquared_energy(pixel, half):
    step = math.pi * pixel
    rule = pixel_rule(half, step)
    total = rule.unfold(rule.means(airy(rule.v)[None]), half).sum() * step**2 / (4.0 * math.pi)
    answer = lm.psf(lm.Pupil(), 3, 1.0, method=lm.Hankel(), dtype=np.float64)
    assert total == pytest.approx(ensquared_energy(answer, (half + 0.5) * pixel), abs=1e-10)


def test_a_large_window_lies_between_the_circles_inside_and_around_it():
    pixel, half = 0.7, 20
    rule = pixel_rule(half, math.pi * pixel)
    total = rule.unfold(rule.means(airy(rule.v)[None]), half).sum() * (math.pi * pixel) ** 2 / (4.0 * math.pi)
    inside, around = (math.pi * pixel * (half + 0.5) * f for f in (1.0, math.sqrt(2.0)))
    # Rayleigh's formula for the light within a circle.
    assert 1.0 - j0(inside) ** 2 - j1(inside) ** 2 < total < 1.0 - j0(around) ** 2 - j1(around) ** 2


def test_windows_are_symmetric_and_smaller_ones_are_cut_from_larger():
    rule = pixel_rule(5, 2.0)
    means = rule.means(airy(rule.v)[None])
    window = rule.unfold(means, 5)
    assert window.shape == (1, 11, 11)
    for turned in (window[:, ::-1], window[:, :, ::-1], window.transpose(0, 2, 1)):
        assert np.array_equal(window, turned)
    assert np.array_equal(rule.unfold(means, 2), window[:, 3:-3, 3:-3])
