"""Filter tables, and streams (filters in the compiled core), for live depth and depth from photographs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Annotated, ClassVar, Literal, NamedTuple, TypeAlias

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.cached import Kept, cached_property
from lommel.base.options import Options, Shown
from lommel.core.answers import DType
from lommel.core.engine import FocalScale, FocalStream
from lommel.estimation.depth_precision import WINDOW
from lommel.estimation.focal_model import FocalLight, FocalModel, Spectrum, Transfer, transfer_curve
from lommel.imaging.focal_tables import SharpTables, Taps, candidates, focal_tables, residual_filters, shifts
from lommel.optics.lens import Lens
from lommel.recorded.noise import Noise

Frame = Values
Magnification: TypeAlias = Literal["registered", "lens"] | float


def checked_magnification(name: str, value: object) -> Magnification:
    """Return a magnification; TypeError or ValueError if it is neither a number nor one of the names."""
    if isinstance(value, str):
        if value not in ("registered", "lens"):
            raise ValueError(f'{name} must be "registered", "lens" or a number, got {value!r}')
        return "lens" if value == "lens" else "registered"
    return validation.real(name, value, above=0.8, below=1.25)


def _parsed(text: str) -> Magnification:
    """Return the magnification of a text; ValueError if it is none."""
    try:
        number = float(text)
    except ValueError:
        return checked_magnification("magnification", text)
    return checked_magnification("magnification", number)


_SHOWN = Shown(metavar="registered|lens|NUMBER", parse=_parsed)


@dataclass(frozen=True, kw_only=True)
class Magnified(Options):
    """Magnification of images that differ in focus.

    Parameters
    ----------
    magnification : {"registered", "lens"} or float, default "registered"
        "registered": points are at the same pixels in all images. "lens": each image is magnified as by a thin lens
        at its sensor distance, and is resampled to the scale of the first, about the centre. A number: magnification
        of the second of two images relative to the first, such as 0.99.
    """

    heading: ClassVar[str] = "Camera"
    magnification: Annotated[Magnification, checked_magnification, _SHOWN] = "registered"


class Registration:
    """Resampling of frames to the magnification of the first, about the image centre.

    Parameters
    ----------
    magnification : {"registered", "lens"} or float
        Magnification of the frames; see :class:`Magnified`.
    lenses : sequence of Lens
    size : (int, int)
        Height and width, pixels.
    threads : int

    Attributes
    ----------
    scales : tuple of float
        Pixel pitch of each frame before resampling / pixel pitch after resampling.
    """

    def __init__(
        self, magnification: Magnification, lenses: Sequence[Lens], size: tuple[int, int], threads: int
    ) -> None:
        self.scales = (1.0,) * len(lenses)
        if isinstance(magnification, float):
            if len(lenses) != 2:
                raise ValueError(f"magnification must be a name for {len(lenses)} images, got {magnification:g}")
            self.scales = 1.0, magnification
        elif magnification == "lens":
            # Image height is proportional to the distance from pupil to sensor.
            self.scales = tuple(lens.sensor_distance / lenses[0].sensor_distance for lens in lenses)
        self._scales = [FocalScale(*size, scale, threads) if scale != 1.0 else None for scale in self.scales]
        self._buffers = [None if one is None else np.empty(size, dtype=np.float32) for one in self._scales]

    def __bool__(self) -> bool:
        """Return True if a frame is resampled."""
        return any(self._scales)

    def __call__(self, frames: list[Frame], saturation: float, known: NDArray[np.uint8] | None) -> list[Frame]:
        """Return resampled frames, in arrays that the next call overwrites; NaN where unknown pixels contribute."""
        resampled = list(frames)
        for k, (scale, out) in enumerate(zip(self._scales, self._buffers, strict=True)):
            if scale is not None and out is not None:
                scale(frames[k], saturation, known, out)
                resampled[k] = out
        return resampled


class FrameForm:
    """Shape, noise and valid pixels of the frames of a camera; TypeError or ValueError for invalid arguments.

    Parameters
    ----------
    shape : (int, int) or (int, int, int)
        Height and width, and optionally the number of channels.
    noise : Noise
        Noise, the same for all pixels.
    saturation : float or None
        Pixel value at and above which pixels are saturated. The largest unsigned integer is always saturated.
    """

    def __init__(self, shape: tuple[int, ...], noise: Noise, saturation: float | None) -> None:
        if not isinstance(shape, Sequence) or len(shape) not in (2, 3):
            raise TypeError(f"shape must be height and width, and optionally channels, got {validation.shown(shape)}")
        height, width = (
            validation.integer(f"shape[{k}]", shape[k], least=64, most=validation.MAX_SIDE) for k in range(2)
        )
        self.size = height, width
        self.channels = validation.integer("shape[2]", shape[2], least=1, most=16) if len(shape) == 3 else 1
        if validation.instance("noise", noise, Noise).excess != 1.0:
            raise ValueError(
                f"noise must have no excess for live frames, got excess={noise.excess:g}; pass noise.poisson, which "
                "counts (electrons / excess)"
            )
        for name in ("white", "read", "offset"):
            if not isinstance(getattr(noise, name), float | None):
                raise ValueError(
                    f"noise.{name} must be a number for live frames, not a map of the sensor; use its median, and "
                    "make pixels that differ much NaN"
                )
        self.white, self.read, self.offset = float(noise.white or 1.0), float(noise.read), float(noise.offset)
        self._saturation = math.inf if saturation is None else validation.real("saturation", saturation)

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of frames."""
        return self.size if self.channels == 1 else (*self.size, self.channels)

    def checked(self, name: str, frame: Frame) -> Frame:
        """Return a frame as the C++ core expects it."""
        if not isinstance(frame, np.ndarray):
            raise TypeError(f"{name} must be an ndarray, got {validation.shown(frame)}")
        validation.refuse_masked(name, frame)
        if frame.shape != self.shape:
            raise ValueError(f"{name} must have the shape {self.shape}, got {frame.shape}")
        if frame.dtype in (np.uint8, np.uint16, np.float32):
            return frame if frame.strides[1] == frame.itemsize * self.channels else np.ascontiguousarray(frame)
        if frame.dtype.kind == "f":
            return np.asarray(frame, dtype=np.float32)
        raise TypeError(f"{name} must be of uint8, uint16 or floats, got {frame.dtype}")

    def saturation(self, dtype: DType) -> float:
        """Return the value at which pixels are saturated."""
        return min(self._saturation, float(np.iinfo(dtype).max) if dtype.kind == "u" else math.inf)

    def known(self, frames: Sequence[Frame], saturation: float, valid: ArrayLike | None) -> NDArray[np.uint8] | None:
        """Return a mask of pixels that are True in `valid` and not saturated; None if all are valid."""
        masks = []
        if valid is not None:
            masks.append(self._mask(valid))
        # If one channel of a pixel is saturated, the pixel is invalid in all channels.
        if self.channels > 1:
            for frame in frames:
                with np.errstate(invalid="ignore"):
                    masks.append(np.asarray((frame < saturation).all(axis=2), dtype=np.bool_).view(np.uint8))
        if len(masks) <= 1:
            return masks[0] if masks else None
        return np.asarray(np.logical_and.reduce(masks)).view(np.uint8)

    def _mask(self, known: ArrayLike) -> NDArray[np.uint8]:
        mask = validation.array("known", known)
        if mask.shape != self.size or mask.dtype != np.bool_:
            raise ValueError(f"known must be of bool and of shape {self.size}, got {mask.dtype} of {mask.shape}")
        return np.ascontiguousarray(mask).view(np.uint8)

    def image(self, out: NDArray[np.float32] | None) -> NDArray[np.float32]:
        """Return `out`, or a new array for an image; ValueError unless `out` is a contiguous frame of float32."""
        if out is None:
            return np.empty(self.shape, dtype=np.float32)
        if out.shape != self.shape or out.dtype != np.float32 or not out.flags.c_contiguous:
            raise ValueError(f"out must be a contiguous array of float32 of shape {self.shape}")
        return out


