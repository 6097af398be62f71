"""The macros and scripts of the page on Fiji, ImageJ, MATLAB and Octave, run in ImageJ and Octave where these are."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
import tifffile

import lommel as lm
from lommel.measures.spot import axial_fwhm

PAGE = (Path(__file__).resolve().parent.parent / "docs" / "fiji-matlab.md").read_text(encoding="utf-8")
JAR = Path("/usr/share/java/ij.jar")
octave = pytest.mark.skipif(not shutil.which("octave-cli"), reason="there is no Octave")
imagej = pytest.mark.skipif(
    not (JAR.exists() and shutil.which("java") and shutil.which("xvfb-run")),
    reason="there is no ImageJ or no display",
)


def block(name: str) -> str:
    """Return the code of a block by its name."""
    (code,) = re.findall(rf"^```\{{code-block\}} \w+\n:name: {name}\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL)
    return code


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    made = tmp_path_factory.mktemp("psf")
    microscope = lm.load_microscope(lm.example_files()["zeiss-63x-1.4-oil"])
    z = 100e-9 * (np.arange(31) - 15)
    pupil = microscope.objective.pupil(depth=2e-6, z=z, wavelength=520e-9, origin="brightest")
    psf = lm.psf(pupil, 33, microscope.pixel)
    for suffix in ("ome.tif", "mat", "fits"):
        psf.save(made / f"psf.{suffix}")
    return made


def in_octave(folder: Path, *names: str) -> str:
    (folder / "script.m").write_text("\n".join(map(block, names)), encoding="utf-8")
    command = ["octave-cli", "--norc", "--quiet", "script.m"]
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300, check=False)
    assert "error: called" not in result.stderr, result.stderr
    return result.stdout


def in_imagej(folder: Path, name: str) -> list[str]:
    (folder / "macro.ijm").write_text(block(name), encoding="utf-8")
    command = ["xvfb-run", "-a", "java", "-cp", str(JAR), "ij.ImageJ", "-batch", "macro.ijm", f"{folder}/"]
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300, check=True)
    return result.stdout.splitlines()


@octave
def test_octave_reads_the_values_by_row_column_and_plane(folder):
    told = in_octave(folder, "octave-load")
    psf = lm.PSF.load(folder / "psf.ome.tif")
    assert "rows = 33" in told
    assert "planes = 31" in told
    assert float(re.search(r"step = +(\S+)", told)[1]) == pytest.approx(1e-7)
    peak, at = re.search(r"peak (\S+) at the centre: (\d)", told).groups()
    assert (float(peak), at) == (pytest.approx(float(psf.values.max()), rel=1e-5), "1")


@imagej
def test_the_macro_finds_voxels_and_the_axial_width(folder):
    told = in_imagej(folder, "ijm-open")
    psf = lm.PSF.load(folder / "psf.ome.tif")
    voxel = next(line for line in told if line.startswith("voxel")).split()
    assert tuple(map(float, voxel[1:4])) == pytest.approx((6.5 / 63, 6.5 / 63, 0.1), rel=1e-3)
    width = next(line for line in told if line.startswith("axial FWHM")).split()
    assert float(width[2]) == pytest.approx(1e6 * float(axial_fwhm(psf)), rel=0.02)
    with tifffile.TiffFile(folder / "psf-imagej.tif") as written:
        assert written.imagej_metadata["spacing"] == pytest.approx(0.1)
        np.testing.assert_array_equal(written.asarray(), psf.values)
