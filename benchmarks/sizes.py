"""Cost against the side of the window, for each way to compute a PSF: the paper's Fig. 1, measured."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass, replace
from typing import Any

import lommel as lm
from benchmarks.baselines import fft
from benchmarks.report import Table
from benchmarks.settings import Settings
from benchmarks.timing import Contender, race
from benchmarks.truth import Question, intensity, truth

SIDES = [33, 65, 129, 257, 512, 1024, 2048, 4096]
PIXEL = 0.5
_SECONDS = 4.0  # no call is made that the last one suggests to take longer


@dataclass(frozen=True)
class Way:
    """One curve: a method, and how its cost is expected to grow at most when the side doubles."""

    name: str
    method: lm.Method | None
    growth: float


def _ways(n: int) -> list[Way]:
    return [
        Way("lommel", None, 4.0),
        Way("quadrature", lm.Hankel(), 8.0),
        Way("closed form, Abramowitz 30", lm.ClosedForm(erf=lm.AbramowitzErf(30)), 4.0),
        Way("closed form, Fresnel", lm.ClosedForm(), 4.0),
        Way("FFT, whole method", lm.Fraunhofer(samples=max(n, 64), padding=1.0), 4.5),
        Way("ray tracing", lm.HuygensFresnel(symmetry=False), 16.0),
    ]


def lens() -> tuple[lm.Pupil, float]:
    """Return a lens out of focus by C_d = 10, for the methods that need distances, and the pixel pitch in metres."""
    ideal = lm.Lens(focal_length=50e-3, f_number=8.0, wavelength=550e-9)
    # C_d is proportional to 1/s for a lens focused at infinity.
    pupil = ideal.pupil(float(ideal.defocus(1.0)) / 10.0)
    return pupil, PIXEL * pupil.scale


def free_memory() -> float:
    """Return the bytes that are available, or infinity where that is not known."""
    try:
        return float(os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE"))
    except (AttributeError, ValueError, OSError):
        return math.inf


def _contender(way: Way, n: int) -> Contender:
    pupil, pixel = lens()
    method = way.method
    options: dict[str, Any] = {} if method is None else {"method": method}

    def call(_: Any) -> lm.PSF:
        return lm.psf(pupil, n, pixel, threads=1, **options)

    return Contender(way.name, call, values=intensity)


def run(settings: Settings) -> Table:
    """Measure every way at every size that it reaches in time."""
    table = Table(
        "sizes",
        "Cost against the size of the window",
        f"A lens at f/8 with C_d = 10, pixels of {PIXEL:g} λN, one thread, one call for the whole window. The unit "
        "of cost is one FFT of 1024² complex128. The FFT method pads to twice the side or a little more; the FFT "
        "alone is that transform and nothing else. Ray tracing sums every wavelet for every pixel; most of its "
        "error is physics (no Fresnel approximation). The paper's truncated series for erf holds for small windows "
        "only. Nothing is extrapolated: a method stops where its next call would take more than "
        f"{_SECONDS:g} s, or more memory than is free.",
        {"n": "text", "way": "text", "cost": "number", "over lommel": "spread", "true error": "error"},
    )
    from scipy.fft import next_fast_len

    unit = fft()
    last: dict[str, list[float]] = {}
    for n in SIDES[:5:2] if settings.quick else SIDES:
        judged = truth(Question(10.0, n=n, pixel=PIXEL))
        ways = {way.name: way for way in _ways(n)}
        mine = _contender(ways["lommel"], n)
        for name in [*ways, "FFT, alone"]:
            way = ways.get(name, Way(name, None, 4.5))
            if last.get(name, [0.0])[-1] * way.growth > _SECONDS:
                continue
            if name.startswith("FFT") and 8 * 16 * (2 * n) ** 2 > free_memory():
                table.notes.append(f"{name}, {n}²: left out for lack of memory")
                continue
            settings.tick(f"{n}², {name}")
            one = fft(next_fast_len(2 * n)) if name == "FFT, alone" else _contender(way, n)
            others = [one] if name == "lommel" else [one, replace(mine, name="lommel, again")]
            result = race(
                [replace(unit, name="unit"), *others], settings.rounds, budget=0.3 if settings.quick else 3.0
            )
            last.setdefault(name, []).append(result.median(one.name))
            values = result.values[one.name]
            table.add(
                f"{n}",
                name,
                result.ratio(one.name, "unit"),
                None if len(others) == 1 else result.ratio(one.name, "lommel, again"),
                judged.error(values) if values.size else None,
            )
    for name, taken in last.items():
        if len(taken) > 5:
            sides = SIDES[3 : len(taken)]
            power = math.log(taken[-1] / taken[3]) / math.log(sides[-1] / sides[0])
            table.notes.append(
                f"{name}: from {sides[0]}² to {sides[-1]}² the cost grew as n to the power {power:.2f}"
            )
    return table
