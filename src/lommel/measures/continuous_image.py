"""Continuous image sampled by the values of a PSF: light per area at any point, light in circles and rectangles.

The image e at the position r is the intensity of a point source, convolved with each blur and, if pixels integrate,
with the pixel. Its Fourier transform is the optical transfer function (OTF) times factors B of blur and S of pixels,

    e(r) = int OTF(f) B(f) S(f) exp(2 pi i f.r) d^2 f ,

as a fraction of all light per area. The fraction of all light within the radius R of the point c is

    E(R) = int OTF(f) B(f) S(f) exp(2 pi i f.c) R J1(2 pi R abs(f)) / abs(f) d^2 f .

Two classes represent an image. :class:`PolarImage`, for radially symmetric lenses and lenses seen through
turbulence, computes the OTF from the pupil, at Gauss nodes along the radial frequency. :class:`CartesianImage`, for
all pupils, uses the discrete Fourier transform of samples, times a cut-off function. This function is 1 (to 1e-8) up
to the band, the highest frequency with a nonzero OTF in cycles per lambda*N, and falls smoothly to 0 at twice the
band. It hardly changes E(R), because it is 1 wherever the OTF is not 0. Its Fourier transform, called its kernel, is
negligible at distances above 12 / band lambda*N. Samples farther than this outside the circle are therefore omitted.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache, partial
from itertools import pairwise
from typing import NamedTuple, cast

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.cached import cached_property
from lommel.blur.blurs import Blur, Seeing
from lommel.blur.convolution import Short
from lommel.core.answers import Samples, ToleranceError, Wanted
from lommel.core.engine import product
from lommel.measures.aperture_means import gradient
from lommel.measures.overlap import autocorrelation, cells
from lommel.measures.psf_like import PSFLike, checked
from lommel.methods.choice import candidates, first_within_tolerance
from lommel.methods.chordal_gauss import ChordalGauss
from lommel.methods.layers.chordal_debye import ChordalDebye
from lommel.methods.method import Method, RadialMethod, beyond_period, with_model_error
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.methods.nonuniform_fft import NonuniformFFT
from lommel.methods.polychromatic import Polychromatic
from lommel.optics.aperture.mask import cell_centers
from lommel.optics.aperture.opening import Opening
from lommel.optics.aperture.shapes import Listed, listed
from lommel.optics.base_pupil import BasePupil
from lommel.optics.colour.spectrum import Component
from lommel.optics.grid import Grid
from lommel.optics.pupil import FieldPupil, Pupil
from lommel.special.legendre import gauss_legendre

_GAUSS = 0.5 / math.sqrt(3.0)  # distance of the two Gauss nodes from the middle, as a fraction of the interval


# Clear area of each square cell of an aperture. A line of constant y crosses an ellipse or a convex polygon in one
# interval. The area is the integral over y of the length of the interval within the cell. The range of y is split at
# edges of cells and at corners of the aperture, and further so that within a part no edge of the aperture advances by
# more than a column of cells; each part has two Gauss nodes. With straight edges that do not cross in a part, sums of
# areas along a row of cells are exact. The area of a cell is approximate if an edge enters the next column in a part.


def phased_cells(opening: Opening, side: int) -> NDArray[np.complex128]:
    """Return the means of the aperture times ``exp(i phase)`` over `side` x `side` cells of [-1, 1] x [-1, 1]."""
    means = np.zeros((side, side), dtype=np.complex128)
    centers = cell_centers(side)
    for region, phase in zip(opening.regions, opening.phases, strict=True):
        rows, columns, fractions = _covered_fractions(listed(region), side)
        if phase.any():
            x, y = centers[columns], centers[rows, None]
            mean = float(np.prod(np.sinc(phase[1:] / (math.pi * side))))
            means[rows, columns] += fractions * (mean * np.exp(1j * (phase[0] + phase[1] * x + phase[2] * y)))
        else:
            means[rows, columns] += fractions
    return means


def _covered_fractions(region: Listed, side: int) -> tuple[slice, slice, Array]:
    """Return the rows and columns of the cells around a region, and the fraction of each cell that it covers."""
    y, weight, row = _clear_lines(region, side)
    low, high = np.array([_intervals(region, k, y) for k in range(len(region.polygons))]).transpose(1, 0, 2)
    ends = np.sort(np.concatenate([low, high]), axis=0)
    # Between neighbouring ends a line is either clear or blocked throughout: test the midpoint.
    middle = 0.5 * (ends[1:] + ends[:-1])
    inside = [(a < middle) & (middle < b) for a, b in zip(low, high, strict=True)]
    is_clear = region.combined(inside, np.logical_and, np.logical_or, lambda a, b: a & ~b)
    is_clear &= ends[1:] > ends[:-1]
    piece, line = np.nonzero(is_clear)
    if not line.size:
        return slice(0, 0), slice(0, 0), np.zeros((0, 0))
    # The covered part of each cell along a line is a running sum: the start of an interval adds 1 to all cells after
    # it, the end of an interval subtracts 1. An edge at the fraction `part` of a cell changes the sum by 1 - part in
    # this cell and by part in the next.
    position = np.concatenate([ends[piece, line], ends[piece + 1, line]])
    position = np.clip(0.5 * side * (position + 1.0), 0.0, float(side))
    change = np.concatenate([weight[line], -weight[line]])
    first_cell = np.floor(position).astype(np.int64)
    first_row, first_column = int(row[line].min()), int(first_cell.min())
    shape = int(row[line].max()) + 1 - first_row, int(first_cell.max()) + 2 - first_column
    index = np.tile(row[line] - first_row, 2) * shape[1] + first_cell - first_column
    part = position - first_cell
    steps = np.bincount(index, change * (1.0 - part), math.prod(shape)) + np.bincount(
        index + 1, change * part, math.prod(shape)
    )
    covered = np.cumsum(steps.reshape(shape), axis=1)[:, : side - first_column]
    return slice(first_row, first_row + shape[0]), slice(first_column, first_column + covered.shape[1]), covered


def _clear_lines(region: Listed, side: int) -> tuple[Array, Array, NDArray[np.int64]]:
    """Return lines of constant y, their weights in units of the side of a cell, and the row of cells of each line."""
    cell, ellipses, events, spans = 2.0 / side, iter(region.ellipses), [], []
    for corners in region.polygons:
        if len(corners):
            events += [
                # The edge is split in steps of at most one column of cells.
                np.linspace(y0, y1, 2 + int(abs(x1 - x0) / cell) if y0 != y1 else 1)
                for (x0, y0), (x1, y1) in zip(corners, np.roll(corners, -1, axis=0), strict=True)
            ]
            spans.append((corners[:, 1].min(), corners[:, 1].max()))
        else:
            _, y, a, b, angle = next(ellipses)
            half_height = math.hypot(a * math.sin(angle), b * math.cos(angle))
            half_width = math.hypot(a * math.cos(angle), b * math.sin(angle))
            # The ellipse is split in steps of at most one column of cells, up to 0.8 of its half-width.
            height = half_height * np.sqrt(1.0 - np.linspace(0.0, 0.8, 2 + int(half_width / cell)) ** 2)
            events += [y + height, y - height]
            spans.append((y - half_height, y + half_height))
    # Smallest and largest y of the region.
    low, high = region.combined(
        spans,
        lambda a, b: (max(a[0], b[0]), min(a[1], b[1])),
        lambda a, b: (min(a[0], b[0]), max(a[1], b[1])),
        lambda a, _: a,
    )
    edges = np.unique(
        np.clip(np.concatenate([cell * np.arange(side + 1.0) - 1.0, *events]), max(low, -1.0), min(high, 1.0))
    )
    # Two Gauss nodes are exact for cubics; the covered length of a row is linear in y between straight edges.
    middle, heights = 0.5 * (edges[1:] + edges[:-1]), np.diff(edges)
    row = np.minimum((0.5 * side * (middle + 1.0)).astype(np.int64), side - 1)
    lines = np.concatenate([middle - _GAUSS * heights, middle + _GAUSS * heights])
    return lines, np.tile(0.25 * side * heights, 2), np.tile(row, 2)


def _intervals(region: Listed, part: int, y: Array) -> tuple[Array, Array]:
    """Return both ends in x of each line of constant `y` within a part of a region; both are 2 if there are none."""
    corners = region.polygons[part]
    if len(corners):
        (x0, y0), (x1, y1) = corners.T[:, :, None], np.roll(corners, -1, axis=0).T[:, :, None]
        crosses = (np.minimum(y0, y1) <= y) & (y < np.maximum(y0, y1))
        x = x0 + (x1 - x0) * np.divide(y - y0, y1 - y0, out=np.zeros(crosses.shape), where=crosses)
        low, high = np.where(crosses, x, np.inf).min(axis=0), np.where(crosses, x, -np.inf).max(axis=0)
        return np.where(low < high, low, 2.0), np.where(low < high, high, 2.0)
    x, middle, a, b, angle = region.ellipses[sum(len(polygon) == 0 for polygon in region.polygons[:part])]
    cos, sin = math.cos(angle), math.sin(angle)
    half_height = math.hypot(a * sin, b * cos)
    # Chord of a rotated ellipse: half length a b sqrt(tall^2 - up^2) / tall^2, with its middle on a straight line.
    dy = y - middle
    half_chord = a * b * np.sqrt(np.maximum(half_height**2 - dy**2, 0.0)) / half_height**2
    center = x + dy * (a * a - b * b) * sin * cos / half_height**2
    return np.where(half_chord > 0.0, center - half_chord, 2.0), np.where(half_chord > 0.0, center + half_chord, 2.0)


# OTF at low frequencies, for strong blur: the autocorrelation of the pupil at small shifts (docs/certificate.md,
# "From cells"). Each cell has the mean of the pupil function over its area. The autocorrelation of these means is the
# autocorrelation of the pupil, convolved twice with the square of a cell. The code corrects the values for the second
# moment of the squares, and the value at shift 0 for the cusp of the OTF. Cubic splines interpolate between cells.
# The error of the OTF is about 1e-6, or more if a shift by less than a cell opens or closes a gap; the error of the
# light is about 1e-6 of all light.

_MIN_CELLS = 32.0  # least number of cells within the largest shift


class SmallShifts(NamedTuple):
    """Cubic splines through the OTF of a single pupil, sampled at shifts by whole cells."""

    splines: tuple[Array, ...]  # real part, and the imaginary part unless it is zero
    side: int  # number of cells along the diameter of the aperture
    max_shift: int  # cells

    @classmethod
    def of(cls, pupil: Pupil, end: float) -> SmallShifts:
        """Return the splines for frequencies up to `end` times the cutoff frequency."""
        side = int(np.clip(2 ** math.ceil(math.log2(_MIN_CELLS / end)), 1024, 4096))
        return _small_shifts(pupil, side, min(math.ceil(end * side) + 4, side))

    def at(self, fx: Array, fy: Array) -> NDArray[np.complex128]:
        """Return the OTF at frequencies in units of the cutoff frequency."""
        positions = [self.side * f + self.max_shift for f in (fy, fx)]
        parts = [
            scipy.ndimage.map_coordinates(spline, positions, order=3, prefilter=False) for spline in self.splines
        ]
        return np.asarray(parts[0] if len(parts) == 1 else parts[0] + 1j * parts[1], dtype=np.complex128)


@lru_cache(maxsize=4)
def _small_shifts(pupil: Pupil, side: int, max_shift: int) -> SmallShifts:
    field = phased_cells(pupil.opening, side)
    rows, columns = np.nonzero(field)
    centers = cell_centers(side)
    x, y = centers[columns], centers[rows]
    rho = np.hypot(x, y)
    amplitude = np.ones(rho.size) if pupil.illumination.uniform else pupil.illumination.at(rho * rho)
    if pupil.wavefront.flat:
        field[rows, columns] *= amplitude
    else:
        theta = np.arctan2(y, x)
        # Mean over a cell along which the phase is linear: a sinc of the phase change along each side.
        amplitude *= np.prod(np.sinc(gradient(pupil.wavefront, rho, theta)[0] / (math.pi * side)), axis=0)
        field[rows, columns] *= amplitude * np.exp(1j * pupil.wavefront.phase(rho, theta))
    # Zero padding by the largest shift, so that no shifted product wraps around.
    size = scipy.fft.next_fast_len(side + max_shift + 1)
    spectrum = scipy.fft.fft2(field, (size, size))
    shifts = np.arange(-max_shift - 1, max_shift + 2)
    raw_otf = scipy.fft.ifft2(spectrum.real**2 + spectrum.imag**2)[np.ix_(shifts, shifts)].conj()
    # OTF = sum over cells * (area of a cell, (2 / side)^2) / (pi * transmission).
    raw_otf *= 4.0 / (math.pi * side**2 * pupil.transmission)
    otf = raw_otf[1:-1, 1:-1]
    # The averages over the cells of both pupils convolve the autocorrelation with a kernel of variance 1/6 (cells^2)
    # along each axis, which adds 1/12 of its Laplacian. Subtract this term, by the five-point stencil.
    neighbours = raw_otf[:-2, 1:-1] + raw_otf[2:, 1:-1] + raw_otf[1:-1, :-2] + raw_otf[1:-1, 2:]
    otf = otf - (neighbours - 4.0 * otf) / 12.0
    # Near the shift 0 the OTF is the cone 1 - c d, with the distance d in cells. The sum of its samples exceeds the
    # integral by 0.229 c (sum of k^-3 / (4 pi^2) over a lattice), which is subtracted from the sample at 0.
    center = otf[max_shift - 2 : max_shift + 3, max_shift - 2 : max_shift + 3].real
    slope = float(np.mean([1.0 - center[0, 2], 1.0 - center[4, 2], 1.0 - center[2, 0], 1.0 - center[2, 4]])) / 2.0
    otf[max_shift, max_shift] = 1.0 - 0.229 * slope
    parts = (otf.real, otf.imag) if np.abs(otf.imag).max() > 1e-12 else (otf.real,)
    return SmallShifts(tuple(scipy.ndimage.spline_filter(part, order=3) for part in parts), side, max_shift)


def transfer(pupil: Pupil, end: float, fx: Array, fy: Array) -> NDArray[np.complex128]:
    """Return the OTF of a single pupil at frequencies in units of the cutoff frequency, all below `end`."""
    if pupil.mask is None:
        return SmallShifts.of(pupil, end).at(fx, fy)
    shifts = pupil.mask.side * np.stack([fx.ravel(), fy.ravel()], axis=-1)
    return cells(pupil).between(shifts).reshape(fx.shape)


# Cut-off function c(f) = erfc((f / band - _MIDDLE) / _WIDTH) / 2; see docs/certificate.md, "From samples".
_KERNEL_REACH = 12.0  # the kernel of the cut-off is below 1e-10 at distances above _KERNEL_REACH / band, lambda*N
# In units of the band: c differs from 1 at f = band, and from 0 at f = 2 band, by erfc(4) / 2 = 8e-9.
_MIDDLE, _WIDTH = 1.5, 0.125
KERNEL_NORM = 3.94
"""Integral of the modulus of the cut-off's kernel over the plane, which bounds the growth of errors of samples."""
CUT_ERROR = 2e-8
"""Error of the light within a circle due to the cut-off, as a fraction of all light."""
_NEGLIGIBLE = 1e-11  # frequencies at which the transfer function of the blur is smaller are omitted
MOST_SIDE = 6144
"""Largest number of samples along a side."""
_MAX_VALUES = 2**24  # largest number of samples or waves computed together, to limit the memory
_TAPER = 64.0  # width, lambda*N, of the margin in which the weights of samples for the OTF fall to 0
# Smallest numbers of directions over half a turn: for a radially symmetric OTF, and for any other OTF.
_MIN_ANGLES, _MIN_ANGLES_OTF = 48, 160


