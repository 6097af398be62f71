"""What lies beyond the windows, of the light of whole images: the remainders of all channels, side by side."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property, lru_cache
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from lommel.base.threads import side_by_side
from lommel.imaging.bank import Bank
from lommel.imaging.remainder import Remainder, smooth_transforms

# Of an image between two mirrors, half a pixel beyond its first and its last pixel, a convolution with an even kernel
# is diagonal in the discrete cosine transform of type II, whatever the reach of the kernel: it multiplies by
# ``sum_q g(q) cos(pi k q / n)``, the transform of the kernel at the frequencies ``k / 2 n``. Where no mirror is
# wanted, an image is continued first, and the mirror is farther away.
#
# References
# ----------
# S. A. Martucci, "Symmetric convolution and the discrete sine and cosine transforms", IEEE Trans. Signal Process. 42,
# 1038 (1994), doi:10.1109/78.295213.

_COPIES = 9.04
"""Sum of 1 over the cubed distances from one point of a square lattice to the others: 9.0336."""


class MirroredKernels:
    """The g_r of a remainder, as they act on images of one shape.

    Parameters
    ----------
    remainder : Remainder
    shape : (int, int)
        Height and width of the image.
    border : {"reflect", "extend", "zero"}
        What lies beyond its edges. The last pixels go on for half of the height and the width, and are mirrored
        there. Darkness is as wide as it takes for light from its mirrors to be less than half of `tol` of white.
    dtype : dtype
        Of the sums.
    tol : float

    Attributes
    ----------
    error : float
        Light from mirrors beyond darkness, of white: what is off beside the remainder.
    """

    def __init__(
        self, remainder: Remainder, shape: tuple[int, int], border: str, dtype: np.dtype[Any], tol: float
    ) -> None:
        self.remainder, self.border, self.dtype, self.error = remainder, border, dtype, 0.0
        self._around = [(0, 0), (0, 0)]
        if border == "extend":
            self._around = [(max(1, side // 2),) * 2 for side in shape]
        elif border == "zero":
            from scipy.fft import next_fast_len

            tail = float(np.abs(remainder.knots @ remainder.smooth[:, 0]).max())
            light = _COPIES * math.prod(shape) * tail
            dark = max(math.ceil(0.5 * math.cbrt(light / (0.5 * tol))), remainder.table.shape[1])
            self._around = [(dark, next_fast_len(side + 2 * dark, real=True) - side - dark) for side in shape]
            self.error = light / (2.0 * dark) ** 3
        (top, _), (left, _) = self._around
        self._image = slice(top, top + shape[0]), slice(left, left + shape[1])
        self._sides = [side + sum(more) for side, more in zip(shape, self._around, strict=True)]

    @cached_property
    def eigenvalues(self) -> NDArray[Any]:
        """Transforms of the g_r, shape (rank, height, width) of the image as it is continued; kept."""
        table, scale = self.remainder.table.astype(self.dtype), self.remainder.scale
        down, across = (_cosines(side, table.shape[1] - 1, self.dtype.char) for side in self._sides)
        made = down @ table @ across.T
        known = _smooth(*self._sides, scale, self.dtype.char)
        for each, parts in zip(made, self.remainder.smooth.astype(self.dtype), strict=True):
            for part, transform in zip(parts, known, strict=True):
                each += part * transform
        return np.asarray(made)

    def transformed(self, r: int, plane: NDArray[Any]) -> NDArray[Any]:
        """Return the transform of what g_r makes of a plane."""
        from scipy.fft import dctn

        if self.border != "reflect":
            plane = np.pad(plane, self._around, mode="edge" if self.border == "extend" else "constant")
        made = dctn(plane, overwrite_x=True)
        made *= self.eigenvalues[r]
        return np.asarray(made)

    def image(self, transform: NDArray[Any], threads: int = 1) -> NDArray[Any]:
        """Return the image of a transform."""
        from scipy.fft import idctn

        return np.asarray(idctn(transform, overwrite_x=True, workers=threads)[self._image])

    def known(self, plane: NDArray[Any], threads: int = 1) -> NDArray[Any]:
        """Return the transform of a plane with darkness around it: the transpose of :meth:`image` but for a scale."""
        from scipy.fft import dctn

        return np.asarray(dctn(np.pad(plane, self._around), workers=threads))

    def taken(self, r: int, known: NDArray[Any]) -> NDArray[Any]:
        """Return the transpose of :meth:`transformed`, but for that scale, of a transform."""
        from scipy.fft import idctn

        taken = idctn(self.eigenvalues[r] * known, overwrite_x=True)
        if self.border == "extend":
            # What copies of the edges took goes to these.
            for lines, (before, after) in zip((taken, taken.T), self._around, strict=True):
                lines[before] += lines[:before].sum(axis=0)
                lines[-after - 1] += lines[-after:].sum(axis=0)
        return np.asarray(taken[self._image])


@lru_cache(maxsize=8)
def _cosines(side: int, reach: int, kind: str) -> NDArray[Any]:
    """Return the cosines that an even kernel is multiplied by, and 2 where a value stands for two."""
    turns = np.outer(np.arange(side), np.arange(reach + 1)) % (2 * side)
    made = 2.0 * np.cos((math.pi / side) * turns)
    made[:, 0] = 1.0
    made.flags.writeable = False
    return np.asarray(made.astype(kind))


@lru_cache(maxsize=4)
def _smooth(height: int, width: int, scale: float, kind: str) -> NDArray[Any]:
    """Return the transforms of the smooth parts, shape (3, height, width)."""
    down, across = ((np.arange(side) / (2.0 * side)).astype(kind) for side in (height, width))
    return smooth_transforms(np.hypot(down[:, None], across), scale)


_ROUNDING = 32.0  # units that a sum in single precision may be off; measured: 9
_LARGE = 2**16  # pixels from which threads are worth their start


class Blur(Protocol):
    """What must be known of a blur."""

    border: str
    dtype: np.dtype[Any]
    threads: int

    @property
    def shape(self) -> tuple[int, int]:
        """Height and width of the images."""

    def positions(self, channel: int) -> NDArray[np.float64]:
        """Return where each point is in the bank of a channel."""


class Beyond:
    """The remainders of a blur: of every point a little light on every pixel, and the transpose.

    Parameters
    ----------
    banks : sequence of Bank
        One a channel, each with its remainder.
    tol : float
        Of the settings.
    """

    def __init__(self, banks: Sequence[Bank], tol: float) -> None:
        self._remainders = [bank.remainder for bank in banks]
        self._banks = list(banks)
        self._tol = tol
        self._kernels: dict[tuple[int, tuple[int, int], str], MirroredKernels] = {}
        self._factors: dict[int, tuple[NDArray[np.float64], NDArray[Any]]] = {}

    def error(self, blur: Blur) -> float:
        """Return the sum over pixels of the most that K is off there, of any channel, for this scene."""
        # In darkness nothing comes from farther away than the image is large.
        shape = blur.shape if blur.border == "zero" else None
        found = max(
            bank.remainder.error(blur.positions(channel), shape) + self._kernels_of(blur, channel).error
            for channel, bank in enumerate(self._banks)
            if bank.remainder is not None
        )
        return found + self.rounding(blur.dtype)

    @staticmethod
    def rounding(dtype: np.dtype[Any]) -> float:
        """Return what sums of this type may be off, of the brightest point."""
        return _ROUNDING * float(np.finfo(dtype).eps)

    def apart(self, channel: int) -> tuple[Bank, Bank]:
        """Return banks of what a PSF is within its windows, and of what the remainder holds there."""
        bank = self._banks[channel]
        assert bank.filled is not None
        return replace(bank, windows=bank.windows + bank.filled), replace(bank, windows=bank.filled)

    def spread(
        self, blur: Blur, channels: Sequence[int], planes: Sequence[NDArray[Any]], *, slopes: bool = False
    ) -> list[NDArray[Any]]:
        """Return what planes of light, of these channels, make beyond the windows.

        Parameters
        ----------
        blur : DepthBlur
        channels : sequence of int
        planes : sequence of ndarray, shape (height, width)
        slopes : bool, default False
            Of the remainders, take their derivatives by positions in the banks.

        Returns
        -------
        list of ndarray, shape (height, width)
        """
        factors = [self._factors_of(blur, channel, slopes) for channel in channels]
        kernels = [self._kernels_of(blur, channel) for channel in channels]

        light = [np.ascontiguousarray(plane) for plane in planes]

        def part(each: tuple[int, int]) -> NDArray[Any]:
            index, r = each
            return kernels[index].transformed(r, factors[index][r] * light[index])

        asked = [(index, r) for index, each in enumerate(factors) for r in range(len(each))]
        sums = _summed(asked, side_by_side(part, asked, _threads(blur)))
        return [each.image(total, _threads(blur)) for each, total in zip(kernels, sums, strict=True)]

    def collect(
        self, blur: Blur, channels: Sequence[int], planes: Sequence[NDArray[Any]], *, slopes: bool = False
    ) -> list[NDArray[Any]]:
        """Return what the transpose of :meth:`spread` makes of planes.

        Parameters
        ----------
        blur : DepthBlur
        channels : sequence of int
        planes : sequence of ndarray, shape (height, width)
        slopes : bool, default False
            As of :meth:`spread`.

        Returns
        -------
        list of ndarray, shape (height, width)
        """
        factors = [self._factors_of(blur, channel, slopes) for channel in channels]
        kernels = [self._kernels_of(blur, channel) for channel in channels]
        asked = [(index, r) for index, each in enumerate(factors) for r in range(len(each))]
        known = [each.known(plane, _threads(blur)) for each, plane in zip(kernels, planes, strict=True)]

        def part(each: tuple[int, int]) -> NDArray[Any]:
            index, r = each
            taken = kernels[index].taken(r, known[index])
            taken *= factors[index][r]
            return taken

        return _summed(asked, side_by_side(part, asked, _threads(blur)))

    def _kernels_of(self, blur: Blur, channel: int) -> MirroredKernels:
        """Return the kernels of a channel for images of this shape and border; kept."""
        remainder = self._remainders[channel]
        assert remainder is not None
        key = (id(remainder), blur.shape, blur.border)
        if key not in self._kernels:
            self._kernels[key] = MirroredKernels(remainder, blur.shape, blur.border, blur.dtype, self._tol)
        return self._kernels[key]

    def _factors_of(self, blur: Blur, channel: int, slopes: bool) -> NDArray[Any]:
        """Return the a_r of all points, shape (rank, height, width); kept for the depth of the last call.

        Or their derivatives by positions in the bank, which are not kept.
        """
        remainder, positions = self._remainders[channel], blur.positions(channel)
        assert remainder is not None
        if slopes:
            return np.asarray(remainder.slopes(positions, blur.dtype) * blur.dtype.type(remainder.spacing))
        last = self._factors.get(id(remainder))
        if last is None or last[0] is not positions:
            last = self._factors[id(remainder)] = positions, remainder.factors(positions, blur.dtype)
        return last[1]


def _summed(asked: Sequence[tuple[int, int]], parts: Sequence[NDArray[Any]]) -> list[NDArray[Any]]:
    """Return the sum over r of the parts of each plane."""
    sums: list[NDArray[Any]] = []
    for (_, r), found in zip(asked, parts, strict=True):
        if r == 0:
            sums.append(found)
        else:
            sums[-1] += found
    return sums


def _threads(blur: Blur) -> int:
    return (blur.threads or os.cpu_count() or 1) if blur.shape[0] * blur.shape[1] >= _LARGE else 1
