"""Tables and streams of one kind of frames, as live depth and depth from photographs share them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from typing import NamedTuple, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.cached import cached_property
from lommel.core.answers import DType
from lommel.core.engine import FocalScale, FocalStream
from lommel.estimation.focal_model import FocalLight, FocalModel, Spectrum, Transfer, transfer_curve
from lommel.imaging.focal_tables import SharpTables, Taps, candidates, focal_tables, shifts
from lommel.optics.lens import Lens
from lommel.recorded.noise import Noise

Frame = Values

MAGNIFICATIONS = ("registered", "lens")
"""How frames of different focus are magnified: alike, or as by a lens at their sensor distances."""


class DefocusKeywords(TypedDict, total=False):
    """Options of depth from defocus."""

    exposures: Sequence[float] | str | None
    magnification: str
    window: float
    saturation: float | None


@dataclass(frozen=True)
class DefocusOptions:
    """Options of depth from defocus, with their defaults.

    Parameters
    ----------
    exposures : sequence of float, optional
        Exposure of each image relative to the first, such as exposure time over squared f-number. By default the
        ratio of their means. "smooth", of :class:`lommel.imaging.LiveDepth` only: a ratio that changes over the image
        as a polynomial of second order, measured in each call, for frames of different vignetting.
    magnification : {"registered", "lens"}, default "registered"
        "registered": points are at the same pixels in all images. "lens": each image is magnified as by a thin lens
        at its sensor distance, and is resampled to the scale of the first, about the centre.
    window : float, default 4.0
        Rms width of the Gaussian windows in which depth is taken to be constant, pixels: 1 to 64, and 2 to 16 for
        :class:`lommel.imaging.LiveDepth`. Larger windows are more precise on flat surfaces, with less spatial
        resolution.
    saturation : float, optional
        Stored value from which on pixels are full, and ignored; by default the largest value of unsigned integers.
    """

    exposures: Sequence[float] | str | None = None
    magnification: str = "registered"
    window: float = 4.0
    saturation: float | None = None


def relative_exposures(given: Sequence[float], count: int) -> tuple[float, ...]:
    """Return exposures over the first; TypeError or ValueError unless they are `count` numbers above 0."""
    values = validation.real_array("exposures", given, least=1e-6, most=1e6)
    if values.shape != (count,):
        raise ValueError(f"exposures must be {count} numbers > 0, one for each lens, got {validation.shown(given)}")
    return tuple((values / values[0]).tolist())


class Registration:
    """Frames at the scale of the first, about their middle.

    Parameters
    ----------
    magnification : {"registered", "lens"}
        How they differ.
    lenses : sequence of Lens
    size : (int, int)
        Height and width, pixels.
    threads : int

    Attributes
    ----------
    scales : tuple of float
        Pitch that each frame has since, in pixels.
    """

    def __init__(self, magnification: str, lenses: Sequence[Lens], size: tuple[int, int], threads: int) -> None:
        self.scales = (1.0,) * len(lenses)
        if validation.choice("magnification", magnification, MAGNIFICATIONS) == "lens":
            # The image of a direction is as large as the sensor is distant from the pupil.
            self.scales = tuple(lens.sensor_distance / lenses[0].sensor_distance for lens in lenses)
        self._scales = [FocalScale(*size, scale, threads) if scale != 1.0 else None for scale in self.scales]
        self._made = [None if one is None else np.empty(size, dtype=np.float32) for one in self._scales]

    def __bool__(self) -> bool:
        """Whether any frame is resampled."""
        return any(self._scales)

    def __call__(self, frames: list[Frame], full: float, known: NDArray[np.uint8] | None) -> list[Frame]:
        """Return frames, in arrays that the next call overwrites; NaN where they depend on unknown pixels."""
        made = list(frames)
        for k, (scale, out) in enumerate(zip(self._scales, self._made, strict=True)):
            if scale is not None and out is not None:
                scale(frames[k], full, known, out)
                made[k] = out
        return made


class FrameForm:
    """What frames of one camera have in common; TypeError or ValueError that names the argument at fault.

    Parameters
    ----------
    shape : (int, int) or (int, int, int)
        Height, width, and channels if any.
    noise : Noise
        With numbers, not maps.
    saturation : float or None
        Value from which on pixels are full, as is the largest of unsigned integers.
    known : array_like of bool, or None
        Pixels of the sensor that are not broken.
    """

    def __init__(
        self, shape: tuple[int, ...], noise: Noise, saturation: float | None, known: ArrayLike | None
    ) -> None:
        if not isinstance(shape, Sequence) or len(shape) not in (2, 3):
            raise TypeError(f"shape must be height and width, and channels if any, got {validation.shown(shape)}")
        height, width = (
            validation.integer(f"shape[{k}]", shape[k], least=64, most=validation.MAX_SIDE) for k in range(2)
        )
        self.size = height, width
        self.channels = validation.integer("shape[2]", shape[2], least=1, most=16) if len(shape) == 3 else 1
        if validation.instance("noise", noise, Noise).excess != 1.0:
            raise ValueError(
                f"noise must have no excess for live frames, got excess={noise.excess:g}: give noise.poisson, whose "
                "electrons are those of the light over it"
            )
        for name in ("white", "read", "offset"):
            if not isinstance(getattr(noise, name), float | None):
                raise ValueError(
                    f"noise.{name} must be a number for live frames, not a map of the sensor: take its median, and "
                    "name pixels that differ much in known="
                )
        self.white, self.read, self.offset = float(noise.white or 1.0), float(noise.read), float(noise.offset)
        self._saturation = math.inf if saturation is None else validation.real("saturation", saturation)
        self._known = None if known is None else self._mask(known)

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of frames."""
        return self.size if self.channels == 1 else (*self.size, self.channels)

    @property
    def masked(self) -> bool:
        """Whether some pixels of the sensor are broken."""
        return self._known is not None

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

    def full(self, dtype: DType) -> float:
        """Return the value at which pixels are saturated."""
        return min(self._saturation, float(np.iinfo(dtype).max) if dtype.kind == "u" else math.inf)

    def known(self, frames: Sequence[Frame], full: float, given: ArrayLike | None) -> NDArray[np.uint8] | None:
        """Return the known pixels of the sensor and of frames, in all channels and by mask; None if all are."""
        masks = [] if self._known is None else [self._known]
        if given is not None:
            masks.append(self._mask(given))
        # A channel at saturation makes the depth of its pixel unknown in all channels.
        if self.channels > 1:
            for frame in frames:
                with np.errstate(invalid="ignore"):
                    masks.append(np.asarray((frame < full).all(axis=2), dtype=np.bool_).view(np.uint8))
        if len(masks) <= 1:
            return masks[0] if masks else None
        return np.asarray(np.logical_and.reduce(masks)).view(np.uint8)

    def _mask(self, given: ArrayLike) -> NDArray[np.uint8]:
        mask = validation.array("known", given)
        if mask.shape != self.size or mask.dtype != np.bool_:
            raise ValueError(f"known must be of bool and of shape {self.size}, got {mask.dtype} of {mask.shape}")
        return np.ascontiguousarray(mask).view(np.uint8)

    def image(self, out: NDArray[np.float32] | None) -> NDArray[np.float32]:
        """Return the array an image is written to; ValueError unless `out` is a frame of float32."""
        if out is None:
            return np.empty(self.shape, dtype=np.float32)
        if out.shape != self.shape or out.dtype != np.float32 or not out.flags.c_contiguous:
            raise ValueError(f"out must be a contiguous array of float32 of shape {self.shape}")
        return out


