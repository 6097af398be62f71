"""What else the engine does: obscured, polychromatic, integrated, off-centre, with derivatives."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.averages import average_truth
from benchmarks.baselines import fft
from benchmarks.engine import engine
from benchmarks.report import Table
from benchmarks.settings import Settings
from benchmarks.timing import Contender, race
from benchmarks.truth import Question, Truth, exact, intensity, truth

BASE = Question(10.0, 3.0)
_WAVE = 550e-9


def features(settings: Settings) -> Table:
    """Each beside the plain 512² and the FFT."""
    table = Table(
        "features",
        "Options",
        f"512², {BASE}, tol 1e-6, one thread. The unit of the first ratio is the plain PSF of the same window; the "
        "second is beside one FFT of 1024² complex128, though that FFT does none of this. True errors are over the "
        "largest value, against quadrature at the same radii: of pixel averages 64 points for each of 500 pixels, "
        "of derivatives five-point differences of the quadrature.",
        {
            "what": "text",
            "over the plain PSF": "spread",
            "FFT alone over it": "spread",
            "true error": "error",
        },
    )
    usual, other = engine(BASE, name="usual"), fft()
    for one, judged in _contenders(settings):
        settings.tick(one.name)
        result = race([one, usual, other], settings.rounds, budget=3.0)
        table.add(
            one.name,
            result.ratio(one.name, usual.name),
            result.ratio(other.name, one.name),
            judged.error(result.values[one.name]),
        )
    return table


def _contenders(settings: Settings) -> list[tuple[Contender, Truth]]:
    b = BASE
    obscured = Question(b.defocus, b.spherical, obscuration=0.33)
    higher = Question(b.defocus, b.spherical, higher=(5.0, -2.0))
    aside = Question(b.defocus, b.spherical, center=(250.3, 261.7))
    centered = engine(b, name="pixels averaged over their area, `integrate=True`", integrate=True)
    found = [
        (engine(b, name="float64", dtype=np.float64), truth(b)),
        (engine(b, name="`out=` given", out=True), truth(b)),
        (_planned(), truth(b)),
        (engine(obscured, name="obscured by a third of the diameter"), truth(obscured)),
        (engine(higher, name="with rho⁶ and rho⁸"), truth(higher)),
    ]
    for names in (("defocus",), ("defocus", "spherical")):
        values = _slope(names[-1])
        one = engine(b, name=f"derivatives by {' and '.join(names)}", derivatives=names)
        found.append((_with(one, values), _slope_truth(names[-1])))
    found += [(engine(aside, name="axis between pixels, `center=`"), truth(aside)), (centered, average_truth(b))]
    if not settings.quick:
        found.append(_polychromatic(7))
    return found


def _with(one: Contender, values: Any) -> Contender:
    return Contender(one.name, one.call, one.config, one.fresh, values)


def _planned() -> Contender:
    plan = lm.Plan(BASE.n, BASE.pixel, threads=1)
    return Contender("by a `Plan`", plan, fresh=BASE.fresh, values=intensity)


def _slope(name: str) -> Any:
    return lambda answer: answer.derivatives[name] / answer.scale


def _slope_truth(name: str) -> Truth:
    """Return dI/dC by a five-point difference."""
    offsets = np.arange(BASE.n) - BASE.n // 2
    h, total = 1e-2, np.zeros((BASE.n, BASE.n))
    for k, weight in ((-2, 1.0), (-1, -8.0), (1, 8.0), (2, -1.0)):
        move = lm.Wavefront(k * h) if name == "defocus" else lm.Wavefront(0.0, k * h)
        wavefront = lm.Wavefront(BASE.defocus, BASE.spherical) + move
        total += weight * exact(lm.Pupil(wavefront), offsets[:, None], offsets, BASE.step)
    total /= 12.0 * h
    return Truth(np.s_[:, :], total, float(np.abs(total).max()))


def _polychromatic(count: int) -> tuple[Contender, Truth]:
    waves = np.linspace(450e-9, 650e-9, count)
    weights = np.hanning(count + 2)[1:-1]
    n, number = BASE.n, 4.0
    pixel = BASE.pixel * _WAVE * number
    method = lm.Polychromatic(waves.tolist(), weights.tolist())

    def pupil(share: float) -> lm.Pupil:
        wavefront = lm.Wavefront(share * BASE.defocus, share * BASE.spherical)
        return lm.Pupil(wavefront, wavelength=_WAVE, f_number=number)

    def call(one: lm.Pupil) -> lm.PSF:
        return lm.psf(one, n, pixel, method=method, threads=1)

    offsets = np.arange(n) - n // 2
    total: NDArray[np.float64] = np.zeros((n, n))
    for wave, weight in zip(waves, weights / weights.sum(), strict=True):
        scale = _WAVE / wave
        one = BASE.pupil(scale)
        total += weight * scale**2 * exact(one, offsets[:, None], offsets, math.pi * BASE.pixel * scale)
    contender = Contender(
        f"polychromatic, {count} wavelengths",
        call,
        fresh=lambda times: [pupil(1.0 - 1e-7 * k) for k in range(times)],
        values=intensity,
    )
    return contender, Truth(np.s_[:, :], total, float(total.max()))
