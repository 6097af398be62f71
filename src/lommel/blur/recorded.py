"""Blurred, pixel-integrated images by any method, from samples whose number follows from the tolerance."""

from __future__ import annotations

import math
from contextlib import suppress
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from lommel.base.arrays import Array, Values, largest
from lommel.blur.blurs import Blur, Seeing, require_unit
from lommel.blur.convolution import Gate, Halo, Readout, Short, Spread, ends, readout, spread
from lommel.blur.transfer_integral import FURTHER, Fading, TransferIntegral
from lommel.core.answers import Declined, DType, Samples, ToleranceError, Wanted, not_met
from lommel.core.engine import product
from lommel.methods.choice import candidates, first_within_tolerance
from lommel.methods.method import Method, normalized_error, stored, storing, with_model_error
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.methods.polychromatic import Polychromatic
from lommel.methods.question import output_spec, place
from lommel.optics.aperture.shapes import Segments
from lommel.optics.base_pupil import BasePupil
from lommel.optics.colour.spectrum import Component
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront

# v and w are as in lommel.blur.convolution. The spectrum of the intensity ends at ``abs(w) = 2`` (the band), and
# ``int abs(OTF) dw`` is at most the unaberrated peak: an error e of a response in the band causes errors of at most e
# times this peak (as in methods/averaging.py). Weights multiply errors of samples by at most their absolute sum.
#
# The share s of the band: blur is negligible for ``abs(w) > 2 s``. Blur is then computed in the unit v / s, in which
# it ends at 2, on a coarse lattice. Samples of the intensity are finer, because their frequencies above 2 s must not
# alias into the frequencies of the blur (docs/certificate.md, section 17). They are gathered (low-pass filtered and
# resampled) on the coarse lattice. Gate, readout, halo and lattice: see lommel.blur.convolution.

STEP = 0.8
"""Step of the coarse lattice, in the unit v / s."""
_WORTH = 0.8  # share of the band above which a coarser lattice saves no time
_COARSEST = 1e-4  # largest error of a gate, relative to the largest possible light in the band
_MAX_SIDE = 6144  # largest number of samples along an axis
_AT_ONCE = 2**24  # largest number of samples of a block of pupils
_MAX_CACHED = 2**21  # largest number of samples of a pupil that is cached for other blur
_MAX_LATTICES = 4  # largest number of cached lattices of a pupil


class Request(NamedTuple):
    """Parameters of a computation. If `shared`, lattices are rounded to finer and wider ones, which are cached."""

    method: Method | None
    threads: int
    tol: float  # tolerance of the samples, relative to their peak
    error: float  # error of the responses, relative to the unaberrated peak
    margin: float  # margin of the lattice around the pixels for seeing, in v
    shared: bool = True


class BlurredStack(NamedTuple):
    """Images of the flattened stack, and the parts of their absolute error bounds, each of shape (n,)."""

    values: Array
    sample_error: Array  # part due to errors of the samples; NaN where the method has no bound
    response: Array  # part due to errors of the responses and rounding
    missing: Array  # part due to light outside the lattice, which seeing would spread into the image
    method: Method


def summed(request: Request, pupil: BasePupil, grid: Grid, blurs: tuple[Blur, ...]) -> BlurredStack:
    """Return images summed over the wavelengths of a spectrum; each wavelength is blurred by its own seeing."""
    method = request.method
    if not isinstance(method, Polychromatic):
        return _stack_images(request, Component(1.0, 1.0, pupil), grid, blurs)
    parts = method.components(pupil)
    # Seeing depends on the wavelength: blur before the sum over wavelengths.
    images = [_stack_images(request._replace(method=method.method), part, grid, blurs)[:4] for part in parts]
    weighted = ([part.weight * value for value in values] for part, values in zip(parts, images, strict=True))
    return BlurredStack._make([*(np.sum(components, axis=0) for components in zip(*weighted, strict=True)), method])


