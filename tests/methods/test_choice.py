"""Which method answers where none is named."""

from __future__ import annotations

import math
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from disk_questions import aperture_question, disk_question
from lommel import _core
from lommel.core.answers import Declined, Samples, Wanted
from lommel.core.engine import Window, disk_costs
from lommel.methods import ChordalGauss, Hankel, NijboerZernike, NonuniformFFT, choice, nijboer_zernike
from lommel.methods.chordal_gauss import ChordalIfCheaper
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
        (lm.Pupil(obscuration=0.3, spider=lm.Spider.equal(3, width=0.05)), 33),
        (lm.Pupil(obscuration=0.02, spider=lm.Spider.equal(3, width=0.05)), 33),
    ]
    for rule, (pupil, side) in zip(choice.RULES, cases, strict=True):
        grid = Grid(side, 0.5)
        assert next(other for other in choice.RULES if other.applies(pupil, grid)) is rule
        assert tuple(type(way) for way in choice.candidates(pupil, grid)) == rule.methods


@pytest.mark.parametrize(("processor", "level"), [("Xeon", "avx512"), ("Xeon", "avx2")])
def test_the_choice_is_that_of_the_times_that_were_measured(processor, level):
    """What benchmarks/choice.py measured of both methods; the choice itself is by counts and takes no time here."""
    widest = _core.instructions()
    _core.limit_instructions(level)
    try:
        if _core.instructions() != level:
            pytest.skip(f"the processor has no {level}")
        ratios = []
        for line in (Path(__file__).parent / "choice.csv").read_text(encoding="utf-8").splitlines():
            if line.startswith(f"{processor},{level},") and "aperture" not in line:
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


def test_the_choice_behind_vanes_is_that_of_the_times_that_were_measured():
    """Averages, which chords decline where they are estimated to take longer."""
    ratios = []
    for line in (Path(__file__).parent / "choice.csv").read_text(encoding="utf-8").splitlines():
        _, level, index, *took = line.split(",")
        if level != _core.instructions() or not index.startswith("aperture"):
            continue
        kind, (pupil, grid, tol) = aperture_question(int(index.split()[1]))
        times = [float(one) for one in took]
        if kind == "annulus" or not grid.integrate or not math.isfinite(times[0]):
            continue
        try:
            ChordalIfCheaper(tol).images(pupil, grid, Wanted(threads=1))
            ratios.append(times[0] / min(times))
        except Declined:
            ratios.append(times[1] / min(times))
    if not ratios:
        pytest.skip("not measured with these instructions")
    assert np.mean(np.array(ratios) <= 1.5) >= 0.95
    assert max(ratios) <= 2.5


@pytest.mark.parametrize(("widths", "side", "pixel", "pupils", "declines"), [
    ((0.02, 0.035, 0.05), 33, 2.0, (), True), ((0.02, 0.035, 0.05), 33, 4.0, (), True),
    ((0.02, 0.035, 0.05), 33, 5.0, (), False), ((0.02, 0.035, 0.05), 33, 1.0, (), False),
    ((0.02, 0.035, 0.05), 128, 0.5, (), False), ((0.02, 0.035, 0.05), 33, 4.0, (2,), False),
    ((0.02, 0.02, 0.02), 33, 4.0, (), False), ((0.05, 0.05, 0.05, 0.05), 33, 4.0, (), False),
])  # fmt: skip
def test_averages_of_one_image_behind_wide_vanes_on_one_side_are_at_nodes_of_the_aperture(
    widths, side, pixel, pupils, declines
):
    stop = lm.Disc()
    for k, width in enumerate(widths):
        angle = 2.0 * math.pi * k / len(widths)
        stop = stop - lm.Polygon.strip((0.0, 0.0), (2.0 * math.cos(angle), 2.0 * math.sin(angle)), width)
    if len(widths) == 4:  # pairs of vanes are one strip
        pupil = lm.Pupil(lm.Wavefront(1.0), obscuration=0.3, spider=lm.Spider.equal(4, widths[0]))
    else:
        pupil = lm.Pupil(lm.Wavefront(np.ones(pupils)), obscuration=0.3, stop=stop)
    grid = Grid(side, pixel, integrate=True)
    if declines:
        with pytest.raises(Declined, match="nodes of the aperture"):
            ChordalIfCheaper(1e-4)._filters(pupil, grid, Wanted())
    else:
        assert ChordalIfCheaper(1e-4)._filters(pupil, grid, Wanted())
    assert ChordalGauss(1e-4)._filters(pupil, grid, Wanted())


