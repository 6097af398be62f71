r"""Debye-Wolf integrals over the angles of a microscope's light, by Gauss-Legendre quadrature with proven bounds.

The bounds come from ellipses on which the integrands are analytic. [0, 1] is cut at the critical angle of the sample,
``rho = n_s / NA``. Below, the variable is 1 - c, with the cosine c in the layer of the lowest index and
``rho d rho = -(n / NA)^2 c dc``; above, ``kappa = abs(c_s)``. The error of Gauss's rule falls like ``exp(-2 n eta)``
for each ellipse without branch points of other cosines and zeros of denominators. Integrands that are odd in rho
(radial, azimuthal, vortex) are integrated over rho itself near the centre. Discs that cover an ellipse bound the
integrand on it: certificate, section 14.

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
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.base.cached import cached_property
from lommel.optics.layers.stratified import Amplitudes, Layers, Values
from lommel.special.disc_arithmetic import Disc, disc, windings
from lommel.special.legendre import gauss_legendre

ETA = np.geomspace(4e-3, 2.5, 28)
_ARCS = 1024
_GLANCE = 24  # points of an ellipse for an estimate
_ORDERS = {"vectorial": (0, 1, 2), "scalar": (0,), "radial": (0, 1), "azimuthal": (0, 1), "vortex": (1, 2, 3)}
_ODD = ("radial", "azimuthal", "vortex")
# End of the centre, in 1 - c and in rho over n / NA: there both sections are equally far from their singularities.
_CENTRE = 0.3
_CENTRE_RHO = math.sqrt(_CENTRE * (2.0 - _CENTRE))
Complex = NDArray[np.complex128]
Rows = tuple[int, ...] | None
"""Indices of some ellipses; None for all."""


@dataclass(frozen=True)
class Model:
    """The field integrals: vectorial K0, K1, K2; scalar U; or those of radial, azimuthal and vortex beams.

    `aplanatic` is the amplitude ``c_i^(-1/2)`` of the sine condition instead of 1; `supercritical` includes light
    beyond the critical angle of the sample.
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
        """Whether surfaces and films count."""
        return self.kind != "scalar"


class At:
    """Points of a section, or discs along ellipses around it, with quantities of the integrands, computed once."""

    def __init__(self, piece: Piece, x: Values) -> None:
        self.piece, self.x, self.square = piece, x, piece.square(x)
        self._known: dict[float, Values] = {}

    def __call__(self, index: float) -> Values:
        """Return c_m of a layer."""
        if index not in self._known:
            # Above the critical angle the cosine of the lowest index is imaginary by definition of the variable.
            if self.piece.is_root(index):
                of = 1.0 - self.square * index**-2
                found = of.sqrt() if isinstance(of, Disc) else np.sqrt(of + 0.0j)
            else:
                found = 1j * self.x if self.piece.above else 1.0 + 0.0j - self.x
            self._known[index] = found
        return self._known[index]

    @cached_property
    def amplitudes(self) -> Amplitudes:
        """Transmission amplitudes of s and p waves."""
        return self.piece.layers.amplitudes(self, self.square)

    @cached_property
    def rates(self) -> tuple[Values, Values, Values]:
        """Phase at depth 0 and focus 0, and its derivatives by both."""
        return self.piece.layers.rates(self)

    @cached_property
    def height(self) -> Array:
        """Bound on ``abs(Im rho)`` of discs."""
        if isinstance(self.piece, Centre):
            return np.asarray(np.abs(self.x.centre.imag) + self.x.radius)
        # The lesser of two bounds on Im of the root of a disc: certificate, section 14, "Discs".
        square = self.square * self.piece.layers.NA**-2
        root = np.sqrt(square.centre)
        near = np.abs(root.imag) + square.radius / np.maximum(np.abs(root), 1e-300)
        return np.asarray(np.minimum(np.hypot(root.imag, np.sqrt(square.radius)), near))

    @cached_property
    def fit(self) -> NDArray[np.bool_]:
        """Whether each ellipse contains no singularity: proven for discs, probable for points."""
        found = self._in_sheet()
        # A denominator analytic inside has as many zeros there as its values wind around 0.
        for around in (*self.amplitudes.denominators, *([self.square] if self.piece.odd else [])):
            found &= windings(disc(around)) == 0
        return found

    def _in_sheet(self) -> NDArray[np.bool_]:
        """Return whether cosines are known on each ellipse, and those with branch points have none inside."""
        fit, rooted = np.ones(disc(self.x).radius.shape[:-1], np.bool_), self.piece.rooted
        for index in {*rooted, self.piece.layers.sample}:
            c = self(index)
            if isinstance(c, Disc):
                fit &= np.isfinite(c.radius).all(axis=-1)
                # Re c > 0 on all discs keeps c^(-1/2) analytic: certificate, section 14, "Which ellipses".
                if index in rooted:
                    fit &= (c.centre.real > c.radius).all(axis=-1)
            elif self.piece.is_root(index):
                fit &= ((c * c).real > 0.0).all(axis=-1)
            elif index in rooted:
                fit &= (c.real > 0.0).all(axis=-1)
        return fit


