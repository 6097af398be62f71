"""Functions of the compiled core, with named results and Python exceptions; no other module imports the core.

The core encodes "divide by the largest value" as the scale 0, and a missed tolerance as a nonzero or negative bound.
In this file these are a scale of None and a ToleranceError.

Terms of this file: n is the number of pupils of a flattened stack; v = pi r / (lambda N) is the optical coordinate; U
is the field and I = abs(U)^2 the intensity. The chordal rule integrates over the pupil along chords (lines of
constant x), each with quadrature points ("nodes"). By symmetry only nodes of one quadrant (x > 0, y > 0) are stored.
Distances in v are distances on the sensor. "Certificate" is the document with the proofs of the bounds.
"""

# No `from __future__ import annotations`: compiling annotations that are text slows down the import of NamedTuples.

import sys
from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel import _core
from lommel.base.arrays import Array
from lommel.core.answers import FieldValues, Intensities, Pixels, Samples, Slopes, Wanted, not_met

# Functions and classes of the core that need no conversion of arguments or results.
MoleculeFitter = _core.MoleculeFitter
MoleculeTable = _core.MoleculeTable
average_samples = _core.average_samples
band_points = _core.band_points
bessel_sequence = _core.bessel_sequence
clear_tables = _core.clear_caches
closed_form_fields = _core.closed_form_fields
collect = _core.collect
composite = _core.composite
depth_layers = _core.depth_layers
distinct_radii = _core.distinct_radii
fft_length = _core.fft_length
field_spread = _core.field_spread
filter_planes = _core.filter_planes
gauss_error = _core.gauss_error
gauss_legendre = _core.gauss_legendre
gradient_sum = _core.gradient_sum
huygens_sum = _core.huygens_sum
least_average = _core.least_average
least_squares = _core.least_squares
polynomial_fields = _core.polynomial_fields
product = _core.product
scatter = _core.scatter
shrink_bands = _core.shrink_bands
shrink_gradient = _core.shrink_gradient
spread = _core.spread
transfer_rule = _core.transfer_rule


class FocalScale(_core.FocalScale):
    """Frames enlarged about their middle; pickled as its arguments."""

    def __init__(self, *given: Any) -> None:
        super().__init__(*given)
        self._given = given

    def __reduce__(self) -> tuple[Any, ...]:
        return FocalScale, self._given


class FocalStream(_core.FocalStream):
    """Depth and sharp images of frames that differ in focus; pickled as its arguments, without the frames."""

    def __init__(self, *given: Any) -> None:
        super().__init__(*given)
        self._given = given

    def __reduce__(self) -> tuple[Any, ...]:
        return FocalStream, self._given


class RadialStack(NamedTuple):
    """Radially symmetric pupils."""

    terms: Array  # (n, k), coefficients of R_2^0, R_4^0, ..., radians at the edge
    obscuration: float  # radius of the obscuration / radius of the aperture
    amplitude: Array  # g_0, g_1, ... of exp(-(g_0 + g_1 rho^2 + ...))


UNCUT = np.empty((0, 9))
"""Strips of an aperture that has none."""


class DiskStack(NamedTuple):
    """Pupils with arbitrary wavefronts; obscuration and amplitude are those of :class:`RadialStack`."""

    terms: NDArray[np.int32]  # (k, 2), n and m of each Zernike term, m < 0 for sines
    edge: Array  # (n, k), coefficients of the terms, radians at the edge
    obscuration: float
    amplitude: Array
    strips: Array = UNCUT  # of lommel.optics.aperture.opening.Opening.strips


class Window(NamedTuple):
    """Grid of pixels."""

    shape: tuple[int, int]  # height and width
    center: tuple[float, float] | Array  # row and column of the axis; as an array (n, 2), or (1, 2) for all pupils
    step: float  # pixel pitch in v


_NO_DERIVATIVES: dict[str, object] = {}


def _common_scale(wanted: Wanted) -> float:
    """Return the common factor of all images; 0 if each image is divided by its largest value."""
    assert not isinstance(wanted.scale, np.ndarray), "images of one aperture have one scale"
    return wanted.scale or 0.0


def _outputs(count: int, window: Window, wanted: Wanted) -> tuple[float, Pixels, Array]:
    """Return the scale, and arrays for results: images, and (factor of I, error bound, peak) of each image."""
    values = np.empty((count, *window.shape), wanted.dtype) if wanted.out is None else wanted.out
    return _common_scale(wanted), values, np.empty((3, count))


