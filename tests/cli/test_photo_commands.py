"""`lommel blur`, run as a user runs it, and its files read back."""

from __future__ import annotations

import json
import math
import re
import shutil
import subprocess
from types import SimpleNamespace

import numpy as np
import pytest
import tifffile
from PIL import Image

import lommel as lm
from lommel import imaging
from lommel.base.encoding import from_light, to_light
from lommel.cli import video_commands
from lommel.imaging import depth_of_field
from lommel.imaging.defocus_verdict import DefocusVerdict
from lommel.io.depth_maps import fill_missing

LENS = """\
name = "soft"
[lens]
focal_length = "50 mm"
f_number = 2
focus_distance = "2 m"
wavelength = "550 nm"
[aberrations]
W040 = 3.0
[sensor]
pixel = "40 um"
shape = 33
"""
FIELD = '[field]\nsensor = ["2 mm", "2 mm"]\nW131 = 0.1\n'
PLAIN = LENS.replace("550", "540").replace("W040 = 3.0", "")
GIVEN = ("plain.toml",)
PAIR = "--focus 1m --focus 2m --between 1m 3m"
RNG = np.random.default_rng(7)
# Noise of one colour: formats for pictures keep light better than colour.
PHOTO = (RNG.integers(40, 200, (30, 36, 1)) * [1.0, 0.8, 0.6]).astype(np.uint8)
DEPTH = 1.9 + 0.3 * np.linspace(0.0, 1.0, 30 * 36).reshape(30, 36)
BAD = [
    ("blur alpha.png depth.npy lens.toml -o out.png", "it has alpha that is not opaque everywhere; put it on"),
    ("blur photo.png small.npy lens.toml -o out.png", "must have the size of the upright photo, 36 x 30, got"),
    ("blur photo.png depth.png lens.toml -o out.png", "depth.png is an integer image; give the scale, e.g."),
    ("blur --batch . . lens.toml -o set --supersample 2", "--supersample is an option for a single photo"),
]


def exif(f_number: float) -> bytes:
    tags = Image.Exif()
    tags[0x8769] = {0x920A: 50.0, 0x829D: f_number}
    return tags.tobytes()


@pytest.fixture
def folder(tmp_path):
    Image.fromarray(PHOTO).save(tmp_path / "photo.png")
    Image.fromarray(PHOTO).save(tmp_path / "camera.png", exif=exif(2.0))
    Image.fromarray(PHOTO[..., 0]).save(tmp_path / "grey.png")
    Image.fromarray(np.round(DEPTH * 1000).astype(np.uint16)).save(tmp_path / "depth.png")
    Image.new("RGBA", (36, 30)).save(tmp_path / "alpha.png")
    np.save(tmp_path / "depth.npy", DEPTH)
    np.save(tmp_path / "small.npy", DEPTH[1:])
    (tmp_path / "lens.toml").write_text(LENS)
    (tmp_path / "plain.toml").write_text(PLAIN)
    return tmp_path


def expected(image: np.ndarray = PHOTO, depth: np.ndarray = DEPTH, **changes: object) -> np.ndarray:
    lens = {"focal_length": 50e-3, "f_number": 2.0, "focus_distance": 2.0, "wavelength": 540e-9}
    lens |= {name: changes.pop(name) for name in list(changes) if name in (*lens, "aberrations")}
    options = {"pixel": 40e-6, "encoding": "linear"} | changes
    light = to_light("image", image, "srgb", np.float32)
    blurred = depth_of_field(light, depth, lm.Lens(**lens), **options).values
    return from_light(np.clip(blurred, 0.0, 1.0), "srgb", image.dtype)


def ran(result: subprocess.CompletedProcess[str]) -> str:
    assert result.returncode == 0, result.stderr
    assert result.stderr == ""
    return result.stdout


def test_a_shell_blurs_a_photo_as_python_does(run_lommel, folder):
    told = ran(run_lommel("blur", "photo.png", "depth.npy", *GIVEN, "-o", "out.png", folder=folder))
    assert "8-bit values, assumed sRGB; if they are linear, give --encoding linear\n" in told
    assert told.splitlines()[-1] == "wrote out.png"
    np.testing.assert_array_equal(np.asarray(Image.open(folder / "out.png")), expected())


