"""Base class of microscope methods that interpolate azimuthal orders along the radius, to a tolerance."""

from __future__ import annotations

from abc import abstractmethod

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Images, Intensities, Wanted
from lommel.methods.layers.orders import Orders, Table
from lommel.methods.layers.refinement import BRIGHT_RING, LEAST, refine_until
from lommel.methods.method import RadialMethod, painted, storing
from lommel.methods.pixels.averaging import averaged_images
from lommel.optics.grid import Grid
from lommel.optics.layers.objective_pupil import ObjectivePupil

_LEAST = 1e-13
_BRIGHT = np.array([0.0, BRIGHT_RING])  # where something is bright in most planes


class ProvenMethod(RadialMethod[ObjectivePupil]):
    """A method for the pupils of objectives that knows orders of the azimuth; dataclasses of it have a `tol`."""

    pupils = "objective"
    apodized = True
    nonradial = True
    tol: float

    @abstractmethod
    def _orders(self, pupil: ObjectivePupil, v: Array, asked: float) -> Orders:
        """Return the light at rising v, to about an accuracy."""

    def _ceiling(self, pupil: ObjectivePupil) -> float:
        """Return what the light is at most, and the integral of the modulus of its transfer function."""
        return 1.0

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return the reason where there are aberrations."""
        return "supports no aberrations on top of those of layers" if pupil.aberrated else None

    def profile(self, pupil: ObjectivePupil, v: Array) -> Intensities:
        """Return the mean over all azimuths at rising v; where the light is radial, all that there is of it."""
        at, where = np.unique(np.append(v, _BRIGHT), return_inverse=True)

        def made_of(asked: float) -> tuple[Array, Array]:
            found = self._orders(pupil, at, asked)
            return found.mean, found.error

        made = refine_until(made_of, self.tol, start=0.1 * self.tol, floor=_LEAST, named=self.tol)
        return made._replace(values=made.values[:, where[: v.size]])

    def intensity(self, pupil: ObjectivePupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return I at the distinct radii of `grid`, or on its pixels where these share none."""
        if self.along_radius(pupil) is not None:
            return super().intensity(pupil, grid, threads)
        return self.images(pupil, grid, Wanted(threads=threads)).intensities

    def images(self, pupil: ObjectivePupil, grid: Grid, wanted: Wanted) -> Images:
        """Return the images of the flattened stack; see :meth:`lommel.Method.images`."""
        if self.along_radius(pupil) is not None or wanted.terms or wanted.powers:
            return super().images(pupil, grid, wanted)
        if not grid.integrate:
            return self._samples(pupil, grid, self.tol, wanted)
        band = self.stretch(pupil), self._ceiling(pupil)
        return averaged_images(self._samples, pupil, grid, self.tol, wanted, band)

    def _samples(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Images:
        """Return I at the centres of pixels."""
        grid.require_one_axis()
        x, y = pupil.v(grid.x), pupil.v(grid.y)[:, None]
        radius, turn = np.hypot(x, y).ravel(), np.exp(1j * np.arctan2(y, x)).ravel()
        faster, ceiling = self.stretch(pupil), self._ceiling(pupil)
        # What is divided by its own largest value is off by twice as much, and by nothing over the peak elsewhere.
        alone = wanted.scale is None
        aim = (0.48 if alone else 1.0) * (max(tol, LEAST) - 1.1 * storing(wanted.dtype))
        bright = _BRIGHT[:0] if alone else _BRIGHT
        latest: list[tuple[Table, Orders]] = []

        def made_of(asked: float) -> tuple[Array, Array]:
            table = Table.around(radius, 0.25 * asked / ceiling, faster)
            at, where = np.unique(np.append(table.radii, bright), return_inverse=True)
            found, count = self._orders(pupil, at, asked), where.size - bright.size
            known, beside = found.at(where[:count]), found.at(where[count:])
            latest[:] = [(table, known)]
            values = table.painted(known, radius, turn) if alone else np.append(known.samples, beside.samples, axis=1)
            return values, table.error(found) + 0.25 * asked

        made = refine_until(made_of, aim, start=0.03 * aim, floor=_LEAST * ceiling, named=self.tol)
        table, known = latest[0]
        pixels = made.values if alone else table.painted(known, radius, turn)
        values = pixels.reshape(-1, *grid.shape)
        return painted(made._replace(values=values), grid, wanted)._replace(peak=made.peak)
