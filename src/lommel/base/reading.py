"""Reading and parsing of files, with checks of the required memory and time before a file is decoded.

Reading a plain file takes at most 256 MB of memory or ten times the file size, whichever is larger, and at most one
second of processor time per megabyte. For compressed files the limit of memory is a hundred times the file size.
"""

from __future__ import annotations

import errno
import io
import logging
import math
import mmap
import os
import re
import stat
import struct
import sys
import threading
import warnings
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager, redirect_stdout
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any, cast
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Json, Values
from lommel.base.optional import library

if TYPE_CHECKING:
    import zipfile
    from xml.etree.ElementTree import Element

    from h5py import Dataset, File, Group
    from PIL.Image import Image
    from PIL.TiffImagePlugin import TiffImageFile
    from tifffile import TiffFile, TiffFrame, TiffPage, TiffPageSeries

Tags = dict[int, NDArray[np.generic]]

MAX_PIXELS = validation.MAX_SIDE**2
"""Maximum number of pixels in a picture, and of bytes in a description."""

MAX_PICTURE_SIDE = 2**16
"""Maximum number of pixels along one side of a picture."""

MAX_TEXT = 2**23
"""Maximum size in bytes of a table with a row for each position."""

MAX_LIST = 2**19
"""Maximum size in bytes of a list, such as the terms of one wavefront."""

MAX_TOML = 2**18
"""Maximum size in bytes of a lens file; the parser may allocate half a kilobyte for two bytes of TOML."""

MEMORY = 2**28
"""Bytes of memory that reading a file of any size may take."""

NPZ_TIMES = 4
"""Memory for reading the arrays of a .npz file divided by their size."""

# Maximum of memory / file size, for plain and for compressed files, if the memory exceeds MEMORY.
_RATIO, _COMPRESSED_RATIO = 10, 100
_HEADER = 2**16  # number of bytes read to parse the header of an array, which is usually one line
_TIFF_TYPES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 6: 1, 7: 1, 8: 2, 9: 4, 10: 8, 11: 4, 12: 8, 13: 4, 16: 8, 17: 8, 18: 8}
_TIFF_INTEGERS = {1: "u1", 3: "u2", 4: "u4", 13: "u4", 16: "u8", 18: "u8"}
_DESCRIPTION = 270  # tag ImageDescription, which tifffile parses if it is XML
_MANAGER = 51123  # tag of Micro-Manager's metadata
_TIFF_PAGE = 2**12  # bytes of memory that tifffile uses for a page
_TIFF_FRAME = 2**10  # bytes of memory that tifffile uses for a page that resembles the first
_PLANE = 2**6  # bytes of memory that tifffile and this package use for each image plane that the metadata state
_MAX_TAGS = 4096  # maximum number of tags of a page
DEFLATE = (8, 32946)
"""Codes of the compression deflate in TIFF files."""

_MAX_DEFLATE_RATIO = 1032  # two bits may encode 258 bytes (RFC 1951, 3.2.5)
# Compressions whose decoded size is known before decoding.
_COMPRESSIONS = {1: "none", 5: "LZW", 8: "deflate", 32773: "PackBits", 32946: "deflate"}
_MAX_SCANS = 20  # number of scans above which the time to decode a JPEG is limited; progressive files have about ten
_MAX_MEMBERS = 1000  # maximum number of members of an archive
_MAX_KEY_PARTS = 16  # maximum number of parts of a dotted key; lens files have at most four
_KEY = r"(?:[\w-]+|\"[^\"\n]*\"|'[^'\n]*')"
_DOTTED = re.compile(rf"(?<![\w-]){_KEY}(?:[ \t]*\.[ \t]*{_KEY}){{{_MAX_KEY_PARTS}}}")


def contents(path: Path, limit: int = 8 * validation.MAX_VALUES + MAX_PIXELS) -> bytes:
    """Return the bytes of a file; OSError if it is too large, or a pipe or device."""
    count = size(path)
    if count > limit:
        raise OSError(errno.EFBIG, f"has {count} bytes; the limit is {limit}", str(path))
    with path.open("rb") as file:
        return file.read(count)


def start(path: Path, count: int) -> bytes:
    """Return the first `count` bytes of a file; OSError if it is a folder, pipe or device."""
    size(path)  # raises an error for a pipe, on which reading would wait
    with path.open("rb") as file:
        return file.read(count)


def size(path: Path) -> int:
    """Return the number of bytes of a file; OSError if it is a folder, pipe or device."""
    status = path.stat()
    if stat.S_ISDIR(status.st_mode):
        raise IsADirectoryError(errno.EISDIR, "Is a directory", str(path))
    if not stat.S_ISREG(status.st_mode):
        raise OSError(errno.EINVAL, "is no regular file", str(path))
    return status.st_size


def affords(memory: float, size: int, times: int = _COMPRESSED_RATIO) -> bool:
    """Return True if reading a file of `size` bytes may use `memory` bytes."""
    return memory <= max(MEMORY, times * size)


