"""Depth that is no metres, and light that is no share of white: refused or told, wherever images are made."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import lommel as lm
from lommel import imaging

LENS = lm.Lens(focal_length=50e-3, f_number=2.0, focus_distance=2.0, wavelength=550e-9)
PIXEL = 40e-6
SCENE = np.full((24, 32), 0.5)
NOISE = lm.Noise(white=5000, read=3.0)


WAYS = {
    "depth_of_field": lambda depth: imaging.depth_of_field(SCENE, depth, LENS, PIXEL, encoding="linear"),
    "tiles": lambda depth: imaging.depth_of_field(SCENE, depth, LENS, PIXEL, encoding="linear", tile=16),
    "plan": lambda depth: imaging.FocusPlan(SCENE, depth, LENS, PIXEL, encoding="linear"),
    "blur": lambda depth: imaging.DepthBlur(depth, LENS, PIXEL),
    "restore": lambda depth: imaging.restore(
        SCENE, depth, LENS, PIXEL, encoding="linear", noise=NOISE, method=imaging.RichardsonLucy(steps=1)
    ),
}


@pytest.mark.parametrize("way", WAYS)
def test_integers_are_refused_with_the_way_out(way):
    for kind in (np.uint16, np.int64):
        with pytest.raises(TypeError, match=rf"floats, got {np.dtype(kind)}; .* millimetre give 0\.001 \* depth"):
            WAYS[way](np.full(SCENE.shape, 2000, kind))
    WAYS[way](0.001 * np.full(SCENE.shape, 2000, np.uint16))


@pytest.mark.parametrize("way", WAYS)
def test_depth_beyond_the_hyperfocal_distance_is_told(way):
    with pytest.warns(UserWarning, match=r"all of the depth, 1900 m to 2200 m, is beyond the hyperfocal .* 15\.68 m"):
        WAYS[way](np.linspace(1900.0, 2200.0, SCENE.size).reshape(SCENE.shape))


def test_depth_within_the_focal_length_is_told_before_its_blur_is_refused():
    with (
        pytest.warns(
            UserWarning, match=r"all of the depth, 2 mm, is within the focal length, 50 mm: is it in metres\?"
        ),
        pytest.raises(ValueError, match="windows of more than"),
    ):
        imaging.DepthBlur(np.full(SCENE.shape, 0.002), LENS, PIXEL)


@pytest.mark.parametrize("tile", [None, 16])
def test_light_far_beyond_white_is_told(tile):
    depth = np.full(SCENE.shape, 2.0)
    for peak in (9.9, 10.1):
        scene = SCENE.copy()
        scene[3, 4] = peak
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            imaging.depth_of_field(scene, depth, LENS, PIXEL, encoding="linear", tile=tile)
        words = [str(each.message) for each in told]
        assert words == ([] if peak < 10.0 else ["there is light of 10.1 times white, which is 1 in floats; divide "
                                                 "them by their white"])  # fmt: skip