def _require(bound: float, tol: float, relative_to: str, other: str = "") -> None:
    """Raise ToleranceError if `bound`, an error bound that exceeds `tol`, is not 0."""
    if bound:
        raise not_met(tol, bound, relative_to, other=other)


def radial_images(
    stack: RadialStack, window: Window, tol: float, wanted: Wanted, *, integrate: bool = False
) -> Samples:
    """Return images of radially symmetric pupils: point samples, or averages over pixels with `integrate`."""
    scale, values, numbers = _outputs(len(stack.terms), window, wanted)
    slopes, arguments = None, _NO_DERIVATIVES
    if n := len(wanted.powers):
        slopes = Slopes(np.empty((n, *values.shape), values.dtype), np.empty((n, len(values))))
        arguments = {"powers": np.array(wanted.powers, dtype=np.int64)}
        arguments |= {"derivative_images": slopes.values, "derivative_bounds": slopes.error}
    render: Callable[..., float] = _core.render
    # Positional arguments: with keywords, a small image would take a sixth longer.
    bound = render(stack, window, integrate, (tol, wanted.threads, scale), values, numbers, **arguments)
    _require(bound, tol, _error_reference(wanted))
    return Samples(values, numbers[0], numbers[1], slopes, numbers[2])


def filters_pay(stack: RadialStack, window: Window, tol: float, *, derivatives: bool = False) -> bool:
    """Return True if pixel averages (with `derivatives`, their derivatives) are faster by filtering finer samples."""
    return _core.filters_pay(stack, window, tol, derivatives)


def radial_plan(
    stack: RadialStack, shape: tuple[int, ...], window: Window, tol: float, wanted: Wanted, *, integrate: bool
) -> Callable[[Array, Pixels], tuple[Array, float] | None]:
    """Return a fast function f(terms, values) for :func:`radial_images` of stacks that differ in their terms only.

    f writes the images to `values` and returns their scales and largest error bound. f returns None and writes
    nothing if the arrays have the wrong shape or type, or if :func:`filters_pay` returns True.
    """
    scale, kind = _common_scale(wanted), np.dtype(wanted.dtype).char
    request = tol, wanted.threads, scale
    plan = _core.RadialPlan(stack.obscuration, stack.amplitude, window, integrate, request, kind)
    relative_to, common_scales = _error_reference(wanted), np.full(shape, scale)
    common_scales.flags.writeable = False  # shared by all results
    render = plan.render

    def compute(terms: Array, values: Pixels) -> tuple[Array, float] | None:
        scales = None if scale else np.empty(shape)
        bound = render(terms, values, scales)
        if bound is None:
            return None
        if bound < 0.0:
            raise not_met(tol, -bound, relative_to)
        return common_scales if scales is None else scales, bound

    return compute


def _error_reference(wanted: Wanted) -> str:
    """Return in words the value by which errors of images are divided."""
    return 'the largest value in the window (normalize="peak")' if wanted.scale is None else "the peak"


def series_images(stack: DiskStack, window: Window, tol: float, wanted: Wanted) -> Samples:
    """Return point samples of images of arbitrary wavefronts, by interpolation between circles."""
    other = f"ChordalGauss({tol:g})"
    return _disk_images(_core.series_images, "the peak", stack, window, tol, wanted, other)


class FarPixels(NamedTuple):
    """Averages over the pixels that are far from the axis of each image, and 0 for all other pixels."""

    values: Array  # (n, height, width)
    nearest: Array  # (n,), smallest distance of a computed pixel from the axis, in pixels
    error: Array  # (n,), bounds on the error of I
    axes: Array  # (n, 2), row and column of the axis


def far_averages(stack: DiskStack, window: Window, limit: float, tol: float, threads: int) -> FarPixels:
    """Return averages over pixels so far from the axis that their errors are likely below tol * (largest average).

    If the nearest such pixel is farther than `limit` (in v), no pixel is computed; `nearest` exceeds all distances.
    """
    count = len(stack.edge)
    values, numbers = np.empty((count, *window.shape)), np.empty((count, 5))
    _core.far_averages(stack, window, limit, tol, threads, values, numbers)
    return FarPixels(values, numbers[:, 0], numbers[:, 1], numbers[:, 3:])


