"""`lommel restore`, run as a user runs it, and its files read back."""

from __future__ import annotations

import json
import subprocess

import numpy as np
import pytest
import tifffile
from PIL import Image
from scipy.ndimage import convolve

import lommel as lm
from lommel.base.encoding import from_light
from lommel.imaging import FieldBlur, RichardsonLucy, TotalVariation, depth_of_field, restore
from scenes import POINTS, averaged, texture

LENS = """\
[lens]
focal_length = "50 mm"
f_number = 2.8
focus_distance = "2 m"
wavelength = "550 nm"
[sensor]
pixel = "8 um"
shape = 33
"""
OPTICS = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
DEPTH = np.where(np.arange(56) < 26, 2.5, 2.1) * np.ones((48, 1))
SCENE = np.random.default_rng(0).uniform(0.05, 0.8, (6, 7, 3)).repeat(8, axis=0).repeat(8, axis=1)
NOISE = lm.Noise(white=5000.0, read=3.0)
GIVEN = ("--white", 5000, "--read", 3)


def error(light: np.ndarray) -> float:
    return float(np.sqrt(np.mean((light - SCENE)[6:-6, 6:-6] ** 2)))


@pytest.fixture
def folder(tmp_path):
    light = depth_of_field(SCENE, DEPTH, OPTICS, 8e-6, encoding="linear", energy=0.995).values
    photo = np.moveaxis(NOISE.record(np.moveaxis(5000.0 * light, 2, 0), seed=1), 0, 2)
    tifffile.imwrite(tmp_path / "photo.tif", photo.astype(np.float32), photometric="rgb")
    Image.fromarray(from_light(np.clip(photo, 0.0, 1.0), "srgb", np.uint8)).save(tmp_path / "photo.png")
    np.save(tmp_path / "depth.npy", DEPTH)
    np.save(tmp_path / "small.npy", DEPTH[1:])
    (tmp_path / "lens.toml").write_text(LENS)
    return tmp_path


def ran(result: subprocess.CompletedProcess[str], code: int = 0) -> str:
    assert result.returncode == code, result.stderr
    assert result.stderr == ""
    return result.stdout


@pytest.mark.parametrize("way", [RichardsonLucy(), TotalVariation()])
def test_a_shell_restores_a_photo_as_python_does(call_lommel, folder, way):
    options = ("--method", "total-variation") if isinstance(way, TotalVariation) else ()
    arguments = ("restore", "photo.tif", "depth.npy", "lens.toml", *GIVEN, *options)
    told = ran(call_lommel(*arguments, "-o", "sharp.tif", folder=folder))
    photo, sharp = (tifffile.imread(folder / name) for name in ("photo.tif", "sharp.tif"))
    same = restore(photo, DEPTH, OPTICS, 8e-6, encoding="linear", noise=NOISE, method=way)
    np.testing.assert_array_equal(sharp, same.values)
    assert error(sharp) < 0.8 * error(photo)
    assert "float values, assumed linear; if they are sRGB, give --encoding srgb\n" in told
    assert "wrote sharp.tif" in told.splitlines()
    facts = json.loads(ran(call_lommel(*arguments, "--json", "-o", "sharp.tif", folder=folder)))
    assert facts.items() >= same.to_dict().items()
    assert (facts["before"], facts["discrepancy"]) == (same.before, same.discrepancy)
    assert (facts["steps"], facts["stopped"], facts["strength"]) == (same.steps, "noise", same.strength)
    assert (facts["unknown"], facts["files"]) == (0.0, ["sharp.tif"])


def test_a_mask_leaves_pixels_out(call_lommel, folder):
    photo, out = np.array(Image.open(folder / "photo.png")), np.zeros(DEPTH.shape, np.uint8)
    photo[20:23, 30:33], out[20:23, 30:33] = 240, 255  # a reflection
    for name, values in (("photo", photo), ("mask", out)):
        Image.fromarray(values).save(folder / f"{name}.png")
    arguments = ("restore", "photo.png", "depth.npy", "lens.toml", *GIVEN, "--json", "-o", "sharp.tif")
    facts = json.loads(ran(call_lommel(*arguments, "--mask", "mask.png", folder=folder)))
    assert facts["unknown"] == pytest.approx(9 / DEPTH.size)
    hidden = np.broadcast_to(out[..., None] != 0, photo.shape)
    ways = {"encoding": "srgb", "noise": NOISE}
    seen, same = (restore(one, DEPTH, OPTICS, 8e-6, **ways) for one in (photo, np.ma.masked_array(photo, hidden)))
    assert facts["discrepancy"] == pytest.approx(same.discrepancy)
    assert same.discrepancy < seen.discrepancy


