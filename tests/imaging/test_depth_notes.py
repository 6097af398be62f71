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
# f^2 / (N c) + f for a circle of two pixels: 50^2 / (2 * 0.08) + 50 mm.
HYPERFOCAL = 15.675


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


def test_integers_of_dask_are_refused_before_they_are_computed():
    da = pytest.importorskip("dask.array")
    with pytest.raises(TypeError, match="depth must hold metres in floats, got uint16"):
        imaging.depth_of_field(
            da.from_array(SCENE), da.full(SCENE.shape, 2000, dtype=np.uint16), LENS, PIXEL, encoding="linear"
        )


@pytest.mark.parametrize("way", WAYS)
def test_depth_beyond_the_hyperfocal_distance_is_told(way):
    with pytest.warns(UserWarning, match=r"all of the depth, 1900 m to 2200 m, is beyond the hyperfocal .* 15\.68 m"):
        WAYS[way](np.linspace(1900.0, 2200.0, SCENE.size).reshape(SCENE.shape))


def test_what_may_be_metres_is_not_told():
    for low, high in ((0.99 * HYPERFOCAL, 2000.0), (1.9, np.inf), (np.inf, np.inf)):
        depth = np.full(SCENE.shape, high)
        depth[:, :16] = low
        imaging.DepthBlur(depth, LENS, PIXEL, largest=200)
    with pytest.warns(UserWarning, match="beyond the hyperfocal"):
        imaging.DepthBlur(np.full(SCENE.shape, 1.01 * HYPERFOCAL), LENS, PIXEL)


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


def test_light_that_may_be_beyond_white_is_not_told():
    photo = 20.0 * SCENE
    photo[0, 0] = 0.5
    given = {"encoding": "linear", "noise": NOISE, "method": imaging.RichardsonLucy(steps=1)}
    depth = np.full(SCENE.shape, 2.0)
    imaging.restore(photo + 1.0, depth, LENS, PIXEL, saturation=np.inf, **given)
    with pytest.warns(UserWarning, match="light of 11 times white"):
        imaging.restore(np.where(photo > 1.0, 11.0, photo), depth, LENS, PIXEL, **given)


def test_a_photograph_and_its_light_tell_it(tmp_path):
    imaging.write_photo(tmp_path / "a.tif", 255.0 * SCENE, encoding="linear", dtype=np.float32)
    with pytest.warns(UserWarning, match=r"light of 127\.5 times white"):
        imaging.read_photo(tmp_path / "a.tif").light()
