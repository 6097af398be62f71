"""What every store of a stack is: metadata that are written once, and chunks that are written one by one.

Chunks are written plainly, as both formats define it: a file each (Zarr), or a run of bytes at a fixed place (a
contiguous data set of HDF5, allocated at once). So nothing but the chunk changes when one is written, and a process
that is killed meanwhile leaves all others as they were.

Every store has an identity, a random number. It is looked at in every write, so that nothing is written into another
store that has taken the place of this one, and is part of every checksum, so that what came there all the same does
not pass for what was asked.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.atomic import in_use
from lommel.base.checksums import checksum, crc32
from lommel.io.psf_files import FileError
from lommel.stacks.layout import FORMAT, MARKS, OF_CHUNK, Index, Layout, layouts

KEY = "lommel"
IDENTITY = "identity"
WHAT = "a stack of PSFs"
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
    def create(cls, path: Path, said: dict[str, Any], arrays: Arrays, *, new: bool) -> None:
        """Write a store without chunks: the description, sealed, and the `arrays` that it needs.

        One that is there is replaced, or, if it is to be `new`, kept, with a FileExistsError.
        """

    @classmethod
    @abstractmethod
    def open(cls, path: Path) -> Self:
        """Return the store at a path; FileError if there is something else."""

    @property
    @abstractmethod
    def own_file(self) -> Path:
        """The file that is there as long as the store, and that who computes holds."""

    @abstractmethod
    def marks(self) -> NDArray[np.bool_]:
        """Return which chunks are there."""

    @abstractmethod
    def get(self, name: str, index: Index) -> NDArray[Any] | None:
        """Return a chunk of an array, or None where a file of it is missing."""

    @abstractmethod
    def put(self, parts: dict[str, NDArray[Any]], index: Index) -> None:
        """Write a chunk of some arrays, and return when they are on the disk; FileError if the store was replaced."""

    def held(self, *, alone: bool = False) -> AbstractContextManager[None]:
        """Hold the store, with others who compute the same, or alone, to replace it."""
        return in_use(self.own_file, alone=alone)

    def keep(self, index: Index, made: Arrays, pupils: int) -> None:
        """Write what was computed of a chunk, and, when that is on the disk, that it is there.

        The checksum of the pupils is that of those who asked: what the store says of pupils is compared with it.
        """
        self.put(made, index)
        self.put({MARKS: np.full((1,) * len(index), self._sum(index, made, pupils))}, index)

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
        made = {name: self.given(name, index) for name in OF_CHUNK}
        pupils = {name: self.given(name, index) for name in self.pupils}
        if self._sum(index, made, crc32({}, pupils)) != mark:
            raise FileError(f"chunk {index} of {validation.line(self.path)} is damaged: its checksum is another")
        return made | pupils

    def whole(self, name: str) -> NDArray[Any]:
        """Return a small array, such as the error bounds; NaN where chunks of it are not there."""
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

    def given(self, name: str, index: Index) -> NDArray[Any]:
        """Return a chunk of an array that is there from the beginning, or with the mark; FileError if it is not."""
        part = self.get(name, index)
        if part is None:
            raise FileError(f"{validation.line(self.path)} lacks chunk {index} of {name}")
        return part

    def _mark(self, index: Index) -> int:
        found = self.get(MARKS, index)
        return -1 if found is None else int(found.flat[0])

    def _sum(self, index: Index, made: Arrays, pupils: int) -> int:
        """Return the checksum of a chunk, of its place in this store, and of that of its pupils."""
        return crc32({"chunk": [int(i) for i in index], "store": self.said[IDENTITY], "pupils": pupils}, made)


def replaced(path: Path) -> FileError:
    """Return what tells that a store is gone."""
    return FileError(
        f"{validation.line(path)} was removed, or replaced by another call of psf_to, while its PSFs were computed; "
        "call psf_to again, with a path that nobody else writes to"
    )


def missing(name: str, layout: Layout) -> float:
    """Return what stands where there is nothing yet."""
    return -1 if name == MARKS else np.nan if layout.dtype[1] == "f" else 0


def units(said: dict[str, Any], name: str) -> dict[str, str]:
    """Return the attributes of an array: its unit, if it is a coordinate."""
    unit = said["axes"].get(name, said["unit"] if name in ("y", "x") else None)
    return {} if unit is None else {"units": unit}


def checked(description: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Layout]]:
    """Return the description of a store, checked, and its arrays."""
    if description["checksum"] != checksum(description, {}):
        raise ValueError("its description was changed after it was written")
    said = {name: value for name, value in description.items() if name != "checksum"}
    if said["format"] != FORMAT:
        raise ValueError(f"it is of format {said['format']}, and this version reads {FORMAT}")
    if not isinstance(said[IDENTITY], str) or len(said[IDENTITY]) != 32 or not said[IDENTITY].isalnum():
        raise ValueError(f"its identity must be 32 letters and digits, got {validation.shown(said[IDENTITY])}")
    return said, layouts(said)
