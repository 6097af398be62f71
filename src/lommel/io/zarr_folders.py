"""Zarr folders: plain arrays written and read without zarr, and checks of foreign folders before zarr reads them.

Zarr core specification, version 3.0, https://zarr-specs.readthedocs.io/en/latest/v3/core/
"""

from __future__ import annotations

import asyncio
import itertools
import json
import math
import os
import re
import stat
import struct
from collections.abc import Awaitable, Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from lommel.base import reading, validation
from lommel.base.arrays import Json, Values
from lommel.io.registry import Description

_Value = TypeVar("_Value")
_NAMED = 3  # largest number of missing chunks that are named
_CHUNK = re.compile(r"c|c?[./]?\d+([./]\d+)*")  # last component of the path of a chunk file


def files_of(folder: Path) -> list[Path]:
    """Return the files in a folder and below; OSError for a pipe or device, on which reading would wait."""
    files = [Path(place, name) for place, _, names in os.walk(folder) for name in names]
    for file in files:
        reading.size(file)
    return files


def is_zarr(array: Any) -> bool:
    """Return whether an array is one of Zarr, without the import of zarr."""
    return type(array).__module__.partition(".")[0] == "zarr"


def awaited(call: Callable[[], Awaitable[_Value]], executor: ThreadPoolExecutor | None = None) -> _Value:
    """Return what an asynchronous call of zarr returns, in an event loop of its own, whose threads are an `executor`.

    The loop of zarr goes on with other chunks after an error, up to the end of the process.
    """

    async def run() -> _Value:
        if executor is not None:
            asyncio.get_running_loop().set_default_executor(executor)
        return await call()

    with ThreadPoolExecutor(1) as thread:  # the calling one may run a loop already, as in a notebook
        return thread.submit(asyncio.run, run()).result()


def values_of(array: Any, part: Any) -> Any:
    """Return a part of an array, which may be one of Zarr; RuntimeError if chunks of that are damaged."""
    if not is_zarr(array):
        return array[part]
    try:
        return awaited(lambda: array.async_array.getitem(part))
    except (OSError, MemoryError, IndexError):
        raise
    except Exception as error:  # codecs raise many types
        raise RuntimeError(str(error) or type(error).__name__) from None


class Missing(NamedTuple):
    """Missing chunks: a sentence, without its full stop, that names them, their number, and that of all."""

    text: str
    number: int
    total: int


