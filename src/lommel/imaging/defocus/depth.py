"""Depth from defocus: the distance of everything in several photographs of a scene, by the blur of each part."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.cached import cached_property
from lommel.base.encoding import from_light, to_light
from lommel.estimation.noise import Noise
from lommel.imaging.defocus.photos import expose
from lommel.imaging.defocus.tiles import Tiling, Transfer
from lommel.imaging.scene import fill_missing
from lommel.imaging.sensor_light import sensor_transfer
from lommel.imaging.settings import Settings, Spectrum
from lommel.io.depthmaps import write_depth
from lommel.optics.lens import Lens
from lommel.show import depth_maps

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_USUAL, _MOST = 61, 2001  # candidates
_STEP, _LARGEST_STEP = 1.0, 2.0  # radians of defocus from one candidate to the next
_EDGE = 0.3  # or pixels that the edge of the blur moves by, where that is more: as in pixels of 3 lambda N
_SIDE = 0.35  # of a window, by which texture may lie to one side of it
_KNOWN = 0.1  # of the range of vergence: who knows no better than this knows nothing


@dataclass(frozen=True, eq=False)
class DefocusDepth:
    """What :func:`lommel.imaging.depth_from_defocus` found.

    Attributes
    ----------
    depth : ndarray, shape (height, width)
        Distance from the lens, metres; NaN where it is not known.
    deviation : ndarray, shape (height, width)
        Its standard deviation, metres; infinite where it is not known.
    misfit : ndarray, shape (height, width)
        What the photographs differ by beyond the depth found, over noise: 1 where registration and noise hold,
        more at steps of depth, at borders, where something moved. The deviation has grown with it.
    candidates : ndarray, shape (count,)
        Distances that were tried, metres.
    exposures : tuple of float
        Light of each photograph over that of the first, as it was stated or measured.
    encoding : {"srgb", "linear"}
        Of the photographs, and of `sharp`.
    """

    depth: Array
    deviation: Array
    misfit: Array
    candidates: Array
    exposures: tuple[float, ...]
    encoding: str
    _sharpen: Callable[[Array], NDArray[Any]] = field(repr=False)

    @property
    def known(self) -> float:
        """Share of the pixels whose depth is known."""
        return float(np.isfinite(self.deviation).mean())

    @cached_property
    def sharp(self) -> NDArray[Any]:
        """The image in focus everywhere, of the shape, type and encoding of the photographs, as exposed as the first.

        By Wiener's filter at the depth of each pixel, or the nearest that is known: what noise hides stays soft.
        Computed when it is first asked for. ValueError if no depth is known.
        """
        if self.known == 0.0:
            raise ValueError("no depth is known, and so there is no sharp image: the photographs have no texture")
        return self._sharpen(fill_missing(self.depth, "nearest"))

    def save(self, path: str | PathLike[str]) -> None:
        """Write the depth as a map that :func:`lommel.imaging.read_depth` reads: .tif, .npy or .pfm.

        Raises
        ------
        TypeError, ValueError
            If `path` is no path, or none of these.
        OSError
            If the file cannot be written.
        """
        write_depth(Path(path), self.depth)

    def plot(self) -> Figure:
        """Draw depth, deviation and the sharp image, where there is one, on a figure of matplotlib."""
        light = to_light("sharp", self.sharp, self.encoding, np.float64) if self.known else None
        return depth_maps.maps(self.depth, self.deviation, light)

    def __repr__(self) -> str:
        if not self.known:
            return "<DefocusDepth: no depth is known>"
        inner = np.isfinite(self.deviation)
        low, high = np.percentile(self.depth[inner], [5.0, 95.0])
        return (
            f"<DefocusDepth: known at {100.0 * self.known:.3g} %, {low:.4g} m to {high:.4g} m (5 to 95 %), "
            f"+- {1e3 * np.median(self.deviation[inner]):.3g} mm>"
        )


def depth_from_defocus(
    photographs: Sequence[ArrayLike],
    lenses: Sequence[Lens],
    pixel: float,
    *,
    encoding: str,
    noise: Noise,
    between: tuple[float, float],
    window: float = 4.0,
    candidates: int | None = None,
    wavelengths: Sequence[Spectrum] | None = None,
    exposures: Sequence[float] | None = None,
    magnification: str = "registered",
    saturation: float | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> DefocusDepth:
    """Find the distance of everything in photographs of a scene that differ in focus, or in aperture.

    Parameters
    ----------
    photographs : sequence of array_like, shape (height, width) or (height, width, channels)
        Two or more of the same scene from the same place, unsigned integers (white is their largest value) or floats.
        NaN, and the largest value of integers, mark pixels that are not known. Neither denoised nor sharpened, nor a
        JPEG of low quality: what is left of the noise is what depth is weighed by.
    lenses : sequence of Lens
        That of each photograph, focused and stopped as it was, with radially symmetric aberrations and a round
        aperture.
    pixel : float
        Pixel pitch, metres.
    encoding : {"srgb", "linear"}
        Of the values.
    noise : Noise
        Of the photographs in light, in which integers end at 1: ``white`` is electrons at white.
    between : (float, float)
        Nearest and farthest distance that is looked for, metres; the farthest may be infinite.
    window : float, default 4.0
        Rms width of the Gaussian windows in which depth is taken to be the same, pixels, 1 to 64. Larger ones know
        flat surfaces better and small things worse.
    candidates : int, optional
        How many distances are tried, equally spaced in 1 / distance. By default 61, or more where defocus would
        change by more than a radian from one to the next. Depth is found between them.
    wavelengths : sequence, optional
        As of :func:`lommel.imaging.depth_of_field`. Channels have textures of their own, and one depth.
    exposures : sequence of float, optional
        Light of each photograph over that of the first: exposure time over squared f-number, for one. By default what
        they hold on average, as a camera that meters would make it.
    magnification : {"registered", "lens"}, default "registered"
        Whether points are at the same pixel in all photographs, or each is as large as its lens, thin and of the
        sensor distance that it has, makes it: these are resampled to the scale of the first, about the middle.
    saturation : float, optional
        Stored value from which on pixels are not known.
    progress : callable, optional
        Called as ``progress(done, tiles)``.

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
    Exact PSFs, averaged over the pixels, of each candidate; noise of the light around each pixel. Nothing is assumed
    of the scene but that depth, and what of the texture noise hides, are the same in a window; its texture is
    not taken from the blur of one photograph but from the difference of two, so that the answer has no bias of a
    wrong guess (Subbarao and Surya 1994, doi:10.1007/BF02028349, and Favaro and Soatto 2005,
    doi:10.1109/TPAMI.2005.43, compare photographs alike). The deviation is that of the least cost, by its curvature,
    the noise and the size of the window, and grows with the misfit and with the slope of what is found; compare
    :func:`lommel.depth_precision`. There is no depth where it exceeds a tenth of the range, in 1 / distance, where
    other candidates cost hardly more, where the best one is the first or the last, and where half of a window is not
    known.

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
    return depth_by(
        sensor_transfer, photographs, lenses, pixel, encoding=encoding, noise=noise, between=between, window=window,
        candidates=candidates, wavelengths=wavelengths, exposures=exposures, magnification=magnification,
        saturation=saturation, progress=progress,
    )  # fmt: skip