def afford(memory: float, size: int, times: int = _COMPRESSED_RATIO) -> None:
    """Raise ValueError if reading a file of `size` bytes must not use `memory` bytes."""
    if not affords(memory, size, times):
        limit = max(MEMORY, times * size)
        hint = "; save it without compression" if times == _COMPRESSED_RATIO else ""
        raise ValueError(
            f"it would take {memory:.3g} bytes of memory; the limit for a file of {size} bytes is {limit:.3g}{hint}"
        )


def decoded(data: bytes) -> str:
    """Return a UTF-8 text with Unix line ends; ValueError if it is not UTF-8."""
    try:
        return data.decode("utf-8-sig").replace("\r\n", "\n").replace("\r", "\n")
    except UnicodeDecodeError as error:
        raise ValueError(f"not UTF-8 text: {error}") from None


def toml(text: str) -> Json:
    """Parse a TOML text; ValueError if it is not valid, or nested too deeply."""
    import tomllib

    if len(text) > MAX_TOML:
        raise ValueError(f"it has {len(text)} characters; the limit is {MAX_TOML}")
    if found := _DOTTED.search(text):
        raise ValueError(f"a key must have at most {_MAX_KEY_PARTS} parts, got {validation.shown(found[0])}")
    try:
        return tomllib.loads(text)
    except (RecursionError, MemoryError) as error:
        raise ValueError(f"its tables are too many or too deep ({type(error).__name__})") from None


def json(data: bytes | str, pairs: Callable[[list[tuple[str, object]]], object] | None = None) -> Any:
    """Parse a JSON text; ValueError if it is not valid, or would take too much memory."""
    from json import loads

    text = data.decode() if isinstance(data, bytes) else data
    # Bytes of the Python objects that the parser may create for each occurrence of these characters.
    costs = (("[", 128), ("{", 320), (",", 32), (":", 96), ('"', 28))
    afford(2 * len(text) + sum(cost * text.count(character) for character, cost in costs), len(text), _RATIO)
    try:
        return loads(text, object_pairs_hook=pairs)
    except (RecursionError, MemoryError) as error:
        raise ValueError(f"its objects are too many or too deep ({type(error).__name__})") from None


def xml(text: str) -> Element:
    """Return the root element of an XML text; ValueError if it is not valid, or would take too much memory."""
    from xml.etree import ElementTree as ET

    _afford_xml(text)
    try:
        return ET.fromstring(text)
    except ET.ParseError as error:
        raise ValueError(f"it is no XML: {error}") from None


def _afford_xml(text: str) -> None:
    """Raise ValueError for XML that would take too much memory, or defines entities, which expand without limit."""
    if "<!ENTITY" in text:
        raise ValueError("it defines XML entities, which are not supported")
    # Python uses up to 512 bytes for an element and 160 bytes for an attribute.
    afford(2 * len(text) + 512 * text.count("<") + 160 * text.count("="), len(text), _RATIO)


def reason(error: Exception) -> str:
    """Return the message of an error, possibly of another library, on one line."""
    return validation.brief(" ".join(str(error).split()), 240) or type(error).__name__


@contextmanager
def refused_as(kind: type[ValueError], source: Path, what: str) -> Iterator[None]:
    """Raise any error again as `kind`, with the message "SOURCE WHAT: reason"; ImportError is not changed."""
    try:
        yield
    except (ImportError, kind):
        raise
    except Exception as error:
        raise kind(f"{validation.line(source)} {what}: {reason(error)}") from error


def pixels(width: int, height: int) -> None:
    """Raise ValueError if a picture exceeds the maximum number of pixels or the maximum side."""
    if not 0 < width * height <= MAX_PIXELS:
        raise ValueError(f"it has {width} x {height} pixels; the limit is {MAX_PIXELS} in total")
    if max(width, height) > MAX_PICTURE_SIDE:
        raise ValueError(f"it has {width} x {height} pixels; the limit of a side is {MAX_PICTURE_SIDE}")


def npy(data: bytes, limit: int = validation.MAX_VALUES) -> tuple[NDArray[np.generic], bytes]:
    """Return the array of a .npy file, and the bytes after the array."""
    start, shape, fortran, kind = _npy_header(data[:_HEADER], limit)
    count = math.prod(shape)
    if start + count * kind.itemsize > len(data):
        raise ValueError(f"its values take {count * kind.itemsize} bytes, got {len(data) - start}")
    values = np.frombuffer(data, kind, count, start).reshape(shape, order="F" if fortran else "C").copy()
    return values, data[start + count * kind.itemsize :]


def npy_mapped(path: Path) -> NDArray[np.generic]:
    """Return the array of a .npy file as a memory map, whose values are read on access."""
    offset, shape, fortran, kind = _npy_header(start(path, _HEADER), validation.MAX_VALUES)
    count, available = math.prod(shape) * kind.itemsize, size(path) - offset
    if count > available:
        raise ValueError(f"its values take {count} bytes, got {available}")
    return np.memmap(path, kind, "r", offset, shape, "F" if fortran else "C") if count else np.zeros(shape, kind)


