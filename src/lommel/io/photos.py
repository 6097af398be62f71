"""Read and write photographs with their EXIF, and the file formats of depth maps."""

from __future__ import annotations

import io
import math
import re
import struct
import warnings
import zlib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, redirect_stdout
from dataclasses import dataclass, field, replace
from functools import partial
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.base import atomic, reading, validation
from lommel.base.arrays import Values
from lommel.base.encoding import Encoding, ToneCurves, agree, checked, from_light, named, scene_light
from lommel.base.optional import library, version
from lommel.io import icc, registry
from lommel.io.registry import Format

if TYPE_CHECKING:
    from PIL.Image import Exif as Tags
    from PIL.Image import Image

PREFIX = b"Exif\0\0"
"""Marker bytes before the EXIF block in a JPEG file."""

Entry = tuple[int, int, bytes]  # type, number of values, and values as little-endian bytes
Directory = dict[int, Entry]

_TYPE_BYTES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 6: 1, 7: 1, 8: 2, 9: 4, 10: 8, 11: 4, 12: 8, 129: 1}  # bytes per type
# Types of more than one byte, whose byte order matters.
_WORD_TYPES = {3: "u2", 8: "u2", 12: "u8", **dict.fromkeys((4, 5, 9, 10, 11), "u4")}
_MAX_ENTRY_BYTES, _MAX_ENTRIES, _MAX_EXIF_BYTES = 2**12, 256, 2**16 - 256  # limits of EXIF
EXPOSURE_TAG, _GPS_TAG = 0x8769, 0x8825  # tags of the subdirectories with exposure and GPS data
_SENSOR_UNITS = {2: 25.4e-3, 3: 1e-2, 4: 1e-3, 5: 1e-6}  # metres of values of the tag FocalPlaneResolutionUnit
_SAME_ASPECT = 0.01  # relative difference of the aspect ratios of a picture and of its reduction, by rounding
_GAMMA_TAG, _INTEROPERABILITY_TAG = 0xA500, 0xA005
COLOUR_SPACE_TAG = 0xA001
"""Tag of EXIF whose value 1 states sRGB."""
_COPIED_TAGS = (0x010F, 0x0110, 0x0132, 0x013B, 0x8298)  # make, model, date, artist, copyright
# Tags that are not copied: maker's notes contain offsets into the old file, the other tags describe the old pixels.
_OMITTED_TAGS = {EXPOSURE_TAG: (0x927C, *range(0xA001, 0xA006), 0xA20E, 0xA20F, 0xA210), _GPS_TAG: ()}


@dataclass(frozen=True)
class Exif:
    """Lens data in the EXIF of a photograph; unknown values, which EXIF stores as 0, are None.

    Attributes
    ----------
    focal_length : float or None
        Focal length of the lens, metres.
    f_number : float or None
    block : bytes or None
        EXIF that :func:`lommel.imaging.write_photo` stores: camera, lens, exposure, dates, place, artist and
        copyright, without orientation, thumbnail and maker's notes.
    pixel : float or None
        Pixel pitch on the sensor, metres. If the EXIF has the size of a larger picture of the same aspect ratio, of
        which this one is a reduction, it is the pitch after the reduction.
    focus, zoom : float or None
        Subject distance, metres, and ratio of digital zoom.
    """

    focal_length: float | None = None
    f_number: float | None = None
    block: bytes | None = field(default=None, repr=False, compare=False)
    pixel: float | None = None
    focus: float | None = None
    zoom: float | None = None


def parsed(tags: Mapping[Any, Any], stored: bytes | None, shape: tuple[int, ...]) -> Exif:
    """Return the lens data of a photograph of a `shape` from the `tags` of exposure and from its `stored` EXIF.

    The keys of `tags` are numbers, as of Pillow, or names, as of tifffile, where rational numbers are pairs.
    """

    def positive_value(tag: int, name: str) -> float | None:
        value = tags.get(tag, tags.get(name))
        try:
            number = value[0] / value[1] if isinstance(value, tuple) else float(value)
        except (TypeError, ValueError, ArithmeticError, IndexError):  # None, or damaged
            return None
        return number if 0.0 < number < math.inf else None

    # Millimetres, and pixels per unit, of EXIF 2.32.
    focal, resolution = positive_value(0x920A, "FocalLength"), positive_value(0xA20E, "FocalPlaneXResolution")
    unit = _SENSOR_UNITS.get(tags.get(0xA210, tags.get("FocalPlaneResolutionUnit", 2)), 0.0)
    pixel = (resolution and unit / resolution) or None
    columns, rows = positive_value(0xA002, "PixelXDimension"), positive_value(0xA003, "PixelYDimension")
    if pixel and columns and rows:
        long, short = (end(columns, rows) / end(shape[:2]) for end in (max, min))
        pixel *= long if math.isclose(long, short, rel_tol=_SAME_ASPECT) else 1.0
    number, apex = positive_value(0x829D, "FNumber"), positive_value(0x9202, "ApertureValue")
    number = number or (apex and 2.0 ** (0.5 * apex))
    focus, zoom = positive_value(0x9206, "SubjectDistance"), positive_value(0xA404, "DigitalZoomRatio")
    return Exif(focal and 1e-3 * focal, number, stored and _copy_tags(stored), pixel, focus, zoom)


