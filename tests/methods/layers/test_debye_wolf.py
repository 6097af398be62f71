"""Stacks of a microscope: against direct sums over dipoles, and what methods say of pupils they do not take."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.methods import DebyeWolf, Polychromatic, Stratified
from lommel.optics.layers import debye
from objectives import OIL

WAVE, PIXEL = 520e-9, 6.5e-6
METHODS = [DebyeWolf(1e-9), Stratified(1e-9)]


def fields(pupil, side):
    """K0, K1, K2 at the pixels of a window, and their azimuth."""
    y, x = np.mgrid[-(side // 2) : side - side // 2, -(side // 2) : side - side // 2] * PIXEL
    v = pupil.v(np.hypot(y, x).ravel())
    planes = pupil.depth.ravel(), pupil.focus.ravel()
    model = debye.Model()
    found = debye.fields(debye.rule(pupil.layers, model, *planes, float(v.max()), 1e-13), model, *planes, v)
    return [part.reshape(-1, side, side) for part in found], np.arctan2(y, x)


def of_dipole(p, K, phi):
    """The light of a dipole on the camera, by its field."""
    (K0, K1, K2), (px, py, pz) = K, p
    Ex = px * (K0 + K2 * np.cos(2 * phi)) + py * K2 * np.sin(2 * phi) - 2j * pz * K1 * np.cos(phi)
    Ey = px * K2 * np.sin(2 * phi) + py * (K0 - K2 * np.cos(2 * phi)) - 2j * pz * K1 * np.sin(phi)
    return np.abs(Ex) ** 2 + np.abs(Ey) ** 2


@pytest.mark.parametrize("method", METHODS, ids=["reference", "engine"])
@pytest.mark.parametrize("angles", [(0.0, 0.0), (0.7, 0.4), (1.3, -2.0)])
def test_a_dipole_shines_as_its_field_does(method, angles):
    pupil = OIL.pupil(depth=1e-6, z=[-0.3e-6, 0.2e-6], wavelength=WAVE, emitter=lm.Dipole(*angles))
    made = lm.psf(pupil, 17, PIXEL, method=method, integrate=False, normalize="strehl")
    polar, azimuth = angles
    p = np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)
    found = of_dipole(p, *fields(pupil, 17))
    expected = 1.5 * found / pupil.power[:, None, None]
    assert np.abs(made.values - expected).max() <= made.error_bound * expected.max()
    assert made.error_bound <= 1e-9


@pytest.mark.parametrize("jones", ["x", "y", (1.0, 1.0j), (0.3, 0.8 - 0.2j)])
def test_polarised_light_is_focused_as_its_field_is(jones):
    pupil = OIL.pupil(depth=1e-6, z=0.2e-6, wavelength=WAVE, emitter=lm.Beam(jones))
    made = lm.psf(pupil, 17, PIXEL, method=Stratified(1e-9), integrate=False, normalize="strehl")
    a, b = {"x": (1, 0), "y": (0, 1)}.get(jones, jones)
    (K0, K1, K2), phi = fields(pupil, 17)
    Ex = a * (K0 + K2 * np.cos(2 * phi)) + b * K2 * np.sin(2 * phi)
    Ey = a * K2 * np.sin(2 * phi) + b * (K0 - K2 * np.cos(2 * phi))
    Ez = -2j * K1 * (a * np.cos(phi) + b * np.sin(phi))
    light = np.abs(Ex) ** 2 + np.abs(Ey) ** 2 + np.abs(Ez) ** 2
    expected = (light / (abs(a) ** 2 + abs(b) ** 2) / pupil.power[:, None, None])[0]
    assert np.abs(made.values - expected).max() <= made.error_bound * expected.max()


def test_the_mean_of_three_dipoles_is_an_emitter_that_turns_freely():
    given = {"depth": 1e-6, "z": 0.2e-6, "wavelength": WAVE}
    dipoles = [lm.Dipole(np.pi / 2, 0.0), lm.Dipole(np.pi / 2, np.pi / 2), lm.Dipole(0.0, 0.0)]
    total = np.zeros((9, 9))
    for dipole in dipoles:
        pupil = OIL.pupil(**given, emitter=dipole)
        total += lm.psf(pupil, 9, PIXEL, tol=1e-9, integrate=False, normalize="strehl").values * pupil.power / 3.0
    free = OIL.pupil(**given)
    made = lm.psf(free, 9, PIXEL, tol=1e-9, integrate=False, normalize="strehl").values * free.power
    assert made == pytest.approx(total, abs=1e-8)
    half = OIL.pupil(**given, emitter=lm.Dipole(0.4, 0.1, wobble=1.0))
    assert half.radial
    assert lm.psf(half, 9, PIXEL, tol=1e-9).values == pytest.approx(lm.psf(free, 9, PIXEL, tol=1e-9).values)


@pytest.mark.parametrize("emitter", ["isotropic", "scalar", lm.Beam("x"), lm.Dipole(0.8, 0.2)])
def test_a_wide_window_has_nearly_all_light_and_averages_sum_as_samples_do(emitter):
    objective = lm.Objective(
        NA=0.6, magnification=40, immersion=1.0, working_distance=1e-3, coverslip=None, sample=1.0
    )
    pupil = objective.pupil(depth=0.0, z=[0.0, 2e-6], wavelength=WAVE, emitter=emitter)
    averaged, sampled = (lm.psf(pupil, 151, 6.5e-6, integrate=which) for which in (True, False))
    assert averaged.values.sum(axis=(1, 2)) == pytest.approx(sampled.values.sum(axis=(1, 2)), abs=2e-3)
    assert np.all(averaged.values.sum(axis=(1, 2)) > 0.95)
    assert np.all(averaged.values.sum(axis=(1, 2)) < 1.0)


def test_emitted_light_is_what_is_collected_over_that_of_an_emitter_far_away():
    tirf = lm.Objective(
        NA=1.49,
        magnification=100,
        immersion=1.518,
        working_distance=0.12e-3,
        coverslip=lm.Layer(1.518, 17e-5),
        sample=1.33,
    )
    pupil = tirf.pupil(depth=[0.0, 5e-7], wavelength=670e-9, origin="coverslip")
    energy, emitted = (lm.psf(pupil, 9, 1e-5, normalize=how) for how in ("energy", "emitted"))
    ratio = emitted.values / energy.values
    collected = tirf.collected([0.0, 5e-7], wavelength=670e-9)
    assert ratio == pytest.approx(np.broadcast_to(collected[:, None, None], ratio.shape), rel=1e-5)


def test_origins_differ_by_where_the_focus_is():
    focus = OIL.focus(2e-6, wavelength=WAVE)
    for origin, start in (("coverslip", 0.0), ("paraxial", focus.paraxial), ("brightest", focus.brightest)):
        pupil = OIL.pupil(depth=2e-6, z=[0.0, 1e-7], wavelength=WAVE, origin=origin)
        assert pupil.focus == pytest.approx(start + np.array([0.0, 1e-7]), abs=1e-15)
        assert pupil.z == pytest.approx([0.0, 1e-7])


def test_a_stack_is_cut_and_broadcast_and_comes_back_from_plain_types():
    pupil = OIL.pupil(depth=[[0.0], [1e-6]], z=[0.0, 1e-7, 2e-7], wavelength=WAVE, emitter=lm.Beam((1.0, 1.0j)))
    assert pupil.shape == (2, 3)
    assert pupil[1, 2].depth == 1e-6
    assert pupil[0, 0].broadcast((2,)).shape == (2,)
    assert type(pupil).from_dict(pupil.to_dict()) == pupil
    assert pupil != pupil[0]
    with pytest.raises(TypeError):
        hash(pupil)


def test_colours_add_up():
    pupil = OIL.pupil(depth=0.0, z=[0.0, 3e-7], wavelength=WAVE)
    waves, weights = (500e-9, 540e-9), (0.25, 0.75)
    white = lm.psf(pupil, 9, PIXEL, method=Polychromatic(waves, weights, tol=1e-8), dtype=np.float64)
    parts = [lm.psf(pupil.in_light(w), 9, PIXEL, tol=1e-9) for w in waves]
    total = sum(share * part.values for share, part in zip(weights, parts, strict=True))
    assert white.values == pytest.approx(total, abs=1e-7 * total.max())


def test_what_is_dark_on_the_axis_is_known_there_too():
    dark = OIL.pupil(depth=0.0, wavelength=WAVE, emitter=lm.Beam("azimuthal"))
    made = DebyeWolf(1e-6).profile(dark, np.zeros(1))
    assert made.values == pytest.approx(0.0, abs=1e-6)
    assert made.error <= 1e-6
