"""Uneven light on a chart, from the white squares in windows."""

from __future__ import annotations

import numpy as np

from lommel.estimation.chart_light import relative_light


def test_light_over_windows_is_that_of_the_chart_however_some_squares_are_printed():
    draw = np.random.default_rng(1)
    middle = np.stack(np.meshgrid(*(np.linspace(-0.9, 0.9, 7),) * 2), axis=-1).reshape(-1, 2)
    offset = (np.arange(15) - 7) * 0.008
    u, v = middle[:, :1] + offset, middle[:, 1:] + offset
    square = u[:, None] ** 2 + v[:, :, None] ** 2
    true = (1.0 - 0.2 * square + 0.03 * square**2) * (1.0 + 0.05 * u[:, None])
    pattern = np.where(np.sign(offset[:, None] * offset) > 0.0, 5000.0, 500.0)
    mean = true * pattern
    mean[::11] *= draw.uniform(0.7, 0.95, mean[::11].shape[0])[:, None, None]  # dirt
    images = draw.poisson(mean).astype(float)[:, None]
    found = relative_light(images, np.ones(images.shape, dtype=bool), u, v)
    exact = true / true[:, 7:8, 7:8]
    assert np.abs(exact - 1.0).max() > 0.02
    np.testing.assert_allclose(found[:, 0], exact, atol=5e-3)
    assert np.sqrt(((found[:, 0] - exact) ** 2).mean()) < 1e-3
    few = relative_light(images[:2], np.ones(images[:2].shape, dtype=bool), u[:2], v[:2])
    assert (few == 1.0).all()
