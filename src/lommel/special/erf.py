"""Error function on the rays at +-45 degrees of the complex plane, by three algorithms, for the paper's closed form.

``erf(e^{-i pi/4} s)`` with real s is a pair of real Fresnel integrals:
``int_0^s exp(i tau^2) d tau = (sqrt(pi)/2) e^{i pi/4} erf(e^{-i pi/4} s)`` (DLMF 7.5.8).
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core import engine
from lommel.special.legendre import gauss_legendre

HALF = 0.5 * math.sqrt(math.pi) * np.exp(0.25j * math.pi)
"""``int_0^inf exp(i tau^2) d tau``."""


def fresnel_auxiliary(s: ArrayLike) -> NDArray[np.complex128]:
    """Return ``G(s) = exp(-i s^2) int_s^inf exp(i tau^2) d tau`` for ``s >= 0``.

    ``G(s) = (sqrt(pi)/2) e^{i pi/4} w(e^{i pi/4} s)`` with the Faddeeva function w (DLMF 7.5.8-10);
    G is smooth, and about ``i / (2s)`` at large s. The relative error is about 1e-13.

    Parameters
    ----------
    s : array_like
        >= 0.

    Returns
    -------
    ndarray of complex
    """
    return np.asarray(HALF * scipy.special.wofz(np.exp(0.25j * math.pi) * np.asarray(s, dtype=np.float64)))


_RAY = np.exp(-0.25j * math.pi)  # direction of the ray
# Empty table, for evaluations without a table in the compiled core.
_NO_TABLE = np.empty(0, dtype=np.complex128)


class Erf(ABC):
    """Evaluation of ``erf(e^{-i pi/4} s)`` for real s."""

    @abstractmethod
    def auxiliary(self, s: Array) -> NDArray[np.complex128]:
        """Return ``G(s) = exp(-i s^2) int_s^inf exp(i tau^2) d tau`` for `s` >= 0."""

    @property
    def compiled(self) -> tuple[int, NDArray[np.complex128]]:
        """Arguments of the compiled core: number of terms of Eq. (14), and table; by default 0 and an empty table."""
        return 0, _NO_TABLE

    def on_ray(self, s: ArrayLike) -> NDArray[np.complex128]:
        """Return ``erf(e^{-i pi/4} s)`` for real `s` of either sign."""
        x = _arguments(s)
        # erf is odd, and G is defined for s >= 0.
        r = np.abs(x)
        return np.asarray(np.where(x < 0, -1.0, 1.0) * (1.0 - np.exp(1j * r**2) * self.auxiliary(r) / HALF))


def _arguments(s: ArrayLike) -> Array:
    argument = validation.real_array("s", s)
    # s^2 must not overflow.
    if argument.size and np.abs(argument).max() > 1e150:
        raise ValueError(f"s must be at most 1e150, got {np.abs(argument).max():g}")
    return argument


@dataclass(frozen=True)
class FresnelErf(Erf):
    """Error function with an error of about 1e-13, by the Faddeeva function."""

    def auxiliary(self, s: Array) -> NDArray[np.complex128]:
        """Return G(s) for ``s >= 0``."""
        return fresnel_auxiliary(s)


@dataclass(frozen=True)
class TableErf(Erf):
    """Error function by a lookup table with linear interpolation, as the paper proposes.

    The table contains ``(s + 2) G(s)`` as a function of ``s / (s + 2)``, which is smooth up to infinite s, unlike erf
    itself. The error is at most about ``0.6 / samples**2``.

    Parameters
    ----------
    samples : int, default 4096
        Length of the table, 2 to 10 million.

    Raises
    ------
    TypeError, ValueError
        If `samples` is out of range.
    """

    samples: int = 4096

    def __post_init__(self) -> None:
        object.__setattr__(self, "samples", validation.integer("samples", self.samples, least=2, most=10**7))

    @property
    def compiled(self) -> tuple[int, NDArray[np.complex128]]:
        """No terms, and the table."""
        return 0, _table(self.samples)[1]

    def auxiliary(self, s: Array) -> NDArray[np.complex128]:
        """Return G(s) for ``s >= 0`` from the table."""
        # (s + 2) G(s) is smooth and falls from 2 G(0) to i / 2, so that linear interpolation suffices.
        grid, table = _table(self.samples)
        values = np.interp(s / (s + 2.0), grid, table)
        return np.asarray(values / (s + 2.0))


@lru_cache(maxsize=4)
def _table(samples: int) -> tuple[Array, NDArray[np.complex128]]:
    # y = s / (s + 2), from 0 to 1 for s from 0 to infinity; (s + 2) G(s) tends to i / 2.
    y = np.linspace(0.0, 1.0, samples)
    s = 2.0 * y[:-1] / (1.0 - y[:-1])
    return y, np.append((s + 2.0) * fresnel_auxiliary(s), 0.5j)


@dataclass(frozen=True)
class AbramowitzErf(Erf):
    """Error function by the truncated series of the paper's Eq. (14), Abramowitz and Stegun 7.1.29.

    The largest term is at ``n = 2 abs(Im z)``: N terms suffice only if ``abs(Im z)`` is below about ``N/2 - 3``.
    For larger ``abs(Im z)`` the result approaches the real error function, which causes the outer rings in the
    paper's figures.

    Parameters
    ----------
    terms : int, default 10
        N of Eq. (14), 1 to 100000.

    Raises
    ------
    TypeError, ValueError
        If `terms` is out of range.
    """

    terms: int = 10

    def __post_init__(self) -> None:
        object.__setattr__(self, "terms", validation.integer("terms", self.terms, least=1, most=100_000))

    @property
    def compiled(self) -> tuple[int, NDArray[np.complex128]]:
        """The number of terms, and no table."""
        return self.terms, _NO_TABLE

    def __call__(self, z: ArrayLike) -> NDArray[np.complex128]:
        """Return Eq. (14) at complex z, with every exponential scaled so that no factor overflows.

        Raises
        ------
        OverflowError
            If the value itself, about ``exp(Im(z)^2 - Re(z)^2)``, exceeds the range of doubles.
        """
        argument = validation.array("z", z)
        is_numeric = argument.dtype.kind in "iufc"
        with np.errstate(over="ignore"):  # a long double beyond the range becomes infinite: TypeError
            argument = argument.astype(np.complex128) if is_numeric else argument
        if not is_numeric or not np.all(np.isfinite(argument)):
            raise TypeError(f"z must hold finite numbers, got {validation.shown(z)}")
        # erf is odd; the formula is used for x >= 0.
        sign = np.where(argument.real < 0, -1.0, 1.0)
        x, y = sign * argument.real, sign * argument.imag
        # Intermediate products may overflow although the sum does not; the sum itself is checked at the end.
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            xy2 = 2.0 * x * y
            decay = np.exp(-x * x)
            # (1 - cos 2xy + i sin 2xy) / (2 pi x), with the limit i y / pi at x = 0.
            quotient = np.where(x > 1e-150, (2.0 * np.sin(0.5 * xy2) ** 2 + 1j * np.sin(xy2)) / (2.0 * np.pi * x), 0)
            total = scipy.special.erf(x) + decay * np.where(x > 1e-150, quotient, 1j * y / np.pi)
            cos, sin = np.cos(xy2), np.sin(xy2)
            for n in range(1, self.terms + 1):
                unit = np.exp(-0.25 * n * n - x * x)
                rise = np.exp(n * np.abs(y) - 0.25 * n * n - x * x)
                fall = np.exp(-n * np.abs(y) - 0.25 * n * n - x * x)
                cosh = 0.5 * (rise + fall)
                sinh = np.sign(y) * 0.5 * (rise - fall)
                f = 2.0 * x * unit - 2.0 * x * cosh * cos + n * sinh * sin
                g = 2.0 * x * cosh * sin + n * sinh * cos
                total = total + 2.0 / np.pi * (f + 1j * g) / (n * n + 4.0 * x * x)
        if not np.all(np.isfinite(total)):
            raise OverflowError(f"Eq. (14) overflows doubles at z={argument[~np.isfinite(total)].flat[0]}")
        return np.asarray(sign * total)

    def on_ray(self, s: ArrayLike) -> NDArray[np.complex128]:
        """Return Eq. (14) at ``e^{-i pi/4} s``."""
        return self(_RAY * _arguments(s))

    def auxiliary(self, s: Array) -> NDArray[np.complex128]:
        """Return G(s) for ``s >= 0`` as the complement of Eq. (14)."""
        return np.asarray(HALF * (1.0 - self.on_ray(s)) * np.exp(-1j * s * s))


def chirp_moments(
    a: float, b: ArrayLike, low: ArrayLike, high: ArrayLike, *, erf: Erf | None = None
) -> NDArray[np.complex128]:
    r"""Return ``int_low^high R^m exp(i (a R^2 + b R)) dR`` for m = 0, 1, 2 (compiled).

    The m = 0 moment is the error function of the paper's Eq. (13); the others follow by parts:
    ``M_1 = [e]/(2ia) - (b/2a) M_0`` and ``M_2 = [R e]/(2ia) - M_0/(2ia) - (b/2a) M_1``, with e the integrand for m =
    0. The error function is expressed by its non-oscillating part G, so that no phase b^2/4a of a distant stationary
    point appears. For ``abs(a) (high - low)^2 < 0.1`` these formulas cancel: the factor exp(i a R^2) is then expanded
    in powers of R, and the moments of the linear wave follow by parts, exact to rounding.

    Parameters
    ----------
    a : float
        Curvature of the phase, positive, negative or zero.
    b, low, high : array_like
        Slope and limits, ``low <= high``, broadcast together.
    erf : Erf, default FresnelErf()

    Returns
    -------
    ndarray of complex, shape ``(3,) + b.shape``
    """
    parts = np.broadcast_arrays(*(np.asarray(x, dtype=np.float64) for x in (b, low, high)))
    slope, start, end = (np.ascontiguousarray(x).ravel() for x in parts)
    values = engine.chirp_moments(float(a), slope, start, end, *(erf or FresnelErf()).compiled)
    return values.reshape(3, *parts[0].shape)


def unit_moments(phase: Array, count: int) -> NDArray[np.complex128]:
    r"""Return ``int_0^1 x^(2m+1) exp(i phase x^2) dx`` for m = 0, ..., count-1.

    With u = x^2, the integral is ``J_m = int_0^1 u^m e^{i phase u} du / 2``. Large phases use the recurrence
    ``J_m = (e^{i phase}/2 - m J_{m-1}) / (i phase)``, which cancels for small phases; small phases use quadrature.

    Parameters
    ----------
    phase : ndarray
        Radians.
    count : int

    Returns
    -------
    ndarray of complex, shape ``(count,) + phase.shape``
    """
    modulus = np.abs(phase)
    moments = np.empty((count, *phase.shape), dtype=np.complex128)
    # The recurrence multiplies errors by m / phase at each step.
    is_small = modulus <= max(32.0, 2.0 * count)
    if np.any(is_small):
        u, w = gauss_legendre(24 + count // 2 + int(modulus[is_small].max()))
        wave = 0.5 * w * np.exp(1j * phase[is_small][:, None] * u)
        for m in range(count):
            moments[m, is_small] = wave.sum(axis=1)
            wave = wave * u
    is_large = ~is_small
    if np.any(is_large):
        p = phase[is_large]
        end = np.exp(1j * p)
        value = (end - 1.0) / (2j * p)
        moments[0, is_large] = value
        for m in range(1, count):
            value = (0.5 * end - m * value) / (1j * p)
            moments[m, is_large] = value
    return moments
