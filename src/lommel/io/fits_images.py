"""FITS images and tables, plain or compressed by gzip or bzip2; their sizes are checked before they are decoded."""

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

_MOST_AXES = 16
_BLOCK, _MOST_HEADER = 2880, 2**20  # bytes; headers and data fill whole blocks (FITS standard 4.0, 3.1)
_SIZE = re.compile(rb"(BITPIX  |NAXIS\d* *|PCOUNT  |GCOUNT  )= +(-?\d{1,12})\b")
_END = re.compile(rb"^(?:.{80})*END {77}", re.DOTALL)
_TIMES = 4  # times the unpacked file: memory used while its values are read


Cards: TypeAlias = Mapping[str, Any]
"""A header: the values of its cards by name."""


class Image(NamedTuple):
    """An image, its header from the name of a card to its value, its number in the file, and the primary header."""

    values: Values
    header: Cards
    number: int = 0
    primary: Cards = {}  # noqa: RUF012 (never changed)


def write(images: Sequence[tuple[Values, Cards]]) -> bytes:
    """Return a FITS file; the values of cards may be pairs of value and comment."""
    from astropy.io import fits

    file = fits.HDUList()
    for values, cards in images:
        # Big-endian copies: astropy would swap the bytes of the caller's array.
        stored = values.astype(values.dtype.newbyteorder(">"))
        made = fits.ImageHDU(stored) if file else fits.PrimaryHDU(stored)
        for name, value in cards.items():
            made.header[name] = value
        made.add_checksum(when="of what follows")  # not of when it was written
        file.append(made)
    return atomic.contents(file.writeto)


def packed(write: Callable[..., bytes]) -> Callable[..., bytes]:
    """Return a function that writes the same, compressed, without a time stamp."""

    def made(*args: object) -> bytes:
        plain = write(*args)
        small = gzip.compress(plain, 6, mtime=0)
        return small if reading.affords(_TIMES * len(plain), len(small)) else gzip.compress(plain, 0, mtime=0)

    return made


def read(data: bytes, most: int) -> list[Image]:
    """Return the images of a file, with at most `most` values in all; ValueError if there is none."""
    from astropy.io import fits

    plain = _unpacked(data)
    found, total, primary = list[Image](), 0, Json()
    with warnings.catch_warnings():
        # Comments in other letters and cards that are not standard do no harm.
        warnings.simplefilter("ignore")
        warnings.filterwarnings("error", ".*truncated")
        # One after the other: the next begins where the sizes of the last say, which are checked first.
        with fits.open(io.BytesIO(plain), memmap=False, disable_image_compression=True) as file:
            for number, unit in enumerate(file):
                header, cards = unit.header, Json()
                for card in header.cards:
                    with suppress(Exception):  # of a card that nobody reads
                        cards[card.keyword] = card.value
                primary = primary or cards
                if header.get("XTENSION", "IMAGE").strip() != "IMAGE" or not header["NAXIS"]:
                    continue  # a table, or a header alone
                sides = [header[f"NAXIS{k + 1}"] for k in range(min(header["NAXIS"], _MOST_AXES))]
                total += math.prod(sides)
                if min(sides) < 1 or total > most or math.prod(sides) * abs(header["BITPIX"]) > 8 * len(plain):
                    raise ValueError(
                        f"it has {' x '.join(map(str, sides))} values, more than it holds or than {most}"
                    )
                values = np.asarray(unit.data, unit.data.dtype.newbyteorder("="))
                found.append(Image(values, cards, number, primary))
    if not found:
        raise ValueError("it holds no image; one in a compressed table (.fz) is to be unpacked first")
    return found


