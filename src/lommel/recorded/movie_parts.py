"""Parts of movies that workers read: of files, of arrays in chunks (dask, Zarr), and of arrays in memory."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import executors, validation
from lommel.base.arrays import Values
from lommel.base.optional import library
from lommel.io import zarr_folders
from lommel.recorded.frames import UNKNOWN, Frames, RecordingError, Source, block_size, sizes_of_chunks


@dataclass(frozen=True, eq=False)
class _InFile:
    """Images of a file that is opened where they are read: an error while they are unpickled would end a worker."""

    source: Source
    planes: NDArray[np.intp]

    def opened(self) -> Frames:
        return replace(self.source.opened(), numbers=self.planes, axes=f"{UNKNOWN}YX")


@dataclass(frozen=True, eq=False)
class Part:
    """Images `first` to `last` - 1 of a movie, read where they are used: workers open files and chunks.

    `images` begin at the number `start` of the movie. Files, and arrays of Zarr and dask, are sent to workers as they
    are; other images are read before.
    """

    images: Any
    first: int
    last: int
    start: int = 0
    at_worker: bool = False

    def read(self) -> Values:
        """Return the images, with a mask if the array has one."""
        source = self.images.opened() if isinstance(self.images, _InFile) else self.images
        if self.at_worker:
            _check_seen(source)
        try:
            images: Any = zarr_folders.values_of(source, self._within)
            if self.at_worker and _is_dask(images):
                images = images.compute(scheduler="synchronous")  # not by the cluster, which waits for this worker
        except RuntimeError as error:  # of damaged chunks, which codecs do not name
            message = f"images {self.first} to {self.last - 1} of {validation.line(source)}: {error}"
            raise RecordingError(message) from None
        if isinstance(source, Frames):
            source.planes.release()
            return np.asarray(images)
        values, mask = validation.parted("movie", images, "counts")
        return values if mask is None else np.ma.masked_array(values, mask)

    @property
    def _within(self) -> slice:
        return slice(self.first - self.start, self.last - self.start)

    def __reduce__(self) -> tuple[type[Part], tuple[Any, ...]]:
        images, numbers = self.images, (self.first, self.last)
        if self.at_worker or zarr_folders.is_zarr(images):
            return Part, (images, *numbers, self.start, True)
        if isinstance(images, Frames) and images.planes.source is not None:
            return Part, (_InFile(images.planes.source, images.numbers[self._within]), *numbers, self.first, True)
        if not _is_dask(images):
            return Part, (self.read(), *numbers, self.first)
        (part,) = library("dask", "arrays of dask need", "").optimize(
            images[self._within]
        )  # without the other chunks
        return Part, (part, *numbers, self.first, True)


def _is_dask(images: Any) -> bool:
    return type(images).__module__.partition(".")[0] == "dask"


def _check_seen(images: Any) -> None:
    # Chunks of a Zarr array that are missing count as empty: without its folder all would.
    for stored in zarr_folders.stored_arrays(images):
        root = zarr_folders.folder_of(stored)
        if root is not None and not root.exists():
            raise RecordingError(executors.unseen(root))


def parts_of(images: Any, size: int | None) -> Iterator[tuple[Part, list[slice]]]:
    """Yield parts of images to be read at once, and their blocks as slices: blocks that lie in the same chunk.

    `size` is the number of images of a block, by default 4194304 pixels.
    """
    size = block_size(images.shape, size)
    if isinstance(images, Frames):
        together = images.planes.together
    else:
        chunks = None if isinstance(images, np.ndarray) else getattr(images, "chunks", None)
        together = max(sizes_of_chunks(images.shape, chunks)[0]) if isinstance(chunks, tuple) else 1
    length, total = size * -(-together // size), images.shape[0]
    for first in range(0, total, length):
        last = min(first + length, total)
        yield Part(images, first, last), [slice(k, min(k + size, last)) for k in range(first, last, size)]
