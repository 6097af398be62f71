"""Random microscopes, emitters, aberrations and windows: no error is above its bound, by sums of plane waves."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from objectives import OIL, OIL_60X, WATER_40X, oil
from plane_waves import intensity

DRY = lm.Objective(
    NA=0.8, magnification=40, immersion=1.0, working_distance=0.5e-3, coverslip=lm.Layer(1.5255, 17e-5), sample=1.36
)
TIRF = lm.Objective(
    NA=1.49,
    magnification=100,
    immersion=1.518,
    working_distance=0.12e-3,
    coverslip=lm.Layer(1.5255, 17e-5),
    sample=1.33,
)
OBJECTIVES = [OIL, OIL_60X, WATER_40X, DRY, TIRF, oil(films=[lm.Layer(1.9, 8e-8)])]


def system(seed):
    """Return an objective, a pupil, and a wavefront that may be added to its aberrations."""
    rng = np.random.default_rng(seed)
    objective = OBJECTIVES[rng.integers(len(OBJECTIVES))]
    dipole = rng.uniform(0.0, np.pi), rng.uniform(-3.0, 3.0)
    jones = complex(rng.normal()), complex(rng.normal(), rng.normal())
    emitters = ["isotropic", lm.Dipole(*dipole), lm.Dipole(*dipole, wobble=rng.uniform()), lm.Scalar("aplanatic")]
    emitters += [lm.Beam(), lm.Beam(jones), lm.Beam("radial"), lm.Beam("azimuthal"), lm.Beam("vortex")]
    degree = int(rng.integers(2, 8))
    terms = {(n, m): rng.normal() for n in range(1, degree + 1) for m in range(-n, n + 1, 2) if rng.random() < 0.5}
    size = np.sqrt(sum(c * c for c in terms.values())) or 1.0
    rms = 2.0 * np.pi * rng.uniform(0.0, 0.25)
    wavefront = lm.Wavefront.zernike({term: c * rms / size for term, c in terms.items()})
    given = {"depth": 10.0 ** rng.uniform(-8.5, -5.3), "wavelength": rng.uniform(450e-9, 700e-9)}
    emitter = emitters[rng.integers(len(emitters))]
    pupil = objective.pupil(**given, z=rng.uniform(-8e-7, 8e-7), emitter=emitter, aberrations=wavefront)
    return rng, objective, pupil


@pytest.mark.parametrize("seed", range(48))
def test_samples_and_slopes_are_within_their_bounds(seed):
    rng, objective, pupil = system(seed)
    tol, pixel = 10.0 ** rng.uniform(-8.0, -2.0), rng.uniform(0.1, 0.8) * pupil.scale
    center = tuple(rng.uniform(-0.5, 3.5, 2))
    asked = {"center": center, "integrate": False, "dtype": np.float64, "method": lm.ChordalDebye(tol)}
    made = lm.psf(pupil, (4, 3), pixel, derivatives=("row", "column"), **asked)
    y, x = (pixel * (np.arange(side) - at) for side, at in zip((4, 3), center, strict=True))

    def exact(down=0.0, across=0.0):
        places = np.meshgrid(y - down * pixel, x - across * pixel, indexing="ij")
        light = intensity(objective, pupil, places[1].ravel(), places[0].ravel(), 72, 128)
        return light.reshape(4, 3) / pupil.power[0] * made.scale

    known = exact()
    assert np.abs(made.values - known).max() <= (made.error_bound + 2e-10) * known.max()
    assert made.error_bound <= tol
    h = 1e-2
    for name in ("row", "column"):
        ends = [exact(s * h, 0.0) if name == "row" else exact(0.0, s * h) for s in (1, -1, 2, -2)]
        slope = (8.0 * (ends[0] - ends[1]) - (ends[2] - ends[3])) / (12.0 * h)
        off = np.abs(made.derivatives[name] - slope).max()
        assert (
            off <= made.derivative_bounds[name] * made.values.max() + 1e-7 * np.abs(slope).max() + 1e-8 * known.max()
        )