def test_a_lens_file_has_its_aberrations_and_they_shrink_with_the_stop(call_lommel, folder):
    arguments = ("blur", "photo.png", "depth.npy", "lens.toml")
    radius = 2.0 / 2.8
    stopped = lm.Wavefront.from_seidel(W040=3.0 * radius**4)
    for options, changes in (
        ([], {"aberrations": lm.Wavefront.from_seidel(W040=3.0)}),
        (["--f-number", "2.8"], {"f_number": 2.8, "aberrations": stopped}),
        (["--focus", "2.1m", "--tol", "1e-3"], {"focus_distance": 2.1, "tol": 1e-3}),
    ):
        ran(call_lommel(*arguments, *options, "-o", "out.png", folder=folder))
        wanted = {"wavelength": 550e-9, "aberrations": lm.Wavefront.from_seidel(W040=3.0)} | changes
        found = np.asarray(Image.open(folder / "out.png")).astype(int)
        assert np.abs(found - expected(**wanted)).max() <= 1


def test_exif_tells_what_no_option_does(call_lommel, folder):
    ran(call_lommel("blur", "camera.png", "depth.npy", "--focus", "2 m", "--pixel", "40um", "-o", "a.png",
                    folder=folder))  # fmt: skip
    np.testing.assert_array_equal(np.asarray(Image.open(folder / "a.png")), expected())


def test_the_range_of_depth_is_told_and_what_is_unknown(call_lommel, folder):
    low, high = DEPTH.min(), DEPTH.max()
    told = json.loads(
        ran(call_lommel("blur", "photo.png", "depth.npy", *GIVEN, "--json", "-o", "a.png", folder=folder))
    )
    assert told["depth"] == pytest.approx([low, high])
    stored = np.where(DEPTH < 2.0, -1.0, DEPTH)
    np.save(folder / "marked.npy", stored)
    asked = (*GIVEN, "--unknown", "-1", "--unknown", "255", "--missing", "nearest", "-o", "b.png", "--json")
    told = json.loads(ran(call_lommel("blur", "photo.png", "marked.npy", *asked, folder=folder)))
    assert told["depth"] == pytest.approx([DEPTH[DEPTH >= 2.0].min(), high])
    assert told["depth_unknown"] == pytest.approx((DEPTH < 2.0).mean())
    filled = expected(depth=fill_missing(np.where(DEPTH < 2.0, np.nan, DEPTH), "nearest"))
    np.testing.assert_array_equal(np.asarray(Image.open(folder / "b.png")), filled)


def test_inverse_depth_disparity_and_other_sizes_are_as_in_python(call_lommel, folder):
    stored = np.round(255 * (1.0 / DEPTH - 1.0 / 2.3) / (1.0 / 1.8 - 1.0 / 2.3)).astype(np.uint8)
    Image.fromarray(stored).save(folder / "inverse.png")
    Image.fromarray(np.round(8000 / DEPTH).astype(np.uint16)).save(folder / "disparity.png")
    Image.fromarray(stored[1::2, 1::2]).save(folder / "half.png")
    ways = {
        "inverse.png": (("--inverse-depth", "1.8m", "2.3m"), 1.0 / (stored / 255 * (1 / 1.8 - 1 / 2.3) + 1 / 2.3)),
        "disparity.png": (("--disparity", "8000", "0"), 8000.0 / np.round(8000 / DEPTH)),
    }
    for name, (options, depth) in ways.items():
        ran(call_lommel("blur", "photo.png", name, *GIVEN, *options, "-o", "a.png", folder=folder))
        found = np.asarray(Image.open(folder / "a.png")).astype(int)
        assert np.abs(found - expected(depth=depth)).max() <= 1
    resampled = ("--inverse-depth", "1.8m", "2.3m", "--resample", "nearest")
    ran(call_lommel("blur", "photo.png", "half.png", *GIVEN, *resampled, "-o", "b.png", folder=folder))
    half = np.repeat(np.repeat(ways["inverse.png"][1][1::2, 1::2], 2, axis=0), 2, axis=1)
    assert np.abs(np.asarray(Image.open(folder / "b.png")).astype(int) - expected(depth=half)).max() <= 1


