"""Blurred, pixel-integrated images by any method, from samples as fine as the tolerance needs."""

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
from lommel.core.answers import Declined, DType, Images, ToleranceError, Wanted, not_met
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

# The intensity has no frequencies beyond ``abs(w) = 2``, and ``int abs(OTF) dw`` is at most the peak without
# aberration, so that a response that is off by e there makes errors of at most e times that peak (as in
# methods/averaging.py). What samples err by counts as often as the moduli of all weights together.
# Blur that ends at ``abs(w) = 2 s`` is computed in units of v / s, in which it ends at 2 too, on a lattice as coarse;
# samples of the intensity are finer, for theirs must not be taken for frequencies of the blur (docs/certificate.md,
# section 17).

STEP = 0.8
"""Step of samples in v, over the share of the band that blur leaves."""
_WORTH = 0.8  # share of the band above which a coarser lattice does not pay
_COARSEST = 1e-4  # error of a gate, over the largest possible value of light in this band
_MOST = 6144  # samples a side
_AT_ONCE = 2**24  # samples of a block of pupils
_KEPT = 2**21  # samples of a pupil up to which they are kept for other blur
_STEPS = 4  # lattices of a pupil that are kept


class Request(NamedTuple):
    """Method, threads, tolerance of samples, error of responses, and margin of the lattice for turbulence, in v.

    Where samples are `shared` with other blur, the lattice is one of few, a little finer and wider than needed.
    """

    method: Method | None
    threads: int
    tol: float
    error: float
    margin: float
    shared: bool = True


class BlurredStack(NamedTuple):
    """Images of the flattened stack and parts of their error bounds, each of shape (n,)."""

    values: Array
    given: Array  # error of the samples; NaN where the method has no bound
    response: Array  # error of the responses, and rounding
    missing: Array  # light from beyond the lattice that turbulence would bring
    method: Method


def summed(request: Request, pupil: BasePupil, grid: Grid, several: tuple[Blur, ...]) -> BlurredStack:
    """Return images summed over the wavelengths of a spectrum, each blurred by its own width of turbulence."""
    method = request.method
    if not isinstance(method, Polychromatic):
        return _stack_images(request, Component(1.0, 1.0, pupil), grid, several)
    parts = method.components(pupil)
    # Turbulence depends on the wavelength, so that blur must come before the sum.
    made = [_stack_images(request._replace(method=method.method), part, grid, several)[:4] for part in parts]
    weighted = ([part.weight * value for value in values] for part, values in zip(parts, made, strict=True))
    return BlurredStack._make([*(np.sum(each, axis=0) for each in zip(*weighted, strict=True)), method])


class Band(NamedTuple):
    """Share of the band of the intensity that blur leaves, and bounds on integrals of the moduli of spectra.

    Each integral is over frequencies, in the unit in which that of the aperture alone is the unaberrated peak.
    """

    share: float
    tail: float  # light through blur, beyond the share
    clear: float  # light without blur, within it
    blurred: float  # light through blur

    @property
    def ended(self) -> bool:
        """Whether blur ends within the band of the intensity."""
        return self.share < 1.0

    @classmethod
    def of(cls, pupil: BasePupil, several: tuple[Blur, ...], error: float, *, shared: bool = True) -> Band:
        """Return the share beyond which blur leaves at most `error` of the peak; one of few if `shared`."""
        fading, light = Fading.above(several, pupil.scale, pupil.wavelength), pupil.transmission
        # abs(O) <= pi tau bounds the tail by 8 tau int T f df: certificate, section 17, "Blur that ends early".
        share, left = fading.end(error * pupil.amplitude**2 / (8.0 * light), FURTHER)
        if shared:  # in eighths of octaves, so that blur of about the same width has the same lattice
            share = 2.0 ** (math.ceil(8.0 * math.log2(share)) / 8.0)
        if share > _WORTH:
            share, left = 1.0, 0.0
        return cls(share, 8.0 * light * left, 4.0 * light * share**2, 8.0 * light * fading.light)


