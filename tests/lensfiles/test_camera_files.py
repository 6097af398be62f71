"""Camera files, examples that say what their sources do, and the section [sensor] that names a camera."""

from __future__ import annotations

import tomllib
from pathlib import Path

import numpy as np
import pytest

import lommel as lm
from cases import each
from lommel.lensfiles import of_kind
from lommel.lensfiles.toml_files import LensFileError

CAMERAS, OBJECTIVES = of_kind("camera"), of_kind("objective")
PLAIN = """\
name = "C"
source = "nobody"
[camera]
pixel = "6.5 um"
read = 1.5
full_well = 30000
gain = 0.46
offset = 100
"""


@each("text", ["em_gain = 300\nread = 45\ngain = 12", "excess = 2\nread = 0.15\ngain = 0.04"])
def test_a_camera_that_multiplies_electrons_has_excess_noise(write, text):
    camera = lm.load_camera(write(f'[camera]\npixel = "16 um"\noffset = 200\n{text}\n'))
    assert camera.noise == lm.Noise(white=0.04, read=0.15, offset=200.0, excess=2.0)


def test_a_camera_is_plain_data_without_its_pixels(write):
    known = {"name": "C", "source": "nobody", "read": 1.5, "full_well": 30000.0, "gain": 0.46, "offset": 100.0}
    assert lm.load_camera(write(PLAIN)).to_dict() == known | {"excess": 1.0}


@pytest.fixture
def write(tmp_path: Path):
    """Write a file into a folder of its own."""

    def written(text: str, name: str = "mine.toml") -> Path:
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return written


def test_a_camera_file_is_read_with_all_it_says(write):
    camera = lm.load_camera(write(PLAIN))
    assert camera == lm.Camera("C", "nobody", 6.5e-6, 1.5, 30000.0, 0.46, 100.0)
    assert camera.noise == lm.Noise(white=0.46, read=1.5, offset=100.0)
    bare = lm.load_camera(write('[camera]\npixel = ["4 um", "6 um"]\n', "bare.toml"))
    assert (bare.name, bare.pixel, bare.read) == ("bare", (4e-6, 6e-6), None)
    with pytest.raises(ValueError, match="must state read"):
        bare.noise  # noqa: B018
    with pytest.raises(ValueError, match="must be square"):
        bare.side  # noqa: B018


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ('"6.5 um"', "6.5", r"camera.pixel \(line 4\): .*unit"),
        ('"6.5 um"', '"6.5 m"', "pixel"),
        ("1.5", "-1", r"camera.read \(line 5\)"),
        ("offset = 100", "ofset = 100", r"camera.ofset \(line 8\): unknown key; did you mean offset"),
    ],
)
def test_errors_of_a_camera_file_name_key_and_line(write, old, new, told):
    with pytest.raises(LensFileError, match=told):
        lm.load_camera(write(PLAIN.replace(old, new)))


def test_the_section_sensor_takes_pixels_from_its_camera(write):
    lens = Path(of_kind("lens")["nifty-fifty"]).read_text(encoding="utf-8")
    pixel = next(line for line in lens.splitlines() if line.startswith("pixel"))
    write(PLAIN)
    own = lm.load_instrument(write(lens.replace(pixel, 'camera = "mine.toml"'), "lens.toml"))
    assert (own.pixel, own.camera.read) == (6.5e-6, 1.5)
    shipped = lm.load_instrument(write(lens.replace(pixel, 'camera = "andor-neo-5.5"'), "lens.toml"))
    assert shipped.camera == lm.load_camera("andor-neo-5.5")
    binned = lm.load_instrument(write(lens.replace(pixel, 'camera = "andor-neo-5.5"\npixel = "13 um"'), "lens.toml"))
    assert (binned.pixel, binned.camera) == (13e-6, shipped.camera)
    assert lm.load_instrument(of_kind("lens")["nifty-fifty"]).camera is None
    write('[camera]\npixel = ["4 um", "6 um"]\n', "wide.toml")
    wide = lm.load_instrument(write(lens.replace(pixel, 'camera = "wide.toml"'), "lens.toml"))
    assert wide.pixel == (4e-6, 6e-6)
    image = lm.psf(own.pupil(), 9, own.pixel).values
    np.testing.assert_array_equal(image, lm.psf(own.pupil(), 9, 6.5e-6).values)


@pytest.mark.parametrize(
    ("camera", "told"),
    [
        ('"none.toml"', "'none.toml' cannot be read: No such file"),
        ('"wide.toml"', "sensor.pixel"),
        ('"../mine.toml"', "must lie in the folder"),
    ],
)
def test_cameras_that_a_microscope_cannot_have_are_refused(write, tmp_path, camera, told):
    write('[camera]\npixel = ["4 um", "6 um"]\n', "wide.toml")
    text = OBJECTIVES["nikon-60x-1.4-oil"].read_text(encoding="utf-8")
    assert tomllib.loads(text)["sensor"]["camera"] == "hamamatsu-orca-flash4-v3"
    path = write(text.replace('"hamamatsu-orca-flash4-v3"', camera), "microscope.toml")
    with pytest.raises(LensFileError, match=told):
        lm.load_microscope(path, folder_only=True)
