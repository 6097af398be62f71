"""Blur of a stack of which every plane has a PSF of its own, where PSFs are rotationally symmetric."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.base.threads import product, side_by_side
from lommel.microscopy.stack_blur import TiledBlur

_APART = 0.2  # radians between two frequencies, at the edge of the PSF
_TOGETHER = 16  # magnitudes of frequencies that are a task of a thread
_ON_AXIS = 0.4  # cycles a pixel: beyond, frequencies on the diagonal are farther from those that alias


_BESIDE = {0: 0.0, 2: 1.0 / 8.0, 3: 1.0 / 6.0}  # what a B-spline has at the voxels beside its middle


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

    def _own(self, frequency: Any) -> Array:
        """Return the transfer function of pixels along one axis, over that of the B-spline."""
        pixels, spline = self._parts
        found = np.sinc(frequency) if pixels else np.ones(frequency.shape)
        beside = _BESIDE[spline]
        return np.asarray(found / (1.0 - 2.0 * beside * (1.0 - np.cos(2.0 * math.pi * frequency))))

    def __call__(self, kernel: Array) -> Values:
        """Return it of the planes of an even kernel, shape (frequencies, planes)."""
        values = kernel.astype(np.float32)
        near = product(values.sum(axis=1), self._axis)
        half = product(values.reshape(-1, values.shape[2]), self._slanted).reshape(*values.shape[:2], -1)
        far = np.einsum("yf,pyf->pf", self._slanted, half)
        made = np.concatenate([near, far], axis=1) / self._pixels
        return np.ascontiguousarray(made.T, np.float32)

    def misfit(self, kernel: Array) -> float:
        """Return by how much the transfer function of a kernel differs from this, rms over its own."""
        from scipy.fft import rfft2

        sides = 2 * kernel.shape[1], 2 * kernel.shape[2]
        half = kernel.shape[1] // 2
        known = rfft2(kernel, sides) * np.exp(
            2j * math.pi * half * (np.fft.fftfreq(sides[0])[:, np.newaxis] + np.fft.rfftfreq(sides[1]))
        )
        place, share, pixel = self.places(sides)
        made = self(kernel).T
        found = (made[:, place] * (1.0 - share) + made[:, place + 1] * share) * pixel
        off = known.reshape(len(kernel), -1) - found
        return float(np.sqrt((np.abs(off) ** 2).sum() / (np.abs(known) ** 2).sum()))

    def places(self, tile: tuple[int, int]) -> tuple[Array, Array, Array]:
        """Return the frequencies of a tile: number of the one below, share of the one above, transfer of a pixel."""
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
        """Multiply each frequency of the room by its matrix, or the transpose of it, in place."""
        assert self._room is not None
        flat = self._room.reshape(self.whole[0], -1)
        given, made = (self.shape[0], self.whole[0]) if transposed else (self.whole[0], self.shape[0])

        def several(begin: int) -> None:
            for number in range(begin, min(begin + _TOGETHER, len(self._groups))):
                one(number)

        def one(number: int) -> None:
            here, level = self._groups[number], self._levels[number]
            values = np.take(flat[:given], here, axis=1)
            first, second = self._matrices[level], self._matrices[level + 1]
            if transposed:
                first, second = first.T, second.T
            found = product(first, (values * self._below[here]).view(np.float32))
            values *= self._above[here]
            found += product(second, values.view(np.float32))
            flat[:made, here] = found.view(np.complex64)

        side_by_side(several, range(0, len(self._groups), _TOGETHER), self._threads)
