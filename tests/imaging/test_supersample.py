"""Scenes finer than the sensor: the result averages their light over its pixels."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.imaging import depth_of_field

LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
PIXEL = 6e-6


def test_a_point_is_the_psf_over_the_pixels_of_the_sensor():
    """A point off the middle of its pixel, against the PSF with its centre there."""
    scene = np.zeros((4 * 31, 4 * 31))
    scene[4 * 15 + 3, 4 * 15] = 1.0
    made = depth_of_field(
        scene, np.full(scene.shape, 1.95), LENS, PIXEL, encoding="linear", supersample=4, energy=0.995
    )
    # Three eighths of a pixel down and left of the middle; a point has the light of a sixteenth of a pixel.
    expected = lm.psf(LENS.pupil(1.95), 31, PIXEL, center=(15.375, 14.625)).values / 16.0
    # The light outside the window is spread over the window.
    np.testing.assert_allclose((1.0 - made.lost) * made.values, expected, atol=2e-3 * expected.max())


def test_all_ways_agree():
    scene = np.random.default_rng(3).random((48, 64, 3))
    depth = np.full((48, 64), 2.5)
    options = {"encoding": "srgb", "supersample": 2}
    made = depth_of_field(scene, depth, LENS, PIXEL, **options)
    assert made.values.shape == (24, 32, 3)
    out = np.empty((24, 32, 3))
    depth_of_field(scene, depth, LENS, PIXEL, out=out, **options)
    np.testing.assert_array_equal(out, made.values)


def test_tiles_are_of_one_size():
    scene, depth = np.ones((48, 64)), np.full((48, 64), 2.0)
    with pytest.raises(ValueError, match="supersample must be 1 with tile"):
        depth_of_field(scene, depth, LENS, PIXEL, encoding="linear", supersample=2, tile=16)
