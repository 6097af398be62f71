"""Quadrature along the rows of any aperture, summed by a non-uniform FFT: every pupil, with a proven error bound."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Declined, Images, Intensities, Slopes, Wanted, not_met
from lommel.core.engine import row_images
from lommel.methods.matrix_fourier import samples_needed
from lommel.methods.method import Method, once_stored, painted, relative_error, storing
from lommel.methods.moment_rule import degrees_and_error, field_sums, moment_rule, phase_roundings, worth
from lommel.methods.nijboer_zernike import disk_stack, window_of
from lommel.methods.pixels.averaging import averaged_images
from lommel.optics.aperture.opening import degree_needed
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil

_LEAST = 4e-15  # error of U that is asked for, over its largest value
_SUMS = 0.25  # of the error of U, what sums may lose
_FEWER = 0.75  # of the pixels, what those on one side of the axis may be for others to be their mirror images


@dataclass(frozen=True)
class NonuniformFFT(Method[Pupil]):
    r"""Gauss quadrature along the rows of the clear aperture, transformed onto the pixels by two non-uniform FFTs.

    Supports all pupils of a lens: any wavefront, spiders, vignetting, stops of any shape, segments, masks, apodized.

    Parameters
    ----------
    tol : float, default 1e-6
        Bound on ``max|I - I_exact| / max I``, 1e-12 to below 0.1; max I is the largest value in the window, or that
        found on a coarse lattice over the whole blur. It is a contract: :class:`ToleranceError` is raised if it
        cannot be met. A mask is the sum of its samples.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    Lines of constant y cut the aperture in intervals. Gauss-Legendre rules along these, and across them between the
    places where edges meet, are off by a proven amount for every polynomial of a degree that is at most 1 on the unit
    disc; and a polynomial of that degree is proven to be close to the integrand there
    (:func:`lommel.optics.aperture.opening.degree_needed`). Waves of the nodes of a row are added to a fine grid by
    the taps of a kernel and transformed to the columns, those of the rows likewise to the pixels; aliases of it and
    all roundings are bounded too. Derived in docs/certificate.md, section 18. Averages over pixels filter samples.
    Small windows of many fields (stacks, derivatives) are products of matrices with a rule of the disc that has the
    moments of the aperture (``lommel.methods.moment_rule``).

    References
    ----------
    Lloyd N. Trefethen, Approximation Theory and Approximation Practice (2013), Theorem 19.3: the bound on Gauss's
    rule. Magnus Lundin, "The extremal PSH for the complement of convex, symmetric subsets of R^N", Michigan Math. J.
    32, 197 (1985), doi:10.1307/mmj/1029003186: how fast polynomials grow off the disc.
    Alok Dutt and V. Rokhlin, "Fast Fourier transforms for nonequispaced data", SIAM J. Sci. Comput. 14, 1368 (1993),
    doi:10.1137/0914081.
    """

    apodized = nonradial = any_aperture = True
    tol: float = 1e-6

    def intensity(self, pupil: Pupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return I at, or averaged over, the pixels, shape ``(n, height, width)``, with its bound."""
        return self.images(pupil, grid, Wanted(threads=threads)).intensities

    def images(self, pupil: Pupil, grid: Grid, wanted: Wanted) -> Images:
        """Return the images of the flattened stack; see :meth:`lommel.Method.images`."""
        if wanted.powers:
            raise ValueError("derivatives by powers of rho are not available from NonuniformFFT; use Zernike terms")
        if wanted.terms and wanted.scale is None:
            raise ValueError('derivatives of values divided by their largest one are not available: normalize="peak"')
        grid.require_one_axis()
        if grid.integrate:
            from lommel.methods.pixels.aperture_nodes import averaged_apertures

            made = averaged_apertures(pupil, grid, self.tol, wanted)
            if made is not None:
                return made
        # Errors of averages are over the largest anywhere, as those of samples in a dark window need not be.
        sample = partial(_sampled, everywhere=True) if grid.integrate else _sampled
        return averaged_images(sample, pupil, grid, self.tol, wanted)


def _sampled(pupil: Pupil, grid: Grid, tol: float, wanted: Wanted, *, everywhere: bool = False) -> Images:
    """Return samples of the flattened stack, with bounds over the peak below `tol` once they are stored."""
    if pupil.mask is not None and not pupil.mask.squares:
        needed, why = samples_needed(pupil, grid)
        if needed > pupil.mask.side:
            raise Declined(
                f"the mask of side {pupil.mask.side} is too coarse: {why} need a side of at least {needed:.5g}"
            )
    room = tol - (1.0 + tol) * storing(wanted.dtype)
    if wanted.scale is None:
        room *= 0.49  # values divided by their own largest one are off by twice as much
    # Light spread evenly over a blur has about this field; where it gathers the peak is brighter.
    bright = pupil.amplitude / (1.0 + sum(n * w for (n, _), w in pupil.wavefront.amplitudes().items() if n > 1))
    elsewhere: Array | None = np.zeros(math.prod(pupil.shape)) if wanted.scale is None else None
    for _ in range(8):
        asked = max(0.45 * room * bright / pupil.amplitude, _LEAST)
        values, slopes, off, off_slopes = _sums(pupil, grid, asked, wanted)
        peak = values.max(axis=(1, 2))
        made, error = _judged(values, peak if elsewhere is None else np.maximum(peak, elsewhere), off, wanted)
        if elsewhere is None and (error > tol or (everywhere and float(peak.min()) < bright**2)):
            elsewhere = _elsewhere(pupil, max(asked, 1e-4 * bright / pupil.amplitude), wanted.threads)
            made, error = _judged(values, np.maximum(peak, elsewhere), off, wanted)
        if error <= tol or asked <= _LEAST:
            break
        # Budgets follow the peak that was found.
        assert made.peak is not None
        bright = min(0.9 * math.sqrt(max(float(made.peak.min()), 1e-300)), 0.5 * bright)
    if not error <= tol:
        raise not_met(tol, error, "the peak")
    answer = painted(made, grid, wanted)
    if not wanted.terms:
        return answer
    peak = np.asarray(made.peak)
    # I' = 2 Re(conj(U) U'), and |U'| is at most what light there is.
    rise = 2.0 * (np.sqrt(peak) * off_slopes + (pupil.amplitude + off_slopes) * off) / peak
    scaled = (slopes * answer.scale[:, None, None]).astype(wanted.dtype)
    error = rise + (np.abs(slopes).max(axis=(2, 3)) / peak + rise) * storing(wanted.dtype)
    return answer._replace(slopes=Slopes(scaled, error))


