"""Stacks in HDF5 files: a run of bytes for each chunk, in contiguous data sets.

The user block before the HDF5 data holds the description and the offsets of the data sets, with a checksum. Chunks
are read from these offsets, so that the HDF5 library never opens a file of unknown origin or a damaged one.
"""

from __future__ import annotations

import io
import json
import math
import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO, ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from lommel.base import atomic, reading
from lommel.base.checksums import sealed
from lommel.base.optional import library
from lommel.io.psf_files import told
from lommel.stacks import store as stores
from lommel.stacks.store import Arrays, Description, Index, Layout, Store, Values

_MARK = b"lommel stack %s %12d\n"  # the identity of the store, and the length of the description that follows
_HEAD = len(_MARK % (bytes(32), 0))
_PAGE = 4096
_PLACES, _BYTES = "offsets", "bytes"  # keys of the description in this format


@dataclass(frozen=True)
class Hdf5Store(Store):
    """An HDF5 file of contiguous data sets at known offsets."""

    offsets: dict[str, int] = field(repr=False)
    one_file: ClassVar[bool] = True

    @classmethod
    def create(cls, path: Path, said: Description, arrays: Arrays, *, new: bool) -> None:
        """Write the file."""
        h5py = library("h5py", "stacks in .h5 need", "hdf5")
        found = stores.layouts(said)
        # A number has at most twenty digits.
        most = _HEAD + len(json.dumps(sealed(said, {}))) + sum(len(name) + 30 for name in found) + 200

        # The HDF5 library writes to memory, without the arrays: a full disk would end the process.
        made, offsets = _Pages(), {}
        with h5py.File(made, "w", userblock_size=max(512, 1 << most.bit_length())) as file:
            file[stores.KEY] = json.dumps(sealed(said, {}))
            for name, layout in found.items():
                data = _contiguous(h5py, file, name, layout)
                data.attrs.update(stores.units(said, name))
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
                file.truncate(made.size)
                for start, page in made.pages.items():
                    file.seek(start)
                    file.write(page[: made.size - start])
                file.seek(0)
                file.write(_MARK % (said[stores.IDENTITY].encode(), len(text)) + text)
                for name, layout in found.items():
                    if name != "values":  # which stay a hole in the file until they are written
                        empty = np.broadcast_to(np.array(stores.missing(name, layout), layout.dtype), layout.shape)
                        file.seek(offsets[name])
                        file.write(np.ascontiguousarray(arrays.get(name, empty), layout.dtype).data.cast("B"))

        atomic.write_by(path, fill, new=new)

    @classmethod
    def open(cls, path: Path) -> Self:
        """Return the store at a path."""
        size = reading.size(path)
        with told(path, stores.WHAT), path.open("rb") as file:
            mark = file.read(_HEAD).split()
            if mark[:2] != [b"lommel", b"stack"] or len(mark) != 4 or int(mark[3]) > min(size, reading.MAX_PIXELS):
                raise ValueError("no description before HDF5 begins")
            said, found = stores.checked(reading.json(file.read(int(mark[3]))))
            offsets = {name: int(said[_PLACES][name]) for name in found}
            ends = [offsets[name] + layout.nbytes for name, layout in found.items()]
            if min(offsets.values()) < 0 or max(*ends, int(said[_BYTES])) > size:
                raise ValueError(
                    f"it was written with {said[_BYTES]} bytes, or its data sets take more; it has {size}"
                )
            return cls(path, said, found, offsets)

    @property
    def own_file(self) -> Path:
        """The file itself."""
        return self.path

    def _place(self, name: str, index: Index) -> int:
        layout = self.layouts[name]
        return self.offsets[name] + layout.first(index) * np.dtype(layout.dtype).itemsize

    def marks(self) -> NDArray[np.bool_]:
        """Return which chunks are computed."""
        layout = self.layouts[stores.MARKS]
        return self._read(stores.MARKS, (0,) * len(layout.shape), layout.shape) >= 0

    def get(self, name: str, index: Index) -> Values:
        """Return a chunk, with fill values if it was not written."""
        return self._read(name, index, self.layouts[name].part(index))

    def _read(self, name: str, index: Index, shape: tuple[int, ...]) -> Values:
        place, kind = self._place(name, index), self.layouts[name].dtype
        with told(self.path, stores.WHAT):
            reading.size(self.path)  # lest it be a pipe
            return np.fromfile(self.path, kind, count=math.prod(shape), offset=place).reshape(shape)

    def put(self, parts: Arrays, index: Index) -> None:
        """Write runs of bytes into the file, if it is still this one."""
        with self._opened() as file:
            for name, part in parts.items():
                file.seek(self._place(name, index))
                file.write(np.ascontiguousarray(part, self.layouts[name].dtype).data.cast("B"))
            file.flush()
            os.fsync(file.fileno())

    @contextmanager
    def _opened(self) -> Iterator[BinaryIO]:
        """Yield the file to write into; FileError if it was replaced."""
        try:
            with atomic.told_as(self.path), self.path.open("r+b") as file:
                if file.read(_HEAD).split()[2:3] != [self.said[stores.IDENTITY].encode()]:
                    raise stores.replaced(self.path)
                yield file
        except FileNotFoundError:
            raise stores.replaced(self.path) from None


