"""The paper's question and its Fig. 1: its closed form, the FFT and Huygens beside lommel; cost against the side."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.contenders import fft
from benchmarks.report import Table
from benchmarks.timing import Contender, Settings, race
from benchmarks.truth import Question, exact_stack, intensity, stack_error, truth

_PIXEL = 0.5
_FORMS: dict[str, lm.methods.Method] = {
    "closed form, Fresnel integrals": lm.paper.ClosedForm(),
    "closed form, table of 4096": lm.paper.ClosedForm(erf=lm.paper.TableErf()),
    "closed form, Abramowitz 30": lm.paper.ClosedForm(erf=lm.paper.AbramowitzErf(30)),
    "closed form, tuned to 1e-4": lm.paper.TunedClosedForm(1e-4),
}
_STACK = 1000


class Transform:
    """SciPy's FFT of a sampled pupil, all that does not depend on the phase at hand, in single precision."""

    def __init__(self, n: int, side: int) -> None:
        from scipy.fft import fft2

        x = np.fft.fftfreq(side) * 2.0 / _PIXEL
        t = x[:, None] ** 2 + x**2
        self.inside, self.fft2 = np.nonzero(t.ravel() < 1.0)[0], fft2
        self.t = t.ravel()[self.inside].astype(np.float32)
        self.field = np.zeros((side, side), np.complex64)
        self.scale = np.float32((4.0 / (math.pi * (_PIXEL * side) ** 2)) ** 2)
        self.window = np.ix_(*2 * [(np.arange(n) - n // 2) % side])

    def __call__(self, pupil: lm.Pupil) -> NDArray[np.float32]:
        """Return I of one pupil, or of a stack."""
        return np.stack([self._one(c) for c in pupil.coefficients()]).reshape(
            *pupil.shape, *self.window[0].shape[:1], -1
        )

    def _one(self, c: NDArray[np.float64]) -> NDArray[np.float32]:
        c1, c2 = np.float32(c[0]), np.float32(c[1] if len(c) > 1 else 0.0)
        self.field.ravel()[self.inside] = np.exp(1j * ((c2 * self.t + c1) * self.t))
        values = self.fft2(self.field, workers=1)[self.window]
        return np.asarray(self.scale * (values.real**2 + values.imag**2))


def _huygens(q: Question) -> Contender:
    """Return the sum of wavelets at each distinct radius, which needs a lens and lengths."""
    ideal = lm.Lens(focal_length=50e-3, f_number=8.0, wavelength=550e-9, aberrations=lm.Wavefront(0.0, q.spherical))
    pupil = ideal.pupil(float(ideal.defocus(1.0)) / q.defocus)  # C_d goes like the inverse of the distance

    def call(_: Any) -> lm.PSF:
        method, pixel = lm.paper.HuygensFresnel(), _PIXEL * pupil.scale
        return lm.psf(pupil, q.n, pixel, method=method, threads=1, integrate=False, dtype=np.float32)

    return Contender("Huygens, distinct radii", call, values=intensity)


def _many(share: float) -> lm.Pupil:
    random = np.random.default_rng(1885)
    defocus, spherical = random.uniform(-20.0, 20.0, _STACK), random.uniform(-5.0, 5.0, _STACK)
    return lm.Pupil(lm.Wavefront(share * defocus, share * spherical))


def _contenders(n: int, fresh: Any) -> list[Contender]:
    def by(name: str, **options: Any) -> Contender:
        def call(pupil: lm.Pupil) -> lm.PSF:
            return lm.psf(pupil, n, _PIXEL, threads=1, dtype=np.float32, **options)

        return Contender(name, call, fresh=fresh, values=intensity)

    transforms = [Contender(f"FFT of {side}², SciPy", Transform(n, side), fresh=fresh) for side in (n, 2 * n)]
    return [by("lommel"), *(by(name, method=form) for name, form in _FORMS.items()), *transforms]


def paper(settings: Settings) -> Table:
    """Race all ways through one image, and through a stack of small ones."""
    table = Table(
        "paper",
        "The question of the paper",
        f"A lens out of focus, with spherical aberration or without, pixels of {_PIXEL:g} λN, one thread, float32. "
        "The FFT is SciPy's, of complex64, with all that does not depend on the phase at hand: one as large as the "
        "window, as in the paper, and one of twice its side. The closed form takes 16 quadratic phases for spherical "
        "aberration and is compiled, like the default method. Its error is that of its approximations, whatever its "
        "error function, but for the rings that 30 terms bring into large windows. "
        f"The stack has {_STACK} pupils, C_d up to ±20 and C_s up to ±5; errors are those of the "
        "worst image. Huygens' superposition, of which most of the error is physics (no Fresnel approximation), "
        "takes minutes for the radii of 512².",
        {"image": "text", "way": "text", "FFT over it": "spread", "over lommel": "spread"} | {"true error": "error"},
    )
    for n in (33,) if settings.quick else (33, 512):
        for spherical in (0.0, 3.0):
            q = Question(10.0, spherical, n=n, pixel=_PIXEL)
            words = f"C_d = {q.defocus:g}, C_s = {q.spherical:g}"
            reference = exact_stack(q.pupil(), n, _PIXEL)
            ways = _contenders(n, q.fresh) + [_huygens(q)] * (n == 33)
            _race(table, settings, f"{n}², {words}", ways, reference)
    if not settings.quick:
        stack = _many(1.0)

        def fresh(count: int) -> list[lm.Pupil]:
            return [_many(1.0 - 1e-7 * k) for k in range(count)]

        slow = ("closed form, tuned to 1e-4",)
        ways = [one for one in _contenders(33, fresh) if one.name not in slow]
        _race(table, settings, f"{_STACK} of 33², both random", ways, exact_stack(stack, 33, _PIXEL))
    return table


def _race(
    table: Table, settings: Settings, image: str, ways: list[Contender], reference: NDArray[np.float64]
) -> None:
    settings.tick(image)
    mine, transform = ways[0], next(one for one in ways if one.name.startswith("FFT"))
    again = [replace(mine, name="again"), replace(transform, name="FFT")]
    result = race([*again, *ways], settings.rounds, budget=2.0 if settings.quick else 10.0)
    for one in ways:
        error = stack_error(result.values[one.name], reference)
        table.add(image, one.name, result.ratio("FFT", one.name), result.ratio(one.name, "again"), error)


SIDES = [33, 65, 129, 257, 512, 1024, 2048, 4096]
PIXEL = 0.5
_SECONDS = 4.0  # no call is made that the last one suggests to take longer


@dataclass(frozen=True)
class Way:
    """One curve: a method, and how its cost is expected to grow at most when the side doubles."""

    name: str
    method: lm.methods.Method | None
    growth: float


def _ways(n: int) -> list[Way]:
    return [
        Way("lommel", None, 4.0),
        Way("quadrature", lm.methods.Hankel(), 8.0),
        Way("closed form, Abramowitz 30", lm.paper.ClosedForm(erf=lm.paper.AbramowitzErf(30)), 4.0),
        Way("closed form, Fresnel", lm.paper.ClosedForm(), 4.0),
        Way("FFT, whole method", lm.paper.Fraunhofer(samples=max(n, 64), padding=1.0), 4.5),
        Way("ray tracing", lm.paper.HuygensFresnel(symmetry=False), 16.0),
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


def sizes(settings: Settings) -> Table:
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
