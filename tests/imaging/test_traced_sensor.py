"""Noise within a framework."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.imaging import traced_noise

DRAW = np.random.default_rng(1)


def test_noise_has_the_variance_of_the_sensor():
    noise = lm.Noise(white=800.0, read=4.0, offset=0.02)
    image = np.full((400, 500), 0.3)
    recorded = traced_noise(image, noise, DRAW.standard_normal(image.shape))
    wanted = noise.variance(noise.electrons(0.3)) / 800.0**2
    assert recorded.mean() == pytest.approx(0.3, abs=1e-3)
    assert recorded.var() == pytest.approx(float(wanted), rel=0.02)
    exact = noise.record(noise.electrons(image), seed=3)
    assert np.var(np.asarray(exact)) == pytest.approx(recorded.var(), rel=0.03)


def test_the_gradient_of_noise_is_that_of_a_draw():
    jax = pytest.importorskip("jax")
    noise, normal = lm.Noise(white=100.0, read=2.0), jax.numpy.asarray(DRAW.standard_normal(5), "float32")
    slope = jax.grad(lambda light: traced_noise(light, noise, normal).sum())(jax.numpy.full(5, 0.25))
    wanted = 1.0 + 0.5 * np.asarray(normal) / np.sqrt(25.0 + 4.0)
    assert np.allclose(slope, wanted, rtol=1e-4)
    dark = jax.grad(lambda light: traced_noise(light, lm.Noise(read=0.0), normal).sum())(jax.numpy.zeros(5))
    assert np.isfinite(np.asarray(dark)).all()


def test_maps_of_noise_are_refused():
    with pytest.raises(ValueError, match="a single white, read and offset"):
        traced_noise(np.ones((2, 2)), lm.Noise(read=np.ones((2, 2))), np.ones((2, 2)))
