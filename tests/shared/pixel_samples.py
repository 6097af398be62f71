"""Averages over pixels by Gauss's rule of samples within each."""

from __future__ import annotations

import numpy as np

import lommel as lm
from lommel.optics.grid import Grid


def averages_of_samples(
    pupil: lm.Pupil, grid: Grid, count: int, method: lm.methods.Method, **more: object
) -> np.ndarray:
    """Return averages, or what `more` asks of images beside values, of so many samples along each axis of a pixel."""
    x, weight = np.polynomial.legendre.leggauss(count)
    row, column = grid.center
    total: np.ndarray | float = 0.0
    for y, of_y in zip(0.5 * x, 0.5 * weight, strict=True):
        for across, of_x in zip(0.5 * x, 0.5 * weight, strict=True):
            at = (row - y, column - across)
            made = lm.psf(
                pupil, grid.shape, grid.pixel, center=at, integrate=False, method=method, normalize="strehl", **more
            )
            values = np.stack([made.values, *(made.derivatives or {}).values()])
            total = total + of_y * of_x * values
    return np.asarray(total)
