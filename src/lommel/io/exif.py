"""EXIF of photographs: the lens data in it, and what of it is passed on to files made of a photograph."""

from __future__ import annotations

import math
import struct
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from lommel.base import validation

PREFIX = b"Exif\0\0"
"""What JPEG has before EXIF."""

Entry = tuple[int, int, bytes]  # type, number of values, and the values with their low bytes first
Directory = dict[int, Entry]

_FILM_DIAGONAL = math.hypot(36e-3, 24e-3)
_BYTES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 6: 1, 7: 1, 8: 2, 9: 4, 10: 8, 11: 4, 12: 8, 129: 1}  # of a value, by type
_WORDS = {3: "u2", 8: "u2", 12: "u8", **dict.fromkeys((4, 5, 9, 10, 11), "u4")}  # that have an order of bytes
_LONGEST, _MOST, _LARGEST = 2**12, 256, 2**16 - 256  # bytes of an entry, entries, and bytes of all, as JPEG holds
_LENS, _PLACE = 0x8769, 0x8825  # directories below the first
_KEPT = (0x010F, 0x0110, 0x0132, 0x013B, 0x8298)  # make, model, date, artist, copyright
# Maker's notes name places in the file; the others describe the pixels that were.
_LEFT = {_LENS: (0x927C, 0xA001, 0xA002, 0xA003, 0xA005), _PLACE: ()}


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
    block : bytes or None
        What :func:`lommel.imaging.write_photo` writes of it: camera, lens, exposure, dates, place, artist and
        copyright; without orientation, thumbnail and maker's notes.
    """

    focal_length: float | None = None
    f_number: float | None = None
    film_focal_length: float | None = None
    block: bytes | None = field(default=None, repr=False, compare=False)

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


def parsed(tags: dict[int, Any], stored: bytes | None) -> Exif:
    """Return the EXIF of the tags of its directory of the lens, and of its bytes in a file."""

    def known(tag: int) -> float | None:
        value = tags.get(tag)
        number = math.nan if value is None else float(value)
        return number if 0.0 < number < math.inf else None

    focal, film = known(0x920A), known(0xA405)
    return Exif(focal and 1e-3 * focal, known(0x829D), film and 1e-3 * film, stored and _kept(stored))


def _kept(stored: bytes) -> bytes | None:
    """Return what is passed on of EXIF, or of a TIFF file, as a TIFF file without image; None if that is nothing."""
    data = stored.removeprefix(PREFIX)
    order = {b"II*\0": "<", b"MM\0*": ">"}.get(data[:4])
    if order is None or len(data) < 8:
        return None
    (at,) = struct.unpack_from(order + "I", data, 4)
    first = _directory(data, at, order)
    below = {
        tag: {name: entry for name, entry in _below(data, first, tag, order).items() if name not in left}
        for tag, left in _LEFT.items()
    }
    block = _block({tag: first[tag] for tag in _KEPT if tag in first}, below, 8)
    return b"II*\0" + struct.pack("<I", 8) + block if 6 < len(block) <= _LARGEST else None


def _directory(data: bytes, at: int, order: str) -> Directory:
    """Return the entries of a directory, without those that are damaged or long."""
    found: Directory = {}
    (count,) = struct.unpack_from(order + "H", data, at) if at + 2 <= len(data) else (0,)
    for entry in range(at + 2, min(at + 2 + 12 * min(count, _MOST), len(data) - 11), 12):
        tag, kind, number, place = struct.unpack_from(order + "HHII", data, entry)
        size = number * _BYTES.get(kind, 0)
        place = entry + 8 if size <= 4 else place
        if 0 < size <= _LONGEST and place + size <= len(data):
            word = _WORDS.get(kind, "u1")
            values = np.frombuffer(data[place : place + size], order + word)
            found[tag] = kind, number, values.astype("<" + word).tobytes()
    return found


def _below(data: bytes, first: Directory, tag: int, order: str) -> Directory:
    """Return the directory to which an entry of the first one points."""
    return _directory(data, int.from_bytes(first[tag][2][:4], "little"), order) if tag in first else {}


def _block(first: Directory, below: dict[int, Directory], at: int) -> bytes:
    """Return a directory at a place in a file and those below it, which it points to."""
    below = {tag: part for tag, part in below.items() if part}
    behind = at + len(_packed(first | dict.fromkeys(below, (4, 1, bytes(4))), at))
    parts = b""
    for tag, part in below.items():
        first = first | {tag: (4, 1, struct.pack("<I", behind + len(parts)))}
        parts += _packed(part, behind + len(parts))
    return _packed(first, at) + parts


def _packed(found: Directory, at: int) -> bytes:
    """Return a directory at a place in a file, and behind it the values that it has no room for."""
    head, rest = struct.pack("<H", len(found)), b""
    behind = at + 6 + 12 * len(found)
    for tag, (kind, number, values) in sorted(found.items()):
        place = values.ljust(4, b"\0")
        if len(values) > 4:
            place = struct.pack("<I", behind + len(rest))
            rest += values + bytes(len(values) % 2)
        head += struct.pack("<HHI", tag, kind, number) + place
    return head + bytes(4) + rest


def in_tiff(file: bytes, block: bytes) -> bytes:
    """Return a TIFF file of one page and low bytes first with EXIF: its directory is written anew at the end."""
    (at,) = struct.unpack_from("<I", file, 4)
    (count,) = struct.unpack_from("<H", file, at)
    rows = (struct.unpack_from("<HHI4s", file, at + 2 + 12 * k) for k in range(count))
    own: Directory = {tag: (kind, number, place) for tag, kind, number, place in rows}
    file += bytes(len(file) % 2)
    first = _directory(block, 8, "<")
    below = {tag: _below(block, first, tag, "<") for tag in _LEFT}
    return file[:4] + struct.pack("<I", len(file)) + file[8:] + _block(first | own, below, len(file))
