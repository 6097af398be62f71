"""Zarr folders (version 3) with uncompressed chunks; no thread goes on after a call, and sizes are checked first.

Zarr core specification, version 3.0, https://zarr-specs.readthedocs.io/en/latest/v3/core/
"""

from __future__ import annotations

import json
import math
import stat
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Self

import numpy as np

from lommel.base import reading, validation
from lommel.io.registry import Description, Values

META = "zarr.json"
_KINDS = ("float32", "float64", "uint8", "int64")


def write_group(folder: Path, attributes: Mapping[str, Any]) -> None:
    """Write a group, a folder that holds arrays."""
    folder.mkdir(parents=True, exist_ok=True)
    _write_meta(folder, {"zarr_format": 3, "node_type": "group", "attributes": attributes})


def _write_meta(folder: Path, said: Mapping[str, Any]) -> None:
    (folder / META).write_text(json.dumps(said, indent=2, allow_nan=False), encoding="utf-8")


@dataclass(frozen=True)
class Layout:
    """An array cut into chunks: its shape, that of its chunks, its type ("<f4") and the names of its axes."""

    shape: tuple[int, ...]
    chunks: tuple[int, ...]
    dtype: str
    dimensions: tuple[str, ...] = field(default=(), compare=False)

    @property
    def grid(self) -> tuple[int, ...]:
        """Number of chunks along each axis."""
        return tuple(-(-n // c) for n, c in zip(self.shape, self.chunks, strict=True))

    def whole(self, index: tuple[int, ...]) -> tuple[int, ...]:
        """Return the index of a chunk along all axes, 0 along those beyond `index`."""
        return (*index, *(0,) * (len(self.shape) - len(index)))

    def within(self, index: tuple[int, ...]) -> tuple[slice, ...]:
        """Return the slices of a chunk in the array; axes beyond `index` are whole."""
        sides = zip(self.whole(index), self.chunks, self.shape, strict=True)
        return tuple(slice(i * c, min((i + 1) * c, n)) for i, c, n in sides)

    def first(self, index: tuple[int, ...]) -> int:
        """Return the index in the flattened array of the first value of a chunk."""
        place = tuple(part.start for part in self.within(index))
        return int(np.ravel_multi_index(place, self.shape)) if place else 0

    def part(self, index: tuple[int, ...]) -> tuple[int, ...]:
        """Return the shape of a chunk, smaller at the end of an axis."""
        return tuple(part.stop - part.start for part in self.within(index))

    @property
    def nbytes(self) -> int:
        """Bytes of all of it."""
        return math.prod(self.shape) * np.dtype(self.dtype).itemsize


@dataclass(frozen=True)
class ZarrArray:
    """An array in a folder, by chunks; those at the end of an axis are stored whole."""

    folder: Path
    layout: Layout
    separator: str = "."  # between the numbers of a chunk in its file name

    def create(
        self, *, fill: float = 0, attributes: Mapping[str, Any] | None = None, values: Values | None = None
    ) -> None:
        """Write the metadata of the array, of its group if that has none, and the chunks of the values, if given."""
        if not (self.folder.parent / META).exists():
            write_group(self.folder.parent, {})
        self.folder.mkdir()
        kind = np.dtype(self.layout.dtype)
        endian = {"configuration": {"endian": "little"}} if kind.itemsize > 1 else {}
        said = {
            "zarr_format": 3,
            "node_type": "array",
            "shape": self.layout.shape,
            "data_type": kind.name,
            "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": self.layout.chunks}},
            "chunk_key_encoding": {"name": "default", "configuration": {"separator": self.separator}},
            "fill_value": "NaN" if math.isnan(fill) else kind.type(fill).item(),
            "codecs": [{"name": "bytes"} | endian],
            "attributes": attributes or {},
            "dimension_names": self.layout.dimensions,
            "storage_transformers": [],
        }
        _write_meta(self.folder, said)
        if values is not None:
            for index in np.ndindex(*self.layout.grid):
                self.file(index).write_bytes(self.packed(values[self.layout.within(index)]))

    @classmethod
    def open(cls, folder: Path) -> Self:
        """Return the array in a folder; ValueError if it is stored in another way."""
        said = _meta(folder)
        kind, codecs = said["data_type"], said["codecs"]
        plain = len(codecs) == 1 and codecs[0]["name"] == "bytes" and not said.get("storage_transformers")
        keys = said["chunk_key_encoding"]
        plain = plain and codecs[0].get("configuration", {}).get("endian", "little") == "little"
        plain = plain and kind in _KINDS and keys["name"] == "default" and said["chunk_grid"]["name"] == "regular"
        separator = keys.get("configuration", {}).get("separator", "/")
        shape, chunks = said["shape"], said["chunk_grid"]["configuration"]["chunk_shape"]
        sides = all(type(n) is int and n > 0 for n in (*shape, *chunks)) and len(shape) == len(chunks)
        if not plain or separator not in (".", "/") or not sides:
            raise ValueError(f"its array {folder.name} is stored in another way; zarr reads it")
        return cls(folder, Layout(tuple(shape), tuple(chunks), np.dtype(kind).newbyteorder("<").str), separator)

    def file(self, index: tuple[int, ...]) -> Path:
        """Return the file of a chunk, the first one along axes that are not given."""
        return self.folder / self.separator.join(("c", *map(str, self.layout.whole(index))))

    def packed(self, part: Values) -> memoryview:
        """Return the bytes of a chunk, padded with zeros at the end of an axis."""
        if part.shape != self.layout.chunks:
            part = np.pad(part, [(0, c - n) for c, n in zip(self.layout.chunks, part.shape, strict=True)])
        return np.ascontiguousarray(part, self.layout.dtype).reshape(-1).data.cast("B")

    def get(self, index: tuple[int, ...]) -> Values:
        """Return a chunk; FileNotFoundError if it is missing, ValueError if its file has another size."""
        file, kind = self.file(index), np.dtype(self.layout.dtype)
        nbytes = math.prod(self.layout.chunks) * kind.itemsize
        if (size := _size(file)) != nbytes:
            raise ValueError(f"its chunk {file.name} takes {nbytes} bytes, got {size}")
        part = np.frombuffer(reading.contents(file, nbytes), kind).reshape(self.layout.chunks)
        return part[tuple(map(slice, self.layout.part(index)))]

    def read(self) -> Values:
        """Return the whole array; ValueError or OSError if it is too large or chunks are missing."""
        array = self.layout
        if math.prod(array.shape) > validation.MAX_VALUES:
            raise ValueError(
                f"it has {' x '.join(map(str, array.shape))} values; the limit is {validation.MAX_VALUES}"
            )
        if (held := sum(_size(self.file(index)) for index in np.ndindex(*array.grid))) < array.nbytes:
            raise ValueError(f"its values take {array.nbytes} bytes, plainly stored, got {held}")
        out = np.empty(array.shape, array.dtype)
        for index in np.ndindex(*array.grid):
            out[array.within(index)] = self.get(index)
        return out


def attributes(folder: Path) -> Description:
    """Return the attributes of a group."""
    found: Description = _meta(folder)["attributes"]
    return found


def _meta(folder: Path) -> Description:
    _size(folder / META)
    found: Description = reading.json(reading.contents(folder / META, reading.MAX_PIXELS))
    return found


def _size(path: Path) -> int:
    """Return the size of a file; ValueError for a link, which may lead anywhere."""
    status = path.lstat()
    if not stat.S_ISREG(status.st_mode):
        raise ValueError(f"{path.name} is no regular file")
    return status.st_size
