"""The option --camera: whose pixels and noise a command takes, and what comes before them."""

from __future__ import annotations

import dataclasses
import json
import re
import shutil
from typing import Any

import numpy as np
import pytest

import lommel as lm
from lommel.cli import deconvolve_command
from lommel.cli.instruments import Sensor, instrument_of, microscope_of, noise_of
from lommel.lensfiles import example_files

ZYLA = lm.load_camera("andor-zyla-4.2")
ORCA = lm.load_camera("hamamatsu-orca-flash4-v3")


def given(**values: object) -> dict[str, object]:
    return {"white": None, "read": None, "offset": None} | values


def test_pixels_are_the_options_then_the_cameras_then_the_files():
    lens, objective = example_files()["phone"], example_files()["nikon-60x-1.4-oil"]
    assert instrument_of(lens).pixel == 1.22e-6
    assert instrument_of(lens, camera=ZYLA).pixel == 6.5e-6
    assert instrument_of(lens, camera=ZYLA).camera == ZYLA
    assert instrument_of(lens, camera=ZYLA, pixel=13e-6).pixel == 13e-6
    assert microscope_of(objective).camera == ORCA
    other = lm.load_camera("andor-ixon-888")
    assert microscope_of(objective, camera=other).pixel == 13e-6
    assert microscope_of(objective, camera=other, pixel=26e-6).pixel == 26e-6
    wide = dataclasses.replace(ZYLA, pixel=(4e-6, 6e-6))
    assert instrument_of(lens, camera=wide).pixel == (4e-6, 6e-6)
    with pytest.raises(ValueError, match="must be square"):
        microscope_of(objective, camera=wide)


def test_images_at_a_wavelength_that_no_camera_records_are_refused(tmp_path):
    text = example_files()["phone"].read_text("utf-8")
    (tmp_path / "far.toml").write_text(re.sub(r'wavelength = ".*"', 'wavelength = "0.55 mm"', text), "utf-8")
    assert Sensor(camera=ZYLA).instrument(example_files()["phone"], "a.toml").pixel == 6.5e-6
    with (
        pytest.warns(UserWarning, match="far infrared"),
        pytest.raises(ValueError, match=r"a\.toml: wavelength must be"),
    ):
        Sensor().instrument(tmp_path / "far.toml", "a.toml")


def test_an_object_in_focus_stays_there_and_a_stack_needs_a_step(tmp_path):
    lens = example_files()["phone"]
    (tmp_path / "near.toml").write_text(lens.read_text("utf-8").replace('"2 m"', '"0.5 m"'), "utf-8")
    near = instrument_of(tmp_path / "near.toml", focus_distance=3.0)
    assert (instrument_of(lens, focus_distance=3.0).object_distance, near.object_distance) == pytest.approx(
        (2.0, 3.0)
    )
    assert instrument_of(tmp_path / "near.toml", f_number=4.0).object_distance == pytest.approx(0.5)
    plain = dataclasses.replace(lm.load_microscope(example_files()["nikon-60x-1.4-oil"]), planes=1, step=0.0)
    plain.save(tmp_path / "plain.toml")
    axial = 1e9 * plain.objective.nyquist(wavelength=plain.wavelength).axial
    with pytest.raises(ValueError, match=f"needs at most {axial:.3g} nm"):
        microscope_of(tmp_path / "plain.toml", stack=5)


def test_noise_of_counts_is_the_options_and_then_the_cameras():
    assert noise_of(given(), ORCA) == lm.Noise(white=0.46, read=1.6, offset=100.0) == ORCA.noise
    assert noise_of(given(white=2.0, offset=0.0), ORCA) == lm.Noise(white=2.0, read=1.6)
    dark = np.full((4, 5), 3.0)
    assert noise_of(given(read=dark), ORCA) == lm.Noise(white=0.46, read=dark, offset=100.0)
    assert noise_of(given(read=0.0), None) == lm.Noise(read=0.0)
    with pytest.raises(ValueError, match=r"--read is missing: .*, or a camera that states it, by --camera$"):
        noise_of(given(), None)
    with pytest.raises(ValueError, match="which Andor iXon Ultra 888, EMCCD does not state"):
        noise_of(given(), lm.load_camera("andor-ixon-888"))


def test_noise_of_photographs_has_the_full_well_at_white_and_no_offset():
    assert noise_of(given(), ZYLA, photographs=True) == lm.Noise(white=30000.0, read=0.9)
    assert noise_of(given(offset=0.01), ZYLA, photographs=True) == lm.Noise(white=30000.0, read=0.9, offset=0.01)
    with pytest.raises(ValueError, match="--white is missing: the number of electrons at white, which QHY268M"):
        noise_of(given(), lm.load_camera("qhy268m-pro"), photographs=True)