def test_the_camera_and_the_date_stay_with_the_photo(call_lommel, folder):
    tags = Image.Exif()
    tags[0x010F], tags[0x0132], tags[0x0112] = "Canon", "2026:01:02 03:04:05", 1
    tags[0x8769] = {0xA434: "50mm f/2"}
    Image.fromarray(PHOTO).save(folder / "dated.jpg", exif=tags.tobytes())
    for name in ("a.jpg", "a.png", "a.tif"):
        ran(call_lommel("blur", "dated.jpg", "depth.npy", *GIVEN, "-o", name, folder=folder))
        with Image.open(folder / name) as file:
            found = file.getexif()
            assert (found[0x010F], found[0x0132]) == ("Canon", "2026:01:02 03:04:05")
            assert found.get_ifd(0x8769)[0xA434] == "50mm f/2"


@pytest.mark.parametrize(
    ("name", "dtype"), [("a.tif", np.uint8), ("deep.png", np.uint16), ("a.jpg", np.uint8), ("float.tif", np.float32)]
)
def test_the_output_has_the_bits_of_the_photo(call_lommel, folder, name, dtype):
    photo = PHOTO[..., 0]
    if dtype == np.uint16:
        photo = photo.astype(np.uint16) * np.uint16(257)
    elif dtype == np.float32:
        photo = to_light("photo", photo, "srgb", np.float32)
    tifffile.imwrite(folder / "given.tif", photo)
    told = ran(call_lommel("blur", "given.tif", "depth.npy", *GIVEN, "--json", "-o", name, folder=folder))
    values = tifffile.imread(folder / name) if name.endswith("tif") else np.asarray(Image.open(folder / name))
    assert values.dtype == dtype
    floats = values if dtype == np.float32 else values / np.iinfo(dtype).max
    light = floats if dtype == np.float32 else to_light("a", floats.astype(np.float64), "srgb", np.float64)
    as_eight = from_light(np.asarray(light), "srgb", np.uint8).astype(int)
    off = np.abs(as_eight - expected(PHOTO[..., 0]))
    assert off.max() <= (8 if name == "a.jpg" else 0)
    assert json.loads(told)["encoding"]["output"] == ("linear" if dtype == np.float32 else "srgb")


@pytest.mark.parametrize(("arguments", "error"), BAD, ids=[arguments for arguments, _ in BAD])
def test_bad_input_is_told_in_one_line_and_leaves_nothing_behind(call_lommel, folder, arguments, error):
    before = sorted(folder.rglob("*"))
    result = call_lommel(*arguments.split(), folder=folder)
    assert result.returncode == 2
    assert result.stdout == ""
    (line,) = result.stderr.splitlines()
    assert line.startswith("Error: ")
    assert error in line
    assert sorted(folder.rglob("*")) == before


BENT = """\
[lens]
focal_length = "35 mm"
f_number = 2.8
focus_distance = "inf"
wavelength = "540 nm"
[colour]
wavelengths = ["460 nm", "540 nm", "600 nm"]
lateral = ["9 um", "0 um", "-6 um"]
heights = "0.6 mm"
[sensor]
pixel = "6 um"
[field]
sensor = ["0.64 mm", "0.96 mm"]
edge = "0.6 mm"
W311 = -4.0
W131 = 1.0
"""