class Band(NamedTuple):
    """Share s of the band in which the blur is not negligible, and bounds on integrals of absolute spectra.

    The integrals are in units in which the integral over the spectrum of an unaberrated image is its peak.
    """

    share: float
    tail: float  # integral of OTF times T outside the share
    clear: float  # integral of the OTF, without blur, inside the share
    blurred: float  # integral of OTF times T

    @property
    def ended(self) -> bool:
        """Whether blur ends within the band of the intensity."""
        return self.share < 1.0

    @classmethod
    def of(cls, pupil: BasePupil, blurs: tuple[Blur, ...], error: float, *, shared: bool = True) -> Band:
        """Return the share outside which the spectrum sums to `error` of the peak or less; rounded if `shared`."""
        transfer, light = Fading.above(blurs, pupil.scale, pupil.wavelength), pupil.transmission
        # abs(O) <= pi tau bounds the tail by 8 tau int T f df: certificate, section 17, "Blur that ends early".
        share, tail = transfer.end(error * pupil.amplitude**2 / (8.0 * light), FURTHER)
        if shared:  # rounded to eighths of octaves: blurs of similar width have equal lattices
            share = 2.0 ** (math.ceil(8.0 * math.log2(share)) / 8.0)
        if share > _WORTH:
            share, tail = 1.0, 0.0
        return cls(share, 8.0 * light * tail, 4.0 * light * share**2, 8.0 * light * transfer.light)


def _stack_images(request: Request, part: Component, grid: Grid, blurs: tuple[Blur, ...]) -> BlurredStack:
    """Return images of a stack at one wavelength; pupils with one common axis share a lattice."""
    pupil = part.pupil
    if grid.stack:
        images = [
            _stack_images(request, part._replace(pupil=pupil[index]), grid[index], blurs)
            for index in np.ndindex(grid.stack)
        ]
        return _join(images)
    band, peak = Band.of(pupil, blurs, request.error, shared=request.shared), pupil.amplitude**2
    # In the unit v / share every blur ends at abs(w) = 2: gate and step do not depend on the blur.
    scale = pupil.scale / band.share
    # A narrow band contains less light: a gate with a larger relative error has the same effect on the image.
    error = max(request.error, min(request.error * peak / band.clear, _COARSEST))
    gate = Gate.of(STEP, 2.0 ** math.floor(math.log2(error)) if request.shared else error)
    rows, columns = (
        readout(tuple(math.pi / scale * places), math.pi / scale * active, gate)
        for places, active in zip((grid.y, grid.x), grid.active, strict=True)
    )
    halo = Halo.of(blurs, scale, pupil.wavelength, gate)
    lattice = Lattice.of(request, band, Short.of(blurs, scale), halo, (rows, columns))
    reach = max(max(-first, first + n - 1) for first, n in zip(lattice.first, lattice.counts, strict=True))
    half_side = reach * lattice.h / (math.pi * band.share)
    if halo.several and half_side > 0.5 * pupil.period:
        # Repeated images would add light to the lattice, which the bounds do not include.
        raise ToleranceError(
            f"the mask repeats the image every {pupil.period:g} lambda*N, but this seeing and tolerance need "
            f"{2.0 * half_side:.4g} lambda*N or more: use a finer mask, or one with squares=True"
        )
    blocks = _blocks(pupil, math.prod(lattice.counts))
    return _join([_block_images(request, block, band, lattice, (rows, columns)) for block in blocks])


def _join(parts: list[BlurredStack]) -> BlurredStack:
    """Concatenate the images of parts of a stack."""
    components = zip(*(part[:4] for part in parts), strict=True)
    return BlurredStack._make([*(np.concatenate(values) for values in components), parts[0].method])


class Gather(NamedTuple):
    """Weights, shape (samples, coarse samples), that resample one axis to a coarser lattice."""

    matrix: Any  # None if the lattices are equal
    first: int  # index of the first coarse sample
    error: float  # error of the response to waves in the band
    gain: float  # gain of the readout that resamples: largest sum of absolute weights
    sums: float  # largest sum of absolute weights of a coarse sample, times h / (coarse step)

    @classmethod
    def of(cls, h: float, first: int, count: int, gate: Gate) -> Gather:
        """Return the weights of `count` samples, `h` apart."""
        if h == gate.h:
            return cls(None, first, 0.0, 1.0, 1.0)
        resampler = readout(tuple(h * (first + np.arange(float(count)))), 0.0, gate)
        matrix = resampler.matrix.toarray()
        sums = h / gate.h * float(np.abs(matrix).sum(axis=0).max())
        return cls(matrix, resampler.first, resampler.error, resampler.gain, sums)


