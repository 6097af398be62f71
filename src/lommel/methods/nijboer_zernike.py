"""The Legendre-Bessel form of the extended Nijboer-Zernike series: the default method."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from lommel import _core, validation
from lommel.methods import bounds
from lommel.methods.method import RadialMethod, Result, ToleranceError, annulus, relative_error
from lommel.pupil import Pupil
from lommel.special.bessel import legendre_transforms
from lommel.special.legendre import gauss_legendre, shifted_legendre

_POINTS = 16  # Chebyshev points a piece
_MAX_TERMS = 20_000


@dataclass(frozen=True)
class NijboerZernike(RadialMethod):
    r"""Series of Bessel functions, exact to a tolerance: the default.

    Supports every pupil.

    Parameters
    ----------
    tol : float, default 1e-6
        Bound on ``max|I - I_exact| / max I`` over the window, max I being the peak of the PSF,
        1e-12 to 1e-1. It is a contract: the series and
        its interpolation are cut by proven bounds, and the result is checked against the peak that was found.
        :class:`ToleranceError` says where rounding (estimated, not proven) forbids it.

    Notes
    -----
    With ``E(t) = exp(i Phi)`` and t = rho^2,
    ``beta_n = (2n+1) int_0^1 E(t) P_n(2t-1) dt`` and
    ``U(v) = sum_n beta_n 2 (-1)^n J_{2n+1}(v) / v``:
    the P_n(2t-1) are the radial Zernike polynomials, and the basis is orthogonal, so nothing cancels whatever
    the defocus. U is entire of exponential type 1, hence polynomial pieces of degree 15 and width H carry it to
    ``4 (H/4)^16 / 16!`` of its largest value (Bernstein). An obscured aperture is the difference of two disks.

    References
    ----------
    A. J. E. M. Janssen, J. Opt. Soc. Am. A 19, 849 (2002), doi:10.1364/JOSAA.19.000849.
    S. van Haver and A. J. E. M. Janssen, J. Eur. Opt. Soc. Rapid Publ. 8, 13044 (2013),
    doi:10.2971/jeos.2013.13044.
    """

    tol: float = 1e-6

    def __post_init__(self) -> None:
        object.__setattr__(self, "tol", validation.real("tol", self.tol, least=1e-12, below=1e-1))

    def unsupported(self, pupil: Pupil) -> str | None:
        """Return None: every pupil is supported."""
        return None

    def evaluate(self, pupil: Pupil, v: NDArray[np.float64]) -> Result:
        """Return U at rising v with its error bound, small enough for an intensity within `tol` of the peak."""
        return self._series(pupil, v, self._field_tolerance(pupil))

    def profile(self, pupil: Pupil, v: NDArray[np.float64]) -> Result:
        """Return I at rising v; the tolerance is checked against the peak that was found, and tightened."""
        error = self._field_tolerance(pupil)
        for _ in range(6):
            intensity, bound = self._attempt(pupil, v, error)
            assert bound is not None
            relative = relative_error(intensity, bound)
            if np.any(relative > self.tol):
                # The window may miss the peak, which for a defocused lens need not be at its centre.
                scan = np.linspace(0.0, float(pupil.v(pupil.geometric_radius()).max()) + 4.0, 257)
                outside = self._attempt(pupil, scan, error).values
                relative = relative_error(np.concatenate([intensity, outside], axis=1), bound)
            if np.all(relative <= self.tol):
                return Result(intensity, relative)
            if np.all(bound < 4.0 * bounds.rounding_error(pupil.coefficients(), 0.0, 1)):
                break
            error *= 0.1
        raise ToleranceError(
            f"tol={self.tol:g} cannot be met in double precision: the bound on the error stays at "
            f"{relative.max():.2g} of the peak"
        )

    def _field_tolerance(self, pupil: Pupil) -> float:
        """Return the error in U that meets `tol` wherever sup|U| > area / (2 sum|c| + 1), as it nearly always is."""
        phases = float(np.abs(pupil.coefficients()).sum(axis=1).max())
        return 0.125 * self.tol * pupil.area / (2.0 * phases + 1.0)

    def _attempt(self, pupil: Pupil, v: NDArray[np.float64], error: float) -> Result:
        """Return I with a bound of about `error` on U, through polynomial pieces where those are fewer values."""
        reach = float(v[-1]) if v.size else 0.0
        width = 4.0 * (0.125 / 4.0 * error * math.factorial(_POINTS)) ** (1.0 / _POINTS)
        pieces = max(1, math.ceil(reach / width))
        if pieces * _POINTS >= v.size:
            values, bound = self._series(pupil, v, error)
            return Result(values.real**2 + values.imag**2, bound)
        nodes, to_coefficients = _chebyshev(_POINTS)
        at = (width * (np.arange(pieces)[:, None] + nodes)).ravel()
        values, bound = self._series(pupil, at, 0.25 * error)
        assert bound is not None
        coefficients = values.reshape(-1, pieces, _POINTS) @ to_coefficients
        intensity = _core.intensity_of_pieces(np.ascontiguousarray(coefficients), width, v)
        # Interpolation magnifies the errors of the values by its Lebesgue constant and adds its own.
        interpolation = 4.0 * (0.25 * width) ** _POINTS / math.factorial(_POINTS) * pupil.area
        return Result(intensity, _LEBESGUE * bound + interpolation)

    def _series(self, pupil: Pupil, v: NDArray[np.float64], error: float) -> Result:
        def disk(coefficients: NDArray[np.float64], at: NDArray[np.float64]) -> Result:
            reach = float(at[-1]) if at.size else 0.0
            g = bounds.growth(coefficients, 0.0, 0.0)
            terms = bounds.series_terms(g, reach, 0.25 * error)
            nodes = bounds.coefficient_nodes(g, terms, 0.25 * error)
            if nodes > _MAX_TERMS:
                raise ValueError(
                    f"phases of {np.abs(coefficients).max():.3g} rad take {nodes} quadrature nodes, "
                    f"more than the limit of {_MAX_TERMS}"
                )
            beta = _legendre_coefficients(coefficients, terms, nodes)
            table = legendre_transforms(at, terms).T
            values = beta.real @ table + 1j * (beta.imag @ table)
            rounding = bounds.rounding_error(coefficients, 0.0, terms)
            return Result(values, bounds.series_error(g, terms, reach) + 0.25 * error + rounding)

        return annulus(disk, pupil, v)


def _legendre_coefficients(coefficients: NDArray[np.float64], terms: int, nodes: int) -> NDArray[np.complex128]:
    """Return beta_n of exp(i Phi), shape ``(n, terms)``."""
    t, weights = gauss_legendre(nodes)
    powers = t ** np.arange(1, 1 + coefficients.shape[1])[:, None]
    integrand = weights * np.exp(1j * (coefficients @ powers))
    polynomials = shifted_legendre(t, terms)
    beta = integrand.real @ polynomials + 1j * (integrand.imag @ polynomials)
    return np.asarray(beta * (2.0 * np.arange(terms) + 1.0))


@lru_cache(maxsize=1)
def _chebyshev(points: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return Chebyshev points of [0, 1], rising, and the matrix from values there to coefficients."""
    angles = np.pi * (np.arange(points)[::-1] + 0.5) / points
    matrix = 2.0 / points * np.cos(angles[:, None] * np.arange(points))
    matrix[:, 0] *= 0.5
    return 0.5 * (1.0 + np.cos(angles)), matrix


# Lebesgue constant of interpolation at n Chebyshev points: at most (2/pi) log(n) + 1.
_LEBESGUE = 2.0 / math.pi * math.log(_POINTS) + 1.0
