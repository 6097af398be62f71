"""Stacks in Zarr folders: a file for each chunk."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Self

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic
from lommel.base.checksums import sealed
from lommel.io import zarr_folders
from lommel.io.psf_files import told
from lommel.io.zarr_folders import META, ZarrArray
from lommel.stacks import store as stores
from lommel.stacks.store import Arrays, Description, Index, Store, Values


class ZarrStore(Store):
    """A Zarr group of version 3 of plain arrays.

    A chunk is written in a folder named by the identity of the store, and moved into place: another store in its
    place has no such folder, and nothing is written.
    """

    @classmethod
    def create(cls, path: Path, said: Description, arrays: Arrays, *, new: bool) -> None:
        """Write the folder."""

        def fill(folder: Path) -> None:
            zarr_folders.write_group(folder, {stores.KEY: sealed(said, {})})
            for name, layout in stores.layouts(said).items():
                ZarrArray(folder / name, layout.shape, layout.chunks, layout.dtype).create(
                    layout.dimensions,
                    fill=stores.missing(name, layout),
                    attributes=stores.units(said, name),
                    values=arrays.get(name),
                )
            ZarrArray(_scratch(folder, said), (), (), "|u1").create(())

        atomic.write_folder(path, fill, new=new)

    @classmethod
    def open(cls, path: Path) -> Self:
        """Return the store at a path."""
        if not path.is_dir():
            raise FileNotFoundError(2, os.strerror(2), str(path))
        with told(path, stores.WHAT):
            said, found = stores.checked(zarr_folders.attributes(path)[stores.KEY])
            store = cls(path, said, found)
            for name in found:
                if ZarrArray.open(path / name) != store._array(name):
                    raise ValueError(f"its array {name} is stored in another way; zarr reads it")
            return store

    @property
    def own_file(self) -> Path:
        """The description."""
        return self.path / META

    def _array(self, name: str) -> ZarrArray:
        layout = self.layouts[name]
        return ZarrArray(self.path / name, layout.shape, layout.chunks, layout.dtype)

    def marks(self) -> NDArray[np.bool_]:
        """Return which chunks are computed, by the files that exist."""
        array = self._array(stores.MARKS)
        found = np.zeros(array.grid, dtype=bool)
        with told(self.path, stores.WHAT), os.scandir(array.folder) as entries:
            for entry in entries:
                key, *numbers = entry.name.split(".")
                if key == "c" and all(number.isdecimal() for number in numbers):
                    index = tuple(int(number) for number in numbers)
                    found[index] = self._mark(index) >= 0
        return found

    def get(self, name: str, index: Index) -> Values | None:
        """Return a chunk; None if there is no file."""
        with told(self.path, stores.WHAT):
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
            raise stores.replaced(self.path) from None


def _scratch(folder: Path, said: Description) -> Path:
    """Return the folder where chunks are written, an empty array to readers of the group."""
    return folder / "chunks" / str(said[stores.IDENTITY])