BLOCK = 4
"""Side, in pixels, of the blocks over which the energies of filtered images are summed."""

UNMEASURED = 0.03, 0.02
"""Relative standard errors of the f-number and of each focus distance of a lens that was not measured."""

CONTRAST = 0.2
"""Texture contrast for which filters are designed: rms / mean, for structures of 2 to 128 pixels."""

MAX_KNOWN_ERROR = 0.17
"""Largest standard error of a known depth / vergence range."""

_MIN_CANDIDATES = 61  # smallest default number of candidate depths
_STEP = 0.75  # defocus between neighbouring candidates, radians at the pupil edge
_EDGE = 0.3  # pixels: if the blur radius changes by less per radian, a change by this much counts as 1 rad of defocus
_MAX_RANK = 48  # largest number of filtered images per channel
_CHANGE = 0.01  # finite difference for derivatives by lenses: relative change of f-numbers, or fraction of a step
_DERIVATIVE_CANDIDATES = 15  # number of candidates at which derivatives by lenses are computed
_FOCI = 5  # number of foci from which the basis of refocused images is computed
_SAME = 1e-9  # largest relative difference of focus distances that are equal up to rounding
_BRIGHT = 50_000.0  # electrons per pixel at which depths on both sides of a focus are compared
_DISTINCT = 3.0  # smallest difference of their energies by which they are distinct, in standard errors of a window


