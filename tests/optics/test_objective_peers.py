"""Gibson and Lanni's microscope as others compute it (make peers)."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm

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
