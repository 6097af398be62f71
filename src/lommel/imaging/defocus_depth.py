"""Depth from defocus: the depth map of a scene from photographs with different focus or aperture."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Json, Values, plain
from lommel.base.cached import cached_property
from lommel.base.encoding import Encoding, from_light, to_light
from lommel.base.options import In, listed
from lommel.core.engine import FocalStream
from lommel.estimation.depth_precision import WINDOW
from lommel.estimation.focal_model import FocalLight, Transfer, transfer_curve
from lommel.imaging.defocus_verdict import DefocusVerdict, judge_frames, squared_slopes
from lommel.imaging.focal_engine import (
    BLOCK,
    CONTRAST,
    FocalEngine,
    FocalTask,
    Magnified,
    Registration,
    checked_range,
    processors,
)
from lommel.imaging.pair_noise import is_compressed, residual_variance, starting_noise, without_rounding
from lommel.imaging.photograph import require_image
from lommel.imaging.settings import channel_spectra, spectra
from lommel.io.depth_maps import fill_missing, write_depth
from lommel.optics.lens import Lens, pixel_of
from lommel.recorded.counts import Counts, counts_of
from lommel.recorded.noise import Noise
from lommel.show import estimates

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_MAX_CANDIDATES = 2001  # largest number of candidates
_ROWS = 1024  # number of rows computed together
_MULTIPLE = 16  # pixels: a common multiple of the sides of blocks and of all squares that are binned
_MIN_SIDE = 160  # pixels, smallest height and width; smaller photographs are padded with mirrored pixels
_MIN_UNMIXED = 0.2  # least fraction of pixels, away from unknown ones and borders, that measure exposures
_TEXTURE_REACH = 3.0  # distance from which texture determines depth in flat areas / window
_MAX_FAINT = 0.2  # largest standard error / usual one in JPEG, whose noise is faint texture too
_ADDED_VARIANCE = 1e-3  # variance added to the read-noise variance, as a fraction of the mean electrons per pixel


@dataclass(frozen=True, eq=False)
class DefocusDepth:
    """Depth map estimated by :func:`lommel.imaging.depth_from_defocus`.

    Attributes
    ----------
    depth : ndarray, shape (height, width)
        Distance from the lens, metres; NaN where depth cannot be determined.
    errors : ndarray, shape (height, width)
        Standard error of `depth`, metres, of noise alone unless errors of the lens are stated; inf where depth cannot
        be determined. ``verdict.lens_error`` is that of the lens, which all points at one distance share.
    misfit : ndarray, shape (height, width)
        Residual difference of the photographs at the estimated depth, relative to the noise: 1 where registration and
        noise model are right, more at depth edges, borders and moving objects. `errors` increase with it.
    candidates : ndarray, shape (count,)
        Candidate distances, metres.
    exposures : tuple of float
        Exposure of each photograph relative to the first, as measured.
    encoding : {"srgb", "linear"}, float or ToneCurves
        Encoding of the photographs and of `sharp`.
    """

    depth: Array
    errors: Array
    misfit: Array
    candidates: Array
    exposures: tuple[float, ...]
    encoding: Encoding
    _sharpen: Callable[[Array], Values]
    _judge: Callable[[], DefocusVerdict]
    _sources: str  # of `errors`

    @property
    def known(self) -> float:
        """Fraction of the pixels whose depth is known."""
        return float(np.isfinite(self.errors).mean())

    @cached_property
    def verdict(self) -> DefocusVerdict:
        """Test of registration, noise and lenses against the photographs; computed on first use in some seconds."""
        return self._judge()

    @cached_property
    def sharp(self) -> Values:
        """The all-in-focus image by Wiener filtering, encoded like the photographs; ValueError without depths."""
        if self.known == 0.0:
            raise ValueError("no depth is known, so no sharp image: use photographs with texture, or widen between=")
        return self._sharpen(np.asarray(fill_missing(self.depth, "nearest"), dtype=np.float64))

    def to_dict(self) -> Json:
        """Return the result without images as plain data for JSON; computes `verdict` if necessary.

        Returns
        -------
        dict
            The entries of ``verdict.to_dict()``, shape, number of candidates, exposures and fraction of pixels with
            known depth; for these pixels, percentiles of depth, and the median of `errors` and its sources, metres.
            None if no depth is known, and for values that are not finite.
        """
        facts, inner = self.verdict.to_dict(), np.isfinite(self.errors)
        ends = np.percentile(self.depth[inner], [5.0, 50.0, 95.0]).tolist() if inner.any() else None
        depth_facts: Json = plain(
            {
                "shape": self.depth.shape,
                "candidates": len(self.candidates),
                "exposures": self.exposures,
                "known": self.known,
                "depth": ends and dict(zip(("5 %", "50 %", "95 %"), ends, strict=True)),
                "error": float(np.median(self.errors[inner])) if inner.any() else None,
                "error_of": self._sources,
            }
        )
        return facts | depth_facts

    def save(self, path: str | PathLike[str]) -> None:
        """Write the depth map to `path`: .tif, .npy or .pfm; ValueError for another suffix."""
        write_depth(Path(path), self.depth)

    def plot(self) -> Figure:
        """Plot depth, its standard error and the all-in-focus image in a Matplotlib figure."""
        light = to_light("sharp", self.sharp, self.encoding, np.float64) if self.known else None
        return estimates.maps(self.depth, self.errors, light)

    def __repr__(self) -> str:
        if not self.known:
            return "<DefocusDepth: no depth is known>"
        inner = np.isfinite(self.errors)
        low, high = np.percentile(self.depth[inner], [5.0, 95.0])
        return (
            f"<DefocusDepth: known at {100.0 * self.known:.3g} %, {low:.4g} m to {high:.4g} m (5 to 95 %), "
            f"+- {1e3 * np.median(self.errors[inner]):.3g} mm of {self._sources}>"
        )


@dataclass(frozen=True, kw_only=True)
class DefocusOptions(Magnified):
    """Options of :func:`lommel.imaging.depth_from_defocus`.

    Parameters
    ----------
    f_number_error : float, optional
        Common standard error of all f-numbers relative to them, 0.05 for 5 %, below 0.5, as part of `errors`. A
        relative error of the pixel pitch has the same effect, an error of the focal length twice this effect.
    focus_error : float, optional
        Standard error of each 1 / (focus distance), independent of the others, dioptres (1 / m), as part of `errors`:
        0.02 is 2 % at 1 m and 4 % at 2 m. If neither error is stated, `errors` are of noise alone, and the verdict
        states beside them what 3 % of the f-number and 2 % of each focus distance add, for a lens that was not
        measured.
    """

    f_number_error: Annotated[float | None, In(least=0.0, below=0.5)] = None
    focus_error: Annotated[float | None, In(least=0.0, unit="dioptres")] = None


@listed(DefocusOptions)
def depth_from_defocus(
    photographs: Sequence[ArrayLike],
    lenses: Sequence[Lens],
    pixel: float,
    *,
    encoding: Encoding,
    noise: Noise | None = None,
    between: tuple[float, float],
    transfer: Transfer = transfer_curve,
    progress: Callable[[int, int], object] | None = None,
    options: DefocusOptions | None = None,
    **given: Any,
) -> DefocusDepth:
    """Estimate a depth map from photographs of a scene that differ in focus or aperture (depth from defocus).

    Parameters
    ----------
    photographs : sequence of array_like, shape (height, width) or (height, width, channels)
        Two or more photographs of one scene from one position, grey or in RGB: floats, or unsigned integers with the
        largest value as white. NaN, masked pixels, and the largest value of integers are unknown. Channels have
        separate textures and one depth. Do not denoise or sharpen photographs, and do not use low-quality JPEG: depth
        is estimated relative to the noise.
    lenses : sequence of Lens
        Lens of each photograph, at its focus distance and f-number; circular apertures and radially symmetric
        aberrations only.
    pixel : float
        Pixel pitch, metres.
    encoding : {"srgb", "linear"} or float
        Encoding of the photographs; a number states ``light = value ** number``.
    noise : Noise, optional
        Noise of the linear photographs, where white is 1: ``noise.white`` is the number of electrons at white. By
        default it is estimated from the photographs, as that of the residual at the depths found: `verdict` does not
        test it.
    between : (float, float)
        Nearest and farthest candidate distance, metres; the farthest may be infinite.
    transfer : callable, optional
        ``transfer(lens, vergence, spectrum, pixel)``, for PSFs other than those of the lenses. It returns a function
        that maps `frequency` (cycles per pixel) to the transfer function of the optics, without the pixel, of shape
        ``(len(vergence), *frequency.shape)``. `spectrum` is a sequence of pairs (wavelength in metres, weight).
    progress : callable, optional
        Called as ``progress(done, bands)`` after each band of rows, with the numbers of complete and of all bands.
    options : DefocusOptions, optional
        All options below in one object; keywords override it.
    {options}

    Returns
    -------
    DefocusDepth

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range or of another shape, if a lens is not radially symmetric, if there are fewer
        than two photographs, or if the range spans too much defocus.

    Notes
    -----
    Candidate distances are equally spaced in 1 / distance, at least 61, and 0.75 rad of defocus apart at most; depth
    is interpolated between them. Exposures are measured by the mean values of pixels whose light neither saturated
    pixels nor the border reach. Depth is assumed constant in Gaussian windows of 4 pixels rms.

    If two photographs are each filtered by the transfer function of the other, their difference (residual) at the
    true depth is noise, whatever the texture. A wrong assumption about the texture therefore does not bias depth
    (compare Subbarao and Surya 1994, doi:10.1007/BF02028349, and Favaro and Soatto 2005,
    doi:10.1109/TPAMI.2005.43). The transfer functions, of optics and pixel, are those of a continuous scene; aliases
    are treated as noise. The energy, the mean square of the residual over a window, is computed in blocks by the
    filters of :class:`lommel.imaging.LiveDepth`, and interpolated between blocks. The standard error follows from the
    curvature of the energy at its minimum, the noise and the size of the window. It grows with the misfit, with the
    slope of the depth map and near depth edges; compare :func:`lommel.depth_precision`. It includes the stated errors
    of the lenses, which shift whole surfaces. Depth is NaN where its standard error exceeds 17 % of the range in 1 /
    distance (3.4 % in JPEG whose noise is estimated; 4 % where less than half of the depths within 16 pixels are
    known), where another candidate has almost the same energy, which is frequent with periodic textures, where it is
    outside of `between`, and where half of a window or more is within the blur of the border or of unknown pixels. It
    is that of the texture within 16 pixels: a plain area beside an object has the depth of the object, or none, up to
    16 pixels beyond its blurred edge.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.35, wavelength=540e-9)
    >>> lenses = [lens, lens.focused(1.8)]
    >>> scene = np.random.default_rng(0).random((64, 64))
    >>> pair = [
    ...     lm.imaging.depth_of_field(scene, np.full((64, 64), 1.5), one, 4e-6, encoding="linear").values
    ...     for one in lenses
    ... ]
    >>> found = lm.imaging.depth_from_defocus(
    ...     pair,
    ...     lenses,
    ...     4e-6,
    ...     encoding="linear",
    ...     noise=lm.Noise(white=1e4, read=3),
    ...     between=(1.2, 2.0),
    ...     progress=lambda done, bands: print(f"{done} of {bands} bands of rows"),
    ... )
    1 of 1 bands of rows
    >>> round(float(np.median(found.depth)), 2)
    1.5
    """
    o = DefocusOptions.of("depth_from_defocus", options, given)
    pitch = pixel_of(lenses, pixel)
    photos = list_photographs(photographs, lenses)
    if transfer is transfer_curve and all(lens == lenses[0] for lens in lenses):
        raise ValueError("lenses must differ in focus or aperture: photographs with one setting have one blur")
    # Without a noise photographs stay in units of white until it is estimated.
    stated = Noise(white=1.0, read=0.0) if noise is None else validation.instance("noise", noise, Noise).poisson
    validation.function("progress", progress, required=False)
    ends, vergence = checked_range(between, lenses, pitch, _MAX_CANDIDATES, transfer)
    images, valid, shape, scene = counts_in_electrons(photos, encoding, stated)
    if not valid.any():
        raise ValueError("photographs have no pixel that is known in all of them: they are NaN or saturated")
    white, read = np.ones(len(images)), math.sqrt(float(np.mean(np.square(stated.read))))
    if noise is None:
        white, read = starting_noise(np.where(valid, images, np.nan))
        images *= white[:, None, None, None].astype(np.float32)
    registered = Registration(o.magnification, lenses, valid.shape, processors())
    for channel in images if registered else ():
        channel[1:] = registered(list(channel), math.inf, valid.view(np.uint8))[1:]
    if registered:
        # Pixels that depend on unknown ones are NaN. The transforms of the verdict need a value everywhere.
        valid = np.isfinite(images).all(axis=(0, 1)) & valid
        for channel in images if valid.any() else ():
            channel[:] = [fill_missing(plane, "nearest") for plane in channel]
    colours = spectra("channels", channel_spectra(shape, lenses[0].wavelength))
    task = FocalTask(lenses, vergence, colours, pitch, ends, BLOCK, processors(), transfer, registered.scales)
    means = images[..., _unmixed(valid, task.blur)].mean(axis=(0, 2), dtype=np.float64)
    if not np.all(means > 0.0):
        text = ", ".join(f"{value:.4g}" for value in means)
        raise ValueError(f"photographs must have a mean above 0, got {text} electrons per pixel")
    mean, ratios = float(means[0]), tuple((means / means[0]).tolist())
    # Scale all frames to the exposure of the first: the tables assume one light level.
    images /= np.asarray(ratios, dtype=np.float32)[:, None, None]
    excess, brightest = 1.0, int(np.argmax(images[:, 0].mean(axis=(1, 2))))
    for estimated in (True, False) if noise is None else (False,):
        dark = math.sqrt(read**2 + _ADDED_VARIANCE * mean)
        engine = FocalEngine(task, FocalLight(mean, dark, ratios, CONTRAST))
        position, index_errors, misfit = _search(engine, images, valid, None if estimated else progress)
        if estimated:
            # The residual is noise at the true depth: its variance is that of the noise.
            blocks = tuple(slice(BLOCK // 2, side // BLOCK * BLOCK, BLOCK) for side in valid.shape)
            places = vergence[0] + (vergence[1] - vergence[0]) * position[blocks]
            aliases = engine.alias_misfit(images[brightest], valid, dark, places)
            excess = residual_variance(misfit[blocks], aliases)
            images /= np.float32(excess)
            white, mean, read = white / excess, mean / excess, read / math.sqrt(excess)
    found = None
    if noise is None:
        levels = np.iinfo(scene.dtype).max + 1 if scene.dtype.kind == "u" else 0
        light = (images[:, 0] / white[:, None, None])[:, valid][:, ::8]
        found = without_rounding(Noise(white=float(white.mean()), read=read), light, levels, encoding)
    # Blur is linear in 1 / distance: the candidates are equally spaced in it.
    step = float(vergence[1] - vergence[0])
    limit = engine.known / step
    if found and any(map(is_compressed, images[brightest])):
        limit *= _MAX_FAINT
    _add_slope_errors(position, index_errors, WINDOW, limit)
    estimate, errors = vergence[0] + step * position.astype(np.float64), step * index_errors
    lens_errors = o.f_number_error, o.focus_error
    if any(lens_errors):
        _add_lens_errors(engine, lens_errors, estimate, errors, index_errors)
    with np.errstate(invalid="ignore", divide="ignore"):
        depth, distances = 1.0 / estimate, 1.0 / vergence
        # Depth is 1 / v at the vergence v: d(1 / v) = -dv / v^2.
        sigma = np.where(np.isfinite(errors), errors * depth**2, np.inf)
    sources = "noise and lens" if any(lens_errors) else "noise"
    maps = images, valid, step * index_errors, misfit, estimate
    form = encoding, scene.shape, scene.dtype
    sharpen = partial(_sharpened, engine, images, valid, (float(vergence[0]), step), white, stated, form)
    judge = partial(judge_frames, engine, *maps, lens_errors, found, excess=excess)
    return DefocusDepth(depth, sigma, misfit.astype(np.float64), distances, ratios, encoding, sharpen, judge, sources)


def _sharpened(
    engine: FocalEngine,
    images: Values,
    valid: NDArray[np.bool_],
    candidates: tuple[float, float],
    white: Array,
    stated: Noise,
    form: tuple[Encoding, tuple[int, ...], np.dtype[Any]],
    metres: Array,
) -> Values:
    """Return the all-in-focus image for a depth map, in the encoding, shape and type of the photographs.

    `candidates` are the first vergence and the step between them.
    """
    (first, step), (encoding, shape, dtype) = candidates, form
    positions = np.asarray((1.0 / metres - first) / step, dtype=np.float32)
    planes = _compute_sharp(engine, images, valid, positions) / white[:, None, None]
    light = np.moveaxis(stated.image(planes), 0, 2)
    light = np.broadcast_to(light, (*valid.shape, *shape[2:])) if len(shape) == 3 else light[..., 0]
    if dtype.kind != "f":
        light = np.clip(light, 0.0, 1.0)
    elif encoding != "linear":
        light = np.maximum(light, 0.0)
    return from_light(light, encoding, dtype)


def list_photographs(photographs: object, lenses: Sequence[Lens]) -> list[object]:
    """Return the photographs with their masks; ValueError unless there is one for each of at least two lenses."""
    if len(lenses) < 2:
        raise ValueError(
            f"lenses must be two or more: one photograph cannot separate blur from soft texture; got {len(lenses)}"
        )
    images = list(photographs) if isinstance(photographs, list | tuple) else _separate_photographs(photographs)
    if len(images) != len(lenses):
        count = len(images) or validation.shown(photographs)
        raise ValueError(f"photographs must be as many as lenses, {len(lenses)}, got {count}")
    return images


def _counts(photographs: list[object]) -> list[Counts]:
    """Return photographs as counts; ValueError unless they are images of one shape."""
    shape = "(height, width) or (height, width, channels)"
    counts = []
    for k, photograph in enumerate(photographs):
        counts.append(counts_of(f"photographs[{k}]", photograph, sides=(2, 3), shape=shape))
        require_image(f"photographs[{k}]", counts[k].values.shape)
    if len({photograph.values.shape for photograph in counts}) > 1:
        shapes = ", ".join(str(photograph.values.shape) for photograph in counts)
        raise ValueError(f"photographs must be of one shape, got {shapes}")
    return counts


def _unmixed(valid: NDArray[np.bool_], blur: float) -> NDArray[np.bool_]:
    """Return the pixels that no light of unknown ones or from outside reaches; `valid` if few are left."""
    # The light that clipped pixels or the border hide differs between photographs of different blur.
    unmixed = scipy.ndimage.minimum_filter(valid, 2 * math.ceil(blur) + 1, mode="constant", cval=False)
    return unmixed if unmixed.sum() > _MIN_UNMIXED * valid.sum() else valid


def _add_slope_errors(position: Values, errors: Values, window: float, limit: float) -> None:
    """Increase `errors` on slopes without texture, in place: the depth there is that of texture some pixels away."""
    known, reach = np.isfinite(errors), _TEXTURE_REACH * window
    least = scipy.ndimage.minimum_filter(errors, 2 * round(reach) + 1)
    # Errors that are more than twice the least error around come from texture that is on average reach / 2 away.
    borrowed = np.maximum(0.0, 1.0 - np.square(2.0 * least[known] / errors[known]))
    errors[known] = np.sqrt(errors[known] ** 2 + 0.25 * reach**2 * borrowed * squared_slopes(position, window)[known])
    unknown = known & (errors > limit)
    position[unknown], errors[unknown] = math.nan, math.inf


def _add_lens_errors(
    engine: FocalEngine,
    stated: tuple[float | None, float | None],
    estimate: Array,
    errors: Array,
    index_errors: Values,
) -> None:
    """Add the errors of f-numbers and foci to `errors`, the standard errors of 1 / distance, in place.

    `index_errors` are standard errors in steps between candidates. Where the combined standard error is too large,
    depth becomes unknown in all three arrays.
    """
    inner = np.isfinite(errors)
    errors[inner] = np.hypot(errors[inner], engine.lens_errors(estimate[inner], *stated))
    unknown = inner & (errors > engine.known)
    estimate[unknown], errors[unknown], index_errors[unknown] = math.nan, math.inf, math.inf


def _bands(shape: tuple[int, int], reach: int) -> Iterator[tuple[slice, slice]]:
    """Yield pairs: the rows of a band, and the rows on which their depths depend, which start at a whole block."""
    for top in range(0, shape[0], _ROWS):
        bottom = min(top + _ROWS, shape[0])
        # The start is a multiple of 16: blocks are at the same pixels as in the whole photograph.
        start = max(0, top - reach) // _MULTIPLE * _MULTIPLE
        yield slice(top, bottom), slice(start, min(shape[0], bottom + reach))


def _pad_images(images: Values, valid: NDArray[np.bool_]) -> tuple[list[Values], NDArray[np.uint8]]:
    """Return images padded by mirroring to multiples of 16, and a map: 1 known, 0 unknown, 2 mirrored pixels."""
    sides = [max(_MIN_SIDE, math.ceil(side / _MULTIPLE) * _MULTIPLE) for side in valid.shape]
    margins = [(0, side - length) for side, length in zip(sides, valid.shape, strict=True)]
    planes = [np.pad(plane, margins, mode="symmetric") for plane in images.reshape(-1, *valid.shape)]
    return planes, np.pad(valid.astype(np.uint8), margins, constant_values=2)


def _load_planes(stream: FocalStream, planes: list[Values], known: NDArray[np.uint8]) -> None:
    """Load planes, in electrons, into a stream."""
    # Gains are polynomials in x and y, here the constant 1: the photographs were scaled to equal exposure.
    gains = np.zeros((len(planes), 6), dtype=np.float32)
    gains[:, 0] = 1.0
    stream.take(planes, gains, 0.0, math.inf, known)


def _search(
    engine: FocalEngine, images: Values, valid: NDArray[np.bool_], progress: Callable[[int, int], object] | None
) -> NDArray[np.float32]:
    """Return an array (3, height, width): depth as the index of a candidate, its standard error, and the misfit."""
    result = np.empty((3, *valid.shape), dtype=np.float32)
    bands = list(_bands(valid.shape, engine.reach))
    for done, (band, reached) in enumerate(bands, 1):
        planes, known = _pad_images(images[:, :, reached], valid[reached])
        stream = engine.stream(known.shape)
        _load_planes(stream, planes, known)
        padded = np.empty((3, *known.shape), dtype=np.float32)
        stream.places(*padded)
        offset = band.start - reached.start
        result[:, band] = padded[:, offset : offset + band.stop - band.start, : valid.shape[1]]
        if progress is not None:
            progress(done, len(bands))
    return result


def _compute_sharp(engine: FocalEngine, images: Values, valid: NDArray[np.bool_], positions: Values) -> Array:
    """Return the all-in-focus image in electrons, (channels, height, width), for depths as candidate indices."""
    if not engine.images:
        engine.sharpen()
    result = np.empty((len(images), *valid.shape))
    for band, reached in _bands(valid.shape, engine.reach):
        offset = band.start - reached.start
        for channel, frames in enumerate(images[:, :, reached]):
            planes, known = _pad_images(frames, valid[reached])
            stream = engine.image_stream(known.shape, channel)
            _load_planes(stream, planes, known)
            margins = [(0, side - length) for side, length in zip(known.shape, positions[reached].shape, strict=True)]
            padded = np.empty(known.shape, dtype=np.float32)
            stream.mix(np.pad(positions[reached], margins, mode="edge"), 1, engine.factors(channel, None), padded)
            result[channel, band] = padded[offset : offset + band.stop - band.start, : valid.shape[1]]
    return result


def _separate_photographs(photographs: object) -> list[object]:
    """Return the photographs in one array, with their masks; an empty list if the array has fewer than three axes."""
    values, mask = validation.parted("photographs", photographs, "counts")
    if values.ndim < 3:
        return []
    return list(values if mask is None else np.ma.masked_array(values, mask=mask))


def _is_grey(values: Values) -> bool:
    """Return whether a photograph has three equal channels."""
    return values.ndim == 3 and values.shape[2] == 3 and bool((values == values[..., :1]).all())


def _electrons(name: str, counts: Counts, encoding: Encoding, noise: Noise) -> tuple[Array, NDArray[np.bool_]]:
    """Return the electrons of one photograph, (channels, height, width), and the map of its known pixels."""
    values = counts.values
    pixels: NDArray[np.bool_] = np.asarray(counts.known.reshape(*values.shape[:2], -1).all(axis=2))
    light = to_light(name, np.where(counts.known, values, values.dtype.type(0)), encoding, np.float64)
    planes = noise.electrons(np.moveaxis(light.reshape(*pixels.shape, -1), 2, 0))
    if pixels.any():
        planes = np.stack([fill_missing(np.where(pixels, plane, np.nan), "nearest") for plane in planes])
    return planes, pixels


def counts_in_electrons(
    photographs: list[object], encoding: Encoding, noise: Noise
) -> tuple[Values, NDArray[np.bool_], tuple[int, ...], Values]:
    """Return photographs in electrons, (channels, frames, height, width), known pixels, the shape of one, the first.

    Three equal channels become one, in the shape as well.
    """
    counts = _counts(photographs)
    first = counts[0].values
    if all(_is_grey(photo.values) for photo in counts):
        counts = [photo[..., 0] for photo in counts]
    electrons, known = zip(
        *(_electrons(f"photographs[{k}]", photo, encoding, noise) for k, photo in enumerate(counts)), strict=True
    )
    images = np.stack(electrons, axis=1).astype(np.float32, order="C")
    return images, np.ascontiguousarray(np.all(known, axis=0)), counts[0].values.shape, first
