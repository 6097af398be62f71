"""Photographs of sharp images: depth-of-field rendering, by tiles, of focus pulls, or through a field map."""

from __future__ import annotations

import copy
import sys
from collections import OrderedDict
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, Protocol, TypeAlias, Unpack, cast, overload

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.encoding import clipped_share, from_light, scene_light, to_light
from lommel.base.optional import library
from lommel.base.options import require_known, shares
from lommel.core import engine
from lommel.deconvolve.linear import LinearBlur, tiles_of
from lommel.field.maps import FieldMap, require_one_aperture
from lommel.imaging.blur import DepthBlur, require_lens, require_metres
from lommel.imaging.field_blur import FieldBlur, PointLight
from lommel.imaging.occlusion import Occlusion, reach_behind
from lommel.imaging.settings import MISSING, FieldKeywords, Keywords, Settings, Spectrum
from lommel.optics.colour.spectrum import Channels
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil

Pixels = NDArray[np.generic]  # stored values, unsigned integers or floats

TILE = 1024  # default side of the tiles of memory maps, pixels

_DaskArray: TypeAlias = Any  # dask is typed in part only

_STRIP = 2**20  # depths read at once to find their range


class LazyArray(Protocol):
    """The part of a dask array's interface that is used here."""

    shape: tuple[int, ...]
    chunks: tuple[tuple[int, ...], ...]

    def compute(self, **options: object) -> Pixels:
        """Return the values."""


@dataclass(frozen=True, eq=False)
class Photograph:
    """What :func:`lommel.imaging.depth_of_field` returns for arrays; converts to an array of its values.

    Attributes
    ----------
    values : ndarray
        Of the shape, type and encoding of the image.
    lost : float
        Largest share of the light of a point beyond its window, which is spread over the window instead; 0 with
        ``energy=1``.
    error : float
        Largest error of interpolated windows over their peak, checked half-way between windows. With ``energy=1`` the
        sum over all pixels of the largest error of a PSF there, at any depth and in any channel: without occlusion no
        pixel is off by more than this times the brightest point of the scene, in light. It includes estimates of the
        error far from the point and of rounding, not the steps between integers.
    window : int
        Side of the largest window, pixels.
    clipped : float
        Fraction of the values that were clipped at white, as on a sensor; 0 for floats.
    """

    values: Pixels
    lost: float
    error: float
    window: int
    clipped: float = 0.0

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> Pixels:
        """Return the values."""
        return np.array(self.values, dtype=dtype, copy=copy)


def _photograph(values: Pixels, blur: DepthBlur, clipped: float) -> Photograph:
    """Return values as a photograph, with the error of its blur and the share that was clipped."""
    return Photograph(values, blur.lost, blur.error, 2 * max(bank.half for bank in blur.banks) + 1, clipped)


def fill_missing(depth: ArrayLike, missing: str) -> Values:
    """Return a depth map whose NaNs are filled as the option `missing` says."""
    validation.choice("missing", missing, MISSING)
    distances = validation.array("depth", depth)
    if distances.dtype.kind != "f" or missing == "raise" or not np.isnan(distances).any():
        return distances
    unknown = np.isnan(distances)
    if missing == "infinity":
        return np.where(unknown, np.inf, distances)
    if unknown.all():
        raise ValueError("depth is NaN everywhere")
    from scipy.ndimage import distance_transform_edt

    nearest = distance_transform_edt(unknown, return_distances=False, return_indices=True)
    return np.asarray(distances[tuple(nearest)])


def stored(light: Values, encoding: str, dtype: DTypeLike, threads: int = 0) -> tuple[Pixels, float]:
    """Return finite light, white being 1, as stored values, and the share that an integer type clips."""
    if light.dtype != np.float32 or dtype != np.uint8 or light.size == 0:
        return from_light(light, encoding, dtype), clipped_share(light, dtype)
    # Comparing with the edges of the levels is faster than encoding each value, and rounds alike.
    values = np.empty(light.shape, dtype=np.uint8)
    level = 1.0 / 255.0
    flat = np.ascontiguousarray(light).reshape(-1)
    # A value is clipped where it is more than a level beyond 0 or 1.
    beyond = engine.levels(flat, _edges(encoding), -level, 1.0 + level, threads, values.reshape(-1))
    return values, beyond / light.size