def _judged(values: Array, peak: Array, off: Array, wanted: Wanted) -> tuple[Intensities, float]:
    """Return intensities with bounds over a peak, from those of U, and the largest of these once they are stored."""
    made = Intensities(values, relative_error(peak[:, None], off), peak)
    return made, float(np.max(once_stored(made, wanted)))  # type: ignore[arg-type]


def _elsewhere(pupil: Pupil, error: float, threads: int) -> Array:
    """Return what the peak of each PSF is at least, from a coarse lattice over all the blur."""
    blur = float(pupil.v(pupil.geometric_radius()).max())
    far = Grid(64, max(0.5, blur / (30.0 * math.pi)) * pupil.scale)
    values, _, off, _ = _sums(pupil, far, error, Wanted(threads=threads))
    return np.asarray(np.maximum(np.sqrt(values.max(axis=(1, 2))) - off, 0.0) ** 2)


def _real(pupil: Pupil) -> bool:
    """Return whether the pupil function is real, so that images are the same turned by half a turn."""
    return pupil.wavefront.flat and not pupil.phase_mask and not pupil.opening.phases.any()


def _half(grid: Grid) -> Grid | None:
    """Return pixels on one side of the axis that tell all others, or None where they are not much fewer."""
    if not grid.mirrored:
        return None
    down, across = (max(c, side - 1 - c) for c, side in zip(grid.axis, grid.shape, strict=True))
    first = grid.axis[1] % 1.0
    shape = int(2.0 * down) + 1, int(across - first) + 1
    if math.prod(shape) > _FEWER * math.prod(grid.shape):
        return None
    return Grid(shape, grid.pixel, center=(down, -first))


def _mirrored(values: Array, half: Grid, grid: Grid) -> Array:
    """Return images on the pixels of `grid` from those on the :func:`_half` of them."""
    (row, column), (down, _) = grid.axis, half.axis
    left, top, end = math.ceil(column), int(down - row), int(down + row) + 1
    out = np.empty((len(values), *grid.shape))
    out[:, :, left:] = values[:, top : top + grid.height, : grid.width - left]
    near = int(left == column)  # the column on the axis has no mirror image
    turned = values[:, end - grid.height : end, near : near + left]
    out[:, :, :left] = turned[:, ::-1, ::-1]
    return out


def _sums(pupil: Pupil, grid: Grid, error: float, wanted: Wanted) -> tuple[Array, Array, Array, Array]:
    """Return I, its derivatives, and bounds on the errors of U and of its derivatives by any term of `wanted`.

    `error` is that of U over its largest value, which the bounds will be close to.
    """
    half = None if wanted.terms or not _real(pupil) else _half(grid)
    if half is not None:
        values, slopes, off, off_slopes = _sums(pupil, half, error, wanted)
        return _mirrored(values, half, grid), slopes, off, off_slopes
    step, amplitude = grid.step(pupil), pupil.amplitude
    reach = step / grid.side * math.hypot(*(float(np.abs(part).max()) for part in (grid.x, grid.y)))
    factor = max((n for n, _ in wanted.terms), default=0)
    phases = pupil.opening.phases.copy()
    if pupil.mask is None:
        phases[:, 0] = np.remainder(phases[:, 0] + math.pi, 2.0 * math.pi) - math.pi
        terms = [(n, w) for (n, _), w in pupil.wavefront.amplitudes().items()]
        steepest = float(np.hypot(phases[:, 1], phases[:, 2]).max())
        aim = 0.3 * error * amplitude
        degree, fine, missed = degrees_and_error(pupil, reach, aim)
        degree, fine = degree + factor, fine + factor
        if worth(pupil, grid, wanted.terms, degree, fine, aim):
            rule = moment_rule(pupil.opening, degree, fine, aim)
            values, slopes, lost = field_sums(rule, pupil, grid, wanted.terms)
            off, off_slopes = np.tile((missed + 1.1 * aim + lost)[:, None], len(values))
            return values, slopes, off, off_slopes
        rules = pupil.opening.rows(degree_needed(terms, reach + steepest, pupil.illumination, aim) + factor, aim)
    else:
        phases, rules, missed = np.zeros((1, 3)), pupil.samples, phase_roundings(pupil)
    window = window_of(pupil, grid)
    values, slopes, lost = row_images(rules, phases, disk_stack(pupil), window, 0.5 * _SUMS * error, wanted)
    if pupil.mask is not None and pupil.mask.squares:
        down, across = (np.sinc(step / grid.side / (math.pi * pupil.mask.side) * at) ** 2 for at in (grid.y, grid.x))
        cells = down[:, None] * across
        values, slopes = values * cells, slopes * cells
    off = missed + lost
    return values, slopes, off, off
