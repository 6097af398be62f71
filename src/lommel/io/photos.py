"""Files of photographs with the lens data of their EXIF, of depth maps in metres, and focus pulls."""

from __future__ import annotations

import errno
import math
import os
import re
import struct
import warnings
import zlib
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import atomic, reading, validation
from lommel.base.arrays import Array
from lommel.base.encoding import ENCODINGS, from_light, to_light
from lommel.base.optional import version
from lommel.io import exr_files, registry
from lommel.io.registry import Description, Format, Values

PNG, JPEG, TIFF = (b"\x89PNG\r\n\x1a\n",), (b"\xff\xd8\xff",), (b"II*\0", b"MM\0*", b"II+\0", b"MM\0+")
"""The first bytes of files."""

_RAW = (b"FUJIFILMCCD-RAW", b"IIRO", b"IIRS", b"MMOR", b"IIU\0", b"FOVb", b"\0MRM")
_RAW_SUFFIXES = (
    *(".3fr", ".arw", ".cr2", ".cr3", ".crw", ".dcr", ".dng", ".erf", ".fff", ".iiq", ".kdc", ".mef", ".mos", ".mrw"),
    *(".nef", ".nrw", ".orf", ".pef", ".raf", ".rw2", ".rwl", ".sr2", ".srf", ".srw", ".x3f"),
)

_FILM_DIAGONAL = math.hypot(36e-3, 24e-3)
# EXIF's Orientation, from 1 on: steps along the stored rows and columns, and whether these are then exchanged.
_TURNS = ((1, 1, 0), (1, -1, 0), (-1, -1, 0), (-1, 1, 0), (1, 1, 1), (-1, 1, 1), (-1, -1, 1), (1, -1, 1))

_PFM = re.compile(rb"(P[fF])\s+(\d{1,9})\s+(\d{1,9})\s+([+-]?[0-9.]+(?:[eE][+-]?\d+)?)\s")


class PhotoError(ValueError):
    """A file that cannot be read as a photograph or a depth map; the message names it and says why."""


@dataclass(frozen=True)
class Exif:
    """Lens data in the EXIF of a photograph; None for unknown, which EXIF writes as 0.

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
            If `shape` is not the shape of an image.
        ValueError
            If either focal length is unknown, or a side is out of range.
        """
        if not isinstance(shape, tuple | list) or len(shape) < 2:
            raise TypeError(f"shape must be (height, width), got {validation.shown(shape)}")
        validation.image_shape(tuple(shape[:2]))
        if self.focal_length is None or self.film_focal_length is None:
            raise ValueError("the EXIF does not state a focal length and its 35 mm equivalent; give the pixel pitch")
        return _FILM_DIAGONAL * self.focal_length / self.film_focal_length / math.hypot(*shape[:2])


