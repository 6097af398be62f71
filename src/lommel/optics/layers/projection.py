r"""Amplitudes of a microscope's pupil as truncated series of Zernike polynomials.

Over a disc, what the series leaves out is orthogonal to polynomials up to its degree, and in a small window the
kernel and a measured wavefront nearly are such polynomials: the kink of amplitude and phase at the critical angle is
integrated without nodes near it. Coefficients are integrals over the angles of :mod:`lommel.optics.layers.debye`,

.. math:: c_n = 2 (n + 1) \int_0^1 t(\rho) R_n^q(\rho) \rho \, d\rho , \quad n = q, q + 2, \dots, D .
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core import engine
from lommel.optics.layers import debye
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.layers.quadrature_bounds import Complex, Model, Piece
from lommel.optics.layers.stratified import Layers
from lommel.special import zernike

_Number = TypeVar("_Number", np.float64, np.complex128)
_LEAST_DEPTH, _LEAST_FOCUS = 1e-6, 1e-6


WAVENUMBER = engine.BY_WAVENUMBER


class Amplitudes(NamedTuple):
    """Series of the amplitudes of some planes, and a bound on what their errors add to a field."""

    coefficients: Complex  # (1 + rates, planes, terms), those of all parts
    error: float  # by the quadrature of coefficients, and rounding
    steepest: float  # what the series of the derivative by ln k is divided by


class _Integrals(NamedTuple):
    """A rule for some depths and stages, and the weights that its angles have in coefficients."""

    rule: debye.Rule
    weights: Complex  # (3, angles, terms), those of derivatives by depth and focus last
    changes: Complex | None  # (angles, terms), by ln k, where there are films
    steepest: float  # the bound on derivatives by ln k, where these are asked for


def degrees(order: int, degree: int) -> NDArray[np.int64]:
    """Return n of the terms of an azimuthal order up to a degree, one at the least."""
    return np.arange(order, max(degree, order) + 1, 2, dtype=np.int64)


def amplitudes(pupil: ObjectivePupil, degree: int, error: float, rates: tuple[int, ...] = ()) -> Amplitudes:
    """Return the amplitudes of the flattened planes of a `pupil`, half of the parts of its model times the wave.

    By integrals over the angles, the sum of which is off by `error` at most. Further series are those of derivatives,
    0 for that by depth, 1 for that by focus and :data:`WAVENUMBER` for that by ln k at fixed v, less a phase that all
    fields share, over :func:`steepest` or the bound that is returned.
    """
    depth, focus = pupil.depth.ravel(), pupil.focus.ravel()
    layers, model = pupil.layers, pupil.light.model
    by_k = WAVENUMBER in rates
    made = _integrals(layers, model, *_box(layers, depth, focus), degree, error, by_k=by_k)
    waves = made.rule.waves(depth, focus)
    # So small a matrix product takes a threaded BLAS as long as its threads take to wake up.
    found = np.empty((1 + len(rates), len(waves), made.weights.shape[2]), np.complex128)
    for k, rate in enumerate((-1, *rates)):
        np.einsum("pq,qt->pt", waves, made.weights[1 + rate if rate < 2 else 0], out=found[k])
    if by_k:
        fixed, by_depth, by_focus = debye.turning(made.rule, layers, model).rates
        turned = 1j * waves * (fixed + np.outer(depth, by_depth) + np.outer(focus, by_focus))
        total = np.einsum("pq,qt->pt", turned, made.weights[0])
        if made.changes is not None:
            total += np.einsum("pq,qt->pt", waves, made.changes)
        found[1 + rates.index(WAVENUMBER)] = total / made.steepest
    return Amplitudes(found, (degree + 2.0) * _each(error, degree) + 4.0 * made.rule.rounding, made.steepest)


def by_part(coefficients: NDArray[_Number], orders: tuple[int, ...], degree: int) -> list[NDArray[_Number]]:
    """Return the coefficients of each part, or their moduli."""
    ends = np.cumsum([0, *(degrees(order, degree).size for order in orders)])
    return [coefficients[..., low:high] for low, high in itertools.pairwise(ends)]


@lru_cache(maxsize=32)
def norm(layers: Layers, model: Model) -> float:
    """Bound ``(2 int abs(t)^2 rho drho)^(1/2)`` of all parts at any depth: next to the glass nothing has faded."""
    return math.sqrt(float(debye.power(layers, np.zeros(1), model)[0].max())) * (1.0 + 1e-12)


@lru_cache(maxsize=32)
def steepest(layers: Layers, model: Model) -> tuple[float, float]:
    """Bound the derivatives of the phase by depth and by focus in the pupil, less their middle."""
    return debye.steepest(layers, model, np.zeros(1), np.zeros(1))[:2]


def _each(error: float, degree: int) -> float:
    """Return what each integral may be off by: by Bessel's inequality these add up to degree + 2 times as much."""
    return float(2.0 ** math.floor(math.log2(error / (degree + 2.0))))


