"""Photographs from files and to them: PNG, JPEG and TIFF, as light, with what EXIF knows of the lens."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base import atomic, reading, validation
from lommel.base.encoding import ENCODINGS, from_light, to_light
from lommel.io import fits_images, photo_formats, registry
from lommel.io import photo_formats as formats
from lommel.io.registry import Format

_pillow, _tifffile = (partial(Format, library=name, extra="images") for name in ("PIL.Image", "tifffile"))
PNG, JPEG, TIFF = (b"\x89PNG\r\n\x1a\n",), (b"\xff\xd8\xff",), (b"II*\0", b"MM\0*", b"II+\0", b"MM\0+")
"""What files begin with."""

_RAW = (b"FUJIFILMCCD-RAW", b"IIRO", b"IIRS", b"MMOR", b"IIU\0", b"FOVb", b"\0MRM")
_RAW_SUFFIXES = (
    *(".3fr", ".arw", ".cr2", ".cr3", ".crw", ".dcr", ".dng", ".erf", ".fff", ".iiq", ".kdc", ".mef", ".mos", ".mrw"),
    *(".nef", ".nrw", ".orf", ".pef", ".raf", ".rw2", ".rwl", ".sr2", ".srf", ".srw", ".x3f"),
)

_8, _16, _FLOAT = "of uint8", "of uint16", "of float32"
registry.register(
    _pillow("photo", (".png",), formats.write_png, formats.read_png, PNG, (_8, _16)),
    _pillow("photo", (".jpg", ".jpeg"), formats.write_jpeg, formats.read_jpeg, JPEG, (_8,)),
    _tifffile("photo", (".tif", ".tiff"), formats.write_tiff, formats.read_tiff, TIFF, (_8, _16, _FLOAT)),
)
find = partial(registry.find, "photo")

_FILM_DIAGONAL = math.hypot(36e-3, 24e-3)
# What EXIF's Orientation asks for, from stored rows and columns to those of the scene.
_TURNS = {
    1: lambda a: a,
    2: lambda a: a[:, ::-1],
    3: lambda a: a[::-1, ::-1],
    4: lambda a: a[::-1],
    5: lambda a: a.swapaxes(0, 1),
    6: lambda a: a[::-1].swapaxes(0, 1),
    7: lambda a: a[::-1, ::-1].swapaxes(0, 1),
    8: lambda a: a[:, ::-1].swapaxes(0, 1),
}


class PhotoError(ValueError):
    """A file that cannot be read as a photograph or a depth map; the message names it and says why."""


@dataclass(frozen=True)
class Exif:
    """What a photograph says of its lens; None where it says nothing (EXIF writes 0 for unknown).

    Attributes
    ----------
    focal_length : float or None
        Metres.
    f_number : float or None
    film_focal_length : float or None
        Metres: the focal length with the same angle of view on film of 36 mm x 24 mm.
    """

    focal_length: float | None = None
    f_number: float | None = None
    film_focal_length: float | None = None

    def pixel(self, shape: tuple[int, ...]) -> float:
        """Return the pixel pitch (metres) of an image of `shape` that has the diagonal of the whole sensor.

        EXIF rounds the film equivalent to whole millimetres, which makes an error of a few per cent.

        Parameters
        ----------
        shape : tuple of int
            Height and width first.

        Returns
        -------
        float

        Raises
        ------
        TypeError
            If `shape` is no shape of an image.
        ValueError
            If either focal length is unknown, or a side is out of range.
        """
        if not isinstance(shape, tuple | list) or len(shape) < 2:
            raise TypeError(f"shape must be (height, width), got {validation.shown(shape)}")
        validation.image_shape(tuple(shape[:2]))
        if self.focal_length is None or self.film_focal_length is None:
            raise ValueError("the EXIF does not state a focal length and its 35 mm equivalent; give the pixel pitch")
        return _FILM_DIAGONAL * self.focal_length / self.film_focal_length / math.hypot(*shape[:2])


@dataclass(frozen=True, eq=False)
class Picture:
    """A photograph as it is stored, upright.

    Attributes
    ----------
    values : ndarray, shape (height, width) or (height, width, 3)
        uint8, uint16 or float.
    encoding : {"srgb", "linear"}
    exif : Exif
    profile : bytes or None
        ICC profile. It is handed on, not interpreted: of sRGB only the curve is used, which that of most displays is.
    """

    values: NDArray[Any]
    encoding: str
    exif: Exif
    profile: bytes | None = None

    def light(self, dtype: DTypeLike = np.float32) -> NDArray[Any]:
        """Return values in proportion to light, 1 being white.

        Parameters
        ----------
        dtype : float32 or float64, default float32

        Returns
        -------
        ndarray
            Of the shape of `values`.

        Raises
        ------
        TypeError
            If `dtype` is another.
        """
        return to_light("the photograph", self.values, self.encoding, dtype)


def read_photo(path: str | PathLike[str], encoding: str | None = None) -> Picture:
    """Read a photograph, told by its content to be PNG, JPEG or TIFF, and turn it as its EXIF says.

    Parameters
    ----------
    path : path
    encoding : {"srgb", "linear"}, optional
        Of the values stored. By default integers are sRGB and floats linear.

    Returns
    -------
    Picture
        8 or 16 bits, or floats (TIFF), with all of them: 16-bit colour of PNG too.

    Raises
    ------
    PhotoError
        If the file is damaged, of another format, a raw photograph, animated, has more than 16384^2 pixels or a side
        of more than 65536, takes 256 MB of memory and a hundred times its size, or has alpha, a colour space but grey
        and RGB, or values but uint8, uint16 and floats.
    ImportError
        If Pillow or tifffile is not installed.
    OSError
        If it cannot be read.
    """
    if encoding is not None:
        validation.choice("encoding", encoding, ENCODINGS)
    values, exif, profile = read_raster(path)
    return Picture(values, encoding or ("linear" if values.dtype.kind == "f" else "srgb"), exif, profile)


def read_raster(path: str | PathLike[str]) -> tuple[NDArray[Any], Exif, bytes | None]:
    """Return the upright values of a photograph, its EXIF and its ICC profile; see :func:`read_photo`."""
    source = validation.path("path", path)
    data = reading.contents(source)
    with told(source, "photo", data) as form:
        return upright(form, data)


@contextmanager
def told(source: Path, kind: str, data: bytes) -> Iterator[Format]:
    """Yield the format of the contents of a file; PhotoError if there is none, or if what reads it fails."""
    if _is_raw(source, data):
        raise PhotoError(
            f"{validation.line(source)} is a raw photograph, of which a preview is all that could be read. Develop "
            "it first, for example by rawpy.imread(path).postprocess(gamma=(1, 1), no_auto_bright=True, "
            "output_bps=16), and save it as TIFF"
        )
    try:
        form = registry.identify(kind, data)
    except ValueError as error:
        raise PhotoError(f"{validation.line(source)} {error}") from None
    what = {"photo": f"a {form.name} photograph", "images": kind}.get(kind, f"a {kind}")
    try:
        yield form
    except ImportError:
        raise
    except Exception as error:
        raise PhotoError(f"{validation.line(source)} cannot be read as {what}: {reading.reason(error)}") from error


def _is_raw(source: Path, data: bytes) -> bool:
    if source.suffix.lower() in _RAW_SUFFIXES or data.startswith(_RAW) or data[4:12] == b"ftypcrx ":
        return True
    try:
        return data.startswith(TIFF) and reading.is_raw(data)
    except ValueError:
        return False  # damaged, which is told where it is read


def upright(form: Format, data: bytes) -> tuple[NDArray[Any], Exif, bytes | None]:
    """Return what a file holds, turned as its EXIF says; what Pillow warns of, parts it leaves out, is an error."""
    with warnings.catch_warnings(), reading.quietly():
        warnings.simplefilter("error")
        values, tags, profile = form.read(data)
        orientation = tags.get(0x0112, 1)
        if orientation not in _TURNS:
            raise ValueError(f"its EXIF states the orientation {orientation!r}; 1 to 8 have a meaning")
        exif = _exif(tags.get_ifd(0x8769))
    return np.ascontiguousarray(_TURNS[orientation](values)), exif, profile


def _exif(tags: dict[int, Any]) -> Exif:
    def known(tag: int) -> float | None:
        value = tags.get(tag)
        number = math.nan if value is None else float(value)
        return number if 0.0 < number < math.inf else None

    focal, film = known(0x920A), known(0xA405)
    return Exif(focal and 1e-3 * focal, known(0x829D), film and 1e-3 * film)


def write_photo(
    path: str | PathLike[str],
    light: NDArray[Any],
    *,
    encoding: str = "srgb",
    dtype: DTypeLike = np.uint8,
    quality: int = 95,
    profile: bytes | None = None,
) -> float:
    """Write light as a photograph; the suffix chooses PNG, JPEG or TIFF.

    Integers end at black and white, as sensors do; what lies beyond by half a level or more is counted. Floats keep
    all. The file is written under a temporary name and moved into place.

    Parameters
    ----------
    path : path
        .png (uint8, uint16), .jpg (uint8) or .tif (uint8, uint16, float32).
    light : ndarray of float, shape (height, width) or (height, width, 3)
        1 is white.
    encoding : {"srgb", "linear"}, default "srgb"
        Of the values stored.
    dtype : uint8, uint16 or float32, default uint8
    quality : int, default 95
        Of a JPEG, 1 to 100; colours have the full resolution.
    profile : bytes, optional
        An ICC profile to store.

    Returns
    -------
    float
        Share of the values that were clipped.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or the format has no such values.
    OSError
        If the file cannot be written.
    """
    find(path)
    if profile is not None:
        validation.instance("profile", profile, bytes)
    values, clipped = stored(light, encoding, dtype)
    validation.integer("quality", quality, least=1, most=100)
    atomic.write(Path(path), encoded(path, values, quality, profile))
    return clipped


def stored(light: NDArray[Any], encoding: str, dtype: DTypeLike) -> tuple[NDArray[Any], float]:
    """Return light as values of uint8, uint16 or float32 in an encoding, and the share that integers clip."""
    validation.choice("encoding", encoding, ENCODINGS)
    kind = validation.kind("dtype", dtype, np.uint8, np.uint16, np.float32)
    light = validation.array("light", light)
    if light.dtype.kind != "f":
        raise TypeError(f"light must hold floats, got {light.dtype}")
    if light.ndim not in (2, 3) or light.shape[2:] not in ((), (3,)) or 0 in light.shape:
        raise ValueError(f"light must have the shape (height, width) or (height, width, 3), got {light.shape}")
    if not np.all(np.isfinite(light)):
        raise ValueError(f"light must be finite, got {light[~np.isfinite(light)].flat[0]}")
    if kind.kind == "f":
        return from_light(light, encoding, kind), 0.0
    half = 0.5 / np.iinfo(kind).max
    within = np.clip(light, 0.0, 1.0)
    # Half a level of sRGB is less light than of linear values at black, and more at white.
    low, high = (half / 12.92, half * 2.4 / 1.055) if encoding == "srgb" else (half, half)
    clipped = float(np.mean((light < -low) | (light > 1.0 + high)))
    return from_light(within, encoding, kind), clipped


def encoded(path: str | PathLike[str], values: NDArray[Any], quality: int, profile: bytes | None = None) -> bytes:
    """Return the bytes of a photograph in the format of the suffix of `path`."""
    written: bytes = find(path, holding=f"of {values.dtype.name}").write(values, quality, profile)
    return written


def read_images(paths: Sequence[str | PathLike[str]]) -> NDArray[Any]:
    """Read images of one size from TIFF (every page is one), NPY and FITS (one image or a stack) or 16-bit PNG files.

    Parameters
    ----------
    paths : sequence of path
        Of one or several files; their images follow each other.

    Returns
    -------
    ndarray, shape (n, height, width)
        Of the type that is stored, integers or floats.

    Raises
    ------
    PhotoError
        If a file is damaged, of another format, has colours, or its images are of another size or type.
    OSError
        If one cannot be read.
    """
    found: list[NDArray[Any]] = []
    for path in paths:
        source = validation.path("paths", path)
        data = reading.contents(source)
        with told(source, "images", data) as form:
            values = form.read(data)
            if values.ndim == 2:
                values = values[None]
            if values.ndim != 3 or 0 in values.shape or values.dtype.kind not in "iuf":
                raise ValueError(f"it holds {values.dtype} of the shape {values.shape}, no grey images")
        if found and (found[0].shape[1:], found[0].dtype) != (values.shape[1:], values.dtype):
            (_, height, width), (_, other, across) = found[0].shape, values.shape
            raise PhotoError(
                f"{validation.line(source)} has images of {other} x {across} {values.dtype}, those before are of "
                f"{height} x {width} {found[0].dtype}"
            )
        found.append(values)
    if not found:
        raise ValueError("paths must name a file or several, got none")
    return np.concatenate(found)


def _npy(data: bytes) -> NDArray[Any]:
    return reading.npy(data, reading.MAX_PIXELS)[0]


def _png(data: bytes) -> NDArray[Any]:
    return photo_formats.read_png(data)[0]


def _fits(data: bytes) -> NDArray[Any]:
    return fits_images.read(data, reading.MAX_PIXELS)[0].values


def _tiff(data: bytes) -> NDArray[Any]:
    with reading.tiff(data) as file:
        pages = [page for page in list[Any](file.pages) if not page.is_reduced]
        if wrong := [page.axes for page in pages if page.axes not in ("YX", "SYX")]:
            raise ValueError(f"a page has the axes {wrong[0]}, which is no grey image")
        # Three images that were written without a word are planes of one page.
        images = [page.asarray().reshape(-1, *page.shape[-2:]) for page in pages]
    if len({image.shape[1:] for image in images}) > 1:
        raise ValueError("its pages are of several sizes")
    values = np.concatenate(images)
    return values.astype(values.dtype.newbyteorder("="), copy=False)


registry.register(
    Format("images", (".npy",), read=_npy, starts=(b"\x93NUMPY",)),
    Format("images", (".tif", ".tiff"), read=_tiff, starts=TIFF, library="tifffile", extra="images"),
    Format("images", (".png",), read=_png, starts=PNG, library="PIL.Image", extra="images"),
    Format("images", fits_images.SUFFIXES, read=_fits, starts=(b"SIMPLE  =",), library="astropy", extra="fits"),
)