_FIRST = 16  # bytes that tell the kind of a file
_SAMPLE = 2**17  # bytes that say how to compress the others


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
        ICC profile, passed on without interpretation.
    """

    values: Values
    encoding: str
    exif: Exif
    profile: bytes | None = None

    def light(self, dtype: DTypeLike = np.float32) -> Values:
        """Return linear light, 1 being white.

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
            If `dtype` is another type.
        """
        return to_light("the photograph", self.values, self.encoding, dtype)


def read_photo(path: str | PathLike[str], encoding: str | None = None) -> Picture:
    """Read a PNG, JPEG, TIFF or EXR photograph, recognized by its content, and rotate it as its EXIF says.

    Parameters
    ----------
    path : path
    encoding : {"srgb", "linear"}, optional
        Encoding of the stored values; by default integers are sRGB and floats are linear.

    Returns
    -------
    Picture
        With 8 or 16 bits, or floats (TIFF, EXR).

    Raises
    ------
    PhotoError
        If the file is damaged, of another format, a raw photograph, animated, has more than 16384^2 pixels or a side
        of more than 65536, takes 256 MB of memory and a hundred times its size, or has alpha, a colour space but grey
        and RGB, or values but uint8, uint16 and floats.
    ImportError
        If Pillow, tifffile or OpenEXR is not installed.
    OSError
        If it cannot be read.
    """
    if encoding is not None:
        validation.choice("encoding", encoding, ENCODINGS)
    values, exif, profile = read_raster(path)
    return Picture(values, encoding or ("linear" if values.dtype.kind == "f" else "srgb"), exif, profile)


def read_raster(path: str | PathLike[str]) -> tuple[Values, Exif, bytes | None]:
    """Return the upright values of a photograph, its EXIF and its ICC profile; see :func:`read_photo`."""
    source = validation.path("path", path)
    data = reading.contents(source)
    with told(source, "photo", data) as form:
        return upright(form, data)


@contextmanager
def told(source: Path, kind: str, data: bytes) -> Iterator[Format]:
    """Yield the format of the contents of a file; PhotoError if it is unknown or if reading it fails."""
    require_developed(source, data)
    try:
        form = registry.identify(kind, data)
    except ValueError as error:
        raise PhotoError(f"{validation.line(source)} {error}") from None
    what = f"a {form.name} photograph" if kind == "photo" else f"a {kind}"
    try:
        yield form
    except ImportError:
        raise
    except Exception as error:
        raise PhotoError(f"{validation.line(source)} cannot be read as {what}: {reading.reason(error)}") from error


def require_developed(source: Path, data: bytes) -> None:
    """Raise PhotoError for a raw photograph, by its name and its contents, of which the first bytes are enough."""
    if _is_raw(source, data):
        raise PhotoError(
            f"{validation.line(source)} is a raw photograph, of which only a preview could be read. Develop it, "
            "for example by rawpy.imread(path).postprocess(gamma=(1, 1), no_auto_bright=True, output_bps=16), and "
            "save it as TIFF"
        )


def _is_raw(source: Path, data: bytes) -> bool:
    if source.suffix.lower() in _RAW_SUFFIXES or data.startswith(_RAW) or data[4:12] == b"ftypcrx ":
        return True
    try:
        return data.startswith(TIFF) and reading.is_raw(data if len(data) > _FIRST else source)
    except ValueError:
        return False  # damaged, which is reported when it is read


def upright(form: Format, data: bytes) -> tuple[Values, Exif, bytes | None]:
    """Return the values, rotated as the EXIF says; a warning of Pillow, that parts are missing, is an error."""
    with warnings.catch_warnings(), reading.quietly():
        warnings.simplefilter("error")
        values, tags, profile = form.read(data)
        orientation = tags.get(0x0112, 1)
        if orientation not in range(1, 9):
            raise ValueError(f"its EXIF states the orientation {orientation!r}; 1 to 8 have a meaning")
        down, across, exchanged = _TURNS[int(orientation) - 1]
        values = values[::down, ::across].swapaxes(0, exchanged)
        exif = _exif(tags.get_ifd(0x8769))
    return np.ascontiguousarray(values), exif, profile


def _exif(tags: dict[int, Any]) -> Exif:
    def known(tag: int) -> float | None:
        value = tags.get(tag)
        number = math.nan if value is None else float(value)
        return number if 0.0 < number < math.inf else None

    focal, film = known(0x920A), known(0xA405)
    return Exif(focal and 1e-3 * focal, known(0x829D), film and 1e-3 * film)


def write_photo(
    path: str | PathLike[str],
    light: Values,
    *,
    encoding: str = "srgb",
    dtype: DTypeLike = np.uint8,
    quality: int = 95,
    profile: bytes | None = None,
) -> float:
    """Write light as a photograph; the suffix chooses PNG, JPEG, TIFF or EXR.

    Integers are clipped at black and white, as on a sensor; floats are not. The file is written under a temporary
    name and moved into place.

    Parameters
    ----------
    path : path
        .png (uint8, uint16), .jpg (uint8), .tif (uint8, uint16, float32) or .exr (float32, without profile).
    light : ndarray of float, shape (height, width) or (height, width, 3)
        1 is white.
    encoding : {"srgb", "linear"}, default "srgb"
        Encoding of the stored values.
    dtype : uint8, uint16 or float32, default uint8
    quality : int, default 95
        Quality of a JPEG, 1 to 100; there is no chroma subsampling.
    profile : bytes, optional
        An ICC profile to store.

    Returns
    -------
    float
        Fraction of the values that are clipped by half a level or more.

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


