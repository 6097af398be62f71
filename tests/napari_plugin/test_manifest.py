"""The plugin of napari without napari: what its manifest names, and layers of PSFs."""

from __future__ import annotations

import subprocess
import sys
import tomllib
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
import tifffile
import yaml

import lommel as lm
from lommel.napari_plugin import contributions

ROOT = Path(__file__).resolve().parents[2]
MANIFEST = ROOT / "src" / "lommel" / "napari_plugin" / "napari.yaml"


def test_the_manifest_names_functions_that_exist_and_commands_that_it_has():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["entry-points"]["napari.manifest"] == {"lommel": "lommel.napari_plugin:napari.yaml"}
    parts = yaml.safe_load(MANIFEST.read_text(encoding="utf-8"))["contributions"]
    ids = [command["id"] for command in parts["commands"]]
    for command in parts["commands"]:
        module, name = command["python_name"].split(":")
        assert callable(getattr(import_module(module), name))
    used = [part["command"] for kind in ("widgets", "readers", "sample_data") for part in parts[kind]]
    assert sorted(used) == sorted(ids)


def test_no_module_of_the_plugin_imports_qt_napari_or_magicgui():
    names = [f"lommel.napari_plugin.{path.stem}" for path in MANIFEST.parent.glob("[!_]*.py")]
    code = f"import sys\nfor name in {names}: __import__(name)\nprint(*sys.modules)"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert set(names) <= set(found)
    assert not {name.partition(".")[0] for name in found} & {
        "napari",
        "magicgui",
        "qtpy",
        "PyQt5",
        "PyQt6",
        "PySide6",
    }


def test_layers_have_voxels_in_micrometres_of_the_sample(tmp_path):
    objective = lm.Objective(NA=1.2, magnification=60, immersion=1.333, working_distance=0.28e-3, sample=1.33)
    stack = lm.psf(objective.pupil(depth=1e-6, z=[-3e-7, 0.0, 3e-7], wavelength=520e-9), 9, 6e-6)
    stack.save(tmp_path / "psf.ome.tif")
    (data, options, kind) = contributions.reader(str(tmp_path / "psf.ome.tif"))("")[0]
    np.testing.assert_array_equal(data, stack.values)
    assert options["scale"] == pytest.approx((0.3, 0.1, 0.1))
    assert (options["name"], options["units"], kind) == ("psf", ("um",) * 3, "image")
    assert contributions.psf_of(options["metadata"]).error_bound == pytest.approx(stack.error_bound)
    lens = lm.psf(lm.Lens(focal_length=0.05, f_number=2, wavelength=5e-7).pupil(), 9, (4e-6, 6e-6))
    assert contributions.voxel(lens) == pytest.approx((4.0, 6.0))
    assert contributions.voxel(lm.psf(lm.Pupil(), 9, 0.5)) is None
    assert "scale" not in contributions.layer_of(lm.psf(lm.Pupil(), 9, 0.5), "one")[1]


def test_recorded_stacks_are_a_layer_for_each_channel_with_voxels_and_wavelength(tmp_path):
    (data, options, _) = contributions.reader(str(ROOT / "tests" / "truth" / "microsim.ome.tif"))("")[0]
    assert (data.shape, options["name"]) == ((16, 28, 28), "microsim")
    assert options["scale"] == pytest.approx((0.35, 6.5 / 60, 6.5 / 60))
    assert options["metadata"][contributions.EMISSION] == pytest.approx(520e-9)
    stack = np.arange(2 * 3 * 5 * 6, dtype=np.uint16).reshape(2, 3, 5, 6)
    colours = {"Name": ["GFP", "Cy5"], "EmissionWavelength": [509, 670]}
    sizes = {"PhysicalSizeX": 0.1, "PhysicalSizeY": 0.1, "PhysicalSizeZ": 0.3}
    tifffile.imwrite(tmp_path / "a.tif", stack, ome=True, metadata={"axes": "CZYX", "Channel": colours} | sizes)
    made = contributions.reader(str(tmp_path / "a.tif"))("")
    assert [each[1]["name"] for each in made] == ["a GFP", "a Cy5"]
    assert [each[1]["metadata"][contributions.EMISSION] for each in made] == pytest.approx([509e-9, 670e-9])
    np.testing.assert_array_equal(np.stack([each[0] for each in made]), stack)


def test_files_without_voxels_are_left_to_other_readers(tmp_path):
    tifffile.imwrite(tmp_path / "plain.tif", np.zeros((4, 8, 8), np.uint8), photometric="minisblack")
    assert contributions.reader(str(tmp_path / "plain.tif")) is None
    np.save(tmp_path / "a.npy", np.zeros((3, 3)))
    (tmp_path / "b.tif").write_bytes(b"nothing")
    for path in (str(tmp_path / "a.npy"), str(tmp_path / "b.tif"), str(tmp_path / "none.npz"), ["a.tif", "b.tif"]):
        assert contributions.reader(path) is None


def test_sample_beads_are_what_the_psf_and_the_camera_make_of_points():
    (counts, options, _), (kernel, of_psf, _) = contributions.beads()
    camera = options["metadata"][contributions.KEY]
    assert (counts.dtype, counts.shape, kernel.shape) == (np.uint16, (24, 96, 96), (33, 65, 65))
    assert options["scale"] == of_psf["scale"] == pytest.approx((0.2, 6.5 / 63, 6.5 / 63))
    electrons = camera.noise.electrons(counts)
    # A background of 10 electrons, far from the beads, whose light is that of their number.
    assert np.percentile(electrons, 1) == pytest.approx(10.0, abs=10.0)
    assert electrons.max() > 30 * np.median(electrons)
    total = electrons.sum() - 10.0 * electrons.size
    assert 0.3 * 30 * contributions._PHOTONS * 0.5 < total < 30 * contributions._PHOTONS
