"""Where stacks are kept: a Zarr folder or an HDF5 file, whose metadata are written once, and whose chunks one by one.

Chunks are written plainly, as both formats define it: a file each (Zarr), or a run of bytes at a fixed place (a
contiguous data set of HDF5, allocated at once). So nothing but the chunk changes when one is written, and a process
that is killed meanwhile leaves all others as they were.
"""

from __future__ import annotations

import json
import math
import os
from abc import ABC, abstractmethod
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic, validation
from lommel.base.checksums import checksum, crc32, sealed
from lommel.base.optional import library
from lommel.io.psf_files import FileError, told
from lommel.stacks.layout import FORMAT, MARKS, OF_CHUNK, Index, Layout, layouts

_KEY = "lommel"
_WHAT = "a stack of PSFs"
Arrays = dict[str, NDArray[Any]]


@dataclass(frozen=True)
class Store(ABC):
    """A store that is there; can be sent to other processes that see the same files.

    Parameters
    ----------
    path : Path
    said : dict
        The description of the stack.
    """

    path: Path
    said: dict[str, Any] = field(repr=False)
    layouts: dict[str, Layout] = field(repr=False)

    one_file: ClassVar[bool] = False
    """Whether several machines are not to write into it at once."""

    @classmethod
    @abstractmethod
    def create(cls, path: Path, said: dict[str, Any], arrays: Arrays) -> None:
        """Write a store without chunks: the description, sealed, and the `arrays` that it needs."""

    @classmethod
    @abstractmethod
    def open(cls, path: Path) -> Self:
        """Return the store at a path; FileError if there is something else."""

    @abstractmethod
    def get(self, name: str, index: Index) -> NDArray[Any] | None:
        """Return a chunk of an array, or None where a file of it is missing."""

    @abstractmethod
    def put(self, parts: dict[str, NDArray[Any]], index: Index) -> None:
        """Write a chunk of some arrays, and return when they are on the disk."""

    def done(self, index: Index) -> bool:
        """Return whether a chunk is there."""
        return self._mark(index) >= 0

    def keep(self, index: Index, made: Arrays) -> None:
        """Write what was computed of a chunk, and, when that is on the disk, that it is there."""
        self.put(made, index)
        self.put({MARKS: np.full((1,) * len(index), self._sum(index, made))}, index)

    def chunk(self, index: Index) -> Arrays:
        """Return all that is stored of a chunk, pupils too.

        Raises
        ------
        ValueError
            If it was not computed yet.
        FileError
            If it is damaged.
        """
        mark = self._mark(index)
        if mark < 0:
            raise ValueError(
                f"chunk {index} of {validation.line(self.path)} is not there yet: call psf_to as before to go on"
            )
        found = {name: self._given(name, index) for name in (*OF_CHUNK, *self.pupils)}
        if self._sum(index, found) != mark:
            raise FileError(f"chunk {index} of {validation.line(self.path)} is damaged: its checksum is another")
        return found

    def whole(self, name: str) -> NDArray[Any]:
        """Return a small array, such as a coordinate; NaN where chunks of it are not there."""
        layout = self.layouts[name]
        out = np.full(layout.shape, _missing(name, layout), layout.dtype)
        for index in np.ndindex(*layout.grid):
            if (part := self.get(name, index)) is not None:
                out[layout.within(index)] = part
        return out

    @property
    def pupils(self) -> list[str]:
        """Names of the arrays that differ between pupils."""
        return [name for name in self.layouts if name.startswith("pupil/")]

    def _given(self, name: str, index: Index) -> NDArray[Any]:
        part = self.get(name, index)
        if part is None:
            raise FileError(f"{validation.line(self.path)} lacks chunk {index} of {name}")
        return part

    def _mark(self, index: Index) -> int:
        found = self.get(MARKS, index)
        return -1 if found is None else int(found.flat[0])

    def _sum(self, index: Index, made: Arrays) -> int:
        """Return the checksum of a chunk, of its place, and of its pupils."""
        pupils = {name: self._given(name, index) for name in self.pupils}
        return crc32({"chunk": [int(i) for i in index]}, made | pupils)


