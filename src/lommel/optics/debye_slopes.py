r"""Derivatives of the integrals over a microscope's light: the same angles with factors, and what these err by.

By the depth, by the focus and by v the factors are ``i d psi / dx`` and ``rho J_m'(v rho)``. All phases are
proportional to the wavenumber k, so that by ln k the factor is ``i psi``; a real constant in psi turns all fields
alike, and is left out. The amplitudes along s and p change with k, too, where there are films.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.optics.debye import Rule, films
from lommel.optics.pupil_pieces import ETA, At, Complex, Covered, Model, Piece, enclosed, extremes, pieces
from lommel.optics.stratified import Layers
from lommel.special.legendre import gauss_legendre


class Turning(NamedTuple):
    """What fields of a :class:`Rule` change by with ln k at fixed v.

    Attributes
    ----------
    rates : ndarray of complex, shape (3, q)
        As those of the rule, each less a constant.
    changes : ndarray of complex, shape (parts, q), or None
        Of the parts themselves.
    """

    rates: Complex
    changes: Complex | None


def turning(found: Rule, layers: Layers, model: Model) -> Turning:
    """Return what the fields of a rule change by."""
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
    """Return what a :func:`lommel.optics.debye.rule` for these arguments errs by in derivatives.

    By the depth, the focus, v, and ln k at fixed v.
    """
    share = tol / len(found.counts)
    each = [
        _of_piece(piece, model, depth, focus, v, share, n)
        for piece, n in zip(pieces(layers, model), found.counts, strict=True)
    ]
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
    """Return what the factors of derivatives by depth, focus and ln k are at most in the pupil, less a real constant.

    An analytic function is largest on the border of an ellipse around a piece of the pupil; discs cover that.
    """
    found = np.zeros(3)
    middle = layers.middle_rates()
    for piece in pieces(layers, model):
        row = next(row for row in range(ETA.size) if enclosed(piece, model, (row,))[0].fit[0])
        covered, _ = enclosed(piece, model, (row,))
        rates = [(rate - least).largest for rate, least in zip(covered.rates[1:], middle[1:], strict=True)]
        found = np.maximum(
            found, [*(each.max() for each in rates), _phases(piece, model, covered, depth, focus).max()]
        )
    return float(found[0]), float(found[1]), float(found[2])


def _of_piece(
    piece: Piece, model: Model, depth: Array, focus: Array, v: float, error: float, n: int
) -> tuple[float, ...]:
    """Return what n nodes of a piece, which serve to `error`, err by at most."""
    growth = piece.serving(model, depth, focus, v, error)
    rows = tuple(int(row) for row in np.flatnonzero(np.isfinite(growth)))
    covered, _ = enclosed(piece, model, rows)
    _, by_depth, by_focus = covered.rates
    # abs(dJ_m(v rho)/dv) <= abs(rho) exp(v abs(Im rho)), and other factors are those of the phase.
    rho = np.sqrt(covered.at.square.largest) / piece.layers.NA
    factors = by_depth.largest, by_focus.largest, rho, _phases(piece, model, covered, depth, focus)
    proven = (piece.constant() - 2.0 * n * ETA + growth)[list(rows)]
    return tuple(float(np.exp((proven + np.log(each.max(axis=-1))).min())) for each in factors)


def _phases(piece: Piece, model: Model, covered: Covered, depth: Array, focus: Array) -> Array:
    """Return what bounds the derivatives by ln k over the integrands on each disc."""
    psi, middle = np.zeros(covered.at.square.radius.shape), piece.layers.middle_rates()
    for d, f in extremes(depth, focus):
        centre, radius = np.zeros(psi.shape, np.complex128), np.zeros(psi.shape)
        for by, rate, least in zip((1.0, d, f), covered.rates, middle, strict=True):
            centre = centre + by * (rate.centre - least)
            radius = radius + abs(by) * rate.radius
        psi = np.maximum(psi, (np.abs(centre) + radius) * (1.0 + 1e-12))
    if films(piece.layers, model):
        of_s, of_p = piece.layers.log_slopes(covered.at, covered.at.square)
        psi = psi + np.maximum(of_s.largest, of_p.largest)
    return psi
