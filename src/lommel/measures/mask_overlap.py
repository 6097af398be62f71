r"""Autocorrelation of pupils with a mask: sums over cells.

The pupil function is constant on the square cells of a mask, where the wavefront counts in the middles. The overlap
of two cells is linear in either coordinate of their shift, and so the autocorrelation is, between shifts d by whole
cells, the bilinear interpolation of ``A(d) = sum_k P_k conj(P_(k + d))``: exactly, whatever the mask.

The image of samples is not that of square cells, but one period of ``sum_d A(d) exp(2 pi i d.r / side)``. At whole
cells its transform is the same.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.base.cached import cached_property
from lommel.methods.matrix_fourier import pupil_functions
from lommel.optics.aperture.mask import cell_centers
from lommel.optics.pupil import Pupil

_MAX_TABLE = 2048
"""Cells along a side of which all shifts are kept, in 270 MB."""


class Cells:
    """The pupil function on the cells of a mask, of all light 1."""

    def __init__(self, field: NDArray[np.complex128]) -> None:
        self.field = field / np.linalg.norm(field)

    @cached_property
    def _table(self) -> NDArray[np.complex128]:
        from scipy import fft

        spectrum = fft.fft2(self.field, (2 * len(self.field), 2 * len(self.field)))
        return np.asarray(fft.ifft2(spectrum.real**2 + spectrum.imag**2).conj())

    def at(self, across: NDArray[np.int64], down: NDArray[np.int64]) -> NDArray[np.complex128]:
        """Return the autocorrelation at shifts by whole cells along columns and rows."""
        side = len(self.field)
        # At a side and beyond no cells overlap.
        x, y = (np.clip(shift, -side, side) for shift in (across, down))
        if side <= _MAX_TABLE:
            return np.asarray(self._table[y, x])
        shifts, where = np.unique(np.stack([x, y]), axis=1, return_inverse=True)
        return np.array([self._shifted(*shift) for shift in shifts.T.tolist()])[where.reshape(-1)]

    def _shifted(self, x: int, y: int) -> complex:
        """Return that at one shift, by a sum."""
        side = len(self.field)
        first, second = (
            self.field[max(b, 0) : side + min(b, 0), max(a, 0) : side + min(a, 0)] for a, b in ((x, y), (-x, -y))
        )
        return complex(np.einsum("yx,yx->", first.conj(), second))

    def between(self, shift: Array) -> NDArray[np.complex128]:
        """Return the autocorrelation at shifts in cells, shape (points, 2)."""
        first = np.floor(np.clip(shift, -len(self.field), len(self.field)))
        (x, y), (column, row) = (shift - first).T, first.T.astype(np.int64)
        x, y = (np.clip(part, 0.0, 1.0) for part in (x, y))
        near, next_to = ((1.0 - x) * self.at(column, j) + x * self.at(column + 1, j) for j in (row, row + 1))
        return np.asarray((1.0 - y) * near + y * next_to)

    def centroid(self, *, squares: bool) -> Array:
        """Return the centroid (x, y) of the image in lambda*N, of all of it for `squares`, else of one period."""
        side = len(self.field)
        # The derivative of the autocorrelation at 0, or the integral of x over the period of each wave.
        d = np.arange(1, 2 if squares else side)
        weight = (np.ones(1) if squares else -((-1.0) ** d) * 2.0 / d) * (-0.5 * side / math.pi)
        zero = np.zeros_like(d)
        return np.array([weight @ self.at(d, zero).imag, weight @ self.at(zero, d).imag])


@lru_cache(maxsize=2)
def cells(pupil: Pupil) -> Cells:
    """Return the cells of a single pupil."""
    assert pupil.mask is not None
    side = pupil.mask.side
    (field,) = pupil_functions(pupil, cell_centers(side), 1.0 / side, "grey")
    return Cells(field)


def cells_of_stack(pupil: Pupil) -> list[Cells]:
    """Return the cells of each pupil of the flattened stack."""
    return [cells(pupil[index]) for index in np.ndindex(pupil.shape)] if pupil.shape else [cells(pupil)]


def of_mask(pupil: Pupil, f: Array) -> NDArray[np.complex128]:
    """Return the OTF at frequencies f over the cutoff, shape (points, 2), for the flattened stack."""
    assert pupil.mask is not None
    return np.stack([one.between(pupil.mask.side * f) for one in cells_of_stack(pupil)])
