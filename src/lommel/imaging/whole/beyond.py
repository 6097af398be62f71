"""What lies beyond the windows, of the light of whole images: the remainders of all channels, side by side."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from lommel.base.together import side_by_side
from lommel.imaging.bank import Bank
from lommel.imaging.whole.mirrored import MirroredKernels

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