def _stack_images(request: Request, part: Component, grid: Grid, several: tuple[Blur, ...]) -> BlurredStack:
    """Return images of a stack in one wavelength; pupils around one axis share a lattice."""
    pupil = part.pupil
    if grid.stack:
        each = [
            _stack_images(request, part._replace(pupil=pupil[index]), grid[index], several)
            for index in np.ndindex(grid.stack)
        ]
        return _joined(each)
    band, peak = Band.of(pupil, several, request.error, shared=request.shared), pupil.amplitude**2
    # In units of v / share blur ends at abs(w) = 2, as the intensity does: one gate and one step serve all blur.
    scale = pupil.scale / band.share
    # An error within a narrow band moves less light, so that a coarser gate has the same effect on the image.
    error = max(request.error, min(request.error * peak / band.clear, _COARSEST))
    gate = Gate.of(STEP, 2.0 ** math.floor(math.log2(error)) if request.shared else error)
    rows, columns = (
        readout(tuple(math.pi / scale * places), math.pi / scale * active, gate)
        for places, active in zip((grid.y, grid.x), grid.active, strict=True)
    )
    halo = Halo.of(several, scale, pupil.wavelength, gate)
    lattice = Lattice.of(request, band, Short.of(several, scale), halo, (rows, columns))
    reach = max(max(-first, first + n - 1) for first, n in zip(lattice.first, lattice.counts, strict=True))
    far = reach * lattice.h / (math.pi * band.share)
    if halo.several and far > 0.5 * pupil.period:
        # Light of a repeated image would be counted, and what it spreads here is in no bound.
        raise ToleranceError(
            f"the mask repeats the image every {pupil.period:g} lambda*N, too soon for this seeing to this "
            f"tolerance, which take {2.0 * far:.4g}: give a finer mask, or one with squares=True"
        )
    blocks = _blocks(pupil, math.prod(lattice.counts))
    return _joined([_block_images(request, block, band, lattice, (rows, columns)) for block in blocks])


def _joined(parts: list[BlurredStack]) -> BlurredStack:
    """Return images of parts of a stack, joined along it."""
    each = zip(*(one[:4] for one in parts), strict=True)
    return BlurredStack._make([*(np.concatenate(values) for values in each), parts[0].method])


class Gather(NamedTuple):
    """Weights, shape (samples, places), by which samples of one side are gathered on a coarser lattice."""

    matrix: Any
    first: int  # index of the first place
    error: float  # of the response to waves of the band
    gain: float  # largest sum of moduli over places
    sums: float  # largest sum of moduli over samples

    @classmethod
    def of(cls, h: float, first: int, count: int, gate: Gate) -> Gather:
        """Return the weights of `count` samples, `h` apart."""
        if h == gate.h:
            return cls(None, first, 0.0, 1.0, 1.0)
        made = readout(tuple(h * (first + np.arange(float(count)))), 0.0, gate)
        matrix = made.matrix.toarray()
        return cls(matrix, made.first, made.error, made.gain, h / gate.h * float(np.abs(matrix).sum(axis=0).max()))


