"""Zarr folders: written for all readers, and those of others checked before zarr reads their chunks.

Zarr core specification, version 3.0, https://zarr-specs.readthedocs.io/en/latest/v3/core/
"""

from __future__ import annotations

import itertools
import json
import math
import os
import re
import stat
import struct
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from lommel.base import reading, validation
from lommel.base.arrays import Json, Values
from lommel.base.validation import shown
from lommel.io.registry import Description

if TYPE_CHECKING:
    from zarr.abc.store import ByteRequest
    from zarr.core.buffer import Buffer, BufferPrototype


# Of these it is known how much comes out of them; the others do not compress.
_PACKERS = ("blosc", "gzip", "lz4", "zlib", "zstd")
_PLAIN = ("bytes", "endian", "transpose", "crc32c", "crc32", "adler32", "fletcher32", "shuffle", "delta", "astype",
          "fixedscaleoffset", "bitround", "quantize")  # fmt: skip
_ROOM = 2**20  # bytes that a chunk may unpack to beyond its contents
_BLOCK = 2**17  # largest block of zstd, bytes (RFC 8878, 3.1.1.2.4)
_CHUNK = re.compile(r"c|c?[./]?\d+([./]\d+)*")


def regular(root: Path, key: str) -> int | None:
    """Return the bytes of a file in a folder, None without one; ValueError for links and for what is not a file."""
    there = root
    parts = key.split("/")
    if ".." in parts or key.startswith("/"):
        raise ValueError(f"{shown(key)} leads out of the folder")
    for part in parts:
        there = there / part
        try:
            status = there.lstat()
        except (FileNotFoundError, NotADirectoryError):
            return None
        _no_link(key, status.st_mode)
    return status.st_size if stat.S_ISREG(status.st_mode) else None


def _no_link(key: str, mode: int) -> None:
    if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
        kind = "a link, which is not followed" if stat.S_ISLNK(mode) else "no regular file"
        raise ValueError(f"{key} is {kind}")


def store(root: Path) -> Any:
    """Return a folder as a zarr store that reads only regular files in it."""
    from zarr.storage import LocalStore

    class Regular(LocalStore):
        async def get(
            self, key: str, prototype: BufferPrototype | None = None, byte_range: ByteRequest | None = None
        ) -> Buffer | None:
            return None if regular(root, key) is None else await super().get(key, prototype, byte_range)

        async def get_partial_values(
            self, prototype: BufferPrototype, key_ranges: Iterable[tuple[str, ByteRequest | None]]
        ) -> list[Buffer | None]:
            wanted = list(key_ranges)
            for key, _ in wanted:
                regular(root, key)
            return await super().get_partial_values(prototype, wanted)

        def get_sync(
            self, key: str, *, prototype: BufferPrototype | None = None, byte_range: ByteRequest | None = None
        ) -> Buffer | None:
            found = regular(root, key) is not None
            return super().get_sync(key, prototype=prototype, byte_range=byte_range) if found else None

    return Regular(root, read_only=True)


