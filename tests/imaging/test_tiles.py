"""By tiles and by chunks as in one piece, in little memory."""

from __future__ import annotations

import json
import subprocess
import sys
from functools import cache

import numpy as np
import pytest

import lommel as lm
from lommel.imaging import depth_of_field

LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
PIXEL = 8e-6


def scene(channels=3, dtype=np.float32):
    rng = np.random.default_rng(0)
    image = rng.random((70, 90, channels)[: 2 if channels == 1 else 3])
    image = (image * 200).astype(dtype) if np.dtype(dtype).kind == "u" else image.astype(dtype)
    return image, 1.7 + 0.7 * rng.random((70, 90))


@cache
def in_one_piece(channels, border):
    """Return the photograph of the scene, and the options that make it."""
    options = {"encoding": "linear", "border": border} | ({"occlusion": False} if channels == 1 else {})
    return depth_of_field(*scene(channels), LENS, PIXEL, **options), options


@pytest.mark.parametrize("border", ["reflect", "extend", "zero"])
@pytest.mark.parametrize("side", [16, 33, 64, 128])
@pytest.mark.parametrize("channels", [1, 3])
def test_tiles_make_the_same_photograph_as_one_piece(border, side, channels):
    image, depth = scene(channels)
    whole, options = in_one_piece(channels, border)
    tiled = depth_of_field(image, depth, LENS, PIXEL, tile=side, **options)
    assert np.abs(tiled.values - whole.values).max() < 2e-6
    assert (tiled.lost, tiled.error) == pytest.approx((whole.lost, whole.error), rel=1e-9)
    assert tiled.window == whole.window
    assert whole.window > 9


def test_objects_at_infinity_and_holes_are_tiled_too():
    image, depth = scene(dtype=np.uint8)
    depth[5:9, 60:70] = np.nan
    lens = lm.Lens(focal_length=20e-3, f_number=8.0, focus_distance=4.0, wavelength=550e-9)
    options = {"encoding": "srgb", "missing": "infinity"}
    whole = depth_of_field(image, depth, lens, PIXEL, **options)
    tiled = depth_of_field(image, depth, lens, PIXEL, tile=32, **options)
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


@pytest.mark.parametrize("border", ["reflect", "extend", "zero"])
@pytest.mark.parametrize(("side", "dtype", "allowed"), [(16, "f8", 1e-13), (33, "f4", 4e-6), (64, "f8", 1e-13)])
def test_tiles_hide_what_the_whole_hides(border, side, dtype, allowed):
    image, depth = edges()
    image = image.astype(dtype)
    options = {"encoding": "linear", "border": border, "occlusion": True, "dtype": dtype}
    whole = depth_of_field(image, depth, LENS, PIXEL, **options)
    tiled = depth_of_field(image, depth, LENS, PIXEL, tile=side, **options)
    assert np.abs(tiled.values - whole.values).max() <= allowed
    if side == 33:
        added = depth_of_field(image, depth, LENS, PIXEL, tile=side, **{**options, "occlusion": False})
        assert np.abs(added.values - whole.values).max() > 0.1


@pytest.mark.parametrize("seed", range(3))
def test_tiles_hide_what_the_whole_hides_wherever_edges_are_as_near(seed):
    """Rough depth has many points as far from two edges: tiles are to choose the same."""
    rng = np.random.default_rng(seed)
    image, depth = rng.random((40, 53)), 1.7 + 1.5 * (rng.random((40, 53)) > 0.7)
    options = {"encoding": "linear", "occlusion": True, "dtype": np.float64}
    whole = depth_of_field(image, depth, LENS, PIXEL, **options)
    tiled = depth_of_field(image, depth, LENS, PIXEL, tile=16, **options)
    assert np.abs(tiled.values - whole.values).max() <= 1e-13


@pytest.mark.parametrize("missing", ["nearest", "infinity"])
@pytest.mark.parametrize("occlusion", [False, True])
def test_holes_are_filled_as_in_the_whole(missing, occlusion):
    image, depth = edges(1)
    depth[20:62, 30:70] = np.nan  # wider than a tile
    lens = lm.Lens(focal_length=20e-3, f_number=4.0, focus_distance=2.5, wavelength=550e-9)
    options = {"encoding": "linear", "missing": missing, "occlusion": occlusion}
    whole = depth_of_field(image, depth, lens, PIXEL, **options)
    tiled = depth_of_field(image, depth, lens, PIXEL, tile=16, **options)
    assert np.abs(tiled.values - whole.values).max() < 4e-6


