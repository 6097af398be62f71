"""What the file of a stranger may cost: looked up in its header before anything in it is decoded."""

from __future__ import annotations

import errno
import io
import logging
import math
import stat
import struct
import warnings
import zipfile
import zlib
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation

MAX_PIXELS = validation.MAX_SIDE**2
"""Most pixels of a picture, and most characters of a description."""

MAX_TEXT = 2**24
"""Most bytes of a lens file or a table."""

_HEADER = 2**16  # bytes; that of an array is a line
_TIFF_TYPES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 6: 1, 7: 1, 8: 2, 9: 4, 10: 8, 11: 4, 12: 8, 13: 4, 16: 8, 17: 8, 18: 8}
_DEFLATE = (8, 32946)
# Of these the size of what comes out is known, or at most 64 times that of what goes in.
_COMPRESSIONS = {1: "none", 5: "LZW", 8: "deflate", 32773: "PackBits", 32946: "deflate"}


def contents(path: Path, most: int = 8 * validation.MAX_VALUES + MAX_PIXELS) -> bytes:
    """Return the bytes of a file; OSError if it is no regular one, which a pipe or a device is not, or too large."""
    count = size(path)
    if count > most:
        raise OSError(errno.EFBIG, f"has {count} bytes; the limit is {most}", str(path))
    with path.open("rb") as file:
        return file.read(count)


def size(path: Path) -> int:
    """Return how many bytes a file has; OSError if it is no regular one."""
    status = path.stat()
    if stat.S_ISDIR(status.st_mode):
        raise IsADirectoryError(errno.EISDIR, "Is a directory", str(path))
    if not stat.S_ISREG(status.st_mode):
        raise OSError(errno.EINVAL, "is no regular file", str(path))
    return status.st_size


def text(path: Path) -> str:
    """Return a text in UTF-8 of at most :data:`MAX_TEXT` bytes; ValueError if it is another."""
    return decoded(contents(path, MAX_TEXT))


def decoded(data: bytes) -> str:
    """Return a text in UTF-8 with plain ends of lines; ValueError if it is another."""
    try:
        return data.decode("utf-8-sig").replace("\r\n", "\n").replace("\r", "\n")
    except UnicodeDecodeError as error:
        raise ValueError(f"not UTF-8 text: {error}") from None


def reason(error: Exception) -> str:
    """Return what an error says, which may be one of a library, on one line."""
    return validation.brief(" ".join(str(error).split()), 240) or type(error).__name__


def pixels(width: int, height: int) -> None:
    """Refuse a picture that is larger than any that this package makes."""
    if not 0 < width * height <= MAX_PIXELS:
        raise ValueError(f"it has {width} x {height} pixels; the limit is {MAX_PIXELS} in all")


def npy(data: bytes, most: int = validation.MAX_VALUES) -> tuple[NDArray[Any], bytes]:
    """Return the array of a .npy file, and what stands behind it."""
    start, shape, fortran, kind = _npy_header(data[:_HEADER], most)
    count = math.prod(shape)
    if start + count * kind.itemsize > len(data):
        raise ValueError(f"its values take {count * kind.itemsize} bytes, got {len(data) - start}")
    values = np.frombuffer(data, kind, count, start).reshape(shape, order="F" if fortran else "C").copy()
    return values, data[start + count * kind.itemsize :]


def _npy_header(data: bytes, most: int) -> tuple[int, tuple[int, ...], bool, np.dtype[Any]]:
    file = io.BytesIO(data)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            version = np.lib.format.read_magic(file)
            read = {1: np.lib.format.read_array_header_1_0, 2: np.lib.format.read_array_header_2_0}[version[0]]
            shape, fortran, kind = read(file)
    except Exception as error:  # of Python's own parser among others
        raise ValueError(f"its header is not that of an array: {str(error) or type(error).__name__}") from None
    if kind.hasobject:
        raise ValueError("it holds Python objects, a pickle")
    if min(shape, default=1) < 0 or math.prod(shape) * kind.itemsize > 8 * most:
        raise ValueError(f"it has {' x '.join(map(str, shape))} values of {kind}; the limit is {most}")
    return file.tell(), shape, fortran, kind


def npz(data: bytes) -> dict[str, Callable[[int], NDArray[Any]]]:
    """Return what reads the arrays of a .npz file, by name, each with a limit on its values."""

    def read(member: zipfile.ZipInfo, most: int) -> NDArray[Any]:
        with archive.open(member) as file:
            head = file.read(_HEADER)
            start, shape, _, kind = _npy_header(head, most)
            size = start + math.prod(shape) * kind.itemsize
            if size != member.file_size:
                raise ValueError(f"{validation.shown(member.filename)} takes {size} bytes, got {member.file_size}")
            return npy(head + file.read(), most)[0]

    archive = zipfile.ZipFile(io.BytesIO(data))
    members = {member.filename.removesuffix(".npy"): member for member in archive.infolist()}
    if any(member.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED) for member in members.values()):
        raise ValueError("it is compressed in an unknown way")
    return {name: partial(read, member) for name, member in members.items()}


