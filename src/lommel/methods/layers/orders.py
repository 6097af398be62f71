r"""Intensities as azimuthal Fourier orders at given radii, and the base class of methods that interpolate these.

The intensity of any emitter is ``sum_m F_m(r) exp(i m phi)``, m from -2 to 2 and ``F_-m = conj(F_m)``; products of
several have a few more orders. Radially symmetric intensities have the order 0 alone.
"""

from __future__ import annotations

from abc import abstractmethod
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Images, Intensities, Wanted
from lommel.methods.layers.debye_wolf import BRIGHT_RING, LEAST, LayeredMethod, harmonics, refine_until
from lommel.methods.layers.disc_means import HALF, Values, between, growth, table_step
from lommel.methods.layers.samples import Samples
from lommel.methods.layers.stratified import Stratified, profiles
from lommel.methods.method import RadialMethod, painted, storing
from lommel.methods.pixels.averaging import averaged_images
from lommel.optics.grid import Grid
from lommel.optics.layers.objective_pupil import ObjectivePupil

_LEAST = 1e-13
_BRIGHT = np.array([0.0, BRIGHT_RING])  # where something is bright in most planes
_FINEST = 0.05
_ROUNDING = 2.0**-50
_AROUND = np.linspace(0.0, 2.0 * np.pi, 8, endpoint=False)
_SOME = 512  # radii
_PIXELS = 2**21  # of all planes and orders, at once


