"""Functions of the compiled core with results and exceptions of Python; no other module imports the core.

These are functions of arrays, so that another implementation can replace them. The core returns 0 for "divide by the
largest value" or "met", and a negative bound for "not met"; here these are None and a ToleranceError.
"""

# Annotations are not postponed: a NamedTuple compiles each that is text, which takes longer than all else here.

import sys
from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel import _core
from lommel.base.arrays import Array
from lommel.core.answers import FieldValues, Images, Intensities, Pixels, Slopes, Wanted, not_met

# Functions of arrays without codes for what is not met: as the core has them.
FocalScale = _core.FocalScale
FocalStream = _core.FocalStream
MoleculeFitter = _core.MoleculeFitter
MoleculeTable = _core.MoleculeTable
average_samples = _core.average_samples
band_points = _core.band_points
bessel_sequence = _core.bessel_sequence
chirp_moments = _core.chirp_moments
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
huygens_sum = _core.huygens_sum
least_average = _core.least_average
least_squares = _core.least_squares
legendre_transforms = _core.legendre_transforms
levels = _core.levels
polynomial_fields = _core.polynomial_fields
product = _core.product
remainder_factors = _core.remainder_factors
scatter = _core.scatter
spread = _core.spread
table_bytes = _core.cached_bytes
transfer_rule = _core.transfer_rule


class RadialStack(NamedTuple):
    """Radially symmetric pupils."""

    terms: Array  # (n, k), coefficients of R_2^0, R_4^0, ..., radians at the edge
    obscuration: float  # over the radius of the aperture
    amplitude: Array  # g_0, g_1, ... of exp(-(g_0 + g_1 rho^2 + ...))


class DiskStack(NamedTuple):
    """Pupils of any wavefront, with obscuration and amplitude as of :class:`RadialStack`."""

    terms: NDArray[np.int32]  # (k, 2), n and m of each Zernike term, m < 0 for sines
    edge: Array  # (n, k), their coefficients, radians at the edge
    obscuration: float
    amplitude: Array


class Window(NamedTuple):
    """Pixels: (height, width), the pixel (row, column) that the axis is at, and their pitch in v.

    Or, where each of n pupils has an axis of its own, ``center`` is one array of these, shape (n, 2); of (1, 2) all
    have the one.
    """

    shape: tuple[int, int]
    center: tuple[float, float] | Array
    step: float


_NOTHING: dict[str, object] = {}


def _one_scale(wanted: Wanted) -> float:
    """Return the factor of all images; 0 where each has a peak of 1."""
    assert not isinstance(wanted.scale, np.ndarray), "images of one aperture have one scale"
    return wanted.scale or 0.0


def _places(count: int, window: Window, wanted: Wanted) -> tuple[float, Pixels, Array]:
    """Return the scale, the images that the core writes to, and for each its factor, error and peak."""
    values = np.empty((count, *window.shape), wanted.dtype) if wanted.out is None else wanted.out
    return _one_scale(wanted), values, np.empty((3, count))


def _require(unmet: float, tol: float, over: str) -> None:
    if unmet:
        raise not_met(tol, unmet, over)


def radial_images(
    stack: RadialStack, window: Window, tol: float, wanted: Wanted, *, integrate: bool = False
) -> Images:
    """Return samples around an axis anywhere, or averages over pixels."""
    scale, values, numbers = _places(len(stack.terms), window, wanted)
    slopes, more = None, _NOTHING
    if n := len(wanted.powers):
        slopes = Slopes(np.empty((n, *values.shape), values.dtype), np.empty((n, len(values))))
        more = {"powers": np.array(wanted.powers, dtype=np.int64)}
        more |= {"derivative_images": slopes.values, "derivative_bounds": slopes.error}
    render: Callable[..., float] = _core.render
    # By position, for by name a small image would take a sixth longer.
    unmet = render(stack, window, integrate, (tol, wanted.threads, scale), values, numbers, **more)
    _require(unmet, tol, _over(wanted))
    return Images(values, numbers[0], numbers[1], slopes, numbers[2])


