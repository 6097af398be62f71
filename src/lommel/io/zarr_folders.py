"""Zarr folders: plain arrays written and read without zarr, and checks of foreign folders before zarr reads them.

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


# Compressors for which the decompressed size can be bounded before a chunk is decompressed into memory. Otherwise a
# malicious chunk of a few bytes could decompress to gigabytes.
_COMPRESSORS = ("blosc", "gzip", "lz4", "zlib", "zstd")
# Filters and checksums, which do not compress.
_FILTERS = ("bytes", "endian", "transpose", "crc32c", "crc32", "adler32", "fletcher32", "shuffle", "delta", "astype",
            "fixedscaleoffset", "bitround", "quantize")  # fmt: skip
_MARGIN = 2**20  # bytes by which a decompressed chunk may exceed its nominal size
_ZSTD_BLOCK = 2**17  # largest decompressed block of zstd, bytes (RFC 8878, 3.1.1.2.4)
_CHUNK = re.compile(r"c|c?[./]?\d+([./]\d+)*")  # last component of the path of a chunk file


def regular(root: Path, key: str) -> int | None:
    """Return the size in bytes of the file `key` in a folder; None if it does not exist or is a folder.

    ValueError for a link, a special file or a path that leads out of the folder.
    """
    path = root
    parts = key.split("/")
    if ".." in parts or key.startswith("/"):
        raise ValueError(f"{shown(key)} leads out of the folder")
    for part in parts:
        path = path / part
        try:
            status = path.lstat()
        except (FileNotFoundError, NotADirectoryError):
            return None
        _require_regular(key, status.st_mode)
    return status.st_size if stat.S_ISREG(status.st_mode) else None


def _require_regular(key: str, mode: int) -> None:
    """Raise ValueError unless `mode` is the mode of a regular file or a folder; `key` is the name in messages."""
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
            ranges = list(key_ranges)
            for key, _ in ranges:
                regular(root, key)
            return await super().get_partial_values(prototype, ranges)

        def get_sync(
            self, key: str, *, prototype: BufferPrototype | None = None, byte_range: ByteRequest | None = None
        ) -> Buffer | None:
            exists = regular(root, key) is not None
            return super().get_sync(key, prototype=prototype, byte_range=byte_range) if exists else None

    return Regular(root, read_only=True)


class Chunks:
    """Chunk files of a zarr array in a folder `root`."""

    def __init__(self, root: Path, array: Any) -> None:
        self._folder, self._array = root / array.path, array
        self._file_chunks: tuple[int, ...] = array.shards or array.chunks  # shape of the values in one file
        self._bytes = math.prod(array.chunks) * array.dtype.itemsize  # bytes of a decompressed chunk
        self._compressor, self._index_location = _compressor(array.metadata)

    def missing(self) -> tuple[int, int]:
        """Return the number of missing chunk files and of all chunk files; ValueError for links and pipes."""
        total = math.prod(
            math.ceil(side / part) for side, part in zip(self._array.shape, self._file_chunks, strict=True)
        )
        files, folders = 0, [self._folder]
        while folders:
            with os.scandir(folders.pop()) as entries:
                for entry in entries:
                    name = os.path.relpath(entry.path, self._folder)
                    _require_regular(name, entry.stat(follow_symlinks=False).st_mode)
                    if entry.is_dir(follow_symlinks=False):
                        folders.append(Path(entry.path))
                    elif _CHUNK.fullmatch(entry.name):
                        files += 1
        return max(0, total - files), total

    def check(self, ranges: list[range]) -> tuple[int, int]:
        """Return the bytes of the values in `ranges` (one per axis), and the bytes of the chunk files that hold them.

        ValueError for a chunk that decompresses to more than its nominal size, or has too high a compression ratio.
        """
        chunk_ranges = [
            range(part.start // side, -(-part.stop // side))
            for part, side in zip(ranges, self._file_chunks, strict=True)
        ]
        file_bytes = 0
        for index in itertools.product(*chunk_ranges):
            key = self._array.metadata.encode_chunk_key(index)
            if size := regular(self._folder, key):
                file_bytes += size
                reading.afford(self._bytes, size)
                self._require_small(key)
        return math.prod(map(len, ranges)) * self._array.dtype.itemsize, file_bytes

    def _require_small(self, key: str) -> None:
        """Raise ValueError if a chunk in the file `key` decompresses to more than its nominal size."""
        if self._compressor is None:
            return
        data = reading.contents(self._folder / key)
        for chunk in self._chunks_of_shard(data) if self._array.shards else (data,):
            if self._compressor == "blosc" and (
                len(chunk) < 16 or struct.unpack_from("<I", chunk, 12)[0] > len(chunk)
            ):
                raise ValueError(f"its chunk {key} is truncated: its header states more bytes")  # Blosc would read on
            if _decompressed_size(self._compressor, chunk, self._bytes + _MARGIN) > 2 * self._bytes + _MARGIN:
                raise ValueError(f"its chunk {key} unpacks to more than its {self._bytes} bytes")

    def _chunks_of_shard(self, data: bytes) -> Iterator[bytes]:
        """Yield the chunks of a shard; an index of their offsets and lengths is at the start or end of the shard."""
        count = math.prod(outer // inner for outer, inner in zip(self._file_chunks, self._array.chunks, strict=True))
        if len(data) < 16 * count:
            raise ValueError(f"its shards of {len(data)} bytes have no index of {count} chunks")
        # The index at the end is followed by a checksum of four bytes.
        start = 0 if self._index_location == "start" else max(0, len(data) - 16 * count - 4)
        for offset, size in struct.iter_unpack("<QQ", data[start : start + 16 * count]):
            if offset != 2**64 - 1:  # marks an empty chunk
                yield data[offset : offset + size]


def _compressor(metadata: Any) -> tuple[str | None, str]:
    """Return (1) the name of the compressor of an array, or None, (2) the location of the index of its shards.

    ValueError for several compressors or unknown codecs.
    """
    index_location = "end"
    codecs = list(getattr(metadata, "codecs", ()))
    if len(codecs) == 1 and codecs[0].to_dict()["name"] == "sharding_indexed":
        sharding = codecs[0]
        # The attribute of this name is an enumeration in older versions of zarr, and text in newer ones.
        index_location = str(sharding.to_dict()["configuration"]["index_location"])
        codecs = list(sharding.codecs)
        if [codec.to_dict()["name"] for codec in sharding.index_codecs] != ["bytes", "crc32c"]:
            raise ValueError("its shards have an index of another kind")
    names = [str(codec.to_dict()["name"]).removeprefix("numcodecs.") for codec in codecs]
    # Zarr version 2 has filters and a compressor instead of codecs.
    version2 = [*(getattr(metadata, "filters", None) or ()), getattr(metadata, "compressor", None)]
    names += [codec.codec_id for codec in version2 if codec is not None]
    compressors = [name for name in names if name not in _FILTERS]
    if len(compressors) > 1 or any(name not in _COMPRESSORS for name in compressors):
        raise ValueError(
            f"its chunks are compressed by {', '.join(compressors)}; save it with one of {', '.join(_COMPRESSORS)}"
        )
    return (compressors[0] if compressors else None), index_location


def _decompressed_size(compressor: str, data: bytes, limit: int) -> int:
    """Return a bound on the decompressed bytes of a chunk; 0 for a damaged chunk, which the decoder reports.

    For gzip and zlib, which store no size, return 0 for at most `limit` bytes and ``3 * most`` for more.
    """
    try:
        if compressor == "blosc":
            return int(struct.unpack_from("<I", data, 4)[0])
        if compressor == "lz4":
            return int(struct.unpack_from("<I", data)[0])
        if compressor == "zstd":
            return _decompressed_size_of_zstd(data)
    except struct.error:
        return 0
    return 0 if reading.inflates_within(data, limit, wbits=47) else 3 * limit


def _decompressed_size_of_zstd(data: bytes) -> int:
    """Return a bound on the decompressed bytes of zstd frames, from their headers (RFC 8878, 3.1.1)."""
    total, offset = 0, 0
    while offset + 4 < len(data) and data[offset : offset + 4] == b"\x28\xb5\x2f\xfd":
        # Frame header: descriptor, window descriptor unless a single segment, dictionary, content size.
        flags = data[offset + 4]
        single_segment, size_flag = flags >> 5 & 1, flags >> 6
        width = (single_segment, 2, 4, 8)[size_flag]
        offset += 5 + (1 - single_segment) + (0, 1, 2, 4)[flags & 3]
        content_size = int.from_bytes(data[offset : offset + width], "little") + (256 if width == 2 else 0)
        offset, block_sizes, is_last = offset + width, 0, False
        while not is_last:
            (header,) = struct.unpack_from(
                "<I", data[offset : offset + 3].ljust(4, b"\0") if offset + 3 <= len(data) else b""
            )
            # Types 0 and 1, raw and run-length encoded, have `size` bytes; compressed blocks have at most the limit.
            is_last, block_type, size = bool(header & 1), header >> 1 & 3, header >> 3
            block_sizes += size if block_type < 2 else _ZSTD_BLOCK
            offset += 3 + (1 if block_type == 1 else size)
        offset += 4 * (flags >> 2 & 1)  # checksum
        total += content_size if width else block_sizes
    return total


META = "zarr.json"
_KINDS = ("float32", "float64", "uint8", "int64")  # data types that are read and written without zarr


def write_group(folder: Path, attributes: Json) -> None:
    """Create a folder with the metadata of a group, which is a folder of arrays."""
    folder.mkdir(parents=True, exist_ok=True)
    _write_meta(folder, {"zarr_format": 3, "node_type": "group", "attributes": attributes})


def _write_meta(folder: Path, metadata: Json) -> None:
    (folder / META).write_text(json.dumps(metadata, indent=2, allow_nan=False), encoding="utf-8")


@dataclass(frozen=True)
class Layout:
    """Division of an array into chunks: shapes of array and chunks, data type ("<f4") and names of the axes.

    A chunk is identified by its index along each axis; trailing zeros may be omitted.
    """

    shape: tuple[int, ...]
    chunks: tuple[int, ...]
    dtype: str
    dimensions: tuple[str, ...] = field(default=(), compare=False)

    @property
    def grid(self) -> tuple[int, ...]:
        """Number of chunks along each axis."""
        return tuple(-(-n // c) for n, c in zip(self.shape, self.chunks, strict=True))

    def full_index(self, index: tuple[int, ...]) -> tuple[int, ...]:
        """Return the index of a chunk along all axes, with omitted zeros appended."""
        return (*index, *(0,) * (len(self.shape) - len(index)))

    def within(self, index: tuple[int, ...]) -> tuple[slice, ...]:
        """Return the slices of a chunk in the array."""
        sides = zip(self.full_index(index), self.chunks, self.shape, strict=True)
        return tuple(slice(i * c, min((i + 1) * c, n)) for i, c, n in sides)

    def first(self, index: tuple[int, ...]) -> int:
        """Return the index in the flattened array of the first value of a chunk."""
        start = tuple(part.start for part in self.within(index))
        return int(np.ravel_multi_index(start, self.shape)) if start else 0

    def part(self, index: tuple[int, ...]) -> tuple[int, ...]:
        """Return the shape of a chunk within the array; the last chunk along an axis may be smaller."""
        return tuple(part.stop - part.start for part in self.within(index))

    @property
    def nbytes(self) -> int:
        """Size of the array in bytes."""
        return math.prod(self.shape) * np.dtype(self.dtype).itemsize


@dataclass(frozen=True)
class ZarrArray:
    """An uncompressed zarr array in a folder, read and written chunk by chunk; all chunk files have the same size."""

    folder: Path
    layout: Layout
    separator: str = "."  # between the indices of a chunk in its file name

    def create(self, *, fill: float = 0, attributes: Json | None = None, values: Values | None = None) -> None:
        """Write the metadata of the array, of its group unless they exist, and the chunks of `values` if given.

        Readers use the value `fill` in chunks without a file.
        """
        if not (self.folder.parent / META).exists():
            write_group(self.folder.parent, {})
        self.folder.mkdir()
        kind = np.dtype(self.layout.dtype)
        endian = {"configuration": {"endian": "little"}} if kind.itemsize > 1 else {}
        metadata = {
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
        _write_meta(self.folder, metadata)
        if values is not None:
            for index in np.ndindex(*self.layout.grid):
                self.file(index).write_bytes(self.packed(values[self.layout.within(index)]))

    @classmethod
    def open(cls, folder: Path) -> Self:
        """Return the array in a folder; ValueError unless its metadata are as :meth:`create` writes them."""
        metadata = _meta(folder)
        kind, codecs = metadata["data_type"], metadata["codecs"]
        supported = len(codecs) == 1 and codecs[0]["name"] == "bytes" and not metadata.get("storage_transformers")
        keys = metadata["chunk_key_encoding"]
        supported = supported and codecs[0].get("configuration", {}).get("endian", "little") == "little"
        regular_grid = keys["name"] == "default" and metadata["chunk_grid"]["name"] == "regular"
        supported = supported and kind in _KINDS and regular_grid
        separator = keys.get("configuration", {}).get("separator", "/")
        shape, chunks = metadata["shape"], metadata["chunk_grid"]["configuration"]["chunk_shape"]
        valid_shapes = all(type(n) is int and n > 0 for n in (*shape, *chunks)) and len(shape) == len(chunks)
        if not supported or separator not in (".", "/") or not valid_shapes:
            raise ValueError(f"its array {folder.name} has an unsupported layout; read it by zarr")
        return cls(folder, Layout(tuple(shape), tuple(chunks), np.dtype(kind).newbyteorder("<").str), separator)

    def file(self, index: tuple[int, ...]) -> Path:
        """Return the path of the file of a chunk."""
        return self.folder / self.separator.join(("c", *map(str, self.layout.full_index(index))))

    def packed(self, part: Values) -> memoryview:
        """Return the bytes of a chunk; a smaller chunk at the end of an axis is padded with zeros."""
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
        """Return the whole array; ValueError or OSError if the array is too large or chunks are missing."""
        array = self.layout
        if math.prod(array.shape) > validation.MAX_VALUES:
            raise ValueError(
                f"it has {' x '.join(map(str, array.shape))} values; the limit is {validation.MAX_VALUES}"
            )
        # Checked before memory is allocated, since the metadata may state any size.
        if (stored_bytes := sum(_size(self.file(index)) for index in np.ndindex(*array.grid))) < array.nbytes:
            raise ValueError(f"its values take {array.nbytes} uncompressed bytes, got {stored_bytes}")
        values = np.empty(array.shape, array.dtype)
        for index in np.ndindex(*array.grid):
            values[array.within(index)] = self.get(index)
        return values


def attributes(folder: Path) -> Description:
    """Return the attributes of a group."""
    group_attributes: Description = _meta(folder)["attributes"]
    return group_attributes


def _meta(folder: Path) -> Description:
    """Return the metadata of a group or array; ValueError if the file is not a regular file."""
    _size(folder / META)
    metadata: Description = reading.json(reading.contents(folder / META, reading.MAX_PIXELS))
    return metadata


def _size(path: Path) -> int:
    """Return the size of a file in bytes; ValueError for a link, which could lead out of the folder."""
    status = path.lstat()
    if not stat.S_ISREG(status.st_mode):
        raise ValueError(f"{path.name} is no regular file")
    return status.st_size
