"""Default method: the Legendre-Bessel form of the extended Nijboer-Zernike series, with error bounds."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from lommel.base.arrays import Array
from lommel.core.answers import Declined, FieldValues, Intensities, Pixels, Samples, ToleranceError, Wanted
from lommel.core.engine import (
    DiskStack,
    FarPixels,
    RadialStack,
    Window,
    far_averages,
    filters_pay,
    product,
    radial_fields,
    radial_images,
    radial_plan,
    radial_profiles,
    series_images,
)
from lommel.methods.method import FieldMethod, Shortcut
from lommel.optics.grid import Grid

if TYPE_CHECKING:
    from lommel.optics.pupil import Pupil


@dataclass(frozen=True)
class NijboerZernike(FieldMethod["Pupil"]):
    r"""Legendre-Bessel series, accurate to a tolerance: the default method.

    Supports circular and annular apertures with any wavefront, up to about 5000 radians of phase if it is radially
    symmetric and a few hundred if not.

    Parameters
    ----------
    tol : float, default 1e-6
        Bound on ``max|I - I_exact| / max I`` over the window, max I being the peak of the PSF, 1e-12 to 1e-1. The
        errors of truncation, quadrature, interpolation and rounding are bounded, and :class:`~lommel.ToleranceError`
        is raised if their sum, divided by the computed peak, cannot be brought below `tol`. Without radial symmetry
        this is so below about 1e-9; :class:`ChordalGauss` then reaches about 1e-11.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    A radially symmetric pupil ``E(t) = exp(i Phi)``, with t = rho^2 and the phase Phi, has the coefficients
    ``beta_n = (2n+1) int_0^1 E(t) P_n(2t-1) dt`` and the field ``U(v) = sum_n beta_n 2 (-1)^n J_{2n+1}(v) / v``. The
    P_n(2t-1) are the radial Zernike polynomials, an orthogonal basis, so that large terms do not cancel at any
    defocus. The Bessel functions do not depend on the pupil; they are tabulated once as polynomials of degree 15 on
    pieces of the v axis. An obscured aperture is the difference of two disks.

    A pupil with any Zernike terms is ``P = sum beta_n^m R_n^|m| exp(i m theta)``, and its field is
    ``U(v, psi) = 2 sum_n (-i)^n sum_m beta_n^m J_{n+1}(v)/v exp(i m psi)``: all azimuthal orders m use the same
    radial functions J_{n+1}(v)/v. FFTs over m give U on circles, and interpolation between them eight pixels at once.

    References
    ----------
    A. J. E. M. Janssen, J. Opt. Soc. Am. A 19, 849 (2002), doi:10.1364/JOSAA.19.000849.
    S. van Haver and A. J. E. M. Janssen, J. Eur. Opt. Soc. Rapid Publ. 8, 13044 (2013),
    doi:10.2971/jeos.2013.13044.
    J. J. M. Braat, P. Dirksen, A. J. E. M. Janssen and A. S. van de Nes, J. Opt. Soc. Am. A 20, 2281 (2003).
    """

    apodized = nonradial = True
    tol: float = 1e-6

    def evaluate(self, pupil: Pupil, v: Array) -> FieldValues:
        """Return U at increasing v with its error bound, which is small enough for an error of I of at most `tol`."""
        return radial_fields(radial_stack(pupil), v, self.tol)

    def profile(self, pupil: Pupil, v: Array) -> Intensities:
        """Return the intensity I at increasing v; its error bound is checked against the computed peak."""
        return radial_profiles(radial_stack(pupil), v, self.tol)

    def means(self, pupil: Pupil, v: Array, matrix: Array, threads: int) -> Array:
        """Return ``I(v) @ matrix``, shape ``(pupils, sums)``, for the flattened stack of a `pupil`.

        `v` is increasing, and `matrix` has the shape ``(len(v), sums)``; `threads` is the largest number of threads.
        """
        profiles = radial_profiles(radial_stack(pupil), v, self.tol, threads)
        return product(profiles.values, matrix, threads)

    def intensity(self, pupil: Pupil, grid: Grid, threads: int) -> Intensities:
        """Return I at the distinct radii of `grid` if pupil and grid are symmetric, otherwise at its pixels."""
        if pupil.radial and grid.symmetric:
            return super().intensity(pupil, grid, threads)
        return self.images(pupil, grid, Wanted(threads=threads)).intensities

    def plan(self, pupil: Pupil, grid: Grid, wanted: Wanted) -> Shortcut | None:
        """Return a prepared computation of further radial pupils on the same window; see :meth:`Method.plan`."""
        # The plan keeps the tables and error bounds of one window; the truncation error of an apodization would widen
        # these bounds.
        if not pupil.radial or grid.stack or pupil.illumination.error:
            return None
        window = window_of(pupil, grid)
        compute = radial_plan(radial_stack(pupil), pupil.shape, window, self.tol, wanted, integrate=grid.integrate)

        def shortcut(new_pupil: Pupil, values: Pixels) -> tuple[Array, float] | None:
            wavefront = new_pupil.wavefront
            return None if wavefront.left_out else compute(wavefront.radial_terms, values)

        return shortcut

    def images(self, pupil: Pupil, grid: Grid, wanted: Wanted) -> Samples:
        """Return the images of the flattened stack; see :meth:`lommel.methods.Method.images`."""
        if wanted.terms:
            raise ValueError("derivatives by Zernike terms are not available from NijboerZernike; use ChordalGauss")
        if pupil.radial:
            return self._radial_images(pupil, grid, wanted)
        if wanted.powers:
            raise ValueError("derivatives by powers of rho are available for radially symmetric pupils only")
        return disk_images(_series_samples, pupil, grid, self.tol, wanted)

    def _radial_images(self, pupil: Pupil, grid: Grid, wanted: Wanted) -> Samples:
        stack, window = radial_stack(pupil), window_of(pupil, grid)

        def images(wanted: Wanted, *, sampled: bool) -> Samples:
            if sampled:
                try:
                    return disk_images(_radial_samples, pupil, grid, self.tol, wanted)
                except ToleranceError:
                    pass  # filters magnify the errors of samples, so that double precision may not suffice
            return radial_images(stack, window, self.tol, wanted, integrate=grid.integrate)

        averaged = grid.integrate and not grid.stack
        # Pixel averages are sums with weights that all pupils of a window share (certificate, section 9), or filtered
        # finer samples (section 10).
        sampled = averaged and filters_pay(stack, window, self.tol)
        if averaged and wanted.powers and (sampled or filters_pay(stack, window, self.tol, derivatives=True)):
            values = images(wanted._replace(powers=()), sampled=sampled)
            # Derivatives are computed from finer samples, values by the faster of the two methods.
            return values._replace(slopes=images(wanted._replace(out=None), sampled=True).slopes)
        return images(wanted, sampled=sampled)


def _radial_samples(pupil: Pupil, grid: Grid, tol: float, wanted: Wanted) -> Samples:
    return radial_images(radial_stack(pupil), window_of(pupil, grid), tol, wanted)


def _series_samples(pupil: Pupil, grid: Grid, tol: float, wanted: Wanted) -> Samples:
    return series_images(disk_stack(pupil), window_of(pupil, grid), tol, wanted)


def radial_stack(pupil: Pupil) -> RadialStack:
    """Return the flattened stack of a radially symmetric pupil."""
    if not pupil.radial:
        raise Declined(
            "a pupil that is not radially symmetric has no radial profile; compute its image with lommel.psf"
        )
    # The amplitude is a factor of E(t); see the certificate, section 5.
    return RadialStack(pupil.radial_terms(), pupil.obscuration, pupil.illumination.exponent)


def disk_stack(pupil: Pupil) -> DiskStack:
    """Return the flattened stack of a pupil with any wavefront; of its aperture, the annulus and straight vanes."""
    edge, indices = pupil.wavefront.edge, pupil.wavefront.indices
    stack = DiskStack(indices, edge.reshape(-1, len(indices)), pupil.obscuration, pupil.illumination.exponent)
    return stack if (cut := pupil.strips) is None else stack._replace(obscuration=cut[0], strips=cut[1])


def window_of(pupil: Pupil, grid: Grid) -> Window:
    """Return the pixels of a grid as a window in the reduced coordinate v."""
    return Window(grid.shape, grid.axes if grid.stack else grid.axis, grid.step(pupil))


def disk_images(
    sample: Callable[[Pupil, Grid, float, Wanted], Samples],
    pupil: Pupil,
    grid: Grid,
    tol: float,
    wanted: Wanted,
) -> Samples:
    """Return images for any wavefront: values of `sample` at pixel centres, or pixel averages of finer samples."""
    if not grid.integrate:
        return sample(pupil, grid, tol, wanted)
    from lommel.methods.averaging import averaged_images

    def far_pixels(part: Pupil, pixels: Grid, limit: float, tol: float, threads: int) -> FarPixels:
        return far_averages(disk_stack(part), window_of(part, pixels), limit, tol, threads)

    return averaged_images(sample, pupil, grid, tol, wanted, far=far_pixels)
