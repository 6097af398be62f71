"""Autocorrelation of pupils at the shifts that blur leaves, from the pupil function on square cells.

Cells carry the mean of the pupil function over their area. The autocorrelation of these is that of the pupil,
smoothed by two squares of the size of a cell, which their second moment corrects; at 0 it is known. Between cells
it is interpolated by cubic splines. It is off by some 1e-6, more where a shift by less than a cell opens or closes a
gap; images, which average it, by about 1e-6 of all light.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.measures.aperture_means import gradient
from lommel.measures.mask_overlap import cells
from lommel.optics.aperture.mask import cell_centers
from lommel.optics.aperture.raster import phased_cells
from lommel.optics.pupil import Pupil

_FINE = 32.0
"""Cells that the shifts reach over, at least."""


class SmallShifts(NamedTuple):
    """Cubic splines through the OTF of a single pupil at shifts by whole cells."""

    splines: tuple[Array, ...]  # of the real part and, if there is any, of the imaginary one
    side: int
    most: int

    @classmethod
    def of(cls, pupil: Pupil, end: float) -> SmallShifts:
        """Return those for frequencies up to `end` of the cutoff."""
        side = int(np.clip(2 ** math.ceil(math.log2(_FINE / end)), 1024, 4096))
        return _small_shifts(pupil, side, min(math.ceil(end * side) + 4, side))

    def at(self, fx: Array, fy: Array) -> NDArray[np.complex128]:
        """Return the OTF at frequencies over the cutoff."""
        from scipy.ndimage import map_coordinates

        places = [self.side * f + self.most for f in (fy, fx)]
        parts = [map_coordinates(spline, places, order=3, prefilter=False) for spline in self.splines]
        return np.asarray(parts[0] if len(parts) == 1 else parts[0] + 1j * parts[1], dtype=np.complex128)


@lru_cache(maxsize=4)
def _small_shifts(pupil: Pupil, side: int, most: int) -> SmallShifts:
    from scipy import fft
    from scipy.ndimage import spline_filter

    field = phased_cells(pupil.opening, side)
    rows, columns = np.nonzero(field)
    at = cell_centers(side)
    x, y = at[columns], at[rows]
    rho = np.hypot(x, y)
    light = np.ones(rho.size) if pupil.illumination.uniform else pupil.illumination.at(rho * rho)
    if pupil.wavefront.flat:
        field[rows, columns] *= light
    else:
        theta = np.arctan2(y, x)
        # Means over cells, along which the phase turns.
        light *= np.prod(np.sinc(gradient(pupil.wavefront, rho, theta)[0] / (math.pi * side)), axis=0)
        field[rows, columns] *= light * np.exp(1j * pupil.wavefront.phase(rho, theta))
    size = fft.next_fast_len(side + most + 1)
    spectrum = fft.fft2(field, (size, size))
    near = np.arange(-most - 1, most + 2)
    raw = fft.ifft2(spectrum.real**2 + spectrum.imag**2)[np.ix_(near, near)].conj()
    raw *= 4.0 / (math.pi * side**2 * pupil.transmission)
    found = raw[1:-1, 1:-1]
    # Means over cells, of both pupils, are of the variance 1/6 along each axis.
    around = raw[:-2, 1:-1] + raw[2:, 1:-1] + raw[1:-1, :-2] + raw[1:-1, 2:]
    found = found - (around - 4.0 * found) / 12.0
    # Samples of the cone 1 - c d about 0 add up to 0.229 c too much: sum of 1 / (4 pi^2 k^3) over a lattice.
    ring = found[most - 2 : most + 3, most - 2 : most + 3].real
    slope = float(np.mean([1.0 - ring[0, 2], 1.0 - ring[4, 2], 1.0 - ring[2, 0], 1.0 - ring[2, 4]])) / 2.0
    found[most, most] = 1.0 - 0.229 * slope
    parts = (found.real, found.imag) if np.abs(found.imag).max() > 1e-12 else (found.real,)
    return SmallShifts(tuple(spline_filter(part, order=3) for part in parts), side, most)


def transfer(pupil: Pupil, end: float, fx: Array, fy: Array) -> NDArray[np.complex128]:
    """Return the OTF of a single pupil at frequencies over the cutoff, all below `end`."""
    if pupil.mask is None:
        return SmallShifts.of(pupil, end).at(fx, fy)
    shifts = pupil.mask.side * np.stack([fx.ravel(), fy.ravel()], axis=-1)
    return cells(pupil).between(shifts).reshape(fx.shape)