class Chunks:
    """The files of a zarr array in a folder."""

    def __init__(self, root: Path, array: Any) -> None:
        self._folder, self._array = root / array.path, array
        self._outer: tuple[int, ...] = array.shards or array.chunks
        self._bytes = math.prod(array.chunks) * array.dtype.itemsize
        self._packer, self._index = _packer(array.metadata)

    def missing(self) -> tuple[int, int]:
        """Return how many chunks have no file, and how many there are; ValueError for links and pipes."""
        total = math.prod(math.ceil(side / part) for side, part in zip(self._array.shape, self._outer, strict=True))
        found, folders = 0, [self._folder]
        while folders:
            with os.scandir(folders.pop()) as entries:
                for entry in entries:
                    _no_link(os.path.relpath(entry.path, self._folder), entry.stat(follow_symlinks=False).st_mode)
                    if entry.is_dir(follow_symlinks=False):
                        folders.append(Path(entry.path))
                    elif _CHUNK.fullmatch(entry.name):
                        found += 1
        return max(0, total - found), total

    def check(self, ranges: list[range]) -> tuple[int, int]:
        """Return how many bytes places along each axis take, and the files of their chunks.

        ValueError for a chunk that unpacks to more than it should, or than its file may.
        """
        sides = [
            range(part.start // outer, -(-part.stop // outer))
            for part, outer in zip(ranges, self._outer, strict=True)
        ]
        held = 0
        for at in itertools.product(*sides):
            key = self._array.metadata.encode_chunk_key(at)
            if count := regular(self._folder, key):
                held += count
                reading.afford(self._bytes, count)
                self._unpacks(key)
        return math.prod(map(len, ranges)) * self._array.dtype.itemsize, held

    def _unpacks(self, key: str) -> None:
        if self._packer is None:
            return
        data = reading.contents(self._folder / key)
        for part in self._parts(data) if self._array.shards else (data,):
            if self._packer == "blosc" and (len(part) < 16 or struct.unpack_from("<I", part, 12)[0] > len(part)):
                raise ValueError(f"its chunk {key} is cut off: it ends before it says")  # Blosc would read on
            if _unpacked(self._packer, part, self._bytes + _ROOM) > 2 * self._bytes + _ROOM:
                raise ValueError(f"its chunk {key} unpacks to more than its {self._bytes} bytes")

    def _parts(self, data: bytes) -> Iterator[bytes]:
        """Yield the chunks in a shard, by the index at its end or start, of offsets and lengths."""
        count = math.prod(outer // inner for outer, inner in zip(self._outer, self._array.chunks, strict=True))
        if len(data) < 16 * count:
            raise ValueError(f"its shards of {len(data)} bytes have no index of {count} chunks")
        start = 0 if self._index == "start" else max(0, len(data) - 16 * count - 4)
        for place, size in struct.iter_unpack("<QQ", data[start : start + 16 * count]):
            if place != 2**64 - 1:
                yield data[place : place + size]


def _packer(metadata: Any) -> tuple[str | None, str]:
    """Return the compressors of an array, and where its shards have their index."""
    index = "end"
    codecs = list(getattr(metadata, "codecs", ()))
    if len(codecs) == 1 and codecs[0].to_dict()["name"] == "sharding_indexed":
        inner = codecs[0]
        index, codecs = str(inner.index_location.value), list(inner.codecs)
        if [one.to_dict()["name"] for one in inner.index_codecs] != ["bytes", "crc32c"]:
            raise ValueError("its shards have an index of another kind")
    names = [str(one.to_dict()["name"]).removeprefix("numcodecs.") for one in codecs]
    older = [*(getattr(metadata, "filters", None) or ()), getattr(metadata, "compressor", None)]
    names += [one.codec_id for one in older if one is not None]
    packers = [name for name in names if name not in _PLAIN]
    if len(packers) > 1 or any(name not in _PACKERS for name in packers):
        raise ValueError(
            f"its chunks are compressed by {', '.join(packers)}; save it with one of {', '.join(_PACKERS)}"
        )
    return (packers[0] if packers else None), index


def _unpacked(packer: str, data: bytes, most: int) -> int:
    """Return the most bytes that a chunk unpacks to; 0 for damaged ones, which the decoder reports."""
    try:
        if packer == "blosc":
            return int(struct.unpack_from("<I", data, 4)[0])
        if packer == "lz4":
            return int(struct.unpack_from("<I", data)[0])
        if packer == "zstd":
            return _of_zstd(data)
    except struct.error:
        return 0
    return 0 if reading.inflates_within(data, most, wbits=47) else 3 * most


def _of_zstd(data: bytes) -> int:
    """Return what the frames of zstd unpack to at most (RFC 8878, 3.1.1)."""
    total, at = 0, 0
    while at + 4 < len(data) and data[at : at + 4] == b"\x28\xb5\x2f\xfd":
        flags = data[at + 4]
        single, kind = flags >> 5 & 1, flags >> 6
        width = (single, 2, 4, 8)[kind]
        at += 5 + (1 - single) + (0, 1, 2, 4)[flags & 3]
        stated = int.from_bytes(data[at : at + width], "little") + (256 if width == 2 else 0)
        at, blocks, last = at + width, 0, False
        while not last:
            (head,) = struct.unpack_from("<I", data[at : at + 3].ljust(4, b"\0") if at + 3 <= len(data) else b"")
            last, of, size = bool(head & 1), head >> 1 & 3, head >> 3
            blocks += size if of < 2 else _BLOCK
            at += 3 + (1 if of == 1 else size)
        at += 4 * (flags >> 2 & 1)
        total += stated if width else blocks
    return total


META = "zarr.json"
_KINDS = ("float32", "float64", "uint8", "int64")


def write_group(folder: Path, attributes: Json) -> None:
    """Write a group, a folder that holds arrays."""
    folder.mkdir(parents=True, exist_ok=True)
    _write_meta(folder, {"zarr_format": 3, "node_type": "group", "attributes": attributes})


def _write_meta(folder: Path, said: Json) -> None:
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
        """Size in bytes."""
        return math.prod(self.shape) * np.dtype(self.dtype).itemsize


@dataclass(frozen=True)
class ZarrArray:
    """An array in a folder, by chunks; those at the end of an axis are stored whole."""

    folder: Path
    layout: Layout
    separator: str = "."  # between the numbers of a chunk in its file name

    def create(self, *, fill: float = 0, attributes: Json | None = None, values: Values | None = None) -> None:
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
