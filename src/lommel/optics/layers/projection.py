r"""Series of a microscope's pupil function: Zernike series of amplitudes, azimuthal Fourier series of aberrations.

The error of a Zernike series truncated at degree D is orthogonal to all polynomials of degree at most D. In a small
window the other factors of the integrand (the Fourier kernel and the aberrations) are nearly such a polynomial. The
truncation error therefore hardly changes the field, in spite of the kink of the amplitude at the critical angle. The
rules of :mod:`lommel.optics.layers.debye` compute the coefficients

.. math:: c_n = 2 (n + 1) \int_0^1 t(\rho) R_n^q(\rho) \rho \, d\rho , \quad n = q, q + 2, \dots, D .
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.optics.layers import debye
from lommel.optics.layers.debye import Complex, Model, Piece, Rule
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.layers.stratified import Layers
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special import zernike

DEGREE_MOST = 30  # largest n: rounding errors of radial polynomials in powers of rho^2 grow like 5.8^(n / 2)
_ORDERS_MOST = 250  # largest azimuthal Fourier order
_HEIGHTS = np.geomspace(1e-2, 6.0, 200)  # values of b > 0 in the bound on Fourier orders
Sizes = tuple[tuple[tuple[int, int], float], ...]
"""((n, m), w) of terms with m >= 0; w is the largest ``sqrt(cosine^2 + sine^2)`` in a stack, radians at the edge."""


# Azimuthal Fourier orders of aberrations W: ``P = exp(i W) = sum_m P_m(rho) exp(i m theta)``. At the complex azimuth
# theta + i b a term of order m and size w has an imaginary part of at most ``w sinh(m b)``. Hence ``abs(P_m(rho)) <=
# exp(sum_j w_j sinh(m_j b) - abs(m) b)`` for any b > 0 and rho from 0 to 1. At complex rho ``abs(P) <= exp(sum_j w_j
# abs(Im R_j(rho)))``: docs/certificate.md, section 16, "Angles of the pupil" and "Nodes".


class Orders(NamedTuple):
    """Fourier orders -most to most, computed at `angles` equally spaced angles.

    `error` bounds the sum of the moduli of omitted orders and aliases.
    """

    most: int
    angles: int
    error: float


def checked(wavefront: Wavefront | None) -> Wavefront | None:
    """Return aberrations if they are supported, None if they are None or zero; else TypeError or ValueError."""
    validation.optional("aberrations", wavefront, Wavefront)
    if wavefront is None or wavefront.flat:
        return None
    for (n, m), c in wavefront.edge_terms().items():
        if n > DEGREE_MOST and np.any(c):
            raise ValueError(f"aberrations must have terms up to degree {DEGREE_MOST}, got (n, m) = ({n}, {m})")
    return wavefront


@lru_cache(maxsize=64)
def orders(terms: Sizes, error: float) -> Orders:
    """Return the fewest orders whose :attr:`Orders.error` is at most `error`; ValueError if there are too many."""
    # S(b) of docs/certificate.md, section 16, "Angles of the pupil".
    strip = sum((w * np.sinh(m * _HEIGHTS) for (_, m), w in terms), np.zeros(_HEIGHTS.shape))

    def omitted(m: int) -> float:
        """Return a bound on the sum of abs(P_k) over all orders with abs(k) > m."""
        if not strip.any():
            return 0.0
        exponent = strip - (m + 1) * _HEIGHTS - np.log(-np.expm1(-_HEIGHTS))
        return 2.0 * math.exp(min(float(exponent.min()), 700.0))

    for most in range(_ORDERS_MOST + 1):
        if omitted(most) <= 0.5 * error:
            # Order m is aliased with the orders m + k angles, of which the lowest is angles - most = most + 2.
            return Orders(most, 2 * most + 2, omitted(most) + omitted(most + 1))
    largest = max(terms, key=lambda term: term[0][1] * term[1])
    raise ValueError(
        f"aberrations must be smaller: they have more than {_ORDERS_MOST} orders of the azimuth; the largest term, "
        f"(n, m) = {largest[0]}, has {largest[1] / (2.0 * math.pi):.3g} waves at the edge"
    )


def samples(wavefront: Wavefront, rho: Array, fourier: Orders) -> NDArray[np.complex128]:
    """Return P_m(rho) of the flattened stack, shape ``(n, 2 most + 1, len(rho))``, m from -most to most."""
    # A discrete Fourier transform over the azimuth at each rho.
    theta = 2.0 * np.pi / fourier.angles * np.arange(fourier.angles)
    phases = wavefront.flattened().phase(np.minimum(rho[:, None], 1.0), theta)
    coefficients = np.fft.fft(np.exp(1j * phases), axis=-1) / fourier.angles
    return np.moveaxis(coefficients[..., np.arange(-fourier.most, fourier.most + 1)], -1, 1)


def components(wavefront: Wavefront, terms: Sizes, rule: Rule, error: float) -> tuple[NDArray[np.complex128], float]:
    """Return P_m at the nodes of a rule, m from -most to most, and a bound on the resulting error of the fields.

    `most` is the smallest one for which the omitted orders add at most `error` to the fields.
    """
    size = max(float(np.abs(part).sum()) for part in rule.parts)
    fourier = orders(terms, 0.01 * error / size)
    coefficients = samples(wavefront, rule.rho, fourier)
    # orders() is valid for all radii; at the nodes of the rule fewer orders may suffice (certificate, section 16).
    # `pair_bounds` bounds the contribution of orders m and -m, `omitted` that of all orders above m.
    weights = np.abs(np.stack(rule.parts))
    pair_bounds = (np.abs(coefficients) @ weights.T).max(axis=-1)
    pair_bounds = (pair_bounds + pair_bounds[:, ::-1])[:, fourier.most :].max(axis=0)
    omitted = np.append(np.cumsum(pair_bounds[::-1])[::-1], 0.0)[1:]
    most = int(np.flatnonzero(omitted <= error)[0])
    return coefficients[:, fourier.most - most : fourier.most + most + 1], float(omitted[most] + fourier.error * size)


@lru_cache(maxsize=16)
def growth(piece: Piece, terms: Sizes) -> Array:
    """Return the log of a bound on ``abs(exp(i W))`` at any azimuth, on each disc around a section."""
    covered = piece.covered()
    height, square = covered.height, covered.square * piece.layers.NA**-2
    root = np.sqrt(square.largest)
    total = np.zeros(height.shape)
    for (n, m), w in terms:
        middle, change = _taylor(n, m, square.centre, square.radius)
        imaginary = np.abs(middle.imag) + change
        total += w * (root * imaginary + height * (np.abs(middle) + change) if m % 2 else imaginary)
    return total


def _taylor(n: int, m: int, centre: NDArray[np.complex128], radius: Array) -> tuple[NDArray[np.complex128], Array]:
    """Return ``R_n^m`` (``R_n^m / rho`` for odd m) at centres of discs of rho^2, and its largest change in a disc."""
    # Coefficients of the radial polynomial in rho^2, exact up to n = 30.
    half_sum, low = (n + m) // 2, m // 2
    f = math.factorial
    powers = np.zeros(n // 2 + 1)
    for s in range((n - m) // 2 + 1):
        powers[(n - m) // 2 - s + low] = (-1) ** s * f(n - s) // (f(s) * f(half_sum - s) * f((n - m) // 2 - s))
    poly = np.polynomial.Polynomial(powers)
    size = np.polynomial.Polynomial(np.abs(powers))
    # Rounding errors plus the Taylor series, which bounds the change on a disc: certificate, section 16, "Nodes".
    change = 2.0**-50 * size(np.abs(centre) + radius)
    step = np.ones(radius.shape)
    slope = poly
    for k in range(1, powers.size):
        slope = slope.deriv()
        step = step * radius / k
        change = change + np.abs(slope(centre)) * step
    return np.asarray(poly(centre)), np.asarray(change)


_LEAST_DEPTH, _LEAST_FOCUS = 1e-6, 1e-6  # values of `least` in _widened() for depth and focus, metres


class Amplitudes(NamedTuple):
    """Zernike series of the amplitudes in several planes, and a bound on the error that they cause in a field."""

    coefficients: Complex  # shape (1 + derivatives, planes, terms of all parts)
    error: float  # due to quadrature of the coefficients and rounding


class _Integrals(NamedTuple):
    """Rule for a range of depths and stage positions, and the weights of its nodes in the coefficients."""

    rule: debye.Rule
    weights: Complex  # shape (3, nodes, terms): amplitudes, derivatives by depth, derivatives by focus


def degrees(order: int, degree: int) -> NDArray[np.int64]:
    """Return n of the Zernike terms of an azimuthal order with n <= degree; at least the lowest n."""
    return np.arange(order, max(degree, order) + 1, 2, dtype=np.int64)


def series_weights(model: Model, degree: int, rho: Array, parts: Sequence[Complex]) -> Complex:
    """Return the weights of nodes in the coefficients of all terms, from weighted `parts`, shape (nodes, terms)."""
    columns = [
        part * ((n + 1.0) * radial)
        for order, part in zip(model.orders, parts, strict=True)
        for n, radial in zip(degrees(order, degree), zernike.radials(order, max(degree, order), rho), strict=True)
    ]
    return np.stack(columns, axis=1)


def amplitudes(pupil: ObjectivePupil, degree: int, error: float, rates: tuple[int, ...] = ()) -> Amplitudes:
    """Return Zernike series of the amplitudes of the flattened planes of a `pupil`.

    An amplitude is half of a part of the pupil's model times ``exp(i psi)``. The sum of the errors of the
    coefficients is at most `error`. `rates` requests series of derivatives, 0 by depth and 1 by focus, without a
    phase common to all fields and divided by :func:`lommel.optics.layers.debye.steepest`.
    """
    depth, focus = pupil.depth.ravel(), pupil.focus.ravel()
    layers, model = pupil.layers, pupil.light.model
    integrals = _integrals(layers, model, *_box(layers, depth, focus), degree, error)
    waves = integrals.rule.waves(depth, focus)
    # For such small matrices einsum is faster than BLAS, which would start threads.
    series = np.empty((1 + len(rates), len(waves), integrals.weights.shape[2]), np.complex128)
    for k, rate in enumerate((-1, *rates)):
        np.einsum("pq,qt->pt", waves, integrals.weights[1 + rate], out=series[k])
    return Amplitudes(series, (degree + 2.0) * _integral_tol(error, degree) + 4.0 * integrals.rule.rounding)


@lru_cache(maxsize=32)
def norm(layers: Layers, model: Model) -> float:
    """Return the largest ``sqrt(2 int abs(t)^2 rho drho)`` of the parts t at depth 0, a bound for all depths."""
    return math.sqrt(float(debye.power(layers, np.zeros(1), model)[0].max())) * (1.0 + 1e-12)


def _integral_tol(error: float, degree: int) -> float:
    """Return the tolerance of one integral; by Bessel's inequality a sum has (degree + 2) times this error."""
    return float(2.0 ** math.floor(math.log2(error / (degree + 2.0))))