def _npy_header(data: bytes, limit: int) -> tuple[int, tuple[int, ...], bool, np.dtype[np.generic]]:
    file = io.BytesIO(data)
    try:
        # Warnings become errors here: NumPy issues warnings for obsolete formats of the header.
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            version = np.lib.format.read_magic(file)
            read = {1: np.lib.format.read_array_header_1_0, 2: np.lib.format.read_array_header_2_0}[version[0]]
            shape, fortran, kind = read(file)
    except Exception as error:  # NumPy evaluates the header with Python's parser, which raises many types of errors
        raise ValueError(f"its header is not that of an array: {str(error) or type(error).__name__}") from None
    if kind.hasobject:
        raise ValueError("it holds Python objects, a pickle")
    if min(shape, default=1) < 0 or math.prod(shape) * kind.itemsize > 8 * limit:
        raise ValueError(f"it has {' x '.join(map(str, shape))} values of {kind}; the limit is {limit}")
    return file.tell(), shape, fortran, kind


def npz(data: bytes) -> dict[str, Callable[[int], NDArray[np.generic]]]:
    """Return for each array of a .npz file, by name, a function that reads it; its argument limits the size."""
    import zipfile

    def read(member: zipfile.ZipInfo, limit: int) -> NDArray[np.generic]:
        with archive.open(member) as file:
            head = file.read(_HEADER)
            start, shape, _, kind = _npy_header(head, limit)
            size = start + math.prod(shape) * kind.itemsize
            # Decode a member only if the size in its .npy header equals the size in the directory of the archive.
            if size != member.file_size:
                raise ValueError(f"{validation.shown(member.filename)} takes {size} bytes, got {member.file_size}")
            return npy(head + file.read(), limit)[0]

    # The members are counted before the archive is opened, since opening creates a Python object for each member.
    if data.count(b"PK\1\2") > _MAX_MEMBERS:
        raise ValueError(f"it has more than {_MAX_MEMBERS} members")
    archive = zipfile.ZipFile(io.BytesIO(data))
    members = {member.filename.removesuffix(".npy"): member for member in archive.infolist()}
    if any(member.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED) for member in members.values()):
        raise ValueError("it is compressed in an unknown way")
    afford(NPZ_TIMES * sum(member.file_size for member in members.values()), len(data))
    return {name: partial(read, member) for name, member in members.items()}


def png(data: bytes) -> Image:
    """Return a PNG file opened by Pillow, not yet decoded; ValueError if its data cannot hold the stated pixels."""
    from PIL.PngImagePlugin import PngImageFile

    # Chunks have length, name, data, CRC. Only IDAT chunks hold pixels, compressed by deflate.
    offset, idat = 8, 0
    while offset + 8 <= len(data):
        size, name = struct.unpack_from(">I4s", data, offset)
        idat += size if name == b"IDAT" else 0
        offset += 12 + size
    width, height, bits, kind = struct.unpack_from(">IIBB", data.ljust(26, b"\0"), 16)
    pixels(width, height)
    samples = {2: 3, 4: 2, 6: 4}.get(kind, 1)
    pixel_bytes = (width * bits * samples + 7) // 8 * height
    if pixel_bytes > _MAX_DEFLATE_RATIO * idat:
        raise ValueError(f"{width} x {height} pixels take {pixel_bytes} bytes, more than its {idat} can inflate to")
    afford(png_takes(width * height, bits, kind in (2, 6)), len(data))
    # Image.open is not used: its limit against decompression bombs would refuse large pictures of this package.
    return PngImageFile(io.BytesIO(data))


def png_takes(count: int, bits: int, colour: bool) -> int:
    """Return the bytes of memory for reading a PNG of `count` pixels: Pillow's image, a copy, depth in float64."""
    return count * ((14 if bits == 16 else 8) if colour else 13)


def jpeg(data: bytes) -> Image:
    """Return a JPEG file opened by Pillow, not yet decoded; ValueError if decoding would take too long."""
    from PIL.JpegImagePlugin import JpegImageFile

    # Every scan covers the whole image, so that decoding a small file with many scans could take minutes.
    scans = data.count(b"\xff\xda")
    file = JpegImageFile(io.BytesIO(data))
    width, height = file.size
    pixels(width, height)
    # With several scans the decoder stores all DCT coefficients of the image, 16 bits each.
    sampling = [x_factor * y_factor for _, x_factor, y_factor, _ in getattr(file, "layer", [])] or [1]
    coefficient_bytes = 2.0 * sum(sampling) / max(sampling) if scans > 1 else 0.0
    afford(width * height * (7.0 + coefficient_bytes), len(data))
    if scans > _MAX_SCANS and width * height * scans > 2**28 + 2**10 * len(data):
        raise ValueError(f"it has {width} x {height} pixels in {scans} scans")
    return file