def stored(light: Values, encoding: str, dtype: DTypeLike) -> tuple[Values, float]:
    """Return light as values of uint8, uint16 or float32 in an encoding, and the fraction that is clipped."""
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
    # Half a level of sRGB is less light at black than at white.
    low, high = (half / 12.92, half * 2.4 / 1.055) if encoding == "srgb" else (half, half)
    clipped = float(np.mean((light < -low) | (light > 1.0 + high)))
    return from_light(within, encoding, kind), clipped


def encoded(path: str | PathLike[str], values: Values, quality: int, profile: bytes | None = None) -> bytes:
    """Return the bytes of a photograph in the format of the suffix of `path`."""
    written: bytes = find(path, holding=f"of {values.dtype.name}").write(values, quality, profile)
    return written


_BAND = 2**20  # pixels that are converted to an array at once


def _read(opener: Callable[[bytes], Any], data: bytes) -> tuple[Values, Any, bytes | None]:
    """Return the values, the tags and the ICC profile of a file of Pillow, with all 16 bits of a PNG."""
    with opener(data) as file:
        if getattr(file, "is_animated", False):
            raise ValueError(f"it is an animation of {file.n_frames} frames")
        if "A" in file.mode or "transparency" in file.info:
            raise ValueError("it has alpha; flatten it first")
        if file.mode not in ("1", "L", "P", "RGB", "I", "I;16"):
            raise ValueError(f"its colours are {file.mode}, neither grey nor RGB")
        deep, grey, mode = file.format == "PNG" and data[24] == 16, file.mode != "RGB", file.tile[0][3]
        # The tags of a PNG may stand behind the image.
        tags, profile = file.getexif(), file.info.get("icc_profile")
        values = _array(file)
    if not deep:
        return values, tags, profile
    if grey:
        return values.astype(np.uint16, copy=False), tags, profile
    if mode != "RGB;16B":
        raise ValueError(f"this Pillow reads 16-bit colour as {mode}; save it as TIFF")
    del file  # to save memory
    # Pillow keeps the high bytes of 16-bit colour; read as if bytes were swapped, the low ones.
    values = values.astype(np.uint16)
    values <<= 8
    with opener(data) as again:
        again.tile = [(*again.tile[0][:3], "RGB;16L")]
        values |= _array(again)
    return values, tags, profile


