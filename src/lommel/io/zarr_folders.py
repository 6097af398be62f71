"""Zarr folders (version 3) written and read plainly: descriptions in JSON, uncompressed chunks, a file each.

zarr writes by threads of its own, which go on after an error, and reads what it finds, of any kind and size. Here
nothing is under way once a call has ended, and what is read is compared with the size of its file before.

Zarr core specification, version 3.0, https://zarr-specs.readthedocs.io/en/latest/v3/core/
"""

from __future__ import annotations

import json
import math
import stat
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from lommel.base import reading, validation

META = "zarr.json"
_KINDS = ("float32", "float64", "uint8", "int64")


def write_group(folder: Path, attributes: Mapping[str, Any]) -> None:
    """Make a group, a folder that holds arrays."""
    folder.mkdir(parents=True, exist_ok=True)
    _write_meta(folder, {"zarr_format": 3, "node_type": "group", "attributes": attributes})


def _write_meta(folder: Path, said: Mapping[str, Any]) -> None:
    (folder / META).write_text(json.dumps(said, indent=2, allow_nan=False), encoding="utf-8")


@dataclass(frozen=True)
class ZarrArray:
    """An array in a folder.

    Parameters
    ----------
    folder : Path
    shape, chunks : tuple of int
        Of all of it, and of a chunk; those at the end of an axis are stored whole.
    dtype : str
        Such as "<f4".
    separator : str
        "." or "/", between the numbers of a chunk in the name of its file.
    """

    folder: Path
    shape: tuple[int, ...]
    chunks: tuple[int, ...]
    dtype: str
    separator: str = "."  # one folder, whose names one call settles

    def create(
        self,
        dimensions: Sequence[str],
        *,
        fill: float = 0,
        attributes: Mapping[str, Any] | None = None,
        values: NDArray[Any] | None = None,
    ) -> None:
        """Write the description, that of the group that holds it if there is none, and chunks of values if given."""
        if not (self.folder.parent / META).exists():
            write_group(self.folder.parent, {})
        self.folder.mkdir()
        kind = np.dtype(self.dtype)
        endian = {"configuration": {"endian": "little"}} if kind.itemsize > 1 else {}
        said = {
            "zarr_format": 3,
            "node_type": "array",
            "shape": self.shape,
            "data_type": kind.name,
            "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": self.chunks}},
            "chunk_key_encoding": {"name": "default", "configuration": {"separator": self.separator}},
            "fill_value": "NaN" if math.isnan(fill) else kind.type(fill).item(),
            "codecs": [{"name": "bytes"} | endian],
            "attributes": attributes or {},
            "dimension_names": list(dimensions),
            "storage_transformers": [],
        }
        _write_meta(self.folder, said)
        if values is not None:
            for index in np.ndindex(*self.grid):
                self.file(index).write_bytes(self.packed(values[self._within(index)]))

    @classmethod
    def open(cls, folder: Path) -> Self:
        """Return what is in a folder; ValueError if it is no such array, OSError if it cannot be read."""
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
            raise ValueError(f"its array {folder.name} is stored another way; zarr reads it")
        return cls(folder, tuple(shape), tuple(chunks), np.dtype(kind).newbyteorder("<").str, separator)

    @property
    def grid(self) -> tuple[int, ...]:
        """How many chunks there are along each axis."""
        return tuple(-(-n // c) for n, c in zip(self.shape, self.chunks, strict=True))

    def file(self, index: tuple[int, ...]) -> Path:
        """Return where a chunk is; of axes that are not named the first is meant."""
        whole = (*index, *(0,) * (len(self.shape) - len(index)))
        return self.folder / self.separator.join(("c", *map(str, whole)))

    def packed(self, part: NDArray[Any]) -> memoryview:
        """Return what is stored of a chunk, filled up with zeros where it is smaller, at the end of an axis."""
        whole = np.zeros(self.chunks, self.dtype) if part.shape != self.chunks else part
        if whole is not part:
            whole[tuple(slice(0, n) for n in part.shape)] = part
        return np.ascontiguousarray(whole, self.dtype).reshape(-1).data.cast("B")

    def get(self, index: tuple[int, ...]) -> NDArray[Any]:
        """Return a chunk; FileNotFoundError where there is none, ValueError if its file has another size."""
        file, nbytes = self.file(index), math.prod(self.chunks) * np.dtype(self.dtype).itemsize
        if (size := _size(file)) != nbytes:
            raise ValueError(f"its chunk {file.name} takes {nbytes} bytes, got {size}")
        part = np.frombuffer(reading.contents(file, nbytes), self.dtype).reshape(self.chunks)
        whole = (*index, *(0,) * (len(self.shape) - len(index)))
        sides = zip(whole, self.chunks, self.shape, strict=True)
        return part[tuple(slice(0, min(c, n - i * c)) for i, c, n in sides)]

    def read(self, most: int = validation.MAX_VALUES) -> NDArray[Any]:
        """Return all of it, at most so many values; ValueError or OSError where chunks are not there."""
        if math.prod(self.shape) > most:
            raise ValueError(f"it has {' x '.join(map(str, self.shape))} values; the limit is {most}")
        held = sum(_size(self.file(index)) for index in np.ndindex(*self.grid))
        out = np.empty(self.shape, self.dtype)
        if held < out.nbytes:
            raise ValueError(f"its values take {out.nbytes} bytes, plainly stored, got {held}")
        for index in np.ndindex(*self.grid):
            out[self._within(index)] = self.get(index)
        return out

    def _within(self, index: tuple[int, ...]) -> tuple[slice, ...]:
        return tuple(slice(i * c, (i + 1) * c) for i, c in zip(index, self.chunks, strict=True))


def attributes(folder: Path) -> dict[str, Any]:
    """Return what a group says; OSError if it cannot be read, ValueError or KeyError if it is none."""
    found: dict[str, Any] = _meta(folder)["attributes"]
    return found


def _meta(folder: Path) -> dict[str, Any]:
    _size(folder / META)
    found: dict[str, Any] = reading.json(reading.contents(folder / META, reading.MAX_PIXELS))
    return found


def _size(path: Path) -> int:
    """Return the bytes of a file; OSError if it is none, or a link, which may lead anywhere."""
    status = path.lstat()
    if not stat.S_ISREG(status.st_mode):
        raise ValueError(f"{path.name} is no regular file")
    return status.st_size