class ZarrStore(Store):
    """A Zarr group of version 3, its arrays stored plainly."""

    @classmethod
    def create(cls, path: Path, said: dict[str, Any], arrays: Arrays) -> None:
        """Write the folder."""
        zarr = library("zarr", "stacks in .zarr need", "zarr")

        def fill(folder: Path) -> None:
            group = zarr.create_group(folder, zarr_format=3, attributes={_KEY: sealed(said, {})})
            for name, layout in layouts(said).items():
                made = group.create_array(
                    name,
                    shape=layout.shape,
                    dtype=layout.dtype,
                    chunks=layout.chunks,
                    compressors=None,
                    filters=None,
                    fill_value=_missing(name, layout),
                    chunk_key_encoding={
                        "name": "default",
                        "separator": ".",
                    },  # one folder, whose names one call settles
                    dimension_names=list(layout.dimensions),
                    attributes=_units(said, name),
                    config={"write_empty_chunks": True},
                )
                if name in arrays:
                    made[...] = arrays[name]

        atomic.write_folder(path, fill)

    @classmethod
    def open(cls, path: Path) -> Self:
        """Return the store at a path."""
        if not path.is_dir():
            raise FileNotFoundError(2, os.strerror(2), str(path))
        with told(path, _WHAT):
            said, found = _said(json.loads((path / "zarr.json").read_bytes())["attributes"][_KEY])
            for name, layout in found.items():
                known = json.loads((path / name / "zarr.json").read_bytes())
                way = known["chunk_grid"]["configuration"]["chunk_shape"], [c["name"] for c in known["codecs"]]
                if (known["shape"], *way) != (list(layout.shape), list(layout.chunks), ["bytes"]):
                    raise ValueError(f"its array {name} is stored another way; zarr reads it")
            return cls(path, said, found)

    def _file(self, name: str, index: Index) -> Path:
        whole = (*index, *(0,) * (len(self.layouts[name].shape) - len(index)))
        return self.path / name / ".".join(("c", *map(str, whole)))

    def get(self, name: str, index: Index) -> NDArray[Any] | None:
        """Return a chunk; None if there is no file."""
        layout = self.layouts[name]
        try:
            data = self._file(name, index).read_bytes()
        except FileNotFoundError:
            return None
        with told(self.path, _WHAT):
            whole = np.frombuffer(data, layout.dtype).reshape(layout.chunks)
        return whole[tuple(slice(0, n) for n in layout.part(index))]

    def put(self, parts: Arrays, index: Index) -> None:
        """Write a file each, whole or not at all."""
        with atomic.together() as write:
            for name, part in parts.items():
                layout = self.layouts[name]
                whole = np.zeros(layout.chunks, layout.dtype) if part.shape != layout.chunks else part
                if whole is not part:
                    whole[tuple(slice(0, n) for n in part.shape)] = part
                write(self._file(name, index), np.ascontiguousarray(whole, layout.dtype).data.cast("B"))


