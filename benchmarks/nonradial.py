"""One large window of a pupil that is not radially symmetric: the series, and other methods, against one FFT."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from importlib.util import find_spec

import lommel as lm
from benchmarks.baselines import fft
from benchmarks.engine import engine
from benchmarks.mixed import ALIGNED, RANDOM, Mixed, error
from benchmarks.peers_image import ducc0_single
from benchmarks.settings import Settings
from benchmarks.targets import Measured, over_abs, worst
from benchmarks.targets import by_plan as plan_of
from benchmarks.timing import Contender, race

PIXELS = (0.25, 0.5, 1.0)


def _cases(settings: Settings, *pixels: float) -> list[Mixed]:
    directions = (RANDOM[0],) if settings.quick else (ALIGNED, *RANDOM)
    return [Mixed(pixel=p, directions=d) for d in directions for p in pixels]


def against_fft(
    settings: Settings, *, pixels: tuple[float, ...], threads: int, reaches: tuple[float, ...] = (10.0, 3.0)
) -> Measured:
    """Measure 512², against the FFT."""
    other, found = fft(), []
    for q in (replace(q, reach=r) for r in reaches for q in _cases(settings, *pixels)):
        mine = engine(q, threads=threads, out=True)
        result = race([mine, other], settings.rounds)
        note = f"{q}: {mine.config}, {1e3 * result.median(mine.name):.2f} ms; {other.config}"
        found.append(Measured(result.ratio(other.name, mine.name), error(q, result.values[mine.name]), note))
    return worst(found, more=True)


def by_plan(settings: Settings) -> Measured:
    """Measure one 33² by a plan."""
    q = Mixed(n=33, reach=1.0)
    note = f"{q}: plan(pupil, out=frame), a new pupil each time"
    return over_abs(settings, plan_of(q), partial(error, q), note)


def against_ducc0(settings: Settings, *, pixel: float) -> Measured:
    """Measure 512², against the non-uniform FFT of DUCC in single precision."""
    for name in ("ducc0", "numba"):
        if find_spec(name) is None:
            raise NotImplementedError(f"{name} is not installed")
    found = []
    for q in _cases(settings, pixel):
        mine, theirs = engine(q, out=True), ducc0_single(q)
        other = Contender("ducc0", lambda _, call=theirs.call: call())  # type: ignore[misc]
        result = race([mine, other], settings.rounds)
        off = min(error(way, result.values[other.name], fit=True) for way in (q, q.turned()))
        note = f"{q}: {mine.config}; ducc0, {theirs.config}, whose error is {off:.1e}"
        found.append(Measured(result.ratio(other.name, mine.name), error(q, result.values[mine.name]), note))
    return worst(found, more=True)


def _method(name: str, pixel: float) -> lm.Method:
    if name == "NonuniformFFT":
        return lm.NonuniformFFT()
    if name == "MatrixFourier":
        return lm.MatrixFourier(samples=512)
    # Its FFT is one of 1024 squared, whatever the pitch.
    return lm.Fraunhofer(samples=round(1024 * pixel), padding=1.0 / pixel, edge="grey")


def method_against_fft(settings: Settings, *, name: str) -> Measured:
    """Measure 512² by another method, against the FFT."""
    other, found = fft(), []
    for q in _cases(settings, *PIXELS)[:6]:
        mine = engine(q, method=_method(name, q.pixel))
        result = race([mine, other], settings.rounds, budget=1.0)
        note = f"{q}: {mine.config}; {other.config}"
        found.append(Measured(result.ratio(other.name, mine.name), error(q, result.values[mine.name]), note))
    return worst(found, more=True)
