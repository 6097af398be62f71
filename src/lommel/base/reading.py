"""Reading and parsing of files, with checks of the sizes that their headers state."""

from __future__ import annotations

import errno
import io
import logging
import math
import re
import stat
import struct
import threading
import warnings
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from importlib.util import find_spec
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any, TypeVar, cast
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Json, Values
from lommel.base.optional import library

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

    from h5py import Dataset, File, Group
    from PIL.TiffImagePlugin import TiffImageFile
    from tifffile import TiffFile, TiffFrame, TiffPage, TiffPageSeries

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

_LZW = 5  # code of the compression LZW in TIFF files
_PART = re.compile(r"(?P<file>.+)\[(?P<part>[^\[\]]+)\]")
_Item = TypeVar("_Item")


def part_of(path: Path) -> tuple[Path, str | None]:
    """Split file.fits[SCI] into the path of the file and the name or number of an image, or None."""
    match = None if path.exists() else _PART.fullmatch(str(path))
    return (Path(match["file"]), match["part"]) if match and Path(match["file"]).exists() else (path, None)


def only(
    items: Sequence[_Item], names: Sequence[Sequence[str]], sizes: Sequence[str], part: str | None, file: str
) -> _Item:
    """Return the image of a file that is named `part`, without it the only image.

    Each image has several `names`, of which the last is its number or path, and a size as text. ValueError with the
    names of all images if no image or more than one has the name; `file` is the name of the file there.
    """
    keys = [[_key(name) for name in each] for each in names]
    fitting = [item for item, each in zip(items, keys, strict=True) if part and _key(part) == each[-1]]
    fitting = fitting or [item for item, each in zip(items, keys, strict=True) if part is None or _key(part) in each]
    if len(fitting) == 1:
        return fitting[0]
    listed, first = listing(names, sizes)
    raise ValueError(f"it holds {len(items)} image{'s' * (len(items) != 1)}, {listed}: name one, as in {file}{first}")


def listing(names: Sequence[Sequence[str]], sizes: Sequence[str]) -> tuple[str, str]:
    """Return the images of a file as text, by the first name of each that is unique, and the first of these names."""
    counts = Counter(key for each in names for key in {_key(name) for name in each})
    unique = [
        next((f"[{n}]" for n in each[:-1] if n and counts[_key(n)] == 1 and "[" not in n), f"[{each[-1]}]")
        for each in names
    ]
    texts = [f"{name} of {size}" if size else name for name, size in zip(unique, sizes, strict=True)]
    return ", ".join(texts[:4]) + f" and {len(texts) - 4} more" * (len(texts) > 4), unique[0]


def _key(name: str) -> str:
    return name.upper().replace(" ", "")


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
    try:
        return tomllib.loads(text)
    except (RecursionError, MemoryError) as error:
        raise ValueError(f"its tables are too many or too deep ({type(error).__name__})") from None


def json(data: bytes | str, pairs: Callable[[list[tuple[str, object]]], object] | None = None) -> Any:
    """Parse a JSON text; ValueError if it is not valid, or nested too deeply."""
    from json import loads

    try:
        return loads(data, object_pairs_hook=pairs)
    except (RecursionError, MemoryError) as error:
        raise ValueError(f"its objects are too many or too deep ({type(error).__name__})") from None


def xml(text: str) -> Element:
    """Return the root element of an XML text; ValueError if it is not valid."""
    from xml.etree import ElementTree as ET

    try:
        return ET.fromstring(text)
    except ET.ParseError as error:
        raise ValueError(f"it is no XML: {error}") from None


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
    file = io.BytesIO(data)
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # NumPy issues warnings for obsolete formats of the header
        values = np.lib.format.read_array(file, allow_pickle=False)
    if values.size > limit:
        raise ValueError(f"it has {' x '.join(map(str, values.shape))} values; the limit is {limit}")
    return values, file.read()


HEIC = tuple(
    struct.pack(">I", size) + b"ftyp" + brand
    for size in range(16, 68, 4)
    for brand in (b"heic", b"heix", b"mif1", b"msf1")
)
"""The first bytes of HEIC files."""


def pillow(kind: str, data: bytes) -> Any:
    """Return a picture opened by Pillow, not yet decoded; `kind` is Png, Jpeg, Bmp or Heif."""
    # Image.open is not used: its limit against decompression bombs would refuse large pictures of this package.
    if kind == "Heif":
        module = library("pillow_heif.as_plugin", "HEIC files need", "heic")
    else:
        module = library(f"PIL.{kind}ImagePlugin", "pictures need", "images")
    file = getattr(module, f"{kind}ImageFile")(io.BytesIO(data))
    pixels(*file.size)
    return file


@contextmanager
def tiff(data: bytes) -> Iterator[TiffFile]:
    """Open a TIFF file with tifffile; ValueError if a page is too large, or states more data than the file holds."""
    import tifffile

    with quietly(), tifffile.TiffFile(io.BytesIO(data)) as file:
        for page in file.pages:
            _require_held(page)
        yield file


def tiff_on_disk(path: Path) -> tuple[TiffFile, list[str]]:
    """Return a TIFF file of any size, opened by tifffile, and the errors that tifffile logged.

    Pages are not checked here: :func:`tiff_values` checks each when it is read.
    """
    import tifffile

    with quietly() as errors:
        file = tifffile.TiffFile(path)
        try:
            # Of frames written one by one, each described as an image of its own, tifffile compares all with all.
            pages: list[Any] = list(file.pages[:2])
            if len(pages) > 1 and all(page.is_shaped and page.shape == pages[0].shape for page in pages):
                file.close()
                file = tifffile.TiffFile(path, is_shaped=False)
            try:
                file.series  # noqa: B018 (finds the pages)
            except RuntimeError:  # tifffile takes pages for equal of which it has compared a few
                file.close()
                file = tifffile.TiffFile(path, is_shaped=False, is_uniform=False)
                file.series  # noqa: B018
        except BaseException:
            file.close()
            raise
    return file, errors