@dataclass(frozen=True)
class Piece:
    """Section of the pupil in its analytic variable; `odd` integrands need ellipses that exclude rho = 0."""

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
        """Return whether the cosine of a layer may have branch points."""
        return index != self.lowest

    def jacobian(self, x: Values) -> Values:
        """Return ``rho d rho / dx``."""
        return (x if self.above else 1.0 - x) * (self.lowest / self.layers.NA) ** 2

    def parts(self, at: At, model: Model) -> tuple[Complex, ...]:
        """Return the factors of ``exp(i psi) J_m``, Jacobian included, in the order of `model`."""
        return self._composed(at, model, *(at.amplitudes[:2] if model.transmits else (1.0, 1.0)))

    def changes(self, at: At, model: Model) -> tuple[Complex, ...]:
        """Return the derivatives of :meth:`parts` by ln k, which films cause."""
        of_s, of_p = self.layers.log_slopes(at, at.square)
        t_s, t_p, _ = at.amplitudes
        return self._composed(at, model, t_s * of_s, t_p * of_p)

    def _composed(self, at: At, model: Model, t_s: Values, t_p: Values) -> tuple[Complex, ...]:
        # The parts of radial, azimuthal and vortex beams: certificate, section 14, "What is odd in rho".
        c_i, c_s = at(self.layers.immersion), at(self.layers.sample)
        light = self.jacobian(at.x) * (c_i**-0.5 if model.aplanatic else 1.0 + 0.0j)
        if self.layers.exponent:
            light = light * np.exp(-self.layers.apodization(at.square))
        if model.kind == "scalar":
            return (2.0 * light,)
        sine = np.sqrt(at.square) / self.layers.sample
        if model.kind == "azimuthal":
            return 0.0 * light, 2.0 * light * t_s
        if model.kind == "radial":
            return 2.0j * light * t_p * sine, 2.0 * light * t_p * c_s
        return light * (t_s + t_p * c_s), light * t_p * sine, light * (t_s - t_p * c_s)

    def _ellipses(self, eta: Array, theta: Array) -> Complex:
        """Return points on the ellipses around the piece, one for each eta, shape ``(eta, theta)``."""
        half = 0.5 * (self.high - self.low)
        return np.asarray(self.low + half * (1.0 + np.cos(theta + 1j * eta[:, None])))

    @cached_property
    def covered(self) -> At:
        """All ellipses, covered with discs."""
        return self._cover(ETA)

    def _cover(self, eta: Array) -> At:
        step = 2.0 * math.pi / _ARCS
        theta = (np.arange(float(_ARCS)) + 0.5) * step
        # abs(dx/dtheta)^2 / half^2 = sin^2 theta + sinh^2 eta; its maximum along an arc is the radius of its disc.
        slope = np.hypot(np.minimum(np.abs(np.sin(theta)) + 0.5 * step, 1.0), np.sinh(eta)[:, None])
        # A little more than exact for rounding of centres and radii.
        radius = 0.25 * step * (self.high - self.low) * slope * (1.0 + 1e-12) + 1e-15
        return At(self, Disc(self._ellipses(eta, theta), radius))

    @property
    def rooted(self) -> tuple[float, ...]:
        """Indices of the layers whose cosines must stay in the right half plane."""
        return self.layers.immersion, self.layers.glass

    def growth(
        self, model: Model, depth: Array, focus: Array, v: float, rows: Rows = None, factor: Array | float = 0.0
    ) -> Array:
        """Return the log of a bound on the integrands on each ellipse (or `rows` of them), infinite where singular.

        `factor` is the log of a bound on a further factor on each disc of all ellipses.
        """
        covered, amplitude = enclosed(self, model, rows)
        fixed, by_depth, by_focus = covered.rates
        worst = np.full(covered.height.shape, -np.inf)
        with np.errstate(all="ignore"):
            for d, f in extremes(depth, focus):
                # abs(exp(i psi)) = exp(-Im psi), with the radii of the discs.
                phase = fixed.centre.imag + d * by_depth.centre.imag + f * by_focus.centre.imag
                worst = np.maximum(worst, fixed.radius + d * by_depth.radius + abs(f) * by_focus.radius - phase)
            grown = (amplitude + worst + v * covered.height + factor).max(axis=-1)
        found = np.full(ETA.shape, np.inf)
        found[list(rows or range(ETA.size))] = np.where(covered.fit & np.isfinite(grown), grown + 1e-9, np.inf)
        return found

    def _glance(self, model: Model, depth: Array, focus: Array, v: float) -> Array:
        """Estimate :meth:`growth` from some points of each ellipse: not a bound, at a tenth of the cost."""
        at = At(self, self._ellipses(ETA, (np.arange(float(_GLANCE)) + 0.5) * (2.0 * math.pi / _GLANCE)))
        fixed, by_depth, by_focus = at.rates
        with np.errstate(all="ignore"):
            light = np.log(np.max([np.abs(part) for part in self.parts(at, model)], axis=0))
            fading = np.min([(fixed + d * by_depth + f * by_focus).imag for d, f in extremes(depth, focus)], axis=0)
            found = (light - fading + v / self.layers.NA * np.abs(np.sqrt(at.square).imag)).max(axis=-1)
        return np.where(at.fit & np.isfinite(found), found, np.inf)

    def enough(
        self, model: Model, depth: Array, focus: Array, v: float, error: float, factor: Factor | None = None
    ) -> int:
        """Return a number of nodes proven to err by at most `error`; `factor` as of :func:`debye.rule`."""
        if factor is None:
            return self.nodes(self.serving(model, depth, focus, v, error), error)
        return self.nodes(self.growth(model, depth, focus, v, factor=factor(self)), error)

    def serving(self, model: Model, depth: Array, focus: Array, v: float, error: float) -> Array:
        """Return :meth:`growth` on the few ellipses that are best by an estimate."""
        glance = self._needed(self._glance(model, depth, focus, v), error)
        best = int(glance.argmin())
        # One ellipse is nearly always enough; each further one costs as much.
        for rows in ((best,), tuple(row for row in (best - 1, best + 1) if 0 <= row < ETA.size)):
            growth = self.growth(model, depth, focus, v, rows)
            if np.isfinite(growth).any():
                return growth
        return self.growth(model, depth, focus, v)

    def constant(self) -> Array:
        """Return the log of the factor of the growth in the bound, without the number of nodes."""
        return np.asarray(math.log(64.0 / 15.0 * 0.5 * (self.high - self.low)) - np.log(-np.expm1(-2.0 * ETA)))

    def _needed(self, growth: Array, error: float) -> Array:
        with np.errstate(over="ignore"):
            return np.asarray((growth + self.constant() - math.log(error)) / (2.0 * ETA))

    def nodes(self, growth: Array, error: float) -> int:
        """Return the fewest nodes proven to err by at most `error`; ValueError if no number suffices."""
        needed = float(self._needed(growth, error).min())
        if not math.isfinite(needed):
            thinner = "films must be thinner, or " if self.layers.films else ""
            raise ValueError(
                f"{thinner}NA must be farther below the indices of immersion and cover glass: at {self.layers.NA:g} "
                "no number of angles is proven to suffice"
            )
        return max(2, math.ceil(needed))