def optics_of(exif: Exif) -> dict[str, float]:
    """Return the lens data of EXIF as metadata of images."""
    stated = {"focal_length": exif.focal_length, "f_number": exif.f_number, "sensor_pixel": exif.pixel}
    stated |= {"focus": exif.focus, "zoom": exif.zoom}
    return {name: value for name, value in stated.items() if value is not None}


def _copy_tags(stored: bytes) -> bytes | None:
    """Return the tags to copy from EXIF or a TIFF file, as a TIFF file without image; None if there are none."""
    data = stored.removeprefix(PREFIX)
    order = {b"II*\0": "<", b"MM\0*": ">"}.get(data[:4])
    if order is None or len(data) < 8:
        return None
    (offset,) = struct.unpack_from(order + "I", data, 4)
    first = _directory(data, offset, order)
    subdirectories = {
        tag: {name: entry for name, entry in _subdirectory(data, first, tag, order).items() if name not in omitted}
        for tag, omitted in _OMITTED_TAGS.items()
    }
    block = _pack_directories({tag: first[tag] for tag in _COPIED_TAGS if tag in first}, subdirectories, 8)
    return b"II*\0" + struct.pack("<I", 8) + block if 6 < len(block) <= _MAX_EXIF_BYTES else None


def _directory(data: bytes, offset: int, order: str) -> Directory:
    """Return the entries of the directory at position `offset`; damaged and long entries are skipped."""
    entries: Directory = {}
    (count,) = struct.unpack_from(order + "H", data, offset) if offset + 2 <= len(data) else (0,)
    for entry in range(offset + 2, min(offset + 2 + 12 * min(count, _MAX_ENTRIES), len(data) - 11), 12):
        tag, kind, number, value_offset = struct.unpack_from(order + "HHII", data, entry)
        size = number * _TYPE_BYTES.get(kind, 0)
        value_offset = entry + 8 if size <= 4 else value_offset
        if 0 < size <= _MAX_ENTRY_BYTES and value_offset + size <= len(data):
            word = _WORD_TYPES.get(kind, "u1")
            values = np.frombuffer(data[value_offset : value_offset + size], order + word)
            entries[tag] = kind, number, values.astype("<" + word).tobytes()
    return entries


def _subdirectory(data: bytes, first: Directory, tag: int, order: str) -> Directory:
    """Return the subdirectory whose position is the value of a tag of the first directory; {} without the tag."""
    return _directory(data, int.from_bytes(first[tag][2][:4], "little"), order) if tag in first else {}


def _pack_directories(first: Directory, subdirectories: dict[int, Directory], offset: int) -> bytes:
    """Return the bytes of a directory for the position `offset` in a file, followed by its subdirectories."""
    subdirectories = {tag: subdirectory for tag, subdirectory in subdirectories.items() if subdirectory}
    next_offset = offset + len(_pack_entries(first | dict.fromkeys(subdirectories, (4, 1, bytes(4))), offset))
    parts = b""
    for tag, subdirectory in subdirectories.items():
        first = first | {tag: (4, 1, struct.pack("<I", next_offset + len(parts)))}
        parts += _pack_entries(subdirectory, next_offset + len(parts))
    return _pack_entries(first, offset) + parts


def _pack_entries(entries: Directory, offset: int) -> bytes:
    """Return the bytes of a directory for the position `offset` in a file; values of over four bytes follow it."""
    head, long_values = struct.pack("<H", len(entries)), b""
    values_offset = offset + 6 + 12 * len(entries)
    for tag, (kind, number, values) in sorted(entries.items()):
        value_field = values.ljust(4, b"\0")
        if len(values) > 4:
            value_field = struct.pack("<I", values_offset + len(long_values))
            long_values += values + bytes(len(values) % 2)
        head += struct.pack("<HHI", tag, kind, number) + value_field
    return head + bytes(4) + long_values


def in_tiff(file: bytes, block: bytes) -> bytes:
    """Return a little-endian TIFF file of one page with EXIF added: a new directory is appended to the file."""
    (offset,) = struct.unpack_from("<I", file, 4)
    (count,) = struct.unpack_from("<H", file, offset)
    rows = (struct.unpack_from("<HHI4s", file, offset + 2 + 12 * k) for k in range(count))
    entries: Directory = {tag: (kind, number, place) for tag, kind, number, place in rows}
    file += bytes(len(file) % 2)
    first = _directory(block, 8, "<")
    subdirectories = {tag: _subdirectory(block, first, tag, "<") for tag in _OMITTED_TAGS}
    directories = _pack_directories(first | entries, subdirectories, len(file))
    return file[:4] + struct.pack("<I", len(file)) + file[8:] + directories


START = (b"\x76\x2f\x31\x01",)
"""The first bytes of EXR files."""