def chordal_images(
    stack: DiskStack,
    window: Window,
    tol: float,
    wanted: Wanted,
    *,
    if_cheaper: bool = False,
) -> Samples:
    """Return point samples by the chordal rule, with errors relative to the largest value in the window.

    Errors of derivatives with respect to `wanted.terms` have bounds relative to this value, which may exceed `tol`.
    With `if_cheaper`, Declined is raised if :func:`series_images` is likely to be faster.
    """
    relative_to = "the largest value in the window"
    if not wanted.terms:
        compute = _core.cheaper_chordal_images if if_cheaper else _core.chordal_images
        return _disk_images(compute, relative_to, stack, window, tol, wanted)
    terms, count = np.array(wanted.terms, dtype=np.int32), len(stack.edge)
    slopes = Slopes(np.empty((len(terms), count, *window.shape), wanted.dtype), np.empty((len(terms), count)))
    derivatives = {"factors": terms, "slopes": slopes.values, "bounds": slopes.error}
    images = _disk_images(_core.chordal_derivatives, relative_to, stack, window, tol, wanted, "", **derivatives)
    return images._replace(slopes=slopes)


def _averages_outputs(count: int, window: Window, wanted: Wanted) -> tuple[Samples, tuple[Any, ...]]:
    """Return empty images with their derivatives, and the same arrays as arguments of the core."""
    scale, values, numbers = _outputs(count, window, wanted)
    terms = np.array(wanted.terms, dtype=np.int32).reshape(-1, 2)
    slopes = Slopes(np.empty((len(terms), *values.shape), wanted.dtype), np.empty((len(terms), count)))
    images = Samples(values, numbers[0], numbers[1], slopes if len(terms) else None, numbers[2])
    return images, (scale, values, numbers, terms, slopes.values, slopes.error)


def disk_averages(
    stack: DiskStack, window: Window, tol: float, wanted: Wanted, *, if_cheaper: bool
) -> Samples | None:
    """Return averages over pixels, with errors relative to the largest average at any position of a pixel.

    None if another method suits better. With `if_cheaper`, Declined is raised if :func:`series_images` is likely to
    be faster.
    """
    images, (scale, *outputs) = _averages_outputs(len(stack.edge), window, wanted)
    compute: Callable[..., bool] = _core.disk_averages
    return images if compute(stack, window, (tol, wanted.threads, scale), if_cheaper, *outputs) else None


ApertureRule = Callable[[float, float, float, bool, int, int], tuple[Array, float, bool] | None]
"""Function that computes the weights of a quadrature rule for an aperture.

Arguments: largest distances from the axis in v along y and along x, allowed error of U up to these distances, True
for sums in single precision, numbers of nodes along y and along x. Results: weights of a quadrant, error of U with
these weights, and True if this error includes the error of sums in single precision. None instead if no rule meets
the allowed error.
"""


def aperture_averages(
    stack: DiskStack,
    window: Window,
    strehl: float,
    transmission: float,
    tol: float,
    wanted: Wanted,
    rule: ApertureRule,
) -> Samples | None:
    """Return averages over pixels for an arbitrary aperture, whose amplitude is part of the weights of `rule`.

    The weights have the shape (chords, nodes, 8): real and imaginary part at (x, y), (x, -y), (-x, y) and (-x, -y).
    None if the core finds no suitable nodes for the window, or if `rule` returns None.
    """
    images, (scale, *outputs) = _averages_outputs(len(stack.edge), window, wanted)
    compute: Callable[..., bool] = _core.aperture_averages
    arguments = (stack.terms, stack.edge, window, (tol, wanted.threads, scale), strehl, transmission, rule)
    return images if compute(*arguments, *outputs) else None


def growth_curves() -> Array:
    """Return the heights b of the complex curves of :func:`stack_growth`."""
    return _core.growth_curves()


def stack_growth(stack: DiskStack, curve: int, reach: tuple[float, float], threads: int) -> float:
    """Return a bound on log(mean of ``|exp(i Phi - i v.rho)|``) of all pupils, for v up to `reach` along x and y.

    The mean is over the points of the chords of one direction at the height ``growth_curves()[curve]``; the bound
    holds for all directions.
    """
    return _core.stack_growth(stack.terms, stack.edge, curve, reach, threads)