@lru_cache(maxsize=48)
def _integrals(
    layers: Layers,
    model: Model,
    depth: tuple[float, float],
    focus: tuple[float, float],
    degree: int,
    error: float,
    *,
    by_k: bool,
) -> _Integrals:
    """Return a rule for a range of depths, and of focus less that of paraxial rays, and weights of its angles.

    These make coefficients of waves, of all parts side by side, and those of the derivatives by depth and by focus.
    """
    middle, steep = layers.middle_rates()[1:], steepest(layers, model)
    # The phase is linear in both: the corners bound all.
    corners = [(d, f + layers.immersion / layers.sample * d) for d in depth for f in focus]
    d, f = np.array(corners).T
    turns = max(1.0, debye.steepest(layers, model, d, f)[2]) if by_k else 1.0

    def growth(piece: Piece) -> Array:
        # R_n^m(rho) is a mean of U_n(rho cos(alpha)), at most n + 1 times exp(n b), rho within the ellipse of b.
        square = piece.covered.square * layers.NA**-2
        size = np.abs(square.centre) + np.abs(square.centre - 1.0) + 2.0 * square.radius
        turned = [
            (rate - least).largest / most
            for rate, least, most in zip(piece.covered.rates[1:], middle, steep, strict=True)
        ]
        if by_k:
            with np.errstate(invalid="ignore"):  # no disc covers some ellipses
                phases = debye.phases(piece.covered, model, d, f) / turns
            turned.append(np.where(np.isnan(phases), np.inf, phases))
        grown = math.log(degree + 4.0) + 0.5 * (degree + 3.0) * np.arccosh(np.maximum(size, 1.0))
        return np.asarray(grown + np.log(np.maximum(1.0, np.max(turned, axis=0))))

    rule = debye.rule(layers, model, d, f, 0.0, _each(error, degree), growth)
    factors = [1j * (rate - least) / most for rate, least, most in zip(rule.rates[1:], middle, steep, strict=True)]

    def weighted(parts: Sequence[Complex]) -> Complex:
        weights = [
            part * ((n + 1.0) * zernike.radial(int(n), order, rule.rho))
            for order, part in zip(model.orders, parts, strict=True)
            for n in degrees(order, degree)
        ]
        return np.stack(weights, axis=1)

    plain, changes = weighted(rule.parts), debye.turning(rule, layers, model).changes if by_k else None
    weights = np.ascontiguousarray([plain, *(factor[:, None] * plain for factor in factors)])
    return _Integrals(rule, weights, None if changes is None else weighted(tuple(changes)), turns)


def _box(layers: Layers, depth: Array, focus: Array) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return a range of depths and one of focus less that of paraxial rays, widened so that others share them."""
    off = focus - layers.immersion / layers.sample * depth
    return _widened(depth, _LEAST_DEPTH), _widened(off, _LEAST_FOCUS)


def _widened(values: Array, least: float) -> tuple[float, float]:
    low, high = (values.item(),) * 2 if values.size == 1 else (float(values.min()), float(values.max()))
    step = 0.25 * 2.0 ** math.ceil(math.log2(max(-low, high, least)))
    return step * math.floor(low / step), step * math.ceil(high / step)
