"""Voxels that light through the objective cannot make: hot and blinking pixels of the camera, cosmic rays."""

from __future__ import annotations

import math
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.recorded.noise import Noise

_SURE = 10.0  # standard deviations of the noise,
_SHARPER = 2.0  # and times what the PSF lets a point exceed its neighbours by
MOST = 1e-3
"""Of all voxels, that single events are: more are points of light, sharper than PSFs that are too wide."""

_PERSISTENT = 8.0  # standard errors, by which the mean over all planes exceeds that of the neighbours
_MOSTLY = 0.75  # of the planes: at least so many above the median of the neighbours,
_ABOVE = 0.6  # and more above them all;
_BUT_ONE = 0.5  # or in the mean by so much of the excess above all but one, which may be hot, too
_PLANES = 32  # that are looked at
_FEW = 5  # planes, below which nothing is persistent
_PASSES = 3  # of which each leaves out what the last one found
_NEAR = [(y, x) for y, x in product((-1, 0, 1), (-1, 0, 1)) if y or x]
_SIDES = [(y, x) for y, x in _NEAR if 0 in (y, x)]
_NEXT = [(2 * y, 2 * x) for y, x in _NEAR]


def sharpness(psf: Array) -> float:
    """Return how many times brighter the brightest voxel of a PSF is than the next in its plane."""
    plane, row, column = np.unravel_index(int(psf.argmax()), psf.shape)
    around = psf[plane, max(row - 1, 0) : row + 2, max(column - 1, 0) : column + 2].copy()
    top = float(around.max())
    around[around == top] = 0.0
    return top / max(float(around.max()), 1e-12 * top)


def hot_pixels(stack: Any, noise: Noise, sharpest: float, limit: float = math.inf) -> NDArray[np.bool_]:
    """Return which pixels are hot: above all of their neighbours in most planes, whatever is in focus there.

    A pixel exceeds the median of its eight neighbours by more than eight standard errors in the mean over the planes;
    it is above that median in three quarters of the planes, and above all neighbours in 60 %, or exceeds all
    but one of them by half as much as the median: two hot pixels may be beside each other. A point of light is so
    in the planes near its focus alone. A line of light along the optical axis is so in all, but lights its
    neighbours, too: a hot pixel exceeds these by more than twice what the PSF lets a point exceed them.
    Values from the `limit` on, and NaN, are unknown.
    """
    planes = np.unique(np.linspace(0, len(stack) - 1, min(len(stack), _PLANES)).astype(int))
    hot = np.zeros(stack.shape[1:], dtype=bool)
    if len(planes) < _FEW:
        return hot
    for _ in range(_PASSES):
        found = _persistent(stack, planes, noise, limit, hot, _SHARPER * (sharpest - 1.0))
        if not found.any():
            break
        hot |= found
    return hot


def _persistent(
    stack: Any, planes: Array, noise: Noise, limit: float, hot: NDArray[np.bool_], steepest: float
) -> NDArray[np.bool_]:
    """Return hot pixels beside those that are known."""
    gain = np.asarray(1.0 if noise.white is None else noise.white)
    total, steps, slopes, seen, positive, above, but_one = (np.zeros(hot.shape) for _ in range(7))
    for plane in planes:
        given = np.asarray(stack[int(plane)], np.float64)
        known = np.isfinite(given) & (given < limit) & ~hot
        light = gain * (given - noise.offset)
        light = np.where(known, light, np.median(light[known]) if known.any() else 0.0)
        height, width = light.shape
        padded = np.pad(light, 2, mode="reflect")
        at = {(y, x): padded[2 + y : 2 + y + height, 2 + x : 2 + x + width] for y, x in _NEAR + _NEXT}
        near = np.sort([at[place] for place in _NEAR], axis=0)
        middle = 0.5 * (near[3] + near[4])
        # That of the median of eight is a fifth of that of one.
        noisy = np.sqrt(1.2 * (np.maximum(middle, 1.0) + np.asarray(noise.read) ** 2))
        # Medians, as one of these may be hot, too.
        sides, beyond = (np.median([at[place] for place in places], axis=0) for places in (_SIDES, _NEXT))
        for values, sums in (
            ((light - middle) / noisy, total), (light - sides, steps), (sides - beyond, slopes), (1.0, seen),
            (light > middle, positive), (light > near[-1], above), ((light - near[-2]) / noisy, but_one),
        ):  # fmt: skip
            sums += np.where(known, values, 0.0)
    sure = total > _PERSISTENT * np.sqrt(seen)
    often = (positive >= _MOSTLY * seen) & ((above > _ABOVE * seen) | (but_one > _BUT_ONE * total))
    return np.asarray(sure & often & (steps > steepest * slopes) & (seen >= _FEW))


def hot_voxels(stack: Any, noise: Noise, sharpest: float, limit: float = math.inf) -> Array:
    """Return plane, row and column of the hot voxels of a stack, shape ``(n, 3)``.

    A voxel is one where its excess over the median of the plane is more than twice `sharpest` times that of the
    brightest of its eight neighbours, and ten standard deviations of the noise besides. Values from the `limit` on,
    and NaN, are unknown.
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
        hot = (values < limit) & (values - base > _SHARPER * sharpest * np.maximum(near - base, 0.0) + sure)
        found.append(np.column_stack([np.full(np.count_nonzero(hot), plane), *np.nonzero(hot)]))
    return np.concatenate(found)


class LeftOut:
    """A stack some of whose voxels are unknown: NaN, or, of integers, not below `limit`.

    These are `voxels`, an array of their planes, rows and columns, and those of a `mask` of all planes, or of each.
    """

    def __init__(
        self, stack: Any, limit: float, *, voxels: Array | None = None, mask: NDArray[np.bool_] | None = None
    ) -> None:
        self.shape, self.dtype = stack.shape, stack.dtype
        self._stack, self._voxels = stack, np.zeros((0, 3), int) if voxels is None else voxels
        self._mask = np.broadcast_to(False if mask is None else mask, self.shape)
        whole = self.dtype.kind in "iu"
        self.limit = min(limit, float(np.iinfo(self.dtype).max)) if whole else limit
        self._unknown = self.dtype.type(self.limit if whole else math.nan)

    def __len__(self) -> int:
        return int(self.shape[0])

    def __getitem__(self, at: Any) -> Values:
        plane, *rest = at if isinstance(at, tuple) else (at,)
        part: Values = np.array(self._stack[(plane, *rest)])
        part[self._mask[(plane, *rest)]] = self._unknown
        here = self._voxels[self._voxels[:, 0] == plane][:, 1:]
        for axis, each in enumerate(rest):
            first, end, _ = each.indices(self.shape[1 + axis])
            here = here[(here[:, axis] >= first) & (here[:, axis] < end)]
            here[:, axis] -= first
        part[here[:, 0], here[:, 1]] = self._unknown
        return part
