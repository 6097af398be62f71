"""Derivatives of microscopes' stacks: sums of their own, differences, and what is refused."""

from __future__ import annotations

import os

import numpy as np
import pytest

import lommel as lm
from lommel.methods import ChordalDebye, DebyeRings
from lommel.methods.layers import slopes, stratified
from lommel.optics.grid import Grid
from lommel.optics.layers import debye
from lommel.optics.layers.stratified import Design
from objectives import OIL

WAVE, PIXEL = 520e-9, 6.5e-6
Z, DEPTH, CENTER = np.array([1.0, 1.2, 3.0]) * 1e-6, np.array([0.05, 0.3, 2.0]) * 1e-6, (4.2, 3.7)


def pupil(dz=0.0, dd=0.0, emitter="isotropic"):
    return OIL.pupil(depth=DEPTH + dd, z=Z + dz, wavelength=WAVE, origin="coverslip", emitter=emitter)


def difference(at, h):
    return (45.0 * (at(h) - at(-h)) - 9.0 * (at(2.0 * h) - at(-2.0 * h)) + at(3.0 * h) - at(-3.0 * h)) / (60.0 * h)


def samples(name, of):
    """I of samples around CENTER and its derivative, over the power of each plane, by scipy's Bessel functions."""
    y, x = np.mgrid[0:9, 0:9]
    v = of.pupil_step * np.hypot(y - CENTER[0], x - CENTER[1]).ravel()
    p, model = of.pupil, of.pupil.light.model
    rule = debye.rule(p.layers, model, p.depth, p.focus, float(v.max()), 1e-13)
    turned = rule._replace(parts=tuple(part * 1j * rule.rates[{"depth": 1, "z": 2}[name]] for part in rule.parts))
    F, G = (debye.fields(each, model, p.depth, p.focus, v) for each in (rule, turned))
    shares = p.light.shares
    value = sum(share * np.abs(f) ** 2 for share, f in zip(shares, F, strict=True))
    slope = sum(2.0 * share * (g * f.conj()).real for share, f, g in zip(shares, F, G, strict=True))
    return (each.reshape(-1, 9, 9) for each in (value, slope))


class Asked:
    def __init__(self, emitter):
        self.pupil = pupil(emitter=emitter)
        self.pupil_step = Grid(9, PIXEL).step(self.pupil)


def wrong(made, name, expected):
    off = np.abs(made.derivatives[name] - expected).max(axis=(1, 2))
    return float((off / made.values.max(axis=(1, 2))).max())


@pytest.mark.parametrize("tol", [1e-4, 1e-6, 1e-9])
@pytest.mark.parametrize("emitter", ["isotropic", "scalar"])
@pytest.mark.parametrize("normalize", ["strehl", "emitted"])
def test_derivatives_by_the_stage_and_the_depth_are_sums_over_the_same_angles(normalize, emitter, tol):
    of = Asked(emitter)
    made = lm.psf(
        of.pupil,
        9,
        PIXEL,
        tol=tol,
        center=CENTER,
        integrate=False,
        dtype=np.float64,
        normalize=normalize,
        derivatives=("z", "depth"),
    )
    power = of.pupil.power[:, None, None]
    scale = made.scale[:, None, None] / power
    value, slope = samples("z", of)
    assert made.values == pytest.approx(scale * value, abs=2 * tol * (scale * value).max())
    assert wrong(made, "z", scale * slope) <= made.derivative_bounds["z"] <= 30.0 * tol * 1e8
    value, slope = samples("depth", of)
    rate = (
        debye.power(of.pupil.layers, of.pupil.depth, of.pupil.light.model, by_depth=True)[0] @ of.pupil.light.shares
    )
    if normalize == "strehl":
        slope = slope - value * rate[:, None, None] / power
    assert wrong(made, "depth", scale * slope) <= made.derivative_bounds["depth"] <= 30.0 * tol * 1e8