def aperture_images(stack: DiskStack, window: Window, weights: Array, wanted: Wanted) -> tuple[Pixels, Pixels]:
    """Return I (n, h, w) and its derivatives (k, n, h, w) by such weights, computed and stored in `wanted.dtype`."""
    count, factors = len(stack.edge), np.array(wanted.terms, dtype=np.int32).reshape(-1, 2)
    values, slopes = (np.empty((*s, count, *window.shape), wanted.dtype) for s in ((), (len(factors),)))
    _core.aperture_images(stack.terms, stack.edge, window, weights, wanted.threads, values, factors, slopes)
    return values, slopes


def disk_costs(stack: DiskStack, window: Window, tol: float) -> tuple[float, float]:
    """Return the estimated times in nanoseconds of :func:`chordal_images` and of :func:`series_images`.

    ValueError if the chordal rule cannot compute the images.
    """
    return _core.disk_costs(stack, window, tol, tol >= 1e-6)


def chordal_plan(
    obscuration: float,
    amplitude: Array,
    strips: Array,
    window: Window,
    tol: float,
    wanted: Wanted,
    *,
    if_cheaper: bool,
) -> Callable[[NDArray[np.int32], Array, Pixels], tuple[Array, float]]:
    """Return a fast function f(terms, edge, values) for :func:`chordal_images` of stacks of one aperture.

    f writes the images to `values`, of shape (..., height, width), and returns their scales and largest error bound.
    """
    request = tol, wanted.threads, _common_scale(wanted)
    compute = _core.cheaper_chordal_images if if_cheaper else _core.chordal_images

    def compute_images(terms: NDArray[np.int32], edge: Array, values: Pixels) -> tuple[Array, float]:
        stack, count = values.shape[:-2], edge.size // len(terms)
        numbers = np.empty((3, count))
        edges, images = edge.reshape(count, -1), values.reshape(count, *window.shape)
        if bound := compute((terms, edges, obscuration, amplitude, strips), window, request, images, numbers):
            raise not_met(tol, bound, "the largest value in the window")
        return numbers[0].reshape(stack), max(numbers[1].tolist())

    return compute_images


def chordal_gradient(
    stack: DiskStack, window: Window, tol: float, weights: Array, terms: tuple[tuple[int, int], ...], threads: int
) -> Array:
    """Return derivatives of sum(weights * I) with respect to the coefficients of k Zernike `terms`, shape (n, k)."""
    gradient, by_terms = np.empty((len(stack.edge), len(terms))), np.array(terms, dtype=np.int32)
    _require(
        _core.chordal_gradient(stack, window, tol, threads, weights, by_terms, gradient),
        tol,
        "the largest value in the window",
    )
    return gradient


def chordal_sums(stack: DiskStack, window: Window, counts: tuple[int, int], threads: int = 0) -> NDArray[np.float32]:
    """Return I, shape (n, width, height), in single precision, without a bound, for `counts` (chords, nodes)."""
    intensities = np.empty((len(stack.edge), *window.shape[::-1]), dtype=np.float32)
    _core.chordal_sums(stack, window, counts, threads, intensities)
    return intensities


def chordal_sums_gradient(
    stack: DiskStack, window: Window, counts: tuple[int, int], weights: Array, threads: int = 0
) -> Array:
    """Return derivatives of sum(weights * I) with respect to all coefficients, for I of :func:`chordal_sums`.

    `weights` have the shape ``(n, height, width)``.
    """
    gradient = np.empty(stack.edge.shape)
    _core.chordal_sums_gradient(stack, window, counts, threads, weights, gradient)
    return gradient


class NodeTables(NamedTuple):
    """Components of the electric field in the pupil ("fields") at the nodes of a quadrant.

    A field is a sum of k contributions ("shares") ``factor * sum_n c_n R_n``. The radial functions R_n are divided
    into groups ("parts"); each sum runs over one part. A parity is 2 if a function is odd in x, plus 1 if it is odd
    in y. The last two axes of every table, "...", are chord and node.
    """

    radial: Array  # (terms, ...), radial functions of all parts
    ends: NDArray[np.int32]  # end index of the terms of each part
    shares: NDArray[np.int32]  # (k, 3): index of the field, parity of the factor, index of the part
    factors: NDArray[np.complex128]  # (k, ...)


