"""The Legendre-Bessel form of the extended Nijboer-Zernike series, compiled and certified: the default method."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel import _core, validation
from lommel.grid import Grid
from lommel.methods.averaging import Sample, averaged, averaged_images
from lommel.methods.method import (
    FieldMethod,
    FieldValues,
    Images,
    Intensities,
    Slopes,
    ToleranceError,
    not_met,
)
from lommel.methods.whole_disk import render
from lommel.pupil import Pupil

_LEAST_TOL = 1e-12


@dataclass(frozen=True)
class NijboerZernike(FieldMethod):
    r"""Series of Bessel functions, exact to a tolerance: the default.

    Supports every circular aperture, obscured or not, and every wavefront, up to about 5000 radians of phase if it is
    radially symmetric and some hundred if not.

    Parameters
    ----------
    tol : float, default 1e-6
        Bound on ``max|I - I_exact| / max I`` over the window, max I being the peak of the PSF, 1e-12 to 1e-1. It is
        a contract: truncation, quadrature, interpolation and rounding are bounded, the bound is checked against
        the peak that was found, and :class:`ToleranceError` is raised where it cannot be brought below `tol`.

    Notes
    -----
    With ``E(t) = exp(i Phi)`` and t = rho^2, ``beta_n = (2n+1) int_0^1 E(t) P_n(2t-1) dt`` and
    ``U(v) = sum_n beta_n 2 (-1)^n J_{2n+1}(v) / v``: the P_n(2t-1) are the radial Zernike polynomials, and the basis
    is orthogonal, so nothing cancels whatever the defocus. The Bessel functions do not depend on the pupil; they
    are tabulated once as polynomials of degree 15 on pieces of the v axis, U being of exponential type 1. An
    obscured aperture is the difference of two disks.

    With any Zernike terms, ``P = sum beta_n^m R_n^|m| exp(i m theta)`` and
    ``U(v, psi) = 2 sum_n (-i)^n sum_m beta_n^m J_{n+1}(v)/v exp(i m psi)``: the same radial functions serve every
    azimuthal order; the orders are summed while rendering, for eight pixels at once.

    References
    ----------
    A. J. E. M. Janssen, J. Opt. Soc. Am. A 19, 849 (2002), doi:10.1364/JOSAA.19.000849.
    S. van Haver and A. J. E. M. Janssen, J. Eur. Opt. Soc. Rapid Publ. 8, 13044 (2013),
    doi:10.2971/jeos.2013.13044.
    J. J. M. Braat, P. Dirksen, A. J. E. M. Janssen and A. S. van de Nes, J. Opt. Soc. Am. A 20, 2281 (2003).
    """

    apodized: ClassVar[bool] = True
    nonradial: ClassVar[bool] = True
    tol: float = 1e-6

    def __post_init__(self) -> None:
        object.__setattr__(self, "tol", validation.real("tol", self.tol, least=_LEAST_TOL, below=1e-1))

    def unsupported(self, pupil: Pupil) -> str | None:
        """Return None: every pupil is supported."""
        return None

    def evaluate(self, pupil: Pupil, v: NDArray[np.float64]) -> FieldValues:
        """Return U at rising v with its error bound, small enough for an intensity within `tol` of the peak."""
        _require_radial(pupil)
        return FieldValues(
            *_core.field(pupil.radial_terms(), pupil.obscuration, pupil.illumination.exponent, v, self.tol)
        )

    def profile(self, pupil: Pupil, v: NDArray[np.float64]) -> Intensities:
        """Return I at rising v; its bound is checked against the peak that was found."""
        _require_radial(pupil)
        values, bounds, peaks = _core.profile(
            pupil.radial_terms(), pupil.obscuration, pupil.illumination.exponent, v, self.tol
        )
        if bounds.min() < 0:
            raise self._not_met(-bounds.min())
        return Intensities(values, bounds, peaks)

    def means(
        self, pupil: Pupil, v: NDArray[np.float64], matrix: NDArray[np.float64], threads: int = 0
    ) -> NDArray[np.float64]:
        """Return ``I(v) @ matrix`` for the flattened stack, shape ``(n, sums)`` from a matrix ``(len(v), sums)``."""
        _require_radial(pupil)
        sums, bounds = _core.means(
            pupil.radial_terms(), pupil.obscuration, pupil.illumination.exponent, v, self.tol, matrix, threads
        )
        if bounds.min() < 0:
            raise self._not_met(-bounds.min())
        return sums

    def tightened(self) -> NijboerZernike:
        """Return the same method with half the tolerance, or with the least that there is."""
        return NijboerZernike(max(0.5 * self.tol, _LEAST_TOL))

    def intensity(self, pupil: Pupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return I at the distinct radii of `grid`, or on its pixels where these share none."""
        if pupil.radial and grid.symmetric:
            return super().intensity(pupil, grid, threads)
        if pupil.radial:
            images, peaks = self._pixel_images(pupil, grid, 1.0, np.float64, None, (), threads)
            return Intensities(images.values, images.error, peaks)
        sample = self._sample(threads)
        if grid.integrate:
            return averaged(sample, pupil, grid, self.tol, normalize=False)
        made = sample(pupil, grid, self.tol)
        return Intensities(made.values, made.bounds, made.peaks)

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
        if not pupil.radial:
            return self._nonradial_images(pupil, grid, scale, dtype, out, powers, threads)
        if not grid.symmetric:
            return self._pixel_images(pupil, grid, scale, dtype, out, powers, threads)[0]
        coefficients = pupil.radial_terms()
        n, shape = len(coefficients), grid.shape
        values = np.empty((n, *shape), dtype) if out is None else out
        scales, bounds = np.empty(n), np.empty(n)
        # The compiled core takes 0 for "divide by the largest value".
        scales.fill(0.0 if scale is None else scale)
        slopes = Slopes(np.empty((len(powers), n, *shape), dtype), np.empty((len(powers), n))) if powers else None
        arguments = (
            coefficients,
            pupil.obscuration,
            pupil.illumination.exponent,
            grid.step(pupil),
            self.tol,
            threads,
        )
        if slopes is None:
            unmet = _core.render(*arguments, values, scales, bounds)
        else:
            wanted = np.array(powers, dtype=np.int64)
            unmet = _core.differentiate(*arguments, values, scales, bounds, wanted, *slopes)
        if unmet:
            raise self._not_met(unmet)
        return Images(values, scales, bounds, slopes)

    def _pixel_images(
        self,
        pupil: Pupil,
        grid: Grid,
        scale: float | None,
        dtype: DTypeLike,
        out: NDArray[Any] | None,
        powers: tuple[int, ...],
        threads: int,
    ) -> tuple[Images, NDArray[np.float64]]:
        """Return images of pixels that average, or around an axis anywhere, and what their bounds are related to."""
        coefficients = pupil.radial_terms()
        n, k = len(coefficients), len(powers)
        values = np.empty((n, *grid.shape), dtype) if out is None else out
        scales, bounds, peaks = np.full(n, 0.0 if scale is None else scale), np.empty(n), np.empty(n)
        slopes = Slopes(np.empty((k, n, *grid.shape), dtype), np.empty((k, n)))
        unmet = _core.render_pixels(
            coefficients,
            pupil.obscuration,
            pupil.illumination.exponent,
            *grid.center,
            grid.step(pupil),
            grid.integrate,
            self.tol,
            threads,
            values,
            scales,
            bounds,
            peaks,
            np.array(powers, dtype=np.int64),
            *slopes,
        )
        if unmet:
            raise not_met(self.tol, unmet, "the largest value in the window" if scale is None else "the peak")
        return Images(values, scales, bounds, slopes if powers else None), peaks

    def _nonradial_images(
        self,
        pupil: Pupil,
        grid: Grid,
        scale: float | None,
        dtype: DTypeLike,
        out: NDArray[Any] | None,
        powers: tuple[int, ...],
        threads: int,
    ) -> Images:
        if powers:
            raise ValueError("derivatives are available of radially symmetric pupils only")
        if not grid.integrate:
            made = render(_core.series_images, pupil, grid, scale, dtype, self.tol, "the peak", out, threads)
            return Images(made.values, made.scales, made.bounds)
        return averaged_images(self._sample(threads), pupil, grid, scale, dtype, self.tol, out)

    def _sample(self, threads: int) -> Sample:
        return lambda pupil, grid, tol: render(
            _core.series_images, pupil, grid, 1.0, np.float64, tol, "the peak", threads=threads
        )

    def _not_met(self, bound: float) -> ToleranceError:
        return not_met(self.tol, bound, "the peak")


def _require_radial(pupil: Pupil) -> None:
    if not pupil.radial:
        raise ValueError(
            "a pupil that is not radially symmetric has no radial profile; ask for its image with lommel.psf"
        )
