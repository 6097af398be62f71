"""What else the engine does: obscuration, colours, derivatives, seeing, vanes, segments and masks."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import j0, j1

import lommel as lm
from benchmarks.camera import average_truth
from benchmarks.contenders import engine, fft
from benchmarks.report import Table
from benchmarks.timing import Contender, Settings, race
from benchmarks.truth import Question, Truth, exact, intensity, truth
from lommel.blur.blurs import KOLMOGOROV

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
    method = lm.methods.Polychromatic(waves.tolist(), weights.tolist())

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


_STARS = {50.0: (8.0, 600e-9, 0.0), 12.0: (2.4, 700e-9, 0.33)}
"""Diameter (metres), wavelength and obscuration for each D / r0."""


def seeing(settings: Settings) -> Table:
    """Each beside the FFT, with its true error and bound."""
    table = Table(
        "seeing",
        "Seeing",
        "33² samples of 0.1 arcsec, one thread, each image with another r0. Beside one FFT of 1024² complex128, "
        "though that does none of this. True errors: over the largest value, against quadrature of OTF times blur.",
        {"what": "text", "FFT alone over it": "spread", "true error": "error", "bound": "error"},
    )
    other = fft()
    for ratio, (diameter, wavelength, eps) in _STARS.items():
        for tol in (1e-4, 1e-6, 1e-9):
            name = f"D / r0 = {ratio:g}, tol {tol:g}"
            settings.tick(name)
            pixel, pupil = 0.1 * math.pi / 648000.0 / (wavelength / diameter), lm.Pupil(obscuration=eps)
            one = _star(name, pupil, pixel, tol, ratio)
            result = race([one, other], settings.rounds, budget=2.0)
            answer = one.call(ratio)
            radius = np.hypot(answer.grid.x, answer.grid.y[:, None])
            exact = _exact(radius, pupil, ratio)
            off = float(np.abs(answer.values - exact).max() / exact.max())
            table.add(name, result.ratio(other.name, one.name), off, float(answer.error_bound))
    return table


def _star(name: str, pupil: lm.Pupil, pixel: float, tol: float, ratio: float) -> Contender:
    def call(ratio: float) -> Any:
        air = lm.Seeing(1.0 / ratio)
        return lm.psf(pupil, 33, pixel, blur=air, tol=tol, threads=1, dtype=np.float64, normalize="strehl")

    def fresh(count: int) -> list[float]:
        return (ratio * (1.0 + 1e-4 * np.arange(count))).tolist()

    return Contender(name, call, f"psf(..., blur=Seeing(), tol={tol:g})", fresh, lambda answer: answer.values)


def _exact(radius: Array, pupil: lm.Pupil, ratio: float) -> Array:
    """Return the long exposure over the unaberrated peak at radii in lambda*N, with 600 nodes."""
    x, weight = np.polynomial.legendre.leggauss(600)
    end = math.cbrt(min(4.0 / ratio, 0.5 * (1.0 - pupil.obscuration)))
    u = 0.5 * end * (x + 1.0)
    f, weight = u**3, 0.5 * end * weight * 3.0 * u**5
    weight = weight * np.real(lm.otf(pupil, f, tol=1e-13)) * np.exp(-KOLMOGOROV * (ratio * f) ** (5.0 / 3.0))
    places, where = np.unique(radius, return_inverse=True)
    found = 8.0 * j0(2.0 * math.pi * np.multiply.outer(places, f)) @ weight
    return np.asarray(found[where.reshape(radius.shape)] * pupil.transmission / pupil.amplitude**2)


Array = NDArray[np.float64]
Field = NDArray[np.complex128]

_SAMPLES = 512
_PIXEL = 0.25  # lambda*N
_VANES = (5, 0.02, 0.2)  # how many, width over the radius, angle of the first
_OBSCURATION = 0.3
_X: Array = (2.0 * np.arange(_SAMPLES) + 1.0) / _SAMPLES - 1.0  # middles of cells


class _Case(NamedTuple):
    name: str
    side: int
    make: Callable[[int], lm.Pupil]  # of a number, by which aberrations differ
    sampled: Field  # the nominal pupil function in cells of 1 / 256 of the radius
    exact: Field | None  # its transform


def apertures(settings: Settings) -> Table:
    """Each with its true error and bound, beside the transform and its error."""
    table = Table(
        "apertures",
        "Vanes, segments and masks",
        f"Samples of {_PIXEL} λN, tol 1e-6, one thread, each call with another pupil of the same aperture. Beside "
        f"what HCIPy and POPPY do for such windows, the matrix Fourier transform, here of {_SAMPLES}² cells in NumPy "
        "with all its matrices at hand; cells at an edge are in or out. True errors: over the largest value, against "
        "closed forms (polygons, square cells) and Gauss-Legendre quadrature across each vane.",
        {
            "what": "text",
            "matrix transform over it": "spread",
            "error of the matrix transform": "error",
            "true error": "error",
            "bound": "error",
        },
    )
    for case in _cases():
        settings.tick(case.name)
        one, other = _lommel(case), _transform(case)
        result = race([one, other], settings.rounds, budget=2.0)
        answer = one.call(one.fresh(1)[0])
        exact = _over_peak(np.abs(case.exact) ** 2 if case.exact is not None else result.values[other.name])
        errors = [
            float(np.abs(_over_peak(values) - exact).max()) for values in (result.values[other.name], answer.values)
        ]
        table.add(case.name, result.ratio(other.name, one.name), *errors, float(answer.error_bound))
    return table


def _lommel(case: _Case) -> Contender:
    def call(pupil: lm.Pupil) -> Any:
        return lm.psf(pupil, case.side, _PIXEL, tol=1e-6, threads=1)

    def fresh(count: int) -> list[lm.Pupil]:
        return [case.make(k) for k in range(count)]

    return Contender(case.name, call, "psf(..., tol=1e-6)", fresh, lambda answer: answer.values)


def _transform(case: _Case) -> Contender:
    v = _places(case.side)
    # Square cells: their own transform is a factor along each axis.
    waves = np.exp(-1j * np.multiply.outer(v, _X)) * np.sinc(v / (np.pi * _SAMPLES))[:, None]
    across = np.ascontiguousarray(waves.T)
    return Contender(
        "matrix transform",
        lambda _: np.abs(waves @ case.sampled @ across) ** 2,
        f"NumPy, {_SAMPLES}² cells",
    )


def _over_peak(values: Any) -> Array:
    given = np.asarray(values, np.float64)
    return given / given.max()


def _places(side: int) -> Array:
    return np.pi * _PIXEL * (np.arange(side) - side // 2)


def _cases() -> list[_Case]:
    rng = np.random.default_rng(18)
    hexagon = lm.Polygon.regular(6, 0.9)
    whole = lm.Segments(tuple(part.parts[0] for part in lm.telescopes.jwst().shapes))  # without the struts
    phases = [rng.normal(0.0, 0.5, (3, len(whole.shapes))) for _ in range(8)]
    inner = np.hypot(_X, _X[:, None]) < 1.0 - 2.0 / _SAMPLES  # cells that the edge does not cut
    plate = np.where(inner, np.exp(1j * rng.normal(0.0, 1.0, inner.shape)), 0.0)
    return [
        _Case(
            f"obscuration of {_OBSCURATION} and {_VANES[0]} vanes, 128²",
            128,
            lambda k: lm.Pupil(lm.Wavefront(1e-3 * k), obscuration=_OBSCURATION, spider=lm.Spider.equal(*_VANES)),
            _with_vanes(_X, _X[:, None]),
            _vanes(_places(128)),
        ),
        _Case(
            "one hexagon, 65²",
            65,
            lambda k: lm.Pupil(lm.Wavefront(1e-3 * k), stop=hexagon),
            _inside(hexagon.corners),
            _polygon(hexagon.corners, _places(65)),
        ),
        _Case(
            f"JWST, {len(whole.shapes)} segments with piston, tip and tilt of 0.5 rad, 256²",
            256,
            lambda k: lm.Pupil(stop=whole.phased(*phases[k % len(phases)])),
            *_segments(whole.phased(*phases[0]), _places(256)),
        ),
        _Case(
            f"mask of {_SAMPLES}² complex squares, 128²",
            128,
            lambda k: lm.Pupil(mask=lm.Mask(plate * (1.0 - 1e-9 * k), squares=True)),
            plate,
            None,
        ),
    ]


def _inside(corners: Any) -> Field:
    """Return 1 in the cells whose middles are in a convex polygon, 0 elsewhere."""
    found = np.ones((_SAMPLES, _SAMPLES), bool)
    for (x, y), (to_x, to_y) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        found &= (to_x - x) * (_X[:, None] - y) >= (to_y - y) * (_X - x)
    return found.astype(np.complex128)


def _polygon(corners: Any, v: Array, tip: float = 0.0, tilt: float = 0.0) -> Field:
    """Return ``int exp(-i (v.rho - tip x - tilt y))`` over a polygon, by the theorem of Stokes."""
    vx, vy = v - tip, v[:, None] - tilt
    square, total = vx * vx + vy * vy, np.zeros((v.size, v.size), np.complex128)
    for p, q in zip(np.array(corners), np.roll(corners, -1, axis=0), strict=True):
        (dx, dy), (x, y) = q - p, 0.5 * (p + q)
        flux = (vx * dy - vy * dx) * np.sinc((vx * dx + vy * dy) / (2.0 * np.pi))
        total += 1j * flux * np.exp(-1j * (vx * x + vy * y)) / np.where(square > 0.0, square, 1.0)
    x, y = np.array(corners).T
    return np.where(square > 0.0, total, 0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def _segments(given: lm.Segments, v: Array) -> tuple[Field, Field]:
    """Return the pupil function in cells, and its transform."""
    cells, field = np.zeros((_SAMPLES, _SAMPLES), np.complex128), np.zeros((v.size, v.size), np.complex128)
    for shape, piston, tip, tilt, (x, y) in zip(
        given.shapes, given.piston, given.tip, given.tilt, given.centers, strict=True
    ):
        corners: Any = shape.corners  # type: ignore[union-attr]
        cells += _inside(corners) * np.exp(1j * (piston + tip * (_X - x) + tilt * (_X[:, None] - y)))
        field += np.exp(1j * (piston - tip * x - tilt * y)) * _polygon(corners, v, tip, tilt)
    return cells, field


def _with_vanes(x: Array, y: Array) -> Field:
    count, width, first = _VANES
    radius = np.hypot(x, y)
    found = (radius < 1.0) & (radius > _OBSCURATION)
    for angle in first + 2.0 * np.pi / count * np.arange(count):
        c, s = np.cos(angle), np.sin(angle)
        found &= ~((np.abs(y * c - x * s) < 0.5 * width) & (x * c + y * s > 0.0))
    return found.astype(np.complex128)


def _vanes(v: Array) -> Field:
    """Return the transform of the annulus less that of each vane, by quadrature across."""
    count, width, first = _VANES
    radius = np.hypot(v, v[:, None])
    known = np.where(radius > 0.0, radius, 1.0)

    def disc(edge: float) -> Array:
        return np.where(radius > 0.0, 2.0 * np.pi * edge * j1(edge * known) / known, np.pi * edge**2)

    found = (disc(1.0) - disc(_OBSCURATION)).astype(np.complex128)
    nodes, weights = np.polynomial.legendre.leggauss(24)
    for angle in first + 2.0 * np.pi / count * np.arange(count):
        along = v * np.cos(angle) + v[:, None] * np.sin(angle)
        across = v[:, None] * np.cos(angle) - v * np.sin(angle)
        for t, weight in zip(0.5 * width * nodes, 0.5 * width * weights, strict=True):
            low, high = np.sqrt(_OBSCURATION**2 - t * t), np.sqrt(1.0 - t * t)
            line = (high - low) * np.sinc(along * (high - low) / (2.0 * np.pi))
            found -= weight * line * np.exp(-1j * (0.5 * along * (low + high) + across * t))
    return found
