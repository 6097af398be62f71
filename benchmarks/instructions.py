"""What is lost on processors whose vectors are narrower: the same build, limited to fewer instructions."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np

import lommel as lm
from benchmarks.chordal import SIDE, random_zernikes
from benchmarks.depth import photograph
from benchmarks.engine import engine, stack, through_focus
from benchmarks.microscopes import planes
from benchmarks.mixed import RANDOM, Mixed
from benchmarks.report import Table
from benchmarks.settings import Settings
from benchmarks.timing import Contender, race
from benchmarks.truth import Question
from lommel import _core

_LEVELS = ("avx512", "avx2", "portable")


@contextmanager
def _limited(level: str) -> Iterator[None]:
    _core.limit_instructions(level)
    try:
        yield
    finally:
        _core.limit_instructions(_LEVELS[0])


def _works() -> list[tuple[str, Contender]]:
    radial, general = Question(10.0, 3.0), Mixed(directions=RANDOM[0])
    chords = stack(random_zernikes(each=True), SIDE, 0.5, method=lm.ChordalGauss(1e-4), dtype=np.float32, out=True)
    spider = lm.Pupil(lm.Wavefront(3.0), obscuration=0.3, spider=lm.Spider.equal(4, 0.02))
    vanes = Contender("vanes", lambda _: lm.psf(spider, 128, 0.5, threads=1))
    frequencies = np.linspace(0.0, 1.0, 100)
    transfer = Contender("otf", lambda _: lm.otf(general.pupil(), frequencies))
    return [
        ("512², radially symmetric", engine(radial, out=True)),
        ("512², its pixels averaged", engine(radial, out=True, integrate=True)),
        ("1000 of 33², through focus, float64", stack(through_focus(10.0, 1000), 33, 0.5, out=True)),
        ("512², coma, astigmatism, trefoil and defocus of 10 rad each", engine(general, out=True)),
        ("1000 of 33², 15 Zernike terms of 1 rad rms each, tol 1e-4", chords),
        ("128², four vanes", vanes),
        ("transfer function of 10 rad each at 100 frequencies", transfer),
        ("64 planes of 64² of an immersion objective", planes()),
        ("500 × 741 RGB blurred by depth, 2 threads", photograph()),
    ]


def limited(settings: Settings) -> Table:
    """How many times as long each work takes with narrower vectors as with the widest."""
    table = Table(
        "instructions",
        "Instruction sets",
        "How many times as long the same build takes when it is limited to AVX2 with FMA, or to what every x86-64 "
        "processor has (SSE2), as with the widest vectors of this one. Pixels of 0.5 λN, tol 1e-6 and float32 unless "
        "the row says otherwise, one thread, into an array that is there already.",
        {"work": "text", "AVX2": "spread", "SSE2": "spread"},
    )
    table.notes.append(f"the widest here: {_core.instructions()}")
    for work, one in _works():
        settings.tick(work)

        def at(level: str, call: Callable[[Any], Any] = one.call) -> Callable[[Any], Any]:
            def limited_call(argument: Any) -> Any:
                with _limited(level):
                    return call(argument)

            return limited_call

        result = race(
            [replace(one, name=level, call=at(level)) for level in _LEVELS], settings.rounds, budget=3.0, keep=False
        )
        table.add(work, *(result.ratio(level, _LEVELS[0]) for level in _LEVELS[1:]))
    return table
