r"""The phase of defocus of a lens that obeys the sine condition, and its expansion in radial Zernike terms.

A wave converges to (or comes from) a point of the axis; the reference sphere has its centre in another. Both pass
through the vertex of the pupil, the wave with the curvature a + delta where the sphere has a. A point of the sphere
at the height h from the axis is ``a p`` closer to the centre along the axis than the vertex, and its distance from
the centre of the wave, less that of the vertex, is by elementary geometry

``W(h) = 2 p delta / (1 + sqrt(1 + 2 p (a + delta) delta)), p = h^2 / (1 + sqrt(1 - a^2 h^2)) .``

The sine condition makes h proportional to rho. W is then a function of t = rho^2 with branch points only, and the
farther these are from [0, 1], the faster a series of Chebyshev polynomials falls; Legendre polynomials of 2t - 1, the
radially symmetric Zernike terms, hold the same polynomial.

References
----------
M. Born and E. Wolf, *Principles of Optics*, 7th ed., sections 4.5 (the conditions of Abbe and Herschel) and 5.1 (the
aberration function).
L. N. Trefethen, *Approximation Theory and Approximation Practice* (SIAM, 2013), Theorems 8.1 and 8.2.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from lommel.base.arrays import Array
from lommel.optics.wavefront.wavefront import Wavefront, symmetric_terms
from lommel.special import zernike

_DEGREE = 80  # of the series that is cut
_LEAST, _MOST = 2, zernike.MAX_DEGREE // 2  # terms that are kept
_ROUNDING = 2.0**-47


@lru_cache(maxsize=4)
def _chebyshev_to_legendre(degree: int) -> Array:
    """Return the coefficients of P_j in T_k, shape ``(degree + 1, degree + 1)``, [k, j].

    B. K. Alpert and V. Rokhlin, SIAM J. Sci. Stat. Comput. 12, 158 (1991), Eq. 2.20, doi:10.1137/0912009.
    """
    ratio = [math.sqrt(math.pi), 2.0 / math.sqrt(math.pi)]  # Gamma(z + 1/2) / Gamma(z + 1) at z = 0, 1/2, ...
    for i in range(2, 2 * degree + 1):
        ratio.append(ratio[i - 2] * (i - 1) / i)
    found = np.zeros((degree + 1, degree + 1))
    found[0, 0] = 1.0
    for k in range(1, degree + 1):
        found[k, k] = 0.5 * math.sqrt(math.pi) / ratio[2 * k]
        for j in range(k - 2, -1, -2):
            found[k, j] = -k * (j + 0.5) * ratio[k - j - 2] / (k - j) * ratio[k + j - 1] / (k + j + 1)
    return found


def path(t: Array, radius: float, sphere: float, vergence: Array) -> Array:
    """Return the path difference W at ``rho^2 = t``, metres.

    Parameters
    ----------
    t : ndarray, shape (t,)
    radius : float
        Of the pupil, metres.
    sphere : float
        Curvature a of the reference sphere, 1/metres: positive where light diverges from its centre.
    vergence : ndarray, shape (n,)
        Difference delta of the curvature of the wave, 1/metres.

    Returns
    -------
    ndarray, shape (n, t)
        Metres.
    """
    square = radius**2 * t
    p = square / (1.0 + np.sqrt(1.0 - sphere**2 * square))
    delta = vergence[:, None]
    return np.asarray(2.0 * p * delta / (1.0 + np.sqrt(1.0 + 2.0 * p * (sphere + delta) * delta)))


def growth(radius: float, sphere: float, vergence: float) -> float:
    """Bound the range of Im W across the pupil per Im delta, metres^2, for ``|delta| <= vergence``; may be infinite.

    With ``w = 2 p (a + delta) delta``, ``W = p delta g(w)`` and ``g(w) = 2 / (1 + sqrt(1 + w))``, whose series
    alternates: on ``|w| <= q < 1``, ``|g - 1|`` and ``|g'|`` are largest at -q.
    """
    p = radius**2 / (1.0 + math.sqrt(1.0 - (sphere * radius) ** 2))
    q = 2.0 * p * (abs(sphere) + vergence) * vergence
    if not q < 1.0:
        return math.inf
    root = math.sqrt(1.0 - q)
    slope = 2.0 * p * (abs(sphere) + 2.0 * vergence) / (root * (1.0 + root) ** 2)
    e = 2.0 / (1.0 + root) - 1.0 + vergence * slope
    return p * max(1.0 + e, 2.0 * e)


def expansion(radius: float, sphere: float, vergence: Array, wavelength: float) -> tuple[Array, float]:
    """Return the phase ``2 pi W / wavelength`` as coefficients of R_2^0, R_4^0, ..., and a bound on their error.

    At most thirty terms of a series of degree 80 are kept. The bound, radians, is the sum of the terms cut off, the
    truncation of the series and rounding; the constant phase does not count.

    Parameters
    ----------
    radius, sphere, vergence
        As of :func:`lommel.optics.wavefront.aplanatic.path`.
    wavelength : float
        Metres.

    Returns
    -------
    coefficients : ndarray, shape (n, k)
    error : float
        The largest of the stack.

    Raises
    ------
    ValueError
        If the sine of the rim would be 1 or more, or if the object is so close that the phase has no expansion.
    """
    wavenumber = 2.0 * math.pi / wavelength
    size = float(np.abs(vergence).max())
    with np.errstate(over="ignore"):  # refused below
        bend = 2.0 * float(np.abs((sphere + vergence) * vergence).max())
    nearest = radius**2 * max(sphere**2, bend)  # one over the t within which neither root can vanish
    if nearest >= 1.0:
        if radius * abs(sphere) >= 1.0:
            reason = f"the sine of the angle of its rim would be {radius * abs(sphere):.4g}"
        else:
            reason = "the object is so close that the phase has no expansion in powers of rho^2"
        raise ValueError(f"model 'aplanatic' is not possible: {reason}")
    angle = (np.arange(_DEGREE + 1, dtype=np.float64) + 0.5) * (math.pi / (_DEGREE + 1))
    values = wavenumber * path(0.5 + 0.5 * np.cos(angle), radius, sphere, vergence)
    series = values @ np.cos(np.outer(angle, np.arange(_DEGREE + 1))) * (2.0 / (_DEGREE + 1))
    series[:, 0] *= 0.5
    # On the ellipse through t = 1 / nearest both roots have a positive real part, hence |W| <= 2 R^2 |t| delta.
    reach = 1.0 / max(nearest, 1e-6)
    ellipse = 2.0 * reach - 1.0 + 2.0 * math.sqrt(reach * (reach - 1.0))
    beyond = 8.0 * wavenumber * radius**2 * reach * size * ellipse**-_DEGREE / (ellipse - 1.0)
    total = np.abs(series).sum(axis=1).max()
    tails = np.abs(series[:, ::-1]).cumsum(axis=1)[:, ::-1].max(axis=0)  # from each term on
    enough = 4.0 * _ROUNDING * total  # what roundings of the series leave is less
    degree = next((k for k in range(_LEAST, _MOST) if tails[k + 1] <= enough), _MOST)
    terms = series[:, : degree + 1] @ _chebyshev_to_legendre(degree)
    rounding = _ROUNDING * (total + np.abs(terms).sum(axis=1).max())
    return terms[:, 1:], float(tails[degree + 1] + beyond + rounding) if size else 0.0


def wavefront(radius: float, sphere: float, vergence: Array, wavelength: float) -> Wavefront:
    """Return the phase ``2 pi W / wavelength`` as a stack of the shape of `vergence`; see :func:`expansion`."""
    edge, error = expansion(radius, sphere, vergence.ravel(), wavelength)
    return Wavefront.trusted(symmetric_terms(edge.shape[-1]), edge.reshape(*vergence.shape, -1), error)