def only(images: Sequence[Image], name: str | None) -> Image:
    """Return the image of a name, a name and version as SCI,2, or a number, 0 being the primary; or the only one.

    ValueError where there is none, or more.
    """
    if name is None and len(images) == 1:
        return images[0]
    called = [str(image.header.get("EXTNAME", "")).strip().upper() for image in images]
    versions = [f"{own},{image.header.get('EXTVER', 1)}" for own, image in zip(called, images, strict=True)]
    asked = "" if name is None else name.upper().replace(" ", "")
    wanted = [
        image
        for image, own, version in zip(images, called, versions, strict=True)
        if asked and asked in (own, version, str(image.number))
    ]
    if len(wanted) == 1:
        return wanted[0]
    names = [
        own
        if own and called.count(own) == 1
        else version
        if own and versions.count(version) == 1
        else str(image.number)
        for image, own, version in zip(images, called, versions, strict=True)
    ]
    told = [f"[{own}] of {' x '.join(map(str, one.values.shape))}" for own, one in zip(names, images, strict=True)]
    listed = ", ".join(told[:4]) + (f" and {len(told) - 4} more" if len(told) > 4 else "")
    raise ValueError(f"it holds {len(images)} images, {listed}: name one, as in file.fits[{names[0]}]")


def read_columns(data: bytes, most: int) -> list[tuple[str, str, Values]]:
    """Return name, unit and numbers of the columns of the first table of a file; ValueError if there is none."""
    from astropy.io import fits

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", fits.verify.VerifyWarning)
        with fits.open(io.BytesIO(_unpacked(data)), memmap=False) as file:
            for unit in file:
                if unit.header.get("XTENSION", "").strip() not in ("BINTABLE", "TABLE"):
                    continue
                if unit.header["NAXIS1"] * unit.header["NAXIS2"] > most:
                    raise ValueError(f"its table has more than {most} bytes")
                found = [(c.name, (c.unit or "").strip(), np.asarray(unit.data[c.name])) for c in unit.columns]
                numbers = [each for each in found if each[2].ndim == 1 and each[2].dtype.kind in "fiu"]
                return [(name, of, values.astype(np.float64)) for name, of, values in numbers]
    raise ValueError("it holds no table")


def is_fits(data: bytes) -> bool:
    """Return whether data begin as a FITS file, or as one compressed by gzip or bzip2."""
    return data.startswith((b"SIMPLE  =", *PACKED_STARTS))


def _unpacked(data: bytes) -> bytes:
    """Return the contents of a file, unpacked as far as its headers say."""
    packed, parts, at = data.startswith(PACKED_STARTS), list[bytes](), 0
    source: io.BufferedIOBase = io.BytesIO(data)
    if packed:
        source = gzip.GzipFile(fileobj=source) if data.startswith(PACKED_STARTS[0]) else bz2.BZ2File(source)
    try:
        block = source.read(_BLOCK)
        if packed and not block.startswith(b"SIMPLE"):
            raise ValueError("what is packed in it is no FITS file; unpack it")
        while not at or block.startswith(b"XTENSION"):
            start, cards = at, dict[str, int]()
            while True:
                parts.append(block)
                at += _BLOCK
                for card in (block[k : k + 80] for k in range(0, _BLOCK, 80)):
                    if size := _SIZE.match(card):
                        cards[size[1].decode().strip()] = int(size[2])
                if _END.search(block):
                    break
                if len(block) < _BLOCK or at - start > _MOST_HEADER:
                    raise ValueError(f"a header of it has no END within {at - start} bytes")
                block = source.read(_BLOCK)
            sides = [abs(cards.get(f"NAXIS{k + 1}", 0)) for k in range(min(cards.get("NAXIS", 0), _MOST_AXES))]
            values = math.prod(sides) if sides else 0
            values = abs(cards.get("GCOUNT", 1)) * (abs(cards.get("PCOUNT", 0)) + values)
            count = -(-values * abs(cards.get("BITPIX", 8)) // 8 // _BLOCK) * _BLOCK
            at += count
            if packed:
                reading.afford(_TIMES * at, len(data))
                parts.append(source.read(count))
            else:
                source.seek(at)
            block = source.read(_BLOCK)
    except (OSError, EOFError, zlib.error) as error:
        raise ValueError(f"it cannot be unpacked: {error}") from None
    return b"".join(parts) if packed else data
