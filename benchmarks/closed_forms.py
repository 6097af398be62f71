"""The paper's own question, defocus and spherical aberration: its closed form beside the FFT, Huygens and lommel."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.report import Table
from benchmarks.settings import Settings
from benchmarks.timing import Contender, race
from benchmarks.truth import Question, exact_stack, intensity, stack_error

_PIXEL = 0.5
_FORMS: dict[str, lm.Method] = {
    "closed form, Fresnel integrals": lm.ClosedForm(),
    "closed form, table of 4096": lm.ClosedForm(erf=lm.TableErf()),
    "closed form, Abramowitz 30": lm.ClosedForm(erf=lm.AbramowitzErf(30)),
    "closed form, tuned to 1e-4": lm.TunedClosedForm(1e-4),
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
        method, pixel = lm.HuygensFresnel(), _PIXEL * pupil.scale
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


def run(settings: Settings) -> Table:
    """Race all ways through one image, and through a stack of small ones."""
    table = Table(
        "paper",
        "The question of the paper",
        f"A lens out of focus, with spherical aberration or without, pixels of {_PIXEL:g} λN, one thread, float32. "
        "The FFT is SciPy's, of complex64, with all that does not depend on the phase at hand: one as large as the "
        "window, as in the paper, and one of twice its side. The closed form takes 16 quadratic phases for spherical "
        "aberration and is compiled, like the default method; its error is that of its approximations, whatever its "
        f"error function. The stack has {_STACK} pupils, C_d up to ±20 and C_s up to ±5; errors are those of the "
        "worst image. Huygens' superposition, of which most of the error is physics (no Fresnel approximation), "
        "takes minutes for the radii of 512².",
        {"window": "text", "pupil": "text", "way": "text", "FFT over it": "spread", "over lommel": "spread"}
        | {"true error": "error"},
    )
    for n in (33,) if settings.quick else (33, 512):
        for spherical in (0.0, 3.0):
            q = Question(10.0, spherical, n=n, pixel=_PIXEL)
            words = f"C_d = {q.defocus:g}, C_s = {q.spherical:g}"
            reference = exact_stack(q.pupil(), n, _PIXEL)
            ways = _contenders(n, q.fresh) + [_huygens(q)] * (n == 33)
            _race(table, settings, f"{n}²", words, ways, reference)
    if not settings.quick:
        stack = _many(1.0)

        def fresh(count: int) -> list[lm.Pupil]:
            return [_many(1.0 - 1e-7 * k) for k in range(count)]

        slow = ("closed form, tuned to 1e-4",)
        ways = [one for one in _contenders(33, fresh) if one.name not in slow]
        _race(table, settings, f"{_STACK} of 33²", "both", ways, exact_stack(stack, 33, _PIXEL))
    return table


def _race(
    table: Table, settings: Settings, window: str, pupil: str, ways: list[Contender], reference: NDArray[np.float64]
) -> None:
    settings.tick(f"{window}, {pupil}")
    mine, transform = ways[0], next(one for one in ways if one.name.startswith("FFT"))
    again = [replace(mine, name="again"), replace(transform, name="FFT")]
    result = race([*again, *ways], settings.rounds, budget=2.0 if settings.quick else 10.0)
    for one in ways:
        error = stack_error(result.values[one.name], reference)
        table.add(window, pupil, one.name, result.ratio("FFT", one.name), result.ratio(one.name, "again"), error)
