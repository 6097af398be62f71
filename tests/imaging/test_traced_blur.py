"""Blur by depth within a framework: what each point spreads, the adjoint, derivatives by image and by depth."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from frameworks import THERE

LENS = lm.Lens(focal_length=16e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
PIXEL = 3.45e-6
DRAW = np.random.default_rng(0)
IMAGE, DEPTH = DRAW.random((20, 27)), DRAW.uniform(1.5, 4.0, (20, 27))


def spread(blur):
    """Return the sum of what each point spreads, by images of the core."""
    half, (height, width) = blur.half, IMAGE.shape
    plan = lm.Plan(2 * half + 1, PIXEL, tol=1e-9)
    windows = plan(LENS.pupil(DEPTH.ravel())).values
    windows /= windows.sum(axis=(1, 2), keepdims=True)
    whole = np.zeros((height + 2 * half, width + 2 * half))
    for window, (i, j) in zip(windows, np.ndindex(IMAGE.shape), strict=True):
        whole[i : i + 2 * half + 1, j : j + 2 * half + 1] += IMAGE[i, j] * window
    return whole[half : half + height, half : half + width]


@pytest.mark.parametrize("framework", THERE)
def test_a_blur_is_the_sum_of_what_its_points_spread(framework):
    with framework.used() as xp:
        blur = lm.imaging.traced_blur(
            LENS,
            [1.5, 4.0],
            PIXEL,
            xp,
            device=framework.place(xp),
            precision="float64" if framework.double else "float32",
        )
        found = framework.to_numpy(blur(framework.array(xp, IMAGE), framework.array(xp, DEPTH)))
    exact = spread(blur)
    assert np.abs(found - exact).max() < 1e-4 * exact.max()
    assert blur.error <= 1e-4
    assert blur.rank <= 10


@pytest.mark.parametrize("precision", ["float32", "float64"])
def test_its_derivatives_are_the_adjoint_and_those_by_depth(precision):
    jax = pytest.importorskip("jax")
    jnp, eps = jax.numpy, 1e-5 if precision == "float32" else 1e-12
    with jax.enable_x64(True):
        blur = lm.imaging.traced_blur(LENS, [1.4, 4.1], PIXEL, jnp, precision=precision)
        image, depth, other, turn = (
            jnp.asarray(a, dtype=precision) for a in (IMAGE, DEPTH, IMAGE[::-1] - 0.5, DEPTH)
        )

        @jax.jit
        def gradients(blur, image, depth):
            return jax.grad(lambda a, d: jnp.sum(blur(a, d) * other), argnums=(0, 1))(image, depth)

        by_image, by_depth = gradients(blur, image, depth)
        forward = jax.jit(lambda blur, a, d: jnp.sum(blur(a, d) * other))
        value = forward(blur, image, depth)
        assert abs(jnp.sum(by_image * image) - value) < eps * jnp.sum(jnp.abs(image * by_image))
        if precision == "float64":
            h = 1e-5
            difference = (forward(blur, image, depth + h * turn) - forward(blur, image, depth - h * turn)) / (2 * h)
            assert abs(jnp.sum(by_depth * turn) - difference) < 1e-6 * jnp.sum(jnp.abs(by_depth * turn))


def test_beyond_the_valid_range_there_is_no_image_and_far_away_is_within():
    blur = lm.imaging.traced_blur(LENS, [1.5, np.inf], PIXEL)
    assert np.isfinite(blur(IMAGE, np.where(DEPTH > 2.0, np.inf, DEPTH))).all()
    assert np.isnan(blur(IMAGE, DEPTH - 1.0)).any()
    sharp = lm.imaging.traced_blur(LENS, 2.0, PIXEL)
    assert sharp(IMAGE, np.full_like(IMAGE, 2.0)).shape == IMAGE.shape


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"lens": lm.Lens(focal_length=16e-3, f_number=4.0, wavelength=550e-9, model="aplanatic")}, "paraxial"),
        ({"lens": lm.Lens(focal_length=1e-2, f_number=4.0, wavelength=5e-7, spider=lm.Spider(0.1, [0.0]))}, "round"),
        ({"pixel": 0.0}, "pixel"),
        ({"distances": [-1.0, 2.0]}, "object_distance"),
        ({"energy": 1.0}, "energy"),
        ({"largest": 2}, "largest"),
        ({"precision": "half"}, "precision"),
    ],
)
def test_what_no_blur_can_be_made_of_is_refused(change, message):
    asked = {"lens": LENS, "distances": [1.5, 4.0], "pixel": PIXEL} | change
    with pytest.raises(ValueError, match=message):
        lm.imaging.traced_blur(**asked)


def test_images_and_depths_of_different_shapes_are_refused():
    with pytest.raises(ValueError, match="one shape"):
        lm.imaging.traced_blur(LENS, [1.5, 4.0], PIXEL)(IMAGE, DEPTH[1:])