def filters_pay(stack: RadialStack, window: Window, tol: float, *, derivatives: bool = False) -> bool:
    """Return whether averages of a stack, or their derivatives alone, are cheaper from finer samples."""
    return _core.filters_pay(stack, window, tol, derivatives)


def radial_plan(
    stack: RadialStack, shape: tuple[int, ...], window: Window, tol: float, wanted: Wanted, *, integrate: bool = False
) -> Callable[[Array, Pixels], tuple[Array, float] | None]:
    """Return what writes images of a stack as :func:`radial_images`, and returns their scales and largest bound.

    It returns None, with nothing written, where the arrays do not match, or :func:`filters_pay`; of `stack` all but
    its terms counts.
    """
    scale, kind = _one_scale(wanted), np.dtype(wanted.dtype).char
    request = tol, wanted.threads, scale
    plan = _core.RadialPlan(stack.obscuration, stack.amplitude, window, integrate, request, kind)
    over, alike = _over(wanted), np.full(shape, scale)
    alike.flags.writeable = False  # one for all answers
    render = plan.render

    def ask(terms: Array, values: Pixels) -> tuple[Array, float] | None:
        # With a given scale all answers share one read-only array.
        scales = None if scale else np.empty(shape)
        bound = render(terms, values, scales)
        if bound is None:
            return None
        if bound < 0.0:
            raise not_met(tol, -bound, over)
        return alike if scales is None else scales, bound

    return ask


def _over(wanted: Wanted) -> str:
    return 'the largest value in the window, as normalize="peak" takes it' if wanted.scale is None else "the peak"


def series_images(stack: DiskStack, window: Window, tol: float, wanted: Wanted) -> Images:
    """Return samples of pupils that need not be radially symmetric by their series; as :func:`radial_images`."""
    return _disk_images(_core.series_images, "the peak", stack, window, tol, wanted)


class FarPixels(NamedTuple):
    """Averages over pixels far from the axis of each image, 0 nearer to it."""

    values: Array  # (n, height, width)
    nearest: Array  # (n,), the distance in pixels from which on they are there
    error: Array  # (n,), bounds on the error of the intensity
    axes: Array  # (n, 2), row and column


def far_averages(stack: DiskStack, window: Window, most: float, tol: float, threads: int) -> FarPixels:
    """Return averages over pixels, from where on they are likely to be within `tol` of the largest one.

    None if that is more than `most` in v from the axis: the distance is larger than that of any pixel then.
    """
    count = len(stack.edge)
    values, numbers = np.empty((count, *window.shape)), np.empty((count, 5))
    _core.far_averages(stack, window, most, tol, threads, values, numbers)
    return FarPixels(values, numbers[:, 0], numbers[:, 1], numbers[:, 3:])


def chordal_images(
    stack: DiskStack,
    window: Window,
    tol: float,
    wanted: Wanted,
    *,
    if_cheaper: bool = False,
) -> Images:
    """Return the same by the chordal rule, with errors over the largest value in the window.

    Derivatives by the terms that `wanted` names are over the same value; their errors are bounded, not held to `tol`.
    With `if_cheaper`, images that :func:`series_images` is likely to take less time for raise Declined.
    """
    over = "the largest value in the window"
    if not wanted.terms:
        compute = _core.cheaper_chordal_images if if_cheaper else _core.chordal_images
        return _disk_images(compute, over, stack, window, tol, wanted)
    terms, count = np.array(wanted.terms, dtype=np.int32), len(stack.edge)
    slopes = Slopes(np.empty((len(terms), count, *window.shape), wanted.dtype), np.empty((len(terms), count)))
    more = {"factors": terms, "slopes": slopes.values, "bounds": slopes.error}
    made = _disk_images(_core.chordal_derivatives, over, stack, window, tol, wanted, **more)
    return made._replace(slopes=slopes)


