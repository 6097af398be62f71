"""Microscope images with a measured wavefront in small windows, by the chordal Gauss rule with projected amplitudes.

A chord is a line of constant x across the unit disc of the pupil; quadrature nodes lie on chords. Images use numbers
of chords and of nodes per chord that are proven to suffice. Searches for parameters use fewer, without an error
bound.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Declined, Samples, Wanted, not_met
from lommel.core.engine import (
    NodeTables,
    NodeTerms,
    NodeWaves,
    Window,
    chordal_field_errors,
    chordal_series_gradient,
    chordal_series_light,
    chordal_series_sizes,
    folded_waves,
)
from lommel.methods.averaging import averaged_gradient
from lommel.methods.layers.debye_rings import squares
from lommel.methods.layers.debye_wolf import LEAST, AberratedMethod, likely_peak
from lommel.methods.method import normalized_error, stored, storing
from lommel.optics.grid import Grid
from lommel.optics.layers import debye, projection
from lommel.optics.layers.debye import Complex, Model
from lommel.optics.layers.emitter import Emitter
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.optics.layers.stratified import Layers
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre

_B = np.geomspace(0.03, 2.7, 64)  # imaginary parts b of the shifted integration paths; each b gives a bound
_SINH = np.sinh(_B)
# Bounds decrease like exp(-2 n b) with the number n of chords or nodes; the core computes the required n / 2.
_QUARTER = 0.25 / _B
_RATIO = np.exp(-4.0 * _B)
_OVER_CHORDS = np.log1p(_RATIO)  # logarithm of the factor of exp(-2 n b) in the bound for chords
# cosh(b)^2 / (cosh(2 b) / 2): certificate, section 16, "Chords and nodes".
_CHORD_WEIGHT = 1.0 + 1.0 / np.cosh(2.0 * _B)  # largest weight of chords on the shifted paths / mean weight
_ETA = np.linspace(0.0, 1.0, 17)  # positions on a path for the trapezoidal rule of means_of_kernel()
# exp(-s) I_0(s) <= sqrt(_BESSEL / s), by 1 - cos t >= 2 t^2 / pi^2 in the integral of I_0 (section 16).
_BESSEL = math.pi / 8.0
_OVER_NODES = math.log(32.0 / 15.0) - np.log(-np.expm1(-2.0 * _B))  # logarithm of the factor in the bound for nodes
_MOST_NODES, _MOST_DEGREE = 256, 250  # limits that keep sums of exp(n b) finite
_ROUNDING = 2.0**-53
# Fractions of the allowed error of a field: for the projection, the sum over chords and the sum over nodes.
_FRACTIONS = (0.25, 0.3, 0.3)
_QUADRATURE = 0.05  # fraction of the allowed error of a field: for the quadrature of the radial series


class By(NamedTuple):
    """Parameters of derivatives."""

    rates: tuple[int, ...] = ()  # 0: depth, 1: focus, divided by the largest phase rate
    terms: tuple[tuple[int, int], ...] = ()  # n and m of Zernike terms


_NO_DERIVATIVES = By()
_FLAT_WAVEFRONT = Wavefront()
_Result = TypeVar("_Result")


@dataclass(frozen=True)
class ChordalDebye(AberratedMethod):
    r"""Debye-Wolf integral of an objective in small windows, with or without aberrations, by sums over chords.

    Supports the pupils of :meth:`lommel.Objective.pupil` only, with any emitter. Without aberrations
    :class:`Stratified` is faster, but has no derivatives by Zernike terms.

    Parameters
    ----------
    tol : float, default 1e-6
        Tolerance relative to the largest value in the window, 1e-12 to 1e-1; :class:`~lommel.ToleranceError` is
        raised if it cannot be met, for example in a window far from the image.

    Raises
    ------
    TypeError, ValueError
        If `tol` is out of range.

    Notes
    -----
    Every field is ``(1/pi) int t(rho) exp(i q theta + i W - i v.r) dx dy`` over the unit disc, where t is the
    amplitude with the phase of the layers, W the measured wavefront (radians), r the pupil position and v the image
    position. t has a kink at the critical angle, and is replaced by its series of radial polynomials ``R_n^q`` up to
    degree D. The remainder is orthogonal to all polynomials of degree up to D, and in a small window
    ``exp(i W - i v.r)`` is nearly such a polynomial: the remainder contributes little. The rule of
    :class:`ChordalGauss` integrates the series times this exponential. The degree and the numbers of chords and nodes
    are proven to suffice; see docs/certificate.md, section 16.

    References
    ----------
    L. N. Trefethen and J. A. C. Weideman, SIAM Review 56, 385 (2014), doi:10.1137/130932132: the trapezoidal rule.
    J. J. M. Braat, P. Dirksen, A. J. E. M. Janssen and A. S. van de Nes, J. Opt. Soc. Am. A 20, 2281 (2003): Zernike
    series of the amplitudes of vectorial light.
    """

    tol: float = 1e-6

    def unsupported(self, pupil: ObjectivePupil) -> str | None:
        """Return None: all pupils are supported."""
        return None

    def _samples(self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted) -> Samples:
        return self.differentiated(pupil, grid, tol, wanted)[0]

    def differentiated(
        self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted, by: By = _NO_DERIVATIVES
    ) -> tuple[Samples, Array, Array, Array]:
        """Return the intensity I of a `pupil` at the pixel centres of `grid`, and its derivatives `by` parameters.

        Results: (1) images; (2) derivatives, shape (k, n, height, width), to which `tol` does not apply; (3) bounds
        on the errors of the derivatives, (k, n); (4) bounds on their largest moduli, (k, n). Raises the errors
        of ``images``.
        """
        n = pupil.depth.size
        if not grid.stack:
            return self._refine(pupil, grid, tol, wanted, by)
        values = np.empty((n, *grid.shape), wanted.dtype) if wanted.out is None else wanted.out
        scales = None if wanted.scale is None else np.broadcast_to(wanted.scale, n)
        scalars, derivatives, bounds = np.empty((3, n)), None, np.empty(0)
        for indices, planes, subgrid in axis_groups(pupil, grid):
            part_wanted = wanted._replace(scale=None if scales is None else scales[indices], out=None)
            images, part_derivatives, *part_bounds = self._refine(planes, subgrid, tol, part_wanted, by)
            values[indices] = images.values
            scalars[:, indices] = images.scale, images.bound, images.brightest
            if derivatives is None:
                derivatives = np.empty((len(part_derivatives), n, *grid.shape))
                bounds = np.empty((2, len(part_derivatives), n))
            derivatives[:, indices], bounds[:, :, indices] = part_derivatives, part_bounds
        assert derivatives is not None
        return Samples(values, scalars[0], scalars[1], None, scalars[2]), derivatives, bounds[0], bounds[1]

    def _refine(
        self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted, by: By
    ) -> tuple[Samples, Array, Array, Array]:
        """Return the result of :meth:`differentiated` for one axis, with the error of I below `tol` of its peak."""

        def compute(field_error: float) -> tuple[tuple[Array, Array, Array], Array, Array]:
            result = intensities(pupil, grid, field_error, wanted.threads, by)
            return result, result[2][0], result[1][0]

        (values, error, largest), peak, relative = self._prove(pupil, tol, wanted, compute)
        scales = np.empty(peak.shape)
        scales[:] = 1.0 / peak if wanted.scale is None else wanted.scale
        out = np.empty(values.shape[1:], wanted.dtype) if wanted.out is None else wanted.out
        np.multiply(values[0], scales[:, None, None], out=out, casting="same_kind")
        return (
            Samples(out, scales, stored(relative, wanted.dtype), None, peak - error[0]),
            values[1:],
            error[1:],
            largest[1:],
        )

    def _prove(
        self, pupil: ObjectivePupil, tol: float, wanted: Wanted, run: Callable[[float], tuple[_Result, Array, Array]]
    ) -> tuple[_Result, Array, Array]:
        """Return the result from fields accurate enough for `tol`, the largest I, and the error relative to it.

        `run` returns the result, the largest I and the absolute error of I, for a required error of fields.
        Raises ToleranceError if `tol` cannot be met.
        """
        # Division by the computed peak doubles the error, and adds a second rounding error.
        factor = 2.0 if wanted.scale is None else 1.0
        # The first required error of fields assumes a quarter of the likely peak. It is reduced until the error
        # bound of I is at most `tol`.
        target = max(tol, LEAST) / factor - 2.0 * storing(wanted.dtype)
        assumed_peak = likely_peak(pupil) / 4.0
        while True:
            field_error = max(LEAST, 2.0 ** math.floor(math.log2(target * math.sqrt(assumed_peak) / 6.0)))
            result, peak, error = run(field_error)
            least_peak = peak - error
            relative: Array = np.where(least_peak > 0.0, error / np.where(least_peak > 0.0, least_peak, 1.0), np.inf)
            if wanted.scale is None:
                relative = normalized_error(relative)
            if (worst_error := float(stored(relative, wanted.dtype).max())) <= tol:
                return result, peak, relative
            if field_error <= LEAST:
                raise not_met(self.tol, worst_error, "the largest value in the window")
            # The peak is lower than assumed, or the bound is less tight: reduce the error of fields.
            assumed_peak, target = assumed_peak * 0.25, target * max(1e-3, min(0.5, 0.5 * tol / worst_error))

    def gradient(self, pupil: ObjectivePupil, grid: Grid, weights: Array, by: By) -> Array:
        """Return weighted sums of I over the pixels of `grid` and their derivatives `by` parameters, (n, 1 + k).

        The transpose of :meth:`differentiated`: it takes little more time than an image, for any number of terms.

        Parameters
        ----------
        pupil : ObjectivePupil
        grid : Grid
        weights : ndarray, shape (n, height, width)
            Weights of the pixels in each image of the flattened stack.
        by : By

        Raises
        ------
        ToleranceError, ValueError
            If the tolerance cannot be met, or too many nodes are required.
        """
        wanted = Wanted(1.0, np.dtype(np.float64))

        def gradient_of_samples(pupil: ObjectivePupil, grid: Grid, tol: float, weights: Array) -> Array:
            if grid.stack:
                result = np.empty((len(weights), 1 + len(by.rates) + len(by.terms)))
                for indices, planes, subgrid in axis_groups(pupil, grid):
                    result[indices] = gradient_of_samples(planes, subgrid, tol, weights[indices])
                return result
            return self._prove(pupil, tol, wanted, lambda error: sums(pupil, grid, error, weights, 0, by))[0]

        weights = np.ascontiguousarray(weights, dtype=np.float64)
        if not grid.integrate:
            return gradient_of_samples(pupil, grid, self.tol, weights)
        return averaged_gradient(gradient_of_samples, pupil, grid, self.tol, weights)


# Planes with neighbouring axes share a group: largest extent of the axes, and side of the cells that divide larger
# extents, both in units of the side of the window.
_MAX_SPREAD, _CELL = 0.2, 0.15


def axis_groups(pupil: ObjectivePupil, grid: Grid) -> Iterator[tuple[NDArray[np.int64], ObjectivePupil, Grid]]:
    """Yield groups of planes with a common axis: indices, planes and grid.

    Planes with neighbouring axes share a group, in which tilts of the wavefront replace small shifts of the axis.
    """
    if pupil.depth.size == 1:
        for i, k in enumerate(np.ndindex(pupil.shape)):
            yield np.array([i]), pupil[k] if pupil.shape else pupil, grid[k]
        return
    all_planes = pupil[np.unravel_index(np.arange(pupil.depth.size), pupil.shape)]
    axes, side = grid.axes, np.array(grid.shape)
    cells = np.zeros(len(axes), dtype=np.int64)
    if (np.ptp(axes, axis=0) > _MAX_SPREAD * side).any():
        cells = np.unique(np.floor(axes / (_CELL * side)), axis=0, return_inverse=True)[1].ravel()
    for cell in range(int(cells.max(initial=0)) + 1):
        indices = np.flatnonzero(cells == cell)
        group_axes, planes = axes[indices], all_planes[indices]
        middle = 0.5 * (group_axes.min(axis=0) + group_axes.max(axis=0))
        if len(indices) > 1:
            # A shift d of the axis in v is a tilt: exp(-i (v - d).r) = exp(-i v.r) exp(i d.r).
            row, column = (group_axes - middle).T * grid.step(pupil)
            tilts = Wavefront.from_edge({(1, -1): row, (1, 1): column})
            planes = replace(planes, aberrations=tilts + planes.aberrations if planes.aberrations else tilts)
        yield indices, planes, Grid(grid.shape, grid.side, center=(float(middle[0]), float(middle[1])))


# Limits above which methods over circles (Stratified, DebyeRings) are faster: their tables serve many samples.
_MOST_SAMPLES = 50000  # samples of all planes
_MOST_PLANE_SAMPLES = 10000  # samples of a plane, if each plane has its own axis
_PLAIN_PLANES, _PLAIN_SAMPLES = 8, 20000  # without aberrations: number of planes, and samples of all planes


class ChordalDebyeIfCheaper(ChordalDebye):
    """ChordalDebye that raises Declined if methods over circles are estimated to be faster."""

    def differentiated(
        self, pupil: ObjectivePupil, grid: Grid, tol: float, wanted: Wanted, by: By = _NO_DERIVATIVES
    ) -> tuple[Samples, Array, Array, Array]:
        """Return I at pixel centres and its derivatives; see :meth:`ChordalDebye.differentiated`."""
        planes, samples = pupil.depth.size, pupil.depth.size * math.prod(grid.shape)
        many_unaberrated = not pupil.aberrated and (planes > _PLAIN_PLANES or samples > _PLAIN_SAMPLES)
        common_axis = not grid.stack or planes == 1
        if many_unaberrated or samples > (_MOST_SAMPLES if common_axis else planes * _MOST_PLANE_SAMPLES):
            raise Declined("methods over circles are estimated to be faster for so many samples")
        return super().differentiated(pupil, grid, tol, wanted, by)

    @property
    def reported(self) -> ChordalDebye:
        """Method named in results."""
        return ChordalDebye(self.tol)


class Rule(NamedTuple):
    """Number of chords and number of nodes per chord (both even), and the degree of the radial series."""

    chords: int
    nodes: int
    degree: int


class Fields(NamedTuple):
    """Arguments of the core for the fields of some planes, and bounds on the errors of fields."""

    arguments: tuple[NodeTables, Complex, NodeWaves, Window]
    sets: NDArray[np.int32]  # (series, Zernike term or -1, 0) of each set of fields
    terms: NodeTerms
    field_errors: Array  # bounds on errors of fields, (sets, planes, fields)


@dataclass(frozen=True, eq=False)
class _Case:
    """Quantities of a stack of wavefronts in a window that do not depend on depth and focus."""

    wavefront: Wavefront
    orders: tuple[int, ...]
    emitter: Emitter
    by: By
    sets: NDArray[np.int32]
    degree: int
    wave_index: NDArray[np.int32] | None  # wavefront of each plane; None if all planes share one
    sizes: Growth  # for each set, (sets, b)
    chosen: Array  # bounds that determine the numbers of chords and of nodes, (2, b)
    powers: Array  # bound on each term on the shifted paths, (terms, b)
    ends: NDArray[np.int32]  # index after the last term of each amplitude part
    series: NDArray[np.int32]  # index of the radial series of each set
    truncation: Array  # truncation error of each set of fields, (sets,)
    rounding: Array  # part of the rounding errors that is independent of the rule, in units of _ROUNDING, (sets,)
    rules: dict[Rule, _RuleTables]  # cached tables

    def rule_tables(self, rule: Rule) -> _RuleTables:
        """Return the tables for given numbers of chords and nodes."""
        result = self.rules.get(rule)
        if result is None:
            phase_terms = node_terms(rule.chords, rule.nodes, self.wavefront.terms)
            weight = quadrant(rule.chords, rule.nodes).weight
            waves = folded_waves(phase_terms, self.wavefront.edge, weight)
            tables = node_tables(rule, self.orders, self.emitter)
            rounding = _ROUNDING * (2.0 * (rule.chords + rule.nodes) + self.rounding)
            terms = node_terms(rule.chords, rule.nodes, self.by.terms)
            result = _RuleTables(tables, waves, terms, curves(self.sizes, rule), rounding)
            if len(self.rules) < _MOST_RULES and waves.nbytes <= _MOST_BYTES:
                self.rules[rule] = result
        return result


class _RuleTables(NamedTuple):
    """Tables for the fields of one rule."""

    tables: NodeTables
    waves: NDArray[np.complex128]
    terms: NodeTerms
    curves: tuple[Array, Array]
    rounding: Array  # rounding error of a field, divided by the sum of the moduli of amplitudes, (sets,)


_MOST_RULES, _MOST_BYTES = 8, 2**20  # number of cached rules, and largest size (bytes) of the waves of a cached rule


@lru_cache(maxsize=32)
def _case(
    layers: Layers, emitter: Emitter, aberrations: Wavefront | None, window: Window, by: By, field_error: float
) -> _Case:
    wavefront, model = (aberrations or _FLAT_WAVEFRONT).flattened(), emitter.light.model
    axis, shape = np.array(window.center), np.array(window.shape)
    base_growth = growth(wavefront, -axis * window.step, (shape - 1.0 - axis) * window.step)
    # The degree allows for the factor of the highest Zernike term of the derivatives.
    limit = base_growth.times(max((n for n, _ in by.terms), default=0))
    norm = projection.norm(layers, model)
    degree = degree_for(limit.projection, norm, _FRACTIONS[0] * field_error)
    sets = [*_series(by), *((0, k, 0) for k in range(len(by.terms)))]
    factors = [0 if term < 0 else by.terms[term][0] for _, term, _ in sets]
    sizes = Growth(*(np.stack(parts) for parts in zip(*(base_growth.times(n) for n in factors), strict=True)))
    truncation = norm * truncation_error(sizes.projection, degree)
    reach = window.step * float(np.hypot(*np.maximum(axis, shape - 1.0 - axis)))
    per_term = wavefront.indices[:, 0] ** 2 * 3.0 + 16.0 + len(wavefront.terms)
    # Section 16, "Rounding", without 2 N + 2 K for the N chords and K nodes of the rule.
    rounding = 4.0 * degree + 64.0 + 9.0 * reach + (np.abs(wavefront.edge) @ per_term).max()
    # Further rounding errors, from a factor of degree n: section 8, "Derivatives".
    extra = [6.0 * n * n for n in factors]
    counts = [projection.degrees(q, degree).size for q in model.orders]
    powers = np.concatenate([_powers(q, degree) for q in model.orders])
    chosen = [
        (mean - math.log(part * field_error)) * _QUARTER
        for mean, part in zip((limit.chords + _OVER_CHORDS, limit.nodes + _OVER_NODES), _FRACTIONS[1:], strict=True)
    ]
    planes = len(wavefront.edge)
    return _Case(
        wavefront, model.orders, emitter, by, np.array(sets, dtype=np.int32), degree,
        np.arange(planes, dtype=np.int32) if planes > 1 else None, sizes, np.array(chosen), powers,
        np.cumsum(counts, dtype=np.int32), np.array([k for k, _, _ in sets], dtype=np.int32), truncation,
        rounding + np.array(extra), {},
    )  # fmt: skip


def fields(pupil: ObjectivePupil, grid: Grid, field_error: float, by: By) -> Fields:
    """Return arguments for fields of planes with one axis and their derivatives, with errors of about `field`."""
    window = Window(grid.shape, grid.axis, grid.step(pupil))
    case = _case(pupil.layers, pupil.emitter, pupil.aberrations, window, by, field_error)
    series = projection.amplitudes(pupil, case.degree, _QUADRATURE * field_error, by.rates)
    # The weights of a rule have the sum 1: a weighted sum of an amplitude is at most the sum of moduli of its terms.
    sizes, chords, nodes = chordal_series_sizes(series.coefficients, case.ends, case.powers, _QUARTER, case.chosen)
    tables_of_rule = case.rule_tables(Rule(_even_count(chords), _even_count(nodes), case.degree))
    shares = _part_moduli(pupil.emitter)
    field_errors = chordal_field_errors(
        sizes, case.series, tables_of_rule.curves, case.truncation, tables_of_rule.rounding, shares, series.error
    )
    index = np.zeros(pupil.depth.size, dtype=np.int32) if case.wave_index is None else case.wave_index
    arguments = tables_of_rule.tables, series.coefficients, NodeWaves(tables_of_rule.waves, index), window
    return Fields(arguments, case.sets, tables_of_rule.terms, field_errors)


def intensities(
    pupil: ObjectivePupil, grid: Grid, field_error: float, threads: int, by: By = _NO_DERIVATIVES
) -> tuple[Array, Array, Array]:
    """Return I at pixel centres around one axis, and its derivatives, from fields with errors of about `field`.

    The values have the shape (1 + k, n, height, width). The other two arrays, (1 + k, n), are bounds on the errors
    and on the largest moduli of the values.
    """
    data = fields(pupil, grid, field_error, by)
    return chordal_series_light(*data.arguments, data.sets, data.terms, data.field_errors, pupil.power, threads)


def sums(
    pupil: ObjectivePupil, grid: Grid, field_error: float, weights: Array, threads: int, by: By
) -> tuple[Array, Array, Array]:
    """Return weighted sums of I and their derivatives, (n, 1 + k), for one axis; also the largest I and its error."""
    data = fields(pupil, grid, field_error, by)
    sets = np.array(_series(by), dtype=np.int32)
    results, largest = chordal_series_gradient(*data.arguments, sets, data.terms, weights, threads)
    peak, error = largest[:, 0], error_of_light(data.field_errors[0], largest[:, 1:])
    return results / pupil.power[:, None], peak / pupil.power, error / pupil.power * (1.0 + 1e-12)


def _series(by: By) -> list[tuple[int, int, int]]:
    """Return the sets of fields without a Zernike term, of I and of its derivatives by rates."""
    return [(k, -1, 0) for k in range(1 + len(by.rates))]


def error_of_light(field_errors: Array, largest: Array) -> Array:
    """Bound the error of a sum of squared fields with `field_errors` and moduli up to `largest`; shape (n,)."""
    return np.asarray((field_errors * (2.0 * largest + field_errors) + 32.0 * _ROUNDING * largest**2).sum(axis=-1))


@lru_cache(maxsize=64)
def _rows(emitter: Emitter) -> Complex:
    """Return the fields of an emitter as linear combinations of its waves; I is the sum of their squared moduli."""
    return squares(emitter.light.waves.form)


@lru_cache(maxsize=64)
def _part_moduli(emitter: Emitter) -> Array:
    """Return the moduli of the coefficients of amplitude parts in the fields of an emitter."""
    parts, count = np.array(emitter.light.waves.parts), len(emitter.light.model.orders)
    return np.asarray(np.abs(_rows(emitter)) @ (parts[:, None] == np.arange(count)).astype(np.float64))


@lru_cache(maxsize=64)
def _powers(order: int, degree: int) -> Array:
    """Return bounds on each term of an amplitude on the shifted paths, shape (terms, b)."""
    return np.asarray(np.exp(np.outer(projection.degrees(order, degree), _B)))


class Growth(NamedTuple):
    """Logarithms of bounds on the means of ``abs(exp(i W - i v.r))`` on the shifted paths, each of shape (..., b)."""

    projection: Array  # for the projection
    chords: Array  # for the sum over chords
    nodes: Array  # for the sums over nodes

    def times(self, n: int) -> Growth:
        """Return bounds for integrands with a Zernike term of degree n, at most ``cosh(n b)``, as a factor."""
        return Growth(*(log_mean + _factor(n) for log_mean in self)) if n else self


@lru_cache(maxsize=256)
def _factor(n: int) -> Array:
    return np.asarray(n * _B + np.log(0.5 + 0.5 * np.exp(-2.0 * n * _B)))


@lru_cache(maxsize=256)
def _sinh(n: int) -> Array:
    return np.asarray(np.sinh(n * _B))


def growth(wavefront: Wavefront, low: Array, high: Array) -> Growth:
    """Return bounds for a stack of wavefronts, in a window from v = `low` to v = `high`, (y, x)."""
    terms, reach = wavefront.edge_terms(), []
    for edges, term in zip(zip(low.tolist(), high.tolist(), strict=True), ((1, -1), (1, 1)), strict=True):
        # A tilt shifts the image: the integrand depends on v minus the tilt.
        tilt = terms.get(term, 0.0)
        reach.append(max(float(np.abs(edge - tilt).max()) for edge in edges))
    total = np.zeros(_B.shape)
    for (n, _), w in wavefront.amplitudes().items():
        if n > 1:
            total += w * _sinh(n)
    return Growth(*(total + kernel_mean for kernel_mean in means_of_kernel(reach[0], reach[1])))


def means_of_kernel(y: float, x: float) -> tuple[Array, Array, Array]:
    """Bound the logarithms of the means of ``abs(exp(-i v.r))``, as in :class:`Growth`, for abs(v) up to (y, x)."""
    # m_1 = sinh(s) / s, s = abs(v) sinh(b): section 16, "Projection".
    s = np.maximum(math.hypot(y, x) * _SINH, 1e-12)
    over_disc = s + np.log(-np.expm1(-2.0 * s) / (2.0 * s))
    # The trapezoidal rule overestimates the mean of a convex function.
    exponent = np.maximum(np.outer(_SINH, np.hypot(x, y * _ETA)), 1e-12)
    scaled = np.exp(exponent - s[:, None]) * np.minimum(1.0, np.sqrt(_BESSEL / exponent))
    over_chords = s + np.minimum(0.0, np.log(_CHORD_WEIGHT * (0.5 * (scaled[:, 1:] + scaled[:, :-1])).mean(axis=1)))
    # m_K <= I_0(abs(v_y) sinh b) <= exp(s) sqrt(pi / (8 s)).
    over_nodes = np.maximum(y * _SINH, 1e-12)
    return over_disc, over_chords, over_nodes + np.minimum(0.0, 0.5 * np.log(_BESSEL / over_nodes))


def truncation_error(log_means: Array, degree: int) -> Array:
    """Bound the contribution of terms above `degree` to a field, divided by the norm; `size` has shape (..., b)."""
    return np.asarray(np.exp(np.minimum(700.0, (log_means + _tail_exponent(degree)).min(axis=-1))))


@lru_cache(maxsize=256)
def _tail_exponent(degree: int) -> Array:
    return np.asarray(_tail(degree + 1.0) - (degree + 1.0) * _B)


def _tail(first_degree: Array | float) -> Array:
    """Return the logarithm of the tail of the series from degree `first` on, without the factor exp(-first b)."""
    # The squared tail is the sum over n = D + 1, D + 3, ... of (n + 1) exp(-2 n b).
    terms = (first_degree + 1.0) / (1.0 - _RATIO) + 2.0 * _RATIO / (1.0 - _RATIO) ** 2
    return np.asarray(0.5 * np.log(terms) + np.log1p(np.exp(-2.0 * _B)))


_FIRST_TAIL = _tail(40.0)
_TOO_LARGE = "window or aberrations too large for ChordalDebye; leave method out, or use a smaller window"


def degree_for(log_means: Array, norm: float, error: float) -> int:
    """Return the degree at which truncation of amplitudes with this norm causes an error of at most about `error`."""
    log_reduction = log_means + math.log(norm / error)
    # The tail depends weakly on the degree: two steps of a fixed-point iteration suffice.
    first_degree = np.maximum((log_reduction + _FIRST_TAIL) / _B, 1.0)
    first_degree = np.maximum((log_reduction + _tail(first_degree)) / _B, 1.0)
    degree = math.ceil(float(first_degree.min())) - 1
    if degree > _MOST_DEGREE:
        raise Declined(_TOO_LARGE)
    return degree


def _even_count(half_count: float) -> int:
    """Return the even number of chords or nodes that is proven to suffice, from half of this number."""
    count = 2 * max(2, math.ceil(half_count))
    if count > _MOST_NODES:
        raise Declined(_TOO_LARGE)
    return count


def curves(means: Growth, rule: Rule) -> tuple[Array, Array]:
    """Return the errors of the sums over chords and over nodes, for amplitudes of modulus 1 on the shifted paths."""
    over_chords, over_nodes = _rule_errors(rule.chords, rule.nodes)
    return np.exp(np.minimum(means.chords + over_chords, 600.0)), np.exp(np.minimum(means.nodes + over_nodes, 600.0))


@lru_cache(maxsize=64)
def _rule_errors(chords: int, nodes: int) -> tuple[Array, Array]:
    """Return the logarithms of the relative errors of sums over chords and over nodes."""
    # Certificate, section 8: e_N and e_K, divided by the mean modulus of the integrand on the shifted paths.
    over_chords = np.log1p(_RATIO) - np.log(-np.expm1(-2.0 * (chords + 1) * _B)) - 2.0 * chords * _B
    return over_chords, _OVER_NODES - 2.0 * nodes * _B


class Quadrant(NamedTuple):
    """Nodes with x, y > 0, shape (chords / 2, nodes / 2), and their weights."""

    rho: Array
    theta: Array
    weight: Array


@lru_cache(maxsize=16)
def quadrant(chords: int, nodes: int) -> Quadrant:
    """Return the nodes of a rule in the quadrant x, y > 0, and their weights."""
    # The other quadrants are mirror images; the core adds their waves to the waves of this one.
    angle = np.pi / (chords + 1) * np.arange(1, chords // 2 + 1)[:, None]
    eta, weight = (values[::-1][: nodes // 2] for values in gauss_legendre(nodes, -1.0, 1.0))
    x, y = np.cos(angle) + 0.0 * eta, np.sin(angle) * eta
    return Quadrant(np.hypot(x, y), np.arctan2(y, x), np.sin(angle) ** 2 * weight / (chords + 1))


@lru_cache(maxsize=16)
def node_tables(rule: Rule, orders: tuple[int, ...], emitter: Emitter) -> NodeTables:
    """Return the tables of an emitter's fields at the nodes of a quadrant."""
    nodes, waves = quadrant(rule.chords, rule.nodes), emitter.light.waves
    radial = [zernike.radials(q, max(rule.degree, q), nodes.rho) for q in orders]
    shares, factors = [], []
    for c, row in enumerate(_rows(emitter)):
        for coefficient, q, j in zip(row, waves.orders, waves.parts, strict=True):
            for parity, factor in zip(
                _PARITIES[q % 2], (np.cos(q * nodes.theta), 1j * np.sin(q * nodes.theta)), strict=True
            ):
                if coefficient and (q or not parity):
                    shares.append((c, parity, j))
                    factors.append(coefficient * factor)
    ends = np.cumsum([len(functions) for functions in radial])
    return NodeTables(
        np.concatenate(radial), ends.astype(np.int32), np.array(shares, dtype=np.int32), np.stack(factors)
    )


