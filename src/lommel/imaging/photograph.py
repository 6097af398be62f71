"""Photographs of sharp images: depth-of-field rendering, as a whole or by tiles, and blur by a field map."""

from __future__ import annotations

import copy
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Annotated, Any, Self

import numpy as np
import scipy
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.cached import Kept
from lommel.base.encoding import Encoding, ToneCurves, clipped_fraction, from_light, scene_light, to_light
from lommel.base.options import HIDDEN, In, listed
from lommel.deconvolve.linear import folded, tiles_of
from lommel.field.maps import FieldMap, require_one_aperture
from lommel.imaging.blur import DepthBlur, require_lens, require_metres
from lommel.imaging.field_blur import FieldBlur, FieldPhotographOptions, PointLight
from lommel.imaging.occlusion import Occlusion, points_of_light, reach_behind
from lommel.imaging.settings import FILL, Spectrum, TableOptions, channel_spectra
from lommel.io.photos import Photograph
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront

Pixels = NDArray[np.generic]  # stored values, unsigned integers or floats

TILE = 1024  # default side of the tiles of memory maps, pixels

_INTERVAL_BITS = 14  # number of trailing bits of float32 light that do not select an interval between thresholds
_IN_CACHE = 1 << 14  # values encoded at a time: what is between stays in the cache
_STRIP = 2**20  # number of depth values read together, which limits the memory for the depth range


@dataclass(frozen=True, eq=False)
class Rendered:
    """Photograph computed from a sharp image; ``np.asarray`` returns its values.

    Attributes
    ----------
    photograph : Photograph
        Stored values, in the type and encoding of the image.
    lost : float
        Largest fraction of a point's light that falls outside the PSF's window, and is spread over the window
        instead.
    error : float
        Largest error of interpolated PSFs relative to their peak, checked half-way between computed PSFs.
    window : int
        Side of the largest PSF window, pixels.
    clipped : float
        Fraction of the values that were clipped to the range of their integer type; 0 for floats.
    """

    photograph: Photograph
    lost: float
    error: float
    window: int
    clipped: float = 0.0

    @property
    def values(self) -> Values:
        """Stored values of the photograph."""
        return self.photograph.values

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> Pixels:
        """Return the values."""
        return np.array(self.values, dtype=dtype, copy=copy)

    @classmethod
    def by(cls, blur: DepthBlur | FieldBlur, values: Pixels, encoding: Encoding, clipped: float) -> Self:
        """Return a photograph from stored values, the blur that made them, and the fraction clipped."""
        side = 2 * max(bank.half for bank in blur.banks) + 1
        return cls(Photograph(values, encoding), blur.lost, blur.error, side, clipped)


def encode_light(light: Values, encoding: Encoding, dtype: DTypeLike) -> tuple[Pixels, float]:
    """Return finite light (1 is white) as stored values, and the fraction of values clipped to an integer range."""
    clipped = clipped_fraction(light, dtype)
    if light.dtype != np.float32 or dtype != np.uint8 or isinstance(encoding, ToneCurves):
        return from_light(light, encoding, dtype), clipped
    # Comparison with the thresholds between levels is faster than encoding each value; the results are equal.
    thresholds, levels = _thresholds(encoding)
    values = np.empty(light.shape, dtype=np.uint8)
    flat, stored = np.ascontiguousarray(light).reshape(-1), values.reshape(-1)
    for first in range(0, light.size, _IN_CACHE):
        part = np.s_[first : first + _IN_CACHE]
        # Of negative numbers, the bits are those of a negative integer.
        bits = np.maximum(np.minimum(flat[part], np.float32(1.0)).view(np.int32), 0)
        below = levels.take(bits >> _INTERVAL_BITS)
        np.add(below, flat[part] >= thresholds.take(below), out=stored[part])
    return values, clipped


@lru_cache
def _thresholds(encoding: str | float) -> tuple[NDArray[np.float32], NDArray[np.uint8]]:
    """Return the values of light at which the rounded 8-bit value increases by one, and infinity; and levels.

    These are those of floats from 0 to 1 whose last `_INTERVAL_BITS` bits are 0. At most one threshold is between two
    such floats.
    """
    rising = to_light("thresholds", (np.arange(255) + 0.5) / 255.0, encoding, np.float64).astype(np.float32)
    starts = np.arange(0, np.float32(1.0).view(np.int32) + 1, 1 << _INTERVAL_BITS, dtype=np.int32).view(np.float32)
    return np.append(rising, np.float32(np.inf)), np.searchsorted(rising, starts, side="right").astype(np.uint8)


