"""PSFs of microscopes in files: what comes back, and what others read in OME-TIFF."""

from __future__ import annotations

import json
from xml.etree import ElementTree as ET

import numpy as np
import pytest
import tifffile

import lommel as lm

OBJECTIVE = lm.Objective(
    NA=1.2,
    magnification=60,
    immersion=1.333,
    working_distance=0.28e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.36,
    films=(lm.Layer(1.46, 50e-9),),
)
EMITTERS = [
    "isotropic",
    "scalar",
    lm.Dipole(0.3, 1.1, wobble=0.2),
    lm.Beam("x"),
    lm.Beam((1.0, 0.5j)),
    lm.Scalar("aplanatic", supercritical=False),
]
EVEN = np.arange(-2, 3) * 0.1e-6


def made(z=EVEN, depth=2e-6, emitter="scalar", **options) -> lm.PSF:
    pupil = OBJECTIVE.pupil(depth=depth, z=z, wavelength=520e-9, origin="paraxial", emitter=emitter)
    return lm.psf(pupil, **{"shape": (4, 5), "pixel": 6.5e-6} | options)


def xml(psf: lm.PSF, folder) -> tuple[ET.Element, dict]:
    """The OME-XML of a PSF, as a program that knows no lommel finds it, and the description in it."""
    psf.save(folder / "a.ome.tif")
    with tifffile.TiffFile(folder / "a.ome.tif") as file:
        found = ET.fromstring(file.pages[0].tags["ImageDescription"].value)
        assert file.series[0].axes == ("ZYX" if psf.pupil.shape else "YX")
        np.testing.assert_array_equal(file.asarray().ravel(), psf.values.ravel())
    return found, json.loads(found.findtext(".//{*}Image/{*}Description"))


@pytest.mark.parametrize("suffix", [".tif", ".npy", ".npz"])
@pytest.mark.parametrize("emitter", EMITTERS, ids=repr)
def test_a_stack_loads_as_it_was_with_its_emitter(emitter, suffix, tmp_path):
    psf = made(EVEN[1:3], emitter=emitter, shape=2, integrate=False, normalize="emitted")
    psf.save(tmp_path / f"a{suffix}")
    loaded = lm.PSF.load(tmp_path / f"a{suffix}")
    assert loaded.pupil == psf.pupil
    assert (loaded.method, loaded.grid, loaded.normalize) == (psf.method, psf.grid, "emitted")
    np.testing.assert_array_equal(loaded.values, psf.values)
    np.testing.assert_array_equal(loaded.pupil.focus, psf.pupil.focus)


@pytest.mark.parametrize("suffix", [".tif", ".npy", ".npz"])
@pytest.mark.parametrize("z", [0.0, np.zeros((2, 1)) + EVEN[:2]], ids=["one plane", "two axes"])
def test_stacks_of_any_shape_load_and_go_on(z, suffix, tmp_path):
    psf = made(z)
    psf.save(tmp_path / f"a{suffix}")
    loaded = lm.PSF.load(tmp_path / f"a{suffix}")
    assert loaded.pupil.shape == np.shape(z)
    np.testing.assert_array_equal(loaded.values, psf.values)
    np.testing.assert_array_equal(loaded.profile([0.0, 1e-5])[1], psf.profile([0.0, 1e-5])[1])


def test_sizes_are_those_in_the_sample_and_of_the_stage(tmp_path):
    root, description = xml(made(), tmp_path)
    pixels = root.find(".//{*}Pixels").attrib
    assert float(pixels["PhysicalSizeX"]) == float(pixels["PhysicalSizeY"]) == pytest.approx(6.5 / 60, rel=1e-11)
    assert float(pixels["PhysicalSizeZ"]) == 0.1
    assert {pixels[f"PhysicalSize{axis}Unit"] for axis in "XYZ"} == {"µm"}
    assert (pixels["SizeZ"], pixels["SizeY"], pixels["SizeX"]) == ("5", "4", "5")
    assert [float(plane.get("PositionZ")) for plane in root.findall(".//{*}Plane")] == [-0.2, -0.1, 0.0, 0.1, 0.2]
    assert "planes" not in description


def test_light_that_is_focused_into_the_sample_has_a_wavelength_of_excitation(tmp_path):
    channel = xml(made(0.0, emitter=lm.Beam("x")), tmp_path)[0].find(".//{*}Channel").attrib
    assert float(channel["ExcitationWavelength"]) == 520.0
    assert "EmissionWavelength" not in channel


@pytest.mark.parametrize("z", [np.array([0.0, 1e-7, 3e-7]), np.zeros(3), EVEN[:4].reshape(2, 2)])
def test_planes_that_are_not_evenly_spaced_have_no_step_and_the_description_says_so(z, tmp_path):
    root, description = xml(made(z), tmp_path)
    assert "PhysicalSizeZ" not in root.find(".//{*}Pixels").attrib
    assert description["planes"].startswith("planes are not evenly spaced along z")
    places = [float(plane.get("PositionZ")) for plane in root.findall(".//{*}Plane")]
    np.testing.assert_allclose(places, 1e6 * z.ravel(), rtol=1e-11)
