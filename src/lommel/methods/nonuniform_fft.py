"""Spectral quadrature over any aperture, summed by a non-uniform FFT: every pupil, to a tolerance."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from typing import Any

import numpy as np

from lommel.base import optional
from lommel.base.arrays import Array
from lommel.core.answers import Declined, Intensities, ToleranceError
from lommel.methods.matrix_fourier import samples_needed
from lommel.methods.method import Method
from lommel.methods.pixels.averaging import filtered, filtered_by, least_average
from lommel.optics.aperture.opening import degree_needed
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil

_LEAST_EPS = 1e-14  # what FINUFFT reaches in double precision
_BLOCK_DEGREE = 16  # degrees are rounded up to these, so that neighbours share their nodes


@dataclass(frozen=True)
class NonuniformFFT(Method[Pupil]):
    r"""Gauss quadrature over the clear aperture, transformed onto the pixels by FINUFFT (type 1, two dimensions).

    Supports every pupil: any wavefront, spiders, vignetting, masks, apodization. Needs the optional library finufft,
    ``pip install finufft``.

    Parameters
    ----------
    tol : float, default 1e-6
        Target for the error of the intensity relative to the peak of the PSF, 1e-11 to below 0.1. It is tested, not
        proven: see the notes. `PSF.error_bound` is None.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    The nodes (:meth:`lommel.optics.aperture.opening.Opening.rule`) are exact to a total degree for which the error of
    U is proven to be below a quarter of the tolerance (:func:`lommel.optics.aperture.opening.degree_needed`), on
    discs, annuli and full ellipses. On other apertures the degree is the same, and the rule converged to about 1e-13.
    The precision asked of FINUFFT is another quarter; it is a requested relative accuracy of its kernel, measured by
    its authors, not proven. A mask is not integrated: its samples are the pupil, and are summed.

    Both parts are relative to the computed peak, in the window or on a coarse lattice over the whole blur; if that is
    lower than estimated, the sum is repeated. `integrate` filters finer samples, as derived in docs/certificate.md.

    References
    ----------
    A. H. Barnett, J. F. Magland and L. af Klinteberg, "A parallel non-uniform fast Fourier transform library based
    on an 'exponential of semicircle' kernel", SIAM J. Sci. Comput. 41, C479 (2019), doi:10.1137/18M120885X.
    """

    apodized = nonradial = any_aperture = True
    least_tol = 1e-11
    tol: float = 1e-6

    def intensity(self, pupil: Pupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return I at, or averaged over, the pixels, shape ``(n, height, width)``.

        Raises
        ------
        ImportError
            If finufft is not installed.
        ValueError
            If the samples of a mask are too coarse for the wavefront and the window.
        ToleranceError
            If double precision does not hold the tolerance, relative to the peak of the PSF.
        """
        library()
        if pupil.mask is not None:
            needed, why = samples_needed(pupil, grid)
            if needed > pupil.mask.side:
                raise Declined(
                    f"the mask of side {pupil.mask.side} is too coarse: {why} need a side of at least {needed:.5g}"
                )
        pupils = [pupil] if pupil.shape == () else [pupil[index] for index in np.ndindex(pupil.shape)]
        return Intensities(np.stack([self._image(one, grid, threads) for one in pupils]), None)

    def _image(self, pupil: Pupil, grid: Grid, threads: int) -> Array:
        amplitude, step = pupil.amplitude, grid.step(pupil)
        lowest = least_average(step) if grid.integrate else 1.0
        # Light spread evenly over the blur has this field; where it gathers the peak is brighter.
        blur = float(pupil.v(pupil.geometric_radius()))
        bright, seen = amplitude / (1.0 + blur), 0.0

        def samples(at: Grid, budget: float) -> Array:
            nonlocal seen
            found = self._sum(pupil, at, budget, threads)
            seen = max(seen, math.sqrt(float(found.max())))
            return found

        for _ in range(6):
            # I errs by 2 |U| times the error of U.
            budget = 0.125 * self.tol * lowest * bright
            if budget / amplitude < _LEAST_EPS:
                break
            image: Array
            if grid.integrate:
                taps = filtered_by(step, 0.05 * self.tol * lowest * (bright / amplitude) ** 2)
                image = np.empty(grid.shape)
                filtered(lambda fine: [samples(fine, budget)[None]], image[None, None], grid, taps, threads)  # noqa: B023
            else:
                image = samples(grid, budget)
            if seen < bright:
                # The peak, to which errors relate, may lie outside of the window.
                samples(Grid(64, max(0.5, blur / (30.0 * math.pi)) * pupil.scale), 1e-3 * bright)
            if seen >= bright:
                return image
            bright = 0.9 * seen
        raise ToleranceError(
            f"tol={self.tol:g} cannot be met in double precision: the peak of the PSF is "
            f"{(bright / amplitude) ** 2:.2g} of the unaberrated one; ask for a larger tol"
        )

    def _sum(self, pupil: Pupil, grid: Grid, budget: float, threads: int) -> Array:
        """Return the samples of a single pupil, with errors of U below `budget`."""
        step = grid.step(pupil)
        reach = step / grid.side * math.hypot(*(float(np.abs(part).max()) for part in (grid.x, grid.y)))
        terms = pupil.wavefront.amplitudes().items()
        degree = degree_needed([(n, w) for (n, _), w in terms], reach, pupil.illumination, budget)
        x, y, w = pupil.rule(math.ceil(degree / _BLOCK_DEGREE) * _BLOCK_DEGREE)
        phase = pupil.wavefront.phase(np.hypot(x, y), np.arctan2(y, x)).ravel()
        # An axis off the default place is a tilt of the pupil.
        down, across = step * (np.array([grid.height // 2, grid.width // 2]) - grid.axis)
        strengths = w * pupil.illumination.at(x * x + y * y) * np.exp(1j * (phase - down * y - across * x))
        eps = budget / pupil.amplitude
        # Modes run from -(n // 2), and the first axis of the answer belongs to the first coordinate.
        # Threads cost more than they save where there is little to do.
        most = min(threads or os.cpu_count() or 1, 1 + (x.size + grid.height * grid.width) // 2**19)
        plan = library().Plan(1, grid.shape, eps=eps, isign=-1, nthreads=most)
        plan.setpts(step * y, step * x)
        field = plan.execute(strengths)
        return np.asarray(field.real**2 + field.imag**2)


def library() -> Any:
    """Return finufft, or say how to get it."""
    return optional.library("finufft", "NonuniformFFT needs", "nufft")