class NodeWaves(NamedTuple):
    """Results of :func:`folded_waves`, and the index of the wave of each plane."""

    values: NDArray[np.complex128]  # (kinds, waves, 4, ...)
    wave_index: NDArray[np.int32]  # (planes,)


class NodeTerms(NamedTuple):
    """Zernike terms at the nodes, and the parity of each term."""

    values: Array  # (terms, ...)
    parities: NDArray[np.int32]


def folded_waves(terms: NodeTerms, edge: Array, weights: Array) -> NDArray[np.complex128]:
    """Return for each node and parity the weighted sum of exp(i W) over (+-x, +-y): (1, wavefronts, 4, ...).

    W is the sum of `terms` times the coefficients `edge` of shape (wavefronts, terms).
    """
    return _core.folded_waves(terms, edge, weights, 0.0)  # 0.0: no second kind, of waves times W


class SeriesSizes(NamedTuple):
    """Bounds on the parts (:class:`NodeTables`) of amplitudes, at real angles and on complex curves around them."""

    on_curves: Array  # (series, planes, parts, curves)
    moduli: Array  # (series, planes, parts)


def chordal_series_sizes(
    coefficients: NDArray[np.complex128], ends: NDArray[np.int32], powers: Array, rate: Array, offsets: Array
) -> tuple[SeriesSizes, float, float]:
    """Return bounds on amplitude series, and half the required number of chords and of nodes.

    `coefficients` have the shape (series, planes, terms); `powers` (terms, curves) bound the terms on the curves. The
    numbers (i = 0 for chords, 1 for nodes) are the minimum over the curves of
    ``offsets[i, curve] + rate[curve] * log(largest part on the curve)``.
    """
    on_curves, moduli, chords, nodes = _core.chordal_series_sizes(coefficients, ends, powers, rate, offsets)
    return SeriesSizes(on_curves, moduli), chords, nodes


def chordal_field_errors(
    sizes: SeriesSizes,
    series: NDArray[np.int32],
    curves: tuple[Array, Array],
    truncation: Array,
    rounding: Array,
    shares: Array,
    error: float,
) -> Array:
    """Return bounds on the errors of sums over chords and nodes, of shape (sets, planes, fields).

    A set of fields has a series (index `series`). The arrays `curves`, of shape (sets, curves), are factors of the
    parts on the curves, for chords and nodes. `truncation` bounds the truncation error of a series, `rounding` the
    rounding error / modulus. A field is a sum of parts times `shares` (fields, parts); `error` is added to each part.
    """
    return _core.chordal_field_errors(*sizes, series, *curves, truncation, rounding, shares, error)


def chordal_series_light(
    tables: NodeTables,
    coefficients: NDArray[np.complex128],
    waves: NodeWaves,
    window: Window,
    sets: NDArray[np.int32],
    terms: NodeTerms,
    field_errors: Array,
    power: Array,
    threads: int = 0,
) -> tuple[Array, Array, Array]:
    """Return the intensity of each plane and its derivatives, their error bounds, and their largest moduli.

    The intensity is the sum of abs(field)^2 divided by the `power` of the plane. Values have the shape (sets, planes,
    height, width), bounds and largest moduli (sets, planes). `coefficients` have the shape (series, planes, terms).
    Each row of `sets` defines the fields of one derivative (the first row: of the intensity) by three integers: the
    index of the series, the index in `terms` of a term that is multiplied by i (-1 for none), and the kind of the
    waves. `field_errors` (sets, planes, fields) are bounds on the errors of the fields.
    """
    return _core.chordal_series_light(
        tables, (coefficients, sets), terms, waves, window, field_errors, power, threads
    )


def chordal_series_gradient(
    tables: NodeTables,
    coefficients: NDArray[np.complex128],
    waves: NodeWaves,
    window: Window,
    sets: NDArray[np.int32],
    terms: NodeTerms,
    weights: Array,
    threads: int = 0,
) -> tuple[Array, Array]:
    """Return sum(weights * I) of each plane and its derivatives, with I of :func:`chordal_series_light`.

    `weights` have the shape (planes, height, width). The first array has for each plane the sum, its derivatives
    defined by all `sets` but the first (these sets must have no term), and its derivatives with respect to all
    `terms`. The second array has the largest I and the largest modulus of each field.
    """
    return _core.chordal_series_gradient(tables, (coefficients, sets), terms, waves, window, weights, threads)


