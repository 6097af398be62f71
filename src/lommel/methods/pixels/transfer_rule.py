r"""Quadrature over the frequencies along one axis that the largest transfer function of a disc weighs.

The transfer function of a pupil function of modulus at most 1 on the disc is at most the autocorrelation of the disc.
Summed along the other axis this is the autocorrelation m of the chords ``sqrt(1 - s^2)``,

.. math:: \int f(w)\, m(w)\, dw = \iint f(s - t) \sqrt{1 - s^2} \sqrt{1 - t^2}\, ds\, dt,

which Gauss's rules of Chebyshev polynomials of the second kind along s and t make a sum of few terms, exact for
polynomials f. Of even f a rule in ``w^2`` has their least number (Golub and Welsch 1969,
doi:10.1090/S0025-5718-69-99647-1), its recurrence by Stieltjes's procedure.

What bounds the mean of a modulus is, by Schwarz's inequality, the mean of a square,

.. math:: \left(\int \lvert e \rvert\, m\, dw\right)^2 \le \int \frac mq\, dw \int q\, m\, e^2\, dw, \qquad
          q(w) = (1 - w^2 / 4)^2,

nearly without loss for filters, whose errors are largest at the end of the band. The first integral is 1.6977.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from lommel.base.arrays import Array

_OF_SHARE = 1.69766  # the integral of m / q, a little more


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
    from scipy.linalg import eigh_tridiagonal

    count, angle = degree + 1, math.pi / (degree + 2)
    one, other = np.meshgrid(np.arange(1, count + 1), np.arange(1, count + 1), indexing="ij")
    # Of pairs with the same distance, one.
    first = (one <= other) & (one + other <= count + 1)
    one, other = one[first], other[first]
    alike = np.where(one == other, 1.0, 2.0) * np.where(one + other == count + 1, 1.0, 2.0)
    u = (2.0 * np.sin(0.5 * angle * (one + other)) * np.sin(0.5 * angle * (one - other))) ** 2
    p = np.sqrt(alike) * np.sin(angle * one) * np.sin(angle * other)
    nodes = degree // 2 + 1
    mean, beside = np.zeros(nodes), np.zeros(nodes + 1)
    before, p = np.zeros_like(p), p / np.linalg.norm(p)
    for k in range(nodes):
        mean[k] = u @ (p * p)
        after = (u - mean[k]) * p - beside[k] * before
        beside[k + 1] = np.linalg.norm(after)
        before, p = p, after / beside[k + 1]
    squares, vectors = eigh_tridiagonal(mean, beside[1:nodes])
    weights = vectors[0] ** 2
    return np.sqrt(np.maximum(squares, 0.0)), np.asarray(weights / weights.sum())