class Centre(Piece):
    """The centre of the pupil in the variable rho, in which odd integrands are analytic."""

    def square(self, x: Values) -> Values:
        """Return ``(NA rho)^2``."""
        return x * x * self.layers.NA**2

    def is_root(self, index: float) -> bool:
        """Return True: no cosine is the variable itself."""
        return True

    def jacobian(self, x: Values) -> Values:
        """Return rho."""
        return x

    @property
    def rooted(self) -> tuple[float, ...]:
        """All layers."""
        return self.layers.immersion, self.layers.glass, self.layers.sample


Factor = Callable[[Piece], Array]
"""Log of a bound on a further analytic factor of the integrands, on each disc around a section."""


@lru_cache(maxsize=32)
def enclosed(piece: Piece, model: Model, rows: Rows) -> tuple[At, Array]:
    """Return ellipses as discs, and the log of a bound on each part without exponential and Bessel function."""
    at = piece.covered if rows is None else piece._cover(ETA[list(rows)])
    t_s, t_p, _ = at.amplitudes
    with np.errstate(all="ignore"):
        light = np.log(piece.jacobian(at.x).largest)
        if model.aplanatic:
            light -= 0.5 * np.log(at(piece.layers.immersion).least)
        if piece.layers.exponent:
            g = piece.layers.apodization(at.square)
            light += g.radius - g.centre.real
        if model.kind == "scalar":
            return at, np.asarray(light + math.log(2.0))
        c_s = at(piece.layers.sample)
        sine = np.sqrt(at.square.largest) / piece.layers.sample
        if model.kind == "azimuthal":
            return at, np.asarray(light + np.log(2.0 * t_s.largest))
        if model.kind == "radial":
            return at, np.asarray(light + np.log(2.0 * np.maximum((t_p * c_s).largest, t_p.largest * sine)))
        return at, np.asarray(light + np.log(np.maximum(t_s.largest + (t_p * c_s).largest, t_p.largest * sine)))


