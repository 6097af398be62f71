"""Stacks in HDF5 files: a run of bytes for each chunk, in data sets whose places do not change."""

from __future__ import annotations

import json
import math
import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic
from lommel.base.checksums import sealed
from lommel.base.optional import library
from lommel.io.psf_files import told
from lommel.stacks.layout import Index, Layout, layouts
from lommel.stacks.store import KEY, WHAT, Arrays, Store, checked, missing, units


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
                file[KEY] = json.dumps(sealed(said, {}))
                found = layouts(said)
                for name, layout in found.items():
                    data = _contiguous(h5py, file, name, layout)
                    data.attrs.update(units(said, name))
                    if name in arrays:
                        data[...] = arrays[name]
                    elif name != "values":  # which stay a hole in the file until they are there
                        data[...] = missing(name, layout)
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
        with told(path, WHAT), h5py.File(path, "r") as file:
            said, found = checked(json.loads(file[KEY][()]))
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
        with told(self.path, WHAT):
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