# Parities are numbered by 2 (if odd in x) + 1 (if odd in y).
_PARITIES = ((0, 3), (2, 1))  # of the cosine and the sine of q theta, for even and odd q


@lru_cache(maxsize=16)
def node_terms(chords: int, nodes: int, terms: tuple[tuple[int, int], ...]) -> NodeTerms:
    """Return Zernike terms at the nodes of a quadrant, and the parity of each term."""
    points = quadrant(chords, nodes)
    odd_y = np.array([m < 0 for _, m in terms], dtype=np.int32)
    odd_x = np.array([(abs(m) + (m < 0)) % 2 for _, m in terms], dtype=np.int32)
    values = [zernike.polynomial(n, m, points.rho, points.theta) for n, m in terms]
    return NodeTerms(np.reshape(values, (len(terms), *points.rho.shape)), 2 * odd_x + odd_y)


# Averages over discs are sums over chords of the same kind of rule: certificate, "Scanning microscopes and beads".
_DISC_B = np.geomspace(0.02, 6.0, 96)
_MOST_DISC_CHORDS = 200


def chords_for(radius: float, error: float) -> int:
    """Return the smallest even number of chords for which the error of a disc average is at most `error`."""
    for chords in range(2, _MOST_DISC_CHORDS + 1, 2):
        if chord_error(radius, chords) <= error:
            return chords
    raise Declined("with aberrations, averages are limited to discs of 15 Airy units; use a smaller pinhole or bead")


