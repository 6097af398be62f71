"""Stacks of beads: images against sums of plane waves over the ball, estimates, score tests, verdicts, bad input."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
import plane_waves
import searches
from lommel import _core
from lommel.estimation import bead_checks, bead_images, beads
from lommel.estimation.bead_checks import is_possible, missing_findings
from lommel.estimation.bead_images import AMPLITUDES, CONSTANTS, BeadImages, Place, Setup, Stack, changed_objective
from lommel.estimation.bead_search import Prior
from lommel.estimation.favoured_effects import Round
from lommel.fit.findings import Finding, Findings
from lommel.fit.score_tests import ScoreTest
from lommel.optics.layers.emitter import emitter_of
from lommel.optics.layers.stratified import Design
from lommel.special import zernike
from objectives import OIL, oil

WAVE, PIXEL = 600e-9, 6.5e-6
Z = np.linspace(-0.9e-6, 0.9e-6, 9)
NOISE = lm.Noise(read=1.6, offset=100)
GIVEN = {"z": Z, "noise": NOISE, "diameter": 0.1e-6, "threads": 1, "starts": 1}
TERMS = tuple(zernike.term(5 + k, "noll") for k in range(7))


def fitted(stacks, objective, *, aberrations=None, **given):
    """Return the fit of stacks of beads through an objective."""
    microscope = lm.Microscope(objective, WAVE, PIXEL, aberrations=aberrations)
    return searches.fit_beads(stacks, microscope, **given)


class _AskedError(Exception):
    """The beads of a fit that was asked for."""


@pytest.mark.parametrize("fits", [True, False])
def test_the_bead_that_is_held_out_is_not_among_those_that_are_fitted(monkeypatch, fits):
    def asked(state, others):
        raise _AskedError(list(others))

    monkeypatch.setattr(bead_checks, "_restricted", asked)
    model = SimpleNamespace(stacks=[0] * 6, brightest_first=lambda: [5, 3, 1, 0, 2, 4], with_beads=list)
    with pytest.raises(_AskedError) as found:
        bead_checks.held_out(model, SimpleNamespace(state=None, fits=lambda _: fits), lambda *_: None)
    (others,) = found.value.args
    assert others == ([0, 1, 2, 3, 4] if fits else [3, 1, 0, 2, 4][: bead_checks._MISFIT_BEADS])


def waves(seed, rms=0.12, terms=TERMS):
    """Return random coefficients of terms, radians rms."""
    drawn = np.random.default_rng(1000 + seed).normal(size=len(terms))
    return drawn * (2.0 * np.pi * rms / np.linalg.norm(drawn))


def wavefront(coefficients, terms=TERMS):
    """Return the wavefront of coefficients of terms."""
    return lm.Wavefront.zernike(dict(zip(terms, coefficients, strict=True)))


def recorded(
    seed, coefficients, objective=OIL, *, light=1e4, depth=50e-9, diameter=0.1e-6, z=Z, pixel=PIXEL, size=15,
    terms=TERMS, moved=(0.0, 0.0), draw=0,
):  # fmt: skip
    """Return the stack of a bead, by a certified PSF, and where it is."""
    rng = np.random.default_rng(seed)
    row, column, up = *rng.uniform(-0.8, 0.8, 2), rng.uniform(-80e-9, 80e-9)
    row, column = row + moved[0], column + moved[1]
    waves_of = wavefront(coefficients, terms)
    pupil = objective.pupil(depth=depth, z=z - up, wavelength=WAVE, aberrations=waves_of)
    center = size // 2 + row, size // 2 + column
    method = lm.methods.Bead(diameter, 1e-4)
    made = lm.psf(pupil, size, pixel, method=method, integrate=True, center=center).values
    return NOISE.record(light * made.astype(float) + 10.0, seed=seed + draw), (*center, up)


def ball(count):
    """Return points in a ball of radius 1, (x, y, u), and weights, by quadrature in all three dimensions."""
    u, w = np.polynomial.legendre.leggauss(count)
    s, v = np.polynomial.legendre.leggauss(count)
    s, v = 0.5 * (1.0 + s), 0.5 * v
    turn = 2.0 * np.pi * np.arange(2 * count) / (2 * count)
    rho = np.sqrt((1.0 - u[:, None] ** 2) * s)[..., None]
    share = (w * (1.0 - u**2))[:, None, None] * v[:, None] * np.ones(turn.size)
    x, y, up = np.broadcast_arrays(rho * np.cos(turn), rho * np.sin(turn), u[:, None, None])
    return x, y, up, share / share.sum()


def test_dry_samples_are_fitted_and_the_index_of_air_is_known():
    dry = lm.Objective(
        NA=0.8, magnification=40, immersion=1.0, working_distance=1e-3, coverslip=lm.Layer(1.5, 170e-6), sample=1.0
    )
    true, z = waves(2), np.linspace(-2e-6, 2e-6, 5)
    image, _ = recorded(2, true, dry, z=z, light=4e4)
    found = fitted(image, dry, **(GIVEN | {"z": z}), terms=TERMS)
    assert found.converged
    assert not {"sample", "immersion"} & set(found.coefficients)
    errors = np.array([found.coefficients[term] for term in TERMS]) - true
    assert np.sqrt(np.mean((errors / np.sqrt(np.diag(found.covariance))[: len(TERMS)]) ** 2)) < 2.0
    with pytest.raises(ValueError, match=r"priors must be without 'sample': .* or the medium is air"):
        fitted(image, dry, **(GIVEN | {"z": z}), terms=TERMS, priors={"sample": 0.01})


@pytest.mark.parametrize("diameter", [0.1e-6, 0.25e-6])
def test_images_are_those_of_plane_waves_summed_over_the_ball_and_the_pixel(diameter):
    coefficients, place = waves(1, 0.15), Place(0.3, -0.2, 0.15e-6, 0.5 * diameter)
    z, size = np.array([-0.5e-6, 0.2e-6]), 21
    stack = Stack(np.ones((4, 2, size * size)), (size, size), z)
    setup = Setup(OIL, WAVE, OIL.pupil(depth=0.0, wavelength=WAVE).emitter, PIXEL, diameter)
    found = BeadImages(TERMS, {}, 1).values(setup, coefficients, place, stack)
    rows, columns = np.array([10, 11, 8, 13, 5]), np.array([10, 9, 12, 10, 4])
    sub, weight = np.polynomial.legendre.leggauss(3)
    dy, dx = np.meshgrid(0.5 * sub, 0.5 * sub, indexing="ij")
    x, y, up, share = ball(4 if diameter > 2e-7 else 3)
    total, power = np.zeros((2, rows.size)), 0.0
    aberrations = wavefront(coefficients)
    for k in range(x.shape[0]):
        depth = place.depth + 0.5 * diameter * up[k, 0, 0]
        pupil = OIL.pupil(
            depth=depth, z=place.focus + z, wavelength=WAVE, aberrations=aberrations, origin="coverslip"
        )
        shift = 0.5 * diameter * OIL.magnification / PIXEL
        at_x = columns[:, None, None] - 10 - place.column + dx.ravel()[:, None] - shift * x[k].ravel()
        at_y = rows[:, None, None] - 10 - place.row + dy.ravel()[:, None] - shift * y[k].ravel()
        made = plane_waves.intensity(OIL, pupil, PIXEL * at_x.ravel(), PIXEL * at_y.ravel(), 24, 48)
        made = made.reshape(2, rows.size, dx.size, -1)
        total += np.einsum("zpqb,q,b->zp", made, np.outer(weight, weight).ravel() / 4.0, share[k].ravel())
        power += share[k].sum() * pupil.power[0]
    cell = (2.0 * np.pi * OIL.NA * PIXEL / (WAVE * OIL.magnification)) ** 2 / (4.0 * np.pi)
    true = cell * total / power
    np.testing.assert_allclose(found[:, rows, columns], true, rtol=0, atol=3e-4 * found.max())


@pytest.mark.parametrize("name", [*CONSTANTS, *AMPLITUDES, "row", "column", "focus", 0, 5])
def test_derivatives_are_differences_of_images(name):
    coefficients, place = waves(2), Place(0.3, -0.2, 0.1e-6, 80e-9)
    stack = Stack(np.ones((4, 3, 225)), (15, 15), np.array([-0.6e-6, 0.0, 0.5e-6]), np.array([1.0, 0.0, 0.0]))
    start = oil(apodization=lm.Apodization.zernike({2: -0.2, 4: 0.1})) if name in AMPLITUDES else OIL
    emitter = lm.Dipole(1.5, 0.4, wobble=1.0 if name not in ("wobble", "azimuth") else 0.6)
    setup = Setup(start, WAVE, emitter, PIXEL, 0.1e-6)
    images = BeadImages(TERMS, {(6, 0): 0.1}, 1)

    def at(h):
        if isinstance(name, int):
            return setup, coefficients + h * np.eye(len(TERMS))[name], place
        if name in place._fields:
            return setup, coefficients, place._replace(**{name: getattr(place, name) + h})
        return setup.with_constant(name, setup.value(name) + h), coefficients, place

    steps = {"row": 1e-3, "column": 1e-3, "focus": 1e-9} | {key: 0.2 * of.step for key, of in CONSTANTS.items()}
    h = steps.get(name, 1e-3) * (PIXEL if name == "pixel" else 1.0)
    exact = (images.values(*at(h), stack) - images.values(*at(-h), stack)) / (2.0 * h)
    if name in CONSTANTS:
        found = images.differences(setup, coefficients, place, stack, name)
    elif name in AMPLITUDES:
        found = images.derivatives(setup, coefficients, place, stack, (name,))[-1]
    else:
        order = [*range(len(TERMS)), "focus", "row", "column"]
        found = images.derivatives(setup, coefficients, place, stack)[order.index(name)]
    # Of the middle of the bead alone: its two discs differ by little.
    assert np.abs(found - exact).max() <= 0.06 * np.abs(exact).max()


@pytest.mark.parametrize("samples", [1, 10**9])
def test_images_of_planes_computed_in_groups_are_those_of_single_planes(monkeypatch, samples):
    setup, model = Setup(OIL, WAVE, emitter_of("isotropic"), PIXEL, 0.1e-6), BeadImages(TERMS, {}, 1)
    place, stack = Place(0.3, -0.2, 0.1e-6, 60e-9, 0.2, -0.1), Stack(np.ones((4, 9, 225)), (15, 15), Z)
    monkeypatch.setattr(bead_images, "_MOST_SAMPLES", samples)
    images = [model.values(setup, waves(1), place, stack), model.derivatives(setup, waves(1), place, stack)]
    # The drift displaces planes in proportion to time: a plane alone has that of its place.
    for k, time in enumerate(stack.times):
        alone = place._replace(row=0.3 + 0.2 * time, column=-0.2 - 0.1 * time, drift_row=0.0, drift_column=0.0)
        one = Stack(np.ones((4, 1, 225)), (15, 15), Z[k : k + 1])
        for found, of in zip(images, (model.values, model.derivatives), strict=True):
            single = of(setup, waves(1), alone, one)[..., 0, :, :]
            largest = np.abs(single).max(axis=(-2, -1), keepdims=True)
            np.testing.assert_array_less(np.abs(found[..., k, :, :] - single) / largest, 2e-3)


def test_beads_at_fractions_of_a_pixel_share_their_tables():
    setup, images = Setup(OIL, WAVE, emitter_of("isotropic"), PIXEL, 0.1e-6), BeadImages(TERMS, {}, 1)
    stack = Stack(np.zeros((4, 2, 121)), (11, 11), np.array([0.0, 2e-7]))
    kept = []
    for place in (Place(0.0, 0.0, 0.0, 1e-7), Place(0.2, -0.3, 0.0, 1e-7), Place(-0.4, 0.1, 0.0, 1e-7)):
        images.values(setup, waves(1), place, stack)
        kept.append(_core.cached_bytes()[0])
    assert kept[0] == kept[1] == kept[2]


def test_images_are_smooth_in_the_depth_of_a_bead_that_reaches_the_glass():
    stack = Stack(np.ones((4, 2, 225)), (15, 15), np.array([-0.4e-6, 0.3e-6]))
    setup = Setup(OIL, WAVE, OIL.pupil(depth=0.0, wavelength=WAVE).emitter, PIXEL, 0.1e-6)
    images = BeadImages((), {}, 1)
    values = [
        images.values(setup, np.zeros(0), Place(0.3, -0.2, 0.1e-6, depth), stack) for depth in (46e-9, 50e-9, 54e-9)
    ]
    below, above = np.diff(values, axis=0)
    assert np.abs(above - below).max() < 0.1 * np.abs(above).max()
    found = images.differences(setup, np.zeros(0), Place(0.3, -0.2, 0.1e-6, 50e-9), stack, "depth")
    np.testing.assert_allclose(4e-9 * found, 0.5 * (below + above), atol=1e-3 * np.abs(above).max())


@pytest.mark.parametrize(("displaced", "name"), [([0, 1, 2], "planes 0 to 2"), ([4], "plane 4")])
def test_planes_that_the_stage_displaced_are_found_and_their_displacement_is_estimated(displaced, name):
    given, true_z = waves(3, 0.1), Z.copy()
    true_z[displaced] += 60e-9
    images, _ = recorded(3, given, z=true_z, light=3e4)
    found = fitted(images, OIL, **GIVEN, terms=TERMS, priors={})
    assert found.status == "converged"
    assert [*found.findings.get("estimated").numbers] == [f"{name} displaced along z", "move"]
    assert abs(found.coefficients["jump"] - 60e-9) < 4.0 * found.errors["jump"] < 30e-9
    pulls = [(found.coefficients[t] - a) / found.errors[t] for t, a in zip(TERMS, given, strict=True)]
    assert np.sqrt(np.mean(np.square(pulls))) < 1.6
    assert f"{name} displaced along z " in found.message
    where = {"depth": 1e-6, "z": np.array([0.0]), "shape": 9}
    assert found.psf_errors(**where).shape == (1, 9, 9)


def test_a_dye_that_keeps_polarization_is_estimated_besides():
    given = waves(3, 0.1)
    x_dipole = lm.Dipole(0.5 * np.pi, 0.5, wobble=0.7)
    pupil = OIL.pupil(depth=50e-9, z=Z, wavelength=WAVE, aberrations=wavefront(given), emitter=x_dipole)
    bead = lm.psf(pupil, 15, PIXEL, method=lm.methods.Bead(0.1e-6, 1e-4), integrate=True).values
    found = fitted(NOISE.record(2e4 * bead + 10.0, seed=1), OIL, **GIVEN, terms=TERMS, priors={})
    assert found.status == "converged"
    assert [*found.findings.get("estimated").numbers] == ["a dye that keeps polarization, wobble", "move"]
    assert re.search(r"a dye that keeps polarization, wobble 0.[67]\d* \+- \S+ \(stated 1\)", found.message)
    assert (found.emitter.polar, found.emitter.wobble) == (0.5 * np.pi, found.coefficients["wobble"])
    for name, value in ("wobble", 0.7), ("azimuth", 0.5):
        assert abs(found.coefficients[name] - value) < 3.5 * found.errors[name] < 0.3
    pulls = [(found.coefficients[t] - a) / found.errors[t] for t, a in zip(TERMS, given, strict=True)]
    assert np.sqrt(np.mean(np.square(pulls))) < 1.6


def test_aberrations_and_places_are_found_from_nothing_within_their_standard_errors():
    given = waves(1, 0.28)
    images, (row, column, up) = recorded(1, given, size=17)
    found = fitted(images, OIL, **GIVEN | {"starts": 5}, terms=TERMS, priors={})
    assert found.converged, found.message
    off = [(found.coefficients[t] - c) / found.errors[t] for t, c in zip(TERMS, given, strict=True)]
    assert np.abs(off).max() < 4.5
    one = found.beads[0]
    for value, true, error in ((one.row, row, "row"), (one.column, column, "column"), (one.z, up, "z")):
        assert abs(value - true) < 5.0 * one.errors[error]
    assert found.model_error < 1e-3
    assert 0.5 < np.sqrt(np.mean(((one.flux - 1e4) / one.flux_errors) ** 2)) < 1.6
    assert 0.5 < np.sqrt(np.mean(((one.background - 10.0) / one.background_errors) ** 2)) < 1.6
    assert abs(one.flux.mean() - 1e4) < 4.0 * one.errors["flux"]


# Each microscope differs from the one that is stated in one constant.
WRONG = {
    "sample": {"objective": changed_objective(OIL, "sample", 1.38)},
    "NA": {"objective": changed_objective(OIL, "NA", 1.37)},
    "depth": {"depth": 0.3e-6},
    "diameter": {"diameter": 0.2e-6, "depth": 0.1e-6},
}


@pytest.mark.parametrize(("name", "value"), [("sample", 1.38), ("NA", 1.37), ("depth", 0.3e-6), ("diameter", 0.2e-6)])
def test_a_constant_that_is_wrong_is_estimated_besides(name, value):
    images, _ = recorded(3, given := waves(3, 0.1), **WRONG[name], light=3e4)
    asked = GIVEN | ({"depth": 0.1e-6} if name == "diameter" else {})
    found = fitted(images, OIL, **asked, terms=TERMS, priors={})
    told = found.findings.get("estimated")
    label = f"{name} of bead 0" if name == "depth" else name
    assert (found.status, [*told.numbers]) == ("converged", [label, "move"])
    assert re.search(rf"estimated besides: {label} \S+ \+- \S+( [nu]m)? \(stated \S+\): terms allow", found.message)
    depth = found.beads[0].depth, found.beads[0].errors.get("depth")
    one, error = depth if name == "depth" else (found.coefficients[name], found.errors[name])
    assert abs(one - value) < 4.0 * error
    if name in ("sample", "NA"):
        assert getattr(found.objective, name) == one
    pulls = [(found.coefficients[t] - a) / found.errors[t] for t, a in zip(TERMS, given, strict=True)]
    assert np.sqrt(np.mean(np.square(pulls))) < 1.6
    assert told.numbers["move"] > 1.5


def test_a_wrong_step_is_estimated_besides_and_named_in_nanometres():
    images, _ = recorded(3, waves(3, 0.1), z=Z / 1.25, light=3e4)
    found = fitted(images, OIL, **GIVEN, terms=TERMS, priors={})
    assert found.status == "converged"
    assert re.search(r"estimated besides: step 1[78]\d(\.\d+)? \+- \S+ nm \(stated 225\)", found.message)
    assert abs(found.coefficients["step"] - 0.8) < 4.0 * found.errors["step"] < 0.04


def test_beads_that_all_misfit_are_fitted_by_few_of_them():
    stacks = [recorded(60 + k, waves(3, 0.1), z=Z / 1.25, light=2e4)[0] for k in range(6)]
    found = fitted(stacks, OIL, **GIVEN, terms=TERMS[:3], priors={})
    assert re.search(
        r"no bead fits with the constants as stated: terms and constants are those of [25] of 6 beads", found.message
    )
    assert "step" in found.message


def test_constants_are_plausible_within_six_times_their_expected_errors():
    setup = Setup(OIL, WAVE, lm.Dipole(0.0, 0.0, wobble=1.0), PIXEL, 0.1e-6)
    model = SimpleNamespace(depths=(Prior(50e-9, 0.0),))
    limits = {"sample": (1.33, 0.12), "step": (1.0, 0.4), "pixel": (PIXEL, 0.06 * PIXEL), "depth": (50e-9, 0.3e-6)}
    for name, (stated, largest) in limits.items():
        for side in (0.999, 1.001):
            assert bead_checks._is_plausible(model, setup, name, stated + side * largest) == (side < 1.0)
    for side in (0.999, 1.001):  # of a bead on the glass, the centre is at 50 nm
        assert bead_checks._is_plausible(model, setup, "depth", side * 25e-9) == (side > 1.0)


def test_a_constant_that_would_leave_physics_is_named_without_a_value():
    given = waves(3, 0.1)
    pupil = OIL.pupil(depth=50e-9, z=Z, wavelength=WAVE, aberrations=wavefront(given))
    images = NOISE.record(1e5 * lm.psf(pupil, 17, PIXEL, integrate=False).values.astype(float) + 10.0, seed=1)
    found = fitted(images, OIL, **GIVEN | {"diameter": 0.0}, depth=50e-9, terms=TERMS, priors={})
    blur = next(one for one in found.tests if one.name == "blur")
    assert (blur.size[0] < 0.0, abs(blur.sigmas) > 5.0) == (True, True)
    assert "blur lower than 0 pixels^2, beyond what is possible (" in found.message
    setup = Setup(OIL, WAVE, pupil.emitter, PIXEL, 0.1e-6)
    for name, worst, best in (("sample", 0.9, 1.0), ("NA", 1.52, 1.5), ("depth", 0.0, 0.03e-6), ("step", 0.0, 0.5)):
        assert not is_possible(setup, name, worst)
        assert is_possible(setup, name, best)


def test_what_is_held_and_not_tested_is_named(monkeypatch):
    found = fitted(recorded(3, waves(3, 0.1), light=3e3)[0], OIL, **GIVEN, terms=TERMS, priors={})
    told = found.findings.get("untested")
    assert (told.severity, found.reliable, [*told.numbers]) == ("note", True, ["coverslip", "what"])
    assert "not determined: coverslip (5 um of it changes noll 11 spherical by " in told.text
    monkeypatch.setattr(bead_checks, "missing_tests", lambda *_: ((), None, []))  # bright beads test the cover glass
    bright = [
        fitted(recorded(3, waves(3, 0.1), one, light=1e5)[0], OIL, **GIVEN, terms=TERMS, priors={})
        for one in (changed_objective(OIL, "coverslip", 165e-6), changed_objective(OIL, "coverslip", 175e-6))
    ]
    change = 0.5 * abs(bright[1].coefficients[4, 0] - bright[0].coefficients[4, 0])
    assert change == pytest.approx(told.numbers["coverslip"]["noll 11 spherical"], rel=0.2)


def test_priors_that_the_beads_contradict_within_chance_are_widened():
    pulls = []
    for seed in range(3):
        images, _ = recorded(seed, given := waves(seed, 0.1), light=1e4, depth=85e-9)
        found = fitted(images, OIL, **GIVEN, terms=TERMS, priors={"depth": 10e-9})
        assert found.reliable
        assert next(one for one in found.tests if one.name == "depth").log_bayes > 0.0
        pulls += [(found.coefficients[t] - a) / found.errors[t] for t, a in zip(TERMS, given, strict=True)]
    assert np.abs(pulls).max() < 3.0


def test_errors_allow_for_a_constant_that_the_beads_favour_within_chance():
    pulls = []
    for seed in range(4):
        images, _ = recorded(seed, given := waves(seed, 0.1), light=1e4, depth=90e-9)
        found = fitted(images, OIL, **GIVEN, terms=TERMS, priors={})
        assert found.reliable
        assert next(one for one in found.tests if one.name == "depth").log_bayes > 0.0
        pulls += [(found.coefficients[t] - a) / found.errors[t] for t, a in zip(TERMS, given, strict=True)]
        assert found.aberrations.edge_terms()[4, 0] == pytest.approx(found.coefficients[4, 0] * 5**0.5)
    assert np.abs(pulls).max() < 2.5  # without it, noll 11 is off by more than five
    assert 0.7 < np.sqrt(np.mean(np.square(pulls))) < 1.2


def test_terms_of_the_amplitude_are_found_and_named_where_they_are_not_estimated():
    light = {2: -0.15, 4: 0.04}
    given = waves(4, 0.1)
    images, _ = recorded(6, given, oil(apodization=lm.Apodization.zernike(light)), light=3e4)
    plain = fitted(images, OIL, **GIVEN, terms=TERMS, priors={})
    # One term does not suffice: it is estimated besides, and another doubt remains.
    assert (plain.status, [*plain.findings.get("estimated").numbers]) == ("doubtful", ["apodization_2", "move"])
    found = fitted(images, OIL, **GIVEN, terms=TERMS, priors={}, apodization=2)
    assert found.reliable, found.message
    for n, b in light.items():
        name = f"apodization_{n}"
        assert abs(found.coefficients[name] - b) < 4.0 * found.errors[name]
        assert found.errors[name] < 0.01
        assert found.objective.apodization.to_zernike()[n] == pytest.approx(found.coefficients[name])
    where = {"depth": 1e-6, "z": np.array([-0.3e-6, 0.3e-6])}
    errors = found.psf_errors(**where, shape=15)
    assert errors.max() > 1.05 * plain.psf_errors(**where, shape=15).max()
    true = oil(apodization=lm.Apodization.zernike(light)).pupil(
        **where, wavelength=WAVE, aberrations=wavefront(given)
    )
    off = [
        np.abs(lm.psf(one, 15, PIXEL).values - lm.psf(true, 15, PIXEL).values).max()
        for one in (found.pupil(**where), plain.pupil(**where))
    ]
    assert off[0] < 4.0 * errors.max() < off[1]


def test_immersion_and_cover_glass_are_named_together():
    images, _ = recorded(4, waves(3, 0.1), oil(design=Design(1.515, OIL.coverslip)))
    other = oil(design=Design(1.515, OIL.coverslip))
    stated = changed_objective(other, "immersion", 1.516)
    found = fitted(images, stated, **GIVEN, terms=TERMS, priors={})
    assert {*found.findings.get("estimated").numbers} == {"immersion", "coverslip", "move"}
    assert abs(found.objective.immersion - 1.518) < 2.0 * found.errors["immersion"] < 2e-3


def test_constants_with_priors_are_estimated_and_right_ones_not_suspected():
    images, _ = recorded(5, waves(5), changed_objective(OIL, "sample", 1.335), light=3e4)
    found = fitted(images, OIL, **GIVEN, terms=TERMS, priors={"sample": (1.33, 0.02), "depth": 5e-9})
    assert found.reliable, found.message
    assert found.objective.sample == pytest.approx(1.335, abs=4.0 * found.errors["sample"])
    assert found.errors["sample"] < 0.01
    assert float(re.search(r"sample: (\S+)", repr(found))[1]) == pytest.approx(found.objective.sample, abs=1e-3)
    sure = fitted(images, OIL, **GIVEN, terms=TERMS, priors={"sample": (1.33, 1e-6), "depth": 5e-9})
    assert sure.objective.sample == pytest.approx(1.33, abs=1e-5)


def test_an_estimate_far_from_its_prior_is_a_doubt_that_names_it():
    model = SimpleNamespace(priors={"diameter": Prior(0.1e-6, 10e-9), "sample": Prior(1.33, 0.02)})
    state = SimpleNamespace(setup=SimpleNamespace(value={"diameter": 0.22e-6, "sample": 1.38}.get))
    (told,) = bead_checks.prior_findings(model, state)
    assert (told.code, told.severity) == ("contradiction", "doubt")
    assert told.numbers == {"diameter": pytest.approx(12.0)}
    assert told.text.startswith("diameter 0.22 um is 12 prior errors from 0.1 +- 0.01:")
    assert bead_checks.prior_findings(model, state, ["diameter"]) == []


def test_a_medium_far_from_its_prior_is_told_once_with_the_strehl_ratio_it_costs():
    setup = Setup(OIL, WAVE, lm.Dipole(0.0, 0.0, wobble=1.0), PIXEL, 0.1e-6)
    changed = setup.with_constant("coverslip", OIL.coverslip.thickness + 40e-6)
    joint = SimpleNamespace(priors={"coverslip": Prior(OIL.coverslip.thickness, 5e-6)}, depths=())
    fit = SimpleNamespace(state=SimpleNamespace(setup=changed))
    tests = [
        ScoreTest(name, np.array([size]), np.array([1e-4]), 7.4, 20.0)
        for name, size in (("coverslip", 40e-6), ("immersion", 1e-3))
    ]
    (told,), _ = missing_findings(Round((joint, fit), (tests, None, [])), setup, joint)
    assert (told.code, told.severity) == ("contradiction", "doubt")
    assert re.match(
        r"coverslip 210 um is 8 prior errors from 170 \+- 5, or as well immersion = 1\.519\d* .*, which", told.text
    )
    told = bead_checks.with_strehl(Findings([told]), (0.935, 0.002)).get("contradiction")
    assert told.text.endswith("or they stand for spherical aberration: the Strehl ratio is 0.9350 +- 0.0020")
    assert (told.numbers["strehl"], told.numbers["coverslip"]) == (0.935, pytest.approx(8.0))
    other = Findings([Finding("contradiction", "doubt", "these stand for another error of the model", {"NA": 9.0})])
    assert bead_checks.with_strehl(other, (0.935, 0.002)) is other


@pytest.mark.parametrize("error", [5e-6, 40e-6])
def test_the_strehl_ratio_is_that_of_the_design_whatever_medium_has_the_aberration(error):
    """A cover glass that its prior holds, or does not, shares the spherical aberration with the terms."""
    design = changed_objective(OIL, "sample", 1.5)
    thick = changed_objective(design, "coverslip", OIL.coverslip.thickness + 20e-6)
    images, _ = recorded(21, np.zeros(len(TERMS)), thick, light=1e5)
    found = fitted(images, design, **GIVEN, terms=TERMS, priors={"coverslip": error})
    z = np.linspace(-1.5e-6, 1.5e-6, 121)
    peaks = [
        lm.psf(one.pupil(depth=50e-9, z=z, wavelength=WAVE), 1, 1e-7, integrate=False).values.max()
        for one in (thick, design)
    ]
    strehl, rms = found.strehl(depth=50e-9), found.rms(depth=50e-9)
    assert peaks[0] / peaks[1] < 0.985
    assert strehl[0] == pytest.approx(peaks[0] / peaks[1], abs=3.0 * strehl[1] + 3e-3)
    assert strehl[1] < 0.01
    assert strehl[0] == pytest.approx(math.exp(-(rms[0] ** 2)), abs=0.01)


def test_a_stack_in_reversed_order_is_told_before_constants():
    images, _ = recorded(6, waves(6), light=2e4)
    found = fitted(images[::-1], OIL, **GIVEN, terms=TERMS, priors={})
    assert not found.converged
    assert "reversed_z" in found.findings.codes
    assert "other_explanation" not in found.findings.codes
    again = fitted(images[::-1], OIL, **GIVEN | {"z": -Z}, terms=TERMS, priors={})
    assert again.converged


def test_several_beads_share_the_microscope():
    given = waves(7)
    stacks = [recorded(30 + k, given, depth=depth)[0] for k, depth in enumerate((50e-9, 1e-6))]
    alone = fitted(stacks[0], OIL, **GIVEN, terms=TERMS, priors={})
    found = fitted(stacks, OIL, **GIVEN, depth=[50e-9, 1e-6], terms=TERMS, priors={})
    assert found.converged
    for term, c in zip(TERMS, given, strict=True):
        assert abs(found.coefficients[term] - c) < 4.5 * found.errors[term]
        assert found.errors[term] < 0.9 * alone.errors[term]
    assert [one.used for one in found.beads] == [True] * 2


def test_a_term_that_differs_between_beads_is_named_and_no_neighbor():
    given = waves(7, 0.1)
    other = given + 0.25 * np.eye(len(TERMS))[3]  # coma at the corner of the field
    stacks = [recorded(30 + k, one, light=2e4)[0] for k, one in enumerate((given, given, other))]
    found = fitted(stacks, OIL, **GIVEN, terms=TERMS, priors={})
    first = found.tests[0]
    assert first.name == "noll 8 coma x of bead 2 unlike that of the other beads"
    assert abs(first.size[0] - 0.25) < max(5.0 * first.errors[0], 0.05)
    assert "neighbor" not in found.message
    assert f"the data favour {first.name}" in found.message
    alike = fitted(stacks[:2], OIL, **GIVEN, terms=TERMS, priors={})
    assert alike.reliable
    assert next(one for one in alike.tests if "unlike" in one.name).log_bayes < 3.0


def test_further_beads_have_places_and_errors_as_if_they_were_of_the_joint_fit():
    given = waves(7, 0.1)
    drawn = [recorded(30 + k, given, light=2e4) for k in range(4)]
    stacks, places = [one for one, _ in drawn], [place for _, place in drawn]
    empty = NOISE.record(np.full(stacks[0].shape, 10.0), seed=5)
    asked = GIVEN | {"terms": TERMS, "priors": {"depth": 20e-9}}
    every = fitted(stacks, OIL, **asked)
    few = fitted([*stacks, empty], OIL, **asked, joint=2)
    assert "terms and constants are those of 2 of 5 beads" in few.message
    assert few.converged
    for one, whole, (row, column, up) in zip(few.beads, every.beads, places, strict=False):
        assert one.used
        for value, true, key in ((one.row, row, "row"), (one.column, column, "column"), (one.z, up, "z")):
            assert abs(value - true) < 4.5 * one.errors[key]
            assert one.errors[key] == pytest.approx(whole.errors[key], rel=0.3)
    # Errors common to all beads cancel in differences of heights.
    z, c = np.array([one.z for one in few.beads]), few.z_covariance
    differences = [z[k] - z[0] - places[k][2] + places[0][2] for k in (1, 2, 3)]
    errors = [math.sqrt(c[0, 0] + c[k, k] - 2.0 * c[0, k]) for k in (1, 2, 3)]
    assert np.abs(np.divide(differences, errors)).max() < 3.5
    np.linalg.cholesky(c / np.sqrt(np.outer(np.diag(c), np.diag(c))))


def test_constants_that_differ_from_the_stated_ones_are_named_with_both_values():
    stated = Setup(OIL, WAVE, emitter_of("isotropic"), PIXEL, 0.1e-6)
    values = {(2, 2): 0.3, "NA": 1.36, "pixel": 1.019 * PIXEL, "diameter": 0.12e-6, "sample": 1.4}
    errors = {(2, 2): 0.01, "NA": 0.001, "pixel": 1e-9, "diameter": 8e-9, "sample": math.nan}
    (found,) = bead_checks.stated_findings(stated, values | {"blur": 0.3}, errors | {"blur": 0.01}, ())
    assert (found.code, found.severity, [*found.numbers]) == ("estimated", "note", ["NA"])
    assert found.text.startswith("estimated unlike stated: NA 1.3600 +- 0.0010 (stated 1.4): terms allow")
    assert not bead_checks.stated_findings(stated, values, errors, ["NA"])


def test_the_maximum_of_a_quadratic_function_with_cross_terms_is_found_in_one_step():
    curvature = np.array([[-2.0, 0.8, -0.5], [0.8, -1.5, 0.3], [-0.5, 0.3, -1.0]])
    place = np.array([0.3, -0.2, 0.4])
    grid = np.stack(np.meshgrid(*3 * (np.arange(-2.0, 3.0),), indexing="ij"), axis=-1) - place
    values = 10.0 + 0.5 * np.einsum("...i,ij,...j->...", grid, curvature, grid)
    np.testing.assert_allclose(beads._to_maximum(values, (2, 2, 2)), place, atol=1e-12)


def test_the_error_of_the_strehl_ratio_is_that_of_all_coefficients():
    found = fitted(
        recorded(3, waves(3, 0.1))[0], OIL, **GIVEN, terms=[(2, 2), (3, 1), (4, 0)], priors={"coverslip": 5e-6}
    )
    scales, slopes = np.sqrt(np.diag(found.covariance)), []
    for k, scale in enumerate(scales):
        step = 0.3 * scale * np.eye(len(scales))[k]
        pair = []
        for sign in (-1.0, 1.0):
            state = replace(found._state, waves=found._state.waves + sign * step[:3])
            setup = state.setup.with_constant("coverslip", state.setup.value("coverslip") + sign * step[3])
            changed = replace(found, _state=replace(state, setup=setup), objective=setup.objective)
            pair.append(changed.strehl(depth=50e-9)[0])
        slopes.append((pair[1] - pair[0]) / (0.6 * scale))
    expected = math.sqrt(np.array(slopes) @ found.covariance @ np.array(slopes))
    assert found.strehl(depth=50e-9)[1] == pytest.approx(expected, rel=0.1)


def test_widths_and_strehl_ratio_share_one_stack(monkeypatch):
    found = fitted(recorded(3, waves(3, 0.1))[0], OIL, **GIVEN, terms=TERMS[:2], priors={})
    count, focus = [], type(found)._focus
    monkeypatch.setattr(type(found), "_focus", lambda *given: count.append(1) or focus(*given))
    found.fwhm(depth=50e-9), found.strehl(depth=50e-9), found.fwhm(depth=50e-9)
    assert len(count) == 2  # with and without the terms


def test_a_bead_left_out_of_the_fit_tells_whether_its_answer_holds_for_others():
    given = waves(7)
    stacks = [recorded(30 + k, given, light=2e4)[0] for k in range(3)]
    found = fitted(stacks, OIL, **GIVEN, terms=TERMS, priors={})
    assert found.converged
    assert abs(found.held_out - 1.0) < 0.1
    assert f"held-out bead {found.held_out:.4g}" in found.message
    other = given + 0.15 * waves(11)
    mixed = fitted([*stacks[:2], recorded(33, other, light=2e4)[0]], OIL, **GIVEN, terms=TERMS, priors={})
    assert mixed.held_out > max(1.2, mixed.chi2)
    alone = fitted(stacks[0], OIL, **GIVEN, terms=TERMS, priors={})
    assert math.isnan(alone.held_out)
    assert "held-out" not in alone.message


def test_the_deviation_of_the_psf_elsewhere_is_what_fits_differ_by():
    given, truth = waves(8, 0.1), None
    z, off = np.array([-0.3e-6, 0.3e-6]), []
    for seed in range(2):
        images, _ = recorded(50 + seed, given)
        found = fitted(images, OIL, **GIVEN, terms=TERMS, priors={})
        sd = found.psf_errors(depth=2e-6, z=z, shape=15)
        if truth is None:
            aberrations = wavefront(given)
            pupil = OIL.pupil(depth=2e-6, z=z, wavelength=WAVE, aberrations=aberrations)
            truth = lm.psf(pupil, 15, PIXEL).values
        made = lm.psf(found.pupil(depth=2e-6, z=z), 15, PIXEL).values
        bright = truth > 0.1 * truth.max()
        off.append((made - truth)[bright] / sd[bright])
    assert sd.shape == truth.shape
    assert 0.6 < np.sqrt(np.mean(np.square(off))) < 1.5


def test_a_plane_that_moved_is_named():
    given = waves(9, 0.1)
    images, _ = recorded(70, given, size=17)
    images[3] = np.roll(recorded(70, given, size=17)[0][3], 1, axis=1)  # by a pixel
    found = fitted(images, OIL, **GIVEN, terms=TERMS, priors={})
    assert list(found.beads[0].moved) == [3]
    row, column = found.beads[0].moved[3]
    assert abs(row) < 0.3
    assert 0.5 < column < 1.2
    assert 3 in found.findings.get("moved").numbers["bead 0"]
    still = fitted(recorded(70, given, size=17)[0], OIL, **GIVEN, terms=TERMS, priors={})
    assert still.beads[0].moved == {}


def test_drift_is_estimated():
    given = waves(9, 0.1)
    rng = np.random.default_rng(0)
    light = []
    for t, z in zip(np.linspace(-1, 1, 9), Z, strict=True):
        pupil = OIL.pupil(depth=50e-9, z=z, wavelength=WAVE, aberrations=wavefront(given))
        bead = lm.methods.Bead(0.1e-6, 1e-4)
        light.append(lm.psf(pupil, 17, PIXEL, method=bead, integrate=True, center=(8 + 0.3 * t, 8 - 0.2 * t)).values)
    images = NOISE.record(1e4 * np.array(light) + 10.0, seed=rng)
    found = fitted(images, OIL, **GIVEN, terms=TERMS, priors={}, drift=True)
    assert found.converged, found.message
    for value, true, name in zip(found.beads[0].drift, (0.3, -0.2), ("drift_row", "drift_column"), strict=True):
        assert abs(value - true) < 5.0 * found.beads[0].errors[name]


def test_errors_contain_how_halves_of_the_planes_differ_where_nothing_explains_a_misfit():
    z = np.linspace(-0.9e-6, 0.9e-6, 10)
    stack, _ = recorded(1, waves(1), light=1e6, z=z)
    # A ghost that is not in the model, and whose light changes from plane to plane.
    ghost = 0.06 * np.roll(stack - 110.0, (3, 2), (1, 2)) * np.cos(np.arange(10.0))[:, None, None] ** 2
    stack = np.round(stack + ghost)
    whole, even, odd = (
        fitted(stack[part], OIL, **(GIVEN | {"z": z[part]}), terms=TERMS, priors={})
        for part in (np.s_[:], np.s_[::2], np.s_[1::2])
    )
    assert [fit.status for fit in (whole, even, odd)] == ["doubtful"] * 3
    assert 0.01 < whole.findings.get("missed_light").numbers["missed"] < 0.1
    differences = np.array([even.coefficients[term] - odd.coefficients[term] for term in TERMS])
    errors = np.array([np.hypot(even.errors[term], odd.errors[term]) for term in TERMS])
    assert 0.3 < np.sqrt(np.mean((differences / errors) ** 2)) < 1.5
    # Two halves differ by twice the error of the whole.
    assert 0.5 < np.median(errors / [2.0 * whole.errors[term] for term in TERMS]) < 2.0


def test_a_search_that_ends_at_very_strong_aberrations_is_a_misfit():
    images, _ = recorded(1, waves(1))
    start = lm.Wavefront.zernike({(3, 3): 35.0})
    found = fitted(images, OIL, **GIVEN, terms=[(3, 3)], priors={}, aberrations=start, steps=1)
    assert (found.converged, found.reliable, found.model_error) == (False, False, math.inf)
    assert found.status == "misfit"
    assert found.findings.get("model_error").numbers == {"error": math.inf}


def test_a_sloping_background_alone_is_no_bead_without_a_search():
    slope = 20.0 + 15.0 * np.linspace(-0.5, 0.5, 15)[None, :, None] * np.ones((9, 15, 15))
    found = fitted(NOISE.record(slope, seed=3), OIL, terms=TERMS, **(GIVEN | {"starts": 5}))
    assert (found.status, found.steps) == ("no_light", 0)


STACK = recorded(11, waves(11), light=2e3)[0]


@pytest.mark.parametrize(
    ("more", "told"),
    [
        ({"z": Z[:5]}, "z must have a position for each of 9 planes"),
        ({"z": Z[[1, 0, *range(2, 9)]]}, "z must increase from plane to plane"),
        ({"z": 1e6 * Z}, "z must be in metres"),
        ({"depth": 10e-9}, "depth must be the depth of a bead.s centre, at least the radius"),
        ({"terms": ["noll 4", "noll 5"]}, "equivalent to a shift of the bead"),
        ({"priors": {"immersion": math.inf, "coverslip": math.inf}}, "depend only on a combination of both"),
        ({"priors": {"NA": math.inf}, "depth": 2e-6}, "NA if all beads are deeper than a wavelength"),
        ({"stacks": lm.Counts.of(STACK, noise=NOISE)}, "noise must be omitted if stacks are Counts"),
    ],
)
def test_what_cannot_be_fitted_is_refused_with_a_sentence(more, told):
    given = {"stacks": STACK, "terms": TERMS} | GIVEN | more
    with pytest.raises((ValueError, TypeError), match=told) as caught:
        fitted(given.pop("stacks"), OIL, **given)
    assert len(str(caught.value)) < 300


def test_what_the_camera_and_the_stage_do_is_named():
    given = waves(9, 0.1)
    electrons = NOISE.electrons(recorded(9, given, light=1e5)[0])
    bent = NOISE.image(electrons - 0.1 * electrons**2 / 1e4)
    found = fitted(bent, OIL, **GIVEN, terms=TERMS, priors={})
    assert "non-linear gain" in found.findings.get("other_explanation").numbers
    moving = [
        recorded(9, given, light=3e4, z=Z[[k]], moved=(0.05 * (k - 4), 0.0), draw=k)[0][0] for k in range(len(Z))
    ]
    found = fitted(np.stack(moving), OIL, **GIVEN, terms=TERMS, priors={})
    assert (found.status, [*found.findings.get("estimated").numbers]) == (
        "converged",
        ["drift_row of bead 0", "move"],
    )
    stated = fitted(np.stack(moving), OIL, **GIVEN, terms=TERMS, priors={}, drift=True)
    assert stated.findings.get("estimated") is None
    for term, error in stated.errors.items():
        assert abs(found.coefficients[term] - stated.coefficients[term]) < 0.2 * error


def test_a_background_that_slopes_is_estimated():
    true, planes = waves(9, 0.1), np.linspace(-10.0, 10.0, 15)
    first, second = recorded(9, true, light=3e4)[0], recorded(12, true, light=2e4)[0]
    found = fitted([first + planes, second - 0.5 * planes[:, None]], OIL, **GIVEN, terms=TERMS, priors={})
    assert found.reliable, found.message
    told = found.findings.get("estimated")
    assert [*told.numbers] == ["gradient_column of bead 0", "gradient_row of bead 1", "move"]
    # The planes are added to the recorded images: estimates are those of level images.
    level = fitted([first, second], OIL, **GIVEN, terms=TERMS, priors={})
    assert level.findings.get("estimated") is None
    assert [bead.gradient for bead in level.beads] == [(0.0, 0.0)] * 2
    for term, value in level.coefficients.items():
        assert abs(found.coefficients[term] - value) < 0.7 * level.errors[term]
    for bead, other, gradient in zip(found.beads, level.beads, ((0.0, 20.0), (-10.0, 0.0)), strict=True):
        errors = bead.errors["gradient_row"], bead.errors["gradient_column"]
        assert np.all(np.abs(np.subtract(bead.gradient, gradient)) < 4.0 * np.array(errors))
        np.testing.assert_allclose(bead.background, other.background, atol=4.0 * bead.errors["background"])
        assert abs(bead.chi2 - 1.0) < 0.15
        assert np.abs(np.median(bead.images - bead.model, axis=(0, 1))).max() < 2.0


def test_a_prior_that_the_beads_contradict_is_named():
    """Though all candidates together may be as likely by chance, the few that have priors are not."""
    setup = Setup(OIL, WAVE, lm.Dipole(0.0, 0.0, wobble=1.0), PIXEL, 0.1e-6)
    joint = SimpleNamespace(priors={"sample": Prior(OIL.sample, 3e-3)}, depths=())

    def found(sigmas):
        size = np.array([sigmas * 3.2e-3])
        test = ScoreTest("sample", size, np.array([1e-3]), sigmas, 2.0)
        held = ScoreTest("NA", size, np.array([1e-3]), 4.0, 2.0)
        fit = SimpleNamespace(state=SimpleNamespace(setup=setup))
        return missing_findings(Round((joint, fit), ((held, test), None, [])), setup, joint)[0]

    assert found(3.4) == []
    (told,) = found(-3.6)
    assert (told.code, told.severity) == ("other_explanation", "doubt")
    assert re.search(r"the data favour sample = 1\.\d+ \+- 0\.001\d*, stated 1\.33 .*, against its prior$", told.text)


@pytest.mark.parametrize(("sigmas", "severity"), [(0.5, "note"), (2.0, "doubt")])
def test_an_error_of_the_images_of_the_search_is_told_by_the_estimate_that_it_moves(monkeypatch, sigmas, severity):
    """Images whose error is that of coma: the fit is off by it, and the constants are held."""
    image, _ = recorded(4, waves(4))
    given = GIVEN | {"terms": TERMS, "priors": {}}
    exact = fitted(image, OIL, **given)
    assert "model_error" not in exact.findings.codes
    step = sigmas * exact.errors[3, 1] * (np.array(TERMS) == (3, 1)).all(axis=1)

    def images(model, state, planes):
        made = (
            model.images.values(state.setup, waves_of, state.places[0], model.stacks[0])[[*planes]]
            for waves_of in (state.waves, state.waves + step)
        )
        return tuple(made)

    monkeypatch.setattr(bead_checks, "_point_images", images)
    monkeypatch.setattr(beads, "_MAX_IMAGE_ERROR", 0.0)
    finding = fitted(image, OIL, **given).findings.get("model_error")
    assert finding.severity == severity
    assert finding.numbers["moved"] == pytest.approx(sigmas, rel=0.05)
    assert "which moves noll 8 coma x by" in finding.text


def test_the_effect_that_is_most_significant_is_the_first_of_those_estimated_besides():
    places = [SimpleNamespace(gradient_row=row, gradient_column=column) for row, column in ((0.11, 0.3), (0.9, -0.2))]
    state = SimpleNamespace(waves=np.zeros(1), setup=SimpleNamespace(value=lambda _: 0.0), places=places)
    fit = SimpleNamespace(state=state, scores=SimpleNamespace(information=np.eye(5)[None] / 0.1**2))
    model = SimpleNamespace(
        names=[(3, 1)], priors={}, bead_parameters=["gradient_row", "gradient_column"],
        depths=[Prior(5e-8, 0.0)] * 2, columns=lambda bead, count: range(count + 2 * bead, count + 2 * bead + 2),
    )  # fmt: skip
    both = SimpleNamespace(fit=(model, fit), names=(bead_checks._GRADIENT,))
    (finding,) = bead_checks.estimates_of(both, both, state.setup)
    assert finding.text.startswith("estimated besides: gradient_row of bead 1 0.90 +- 0.10")
