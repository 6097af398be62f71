"""PSFs of apertures of any shape: quadrature along rows, summed by a non-uniform FFT, with a proven error bound.

A row is a set of quadrature nodes on a line of constant y; a chord is a row that crosses the whole disc. Stacks
and derivatives on small windows use the moment rule instead, a quadrature rule of the disc that has the same moments
as the aperture: certificate, section 18.

References
----------
T. Koornwinder, "Two-variable analogues of the classical orthogonal polynomials", in Theory and Application of Special
Functions, Academic Press (1975), 435.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache, partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core import engine
from lommel.core.answers import Declined, Intensities, Pixels, Samples, Slopes, Wanted, not_met
from lommel.core.engine import DiskStack, Window, aperture_averages, aperture_images, row_images
from lommel.methods.averaging import averaged_images
from lommel.methods.matrix_fourier import samples_needed
from lommel.methods.method import Method, relative_error, storing, to_images, with_storage_rounding
from lommel.methods.nijboer_zernike import disk_stack, window_of
from lommel.optics.aperture.opening import Opening, degree_needed
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.special.legendre import gauss_legendre

Complexes = NDArray[np.complex128]

_UNIT = 2.0**-53  # unit roundoff
_MOMENT_SHARE = 0.2  # fraction of the requested error for each approximation by polynomials
_MOMENT_SINGLE_SHARE = 1.0  # sums in single precision are tried up to this error over the requested one
_MIN_FIELD_ERROR = 3e-12  # relative error of the field below which rounding errors dominate
_MAX_WAVES = 2**25  # largest number of tabulated cosines and sines of the nodes
_MAX_DEGREE = 400  # largest degree of a moment rule
_SAMPLES_SHARE = 0.25  # fraction of the time of sums for sampling the growth of pupil functions
_USUAL_GROWTH = 0.4  # typical logarithm of the mean growth over the bound by the maxima of all terms
_STEPS = 24  # assumed number of stacks or steps of a fit with the same rule
_SINGLE_ERROR = 3e-7  # likely least error of sums in single precision
_LONE_VECTOR = 0.4  # time of averages of a single image over that of a vector of pupils
_RULE_COST = 1.0  # factor of the time of a rule
_DEGREE_STEP = 8  # degrees are rounded up to multiples of this
_MOMENT_STEP = 32  # the same for degrees up to which moments are computed


# Moment rule. A quadrature rule of the aperture is a linear functional L. For polynomials p up to degree D there is
# one polynomial g with L(p) = integral of p g over the disc. A rule of the disc that is exact to degree 2 D therefore
# yields L(p) if its weights omega are multiplied by g. The rule has D + 2 chords of D + 2 nodes, for any number of
# vanes or segments. The products of weights and g may be negative or complex; the sum of their moduli is at most
# ``sqrt(sum omega) sqrt(sum omega |g|^2)``, about the square root of the transmitted area (certificate, section 18,
# "Moments").
#
# g is the sum of ``L(phi) phi`` over an orthonormal basis phi: products of Gegenbauer polynomials of y and Legendre
# polynomials along the chord at y (Koornwinder 1975), computed by one recurrence along each axis.


def moment_rule_is_faster(
    pupil: Pupil, grid: Grid, terms: tuple[tuple[int, int], ...], degree: int, rule_degree: int, error: float
) -> bool:
    """Return True if the moment rule of these degrees and this error takes less time than transforms of rows."""
    height = grid.shape[0]
    rows = degree + 0.5 * _DEGREE_STEP + 2.0
    if degree > _MAX_DEGREE or rows**2 * height > _MAX_WAVES or error < _MIN_FIELD_ERROR * pupil.amplitude:
        return False
    times = _Times.of(pupil, len(terms), degree, rule_degree, error)
    return times.rule + _STEPS * times.sums(*grid.shape) < _STEPS * times.transforms(*grid.shape)


class _Times(NamedTuple):
    """Estimated times in microseconds, fitted to those of 200 questions about five apertures, of 9 to 400 pixels."""

    rows: float  # of the moment rule
    nodes: int  # in the rows of the aperture
    lines: int  # rows of the aperture, of all regions
    images: int  # images and derivatives
    vectors: int  # vectors of pupils for images and derivatives

    @classmethod
    def of(cls, pupil: Pupil, terms: int, degree: int, rule_degree: int, error: float) -> _Times:
        """Return the times for `terms` derivatives; other arguments are those of :func:`moment_rule`."""
        _, rounded_degree, power = _round_up_degrees(degree, rule_degree, error)
        count, lanes = math.prod(pupil.shape), 16 if error >= _SINGLE_ERROR else 8
        rows = degree + 0.5 * _DEGREE_STEP + 2.0
        sizes = _count_nodes(pupil.opening, rounded_degree, power)
        return cls(rows, *sizes, count * (1 + terms), math.ceil(count / lanes) * (1 + terms))

    @property
    def rule(self) -> float:
        """Time of a moment rule."""
        return 350.0 + _RULE_COST * (
            (0.015 + 5.6e-4 * self.rows) * self.rows**2 + (0.16 + 1.4e-3 * self.rows) * self.nodes
        )

    def sums(self, height: float, width: float) -> float:
        """Time of samples by the moment rule."""
        products = (0.023 + 6e-4 * height) * self.rows**2
        return 900.0 + self.vectors * products + 0.012 * self.images * height * width

    def transforms(self, height: float, width: float) -> float:
        """Time of samples by transforms of rows."""
        each = 0.036 * self.nodes + (0.06 * self.lines + 0.015 * height) * width
        return 1700.0 + self.images * each

    def averages(self, height: int, width: int, rows: int, columns: int) -> float:
        """Time of averages over ``height x width`` pixels from samples at nodes."""
        filters = 8e-4 * rows * height * (columns + width)
        vectors = _LONE_VECTOR if self.images == 1 else self.vectors
        return 450.0 + vectors * ((0.05 + 6e-4 * columns) * self.rows * rows + filters)


class MomentRule(NamedTuple):
    """Weights of the nodes of the disc rule, shape (rows, rows)."""

    weight: Complexes
    total: float  # sum of the moduli of the weights
    steps: float  # roundings of sums in single precision, in units of 2^-24: moduli times numbers of steps
    edge_error: float  # error of U due to edges that rounding displaces

    @property
    def rows(self) -> int:
        """Number of rows, even."""
        return len(self.weight)


class Nodes(NamedTuple):
    """Rule of the unit disc: rows at `y`, nodes `x` along each row, shape (rows, rows), and their weights."""

    y: Array
    x: Array
    t: Array  # node positions along the chord, in units of half its length
    weight: Array


@lru_cache(maxsize=8)
def nodes(rows: int) -> Nodes:
    """Return the rule of the disc that is exact to degree ``2 rows - 1`` and symmetric about both axes."""
    # Chords at y = cos(t_i), t_i = i pi / (N + 1), with weights sin^2 t_i / (N + 1): certificate, section 8.
    theta = (np.arange(rows) + 1.0) * (math.pi / (rows + 1))
    end, (t, weight) = np.sin(theta), gauss_legendre(rows, -1.0, 1.0)
    return Nodes(np.cos(theta), np.outer(end, t), np.asarray(t), np.outer(end**2 / (rows + 1), weight))


def moment_rule(opening: Opening, degree: int, rule_degree: int, error: float) -> MomentRule:
    """Return the moment rule whose sums equal those of :meth:`Opening.rows` for polynomials up to `degree`.

    The rows, exact to degree `rule_degree` with about this `error`, also integrate the phase factors of segments; the
    weights of the moment rule contain these factors.
    """
    return _moment_rule(opening, *_round_up_degrees(degree, rule_degree, error))


def degrees_and_error(
    pupil: Pupil, reach: tuple[float, float], allowed: float, shape: tuple[int, int], growth: Growth
) -> tuple[int, int, float]:
    """Return `degree` and `rule_degree` of :func:`moment_rule`, and the resulting error of U.

    The error holds for v up to `reach` along x and y. Each polynomial approximation has an error of at most
    `allowed`. For the derivative by a Zernike term, add the degree of the term to both degrees. `shape`: numbers of
    pixels or nodes along x and y, for the time that a lower degree saves.
    """
    terms = [(n, w) for (n, _), w in pupil.wavefront.each_amplitude().items()]
    phases = pupil.opening.phases
    steepest = float(np.hypot(phases[:, 1], phases[:, 2]).max())
    degree = degree_needed(terms, math.hypot(*reach), pupil.illumination, allowed)
    if _samples_pay(pupil, degree, shape):
        mean = _sampled_growth(pupil, reach, allowed, growth)
        degree = min(degree, degree_needed(terms, math.hypot(*reach), pupil.illumination, allowed, mean=mean))
    # A polynomial approximates the phase factor of a segment; its degree adds to the degree of the pupil function.
    rule_degree = degree + (degree_needed([], steepest, pupil.illumination, allowed, power=0.0) if steepest else 0)
    return degree, rule_degree, polynomial_error(pupil, allowed)


def polynomial_error(pupil: Pupil, allowed: float) -> float:
    """Bound the error of U by a rule for polynomials that are within ``allowed / 2`` of the pupil function."""
    # Section 18, "A polynomial": a (1 + W) / 2 + (1 + a / 2) a, with a = `allowed` and W <= 1 + a.
    return 1.1 * allowed + (1.0 + allowed) * allowed + phase_roundings(pupil)


def _samples_pay(pupil: Pupil, degree: int, shape: tuple[int, int]) -> bool:
    """Return whether sampling the growth of pupil functions takes little time beside the sums that it shortens."""
    terms = pupil.wavefront.terms
    highest, order = max(n for n, _ in terms), max(1, *(abs(m) for _, m in terms))
    # Vector operations for each pupil: of sampled_growth() in the core, and of the sums by this degree.
    samples = (3.0 * highest + 1.0) ** 2 * math.ceil(5.0 * order / 16.0) * (2.0 * len(terms) + 40.0)
    sums = (degree**2 * (shape[0] + 40.0) + degree * shape[0] * shape[1]) / 16.0
    return highest > 1 and samples < _SAMPLES_SHARE * sums


Growth = Callable[[int, tuple[float, float]], float]


def _growth_of(stack: DiskStack, threads: int) -> Growth:
    """Return :func:`engine.stack_growth` of a stack, computed once for each curve and window."""
    return cache(lambda curve, reach: engine.stack_growth(stack, curve, reach, threads))


def _sampled_growth(pupil: Pupil, reach: tuple[float, float], error: float, growth: Growth) -> tuple[float, float]:
    """Return the height b of one complex curve and the logarithm of the mean growth on it, of all pupils."""
    b = engine.growth_curves()
    b = b[max(n for n, _ in pupil.wavefront.terms) * b < 15.0]
    phases = [np.multiply.outer(w, np.sinh(n * b)) for (n, _), w in pupil.wavefront.each_amplitude().items()]
    # The curve of the lowest degree if the mean is the usual part of what all terms add up to.
    likely = _USUAL_GROWTH * np.sum(phases, axis=0).reshape(-1, b.size).max(axis=0) + math.hypot(*reach) * np.sinh(b)
    curve = int(np.argmin((likely + 10.0 - math.log(error)) / b))
    return float(b[curve]), growth(curve, reach)


def phase_roundings(pupil: Pupil) -> float:
    """Bound the error of U due to rounding of segment phases, which may be many turns."""
    # Certificate, section 18, "Phases": 8 u s ||A||, s the largest sum of moduli of three coefficients.
    return 8.0 * _UNIT * float(np.abs(pupil.opening.phases).sum(axis=1).max()) * math.sqrt(pupil.amplitude)


def _round_up_degrees(degree: int, rule_degree: int, error: float) -> tuple[int, int, int]:
    """Return degrees rounded up and the exponent of the error rounded down, so that cached rules are reused."""
    degree = _DEGREE_STEP * math.ceil(degree / _DEGREE_STEP)
    rule_degree = _MOMENT_STEP * math.ceil(max(rule_degree, degree) / _MOMENT_STEP)
    return degree, rule_degree, 2 * math.floor(0.5 * math.log10(error))


@lru_cache(maxsize=16)
def _count_nodes(opening: Opening, rule_degree: int, power: int) -> tuple[int, int]:
    """Return the numbers of nodes in all rows, and of rows."""
    heights = [rule.nodes[1] for rule in opening.rows(rule_degree, 10.0**power)]
    return sum(map(len, heights)), sum(int(np.count_nonzero(np.diff(y))) + 1 for y in heights)


@lru_cache(maxsize=16)
def _moment_rule(opening: Opening, degree: int, rule_degree: int, power: int) -> MomentRule:
    moments, edge_error = _moments(opening, _MOMENT_STEP * math.ceil(degree / _MOMENT_STEP), rule_degree, power)
    # Values of g = sum L(phi) phi at the nodes, times the weights of the disc rule (of sum 1) and the disc area pi.
    disc = nodes(degree + 2)
    weight = engine.moment_values(moments, degree, disc.y, disc.t) * (math.pi * disc.weight)
    weight.flags.writeable = False
    modulus, steps = np.abs(weight), _steps(degree + 2)
    return MomentRule(
        weight,
        float(modulus.sum()),
        float((modulus @ (2.0 * steps) + 1.5 * steps * modulus.sum(1)).sum()),
        edge_error,
    )


def _steps(rows: int) -> Array:
    """Return how often each node, and its mirror image, is rounded in a sum of the core in single precision."""
    half = rows // 2
    at = np.arange(half)
    left = half - at
    if half >= 2 * _SUM_BLOCK:
        block = at // _SUM_BLOCK
        left = (
            np.minimum(_SUM_BLOCK, half - _SUM_BLOCK * block) - at % _SUM_BLOCK - block + math.ceil(half / _SUM_BLOCK)
        )
    return np.concatenate([left, left[::-1]]).astype(np.float64)


@lru_cache(maxsize=8)
def _moments(opening: Opening, degree: int, rule_degree: int, power: int) -> tuple[Complexes, float]:
    """Return L(phi) of the basis up to a `degree`, [k, m], and the error of U due to rounding of the edges."""
    rules = opening.rows(rule_degree, 10.0**power)
    x, y, weight = np.concatenate([rule.nodes for rule in rules], axis=1)
    phases, regions = (
        np.array(opening.phases),
        np.repeat(np.arange(len(rules)), [rule.nodes.shape[1] for rule in rules]),
    )
    # Whole turns are removed exactly, since cosines of large angles lose digits.
    phases[:, 0] = [math.remainder(piston, 2.0 * math.pi) for piston in phases[:, 0]]
    piston, tip, tilt = phases.T[:, regions]
    phased = weight * np.exp(1j * (piston + tip * x + tilt * y))
    t = np.clip(x / np.sqrt((1.0 - y) * (1.0 + y)), -1.0, 1.0)
    starts = np.flatnonzero(np.diff(y, prepend=np.nan) != 0.0)  # of rows, also where regions share one
    moments = engine.moments(degree, y[starts], np.diff(starts, append=y.size), t, phased)
    return moments, sum(rule.lost for rule in rules)


def _moment_images(
    rule: MomentRule, pupil: Pupil, grid: Grid, wanted: Wanted, *, single_precision: bool
) -> tuple[Array, Array]:
    """Return I (n, h, w) and its derivatives (k, n, h, w) by a moment rule."""
    # The nodes lie on lines of constant y here, but of constant x in the core: x and y are exchanged.
    window, (terms, signs) = window_of(pupil, grid), exchange_axes(wanted.terms)
    values, slopes = aperture_images(
        transposed(disk_stack(pupil)),
        window._replace(shape=window.shape[::-1], center=window.center[::-1]),
        quadrant_weights(rule, pupil),
        Wanted(
            dtype=np.float32 if single_precision else np.float64,
            threads=wanted.threads,
            terms=tuple((int(n), int(m)) for n, m in terms),
        ),
    )
    signed = np.multiply(slopes.swapaxes(2, 3), signs[:, None, None, None], order="C")
    return values.swapaxes(1, 2).astype(np.float64, order="C"), signed


def roundings(rule: MomentRule, pupil: Pupil, reach: float, *, single_precision: bool = False) -> float:
    """Bound the rounding error of U for v up to `reach`, with sums in `single_precision`."""
    # Rounding of phases, waves, sums along both axes, and weights: certificate, section 18, "Phases", "Moments".
    edge = pupil.wavefront.flattened().edge
    per_term = np.array([4.0 * n * n + 14.0 + len(edge[0]) for n, _ in pupil.wavefront.terms])
    units = float((np.abs(edge) @ per_term).max()) + 6.0 * reach + 20.0 * rule.rows + pupil.illumination.slope + 40.0
    # Sums over mirrored chords and nodes, and phases in multiples of 2^-32 turns: section 8, "In single precision".
    extra = 2.0**-24 * 36.0 + 7.4e-10 * (len(edge[0]) + 6) if single_precision else 0.0
    sums = 2.0**-24 * rule.steps if single_precision else 0.0
    return (_UNIT * units + extra) * rule.total + sums + rule.edge_error


_SUM_BLOCK = 16  # number of terms that the core adds up at a time in single precision
_SAMPLE_COST = 0.014  # microseconds to filter a sample
_SINGLE_SHARE = 6.0  # sums in single precision are tried up to this error over the requested one
_SINGLE_IMAGE_SHARE = 0.1  # and up to this error over the tolerance, above which few pupils meet it
_MIN_NODE_ERROR = 1e-12  # error of the field below which rounding errors dominate


# Pixel averages use the moment rule, which has the same nodes as the chordal rule of circular apertures. The core
# therefore sums several pupils in parallel vector lanes, as for circular apertures.


def averaged_apertures(pupil: Pupil, grid: Grid, tol: float, wanted: Wanted) -> Samples | None:
    """Return pixel averages with bounds below `tol`; None if not applicable, or slower than filtered samples."""
    highest = max((n for n, _ in wanted.terms), default=0)
    if pupil.mask is not None or wanted.powers:
        return None
    stack, window = disk_stack(pupil), window_of(pupil, grid)
    growth = _growth_of(stack, wanted.threads)

    def rule(
        down: float, across: float, field_tol: float, float32: bool, rows: int, columns: int
    ) -> tuple[Array, float, bool] | None:
        allowed = 0.15 * field_tol
        if allowed < _MIN_NODE_ERROR:
            return None
        degree, rule_degree, approximation_error = degrees_and_error(
            pupil, (down, across), allowed, (rows, columns), growth
        )
        degree, rule_degree = degree + highest, rule_degree + highest
        if degree > _MAX_DEGREE:
            return None
        times = _Times.of(pupil, len(wanted.terms), degree, rule_degree, allowed)
        if not _nodes_are_faster(times, window, rows, columns):
            return None
        moments = moment_rule(pupil.opening, degree, rule_degree, allowed)
        reach = math.hypot(down, across)
        rounding = roundings(moments, pupil, reach, single_precision=True)
        float32 = float32 and rounding < min(_SINGLE_SHARE * field_tol, _SINGLE_IMAGE_SHARE * tol)
        error = approximation_error + 1.1 * allowed + (rounding if float32 else roundings(moments, pupil, reach))
        return quadrant_weights(moments, pupil), error, float32

    # The nodes lie on lines of constant y here, but of constant x in the core: x and y are exchanged.
    core_terms, signs = exchange_axes(wanted.terms)
    images = aperture_averages(
        transposed(stack),
        window._replace(shape=window.shape[::-1], center=window.center[::-1]),
        pupil.likely_strehl * pupil.opening.likely_strehl,
        pupil.transmission,
        tol,
        wanted._replace(out=None, terms=tuple((int(n), int(m)) for n, m in core_terms)),
        rule,
    )
    return None if images is None else _transposed_back(images, signs, wanted.out)


def _transposed_back(images: Samples, signs: Array, out: Pixels | None) -> Samples:
    """Return images with x and y exchanged, and derivatives multiplied by `signs`."""
    values = np.empty_like(images.values.swapaxes(1, 2), order="C") if out is None else out
    values[...] = images.values.swapaxes(1, 2)
    slopes = images.slopes
    if slopes is not None:
        transposed_slopes = slopes.values.swapaxes(2, 3) * signs[:, None, None, None].astype(slopes.values.dtype)
        slopes = Slopes(np.ascontiguousarray(transposed_slopes), slopes.error)
    return images._replace(values=values, slopes=slopes)


def _nodes_are_faster(times: _Times, window: Window, rows: int, columns: int) -> bool:
    """Return whether sums over nodes take less time than filtering samples, with a rule shared by several stacks."""
    height, width = (window.step / 1.2 * n + 20.0 for n in window.shape)
    by_rule = times.rule + _STEPS * times.sums(height, width)
    filtered = min(by_rule, _STEPS * times.transforms(height, width))
    filters = 450.0 + _SAMPLE_COST * times.images * height * width
    return times.rule + _STEPS * times.averages(*window.shape, rows, columns) < filtered + _STEPS * filters


def exchange_axes(terms: Sequence[tuple[int, int]] | NDArray[np.int32]) -> tuple[NDArray[np.int32], Array]:
    """Return Zernike terms with x and y exchanged, and their signs; odd orders exchange cosine and sine."""
    n, m = np.reshape(np.asarray(terms, dtype=np.int32), (-1, 2)).T
    is_odd, order = m % 2 != 0, np.abs(m)
    # cos(m (pi / 2 - theta)) and sin(m (pi / 2 - theta)) depend on m modulo 4.
    sign = np.where(order // 2 % 2 == 0, 1.0, -1.0)
    terms_out = np.stack([n, np.where(is_odd, -m, m)], axis=1)
    return np.ascontiguousarray(terms_out, dtype=np.int32), np.where(is_odd, sign, np.where(m < 0, -sign, sign))


def transposed(stack: DiskStack) -> DiskStack:
    """Return the stack with x and y exchanged."""
    terms, signs = exchange_axes(stack.terms)
    return stack._replace(terms=terms, edge=stack.edge * signs)


def quadrant_weights(rule: MomentRule, pupil: Pupil) -> Array:
    """Return the weights times the pupil amplitude in the layout of the core, (chords, nodes, 8).

    The last axis has the four mirror images of a node of the top right quadrant, each as real and imaginary part.
    """
    weight, q = rule.weight, rule.rows // 2
    if not pupil.illumination.uniform:
        disc = nodes(rule.rows)
        weight = weight * pupil.illumination.at(disc.x**2 + disc.y[:, None] ** 2)
    # y decreases with the row index, x increases with the node index.
    top, bottom = weight[:q], weight[: q - 1 : -1]
    parts = [part for rows in (top, bottom) for part in (rows[:, : q - 1 : -1], rows[:, :q])]
    return np.stack([part for weights in parts for part in (weights.real, weights.imag)], axis=2)


_MIN_ERROR = 4e-15  # smallest allowed error of U, relative to the largest possible value of U
_SUM_SHARE = 0.25  # fraction of the error of U allotted to the sums
_MAX_HALF_SHARE = 0.75  # mirroring saves time if the half image has at most this fraction of the pixels


@dataclass(frozen=True)
class NonuniformFFT(Method[Pupil]):
    r"""Gauss quadrature along the rows of the clear aperture, transformed onto the pixels by two non-uniform FFTs.

    Supports all pupils of a lens: any wavefront, spiders, vignetting, stops of any shape, segments, masks and
    apodization.

    Parameters
    ----------
    tol : float, default 1e-6
        Bound on ``max|I - I_exact| / max I``, 1e-12 to below 0.1; max I is the largest value in the window or on a
        coarse lattice over the whole blur. :class:`~lommel.ToleranceError` is raised if the bound cannot be met. The
        exact image of a mask is the sum over its samples.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    Lines of constant y cut the aperture into intervals. Gauss-Legendre rules are used along the intervals and,
    in y, between the intersections of edges. Their error is bounded for all polynomials of a given degree with a
    modulus of at most 1 on the unit disc, and the integrand is proven to be close to such a polynomial
    (:func:`lommel.optics.aperture.opening.degree_needed`). One non-uniform FFT spreads the nodes of each row to a
    fine grid with a kernel and transforms them to the columns; a second one transforms the rows in the same way.
    Aliasing and rounding errors are included in the bound: docs/certificate.md, section 18. Pixel-integrated values
    are filtered samples. Stacks and derivatives on small windows are matrix products with a quadrature rule of the
    disc that has the same moments as the aperture.

    References
    ----------
    Lloyd N. Trefethen, Approximation Theory and Approximation Practice (2013), Theorem 19.3: error bound of the Gauss
    rule. Magnus Lundin, "The extremal PSH for the complement of convex, symmetric subsets of R^N", Michigan Math. J.
    32, 197 (1985), doi:10.1307/mmj/1029003186: growth of polynomials outside the disc.
    Alok Dutt and V. Rokhlin, "Fast Fourier transforms for nonequispaced data", SIAM J. Sci. Comput. 14, 1368 (1993),
    doi:10.1137/0914081.
    """

    apodized = nonradial = any_aperture = True
    tol: float = 1e-6

    def intensity(self, pupil: Pupil, grid: Grid, threads: int) -> Intensities:
        """Return I at pixel centres, or averaged over pixels, shape ``(n, height, width)``, with its error bound."""
        return self.images(pupil, grid, Wanted(threads=threads)).intensities

    def images(self, pupil: Pupil, grid: Grid, wanted: Wanted) -> Samples:
        """Return the images of the flattened stack; see :meth:`lommel.methods.Method.images`."""
        if wanted.powers:
            raise ValueError("derivatives by powers of rho are not available from NonuniformFFT; use Zernike terms")
        if wanted.terms and wanted.scale is None:
            raise ValueError(
                'derivatives of values divided by their largest one are not available; avoid normalize="peak"'
            )
        grid.require_one_axis()
        if grid.integrate:
            averages = averaged_apertures(pupil, grid, self.tol, wanted)
            if averages is not None:
                return averages
        # Errors of averages are relative to the peak of the PSF, even if the window does not contain the peak.
        sample = partial(_sample_images, everywhere=True) if grid.integrate else _sample_images
        return averaged_images(sample, pupil, grid, self.tol, wanted)


def _sample_images(pupil: Pupil, grid: Grid, tol: float, wanted: Wanted, *, everywhere: bool = False) -> Samples:
    """Return samples of the flattened stack, with bounds below `tol` of the peak, including rounding of storage.

    With `everywhere`, the peak is the peak of the whole PSF, otherwise the largest value in the window.
    """
    if pupil.mask is not None and not pupil.mask.squares:
        min_side, reason = samples_needed(pupil, grid)
        if min_side > pupil.mask.side:
            raise Declined(
                f"the mask of side {pupil.mask.side} is too coarse: {reason} need a side of at least {min_side:.5g}"
            )
    budget = tol - (1.0 + tol) * storing(wanted.dtype)
    if wanted.scale is None:
        budget *= 0.49  # division by the computed peak doubles the error (section 6)
    # Estimate of max |U|, mostly an underestimate.
    peak_field = 0.5 * pupil.amplitude * math.sqrt(pupil.likely_strehl * pupil.opening.likely_strehl)
    outer_peak: Array | None = np.zeros(math.prod(pupil.shape)) if wanted.scale is None else None
    # The first requested error of U assumes the estimated peak. It is reduced if the error bound, relative to the
    # computed peak, exceeds `tol` (section 6).
    for _ in range(8):
        field_error = max(0.45 * budget * peak_field / pupil.amplitude, _MIN_ERROR)
        values, slopes, field_bounds, slope_bounds = _sums(pupil, grid, field_error, wanted)
        peak = values.max(axis=(1, 2))
        intensities, error = _with_bounds(
            values, peak if outer_peak is None else np.maximum(peak, outer_peak), field_bounds, wanted
        )
        if outer_peak is None and (error > tol or (everywhere and float(peak.min()) < peak_field**2)):
            outer_peak = _peak_bound(pupil, max(field_error, 1e-4 * peak_field / pupil.amplitude), wanted.threads)
            intensities, error = _with_bounds(values, np.maximum(peak, outer_peak), field_bounds, wanted)
        if error <= tol or field_error <= _MIN_ERROR:
            break
        assert intensities.peak is not None
        peak_field = min(0.9 * math.sqrt(max(float(intensities.peak.min()), 1e-300)), 0.5 * peak_field)
    if not error <= tol:
        raise not_met(tol, error, "the peak")
    images = to_images(intensities, grid, wanted)
    if not wanted.terms:
        return images
    peak = np.asarray(intensities.peak)
    # Error of I' = 2 Re(conj(U) U'), where |U'| is at most the amplitude.
    derivative_error = 2.0 * (np.sqrt(peak) * slope_bounds + (pupil.amplitude + slope_bounds) * field_bounds) / peak
    scaled = (slopes * images.scale[:, None, None]).astype(wanted.dtype)
    error = derivative_error + (np.abs(slopes).max(axis=(2, 3)) / peak + derivative_error) * storing(wanted.dtype)
    return images._replace(slopes=Slopes(scaled, error))


def _with_bounds(values: Array, peak: Array, field_bounds: Array, wanted: Wanted) -> tuple[Intensities, float]:
    """Return intensities with bounds relative to `peak`, and the largest bound after storing."""
    intensities = Intensities(values, relative_error(peak[:, None], field_bounds), peak)
    return intensities, float(np.max(with_storage_rounding(intensities, wanted)))  # type: ignore[arg-type]


def _peak_bound(pupil: Pupil, error: float, threads: int) -> Array:
    """Return a lower bound on the peak of each PSF, from a coarse lattice over the whole blur."""
    blur = float(pupil.v(pupil.geometric_radius()).max())
    lattice = Grid(64, max(0.5, blur / (30.0 * math.pi)) * pupil.scale)
    values, _, field_bounds, _ = _sums(pupil, lattice, error, Wanted(threads=threads))
    return np.asarray(np.maximum(np.sqrt(values.max(axis=(1, 2))) - field_bounds, 0.0) ** 2)


def _has_real_function(pupil: Pupil) -> bool:
    """Return whether the pupil function is real; images are then symmetric under rotation by 180 degrees."""
    return pupil.wavefront.flat and not pupil.phase_mask and not pupil.opening.phases.any()


def _half_grid(grid: Grid) -> Grid | None:
    """Return the pixels on one side of the axis; None if mirroring them does not save time."""
    if not grid.mirrored:
        return None
    reach_y, reach_x = (max(c, side - 1 - c) for c, side in zip(grid.axis, grid.shape, strict=True))
    offset = grid.axis[1] % 1.0
    shape = int(2.0 * reach_y) + 1, int(reach_x - offset) + 1
    if math.prod(shape) > _MAX_HALF_SHARE * math.prod(grid.shape):
        return None
    return Grid(shape, grid.pixel, center=(reach_y, -offset))


def _mirror_half(values: Array, half: Grid, grid: Grid) -> Array:
    """Return images on the pixels of `grid` from images on its :func:`_half_grid`."""
    (row, column), (reach_y, _) = grid.axis, half.axis
    columns, top, last = math.ceil(column), int(reach_y - row), int(reach_y + row) + 1
    images = np.empty((len(values), *grid.shape))
    images[:, :, columns:] = values[:, top : top + grid.height, : grid.width - columns]
    skipped = int(columns == column)  # the column on the axis has no mirror image
    rotated = values[:, last - grid.height : last, skipped : skipped + columns]
    images[:, :, :columns] = rotated[:, ::-1, ::-1]
    return images


def _sums(pupil: Pupil, grid: Grid, error: float, wanted: Wanted) -> tuple[Array, Array, Array, Array]:
    """Return I, its derivatives, and bounds on the errors of U and of its derivatives by any term.

    `error` is the requested error of U divided by the amplitude; the bounds are about `error` times the amplitude.
    """
    half = None if wanted.terms or not _has_real_function(pupil) else _half_grid(grid)
    if half is not None:
        values, slopes, field_bounds, slope_bounds = _sums(pupil, half, error, wanted)
        return _mirror_half(values, half, grid), slopes, field_bounds, slope_bounds
    step, amplitude = grid.step(pupil), pupil.amplitude
    sides = tuple(step / grid.side * float(np.abs(part).max()) for part in (grid.x, grid.y))
    reach = math.hypot(*sides)
    highest = max((n for n, _ in wanted.terms), default=0)
    phases = pupil.opening.phases.copy()
    if pupil.mask is None:
        # Pistons are reduced to [-pi, pi), since sines of large phases lose digits.
        phases[:, 0] = np.remainder(phases[:, 0] + math.pi, 2.0 * math.pi) - math.pi
        terms = [(n, w) for (n, _), w in pupil.wavefront.each_amplitude().items()]
        steepest = float(np.hypot(phases[:, 1], phases[:, 2]).max())
        allowed = _MOMENT_SHARE * error * amplitude
        degree, rule_degree, approximation_error = degrees_and_error(
            pupil, (sides[0], sides[1]), allowed, grid.shape[::-1], _growth_of(disk_stack(pupil), wanted.threads)
        )
        degree, rule_degree = degree + highest, rule_degree + highest
        if moment_rule_is_faster(pupil, grid, wanted.terms, degree, rule_degree, allowed):
            rule = moment_rule(pupil.opening, degree, rule_degree, allowed)
            rounding = roundings(rule, pupil, reach, single_precision=True)
            single = wanted.dtype == np.float32 and rounding < _MOMENT_SINGLE_SHARE * error * amplitude
            values, slopes = _moment_images(rule, pupil, grid, wanted, single_precision=single)
            field_bound = (
                approximation_error + 1.1 * allowed + (rounding if single else roundings(rule, pupil, reach))
            )
            # The factor, its products, and the two products of I': certificate, section 8, "Derivatives".
            slope_bound = field_bound + 6.0 * _UNIT * (1 + highest**2) + (7.0 * 2.0**-24 if single else 0.0)
            return values, slopes, *np.tile(np.array([[field_bound], [slope_bound]]), len(values))
        allowed = 0.3 * error * amplitude
        approximation_error = polynomial_error(pupil, allowed)
        degree = degree_needed(terms, reach + steepest, pupil.illumination, allowed) + highest
        rules = pupil.opening.rows(degree, allowed)
    else:
        phases, rules, approximation_error = np.zeros((1, 3)), pupil.samples, phase_roundings(pupil)
    window = window_of(pupil, grid)
    values, slopes, sum_error = row_images(rules, phases, disk_stack(pupil), window, 0.5 * _SUM_SHARE * error, wanted)
    if pupil.mask is not None and pupil.mask.squares:
        # Square cells multiply the field by a sinc along each axis, and I by squared sincs (section 18, "The light of
        # a mask").
        sinc_y, sinc_x = (np.sinc(step / grid.side / (math.pi * pupil.mask.side) * r) ** 2 for r in (grid.y, grid.x))
        cells = sinc_y[:, None] * sinc_x
        values, slopes = values * cells, slopes * cells
    field_bounds = approximation_error + sum_error
    return values, slopes, field_bounds, field_bounds