BLOCK = 4
"""Pixels a side of the blocks that energies are summed over."""

CONTRAST = 0.2
"""Of the texture that filters are designed for: the rms over the mean of structures of 2 to 128 pixels."""

_USUAL = 61  # least number of candidates by default
_STEP, _LARGEST_STEP = 0.75, 2.0  # radians of defocus from one candidate to the next
_EDGE = 0.3  # or pixels of movement of the blur's edge, where that is more
_MOST_RANK = 48  # largest number of images whose products make energies
_KNOWN = 0.17  # of the range of vergence: largest standard error of a known depth
_MARGIN = 0.02  # of the range, by which the vergence of what is known may lie beyond it
_CHANGE = 0.01  # relative change of f-numbers, and of candidates, for derivatives
_SOME = 15  # candidates at which these derivatives are computed
_FOCI = 5  # foci that the basis of refocused images is made from
_MOST_WEIGHTS = 30  # largest number of weights on a side of a window


class FocalTask(NamedTuple):
    """Frames and the request for depths: blocks of `block` pixels a side, with `fine` depths along either axis."""

    lenses: Sequence[Lens]
    vergence: Array
    spectra: Sequence[Spectrum]  # of each channel
    pixel: float
    between: tuple[float, float]
    window: float
    block: int
    fine: int
    threads: int
    transfer: Transfer = transfer_curve
    scales: tuple[float, ...] = ()  # pixel pitches of resampled frames, in pixels

    def model(
        self, light: FocalLight, channel: int = 0, binning: int = 1, lenses: Sequence[Lens] | None = None
    ) -> FocalModel:
        """Return the model of a channel, in squares of pixels, of these lenses or others."""
        return FocalModel.of(
            lenses or self.lenses,
            self.vergence,
            self.spectra[channel],
            self.pixel,
            light,
            transfer=self.transfer,
            binning=binning,
            scales=self.scales,
        )


