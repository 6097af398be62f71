"""`lommel psf --colour`, run as a user runs it."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image

import lommel as lm


def test_files_and_tables_hold_what_python_computes(call_lommel, lenses, tmp_path):
    path = lenses["fast-portrait"]
    outputs = [part for name in ("a.npz", "a.tif", "a.png") for part in ("-o", name)]
    result = call_lommel("psf", path, "--colour", "--shape", "33", *outputs, "--plot", "p.png", folder=tmp_path)
    assert (result.returncode, result.stderr) == (0, "")
    instrument = lm.load_instrument(path)
    expected = lm.colour_psf(instrument.pupil(), 33, instrument.pixel, instrument.channels)
    for name in ("a.npz", "a.tif"):
        found = lm.ColourPSF.load(tmp_path / name)
        assert found.channels == instrument.channels
        assert np.abs(found.values - expected.values).max() <= 1e-7 * expected.values.max()
    with Image.open(tmp_path / "a.png") as picture:
        assert picture.mode == "RGB"
    assert "red" in result.stdout
    assert "8 from 440 nm to 630 nm" in result.stdout
    assert result.stdout.split("wrote ")[1:] == ["a.npz\n", "a.tif\n", "a.png\n", "p.png\n"]


def test_a_field_is_in_colour(call_lommel, lenses, tmp_path):
    pytest.importorskip("zarr")
    options = ["--colour", "--field", "2x3", "--shape", "15", "-o", "f.zarr", "-o", "f.mat", "--plot", "f.png"]
    result = call_lommel("psf", lenses["camera-field"], *options, folder=tmp_path)
    assert (result.returncode, result.stderr) == (0, "")
    for name in ("f.zarr", "f.mat"):
        assert lm.PSFGrid.load(tmp_path / name).values.shape == (2, 3, 3, 15, 15)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["-o", "a.jpg"], ".raw, .tif, .tiff, .png for a PSF in channels, got"),
        (["--field", "2x3"], "must have a section [field]"),
        (["--normalize", "emitted"], "for the pupils of an Objective"),
    ],
)
def test_faults_are_one_line(call_lommel, lenses, tmp_path, options, message):
    result = call_lommel("psf", lenses["phone"], "--colour", *options, folder=tmp_path)
    assert result.returncode == 2
    assert message in result.stderr
    assert result.stderr.count("\n") == 1


def test_a_field_in_colour_in_a_file_that_holds_none_is_refused_before_it_is_computed(call_lommel, lenses, tmp_path):
    for name in ("f.tif", "f.png"):
        options = ["--colour", "--field", "64x64", "--shape", "1025", "-o", name]
        result = call_lommel("psf", lenses["camera-field"], *options, folder=tmp_path)
        assert result.returncode == 2
        assert ".hdf5, .mat, .raw for a grid of PSFs at several distances or in channels, got" in result.stderr
        assert result.stderr.count("\n") == 1