def chord_error(radius: float, chords: int) -> float:
    """Bound the error of the transfer function of a disc of `radius` (in v), computed as a sum over chords."""
    # Section 8 for the integrand exp(i s w.r) with abs(w) <= 2.
    bound = np.exp(np.minimum(2.0 * radius * np.sinh(_DISC_B) - 2.0 * chords * _DISC_B, 600.0))
    return float(((1.0 + np.exp(-4.0 * _DISC_B)) * bound / -np.expm1(-2.0 * (chords + 1) * _DISC_B)).min())


# Parameter searches only need errors that are small relative to the noise; a certified image checks their result. The
# searches use rules of fixed size, with about half as many chords and nodes as the proof requires. Pixels, beads and
# blur are linear filters of the samples. The OTF of I is 0 at frequencies abs(w) > 2. Below, filter weights are
# fitted to the transfer function by least squares, weighted with the OTF of a circular aperture.

Term = tuple[int, int]
MIN_MARGIN = 7  # smallest number of samples on each side of a filter
_MAX_SPACING = 1.535  # v between samples; pi/2 is the Nyquist limit
_BAND = 2.0 * np.cos((np.arange(160) + 0.5) * (0.5 * math.pi / 160))  # Chebyshev points of [0, 2]
_HALF_BAND = 0.5 * _BAND
_WEIGHT = 2.0 / math.pi * (np.arccos(_HALF_BAND) - _HALF_BAND * np.sqrt(1.0 - _HALF_BAND * _HALF_BAND)) + 1e-3
# _WEIGHT is the OTF of a circular aperture, plus 0.001 to keep the fit determined at the end of the band.
_DISC = 1e-4  # allowed error of the transfer function of a disc