class Lattice(NamedTuple):
    """Samples in v over the share of the band, rows and columns, and the kernel that blurs them once gathered."""

    step: float  # from sample to sample, in v
    h: float  # the same in units of v over the share
    first: tuple[int, int]  # index of the first sample, 0 on the axis
    counts: tuple[int, int]
    gathers: tuple[Gather, Gather]
    blind: float  # bound on the sum of moduli of weights of samples beyond the ends
    gate: Gate
    kernel: Spread | None

    @classmethod
    def of(cls, request: Request, band: Band, short: Short, halo: Halo, pixels: tuple[Readout, Readout]) -> Lattice:
        """Return the lattice for pixels (rows, columns) to the requested errors."""
        gate, margin = halo.gate, request.margin * band.share
        plain, seen = short.nothing and not halo.several, bool(halo.several)
        # Copies of the band of the intensity begin where that of the blur ends, or from the next sixteenth on.
        ended = math.ceil(16.0 * band.share) / 16.0 if request.shared else band.share
        step = min(gate.h / band.share, math.pi / (1.0 + ended))
        # Within rounding of the coarse step no gathering is needed, which costs two products and an error.
        h = gate.h if step * band.share >= gate.h * (1.0 - 1e-15) else step * band.share
        beyond, cut = ends(gate)
        begins, counts, least, gathers = [], [], [], []
        for side, reach in zip(pixels, short.reach(gate.error)[::-1], strict=True):
            room = 0 if plain else math.ceil((reach + (0.0 if short.nothing else beyond)) / gate.h)
            first, last = side.first - room, side.first + side.samples - 1 + room
            # The readout takes places as far as the gate reaches, and gathering takes samples as far from those.
            more = 0.0 if h == gate.h else beyond
            near, far = first * gate.h - more, last * gate.h + more
            if seen and band.ended:
                # Light moves up to the margin from the pixels themselves; the samples of the readout must exist too.
                least_of, most_of = side.ends(reach)
                near = min(least_of - margin, side.first * gate.h + more)
                far = max(most_of + margin, (side.first + side.samples - 1) * gate.h - more)
            elif seen:
                near, far = min(near, 0.0) - margin, max(far, 0.0) + margin
            low, high = math.floor(near / h), math.ceil(far / h)
            # A lattice symmetric about the axis costs a quarter.
            if 2 * max(-low, high) + 1 <= 1.2 * (high - low + 1):
                high = max(-low, high) if not request.shared else _outwards(max(-low, high))
                low = -high
            begins.append(low)
            counts.append(high - low + 1)
            if max(counts) > _MOST:
                break
            gathers.append(made := Gather.of(h, low, counts[-1], gate))
            places = counts[-1] if made.matrix is None else made.matrix.shape[1]
            # The padded side holds all differences of places, so that no light wraps around to a place that is read.
            least.append(2 * max(last - made.first, made.first + places - 1 - first) + 2 if seen else places)
        if max(counts) > _MOST:
            raise ToleranceError(
                f"this image takes a lattice of {max(counts)} samples a side, more than {_MOST}, to be known to the "
                "tolerance: ask for a larger tol, or for a smaller window"
            )
        kernel = None if plain else spread(short, halo, (least[0], least[1]), margin, ended=band.ended)
        blind = 0.0 if seen or h == gate.h else 2.0 * cut * max(one.sums for one in gathers)
        return cls(
            step, h, (begins[0], begins[1]), (counts[0], counts[1]), (gathers[0], gathers[1]), blind, gate, kernel
        )

    def gathered(self, samples: Array, threads: int) -> Array:
        """Return a stack of samples gathered on the coarser lattice."""
        down, across = (one.matrix for one in self.gathers)
        if down is None:
            return samples
        # By the core: threads of BLAS wait for each other, for as long as all the rest takes.
        # (h / H)^2: gathered values are densities on the coarse lattice, as samples are on the fine one.
        turned = (self.h / self.gate.h) ** 2 * down.T
        return np.stack([product(product(turned, one, threads), across, threads) for one in samples])


