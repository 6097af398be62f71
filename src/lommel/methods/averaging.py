r"""Pixel integration for any pupil: finer samples and a filter.

A pixel averages the intensity over its square, which multiplies the transfer function by ``sinc(a wx / 2)`` and
``sinc(a wy / 2)``, a the pitch in v. The transfer function vanishes beyond ``|w| = 2``, so any taps c_k on samples
h apart whose response ``C(w) = sum_k c_k cos(k h w)`` agrees with the sinc up to there do the same, along rows and
then along columns. An error eps of the response costs at most ``(2 eps + eps^2) int |OTF| dw``, an integral that is
at most the intensity at the peak without aberration, where the transfer function is nowhere negative.

Far from the axis of a circular or annular pupil averages have a closed form, and pixels need no samples.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple, TypeVar

import numpy as np

from lommel.base.arrays import Array, largest
from lommel.core.answers import Declined, Images, Pixels, Slopes, ToleranceError, Wanted, not_met
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

# Filters for adjacent pixels need not have whole samples a pixel: two pixels of pitch a may share s samples, an odd
# number, ``h = 2 a / s`` apart. The centre of one pixel is then a sample, that of the other half-way between two.

_FARTHEST = 1.27  # v between samples that two pixels share: four fifths of pi/2, where no filter is long enough
_TAP = 0.02  # cost of a weight of a pixel over that of a sample
_WORTH = 0.85  # share of samples, of those of whole numbers a pixel, below which sharing pays


P = TypeVar("P", bound=BasePupil)
Function = Callable[[Array], Array]


def fitted(response: Function, wave: Function, x: Pixels, *, in_disc: bool = False) -> tuple[Array, float, float]:
    """Return weights of samples at distances `x` on either side, the error of their response, and their gain.

    The error is the largest one or, `in_disc`, the bound on its mean, weighted by the transfer function of a disc.
    """
    # Weights by least squares at points of the band.
    w = band_points(float(x[-1]))
    # Weights are alike on both sides: every distance but 0 counts twice.
    times = np.where(x > 0.0, 2.0, 1.0)
    basis, wanted = times * wave(np.outer(w, x)), response(w)
    if in_disc:
        # Least squares in the norm that bounds the mean error: certificate, section 10.
        at, weights = transfer_rule(w.size)
        root = np.sqrt(weights)
        weighed, aim = (root * times[:, None] * wave(np.outer(x, at))).T, root * response(at)
    else:
        weighed, aim = basis, wanted
    c: Array = least_squares(np.ascontiguousarray(weighed), aim[:, None])[:, 0]
    c *= (x > 0.0) | (wave is np.cos)  # an odd response has no weight in the middle
    gain = float((times * np.abs(c)).sum())
    # In response and weights: one rounding for each of the products and sums of the taps.
    rounding = 2.0**-52 * (x.size + 3) * gain
    # A polynomial but for 1e-17 in w is at most sqrt(2) times its largest value at twice as many Chebyshev points.
    most = math.sqrt(2.0) * (float(np.abs(basis @ c - wanted).max()) + rounding) + 1e-17
    if in_disc:
        # One of the two factors of an average is off by this in the mean, the other at most by `most`.
        return c, (1.0 + 0.5 * most) * (float(np.linalg.norm(weighed @ c - aim)) + 2.0 * rounding + 1e-17), gain
    return c, most, gain


def shared(step: float, error: float, across: int, sides: tuple[int, ...], *, in_disc: bool = False) -> int:
    """Return the number of samples that two pixels share along an axis; twice `across` if sharing does not pay."""
    # Fewer samples take longer filters, and so more of them beyond the edges of a window of few pixels.

    def samples(s: int) -> float:
        taps = 2.0 * _half(step, error, s, in_disc=in_disc)
        tall, wide = (0.5 * s * side + taps for side in sides)
        return tall * wide + (_TAP * taps * sides[0] * (wide + sides[1]) if in_disc else 0.0)

    # With one sample for two pixels the other is interpolated half-way, by weights of both signs, which magnify
    # errors.
    # Rules of the mean error go to the end of the band, h = pi / 2; others need a gap.
    least = 2.0 * step / (0.5 * math.pi * (1.0 + 1e-12) if in_disc else _FARTHEST)
    counts = range(max(2, math.ceil(least)), 2 * across + 1)
    fewest = min((s for s in counts if s % 2 == 0 or 2.0 * step <= s * _FARTHEST), key=samples)
    return fewest if samples(fewest) < (1.0 if in_disc else _WORTH) * samples(2 * across) else 2 * across


def _half(step: float, error: float, s: int, *, in_disc: bool = False) -> int:
    """Estimate the number of samples on either side of a filter."""
    # Width of the gap between the band of I and its first copy (certificate, "Samples that pixels share"): the filter
    # falls from 1 to 0 within it, and its length is inversely proportional to that.
    room = 1.0 - 4.0 * step / (s * math.pi)
    if in_disc:
        # Without a gap the error falls only with a power of the length.
        far = math.log(0.1 / error) / (3.7 * room + 0.2) - 3.0 + s % 2
        return max(s // 4 + 2, int(0.25 * s + min(far, (0.045 / error) ** 0.32)))
    return max(s // 4 + 2, int(0.25 * s + math.log(0.1 / error) / (3.4 * room)) - 2)


def paired(
    response: Function, step: float, error: float, s: int, *, in_disc: bool = False
) -> tuple[Array, float, float]:
    """Return weights for two pixels that share `s` samples (odd), off by `error`, both from the first sample on."""
    h, half = 2.0 * step / s, _half(step, error, s, in_disc=in_disc)
    while True:
        even, off, gain = fitted(response, np.cos, h * np.arange(half + 1), in_disc=in_disc)
        odd, *worse = fitted(response, np.cos, h * (np.arange(half) + 0.5), in_disc=in_disc)
        off, gain = max(off, worse[0]), max(gain, worse[1])
        if (off <= error and gain <= 1.5) or half > s + 60:
            weights = np.zeros((2, 2 * half + s // 2 + 1))
            weights[0, : 2 * half + 1] = np.concatenate([even[:0:-1], even])
            weights[1, s // 2 + 1 :] = np.concatenate([odd[::-1], odd])
            return weights, off, gain
        half += 1 + half // 16 * in_disc


_VALUES = 2**23  # samples computed at once
_WIDEST, _CLOSER = 1.05, 0.8  # v between samples: two thirds and half of what the band of I allows
_MOST = 512  # samples across a pixel
_SINGLE = 2e-7  # tolerance from which samples are stored in single precision
_SHORT = 20.0  # pitch in v up to which filters are short enough for rules of the mean error
_EASIER = 64.0  # allowed mean error of a response over the allowed largest one, at a peak without aberration
_ROUGHER = 10.0  # allowed error of filters of derivatives, over that of averages
_DARK = 0.1  # share of the tolerance for sums of dark samples in single precision
_ALL = 1e30  # a limit of brightness, over the peak, that no sample exceeds

# Signature: pupils, pixels, tolerance, specification -> intensity at the pixel centres.
Sample = Callable[[P, Grid, float, Wanted], Images]
# Signature: pupils, pixels, largest v at which they may begin, tolerance, threads -> averages far from the axis.
Far = Callable[[P, Grid, float, float, int], FarPixels]

Band = tuple[float, float]


class Averages(NamedTuple):
    """Averages over pixels, for the flattened stack."""

    values: Array  # (1 + k, n, height, width): I, its derivatives by k terms, and along y and x if requested
    error: Array  # (1 + k, n), bounds over the peak; for I after storing
    peak: Array  # (n,)


def averaged(
    sample: Sample[P],
    pupil: P,
    grid: Grid,
    tol: float,
    wanted: Wanted,
    band: Band | None = None,
    *,
    gradients: bool = False,
) -> Averages:
    """Return the intensity averaged over each pixel, with bounds on its error below `tol` after storing.

    With `gradients` its derivatives by v along y and x follow, from the same samples.
    """
    # Errors are over the largest average of any pixel or, if `wanted` has no scale, that of the window, by which
    # values are divided. Derivatives by Zernike terms follow: their transfer function is at most twice that of the
    # aperture without aberration, since terms are at most 1. For light with another band (products, several
    # emitters), `band` has its bandwidth over that of the intensity, and the integral of the modulus of its transfer
    # function.
    try:
        return _averaged(sample, pupil, grid, tol, wanted, band, _WIDEST, gradients=gradients)
    except ToleranceError:
        # Filters on wider steps are longer and may reach bright light beside a dark window, to which errors relate.
        return _averaged(sample, pupil, grid, tol, wanted, band, _CLOSER, gradients=gradients)


def _averaged(
    sample: Sample[P],
    pupil: P,
    grid: Grid,
    tol: float,
    wanted: Wanted,
    band: Band | None,
    widest: float,
    *,
    gradients: bool,
) -> Averages:
    # A function of twice the bandwidth on pixels is I on pixels of twice the size.
    faster, ceiling = (1.0, pupil.amplitude**2) if band is None else band
    step, normalize = faster * grid.step(pupil), wanted.scale is None
    lowest = least_average(step)
    tol_stored = before_storing(tol, wanted)
    err_samples, err_response = _first_errors(tol_stored, step)
    in_disc = band is None and not gradients and widest == _WIDEST and step <= _SHORT and pupil.within_disc
    if in_disc:
        # A power of two, so that pupils with similar peaks share a filter.
        ceiling, err_response = (
            1.0,
            err_response * 2.0 ** math.floor(math.log2(_EASIER * ceiling * pupil.likely_strehl)),
        )
    # Five attempts: each reduces the error of the samples or of the filter by its measured excess.
    for _ in range(5):
        taps, slope = _filters(step, err_response, widest, grid.shape, gradients=gradients, in_disc=in_disc)
        tol_samples = err_samples / taps.gain**2
        err_single, dark = _dark_samples(taps, _DARK * tol_stored * lowest if tol_samples >= _SINGLE else 0.0)
        # G^2 multiplies errors of samples: certificate, section 10.
        try:
            total, err_given, peaks = _filtered(sample, pupil, grid, tol_samples, taps, wanted, dark, slope)
        except ToleranceError as fault:
            # Errors of averages are those of the samples times G^2.
            bound = math.inf if fault.bound is None else tol * fault.bound / tol_samples
            pixels = f"by averages over pixels of {step / math.pi:.3g} lambda*N in double precision"
            raise not_met(tol, bound, "the largest value in the window", pixels) from None
        tops = total[0].max(axis=(1, 2))
        rounding = (2 * taps.weights.shape[-1] + 8) * 2.0**-53 * taps.gain**2
        err_filter = (2.0 + taps.error) * taps.error * ceiling
        err_own = err_filter + (rounding + 1.01 * err_single) * peaks[0]
        # The largest average over the plane is at least `lowest` times the peak of I: section 10, "Relative to what".
        peak = tops if normalize else np.maximum(tops, lowest * peaks[0])
        if not peak.min() > 0:
            break
        relative = (err_given[0] + err_own) / peak
        bounds = stored_error(relative, wanted)
        if largest(bounds) <= tol:
            # Transfer functions of derivatives by terms are at most twice that of the aperture: section 8.
            errors = err_given + 2.0 * err_filter + rounding * peaks
            if slope is not None:
                # The response to slopes is at most 2, that of averages 1: section 12, "Shifts".
                missed = (slope.error * (1.0 + taps.error) + 2.0 * taps.error) * ceiling
                rounding = (4 * taps.weights.size + 16) * 2.0**-53 * taps.gain * slope.gain
                errors[-2:] = err_given[-2:] + missed + rounding * peaks[-2:]
            errors /= peak
            errors[0] = bounds
            return Averages(total, errors, peak)
        too_large = float((err_given[0] / peak).max()) / (0.5 * tol_stored)
        # If the filter alone is too coarse, samples stay: double precision may not reach a tolerance that is not
        # needed.
        if too_large > 1.0 and err_samples >= _SINGLE * taps.gain**2:
            # Errors in single precision are larger than in double and say little of these: begin there just below the
            # limit.
            err_samples = 0.9 * _SINGLE
        elif too_large > 1.0:
            err_samples /= too_large
        err_response *= min(1.0, 0.2 * tol_stored / float((err_own / peak).max()))
    raise not_met(tol, 1.0 if not peak.min() > 0 else float(bounds.max()), "the largest value in the window")


def _filters(
    step: float, error: float, widest: float, shape: tuple[int, int], *, gradients: bool, in_disc: bool
) -> tuple[Taps, Taps | None]:
    """Return a filter of averages off by `error`, with `gradients` also one of derivatives along an axis."""
    if gradients:
        return _with_slope(step, error, widest)
    if widest < _WIDEST:
        return filtered_by(step, error, widest), None
    return _shared_by(step, error, shape, in_disc=in_disc), None


def _dark_samples(taps: Taps, allowed: float) -> tuple[float, float]:
    """Return the error, at most `allowed`, of summing dark samples in single precision, and their largest brightness.

    Both over the peak; certificate, section 10, "Dark rows".
    """
    # 2 (n + 4) u32 G^2 d, d the largest sample in units of the peak.
    lost = 2.0 * (taps.weights.shape[-1] + 4) * 2.0**-24 * taps.gain**2
    return (lost, _ALL) if allowed > lost else (allowed, allowed / lost)


def before_storing(tol: float, wanted: Wanted) -> float:
    """Return the error that averages may have for images to be within a tolerance after storing."""
    # Values divided by their own largest one have twice the error; 0.4 leaves a reserve.
    return (0.4 if wanted.scale is None else 1.0) * (tol - (1.0 + tol) * storing(wanted.dtype))


def stored_error(off: Array, wanted: Wanted) -> Array:
    """Return the error of images after storing, from that of averages, over their peak."""
    return stored(normalized_error(off) if wanted.scale is None else off, wanted.dtype)


def _first_errors(aim: float, step: float) -> tuple[float, float]:
    """Estimate errors of samples and of a response that suffice for an error of averages."""
    # For a largest average a few times its least possible value, and a peak that is not faint.
    lowest = least_average(step)
    # Half of the tolerance for samples, some thousandths for the response, which G^2 and the peak multiply.
    return 0.5 * aim * min(4.0 * lowest, 1.0), 2e-3 * aim * lowest


_SHARE = 0.7  # of the tolerance, the error of pixels without samples if the peak is as estimated
_SPARED = 250000  # samples saved, above which pixels without samples pay


@lru_cache(maxsize=64)
def farthest(step: float, shape: tuple[int, int]) -> float:
    """Return the largest v at which pixels without samples may begin to save enough, 0 if they cannot."""
    inside = math.prod(shape) - _SPARED * (_FARTHEST / step) ** 2
    return 0.5 * step * max(0.0, min(math.sqrt(max(0.0, inside)), *shape), inside / min(shape))


def nearest(pupil: Pupil, grid: Grid, tol: float) -> float:
    """Estimate the least v at which pixels without samples begin; 0 if all pixels have samples."""
    # What averaging leaves of the rings of the unaberrated aperture, over the largest average.
    step = grid.step(pupil)
    if farthest(step, grid.shape) == 0.0:
        return 0.0
    # m_0 / r^3 of certificate, section 9, "Farther out".
    rings = 4.0 / math.pi * float(pupil.illumination.at(np.ones(()))) ** 2 * min(1.0, math.sqrt(2.0) / step)
    return math.cbrt(rings / (_SHARE * tol * min(1.0, 4.0 * math.pi * pupil.transmission / step**2)))


def _near_and_far(
    sample: Sample[P], far: Far[P], pupil: P, grid: Grid, tol: float, wanted: Wanted
) -> Averages | None:
    """Return averages with samples near the axis only, or None if that would not save time."""
    step = grid.step(pupil)
    most = farthest(step, grid.shape)
    if wanted.terms or wanted.powers or most == 0.0:
        return None
    room = before_storing(tol, wanted)
    if room <= 0.0:
        return None
    asked = _SHARE * room
    for _ in range(3):
        try:
            away = far(pupil, grid, most, asked, wanted.threads)
            inside = [
                slice(
                    max(0, math.floor((axis - away.nearest).min())),
                    min(side, math.ceil((axis + away.nearest).max()) + 1),
                )
                for axis, side in zip(away.axes.T, grid.shape, strict=True)
            ]
            shape = tuple(max(0, part.stop - part.start) for part in inside)
            if not 0 < math.prod(shape) < math.prod(grid.shape):
                return None
            center = [middle - part.start for middle, part in zip(grid.center, inside, strict=True)]
            box = Grid((shape[0], shape[1]), grid.side, center=(center[0], center[1]), integrate=True)
        except (Declined, ToleranceError):
            return None
        try:
            near = averaged(sample, pupil, box, tol, wanted)  # if this is declined, the whole window is, too
        except ToleranceError:
            return None  # the whole window may have a bound
        off = away.error / near.peak
        bounds = stored_error(off, wanted)
        if bounds.max() <= tol:
            away.values[:, inside[0], inside[1]] = near.values[0]
            # Values divided by their own largest one are at most 1, wherever that is.
            top = away.values.max(axis=(1, 2)) if wanted.scale is None else near.peak
            return Averages(away.values[None], np.maximum(near.error, bounds), np.maximum(near.peak, top))
        asked *= 0.8 * room / float(off.max())
    return None


def averaged_images(
    sample: Sample[P],
    pupil: P,
    grid: Grid,
    tol: float,
    wanted: Wanted,
    band: Band | None = None,
    far: Far[P] | None = None,
) -> Images:
    """Return images of samples or, if `grid` integrates, of :func:`averaged` pixels, some of them by `far`."""
    if not grid.integrate:
        return sample(pupil, grid, tol, wanted)
    made = None if far is None else _near_and_far(sample, far, pupil, grid, tol, wanted)
    return finished(averaged(sample, pupil, grid, tol, wanted, band) if made is None else made, wanted)


def finished(made: Averages, wanted: Wanted) -> Images:
    """Return averages as images, with their derivatives."""
    averages = made.values[0]
    scales = np.empty(len(averages))
    scales[:] = 1.0 / made.peak if wanted.scale is None else wanted.scale
    values = np.empty(averages.shape, wanted.dtype) if wanted.out is None else wanted.out
    np.multiply(averages, scales[:, None, None], out=values, casting="same_kind")
    slopes = None
    if len(made.values) > 1:
        off = made.error[1:]
        size = np.abs(made.values[1:]).max(axis=(2, 3)) / made.peak
        stored_as = (made.values[1:] * scales[:, None, None]).astype(wanted.dtype)
        slopes = Slopes(stored_as, off + (size + off) * storing(wanted.dtype))
    return Images(values, scales, made.error[0], slopes, made.peak)


class Taps(NamedTuple):
    """Filter that averages over pixels along one axis."""

    stride: int  # samples a pixel, or shared by two pixels (odd)
    weights: Array  # (2 k + 1,), from k samples before to k after the centre; for two pixels see paired()
    error: float  # bound on the error of the response for abs(w) <= 2
    gain: float  # sum of the moduli of the weights: factor of the errors of samples

    @property
    def pixels(self) -> int:
        """Number of pixels with weights of their own."""
        return 1 if self.weights.ndim == 1 else len(self.weights)

    @property
    def margin(self) -> int:
        """Number of samples before the centre of the first pixel."""
        return int(self.weights.shape[-1] - (self.pixels - 1) * (self.stride // 2)) // 2


def samples_across(step: float, widest: float = _WIDEST) -> int:
    """Return the number of samples across a pixel of pitch `step` in v, at most `widest` apart."""
    if step > _MOST * _WIDEST:
        raise Declined(
            f"pixel must be at most {_MOST * _WIDEST / math.pi:.0f} lambda*N to average a pupil that is not radially "
            f"symmetric over it, got {step / math.pi:.4g} lambda*N; take smaller pixels, and average blocks of them"
        )
    return max(1, math.ceil(step / widest))


@lru_cache(maxsize=64)
def filtered_by(step: float, error: float, widest: float = _WIDEST, *, growing: bool = False) -> Taps:
    """Return the shortest filter for pixels of pitch `step` in v, samples at most `widest` apart, off by `error`.

    If `growing`, its response is the derivative of the average by ln a: ``cos(a w / 2) - sinc(a w / 2)``.
    """

    def response(w: Array) -> Array:
        mean = _pixel(step)(w)
        return np.cos(0.5 * step * w) - mean if growing else mean

    return _fitted(response, np.cos, step, error, widest, 3.0 if growing else 1.5)


def _pixel(step: float) -> Callable[[Array], Array]:
    return lambda w: np.sinc(0.5 * step / math.pi * w)


@lru_cache(maxsize=64)
def _shared_by(step: float, error: float, shape: tuple[int, int], *, in_disc: bool = False) -> Taps:
    """Return the filter with the fewest samples for a window; two pixels may share an odd number."""
    s = shared(step, error, samples_across(step), shape, in_disc=in_disc)
    if s % 2 == 0:
        return _fitted(_pixel(step), np.cos, step, error, 2.0 * step / s * (1.0 + 1e-12), 1.5, in_disc=in_disc)
    return Taps(s, *paired(_pixel(step), step, error, s, in_disc=in_disc))


@lru_cache(maxsize=64)
def sloping(step: float, error: float, *, averages: bool, widest: float = _WIDEST) -> Taps:
    """Return the shortest filter for the derivative along an axis, of averages over pixels or of point values.

    Its response, without the factor i, is ``w sinc(a w / 2)`` or w.
    """

    def response(w: Array) -> Array:
        return w * np.sinc(0.5 * step / math.pi * w) if averages else w

    return _fitted(response, np.sin, step, error, widest, 6.0)


def _fitted(
    response: Function,
    wave: Function,
    step: float,
    error: float,
    widest: float,
    most: float,
    *,
    in_disc: bool = False,
) -> Taps:
    """Return the shortest filter for a response, cosines or sines, with a gain below `most`; else the best found."""
    stride = samples_across(step, widest)
    half, odd = _half(step, error, 2 * stride, in_disc=True) if in_disc else stride // 2 + 2, wave is np.sin
    while True:
        c, reached, gain = fitted(response, wave, step / stride * np.arange(half + 1), in_disc=in_disc)
        # Few samples beyond the edges of a large pixel would need large weights, which magnify errors.
        if (reached <= error and gain <= most) or half > stride + 60:
            # Sines are odd: weights before the centre have the opposite sign.
            return Taps(stride, np.concatenate([-c[:0:-1] if odd else c[:0:-1], c]), reached, gain)
        half += 1 + half // 16 * in_disc


@lru_cache(maxsize=64)
def _with_slope(step: float, error: float, widest: float) -> tuple[Taps, Taps]:
    """Return a filter of averages off by `error`, and one of their derivatives along an axis, of equal length."""
    # Derivatives have no tolerance of their own: their filter may be ten times as far off.
    return as_long(filtered_by(step, error, widest), sloping(step, _ROUGHER * error, averages=True, widest=widest))


def as_long(one: Taps, other: Taps) -> tuple[Taps, Taps]:
    """Return two filters padded with zeros to the same number of weights."""
    size = max(one.weights.size, other.weights.size)
    return tuple(t._replace(weights=np.pad(t.weights, (size - t.weights.size) // 2)) for t in (one, other))  # type: ignore[return-value]


def _filtered(
    sample: Sample[P],
    pupil: P,
    grid: Grid,
    tol: float,
    taps: Taps,
    wanted: Wanted,
    dark: float,
    slope: Taps | None = None,
) -> tuple[Array, Array, Array]:
    """Return averages, the errors that samples cause in them, and the largest samples, as in :class:`Averages`.

    Samples of at most `dark` times the peak are summed in single precision. Derivatives along y and x by `slope` come
    last.
    """
    count, images = math.prod(pupil.shape), 1 + len(wanted.terms) + len(wanted.powers)
    dtype = np.dtype(np.float32 if tol >= _SINGLE else np.float64)
    question = Wanted(dtype=dtype, threads=wanted.threads, terms=wanted.terms, powers=wanted.powers)
    all_ = images + (0 if slope is None else 2)
    total, error, peaks = np.empty((all_, count, *grid.shape)), np.zeros((all_, count)), np.zeros((all_, count))
    for part, one, pixels in blocks(pupil, grid, taps, images):
        for fine, rows in _strips_of(total[:, part], pixels, taps):
            # Strips bound the memory of samples; the largest error of all strips counts.
            made = sample(one, fine, tol, question)
            off = made.bound * made.brightest
            error[0, part] = np.maximum(error[0, part], taps.gain**2 * off)
            peaks[0, part] = np.maximum(peaks[0, part], made.brightest - off)
            limit = dark * float(made.brightest.min())
            average_samples(made.values, _sets(taps), taps.stride, wanted.threads, rows[0], dark=limit)
            if slope is not None:
                error[-2:, part] = np.maximum(error[-2:, part], taps.gain * slope.gain * off)
                peaks[-2:, part] = np.maximum(peaks[-2:, part], made.brightest + off)
                for down, across, out in ((slope, taps, rows[-2]), (taps, slope, rows[-1])):
                    _weigh(made.values, down, across, wanted.threads, out)
            if made.slopes is None:
                continue
            size = np.abs(made.slopes.values).max(axis=(2, 3))
            peaks[1:images, part] = np.maximum(peaks[1:images, part], size)
            off = taps.gain**2 * made.slopes.error * made.brightest
            error[1:images, part] = np.maximum(error[1:images, part], off)
            for slopes, out in zip(made.slopes.values, rows[1:images], strict=True):
                average_samples(slopes, _sets(taps), taps.stride, wanted.threads, out, -math.inf)
    return total, error, peaks


def filtered(
    samples: Callable[[Grid], Sequence[Pixels]], out: Array, grid: Grid, taps: Taps, threads: int = 0
) -> None:
    """Write averages over the pixels of `grid` to `out`, shape (k, n, height, width), in strips of rows.

    The first of the k is an intensity; the others may be negative.
    """
    for fine, rows in _strips_of(out, grid, taps):
        for k, values in enumerate(samples(fine)):
            average_samples(values, _sets(taps), taps.stride, threads, rows[k], -math.inf if k else 0.0)


def _sets(taps: Taps) -> Array:
    """Return the weights in the layout of the core: one row for each pixel with weights of its own."""
    return taps.weights.reshape(-1, taps.weights.shape[-1])


def _strips_of(out: Array, grid: Grid, taps: Taps) -> Iterator[tuple[Grid, Array]]:
    """Yield the grids of samples for strips of rows of (..., n, height, width), and the strips."""
    return ((_fine(grid, y, rows.shape[-2], taps), rows) for y, rows in _strips(out, taps))


def averaged_gradient(
    gradient: Callable[[P, Grid, float, Array], Array], pupil: P, grid: Grid, tol: float, weights: Array
) -> Array:
    """Return the gradient of the sum over pixels of `weights`, (n, height, width), times averages."""
    # By the transpose of the filter: `gradient` gets a grid of samples with their weights, and the tolerance with
    # which :func:`averaged` begins (and mostly ends).
    finer, response = _first_errors(tol - (1.0 + tol) * storing(np.float64), grid.step(pupil))

    def by(widest: float) -> Array:
        taps = filtered_by(grid.step(pupil), response, widest)
        found = []
        for part, one, pixels in blocks(pupil, grid, taps):
            sums: float | Array = 0.0
            for y, rows in _strips(weights[part], taps):
                sums += gradient(
                    one, _fine(pixels, y, rows.shape[1], taps), finer / taps.gain**2, spread_out(rows, taps)
                )
            found.append(sums)
        return np.concatenate(found)

    try:
        return by(_WIDEST)
    except ToleranceError:
        return by(_CLOSER)


def _strips(values: Pixels, taps: Taps) -> Iterator[tuple[int, Pixels]]:
    """Yield the first row and the rows of strips of (..., n, height, width) that are filtered at once."""
    each = math.prod(values.shape[:-3]) * _samples(values.shape[-1], taps) * taps.stride / taps.pixels
    most = max(1, int(_VALUES / each))
    if most >= values.shape[-2]:
        yield 0, values
        return
    for y in range(0, values.shape[-2], most):
        yield y, values[..., y : y + most, :]


def spread_out(weights: Array, taps: Taps) -> Array:
    """Return the weights of samples in weighted sums of averages, shape (n, samples, samples)."""

    def matrix(pixels: int) -> Array:
        made = np.zeros((_samples(pixels, taps), pixels))
        for pixel in range(pixels):
            # The transpose of the filter along one axis.
            made[pixel * taps.stride :, pixel][: taps.weights.size] = taps.weights
        return made

    _, height, width = weights.shape
    return np.ascontiguousarray(matrix(height) @ weights @ matrix(width).T)


def weighed(samples: Array, rows: Taps, columns: Taps, threads: int = 0) -> Array:
    """Return sums of samples, shape (n, h, w), by one filter along each axis, of any sign."""
    sides = ((side - rows.weights.size) // rows.stride + 1 for side in samples.shape[1:])
    out = np.empty((len(samples), *sides))
    _weigh(samples, rows, columns, threads, out)
    return out


def _weigh(samples: Pixels, rows: Taps, columns: Taps, threads: int, out: Array) -> None:
    # No clamping at 0, as for averages of an intensity: minus infinity is the least value.
    average_samples(samples, _sets(rows), rows.stride, threads, out, -math.inf, _sets(columns))


def _samples(pixels: int, taps: Taps) -> int:
    return (pixels - 1) // taps.pixels * taps.stride + int(taps.weights.shape[-1])


def _fine(grid: Grid, row: int, height: int, taps: Taps) -> Grid:
    """Return the grid of samples for some rows of pixels."""
    return _spaced(
        grid, row, (_samples(height, taps), _samples(grid.width, taps)), taps.stride / taps.pixels, taps.margin
    )


@lru_cache(maxsize=64)
def _spaced(grid: Grid, row: int, shape: tuple[int, int], across: float, margin: int) -> Grid:
    """Return a grid of samples, `across` a pixel along either axis, from `margin` before the centre of a pixel."""
    y, x = grid.center
    return Grid(shape, grid.side / across, center=((y - row) * across + margin, x * across + margin))


def finer(grid: Grid, taps: Taps) -> Grid:
    """Return the grid of all samples for the pixels of `grid`."""
    return _fine(grid, 0, grid.height, taps)


def blocks(pupil: P, grid: Grid, taps: Taps, images: int = 1) -> Iterator[tuple[slice, P, Grid]]:
    """Yield parts of a stack that are sampled at once: their slice of the flattened stack, pupils and pixels."""
    size = max(1, _VALUES // (images * math.prod(_samples(side, taps) for side in grid.shape)))
    count = math.prod(pupil.shape)
    if count <= size:
        yield slice(0, count), pupil, grid
        return
    for first in range(0, count, size):
        part = slice(first, min(first + size, count))
        which = np.unravel_index(np.arange(part.start, part.stop), pupil.shape)
        yield part, pupil[which], grid[which] if grid.stack else grid