def _disk_images(
    compute: Callable[..., float],
    relative_to: str,
    stack: DiskStack,
    window: Window,
    tol: float,
    wanted: Wanted,
    other: str = "",
    **derivatives: object,
) -> Samples:
    """Return images by a function of the core; ToleranceError if it cannot meet `tol`, as `other` methods may."""
    scale, values, numbers = _outputs(len(stack.edge), window, wanted)
    request = tol, wanted.threads, scale
    _require(compute(stack, window, request, values, numbers, **derivatives), tol, relative_to, other)
    return Samples(values, numbers[0], numbers[1], None, numbers[2])


def radial_fields(stack: RadialStack, v: Array, tol: float) -> FieldValues:
    """Return U at increasing v; the errors are usually so small that I is accurate to `tol` times the peak."""
    return FieldValues(*_core.field(stack, v, tol))


def radial_profiles(stack: RadialStack, v: Array, tol: float, threads: int = 1) -> Intensities:
    """Return I at increasing v, with errors of at most `tol` times the peak."""
    values, bounds, peaks = _core.profile(stack, v, tol, threads)
    _require(-min(float(bounds.min()), 0.0), tol, "the peak")
    return Intensities(values, bounds, peaks)


class Layered(NamedTuple):
    """Integrand of images through layers (microscopes): q quadrature nodes, m field components, n planes."""

    rho: Array  # (q,), pupil radii of the nodes
    parts: NDArray[np.complex128]  # (m, q), integrands of Bessel orders 0, 1, ..., times the weights of the rule
    rates: NDArray[np.complex128]  # (3, q), the phase, and its derivatives with respect to depth and focus
    error: float  # bound on the error of each field component
    planes: Array  # (3, n), depth, focus and power
    forms: NDArray[np.complex128]  # (k, m, m), Hermitian forms of the intensity, one for each azimuthal order
    azimuthal: Array  # (k, 3), azimuthal order (order 0 first), factor of its cosine, factor of its sine


class LayeredSlopes(NamedTuple):
    """Variables with respect to which images of :class:`Layered` are differentiated."""

    variables: Array  # (variables, 2), one of BY_DEPTH, ..., and a factor of this derivative of I
    intensity_factors: Array  # (variables, n), factor c of the term c * I that is added to each derivative
    field_errors: Array  # (3,), errors of derivatives of U with respect to depth, focus and v


class Rings(NamedTuple):
    """Data of images with arbitrary wavefronts: fields on circles around the axis, and interpolation to pixels."""

    bessel: Array  # (orders, circles, nodes), Bessel functions
    parts: NDArray[np.complex128]  # (n or 1, 2 orders - 1, fields, nodes)
    waves: NDArray[np.complex128]  # (n, nodes)
    power: Array  # (n,)
    angles: int  # number of angles on each circle, a result of :func:`fft_length`
    filter: Array  # weights of a circle, of its two neighbours, of the next two, ...
    radial: Array  # (terms, 16), radial interpolation weights ("taps") as polynomials, highest power first
    angular: Array  # (terms, 16), azimuthal interpolation weights as polynomials, highest power first
    taps: tuple[int, int]  # numbers of radial and of azimuthal weights
    gains: Array  # (2, 2 orders - 1), factors of azimuthal orders of I, and errors of these factors


class Ringed(NamedTuple):
    """Largest values of images of :class:`Rings`, from which their error bounds are computed."""

    squares: Array  # (fields, n), largest abs(field)^2 on the circles
    top: Array  # (n,), largest I on the circles
    aliases: Array  # (n,), bound on the aliasing error of I between the angles, after the filter
    sums: Array  # (n,), sum of the moduli of the azimuthal orders of I, after the filter
    pixel: Array  # (n,), largest pixel value


BY_DEPTH, BY_FOCUS, BY_AXIS = range(3)  # variables of derivatives in :func:`layered_images`


