"""Chordal Gauss quadrature of the disk as two matrix products, for any wavefront, with a proven error bound."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Declined, Intensities, Pixels, Samples, Wanted
from lommel.core.engine import chordal_gradient, chordal_images, chordal_plan, disk_averages
from lommel.methods.method import Method, Shortcut
from lommel.methods.nijboer_zernike import disk_images, disk_stack, window_of
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil


@dataclass(frozen=True)
class ChordalGauss(Method[Pupil]):
    r"""Quadrature over chords of the pupil by two matrix products, for any wavefront, with a proven error bound.

    Supports circular and annular apertures, with or without apodization, also behind straight vanes that part within
    the obscuration or, without one, begin at the axis with one width or are parallel bars. Intended for stacks of
    small windows: several pupils are computed together, and the tables of a window are cached between calls. The cost
    is proportional to the number N of chords times the number of nodes per chord. Both numbers grow with the phase
    and with the window; N is at most 1024. Images in float32 are summed in single precision if the tolerance allows
    this; the bound includes the rounding errors.

    Parameters
    ----------
    tol : float, default 1e-6
        Bound on ``max abs(I - I_exact) / max I`` over the window, max I being the largest value in the window, 1e-12
        to 1e-1. Quadrature and rounding errors are bounded, the bound is compared with the largest computed value,
        and :class:`~lommel.ToleranceError` is raised if the bound cannot be brought below `tol`, for
        example in a window far from the light.

    Raises
    ------
    ValueError
        If phase and window need more than 1024 chords or tables of more than 384 MiB.

    Notes
    -----
    ``U(v_x, v_y) = (1/pi) int P(x, y) exp(-i (v_x x + v_y y)) dx dy`` over the disk, with the pupil function P,
    is computed by the rule with nodes ``x_i = cos(i pi / (N+1))``, ``y_ik = sqrt(1 - x_i^2) eta_k``, with the
    Gauss-Legendre nodes eta_k. The weights ``(1 - x_i^2) w_k / (N+1)`` are positive. Across the chords, this is the
    trapezoidal rule for a periodic function; along the chords, it is a Gauss rule. Both rules converge geometrically,
    since the integrand is entire. The bound, derived in docs/certificate.md, uses that Zernike terms are
    trigonometric polynomials on every chord. A tilt is treated as a shift of the window. An obscured aperture is the
    difference of two disks, and vanes are strips that are subtracted, by Gauss rules across and along; the fields of
    their lines are interpolated between tabulated places. Nodes and pixels at opposite coordinates are computed
    together, along both axes.

    References
    ----------
    L. N. Trefethen and J. A. C. Weideman, "The exponentially convergent trapezoidal rule", SIAM Review 56, 385
    (2014), doi:10.1137/130932132.
    L. N. Trefethen, Approximation Theory and Approximation Practice, chapter 19: error bound of the Gauss rule.
    A. H. Stroud, Approximate Calculation of Multiple Integrals (1971), section 2.4: product rules.
    R. Soummer, L. Pueyo, A. Sivaramakrishnan and R. J. Vanderbei, Opt. Express 15, 15935 (2007),
    doi:10.1364/OE.15.015935: the transform as two matrix products.
    A. J. E. M. Janssen and P. Dirksen, J. Microlith. Microfab. Microsyst. 5, 030501 (2006):
    Zernike terms of a smaller disk.
    """

    apodized = nonradial = cut_aperture = True
    tol: float = 1e-6
    _if_cheaper: ClassVar[bool] = False

    def intensity(self, pupil: Pupil, grid: Grid, threads: int) -> Intensities:
        """Return I at pixel centres, or averaged over pixels, shape ``(n, height, width)``, with its error bound."""
        return self.images(pupil, grid, Wanted(threads=threads)).intensities

    def plan(self, pupil: Pupil, grid: Grid, wanted: Wanted) -> Shortcut | None:
        """Return a prepared computation for further pupils with the same axis; see :meth:`Method.plan`."""
        # Plans compute point samples around one axis; their bounds exclude truncation errors of an apodization.
        if grid.stack or grid.integrate or pupil.illumination.error:
            return None
        shape, dtype = pupil.shape + grid.shape, np.dtype(wanted.dtype)
        aperture, window = disk_stack(pupil)[2:], window_of(pupil, grid)
        weighed = self._if_cheaper and pupil.circular  # there is no series behind vanes
        compute = chordal_plan(*aperture, window, self.tol, wanted, if_cheaper=weighed)

        def shortcut(new_pupil: Pupil, values: Pixels) -> tuple[Array, float] | None:
            wavefront, flags = new_pupil.wavefront, values.flags
            fits = values.shape == shape and values.dtype == dtype and flags.c_contiguous and flags.writeable
            # The core writes in place, only to arrays of exactly this layout.
            if wavefront.left_out or not fits:
                return None
            return compute(wavefront.indices, wavefront.edge, values)

        return shortcut

    def images(self, pupil: Pupil, grid: Grid, wanted: Wanted) -> Samples:
        """Return the images of the flattened stack; see :meth:`lommel.methods.Method.images`."""
        if wanted.powers:
            raise ValueError("derivatives are not available from ChordalGauss; use NijboerZernike")
        if wanted.terms and wanted.scale is None:
            raise ValueError('derivatives of values divided by their largest one are not available: normalize="peak"')

        def point_samples(part: Pupil, pixels: Grid, tol: float, wanted: Wanted) -> Samples:
            stack, window = disk_stack(part), window_of(part, pixels)
            return chordal_images(stack, window, tol, wanted, if_cheaper=self._if_cheaper and pupil.circular)

        if grid.integrate and (pupil.circular or not self._filters(pupil, grid, wanted)):
            # If faster, averages are computed as sums over nodes that all pixels of the window share: certificate,
            # section 10, "Nodes of a window".
            averages = disk_averages(
                disk_stack(pupil), window_of(pupil, grid), self.tol, wanted, if_cheaper=self._if_cheaper
            )
            if averages is not None:
                return averages
        if not pupil.circular:
            from lommel.methods.averaging import averaged_images

            return averaged_images(point_samples, pupil, grid, self.tol, wanted)
        return disk_images(point_samples, pupil, grid, self.tol, wanted)

    def _filters(self, pupil: Pupil, grid: Grid, wanted: Wanted) -> bool:
        """Return whether averages behind vanes are filtered samples."""
        assert pupil.strips is not None
        strips, count, pitch = pupil.strips[1], math.prod(pupil.shape), grid.step(pupil)
        split, one_sided = bool(strips[:, 7].any()), not strips[:, 5:7].all()
        # Up to a vector of pupils take the time of one at nodes, which are half as many as samples.
        nodes = _NODES_PER_V * pitch * max(grid.shape)
        filters = split or (not wanted.terms and count <= _FEW and nodes > _NODES_PER_PUPIL * count - _FEWEST_NODES)
        # The moment rule is fast for one pupil in windows that have nodes; without filters disk_averages() chooses.
        large = pitch > _LEAST_PITCH and np.ptp(strips[:, 2:4], axis=1).max() > _NARROW
        shared = one_sided and large and count == 1 and _FEWEST_ONE_SIDED < nodes < _NODES_PER_V * _LARGEST_WINDOW
        if self._if_cheaper and filters and (shared or (split and (count > _FEW or wanted.terms))):
            raise Declined("nodes of the aperture are likely to take less time than filters")
        return filters

    def gradient(self, pupil: Pupil, grid: Grid, weights: Array, terms: tuple[tuple[int, int], ...]) -> Array:
        """Return derivatives of weighted sums of the values by the coefficients of Zernike terms, shape ``(n, k)``.

        The transpose of the derivatives of :meth:`images`: it takes the time of two images, for any number of terms.

        Parameters
        ----------
        pupil : Pupil
        grid : Grid
        weights : ndarray, shape (n, height, width)
            Weights of the pixels of each image of the flattened stack.
        terms : tuple of (int, int)
            n and m of each term. Coefficients are in radians at the edge of the pupil.

        Raises
        ------
        ToleranceError
            If the tolerance cannot be met.
        """

        def gradient_of_samples(part: Pupil, pixels: Grid, tol: float, pixel_weights: Array) -> Array:
            return chordal_gradient(disk_stack(part), window_of(part, pixels), tol, pixel_weights, terms, 0)

        if not pupil.circular:
            raise Declined("ChordalGauss has no transpose of derivatives behind vanes; use NonuniformFFT")
        weights = np.ascontiguousarray(weights, dtype=np.float64)
        if not grid.integrate:
            return gradient_of_samples(pupil, grid, self.tol, weights)
        from lommel.methods.averaging import averaged_gradient

        return averaged_gradient(gradient_of_samples, pupil, grid, self.tol, weights)


_FEW = 4  # largest number of pupils behind vanes whose averages may be filtered samples
_NODES_PER_V = 0.64  # nodes of a window per v, approximately
# Filters are faster from this number of nodes per pupil, less the second.
_NODES_PER_PUPIL, _FEWEST_NODES = 80.0, 60.0
# Behind vanes on one side of the axis, one of them wider than _NARROW, nodes of the aperture are faster than filters
# for pixels larger than this (v), from this number of nodes of a window, and up to this width of it (v).
_NARROW, _LEAST_PITCH, _FEWEST_ONE_SIDED, _LARGEST_WINDOW = 0.035, 2.5, 100.0, 450.0
_MAX_SAMPLED_V = 90.0  # largest estimated v at which far pixels start; beyond it NijboerZernike is faster


class ChordalIfCheaper(ChordalGauss):
    """ChordalGauss that raises Declined if NijboerZernike or, behind vanes, NonuniformFFT is likely to be faster."""

    _if_cheaper = True

    def images(self, pupil: Pupil, grid: Grid, wanted: Wanted) -> Samples:
        """Return the images of the flattened stack; see :meth:`lommel.methods.Method.images`."""
        if grid.integrate and not wanted.terms and pupil.circular:
            from lommel.methods.averaging import estimate_far_start

            # NijboerZernike has a closed form of averages far from the axis, and needs samples near the axis only.
            if estimate_far_start(pupil, grid, self.tol) > _MAX_SAMPLED_V:
                raise Declined("NijboerZernike is estimated to compute the samples near the axis faster")
        return super().images(pupil, grid, wanted)

    @cached_property
    def reported(self) -> ChordalGauss:
        """Method named in results."""
        return ChordalGauss(self.tol)
