"""Stores of PSF stacks, Zarr folders and HDF5 files: how chunks are cut, written, marked and checked.

Chunks are written plainly, as both formats define it: a file each (Zarr), or a run of bytes at a fixed place (a
contiguous data set of HDF5, allocated at once). Writing one changes nothing else, and a process that is killed
meanwhile leaves all others as they were.

Every store has an identity, a random number. Each write compares it, so that nothing is written into another store
that has taken the place of this one, and every checksum includes it, so that chunks of another store are detected.
"""

from __future__ import annotations

import json
import math
import os
from abc import ABC, abstractmethod
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import atomic, reading, sparse_hdf5, validation
from lommel.base.checksums import checksum, crc32, sealed
from lommel.base.optional import library
from lommel.io import zarr_folders
from lommel.io.psf_files import FileError, told
from lommel.io.zarr_folders import Layout, ZarrArray

KEY = "lommel"
IDENTITY = "identity"
WHAT = "a stack of PSFs"
Values: TypeAlias = NDArray[Any]
"""An array of one of the types of a store."""
Arrays = dict[str, Values]
Description: TypeAlias = dict[str, Any]
"""The description of a stack in plain types, as JSON holds it."""

FORMAT = 2
MAX_CHUNKS = 2**24
"""Largest number of chunks of a stack."""
DEFAULT = 2**24
"""Bytes of the values of a chunk by default."""
MARKS = "chunks/checksum"
"""The array with the checksum of each chunk, or -1 where it is not computed yet."""
OF_CHUNK = ("values", "error_bound", "scale", "method")
"""The computed arrays."""

Index = tuple[int, ...]
Center: TypeAlias = tuple[ArrayLike, ArrayLike]


