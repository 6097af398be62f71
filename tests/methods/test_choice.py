"""Which method answers where none is named."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import lommel as lm
from disk_questions import disk_question
from lommel import _core
from lommel.core.answers import Declined
from lommel.core.engine import Window, disk_costs
from lommel.methods import ChordalGauss, NijboerZernike, NonuniformFFT, choice
from lommel.methods.nijboer_zernike import disk_stack, window_of
from lommel.optics.grid import Grid

COMA = lm.Pupil(lm.Wavefront(1.0, nonradial={(3, 1): 2.0}))
STACK = lm.Pupil(lm.Wavefront(np.zeros(8), nonradial={(3, 1): np.linspace(1, 2, 8)}))
STRONG = lm.Pupil(lm.Wavefront(nonradial={(20, 2): 100.0}))
TILTED = lm.Pupil(lm.Wavefront(nonradial={(1, 1): 4000.0, (3, 1): 1.0}))


@pytest.mark.parametrize(
    ("pupil", "shape", "options", "method"),
    [
        (lm.Pupil(lm.Wavefront(9.0), obscuration=0.3), 33, {}, NijboerZernike),
        (COMA, 33, {}, ChordalGauss),
        (COMA, 33, {"integrate": True}, ChordalGauss),
        (COMA, 400, {}, NijboerZernike),
        (STACK, 100, {}, ChordalGauss),
        (COMA, (201, 401), {}, NijboerZernike),
        (lm.Pupil(vignetting=lm.Ellipse(0.9, 0.6)), 17, {}, NonuniformFFT),
    ],
)
def test_every_pupil_and_window_goes_to_the_method_that_serves_it(pupil, shape, options, method):
    answer = lm.psf(pupil, shape, 0.5, **options)
    assert type(answer.method) is method
    assert lm.psf(pupil, shape, 0.5, tol=1e-8, **options).method == method(1e-8)
    assert lm.Plan(shape, 0.5, **options)(pupil).values.tobytes() == answer.values.tobytes()


def test_a_small_window_that_the_light_misses_goes_to_the_series():
    answer = lm.psf(TILTED, 17, 0.5, normalize="strehl")
    assert type(answer.method) is NijboerZernike
    assert answer.values.max() < 1e-4
    with pytest.raises(ValueError, match="chords"):
        lm.psf(TILTED, 17, 0.5, method="chordal-gauss")


def test_both_methods_for_general_wavefronts_agree():
    series = lm.psf(COMA, 33, 0.5, method=NijboerZernike(1e-9), dtype=np.float64)
    matrix = lm.psf(COMA, 33, 0.5, method=ChordalGauss(1e-9), dtype=np.float64)
    assert lm.peak_error(series, matrix) <= series.error_bound + matrix.error_bound


def test_each_rule_of_the_table_has_a_pupil_that_it_is_the_first_for():
    objective = lm.Objective(
        NA=1.2, magnification=60, immersion=1.33, working_distance=3e-4, coverslip=None, sample=1.33
    )
    behind_layers = objective.pupil(depth=0.0, wavelength=500e-9)
    measured = objective.pupil(depth=0.0, wavelength=500e-9, aberrations=lm.Wavefront(spherical=1.0))
    cases = [
        (measured, 33),
        (behind_layers, 33),
        (lm.Pupil(), 33),
        (COMA, 33),
        (lm.Pupil(spider=lm.Spider.equal(3, width=0.05)), 33),
    ]
    for rule, (pupil, side) in zip(choice.RULES, cases, strict=True):
        grid = Grid(side, 0.5)
        assert next(other for other in choice.RULES if other.applies(pupil, grid)) is rule
        assert tuple(type(way) for way in choice.candidates(pupil, grid)) == rule.methods


@pytest.mark.parametrize(("processor", "level"), [("Zen 5", "avx512"), ("Zen 5", "avx2"), ("Zen 1", "avx2")])
def test_the_choice_is_that_of_the_times_that_were_measured(processor, level):
    """What benchmarks/choice.py measured of both methods; the choice itself is by counts and takes no time here."""
    widest = _core.instructions()
    _core.limit_instructions(level)
    try:
        if _core.instructions() != level:
            pytest.skip(f"the processor has no {level}")
        ratios = []
        for line in (Path(__file__).parent / "choice.csv").read_text(encoding="utf-8").splitlines():
            if line.startswith(f"{processor},{level},"):
                index, *took = line.split(",")[2:]
                pupil, grid, tol = disk_question(int(index))
                try:
                    costs = disk_costs(disk_stack(pupil), window_of(pupil, grid), tol)
                except ValueError:
                    costs = (math.inf, 0.0)
                times = [float(one) for one in took]
                ratios.append(times[costs[1] < costs[0]] / min(times))
    finally:
        _core.limit_instructions(widest)
    assert len(ratios) >= 290
    assert np.mean(np.array(ratios) <= 1.25) >= 0.95
    assert max(ratios) <= 1.5


def test_more_of_anything_costs_no_less():
    def costs(pupil: lm.Pupil, side: int, pixel: float = 0.5, tol: float = 1e-6) -> np.ndarray:
        return np.array(disk_costs(disk_stack(pupil), window_of(pupil, Grid(side, pixel)), tol))

    base = costs(COMA, 65)
    stronger = lm.Pupil(lm.Wavefront(5.0, nonradial={(3, 1): 20.0}))
    obscured = lm.Pupil(COMA.wavefront, obscuration=0.3)
    for more in (
        costs(COMA, 129),
        costs(COMA, 65, 2.0),
        costs(stronger, 65),
        costs(obscured, 65),
        costs(COMA, 65, tol=1e-9),
    ):
        assert np.all(more > base)
    # Each pupil of a stack adds its own to what chords have looked at before.
    alone, halves = (sum(costs(STACK[k : k + n], 65)[1] for k in range(0, 8, n)) for n in (1, 4))
    assert alone - halves == pytest.approx(6.0 * (halves - costs(STACK, 65)[1]), rel=1e-9)
    # A tilt moves the axis, which costs the series nothing but the reach.
    tilted = lm.Pupil(lm.Wavefront(1.0, nonradial={(3, 1): 2.0, (1, 1): 8.0 * math.pi / 2.0}))
    moved = disk_costs(disk_stack(COMA), Window((65, 65), (32, 40), math.pi / 2.0), 1e-6)
    assert costs(tilted, 65)[1] == pytest.approx(moved[1], rel=0.01)
    # What is dark is expanded as far as it is seen.
    assert costs(lm.Pupil(COMA.wavefront, obscuration=0.9), 65)[1] > 1.05 * costs(obscured, 65)[1]


def test_what_one_of_the_methods_can_prove_is_answered():
    strong = lm.Pupil(lm.Wavefront(nonradial={(8, 2): 250.0}))
    with pytest.raises(lm.ToleranceError):
        lm.psf(strong, 33, 4.0, method=NijboerZernike(1e-8))
    assert lm.psf(strong, 33, 4.0, tol=1e-8).method == ChordalGauss(1e-8)
    with pytest.raises(Declined, match="nodes"):
        lm.psf(STRONG, 33, 4.0, method=ChordalGauss(1e-8))
    assert lm.psf(STRONG, 33, 4.0, tol=1e-8).method == NijboerZernike(1e-8)


def test_the_next_method_is_asked_where_one_proves_nothing_and_the_last_one_says_why():
    asked = []

    def ask(way):
        asked.append(way)
        if len(asked) < 3:
            raise lm.ToleranceError(f"{way.tol:g} is not proven")
        return "proven"

    ways = tuple(NijboerZernike(tol) for tol in (1e-3, 1e-4, 1e-5))
    assert choice.first_within_tolerance(ways, ask) == (ways[2], "proven")
    assert asked == list(ways)
    asked.clear()
    with pytest.raises(lm.ToleranceError, match=r"0\.0001 is not proven"):
        choice.first_within_tolerance(ways[:2], ask)


def test_a_tolerance_below_that_of_the_only_method_is_refused():
    with pytest.raises(ValueError, match=r"tol must be >= 1e-12 and < 0\.1, got 1e-13"):
        lm.psf(lm.Pupil(spider=lm.Spider.equal(3, width=0.05)), 9, 0.5, tol=1e-13)
    assert lm.psf(COMA, 9, 0.5, tol=1e-11).error_bound <= 1e-11


@pytest.mark.parametrize(("part", "options"), [("plan", {}), ("images", {"integrate": True})])
def test_a_fault_of_the_code_is_not_hidden_by_the_next_method(monkeypatch, part, options):
    def broken(*_):
        raise ValueError("a bug")

    monkeypatch.setattr(ChordalGauss, part, broken)
    lm.clear_caches()  # of plans that are made
    with pytest.raises(ValueError, match="a bug"):
        lm.psf(COMA, 9, 0.5, **options)


def test_the_next_method_answers_a_plan_whose_first_one_declines():
    plan = lm.Plan(17, 0.5)
    strong = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 900.0}))
    with pytest.raises(Declined):
        lm.psf(strong, 17, 0.5, method="chordal-gauss")
    for pupil in (COMA, strong, COMA, TILTED):
        answer = plan(pupil)
        assert answer.method == (ChordalGauss() if pupil is COMA else NijboerZernike())
        assert answer.values.tobytes() == lm.psf(pupil, 17, 0.5).values.tobytes()
