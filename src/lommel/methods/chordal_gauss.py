"""The chordal Gauss rule on the disk and two matrix products: stacks of small windows of any wavefront, certified."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel import _core, validation
from lommel.grid import Grid
from lommel.methods.averaging import Rendered, Sample, averaged, averaged_images
from lommel.methods.azimuthal import phase_rounding
from lommel.methods.method import Images, Intensities, Method, not_met
from lommel.pupil import Pupil
from lommel.special import zernike

_LEAST_TOL = 1e-12
_BLOCK = 2**22  # values between two looks at the keyboard


@dataclass(frozen=True)
class ChordalGauss(Method):
    r"""Quadrature over the whole disk by a matrix product along y and one along x: any wavefront, to a tolerance.

    Supports every pupil, obscured and apodized too. Meant for stacks of small windows: pupils are computed side by
    side, and the tables of a window are kept from call to call. The work grows with the square of the number N of
    chords, which grows with the phase and with the window; more than 1024 are refused.

    Parameters
    ----------
    tol : float, default 1e-6
        Bound on ``max|I - I_exact| / max I`` over the window, max I being the largest value in the window, 1e-12 to
        1e-1. It is a contract: quadrature and rounding are bounded, the bound is checked against the largest value
        that was found, and :class:`ToleranceError` is raised where it cannot be brought below `tol`, as in a window
        that hardly any light reaches.

    Raises
    ------
    ValueError
        If phases and window take more than 1024 chords or tables of more than 256 MiB.

    Notes
    -----
    ``U(v_x, v_y) = (1/pi) int P(x, y) exp(-i (v_x x + v_y y)) dx dy`` over the disk, P the pupil function, by the
    rule with nodes ``x_i = cos(i pi / (N+1))``, ``y_ik = sqrt(1 - x_i^2) eta_k``, eta_k those of Gauss and Legendre.
    Its weights ``(1 - x_i^2) w_k / (N+1)`` are positive, and it is exact for polynomials of degree 2N - 1. The
    integrand is entire, so its components of higher degree fall geometrically; Zernike terms are trigonometric
    polynomials on every chord, whence the bound, derived on the page about the certificate. A tilt counts as a shift
    of the window. An obscured aperture is the difference of two disks. On both axes, values and nodes of opposite
    sign share work.

    References
    ----------
    B. F. Logan and L. A. Shepp, "Optimal reconstruction of a function from its projections", Duke Math. J. 42, 645
    (1975): the ridge polynomials of the bound.
    A. H. Stroud, Approximate Calculation of Multiple Integrals (1971), section 2.4: product rules.
    R. Soummer, L. Pueyo, A. Sivaramakrishnan and R. J. Vanderbei, Opt. Express 15, 15935 (2007),
    doi:10.1364/OE.15.015935: the transform as two matrix products.
    A. J. E. M. Janssen and P. Dirksen, J. Microlith. Microfab. Microsyst. 5, 030501 (2006):
    Zernike terms of a smaller disk.
    """

    apodized: ClassVar[bool] = True
    nonradial: ClassVar[bool] = True
    tol: float = 1e-6

    def __post_init__(self) -> None:
        object.__setattr__(self, "tol", validation.real("tol", self.tol, least=_LEAST_TOL, below=1e-1))

    def unsupported(self, pupil: Pupil) -> str | None:
        """Return None: every pupil is supported."""
        return None

    def intensity(self, pupil: Pupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return I at, or averaged over, the pixels, shape ``(n, height, width)``, with its bound."""
        sample = self._sample(threads)
        if grid.integrate:
            return averaged(sample, pupil, grid, self.tol, normalize=False)
        made = sample(pupil, grid, self.tol)
        return Intensities(made.values, made.bounds, made.peaks)

    def tightened(self) -> ChordalGauss:
        """Return the same method with half the tolerance, or with the least that there is."""
        return ChordalGauss(max(0.5 * self.tol, _LEAST_TOL))

    def images(
        self,
        pupil: Pupil,
        grid: Grid,
        scale: float | None,
        dtype: DTypeLike,
        *,
        out: NDArray[Any] | None = None,
        powers: tuple[int, ...] = (),
        threads: int = 0,
    ) -> Images:
        """Return the images of the flattened stack; see :meth:`Method.images`."""
        if powers:
            raise ValueError("derivatives are not available from ChordalGauss; use NijboerZernike")
        if grid.integrate:
            return averaged_images(self._sample(threads), pupil, grid, scale, dtype, self.tol, out)
        made = _render(pupil, grid, scale, dtype, self.tol, out=out, threads=threads)
        return Images(made.values, made.scales, made.bounds)

    def _sample(self, threads: int) -> Sample:
        return lambda pupil, grid, tol: _render(pupil, grid, 1.0, np.float64, tol, threads=threads)


def _render(
    pupil: Pupil,
    grid: Grid,
    scale: float | None,
    dtype: DTypeLike,
    tol: float,
    out: NDArray[Any] | None = None,
    threads: int = 0,
) -> Rendered:
    """Return images at the pixel centres."""
    terms, outer, inner = disk_terms(pupil)
    n = len(outer)
    values = np.empty((n, *grid.shape), dtype) if out is None else out
    scales, bounds = np.empty(n), np.empty(n)
    block = max(1, _BLOCK // (grid.height * grid.width))
    left = tol
    while True:
        # The compiled core takes 0 for "divide by the largest value".
        scales.fill(0.0 if scale is None else scale)
        for first in range(0, n, block):
            part = slice(first, first + block)
            unmet = _core.chordal(
                terms,
                outer[part],
                inner[part],
                pupil.obscuration,
                pupil.illumination.exponent,
                *grid.center,
                grid.step(pupil),
                left,
                threads,
                values[part],
                scales[part],
                bounds[part],
            )
            if unmet:
                raise not_met(tol, unmet, "the largest value in the window")
        peaks = values.max(axis=(1, 2)) / scales
        added = (2.0 if scale is None else 1.0) * phase_rounding(pupil, peaks)
        if (bounds + added).max() <= tol:
            return Rendered(values, scales, bounds + added, peaks)
        # Proven with nothing to spare: what is added is now known.
        left -= 1.1 * float(added.max())
        if left < 0.2 * tol:
            raise not_met(tol, float((bounds + added).max()), "the largest value in the window")


def disk_terms(pupil: Pupil) -> tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
    """Return the terms (n, m) of the phase, and their coefficients on the whole disk and on the obscured one.

    Shapes ``(terms, 2)`` and twice ``(n, terms)``; radians at the edge of the disk in question. Both phases lack the
    same constant. Terms that are zero throughout the stack are left out.
    """
    given = {term: c for term, c in pupil.wavefront.flattened().edge_terms().items() if np.any(c)}
    within = zernike.scaled(given, pupil.obscuration) if pupil.obscuration > 0.0 else {}
    terms = sorted({*given, *within}) or [(2, 0)]
    count = pupil.coefficients().shape[0]
    outer, inner = np.zeros((count, len(terms))), np.zeros((count, len(terms)))
    for j, term in enumerate(terms):
        outer[:, j] = given.get(term, 0.0)
        inner[:, j] = within.get(term, 0.0)
    return np.array(terms, dtype=np.int64), outer, inner
