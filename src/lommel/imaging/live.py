"""Depth maps with standard errors, and sharp images, from frames at video rate."""

from __future__ import annotations

import copy
import math
from collections.abc import Sequence
from dataclasses import dataclass
from os import PathLike
from typing import Annotated, Any, Literal, NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import atomic, validation
from lommel.base.arrays import Array, Values
from lommel.base.options import listed
from lommel.estimation.focal_model import FocalLight, FocalModel
from lommel.imaging.defocus_depth import DefocusOptions
from lommel.imaging.defocus_verdict import DefocusVerdict, judge_frames
from lommel.imaging.focal_engine import (
    BLOCK,
    CONTRAST,
    FocalEngine,
    FocalTask,
    FrameForm,
    Magnified,
    Registration,
    checked_range,
    processors,
)
from lommel.imaging.focal_tables import SharpTables, Taps
from lommel.imaging.pair_noise import EstimatedNoise, residual_variance, starting_noise
from lommel.optics.lens import Lens, pixel_of
from lommel.recorded.noise import Noise

_MAX_CANDIDATES_SHARPEN = 961  # largest number of candidate depths of LiveSharpen
_ELECTRONS = 5000.0  # default mean number of electrons per pixel


class LiveSharpen:
    """Sharp images of single frames whose depth is known, by one filter pass.

    Parameters
    ----------
    lens : Lens
        Lens at its focus distance and f-number, with a circular or annular aperture and radially symmetric
        aberrations.
    pixel : float
        Pixel pitch, metres.
    between : (float, float)
        Nearest and farthest distance, metres; the farthest may be infinite.
    noise : Noise
        Noise of the frames, with numbers (not maps) for `white`, `read` and `offset`.
    shape : (int, int) or (int, int, int)
        Height and width of the frames, at least 64 pixels each, and optionally the number of channels.
    light : float, default 5000
        Mean number of electrons per pixel. A smaller number yields a smoother image.
    saturation : float, optional
        Value at and above which pixels are saturated; by default the largest value of unsigned integers. Saturated
        pixels are filled from their neighbours.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range or of another shape, or if the lens is not radially symmetric.

    Notes
    -----
    Each distance has a Wiener filter, for textures whose power spectrum falls as 1 / frequency^2, computed as a
    polynomial of one small filter (see :class:`lommel.imaging.LiveDepth`). Filters keep the mean of the image. Blur
    that is wider than the filters is removed only in part.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.35, wavelength=540e-9)
    >>> sharpen = lm.imaging.LiveSharpen(
    ...     lens, 4e-6, between=(1.2, 2.0), noise=lm.Noise(read=3), shape=(64, 96), light=1000, saturation=4095
    ... )
    >>> out = np.empty((64, 96), np.float32)  # for all frames, where allocation would take too long
    >>> sharpen(np.full((64, 96), 1000, np.uint16), 1.7, out=out).round(3).max()
    np.float32(1000.0)
    """

    def __init__(
        self,
        lens: Lens,
        pixel: float,
        *,
        between: tuple[float, float],
        noise: Noise,
        shape: tuple[int, ...],
        light: float = _ELECTRONS,
        saturation: float | None = None,
    ) -> None:
        pitch = pixel_of([lens], pixel)
        self._form = form = FrameForm(shape, noise, saturation)
        mean = validation.real("light", light, least=1.0, below=1e9)
        spectrum = ((lens.wavelength, 1.0),)
        self._between, self._vergence = checked_range(between, [lens], pitch, _MAX_CANDIDATES_SHARPEN)
        model = FocalModel.of([lens], self._vergence, spectrum, pitch, FocalLight(mean, form.read, (1.0,), CONTRAST))
        self._tables = tables = SharpTables(model, Taps.of(5), 12)
        self._factors = _float32(tables.mixes(tables.pixel))
        self._stream = tables.stream(form.size, processors())
        self._gains = _float32([[form.white, 0.0, 0.0, 0.0, 0.0, 0.0]])

    def __repr__(self) -> str:
        nearest, farthest = self._between
        size = " x ".join(map(str, self._form.shape))
        return f"<LiveSharpen of frames of {size}, {nearest:g} to {farthest:g} m: {len(self._tables.basis)} images>"

    def __call__(
        self, frame: Values, depth: float | ArrayLike, out: NDArray[np.float32] | None = None
    ) -> NDArray[np.float32]:
        """Return the sharp image of a frame, electrons.

        Parameters
        ----------
        frame : ndarray, shape (height, width) or (height, width, channels)
            Frame of uint8, uint16 or floats; NaN marks unknown pixels.
        depth : float or array_like, shape (height, width) or (height // 4, width // 4)
            Distance in metres: one number, a map of pixels, or a map of blocks of 4 x 4 pixels. Between block centres
            1 / distance is interpolated linearly.
        out : ndarray of float32, of the shape of a frame, optional
            Array for the result.

        Raises
        ------
        TypeError, ValueError
            If the frame or `out` is of another shape or type, or `depth` is of another shape, NaN, or not above 0.
        """
        stored = self._form.checked("frame", frame)
        places, side = self._places(depth)
        limit = self._form.saturation(stored.dtype)
        image = self._form.image(out)
        if self._form.channels == 1:
            self._stream.take([stored], self._gains, self._form.offset, limit, None)
            self._stream.mix(places, side, self._factors, image)
            return image
        channel = np.empty(self._form.size, dtype=np.float32)
        for c in range(self._form.channels):
            plane = np.ascontiguousarray(stored[..., c])
            self._stream.take([plane], self._gains, self._form.offset, limit, None)
            self._stream.mix(places, side, self._factors, channel)
            image[..., c] = channel
        return image

    def _places(self, depth: float | ArrayLike) -> tuple[NDArray[np.float32], int]:
        """Return depths as positions between candidates, and the side in pixels of the block for each position."""
        with np.errstate(over="ignore"):
            metres = np.asarray(depth, dtype=np.float32)
        height, width = self._form.size
        sides = {(): min(height, width), (height, width): 1, (height // BLOCK, width // BLOCK): BLOCK}
        # `sides` maps the shape of a depth map to the side of its blocks, in pixels.
        if metres.shape not in sides:
            raise ValueError(
                f"depth must be a number, or have the shape {(height, width)} or "
                f"{(height // BLOCK, width // BLOCK)}, got {metres.shape}"
            )
        if not metres.min() > 0.0:  # also if the minimum is NaN
            raise ValueError(f"depth must be > 0 metres everywhere, got {metres[~(metres > 0.0)].flat[0]}")
        start, step = np.float32(self._vergence[0]), np.float32(self._vergence[1] - self._vergence[0])
        # In place: for a map of pixels a temporary array would take as long as the filters.
        places = np.divide(np.float32(1.0) / step, np.atleast_2d(metres), order="C")
        places -= start / step
        return places, sides[metres.shape]


def _float32(values: ArrayLike) -> NDArray[np.float32]:
    return np.ascontiguousarray(values, dtype=np.float32)


_LEVELS = (500.0, 5000.0, 50_000.0)  # mean electrons per pixel for which tables are computed by default
_MAX_CANDIDATES = 241  # largest number of candidate depths of LiveDepth
_CELLS = 8  # number of parts of a frame along each side; light is summed in each part
_MIN_MEAN = 0.05  # mean of a frame / mean of the brightest frame, below which the frame counts as black
_MAX_RATIO = 2.0  # largest ratio of exposures: the tables are for equal ones


@dataclass(frozen=True, eq=False, repr=False)
class LiveDepthMap:
    """Depth map in blocks of 4 x 4 pixels; the next call of LiveDepth overwrites its arrays.

    Attributes
    ----------
    depth : ndarray of float32, shape (height // 4, width // 4)
        Distance from the lens, metres; NaN where depth is unknown.
    errors : ndarray of float32
        Standard error of `depth`, metres, of noise alone; inf where depth is unknown. Errors of the lens add that of
        ``LiveDepth.verdict().lens_error``.
    misfit : ndarray of float32
        Residual difference of the frames at the estimated depth, relative to noise: 1 if registration and noise are
        as stated. Larger values indicate motion, misregistration or depth edges. Values below 0.7 indicate overstated
        noise or denoised frames.
    exposures : tuple of float
        Exposure of each frame relative to the first, as measured.
    light : float
        Mean number of electrons per pixel in the first frame.
    """

    depth: NDArray[np.float32]
    errors: NDArray[np.float32]
    misfit: NDArray[np.float32]
    exposures: tuple[float, ...]
    light: float

    @property
    def known(self) -> float:
        """Fraction of the blocks whose depth is known."""
        return float(np.isfinite(self.errors).mean())

    def __repr__(self) -> str:
        inner = np.isfinite(self.errors)
        if not inner.any():
            return "<LiveDepthMap: no depth is known>"
        low, high = np.percentile(self.depth[inner], [5.0, 95.0])
        return (
            f"<LiveDepthMap: known at {100.0 * self.known:.3g} %, {low:.4g} m to {high:.4g} m (5 to 95 %), "
            f"+- {1e3 * np.median(self.errors[inner]):.3g} mm of noise, "
            f"misfit {np.nanmedian(self.misfit[inner]):.2f}>"
        )


def _light(name: str, value: float | Sequence[float]) -> tuple[float, ...]:
    """Return levels of light in ascending order."""
    values = validation.real_array(name, value, least=1.0, most=1e9)
    if values.ndim > 1 or not 1 <= values.size <= 16:
        raise ValueError(f"{name} must be one number or a sequence of 1 to 16 numbers, got shape {values.shape}")
    return tuple(sorted(set(np.atleast_1d(values).tolist())))


@dataclass(frozen=True, kw_only=True)
class LiveDepthOptions(Magnified):
    """Options of :class:`lommel.imaging.LiveDepth`.

    Parameters
    ----------
    exposures : {"uniform", "smooth"}, default "uniform"
        Exposures of the frames relative to the first, measured in each call: "uniform": the ratio of the mean values.
        "smooth": a polynomial of second order over the image, for frames with different vignetting.
    saturation : float, optional
        Value at and above which pixels are saturated and ignored, such as 4095 in frames of 12 bits; by default the
        largest unsigned integer.
    light : float or sequence of float, optional
        Mean electrons per pixel for which tables are computed; by default 500, 5000 and 50 000. The tables nearest to
        the light of a frame are used. Light that differs by a factor of up to three hardly increases errors.
    sharp, refocus : bool, default False
        `sharp` prepares tables for :meth:`LiveDepth.sharp`; `refocus` for this and :meth:`LiveDepth.refocus`.
    """

    exposures: Literal["uniform", "smooth"] = "uniform"
    saturation: float | None = None
    light: Annotated[tuple[float, ...] | None, _light] = None
    sharp: bool = False
    refocus: bool = False


@listed(LiveDepthOptions)
class LiveDepth:
    """Depth maps in blocks of 4 x 4 pixels, at video rate, from frames that differ in focus.

    Parameters
    ----------
    lenses : sequence of Lens
        Lens of each frame, at its focus distance and f-number; two or more. Circular or annular apertures and
        radially symmetric aberrations only.
    pixel : float
        Pixel pitch, metres.
    between : (float, float)
        Nearest and farthest distance, metres; the farthest may be infinite.
    noise : Noise, optional
        Noise of the frames, with numbers (not maps) for `white`, `read` and `offset`. For frames in counts, `white`
        is the gain in electrons per count. By default it is estimated from the first frames, without offset.
    shape : (int, int) or (int, int, int)
        Height and width of the frames, at least 64 pixels each, and optionally the number of channels, which are
        summed to estimate depth.
    options : LiveDepthOptions, optional
        All options below in one object; keywords override it.
    {options}

    Attributes
    ----------
    noise : Noise or None
        Noise of the frames, as stated or as estimated from the first ones; None before these, when there are no
        tables either.
    binning : tuple of int
        Side, in pixels, of the squares that are summed before filtering, for each level of `light`.
    rank : tuple of int
        Number of filtered images, from whose products the energies are computed, for each level of `light`.
    design_error : float
        Largest bias of depth due to the filter approximation, within the range, in standard errors of a window.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range or of another shape, if a lens is not radially symmetric, or if the range spans
        too much defocus for the largest number of filters.

    Notes
    -----
    Y_1 and Y_2 are the spectra of two frames, h_1 and h_2 the transfer functions of lens and pixel at a depth. At the
    true depth the residual ``h_2 Y_1 - h_1 Y_2`` is noise, whatever the texture; aliases of the texture are treated
    as noise. The energy is the mean square of the residual over a window. Residuals are computed as polynomials of
    one small filter, and energies as quadratic forms of a few images (see the page on live depth). The standard error
    follows from the curvature of the energy, the noise and the window; it grows with the misfit, with the slope of
    the depth map and near depth edges. Depth is unknown where another depth has almost the same energy, which is
    frequent with periodic textures, where it is outside of `between`, where the standard error exceeds 17 % of the
    range in 1 / distance (4 % where less than half of the blocks within 16 pixels are known), and where half of a
    window or more is within the blur of the border or of unknown pixels. The depth of a block is that of the texture
    within 16 pixels: a plain area beside an object has the depth of the object, or none, up to 16 pixels beyond its
    blurred edge.

    :meth:`verdict` tests registration, noise and the size of blur. It cannot detect exchanged frames, or an error
    that both focus distances share.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.35, wavelength=540e-9)
    >>> live = lm.imaging.LiveDepth(
    ...     [lens, lens.focused(1.8)], 4e-6, between=(1.2, 2.0), noise=lm.Noise(read=3), shape=(96, 96), light=5000
    ... )
    >>> live
    <LiveDepth of 2 frames of 96 x 96, 1.2 to 2 m: pixels of 1, 6 images, for 5000 electrons>
    """

    def __init__(
        self,
        lenses: Sequence[Lens],
        pixel: float,
        *,
        between: tuple[float, float],
        noise: Noise | None = None,
        shape: tuple[int, ...],
        options: LiveDepthOptions | None = None,
        **given: Any,
    ) -> None:
        o = LiveDepthOptions.of("LiveDepth", options, given)
        pitch = pixel_of(lenses, pixel)
        if len(lenses) < 2:
            raise ValueError(f"lenses must be two or more, of frames that differ in focus; got {len(lenses)}")
        self._form = form = FrameForm(shape, Noise(read=0.0) if noise is None else noise, o.saturation)
        self._options, self._estimates, self._levels, self._excess = o, noise is None, list[_Level](), 1.0
        self._smooth, count = o.exposures == "smooth", processors()
        spectrum = ((lenses[0].wavelength, 1.0),)
        self._between, vergence = checked_range(between, lenses, pitch, _MAX_CANDIDATES)
        self._registered = Registration(o.magnification, lenses, form.size, count)
        scales = self._registered.scales
        self._task = FocalTask(lenses, vergence, [spectrum], pitch, self._between, 1, count, scales=scales)
        self.noise: Noise | None = None
        if noise is not None:
            self._prepare(noise)
        blocks = self._form.size[0] // BLOCK, self._form.size[1] // BLOCK
        # Every call writes to these arrays: allocation would take too long at video rate.
        self._depth, self._errors, self._misfit = (np.empty(blocks, dtype=np.float32) for _ in range(3))
        self._positions = np.zeros(blocks, dtype=np.float32)
        self._sums = np.zeros((len(lenses) + 1, _CELLS, _CELLS))
        self._gains = np.zeros((len(lenses), 6), dtype=np.float32)
        self._lenses = tuple(lenses)
        self._planes = (
            [np.empty(self._form.size, dtype=np.float32) for _ in lenses] if self._form.channels > 1 else None
        )
        self._refocus = o.refocus
        self._last: _Call | None = None

    def __getstate__(self) -> dict[str, object]:
        """Return the attributes without frames, which copies and pickles have none of."""
        return vars(self) | {"_last": None}

    def __copy__(self) -> Self:
        # Every object has its own arrays, which calls overwrite.
        return copy.deepcopy(self)

    def _prepare(self, noise: Noise, light: tuple[float, ...] = ()) -> None:
        """Compute the tables for a noise, for mean electrons per pixel by default as in the options."""
        o = self._options
        self.noise, self._form = noise, FrameForm(self._form.shape, noise, o.saturation)
        # Depth is estimated from the sum of the channels: their read-noise variances add.
        read, ratios = self._form.read * math.sqrt(self._form.channels), (1.0,) * len(self._task.lenses)
        self._levels = [
            _Level(self._task, FocalLight(mean, read, ratios, CONTRAST), self._form, o.sharp or o.refocus, o.refocus)
            for mean in light or o.light or (electrons * self._form.channels for electrons in _LEVELS)
        ]

    def estimate_noise(self, *versions: Sequence[Values], known: Values | None = None) -> int:
        """Estimate the noise by the finest details and the residual of frames, and compute the tables for it.

        A call of a LiveDepth object without noise does it with its frames.

        Parameters
        ----------
        *versions : sequence of ndarray
            The frames, and the same ones processed otherwise, such as with equalized rows.
        known : ndarray of bool, shape (height, width), optional
            True for pixels that are valid in these frames.

        Returns
        -------
        int
            Index of the version whose residual is least: the noise is that of this one.

        Raises
        ------
        TypeError, ValueError
            As a call with the frames; if all pixels have one value, or few are known.
        """
        stored, saturation, mask = self._checked(versions[0], known)
        planes, limit = self._grey(stored, saturation, mask)
        with np.errstate(invalid="ignore"):
            valid = np.logical_and.reduce([plane < limit for plane in planes])
        images = np.where(valid & (True if mask is None else mask > 0), planes, np.nan)
        (white,), read = starting_noise(images[None])
        read /= math.sqrt(self._form.channels)
        try:
            self._prepare(Noise(white=white, read=read), (max(float(white * np.nanmean(images[0])), 1.0),))
            residuals = [residual_variance(self(*each, known=known).misfit, self.aliases()) for each in versions]
            self._excess = excess = min(residuals)
        finally:
            self.noise, self._levels = None, []
        self._prepare(Noise(white=white / excess, read=read / math.sqrt(excess)))
        return residuals.index(excess)

    @property
    def binning(self) -> tuple[int, ...]:
        """Side in pixels of the squares that are summed before filtering, for each level of light."""
        return tuple(level.engine.binning for level in self._levels)

    @property
    def rank(self) -> tuple[int, ...]:
        """Number of filtered images, for each level of light."""
        return tuple(level.engine.rank for level in self._levels)

    @property
    def design_error(self) -> float:
        """Largest bias of depth due to the filter approximation, in standard errors of a window."""
        return max((level.engine.design_error for level in self._levels), default=math.nan)

    def __repr__(self) -> str:
        height, width = self._form.size
        nearest, farthest = self._between
        electrons = [f"{level.engine.light.mean:g}" for level in self._levels]
        tables = f"pixels of {', '.join(map(str, self.binning))}, {', '.join(map(str, self.rank))} images"
        return f"<LiveDepth of {len(self._lenses)} frames of {height} x {width}, {nearest:g} to {farthest:g} m: " + (
            f"{tables}, for {', '.join(electrons)} electrons>" if electrons else "noise from the first frames>"
        )

    def __call__(self, *frames: Values, known: Values | None = None) -> LiveDepthMap:
        """Return the depth map of frames, in arrays that the next call overwrites.

        Parameters
        ----------
        *frames : ndarray, shape (height, width) or (height, width, channels)
            One frame of each lens, of uint8, uint16 or floats; NaN marks unknown pixels.
        known : ndarray of bool, shape (height, width), optional
            True for pixels that are valid in these frames.

        Raises
        ------
        TypeError, ValueError
            If frames are of another number, shape or type, if a frame is black, or if no pixel is known in all.
        """
        if not self._levels:
            self.estimate_noise(frames, known=known)
        stored, saturation, mask = self._checked(frames, known)
        planes, limit = self._grey(stored, saturation, mask)
        first_stream = self._levels[0].stream
        first_stream.sums(planes, limit, mask, self._sums)
        exposures, light = self._measure_exposures()
        # Choose the level of light whose ratio to `light` is nearest to 1.
        level = min(self._levels, key=lambda candidate: abs(math.log(candidate.engine.light.mean / max(light, 1e-3))))
        self._gains[:, 0] = [self._form.white / each for each in exposures]
        if self._smooth:
            self._gains[1:] = self._form.white * _smooth_ratios(self._sums, self._offset)
        level.stream.take(planes, self._gains, self._offset, limit, mask)
        level.stream.depths(self._depth, self._errors, self._misfit)
        self._last = _Call(level, stored, saturation, mask)
        return LiveDepthMap(self._depth, self._errors, self._misfit, exposures, light)

    def _checked(
        self, frames: Sequence[Values], known: Values | None
    ) -> tuple[list[Values], float, NDArray[np.uint8] | None]:
        """Return frames as they are read, the value of saturated pixels, and the mask of known ones."""
        if len(frames) != len(self._lenses):
            raise ValueError(f"frames must be as many as lenses, {len(self._lenses)}, got {len(frames)}")
        stored = [self._form.checked(f"frames[{k}]", frame) for k, frame in enumerate(frames)]
        saturation = self._form.saturation(frames[0].dtype)
        return stored, saturation, self._form.known(frames, saturation, known)

    def save(self, path: str | PathLike[str]) -> None:
        """Write the tables to a file for cameras without Python: ``lommel_live_new`` of the C interface reads it.

        The file also contains noise and saturation of the frames, and the tables of sharp images if ``sharp=True``.
        The size of the frames is an argument of ``lommel_live_new``.

        Parameters
        ----------
        path : path-like
            Path of the file, which is replaced if it exists.

        Raises
        ------
        TypeError, ValueError
            For colour frames, smooth exposures, magnification, or several levels of light.
        """
        if len(self._levels) != 1 or self._form.channels != 1 or self._smooth or self._registered:
            raise ValueError(
                "tables are saved of grey frames with one noise (noise=) and level of light (light=), without "
                "exposures= and magnification=; the file format has no fields for other options"
            )
        form, name = self._form, validation.path("path", path)
        limit = form.saturation(np.dtype(np.float32))
        atomic.write(name, self._levels[0].engine.tables(form.white, form.offset, limit))

    def _grey(self, stored: list[Values], limit: float, mask: NDArray[np.uint8] | None) -> tuple[list[Values], float]:
        """Return registered frames, summed over channels, and the value at which their pixels are saturated.

        `limit` is the saturation value of the frames before the sum.
        """
        if self._planes is None:
            return self._registered(stored, limit, mask), limit
        for frame, plane in zip(stored, self._planes, strict=True):
            np.sum(frame, axis=2, dtype=np.float32, out=plane)
        # A sum of channels has no single saturation value: the mask excludes saturated pixels.
        return self._registered(list(self._planes), math.inf, mask), math.inf

    @property
    def _offset(self) -> float:
        """Offset of the sum of the channels, in counts."""
        return self._form.offset * self._form.channels

    def _measure_exposures(self) -> tuple[tuple[float, ...], float]:
        """Return the relative exposures, and the mean electrons per pixel of the first frame."""
        counts = float(self._sums[-1].sum())
        if counts == 0.0:
            raise ValueError("frames have no pixel that is known in all of them: pixels are saturated, NaN or masked")
        white = self._form.white
        means = (self._sums[:-1].sum(axis=(1, 2)) / counts - self._offset) * white
        darkest = int(np.argmin(means))
        if not means[darkest] > max(_MIN_MEAN * means.max(), 0.0):
            raise ValueError(
                f"frames[{darkest}] must hold light, got a mean of {means[darkest]:.4g} electrons above the offset "
                f"{self._form.offset:g} of the noise; the brightest frame has {means.max():.4g}"
            )
        ratios = tuple((means / means[0]).tolist())
        if not 1.0 / _MAX_RATIO <= min(ratios) <= max(ratios) <= _MAX_RATIO:
            raise ValueError(
                "frames must not differ in exposure by more than a factor of 2: their means are "
                + ", ".join(f"{mean:.4g}" for mean in means)
                + " electrons"
            )
        return ratios, float(means[0])

    def verdict(self, *, f_number_error: float | None = None, focus_error: float | None = None) -> DefocusVerdict:
        """Test registration, noise and lenses against the frames of the last call; takes some seconds.

        The arrays of these frames must not have changed.

        Parameters
        ----------
        f_number_error, focus_error : float, optional
            Standard errors of the lenses, as in :class:`~lommel.imaging.DefocusOptions` and
            ``FocalCalibration.errors``, which determine `lens_error`. By default those of lenses that were not
            measured.

        Raises
        ------
        ValueError
            If there was no call yet, or an error is out of range.
        """
        DefocusOptions(f_number_error=f_number_error, focus_error=focus_error)  # checks them
        stated = f_number_error, focus_error
        level = self._last_call().level
        images, valid = self._electrons()
        images = images[None]
        # Expand blocks to pixels; rows and columns outside whole blocks repeat their neighbours.
        errors, misfit, vergence = (
            np.pad(np.kron(blocks, np.ones((BLOCK, BLOCK))), [(0, side % BLOCK) for side in valid.shape], mode="edge")
            # Standard errors of the vergence 1 / depth: d(1 / z) = -dz / z^2.
            for blocks in (self._errors / self._depth**2, self._misfit, 1.0 / self._depth)
        )
        errors = np.where(np.isnan(errors), np.inf, errors)
        noise = EstimatedNoise(self.noise) if self._estimates and self.noise else None
        maps = images, valid, errors, misfit, vergence
        return judge_frames(level.engine, *maps, stated, noise, excess=self._excess, included=False)

    def aliases(self) -> NDArray[np.float32]:
        """Return the misfit that aliases of binned pixels add to blocks of the last call; NaN where depth is unknown.

        Details finer than binned pixels, measured in the frames, act as noise that differs between frames,
        with the filters of the depth found. The arrays of these frames must not have changed.

        Returns
        -------
        ndarray of float32, shape (height // 4, width // 4)
            Expected misfit - 1 of exact lenses and registered frames, within a factor of about 2; 0 without binning.

        Raises
        ------
        ValueError
            If there was no call yet.
        """
        engine, read = self._last_call().level.engine, self._form.read * math.sqrt(self._form.channels)
        return engine.alias_misfit(*self._electrons(), read, np.reciprocal(self._depth))

    def _electrons(self) -> tuple[Values, NDArray[np.bool_]]:
        """Return the frames of the last call, in electrons at the exposure of the first one, and the valid pixels."""
        _, stored, saturation, mask = self._last_call()
        planes, limit = self._grey(stored, saturation, mask)
        with np.errstate(invalid="ignore"):
            valid = np.all([np.isfinite(plane) & (plane < limit) for plane in planes], axis=0)
        if mask is not None:
            valid &= mask > 0
        rows, columns = (2.0 * (np.arange(side) + 0.5) / side - 1.0 for side in self._form.size)
        y, x = rows[:, None], columns[None, :]
        light = [
            # The gain is a polynomial in x and y, evaluated by Horner's rule.
            (plane - self._offset) * (g[0] + x * (g[1] + x * g[2]) + y * (g[3] + x * g[4] + y * g[5]))
            for plane, g in zip(planes, self._gains.astype(np.float64), strict=True)
        ]
        return np.where(valid, light, 0.0), valid

    def sharp(self) -> NDArray[np.float32]:
        """Return the sharp image of the frames of the last call, whose arrays must not have changed.

        Pixels are filtered by the Wiener filter of their depth; unknown depth is filled from neighbouring blocks.

        Returns
        -------
        ndarray of float32
            Electrons of each pixel at the exposure of the first frame, with the shape of a frame.

        Raises
        ------
        ValueError
            If there was no call yet, or without ``sharp=True``.
        """
        return self._filter_images(None)

    def refocus(self, distance: float) -> NDArray[np.float32]:
        """Return the image that the first lens would record at another focus, from the frames of the last call.

        Parameters
        ----------
        distance : float
            Distance in focus, metres. The first call for a distance takes longer, since it computes a table.

        Raises
        ------
        TypeError, ValueError
            As :meth:`sharp`; if `distance` is not above 0; or without ``refocus=True``.
        """
        return self._filter_images(validation.real("distance", distance, above=0.0, infinite=True, unit="metres"))

    def _last_call(self) -> _Call:
        if self._last is None:
            raise ValueError("there are no frames yet: call the LiveDepth object with frames first")
        return self._last

    def _filter_images(self, distance: float | None) -> NDArray[np.float32]:
        level, planes, limit, mask = self._last_call()
        if level.pictures is None:
            raise ValueError("sharp images need tables: use LiveDepth(..., sharp=True), or refocus=True")
        if distance is not None and not self._refocus:
            raise ValueError("refocused images need tables: use LiveDepth(..., refocus=True)")
        out = self._form.image(None)
        factors = level.engine.factors(0, None if distance is None else self._lenses[0].focused(distance))
        level.stream.positions(self._positions)
        if self._form.channels == 1:
            if level.pictures is not level.stream:
                planes = self._registered(planes, limit, mask)
                level.pictures.take(planes, self._gains, self._form.offset, limit, mask)
            level.pictures.mix(self._positions, BLOCK, factors, out)
            return out
        for c in range(self._form.channels):
            channel_frames = self._registered([np.ascontiguousarray(frame[..., c]) for frame in planes], limit, mask)
            level.pictures.take(channel_frames, self._gains, self._form.offset, limit, mask)
            image = np.empty(self._form.size, dtype=np.float32)
            level.pictures.mix(self._positions, BLOCK, factors, image)
            out[..., c] = image
        return out


def _smooth_ratios(sums: Array, offset: float) -> Array:
    """Return, for each frame but the first, the polynomial (brightness of the first frame) / (brightness of frame).

    Coefficients are those of 1, x, x^2, y, x y, y^2 for x and y from -1 to 1, shape (frames - 1, 6). `sums` holds the
    sum of each frame in each part of the field, and in its last row the number of pixels of each part.
    """
    count = sums[-1].ravel()
    # Least squares over the parts.
    light = sums[:-1].reshape(len(sums) - 1, -1) - offset * count
    centres = (np.arange(_CELLS) + 0.5) * (2.0 / _CELLS) - 1.0
    y, x = (coordinates.ravel() for coordinates in np.meshgrid(centres, centres, indexing="ij"))
    offset_variance = (1.0 / _CELLS) ** 2 / 3.0  # mean square of x - (x at the centre) in a part
    terms = np.stack([np.ones_like(x), x, x * x + offset_variance, y, x * y, y * y + offset_variance], axis=1)
    # The variance of a mean of n pixels is proportional to 1 / n: equations are weighted by sqrt(n).
    weight = np.sqrt(count)
    ratios = []
    for frame_light in light[1:]:
        scaled = frame_light / np.maximum(weight, 1.0)
        ratios.append(np.linalg.lstsq(terms * scaled[:, None], light[0] / np.maximum(weight, 1.0), rcond=1e-6)[0])
    return np.asarray(ratios)


class _Level:
    """Tables for one level of light, and streams (filters in the compiled core) for depth and for images."""

    def __init__(self, task: FocalTask, light: FocalLight, form: FrameForm, images: bool, refocus: bool) -> None:
        self.engine = FocalEngine(task, light)
        # Grey frames that are not binned have one stream for depth and sharp images.
        one_stream = images and form.channels == 1 and self.engine.binning == 1
        if images:
            self.engine.sharpen(refocus=refocus, stream_filter=one_stream)
        self.stream = self.engine.stream(form.size, images=one_stream)
        self.pictures = self.stream if one_stream else self.engine.image_stream(form.size) if images else None


class _Call(NamedTuple):
    """Frames and tables of one call of LiveDepth."""

    level: _Level
    frames: list[Values]
    saturation: float
    known: NDArray[np.uint8] | None
