"""Phase retrieval from bead stacks of a microscope: estimates scatter as their standard errors say."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from objectives import OIL

NOISE = lm.Noise(read=1.6, offset=100)
Z = np.linspace(-0.8e-6, 0.8e-6, 5)
GIVEN = {"depth": 0.1e-6, "wavelength": 600e-9}


def recorded(true, photons, seed, emitter="isotropic"):
    """Return images of a bead, and where its axis is."""
    rng = np.random.default_rng(seed)
    center = tuple(8.0 + rng.uniform(-0.5, 0.5, 2))
    pupil = OIL.pupil(**GIVEN, z=Z, aberrations=true, emitter=emitter)
    light = lm.psf(pupil, 17, 6.5e-6, center=center, tol=1e-6).values
    return NOISE.record(photons * light + 5.0, seed=seed), center


@pytest.mark.parametrize(
    ("seed", "emitter"),
    [*((seed, "isotropic") for seed in range(4)), *((seed, lm.Dipole(0.9, 0.3)) for seed in (4, 5))],
)
def test_the_aberrations_of_a_stack_are_found_within_their_standard_errors(seed, emitter):
    rng = np.random.default_rng(100 + seed)
    given = rng.normal(size=6)
    given *= (0.4, 0.8)[seed % 2] / np.linalg.norm(given)
    true = lm.Wavefront.zernike({4 + k: c for k, c in enumerate(given)}, order="noll")
    images, center = recorded(true, 2e4, seed, emitter)
    start = OIL.pupil(**GIVEN, z=Z, emitter=emitter)
    found = lm.retrieve(images, start, pixel=6.5e-6, noise=NOISE, terms=6)
    assert found.converged, found.message
    off = [(c - t) / found.errors[name] for (name, c), t in zip(found.coefficients.items(), given, strict=True)]
    assert np.abs(off).max() <= 4.5
    for axis, place in enumerate(("row", "column")):
        assert (np.abs(found.center[:, axis] - center[axis]) <= 5.0 * found.errors[place]).all()
    again = lm.psf(found.pupil, 17, 6.5e-6)
    assert again.pupil.shape == (5,)
    assert found.psf.shape == (5, 17, 17)


def test_aberrations_of_the_pupil_that_are_not_terms_are_fixed():
    fixed = lm.Wavefront.zernike({11: 0.3, 5: 0.1}, order="noll")
    images, _ = recorded(fixed + lm.Wavefront.zernike({5: 0.4}, order="noll"), 5e4, 3)
    start = OIL.pupil(**GIVEN, z=Z, aberrations=fixed)
    found = lm.retrieve(images, start, pixel=6.5e-6, noise=NOISE, terms=["noll 5"])
    assert found.converged
    assert found.coefficients["noll 5"] == pytest.approx(0.5, abs=5.0 * found.errors["noll 5"])
    assert found.wavefront.to_zernike(order="noll", normalization="rms")[11] == pytest.approx(0.3)


@pytest.mark.parametrize(
    ("pupil", "more", "told"),
    [
        ({"z": Z[:2]}, {}, "pupil must have one plane, or one for each of 5 images"),
        ({"z": Z}, {"defocus": 1.0}, "defocus must be 0 for an Objective"),
        ({"z": Z}, {"also": ("center", "wavelength")}, "also must be .* for an Objective, got 'wavelength'"),
        ({"z": Z, "aberrations": lm.Wavefront(np.arange(5.0))}, {}, "one set of aberrations, shared by all planes"),
    ],
)
def test_what_an_objective_lacks_is_refused(pupil, more, told):
    images, _ = recorded(None, 1e3, 1)
    with pytest.raises(ValueError, match=told):
        lm.retrieve(images, OIL.pupil(**GIVEN, **pupil), pixel=6.5e-6, noise=NOISE, **more)


def test_a_wrong_step_is_a_misfit_however_strong_the_aberrations_that_are_tried():
    true = lm.Wavefront.zernike({5: 0.3, 6: 0.5, 7: -0.2}, order="noll")
    images, _ = recorded(true, 5e4, 4)
    found = lm.retrieve(images, OIL.pupil(**GIVEN, z=-Z / 3.0), pixel=6.5e-6, noise=NOISE, terms=6, starts=3)
    assert not found.converged
    assert "z (step, direction)" in found.message


def test_starts_too_strong_to_be_computed_are_left_out(monkeypatch):
    images, _ = recorded(lm.Wavefront.zernike({6: 0.5}, order="noll"), 5e4, 5)
    monkeypatch.setattr(lm.estimation.phase_retrieval, "_SPREAD", 200.0)
    found = lm.retrieve(images, OIL.pupil(**GIVEN, z=-Z / 3.0), pixel=6.5e-6, noise=NOISE, terms=3, starts=5)
    assert not found.converged
    assert found.starts == 5