class FocalTask(NamedTuple):
    """Lenses of the frames, and parameters of the depth map."""

    lenses: Sequence[Lens]
    vergence: Array  # 1 / distance of each candidate, 1 / m
    spectra: Sequence[Spectrum]  # spectrum of each channel
    pixel: float  # pixel pitch, metres
    between: tuple[float, float]  # nearest and farthest distance, metres
    subdivision: int  # number of depths along each side of a block
    threads: int
    transfer: Transfer = transfer_curve
    scales: tuple[float, ...] = ()  # pixel pitches of resampled frames, in pixels

    @property
    def blur(self) -> float:
        """Largest radius of the blur, pixels."""
        ends = np.asarray(self.between)
        return max(float(lens.pupil(ends).geometric_radius().max()) for lens in self.lenses) / self.pixel

    def model(
        self, light: FocalLight, channel: int = 0, binning: int = 1, lenses: Sequence[Lens] | None = None, **more: int
    ) -> FocalModel:
        """Return the model of a channel with pixels binned, for `lenses` or by default those of the task."""
        return FocalModel.of(
            lenses or self.lenses,
            self.vergence,
            self.spectra[channel],
            self.pixel,
            light,
            transfer=self.transfer,
            binning=binning,
            scales=self.scales,
            **more,
        )


def checked_range(
    between: tuple[float, float],
    lenses: Sequence[Lens],
    pixel: float,
    limit: int,
    transfer: Transfer = transfer_curve,
) -> tuple[tuple[float, float], Array]:
    """Return `between` after checks, and the vergences (1/m) of the candidate depths, at most `limit`.

    ValueError also if `between` contains both sides of a focus that all of several lenses share, with equal images.
    """
    if not isinstance(between, Sequence | np.ndarray) or len(between) != 2:
        raise TypeError(f"between must be the nearest and the farthest distance, got {validation.shown(between)}")
    nearest = validation.real("between[0]", between[0], above=0.0, unit="metres")
    farthest = validation.real("between[1]", between[1], above=0.0, infinite=True, unit="metres")
    if not nearest < farthest:
        raise ValueError(f"between must be the nearest and the farthest distance, got {nearest:g} and {farthest:g} m")
    if len(lenses) > 1:
        _refuse_mirrored((nearest, farthest), lenses, pixel, transfer)
    span = 0.0
    for lens in lenses:
        # The blur radius changes by 4 lambda N / pi per radian of defocus.
        radius_rate = 4.0 * lens.wavelength * lens.working_f_number / (math.pi * pixel)
        span = max(span, float(abs(np.diff(lens.defocus([nearest, farthest]))[0])) * min(1.0, radius_rate / _EDGE))
    count = max(_MIN_CANDIDATES, math.ceil(span / _STEP) + 1)
    if count > limit:
        raise ValueError(
            f"between spans so much defocus that {count} candidates are needed, more than {limit}: choose a "
            "smaller range, stop down, or bin pixels"
        )
    return (nearest, farthest), candidates((nearest, farthest), count + -(count - 1) % 4, lenses)


