"""Checksums of the arrays and the description of a file."""

from __future__ import annotations

import json
import zlib
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lommel.base import reading
from lommel.base.arrays import Json


def plain(description: Mapping[str, object]) -> Json:
    """Return a description as JSON holds it."""
    found: Json = json.loads(json.dumps(description))
    return found


def sealed(description: Json, arrays: Mapping[str, NDArray[np.generic]]) -> Json:
    """Return a description with the checksum of the arrays of a file and of all else that it says."""
    return description | {"checksum": checksum(description, arrays)}


def checksum(description: Mapping[str, object], arrays: Mapping[str, NDArray[np.generic]]) -> str:
    """Return the checksum of arrays by name, and of all that is said of them."""
    return f"crc32 {crc32(description, arrays):08x}"


def of_bytes(data: bytes) -> str:
    """Return the size and the checksum of what a file holds."""
    return f"{len(data)} bytes, crc32 {zlib.crc32(data):08x}"


def of_file(path: Path) -> str:
    """Return the size and the checksum of a file; OSError if there is none."""
    size, total = reading.size(path), 0  # lest it be a pipe
    with path.open("rb") as file:
        while part := file.read(2**20):
            total = zlib.crc32(part, total)
    return f"{size} bytes, crc32 {total:08x}"


def crc32(description: Mapping[str, object], arrays: Mapping[str, NDArray[np.generic]]) -> int:
    """Return the number of :func:`checksum`."""
    said = {key: value for key, value in description.items() if key != "checksum"}
    total = zlib.crc32(json.dumps(said, sort_keys=True, allow_nan=False).encode())
    for name in sorted(arrays):
        values = arrays[name]
        plain = np.ascontiguousarray(values, dtype=values.dtype.newbyteorder("<"))
        total = zlib.crc32(plain.data.cast("B") if plain.size else b"", zlib.crc32(name.encode(), total))
    return total
