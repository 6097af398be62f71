"""Scanning microscopes and beads: intensities as azimuthal Fourier orders at given radii, interpolated between these.

The intensity of any emitter is ``sum_m F_m(r) exp(i m phi)``, m from -2 to 2 and ``F_-m = conj(F_m)``; products of
several have a few more orders. Radially symmetric intensities have the order 0 alone.
"""

from __future__ import annotations

import math
from abc import abstractmethod
from dataclasses import dataclass, field, replace
from typing import NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.answers import Images, Intensities, Wanted
from lommel.methods.averaging import averaged_images
from lommel.methods.layers.debye_wolf import BRIGHT_RING, LEAST, LayeredMethod, harmonics, refine_until
from lommel.methods.layers.samples import (
    ETA,
    HALF,
    SampledLight,
    Values,
    between,
    disc_filter,
    disc_means,
    gauss_error,
    growth,
    light_samples,
    table_step,
)
from lommel.methods.layers.stratified import Stratified, profiles
from lommel.methods.method import RadialMethod, storing, to_images
from lommel.optics.grid import Grid
from lommel.optics.layers import debye
from lommel.optics.layers.emitter import Absorbed, Beam, Dipole
from lommel.optics.layers.objective_pupil import ObjectivePupil

_LEAST = 1e-13
_BRIGHT = np.array([0.0, BRIGHT_RING])  # radii at which most planes are bright
_FINEST = 0.05
_ROUNDING = 2.0**-50
_AROUND = np.linspace(0.0, 2.0 * np.pi, 8, endpoint=False)
_SOME = 512  # radii at which the largest value is searched
_PIXELS = 2**21  # values of all planes and orders, at once


