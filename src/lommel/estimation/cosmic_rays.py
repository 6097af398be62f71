"""Pixels of stars that cosmic rays have struck, or that are hot: tracks that are sharper than light through a pupil.

Without a model of the star a pixel is struck that exceeds its neighbours by more than a point of light without
aberration does, as in "Laplacian" searches (van Dokkum 2001, doi:10.1086/323894): tracks are lines, and most
neighbours of their pixels are dark.
"""

from __future__ import annotations

from itertools import product
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from scipy.stats import norm

from lommel.base.arrays import Array
from lommel.optics.pupil import Pupil
from lommel.psf import psf

Mask: TypeAlias = NDArray[np.bool_]

_SURE, _BESIDE = 6.0, 3.0  # standard deviations: of a struck pixel, and of one beside a struck pixel
_SHARPER = 2.0  # times the excess over its neighbours of a point of light without aberration; half beside a track
_LEAST = 8.0  # least ratio to neighbours: on pixels far below lambda*N dark lines of any width occur
_NEIGHBOUR = 0.25  # standard deviation of the middle of neighbours, over twice that of a pixel: faint points are rare
_SPAN, _SHIFTS, _LIT = 7, 4, 0.05  # pixels of such an image, positions of the axis in one, bright share of the peak
_DARK = 0.02  # quantile of the pixels of a window that are dark: below its sky or hardly above
_LONGEST = 8  # passes in which tracks grow
_MOST = 0.06  # of the pixels of a window: more are not rays
_AROUND, _SIDES = (ndimage.generate_binary_structure(2, n)[None] for n in (2, 1))  # of a pixel, which is one of them
_OTHERS = [place for place in product(range(3), range(3)) if place != (1, 1)]


def sharpness(pupil: Pupil, pixel: float, *, integrate: bool) -> float:
    """Return the largest ratio of a pixel to the middle one of its neighbours, for a point in focus."""
    # The ratio depends on where the axis is in a pixel.
    side = _SPAN * _SHIFTS
    fine = np.asarray(psf(pupil.unaberrated(), side, pixel / _SHIFTS, tol=1e-4, integrate=integrate).values, float)
    found = 1.0
    for row, column in product(range(_SHIFTS), range(_SHIFTS)):  # where the axis is in a pixel
        if integrate:
            part = fine[row : side - _SHIFTS + row, column : side - _SHIFTS + column]
            image = part.reshape(_SPAN - 1, _SHIFTS, _SPAN - 1, _SHIFTS).sum(axis=(1, 3))
        else:
            image = fine[row::_SHIFTS, column::_SHIFTS]
        near = _middle(image[None], np.ones((1, *image.shape), dtype=bool))[0]
        bright = image > _LIT * image.max()
        found = max(found, float((image / np.maximum(near, 1e-6 * image.max()))[bright].max()))
    return found


def struck(electrons: Array, variance: Array, valid: Mask, sharpest: float) -> Mask:
    """Return which pixels of images (..., height, width) are struck, and the rims of tracks.

    `variance` is that of the noise beside Poisson's, `sharpest` as of :func:`sharpness`. Where more pixels are found
    than rays would strike, it is the star that is sharp, and none is left out.
    """
    height, width = electrons.shape[-2:]
    known = valid.reshape(-1, height, width)
    light = np.where(known, electrons.reshape(known.shape), np.nan)
    read = variance.reshape(known.shape)
    # The sky is no brighter than the darkest pixels beside their noise: light of a star may fill a window.
    dark = np.nanquantile(light, _DARK, axis=(1, 2), method="lower", keepdims=True)
    noisy = np.maximum(dark, 0.0) + read.mean(axis=(1, 2), keepdims=True)
    # Noise alone puts the quantile that many standard deviations below the sky.
    level = dark - norm.ppf(_DARK) * np.sqrt(noisy)
    excess, noisy = light - level, read + np.maximum(level, 0.0)
    found, steepest = np.zeros(known.shape, dtype=bool), max(_SHARPER * sharpest, _LEAST)
    for _ in range(_LONGEST):
        near = np.maximum(_middle(excess, known & ~found), 0.0)
        beside = ndimage.binary_dilation(found, _AROUND)
        most = np.where(beside, 0.5, 1.0) * steepest
        spread = noisy + most * near + (_NEIGHBOUR * most) ** 2 * (noisy + near)
        over = excess - most * near
        # Bernstein's bound of Poisson's tail.
        off = over / np.sqrt(np.maximum(spread + np.maximum(over, 0.0) / 3.0, 1e-3))
        more = known & ~found & (off > np.where(beside, _BESIDE, _SURE))
        if not more.any():
            break
        found |= more
    # Windows of a sharp star lose no pixel.
    few = found.sum(axis=(1, 2)) <= _MOST * known.sum(axis=(1, 2))
    found &= few[:, None, None]
    return np.asarray(known & ndimage.binary_dilation(found, _SIDES)).reshape(valid.shape)


def _middle(images: Array, known: Mask) -> Array:
    """Return the middle one of each pixel's known neighbours, of an even number the brighter."""
    padded = np.pad(np.where(known, images, -np.inf), ((0, 0), (1, 1), (1, 1)), constant_values=-np.inf)
    _, height, width = images.shape
    around = [padded[:, y : y + height, x : x + width] for y, x in _OTHERS]
    near = np.sort(np.stack(around), axis=0)[::-1]
    count = np.isfinite(near).sum(axis=0)
    found = np.take_along_axis(near, np.maximum(count - 1, 0)[None] // 2, axis=0)[0]
    return np.where(count > 0, found, 0.0)