class _Pages(io.RawIOBase):
    """A sparse file in memory."""

    def __init__(self) -> None:
        self.pages: dict[int, bytearray] = {}
        self.size = self._at = 0

    def seek(self, offset: int, whence: int = io.SEEK_SET) -> int:
        """Set the position, which may be beyond the end."""
        self._at = offset + {io.SEEK_SET: 0, io.SEEK_CUR: self._at, io.SEEK_END: self.size}[whence]
        return self._at

    def tell(self) -> int:
        """Return the position."""
        return self._at

    def truncate(self, size: int | None = None) -> int:
        """Set the end."""
        self.size = self._at if size is None else size
        return self.size

    def write(self, data: Any) -> int:
        """Write at the position."""
        given = memoryview(data).cast("B")
        for start, within, part in self._parts(len(given)):
            self.pages.setdefault(start, bytearray(_PAGE))[within] = given[part]
        self._at += len(given)
        self.size = max(self.size, self._at)
        return len(given)

    def readinto(self, out: Any) -> int:
        """Read from the position; zeros from holes."""
        taken = memoryview(out).cast("B")[: max(0, self.size - self._at)]
        for start, within, part in self._parts(len(taken)):
            taken[part] = self.pages.get(start, bytes(_PAGE))[within]
        self._at += len(taken)
        return len(taken)

    def _parts(self, count: int) -> Iterator[tuple[int, slice, slice]]:
        """Yield the start of each page, its slice, and the slice of the next `count` bytes."""
        done = 0
        while done < count:
            within = (self._at + done) % _PAGE
            step = min(_PAGE - within, count - done)
            yield self._at + done - within, slice(within, within + step), slice(done, done + step)
            done += step


def _contiguous(h5py: Any, file: Any, name: str, layout: Layout) -> Any:
    """Return a new data set, allocated at once and not filled."""
    wanted = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
    wanted.set_layout(h5py.h5d.CONTIGUOUS)
    wanted.set_alloc_time(h5py.h5d.ALLOC_TIME_EARLY)
    wanted.set_fill_time(h5py.h5d.FILL_TIME_NEVER)
    parents = h5py.h5p.create(h5py.h5p.LINK_CREATE)
    parents.set_create_intermediate_group(True)
    space, of = h5py.h5s.create_simple(layout.shape), h5py.h5t.py_create(np.dtype(layout.dtype))
    h5py.h5d.create(file.id, name.encode(), of, space, dcpl=wanted, lcpl=parents)
    return file[name]