class Orders(NamedTuple):
    """Light at radii, as orders of the azimuth."""

    values: Values  # (n, 2 M + 1, radii), F_-M first; complex, or real where M is 0
    error: Array  # (n,), bound on the sum at these radii and any azimuth

    @property
    def most(self) -> Array:
        """Bound on the sum of the orders, for each plane."""
        return np.asarray(np.abs(self.values).sum(axis=1).max(axis=1))

    @property
    def mean(self) -> Array:
        """Mean over all azimuths, shape (n, radii), not negative."""
        return np.asarray(np.maximum(self._upper[:, 0].real, 0.0))

    @property
    def samples(self) -> Array:
        """The sum at some azimuths and radii, shape (n, places)."""
        some = self._upper[..., :: max(1, self.values.shape[2] // _SOME), None]
        return _summed(some, np.exp(1j * _AROUND)).reshape(len(self.values), -1)

    @property
    def _upper(self) -> Values:
        """The orders 0 to M, of which the others are conjugates."""
        return self.values[:, self.values.shape[1] // 2 :]

    def at(self, which: NDArray[np.int64]) -> Orders:
        """Return the light at some of the radii."""
        return Orders(self.values[:, :, which], self.error)

    def times(self, factor: Array) -> Orders:
        """Return the light times a factor of at least 0 for each plane."""
        return Orders(self.values * factor[:, None, None], self.error * factor)


def highest(pupil: ObjectivePupil) -> int:
    """Return the highest order of the light of a pupil."""
    return max(h.order for h in pupil.light.harmonics)


def light(pupil: ObjectivePupil, v: Array, asked: float, tol: float) -> Orders:
    """Return the light of a pupil at rising v.

    Its error is `asked` of its own peak, but at least 0.05 `tol`: errors relate to the same peak, and double
    precision can hold that.
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
            # a cos m phi + b sin m phi = Re (a - i b) exp(i m phi).
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
        # Orders of a product are the convolution of those of its factors.
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
    """Equally spaced radii, between twelve of which light at pixels is interpolated."""

    places: NDArray[np.int64]  # in units of `step`; negative ones lie beyond the axis
    step: float  # in v

    @classmethod
    def around(cls, radius: Array, error: float, faster: float) -> Table:
        """Return the table for pixels at `radius`, light of the exponential type ``2 faster`` and an error."""
        step = table_step(error) / faster
        first, last = (int(np.floor(at / step)) for at in (radius.min(), radius.max()))
        return cls(np.arange(first + 1 - HALF, last + HALF + 1), step)

    @property
    def radii(self) -> Array:
        """Radii at which light must be known, rising."""
        return self.step * np.unique(np.abs(self.places))

    def error(self, found: Orders) -> Array:
        """Bound the error of pixels, ``(n,)``, without that of :meth:`around`."""
        return growth() * (found.error + 8.0 * _ROUNDING * found.most)

    def painted(self, found: Orders, radius: Array, turn: NDArray[np.complex128]) -> Array:
        """Return light known at :attr:`radii` on pixels, ``(n, pixels)``; `turn` is ``exp(i phi)`` of the pixels."""
        from scipy.sparse import csr_array

        values = found._upper
        # Beyond the axis the azimuth changes by pi: F_m(-r) = (-1)^m F_m(r), certificate, "Scanning microscopes and
        # beads".
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
    """Base of methods for objectives that compute orders of the azimuth; subclasses are dataclasses with a `tol`."""

    @abstractmethod
    def _orders(self, pupil: ObjectivePupil, v: Array, asked: float) -> Orders:
        """Return the light at rising v, to about the accuracy `asked`."""

    @abstractmethod
    def _pixels(self, pupil: ObjectivePupil, grid: Grid, asked: float, threads: int) -> SampledLight:
        """Return the light of pupils with aberrations at pixel centres, to about the accuracy `asked`."""

    def _aberrated(self, pupil: ObjectivePupil) -> bool:
        """Return whether any of the light has aberrations."""
        return pupil.aberrated

    def _ceiling(self, pupil: ObjectivePupil) -> float:
        """Return an upper bound on the light and on the integral of the modulus of its transfer function."""
        return 1.0

    def profile(self, pupil: ObjectivePupil, v: Array) -> Intensities:
        """Return the mean over all azimuths at rising v, which is the light itself if it is radial."""
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
        """Return I at pixel centres."""
        grid.require_one_axis()
        if self._aberrated(pupil):
            return self._by_pixels(pupil, grid, tol, wanted)
        x, y = pupil.v(grid.x), pupil.v(grid.y)[:, None]
        radius, turn = np.hypot(x, y).ravel(), np.exp(1j * np.arctan2(y, x)).ravel()
        faster, ceiling = self.stretch(pupil), self._ceiling(pupil)
        # Values divided by their own largest one have twice the error; 0.48 leaves a reserve.
        alone = wanted.scale is None
        aim = (0.48 if alone else 1.0) * (max(tol, LEAST) - 1.1 * storing(wanted.dtype))
        # The peak of a plane may lie beside the window; then values at the axis and on a bright ring bound it from
        # below.
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
        return to_images(made._replace(values=values), grid, wanted)._replace(peak=made.peak)

    def _by_pixels(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Images:
        """Return the same for light with aberrations, relative to the largest value in the window."""
        aim = (0.48 if wanted.scale is None else 1.0) * (max(tol, LEAST) - 1.1 * storing(wanted.dtype))

        def made_of(asked: float) -> tuple[Array, Array]:
            found = self._pixels(pupil, grid, asked, wanted.threads)
            return np.maximum(found.values, 0.0), found.error

        return to_images(refine_until(made_of, aim, start=0.1 * aim, floor=_LEAST, named=self.tol), grid, wanted)


_NODES_MOST = 200
_DIAMETER_MOST = 1e-5


@dataclass(frozen=True)
class Bead(ProvenMethod):
    r"""A bead uniformly filled with emitters, centred on the emitter of the pupil.

    The ball is integrated over discs: ``3/4 int (1 - u^2) D(u) du`` over -1 to 1, D being the mean PSF over a disc of
    radius ``R sqrt(1 - u^2)`` at the depth ``d + R u``. Gauss's rule for the weight ``1 - u^2`` has a number of
    heights that is proven to suffice.

    Parameters
    ----------
    diameter : float
        Metres, in the sample.
    tol : float, default 1e-6
        Tolerance relative to the peak of each plane.

    Raises
    ------
    TypeError, ValueError
        If one of them is out of range.

    Notes
    -----
    The light is band-limited along the height as well as laterally: fields vary by at most ``k n_s (1 - c)``, and
    decay beyond the critical angle like ``exp(-k n_s kappa h)``, so the sum over heights converges geometrically.
    Refraction by the bead itself is neglected.
    """

    diameter: float
    tol: float = 1e-6

    def __post_init__(self) -> None:
        size = validation.real("diameter", self.diameter, above=0.0, most=_DIAMETER_MOST, unit="metres")
        object.__setattr__(self, "diameter", size)
        super().__post_init__()

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return the reason if the bead would reach into the glass."""
        radius = 0.5 * self.diameter
        near = float(pupil.depth.min())
        if near < radius * (1.0 - 1e-9):
            return f"needs a depth of at least the radius of the bead, {radius:g} metres, got {near:g}"
        return super().unsupported(pupil)

    def _orders(self, pupil: ObjectivePupil, v: Array, asked: float) -> Orders:
        """Return the light at rising v."""
        radius, layers, highest_order = 0.5 * self.diameter, pupil.layers, highest(pupil)
        size = layers.wavenumber * layers.NA * radius
        heights, stack, share, off = self._planes(pupil, asked)
        depths = stack.depth
        half = heights.size // 2
        discs = [disc_means(v, size * float(np.sqrt(1.0 - u * u)), asked, highest_order) for u in heights[half:]]
        discs = discs[: -half - 1 : -1] + discs  # discs below the middle have the radii of those above
        places, rows = np.unique(np.concatenate([d.places for d in discs]), return_inverse=True)
        found = light(stack, places, asked, self.tol)
        values_at, errors = found.values.reshape(*depths.shape, -1, places.size), found.error.reshape(depths.shape)
        values: Values = np.zeros(1)
        error, first = np.full(depths.shape[1], off), 0
        for k, means in enumerate(discs):
            here = rows[first : first + means.places.size]
            first += means.places.size
            values = values + share[k, :, None, None] * means.of(values_at[k][..., here])
            error += share[k] * (errors[k] * means.gain + means.error)
        return Orders(values, error)

    def _pixels(self, pupil: ObjectivePupil, grid: Grid, asked: float, threads: int) -> SampledLight:
        """Return the light at the centres of pixels."""
        size = 0.5 * self.diameter * pupil.layers.wavenumber * pupil.layers.NA
        heights, stack, share, off = self._planes(pupil, asked)
        count = math.prod(pupil.shape)
        values, error = np.zeros((count, *grid.shape)), np.full(count, off)
        # Discs below the middle have the radii, and hence the filters, of those above.
        for k, other in enumerate(range(len(heights) - 1, len(heights) // 2 - 1, -1)):
            means = disc_filter(grid.step(pupil), size * math.sqrt(1.0 - heights[k] ** 2), asked)
            for j in {k, other}:
                plane = replace(pupil, depth=stack.depth[j].reshape(pupil.shape))
                one = means.of(light_samples(plane, means.samples(grid), asked / means.gain, threads), threads)
                values += one.times(share[j]).values
                error += share[j] * one.error
        return SampledLight(values, error)

    def _planes(self, pupil: ObjectivePupil, asked: float) -> tuple[Array, ObjectivePupil, Array, float]:
        """Return heights, planes at these without aberrations (heights, n), their shares of light, and an error."""
        # Gauss's rule for the weight 1 - u^2 over heights in units of the radius.
        heights, weights, off = _rule(self._growth(pupil), asked)
        depths = np.maximum(pupil.depth.ravel() + 0.5 * self.diameter * heights[:, None], 0.0)
        focus, z = (np.broadcast_to(part.ravel(), depths.shape) for part in (pupil.focus, pupil.z))
        stack = replace(pupil, depth=depths, focus=focus, z=z, aberrations=None)
        share = weights[:, None] * stack.power.reshape(depths.shape)
        return heights, stack, share / share.sum(axis=0), off

    def _growth(self, pupil: ObjectivePupil) -> Array:
        """Return the logarithm of the growth of the intensity on ellipses of complex heights."""
        layers, radius = pupil.layers, 0.5 * self.diameter
        eta, ratio = ETA, layers.NA / layers.sample
        within = float(1.0 - np.sqrt(max(1.0 - ratio**2, 0.0)))
        fading = float(np.sqrt(max(ratio**2 - 1.0, 0.0)))
        # abs(Im) of the disc is R sinh(eta) abs(cos), that of the height R sinh(eta) abs(sin).
        # Certificate, "Beads".
        across = radius * layers.wavenumber * float(np.hypot(2.0 * layers.NA, layers.sample * within))
        return across * np.sinh(eta) + 2.0 * radius * layers.wavenumber * layers.sample * fading * np.cosh(eta)


def _rule(growth: Array, error: float) -> tuple[Array, Array, float]:
    """Return heights, weights of sum 1, and the error of sums over them: `error`, or more at the most nodes."""
    from scipy.special import roots_jacobi

    nodes = 2
    # Twice: intensities are divided by such a sum too.
    while (off := 2.0 * gauss_error(growth, nodes)) > error and nodes < _NODES_MOST:
        nodes += 1
    # Gauss-Jacobi with the weight (1 - u)(1 + u): areas of the discs of a ball.
    u, w = roots_jacobi(nodes, 1.0, 1.0)
    return u, w / w.sum(), off


AIRY = 2.0 * math.pi * 0.61  # ``0.61 lambda / NA``, half an Airy unit, in v
_PINHOLE_MOST = 100.0
_SATURATION_MOST = 1e4
_SHARE = 0.02  # of the tolerance: difference between the polynomial and the exponential
_COARSE, _FINE = np.linspace(0.1, 8.0, 80), np.linspace(-0.1, 0.1, 101)  # v, search for the crest


@dataclass(frozen=True)
class Confocal(ProvenMethod):
    r"""Confocal microscope: excitation intensity times the fraction of the emission that passes the pinhole.

    ``E(r) P(r)``, r being the distance of the emitter from the axis: E is the excitation intensity, relative to the
    focus of a uniform scalar aperture that sends as much light through the same plane of the sample; P is the
    fraction of the collected emission that passes the pinhole. The pupil is that of the emission, and gives the
    planes. A :class:`lommel.Dipole` absorbs the field along its moment: E is then three times the intensity of that
    component, averaged over its wobble; for a freely rotating dipole it is the total intensity.

    Parameters
    ----------
    excitation : ObjectivePupil
        Excitation light, in any planes.
    pinhole : float, default 1
        Diameter of the pinhole in Airy units, ``1.22 lambda / NA`` of the emission.
    tol : float, default 1e-6
        Tolerance relative to the peak of each plane.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.

    Notes
    -----
    ``E(r) = 4 pi / (k NA)^2 I(r) / int I d^2r``, the integral over the plane of the emitter, the same at every
    focus; for circular light ``I = abs(K0)^2 + 2 abs(K1)^2 + abs(K2)^2`` of :meth:`lommel.Objective.fields`.
    The integral includes Fresnel losses and light beyond the critical angle; near the glass it changes with depth.

    E P has the spatial frequencies of both, ``1 + lambda_emission / lambda_excitation`` times those of a field.

    References
    ----------
    T. Ha, T. A. Laurence, D. S. Chemla and S. Weiss, J. Phys. Chem. B 103, 6839 (1999), doi:10.1021/jp990948j:
    dipoles in polarised light.
    """

    excitation: ObjectivePupil
    pinhole: float = 1.0
    tol: float = 1e-6

    def __post_init__(self) -> None:
        super().__post_init__()
        pupil = _given("excitation", self.excitation)
        if not (pupil.light.radial or isinstance(pupil.emitter, Beam)):
            raise ValueError(f"excitation must be the light of a Beam, got that of {pupil.emitter!r}")
        object.__setattr__(self, "excitation", _one_plane("excitation", pupil))
        pinhole = validation.real("pinhole", self.pinhole, above=0.0, most=_PINHOLE_MOST, unit="Airy units")
        object.__setattr__(self, "pinhole", pinhole)

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return the reason where the excitation is that of another objective, or leaves the emitter dark."""
        if pupil.magnification != self.excitation.magnification:
            return (
                f"has an excitation of the magnification {self.excitation.magnification:g}, "
                f"and a pupil of {pupil.magnification:g}"
            )
        if reason := super().unsupported(pupil):
            return reason
        if _fixed(pupil) and not isinstance(self.excitation.emitter, Beam):
            return f"needs an excitation by a Beam for {pupil.emitter!r}, got {self.excitation.emitter!r}"
        if not self._lit(pupil).power.min() > 0.0:
            return f"has an excitation without a field along {pupil.emitter!r}"
        return None

    def along_radius(self, pupil: ObjectivePupil) -> RadialMethod | None:
        """Return the method itself if neither light depends on the azimuth, else None."""
        return self if pupil.radial and self._lit(pupil).radial and not self._aberrated(pupil) else None

    def _ceiling(self, pupil: ObjectivePupil) -> float:
        """Return an upper bound on the product and on the integral of the modulus of its transfer function."""
        return max(1.0, self._share) * float(self._absorbed(pupil).max())

    @property
    def _share(self) -> float:
        """Area of the pinhole: light through it over the mean intensity across it."""
        return 0.25 * (AIRY * self.pinhole) ** 2

    def _lit(self, pupil: ObjectivePupil) -> ObjectivePupil:
        """Return the excitation in the planes of the emission, as the emitter absorbs it."""
        beam = self.excitation.emitter
        if isinstance(beam, Beam) and (dipole := _fixed(pupil)):
            beam = Absorbed(beam.polarization, dipole)
        return replace(pupil, layers=self.excitation.layers, emitter=beam, aberrations=self.excitation.aberrations)

    def _aberrated(self, pupil: ObjectivePupil) -> bool:
        """Return whether any of the light has aberrations."""
        return pupil.aberrated or self.excitation.aberrated

    def _absorbed(self, pupil: ObjectivePupil) -> Array:
        """Return the largest light absorbed in each plane, over that of the beam."""
        lit = self._lit(pupil)
        return lit.power / replace(lit, emitter=self.excitation.emitter).power

    def stretch(self, pupil: ObjectivePupil) -> float:
        """Return the exponential type of a field whose square is the product: the sum of both types."""
        return 1.0 + pupil.scale / self.excitation.scale

    def _orders(self, pupil: ObjectivePupil, v: Array, asked: float) -> Orders:
        """Return the product at rising v, of the emission."""
        # The same radius in metres is another v at the wavelength of the excitation.
        excited = light(self._lit(pupil), pupil.scale / self.excitation.scale * v, asked, self.tol)
        means = disc_means(v, AIRY * self.pinhole, asked / max(1.0, self._share), highest(pupil))
        seen = light(pupil, means.places, asked, self.tol)
        passed = Orders(means.of(seen.values), seen.error * means.gain + means.error)
        return product(excited.times(self._absorbed(pupil)), passed.times(np.full(len(seen.error), self._share)))

    def _pixels(self, pupil: ObjectivePupil, grid: Grid, asked: float, threads: int) -> SampledLight:
        """Return the product at the centres of pixels."""
        accuracy = asked / max(1.0, self._share)
        means = disc_filter(grid.step(pupil), AIRY * self.pinhole, accuracy)
        seen = means.of(light_samples(pupil, means.samples(grid), accuracy / means.gain, threads), threads)
        excited = light_samples(self._lit(pupil), grid, asked, threads).times(self._absorbed(pupil))
        return excited.times(seen.times(np.full(len(seen.error), self._share)))


def _one_plane(name: str, pupil: ObjectivePupil) -> ObjectivePupil:
    """Return the pupil in one of its planes, which must share their aberrations."""
    if pupil.aberrations is not None and pupil.aberrations.shape:
        raise ValueError(f"{name} must have one set of aberrations for all planes, got a stack")
    return pupil[(0,) * len(pupil.shape)] if pupil.shape else pupil


def _given(name: str, given: object) -> ObjectivePupil:
    """Return the given pupil, or rebuild it from its description."""
    pupil = ObjectivePupil.from_dict(given) if isinstance(given, dict) else given
    return cast("ObjectivePupil", validation.instance(name, pupil, ObjectivePupil))


def _fixed(pupil: ObjectivePupil) -> Dipole | None:
    """Return the dipole of a pupil, None if it rotates freely."""
    emitter = pupil.emitter
    return emitter if isinstance(emitter, Dipole) and emitter.wobble < 1.0 else None


@dataclass(frozen=True)
class TwoPhoton(ProvenMethod):
    r"""Two-photon microscope: the squared excitation intensity; all emitted light is collected.

    The pupil is that of the excitation.

    Parameters
    ----------
    tol : float, default 1e-6
        Tolerance relative to the peak of each plane.

    Raises
    ------
    TypeError, ValueError
        If `tol` is out of range.

    References
    ----------
    W. Denk, J. H. Strickler and W. W. Webb, Science 248, 73 (1990), doi:10.1126/science.2321027.
    """

    tol: float = 1e-6

    def stretch(self, pupil: ObjectivePupil) -> float:
        """Return 2: the square of an intensity."""
        return 2.0

    def _orders(self, pupil: ObjectivePupil, v: Array, asked: float) -> Orders:
        """Return the square of the intensity at rising v."""
        once = light(pupil, v, asked, self.tol)
        return product(once, once)

    def _pixels(self, pupil: ObjectivePupil, grid: Grid, asked: float, threads: int) -> SampledLight:
        """Return the square of the intensity at the centres of pixels."""
        once = light_samples(pupil, grid, asked, threads)
        return once.times(once)


@dataclass(frozen=True)
class Sted(Confocal):
    r"""Confocal microscope with stimulated emission depletion (STED).

    ``E(r) P(r) 2^(-s D(r))``: E and P as of :class:`lommel.methods.Confocal`, D the intensity of the depletion beam
    in the units of E. This holds for pulses that are short compared with the lifetime of the excited state; s D is
    the intensity relative to that which depletes half.

    Parameters
    ----------
    excitation, pinhole, tol
        As of :class:`lommel.methods.Confocal`.
    depletion : ObjectivePupil
        A rotationally symmetric beam that is dark on the axis: ``lm.Beam("vortex")``, in any planes.
    saturation : float
        s, at most 1e4; :func:`lommel.microscopy.sted` takes it relative to the maximum of the beam.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.

    Notes
    -----
    ``exp(-2 a D)``, D between 0 and 1, differs by at most ``2 sum_(k > n) exp(-a) I_k(a)`` from its Chebyshev series
    of degree n, which has n times the bandwidth of D, so that it can be interpolated with a proven error. n grows
    like the square root of `saturation`, as does the resolution.

    References
    ----------
    S. W. Hell and J. Wichmann, Opt. Lett. 19, 780 (1994), doi:10.1364/OL.19.000780.
    B. Harke et al., Opt. Express 16, 4154 (2008), doi:10.1364/OE.16.004154: the exponential.
    """

    depletion: ObjectivePupil = field(kw_only=True)
    saturation: float = field(kw_only=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        pupil = _given("depletion", self.depletion)
        if not pupil.light.radial:
            raise ValueError(f"depletion must not depend on the direction, got {pupil!r}")
        if self.excitation.magnification != pupil.magnification:
            raise ValueError(
                f"depletion must have the magnification of the excitation, {self.excitation.magnification:g}, "
                f"got {pupil.magnification:g}"
            )
        object.__setattr__(self, "depletion", _one_plane("depletion", pupil))
        saturation = validation.real("saturation", self.saturation, least=0.0, most=_SATURATION_MOST)
        object.__setattr__(self, "saturation", saturation)

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return the reason if emitters do not rotate freely, or that of a confocal microscope."""
        if _fixed(pupil):
            return f"supports emitters that turn freely only, got {pupil.emitter!r}"
        return super().unsupported(pupil)

    def stretch(self, pupil: ObjectivePupil) -> float:
        """Return the exponential type of a field whose square is the product within the tolerance."""
        return super().stretch(pupil) + self._degree * pupil.scale / self.depletion.scale

    def images(self, pupil: ObjectivePupil, grid: Grid, wanted: Wanted) -> Images:
        """Return the images of the flattened stack; see ``Method.images``."""
        if grid.integrate and self.along_radius(pupil) is None:
            raise ValueError("integrate must be False for a Sted whose light depends on the direction, got True")
        return super().images(pupil, grid, wanted)

    def _aberrated(self, pupil: ObjectivePupil) -> bool:
        """Return whether any of the light has aberrations."""
        return super()._aberrated(pupil) or self.depletion.aberrated

    def _depleting(self, pupil: ObjectivePupil) -> ObjectivePupil:
        """Return the depletion beam in the planes of the emission."""
        beam = self.depletion
        return replace(pupil, layers=beam.layers, emitter=beam.emitter, aberrations=beam.aberrations)

    def _pixels(self, pupil: ObjectivePupil, grid: Grid, asked: float, threads: int) -> SampledLight:
        """Return the product after depletion at pixel centres."""
        rate = math.log(2.0) * self.saturation
        excited = super()._pixels(pupil, grid, asked, threads)
        depleting = light_samples(self._depleting(pupil), grid, asked / max(1.0, rate), threads)
        left = np.exp(-rate * np.maximum(depleting.values, 0.0))
        return excited.times(SampledLight(left, rate * depleting.error))

    def _orders(self, pupil: ObjectivePupil, v: Array, asked: float) -> Orders:
        """Return the product after depletion at rising v of the emission."""
        beam, slower = self.depletion, super().stretch(pupil)
        planes = self._depleting(pupil)
        rate, faster = math.log(2.0) * self.saturation, pupil.scale / beam.scale
        finer, ceiling = max(1.0, rate), self._ceiling(pupil)
        # Both factors are band-limited: they are computed at few radii and interpolated at many.
        # Discs of radius 0 interpolate, from a table as fine as the band of the product needs.
        means = disc_means(slower * v, 0.0, 0.1 * asked / ceiling, highest(self._lit(pupil)))
        known = super()._orders(pupil, means.places / slower, asked)
        excited = Orders(means.of(known.values), known.error * means.gain + ceiling * means.error)
        means = disc_means(faster * v, 0.0, 0.1 * asked / finer)
        known = light(planes, means.places, asked / finer, self.tol / finer)
        depleting = Orders(means.of(known.values), known.error * means.gain + means.error)
        left = np.exp(-rate * depleting.mean)
        # Twice the share: values known and values interpolated each differ by it from the polynomial.
        off = rate * depleting.error + 2.0 * _SHARE * self.tol
        return Orders(excited.values * left[:, None], excited.error + excited.most * off)

    @property
    def _degree(self) -> int:
        """Degree of the polynomial."""
        from scipy.special import ive

        # exp(-2 a D), D from 0 to 1, has the coefficients 2 exp(-a) I_k(a) in Chebyshev polynomials of 2 D - 1.
        a = 0.5 * math.log(2.0) * self.saturation
        # Beyond 40 terms more than the root of 80 a what is left is below 1e-17.
        k = np.arange(1, math.ceil(math.sqrt(80.0 * a)) + 41)
        beyond = 2.0 * np.cumsum(ive(k, a)[::-1])[::-1]  # of degrees below each
        return int(np.argmax(beyond <= _SHARE * self.tol))


def crest(pupil: ObjectivePupil) -> float:
    """Return the largest intensity of a radial beam over its planes, without the phase of the layers."""
    # Each plane wave keeps its transmission by interfaces and films and its decay with depth, but loses the phase psi
    # of :meth:`lommel.Objective.phase`. To 1e-6, as E of :class:`lommel.methods.Confocal` is normalised.
    from scipy.special import jv

    model, depth, focus = pupil.light.model, pupil.depth.ravel(), pupil.focus.ravel()
    rule = debye.rule(pupil.layers, model, depth, focus, float(_COARSE[-1] + _FINE[-1]), 1e-10)
    waves = np.abs(rule.waves(depth, focus))

    def bright(v: Array) -> Array:
        arguments = np.multiply.outer(rule.rho, v)
        each = zip(pupil.light.shares, model.orders, rule.parts, strict=True)
        total = sum(share * np.abs((waves * part) @ jv(order, arguments)) ** 2 for share, order, part in each)
        return np.asarray((total / pupil.power[:, None]).max(axis=0))

    return float(bright(_COARSE[bright(_COARSE).argmax()] + _FINE).max())
