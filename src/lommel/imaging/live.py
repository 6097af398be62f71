"""Depth maps with standard errors, and sharp images, of frames at video rate."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from os import PathLike
from typing import NamedTuple, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import atomic, options, validation
from lommel.base.arrays import Array, Values
from lommel.estimation.focal_model import FocalLight, FocalModel
from lommel.imaging.defocus_verdict import DefocusVerdict, judged
from lommel.imaging.focal_engine import (
    BLOCK,
    CONTRAST,
    DefocusKeywords,
    DefocusOptions,
    FocalEngine,
    FocalTask,
    FrameForm,
    Registration,
    processors,
    ranged,
    relative_exposures,
)
from lommel.imaging.focal_tables import SharpTables, Taps
from lommel.imaging.settings import spectra
from lommel.optics.lens import Lens, pixel_of
from lommel.recorded.noise import Noise

_MOST_DEPTHS = 961  # largest number of candidates of a single frame
_LIGHT = 5000.0  # electrons a pixel, by default


class LiveSharpen:
    """Sharp images of single frames whose depth is known, in one pass.

    Parameters
    ----------
    lens : Lens
        At its focus distance and f-number; a circular or annular aperture and radially symmetric aberrations only.
    pixel : float
        Pixel pitch, metres.
    between : (float, float)
        Nearest and farthest distance, metres; the farthest may be infinite.
    noise : Noise
        Of the values of the frames, with numbers for `white`, `read` and `offset`.
    shape : (int, int) or (int, int, int)
        Height and width of the frames, pixels, 64 or more, and channels.
    light : float, optional
        Mean electrons of a pixel, by default 5000: less makes a smoother image.
    wavelengths : sequence of (float, float), optional
        Spectrum of the light: wavelengths, metres, and weights. By default the wavelength of the lens.
    saturation : float, optional
        Value from which on pixels are full, and filled from their neighbours, as is the largest of unsigned integers.
    threads : int, optional
        Number of threads; by default the number of processors. The result does not depend on it.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range or of another shape, or if the lens is not radially symmetric.

    Notes
    -----
    Wiener's filter of each distance, for textures of a spectrum that falls as the inverse square of the frequency, as
    a polynomial of one small filter (see :class:`lommel.imaging.LiveDepth`). It keeps the mean. Blur wider than the
    filters reach is undone in part.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.35, wavelength=540e-9)
    >>> sharpen = lm.imaging.LiveSharpen(lens, 4e-6, between=(1.2, 2.0), noise=lm.Noise(read=3), shape=(64, 96))
    >>> sharpen(np.full((64, 96), 1000, np.uint16), 1.7).round(3).max()
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
        light: float | None = None,
        wavelengths: Sequence[tuple[float, float]] | None = None,
        saturation: float | None = None,
        threads: int | None = None,
    ) -> None:
        pitch = pixel_of([lens], pixel)
        self._form = form = FrameForm(shape, noise, saturation, None)
        mean = _LIGHT if light is None else validation.real("light", light, least=1.0, below=1e9)
        count = validation.integer("threads", threads, least=1, most=1024) if threads is not None else processors()
        spectrum = spectra("wavelengths", [tuple(wavelengths)])[0] if wavelengths else ((lens.wavelength, 1.0),)
        self._between, self._vergence = ranged(between, [lens], pitch, None, _MOST_DEPTHS)
        model = FocalModel.of([lens], self._vergence, spectrum, pitch, FocalLight(mean, form.read, (1.0,), CONTRAST))
        self._tables = tables = SharpTables(model, Taps.of(5), 12)
        self._factors = _single(tables.mixes(tables.pixel))
        self._stream = tables.stream(form.size, count)
        self._gains = _single([[form.white, 0.0, 0.0, 0.0, 0.0, 0.0]])

    def __repr__(self) -> str:
        near, far = self._between
        size = " x ".join(map(str, self._form.shape))
        return f"<LiveSharpen of frames of {size}, {near:g} to {far:g} m: {len(self._tables.basis)} images>"

    def __call__(
        self, frame: Values, depth: float | ArrayLike, out: NDArray[np.float32] | None = None
    ) -> NDArray[np.float32]:
        """Return the sharp image of a frame, electrons.

        Parameters
        ----------
        frame : ndarray, shape (height, width) or (height, width, channels)
            Of uint8, uint16 or floats; NaN marks unknown pixels.
        depth : float or array_like, shape (height, width) or (height // 4, width // 4)
            Distance, metres, of all, of each pixel, or of blocks of 4 x 4 pixels, between whose middles it is taken
            to change linearly in 1 / distance.
        out : ndarray of float32, of the shape of a frame, optional
            To write to.

        Raises
        ------
        TypeError, ValueError
            If the frame or `out` is of another shape or type, or `depth` is of another shape, not finite or not above
            0.
        """
        stored = self._form.checked("frame", frame)
        places, side = self._places(depth)
        full = self._form.full(stored.dtype)
        made = self._form.image(out)
        if self._form.channels == 1:
            self._stream.take([stored], self._gains, self._form.offset, full, None)
            self._stream.mix(places, side, self._factors, made)
            return made
        one = np.empty(self._form.size, dtype=np.float32)
        for c in range(self._form.channels):
            plane = np.ascontiguousarray(stored[..., c])
            self._stream.take([plane], self._gains, self._form.offset, full, None)
            self._stream.mix(places, side, self._factors, one)
            made[..., c] = one
        return made

    def _places(self, depth: float | ArrayLike) -> tuple[NDArray[np.float32], int]:
        """Return positions in candidates, and the side in pixels of the block that each is the centre of."""
        with np.errstate(over="ignore"):
            metres = np.asarray(depth, dtype=np.float32)
        height, width = self._form.size
        sides = {(): min(height, width), (height, width): 1, (height // BLOCK, width // BLOCK): BLOCK}
        # One depth for all pixels, for each pixel, or for each block.
        if metres.shape not in sides:
            raise ValueError(
                f"depth must be a number, or have the shape {(height, width)} or "
                f"{(height // BLOCK, width // BLOCK)}, got {metres.shape}"
            )
        if not metres.min() > 0.0:  # NaN is not
            raise ValueError(f"depth must be > 0 metres everywhere, got {metres[~(metres > 0.0)].flat[0]}")
        first, step = (np.float32(each) for each in (self._vergence[0], self._vergence[1] - self._vergence[0]))
        # Maps of pixels take as long as their filters, unless they are turned into positions in one place.
        places = np.divide(np.float32(1.0) / step, np.atleast_2d(metres), order="C")
        places -= first / step
        return places, sides[metres.shape]


def _single(values: ArrayLike) -> NDArray[np.float32]:
    return np.ascontiguousarray(values, dtype=np.float32)


_LEVELS = (500.0, 5000.0, 50_000.0)  # default mean electrons of a pixel of the tables
_MOST = 241  # largest number of candidates of several frames
_CELLS = 8  # parts of a frame along a side whose light is summed
_DARK = 0.05  # of the mean of the brightest frame: a darker frame counts as black
_UNLIKE = 2.0  # largest ratio of measured exposures; larger ones must be stated


@dataclass(frozen=True, eq=False, repr=False)
class LiveDepthMap:
    """Depth of blocks of 4 x 4 pixels, in arrays that the next call overwrites.

    Attributes
    ----------
    depth : ndarray of float32, shape (height // 4, width // 4)
        Distance from the lens, metres; NaN where it is not known.
    errors : ndarray of float32
        Its standard error, metres; inf where it is not known.
    misfit : ndarray of float32
        What is left of the difference of the frames at the best depth, over that of noise: 1 where registration and
        noise are as stated. Above: motion, other registration, edges of depth. Below 0.7: noise overstated, or frames
        denoised.
    exposures : tuple of float
        Exposure of each frame relative to the first, as given or measured.
    light : float
        Mean electrons of a pixel.
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
            f"+- {1e3 * np.median(self.errors[inner]):.3g} mm, misfit {np.nanmedian(self.misfit[inner]):.2f}>"
        )


@options.shares(DefocusKeywords, DefocusOptions)
class LiveDepth:
    """Depth of frames that differ in focus, block by block, at video rate.

    Parameters
    ----------
    lenses : sequence of Lens
        Lens of each frame, at its focus distance and f-number; two or more. Circular or annular apertures and
        radially symmetric aberrations only.
    pixel : float
        Pixel pitch, metres.
    between : (float, float)
        Nearest and farthest distance, metres; the farthest may be infinite.
    noise : Noise
        Of the values of the frames, with numbers for `white`, `read` and `offset`: for frames in counts `white` is
        the gain in electrons per count.
    shape : (int, int) or (int, int, int)
        Height and width of the frames, pixels, 64 or more, and channels, of which the sum is taken.
    wavelengths : sequence of (float, float), optional
        Spectrum of the light: wavelengths, metres, and weights. By default the wavelength of the lenses.
    light : float or sequence of float, optional
        Mean electrons of a pixel that tables are made for; those nearest to a frame's are used. By default 500, 5000
        and 50 000. Within a factor of three errors are hardly larger than by tables of their own.
    known : array_like of bool, shape (height, width), optional
        Pixels of the sensor that are not broken.
    sharp, refocus : bool, default False
        Whether sharp images, by :meth:`sharp`, and those of other foci as well, by :meth:`refocus`, will be asked
        for.
    threads : int, optional
        Number of threads; by default the number of processors. The result does not depend on it.
    {options}

    Attributes
    ----------
    binning : tuple of int
        Pixels a side of the squares that each level of light is filtered in: depth loses little by them.
    rank : tuple of int
        Images whose products give the energies of each level.
    design_error : float
        Largest bias of the filters by themselves, in standard errors of a window, within the range.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range or of another shape, if a lens is not radially symmetric, or if the range spans
        more defocus than few filters can tell apart.

    Notes
    -----
    The residual of two frames, ``h_2 Y_1 - h_1 Y_2``, is noise at the true depth, whatever the texture. `h` is the
    transfer function of the lens at a depth times that of the pixel, without aliases, for scenes are continuous;
    aliases of the texture are noise. All residuals are polynomials of one small filter, and their energies quadratic
    forms of few images (see the page on live depth). The standard error follows from the curvature of the energy, the
    noise and the window; it grows with the misfit, with the slope of the depth map and next to edges of depth. Depth
    is not known where another one costs hardly more, where its standard error exceeds a tenth of the range in 1 /
    distance, and where half of a window or more is within the blur of the border or of pixels that are not known.

    :meth:`verdict` tests registration, noise and the size of blur. No pair of frames can tell which of them is
    focused nearer, nor a shift that both foci share.

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
        noise: Noise,
        shape: tuple[int, ...],
        wavelengths: Sequence[tuple[float, float]] | None = None,
        light: float | Sequence[float] | None = None,
        known: ArrayLike | None = None,
        sharp: bool = False,
        refocus: bool = False,
        threads: int | None = None,
        **given: Unpack[DefocusKeywords],
    ) -> None:
        options.require_known(LiveDepth, given, DefocusKeywords)
        chosen = DefocusOptions(**given)
        exposures = chosen.exposures
        pitch = pixel_of(lenses, pixel)
        if len(lenses) < 2:
            raise ValueError(f"lenses must be two or more, of frames that differ in focus; got {len(lenses)}")
        self._form = form = FrameForm(shape, noise, chosen.saturation, known)
        self._smooth, self._given = False, None
        if isinstance(exposures, str):
            self._smooth = validation.choice("exposures", exposures, ("smooth",)) == "smooth"
        elif exposures is not None:
            self._given = relative_exposures(exposures, len(lenses))
        width = validation.real("window", chosen.window, least=2.0, below=16.0 + 1e-9, unit="pixels")
        count = validation.integer("threads", threads, least=1, most=1024) if threads is not None else processors()
        spectrum = spectra("wavelengths", [tuple(wavelengths)])[0] if wavelengths else ((lenses[0].wavelength, 1.0),)
        self._between, vergence = ranged(between, lenses, pitch, None, _MOST)
        sharp, refocus = validation.truth("sharp", sharp), validation.truth("refocus", refocus)
        self._registered = Registration(chosen.magnification, lenses, form.size, count)
        scales = self._registered.scales
        task = FocalTask(lenses, vergence, [spectrum], pitch, self._between, width, BLOCK, 1, count, scales=scales)
        # Depth is found in the sum of the channels: variances of reading add.
        read = form.read * math.sqrt(form.channels)
        ratios = self._given or (1.0,) * len(lenses)
        self._levels = [
            _Level(task, FocalLight(mean, read, ratios, CONTRAST), form, sharp or refocus, refocus)
            for mean in _levels(light, form.channels)
        ]
        blocks = self._form.size[0] // BLOCK, self._form.size[1] // BLOCK
        # Results are written to the same arrays in every call: nothing is allocated at video rate.
        self._depth, self._errors, self._misfit = (np.empty(blocks, dtype=np.float32) for _ in range(3))
        self._positions = np.zeros(blocks, dtype=np.float32)
        self._sums = np.zeros((len(lenses) + 1, _CELLS, _CELLS))
        self._gains = np.zeros((len(lenses), 6), dtype=np.float32)
        self._lenses = tuple(lenses)
        self._planes = (
            [np.empty(self._form.size, dtype=np.float32) for _ in lenses] if self._form.channels > 1 else None
        )
        self._refocus = refocus
        self._last: _Taken | None = None

    @property
    def binning(self) -> tuple[int, ...]:
        """Pixels a side of the squares that each level of light filters."""
        return tuple(level.engine.binning for level in self._levels)

    @property
    def rank(self) -> tuple[int, ...]:
        """Number of images whose products give the energies of each level."""
        return tuple(level.engine.rank for level in self._levels)

    @property
    def design_error(self) -> float:
        """Largest bias of the filters by themselves, in standard errors of a window."""
        return max(level.engine.design_error for level in self._levels)

    def __repr__(self) -> str:
        height, width = self._form.size
        near, far = self._between
        each = [f"{level.engine.light.mean:g}" for level in self._levels]
        return (
            f"<LiveDepth of {len(self._lenses)} frames of {height} x {width}, {near:g} to {far:g} m: "
            f"pixels of {', '.join(map(str, self.binning))}, {', '.join(map(str, self.rank))} images, "
            f"for {', '.join(each)} electrons>"
        )

    def __call__(self, *frames: Values, known: Values | None = None) -> LiveDepthMap:
        """Return the depth of frames, in arrays that the next call overwrites.

        Parameters
        ----------
        *frames : ndarray, shape (height, width) or (height, width, channels)
            One of each lens, of uint8, uint16 or floats; NaN marks unknown pixels.
        known : ndarray of bool, shape (height, width), optional
            Pixels that are known in these frames.

        Raises
        ------
        TypeError, ValueError
            If frames are of another number, shape or type, one holds no light, or none has a known pixel.
        """
        if len(frames) != len(self._lenses):
            raise ValueError(f"frames must be as many as lenses, {len(self._lenses)}, got {len(frames)}")
        stored = [self._form.checked(f"frames[{k}]", frame) for k, frame in enumerate(frames)]
        full = self._form.full(frames[0].dtype)
        mask = self._form.known(frames, full, known)
        planes, limit = self._grey(stored, full, mask)
        first = self._levels[0].stream
        first.sums(planes, limit, mask, self._sums)
        exposures, light = self._exposed()
        # The level whose light is nearest by ratio, as noise depends on ratios of light.
        level = min(self._levels, key=lambda one: abs(math.log(one.engine.light.mean / max(light, 1e-3))))
        self._gains[:, 0] = [self._form.white / each for each in exposures]
        if self._smooth:
            self._gains[1:] = self._form.white * _smooth_ratios(self._sums, self._offset)
        level.stream.take(planes, self._gains, self._offset, limit, mask)
        level.stream.depths(self._depth, self._errors, self._misfit)
        self._last = _Taken(level, stored, full, mask)
        return LiveDepthMap(self._depth, self._errors, self._misfit, exposures, light)

    def save(self, path: str | PathLike[str]) -> None:
        """Write the tables to a file for cameras without Python: ``lommel_live_new`` of the C interface reads it.

        The file holds the frames' noise, saturation and, where they were asked for, sharp images; the size of the
        frames is stated there.

        Parameters
        ----------
        path : path-like
            Of the file, which is replaced.

        Raises
        ------
        TypeError, ValueError
            For colour, exposures that are stated, magnification, several levels of light, or masks.
        """
        more = self._given is not None or self._smooth or self._form.masked or bool(self._registered)
        if len(self._levels) != 1 or self._form.channels != 1 or more:
            raise ValueError(
                "tables are saved of grey frames for one level of light (light=), without exposures=, magnification= "
                "and known=; the file has no place for more"
            )
        form, name = self._form, validation.path("path", path)
        atomic.write(name, self._levels[0].engine.tables(form.white, form.offset, form.full(np.dtype(np.float32))))

    def _grey(self, stored: list[Values], full: float, mask: NDArray[np.uint8] | None) -> tuple[list[Values], float]:
        """Return the frames that depth is found in, sums of channels, and the value at which they are saturated."""
        if self._planes is None:
            return self._registered(stored, full, mask), full
        for frame, plane in zip(stored, self._planes, strict=True):
            np.sum(frame, axis=2, dtype=np.float32, out=plane)
        # Sums of channels have no one saturation value: the mask excludes saturated pixels.
        return self._registered(list(self._planes), math.inf, mask), math.inf

    @property
    def _offset(self) -> float:
        """Offset of the sum of the channels, in counts."""
        return self._form.offset * self._form.channels

    def _exposed(self) -> tuple[tuple[float, ...], float]:
        """Return the exposures, and the mean electrons of a pixel of the first frame."""
        counts = float(self._sums[-1].sum())
        if counts == 0.0:
            raise ValueError("frames have no pixel that is known in all of them: they are full, NaN or masked")
        white = self._form.white
        means = (self._sums[:-1].sum(axis=(1, 2)) / counts - self._offset) * white
        for k, mean in enumerate(means):
            if not mean > 0.0:
                raise ValueError(
                    f"frames[{k}] must hold light, got a mean of {mean:.4g} electrons above the offset "
                    f"{self._form.offset:g} of the noise"
                )
        if self._given is not None:
            return self._given, float(means[0])
        found = tuple((means / means[0]).tolist())
        dark = int(np.argmin(means))
        if means[dark] < _DARK * means.max():
            raise ValueError(
                f"frames[{dark}] must hold light, got a mean of {means[dark]:.4g} electrons beside {means.max():.4g} "
                "of another"
            )
        if not 1.0 / _UNLIKE <= min(found) <= max(found) <= _UNLIKE:
            raise ValueError(
                "exposures must be stated where frames differ by more than a factor of 2: their means are "
                + ", ".join(f"{mean:.4g}" for mean in means)
                + " electrons"
            )
        return found, float(means[0])

    def verdict(self) -> DefocusVerdict:
        """Return whether registration, noise and lenses agree with the frames of the last call, in some seconds.

        These must not have changed since. ValueError if there are no frames yet.
        """
        level, stored, full, mask = self._taken()
        planes, limit = self._grey(stored, full, mask)
        with np.errstate(invalid="ignore"):
            valid = np.all([np.isfinite(plane) & (plane < limit) for plane in planes], axis=0)
        if mask is not None:
            valid &= mask > 0
        down, across = (2.0 * (np.arange(side) + 0.5) / side - 1.0 for side in self._form.size)
        y, x = down[:, None], across[None, :]
        light = [
            # The polynomial of the gains over the field, by Horner's rule.
            (plane - self._offset) * (g[0] + x * (g[1] + x * g[2]) + y * (g[3] + x * g[4] + y * g[5]))
            for plane, g in zip(planes, self._gains.astype(np.float64), strict=True)
        ]
        images = np.where(valid, light, 0.0)[None]
        # Blocks become pixels; the last rows and columns, beyond whole blocks, repeat their neighbours.
        errors, misfit, vergence = (
            np.pad(np.kron(each, np.ones((BLOCK, BLOCK))), [(0, side % BLOCK) for side in valid.shape], mode="edge")
            # Errors of vergence 1 / depth: d(1 / v) = -dv / v^2.
            for each in (self._errors / self._depth**2, self._misfit, 1.0 / self._depth)
        )
        errors = np.where(np.isnan(errors), np.inf, errors)
        return judged(level.engine, images, valid, errors, misfit, vergence)

    def sharp(self, out: NDArray[np.float32] | None = None) -> NDArray[np.float32]:
        """Return the sharp image of the frames of the last call, which must not have changed since.

        By Wiener's filters at the depths found, in one pass; where depth is not known it is taken from around.

        Parameters
        ----------
        out : ndarray of float32, of the shape of a frame, optional
            To write to: then nothing is allocated.

        Returns
        -------
        ndarray of float32
            Electrons of each pixel at the exposure of the first frame.

        Raises
        ------
        ValueError
            If there are no frames yet, `out` is of another shape or type, or ``sharp=True`` was not asked for.
        """
        return self._mixed(None, out)

    def refocus(self, distance: float, out: NDArray[np.float32] | None = None) -> NDArray[np.float32]:
        """Return what the first lens would see if it were focused elsewhere, of the frames of the last call.

        Parameters
        ----------
        distance : float
            Distance in focus, metres. The first call with it makes a table.
        out : ndarray of float32, optional
            As of :meth:`sharp`, which has results and units, too.

        Raises
        ------
        TypeError, ValueError
            As of :meth:`sharp`, if `distance` is not above 0, or ``refocus=True`` was not asked for.
        """
        return self._mixed(validation.real("distance", distance, above=0.0, infinite=True, unit="metres"), out)

    def _taken(self) -> _Taken:
        if self._last is None:
            raise ValueError("there are no frames yet: call this with frames first")
        return self._last

    def _mixed(self, distance: float | None, out: NDArray[np.float32] | None) -> NDArray[np.float32]:
        level, planes, limit, mask = self._taken()
        if level.pictures is None:
            raise ValueError("images must be asked for: LiveDepth(..., sharp=True), or refocus=True")
        if distance is not None and not self._refocus:
            raise ValueError("images of other foci must be asked for: LiveDepth(..., refocus=True)")
        out = self._form.image(out)
        factors = level.engine.factors(0, None if distance is None else self._lenses[0].focused(distance))
        level.stream.positions(self._positions)
        if self._form.channels == 1:
            if level.pictures is not level.stream:
                planes = self._registered(planes, limit, mask)
                level.pictures.take(planes, self._gains, self._form.offset, limit, mask)
            level.pictures.mix(self._positions, BLOCK, factors, out)
            return out
        for c in range(self._form.channels):
            one = self._registered([np.ascontiguousarray(frame[..., c]) for frame in planes], limit, mask)
            level.pictures.take(one, self._gains, self._form.offset, limit, mask)
            image = np.empty(self._form.size, dtype=np.float32)
            level.pictures.mix(self._positions, BLOCK, factors, image)
            out[..., c] = image
        return out


def _smooth_ratios(sums: Array, offset: float) -> Array:
    """Return the ratios of brightness of the first frame to the others as polynomials over the field.

    Coefficients are of 1, x, x^2, y, x y, y^2, x and y from -1 to 1. `sums` holds the sums of each frame, and last
    the numbers of pixels, over parts of the field.
    """
    count = sums[-1].ravel()
    # Least squares over the parts.
    light = sums[:-1].reshape(len(sums) - 1, -1) - offset * count
    middle = (np.arange(_CELLS) + 0.5) * (2.0 / _CELLS) - 1.0
    y, x = (each.ravel() for each in np.meshgrid(middle, middle, indexing="ij"))
    within = (1.0 / _CELLS) ** 2 / 3.0  # the mean square of positions about the middle of a part
    terms = np.stack([np.ones_like(x), x, x * x + within, y, x * y, y * y + within], axis=1)
    # The variance of a mean of n pixels goes with 1 / n: the equations are weighted by sqrt(n).
    weight = np.sqrt(count)
    found = []
    for other in light[1:]:
        scaled = other / np.maximum(weight, 1.0)
        found.append(np.linalg.lstsq(terms * scaled[:, None], light[0] / np.maximum(weight, 1.0), rcond=1e-6)[0])
    return np.asarray(found)


class _Level:
    """Tables for one level of light, and the streams that use them."""

    def __init__(self, task: FocalTask, light: FocalLight, form: FrameForm, images: bool, refocus: bool) -> None:
        self.engine = FocalEngine(task, light)
        # Images of frames that are not binned are made in the pass that finds their depth.
        shared = images and form.channels == 1 and self.engine.binning == 1
        if images:
            self.engine.sharpen(refocus=refocus, shared=shared)
        self.stream = self.engine.stream(form.size, images=shared)
        self.pictures = self.stream if shared else self.engine.image_stream(form.size) if images else None


class _Taken(NamedTuple):
    """Frames and tables of the last call."""

    level: _Level
    frames: list[Values]
    full: float
    known: NDArray[np.uint8] | None


def _levels(light: float | Sequence[float] | None, channels: int) -> list[float]:
    if light is None:
        return [each * channels for each in _LEVELS]
    values = validation.real_array("light", light, least=1.0, most=1e9)
    if values.ndim > 1 or not 1 <= values.size <= 16:
        raise ValueError(f"light must be a number or up to 16, got shape {values.shape}")
    return sorted(set(np.atleast_1d(values).tolist()))