@contextmanager
def _open_exr(data: bytes) -> Iterator[dict[str, Values]]:
    """Yield the channels of an EXR file by name; ValueError if it has several parts, is deep, or is too large."""
    exr = library("OpenEXR", "EXR files need", "exr")
    with redirect_stdout(io.StringIO()), exr.File(io.BytesIO(data), header_only=True) as file:
        if len(file.parts) != 1:
            raise ValueError(f"it has {len(file.parts)} parts; give a file of one")
        header = dict(file.header())  # a copy, since the library empties the header when it closes the file
    if header.get("type", exr.scanlineimage) not in (exr.scanlineimage, exr.tiledimage):
        raise ValueError("it is a deep image; flatten it first")
    window, display_window = (
        [np.asarray(corner, dtype=np.int64).tolist() for corner in header[name]]
        for name in ("dataWindow", "displayWindow")
    )
    if window != display_window:
        raise ValueError(f"it holds the pixels {window} of {display_window} (corners x, y); save it uncropped")
    (left, top), (right, bottom) = window
    width, height = right - left + 1, bottom - top + 1
    reading.pixels(width, height)
    if any((c.xSampling, c.ySampling) != (1, 1) for c in header["channels"]):
        raise ValueError("some of its channels are subsampled; save it as RGB or grey")
    with redirect_stdout(io.StringIO()) as messages:  # the library prints that it leaves out a damaged part
        file = exr.File(io.BytesIO(data), separate_channels=True)
    with file:
        if not file.parts:
            raise ValueError(f"its pixels are damaged: {messages.getvalue().rpartition(' - ')[2].strip()}")
        yield {name: channel.pixels for name, channel in file.channels().items()}


def read_exr(data: bytes) -> tuple[Values, Tags, bytes | None]:
    """Return (1) the values of an EXR photograph in float32, (2) empty tags, (3) None: EXR has no ICC profile."""
    from PIL import Image

    with _open_exr(data) as channels:
        alpha = channels.pop("A", None)
        if alpha is not None and not (alpha == 1.0).all():
            raise ValueError("it has an alpha channel that is not 1 everywhere; composite it onto a background first")
        names = set(channels) - {"Z"}  # Z is depth and not part of the photograph
        if names == {"R", "G", "B"}:
            values = np.stack([channels[name] for name in "RGB"], axis=-1)
        elif names == {"Y"}:
            values = channels["Y"]
        else:
            raise ValueError(f"its channels are {', '.join(sorted(names))}, neither R, G, B nor Y; save these alone")
    if values.dtype.kind != "f":
        raise ValueError(f"it holds {values.dtype}, not floats")
    return values.astype(np.float32), Image.Exif(), None


def read_depth(data: bytes, _scale: float | None, part: str | None = None) -> Values:
    """Return the channel `part` of an EXR file, else Z (of any layer), else the only one, possibly as R = G = B."""
    with _open_exr(data) as channels:
        names = [name for name in channels if name.split(".")[-1] == "Z"]
        if part is not None:
            names = [
                reading.only(list(channels), [[name] for name in channels], [""] * len(channels), part, "file.exr")
            ]
        if len(names) != 1:
            names = [name for name in channels if name != "A"]
        if set(names) == {"R", "G", "B"} and all(
            np.array_equal(channels[name], channels["R"], equal_nan=True) for name in "GB"
        ):
            names = ["R"]
        if len(names) != 1:
            raise ValueError(
                f"its channels are {', '.join(sorted(channels))}; a depth map has one, or one named Z: name one, as "
                "in file.exr[Y]"
            )
        return np.array(channels[names[0]])


def _exr_bytes(channels: dict[str, Values]) -> bytes:
    exr = library("OpenEXR", "EXR files need", "exr")
    header = {"compression": exr.ZIP_COMPRESSION, "type": exr.scanlineimage, "software": f"lommel {version()}"}
    buffer = io.BytesIO()
    with exr.File(header, {name: np.ascontiguousarray(plane) for name, plane in channels.items()}) as file:
        file.write(buffer)
    return buffer.getvalue()


def write_exr(values: Values, _profile: None = None) -> bytes:
    """Return a photograph as an EXR file, without loss."""
    return _exr_bytes({"RGB" if values.ndim == 3 else "Y": values})


def write_depth(values: Values) -> bytes:
    """Return a depth map as the channel Z of an EXR file."""
    return _exr_bytes({"Z": values})


PNG, JPEG, TIFF = (b"\x89PNG\r\n\x1a\n",), (b"\xff\xd8\xff",), (b"II*\0", b"MM\0*", b"II+\0", b"MM\0+")
"""The first bytes of PNG, JPEG and TIFF files."""

_RAW_STARTS = (b"FUJIFILMCCD-RAW", b"IIRO", b"IIRS", b"MMOR", b"IIU\0", b"FOVb", b"\0MRM")
_RAW_SUFFIXES = (
    *(".3fr", ".arw", ".cr2", ".cr3", ".crw", ".dcr", ".dng", ".erf", ".fff", ".iiq", ".kdc", ".mef", ".mos", ".mrw"),
    *(".nef", ".nrw", ".orf", ".pef", ".raf", ".rw2", ".rwl", ".sr2", ".srf", ".srw", ".x3f"),
)

