"""Gibson and Lanni's microscope as others compute it (make peers)."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

import numpy as np
import pytest

import lommel as lm

ROOT = Path(__file__).resolve().parents[3]
PAGE = (ROOT / "docs" / "microscopes-peers.md").read_text(encoding="utf-8")
microscope_peers = runpy.run_path(str(ROOT / "benchmarks" / "microscope_peers.py"))
DEPTH = 2e-6
Z = np.linspace(-1.0, 3.0, 21)  # micrometres


@pytest.mark.parametrize(("NA", "most"), [(1.2, 5e-4), (1.3, 5e-4), (1.4, 2e-2)])
@pytest.mark.parametrize("vectorial", [True, False])
def test_psfmodels_agrees_within_its_quadrature(NA, most, vectorial):
    # Its pixels at whole numbers of steps are not interpolated, and with sf=1 they are not averaged.
    psfmodels = pytest.importorskip("psfmodels")
    layers = {"NA": NA, "ni": 1.515, "ni0": 1.515, "ng": 1.5255, "ng0": 1.5255, "ns": 1.33, "tg": 170, "tg0": 170}
    model = psfmodels.vectorial_psf if vectorial else psfmodels.scalar_psf
    peer = model(
        Z, nx=21, dxy=0.05, pz=1e6 * DEPTH, wvl=0.61, params={**layers, "ti0": 150, "sf": 1}, normalize=False
    )
    objective = lm.Objective(
        NA=NA,
        magnification=60,
        immersion=1.515,
        working_distance=150e-6,
        coverslip=lm.Layer(1.5255, 170e-6),
        sample=1.33,
    )
    kind = objective.fields if vectorial else objective.scalar
    # Its z counts from the paraxial focus, plus the depth.
    focus = DEPTH * 1.515 / 1.33 + 1e-6 * Z - DEPTH
    ours = kind(np.arange(11) * 0.05e-6, depth=DEPTH, focus=focus, wavelength=0.61e-6).intensity
    theirs = peer[:, 10, 10:]
    assert np.abs(ours / ours.max() - theirs / theirs.max()).max() < most


@pytest.mark.parametrize("name", microscope_peers["PEERS"])
def test_the_page_has_what_the_packages_say(name):
    told = re.split(r"^### ", PAGE, flags=re.MULTILINE)
    (section,) = (part for part in told if part.startswith(name))
    answer = microscope_peers["compared"](name)
    if answer is None:
        pytest.skip(f"{name} is not installed: make peers")
    version, rows = answer
    assert section.startswith(f"{name} {version}\n")
    written = dict(re.findall(r"^\| (.+?) \| ([\d.e+-]+) ?.*\|$", section, flags=re.MULTILINE))
    assert written.keys() == {row.asked for row in rows}
    for row in rows:
        # What rounding is of differs by machine.
        assert row.found == pytest.approx(float(written[row.asked]), rel=0.1, abs=1e-6)