def cut(shape: tuple[int, ...], most: int) -> tuple[int, ...]:
    """Return the shape of equal chunks of a stack, of at most so many members, each a run of the flattened stack."""
    # Axes are whole from the last on, as far as they fit.
    chunk = [1] * len(shape)
    for axis in reversed(range(len(shape))):
        parts = -(-shape[axis] // min(most, shape[axis]))
        chunk[axis] = -(-shape[axis] // parts)
        if parts > 1:
            break
        most //= shape[axis]
        if most < 2:
            break
    return tuple(chunk)


def layouts(said: Description) -> dict[str, Layout]:
    """Return the arrays of the store of a description, by name; TypeError, ValueError or KeyError if it is none."""
    stack, window, chunks = (tuple(int(n) for n in said[name]) for name in ("stack", "window", "chunks"))
    names = tuple(said["axes"])
    kind = {"float32": "<f4", "float64": "<f8"}[said["dtype"]]
    if not len(names) == len(stack) == len(chunks) >= 1 or min(*stack, *chunks, *window) < 1 or len(window) != 2:
        raise ValueError(f"axes {names}, chunks {chunks} and windows {window} for a stack of shape {stack}")
    count = math.prod(-(-n // c) for n, c in zip(stack, chunks, strict=True))
    if math.prod(stack) > validation.MAX_VALUES or count > MAX_CHUNKS:
        raise ValueError(
            f"a stack must have at most {validation.MAX_VALUES} PSFs in {MAX_CHUNKS} chunks, "
            f"got {math.prod(stack)} in {count}"
        )
    found = {
        "values": Layout(stack + window, chunks + window, kind, (*names, "y", "x")),
        "error_bound": Layout(stack, chunks, "<f8", names),
        "scale": Layout(stack, chunks, "<f8", names),
        "method": Layout(stack, chunks, "|u1", names),
    }
    if not all(name.isidentifier() for name in (*names, *said["arrays"])) or {*names} & {*found, "y", "x"}:
        raise ValueError(f"axes {names} and arrays {list(said['arrays'])} are not names of this kind")
    for name, (more, _) in said["arrays"].items():
        further = tuple(int(n) for n in more)
        found[f"pupil/{name}"] = Layout(
            stack + further, chunks + further, "<f8", (*names, "term")[: len(stack + further)]
        )
    marks = found["scale"].grid
    found[MARKS] = Layout(marks, (1,) * len(marks), "<i8", tuple(f"{name}_chunk" for name in names))
    places = {name: (n, "<f8") for name, n in zip(names, stack, strict=True)}
    if said["center"] is not None:
        places |= {"y": (window[0], "<f8"), "x": (window[1], "<f8")}
    return found | {name: Layout((n,), (n,), dtype, (name,)) for name, (n, dtype) in places.items()}


@dataclass(frozen=True)
class Store(ABC):
    """An existing store, by its path and its description; other processes that see the same files can use it."""

    path: Path
    said: Description = field(repr=False)
    layouts: dict[str, Layout] = field(repr=False)

    one_file: ClassVar[bool] = False
    """Whether only one machine may write into it at a time."""

    @classmethod
    @abstractmethod
    def create(cls, path: Path, said: Description, arrays: Arrays, *, new: bool) -> None:
        """Write a store without chunks, in place of an existing one, or FileExistsError if it has to be `new`."""

    @classmethod
    @abstractmethod
    def open(cls, path: Path) -> Self:
        """Return the store at a path; FileError if there is something else."""

    @abstractmethod
    def marks(self) -> NDArray[np.bool_]:
        """Return which chunks are computed."""

    @abstractmethod
    def get(self, name: str, index: Index) -> Values | None:
        """Return a chunk of an array, or None where a file of it is missing."""

    @abstractmethod
    def put(self, parts: Arrays, index: Index) -> None:
        """Write a chunk of some arrays to the disk; FileError if the store was replaced."""

    def held(self, *, alone: bool = False) -> AbstractContextManager[bool]:
        """Lock the store, shared to compute into it, or alone to replace it."""
        return atomic.in_use(self.path, alone=alone)

    def keep(self, index: Index, made: Arrays, pupils: int) -> None:
        """Write a computed chunk, then its mark: a checksum that includes that of the requested `pupils`."""
        self.put(made, index)
        self.put({MARKS: np.full((1,) * len(index), self._sum(index, made, pupils))}, index)

    def chunk(self, index: Index) -> Arrays:
        """Return the arrays of a chunk, pupils too; ValueError if it is not computed yet, FileError if damaged."""
        mark = self._mark(index)
        if mark < 0:
            raise ValueError(
                f"chunk {index} of {validation.line(self.path)} is not there yet: call psf_to as before to go on"
            )
        made = {name: self.given(name, index) for name in OF_CHUNK}
        pupils = {name: self.given(name, index) for name in self.pupils}
        if self._sum(index, made, crc32({}, pupils)) != mark:
            raise FileError(f"chunk {index} of {validation.line(self.path)} is damaged: its checksum is another")
        return made | pupils

    def whole(self, name: str) -> Values:
        """Return a whole array, such as the error bounds; NaN where chunks are not computed yet."""
        layout = self.layouts[name]
        out = np.full(layout.shape, missing(name, layout), layout.dtype)
        for index in np.ndindex(*layout.grid):
            if (part := self.get(name, index)) is not None:
                out[layout.within(index)] = part
        return out

    @property
    def pupils(self) -> list[str]:
        """Names of the arrays that differ between pupils."""
        return [name for name in self.layouts if name.startswith("pupil/")]

    def given(self, name: str, index: Index) -> Values:
        """Return a chunk of an array that the store must have; FileError if it has not."""
        part = self.get(name, index)
        if part is None:
            raise FileError(f"{validation.line(self.path)} lacks chunk {index} of {name}")
        return part

    def _mark(self, index: Index) -> int:
        found = self.get(MARKS, index)
        return -1 if found is None else int(found.flat[0])

    def _sum(self, index: Index, made: Arrays, pupils: int) -> int:
        """Return the checksum of a chunk with its index, the identity of the store and the checksum of its pupils."""
        return crc32({"chunk": [int(i) for i in index], "store": self.said[IDENTITY], "pupils": pupils}, made)


def replaced(path: Path) -> FileError:
    """Return the error for a store that was removed or replaced."""
    return FileError(
        f"{validation.line(path)} was removed, or replaced by another call of psf_to, while its PSFs were computed; "
        "call psf_to again, with a path that nobody else writes to"
    )


def missing(name: str, layout: Layout) -> float:
    """Return the fill value of an array."""
    return -1 if name == MARKS else np.nan if layout.dtype[1] == "f" else 0


def units(said: Description, name: str) -> dict[str, str]:
    """Return the attributes of an array: the unit of a coordinate."""
    unit = said["axes"].get(name, said["unit"] if name in ("y", "x") else None)
    return {} if unit is None else {"units": unit}


def checked(description: Description) -> tuple[Description, dict[str, Layout]]:
    """Return the description of a store, checked, and its arrays."""
    if description["checksum"] != checksum(description, {}):
        raise ValueError("its description was changed after it was written")
    said = {name: value for name, value in description.items() if name != "checksum"}
    if said["format"] != FORMAT:
        raise ValueError(f"it is of format {said['format']}, and this version reads {FORMAT}")
    if not isinstance(said[IDENTITY], str) or len(said[IDENTITY]) != 32 or not said[IDENTITY].isalnum():
        raise ValueError(f"its identity must be 32 letters and digits, got {validation.shown(said[IDENTITY])}")
    return said, layouts(said)


class ZarrStore(Store):
    """A Zarr group of version 3 of plain arrays.

    A chunk is written in a folder named by the identity of the store, and moved into place: another store in its
    place has no such folder, and nothing is written.
    """

    @classmethod
    def create(cls, path: Path, said: Description, arrays: Arrays, *, new: bool) -> None:
        """Write the folder."""

        def fill(folder: Path) -> None:
            zarr_folders.write_group(folder, {KEY: sealed(said, {})})
            for name, layout in layouts(said).items():
                array = ZarrArray(folder / name, layout)
                array.create(fill=missing(name, layout), attributes=units(said, name), values=arrays.get(name))
            ZarrArray(_scratch(folder, said), Layout((), (), "|u1")).create()

        atomic.write_folder(path, fill, new=new)

    @classmethod
    def open(cls, path: Path) -> Self:
        """Return the store at a path."""
        if not path.is_dir():
            raise FileNotFoundError(2, os.strerror(2), str(path))
        with told(path, WHAT):
            said, found = checked(zarr_folders.attributes(path)[KEY])
            store = cls(path, said, found)
            for name in found:
                if ZarrArray.open(path / name) != store._array(name):
                    raise ValueError(f"its array {name} is stored in another way; zarr reads it")
            return store

    def held(self, *, alone: bool = False) -> AbstractContextManager[bool]:
        """Lock the description."""
        return atomic.in_use(self.path / zarr_folders.META, alone=alone)

    def _array(self, name: str) -> ZarrArray:
        return ZarrArray(self.path / name, self.layouts[name])

    def marks(self) -> NDArray[np.bool_]:
        """Return which chunks are computed, by the files that exist."""
        array = self._array(MARKS)
        found = np.zeros(array.layout.grid, dtype=bool)
        with told(self.path, WHAT), os.scandir(array.folder) as entries:
            for entry in entries:
                key, *numbers = entry.name.split(".")
                if key == "c" and all(number.isdecimal() for number in numbers):
                    index = tuple(int(number) for number in numbers)
                    found[index] = self._mark(index) >= 0
        return found

    def get(self, name: str, index: Index) -> Values | None:
        """Return a chunk; None if there is no file."""
        with told(self.path, WHAT):
            try:
                return self._array(name).get(index)
            except FileNotFoundError:
                return None

    def put(self, parts: Arrays, index: Index) -> None:
        """Write a file each, whole or not at all."""
        try:
            with atomic.together(_scratch(self.path, self.said)) as write:
                for name, part in parts.items():
                    array = self._array(name)
                    write(array.file(index), array.packed(part))
        except (FileNotFoundError, NotADirectoryError):
            raise replaced(self.path) from None


def _scratch(folder: Path, said: Description) -> Path:
    """Return the folder where chunks are written, an empty array to readers of the group."""
    return folder / "chunks" / str(said[IDENTITY])


_MARK = b"lommel stack %s %12d\n"  # the identity of the store, and the length of the description that follows
_HEAD = len(_MARK % (bytes(32), 0))
_PLACES, _BYTES = "offsets", "bytes"  # keys of the description in this format


@dataclass(frozen=True)
class Hdf5Store(Store):
    """An HDF5 file of contiguous data sets at known offsets."""

    # The user block before the HDF5 data holds the description and the offsets, with a checksum. Chunks are read from
    # these offsets, so that the HDF5 library never opens a file of unknown origin or a damaged one.

    offsets: dict[str, int] = field(repr=False)
    one_file: ClassVar[bool] = True

    @classmethod
    def create(cls, path: Path, said: Description, arrays: Arrays, *, new: bool) -> None:
        """Write the file."""
        h5py = library("h5py", "stacks in .h5 need", "hdf5")
        found = layouts(said)
        # A number has at most twenty digits.
        most = _HEAD + len(json.dumps(sealed(said, {}))) + sum(len(name) + 30 for name in found) + 200

        # The HDF5 library writes to memory, without the arrays: a full disk would end the process.
        made, offsets = sparse_hdf5.Sparse(), {}
        with h5py.File(made, "w", userblock_size=max(512, 1 << most.bit_length())) as file:
            file[KEY] = json.dumps(sealed(said, {}))
            for name, layout in found.items():
                data = sparse_hdf5.hole(file, name, layout.shape, np.dtype(layout.dtype))
                data.attrs.update(units(said, name))
                if layout.dimensions == (name,):
                    data.make_scale(name)
                offsets[name] = data.id.get_offset()
            for name, layout in found.items():
                for axis, dimension in enumerate(layout.dimensions):
                    file[name].dims[axis].label = dimension
                    if dimension in found and dimension != name:
                        file[name].dims[axis].attach_scale(file[dimension])
        text = json.dumps(sealed(said | {_PLACES: offsets, _BYTES: made.size}, {})).encode()

        def fill(place: Path) -> None:
            with place.open("wb") as file:
                made.copy(file)
                file.seek(0)
                file.write(_MARK % (said[IDENTITY].encode(), len(text)) + text)
                for name, layout in found.items():
                    if name != "values":  # which stay a hole in the file until they are written
                        empty = np.broadcast_to(np.array(missing(name, layout), layout.dtype), layout.shape)
                        file.seek(offsets[name])
                        file.write(np.ascontiguousarray(arrays.get(name, empty), layout.dtype).data.cast("B"))

        atomic.write_by(path, fill, new=new)

    @classmethod
    def open(cls, path: Path) -> Self:
        """Return the store at a path."""
        size = reading.size(path)
        with told(path, WHAT), path.open("rb") as file:
            mark = file.read(_HEAD).split()
            if mark[:2] != [b"lommel", b"stack"] or len(mark) != 4 or int(mark[3]) > min(size, reading.MAX_PIXELS):
                raise ValueError("no description before HDF5 begins")
            said, found = checked(reading.json(file.read(int(mark[3]))))
            offsets = {name: int(said[_PLACES][name]) for name in found}
            ends = [offsets[name] + layout.nbytes for name, layout in found.items()]
            if min(offsets.values()) < 0 or max(*ends, int(said[_BYTES])) > size:
                raise ValueError(
                    f"it was written with {said[_BYTES]} bytes, or its data sets take more; it has {size}"
                )
            return cls(path, said, found, offsets)

    def _place(self, name: str, index: Index) -> int:
        layout = self.layouts[name]
        return self.offsets[name] + layout.first(index) * np.dtype(layout.dtype).itemsize

    def marks(self) -> NDArray[np.bool_]:
        """Return which chunks are computed."""
        layout = self.layouts[MARKS]
        return self._read(MARKS, (0,) * len(layout.shape), layout.shape) >= 0

    def get(self, name: str, index: Index) -> Values:
        """Return a chunk, with fill values if it was not written."""
        return self._read(name, index, self.layouts[name].part(index))

    def _read(self, name: str, index: Index, shape: tuple[int, ...]) -> Values:
        place, kind = self._place(name, index), self.layouts[name].dtype
        with told(self.path, WHAT):
            reading.size(self.path)  # lest it be a pipe
            return np.fromfile(self.path, kind, count=math.prod(shape), offset=place).reshape(shape)

    def put(self, parts: Arrays, index: Index) -> None:
        """Write runs of bytes into the file, if it is still this one."""
        try:
            with atomic.told_as(self.path), self.path.open("r+b") as file:
                if file.read(_HEAD).split()[2:3] != [self.said[IDENTITY].encode()]:
                    raise replaced(self.path)
                for name, part in parts.items():
                    file.seek(self._place(name, index))
                    file.write(np.ascontiguousarray(part, self.layouts[name].dtype).data.cast("B"))
                file.flush()
                os.fsync(file.fileno())
        except FileNotFoundError:
            raise replaced(self.path) from None


_KINDS: dict[str, type[Store]] = {".zarr": ZarrStore, ".h5": Hdf5Store, ".hdf5": Hdf5Store}


def kind(path: Path) -> type[Store]:
    """Return the class of stores for the suffix of a path; ValueError if it is unknown."""
    if path.suffix.lower() not in _KINDS:
        raise ValueError(f"store must end in {', '.join(_KINDS)}, got {validation.shown(str(path))}")
    return _KINDS[path.suffix.lower()]