@dataclass(frozen=True)
class Hdf5Store(Store):
    """An HDF5 file of contiguous data sets, at places that do not change."""

    offsets: dict[str, int] = field(repr=False)
    one_file: ClassVar[bool] = True

    @classmethod
    def create(cls, path: Path, said: dict[str, Any], arrays: Arrays) -> None:
        """Write the file."""
        h5py = library("h5py", "stacks in .h5 need", "hdf5")

        def fill(place: Path) -> None:
            with h5py.File(place, "w") as file:
                file[_KEY] = json.dumps(sealed(said, {}))
                found = layouts(said)
                for name, layout in found.items():
                    data = _contiguous(h5py, file, name, layout)
                    data.attrs.update(_units(said, name))
                    if name in arrays:
                        data[...] = arrays[name]
                    elif name != "values":  # which stay a hole in the file until they are there
                        data[...] = _missing(name, layout)
                    if layout.dimensions == (name,):
                        data.make_scale(name)
                for name, layout in found.items():
                    for axis, dimension in enumerate(layout.dimensions):
                        file[name].dims[axis].label = dimension
                        if dimension in found and dimension != name:
                            file[name].dims[axis].attach_scale(file[dimension])

        atomic.write_by(path, fill)

    @classmethod
    def open(cls, path: Path) -> Self:
        """Return the store at a path."""
        h5py = library("h5py", "stacks in .h5 need", "hdf5")
        if not path.exists():
            raise FileNotFoundError(2, os.strerror(2), str(path))
        with told(path, _WHAT), h5py.File(path, "r") as file:
            said, found = _said(json.loads(file[_KEY][()]))
            offsets = {}
            for name, layout in found.items():
                data = file[name]
                offsets[name] = data.id.get_offset()
                if (data.shape, data.dtype, offsets[name] is None) != (layout.shape, np.dtype(layout.dtype), False):
                    raise ValueError(f"its data set {name} is stored another way; h5py reads it")
            return cls(path, said, found, offsets)

    def _place(self, name: str, index: Index) -> int:
        layout = self.layouts[name]
        return self.offsets[name] + layout.first(index) * np.dtype(layout.dtype).itemsize

    def get(self, name: str, index: Index) -> NDArray[Any]:
        """Return a chunk, as the file was made where it was not written."""
        layout = self.layouts[name]
        shape = layout.part(index)
        with told(self.path, _WHAT):
            return np.fromfile(
                self.path, layout.dtype, count=math.prod(shape), offset=self._place(name, index)
            ).reshape(shape)

    def put(self, parts: Arrays, index: Index) -> None:
        """Write runs of bytes."""
        with self.path.open("r+b") as file:
            for name, part in parts.items():
                file.seek(self._place(name, index))
                file.write(np.ascontiguousarray(part, self.layouts[name].dtype).data.cast("B"))
            file.flush()
            os.fsync(file.fileno())


KINDS: dict[str, type[Store]] = {".zarr": ZarrStore, ".h5": Hdf5Store, ".hdf5": Hdf5Store}
"""By the suffix of their paths."""


def kind(path: Path) -> type[Store]:
    """Return what stores of a path are; ValueError if its suffix is unknown."""
    if path.suffix.lower() not in KINDS:
        raise ValueError(f"store must end in {', '.join(KINDS)}, got {validation.shown(str(path))}")
    return KINDS[path.suffix.lower()]


def _contiguous(h5py: Any, file: Any, name: str, layout: Layout) -> Any:
    """Return a new data set whose place is decided at once, and which nothing is written into."""
    wanted = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
    wanted.set_layout(h5py.h5d.CONTIGUOUS)
    wanted.set_alloc_time(h5py.h5d.ALLOC_TIME_EARLY)
    wanted.set_fill_time(h5py.h5d.FILL_TIME_NEVER)
    parents = h5py.h5p.create(h5py.h5p.LINK_CREATE)
    parents.set_create_intermediate_group(True)
    space, of = h5py.h5s.create_simple(layout.shape), h5py.h5t.py_create(np.dtype(layout.dtype))
    h5py.h5d.create(file.id, name.encode(), of, space, dcpl=wanted, lcpl=parents)
    return file[name]


def _missing(name: str, layout: Layout) -> float:
    """Return what stands where there is nothing yet."""
    return -1 if name == MARKS else np.nan if layout.dtype[1] == "f" else 0


def _units(said: dict[str, Any], name: str) -> dict[str, str]:
    unit = said["axes"].get(name, said["unit"] if name in ("y", "x") else None)
    return {} if unit is None else {"units": unit}


def _said(description: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Layout]]:
    """Return the description of a store, checked, and its arrays."""
    if description["checksum"] != checksum(description, {}):
        raise ValueError("its description was changed after it was written")
    said = {name: value for name, value in description.items() if name != "checksum"}
    if said["format"] != FORMAT:
        raise ValueError(f"it is of format {said['format']}, and this version reads {FORMAT}")
    return said, layouts(said)
