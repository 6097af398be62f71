"""Maximum projections of a stack before and after it is restored, and of what is left of it."""

from __future__ import annotations

from threading import Lock
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Values
from lommel.imaging.linear import Part, PlaneOperator
from lommel.imaging.poisson_counts import PoissonCounts


class Projections(NamedTuple):
    """Projections along z, shape (height, width), and along y, shape (planes, width), of float32.

    Attributes
    ----------
    recorded, restored : (ndarray, ndarray)
        Maxima, in the unit of the recording without its offset.
    residual : (ndarray, ndarray)
        Recording less model over the noise, summed over the square root of the number of voxels: of unit variance
        where PSF and noise are right.
    """

    recorded: tuple[Values, Values]
    restored: tuple[Values, Values]
    residual: tuple[Values, Values]


def blank(shape: tuple[int, int, int]) -> Projections:
    """Return projections in which nothing is known: NaN."""
    planes, height, width = shape
    recorded, restored, residual = (
        (np.full((height, width), np.nan, np.float32), np.full((planes, width), np.nan, np.float32)) for _ in range(3)
    )
    return Projections(recorded, restored, residual)


class Projecting:
    """Projections of a stack whose chunks are restored one after another."""

    def __init__(self, shape: tuple[int, int, int]) -> None:
        self._made, self._known = blank(shape), np.zeros((shape[0], shape[2]), np.float32)

    def add(
        self,
        rows: slice,
        columns: slice,
        corner: tuple[int, int],
        blur: PlaneOperator,
        counted: PoissonCounts,
        light: Part,
        restored: Values,
    ) -> None:
        """Add a chunk: these rows and columns of the stack; those of the blur begin at the corner."""
        down, across = (at.start - first for at, first in zip((rows, columns), corner, strict=True))
        height, width = rows.stop - rows.start, columns.stop - columns.start
        sums, known, most = (np.zeros((height, width), np.float32) for _ in range(3))
        along = np.zeros((3, len(restored), width), np.float32)
        lock = Lock()

        def compared(plane: int, y: slice, x: slice, model: Values) -> None:
            counts, off, share = counted.residuals(plane, y, x, model)
            top, left = y.start - down, x.start - across
            inner = np.s_[max(-top, 0) : max(height - top, 0), max(-left, 0) : max(width - left, 0)]
            counts, off, share = counts[inner], off[inner], share[inner]
            at = np.s_[max(top, 0) : max(top, 0) + len(off), max(left, 0) : max(left, 0) + off.shape[1]]
            # Planes are compared by several threads.
            with lock:
                sums[at] += off
                known[at] += share
                np.maximum(most[at], counts, out=most[at])
                part = along[:, plane, at[1]]
                part[0] += off.sum(axis=0)
                part[1] += share.sum(axis=0)
                np.maximum(part[2], counts.max(axis=0, initial=0.0), out=part[2])

        blur.forward(light, compared)
        recorded, after, residual = self._made
        recorded[0][rows, columns] = np.where(known > 0.0, most, np.float32(np.nan))
        after[0][rows, columns] = restored.max(axis=0)
        residual[0][rows, columns] = _over_root(sums, known)
        # Chunks above and below have a part of each voxel of the projection along y.
        before = self._known[:, columns]
        # Back to sums: residuals are stored over the root of their number.
        off = along[0] + np.nan_to_num(residual[1][:, columns]) * np.sqrt(before)
        self._known[:, columns] = before + along[1]
        residual[1][:, columns] = _over_root(off, self._known[:, columns])
        highest = np.where(along[1] > 0.0, along[2], np.float32(np.nan))
        for whole, part in ((recorded, highest), (after, restored.max(axis=1))):
            whole[1][:, columns] = np.fmax(whole[1][:, columns], part)

    def made(self, *, turned: bool) -> Projections:
        """Return the projections, in the order of the recording if the planes were turned."""
        if not turned:
            return self._made
        return Projections(*((each[0], each[1][::-1]) for each in self._made))


def _over_root(sums: Values, known: Values) -> Values:
    """Return sums over the square root of the number of voxels, NaN where there are none."""
    return np.where(known > 0.0, sums / np.sqrt(np.maximum(known, 1.0)), np.float32(np.nan))
