"""The table of targets: each row measured as it is worded, judged, and measured again if it fails."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import takewhile

import numpy as np

import lommel as lm
from benchmarks import camera, depth, localization, processes, wavefronts
from benchmarks.contenders import (
    Plain,
    by_plan,
    copy,
    engine,
    faster_ffts,
    fewest,
    fft,
    over_abs,
    plain,
    stack,
    through_focus,
)
from benchmarks.processes import memory
from benchmarks.report import Table
from benchmarks.timing import Contender, Measured, Race, Settings, Spread, race, worst
from benchmarks.truth import Question, exact_stack, stack_error, truth

CASES = [(0.0, 0.0), (10.0, 3.0), (50.0, 0.0), (0.0, 50.0), (50.0, 50.0), (-50.0, 50.0)]
TOL = 1e-6


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
        found.append(
            Measured(result.ratio(other.name, mine.name), error, f"{q}: {mine.config}. Against {other.config}")
        )
    return worst(found, more=True)


def against_copy(settings: Settings) -> Measured:
    """Measure 512², against copying a float64 512²."""
    other, found = copy((512, 512), np.float64), []
    for q in _questions(settings, *((0.5,) if settings.quick else (0.25, 0.5, 1.0))):
        mine = engine(q)
        result = race([mine, other], settings.rounds)
        error = truth(q).error(result.values[mine.name])
        found.append(
            Measured(result.ratio(mine.name, other.name), error, f"{q}: {mine.config}. Against {other.config}")
        )
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
        note = f"{q}: {mine.config}. Against {other.config}, whose error is {theirs:.1e}"
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
        found.append(
            Measured(result.ratio(mine.name, other.name), error, f"{q}: {mine.config}. Against {other.config}")
        )
    return worst(found, more=False)


def _stack_error(fresh: Callable[[int], list[lm.Pupil]], result: Race, name: str, n: int, pixel: float) -> float:
    return stack_error(result.values[name], exact_stack(fresh(1)[0], n, pixel))


def stack_copy(settings: Settings, *, out: bool) -> Measured:
    """Compare 4096 of 33² with copying them."""
    fresh = through_focus(20.0, 4096)
    mine, other = stack(fresh, 33, 0.5, out=out), copy((4096, 33, 33), np.float64)
    result = race([mine, other], settings.rounds)
    note = f"abs(C_d) <= 20, pixel 0.5 λN: {mine.config}. Against {other.config}"
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
    note = f"abs(C_d) <= 10, pixel 0.5 λN: {mine.config}. Against {other.config}, whose error is {theirs:.1e}"
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
    note = f"abs(C_d) <= 20, pixel 0.5 λN: {mine.config}. Against {other.config}, whose error is {theirs:.1e}"
    return Measured(result.ratio(best, mine.name), error, note)


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
        note = f"{case}: the first three calls of a process, out= given. Kept afterwards: {used['kept']:.1f} MiB"
        found.append(Measured(Spread(peak, peak, peak, 1), None, note))
    return worst(found, more=False)


_SAME = "np.copyto of the same array"

_PLAIN = "NumPy: quadrature, cached J0, "

# What must be reached holds for processors of 2017 (AVX2 in halves of 128 bits) and of 2024 alike: a row that
# another library is the measure of leaves room for what an FFT, a copy or a product gains more or less there.
TARGETS = [
    Target(
        "512², float32, tol 1e-6, abs(C_d), abs(C_s) ≤ 50",
        "scipy.fft of 1024² complex128",
        *(40, 120, "x", True),
        against_fft,
    ),
    Target("the same", "np.copyto of a float64 512²", 7, 2.5, "", False, against_copy),
    Target("the same", _PLAIN + "CubicSpline onto the grid", 20, 50, "x", True, against_spline),
    Target("the same", _PLAIN + "the distinct radii only, gathered", None, None, "x", True, against_folded),
    Target("4096², float32, 2 threads, into `out`", _SAME, 3, 1.5, "", False, partial(large, out=True)),
    Target("the same, its output allocated", _SAME, None, None, "", False, partial(large, out=False)),
    Target(
        "4096 of 33², float64, abs(C_d) ≤ 20, into `out`",
        "np.copyto of the stack",
        *(3, 2, "", False),
        partial(stack_copy, out=True),
    ),
    Target(
        "the same, its output allocated",
        "np.copyto of the stack",
        *(None, None, "", False),
        partial(stack_copy, out=False),
    ),
    Target(
        "1000 of 33², float64, abs(C_d) ≤ 10, 2 threads",
        "NumPy: GEMM, 30 nodes, 135 distinct radii, gathered",
        *(1, 4, "x", True),
        stack_gemm,
    ),
    Target(
        "64 planes of 256², float32, through focus",
        _PLAIN + "CubicSpline onto the grid",
        *(5, 15, "x", True),
        partial(focus, ways=("pixels",)),
    ),
    Target(
        "the same",
        _PLAIN + "the distinct radii only, gathered",
        *(None, None, "x", True),
        partial(focus, ways=("spline", "direct")),
    ),
    *(
        Target(
            f"512², float32, pixels of {pixel:g} λN averaged, into `out`",
            "the same window sampled",
            *(must, aim, "", False),
            partial(camera.over_samples, pixel=pixel),
        )
        for pixel, must, aim in ((0.25, 5, 2.5), (0.5, 10, 5), (1.0, 30, 18))
    ),
    *(
        Target(
            f"512², float32, coma, astigmatism, trefoil and defocus of 10 rad each, pixels of {pixel:g} λN averaged",
            "the same window sampled",
            *(must, 2, "", False),
            partial(camera.general_over_samples, pixel=pixel),
        )
        # Pixels of 1 λN take four samples each.
        for pixel, must in ((0.25, 4), (0.5, 4), (1.0, 7))
    ),
    Target(
        "1000 of 33², float32, pixels of 3.45 µm at f/1.8 averaged, into `out`",
        "the same stack sampled",
        *(8, 3, "", False),
        camera.stack_over_samples,
    ),
    *(
        Target(
            f"1000 of 25², float32, 0.5 λN, {'averaged' if integrate else 'sampled'}, each around an axis of its own",
            "the same stack around the middle pixel",
            *(18, 5, "", False),
            partial(camera.over_centred, pixel=0.5, integrate=integrate),
        )
        for integrate in (False, True)
    ),
    *(
        Target(
            f"1000 of 33², 15 Zernike terms of 1 rad rms {'each' if each else 'together'}, float32, tol 1e-4"
            + (", 2 threads" if threads == 2 else ""),
            "scipy.fft of 1000 × 128² complex128, one thread",
            *(5, 20, "x", True),
            partial(wavefronts.stacks_against_fft, each=each, threads=threads),
            wavefronts.TOL,
        )
        for each in (False, True)
        for threads in (1, 2)
    ),
    *(
        Target(
            f"the same of 1 rad rms each, tol {tol:g}, with 15 derivatives by coefficients, over 16",
            "the images alone",
            *(1.5, 1.1, "", False),
            partial(wavefronts.derivatives_over_images, tol=tol),
            tol,
        )
        for tol in (wavefronts.TOL, 1e-6)
    ),
    *(
        Target(
            f"the gradient of a weighted sum of these by {terms} coefficients, tol 1e-6",
            "the images alone, float64",
            *(4, 2.5, "", False),
            partial(wavefronts.gradient_over_images, terms=terms),
        )
        for terms in (15, 60)
    ),
    *(
        Target(
            f"512², float32, tol 1e-6, pixels of {pixel:g} λN, coma, astigmatism, trefoil and defocus of up to "
            "10 rad each, into `out`",
            "scipy.fft of 1024² complex128, one thread",
            *(3, aim, "x", True),
            partial(wavefronts.window_against_fft, pixels=(pixel,), threads=1),
        )
        for pixel, aim in ((0.25, 10), (0.5, 8), (1.0, 8))
    ),
    *(
        Target(
            f"the same, pixels of {pixel:g} λN, 10 rad",
            "ducc0's non-uniform FFT in single precision, one thread",
            *(must, aim, "x", True),
            partial(wavefronts.against_ducc0, pixel=pixel),
        )
        for pixel, must, aim in ((0.25, 1, 3), (0.5, 2, 4), (1.0, 4, 8))
    ),
    Target(
        "the same, all pixels, 2 threads",
        "scipy.fft of 1024² complex128, one thread",
        *(1.5, 5, "x", True),
        partial(wavefronts.window_against_fft, pixels=wavefronts.PIXELS, threads=2),
    ),
    Target(
        "the same of 30 rad each, pixels of 0.5 λN",
        "scipy.fft of 1024² complex128, one thread",
        *(None, None, "x", True),
        partial(wavefronts.window_against_fft, pixels=(0.5,), threads=1, reaches=(30.0,)),
    ),
    *(
        Target(
            f"the same 512², by `{name}`{how}",
            "scipy.fft of 1024² complex128, one thread",
            *(None, None, "x", True),
            partial(wavefronts.method_against_fft, name=name),
            math.inf,
        )
        for name, how in (
            ("NonuniformFFT", ""),
            ("MatrixFourier", " of 512 samples"),
            ("Fraunhofer", ", an FFT of 1024²"),
        )
    ),
    Target(
        "500 × 741 RGB blurred by depth, windows up to 33², tol 1e-4, 2 threads",
        "scipy.signal.oaconvolve with one fixed 33²",
        *(2, 1.5, "", False),
        partial(depth.against_fixed, bank=False),
        depth.TOL,
    ),
    Target(
        "the same, and making its windows",
        "scipy.signal.oaconvolve with one fixed 33²",
        *(None, None, "", False),
        partial(depth.against_fixed, bank=True),
        depth.TOL,
    ),
    Target(
        "the same, its windows made",
        "the PSF of every point by an FFT of 64², added",
        *(200, 400, "x", True),
        depth.against_points,
        depth.TOL,
    ),
    Target(
        "the same through focus, a frame of 30",
        "scipy.signal.oaconvolve with one fixed 33²",
        *(4, 2, "", False),
        depth.focus_pull,
    ),
    Target(
        "a photograph with occlusion at a new depth map, the worst of five scenes",
        "depth_of_field without occlusion",
        *(4, 2.5, "", False),
        depth.occluded_once,
    ),
    Target(
        "occlusion, forward again at one depth map, the worst of five scenes",
        "scipy.signal.oaconvolve with one fixed 33²",
        *(8, 4, "", False),
        depth.occluded,
    ),
    Target(
        "1000 images of a molecule, 15², with slopes by row, column and z, by a table of tol 1e-4",
        "np.abs of as many float32",
        *(60, 30, "", False),
        localization.image_over_abs,
        localization.TOL,
    ),
    *(
        Target(
            "1000 molecules of 1000 photons, 15², fitted with their starts",
            f"Picasso's cubic splines from {starts} start{'s' if starts > 1 else ''}, one thread",
            *(must, aim, "x", True),
            partial(localization.fit_over_splines, starts=starts),
        )
        for starts, must, aim in ((1, 2.5, 4), (5, 20, 30))
    ),
    *(
        Target(
            f"the gradient of 15² averages of an aberrated objective by {terms} Zernike terms, tol 1e-4",
            "the image",
            *(must, aim, "", False),
            partial(localization.gradient_over_image, terms=terms),
            localization.TOL,
        )
        for terms, must, aim in ((21, 3, 1.5), (231, 4, 2))
    ),
    Target("one 33² by a plan", "np.abs of a complex 33²", 4, 2.5, "", False, partial(plan, pupils=False)),
    Target(
        "the same, and making its pupil",
        "np.abs of a complex 33²",
        *(None, None, "", False),
        partial(plan, pupils=True),
    ),
    Target(
        "one 33² of coma, astigmatism, trefoil and defocus of up to 1 rad each by a plan",
        "np.abs of a complex 33²",
        *(40, 18, "", False),
        wavefronts.by_plan,
    ),
    Target("the pupil of a lens", "np.abs of a complex 33²", 3.5, 1.5, "", False, pupil_of_lens),
    Target("import lommel", "import numpy", 1.25, 1.15, "", False, processes.importing),
    Target("the first 512² of a process", "np.copyto to a new array there", None, None, "", False, processes.first),
    Target("512² between others that empty the caches", "np.copyto there", 3.5, 2, "", False, processes.between),
    Target("memory above the output, 512²", "nothing", 20, 8, " MiB", False, peak_memory),
]


def targets(settings: Settings) -> Table:
    """Measure and judge every row; one that fails gets a second chance, and both results are noted."""
    table = Table(
        "targets",
        "All rows",
        "Through the public Python call, warm, one thread unless the row says otherwise. The least favourable "
        "case of each row, with the largest true error of all its cases. "
        f"{_unit(settings)}",
        {
            "work": "text",
            "against": "text",
            "must": "text",
            "aim": "text",
            "measured": "spread",
            "unit": "text",
            "verdict": "text",
            "true error": "error",
        },
    )
    for number, target in enumerate(TARGETS, 1):
        settings.tick(f"{target.work} against {target.against}")
        try:
            found = target.measure(settings)
        except NotImplementedError as reason:
            table.add(*_words(target), None, target.counted_in, "skipped", None)
            table.notes.append(f"row {number}: {reason}")
            continue
        again = ""
        if target.verdict(found.value.median) == "MISSED":
            settings.tick(f"again: {target.work} against {target.against}")
            again = f". Second try, the first came to {found.value.median:.3g}"
            found = target.measure(settings)
        verdict = target.verdict(found.value.median)
        if found.error is not None and found.error > target.tol:
            verdict = "MISSED"
            again += f". The error exceeds {target.tol:g}"
        table.add(*_words(target), found.value, target.counted_in, verdict, found.error)
        table.notes.append(f"row {number}: {found.note}{again}")
    return table


def _unit(settings: Settings) -> str:
    """Say what the FFT that rows are measured against is worth beside the fastest one at hand."""
    known, others = fft(), faster_ffts()
    said = "SciPy's FFT is the unit because everybody has it; it is not the fastest"
    if not others:
        return f"{said}: ducc0's, not installed for this run, takes about half its time."
    result = race([known, *others], settings.rounds)
    ratios = " and ".join(f"{result.ratio(o.name, known.name).median:.2f} ({o.name})" for o in others)
    return f"{said}: in this run ducc0's took {ratios} of its time, and ratios to it are that much smaller."


def _words(target: Target) -> tuple[str | None, ...]:
    return target.work, target.against, target.limit(target.must), target.limit(target.aim)


def missed(table: Table) -> list[str]:
    """Return the rows that did not reach what they must, by what they say before that."""
    named = list(takewhile(lambda name: name != "must", table.columns))
    return [" against ".join(row[name] for name in named) for row in table.rows if row.get("verdict") == "MISSED"]