def test_files_go_in_and_out_and_progress_is_told(tmp_path):
    image, depth = scene(dtype=np.uint8)
    np.save(tmp_path / "image.npy", image)
    np.save(tmp_path / "depth.npy", depth)
    out = np.lib.format.open_memmap(tmp_path / "out.npy", mode="w+", dtype=np.uint8, shape=image.shape)
    told: list[tuple[int, int]] = []
    made = depth_of_field(
        np.load(tmp_path / "image.npy", mmap_mode="r"),
        np.load(tmp_path / "depth.npy", mmap_mode="r"),
        LENS,
        PIXEL,
        encoding="srgb",
        tile=40,
        out=out,
        progress=lambda done, tiles: told.append((done, tiles)),
    )
    assert made.values is out
    assert told == [(k, 6) for k in range(1, 7)]
    whole = depth_of_field(image, depth, LENS, PIXEL, encoding="srgb").values
    assert np.abs(out.astype(int) - whole).max() <= 1


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
from lommel.imaging import depth_of_field
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


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        ({"tile": 8}, ValueError, "tile must be from 16 to 16384, got 8"),
        ({"missing": "nearest", "depth": np.full((70, 90), np.nan)}, ValueError, "depth is NaN everywhere"),
        ({"out": np.zeros((70, 90, 3))}, TypeError, "out must have the type of the image, float32, got float64"),
        ({"out": np.zeros((70, 90), "f4")}, ValueError, "out must have the shape of the image"),
        ({"progress": 3}, TypeError, "progress must be callable, got 3"),
        ({"image": [1.0]}, ValueError, "image must have the shape"),
        ({"depth": np.ones((7, 9))}, ValueError, r"depth must have the shape of the image, \(70, 90\), got \(7, 9\)"),
        ({"depth": np.full((70, 90), np.nan)}, ValueError, "depth is NaN"),
        ({"depth": np.full((70, 90), -1.0)}, ValueError, "depth must be > 0 metres, got -1.0"),
        ({"depth": np.full((70, 90), "a")}, TypeError, "depth must hold metres"),
        ({"depths": (1.0, np.nan)}, ValueError, "depths must be the nearest and the farthest"),
        ({"image": np.full((70, 90, 3), np.nan)}, ValueError, "image must be finite, got nan"),
        ({"encoding": "gamma"}, ValueError, "encoding must be one of"),
        ({"depth": np.full((70, 90), 0.5)}, ValueError, "windows of more than 71 pixels a side"),
    ],
)
def test_what_cannot_be_tiled_is_refused_by_name(change, error, message):
    image, depth = scene()
    given = {"image": image, "depth": depth, "lens": LENS, "pixel": PIXEL, "encoding": "linear", "tile": 16} | change
    with pytest.raises(error, match=message):
        depth_of_field(**given)


def test_the_result_must_not_go_where_the_image_is():
    image, depth = scene()
    with pytest.raises(ValueError, match="must not share memory"):
        depth_of_field(image, depth, LENS, PIXEL, encoding="linear", tile=32, out=image)


