"""Derivatives of dipoles, beams and measured wavefronts: as differences of the references, within their bounds."""

from __future__ import annotations

import os

import numpy as np
import pytest

import lommel as lm
from lommel.methods import DebyeRings, DebyeWolf, Stratified
from lommel.optics.layers import debye
from objectives import oil

BRIEF = os.environ.get("HYPOTHESIS_PROFILE") != "thorough"
WAVE, PIXEL, SIDE = 520e-9, 6.5e-6, 7
OIL = oil(films=[lm.Layer(2.0, 40e-9)])
DEPTH, Z, CENTER = np.array([0.1e-6, 1e-6]), np.array([0.4e-6, 2e-6]), (3.3, 2.6)
STEPS = {
    "z": (lambda h: {"dz": h}, 4e-9),
    "depth": (lambda h: {"dd": h}, 4e-9),
    "row": (lambda h: {"at": (CENTER[0] + h, CENTER[1])}, 4e-2),
    "column": (lambda h: {"at": (CENTER[0], CENTER[1] + h)}, 4e-2),
}


def difference(at, h):
    return (45.0 * (at(h) - at(-h)) - 9.0 * (at(2.0 * h) - at(-2.0 * h)) + at(3.0 * h) - at(-3.0 * h)) / (60.0 * h)


def images(light, dz=0.0, dd=0.0, at=CENTER, of=OIL, **options):
    planes = of.pupil(depth=DEPTH + dd, z=Z + dz, wavelength=WAVE, origin="coverslip", **light)
    return lm.psf(planes, SIDE, PIXEL, center=at, dtype=np.float64, **options)


def compared(light, names, tol, slack, way=None, **options):
    """Derivatives are as differences of finer values say."""
    made = images(light, tol=tol, derivatives=names, **options)
    top = made.values.max(axis=(1, 2))
    assert made.error_bound <= tol
    for name in names:
        change, h = STEPS[name]
        expected = difference(lambda t, change=change: images(light, method=way, **change(t), **options).values, h)
        size = float((np.abs(expected).max(axis=(1, 2)) / top).max())
        off = float((np.abs(made.derivatives[name] - expected).max(axis=(1, 2)) / top).max())
        assert off <= made.derivative_bounds[name] + slack * size, name
        assert off <= 1e-6 * size, name
        assert 1e-3 * tol * size <= made.derivative_bounds[name] <= 1e3 * tol * size, name


@pytest.mark.parametrize(
    ("emitter", "normalize", "integrate"),
    [
        (lm.Dipole(0.7, 0.4), "energy", False),
        (lm.Dipole(0.7, 0.4), "energy", True),
        (lm.Dipole(1.3, -2.0, wobble=0.2), "emitted", False),
        (lm.Beam((1, 0.3j)), "strehl", True),
    ],
    ids=str,
)
def test_light_that_depends_on_the_azimuth_has_all_derivatives(emitter, normalize, integrate):
    names = tuple(STEPS) if normalize == "energy" else ("depth",)
    way = Stratified(1e-7) if integrate else DebyeWolf(1e-10)
    compared({"emitter": emitter}, names, 1e-6, 1e-7, way, normalize=normalize, integrate=integrate)


MEASURED = lm.Wavefront.zernike({5: 0.08, 7: 0.05, 11: -0.04}, order="noll", unit="waves")
EACH = lm.Wavefront.zernike({2: np.array([0.1, -0.1]), 6: np.array([0.1, 0.2])}, order="noll", unit="waves")


@pytest.mark.parametrize("integrate", [False, True])
@pytest.mark.parametrize(
    "light",
    [
        {"aberrations": MEASURED},
        {"aberrations": EACH},
        {"aberrations": MEASURED, "emitter": lm.Dipole(0.7, 0.4)},
        {"aberrations": MEASURED, "emitter": lm.Beam("radial")},
    ],
    ids=str,
)
def test_measured_wavefronts_have_derivatives_by_stage_depth_and_axis(light, integrate):
    names = ("z", "depth", "row", "column") if light.get("emitter") is None else ("z", "depth")
    compared(light, names, 1e-6, 1e-7, DebyeRings(1e-7), integrate=integrate)


@pytest.mark.parametrize("integrate", [False, True])
def test_what_the_terms_leave_out_is_in_bounds(integrate):
    vague, sharp = (
        images(
            {"aberrations": lm.Wavefront.trusted(MEASURED.terms, MEASURED.edge, error)},
            tol=1e-2,
            derivatives=("z", "row"),
            integrate=integrate,
        )
        for error in (1e-4, 0.0)
    )
    for name, most in (("z", 1e3), ("row", 5e-3)):
        assert vague.derivative_bounds[name] >= sharp.derivative_bounds[name] + most


def test_each_plane_has_its_own_axis():
    light = {"emitter": lm.Dipole(0.7, 0.4)}
    for more in ({}, {"aberrations": MEASURED}):
        rows, columns = np.array([3.1, 2.4]), np.array([2.8, 3.6])
        both = images(light | more, at=(rows, columns), tol=1e-5, derivatives=("z",))
        for k in range(2):
            one = images(light | more, at=(rows[k], columns[k]), tol=1e-6, derivatives=("z",))
            off = np.abs(both.derivatives["z"][k] - one.derivatives["z"][k]).max() / one.values[k].max()
            assert off <= both.derivative_bounds["z"] + one.derivative_bounds["z"]


def test_no_derivative_is_more_than_its_size_says():
    # What filters err by relies on it.
    for light in ({"emitter": lm.Dipole(0.7, 0.4)}, {"aberrations": MEASURED}):
        planes = OIL.pupil(depth=DEPTH, z=Z, wavelength=WAVE, origin="coverslip", **light)
        found = debye.steepest(planes.layers, planes.light.model)
        made = images(light, tol=1e-4, derivatives=("z", "depth"), normalize="strehl", integrate=False)
        assert np.abs(made.derivatives["z"]).max() <= 2.0 * found[1]
        k = 2.0 * np.pi / WAVE
        # From the middle of the range of n cos, to either end.
        assert found[1] == pytest.approx(k * 0.5 * (1.518 - np.sqrt(1.518**2 - 1.4**2)), rel=1e-2)
        assert found[0] == pytest.approx(k * np.hypot(0.5 * 1.33, np.sqrt(1.4**2 - 1.33**2)), rel=1e-2)


@pytest.mark.parametrize("seed", range(3 if BRIEF else 100))
def test_random_light_is_within_its_bounds(seed):
    rng = np.random.default_rng(seed)
    emitter = [lm.Dipole(*rng.uniform(0, 3, 2), wobble=rng.uniform()), lm.Beam((1, rng.uniform() * 1j)), "isotropic"]
    terms = {int(k): rng.normal(0, 0.06) for k in rng.choice(np.arange(4, 16), 3, replace=False)}
    light = {"emitter": emitter[seed % 3]}
    if seed % 3 == 2 or rng.random() < 0.3:
        light["aberrations"] = lm.Wavefront.zernike(terms, order="noll", unit="waves")
    n_i = rng.choice([1.333, 1.518])
    of = lm.Objective(
        NA=rng.uniform(0.4, 0.95 * n_i),
        magnification=60,
        immersion=n_i,
        working_distance=0.3e-3,
        coverslip=lm.Layer(1.5255, 170e-6),
        sample=rng.uniform(1.3, 1.45),
    )
    tol, integrate = 10.0 ** -rng.integers(4, 7), bool(rng.integers(2))
    way = DebyeRings(1e-7) if "aberrations" in light else Stratified(1e-7)
    compared(light, tuple(STEPS), tol, 1e-7, way, of=of, integrate=integrate)