def ranged(
    between: tuple[float, float], lenses: Sequence[Lens], pixel: float, count: int | None, most: int
) -> tuple[tuple[float, float], Array]:
    """Return a range of distances and the vergence of its candidates; TypeError or ValueError."""
    if not isinstance(between, Sequence | np.ndarray) or len(between) != 2:
        raise TypeError(f"between must be the nearest and the farthest distance, got {validation.shown(between)}")
    near = validation.real("between[0]", between[0], above=0.0, unit="metres")
    far = validation.real("between[1]", between[1], above=0.0, infinite=True, unit="metres")
    if not near < far:
        raise ValueError(f"between must be the nearest and the farthest distance, got {near:g} and {far:g} m")
    span = 0.0
    for lens in lenses:
        # The edge of the blur moves by 4 lambda N / pi a radian.
        wide = 4.0 * lens.wavelength * lens.working_f_number / (math.pi * pixel)
        span = max(span, float(abs(np.diff(lens.defocus([near, far]))[0])) * min(1.0, wide / _EDGE))
    if count is None:
        count = max(_USUAL, math.ceil(span / _STEP) + 1)
        if count > most:
            raise ValueError(
                f"between spans defocus for which it takes {count} candidates, more than {most}: name nearer limits, "
                "stop down, or bin pixels"
            )
    else:
        count = validation.integer("candidates", count, least=max(9, math.ceil(span / _LARGEST_STEP) + 1), most=most)
    return (near, far), candidates((near, far), count + -(count - 1) % 4, lenses)