def output_array(out: Pixels | None, shape: tuple[int, ...], dtype: np.dtype[np.generic], *inputs: Pixels) -> Pixels:
    """Return `out`, or a new array if it is None; TypeError or ValueError if it does not fit or overlaps `inputs`."""
    if out is None:
        return np.empty(shape, dtype=dtype)
    if not isinstance(out, np.ndarray):
        raise TypeError(f"out must be an array, got {validation.shown(out)}")
    if out.shape != shape:
        raise ValueError(f"out must have the shape of the image, {shape}, got {out.shape}")
    if out.dtype != dtype:
        raise TypeError(f"out must have the type of the image, {dtype}, got {out.dtype}")
    if not out.flags.writeable or any(np.may_share_memory(out, source) for source in inputs):
        raise ValueError("out must be writeable, and must not share memory with image or depth")
    return out


def require_image(name: str, shape: tuple[int, ...]) -> None:
    """Raise ValueError unless `shape` is the shape of an image; `name` is the argument in the message."""
    if len(shape) not in (2, 3) or 0 in shape:
        raise ValueError(f"{name} must have the shape (height, width) or (height, width, channels), got {shape}")


def require_scene(name: str, shape: tuple[int, ...], depth: tuple[int, ...]) -> None:
    """Raise ValueError unless `shape` is the shape of an image, and `depth` the shape of its depth map."""
    require_image(name, shape)
    if depth != shape[:2]:
        raise ValueError(f"depth must have the shape of the {name}, {shape[:2]}, got {depth}")


@dataclass(frozen=True, kw_only=True)
class BlurOptions(TableOptions):
    """Options of depth-of-field rendering.

    Parameters
    ----------
    supersample : int, default 1
        Number of points of `image` and `depth` along each side of a pixel of the result, 1 to 16: the points are
        ``pixel / supersample`` apart, and each pixel of the result is the mean light of its points. The `window` of
        the result is in points, not pixels. Not available with `tile`; memory maps are rendered as a whole.
    tile : int, optional
        Side of the tiles, pixels, 16 to 16384; by default 1024 for memory maps. A tile requires several hundred bytes
        per pixel and channel.
    """

    supersample: Annotated[int, In(least=1, most=16)] = 1
    tile: Annotated[int | None, In(least=16, most=validation.MAX_SIDE), HIDDEN] = None