def test_a_photograph_through_the_field_of_a_lens_file_is_that_of_python(call_lommel, tmp_path):
    (tmp_path / "bent.toml").write_text(BENT)
    photo = np.full((64, 96, 3), 20, np.uint8)
    photo[::9, ::7] = 250
    Image.fromarray(photo).save(tmp_path / "photo.png")
    given = ["blur", "photo.png", "bent.toml", "--over-field", "-o"]
    made = call_lommel(*given, "out.png", "--json", "--pixel", "10um", folder=tmp_path)
    assert (made.returncode, made.stderr) == (0, "")
    field = lm.load_instrument(tmp_path / "bent.toml").field()
    wanted = lm.imaging.field_photograph(photo, field, 10e-6, encoding="srgb")
    found = np.asarray(Image.open(tmp_path / "out.png"))
    assert np.abs(found.astype(int) - wanted.values).max() <= 1
    assert np.abs(found.astype(int) - photo).max() > 50  # lines are bent
    facts = json.loads(made.stdout)
    assert facts["moved"] == pytest.approx(float(np.hypot(*field.displacement(475e-6, 315e-6))) / 10e-6)
    for stray, message in (
        (["--focus", "2m"], "--focus cannot be combined with --over-field"),
        (["--supersample", "2"], "--supersample cannot be combined with --over-field"),
        (["bent.toml"], "DEPTH cannot be combined"),
    ):
        refused = call_lommel(*given, "no.png", *stray, folder=tmp_path)
        assert refused.returncode == 2
        assert message in refused.stderr
    assert not (tmp_path / "no.png").exists()


@pytest.mark.parametrize("tol", [None, "1e-3"])
def test_what_a_photograph_is_off_by_is_told(tol, call_lommel, folder, monkeypatch):
    given = []

    def rendered(light, *_, options, **__):
        given.append(options)
        return SimpleNamespace(values=1.2 * (light > 0.0), window=9, lost=1e-3, error=2e-3)

    monkeypatch.setattr(imaging, "depth_of_field", rendered)
    monkeypatch.setattr(imaging, "field_photograph", rendered)
    (folder / "bent.toml").write_text(BENT)
    for words in (["depth.npy", "plain.toml"], ["bent.toml", "--over-field"]):
        asked = [*words, *(["--tol", tol] if tol else []), "-o", "out.png", "--json"]
        facts = json.loads(ran(call_lommel("blur", "photo.png", *asked, folder=folder)))
        assert (facts["interpolation_error"], facts["light_beyond_windows"], facts["clipped"]) == (2e-3, 1e-3, 1.0)
        assert facts["files"] == ["out.png"]
    assert given[0].tol == (1e-3 if tol else imaging.BlurOptions().tol)
    assert given[1] is None if tol is None else given[1].tol == 1e-3


@pytest.mark.parametrize("misfit", [math.nan, 3.0])
def test_depth_its_error_and_the_test_of_the_lenses_are_written_and_told(misfit, call_lommel, folder, monkeypatch):
    verdict = DefocusVerdict.of(misfit)
    found = SimpleNamespace(depth=DEPTH, errors=0.01 * DEPTH, verdict=verdict, plot=None)
    found.to_dict = lambda: {"depth": None}
    monkeypatch.setattr(imaging, "depth_from_defocus", lambda *_, **__: found)
    words = ["depth", "grey.png", "grey.png", "plain.toml", "--focus", "1m", "--focus", "2m", "--between", "1m", "3m"]
    words += ["--white", "1e4", "--read", "3", "-o", "d.npy", "-o", "e.npy"]
    facts = json.loads((made := call_lommel(*words, "--json", folder=folder)).stdout)
    assert (facts["agrees"], facts["untested"]) == (False, verdict.findings.get("untested").numbers["what"])
    assert (facts["files"], made.returncode) == (["d.npy", "e.npy"], 0 if verdict.converged else 3)
    np.testing.assert_allclose(np.load(folder / "e.npy"), 0.01 * DEPTH, rtol=1e-6)
    told = " ".join(call_lommel(*words, folder=folder).stdout.split())
    assert (verdict.summary in told) == (misfit == 3.0)
    assert all(finding.text[:40] in told for finding in verdict.findings)
    assert told.endswith("wrote d.npy wrote e.npy")