def test_a_focus_that_is_wrong_is_told(call_lommel, folder):
    wrong = ("--white", 80000, "--read", 3, "--focus", "1.9 m")
    arguments = ("restore", "photo.tif", "depth.npy", "lens.toml", *wrong, "--json", "-o", "a.tif")
    facts = json.loads(ran(call_lommel(*arguments, folder=folder), code=3))
    assert [each["code"] for each in facts["findings"]] == ["misfit"]


def test_saturated_pixels_are_counted(call_lommel, folder):
    arguments = ("restore", "photo.tif", "depth.npy", "lens.toml", *GIVEN, "-o", "sharp.tif")
    unknown = np.mean(tifffile.imread(folder / "photo.tif") >= 0.5)
    facts = json.loads(ran(call_lommel(*arguments, "--saturation", 0.5, "--json", folder=folder)))
    assert facts["unknown"] == pytest.approx(unknown)


def test_linear_integers_are_taken_as_stated(call_lommel, folder):
    photo = tifffile.imread(folder / "photo.tif")
    tifffile.imwrite(folder / "raw.tif", np.rint(65535 * np.clip(photo, 0, 1)).astype(np.uint16), photometric="rgb")
    arguments = ("restore", "raw.tif", "depth.npy", "lens.toml", *GIVEN, "--encoding", "linear")
    told = ran(call_lommel(*arguments, "-o", "sharp.tif", folder=folder))
    assert "16-bit values, linear\n" in told
    same = restore(tifffile.imread(folder / "raw.tif"), DEPTH, OPTICS, 8e-6, encoding="linear", noise=NOISE)
    np.testing.assert_array_equal(tifffile.imread(folder / "sharp.tif"), same.values)


def test_one_distance_is_stated_or_estimated(call_lommel, folder):
    rng = np.random.default_rng(3)
    scene = rng.uniform(0.05, 0.8, (24, 24)).repeat(4, axis=0).repeat(4, axis=1)
    light = depth_of_field(scene, np.full(scene.shape, 2.2), OPTICS, 8e-6, encoding="linear").values
    photo = NOISE.record(5000.0 * light, seed=1).astype(np.float32)
    tifffile.imwrite(folder / "grey.tif", photo)
    arguments = ("restore", "grey.tif", "lens.toml", *GIVEN, "--json", "-o", "sharp.tif")
    facts = json.loads(ran(call_lommel(*arguments, "--at", "2.2m", folder=folder)))
    same = restore(photo, 2.2, OPTICS, 8e-6, encoding="linear", noise=NOISE)
    np.testing.assert_array_equal(tifffile.imread(folder / "sharp.tif"), same.values)
    assert (facts["method"], facts["stopped"]) == ("default", "one pass")
    unknown = json.loads(ran(call_lommel(*arguments, "--at", "unknown", folder=folder)))
    errors = np.abs(np.array(unknown["distances"]) - 2.2) / unknown["distance_errors"]
    assert errors.min() < 3.0
    wide = call_lommel(*arguments[:-3], "-o", "sharp.tif", "--at", "2.5m", folder=folder)
    assert "--accept restores by that blur" in " ".join(wide.stdout.split())
    neither = call_lommel("restore", "grey.tif", *GIVEN, "--focus", "2m", "-o", "a.tif", folder=folder)
    assert "give a depth map DEPTH, or --at" in neither.stderr
    both = call_lommel(
        "restore", "grey.tif", "depth.npy", "lens.toml", *GIVEN, "--at", "2m", "-o", "a.tif", folder=folder
    )
    assert "DEPTH cannot be combined with --at" in both.stderr