def test_a_psf_with_a_camera_is_that_with_its_pixel(call_lommel, tmp_path):
    shutil.copy(example_files()["phone"], tmp_path)
    shutil.copy(example_files()["nikon-60x-1.4-oil"], tmp_path)
    for file, pixel in (("phone", "3.45um"), ("nikon-60x-1.4-oil", "3.45um")):
        call = ("psf", f"{file}.toml", "--shape", "9", *(("--stack", "1") if file != "phone" else ()))
        call_lommel(*call, "--camera", "mvbluefox3-imx250", "-o", "a.npy", folder=tmp_path)
        call_lommel(*call, "--pixel", pixel, "-o", "b.npy", folder=tmp_path)
        np.testing.assert_array_equal(np.load(tmp_path / "a.npy"), np.load(tmp_path / "b.npy"))


def test_info_tells_the_camera_and_its_noise(call_lommel, tmp_path):
    shutil.copy(example_files()["nikon-60x-1.4-oil"], tmp_path)
    told = json.loads(call_lommel("info", "nikon-60x-1.4-oil.toml", "--json", folder=tmp_path).stdout)
    assert (told["camera"]["name"], told["camera"]["read"], told["pixel"]) == (ORCA.name, 1.6, 6.5e-6)
    (tmp_path / "mine.toml").write_text('[camera]\npixel = "9 um"\nread = 2.5\n')
    shutil.copy(example_files()["phone"], tmp_path)
    told = json.loads(call_lommel("info", "phone.toml", "--camera", "mine.toml", "--json", folder=tmp_path).stdout)
    assert (told["camera"]["name"], told["camera"]["read"], told["pixel"]) == ("mine", 2.5, 9e-6)


def test_precision_takes_the_read_noise_of_the_camera(call_lommel, tmp_path):
    shutil.copy(example_files()["phone"], tmp_path)
    call = (
        "precision",
        "phone.toml",
        "--focus",
        "1.5m",
        "--pair",
        "0.1",
        "--photons",
        "100",
        "--json",
        "--pixel",
        "1.4um",
    )

    def errors(*more: str) -> list[float]:
        return json.loads(call_lommel(*call, *more, folder=tmp_path).stdout)["errors"]

    assert errors("--camera", "google-pixel-4") == errors("--read", "5") != errors()
    assert errors("--camera", "google-pixel-4", "--read", "3") == errors() == errors("--read", "3")


def test_deconvolve_takes_the_noise_of_a_camera_that_is_named(call_lommel, monkeypatch, tmp_path):
    seen = []

    def restore(_: object, microscope: object, noise: object, options: Any, **more: object) -> None:
        seen.append((noise, options.pixel))
        raise ValueError("enough")

    monkeypatch.setattr(deconvolve_command, "run", restore)
    np.save(tmp_path / "stack.npy", np.ones((3, 9, 9)))
    call = ["deconvolve", "stack.npy", example_files()["nikon-60x-1.4-oil"], "--axes", "ZYX", "-o", "out.ome.tif"]
    for more in (["--camera", "andor-zyla-4.2", "--offset", "100"], []):
        assert "enough" in call_lommel(*call, *more, folder=tmp_path).stderr
    # The voxels are those of the stack; a camera that is only an example in the file of the objective is not taken.
    assert seen == [(lm.Noise(white=0.45, read=0.9, offset=100.0), None), (None, None)]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("sfr", "chart.png", "--pixel", "3.45mm"), "got 3.45 mm; did you mean 3.45 um?"),
        (("psf", "lens.toml", "--pixel", "4umx3mm"), "got 3 mm; did you mean 3 um?"),
        (("deconvolve", "a.tif", "b.toml", "-o", "c.tif", "--pixel", "6.5nm"), "got 6.5 nm; did you mean 6.5 um?"),
        (("localize", "a.tif", "b.toml", "-o", "c.csv", "--pixel", "-3um"), "--pixel must be "),
    ],
)
def test_pixels_that_no_camera_has_are_refused_before_files_are_read(call_lommel, tmp_path, words, said):
    result = call_lommel(*words, folder=tmp_path)
    assert result.returncode == 2
    assert said in " ".join(result.stderr.split())


@pytest.mark.parametrize("pixel", [10e-9, 0.5e-6, 55e-6, 150e-6, 353e-6])
def test_pixels_of_scans_of_detectors_and_in_the_sample_are_accepted(pixel):
    """In the sample, of SPAD arrays and X-ray detectors, and of a print at 72 dpi."""
    assert Sensor(pixel=pixel).pixel == pixel
    assert lm.microscopy.DeconvolveOptions(pixel=pixel).pixel == pixel
