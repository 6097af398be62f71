"""Scanning microscopes and beads: intensities as azimuthal Fourier orders on a table of radii, then interpolated.

The intensity of any emitter is ``sum_m F_m(r) exp(i m phi)``, m from -2 to 2 and ``F_-m = conj(F_m)``; products of
intensities have a few more orders. Radially symmetric intensities have the order 0 only. v is the radius in optical
units, ``k NA r``, and phi the azimuth; n is the number of planes.
"""

from __future__ import annotations

import math
from abc import abstractmethod
from dataclasses import dataclass, field, replace
from typing import NamedTuple, cast

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core.answers import Intensities, Samples, Wanted
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

_MIN_ERROR = 1e-13  # smallest error that is requested of intensities of peak about 1
_BRIGHT_RADII = np.array([0.0, BRIGHT_RING])  # radii v at which most planes are bright
_MIN_ERROR_FRACTION = 0.05  # smallest error requested of one factor of a product, divided by the tolerance
_ROUNDING = 2.0**-50  # relative rounding error of an intensity or a product
_AZIMUTHS = np.linspace(0.0, 2.0 * np.pi, 8, endpoint=False)  # azimuths at which the peak is searched, radians
_PEAK_RADII = 512  # approximate number of radii at which the peak is searched
_BLOCK_VALUES = 2**21  # number of values of all planes and orders that are interpolated in one block of pixels


