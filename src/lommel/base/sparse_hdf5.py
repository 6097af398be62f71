"""HDF5 files made in memory without their arrays, which are then written without the HDF5 library."""

from __future__ import annotations

import io
from typing import Any, BinaryIO

import numpy as np


class Sparse(io.RawIOBase):
    """A sparse file in memory: what was written, piece by piece."""

    def __init__(self) -> None:
        self.pieces: list[tuple[int, bytes]] = []
        self.size = self._at = 0

    def copy(self, file: BinaryIO) -> None:
        """Write the pieces to a file, and set its end."""
        for start, piece in self.pieces:
            file.seek(start)
            file.write(piece)
        file.truncate(self.size)

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
        self.pieces.append((self._at, bytes(data)))
        self._at += len(self.pieces[-1][1])
        self.size = max(self.size, self._at)
        return len(self.pieces[-1][1])

    def readinto(self, out: Any) -> int:
        """Read from the position; zeros from holes."""
        taken = memoryview(out).cast("B")[: max(0, self.size - self._at)]
        taken[:] = bytes(len(taken))
        for start, piece in self.pieces:
            first, end = max(start, self._at), min(start + len(piece), self._at + len(taken))
            if first < end:
                taken[first - self._at : end - self._at] = piece[first - start : end - start]
        self._at += len(taken)
        return len(taken)


def hole(file: Any, name: str, shape: tuple[int, ...], dtype: np.dtype[Any]) -> Any:
    """Return a new data set of a file, in one piece at ``id.get_offset()``, of which nothing is written."""
    import h5py

    wanted, parents = (h5py.h5p.create(of) for of in (h5py.h5p.DATASET_CREATE, h5py.h5p.LINK_CREATE))
    wanted.set_layout(h5py.h5d.CONTIGUOUS)
    wanted.set_alloc_time(h5py.h5d.ALLOC_TIME_EARLY)
    wanted.set_fill_time(h5py.h5d.FILL_TIME_NEVER)
    parents.set_create_intermediate_group(True)
    space, of = h5py.h5s.create_simple(shape), h5py.h5t.py_create(dtype, logical=True)
    h5py.h5d.create(file.id, name.encode(), of, space, dcpl=wanted, lcpl=parents)
    return file[name]
