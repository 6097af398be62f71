r"""Quadrature over the frequencies along one axis, that bounds what an error of the response costs averages.

The transfer function of a pupil function of modulus at most 1 on the disc is at most the autocorrelation of the disc.
Summed along the other axis this is the autocorrelation m of the chords ``sqrt(1 - s^2)``, of integral 1, and at most

.. math:: m(w) \le \frac{16}{3 \pi^2}\, y^2, \qquad y = 1 - w^2 / 4,

with equality at w = 0. By Schwarz's inequality, as the integral of the root of y is pi,

.. math:: \left(\int \lvert e \rvert\, m\, dw\right)^2
          \le \left(\frac{16}{3 \pi^2}\right)^2 \pi \int \sqrt{y}\, y^3\, e^2\, dw,

nearly without loss for filters, whose errors are largest at the end of the band. Of polynomials Gauss's rule of
Chebyshev polynomials of the second kind has the integral exactly.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from lommel.base.arrays import Array


def band_points(reach: float) -> Array:
    """Return Chebyshev points of the band, at which the error of the response of samples up to a distance is found.

    It is even or odd, and entire, of type T, the `reach`; all but 1e-17 of it is a polynomial in w of degree
    ``M = 2.36 T + 48`` (its Chebyshev series falls below ``e^-48`` there), M being the number of points. As a
    trigonometric polynomial of the angle it falls from its largest value no faster than ``cos(M s)`` (Duffin and
    Schaeffer, Bull. Amer. Math. Soc. 44, 236, 1938), and one of 2 M Chebyshev points is within ``pi / (4 M)`` of it:
    it is at most sqrt(2) times as large as at these.
    """
    degree = math.ceil(2.36 * reach) + 48
    return np.asarray(2.0 * np.cos((np.arange(degree) + 0.5) * (0.5 * math.pi / degree)))


@lru_cache(maxsize=16)
def mean_rule(degree: int) -> tuple[Array, Array]:
    """Return w from 0 to 2 and weights, by which the root of the sum of squares bounds the mean modulus.

    Of polynomials up to this `degree` in w, even or odd.
    """
    count = 2 * math.ceil(0.5 * degree + 2.0)
    angle = np.arange(1, count // 2 + 1) * (math.pi / (count + 1))
    # Of w = 2 cos(angle) on either side, dw being 2 dcos.
    factor = (16.0 / (3.0 * math.pi**2)) ** 2 * math.pi * 4.0 * math.pi / (count + 1)
    return 2.0 * np.cos(angle), factor * np.sin(angle) ** 8
