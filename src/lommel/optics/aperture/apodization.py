r"""The amplitude across the pupil: ``exp(-(g_0 + g_1 t + ... + g_K t^K))``, t = rho^2, at most 1.

The amplitude ``cos(theta)^p`` with ``sin(theta) = s rho`` is ``(1 - s^2 t)^(p/2)``. Its logarithm is a Chebyshev
series in x = 2t - 1 whose terms fall like q^k. With ``q = (1 - cos) / (1 + cos)``, where cos is the cosine of theta
at the rim of the pupil (rho = 1),

``(1 - s^2 t) (1 + q)^2 = 1 - 2 q x + q^2,  log(1 - 2 q x + q^2) = -2 sum_(k>=1) q^k T_k(x) / k .``

The remainder of the logarithm of the amplitude after the term K is at most ``abs(p) q^(K+1) / ((K+1) (1 - q))``.

References
----------
J. C. Mason and D. C. Handscomb, *Chebyshev Polynomials* (Chapman and Hall, 2003), section 5.2 (generating functions).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Json
from lommel.special.legendre import gauss_legendre

_MAX_POWERS = 10  # largest power of t: the limit of the compiled core and of radial terms of a wavefront
_MAX_EXPONENT = 100.0  # largest sum of absolute Chebyshev coefficients of the exponent
_ROUNDING = 2.0**-47  # relative rounding error of sums of the coefficients, with a margin


@dataclass(frozen=True)
class Apodization:
    """An amplitude ``exp(-(g_0 + g_1 t + g_2 t^2 + ...))`` across the pupil, t = rho^2, whose largest value is 1.

    Parameters
    ----------
    powers : sequence of float
        Coefficients g_1, g_2, ...: at most ten. g_0 is computed so that the largest amplitude on the disk is 1.
    error : float, default 0
        Bound on the relative error of the amplitude, apart from a constant factor. It contributes to
        `PSF.error_bound`.

    Attributes
    ----------
    exponent : ndarray
        g_0, g_1, ...

    Raises
    ------
    TypeError, ValueError
        If a number is not finite, or the Chebyshev coefficients of the exponent sum to more than 100.

    Examples
    --------
    >>> edge = Apodization([0.0, 0.0, 1.0])  # exp(-rho^6)
    >>> float(edge.value(1.0)) == math.exp(-1.0)
    True
    """

    powers: tuple[float, ...] = ()
    error: float = field(default=0.0, kw_only=True)
    exponent: Array = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        # + 0.0 turns -0 into 0, so that equal amplitudes are equal keys of caches.
        powers = [float(g) + 0.0 for g in validation.real_array("powers", self.powers).ravel()]
        while powers and powers[-1] == 0.0:
            powers.pop()
        if len(powers) > _MAX_POWERS:
            raise ValueError(f"powers must have at most {_MAX_POWERS} coefficients, got {len(powers)}")
        largest = max(map(abs, powers), default=0.0)
        # Powers above 1e11 have Chebyshev coefficients above the limit, whose computation might overflow.
        exponent = np.array([0.0 if largest > 1e11 else _constant(powers), *powers])
        size = largest if largest > 1e11 else float(np.abs(_chebyshev(exponent, 0.0)).sum())
        if not size <= _MAX_EXPONENT * (1.0 + 1e-12):
            raise ValueError(f"powers must lead to an exponent of at most {_MAX_EXPONENT:g}, got {size:.4g}")
        error = validation.real("error", self.error, least=0.0)
        exponent.setflags(write=False)
        # NumPy arrays are not hashable: the dataclass compares the tuple `powers`, and not `exponent`.
        vars(self).update(powers=tuple(powers), error=error, exponent=exponent)

    @classmethod
    def gaussian(cls, g: float) -> Apodization:
        """Return ``exp(-g rho^2)``, `g` from 0 to 100; TypeError or ValueError otherwise."""
        return _gaussian(validation.real("g", g, least=0.0, most=_MAX_EXPONENT + 1e-9))

    @classmethod
    def cosine(cls, sine: float, power: float) -> Apodization:
        """Return ``cos(theta)^power`` divided by its maximum, ``sin(theta) = sine * rho``, `sine` 0 to below 1.

        The exponent is a series in rho^2 of at most ten terms; `error` bounds the truncation and rounding errors.
        TypeError or ValueError if the sine or the `power` is out of range.
        """
        s = validation.real("sine", sine, least=0.0, below=1.0)
        p = validation.real("power", power)
        cosine = math.sqrt((1.0 - s) * (1.0 + s))
        q = s * s / (1.0 + cosine) ** 2  # (1 - cos) / (1 + cos)
        if p == 0.0 or q == 0.0:
            return cls()
        from numpy.polynomial import Chebyshev, Polynomial

        k = np.arange(1, _MAX_POWERS + 1)
        # Series of log(1 - 2 q x + q^2) and its tail: certificate, section 5, "An amplitude".
        series = p * q**k / k
        tails = np.abs(p) * q ** (k + 1) / ((k + 1) * (1.0 - q))
        # Number of terms: the fewest with a truncation error below rounding errors, ten at most.
        degree = 1 + next((i for i in range(_MAX_POWERS) if tails[i] <= _ROUNDING * abs(series[0])), _MAX_POWERS - 1)
        # Coefficients of t^j in T_k(2t - 1): integers, exact.
        rows = [Chebyshev.basis(i, domain=[0.0, 1.0]).convert(kind=Polynomial).coef for i in range(degree + 1)]
        matrix = np.stack([np.pad(row, (0, degree + 1 - row.size)) for row in rows])
        powers = np.concatenate(([0.0], series[:degree])) @ matrix
        log_error = float(tails[degree - 1] + _ROUNDING * np.abs(powers).sum())
        # An error e of the logarithm is a relative error of at most exp(e) - 1 of the amplitude.
        return cls(tuple(powers[1:].tolist()), error=math.expm1(min(log_error, _MAX_EXPONENT)))

    @classmethod
    def zernike(cls, terms: Mapping[int, float]) -> Apodization:
        """Return ``exp(sum of terms[n] (n + 1)^(1/2) R_n^0(rho))`` divided by its maximum.

        Parameters
        ----------
        terms : mapping of int to float
            Coefficients (nepers rms over the full pupil) by degree n = 2, 4, ..., 20.

        Raises
        ------
        TypeError, ValueError
            If a degree is not an even number from 2 to 20, or the exponent is too large (see the class).
        """
        from numpy.polynomial import Legendre, Polynomial

        validation.instance("terms", terms, Mapping)
        series = np.zeros(_MAX_POWERS + 1)
        for n, b in terms.items():
            degree = validation.integer("degrees of terms", n, least=2, most=2 * _MAX_POWERS)
            if degree % 2:
                raise ValueError(f"degrees of terms must be even, got {degree}")
            series[degree // 2] = math.sqrt(degree + 1.0) * validation.real(f"terms[{degree}]", b)
        # R_2j^0(rho) = P_j(2 t - 1), a Legendre polynomial. The minus sign: the amplitude is exp(-exponent).
        powers = Legendre(series, domain=[0.0, 1.0]).convert(kind=Polynomial).coef
        return cls(tuple((-powers[1:]).tolist()))

    def to_zernike(self) -> dict[int, float]:
        """Return the coefficients by degree, as :meth:`zernike` expects them, without zeros."""
        from numpy.polynomial import Legendre, Polynomial

        series = Polynomial([0.0, *self.powers]).convert(kind=Legendre, domain=[0.0, 1.0]).coef
        terms = {2 * j: -float(c) / math.sqrt(2.0 * j + 1.0) for j, c in enumerate(series) if j}
        return {n: b for n, b in terms.items() if b}

    @property
    def uniform(self) -> bool:
        """True if the amplitude is 1 everywhere."""
        return not self.powers

    @property
    def slope(self) -> float:
        """Bound on the derivative of the exponent with respect to t; determines numbers of quadrature nodes."""
        return float(sum(k * abs(g) for k, g in enumerate(self.powers, 1)))

    def value(self, rho: ArrayLike) -> Array:
        """Return the amplitude at `rho`, radii divided by the aperture radius; ValueError unless from 0 to 1."""
        radii = validation.real_array("rho", rho, least=0.0, most=1.0)
        return self.at(radii * radii)

    def at(self, t: Array, power: float = 1.0) -> Array:
        """Return the amplitude to a `power` at `t`, rho^2."""
        return np.asarray(np.exp(-power * self.exponent_at(t)))

    def exponent_at(self, t: Array) -> Array:
        """Return ``g_0 + g_1 t + ...`` at `t`, rho^2."""
        total = np.full(np.shape(t), self.exponent[-1])
        for g in self.exponent[-2::-1]:
            total = total * t + g
        return np.asarray(total)

    def integral(self, obscuration: float = 0.0, power: float = 1.0) -> float:
        """Return the integral over t of the amplitude to a `power` from `obscuration` squared to 1, to 1e-14."""
        low = obscuration**2
        area = 1.0 - low
        # A Gaussian has a closed form, with the area as its limit for g = 0.
        if len(self.powers) > 1 or self.exponent[0]:
            t, weight = gauss_legendre(24 + math.ceil(0.5 * power * self.slope), low, 1.0)
            return float(weight @ self.at(t, power))
        g = power * self.slope
        return area if g < 1e-12 else math.exp(-g * low) * -math.expm1(-g * area) / g

    def growth(self, cosh: Array, low: float = 0.0) -> Array:
        """Return a bound on ``log(abs(amplitude))`` for complex t in Bernstein ellipses with foci `low` and 1.

        `cosh` are the major semi-axes of the ellipses, divided by half of the distance between the foci.
        """
        # For a Chebyshev series a_k of the exponent: |T_k| <= T_k(cosh) on the ellipse, so that the log amplitude is
        # at most -a_0 + sum of |a_k| T_k(cosh) over k >= 1.
        from numpy.polynomial.chebyshev import chebval

        series = _chebyshev(self.exponent, low)
        return np.asarray(chebval(cosh, np.concatenate(([-series[0]], np.abs(series[1:])))))

    def scaled(self, ratio: float) -> Apodization:
        """Return the apodization of the aperture stopped down to `ratio` of its radius (0 to 1), with maximum 1."""
        area = validation.real("ratio", ratio, above=0.0, below=1.0 + 1e-12) ** 2
        return Apodization(tuple(g * area**k for k, g in enumerate(self.powers, 1)), error=self.error)

    def to_dict(self) -> Json:
        """Return the parameters in plain types; :meth:`from_dict` is the inverse."""
        return {"powers": list(self.powers), "error": self.error}

    @classmethod
    def from_dict(cls, description: Json) -> Apodization:
        """Rebuild an apodization from a `description` by :meth:`to_dict`."""
        return cls(tuple(description["powers"]), error=description["error"])


def _constant(powers: list[float]) -> float:
    """Return the smallest g_0 for which the exponent is nowhere negative for t in [0, 1], plus rounding errors."""
    # An amplitude that decreases with t is largest on the axis, where the exponent is g_0.
    if all(g >= 0.0 for g in powers):
        return 0.0
    from numpy.polynomial.chebyshev import chebder, chebroots, chebtrim, chebval

    series = _chebyshev(np.array([0.0, *powers]), 0.0)
    slope = chebder(series)
    # Leading coefficients below rounding are trimmed, since they would move all roots.
    extrema = np.clip(chebroots(chebtrim(slope, 1e-17 * float(np.abs(slope).sum()))).real, -1.0, 1.0)
    lowest = float(chebval(np.concatenate(([-1.0, 1.0], extrema)), series).min())
    # Rounding moves the root of a flat minimum, but hardly changes the value there.
    return max(0.0, -lowest) + _ROUNDING * sum(k * abs(g) for k, g in enumerate(powers, 1))


def _chebyshev(powers: Array, low: float) -> Array:
    """Return the Chebyshev coefficients on ``[low, 1]`` of a polynomial, given its coefficients of 1, t, t^2, ..."""
    if len(powers) < 2:
        return powers
    from numpy.polynomial import Polynomial  # the slowest part of NumPy to import
    from numpy.polynomial.chebyshev import poly2cheb

    shifted = Polynomial(powers)(Polynomial([0.5 * (1.0 + low), 0.5 * (1.0 - low)]))
    return np.asarray(poly2cheb(shifted.coef))


@lru_cache(maxsize=64)
def _gaussian(g: float) -> Apodization:
    return Apodization((g,))


def illumination(apodization: float | Apodization) -> Apodization:
    """Convert the argument `apodization` of a pupil; a number is the g of a Gaussian. TypeError or ValueError."""
    if isinstance(apodization, Apodization):
        return apodization
    return _gaussian(validation.real("apodization", apodization, least=0.0, most=_MAX_EXPONENT + 1e-9))