def _averages_room(count: int, window: Window, wanted: Wanted) -> tuple[Images, tuple[Any, ...]]:
    """Return images that are not computed yet, with their derivatives, and the same as the core takes them."""
    scale, values, numbers = _places(count, window, wanted)
    by = np.array(wanted.terms, dtype=np.int32).reshape(-1, 2)
    slopes = Slopes(np.empty((len(by), *values.shape), wanted.dtype), np.empty((len(by), count)))
    images = Images(values, numbers[0], numbers[1], slopes if len(by) else None, numbers[2])
    return images, (scale, values, numbers, by, slopes.values, slopes.error)


def disk_averages(
    stack: DiskStack, window: Window, tol: float, wanted: Wanted, *, if_cheaper: bool = False
) -> Images | None:
    """Return averages over pixels, with errors over the largest one anywhere; None where others serve better.

    With `if_cheaper`, those that :func:`series_images` is likely to take less time for raise Declined.
    """
    images, (scale, *places) = _averages_room(len(stack.edge), window, wanted)
    compute: Callable[..., bool] = _core.disk_averages
    return images if compute(stack, window, (tol, wanted.threads, scale), if_cheaper, *places) else None


# From the largest distance in v, the error that fields may have there, whether sums in single precision are wanted,
# and numbers of nodes of rows and columns, to weights of a quadrant, what fields are off by with these, and whether
# that counts such sums.
ApertureRule = Callable[[float, float, bool, int, int], tuple[Array, float, bool] | None]


def aperture_averages(
    stack: DiskStack,
    window: Window,
    strehl: float,
    transmission: float,
    tol: float,
    wanted: Wanted,
    rule: ApertureRule,
) -> Images | None:
    """Return averages over pixels of an aperture around one axis, its amplitude in the weights of a rule of the disk.

    The weights at (x, y), (x, -y), (-x, y), (-x, -y) of each chord and node of a quadrant, of each the real and the
    imaginary part: (chords, nodes, 8). None where the window has no nodes, or there is no rule.
    """
    images, (scale, *places) = _averages_room(len(stack.edge), window, wanted)
    compute: Callable[..., bool] = _core.aperture_averages
    given = (stack.terms, stack.edge, window, (tol, wanted.threads, scale), strehl, transmission, rule)
    return images if compute(*given, *places) else None


def disk_costs(stack: DiskStack, window: Window, tol: float) -> tuple[float, float]:
    """Return nanoseconds that images are likely to take by :func:`chordal_images` and by :func:`series_images`.

    ValueError where the former cannot be computed.
    """
    return _core.disk_costs(stack, window, tol, tol >= 1e-6)


def chordal_plan(
    obscuration: float, amplitude: Array, window: Window, tol: float, wanted: Wanted, *, if_cheaper: bool = False
) -> Callable[[NDArray[np.int32], Array, Pixels], tuple[Array, float]]:
    """Return what writes images of a stack as :func:`chordal_images`, and returns their scales and largest bound.

    Called with the terms, their coefficients and the array for the values, of any axes before those of the window.
    """
    request = tol, wanted.threads, _one_scale(wanted)
    compute = _core.cheaper_chordal_images if if_cheaper else _core.chordal_images

    def ask(terms: NDArray[np.int32], edge: Array, values: Pixels) -> tuple[Array, float]:
        stack, count = values.shape[:-2], edge.size // len(terms)
        numbers = np.empty((3, count))
        flat, images = edge.reshape(count, -1), values.reshape(count, *window.shape)
        if unmet := compute((terms, flat, obscuration, amplitude), window, request, images, numbers):
            raise not_met(tol, unmet, "the largest value in the window")
        return numbers[0].reshape(stack), max(numbers[1].tolist())

    return ask


def chordal_gradient(
    stack: DiskStack, window: Window, tol: float, weights: Array, terms: tuple[tuple[int, int], ...], threads: int = 0
) -> Array:
    """Return derivatives of weighted sums of the intensity by the coefficients of Zernike terms, shape (n, k)."""
    values, which = np.empty((len(stack.edge), len(terms))), np.array(terms, dtype=np.int32)
    _require(
        _core.chordal_gradient(stack, window, tol, threads, weights, which, values),
        tol,
        "the largest value in the window",
    )
    return values


