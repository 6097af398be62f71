"""Depth from defocus: the depth map of a scene from photographs with different focus or aperture."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
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
from lommel.estimation.pixel_transfer import half_window, pixel_of, texture_frequencies
from lommel.imaging.photograph import fill_missing, require_image
from lommel.imaging.sensor_light import sensor_transfer
from lommel.imaging.settings import Settings, Spectrum
from lommel.io.photos import write_depth
from lommel.optics.lens import Lens
from lommel.show import estimates

if TYPE_CHECKING:
    from matplotlib.figure import Figure


_USUAL, _MOST = 61, 2001  # candidates
_STEP, _LARGEST_STEP = 1.0, 2.0  # radians of defocus from one candidate to the next
_EDGE = 0.3  # or pixels that the edge of the blur moves by, where that is more: as in pixels of 3 lambda N
_SIDE = 0.35  # of a window, by which texture may lie to one side of it
_KNOWN = 0.1  # of the range of vergence: depths of a larger standard error are unknown


@dataclass(frozen=True, eq=False)
class DefocusDepth:
    """Depth map estimated by :func:`lommel.imaging.depth_from_defocus`.

    Attributes
    ----------
    depth : ndarray, shape (height, width)
        Distance from the lens, metres; NaN where depth cannot be determined.
    deviation : ndarray, shape (height, width)
        Its standard error, metres; inf where depth cannot be determined.
    misfit : ndarray, shape (height, width)
        Residual difference of the photographs at the estimated depth, relative to the noise: 1 where registration and
        noise model hold, more at depth edges, at borders and where something moved. The deviation includes it.
    candidates : ndarray, shape (count,)
        Candidate distances, metres.
    exposures : tuple of float
        Exposure of each photograph relative to the first, as given or measured.
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
        """Fraction of the pixels whose depth is known."""
        return float(np.isfinite(self.deviation).mean())

    @cached_property
    def sharp(self) -> Values:
        """The all-in-focus image by Wiener filtering, encoded like the photographs; ValueError without depths."""
        if self.known == 0.0:
            raise ValueError("no depth is known, and so there is no sharp image: the photographs have no texture")
        return self._sharpen(np.asarray(fill_missing(self.depth, "nearest"), dtype=np.float64))

    def save(self, path: str | PathLike[str]) -> None:
        """Write the depth map to `path`: .tif, .npy or .pfm; ValueError for another suffix."""
        write_depth(Path(path), self.depth)

    def plot(self) -> Figure:
        """Draw depth, standard deviation and the all-in-focus image on a figure of matplotlib."""
        light = to_light("sharp", self.sharp, self.encoding, np.float64) if self.known else None
        return estimates.maps(self.depth, self.deviation, light)

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
    window : float, default 4.0
        Rms width of the Gaussian windows in which depth is taken to be constant, pixels, 1 to 64. Larger windows are
        more precise on flat surfaces, with less spatial resolution.
    candidates : int, optional
        Number of candidate distances, equally spaced in 1 / distance. By default 61, or more where defocus would
        change by more than a radian from one to the next. Depth is interpolated between them.
    wavelengths : sequence, optional
        As of :func:`lommel.imaging.depth_of_field`. Channels have separate textures and one depth.
    exposures : sequence of float, optional
        Exposure of each photograph relative to the first, such as exposure time over squared f-number. By default
        the ratio of their means.
    magnification : {"registered", "lens"}, default "registered"
        "registered": points are at the same pixels in all photographs. "lens": each photograph is magnified as by a
        thin lens at its sensor distance, and is resampled to the scale of the first, about the centre.
    saturation : float, optional
        Stored value at which pixels saturate; saturated pixels are ignored.
    transfer : callable, optional
        Function that computes the transfer functions, with the arguments and the result of
        :func:`lommel.estimation.pixel_transfer.pixel_transfer`, which is the default; for other PSFs than those of
        the lenses.
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
    Each candidate uses the exact, pixel-integrated PSF, and noise is that of the light around each pixel. The scene
    is assumed to have a constant depth within a window. The estimate compares the differences of two photographs, not
    the blur of one with an assumed texture, so a wrong assumption about the texture does not bias it (compare
    Subbarao and Surya 1994, doi:10.1007/BF02028349, and Favaro and Soatto 2005, doi:10.1109/TPAMI.2005.43). The
    deviation follows from the curvature of the cost at its minimum, the noise and the size of the window, and grows
    with the misfit and with the slope of the depth map; compare :func:`lommel.depth_precision`. Depth is NaN where
    its deviation exceeds a tenth of the range in 1 / distance, where another candidate costs hardly more, where the
    best candidate is the first or the last, and where less than half of a window is known.

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
    pitch = pixel_of(lenses, pixel)
    if len(lenses) < 2:
        raise ValueError(
            f"lenses must be two or more: one photograph cannot separate blur from soft texture; got {len(lenses)}"
        )
    if not isinstance(photographs, Sequence | np.ndarray) or len(photographs) != len(lenses):
        count = len(photographs) if hasattr(photographs, "__len__") else validation.shown(photographs)
        raise ValueError(f"photographs must be as many as lenses, {len(lenses)}, got {count}")
    validation.instance("noise", noise, Noise)
    width = validation.real("window", window, least=1.0, below=64.0 + 1e-9, unit="pixels")
    validation.function("progress", progress, required=False)
    vergence = _candidates(between, candidates, lenses, pitch)
    stored = {f"photographs[{k}]": validation.array(f"photographs[{k}]", one) for k, one in enumerate(photographs)}
    for name, one in stored.items():
        require_image(name, one.shape)
    if len({one.shape for one in stored.values()}) > 1:
        shapes = ", ".join(str(one.shape) for one in stored.values())
        raise ValueError(f"photographs must be of one shape, got {shapes}")
    first = stored["photographs[0]"]
    electrons, known = zip(
        *(_electrons(name, one, encoding, noise, saturation) for name, one in stored.items()), strict=True
    )
    images, valid = np.stack(electrons, axis=1), np.all(known, axis=0)
    if not valid.any():
        raise ValueError("photographs have no pixel that is known in all of them: they are NaN or saturated")
    if validation.choice("magnification", magnification, MAGNIFICATIONS) == "lens":
        images, valid = _rescaled(images, valid, lenses)
    exposed = _relative(images[..., valid], exposures)
    over = np.asarray(exposed)[:, None, None]
    seen = (images / over).astype(np.float32), _variances(images, noise, width, over).astype(np.float32), valid
    with np.errstate(divide="ignore"):
        distances = 1.0 / vergence
    step = vergence[1] - vergence[0]
    spectra = [
        ((channel, 1.0),) if isinstance(channel, float) else tuple(channel)
        for channel in Settings(wavelengths=wavelengths).channels(first.shape, lenses[0].wavelength)
    ]
    tiling = Tiling(seen, lenses, distances, spectra, pitch, width, transfer)
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

    return DefocusDepth(depth, sigma, misfit, distances, exposed, encoding, sharpen)


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


