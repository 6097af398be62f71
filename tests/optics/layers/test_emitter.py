"""What shines: the light of each emitter, against plain sums of plane waves, and what no emitter is."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel.optics.layers.emitter import emitter_of
from plane_waves import intensity

WAVE, PIXEL = 520e-9, 6.5e-6


def objective(NA: float, sample: float) -> lm.Objective:
    immersion = 1.518 if NA > 1.0 else 1.0
    return lm.Objective(
        NA=NA,
        magnification=63,
        immersion=immersion,
        working_distance=0.19e-3,
        coverslip=lm.Layer(1.5255, 170e-6),
        sample=sample,
    )


TIRF, DRY = objective(1.45, 1.33), objective(0.9, 1.4)
EMITTERS = [
    "isotropic",
    lm.Dipole(0.7, 0.4),
    lm.Dipole(1.3, -2.0, wobble=0.4),
    lm.Beam(),
    lm.Beam("x"),
    lm.Beam("y"),
    lm.Beam((0.3, 0.8 - 0.2j)),
    lm.Beam("radial"),
    lm.Beam("azimuthal"),
    lm.Beam("vortex"),
]


@pytest.mark.parametrize("microscope", [TIRF, DRY], ids=["supercritical", "dry"])
@pytest.mark.parametrize("emitter", EMITTERS, ids=repr)
def test_an_emitter_shines_as_the_sum_of_its_plane_waves(microscope, emitter):
    pupil = microscope.pupil(depth=0.2e-6, z=[-0.2e-6, 0.3e-6], wavelength=WAVE, emitter=emitter)
    made = lm.psf(pupil, (5, 7), PIXEL, tol=1e-9, integrate=False)
    y, x = np.mgrid[-2:3, -3:4] * PIXEL
    exact = intensity(microscope, pupil, x.ravel(), y.ravel(), 60, 96) / pupil.power[:, None]
    found = made.values.reshape(2, -1) / np.asarray(made.scale).reshape(-1, 1)
    assert np.abs(found - exact).max() <= 2e-9 * exact.max()


def test_the_scalar_model_has_no_polarisation():
    pupil = DRY.pupil(depth=0.2e-6, z=0.1e-6, wavelength=WAVE, emitter=lm.Scalar("aplanatic"))
    made = lm.psf(pupil, 5, PIXEL, tol=1e-9, integrate=False)
    y, x = np.mgrid[-2:3, -2:3] * PIXEL
    exact = intensity(DRY, pupil, x.ravel(), y.ravel(), 60, 96)[0] / pupil.power
    assert made.values.ravel() / made.scale == pytest.approx(exact, abs=1e-9)


@pytest.mark.parametrize("emitter", [*EMITTERS, "scalar"], ids=repr)
def test_fields_of_any_phase_are_those_of_none_where_there_is_none(emitter):
    light = emitter_of(emitter).light
    rng = np.random.default_rng(1)
    parts = rng.normal(size=len(light.model.orders)) + 1j * rng.normal(size=len(light.model.orders))
    for phi in (0.3, 2.0, -1.1):
        expected = sum(
            (h.form * np.outer(parts, parts.conj())).sum().real
            * (h.cosine * math.cos(h.order * phi) + h.sine * math.sin(h.order * phi))
            for h in light.harmonics
        )
        pairs = zip(light.waves.orders, light.waves.parts, strict=True)
        fields = np.array([(-1j) ** abs(q) * np.exp(1j * q * phi) * parts[j] for q, j in pairs])
        assert (light.waves.form * np.outer(fields, fields.conj())).sum() == pytest.approx(expected, abs=1e-12)


def test_beams_that_go_around_the_axis_are_dark_or_along_it_there():
    given = {"depth": 0.1e-6, "z": [0.0, 0.4e-6], "wavelength": WAVE}
    dark = TIRF.pupil(**given, emitter=lm.Beam("azimuthal"))
    assert dark.radial
    values = lm.psf(dark, 9, PIXEL, tol=1e-9, integrate=False, normalize="peak").values
    assert values[:, 4, 4] == pytest.approx(0.0, abs=1e-9)
    assert np.all(dark.power <= TIRF.pupil(**given, emitter=lm.Beam("x")).power)
    # All light that enters is of one kind or the other: half of it each in unpolarised light.
    both = [TIRF.pupil(**given, emitter=lm.Beam(kind)).power for kind in ("radial", "azimuthal")]
    assert sum(both) / 2 == pytest.approx(TIRF.pupil(**given, emitter=lm.Beam()).power, rel=1e-9)


def test_the_wobble_is_the_share_that_turns_freely():
    given = {"depth": 0.2e-6, "wavelength": WAVE}
    fixed, free, part = (TIRF.pupil(**given, emitter=lm.Dipole(0.6, 0.9, wobble=share)) for share in (0.0, 1.0, 0.25))
    light = [
        lm.psf(one, 7, PIXEL, tol=1e-9, integrate=False, normalize="strehl").values * one.power
        for one in (fixed, free, part)
    ]
    assert light[2] == pytest.approx(0.75 * light[0] + 0.25 * light[1], abs=1e-8)