def chordal_sums(stack: DiskStack, window: Window, counts: tuple[int, int], threads: int = 0) -> NDArray[np.float32]:
    """Return intensities by so many chords and nodes, in single precision, unproven, shape ``(n, width, height)``."""
    made = np.empty((len(stack.edge), *window.shape[::-1]), dtype=np.float32)
    _core.chordal_sums(stack, window, counts, threads, made)
    return made


def chordal_sums_gradient(
    stack: DiskStack, window: Window, counts: tuple[int, int], weights: Array, threads: int = 0
) -> Array:
    """Return derivatives of their sums, times weights ``(n, height, width)``, by all coefficients."""
    made = np.empty(stack.edge.shape)
    _core.chordal_sums_gradient(stack, window, counts, threads, weights, made)
    return made


class NodeTables(NamedTuple):
    """Fields at the nodes of a quadrant of the chordal rule, x, y > 0, which are the last two axes of all tables.

    A field is the sum of its shares, ``factor * sum_n c_n R_n``. Parities are 2 for odd in x plus 1 for odd in y.
    """

    radial: Array  # (terms, ...), those of all parts
    ends: NDArray[np.int32]  # of the terms of each part
    shares: NDArray[np.int32]  # (k, 3): the field, the parity of the factor, the part
    factors: NDArray[np.complex128]  # (k, ...)


class NodeWaves(NamedTuple):
    """Weighted sums of waves over the images of nodes, by parity, of some kinds, and which wave each plane has."""

    values: NDArray[np.complex128]  # (kinds, waves, 4, ...)
    which: NDArray[np.int32]  # (planes,)


class NodeTerms(NamedTuple):
    """Zernike terms at the nodes, and their parities."""

    values: Array  # (terms, ...)
    parities: NDArray[np.int32]


def folded_waves(terms: NodeTerms, edge: Array, weights: Array, largest: float) -> NDArray[np.complex128]:
    """Return weighted sums of ``exp(i W)`` over the images of each node, by parity, (kinds, wavefronts, 4, ...).

    W is a sum of `terms` times the coefficients `edge`, shape (wavefronts, terms). The second kind, for a `largest` W
    above 0, is ``i W exp(i W)`` over it.
    """
    return _core.folded_waves(terms, edge, weights, largest)


class SeriesSizes(NamedTuple):
    """Bounds on parts of amplitudes on curves around the real angles, and at real angles."""

    on_curves: Array  # (series, planes, parts, curves)
    moduli: Array  # (series, planes, parts)


def chordal_series_sizes(
    coefficients: NDArray[np.complex128], ends: NDArray[np.int32], powers: Array, rate: Array, chosen: Array
) -> tuple[SeriesSizes, float, float]:
    """Return bounds on series (series, planes, terms), and halved numbers of chords and of nodes.

    `powers` (terms, curves) bound the terms. The numbers are the least over the curves of `chosen`, (2, curves), and
    the logarithm of the largest part times `rate`.
    """
    on_curves, moduli, chords, nodes = _core.chordal_series_sizes(coefficients, ends, powers, rate, chosen)
    return SeriesSizes(on_curves, moduli), chords, nodes


def chordal_field_errors(
    sizes: SeriesSizes,
    series: NDArray[np.int32],
    curves: tuple[Array, Array],
    left: Array,
    rounding: Array,
    shares: Array,
    error: float,
) -> Array:
    """Return what sums over chords and nodes are off by, (sets, planes, fields).

    Each set has a series, and what parts on the curves are multiplied by for chords and for nodes, (sets, curves);
    what is `left` out, and the `rounding` of moduli. `shares` (fields, parts) of parts, in which there may be another
    `error`, make a field.
    """
    return _core.chordal_field_errors(*sizes, series, *curves, left, rounding, shares, error)


