"""Stores of PSF stacks: how they are cut into chunks, and how chunks are written, marked and checked.

Chunks are written plainly, as both formats define it: a file each (Zarr), or a run of bytes at a fixed place (a
contiguous data set of HDF5, allocated at once). Writing one changes nothing else, and a process that is killed
meanwhile leaves all others as they were.

Every store has an identity, a random number. Each write compares it, so that nothing is written into another store
that has taken the place of this one, and every checksum includes it, so that chunks of another store are detected.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.atomic import in_use
from lommel.base.checksums import checksum, crc32
from lommel.io.psf_files import FileError

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


@dataclass(frozen=True)
class Layout:
    """An array of a store: its shape, that of its chunks, its type ("<f4") and the names of its axes."""

    shape: tuple[int, ...]
    chunks: tuple[int, ...]
    dtype: str
    dimensions: tuple[str, ...]

    @property
    def grid(self) -> tuple[int, ...]:
        """Number of chunks along each axis."""
        return tuple(-(-n // c) for n, c in zip(self.shape, self.chunks, strict=True))

    def within(self, index: Index) -> tuple[slice, ...]:
        """Return the slices of a chunk in the array; axes beyond `index` are whole."""
        whole = (*index, *(0,) * (len(self.shape) - len(index)))
        sides = zip(whole, self.chunks, self.shape, strict=True)
        return tuple(slice(i * c, min((i + 1) * c, n)) for i, c, n in sides)

    def first(self, index: Index) -> int:
        """Return the index in the flattened array of the first value of a chunk."""
        place = tuple(part.start for part in self.within(index))
        return int(np.ravel_multi_index(place, self.shape)) if place else 0

    def part(self, index: Index) -> tuple[int, ...]:
        """Return the shape of a chunk, smaller at the end of an axis."""
        return tuple(part.stop - part.start for part in self.within(index))

    @property
    def nbytes(self) -> int:
        """Bytes of all of it."""
        return math.prod(self.shape) * np.dtype(self.dtype).itemsize


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

    @property
    @abstractmethod
    def own_file(self) -> Path:
        """The file that is locked while chunks are computed."""

    @abstractmethod
    def marks(self) -> NDArray[np.bool_]:
        """Return which chunks are computed."""

    @abstractmethod
    def get(self, name: str, index: Index) -> Values | None:
        """Return a chunk of an array, or None where a file of it is missing."""

    @abstractmethod
    def put(self, parts: Arrays, index: Index) -> None:
        """Write a chunk of some arrays to the disk; FileError if the store was replaced."""

    def held(self, *, alone: bool = False) -> AbstractContextManager[None]:
        """Lock the store, shared to compute into it, or alone to replace it."""
        return in_use(self.own_file, alone=alone)

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
