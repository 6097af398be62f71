"""The image of a specimen, recorded plane by plane by a microscope, as a linear operator."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import DTypeLike

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.imaging.linear import LinearBlur
from lommel.measures.axial import stage
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


def kernel_of(psf: PSF) -> tuple[Array, tuple[int, int, int]]:
    """Return the share of the light of a point in each voxel, which sums to 1, and the voxel of the point."""
    validation.instance("psf", psf, PSF)
    z = stage(psf)
    steps = np.diff(z)
    if z.ndim != 1 or np.ptp(steps) > 1e-6 * np.abs(steps).max():
        raise ValueError(f"psf must be one stack over even steps of z, got steps {np.unique(steps)[:3]} metres")
    origin = int(np.abs(z).argmin())
    if abs(z[origin]) > 1e-6 * abs(steps[0]):
        raise ValueError(f"psf must have a plane at z = 0, the nearest is at {z[origin]:g} metres")
    if not psf.grid.centered:
        raise ValueError(f"psf must have its axis in the middle pixel, got center={psf.grid.center}")
    values = psf.values / psf.values.sum(dtype=np.float64)
    return values.astype(np.float64), (origin, values.shape[1] // 2, values.shape[2] // 2)


Plane = tuple[slice, slice]
"""Rows and columns of part of a plane."""
# Takes the number of a plane, rows and columns, and returns its values there.
Part = Callable[[int, slice, slice], Values]
# The number of a plane, rows and columns, and its values there.
Piece = tuple[int, slice, slice, Values]

_SHARE = 1.5  # of the recording that the two transforms of a tile take, in memory
_SMALL = 2**21  # values that they may have in any case


class TiledBlur:
    """Convolution of a specimen larger than its recording by a margin, by FFTs of tiles, and its transpose."""

    def __init__(self, psf: PSF, shape: tuple[int, int, int], margin: tuple[int, int]) -> None:
        from scipy.fft import fft, next_fast_len, rfft2

        self._kernel, middle = kernel_of(psf)
        self.shape, self._margin = shape, (margin[0], margin[1], margin[1])
        self.whole = tuple(side + 2 * more for side, more in zip(shape, self._margin, strict=True))
        # Light reaches so many voxels towards lower and higher numbers.
        self._lower = middle
        self._upper = tuple(side - 1 - at for side, at in zip(self._kernel.shape, middle, strict=True))
        self._before, self._after = (max(0, reach[0] - margin[0]) for reach in (self._upper, self._lower))
        self._depth = next_fast_len(self.whole[0] + self._before + self._after)
        most = max(_SHARE * math.prod(shape), _SMALL) / (2.0 * self._depth)
        self._tile = tuple(
            _tile(side, more, int(math.sqrt(most)))
            for side, more in zip(self.whole[1:], self._kernel.shape[1:], strict=True)
        )
        # The transform of the kernel, with the point in the first voxel.
        self._transfer = np.zeros((self._depth, self._tile[0], self._tile[1] // 2 + 1), dtype=np.complex64)
        tile = np.zeros(self._tile, dtype=np.float32)
        for plane, values in enumerate(self._kernel):
            tile[: values.shape[0], : values.shape[1]] = values
            moved = np.roll(tile, [-at for at in middle[1:]], axis=(0, 1))
            self._transfer[plane - middle[0]] = rfft2(moved)
        for row in range(self._tile[0]):
            self._transfer[:, row] = fft(self._transfer[:, row], axis=0)
        # Cumulative sums of the kernel over the recorded planes, for each plane of the specimen.
        along = np.cumsum(np.pad(self._kernel, ((1, 0), (0, 0), (0, 0))), axis=0)
        sums = np.zeros((self.whole[0], *(side + 1 for side in self._kernel.shape[1:])))
        for at in range(-self._before, self.whole[0] + self._after):
            first = self._margin[0] + self._lower[0] - at
            low, high = np.clip((first, first + self.shape[0]), 0, len(self._kernel))
            sums[min(max(at, 0), self.whole[0] - 1), 1:, 1:] += along[high] - along[low]
        self._sums = sums.cumsum(axis=1).cumsum(axis=2)

    def forward(self, specimen: Part) -> Iterator[Piece]:
        """Yield the recording of a specimen, each part of it once."""
        from scipy.fft import irfft2

        planes, (margin, across, _) = self.shape[0], self._margin
        for core in self._cores(self.shape):
            light = self._transformed(specimen, self.whole, 0, core, self._upper, across)
            light[self.whole[0] :][: self._after] = light[self.whole[0] - 1]
            light[self._depth - self._before :] = light[0]
            self._along_planes(light)
            inside = _inside(core, self._upper)
            for plane in range(planes):
                yield plane, *core, irfft2(light[margin + plane], self._tile)[inside]

    def adjoint(self, recording: Part) -> Iterator[Piece]:
        """Yield the transpose of :meth:`forward` applied to a recording, each part of the specimen once."""
        from scipy.fft import irfft2

        planes, (margin, across, _) = self.whole[0], self._margin
        for core in self._cores(self.whole):
            seen = self._transformed(recording, self.shape, margin, core, self._lower, -across)
            self._along_planes(seen, transposed=True)
            if self._after:
                seen[planes - 1] += seen[planes:][: self._after].sum(axis=0)
            if self._before:
                seen[0] += seen[self._depth - self._before :].sum(axis=0)
            inside = _inside(core, self._lower)
            for plane in range(planes):
                yield plane, *core, irfft2(seen[plane], self._tile)[inside]

    def seen(self, plane: int, rows: slice, columns: slice) -> Values:
        """Return the share of the light of points of the specimen that falls on the recording, as `Part` does."""
        sums = self._sums[plane]
        limits = []
        for axis, part in ((1, rows), (2, columns)):
            first = self._margin[axis] + self._lower[axis] - np.arange(part.start, part.stop)
            both = np.stack([first, first + self.shape[axis]])
            limits.append(np.clip(both, 0, self._kernel.shape[axis]))
        (top, bottom), (left, right) = limits
        between = sums[bottom] - sums[top]
        return np.asarray(between[:, right] - between[:, left])

    def _cores(self, shape: tuple[int, ...]) -> Iterator[Plane]:
        """Yield rows and columns of planes of this shape that are computed in one go."""
        down, across = (tile - more + 1 for tile, more in zip(self._tile, self._kernel.shape[1:], strict=True))
        for row in range(0, shape[1], down):
            for column in range(0, shape[2], across):
                yield slice(row, min(row + down, shape[1])), slice(column, min(column + across, shape[2]))

    def _transformed(
        self, values: Part, shape: tuple[int, ...], first: int, core: Plane, reach: tuple[int, ...], shift: int
    ) -> Values:
        """Return Fourier transforms of planes, of all that lies within the reach of a core; the others are 0."""
        from scipy.fft import rfft2

        out = np.zeros((self._depth, self._tile[0], self._tile[1] // 2 + 1), dtype=np.complex64)
        tile = np.zeros(self._tile, dtype=np.float32)
        ends = zip(core, shape[1:], reach[1:], self._kernel.shape[1:], strict=True)
        (rows, down), (columns, across) = (
            overlap(part.start + shift - low, part.stop + shift - low + more - 1, side)
            for part, side, low, more in ends
        )
        for plane in range(shape[0]):
            tile[down, across] = values(plane, rows, columns)
            out[first + plane] = rfft2(tile)
        return out

    def _along_planes(self, transform: Values, *, transposed: bool = False) -> None:
        """Convolve along the planes, in place; row by row, for the sake of memory."""
        from scipy.fft import fft, ifft

        for row in range(transform.shape[1]):
            made = fft(transform[:, row], axis=0)
            made *= self._transfer[:, row].conj() if transposed else self._transfer[:, row]
            transform[:, row] = ifft(made, axis=0, overwrite_x=True)


def _tile(side: int, kernel: int, most: int) -> int:
    """Return the side of tiles, of which few do for `side` pixels."""
    from scipy.fft import next_fast_len

    core = max(most, 2 * kernel) - kernel + 1
    pieces = math.ceil(side / core)
    return int(next_fast_len(math.ceil(side / pieces) + kernel - 1, real=True))


def _inside(core: Plane, reach: tuple[int, ...]) -> Plane:
    """Return where a core is in its tile."""
    rows, columns = (slice(low, low + part.stop - part.start) for part, low in zip(core, reach[1:], strict=True))
    return rows, columns


def overlap(start: int, stop: int, side: int) -> tuple[slice, slice]:
    """Return which of `side` pixels lie in a window from `start` to `stop`, and where in the window they are."""
    taken = slice(max(start, 0), max(min(stop, side), 0))
    return taken, slice(taken.start - start, taken.stop - start)