class ImageModel(NamedTuple):
    """Optics, blur and active pixel area (height, width; zeros for point-sampled values) of an image."""

    pupil: BasePupil
    method: Method
    blur: tuple[Blur, ...] = ()
    active: tuple[float, float] = (0.0, 0.0)

    @classmethod
    def of(cls, psf: PSFLike, scope: str = "image") -> ImageModel:
        """Return the model of a PSF; its pixels are included unless `scope` is "optics"."""
        validation.choice("of", scope, ("image", "optics"))
        checked(psf)
        return cls(psf.pupil, psf.method, psf.blur, psf.grid.active if scope == "image" else (0.0, 0.0))

    @property
    def radial_method(self) -> RadialMethod | None:
        """The method if its radial profile is the whole image (no blur, no pixel, radial pupil), else None."""
        return None if self.blur or self.active != (0.0, 0.0) else self.method.along_radius(self.pupil)

    @property
    def single_models(self) -> list[ImageModel]:
        """One model for each pupil of the flattened stack."""
        shape = self.pupil.shape
        return [self._replace(pupil=self.pupil[index]) for index in np.ndindex(shape)] if shape else [self]

    def response(self, fx: Array, fy: Array, wavelength: float | None) -> Array:
        """Return the transfer function of blur and pixel at frequencies in cycles per lambda*N."""
        scale = self.pupil.scale
        height, width = self.active
        response = np.sinc(fx * (width / scale)) * np.sinc(fy * (height / scale))
        for blur in self.blur:
            response = response * blur.transfer(fx / scale, fy / scale, wavelength=wavelength)
        return np.asarray(response)

    @property
    def parts(self) -> list[Component]:
        """With seeing, which depends on wavelength, one component for each wavelength; else a single component."""
        if any(isinstance(blur, Seeing) for blur in self.blur):
            return self.method.components(self.pupil)
        return [Component(1.0, 1.0, self.pupil)]

    @property
    def cutoff(self) -> float:
        """Cutoff frequency of the optics at the shortest wavelength, cycles per lambda*N."""
        # A cell of a mask extends beyond the rim of the aperture by up to half the diagonal of the cell.
        mask = getattr(self.pupil, "mask", None)
        return self.method.stretch(self.pupil) * (1.0 if mask is None else 1.0 + math.sqrt(2.0) / mask.side)

    @property
    def _short_blur(self) -> Short:
        """Gaussian and motion blur; lengths in the optical unit v, pi at lambda*N."""
        return Short.of(self.blur, self.pupil.scale)

    @property
    def band(self) -> float:
        """Highest frequency, up to `cutoff`, at which the transfer function of the blur exceeds 1e-11."""
        scale, f = self.pupil.scale, np.linspace(0.0, self.cutoff, 1025)
        # Gaussian blur passes the highest frequencies along the direction in which it is narrowest.
        variance = float(np.linalg.eigvalsh(self._short_blur.covariance)[0]) / math.pi**2
        transmitted = np.exp(-2.0 * math.pi**2 * variance * f**2)
        # Seeing is weakest at the longest wavelength.
        longest = max((part.pupil.wavelength for part in self.parts if part.pupil.wavelength), default=None)
        for blur in self.blur:
            if isinstance(blur, Seeing):
                transmitted = transmitted * blur.transfer(f / scale, wavelength=longest)
        last = int(np.flatnonzero(transmitted > _NEGLIGIBLE)[-1])
        return float(f[min(last + 1, f.size - 1)])

    @property
    def blur_extent(self) -> tuple[float, float]:
        """Radius of pixel and blur other than seeing, and the largest width of the seeing, lambda*N."""
        scale = self.pupil.scale
        gaussian, streaks = self._short_blur
        # The fraction exp(-6.5^2 / 2) = 7e-10 of a Gaussian lies beyond 6.5 standard deviations.
        radius = 6.5 * math.sqrt(max(float(np.linalg.eigvalsh(gaussian)[-1]), 0.0))
        radius += 0.5 * float(np.hypot(*streaks.T).sum())
        widths = [
            1.0 / (blur.coherence(part.pupil.wavelength) * scale)
            for part in self.parts
            for blur in self.blur
            if isinstance(blur, Seeing)
        ]
        return radius / math.pi + 0.5 * math.hypot(*self.active) / scale, max(widths, default=0.0)

    @property
    def extent(self) -> float:
        """Approximate distance from the axis within which most of the light falls, lambda*N."""
        rays = float(np.max(self.pupil.geometric_radius(), initial=0.0)) / self.pupil.scale
        blur_radius, seeing_width = self.blur_extent
        return rays + blur_radius + 1.5 * seeing_width + 2.5