class TestChunks:
    """With dask."""

    @pytest.fixture
    def da(self):
        return pytest.importorskip("dask.array", reason="dask is missing")

    @pytest.mark.parametrize("scheduler", ["synchronous", "threads", "processes"])
    def test_chunks_make_the_same_photograph_wherever_they_are_computed(self, da, scheduler):
        image, depth = scene()
        whole = depth_of_field(image, depth, LENS, PIXEL, encoding="linear").values
        lazy = depth_of_field(
            da.from_array(image, chunks=(40, 30, 1)),
            da.from_array(depth, chunks=(70, 45)),
            LENS,
            PIXEL,
            encoding="linear",
        )
        assert isinstance(lazy, da.Array)
        assert (lazy.shape, lazy.dtype) == (image.shape, image.dtype)
        made = lazy.compute(scheduler=scheduler, num_workers=1 if scheduler == "processes" else 2)
        assert np.abs(made - whole).max() < 2e-6

    @pytest.mark.parametrize("chunk", [3, 17, 90])
    def test_grey_images_and_chunks_of_any_size(self, da, chunk):
        image, depth = scene(1)
        whole = depth_of_field(image, depth, LENS, PIXEL, encoding="linear", occlusion=False).values
        arrays = (da.from_array(a, chunks=chunk) for a in (image, depth))
        given = {"encoding": "linear", "occlusion": False, "depths": (1.6, 2.5), "tile": None}
        made = depth_of_field(*arrays, LENS, PIXEL, **given)
        lazy = (da.from_array(a) for a in (image, depth))
        alike = depth_of_field(*lazy, LENS, PIXEL, encoding="linear", occlusion=False)
        # A wider range makes other windows, within tol of these.
        assert np.abs(made.compute() - whole).max() < 1e-3
        assert np.abs(alike.rechunk(chunk).compute() - whole).max() < 2e-6

    @pytest.mark.parametrize("chunk", [13, 40])
    @pytest.mark.parametrize("channels", [1, 3])
    def test_chunks_hide_and_fill_as_the_whole(self, da, chunk, channels):
        image, depth = edges(2)
        image = image[..., 0] if channels == 1 else image
        depth[20:50, 30:70] = np.nan
        options = {"encoding": "linear", "missing": "nearest", "occlusion": True}
        whole = depth_of_field(image, depth, LENS, PIXEL, **options).values
        arrays = (da.from_array(a, chunks=chunk) for a in (image, depth))
        made = depth_of_field(*arrays, LENS, PIXEL, **options)
        assert np.abs(made.compute(scheduler="synchronous") - whole).max() < 4e-6

    def test_chunks_may_reach_beyond_the_whole(self, da):
        image, depth = (a[:20, :24] for a in edges(3))
        depth = np.where(np.arange(24) < 9, 1.45, 2.8) + 0.0 * depth
        options = {"encoding": "linear", "occlusion": True}
        whole = depth_of_field(image, depth, LENS, PIXEL, **options).values
        arrays = (da.from_array(a, chunks=8) for a in (image, depth))
        made = depth_of_field(*arrays, LENS, PIXEL, **options)
        assert np.abs(made.compute(scheduler="synchronous") - whole).max() < 4e-6

    def test_the_image_is_cut_as_asked(self, da):
        image, depth = scene(dtype=np.uint8)
        arrays = (da.from_array(a, chunks=10) for a in (image, depth))
        made = depth_of_field(*arrays, LENS, PIXEL, encoding="srgb", tile=48, missing="infinity")
        assert made.chunks == ((48, 22), (48, 42), (3,))
        whole = depth_of_field(image, depth, LENS, PIXEL, encoding="srgb").values
        assert np.abs(made.compute().astype(int) - whole).max() <= 1

    def test_a_depth_beyond_those_named_is_refused_when_it_is_met(self, da):
        image, depth = scene()
        arrays = (da.from_array(a, chunks=40) for a in (image, depth))
        made = depth_of_field(*arrays, LENS, PIXEL, encoding="linear", depths=(1.9, 2.0))
        with pytest.raises(ValueError, match="the range of the whole image"):
            made.compute(scheduler="synchronous")

    def test_holes_are_refused_at_once(self, da):
        image, depth = scene()
        depth[3, 4] = np.nan
        arrays = (da.from_array(a, chunks=40) for a in (image, depth))
        with pytest.raises(ValueError, match="depth is NaN at some points"):
            depth_of_field(*arrays, LENS, PIXEL, encoding="linear")

    def test_arrays_of_numpy_beside_them_are_refused(self, da):
        image, depth = scene()
        for arrays in ((da.from_array(image), depth), (image, da.from_array(depth))):
            with pytest.raises(TypeError, match=r"image and depth must both be dask arrays if one is, got"):
                depth_of_field(*arrays, LENS, PIXEL, encoding="linear")

    @pytest.mark.parametrize("given", [{"out": np.zeros((70, 90, 3))}, {"progress": print}])
    def test_what_chunks_cannot_have_names_the_way_that_dask_has(self, da, given):
        arrays = (da.from_array(a) for a in scene())
        with pytest.raises(ValueError, match=r"use dask.array.store\(result, out\) and dask.diagnostics.ProgressBar"):
            depth_of_field(*arrays, LENS, PIXEL, encoding="linear", **given)
