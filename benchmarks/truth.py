"""The questions, and their exact answers by quadrature, never an FFT: at radii, or over the aperture."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm

_JUDGED = 20_000  # pixels of a window too large to be judged whole
_WHOLE = 1024  # side of the largest window that is


@dataclass(frozen=True, kw_only=True)
class Window(ABC):
    """A square window, in the units of the paper.

    Attributes
    ----------
    n : int
        Side of the window in pixels.
    pixel : float
        Pitch in units of lambda*N.
    center : (float, float), optional
        Pixel of the axis; by default the middle of pixel (n // 2, n // 2).
    """

    n: int = 512
    pixel: float = 0.5
    center: tuple[float, float] | None = None

    @abstractmethod
    def pupil(self, share: float = 1.0) -> lm.Pupil:
        """Return the pupil with `share` of the aberrations."""

    @staticmethod
    @abstractmethod
    def written(x: Any, y: Any, t: Any, constants: Any) -> Any:
        """Return the phase in radians, written out for compilers too, at points of the pupil; t = x^2 + y^2."""

    @property
    @abstractmethod
    def constants(self) -> tuple[float, ...]:
        """What `written` needs to know of the aberrations."""

    def phase(self, x: Any, y: Any, t: Any) -> Any:
        """Return the phase in radians at points of the pupil; t = x^2 + y^2."""
        return self.written(x, y, t, self.constants)

    @property
    @abstractmethod
    def slopes(self) -> tuple[float, float]:
        """Bounds of the gradient of the phase, and of its derivative by the angle, radians."""

    def fresh(self, count: int) -> list[lm.Pupil]:
        """Return that many new pupils, each with 1e-7 less of the aberrations than the one before."""
        return [self.pupil(1.0 - 1e-7 * k) for k in range(count)]

    @property
    def step(self) -> float:
        """Pixel pitch in v."""
        return math.pi * self.pixel


@dataclass(frozen=True)
class Question(Window):
    """A window, and a radially symmetric pupil.

    Attributes
    ----------
    defocus, spherical : float
        C_d and C_s, radians.
    obscuration : float
    higher : tuple of float
        Coefficients of rho^6, rho^8, ..., radians.
    """

    defocus: float = 0.0
    spherical: float = 0.0
    obscuration: float = 0.0
    higher: tuple[float, ...] = ()

    def pupil(self, share: float = 1.0) -> lm.Pupil:
        """Return the pupil with `share` of the aberrations."""
        wavefront = lm.Wavefront(share * self.defocus, share * self.spherical, [share * c for c in self.higher])
        return lm.Pupil(wavefront, obscuration=self.obscuration)

    @staticmethod
    def written(x: Any, y: Any, t: Any, constants: Any) -> Any:  # noqa: ARG004
        """Return the phase in radians at t = rho^2."""
        total = 0.0 * t
        for c in constants:
            total = (total + c) * t
        return total

    @property
    def constants(self) -> tuple[float, ...]:
        """Coefficients of the powers of t, the highest first."""
        return (*self.higher[::-1], self.spherical, 2.0 * self.defocus)

    @property
    def slopes(self) -> tuple[float, float]:
        """Bounds of the gradient of the phase, and of its derivative by the angle, radians."""
        powers = enumerate((2.0 * self.defocus, self.spherical, *self.higher), 1)
        return sum(2.0 * k * abs(c) for k, c in powers), 0.0

    def __str__(self) -> str:
        return f"C_d = {self.defocus:g}, C_s = {self.spherical:g}, pixel {self.pixel:g} λN"


@dataclass(frozen=True)
class Truth:
    """Exact intensities at some pixels, 1 being the peak of the unobscured, unaberrated lens."""

    where: Any
    values: NDArray[np.float64]
    peak: float

    def error(self, values: NDArray[Any], *, fit: bool = False) -> float:
        """Return the largest error over the peak.

        `fit` multiplies `values` by the number that fits them best in the sense of least squares, for software
        whose unit of intensity is not known.
        """
        got = np.asarray(values, dtype=np.float64)[self.where]
        if got.shape != self.values.shape:
            raise ValueError(f"the values are of shape {got.shape}, the truth is of {self.values.shape}")
        if fit:
            got = got * (np.vdot(got, self.values) / np.vdot(got, got))
        return float(np.abs(got - self.values).max() / self.peak)


@lru_cache(maxsize=32)
def truth(question: Question) -> Truth:
    """Return the exact intensities: of every pixel, or of 20 000 and the row through the axis in large windows."""
    q = question
    axis = q.center or (q.n // 2, q.n // 2)
    if q.n <= _WHOLE:
        y, x = np.arange(q.n)[:, None] - axis[0], np.arange(q.n) - axis[1]
        where: Any = np.s_[:, :]
    else:
        random = np.random.default_rng(1885)
        rows, columns = random.integers(0, q.n, (2, _JUDGED))
        rows = np.concatenate([rows, np.full(q.n, q.n // 2)])
        columns = np.concatenate([columns, np.arange(q.n)])
        where, y, x = (rows, columns), rows - axis[0], columns - axis[1]
    values = exact(q.pupil(), y, x, q.step)
    return Truth(where, values, float(values.max()))


def exact(pupil: lm.Pupil, y: NDArray[Any], x: NDArray[Any], step: float) -> NDArray[np.float64]:
    """Return I at positions in pixels from the axis, shape ``pupil.shape + positions``."""
    square = np.round(np.asarray(y, dtype=np.float64) ** 2 + np.asarray(x, dtype=np.float64) ** 2, 9)
    distinct, place = np.unique(square, return_inverse=True)
    field = lm.methods.Hankel().field(pupil, step * np.sqrt(distinct))
    intensity = field.real**2 + field.imag**2
    return np.asarray(intensity[..., place.reshape(square.shape)])


def exact_stack(pupil: lm.Pupil, n: int, pixel: float) -> NDArray[np.float64]:
    """Return the exact intensities of a stack of windows."""
    offsets = np.arange(n) - n // 2
    return exact(pupil, offsets[:, None], offsets, math.pi * pixel)


def stack_error(values: NDArray[Any], reference: NDArray[np.float64]) -> float:
    """Return the largest error of a stack, each image over its own peak."""
    difference = np.abs(np.asarray(values, dtype=np.float64) - reference)
    return float((difference.max(axis=(-2, -1)) / reference.max(axis=(-2, -1))).max())


def intensity(answer: lm.PSF) -> NDArray[np.float64]:
    """Return I of an answer, whatever its normalisation."""
    return np.asarray(answer.values / answer.scale[..., None, None])


_TERMS = {"coma": (3, 1), "astigmatism": (2, 2), "trefoil": (3, 3)}
ALIGNED = (0.0, 0.0, 0.0)
RANDOM = [tuple(case) for case in np.random.default_rng(1942).uniform(-math.pi, math.pi, (2, 3)).tolist()]


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
    directions: tuple[float, ...] = ALIGNED

    def pupil(self, share: float = 1.0) -> lm.Pupil:
        """Return the pupil with `share` of the aberrations."""
        size, terms = share * self.reach, {}
        for (n, m), angle in zip(_TERMS.values(), self.directions, strict=True):
            terms[n, m], terms[n, -m] = size * math.cos(m * angle), size * math.sin(m * angle)
        return lm.Pupil(lm.Wavefront(size, nonradial=terms))

    @staticmethod
    def written(x: Any, y: Any, t: Any, constants: Any) -> Any:
        """Return the phase in radians, written out, at points of the pupil; t = x^2 + y^2."""
        defocus, a, b, c, d, e, f = constants
        coma = (3.0 * t - 2.0) * (a * x + b * y)
        astigmatism = c * (x * x - y * y) + d * x * y
        trefoil = e * (x * x - 3.0 * y * y) * x + f * (3.0 * x * x - y * y) * y
        return defocus * t + coma + astigmatism + trefoil

    @property
    def constants(self) -> tuple[float, ...]:
        """Coefficients of defocus, and of the two halves of coma, astigmatism and trefoil."""
        a, b, c = self.directions
        turns = (math.cos(a), math.sin(a), math.cos(2 * b), 2.0 * math.sin(2 * b), math.cos(3 * c), math.sin(3 * c))
        return (2.0 * self.reach, *(self.reach * turn for turn in turns))

    @property
    def slopes(self) -> tuple[float, float]:
        """Bounds of the gradient of the phase, and of its derivative by the angle, radians."""
        return (4.0 + 7.0 + 2.0 + 3.0) * self.reach, (1.0 + 2.0 + 3.0) * self.reach

    def turned(self) -> Mixed:
        """Return the same, turned by half a turn: what a transform of the other sign makes of it."""
        return replace(self, directions=tuple(angle + math.pi for angle in self.directions))

    @property
    def degrees(self) -> str:
        """The directions, in words."""
        return ", ".join(f"{math.degrees(angle):.0f}°" for angle in self.directions)

    def __str__(self) -> str:
        return f"{self.reach:g} rad each, directions {self.degrees}, pixel {self.pixel:g} λN"


def exact_rows(question: Mixed, rows: NDArray[Any], columns: NDArray[Any] | None = None) -> NDArray[np.float64]:
    """Return the exact intensities of whole rows of the window, or of some columns, by quadrature over chords.

    Along y Gauss-Legendre, along x the second Gauss-Chebyshev rule, whose weight is the length of the chord: what is
    left is entire in x, and a bandwidth of K takes K / 2 nodes and a few dozen for the error to vanish.
    """
    q = question
    at = np.arange(q.n) if columns is None else columns
    # In x it is that of v in the corners, for the chords shorten as x moves.
    bandwidth = math.hypot(q.n / 2, q.n / 2) * q.step + q.slopes[0]
    count = math.ceil(0.5 * bandwidth) + 40
    angle = math.pi * np.arange(1, count + 1) / (count + 1)
    x, chord = np.cos(angle), np.sin(angle)
    eta, weights = np.polynomial.legendre.leggauss(count)
    y = chord[:, None] * eta
    across = x[:, None] + 0.0 * y
    wave = np.exp(1j * q.phase(across, y, across**2 + y**2)) * weights * (chord**2 / (count + 1))[:, None]
    down, right = q.center or (q.n // 2, q.n // 2)
    chords = np.stack([(wave * np.exp(-1j * q.step * (row - down) * y)).sum(axis=1) for row in rows])
    field = chords @ np.exp(-1j * q.step * np.outer(x, at - right))
    return np.asarray(field.real**2 + field.imag**2)


def exact_averages(question: Mixed, rows: NDArray[np.int64]) -> NDArray[np.float64]:
    """Return the exact averages over the pixels of whole rows, by Gauss's rule on each."""
    x, w = np.polynomial.legendre.leggauss(6 + int(0.8 * question.step))
    down, across = rows[:, None] + 0.5 * x, (np.arange(question.n)[:, None] + 0.5 * x).ravel()
    values = exact_rows(question, down.ravel(), across).reshape(len(rows), x.size, question.n, x.size)
    return np.asarray(0.25 * np.einsum("rayb,a,b->ry", values, w, w))


@lru_cache(maxsize=64)
def _truth(question: Mixed, bright: int) -> Truth:
    rows = np.unique(np.clip([*range(bright - 4, bright + 5), *range(7, question.n, 21)], 0, question.n - 1))
    values = exact_rows(question, rows)
    return Truth((rows, slice(None)), values, float(values.max()))


def aperture_error(question: Mixed, values: NDArray[Any], *, fit: bool = False) -> float:
    """Return the largest error over the peak: of every 21st row, and of those about the largest value.

    Where that value is not where the peak is, the peak found is a smaller one, and the error told a larger one.
    `fit` as in :meth:`Truth.error`.
    """
    return _truth(question, int(np.argmax(values)) // question.n).error(values, fit=fit)