def _candidates(between: tuple[float, float], count: int | None, lenses: Sequence[Lens], pixel: float) -> Array:
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


def _variances(images: Array, noise: Noise, window: float, over: Array) -> Array:
    """Return the variance of the noise of each pixel, from the light around it, for images over an exposure each."""
    mean = _smooth(images, window)
    energy = (images - mean) ** 2
    # Stronger texture beyond a window is noise too, since no filter ends with the window.
    leaked = _LEAK**2 * np.maximum(_smooth(energy, _FAR * window) - _smooth(energy, window), 0.0)
    variances = noise.variance(np.maximum(mean, 0.0)) + leaked
    variances = np.maximum(variances, _LEAST * float(variances.mean())) / over**2
    if not np.all(variances > 0.0):
        raise ValueError("noise must be above 0: the photographs hold no light, and reading adds no noise")
    return variances


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


# Powers of texture that weights are made for, over that of the tile; a factor of ten more or less costs little. Less
# than there is, for filters then end sooner, and so do the errors where the depth changes.
_LEVELS = (0.1, 0.005)
_BETWEEN = 0.03  # power over that of the tile below which a window is served by the second level
_COARSE = 4  # candidates from one at which the texture is measured to the next
_FEW = 0.01  # share of a tile below which the first level serves whatever the texture
_PART = 64  # pixels down or across whose windows are computed by one product
_SURE = 4.0  # standard deviations of the energy of noise above which there is texture


