r"""Debye-Wolf integrals over the pupil of a microscope, by Gauss-Legendre quadrature with proven error bounds.

The range [0, 1] of the pupil radius rho is divided into sections (class `Piece`) at ``rho = n_s / NA``, the critical
angle of the sample. The variable of the section below it is x = 1 - c, with the cosine c in the layer of lowest index
n and ``rho d rho = -(n / NA)^2 c dc``. The variable of the section above is ``abs(c_s)``, with the cosine c_s in the
sample. An integrand odd in rho (radial, azimuthal and vortex beams) also has a central section with the variable rho.

Error bounds follow from Bernstein ellipses around each section. If the integrand is analytic on the ellipse of
parameter eta (no branch points of cosines, no zeros of denominators), the error of n Gauss nodes is at most
``constant exp(growth - 2 n eta)``, where exp(growth) bounds the integrand on the ellipse. This bound is computed in
disc arithmetic, on discs that cover the ellipse: docs/certificate.md, section 14.

References
----------
L. N. Trefethen, *Approximation Theory and Approximation Practice* (SIAM, 2013), chapter 19.
B. Richards and E. Wolf, Proc. R. Soc. Lond. A 253, 358 (1959), doi:10.1098/rspa.1959.0200.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.base.cached import cached_property, changed
from lommel.optics.layers.stratified import Amplitudes, Layers, Values
from lommel.special.disc_arithmetic import Disc, disc, windings
from lommel.special.legendre import gauss_legendre

ETA = np.geomspace(4e-3, 2.5, 28)
"""Parameters of the ellipses: semi-axes are cosh(eta) and sinh(eta) times half the length of the section."""
_ARCS = 1024  # number of discs that cover an ellipse
_ESTIMATE_POINTS = 24  # points of an ellipse for an estimate of the growth
_ORDERS = {"vectorial": (0, 1, 2), "scalar": (0,), "radial": (0, 1), "azimuthal": (0, 1), "vortex": (1, 2, 3)}
_ODD_KINDS = ("radial", "azimuthal", "vortex")
# End of the central section, as a value of 1 - c and as a value of rho / (n / NA). It is equally far from the
# singularities of the integrands in the central section and in the next section.
_CENTRE = 0.3
_CENTRE_RHO = math.sqrt(_CENTRE * (2.0 - _CENTRE))
Complex = NDArray[np.complex128]
Rows = tuple[int, ...] | None
"""Indices of ellipses in `ETA`; None for all ellipses."""


@dataclass(frozen=True)
class Model:
    """Kind of field integrals, called parts: vectorial (K0, K1, K2), scalar (U), radial, azimuthal or vortex.

    With `aplanatic` the amplitude is ``c_i^(-1/2)``, by the sine condition, else 1. With `supercritical` the
    integrals include light beyond the critical angle of the sample.
    """

    kind: str = "vectorial"
    aplanatic: bool = True
    supercritical: bool = True

    @property
    def orders(self) -> tuple[int, ...]:
        """Orders of the Bessel functions, one for each part."""
        return _ORDERS[self.kind]

    @property
    def transmits(self) -> bool:
        """True if the integrals include the transmission of surfaces and films."""
        return self.kind != "scalar"


class Points:
    """Cached factors of the integrands, at points x of a section or on discs that cover ellipses around it."""

    def __init__(self, piece: Piece, x: Values) -> None:
        self.piece, self.x, self.square = piece, x, piece.square(x)
        self._cosines: dict[float, Values] = {}

    def __call__(self, index: float) -> Values:
        """Return the cosine c_m in the layer of this index."""
        if index not in self._cosines:
            # The cosine of the lowest index is linear in the variable, without a square root.
            if self.piece.is_root(index):
                square = 1.0 - self.square * index**-2
                cosine = square.sqrt() if isinstance(square, Disc) else np.sqrt(square + 0.0j)
            else:
                cosine = 1j * self.x if self.piece.above else 1.0 + 0.0j - self.x
            self._cosines[index] = cosine
        return self._cosines[index]

    @cached_property
    def amplitudes(self) -> Amplitudes:
        """Transmission amplitudes of s and p waves."""
        return self.piece.layers.amplitudes(self, self.square)

    @cached_property
    def rates(self) -> tuple[Values, Values, Values]:
        """Phase at depth 0 and focus 0, and its derivatives by depth and by focus."""
        return self.piece.layers.rates(self)

    @cached_property
    def height(self) -> Array:
        """Bound on ``abs(Im rho)`` on each disc."""
        if isinstance(self.piece, Centre):
            return np.asarray(np.abs(self.x.centre.imag) + self.x.radius)
        # The smaller of two bounds on abs(Im sqrt(z)), z in a disc: docs/certificate.md, section 14, "Discs".
        square = self.square * self.piece.layers.NA**-2
        root = np.sqrt(square.centre)
        linear_bound = np.abs(root.imag) + square.radius / np.maximum(np.abs(root), 1e-300)
        return np.asarray(np.minimum(np.hypot(root.imag, np.sqrt(square.radius)), linear_bound))

    @cached_property
    def analytic(self) -> NDArray[np.bool_]:
        """True for each ellipse on which the integrands are analytic: proven if `x` is a Disc, else estimated."""
        analytic = self._cosines_analytic()
        # By the argument principle, an analytic denominator has no zero in an ellipse if its winding number is 0.
        for function in (*self.amplitudes.denominators, *([self.square] if self.piece.odd else [])):
            analytic &= windings(disc(function)) == 0
        return analytic

    def _cosines_analytic(self) -> NDArray[np.bool_]:
        """Return True for each ellipse on which cosines are finite and that contains no branch point of cosines."""
        analytic, rooted = np.ones(disc(self.x).radius.shape[:-1], np.bool_), self.piece.rooted
        for index in {*rooted, self.piece.layers.sample}:
            c = self(index)
            if isinstance(c, Disc):
                analytic &= np.isfinite(c.radius).all(axis=-1)
                # If Re c > 0 on all discs, c^(-1/2) is analytic: docs/certificate.md, section 14, "Which ellipses".
                if index in rooted:
                    analytic &= (c.centre.real > c.radius).all(axis=-1)
            elif self.piece.is_root(index):
                analytic &= ((c * c).real > 0.0).all(axis=-1)
            elif index in rooted:
                analytic &= (c.real > 0.0).all(axis=-1)
        return analytic


@dataclass(frozen=True)
class Piece:
    """Section of the pupil from `low` to `high` in the section's variable.

    `above` is True beyond the critical angle, `odd` for integrands odd in rho, whose ellipses must exclude rho = 0.
    """

    layers: Layers
    low: float
    high: float
    above: bool = False
    odd: bool = False

    @property
    def lowest(self) -> float:
        """Index of the layer whose cosine is ``1 - x``, or ``i x`` above the critical angle."""
        return min(self.layers.immersion, self.layers.glass, self.layers.sample)

    def square(self, x: Values) -> Values:
        """Return ``(NA rho)^2``."""
        return self.lowest**2 * (x * x + 1.0 if self.above else x * (2.0 - x))

    def is_root(self, index: float) -> bool:
        """Return True if the cosine in a layer is a square root, with branch points, in the variable."""
        return index != self.lowest

    def jacobian(self, x: Values) -> Values:
        """Return ``rho d rho / dx``."""
        return (x if self.above else 1.0 - x) * (self.lowest / self.layers.NA) ** 2

    def parts(self, points: Points, model: Model) -> tuple[Complex, ...]:
        """Return the factor of ``exp(i psi) J_m`` in each integrand, with the Jacobian, one for each order m."""
        t_s, t_p = points.amplitudes[:2] if model.transmits else (1.0, 1.0)
        # Radial, azimuthal and vortex beams: docs/certificate.md, section 14, "What is odd in rho".
        c_i, c_s = points(self.layers.immersion), points(self.layers.sample)
        factor = self.jacobian(points.x) * (c_i**-0.5 if model.aplanatic else 1.0 + 0.0j)
        if self.layers.exponent:
            factor = factor * np.exp(-self.layers.apodization(points.square))
        if model.kind == "scalar":
            return (2.0 * factor,)
        sine = np.sqrt(points.square) / self.layers.sample
        if model.kind == "azimuthal":
            return 0.0 * factor, 2.0 * factor * t_s
        if model.kind == "radial":
            return 2.0j * factor * t_p * sine, 2.0 * factor * t_p * c_s
        return factor * (t_s + t_p * c_s), factor * t_p * sine, factor * (t_s - t_p * c_s)

    def _ellipses(self, eta: Array, theta: Array) -> Complex:
        """Return points on the ellipses around the section, shape ``(eta, theta)``."""
        half_length = 0.5 * (self.high - self.low)
        return np.asarray(self.low + half_length * (1.0 + np.cos(theta + 1j * eta[:, None])))

    def covered(self, rows: Rows = None) -> Points:
        """Return discs that cover the ellipses with an index in `rows` (None: all)."""
        eta = ETA if rows is None else ETA[list(rows)]
        step = 2.0 * math.pi / _ARCS
        theta = (np.arange(float(_ARCS)) + 0.5) * step
        # abs(dx/dtheta)^2 / half^2 = sin^2 theta + sinh^2 eta; its maximum along an arc is the radius of its disc.
        slope = np.hypot(np.minimum(np.abs(np.sin(theta)) + 0.5 * step, 1.0), np.sinh(eta)[:, None])
        # Slightly enlarged to cover the rounding errors of centres and radii.
        radius = 0.25 * step * (self.high - self.low) * slope * (1.0 + 1e-12) + 1e-15
        return Points(self, Disc(self._ellipses(eta, theta), radius))

    @property
    def rooted(self) -> tuple[float, ...]:
        """Indices of the layers whose cosines must stay in the right half plane."""
        return self.layers.immersion, self.layers.glass

    def growth(
        self, model: Model, depth: Array, focus: Array, v: float, rows: Rows = None, factor: Array | float = 0.0
    ) -> Array:
        """Return the log of a bound on the integrands on each ellipse with an index in `rows` (None: all).

        It is infinite for all other ellipses and for ellipses with singularities. v is the largest ``k NA r``.
        `factor` is, for each disc, the log of a bound on an additional factor of the integrands.
        """
        covered, amplitude = enclosed(self, model, rows)
        phase0, by_depth, by_focus = covered.rates
        wave = np.full(covered.height.shape, -np.inf)
        with np.errstate(all="ignore"):
            for d, f in extremes(depth, focus):
                # The largest abs(exp(i psi)) = exp(-Im psi) on each disc.
                phase = phase0.centre.imag + d * by_depth.centre.imag + f * by_focus.centre.imag
                wave = np.maximum(wave, phase0.radius + d * by_depth.radius + abs(f) * by_focus.radius - phase)
            bound = (amplitude + wave + v * covered.height + factor).max(axis=-1)
        logs = np.full(ETA.shape, np.inf)
        logs[list(rows or range(ETA.size))] = np.where(covered.analytic & np.isfinite(bound), bound + 1e-9, np.inf)
        return logs

    def _estimated_growth(self, model: Model, depth: Array, focus: Array, v: float) -> Array:
        """Estimate :meth:`growth` from a few points of each ellipse, without proof, at a tenth of the cost."""
        points = Points(
            self, self._ellipses(ETA, (np.arange(float(_ESTIMATE_POINTS)) + 0.5) * (2.0 * math.pi / _ESTIMATE_POINTS))
        )
        phase0, by_depth, by_focus = points.rates
        with np.errstate(all="ignore"):
            log_size = np.log(np.max([np.abs(part) for part in self.parts(points, model)], axis=0))
            decay = np.min([(phase0 + d * by_depth + f * by_focus).imag for d, f in extremes(depth, focus)], axis=0)
            growth = (log_size - decay + v / self.layers.NA * np.abs(np.sqrt(points.square).imag)).max(axis=-1)
        return np.where(points.analytic & np.isfinite(growth), growth, np.inf)

    def proven_count(
        self, model: Model, depth: Array, focus: Array, v: float, error: float, factor: Factor | None = None
    ) -> int:
        """Return a number of nodes whose proven error bound is at most `error`; `factor` is as in :func:`rule`."""
        if factor is None:
            return self.nodes(self.growth_on_best(model, depth, focus, v, error), error)
        return self.nodes(self.growth(model, depth, focus, v, factor=factor(self)), error)

    def growth_on_best(self, model: Model, depth: Array, focus: Array, v: float, error: float) -> Array:
        """Return :meth:`growth` on one or two ellipses that need the fewest nodes according to an estimate."""
        estimate = self._node_counts(self._estimated_growth(model, depth, focus, v), error)
        best_row = int(estimate.argmin())
        # The best ellipse nearly always suffices; if its bound is infinite, try its neighbours, then all ellipses.
        for rows in ((best_row,), tuple(row for row in (best_row - 1, best_row + 1) if 0 <= row < ETA.size)):
            growth = self.growth(model, depth, focus, v, rows)
            if np.isfinite(growth).any():
                return growth
        return self.growth(model, depth, focus, v)

    def constant(self) -> Array:
        """Return the log of the constant in the error bound ``constant exp(growth - 2 n eta)`` for each ellipse."""
        return np.asarray(math.log(64.0 / 15.0 * 0.5 * (self.high - self.low)) - np.log(-np.expm1(-2.0 * ETA)))

    def _node_counts(self, growth: Array, error: float) -> Array:
        """Return the number of nodes, not rounded, for which the error bound of each ellipse is `error`."""
        with np.errstate(over="ignore"):
            return np.asarray((growth + self.constant() - math.log(error)) / (2.0 * ETA))

    def nodes(self, growth: Array, error: float) -> int:
        """Return the smallest number of nodes with a proven error of at most `error`; ValueError if there is none."""
        count = float(self._node_counts(growth, error).min())
        if not math.isfinite(count):
            advice = "films must be thinner, or " if self.layers.films else ""
            raise ValueError(
                f"{advice}NA must be farther below the indices of immersion and cover glass: at {self.layers.NA:g} "
                "no number of quadrature nodes is proven to suffice"
            )
        return max(2, math.ceil(count))


class Centre(Piece):
    """Central section of the pupil, whose variable is rho, in which odd integrands are analytic."""

    def square(self, x: Values) -> Values:
        """Return ``(NA rho)^2``."""
        return x * x * self.layers.NA**2

    def is_root(self, index: float) -> bool:
        """Return True: all cosines are square roots in rho."""
        return True

    def jacobian(self, x: Values) -> Values:
        """Return rho."""
        return x

    @property
    def rooted(self) -> tuple[float, ...]:
        """Indices of immersion, glass and sample, whose cosines must stay in the right half plane."""
        return self.layers.immersion, self.layers.glass, self.layers.sample


Factor = Callable[[Piece], Array]
"""Function that returns, for each disc of a section, the log of a bound on an additional factor of the integrands."""


@lru_cache(maxsize=8)
def enclosed(piece: Piece, model: Model, rows: Rows) -> tuple[Points, Array]:
    """Return the discs of ellipses, and on each disc the log of a bound on the moduli of :meth:`Piece.parts`."""
    points = piece.covered(rows)
    bound = _bound(piece, model, points)
    kept = changed(points, _cosines={}, height=points.height, analytic=points.analytic, rates=points.rates)
    del vars(kept)["amplitudes"]  # like the cosines, most of the memory, and needed no more
    return kept, bound


def _bound(piece: Piece, model: Model, points: Points) -> Array:
    t_s, t_p, _ = points.amplitudes
    with np.errstate(all="ignore"):
        bound = np.log(piece.jacobian(points.x).largest)
        if model.aplanatic:
            bound -= 0.5 * np.log(points(piece.layers.immersion).least)
        if piece.layers.exponent:
            g = piece.layers.apodization(points.square)
            bound += g.radius - g.centre.real
        if model.kind == "scalar":
            return np.asarray(bound + math.log(2.0))
        c_s = points(piece.layers.sample)
        sine = np.sqrt(points.square.largest) / piece.layers.sample
        if model.kind == "azimuthal":
            return np.asarray(bound + np.log(2.0 * t_s.largest))
        if model.kind == "radial":
            return np.asarray(bound + np.log(2.0 * np.maximum((t_p * c_s).largest, t_p.largest * sine)))
        return np.asarray(bound + np.log(np.maximum(t_s.largest + (t_p * c_s).largest, t_p.largest * sine)))


def extremes(depth: Array, focus: Array) -> list[tuple[float, float]]:
    """Return the pairs (depth, focus) at which the integrand can be largest: each depth with its extreme foci."""
    # The phase is linear in the focus, so that for each depth the maximum is at the smallest or the largest focus.
    pairs = []
    for d in np.unique(depth):
        foci = focus[depth == d]
        pairs += [(float(d), float(f)) for f in {foci.min(), foci.max()}]
    return pairs


@lru_cache(maxsize=8)
def pieces(layers: Layers, model: Model) -> tuple[Piece, ...]:
    """Return the sections of the pupil; a section beyond the critical angle, if included, is the last."""
    odd = model.kind in _ODD_KINDS
    lowest = min(layers.immersion, layers.glass, layers.sample)
    # 1 - cos of the largest angle, as sin^2 / (1 + cos) without cancellation.
    sine = min(1.0, layers.NA / lowest)
    edge = sine**2 / (1.0 + math.sqrt((1.0 - sine) * (1.0 + sine)))
    sections: list[Piece] = []
    if odd:
        sections.append(Centre(layers, 0.0, min(1.0, _CENTRE_RHO * lowest / layers.NA)))
    if not odd or edge > _CENTRE:
        sections.append(Piece(layers, _CENTRE if odd else 0.0, edge, odd=odd))
    if layers.sample < layers.NA and model.supercritical:
        # abs(c_s) at the rim, as a product without cancellation near the critical angle.
        end = math.sqrt((layers.NA / layers.sample - 1.0) * (layers.NA / layers.sample + 1.0))
        sections.append(Piece(layers, 0.0, end, above=True, odd=odd))
    return tuple(sections)


# Unit of the allowance for rounding errors, which is not proven: docs/certificate.md, section 14, "Rounding".
_ROUNDOFF = 2.0**-53
_RADII = 2048  # number of radii computed together, to limit the memory


class Rule(NamedTuple):
    """Quadrature rule: rho of the nodes, weighted parts, and the phase with its rates by depth and focus.

    `error` is the proven error bound plus `rounding`, an allowance for rounding errors; `counts` are the numbers of
    nodes of the sections.
    """

    rho: Array
    parts: tuple[Complex, ...]
    rates: tuple[Complex, Complex, Complex]
    error: float
    rounding: float
    counts: tuple[int, ...]

    def waves(self, depth: Array, focus: Array) -> Complex:
        """Return ``exp(i psi)`` for each plane and node, shape ``(planes, nodes)``."""
        phase0, by_depth, by_focus = self.rates
        phases = depth[:, None] * by_depth
        phases += focus[:, None] * by_focus
        phases += phase0
        phases *= 1j
        return np.asarray(np.exp(phases, out=phases))


def rule(
    layers: Layers, model: Model, depth: Array, focus: Array, v: float, tol: float, factor: Factor | None = None
) -> Rule:
    """Return a rule with an error of at most `tol` for every part, plane and radius r with ``k NA r <= v``.

    `factor` returns, for a section, the log of a bound on an additional analytic factor of the integrands on each
    disc.
    """
    sections = pieces(layers, model)
    counts = tuple(piece.proven_count(model, depth, focus, v, tol / len(sections), factor) for piece in sections)
    rho, parts, rates = tabulated(sections, model, counts)
    # The rounding error of phases is proportional to the sum of optical paths: certificate, section 14, "Rounding".
    paths = sum(index * abs(thickness) for index, thickness in layers.paths)
    reach = layers.sample * depth.max(initial=0.0) + layers.immersion * np.abs(focus).max(initial=0.0) + paths
    size = max(float(np.abs(part).sum()) for part in parts)
    rounding = (4.0 * layers.wavenumber * reach + 4.0 * v + 2.0 * math.sqrt(rho.size) + 64.0) * _ROUNDOFF * size
    return Rule(rho, parts, rates, float(tol + rounding), rounding, counts)


def tabulated(
    sections: tuple[Piece, ...], model: Model, counts: tuple[int, ...]
) -> tuple[Array, tuple[Complex, ...], tuple[Complex, Complex, Complex]]:
    """Return rho, the weighted parts and the rates of the phase at `counts` Gauss nodes of each section."""
    rhos, parts, rates = [], [], []
    for piece, n in zip(sections, counts, strict=True):
        x, w = gauss_legendre(n, piece.low, piece.high)
        points = Points(piece, x)
        rhos.append(np.sqrt(points.square) / piece.layers.NA)
        parts.append([w * part for part in piece.parts(points, model)])
        rates.append(points.rates)
    phase0, by_depth, by_focus = (np.concatenate(rate) for rate in zip(*rates, strict=True))
    all_parts = tuple(np.concatenate(part) for part in zip(*parts, strict=True))
    return np.concatenate(rhos), all_parts, (phase0, by_depth, by_focus)


def fields(rule: Rule, model: Model, depth: Array, focus: Array, v: Array) -> tuple[Complex, ...]:
    """Return each part in each plane at each v, shape ``(planes, radii)``."""
    waves = rule.waves(depth, focus)
    integrals = tuple(np.empty((depth.size, v.size), np.complex128) for _ in model.orders)
    for start in range(0, v.size, _RADII):
        arguments = np.multiply.outer(rule.rho, v[start : start + _RADII])
        for order, part, values in zip(model.orders, rule.parts, integrals, strict=True):
            values[:, start : start + _RADII] = (waves * part) @ scipy.special.jv(order, arguments)
    return integrals


def power(layers: Layers, depth: Array, model: Model | None = None, *, by_depth: bool = False) -> tuple[Array, Array]:
    """Return the power of each part at each `depth` and far from the glass, in units of ``4 pi / (k NA)^2``.

    With `by_depth`, return the derivatives of both powers by depth.
    """
    model = model or Model()
    # Double the number of nodes until two results agree to 1e-13; convergence is geometric.
    previous = np.full((1, 1), -1.0)
    for n in (32 * 2**k for k in range(9)):
        propagating, decay_rates, evanescent = _powers(layers, model, n)
        decay = np.exp(np.outer(depth, decay_rates))
        total = decay @ evanescent + propagating
        powers, far_powers = total, propagating
        if by_depth:
            # Propagating light does not depend on depth.
            powers, far_powers = decay @ (evanescent * decay_rates[:, None]), 0.0 * far_powers
        # The error of a derivative is relative to the sum of the power and the derivative.
        size = total + np.abs(powers) if by_depth else total
        if (np.abs(powers - previous) <= 1e-13 * size.sum(axis=1, keepdims=True)).all():
            break
        previous = powers
    return powers, far_powers


@lru_cache(maxsize=64)
def _powers(layers: Layers, model: Model, n: int) -> tuple[Array, Array, Array]:
    """Return the powers of each part, by n nodes per section.

    The result is the propagating power, and the decay rates and the powers at depth 0 of evanescent waves at each
    node.
    """
    part_count = len(model.orders)
    propagating, decay_rates, evanescent = np.zeros(part_count), np.zeros(0), np.zeros((0, part_count))
    for piece in pieces(layers, model):
        x, w = gauss_legendre(n, piece.low, piece.high)
        points = Points(piece, x)
        # The squared parts include the square of the Jacobian: divide by it once.
        measure = (w / (2.0 * piece.jacobian(x)))[:, None]
        node_parts = np.stack(piece.parts(points, model), axis=1)
        node_power: Array = measure * np.abs(node_parts) ** 2
        if piece.above:
            decay_rates, evanescent = -2.0 * points.rates[1].imag, node_power
        else:
            propagating += node_power.sum(axis=0)
    return propagating, decay_rates, evanescent


# Derivatives by depth and focus multiply the integrand by ``i d psi / d(depth)`` or ``i d psi / d(focus)``. The
# derivative by v replaces J_m(v rho) by ``rho J_m'(v rho)``.


def slope_errors(
    quadrature: Rule, layers: Layers, model: Model, depth: Array, focus: Array, v: float, tol: float
) -> Array:
    """Return bounds on the errors of a rule for derivatives by depth, by focus and by v."""
    errors = np.zeros(3)
    for piece, n in zip(pieces(layers, model), quadrature.counts, strict=True):
        growth = piece.growth_on_best(model, depth, focus, v, tol / len(quadrature.counts))
        rows = tuple(int(row) for row in np.flatnonzero(np.isfinite(growth)))
        covered, _ = enclosed(piece, model, rows)
        _, by_depth, by_focus = covered.rates
        # abs(dJ_m(v rho)/dv) <= abs(rho) exp(v abs(Im rho)); the other factors are derivatives of the phase.
        rho = np.sqrt(covered.square.largest) / layers.NA
        log_error = (piece.constant() - 2.0 * n * ETA + growth)[list(rows)]
        factors = by_depth.largest, by_focus.largest, rho
        errors += [float(np.exp((log_error + np.log(factor.max(axis=-1))).min())) for factor in factors]
    largest = np.array([*(np.abs(rate).max() for rate in quadrature.rates[1:]), 1.0])
    return errors + quadrature.rounding * largest


@lru_cache(maxsize=32)
def steepest(layers: Layers, model: Model) -> tuple[float, float]:
    """Return bounds on the deviations of the phase derivatives by depth and by focus from their middle values."""
    bounds = np.zeros(2)
    for piece in pieces(layers, model):
        # By the maximum principle a bound on the narrowest ellipse without singularity holds on the section inside.
        row = next(row for row in range(ETA.size) if enclosed(piece, model, (row,))[0].analytic[0])
        covered, _ = enclosed(piece, model, (row,))
        rates = zip(covered.rates[1:], layers.middle_rates(), strict=True)
        bounds = np.maximum(bounds, [(rate - middle).largest.max() for rate, middle in rates])
    return float(bounds[0]), float(bounds[1])
