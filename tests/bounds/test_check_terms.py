"""What is told of localised molecules, and how tables of them come within a tolerance, number by number."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from lommel.core.answers import ToleranceError
from lommel.localize import MovieInfo, checks, movie_fits
from lommel.localize import table as tables
from lommel.localize.checks import Checks, TableTest, scored
from lommel.localize.fitting import MoleculeErrors
from lommel.localize.table import Bounds, Table
from objectives import OIL

PUPIL = OIL.pupil(depth=0.0, wavelength=600e-9)
RNG = np.random.default_rng(3)


@pytest.mark.parametrize("sigmas", [5.0, 5.1])
def test_a_tilted_background_is_told_in_electrons_above_five_deviations(sigmas, monkeypatch):
    score = SimpleNamespace(without_changes=lambda sizes: score, tilt=lambda shape: (sigmas, 3.0, 0.5))
    monkeypatch.setattr(checks, "scored", lambda *_: score)
    made = Checks.__new__(Checks)
    made._changes, made._noise = (
        SimpleNamespace(done=False, images=None, add=lambda _: None),
        lm.Noise(read=1.0, excess=2.0),
    )
    made._table, made._once, made._residuals, made._background = None, {}, [([0] * 1000, 0, 0)], "flat"
    made._recording = SimpleNamespace(rows=1, columns=1)
    assert made.tilt(None, None, fitted=False) == sigmas
    told = [one.numbers for one in made._once.values()]
    assert told == ([{"slope": 6.0, "error": 1.0, "sigmas": sigmas}] if sigmas > 5.0 else [])


def test_the_gain_of_another_table_is_that_of_molecules_that_either_fits():
    likelihood = {"own": [-5.0, -6.0, -7.0, -8.0], "other": [-3.0, -3.0, -8.5, -3.0]}
    off = {"own": [9.0, 9.0, 1.0, 1.0], "other": [2.99, 3.0, 9.0, 1.0]}
    made = SimpleNamespace(_compared=0, _rival="other", _table="own", _gains=[7.0])
    made._refit = lambda table, **_: SimpleNamespace(
        log_likelihood=np.array(likelihood[table]), discrepancy=np.array(off[table]), converged=np.arange(4) < 3
    )
    Checks.compare(made, type("Four", (), {"images": [], "corners": [], "__len__": lambda _: 4})(), "flat")
    assert (made._gains, made._compared) == ([7.0, 2.0, -1.5], 4)


def test_scores_are_of_molecules_that_fit_with_all_that_was_fitted_eliminated():
    n, camera = 9, lm.Noise(white=0.5, read=1.2, offset=10.0, excess=1.5)
    values, changed, slopes = (
        RNG.uniform(0.1, 0.9, (n, 5, 5)),
        RNG.uniform(size=(n, 2, 5, 5)),
        RNG.random((3, n, 5, 5)),
    )
    errors = dict(zip(("row", "column", "z", "photons"), RNG.uniform(0.5, 2.0, (4, n)), strict=True))
    photons, level = RNG.uniform(200.0, 900.0, n), RNG.uniform(3.0, 8.0, n)
    images, corners = RNG.uniform(200.0, 900.0, (n, 5, 5)), np.array([[3, 4]] * n)
    images[1, 2, 3] = np.nan
    row, column = RNG.uniform(1.1, 2.9, (2, n))
    row[3] = 3.01  # beyond the reach
    above = 0.3 + checks.DOUBTFUL
    molecules = SimpleNamespace(
        row=row + 3.0, column=column + 4.0, z=np.arange(float(n)), photons=photons, background=level,
        discrepancy=np.array([0.1, 0.2, 0.3, 9.0, 0.25, above, above + 0.1, 0.0, above - 0.01]),
        converged=np.arange(n) != 7, errors=SimpleNamespace(**errors),
    )  # fmt: skip
    picked = [0, 1, 2, 4, 8]  # the median of those that are usable is 0.3

    class Made:
        shape, reach = (5, 5), 1.0

        def __call__(self, row, column, z, derivatives):
            assert z.tolist() == picked
            return values[picked], dict(zip(("row", "column", "z"), slopes[:, picked], strict=True))

    spots = SimpleNamespace(images=images, corners=corners)
    found, ramp = scored(spots, molecules, Made(), camera, lambda *_: changed[picked]), np.arange(5.0) - 2.0
    for k, one in enumerate(picked):
        light, down, across = photons[one] / 1.5, *np.broadcast_arrays(ramp[:, None], ramp)
        mean, counts = light * values[one] + level[one] / 1.5, (images[one] - 10.0) * 0.5 / 1.5
        weight = np.where(np.isfinite(counts), 1.0 / (mean + (1.2 / 1.5) ** 2), 0.0).ravel()
        parts = [*(light * slopes[:, one] * np.array([1.0, 1.0, 1e-6])[:, None, None]), values[one], np.ones((5, 5))]
        fitted, others = (np.reshape(many, (-1, 25)).T for many in (parts, [down, across, *(light * changed[one])]))
        root = np.sqrt(weight)[:, None]
        by_fit = np.linalg.lstsq(root * fitted, root * others, rcond=None)[0]
        left = others - fitted @ by_fit
        assert found.slope[k] == pytest.approx(
            left.T @ (weight * np.nan_to_num(counts - mean).ravel()), rel=1e-4, abs=0.0
        )
        assert found.information[k] == pytest.approx(left.T @ (weight[:, None] * left), rel=1e-5, abs=0.0)
        scale = np.array(
            [errors["row"][one], errors["column"][one], errors["z"][one] * 1e6, errors["photons"][one] / 1.5]
        )
        assert found.bias[k] == pytest.approx(by_fit[:4, 2:] / scale[:, None], rel=1e-5, abs=0.0)


@pytest.mark.parametrize(("error", "bias", "stated"), [
    (0.02e-6, 13.0, 0.04e-6), (0.02e-6, 12.0, None), (0.08e-6, 13.0, 0.1e-6), (None, 4.9, None), (None, 5.1, 0.1e-6),
])  # fmt: skip
def test_an_error_of_a_constant_is_told_that_molecules_leave_open_and_that_matters(error, bias, stated):
    """Twice what the molecules tell, and no more than half of what is expected; from a bias of one half on."""
    per_unit = np.zeros((2, 4, 3))
    per_unit[0, 1, 2], per_unit[:, 2, 2] = bias * 1e6 * math.sqrt(2.0), 1e5
    made = SimpleNamespace(_bias=per_unit, _images=SimpleNamespace(names=["a", "b", "depth"]))
    made.tests = lambda: [SimpleNamespace(name="depth", errors=(error, 1e9))] if error else []
    expected = (pytest.approx(stated), "column", pytest.approx(stated * bias * 1e6)) if stated else None
    assert TableTest.untested.fget(made).get("depth") == expected


def test_errors_of_places_are_in_metres():
    """Of positions in pixels; those of z, photons and background are what they were."""
    errors = MoleculeErrors(*(np.array([0.1 * k]) for k in range(1, 6)))
    molecules = SimpleNamespace(
        **{name: np.zeros(1) for name in ("discrepancy", "log_likelihood", "state")}, errors=errors
    )
    vars(molecules).update({name: np.zeros(1) for name in ("row", "column", "z", "photons", "background")})
    spots = type("One", (), dict.fromkeys(("frame", "score", "borders", "overlapping", "saturated", "left_out"), 0))
    spots.__len__ = lambda _: 1
    recording = MovieInfo(1, 9, 9, 2e-7, (5, 5), "z")
    table, width = SimpleNamespace(z=(-1.0, 1.0)), (np.array([-1.0, 1.0]), np.ones(2), np.ones(2))
    found = movie_fits._localizations(spots(), molecules, recording, width, table)
    names = ("y_error", "x_error", "z_error", "photons_error", "background_error")
    assert [float(found.table[name][0]) for name in names] == pytest.approx([2e-8, 4e-8, 0.3, 0.4, 0.5])
    assert {along: "z_error" in lm.localize.Localizations(
        found.table, replace(recording, along=along), 1, 0, 0).to_dict()["medians"] for along in ("z", "none")
    } == {"z": True, "none": False}  # fmt: skip


@pytest.mark.parametrize(("bounds", "tries"), [([0.99e-3], 1), ([2e-3, 1.79e-3, 1e-3], 3), ([2e-3, 1.81e-3], 0)])
def test_a_table_is_made_again_until_its_bound_is_below_the_tolerance(bounds, tries, monkeypatch):
    """Parts of the tolerance: 0.2 for taps, 0.15 for series, 0.3 for samples, all of them relative to the peak."""
    asked, planes, peaks = [], [], [0.31, 0.27, 0.22]

    class Made(Table):
        def _fill(self, sampling, exact):
            asked[-1] += (exact, sampling.per)
            self.error_bound = bounds[len(asked) - 1]
            return peaks[len(asked) - 1]

    def psf(pupil, shape, pixel, **options):
        planes.append((len(pupil.z), options))
        return SimpleNamespace(
            values=np.linspace(0.8, 0.4, 9)[:, None, None] * np.linspace(0.1, 1.0, 49).reshape(7, 7)
        )

    monkeypatch.setattr(tables, "psf", psf)
    taps, series = SimpleNamespace(gain=1.3), SimpleNamespace(gain=Bounds(1.7, 9.0))
    monkeypatch.setattr(tables.interpolation, "filtered_taps", lambda *of: asked.append(of) or taps)
    monkeypatch.setattr(tables, "pieces", lambda *of: asked.append((*asked.pop(), of[-1])) or series)
    with pytest.MonkeyPatch.context() if tries else pytest.raises(ToleranceError, match="dimmest plane"):
        Made(PUPIL, 7, 6.5e-6, z=(-1e-7, 1e-7), tol=1e-3)
    assert planes == [(9, {"normalize": "strehl", "tol": 1e-2, "integrate": True})]
    assert len(asked) == len(bounds)
    step, peak = math.pi * 6.5e-6 / PUPIL.scale, 0.95 * 0.4
    per = max(2, math.ceil(2.0 * step / 1.75))
    for found, bound, actual in zip(asked, bounds, peaks, strict=False):
        allowed = 1e-3 * peak
        expected = 2 * step / per, 0.2 * allowed, per, 0.15 * allowed / 1.69, 0.3 * allowed / (1.69 * 1.7), per
        assert found == pytest.approx(expected, rel=1e-9, abs=0.0)
        peak = min(0.7 * peak, 0.95 * actual * 1e-3 / bound)


@pytest.mark.parametrize("exact", [5e-5, 1e-13])
def test_samples_of_a_table_are_computed_again_until_each_block_is_exact_enough(exact, monkeypatch):
    """A bound e relative to the exact peak is e / (1 - e) of that which was computed."""
    asked, bright, expected, worst = [], {0: 0.7, 2: 0.9, 4: 0.2}, [], 0.0
    monkeypatch.setattr(tables, "_BLOCK_SAMPLES", 2 * 3 * 4)

    def render(part, shape, pixel, tol, **_):
        asked.append((part[0], len(part), tol))
        values = bright[part[0]] * np.linspace(0.5, 1.0, 12 * len(part)).reshape(len(part), *shape)
        return SimpleNamespace(values=values, error_bound=0.9 * tol + 2e-3 * (tol == 1e-3))

    series, waves = SimpleNamespace(places=np.arange(5)), SimpleNamespace(at=lambda places: places)
    made, sampling = (
        SimpleNamespace(_render=render, pixel=6.0, tol=1e-4),
        SimpleNamespace(planes=series, per=3, waves=waves),
    )
    for first, most in bright.items():
        tol, bound = 1e-3, math.inf
        while bound > exact and (not expected or expected[-1][2] != 1e-12):
            expected.append((first, min(2, 5 - first), pytest.approx(tol, rel=1e-9, abs=0.0)))
            bound = 0.9 * tol + 2e-3 * (tol == 1e-3)
            bound *= most / (1.0 - bound)
            tol, last = max(1e-12, min(tol / 2.0, 0.8 * tol * exact / bound)), tol
        worst = max(worst, min(bound, 1.0))
        if last == 1e-12:
            break
    if exact < 1e-12:
        with pytest.raises(ToleranceError, match="dimmest plane") as told:
            Table._samples(made, sampling, (3, 4), (1, 2), exact)
        assert told.value.bound == pytest.approx(worst / exact * 1e-4, rel=1e-9, abs=0.0)
    else:
        values, error = Table._samples(made, sampling, (3, 4), (1, 2), exact)
        assert error == pytest.approx(worst, rel=1e-9, abs=0.0)
        assert values.max(axis=(1, 2))[[1, 3, 4]] == pytest.approx([0.7, 0.9, 0.2])
    assert asked == expected


def test_limits_of_tables_are_those_of_the_page_and_the_tolerance_is_1e_4(monkeypatch):
    monkeypatch.setattr(Table, "_build", lambda self: None)
    assert [Table(PUPIL, z=(0.0, 1e-4), **of).tol for of in ({}, {"tol": 1e-5}, {"tol": 0.1})] == [1e-4, 1e-5, 0.1]
    for z, tol, told in (
        ((0.0, 1e-6), 0.99e-5, "tol must be"), ((0.0, 1e-6), 0.101, "tol must be"), ((0.0,), 1e-4, r"got \(0"),
        ((0.0, 0.9e-9), 1e-4, "got 0 .*m and"),
    ):  # fmt: skip
        with pytest.raises(ValueError, match=told):
            Table(PUPIL, z=z, tol=tol)