def bmp(data: bytes) -> Any:
    """Return a BMP file opened by Pillow, not yet decoded; ValueError if it is compressed or truncated."""
    from PIL.BmpImagePlugin import BmpImageFile

    file: Any = BmpImageFile(io.BytesIO(data))
    pixels(*file.size)
    (decoder, _, start, settings), *_ = file.tile
    if decoder != "raw":
        raise ValueError("it is compressed; save it as PNG")
    if start + settings[1] * file.size[1] > len(data):
        raise ValueError(f"{file.size[0]} x {file.size[1]} pixels are more than the file holds")
    return file


HEIC = tuple(
    struct.pack(">I", size) + b"ftyp" + brand
    for size in range(16, 68, 4)
    for brand in (b"heic", b"heix", b"mif1", b"msf1")
)
"""The first bytes of HEIC files."""


def heic(data: bytes) -> Image:
    """Return a HEIC file opened by pillow-heif, not yet decoded."""
    file: Image = library("pillow_heif.as_plugin", "HEIC files need", "heic").HeifImageFile(io.BytesIO(data))
    pixels(*file.size)
    afford(12.0 * file.size[0] * file.size[1], len(data))
    return file


@contextmanager
def tiff(data: bytes) -> Iterator[TiffFile]:
    """Open a TIFF file with tifffile; ValueError if a page is too large, or states more data than the file holds."""
    from lommel.base.tiff_series import File

    count, memory = 0, 0
    for tags in _tiff_pages(data):
        count += 1
        memory += _tiff_page(data, tags)
        afford(_TIFF_PAGE * count, len(data), _RATIO)
        afford(memory, len(data))
    if not count:
        raise ValueError("it has no page")
    with quietly(), File(io.BytesIO(data), tiff_directories, afford_pages) as file:
        yield file


def tiff_on_disk(path: Path) -> tuple[TiffFile, list[str]]:
    """Return a TIFF file of any size, opened by tifffile, and the errors that tifffile logged.

    Only the first page is checked here; :func:`tiff_values` checks each page when it is read. The first page of each
    other file that the OME metadata name is checked too; it must be a regular file in the same folder.
    """
    from lommel.base.tiff_series import File

    tags, sizes = _tiff_first(path)
    text = tags[_DESCRIPTION].tobytes().decode(errors="replace").partition("\0")[0] if _DESCRIPTION in tags else ""
    _afford_xml(text)
    if text.strip().endswith("OME>"):
        _afford_ome(path.resolve(), text.strip(), sizes)
    if _MANAGER in tags:
        _afford_manager(path.resolve())
    with quietly() as errors:
        file = File(path, tiff_directories, afford_pages)
        try:
            file.series  # noqa: B018 (finds the pages)
        except BaseException:
            file.close()
            raise
    return file, errors


def _tiff_first(path: Path) -> tuple[Tags, list[int]]:
    """Check the first page of a file; return its tags, and the number of pixels of each page."""
    if size(path) < 16:
        raise ValueError("its header is not that of a TIFF file")
    with path.open("rb") as file:
        mapped = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        if (tags := next(_tiff_pages(mapped), None)) is None:
            raise ValueError("it has no page")
        _tiff_page(mapped, tags)
        return tags, _tiff_chain(file.fileno(), mapped)


def _tiff_chain(file: int, data: mmap.mmap) -> list[int]:
    """Return the number of pixels of each page; ValueError if the chain of pages is circular or leaves the file."""
    order, big = _tiff_order(data)
    entry, stride = struct.Struct(f"{order}HHQ" if big else f"{order}HHI"), 20 if big else 12
    # Entries of the previous page up to its width and height, and its number of pixels: most pages begin equally.
    sizes, prefix, prefix_pixels = list[int](), b"", 0
    # os.pread, since access through the memory map would keep the surrounding memory resident.
    for _, entries in tiff_directories(lambda offset, count: os.pread(file, count, offset), len(data)):
        if not prefix or not entries.startswith(prefix):
            prefix, prefix_pixels = _tiff_sides(entries, order, entry, stride)
        sizes.append(prefix_pixels)
    return sizes


def tiff_directories(read: Callable[[int, int], bytes], length: int) -> Iterator[tuple[int, bytes]]:
    """Yield the position and the entries of each page; `read` returns the bytes at a position, at most so many.

    ValueError if the chain of pages is circular, leaves the file, or would take too much memory.
    """
    start = read(0, 16)
    order, big = _tiff_order(start)
    head, stride, word = struct.Struct(order + ("Q" if big else "H")), 20 if big else 12, 8 if big else 4
    next_page = struct.Struct(order + ("Q" if big else "I"))
    (offset,) = next_page.unpack_from(start, word)
    visited, read_size = set[int](), 2**9
    while offset:
        if offset in visited:
            raise ValueError("its chain of pages is circular")
        visited.add(offset)
        afford(_TIFF_FRAME * len(visited), length, _RATIO)
        # Read as many bytes as the largest header of a page so far: for most pages one system call suffices.
        part = read(min(offset, length), read_size)
        try:
            (count,) = head.unpack_from(part)
            if count > _MAX_TAGS:
                raise ValueError(f"it has a page of {count} tags; the limit is {_MAX_TAGS}")
            end = head.size + count * stride
            if end + word > len(part):
                read_size = end + word
                part = read(offset, read_size)
            next_offset = next_page.unpack_from(part, end)
        except struct.error:
            raise ValueError("its pages go beyond its end") from None
        yield offset, part[head.size : end]
        (offset,) = next_offset