class FocalEngine:
    """Tables for one level of light; streams for frames of any shape.

    Parameters
    ----------
    task : FocalTask
    light : FocalLight
        Of a pixel of each channel.
    """

    def __init__(self, task: FocalTask, light: FocalLight) -> None:
        self.task, self.light = task, light
        self._weights, self._pixels = block_weights(task.window, task.block)
        blocks = self._weights, task.block
        first = focal_tables(partial(task.model, light, 0), light, blocks)
        rest = [
            focal_tables(partial(task.model, light, channel), light, blocks, like=first)
            for channel in range(1, len(task.spectra))
        ]
        self.channels = [first, *rest]
        if self.rank > _MOST_RANK:
            near, far = task.between
            raise ValueError(
                f"between must span less defocus: depths from {near:g} to {far:g} m take {self.rank} filters, more "
                f"than {_MOST_RANK}; name nearer limits, stop down, or bin pixels"
            )
        self._low, self._high = ((1.0 / each - first.vergence[0]) / first.step for each in task.between[::-1])
        self._factors = lru_cache(maxsize=16)(self._factors_of)
        self.images: list[SharpTables] = []

    @property
    def binning(self) -> int:
        """Pixels a side of the squares that frames are filtered in."""
        return self.channels[0].binning

    @property
    def rank(self) -> int:
        """Number of images whose products make all energies of a channel."""
        return max(one.rank for one in self.channels)

    @property
    def blur(self) -> float:
        """Largest radius of the blur, pixels."""
        ends = np.asarray(self.task.between)
        return max(float(lens.pupil(ends).geometric_radius().max()) for lens in self.task.lenses) / self.task.pixel

    @property
    def reach(self) -> int:
        """Distance from a pixel within which its depth depends on the frames, pixels."""
        tables = self.channels[0]
        filters = tables.degree * (len(tables.taps.values) - 1) * tables.binning
        return filters + math.ceil(self.blur) + (len(self._weights) + 1) * self.task.block

    @property
    def design_error(self) -> float:
        """Largest bias of the filters by themselves within the range, in standard errors of a window."""
        inner = slice(max(0, math.floor(self._low)), math.ceil(self._high) + 1)
        found = [np.abs(one.bias / one.errors)[inner].max() for one in self.channels]
        # Tables give biases and errors of a pixel; the error of a window of n independent pixels is sqrt(n) less.
        return float(max(found)) * math.sqrt(self._pixels) / self.binning

    def by_lenses(self, vergence: Array) -> Array:
        """Return how vergences that are found, of any shape, change with those stated: (1 + frames, *that shape).

        First with the logarithm of all f-numbers, 1 / m, then with the vergence in focus of each frame.
        """
        at, changes = self._by_lenses
        return np.stack([np.interp(vergence, at, each) for each in changes])

    @cached_property
    def _by_lenses(self) -> tuple[Array, Array]:
        """Derivatives at some candidates, (1 + frames, candidates), and before them the vergence of these."""
        step, every = self.channels[0].step, self.task.vergence
        at = every[np.linspace(1, len(every) - 2, _SOME).round().astype(int)]
        threes = self.task._replace(vergence=(at[:, None] + step * np.arange(-1.0, 2.0)).ravel())
        model = threes.model(self.light, 0, self.binning)
        closed = [lens.stopped(lens.f_number * (1.0 + _CHANGE)) for lens in self.task.lenses]
        other = self.task._replace(vergence=at).model(self.light, 0, self.binning, closed)
        found = [step / _CHANGE * shifts(model, other)]
        # Central differences: groups of three candidates, one step apart.
        slope, own = 0.5 * (model.transfer[2::3] - model.transfer[::3]), model.at(slice(1, None, 3))
        for frame in range(len(closed)):
            # The transfer function is that of the difference of the vergence from that in focus, but for 1 - f u.
            transfer = own.transfer.copy()
            transfer[:, frame] -= _CHANGE * slope[:, frame]
            found.append(shifts(model, replace(own, transfer=transfer)) / _CHANGE)
        return at, np.array(found)

    @property
    def known(self) -> float:
        """Largest standard error of a known vergence, 1 / m."""
        near, far = self.task.between
        return _KNOWN * (1.0 / near - 1.0 / far)

    @property
    def of_least(self) -> float:
        """Mean amount by which the least of an energy is below that of the true depth."""
        return self.binning**2 / self._pixels

    def averaged(self, blocks: Array) -> Array:
        """Return means of blocks, (rows, columns), over windows."""
        from scipy.ndimage import correlate1d

        along = np.append(self._weights[:0:-1], self._weights)
        return np.asarray(correlate1d(correlate1d(blocks, along, 0), along, 1))

    def sharpen(self, *, refocus: bool = False, shared: bool = False) -> None:
        """Compute tables of sharp images, and of other foci; with the filters of depth if a stream is shared."""
        task, tables = self.task, self.channels[0]
        taps, degree = (tables.taps, tables.degree) if shared else (Taps.of(5), 12)
        near, far = (1.0 / each for each in task.between)
        with np.errstate(divide="ignore"):
            foci = (1.0 / np.linspace(far, near, _FOCI if refocus else 0)).tolist()
        for channel, spectrum in enumerate(task.spectra):
            model = task.model(self.light, channel)
            targets = [self._target(task.lenses[0].focused(each), spectrum, model) for each in foci]
            model = model.uncertain(tables.errors * self.binning / math.sqrt(self._pixels))
            self.images.append(SharpTables(model, taps, degree, targets))

    def stream(self, shape: tuple[int, int], *, images: bool = False) -> FocalStream:
        """Return the stream that finds depth in frames of a shape, and makes images of the first channel."""
        tables, rank = self.channels[0], self.rank
        residuals = np.zeros((len(self.channels), rank, *tables.basis.shape[1:]))
        forms = []
        # Channels have different ranks: all are filled up with zeros to the largest.
        for one, basis in zip(self.channels, residuals, strict=True):
            basis[: one.rank] = one.basis
            forms.append(one.forms(rank))
        kept = self.images[0].basis if images else np.zeros((0, *tables.basis.shape[1:]))
        statistics = np.sum([one.statistics() for one in self.channels], axis=0)
        statistics[[1, 3]] /= len(self.channels)
        return self._stream(
            shape, self.binning, tables.taps, residuals, kept, np.concatenate(forms, axis=1), statistics
        )

    def image_stream(self, shape: tuple[int, int], channel: int = 0) -> FocalStream:
        """Return the stream that makes sharp images of a channel of frames of a shape."""
        tables = self.images[channel]
        none = np.zeros((1, 0, *tables.basis.shape[1:]))
        return self._stream(shape, 1, tables.taps, none, tables.basis, np.zeros((0, 0)), np.zeros((5, 0)))

    def tables(self, white: float, offset: float, full: float) -> bytes:
        """Return tables of one channel and of sharp images, as cpp/include/lommel/focal/file.hpp reads them."""
        one, count = self.channels[0], len(self.task.vergence)
        images = self.images[0] if self.images else None
        taps, degree = (one.taps, one.degree) if images is None else (images.taps, images.degree)
        kept = np.zeros((0, *one.basis.shape[1:])) if images is None else images.basis
        mixes = np.zeros((count, 0)) if images is None else self.factors(0, None)
        whole = [
            0x464D4C4C,  # the letters LLMF, little-endian
            1,
            one.binning,
            self.task.block // one.binning,
            math.ceil(self.blur / one.binning),
            one.basis.shape[1],
            one.degree,
            len(one.taps.values) - 1,
            one.rank,
            count,
            len(self._weights),
            degree,
            len(taps.values) - 1,
            len(kept),
        ]
        numbers = [*one.taps.padded(), *taps.padded(), white, offset, min(full, 3e38), *self._numbers(one.binning)]
        arrays = (numbers, one.basis, self._weights, one.forms(one.rank), one.statistics(), kept, mixes)
        return np.asarray(whole, "<i4").tobytes() + b"".join(np.asarray(each, "<f4").tobytes() for each in arrays)

    def _numbers(self, binning: int) -> tuple[float, ...]:
        """Return the scalar parameters of a stream."""
        tables, margin = self.channels[0], _MARGIN * len(self.task.vergence)
        return (
            # Sums over binning^2 pixels have binning^2 times the variance of reading.
            (self.light.read * binning) ** 2,
            self._pixels / binning**2,
            float(tables.vergence[0]),
            tables.step,
            self._low - margin,
            self._high + margin,
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
        sizes = height, width, binning, task.block // binning, task.fine, math.ceil(self.blur / binning), task.threads
        return FocalStream(
            sizes,
            _single(taps.values),
            _single(residuals),
            _single(images),
            _single(self._weights),
            _single(forms),
            _single(statistics),
            self._numbers(binning),
        )

    def factors(self, channel: int, lens: Lens | None) -> NDArray[np.float32]:
        """Return the weights that mix basis images to a sharp one of a channel, or to that of a lens."""
        return self._factors(channel, lens)

    def _factors_of(self, channel: int, lens: Lens | None) -> NDArray[np.float32]:
        images = self.images[channel]
        target = images.pixel if lens is None else self._target(lens, self.task.spectra[channel], images.model)
        return np.ascontiguousarray(images.mixes(target), dtype=np.float32)

    def _target(self, lens: Lens, spectrum: Spectrum, model: FocalModel) -> Array:
        """Return the transfer function of a lens for each candidate, with that of the pixel."""
        curve = self.task.transfer(lens, self.task.vergence, spectrum, self.task.pixel)
        band = model.band
        # A square pixel's transfer function, sinc fx sinc fy, with frequencies in cycles a pixel.
        return np.asarray(curve(np.hypot(band.fx, band.fy)) * (np.sinc(band.fx) * np.sinc(band.fy)))


def block_weights(window: float, block: int) -> tuple[Array, float]:
    """Return block weights from the middle on, for a window of an rms width in pixels, and its independent pixels."""
    # The variance of a block's own width, side^2 / 12, is part of the window's.
    rms = math.sqrt(max(window**2 - block**2 / 12.0, 0.04)) / block
    away = np.arange(min(math.ceil(2.0 * rms), _MOST_WEIGHTS) + 1)
    weights = np.exp(-0.5 * (away / rms) ** 2)
    weights /= weights[0] + 2.0 * weights[1:].sum()
    along = float(weights[0] ** 2 + 2.0 * (weights[1:] ** 2).sum()) / block
    # Independent pixels of weights w: (sum w)^2 / sum w^2, along each axis.
    return weights, 1.0 / along**2


def _single(values: ArrayLike) -> NDArray[np.float32]:
    return np.ascontiguousarray(values, dtype=np.float32)


def processors() -> int:
    """Return the number of processors this process may use."""
    import os

    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