# For EXIF orientation 1, 2, ...: steps along the stored rows and columns (-1 flips), and 1 to transpose afterwards.
_ORIENTATIONS = ((1, 1, 0), (1, -1, 0), (-1, -1, 0), (-1, 1, 0), (1, 1, 1), (-1, 1, 1), (-1, -1, 1), (1, -1, 1))

_PFM = re.compile(rb"(P[fF])\s+(\d{1,9})\s+(\d{1,9})\s+([+-]?[0-9.]+(?:[eE][+-]?\d+)?)\s")


class PhotoError(ValueError):
    """A file that cannot be read as a photograph or a depth map; the message has the file name and the reason."""


_SIGNATURE_BYTES = 16  # number of bytes at the start of a file that identify its format


@dataclass(frozen=True, eq=False)
class Photograph:
    """Stored values of a photograph, upright.

    Attributes
    ----------
    values : ndarray, shape (height, width) or (height, width, 3)
        Unsigned integers or floats.
    encoding : {"srgb", "linear"}, float or ToneCurves
        Encoding of `values`, for any argument `encoding`. A number states ``light = value ** number``; a ToneCurves
        has the curves of an ICC profile.
    exif : Exif, optional
    profile : bytes or None
        ICC profile that describes `values`: that of the file, or one of its gamma.
    stated : bool
        True if the file or the caller states the encoding, False if it was assumed.
    """

    values: Values
    encoding: Encoding
    exif: Exif = field(default_factory=Exif)
    profile: bytes | None = None
    stated: bool = False

    def light(self) -> Values:
        """Return linear light; 1 is white.

        Returns
        -------
        ndarray of float32
            Light, of the shape of `values`.

        Warns
        -----
        UserWarning
            If a value of the light exceeds 10, ten times white.
        """
        return scene_light("the photograph", self.values, self.encoding, np.float32)


def read_photo(path: str | PathLike[str], encoding: Encoding | None = None) -> Photograph:
    """Read a photograph (PNG, JPEG, TIFF, EXR, BMP, HEIC, raw) and rotate it upright as its EXIF states.

    Raw photographs (DNG, NEF, CR2, CR3, ...) are demosaiced by LibRaw to linear RGB, with the white balance of the
    camera and without automatic brightness.

    Parameters
    ----------
    path : path
        ``file.tif[1]`` selects one of several pages of a TIFF file, from 0.
    encoding : {"srgb", "linear"} or float, optional
        Encoding of the stored values; a number states ``light = value ** number``. By default floats are linear, and
        integers are encoded as the file states by an ICC profile (curves of red, green and blue, or of grey), a gamma
        of PNG (cICP, sRGB, gAMA) or of EXIF, or else sRGB. Curves within 0.0005 of white of sRGB are sRGB.

    Returns
    -------
    Photograph
        Holds uint8, uint16 or, from TIFF and EXR, floats.

    Raises
    ------
    PhotoError
        If the file is damaged, of another format or animated; if it has over 16384^2 pixels or a
        side over 65536; or if it has alpha that is not opaque everywhere, colours other than grey and RGB, or values
        other than uint8, uint16 and floats.
    ImportError
        If Pillow, tifffile, OpenEXR, pillow-heif or rawpy is not installed.
    OSError
        If it cannot be read.

    Warns
    -----
    UserWarning
        If the file states another encoding than `encoding`, or than linear for floats (its profile is left out if
        `encoding` is given), or has an ICC profile of which no use was made, such as one of look-up tables.
    """
    given = None if encoding is None else checked(encoding)
    values, exif, profile, is_srgb = read_raster(path)
    stated: Encoding | None = "srgb" if is_srgb else None
    name, is_float = Path(path).name, values.dtype.kind == "f"
    if profile is not None:
        try:
            stated = icc.encoding_of(profile, grey=values.ndim == 2)
        except ValueError as error:
            taken = named(given or ("linear" if is_float else "srgb"))
            validation.tell(f"{name}: its ICC profile {error}: not applied, and the values were taken as {taken}")
    used: Encoding = given or ("linear" if is_float else stated or "srgb")
    if stated is not None and used != stated and not agree(used, stated):
        advice = "; give their encoding if they are not"
        if given:
            advice = "" if profile is None else ", and its ICC profile was left out"
        validation.tell(f"{name} states values {named(stated)}, but they were taken as {named(used)}{advice}")
        profile = None if given else profile
    return Photograph(values, used, exif, profile, given is not None or stated is not None)


def read_raster(path: str | PathLike[str]) -> tuple[Values, Exif, bytes | None, bool]:
    """Return (1) the upright values of a photograph, (2) its EXIF, (3) its ICC profile, (4) if sRGB is stated."""
    source, part = reading.part_of(validation.path("path", path))
    data = reading.contents(source)
    with recognized(source, "photo", data, part) as form:
        return upright(form, data)