def afford_pages(pages: int, frames: int, length: int) -> None:
    """Raise ValueError if `pages` of their own kinds and `frames` like others would take too much memory."""
    afford(_TIFF_PAGE * pages + _TIFF_FRAME * frames, length, _RATIO)


def _tiff_sides(entries: bytes, order: str, entry: struct.Struct, stride: int) -> tuple[bytes, int]:
    """Return (1) the entries of a page up to width and height (b"" if either is missing) and (2) width * height."""
    kinds = {1: "B", 3: "H", 4: "I", 16: "Q"}
    sides: dict[int, int] = {}
    for offset in range(0, len(entries) - stride + 1, stride):
        tag, kind, _ = entry.unpack_from(entries, offset)
        if tag in (256, 257) and kind in kinds and struct.calcsize(kinds[kind]) <= stride - entry.size:
            (sides[tag],) = struct.unpack_from(order + kinds[kind], entries, offset + entry.size)
        if len(sides) == 2:
            return entries[: offset + stride], math.prod(sides.values())
    return b"", math.prod(sides.values())


def _afford_ome(path: Path, text: str, sizes: list[int]) -> None:
    """Raise ValueError for OME metadata that state far more planes than pages, or name files in other folders."""
    root = xml(text)
    total, count, min_size = size(path), len(sizes), min(sizes)
    uuid, uuids = root.get("UUID"), {root.get("UUID")}
    for element in root.iter():
        name = element.get("FileName")
        if not element.tag.endswith("UUID") or name is None:
            continue
        if uuid is None and element.text is not None and name.lower() == path.name.lower():
            uuid, uuids = element.text, {element.text}
        elif element.text not in uuids and (sibling := _sibling_file(path, name)) is not None:
            uuids.add(element.text)
            sibling_sizes = _tiff_first(sibling)[1]
            total, count, min_size = total + size(sibling), count + len(sibling_sizes), min(min_size, *sibling_sizes)
    stated_planes = listed_planes = 0
    for part in root.iter():
        if part.tag.endswith("Pixels"):
            sides = (max(1, int(part.get(f"Size{letter}", 1))) for letter in "XYZCT")
            stated_planes += math.prod(sides) // max(1, min_size)
        if part.tag.endswith("TiffData"):
            default_count = 1 if "IFD" in part.attrib else count
            listed_planes += max(0, int(part.get("PlaneCount", part.get("NumPlanes", default_count))))
    planes = max(stated_planes, listed_planes)
    if not affords(_PLANE * planes, total, _RATIO) or not affords(_TIFF_FRAME * count, total, _RATIO):
        raise ValueError(f"its OME metadata state {planes:.3g} planes of its size, far more than its {count} pages")


def _afford_manager(path: Path) -> None:
    """Check the files that tifffile reads together with a file of Micro-Manager: its stack, or its NDTiff index."""
    import tifffile

    if "_MMStack" in path.name:
        for entry in path.parent.glob("*_MMStack*.tif"):
            _sibling_file(path, entry.name)  # pages are not checked, since few of many files are read
    names = set[str]()
    if (index := _sibling_file(path, "NDTiff.index")) is not None:
        places: dict[str, set[int | str]] = {}
        for axes, name, *_ in tifffile.read_ndtiff_index(index):
            names.add(name)
            for axis, place in axes.items():
                places.setdefault(axis, set()).add(place)
        ends = (max([len(indices), *(k + 1 for k in indices if isinstance(k, int))]) for indices in places.values())
        if not affords(_PLANE * (planes := math.prod(ends)), size(index), _RATIO):
            raise ValueError(f"its NDTiff.index states {planes:.3g} images, far more than its size allows")
    for name in names - {path.name}:
        if (sibling := _sibling_file(path, name)) is not None:
            _tiff_first(sibling)


def _sibling_file(path: Path, name: str) -> Path | None:
    """Return the file `name` in the folder of `path`, None if it does not exist; ValueError if it is not allowed."""
    file = path.parent / name
    if not os.path.lexists(file):
        return None
    # Refuse names with a folder: the metadata of a downloaded file could name any file of this computer.
    if name != Path(name).name or "\\" in name:
        raise ValueError(f"its metadata name {validation.shown(name)}; only files beside it are read")
    if not stat.S_ISREG(file.lstat().st_mode):
        raise ValueError(f"its metadata name {validation.shown(name)}, which is no regular file")
    return file


