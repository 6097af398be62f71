"""Microscope stacks with a measured wavefront: fields on circles around the axis, as sums over azimuthal orders."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Samples, Wanted, not_met
from lommel.core.engine import Ringed, Rings, Window, fft_length, ringed_images
from lommel.methods.layers.debye_wolf import LEAST, AberratedMethod, likely_peak
from lommel.methods.method import normalized_error, stored, storing
from lommel.optics.grid import Grid
from lommel.optics.layers import debye, projection
from lommel.optics.layers.debye import Complex
from lommel.optics.layers.emitter import Waves
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.special import interpolation
from lommel.special.bessel import bessel_sequence


class _Band(NamedTuple):
    """Bandwidth of I times the spacing of circles, and smallest error of the interpolation between circles."""

    band: float
    least: float


# The spacing of circles in v is 0.8 or, for small errors, 0.55: certificate, section 16, "Between circles".
_BANDS = (_Band(1.6, 5e-12), _Band(1.1, 5e-13))
_MIN_ERROR = 1e-12  # smallest error of the interpolation around circles
_PARTS = 2**22  # largest number of values of pupil functions in memory, if each pupil has its own wavefront
_ROUNDING = 2.0**-53


class Accuracy(NamedTuple):
    """Allowed errors of fields, of I interpolated between circles, and of I interpolated around circles, over I."""

    field: float
    radial: float
    angular: float


@dataclass(frozen=True)
class DebyeRings(AberratedMethod):
    r"""Debye-Wolf integral of an objective with aberrations, for any emitter, by quadrature over angles.

    Supports the pupils of :meth:`lommel.Objective.pupil` with `aberrations` only.

    Parameters
    ----------
    tol : float, default 1e-6
        Tolerance relative to the peak of each plane, 1e-12 to 1e-1. Because of rounding errors, tolerances below
        about 1e-10 may raise :class:`~lommel.ToleranceError`.

    Raises
    ------
    TypeError, ValueError
        If `tol` is out of range.

    Notes
    -----
    ``exp(i W) = sum_m P_m(rho) exp(i m theta)``, so that each field of a plane is

    .. math:: U(v, \phi) = \sum_m (-i)^{|m + q|} e^{i (m + q) \phi}
       \int P_m(\rho) T(\rho) e^{i \psi} J_{|m + q|}(v \rho) \rho \, d\rho

    with a number of orders and nodes that is proven to suffice. A Fourier transform computes these fields at equal
    angles on equally spaced circles, and the intensity is interpolated to the pixels, also with a proven error; see
    docs/certificate.md, section 16. Bessel functions are cached for stacks of the same objective, wavelength, emitter
    and window.

    References
    ----------
    J. J. M. Braat, P. Dirksen, A. J. E. M. Janssen and A. S. van de Nes, J. Opt. Soc. Am. A 20, 2281 (2003):
    fields by orders of the azimuth.
    """

    tol: float = 1e-6

    def _samples(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Samples:
        peak = likely_peak(pupil) / 4.0
        # Division of values by the largest value doubles the error, and adds a second rounding error.
        factor = 2.0 if wanted.scale is None else 1.0
        allowed = max(tol, LEAST) / factor - 2.0 * storing(wanted.dtype)
        while True:
            # Powers of two, so that similar tolerances share interpolation weights (taps) and angles.
            errors = (allowed * math.sqrt(peak) / 8.0, allowed * peak, allowed / 100.0)
            accuracy = Accuracy(*(2.0 ** math.floor(math.log2(error)) for error in errors))
            images = ringed(pupil, grid, accuracy, wanted)
            assert images.error is not None
            if (worst_error := float(images.error.max())) <= tol:
                return images
            if accuracy.field <= LEAST:
                raise not_met(self.tol, worst_error, "the peak")
            # The peak is lower than estimated, or the bound is less tight: reduce the errors.
            peak, allowed = peak * 0.25, allowed * max(1e-6, min(0.5, 0.5 * tol / worst_error))


def ringed(pupil: ObjectivePupil, grid: Grid, accuracy: Accuracy, wanted: Wanted) -> Samples:
    """Return images computed with these allowed errors, and error bounds: certificate, section 16."""
    step, light, n = grid.step(pupil), pupil.light, pupil.depth.size
    band, radial = _radial_taps(accuracy.radial)
    # Circles up to the farthest pixel, and a margin for the interpolation weights (taps) and the filter.
    circles = math.ceil(grid._farthest * step / (0.5 * band)) + radial.taps.size // 2 + radial.filter.size + 2
    assert pupil.aberrations is not None
    wavefront = pupil.aberrations.flattened()
    terms = tuple(wavefront.amplitudes().items())
    depth, focus, reach = pupil.depth.ravel(), pupil.focus.ravel(), 0.5 * band * (circles - 1)
    rule = debye.rule(
        pupil.layers, light.model, depth, focus, reach, accuracy.field, lambda piece: projection.growth(piece, terms)
    )
    rows = squares(light.waves.form)
    values = np.empty((n, *grid.shape), wanted.dtype) if wanted.out is None else wanted.out
    scales = np.ones(n) if wanted.scale is None else np.broadcast_to(wanted.scale, n)
    axes = grid.axes
    errors, peaks, tops = np.empty((3, n))
    separate = wavefront.shape[0] > 1
    # Stacks with a wavefront for each plane are computed in parts, so that the pupil functions fit into memory.
    block_size = max(8, _PARTS // (len(rows) * rule.rho.size * 100) // 8 * 8) if separate else n
    for part in (slice(k, min(k + block_size, n)) for k in range(0, n, block_size)):
        orders, omitted = projection.components(
            wavefront[part] if separate else wavefront, terms, rule, 0.1 * accuracy.field
        )
        # The order of a field is the sum of an order of the wavefront and the order of an emitter's wave.
        shift = max(map(abs, light.waves.orders))
        max_order = orders.shape[1] // 2 + shift
        # The orders of the intensity are up to twice those of a field; this number of angles separates the orders.
        angles = fft_length(4 * max_order + 1)
        angular = interpolation.circular_taps(2 * max_order, 2 * angles, max(accuracy.angular, _MIN_ERROR))
        waves = rule.waves(depth[part], focus[part])
        sums = Rings(
            bessel=_bessel(rule.rho.tobytes(), 0.5 * band, circles, max_order + 1),
            parts=_fields(light.waves, rows, rule.parts, orders, shift),
            waves=np.ascontiguousarray(waves),
            power=pupil.power[part],
            angles=angles,
            filter=radial.filter,
            radial=radial.taps.polynomials,
            angular=angular.taps.polynomials,
            taps=(radial.taps.size, angular.taps.size),
            gains=np.stack([angular.gains, angular.errors]),
        )
        window = Window(grid.shape, axes[part] if len(axes) > 1 else axes, step / (0.5 * band))
        sampled = ringed_images(sums, window, scales[part], wanted.threads, values[part])
        size = max(float(np.abs(integrand).sum()) for integrand in rule.parts)
        # Quadrature, omitted orders, and roundings of the transform over angles (section 16, "Rounding").
        field_error = rule.error + omitted + 64.0 * math.sqrt(angles) * _ROUNDING * size
        field_errors = field_error * np.abs(rows).sum(axis=1)[:, None] / np.sqrt(sums.power)
        by_circles = _circle_error(sampled, field_errors, max_order, angles)
        errors[part] = _pixel_error(sampled, by_circles, radial, angular, angles)
        peaks[part] = np.maximum(sampled.top - by_circles, sampled.pixel - errors[part])
        tops[part] = sampled.pixel
    relative = np.divide(errors, peaks, out=np.full(peaks.shape, np.inf), where=peaks > 0.0)
    if wanted.scale is None:
        if not np.all(tops > 0.0):
            raise ValueError('normalize="peak" is impossible: no light falls into the window')
        scales = 1.0 / tops
        np.multiply(values, scales[:, None, None], out=values, casting="same_kind")
        relative = stored(normalized_error(relative), wanted.dtype)
    return Samples(values, scales, stored(relative, wanted.dtype), None, peaks)


def _circle_error(sampled: Ringed, field_errors: Array, max_order: int, angles: int) -> Array:
    """Bound the error of the intensity at any angle of a circle, from the errors of fields, shape (fields, n)."""
    # Between angles a field is at most 1 / cos(pi max_order / angles) times its maximum (Ehlich and Zeller).
    largest = np.sqrt(sampled.squares) / math.cos(math.pi * max_order / angles)
    return np.asarray((field_errors * (2.0 * largest + field_errors)).sum(axis=0))


def _pixel_error(
    sampled: Ringed,
    error: Array,
    radial: interpolation.FilteredTaps,
    angular: interpolation.CircularTaps,
    angles: int,
) -> Array:
    """Bound the error of pixels: interpolation between and around circles, errors of intensities, rounding."""
    sizes = sampled.sums + float(np.abs(radial.filter).sum()) * sampled.top
    # Section 16, "Rounding".
    units = 64.0 * math.sqrt(2 * angles) + 2 * radial.filter.size + 64
    interpolated = sampled.aliases + units * _ROUNDING * angular.taps.gain * sizes
    return np.asarray(radial.error + radial.gain * error + radial.taps.gain * interpolated)


@lru_cache(maxsize=64)
def _radial_taps(error: float) -> tuple[float, interpolation.FilteredTaps]:
    band, least = next((choice for choice in _BANDS if error >= choice.least), _BANDS[-1])
    return band, interpolation.filtered_taps(band, max(error, least))


def squares(form: Complex) -> Complex:
    """Return rows T with ``sum_ab form[a, b] U_a conj(U_b) = sum_c abs(sum_a T[c, a] U_a)^2``."""
    if not np.any(form - np.diag(np.diag(form))):
        rows = np.diag(np.sqrt(np.diag(form).astype(np.complex128)))
    else:
        # A Hermitian form is a sum of squares of its eigenvectors; negative eigenvalues are rounding errors.
        eigenvalues, vectors = np.linalg.eigh(form)
        rows = np.sqrt(np.maximum(eigenvalues, 0.0))[:, None] * vectors.T
    return np.asarray(rows[np.abs(rows).max(axis=1) > 1e-14])


def _fields(
    waves: Waves, rows: Complex, parts: Sequence[Complex], orders: Complex, shift: int
) -> NDArray[np.complex128]:
    """Return the integrands of each azimuthal order of the fields, shape (wavefronts, orders, fields, nodes)."""
    integrands = np.zeros((len(orders), orders.shape[1] + 2 * shift, len(rows), orders.shape[2]), np.complex128)
    for c, row in enumerate(rows):
        for coefficient, q, j in zip(row, waves.orders, waves.parts, strict=True):
            if coefficient:
                integrands[:, shift + q : shift + q + orders.shape[1], c] += coefficient * parts[j] * orders
    # Factor (-i)^abs(m + q) of each order: certificate, section 16, first equation.
    phases = (-1j) ** np.abs(np.arange(integrands.shape[1]) - integrands.shape[1] // 2)
    integrands *= phases[:, None, None]
    return integrands


@lru_cache(maxsize=2)
def _bessel(rho: bytes, spacing: float, count: int, orders: int) -> Array:
    """Return J_n at the products of rho and the radii of circles `spacing` apart, shape (orders, circles, nodes)."""
    arguments = np.multiply.outer(spacing * np.arange(count), np.frombuffer(rho))
    bessel = bessel_sequence(arguments.ravel(), orders).reshape(*arguments.shape, orders)
    return np.ascontiguousarray(np.moveaxis(bessel, -1, 0))
