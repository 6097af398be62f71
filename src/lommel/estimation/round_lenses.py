"""Transfer functions of lens and pixels: discrete Fourier transforms of pixel-integrated PSFs, aliasing included.

Beyond a window the intensity of a circular aperture falls as ``r^-3`` on average at any defocus; the light outside
the window is added by this law.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.optics.lens import Lens
from lommel.psf import psf
from lommel.special import zernike

# Pixels of a window beyond the cone of rays, for pixels up to 3 lambda*N wide; fewer for larger ones.
_MARGIN, _LEAST_MARGIN = 20, 4


def require_round(name: str, lens: Lens) -> None:
    """Raise ValueError unless a lens, called `name`, has one set of radially symmetric PSFs."""
    if lens.aberrations.shape != ():
        raise ValueError(f"{name} must have one set of aberrations, got a stack of shape {lens.aberrations.shape}")
    if not lens.aberrations.radial:
        terms = lens.aberrations.to_zernike()
        kinds = list(dict.fromkeys(zernike.name(n, m) for (n, m), c in terms.items() if m and c))
        others = f" and {len(kinds) - 4} more" if len(kinds) > 4 else ""
        raise ValueError(
            f"{name} must have radially symmetric aberrations, got {', '.join(kinds[:4])}{others}: leave these terms "
            "out of the lens (its section [aberrations]), or blur by lommel.imaging.FieldBlur, which takes any PSF"
        )
    if lens.spider or lens.vignetting or lens.mask or lens.stop:
        raise ValueError(
            f"{name} must have a round aperture, without spider, vignetting, mask and stop: leave these out, or blur "
            "by lommel.imaging.FieldBlur, which takes any aperture"
        )


def pixel_of(lenses: Sequence[Lens], pixel: float) -> float:
    """Return a pixel pitch in metres; TypeError or ValueError unless the PSFs of all lenses are circular."""
    if not isinstance(lenses, Sequence) or not lenses or not all(isinstance(lens, Lens) for lens in lenses):
        raise TypeError(f"lenses must be a sequence of Lens, one for each photograph, got {validation.shown(lenses)}")
    pitch = validation.pixel(pixel, metric=True)
    for k, lens in enumerate(lenses):
        require_round(f"lenses[{k}]", lens)
        validation.pixel_on(pitch, lens.wavelength * lens.working_f_number, metric=True)
    return pitch


class WindowError(ValueError):
    """The windows would be too large."""


# Pixels from the middle of a window to its edge, at most.
MOST_HALF = 512


def half_window(lenses: Sequence[Lens], distances: Array, pixel: float) -> int:
    """Return half of a window, pixels, for the blur of all lenses at all distances; WindowError if too large."""
    radius = max(float(lens.pupil(distances).geometric_radius().max()) for lens in lenses)
    widest = max(lens.wavelength * lens.working_f_number for lens in lenses)
    margin = max(_LEAST_MARGIN, math.ceil(_MARGIN * min(1.0, 3.0 * widest / pixel)))
    half = 1.1 * radius / pixel + margin
    if not half <= MOST_HALF:
        side, most = f"{2.0 * half + 1.0:.5g}", 2 * MOST_HALF + 1
        raise WindowError(
            f"distance: windows would need {side} x {side} pixels; the limit is {most} x {most}. Stop down, take "
            "larger pixels, or distances nearer to the focus"
        )
    return math.ceil(1.1 * radius / pixel) + margin


def pixel_transfer(
    lens: Lens,
    distances: Array,
    spectrum: Sequence[tuple[float, float]],
    pixel: float,
    shape: tuple[int, int],
    half: int,
) -> NDArray[np.float32]:
    """Return transfer functions at the frequencies of a discrete Fourier transform.

    Parameters
    ----------
    lens : Lens
        With a circular aperture and radially symmetric aberrations, so that the functions are real and even.
    distances : ndarray, shape (count,)
        Object distances, metres.
    spectrum : sequence of (wavelength, weight)
        Weights sum to 1.
    pixel : float
        Metres.
    shape : (int, int)
        Shape of the images to transform, each side at least ``2 half + 1``.
    half : int
        Half width of the windows, pixels.

    Returns
    -------
    ndarray, shape (count, height // 2 + 1, width // 2 + 1)
        At 0, 1, 2, ... cycles per image height and width; 1 at frequency 0.
    """
    pupil, total = lens.pupil(distances), np.zeros((len(distances), half + 1, half + 1))
    for wavelength, weight in spectrum:
        values = psf(pupil.in_light(wavelength), 2 * half + 1, pixel, integrate=True, dtype=np.float64).values
        total += weight * values[:, half:, half:]
    return transfer_of_windows(total, shape)


def transfer_of_windows(quarter: Array, shape: tuple[int, int]) -> NDArray[np.float32]:
    """Return the transfer functions of symmetric windows, given from the middle row and column on."""
    half = quarter.shape[1] - 1
    across, down = _cosines(shape[1], half), _cosines(shape[0], half)
    # At frequency 0 the transform is the light in the window.
    total = down @ quarter @ across.T
    total += (1.0 - total[:, :1, :1]) * _beyond(shape, half)
    return np.asarray(total, dtype=np.float32)


def squared_frequency(shape: tuple[int, int]) -> Array:
    """Return the square of each frequency of :func:`pixel_transfer`, cycles a pixel."""
    down, across = (np.arange(side // 2 + 1) / side for side in shape)
    return np.asarray(down[:, None] ** 2 + across**2)


def multiplicity(shape: tuple[int, int]) -> Array:
    """Return the share of all frequencies that each one of :func:`pixel_transfer` stands for."""

    def times(side: int) -> Array:
        count = np.full(side // 2 + 1, 2.0)
        count[0] = 1.0
        if side % 2 == 0:
            count[-1] = 1.0
        return count / side

    return np.asarray(times(shape[0])[:, None] * times(shape[1]))


def texture_frequencies(shape: tuple[int, int]) -> tuple[Array, Array]:
    """Return :func:`squared_frequency`, infinite for the mean, which is no texture, and :func:`multiplicity`."""
    square = squared_frequency(shape)
    square[0, 0] = np.inf
    return square, multiplicity(shape)


@lru_cache(maxsize=8)
def _cosines(side: int, half: int) -> Array:
    """Return the cosine transform of symmetric windows from their middle on."""
    angle = 2.0 * math.pi / side * np.outer(np.arange(side // 2 + 1), np.arange(half + 1))
    made = np.cos(angle)
    made[:, 1:] *= 2.0
    return np.asarray(made)


@lru_cache(maxsize=4)
def _beyond(shape: tuple[int, int], half: int) -> Array:
    """Return the transform of light that falls as ``r^-3`` beyond a window, and sums to 1."""
    from scipy.fft import rfft2

    down, across = (np.minimum(np.arange(side), side - np.arange(side)) for side in shape)
    outside = np.maximum(down[:, None], across) > half
    if not outside.any():
        return np.ones((shape[0] // 2 + 1, shape[1] // 2 + 1))
    square = (down[:, None] ** 2 + across**2).astype(np.float64)
    tail = np.where(outside, np.maximum(square, 1.0) ** -1.5, 0.0)
    return np.asarray(rfft2(tail / tail.sum()).real[: shape[0] // 2 + 1])
