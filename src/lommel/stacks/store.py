"""Stores of PSF stacks, Zarr folders: how chunks are cut, written, marked and checked.

A chunk is a file of each array. Writing one changes nothing else, and a process that is killed meanwhile leaves all
others as they were.

Every store has an identity, a random number. Each write compares it, so that nothing is written into another store
that has taken the place of this one, and every checksum includes it, so that chunks of another store are detected.
"""

from __future__ import annotations

import math
import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import atomic, validation
from lommel.base.checksums import checksum, crc32, sealed
from lommel.io import zarr_folders
from lommel.io.psf_files import FileError, told
from lommel.io.registry import Arrays, Description, Values
from lommel.io.zarr_folders import Layout, ZarrArray

KEY = "lommel"
IDENTITY = "identity"
WHAT = "a stack of PSFs"

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
class Store:
    """An existing store, by its path and its description: a Zarr group of version 3 of plain arrays.

    A chunk is written in a folder named by the identity of the store, and moved into place: another store in its
    place has no such folder, and nothing is written. Other processes that see the same files can use it.
    """

    path: Path
    said: Description = field(repr=False)
    layouts: dict[str, Layout] = field(repr=False)

    @classmethod
    def create(cls, path: Path, said: Description, arrays: Arrays, *, new: bool) -> None:
        """Write a store without chunks, in place of an existing one, or FileExistsError if it has to be `new`."""

        def fill(folder: Path) -> None:
            zarr_folders.write_group(folder, {KEY: sealed(said, {})})
            for name, layout in layouts(said).items():
                array = ZarrArray(folder / name, layout)
                array.create(fill=missing(name, layout), attributes=units(said, name), values=arrays.get(name))
            ZarrArray(_scratch(folder, said), Layout((), (), "|u1")).create()

        atomic.write_folder(path, fill, new=new)

    @classmethod
    def open(cls, path: Path) -> Self:
        """Return the store at a path; FileError if there is something else."""
        if not path.is_dir():
            raise FileNotFoundError(2, os.strerror(2), str(path))
        with told(path, WHAT):
            said, found = checked(zarr_folders.attributes(path)[KEY])
            store = cls(path, said, found)
            for name in found:
                if ZarrArray.open(path / name) != store._array(name):
                    raise ValueError(f"its array {name} is stored in another way; zarr reads it")
            return store

    @property
    def mark(self) -> Path:
        """The file that calls hold while they compute into it."""
        return self.path / zarr_folders.META

    def _array(self, name: str) -> ZarrArray:
        return ZarrArray(self.path / name, self.layouts[name])

    def marks(self) -> NDArray[np.bool_]:
        """Return which chunks are computed: have a mark, and a file of each array."""
        found = np.ones(self.layouts[MARKS].grid, dtype=bool)
        for name in (*OF_CHUNK, MARKS):
            there = np.zeros_like(found)
            with told(self.path, WHAT), os.scandir(self.path / name) as entries:
                for entry in entries:
                    key, *numbers = entry.name.split(".")
                    if key == "c" and all(number.isdecimal() for number in numbers):
                        index = tuple(int(number) for number in numbers[: found.ndim])
                        there[index] = name != MARKS or (found[index] and self._mark(index) >= 0)
            found &= there
        return found

    def get(self, name: str, index: Index) -> Values | None:
        """Return a chunk of an array, or None where its file is missing."""
        with told(self.path, WHAT):
            try:
                return self._array(name).get(index)
            except FileNotFoundError:
                return None

    def put(self, parts: Arrays, index: Index) -> None:
        """Write a chunk of some arrays, whole or not at all; FileError if the store was replaced."""
        try:
            with atomic.together(_scratch(self.path, self.said)) as write:
                for name, part in parts.items():
                    array = self._array(name)
                    write(array.file(index), array.packed(part))
        except (FileNotFoundError, NotADirectoryError):
            raise replaced(self.path) from None

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
            raise FileError(
                f"chunk {index} of {validation.line(self.path)} is damaged: its checksum is another; to compute it "
                f"again remove {MARKS}/{self._array(MARKS).file(index).name} in it, and call psf_to as before"
            )
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
    known = {"y": said["unit"], "x": said["unit"]} | said["axes"]
    return {"units": known[name]} if name in known else {}


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


def _scratch(folder: Path, said: Description) -> Path:
    """Return the folder where chunks are written, an empty array to readers of the group."""
    return folder / "chunks" / str(said[IDENTITY])


def path_of(store: str | os.PathLike[str]) -> Path:
    """Return the path of a store, links followed; ValueError if it does not end in .zarr."""
    path = validation.path("store", store)
    if path.suffix.lower() != ".zarr":
        instead = ", which stacks are written to instead of HDF5" if path.suffix.lower() in (".h5", ".hdf5") else ""
        raise ValueError(f"store must end in .zarr{instead}, got {validation.shown(str(path))}")
    return Path(os.path.realpath(path))
