"""Any wavefront: stacks of small windows, their derivatives, and one large window, each beside an FFT."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache, partial
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.contenders import by_plan as plan_of
from benchmarks.contenders import engine, fft, over_abs, stack
from benchmarks.peers import ducc0_single
from benchmarks.timing import Contender, Measured, Settings, no_values, race, worst
from benchmarks.truth import ALIGNED, RANDOM, Mixed, aperture_error, stack_error
from lommel.core.answers import Samples, Wanted
from lommel.optics.grid import Grid
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre

COUNT, SIDE, PIXEL, TOL = 1000, 33, 0.5, 1e-4
_TERMS = range(2, 17)  # Noll
_JUDGED = 16  # members of the stack


def random_zernikes(each: bool) -> Callable[[int], list[lm.Pupil]]:
    """Return a maker of stacks of 15 random Zernike terms: of 1 rad rms together, or `each` of them."""
    c = np.random.default_rng(1934).normal(size=(COUNT, len(_TERMS)))
    c = np.sign(c) if each else c / np.linalg.norm(c, axis=1, keepdims=True)

    def fresh(times: int) -> list[lm.Pupil]:
        made = []
        for k in range(times):
            terms = {j: (1.0 - 1e-7 * k) * c[:, i] for i, j in enumerate(_TERMS)}
            made.append(lm.Pupil(lm.Wavefront.zernike(terms, order="noll")))
        return made

    return fresh


def exact(pupils: lm.Pupil, term: tuple[int, int] | None = None) -> NDArray[np.float64]:
    """Return the intensities of the windows by quadrature in polar coordinates, or their derivatives by a term."""
    r, w = gauss_legendre(64, pupils.obscuration, 1.0)
    theta = 2.0 * math.pi * np.arange(192) / 192
    x, y = np.outer(r, np.cos(theta)).ravel(), np.outer(r, np.sin(theta)).ravel()
    weighted = pupils.values(x, y) * np.repeat(2.0 / 192 * w * r, 192)
    v = math.pi * PIXEL * (np.arange(SIDE) - SIDE // 2)
    across, down = np.exp(-1j * np.outer(x, v)), np.exp(-1j * np.outer(v, y))
    fields = np.stack([(down * one) @ across for one in weighted])
    if term is None:
        return np.asarray(fields.real**2 + fields.imag**2)
    factor = zernike.polynomial(*term, np.hypot(x, y), np.arctan2(y, x))
    slopes = np.stack([(down * (factor * one)) @ across for one in weighted])
    return np.asarray(-2.0 * (fields.conj() * slopes).imag)


@lru_cache(maxsize=1)
def ffts() -> Contender:
    """SciPy's FFTs alone, of all pupils in one call with one thread, in place."""
    from scipy.fft import fft2

    phase = np.random.default_rng(1).normal(size=(COUNT, 128, 128))
    padded = np.exp(1j * phase)
    config = f"scipy.fft.fft2 of {COUNT} × 128² complex128 in one call, in place, the FFT alone"
    return Contender(
        "FFTs 128²",
        lambda _: fft2(padded, norm="ortho", overwrite_x=True, workers=1),
        config,
        values=no_values,
    )


def stacks_against_fft(settings: Settings, *, each: bool, threads: int) -> Measured:
    """Measure 1000 of 33², of any wavefront, against the FFTs."""
    fresh = random_zernikes(each)
    mine = stack(fresh, SIDE, PIXEL, method=lm.methods.ChordalGauss(TOL), threads=threads, dtype=np.float32, out=True)
    result = race([mine, ffts()], settings.rounds)
    error = stack_error(result.values[mine.name][:_JUDGED], exact(fresh(1)[0][:_JUDGED]))
    note = (
        f"15 terms (Noll 2 to 16) of 1 rad rms {'each' if each else 'together'}, pixel {PIXEL} λN: {mine.config}, "
        f"{1e6 * result.median(mine.name) / COUNT:.1f} µs a PSF. Against {ffts().config}. Error of {_JUDGED} of them"
    )
    return Measured(result.ratio(ffts().name, mine.name), error, note)


def _images(tol: float, dtype: Any, terms: tuple[tuple[int, int], ...], threads: int = 1) -> Contender:
    grid, wanted = Grid(SIDE, PIXEL), Wanted(dtype=dtype, threads=threads, terms=terms)

    def call(pupils: lm.Pupil) -> Samples:
        return lm.methods.ChordalGauss(tol).images(pupils, grid, wanted)

    def first(made: Samples) -> NDArray[np.float64]:
        return np.asarray(made.values if made.slopes is None else made.slopes.values[-1], dtype=np.float64)

    name = "derivatives" if terms else "images"
    config = f"ChordalGauss({tol:g}).images with {len(terms)} derivatives, {np.dtype(dtype)}, threads={threads}"
    return Contender(name, call, config, random_zernikes(True), first)


