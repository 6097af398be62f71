"""The light of defocused points on sensors: profiles of many pupils, and the products that they take."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.core import engine
from lommel.imaging import sensor_light
from lommel.imaging.sensor_light import SensorLight


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
