"""Hankel transform by direct quadrature: the reference for all other methods."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from lommel.base.arrays import Array
from lommel.core import engine
from lommel.core.answers import Declined, FieldValues
from lommel.methods.bounds import growth, quadrature_error, quadrature_nodes, rounding_error
from lommel.methods.method import FieldMethod
from lommel.optics.pupil import Pupil
from lommel.special.legendre import gauss_legendre

_BLOCK = 2**21  # values of J0 held at once: 16 MiB
_MAX_NODES = 16_000


@dataclass(frozen=True)
class Hankel(FieldMethod[Pupil]):
    r"""Gauss-Legendre quadrature of ``U(v) = int exp(i Phi) J0(v sqrt t) dt`` in t = rho^2, at every radius.

    Supports radially symmetric pupils. Each distinct radius is integrated separately, without interpolation.

    Parameters
    ----------
    tol : float, default 1e-14
        The number of nodes is the smallest whose proven quadrature error in U (relative to U(0) = 1 of the
        unaberrated aperture) is below `tol`, 1e-15 to 1e-2. Rounding adds about ``2^-53`` times the phase.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    In t a quartic phase is exactly quadratic and ``J0(v sqrt t)`` is entire, so convergence is geometric
    once n exceeds about half the bandwidth ``max(sqrt(t (1-t)) |Phi'(t)| + v sqrt(1-t) / 2)``. The bound is
    Theorem 19.3 of Trefethen, *Approximation Theory and Approximation Practice* (2013).
    """

    apodized = True
    keeps_tol = False
    least_tol = 1e-15
    most_tol = 1e-2
    tol: float = 1e-14

    def evaluate(self, pupil: Pupil, v: Array) -> FieldValues:
        """Return U at rising v, with the bound of the quadrature and an estimate of the rounding."""
        from scipy.special import j0

        low = pupil.obscuration**2
        terms = pupil.radial_terms()
        reach = float(v[-1]) if v.size else 0.0
        g = growth(terms, low, reach, pupil.illumination)
        n = quadrature_nodes(g, self.tol * (1.0 - low), low)
        if n > _MAX_NODES:
            raise Declined(
                f"phases of {np.abs(terms).max():.3g} rad and v up to {reach:.3g} take {n:.3g} quadrature "
                f"nodes, more than the limit of {_MAX_NODES}"
            )
        t, weights = gauss_legendre(n, low, 1.0)
        integrand = weights * pupil.illumination.at(t) * np.exp(1j * pupil.radial_phase(t))
        # The threads of OpenBLAS would wait for one another, busily, where several channels are computed at once.
        parts = [np.ascontiguousarray(part) for part in (integrand.real, integrand.imag)]
        values = np.empty((len(terms), v.size), dtype=np.complex128)
        root = np.sqrt(t)[:, None]
        rows = max(1, _BLOCK // n)
        for start in range(0, v.size, rows):
            block = slice(start, start + rows)
            kernel = j0(root * v[block])
            values[:, block].real, values[:, block].imag = (engine.product(part, kernel, 1) for part in parts)
        error = quadrature_error(g, n, low) + rounding_error(terms, low, n)
        return FieldValues(values, error)