def chordal_series_light(
    tables: NodeTables,
    coefficients: NDArray[np.complex128],
    waves: NodeWaves,
    window: Window,
    sets: NDArray[np.int32],
    terms: NodeTerms,
    wrong: Array,
    power: Array,
    threads: int = 0,
) -> tuple[Array, Array, Array]:
    """Return the sum of squares of fields in each plane, and its derivatives, (sets, planes, height, width).

    Over the `power` of each plane. Then what they are off by, of fields that are `wrong` by so much, (sets, planes,
    fields), and the largest of each in modulus, (sets, planes). `coefficients` have the shape (series, planes,
    terms); a set of fields has one of these series, is multiplied by i times one of the `terms` or, for -1, none, and
    has waves of a kind.
    """
    return _core.chordal_series_light(tables, (coefficients, sets), terms, waves, window, wrong, power, threads)


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
    """Return sums of the light of :func:`chordal_series_light` times `weights`, (planes, height, width).

    In each plane the sum, then its derivatives by sets but the first, none with a term, then by all `terms`, and as a
    second array the largest light and the largest modulus of each field.
    """
    return _core.chordal_series_gradient(tables, (coefficients, sets), terms, waves, window, weights, threads)


def _disk_images(
    compute: Callable[..., float],
    over: str,
    stack: DiskStack,
    window: Window,
    tol: float,
    wanted: Wanted,
    **more: object,
) -> Images:
    scale, values, numbers = _places(len(stack.edge), window, wanted)
    request = tol, wanted.threads, scale
    _require(compute(stack, window, request, values, numbers, **more), tol, over)
    return Images(values, numbers[0], numbers[1], None, numbers[2])


def radial_fields(stack: RadialStack, v: Array, tol: float) -> FieldValues:
    """Return U at rising v, with errors that serve an intensity within `tol` of the peak, likely."""
    return FieldValues(*_core.field(stack, v, tol))


def radial_profiles(stack: RadialStack, v: Array, tol: float, threads: int = 1) -> Intensities:
    """Return I at rising v, within `tol` of the peak."""
    values, bounds, peaks = _core.profile(stack, v, tol, threads)
    _require(-min(float(bounds.min()), 0.0), tol, "the peak")
    return Intensities(values, bounds, peaks)


class Layered(NamedTuple):
    """Planes through layers: angles, and the fields of their light."""

    rho: Array  # (q,)
    parts: NDArray[np.complex128]  # (m, q), of orders 0, 1, ..., with the weights of the rule
    rates: NDArray[np.complex128]  # (3, q), the phase, and its derivatives by depth and focus
    error: float  # bound on the error of each part of the field
    planes: Array  # (3, n), depth, focus and power
    forms: NDArray[np.complex128]  # (k, m, m), Hermitian, of each order of the azimuth
    turns: Array  # (k, 3), that order, and the factors of its cosine and its sine; order 0 first


class LayeredSlopes(NamedTuple):
    """Variables that images of such planes are differentiated by."""

    by: Array  # (k, 2), BY_DEPTH, ... of the engine, and a factor of that derivative of I
    own: Array  # (k, n), factor of I itself in each
    of_fields: Array  # (4,), errors of fields in derivatives by depth, focus, v and ln k
    turning: NDArray[np.complex128]  # (3, q), as `rates`, less a real number each
    changes: NDArray[np.complex128] | None  # (m, q), derivatives of `parts` by ln k


class Rings(NamedTuple):
    """Planes with any wavefront: fields on circles, and their interpolation to pixels."""

    bessel: Array  # (orders, circles, nodes)
    parts: NDArray[np.complex128]  # (n or 1, 2 orders - 1, fields, nodes)
    waves: NDArray[np.complex128]  # (n, nodes)
    power: Array  # (n,)
    angles: int  # on each circle, an fft_length
    filter: Array  # weights of a circle, of those on either side, ...
    along: Array  # (terms, 16), taps as polynomials, the highest power first
    around: Array  # likewise
    taps: tuple[int, int]  # numbers of taps along and around
    gains: Array  # (2, 2 orders - 1), factors of orders of the intensity, and their errors