@pytest.mark.parametrize("integrate", [False, True])
def test_derivatives_are_what_differences_come_to(integrate):
    options = {"integrate": integrate, "dtype": np.float64, "tol": 1e-9}
    names = ("row", "z", "column", "depth", "row")
    made = lm.psf(pupil(), 9, PIXEL, center=CENTER, derivatives=names, **options)
    assert list(made.derivatives) == ["row", "z", "column", "depth"]

    def moved(dy=0.0, dx=0.0):
        return lm.psf(pupil(), 9, PIXEL, center=(CENTER[0] + dy, CENTER[1] + dx), **options).values

    found = {
        "row": difference(moved, 1e-2),
        "column": difference(lambda h: moved(dx=h), 1e-2),
        "z": difference(lambda h: lm.psf(pupil(dz=h), 9, PIXEL, center=CENTER, **options).values, 2e-9),
        "depth": difference(lambda h: lm.psf(pupil(dd=h), 9, PIXEL, center=CENTER, **options).values, 2e-9),
    }
    for name, expected in found.items():
        size = float((np.abs(expected).max(axis=(1, 2)) / made.values.max(axis=(1, 2))).max())
        assert wrong(made, name, expected) <= 3e-7 * size
        assert made.derivative_bounds[name] <= 3e-7 * size


@pytest.mark.parametrize("method", [ChordalDebye, DebyeRings])
@pytest.mark.parametrize("tol", [1e-3, 1e-6])
def test_averages_move_by_the_samples_that_they_are_made_of(method, tol, monkeypatch):
    wavefront = lm.Wavefront.zernike({(2, 2): 0.9, (3, 1): 0.3})
    planes = OIL.pupil(depth=DEPTH, z=Z, wavelength=WAVE, origin="coverslip", aberrations=wavefront)
    options = {"integrate": True, "dtype": np.float64, "center": CENTER}

    def moved(dy=0.0, dx=0.0):
        more = options | {"center": (CENTER[0] + dy, CENTER[1] + dx), "tol": 1e-9}
        return lm.psf(planes, 7, PIXEL, method=ChordalDebye(1e-9), **more).values

    rounds = []
    name = "differentiated" if method is ChordalDebye else "_samples"
    asked = getattr(method, name)
    monkeypatch.setattr(method, name, lambda *given: (rounds.append(1), asked(*given))[1])
    found = {}
    for names in (("z", "row", "column"), ("row", "column")) if method is ChordalDebye else (("row", "column"),):
        rounds.clear()
        found[names] = lm.psf(planes, 7, PIXEL, method=method(tol), derivatives=names, **options)
        assert len(rounds) == 1
    monkeypatch.undo()
    for name, expected in (("row", difference(moved, 2e-2)), ("column", difference(lambda h: moved(dx=h), 2e-2))):
        for made in found.values():
            assert wrong(made, name, expected) <= made.derivative_bounds[name] <= 20.0 * tol


BRIEF = os.environ.get("HYPOTHESIS_PROFILE") != "thorough"


@pytest.mark.parametrize("seed", range(4 if BRIEF else 200))
def test_random_systems_are_within_their_bounds(seed):
    rng = np.random.default_rng(seed)
    n_i = rng.choice([1.0, 1.333, 1.518])
    of = lm.Objective(
        NA=rng.uniform(0.3, 0.95 * n_i),
        magnification=60,
        immersion=n_i,
        working_distance=0.4e-3,
        coverslip=lm.Layer(1.5255, 170e-6 + rng.uniform(-5e-6, 5e-6)),
        design=Design(n_i, lm.Layer(1.5255, 170e-6)),
        films=[lm.Layer(rng.uniform(1.4, 2.2), rng.uniform(20e-9, 300e-9)) for _ in range(rng.integers(0, 3))],
        sample=rng.uniform(1.0, 1.52),
    )
    depth, z = rng.uniform(0.3e-6, 8e-6), rng.uniform(-2e-6, 2e-6, 2)
    wave, center, integrate = rng.uniform(450e-9, 700e-9), rng.uniform(2.0, 4.0, 2), bool(seed % 2)
    focus = of.pupil(depth=depth, z=z, wavelength=wave, origin="paraxial").focus

    def at(tol, dz=0.0, dd=0.0, dy=0.0, dx=0.0, **more):
        planes = of.pupil(depth=depth + dd, z=focus + dz, wavelength=wave, origin="coverslip")
        axis = center[0] + dy, center[1] + dx
        return lm.psf(planes, 7, 5e-6, center=axis, integrate=integrate, dtype=np.float64, tol=tol, **more)

    steps = {"dz": ("z", 2e-9), "dd": ("depth", 2e-9), "dy": ("row", 1e-2), "dx": ("column", 1e-2)}
    made = at(10.0 ** -rng.integers(4, 8), derivatives=tuple(name for name, _ in steps.values()))
    for key, (name, h) in steps.items():
        expected = difference(lambda t, key=key: at(1e-8, **{key: t}).values, h)
        size = float((np.abs(expected).max(axis=(1, 2)) / made.values.max(axis=(1, 2))).max())
        assert wrong(made, name, expected) <= made.derivative_bounds[name] + 1e-7 * size


