"""Autocorrelation of pupils at the shifts that blur leaves, from the pupil function on square cells.

Cells carry the mean of the pupil function over their area. The autocorrelation of these is that of the pupil,
smoothed by two squares of the size of a cell, which their second moment corrects; at 0 it is known. Between cells
it is interpolated by cubic splines. It is off by some 1e-6, more where a shift by less than a cell opens or closes a
gap; images, which average it, by about 1e-6 of all light.

Apertures on square cells: the area of each that is clear, in a second for any number of parts.
Lines of constant y cross ellipses and convex polygons in one interval each. Two Gauss nodes between edges of cells,
corners and, where they are flat, the places at which edges enter the next cell are exact for straight edges, but
where these cross one another within a cell.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.measures.aperture_means import gradient
from lommel.measures.overlap import cells
from lommel.optics.aperture.mask import cell_centers
from lommel.optics.aperture.opening import Opening
from lommel.optics.aperture.shapes import Listed, listed
from lommel.optics.pupil import Pupil

_GAUSS = 0.5 / math.sqrt(3.0)


def phased_cells(opening: Opening, side: int) -> NDArray[np.complex128]:
    """Return the means of ``exp(i phase)`` of the segments over `side` x `side` cells of [-1, 1] x [-1, 1]."""
    found = np.zeros((side, side), dtype=np.complex128)
    at = cell_centers(side)
    for region, phase in zip(opening.regions, opening.phases, strict=True):
        rows, columns, clear = _cells(listed(region), side)
        if phase.any():
            x, y = at[columns], at[rows, None]
            mean = float(np.prod(np.sinc(phase[1:] / (math.pi * side))))
            found[rows, columns] += clear * (mean * np.exp(1j * (phase[0] + phase[1] * x + phase[2] * y)))
        else:
            found[rows, columns] += clear
    return found


def _cells(region: Listed, side: int) -> tuple[slice, slice, Array]:
    """Return the rows and columns of cells that hold a region, and the part of each that it covers."""
    y, weight, row = _clear_lines(region, side)
    low, high = np.array([_crossed(region, k, y) for k in range(len(region.polygons))]).transpose(1, 0, 2)
    ends = np.sort(np.concatenate([low, high]), axis=0)
    middle = 0.5 * (ends[1:] + ends[:-1])
    inside = [(a < middle) & (middle < b) for a, b in zip(low, high, strict=True)]
    clear = region.combined(inside, np.logical_and, np.logical_or, lambda a, b: a & ~b)
    clear &= ends[1:] > ends[:-1]
    piece, line = np.nonzero(clear)
    if not line.size:
        return slice(0, 0), slice(0, 0), np.zeros((0, 0))
    # Where light begins counts from there on, where it ends no more.
    place = np.concatenate([ends[piece, line], ends[piece + 1, line]])
    place = np.clip(0.5 * side * (place + 1.0), 0.0, float(side))
    change = np.concatenate([weight[line], -weight[line]])
    first = np.floor(place).astype(np.int64)
    top, left = int(row[line].min()), int(first.min())
    shape = int(row[line].max()) + 1 - top, int(first.max()) + 2 - left
    at = np.tile(row[line] - top, 2) * shape[1] + first - left
    part = place - first
    steps = np.bincount(at, change * (1.0 - part), math.prod(shape)) + np.bincount(
        at + 1, change * part, math.prod(shape)
    )
    covered = np.cumsum(steps.reshape(shape), axis=1)[:, : side - left]
    return slice(top, top + shape[0]), slice(left, left + covered.shape[1]), covered


def _clear_lines(region: Listed, side: int) -> tuple[Array, Array, NDArray[np.int64]]:
    """Return lines of constant y, their weights over the side of a cell, and the rows of cells they are in."""
    cell, ellipses, events, spans = 2.0 / side, iter(region.ellipses), [], []
    for corners in region.polygons:
        if len(corners):
            events += [
                np.linspace(y0, y1, 2 + int(abs(x1 - x0) / cell) if y0 != y1 else 1)
                for (x0, y0), (x1, y1) in zip(corners, np.roll(corners, -1, axis=0), strict=True)
            ]
            spans.append((corners[:, 1].min(), corners[:, 1].max()))
        else:
            _, y, a, b, angle = next(ellipses)
            tall = math.hypot(a * math.sin(angle), b * math.cos(angle))
            across = math.hypot(a * math.cos(angle), b * math.sin(angle))
            height = tall * np.sqrt(1.0 - np.linspace(0.0, 0.8, 2 + int(across / cell)) ** 2)
            events += [y + height, y - height]
            spans.append((y - tall, y + tall))
    # Between which y the region lies.
    low, high = region.combined(
        spans,
        lambda a, b: (max(a[0], b[0]), min(a[1], b[1])),
        lambda a, b: (min(a[0], b[0]), max(a[1], b[1])),
        lambda a, _: a,
    )
    edges = np.unique(
        np.clip(np.concatenate([cell * np.arange(side + 1.0) - 1.0, *events]), max(low, -1.0), min(high, 1.0))
    )
    middle, wide = 0.5 * (edges[1:] + edges[:-1]), np.diff(edges)
    row = np.minimum((0.5 * side * (middle + 1.0)).astype(np.int64), side - 1)
    lines = np.concatenate([middle - _GAUSS * wide, middle + _GAUSS * wide])
    return lines, np.tile(0.25 * side * wide, 2), np.tile(row, 2)


def _crossed(region: Listed, part: int, y: Array) -> tuple[Array, Array]:
    """Return where lines enter a part and leave it, both 2 where they miss it."""
    corners = region.polygons[part]
    if len(corners):
        (x0, y0), (x1, y1) = corners.T[:, :, None], np.roll(corners, -1, axis=0).T[:, :, None]
        meets = (np.minimum(y0, y1) <= y) & (y < np.maximum(y0, y1))
        x = x0 + (x1 - x0) * np.divide(y - y0, y1 - y0, out=np.zeros(meets.shape), where=meets)
        low, high = np.where(meets, x, np.inf).min(axis=0), np.where(meets, x, -np.inf).max(axis=0)
        return np.where(low < high, low, 2.0), np.where(low < high, high, 2.0)
    x, middle, a, b, angle = region.ellipses[sum(len(at) == 0 for at in region.polygons[:part])]
    cos, sin = math.cos(angle), math.sin(angle)
    tall = math.hypot(a * sin, b * cos)
    up = y - middle
    half = a * b * np.sqrt(np.maximum(tall**2 - up**2, 0.0)) / tall**2
    center = x + up * (a * a - b * b) * sin * cos / tall**2
    return np.where(half > 0.0, center - half, 2.0), np.where(half > 0.0, center + half, 2.0)


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
