"""Error function on the rays at +-45 degrees of the complex plane, by three algorithms, for the paper's closed form.

``erf(e^{-i pi/4} s)`` with real s is a pair of real Fresnel integrals:
``int_0^s exp(i tau^2) d tau = (sqrt(pi)/2) e^{i pi/4} erf(e^{-i pi/4} s)`` (DLMF 7.5.8).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation

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


# Empty table, for evaluations without a table in the compiled core.
_NO_TABLE = np.empty(0, dtype=np.complex128)


class Erf:
    """Evaluation of ``erf(e^{-i pi/4} s)`` for real s, by the compiled core."""

    @property
    def compiled(self) -> tuple[int, NDArray[np.complex128]]:
        """Arguments of the compiled core: number of terms of Eq. (14), and table; by default 0 and an empty table."""
        return 0, _NO_TABLE


@dataclass(frozen=True)
class FresnelErf(Erf):
    """Error function with an error of about 1e-13, by the Faddeeva function."""


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
        return 0, _table(self.samples)


@lru_cache(maxsize=4)
def _table(samples: int) -> NDArray[np.complex128]:
    # (s + 2) G(s) is smooth and falls from 2 G(0) to i / 2, so that linear interpolation suffices.
    # y = s / (s + 2), from 0 to 1 for s from 0 to infinity; (s + 2) G(s) tends to i / 2.
    y = np.linspace(0.0, 1.0, samples)
    s = 2.0 * y[:-1] / (1.0 - y[:-1])
    return np.append((s + 2.0) * fresnel_auxiliary(s), 0.5j)


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