def _require_held(page: Any) -> None:
    """Raise ValueError for a page that is too large or lacks data."""
    kind, sizes = page.keyframe, page.databytecounts
    pixels(kind.imagewidth, kind.imagelength)
    if len(page.dataoffsets) < math.prod(kind.chunked) or len(sizes) < len(page.dataoffsets):
        raise ValueError(f"it has {len(sizes)} of {math.prod(kind.chunked)} strips or tiles")
    decoded_size = kind.size * kind.bitspersample // 8
    if kind.compression == 1 and sum(sizes) < decoded_size:
        raise ValueError(f"its values take {decoded_size} bytes, got {sum(sizes)}")


def tiff_values(page: Any, shape: tuple[int, ...], dtype: np.dtype[np.generic]) -> Values:
    """Return the values of a page; ValueError unless it has the `shape` and `dtype` of the first page.

    All pages share the handle of the file, so that only one thread at a time may read them.
    """
    kind, handle = page.keyframe, page.parent.filehandle
    if kind.size != math.prod(shape) or np.dtype(kind.dtype).newbyteorder("=") != dtype.newbyteorder("="):
        sides = " x ".join(map(str, kind.shape))
        raise ValueError(f"it has {sides} values of {kind.dtype}, not {' x '.join(map(str, shape))} of {dtype}")
    _require_held(page)
    closed = handle.closed  # an image may consist of more files than can be open simultaneously
    if closed:
        handle.open()
    try:
        return tiff_array(page).reshape(shape)
    finally:
        if closed:
            handle.close()


def tiff_array(page: TiffPage | TiffFrame) -> Values:
    """Return the values of a page; ValueError if neither tifffile nor, for LZW, Pillow can decode it."""
    if page.compression != _LZW or find_spec("imagecodecs"):
        try:
            return np.asarray(page.asarray())
        except (NotImplementedError, ValueError) as error:  # such as of 12 packed bits, or a compression
            if "imagecodecs" not in str(error) or find_spec("imagecodecs"):
                raise
            raise ValueError(f"{reason(error)}: pip install imagecodecs") from None
    from PIL.TiffImagePlugin import TiffImageFile

    values, dtype = np.empty(0), np.dtype(page.dtype).newbyteorder("=")
    try:
        if (image := _PILLOW_IMAGES.get(page.parent)) is None:
            page.parent.filehandle.seek(0)
            image = _PILLOW_IMAGES[page.parent] = TiffImageFile(cast("IO[bytes]", page.parent.filehandle))
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


def is_raw(source: Path | bytes) -> bool:
    """Return True for a TIFF file of a raw photograph: a DNG, a mosaic, or a file whose first page is a preview."""
    import tifffile

    with quietly(), tifffile.TiffFile(io.BytesIO(source) if isinstance(source, bytes) else source) as file:
        page = file.pages.first
        is_mosaic = page.photometric in (tifffile.PHOTOMETRIC.CFA, tifffile.PHOTOMETRIC.LINEAR_RAW)
        is_preview = page.is_reduced or any(part.size > page.size for part in page.pages or ())
        file.filehandle.seek(8)
        return bool(is_mosaic or is_preview or "DNGVersion" in page.tags or file.filehandle.read(2) == b"CR")


def require_whole(data: bytes) -> None:
    """Raise ValueError if strips or tiles of a TIFF file, such as a raw photograph, end beyond the file."""
    import tifffile

    ends = list[int]()
    with suppress(Exception), quietly(), tifffile.TiffFile(io.BytesIO(data)) as file:
        for page in list(file.pages):
            for part in (page, *(page.pages or ())):
                ends += [start + count for start, count in zip(part.dataoffsets, part.databytecounts, strict=True)]
    if max(ends, default=0) > len(data):
        raise ValueError(f"it is cut off: it has {len(data)} bytes, and states {max(ends)}")


def hdf5(data: bytes) -> File:
    """Return an HDF5 file opened by h5py; :func:`hdf5_values` reads its arrays."""
    import h5py

    return h5py.File(io.BytesIO(data), "r")


def hdf5_values(array: Dataset | Group | None) -> NDArray[np.generic]:
    """Return an array of an HDF5 file; ValueError if it is in another file, which may be missing, or too large."""
    import h5py

    if not isinstance(array, h5py.Dataset) or array.external or array.is_virtual or array.dtype.kind not in "iufS":
        raise ValueError("it must be an array of numbers in the file itself")
    if array.size > validation.MAX_VALUES:
        raise ValueError(f"it has {array.size} values; the limit is {validation.MAX_VALUES}")
    return np.asarray(array[()])


@contextmanager
def quietly() -> Iterator[list[str]]:
    """Suppress tifffile's log; yield the list of errors that this thread logs, which the caller reports."""
    log, errors, this_thread = logging.getLogger("tifffile"), list[str](), threading.get_ident()

    def collect(record: logging.LogRecord) -> bool:
        if record.levelno >= logging.ERROR and record.thread == this_thread:
            errors.append(record.getMessage())
        return False

    log.filters.insert(0, collect)  # each call adds its own filter, since several threads may read; the last is first
    try:
        yield errors
    finally:
        log.removeFilter(collect)
