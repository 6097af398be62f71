"""Voxels that light through the objective cannot make: hot and blinking pixels of the camera, cosmic rays."""

from __future__ import annotations

import math
from itertools import product
from typing import Any

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.recorded.noise import Noise

_SURE = 10.0  # standard deviations of the noise,
_SHARPER = 2.0  # and times what the PSF lets a point exceed its neighbours by
MOST = 1e-3  # of all voxels: more are not the camera's


def sharpness(psf: Array) -> float:
    """Return how many times brighter the brightest voxel of a PSF is than the next in its plane."""
    plane, row, column = np.unravel_index(int(psf.argmax()), psf.shape)
    around = psf[plane, max(row - 1, 0) : row + 2, max(column - 1, 0) : column + 2].copy()
    top = float(around.max())
    around[around == top] = 0.0
    return top / max(float(around.max()), 1e-12 * top)


def hot_voxels(stack: Any, noise: Noise, sharpest: float) -> Array:
    """Return plane, row and column of the hot voxels of a stack, shape ``(n, 3)``.

    A voxel is one where its excess over the median of the plane is more than twice `sharpest` times that of the
    brightest of its eight neighbours, and ten standard deviations of the noise besides.
    """
    noise = noise.poisson
    gain = np.asarray(1.0 if noise.white is None else noise.white)
    found = []
    for plane in range(len(stack)):
        given = np.asarray(stack[plane], dtype=np.float64)
        known = np.isfinite(given)
        values = np.where(known, given, -np.inf)
        height, width = values.shape
        padded = np.pad(values, 1, constant_values=-np.inf)
        near = np.full_like(values, -np.inf)
        for y, x in product(range(3), range(3)):
            if (y, x) != (1, 1):
                np.maximum(near, padded[y : y + height, x : x + width], out=near)
        base = float(np.median(given[known])) if known.any() else 0.0
        counted = np.maximum(gain * (np.maximum(values, base) - noise.offset), 0.0)
        sure = _SURE * np.sqrt(counted + np.asarray(noise.read) ** 2) / gain
        hot = values - base > _SHARPER * sharpest * np.maximum(near - base, 0.0) + sure
        found.append(np.column_stack([np.full(np.count_nonzero(hot), plane), *np.nonzero(hot)]))
    return np.concatenate(found)


class LeftOut:
    """A stack some of whose voxels are unknown: NaN, or, of integers, not below `limit`."""

    def __init__(self, stack: Any, voxels: Array, limit: float) -> None:
        self._stack, self._voxels = stack, voxels
        self.shape, self.dtype = stack.shape, stack.dtype
        whole = self.dtype.kind in "iu"
        self.limit = min(limit, float(np.iinfo(self.dtype).max)) if whole else limit
        self._unknown = self.dtype.type(self.limit if whole else math.nan)

    def __len__(self) -> int:
        return int(self.shape[0])

    def __getitem__(self, at: Any) -> Values:
        plane, *rest = at if isinstance(at, tuple) else (at,)
        part: Values = np.array(self._stack[(plane, *rest)])
        here = self._voxels[self._voxels[:, 0] == plane][:, 1:]
        for axis, each in enumerate(rest):
            first, end, _ = each.indices(self.shape[1 + axis])
            here = here[(here[:, axis] >= first) & (here[:, axis] < end)]
            here[:, axis] -= first
        part[here[:, 0], here[:, 1]] = self._unknown
        return part
