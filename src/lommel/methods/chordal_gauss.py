"""The chordal Gauss rule on the disk and two matrix products: stacks of small windows of any wavefront, certified."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Declined, Images, Intensities, Pixels, Wanted
from lommel.core.engine import chordal_gradient, chordal_images, chordal_plan, disk_averages
from lommel.methods.method import Method, Shortcut
from lommel.methods.nijboer_zernike import disk_images, disk_stack, window_of
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil


@dataclass(frozen=True)
class ChordalGauss(Method[Pupil]):
    r"""Quadrature over chords of the pupil by two matrix products, for any wavefront, with a proven error bound.

    Supports circular and annular apertures, apodized too. Intended for stacks of small windows: several pupils are
    computed together, and the tables of a window are kept between calls. The cost grows with the number N of chords
    times that of nodes on each, both of which grow with the phase and with the window; N is at most 1024. Images in
    float32 are summed in single precision where the tolerance allows it; its rounding is included in the bound.

    Parameters
    ----------
    tol : float, default 1e-6
        Bound on ``max|I - I_exact| / max I`` over the window, max I being the largest value in the window, 1e-12 to
        1e-1. It is a contract: quadrature and rounding are bounded, the bound is checked against the largest computed
        value, and :class:`ToleranceError` is raised if it cannot be brought below `tol`, as in a window far from the
        light.

    Raises
    ------
    ValueError
        If phase and window need more than 1024 chords or tables of more than 384 MiB.

    Notes
    -----
    ``U(v_x, v_y) = (1/pi) int P(x, y) exp(-i (v_x x + v_y y)) dx dy`` over the disk, P the pupil function, by the
    rule with nodes ``x_i = cos(i pi / (N+1))``, ``y_ik = sqrt(1 - x_i^2) eta_k``, eta_k those of Gauss and Legendre.
    Its weights ``(1 - x_i^2) w_k / (N+1)`` are positive. Across chords it is the trapezoidal rule for a periodic
    function, along them Gauss's; both converge geometrically, for the integrand is entire. Zernike terms are
    trigonometric polynomials on every chord, whence the bound, derived on the page about the certificate. A tilt
    counts as a shift of the window. An obscured aperture is the difference of two disks. On both axes, values and
    nodes of opposite sign share work.

    References
    ----------
    L. N. Trefethen and J. A. C. Weideman, "The exponentially convergent trapezoidal rule", SIAM Review 56, 385
    (2014), doi:10.1137/130932132.
    L. N. Trefethen, Approximation Theory and Approximation Practice, chapter 19: the bound on Gauss's rule.
    A. H. Stroud, Approximate Calculation of Multiple Integrals (1971), section 2.4: product rules.
    R. Soummer, L. Pueyo, A. Sivaramakrishnan and R. J. Vanderbei, Opt. Express 15, 15935 (2007),
    doi:10.1364/OE.15.015935: the transform as two matrix products.
    A. J. E. M. Janssen and P. Dirksen, J. Microlith. Microfab. Microsyst. 5, 030501 (2006):
    Zernike terms of a smaller disk.
    """

    apodized = nonradial = True
    tol: float = 1e-6
    _if_cheaper: ClassVar[bool] = False

    def intensity(self, pupil: Pupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return I at, or averaged over, the pixels, shape ``(n, height, width)``, with its bound."""
        return self.images(pupil, grid, Wanted(threads=threads)).intensities

    def plan(self, pupil: Pupil, grid: Grid, wanted: Wanted) -> Shortcut | None:
        """Return a prepared computation for further pupils around one axis; see :meth:`Method.plan`."""
        # A plan has samples around one axis, and no bound on the truncation of an apodization.
        if grid.stack or grid.integrate or pupil.illumination.error:
            return None
        shape, dtype = pupil.shape + grid.shape, np.dtype(wanted.dtype)
        light, window = pupil.illumination.exponent, window_of(pupil, grid)
        ask = chordal_plan(pupil.obscuration, light, window, self.tol, wanted, if_cheaper=self._if_cheaper)

        def answer(further: Pupil, values: Pixels) -> tuple[Array, float] | None:
            wavefront, flags = further.wavefront, values.flags
            fits = values.shape == shape and values.dtype == dtype and flags.c_contiguous and flags.writeable
            # The core writes in place: only arrays of this exact layout.
            if wavefront.left_out or not fits:
                return None
            return ask(wavefront.indices, wavefront.edge, values)

        return answer

    def images(self, pupil: Pupil, grid: Grid, wanted: Wanted) -> Images:
        """Return the images of the flattened stack; see :meth:`lommel.Method.images`."""
        if wanted.powers:
            raise ValueError("derivatives are not available from ChordalGauss; use NijboerZernike")
        if wanted.terms and wanted.scale is None:
            raise ValueError('derivatives of values divided by their largest one are not available: normalize="peak"')

        def sampled(some: Pupil, pixels: Grid, tol: float, wanted: Wanted) -> Images:
            stack, window = disk_stack(some), window_of(some, pixels)
            return chordal_images(stack, window, tol, wanted, if_cheaper=self._if_cheaper)

        if grid.integrate:
            stack, window = disk_stack(pupil), window_of(pupil, grid)
            # Nodes of the window that all pixels share, if that is faster: certificate, section 10, "Nodes of a
            # window".
            made = disk_averages(stack, window, self.tol, wanted, if_cheaper=self._if_cheaper)
            if made is not None:
                return made
        return disk_images(sampled, pupil, grid, self.tol, wanted)

    def gradient(
        self, pupil: Pupil, grid: Grid, weights: Array, terms: tuple[tuple[int, int], ...], threads: int = 0
    ) -> Array:
        """Return derivatives of weighted sums of the values by the coefficients of Zernike terms, shape ``(n, k)``.

        The transpose of the derivatives of :meth:`images`: it costs about two images, for any number of terms.

        Parameters
        ----------
        pupil : Pupil
        grid : Grid
        weights : ndarray, shape (n, height, width)
            Of the pixels of each image of the flattened stack.
        terms : tuple of (int, int)
            n and m of each term, its coefficient in radians at the edge.
        threads : int, default 0
            Maximum number of threads; 0 for the number of processors.

        Raises
        ------
        ToleranceError
            If images cannot meet the tolerance.
        """

        def sampled(some: Pupil, pixels: Grid, tol: float, of: Array) -> Array:
            return chordal_gradient(disk_stack(some), window_of(some, pixels), tol, of, terms, threads)

        weights = np.ascontiguousarray(weights, dtype=np.float64)
        if not grid.integrate:
            return sampled(pupil, grid, self.tol, weights)
        from lommel.methods.averaging import averaged_gradient

        return averaged_gradient(sampled, pupil, grid, self.tol, weights)


_CHORDS = 90.0  # v up to which averages need samples, beyond which the series is faster


class ChordalIfCheaper(ChordalGauss):
    """ChordalGauss where it is estimated to be faster than :class:`NijboerZernike`; elsewhere Declined, at once."""

    _if_cheaper = True

    def images(self, pupil: Pupil, grid: Grid, wanted: Wanted) -> Images:
        """Return the images of the flattened stack; see :meth:`lommel.Method.images`."""
        if grid.integrate and not wanted.terms:
            from lommel.methods.averaging import estimate_far_start

            # Far from the axis averages have a closed form: the series needs samples near it only.
            if estimate_far_start(pupil, grid, self.tol) > _CHORDS:
                raise Declined("so many samples near the axis take less time by the series")
        return super().images(pupil, grid, wanted)

    @cached_property
    def reported(self) -> ChordalGauss:
        """Method named in results."""
        return ChordalGauss(self.tol)