def tiff_values(page: Any, shape: tuple[int, ...], dtype: np.dtype[np.generic]) -> Values:
    """Return the values of a page; ValueError unless it has the `shape` and `dtype` of the first page.

    ValueError too if its compression is not supported, or a strip or tile is too large for the page. All pages share
    the handle of the file, so that only one thread at a time may read them.
    """
    kind, handle = page.keyframe, page.parent.filehandle
    count, size = math.prod(shape), math.prod(shape) * dtype.itemsize
    if kind.size != count or np.dtype(kind.dtype).newbyteorder("=") != dtype.newbyteorder("="):
        sides = " x ".join(map(str, kind.shape))
        raise ValueError(f"it has {sides} values of {kind.dtype}, not {' x '.join(map(str, shape))} of {dtype}")
    if kind.compression not in _COMPRESSIONS:
        raise ValueError(f"its compression is of the kind {int(kind.compression)}, which is not supported")
    part_size = math.prod(page.chunks) * dtype.itemsize
    if part_size > max(4 * size, 2**20 * dtype.itemsize):
        raise ValueError(f"it has strips or tiles of {part_size} bytes for a page of {size} bytes")
    decoded_size = count * kind.bitspersample // 8
    if kind.compression == 1 and sum(page.databytecounts) < decoded_size:
        raise ValueError(f"its values take {decoded_size} bytes, got {sum(page.databytecounts)}")
    closed = handle.closed  # an image may consist of more files than can be open simultaneously
    if closed:
        handle.open()
    try:
        for offset, stored_size in zip(page.dataoffsets, page.databytecounts, strict=True):
            if kind.compression in DEFLATE:
                handle.seek(offset)
                if not inflates_within(handle.read(stored_size), max(size, part_size)):
                    raise ValueError(f"a part of it inflates to more than {size} bytes")
        return tiff_array(page).reshape(shape)
    finally:
        if closed:
            handle.close()


def tiff_array(page: TiffPage | TiffFrame) -> Values:
    """Return the values of a page; ValueError if neither tifffile nor, for LZW, Pillow can decode it."""
    if page.compression != _LZW or find_spec("imagecodecs"):
        return np.asarray(page.asarray())
    from PIL.TiffImagePlugin import TiffImageFile

    values, dtype = np.empty(0), np.dtype(page.dtype).newbyteorder("=")
    try:
        if (image := _PILLOW_IMAGES.get(page.parent)) is None:
            page.parent.filehandle.seek(0)
            image = _PILLOW_IMAGES[page.parent] = TiffImageFile(cast("IO[bytes]", page.parent.filehandle))
        with unprinted():
            image.seek(page.index)
            values = np.asarray(image)
    except (OSError, SyntaxError, TypeError) as error:  # Pillow raises TypeError for a page in a SubIFD
        if str(error) != "unknown pixel mode":
            raise ValueError(f"its LZW data cannot be unpacked: {reason(error)}") from None
    if values.shape != page.shape or values.dtype.newbyteorder("=") != dtype:
        colour = " in colour" if len(page.shape) > 2 else ""
        raise ValueError(
            f"LZW of {dtype}{colour} needs the package imagecodecs: pip install imagecodecs, or save the file with "
            "deflate or uncompressed"
        )
    return values.astype(dtype, copy=False)


@contextmanager
def unprinted() -> Iterator[list[str]]:
    """Suppress what libraries print about damage, one thread at a time; yield what this thread prints by Python.

    Standard output may carry results: OpenEXR's binding prints there by Python. libtiff and OpenEXR's core write to
    standard error, whose file descriptor is redirected, as replacing sys.stderr would have no effect on C libraries.
    """
    with _PRINT_LOCK, Path(os.devnull).open("wb") as null_file:
        output = _Output(sys.stdout)
        try:
            copy = os.dup(2)
        except OSError:  # standard error is closed
            copy = -1
        try:
            if copy >= 0:
                os.dup2(null_file.fileno(), 2)
            with redirect_stdout(cast("IO[str]", output)):
                yield output.texts
        finally:
            if copy >= 0:
                os.dup2(copy, 2)
                os.close(copy)


class _Output:
    """Standard output that keeps the texts of the thread that made it, and passes on those of other threads."""

    def __init__(self, stream: IO[str] | None) -> None:
        self._stream, self._thread, self.texts = stream, threading.get_ident(), list[str]()

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    def write(self, text: str) -> int:
        """Write a text to the stream, or keep it."""
        if threading.get_ident() != self._thread:
            return self._stream.write(text) if self._stream else 0
        self.texts.append(text)
        return len(text)


_PRINT_LOCK = threading.Lock()
_LZW = 5
# Images opened by Pillow, by the tifffile object of the same file.
_PILLOW_IMAGES: WeakKeyDictionary[TiffFile, TiffImageFile] = WeakKeyDictionary()


def tiff_mapped(file: TiffFile, series: TiffPageSeries, path: Path, count: int) -> Values | None:
    """Return the planes of a series as a memory map if they are contiguous in the file; otherwise None.

    Files of ImageJ may have only one page, for the first plane. ValueError if the description states more data than
    the file contains.
    """
    dtype, sides = np.dtype(series.dtype).newbyteorder(file.byteorder), series.shape[-2:]
    start, byte_count = series.dataoffset, count * math.prod(sides) * dtype.itemsize
    if start is not None and not series.is_multifile:
        if start + byte_count > size(path):
            raise ValueError(f"{byte_count} bytes of {count} images are more than the file holds")
        return np.memmap(path, dtype, "r", start, (count, *sides))
    if series.kind != "ome" and count > len(file.pages):  # missing pages of OME files are reported later
        raise ValueError(f"its description states {count} images; it has {len(file.pages)} pages")
    return None


