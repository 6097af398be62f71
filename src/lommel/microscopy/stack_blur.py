"""The image of a specimen, recorded plane by plane by a microscope, as a linear operator."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from itertools import chain
from typing import NamedTuple

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.threads import product, side_by_side
from lommel.core import engine
from lommel.deconvolve.linear import UNSEEN, LinearBlur, Part, PartConsumer, Plane, PlaneOperator, Result, overlap
from lommel.measures.spot import stage
from lommel.psf import PSF


class StackBlur(LinearBlur):
    """Three-dimensional blur of a microscope with one PSF, a linear operator; planes are channels.

    Parameters
    ----------
    psf : PSF
        A stack over z in equal steps, with one plane at z = 0, of the step and pixels of the recording; used at all
        depths. Values are divided by their sum, so that light is conserved except for what leaves the recording,
        outside of which it is dark.
    shape : (int, int, int)
        Number of planes, height and width of the recording.
    dtype : float32 or float64, default float32
        Type of the computation, by zero-padded FFTs.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.
    """

    def __init__(self, psf: PSF, shape: tuple[int, int, int], dtype: DTypeLike = np.float32) -> None:
        from scipy.fft import next_fast_len, rfftn

        values, middle = kernel_of(psf)
        if not isinstance(shape, tuple | list) or len(shape) != 3:
            raise ValueError(f"shape must be (planes, height, width), got {validation.shown(shape)}")
        sides = [validation.integer("shape", side, least=1, most=validation.MAX_SIDE) for side in shape]
        self.dtype = validation.kind("dtype", dtype, np.float32, np.float64)
        self.channels, self.shape = sides[0], (sides[1], sides[2])
        size = [next_fast_len(n + k - 1, real=True) for n, k in zip(sides, values.shape, strict=True)]
        kernel = np.zeros(size, self.dtype)
        kernel[tuple(slice(k) for k in values.shape)] = values
        self._size, self._transfer = size, rfftn(np.roll(kernel, [-m for m in middle], axis=(0, 1, 2)))

    def forward(self, image: Values) -> Values:
        """Return the recording of a specimen `image`: see :meth:`lommel.imaging.LinearBlur.forward`."""
        return self._filtered(image, self._transfer)

    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward` of an `image`: see :meth:`lommel.imaging.LinearBlur.adjoint`."""
        return self._filtered(image, self._transfer.conj())

    def _filtered(self, image: Values, transfer: Values) -> Values:
        from scipy.fft import irfftn, rfftn

        made = irfftn(rfftn(self.planes(image), self._size) * transfer, self._size)
        made = made[: self.channels, : self.shape[0], : self.shape[1]]
        return np.ascontiguousarray(np.moveaxis(made, 0, 2), self.dtype).reshape(image.shape)


Kernel = tuple[Array, tuple[int, int, int]]
"""Shares of the light of a point in voxels, and the voxel of the point."""