def _refuse_mirrored(ends: tuple[float, float], lenses: Sequence[Lens], pixel: float, transfer: Transfer) -> None:
    """Raise ValueError if lenses with one focus distance have equal images on both sides of it, within `ends`.

    Without spherical aberration blur depends on abs(1 / distance - 1 / focus distance).
    """
    focus, (low, high) = 1.0 / lenses[0].focus_distance, (1.0 / distance for distance in ends[::-1])
    extent = min(high - focus, focus - low)
    if extent <= _SAME * high or any(abs(1.0 / lens.focus_distance - focus) > _SAME * focus for lens in lenses):
        return
    # Frames at distances on one side, filtered for the mirror images of these distances: what is left of the scene?
    offsets = extent * np.linspace(0.25, 1.0, 4)
    vergence = np.maximum(focus + np.append(offsets, -offsets), 0.0)
    light, spectrum = FocalLight(_BRIGHT, 0.0, (1.0,) * len(lenses), CONTRAST), ((lenses[0].wavelength, 1.0),)
    model = FocalModel.of(lenses, vergence, spectrum, pixel, light, transfer=transfer)
    filters, share = residual_filters(model), model.band.share
    scene = np.einsum("cpif,cif->cpf", filters, np.roll(model.transfer, len(offsets), axis=0)) ** 2 * model.texture
    noise = np.einsum("cpif,i->cpf", filters**2, model.white)
    errors = np.sqrt(2.0 * (noise**2 @ share).sum(axis=1) / (4.0 * math.pi * WINDOW**2))
    if ((scene @ share).sum(axis=1) / errors).max() < _DISTINCT:
        middle = f"{1.0 / focus:.4g}"
        near, far = (1.0 / v if v > _SAME * focus else math.inf for v in (focus + extent, focus - extent))
        raise ValueError(
            f"both sides of the focus at {middle} m are in between=: {near:.3g} m and {far:.3g} m cannot be told "
            f"apart; state one side, {ends[0]:g} to {middle} m or {middle} to {ends[1]:g} m"
        )


