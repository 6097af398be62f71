"""Depth from defocus: the depth map of a scene from photographs with different focus or aperture."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import options, validation
from lommel.base.arrays import Array, Json, Values, plain
from lommel.base.cached import cached_property
from lommel.base.encoding import from_light, to_light
from lommel.core.engine import FocalStream
from lommel.estimation.focal_model import FocalLight, Transfer, transfer_curve
from lommel.imaging.defocus_verdict import DefocusVerdict, judged
from lommel.imaging.focal_engine import (
    BLOCK,
    CONTRAST,
    DefocusKeywords,
    DefocusOptions,
    FocalEngine,
    FocalTask,
    Registration,
    processors,
    ranged,
    relative_exposures,
)
from lommel.imaging.photograph import fill_missing, require_image
from lommel.imaging.settings import Settings, Spectrum
from lommel.io.depth_maps import write_depth
from lommel.optics.lens import Lens, pixel_of
from lommel.recorded.counts import Counts
from lommel.recorded.noise import Noise
from lommel.show import estimates

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_MOST = 2001  # largest number of candidates
_LEAST_OF_BLOCK = 2.0  # rms width of windows, pixels, above which blocks have a side of four; below, of two
_ROWS = 1024  # rows computed together
_WHOLE = 16  # pixels a side that squares and blocks divide
_LEAST_SIDE = 160  # pixels a side computed together: smaller photographs are extended by mirrored, unknown pixels
_LEAST_VARIANCE = 1e-3  # variance of a pixel read without noise, over the mean light


@dataclass(frozen=True, eq=False)
class DefocusDepth:
    """Depth map estimated by :func:`lommel.imaging.depth_from_defocus`.

    Attributes
    ----------
    depth : ndarray, shape (height, width)
        Distance from the lens, metres; NaN where depth cannot be determined.
    errors : ndarray, shape (height, width)
        Its standard error, metres; inf where depth cannot be determined.
    misfit : ndarray, shape (height, width)
        Residual difference of the photographs at the estimated depth, relative to the noise: 1 where registration and
        noise model hold, more at depth edges, at borders and where something moved. The standard error includes it.
    candidates : ndarray, shape (count,)
        Candidate distances, metres.
    exposures : tuple of float
        Exposure of each photograph relative to the first, as given or measured.
    encoding : {"srgb", "linear"}
        Of the photographs, and of `sharp`.
    """

    depth: Array
    errors: Array
    misfit: Array
    candidates: Array
    exposures: tuple[float, ...]
    encoding: str
    _sharpen: Callable[[Array], Values]
    _judge: Callable[[], DefocusVerdict]

    @property
    def known(self) -> float:
        """Fraction of the pixels whose depth is known."""
        return float(np.isfinite(self.errors).mean())

    @cached_property
    def verdict(self) -> DefocusVerdict:
        """Whether registration, noise and lenses agree with the photographs; computed on first use, some seconds."""
        return self._judge()

    @cached_property
    def sharp(self) -> Values:
        """The all-in-focus image by Wiener filtering, encoded like the photographs; ValueError without depths."""
        if self.known == 0.0:
            raise ValueError("no depth is known, and so there is no sharp image: the photographs have no texture")
        return self._sharpen(np.asarray(fill_missing(self.depth, "nearest"), dtype=np.float64))

    def to_dict(self) -> Json:
        """Return the result as plain data, as JSON has it, without images; it is judged then, if it was not before.

        Returns
        -------
        dict
            What the verdict has; the shape, the number of candidates, the
            exposures, the fraction that is known, and there the percentiles of depth and the median of its standard
            error, metres; None where these are not finite.
        """
        facts, inner = self.verdict.to_dict(), np.isfinite(self.errors)
        ends = np.percentile(self.depth[inner], [5.0, 50.0, 95.0]).tolist() if inner.any() else None
        mine: Json = plain(
            {
                "shape": self.depth.shape,
                "candidates": len(self.candidates),
                "exposures": self.exposures,
                "known": self.known,
                "depth": ends and dict(zip(("5 %", "50 %", "95 %"), ends, strict=True)),
                "error": float(np.median(self.errors[inner])) if inner.any() else None,
            }
        )
        return facts | mine

    def save(self, path: str | PathLike[str]) -> None:
        """Write the depth map to `path`: .tif, .npy or .pfm; ValueError for another suffix."""
        write_depth(Path(path), self.depth)

    def plot(self) -> Figure:
        """Draw depth, its standard error and the all-in-focus image on a figure of matplotlib."""
        light = to_light("sharp", self.sharp, self.encoding, np.float64) if self.known else None
        return estimates.maps(self.depth, self.errors, light)

    def __repr__(self) -> str:
        if not self.known:
            return "<DefocusDepth: no depth is known>"
        inner = np.isfinite(self.errors)
        low, high = np.percentile(self.depth[inner], [5.0, 95.0])
        return (
            f"<DefocusDepth: known at {100.0 * self.known:.3g} %, {low:.4g} m to {high:.4g} m (5 to 95 %), "
            f"+- {1e3 * np.median(self.errors[inner]):.3g} mm>"
        )


@options.shares(DefocusKeywords, DefocusOptions)
def depth_from_defocus(
    photographs: Sequence[ArrayLike],
    lenses: Sequence[Lens],
    pixel: float,
    *,
    encoding: str,
    noise: Noise,
    between: tuple[float, float],
    candidates: int | None = None,
    wavelengths: Sequence[Spectrum] | None = None,
    f_number_error: float = 0.0,
    focus_error: float = 0.0,
    transfer: Transfer = transfer_curve,
    progress: Callable[[int, int], object] | None = None,
    **given: Unpack[DefocusKeywords],
) -> DefocusDepth:
    """Estimate a depth map from photographs of a scene that differ in focus or aperture (depth from defocus).

    Parameters
    ----------
    photographs : sequence of array_like, shape (height, width) or (height, width, channels)
        Two or more of the same scene from the same place, unsigned integers (white is their largest value) or floats.
        NaN, and the largest value of integers, mark unknown pixels. Neither denoised nor sharpened, nor a JPEG of low
        quality: depths are weighed by the noise.
    lenses : sequence of Lens
        Lens of each photograph, at its focus distance and f-number; circular apertures and radially symmetric
        aberrations only.
    pixel : float
        Pixel pitch, metres.
    encoding : {"srgb", "linear"}
        Of the values.
    noise : Noise
        Noise of the linear photographs, whose white is 1: ``white`` is the number of electrons at white.
    between : (float, float)
        Nearest and farthest candidate distance, metres; the farthest may be infinite.
    candidates : int, optional
        Number of candidate distances, equally spaced in 1 / distance, up to three more so that it is one more than a
        multiple of four. By default 61, or more where defocus would change by more than 0.75 rad from one to the
        next. They reach a little beyond the range; depth is interpolated between them.
    wavelengths : sequence, optional
        As of :func:`lommel.imaging.depth_of_field`. Channels have separate textures and one depth.
    f_number_error : float, default 0.0
        Relative standard error of the f-numbers, which are all off alike, below 0.5: of a lens that is not measured
        0.05, say. Those of the pixel pitch count as much, of the focal length twice. 0 if lenses are as stated.
    focus_error : float, default 0.0
        Standard error of each focus distance by itself, dioptres (1 / m).
    transfer : callable, optional
        ``transfer(lens, vergence, spectrum, pixel)``, for other PSFs than those of the lenses: a function of the
        frequency, cycles per pixel, to the transfer function of the optics, without that of the pixel, of shape
        ``(len(vergence), *frequency.shape)``. `spectrum` has pairs of wavelengths, metres, and weights.
    progress : callable, optional
        Called as ``progress(done, bands)`` after each band of rows.
    {options}

    Returns
    -------
    DefocusDepth

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range or of another shape, if a lens is not radially symmetric, if there are not two
        photographs or more, or if `candidates` are more than two radians of defocus from one another.

    Notes
    -----
    The residual of two photographs, each through the transfer function of the other, is noise at the true depth,
    whatever the texture, so a wrong assumption about the texture does not bias it (compare Subbarao and Surya 1994,
    doi:10.1007/BF02028349, and Favaro and Soatto 2005, doi:10.1109/TPAMI.2005.43). Transfer functions are those of a
    scene that is continuous: of the optics and the pixel, without aliases, which are noise. The filters are those of
    :class:`lommel.imaging.LiveDepth`, between whose blocks energies are interpolated. The standard error follows from
    the curvature of the energy at its minimum, the noise and the size of the window, and grows with the misfit, with
    the slope of the depth map and next to its edges; compare :func:`lommel.depth_precision`. It has a part of errors
    that are stated of lenses, which shift whole surfaces; without these it holds for lenses exactly as stated. Depth
    is NaN where its standard error exceeds a sixth of the range in 1 / distance, where another candidate costs hardly
    more, where the best candidate is the first or the last, and where half of a window or more is within the blur of
    the border or of unknown pixels.

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
    ...     pair, lenses, 4e-6, encoding="linear", noise=lm.Noise(white=1e4, read=3), between=(1.2, 2.0)
    ... )
    >>> round(float(np.median(found.depth)), 2)
    1.5
    """
    options.require_known(depth_from_defocus, given, DefocusKeywords)
    chosen = DefocusOptions(**given)
    exposures, saturation = chosen.exposures, chosen.saturation
    if isinstance(exposures, str):
        said = validation.shown(exposures)
        raise TypeError(f'exposures must be numbers, got {said}; "smooth" ratios are those of LiveDepth')
    pitch = pixel_of(lenses, pixel)
    photos = _one_of_each(photographs, lenses)
    noise = validation.instance("noise", noise, Noise).poisson
    width = validation.real("window", chosen.window, least=1.0, below=64.0 + 1e-9, unit="pixels")
    validation.function("progress", progress, required=False)
    ends, vergence = ranged(between, lenses, pitch, candidates, _MOST)
    if saturation is not None:
        validation.real("saturation", saturation, above=0.0)
    validation.real("f_number_error", f_number_error, least=0.0, below=0.5)
    validation.real("focus_error", focus_error, least=0.0, unit="dioptres")
    counts = _counts(photos, saturation)
    first = counts[0].values
    if wavelengths is None and all(_is_grey(one.values) for one in counts):  # stored three times, it was counted once
        counts = [one[..., 0] for one in counts]
    electrons, known = zip(
        *(_electrons(f"photographs[{k}]", one, encoding, noise) for k, one in enumerate(counts)), strict=True
    )
    images, valid = (
        np.stack(electrons, axis=1).astype(np.float32, order="C"),
        np.ascontiguousarray(np.all(known, axis=0)),
    )
    if not valid.any():
        raise ValueError("photographs have no pixel that is known in all of them: they are NaN or saturated")
    registered = Registration(chosen.magnification, lenses, valid.shape, processors())
    for channel in images if registered else ():
        channel[1:] = registered(list(channel), math.inf, valid.view(np.uint8))[1:]
    # Registration makes NaN of what depends on unknown pixels.
    valid = np.isfinite(images).all(axis=(0, 1)) & valid
    means = images[..., valid].mean(axis=(0, 2), dtype=np.float64)
    if not np.all(means > 0.0):
        told = ", ".join(f"{each:.4g}" for each in means)
        raise ValueError(f"photographs must hold light on average, got {told} electrons a pixel")
    mean, exposed = float(means[0]), tuple((means / means[0]).tolist())
    exposed = exposed if exposures is None else relative_exposures(exposures, len(lenses))
    # All frames at the exposure of the first: one level of light holds for all tables.
    images /= np.asarray(exposed, dtype=np.float32)[:, None, None]
    channels = Settings(wavelengths=wavelengths).channels(counts[0].values.shape, lenses[0].wavelength)
    spectra = [((each, 1.0),) if isinstance(each, float) else tuple(each) for each in channels]
    block = BLOCK if width >= _LEAST_OF_BLOCK else BLOCK // 2
    sizes = width, block, block, processors()
    task = FocalTask(lenses, vergence, spectra, pitch, ends, *sizes, transfer, registered.scales)
    read = math.sqrt(float(np.mean(np.square(noise.read))) + _LEAST_VARIANCE * mean)
    engine = FocalEngine(task, FocalLight(mean, read, exposed, CONTRAST))
    position, spread, misfit = _search(engine, images, valid, progress)
    # Blur changes linearly with 1 / distance, so candidates have equal steps of it.
    step = float(vergence[1] - vergence[0])
    found, errors = vergence[0] + step * position.astype(np.float64), step * spread
    stated = f_number_error
    if f_number_error or focus_error:
        stated = _add_lens_errors(engine, lenses, (f_number_error, focus_error), found, errors, spread)
    with np.errstate(invalid="ignore", divide="ignore"):
        depth, distances = 1.0 / found, 1.0 / vergence
        # d(1 / v) = -dv / v^2.
        sigma = np.where(np.isfinite(errors), errors * depth**2, np.inf)

    def sharpen(filled: Array) -> Values:
        place = np.asarray((1.0 / filled - vergence[0]) / step, dtype=np.float32)
        light = np.moveaxis(noise.image(_sharp(engine, images, valid, place)), 0, 2)
        light = np.broadcast_to(light, (*valid.shape, *first.shape[2:])) if first.ndim == 3 else light[..., 0]
        if first.dtype.kind != "f":
            light = np.clip(light, 0.0, 1.0)
        elif encoding == "srgb":
            light = np.maximum(light, 0.0)
        return from_light(light, encoding, first.dtype)

    judge = partial(judged, engine, images, valid, spread, misfit, found, stated)
    return DefocusDepth(depth, sigma, misfit.astype(np.float64), distances, exposed, encoding, sharpen, judge)


def _one_of_each(photographs: object, lenses: Sequence[Lens]) -> list[object]:
    """Return the photographs, with their masks; ValueError unless as many as lenses, at least two."""
    if len(lenses) < 2:
        raise ValueError(
            f"lenses must be two or more: one photograph cannot separate blur from soft texture; got {len(lenses)}"
        )
    given = list(photographs) if isinstance(photographs, list | tuple) else _separate_photographs(photographs)
    if len(given) != len(lenses):
        count = len(given) or validation.shown(photographs)
        raise ValueError(f"photographs must be as many as lenses, {len(lenses)}, got {count}")
    return given


def _counts(photographs: list[object], saturation: float | None) -> list[Counts]:
    """Return photographs as counts; ValueError unless they are images of one shape."""
    shape = "(height, width) or (height, width, channels)"
    counts = []
    for k, one in enumerate(photographs):
        counts.append(Counts.of(f"photographs[{k}]", one, sides=(2, 3), shape=shape, saturation=saturation))
        require_image(f"photographs[{k}]", counts[k].values.shape)
    if len({one.values.shape for one in counts}) > 1:
        shapes = ", ".join(str(one.values.shape) for one in counts)
        raise ValueError(f"photographs must be of one shape, got {shapes}")
    return counts


def _add_lens_errors(
    engine: FocalEngine,
    lenses: Sequence[Lens],
    stated: tuple[float, float],
    found: Array,
    errors: Array,
    spread: Values,
) -> float:
    """Add standard errors of f-numbers and foci to those of 1 / distance; return that of the size of blur.

    Where the sum is too large, depth is not known.
    """
    f_number_error, focus_error = stated
    foci = [1.0 / lens.focus_distance for lens in lenses]
    inner = np.isfinite(errors)
    of_f_number, *of_foci = engine.by_lenses(found[inner])
    # Frames of one focus share its error.
    shared = [np.sum([by for by, each in zip(of_foci, foci, strict=True) if each == one], 0) for one in set(foci)]
    errors[inner] = np.sqrt(
        errors[inner] ** 2 + (f_number_error * of_f_number) ** 2 + focus_error**2 * np.square(shared).sum(axis=0)
    )
    lost = inner & (errors > engine.known)
    found[lost], errors[lost], spread[lost] = math.nan, math.inf, math.inf
    if len(shared) == 1:
        return f_number_error
    # Blurs of two frames differ by the difference of their foci: two independent errors e change it by sqrt(2) e.
    return math.hypot(f_number_error, math.sqrt(2.0) * focus_error / (max(foci) - min(foci)))


def _bands(shape: tuple[int, int], reach: int) -> Iterator[tuple[slice, slice]]:
    """Yield the rows computed together, and the rows they depend on, in whole squares and blocks."""
    for top in range(0, shape[0], _ROWS):
        bottom = min(top + _ROWS, shape[0])
        # From a multiple of 16 rows on, so that squares and blocks are those of the whole photograph.
        above = max(0, top - reach) // _WHOLE * _WHOLE
        yield slice(top, bottom), slice(above, min(shape[0], bottom + reach))


def _framed(images: Values, valid: NDArray[np.bool_]) -> tuple[list[Values], NDArray[np.uint8]]:
    """Return planes mirrored up to a size of whole squares, and a map of known pixels: 2 where mirrored."""
    sides = [max(_LEAST_SIDE, math.ceil(side / _WHOLE) * _WHOLE) for side in valid.shape]
    more = [(0, side - own) for side, own in zip(sides, valid.shape, strict=True)]
    planes = [np.pad(one, more, mode="symmetric") for one in images.reshape(-1, *valid.shape)]
    return planes, np.pad(valid.astype(np.uint8), more, constant_values=2)


def _take(stream: FocalStream, planes: list[Values], known: NDArray[np.uint8]) -> None:
    """Load planes, in electrons, into a stream."""
    # Gains are polynomials in x and y: a constant 1, for photographs at equal exposure.
    gains = np.zeros((len(planes), 6), dtype=np.float32)
    gains[:, 0] = 1.0
    stream.take(planes, gains, 0.0, math.inf, known)


def _search(
    engine: FocalEngine, images: Values, valid: NDArray[np.bool_], progress: Callable[[int, int], object] | None
) -> NDArray[np.float32]:
    """Return position and its standard error, in candidates, and misfit of each pixel."""
    found = np.empty((3, *valid.shape), dtype=np.float32)
    bands = list(_bands(valid.shape, engine.reach))
    for done, (inside, around) in enumerate(bands, 1):
        planes, known = _framed(images[:, :, around], valid[around])
        stream = engine.stream(known.shape)
        _take(stream, planes, known)
        made = np.empty((3, *known.shape), dtype=np.float32)
        stream.places(*made)
        first = inside.start - around.start
        found[:, inside] = made[:, first : first + inside.stop - inside.start, : valid.shape[1]]
        if progress is not None:
            progress(done, len(bands))
    return found


def _sharp(engine: FocalEngine, images: Values, valid: NDArray[np.bool_], place: Values) -> Array:
    """Return the electrons of the scene in focus, (channels, height, width), at positions of candidates."""
    if not engine.images:
        engine.sharpen()
    out = np.empty((len(images), *valid.shape))
    for inside, around in _bands(valid.shape, engine.reach):
        first = inside.start - around.start
        for channel, several in enumerate(images[:, :, around]):
            planes, known = _framed(several, valid[around])
            stream = engine.image_stream(known.shape, channel)
            _take(stream, planes, known)
            more = [(0, side - own) for side, own in zip(known.shape, place[around].shape, strict=True)]
            made = np.empty(known.shape, dtype=np.float32)
            stream.mix(np.pad(place[around], more, mode="edge"), 1, engine.factors(channel, None), made)
            out[channel, inside] = made[first : first + inside.stop - inside.start, : valid.shape[1]]
    return out


def _separate_photographs(photographs: object) -> list[object]:
    """Return the photographs of one array or container, with their masks; none if it has no axis for them."""
    values, hidden = validation.parted("photographs", photographs)
    if values.ndim < 3:
        return []
    return list(values if hidden is None else np.ma.masked_array(values, mask=hidden))


def _is_grey(values: Values) -> bool:
    """Return whether a photograph has three equal channels."""
    return values.ndim == 3 and values.shape[2] == 3 and bool((values == values[..., :1]).all())


def _electrons(name: str, counts: Counts, encoding: str, noise: Noise) -> tuple[Array, NDArray[np.bool_]]:
    """Return the electrons of one photograph, channels first, and its known pixels."""
    values = counts.values
    pixels: NDArray[np.bool_] = np.asarray(counts.known.reshape(*values.shape[:2], -1).all(axis=2))
    light = to_light(name, np.where(counts.known, values, values.dtype.type(0)), encoding, np.float64)
    planes = noise.electrons(np.moveaxis(light.reshape(*pixels.shape, -1), 2, 0))
    if pixels.any():
        planes = np.stack([fill_missing(np.where(pixels, plane, np.nan), "nearest") for plane in planes])
    return planes, pixels