def test_photo_alone_is_restored_by_a_blur_of_unknown_size(call_lommel, folder):
    y, x = (np.minimum(k, 128 * POINTS - k) for k in np.ogrid[: 128 * POINTS, : 128 * POINTS])
    disc = np.fft.rfft2(np.hypot(y, x) < 3.5 * POINTS)
    scene = texture("leaves", 128, 7, 0.4)
    seen = averaged(np.fft.irfft2(np.fft.rfft2(scene) * disc / disc[0, 0].real, scene.shape)) / 3.0
    noise = lm.Noise(white=20000.0, read=3.0)
    photo = noise.record(20000.0 * seen, seed=1).astype(np.float32)
    tifffile.imwrite(folder / "grey.tif", photo)
    arguments = ("restore", "grey.tif", "--white", 20000, "--read", 3, "--json", "-o", "sharp.tif")
    facts = json.loads(ran(call_lommel(*arguments, folder=folder)))
    same = restore(photo, "unknown", encoding="linear", noise=noise)
    np.testing.assert_array_equal(tifffile.imread(folder / "sharp.tif"), same.values)
    assert facts["findings"][-1]["numbers"] == same.findings.get("blur_shape").numbers
    assert "focal_length" not in facts


def test_a_field_is_undone_by_its_table(call_lommel, folder):
    field = lm.FieldMap.from_seidel(
        5e-4, W131=1.5, W222=1.0, W020=1.5, wavelength=550e-9, f_number=OPTICS.working_f_number
    )
    field.save(folder / "field.csv")
    scene = np.random.default_rng(5).uniform(0.05, 0.8, (20, 24)).repeat(4, axis=0).repeat(4, axis=1)
    light = FieldBlur(field, scene.shape, 8e-6, energy=0.995).forward(scene.astype(np.float32))
    photo = NOISE.record(5000.0 * light, seed=2).astype(np.float32)
    tifffile.imwrite(folder / "grey.tif", photo)
    arguments = ("restore", "grey.tif", "lens.toml", *GIVEN, "--json", "-o", "sharp.tif")
    facts = json.loads(ran(call_lommel(*arguments, "--field", "field.csv", folder=folder)))
    assert facts["stopped"] == "one pass"
    sharp = tifffile.imread(folder / "sharp.tif")
    inner = np.s_[6:-6, 6:-6]
    assert np.std((sharp - scene)[inner]) < 0.75 * np.std((photo - scene)[inner])
    both = call_lommel(*arguments, "--field", "field.csv", "--at", "2m", folder=folder)
    assert "--at cannot be combined with --field" in both.stderr


def test_a_measured_psf_needs_no_lens(call_lommel, folder):
    rng = np.random.default_rng(7)
    window = np.outer(np.hanning(9)[1:-1], np.hanning(13)[1:-1])
    scene = rng.uniform(0.05, 0.8, (18, 18)).repeat(4, axis=0).repeat(4, axis=1)
    photo = NOISE.record(5000.0 * convolve(scene, window / window.sum(), mode="reflect"), seed=1).astype(np.float32)
    tifffile.imwrite(folder / "grey.tif", photo)
    star = np.pad(0.5 * window, ((12, 12), (10, 10)))
    tifffile.imwrite(folder / "star.tif", star.astype(np.float32))
    arguments = ("restore", "grey.tif", *GIVEN, "--psf", "star.tif", "-o", "sharp.tif")
    facts = json.loads(ran(call_lommel(*arguments, "--json", folder=folder)))
    assert (facts["stopped"], "focal_length" in facts) == ("one pass", False)
    assert facts["psf_read"].startswith("float values, assumed linear")
    inner, sharp = np.s_[6:-6, 6:-6], tifffile.imread(folder / "sharp.tif")
    assert np.std((sharp - scene)[inner]) < 0.75 * np.std((photo - scene)[inner])
    Image.fromarray((255 * star / star.max()).astype(np.uint8)).save(folder / "full.png")
    for more, message in (
        (("--at", "2m"), "--at cannot be combined with --psf"),
        (("--focus", "2m"), "--focus cannot be combined with --psf"),
    ):
        assert message in call_lommel(*arguments, *more, folder=folder).stderr
    given = "restore", "grey.tif", "lens.toml", *GIVEN, "--psf", "star.tif", "-o", "a.tif"
    assert "a lens cannot be combined with --psf" in call_lommel(*given, folder=folder).stderr
    given = "restore", "grey.tif", *GIVEN, "--psf", "full.png", "-o", "a.tif"
    assert "--psf must not be saturated" in call_lommel(*given, folder=folder).stderr
    given = "restore", "grey.tif", *GIVEN, "--psf", "grey.tif", "-o", "a.tif"
    assert "--psf grey.tif must show a peak" in call_lommel(*given, folder=folder).stderr