class Ringed(NamedTuple):
    """Sizes that bound the errors of such planes."""

    squares: Array  # (fields, n), the largest of each field on circles
    top: Array  # (n,), the largest intensity on circles
    aliases: Array  # (n,), the error of the orders of one between angles, filtered
    sums: Array  # (n,), the sum of their moduli, filtered
    pixel: Array  # (n,), the largest pixel


BY_DEPTH, BY_FOCUS, BY_AXIS, BY_WAVENUMBER = range(4)  # by what :func:`layered_images` differentiates


def layered_images(
    asked: Layered,
    window: Window,
    allowed: float,
    wanted: Wanted,
    *,
    integrate: bool = False,
    slopes: LayeredSlopes | None = None,
) -> Images | None:
    """Return images of planes, with bounds on errors over their peaks that are to be compared with a tolerance."""
    count = asked.planes.shape[1]
    values = np.empty((count, *window.shape), wanted.dtype) if wanted.out is None else wanted.out
    numbers = np.empty((3, count))
    numbers[0] = 0.0 if wanted.scale is None else wanted.scale
    kinds = 0 if slopes is None else len(slopes.by) + int((slopes.by[:, 0] == BY_AXIS).sum())
    found, errors = np.empty((kinds, *values.shape), wanted.dtype), np.empty((kinds, count))
    derivatives = None if slopes is None else (*slopes, found, errors)
    images: Callable[..., bool] = _core.layered_images
    made = images(asked, window, integrate, allowed, wanted.threads, values, numbers, derivatives)
    of = None if slopes is None else Slopes(found, errors / numbers[2])
    return Images(values, numbers[0], numbers[1], of, numbers[2]) if made else None


def layered_profiles(asked: Layered, v: Array, threads: int = 1) -> tuple[Array, Array]:
    """Return orders of the azimuth at rising v, shape ``(n, k, len(v))``, and what their sum is off by, ``(n,)``."""
    return _core.layered_profiles(asked, v, threads)


def ringed_images(asked: Rings, window: Window, scales: Array, threads: int, out: Pixels) -> Ringed:
    """Write intensities times scales; the step of the window is in circles, its center is an array or one pixel."""
    images: Callable[..., Array] = _core.ringed_images
    made = images(asked, window, np.ascontiguousarray(scales), threads, out)
    return Ringed(made[:-4], *made[-4:])


class PixelRadii(NamedTuple):
    """Radii at which I tells all pixels of a window, and what becomes of its errors; certificate, section 9."""

    v: Array
    error: float
    of_nodes: float
    of_grid: float
    rounding: float


def pixel_radii(window: Window, integrate: bool, level: int, threads: int = 0) -> PixelRadii:
    """Return the radii for errors of about ``10^-level``."""
    row, column = window.center
    return PixelRadii(*_core.pixel_radii(*window.shape, row, column, window.step, integrate, level, threads))


def pixel_values(
    window: Window, profiles: Array, integrate: bool, level: int, threads: int = 0
) -> tuple[Array, Array]:
    """Return the pixels from I at those radii, shape ``(n, height, width)``, and what their rounding is at most."""
    (row, column), values = window.center, np.empty((len(profiles), *window.shape))
    penalties = _core.pixel_values(
        np.ascontiguousarray(profiles), row, column, window.step, integrate, level, threads, values
    )
    return values, penalties


RowRule = _core.RowRule
"""Quadrature over a region of ellipses and polygons: `nodes`, shape (3, n), x, y and weight; `weight`, their sum.

`lost` bounds what edges that are misplaced by rounding do to integrals of what is at most 1.
"""


