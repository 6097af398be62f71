"""README's commands for microscopes, on stacks that microsim simulated and other packages wrote."""

from __future__ import annotations

import json
import re
import shlex
import shutil
from pathlib import Path

import numpy as np
import pytest
import tifffile

from lommel.microscopy import refinement

ROOT = Path(__file__).resolve().parents[2]
TRUTH = ROOT / "tests" / "truth"
TRUE = json.loads((TRUTH / "microsim.json").read_text(encoding="utf-8"))
FIELD = 0.99  # of the light in focus falls on the simulated field, in which photons are counted
GAIN = 30000 / 65535  # electrons per count, of the simulated camera
SAID = re.findall(r"`(lommel [^`]+ objective\.toml [^`]+)`", (ROOT / "README.md").read_text(encoding="utf-8"))
COMMANDS = {words[1]: words[1:] for line in SAID for words in [shlex.split(line)]}


@pytest.fixture
def folder(tmp_path):
    """A user's folder: stacks, and the example of the objective under the name that README has."""
    shutil.copy(TRUTH / "microsim.ome.tif", tmp_path / "stack.ome.tif")
    shutil.copy(TRUTH / "microsim-beads.tif", tmp_path / "beads.tif")
    shutil.copy(ROOT / "examples" / "objectives" / "nikon-60x-1.2-water.toml", tmp_path / "objective.toml")
    return tmp_path


def test_these_are_the_commands_for_microscopes():
    assert list(COMMANDS) == ["psf", "deconvolve", "beads", "localize"]  # the last one takes a movie


def test_the_beads_of_microsim_are_restored_where_they_were_and_as_bright(folder, call_lommel, monkeypatch):
    monkeypatch.setattr(refinement, "_STEPS", 4)  # of each direction of z, which nothing tells here
    result = call_lommel(*COMMANDS["deconvolve"], folder=folder)
    assert result.returncode == 0, result.stderr
    assert "From the OME metadata of the file: 108.3 nm pixels, 350 nm planes apart." in result.stdout
    assert "wavelength of the objective file" not in result.stdout  # that of the stack was taken
    planes = int(re.search(r"in\s+all\s+(\d+)\s+planes\s+of\s+its\s+PSF", result.stdout)[1])
    restored = np.squeeze(tifffile.imread(folder / "restored.ome.tif")).astype(float)
    for bead in TRUE["stack"]:
        around = ([slice(max(round(at) - n, 0), round(at) + n + 1) for at in bead["voxel"]] for n in (4, 3))
        light, part = (restored[tuple(box)] - np.median(restored) for box in around)
        first = [round(at) - 3 for at in bead["voxel"]]
        places = np.indices(part.shape).reshape(3, -1) @ part.ravel() / part.sum() + np.maximum(first, 0)
        assert places == pytest.approx(bead["voxel"], abs=0.1)
        assert GAIN * light.sum() / planes == pytest.approx(bead["photons"] / FIELD, rel=0.07)


def test_the_psf_of_the_bead_of_microsim_has_its_photons_and_no_aberrations(folder, call_lommel):
    result = call_lommel(*COMMANDS["beads"], folder=folder)
    assert result.returncode == 0, result.stderr
    assert "converged: chi2 1.0" in result.stdout
    terms = re.findall(r"^noll \d+ .* (-?[\d.]+) +([\d.]+) +rad$", result.stdout, flags=re.MULTILINE)
    assert len(terms) > 10
    assert all(abs(float(value)) < 4.0 * float(error) for value, error in terms)
    electrons, error = re.search(r"beads\.tif \[0\].* (\d+)\+-(\d+) ", result.stdout).groups()
    assert float(electrons) == pytest.approx(TRUE["bead"]["photons"] / FIELD, abs=3.0 * float(error))
    assert (folder / "fitted.toml").exists()


def test_the_psfs_of_the_objective_are_written(folder, call_lommel):
    assert call_lommel(*COMMANDS["psf"], folder=folder).returncode == 0
    assert tifffile.imread(folder / "psf.ome.tif").shape == (64, 65, 65)
