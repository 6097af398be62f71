"""What the engine has to reach: each row measured as it is worded, judged, and measured again if it fails."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.baselines import Plain, copy, fewest, fft, plain
from benchmarks.engine import engine, stack, through_focus
from benchmarks.fresh import memory
from benchmarks.settings import Settings
from benchmarks.timing import Contender, Race, Spread, race
from benchmarks.truth import Question, Window, exact_stack, stack_error, truth

CASES = [(0.0, 0.0), (10.0, 3.0), (50.0, 0.0), (0.0, 50.0), (50.0, 50.0), (-50.0, 50.0)]
TOL = 1e-6


@dataclass(frozen=True)
class Measured:
    """What was found, in the worst of the cases of a row."""

    value: Spread
    error: float | None
    note: str


@dataclass(frozen=True)
class Target:
    """A row: the work, what it is measured against, how far it must and should come; `more`: more is better."""

    work: str
    against: str
    must: float | None
    aim: float | None
    unit: str
    more: bool
    measure: Callable[[Settings], Measured]
    tol: float = TOL

    def limit(self, value: float | None) -> str | None:
        """Write a limit."""
        return None if value is None else f"{'≥' if self.more else '≤'} {value:g}{self.unit}"

    @property
    def counted_in(self) -> str:
        """Return what a measured value counts."""
        return {"x": "times as fast", "": "times as long"}.get(self.unit, self.unit.strip())

    def verdict(self, value: float) -> str:
        """Return "aim", "must" or "MISSED"; "no target" where there is none."""
        if self.must is None or self.aim is None:
            return "no target"
        if value >= self.aim if self.more else value <= self.aim:
            return "aim"
        return "must" if (value >= self.must if self.more else value <= self.must) else "MISSED"


def worst(found: list[Measured], *, more: bool) -> Measured:
    """Return the least favourable case, with the largest error of all."""
    ranked = sorted(found, key=lambda m: m.value.median if more else -m.value.median)
    errors = [m.error for m in found if m.error is not None]
    note = ranked[0].note
    if len(found) > 1:
        note = f"worst of {len(found)} cases, {note}; the best came to {ranked[-1].value.median:.3g}"
    return Measured(ranked[0].value, max(errors, default=None), note)


def _questions(settings: Settings, *pixels: float) -> list[Question]:
    cases = [CASES[1], CASES[4]] if settings.quick else CASES
    return [Question(c, s, pixel=p) for c, s in cases for p in pixels]


def against_fft(settings: Settings) -> Measured:
    """Measure 512², against the FFT."""
    other, found = fft(), []
    for q in _questions(settings, *((0.5,) if settings.quick else (0.25, 0.5, 1.0))):
        mine = engine(q)
        result = race([mine, other], settings.rounds)
        error = truth(q).error(result.values[mine.name])
        found.append(Measured(result.ratio(other.name, mine.name), error, f"{q}: {mine.config}; {other.config}"))
    return worst(found, more=True)


def against_copy(settings: Settings) -> Measured:
    """Measure 512², against copying a float64 512²."""
    other, found = copy((512, 512), np.float64), []
    for q in _questions(settings, *((0.5,) if settings.quick else (0.25, 0.5, 1.0))):
        mine = engine(q)
        result = race([mine, other], settings.rounds)
        error = truth(q).error(result.values[mine.name])
        found.append(Measured(result.ratio(mine.name, other.name), error, f"{q}: {mine.config}; {other.config}"))
    return worst(found, more=False)


def fastest(result: Race, names: list[str]) -> str:
    """Return the fastest of some contenders."""
    return min(names, key=result.median)


def _against_plain(settings: Settings, *ways: str) -> Measured:
    """Measure 512², against the fastest of some ways of `Plain`."""
    found = []
    for q in _questions(settings, 0.5):
        mine, reference = engine(q), truth(q).values[None]
        others: dict[str, Contender] = {}
        for way in ways:
            nodes, radii = fewest(q.n, q.step, q.pupil(), reference, way=way)
            for product in ("gemm", "gemv"):
                one = Plain(q.n, q.step, nodes, radii, way=way, product=product)
                others[f"{way} {product}"] = plain(f"{way} {product}", one, q.fresh)
        result = race([mine, *others.values()], settings.rounds)
        other = others[fastest(result, list(others))]
        theirs = stack_error(result.values[other.name], reference)
        note = f"{q}: {mine.config}; {other.config}, whose error is {theirs:.1e}"
        error = truth(q).error(result.values[mine.name])
        found.append(Measured(result.ratio(other.name, mine.name), error, note))
    return worst(found, more=True)


def against_spline(settings: Settings) -> Measured:
    """Measure 512², against quadrature and a spline onto the grid."""
    return _against_plain(settings, "pixels")


def against_folded(settings: Settings) -> Measured:
    """Measure 512², against quadrature that also shares equal radii among pixels."""
    return _against_plain(settings, "spline", "sparse")


def large(settings: Settings, *, out: bool) -> Measured:
    """Compare 4096² with copying it, two threads."""
    found = []
    other = copy((4096, 4096), np.float32)
    for case in CASES[1:2] if settings.quick else CASES[1:5:3]:
        q = Question(*case, n=4096, pixel=0.25)
        mine = engine(q, threads=2, out=out)
        result = race([mine, other], settings.rounds)
        error = truth(q).error(result.values[mine.name])
        found.append(Measured(result.ratio(mine.name, other.name), error, f"{q}: {mine.config}; {other.config}"))
    return worst(found, more=False)


def _stack_error(fresh: Callable[[int], list[lm.Pupil]], result: Race, name: str, n: int, pixel: float) -> float:
    return stack_error(result.values[name], exact_stack(fresh(1)[0], n, pixel))


def stack_copy(settings: Settings, *, out: bool) -> Measured:
    """Compare 4096 of 33² with copying them."""
    fresh = through_focus(20.0, 4096)
    mine, other = stack(fresh, 33, 0.5, out=out), copy((4096, 33, 33), np.float64)
    result = race([mine, other], settings.rounds)
    note = f"abs(C_d) <= 20, pixel 0.5 λN: {mine.config}; {other.config}"
    return Measured(result.ratio(mine.name, other.name), _stack_error(fresh, result, mine.name, 33, 0.5), note)


def stack_gemm(settings: Settings) -> Measured:
    """Measure 1000 of 33² with two threads, against a matrix product."""
    fresh = through_focus(10.0, 1000)
    mine = stack(fresh, 33, 0.5, threads=2, out=True)
    step = Question().step
    others = []
    for write, threads in (("gather", 1), ("mirror", 1), ("gather", 2)):
        one = Plain(33, step, 30, way="direct", write=write, dtype=np.float64, count=1000)
        others.append(plain(f"{write}, {threads}", one, fresh, threads=threads))
    result = race([mine, *others], settings.rounds)
    best = fastest(result, [o.name for o in others])
    other = next(o for o in others if o.name == best)
    reference = exact_stack(fresh(1)[0], 33, 0.5)
    error, theirs = (stack_error(result.values[name], reference) for name in (mine.name, best))
    note = f"abs(C_d) <= 10, pixel 0.5 λN: {mine.config}; {other.config}, whose error is {theirs:.1e}"
    return Measured(result.ratio(best, mine.name), error, note)


def focus(settings: Settings, *, ways: tuple[str, ...]) -> Measured:
    """Measure 64 planes of 256² through focus, against the fastest of some ways of `Plain`."""
    fresh = through_focus(20.0, 64)
    mine = stack(fresh, 256, 0.5, dtype=np.float32, out=True)
    step = Question().step
    reference = exact_stack(fresh(1)[0], 256, 0.5)
    others = []
    for way in ways:
        nodes, radii = fewest(256, step, fresh(1)[0], reference, way=way)
        for write in ("gather", "mirror") if way != "pixels" else ("gather",):
            one = Plain(256, step, nodes, radii, way=way, write=write, count=64)
            others.append(plain(f"{way} {write}", one, fresh))
    result = race([mine, *others], settings.rounds)
    best = fastest(result, [o.name for o in others])
    other = next(o for o in others if o.name == best)
    error, theirs = (stack_error(result.values[name], reference) for name in (mine.name, best))
    note = f"abs(C_d) <= 20, pixel 0.5 λN: {mine.config}; {other.config}, whose error is {theirs:.1e}"
    return Measured(result.ratio(best, mine.name), error, note)


def over_abs(
    settings: Settings, mine: Contender, error: Callable[[NDArray[Any]], float] | None, note: str
) -> Measured:
    """Measure a call against the modulus of 33² complex numbers, which takes a few microseconds."""
    field = np.exp(1j * np.arange(33.0**2)).reshape(33, 33)
    other = Contender("abs", lambda _: np.abs(field))
    result = race([mine, other], settings.rounds)
    found = None if error is None else error(result.values[mine.name])
    note = f"{note}, {1e6 * result.median(mine.name):.2g} µs; np.abs, {1e6 * result.median(other.name):.2g} µs"
    return Measured(result.ratio(mine.name, other.name), found, note)


def by_plan(q: Window, *, pupils: bool = False) -> Contender:
    """One window of a new pupil by a plan; `pupils`: and making that, of 5 rad of defocus."""
    live, frame = lm.Plan(q.n, q.pixel, threads=1), np.zeros((q.n, q.n), np.float32)
    if pupils:
        return Contender(
            "plan", lambda _: live(lm.Pupil(lm.Wavefront(5.0)), out=frame), values=lambda a: a.values / a.scale
        )
    return Contender("plan", lambda pupil: live(pupil, out=frame), fresh=q.fresh, values=lambda a: a.values / a.scale)


def plan(settings: Settings, *, pupils: bool) -> Measured:
    """Measure one 33² by a plan; `pupils`: and making its pupil."""
    q = Question(5.0, n=33)
    note = "plan(pupil, out=frame), a new pupil each time"
    return over_abs(settings, by_plan(q, pupils=pupils), truth(q).error, note)


def pupil_of_lens(settings: Settings) -> Measured:
    """Measure the pupil of a lens for an object at a new distance."""
    lens = lm.Lens(focal_length=50e-3, f_number=2.0, wavelength=550e-9, focus_distance=2.0)
    mine = Contender(
        "pupil",
        lens.pupil,
        fresh=lambda count: [1.0 + 1e-7 * k for k in range(count)],
        values=lambda pupil: pupil.wavefront.edge,
    )
    return over_abs(settings, mine, None, "lens.pupil(distance) of a lens without aberrations")


def peak_memory(settings: Settings) -> Measured:
    """Measure MiB above the output, in fresh processes."""
    found = []
    for defocus, spherical in CASES[4:5] if settings.quick else CASES[1:5:3]:
        used = memory(512, defocus, spherical)
        if used is None:
            raise NotImplementedError("only Linux tells the peak of resident memory")
        peak = used["peak"]
        case = f"C_d = {defocus:g}, C_s = {spherical:g}"
        note = f"{case}: the first three calls of a process, out= given; {used['kept']:.1f} MiB kept afterwards"
        found.append(Measured(Spread(peak, peak, peak, 1), None, note))
    return worst(found, more=False)
