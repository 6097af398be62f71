r"""Quadrature over the frequencies along one axis that the largest transfer function of a disc weighs.

The transfer function of a pupil function of modulus at most 1 on the disc is at most the autocorrelation of the disc.
Summed along the other axis this is the autocorrelation m of the chords ``sqrt(1 - s^2)``,

.. math:: \int f(w)\, m(w)\, dw = \iint f(s - t) \sqrt{1 - s^2} \sqrt{1 - t^2}\, ds\, dt,

which Gauss's rules of Chebyshev polynomials of the second kind along s and t make a sum of few terms, exact for
polynomials f. Gauss's rule of m has fewest, of which even f need one half (Golub and Welsch 1969,
doi:10.1090/S0025-5718-69-99647-1), its recurrence by Stieltjes's procedure. The recurrence is that of w, not of
``w^2``: as m is even its Jacobi matrix has no diagonal, and its eigenvalues have the relative precision of its
entries (Demmel and Kahan 1990, doi:10.1137/0911052). Libraries find them to that of the largest one alone, by
kernels that differ between machines; a step of Newton's method makes all of them precise on every one.

What bounds the mean of a modulus is, by Schwarz's inequality, the mean of a square,

.. math:: \left(\int \lvert e \rvert\, m\, dw\right)^2 \le \int \frac mq\, dw \int q\, m\, e^2\, dw, \qquad
          q(w) = (1 - w^2 / 4)^2,

nearly without loss for filters, whose errors are largest at the end of the band. The first integral is 1.69765273.
"""

from __future__ import annotations

import math
from functools import lru_cache
from itertools import pairwise

import numpy as np

from lommel.base.arrays import Array

_OF_SHARE = 1.69766  # the integral of m / q, and 4e-6 of it for the rounding of the rule


@lru_cache(maxsize=16)
def modulus_rule(degree: int) -> tuple[Array, Array]:
    """Return w from 0 to 2 and weights, by which the root of the sum of squares bounds the mean modulus.

    Of polynomials of this `degree` in w, even or odd.
    """
    w, weights = transfer_rule(degree + 2)
    return w, _OF_SHARE * (1.0 - 0.25 * w * w) ** 2 * weights


@lru_cache(maxsize=16)
def transfer_rule(degree: int) -> tuple[Array, Array]:
    """Return w from 0 to 2, and weights of sum 1, exact for even polynomials of w up to twice this even `degree`."""
    from scipy.linalg import eigvalsh_tridiagonal

    count, angle = degree + 1, math.pi / (degree + 2)
    one, other = np.meshgrid(np.arange(1, count + 1), np.arange(1, count + 1), indexing="ij")
    # Of pairs with the same distance, one.
    first = (one <= other) & (one + other <= count + 1)
    one, other = one[first], other[first]
    alike = np.where(one == other, 1.0, 2.0) * np.where(one + other == count + 1, 1.0, 2.0)
    # The polynomials are even and odd by turns: w of one sign will do.
    w = 2.0 * np.sin(0.5 * angle * (one + other)) * np.sin(0.5 * angle * (other - one))
    p = np.sqrt(alike) * np.sin(angle * one) * np.sin(angle * other)
    beside = np.zeros(degree + 3)
    before, p = np.zeros_like(p), p / math.sqrt((p * p).sum())
    for k in range(degree + 2):
        after = w * p - beside[k] * before
        beside[k + 1] = math.sqrt((after * after).sum())
        before, p = p, after / beside[k + 1]
    nodes = eigvalsh_tridiagonal(np.zeros(degree + 2), beside[1:-1])[degree // 2 + 1 :]
    nodes -= _newton(nodes, beside)[0]
    return nodes, 2.0 / _newton(nodes, beside)[1]


def _newton(w: Array, beside: Array) -> tuple[Array, Array]:
    """Return the last orthonormal polynomial over its derivative, and the sum of the squares of the others."""
    before, p, squares = np.zeros_like(w), np.ones_like(w), np.zeros_like(w)
    slope_before, slope = np.zeros_like(w), np.zeros_like(w)
    for last, after in pairwise(beside):
        squares += p * p
        slope_before, slope = slope, (p + w * slope - last * slope_before) / after
        before, p = p, (w * p - last * before) / after
    return p / slope, squares
