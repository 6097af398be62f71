"""Maps of depth, written and read again."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
import tifffile
from PIL import Image

from containers import png
from lommel.imaging import PhotoError, read_depth, write_depth


@pytest.mark.parametrize("suffix", [".tif", ".tiff", ".npy", ".pfm"])
def test_what_is_written_is_read(tmp_path, suffix):
    depth = np.array([[1.5, np.nan, np.inf], [0.25, 2.0, 1e-3]])
    write_depth(tmp_path / f"depth{suffix}", depth)
    assert np.array_equal(read_depth(tmp_path / f"depth{suffix}"), depth.astype(np.float32), equal_nan=True)


def test_what_is_no_map_is_told(tmp_path):
    with pytest.raises(ValueError, match=r"must end in \.npy, \.pfm, \.tif, \.tiff"):
        write_depth(tmp_path / "depth.png", np.ones((2, 2)))
    for wrong in (np.ones(3), np.ones((2, 2, 2)), np.array([["a"]]), np.ones((0, 2))):
        with pytest.raises((TypeError, ValueError), match="depth must be numbers"):
            write_depth(tmp_path / "depth.npy", wrong)
    with pytest.raises(ValueError, match="depth must be >= 0 metres, got -1"):
        write_depth(tmp_path / "depth.npy", np.array([[1.0, -1.0]]))
    assert not list(tmp_path.iterdir())


LEVELS = np.array([[255, 0, 128], [1, 64, 200]], np.uint8)


def by_hand(share: float, near: float, far: float) -> float:
    """The distance whose dioptres lie at this share of the way from those of far to those of near."""
    return 1.0 / (share / near + (1.0 - share) / far)


@pytest.mark.parametrize(
    ("name", "stored", "top"),
    [
        ("a.png", LEVELS, 255),
        ("a.png", LEVELS.astype(np.uint16) * 257, 65535),
        ("a.tif", LEVELS.astype(np.uint16) * 200, 65535),
        ("a.tif", (LEVELS / 255.0).astype(np.float32), 1.0),
        ("a.npy", LEVELS / 255.0, 1.0),
    ],
)
@pytest.mark.parametrize("far", [4.0, np.inf])
def test_inverse_depth_is_linear_in_dioptres(tmp_path, name, stored, top, far):
    save(tmp_path / name, stored)
    found = read_depth(tmp_path / name, inverse=(0.5, far))
    expected = [[by_hand(float(value) / top, 0.5, far) if value or far < np.inf else np.inf for value in row]
                for row in stored.tolist()]  # fmt: skip
    np.testing.assert_allclose(found, expected, rtol=1e-6)
    assert found[0, 1] == far
    marked = read_depth(tmp_path / name, inverse=(0.5, far), unknown=[0, stored[0, 2]])
    assert np.isnan(marked).tolist() == [[False, True, True], [False, False, False]]
    np.testing.assert_array_equal(marked[1], found[1])


def save(path, stored):
    """Write a file as other programs do."""
    if path.suffix == ".npy":
        np.save(path, stored)
    elif path.suffix == ".tif":
        tifffile.imwrite(path, stored, photometric="minisblack")
    elif path.suffix == ".pfm":
        height, width = stored.shape
        path.write_bytes(f"Pf\n{width} {height}\n-0.003922\n".encode() + stored[::-1].astype("<f4").tobytes())
    else:
        Image.fromarray(stored).save(path)


@pytest.mark.parametrize("name", ["a.png", "a.tif", "a.npy", "a.pfm"])
def test_disparity_is_what_stereo_has(tmp_path, name):
    # Middlebury: Z = baseline * f / (d + doffs), f and d in pixels; what is not known is infinite.
    product, offset = 0.193 * 3997.7, 131.1
    stored = LEVELS.astype(np.uint16 if name == "a.png" else np.float32)
    if stored.dtype.kind == "f":
        stored[0, 0] = np.inf
    save(tmp_path / name, stored)
    found = read_depth(tmp_path / name, disparity=(product, offset), unknown=[np.inf])
    for at in ((0, 1), (0, 2), (1, 0), (1, 2)):
        assert found[at] == pytest.approx(0.193 * 3997.7 / (float(stored[at]) + 131.1))
    assert np.isnan(found[0, 0]) == (stored.dtype.kind == "f")
    with pytest.raises(ValueError, match=r"disparities > 0 \(the offset is 0\), got 0; .* state it as `unknown`"):
        read_depth(tmp_path / name, disparity=(product, 0.0), unknown=[np.inf])
    known = read_depth(tmp_path / name, disparity=(product, 0), unknown=[0, np.inf])
    assert np.isnan(known[0, 1])
    assert known[1, 1] == pytest.approx(product / 64.0)
    with pytest.raises(ValueError, match=r"disparities > 1 \(the offset is -1\), got 0; if that means"):
        read_depth(tmp_path / name, disparity=(product, -1.0), unknown=[np.inf])
    with pytest.raises(ValueError, match=r"disparities > 1 \(the offset is -1\), got 1; .* state it as `unknown`"):
        read_depth(tmp_path / name, disparity=(product, -1.0), unknown=[np.inf, 0.0])
    if stored.dtype.kind == "f":
        with pytest.raises(ValueError, match=r"finite disparities .*, got inf; .* state it as `unknown`"):
            read_depth(tmp_path / name, disparity=(product, offset))


@pytest.mark.parametrize("kind", [np.int32, np.uint32, np.int16])
def test_levels_of_32_bits_are_scaled(tmp_path, kind):
    save(tmp_path / "a.tif", np.array([[1000, 30000], [2500, 4]], kind))
    np.testing.assert_allclose(read_depth(tmp_path / "a.tif", scale=1e-3), [[1.0, 30.0], [2.5, 0.004]])
    with pytest.raises(ValueError, match=f"{np.dtype(kind)}; `inverse` is for uint8, uint16 and floats of 0 to 1"):
        read_depth(tmp_path / "a.tif", inverse=(0.5, 4.0))


@pytest.mark.parametrize(
    ("options", "error", "said"),
    [
        ({"scale": 1e-3, "inverse": (1, 2)}, ValueError, "one of `scale`, `inverse` and `disparity`"),
        ({"disparity": (9, 1), "inverse": (1, 2)}, ValueError, "one of `scale`, `inverse` and `disparity`"),
        ({"scale": 1, "disparity": (9, 1)}, ValueError, "one of `scale`, `inverse` and `disparity`"),
        ({"inverse": (2, 1)}, ValueError, "inverse must be > 2 metres, got 1"),
        ({"inverse": (0, 1)}, ValueError, "inverse must be > 0 metres, got 0"),
        ({"inverse": 2.0}, TypeError, "inverse must be two numbers, got 2.0"),
        ({"disparity": (0, 1)}, ValueError, "disparity must be > 0 metres times pixels"),
        ({"disparity": (1, np.inf)}, ValueError, "disparity must be finite"),
        ({"resample": "nearest"}, ValueError, "resample needs the shape"),
        ({"resample": "linear", "shape": (4, 6)}, ValueError, "resample must be one of"),
        ({"depth_scale": 1.0}, TypeError, r"read_depth\(\) has no option 'depth_scale'"),
        ({}, PhotoError, "give the scale, e.g. scale=0.001 for millimetres, or `inverse` or `disparity`"),
    ],
)
def test_what_contradicts_itself_is_refused(tmp_path, options, error, said):
    save(tmp_path / "a.png", LEVELS)
    with pytest.raises(error, match=said):
        read_depth(tmp_path / "a.png", **options)


def test_shares_of_more_than_all_are_refused(tmp_path):
    for stored in (np.array([[0.5, 1.01]]), np.array([[0.5, -1.0]])):
        save(tmp_path / "a.npy", stored)
        with pytest.raises(ValueError, match=r"must hold 0 to 1 for `inverse`, got .*; divide by the largest"):
            read_depth(tmp_path / "a.npy", inverse=(0.5, 4.0))
    assert read_depth(tmp_path / "a.npy", inverse=(0.5, 4.0), unknown=[-1])[0, 0] == pytest.approx(1 / 1.125)


def test_maps_of_0_to_1_in_metres_are_told(tmp_path):
    save(tmp_path / "a.npy", np.array([[0.2, 1.0]]))
    with pytest.warns(UserWarning, match=r"farthest depth of .*a.npy is exactly 1: .* `inverse` states"):
        read_depth(tmp_path / "a.npy")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        read_depth(tmp_path / "a.npy", scale=1.0)
        read_depth(tmp_path / "a.npy", inverse=(1.0, 2.0))


def test_grey_in_three_channels_is_grey(tmp_path):
    for suffix in (".png", ".tif"):
        for stored in (LEVELS, 100 * LEVELS.astype(np.uint16)):
            path = tmp_path / f"a{suffix}"
            three = np.repeat(stored[..., None], 3, axis=2)
            if suffix == ".tif":
                tifffile.imwrite(path, three, photometric="rgb")
            else:
                path.write_bytes(png(three, 2))
            found = read_depth(path, scale=0.5, unknown=0)
            np.testing.assert_array_equal(found, np.where(stored == 0, np.nan, 0.5 * stored))
            three[1, 2, 1] += 1
            if suffix == ".tif":
                tifffile.imwrite(path, three, photometric="rgb")
            else:
                path.write_bytes(png(three, 2))
            with pytest.raises(PhotoError, match="it is in colour: its three channels differ, and a depth map"):
                read_depth(path, scale=0.5, unknown=0)


@pytest.mark.parametrize("shape", [(8, 12), (7, 11), (24, 36), (5, 8), (4, 6), (3, 4)])
def test_a_map_of_another_size_takes_the_nearest(tmp_path, shape):
    stored = np.arange(1.0, 25.0).reshape(4, 6)
    save(tmp_path / "a.npy", stored)
    if shape != (4, 6):
        width = f"{shape[1]} x {shape[0]}"
        with pytest.raises(
            ValueError, match=rf'size of the upright photo, {width}, got 6 x 4, of .* resample="nearest" resamples it'
        ):
            read_depth(tmp_path / "a.npy", shape=shape)
    found = read_depth(tmp_path / "a.npy", shape=(*shape, 3), resample="nearest")
    assert found.shape == shape
    for row in range(shape[0]):
        for column in range(shape[1]):
            place = int((row + 0.5) / shape[0] * 4), int((column + 0.5) / shape[1] * 6)
            assert found[row, column] == stored[place]


def test_edges_are_not_mixed_and_unknown_stays_unknown(tmp_path):
    stored = np.array([[1.5, 9.0], [np.nan, 9.0]])
    save(tmp_path / "a.npy", stored)
    found = read_depth(tmp_path / "a.npy", shape=(6, 6), resample="nearest")
    assert set(found[:3].ravel().tolist()) == {1.5, 9.0}
    assert np.isnan(found[3:, :3]).all()
