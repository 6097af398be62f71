"""Discrete transforms of the values in a window: sums over pixels, which alias where these are large."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base.arrays import Array
from lommel.measures.answer import Answer, checked
from lommel.measures.energy import energy_per_pixel
from lommel.measures.transfer import Complexes, frequencies


def sampled_otf(answer: Answer, fx: ArrayLike, fy: ArrayLike = 0.0) -> Complexes:
    """Return the discrete Fourier transform of the values in the window, by direct summation.

    :func:`lommel.otf` is the transfer function of the image. That of its samples repeats with the sampling frequency
    1 / pixel: at the Nyquist frequency it is twice the real part of the image's.

    Parameters
    ----------
    answer : PSF
    fx, fy : array_like
        As of :func:`lommel.otf`, at most the Nyquist frequency ``1 / (2 pixel)``.

    Returns
    -------
    complex or complex ndarray, shape ``answer.pupil.shape + s``
        ``sum values exp(-2 pi i (fx x + fy y))`` as a fraction of all light, x and y from the axis: the sum of the
        image's transfer function at f and at its aliases, f plus multiples of 1 / pixel, but for the light outside
        of the window and the error of the values. At frequency 0 it is the light in the window.

    Raises
    ------
    TypeError, ValueError
        If the frequencies are not finite, do not broadcast, or exceed that of Nyquist.
    """
    checked(answer)
    across, down = frequencies(fx, fy)
    height, width = answer.grid.pitch
    for name, part, pitch in (("fx", across, width), ("fy", down, height)):
        limit = 0.5 / pitch
        if part.size and np.abs(part).max() > limit * (1.0 + 1e-12):
            raise ValueError(
                f"{name} must be at most the Nyquist frequency 1 / (2 pixel) = {limit:.6g} of the samples, "
                f"got {np.abs(part).max():.6g}"
            )
    x, y = answer.grid.x, answer.grid.y
    columns = np.exp(-2j * math.pi * x[..., None] * across.ravel())
    rows = np.exp(-2j * math.pi * y[..., None] * down.ravel())
    found = np.einsum("...yf,...yf->...f", energy_per_pixel(answer) @ columns, rows)
    result: Complexes = found.reshape(answer.pupil.shape + across.shape)[()]
    return result


def sampled_spectrum(answer: Answer) -> tuple[Array, Array, NDArray[np.complex128]]:
    """Return the frequencies of the window and its transfer function there, by FFT.

    See :func:`lommel.measures.image_transfer.sampled_otf`.

    Parameters
    ----------
    answer : PSF

    Returns
    -------
    fx, fy : ndarray, shapes (width,) and (height,)
        Rising, in steps of 1 / (width pixel) and 1 / (height pixel); 0 at ``width // 2`` and ``height // 2``.
    values : complex ndarray, shape ``answer.values.shape``
    """
    checked(answer)
    from scipy import fft

    grid = answer.grid
    fx = fft.fftshift(fft.fftfreq(grid.width, grid.pitch[1]))
    fy = fft.fftshift(fft.fftfreq(grid.height, grid.pitch[0]))
    plain = fft.fftshift(fft.fft2(energy_per_pixel(answer)), axes=(-2, -1))
    # The transform counts from the first pixel, positions from the axis.
    shift = np.exp(-2j * math.pi * (fy[:, None] * grid.y[..., :1, None] + fx * grid.x[..., :1, None]))
    return fx, fy, np.asarray(plain * shift)