@contextmanager
def recognized(source: Path, kind: str, data: bytes, part: str | None = None) -> Iterator[Format]:
    """Yield the format of the contents of a file; PhotoError if it is unknown or if reading it fails.

    The format reads the page of a TIFF file, or the channel of an EXR depth map, that `part` names.
    """
    raw = is_raw(source, data)
    if raw and kind != "photo":
        raise PhotoError(f"{validation.line(source)} is a raw photograph, not a {kind}")
    try:
        form = _RAW if raw else registry.identify(kind, data)
    except ValueError as error:
        raise PhotoError(f"{validation.line(source)} {error}") from None
    file_kind = f"a {'raw' if raw else form.name} photograph" if kind == "photo" else f"a {kind}"
    with reading.refused_as(PhotoError, source, f"cannot be read as {file_kind}"):
        if part is not None and form.starts != TIFF and (kind, form.starts) != ("depth map", START):
            raise ValueError(f"it holds one image: omit [{part}]")
        yield form if part is None else replace(form, read=partial(form.read, part=part))


def is_raw(source: Path, data: bytes) -> bool:
    """Return True for a raw photograph, from its name and its contents (or first bytes)."""
    if source.suffix.lower() in _RAW_SUFFIXES or data.startswith(_RAW_STARTS) or data[4:12] == b"ftypcrx ":
        return True
    try:
        return data.startswith(TIFF) and reading.is_raw(data if len(data) > _SIGNATURE_BYTES else source)
    except Exception:  # tifffile raises many types
        return False  # a damaged file, which raises an error when it is read


def upright(form: Format, data: bytes) -> tuple[Values, Exif, bytes | None, bool]:
    """Return (1) values rotated upright, (2) EXIF, (3) ICC profile, (4) True if sRGB is stated otherwise.

    A warning of Pillow is raised as an error.
    """
    with warnings.catch_warnings(), reading.quietly():
        warnings.simplefilter("error")
        values, tags, profile, *block = form.read(data)
        orientation = tags.get(0x0112, 1)
        if orientation not in range(1, 9):
            raise ValueError(f"its EXIF states the orientation {orientation!r}; 1 to 8 have a meaning")
        row_step, column_step, transposed = _ORIENTATIONS[int(orientation) - 1]
        values = values[::row_step, ::column_step].swapaxes(0, transposed)
        exposure = tags.get_ifd(EXPOSURE_TAG)
        exif = parsed(exposure, block[0] if block else None, values.shape)
        is_srgb = 1 in (tags.get(COLOUR_SPACE_TAG), exposure.get(COLOUR_SPACE_TAG))
        gamma, colours = float(exposure.get(_GAMMA_TAG, 0.0)), icc.SRGB
        if tags.get_ifd(_INTEROPERABILITY_TAG).get(1) == "R03":  # Adobe RGB, of DCF 2.0
            gamma, colours = 563.0 / 256.0, icc.ADOBE_RGB
        if profile is None and not is_srgb and 0.1 <= gamma <= 10.0:
            profile = icc.profile_of([gamma], grey=values.ndim == 2, colours=colours)
    return np.ascontiguousarray(values), exif, profile, is_srgb


def write_photo(
    path: str | PathLike[str],
    light: Values,
    *,
    encoding: Encoding = "srgb",
    dtype: DTypeLike = np.uint8,
    like: Photograph | None = None,
) -> float:
    """Write light as a photograph; the suffix chooses PNG, JPEG, TIFF or EXR.

    Integers are clipped at black and white, as on a sensor; floats are not. A JPEG has the quality 95 and no chroma
    subsampling. The file is written under a temporary name and moved into place.

    Parameters
    ----------
    path : path
        .png (uint8, uint16), .jpg (uint8), .tif (uint8, uint16, float32) or .exr (float32).
    light : ndarray of float, shape (height, width) or (height, width, 3)
        1 is white.
    encoding : {"srgb", "linear"} or float, default "srgb"
        Encoding of the stored values, as of :func:`read_photo`. Integers that are not sRGB have an ICC profile that
        states it.
    dtype : uint8, uint16 or float32, default uint8
    like : Photograph, optional
        Source photograph, whose EXIF is stored, and its ICC profile if the encoding is the same, since a profile
        describes the stored values. EXR files hold neither.

    Returns
    -------
    float
        Fraction of the values that are clipped by more than half a level.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or the format has no such values.
    OSError
        If the file cannot be written.
    """
    form = find(path)
    validation.optional("like", like, Photograph)
    values, clipped = stored(light, encoding, dtype)
    find(path, holding=f"of {values.dtype.name}")
    profile, block = None, None
    if like is not None and _EXIF in form.holds:
        profile, block = like.profile if encoding == like.encoding else None, like.exif.block
    if profile is not None or values.dtype.kind == "f" or encoding == "srgb":
        pass
    elif isinstance(encoding, ToneCurves):
        profile = encoding.profile
    else:
        profile = icc.profile_of([1.0 if isinstance(encoding, str) else encoding], grey=values.ndim == 2)
    atomic.write(Path(path), form.write(values, profile, *([] if block is None else [block])))
    return clipped