@lru_cache(maxsize=48)
def _integrals(
    layers: Layers,
    model: Model,
    depth: tuple[float, float],
    focus: tuple[float, float],
    degree: int,
    error: float,
) -> _Integrals:
    """Return a rule and weights for ranges of depth and of (focus - paraxial focus of the depth).

    The weights convert ``exp(i psi)`` at the nodes to the coefficients of all parts and of their derivatives.
    """
    middle, steep = layers.middle_rates(), debye.steepest(layers, model)
    # The phase is linear in depth and focus, so that the corners of the range (a parallelogram) bound all planes.
    corners = [(d, f + layers.immersion / layers.sample * d) for d in depth for f in focus]
    d, f = np.array(corners).T

    def growth(piece: Piece) -> Array:
        # R_n^m(rho) is a mean of Chebyshev polynomials U_n(rho cos(alpha)). Their moduli are at most
        # (n + 1) exp(n b) if rho lies within the Bernstein ellipse of parameter b.
        covered, _ = debye.enclosed(piece, model, None)
        square = covered.square * layers.NA**-2
        size = np.abs(square.centre) + np.abs(square.centre - 1.0) + 2.0 * square.radius
        factors_on_discs = [
            (rate - least).largest / most for rate, least, most in zip(covered.rates[1:], middle, steep, strict=True)
        ]
        log_bound = math.log(degree + 4.0) + 0.5 * (degree + 3.0) * np.arccosh(np.maximum(size, 1.0))
        return np.asarray(log_bound + np.log(np.maximum(1.0, np.max(factors_on_discs, axis=0))))

    rule = debye.rule(layers, model, d, f, 0.0, _integral_tol(error, degree), growth)
    factors = [1j * (rate - least) / most for rate, least, most in zip(rule.rates[1:], middle, steep, strict=True)]

    amplitude_weights = series_weights(model, degree, rule.rho, rule.parts)
    weights = [amplitude_weights, *(factor[:, None] * amplitude_weights for factor in factors)]
    return _Integrals(rule, np.ascontiguousarray(weights))


def _box(layers: Layers, depth: Array, focus: Array) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return ranges of depth and (focus - paraxial focus), rounded outwards so that similar planes share a rule."""
    offset = focus - layers.immersion / layers.sample * depth
    return _widened(depth, _LEAST_DEPTH), _widened(offset, _LEAST_FOCUS)


def _widened(values: Array, least: float) -> tuple[float, float]:
    """Return the range of values, rounded outwards to multiples of a power of 2 that is at least ``least / 4``."""
    low, high = (values.item(),) * 2 if values.size == 1 else (float(values.min()), float(values.max()))
    step = 0.25 * 2.0 ** math.ceil(math.log2(max(-low, high, least)))
    return step * math.floor(low / step), step * math.ceil(high / step)