def tiff(data: bytes) -> None:
    """Refuse a TIFF file whose pages are too large or whose tags and compressed parts claim more than it holds."""
    order = {b"II": "<", b"MM": ">"}.get(data[:2])
    if order is None or len(data) < 16:
        raise ValueError("its header is not that of a TIFF file")
    big = struct.unpack_from(f"{order}H", data, 2)[0] == 43
    seen: set[int] = set()
    (at,) = struct.unpack_from(f"{order}Q" if big else f"{order}I", data, 8 if big else 4)
    while at:
        if at in seen:
            raise ValueError("its pages run in a circle")
        seen.add(at)
        tags, at = _tiff_tags(data, at, order, big)
        _tiff_page(data, tags)
    if not seen:
        raise ValueError("it has no page")


def _tiff_tags(data: bytes, at: int, order: str, big: bool) -> tuple[dict[int, Sequence[int]], int]:
    """Return the integers that the tags of a page hold, and where the next page is."""
    tags: dict[int, Sequence[int]] = {}
    head, entry, word = ("Q", "HHQ", "Q") if big else ("H", "HHI", "I")
    try:
        (count,) = struct.unpack_from(order + head, data, at)
        at += struct.calcsize(head)
        inline = struct.calcsize(word)
        for _ in range(count):
            tag, kind, number = struct.unpack_from(order + entry, data, at)
            place, size = at + struct.calcsize("=" + entry), number * _TIFF_TYPES.get(kind, 1)
            if size > inline:
                (place,) = struct.unpack_from(order + word, data, place)
            if place + size > len(data):
                raise ValueError(f"its tag {tag} claims {size} bytes of a file of {len(data)}")
            code = {1: "B", 3: "H", 4: "I", 16: "Q"}.get(kind)
            if code and tag not in tags:
                tags[tag] = struct.unpack_from(f"{order}{number}{code}", data, place)
            at += struct.calcsize("=" + entry) + inline
        return tags, int(struct.unpack_from(order + word, data, at)[0])
    except struct.error:
        raise ValueError("its pages go beyond its end") from None


def _tiff_page(data: bytes, tags: dict[int, Sequence[int]]) -> None:
    def one(tag: int, default: int) -> int:
        return tags[tag][0] if tags.get(tag) else default

    width, height, samples = one(256, 0), one(257, 0), one(277, 1)
    pixels(width, height)
    compression, bits = one(259, 1), max(tags.get(258, (1,)), default=1)
    if one(32997, 1) != 1 or samples > 64 or bits > 64:
        raise ValueError(f"it has {samples} samples of {bits} bits a pixel, or pages of several layers")
    if compression not in _COMPRESSIONS:
        known = ", ".join(dict.fromkeys(_COMPRESSIONS.values()))
        raise ValueError(f"its compression is of the kind {compression}; save it with {known}")
    tiled = 322 in tags
    across, down = (one(322, 0), one(323, 0)) if tiled else (width, min(one(278, height), height))
    if across * down == 0 or across * down > max(4 * width * height, 2**20):
        raise ValueError(f"it has {width} x {height} pixels in parts of {across} x {down}")
    most = (across * samples * bits + 7) // 8 * down
    if compression == 1 and (width * samples * bits + 7) // 8 * height > len(data):
        raise ValueError(f"{width} x {height} pixels without compression are more than the file holds")
    parts = math.ceil(width / across) * math.ceil(height / down) * (samples if one(284, 1) == 2 else 1)
    places, sizes = (tags.get(324, ()), tags.get(325, ())) if tiled else (tags.get(273, ()), tags.get(279, ()))
    if len(places) < parts or (compression != 1 and len(sizes) < parts):
        raise ValueError(f"it has {min(len(places), len(sizes))} parts; {width} x {height} pixels take {parts}")
    for place, size in zip(places[:parts], sizes[:parts], strict=False):
        if compression in _DEFLATE and not _inflates_within(data[place : place + size], most):
            raise ValueError(f"a part of it inflates to more than its {most} bytes")


def _inflates_within(part: bytes, most: int) -> bool:
    try:
        return len(zlib.decompressobj().decompress(part, most + 1)) <= most
    except zlib.error:
        return True  # told where it is read


@contextmanager
def quietly() -> Iterator[None]:
    """Keep to itself what tifffile logs of damaged files, which an error tells."""
    log = logging.getLogger("tifffile")

    def nothing(_: logging.LogRecord) -> bool:
        return False

    log.addFilter(nothing)  # one for each who reads
    try:
        yield
    finally:
        log.removeFilter(nothing)
