"""Noise, mosaic and demosaicking within a framework."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from frameworks import THERE
from lommel.imaging import traced_demosaic, traced_mosaic, traced_noise

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


@pytest.mark.parametrize("pattern", ["RGGB", "BGGR", "GRBG", "GBRG"])
@pytest.mark.parametrize("framework", THERE)
def test_demosaicking_keeps_what_is_recorded_and_planes_are_exact(framework, pattern):
    image = DRAW.random((2, 3, 8, 10))
    y, x = np.indices((8, 10))
    plane = np.stack([1.0 + 0.2 * x + 0.1 * y, 2.0 - 0.1 * x, 0.5 + 0.3 * y])
    with framework.used() as xp:
        mosaic = traced_mosaic(framework.array(xp, image), pattern)
        found = framework.to_numpy(traced_demosaic(mosaic, pattern))
        mosaic = framework.to_numpy(mosaic)
        flat = framework.to_numpy(traced_demosaic(traced_mosaic(framework.array(xp, plane), pattern), pattern))
    colour = np.array(["RGB".index(c) for c in pattern]).reshape(2, 2)[y % 2, x % 2]
    assert np.allclose(mosaic, np.take_along_axis(image, colour[None, None], axis=1)[:, 0], atol=1e-6)
    assert np.allclose(np.take_along_axis(found, colour[None, None], axis=1)[:, 0], mosaic, atol=1e-6)
    assert np.allclose(flat[:, 1:-1, 1:-1], plane[:, 1:-1, 1:-1], atol=1e-5)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: traced_mosaic(np.ones((3, 5, 4))), "even sides"),
        (lambda: traced_mosaic(np.ones((3, 4, 4)), "RGBG"), "pattern"),
        (lambda: traced_demosaic(np.ones((2, 2))), "4 or more"),
        (lambda: traced_noise(np.ones(3), lm.Noise(read=1.0), np.ones(4)), "shape of the image"),
        (
            lambda: traced_noise(np.ones((2, 2)), lm.Noise(read=np.ones((2, 2))), np.ones((2, 2))),
            "a single white, read and offset",
        ),
    ],
)
def test_bad_input_is_refused(call, message):
    with pytest.raises(ValueError, match=message):
        call()