class Chunks:
    """Chunk files of a zarr array in a folder `root`."""

    def __init__(self, root: Path, array: Any) -> None:
        self._folder, self._array = root / array.path, array
        self._file_chunks: tuple[int, ...] = array.shards or array.chunks  # shape of the values in one file
        codecs = [*getattr(array.metadata, "codecs", ()), getattr(array.metadata, "compressor", None)]
        self._has_blosc = any("blosc" in type(codec).__name__.lower() for codec in codecs)

    def missing(self, files: Sequence[Path]) -> list[Missing]:
        """Return what is missing among the chunk `files`, as a list of at most one; ValueError if all are."""
        counts = [math.ceil(side / part) for side, part in zip(self._array.shape, self._file_chunks, strict=True)]
        total = math.prod(counts)
        found = sum(bool(_CHUNK.fullmatch(file.name)) for file in files if file.is_relative_to(self._folder))
        if not found and total:
            raise ValueError(f"it lacks all of its {total} chunks: copy the whole folder")
        if found >= total:
            return []
        keys = map(self._array.metadata.encode_chunk_key, itertools.product(*map(range, counts)))
        present = set(files)
        absent = (key for key in keys if self._folder / key not in present)
        names = ", ".join(itertools.islice(absent, _NAMED)) + f" and {total - found - _NAMED} more" * (
            total - found > _NAMED
        )
        text = (
            f"{total - found} of the {total} chunks of the folder are missing and count as {self._array.fill_value}: "
            f"{names}; they were empty, or the copy is not complete"
        )
        return [Missing(text, total - found, total)]

    def check(self, ranges: list[range]) -> None:
        """Raise ValueError for a truncated chunk of Blosc, which would read on, in `ranges` (one per axis)."""
        chunk_ranges = [
            range(part.start // side, -(-part.stop // side))
            for part, side in zip(ranges, self._file_chunks, strict=True)
        ]
        for index in itertools.product(*chunk_ranges) if self._has_blosc else ():
            key = self._array.metadata.encode_chunk_key(index)
            if (file := self._folder / key).is_file():
                head = reading.start(file, 16)
                if len(head) < 16 or struct.unpack_from("<I", head, 12)[0] > reading.size(file):
                    raise ValueError(f"its chunk {key} is truncated: its header states more bytes")


def missing_chunks(images: Any) -> list[Missing]:
    """Return what is missing of the chunks of an array of Zarr, or of those that an array of dask reads."""
    arrays = [array for array in stored_arrays(images) if is_zarr(array)]
    folders = [(folder_of(array), array) for array in arrays]
    lists = [Chunks(root, array).missing(files_of(root / array.path)) for root, array in folders if root is not None]
    return list(dict.fromkeys(itertools.chain.from_iterable(lists)))


def folder_of(array: Any) -> Path | None:
    """Return the folder of the store of an array of Zarr, None if it is in none; dask opens one by fsspec."""
    store = getattr(array, "store", None)
    root = getattr(store, "root", None)
    protocol = getattr(getattr(getattr(store, "fs", None), "sync_fs", None), "protocol", ())
    root = store.path if root is None and store is not None and "file" in protocol else root
    return None if root is None else Path(root)


def stored_arrays(images: Any) -> Iterator[Any]:
    """Yield an array and, if it is one of dask, the different objects in its tasks, such as arrays of Zarr."""
    yield images
    graph: Any = getattr(images, "__dask_graph__", dict)()
    found: dict[int, Any] = {}
    for task in dict(graph or {}).values():
        parts = task if isinstance(task, tuple) else (task, getattr(task, "value", None), *getattr(task, "args", ()))
        found |= {id(part): part for part in parts}
    yield from found.values()


META = "zarr.json"
_KINDS = ("float32", "float64", "uint8", "int64")  # data types that are read and written without zarr
_SHEAR = 1e-6  # largest element of an affine transform off its diagonal, relative to the diagonal


class OMEImage(NamedTuple):
    """An image of an OME-Zarr: its finest array, and for each of its axes a letter of TCZYX, the unit and the scale.

    The scale is a text where the file states transforms that are no scale, and None where it states none.
    """

    array: Any
    axes: str
    units: list[str | None]
    scale: NDArray[np.float64] | str | None
    attributes: Json
    notes: list[str]


def ome_image(folder: Path, group: Any, part: str | None) -> OMEImage:
    """Return the image of an OME-Zarr (0.1 to 0.5) that is named `part`, without it the only one.

    Images are the multiscales of the folder or, in folders of converters, of the groups in it. ValueError if there is
    no image, if several fit, or if axes or transforms are invalid; other errors for malformed metadata.
    """
    for kind, place in (("plate", "A/1/0"), ("well", "0")):
        if kind in _ome(group):
            raise ValueError(
                f"it is a {kind} of several images: give the folder of one, such as {folder.name}/{place}"
            )
    places = [""]
    if "multiscales" not in _ome(group):
        # Converters put folders that are no groups beside those of images.
        places = [p.name for p in folder.iterdir() if (p / ".zgroup").exists() or (p / META).exists()]
    images, names = [], []
    for path in sorted(places, key=lambda name: (len(name), name)):
        member = group[path] if path else group
        listed = _ome(member).get("multiscales", [])
        for k, scales in enumerate(listed):
            images.append((member, scales))
            number = path if path and len(listed) == 1 else f"{path}/{k}".lstrip("/")
            names.append([str(scales.get("name") or ""), number])
    if not images:
        raise ValueError(
            "it holds no multiscales of OME-Zarr: pass an array, such as zarr.open(path)['0'], and pixel="
        )
    member, scales = reading.only(images, names, [""] * len(images), part, folder.name)
    if "coordinateSystems" in scales:
        raise ValueError("its metadata are of OME-Zarr 0.6: save it as 0.4 or 0.5")
    notes, levels = [], []
    for dataset in scales["datasets"]:
        if dataset["path"] in member:
            levels.append((dataset, member[dataset["path"]]))
        else:
            notes.append(f"The folder lacks the array {dataset['path']} of its pyramid.")
    if not levels:
        raise ValueError("it lacks all arrays of its pyramid: copy the whole folder")
    dataset, array = max(levels, key=lambda level: math.prod(level[1].shape))
    axes, units = _axes(scales, array)
    transforms = [*dataset.get("coordinateTransformations", []), *scales.get("coordinateTransformations", [])]
    scale = _scale(member, transforms, array.ndim)
    if scale is None:
        notes.append("The file states no scale: the size of its pixels is unknown.")
    elif not isinstance(scale, str) and (turned := [a for a, s in zip(axes, scale, strict=True) if s < 0.0]):
        notes.append(
            f"The file states a negative scale along {', '.join(turned)}, of which the magnitude was used: the order "
            "of its values was kept."
        )
    return OMEImage(array, axes, units, scale, _ome(member), notes)


def _ome(group: Any) -> Json:
    """Return the attributes of a group; OME-Zarr 0.5 has them in an attribute of their own."""
    group_attributes: Json = dict(group.attrs)
    return {**group_attributes, **group_attributes.get("ome", {})}


def _axes(scales: Json, array: Any) -> tuple[str, list[str | None]]:
    """Return letters and units of the axes of an array; ValueError unless Y and X are among them."""
    entries = [axis if isinstance(axis, dict) else {"name": axis} for axis in scales.get("axes", "tczyx")]
    names, kinds = [str(entry["name"]) for entry in entries], {"time": "T", "channel": "C"}
    letters = [
        name.upper() if len(name) == 1 else kinds.get(str(entry.get("type")), "?")
        for name, entry in zip(names, entries, strict=True)
    ]
    axes = "".join(letters)
    if (
        not set(axes) <= set("TCZYX")
        or len(set(axes)) != len(axes)
        or not set("YX") <= set(axes)
        or len(axes) != array.ndim
    ):
        raise ValueError(
            f"its axes are {', '.join(names)} for {array.ndim} axes of its array: save it with y and x, and at most "
            "one of t, c and z each"
        )
    stated = getattr(array.metadata, "dimension_names", None) or array.attrs.get("_ARRAY_DIMENSIONS") or names
    if list(stated) != names and sorted(map(str, stated)) == sorted(names):
        raise ValueError(
            f"its array names its axes {', '.join(map(str, stated))}, its metadata {', '.join(names)}: save it again"
        )
    return axes, [entry.get("unit") for entry in entries]


def _scale(group: Any, transforms: Sequence[Json], count: int) -> NDArray[np.float64] | str | None:
    """Return the product of the scales of transforms, words for transforms that are no scale, or None for none."""
    scale, steps, kinds = np.ones(count), list(transforms), set[str]()
    for transform in steps:
        kinds.add(kind := str(transform.get("type")))
        if kind == "sequence":
            steps += transform["transformations"]  # in any order, since factors are multiplied
        elif kind in ("scale", "affine"):
            factors = matrix = np.asarray(
                transform[kind] if kind in transform else group[transform["path"]][...], float
            )
            if kind == "affine":
                matrix = (matrix if len(matrix) == count else matrix[:-1])[:, :-1]
                factors = np.diag(matrix)
            if factors.shape != (count,):
                raise ValueError(f"its {kind} has {factors.size} values for {count} axes")
            if matrix.ndim == 2 and np.abs(matrix - np.diag(factors)).max() > _SHEAR * np.abs(factors).min():
                return "an affine transform with rotation or shear"
            scale = scale * factors
        elif kind not in ("identity", "translation"):
            return f"a transform of the type {validation.key(kind)}"
    return scale if kinds & {"scale", "affine"} else "an identity transform" if "identity" in kinds else None


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