def derivatives_over_images(settings: Settings, *, tol: float) -> Measured:
    """Measure 1000 of 33² with 15 derivatives, over 16 times their images."""
    terms = tuple(zernike.term(j, "noll") for j in _TERMS)
    mine, images = _images(tol, np.float32, terms), _images(tol, np.float32, ())
    result = race([mine, images], settings.rounds)
    judged = random_zernikes(True)(1)[0][:_JUDGED]
    missed = np.abs(result.values[mine.name][:_JUDGED] - exact(judged, terms[-1])).max(axis=(1, 2))
    error = float((missed / exact(judged).max(axis=(1, 2))).max())
    ratio = result.ratio(mine.name, images.name)
    value = type(ratio)(ratio.median / 16.0, ratio.low / 16.0, ratio.high / 16.0, ratio.rounds)
    return Measured(value, error, f"{mine.config}. Error of the last of {_JUDGED} of them, over the peak")


def gradient_over_images(settings: Settings, *, terms: int) -> Measured:
    """Measure the gradient of a weighted sum of 1000 of 33² by coefficients, over the images."""
    wanted = tuple(zernike.term(j, "noll") for j in range(2, 2 + terms))
    weights, grid = np.random.default_rng(7).normal(size=(COUNT, SIDE, SIDE)), Grid(SIDE, PIXEL)

    def call(pupils: lm.Pupil) -> NDArray[np.float64]:
        return lm.methods.ChordalGauss(1e-6).gradient(pupils, grid, weights, wanted)

    config = f"ChordalGauss(1e-06).gradient by {terms} terms, all threads"
    mine, images = Contender("gradient", call, config, random_zernikes(True)), _images(1e-6, np.float64, (), 0)
    result = race([mine, images], settings.rounds)
    return Measured(result.ratio(mine.name, images.name), None, f"{config}. Against {images.config}")


PIXELS = (0.25, 0.5, 1.0)


def _cases(settings: Settings, *pixels: float) -> list[Mixed]:
    directions = (RANDOM[0],) if settings.quick else (ALIGNED, *RANDOM)
    return [Mixed(pixel=p, directions=d) for d in directions for p in pixels]


def window_against_fft(
    settings: Settings, *, pixels: tuple[float, ...], threads: int, reaches: tuple[float, ...] = (10.0, 3.0)
) -> Measured:
    """Measure 512², against the FFT."""
    other, found = fft(), []
    for q in (replace(q, reach=r) for r in reaches for q in _cases(settings, *pixels)):
        mine = engine(q, threads=threads, out=True)
        result = race([mine, other], settings.rounds)
        note = f"{q}: {mine.config}, {1e3 * result.median(mine.name):.2f} ms. Against {other.config}"
        found.append(Measured(result.ratio(other.name, mine.name), aperture_error(q, result.values[mine.name]), note))
    return worst(found, more=True)


def by_plan(settings: Settings) -> Measured:
    """Measure one 33² by a plan."""
    q = Mixed(n=33, reach=1.0)
    note = f"{q}: plan(pupil, out=frame), a new pupil each time"
    return over_abs(settings, plan_of(q), partial(aperture_error, q), note)


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
        off = min(aperture_error(way, result.values[other.name], fit=True) for way in (q, q.turned()))
        note = f"{q}: {mine.config}. Against ducc0, {theirs.config}, whose error is {off:.1e}"
        found.append(Measured(result.ratio(other.name, mine.name), aperture_error(q, result.values[mine.name]), note))
    return worst(found, more=True)


def _method(name: str, pixel: float) -> lm.methods.Method:
    if name == "NonuniformFFT":
        return lm.methods.NonuniformFFT()
    if name == "MatrixFourier":
        return lm.methods.MatrixFourier(samples=512)
    # Its FFT is one of 1024 squared, whatever the pitch.
    return lm.paper.Fraunhofer(samples=round(1024 * pixel), padding=1.0 / pixel, edge="grey")


def method_against_fft(settings: Settings, *, name: str) -> Measured:
    """Measure 512² by another method, against the FFT."""
    other, found = fft(), []
    for q in _cases(settings, *PIXELS)[:6]:
        mine = engine(q, method=_method(name, q.pixel))
        result = race([mine, other], settings.rounds, budget=1.0)
        note = f"{q}: {mine.config}. Against {other.config}"
        found.append(Measured(result.ratio(other.name, mine.name), aperture_error(q, result.values[mine.name]), note))
    return worst(found, more=True)
