"""Pupils that are not radially symmetric, and their exact answers: quadrature over the aperture, never an FFT."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

import lommel as lm
from benchmarks.truth import Truth, Window

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


def error(question: Mixed, values: NDArray[Any], *, fit: bool = False) -> float:
    """Return the largest error over the peak: of every 21st row, and of those about the largest value.

    Where that value is not where the peak is, the peak found is a smaller one, and the error told a larger one.
    `fit` as in :meth:`Truth.error`.
    """
    return _truth(question, int(np.argmax(values)) // question.n).error(values, fit=fit)