def test_what_the_exif_states_otherwise_than_options_or_the_lens_file_is_named(call_lommel, folder, monkeypatch):
    def notes(words: str) -> str:
        return " ".join(json.loads(ran(call_lommel(*words.split(), "--json", folder=folder))).get("notes", []))

    monkeypatch.setattr(
        imaging,
        "depth_of_field",
        lambda light, *_, **__: SimpleNamespace(values=light, window=9, lost=0.0, error=0.0),
    )
    tags = Image.Exif()  # 800 pixels per centimetre, of a picture that was twice as large
    sizes = {0xA20E: 800.0, 0xA20F: 800.0, 0xA210: 3, 0xA002: 72, 0xA003: 60}
    for name, lens, turned in (
        ("zoom.jpg", {0x920A: 35.0, 0x829D: 5.6}, 1),
        ("own.jpg", {0x920A: 50.4, 0x829D: 2.05}, 6),
    ):
        tags[0x8769], tags[0x0112] = lens | sizes, turned
        stored = PHOTO if turned == 1 else np.rot90(PHOTO)
        Image.fromarray(np.ascontiguousarray(stored)).save(folder / name, exif=tags.tobytes())
    blur = "blur {} depth.npy {} -o out.png"
    said = notes(blur.format("zoom.jpg", "plain.toml --pixel 40um"))
    assert "The EXIF of zoom.jpg states f/5.6; 2 was used." in said
    assert "The EXIF of zoom.jpg states a focal length of 35 mm; 50 mm was used." in said
    assert "states pixels of 25 um; 40 um, right if the picture was reduced by 1.6, was used." in said
    for words in (
        "plain.toml --pixel 25um",
        "plain.toml --pixel 25.7um --f-number 2.1",
        "plain.toml --pixel 50um --supersample 2",
    ):
        assert "EXIF" not in notes(blur.format("own.jpg", words))
    assert "EXIF" not in notes(blur.format("photo.png", "plain.toml"))
    said = notes(blur.format("camera.png", "--focus 2m --pixel 40um --f-number 4"))
    assert said == "The EXIF of camera.png states f/2; 4 was used."


@pytest.mark.parametrize(
    "words",
    [
        "blur camera.png field.toml --over-field -o out.png",
        "restore camera.png depth.npy plain.toml --white 5000 --read 3 -o out.png --f-number 4",
        f"depth photo.png camera.png plain.toml {PAIR} --white 5e3 --read 3 --f-number 4",
        "sharpen camera.png plain.toml --at 1.5m --f-number 4 -o out.png",
        "sharpen seq plain.toml --at 1.5m --f-number 4 -o out.mkv",
        f"watch plain.toml --source plain --source seq {PAIR} --f-number 4 --table t.csv",
    ],
)
def test_every_command_compares_the_exif_of_its_photos(words, call_lommel, folder, monkeypatch):
    def stop(*_: object, **__: object) -> None:
        raise ValueError("stopped")

    for name in ("field_photograph", "restore", "depth_from_defocus"):
        monkeypatch.setattr(imaging, name, stop)
    monkeypatch.setattr(video_commands, "LiveDepth", stop)
    monkeypatch.setattr(video_commands, "LiveSharpen", stop)
    (folder / "field.toml").write_text(PLAIN.replace("f_number = 2", "f_number = 4") + FIELD)
    for place, photo in (("plain", "photo.png"), ("seq", "camera.png")):
        (folder / place).mkdir()
        for k in range(3):
            shutil.copy(folder / photo, folder / place / f"{k}.png")
    said = call_lommel(*words.split(), folder=folder).stderr
    assert re.search(r"Note: The EXIF of (\S*seq|camera.png) states f/2; 4 was used\.\n", said), said
    assert "Error: stopped" in said


def test_notes_of_the_library_are_told_with_the_answer(call_lommel, folder):
    np.save(folder / "mm.npy", 1000.0 * DEPTH)
    given = ("blur", "photo.png", "mm.npy", "lens.toml")
    found = json.loads(ran(call_lommel(*given, "--json", "-o", "b.png", folder=folder)))
    assert "hyperfocal distance" in found["notes"][-1]
    assert "note: all of the depth" in ran(call_lommel(*given, "-o", "a.png", folder=folder))
