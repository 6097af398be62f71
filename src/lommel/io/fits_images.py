"""Images in FITS, plain or compressed by gzip: written with a header, decoded once their sizes are known."""

from __future__ import annotations

import gzip
import io
import math
import warnings
import zlib
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic, reading

SUFFIXES = (".fits", ".fit")
PACKED = (".fits.gz", ".fit.gz")

_GZIP = b"\x1f\x8b"
_MOST_AXES = 16


class Image(NamedTuple):
    """An image and its header, from the name of a card to its value."""

    values: NDArray[Any]
    header: Mapping[str, Any]


def write(images: Sequence[tuple[NDArray[Any], Mapping[str, Any]]]) -> bytes:
    """Return a FITS file; the values of cards may be pairs of value and comment."""
    from astropy.io import fits

    file = fits.HDUList()
    for values, cards in images:
        # In the order of the file: astropy would turn the bytes of the caller's own array.
        stored = values.astype(values.dtype.newbyteorder(">"))
        made = fits.ImageHDU(stored) if file else fits.PrimaryHDU(stored)
        for name, value in cards.items():
            made.header[name] = value
        made.add_checksum(when="of what follows")  # not of when it was written
        file.append(made)
    return atomic.contents(file.writeto)


def packed(write: Callable[..., bytes]) -> Callable[..., bytes]:
    """Return what writes the same, compressed, and the same bytes at any time of the day."""
    return lambda *args: gzip.compress(write(*args), 6, mtime=0)


def read(data: bytes, most: int) -> list[Image]:
    """Return the images of a file that have values, of at most so many in all; ValueError if there is none."""
    from astropy.io import fits

    plain = _inflated(data, 8 * most + reading.MAX_TEXT) if data.startswith(_GZIP) else data
    found, total = [], 0
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # of a file that is cut, say
        # But of comments in other letters, and cards that are not quite as they should be, nothing depends.
        warnings.filterwarnings("ignore", "non-ASCII characters")
        warnings.simplefilter("ignore", fits.verify.VerifyWarning)
        # One after the other: where the next begins follows from the sizes of the last, which are looked at first.
        with fits.open(io.BytesIO(plain), memmap=False, disable_image_compression=True) as file:
            for unit in file:
                header = unit.header
                if header.get("XTENSION", "IMAGE").strip() != "IMAGE" or not header["NAXIS"]:
                    continue  # a table, or a header alone
                sides = [header[f"NAXIS{k + 1}"] for k in range(min(header["NAXIS"], _MOST_AXES))]
                total += math.prod(sides)
                if min(sides) < 1 or total > most or math.prod(sides) * abs(header["BITPIX"]) > 8 * len(plain):
                    raise ValueError(
                        f"it has {' x '.join(map(str, sides))} values, more than it holds or than {most}"
                    )
                found.append(Image(np.asarray(unit.data, unit.data.dtype.newbyteorder("=")), _cards(header)))
    if not found:
        raise ValueError("it holds no image; one in a compressed table (.fz) is to be unpacked first")
    return found


def _cards(header: Any) -> dict[str, Any]:
    found = {}
    for card in header.cards:
        with suppress(Exception):  # of a card that is never asked for
            found[card.keyword] = card.value
    return found


def _inflated(data: bytes, most: int) -> bytes:
    try:
        plain = zlib.decompressobj(31).decompress(data, most + 1)
    except zlib.error as error:
        raise ValueError(f"it cannot be unpacked: {error}") from None
    if len(plain) > most:
        raise ValueError(f"it unpacks to more than {most} bytes")
    return plain
