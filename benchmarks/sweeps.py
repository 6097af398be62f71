"""Cost and error against aberrations, tolerance, accuracy asked of the FFT, stack and threads."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

import lommel as lm
from benchmarks.baselines import Plain, copy, fewest, fft, plain
from benchmarks.beside import general_by_threads
from benchmarks.engine import engine, stack, through_focus
from benchmarks.report import Table
from benchmarks.settings import Settings
from benchmarks.timing import Contender, race
from benchmarks.truth import Question, exact_stack, intensity, stack_error, truth


def _bound(question: Question, method: lm.Method) -> float | None:
    return lm.psf(question.pupil(), question.n, question.pixel, method=method).error_bound


def aberrations(settings: Settings) -> Table:
    """512² at the default tolerance, C_d and C_s up to 200."""
    table = Table(
        "aberrations",
        "Cost and error against the aberrations",
        "512², pixels of 0.5 λN, tol 1e-6, float32, one thread. The last columns are the errors of the whole FFT "
        "method at 1024² with 512 samples across the pupil, a sample counting whole or by the part of its cell that "
        "is clear; it aliases where light from outside the FFT's window would fall into it.",
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
                method = lm.Fraunhofer(samples=512, padding=1.0, edge=edge)
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
            _bound(q, lm.NijboerZernike()),
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
        method = lm.NijboerZernike(10.0**exponent)
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
        f"it (the whole method, 1024² to {largest}², binary and grey edge; at this pitch more padding changes "
        "nothing, more samples across the pupil do), against lommel with that tolerance.",
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
                method = lm.Fraunhofer(samples=side // 2, padding=1.0, edge=edge)
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
            mine = engine(q, method=lm.NijboerZernike(10.0**exponent))
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
            method = lm.Fraunhofer(samples=side // 2, padding=1.0, edge="grey")
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
        "near or far from each other: where they answered each other within 90 ns, a general 512² gained 1.6 and "
        "occlusion 1.5, where it took them 400 ns, 1.2 and 0.75.",
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
        "tabulated beforehand (which is not counted), with about the fewest nodes and radii for an error of 1e-6, "
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