def _array(image: Any) -> Values:
    """Return the values of an image of Pillow, band by band, since Pillow makes two copies."""
    width, height = image.size
    step, plain = max(1, _BAND // width), {"P": "RGB", "1": "L"}.get(image.mode)
    made: Values | None = None
    for top in range(0, height, step):
        part = image.crop((0, top, width, min(top + step, height)))
        band = np.asarray(part.convert(plain) if plain else part)
        if made is None:
            made = np.empty((height, *band.shape[1:]), band.dtype)
        made[top : top + step] = band
    assert made is not None
    return made


def read_tiff(data: bytes, *, levels: bool = False) -> tuple[Values, Any, bytes | None]:
    """Return the values, the tags and the ICC profile of a TIFF file of one page, `levels` of any integers."""
    import tifffile
    from PIL import Image

    with reading.tiff(data) as file:
        pages = [page for page in list[Any](file.pages) if not page.is_reduced]
        if len(pages) != 1:
            raise ValueError(f"it has {len(pages)} pages; give a file of one")
        page = pages[0]
        if page.extrasamples:
            raise ValueError("it has alpha or other further channels; flatten it first")
        if page.photometric not in (tifffile.PHOTOMETRIC.MINISBLACK, tifffile.PHOTOMETRIC.RGB):
            raise ValueError(f"its colours are {page.photometric.name}, neither grey nor RGB")
        values, axes, profile = reading.tiff_array(page), page.axes, page.iccprofile
    if values.shape != page.shape:
        raise ValueError(
            f"its values are of an unknown kind, {page.bitspersample} bits of the format {page.sampleformat}"
        )
    if axes == "SYX":
        values = np.moveaxis(values, 0, 2)
    elif axes not in ("YX", "YXS"):
        raise ValueError(f"its axes are {axes}, neither YX nor YXS")
    if values.dtype not in (np.uint8, np.uint16) and values.dtype.kind not in ("iuf" if levels else "f"):
        raise ValueError(f"it holds {values.dtype}, neither uint8, uint16 nor floats")
    tags = Image.Exif()
    if data[2:4] in (b"*\0", b"\0*"):  # not BigTIFF, which Pillow does not read
        tags.load(data)
    return values.astype(values.dtype.newbyteorder("="), copy=False), tags, profile


def write_png(values: Values, _quality: int, profile: bytes | None) -> bytes:
    """Return a PNG file, uncompressed where it would else exceed the limits of :mod:`lommel.base.reading`."""
    bits = 8 * values.dtype.itemsize
    takes = reading.png_takes(values.shape[0] * values.shape[1], bits, values.ndim == 3)
    for level in (6, 0):
        if bits == 16:
            made = png_of_16_bits(values, profile, level)
        else:
            made = _by_pillow("png", values, profile, compress_level=level)
        if reading.affords(takes, len(made)):
            break
    return made


def _write_jpeg(values: Values, quality: int, profile: bytes | None) -> bytes:
    return _by_pillow("jpeg", values, profile, quality=quality, subsampling=0)


def write_tiff(values: Values, _quality: int, profile: bytes | None) -> bytes:
    """Return a TIFF file, lossless."""
    import tifffile

    options = {"photometric": "rgb" if values.ndim == 3 else "minisblack", "software": f"lommel {version()}"}
    return atomic.contents(tifffile.imwrite, values, iccprofile=profile, metadata=None, **options)


def _by_pillow(form: str, values: Values, profile: bytes | None, **options: int) -> bytes:
    from PIL import Image

    return atomic.contents(Image.fromarray(values).save, form, icc_profile=profile, **options)


def png_of_16_bits(values: NDArray[np.uint16], profile: bytes | None, level: int) -> bytes:
    """Return a 16-bit PNG, which Pillow writes for grey only, with each row as the difference from the one above."""
    height, width = values.shape[:2]
    rows = values.astype(">u2").view(np.uint8).reshape(height, -1)
    lines = np.full((height, 1 + rows.shape[1]), 2, dtype=np.uint8)
    lines[0, 1:] = rows[0]
    np.subtract(rows[1:], rows[:-1], out=lines[1:, 1:])
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", width, height, 16, 2 if values.ndim == 3 else 0, 0, 0, 0))]
    if profile is not None:
        chunks.append((b"iCCP", b"ICC Profile\0\0" + zlib.compress(profile)))
    packed = _packed(lines.tobytes(), level)
    chunks += [(b"IDAT", packed), (b"IEND", b"")]
    parts = [struct.pack(">I", len(d)) + name + d + struct.pack(">I", zlib.crc32(name + d)) for name, d in chunks]
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


def _packed(data: bytes, level: int) -> bytes:
    """Return data compressed, at level 1 without a search for strings where a sample, as of noise, has none."""
    part = data[len(data) // 2 :][:_SAMPLE]

    def pressed(what: bytes, strategy: int) -> bytes:
        found = zlib.compressobj(level, strategy=strategy)
        return found.compress(what) + found.flush()

    plain = level != 1 or len(pressed(part, zlib.Z_DEFAULT_STRATEGY)) < len(pressed(part, zlib.Z_RLE))
    return pressed(data, zlib.Z_DEFAULT_STRATEGY if plain else zlib.Z_RLE)


def read_depth(
    path: str | PathLike[str],
    *,
    scale: float | None = None,
    zero_is_unknown: bool = False,
    unknown: Sequence[float] = (),
) -> Array:
    """Read a depth map: the distance of every point from the lens, NaN where it is unknown.

    Parameters
    ----------
    path : path
        NPY, PFM, or a grey TIFF, PNG or EXR (its channel Z, or the only one), recognized by its content.
    scale : float, optional
        Metres per level of integers, which need it; floats are metres without it. A PFM file whose header states a
        scale other than 1 needs it too, since programs disagree on its meaning.
    zero_is_unknown : bool, default False
        Whether 0 means unknown.
    unknown : sequence of float, optional
        Other stored values that mean unknown, such as (-1, 255), before they are scaled.

    Returns
    -------
    ndarray, shape (height, width)
        Metres; may hold infinity and NaN.

    Raises
    ------
    PhotoError
        If the file is damaged, of another format, has several channels, or has levels and no `scale` is given.
    ValueError
        If it holds a distance that is not positive, or 0 without `zero_is_unknown`.
    OSError
        If it cannot be read.
    """
    source = validation.path("path", path)
    marks = validation.real_array("unknown", unknown)
    factor = 1.0 if scale is None else validation.real("scale", scale, above=0.0, unit="metres per level")
    data = reading.contents(source)
    name = validation.line(source)
    if data.startswith(JPEG):
        raise PhotoError(f"{name} is a JPEG, which does not preserve depth; save it as TIFF or 16-bit PNG")
    with told(source, "depth map", data) as form:
        values = form.read(data, scale)
    del data  # to save memory
    if values.ndim != 2 or 0 in values.shape:
        raise PhotoError(f"{name} has the shape {values.shape}; a depth map has (height, width)")
    if values.dtype.kind not in "iuf":
        raise PhotoError(f"{name} holds {values.dtype}; a depth map holds numbers")
    if values.dtype.kind != "f" and scale is None:
        raise PhotoError(f"{name} is an integer image; give the scale, e.g. scale=0.001 for millimetres")
    with np.errstate(over="ignore", invalid="ignore"):  # of a NaN that signals
        metres: Array = values.astype(np.float64)
        metres *= factor
    zeros = values.size - np.count_nonzero(values)
    if zeros and not zero_is_unknown:
        raise ValueError(
            f"{name} is 0 at {zeros} of {values.size} points; if that means unknown, give `zero_is_unknown`"
        )
    if zeros:
        metres[values == 0] = np.nan
    metres[np.isin(values, marks)] = np.nan
    if (least := np.fmin.reduce(metres, axis=None)) < 0.0:
        stored = np.fmin.reduce(values, axis=None)
        raise ValueError(
            f"{name} must hold distances > 0 metres, got {least:g}; if the value {stored:g} means unknown, state it "
            "as `unknown`"
        )
    return metres


def write_depth(path: str | PathLike[str], depth: ArrayLike) -> None:
    """Write a depth map, or its standard deviation, in single precision, for :func:`lommel.imaging.read_depth`.

    The file is written under a temporary name and moved into place.

    Parameters
    ----------
    path : path
        .tif, .npy, .pfm or .exr.
    depth : array_like, shape (height, width)
        Metres; NaN where it is not known, may be infinite.

    Raises
    ------
    TypeError, ValueError
        If `depth` is not a map of this shape or holds negative values, or `path` has another suffix.
    OSError
        If the file cannot be written.
    """
    target = validation.path("path", path)
    write = find_depth(target).write
    metres = validation.array("depth", depth)
    if metres.dtype.kind not in "iuf" or metres.ndim != 2 or 0 in metres.shape:
        raise ValueError(f"depth must be numbers of the shape (height, width), got {metres.dtype} {metres.shape}")
    if np.any(metres < 0.0):
        raise ValueError(f"depth must be >= 0 metres, got {metres[metres < 0.0].flat[0]:g}")
    with np.errstate(over="ignore"):
        data: bytes = write(np.asarray(metres, dtype=np.float32))
    atomic.write(target, data)


def _pfm(data: bytes, scale: float | None) -> Values:
    """Return the values of a portable float map: rows run upwards, a negative scale means little-endian."""
    found = _PFM.match(data)
    if not found:
        raise ValueError("its header is not that of a PFM file")
    if found[1] != b"Pf":
        raise ValueError("it is in colour")
    width, height, unit = int(found[2]), int(found[3]), float(found[4])
    reading.pixels(width, height)
    if unit == 0.0 or (abs(unit) != 1.0 and scale is None):
        raise ValueError(f"its header states the scale {unit:g}; give `scale`, the metres per unit")
    body = data[found.end() :]
    if len(body) != 4 * width * height:
        raise ValueError(f"{width} x {height} values take {4 * width * height} bytes, got {len(body)}")
    return np.frombuffer(body, dtype="<f4" if unit < 0.0 else ">f4").reshape(height, width)[::-1]


def _npy(data: bytes, _scale: float | None) -> Values:
    return reading.npy(data, reading.MAX_PIXELS)[0]


def _raster(data: bytes, _scale: float | None) -> Values:
    form = registry.identify("photo", data)
    return upright(replace(form, read=partial(read_tiff, levels=True)) if form.read is read_tiff else form, data)[0]


def _write_pfm(values: NDArray[np.float32]) -> bytes:
    height, width = values.shape
    return f"Pf\n{width} {height}\n-1.0\n".encode() + values[::-1].astype("<f4").tobytes()


read_png, _8, _16 = partial(_read, reading.png), "of uint8", "of uint16"
_photo, _depth = (partial(Format, kind) for kind in ("photo", "depth map"))
registry.register(
    _photo((".png",), write_png, read_png, PNG, (_8, _16), library="PIL.Image"),
    _photo((".jpg", ".jpeg"), _write_jpeg, partial(_read, reading.jpeg), JPEG, (_8,), library="PIL.Image"),
    _photo((".tif", ".tiff"), write_tiff, read_tiff, TIFF, (_8, _16, "of float32"), library="tifffile"),
    _photo(
        (".exr",), exr_files.write_photo, exr_files.read_photo, exr_files.START, ("of float32",), library="OpenEXR"
    ),
    _depth((".npy",), partial(atomic.contents, np.save), _npy, (b"\x93NUMPY",)),
    _depth((".pfm",), _write_pfm, _pfm, (b"Pf", b"PF")),
    _depth((".tif", ".tiff"), partial(write_tiff, _quality=100, profile=None), _raster, TIFF, library="tifffile"),
    _depth((".png",), read=_raster, starts=PNG),
    _depth((".exr",), exr_files.write_depth, exr_files.read_depth, exr_files.START, library="OpenEXR"),
)
find, find_depth = partial(registry.find, "photo"), partial(registry.find, "depth map")

_NUMBER = re.compile(r"%0?\d?d")


def check_pattern(path: str | PathLike[str], name: str = "path") -> Path:
    """Return a path that frames can be written to, with one number such as ``%03d`` or none."""
    target = validation.path("path", path)
    numbers = _NUMBER.findall(target.name)
    if len(numbers) != target.name.count("%") or len(numbers) > 1 or "%" in str(target.parent):
        raise ValueError(
            f"{name} may have one number such as %03d in its last part and no other %, "
            f"got {validation.shown(str(path))}"
        )
    if numbers:
        find(target, name)
        return target
    try:
        registry.find("frames", target, name)
    except ValueError as error:
        raise ValueError(f"{error}; a number such as %03d makes a photograph of each") from None
    return target


def is_animation(path: str | PathLike[str]) -> bool:
    """Return whether frames are written to one animation, which has 8 bits."""
    target = validation.path("path", path)
    return not _NUMBER.search(target.name) and registry.find("frames", target).holds == (_8,)


def write_frames(
    path: str | PathLike[str],
    frames: Iterable[Values],
    *,
    fps: float = 12.0,
    quality: int = 95,
) -> list[Path]:
    """Write frames and return the files written; a failure leaves no file.

    Parameters
    ----------
    path : path
        With a number such as ``%03d``: one photograph per frame, counted from 1. Without: an 8-bit animation, .gif
        (256 colours per frame), .png or .apng (lossless) or .webp; or a TIFF stack.
    frames : iterable of ndarray
        Stored values of each frame, all of one shape and type.
    fps : float, default 12
        Frames per second of an animation, which repeats forever.
    quality : int, default 95
        Quality of JPEG and WebP, 1 to 100.

    Returns
    -------
    list of path

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, there are no frames, or they differ in shape or type.
    OSError
        If a file cannot be written.
    """
    target = check_pattern(path)
    duration = 1000.0 / validation.real("fps", fps, least=1e-3, below=1000.0)
    validation.integer("quality", quality, least=1, most=100)
    if not _NUMBER.search(target.name):
        kept = list(_alike(frames))
        form = registry.find("frames", target, holding=f"of {kept[0].dtype.name}")
        atomic.write(target, form.write(kept, duration, quality))
        return [target]
    if not target.parent.is_dir():  # before the first frame is made
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(target))
    made = []
    with atomic.together() as put:
        for number, frame in enumerate(_alike(frames), 1):
            made.append(target.with_name(target.name % number))
            put(made[-1], encoded(target, frame, quality))
    return made


def _alike(frames: Iterable[Values]) -> Iterable[Values]:
    first = None
    if not isinstance(frames, Iterable) or getattr(frames, "ndim", 1) == 0 or np.ma.is_masked(frames):
        raise TypeError(f"frames must be arrays, got {validation.shown(frames)}")
    for frame in frames:
        if not isinstance(frame, np.ndarray) or frame.ndim not in (2, 3):
            raise TypeError(
                f"frames must be arrays of shape (height, width) or with 3 channels, got {validation.shown(frame)}"
            )
        first = frame if first is None else first
        if (frame.shape, frame.dtype) != (first.shape, first.dtype):
            raise ValueError(f"frames must be alike, got {first.shape} {first.dtype} and {frame.shape} {frame.dtype}")
        yield frame
    if first is None:
        raise ValueError("there must be at least one frame")


def _stack(frames: list[Values], _duration: float, _quality: int) -> bytes:
    import tifffile

    photometric = "rgb" if frames[0].ndim == 3 else "minisblack"
    return atomic.contents(tifffile.imwrite, np.stack(frames), photometric=photometric, metadata=None)


def _animation(form: str, frames: list[Values], duration: float, quality: int) -> bytes:
    from PIL import Image, features

    if form == "webp" and not features.check("webp"):
        raise ImportError("this Pillow has no WebP; write .png, .gif or .tif")
    first, *others = map(Image.fromarray, frames)
    options: Description = {"quality": quality} if form == "webp" else {}
    options["duration"] = duration if form == "png" else round(duration)
    return atomic.contents(first.save, form, save_all=True, append_images=others, loop=0, **options)


_DEEP = ("of uint16", "of float32", "of float64")
_animated = partial(Format, "frames", library="PIL.Image", holds=(_8,))
registry.register(
    _animated((".gif",), partial(_animation, "gif"), what="256 colours per frame"),
    _animated((".png", ".apng"), partial(_animation, "png")),
    _animated((".webp",), partial(_animation, "webp")),
    Format("frames", (".tif", ".tiff"), _stack, library="tifffile", holds=(_8, *_DEEP)),
)