def stored(light: Values, encoding: Encoding, dtype: DTypeLike) -> tuple[Values, float]:
    """Return encoded light as uint8, uint16 or float32, and the fraction of its values that were clipped."""
    encoding = checked(encoding)
    kind = validation.kind("dtype", dtype, np.uint8, np.uint16, np.float32)
    light = validation.array("light", light, "counts")
    if light.dtype.kind != "f":
        raise TypeError(f"light must hold floats, got {light.dtype}")
    if light.ndim not in (2, 3) or light.shape[2:] not in ((), (3,)) or 0 in light.shape:
        raise ValueError(f"light must have the shape (height, width) or (height, width, 3), got {light.shape}")
    if not np.all(np.isfinite(light)):
        raise ValueError(f"light must be finite, got {light[~np.isfinite(light)].flat[0]}")
    if kind.kind == "f":
        return from_light(light, encoding, kind), 0.0
    half_level = 0.5 / np.iinfo(kind).max
    clipped_light = np.clip(light, 0.0, 1.0)
    # Half a level in terms of light: sRGB has the slope 12.92 at black and 1.055 / 2.4 at white.
    low, high = (half_level / 12.92, half_level * 2.4 / 1.055) if encoding == "srgb" else (half_level, half_level)
    clipped_fraction = float(np.mean((light < -low) | (light > 1.0 + high)))
    return from_light(clipped_light, encoding, kind), clipped_fraction


_SRGB_TRANSFER, _HDR = 13, (16, 18)
# Curves of the transfer functions of ITU-T H.273 that are used: BT.709, gamma 2.2 and 2.8, linear; 2 is unspecified.
_TRANSFERS: dict[int, Sequence[float]] = dict.fromkeys((1, 6, 14, 15), icc.BT709) | {4: (2.2,), 5: (2.8,), 8: (1.0,)}

_BAND_PIXELS = 2**20  # number of pixels that are converted to an array in one step


def _decode(kind: str, data: bytes) -> tuple[Values, Tags, bytes | None, bytes | None]:
    """Return (1) values (16-bit for a 16-bit PNG), (2) tags, (3) ICC profile, (4) EXIF of a file read by Pillow."""
    with reading.pillow(kind, data) as file:
        if getattr(file, "is_animated", False):
            raise ValueError(f"it is an animation of {file.n_frames} frames")
        if file.mode not in ("1", "L", "P", "RGB", "I", "I;16", "LA", "RGBA"):
            raise ValueError(f"its colours are {file.mode}, neither grey nor RGB")
        is_16_bit, grey = file.format == "PNG" and data[24] == 16, file.mode not in ("P", "RGB", "RGBA")
        mode = file.tile[0][3] if is_16_bit else ""
        if is_16_bit and "transparency" in file.info:
            raise ValueError(_ALPHA)
        if mode == "LA;16B":  # Pillow keeps only the high bytes; decoded as RGBA, each byte is a channel
            file.tile = [(*file.tile[0][:3], "RGBA")]
        values = _opaque_values(file)
        # The tags of a PNG may follow the image data.
        tags, profile = file.getexif(), file.info.get("icc_profile")
        place = data.find(b"cICP", 0, max(0, data.find(b"IDAT"))) if file.format == "PNG" else -1
        nclx = (file.info.get("nclx_profile") or {}).get("transfer_characteristics")
        transfer = data[place + 5] if place >= 0 else nclx if nclx in _HDR else None
        gamma = file.info.get("gamma", 0.0) if file.format == "PNG" else 0.0
        if transfer in _HDR:
            raise ValueError("its values are of HDR (PQ or HLG); save it as sRGB")
        if transfer == _SRGB_TRANSFER or (transfer is None and profile is None and "srgb" in file.info):
            profile, tags[COLOUR_SPACE_TAG] = None, 1
        elif transfer in _TRANSFERS:
            profile = icc.profile_of(_TRANSFERS[transfer], grey=grey)
        elif profile is None and 0.1 <= gamma <= 10.0:
            profile = icc.profile_of([1.0 / gamma], grey=grey)
        metadata = tags, profile, file.info.get("exif")
    if not is_16_bit:
        return values, *metadata
    if grey:
        return values.astype(np.uint16, copy=False), *metadata
    if mode == "LA;16B":
        if values[..., 2].min() < 255:
            raise ValueError(_ALPHA)
        return values[..., 0] * np.uint16(256) + values[..., 1], *metadata
    if mode not in ("RGB;16B", "RGBA;16B"):
        raise ValueError(f"this Pillow reads 16-bit colour as {mode}; save it as TIFF")
    del file  # to save memory
    # Pillow keeps only the high bytes of 16-bit colour: decode again in the other byte order to get the low bytes.
    values = values.astype(np.uint16)
    values <<= 8
    with reading.pillow(kind, data) as swapped_file:
        swapped_file.tile = [(*swapped_file.tile[0][:3], mode.replace("16B", "16L"))]
        values |= _opaque_values(swapped_file)
    return values, *metadata


_WHITES = [2.0**bits - 1.0 for bits in range(9, 16)]  # MaxSampleValue of fewer bits in 16; others are statistics
_ALPHA = (
    "it has alpha that is not opaque everywhere; put it on a background, for example by ImageMagick: "
    "magick IN -background black -flatten OUT"
)