@lru_cache
def _edges(encoding: str) -> NDArray[np.float32]:
    """Return the light half-way between the levels of a byte."""
    return to_light("edges", (np.arange(255) + 0.5) / 255.0, encoding, np.float64).astype(np.float32)


def output(
    out: Pixels | None, name: str, shape: tuple[int, ...], dtype: np.dtype[np.generic], *read: Pixels
) -> Pixels:
    """Return `out`, checked for values like those of the image called `name`, or a new array; `read` is kept."""
    if out is None:
        return np.empty(shape, dtype=dtype)
    if not isinstance(out, np.ndarray):
        raise TypeError(f"out must be an array, got {validation.shown(out)}")
    if out.shape != shape:
        raise ValueError(f"out must have the shape of the {name}, {shape}, got {out.shape}")
    if out.dtype != dtype:
        raise TypeError(f"out must have the type of the {name}, {dtype}, got {out.dtype}")
    if not out.flags.writeable or any(np.may_share_memory(out, each) for each in read):
        raise ValueError(f"out must be writeable, and must not share memory with {name} or depth")
    return out


def require_image(name: str, shape: tuple[int, ...]) -> None:
    """Refuse a shape that is not that of an image, called `name`."""
    if len(shape) not in (2, 3) or 0 in shape:
        raise ValueError(f"{name} must have the shape (height, width) or (height, width, channels), got {shape}")


def require_scene(name: str, shape: tuple[int, ...], depth: tuple[int, ...]) -> None:
    """Refuse shapes that are not those of an image, called `name`, and of its depth map."""
    require_image(name, shape)
    if depth != shape[:2]:
        raise ValueError(f"depth must have the shape of the {name}, {shape[:2]}, got {depth}")


