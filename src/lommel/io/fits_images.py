"""FITS images and tables, plain or compressed by gzip or bzip2.

A "unit" (HDU) of a file is a header with its data; a "card" is an entry of a header: keyword, value and comment.
"""

from __future__ import annotations

import bz2
import gzip
import io
import math
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


Cards: TypeAlias = Mapping[str, Any]
"""Values of the cards of a header by keyword."""


class Image(NamedTuple):
    """Values of an image, its header, its number in the file, the header of the first unit, and comments of both."""

    values: Values
    header: Cards
    number: int = 0
    primary: Cards = {}  # noqa: RUF012 (never changed)
    comments: dict[str, str] = {}  # noqa: RUF012 (never changed)


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
        unit.add_checksum(when="by lommel")  # a fixed comment instead of the time of writing
        file.append(unit)
    return atomic.contents(file.writeto)


def packed(write: Callable[..., bytes]) -> Callable[..., bytes]:
    """Return a function that compresses the result of `write` by gzip, without a time stamp."""
    return lambda *args: gzip.compress(write(*args), 6, mtime=0)


def read(data: bytes, max_values: int) -> list[Image]:
    """Return the images of a file; ValueError if it has no image, or more than `max_values` values in total."""
    from astropy.io import fits

    contents = _decompress(data)
    images, total, primary, primary_comments = list[Image](), 0, Json(), dict[str, str]()
    kinds = set[str]()
    with warnings.catch_warnings():
        # Ignore warnings about comments that are not ASCII and about cards that are not standard.
        warnings.simplefilter("ignore")
        warnings.filterwarnings("error", ".*truncated")
        # The sizes in each header are checked before its data are read.
        with fits.open(io.BytesIO(contents), memmap=False, disable_image_compression=True) as file:
            for number, unit in enumerate(file):
                header, cards, comments = unit.header, Json(), primary_comments.copy()
                kinds.add("packed" if header.get("ZIMAGE") else str(header.get("XTENSION", "IMAGE")).strip())
                for card in header.cards:
                    with suppress(Exception):  # an invalid card is skipped
                        cards[card.keyword], comments[card.keyword] = card.value, card.comment
                primary, primary_comments = primary or cards, primary_comments or comments
                if header.get("GROUPS") is True and header.get("NAXIS1") == 0:
                    raise ValueError(
                        "it holds random groups, which are not read: save the images as image extensions"
                    )
                if header.get("XTENSION", "IMAGE").strip() != "IMAGE" or not header["NAXIS"]:
                    continue  # a table, or a header without data
                sides = [header[f"NAXIS{k + 1}"] for k in range(min(header["NAXIS"], _MAX_AXES))]
                total += math.prod(sides)
                if (
                    min(sides) < 1
                    or total > max_values
                    or math.prod(sides) * abs(header["BITPIX"]) > 8 * len(contents)
                ):
                    count = " x ".join(map(str, sides))
                    raise ValueError(f"it states {count} values, more than the file holds or than {max_values}")
                values = np.asarray(unit.data, unit.data.dtype.newbyteorder("="))
                images.append(Image(values, cards, number, primary, comments))
    if not images:
        if "packed" in kinds:
            raise ValueError("it holds no image; unpack the image that is compressed in a table (.fz) first")
        raise ValueError(f"it holds no image, but {'tables only' if kinds - {'IMAGE'} else 'headers without data'}")
    return images


def only(images: Sequence[Image], name: str | None) -> Image:
    """Return the image selected by `name`: an EXTNAME, "EXTNAME,EXTVER", or a number, 0 for the first unit.

    Without a `name`, return the only image. ValueError if no image or more than one image fits.
    """
    names = []
    for image in images:
        extname = str(image.header.get("EXTNAME", "")).strip()
        versions = [extname, f"{extname},{image.header.get('EXTVER', 1)}"] if extname else []
        names.append([*versions, str(image.number)])
    sizes = [" x ".join(map(str, image.values.shape)) for image in images]
    return reading.only(images, names, sizes, name, "file.fits")


def read_columns(data: bytes, max_bytes: int) -> list[tuple[str, str, Values]]:
    """Return (name, unit, values) of the numeric columns of the first table of a file; ValueError if it has none."""
    from astropy.io import fits

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", fits.verify.VerifyWarning)
        try:
            units = fits.open(io.BytesIO(_decompress(data)), memmap=False)
        except OSError as error:
            raise ValueError(f"it is damaged: {error}") from None
        with units:
            for unit in units:
                if unit.header.get("XTENSION", "").strip() not in ("BINTABLE", "TABLE"):
                    continue
                if unit.header["NAXIS1"] * unit.header["NAXIS2"] > max_bytes:
                    raise ValueError(f"its table has more than {max_bytes} bytes")
                columns = [(c.name, (c.unit or "").strip(), np.asarray(unit.data[c.name])) for c in unit.columns]
                numeric = [column for column in columns if column[2].ndim == 1 and column[2].dtype.kind in "fiu"]
                return [(name, column_unit, values.astype(np.float64)) for name, column_unit, values in numeric]
    raise ValueError("it holds no table")


def may_be_fits(data: bytes) -> bool:
    """Return True if data begin like a FITS file, or like any file compressed by gzip or bzip2."""
    return data.startswith((b"SIMPLE  =", *PACKED_STARTS))


def _decompress(data: bytes) -> bytes:
    """Return the contents of a file."""
    try:
        if data.startswith(PACKED_STARTS[0]):
            data = gzip.decompress(data)
        elif data.startswith(PACKED_STARTS[1]):
            data = bz2.decompress(data)
    except (OSError, EOFError, ValueError, zlib.error) as error:
        raise ValueError(f"it cannot be decompressed: {error}") from None
    if not data.startswith(b"SIMPLE"):
        raise ValueError("it is not a FITS file; decompress it first")
    return data