def _outwards(count: int) -> int:
    """Return `count` rounded up to five significant bits, so that lattices of similar size are shared."""
    unit = 1 << max(0, count.bit_length() - 5)
    return -(-count // unit) * unit


def _blocks(pupil: BasePupil, samples: int) -> list[BasePupil]:
    """Return parts of a flattened stack whose samples fit into memory together."""
    count, size = math.prod(pupil.shape), max(1, _AT_ONCE // samples)
    if count <= size:
        return [pupil]
    starts = range(0, count, size)
    return [pupil[np.unravel_index(np.arange(s, min(s + size, count)), pupil.shape)] for s in starts]


def _block_images(
    request: Request, pupil: BasePupil, band: Band, lattice: Lattice, pixels: tuple[Readout, Readout]
) -> BlurredStack:
    """Return images of a few pupils from one lattice, with the error budget of certificate, section 17."""
    (rows, columns), (down, across), kernel = pixels, lattice.gathers, lattice.kernel
    method, samples, off = _on_lattice(request, pupil, lattice)
    peak, light = pupil.amplitude**2, 4.0 * math.pi * pupil.transmission * band.share**2
    gain, missing = rows.gain * columns.gain, np.zeros(len(samples))
    # Where turbulence ends within the band, errors count by the light of each sample, not by the peak.
    each = kernel is not None and kernel.core > 0.0 and band.ended
    clear, blurred = (band.clear, band.blurred) if each else (min(band.clear, peak), min(band.blurred, peak))
    # (1 + a)(1 + b) - 1 of the responses along rows and columns.
    response = (rows.error + columns.error + rows.error * columns.error) * blurred
    if kernel is not None:
        gather, gathering = down.gain * across.gain, down.error + across.error + down.error * across.error
        spreading = kernel.error * clear + gathering * (band.blurred + kernel.error * band.clear)
        most = light * kernel.core * gather if each else peak * down.sums * across.sums
        spreading += most * (kernel.blind + 2.0**-53 * sum(lattice.counts) * max(1.0, kernel.gain))
        # Samples beyond the ends of a lattice without turbulence: at most the unaberrated peak each.
        spreading += peak * lattice.blind * kernel.gain
        response += gain * (spreading + light * gather * kernel.off) + band.tail * (1.0 + gain * gather)
    rounding = 0.0
    if kernel is not None:
        coarse = lattice.gathered(samples, request.threads)
        rounding = gain * kernel.rounding(coarse)
        area = lattice.h**2 * samples[0].size
        # Parseval: h^2 times the sum over the whole plane is all light, 4 pi tau; the rest lies beyond the lattice.
        there = lattice.h**2 * samples.sum(axis=(1, 2)) - area * np.nan_to_num(off)
        missing = kernel.missing * np.clip(light - there, 0.0, light)
        if each:
            # Blur is nowhere negative and has unit sum, so that its gain is 1 but for the errors of its weights.
            gain = 1.0 + 2.0 * area * response / light
        else:
            missing *= gain
            gain *= kernel.gain * down.sums * across.sums
        samples = kernel.on(coarse, request.threads)
    top, left = rows.first - down.first, columns.first - across.first
    part = samples[:, top : top + rows.samples, left : left + columns.samples]
    values = np.stack([(columns.matrix @ (rows.matrix @ one).T).T for one in part])
    error = np.full(len(values), 1.0001 * response + rounding)
    return BlurredStack(values, gain * off, error, missing, method)


class Known(NamedTuple):
    """Samples of a pupil on a lattice, kept for other blur and other wavelengths."""

    first: tuple[int, int]
    tol: float
    method: Method
    samples: Array
    off: Array

    def part(self, first: tuple[int, int], counts: tuple[int, int]) -> Array | None:
        """Return the samples of a smaller lattice, None where it is not within this one."""
        low = [there - here for there, here in zip(first, self.first, strict=True)]
        high = [at + count for at, count in zip(low, counts, strict=True)]
        if min(low) < 0 or high[0] > self.samples.shape[1] or high[1] > self.samples.shape[2]:
            return None
        return self.samples[:, low[0] : high[0], low[1] : high[1]]


@lru_cache(maxsize=2)
def _known(_aperture: tuple[object, ...], _wavefront: Wavefront) -> dict[float, Known]:
    """Return the samples kept for an aperture and a wavefront, by the step of their lattice."""
    # The cache returns the same dictionary again, to be filled by the caller.
    return {}


def _on_lattice(request: Request, pupil: BasePupil, lattice: Lattice) -> tuple[Method, Array, Array]:
    """Return the method, samples of a stack on a lattice, and bounds on their errors, NaN where unknown."""
    first, counts = lattice.first, lattice.counts
    fine = Grid(counts, lattice.step * pupil.scale / math.pi, center=(-first[0], -first[1]))
    if not request.shared or request.method or not isinstance(pupil, Pupil) or pupil.circular or pupil.shape:
        return _sampled(request, pupil, fine)
    # In half decades of the tolerance, so that other blur of similar width meets the kept samples.
    request = request._replace(tol=10.0 ** (0.5 * math.floor(2.0 * math.log10(request.tol))))
    known = _known(pupil.aperture, pupil.wavefront)
    kept = known.get(lattice.step)
    if kept is not None and kept.tol <= request.tol and (part := kept.part(first, counts)) is not None:
        return kept.method, part, kept.off
    made = _sampled(request, pupil, fine)
    if made[1].size > _KEPT:
        return made
    # The oldest lattices go first: dictionaries keep the order of insertion.
    for step in list(known)[: max(0, len(known) - _STEPS + 1)]:
        known.pop(step, None)
    known[lattice.step] = Known(first, request.tol, *made)
    return made


def _sampled(request: Request, pupil: BasePupil, fine: Grid) -> tuple[Method, Array, Array]:
    """Return the method, samples of a stack computed on a lattice, and bounds on their errors, NaN where unknown."""
    if request.method is not None:
        ways: tuple[Method, ...] = (request.method.tightened(max(request.tol, request.method.least_tol)),)
        # A method that is named keeps its own tolerance if that is tighter than needed.
        if request.tol > request.method.tol:
            ways = (request.method,)
    else:
        least = 1e-11 if not pupil.circular else Method.least_tol
        ways = candidates(pupil, fine, min(max(request.tol, least), 0.05))
    ways[0].require(pupil)
    fine.require_reach(pupil)

    def ask(way: Method) -> Images:
        made = way.intensity(pupil, fine, request.threads)
        values, scales = made.values, np.ones(len(made.values))
        if values.ndim == 2:
            values = np.empty((len(scales), *fine.shape))
            fine.paint(made.values, scales, values)
        peak = made.values.reshape(len(scales), -1).max(axis=1) if made.peak is None else made.peak
        return with_model_error(Images(values, scales, made.error, None, peak), pupil, way, normalized=False)

    way, made = first_within_tolerance(ways, ask)
    assert made.peak is not None
    return (
        way.reported,
        made.values,
        np.full(len(made.values), np.nan) if made.error is None else made.error * made.peak,
    )


_TRIES = 7


def of_transfer(
    request: Request, tol: float, pupil: BasePupil, grid: Grid, several: tuple[Blur, ...]
) -> Method | None:
    """Return the quadrature over transfer functions, None where it does not apply or takes longer than a lattice."""
    method = request.method
    white = method if isinstance(method, Polychromatic) else None
    single = method if white is None else white.method
    if not (single is None or isinstance(single, NijboerZernike)) or not (several and grid.square):
        return None
    if Fading.of(several, pupil.scale, pupil.wavelength) is None:
        return None
    way, seconds = TransferIntegral(tol, several), 0.0
    for _, _, part in white.components(pupil) if white else [Component(1.0, 1.0, pupil)]:
        if not (isinstance(part, Pupil) and part.radial):
            return None
        seconds += max(1, math.prod(grid.stack)) * way.seconds(part, grid)
        if seconds > _lattice_seconds(request, part, grid, several):
            return None
    return way if white is None else Polychromatic(white.wavelengths, white.weights, way)


def _lattice_seconds(request: Request, pupil: BasePupil, grid: Grid, several: tuple[Blur, ...]) -> float:
    """Estimate the time of images from a lattice of samples."""
    share = Band.of(pupil, several, request.error).share
    h = min(STEP / share, math.pi / (1.0 + share))
    beyond = request.margin or max(Short.of(several, pupil.scale).reach(1e-9)) + 30.0 / share
    samples = (2.0 * (grid.reach(pupil) / math.sqrt(2.0) + beyond) / h) ** 2
    pixels = 4e-6 * max(grid.shape) ** 2 if grid.integrate else 0.0
    return 4e-3 + pixels + 4e-8 * samples * math.prod(pupil.shape)


def transferred(way: Method, pupil: BasePupil, grid: Grid, wanted: Wanted) -> Images:
    """Return images of a stack by quadrature over transfer functions, each pupil around its own axis."""
    if not grid.stack:
        return way.images(pupil, grid, wanted)
    values = np.empty((math.prod(grid.stack), *grid.shape), wanted.dtype) if wanted.out is None else wanted.out
    scales, errors = np.empty(len(values)), np.empty(len(values))
    for k, index in enumerate(np.ndindex(grid.stack)):
        scale = wanted.scale
        one = wanted._replace(
            out=values[k : k + 1],
            scale=scale if scale is None or np.ndim(scale) == 0 else np.asarray(scale)[k : k + 1],
        )
        made = way.images(pupil[index], grid[index], one)
        scales[k], errors[k] = made.scale[0], made.bound[0]
    return Images(values, scales, errors)


def recorded_images(
    method: Method | None, tol: float, pupil: BasePupil, grid: Grid, several: tuple[Blur, ...], wanted: Wanted
) -> tuple[Method, Images]:
    """Return the method that sampled, and the blurred images of a stack, with errors below `tol` of the peak."""
    if method is not None and method.sampling == "pixel":
        raise ValueError(
            f"method must have point values for blur, fill and pixels that are not square, got "
            f"{type(method).__name__}, which has none; leave it out"
        )
    dtype, peaked = wanted.dtype, wanted.scale is None
    # Half where values are divided by their own largest one, whose error counts again; a tenth is a reserve.
    aim = (0.45 if peaked else 0.9) * (tol - 1.1 * storing(dtype))
    request = _first_request(method, pupil, grid, several, aim, wanted.threads)
    way = of_transfer(request, tol, pupil, grid, several)
    if way is not None:
        # Declined or not met: the lattice has no such limits and is tried next.
        with suppress(ToleranceError, Declined):
            return way, transferred(way, pupil, grid, wanted)
    elsewhere = 0.0 if peaked else _axis_level(request, pupil, grid, several)
    for tries in range(_TRIES):
        try:
            made = summed(request, pupil, grid, several)
        except (ValueError, ToleranceError) as fault:
            # A shared lattice is larger than needed: before an error is reported, the smallest one is tried.
            if request.shared:
                request = request._replace(shared=False)
                continue
            if method is None:
                _refuse_seeing(request, tol, pupil, several, fault)
            raise
        tops = np.maximum(made.values.max(axis=(1, 2)), elsewhere)
        if not tops.min() > 0:
            raise ValueError("no light falls into the window that is brighter than the errors there")
        # Where the samples have no bound, the errors that blur adds are kept below the tolerance on their own.
        unknown = bool(np.isnan(made.given).any())
        relative = ((0.0 if unknown else made.given) + made.response + made.missing) / tops
        # e / (peak - e) of the exact peak; beyond a half nothing is proven.
        relative = np.where(relative < 0.5, relative / (1.0 - np.minimum(relative, 0.5)), np.inf)
        bounds = stored(normalized_error(relative) if peaked else relative, dtype)
        if bounds.max() <= tol or (method is not None and not method.keeps_tol and not unknown):
            return made.method, _scaled(made, wanted, None if unknown else bounds)
        request = _refined_request(request, made, aim * tops)._replace(shared=request.shared and tries == 0)
    raise not_met(tol, float(bounds.max()), "the largest value in the window")


def _refuse_seeing(
    request: Request, tol: float, pupil: BasePupil, several: tuple[Blur, ...], fault: Exception
) -> None:
    """Raise ToleranceError if seeing needs samples too far beyond the window."""
    ratio = _seeing_ratio(pupil, several)
    if ratio and not math.isfinite(pupil.period):
        raise ToleranceError(
            f"seeing of D / r0 = {ratio:.3g} to tol={tol:g} takes samples of the PSF without seeing to "
            f"{request.margin / math.pi:.0f} lambda*N beyond the window, too far for this aperture. Ask for a "
            "larger tol, up to 0.01, or for a pupil with an obscuration only, which in strong seeing has nearly "
            "the same image"
        ) from fault


def _scaled(made: BlurredStack, wanted: Wanted, bounds: Array | None) -> Images:
    """Return images divided by their largest values, or multiplied by the requested scale."""
    tops = made.values.max(axis=(1, 2))
    scales = 1.0 / tops if wanted.scale is None else np.broadcast_to(np.asarray(wanted.scale), tops.shape)
    values = np.empty(made.values.shape, wanted.dtype) if wanted.out is None else wanted.out
    # Clamp to 0: averages of an intensity are not negative, and clamping does not increase the error.
    np.multiply(np.maximum(made.values, 0.0), scales[:, None, None], out=values, casting="same_kind")
    return Images(values, scales, bounds)


def _seeing_ratio(pupil: BasePupil, several: tuple[Blur, ...]) -> float:
    """Return the width of the broadest seeing in lambda*N, the diameter over r0; 0 without."""
    air = (blur for blur in several if isinstance(blur, Seeing))
    return max((1.0 / (one.coherence(pupil.wavelength) * pupil.scale) for one in air), default=0.0)


def _axis_level(request: Request, pupil: BasePupil, grid: Grid, several: tuple[Blur, ...]) -> float | Array:
    """Return a lower bound on the brightest pixel around the axis: errors of windows beside it are over it too."""
    rows, columns = np.broadcast_arrays(*grid.center)
    if np.all((rows > -0.5) & (rows < grid.height - 0.5) & (columns > -0.5) & (columns < grid.width - 0.5)):
        return 0.0
    # Three pixels hold the peak of any centred blur; coarse tolerances suffice for a lower bound.
    there = Grid(3, grid.pixel, integrate=grid.integrate, fill=grid.fill)
    made = summed(request._replace(tol=max(request.tol, 1e-6), error=max(request.error, 1e-9)), pupil, there, several)
    off = made.response + made.missing + np.nan_to_num(made.given)
    return np.asarray(np.maximum(made.values.max(axis=(1, 2)) - off, 0.0))


def _first_request(
    method: Method | None, pupil: BasePupil, grid: Grid, several: tuple[Blur, ...], aim: float, threads: int
) -> Request:
    """Return the first request, estimated from the widths of diffraction, blur and pixels."""
    to_v = math.pi / pupil.scale
    short = Short.of(several, pupil.scale)
    halo = Halo.of(several, pupil.scale, pupil.wavelength, Gate.of(STEP, 1e-6))
    # Area of a uniform spot with the same light and peak; variances and squared widths of independent blurs add.
    spot = 4.0 * math.pi * pupil.transmission / pupil.likely_peak
    sides = 2.0 * math.pi * np.diag(short.covariance) + (short.streaks**2).sum(axis=0)
    sides = sides + np.array([(to_v * a) ** 2 for a in grid.active[::-1]])
    area = math.sqrt(float(np.prod(spot + sides)))
    # The kernel at 0 is the inverse of the area of the halo.
    if halo.several:
        area += 1.0 / float(halo.at(np.zeros(1))[0])
    # Most of the tolerance goes to light beyond the lattice, which costs the most to reduce.
    samples, responses = (0.12, 0.009) if halo.several else (0.3, 0.02)
    tol = max(samples * aim * spot / area, 1e-13)  # over the peak of the samples
    bright = 4.0 * math.pi * pupil.transmission / area
    error = max(responses * aim * bright / pupil.amplitude**2, 1e-15)
    request = Request(method, threads, tol, error, 0.0)
    if not halo.several:
        return request
    half = to_v * 0.5 * min(side * pitch for side, pitch in zip(grid.shape, grid.pitch, strict=True))
    # Where turbulence does not end within the band, its kernel is convolved with the gate and is wider.
    more = 0.0 if Band.of(pupil, several, error).ended else 60.0
    blur = float(pupil.v(pupil.geometric_radius()).max())
    return request._replace(margin=blur + more + _margin(halo, half, _edges(pupil), 0.5 * aim / area))


def _edges(pupil: BasePupil) -> float:
    """Estimate the length of the edges of an aperture over that of a disc of the same area."""
    # Light far from the axis is diffracted by edges, in proportion to their length (r^-3 each).
    if not isinstance(pupil, Pupil) or pupil.circular:
        return 1.0 / (1.0 - getattr(pupil, "obscuration", 0.0))
    return 6.0 if isinstance(pupil.stop, Segments) else 2.0


def _margin(halo: Halo, half: float, edges: float, allowed: float) -> float:
    """Estimate the margin of a lattice around a window (half side `half`, v) that misses `allowed` light, in v."""
    # Encircled energy of a disc far out: 1 - 2 / (pi R) (Rayleigh).
    margins = np.geomspace(5.0, 1e5, 400)
    missing = np.minimum(edges * 2.0 / (math.pi * (half + margins)), 1.0)
    low, high = 0, margins.size - 1
    # Bisection: both factors fall with the margin.
    while high - low > 1:
        middle = (low + high) // 2
        enough = missing[middle] * halo.bound(float(margins[middle])) <= allowed
        low, high = (low, middle) if enough else (middle, high)
    return float(margins[high])


def _refined_request(request: Request, made: BlurredStack, allowed: Array) -> Request:
    """Return the next request: each error reduced by its excess, with shares that sum to less than 1."""
    tol, error, margin = request.tol, request.error, request.margin
    given = np.zeros(len(allowed)) if np.isnan(made.given).any() else made.given
    if (much := float((given / (0.4 * allowed)).max())) > 1.0:
        tol *= max(0.5 / much, 1e-4)
    if (much := float((made.response / (0.2 * allowed)).max())) > 1.0:
        error *= max(0.5 / much, 1e-6)
    if (much := float((made.missing / (0.5 * allowed)).max())) > 1.0:
        # The kernel falls as R^(-11/3) and the light beyond as R^-1: together R^(-14/3), hence the power 3/14.
        margin *= min(1.1 * much ** (3.0 / 14.0), 3.0)
        # The missing light is bounded by all light less the sum of the samples, so that their error counts there too.
        tol *= 0.5
    return request._replace(tol=tol, error=max(error, 1e-15), margin=margin)


def recorded(
    pupil: BasePupil,
    grid: Grid,
    several: tuple[Blur, ...],
    settings: tuple[Method | None, float, str, DType, int],
    out: Values | None = None,
) -> dict[str, Any]:
    """Return the attributes of the PSF of `pupil` on `grid`, for :class:`lommel.Plan`."""
    method, tol, normalize, dtype, threads = settings
    if grid.stack:
        grid = grid.broadcast(pupil.shape)
    require_unit(several, pupil)
    if pupil.layered:
        raise ValueError(
            "blur, fill and pixels that are not square are for lenses, got the pupil of an Objective: ask for finer "
            "square pixels, and sum blocks of them"
        )
    way = method or candidates(pupil, Grid(grid.shape, min(grid.pitch)), tol)[-1]
    wanted = output_spec(grid, pupil, way, normalize, dtype, threads)
    shape = pupil.shape + grid.shape
    values = np.empty(shape, dtype) if out is None else place(out, shape, dtype)
    question = wanted._replace(out=values.reshape(-1, *grid.shape))
    used, made = recorded_images(method, tol, pupil, grid, several, question)
    # Samples are finer than the image that is reported; the quadrature is not a public method.
    used = method or (way if isinstance(used, TransferIntegral) else used).with_tol(tol)
    return {
        "values": values,
        "grid": grid,
        "pupil": pupil,
        "method": used,
        "normalize": normalize,
        "error_bound": None if made.error is None else largest(made.error),
        "scale": np.asarray(made.scale).reshape(pupil.shape),
        "blur": several,
    }