@shares(Keywords, Settings)
class FocusPlan:
    """Depth-of-field rendering of one scene, for live use: focus and f-number change from frame to frame.

    The options are checked and the image is decoded once. A frame computes the windows and the occlusion of its focus
    setting, unless that is one of the last settings, then blurs and encodes. The values are those of
    :func:`lommel.imaging.depth_of_field` with the same arguments, bit for bit.

    Parameters
    ----------
    image, depth, lens, pixel, encoding
        As of :func:`lommel.imaging.depth_of_field`. The image and the depth are copied.
    keep : int, default 4
        Number of lens settings whose windows and occlusion are kept, 1 to 1000. A setting takes a few MiB, 8 bytes
        per point and channel, and with `occlusion` the memory of :class:`lommel.imaging.Occlusion`; with ``energy=1``
        up to five times as much.
    supersample : int, default 1
        As of :func:`lommel.imaging.depth_of_field`.
    {options}

    Raises
    ------
    TypeError, ValueError
        As :func:`lommel.imaging.depth_of_field`; and if the windows of `lens` as it is given exceed `largest`, since
        they are computed at once.

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
        encoding: str,
        keep: int = 4,
        supersample: int = 1,
        **options: Unpack[Keywords],
    ) -> None:
        require_lens(lens, "image, depth, lens, pixel")
        self.settings = Settings.of(FocusPlan, options, Keywords)
        given = validation.array("image", image)
        # A copy: the caller may change the map between frames.
        distances = np.array(fill_missing(depth, self.settings.missing))
        require_scene("image", given.shape, distances.shape)
        self._finer = validation.integer("supersample", supersample, least=1, most=16)
        height, width = (side // self._finer for side in given.shape[:2])
        if (height * self._finer, width * self._finer) != given.shape[:2]:
            raise ValueError(
                f"supersample must divide the height and the width of the image, {given.shape[:2]}, got {supersample}"
            )
        self.lens, self.shape, self.dtype = lens, (height, width, *given.shape[2:]), given.dtype
        self._encoding = encoding
        self._light = scene_light("image", given, encoding, self.settings.dtype)
        self._depth = distances
        self._keep = validation.integer("keep", keep, least=1, most=1000)
        self._pixel = validation.pixel(pixel, metric=True) / self._finer
        self._channels = self.settings.channels(self.shape, lens.wavelength)
        self._known: OrderedDict[tuple[float, float], Occlusion] = OrderedDict()
        self.blur()

    def lens_at(self, *, focus_distance: float | None = None, f_number: float | None = None) -> Lens:
        """Return the lens at another `focus_distance` (metres) or `f_number`; None leaves that of `lens`.

        Errors are those of :meth:`lommel.Lens.focused` and :meth:`lommel.Lens.stopped`.
        """
        lens = self.lens if f_number is None else self.lens.stopped(f_number)
        return lens if focus_distance is None else lens.focused(focus_distance)

    def blur(self, *, focus_distance: float | None = None, f_number: float | None = None) -> DepthBlur:
        """Return the linear operator at a `focus_distance` and `f_number`; ValueError if the blur is too large."""
        return self._occlusion_at(focus_distance, f_number).blur

    def _occlusion_at(self, focus_distance: float | None, f_number: float | None) -> Occlusion:
        """Return the operator with occlusion at a focus and f-number, and keep it."""
        lens = self.lens_at(focus_distance=focus_distance, f_number=f_number)
        # Sensor distance and aperture diameter determine the lens: equal ones in other words are found again.
        key = (lens.sensor_distance, lens.aperture_diameter)
        if key in self._known:
            self._known.move_to_end(key)
            return self._known[key]
        made = Occlusion(DepthBlur(self._depth, lens, self._pixel, channels=self._channels, **self.settings.of_blur))
        self._known[key] = made
        if len(self._known) > self._keep:
            self._known.popitem(last=False)
        return made

    def __call__(
        self, *, focus_distance: float | None = None, f_number: float | None = None, out: Pixels | None = None
    ) -> Photograph:
        """Return the photograph at a focus and f-number.

        Parameters
        ----------
        focus_distance : float, optional
            Object distance in focus, metres, more than the focal length, may be infinite; by default that of the
            lens. The sensor moves, and with it the working f-number.
        f_number : float, optional
            Focal length over the diameter of the aperture; by default that of the lens.
        out : ndarray, optional
            Array of the shape and type of the image that the values are written to.

        Returns
        -------
        Photograph

        Raises
        ------
        TypeError, ValueError
            If an argument is out of range, or the blur exceeds the largest window allowed. `out` is then untouched.
        """
        if out is not None:
            output(out, "image", self.shape, self.dtype)
        occlusion = self._occlusion_at(focus_distance, f_number)
        seen = (occlusion if self.settings.occlusion else occlusion.blur).forward(self._light)
        if self._finer > 1:
            height, width, *channels = self.shape
            seen = seen.reshape(height, self._finer, width, self._finer, *channels).mean(axis=(1, 3))
        values, clipped = stored(seen, self._encoding, self.dtype, self.settings.threads or 0)
        made = _photograph(values, occlusion.blur, clipped)
        if out is None:
            return made
        # Errors must leave `out` as it was, so it is written to at the end.
        np.copyto(out, made.values)
        return replace(made, values=out)


class ChunkKeywords(Keywords, total=False):
    """Options of depth-of-field rendering by parts."""

    tile: int | None
    depths: tuple[float, float] | None


class SceneKeywords(ChunkKeywords, total=False):
    """Options of depth-of-field rendering at once."""

    supersample: int
    out: Pixels | None
    progress: Callable[[int, int], object] | None


@overload
def depth_of_field(
    image: LazyArray, depth: LazyArray, lens: Lens, pixel: float, *, encoding: str, **options: Unpack[ChunkKeywords]
) -> LazyArray: ...


@overload
def depth_of_field(
    image: ArrayLike, depth: ArrayLike, lens: Lens, pixel: float, *, encoding: str, **options: Unpack[SceneKeywords]
) -> Photograph: ...


@shares(Keywords, Settings)
def depth_of_field(
    image: ArrayLike | LazyArray,
    depth: ArrayLike | LazyArray,
    lens: Lens,
    pixel: float,
    *,
    encoding: str,
    supersample: int = 1,
    tile: int | None = None,
    depths: tuple[float, float] | None = None,
    out: Pixels | None = None,
    progress: Callable[[int, int], object] | None = None,
    **options: Unpack[Keywords],
) -> Photograph | LazyArray:
    """Render the depth of field of a lens: blur each point of a sharp image by the PSF at its distance.

    The PSFs are pixel-integrated, with diffraction, aberrations and colour (:class:`lommel.imaging.DepthBlur`), and
    near points occlude far ones (:class:`lommel.imaging.Occlusion`). Arrays are rendered at once; memory maps, and
    arrays with `tile`, in overlapping tiles with little memory; dask arrays lazily, by chunks. Tiles and chunks agree
    with the whole image but for rounding: they share their windows and overlap by half a window, with `occlusion` by
    twice the range of blur radii more, the distance over which occluded points are searched.

    Parameters
    ----------
    image : array_like, memory map or dask array, shape (height, width) or (height, width, channels)
        Unsigned integers (white is their largest value) or floats (white is 1).
    depth : array_like, memory map or dask array, shape (height, width)
        Distance of each point from the lens along the axis, metres; may be infinite. It is read twice, first for its
        range; with ``missing="nearest"`` it is read as a whole, since the nearest depth may lie in any tile.
    lens : Lens
        With radially symmetric aberrations.
    pixel : float
        Pixel pitch of the result, metres.
    encoding : {"srgb", "linear"}
        Of the values of `image`, and of the result.
    supersample : int, default 1
        Points of `image` and `depth` along each side of a pixel of the result, 1 to 16: the scene is given at points
        ``pixel / supersample`` apart, and the result averages their light over its pixels. `largest` and the `window`
        of the result count points. Not with `tile` or `depths`, nor for dask arrays; memory maps are
        rendered at once.
    tile : int, optional
        Side of the tiles, pixels, 16 to 16384; by default 1024 for memory maps. Memory beyond input and output is
        about a hundred bytes per pixel of a tile, and with `occlusion` several hundred per channel. For dask arrays
        the side of the chunks, which are kept by default.
    depths : (float, float), optional
        Nearest and farthest distance in the scene, metres, where they are known: `depth` is then not read for them.
    out : ndarray, optional
        Array or memory map of the shape and type of the result that the values are written to. Not for dask arrays.
    progress : callable, optional
        Called as ``progress(done, tiles)`` after each tile. Not for dask arrays.
    {options}

    Returns
    -------
    Photograph or dask.array.Array
        A dask array for dask arrays, of the shape and type of `image`; windows are computed immediately, the rest
        lazily, each chunk by one thread unless `threads` is given.

    Raises
    ------
    TypeError, ValueError
        If an argument is unknown or out of range, if shapes do not match, if the lens is not radially symmetric, if
        the blur exceeds `largest`, if an image has two or four channels and no `wavelengths` are given (one may be
        alpha), or if `out` does not fit. Tiles already written are kept. Chunks are checked when they are computed.
    """
    require_known(depth_of_field, options, Keywords)
    require_lens(lens, "image, depth, lens, pixel")
    if tile is not None:
        validation.integer("tile", tile, least=16, most=validation.MAX_SIDE)
    validation.function("progress", progress, required=False)
    lazy = _are_dask(image, depth)
    if supersample != 1 and (tile is not None or depths is not None or lazy):
        raise ValueError(f"supersample must be 1 with tile or depths and for dask arrays, got {supersample}")
    if lazy:
        if out is not None or progress is not None:
            raise ValueError(
                "out and progress are not for dask arrays, which are computed later: use "
                "dask.array.store(result, out) and dask.diagnostics.ProgressBar"
            )
        # dask runs chunks in parallel: a thread each by default.
        given: Keywords = {"threads": 1, **options}
        return _lazy(image, depth, lens, pixel, encoding, tile, depths, Settings(**given))
    if tile is None and supersample == 1 and any(isinstance(part, np.memmap) for part in (image, depth, out)):
        tile = TILE
    values = validation.array("image", cast("ArrayLike", image))
    distances = validation.array("depth", cast("ArrayLike", depth))
    if tile is None and depths is None:
        made = FocusPlan(values, distances, lens, pixel, encoding=encoding, supersample=supersample, **options)(
            out=out
        )
        if progress is not None:
            progress(1, 1)
        return made
    return _by_tiles(values, distances, lens, pixel, encoding, tile, depths, Settings(**options), out, progress)


def _by_tiles(
    values: Pixels,
    distances: Pixels,
    lens: Lens,
    pixel: float,
    encoding: str,
    tile: int | None,
    depths: tuple[float, float] | None,
    settings: Settings,
    out: Pixels | None,
    progress: Callable[[int, int], object] | None,
) -> Photograph:
    """Return the photograph of arrays or memory maps, tile by tile."""
    require_scene("image", values.shape, distances.shape)
    out = output(out, "image", values.shape, values.dtype, values, distances)
    if settings.missing == "nearest":
        distances = fill_missing(distances, "nearest")
    depths = depth_range(distances, settings.missing) if depths is None else depths
    blur = TileBlur(values.shape, depths, lens, pixel, encoding, settings)
    tiles = list(tiles_of(values.shape, tile or max(values.shape[:2]), blur.overlap))
    clipped = 0.0
    for done, (inside, around, within) in enumerate(tiles, 1):
        seen = blur.light(values[around], np.asarray(distances[around]))[within]
        out[inside], share = stored(seen, encoding, values.dtype, settings.threads or 0)
        clipped += share * seen.size / out.size
        if progress is not None:
            progress(done, len(tiles))
    return _photograph(out, blur.whole, clipped)


def _are_dask(image: object, depth: object) -> bool:
    """Return whether image and depth are dask arrays; TypeError if only one is."""
    da = sys.modules.get("dask.array")  # without which there are no such arrays
    found = [da is not None and isinstance(part, da.Array) for part in (image, depth)]
    if any(found) and not all(found):
        raise TypeError(
            "image and depth must both be dask arrays if one is, "
            f"got {type(image).__name__} and {type(depth).__name__}; dask.array.from_array() makes one"
        )
    return all(found)


def _lazy(
    image: _DaskArray,
    depth: _DaskArray,
    lens: Lens,
    pixel: float,
    encoding: str,
    tile: int | None,
    depths: tuple[float, float] | None,
    settings: Settings,
) -> LazyArray:
    """Return the photograph of dask arrays as a dask array, computed chunk by chunk."""
    dask, da = (library(name, "chunks need", "dask") for name in ("dask", "dask.array"))
    require_scene("image", image.shape, depth.shape)
    require_metres(depth.dtype)
    if tile is not None:
        image = image.rechunk({0: tile, 1: tile})
    # Channels are blurred and encoded together.
    if image.ndim == 3:
        image = image.rechunk({2: -1})
    if settings.missing == "nearest":
        # The nearest depth may lie in any chunk.
        depth = depth.rechunk(-1).map_blocks(fill_missing, "nearest", dtype=depth.dtype, meta=depth._meta)
    if depths is None:
        known = da.where(da.isnan(depth), float("inf"), depth) if settings.missing == "infinity" else depth
        low, high = dask.compute(known.min(), known.max())
        depths = _known_range(float(low), float(high))
    blur = TileBlur(image.shape, depths, lens, pixel, encoding, settings)
    distances = depth.rechunk(image.chunks[:2])
    # dask refuses an overlap beyond the array.
    around = {axis: min(blur.overlap, image.shape[axis]) for axis in (0, 1)}
    if image.ndim == 3:
        # Chunks of the two arrays are matched by their axes, counted from the last.
        distances, around = distances[..., None], around | {2: 0}
    made: LazyArray = da.map_overlap(
        blur.chunk,
        image,
        distances,
        depth=[around, around],
        boundary="none",
        align_arrays=False,
        dtype=image.dtype,
        meta=image._meta,
    )
    return made


class TileBlur:
    """:func:`lommel.imaging.depth_of_field` of any part of a scene, with windows computed once; can be pickled."""

    def __init__(
        self,
        shape: tuple[int, ...],
        depths: tuple[float, float],
        lens: Lens,
        pixel: float,
        encoding: str,
        settings: Settings,
    ) -> None:
        if settings.energy == 1.0:
            raise ValueError(
                "energy must be below 1 for tiles and chunks, since with all of its light a point reaches the whole "
                "image: give a smaller energy such as 0.99, or the whole image at once, such as np.array(image)"
            )
        # Where it is "nearest" the whole depth has been filled before it was cut.
        self.missing = "raise" if settings.missing == "nearest" else settings.missing
        self.encoding, self._occlusion = encoding, settings.occlusion
        keywords = settings.of_blur | {"largest": settings.largest or max(1, min(shape[:2]) // 2)}
        with np.errstate(over="ignore"):  # long doubles
            # Only the two ends of the range: they determine the windows of all parts.
            extremes = np.array(validation.number_array("depths", depths), dtype=np.float64)[None]
        if extremes.shape != (1, 2) or np.isnan(extremes).any():
            raise ValueError(f"depths must be the nearest and the farthest, got {validation.shown(depths)}")
        self.whole = DepthBlur(extremes, lens, pixel, channels=settings.channels(shape, lens.wavelength), **keywords)
        self._reach = (float(self.whole.defocus.min()), float(self.whole.defocus.max()))
        self.half = max(bank.half for bank in self.whole.banks)
        # Pixels around a part that it depends on, where the image continues.
        self.overlap = self.half + (reach_behind(self.whole, self._reach) if self._occlusion else 0)

    def light(self, image: Pixels, depth: Pixels) -> Values:
        """Return the light of a part; within `overlap` of a side where the image continues it is incomplete."""
        image, depth = validation.array("image", image), validation.array("depth", depth)
        return self.operator(depth).forward(scene_light("image", image, self.encoding, self.whole.dtype))

    def operator(self, depth: Pixels) -> LinearBlur:
        """Return the operator of a part, with occlusion as in the whole scene."""
        blur = copy.copy(self.whole)
        blur.place(fill_missing(depth, self.missing))
        low, high = self._reach
        if blur.defocus.min() < low or blur.defocus.max() > high:
            raise ValueError(
                f"depth must give C_d from {low:.6g} to {high:.6g} rad, as the depths named for the whole image, "
                f"got {blur.defocus.min():.6g} to {blur.defocus.max():.6g}"
            )
        return Occlusion(blur, self._reach) if self._occlusion else blur

    def chunk(self, image: Pixels, depth: Pixels) -> Pixels:
        """Return the photograph of a part whose depth has as many axes as the image."""
        light = self.light(image, depth.reshape(depth.shape[:2]))
        return stored(light, self.encoding, image.dtype, self.whole.threads)[0]


def depth_range(depth: Pixels, missing: str = "raise") -> tuple[float, float]:
    """Return the nearest and the farthest distance, metres, reading a strip of rows at a time."""
    require_metres(depth.dtype)
    rows = max(1, _STRIP // depth.shape[1])
    low, high = np.inf, -np.inf
    for first in range(0, depth.shape[0], rows):
        part = fill_missing(np.asarray(depth[first : first + rows]), missing)
        low, high = np.minimum(low, part.min()), np.maximum(high, part.max())
    return _known_range(float(low), float(high))


def _known_range(low: float, high: float) -> tuple[float, float]:
    """Return the range of depths; ValueError if one of them is NaN."""
    if np.isnan(low):
        raise ValueError("depth is NaN at some points; say what is there by `missing`")
    return low, high


PLACES = 1e-3
"""Accuracy of the source position of pixels, pixels, checked half-way between nodes."""

_FEW = 4096  # pixels below which positions are computed one by one
_MOST = 257  # largest number of nodes along a side
_MODES = {"reflect": "reflect", "extend": "nearest", "zero": "grid-constant"}  # borders as SciPy calls them


@shares(FieldKeywords, Settings)
def field_photograph(
    image: ArrayLike,
    field_map: FieldMap,
    pixel: float,
    *,
    encoding: str,
    center: tuple[float, float] | None = None,
    sensor: tuple[float, float] | None = None,
    wavelengths: Channels | Sequence[Spectrum] | None = None,
    tol: float = 1e-3,
    **options: Unpack[FieldKeywords],
) -> Photograph:
    """Render a sharp image as a lens records it: blur over the field, distortion, lateral colour, shading.

    The image is what an ideal lens would record. Each channel is resampled by quintic splines to where the tilts of
    the map move its light (:meth:`lommel.FieldMap.displacement`), then blurred by :class:`lommel.imaging.FieldBlur`
    with the PSFs of the map without these tilts, and multiplied by the shading of the map. This is the blur by the
    PSFs of the map with its tilts, for displacements of any size.

    Parameters
    ----------
    image : array_like, shape (height, width) or (height, width, channels)
        Unsigned integers (white is their largest value) or floats (white is 1).
    field_map : FieldMap
        Positions are those without distortion. Lateral and axial colour are those of the lens of its aperture.
    pixel : float
        Pixel pitch, in the unit of the map (metres if it has a wavelength).
    encoding : {"srgb", "linear"}
        Of the values of `image`, and of the result.
    center, sensor
        As of :class:`lommel.imaging.FieldBlur`. A `sensor` larger than the image exaggerates PSFs, not distortion.
    wavelengths : Channels or sequence, optional
        :class:`lommel.Channels`, or a wavelength (metres) or pairs of wavelength and weight for each channel. By
        default that of the map for a grey image, and 600, 540 and 460 nm for one of three channels.
    tol : float, default 1e-3
        As of :class:`lommel.imaging.FieldBlur`.
    {options}

    Returns
    -------
    Photograph
        Without resampling, no pixel is off by more than ``error + 2 * lost`` times the brightest point, in light;
        `error` is the largest sum of absolute differences between interpolated and exact windows.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range; if light comes from beyond the map; if the map has vignetting.

    Notes
    -----
    A uniform scene stays uniform but for the shading, which is the relative illumination as measured: where
    distortion stretches the picture, points have more light. :class:`lommel.imaging.FieldBlur` with the tilts in its
    windows conserves the light of points instead.

    Places are accurate to 0.001 pixel. Splines change a Gaussian of standard deviation 1 pixel by 0.3 % of its peak,
    of 1.5 pixels by 0.04 %, of 2 pixels by 0.005 %; next to sharp edges they overshoot, and light below 0 becomes 0.

    Examples
    --------
    >>> field = lm.FieldMap.from_seidel(2.5e-3, W311=-60.0, W131=0.5, wavelength=550e-9, f_number=4.0)
    >>> image = np.zeros((60, 80, 3), np.float32)
    >>> image[30, 60] = 1.0
    >>> made = lm.imaging.field_photograph(image, field, 4e-6, encoding="linear", sensor=(3e-3, 4e-3))
    >>> made.values.shape
    (60, 80, 3)
    """
    validation.instance("field_map", field_map, FieldMap)
    given = validation.array("image", image)
    require_image("image", given.shape)
    require_one_aperture(field_map)
    settings = Settings.of(field_photograph, dict(options), FieldKeywords)
    known = field_map.pupil_without_wavefront.wavelength
    spectra: Sequence[Spectrum] | None = None
    if known is not None:
        spectra = Settings(wavelengths=wavelengths).channels(given.shape, known)
    elif wavelengths is not None or given.ndim == 3:
        raise ValueError("image must be grey, without wavelengths=, for a map without a wavelength; make the map "
                         "with wavelength= and f_number=")  # fmt: skip
    light = scene_light("image", given, encoding, settings.dtype)
    shape = (given.shape[0], given.shape[1])
    blur = StraightBlur(field_map, shape, pixel, center=center, sensor=sensor, channels=spectra, tol=tol, **options)
    planes = light.reshape(*shape, -1)
    moved = np.empty_like(planes)
    for k, spectrum in enumerate(blur.spectra):
        moved[..., k] = resampled(planes[..., k], blur, spectrum)
    seen = blur.forward(moved.reshape(light.shape))
    if field_map.shading is not None:
        lit = np.asarray(field_map.illumination(blur.x, blur.y[:, None]), dtype=seen.dtype)
        # Shading is a factor of the recorded light, at the position where it arrives.
        seen = seen * lit.reshape(*shape, *(1,) * (seen.ndim - 2))
    values, clipped = stored(seen, encoding, given.dtype, settings.threads or 0)
    side = max(bank.window(blur.y[0], blur.x[0]).shape[0] for bank in blur.banks)
    return Photograph(values, blur.lost, blur.error, side, clipped)


class StraightLight(PointLight):
    """The PSF of the light that arrives at a position of the sensor, centred on it."""

    def pupil(self, y: Array, x: Array, defocus: Array) -> Pupil:
        """Return the stack of pupils whose light arrives at positions, without the tilts that move it there."""
        return self.field_map.untilted(x, y, self.spectrum)


class StraightBlur(FieldBlur):
    """Blur by the PSFs of a field map without their tilts, of an image that is already distorted."""

    @property
    def _point_light(self) -> type[PointLight]:
        return StraightLight

    def _require_within_map(self, x: Array, y: Array) -> None:
        """Raise ValueError where light comes from outside the map."""
        for spectrum in self.spectra:
            self.field_map.undistorted(x, y, spectrum)


def resampled(plane: Values, blur: StraightBlur, spectrum: Spectrum | None) -> Values:
    """Return a plane of light with each point moved as the map distorts it, by quintic splines."""
    from scipy.ndimage import map_coordinates

    pitch = [float(along[1] - along[0]) if len(along) > 1 else blur.pixel for along in (blur.y, blur.x)]
    down, across = _places(blur.field_map, blur.y, blur.x, spectrum, PLACES * min(pitch))
    at = np.stack([(down - blur.y[0]) / pitch[0], (across - blur.x[0]) / pitch[1]])
    # Without distortion the image stays as it is, free of resampling errors.
    if all(np.abs(found - here).max() <= PLACES for found, here in zip(at, np.indices(plane.shape), strict=True)):
        return plane
    made: Values = map_coordinates(plane, at, order=5, mode=_MODES[blur.border], output=plane.dtype)
    # Splines overshoot at edges; light is not negative.
    return np.maximum(made, 0.0) if plane.min() >= 0.0 else made


def _places(field_map: FieldMap, y: Array, x: Array, spectrum: Spectrum | None, tol: float) -> tuple[Array, Array]:
    """Return y and x, without distortion, of the light that arrives at rows and columns, within `tol`."""
    from scipy.interpolate import RectBivariateSpline

    if len(y) * len(x) <= _FEW or min(len(y), len(x)) < 16:
        across, down = field_map.undistorted(x, y[:, None], spectrum)
        return down, across
    count = 9
    while count <= _MOST:
        # Over positions from 0 to 1, because FITPACK compares with absolute tolerances.
        nodes, between = np.linspace(0.0, 1.0, count), (np.arange(count - 1) + 0.5) / (count - 1)
        known, exact = (
            field_map.undistorted(x[0] + part * (x[-1] - x[0]), y[0] + part[:, None] * (y[-1] - y[0]), spectrum)[::-1]
            for part in (nodes, between)
        )
        splines = [RectBivariateSpline(nodes, nodes, part, kx=5, ky=5, s=0) for part in known]
        off = max(float(np.abs(s(between, between) - e).max()) for s, e in zip(splines, exact, strict=True))
        if off <= tol:
            down, across = (s(*(np.linspace(0.0, 1.0, len(along)) for along in (y, x))) for s in splines)
            return down, across
        # Old nodes are among the new ones, and the spacing halves.
        count = 2 * count - 1
    raise ValueError("distortion of the map must be smooth over the field, and changes between close pixels")
