"""Stacks in Zarr folders: a file for each chunk."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic
from lommel.base.checksums import sealed
from lommel.base.optional import library
from lommel.io.psf_files import told
from lommel.stacks.layout import Index, layouts
from lommel.stacks.store import KEY, WHAT, Arrays, Store, checked, missing, units


class ZarrStore(Store):
    """A Zarr group of version 3, its arrays stored plainly."""

    @classmethod
    def create(cls, path: Path, said: dict[str, Any], arrays: Arrays) -> None:
        """Write the folder."""
        zarr = library("zarr", "stacks in .zarr need", "zarr")

        def fill(folder: Path) -> None:
            group = zarr.create_group(folder, zarr_format=3, attributes={KEY: sealed(said, {})})
            for name, layout in layouts(said).items():
                made = group.create_array(
                    name,
                    shape=layout.shape,
                    dtype=layout.dtype,
                    chunks=layout.chunks,
                    compressors=None,
                    filters=None,
                    fill_value=missing(name, layout),
                    chunk_key_encoding={
                        "name": "default",
                        "separator": ".",
                    },  # one folder, whose names one call settles
                    dimension_names=list(layout.dimensions),
                    attributes=units(said, name),
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
        with told(path, WHAT):
            said, found = checked(json.loads((path / "zarr.json").read_bytes())["attributes"][KEY])
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
        with told(self.path, WHAT):
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
