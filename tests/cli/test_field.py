"""`lommel psf --field`, run as a user runs it."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest
from PIL import Image

import lommel as lm

OPTIONS = ["--field", "3x4", "--shape", "21x17", "--normalize", "strehl"]


@pytest.fixture(scope="module")
def expected(lenses) -> lm.PSFGrid:
    instrument = lm.load_instrument(lenses["camera-field"])
    return instrument.field().grid(
        3,
        4,
        sensor=(24e-3, 36e-3),
        shape=(21, 17),
        pixel=0.5e-6,
        normalize="strehl",
    )


@pytest.fixture(scope="module")
def written(run_lommel, lenses, tmp_path_factory):
    folder = tmp_path_factory.mktemp("field")
    pytest.importorskip("zarr")
    outputs = [part for suffix in (".tif", ".zarr", ".npz") for part in ("-o", f"a{suffix}")]
    result = run_lommel("psf", lenses["camera-field"], *OPTIONS, *outputs, "--plot", "a.png", folder=folder)
    assert (result.returncode, result.stderr) == (0, "")
    return folder, result.stdout


def test_every_file_holds_what_python_computes(written, expected):
    folder, text = written
    assert {path.name for path in folder.iterdir()} == {"a.tif", "a.zarr", "a.npz", "a.png"}
    for suffix in (".tif", ".zarr", ".npz"):
        loaded = lm.PSFGrid.load(folder / f"a{suffix}")
        np.testing.assert_allclose(loaded.values, expected.values, atol=1e-6)
        np.testing.assert_allclose(loaded.x, expected.x)
    with Image.open(folder / "a.png") as figure:
        assert figure.size[0] > figure.size[1] > 600
    figure = "a.png: square root of the values, each PSF normalized to its maximum"
    assert re.findall(r"^wrote (.*)$", text, re.MULTILINE) == ["a.tif", "a.zarr", "a.npz", figure]


def test_the_json_is_what_python_knows(call_lommel, lenses, expected, tmp_path):
    result = call_lommel("psf", lenses["camera-field"], *OPTIONS, "--json", folder=tmp_path)
    data = json.loads(result.stdout)
    assert data["sensor"] == pytest.approx([0.024, 0.036])
    np.testing.assert_allclose(data["x"], expected.x)
    np.testing.assert_allclose(data["y"], expected.y)
    np.testing.assert_allclose(data["peak"], expected.values.max(axis=(2, 3)))
    assert data["shape"] == [3, 4, 21, 17]
    assert data["files"] == []


def test_a_lens_file_may_narrow_the_aperture_of_its_field(call_lommel, lenses, tmp_path):
    text = lenses["camera-field"].read_text(encoding="utf-8").replace("shape = 49", "shape = 9")
    vanes = '[aperture.spider]\nvanes = 4\nwidth = "2 mm"\n'
    (tmp_path / "vanes.toml").write_text(
        text.replace("[lens]", "[lens]\napodization = 0.5") + vanes, encoding="utf-8"
    )
    result = call_lommel("psf", "vanes.toml", "--field", "2x3", "-o", "a.tif", folder=tmp_path)
    assert (result.returncode, result.stderr) == (0, "")
    loaded = lm.PSFGrid.load(tmp_path / "a.tif")
    assert loaded.psf.pupil.spider == lm.Spider.equal(4, 2e-3 / (35e-3 / 4))
    assert loaded.psf.pupil.apodization == 0.5
    assert call_lommel("info", "vanes.toml", folder=tmp_path).returncode == 0


@pytest.mark.parametrize(
    ("arguments", "what"),
    [
        (["--field", "5"], "--field must be ROWSxCOLUMNS such as 5x7, got 5"),
        (["--field", "0x7"], "rows must be from 1 to 1000, got 0"),
        (["--field", "2x2", "-o", "a.png"], "--output must end in .tif, .tiff, .zarr, .npy, .npz, .fits,"),
        (["--field", "2x2", "--plot", "a.tif"], "a figure must end in .png, .pdf or .svg"),
    ],
)  # fmt: skip
def test_what_makes_no_sense_is_one_line(call_lommel, lenses, tmp_path, arguments, what):
    result = call_lommel("psf", lenses["camera-field"], *arguments, folder=tmp_path)
    assert result.returncode == 2
    assert what in result.stderr
    assert not list(tmp_path.iterdir())


def test_the_psf_of_one_place_has_the_wavefront_and_the_blur_there(call_lommel, lenses, tmp_path):
    lens = lenses["camera-field"]
    options = ["--at", "15mm", "-10mm", "--jitter", "2", "--shape", "33", "-o", "corner.npz"]
    result = call_lommel("psf", lens, *options, folder=tmp_path)
    assert (result.returncode, result.stderr) == (0, "")
    assert "15 mm right of and 10 mm above the middle of the sensor" in result.stdout
    instrument = lm.load_instrument(lens)
    blur = lm.Jitter(2.0 * np.pi / 648000.0 * 35e-3)
    corner = lm.psf(
        instrument.field().pupil(15e-3, -10e-3), 33, instrument.pixel, blur=blur, **instrument.sensor_options
    )
    np.testing.assert_allclose(
        lm.PSF.load(tmp_path / "corner.npz").values, corner.values, atol=1e-6 * corner.values.max()
    )
    axis = lm.psf(instrument.pupil(), 33, instrument.pixel, blur=blur, **instrument.sensor_options)
    assert np.abs(axis.values - corner.values).max() > 0.1 * corner.values.max()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--at", "15mm", "-10mm", "--colour"], "--at is for one PSF"),
        (["--at", "15mm", "-10"], "is a length without a unit"),
        (["--at", "30mm", "0mm"], "lies outside of the map"),
    ],
)
def test_a_place_that_has_no_psf_is_told(call_lommel, lenses, tmp_path, options, message):
    result = call_lommel("psf", lenses["camera-field"], *options, folder=tmp_path)
    assert result.returncode == 2
    assert re.search(message, result.stderr)
    assert result.stderr.count("\n") < 8
