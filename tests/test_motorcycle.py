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


def test_what_was_blurred_is_restored(call_lommel, scene, tmp_path):
    # The bench and the boards behind the saddle, out of focus in a photograph of the machine.
    rows, columns = slice(60, 160), slice(100, 230)
    depth = read_depth(scene / "motorcycle-depth.tif")[rows, columns]
    picture = read_photo(scene / "motorcycle.png")
    tifffile.imwrite(tmp_path / "depth.tif", depth, photometric="minisblack")
    write_photo(tmp_path / "photo.png", picture.light()[rows, columns])
    (tmp_path / "lens.toml").write_text(
        '[lens]\nfocal_length = "48.34 mm"\nf_number = 0.95\nwavelength = "540 nm"\n[sensor]\npixel = "48.58 um"\n'
    )
    camera = ("lens.toml", "--missing", "nearest")
    noise = ("--focus", "2.4m", "--white", 50000, "--read", 3)
    for command in (("blur", "photo.png", "depth.tif", *camera, "-o", "near.png", *noise[:2]),
                    ("restore", "near.png", "depth.tif", *camera, "-o", "sharp.png", *noise)):  # fmt: skip
        result = call_lommel(*command, folder=tmp_path)
        assert result.returncode == 0, result.stderr
    assert "noise" in next(line for line in result.stdout.splitlines() if line.startswith("stopped"))
    truth = picture.values[rows, columns].astype(float)
    pictures = [np.asarray(Image.open(tmp_path / name)) for name in ("near.png", "sharp.png")]
    off = [np.sqrt(np.mean((made - truth)[8:-8, 8:-8] ** 2)) for made in pictures]
    assert off[1] < 0.85 * off[0]