def row_rule(
    ellipses: ArrayLike,
    polygons: Sequence[ArrayLike],
    steps: Sequence[int],
    degree: int,
    error: float,
) -> RowRule:
    """Return a rule off by at most `error` for polynomials of a `degree` that are at most 1 on the unit disc.

    Parameters
    ----------
    ellipses : sequence of (x, y, a, b, angle)
    polygons : sequence of sequences of (x, y)
        Of each part its corners, none of an ellipse.
    steps : sequence of int
        The region in postfix order: numbers of parts, -1 for both of two, -2 for either, -3 for the first without the
        second.
    degree : int
    error : float
    """
    given = [np.asarray(corners, dtype=np.float64).reshape(-1, 2) for corners in polygons]
    return _core.row_rule(
        np.array(ellipses, dtype=np.float64).reshape(-1, 5),
        np.concatenate(given),
        np.array([len(corners) for corners in given], dtype=np.int32),
        np.array(steps, dtype=np.int32),
        degree,
        error,
    )


def row_samples(x: Array, y: Array, weight: Array, phase: Array | None = None) -> RowRule:
    # A new row begins where y changes.
    """Return samples, those of each row one after the other, as such a rule; each may have a phase."""
    starts = np.flatnonzero(np.diff(y, prepend=np.nan) != 0.0)
    counts = np.diff(starts, append=len(y)).astype(np.int64)
    return _core.row_samples(y[starts], counts, x, weight, np.zeros(0) if phase is None else phase)


def row_images(
    rules: Sequence[RowRule], phases: Array, stack: DiskStack, window: Window, precision: float, wanted: Wanted
) -> tuple[Array, Array, Array]:
    """Return intensities (n, h, w), derivatives by terms of `wanted` (k, n, h, w), and what sums lose of U (n,).

    Of pupils on regions with `phases` (regions, 3), constant and by x and y; sums lose about `precision` of weights.
    """
    count, factors = len(stack.edge), np.array(wanted.terms, dtype=np.int32).reshape(-1, 2)
    values, slopes, lost = (
        np.empty(s) for s in ((count, *window.shape), (len(factors), count, *window.shape), (count,))
    )
    _core.row_images(list(rules), phases, stack, window, precision, wanted.threads, values, factors, slopes, lost)
    return values, slopes, lost


def star_likelihood(images: Sequence[Pixels], light: Array, star: Array, threads: int) -> tuple[Array, Array]:
    """Return what Fisher scoring needs of the counts of stars, given images of sets of parameters.

    Parameters
    ----------
    images : sequence of ndarray, each of shape (sets * n, height, width)
        The images of a point, and their derivatives.
    light : ndarray, shape (sets, 2, n)
        Flux and background of each image, electrons.
    star : ndarray, shape (4, n, height * width)
        Electrons counted; variance of reading; the same as weights are made with; 1 where a pixel is valid, else 0.
    threads : int
        At most; 0 for all.

    Returns
    -------
    numbers : ndarray, shape (3, sets, n)
        Minus the log-likelihood up to a constant, expectation and variance of Pearson's chi2.
    products : ndarray, shape (sets, n, k + 2, k + 2)
        Sums over pixels of the products of the derivatives, the image, 1, and the residual, over standard deviations.
    """
    kind = images[0].dtype
    compute = _core.star_likelihood_single if kind == np.float32 else _core.star_likelihood_double
    return compute([np.ascontiguousarray(image, kind) for image in images], light, star, threads)


_Kept = type(lru_cache(maxsize=1)(len))


def clear_caches() -> None:
    """Free the memory kept between calls: tables of the compiled core, plans of :func:`lommel.psf` and others.

    The next call recomputes what it needs: it takes as long as the first call of a process, with identical results.
    Calls that are running in other threads keep what they use until they return. Plans, PSFs and operators that you
    hold stay valid. For the limits of the caches see :doc:`the guide </running>`.

    Examples
    --------
    >>> import lommel as lm
    >>> image = lm.psf(lm.Pupil(), 64, 0.25)
    >>> lm.clear_caches()
    """
    for name, module in tuple(sys.modules.items()):
        if name.startswith("lommel."):
            # Those without a limit hold what is made once a process: classes, what is registered elsewhere.
            for value in tuple(vars(module).values()):
                if isinstance(value, _Kept) and value.cache_parameters()["maxsize"] is not None:
                    value.cache_clear()
    clear_tables()
