"""One large window of a pupil that is not radially symmetric: the series, and other methods, against one FFT."""

from __future__ import annotations

from importlib.util import find_spec

import lommel as lm
from benchmarks.baselines import fft
from benchmarks.engine import engine
from benchmarks.mixed import ALIGNED, RANDOM, Mixed, error
from benchmarks.settings import Settings
from benchmarks.targets import Measured, worst
from benchmarks.timing import race


def _cases(settings: Settings) -> list[Mixed]:
    if settings.quick:
        return [Mixed(directions=d) for d in (ALIGNED, RANDOM[0])]
    return [Mixed(pixel=p, directions=d) for d in (ALIGNED, *RANDOM) for p in (0.25, 0.5, 1.0)]


def against_fft(settings: Settings, *, threads: int) -> Measured:
    """Measure 512², against the FFT."""
    other, found = fft(), []
    mild = [] if settings.quick else [Mixed(pixel=p, reach=3.0, directions=RANDOM[0]) for p in (0.25, 0.5, 1.0)]
    for q in (*_cases(settings), *mild):
        mine = engine(q, threads=threads, out=True)
        result = race([mine, other], settings.rounds)
        note = f"{q}: {mine.config}, {1e3 * result.median(mine.name):.2f} ms; {other.config}"
        found.append(Measured(result.ratio(other.name, mine.name), error(q, result.values[mine.name]), note))
    return worst(found, more=True)


def _method(name: str, pixel: float) -> lm.Method:
    if name == "NonuniformFFT":
        if find_spec("finufft") is None:
            raise NotImplementedError("finufft is not installed")
        return lm.NonuniformFFT()
    if name == "MatrixFourier":
        return lm.MatrixFourier(samples=512)
    # Its FFT is one of 1024 squared, whatever the pitch.
    return lm.Fraunhofer(samples=round(1024 * pixel), padding=1.0 / pixel, edge="grey")


def method_against_fft(settings: Settings, *, name: str) -> Measured:
    """Measure 512² by another method, against the FFT."""
    other, found = fft(), []
    for q in _cases(settings)[:6]:
        mine = engine(q, method=_method(name, q.pixel))
        result = race([mine, other], settings.rounds, budget=1.0)
        note = f"{q}: {mine.config}; {other.config}"
        found.append(Measured(result.ratio(other.name, mine.name), error(q, result.values[mine.name]), note))
    return worst(found, more=True)