class Scene:
    """A sharp image with its depth map, whose photographs are computed through any lens."""

    def __init__(
        self, image: ArrayLike, depth: ArrayLike, lens: Lens, pixel: float, encoding: Encoding, o: BlurOptions
    ) -> None:
        require_lens(lens, "image, depth, lens, pixel")
        scene = validation.array("image", image, "counts")
        # A copy: the caller may change the map between frames.
        self._depth = np.array(validation.array("depth", depth, "metres"))
        require_scene("image", scene.shape, self._depth.shape)
        height, width = (side // o.supersample for side in scene.shape[:2])
        if (height * o.supersample, width * o.supersample) != scene.shape[:2]:
            raise ValueError(
                f"supersample must divide the height and the width of the image, {scene.shape[:2]}, "
                f"got {o.supersample}"
            )
        self.shape, self.dtype, self.encoding = (height, width, *scene.shape[2:]), scene.dtype, encoding
        self._light = scene_light("image", scene, encoding, np.float32)
        self._pixel = validation.pixel(pixel, metric=True) / o.supersample
        self._channels, self._o = channel_spectra(self.shape, lens.wavelength), o

    def blur(self, lens: Lens) -> Occlusion:
        """Return the blur by a lens; ValueError if it is too large."""
        o = self._o
        return Occlusion(
            DepthBlur(self._depth, lens, self._pixel, channels=self._channels, energy=o.energy, tol=o.tol)
        )

    def photograph(self, blur: Occlusion, out: Pixels | None = None, *, occlusion: bool = True) -> Rendered:
        """Return the photograph with the blur of this scene; `out` is written last, and unchanged after errors."""
        points = self._o.supersample
        light = blur.forward(self._light, copies=False) if occlusion else blur.blur.forward(self._light)
        if points > 1:
            height, width, *channels = self.shape
            light = light.reshape(height, points, width, points, *channels).mean(axis=(1, 3))
        values, clipped = encode_light(light, self.encoding, self.dtype)
        if out is not None:
            out[...] = values
        return Rendered.by(blur.blur, values if out is None else out, self.encoding, clipped)


_KEPT = 4  # number of lens settings whose PSF windows and occlusion a FocusPlan keeps


class FocusPlan:
    """Depth-of-field rendering of one scene, for live use: focus and f-number change from frame to frame.

    The image is decoded once. For each frame, the PSF windows and the occlusion for the lens setting are computed,
    unless they are kept from one of the last four settings; then the image is blurred and encoded. The stored values
    equal those of :func:`lommel.imaging.depth_of_field` with the same arguments, bit for bit.

    Parameters
    ----------
    image, depth, lens, pixel, encoding
        See :func:`lommel.imaging.depth_of_field`. The image and the depth are copied.
    occlusion : bool, default True
        Near objects occlude far objects. Without occlusion, frames take less time, but light of the background
        spreads over the edges of near objects.

    Raises
    ------
    TypeError, ValueError
        See :func:`lommel.imaging.depth_of_field`.

    Examples
    --------
    >>> lens = Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    >>> plan = FocusPlan(np.ones((40, 60), np.float32), np.full((40, 60), 2.5), lens, 8e-6, encoding="linear")
    >>> plan(focus_distance=2.5).window < plan(focus_distance=2.0).window
    True
    """

    def __init__(
        self,
        image: ArrayLike,
        depth: ArrayLike,
        lens: Lens,
        pixel: float,
        *,
        encoding: Encoding,
        occlusion: bool = True,
    ) -> None:
        self._occlusion, self.lens = validation.truth("occlusion", occlusion), lens
        self._scene = Scene(image, depth, lens, pixel, encoding, BlurOptions())
        self._blur = Kept(self._scene.blur, _KEPT)
        self._blur(lens)  # checks the depth, and whether windows are too large

    def __call__(
        self, *, focus_distance: float | None = None, f_number: float | None = None, out: Pixels | None = None
    ) -> Rendered:
        """Return the photograph at a focus distance and f-number.

        Parameters
        ----------
        focus_distance : float, optional
            Object distance in focus, metres, more than the focal length, may be infinite; by default the focus
            distance of the lens. Refocusing moves the sensor, which changes the working f-number.
        f_number : float, optional
            Focal length divided by the diameter of the aperture; by default the f-number of the lens.
        out : ndarray, optional
            Array that receives the values, with the type of the image and the shape of the photograph.

        Returns
        -------
        Rendered

        Raises
        ------
        TypeError, ValueError
            If an argument is out of range, or a window is too large; `out` is then unchanged.
        """
        if out is not None:
            output_array(out, self._scene.shape, self._scene.dtype)
        lens = self.lens if f_number is None else self.lens.stopped(f_number)
        lens = lens if focus_distance is None else lens.focused(focus_distance)
        return self._scene.photograph(self._blur(lens), out, occlusion=self._occlusion)


@listed(BlurOptions)
def depth_of_field(
    image: ArrayLike,
    depth: ArrayLike,
    lens: Lens,
    pixel: float,
    *,
    encoding: Encoding,
    out: Pixels | None = None,
    progress: Callable[[int, int], object] | None = None,
    options: BlurOptions | None = None,
    **given: Any,
) -> Rendered:
    """Render the depth of field of a lens: blur each point of a sharp image by the PSF at its distance.

    The PSFs are pixel-integrated, with diffraction, aberrations and colour (:class:`lommel.imaging.DepthBlur`), and
    near points occlude far points (:class:`lommel.imaging.Occlusion`). A grey image has the wavelength of the lens,
    the three channels of a colour image 600, 540 and 460 nm. Arrays are rendered as a whole. Memory maps, and arrays
    with `tile`, are rendered in overlapping tiles, with little memory. Tiles use the PSF windows of the whole image;
    the result agrees with that of the whole image except for rounding. Tiles overlap by half a window and twice the
    range of blur radii: the largest distance of an occluded point from an edge.

    Parameters
    ----------
    image : array_like or memory map, shape (height, width) or (height, width, channels)
        Unsigned integers (white is their largest value) or floats (white is 1).
    depth : array_like or memory map, shape (height, width)
        Distance of each point from the lens along the axis, metres; may be infinite. Tiles read the map twice, first
        for its range.
    lens : Lens
        Lens with radially symmetric aberrations.
    pixel : float
        Pixel pitch of the result, metres.
    encoding : {"srgb", "linear"} or float
        Encoding of `image` and of the result; a number states ``light = value ** number``.
    out : ndarray, optional
        Array or memory map that receives the values, with the shape and type of the result.
    progress : callable, optional
        Called as ``progress(done, total)``, with the numbers of complete and of all tiles, or of blurred points where
        there are no tiles.
    options : BlurOptions, optional
        Options as an object, which keywords change.
    {options}

    Returns
    -------
    Rendered

    Raises
    ------
    TypeError, ValueError
        If an argument is unknown or out of range, if shapes do not match, if a depth is unknown (NaN), if the lens is
        not radially symmetric, if a window is wider than the shorter side of the image, if the image has neither one
        nor three channels, or if `out` has another shape or type. After an error, `out` contains the tiles that were
        written before.
    """
    o = BlurOptions.of("depth_of_field", options, given)
    require_lens(lens, "image, depth, lens, pixel")
    validation.function("progress", progress, required=False)
    if o.supersample != 1 and o.tile is not None:
        raise ValueError(f"supersample must be 1 with tile, got {o.supersample}")
    mapped = any(isinstance(part, np.memmap) for part in (image, depth, out))
    side = o.tile or (TILE if mapped and o.supersample == 1 else None)
    values, distances = validation.array("image", image, "counts"), validation.array("depth", depth, "metres")
    if side is not None:
        return _render_tiles(values, distances, lens, pixel, encoding, side, o, out, progress)
    scene = Scene(values, distances, lens, pixel, encoding, o)
    if out is not None:
        output_array(out, scene.shape, scene.dtype)
    blur = scene.blur(lens)
    if progress is not None:
        blur.blur.watch = _counted(progress, distances.size * blur.channels)
    return scene.photograph(blur, out)


def _counted(progress: Callable[[int, int], object], total: int) -> Callable[[int], None]:
    """Return a function that adds numbers, and calls `progress` with their sum and the `total`."""
    done = 0

    def count(points: int) -> None:
        nonlocal done
        done += points
        progress(min(done, total), total)

    return count


def _render_tiles(
    values: Pixels,
    distances: Pixels,
    lens: Lens,
    pixel: float,
    encoding: Encoding,
    side: int,
    o: BlurOptions,
    out: Pixels | None,
    progress: Callable[[int, int], object] | None,
) -> Rendered:
    """Return the photograph for arrays or memory maps, rendered tile by tile."""
    require_scene("image", values.shape, distances.shape)
    out = output_array(out, values.shape, values.dtype, values, distances)
    # The two ends of the depth range determine the windows of all tiles.
    whole = DepthBlur(
        np.array([_depth_range(distances)]), lens, pixel, channels=channel_spectra(values.shape, lens.wavelength),
        energy=o.energy, tol=o.tol, largest=min(2048, max(1, min(values.shape[:2]) // 2)),
    )  # fmt: skip
    reach = float(whole.defocus.min()), float(whole.defocus.max())
    # Points in the margin of a tile contribute light to the tile.
    margin = max(bank.half for bank in whole.banks) + reach_behind(whole, reach)
    tiles = list(tiles_of(values.shape, side, margin))
    clipped = 0.0
    for count, (region, overlapping, inner) in enumerate(tiles, 1):
        blur = copy.copy(whole)
        blur.place(np.asarray(distances[overlapping]))
        seen = Occlusion(blur)
        seen.reach = reach
        sharp = scene_light("image", np.asarray(values[overlapping]), encoding, whole.dtype)
        light = seen.forward(sharp, copies=False)[inner]
        out[region], fraction = encode_light(light, encoding, values.dtype)
        clipped += fraction * light.size / out.size
        if progress is not None:
            progress(count, len(tiles))
    return Rendered.by(whole, out, encoding, clipped)


def _depth_range(depth: Pixels) -> tuple[float, float]:
    """Return the nearest and the farthest distance, metres; read the depth in strips of rows."""
    require_metres(depth.dtype)
    rows = max(1, _STRIP // depth.shape[1])
    low, high = np.inf, -np.inf
    for first in range(0, depth.shape[0], rows):
        part = np.asarray(depth[first : first + rows])
        low, high = np.minimum(low, part.min()), np.maximum(high, part.max())
    if np.isnan(low):
        raise ValueError(f"depth is NaN at some points; {FILL}")
    return float(low), float(high)


POSITION_TOL = 1e-3
"""Tolerance of the undistorted positions of pixels, in pixels, checked half-way between interpolation nodes."""

_MAX_UNINTERPOLATED = 4096  # largest number of pixels whose positions are all computed without interpolation
_MAX_NODES = 257  # largest number of interpolation nodes along a side


@listed(FieldPhotographOptions)
def field_photograph(
    image: ArrayLike,
    field_map: FieldMap,
    pixel: float,
    *,
    encoding: Encoding,
    sensor: tuple[float, float] | None = None,
    options: FieldPhotographOptions | None = None,
    **given: Any,
) -> Rendered:
    """Render a sharp image as a lens records it: blur over the field, distortion, lateral colour, shading.

    `image` is the image of an ideal lens. The wavefront tilts of the map displace light
    (:meth:`lommel.FieldMap.displacement`): each channel is resampled accordingly by quintic splines, blurred by
    :class:`lommel.imaging.FieldBlur` with the PSFs of the map without tilts, and multiplied by the shading of the
    map. Points of light are not resampled: their PSFs are drawn where the light arrives, between pixels. These steps
    are equivalent to the blur by the PSFs of the map with tilts, for displacements of any size.

    Parameters
    ----------
    image : array_like, shape (height, width) or (height, width, channels)
        Unsigned integers (white is their largest value) or floats (white is 1).
    field_map : FieldMap
        Map over undistorted field positions; the lens of its aperture determines lateral and axial colour.
    pixel : float
        Pixel pitch, in the unit of the map (metres if it has a wavelength).
    encoding : {"srgb", "linear"} or float
        Encoding of `image` and of the result; a number states ``light = value ** number``.
    sensor : (float, float), optional
        See :class:`lommel.imaging.FieldBlur`. A `sensor` larger than the image enlarges the PSFs, not the distortion.
    options : FieldPhotographOptions, optional
        Options as an object, which keywords change.
    {options}

    Returns
    -------
    Rendered
        Apart from resampling, the error of the light of a pixel is at most ``error + 2 * lost`` times the brightest
        point; `error` is the largest sum of absolute differences between an interpolated and an exact PSF window.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range; if a pixel receives light from outside the map; if the map has vignetting.

    Notes
    -----
    The photograph of a uniform scene is uniform except for the shading, the measured relative illumination. If
    distortion stretches the image, the total light of each point therefore increases. In contrast,
    :class:`lommel.imaging.FieldBlur` with the tilts in the windows conserves the total light of each point.

    Positions are accurate to 0.001 pixel. Resampling by splines changes a Gaussian by 0.3 % of its peak for a
    standard deviation of 1 pixel, by 0.04 % for 1.5 pixels, and by 0.005 % for 2 pixels. Points of light are isolated
    bright pixels, at most three among 5 x 5, at least 4 times as far above the others as these differ. They stand out
    from the others by at least 3 % and 0.003 of white (of the brightest pixel if it is below white), and are the
    brightest of a channel if their PSFs have more than 2^23 values (2^18 if the aperture is neither circular nor
    annular). Light that arrives outside the image is lost. At other sharp edges splines overshoot; where the blur
    leaves negative light, it is taken from the positive light of the 25 pixels around, so that the sum is conserved.

    Examples
    --------
    >>> field = lm.FieldMap.from_seidel(2.5e-3, W311=-60.0, W131=0.5, wavelength=550e-9, f_number=4.0)
    >>> image = np.zeros((60, 80, 3), np.float32)
    >>> image[30, 60] = 1.0
    >>> photograph = lm.imaging.field_photograph(image, field, 4e-6, encoding="linear", sensor=(3e-3, 4e-3))
    >>> photograph.values.shape
    (60, 80, 3)
    """
    validation.instance("field_map", field_map, FieldMap)
    scene = validation.array("image", image, "counts")
    require_image("image", scene.shape)
    require_one_aperture(field_map)
    o = FieldPhotographOptions.of("field_photograph", options, given)
    wavelength = field_map.pupil_without_wavefront.wavelength
    spectra: Sequence[Spectrum] | None = None
    if wavelength is not None:
        spectra = channel_spectra(scene.shape, wavelength)
    elif scene.ndim == 3:
        raise ValueError(
            "image must be grey for a map without a wavelength; make the map with wavelength= and f_number="
        )
    light = scene_light("image", scene, encoding, np.float32)
    shape = (scene.shape[0], scene.shape[1])
    blur = UntiltedBlur(field_map, shape, pixel, sensor=sensor, channels=spectra, energy=o.energy, tol=o.tol)
    planes = light.reshape(*shape, -1)
    distorted, drawn, drawable = np.empty_like(planes), {}, _MAX_DRAWN[field_map.pupil_without_wavefront.circular]
    for k, bank in enumerate(blur.banks):
        plane, sources = planes[..., k], blur.sources(k)
        # Without distortion the image is not resampled.
        if np.abs(sources - np.indices(shape)).max() > POSITION_TOL:
            points = points_of_light(plane, drawable // (2 * (bank.half + _MARGIN) + 1) ** 2)
            if points.any() and min(shape) > 1:
                plane, drawn[k] = plane - points, blur.draw(points, k)
            plane = scipy.ndimage.map_coordinates(plane, sources, order=5, mode="reflect", output=plane.dtype)
        distorted[..., k] = plane
    blurred = blur.forward(distorted.reshape(light.shape))
    for k, image_of_points in drawn.items():
        blurred.reshape(planes.shape)[..., k] += image_of_points
    # Splines overshoot at edges, where the blur is narrow; light is not negative.
    if blurred.min() < 0.0 <= light.min():
        blurred = positive(blurred)
    if field_map.shading is not None:
        shading = np.asarray(field_map.illumination(blur.x, blur.y[:, None]), dtype=blurred.dtype)
        # Shading multiplies the blurred light, at its position on the sensor.
        blurred = blurred * shading.reshape(*shape, *(1,) * (blurred.ndim - 2))
    values, clipped = encode_light(blurred, encoding, scene.dtype)
    return Rendered.by(blur, values, encoding, clipped)


class UntiltedLight(PointLight):
    """PSF of the light that arrives at a sensor position, centred on this position or shifted from it."""

    def pupil(self, y: Array, x: Array, *shift: Array) -> Pupil:
        """Return the pupils of the light that arrives at (y, x), with the tilts of a `shift` along y and x alone.

        The light of a blur has neither defocus nor shift: its third coordinate is 0.
        """
        pupil = self.field_map.untilted(x, y, self.spectrum)
        tilts = {(1, m): math.pi / pupil.scale * part for m, part in zip((-1, 1), shift, strict=False)}
        return pupil.carrying(pupil.wavefront + Wavefront.from_edge(tilts), None)


class UntiltedBlur(FieldBlur):
    """Blur of an already distorted image by the PSFs of a field map without their tilts."""

    @property
    def _point_light(self) -> type[PointLight]:
        return UntiltedLight

    def _require_within_map(self, x: Array, y: Array) -> None:
        """Raise ValueError where light comes from outside the map."""
        for spectrum in self.spectra:
            self.field_map.undistorted(x, y, spectrum)

    def sources(self, channel: int) -> Array:
        """Return the undistorted row and column, in pixels, of the light at each pixel, shape (2, height, width)."""
        spectrum, tol = self.spectra[channel], POSITION_TOL * min(self._pitch)
        y, x = undistorted_positions(self.field_map, self.y, self.x, spectrum, tol)
        return np.stack([(y - self.y[0]) / self._pitch[0], (x - self.x[0]) / self._pitch[1]])

    def draw(self, points: Values, channel: int) -> Values:
        """Return the image of points, each with the PSF of the map at the exact position where its light arrives."""
        spectrum, half = self.spectra[channel], self.banks[channel].half + _MARGIN
        start, pitch = np.array([[self.y[0]], [self.x[0]]]), np.array(self._pitch)[:, None]
        drawn = np.zeros([count + 2 * half for count in points.shape], dtype=points.dtype)
        origin, last = np.argwhere(points).T.astype(np.float64), np.array(points.shape)[:, None] - 1.0

        def source(place: Array) -> Array:
            """Return the undistorted row and column of the light at places (row, column) between pixels."""
            y, x = start + pitch * place
            return np.asarray((np.stack(self.field_map.undistorted(x, y, spectrum)[::-1]) - start) / pitch)

        landing = origin
        for _ in range(_LANDING_STEPS):
            place = np.clip(landing, 0.0, last)
            landing = place + origin - source(place)
        pixel = np.clip(np.rint(landing), 0.0, last)
        (y, x), shift = start + pitch * place, self.pixel * (landing - pixel)
        psfs = UntiltedLight(self.field_map, None, spectrum, self.pixel, 1e-6)
        windows = psfs.windows(np.stack([y, x, *shift], axis=1), half)
        # Brightness is that of surfaces: the light of a point grows with the area onto which its pixel is stretched.
        ends = [np.clip([place + step, place - step], 0.0, last) for step in 0.5 * np.eye(2)[..., None]]
        (a, b), (c, d) = ((source(high) - source(low)) / (high - low).sum(axis=0) for high, low in ends)
        windows *= (points[points != 0.0] / (a * d - b * c) / windows.sum(axis=(1, 2)))[:, None, None]
        arrives = (np.abs(landing - 0.5 * last) <= 0.5 * last + 0.5).all(axis=0)
        for row, column, window in zip(*pixel[:, arrives].astype(int), windows[arrives], strict=True):
            drawn[row : row + 2 * half + 1, column : column + 2 * half + 1] += window
        return folded(drawn, (half, half), points.shape)


_MARGIN = 3  # pixels by which windows of points, at any shift, are wider on each side than those of the blur
_LANDING_STEPS = 12  # steps of a fixed-point iteration; each reduces the error by the strain of the distortion
# Largest number of values of the PSFs that are drawn in a channel; PSFs of apertures that are neither circular nor
# annular (False) take 30 to 200 times as long.
_MAX_DRAWN = {True: 2**23, False: 2**18}


def positive(light: Values) -> Values:
    """Return light without negative values; the light of the 5 x 5 pixels around each of them is less by as much."""
    padded, negative = np.pad(np.maximum(light, 0.0), [(2, 2), (2, 2), (0, 0)][: light.ndim]), np.nonzero(light < 0.0)
    steps = np.ravel_multi_index(list(np.indices((5, 5, 1)).reshape(3, -1)[: light.ndim]), padded.shape)
    around = np.ravel_multi_index(negative, padded.shape) + steps[:, None]
    values, kept = padded.reshape(-1), np.ones_like(padded).reshape(-1)
    sums = values[around].sum(axis=0)
    share = light[negative] / np.where(sums > 0.0, sums, np.inf)
    for places in around:
        kept[places] += share
    values *= np.maximum(kept, 0.0)
    return padded[2:-2, 2:-2]


def undistorted_positions(
    field_map: FieldMap, y: Array, x: Array, spectrum: Spectrum | None, tol: float
) -> tuple[Array, Array]:
    """Return the undistorted coordinates (y, x) of light that arrives at rows y and columns x, accurate to `tol`."""
    if len(y) * len(x) <= _MAX_UNINTERPOLATED or min(len(y), len(x)) < 16:
        source_x, source_y = field_map.undistorted(x, y[:, None], spectrum)
        return source_y, source_x
    count = 9
    while count <= _MAX_NODES:
        # Coordinates of interpolation nodes are 0 to 1 along both axes, because FITPACK has absolute tolerances.
        nodes, middles = np.linspace(0.0, 1.0, count), (np.arange(count - 1) + 0.5) / (count - 1)
        at_nodes, at_middles = (
            field_map.undistorted(x[0] + part * (x[-1] - x[0]), y[0] + part[:, None] * (y[-1] - y[0]), spectrum)[::-1]
            for part in (nodes, middles)
        )
        splines = [
            scipy.interpolate.RectBivariateSpline(nodes, nodes, values, kx=5, ky=5, s=0) for values in at_nodes
        ]
        error = max(float(np.abs(s(middles, middles) - e).max()) for s, e in zip(splines, at_middles, strict=True))
        if error <= tol:
            source_y, source_x = (s(*(np.linspace(0.0, 1.0, len(axis)) for axis in (y, x))) for s in splines)
            return source_y, source_x
        # Halve the spacing: the new nodes include the old nodes.
        count = 2 * count - 1
    raise ValueError("distortion of the map varies too fast to be interpolated; make a map with smoother tilts")
