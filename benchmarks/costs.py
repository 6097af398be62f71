"""Cost of a pixel against window, aberrations, terms, tolerance and pupils; and beside the limits of the machine."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import asdict
from functools import lru_cache
from typing import Any

import numpy as np

import lommel as lm
from benchmarks.baselines import copy
from benchmarks.chordal import exact, random_zernikes
from benchmarks.engine import engine, stack, through_focus
from benchmarks.mixed import RANDOM, Mixed
from benchmarks.report import Table
from benchmarks.settings import Settings
from benchmarks.timing import Contender, Spread, race
from benchmarks.truth import Question
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
        "Time for a value of an image by a plan, into an array that is there already, over that of `np.abs` for one "
        "number of 512² of complex64; one thread, pixels of 0.5 λN, tol 1e-6. General pupils have 15 random Zernike "
        "terms of 1 rad rms together unless said.",
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
        "How many times as long each work takes as the least that its limit allows: storing its values as fast as "
        "`np.copyto` writes an array of this size, or the multiply-adds of its two matrix products, as fast as "
        "`np.matmul` of 1024² float32. One thread, into an array that is there already.",
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
    sums = stack(random_zernikes(each=True), 33, 0.5, method=lm.ChordalGauss(1e-4), dtype=np.float32, out=True)
    result = race([sums, gemm], settings.rounds, budget=4.0, keep=False)
    # Of each pair of chords 17 rows of four sums, re and im, over pairs of nodes; of each row 17 columns of four.
    least = 1000 * (chords / 2) * (17 * (nodes / 2) * 8 + 33 * 17 * 4)
    spread = result.ratio(sums.name, gemm.name)
    why = f"arithmetic: phases and sines of the nodes; {chords} chords of {nodes} nodes are enough"
    row = table.add("1000 of 33², 15 Zernike terms of 1 rad rms each, tol 1e-4", "multiply-adds", None, why)
    row["over it"] = _times(spread, n**3 / least)
    return table
