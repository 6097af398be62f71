"""Transfer functions by the windows of photographs: those of PSFs through the front door."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import j1

import lommel as lm
from lommel.core import engine
from lommel.estimation.pixel_transfer import half_window, pixel_transfer
from lommel.imaging import sensor_light
from lommel.imaging.sensor_light import SensorLight, sensor_transfer

LENS = lm.Lens(
    focal_length=35e-3, f_number=4.0, focus_distance=1.5, wavelength=540e-9, aberrations=lm.Wavefront(0.0, 1.0)
)


@pytest.mark.parametrize("spectrum", [((540e-9, 1.0),), ((500e-9, 0.3), (600e-9, 0.7))])
def test_they_are_those_of_the_psf(spectrum):
    distances = np.array([1.2, 1.5, 2.0, np.inf])
    asked = LENS, distances, spectrum, 4e-6, (96, 81), 24
    np.testing.assert_allclose(sensor_transfer(*asked), pixel_transfer(*asked), atol=2e-6)


def test_pixels_of_many_spots_average_a_disc():
    """Rays of a point out of focus fill a disc: its transform times that of a pixel, but for folded light."""
    lens = lm.Lens(focal_length=48e-3, f_number=0.95, focus_distance=2.4, wavelength=540e-9)
    distances = np.array([4.8])
    half = half_window([lens], distances, 48e-6)
    made = sensor_transfer(lens, distances, ((540e-9, 1.0),), 48e-6, (256, 256), half)[0, 0, 1:]
    cycles = np.arange(1, 129) / 256.0
    around = 2.0 * np.pi * float(lens.pupil(4.8).geometric_radius()) / 48e-6 * cycles
    off = np.abs(made - 2.0 * j1(around) / around * np.sinc(cycles))
    assert off.max() < 0.011
    assert off[cycles < 0.25].max() < 0.004


@pytest.mark.parametrize("obscuration", [0.0, 0.3])
def test_profiles_of_many_pupils_are_those_of_the_series(monkeypatch, obscuration):
    lens = lm.Lens(focal_length=50e-3, f_number=2.0, wavelength=540e-9, obscuration=obscuration)
    light = SensorLight.of(lens, ((540e-9, 1.0),), 12e-6)
    stack, v = light.defocused(np.linspace(-30.0, 90.0, 5)), 0.4 * np.arange(4101)
    exact = lm.NijboerZernike(1e-8).profile(stack, v).values
    for dear in (0.0, np.inf):  # matrix products, the series
        monkeypatch.setattr(sensor_light, "_DEAR", dear)
        made = sensor_light._profiles(stack, v)
        assert (np.abs(made - exact).max(axis=1) <= 2e-8 * exact.max(axis=1)).all()


@pytest.mark.parametrize("shape", [(1, 1, 1), (3, 30, 100), (8, 7, 48), (17, 5, 33), (130, 40, 70)])
def test_matrix_products_are_those_of_numpy_with_any_number_of_threads(shape):
    rows, count, sums = shape
    draw = np.random.default_rng(0)
    left, right = draw.standard_normal((rows, count)), draw.standard_normal((count, sums))
    made = engine.product(left, right, 1)
    np.testing.assert_allclose(made, left @ right, rtol=0.0, atol=1e-13)
    assert np.array_equal(engine.product(left, right, 3), made)
