"""Microscopes at the command line: what is printed and written, and what is refused."""

from __future__ import annotations

import json
import math
import re
import shutil
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest
import tifffile
from PIL import Image

import lommel as lm

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples" / "objectives" / "zeiss-63x-1.4-oil.toml"
SCALAR = 'emitter = "scalar"'
STACK = ["--stack", 4, "--step", "200 nm", "--depth", "3 um", "--shape", "5x6"]


@pytest.fixture
def folder(tmp_path):
    """A folder with a microscope, whose PSF takes no time, and a lens."""
    text = EXAMPLE.read_text(encoding="utf-8").replace('emitter = "isotropic"', SCALAR)
    (tmp_path / "objective.toml").write_text(text, encoding="utf-8")
    stack = text[text.index("[stack]") : text.index("[sensor]")]
    (tmp_path / "plane.toml").write_text(text.replace(stack, ""), encoding="utf-8")
    shutil.copy(ROOT / "examples" / "lenses" / "phone.toml", tmp_path / "lens.toml")
    yield tmp_path
    plt.close("all")


def test_a_stack_is_written_as_data_and_as_sections(folder, call_lommel):
    outputs = ["-o", "a.ome.tif", "-o", "a.npz", "-o", "a.png", "--plot", "a.pdf"]
    result = call_lommel("psf", "objective.toml", *STACK, *outputs, folder=folder)
    assert (result.returncode, result.stderr) == (0, "")
    psf = lm.PSF.load(folder / "a.npz")
    assert psf.shape == (4, 5, 6)
    np.testing.assert_allclose(psf.pupil.z, [-4e-7, -2e-7, 0.0, 2e-7], atol=1e-18)
    assert set(psf.pupil.depth) == {3e-6}
    np.testing.assert_array_equal(tifffile.imread(folder / "a.ome.tif"), psf.values)
    with Image.open(folder / "a.png") as picture:
        assert min(picture.size) > 400
    assert (folder / "a.pdf").read_bytes().startswith(b"%PDF")
    last = result.stdout.splitlines()[-4:]
    assert last == ["wrote a.ome.tif", "wrote a.npz", "wrote a.png", "wrote a.pdf"]
    assert re.search(r"shape +4 x 5 x 6\n", result.stdout)


def test_the_json_is_what_python_says(folder, call_lommel):
    result = call_lommel("psf", "objective.toml", *STACK, "--json", "-o", "a.npy", folder=folder)
    facts = json.loads(result.stdout)
    assert (facts["NA"], facts["depth"], facts["planes"], facts["step"]) == (1.4, 3e-6, 4, 2e-7)
    assert facts["psf"]["shape"] == [4, 5, 6]
    assert facts["files"] == ["a.npy"]
    # The table of foci, which takes longer than the stack, is that of info alone.
    info = json.loads(call_lommel("info", "objective.toml", "--depth", "3 um", "--json", folder=folder).stdout)
    assert facts["focus"] == []
    assert len(info["focus"]) == 6
    dipole = "of a freely rotating dipole"
    assert dipole in call_lommel("info", "objective.toml", folder=folder).stdout
    assert dipole not in call_lommel("psf", "objective.toml", *STACK, folder=folder).stdout


def test_the_foci_of_an_aberrated_objective_are_its_own(folder, call_lommel):
    terms = "terms = { 5 = 0.05, 11 = -0.03 }"
    table = f'\n[aberrations.zernike]\norder = "noll"\nunit = "waves"\nnormalization = "rms"\n{terms}\n'
    text = EXAMPLE.read_text(encoding="utf-8")
    (folder / "ideal.toml").write_text(text)
    (folder / "aberrated.toml").write_text(text + table)
    made = [
        json.loads(call_lommel("info", name, "--json", folder=folder).stdout)["focus"]
        for name in ("ideal.toml", "aberrated.toml")
    ]
    for ideal, aberrated in list(zip(*made, strict=True))[:2]:
        # The Strehl ratio of Marechal is 0.87 for light that is even over the pupil; here its edge is brighter.
        least = math.exp(-((2.0 * math.pi) ** 2) * (0.05**2 + 0.03**2))
        assert 0.9 * least < aberrated["peak"] / ideal["peak"] < least
        assert aberrated["lateral_fwhm"] > 1.005 * ideal["lateral_fwhm"]


def test_the_measured_wavefront_is_told(folder, call_lommel):
    file = ROOT / "examples" / "objectives" / "zeiss-63x-astigmatic.toml"
    out = call_lommel("info", file, folder=folder).stdout
    assert "\nrms waves " in out
    assert "astigmatism 0" in out.partition("\nzernike\n")[2]
    facts = json.loads(call_lommel("info", file, "--json", folder=folder).stdout)
    assert facts["rms_waves"] == pytest.approx(0.15)
    assert 0.15 < facts["rms_waves_with_media"] < 0.17  # the depth in water adds to it
    assert 0.8 < facts["strehl"] / math.exp(-((2.0 * math.pi * 0.15) ** 2)) < 1.2
    assert [(term["n"], term["m"]) for term in facts["zernike"]] == [(2, 2)]
    plain = call_lommel("info", "objective.toml", folder=folder).stdout
    assert "wavefront error" not in plain
    assert "strehl" not in plain
    assert "Zernike" not in plain


def test_a_cover_glass_unlike_the_design_has_its_strehl_ratio_without_terms(folder, call_lommel):
    design = '[design]\nimmersion = 1.518\n\n[design.coverslip]\nindex = 1.5255\nthickness = "160 um"\n'
    (folder / "thick.toml").write_text(f"{(folder / 'objective.toml').read_text()}\n{design}")
    facts = json.loads(call_lommel("info", "thick.toml", "--json", folder=folder).stdout)
    assert facts["rms_waves"] == 0.0
    rms = 2.0 * math.pi * facts["rms_waves_with_media"]
    assert rms > 0.1
    assert 1.0 < facts["strehl"] / math.exp(-(rms**2)) < 1.3  # Marechal's is low for much spherical aberration