def layered_images(
    layered: Layered,
    window: Window,
    allowed: float,
    wanted: Wanted,
    *,
    integrate: bool = False,
    slopes: LayeredSlopes | None = None,
) -> Samples | None:
    """Return images with error bounds relative to their peaks, or None; the caller checks the bounds."""
    count = layered.planes.shape[1]
    values = np.empty((count, *window.shape), wanted.dtype) if wanted.out is None else wanted.out
    numbers = np.empty((3, count))
    numbers[0] = 0.0 if wanted.scale is None else wanted.scale
    kinds = 0 if slopes is None else len(slopes.variables) + int((slopes.variables[:, 0] == BY_AXIS).sum())
    derivatives, errors = np.empty((kinds, *values.shape), wanted.dtype), np.empty((kinds, count))
    arguments = None if slopes is None else (*slopes, derivatives, errors)
    images: Callable[..., bool] = _core.layered_images
    computed = images(layered, window, integrate, allowed, wanted.threads, values, numbers, arguments)
    results = None if slopes is None else Slopes(derivatives, errors / numbers[2])
    return Samples(values, numbers[0], numbers[1], results, numbers[2]) if computed else None


def layered_profiles(layered: Layered, v: Array, threads: int = 1) -> tuple[Array, Array]:
    """Return azimuthal orders of I at increasing v, (n, k, len(v)), and bounds on the error of I, (n,)."""
    return _core.layered_profiles(layered, v, threads)


def ringed_images(rings: Rings, window: Window, scales: Array, threads: int, out: Pixels) -> Ringed:
    """Write I times `scales` to `out`; the unit of the step of the window is the distance between circles."""
    images: Callable[..., Array] = _core.ringed_images
    sizes = images(rings, window, np.ascontiguousarray(scales), threads, out)
    return Ringed(sizes[:-4], *sizes[-4:])


class PixelRadii(NamedTuple):
    """Radii from which I at all pixels is interpolated, and factors of error bounds (certificate, section 9)."""

    v: Array
    error: float
    of_nodes: float
    of_grid: float
    rounding: float


def pixel_radii(window: Window, integrate: bool, level: int, threads: int = 0) -> PixelRadii:
    """Return radii for which the interpolation error is about ``10^-level``."""
    row, column = window.center
    return PixelRadii(*_core.pixel_radii(*window.shape, row, column, window.step, integrate, level, threads))


def pixel_values(
    window: Window, profiles: Array, integrate: bool, level: int, threads: int = 0
) -> tuple[Array, Array]:
    """Return pixels, shape (n, height, width), from I at the radii of :func:`pixel_radii`, and rounding bounds."""
    (row, column), values = window.center, np.empty((len(profiles), *window.shape))
    penalties = _core.pixel_values(
        np.ascontiguousarray(profiles), row, column, window.step, integrate, level, threads, values
    )
    return values, penalties


RowRule = _core.RowRule
"""Quadrature over a region of ellipses and polygons.

`nodes`, shape (3, number of nodes), has x, y and weight of each node; `weight` is the sum of the weights. `lost` is a
bound on the error of integrals of functions with abs(f) <= 1 that is caused by rounding of the edges.
"""


def row_rule(
    ellipses: ArrayLike,
    polygons: Sequence[ArrayLike],
    steps: Sequence[int],
    degree: int,
    error: float,
) -> RowRule:
    """Return a quadrature rule for polynomials p of a `degree` with abs(p) <= 1 on the unit disc.

    Parameters
    ----------
    ellipses : sequence of (x, y, a, b, angle)
        Ellipses, in the order of the shapes that are ellipses.
    polygons : sequence of sequences of (x, y)
        Corners of each shape; empty for an ellipse.
    steps : sequence of int
        The region in postfix notation: an index of a shape, -1 for the intersection of the last two operands, -2 for
        their union, -3 for the first operand without the second.
    degree : int
        Degree of the polynomials.
    error : float
        Largest error of an integral.
    """
    corners_of = [np.asarray(corners, dtype=np.float64).reshape(-1, 2) for corners in polygons]
    return _core.row_rule(
        np.array(ellipses, dtype=np.float64).reshape(-1, 5),
        np.concatenate(corners_of),
        np.array([len(corners) for corners in corners_of], dtype=np.int32),
        np.array(steps, dtype=np.int32),
        degree,
        error,
    )