def tiff_left_out(file: TiffFile) -> str:
    """Return a note ("5 pages, of which ...") if ImageJ's description omits pages, else "".

    ValueError if the description states more images than there are pages.
    """
    count, series = len(file.pages), file.series[0]
    if not file.is_imagej or count <= 1:  # with one page, ImageJ may store many images
        return ""
    images = (file.imagej_metadata or {}).get("images", math.prod(series.shape) // max(1, series.keyframe.size))
    if images > count:
        raise ValueError(f"its description by ImageJ states {images} images; it has {count} pages")
    return f"{count} pages, of which its description by ImageJ states {images}" if images < count else ""


def is_raw(data: bytes | mmap.mmap | Path) -> bool:
    """Return True for a TIFF file of a raw photograph: a DNG, a mosaic, or a file whose first page is a preview."""
    if isinstance(data, Path):
        with data.open("rb") as file:
            return is_raw(mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ))
    page = next(_tiff_pages(data), {})
    preview = _value(page, 254, 0) & 1 or data[8:10] == b"CR"
    return bool(preview or 50706 in page or _value(page, 262, 1) in (32803, 34892) or _has_larger_subpage(data, page))


def _has_larger_subpage(data: bytes | mmap.mmap, page: Tags) -> bool:
    """Return True if a subpage (SubIFD) of a page is larger than the page."""
    order = "<" if data[:2] == b"II" else ">"
    big = struct.unpack_from(f"{order}H", data, 2)[0] == 43
    subpages = [_tiff_tags(data, int(offset), order, big) for offset in page.get(330, ())[:16]]
    return any(_value(p, 256, 0) * _value(p, 257, 0) > _value(page, 256, 0) * _value(page, 257, 0) for p in subpages)


def _tiff_pages(data: bytes | mmap.mmap) -> Iterator[Tags]:
    """Yield the tags of each page as arrays of integers; a tag of another type has an empty array."""
    order, big = _tiff_order(data)
    for offset, _ in tiff_directories(lambda offset, count: data[offset : offset + count], len(data)):
        yield _tiff_tags(data, offset, order, big)


def _tiff_order(data: bytes | mmap.mmap) -> tuple[str, bool]:
    """Return the byte order of a TIFF file, and True if it is a BigTIFF."""
    order = {b"II": "<", b"MM": ">"}.get(data[:2])
    if order is None or len(data) < 16:
        raise ValueError("its header is not that of a TIFF file")
    return order, struct.unpack_from(f"{order}H", data, 2)[0] == 43


def _tiff_tags(data: bytes | mmap.mmap, offset: int, order: str, big: bool) -> Tags:
    """Return the tags of the page at position `offset`."""
    tags: Tags = {}
    head, entry, word = ("Q", "HHQ", "Q") if big else ("H", "HHI", "I")
    try:
        (count,) = struct.unpack_from(order + head, data, offset)
        offset += struct.calcsize(head)
        inline, claimed = struct.calcsize(word), 0
        for _ in range(count):
            tag, kind, number = struct.unpack_from(order + entry, data, offset)
            value_offset, size = offset + struct.calcsize("=" + entry), number * _TIFF_TYPES.get(kind, 1)
            if size > inline:
                (value_offset,) = struct.unpack_from(order + word, data, value_offset)
            if value_offset + size > len(data):
                raise ValueError(f"its tag {tag} claims {size} bytes of a file of {len(data)}")
            # Pillow copies the values of all tags, of which many may be the same bytes.
            if (claimed := claimed + size) > 2 * len(data):
                raise ValueError(f"its tags claim {claimed} bytes of a file of {len(data)}")
            if tag not in tags:
                integers = "u1" if tag == _DESCRIPTION else _TIFF_INTEGERS.get(kind)
                tags[tag] = np.frombuffer(data, order + (integers or "u1"), number if integers else 0, value_offset)
            offset += struct.calcsize("=" + entry) + inline
        return tags
    except (struct.error, OverflowError):  # OverflowError: a position exceeds the largest index
        raise ValueError("its pages go beyond its end") from None


def _value(tags: Tags, tag: int, default: int) -> int:
    return int(tags[tag][0]) if tag in tags and tags[tag].size else default