def test_wide_windows_around_their_middle_have_derivatives_of_averages():
    options = {"dtype": np.float64, "tol": 1e-8, "normalize": "strehl"}
    names = ("row", "z", "depth")
    far, near = (lm.psf(pupil(), side, PIXEL, derivatives=names, **options) for side in (101, 21))
    for name in names:
        off = np.abs(far.derivatives[name][:, 40:61, 40:61] - near.derivatives[name]).max()
        assert off <= (far.derivative_bounds[name] + near.derivative_bounds[name]) * near.values.max()
    with pytest.raises(ValueError, match="samples in windows up to"):
        lm.psf(pupil(), 101, PIXEL, integrate=False, derivatives=("z",))


def test_what_rounding_denies_the_engine_has_images_by_the_reference_and_derivatives_all_the_same(monkeypatch):
    fine = lm.psf(pupil(), 9, PIXEL, center=CENTER, tol=1e-7, dtype=np.float64, derivatives=("z",))
    made_of = stratified.differentiated
    monkeypatch.setattr(slopes, "differentiated", lambda *asked: made_of(*asked) if asked[3] >= 1e-6 else None)
    made = lm.psf(pupil(), 9, PIXEL, center=CENTER, tol=1e-7, dtype=np.float64, derivatives=("z",))
    assert made.error_bound <= 1e-7
    assert made.derivative_bounds["z"] > fine.derivative_bounds["z"]
    off = np.abs(made.derivatives["z"] - fine.derivatives["z"]).max()
    assert off <= 2.0 * made.derivative_bounds["z"] * made.values.max()


def test_each_plane_moves_about_its_own_axis_and_single_precision_stores_what_it_says():
    rows, columns = np.array([3.1, 4.4, 5.0]), np.array([4.0, 3.3, 4.9])
    names = ("z", "row", "column")
    made = lm.psf(pupil(), 9, PIXEL, center=(rows, columns), derivatives=names)
    for k in range(3):
        one = lm.psf(
            pupil()[k], 9, PIXEL, center=(rows[k], columns[k]), derivatives=names, tol=1e-9, dtype=np.float64
        )
        for name in names:
            assert made.derivatives[name].dtype == np.float32
            off = np.abs(made.derivatives[name][k] - one.derivatives[name]).max() / one.values.max()
            assert off <= made.derivative_bounds[name] + one.derivative_bounds[name]


@pytest.mark.parametrize(("emitter", "name"), [("isotropic", "z"), (lm.Dipole(0.7, 0.4), "row")])
def test_what_single_precision_stores_is_in_the_bound(emitter, name):
    of = pupil(emitter=emitter)[:1]
    made, exact = (
        lm.psf(of, 9, PIXEL, derivatives=[name], tol=1e-6, dtype=kind) for kind in (np.float32, np.float64)
    )
    stored = 2.0**-24 * np.abs(exact.derivatives[name]).max() / exact.values.max()
    added = made.derivative_bounds[name] - exact.derivative_bounds[name]
    assert added == pytest.approx(stored, rel=1e-2, abs=0.0)


@pytest.mark.parametrize("shape", [(1, 1), (1, 3), (2, 5), (5, 5)])
def test_bounds_of_derivatives_grow_by_what_storing_them_rounds(shape):
    bounds, asked = {}, pupil()[1]
    for dtype in (np.float32, np.float64):
        made = lm.psf(asked, shape, PIXEL, integrate=False, dtype=dtype, derivatives=("z",))
        bounds[dtype] = made.derivative_bounds["z"]
    most = np.abs(made.derivatives["z"]).max() / made.values.max()
    assert 0.99 * 2.0**-24 * most <= bounds[np.float32] - bounds[np.float64] <= 1.1 * 2.0**-24 * most