class Orders(NamedTuple):
    """Intensity at given radii as azimuthal Fourier orders, for n planes."""

    values: Values  # (n, 2 M + 1, radii), F_-M first; complex, or real if M is 0
    error: Array  # (n,), bound on the error of the intensity at these radii and any azimuth

    @property
    def largest(self) -> Array:
        """Upper bound on the intensity at these radii, for each plane."""
        return np.asarray(np.abs(self.values).sum(axis=1).max(axis=1))

    @property
    def mean(self) -> Array:
        """Mean over all azimuths, shape (n, radii), not negative."""
        return np.asarray(np.maximum(self._nonnegative[:, 0].real, 0.0))

    @property
    def samples(self) -> Array:
        """Intensity on a coarse grid of radii and azimuths, shape (n, samples), to estimate the peak."""
        subset = self._nonnegative[..., :: max(1, self.values.shape[2] // _PEAK_RADII), None]
        return _sum_orders(subset, np.exp(1j * _AZIMUTHS)).reshape(len(self.values), -1)

    @property
    def _nonnegative(self) -> Values:
        """The orders 0 to M; the order -m is the conjugate of the order m."""
        return self.values[:, self.values.shape[1] // 2 :]

    def at(self, indices: NDArray[np.int64]) -> Orders:
        """Return the intensity at the radii of the `indices`."""
        return Orders(self.values[:, :, indices], self.error)

    def times(self, factor: Array) -> Orders:
        """Return the intensity times `factor`, one number of at least 0 for each plane."""
        return Orders(self.values * factor[:, None, None], self.error * factor)


def highest(pupil: ObjectivePupil) -> int:
    """Return the highest azimuthal order of the intensity of a pupil."""
    return max(h.order for h in pupil.light.harmonics)


def light(pupil: ObjectivePupil, v: Array, accuracy: float, tol: float) -> Orders:
    """Return the intensity of a pupil at rising v.

    The requested error, relative to the peak of this intensity, is `accuracy` or, if this is larger, 0.05 `tol`.
    """
    computed = profiles(pupil, v, max(accuracy, _MIN_ERROR_FRACTION * tol, Stratified.least_tol))
    if computed is None:
        values, error = harmonics(pupil, v, LEAST)
        computed = np.moveaxis(values, 0, 1), error
    values, error = computed
    if (highest_order := highest(pupil)) == 0:
        return Orders(values, error)
    orders = np.zeros((len(values), 2 * highest_order + 1, v.size), np.complex128)
    for h, profile in zip(pupil.light.harmonics, np.moveaxis(values, 1, 0), strict=True):
        if h.order:
            # a cos m phi + b sin m phi = Re (a - i b) exp(i m phi).
            orders[:, highest_order + h.order] += 0.5 * (h.cosine - 1j * h.sine) * profile
        else:
            orders[:, highest_order] = profile
    orders[:, :highest_order] = orders[:, :highest_order:-1].conj()
    return Orders(orders, error + _ROUNDING * np.abs(orders).sum(axis=1).max(axis=1))


def product(a: Orders, b: Orders) -> Orders:
    """Return the product of two intensities in the same planes at the same radii."""
    count, other_count = a.values.shape[1], b.values.shape[1]
    kind = np.result_type(a.values, b.values)
    values = np.zeros((len(a.values), count + other_count - 1, a.values.shape[2]), kind)
    for j in range(count):
        # The orders of a product are the convolution of the orders of its factors.
        values[:, j : j + other_count] += a.values[:, j, None] * b.values
    bounds = a.largest, b.largest
    error = a.error * bounds[1] + b.error * (bounds[0] + a.error) + _ROUNDING * bounds[0] * bounds[1]
    return Orders(values, error)


def _sum_orders(values: Values, turn: NDArray[np.complex128]) -> Array:
    """Return the sum over m = -M to M from `values` (n, orders 0 to M, ...); `turn` is ``exp(i phi)``."""
    total, power = values[:, 0].real * np.ones(turn.shape), np.ones_like(turn)
    for m in range(1, values.shape[1]):
        power = power * turn
        total = total + 2.0 * (values[:, m] * power).real
    return np.asarray(total)


class Table(NamedTuple):
    """Equally spaced radii, from which intensities at pixels are interpolated by the nearest 2 HALF radii."""

    positions: NDArray[np.int64]  # radii in units of `step`; a negative radius is at the opposite azimuth
    step: float  # spacing of the radii in v

    @classmethod
    def for_pixels(cls, radius: Array, error: float, stretch: float) -> Table:
        """Return the table for pixels at `radius`: interpolation to `error`, exponential type 2 `stretch`."""
        step = table_step(error) / stretch
        first, last = (int(np.floor(r / step)) for r in (radius.min(), radius.max()))
        return cls(np.arange(first + 1 - HALF, last + HALF + 1), step)

    @property
    def radii(self) -> Array:
        """Radii v, rising, at which the intensity has to be computed."""
        return self.step * np.unique(np.abs(self.positions))

    def error(self, orders: Orders) -> Array:
        """Bound the error of pixels, ``(n,)``, without the interpolation error passed to :meth:`for_pixels`."""
        return growth() * (orders.error + 8.0 * _ROUNDING * orders.largest)

    def interpolate(self, tabulated: Orders, radius: Array, turn: NDArray[np.complex128]) -> Array:
        """Interpolate the intensity from :attr:`radii` to pixels, ``(n, pixels)``; `turn` is ``exp(i phi)``."""
        orders = tabulated._nonnegative
        # At negative radii the azimuth changes by pi: F_m(-r) = (-1)^m F_m(r), certificate, "Scanning microscopes and
        # beads".
        sign = np.where(self.positions < 0, -1.0, 1.0)
        row = np.searchsorted(np.unique(np.abs(self.positions)), np.abs(self.positions))
        table = np.stack([orders[:, m][:, row] * sign**m for m in range(orders.shape[1])], axis=1)
        values = np.empty((len(orders), radius.size))
        block = max(1, _BLOCK_VALUES // (table.shape[0] * table.shape[1]))
        for part in (slice(k, k + block) for k in range(0, radius.size, block)):
            radii, index = np.unique(radius[part], return_inverse=True)
            start, weights = between(radii / self.step)
            columns = (start - self.positions[0])[:, None] + np.arange(2 * HALF)
            ends = np.arange(0, columns.size + 1, 2 * HALF)
            matrix = scipy.sparse.csr_array(
                (weights.ravel(), columns.ravel(), ends), shape=(radii.size, self.positions.size)
            )
            lines = (matrix @ table.reshape(-1, self.positions.size).T).T.reshape(*table.shape[:2], radii.size)
            values[:, part] = _sum_orders(lines[..., index], turn[part])
        return np.maximum(values, 0.0, out=values)


class ProvenMethod(LayeredMethod, RadialMethod[ObjectivePupil]):
    """Base of methods for objectives that compute azimuthal orders; subclasses are dataclasses with a `tol`."""

    @abstractmethod
    def _orders(self, pupil: ObjectivePupil, v: Array, target: float) -> Orders:
        """Return the image intensity at rising v, with an error of about `target`."""

    @abstractmethod
    def _pixels(self, pupil: ObjectivePupil, grid: Grid, target: float, threads: int) -> SampledLight:
        """Return the image intensity with aberrations at pixel centres, with an error of about `target`."""

    def _aberrated(self, pupil: ObjectivePupil) -> bool:
        """Return whether the emission, excitation or depletion has aberrations."""
        return pupil.aberrated

    def _ceiling(self, pupil: ObjectivePupil) -> float:
        """Return an upper bound on the intensity and on the integral of the modulus of its transfer function."""
        return 1.0

    def profile(self, pupil: ObjectivePupil, v: Array) -> Intensities:
        """Return the mean intensity over all azimuths at rising v."""
        if self._aberrated(pupil):
            raise ValueError(
                f"{type(self).__name__} has no profiles of light with aberrations; compute an image, and measure that"
            )
        radii, index = np.unique(np.append(v, _BRIGHT_RADII), return_inverse=True)

        def compute(target: float) -> tuple[Array, Array]:
            orders = self._orders(pupil, radii, target)
            return orders.mean, orders.error

        intensities = refine_until(compute, self.tol, start=0.1 * self.tol, floor=_MIN_ERROR, tol=self.tol)
        return intensities._replace(values=intensities.values[:, index[: v.size]])

    def intensity(self, pupil: ObjectivePupil, grid: Grid, threads: int) -> Intensities:
        """Return I at the distinct radii of the pixels if it is radially symmetric, else at every pixel."""
        if self.along_radius(pupil) is not None:
            return super().intensity(pupil, grid, threads)
        return self.images(pupil, grid, Wanted(threads=threads)).intensities

    def images(self, pupil: ObjectivePupil, grid: Grid, wanted: Wanted) -> Samples:
        """Return the images of the flattened stack; see :meth:`lommel.methods.Method.images`."""
        if self.along_radius(pupil) is not None or wanted.terms or wanted.powers:
            return super().images(pupil, grid, wanted)
        if not grid.integrate:
            return self._samples(pupil, grid, self.tol, wanted)
        band = self.stretch(pupil), self._ceiling(pupil)
        return averaged_images(self._samples, pupil, grid, self.tol, wanted, band)

    def _samples(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Samples:
        """Return I at pixel centres, interpolated from a table of radii unless there are aberrations."""
        grid.require_one_axis()
        if self._aberrated(pupil):
            return self._aberrated_samples(pupil, grid, tol, wanted)
        x, y = pupil.v(grid.x), pupil.v(grid.y)[:, None]
        radius, turn = np.hypot(x, y).ravel(), np.exp(1j * np.arctan2(y, x)).ravel()
        stretch, ceiling = self.stretch(pupil), self._ceiling(pupil)
        # Images without a scale are divided by their own peak, which doubles the error; 0.48 leaves a reserve.
        divided_by_peak = wanted.scale is None
        allowed = (0.48 if divided_by_peak else 1.0) * (max(tol, LEAST) - 1.1 * storing(wanted.dtype))
        # With a scale, errors are relative to the peak of the plane, which may lie outside of the window. Intensities
        # on the axis and on a bright ring are then a lower bound of the peak.
        ring = _BRIGHT_RADII[:0] if divided_by_peak else _BRIGHT_RADII
        latest: list[tuple[Table, Orders]] = []

        def compute(target: float) -> tuple[Array, Array]:
            table = Table.for_pixels(radius, 0.25 * target / ceiling, stretch)
            radii, index = np.unique(np.append(table.radii, ring), return_inverse=True)
            orders, count = self._orders(pupil, radii, target), index.size - ring.size
            tabulated, on_ring = orders.at(index[:count]), orders.at(index[count:])
            latest[:] = [(table, tabulated)]
            if divided_by_peak:
                values = table.interpolate(tabulated, radius, turn)
            else:
                values = np.append(tabulated.samples, on_ring.samples, axis=1)
            return values, table.error(orders) + 0.25 * target

        intensities = refine_until(compute, allowed, start=0.03 * allowed, floor=_MIN_ERROR * ceiling, tol=self.tol)
        table, tabulated = latest[0]
        pixels = intensities.values if divided_by_peak else table.interpolate(tabulated, radius, turn)
        values = pixels.reshape(-1, *grid.shape)
        return to_images(intensities._replace(values=values), grid, wanted)._replace(peak=intensities.peak)

    def _aberrated_samples(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Samples:
        """Return I with aberrations at pixel centres, with an error relative to the largest value in the window."""
        allowed = (0.48 if wanted.scale is None else 1.0) * (max(tol, LEAST) - 1.1 * storing(wanted.dtype))

        def compute(target: float) -> tuple[Array, Array]:
            samples = self._pixels(pupil, grid, target, wanted.threads)
            return np.maximum(samples.values, 0.0), samples.error

        intensities = refine_until(compute, allowed, start=0.1 * allowed, floor=_MIN_ERROR, tol=self.tol)
        return to_images(intensities, grid, wanted)


_MAX_HEIGHTS = 200  # largest number of heights of the Gauss rule over a bead
_MAX_DIAMETER = 1e-5  # largest diameter of a bead, metres


@dataclass(frozen=True)
class Bead(ProvenMethod):
    r"""A bead uniformly filled with emitters, centred on the emitter of the pupil.

    The image is an integral over discs, ``3/4 int (1 - u^2) D(u) du`` over -1 to 1. R is the radius of the
    bead and d the depth of its centre; D is the mean PSF over a disc of radius ``R sqrt(1 - u^2)`` at the depth
    ``d + R u``. A Gauss rule for the weight ``1 - u^2`` computes the integral; its number of heights u is proven
    to suffice.

    Parameters
    ----------
    diameter : float
        Diameter of the bead, metres; at most 1e-5.
    tol : float, default 1e-6
        Tolerance relative to the peak of each plane.

    Raises
    ------
    TypeError, ValueError
        If `diameter` or `tol` is out of range.

    Notes
    -----
    The intensity is band-limited along the height h as well as phasely. Relative to the axial wave, the phase of a
    plane wave in the sample (wavenumber ``k n_s``) varies by at most ``k n_s (1 - c) h``, with c the smallest cosine
    of a ray's angle. Waves beyond the critical angle decay like ``exp(-k n_s kappa h)``, where the cosine is
    ``i kappa``. The sum over heights therefore converges geometrically.
    Refraction by the bead itself is neglected.
    """

    diameter: float
    tol: float = 1e-6

    def __post_init__(self) -> None:
        size = validation.real("diameter", self.diameter, above=0.0, most=_MAX_DIAMETER, unit="metres")
        object.__setattr__(self, "diameter", size)
        super().__post_init__()

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return the reason why a pupil is not supported, for example a bead that extends into glass; else None."""
        radius = 0.5 * self.diameter
        least_depth = float(pupil.depth.min())
        if least_depth < radius * (1.0 - 1e-9):
            return f"needs a depth of at least the radius of the bead, {radius:g} metres, got {least_depth:g}"
        return super().unsupported(pupil)

    def _orders(self, pupil: ObjectivePupil, v: Array, target: float) -> Orders:
        """Return the image intensity of the bead at rising v."""
        radius, layers, highest_order = 0.5 * self.diameter, pupil.layers, highest(pupil)
        size = layers.wavenumber * layers.NA * radius
        heights, stack, fractions, rule_error = self._planes(pupil, target)
        depths = stack.depth
        middle = heights.size // 2
        discs = [disc_means(v, size * float(np.sqrt(1.0 - u * u)), target, highest_order) for u in heights[middle:]]
        discs = discs[: -middle - 1 : -1] + discs  # the disc at -u has the radius of the disc at u
        places, rows = np.unique(np.concatenate([d.places for d in discs]), return_inverse=True)
        points = light(stack, places, target, self.tol)
        values_at, errors = points.values.reshape(*depths.shape, -1, places.size), points.error.reshape(depths.shape)
        values: Values = np.zeros(1)
        error, start = np.full(depths.shape[1], rule_error), 0
        for k, means in enumerate(discs):
            rows_of_disc = rows[start : start + means.places.size]
            start += means.places.size
            values = values + fractions[k, :, None, None] * means.of(values_at[k][..., rows_of_disc])
            error += fractions[k] * (errors[k] * means.gain + means.error)
        return Orders(values, error)

    def _pixels(self, pupil: ObjectivePupil, grid: Grid, target: float, threads: int) -> SampledLight:
        """Return the image intensity of the bead at pixel centres."""
        size = 0.5 * self.diameter * pupil.layers.wavenumber * pupil.layers.NA
        heights, stack, fractions, rule_error = self._planes(pupil, target)
        count = math.prod(pupil.shape)
        values, error = np.zeros((count, *grid.shape)), np.full(count, rule_error)
        # The discs at heights u and -u have the same radius, and hence the same filter.
        for k, mirror in enumerate(range(len(heights) - 1, len(heights) // 2 - 1, -1)):
            means = disc_filter(grid.step(pupil), size * math.sqrt(1.0 - heights[k] ** 2), target)
            for j in {k, mirror}:
                plane = replace(pupil, depth=stack.depth[j].reshape(pupil.shape))
                samples = means.of(light_samples(plane, means.samples(grid), target / means.gain, threads), threads)
                values += samples.times(fractions[j]).values
                error += fractions[j] * samples.error
        return SampledLight(values, error)

    def _planes(self, pupil: ObjectivePupil, target: float) -> tuple[Array, ObjectivePupil, Array, float]:
        """Return the heights u, and for each height and plane a pupil and a fraction of the light; also the error.

        The pupils have no aberrations. For each plane the fractions have the sum 1. The error is that of the sum over
        heights.
        """
        # Gauss rule for the weight 1 - u^2 over heights u in units of the radius.
        heights, weights, error = _height_rule(self._growth(pupil), target)
        depths = np.maximum(pupil.depth.ravel() + 0.5 * self.diameter * heights[:, None], 0.0)
        focus, z = (np.broadcast_to(part.ravel(), depths.shape) for part in (pupil.focus, pupil.z))
        stack = replace(pupil, depth=depths, focus=focus, z=z, aberrations=None)
        fractions = weights[:, None] * stack.power.reshape(depths.shape)
        return heights, stack, fractions / fractions.sum(axis=0), error

    def _growth(self, pupil: ObjectivePupil) -> Array:
        """Return the logarithm of a bound on the intensity, for complex heights on each Bernstein ellipse `ETA`."""
        layers, radius = pupil.layers, 0.5 * self.diameter
        eta, ratio = ETA, layers.NA / layers.sample
        one_minus_cosine = float(1.0 - np.sqrt(max(1.0 - ratio**2, 0.0)))  # largest 1 - c, for propagating waves
        largest_kappa = float(np.sqrt(max(ratio**2 - 1.0, 0.0)))  # for waves beyond the critical angle
        # At the parameter t of the ellipse, the imaginary part of the disc's radius has the modulus R sinh(eta)
        # abs(cos t), that of the height R sinh(eta) abs(sin t): certificate, "Beads".
        phase = radius * layers.wavenumber * float(np.hypot(2.0 * layers.NA, layers.sample * one_minus_cosine))
        return phase * np.sinh(eta) + 2.0 * radius * layers.wavenumber * layers.sample * largest_kappa * np.cosh(eta)


def _height_rule(growth: Array, error: float) -> tuple[Array, Array, float]:
    """Return heights u, weights of sum 1, and the error bound; it exceeds `error` if `_MAX_HEIGHTS` are too few."""
    nodes = 2
    # Factor 2: a sum of intensities is divided by a sum of powers, and the rule contributes an error to both sums.
    while (bound := 2.0 * gauss_error(growth, nodes)) > error and nodes < _MAX_HEIGHTS:
        nodes += 1
    # Gauss-Jacobi with the weight (1 - u)(1 + u), proportional to the area of the disc at the height u.
    u, w = scipy.special.roots_jacobi(nodes, 1.0, 1.0)
    return u, w / w.sum(), bound


AIRY = 2.0 * math.pi * 0.61  # radius ``0.61 lambda / NA``, half an Airy unit, in v
_MAX_PINHOLE = 100.0  # Airy units
_MAX_SATURATION = 1e4
_POLYNOMIAL_ERROR = 0.02  # largest error of the polynomial for the depletion, as a fraction of the tolerance
_RADII, _OFFSETS = np.linspace(0.1, 8.0, 80), np.linspace(-0.1, 0.1, 101)  # peak search: radii v, then offsets in v


@dataclass(frozen=True)
class Confocal(ProvenMethod):
    r"""Confocal microscope: excitation intensity times the fraction of the emission that passes the pinhole.

    The image is ``E(r) P(r)``, r being the distance from the axis: E is the excitation intensity, relative to the
    focus of a uniform scalar aperture that sends as much light through the same plane of the sample; P is the
    fraction of the collected emission that passes the pinhole. An image is computed for the pupil of the
    emission; its planes are used for the excitation, too. A :class:`lommel.Dipole` absorbs the component of the field
    along its moment: E is then three times the intensity of this component, averaged over the wobble of the dipole.
    For a freely rotating dipole, E is the total intensity.

    Parameters
    ----------
    excitation : ObjectivePupil
        Pupil of the excitation; its own planes are not used.
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
    ``E(r) = 4 pi / (k NA)^2 I(r) / int I d^2r``, with the integral over the plane of the emitter. The integral
    does not depend on the focus. For circular polarization ``I = abs(K0)^2 + 2 abs(K1)^2 + abs(K2)^2``, with K0 to
    K2 of :meth:`lommel.Objective.fields`. The integral includes Fresnel losses and light beyond the critical angle;
    near the glass it changes with depth.

    The spatial frequencies of E P are sums of a frequency of E and a frequency of P: the cutoff is the cutoff of the
    emission times ``1 + lambda_emission / lambda_excitation``.

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
        pupil = _pupil_of("excitation", self.excitation)
        if not (pupil.light.radial or isinstance(pupil.emitter, Beam)):
            raise ValueError(f"excitation must be the light of a Beam, got the light of {pupil.emitter!r}")
        object.__setattr__(self, "excitation", _one_plane("excitation", pupil))
        pinhole = validation.real("pinhole", self.pinhole, above=0.0, most=_MAX_PINHOLE, unit="Airy units")
        object.__setattr__(self, "pinhole", pinhole)

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return the reason if the excitation has another magnification or does not excite the emitter, else None."""
        if pupil.magnification != self.excitation.magnification:
            return (
                f"has an excitation of the magnification {self.excitation.magnification:g}, but a pupil of "
                f"{pupil.magnification:g}: both must be equal"
            )
        if reason := super().unsupported(pupil):
            return reason
        if _fixed_dipole(pupil) and not isinstance(self.excitation.emitter, Beam):
            return f"needs an excitation by a Beam for {pupil.emitter!r}, got {self.excitation.emitter!r}"
        if not self._absorbed_excitation(pupil).power.min() > 0.0:
            return f"has an excitation without a field along {pupil.emitter!r}"
        return None

    def along_radius(self, pupil: ObjectivePupil) -> RadialMethod | None:
        """Return the method itself if neither emission nor excitation depends on the azimuth, else None."""
        return (
            self if pupil.radial and self._absorbed_excitation(pupil).radial and not self._aberrated(pupil) else None
        )

    def _ceiling(self, pupil: ObjectivePupil) -> float:
        """Return an upper bound on the product and on the integral of the modulus of its transfer function."""
        return max(1.0, self._pinhole_area) * float(self._absorbed_fraction(pupil).max())

    @property
    def _pinhole_area(self) -> float:
        """Power through the pinhole divided by the mean intensity over it."""
        return 0.25 * (AIRY * self.pinhole) ** 2

    def _absorbed_excitation(self, pupil: ObjectivePupil) -> ObjectivePupil:
        """Return the pupil of the absorbed excitation in the planes of the emission."""
        beam = self.excitation.emitter
        if isinstance(beam, Beam) and (dipole := _fixed_dipole(pupil)):
            beam = Absorbed(beam.polarization, dipole)
        return replace(pupil, layers=self.excitation.layers, emitter=beam, aberrations=self.excitation.aberrations)

    def _aberrated(self, pupil: ObjectivePupil) -> bool:
        """Return whether the emission or the excitation has aberrations."""
        return pupil.aberrated or self.excitation.aberrated

    def _absorbed_fraction(self, pupil: ObjectivePupil) -> Array:
        """Return the absorbed power in each plane, divided by the power of the beam."""
        absorbed = self._absorbed_excitation(pupil)
        return absorbed.power / replace(absorbed, emitter=self.excitation.emitter).power

    def stretch(self, pupil: ObjectivePupil) -> float:
        """Return the exponential type in v of a field whose square is E P: 1 for P, plus that of the excitation."""
        return 1.0 + pupil.scale / self.excitation.scale

    def _orders(self, pupil: ObjectivePupil, v: Array, target: float) -> Orders:
        """Return the product E P at rising v of the emission."""
        # A radius in metres corresponds to another v at the wavelength of the excitation.
        excited = light(self._absorbed_excitation(pupil), pupil.scale / self.excitation.scale * v, target, self.tol)
        means = disc_means(v, AIRY * self.pinhole, target / max(1.0, self._pinhole_area), highest(pupil))
        detected = light(pupil, means.places, target, self.tol)
        through_pinhole = Orders(means.of(detected.values), detected.error * means.gain + means.error)
        return product(
            excited.times(self._absorbed_fraction(pupil)),
            through_pinhole.times(np.full(len(detected.error), self._pinhole_area)),
        )

    def _pixels(self, pupil: ObjectivePupil, grid: Grid, target: float, threads: int) -> SampledLight:
        """Return the product E P at pixel centres."""
        accuracy = target / max(1.0, self._pinhole_area)
        means = disc_filter(grid.step(pupil), AIRY * self.pinhole, accuracy)
        detected = means.of(light_samples(pupil, means.samples(grid), accuracy / means.gain, threads), threads)
        excited = light_samples(self._absorbed_excitation(pupil), grid, target, threads).times(
            self._absorbed_fraction(pupil)
        )
        return excited.times(detected.times(np.full(len(detected.error), self._pinhole_area)))


def _one_plane(name: str, pupil: ObjectivePupil) -> ObjectivePupil:
    """Return the pupil in its first plane; ValueError if each plane has its own aberrations."""
    if pupil.aberrations is not None and pupil.aberrations.shape:
        raise ValueError(f"{name} must have one set of aberrations for all planes, got a stack")
    return pupil[(0,) * len(pupil.shape)] if pupil.shape else pupil


def _pupil_of(name: str, value: object) -> ObjectivePupil:
    """Return the given pupil, rebuilt if it is a dictionary; TypeError for other types."""
    pupil = ObjectivePupil.from_dict(value) if isinstance(value, dict) else value
    return cast("ObjectivePupil", validation.instance(name, pupil, ObjectivePupil))


def _fixed_dipole(pupil: ObjectivePupil) -> Dipole | None:
    """Return the dipole of a pupil, None if the emitter rotates freely."""
    emitter = pupil.emitter
    return emitter if isinstance(emitter, Dipole) and emitter.wobble < 1.0 else None


@dataclass(frozen=True)
class TwoPhoton(ProvenMethod):
    r"""Two-photon microscope: the squared excitation intensity; all emitted light is collected.

    An image is computed for the pupil of the excitation.

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
        """Return 2, the exponential type of a field whose square is the squared intensity."""
        return 2.0

    def _orders(self, pupil: ObjectivePupil, v: Array, target: float) -> Orders:
        """Return the square of the intensity at rising v."""
        intensity = light(pupil, v, target, self.tol)
        return product(intensity, intensity)

    def _pixels(self, pupil: ObjectivePupil, grid: Grid, target: float, threads: int) -> SampledLight:
        """Return the square of the intensity at pixel centres."""
        intensity = light_samples(pupil, grid, target, threads)
        return intensity.times(intensity)


@dataclass(frozen=True)
class Sted(Confocal):
    r"""Confocal microscope with stimulated emission depletion (STED).

    The image is ``E(r) P(r) 2^(-s D(r))``: E and P as in :class:`lommel.methods.Confocal`, D the intensity of the
    depletion beam in the units of E, and s the saturation. This holds for pulses that are short compared with the
    lifetime of the excited state; s D is the intensity divided by the saturation intensity, which depletes half of
    the emitters.

    Parameters
    ----------
    excitation, pinhole, tol
        As for :class:`lommel.methods.Confocal`.
    depletion : ObjectivePupil
        A rotationally symmetric beam that is dark on the axis: ``lm.Beam("vortex")``, in any planes.
    saturation : float
        The factor s of D, at most 1e4. The argument of :func:`lommel.microscopy.sted`, by contrast, is s times the
        peak of D.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.

    Notes
    -----
    With ``a = s ln(2) / 2`` the factor is ``exp(-2 a D)``. For D between 0 and 1 its Chebyshev series of degree n has
    an error of at most ``2 sum_(k > n) exp(-a) I_k(a)``, I_k the modified Bessel functions. The bandwidth of the
    series is n times the bandwidth of D, so that it can be interpolated with a proven error. n grows like the square
    root of `saturation`, as does the resolution.

    References
    ----------
    S. W. Hell and J. Wichmann, Opt. Lett. 19, 780 (1994), doi:10.1364/OL.19.000780.
    B. Harke et al., Opt. Express 16, 4154 (2008), doi:10.1364/OE.16.004154: the exponential.
    """

    depletion: ObjectivePupil = field(kw_only=True)
    saturation: float = field(kw_only=True)

    def __post_init__(self) -> None:
        super().__post_init__()
        pupil = _pupil_of("depletion", self.depletion)
        if not pupil.light.radial:
            raise ValueError(f"depletion must not depend on the direction, got {pupil!r}")
        if self.excitation.magnification != pupil.magnification:
            raise ValueError(
                f"depletion must have the magnification of the excitation, {self.excitation.magnification:g}, "
                f"got {pupil.magnification:g}"
            )
        object.__setattr__(self, "depletion", _one_plane("depletion", pupil))
        saturation = validation.real("saturation", self.saturation, least=0.0, most=_MAX_SATURATION)
        object.__setattr__(self, "saturation", saturation)

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return the reason if emitters do not rotate freely, or if :class:`Confocal` does not support the pupil."""
        if _fixed_dipole(pupil):
            return f"supports freely rotating emitters only, got {pupil.emitter!r}"
        return super().unsupported(pupil)

    def stretch(self, pupil: ObjectivePupil) -> float:
        """Return the exponential type in v of a field whose square is E P times the depletion polynomial."""
        return super().stretch(pupil) + self._degree * pupil.scale / self.depletion.scale

    def images(self, pupil: ObjectivePupil, grid: Grid, wanted: Wanted) -> Samples:
        """Return the images of the flattened stack; see ``Method.images``."""
        if grid.integrate and self.along_radius(pupil) is None:
            raise ValueError("integrate must be False for a Sted whose light depends on the azimuth, got True")
        return super().images(pupil, grid, wanted)

    def _aberrated(self, pupil: ObjectivePupil) -> bool:
        """Return whether the emission, excitation or depletion has aberrations."""
        return super()._aberrated(pupil) or self.depletion.aberrated

    def _depletion_pupil(self, pupil: ObjectivePupil) -> ObjectivePupil:
        """Return the pupil of the depletion beam in the planes of the emission."""
        beam = self.depletion
        return replace(pupil, layers=beam.layers, emitter=beam.emitter, aberrations=beam.aberrations)

    def _pixels(self, pupil: ObjectivePupil, grid: Grid, target: float, threads: int) -> SampledLight:
        """Return the product ``E P 2^(-s D)`` at pixel centres."""
        rate = math.log(2.0) * self.saturation
        excited = super()._pixels(pupil, grid, target, threads)
        depleting = light_samples(self._depletion_pupil(pupil), grid, target / max(1.0, rate), threads)
        undepleted = np.exp(-rate * np.maximum(depleting.values, 0.0))
        return excited.times(SampledLight(undepleted, rate * depleting.error))

    def _orders(self, pupil: ObjectivePupil, v: Array, target: float) -> Orders:
        """Return the product ``E P 2^(-s D)`` at rising v of the emission."""
        beam, excited_type = self.depletion, super().stretch(pupil)
        planes = self._depletion_pupil(pupil)
        rate, depletion_type = math.log(2.0) * self.saturation, pupil.scale / beam.scale
        divisor, ceiling = max(1.0, rate), self._ceiling(pupil)
        # Both factors are band-limited: they are computed at few radii and interpolated to the radii v.
        # A disc mean of radius 0 is an interpolation, from a table as fine as the bandwidth requires.
        means = disc_means(excited_type * v, 0.0, 0.1 * target / ceiling, highest(self._absorbed_excitation(pupil)))
        tabulated = super()._orders(pupil, means.places / excited_type, target)
        excited = Orders(means.of(tabulated.values), tabulated.error * means.gain + ceiling * means.error)
        means = disc_means(depletion_type * v, 0.0, 0.1 * target / divisor)
        tabulated = light(planes, means.places, target / divisor, self.tol / divisor)
        depleting = Orders(means.of(tabulated.values), tabulated.error * means.gain + means.error)
        undepleted = np.exp(-rate * depleting.mean)
        # The error of the polynomial counts twice: for values in the table, and for interpolated values.
        error = rate * depleting.error + 2.0 * _POLYNOMIAL_ERROR * self.tol
        return Orders(excited.values * undepleted[:, None], excited.error + excited.largest * error)

    @property
    def _degree(self) -> int:
        """Degree of the Chebyshev series of the depletion factor that has the error `_POLYNOMIAL_ERROR`."""
        # exp(-2 a D), D from 0 to 1, has the coefficients 2 exp(-a) I_k(a) in Chebyshev polynomials of 2 D - 1.
        a = 0.5 * math.log(2.0) * self.saturation
        # The sum over k > sqrt(80 a) + 40 is below 1e-17.
        k = np.arange(1, math.ceil(math.sqrt(80.0 * a)) + 41)
        remainders = (
            2.0 * np.cumsum(scipy.special.ive(k, a)[::-1])[::-1]
        )  # error of the series of degree 0, 1, 2, ...
        return int(np.argmax(remainders <= _POLYNOMIAL_ERROR * self.tol))


def crest(pupil: ObjectivePupil) -> float:
    """Return the largest intensity of a radial beam in any of its planes, without aberrations by the layers.

    The unit is the unit of E in :class:`lommel.methods.Confocal`; the relative error is about 1e-6.
    """
    # The waves keep their transmission by interfaces and films and their decay with depth; the phase psi of
    # :meth:`lommel.optics.layers.stratified.Layers.rates` is omitted.

    model, depth, focus = pupil.light.model, pupil.depth.ravel(), pupil.focus.ravel()
    rule = debye.rule(pupil.layers, model, depth, focus, float(_RADII[-1] + _OFFSETS[-1]), 1e-10)
    waves = np.abs(rule.waves(depth, focus))

    def intensity(v: Array) -> Array:
        arguments = np.multiply.outer(rule.rho, v)
        components = zip(pupil.light.shares, model.orders, rule.parts, strict=True)
        total = sum(
            weight * np.abs((waves * part) @ scipy.special.jv(order, arguments)) ** 2
            for weight, order, part in components
        )
        return np.asarray((total / pupil.power[:, None]).max(axis=0))

    return float(intensity(_RADII[intensity(_RADII).argmax()] + _OFFSETS).max())