def kernel_of(psf: PSF) -> Kernel:
    """Return the share of the light of a point in each voxel, which sums to 1, and the voxel of the point."""
    validation.instance("psf", psf, PSF)
    z = stage(psf)
    steps = np.diff(z)
    if z.ndim != 1 or np.ptp(steps) > 1e-6 * np.abs(steps).max():
        raise ValueError(f"psf must be one stack over even steps of z, got steps {np.unique(steps)[:3]} metres")
    # The plane of the point: z = 0.
    origin = int(np.abs(z).argmin())
    if abs(z[origin]) > 1e-6 * abs(steps[0]):
        raise ValueError(f"psf must have a plane at z = 0, the nearest is at {z[origin]:g} metres")
    if not psf.grid.centered:
        raise ValueError(f"psf must have its axis in the middle pixel, got center={psf.grid.center}")
    values = psf.values / psf.values.sum(dtype=np.float64)
    return values.astype(np.float64), (origin, values.shape[1] // 2, values.shape[2] // 2)


_Places = tuple[NDArray[np.intp], int, int]


class _Job(NamedTuple):
    """A tile: part of a plane that comes out, part that goes in, and where both are in the tile."""

    core: Plane
    taken: Plane
    placed: Plane
    inside: Plane


_SHARE = 3.0  # largest memory of the transform of a tile, over that of the recording
_SMALL = 2**23  # values that it may have in any case
_COLUMNS = (0, 4, 1, 5, 2, 6, 3, 7)  # columns of a transform that the core filters together, in its order
_ALIKE = 1e-6  # of the largest value: largest difference of a kernel from its mirror image


class TiledBlur(PlaneOperator):
    """Convolution of a specimen larger than its recording by a margin, by FFTs of tiles, and its transpose.

    With several PSFs the image is ``sum_s h_s * (w_s x)``, with a weight of each PSF at each plane of the specimen.
    Arrays instead of PSFs are taken as they are, their middle voxel as that of the point.
    Results depend neither on the number of threads nor on where the arrays are.
    """

    def __init__(
        self,
        psf: PSF | Iterable[PSF | Array | Kernel],
        shape: tuple[int, int, int],
        margin: tuple[int, int],
        *,
        weights: Array | None = None,
        threads: int = 0,
    ) -> None:
        from scipy.fft import next_fast_len

        kernels = iter([psf] if isinstance(psf, PSF) else psf)
        first, middle = _kernel(next(kernels))
        self.shape, self._margin, self._threads = shape, (margin[0], margin[1], margin[1]), threads
        self.whole = shape[0] + 2 * margin[0], shape[1] + 2 * margin[1], shape[2] + 2 * margin[1]
        sides = self._sides = first.shape
        # Light reaches so many voxels towards lower and higher numbers.
        self._lower = middle
        self._upper = tuple(side - 1 - at for side, at in zip(sides, middle, strict=True))
        self._before, self._after = (max(0, reach[0] - margin[0]) for reach in (self._upper, self._lower))
        # Planes beyond the margin that the outermost ones stand for: their PSFs reach the recording.
        self._depth: int = engine.fft_length(self.whole[0] + self._before + self._after)
        self._weights = np.ones((1, self.whole[0]), np.float32) if weights is None else weights.astype(np.float32)
        most = max(_SHARE * math.prod(shape), _SMALL) / self.whole[0]
        # One tile has what it lacks at its other end, where it is dark.
        full = [
            max(whole, side + more + max(low, high))
            for whole, side, more, low, high in zip(
                self.whole[1:], shape[1:], self._margin[1:], self._lower[1:], self._upper[1:], strict=True
            )
        ]
        one = [int(next_fast_len(side, real=True)) for side in full]
        self._single = math.prod(one) <= most
        self._tile = (one[0], one[1])
        if not self._single:
            down, across = (
                _tile(side, more, int(math.sqrt(most))) for side, more in zip(self.whole[1:], sides[1:], strict=True)
            )
            self._tile = down, across
        self._limits, self._places = self._edges()
        self._seen = np.zeros((self.whole[0], *(side.shape[1] for side in self._limits)), np.float32)
        self._transfers: list[object] = []
        # One after the other, as there may be many.
        for number, values in enumerate(chain([first], (_kernel(each)[0] for each in kernels))):
            self._learn(number, values)
            self._share(number, values)
        self.weigh(1.0)
        self._room: Values | None = None

    def _learn(self, number: int, kernel: Array) -> None:
        """Keep the transform of a kernel."""
        self._transfers.append(self._transfer(kernel, _mirrored(kernel)))

    def _transfer(self, kernel: Array, even: bool) -> Values:
        """Return the transform of a kernel, with the point in the first voxel.

        That of an even one is real until planes are transformed, and the same in rows of opposite frequencies: an
        eighth of the values says it all. The shape is (rows, groups of columns, frequencies, real and imaginary
        parts).
        """
        from scipy.fft import fft, rfft, rfft2

        middle = self._lower
        rows = self._tile[0] // 2 + 1 if even else self._tile[0]
        planes = self._depth // 2 + 1 if even else self._depth
        made = np.zeros((len(kernel), rows, self._tile[1] // 2 + 1), np.float32 if even else np.complex64)
        tile = np.zeros(self._tile, dtype=np.float32)
        for plane, values in enumerate(kernel):
            tile[: values.shape[0], : values.shape[1]] = values
            found = rfft2(np.roll(tile, [-at for at in middle[1:]], axis=(0, 1)))[:rows]
            made[plane] = found.real if even else found
        groups = -(-made.shape[2] // len(_COLUMNS))
        out = np.empty((rows, groups, planes, 2, len(_COLUMNS)), np.float32)
        column = np.zeros((self._depth, groups * len(_COLUMNS)), made.dtype)
        order = np.arange(len(kernel)) - middle[0]
        for row in range(rows):
            column[order, : made.shape[2]] = made[:, row]
            # The inverse transform is not scaled: the factor is in the transfer function.
            found = (rfft(column, axis=0) if even else fft(column, axis=0)) / np.float32(self._depth)
            parts = found.reshape(planes, groups, -1)[:, :, _COLUMNS].transpose(1, 0, 2)
            out[row, :, :, 0], out[row, :, :, 1] = parts.real, parts.imag
        return out.reshape(rows, groups, planes, -1)

    def _edges(self) -> tuple[list[NDArray[np.intp]], list[_Places]]:
        """Return what part of a kernel falls on the recording, of few rows and columns that are all there are.

        With it, of both axes: which of them each row or column is, and from where to where all are the same.
        """
        limits, places = [], []
        for axis in (1, 2):
            first = self._margin[axis] + self._lower[axis] - np.arange(self.whole[axis])
            both = np.clip(np.stack([first, first + self.shape[axis]]), 0, self._sides[axis])
            each, place = np.unique(both, axis=1, return_inverse=True)
            place = place.ravel()
            counts = np.bincount(place)
            start = int(np.argmax(place == counts.argmax()))
            stop = start + int(np.argmin(np.append(place[start:], -1) == place[start]))
            limits.append(each)
            places.append((place, start, stop))
        return limits, places

    def _share(self, number: int, kernel: Array) -> None:
        """Add the share of a kernel's light that falls on the recording."""
        (top, bottom), (left, right) = self._limits
        # Cumulative sums of the kernel over the recorded planes, for each plane of the specimen.
        along = np.pad(kernel, ((1, 0), (1, 0), (1, 0))).cumsum(axis=0)
        for at in range(-self._before, self.whole[0] + self._after):
            plane = min(max(at, 0), self.whole[0] - 1)
            share = self._weights[number, plane]
            if share == 0.0:
                continue
            begin = self._margin[0] + self._lower[0] - at
            low, high = np.clip((begin, begin + self.shape[0]), 0, len(kernel))
            # Sums over rectangles from cumulative sums, at four corners.
            sums = (along[high] - along[low]).cumsum(axis=0).cumsum(axis=1)
            between = sums[bottom] - sums[top]
            self._seen[plane] += share * (between[:, right] - between[:, left])

    def forward(self, specimen: Part, take: PartConsumer[Result]) -> list[Result]:
        """Hand the recording of a specimen to `take`, each part of it once; return what it makes of the parts."""
        made: list[Result] = []
        for job in self._jobs(self.shape, self.whole, self._upper, self._margin[1]):
            self._transformed(specimen, self.whole[0], job)
            self._along(transposed=False)
            made += self._planes(self.shape[0], job, take)
        return made

    def adjoint(self, recording: Part, take: PartConsumer[Result]) -> list[Result]:
        """Hand the transpose of :meth:`forward` applied to a recording to `take`, each part of the specimen once."""
        made: list[Result] = []
        for job in self._jobs(self.whole, self.shape, self._lower, -self._margin[1]):
            self._transformed(recording, self.shape[0], job)
            self._along(transposed=True)
            made += self._planes(self.whole[0], job, take)
        return made

    def release(self) -> None:
        """Release the memory of transforms; it is taken again when needed."""
        self._room = None

    def seen(self, plane: int, rows: slice, columns: slice) -> Values:
        """Return the share of the light of points of the specimen that falls on the recording, as `Part` does."""
        first, second = (
            _places_of_part(part, *places) for part, places in zip((rows, columns), self._places, strict=True)
        )
        return _spread(self._seen[plane], first, second)

    def weigh(self, weight: float) -> None:
        """Set the weight that :meth:`per_seen` divides by as well."""
        with np.errstate(divide="ignore"):
            self._per = np.where(self._seen * weight > UNSEEN, 1.0 / (self._seen * weight), 0.0).astype(np.float32)

    def per_seen(self, plane: int, rows: slice, columns: slice, /) -> Values:
        """Return 1 over :meth:`seen` and the weight, 0 where next to nothing is seen."""
        first, second = (
            _places_of_part(part, *places) for part, places in zip((rows, columns), self._places, strict=True)
        )
        return _spread(self._per[plane], first, second)

    def _jobs(
        self, shape: tuple[int, ...], other: tuple[int, ...], reach: tuple[int, ...], shift: int
    ) -> Iterator[_Job]:
        """Yield tiles of planes of a shape, which need those of the other shape within a reach."""
        if self._single:
            core, taken = (_window((0, 0), sides[1:]) for sides in (shape, other))
            put, out = (shift, 0) if shift < 0 else (0, shift)
            yield _Job(core, taken, _window((-put, -put), other[1:]), _window((out, out), shape[1:]))
            return
        kernel = self._sides[1:]
        down, across = (tile - more + 1 for tile, more in zip(self._tile, kernel, strict=True))
        for row in range(0, shape[1], down):
            for column in range(0, shape[2], across):
                core = slice(row, min(row + down, shape[1])), slice(column, min(column + across, shape[2]))
                (rows, above), (columns, beside) = (
                    overlap(part.start + shift - low, part.stop + shift - low + more - 1, side)
                    for part, side, low, more in zip(core, other[1:], reach[1:], kernel, strict=True)
                )
                inside = _window(reach[1:], tuple(part.stop - part.start for part in core))
                yield _Job(core, (rows, columns), (above, beside), inside)

    def _transformed(self, values: Part, planes: int, job: _Job) -> None:
        """Transform planes into the first ones of the room, each laterally."""
        from scipy.fft import rfft2

        if self._room is None:
            self._room = np.empty((self.whole[0], self._tile[0], self._tile[1] // 2 + 1), np.complex64)
        room, spare = self._room, _Spare(self._tile)

        def transform(plane: int) -> None:
            with spare.taken() as tile:
                # The rest of the tile stays dark: each is written at the same place.
                tile[job.placed] = values(plane, *job.taken)
                room[plane] = rfft2(tile)

        side_by_side(transform, range(planes), self._threads)

    def _planes(self, planes: int, job: _Job, take: PartConsumer[Result]) -> list[Result]:
        """Hand on the first planes of the room, transformed back."""
        from scipy.fft import irfft2

        room = self._room
        assert room is not None

        def back(plane: int) -> Result:
            # What follows is faster in contiguous memory.
            light = np.ascontiguousarray(irfft2(room[plane], self._tile, overwrite_x=True)[job.inside])
            return take(plane, *job.core, light)

        return side_by_side(back, range(planes), self._threads)

    def _along(self, *, transposed: bool) -> None:
        """Convolve the room along the planes, in place, or apply the transpose."""
        assert self._room is not None
        # Beyond the outermost planes the specimen is taken to go on like these.
        engine.filter_planes(
            self._room,
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


def _kernel(given: PSF | Array | Kernel) -> Kernel:
    """Return a kernel and the voxel of the point: the middle one of an array, which is taken as it is."""
    if isinstance(given, PSF):
        return kernel_of(given)
    if isinstance(given, tuple):
        return given
    return given, (given.shape[0] // 2, given.shape[1] // 2, given.shape[2] // 2)


class _Spare:
    """Tiles of zeros, each used by one thread at a time."""

    def __init__(self, shape: tuple[int, int]) -> None:
        self._shape, self._tiles = shape, list[Values]()

    @contextmanager
    def taken(self) -> Iterator[Values]:
        try:
            tile = self._tiles.pop()
        except IndexError:
            tile = np.zeros(self._shape, np.float32)
        yield tile
        self._tiles.append(tile)


def _mirrored(kernel: Array) -> bool:
    """Return whether a kernel is the same from left to right and from top to bottom, about its middle pixel."""
    if kernel.shape[1] % 2 == 0 or kernel.shape[2] % 2 == 0:
        return False
    limit = _ALIKE * float(np.abs(kernel).max())
    return all(np.allclose(kernel, np.flip(kernel, axis), rtol=0.0, atol=limit) for axis in (1, 2))


def _places_of_part(part: slice, place: NDArray[np.intp], start: int, stop: int) -> _Places:
    """Return what `TiledBlur._edges` says of an axis, of a part of it."""
    low, high = (min(max(at, part.start), part.stop) - part.start for at in (start, stop))
    return place[part], low, max(low, high)


def _spread(values: Values, first: _Places, second: _Places) -> Values:
    """Return a plane from values of few rows and columns."""
    rows = values[first[0]]
    place, start, stop = second
    out = np.empty((len(rows), len(place)), np.float32)
    out[:, :start] = rows[:, place[:start]]
    if stop > start:
        out[:, start:stop] = rows[:, place[start], np.newaxis]
    out[:, stop:] = rows[:, place[stop:]]
    return out


def _tile(side: int, kernel: int, most: int) -> int:
    """Return the side of tiles such that few cover `side` pixels."""
    from scipy.fft import next_fast_len

    # Tiles of less than twice the kernel would consist of overlap for the most part.
    core = max(most, 2 * kernel) - kernel + 1
    pieces = math.ceil(side / core)
    return int(next_fast_len(math.ceil(side / pieces) + kernel - 1, real=True))


def _window(start: tuple[int, ...], sides: tuple[int, ...]) -> Plane:
    """Return rows and columns from a start."""
    rows, columns = (slice(at, at + side) for at, side in zip(start, sides, strict=True))
    return rows, columns


_APART = 0.2  # radians between two neighbouring frequencies, at the edge of the PSF
_FREQUENCIES_TOGETHER = 16  # magnitudes of frequencies in a task of a thread
_ON_AXIS = 0.4  # cycles a pixel: beyond, frequencies on the diagonal are farther from those that alias


_BESIDE = {0: 0.0, 2: 1.0 / 8.0, 3: 1.0 / 6.0}  # B-splines of a degree at the voxels beside their middle


class RadialTransfer:
    """The lateral transfer function of PSFs, of each plane, over the spatial frequency alone.

    `pixels` says whether values are averages over square pixels, whose own transfer is left out, and `spline` is the
    degree of the B-splines, along rows and columns, by whose transfer functions that of the PSF was divided.
    """

    def __init__(self, side: int, *, pixels: bool, spline: int = 0) -> None:
        half = side // 2
        self.apart = _APART / (2.0 * math.pi * half)
        self.frequencies = self.apart * np.arange(math.ceil(math.sqrt(0.5) / self.apart) + 2)
        at = np.arange(side) - half
        self._near = int(np.searchsorted(self.frequencies, _ON_AXIS))
        axis, slanted = self.frequencies[: self._near], self.frequencies[self._near :] * math.sqrt(0.5)
        self._axis = np.cos(2.0 * math.pi * np.outer(at, axis)).astype(np.float32)
        self._slanted = np.cos(2.0 * math.pi * np.outer(at, slanted)).astype(np.float32)
        self._parts = pixels, spline
        self._pixels = np.concatenate([self._own(axis), self._own(slanted) ** 2])

    def _own(self, frequency: Values) -> Array:
        """Return the transfer function of pixels along one axis, over that of the B-spline."""
        pixels, spline = self._parts
        found = np.sinc(frequency) if pixels else np.ones(frequency.shape)
        beside = _BESIDE[spline]
        # A B-spline of values b beside 1 - 2 b has the transfer function 1 - 2 b (1 - cos 2 pi f).
        return np.asarray(found / (1.0 - 2.0 * beside * (1.0 - np.cos(2.0 * math.pi * frequency))))

    def __call__(self, kernel: Array) -> Values:
        """Return the transfer function of the planes of an even kernel, shape (frequencies, planes)."""
        values = kernel.astype(np.float32)
        # On an axis: the transform of sums over the other one. On the diagonal: cosines along both.
        near = product(values.sum(axis=1), self._axis)
        half = product(values.reshape(-1, values.shape[2]), self._slanted).reshape(*values.shape[:2], -1)
        far = np.einsum("yf,pyf->pf", self._slanted, half)
        made = np.concatenate([near, far], axis=1) / self._pixels
        return np.ascontiguousarray(made.T, np.float32)

    def misfit(self, kernel: Array) -> float:
        """Return the rms difference of a kernel's transfer function from this, over its own rms."""
        from scipy.fft import rfft2

        sides = 2 * kernel.shape[1], 2 * kernel.shape[2]
        half = kernel.shape[1] // 2
        # A shift of the middle to the first pixel, as a phase.
        known = rfft2(kernel, sides) * np.exp(
            2j * math.pi * half * (np.fft.fftfreq(sides[0])[:, np.newaxis] + np.fft.rfftfreq(sides[1]))
        )
        place, share, pixel = self.places(sides)
        made = self(kernel).T
        found = (made[:, place] * (1.0 - share) + made[:, place + 1] * share) * pixel
        off = known.reshape(len(kernel), -1) - found
        return float(np.sqrt((np.abs(off) ** 2).sum() / (np.abs(known) ** 2).sum()))

    def places(self, tile: tuple[int, int]) -> tuple[Array, Array, Array]:
        """Return for each frequency of a tile the index below, the share of that above, and the pixel's transfer."""
        down, across = np.fft.fftfreq(tile[0])[:, np.newaxis], np.fft.rfftfreq(tile[1])
        place = np.hypot(down, across).ravel() / self.apart
        pixel = (self._own(down) * self._own(across)).ravel()
        return place.astype(np.intp), (place % 1.0).astype(np.float32), pixel.astype(np.float32)


class PlaneBlur(TiledBlur):
    """Convolution of each plane of the specimen with a PSF of its own, and its transpose.

    For each lateral spatial frequency the planes of the recording are a matrix times those of the specimen. With
    rotationally symmetric PSFs it depends on the magnitude of the frequency alone: matrices of some magnitudes are
    kept, and interpolated between.
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
        place, share, pixel = transfer.places(self._tile)
        order = np.argsort(place, kind="stable")
        cuts = np.flatnonzero(np.diff(place[order])) + 1
        self._groups = [each.astype(np.int32) for each in np.split(order, cuts)]
        self._levels = [int(place[each[0]]) for each in self._groups]
        self._above, self._below = share * pixel, (1.0 - share) * pixel

    def _learn(self, number: int, kernel: Array) -> None:
        """Put a kernel into the matrices: that of a plane, and the outermost ones also of those beyond."""
        transfer = self._radial(kernel)
        first, last = (number == 0) * self._before, (number == self.whole[0] - 1) * self._after
        for at in range(number - first, number + last + 1):
            # Plane p of the recording gets plane p - start of the kernel.
            start = at - self._margin[0] - self._lower[0]
            low, high = max(start, 0), min(start + len(kernel), self.shape[0])
            if low < high:
                self._matrices[:, low:high, number] += transfer[:, low - start : high - start]

    def _along(self, *, transposed: bool) -> None:
        """Multiply each frequency of the room by its matrix or the transpose, in place."""
        assert self._room is not None
        flat = self._room.reshape(self.whole[0], -1)
        given, made = (self.shape[0], self.whole[0]) if transposed else (self.whole[0], self.shape[0])

        def several(begin: int) -> None:
            for number in range(begin, min(begin + _FREQUENCIES_TOGETHER, len(self._groups))):
                one(number)

        def one(number: int) -> None:
            here, level = self._groups[number], self._levels[number]
            values = np.take(flat[:given], here, axis=1)
            first, second = self._matrices[level], self._matrices[level + 1]
            if transposed:
                first, second = first.T, second.T
            # Complex values as pairs of real ones: the matrices are real.
            found = product(first, (values * self._below[here]).view(np.float32))
            values *= self._above[here]
            found += product(second, values.view(np.float32))
            flat[:made, here] = found.view(np.complex64)

        side_by_side(several, range(0, len(self._groups), _FREQUENCIES_TOGETHER), self._threads)


class WideBlur(PlaneOperator):
    """The blur by PSFs in their windows, `near`, and by what of these lies beyond, `far`, of every `pitch` th pixel.

    Light is shared linearly between the nodes of the coarse grid, and values between these are interpolated, so that
    the transpose is exact. Beyond the margin the specimen is as bright everywhere in each plane as `outside` says: an
    unknown like all others. A flat specimen so has a flat recording.
    """

    outside: Values

    def __init__(
        self,
        near: TiledBlur,
        far: Iterable[Array],
        pitch: int,
        *,
        weights: Array | None = None,
        threads: int = 0,
    ) -> None:
        self._near, self._threads = near, threads
        self.shape, self.whole = near.shape, near.whole
        kernels: Sequence[Array] = list(far)
        margin = (near.whole[0] - near.shape[0]) // 2, (near.whole[1] - near.shape[1]) // 2
        reach = kernels[0].shape[1] // 2
        if reach * pitch < margin[1]:
            raise ValueError(f"far must reach over the margin of {margin[1]} pixels, got {reach} nodes of {pitch}")
        nodes = [(side - 1) // pitch + 2 for side in near.shape[1:]]
        self._far = TiledBlur(
            kernels, (near.shape[0], nodes[0], nodes[1]), (margin[0], reach), weights=weights, threads=threads
        )
        self._recorded = [_Hats(side, 0, pitch, 0, count) for side, count in zip(near.shape[1:], nodes, strict=True)]
        self._given = [
            _Hats(side, margin[1], pitch, reach, count + 2 * reach)
            for side, count in zip(near.whole[1:], nodes, strict=True)
        ]
        down, across = (each.shares.sum(axis=0) for each in self._given)
        # A node stands for pitch^2 pixels: what those of the specimen do not fill is outside.
        self._beyond = np.maximum(float(pitch) ** 2 - np.outer(down, across), 0.0).astype(np.float32)
        self.outside = np.ones(near.whole[0], np.float32)
        ones = np.outer(*(each.shares.sum(axis=0) for each in self._recorded)).astype(np.float32)
        self._seen = self._returned(np.broadcast_to(ones, (near.shape[0], *ones.shape)))
        self.outside_seen = np.einsum("pyx,yx->p", self._seen, self._beyond)
        self.outside_back = np.zeros(near.whole[0], np.float32)
        self.weigh(1.0)

    def forward(self, specimen: Part, take: PartConsumer[Result]) -> list[Result]:
        """Hand the recording of a specimen to `take`, as :meth:`TiledBlur.forward` does."""
        coarse = self._binned(specimen, self.whole, self._given)
        coarse += self.outside[:, np.newaxis, np.newaxis] * self._beyond
        light = np.empty((self.shape[0], *(each.nodes for each in self._recorded)), np.float32)

        def put(plane: int, rows: slice, columns: slice, values: Values) -> None:
            light[plane, rows, columns] = values

        self._far.forward(lambda plane, *at: coarse[(plane, *at)], put)
        return self._near.forward(specimen, self._added(light, self._recorded, take))

    def adjoint(self, recording: Part, take: PartConsumer[Result]) -> list[Result]:
        """Hand the transpose of :meth:`forward` to `take`; that of the light outside is `outside_back`."""
        light = self._returned(self._binned(recording, self.shape, self._recorded))
        self.outside_back = np.einsum("pyx,yx->p", light, self._beyond)
        return self._near.adjoint(recording, self._added(light, self._given, take))

    def release(self) -> None:
        """Release the memory of transforms; it is taken again when needed."""
        self._near.release()
        self._far.release()

    def seen(self, plane: int, rows: slice, columns: slice) -> Values:
        """Return the share of the light of points of the specimen that falls on the recording, as `Part` does."""
        found = _between(self._seen[plane], self._given, rows, columns)
        found += self._near.seen(plane, rows, columns)
        return found

    def weigh(self, weight: float) -> None:
        """Set the weight that :meth:`per_seen` divides by as well."""
        self._weight = weight

    def per_seen(self, plane: int, rows: slice, columns: slice, /) -> Values:
        """Return 1 over :meth:`seen` and the weight, 0 where next to nothing is seen."""
        return per(self.seen(plane, rows, columns) * np.float32(self._weight))

    @property
    def per_outside(self) -> Values:  # type: ignore[override]
        """1 over the weight and the light from outside that falls on the recording."""
        return per(self.outside_seen * np.float32(self._weight))

    def _returned(self, light: Values) -> Values:
        """Return the transpose of the coarse blur."""
        back = np.empty((self.whole[0], *(each.nodes for each in self._given)), np.float32)

        def put(plane: int, rows: slice, columns: slice, values: Values) -> None:
            back[plane, rows, columns] = values

        self._far.adjoint(lambda plane, *at: light[(plane, *at)], put)
        return back

    def _binned(self, values: Part, shape: tuple[int, ...], hats: list[_Hats]) -> Values:
        """Return planes shared between the nodes of the coarse grid."""
        rows, columns = slice(0, shape[1]), slice(0, shape[2])
        down, across = hats
        made = np.empty((shape[0], down.nodes, across.nodes), np.float32)

        def share(plane: int) -> None:
            given = values(plane, rows, columns)
            tall = np.zeros((down.nodes, shape[2]), np.float32)
            for part, nodes in down.parts(rows):
                tall[nodes] += product(down.shares[part, nodes].T, given[part])
            made[plane] = 0.0
            for part, nodes in across.parts(columns):
                made[plane, :, nodes] += product(tall[:, part], across.shares[part, nodes])

        side_by_side(share, range(shape[0]), self._threads)
        return made

    def _added(self, light: Values, hats: list[_Hats], take: PartConsumer[Result]) -> PartConsumer[Result]:
        """Return `take` with interpolated light added to its values."""

        def added(plane: int, rows: slice, columns: slice, values: Values) -> Result:
            values += _between(light[plane], hats, rows, columns)
            return take(plane, rows, columns, values)

        return added


class _Hats:
    """The share of each pixel in each node of a coarse grid; node `lower` is at pixel `before`."""

    def __init__(self, side: int, before: int, pitch: int, lower: int, nodes: int) -> None:
        place = (np.arange(side) - before) / pitch + lower
        self._first = np.floor(place).astype(int)
        self.nodes, self.shares = nodes, np.zeros((side, nodes), np.float32)
        self.shares[np.arange(side), self._first] = 1.0 - (place - self._first)
        inside = self._first + 1 < nodes
        self.shares[np.arange(side)[inside], self._first[inside] + 1] = (place - self._first)[inside]

    def parts(self, pixels: slice) -> Iterator[tuple[slice, slice]]:
        """Yield parts of the pixels, with the few nodes in which these have a share."""
        for start in range(pixels.start, pixels.stop, _TOGETHER):
            stop = min(start + _TOGETHER, pixels.stop)
            yield slice(start, stop), slice(self._first[start], min(self._first[stop - 1] + 2, self.nodes))


def _between(light: Values, hats: list[_Hats], rows: slice, columns: slice) -> Values:
    """Return a part of a plane, interpolated between nodes."""
    down, across = hats
    tall = np.empty((rows.stop - rows.start, light.shape[1]), np.float32)
    for part, nodes in down.parts(rows):
        tall[part.start - rows.start : part.stop - rows.start] = product(down.shares[part, nodes], light[nodes])
    made = np.empty((len(tall), columns.stop - columns.start), np.float32)
    for part, nodes in across.parts(columns):
        here = slice(part.start - columns.start, part.stop - columns.start)
        made[:, here] = product(tall[:, nodes], across.shares[part, nodes].T)
    return made


def per(seen: Values) -> Values:
    """Return 1 over `seen`, 0 where next to nothing is seen."""
    with np.errstate(divide="ignore"):
        return np.where(seen > UNSEEN, np.float32(1.0) / seen, np.float32(0.0))


_TOGETHER = 64  # pixels that are interpolated together, between few of all nodes


def pitch_of(side: int) -> int:
    """Return the pitch of the coarse grid beside a window of `side` pixels."""
    return 5 if side > 33 else 3


def taper(side: int, pitch: int, at: Array | None = None) -> Array:
    """Return the share of light that counts as near, over a window or at distances from its middle on both axes."""
    along = np.arange(side) - side // 2 if at is None else at
    half = side // 2 + 0.5
    wide = min(2.0 * pitch, 0.7 * half)
    radius = np.hypot(along[:, np.newaxis], along)
    inside = np.clip((half - radius) / wide, 0.0, 1.0)
    # A raised cosine: its slope is 0 at either end.
    return np.asarray(0.5 - 0.5 * np.cos(math.pi * inside))
