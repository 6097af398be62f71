r"""Pixel integration for any pupil: samples on a fine grid, and a filter.

Lengths are in units of ``v = pi x / (lambda*N)``, frequencies w in radians per unit of v, and a is the pixel pitch.
Averaging the intensity I over a pixel multiplies the transfer function of I (OTF) by
``sinc(a wx / 2) sinc(a wy / 2)``, with ``sinc x = sin(x) / x``. The OTF vanishes for ``abs(w) > 2``. Weights ("taps")
c_k of samples with the spacing h therefore compute the average over a pixel if the response of the weights,
``C(w) = sum_k c_k cos(k h w)``, equals the sinc for ``abs(w) <= 2``. An error eps of the responses along x and y
changes an average by at most ``(2 eps + eps^2) int abs(OTF) dw``; the integral is at most the unaberrated peak. Far
pixels of circular and annular pupils are averaged in closed form, without samples.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple, TypeVar

import numpy as np

from lommel.base.arrays import Array, largest
from lommel.core.answers import Declined, Pixels, Samples, Slopes, ToleranceError, Wanted, not_met
from lommel.core.engine import (
    FarPixels,
    average_samples,
    band_points,
    least_average,
    least_squares,
    transfer_rule,
)
from lommel.methods.method import normalized_error, stored, storing
from lommel.optics.base_pupil import BasePupil
from lommel.optics.grid import Grid

if TYPE_CHECKING:
    from lommel.optics.pupil import Pupil

# Two adjacent pixels may share an odd number s of samples with the spacing ``h = 2 a / s``. The centre of one pixel
# then lies on a sample, and the centre of the other pixel lies half-way between two samples.

_PAIR_SPACING = 1.27  # largest spacing (v) of samples that two pixels share; the Nyquist limit of I is pi / 2
_TAP_COST = 0.02  # time to apply one weight for one pixel, divided by the time to compute one sample
_PAIR_COST_LIMIT = 0.85  # two pixels share samples if this reduces the number of samples below this fraction


P = TypeVar("P", bound=BasePupil)
Function = Callable[[Array], Array]


def fit_taps(response: Function, wave: Function, x: Pixels, *, in_mean: bool = False) -> tuple[Array, float, float]:
    """Return weights of samples at distances `x` (v) on both sides, and error and gain as in :class:`Taps`.

    The error is the maximum error of the response for ``abs(w) <= 2`` or, if `in_mean`, a bound on the mean error of
    the response, weighted by the OTF of a circular aperture.
    """
    # Least-squares fit of the response at points w of the band.
    w = band_points(float(x[-1]))
    # Weights at x and -x have equal moduli: each distance except 0 counts twice.
    multiplicity = np.where(x > 0.0, 2.0, 1.0)
    basis, target = multiplicity * wave(np.outer(w, x)), response(w)
    if in_mean:
        # Least squares in the norm that bounds the mean error: certificate, section 10.
        nodes, weights = transfer_rule(w.size)
        root = np.sqrt(weights)
        design, rhs = (root * multiplicity[:, None] * wave(np.outer(x, nodes))).T, root * response(nodes)
    else:
        design, rhs = basis, target
    c: Array = least_squares(np.ascontiguousarray(design), rhs[:, None])[:, 0]
    c *= (x > 0.0) | (wave is np.cos)  # sine filters are odd: the weight at 0 is 0
    gain = float((multiplicity * np.abs(c)).sum())
    # Rounding of the response: an error of 2^-52 for each product and each sum over the taps.
    rounding = 2.0**-52 * (x.size + 3) * gain
    # Up to 1e-17 the error is a polynomial in w, and at most sqrt(2) times its maximum at Chebyshev nodes, whose
    # number is twice the degree.
    highest = math.sqrt(2.0) * (float(np.abs(basis @ c - target).max()) + rounding) + 1e-17
    if in_mean:
        # If both responses, along y and x, have the mean error m, their product has the mean error m (2 + `highest`):
        # twice what is returned, as the product of two responses of error e is in error by at most (2 + e) e.
        mean_error = (1.0 + 0.5 * highest) * (float(np.linalg.norm(design @ c - rhs)) + 2.0 * rounding + 1e-17)
        return c, mean_error, gain
    return c, highest, gain


def pair_stride(step: float, error: float, stride: int, sides: tuple[int, ...], *, in_mean: bool) -> int:
    """Return the number of samples per two pixels: 2 `stride`, or fewer if this saves time; `sides` in pixels."""
    # Wider spacing requires longer filters, and therefore more samples beyond the edges of the window.

    def cost(count: int) -> float:
        taps = 2.0 * _half_length(step, error, count, in_mean=in_mean)
        rows, columns = (0.5 * count * side + taps for side in sides)
        return rows * columns + (_TAP_COST * taps * sides[0] * (columns + sides[1]) if in_mean else 0.0)

    # At least 2 samples per two pixels: 1 sample would require interpolation half-way, which magnifies errors.
    # Filters with a bounded mean error allow h = pi / 2; others need a gap between band and first alias.
    lower_limit = 2.0 * step / (0.5 * math.pi * (1.0 + 1e-12) if in_mean else _PAIR_SPACING)
    numbers = range(max(2, math.ceil(lower_limit)), 2 * stride + 1)
    cheapest = min((count for count in numbers if count % 2 == 0 or 2.0 * step <= count * _PAIR_SPACING), key=cost)
    return cheapest if cost(cheapest) < (1.0 if in_mean else _PAIR_COST_LIMIT) * cost(2 * stride) else 2 * stride


def _half_length(step: float, error: float, s: int, *, in_mean: bool) -> int:
    """Estimate the number of samples on each side of the middle of a filter, at s samples per two pixels."""
    # Gap between the band of I and its first alias, divided by the sampling frequency 2 pi / h. The filter length is
    # proportional to 1 / gap (certificate, "Samples that pixels share").
    gap = 1.0 - 4.0 * step / (s * math.pi)
    if in_mean:
        # Without a gap the error falls only as a power of the filter length.
        length = math.log(0.1 / error) / (3.7 * gap + 0.2) - 3.0 + s % 2
        return max(s // 4 + 2, int(0.25 * s + min(length, (0.045 / error) ** 0.32)))
    return max(s // 4 + 2, int(0.25 * s + math.log(0.1 / error) / (3.4 * gap)) - 2)


def fit_pair_weights(
    response: Function, step: float, error: float, s: int, *, in_mean: bool = False
) -> tuple[Array, float, float]:
    """Return weights (2, taps) for two pixels that share `s` samples (odd), and their error and gain."""
    h, side = 2.0 * step / s, _half_length(step, error, s, in_mean=in_mean)
    while True:
        centred, largest_error, gain = fit_taps(response, np.cos, h * np.arange(side + 1), in_mean=in_mean)
        midway, midway_error, midway_gain = fit_taps(response, np.cos, h * (np.arange(side) + 0.5), in_mean=in_mean)
        largest_error, gain = max(largest_error, midway_error), max(gain, midway_gain)
        if (largest_error <= error and gain <= 1.5) or side > s + 60:
            weights = np.zeros((2, 2 * side + s // 2 + 1))
            weights[0, : 2 * side + 1] = np.concatenate([centred[:0:-1], centred])
            weights[1, s // 2 + 1 :] = np.concatenate([midway[::-1], midway])
            return weights, largest_error, gain
        side += 1 + side // 16 * in_mean


_BLOCK_SAMPLES = 2**23  # largest number of samples held in memory together
_FIRST_SPACING, _RETRY_SPACING = 1.05, 0.8  # largest spacing (v) of samples: 2/3 and 1/2 of the Nyquist limit pi / 2
_MAX_STRIDE = 512  # largest number of samples across a pixel
_SINGLE_TOL = 2e-7  # smallest tolerance at which samples are stored in single precision
_MAX_PITCH = 20.0  # largest pixel pitch (v) for filters with a bounded mean error, which are slow for large pixels
_MEAN_FACTOR = 64.0  # allowed mean error of a response, divided by its allowed largest error, at a Strehl ratio of 1
_SLOPE_FACTOR = 10.0  # allowed error of derivative filters, divided by the allowed error of averaging filters
_DARK_PART = 0.1  # fraction of the tolerance that summation of dark samples in single precision may use
_NO_LIMIT = 1e30  # brightness (relative to the peak) above the brightness of any sample

# Signature: pupils, pixels, tolerance, specification -> intensity at the pixel centres.
Sample = Callable[[P, Grid, float, Wanted], Samples]
# Signature: pupils, pixels, largest v at which far pixels may start, tolerance, threads -> averages of far pixels.
Far = Callable[[P, Grid, float, float, int], FarPixels]

Band = tuple[float, float]  # bandwidth divided by the bandwidth of I, and integral of the modulus of the OTF


class Averages(NamedTuple):
    """Pixel averages of the flattened stack, and their derivatives."""

    values: Array  # (1 + k, n, height, width): I, its derivatives by phase coefficients, then along y and x
    error: Array  # (1 + k, n), error bounds relative to the peak; the bound of I includes rounding in storage
    peak: Array  # (n,), largest average, to which the bounds refer


def pixel_averages(
    sample: Sample[P],
    pupil: P,
    grid: Grid,
    tol: float,
    wanted: Wanted,
    band: Band | None = None,
    *,
    gradients: bool = False,
) -> Averages:
    """Return the intensity averaged over each pixel, with error bounds that are at most `tol` after storing.

    With `gradients`, the derivatives by v along y and x are appended, from the same samples.
    """
    # Errors are relative to the largest average in the plane. If `wanted` has no scale, values are divided by the
    # largest average in the window, and errors are relative to it. Zernike terms are at most 1, so that the OTF
    # of a derivative by a term has at most twice the modulus of the unaberrated OTF. `band` describes light whose
    # bandwidth differs from the bandwidth of an intensity: products of fields, or several emitters.
    try:
        return _averages_at_spacing(sample, pupil, grid, tol, wanted, band, _FIRST_SPACING, gradients=gradients)
    except ToleranceError:
        # The filter for the first, wider spacing is longer, and adds errors of bright light outside a dark window.
        return _averages_at_spacing(sample, pupil, grid, tol, wanted, band, _RETRY_SPACING, gradients=gradients)


def _averages_at_spacing(
    sample: Sample[P],
    pupil: P,
    grid: Grid,
    tol: float,
    wanted: Wanted,
    band: Band | None,
    spacing: float,
    *,
    gradients: bool,
) -> Averages:
    # Light of twice the bandwidth requires the filter for twice the pitch; `ceiling` bounds int abs(OTF).
    bandwidth, ceiling = (1.0, pupil.amplitude**2) if band is None else band
    step, normalize = bandwidth * grid.step(pupil), wanted.scale is None
    least_ratio = least_average(step)
    tol_stored = error_before_storing(tol, wanted)
    err_samples, err_response = _first_errors(tol_stored, step)
    in_mean = (
        band is None and not gradients and spacing == _FIRST_SPACING and step <= _MAX_PITCH and pupil.within_disc
    )
    if in_mean:
        # Rounded to a power of two, so that pupils with similar peaks use the same cached filter.
        ceiling, err_response = (
            1.0,
            err_response * 2.0 ** math.floor(math.log2(_MEAN_FACTOR * ceiling * pupil.likely_strehl)),
        )
    # Five attempts: each reduces the allowed errors of samples and filter by the factors by which they were exceeded.
    for _ in range(5):
        taps, slope = _choose_filters(step, err_response, spacing, grid.shape, gradients=gradients, in_mean=in_mean)
        tol_samples = err_samples / taps.gain**2
        err_single, limit = _dark_samples(
            taps, _DARK_PART * tol_stored * least_ratio if tol_samples >= _SINGLE_TOL else 0.0
        )
        try:
            total, err_input, peaks = _average_stack(sample, pupil, grid, tol_samples, taps, wanted, limit, slope)
        except ToleranceError as fault:
            # Filtering multiplies the errors of samples by the squared gain: certificate, section 10.
            bound = math.inf if fault.bound is None else tol * fault.bound / tol_samples
            pixels = f"by averages over pixels of {step / math.pi:.3g} lambda*N in double precision"
            raise not_met(tol, bound, "the largest value in the window", pixels) from None
        tops = total[0].max(axis=(1, 2))
        rounding = (2 * taps.weights.shape[-1] + 8) * 2.0**-53 * taps.gain**2
        err_filter = (2.0 + taps.error) * taps.error * ceiling
        err_added = err_filter + (rounding + 1.01 * err_single) * peaks[0]
        # The largest average in the plane is at least least_ratio * (peak of I): section 10, "Relative to what".
        peak = tops if normalize else np.maximum(tops, least_ratio * peaks[0])
        if not peak.min() > 0:
            break
        relative = (err_input[0] + err_added) / peak
        bounds = stored_error(relative, wanted)
        if largest(bounds) <= tol:
            # The OTFs of derivatives by terms have at most twice the modulus of the unaberrated OTF: section 8.
            errors = err_input + 2.0 * err_filter + rounding * peaks
            if slope is not None:
                # The responses of the derivative and averaging filters are at most 2 and 1: section 12, "Shifts".
                slope_error = (slope.error * (1.0 + taps.error) + 2.0 * taps.error) * ceiling
                rounding = (4 * taps.weights.size + 16) * 2.0**-53 * taps.gain * slope.gain
                errors[-2:] = err_input[-2:] + slope_error + rounding * peaks[-2:]
            errors /= peak
            errors[0] = bounds
            return Averages(total, errors, peak)
        excess = float((err_input[0] / peak).max()) / (0.5 * tol_stored)
        # If only the filter is too inaccurate, keep the tolerance of samples: a smaller tolerance may fail.
        if excess > 1.0 and err_samples >= _SINGLE_TOL * taps.gain**2:
            # Errors in single precision do not predict errors in double precision: the next tolerance is at the
            # limit.
            err_samples = 0.9 * _SINGLE_TOL
        elif excess > 1.0:
            err_samples /= excess
        err_response *= min(1.0, 0.2 * tol_stored / float((err_added / peak).max()))
    raise not_met(tol, 1.0 if not peak.min() > 0 else float(bounds.max()), "the largest value in the window")


def _choose_filters(
    step: float, error: float, spacing: float, shape: tuple[int, int], *, gradients: bool, in_mean: bool
) -> tuple[Taps, Taps | None]:
    """Return an averaging filter with the allowed `error`, and a derivative filter if `gradients`, else None."""
    if gradients:
        return _average_and_slope_filters(step, error, spacing)
    if spacing < _FIRST_SPACING:
        return averaging_filter(step, error, spacing), None
    return _cheapest_filter(step, error, shape, in_mean=in_mean), None


def _dark_samples(taps: Taps, allowed: float) -> tuple[float, float]:
    """Return the error of summing dark samples in single precision, and the largest brightness of dark samples.

    Both are relative to the peak; the error is at most `allowed`: certificate, section 10, "Dark rows".
    """
    # Error for the largest dark sample d: 2 (n + 4) u32 G^2 d, with n weights, unit roundoff u32 and gain G.
    summation_error = 2.0 * (taps.weights.shape[-1] + 4) * 2.0**-24 * taps.gain**2
    return (summation_error, _NO_LIMIT) if allowed > summation_error else (allowed, allowed / summation_error)


def error_before_storing(tol: float, wanted: Wanted) -> float:
    """Return the allowed error of averages before images are stored within the tolerance `tol`."""
    # Division by the largest value of the window doubles the relative error; 0.4 instead of 0.5 leaves a margin.
    return (0.4 if wanted.scale is None else 1.0) * (tol - (1.0 + tol) * storing(wanted.dtype))


def stored_error(error: Array, wanted: Wanted) -> Array:
    """Return the error of stored images from the `error` of averages, both relative to the peak."""
    return stored(normalized_error(error) if wanted.scale is None else error, wanted.dtype)


def _first_errors(allowed: float, step: float) -> tuple[float, float]:
    """Estimate the errors of samples and of a filter response that keep averages within the error `allowed`."""
    # Assumptions: the largest average is 4 times its lower bound, and the Strehl ratio is not small.
    least_ratio = least_average(step)
    # Half of the error is for samples, 0.002 for the response, whose error is multiplied by the peak intensity.
    return 0.5 * allowed * min(4.0 * least_ratio, 1.0), 2e-3 * allowed * least_ratio


_FAR_FRACTION = 0.7  # fraction of the tolerance that far pixels may use, if the peak is as estimated
_MIN_SAVED_SAMPLES = 250000  # least number of samples that far pixels must save


@lru_cache(maxsize=64)
def largest_far_start(step: float, shape: tuple[int, int]) -> float:
    """Return the largest v at which far pixels may start such that they save time; 0 if they cannot save time."""
    count = math.prod(shape) - _MIN_SAVED_SAMPLES * (_PAIR_SPACING / step) ** 2
    return 0.5 * step * max(0.0, min(math.sqrt(max(0.0, count)), *shape), count / min(shape))


def estimate_far_start(pupil: Pupil, grid: Grid, tol: float) -> float:
    """Estimate the smallest v at which far pixels can start; 0 if all pixels need samples."""
    step = grid.step(pupil)
    if largest_far_start(step, grid.shape) == 0.0:
        return 0.0
    # Diffraction rings, averaged without aberrations, have the amplitude m_0 / r^3: section 9, "Farther out".
    rings = 4.0 / math.pi * float(pupil.illumination.at(np.ones(()))) ** 2 * min(1.0, math.sqrt(2.0) / step)
    return math.cbrt(rings / (_FAR_FRACTION * tol * min(1.0, 4.0 * math.pi * pupil.transmission / step**2)))


def _near_and_far(
    sample: Sample[P], far: Far[P], pupil: P, grid: Grid, tol: float, wanted: Wanted
) -> Averages | None:
    """Return averages, far pixels in closed form; None if this is slower or does not meet the tolerance."""
    step = grid.step(pupil)
    far_limit = largest_far_start(step, grid.shape)
    if wanted.terms or wanted.powers or far_limit == 0.0:
        return None
    allowed = error_before_storing(tol, wanted)
    if allowed <= 0.0:
        return None
    tol_far = _FAR_FRACTION * allowed
    for _ in range(3):
        try:
            far_part = far(pupil, grid, far_limit, tol_far, wanted.threads)
            slices = [
                slice(
                    max(0, math.floor((axis - far_part.nearest).min())),
                    min(side, math.ceil((axis + far_part.nearest).max()) + 1),
                )
                for axis, side in zip(far_part.axes.T, grid.shape, strict=True)
            ]
            shape = tuple(max(0, part.stop - part.start) for part in slices)
            if not 0 < math.prod(shape) < math.prod(grid.shape):
                return None
            center = [middle - part.start for middle, part in zip(grid.center, slices, strict=True)]
            box = Grid((shape[0], shape[1]), grid.side, center=(center[0], center[1]), integrate=True)
        except (Declined, ToleranceError):
            return None
        try:
            near_part = pixel_averages(sample, pupil, box, tol, wanted)  # Declined is not caught
        except ToleranceError:
            return None  # the whole window may meet the tolerance, since its peak may be larger
        err_outer = far_part.error / near_part.peak
        bounds = stored_error(err_outer, wanted)
        if bounds.max() <= tol:
            far_part.values[:, slices[0], slices[1]] = near_part.values[0]
            # The divisor is the largest average of the whole window, far pixels included.
            tops = far_part.values.max(axis=(1, 2)) if wanted.scale is None else near_part.peak
            return Averages(
                far_part.values[None], np.maximum(near_part.error, bounds), np.maximum(near_part.peak, tops)
            )
        tol_far *= 0.8 * allowed / float(err_outer.max())
    return None


def averaged_images(
    sample: Sample[P],
    pupil: P,
    grid: Grid,
    tol: float,
    wanted: Wanted,
    band: Band | None = None,
    far: Far[P] | None = None,
) -> Samples:
    """Return point samples or, if `grid` integrates, pixel averages; `far` computes averages of far pixels."""
    if not grid.integrate:
        return sample(pupil, grid, tol, wanted)
    averages = None if far is None else _near_and_far(sample, far, pupil, grid, tol, wanted)
    return to_images(pixel_averages(sample, pupil, grid, tol, wanted, band) if averages is None else averages, wanted)


def to_images(averages: Averages, wanted: Wanted) -> Samples:
    """Return averages and their derivatives as images in the requested scale and type."""
    intensity = averages.values[0]
    scales = np.empty(len(intensity))
    scales[:] = 1.0 / averages.peak if wanted.scale is None else wanted.scale
    values = np.empty(intensity.shape, wanted.dtype) if wanted.out is None else wanted.out
    np.multiply(intensity, scales[:, None, None], out=values, casting="same_kind")
    slopes = None
    if len(averages.values) > 1:
        error = averages.error[1:]
        steepest = np.abs(averages.values[1:]).max(axis=(2, 3)) / averages.peak
        scaled = (averages.values[1:] * scales[:, None, None]).astype(wanted.dtype)
        slopes = Slopes(scaled, error + (steepest + error) * storing(wanted.dtype))
    return Samples(values, scales, averages.error[0], slopes, averages.peak)


class Taps(NamedTuple):
    """Filter along one axis, for averages over pixels or for derivatives."""

    stride: int  # number of samples per pixel or, with weights of two pixels, per two pixels (odd)
    weights: Array  # (2 k + 1,), of samples -k ... k around the centre; of two pixels (2, taps): fit_pair_weights()
    error: float  # bound on the error of the response for abs(w) <= 2, or on the mean error: fit_taps(in_mean=True)
    gain: float  # sum of the moduli of the weights: the largest factor by which the filter multiplies errors

    @property
    def pixels(self) -> int:
        """Number of adjacent pixels with different weights: 1 or 2."""
        return 1 if self.weights.ndim == 1 else len(self.weights)

    @property
    def margin(self) -> int:
        """Number of samples before the centre of the first pixel."""
        return int(self.weights.shape[-1] - (self.pixels - 1) * (self.stride // 2)) // 2


def samples_across(step: float, spacing: float = _FIRST_SPACING) -> int:
    """Return the number of samples across a pixel of pitch `step` in v, with a spacing of at most `spacing`."""
    if step > _MAX_STRIDE * _FIRST_SPACING:
        raise Declined(
            f"pixel must be at most {_MAX_STRIDE * _FIRST_SPACING / math.pi:.0f} lambda*N to average a pupil "
            f"without radial symmetry, got {step / math.pi:.4g} lambda*N; use smaller pixels, "
            "and average blocks of them"
        )
    return max(1, math.ceil(step / spacing))


@lru_cache(maxsize=64)
def averaging_filter(step: float, error: float, spacing: float = _FIRST_SPACING, *, by_pitch: bool = False) -> Taps:
    """Return a filter for averages over pixels of pitch `step`, with samples at most `spacing` apart (both in v).

    If `by_pitch`, the filter computes derivatives of averages by ln a: response ``cos(a w / 2) - sinc(a w / 2)``.
    """

    def response(w: Array) -> Array:
        mean = _sinc(step)(w)
        return np.cos(0.5 * step * w) - mean if by_pitch else mean

    return _shortest_filter(response, np.cos, step, error, spacing, 3.0 if by_pitch else 1.5)


def _sinc(step: float) -> Callable[[Array], Array]:
    return lambda w: np.sinc(0.5 * step / math.pi * w)


@lru_cache(maxsize=64)
def _cheapest_filter(step: float, error: float, shape: tuple[int, int], *, in_mean: bool) -> Taps:
    """Return the averaging filter of least cost for a window of `shape`; two pixels may share samples."""
    s = pair_stride(step, error, samples_across(step), shape, in_mean=in_mean)
    if s % 2 == 0:
        return _shortest_filter(
            _sinc(step), np.cos, step, error, 2.0 * step / s * (1.0 + 1e-12), 1.5, in_mean=in_mean
        )
    return Taps(s, *fit_pair_weights(_sinc(step), step, error, s, in_mean=in_mean))


@lru_cache(maxsize=64)
def slope_filter(step: float, error: float, *, averages: bool, spacing: float = _FIRST_SPACING) -> Taps:
    """Return a filter for derivatives by v along an axis: of pixel averages or, without `averages`, of I.

    The response, divided by i, is ``w sinc(a w / 2)`` or w.
    """

    def response(w: Array) -> Array:
        return w * np.sinc(0.5 * step / math.pi * w) if averages else w

    return _shortest_filter(response, np.sin, step, error, spacing, 6.0)


def _shortest_filter(
    response: Function,
    wave: Function,
    step: float,
    error: float,
    spacing: float,
    max_gain: float,
    *,
    in_mean: bool = False,
) -> Taps:
    """Return the shortest filter with at most this `error` and gain `max_gain`, else the longest filter tried."""
    stride = samples_across(step, spacing)
    side, is_odd = _half_length(step, error, 2 * stride, in_mean=True) if in_mean else stride // 2 + 2, wave is np.sin
    while True:
        c, max_error, gain = fit_taps(response, wave, step / stride * np.arange(side + 1), in_mean=in_mean)
        # A filter with too few samples beyond the edges of a pixel may have large weights, which magnify errors.
        if (max_error <= error and gain <= max_gain) or side > stride + 60:
            # Sine filters are odd: weights before the centre have the opposite sign.
            return Taps(stride, np.concatenate([-c[:0:-1] if is_odd else c[:0:-1], c]), max_error, gain)
        side += 1 + side // 16 * in_mean


@lru_cache(maxsize=64)
def _average_and_slope_filters(step: float, error: float, spacing: float) -> tuple[Taps, Taps]:
    """Return an averaging filter with the allowed `error` and a derivative filter, of equal length."""
    averaging = averaging_filter(step, error, spacing)
    return pad_filters(averaging, slope_filter(step, _SLOPE_FACTOR * error, averages=True, spacing=spacing))


def pad_filters(a: Taps, b: Taps) -> tuple[Taps, Taps]:
    """Return two filters padded with zeros to the same number of weights."""
    size = max(a.weights.size, b.weights.size)
    return tuple(taps._replace(weights=np.pad(taps.weights, (size - taps.weights.size) // 2)) for taps in (a, b))  # type: ignore[return-value]


def _average_stack(
    sample: Sample[P],
    pupil: P,
    grid: Grid,
    tol: float,
    taps: Taps,
    wanted: Wanted,
    dark_limit: float,
    slope: Taps | None = None,
) -> tuple[Array, Array, Array]:
    """Return averages in the order of :class:`Averages`, their errors due to errors of samples, and largest samples.

    Samples of at most `dark_limit` times the peak are summed in single precision. If the filter `slope` is present,
    the last two entries of the first axis are derivatives along y and x.
    """
    count, images = math.prod(pupil.shape), 1 + len(wanted.terms) + len(wanted.powers)
    dtype = np.dtype(np.float32 if tol >= _SINGLE_TOL else np.float64)
    request = Wanted(dtype=dtype, threads=wanted.threads, terms=wanted.terms, powers=wanted.powers)
    arrays = images + (0 if slope is None else 2)
    total, error, peaks = np.empty((arrays, count, *grid.shape)), np.zeros((arrays, count)), np.zeros((arrays, count))
    for part, pupils, pixels in blocks(pupil, grid, taps, images):
        for fine_grid, rows in _sample_strips(total[:, part], pixels, taps):
            # Strips limit the memory for samples. Errors and peaks are the largest of all strips.
            sampled = sample(pupils, fine_grid, tol, request)
            err = sampled.bound * sampled.brightest
            error[0, part] = np.maximum(error[0, part], taps.gain**2 * err)
            peaks[0, part] = np.maximum(peaks[0, part], sampled.brightest - err)
            limit = dark_limit * float(sampled.brightest.min())
            average_samples(sampled.values, _weight_rows(taps), taps.stride, wanted.threads, rows[0], dark=limit)
            if slope is not None:
                error[-2:, part] = np.maximum(error[-2:, part], taps.gain * slope.gain * err)
                peaks[-2:, part] = np.maximum(peaks[-2:, part], sampled.brightest + err)
                for row_filter, column_filter, out in ((slope, taps, rows[-2]), (taps, slope, rows[-1])):
                    _filter_into(sampled.values, row_filter, column_filter, wanted.threads, out)
            if sampled.slopes is None:
                continue
            steepest = np.abs(sampled.slopes.values).max(axis=(2, 3))
            peaks[1:images, part] = np.maximum(peaks[1:images, part], steepest)
            err = taps.gain**2 * sampled.slopes.error * sampled.brightest
            error[1:images, part] = np.maximum(error[1:images, part], err)
            for derivative, out in zip(sampled.slopes.values, rows[1:images], strict=True):
                average_samples(derivative, _weight_rows(taps), taps.stride, wanted.threads, out, -math.inf)
    return total, error, peaks


def average_strips(
    samples: Callable[[Grid], Sequence[Pixels]], out: Array, grid: Grid, taps: Taps, threads: int = 0
) -> None:
    """Write averages over the pixels of `grid` to `out`, shape (k, n, height, width), in strips of rows.

    `samples` returns k arrays for a grid. The first is an intensity; the others may be negative.
    """
    for fine_grid, rows in _sample_strips(out, grid, taps):
        for k, values in enumerate(samples(fine_grid)):
            average_samples(values, _weight_rows(taps), taps.stride, threads, rows[k], -math.inf if k else 0.0)


def _weight_rows(taps: Taps) -> Array:
    """Return the weights in the layout of the C++ core: (1, taps), or (2, taps) for two pixels."""
    return taps.weights.reshape(-1, taps.weights.shape[-1])


def _sample_strips(out: Array, grid: Grid, taps: Taps) -> Iterator[tuple[Grid, Array]]:
    """Return pairs of a sample grid and a strip of rows of `out`, shape (..., n, height, width)."""
    return ((_strip_grid(grid, y, rows.shape[-2], taps), rows) for y, rows in _row_strips(out, taps))


def averaged_gradient(
    gradient: Callable[[P, Grid, float, Array], Array], pupil: P, grid: Grid, tol: float, weights: Array
) -> Array:
    """Return the gradient of ``sum(weights * averages)`` over pixels, weights of shape (n, height, width)."""
    # The transposed filter converts weights of pixels to weights of samples. The tolerance of samples is the first
    # one of :func:`pixel_averages`, which mostly suffices.
    err_samples, response = _first_errors(tol - (1.0 + tol) * storing(np.float64), grid.step(pupil))

    def with_spacing(spacing: float) -> Array:
        taps = averaging_filter(grid.step(pupil), response, spacing)
        gradients = []
        for part, pupils, pixels in blocks(pupil, grid, taps):
            sums: float | Array = 0.0
            for y, rows in _row_strips(weights[part], taps):
                fine_grid = _strip_grid(pixels, y, rows.shape[1], taps)
                sums += gradient(pupils, fine_grid, err_samples / taps.gain**2, spread_out(rows, taps))
            gradients.append(sums)
        return np.concatenate(gradients)

    try:
        return with_spacing(_FIRST_SPACING)
    except ToleranceError:
        return with_spacing(_RETRY_SPACING)


def _row_strips(values: Pixels, taps: Taps) -> Iterator[tuple[int, Pixels]]:
    """Yield first rows and strips of `values` (..., n, height, width), whose samples fit into memory."""
    samples_per_row = math.prod(values.shape[:-3]) * _sample_count(values.shape[-1], taps) * taps.stride / taps.pixels
    max_rows = max(1, int(_BLOCK_SAMPLES / samples_per_row))
    if max_rows >= values.shape[-2]:
        yield 0, values
        return
    for y in range(0, values.shape[-2], max_rows):
        yield y, values[..., y : y + max_rows, :]


def spread_out(weights: Array, taps: Taps) -> Array:
    """Return weights of samples (n, rows, columns), from `weights` of pixels, by the transpose of the filter."""

    def matrix(pixels: int) -> Array:
        transpose = np.zeros((_sample_count(pixels, taps), pixels))
        for pixel in range(pixels):
            transpose[pixel * taps.stride :, pixel][: taps.weights.size] = taps.weights
        return transpose

    _, height, width = weights.shape
    return np.ascontiguousarray(matrix(height) @ weights @ matrix(width).T)


def filter_axes(samples: Array, rows: Taps, columns: Taps, threads: int = 0) -> Array:
    """Return samples (n, height, width) filtered by `rows` along y and by `columns` along x, without clamping."""
    sides = ((side - rows.weights.size) // rows.stride + 1 for side in samples.shape[1:])
    out = np.empty((len(samples), *sides))
    _filter_into(samples, rows, columns, threads, out)
    return out


def _filter_into(samples: Pixels, rows: Taps, columns: Taps, threads: int, out: Array) -> None:
    # A lower limit of -inf switches off clamping to 0, which is valid for intensities only.
    average_samples(samples, _weight_rows(rows), rows.stride, threads, out, -math.inf, _weight_rows(columns))


def _sample_count(pixels: int, taps: Taps) -> int:
    return (pixels - 1) // taps.pixels * taps.stride + int(taps.weights.shape[-1])


def _strip_grid(grid: Grid, row: int, height: int, taps: Taps) -> Grid:
    """Return the grid of samples for `height` rows of pixels, from row `row` on."""
    shape = _sample_count(height, taps), _sample_count(grid.width, taps)
    return _refined_grid(grid, row, shape, taps.stride / taps.pixels, taps.margin)


@lru_cache(maxsize=64)
def _refined_grid(grid: Grid, row: int, shape: tuple[int, int], density: float, margin: int) -> Grid:
    """Return a grid with `density` samples per pixel that begins `margin` samples before the first pixel centre."""
    y, x = grid.center
    return Grid(shape, grid.side / density, center=((y - row) * density + margin, x * density + margin))


def sample_grid(grid: Grid, taps: Taps) -> Grid:
    """Return the grid of all samples for the pixels of `grid`."""
    return _strip_grid(grid, 0, grid.height, taps)


def blocks(pupil: P, grid: Grid, taps: Taps, images: int = 1) -> Iterator[tuple[slice, P, Grid]]:
    """Yield the slice, pupils and pixels of blocks of the flattened stack whose samples fit into memory."""
    count_per_block = max(1, _BLOCK_SAMPLES // (images * math.prod(_sample_count(side, taps) for side in grid.shape)))
    count = math.prod(pupil.shape)
    if count <= count_per_block:
        yield slice(0, count), pupil, grid
        return
    for start in range(0, count, count_per_block):
        part = slice(start, min(start + count_per_block, count))
        index = np.unravel_index(np.arange(part.start, part.stop), pupil.shape)
        yield part, pupil[index], grid[index] if grid.stack else grid