def test_single_images_of_similar_phases_share_large_tables():
    plan = lm.Plan(301, 0.5, method="chordal-gauss", tol=1e-4, threads=1)
    kept = []
    for coma in (2.0, 3.0, 3.5, 4.0):
        plan(lm.Pupil(lm.Wavefront(1.0, nonradial={(3, 1): coma})))
        kept.append(_core.cached_bytes()[0])
    assert kept[-1] - kept[0] < 1e6


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


@pytest.mark.parametrize(("faults", "told"), [
    ("dt", 1), ("td", 0), ("dd", 0), ("ddd", 1), ("tt", 1), ("tdt", 2), ("dtd", 1), ("d", 0), ("ddt", 2),
])  # fmt: skip
def test_of_methods_that_all_fail_a_tolerance_is_told_rather_than_why_one_declines(faults, told):
    """The last tolerance or, without one, the last reason but that of the chordal rule, which is asked last."""
    ways = tuple(NijboerZernike(10.0 ** (-k - 2)) for k in range(len(faults)))

    def fail(way):
        k = ways.index(way)
        raise {"d": Declined, "t": lm.ToleranceError}[faults[k]](str(k))

    with pytest.raises((Declined, lm.ToleranceError), match=f"^{told}$"):
        choice.first_within_tolerance(ways, fail)


@pytest.mark.parametrize("aberrated", [False, True])
@pytest.mark.parametrize("radial", [False, True])
def test_derivatives_of_objectives_try_chords_first_where_the_light_depends_on_the_azimuth(aberrated, radial):
    pupil = SimpleNamespace(aberrated=aberrated, light=SimpleNamespace(radial=radial))
    for methods in ((NijboerZernike(1e-4),), (NijboerZernike(1e-4), NijboerZernike(1e-5))):
        *tried, last = choice.of_derivatives(pupil, methods)
        assert (type(last).__name__, last.tol) == ("ChordalDebye", 1e-4)
        first = [] if aberrated or radial else [("ChordalDebyeIfCheaper", 1e-4)]
        assert [(type(one).__name__, one.tol) for one in tried[: len(first)]] == first
        assert tuple(tried[len(first) :]) == methods


def test_references_are_exact_to_a_billionth_or_by_quadrature():
    objective = lm.Objective(
        NA=1.2, magnification=60, immersion=1.33, working_distance=3e-4, coverslip=None, sample=1.33
    )
    measured = objective.pupil(depth=0.0, wavelength=500e-9, aberrations=lm.Wavefront(spherical=1.0))
    vanes = lm.Pupil(spider=lm.Spider.equal(3, width=0.05))
    for pupil in (objective.pupil(depth=0.0, wavelength=500e-9), measured, COMA, vanes):
        assert [way.tol for way in choice.references(pupil)] == [1e-9] * (2 if pupil is COMA else 1)
    assert choice.references(lm.Pupil()) == (Hankel(),)


@pytest.mark.parametrize(("kind", "pupil"), [(ChordalGauss, COMA), (NijboerZernike, lm.Pupil())])
def test_plans_are_of_one_axis_of_amplitudes_without_an_error_and_those_of_chords_of_samples(kind, pupil):
    def planned(pupil, grid):
        return kind().plan(pupil, grid, Wanted(1.0)) is not None

    vague = lm.Pupil(pupil.wavefront, apodization=lm.Apodization([0.5], error=1e-9))
    assert planned(pupil, Grid(5, 0.5))
    assert planned(pupil, Grid(5, 0.5, integrate=True)) == (kind is NijboerZernike)
    assert not planned(vague, Grid(5, 0.5))
    assert not planned(pupil, Grid(5, 0.5, center=(np.array([2.0, 2.1]), np.array([2.0, 2.0]))).broadcast((2,)))


@pytest.mark.parametrize("integrate", [False, True])
@pytest.mark.parametrize(("pays", "of_slopes", "powers", "sampled"), [
    (False, False, (1,), [False]), (False, True, (1,), [False, True]), (True, False, (1,), [True, True]),
    (True, True, (), [True]), (False, True, (), [False]),
])  # fmt: skip
def test_averages_and_their_derivatives_are_each_by_filters_where_these_pay(
    pays, of_slopes, powers, sampled, integrate, monkeypatch
):
    asked, made = [], Samples(np.ones((1, 5, 5)), np.ones(1), np.zeros(1))
    monkeypatch.setattr(
        nijboer_zernike, "filters_pay", lambda *_, derivatives=False: of_slopes if derivatives else pays
    )
    monkeypatch.setattr(nijboer_zernike, "disk_images", lambda *_: asked.append(True) or made)
    monkeypatch.setattr(nijboer_zernike, "radial_images", lambda *_, **__: asked.append(False) or made)
    NijboerZernike().images(lm.Pupil(), Grid(5, 1.0, integrate=integrate), Wanted(1.0, powers=powers))
    assert asked == (sampled if integrate else [False])


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