def depth_by(
    transfer: Transfer,
    photographs: Sequence[ArrayLike],
    lenses: Sequence[Lens],
    pixel: float,
    *,
    encoding: str,
    noise: Noise,
    between: tuple[float, float],
    window: float = 4.0,
    candidates: int | None = None,
    wavelengths: Sequence[Spectrum] | None = None,
    exposures: Sequence[float] | None = None,
    magnification: str = "registered",
    saturation: float | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> DefocusDepth:
    """Do as :func:`lommel.imaging.depth_from_defocus` by other PSFs than those of the lenses.

    Parameters
    ----------
    transfer : callable
        Makes transfer functions as :func:`lommel.estimation.pixel_transfer.pixel_transfer` does, of its arguments.
    photographs, lenses, pixel, encoding, noise, between, window, candidates, wavelengths, exposures, magnification, \
    saturation, progress
        As of :func:`lommel.imaging.depth_from_defocus`.

    Returns
    -------
    DefocusDepth

    Raises
    ------
    TypeError, ValueError
        As :func:`lommel.imaging.depth_from_defocus`.
    """
    lights = _lenses(lenses)
    if not isinstance(photographs, Sequence | np.ndarray) or len(photographs) != len(lights):
        raise ValueError(f"photographs must be as many as lenses, {len(lights)}, got {_count(photographs)}")
    pitch = validation.pixel(pixel, metric=True)
    for lens in lights:
        validation.pixel_on(pitch, lens.wavelength * lens.working_f_number, metric=True)
    validation.instance("noise", noise, Noise)
    width = validation.real("window", window, least=1.0, below=64.0 + 1e-9, unit="pixels")
    if progress is not None and not callable(progress):
        raise TypeError(f"progress must be callable, got {validation.shown(progress)}")
    vergence = _candidates(between, candidates, lights, pitch)
    first = validation.array("photographs[0]", photographs[0])
    settings = Settings(wavelengths=wavelengths)
    exposed = expose(
        photographs, lights, encoding=encoding, noise=noise, exposures=exposures, magnification=magnification,
        saturation=saturation, window=width,
    )  # fmt: skip
    with np.errstate(divide="ignore"):
        distances = 1.0 / vergence
    step = vergence[1] - vergence[0]
    spectra = [
        ((channel, 1.0),) if isinstance(channel, float) else tuple(channel)
        for channel in settings.channels(first.shape, lights[0].wavelength)
    ]
    tiling = Tiling.of(exposed, lights, distances, spectra, pitch, width, transfer)
    position, variance, misfit, level = tiling.search(progress)
    deviation = np.hypot(np.sqrt(variance), _SIDE * width * _slope(position, width)) * step
    unknown = ~(deviation <= _KNOWN * (vergence[-1] - vergence[0])) | ~np.isfinite(position)
    u = np.where(unknown, np.nan, vergence[0] + step * position)
    with np.errstate(invalid="ignore", divide="ignore"):
        depth = 1.0 / u
        sigma = np.where(unknown, np.inf, deviation * depth**2)

    def sharpen(filled: Array) -> NDArray[Any]:
        place = (1.0 / filled - vergence[0]) / step
        # What does not fit the photographs is as noise to the sharp image.
        clean = float(np.median(level) / np.maximum(misfit, 1.0).mean())
        electrons = np.moveaxis(tiling.sharp(place, clean), 0, 2).reshape(first.shape)
        light = noise.image(electrons if first.ndim == 2 else np.moveaxis(electrons, 2, 0))
        light = light if first.ndim == 2 else np.moveaxis(light, 0, 2)
        if first.dtype.kind != "f":
            light = np.clip(light, 0.0, 1.0)
        elif encoding == "srgb":
            light = np.maximum(light, 0.0)
        return from_light(light, encoding, first.dtype)

    maps = [np.asarray(each, dtype=np.float64) for each in (depth, sigma, misfit)]
    return DefocusDepth(maps[0], maps[1], maps[2], distances, exposed.exposures, encoding, sharpen)


def _slope(position: NDArray[np.floating[Any]], window: float) -> Array:
    """Return how much the position changes from one pixel to the next, over a window; 0 beside what is not known."""
    reach, square = max(1, round(window)), np.zeros(position.shape)
    for axis in (0, 1):
        side = position.shape[axis]
        low, high = (np.clip(np.arange(side) + shift, 0, side - 1) for shift in (-reach, reach))
        between = np.maximum(high - low, 1).reshape((-1, 1) if axis == 0 else (1, -1))
        change = np.take(position, high, axis=axis) - np.take(position, low, axis=axis)
        square += np.nan_to_num(change / between) ** 2
    return np.asarray(np.sqrt(square))


def _lenses(lenses: Sequence[Lens]) -> list[Lens]:
    """Return two lenses or more whose PSFs are round."""
    if not isinstance(lenses, Sequence) or not all(isinstance(lens, Lens) for lens in lenses):
        raise TypeError(f"lenses must be a sequence of Lens, one for each photograph, got {validation.shown(lenses)}")
    if len(lenses) < 2:
        raise ValueError(
            f"lenses must be two or more: one photograph does not tell blur from soft texture; got {len(lenses)}"
        )
    for k, lens in enumerate(lenses):
        if not lens.aberrations.radial or lens.aberrations.shape != ():
            raise ValueError(f"lenses[{k}] must have radially symmetric aberrations, and one set of them")
        if lens.spider or lens.vignetting or lens.mask:
            raise ValueError(
                f"lenses[{k}] must have a round aperture, without spider, vignetting and mask: leave these out where "
                "they take little of the light"
            )
    return list(lenses)


def _count(photographs: Any) -> str:
    return str(len(photographs)) if hasattr(photographs, "__len__") else validation.shown(photographs)


def _candidates(between: tuple[float, float], count: int | None, lenses: list[Lens], pixel: float) -> Array:
    """Return vergences, equally spaced, from that of the farthest distance to that of the nearest."""
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
        if count > _MOST:
            raise ValueError(
                f"between spans defocus for which it takes {count} candidates, more than {_MOST}: name nearer limits"
            )
    else:
        least = max(9, math.ceil(span / _LARGEST_STEP) + 1)
        count = validation.integer("candidates", count, least=least, most=_MOST)
    return np.linspace(1.0 / far, 1.0 / near, count)
