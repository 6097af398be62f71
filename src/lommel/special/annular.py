"""Zernike's polynomials over an annulus, as sums of those over the disc."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from lommel.base.arrays import Array
from lommel.special import zernike


def over_disc(terms: Mapping[tuple[int, int], float], obscuration: float) -> dict[tuple[int, int], float]:
    """Return the coefficients over the disc of the same function; both are rms, over the annulus and over the disc.

    The annular term (n, m) is the one polynomial of the span of the (k, m), k <= n, that is orthonormal over
    ``obscuration <= rho <= 1`` and grows there with rho^n: Gram and Schmidt's, by the Cholesky factor of the inner
    products over the annulus. Exact but for rounding.

    Parameters
    ----------
    terms : mapping of (n, m) to float
    obscuration : float
        Inner radius over the outer one, 0 to below 1.

    Returns
    -------
    dict of (n, m) to float

    References
    ----------
    V. N. Mahajan, "Zernike annular polynomials for imaging systems with annular pupils",
    J. Opt. Soc. Am. 71, 75 (1981), doi:10.1364/JOSA.71.000075.
    """
    found: dict[tuple[int, int], float] = {}
    for m in {m for _, m in terms}:
        orders = range(abs(m), max(n for n, k in terms if k == m) + 1, 2)
        factor = np.linalg.cholesky(_inner_products(orders, m, obscuration))
        given = np.array([terms.get((n, m), 0.0) for n in orders])
        # f = sum_n given_n sum_k (factor^-1)_nk disc_k.
        for n, c in zip(orders, np.linalg.solve(factor.T, given), strict=True):
            found[n, m] = float(c)
    return found


def _inner_products(orders: range, m: int, obscuration: float) -> Array:
    """Return the means over the annulus of products of terms over the disc, of rms 1 there."""
    x, w = np.polynomial.legendre.leggauss(orders[-1] + 1)  # exact: even polynomials, in rho^2
    low = obscuration * obscuration
    rho = np.sqrt(low + (1.0 - low) * 0.5 * (1.0 + x))
    # The mean of the squared cosine over the azimuth is 1/2, which the factors of the disc hold.
    share = 1.0 if m == 0 else 0.5
    basis = np.stack([zernike.rms_factor(n, m) * zernike.radial(n, m, rho) for n in orders])
    return np.asarray(share * (basis * (0.5 * w)) @ basis.T)
