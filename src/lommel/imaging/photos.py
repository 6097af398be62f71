"""Photographs from files: PNG, JPEG and TIFF, as light, with what EXIF knows of the lens."""

from __future__ import annotations

import io
import math
import warnings
from dataclasses import dataclass
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base import optional, reading, validation
from lommel.base.encoding import ENCODINGS, to_light

_SIGNATURES = {
    b"\x89PNG\r\n\x1a\n": "PNG",
    b"\xff\xd8\xff": "JPEG",
    b"II*\0": "TIFF",
    b"MM\0*": "TIFF",
    b"II+\0": "TIFF",
    b"MM\0+": "TIFF",
}
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
        If the file is damaged, of another format, animated, has more than 16384^2 pixels, or has alpha, a colour
        space but grey and RGB, or values but uint8, uint16 and floats.
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
    """Return the upright values of a PNG, JPEG or TIFF file, its EXIF and its ICC profile; see :func:`read_photo`."""
    source = validation.path("path", path)
    data = reading.contents(source)
    kind = next((name for start, name in _SIGNATURES.items() if data.startswith(start)), None)
    if kind is None:
        raise PhotoError(f"{validation.line(source)} is {'not a PNG, JPEG or TIFF file' if data else 'empty'}")
    try:
        # What Pillow warns of are damaged parts that it leaves out.
        with warnings.catch_warnings(), reading.quietly():
            warnings.simplefilter("error")
            values, tags, profile = _read_tiff(data) if kind == "TIFF" else _read_png_or_jpeg(data, kind)
            orientation = tags.get(0x0112, 1)
            if orientation not in _TURNS:
                raise ValueError(f"its EXIF states the orientation {orientation!r}; 1 to 8 have a meaning")
            exif = _exif(tags.get_ifd(0x8769))
    except ImportError:
        raise
    except Exception as error:
        raise PhotoError(
            f"{validation.line(source)} cannot be read as a {kind} photograph: {reading.reason(error)}"
        ) from error
    return np.ascontiguousarray(_TURNS[orientation](values)), exif, profile


def _read_png_or_jpeg(data: bytes, kind: str) -> tuple[NDArray[Any], Any, bytes | None]:
    # Opened as what it is: Pillow's limit on the size of pictures from strangers is not for one's own.
    module = library("PIL.PngImagePlugin" if kind == "PNG" else "PIL.JpegImagePlugin")
    opener = module.PngImageFile if kind == "PNG" else module.JpegImageFile

    def load(rawmode: str | None = None) -> NDArray[Any]:
        with opener(io.BytesIO(data)) as again:
            if rawmode is not None:
                again.tile = [(*again.tile[0][:3], rawmode)]
            again.load()
            return np.asarray(again.convert(plain) if (plain := {"P": "RGB", "1": "L"}.get(again.mode)) else again)

    with opener(io.BytesIO(data)) as file:
        reading.pixels(*file.size)
        if getattr(file, "is_animated", False):
            raise ValueError(f"it is an animation of {file.n_frames} frames")
        if "A" in file.mode or "transparency" in file.info:
            raise ValueError("it has alpha; flatten it first")
        if file.mode not in ("1", "L", "P", "RGB", "I", "I;16"):
            raise ValueError(f"its colours are {file.mode}, neither grey nor RGB")
        deep, grey, mode = kind == "PNG" and data[24] == 16, file.mode != "RGB", file.tile[0][3]
        # That of a PNG may stand behind the image, and is looked for there.
        tags, profile = file.getexif(), file.info.get("icc_profile")
    if not deep:
        return load(), tags, profile
    if grey:
        return load().astype(np.uint16), tags, profile
    if mode != "RGB;16B":
        raise ValueError(f"this Pillow reads 16-bit colour as {mode}; save it as TIFF")
    # Pillow keeps the high bytes of 16-bit colour; read as if bytes were swapped, the low ones.
    return load().astype(np.uint16) << 8 | load("RGB;16L"), tags, profile


def _read_tiff(data: bytes) -> tuple[NDArray[Any], Any, bytes | None]:
    tifffile = library("tifffile")
    reading.tiff(data)
    with tifffile.TiffFile(io.BytesIO(data)) as file:
        pages = [page for page in file.pages if not page.is_reduced]
        if len(pages) != 1:
            raise ValueError(f"it has {len(pages)} pages; give a file of one")
        page = pages[0]
        if page.extrasamples:
            raise ValueError("it has alpha or other further channels; flatten it first")
        if page.photometric not in (tifffile.PHOTOMETRIC.MINISBLACK, tifffile.PHOTOMETRIC.RGB):
            raise ValueError(f"its colours are {page.photometric.name}, neither grey nor RGB")
        values, axes, profile = page.asarray(), page.axes, page.iccprofile
    if values.shape != page.shape:
        raise ValueError(
            f"its values are of an unknown kind, {page.bitspersample} bits of the format {page.sampleformat}"
        )
    if axes == "SYX":
        values = np.moveaxis(values, 0, 2)
    elif axes not in ("YX", "YXS"):
        raise ValueError(f"its axes are {axes}, neither YX nor YXS")
    if values.dtype not in (np.uint8, np.uint16) and values.dtype.kind != "f":
        raise ValueError(f"it holds {values.dtype}, neither uint8, uint16 nor floats")
    tags = library("PIL.Image").Exif()
    if data[2:4] in (b"*\0", b"\0*"):  # Pillow knows those of at most 4 GB
        tags.load(data)
    return values.astype(values.dtype.newbyteorder("="), copy=False), tags, profile


def _exif(tags: dict[int, Any]) -> Exif:
    def known(tag: int) -> float | None:
        value = tags.get(tag)
        number = math.nan if value is None else float(value)
        return number if 0.0 < number < math.inf else None

    focal, film = known(0x920A), known(0xA405)
    return Exif(focal and 1e-3 * focal, known(0x829D), film and 1e-3 * film)


def library(name: str) -> Any:
    """Return an optional library for images."""
    return optional.library(name, "photographs need", "images")
