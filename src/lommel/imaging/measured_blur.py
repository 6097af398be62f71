"""Blur by a measured PSF, the same all over the image."""

from __future__ import annotations

from collections.abc import Sequence
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
    """Blur by one window of each channel, all over an image that is mirrored at its edges.

    Parameters
    ----------
    shape : (int, int)
    windows : sequence of ndarray
        Odd squares of sum 1, pixel-integrated.
    findings : Findings
        Those of the PSFs.
    """

    dtype = np.dtype(np.float32)

    def __init__(self, shape: tuple[int, int], windows: Sequence[Array], findings: Findings) -> None:
        self.shape, self.channels, self.findings = shape, len(windows), findings
        self._windows = [np.asarray(window, self.dtype) for window in windows]
        widest = max(len(window) for window in windows)
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
        windows = [_trimmed(psf.values[0]) for psf in pitched] * (channels // len(psfs))
        return cls((shape[0], shape[1]), windows, Findings([found for psf in pitched for found in psf.findings]))

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


def _trimmed(values: Array) -> Array:
    """Return the smallest odd square around the middle pixel that has nearly all of the light, with sum 1."""
    middle = len(values) // 2
    reach = np.maximum(*np.abs(np.indices(values.shape) - middle))
    within = np.cumsum(np.bincount(reach.ravel(), values.ravel()))
    half = max(int(np.searchsorted(within, _LEAST_LIGHT * within[-1])), 1)
    part = values[middle - half : middle + half + 1, middle - half : middle + half + 1]
    return np.asarray(part / part.sum())