def extremes(depth: Array, focus: Array) -> list[tuple[float, float]]:
    """Return the pairs of depth and focus that bound all others, since the phase is linear in both."""
    # The exponent is convex: for each depth the first and the last focus bound the others.
    found = []
    for d in np.unique(depth):
        here = focus[depth == d]
        found += [(float(d), float(f)) for f in {here.min(), here.max()}]
    return found


@lru_cache(maxsize=8)
def pieces(layers: Layers, model: Model) -> tuple[Piece, ...]:
    """Return the sections of the pupil; that beyond the critical angle comes last, if its light counts."""
    odd = model.kind in _ODD
    lowest = min(layers.immersion, layers.glass, layers.sample)
    # 1 - cos of the largest angle as sin^2 / (1 + cos), without cancellation.
    sine = min(1.0, layers.NA / lowest)
    edge = sine**2 / (1.0 + math.sqrt((1.0 - sine) * (1.0 + sine)))
    found: list[Piece] = []
    if odd:
        found.append(Centre(layers, 0.0, min(1.0, _CENTRE_RHO * lowest / layers.NA)))
    if not odd or edge > _CENTRE:
        found.append(Piece(layers, _CENTRE if odd else 0.0, edge, odd=odd))
    if layers.sample < layers.NA and model.supercritical:
        # kappa = abs(c_s) at the rim, as a product, without cancellation near the critical angle.
        reach = math.sqrt((layers.NA / layers.sample - 1.0) * (layers.NA / layers.sample + 1.0))
        found.append(Piece(layers, 0.0, reach, above=True, odd=odd))
    return tuple(found)