class Planes(NamedTuple):
    """Depths and stage positions of planes (metres), and phase coefficients (radians at the edge)."""

    depth: Array  # (n,)
    focus: Array  # (n,)
    edge: Array  # (n, terms), or (1, terms) if all planes share one wavefront


class SampleLattice(NamedTuple):
    """Lattice of samples from which pixels are filtered, with a margin of `half` samples."""

    shape: tuple[int, int]
    center: tuple[float, float]  # (row, column) of the axis, pixels
    step: float  # pixel pitch in v
    half: int

    @property
    def stride(self) -> int:
        """Number of samples per pixel along each axis."""
        return max(1, math.ceil(self.step / _MAX_SPACING))

    @property
    def window(self) -> Window:
        """Window of all samples, with the margin."""
        s, half = self.stride, self.half
        height, width = (s * (side - 1) + 2 * half + 1 for side in self.shape)
        row, column = (s * position + half for position in self.center)
        return Window((height, width), (row, column), self.step / s)


def search_rule(reach: float, phase: float) -> Rule:
    """Return a rule for samples up to `reach` in v along each axis, and phases up to `phase` (radians)."""
    # Fitted to stacks over 2 um at NA 1.2 to 1.49, with errors of 1e-4 of the peak.
    count = 2 * math.ceil(0.5 * (0.54 * reach + 17.0 + 0.9 * phase))
    return Rule(count + 2, count, count - 4)


