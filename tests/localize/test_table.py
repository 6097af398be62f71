"""Tables of molecules: values and slopes against images by circles, bounds, and what is refused."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import lommel as lm
from cases import each
from lommel import _core
from lommel.localize import Table
from lommel.methods import DebyeRings, Stratified
from objectives import OIL

ASTIGMATISM = lm.Wavefront.zernike({6: 0.15}, order="noll", unit="waves")
TIRF = lm.Objective(NA=1.49, magnification=100, immersion=1.518, sample=1.33)
WATER = lm.Objective(NA=1.2, magnification=60, immersion=1.33, sample=1.33)
SHORT = lm.Objective(NA=1.4, magnification=63, immersion=1.518, sample=1.33)
PUPIL = SHORT.pupil(depth=1e-6, wavelength=600e-9, aberrations=ASTIGMATISM)
RANGE = (-0.3e-6, 0.35e-6)
STEP = 4e-9  # metres along z of differences of the fourth order
OBJECTIVES = Path(__file__).parents[2] / "examples/objectives"


@pytest.fixture(scope="module")
def table() -> Table:
    return Table(PUPIL, shape=(11, 13), pixel=6.5e-6, z=RANGE, reach=2.0)


def plane(pupil, z: float, along: str = "z"):
    """The pupil at a place along z, by way of the stage or the depth as a user would move them."""
    objective, given = SHORT, {"wavelength": 600e-9, "aberrations": pupil.aberrations, "emitter": pupil.emitter}
    for other in (TIRF, WATER):
        objective = other if pupil.layers.NA == other.NA else objective
    if along == "z":
        return objective.pupil(depth=float(pupil.depth), z=z, **given)
    return objective.pupil(depth=z, z=float(pupil.focus), origin="coverslip", **given)


def check(made: Table, places: list[tuple[float, float, float]]) -> None:
    """Values and slopes are within their bounds of images that no sums over chords are in."""
    middle = [side // 2 for side in made.shape]
    z = np.linspace(*made.z, 41)
    dimmest = made(*middle, z).max(axis=(1, 2)).min()
    for row, column, at in places:
        pupil = plane(made.pupil, at, made.along)
        by_circles = DebyeRings(1e-9) if pupil.aberrated else Stratified(1e-9)
        asked = {"method": by_circles, "center": (row, column), "dtype": np.float64}
        exact = lm.psf(pupil, made.shape, made.pixel, derivatives=("row", "column"), **asked)
        near = {
            k: lm.psf(plane(made.pupil, at + k * STEP, made.along), made.shape, made.pixel, **asked).values
            for k in (-2, -1, 1, 2)
        }
        derivatives = dict(exact.derivatives)
        derivatives[made.along] = (8.0 * (near[1] - near[-1]) - (near[2] - near[-2])) / (12.0 * STEP)
        values, slopes = made(row, column, at, derivatives=True)
        assert np.abs(values - exact.values).max() <= made.error_bound * dimmest
        for name, derivative in derivatives.items():
            off, largest = np.abs(slopes[name] - derivative).max(), np.abs(derivative).max()
            assert off <= made.slope_bounds[name] * dimmest + 1e-5 * largest
            assert off <= 3.0 * made.tol * largest  # far below its bound


CASES = {
    "astigmatic": (PUPIL, {"shape": 11, "pixel": 6.5e-6, "z": RANGE}),
    "coarse": (PUPIL, {"shape": 9, "pixel": 10e-6, "z": RANGE, "tol": 1e-3}),
    "coarser": (PUPIL, {"shape": (7, 8), "pixel": 14e-6, "z": (0.0, 0.2e-6)}),
    "fine": (PUPIL, {"shape": 8, "pixel": 4e-6, "z": RANGE, "tol": 1e-5, "reach": 1.0}),
    "dipole": (
        SHORT.pupil(depth=1e-6, wavelength=600e-9, aberrations=ASTIGMATISM, emitter=lm.Dipole(0.7, 0.4)),
        {"shape": 9, "pixel": 6.5e-6, "z": RANGE},
    ),
    "scalar": (
        SHORT.pupil(depth=1e-6, wavelength=600e-9, aberrations=ASTIGMATISM, emitter="scalar"),
        {"shape": 9, "pixel": 6.5e-6, "z": RANGE},
    ),
    "unaberrated": (SHORT.pupil(depth=1e-6, wavelength=600e-9), {"shape": 9, "pixel": 6.5e-6, "z": RANGE}),
    "near the glass": (
        TIRF.pupil(depth=0.1e-6, wavelength=600e-9, aberrations=ASTIGMATISM),
        {"shape": 9, "pixel": 10e-6, "z": RANGE},
    ),
    "water": (
        WATER.pupil(depth=20e-6, wavelength=600e-9, aberrations=lm.Wavefront.zernike({6: 0.1, 8: 0.1}, order="noll")),
        {"shape": 9, "pixel": 6.5e-6, "z": RANGE},
    ),
    "by depth": (
        TIRF.pupil(depth=0.2e-6, wavelength=600e-9, aberrations=ASTIGMATISM),
        {"shape": 9, "pixel": 10e-6, "z": (2 * STEP, 0.4e-6), "along": "depth"},
    ),
    "by depth, deeper": (
        SHORT.pupil(depth=0.9e-6, wavelength=600e-9, aberrations=ASTIGMATISM),
        {"shape": 9, "pixel": 6.5e-6, "z": (0.7e-6, 1.2e-6), "along": "depth"},
    ),
}


@each("name", CASES)
def test_values_and_slopes_are_within_the_bounds(name):
    pupil, options = CASES[name]
    made = Table(pupil, **options)
    assert made.error_bound <= made.tol == options.get("tol", 1e-4)
    (low_row, low_column, low), (high_row, high_column, high) = made.limits
    rng = np.random.default_rng(len(name))
    inner = [tuple(made.limits[0] + rng.random(3) * (made.limits[1] - made.limits[0])) for _ in range(2)]
    check(made, [(low_row, high_column, low), (high_row, low_column, high), *inner])


@given(
    terms=st.lists(st.floats(-0.15, 0.15), min_size=4, max_size=4),
    depth=st.floats(0.05e-6, 5e-6),
    tol=st.sampled_from([1e-2, 1e-3, 1e-4]),
    seed=st.integers(0, 99),
)
@settings(max_examples=12, deadline=None)
def test_any_wavefront_keeps_to_the_bound(terms, depth, tol, seed):
    wavefront = lm.Wavefront.zernike(dict(zip((5, 7, 11, 12), terms, strict=True)), order="noll", unit="waves")
    pupil = SHORT.pupil(depth=depth, wavelength=600e-9, aberrations=wavefront)
    made = Table(pupil, shape=9, pixel=6.5e-6, z=(-0.2e-6, 0.2e-6), tol=tol, reach=1.0)
    rng = np.random.default_rng(seed)
    row, column, z = made.limits[0] + rng.random(3) * (made.limits[1] - made.limits[0])
    moved = SHORT.pupil(depth=depth, z=z, wavelength=600e-9, aberrations=wavefront)
    method = DebyeRings(1e-7) if moved.aberrated else Stratified(1e-7)
    exact = lm.psf(moved, 9, 6.5e-6, method=method, center=(row, column), dtype=np.float64).values
    dimmest = made(4, 4, np.linspace(*made.z, 41)).max(axis=(1, 2)).min()
    assert np.abs(made(row, column, z) - exact).max() <= (made.error_bound + 1e-6) * dimmest


def exact_sums(made: Table, row: float, column: float, z: float) -> np.ndarray:
    """The image that the coefficients of a table stand for, in double precision."""
    pieces, rows, per, wide, *shape = made._parts["sizes"]
    first_row, first_column, low, high, *_ = made._parts["numbers"]
    stored = made._parts["coefficients"][: pieces * 8 * rows * per * wide].astype(float)
    series = np.swapaxes(stored.reshape(pieces, 8, rows, per, wide), -1, -2).reshape(pieces, 8, rows, -1)
    at = (z - low) / (high - low) * pieces
    piece = min(int(at), pieces - 1)
    values = np.tensordot(np.polynomial.chebyshev.chebvander([2.0 * (at - piece) - 1.0], 7)[0], series[piece], 1)
    for axis, (place, first) in enumerate(((row, first_row), (column, first_column))):
        position = -per * place - first
        powers = made._parts["polynomials"][::-1]
        taps = np.polynomial.polynomial.polyval(2.0 * (position - math.floor(position)) - 1.0, powers)
        weights = np.zeros((shape[axis], values.shape[axis]))
        for pixel in range(shape[axis]):
            start = math.floor(position) + 1 - taps.size // 2 + per * pixel
            weights[pixel, start : start + taps.size] = taps
        values = weights @ values if axis == 0 else values @ weights.T
    return values


def test_sums_in_single_precision_are_within_what_is_allowed_for_rounding(monkeypatch):
    kept = {}
    before = Table._bound

    def bound(self, sampling, error, sizes, light):
        peak, taps = before(self, sampling, error, sizes, light), sampling.taps
        often = taps.taps.weighted(2.0 + taps.taps.size - np.maximum(np.arange(taps.taps.size), 1))
        gain, (largest, summed) = taps.taps.gain, sizes
        kept["allowed"] = 1.001 * 2.0**-24 * gain * (gain * summed + 2.0 * often * largest) * light
        return peak

    monkeypatch.setattr(Table, "_bound", bound)
    made = Table(PUPIL, 9, 6.5e-6, z=RANGE)
    rng = np.random.default_rng(3)
    off = []
    for _ in range(60):
        at = made.limits[0] + rng.random(3) * (made.limits[1] - made.limits[0])
        off.append(np.abs(made(*at) - exact_sums(made, *at)).max())
    assert 0.003 * kept["allowed"] <= max(off) <= kept["allowed"]


@each("name", ["zeiss-63x-astigmatic", "zeiss-63x-1.4-oil"])
def test_molecules_of_any_depth_have_a_table_by_default(name):
    microscope = lm.load_microscope(OBJECTIVES / f"{name}.toml")
    pupil = microscope.objective.pupil(depth=1e-6, wavelength=600e-9, aberrations=ASTIGMATISM)
    assert Table(pupil, 15, microscope.pixel, z=(0.0, 1e-6), along="depth").error_bound <= 1e-4


def test_all_instructions_say_the_same(table):
    places = 5 + np.random.default_rng(0).uniform(-2.0, 2.0, (7, 2))
    found = {}
    before = _core.instructions()
    try:
        for level in ("portable", "avx2", "avx512"):
            _core.limit_instructions(level)
            found[level] = table(places[:, 0], places[:, 1] + 1.0, 0.1e-6, derivatives=True)
    finally:
        _core.limit_instructions("avx512")
    assert _core.instructions() == before
    for values, slopes in found.values():
        np.testing.assert_allclose(values, found["portable"][0], atol=1e-6 * values.max())
        for name, slope in slopes.items():
            np.testing.assert_allclose(slope, found["portable"][1][name], atol=1e-5 * np.abs(slope).max())


def test_any_number_of_threads_says_the_same(table):
    rows = 5.0 + np.random.default_rng(1).uniform(-2.0, 2.0, 300)
    places = np.stack([rows, rows + 1.0, np.zeros(300)], axis=1)
    np.testing.assert_array_equal(table.core.images(places, 1), table.core.images(places, 2))


def test_limits_of_a_table_in_the_core_must_rise(table):
    numbers = table._parts["numbers"]
    with pytest.raises(ValueError, match="limits must rise"):
        _core.MoleculeTable(**table._parts | {"numbers": [*numbers[:3], np.inf, *numbers[4:]]})


BAD = [
    ({"pupil": SHORT.pupil(depth=1e-6, z=[0, 1e-6], wavelength=6e-7)}, ValueError, "pupil must be a single pupil"),
    ({"z": (1e-6, 0.0)}, ValueError, "z must be (lowest, highest) in metres, 1 nm to 100 um apart, got 1 um and 0 m"),
    ({"z": (-1e-6, 1e-6), "along": "depth"}, ValueError, "z must be depths >= 0 metres with along='depth', got"),
]


@each("case", BAD)
def test_bad_input_is_refused(case):
    changes, kind, message = case
    given = {"pupil": PUPIL, "shape": 9, "pixel": 6.5e-6, "z": (-1e-7, 1e-7)} | changes
    with pytest.raises(kind, match=re.escape(message)):
        Table(given.pop("pupil"), **given)


@each(
    "case",
    [
        ((2.9, 6.0, 0.0), "row must be from 3 to 7, the range of the table, got 2.9"),
        ((5.0, 8.1, 0.0), "column must be from 4 to 8, the range of the table, got 8.1"),
        ((5.0, 6.0, 0.4e-6), "z must be from -3e-07 to 3.5e-07, the range of the table, got 4e-07"),
    ],
)
def test_places_beyond_the_table_are_refused(case, table):
    places, message = case
    with pytest.raises(ValueError, match=re.escape(message)):
        table(*places)


def test_the_pupil_may_be_of_any_plane_of_the_stage(table):
    moved = Table(plane(PUPIL, 0.2e-6), shape=(11, 13), pixel=6.5e-6, z=RANGE, reach=2.0)
    np.testing.assert_allclose(moved(5.2, 6.1, 0.1e-6), table(5.2, 6.1, 0.1e-6), rtol=0.0, atol=1e-9)


def test_a_thick_cover_glass_takes_part():
    pupil = OIL.pupil(depth=1e-6, wavelength=520e-9, aberrations=ASTIGMATISM)
    made = Table(pupil, shape=9, pixel=6.5e-6, z=(-0.1e-6, 0.1e-6))
    exact = lm.psf(
        OIL.pupil(depth=1e-6, z=0.05e-6, wavelength=520e-9, aberrations=ASTIGMATISM),
        9,
        6.5e-6,
        tol=1e-7,
        center=(4.2, 3.9),
    ).values
    np.testing.assert_allclose(made(4.2, 3.9, 0.05e-6), exact, atol=1e-4 * exact.max())
