r"""Windows at any defocus from those at few: polynomials through Chebyshev nodes, with a proven error.

The field at a point is the integral over the pupil of ``A exp(i Phi)``, A real, and in the complex plane of the
defocus C ``I(C) = U(C) conj(U(conj(C)))``. There Im Phi differs by at most ``rate |Im C|`` from one place of the
pupil to another, so that by the inequality of Cauchy and Schwarz I is at most ``exp(rate |Im C|)`` times the light
that the pupil lets through, and what a pixel holds of this is at most ``bound`` as much. Let M be the most of that
on the ellipse with the foci -1 and 1 (the ends of the range) and semi-axes that sum up to rho: a polynomial through
n nodes errs by at most ``4 M rho^(1 - n) / (rho - 1)``. Little more than ``rate`` times half of the range are
enough. How much windows at the nodes are off themselves grows by a factor of at most ``1 + 2 log(n) / pi``.

The peak of a defocused point is a small part of that of one in focus: errors are to be small beside either. So the
polynomial is through the windows times a parabola, nearly that of 1 over their peaks, and is divided by it.

References
----------
L. N. Trefethen, *Approximation Theory and Approximation Practice* (SIAM, 2013), Theorem 8.2.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Self

import numpy as np

from lommel.base.arrays import Array
from lommel.core import engine

_ERROR = 1e-9  # of windows whose peaks are about 1
_MOST = 20_000  # nodes


@dataclass(frozen=True)
class Parabola:
    """``curvature (C - middle)^2 + least``, of curvature >= 0 and least > 0."""

    curvature: float
    middle: float
    least: float

    @classmethod
    def through(cls, defocus: Array, values: Array) -> Parabola:
        """Return one that is nearly 1 over `values` at three equally spaced points; no value is above 1."""
        step, (before, here, after) = 0.5 * float(defocus[2] - defocus[0]), (1.0 / values).tolist()
        bend = 0.5 * (before + after) - here
        if not bend > 1e-3 * here:
            return cls(0.0, 0.0, 1.0)
        shift = 0.25 * (after - before) / bend
        return cls(bend / step**2, float(defocus[1]) - shift * step, max(1.0, here - bend * shift**2))

    def __call__(self, defocus: Array) -> Array:
        """Return its values."""
        return self.curvature * (defocus - self.middle) ** 2 + self.least


@dataclass(frozen=True)
class DefocusNodes:
    """Windows anywhere in a range of defocus.

    Attributes
    ----------
    low, high : float
        The range, radians.
    parabola : Parabola
        What the windows are multiplied by.
    coefficients : ndarray, shape (n, cells)
        Of the Chebyshev polynomials, for these windows.
    """

    low: float
    high: float
    parabola: Parabola
    coefficients: Array
    threads: int = 0

    @classmethod
    def of(
        cls,
        windows: Callable[[Array], Array],
        low: float,
        high: float,
        parabola: Parabola,
        *,
        rate: Callable[[float], float],
        bound: float,
        threads: int = 0,
    ) -> DefocusNodes:
        """Compute as many windows as it takes: `rate` for C up to a distance from 0, `bound` as above."""
        middle, reach = 0.5 * (low + high), 0.5 * (high - low)
        axis = np.geomspace(1e-3, max(1.0, 20.0 / reach), 200)  # beyond the foci
        rho = 1.0 + axis + np.sqrt(axis * (axis + 2.0))
        beyond = reach * (1.0 + float(axis[-1]))
        fastest = rate(abs(middle) + beyond)
        growth = fastest * reach * 0.5 * (rho - 1.0 / rho)
        most = parabola.curvature * (abs(middle - parabola.middle) + beyond) ** 2 + parabola.least
        count = float((1.0 + (np.log(4.0 * bound * most / (_ERROR * (rho - 1.0))) + growth) / np.log(rho)).min())
        if not count <= _MOST:
            raise ValueError(
                f"depth spans C_d from {low:.4g} to {high:.4g} rad, which takes {count:.4g} PSFs, more than {_MOST}"
            )
        # Angles are odd multiples of half of pi / n, and their cosines come again and again.
        odd = 2 * np.arange(math.ceil(count)) + 1
        cosines = np.cos(np.arange(4 * odd.size) * (0.5 * math.pi / odd.size))
        transform = cosines[np.outer(np.arange(odd.size), odd) % cosines.size] * (2.0 / odd.size)
        transform[0] *= 0.5
        at = middle + reach * cosines[odd]
        return cls(
            low, high, parabola, engine.product(transform, parabola(at)[:, None] * windows(at), threads), threads
        )

    def __call__(self, defocus: Array) -> tuple[Array, float]:
        """Return the windows at each defocus of the range, and a bound on their errors over their peaks."""
        made = self.values(defocus)
        return made, _ERROR / float((self.parabola(defocus) * made.max(axis=1)).min())

    def values(self, defocus: Array) -> Array:
        """Return the windows at each defocus of the range."""
        angle = np.arccos(np.clip((2.0 * defocus - self.low - self.high) / (self.high - self.low), -1.0, 1.0))
        basis = _cosines(angle, len(self.coefficients))
        basis /= self.parabola(defocus)
        return engine.product(np.ascontiguousarray(basis.T), self.coefficients, self.threads)

    def of_first(self, cells: int) -> Self:
        """Return the same for the first pixels alone."""
        return replace(self, coefficients=np.ascontiguousarray(self.coefficients[:, :cells]))

    def sums(self, weights: Array) -> Self:
        """Return the same for sums over the last pixels times weights, shape (sums, pixels)."""
        last = self.coefficients[:, self.coefficients.shape[1] - weights.shape[1] :]
        return replace(self, coefficients=np.ascontiguousarray(last @ weights.T))


def _cosines(angle: Array, count: int) -> Array:
    """Return the cosines of 0, 1, 2, ... times each angle, shape (count, n), from powers, which lose an ulp each."""
    powers = np.empty((count, angle.size), dtype=np.complex128)
    powers[0], known = 1.0, 1
    if count > 1:
        powers[1], known = np.exp(1j * angle), 2
    while known < count:
        more = min(known - 1, count - known)
        np.multiply(powers[1 : more + 1], powers[known - 1], out=powers[known : known + more])
        known += more
    return np.ascontiguousarray(powers.real)
