"""Cost and error against window, aberrations, terms, tolerance, pupils, threads; beside the machine's limits."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import asdict, replace
from functools import cache, lru_cache
from typing import Any

import numpy as np

import lommel as lm
from benchmarks.contenders import Plain, copy, engine, fewest, fft, plain, stack, through_focus
from benchmarks.report import Table
from benchmarks.timing import Contender, Settings, Spread, race
from benchmarks.truth import RANDOM, Mixed, Question, exact_stack, intensity, stack_error, truth
from benchmarks.wavefronts import exact, random_zernikes
from lommel.core.engine import Window, chordal_sums
from lommel.methods.chordal_gauss import disk_stack

_MOST = 1.5  # seconds that a call may take


def _pupils(count: int, terms: int, rms: float) -> lm.Pupil:
    c = np.random.default_rng(terms).normal(size=(count, terms))
    c *= rms / np.linalg.norm(c, axis=1, keepdims=True)
    return lm.Pupil(lm.Wavefront.zernike(dict(enumerate(c.squeeze().T if count == 1 else c.T, 4)), order="noll"))


def _contender(pupil: lm.Pupil, side: int, tol: float = 1e-6, threads: int = 1) -> Contender:
    plan = lm.Plan(side, 0.5, tol=tol, threads=threads)
    out = np.full((*pupil.shape, side, side), 0.0, np.float32 if tol >= 1e-6 else np.float64)  # its pages are there
    return Contender(f"{side}², tol {tol:g}, {threads}", lambda _: plan(pupil, out=out))


def _questions(*, quick: bool) -> Iterator[tuple[str, str, list[tuple[float, Callable[[], tuple[Contender, int]]]]]]:
    """Return panels, curves, and of each their places with what makes a contender and its number of values."""

    def many(places: list[float]) -> list[float]:
        return places[::3] if quick else places

    def asked(count: int, side: int, pupil: Callable[[], lm.Pupil], tol: float = 1e-6) -> Any:
        return lambda: (_contender(pupil(), side, tol), count * side * side)

    radial = lm.Pupil(lm.Wavefront(defocus=10.0, spherical=3.0))
    sides = many([16, 24, 33, 48, 64, 96, 128, 256, 512, 1024, 2048, 4096])
    phases = many([0.1, 0.3, 1, 3, 10, 30, 100, 300])
    counts = many([1, 2, 3, 4, 8, 9, 16, 32, 100, 1000, 10_000, 100_000, 1_000_000])
    yield "side of the window, pixels", "radial", [(n, asked(1, int(n), lambda: radial)) for n in sides]
    yield (
        "side of the window, pixels",
        "15 terms",
        [(n, asked(1, int(n), lambda: _pupils(1, 15, 1.0))) for n in sides],
    )
    focus = [(c, asked(1, 512, lambda c=c: lm.Pupil(lm.Wavefront(defocus=c)))) for c in phases]
    yield "aberration, rad rms (radial: defocus at the edge)", "radial", focus
    rms = [(c, asked(1, 512, lambda c=c: _pupils(1, 15, c))) for c in phases]
    yield "aberration, rad rms (radial: defocus at the edge)", "15 terms", rms
    terms = [
        (n, asked(1, 33, lambda n=n: _pupils(1, int(n), 1.0))) for n in many([3, 6, 15, 36, 66, 120, 200, 300, 400])
    ]
    yield "Zernike terms, 1 rad rms together, 33²", "one pupil", terms
    terms = [(n, asked(16, 33, lambda n=n: _pupils(16, int(n), 1.0))) for n in many([3, 6, 15, 36, 66, 120, 200])]
    yield "Zernike terms, 1 rad rms together, 33²", "16 pupils", terms
    tolerances = many([10.0**-k for k in range(2, 11)])
    yield "tolerance, 512²", "radial", [(tol, asked(1, 512, lambda: radial, tol)) for tol in tolerances]
    yield (
        "tolerance, 512²",
        "15 terms",
        [(tol, asked(1, 512, lambda: _pupils(1, 15, 1.0), tol)) for tol in tolerances],
    )

    def focused(n: int) -> lm.Pupil:
        return lm.Pupil(lm.Wavefront(defocus=np.linspace(-10.0, 10.0, n) if n > 1 else 10.0))

    yield "pupils of 17²", "radial", [(n, asked(int(n), 17, lambda n=n: focused(int(n)))) for n in counts]
    yield "pupils of 17²", "15 terms", [(n, asked(int(n), 17, lambda n=n: _pupils(int(n), 15, 1.0))) for n in counts]


def _times(spread: Spread, by: float) -> dict[str, float]:
    return asdict(Spread(by * spread.median, by * spread.low, by * spread.high, spread.rounds))


def costs(settings: Settings) -> Table:
    """Cost of a value of an image, over the modulus of one complex number, and plots of it."""
    table = Table(
        "costs",
        "Cost of a pixel",
        "Time for a value of an image by a plan, over that of `np.abs` for one number of 512² of complex64. One "
        "thread, pixels of 0.5 λN, tol 1e-6, into an array that is there already. General pupils have 15 random "
        "Zernike terms of 1 rad rms together unless said.",
        {"against": "text", "pupil": "text", "at": "text", "cost": "spread"},
    )
    numbers = np.ones((512, 512), np.complex64)
    unit = Contender("np.abs", lambda _: np.abs(numbers))
    for panel, curve, places in _questions(quick=settings.quick):
        for at, make in places:
            settings.tick(f"{panel}, {curve}: {at:g}")
            try:
                one, values = make()
                result = race([one, unit], settings.rounds, budget=_MOST, keep=False)
            except (ValueError, MemoryError):  # refused: the curve ends
                break
            spread = result.ratio(one.name, unit.name)
            by = numbers.size / values
            row = table.add(panel, curve, f"{at:g}", None)
            row["cost"] = {key: getattr(spread, key) * by for key in ("median", "low", "high")} | {
                "rounds": spread.rounds
            }
            if result.median(one.name) > _MOST:
                break
    return table


@lru_cache(maxsize=1)
def _fewest() -> tuple[int, int]:
    """Return the fewest chords and nodes by which 16 images of 15 terms are within 1e-4 of the peak."""
    pupils = random_zernikes(each=True)(1)[0][:16]
    judged = exact(pupils)
    window = Window((33, 33), (16.0, 16.0), np.pi * 0.5)
    best = (64, 64)
    for chords in range(16, 64, 2):
        for nodes in range(16, 64, 2):
            if chords * nodes < best[0] * best[1]:
                found = chordal_sums(disk_stack(pupils), window, (chords, nodes)).swapaxes(-1, -2)
                error = np.abs(found - judged).max(axis=(-1, -2)) / judged.max(axis=(-1, -2))
                best = (chords, nodes) if error.max() <= 1e-4 else best
    return best


def physical(settings: Settings) -> Table:
    """Compare main rows with storing their values at the speed of memory, or with their multiply-adds at peak."""
    table = Table(
        "physical",
        "Beside the limits of the machine",
        "How many times as long each work takes as the least that its limit allows. The limit of memory: storing "
        "its values as fast as `np.copyto` writes an array of this size. That of arithmetic: the multiply-adds of "
        "its two matrix products, as fast as `np.matmul` of 1024² float32. One thread, into an array that is there "
        "already.",
        {"work": "text", "limit": "text", "over it": "spread", "what bounds it": "text"},
    )
    n = 1024
    square = np.ones((n, n), np.float32)
    product = np.empty_like(square)
    gemm = Contender("matmul", lambda _: np.matmul(square, square, out=product))
    single, double = np.float32, np.float64
    radial, large, general = Question(10.0, 3.0), Question(10.0, 3.0, n=4096, pixel=0.25), Mixed(directions=RANDOM[0])
    planes = stack(through_focus(20.0, 4096), 33, 0.5, out=True)
    eighth, circles = "memory: of eight pixels one is computed", "arithmetic: interpolation on circles"
    works = [
        ("512², radially symmetric", engine(radial, out=True), (512, 512), single, eighth),
        ("4096², radially symmetric", engine(large, out=True), (4096, 4096), single, eighth),
        ("4096 of 33², through focus, float64", planes, (4096, 33, 33), double, eighth),
        ("512², coma, astigmatism and trefoil of 10 rad", engine(general, out=True), (512, 512), single, circles),
    ]
    for title, one, shape, kind, why in works:
        settings.tick(title)
        memory = copy(shape, kind)
        result = race([one, memory], settings.rounds, budget=4.0, keep=False)
        table.add(title, "storing", result.ratio(one.name, memory.name), why)
    chords, nodes = _fewest()
    sums = stack(
        random_zernikes(each=True), 33, 0.5, method=lm.methods.ChordalGauss(1e-4), dtype=np.float32, out=True
    )
    result = race([sums, gemm], settings.rounds, budget=4.0, keep=False)
    # Of each pair of chords 17 rows of four sums, re and im, over pairs of nodes; of each row 17 columns of four.
    least = 1000 * (chords / 2) * (17 * (nodes / 2) * 8 + 33 * 17 * 4)
    spread = result.ratio(sums.name, gemm.name)
    why = f"arithmetic: phases and sines of the nodes; {chords} chords of {nodes} nodes are enough"
    row = table.add("1000 of 33², 15 Zernike terms of 1 rad rms each, tol 1e-4", "multiply-adds", None, why)
    row["over it"] = _times(spread, n**3 / least)
    return table


_MIDDLE = "the axis on a pixel"
_ONE_OF_MANY = "one of sixteen in a batch"


def changes(settings: Settings) -> Table:
    """Time pairs of questions that differ in one thing."""
    table = Table(
        "changes",
        "What a change of the question costs",
        "Two questions that differ in one thing, in turn: by a `Plan` of the same pupil again, into an array that is "
        "there already; of several pupils for each, of pixels each. One thread, tol 1e-6 and float32 unless the row "
        "says otherwise. General 33² have 15 Zernike terms of 1 rad rms each and tol 1e-4; general 512² coma, "
        "astigmatism, trefoil and defocus of 10 rad each.",
        {"what": "text", "over": "text", "ratio": "spread"},
    )
    for what, over, (mine, count), (other, counts) in _pairs(quick=settings.quick):
        settings.tick(what)
        found = race(
            [replace(mine, name="mine"), replace(other, name="other")], settings.rounds, budget=3.0, keep=False
        ).ratio("mine", "other")
        share = counts / count
        table.add(what, over, Spread(found.median * share, found.low * share, found.high * share, found.rounds))
    return table


def _pairs(*, quick: bool) -> Iterator[tuple[str, str, tuple[Contender, float], tuple[Contender, float]]]:
    """Return what is measured, over what, and of both the contender and its number of pupils or pixels."""
    radial, general, many = lm.Pupil(lm.Wavefront(10.0, 3.0)), _general(), random_zernikes(each=True)(1)[0]
    for n, places in (
        (33, {"anywhere": (16.3, 15.8), "between pixels": (15.5, 15.5)}),
        (512, {"anywhere": (256.1, 256.3)}),
    ):
        for where, center in places.items():
            yield (
                f"{n}², radial, sampled, the axis {where}",
                _MIDDLE,
                (_asked(radial, n, center=center), 1),
                (_asked(radial, n), 1),
            )
    averaged = (_asked(radial, 33, integrate=True, center=(16.3, 15.8)), 1)
    yield "33², radial, averaged, the axis anywhere", _MIDDLE, averaged, (_asked(radial, 33, integrate=True), 1)
    for count, name in ((1, "one"), (4, "one of four")):
        yield f"33², general, {name}", _ONE_OF_MANY, (_small(many, count), count), (_small(many, 16), 16)
    for terms in (120, 400):
        yield f"33², {terms} terms of 1 rad rms together", "15 such terms", (_terms(terms), 1), (_terms(15), 1)
    yield (
        "512², general, pixels of 0.01 λN",
        "pixels of 0.5 λN",
        (_asked(general, 512, 0.01), 1),
        (_asked(general, 512), 1),
    )
    yield "512², general, tol 1e-2", "tol 1e-6", (_asked(general, 512, tol=1e-2), 1), (_asked(general, 512), 1)
    if not quick:
        sizes = [(_asked(radial, n), float(n * n)) for n in (8192, 4096)]
        yield "8192², radial, a pixel", "of 4096²", sizes[0], sizes[1]


def general_by_threads() -> list[tuple[str, Callable[[int], Contender]]]:
    """Return works on general pupils, each by so many threads."""
    many, out = random_zernikes(each=True)(1)[0], np.zeros((1000, 33, 33), np.float32)
    return [
        ("512², general, float32", lambda k: _asked(_general(), 512, threads=k)),
        (
            "1000 of 33², general, float32, tol 1e-4",
            lambda k: _called(lm.Plan(33, 0.5, tol=1e-4, threads=k), many, out),
        ),
    ]


def _general() -> lm.Pupil:
    return lm.Pupil(lm.Wavefront(10.0, nonradial={(3, 1): 10.0, (2, 2): 10.0, (3, 3): 10.0}))


def _terms(count: int) -> Contender:
    c = np.random.default_rng(count).normal(size=count)
    c /= np.linalg.norm(c)
    wavefront = lm.Wavefront.zernike({j: float(each) for j, each in enumerate(c, 2)}, order="noll")
    return _asked(lm.Pupil(wavefront), 33, tol=1e-4)


def _small(many: lm.Pupil, count: int) -> Contender:
    """Return a contender for the first pupils of a stack; one alone is no stack."""
    out = np.zeros((33, 33) if count == 1 else (count, 33, 33), np.float32)
    return _called(lm.Plan(33, 0.5, tol=1e-4, threads=1), many[0] if count == 1 else many[:count], out)


def _asked(pupil: lm.Pupil, n: int, pixel: float = 0.5, threads: int = 1, **options: Any) -> Contender:
    return _called(lm.Plan(n, pixel, threads=threads, **options), pupil, _room(n))


@cache
def _room(n: int) -> Any:
    return np.zeros((n, n), np.float32)  # of all contenders of this size: they take turns


def _called(plan: lm.Plan, pupil: lm.Pupil, out: Any) -> Contender:
    return Contender("", lambda _: plan(pupil, out=out))


def _bound(question: Question, method: lm.methods.Method) -> float | None:
    return lm.psf(question.pupil(), question.n, question.pixel, method=method).error_bound


def aberrations(settings: Settings) -> Table:
    """512² at the default tolerance, C_d and C_s up to 200."""
    table = Table(
        "aberrations",
        "Cost and error against the aberrations",
        "512², pixels of 0.5 λN, tol 1e-6, float32, one thread. The last columns are the errors of the whole FFT "
        "method at 1024² with 512 samples across the pupil, a sample counting whole or by the part of its cell that "
        "is clear. It aliases where light from outside the FFT's window would fall into it.",
        {
            "C_d": "text",
            "C_s": "text",
            "FFT alone over lommel": "spread",
            "lommel over np.copyto": "spread",
            "true error": "error",
            "bound": "error",
            "FFT error": "text",
            "FFT error, grey edge": "text",
        },
    )
    cases = [(0, 0), (3, 0), (10, 0), (10, 3), (0, 20), (30, 0), (50, 50), (0, 100), (100, 0), (200, 0)]
    cases += [(-200, 200), (200, 200)]
    other, memory = fft(), copy((512, 512), np.float64)
    for c_d, c_s in cases[2::4] if settings.quick else cases:
        q = Question(float(c_d), float(c_s))
        settings.tick(str(q))
        mine = engine(q)
        result = race([mine, other, memory], settings.rounds)
        judged = truth(q)
        errors = []
        for edge in ("binary", "grey"):
            try:
                method = lm.paper.Fraunhofer(samples=512, padding=1.0, edge=edge)
                error = judged.error(intensity(lm.psf(q.pupil(), q.n, q.pixel, method=method)))
                errors.append(f"{error:.1e}")
            except ValueError:
                errors.append("aliases")
        table.add(
            f"{c_d}",
            f"{c_s}",
            result.ratio(other.name, mine.name),
            result.ratio(mine.name, memory.name),
            judged.error(result.values[mine.name]),
            _bound(q, lm.methods.NijboerZernike()),
            *errors,
        )
    return table


def tolerances(settings: Settings) -> Table:
    """512² at tolerances from 1e-3 to 1e-9."""
    q = Question(50.0, 20.0)
    table = Table(
        "tolerances",
        "Cost and error against the tolerance",
        f"512², {q}, one thread; float64 where the tolerance asks for it.",
        {
            "tol": "text",
            "values": "text",
            "FFT alone over lommel": "spread",
            "over tol 1e-6": "spread",
            "true error": "error",
            "bound": "error",
        },
    )
    other, usual = fft(), engine(q, name="tol 1e-6")
    for exponent in (-3, -6, -9) if settings.quick else range(-3, -10, -1):
        method = lm.methods.NijboerZernike(10.0**exponent)
        settings.tick(f"tol 1e{exponent}")
        mine = engine(q, method=method)
        result = race([mine, usual, other], settings.rounds)
        table.add(
            f"1e{exponent}",
            "float32" if exponent >= -6 else "float64",
            result.ratio(other.name, mine.name),
            result.ratio(mine.name, usual.name),
            truth(q).error(result.values[mine.name]),
            _bound(q, method),
        )
    return table


def accuracy(settings: Settings) -> Table:
    """Find the smallest FFT that is as exact as asked, where there is one up to 8192²."""
    largest = 2048 if settings.quick else 8192
    table = Table(
        "accuracy",
        "The smallest FFT of equal accuracy",
        "512², pixels of 0.5 λN, one thread. For each error asked, the smallest of the FFTs tried that stays below "
        f"it, against lommel with that tolerance. Tried is the whole method, 1024² to {largest}², binary and grey "
        "edge. At this pitch more padding changes nothing, more samples across the pupil do.",
        {
            "pupil": "text",
            "error asked": "text",
            "smallest FFT": "text",
            "its error": "error",
            "over lommel": "spread",
        },
    )
    pupils = [Question(10.0)] if settings.quick else [Question(), Question(10.0), Question(50.0)]
    for q in pupils:
        found: dict[str, tuple[Contender, float]] = {}
        for side in (1024, 2048, 4096, 8192):
            for edge in ("binary", "grey"):
                # The largest takes seconds and gigabytes: one pupil will do, in its better form.
                if side > largest or (side == 8192 and (edge == "binary" or q.defocus != 10.0)):
                    continue
                settings.tick(f"{q}: FFT {side}², {edge} edge")
                method = lm.paper.Fraunhofer(samples=side // 2, padding=1.0, edge=edge)
                one = engine(q, name=f"{side}², {edge} edge", method=method)
                answer = one.call(q.pupil())
                found[one.name] = one, truth(q).error(intensity(answer))
        best = min(found, key=lambda name: found[name][1])
        for exponent in range(-2, -7, -1):
            reaching = [name for name, (_, error) in found.items() if error <= 10.0**exponent]
            if not reaching:
                table.add(
                    f"C_d = {q.defocus:g}",
                    f"1e{exponent}",
                    f"none; the best, {best}, comes to",
                    found[best][1],
                    None,
                )
                break
            one, error = found[reaching[0]]
            mine = engine(q, method=lm.methods.NijboerZernike(10.0**exponent))
            settings.tick(f"{q}: 1e{exponent}")
            result = race([mine, one], settings.rounds, budget=2.0, keep=False)
            table.add(f"C_d = {q.defocus:g}", f"1e{exponent}", one.name, error, result.ratio(one.name, mine.name))
    return table


def stacks(settings: Settings) -> Table:
    """4096 PSFs of 33², beside memory, a matrix product and FFTs."""
    table = Table(
        "stacks",
        "Stacks of 4096 PSFs of 33²",
        "Pixels of 0.5 λN, float64, one thread, into an array that is there already. The FFTs, the whole method with "
        "a grey edge, are timed on 32 of the PSFs and compared for each PSF.",
        {"stack": "text", "way": "text", "over lommel": "spread", "true error": "error"},
    )
    kinds = [
        ("abs(C_d) ≤ 20", 20.0, 0.0),
        ("abs(C_d) ≤ 200", 200.0, 0.0),
        ("abs(C_d) ≤ 200, C_s = 200", 200.0, 200.0),
    ]
    few = 32
    for title, reach, spherical in kinds[:1] if settings.quick else kinds:
        fresh, some = through_focus(reach, 4096, spherical), through_focus(reach, few, spherical)
        settings.tick(title)
        reference = exact_stack(some(1)[0], 33, 0.5)
        step = Question().step
        nodes, _ = fewest(33, step, some(1)[0], reference, way="direct", dtype=np.float64, tol=5e-7)
        mine = stack(fresh, 33, 0.5, out=True)
        gemm = Plain(33, step, nodes, way="direct", dtype=np.float64, count=4096, write="gather")
        others = [copy((4096, 33, 33), np.float64), plain(f"NumPy: {gemm}", gemm, fresh)]
        result = race([mine, *others], settings.rounds, budget=5.0)
        exact = exact_stack(fresh(1)[0], 33, 0.5)
        table.add(title, mine.name, None, stack_error(result.values[mine.name], exact))
        table.add(title, "np.copyto of the stack", result.ratio("np.copyto", mine.name), None)
        name = others[1].name
        table.add(title, name, result.ratio(name, mine.name), stack_error(result.values[name], exact))
        for side in (128, 256, 512):
            method = lm.paper.Fraunhofer(samples=side // 2, padding=1.0, edge="grey")
            one = stack(some, 33, 0.5, name=f"FFT of {side}²", method=method)
            try:
                result = race([mine, one], settings.rounds, budget=2.0)
            except ValueError:
                table.add(title, f"{one.name}: aliases", None, None)
                continue
            result.seconds[one.name] *= 4096 / few
            got = stack_error(result.values[one.name], reference)
            table.add(title, one.name, result.ratio(one.name, mine.name), got)
    return table


def threads(settings: Settings) -> Table:
    """One thread and two."""
    table = Table(
        "threads",
        "Two threads",
        "How many times as fast `threads=2` is as `threads=1`, into an array that is there already. On a machine "
        "with other things to do this says more about the machine, and the two processors of a virtual one may be "
        "near or far from each other. Where they answered each other within 90 ns, a general 512² gained 1.6 and "
        "occlusion 1.5. Where it took them 400 ns, 1.2 and 0.75.",
        {"work": "text", "speed": "spread"},
    )
    works: list[tuple[str, list[Contender]]] = []
    for n in (512, 2048) if settings.quick else (512, 1024, 2048, 4096):
        q = Question(10.0, 3.0, n=n, pixel=0.25)
        works.append((f"{n}², float32", [engine(q, name=f"{k}", threads=k, out=True) for k in (1, 2)]))
    for count, n, reach, dtype in ((4096, 33, 20.0, np.float64), (64, 256, 20.0, np.float32)):
        fresh = through_focus(reach, count)
        pair = [stack(fresh, n, 0.5, name=f"{k}", threads=k, out=True, dtype=dtype) for k in (1, 2)]
        works.append((f"{count} of {n}², {np.dtype(dtype)}", pair))
    works += [(work, [replace(by(k), name=f"{k}") for k in (1, 2)]) for work, by in general_by_threads()]
    for work, pair in works:
        settings.tick(work)
        result = race(pair, settings.rounds, budget=3.0, keep=False)
        table.add(work, result.ratio("1", "2"))
    return table


def numpy(settings: Settings) -> Table:
    """Every form of the plain answer that was tried."""
    table = Table(
        "numpy",
        "Plain NumPy and SciPy",
        "512², pixels of 0.5 λN, float32, one thread: Gauss-Legendre in rho² with the J0 of all nodes and radii "
        "tabulated beforehand (which is not counted). Nodes and radii are about the fewest for an error of 1e-6, "
        "found by trying for each pupil.",
        {"pupil": "text", "way": "text", "over lommel": "spread", "true error": "error"},
    )
    for case in [(10.0, 3.0)] if settings.quick else [(10.0, 3.0), (50.0, 50.0)]:
        q = Question(*case)
        settings.tick(str(q))
        judged, mine = truth(q), engine(q)
        ways = []
        for way in ("pixels", "spline", "sparse", "direct"):
            nodes, radii = fewest(q.n, q.step, q.pupil(), judged.values[None], way=way)
            for product in ("gemm", "gemv"):
                one = Plain(q.n, q.step, nodes, radii, way=way, product=product)
                ways.append(plain(str(one), one, q.fresh))
        result = race([mine, *ways], settings.rounds, budget=4.0)
        for other in ways:
            error = judged.error(result.values[other.name][0])
            pupil = f"C_d = {q.defocus:g}, C_s = {q.spherical:g}"
            table.add(pupil, other.config, result.ratio(other.name, mine.name), error)
    return table
