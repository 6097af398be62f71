"""OpenEXR files, written and read by the library of that name."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm

exr = pytest.importorskip("OpenEXR")


def write(path, channels, **header):
    with exr.File({"compression": exr.PIZ_COMPRESSION, "type": exr.scanlineimage} | header, channels) as file:
        file.write(str(path))


@pytest.mark.parametrize("shape", [(7, 11), (7, 11, 3)])
def test_photographs_come_back_and_are_those_that_the_library_reads(tmp_path, shape):
    light = np.random.default_rng(0).normal(size=shape).astype(np.float32)
    assert lm.imaging.write_photo(tmp_path / "a.exr", light, encoding="linear", dtype=np.float32) == 0.0
    again = lm.imaging.read_photo(tmp_path / "a.exr")
    assert again.encoding == "linear"
    assert np.array_equal(again.values, light)
    with exr.File(str(tmp_path / "a.exr")) as file:
        assert np.array_equal(file.channels()["RGB" if len(shape) == 3 else "Y"].pixels, light)


def test_halves_are_read_and_depth_maps_keep_what_is_unknown(tmp_path):
    light = np.random.default_rng(0).random((5, 6, 3)).astype(np.float16)
    write(tmp_path / "half.exr", {"RGB": light})
    assert np.array_equal(lm.imaging.read_photo(tmp_path / "half.exr").values, light.astype(np.float32))
    depth = np.linspace(0.5, 9.0, 30).reshape(5, 6)
    depth[0, :2] = np.inf, np.nan
    lm.imaging.write_depth(tmp_path / "z.exr", depth)
    assert np.array_equal(lm.imaging.read_depth(tmp_path / "z.exr"), depth.astype(np.float32), equal_nan=True)
    rendered = {"RGB": light.astype(np.float32), "Z": depth.astype(np.float32)}
    write(tmp_path / "all.exr", rendered)
    assert np.array_equal(lm.imaging.read_depth(tmp_path / "all.exr"), depth.astype(np.float32), equal_nan=True)


def test_other_channels_cropped_windows_and_damage_are_refused(tmp_path):
    light = np.zeros((5, 6, 4), np.float32)
    write(tmp_path / "alpha.exr", {"RGBA": light})
    with pytest.raises(lm.imaging.PhotoError, match="alpha that is not 1 everywhere: put it on a background"):
        lm.imaging.read_photo(tmp_path / "alpha.exr")
    write(tmp_path / "two.exr", {"U": light[..., 0], "V": light[..., 1]})
    with pytest.raises(lm.imaging.PhotoError, match="channels are U, V, neither R, G, B nor Y"):
        lm.imaging.read_photo(tmp_path / "two.exr")
    coloured = np.random.default_rng(1).random((5, 6, 3)).astype(np.float32)
    write(tmp_path / "coloured.exr", {"RGB": coloured})
    for name in ("two.exr", "coloured.exr"):
        with pytest.raises(lm.imaging.PhotoError, match="a depth map has one, or one named Z"):
            lm.imaging.read_depth(tmp_path / name)
    corners = (np.array([0, 0], np.int32), np.array([9, 9], np.int32))
    write(tmp_path / "part.exr", {"Y": light[..., 0]}, displayWindow=corners)
    with pytest.raises(lm.imaging.PhotoError, match="save it uncropped"):
        lm.imaging.read_photo(tmp_path / "part.exr")
    data = (tmp_path / "alpha.exr").read_bytes()
    for count in (8, 60, 330, len(data) - 5):
        (tmp_path / "short.exr").write_bytes(data[:count])
        with pytest.raises(lm.imaging.PhotoError):
            lm.imaging.read_depth(tmp_path / "short.exr")
    with pytest.raises(ValueError, match="no ICC profile"):
        lm.imaging.write_photo(tmp_path / "b.exr", light[..., 0], dtype=np.float32, profile=b"x")


def test_opaque_alpha_depth_beside_grey_in_three_channels_and_layers_are_read(tmp_path):
    light = np.random.default_rng(0).random((5, 6, 4)).astype(np.float32)
    light[..., 3] = 1.0
    depth = np.linspace(0.5, 9.0, 30, dtype=np.float32).reshape(5, 6)
    write(tmp_path / "opaque.exr", {"RGBA": light, "Z": depth})
    assert np.array_equal(lm.imaging.read_photo(tmp_path / "opaque.exr").values, light[..., :3])
    assert np.array_equal(lm.imaging.read_depth(tmp_path / "opaque.exr"), depth)
    write(tmp_path / "grey.exr", {"RGB": np.repeat(depth[..., None], 3, axis=2)})
    assert np.array_equal(lm.imaging.read_depth(tmp_path / "grey.exr"), depth)
    layers = {f"ViewLayer.Combined.{name}": light[..., k] for k, name in enumerate("RGBA")}
    write(tmp_path / "layers.exr", layers | {"ViewLayer.Depth.Z": depth})
    assert np.array_equal(lm.imaging.read_depth(tmp_path / "layers.exr"), depth)
