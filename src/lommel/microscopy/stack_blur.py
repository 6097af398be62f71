"""The image of a specimen, recorded plane by plane by a microscope, as a linear operator."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from functools import partial
from itertools import chain
from typing import Any, NamedTuple, cast

import numpy as np
import scipy
from numpy.typing import DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.threads import product, side_by_side
from lommel.core import engine
from lommel.deconvolve.linear import UNSEEN, LinearBlur, PartConsumer, Plane, PlaneOperator, Result, overlap
from lommel.measures.measured_psf import MeasuredPSF
from lommel.measures.spot import stage
from lommel.optics.layers.objective import out_of_focus
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.psf import PSF


class StackBlur(LinearBlur):
    """Three-dimensional blur of a microscope with one PSF, a linear operator; planes are channels.

    Parameters
    ----------
    psf : PSF or MeasuredPSF
        Stack over z in equal steps, with one plane at the brightest focus of the point, and with the step and pixels
        of the recording. The same PSF is used at all depths. Values are divided by their sum, so that light is
        conserved, except for light that leaves the recording. Outside the recording the specimen is assumed to be
        dark.
    shape : (int, int, int)
        Number of planes, height and width of the recording.
    dtype : float32 or float64, default float32
        Type of the computation, by zero-padded FFTs.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.
    """

    def __init__(self, psf: PSF | MeasuredPSF, shape: tuple[int, int, int], dtype: DTypeLike = np.float32) -> None:
        values, middle = kernel_of(psf)
        if not isinstance(shape, tuple | list) or len(shape) != 3:
            raise ValueError(f"shape must be (planes, height, width), got {validation.shown(shape)}")
        sides = [validation.integer("shape", side, least=1, most=validation.MAX_SIDE) for side in shape]
        self.dtype = validation.kind("dtype", dtype, np.float32, np.float64)
        self.channels, self.shape = sides[0], (sides[1], sides[2])
        fft_shape = [scipy.fft.next_fast_len(n + k - 1, real=True) for n, k in zip(sides, values.shape, strict=True)]
        kernel = np.zeros(fft_shape, self.dtype)
        kernel[tuple(slice(k) for k in values.shape)] = values
        self._size, self._transfer = fft_shape, scipy.fft.rfftn(np.roll(kernel, [-m for m in middle], axis=(0, 1, 2)))

    def forward(self, image: Values) -> Values:
        """Return the recording of a specimen `image`: see :meth:`lommel.imaging.LinearBlur.forward`."""
        return self._filtered(image, self._transfer)

    def adjoint(self, image: Values) -> Values:
        """Apply the transpose of :meth:`forward` to an `image`: see :meth:`lommel.imaging.LinearBlur.adjoint`."""
        return self._filtered(image, self._transfer.conj())

    def _filtered(self, image: Values, transfer: Values) -> Values:
        stack = scipy.fft.irfftn(scipy.fft.rfftn(self.planes(image), self._size) * transfer, self._size)
        stack = stack[: self.channels, : self.shape[0], : self.shape[1]]
        return np.ascontiguousarray(np.moveaxis(stack, 0, 2), self.dtype).reshape(image.shape)


Kernel = tuple[Array, tuple[int, int, int]]
"""Fractions of the light of a point in voxels (z, y, x), and the index of the voxel in which the point lies."""


def kernel_of(psf: PSF | MeasuredPSF) -> Kernel:
    """Return the fraction of the light of a point in each voxel, of sum 1, and the index of the point's voxel."""
    if isinstance(psf, MeasuredPSF):
        return psf.values, psf.point
    validation.instance("psf", psf, PSF)
    z, pupil = stage(psf), cast(ObjectivePupil, psf.pupil)
    steps = np.diff(z)
    if z.ndim != 1 or np.ptp(steps) > 1e-6 * np.abs(steps).max():
        raise ValueError(f"psf must be one stack over even steps of z, got steps {np.unique(steps)[:3]} metres")
    # The plane of the point: its brightest focus, z = 0 of that origin only.
    distances = out_of_focus(pupil)
    origin = int(np.abs(distances).argmin())
    if abs(distances[origin]) > 1e-6 * abs(steps[0]):
        raise ValueError(f"psf must have a plane at the brightest focus, the nearest is {distances[origin]:g} m off")
    if not psf.grid.centered:
        raise ValueError(f"psf must have its axis in the middle pixel, got center={psf.grid.center}")
    values = psf.values / psf.values.sum(dtype=np.float64)
    return values.astype(np.float64), (origin, values.shape[1] // 2, values.shape[2] // 2)


class _TileJob(NamedTuple):
    """A tile of one plane, transformed by a single FFT: rows and columns of its input and of its output.

    `output` and `source` are parts of planes; `output_in_tile` and `source_in_tile` are their positions in the tile.
    """

    output: Plane
    source: Plane
    source_in_tile: Plane
    output_in_tile: Plane


_MAX_MEMORY_RATIO = 3.0  # largest number of values in the transforms of a tile, relative to the recording
_MIN_VALUES = 2**23  # number of values that these transforms may have in any case
_MAX_KEPT = 2**22  # voxels of a specimen up to which the recorded fraction of the light of each is kept
_TILE_PIXELS_TOGETHER = 2**16  # pixels of tiles of several planes that are transformed together
_COLUMNS = (0, 4, 1, 5, 2, 6, 3, 7)  # order of the eight columns of a transform that the core filters together
_MIRROR_TOLERANCE = 1e-6  # largest difference between a kernel and its mirror image, relative to its largest value


class TiledBlur(PlaneOperator):
    """Convolution of a specimen with PSFs by FFTs of tiles, and its transpose.

    The specimen exceeds its recording by a margin on all sides. With several PSFs h_s the image is
    ``sum_s h_s * (w_s x)``. Results depend neither on the number of threads nor on the alignment of arrays in memory.

    Parameters
    ----------
    kernels : iterable of ndarray or Kernel
        PSFs h_s, all of one shape, used without normalisation. In arrays the point lies in the middle voxel.
    shape : (int, int, int)
        Planes, height and width of the recording.
    margin : (int, int)
        Planes and pixels by which the specimen exceeds the recording on either side.
    weights : ndarray, shape (PSFs, planes of the specimen), optional
        Weights w_s of each PSF at each plane of the specimen; ones by default.
    threads : int
        Number of threads, 0 for all processors.
    """

    def __init__(
        self,
        kernels: Iterable[Array | Kernel],
        shape: tuple[int, int, int],
        margin: tuple[int, int],
        *,
        weights: Array | None = None,
        threads: int = 0,
    ) -> None:
        others = iter(kernels)
        first_kernel, middle = _kernel(next(others))
        self.shape, self._margin, self._threads = shape, (margin[0], margin[1], margin[1]), threads
        self.whole = shape[0] + 2 * margin[0], shape[1] + 2 * margin[1], shape[2] + 2 * margin[1]
        sides = self._sides = first_kernel.shape
        # Voxels by which the PSF extends from its point towards lower and higher indices, along z, y and x.
        self._lower = middle
        self._upper = tuple(side - 1 - index for side, index in zip(sides, middle, strict=True))
        # The outermost planes also represent planes beyond the margin whose PSFs reach the recording. These two
        # attributes are the numbers of such planes at either end.
        self._before, self._after = (max(0, extent[0] - margin[0]) for extent in (self._upper, self._lower))
        self._depth: int = engine.fft_length(self.whole[0] + self._before + self._after)
        self._weights = np.ones((1, self.whole[0]), np.float32) if weights is None else weights.astype(np.float32)
        max_values = max(_MAX_MEMORY_RATIO * math.prod(shape), _MIN_VALUES) / self.whole[0]  # per plane of a tile
        # A single tile may be shorter than plane + PSF - 1: light that wraps around falls beyond the recording.
        sufficient_sides = [
            max(length, side + pixels + max(lower, upper), lower + 1 + upper)
            for length, side, pixels, lower, upper in zip(
                self.whole[1:], shape[1:], self._margin[1:], self._lower[1:], self._upper[1:], strict=True
            )
        ]
        single_sides = [int(scipy.fft.next_fast_len(side, real=True)) for side in sufficient_sides]
        self._is_single_tile = math.prod(single_sides) <= max_values
        self._tile = (single_sides[0], single_sides[1])
        if not self._is_single_tile:
            tile_height, tile_width = (
                _tile_side(side, kernel_side, int(math.sqrt(max_values)))
                for side, kernel_side in zip(self.whole[1:], sides[1:], strict=True)
            )
            self._tile = tile_height, tile_width
        self._together = max(1, _TILE_PIXELS_TOGETHER // math.prod(self._tile))
        self._limits, self._indices = self._recorded_ranges()
        # Recorded fraction of a point's light, (planes, ranges along y, ranges along x): see `_recorded_ranges`.
        self._seen = np.zeros((self.whole[0], *(limits.shape[1] for limits in self._limits)), np.float32)
        self._transfers: list[object] = []
        # Only one kernel is in memory at a time, as there may be many.
        for number, values in enumerate(chain([first_kernel], (_kernel(entry)[0] for entry in others))):
            self._add_transfer(number, values)
            self._add_recorded_share(number, values)
        self.weigh(1.0)
        self._spectra: Values | None = None  # lateral transforms of the planes of a tile

    def _add_transfer(self, number: int, kernel: Array) -> None:
        """Store the transform of the kernel with this number."""
        self._transfers.append(self._transfer(kernel, _mirror_symmetric(kernel)))

    def _transfer(self, kernel: Array, is_even: bool) -> Values:
        """Return the transform of a kernel with the point in the first voxel, ordered for `engine.filter_planes`.

        The lateral transform of an even kernel (mirror-symmetric along x and y) is real and even: half of the rows
        and half of the frequencies along z suffice. The shape is (rows, groups of eight columns, frequencies along z,
        values): the real parts of a group, then the imaginary parts.
        """
        middle = self._lower
        rows = self._tile[0] // 2 + 1 if is_even else self._tile[0]
        planes = self._depth // 2 + 1 if is_even else self._depth
        lateral = np.zeros((len(kernel), rows, self._tile[1] // 2 + 1), np.float32 if is_even else np.complex64)
        tile = np.zeros(self._tile, dtype=np.float32)
        for plane, values in enumerate(kernel):
            tile[: values.shape[0], : values.shape[1]] = values
            spectrum = scipy.fft.rfft2(np.roll(tile, [-index for index in middle[1:]], axis=(0, 1)))[:rows]
            lateral[plane] = spectrum.real if is_even else spectrum
        groups = -(-lateral.shape[2] // len(_COLUMNS))
        ordered = np.empty((rows, groups, planes, 2, len(_COLUMNS)), np.float32)
        along_z = np.zeros((self._depth, groups * len(_COLUMNS)), lateral.dtype)
        order = np.arange(len(kernel)) - middle[0]
        for row in range(rows):
            along_z[order, : lateral.shape[2]] = lateral[:, row]
            # Divided by the length here, because the core does not scale its inverse transform along z.
            transform = scipy.fft.rfft if is_even else scipy.fft.fft
            spectrum = transform(along_z, axis=0) / np.float32(self._depth)
            parts = spectrum.reshape(planes, groups, -1)[:, :, _COLUMNS].transpose(1, 0, 2)
            ordered[row, :, :, 0], ordered[row, :, :, 1] = parts.real, parts.imag
        return ordered.reshape(rows, groups, planes, -1)

    def spectrum(self, number: int) -> Values:
        """Return the transform of a kernel in the order of FFTs, shape (depth, rows, columns // 2 + 1), complex."""
        height, width = self._tile
        ordered: Any = self._transfers[number]
        rows, groups, planes, _ = ordered.shape
        parts = ordered.reshape(rows, groups, planes, 2, -1)[..., np.argsort(_COLUMNS)]
        spectrum = (parts[..., 0, :] + 1j * parts[..., 1, :]).transpose(2, 0, 1, 3).reshape(planes, rows, -1)
        spectrum = spectrum[..., : width // 2 + 1] * np.float32(self._depth)
        if planes < self._depth:  # of an even kernel
            spectrum = np.concatenate([spectrum, spectrum[1 : (self._depth + 1) // 2][::-1].conj()])
            row = np.arange(height)
            spectrum = spectrum[:, np.minimum(row, height - row)]
        return np.asarray(spectrum)

    def _recorded_ranges(self) -> tuple[list[NDArray[np.intp]], list[NDArray[np.intp]]]:
        """Return the distinct ranges of recorded kernel pixels along y and x, and the range number of each row.

        Ranges of kernel pixels, shape (first and stop, ranges), depend on the position of the point: they differ near
        the edges and are equal in the middle. For either axis the second result has the range number of each row (or
        column) of the specimen.
        """
        limits, indices = [], []
        for axis in (1, 2):
            first_pixel = self._margin[axis] + self._lower[axis] - np.arange(self.whole[axis])
            ranges = np.clip(np.stack([first_pixel, first_pixel + self.shape[axis]]), 0, self._sides[axis])
            distinct_ranges, index = np.unique(ranges, axis=1, return_inverse=True)
            limits.append(distinct_ranges)
            indices.append(index.ravel())
        return limits, indices

    def _add_recorded_share(self, number: int, kernel: Array) -> None:
        """Add the fraction of a kernel's light that falls on the recording to the table for each plane."""
        (top, bottom), (left, right) = self._limits
        # Cumulative sums of the kernel over the recorded planes, for each plane of the specimen.
        cumulative = np.pad(kernel, ((1, 0), (1, 0), (1, 0))).cumsum(axis=0)
        for place in range(-self._before, self.whole[0] + self._after):
            plane = min(max(place, 0), self.whole[0] - 1)
            weight = self._weights[number, plane]
            if weight == 0.0:
                continue
            begin = self._margin[0] + self._lower[0] - place
            low, high = np.clip((begin, begin + self.shape[0]), 0, len(kernel))
            # Sums over rectangles from cumulative sums, at four corners.
            sums = (cumulative[high] - cumulative[low]).cumsum(axis=0).cumsum(axis=1)
            bands = sums[bottom] - sums[top]
            self._seen[plane] += weight * (bands[:, right] - bands[:, left])

    def forward(self, specimen: Values, consume: PartConsumer[Result]) -> list[Result]:
        """Compute the recording of a specimen, call `consume` once with each part of it, and return its results."""
        results: list[Result] = []
        for job in self._tile_jobs(self.shape, self.whole, self._upper, self._margin[1]):
            self._transform_planes(specimen, self.whole[0], job)
            self._filter_along_z(transposed=False)
            results += self._consume_planes(self.shape[0], job, consume)
        return results

    def adjoint(self, recording: Values, consume: PartConsumer[Result]) -> list[Result]:
        """Apply the transpose of :meth:`forward`, and call `consume` once with each part of the specimen."""
        results: list[Result] = []
        for job in self._tile_jobs(self.whole, self.shape, self._lower, -self._margin[1]):
            self._transform_planes(recording, self.shape[0], job)
            self._filter_along_z(transposed=True)
            results += self._consume_planes(self.whole[0], job, consume)
        return results

    def release(self) -> None:
        """Free the memory of transforms until the next :meth:`forward` or :meth:`adjoint`."""
        self._spectra = None

    def forget_seen(self) -> None:
        """Free the memory of the recorded fractions: :meth:`seen` and :meth:`per_seen` cannot be called again."""
        self._seen = np.zeros((0, 0, 0), np.float32)

    def seen(self, plane: int, rows: slice, columns: slice) -> Values:
        """Return the fraction of the light of each point in a part of the specimen that falls on the recording."""
        return self._look_up(self._seen[plane], rows, columns)

    def weigh(self, weight: float) -> None:
        """Set the weight by which :meth:`per_seen` divides."""
        self._weight = np.float32(weight)

    def per_seen(self, plane: int, rows: slice, columns: slice, /) -> Values:
        """Return ``1 / (seen * weight)``, or 0 where hardly any light is recorded (`UNSEEN`)."""
        return self._look_up(reciprocal(self._seen[plane] * self._weight), rows, columns)

    def _look_up(self, table: Values, rows: slice, columns: slice) -> Values:
        """Return the values of a table (ranges along y, ranges along x) at the pixels of a part of a plane."""
        by_row, by_column = self._indices
        return table[by_row[rows]].take(by_column[columns], axis=1)

    def _tile_jobs(
        self, shape: tuple[int, ...], source_shape: tuple[int, ...], lower: tuple[int, ...], shift: int
    ) -> Iterator[_TileJob]:
        """Yield the tiles of output planes of this shape.

        An output pixel at q depends on the source from ``q - lower`` to ``q + side - 1 - lower``, with the `side` of
        the kernel. The first pixel of the output lies at pixel `shift` of the source.
        """
        if self._is_single_tile:
            output, source = (_window((0, 0), sides[1:]) for sides in (shape, source_shape))
            begin, out_begin = max(-shift, 0), max(shift, 0)
            source_in_tile = _window((begin, begin), source_shape[1:])
            yield _TileJob(output, source, source_in_tile, _window((out_begin, out_begin), shape[1:]))
            return
        kernel = self._sides[1:]
        height, width = (tile - side + 1 for tile, side in zip(self._tile, kernel, strict=True))
        for row in range(0, shape[1], height):
            for column in range(0, shape[2], width):
                output = slice(row, min(row + height, shape[1])), slice(column, min(column + width, shape[2]))
                (rows, rows_in_tile), (columns, columns_in_tile) = (
                    overlap(part.start + shift - low, part.stop + shift - low + kernel_side - 1, side)
                    for part, side, low, kernel_side in zip(output, source_shape[1:], lower[1:], kernel, strict=True)
                )
                output_in_tile = _window(lower[1:], tuple(part.stop - part.start for part in output))
                yield _TileJob(output, (rows, columns), (rows_in_tile, columns_in_tile), output_in_tile)

    def _transform_planes(self, values: Values, planes: int, job: _TileJob) -> None:
        """Transform the tile laterally in each of the first `planes` planes, into `_spectra`."""
        if self._spectra is None:
            self._spectra = np.empty((self.whole[0], self._tile[0], self._tile[1] // 2 + 1), np.complex64)
        spectra = self._spectra

        def transform(first: int) -> None:
            some = slice(first, min(first + self._together, planes))
            tiles = np.zeros((some.stop - first, *self._tile), np.float32)
            tiles[:, *job.source_in_tile] = values[some, *job.source]
            spectra[some] = scipy.fft.rfft2(tiles)

        side_by_side(transform, range(0, planes, self._together), self._threads)

    def _consume_planes(self, planes: int, job: _TileJob, consume: PartConsumer[Result]) -> list[Result]:
        """Transform the first `planes` spectra back, and call `consume` with the output of the tile in each plane."""
        spectra = self._spectra
        assert spectra is not None

        def transform_back(first: int) -> list[Result]:
            some = slice(first, min(first + self._together, planes))
            tiles = scipy.fft.irfft2(spectra[some], self._tile, overwrite_x=True)
            # Consumers are faster in contiguous memory.
            light = np.ascontiguousarray(tiles[:, *job.output_in_tile])
            return [consume(first + k, *job.output, each) for k, each in enumerate(light)]

        parts = side_by_side(transform_back, range(0, planes, self._together), self._threads)
        return list(chain.from_iterable(parts))

    def _filter_along_z(self, *, transposed: bool) -> None:
        """Convolve the spectra of the planes along z, in place, or apply the transpose."""
        assert self._spectra is not None
        # The specimen is assumed to continue unchanged beyond its outermost planes.
        engine.filter_planes(
            self._spectra,
            self._transfers,
            self._weights,
            self.shape[0],
            self._margin[0],
            self._before,
            self._after,
            self._depth,
            transposed,
            self._threads,
        )


def _kernel(kernel: Array | Kernel) -> Kernel:
    """Return a kernel and the index of its point, in the middle of an array."""
    if isinstance(kernel, tuple):
        return kernel
    return kernel, (kernel.shape[0] // 2, kernel.shape[1] // 2, kernel.shape[2] // 2)


def _mirror_symmetric(kernel: Array) -> bool:
    """Check that a kernel equals its mirror images along x and along y, about its middle pixel."""
    if kernel.shape[1] % 2 == 0 or kernel.shape[2] % 2 == 0:
        return False
    limit = _MIRROR_TOLERANCE * float(np.abs(kernel).max())
    return all(np.allclose(kernel, np.flip(kernel, axis), rtol=0.0, atol=limit) for axis in (1, 2))


def _tile_side(side: int, kernel: int, target: int) -> int:
    """Return the side (about `target` pixels) of tiles, so that as few tiles as possible cover `side` pixels."""
    # Tiles of less than twice the kernel would mostly consist of overlap.
    core = max(target, 2 * kernel) - kernel + 1
    pieces = math.ceil(side / core)
    return int(scipy.fft.next_fast_len(math.ceil(side / pieces) + kernel - 1, real=True))


def _window(start: tuple[int, ...], sides: tuple[int, ...]) -> Plane:
    """Return the slices of rows and columns with this start and these sides."""
    rows, columns = (slice(first, first + side) for first, side in zip(start, sides, strict=True))
    return rows, columns


_PHASE_STEP = 0.2  # radians: phase difference of neighbouring tabulated frequencies at the edge of the PSF
_VALUES_TOGETHER = 2**16  # values (planes and frequencies) in a task of a thread
_MAX_ON_AXIS = 0.4  # cycles per pixel: above, the table is along the diagonal, where aliases are farther away


_NEIGHBOUR_VALUE = {0: 0.0, 2: 1.0 / 8.0, 3: 1.0 / 6.0}  # value of a B-spline one voxel from its middle, by degree


class RadialTransfer:
    """Lateral transfer functions of rotationally symmetric PSFs, tabulated over the magnitude of the frequency.

    `side` is the side of the PSFs in pixels. With `pixels`, PSF values are averages over square pixels. The transfer
    function of a pixel is not rotationally symmetric, and is divided out of the table. `spline` is the degree of
    B-splines along rows and columns: the PSFs were divided by the transfer functions of the B-splines, and the table
    is multiplied by these.
    """

    def __init__(self, side: int, *, pixels: bool, spline: int = 0) -> None:
        self._given, half_side = (side, pixels, spline), side // 2
        self.spacing = _PHASE_STEP / (2.0 * math.pi * half_side)  # cycles per pixel
        self.frequencies = self.spacing * np.arange(math.ceil(math.sqrt(0.5) / self.spacing) + 2)
        pixel = np.arange(half_side + 1)
        on_axis = int(np.searchsorted(self.frequencies, _MAX_ON_AXIS))
        axis, diagonal = self.frequencies[:on_axis], self.frequencies[on_axis:] * math.sqrt(0.5)
        self._axis = np.cos(2.0 * math.pi * np.outer(pixel, axis)).astype(np.float32)
        self._diagonal = np.cos(2.0 * math.pi * np.outer(pixel, diagonal)).astype(np.float32)
        self._sampling = pixels, spline
        self._sampling_transfers = np.concatenate(
            [self._sampling_transfer(axis), self._sampling_transfer(diagonal) ** 2]
        )

    def __reduce__(self) -> tuple[object, ...]:
        # Tables are much larger than what they are made of, which is sent to workers.
        side, pixels, spline = self._given
        return partial(RadialTransfer, pixels=pixels, spline=spline), (side,)

    def _sampling_transfer(self, frequency: Values) -> Array:
        """Return the transfer function of pixels along one axis, divided by the transfer function of the B-spline."""
        pixels, spline = self._sampling
        transfer = np.sinc(frequency) if pixels else np.ones(frequency.shape)
        b = _NEIGHBOUR_VALUE[spline]
        # The B-spline has the values b, 1 - 2 b, b at voxels.
        return np.asarray(transfer / (1.0 - 2.0 * b * (1.0 - np.cos(2.0 * math.pi * frequency))))

    def __call__(self, kernel: Array) -> Values:
        """Return the transfer function of the planes of an even kernel, shape (frequencies, planes)."""
        # Cosines are even: pixels on both sides of the middle one are added first.
        values = _folded(_folded(kernel.astype(np.float32), 1), 2)
        # On an axis: the transform of sums over the other axis. On the diagonal: cosines along both axes.
        on_axis = product(values.sum(axis=1), self._axis)
        along_x = product(values.reshape(-1, values.shape[2]), self._diagonal).reshape(*values.shape[:2], -1)
        on_diagonal = np.einsum("yf,pyf->pf", self._diagonal, along_x)
        transfer = np.concatenate([on_axis, on_diagonal], axis=1) / self._sampling_transfers
        return np.ascontiguousarray(transfer.T, np.float32)

    def misfit(self, kernel: Array) -> float:
        """Return the rms difference between a kernel's transfer function and its table, relative to the function."""
        sides = 2 * kernel.shape[1], 2 * kernel.shape[2]
        half_side = kernel.shape[1] // 2
        # The phase factor shifts the middle pixel to the first position.
        exact = scipy.fft.rfft2(kernel, sides) * np.exp(
            2j * math.pi * half_side * (np.fft.fftfreq(sides[0])[:, np.newaxis] + np.fft.rfftfreq(sides[1]))
        )
        index, weight, sampling = self.interpolation(sides)
        table = self(kernel).T
        interpolated = (table[:, index] * (1.0 - weight) + table[:, index + 1] * weight) * sampling
        difference = exact.reshape(len(kernel), -1) - interpolated
        return float(np.sqrt((np.abs(difference) ** 2).sum() / (np.abs(exact) ** 2).sum()))

    def interpolation(self, tile: tuple[int, int]) -> tuple[Array, Array, Array]:
        """Return the interpolation in the table for each frequency of the transform of a tile.

        The arrays are (1) the index of the tabulated frequency below, (2) the weight of the frequency above, (3) the
        transfer function of pixel and spline, by which the interpolated value is multiplied.
        """
        row_frequency, column_frequency = np.fft.fftfreq(tile[0])[:, np.newaxis], np.fft.rfftfreq(tile[1])
        position = np.hypot(row_frequency, column_frequency).ravel() / self.spacing
        sampling = (self._sampling_transfer(row_frequency) * self._sampling_transfer(column_frequency)).ravel()
        return position.astype(np.intp), (position % 1.0).astype(np.float32), sampling.astype(np.float32)


def _folded(values: Values, axis: int) -> Values:
    """Return values along an axis of odd length from its middle on, with those on the other side added."""
    lower, upper = np.split(values, [values.shape[axis] // 2], axis)
    upper = upper.copy()
    np.moveaxis(upper, axis, 0)[1:] += np.moveaxis(lower, axis, 0)[::-1]
    return upper


class PlaneBlur(TiledBlur):
    """Convolution of each plane of the specimen with its own PSF, and the transpose.

    For each lateral spatial frequency, the planes of the recording are a matrix times the planes of the specimen.
    With rotationally symmetric PSFs the matrix depends on the magnitude of the frequency alone: matrices are computed
    at the tabulated frequencies of `transfer`, and interpolated linearly between them. `kernels` has one kernel,
    shape (planes, side, side), for each plane of the specimen with its margin.
    """

    def __init__(
        self,
        kernels: Iterable[Array],
        shape: tuple[int, int, int],
        margin: tuple[int, int],
        transfer: RadialTransfer,
        *,
        threads: int = 0,
    ) -> None:
        planes = shape[0] + 2 * margin[0]
        self._radial = transfer
        self._matrices = np.zeros((len(transfer.frequencies), shape[0], planes), np.float32)
        super().__init__(kernels, shape, margin, weights=np.eye(planes), threads=threads)
        index, weight, sampling = transfer.interpolation(self._tile)
        # Frequencies of a tile are grouped by the two tabulated frequencies between which they lie. Groups of about
        # the same size are computed together: each is padded by its last frequency, whose result is written again.
        order = np.argsort(index, kind="stable")
        groups = np.split(order, np.flatnonzero(np.diff(index[order])) + 1)
        groups.sort(key=len)
        self._tasks: list[tuple[NDArray[np.intp], NDArray[np.intp]]] = []  # tabulated frequencies below; frequencies
        while groups:
            count = max(1, _VALUES_TOGETHER // (planes * len(groups[-1])))
            some, groups = groups[-count:], groups[:-count]
            padded = [np.pad(group, (0, len(some[-1]) - len(group)), "edge") for group in some]
            below = index[[group[0] for group in some]].astype(np.intp)
            self._tasks.append((below, np.array(padded)))
        self._weight_above, self._weight_below = weight * sampling, (1.0 - weight) * sampling

    def _add_transfer(self, number: int, kernel: Array) -> None:
        """Add the kernel of a plane to the matrices; an outermost plane also represents the planes beyond it."""
        transfer = self._radial(kernel)
        before, after = (number == 0) * self._before, (number == self.whole[0] - 1) * self._after
        for plane in range(number - before, number + after + 1):
            # Plane p of the recording receives plane p - start of the kernel.
            start = plane - self._margin[0] - self._lower[0]
            low, high = max(start, 0), min(start + len(kernel), self.shape[0])
            if low < high:
                self._matrices[:, low:high, number] += transfer[:, low - start : high - start]

    def _filter_along_z(self, *, transposed: bool) -> None:
        """Multiply the planes at each lateral frequency by its matrix or the transpose, in place."""
        assert self._spectra is not None
        spectra = self._spectra.reshape(self.whole[0], -1)
        planes_in, planes_out = self.whole[0], self.shape[0]
        if transposed:
            planes_in, planes_out = planes_out, planes_in

        def multiply(task: tuple[NDArray[np.intp], NDArray[np.intp]]) -> None:
            below, frequencies = task
            values = np.take(spectra[:planes_in], frequencies, axis=1)  # (planes, groups, frequencies of a group)
            result: Values | float = 0.0
            for tabulated, weights in ((below, self._weight_below), (below + 1, self._weight_above)):
                matrices = self._matrices[tabulated]
                # The matrices are real: complex values are multiplied as pairs of real values.
                pairs = (values * weights[frequencies]).view(np.float32).swapaxes(0, 1)
                result += product(matrices.swapaxes(1, 2) if transposed else matrices, pairs)
            spectra[:planes_out, frequencies] = np.asarray(result).view(np.complex64).swapaxes(0, 1)

        side_by_side(multiply, self._tasks, self._threads)


class WideBlur(PlaneOperator):
    """Blur by wide PSFs: by their windows at every pixel, and by their tails at every `pitch`-th pixel.

    The tails are smooth: light is binned to the nodes of a coarse grid with linear weights, and the result is
    interpolated linearly between the nodes, so that the transpose is exact. Beyond the margin each plane of the
    specimen has the uniform brightness `outside`, which a deconvolution estimates, too. With this light, the
    recording of a uniform specimen is uniform.

    Parameters
    ----------
    windows : TiledBlur
        Blur by the windows of the PSFs.
    tails : iterable of ndarray
        Tails of the PSFs at the nodes, shape (planes, side, side).
    pitch : int
        Pixels between nodes of the coarse grid.
    weights : ndarray, optional
        Weights of the tails in each plane of the specimen, as in :class:`TiledBlur`.
    """

    outside: Values

    def __init__(
        self,
        windows: TiledBlur,
        tails: Iterable[Array],
        pitch: int,
        *,
        weights: Array | None = None,
        threads: int = 0,
    ) -> None:
        self._windows, self._threads = windows, threads
        self.shape, self.whole = windows.shape, windows.whole
        first_tail = next(others := iter(tails))
        margin = (windows.whole[0] - windows.shape[0]) // 2, (windows.whole[1] - windows.shape[1]) // 2
        half = first_tail.shape[1] // 2
        if half * pitch < margin[1]:
            raise ValueError(f"tails must cover the margin of {margin[1]} pixels, got {half} nodes of {pitch} pixels")
        nodes = [(side - 1) // pitch + 2 for side in windows.shape[1:]]
        self._tails = TiledBlur(
            chain([first_tail], others),
            (windows.shape[0], nodes[0], nodes[1]),
            (margin[0], half),
            weights=weights,
            threads=threads,
        )
        self._recording_weights = [
            _LinearWeights(side, 0, pitch, 0, count) for side, count in zip(windows.shape[1:], nodes, strict=True)
        ]
        self._specimen_weights = [
            _LinearWeights(side, margin[1], pitch, half, count + 2 * half)
            for side, count in zip(windows.whole[1:], nodes, strict=True)
        ]
        by_row, by_column = (axis.weights.sum(axis=0) for axis in self._specimen_weights)
        # A node represents pitch^2 pixels. Pixels beyond the specimen have the brightness `outside`.
        self._pixels_outside = np.maximum(float(pitch) ** 2 - np.outer(by_row, by_column), 0.0).astype(np.float32)
        self.outside = np.ones(windows.whole[0], np.float32)
        recorded = np.outer(*(axis.weights.sum(axis=0) for axis in self._recording_weights)).astype(np.float32)
        # Recorded fraction of the light of tails, by node.
        self._seen = _stored(self._tails, np.broadcast_to(recorded, self._tails.shape), transposed=True)
        self._tails.forget_seen()
        self.outside_seen = np.einsum("pyx,yx->p", self._seen, self._pixels_outside)
        self.outside_back = np.zeros(windows.whole[0], np.float32)
        self.weigh(1.0)

    def forward(self, specimen: Values, consume: PartConsumer[Result]) -> list[Result]:
        """Call `consume` with the recording of a specimen, as :meth:`TiledBlur.forward` does."""
        coarse = self._bin(specimen, self._specimen_weights)
        coarse += self.outside[:, np.newaxis, np.newaxis] * self._pixels_outside
        light = _stored(self._tails, coarse)
        return self._windows.forward(specimen, self._with_coarse(light, self._recording_weights, consume))

    def adjoint(self, recording: Values, consume: PartConsumer[Result]) -> list[Result]:
        """Call `consume` with the transpose of :meth:`forward`; set `outside_back`, the transpose for `outside`."""
        light = _stored(self._tails, self._bin(recording, self._recording_weights), transposed=True)
        self.outside_back = np.einsum("pyx,yx->p", light, self._pixels_outside)
        return self._windows.adjoint(recording, self._with_coarse(light, self._specimen_weights, consume))

    def release(self) -> None:
        """Free the memory of transforms until the next :meth:`forward` or :meth:`adjoint`."""
        self._windows.release()

    def seen(self, plane: int, rows: slice, columns: slice) -> Values:
        """Return the fraction of the light of each point in a part of the specimen that falls on the recording."""
        fraction = self._windows.seen(plane, rows, columns)
        lines = self._specimen_weights[0].interpolate(self._seen[plane])
        self._specimen_weights[1].add_interpolated(lines[rows], columns, fraction)
        return fraction

    def weigh(self, weight: float) -> None:
        """Set the weight by which :meth:`per_seen` divides."""
        self._weight, self._per = weight, None
        if math.prod(self.whole) <= _MAX_KEPT:
            rows, columns = slice(0, self.whole[1]), slice(0, self.whole[2])
            self._per = np.stack([self._per_seen(plane, rows, columns) for plane in range(self.whole[0])])

    def per_seen(self, plane: int, rows: slice, columns: slice, /) -> Values:
        """Return ``1 / (seen * weight)``, or 0 where hardly any light is recorded (`UNSEEN`)."""
        return self._per_seen(plane, rows, columns) if self._per is None else self._per[plane, rows, columns]

    def _per_seen(self, plane: int, rows: slice, columns: slice) -> Values:
        return reciprocal(self.seen(plane, rows, columns) * np.float32(self._weight))

    @property
    def per_outside(self) -> Values:  # type: ignore[override]
        """``1 / (weight * outside_seen)`` for each plane; `outside_seen` is the recorded light if `outside` is 1."""
        return reciprocal(self.outside_seen * np.float32(self._weight))

    def _bin(self, values: Values, axes: list[_LinearWeights]) -> Values:
        """Return planes binned to the nodes of the coarse grid with linear weights."""
        by_row, by_column = axes
        binned = np.empty((len(values), by_row.nodes, by_column.nodes), np.float32)
        together = max(1, _PIXELS_BINNED // values[0].size)  # small planes are binned together

        def bin_planes(first: int) -> None:
            planes = slice(first, first + together)
            binned[planes] = by_column.bin(by_row.bin(values[planes]).swapaxes(1, 2)).swapaxes(1, 2)

        side_by_side(bin_planes, range(0, len(values), together), self._threads)
        return binned

    def _with_coarse(
        self, light: Values, axes: list[_LinearWeights], consume: PartConsumer[Result]
    ) -> PartConsumer[Result]:
        """Return a consumer that adds interpolated coarse light to its values before it calls `consume`."""
        by_row, by_column = axes

        def add(plane: int, rows: slice, columns: slice, values: Values) -> Result:
            by_column.add_interpolated(by_row.interpolate(light[plane])[rows], columns, values)
            return consume(plane, rows, columns, values)

        return add


def _stored(blur: TiledBlur, light: Values, *, transposed: bool = False) -> Values:
    """Return the whole result of a blur, or of its transpose, and free the memory of its transforms."""
    operator, shape = (blur.adjoint, blur.whole) if transposed else (blur.forward, blur.shape)
    result = np.empty(shape, np.float32)

    def store(plane: int, rows: slice, columns: slice, values: Values) -> None:
        result[plane, rows, columns] = values

    operator(light, store)
    blur.release()
    return result


class _LinearWeights:
    """Weights of linear interpolation between the nodes of a coarse grid, for each pixel along an axis.

    `weights` has the shape (pixels, nodes). Nodes are `pitch` pixels apart, and node `lower` is at pixel `before`.
    """

    def __init__(self, side: int, before: int, pitch: int, lower: int, nodes: int) -> None:
        position = (np.arange(side) - before) / pitch + lower
        self._first = np.floor(position).astype(int)
        self.nodes, self.weights = nodes, np.zeros((side, nodes), np.float32)
        self.weights[np.arange(side), self._first] = 1.0 - (position - self._first)
        has_next = self._first + 1 < nodes
        self.weights[np.arange(side)[has_next], self._first[has_next] + 1] = (position - self._first)[has_next]

    def bin(self, values: Values) -> Values:
        """Return values (..., pixels, n) summed at the nodes, (..., nodes, n)."""
        result = np.zeros((*values.shape[:-2], self.nodes, values.shape[-1]), np.float32)
        for part, nodes in self._parts(slice(0, len(self.weights))):
            result[..., nodes, :] += product(self.weights[part, nodes].T, values[..., part, :])
        return result

    def interpolate(self, light: Values) -> Values:
        """Return light at the nodes, (..., nodes, n), interpolated at all pixels, (..., pixels, n)."""
        result = np.empty((*light.shape[:-2], len(self.weights), light.shape[-1]), np.float32)
        for part, nodes in self._parts(slice(0, len(self.weights))):
            result[..., part, :] = product(self.weights[part, nodes], light[..., nodes, :])
        return result

    def add_interpolated(self, light: Values, pixels: slice, values: Values) -> None:
        """Add light at the nodes, (n, nodes), interpolated at some pixels, to `values` (n, pixels)."""
        for part, nodes in self._parts(pixels):
            target = slice(part.start - pixels.start, part.stop - pixels.start)
            values[:, target] += product(light[:, nodes], self.weights[part, nodes].T)

    def _parts(self, pixels: slice) -> list[tuple[slice, slice]]:
        """Return parts of the pixels, each with the nodes that have nonzero weights there."""
        starts = range(pixels.start, pixels.stop, _PIXELS_TOGETHER)
        parts = (slice(start, min(start + _PIXELS_TOGETHER, pixels.stop)) for start in starts)
        first = self._first
        return [(part, slice(first[part.start], min(first[part.stop - 1] + 2, self.nodes))) for part in parts]


def reciprocal(seen: Values) -> Values:
    """Return 1 / `seen` for recorded fractions of light, or 0 where hardly any light is recorded (`UNSEEN`)."""
    with np.errstate(divide="ignore"):
        return np.where(seen > UNSEEN, np.float32(1.0) / seen, np.float32(0.0))


_PIXELS_BINNED = 2**16  # pixels of planes that are binned together
_PIXELS_TOGETHER = 64  # pixels interpolated by one matrix product, from the few nodes between which they lie


def pitch_of(side: int) -> int:
    """Return the distance in pixels of nodes of the coarse grid, for PSFs with windows of `side` pixels."""
    return 5 if side > 33 else 3


def taper(side: int, pitch: int, positions: Array | None = None) -> Array:
    """Return the fraction of a PSF that belongs to its window, not to its tail: 1 in the middle and 0 at the edge.

    It is computed at the pixels of a window of `side` pixels, or at `positions` along both axes, in pixels from the
    middle.
    """
    x = np.arange(side) - side // 2 if positions is None else positions
    half = side // 2 + 0.5
    width = min(2.0 * pitch, 0.7 * half)
    radius = np.hypot(x[:, np.newaxis], x)
    fraction = np.clip((half - radius) / width, 0.0, 1.0)
    # A raised cosine, with slope 0 at either end.
    return np.asarray(0.5 - 0.5 * np.cos(math.pi * fraction))
