"""FITS images and tables, plain or compressed by gzip or bzip2; sizes are checked before any decoding.

A "card" is an entry of a FITS header: a keyword, a value and a comment.
"""

from __future__ import annotations

import bz2
import gzip
import io
import math
import re
import warnings
import zlib
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from lommel.base import atomic, reading
from lommel.base.arrays import Json, Values

SUFFIXES = (".fits", ".fit")
PACKED = (".fits.gz", ".fit.gz")
PACKED_STARTS = (b"\x1f\x8b", b"BZh")

_MAX_AXES = 16
_BLOCK, _MAX_HEADER = 2880, 2**20  # bytes; headers and data fill whole blocks (FITS standard 4.0, 3.1)
_SIZE_CARD = re.compile(rb"(BITPIX  |NAXIS\d* *|PCOUNT  |GCOUNT  )= +(-?\d{1,12})\b")
_END_CARD = re.compile(rb"^(?:.{80})*END {77}", re.DOTALL)
_FACTOR = 4  # memory for reading the values / size of the decompressed file


Cards: TypeAlias = Mapping[str, Any]
"""Values of the cards of a header by keyword."""


class Image(NamedTuple):
    """Values of an image, its header, its number in the file, and the header of the first unit of the file."""

    values: Values
    header: Cards
    number: int = 0
    primary: Cards = {}  # noqa: RUF012 (never changed)


def write(images: Sequence[tuple[Values, Cards]]) -> bytes:
    """Return the bytes of a FITS file; the value of a card may be a pair (value, comment)."""
    from astropy.io import fits

    file = fits.HDUList()
    for values, cards in images:
        # A big-endian copy, since astropy would swap the bytes of the caller's array.
        stored = values.astype(values.dtype.newbyteorder(">"))
        unit = fits.ImageHDU(stored) if file else fits.PrimaryHDU(stored)
        for name, value in cards.items():
            unit.header[name] = value
        unit.add_checksum(when="of what follows")  # a fixed comment instead of the time of writing
        file.append(unit)
    return atomic.contents(file.writeto)


def packed(write: Callable[..., bytes]) -> Callable[..., bytes]:
    """Return a function that compresses the result of `write` by gzip, without a time stamp."""

    def write_packed(*args: object) -> bytes:
        plain = write(*args)
        compressed = gzip.compress(plain, 6, mtime=0)
        # A file that this package would refuse to read, because it is compressed too much, is stored uncompressed.
        return (
            compressed if reading.affords(_FACTOR * len(plain), len(compressed)) else gzip.compress(plain, 0, mtime=0)
        )

    return write_packed


def read(data: bytes, most: int) -> list[Image]:
    """Return the images of a file; ValueError if it has no image, or more than `most` values in total."""
    from astropy.io import fits

    plain = _decompress(data)
    images, total, primary = list[Image](), 0, Json()
    with warnings.catch_warnings():
        # Ignore warnings about comments that are not ASCII and about cards that are not standard.
        warnings.simplefilter("ignore")
        warnings.filterwarnings("error", ".*truncated")
        # The sizes in each header are checked before its data are read.
        with fits.open(io.BytesIO(plain), memmap=False, disable_image_compression=True) as file:
            for number, unit in enumerate(file):
                header, cards = unit.header, Json()
                for card in header.cards:
                    with suppress(Exception):  # an invalid card is skipped
                        cards[card.keyword] = card.value
                primary = primary or cards
                if header.get("XTENSION", "IMAGE").strip() != "IMAGE" or not header["NAXIS"]:
                    continue  # a table, or a header without data
                sides = [header[f"NAXIS{k + 1}"] for k in range(min(header["NAXIS"], _MAX_AXES))]
                total += math.prod(sides)
                if min(sides) < 1 or total > most or math.prod(sides) * abs(header["BITPIX"]) > 8 * len(plain):
                    raise ValueError(
                        f"it states {' x '.join(map(str, sides))} values, more than the file holds or than {most}"
                    )
                values = np.asarray(unit.data, unit.data.dtype.newbyteorder("="))
                images.append(Image(values, cards, number, primary))
    if not images:
        raise ValueError("it holds no image; unpack an image that is compressed in a table (.fz) first")
    return images


