"""Detection of cosmic rays and hot pixels in images of stars: features that are sharper than any image of a star.

No model of the star is required. A pixel is part of a track if its ratio to its neighbours exceeds the largest ratio
in the image of an unaberrated star; a similar method is Laplacian detection (van Dokkum 2001, doi:10.1086/323894).
Tracks are lines: most neighbours of their pixels are dark. A pixel is compared with the median of its neighbours.
"""

from __future__ import annotations

from itertools import product
from typing import TypeAlias

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.optics.pupil import Pupil
from lommel.psf import psf

Mask: TypeAlias = NDArray[np.bool_]

# Thresholds in standard deviations: for a pixel of a track, and for a pixel next to a detected track.
_SIGMA, _SIGMA_ADJACENT = 6.0, 3.0
# Threshold of the ratio of a pixel to its neighbours, divided by the largest ratio of an unaberrated star. Next to a
# detected track the threshold is half as large.
_RATIO_FACTOR = 2.0
_MIN_RATIO = 8.0  # smallest threshold of the ratio: with pixels far below lambda*N images have narrow dark lines
# Assumed standard deviation of the median of the neighbours, divided by the standard deviation of a pixel. For
# neighbours of equal brightness it is about twice as large; the smaller value suffices because faint hits are rare.
_NEIGHBOUR_SIGMA = 0.25
_SPAN = 7  # pixels: side of the window of the star for which the ratio is computed
_SHIFTS = 4  # number of positions of the star's axis within a pixel, along each side
_MIN_BRIGHTNESS = 0.05  # smallest brightness of pixels whose ratio is used, divided by the peak
_DARK_QUANTILE = 0.02  # fraction of pixels of a window that is assumed to contain sky only
_MAX_PASSES = 8  # maximum number of passes; tracks grow by a pixel in each pass
_MAX_FRACTION = 0.06  # largest fraction of pixels of a window that cosmic rays are assumed to hit
# Masks of a pixel with its eight neighbours, and of a pixel with its four edge neighbours.
_EIGHT_NEIGHBOURS = np.ones((1, 3, 3), dtype=bool)
_FOUR_NEIGHBOURS = np.array([[[0, 1, 0], [1, 1, 1], [0, 1, 0]]], dtype=bool)
_OFFSETS = [offset for offset in product(range(3), range(3)) if offset != (1, 1)]


def sharpness(pupil: Pupil, pixel: float, *, integrate: bool) -> float:
    """Return the largest ratio of a pixel to the median of its neighbours, for an unaberrated star in focus."""
    # The ratio depends on the position of the axis within a pixel.
    side = _SPAN * _SHIFTS
    star = psf(pupil.unaberrated(), side, pixel / _SHIFTS, tol=1e-4, integrate=integrate)
    fine_image = np.asarray(star.values, float)
    largest_ratio = 1.0
    for row, column in product(range(_SHIFTS), range(_SHIFTS)):
        if integrate:
            shifted_image = fine_image[row : side - _SHIFTS + row, column : side - _SHIFTS + column]
            image = shifted_image.reshape(_SPAN - 1, _SHIFTS, _SPAN - 1, _SHIFTS).sum(axis=(1, 3))
        else:
            image = fine_image[row::_SHIFTS, column::_SHIFTS]
        median = _neighbour_median(image[None], np.ones((1, *image.shape), dtype=bool))[0]
        is_bright = image > _MIN_BRIGHTNESS * image.max()
        largest_ratio = max(largest_ratio, float((image / np.maximum(median, 1e-6 * image.max()))[is_bright].max()))
    return largest_ratio


def cosmic_ray_mask(electrons: Array, variance: Array, valid: Mask, sharpest: float) -> Mask:
    """Return a mask of pixels of images (..., height, width) in tracks of cosmic rays and at their edges.

    `variance` is the read variance (electrons^2), `sharpest` a result of :func:`sharpness`. If tracks contain more
    pixels of a window than cosmic rays would hit, the star itself is sharp, and the mask of the window is empty.
    """
    height, width = electrons.shape[-2:]
    valid_windows = valid.reshape(-1, height, width)
    values = np.where(valid_windows, electrons.reshape(valid_windows.shape), np.nan)
    read = variance.reshape(valid_windows.shape)
    # The sky is estimated from the darkest pixels, because the star may fill most of a window.
    dark_level = np.nanquantile(values, _DARK_QUANTILE, axis=(1, 2), method="lower", keepdims=True)
    noise = np.maximum(dark_level, 0.0) + read.mean(axis=(1, 2), keepdims=True)
    # The quantile `dark_level` differs from the sky by the same quantile of normal noise, which is negative.
    sky = dark_level - scipy.special.ndtri(_DARK_QUANTILE) * np.sqrt(noise)
    excess, noise = values - sky, read + np.maximum(sky, 0.0)
    tracks, ratio = np.zeros(valid_windows.shape, dtype=bool), max(_RATIO_FACTOR * sharpest, _MIN_RATIO)
    for _ in range(_MAX_PASSES):
        median = np.maximum(_neighbour_median(excess, valid_windows & ~tracks), 0.0)
        is_adjacent = scipy.ndimage.binary_dilation(tracks, _EIGHT_NEIGHBOURS)
        threshold = np.where(is_adjacent, 0.5, 1.0) * ratio
        # Variance of the pixel, and of the threshold times the median of its neighbours.
        total_variance = noise + threshold * median + (_NEIGHBOUR_SIGMA * threshold) ** 2 * (noise + median)
        difference = excess - threshold * median
        # Bernstein's bound on the tail of a Poisson distribution.
        sigmas = difference / np.sqrt(np.maximum(total_variance + np.maximum(difference, 0.0) / 3.0, 1e-3))
        is_added = valid_windows & ~tracks & (sigmas > np.where(is_adjacent, _SIGMA_ADJACENT, _SIGMA))
        if not is_added.any():
            break
        tracks |= is_added
    is_plausible = tracks.sum(axis=(1, 2)) <= _MAX_FRACTION * valid_windows.sum(axis=(1, 2))
    tracks &= is_plausible[:, None, None]
    return np.asarray(valid_windows & scipy.ndimage.binary_dilation(tracks, _FOUR_NEIGHBOURS)).reshape(valid.shape)


def _neighbour_median(images: Array, valid: Mask) -> Array:
    """Return the median of the valid neighbours of each pixel; of an even number, the brighter of the middle two."""
    padded = np.pad(np.where(valid, images, -np.inf), ((0, 0), (1, 1), (1, 1)), constant_values=-np.inf)
    _, height, width = images.shape
    neighbours = [padded[:, y : y + height, x : x + width] for y, x in _OFFSETS]
    sorted_neighbours = np.sort(np.stack(neighbours), axis=0)[::-1]
    count = np.isfinite(sorted_neighbours).sum(axis=0)
    median = np.take_along_axis(sorted_neighbours, np.maximum(count - 1, 0)[None] // 2, axis=0)[0]
    return np.where(count > 0, median, 0.0)
