"""Debye-Wolf integrals over the angles of a microscope's light, by Gauss-Legendre quadrature with proven bounds.

References
----------
B. Richards and E. Wolf, Proc. R. Soc. Lond. A 253, 358 (1959), doi:10.1098/rspa.1959.0200.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.optics.layers.quadrature_bounds import ETA, At, Complex, Factor, Model, enclosed, extremes, pieces
from lommel.optics.layers.stratified import Layers
from lommel.special.legendre import gauss_legendre

_ROUNDOFF = 2.0**-53
_RADII = 2048  # at once


class Rule(NamedTuple):
    """A quadrature over angles: rho, the weighted parts of the model, and the phase with its depth and focus rates.

    `error` is the proven bound with an allowance for rounding, which is `rounding`; counts are nodes per section.
    """

    rho: Array
    parts: tuple[Complex, ...]
    rates: tuple[Complex, Complex, Complex]
    error: float
    rounding: float
    counts: tuple[int, ...]

    def waves(self, depth: Array, focus: Array) -> Complex:
        """Return ``exp(i psi)`` for each plane and angle, shape ``(planes, q)``."""
        fixed, by_depth, by_focus = self.rates
        phases = depth[:, None] * by_depth
        phases += focus[:, None] * by_focus
        phases += fixed
        phases *= 1j
        return np.asarray(np.exp(phases, out=phases))


def rule(
    layers: Layers, model: Model, depth: Array, focus: Array, v: float, tol: float, factor: Factor | None = None
) -> Rule:
    """Return a rule within `tol` for every part, plane and radius up to `v` = k NA r.

    `factor` bounds, as a log on each disc around a section, a further analytic factor of the integrands.
    """
    rhos, parts, rates, counts = [], [], [], []
    cut = pieces(layers, model)
    for piece in cut:
        n = piece.enough(model, depth, focus, v, tol / len(cut), factor)
        counts.append(n)
        x, w = gauss_legendre(n, piece.low, piece.high)
        at = At(piece, x)
        rhos.append(np.sqrt(at.square) / layers.NA)
        parts.append([w * part for part in piece.parts(at, model)])
        rates.append(at.rates)
    rho = np.concatenate(rhos)
    joined = tuple(np.concatenate(each) for each in zip(*parts, strict=True))
    fixed, by_depth, by_focus = (np.concatenate(each) for each in zip(*rates, strict=True))
    paths = sum(index * abs(thickness) for index, thickness in layers.paths)
    reach = layers.sample * depth.max(initial=0.0) + layers.immersion * np.abs(focus).max(initial=0.0) + paths
    size = max(float(np.abs(part).sum()) for part in joined)
    rounding = (4.0 * layers.wavenumber * reach + 4.0 * v + 2.0 * math.sqrt(rho.size) + 64.0) * _ROUNDOFF * size
    return Rule(rho, joined, (fixed, by_depth, by_focus), float(tol + rounding), rounding, tuple(counts))


def fields(rule: Rule, model: Model, depth: Array, focus: Array, v: Array) -> tuple[Complex, ...]:
    """Return each part in each plane at each v, shape ``(planes, radii)``."""
    from scipy.special import jv

    waves = rule.waves(depth, focus)
    found = tuple(np.empty((depth.size, v.size), np.complex128) for _ in model.orders)
    for start in range(0, v.size, _RADII):
        arguments = np.multiply.outer(rule.rho, v[start : start + _RADII])
        for order, part, values in zip(model.orders, rule.parts, found, strict=True):
            values[:, start : start + _RADII] = (waves * part) @ jv(order, arguments)
    return found


def power(layers: Layers, depth: Array, model: Model | None = None, *, by: str | None = None) -> tuple[Array, Array]:
    """Return the light of each part, near and far from the glass, over ``4 pi / (k NA)^2``, or a derivative.

    Rules of twice as many angles until two agree to 1e-13; `by` is "depth" or "wavenumber" (ln k).
    """
    model = model or Model()
    before = np.full((1, 1), -1.0)
    for n in (32 * 2**k for k in range(9)):
        steady, fading, faint, steady_change, faint_change = _collected(layers, model, n)
        left = np.exp(np.outer(depth, fading))
        all_light = left @ faint + steady
        near, far = all_light, steady
        if by is not None:
            near, far = left @ (faint * fading[:, None]), 0.0 * far
        if by == "wavenumber":
            near = depth[:, None] * near + left @ faint_change + steady_change
            far = steady_change
        # A derivative need not be more exact than what it is one of.
        size = all_light if by is None else all_light + np.abs(near)
        if (np.abs(near - before) <= 1e-13 * size.sum(axis=1, keepdims=True)).all():
            break
        before = near
    return near, far


@lru_cache(maxsize=64)
def _collected(layers: Layers, model: Model, n: int) -> tuple[Array, Array, Array, Array, Array]:
    """Return the light of each part by n angles: what reaches any depth, decay rates and the light that decays.

    Derivatives of both lights by ln k are last.
    """
    parts = len(model.orders)
    steady, steady_change = np.zeros(parts), np.zeros(parts)
    fading, faint, faint_change = np.zeros(0), np.zeros((0, parts)), np.zeros((0, parts))
    for piece in pieces(layers, model):
        x, w = gauss_legendre(n, piece.low, piece.high)
        at = At(piece, x)
        measure = (w / (2.0 * piece.jacobian(x)))[:, None]
        of = np.stack(piece.parts(at, model), axis=1)
        light: Array = measure * np.abs(of) ** 2
        change: Array = np.zeros(of.shape)
        if films(layers, model):
            change = measure * 2.0 * (of.conj() * np.stack(piece.changes(at, model), axis=1)).real
        if piece.above:
            fading, faint, faint_change = -2.0 * at.rates[1].imag, light, change
        else:
            steady += light.sum(axis=0)
            steady_change += change.sum(axis=0)
    return steady, fading, faint, steady_change, faint_change


def films(layers: Layers, model: Model) -> bool:
    """Return whether amplitudes depend on the wavelength."""
    return bool(layers.films) and model.transmits


# By the depth, by the focus and by v the factors are ``i d psi / dx`` and ``rho J_m'(v rho)``. All phases are
# proportional to the wavenumber k, so that by ln k the factor is ``i psi``; a real constant in psi turns all fields
# alike, and is left out. The amplitudes along s and p change with k, too, where there are films.


class Turning(NamedTuple):
    """Factors of the derivatives by ln k at fixed v: rates of the phase less a constant, changes of the parts."""

    rates: Complex
    changes: Complex | None


def turning(found: Rule, layers: Layers, model: Model) -> Turning:
    """Return the factors of the derivatives of a rule by ln k."""
    rates = np.stack(found.rates) - np.array(layers.middle_rates())[:, None]
    if not films(layers, model):
        return Turning(rates, None)
    changes = []
    for piece, n in zip(pieces(layers, model), found.counts, strict=True):
        x, w = gauss_legendre(n, piece.low, piece.high)
        changes.append(w * np.stack(piece.changes(At(piece, x), model)))
    return Turning(rates, np.concatenate(changes, axis=1))


def slope_errors(
    found: Rule, layers: Layers, model: Model, depth: Array, focus: Array, v: float, tol: float
) -> tuple[float, float, float, float]:
    """Bound the errors of a rule in derivatives by the depth, the focus, v, and ln k at fixed v."""
    each = []
    for piece, n in zip(pieces(layers, model), found.counts, strict=True):
        growth = piece.serving(model, depth, focus, v, tol / len(found.counts))
        rows = tuple(int(row) for row in np.flatnonzero(np.isfinite(growth)))
        covered, _ = enclosed(piece, model, rows)
        _, by_depth, by_focus = covered.rates
        # abs(dJ_m(v rho)/dv) <= abs(rho) exp(v abs(Im rho)), and other factors are those of the phase.
        rho = np.sqrt(covered.square.largest) / layers.NA
        factors = by_depth.largest, by_focus.largest, rho, phases(covered, model, depth, focus)
        proven = (piece.constant() - 2.0 * n * ETA + growth)[list(rows)]
        each.append([float(np.exp((proven + np.log(factor.max(axis=-1))).min())) for factor in factors])
    by_k = turning(found, layers, model)
    phase = max(float(np.abs(by_k.rates.T @ (1.0, d, f)).max()) for d, f in extremes(depth, focus))
    if by_k.changes is not None:
        phase += max(float(np.abs(part).sum()) for part in by_k.changes) / max(
            float(np.abs(part).sum()) for part in found.parts
        )
    largest = *(float(np.abs(rate).max()) for rate in found.rates[1:]), 1.0, 1.0 + phase
    sums = [sum(part) + found.rounding * size for part, size in zip(zip(*each, strict=True), largest, strict=True)]
    return sums[0], sums[1], sums[2], sums[3]


def steepest(layers: Layers, model: Model, depth: Array, focus: Array) -> tuple[float, float, float]:
    """Bound the factors of derivatives by depth, focus and ln k in the pupil, on ellipses around it."""
    found = np.zeros(3)
    middle = layers.middle_rates()
    for piece in pieces(layers, model):
        row = next(row for row in range(ETA.size) if enclosed(piece, model, (row,))[0].fit[0])
        covered, _ = enclosed(piece, model, (row,))
        rates = [(rate - least).largest for rate, least in zip(covered.rates[1:], middle[1:], strict=True)]
        found = np.maximum(found, [*(each.max() for each in rates), phases(covered, model, depth, focus).max()])
    return float(found[0]), float(found[1]), float(found[2])


def phases(covered: At, model: Model, depth: Array, focus: Array) -> Array:
    """Bound the derivatives by ln k over the integrands on each disc."""
    layers, psi = covered.piece.layers, np.zeros(covered.square.radius.shape)
    for d, f in extremes(depth, focus):
        centre, radius = np.zeros(psi.shape, np.complex128), np.zeros(psi.shape)
        for by, rate, least in zip((1.0, d, f), covered.rates, layers.middle_rates(), strict=True):
            centre = centre + by * (rate.centre - least)
            radius = radius + abs(by) * rate.radius
        psi = np.maximum(psi, (np.abs(centre) + radius) * (1.0 + 1e-12))
    if films(layers, model):
        of_s, of_p = layers.log_slopes(covered, covered.square)
        psi = psi + np.maximum(of_s.largest, of_p.largest)
    return psi