def only(images: Sequence[Image], name: str | None) -> Image:
    """Return the image selected by `name`: an EXTNAME, "EXTNAME,EXTVER", or a number, 0 for the first unit.

    Without a `name`, return the only image. ValueError if no image or more than one image fits.
    """
    if name is None and len(images) == 1:
        return images[0]
    extnames = [str(image.header.get("EXTNAME", "")).strip().upper() for image in images]
    versions = [f"{own},{image.header.get('EXTVER', 1)}" for own, image in zip(extnames, images, strict=True)]
    key = "" if name is None else name.upper().replace(" ", "")
    fitting = [
        image
        for image, own, version in zip(images, extnames, versions, strict=True)
        if key and key in (own, version, str(image.number))
    ]
    if len(fitting) == 1:
        return fitting[0]
    names = [
        own
        if own and extnames.count(own) == 1
        else version
        if own and versions.count(version) == 1
        else str(image.number)
        for image, own, version in zip(images, extnames, versions, strict=True)
    ]
    texts = [f"[{own}] of {' x '.join(map(str, one.values.shape))}" for own, one in zip(names, images, strict=True)]
    listed = ", ".join(texts[:4]) + (f" and {len(texts) - 4} more" if len(texts) > 4 else "")
    raise ValueError(f"it holds {len(images)} images, {listed}: name one, as in file.fits[{names[0]}]")


def read_columns(data: bytes, most: int) -> list[tuple[str, str, Values]]:
    """Return (name, unit, values) of the numeric columns of the first table of a file; ValueError if it has none."""
    from astropy.io import fits

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", fits.verify.VerifyWarning)
        with fits.open(io.BytesIO(_decompress(data)), memmap=False) as file:
            for unit in file:
                if unit.header.get("XTENSION", "").strip() not in ("BINTABLE", "TABLE"):
                    continue
                if unit.header["NAXIS1"] * unit.header["NAXIS2"] > most:
                    raise ValueError(f"its table has more than {most} bytes")
                columns = [(c.name, (c.unit or "").strip(), np.asarray(unit.data[c.name])) for c in unit.columns]
                numeric = [each for each in columns if each[2].ndim == 1 and each[2].dtype.kind in "fiu"]
                return [(name, column_unit, values.astype(np.float64)) for name, column_unit, values in numeric]
    raise ValueError("it holds no table")


def is_fits(data: bytes) -> bool:
    """Return True if data begin like a FITS file, or like a file of any format compressed by gzip or bzip2."""
    return data.startswith((b"SIMPLE  =", *PACKED_STARTS))


def _decompress(data: bytes) -> bytes:
    """Return the contents of a file; a compressed file is decompressed up to the end that its headers imply."""
    packed, parts, at = data.startswith(PACKED_STARTS), list[bytes](), 0
    source: io.BufferedIOBase = io.BytesIO(data)
    if packed:
        source = gzip.GzipFile(fileobj=source) if data.startswith(PACKED_STARTS[0]) else bz2.BZ2File(source)
    try:
        block = source.read(_BLOCK)
        if packed and not block.startswith(b"SIMPLE"):
            raise ValueError("the compressed file is not a FITS file; decompress it first")
        while not at or block.startswith(b"XTENSION"):
            start, cards = at, dict[str, int]()
            while True:
                parts.append(block)
                at += _BLOCK
                for card in (block[k : k + 80] for k in range(0, _BLOCK, 80)):
                    if size := _SIZE_CARD.match(card):
                        cards[size[1].decode().strip()] = int(size[2])
                if _END_CARD.search(block):
                    break
                if len(block) < _BLOCK or at - start > _MAX_HEADER:
                    raise ValueError(f"one of its headers has no END within {at - start} bytes")
                block = source.read(_BLOCK)
            sides = [abs(cards.get(f"NAXIS{k + 1}", 0)) for k in range(min(cards.get("NAXIS", 0), _MAX_AXES))]
            values = math.prod(sides) if sides else 0
            values = abs(cards.get("GCOUNT", 1)) * (abs(cards.get("PCOUNT", 0)) + values)
            count = -(-values * abs(cards.get("BITPIX", 8)) // 8 // _BLOCK) * _BLOCK
            at += count
            if packed:
                reading.afford(_FACTOR * at, len(data))
                parts.append(source.read(count))
            else:
                source.seek(at)
            block = source.read(_BLOCK)
    except (OSError, EOFError, zlib.error) as error:
        raise ValueError(f"it cannot be decompressed: {error}") from None
    return b"".join(parts) if packed else data
