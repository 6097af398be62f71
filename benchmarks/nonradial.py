"""One large window of a pupil that is not radially symmetric: the series, and other methods, against one FFT."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.baselines import fft
from benchmarks.engine import engine
from benchmarks.settings import Settings
from benchmarks.targets import Measured, worst
from benchmarks.timing import race
from benchmarks.truth import Truth, Window
from lommel.special.legendre import gauss_legendre

_TERMS = {"coma": (3, 1), "astigmatism": (2, 2), "trefoil": (3, 3)}
_SLOPE = 16.0  # largest gradient of the phase at a reach of 1: 7 + 2 + 3 of these, 4 of the defocus
_ALIGNED = (0.0, 0.0, 0.0)
_RANDOM = [tuple(case) for case in np.random.default_rng(1942).uniform(-math.pi, math.pi, (2, 3)).tolist()]


@dataclass(frozen=True)
class Mixed(Window):
    """A window, and a pupil with coma, astigmatism, trefoil and defocus, all of one size.

    Attributes
    ----------
    reach : float
        Coefficient of each of the four Zernike polynomials, radians at the edge; that of defocus is C_d.
    directions : tuple of float
        Of coma, astigmatism and trefoil: theta in radians where the phase of each is largest.
    """

    reach: float = 10.0
    directions: tuple[float, ...] = _ALIGNED

    def pupil(self, share: float = 1.0) -> lm.Pupil:
        """Return the pupil with `share` of the aberrations."""
        size, terms = share * self.reach, {}
        for (n, m), angle in zip(_TERMS.values(), self.directions, strict=True):
            terms[n, m], terms[n, -m] = size * math.cos(m * angle), size * math.sin(m * angle)
        return lm.Pupil(lm.Wavefront(size, nonradial=terms))

    def __str__(self) -> str:
        degrees = ", ".join(f"{math.degrees(angle):.0f}°" for angle in self.directions)
        return f"{self.reach:g} rad each, directions {degrees}, pixel {self.pixel:g} λN"


def exact_rows(question: Mixed, rows: NDArray[np.int64]) -> NDArray[np.float64]:
    """Return the exact intensities of whole rows of the window, by quadrature over chords of the aperture.

    Along y Gauss-Legendre, along x the second Gauss-Chebyshev rule, whose weight is the length of the chord: what is
    left is entire in x, and a bandwidth of K takes K / 2 nodes and a few dozen for the error to vanish.
    """
    q, pupil = question, question.pupil()
    # In x it is that of v in the corners, for the chords shorten as x moves.
    bandwidth = math.hypot(q.n / 2, q.n / 2) * q.step + _SLOPE * q.reach
    count = math.ceil(0.5 * bandwidth) + 40
    angle = math.pi * np.arange(1, count + 1) / (count + 1)
    x, chord = np.cos(angle), np.sin(angle)
    eta, weights = gauss_legendre(count, -1.0, 1.0)
    y = chord[:, None] * eta
    weighted = pupil.values(np.broadcast_to(x[:, None], y.shape), y)[0] * weights * (chord**2 / (count + 1))[:, None]
    v = q.step * (np.arange(q.n) - q.n // 2)
    chords = np.stack([(weighted * np.exp(-1j * at * y)).sum(axis=1) for at in v[rows]])
    field = chords @ np.exp(-1j * np.outer(x, v))
    return np.asarray(field.real**2 + field.imag**2)


@lru_cache(maxsize=64)
def _truth(question: Mixed, bright: int) -> Truth:
    rows = np.unique(np.clip([*range(bright - 4, bright + 5), *range(7, question.n, 21)], 0, question.n - 1))
    values = exact_rows(question, rows)
    return Truth((rows, slice(None)), values, float(values.max()))


def error(question: Mixed, values: NDArray[Any]) -> float:
    """Return the largest error over the peak: of every 21st row, and of those about the largest value.

    Where that value is not where the peak is, the peak found is a smaller one, and the error told a larger one.
    """
    return _truth(question, int(np.argmax(values)) // question.n).error(values)


def _cases(settings: Settings, reaches: tuple[float, ...]) -> list[Mixed]:
    pixels = (0.5,) if settings.quick else (0.25, 0.5, 1.0)
    directions = [_ALIGNED, *(_RANDOM[:1] if settings.quick or len(reaches) == 1 else _RANDOM)]
    return [Mixed(pixel=p, reach=r, directions=d) for r in reaches for d in directions for p in pixels]


def against_fft(settings: Settings, *, threads: int) -> Measured:
    """Measure 512², against the FFT."""
    other, found = fft(), []
    for q in _cases(settings, (10.0,) if settings.quick else (3.0, 10.0)):
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
    for q in _cases(settings, (10.0,)):
        mine = engine(q, method=_method(name, q.pixel))
        result = race([mine, other], settings.rounds, budget=1.0)
        note = f"{q}: {mine.config}; {other.config}"
        found.append(Measured(result.ratio(other.name, mine.name), error(q, result.values[mine.name]), note))
    return worst(found, more=True)