def light(
    layers: Layers,
    emitter: Emitter,
    planes: Planes,
    samples: SampleLattice,
    rule: Rule,
    terms: tuple[Term, ...],
    *,
    by: tuple[Term, ...] = (),
    by_focus: bool = False,
    by_amplitude: tuple[int, ...] = (),
    threads: int = 0,
) -> Array:
    """Return I, not normalized to the collected light, and its derivatives, (1 + k, n, height, width).

    `terms` are the Zernike terms of `planes.edge`. Derivatives are with respect to focus (per metre, `by_focus`),
    radial terms of the logarithm of the amplitude (degrees `by_amplitude`, nepers rms), and the terms `by` (radians
    at the edge).
    """
    model = emitter.light.model
    coefficients = _amplitudes(layers, model, planes, rule.degree, by_amplitude, by_focus=by_focus)
    tables = node_tables(rule, model.orders, emitter)
    nodes = node_terms(rule.chords, rule.nodes, terms)
    weight = quadrant(rule.chords, rule.nodes).weight
    edge = np.ascontiguousarray(planes.edge, np.float64)
    waves = folded_waves(nodes, edge, weight)
    count = planes.depth.size
    index = np.zeros(count, np.int32) if len(edge) == 1 else np.arange(count, dtype=np.int32)
    derivative_terms = node_terms(rule.chords, rule.nodes, by)
    sets = [*((k, -1, 0) for k in range(len(coefficients))), *((0, k, 0) for k in range(len(by)))]
    # The rule has no error bound: errors of fields are set to 0.
    no_error = np.zeros((len(sets), count, int(tables.shares[:, 0].max()) + 1))
    arguments = tables, coefficients, NodeWaves(waves, index), samples.window, np.array(sets, dtype=np.int32)
    return chordal_series_light(*arguments, derivative_terms, no_error, np.ones(count), threads)[0]