class FocalEngine:
    """Filter tables for one light level, and streams that filter frames of any shape.

    Parameters
    ----------
    task : FocalTask
    light : FocalLight
        Light per pixel of each channel.
    """

    def __init__(self, task: FocalTask, light: FocalLight) -> None:
        self.task, self.light = task, light
        self._weights, self._pixels = block_weights(WINDOW, BLOCK)
        blocks = self._weights, BLOCK
        first = focal_tables(partial(task.model, light, 0), light, blocks)
        other_channels = [
            focal_tables(partial(task.model, light, channel), light, blocks, like=first)
            for channel in range(1, len(task.spectra))
        ]
        self.channels = [first, *other_channels]
        if self.rank > _MAX_RANK:
            near, far = task.between
            raise ValueError(
                f"between must span less defocus: depths from {near:g} to {far:g} m need {self.rank} filters, more "
                f"than {_MAX_RANK}; choose a smaller range, stop down, or bin pixels"
            )
        self._low, self._high = ((1.0 / distance - first.vergence[0]) / first.step for distance in task.between[::-1])
        self._factors = Kept(self._factors_of, 16)
        self.images: list[SharpTables] = []

    @property
    def binning(self) -> int:
        """Binning of frames before filtering, pixels along each axis."""
        return self.channels[0].binning

    @property
    def rank(self) -> int:
        """Number of filtered images, from whose products all energies of a channel are computed."""
        return max(tables.rank for tables in self.channels)

    @property
    def reach(self) -> int:
        """Radius, in pixels, of the neighbourhood in the frames that determines the depth of a pixel."""
        tables = self.channels[0]
        filters = tables.degree * (len(tables.taps.values) - 1) * tables.binning
        # A window, and the depths around, up to two windows away, that decide whether one is known.
        return filters + math.ceil(self.task.blur) + (3 * len(self._weights) - 1) * BLOCK

    @property
    def design_error(self) -> float:
        """Largest bias of depth due to the filter approximation, in standard errors of a window."""
        inner = slice(max(0, math.floor(self._low)), math.ceil(self._high) + 1)
        ratios = [np.abs(tables.bias / tables.errors)[inner].max() for tables in self.channels]
        # `errors` are those of one pixel; a window of n independent pixels divides them by sqrt(n).
        return float(max(ratios)) * math.sqrt(self._pixels) / self.binning

    def lens_derivatives(self, vergence: Array) -> Array:
        """Return derivatives of the estimated vergence by lens parameters, (1 + frames, *vergence.shape).

        The first derivative is by the logarithm of all f-numbers (1 / m), the other derivatives are by the focus
        vergence (1 / focus distance) of each frame.
        """
        vergences, changes = self._lens_derivatives
        return np.stack([np.interp(vergence, vergences, derivatives) for derivatives in changes])

    def lens_errors(self, vergence: Array, f_number_error: float | None, focus_error: float | None) -> Array:
        """Return standard errors of vergence due to errors of the lenses, which all points at one distance share.

        `f_number_error` is the relative error of all f-numbers, `focus_error` that of each focus vergence in 1 / m.
        If both are None, the lens was not measured: see :data:`UNMEASURED`.
        """
        foci = [1.0 / lens.focus_distance for lens in self.task.lenses]
        assumed = f_number_error is None and focus_error is None
        by_f_number, *by_foci = self.lens_derivatives(vergence)
        variance = np.square(by_f_number * (UNMEASURED[0] if assumed else f_number_error or 0.0))
        for focus in set(foci):
            # Frames with equal focus distances share one focus error.
            shift = np.sum([by_foci[k] for k, other in enumerate(foci) if other == focus], axis=0)
            variance += np.square(shift * (UNMEASURED[1] * focus if assumed else focus_error or 0.0))
        return np.asarray(np.sqrt(variance))

    def scale_error(self, f_number_error: float | None, focus_error: float | None) -> float:
        """Return the relative standard error of the scale of blur that follows from stated errors of the lenses."""
        foci = [1.0 / lens.focus_distance for lens in self.task.lenses]
        extent = max(foci) - min(foci)
        # The blurs of two frames differ in proportion to the difference of their foci, with sqrt(2) focus_error.
        by_foci = math.sqrt(2.0) * (focus_error or 0.0) / extent if extent else 0.0
        return math.hypot(f_number_error or 0.0, by_foci)

    @cached_property
    def _lens_derivatives(self) -> tuple[Array, Array]:
        """Vergences of a few candidates, and the derivatives at these vergences, (1 + frames, candidates)."""
        step, vergence = self.channels[0].step, self.task.vergence
        vergences = vergence[np.linspace(1, len(vergence) - 2, _DERIVATIVE_CANDIDATES).round().astype(int)]
        triples = self.task._replace(vergence=(vergences[:, None] + step * np.arange(-1.0, 2.0)).ravel())
        model = triples.model(self.light, 0, self.binning)
        stopped_lenses = [lens.stopped(lens.f_number * (1.0 + _CHANGE)) for lens in self.task.lenses]
        stopped_model = self.task._replace(vergence=vergences).model(self.light, 0, self.binning, stopped_lenses)
        changes = [step / _CHANGE * shifts(model, stopped_model)]
        # Central differences within triples of vergences, one step apart.
        slope, middle_model = 0.5 * (model.transfer[2::3] - model.transfer[::3]), model.at(slice(1, None, 3))
        for frame in range(len(stopped_lenses)):
            # Approximately, the transfer function depends only on the difference (vergence) - (focus vergence).
            transfer = middle_model.transfer.copy()
            transfer[:, frame] -= _CHANGE * slope[:, frame]
            changes.append(shifts(model, replace(middle_model, transfer=transfer)) / _CHANGE)
        return vergences, np.array(changes)

    @property
    def known(self) -> float:
        """Largest standard error of a known vergence, 1 / m."""
        nearest, farthest = self.task.between
        return MAX_KNOWN_ERROR * (1.0 / nearest - 1.0 / farthest)

    def mean_excess(self, binning: int) -> float:
        """Return the mean of (energy at the true depth) - (minimum energy) of pixels with this binning / variance."""
        return binning**2 / self._pixels

    def alias_misfit(
        self, images: Values, valid: NDArray[np.bool_], read: float, vergence: Values
    ) -> NDArray[np.float32]:
        """Return the misfit that aliases of binned pixels add to each block, of frames (frames, height, width).

        The frames are in electrons, `valid` is True for known pixels, `read` is the read noise of a pixel and
        `vergence` a map of blocks; NaN where this is NaN.
        """
        binning, block = self.binning, BLOCK
        if binning == 1:
            return np.where(np.isnan(vergence), vergence, 0.0).astype(np.float32)
        images = np.where(valid, images, images.mean(axis=(1, 2), where=valid, keepdims=True)).astype(np.float32)
        height, width = (side // block * block for side in images.shape[1:])
        frames = images[:, :height, :width]
        # In cosine transforms, pixels of these frequencies have aliases where squares of pixels are summed.
        f = [np.arange(side, dtype=np.float32) * np.float32(0.5 / side) for side in (height, width)]
        centred = np.arange(binning) - 0.5 * (binning - 1)
        box = [np.cos(2.0 * math.pi * axis[:, None] * centred).sum(axis=1, dtype=np.float32) for axis in f]
        aliased = ((f[0][:, None] > 0.5 / binning) | (f[1] > 0.5 / binning)) * box[0][:, None] * box[1]
        aliases = scipy.fft.idctn(
            scipy.fft.dctn(frames, axes=(1, 2), norm="ortho") * aliased, axes=(1, 2), norm="ortho"
        )
        parts = len(frames), height // block, block, width // block, block
        power, light = (np.reshape(each, parts).mean(axis=(0, 2, 4)) for each in (aliases**2, frames))
        variance = self.window_means(np.maximum(light, 0.0) + read**2)
        noise = variance * float(np.mean(aliased**2))  # of `power`
        ratio = np.maximum(self.window_means(power) - noise, 0.0) / (binning**2 * variance)
        return np.asarray(ratio * np.interp(vergence, *self._alias_gains), dtype=np.float32)

    @cached_property
    def _alias_gains(self) -> tuple[Array, Array]:
        """Vergences, and the ratio (misfit that aliases add) / (power of aliases relative to the noise of a pixel).

        Aliases of the frames are taken as independent, of the texture for which filters are made.
        """
        model = self.task.model(self.light, 0, self.binning)
        squares = residual_filters(model) ** 2
        aliases = model.noise - model.white[:, None]
        added = np.einsum("cpif,cif,f->c", squares, aliases, model.band.share)
        noise = np.einsum("cpif,i,f->c", squares, model.white, model.band.share)
        return model.vergence, added / noise * model.white.mean() / (aliases.mean(axis=1) @ model.band.share)

    def window_means(self, blocks: Array) -> Array:
        """Return weighted means of blocks, (rows, columns), over the window of each block."""
        weights = np.append(self._weights[:0:-1], self._weights)
        correlate = scipy.ndimage.correlate1d
        return np.asarray(correlate(correlate(blocks, weights, 0), weights, 1))

    def sharpen(self, *, refocus: bool = False, stream_filter: bool = False) -> None:
        """Compute tables of sharp and, if `refocus`, of refocused images.

        With `stream_filter` the tables use the small filter and the degree of the tables for depth.
        """
        task, tables = self.task, self.channels[0]
        taps, degree = (tables.taps, tables.degree) if stream_filter else (Taps.of(5), 12)
        max_vergence, min_vergence = (1.0 / distance for distance in task.between)
        with np.errstate(divide="ignore"):
            foci = (1.0 / np.linspace(min_vergence, max_vergence, _FOCI if refocus else 0)).tolist()
        for channel, spectrum in enumerate(task.spectra):
            model = task.model(self.light, channel)
            targets = [self._target(task.lenses[0].focused(distance), spectrum, model) for distance in foci]
            model = model.uncertain(tables.errors * self.binning / math.sqrt(self._pixels))
            self.images.append(SharpTables(model, taps, degree, targets))

    def stream(self, shape: tuple[int, int], *, images: bool = False) -> FocalStream:
        """Return the stream that estimates depth from frames of a shape, and sharp images of the first channel."""
        tables, rank = self.channels[0], self.rank
        residuals = np.zeros((len(self.channels), rank, *tables.basis.shape[1:]))
        forms = []
        # Channels of lower rank are padded with zeros.
        for channel, basis in zip(self.channels, residuals, strict=True):
            basis[: channel.rank] = channel.basis
            forms.append(channel.forms(rank))
        image_basis = self.images[0].basis if images else np.zeros((0, *tables.basis.shape[1:]))
        statistics = np.sum([channel.statistics() for channel in self.channels], axis=0)
        statistics[[1, 3, 5, 6, 7]] /= len(self.channels)  # the others are sums, as energies are
        return self._stream(
            shape, self.binning, tables.taps, residuals, image_basis, np.concatenate(forms, axis=1), statistics
        )

    def image_stream(self, shape: tuple[int, int], channel: int = 0) -> FocalStream:
        """Return the stream that computes sharp images of a channel from frames of a shape."""
        tables = self.images[channel]
        no_residuals = np.zeros((1, 0, *tables.basis.shape[1:]))
        return self._stream(shape, 1, tables.taps, no_residuals, tables.basis, np.zeros((0, 0)), np.zeros((8, 0)))

    def tables(self, white: float, offset: float, saturation: float) -> bytes:
        """Return tables of one channel and of sharp images in the format of cpp/include/lommel/focal/file.hpp."""
        channel, count = self.channels[0], len(self.task.vergence)
        images = self.images[0] if self.images else None
        taps, degree = (channel.taps, channel.degree) if images is None else (images.taps, images.degree)
        basis = np.zeros((0, *channel.basis.shape[1:])) if images is None else images.basis
        mixes = np.zeros((count, 0)) if images is None else self.factors(0, None)
        header = [
            0x464D4C4C,  # the letters LLMF, little-endian
            3,
            channel.binning,
            BLOCK // channel.binning,
            math.ceil(self.task.blur / channel.binning),
            channel.basis.shape[1],
            channel.degree,
            len(channel.taps.values) - 1,
            channel.rank,
            count,
            len(self._weights),
            degree,
            len(taps.values) - 1,
            len(basis),
        ]
        numbers = [*channel.taps.padded(), *taps.padded(), white, offset, min(saturation, 3e38)]
        numbers += self._numbers(channel.binning)
        statistics = channel.statistics()
        arrays = numbers, channel.basis, self._weights, channel.forms(channel.rank), statistics, basis, mixes
        return np.asarray(header, "<i4").tobytes() + b"".join(np.asarray(array, "<f4").tobytes() for array in arrays)

    def _numbers(self, binning: int) -> tuple[float, ...]:
        """Return the scalar parameters of a stream."""
        tables = self.channels[0]
        return (
            # The read-noise variance of a sum of binning^2 pixels is binning^2 read^2.
            (self.light.read * binning) ** 2,
            self._pixels / binning**2,
            float(tables.vergence[0]),
            tables.step,
            self._low,
            self._high,
            self.known / tables.step,
        )

    def _stream(
        self,
        shape: tuple[int, int],
        binning: int,
        taps: Taps,
        residuals: Array,
        images: Array,
        forms: Array,
        statistics: Array,
    ) -> FocalStream:
        task = self.task
        height, width = (side // binning for side in shape)
        block, blur = BLOCK // binning, math.ceil(task.blur / binning)
        sizes = height, width, binning, block, task.subdivision, blur, task.threads
        return FocalStream(
            sizes,
            _float32(taps.values),
            _float32(residuals),
            _float32(images),
            _float32(self._weights),
            _float32(forms),
            _float32(statistics),
            self._numbers(binning),
        )

    def factors(self, channel: int, lens: Lens | None) -> NDArray[np.float32]:
        """Return the weights of basis images in the sharp image of a channel, or in the image of `lens`."""
        return self._factors(channel, lens)

    def _factors_of(self, channel: int, lens: Lens | None) -> NDArray[np.float32]:
        images = self.images[channel]
        target = images.pixel if lens is None else self._target(lens, self.task.spectra[channel], images.model)
        return np.ascontiguousarray(images.mixes(target), dtype=np.float32)

    def _target(self, lens: Lens, spectrum: Spectrum, model: FocalModel) -> Array:
        """Return the transfer function of lens and pixel for each candidate."""
        curve = self.task.transfer(lens, self.task.vergence, spectrum, self.task.pixel)
        band = model.band
        # Square pixel: sinc(fx) sinc(fy), frequencies in cycles per pixel.
        return np.asarray(curve(np.hypot(band.fx, band.fy)) * (np.sinc(band.fx) * np.sinc(band.fy)))


def block_weights(window: float, block: int) -> tuple[Array, float]:
    """Return block weights for an rms width `window`, and the number of independent pixels."""
    # The variance of the window includes the variance of a block, side^2 / 12.
    rms = math.sqrt(max(window**2 - block**2 / 12.0, 0.04)) / block
    distances = np.arange(math.ceil(2.0 * rms) + 1)
    weights = np.exp(-0.5 * (distances / rms) ** 2)
    weights /= weights[0] + 2.0 * weights[1:].sum()
    squares = float(weights[0] ** 2 + 2.0 * (weights[1:] ** 2).sum()) / block
    # Along each axis, weights w have (sum w)^2 / sum w^2 independent pixels.
    return weights, 1.0 / squares**2


def _float32(values: ArrayLike) -> NDArray[np.float32]:
    return np.ascontiguousarray(values, dtype=np.float32)


def processors() -> int:
    """Return the number of processors this process may use."""
    import os

    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