class Lattice(NamedTuple):
    """Lattice of samples (rows, columns), the gathering, and the kernel that blurs gathered samples."""

    step: float  # step of the samples, in v
    h: float  # step of the samples, in the unit v / share
    first: tuple[int, int]  # index of the first sample; sample 0 is on the axis
    counts: tuple[int, int]
    gathers: tuple[Gather, Gather]
    outside_sum: float  # bound on the sum of absolute weights for samples outside the lattice
    gate: Gate
    kernel: Spread | None

    @classmethod
    def of(cls, request: Request, band: Band, short: Short, halo: Halo, pixels: tuple[Readout, Readout]) -> Lattice:
        """Return the lattice for pixels (rows, columns) to the requested errors."""
        gate, margin = halo.gate, request.margin * band.share
        sharp, seeing = short.nothing and not halo.several, bool(halo.several)
        # The step is such that aliases of the band begin where the blur ends, with `shared` at the next sixteenth.
        ended = math.ceil(16.0 * band.share) / 16.0 if request.shared else band.share
        step = min(gate.h / band.share, math.pi / (1.0 + ended))
        # If the steps are equal within rounding, samples are not gathered.
        h = gate.h if step * band.share >= gate.h * (1.0 - 1e-15) else step * band.share
        truncation, cut_sum = ends(gate)
        starts, counts, padded, gathers = [], [], [], []
        for side, reach in zip(pixels, short.reach(gate.error)[::-1], strict=True):
            extra_samples = 0 if sharp else math.ceil((reach + (0.0 if short.nothing else truncation)) / gate.h)
            first, last = side.first - extra_samples, side.first + side.samples - 1 + extra_samples
            # Readout and gathering each need samples up to the truncation distance of the gate.
            extra = 0.0 if h == gate.h else truncation
            left, right = first * gate.h - extra, last * gate.h + extra
            if seeing and band.ended:
                # The lattice extends by the margin beyond the pixels, and holds at least the samples of the readout.
                least_of, most_of = side.ends(reach)
                left = min(least_of - margin, side.first * gate.h + extra)
                right = max(most_of + margin, (side.first + side.samples - 1) * gate.h - extra)
            elif seeing:
                left, right = min(left, 0.0) - margin, max(right, 0.0) + margin
            low, high = math.floor(left / h), math.ceil(right / h)
            # Samples on a lattice symmetric about the axis take a quarter of the time.
            if 2 * max(-low, high) + 1 <= 1.2 * (high - low + 1):
                high = max(-low, high) if not request.shared else _round_up(max(-low, high))
                low = -high
            starts.append(low)
            counts.append(high - low + 1)
            if max(counts) > _MAX_SIDE:
                break
            gathers.append(gather := Gather.of(h, low, counts[-1], gate))
            places = counts[-1] if gather.matrix is None else gather.matrix.shape[1]
            # The padded side exceeds all differences of positions: no light wraps around to a sample that is used.
            padded.append(2 * max(last - gather.first, gather.first + places - 1 - first) + 2 if seeing else places)
        if max(counts) > _MAX_SIDE:
            raise ToleranceError(
                f"this image takes a lattice of {max(counts)} samples a side, more than {_MAX_SIDE}, to reach the "
                "tolerance: choose a larger tol, or a smaller window"
            )
        kernel = None if sharp else spread(short, halo, (padded[0], padded[1]), margin, ended=band.ended)
        outside = 0.0 if seeing or h == gate.h else 2.0 * cut_sum * max(axis.sums for axis in gathers)
        return cls(
            step, h, (starts[0], starts[1]), (counts[0], counts[1]), (gathers[0], gathers[1]), outside, gate, kernel
        )

    def gather(self, samples: Array, threads: int) -> Array:
        """Return a stack of samples, gathered on the coarse lattice."""
        row_matrix, column_matrix = (gather.matrix for gather in self.gathers)
        if row_matrix is None:
            return samples
        # Products by the compiled core: the threads of BLAS would spend half of the time waiting.
        # The factor (h / coarse step)^2 conserves densities.
        transposed = (self.h / self.gate.h) ** 2 * row_matrix.T
        return np.stack([product(product(transposed, image, threads), column_matrix, threads) for image in samples])