@dataclass(frozen=True)
class CartesianImage:
    """An image as a sum of plane waves on a lattice of frequencies; lengths in lambda*N."""

    table: NDArray[np.complex128]  # amplitudes of the waves, shape (len(fy), len(fx))
    fy: Array  # frequencies, cycles per lambda*N; fx >= 0 only: the table includes both waves of conjugate pairs
    fx: Array
    band: float  # highest frequency with a nonzero OTF (`ImageModel.band`), cycles per lambda*N
    error: float  # bound on the error of the samples, light per area; NaN if the method has no error bound

    def derivatives(self, x: float, y: float) -> Array:
        """Return light per area at a point and its derivatives, [i, j] of order i along y and j along x, (3, 3)."""
        # Each derivative multiplies a wave by 2 pi i f.
        orders = np.arange(3)
        waves = np.exp(2j * math.pi * x * self.fx)[:, None] * (2j * math.pi * self.fx)[:, None] ** orders
        rows = np.exp(2j * math.pi * y * self.fy)[:, None] * (2j * math.pi * self.fy)[:, None] ** orders
        return np.asarray((rows.T @ (self.table @ waves)).real)

    def on(self, x: Array, y: Array) -> Array:
        """Return light per area on a lattice of points, shape ``(len(y), len(x))``."""
        columns = np.exp(2j * math.pi * np.outer(self.fx, x))
        rows = np.exp(2j * math.pi * np.outer(y, self.fy))
        return np.asarray((rows @ (self.table @ columns)).real)

    def circles(self, radius: Array, center: tuple[float, float] = (0.0, 0.0)) -> Array:
        """Return the light within circles of each radius about `center`."""
        x, y = center
        shifted = (np.exp(2j * math.pi * y * self.fy)[:, None] * self.table) * np.exp(2j * math.pi * x * self.fx)
        squares, index = self._distances
        sums = np.bincount(index, shifted.real.ravel())
        f = np.sqrt(squares[1:]) * (self.fx[1] - self.fx[0])
        # Fourier transform of a disc, pi r^2 at f = 0, else r J1(2 pi r f) / f: once for each distinct abs(f).
        fractions = np.empty(radius.size)
        for i, r in enumerate(radius):
            fractions[i] = math.pi * r * r * sums[0] + (r * scipy.special.j1(2.0 * math.pi * r * f) / f) @ sums[1:]
        return fractions

    @cached_property
    def _distances(self) -> tuple[NDArray[np.int64], NDArray[np.intp]]:
        """Distinct squared distances from f = 0, in steps of the lattice, and the index of each lattice point."""
        rows, columns = self.table.shape
        row = np.fft.fftfreq(rows, 1.0 / rows).round().astype(np.int64)
        squares, index = np.unique(np.add.outer(row**2, np.arange(columns) ** 2).ravel(), return_inverse=True)
        return squares, index.ravel()

    def rectangle(self, low: tuple[float, float], high: tuple[float, float]) -> float:
        """Return the light in a rectangle between two corners (x, y)."""

        def side(f: Array, a: float, b: float) -> NDArray[np.complex128]:
            return np.asarray((b - a) * np.sinc(f * (b - a)) * np.exp(1j * math.pi * (a + b) * f))

        return float((side(self.fy, low[1], high[1]) @ (self.table @ side(self.fx, low[0], high[0]))).real)


