r"""Amplitudes of a microscope's pupil as truncated series of Zernike polynomials.

Over a disc, what the series leaves out is orthogonal to polynomials up to its degree, and in a small window the
kernel and a measured wavefront nearly are such polynomials: the kink of amplitude and phase at the critical angle is
integrated without nodes near it. Coefficients are integrals over the angles of :mod:`lommel.optics.layers.debye`,

.. math:: c_n = 2 (n + 1) \int_0^1 t(\rho) R_n^q(\rho) \rho \, d\rho , \quad n = q, q + 2, \dots, D .
"""

from __future__ import annotations

import itertools
import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.optics.layers import debye
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.layers.quadrature_bounds import Complex, Model, Piece
from lommel.optics.layers.stratified import Layers
from lommel.special import zernike

_LEAST_DEPTH, _LEAST_FOCUS = 1e-6, 1e-6


class Amplitudes(NamedTuple):
    """Series of the amplitudes of some planes, and a bound on what their errors add to a field."""

    coefficients: Complex  # (1 + rates, planes, terms), those of all parts
    error: float  # by the quadrature of coefficients, and rounding


def degrees(order: int, degree: int) -> NDArray[np.int64]:
    """Return n of the terms of an azimuthal order up to a degree, one at the least."""
    return np.arange(order, max(degree, order) + 1, 2, dtype=np.int64)


def amplitudes(pupil: ObjectivePupil, degree: int, error: float, rates: tuple[int, ...] = ()) -> Amplitudes:
    """Return the amplitudes of the flattened planes of a `pupil`, half of the parts of its model times the wave.

    By integrals over the angles, the sum of which is off by `error` at most. Further series are those of derivatives,
    0 for that by depth and 1 for that by focus, less a phase that all fields share, over :func:`steepest`.
    """
    depth, focus = pupil.depth.ravel(), pupil.focus.ravel()
    model = pupil.light.model
    rule, integrals = _integrals(pupil.layers, model, *_box(pupil.layers, depth, focus), degree, error)
    waves = rule.waves(depth, focus)
    # So small a matrix product takes a threaded BLAS as long as its threads take to wake up.
    found = np.einsum("pq,kqt->kpt", waves, integrals[[0, *(1 + rate for rate in rates)]])
    return Amplitudes(found, (degree + 2.0) * _each(error, degree) + 4.0 * rule.rounding)


def by_part(coefficients: Complex, orders: tuple[int, ...], degree: int) -> list[Complex]:
    """Return the coefficients of each part."""
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


@lru_cache(maxsize=16)
def _integrals(
    layers: Layers,
    model: Model,
    depth: tuple[float, float],
    focus: tuple[float, float],
    degree: int,
    error: float,
) -> tuple[debye.Rule, Complex]:
    """Return a rule for a range of depths, and of focus less that of paraxial rays, and weights of its angles.

    These make coefficients of waves, of all parts side by side, and those of the derivatives by depth and by focus.
    """
    middle, steep = layers.middle_rates()[1:], steepest(layers, model)

    def growth(piece: Piece) -> Array:
        # R_n^m(rho) is a mean of U_n(rho cos(alpha)), at most n + 1 times exp(n b), rho within the ellipse of b.
        square = piece.covered.square * layers.NA**-2
        size = np.abs(square.centre) + np.abs(square.centre - 1.0) + 2.0 * square.radius
        turned = [
            (rate - least).largest / most
            for rate, least, most in zip(piece.covered.rates[1:], middle, steep, strict=True)
        ]
        grown = math.log(degree + 4.0) + 0.5 * (degree + 3.0) * np.arccosh(np.maximum(size, 1.0))
        return np.asarray(grown + np.log(np.maximum(1.0, np.max(turned, axis=0))))

    # The phase is linear in both: the corners bound all.
    corners = [(d, f + layers.immersion / layers.sample * d) for d in depth for f in focus]
    d, f = np.array(corners).T
    rule = debye.rule(layers, model, d, f, 0.0, _each(error, degree), growth)
    weights = [
        (part * ((n + 1.0) * zernike.radial(int(n), order, rule.rho)))
        for order, part in zip(model.orders, rule.parts, strict=True)
        for n in degrees(order, degree)
    ]
    factors = [1j * (rate - least) / most for rate, least, most in zip(rule.rates[1:], middle, steep, strict=True)]
    plain = np.stack(weights, axis=1)
    return rule, np.ascontiguousarray([plain, *(factor[:, None] * plain for factor in factors)])


def _box(layers: Layers, depth: Array, focus: Array) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return a range of depths and one of focus less that of paraxial rays, widened so that others share them."""
    off = focus - layers.immersion / layers.sample * depth

    def widened(values: Array, least: float) -> tuple[float, float]:
        step = 0.25 * 2.0 ** math.ceil(math.log2(max(float(np.abs(values).max()), least)))
        return step * math.floor(float(values.min()) / step), step * math.ceil(float(values.max()) / step)

    return widened(depth, _LEAST_DEPTH), widened(off, _LEAST_FOCUS)