def _amplitudes(
    layers: Layers, model: Model, planes: Planes, degree: int, by_amplitude: tuple[int, ...], *, by_focus: bool
) -> Complex:
    """Return the radial series of the amplitudes of planes and their derivatives, (1 + rates, n, terms)."""
    rates, weights, rho = _integrals(layers, model, degree, _nodes(layers, planes, degree))
    constant, by_depth, by_stage = rates
    waves = np.exp(1j * (constant + np.outer(planes.depth, by_depth) + np.outer(planes.focus, by_stage)))
    amplitudes = [waves]
    if by_focus:
        amplitudes.append(waves * (1j * (by_stage - layers.middle_rates()[1])))
    amplitudes += [waves * (math.sqrt(n + 1.0) * zernike.radial(n, 0, rho)) for n in by_amplitude]
    return np.stack([np.einsum("pq,qt->pt", amplitude, weights) for amplitude in amplitudes])


def _nodes(layers: Layers, planes: Planes, degree: int) -> int:
    """Return the number of quadrature angles per section, from the degree and the phase change over the pupil."""
    rates = layers.rates(layers.cosine(np.array([0.0, 0.7, min(1.0, layers.sample / layers.NA)])))
    # Phase change from the axis to the rim, or to the critical angle.
    changes = [float(np.abs(np.ptp(rate.real)) + np.abs(np.ptp(rate.imag))) for rate in rates]
    change = changes[0] + changes[1] * float(planes.depth.max()) + changes[2] * float(np.abs(planes.focus).max())
    return 8 * math.ceil((20.0 + 0.5 * degree + 0.6 * change) / 8.0)