def row_samples(x: Array, y: Array, weight: Array, phase: Array | None = None) -> RowRule:
    """Return a :data:`RowRule` of samples that are ordered by rows of equal y; each sample may have a `phase`."""
    # A new row begins where y changes.
    starts = np.flatnonzero(np.diff(y, prepend=np.nan) != 0.0)
    counts = np.diff(starts, append=len(y)).astype(np.int64)
    return _core.row_samples(y[starts], counts, x, weight, np.zeros(0) if phase is None else phase)


def row_images(
    rules: Sequence[RowRule], phases: Array, stack: DiskStack, window: Window, precision: float, wanted: Wanted
) -> tuple[Array, Array, Array]:
    """Return I (n, h, w), derivatives with respect to `wanted.terms` (k, n, h, w), bounds on the error of U (n,).

    Each rule integrates over a region of the pupil, which has an additional phase: `phases` (regions, 3) are its
    constant and its slopes in x and y. The bounds are on errors of the sums, about `precision` * sum(weights).
    """
    count, factors = len(stack.edge), np.array(wanted.terms, dtype=np.int32).reshape(-1, 2)
    values, slopes, bounds = (
        np.empty(s) for s in ((count, *window.shape), (len(factors), count, *window.shape), (count,))
    )
    _core.row_images(list(rules), phases, stack, window, precision, wanted.threads, values, factors, slopes, bounds)
    return values, slopes, bounds


def moments(
    degree: int, y: Array, counts: NDArray[np.int64], t: Array, weights: NDArray[np.complex128]
) -> NDArray[np.complex128]:
    """Return sums of an orthonormal basis of the disc, [k, m], over nodes in rows, `counts` of them at each `y`.

    The basis, k + m <= `degree`, is a Legendre polynomial of degree k in `t` = x / sqrt(1 - y^2) times
    (1 - y^2)^(k / 2) and a Gegenbauer polynomial of degree m in y.
    """
    return _core.moments(degree, y, counts, t, weights)


def moment_values(moments: NDArray[np.complex128], degree: int, y: Array, t: Array) -> NDArray[np.complex128]:
    """Return the sum over the basis of :func:`moments` up to a `degree` times `moments`, shape (len(y), len(t))."""
    return _core.moment_values(degree, moments, y, t)


def star_likelihood(images: Sequence[Pixels], flux: Array, star: Array, threads: int) -> tuple[Array, Array]:
    """Return the sums that Fisher scoring requires, for n star images and several sets of parameters.

    Parameters
    ----------
    images : sequence of ndarray, each of shape (sets * n, height, width)
        Model images of a point, followed by the derivatives of these images.
    flux : ndarray, shape (sets, 2, n)
        Flux and background of each image, electrons.
    star : ndarray, shape (4, n, height * width)
        Counted electrons; variance of the readout noise; variance of the readout noise for the weights; 1 for a valid
        pixel, else 0.
    threads : int
        Maximum number of threads; 0 for the number of processors.

    Returns
    -------
    numbers : ndarray, shape (3, sets, n)
        Negative log-likelihood up to a constant, expectation and variance of Pearson's chi2.
    products : ndarray, shape (sets, n, k + 2, k + 2)
        Sums over pixels of products of two of these quantities: the derivatives, the image, 1, and the residual, each
        divided by the standard deviation of the pixel.
    """
    kind = images[0].dtype
    compute = _core.star_likelihood_single if kind == np.float32 else _core.star_likelihood_double
    return compute([np.ascontiguousarray(image, kind) for image in images], flux, star, threads)


_CachedFunction = type(lru_cache(maxsize=1)(len))


def clear_caches() -> None:
    """Free the memory of all caches: tables of the compiled core, plans of :func:`lommel.psf`, and others.

    The next call rebuilds the tables: it takes as long as the first call in a process, with identical results.
    Running calls in other threads keep their tables until they return. Existing Plans, PSFs and operators remain
    valid. For the limits of the caches see :doc:`the guide </running>`.

    Examples
    --------
    >>> import lommel as lm
    >>> image = lm.psf(lm.Pupil(), 64, 0.25)
    >>> lm.clear_caches()
    """
    for name, module in tuple(sys.modules.items()):
        if name.startswith("lommel."):
            # Caches without a limit hold objects that exist once per process, such as classes; they are not cleared.
            for value in tuple(vars(module).values()):
                if isinstance(value, _CachedFunction) and value.cache_parameters()["maxsize"] is not None:
                    value.cache_clear()
    clear_tables()