# Allowed for, not proven: certificate, section 14, "Rounding".
_ROUNDOFF = 2.0**-53
_RADII = 2048  # radii at once


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
    cut = pieces(layers, model)
    counts = tuple(piece.enough(model, depth, focus, v, tol / len(cut), factor) for piece in cut)
    rho, joined, rates = tabulated(cut, model, counts)
    # Section 14, "Rounding": phases lose digits in proportion to the optical paths that they sum.
    paths = sum(index * abs(thickness) for index, thickness in layers.paths)
    reach = layers.sample * depth.max(initial=0.0) + layers.immersion * np.abs(focus).max(initial=0.0) + paths
    size = max(float(np.abs(part).sum()) for part in joined)
    rounding = (4.0 * layers.wavenumber * reach + 4.0 * v + 2.0 * math.sqrt(rho.size) + 64.0) * _ROUNDOFF * size
    return Rule(rho, joined, rates, float(tol + rounding), rounding, counts)


def tabulated(
    cut: tuple[Piece, ...], model: Model, counts: tuple[int, ...]
) -> tuple[Array, tuple[Complex, ...], tuple[Complex, Complex, Complex]]:
    """Return rho, the weighted parts and the rates of the phase at `counts` Gauss nodes of each section."""
    rhos, parts, rates = [], [], []
    for piece, n in zip(cut, counts, strict=True):
        x, w = gauss_legendre(n, piece.low, piece.high)
        at = At(piece, x)
        rhos.append(np.sqrt(at.square) / piece.layers.NA)
        parts.append([w * part for part in piece.parts(at, model)])
        rates.append(at.rates)
    fixed, by_depth, by_focus = (np.concatenate(each) for each in zip(*rates, strict=True))
    joined = tuple(np.concatenate(each) for each in zip(*parts, strict=True))
    return np.concatenate(rhos), joined, (fixed, by_depth, by_focus)


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
    # Quadrature converges geometrically: two results that agree are exact to about rounding.
    before = np.full((1, 1), -1.0)
    for n in (32 * 2**k for k in range(9)):
        steady, fading, faint, steady_change, faint_change = _collected(layers, model, n)
        left = np.exp(np.outer(depth, fading))
        all_light = left @ faint + steady
        near, far = all_light, steady
        if by is not None:
            # Far from the glass nothing changes with the depth.
            near, far = left @ (faint * fading[:, None]), 0.0 * far
        if by == "wavenumber":
            near = depth[:, None] * near + left @ faint_change + steady_change
            far = steady_change
        # A derivative needs no smaller error than the quantity it is derived from.
        # By ln k, at fixed v, waves also fade faster in proportion to k: depth times the derivative by depth.
        size = all_light if by is None else all_light + np.abs(near)
        if (np.abs(near - before) <= 1e-13 * size.sum(axis=1, keepdims=True)).all():
            break
        before = near
    return near, far


@lru_cache(maxsize=64)
def _collected(layers: Layers, model: Model, n: int) -> tuple[Array, Array, Array, Array, Array]:
    """Return the light of each part from n angles: steady, decay rates, decaying, and derivatives by ln k."""
    parts = len(model.orders)
    steady, steady_change = np.zeros(parts), np.zeros(parts)
    fading, faint, faint_change = np.zeros(0), np.zeros((0, parts)), np.zeros((0, parts))
    for piece in pieces(layers, model):
        x, w = gauss_legendre(n, piece.low, piece.high)
        at = At(piece, x)
        # Light per unit of rho d rho: the parts contain the Jacobian, which is divided out once of its square.
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
    """Return whether amplitudes depend on the wavelength (films that transmit)."""
    return bool(layers.films) and model.transmits


# Derivatives by depth, focus and v have the factors ``i d psi / dx`` and ``rho J_m'(v rho)``. Phases are proportional
# to the wavenumber k, so that by ln k the factor is ``i psi``; a real constant in psi turns all fields alike and is
# left out. With films the amplitudes of s and p waves depend on k, too.


class Turning(NamedTuple):
    """Factors of derivatives by ln k at fixed v: rates of the phase less a constant, changes of the parts."""

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
    """Bound the errors of a rule in derivatives by depth, focus, v, and ln k at fixed v."""
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
    # Section 15, "The wavelength".
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
        # The narrowest ellipse without a singularity; by the maximum principle its bound holds inside.
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