@lru_cache(maxsize=64)
def _integrals(
    layers: Layers, model: Model, degree: int, nodes: int
) -> tuple[tuple[Complex, Complex, Complex], Complex, Array]:
    """Return phase rates at the quadrature angles, weights of the angles in each radial term, and rho."""
    sections = debye.pieces(layers, model)
    rho, parts, rates = debye.tabulated(sections, model, (nodes,) * len(sections))
    return rates, projection.series_weights(model, degree, rho, parts), rho


class Filter(NamedTuple):
    """Sum of separable filters: pairs of matrices (rows, columns) from samples to pixels."""

    parts: tuple[tuple[Array, Array], ...]

    def of(self, samples: Array) -> Array:
        """Return pixels (..., height, width) from samples."""
        # One small product for each image: BLAS starts no threads for small products.
        total: Array | float = 0.0
        for rows, columns in self.parts:
            row_matrix, column_matrix = (matrix.astype(samples.dtype, copy=False) for matrix in (rows, columns))
            total = total + np.matmul(np.matmul(row_matrix, samples), column_matrix.T)
        return np.asarray(total)


def pixel_filter(
    samples: SampleLattice, disc: float = 0.0, variance: float = 0.0, *, integrate: bool = True
) -> Filter:
    """Return the filter of pixel integration, a disc (radius `disc` in v) and a Gaussian blur (`variance` in v^2)."""
    s, half, side = samples.stride, samples.half, samples.step if integrate else 0.0
    h = samples.step / s

    # Transfer function along one axis: pixel, Gaussian, mean over a chord (sinc), and a pair of chords (cosine).
    def axis_response(w: Array, mean: float, cosine: float) -> Array:
        response = np.sinc(side * w / (2.0 * math.pi)) * np.exp(-0.5 * variance * w * w)
        return np.asarray(response * np.sinc(mean * w / math.pi) * np.cos(cosine * w))

    chords = 0 if disc == 0.0 else chords_for(disc, _DISC)
    angles = np.pi / (chords + 1) * np.arange(1, chords // 2 + 1) if chords else np.array([0.5 * np.pi])
    parts = []
    for angle in angles:
        weight = 4.0 / (chords + 1) * math.sin(angle) ** 2 if chords else 1.0
        rows = _fit_weights(axis_response(_BAND, disc * math.sin(angle), 0.0), h, half)
        columns = weight * _fit_weights(axis_response(_BAND, 0.0, disc * math.cos(angle)), h, half)
        height, width = samples.shape
        parts.append((_filter_matrix(rows, s, height), _filter_matrix(columns, s, width)))
    return Filter(tuple(parts))


def _fit_weights(response: Array, h: float, half: int) -> Array:
    """Return filter weights, for samples with spacing `h` in v, fitted to a transfer function."""
    return np.asarray(_inverse(h, half) @ (_WEIGHT * response))


@lru_cache(maxsize=64)
def _inverse(h: float, half: int) -> Array:
    """Return the least-squares matrix from transfer functions to symmetric filter weights."""
    x = h * np.arange(half + 1)
    basis = np.where(x > 0.0, 2.0, 1.0) * np.cos(np.outer(_BAND, x))
    inverse = np.linalg.pinv(_WEIGHT[:, None] * basis, rcond=1e-10)
    return np.concatenate([inverse[:0:-1], inverse])


def _filter_matrix(weights: Array, stride: int, side: int) -> Array:
    """Return the matrix of a filter, from samples to `side` pixels."""
    matrix = np.zeros((side, stride * (side - 1) + weights.size))
    for i in range(side):
        matrix[i, stride * i : stride * i + weights.size] = weights
    return matrix
