"""What a change of the question costs: the axis, the number of pupils, terms, pixels, tolerance, size and threads."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np

import lommel as lm
from benchmarks.chordal import random_zernikes
from benchmarks.report import Table
from benchmarks.settings import Settings
from benchmarks.timing import Contender, Spread, race

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
