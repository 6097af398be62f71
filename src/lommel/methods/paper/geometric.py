"""Geometrical optics: ray densities of blur disks and caustics."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.answers import Intensities
from lommel.methods.method import Method
from lommel.optics.aperture.shapes import disk_overlap
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil, ray_height

_MAX_CELLS = 2**23  # largest number of cells, intervals of rho that divide the aperture


@dataclass(frozen=True)
class Geometric(Method[Pupil]):
    r"""Geometrical optics: ray density averaged over each pixel, conserving energy exactly.

    Supports uniformly illuminated circular and annular apertures with radially symmetric aberrations. A ray through
    rho meets the sensor at ``v = abs(dPhi/drho)``, Phi being the phase: defocus C_d causes a uniform disk of radius
    ``4 abs(C_d)``, spherical aberration causes caustics. Diffraction is neglected. If the blur is many lambda*N
    wide, the result approximates local averages of the PSF, but not its point values.

    Parameters
    ----------
    rings : int, default 8
        Number of concentric rings of the image per pixel, 1 to 64. The light of a ring is spread evenly over the
        ring, and each pixel receives the fraction of the ring that it covers.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.
    """

    sampling = "pixel"
    rings: int = 8

    def __post_init__(self) -> None:
        object.__setattr__(self, "rings", validation.integer("rings", self.rings, least=1, most=64))

    def intensity(self, pupil: Pupil, grid: Grid, threads: int) -> Intensities:
        """Return I averaged over pixels, shape ``(n, height, width)``."""
        grid.require_one_axis()
        step = grid.step(pupil)
        # A centred image has four equal quadrants.
        rows = np.arange(grid.height // 2 + 1.0) if grid.centered else grid.y / grid.side
        columns = np.arange(grid.width // 2 + 1.0) if grid.centered else grid.x / grid.side
        corner = math.hypot(np.abs(rows).max() + 0.5, np.abs(columns).max() + 0.5)
        count = math.ceil(corner * self.rings) + 1
        stack = pupil.radial_terms()
        energies = np.stack([self._ring_energies(c, pupil.obscuration, step / self.rings, count) for c in stack])
        edges = np.arange(count + 1) / self.rings
        density = energies / (math.pi * (edges[1:] ** 2 - edges[:-1] ** 2))

        # The nearest point of each pixel determines the first ring that can overlap the pixel.
        nearest = np.hypot(*(np.maximum(np.abs(part) - 0.5, 0) for part in np.meshgrid(rows, columns, indexing="ij")))
        first_ring = np.floor(nearest * self.rings).astype(np.int64)
        pixel = (columns - 0.5, columns + 0.5, (rows - 0.5)[:, None], (rows + 0.5)[:, None])
        image = np.zeros((stack.shape[0], rows.size, columns.size))
        covered = disk_overlap(first_ring / self.rings, *pixel)
        # The diagonal of a pixel, sqrt(2), limits the number of rings that overlap it.
        for k in range(math.ceil(math.sqrt(2.0) * self.rings) + 1):
            ring = np.minimum(first_ring + k, count - 1)
            covered_next = disk_overlap((first_ring + k + 1) / self.rings, *pixel)
            image += density[:, ring] * np.maximum(covered_next - covered, 0.0)
            covered = covered_next
        if grid.centered:
            image = grid.unfold(image)
        # Convert light per pixel area to I: the integral of I over the plane, in v, is 4 pi pupil.area.
        return Intensities(image * (4.0 * math.pi * pupil.area / step**2), None)

    def _ring_energies(self, terms: Array, obscuration: float, width: float, count: int) -> Array:
        """Return the fraction of all light in each of `count` rings of `width` in v."""
        rho = np.linspace(obscuration, 1.0, 4097)
        height = ray_height(terms[None], rho)[0]
        steepest = float(np.abs(np.diff(height)).max()) / (rho[1] - rho[0])
        # The cells are so small that the rays of a cell fall into at most two neighbouring rings (5 % margin).
        cells = max(4096, math.ceil(1.05 * steepest * (1.0 - obscuration) / width))
        if cells > _MAX_CELLS:
            raise ValueError(
                f"Geometric would trace {cells:.3g} rays for a blur this large on pixels this small, "
                f"more than the limit of {_MAX_CELLS}; use larger pixels or fewer rings"
            )
        rho = np.linspace(obscuration, 1.0, cells + 1)
        height = np.abs(ray_height(terms[None], rho)[0]) / width
        energy = np.diff(rho**2) / (1.0 - obscuration**2)
        low, high = np.minimum(height[1:], height[:-1]), np.maximum(height[1:], height[:-1])
        ring = np.floor(low)
        # Energy of a cell outside the ring of its lowest ray, if spread evenly over the heights of its rays.
        extent = high - low
        excess = np.maximum(high - ring - 1.0, 0.0)
        outside = energy * np.minimum(excess / np.where(extent > 0, extent, 1.0), 1.0)
        index = np.minimum(ring, count).astype(np.int64)
        total = np.bincount(index, energy - outside, count + 2) + np.bincount(index + 1, outside, count + 2)
        return np.asarray(total[:count])
