"""Measured wavefronts on top of a microscope's light: against plain sums of plane waves over the pupil."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel import _core
from lommel.methods.layers.debye_rings import DebyeRings
from lommel.optics.layers import debye, projection
from objectives import EMITTERS, FIVE, OIL
from objectives import WATER_40X as WATER
from plane_waves import PIXEL, intensity, worst

WAVE = 520e-9


def rings(*of, **options):
    """Return a PSF by circles, also where chords are the default."""
    return lm.psf(*of, method=DebyeRings(), **options)


@pytest.mark.parametrize("emitter", EMITTERS, ids=repr)
def test_the_light_is_the_sum_of_its_plane_waves(emitter):
    given = {"depth": [0.05e-6, 0.3e-6], "z": [-0.3e-6, 0.2e-6], "emitter": emitter}
    pupil = OIL.pupil(**given, wavelength=WAVE, aberrations=FIVE)
    made = lm.psf(pupil, 7, PIXEL, method=DebyeRings(1e-9), integrate=False)
    assert worst(OIL, pupil, made, 7) <= 2e-9
    assert made.error_bound <= 1e-9


@pytest.mark.parametrize("seed", range(12))
def test_no_error_is_above_its_bound_nor_that_above_the_tolerance(seed):
    rng = np.random.default_rng(seed)
    terms = {(n, m): 0.3 * rng.normal() for n in range(1, 8) for m in range(-n, n + 1, 2) if rng.random() < 0.3}
    objective = (OIL, WATER)[seed % 2]
    emitter = rng.choice(np.array(EMITTERS, dtype=object))
    tol = 10.0 ** rng.uniform(-10, -3)
    given = {"depth": 10.0 ** rng.uniform(-8, -5), "z": rng.uniform(-1e-6, 1e-6, 2), "emitter": emitter}
    pupil = objective.pupil(**given, wavelength=WAVE, aberrations=lm.Wavefront.zernike(terms))
    center = tuple(rng.uniform(-1.0, 5.0, 2))
    made = rings(pupil, 5, PIXEL, tol=tol, center=center, integrate=False, dtype=np.float64)
    assert worst(objective, pupil, made, 5, center) <= made.error_bound + 1e-11
    assert made.error_bound <= tol


@pytest.mark.parametrize("level", ["portable", "avx2", "avx512"])
@pytest.mark.parametrize("tol", [1e-6, 1e-9])
def test_wide_windows_are_within_the_bound_whatever_the_instructions(level, tol):
    z = np.linspace(-2e-6, 2e-6, 11)
    pupil = OIL.pupil(depth=2e-6, z=z, wavelength=WAVE, aberrations=FIVE)
    _core.limit_instructions(level)
    try:
        made = rings(pupil, (81, 97), PIXEL, tol=tol, integrate=False, threads=2)
    finally:
        _core.limit_instructions("avx512")
    assert made.error_bound <= tol
    rng = np.random.default_rng(5)
    y, x = np.append([40, 39, 0, 80], rng.integers(0, 81, 12)), np.append([48, 48, 96, 0], rng.integers(0, 97, 12))
    for k in (0, 4, 10):
        exact = intensity(OIL, pupil[k], PIXEL * (x - 48.0), PIXEL * (y - 40.0), 140, 420)[0] / pupil[k].power
        found = made.values[k][y, x] / np.asarray(made.scale).ravel()[k % np.asarray(made.scale).size]
        assert np.abs(found - exact).max() <= made.error_bound * made.values[k].max() * 1.01 + 1e-13


def test_a_stack_of_wavefronts_is_each_of_them():
    wave = lm.Wavefront.zernike({(2, 2): [0.2, -0.4], (3, 1): 0.3, (1, 1): [0.5, 0.0]})
    pupil = OIL.pupil(depth=1e-6, z=[[0.0], [0.2e-6]], wavelength=WAVE, aberrations=wave)
    assert pupil.shape == (2, 2)
    made = rings(pupil, 7, PIXEL, tol=1e-9, integrate=False)
    for k in np.ndindex(2, 2):
        alone = rings(pupil[k], 7, PIXEL, tol=1e-9, integrate=False)
        assert alone.values == pytest.approx(made.values[k], abs=2e-9 * alone.values.max())
    flat = pupil.broadcast((3, 2, 2))[0]
    assert flat == pupil
    assert type(pupil).from_dict(pupil.to_dict()) == pupil
    assert "Wavefront" in repr(pupil)


def test_each_plane_is_over_the_light_of_its_own_depth():
    pupil = OIL.pupil(depth=[0.0, 1e-6], wavelength=WAVE, aberrations=FIVE)
    assert pupil.collected[0] > 1.1 * pupil.collected[1]
    made = rings(pupil, 5, PIXEL, integrate=False, normalize="emitted")
    for k in range(2):
        alone = rings(pupil[k], 5, PIXEL, integrate=False, normalize="emitted")
        assert made.values[k] == pytest.approx(alone.values, abs=3e-6 * float(alone.values.max()))


def test_values_over_their_peak_are_the_same_ones():
    pupil = OIL.pupil(depth=0.0, z=[-2e-7, 1e-7], wavelength=WAVE, aberrations=FIVE)
    made = rings(pupil, 9, PIXEL, integrate=False, normalize="peak")
    plain = rings(pupil, 9, PIXEL, integrate=False, tol=1e-9)
    assert made.values.max(axis=(1, 2)) == pytest.approx(np.ones(2), abs=2e-7)
    expected = plain.values / plain.values.max(axis=(1, 2), keepdims=True)
    assert made.values == pytest.approx(expected, abs=made.error_bound + 1e-8)
    assert made.error_bound <= 1e-6


@pytest.mark.parametrize("integrate", [True, False])
def test_each_plane_may_have_its_own_axis(integrate):
    pupil = OIL.pupil(depth=0.0, z=[[-2e-7], [1e-7]], wavelength=WAVE, aberrations=FIVE)
    rows, columns = np.array([2.0, 2.5, 1.0]), np.array([1.5, 2.0, 2.25])
    asked = {"integrate": integrate, "tol": 1e-7, "dtype": np.float64}
    made = rings(pupil, 5, PIXEL, center=(rows, columns), **asked)
    assert made.values.shape == (2, 3, 5, 5)
    for k in np.ndindex(2, 3):
        alone = rings(pupil[k[0], 0], 5, PIXEL, center=(rows[k[1]], columns[k[1]]), **asked)
        assert made.values[k] == pytest.approx(alone.values, abs=3e-7 * alone.values.max())


def test_tilt_moves_the_image_and_a_turn_turns_it():
    given = {"depth": 1e-6, "z": 0.2e-6, "wavelength": WAVE}
    plain = OIL.pupil(**given)
    step = np.pi * PIXEL / plain.scale
    moved = OIL.pupil(**given, aberrations=lm.Wavefront(nonradial={(1, 1): 2.0 * step, (1, -1): -step}))
    still = lm.psf(plain, 13, PIXEL, tol=1e-9, integrate=False).values
    made = rings(moved, 13, PIXEL, tol=1e-9, integrate=False).values
    assert made[:-1, 2:] == pytest.approx(still[1:, :-2], abs=2e-9 * still.max())
    coma = lm.Wavefront.zernike({(3, 1): 0.5})
    one, other = (OIL.pupil(**given, aberrations=wave) for wave in (coma, coma.rotated(np.pi / 2)))
    one, other = (rings(pupil, 13, PIXEL, tol=1e-9, integrate=False).values for pupil in (one, other))
    assert other == pytest.approx(np.rot90(one, -1), abs=2e-9 * one.max())


def test_in_one_medium_with_a_small_aperture_it_is_the_scalar_lens():
    air = lm.Objective(NA=0.05, magnification=10, immersion=1.0, working_distance=5e-3, coverslip=None, sample=1.0)
    pupil = air.pupil(depth=0.0, z=0.0, wavelength=WAVE, aberrations=FIVE, origin="coverslip", emitter="scalar")
    lens = lm.Pupil(FIVE, wavelength=WAVE, f_number=pupil.f_number)
    for integrate in (True, False):
        here, there = (lm.psf(one, 21, 20e-6, integrate=integrate, tol=1e-8) for one in (pupil, lens))
        assert here.values == pytest.approx(there.values, abs=5e-8 * there.values.max())


@pytest.mark.parametrize(
    "terms", [{(8, 0): 0.4}, {(2, 2): 0.3, (2, -2): -0.4, (3, 1): 0.5, (5, -3): 0.3, (8, 0): 0.4, (12, 6): 0.2}]
)
def test_the_growth_of_the_wavefront_is_above_every_sample(terms):
    wave = lm.Wavefront.zernike(terms)
    terms = tuple(wave.amplitudes().items())
    theta = np.linspace(0.0, 2.0 * np.pi, 201)[:, None]
    for piece in debye.pieces(OIL.pupil(depth=0.0, wavelength=WAVE).layers, debye.Model()):
        bound = projection.growth(piece, terms)
        discs = piece.covered().x
        for row, turn in ((3, 0.3), (12, -1.0), (20, 2.0), (20, 5.0)):
            x = discs.centre[row] + 0.999 * discs.radius[row] * np.exp(1j * turn)
            rho = np.sqrt(piece.square(x)) / piece.layers.NA
            phase = np.zeros((201, rho.size), complex)
            for (n, m), c in wave.edge_terms().items():
                powers = {
                    (2, 2): rho**2,
                    (2, -2): rho**2,
                    (3, 1): 3 * rho**3 - 2 * rho,
                    (5, -3): 5 * rho**5 - 4 * rho**3,
                    (12, 6): 220 * rho**12 - 495 * rho**10 + 360 * rho**8 - 84 * rho**6,
                    (8, 0): 70 * rho**8 - 140 * rho**6 + 90 * rho**4 - 20 * rho**2 + 1,
                }
                if np.any(c):
                    phase += c * powers[n, m] * (np.cos(m * theta) if m >= 0 else np.sin(-m * theta))
            largest = -phase.imag.min(axis=0)
            assert (largest <= bound[row] + 1e-9).all()
        assert np.all(projection.growth(piece, ()) == 0.0)


def test_in_other_light_the_path_stays_and_colours_add_up():
    pupil = OIL.pupil(depth=0.0, z=[0.0, 3e-7], wavelength=WAVE, aberrations=FIVE)
    assert pupil.in_light(2 * WAVE).aberrations == 0.5 * FIVE
    white = lm.psf(
        pupil, 7, PIXEL, method=lm.methods.Polychromatic((500e-9, 540e-9), (0.5, 0.5), tol=1e-8), dtype=np.float64
    )
    parts = [lm.psf(pupil.in_light(w), 7, PIXEL, tol=1e-9) for w in (500e-9, 540e-9)]
    total = sum(0.5 * part.values for part in parts)
    assert white.values == pytest.approx(total, abs=1e-7 * total.max())
