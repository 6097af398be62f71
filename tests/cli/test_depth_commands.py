"""`lommel depth` and `lommel precision`, run as a user runs them."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest
import tifffile

import lommel as lm
from lommel.cli import photo_commands
from lommel.fit.findings import Finding, Findings
from planes import PAIR, PIXEL, shoot, texture

LENS = """
name = "35 mm lens"
[lens]
focal_length = "35 mm"
f_number = 8.0
wavelength = "540 nm"
[sensor]
pixel = "4 um"
shape = 33
"""
FOCI = ["--focus", "1.35 m", "--focus", "1.8 m"]
CAMERA = ["--between", "1.2 m", "2 m", "--white", 1e4, "--read", 3]


@pytest.fixture
def folder(tmp_path):
    """A lens file and two photographs of a plane at 1.5 m."""
    (tmp_path / "lens.toml").write_text(LENS, encoding="utf-8")
    for name, image in zip(("near", "far"), shoot(texture(), 1.5, PAIR), strict=True):
        tifffile.imwrite(tmp_path / f"{name}.tif", image.astype(np.float32))
    return tmp_path


def test_depth_deviation_sharp_image_and_picture_are_written_and_told(folder, call_lommel):
    result = call_lommel(
        "depth", "near.tif", "far.tif", "lens.toml", *FOCI, *CAMERA, "-o", "depth.tif", "-o", "error.npy",
        "--sharp", "sharp.tif", "--plot", "found.png", folder=folder,
    )  # fmt: skip
    assert result.returncode == 0, result.stderr
    lines = result.stdout.splitlines()
    assert "0.01 dioptre of all focus distances by 23 mm" in " ".join(lines)
    assert lines[-4:] == [f"wrote {name}" for name in ("depth.tif", "error.npy", "sharp.tif", "found.png")]
    depth, errors = lm.imaging.read_depth(folder / "depth.tif"), lm.imaging.read_depth(folder / "error.npy")
    assert np.nanmedian(depth) == pytest.approx(1.5, abs=2e-3)
    assert 5e-4 < np.median(errors) < 1e-2
    assert tifffile.imread(folder / "sharp.tif").shape == (112, 112)
    found = lm.imaging.depth_from_defocus(
        [tifffile.imread(folder / f"{name}.tif") for name in ("near", "far")], PAIR, PIXEL, encoding="linear",
        noise=lm.Noise(white=1e4, read=3.0), between=(1.2, 2.0),
    )  # fmt: skip
    assert np.array_equal(depth, found.depth.astype(np.float32), equal_nan=True)


@pytest.mark.parametrize("severity", ["doubt", "error"])
def test_a_calibration_is_written_unless_it_contradicts_the_planes(severity, folder, call_lommel, monkeypatch):
    text = "the lens is 16 standard errors from the stated one"
    found = lm.imaging.FocalCalibration(
        findings=Findings([Finding("contradiction", severity, text)]), summary="", lenses=tuple(PAIR),
        f_number_scale=2.0, f_number_error=0.4, focus_shifts=(0.0, 0.0), focus_error=0.1, origin=0.0,
        origin_error=0.0, covariance=np.eye(4), planes=(),
    )  # fmt: skip
    monkeypatch.setattr(lm.imaging, "calibrate_focus", lambda *_, **__: found)
    arguments = "calibrate", "near.tif", "far.tif", "lens.toml", *FOCI, "--distance", "1.5m", "-o", "mine.toml"
    result = call_lommel(*arguments, folder=folder)
    assert text in result.stdout
    assert result.returncode == (3 if severity == "error" else 4)
    assert (folder / "mine.toml").exists() == (severity == "doubt")
    assert ("mine.toml is not written" in result.stdout) == (severity == "error")
    assert ("wrote mine.toml" in result.stdout) == (severity == "doubt")


def test_errors_of_the_lens_are_part_of_the_deviation(folder, call_lommel):
    arguments = "depth", "near.tif", "far.tif", "lens.toml", *FOCI, *CAMERA, "--json"
    plain, more = (
        json.loads(call_lommel(*arguments, *options, folder=folder).stdout)
        for options in ([], ["--f-number-error", 0.05, "--focus-error", 0.01])
    )
    assert (plain["error_of"], more["error_of"]) == ("noise", "noise and lens")
    assert plain["lens_error"]["nearest"][1] > more["lens_error"]["nearest"][1] > 0.01
    assert more["error"] > 0.01 * 1.5**2 / 2**0.5 > plain["error"]
    assert plain["changes"][1] == pytest.approx(-0.01 * 1.5**2, rel=0.05)


def test_masks_leave_pixels_out_and_json_is_that_of_python(folder, call_lommel):
    photos = [tifffile.imread(folder / f"{name}.tif") for name in ("near", "far")]
    masks = np.zeros((2, 112, 112), dtype=np.uint8)
    masks[1, 50:60, 40:48] = 1
    photos[1][50:60, 40:48] = 0.9  # a reflection
    tifffile.imwrite(folder / "far.tif", photos[1])
    tifffile.imwrite(folder / "mask.tif", masks, photometric="minisblack")
    arguments = "depth", "near.tif", "far.tif", "lens.toml", *FOCI, *CAMERA, "--json", "-o", "depth.tif"
    told = json.loads(call_lommel(*arguments, "--mask", "mask.tif", folder=folder).stdout)
    found = lm.imaging.depth_from_defocus(
        [photos[0], np.ma.masked_array(photos[1], masks[1])], PAIR, PIXEL, encoding="linear",
        noise=lm.Noise(white=1e4, read=3.0), between=(1.2, 2.0),
    )  # fmt: skip
    assert np.isnan(found.depth[52:58, 42:46]).all()
    assert told.items() >= found.to_dict().items()
    depth = lm.imaging.read_depth(folder / "depth.tif")
    assert np.array_equal(depth, found.depth.astype(np.float32), equal_nan=True)


@pytest.mark.parametrize(("largest", "dtype", "told"), [
    (4095, np.uint16, "the largest is 4095, but white (--white) is 65535"), (40000, np.uint16, ""),
    (90, np.uint8, "the largest is 90, but white (--white) is 255"), (0.01, np.float32, ""),
])  # fmt: skip
def test_integers_of_less_than_half_of_their_type_are_told_with_what_is_white(largest, dtype, told):
    text = photo_commands._white_of([np.full((4, 4), level, dtype) for level in (largest, 0)])
    assert told in text
    assert bool(text) == bool(told)


def test_the_value_of_few_bits_that_is_taken_as_saturated_is_told():
    photo = np.full((8, 8), 1000, np.uint16)
    photo[2, :5] = 4095
    assert photo_commands._white_of([photo, photo // 2]).endswith(": 4095 is taken as saturated (--mask)")
    photo[2, 1:5] = 1000
    assert photo_commands._white_of([photo]).endswith(": no smaller value is taken as saturated (--mask)")


def test_precision_is_a_table_and_a_picture(folder, call_lommel):
    options = ["lens.toml", "--focus", "1.5 m", "--photons", 1e4]
    result = call_lommel("precision", *options, "--pair", 0.1, "--plot", "precision.png", folder=folder)
    assert result.returncode == 0, result.stderr
    assert "1.3043 m, 1.7647 m" in result.stdout
    assert (folder / "precision.png").stat().st_size > 10_000
    found = json.loads(call_lommel("precision", *options, "--pair", 0.1, "--json", folder=folder).stdout)
    lens = PAIR[0]
    foci = [1.0 / (1.0 / 1.5 + 0.1), 1.0 / (1.0 / 1.5 - 0.1)]
    expected = lm.depth_precision(
        [lens.focused(focus) for focus in foci], found["distance"], PIXEL, noise=lm.Noise(white=1e4, read=3.0)
    )
    assert found["errors"] == pytest.approx(expected.tolist(), rel=1e-6)
    best = json.loads(call_lommel("precision", *options, "--best", "--json", folder=folder).stdout)
    foci = [one.focus_distance for one in lm.best_depth_foci(lens, 1.5, PIXEL, noise=lm.Noise(white=1e4, read=3.0))]
    assert best["focus_distances"] == pytest.approx(foci)


def test_no_noise_needs_to_be_stated_and_half_of_it_is_refused(folder, call_lommel):
    arguments = "depth", "near.tif", "far.tif", "lens.toml", *FOCI, "--between", "1.2 m", "2 m"
    result = call_lommel(*arguments, "-o", "depth.tif", folder=folder)
    assert result.returncode == 0, result.stderr
    text = " ".join(result.stdout.split())
    white, read = re.search(
        r"noise estimated from the images: white (\S+), read noise (\S+) electrons", text
    ).groups()
    mean = 0.5 * float(white)
    assert mean**2 / (mean + float(read) ** 2) == pytest.approx(5000.0, rel=0.15)
    assert "registration and noise are not tested" in text
    assert np.nanmedian(lm.imaging.read_depth(folder / "depth.tif")) == pytest.approx(1.5, abs=2e-3)
    for options, missing in (
        (["--read", 3], "--white"),
        (["--white", 1e4], "--read"),
        (["--offset", 0.1], "--white"),
    ):
        assert f"{missing} is missing" in call_lommel(*arguments, *options, folder=folder).stderr
