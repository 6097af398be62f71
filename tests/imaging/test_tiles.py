"""By tiles and by chunks as in one piece, in little memory."""

from __future__ import annotations

import json
import subprocess
import sys
from functools import cache

import numpy as np
import pytest

import lommel as lm
from lommel.imaging import RED_GREEN_BLUE, DepthBlur, depth_of_field

LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
PIXEL = 8e-6


def scene(channels=3, dtype=np.float32):
    rng = np.random.default_rng(0)
    image = rng.random((70, 90, channels)[: 2 if channels == 1 else 3])
    image = (image * 200).astype(dtype) if np.dtype(dtype).kind == "u" else image.astype(dtype)
    return image, 1.7 + 0.7 * rng.random((70, 90))


@cache
def in_one_piece(channels):
    """Return the photograph of the scene."""
    return depth_of_field(*scene(channels), LENS, PIXEL, encoding="linear")


@pytest.mark.parametrize("side", [16, 33, 64, 128])
@pytest.mark.parametrize("channels", [1, 3])
def test_tiles_make_the_same_photograph_as_one_piece(side, channels):
    image, depth = scene(channels)
    whole = in_one_piece(channels)
    tiled = depth_of_field(image, depth, LENS, PIXEL, tile=side, encoding="linear")
    assert np.abs(tiled.values - whole.values).max() < 2e-6
    assert (tiled.lost, tiled.error) == pytest.approx((whole.lost, whole.error), rel=1e-9)
    assert tiled.window == whole.window
    assert whole.window > 9


def test_objects_at_infinity_are_tiled_too():
    image, depth = scene(dtype=np.uint8)
    depth[5:9, 60:70] = np.inf
    lens = lm.Lens(focal_length=20e-3, f_number=8.0, focus_distance=4.0, wavelength=550e-9)
    whole = depth_of_field(image, depth, lens, PIXEL, encoding="srgb")
    tiled = depth_of_field(image, depth, lens, PIXEL, tile=32, encoding="srgb")
    assert np.abs(tiled.values.astype(int) - whole.values).max() <= 1
    assert np.mean(tiled.values != whole.values) < 1e-3


def edges(seed=0):
    """Light, and surfaces of several distances with edges of every direction, some slanted, some rough."""
    rng = np.random.default_rng(seed)
    y, x = np.mgrid[:70, :90]
    depth = np.where(x + 0.6 * y > 70, 2.0 + 0.01 * y, 3.5)
    depth[np.hypot(y - 40, x - 33) < 17] = 1.6
    depth[(x // 9 + y // 11) % 4 == 0] = 1.8
    depth[55:, 60:] += 0.6 * rng.random((15, 30))
    return rng.random((70, 90, 3)).astype(np.float32), depth


@pytest.mark.parametrize("side", [16, 33, 64])
def test_tiles_hide_what_the_whole_hides(side):
    image, depth = edges()
    whole = depth_of_field(image, depth, LENS, PIXEL, encoding="linear")
    tiled = depth_of_field(image, depth, LENS, PIXEL, tile=side, encoding="linear")
    assert np.abs(tiled.values - whole.values).max() <= 4e-6
    added = DepthBlur(depth, LENS, PIXEL, channels=RED_GREEN_BLUE).forward(image)
    assert np.abs(added - whole.values).max() > 0.1


@pytest.mark.parametrize("seed", range(3))
def test_tiles_hide_what_the_whole_hides_wherever_edges_are_as_near(seed):
    """Rough depth has many points as far from two edges: tiles are to choose the same."""
    rng = np.random.default_rng(seed)
    image, depth = rng.random((40, 53)), 1.7 + 1.5 * (rng.random((40, 53)) > 0.7)
    whole = depth_of_field(image, depth, LENS, PIXEL, encoding="linear")
    tiled = depth_of_field(image, depth, LENS, PIXEL, tile=16, encoding="linear")
    assert np.abs(tiled.values - whole.values).max() <= 4e-6


@pytest.mark.parametrize("which", ["image", "depth", "out"])
def test_memory_maps_are_done_by_tiles_of_a_side_that_is_chosen(tmp_path, monkeypatch, which):
    monkeypatch.setattr("lommel.imaging.photograph.TILE", 40)
    image, depth = scene()
    given, told = {"image": image, "depth": depth, "out": np.empty_like(image)}, []
    np.save(tmp_path / "a.npy", given[which])
    given[which] = np.load(tmp_path / "a.npy", mmap_mode="r+")
    made = depth_of_field(**given, lens=LENS, pixel=PIXEL, encoding="linear", progress=lambda *at: told.append(at))
    assert made.values is given["out"]
    assert told[-1] == (6, 6)
    by_hand = depth_of_field(image, depth, LENS, PIXEL, encoding="linear", tile=40)
    assert np.array_equal(made.values, by_hand.values)


def test_memory_is_that_of_a_tile_whatever_the_image():
    code = """
import json, tracemalloc
import numpy as np
import lommel as lm
from lommel.imaging import RED_GREEN_BLUE, DepthBlur, depth_of_field
lens = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
height, width = 1200, 1600
image = np.random.default_rng(0).integers(0, 200, (height, width, 3), dtype=np.uint8)
depth = np.linspace(1.7, 2.4, height * width, dtype=np.float32).reshape(height, width)
out = np.empty_like(image)
tracemalloc.start()
depth_of_field(image, depth, lens, 8e-6, encoding="srgb", tile=256, out=out)
print(json.dumps(tracemalloc.get_traced_memory()[1] / 2**20))
"""
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=300, check=True)
    # The whole image takes 22 MiB for one float32 copy; a tile of 256 with its margins, 1.1 MiB.
    assert json.loads(result.stdout) < 40.0


def test_the_result_must_not_go_where_the_image_is():
    image, depth = scene()
    with pytest.raises(ValueError, match="must not share memory"):
        depth_of_field(image, depth, LENS, PIXEL, encoding="linear", tile=32, out=image)
