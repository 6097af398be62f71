r"""Intensities as azimuthal Fourier orders at given radii: of an objective, of products, and on pixels.

The intensity of any emitter is ``sum_m F_m(r) exp(i m phi)``, m from -2 to 2 and ``F_-m = conj(F_m)``; products of
several have a few more orders. Radially symmetric intensities have the order 0 alone.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.engine import layered_profiles
from lommel.methods.layers.debye_wolf import harmonics
from lommel.methods.layers.disc_means import HALF, Values, between, growth, table_step
from lommel.methods.layers.refinement import LEAST
from lommel.methods.layers.stratified import Stratified, _Accuracy, _settled, layered
from lommel.optics.layers.objective_pupil import ObjectivePupil

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

    def attempt(accuracy: _Accuracy) -> tuple[tuple[Array, Array], float]:
        values, off = layered_profiles(layered(pupil, float(v[-1]), accuracy.field), v)
        top = values[:, 0].max(axis=1) - off
        relative = np.divide(off, top, out=np.full(top.shape, np.inf), where=top > 0.0)
        return (values, off), float(relative.max())

    made = None
    if pupil.light.model.orders[0] == 0:
        made = _settled(attempt, pupil, max(asked, _FINEST * tol, Stratified.least_tol))
    if made is None:
        found = harmonics(pupil, v, LEAST)
        made = np.moveaxis(found.values, 0, 1), found.error
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
