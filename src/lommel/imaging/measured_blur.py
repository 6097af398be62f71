"""Blur by a measured PSF, the same all over the image."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Self

import numpy as np
import scipy

from lommel.base.arrays import Array, Values
from lommel.base.units import format_length
from lommel.deconvolve.linear import LinearBlur, copies, folded
from lommel.fit.findings import Findings
from lommel.measures.measured_psf import MeasuredPSF

_LEAST_LIGHT = 0.999  # of a PSF, within the window that is used


class MeasuredBlur(LinearBlur):
    """Blur by the PSF of each channel, all over an image that is mirrored at its edges.

    Parameters
    ----------
    shape : (int, int)
    psfs : sequence of MeasuredPSF
        PSFs of the channels, on the pixels of the image.
    scale : float
        Factor of the width of the PSFs.
    """

    dtype = np.dtype(np.float32)

    def __init__(self, shape: tuple[int, int], psfs: Sequence[MeasuredPSF], scale: float = 1.0) -> None:
        self.shape, self.channels, self._psfs = shape, len(psfs), psfs
        self.findings = Findings([found for psf in dict.fromkeys(psfs) for found in psf.findings])
        windows = {psf: _trimmed(_scaled(psf, scale)) for psf in dict.fromkeys(psfs)}
        self._windows = [np.asarray(windows[psf], self.dtype) for psf in psfs]
        widest = max(len(window) for window in self._windows)
        if widest > min(shape):
            raise ValueError(
                f"the PSF has light in {widest} pixels, more than the shorter side of the photograph: crop it"
            )

    @classmethod
    def of(cls, shape: tuple[int, ...], psfs: Sequence[MeasuredPSF], pixel: float | None) -> Self:
        """Return the blur of a photograph by one PSF for all channels, or by one for each.

        `pixel` is the pitch of the photograph, by default that of the PSFs.
        """
        channels = shape[2] if len(shape) == 3 else 1
        if len(psfs) not in (1, channels):
            raise ValueError(f"lens must have one PSF, or one for each of {channels} channels, got {len(psfs)}")
        for psf in psfs:
            if len(psf.values) > 1:
                raise ValueError(
                    f"lens must be the PSF of a photograph, got that of a stack of {len(psf.values)} planes of "
                    f"{format_length(psf.pixel)}; for stacks use lommel.microscopy.deconvolve"
                )
        pitched = [psf if pixel is None else psf.resampled(pixel, pixel) for psf in psfs]
        return cls((shape[0], shape[1]), pitched * (channels // len(psfs)))

    def scaled(self, factor: float) -> MeasuredBlur:
        """Return the blur by PSFs that are wider by a factor."""
        return MeasuredBlur(self.shape, self._psfs, factor)

    def window(self, row: int, column: int, channel: int = 0) -> Array:
        """Return the PSF of a channel, which is the same at all pixels."""
        return self._windows[channel]

    def forward(self, image: Values) -> Values:
        """Return the blurred image."""

        def blurred(channel: int, plane: Values) -> Values:
            window = self._windows[channel]
            rows, columns = (copies(side, len(window) // 2) for side in self.shape)
            return np.asarray(scipy.signal.oaconvolve(plane[rows[:, None], columns], window, "valid"))

        return self.by_channel(image, blurred)

    def adjoint(self, image: Values) -> Values:
        """Return the transpose of :meth:`forward` applied to an image."""

        def gathered(channel: int, plane: Values) -> Values:
            window = self._windows[channel]
            spread = scipy.signal.oaconvolve(plane, window[::-1, ::-1], "full")
            return folded(np.asarray(spread), (len(window) // 2,) * 2, self.shape)

        return self.by_channel(image, gathered)


def _scaled(psf: MeasuredPSF, scale: float) -> Array:
    """Return the values of a PSF that is wider by a factor."""
    if scale == 1.0:
        return np.asarray(psf.values[0])
    dark = math.ceil(max(psf.values.shape) * max(1.0 / scale - 1.0, 0.0))
    padded = replace(psf, values=np.pad(psf.values, ((0, 0), (dark, dark), (dark, dark))))
    return np.asarray(padded.resampled(psf.pixel / scale, psf.step).values[0])


def _trimmed(values: Array) -> Array:
    """Return the smallest odd square around the middle pixel that has nearly all of the light, with sum 1."""
    middle = len(values) // 2
    reach = np.maximum(*np.abs(np.indices(values.shape) - middle))
    within = np.cumsum(np.bincount(reach.ravel(), values.ravel()))
    half = max(int(np.searchsorted(within, _LEAST_LIGHT * within[-1])), 1)
    part = values[middle - half : middle + half + 1, middle - half : middle + half + 1]
    return np.asarray(part / part.sum())