def _opaque_values(image: Image) -> Values:
    """Return the values of a Pillow image, without its alpha, which must be opaque; converts bands to save memory."""
    width, height = image.size
    mode = {"P": "RGB", "1": "L"}.get(image.mode)
    if "transparency" in image.info:
        mode = {"P": "RGBA", "RGB": "RGBA"}.get(image.mode, "LA")
    step, values = max(1, _BAND_PIXELS // width), None
    for top in range(0, height, step):
        part = image.crop((0, top, width, min(top + step, height)))
        band = np.asarray(part.convert(mode) if mode else part)
        if band.shape[2:] in ((2,), (4,)):
            if band[..., -1].min() < 255:
                raise ValueError(_ALPHA)
            band = band[..., 0] if band.shape[2] == 2 else band[..., :3]
        if values is None:
            values = np.empty((height, *band.shape[1:]), band.dtype)
        values[top : top + step] = band
    assert values is not None
    return values


def read_tiff(
    data: bytes, *, levels: bool = False, part: str | None = None
) -> tuple[Values, Tags, bytes | None, bytes]:
    """Return (1) values, (2) tags, (3) ICC profile, (4) EXIF of the only page of a TIFF file, or that of a number.

    `levels` allows any integer type.
    """
    import tifffile
    from PIL import Image

    with reading.tiff(data) as file:
        pages = [page for page in list[Any](file.pages) if not page.is_reduced]
        sizes = [" x ".join(map(str, page.shape)) for page in pages]
        page = reading.only(pages, [[str(k)] for k in range(len(pages))], sizes, part, "file.tif")
        if (images := math.prod(file.series[0].shape) // page.size) > len(file.pages):  # contiguous, as of ImageJ
            raise ValueError(f"it describes {images} images; give a file of one")
        alpha = tuple(page.extrasamples) in ((1,), (2,))
        if page.extrasamples and not alpha:
            raise ValueError("it has additional channels that are not alpha; remove them")
        if page.photometric not in (tifffile.PHOTOMETRIC.MINISBLACK, tifffile.PHOTOMETRIC.RGB):
            raise ValueError(f"its colours are {page.photometric.name}, neither grey nor RGB")
        values, axes, profile = reading.tiff_array(page), page.axes, page.iccprofile
        white = 0.0 if (tag := page.tags.get("MaxSampleValue")) is None else float(np.max(tag.value))
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
    if white in _WHITES and values.dtype == np.uint16 and not levels and not alpha and values.max() <= white:
        values = np.rint(values * (65535.0 / white)).astype(np.uint16)
    if alpha:
        if not values[..., -1].min() >= (1.0 if values.dtype.kind == "f" else np.iinfo(values.dtype.str).max):
            raise ValueError(_ALPHA)
        values = values[..., :-1] if values.shape[2] > 2 else values[..., 0]
    tags = Image.Exif()
    if data[2:4] in (b"*\0", b"\0*"):  # not BigTIFF, which Pillow does not read
        tags.load(data)
    return values.astype(values.dtype.newbyteorder("="), copy=False), tags, profile, data


@contextmanager
def open_raw(data: bytes) -> Iterator[Any]:
    """Open a raw photograph by LibRaw; ValueError if it is too large or cut off, OSError if it is damaged."""
    rawpy = library("rawpy", "raw photographs need", "raw")
    if data.startswith(TIFF[:2]):
        reading.require_whole(data)
    try:
        opened = rawpy.imread(io.BytesIO(data))
    except rawpy.LibRawError as error:
        raise OSError(f"LibRaw: {error.args[0].decode()}") from None  # bytes
    with opened as file:
        reading.pixels(file.sizes.raw_width, file.sizes.raw_height)
        if file.raw_type.name == "Flat" and not file.raw_image_visible[-1].any():  # as LibRaw leaves what is missing
            raise ValueError("its last rows are empty: it is cut off")
        yield file


def raw_tags(data: bytes) -> Tags:
    """Return the EXIF tags of a raw photograph that is a TIFF file (DNG, NEF, CR2, ...), without its orientation."""
    from PIL import Image

    tags = Image.Exif()
    if data.startswith(TIFF[:2]):
        tags.load(data)
    tags.pop(0x0112, None)
    return tags


def _read_raw(data: bytes) -> tuple[Values, Tags, bytes | None, bytes]:
    """Return (1) linear RGB, upright, (2) tags, (3) ICC profile, (4) EXIF of a raw photograph, as by LibRaw."""
    options = {"gamma": (1, 1), "no_auto_bright": True, "output_bps": 16, "use_camera_wb": True}
    with open_raw(data) as file:  # white is that of the sensor, not the brightest pixel of the photograph
        values = file.postprocess(**options, adjust_maximum_thr=0.0)
    return values, raw_tags(data), icc.profile_of([1.0], grey=False), data


def write_png(values: Values, profile: bytes | None, block: bytes | None = None) -> bytes:
    """Return a PNG file, without loss."""
    if values.dtype.itemsize == 2:
        return png_of_16_bits(values, profile, 6, block)
    return _encode("png", values, profile, block)


def _write_jpeg(values: Values, profile: bytes | None, block: bytes | None = None) -> bytes:
    return _encode("jpeg", values, profile, block, quality=95, subsampling=0)


def write_tiff(values: Values, profile: bytes | None, block: bytes | None = None) -> bytes:
    """Return a TIFF file, without loss."""
    import tifffile

    options = {"photometric": "rgb" if values.shape[2:] == (3,) else "minisblack", "software": f"lommel {version()}"}
    file = atomic.contents(tifffile.imwrite, values, byteorder="<", iccprofile=profile, metadata=None, **options)
    return file if block is None else in_tiff(file, block)


def _encode(form: str, values: Values, profile: bytes | None, block: bytes | None, **options: object) -> bytes:
    from PIL import Image

    if block is not None:
        options["exif"] = PREFIX + block
    return atomic.contents(Image.fromarray(values).save, form, icc_profile=profile, **options)


def png_of_16_bits(
    values: NDArray[np.uint16], profile: bytes | None, level: int, block: bytes | None = None
) -> bytes:
    """Return a 16-bit PNG, grey or (unlike Pillow) RGB; a row is stored as its difference from the previous row."""
    height, width = values.shape[:2]
    # The filter "up" (PNG, 9.2) stores differences between rows, which deflate compresses better.
    rows = values.astype(">u2").view(np.uint8).reshape(height, -1)
    lines = np.full((height, 1 + rows.shape[1]), 2, dtype=np.uint8)
    lines[0, 1:] = rows[0]
    np.subtract(rows[1:], rows[:-1], out=lines[1:, 1:])
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", width, height, 16, 2 if values.ndim == 3 else 0, 0, 0, 0))]
    if profile is not None:
        chunks.append((b"iCCP", b"ICC Profile\0\0" + zlib.compress(profile)))
    if block is not None:
        chunks.append((b"eXIf", block))
    chunks += [(b"IDAT", zlib.compress(lines.data, level)), (b"IEND", b"")]
    parts = [struct.pack(">I", len(d)) + name + d + struct.pack(">I", zlib.crc32(name + d)) for name, d in chunks]
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


def _read_pfm(data: bytes, scale: float | None) -> Values:
    """Return the values of a portable float map, whose first row is the bottom; a scale < 0 means little-endian."""
    header = _PFM.match(data)
    if not header:
        raise ValueError("its header is not that of a PFM file")
    if header[1] != b"Pf":
        raise ValueError("it is in colour; save one channel")
    width, height, scale_in_header = int(header[2]), int(header[3]), float(header[4])
    reading.pixels(width, height)
    if scale_in_header == 0.0 or (abs(scale_in_header) != 1.0 and scale is None):
        raise ValueError(f"its header states the scale {scale_in_header:g}; give `scale`, the metres per unit")
    body = data[header.end() :]
    if len(body) != 4 * width * height:
        raise ValueError(f"{width} x {height} values take {4 * width * height} bytes, got {len(body)}")
    return np.frombuffer(body, dtype="<f4" if scale_in_header < 0.0 else ">f4").reshape(height, width)[::-1]


def _read_npy(data: bytes, _scale: float | None) -> Values:
    return reading.npy(data, reading.MAX_PIXELS)[0]


def _read_raster(data: bytes, _scale: float | None, part: str | None = None) -> Values:
    form = registry.identify("photo", data)
    if form.read is read_tiff:
        form = replace(form, read=partial(read_tiff, levels=True, part=part))
    values = upright(form, data)[0]
    if values.ndim == 2:
        return values
    if any(np.any(row != row[:, :1]) for row in values):
        raise ValueError("it is in colour: its three channels differ, and a depth map has one")
    return np.ascontiguousarray(values[..., 0])


def _write_pfm(values: NDArray[np.float32]) -> bytes:
    height, width = values.shape
    return f"Pf\n{width} {height}\n-1.0\n".encode() + values[::-1].astype("<f4").tobytes()


_RAW = Format("photo", _RAW_SUFFIXES, read=_read_raw)
read_png, _8, _16, _EXIF = partial(_decode, "Png"), "of uint8", "of uint16", "with EXIF"
_photo, _depth = (partial(Format, kind) for kind in ("photo", "depth map"))
registry.register(
    _photo((".png",), write_png, read_png, PNG, (_8, _16, _EXIF), library="PIL.Image"),
    _photo((".jpg", ".jpeg"), _write_jpeg, partial(_decode, "Jpeg"), JPEG, (_8, _EXIF), library="PIL.Image"),
    _photo((".tif", ".tiff"), write_tiff, read_tiff, TIFF, (_8, _16, "of float32", _EXIF), library="tifffile"),
    _photo((".exr",), write_exr, read_exr, START, ("of float32",), library="OpenEXR"),
    _photo((".bmp",), read=partial(_decode, "Bmp"), starts=(b"BM",), library="PIL.Image"),
    _photo((".heic", ".heif"), read=partial(_decode, "Heif"), starts=reading.HEIC, library="pillow_heif"),
    _depth((".npy",), partial(atomic.contents, np.save), _read_npy, (b"\x93NUMPY",)),
    _depth((".pfm",), _write_pfm, _read_pfm, (b"Pf", b"PF")),
    _depth((".tif", ".tiff"), partial(write_tiff, profile=None), _read_raster, TIFF, library="tifffile"),
    _depth((".png",), read=_read_raster, starts=PNG),
    _depth((".exr",), write_depth, read_depth, START, library="OpenEXR"),
)
find, find_depth = partial(registry.find, "photo"), partial(registry.find, "depth map")
