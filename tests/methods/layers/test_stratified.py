"""The engine of microscopes: against the reference, within its bound, in every window; and where it has none."""

from __future__ import annotations

import os

import numpy as np
import pytest

import lommel as lm
from lommel.core.answers import Wanted
from lommel.methods import DebyeWolf, Stratified
from lommel.methods.layers import stratified
from lommel.optics.grid import Grid
from lommel.optics.layers.stratified import Design
from objectives import OIL

BRIEF = os.environ.get("HYPOTHESIS_PROFILE") != "thorough"
WAVE, PIXEL = 520e-9, 6.5e-6
RNG = np.random.default_rng(3)
EMITTERS = [
    "isotropic",
    "scalar",
    lm.Dipole(0.7, 0.4),
    lm.Dipole(1.2, -2.0, wobble=0.3),
    lm.Beam("x"),
    lm.Beam((1, 0.3j)),
]


def planes(n=6, depth=2e-6, span=1e-6, emitter="isotropic"):
    return OIL.pupil(depth=depth, z=np.linspace(-span, span, n), wavelength=WAVE, origin="paraxial", emitter=emitter)


def off(made, exact):
    """The largest error over the peak of each plane, as the reference has it in the same window."""
    wrong, tops = np.abs(made.values - exact.values), exact.values.max(axis=(-2, -1))
    return float((wrong.max(axis=(-2, -1)) / tops).max())


def compared(pupil, shape, tol, pixel=PIXEL, **options):
    options = {"normalize": "strehl", "dtype": np.float64} | options
    try:
        made = lm.psf(pupil, shape, pixel, tol=tol, **options)
    except lm.ToleranceError:
        with pytest.raises(lm.ToleranceError):
            lm.psf(pupil, shape, pixel, method=DebyeWolf(tol), **options)
        return None
    assert isinstance(made.method, Stratified)
    # Its own error is far below its bound: of rounding alone.
    try:
        exact = lm.psf(pupil, shape, pixel, method=DebyeWolf(tol), **options)
    except lm.ToleranceError:
        exact = lm.psf(pupil, shape, pixel, method=DebyeWolf(10.0 * tol), **options)
    assert made.error_bound <= tol
    assert off(made, exact) <= made.error_bound
    return made


def asked_of_the_engine(pupil, grid, tol):
    """Whether the engine itself answers."""
    return stratified.differentiated(pupil, grid, (), tol, Wanted()) is not None


