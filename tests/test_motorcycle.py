"""The example scene, end to end: from the files that its script writes, through the command, to what must be seen."""

from __future__ import annotations

import runpy
from pathlib import Path

import numpy as np
import pytest
import tifffile
from PIL import Image

from lommel.imaging import read_depth, read_photo, write_photo

SCRIPT = Path(__file__).resolve().parent.parent / "examples" / "motorcycle.py"


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    folder = tmp_path_factory.mktemp("scene")
    runpy.run_path(str(SCRIPT))["write"](folder)
    return folder


def test_the_scene_has_the_depth_of_its_calibration(scene):
    depth = read_depth(scene / "motorcycle-depth.tif")
    assert depth.shape == read_photo(scene / "motorcycle.png").values.shape[:2] == (500, 741)
    assert (np.nanmin(depth), np.nanmax(depth)) == (pytest.approx(2.110, abs=1e-3), pytest.approx(5.017, abs=1e-3))
    assert np.isnan(depth).sum() == 27226


def test_what_is_in_focus_is_sharp_and_the_rest_is_not(call_lommel, scene, tmp_path):
    # Handlebar and headlight before the shelf.
    rows, columns = slice(60, 190), slice(430, 600)
    depth = read_depth(scene / "motorcycle-depth.tif")[rows, columns]
    light = read_photo(scene / "motorcycle.png").light()[rows, columns]
    tifffile.imwrite(tmp_path / "depth.tif", depth, photometric="minisblack")
    write_photo(tmp_path / "photo.png", light)
    camera = ("--focal-length", "48.34mm", "--pixel", "48.58um", "--missing", "nearest", "--tol", "1e-3")

    def blurred(focus: str, stop: float) -> np.ndarray:
        result = call_lommel("blur", "photo.png", "depth.tif", *camera, "--focus", focus, "--f-number", stop,
                             "-o", "out.png", folder=tmp_path)  # fmt: skip
        assert result.returncode == 0, result.stderr
        return np.asarray(Image.open(tmp_path / "out.png")).astype(float)

    def contrast(picture: np.ndarray, where: np.ndarray) -> float:
        return float(np.abs(np.diff(picture[..., 1], axis=1))[where[:, 1:]].mean())

    near, far = depth < 2.6, depth > 3.5
    assert min(near.sum(), far.sum()) > 1000
    machine, shelf, stopped = blurred("2.4 m", 1.4), blurred("4.6 m", 1.4), blurred("3 m", 16)
    sharp = read_photo(tmp_path / "photo.png").values.astype(float)
    assert contrast(machine, near) > 1.5 * contrast(shelf, near)
    assert contrast(shelf, far) > 1.2 * contrast(machine, far)
    for where in (near, far):
        assert contrast(stopped, where) > 0.8 * contrast(sharp, where)
    # Light is neither made nor lost, but for what crosses the border of the crop.
    for stop in ("2.4 m", "4.6 m"):
        blurred(stop, 1.4)
        assert read_photo(tmp_path / "out.png").light().mean() == pytest.approx(light.mean(), rel=0.02)


def test_what_was_blurred_is_restored(call_lommel, scene, tmp_path):
    # The bench and the boards behind the saddle, out of focus in a photograph of the machine.
    rows, columns = slice(60, 160), slice(100, 230)
    depth = read_depth(scene / "motorcycle-depth.tif")[rows, columns]
    picture = read_photo(scene / "motorcycle.png")
    tifffile.imwrite(tmp_path / "depth.tif", depth, photometric="minisblack")
    write_photo(tmp_path / "photo.png", picture.light()[rows, columns])
    camera = ("--focal-length", "48.34mm", "--pixel", "48.58um", "--missing", "nearest", "--f-number", 0.95)
    noise = ("--focus", "2.4m", "--white", 50000, "--read", 3)
    for command in (("blur", "photo.png", "depth.tif", "-o", "near.png", *noise[:2]),
                    ("restore", "near.png", "depth.tif", "-o", "sharp.png", *noise)):  # fmt: skip
        result = call_lommel(*command, *camera, folder=tmp_path)
        assert result.returncode == 0, result.stderr
    assert "the rest is noise" in result.stdout
    truth = picture.values[rows, columns].astype(float)
    pictures = [np.asarray(Image.open(tmp_path / name)) for name in ("near.png", "sharp.png")]
    off = [np.sqrt(np.mean((made - truth)[8:-8, 8:-8] ** 2)) for made in pictures]
    assert off[1] < 0.85 * off[0]