class Orders(NamedTuple):
    """Light at radii as orders of the azimuth."""

    values: Values  # (n, 2 M + 1, radii), F_-M first; complex, or real where M is 0
    error: Array  # (n,), bound on the sum at these radii and any azimuth

    @property
    def most(self) -> Array:
        """What the sum is at most, of each plane."""
        return np.asarray(np.abs(self.values).sum(axis=1).max(axis=1))

    @property
    def mean(self) -> Array:
        """The mean over all azimuths, shape (n, radii); nowhere negative."""
        return np.asarray(np.maximum(self._upper[:, 0].real, 0.0))

    @property
    def samples(self) -> Array:
        """The sum at some azimuths and radii, shape (n, places)."""
        some = self._upper[..., :: max(1, self.values.shape[2] // _SOME), None]
        return _summed(some, np.exp(1j * _AROUND)).reshape(len(self.values), -1)

    @property
    def _upper(self) -> Values:
        """The orders 0 to M, which tell all."""
        return self.values[:, self.values.shape[1] // 2 :]

    def at(self, which: NDArray[np.int64]) -> Orders:
        """Return it at some of the radii."""
        return Orders(self.values[:, :, which], self.error)

    def times(self, factor: Array) -> Orders:
        """Return it times what is at least 0, of each plane."""
        return Orders(self.values * factor[:, None, None], self.error * factor)


def highest(pupil: ObjectivePupil) -> int:
    """Return the highest order of the light of a pupil."""
    return max(h.order for h in pupil.light.harmonics)


def light(pupil: ObjectivePupil, v: Array, asked: float, tol: float) -> Orders:
    """Return the light of a pupil at rising v.

    Its error is `asked` of its own peak, or 0.05 `tol`, which does where errors relate to that peak as those that are
    asked about do, and which double precision can hold.
    """
    made = profiles(pupil, v, max(asked, _FINEST * tol, Stratified.least_tol))
    if made is None:
        values, off = harmonics(pupil, v, LEAST)
        made = np.moveaxis(values, 0, 1), off
    values, off = made
    if (most := highest(pupil)) == 0:
        return Orders(values, off)
    orders = np.zeros((len(values), 2 * most + 1, v.size), np.complex128)
    for h, each in zip(pupil.light.harmonics, np.moveaxis(values, 1, 0), strict=True):
        if h.order:
            orders[:, most + h.order] += 0.5 * (h.cosine - 1j * h.sine) * each
        else:
            orders[:, most] = each
    orders[:, :most] = orders[:, :most:-1].conj()
    return Orders(orders, off + _ROUNDING * np.abs(orders).sum(axis=1).max(axis=1))


def product(one: Orders, other: Orders) -> Orders:
    """Return the product of the light of the same planes at the same radii."""
    first, second = one.values.shape[1], other.values.shape[1]
    kind = np.result_type(one.values, other.values)
    values = np.zeros((len(one.values), first + second - 1, one.values.shape[2]), kind)
    for j in range(first):
        values[:, j : j + second] += one.values[:, j, None] * other.values
    sizes = one.most, other.most
    error = one.error * sizes[1] + other.error * (sizes[0] + one.error) + _ROUNDING * sizes[0] * sizes[1]
    return Orders(values, error)


def _summed(values: Values, turn: NDArray[np.complex128]) -> Array:
    """Return the sum of orders from 0 up, the second axis of `values`, and of their conjugates, by ``exp(i phi)``."""
    total, power = values[:, 0].real * np.ones(turn.shape), np.ones_like(turn)
    for m in range(1, values.shape[1]):
        power = power * turn
        total = total + 2.0 * (values[:, m] * power).real
    return np.asarray(total)


class Table(NamedTuple):
    """Even radii, from which light at pixels is interpolated by polynomials between twelve of them."""

    places: NDArray[np.int64]  # in units of step; negative ones are beyond the axis
    step: float  # in v

    @classmethod
    def around(cls, radius: Array, error: float, faster: float) -> Table:
        """Return what pixels at a `radius` each need, of light of the type ``2 faster``, to err by `error`."""
        step = table_step(error) / faster
        first, last = (int(np.floor(at / step)) for at in (radius.min(), radius.max()))
        return cls(np.arange(first + 1 - HALF, last + HALF + 1), step)

    @property
    def radii(self) -> Array:
        """Where light is to be known: rising."""
        return self.step * np.unique(np.abs(self.places))

    def error(self, found: Orders) -> Array:
        """Return what pixels are off by at most, ``(n,)``, beside the error of :meth:`around`."""
        return growth() * (found.error + 8.0 * _ROUNDING * found.most)

    def painted(self, found: Orders, radius: Array, turn: NDArray[np.complex128]) -> Array:
        """Return light known at :attr:`radii` on pixels, ``(n, pixels)``; `turn` is ``exp(i phi)`` of these."""
        from scipy.sparse import csr_array

        values = found._upper
        beyond = np.where(self.places < 0, -1.0, 1.0)
        row = np.searchsorted(np.unique(np.abs(self.places)), np.abs(self.places))
        known = np.stack([values[:, m][:, row] * beyond**m for m in range(values.shape[1])], axis=1)
        out = np.empty((len(values), radius.size))
        each = max(1, _PIXELS // (known.shape[0] * known.shape[1]))
        for part in (slice(k, k + each) for k in range(0, radius.size, each)):
            at, where = np.unique(radius[part], return_inverse=True)
            first, weights = between(at / self.step)
            columns = (first - self.places[0])[:, None] + np.arange(2 * HALF)
            ends = np.arange(0, columns.size + 1, 2 * HALF)
            matrix = csr_array((weights.ravel(), columns.ravel(), ends), shape=(at.size, self.places.size))
            lines = (matrix @ known.reshape(-1, self.places.size).T).T.reshape(*known.shape[:2], at.size)
            out[:, part] = _summed(lines[..., where], turn[part])
        return np.maximum(out, 0.0, out=out)


class ProvenMethod(LayeredMethod, RadialMethod[ObjectivePupil]):
    """A method for the pupils of objectives that knows orders of the azimuth; dataclasses of it have a `tol`."""

    @abstractmethod
    def _orders(self, pupil: ObjectivePupil, v: Array, asked: float) -> Orders:
        """Return the light at rising v, to about an accuracy."""

    @abstractmethod
    def _pixels(self, pupil: ObjectivePupil, grid: Grid, asked: float, threads: int) -> Samples:
        """Return the light of pupils with aberrations at the centres of pixels, to about an accuracy."""

    def _aberrated(self, pupil: ObjectivePupil) -> bool:
        """Return whether any of the light has aberrations."""
        return pupil.aberrated

    def _ceiling(self, pupil: ObjectivePupil) -> float:
        """Return what the light is at most, and the integral of the modulus of its transfer function."""
        return 1.0

    def profile(self, pupil: ObjectivePupil, v: Array) -> Intensities:
        """Return the mean over all azimuths at rising v; where the light is radial, all that there is of it."""
        if self._aberrated(pupil):
            raise ValueError(
                f"{type(self).__name__} has no profiles of light with aberrations; compute an image, and measure that"
            )
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
        if self._aberrated(pupil):
            return self._by_pixels(pupil, grid, tol, wanted)
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

    def _by_pixels(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Images:
        """Return the same where light has aberrations, relative to the largest value in the window."""
        aim = (0.48 if wanted.scale is None else 1.0) * (max(tol, LEAST) - 1.1 * storing(wanted.dtype))

        def made_of(asked: float) -> tuple[Array, Array]:
            found = self._pixels(pupil, grid, asked, wanted.threads)
            return np.maximum(found.values, 0.0), found.error

        return painted(refine_until(made_of, aim, start=0.1 * aim, floor=_LEAST, named=self.tol), grid, wanted)