@pytest.mark.parametrize("tol", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("emitter", EMITTERS, ids=str)
@pytest.mark.parametrize("shape", [(16, 21), 49])
def test_centred_samples_are_within_the_bound(emitter, tol, shape):
    pupil = planes(5, emitter=emitter)
    made = compared(pupil, shape, tol, integrate=False)
    assert asked_of_the_engine(pupil, made.grid, tol)


def test_wide_windows_take_few_radii_and_stay_within_the_bound():
    pupil = planes(3, span=3e-6)
    made = compared(pupil, 161, 1e-7, integrate=False)
    assert asked_of_the_engine(pupil, made.grid, 1e-7)


@pytest.mark.parametrize("integrate", [False, True])
@pytest.mark.parametrize("tol", [1e-4, 1e-8])
@pytest.mark.parametrize("center", [None, (7.3, 5.9), (-4.0, 20.5)])
def test_pixels_average_and_axes_are_anywhere(integrate, tol, center):
    pupil = planes(4)
    made = compared(pupil, (13, 17), tol, integrate=integrate, center=center)
    # Far from the axis roundings of long polynomials are more than those of the profile, which then serves.
    assert asked_of_the_engine(pupil, made.grid, tol) or (center == (-4.0, 20.5) and integrate and tol == 1e-8)


@pytest.mark.parametrize("tol", [1e-4, 1e-6, 1e-8])
@pytest.mark.parametrize("emitter", EMITTERS[2:], ids=str)
def test_dipoles_and_beams_lie_anywhere(emitter, tol):
    pupil = planes(3, emitter=emitter)
    for center in ((6.3, 4.9), (2.0, 13.5)):
        made = compared(pupil, (12, 15), tol, integrate=False, center=center)
        # Distances magnify roundings of what is odd in v; at last the reference answers.
        assert asked_of_the_engine(pupil, made.grid, tol) or (tol == 1e-8 and isinstance(emitter, lm.Dipole))
    compared(pupil, 8, tol, integrate=True, center=(3.6, 4.1))


@pytest.mark.parametrize("emitter", ["isotropic", lm.Dipole(0.9, 0.3)], ids=str)
@pytest.mark.parametrize("integrate", [False, True])
def test_each_emitter_has_an_axis_of_its_own(integrate, emitter):
    n = 5
    pupil, rows, columns = planes(n, emitter=emitter), RNG.uniform(3, 6, n), RNG.uniform(2, 6, n)
    made = lm.psf(pupil, 9, PIXEL, tol=1e-8, integrate=integrate, center=(rows, columns))
    for k in range(n):
        alone = lm.psf(pupil[k], 9, PIXEL, method=DebyeWolf(1e-10), integrate=integrate, center=(rows[k], columns[k]))
        assert np.abs(made.values[k] - alone.values).max() <= (made.error_bound + 1e-10) * alone.values.max()
    assert made.error_bound <= 1e-8


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("normalize", ["energy", "emitted", "strehl", "peak"])
def test_scales_are_those_of_every_method(normalize, dtype):
    pupil = OIL.pupil(depth=[0.0, 2e-7, 3e-6], z=0.0, wavelength=WAVE)
    for integrate in (False, True):
        made, exact = (
            lm.psf(pupil, 11, PIXEL, method=way, integrate=integrate, normalize=normalize, dtype=dtype)
            for way in (Stratified(1e-6), DebyeWolf(1e-6))
        )
        assert off(made, exact) <= made.error_bound + exact.error_bound
        assert made.scale == pytest.approx(exact.scale, rel=1e-5)
        assert made.error_bound <= 1e-6


def test_values_go_where_they_are_wanted():
    pupil, out = planes(4), np.empty((4, 9, 9), np.float32)
    made = lm.Plan(9, PIXEL)(pupil, out=out)
    assert made.values is out
    assert np.array_equal(out, lm.psf(pupil, 9, PIXEL, dtype=np.float32).values)
    assert out.min() >= 0.0


def test_a_dark_window_far_from_the_axis_is_off_by_little_of_its_peak():
    compared(planes(2, span=0.3e-6), 5, 1e-5, center=(30.0, 2.0))


@pytest.mark.parametrize("depth", [0.0, 40e-6])
def test_supercritical_light_and_deep_emitters(depth):
    tirf = lm.Objective(
        NA=1.49,
        magnification=100,
        immersion=1.518,
        working_distance=0.12e-3,
        coverslip=lm.Layer(1.52, 17e-5),
        sample=1.33,
    )
    pupil = tirf.pupil(depth=depth, z=[-0.5e-6, 0.4e-6], wavelength=670e-9)
    compared(pupil, 33, 1e-9, 1e-5, integrate=False)


def test_where_rounding_is_too_much_the_reference_answers(monkeypatch):
    pupil = planes(2)
    monkeypatch.setattr(stratified, "layered_images", lambda *_, **__: None)
    assert not asked_of_the_engine(pupil, Grid(9, PIXEL), 1e-6)
    monkeypatch.setattr(stratified, "_refine", lambda *_: None)
    alone = lm.psf(pupil, 9, PIXEL, method="stratified", integrate=False, dtype=np.float64).values
    assert np.array_equal(
        alone, lm.psf(pupil, 9, PIXEL, method="debye-wolf", integrate=False, dtype=np.float64).values
    )


def test_bounds_that_stay_above_the_tolerance_are_no_answer():
    assert not asked_of_the_engine(planes(2), Grid(9, PIXEL), 1e-17)
    with pytest.raises(lm.ToleranceError):
        Stratified(1e-12)._samples(planes(2), Grid(9, PIXEL), 1e-17, Wanted())


@pytest.mark.parametrize("emitter", ["isotropic", "scalar"])
def test_profiles_are_those_of_the_reference(emitter):
    pupil, v = planes(3, emitter=emitter), np.linspace(0.0, 37.0, 23)
    made, exact = Stratified(1e-8).profile(pupil, v), DebyeWolf(1e-11).profile(pupil, v)
    wrong = np.abs(made.values - exact.values).max(axis=1) / exact.peak
    assert (wrong <= made.error + exact.error).all()
    assert made.error.max() <= 1e-8
    assert Stratified().profile(pupil, np.zeros(0)).values.shape == (3, 0)


def test_angles_are_found_for_all_planes():
    depth, z = RNG.uniform(0.0, 80e-6, 30), RNG.uniform(-1e-6, 1e-6, 30)
    pupil = OIL.pupil(depth=depth, z=z, wavelength=WAVE, origin="paraxial")
    layers, _, depths, foci, *_ = stratified._angles_key(pupil, 20.0, 1e-6)
    at, focus = stratified._corners(layers, depths, foci)
    share = (depth - at[0]) / (at[2] - at[0])
    low, high = ((1.0 - share) * focus[k] + share * focus[2 + k] for k in (0, 1))
    assert np.all((low <= pupil.focus) & (pupil.focus <= high))
    assert np.ptp(foci) <= 3e-6


def test_profiles_far_from_the_peak_are_exact_to_what_is_there():
    made = Stratified(1e-6).profile(planes(2, span=1e-7), np.linspace(50.0, 60.0, 5))
    assert made.peak.max() < 1e-3
    assert made.error.max() <= 1e-6


def test_threads_do_not_change_values():
    pupil = planes(60)
    one, two = (lm.psf(pupil, 33, PIXEL, threads=k).values for k in (1, 2))
    assert np.array_equal(one, two)


def random_system(rng):
    n_i = rng.choice([1.0, 1.333, 1.406, 1.518])
    NA = rng.uniform(0.1, 0.97 * n_i)
    sample = rng.uniform(1.0, 1.52)
    glass, design = (lm.Layer(1.5255, 170e-6 + rng.uniform(-20e-6, 20e-6)) for _ in range(2))
    objective = lm.Objective(
        NA=NA,
        magnification=60,
        immersion=n_i,
        working_distance=0.4e-3,
        coverslip=glass,
        design=Design(n_i, design),
        sample=sample,
    )
    depth = rng.choice([0.0, 1e-7, 2e-6, 20e-6, 80e-6]) * rng.uniform(0.5, 1.0)
    z = rng.uniform(-1, 1, 3) * rng.choice([1e-6, 5e-6, 15e-6])
    emitter = rng.choice(len(EMITTERS))
    return objective.pupil(
        depth=depth, z=z, wavelength=rng.uniform(400e-9, 700e-9), origin="paraxial", emitter=EMITTERS[emitter]
    )


@pytest.mark.parametrize("seed", range(12 if BRIEF else 1000))
def test_random_systems_are_within_the_bound(seed):
    rng = np.random.default_rng(seed)
    pupil, tol = random_system(rng), 10.0 ** -rng.integers(3, 11)
    pixel = rng.choice([2e-6, 6.5e-6])
    if rng.random() < 0.5 or not pupil.radial:
        compared(pupil, int(rng.integers(1, 40)), tol, pixel, integrate=False)
    else:
        compared(pupil, int(rng.integers(3, 14)), tol, pixel, center=tuple(rng.uniform(0, 8, 2)))