def _round_up(count: int) -> int:
    """Return `count` rounded up to five significant bits: lattices of similar size become equal."""
    unit = 1 << max(0, count.bit_length() - 5)
    return -(-count // unit) * unit


def _blocks(pupil: BasePupil, samples: int) -> list[BasePupil]:
    """Return parts of the flattened stack, each with at most `_AT_ONCE` samples."""
    count, size = math.prod(pupil.shape), max(1, _AT_ONCE // samples)
    if count <= size:
        return [pupil]
    starts = range(0, count, size)
    return [pupil[np.unravel_index(np.arange(s, min(s + size, count)), pupil.shape)] for s in starts]


def _block_images(
    request: Request, pupil: BasePupil, band: Band, lattice: Lattice, pixels: tuple[Readout, Readout]
) -> BlurredStack:
    """Return images of a block of pupils from one lattice, with the error budget of certificate, section 17."""
    (rows, columns), (down, across), kernel = pixels, lattice.gathers, lattice.kernel
    method, samples, sample_error = _on_lattice(request, pupil, lattice)
    peak, total_light = pupil.amplitude**2, 4.0 * math.pi * pupil.transmission * band.share**2
    gain, missing = rows.gain * columns.gain, np.zeros(len(samples))
    # `by_light`: if seeing ends within the band, errors are bounded by the light of the samples, not by the peak.
    by_light = kernel is not None and kernel.core > 0.0 and band.ended
    unblurred, blurred = (band.clear, band.blurred) if by_light else (min(band.clear, peak), min(band.blurred, peak))
    # (1 + a)(1 + b) - 1 of the responses along rows and columns.
    response = (rows.error + columns.error + rows.error * columns.error) * blurred
    if kernel is not None:
        gather, gathering = down.gain * across.gain, down.error + across.error + down.error * across.error
        spreading = kernel.error * unblurred + gathering * (band.blurred + kernel.error * band.clear)
        most = total_light * kernel.core * gather if by_light else peak * down.sums * across.sums
        spreading += most * (kernel.outside_sum + 2.0**-53 * sum(lattice.counts) * max(1.0, kernel.gain))
        # Without seeing, each sample outside the lattice is at most the unaberrated peak.
        spreading += peak * lattice.outside_sum * kernel.gain
        response += gain * (spreading + total_light * gather * kernel.off) + band.tail * (1.0 + gain * gather)
    rounding = 0.0
    if kernel is not None:
        coarse = lattice.gather(samples, request.threads)
        rounding = gain * kernel.rounding(coarse)
        area = lattice.h**2 * samples[0].size
        # Parseval: h^2 times the sum over the whole plane is the total light, 4 pi tau. Light outside the lattice is
        # the total minus the sum of the samples.
        light_inside = lattice.h**2 * samples.sum(axis=(1, 2)) - area * np.nan_to_num(sample_error)
        missing = kernel.missing * np.clip(total_light - light_inside, 0.0, total_light)
        if by_light:
            # The kernel is not negative and sums to 1: its gain is 1, except for errors of the weights.
            gain = 1.0 + 2.0 * area * response / total_light
        else:
            missing *= gain
            gain *= kernel.gain * down.sums * across.sums
        samples = kernel.on(coarse, request.threads)
    top, left = rows.first - down.first, columns.first - across.first
    part = samples[:, top : top + rows.samples, left : left + columns.samples]
    values = np.stack([(columns.matrix @ (rows.matrix @ image).T).T for image in part])
    error = np.full(len(values), 1.0001 * response + rounding)
    return BlurredStack(values, gain * sample_error, error, missing, method)


class CachedLattice(NamedTuple):
    """Cached samples of a pupil on a lattice, for other blur and other wavelengths."""

    first: tuple[int, int]
    tol: float
    method: Method
    samples: Array
    errors: Array  # bounds on the absolute errors of the samples, or NaN

    def part(self, first: tuple[int, int], counts: tuple[int, int]) -> Array | None:
        """Return the samples of a smaller lattice; None if this lattice does not contain it."""
        low = [requested - stored for requested, stored in zip(first, self.first, strict=True)]
        high = [start + count for start, count in zip(low, counts, strict=True)]
        if min(low) < 0 or high[0] > self.samples.shape[1] or high[1] > self.samples.shape[2]:
            return None
        return self.samples[:, low[0] : high[0], low[1] : high[1]]


@lru_cache(maxsize=2)
def _cached_lattices(_aperture: tuple[object, ...], _wavefront: Wavefront) -> dict[float, CachedLattice]:
    """Return the cached samples for an aperture and a wavefront, by the step of their lattice."""
    # `lru_cache` returns one dictionary for equal arguments; callers add samples to it.
    return {}


def _on_lattice(request: Request, pupil: BasePupil, lattice: Lattice) -> tuple[Method, Array, Array]:
    """Return the method, samples of a stack on a lattice, cached if possible, and their error bounds or NaN."""
    first, counts = lattice.first, lattice.counts
    grid = Grid(counts, lattice.step * pupil.scale / math.pi, center=(-first[0], -first[1]))
    if not request.shared or request.method or not isinstance(pupil, Pupil) or pupil.circular or pupil.shape:
        return _sampled(request, pupil, grid)
    # Tolerances are rounded down to half decades: other blur of similar width can use the cached samples.
    request = request._replace(tol=10.0 ** (0.5 * math.floor(2.0 * math.log10(request.tol))))
    lattices = _cached_lattices(pupil.aperture, pupil.wavefront)
    cached = lattices.get(lattice.step)
    if cached is not None and cached.tol <= request.tol and (part := cached.part(first, counts)) is not None:
        return cached.method, part, cached.errors
    result = _sampled(request, pupil, grid)
    if result[1].size > _MAX_CACHED:
        return result
    # The oldest lattices go first: dictionaries keep the order of insertion.
    for step in list(lattices)[: max(0, len(lattices) - _MAX_LATTICES + 1)]:
        lattices.pop(step, None)
    lattices[lattice.step] = CachedLattice(first, request.tol, *result)
    return result


def _sampled(request: Request, pupil: BasePupil, grid: Grid) -> tuple[Method, Array, Array]:
    """Compute the samples of a stack on a lattice; return the method, the samples and their error bounds or NaN."""
    if request.method is not None:
        methods: tuple[Method, ...] = (request.method.tightened(max(request.tol, request.method.least_tol)),)
        # A method chosen by the user keeps its own tolerance if it is tighter than needed.
        if request.tol > request.method.tol:
            methods = (request.method,)
    else:
        least = 1e-11 if not pupil.circular else Method.least_tol
        methods = candidates(pupil, grid, min(max(request.tol, least), 0.05))
    methods[0].require(pupil)
    grid.require_reach(pupil)

    def compute(method: Method) -> Samples:
        images = method.intensity(pupil, grid, request.threads)
        values, scales = images.values, np.ones(len(images.values))
        if values.ndim == 2:
            values = np.empty((len(scales), *grid.shape))
            grid.paint(images.values, scales, values)
        peak = images.values.reshape(len(scales), -1).max(axis=1) if images.peak is None else images.peak
        return with_model_error(Samples(values, scales, images.error, None, peak), pupil, method, normalized=False)

    method, images = first_within_tolerance(methods, compute)
    assert images.peak is not None
    return (
        method.reported,
        images.values,
        np.full(len(images.values), np.nan) if images.error is None else images.error * images.peak,
    )


_TRIES = 7  # largest number of computations with tightened requests


def of_transfer(request: Request, tol: float, pupil: BasePupil, grid: Grid, blurs: tuple[Blur, ...]) -> Method | None:
    """Return the quadrature over transfer functions; None if it does not apply, or takes longer than a lattice."""
    method = request.method
    white = method if isinstance(method, Polychromatic) else None
    monochromatic = method if white is None else white.method
    if not (monochromatic is None or isinstance(monochromatic, NijboerZernike)) or not (blurs and grid.square):
        return None
    if Fading.of(blurs, pupil.scale, pupil.wavelength) is None:
        return None
    quadrature, seconds = TransferIntegral(tol, blurs), 0.0
    for _, _, part in white.components(pupil) if white else [Component(1.0, 1.0, pupil)]:
        if not (isinstance(part, Pupil) and part.radial):
            return None
        seconds += max(1, math.prod(grid.stack)) * quadrature.seconds(part, grid)
        if seconds > _lattice_seconds(request, part, grid, blurs):
            return None
    return quadrature if white is None else Polychromatic(white.wavelengths, white.weights, quadrature)


def _lattice_seconds(request: Request, pupil: BasePupil, grid: Grid, blurs: tuple[Blur, ...]) -> float:
    """Return the estimated time, in seconds, of images from a lattice of samples."""
    share = Band.of(pupil, blurs, request.error).share
    h = min(STEP / share, math.pi / (1.0 + share))
    margin = request.margin or max(Short.of(blurs, pupil.scale).reach(1e-9)) + 30.0 / share
    samples = (2.0 * (grid.reach(pupil) / math.sqrt(2.0) + margin) / h) ** 2
    pixels = 4e-6 * max(grid.shape) ** 2 if grid.integrate else 0.0
    return 4e-3 + pixels + 4e-8 * samples * math.prod(pupil.shape)


def transferred(method: Method, pupil: BasePupil, grid: Grid, wanted: Wanted) -> Samples:
    """Return images of a stack by quadrature over transfer functions; each pupil may have its own axis."""
    if not grid.stack:
        return method.images(pupil, grid, wanted)
    values = np.empty((math.prod(grid.stack), *grid.shape), wanted.dtype) if wanted.out is None else wanted.out
    scales, errors = np.empty(len(values)), np.empty(len(values))
    for k, index in enumerate(np.ndindex(grid.stack)):
        scale = wanted.scale
        request = wanted._replace(
            out=values[k : k + 1],
            scale=scale if scale is None or np.ndim(scale) == 0 else np.asarray(scale)[k : k + 1],
        )
        images = method.images(pupil[index], grid[index], request)
        scales[k], errors[k] = images.scale[0], images.bound[0]
    return Samples(values, scales, errors)


def recorded_images(
    method: Method | None, tol: float, pupil: BasePupil, grid: Grid, blurs: tuple[Blur, ...], wanted: Wanted
) -> tuple[Method, Samples]:
    """Return the method of the samples, and the blurred images of a stack with errors below `tol` of the peak."""
    if method is not None and method.sampling == "pixel":
        raise ValueError(
            f"method must compute point values for blur, fill and pixels that are not square, got "
            f"{type(method).__name__}, which does not; leave method= out"
        )
    dtype, own_peak = wanted.dtype, wanted.scale is None
    # Half of tol if values are divided by their own maximum, whose error adds; 10 % are a reserve.
    aim = (0.45 if own_peak else 0.9) * (tol - 1.1 * storing(dtype))
    request = _first_request(method, pupil, grid, blurs, aim, wanted.threads)
    quadrature = of_transfer(request, tol, pupil, grid, blurs)
    if quadrature is not None:
        # If the quadrature declines or misses the tolerance, the lattice is used.
        with suppress(ToleranceError, Declined):
            return quadrature, transferred(quadrature, pupil, grid, wanted)
    axis_level, at_limit = 0.0 if own_peak else _axis_level(request, pupil, grid, blurs), False
    for tries in range(_TRIES):
        try:
            images = summed(request, pupil, grid, blurs)
        except (ValueError, ToleranceError) as failure:
            # Shared lattices are larger than necessary: try the smallest lattice before reporting an error.
            if request.shared:
                request = request._replace(shared=False)
                continue
            # Samples are a small part of the error: those of the least error in reach may be accurate enough.
            reached = getattr(failure, "bound", None) or 0.0
            if not at_limit and request.tol < reached < 3.0 * request.tol:
                request, at_limit = request._replace(tol=1.2 * reached), True
                continue
            if method is None:
                _refuse_seeing(request, tol, pupil, blurs, failure)
            raise
        maxima = np.maximum(images.values.max(axis=(1, 2)), axis_level)
        if not maxima.min() > 0:
            raise ValueError("the light in the window is below its error bound; use a window nearer to the image")
        # If the samples have no error bound, only the errors added by blur are kept below the tolerance.
        unbounded = bool(np.isnan(images.sample_error).any())
        relative = ((0.0 if unbounded else images.sample_error) + images.response + images.missing) / maxima
        # The exact peak is at least peak - e: relative error e / (peak - e); no bound if e / peak is 1/2 or more.
        relative = np.where(relative < 0.5, relative / (1.0 - np.minimum(relative, 0.5)), np.inf)
        bounds = stored(normalized_error(relative) if own_peak else relative, dtype)
        if bounds.max() <= tol or (method is not None and not method.keeps_tol and not unbounded):
            return images.method, _scaled(images, wanted, None if unbounded else bounds)
        request = _refined_request(request, images, aim * maxima)._replace(shared=request.shared and tries == 0)
    raise not_met(tol, float(bounds.max()), "the largest value in the window")


def _refuse_seeing(request: Request, tol: float, pupil: BasePupil, blurs: tuple[Blur, ...], fault: Exception) -> None:
    """Raise ToleranceError if seeing (D / r0, width in lambda*N) needs samples too far beyond the window."""
    seeings = (blur for blur in blurs if isinstance(blur, Seeing))
    ratio = max((1.0 / (seeing.coherence(pupil.wavelength) * pupil.scale) for seeing in seeings), default=0.0)
    if ratio and not math.isfinite(pupil.period):
        raise ToleranceError(
            f"seeing of D / r0 = {ratio:.3g} to tol={tol:g} takes samples of the PSF without seeing up to "
            f"{request.margin / math.pi:.0f} lambda*N outside the window, too far for this aperture. Choose a larger "
            "tol, up to 0.01, or a pupil with only an obscuration: in strong seeing its image is nearly equal"
        ) from fault


def _scaled(images: BlurredStack, wanted: Wanted, bounds: Array | None) -> Samples:
    """Return images divided by their largest values, or multiplied by the requested scale."""
    maxima = images.values.max(axis=(1, 2))
    scales = 1.0 / maxima if wanted.scale is None else np.broadcast_to(np.asarray(wanted.scale), maxima.shape)
    values = np.empty(images.values.shape, wanted.dtype) if wanted.out is None else wanted.out
    # Clamp to 0: averages of an intensity are not negative, and clamping does not increase the error.
    np.multiply(np.maximum(images.values, 0.0), scales[:, None, None], out=values, casting="same_kind")
    return Samples(values, scales, bounds)


def _axis_level(request: Request, pupil: BasePupil, grid: Grid, blurs: tuple[Blur, ...]) -> float | Array:
    """Return a lower bound on the brightest pixel near the axis; errors of off-axis windows are relative to it."""
    rows, columns = np.broadcast_arrays(*grid.center)
    if np.all((rows > -0.5) & (rows < grid.height - 0.5) & (columns > -0.5) & (columns < grid.width - 0.5)):
        return 0.0
    # Three pixels hold the peak of any centred blur; coarse tolerances suffice for a lower bound.
    small = Grid(3, grid.pixel, integrate=grid.integrate, fill=grid.fill)
    images = summed(request._replace(tol=max(request.tol, 1e-6), error=max(request.error, 1e-9)), pupil, small, blurs)
    error = images.response + images.missing + np.nan_to_num(images.sample_error)
    return np.asarray(np.maximum(images.values.max(axis=(1, 2)) - error, 0.0))


def _first_request(
    method: Method | None, pupil: BasePupil, grid: Grid, blurs: tuple[Blur, ...], aim: float, threads: int
) -> Request:
    """Return the first request, estimated from the widths of diffraction, blur and pixels; `aim`: target error."""
    to_v = math.pi / pupil.scale
    short = Short.of(blurs, pupil.scale)
    halo = Halo.of(blurs, pupil.scale, pupil.wavelength, Gate.of(STEP, 1e-6))
    # `spot`: area of a uniform spot with the light and the peak of the PSF. Squared widths of independent blurs add.
    spot = 4.0 * math.pi * pupil.transmission / pupil.likely_peak
    sides = 2.0 * math.pi * np.diag(short.covariance) + (short.streaks**2).sum(axis=0)
    sides = sides + np.array([(to_v * a) ** 2 for a in grid.active[::-1]])
    area = math.sqrt(float(np.prod(spot + sides)))
    # The area of the halo is 1 / (kernel at 0).
    if halo.several:
        area += 1.0 / float(halo.at(np.zeros(1))[0])
    # With seeing, most of the tolerance is left for light outside the lattice, which is the most costly to reduce.
    sample_part, response_part = (0.12, 0.009) if halo.several else (0.3, 0.02)
    tol = max(sample_part * aim * spot / area, 1e-13)  # relative to the peak of the samples
    peak = 4.0 * math.pi * pupil.transmission / area
    error = max(response_part * aim * peak / pupil.amplitude**2, 1e-15)
    request = Request(method, threads, tol, error, 0.0)
    if not halo.several:
        return request
    half_side = to_v * 0.5 * min(side * pitch for side, pitch in zip(grid.shape, grid.pitch, strict=True))
    # If seeing does not end within the band, its kernel is convolved with the gate and is wider.
    gate_margin = 0.0 if Band.of(pupil, blurs, error).ended else 60.0
    blur = float(pupil.v(pupil.geometric_radius()).max())
    return request._replace(margin=blur + gate_margin + _margin(halo, half_side, _edges(pupil), 0.5 * aim / area))


def _edges(pupil: BasePupil) -> float:
    """Return an estimate of (length of the edges of an aperture) / (circumference of a disc of equal area)."""
    # Light far from the axis falls like r^-3 and is proportional to the length of the edges.
    if not isinstance(pupil, Pupil) or pupil.circular:
        return 1.0 / (1.0 - getattr(pupil, "obscuration", 0.0))
    return 6.0 if isinstance(pupil.stop, Segments) else 2.0


def _margin(halo: Halo, half_side: float, edges: float, allowed: float) -> float:
    """Return an estimate of the margin (v) around a window of half side `half_side` for an error of `allowed`."""
    # Encircled energy of a disc at large R: 1 - 2 / (pi R) (Rayleigh).
    margins = np.geomspace(5.0, 1e5, 400)
    missing = np.minimum(edges * 2.0 / (math.pi * (half_side + margins)), 1.0)
    low, high = 0, margins.size - 1
    # Bisection: both factors decrease with the margin.
    while high - low > 1:
        middle = (low + high) // 2
        enough = missing[middle] * halo.bound(float(margins[middle])) <= allowed
        low, high = (low, middle) if enough else (middle, high)
    return float(margins[high])


def _refined_request(request: Request, images: BlurredStack, allowed: Array) -> Request:
    """Return the next request, with the parameters of those errors reduced that exceed their part of `allowed`."""
    tol, error, margin = request.tol, request.error, request.margin
    sample_error = np.zeros(len(allowed)) if np.isnan(images.sample_error).any() else images.sample_error
    if (excess := float((sample_error / (0.4 * allowed)).max())) > 1.0:
        tol *= max(0.5 / excess, 1e-4)
    if (excess := float((images.response / (0.2 * allowed)).max())) > 1.0:
        error *= max(0.5 / excess, 1e-6)
    if (excess := float((images.missing / (0.5 * allowed)).max())) > 1.0:
        # Kernel times light outside the margin: R^(-11/3) R^-1 = R^(-14/3), hence the power 3/14.
        margin *= min(1.1 * excess ** (3.0 / 14.0), 3.0)
        # The missing light is computed as total light minus the sum of the samples, and includes their error.
        tol *= 0.5
    return request._replace(tol=tol, error=max(error, 1e-15), margin=margin)


def recorded(
    pupil: BasePupil,
    grid: Grid,
    blurs: tuple[Blur, ...],
    settings: tuple[Method | None, float, str, DType, int],
    out: Values | None = None,
) -> dict[str, Any]:
    """Return the attributes of the PSF of `pupil` on `grid`, for :class:`lommel.Plan`."""
    method, tol, normalize, dtype, threads = settings
    if grid.stack:
        grid = grid.broadcast(pupil.shape)
    require_unit(blurs, pupil)
    if pupil.layered:
        raise ValueError(
            "blur, fill and pixels that are not square are for lenses, got the pupil of an Objective: compute finer "
            "square pixels, and sum blocks of them"
        )
    candidate = method or candidates(pupil, Grid(grid.shape, min(grid.pitch)), tol)[-1]
    wanted = output_spec(grid, pupil, candidate, normalize, dtype, threads)
    shape = pupil.shape + grid.shape
    values = np.empty(shape, dtype) if out is None else place(out, shape, dtype)
    request = wanted._replace(out=values.reshape(-1, *grid.shape))
    used_method, images = recorded_images(method, tol, pupil, grid, blurs, request)
    # Report the method for the image, not for its finer samples; the quadrature is not a public method.
    used_method = method or (candidate if isinstance(used_method, TransferIntegral) else used_method).with_tol(tol)
    return {
        "values": values,
        "grid": grid,
        "pupil": pupil,
        "method": used_method,
        "normalize": normalize,
        "error_bound": None if images.error is None else largest(images.error),
        "scale": np.asarray(images.scale).reshape(pupil.shape),
        "blur": blurs,
    }