def _tiff_page(data: bytes | mmap.mmap, tags: Tags) -> int:
    """Check that the file can hold a page; return the bytes of memory for decoding it, 0 if it is not compressed."""
    value, empty = partial(_value, tags), np.zeros(0, np.uint8)
    width, height, samples = value(256, 0), value(257, 0), value(277, 1)
    pixels(width, height)
    compression, bits = value(259, 1), int(tags.get(258, empty).max(initial=1))
    if value(32997, 1) != 1 or samples > 64 or bits > 64:
        raise ValueError(f"it has {samples} samples of {bits} bits a pixel, or pages of several layers")
    if compression not in _COMPRESSIONS:
        names = ", ".join(dict.fromkeys(_COMPRESSIONS.values()))
        raise ValueError(f"its compression is of the kind {compression}; save it with {names}")
    tiled = 322 in tags
    part_width, part_height = (value(322, 0), value(323, 0)) if tiled else (width, min(value(278, height), height))
    if part_width * part_height == 0 or part_width * part_height > max(4 * width * height, 2**20):
        raise ValueError(f"it has {width} x {height} pixels in parts of {part_width} x {part_height}")
    part_bytes = (part_width * samples * bits + 7) // 8 * part_height
    if compression == 1 and (width * samples * bits + 7) // 8 * height > len(data):
        raise ValueError(f"{width} x {height} pixels without compression are more than the file holds")
    parts = math.ceil(width / part_width) * math.ceil(height / part_height) * (samples if value(284, 1) == 2 else 1)
    places, sizes = (tags.get(part, empty) for part in ((324, 325) if tiled else (273, 279)))
    if len(places) < parts or (compression != 1 and len(sizes) < parts):
        raise ValueError(f"it has {min(len(places), len(sizes))} parts; {width} x {height} pixels take {parts}")
    for place, size in zip(places[:parts].tolist(), sizes[:parts].tolist(), strict=False):
        # Deflate data do not state their decompressed size: inflate each part, up to the size that it must have.
        if compression in DEFLATE and not inflates_within(data[place : place + size], part_bytes):
            raise ValueError(f"a part of it inflates to more than its {part_bytes} bytes")
    return 0 if compression == 1 else width * height * (13 + 2 * samples * ((bits + 7) // 8))


def inflates_within(part: bytes, limit: int, wbits: int = zlib.MAX_WBITS) -> bool:
    """Return True if deflated bytes inflate to at most `limit` bytes, or are damaged (then reading fails)."""
    try:
        return len(zlib.decompressobj(wbits).decompress(part, limit + 1)) <= limit
    except zlib.error:
        return True


def hdf5(data: bytes) -> File:
    """Return an HDF5 file opened by h5py; :func:`hdf5_values` reads its arrays."""
    import h5py

    return h5py.File(io.BytesIO(data), "r")


def hdf5_below(group: Group, *names: str) -> Dataset:
    """Return the object at a path below a group, None if missing; links that may leave the file are ignored."""
    import h5py

    for name in names:
        if not isinstance(group, h5py.Group) or not isinstance(group.get(name, getlink=True), h5py.HardLink):
            return None
        group = group[name]
    return group


def hdf5_values(array: Dataset, size: int) -> NDArray[np.generic]:
    """Return an array of an HDF5 file of `size` bytes; ValueError if it is in another file or exceeds the limits."""
    import h5py

    if not isinstance(array, h5py.Dataset) or array.external or array.is_virtual or array.dtype.kind not in "iufS":
        raise ValueError("it must be an array of numbers in the file itself")
    if array.chunks is None:
        if array.nbytes > size:
            raise ValueError(f"it must be stored in one piece, got {array.nbytes} bytes of {size}")
        return np.asarray(array[()])
    # Memory for the values as float64 with a mask. Below, chunks that inflate to more than their size are refused.
    afford(3 * max(array.nbytes, 8 * array.size), size)
    chunk = math.prod(array.chunks) * array.dtype.itemsize
    filters = array.id.get_create_plist()
    kinds = [filters.get_filter(k)[0] for k in range(filters.get_nfilters())]
    deflate, shuffling, fletcher = h5py.h5z.FILTER_DEFLATE, h5py.h5z.FILTER_SHUFFLE, h5py.h5z.FILTER_FLETCHER32
    if len(kinds) != len(set(kinds)) or not {deflate, shuffling, fletcher}.issuperset(kinds):
        raise ValueError("it is compressed in an unknown way")
    count = math.prod(math.ceil(side / part) for side, part in zip(array.shape, array.chunks, strict=True))
    if count > size // 16 + 16 or chunk > max(4 * array.nbytes, 2**20):
        raise ValueError(f"it has {count} chunks of {chunk} bytes, of a file of {size}")
    for k in range(array.id.get_num_chunks() if deflate in kinds else 0):
        _, part = array.id.read_direct_chunk(array.id.get_chunk_info(k).chunk_offset)
        if not inflates_within(part[:-4] if kinds[-1] == fletcher else part, chunk + 4):
            raise ValueError(f"a part of it inflates to more than its {chunk} bytes")
    return np.asarray(array[()])


@contextmanager
def quietly() -> Iterator[list[str]]:
    """Suppress tifffile's log; yield the list of errors that this thread logs, which the caller reports."""
    log, errors, this_thread = logging.getLogger("tifffile"), list[str](), threading.get_ident()

    def collect(record: logging.LogRecord) -> bool:
        if record.levelno >= logging.ERROR and record.thread == this_thread:
            errors.append(record.getMessage())
        return False

    log.addFilter(collect)  # each call adds its own filter, since several threads may read
    try:
        yield errors
    finally:
        log.removeFilter(collect)
