"""The questions, and their exact answers: quadrature at the radius of every pixel that is judged, never an FFT."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
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
    field = lm.Hankel().field(pupil, step * np.sqrt(distinct))
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
