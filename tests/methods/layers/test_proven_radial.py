"""What is made of an objective's light around any azimuth: its peaks, its windows, its averages."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import j1, jvp

import lommel as lm
from lommel.methods import TwoPhoton
from lommel.methods.layers.debye_wolf import BRIGHT_RING
from lommel.special.legendre import gauss_legendre
from objectives import TIRF
from plane_waves import intensity

PIXEL = 6.5e-6


def laser(polarization="x", z=(-0.3e-6, 0.1e-6)):
    return TIRF.pupil(depth=0.2e-6, z=np.array(z), wavelength=780e-9, emitter=lm.Beam(polarization))


def squared(pupil, x, y):
    """The exact two-photon light at points of the camera, shape (planes, *x.shape)."""
    found = intensity(TIRF, pupil, x.ravel(), y.ravel(), 40, 70) / pupil.power[:, None]
    return (found**2).reshape(-1, *x.shape)


@pytest.mark.parametrize("tol", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("center", [None, (1.3, 8.2)])
def test_samples_are_within_the_bound_around_any_axis(center, tol):
    pupil = laser((0.3, 0.8 - 0.2j))
    made = lm.psf(pupil, (5, 7), PIXEL, method=TwoPhoton(tol), center=center, integrate=False, normalize="strehl")
    row, column = center or (2, 3)
    y, x = np.mgrid[0:5, 0:7]
    exact = squared(pupil, (x - column) * PIXEL, (y - row) * PIXEL)
    peak = squared(pupil, *np.array([[0.0], [0.0]])).max(axis=1)
    assert np.all(np.abs(made.values - exact).max(axis=(1, 2)) <= made.error_bound * peak)
    assert made.error_bound <= tol


@pytest.mark.parametrize("tol", [1e-3, 1e-6, 1e-9])
def test_pixels_average_what_varies_faster_than_an_intensity(tol):
    pupil, pixel = laser(), 12e-6
    made = lm.psf(pupil, 3, pixel, method=TwoPhoton(tol), integrate=True, normalize="strehl")
    q, w = gauss_legendre(8, -0.5, 0.5)
    at = (np.arange(-1, 2)[:, None] + q).ravel() * pixel
    x, y = np.meshgrid(at, at)
    exact = np.einsum("naibj,i,j->nab", squared(pupil, x, y).reshape(2, 3, 8, 3, 8), w, w)
    assert np.all(np.abs(made.values - exact).max(axis=(1, 2)) <= made.error_bound * exact.max(axis=(1, 2)))
    assert made.error_bound <= tol


def test_values_over_the_largest_in_a_window_beside_the_peak_are_exact_to_that():
    pupil = laser(z=[0.0])
    way = {"method": TwoPhoton(1e-5), "center": (2.0, -6.0), "integrate": False, "dtype": np.float64}
    made = lm.psf(pupil, 5, PIXEL, normalize="peak", **way)
    y, x = np.mgrid[0:5, 0:5]
    exact = squared(pupil, (x + 6.0) * PIXEL, (y - 2.0) * PIXEL)
    # A product with 1 / x, rounded twice.
    assert abs(made.values.max() - 1.0) <= np.finfo(np.float64).eps
    assert np.abs(made.values - exact / exact.max()).max() <= made.error_bound <= 1e-5
    # Where they relate to the peak, which is beside the window, much less is needed.
    bright = lm.psf(pupil, 5, PIXEL, normalize="strehl", **way)
    assert np.abs(bright.values - exact).max() <= 1e-5 * squared(pupil, np.zeros(1), np.zeros(1))[0, 0]
    # Beside nothing but faint light no tolerance near rounding can be met, unless it is over the peak.
    far = {"method": TwoPhoton(1e-9), "center": (2.0, -20.0), "integrate": False, "dtype": np.float64}
    with pytest.raises(lm.ToleranceError, match="tol=1e-09 cannot be met"):
        lm.psf(pupil, 5, PIXEL, normalize="peak", **far)
    assert lm.psf(pupil, 5, PIXEL, normalize="strehl", **far).error_bound <= 1e-9


def test_a_profile_is_the_mean_around_the_axis():
    pupil, v = laser(), np.array([0.0, 2.0, 5.5])
    made = TwoPhoton(1e-9).profile(pupil, v)
    phi = 2.0 * np.pi * (np.arange(16) + 0.5) / 16
    r = v[:, None] * pupil.scale / np.pi
    exact = squared(pupil, r * np.cos(phi), r * np.sin(phi)).mean(axis=-1)
    assert np.all(np.abs(made.values - exact) <= (made.error * made.peak)[:, None] + 1e-12)
    far = TwoPhoton(1e-9).profile(pupil, v[2:])
    assert far.values[:, 0] == pytest.approx(made.values[:, 2], abs=1e-9)
    assert far.peak == pytest.approx(made.peak, rel=1e-8)


def test_light_that_is_radial_is_the_same_either_way():
    pupil = laser("circular")
    alone = lm.psf(pupil, 7, PIXEL, method=TwoPhoton(1e-9), integrate=False, normalize="strehl", dtype=np.float64)
    turning = lm.psf(laser((1.0, 1j + 1e-15)), 7, PIXEL, method=TwoPhoton(1e-9), integrate=False, normalize="strehl")
    assert turning.values == pytest.approx(alone.values, abs=2e-9)
    assert alone.method.along_radius(pupil) is not None
    assert turning.method.along_radius(laser("x")) is None


def test_the_ring_that_is_bright_where_the_axis_is_dark_is_the_maximum_of_j1():
    assert jvp(1, BRIGHT_RING) == pytest.approx(0.0, abs=2e-5)
    assert j1(BRIGHT_RING) > j1(np.linspace(0.0, 20.0, 999)).max() - 1e-5
