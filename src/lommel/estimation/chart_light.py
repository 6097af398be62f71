"""Uneven light on a chart: a smooth function of the position, from the white squares of all windows."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from lommel.base.arrays import Array
from lommel.estimation.field_signs import monomials

_DEGREE = 4
_TURNS = 10
_BLURRED = 2  # pixels beside lines whose light is left out
_LEAST = 10  # white pixels of a window


def relative_light(electrons: Array, valid: NDArray[np.bool_], u: Array, v: Array) -> Array:
    """Return light in each pixel over that in the middle of its window, shape of `electrons` (n, e, height, width).

    `u` (n, width) and `v` (n, height) are positions of pixels over the sensor, from -1 to 1. The logarithm of the
    light is a polynomial of these: of degree 4, or less where windows are fewer than one and a half for each
    coefficient.
    """
    count, exposures, height, width = electrons.shape
    degree = max((d for d in range(_DEGREE + 1) if 3 * (d + 1) * (d + 2) <= 4 * count), default=0)
    found = np.ones(electrons.shape)
    if degree == 0:
        return found
    over = monomials(np.repeat(u[:, None], height, axis=1), np.repeat(v[:, :, None], width, axis=2), degree)
    for e in range(exposures):
        white = np.array([_white(*pair) for pair in zip(electrons[:, e], valid[:, e], strict=True)])
        basis, light = over[white], np.log(electrons[:, e][white])
        if np.linalg.matrix_rank(basis) < basis.shape[1]:
            continue
        weight = np.ones(len(light))
        for _ in range(_TURNS):  # robustly (Geman and McClure): dirt, print
            root = np.sqrt(weight)
            share = np.linalg.lstsq(root[:, None] * basis, root * light, rcond=None)[0]
            distance = np.abs(light - basis @ share)
            weight = 1.0 / (1.0 + (distance / max(3.0 * float(np.median(distance)), 1e-6)) ** 2) ** 2
        smooth = over @ share
        found[:, e] = np.exp(smooth - smooth[:, height // 2, width // 2, None, None])
    return found


def _white(image: Array, valid: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return the pixels in white squares, away from lines."""
    low, high = np.percentile(image[valid], [5.0, 95.0])
    bright = ndimage.median_filter(image, size=3, mode="nearest") > 0.5 * (low + high)
    inside = ndimage.binary_erosion(bright, iterations=_BLURRED, border_value=True) & valid & (image > 0.0)
    return inside if inside.sum() >= _LEAST else np.zeros_like(inside)