# Photographs y_i of one texture x are y_i = h_i(u) x + n_i at each frequency, h_i the transfer function at the
# vergence u = 1 / depth, n_i noise. Whatever x is, at the right u what is orthogonal to h in the vector y is noise:
# of two photographs, (h_2 y_1 - h_1 y_2) / sqrt(h_1^2 + h_2^2). Its energy within a window, less that of noise, is
# least there on average, of every texture, and half of it is minus the logarithm of the likelihood. Frequencies that
# noise hides get the weight S |h|^2 / (1 + S |h|^2), S the power of texture over that of noise, which makes the
# least variance: a wrong S makes the answer less exact, not wrong.
class Transform:
    """Several images of one channel at the frequencies of their transfer functions, in both halves."""

    def __init__(self, images: Values) -> None:
        from scipy.fft import rfft2

        made = rfft2(images.astype(np.float32, copy=False))
        rows = np.arange(images.shape[1] // 2 + 1)
        self.shape: tuple[int, int] = images.shape[1:]
        # Of shape (images, height // 2 + 1, width // 2 + 1), at rising frequencies down, and at falling ones.
        self.top, self.bottom = made[:, rows], made[:, -rows]

    def sum(self, filters: Values) -> NDArray[np.float32]:
        """Return the sum of the images, each through an even filter of the shape of `top`."""
        from scipy.fft import irfft2

        height, width = self.shape
        half, rest = len(filters[0]), height - len(filters[0])
        out = np.empty((height, width // 2 + 1), dtype=np.complex64)
        np.multiply(filters[0], self.top[0], out=out[:half])
        np.multiply(filters[0][rest:0:-1], self.bottom[0, rest:0:-1], out=out[half:])
        for one, top, bottom in zip(filters[1:], self.top[1:], self.bottom[1:], strict=True):
            out[:half] += one * top
            out[half:] += one[rest:0:-1] * bottom[rest:0:-1]
        made: NDArray[np.float32] = irfft2(out, s=self.shape, overwrite_x=True)
        return made

    def level(self, transfers: Values) -> float:
        """Return the power S of texture over that of noise at 1 cycle a pixel, of a spectrum ``S / f^2``."""
        square, times = texture_frequencies(self.shape)
        size = self.shape[0] * self.shape[1]

        def excess(log_level: float, hh: Values, power: Values) -> float:
            return float((times * power / (1.0 + np.exp(log_level) / square * hh)).sum()) - 1.0

        found = []
        for h in np.moveaxis(transfers[:, :: 3 * _COARSE], 1, 0):
            hh = (h**2).sum(axis=0) + 1e-12
            halves = [np.abs((h * part).sum(axis=0)) ** 2 for part in (self.top, self.bottom)]
            power = 0.5 * (halves[0] + halves[1]) / (hh * size)
            power[0, 0] = 0.0
            low, high = -23.0, 46.0
            for _ in range(40):
                middle = 0.5 * (low + high)
                low, high = (middle, high) if excess(middle, hh, power) > 0.0 else (low, middle)
            found.append(low)
        return float(np.exp(np.median(found)))


def residuals(h: Values) -> Iterator[Values]:
    """Yield filters, unit vectors orthogonal to the transfer functions and to one another, by Givens rotations."""
    # Signed, for a filter whose sign jumps from frequency to frequency spreads over the image.
    length, unit = h[0], np.ones_like(h[:1])
    for k in range(1, len(h)):
        more = np.sqrt(length**2 + h[k] ** 2 + np.float32(1e-12))
        out = np.zeros_like(h)
        out[:k] = unit * (h[k] / more)
        out[k] = -length / more
        yield out
        unit = np.concatenate([unit * (length / more), [h[k] / more]])
        length = more


class Weights:
    """Gaussian windows of an rms width, as products with narrow matrices on either side.

    They end after five of that width, and with the tile.
    """

    def __init__(self, sides: tuple[int, int], margin: int, core: tuple[int, int], window: float) -> None:
        reach = math.ceil(5.0 * window)

        def matrices(side: int, inner: int) -> list[tuple[slice, NDArray[np.float32]]]:
            out = []
            for first in range(margin, margin + inner, _PART):
                last = min(first + _PART, margin + inner)
                taken = slice(max(first - reach, 0), min(last + reach, side))
                away = np.arange(taken.start, taken.stop) - np.arange(first, last)[:, None]
                made = np.exp(-0.5 * (away / window) ** 2)
                out.append((taken, np.asarray(made / made.sum(axis=1, keepdims=True), dtype=np.float32)))
            return out

        # Which pixels, with margins, a part of the tile is made of, and how much of each; rows sum to 1.
        self._down, self._across = (matrices(*side) for side in zip(sides, core, strict=True))

    def __call__(self, image: Values) -> NDArray[np.float32]:
        """Return the weighted mean round each pixel that the tile answers for."""
        rows = np.concatenate([matrix @ image[taken] for taken, matrix in self._down])
        return np.concatenate([rows[:, taken] @ matrix.T for taken, matrix in self._across], axis=1)


def whitened(images: Values, variances: Values, transfers: Values) -> tuple[Transform, Values, Values]:
    """Return images and transfer functions over the noise of each image, and the map of the noise."""
    ratio = variances.mean(axis=(1, 2))
    ratio = ratio / ratio.mean()
    local = (variances / ratio[:, None, None]).mean(axis=0)
    scale = 1.0 / np.sqrt(ratio * local.mean())
    transform = Transform((images - images.mean(axis=(1, 2), keepdims=True)) * scale[:, None, None])
    return transform, transfers * (1.0 / np.sqrt(ratio)).astype(np.float32)[:, None, None, None], local


class Costs:
    """The costs of all candidates in one channel of a tile, by the weights for each level of texture."""

    def __init__(self, images: Values, variances: Values, valid: Values, transfers: Values, weigh: Weights) -> None:
        self._images, h, local = whitened(images, variances, transfers)
        self._trust = (valid * (float(local.mean()) / local)).astype(np.float32)
        self._weigh, self.coverage = weigh, np.maximum(weigh(valid), 1e-6)
        self.power = self._images.level(h)
        square, self._times = (each.astype(np.float32) for each in texture_frequencies(self._images.shape))
        count = h.shape[1]
        self._h, self._slopes, self._spectrum = h, np.gradient(h, axis=1), self.power / square
        # Of each level and candidate: the energy of noise, and the variance of a cost by noise for one independent
        # pixel. And for texture as strong as that of the tile the second derivative of the cost by the candidate, the
        # variance of the first for one independent pixel, and the part of that by noise, which is always there.
        self.known, self.spread, self.curvature, self.by_texture, self.by_noise = np.empty((5, len(_LEVELS), count))
        self._of_texture = np.empty((3, len(_LEVELS), -(-count // _COARSE)))
        self.values: list[NDArray[np.float32]] = []  # of each level half of the energy left, less that of noise
        self._textures: list[NDArray[np.float32]] = []
        self._level()

    def _level(self) -> None:
        """Compute all candidates by the weights of the next level."""
        k, count = len(self.values), self._h.shape[1]
        self.values.append(np.empty((count, *self.coverage.shape), dtype=np.float32))
        self._textures.append(np.empty((self._of_texture.shape[2], *self.coverage.shape), dtype=np.float32))
        for c, (h, slope) in enumerate(zip(self._h.swapaxes(0, 1), self._slopes.swapaxes(0, 1), strict=True)):
            hh = (h * h).sum(axis=0) + np.float32(1e-12)
            across = np.maximum((slope * slope).sum(axis=0) - (h * slope).sum(axis=0) ** 2 / hh, 0.0)
            filters = list(residuals(h))
            full = self._spectrum * hh
            signal = np.float32(_LEVELS[k]) * full
            weight = signal / (1.0 + signal)
            root = np.sqrt(weight)
            self.known[k, c] = len(filters) * self._mean(weight)
            self.spread[k, c] = 0.5 * len(filters) * self._mean(weight**2)
            energy = sum(self._energy(one * root) for one in filters)
            self.values[k][c] = 0.5 * (energy - self.known[k, c])
            moved = weight * across
            self.curvature[k, c] = self._mean(moved * self._spectrum)
            self.by_texture[k, c] = self._mean(moved * weight * self._spectrum)
            self.by_noise[k, c] = self._mean(moved * weight / hh)
            if c % _COARSE == 0:
                filtered = signal / (1.0 + signal) ** 2  # of the least variance for texture of this level
                self._textures[k][c // _COARSE] = self._energy(h * np.sqrt(filtered / hh))
                self._of_texture[:, k, c // _COARSE] = [
                    self._mean(values) for values in (filtered, filtered * full, filtered**2)
                ]

    def _mean(self, values: Values) -> float:
        """Return the mean over all frequencies."""
        return float(np.vdot(self._times, values))

    def _energy(self, filters: Values) -> Values:
        """Return the energy of the sum of the images through filters, over that of white noise, in each window."""
        values = self._images.sum(filters)
        values *= values
        values *= self._trust
        return np.asarray(self._weigh(values) / self.coverage)

    def choose(self, at: NDArray[np.int64], independent: Values) -> NDArray[np.int64]:
        """Return the level that serves each pixel, and compute its costs; the second level not for few pixels."""
        weak = self._texture(0, at, 1.0, independent)[0] < _BETWEEN
        if weak.mean() < _FEW:
            return np.zeros(at.shape, dtype=np.int64)
        self._level()
        return weak.astype(np.int64)

    def texture(
        self, at: NDArray[np.int64], level: NDArray[np.int64], misfit: Values, independent: Values
    ) -> tuple[Values, NDArray[np.bool_]]:
        """Return the power of the texture over that of the tile, and where it exceeds noise."""
        found = [self._texture(k, at, misfit, independent) for k in range(len(self.values))]
        power, sure = (np.choose(level, each) for each in zip(*found, strict=True))
        return power, sure

    def _texture(
        self, k: int, at: NDArray[np.int64], misfit: Values | float, independent: Values
    ) -> tuple[Values, NDArray[np.bool_]]:
        """Return power and certainty by the weights of one level."""
        place = np.minimum((at + _COARSE // 2) // _COARSE, len(self._textures[k]) - 1)
        noise, signal, spread = (each[place] for each in self._of_texture[:, k])
        energy = np.take_along_axis(self._textures[k], place[None], axis=0)[0]
        mean = misfit * noise
        # The quantile of chi squared, by Wilson and Hilferty.
        part = 2.0 / 9.0 * spread / (noise**2 * independent)
        return np.maximum(energy - mean, 0.0) / signal, energy > mean * (1.0 - part + _SURE * np.sqrt(part)) ** 3

    def of_level(self, level: NDArray[np.int64]) -> Values:
        """Return the costs, shape (candidates, height, width), each pixel's by the weights of its level."""
        return self.values[0] if len(self.values) == 1 else np.where(level, self.values[1], self.values[0])


_STENCIL = 7  # candidates that the polynomial goes through whose minimum is sought
_DROP = 9.0  # depth is known where the best candidate is better than the mean by so much of a log-likelihood
_SURE_OF_BEST = 3.0  # and by so many standard deviations of the noise of a cost
_CLEAR = 100.0  # from so much on there is no doubt of a minimum
_NOISIER = 2.0  # more than this is no noise stated too low, but depth that changes, or edges


def _least(cost: Values) -> NDArray[np.int64]:
    """Return the place of the least along the first axis, as argmin does ten times as slowly."""
    at, least = np.zeros(cost.shape[1:], dtype=np.int64), cost[0].copy()
    for c, one in enumerate(cost[1:], 1):
        less = one < least
        at[less] = c
        np.minimum(least, one, out=least)
    return at


def _spread(cost: Values, at: NDArray[np.int64], independent: Values) -> Values:
    """Return the mean square distance from the least candidate and its neighbours, weighted by likelihood."""
    least = np.take_along_axis(cost, at[None], axis=0)[0]
    scale = independent.astype(np.float32)
    total, moment = np.zeros((2, *at.shape), dtype=np.float32)
    for c, one in enumerate(cost):
        chance = np.exp((least - one) * scale)
        total += chance
        moment += chance * (np.maximum(np.abs(at - c) - 1, 0) ** 2).astype(np.float32)
    return np.asarray(moment / total)


def _minimum(cost: Values, at: NDArray[np.int64]) -> tuple[Values, Values, Values]:
    """Return place, curvature and value of the minimum next to the least candidate, by a polynomial through seven."""
    start = np.clip(at - _STENCIL // 2, 0, len(cost) - _STENCIL)
    index = start + np.arange(_STENCIL).reshape(-1, *([1] * at.ndim))
    values = np.take_along_axis(cost, index, axis=0).astype(np.float64)
    nodes = np.arange(_STENCIL) - _STENCIL // 2
    inverse = np.linalg.inv(np.vander(nodes, increasing=True).astype(np.float64))
    terms = np.tensordot(inverse, values, axes=1)
    middle = (at - start - _STENCIL // 2).astype(np.float64)
    x = middle.copy()

    def derivative(order: int) -> Values:
        total = np.zeros_like(x)
        for power in range(_STENCIL - 1, order - 1, -1):
            total = total * x + terms[power] * np.prod(np.arange(power, power - order, -1))
        return total

    for _ in range(4):
        bend = derivative(2)
        with np.errstate(divide="ignore", invalid="ignore"):
            step = np.where(bend > 0.0, -derivative(1) / bend, 0.0)
        x = np.clip(x + np.clip(step, -0.5, 0.5), middle - 1.0, middle + 1.0)
    return start + _STENCIL // 2 + x, derivative(2), derivative(0)


_CORE = 256  # most that a tile answers for, pixels a side
_LEAST_MARGIN = 24

Window = tuple[slice, slice]
Places = tuple[NDArray[np.int64], ...]
Transfer = Callable[[Lens, Array, Sequence[tuple[float, float]], float, tuple[int, int], int], NDArray[np.float32]]


class Tiling:
    """Photographs cut into tiles, with the transfer functions of all lenses at all candidates in all channels."""

    def __init__(
        self,
        seen: tuple[Values, Values, NDArray[np.bool_]],
        lenses: Sequence[Lens],
        distances: Array,
        spectra: Sequence[Sequence[tuple[float, float]]],
        pixel: float,
        window: float,
        transfer: Transfer,
    ) -> None:
        from scipy.fft import next_fast_len
        from scipy.ndimage import distance_transform_edt

        # Electrons over relative exposures and the variances of their noise, each (channels, photographs, height,
        # width), and the pixels known in all photographs and channels.
        images, variances, valid = seen
        blur = max(float(lens.pupil(distances).geometric_radius().max()) for lens in lenses) / pixel
        half, margin = half_window(lenses, distances, pixel), max(_LEAST_MARGIN, math.ceil(2.0 * blur + 3.0 * window))
        # The pixels that a tile answers for, and those of its transforms, which have margins.
        height, width = (math.ceil(side / math.ceil(side / _CORE)) for side in valid.shape)
        rows, columns = (next_fast_len(max(side + 2 * margin, 2 * half + 1), real=True) for side in (height, width))
        self._window, self._margin, self._core, self._sides = window, margin, (height, width), (rows, columns)
        self._weigh = Weights(self._sides, margin, self._core, window)

        @cache
        def transfers(spectrum: tuple[tuple[float, float], ...]) -> NDArray[np.float32]:
            return np.stack([transfer(lens, distances, spectrum, pixel, self._sides, half) for lens in lenses])

        self._transfers = [transfers(tuple(spectrum)) for spectrum in spectra]
        self._shape = valid.shape
        around = [
            (margin, (whole - 1) // core * core + side - margin - whole)
            for whole, core, side in zip(self._shape, self._core, self._sides, strict=True)
        ]
        self._images, self._variances = (
            np.pad(part, [(0, 0), (0, 0), *around], mode="symmetric") for part in (images, variances)
        )
        # 1 where pixels are of the image rather than mirrored, and where they are known as far as light is spread.
        known = valid if valid.all() else distance_transform_edt(valid) > blur + 1.0
        self._own, self._trusted = (np.pad(part.astype(np.float32), around) for part in (np.ones(self._shape), known))

    def search(self, progress: Callable[[int, int], object] | None = None) -> list[Array]:
        """Return the maps of :meth:`_found` of all tiles."""
        out = [np.empty(self._shape, dtype=np.float64) for _ in range(4)]
        tiles = list(self._tiles())
        for done, (inside, at) in enumerate(tiles, 1):
            for whole, part in zip(out, self._found(at), strict=True):
                height, width = whole[inside].shape
                whole[inside] = part[:height, :width]
            if progress is not None:
                progress(done, len(tiles))
        return out

    def _found(self, at: Places) -> tuple[Values, Values, Values, Values]:
        """Return position, variance, misfit and power of texture of each pixel that a tile answers for."""
        # The position of the least cost among the candidates is NaN at either end, where there is none; its variance,
        # in candidates squared, is infinite where nothing is known; the misfit is the energy left over that of noise,
        # 1 where the model holds; the power of the texture is that at 1 cycle a pixel over that of noise.
        channels = [
            Costs(images, variances, self._trusted[at], transfer, self._weigh)
            for images, variances, transfer in self._channels(at)
        ]
        share = channels[0].coverage
        independent = 4.0 * np.pi * self._window**2 * share
        levels = [one.choose(_least(one.values[0]), independent) for one in channels]
        parts = [one.of_level(level) for one, level in zip(channels, levels, strict=True)]
        cost = parts[0] if len(parts) == 1 else np.sum(parts, axis=0)
        best = _least(cost)
        position, curvature, least = _minimum(cost, best)
        noise = sum(one.known[level, best] for one, level in zip(channels, levels, strict=True))
        misfit = np.maximum(1.0 + 2.0 * least / np.maximum(noise, 1e-30), 0.0)
        worse = np.maximum(misfit, 1.0)
        # How much better the best candidate is than the mean of all, as the logarithm of a likelihood.
        drop = (cost.mean(axis=0) - least) * independent / worse
        clear = drop > _CLEAR
        sure = clear.copy()
        slope, expected, power = np.zeros((3, *best.shape))
        steepest = sum(one.curvature[level, best] for one, level in zip(channels, levels, strict=True))
        for one, level in zip(channels, levels, strict=True):
            texture, more = one.texture(best, level, np.minimum(worse, _NOISIER), independent)
            # Where the minimum is clear its curvature is the better estimate of the texture.
            texture = np.where(clear, np.maximum(curvature / steepest, 0.0), texture)
            sure |= more
            expected += texture * one.curvature[level, best]
            slope += texture * one.by_texture[level, best] + one.by_noise[level, best]
            power += texture * one.power / len(channels)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            variance = slope / (np.minimum(curvature, 2.0 * expected) ** 2 * independent) * worse**2
        # One narrow minimum among others that are nearly as low is chance.
        variance = np.maximum(variance, _spread(cost, best, independent / worse))
        chance = sum(one.spread[level, best] for one, level in zip(channels, levels, strict=True))
        enough = np.maximum(_DROP, _SURE_OF_BEST * np.sqrt(chance * independent))
        # Less than half of what a window has of the image is not to be believed.
        whole = share >= 0.5 * self._weigh(self._own[at])
        known = sure & whole & (curvature > 0.0) & np.isfinite(variance) & (drop >= enough)
        variance[~known] = np.inf
        outside = (best == 0) | (best == len(cost) - 1)
        variance[outside], position[outside] = np.inf, np.nan
        return position, variance, misfit, power

    def sharp(self, position: Array, level: float) -> Array:
        """Return the electrons of the scene in focus, (channels, height, width), at positions of candidates."""
        out = np.empty((len(self._transfers), *position.shape))
        spectrum = level / texture_frequencies(self._sides)[0].astype(np.float32)
        count = self._transfers[0].shape[1]
        for inside, at in self._tiles():
            place = np.clip(position[inside], 0.0, count - 1.0)
            rows, columns = (slice(self._margin, self._margin + side) for side in place.shape)
            for channel, (images, variances, transfers) in enumerate(self._channels(at)):
                transform, h, local = whitened(images, variances, transfers)
                made = np.zeros(place.shape)
                for c in np.unique(np.concatenate([np.floor(place), np.ceil(place)])).astype(int):
                    # Wiener's filter of one candidate.
                    filters = spectrum * h[:, c] / (1.0 + spectrum * (h[:, c] * h[:, c]).sum(axis=0))
                    made += np.maximum(1.0 - np.abs(place - c), 0.0) * transform.sum(filters)[rows, columns]
                weight = 1.0 / variances.mean(axis=(1, 2))
                mean = float((images.mean(axis=(1, 2)) * weight).sum() / weight.sum())
                out[channel][inside] = made * math.sqrt(float(local.mean())) + mean
        return out

    def _tiles(self) -> Iterator[tuple[Window, Places]]:
        """Yield where each tile answers, and the pixels of the mirrored photographs that it is made of."""
        (height, width), (rows, columns) = self._core, self._sides
        for top in range(0, self._shape[0], height):
            for left in range(0, self._shape[1], width):
                inside = slice(top, min(top + height, self._shape[0])), slice(left, min(left + width, self._shape[1]))
                yield inside, np.ogrid[top : top + rows, left : left + columns]

    def _channels(self, at: Places) -> Iterator[tuple[Values, Values, Values]]:
        """Yield the photographs of each channel in a tile, the variances of their noise, and transfer functions."""
        for images, variances, transfer in zip(self._images, self._variances, self._transfers, strict=True):
            yield images[:, *at], variances[:, *at], transfer