def cartesian_images(model: ImageModel, reach: float) -> Iterator[CartesianImage]:
    """Yield the images of a flattened stack, valid up to `reach` lambda*N from the axis along x and y."""
    # The cut-off adds less than 2e-8 to the error of the light within a circle. With seeing, whose halo has no finite
    # extent, the error is up to about 1e-5.
    pupil, band = model.pupil, model.band
    cutoff = model.cutoff
    # With 1 / pitch >= cutoff + 2 band no alias reaches the frequencies that the cut-off passes (docs/certificate.md,
    # "From samples").
    pitch = 1.0 / max(cutoff + 2.0 * band, 4.0 * band)
    blur_radius, seeing_width = model.blur_extent
    # Farther than `half_side` from the axis samples are omitted: the kernel of the cut-off is below 1e-10 there.
    half_side = reach + _KERNEL_REACH / band + blur_radius
    half_side += seeing_margin(reach, seeing_width)
    period = model.method.period(pupil)
    if reach <= 0.5 * period < half_side and period == pupil.period and not seeing_width:
        # The image of a sampled mask is periodic, with or without blur: one period is the whole image.
        side = scipy.fft.next_fast_len(math.ceil(period / pitch), real=True)
        pitch, half_side = period / side, 0.5 * period
    else:
        side = scipy.fft.next_fast_len(2 * math.ceil(half_side / pitch) + 1, real=True)
    if half_side > (largest := 0.5 * pitch * MOST_SIDE):
        raise _radius_error(pupil, reach, reach - (half_side - largest))
    grid = Grid(side, pitch * pupil.scale, integrate=model.method.sampling == "pixel")
    fy, fx = scipy.fft.fftfreq(side, pitch), scipy.fft.rfftfreq(side, pitch)
    in_band_y, in_band_x = np.abs(fy) <= 2.0 * band, fx <= 2.0 * band
    fy, fx = fy[in_band_y], fx[in_band_x]
    # Frequencies fx > 0 count twice, because rfft returns one wave of each conjugate pair.
    decay = (
        0.5
        * scipy.special.erfc((np.hypot(fy[:, None], fx) / band - _MIDDLE) / _WIDTH)
        * np.where(fx > 0.0, 2.0, 1.0)
        / side**2
    )
    parts = model.parts
    count = math.prod(pupil.shape)
    step = max(1, _MAX_VALUES // side**2)
    for start in range(0, count, step):
        block = np.arange(start, min(start + step, count))
        tables = np.zeros((block.size, fy.size, fx.size), dtype=np.complex128)
        error = np.zeros(block.size)
        for fraction, stretch, part in parts:
            pupils = part[np.unravel_index(block, part.shape)] if part.shape else part
            try:
                images = _sample(pupils, model.method, grid, sum_spectrum=len(parts) == 1)
            except (ValueError, ToleranceError) as fault:
                raise ValueError(f"{_radius_error(pupil, reach)}: {fault}") from fault
            # Convert intensity to a fraction of all light per area: the integral of the intensity over the plane in v
            # is 4 pi times the transmission, and lambda*N of this wavelength is v = pi.
            factor = fraction * stretch**2 * math.pi / (4.0 * part.transmission)
            response = model.response(fx[None, :], fy[:, None], part.wavelength) * (factor * decay)
            for k, image in enumerate(images.values):
                tables[k] += scipy.fft.rfft2(scipy.fft.ifftshift(image))[in_band_y][:, in_band_x] * response
            tops = images.values.reshape(block.size, -1).max(axis=1) if images.peak is None else images.peak
            error += factor * (math.nan if images.error is None else images.error) * tops
        for k, table in enumerate(tables):
            yield CartesianImage(table, fy, fx, band, float(error[k]))


def seeing_margin(reach: float, seeing_width: float) -> float:
    """Return the margin of samples beyond the radius `reach` that seeing of this width needs, all in lambda*N."""
    # With this margin at most 1e-5 of all light is missing or wraps around (docs/certificate.md, "From samples").
    return min(max(2.0 * reach, 20.0 * seeing_width), 30.0 * seeing_width)


def _radius_error(pupil: BasePupil, reach: float, largest: float | None = None) -> ValueError:
    """Return the ValueError for a circle, rectangle or point that needs too many samples."""
    limit = "" if largest is None or largest <= 0.0 else f" of at most {largest * pupil.scale:.3g} {pupil.unit}"
    return ValueError(
        f"a distance of {reach * pupil.scale:.4g} {pupil.unit} from the axis ({reach:.4g} lambda*N) is too far for a "
        f"pupil that is not a radially symmetric lens; use a smaller distance{limit}"
    )


def sampled_transfer(model: ImageModel, fx: Array, fy: Array) -> NDArray[np.complex128]:
    """Return the OTF with blur and pixel from samples of the image; fx, fy in cycles/(lambda*N); ``(n, len(fx))``."""
    # Samples extend 64 lambda*N beyond `ImageModel.extent`; their weights fall to 0 in this margin. The remaining
    # light is scope as diffraction at a hard edge, whose light per area falls as the inverse cube of the distance.
    # The error of the OTF is below 1e-3 up to a fifth of the cutoff (3e-4 without straight edges), and below 1e-4 at
    # higher frequencies.
    radius = model.extent + _TAPER
    cutoff = model.cutoff
    pitch, pupil = 0.25 / cutoff, model.pupil
    side = 2 * math.ceil(radius / pitch)
    grid = Grid(side, pitch * pupil.scale, integrate=model.method.sampling == "pixel")
    position = pitch * (np.arange(side) - side // 2)

    def weight(r: Array) -> Array:
        return np.asarray(0.5 * scipy.special.erfc((r - radius + 0.5 * _TAPER) / (_TAPER / 8.0)))

    weights = weight(np.hypot(position, position[:, None]))
    columns = np.exp(-2j * math.pi * np.outer(position, fx))
    rows = np.exp(-2j * math.pi * np.outer(fy, position))
    # The light of the tail, r^-3 (2 pi r dr), has a constant density in u = 1 / r, and the range of u is finite.
    u, rule = gauss_legendre(4096, 0.0, 1.0 / (radius - _TAPER))
    tail_transform = (rule * (1.0 - weight(1.0 / u))) @ scipy.special.j0(
        2.0 * math.pi * np.hypot(fx, fy) / u[:, None]
    )
    tail_transform /= rule @ (1.0 - weight(1.0 / u))
    otf = np.zeros((math.prod(pupil.shape), fx.size), dtype=np.complex128)
    parts = model.parts
    for fraction, stretch, part in parts:
        pupils = [part[index] for index in np.ndindex(part.shape)] if part.shape else [part]
        response = model.response(fx, fy, part.wavelength) * (np.hypot(fx, fy) < cutoff)
        factor = stretch**2 * math.pi / (4.0 * part.transmission) * pitch**2
        for k, single in enumerate(pupils):
            image = factor * weights * _sample(single, model.method, grid, sum_spectrum=len(parts) == 1).values[0]
            sampled = np.einsum("fy,yf->f", rows, image @ columns)
            otf[k] += fraction * response * (sampled + (1.0 - image.sum()) * tail_transform)
    return otf


def _sample(pupil: BasePupil, method: Method, grid: Grid, *, sum_spectrum: bool) -> Samples:
    """Return samples of I, summed over the spectrum of a :class:`Polychromatic` method if `sum_spectrum`."""
    method_used = method.method if isinstance(method, Polychromatic) and not sum_spectrum else method
    methods: tuple[Method, ...] = () if method_used is None else (method_used,)
    # A method with a proven error bound is replaced by the fastest one for this grid, with at most its tolerance.
    if method_used is None or isinstance(method_used, NijboerZernike | ChordalGauss | ChordalDebye):
        methods = candidates(pupil, grid, min(method.tol, Method.tol))

    def compute(candidate: Method) -> Samples:
        return with_model_error(candidate.images(pupil, grid, Wanted()), pupil, candidate, normalized=False)

    return first_within_tolerance(methods, compute)[1]


@dataclass(frozen=True)
class PolarImage:
    """An image as a sum of waves by frequency and direction; lengths in lambda*N."""

    model: ImageModel
    parts: list[PolarPart]
    band: float
    reach: float  # largest distance of points from the axis in `on` and `derivatives`

    def circles(self, radius: Array, center: tuple[float, float] = (0.0, 0.0)) -> Array:
        """Return the light within circles of each radius about `center`."""
        total = np.zeros(radius.size)
        for f, fx, fy, waves in self._waves(math.hypot(*center)):
            shifted = waves * np.exp(2j * math.pi * (center[0] * fx + center[1] * fy)) if any(center) else waves
            radial = shifted.real.sum(axis=1) / f
            total += [r * (scipy.special.j1(2.0 * math.pi * r * f) @ radial) for r in radius]
        return total

    def rectangle(self, low: tuple[float, float], high: tuple[float, float]) -> float:
        """Return the light in a rectangle between two corners (x, y)."""
        (x, y), (right, bottom) = low, high
        total = 0.0
        reach = max(math.hypot(a, b) for a in (x, right) for b in (y, bottom))
        for _, fx, fy, amplitudes in self._waves(reach):
            part = (right - x) * np.sinc(fx * (right - x)) * (bottom - y) * np.sinc(fy * (bottom - y))
            shifted = amplitudes * np.exp(1j * math.pi * ((x + right) * fx + (y + bottom) * fy))
            total += float((part * shifted.real).sum())
        return total

    def on(self, x: Array, y: Array) -> Array:
        """Return light per area on a lattice of points at equal steps, shape ``(len(y), len(x))``."""
        total = np.zeros((y.size, x.size))
        for _, fx, fy, amplitudes in self._all_waves:
            columns, rows = _plane_waves(fx.ravel(), x), _plane_waves(fy.ravel(), y) * amplitudes.ravel()
            total += product(rows.real, columns.real.T, 0) - product(rows.imag, columns.imag.T, 0)
        return total

    def derivatives(self, x: float, y: float) -> Array:
        """Return light per area at a point and its derivatives, [i, j] of order i along y and j along x, (3, 3)."""
        orders, total = np.arange(3), np.zeros((3, 3))
        for _, fx, fy, amplitudes in self._all_waves:
            shifted = (amplitudes * np.exp(2j * math.pi * (x * fx + y * fy))).ravel()
            rows, columns = ((2j * math.pi * f.ravel()[:, None]) ** orders for f in (fy, fx))
            total += ((rows * shifted[:, None]).T @ columns).real
        return total

    @cached_property
    def _all_waves(self) -> list[Waves]:
        return list(self._waves(self.reach))

    def _waves(self, reach: float) -> Iterator[Waves]:
        """Yield blocks of abs(f), fx, fy and amplitudes of waves, for points up to `reach` from the axis."""
        # Seeing depends on abs(f) only and is evaluated once for all directions.
        blurs = self.model.blur
        seeing = self.model._replace(active=(0.0, 0.0), blur=tuple(b for b in blurs if isinstance(b, Seeing)))
        without_seeing = self.model._replace(blur=tuple(b for b in blurs if not isinstance(b, Seeing)))
        reach = reach + self.model.blur_extent[0]
        for f, weight, otf, wavelength in self.parts:
            min_angles = _MIN_ANGLES if otf is None else _MIN_ANGLES_OTF
            # exp(2 pi i f.r) has azimuthal orders up to about 2 pi abs(f) abs(r).
            angles = min_angles + math.ceil(2.0 * math.pi * float(f.max()) * reach)
            # Half a turn suffices, because the waves of opposite directions are conjugate.
            theta = math.pi / angles * np.arange(angles)
            amplitudes = 2.0 * math.pi / angles * weight * seeing.response(f, np.zeros(f.shape), wavelength)
            count = max(1, _MAX_VALUES // (16 * angles))
            for start in range(0, f.size, count):
                block = slice(start, start + count)
                fx, fy = f[block, None] * np.cos(theta), f[block, None] * np.sin(theta)
                waves = amplitudes[block, None] * without_seeing.response(fx, fy, wavelength)
                yield f[block], fx, fy, waves.astype(np.complex128) if otf is None else waves * otf(fx, fy)


Waves = tuple[Array, Array, Array, NDArray[np.complex128]]


def _plane_waves(f: Array, x: Array) -> NDArray[np.complex128]:
    """Return exp(2 pi i f x) at equally spaced `x`, shape ``(len(x), len(f))``."""
    waves = np.empty((x.size, f.size), dtype=np.complex128)
    waves[0] = np.exp(2j * math.pi * x[0] * f)
    count = 1
    # Each pass doubles the number of rows by exp(i f (x + d)) = exp(i f x) exp(i f d), with one factor for all rows.
    while count < x.size:
        added = min(count, x.size - count)
        np.multiply(waves[:added], np.exp(2j * math.pi * (x[count] - x[0]) * f), out=waves[count : count + added])
        count += added
    return waves


class PolarPart(NamedTuple):
    """Quadrature over the OTF of one wavelength."""

    f: Array  # radial frequencies, cycles per lambda*N
    weight: Array  # quadrature weight of ``f df`` times the fraction of light, and times a radially symmetric OTF
    otf: Callable[[Array, Array], NDArray[np.complex128]] | None  # the OTF unless it is radially symmetric
    wavelength: float | None


Image = CartesianImage | PolarImage
"""Any class that computes the light within circles and rectangles."""


def images(model: ImageModel, reach: float) -> Iterator[Image]:
    """Return the images of a flattened stack, valid up to `reach` lambda*N from the axis."""
    if model.method.sampling == "pixel":
        name = type(model.method).__name__
        raise ValueError(f"method must compute diffraction for the light in circles, got {name}: sum its pixels")
    return (polar_images if is_radial_lens(model) or is_lens_in_seeing(model) else cartesian_images)(model, reach)


def energy_images(model: ImageModel, reach: float, name: str) -> Iterator[Image]:
    """Return :func:`images`; ValueError, with the name `name`, if `reach` exceeds half a period of the image."""
    if (period := model.method.period(model.pupil)) < math.inf:
        blur_radius, seeing_width = model.blur_extent
        edge = reach + (blur_radius + seeing_margin(reach, seeing_width) if seeing_width else 0.0)
        if edge > 0.5 * period * (1.0 + 1e-9):
            raise beyond_period(name if edge == reach else f"{name} with the halo of the seeing", edge, period)
    return images(model, reach)


def is_radial_lens(model: ImageModel) -> bool:
    """Return True for a radially symmetric lens and a method of scalar diffraction with a proven error bound."""
    method_used = model.method.method if isinstance(model.method, Polychromatic) else model.method
    if not (method_used is None or isinstance(method_used, NijboerZernike | ChordalGauss)):
        return False
    if not (isinstance(model.pupil, Pupil) and model.pupil.circular):
        return False
    return all(part.pupil.radial for part in model.method.components(model.pupil))


def is_lens_in_seeing(model: ImageModel) -> bool:
    """Return True for a lens with seeing and a method of scalar diffraction, for which PolarImage is used."""
    # A CartesianImage would need samples over the whole halo of the seeing.
    method_used = model.method.method if isinstance(model.method, Polychromatic) else model.method
    if not (method_used is None or isinstance(method_used, NijboerZernike | ChordalGauss | NonuniformFFT)):
        return False
    lens = isinstance(model.pupil, Pupil | FieldPupil) and math.isinf(model.pupil.period)
    return lens and any(isinstance(blur, Seeing) for blur in model.blur)


def point_images(model: ImageModel, reach: float) -> Iterator[CartesianImage | PolarImage]:
    """Return images of a flattened stack that have `derivatives`, valid up to `reach` lambda*N along x and y."""
    return (polar_images if is_lens_in_seeing(model) else cartesian_images)(model, reach)


def polar_images(model: ImageModel, reach: float) -> Iterator[PolarImage]:
    """Yield the images of a flattened stack, valid up to `reach` lambda*N from the axis."""
    # The error is about 1e-9 of all light for radially symmetric lenses. For other lenses transfer() computes the
    # OTF, and the error is about 1e-6 of all light.
    reach = math.sqrt(2.0) * reach  # the corner of the square of half-side `reach`
    if not is_radial_lens(model):
        for single in model.single_models:
            yield PolarImage(single, list(_directed_parts(single, reach)), single.band, reach)
        return
    band, (blur_radius, _) = model.band, model.blur_extent
    pupil = cast("Pupil", model.pupil)
    ray_radius = float(np.max(pupil.geometric_radius(), initial=0.0)) / pupil.scale
    parts = []
    for fraction, stretch, part in model.method.components(pupil):
        eps = part.obscuration
        # The autocorrelation of an annulus is singular at the shifts at which circles of the two copies touch.
        kinks = (0.0, 0.5 * (1.0 - eps), eps, 0.5 * (1.0 + eps), 1.0)
        ends = sorted({min(kink * stretch, stretch, band) for kink in kinks})
        f, weight = _radial_rule(ends, reach + blur_radius + 2.0 * ray_radius, 32)
        overlap = autocorrelation(part, np.stack([f / stretch, np.zeros(f.size)], axis=-1), 1e-11).real
        parts.append((f, fraction * overlap * weight * f, part.wavelength))
    for k in range(math.prod(pupil.shape)):
        polar_parts = [PolarPart(nodes, weights[k], None, wavelength) for nodes, weights, wavelength in parts]
        yield PolarImage(model, polar_parts, band, reach)


def _directed_parts(model: ImageModel, reach: float) -> Iterator[PolarPart]:
    """Yield a part for each wavelength of a single image whose OTF is not radially symmetric."""
    band, (blur_radius, _) = model.band, model.blur_extent
    ray_radius = float(np.max(model.pupil.geometric_radius(), initial=0.0)) / model.pupil.scale
    for fraction, stretch, part in model.method.components(model.pupil):
        end = min(stretch, band)
        f, weight = _radial_rule([0.0, end], reach + blur_radius + 2.0 * ray_radius, 64)
        otf = partial(_scaled_transfer, part, stretch, end / stretch)
        yield PolarPart(f, fraction * weight * f, otf, part.wavelength)


def _scaled_transfer(pupil: Pupil, stretch: float, end: float, fx: Array, fy: Array) -> NDArray[np.complex128]:
    return transfer(pupil, end, fx / stretch, fy / stretch)


def _radial_rule(ends: list[float], reach: float, least: int) -> tuple[Array, Array]:
    """Return Gauss nodes and weights between neighbouring `ends`, which resolve waves up to `reach` lambda*N."""
    f, w = [], []
    for low, high in pairwise(ends):
        # At both ends the autocorrelation has singular powers of 3/2: f = low + (high - low) sin^2(u) is smooth in u.
        waves = (high - low) * (reach + 2.0)
        u, rule = gauss_legendre(least + math.ceil(2.6 * waves), 0.0, 0.5 * math.pi)
        f.append(low + (high - low) * np.sin(u) ** 2)
        w.append(rule * (high - low) * np.sin(2.0 * u))
    return np.concatenate(f), np.concatenate(w)
