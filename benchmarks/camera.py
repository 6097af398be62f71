"""A camera's question: stacks of small windows averaged over pixels of some lambda N, any wavefront, against FFTs."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.chordal import COUNT, SIDE, TOL
from benchmarks.engine import stack
from benchmarks.settings import Settings
from benchmarks.targets import Measured
from benchmarks.timing import Contender, race
from benchmarks.truth import intensity
from lommel.special.legendre import gauss_legendre

WAVELENGTH = 550e-9
_TERMS = range(4, 16)  # Noll: degrees 2 to 4
_VANES = 50  # pupils behind vanes
_JUDGED = 4  # members of the stack, of each some pixels


def ffts(side: int, dtype: type, count: int) -> Contender:
    """SciPy's FFT alone, one after the other, of an array that stays in the cache."""
    from scipy.fft import fft2

    one = np.exp(1j * np.random.default_rng(1).normal(size=(side, side))).astype(dtype)

    def call(_: object) -> None:
        for _again in range(count):
            fft2(one, workers=1)

    config = f"scipy.fft.fft2 of {side}² {np.dtype(dtype)}, {count} times in the cache, the FFT alone"
    return Contender(f"FFTs {side}²", call, config, values=_none)


def _none(_: object) -> NDArray[np.float64]:
    return np.empty(0)


def pixel_of(f_number: float, pitch: float) -> float:
    """Return a pitch, metres, in lambda N."""
    return pitch / (WAVELENGTH * f_number)


def lenses(waves: float, *, obscuration: float = 0.0, count: int = COUNT) -> Callable[[int], list[lm.Pupil]]:
    """Return a maker of stacks of 12 random Zernike terms of so many waves rms together."""
    c = np.random.default_rng(1873).normal(size=(count, len(_TERMS)))
    c *= waves / np.linalg.norm(c, axis=1, keepdims=True)

    def fresh(times: int) -> list[lm.Pupil]:
        made = []
        for k in range(times):
            terms = {j: (1.0 - 1e-7 * k) * c[:, i] for i, j in enumerate(_TERMS)}
            wavefront = lm.Wavefront.zernike(terms, order="noll", unit="waves")
            made.append(lm.Pupil(wavefront, obscuration=obscuration))
        return made

    return fresh


def error(values: NDArray[np.float64], pupils: lm.Pupil, pixel: float) -> float:
    """Return the largest error of some pixels of some members over their peak, by quadrature of pupil and pixels."""
    step = math.pi * pixel
    x, weight = np.polynomial.legendre.leggauss(8 + int(0.8 * step))
    turns = step * SIDE
    r, w = gauss_legendre(40 + int(0.4 * turns), pupils.obscuration, 1.0)
    angles = 80 + int(1.2 * turns)
    theta = 2.0 * math.pi * np.arange(angles) / angles
    across, down = np.outer(r, np.cos(theta)).ravel(), np.outer(r, np.sin(theta)).ravel()
    rule = np.repeat(2.0 / angles * w * r, angles)
    worst = 0.0
    for i in range(_JUDGED):
        light = np.reshape(pupils[i].values(across, down), -1) * rule
        for row, column in ((16, 16), (16, 17), (13, 19), (22, 16), (11, 21), (24, 9), (2, 30)):
            vy, vx = (step * (at - SIDE // 2 + 0.5 * x) for at in (row, column))
            field = (np.exp(-1j * np.outer(vy, down)) * light) @ np.exp(-1j * np.outer(across, vx))
            exact = 0.25 * weight @ np.abs(field) ** 2 @ weight
            worst = max(worst, abs(float(values[i, row, column]) - exact) / float(values[i].max()))
    return worst


def against_fft(
    settings: Settings, *, f_number: float, pitch: float, waves: float, obscuration: float = 0.0, tol: float = TOL
) -> Measured:
    """Measure 1000 of 33², averaged over pixels, against the FFTs."""
    fresh, pixel = lenses(waves, obscuration=obscuration), pixel_of(f_number, pitch)
    mine, other = averaged(fresh, pixel, tol), ffts(128, np.complex128, COUNT)
    result = race([mine, other], settings.rounds)
    off = error(result.values[mine.name], fresh(1)[0], pixel)
    note = (
        f"pixels of {pixel:.3g} λN: {mine.config}, {1e6 * result.median(mine.name) / COUNT:.1f} µs a PSF; "
        f"{other.config}; error of {7 * _JUDGED} pixels"
    )
    return Measured(result.ratio(other.name, mine.name), off, note)


def averaged(fresh: Callable[[int], list[lm.Pupil]], pixel: float, tol: float) -> Contender:
    """Make a stack averaged over pixels by one ``lm.psf``."""

    def call(pupils: lm.Pupil) -> lm.PSF:
        return lm.psf(pupils, SIDE, pixel, integrate=True, tol=tol, dtype=np.float32, threads=1)

    config = f"lm.psf(..., integrate=True, tol={tol:g}, dtype=float32, threads=1)"
    return Contender("averaged", call, config, fresh, intensity)


def over_samples(settings: Settings, *, f_number: float, pitch: float, waves: float) -> Measured:
    """Measure 1000 of 33², averaged over pixels, over the same window sampled."""
    fresh, pixel = lenses(waves), pixel_of(f_number, pitch)
    mine, other = (
        averaged(fresh, pixel, TOL),
        stack(fresh, SIDE, pixel, method=lm.ChordalGauss(TOL), dtype=np.float32),
    )
    result = race([mine, other], settings.rounds)
    return Measured(
        result.ratio(mine.name, other.name),
        error(result.values[mine.name], fresh(1)[0], pixel),
        f"pixels of {pixel:.3g} λN: {mine.config}; {other.config}",
    )


def vanes_against_fft(settings: Settings) -> Measured:
    """Measure 50 of 33² behind four vanes, averaged over pixels of 2.65 lambda N, against FFTs of 256²."""
    bare = lenses(0.1, obscuration=0.3, count=_VANES)
    spider = lm.Spider.equal(4, width=0.02)

    def fresh(times: int) -> list[lm.Pupil]:
        return [lm.Pupil(p.wavefront, obscuration=0.3, spider=spider) for p in bare(times)]

    other = ffts(256, np.complex64, _VANES)
    mine = averaged(fresh, 2.65, TOL)
    result = race([mine, other], settings.rounds)
    made, pupils = result.values[mine.name], fresh(1)[0]
    exact = lm.psf(pupils[:_JUDGED], SIDE, 2.65, integrate=True, method=lm.NonuniformFFT(1e-7))
    off = np.abs(made[:_JUDGED] - np.asarray(exact.values / exact.scale[..., None, None])).max(axis=(1, 2))
    note = f"{mine.config}; {other.config}; error of {_JUDGED} of them beside those at a tolerance of 1e-7"
    return Measured(result.ratio(mine.name, other.name), float((off / made[:_JUDGED].max(axis=(1, 2))).max()), note)
