"""Depth from defocus: the depth map of a scene from photographs with different focus or aperture."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.cached import cached_property
from lommel.base.encoding import from_light, to_light
from lommel.estimation.noise import Noise
from lommel.imaging.blur import require_round
from lommel.imaging.defocus_costs import Exposures, Tiling, Transfer
from lommel.imaging.photograph import fill_missing, require_image
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
_KNOWN = 0.1  # of the range of vergence: depths of a larger standard error are unknown


@dataclass(frozen=True, eq=False)
class DefocusDepth:
    """What :func:`lommel.imaging.depth_from_defocus` found.

    Attributes
    ----------
    depth : ndarray, shape (height, width)
        Distance from the lens, metres; NaN where depth cannot be determined.
    deviation : ndarray, shape (height, width)
        Its standard error, metres; inf where depth cannot be determined.
    misfit : ndarray, shape (height, width)
        Residual difference of the photographs at the depth found, over noise: 1 where registration and noise hold,
        more at steps of depth, at borders, where something moved. The deviation includes it.
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
    _sharpen: Callable[[Array], Values]

    @property
    def known(self) -> float:
        """Share of the pixels whose depth is known."""
        return float(np.isfinite(self.deviation).mean())

    @cached_property
    def sharp(self) -> Values:
        """The all-in-focus image, like the first photograph, by Wiener's filter; ValueError if no depth is known."""
        if self.known == 0.0:
            raise ValueError("no depth is known, and so there is no sharp image: the photographs have no texture")
        return self._sharpen(np.asarray(fill_missing(self.depth, "nearest"), dtype=np.float64))

    def save(self, path: str | PathLike[str]) -> None:
        """Write the depth map to `path`: .tif, .npy or .pfm; ValueError for another suffix."""
        write_depth(Path(path), self.depth)

    def plot(self) -> Figure:
        """Draw depth, standard deviation and the all-in-focus image on a figure of matplotlib."""
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
    transfer: Transfer = sensor_transfer,
    progress: Callable[[int, int], object] | None = None,
) -> DefocusDepth:
    """Find the distance of everything in photographs of a scene that differ in focus, or in aperture.

    Parameters
    ----------
    photographs : sequence of array_like, shape (height, width) or (height, width, channels)
        Two or more of the same scene from the same place, unsigned integers (white is their largest value) or floats.
        NaN, and the largest value of integers, mark unknown pixels. Neither denoised nor sharpened, nor a JPEG of low
        quality: depths are weighed by the noise.
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
        Rms width of the Gaussian windows in which depth is taken to be constant, pixels, 1 to 64. Larger ones are
        more precise on flat surfaces, and resolve less.
    candidates : int, optional
        Number of candidate distances, equally spaced in 1 / distance. By default 61, or more where defocus would
        change by more than a radian from one to the next. Depth is found between them.
    wavelengths : sequence, optional
        As of :func:`lommel.imaging.depth_of_field`. Channels have textures of their own, and one depth.
    exposures : sequence of float, optional
        Light of each photograph over that of the first: exposure time over squared f-number, for example. By default
        the ratio of their means, as with a metered exposure.
    magnification : {"registered", "lens"}, default "registered"
        Whether points are at the same pixel in all photographs, or each is as large as its lens, thin and of the
        sensor distance that it has, makes it: these are resampled to the scale of the first, about the middle.
    saturation : float, optional
        Stored value from which on pixels are saturated, and left out.
    transfer : callable, optional
        Function that makes the transfer functions, with the arguments and the result of
        :func:`lommel.estimation.pixel_transfer.pixel_transfer`: for other PSFs than those of the lenses, the default.
    progress : callable, optional
        Called as ``progress(done, tiles)`` after each tile.

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
    lights = _lenses(lenses)
    if not isinstance(photographs, Sequence | np.ndarray) or len(photographs) != len(lights):
        count = len(photographs) if hasattr(photographs, "__len__") else validation.shown(photographs)
        raise ValueError(f"photographs must be as many as lenses, {len(lights)}, got {count}")
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
    tiling = Tiling(exposed, lights, distances, spectra, pitch, width, transfer)
    position, variance, misfit, level = tiling.search(progress)
    deviation = np.hypot(np.sqrt(variance), _SIDE * width * _slope(position, width)) * step
    unknown = ~(deviation <= _KNOWN * (vergence[-1] - vergence[0])) | ~np.isfinite(position)
    u = np.where(unknown, np.nan, vergence[0] + step * position)
    with np.errstate(invalid="ignore", divide="ignore"):
        depth = 1.0 / u
        sigma = np.where(unknown, np.inf, deviation * depth**2)

    def sharpen(filled: Array) -> Values:
        place = (1.0 / filled - vergence[0]) / step
        # What does not fit the photographs is as noise to the sharp image.
        clean = float(np.median(level) / np.maximum(misfit, 1.0).mean())
        light = np.moveaxis(noise.image(tiling.sharp(place, clean)), 0, 2).reshape(first.shape)
        if first.dtype.kind != "f":
            light = np.clip(light, 0.0, 1.0)
        elif encoding == "srgb":
            light = np.maximum(light, 0.0)
        return from_light(light, encoding, first.dtype)

    return DefocusDepth(depth, sigma, misfit, distances, exposed.exposures, encoding, sharpen)


def _slope(position: Values, window: float) -> Array:
    """Return the change of the position per pixel, over a window; 0 beside unknown pixels."""
    reach, square = max(1, round(window)), np.zeros(position.shape)
    for axis in (0, 1):
        side = position.shape[axis]
        low, high = (np.clip(np.arange(side) + shift, 0, side - 1) for shift in (-reach, reach))
        between = np.maximum(high - low, 1).reshape((-1, 1) if axis == 0 else (1, -1))
        change = np.take(position, high, axis=axis) - np.take(position, low, axis=axis)
        square += np.nan_to_num(change / between) ** 2
    return np.asarray(np.sqrt(square))


def _lenses(lenses: Sequence[Lens]) -> list[Lens]:
    """Return two lenses or more whose PSFs are circular."""
    if not isinstance(lenses, Sequence) or not all(isinstance(lens, Lens) for lens in lenses):
        raise TypeError(f"lenses must be a sequence of Lens, one for each photograph, got {validation.shown(lenses)}")
    if len(lenses) < 2:
        raise ValueError(
            f"lenses must be two or more: one photograph cannot separate blur from soft texture; got {len(lenses)}"
        )
    for k, lens in enumerate(lenses):
        require_round(f"lenses[{k}]", lens)
    return list(lenses)


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


MAGNIFICATIONS = ("registered", "lens")
_LEAK, _FAR = 0.02, 6.0  # of amplitude, and from how many windows away
_LEAST = 1e-3  # of the mean variance, for pixels of no light that are read without noise


def expose(
    photographs: Sequence[ArrayLike],
    lenses: Sequence[Lens],
    *,
    encoding: str,
    noise: Noise,
    exposures: Sequence[float] | None,
    magnification: str,
    saturation: float | None,
    window: float,
) -> Exposures:
    """Return photographs as electrons; arguments as of :func:`lommel.imaging.depth_from_defocus`."""
    stored = {f"photographs[{k}]": validation.array(f"photographs[{k}]", one) for k, one in enumerate(photographs)}
    for name, one in stored.items():
        require_image(name, one.shape)
    if len({one.shape for one in stored.values()}) > 1:
        shapes = ", ".join(str(one.shape) for one in stored.values())
        raise ValueError(f"photographs must be of one shape, got {shapes}")
    electrons, known = zip(
        *(_electrons(name, one, encoding, noise, saturation) for name, one in stored.items()), strict=True
    )
    images = np.stack(electrons, axis=1)
    valid = np.all(known, axis=0)
    if not valid.any():
        raise ValueError("photographs have no pixel that is known in all of them: they are NaN or saturated")
    if validation.choice("magnification", magnification, MAGNIFICATIONS) == "lens":
        images, valid = _rescaled(images, valid, lenses)
    light = _relative(images[..., valid], exposures)
    mean = _smooth(images, window)
    energy = (images - mean) ** 2
    # Stronger texture beyond a window is noise too, since no filter ends with the window.
    leaked = _LEAK**2 * np.maximum(_smooth(energy, _FAR * window) - _smooth(energy, window), 0.0)
    variances = noise.variance(np.maximum(mean, 0.0)) + leaked
    over = np.asarray(light)[:, None, None]
    variances = np.maximum(variances, _LEAST * float(variances.mean())) / over**2
    if not np.all(variances > 0.0):
        raise ValueError("noise must be above 0: the photographs hold no light, and reading adds no noise")
    return Exposures((images / over).astype(np.float32), variances.astype(np.float32), valid, light)


def _smooth(images: Array, width: float) -> Array:
    """Return means in nearly Gaussian windows of an rms width, by three box filters."""
    from scipy.ndimage import uniform_filter1d

    side = max(1, round(math.sqrt(4.0 * width**2 + 1.0)))
    for axis in (-2, -1):
        for _ in range(3):
            images = uniform_filter1d(images, side, axis=axis, mode="reflect")
    return images


def _electrons(
    name: str, values: Values, encoding: str, noise: Noise, saturation: float | None
) -> tuple[Array, NDArray[np.bool_]]:
    """Return the electrons of one photograph, channels first, and its known pixels; others are filled by these."""
    known = np.ones(values.shape, dtype=np.bool_)
    if values.dtype.kind == "f":
        known = np.isfinite(values)
    elif values.dtype.kind == "u":
        known = values < np.iinfo(values.dtype.str).max
    if saturation is not None:
        with np.errstate(invalid="ignore"):
            known &= values < validation.real("saturation", saturation, above=0.0)
    pixels: NDArray[np.bool_] = np.asarray(known.reshape(*known.shape[:2], -1).all(axis=2))
    if not pixels.all() and pixels.any():
        from scipy.ndimage import distance_transform_edt

        nearest = distance_transform_edt(~pixels, return_distances=False, return_indices=True)
        values = values[tuple(nearest)]
    elif not pixels.any():
        return np.zeros((1, *pixels.shape)), pixels
    light = to_light(name, values, encoding, np.float64)
    return noise.electrons(np.moveaxis(light.reshape(*pixels.shape, -1), 2, 0)), pixels


def _relative(images: Array, exposures: Sequence[float] | None) -> tuple[float, ...]:
    """Return the light of each photograph over that of the first, as stated or as measured."""
    if exposures is not None:
        given = validation.real_array("exposures", exposures)
        if given.shape != (images.shape[1],) or not np.all(given > 0.0):
            raise ValueError(
                f"exposures must be {images.shape[1]} numbers > 0, one for each photograph, "
                f"got {validation.shown(exposures)}"
            )
        return tuple((given / given[0]).tolist())
    sums = images.sum(axis=(0, 2))
    if not np.all(sums > 0.0):
        raise ValueError("photographs must hold light on average to compare their exposures; give exposures=")
    return tuple((sums / sums[0]).tolist())


def _rescaled(images: Array, valid: NDArray[np.bool_], lenses: Sequence[Lens]) -> tuple[Array, NDArray[np.bool_]]:
    """Return images enlarged about their middle to the sensor distance of the first, and their known pixels."""
    from scipy.ndimage import affine_transform

    out, known = images.copy(), valid.copy()
    middle = 0.5 * (np.array(valid.shape) - 1.0)
    for k, lens in enumerate(lenses[1:], 1):
        scale = lens.sensor_distance / lenses[0].sensor_distance
        offset, zoom = middle * (1.0 - scale), scale * np.eye(2)
        for channel in range(len(images)):
            out[channel, k] = affine_transform(images[channel, k], zoom, offset, order=5, mode="mirror")
        whole = affine_transform(valid.astype(np.float64), zoom, offset, order=1, mode="constant", cval=0.0)
        known &= whole > 1.0 - 1e-6
    return out, known
