"""Copies of stacks that are stored in chunks: each chunk is read once, to memory or to a temporary file."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from lommel.base import atomic, executors
from lommel.base.arrays import Values
from lommel.base.atomic import Unfinished
from lommel.recorded.counts import PlanePart, Stack
from lommel.recorded.frames import Frames, RecordingError

_BLOCK_BYTES = 2**22  # largest size of a part that is read together, unless a single chunk is larger


@contextmanager
def local_stacks(
    frames: Frames, unfinished: Unfinished | None, memory: float, *, shared: bool = False
) -> Iterator[Sequence[Stack]]:
    """Yield the channels of images along C, Z, Y, X; reading the planes of these stacks loads no chunk again.

    Chunks are copied to memory or, for an output in an `unfinished` folder, to a file in it, which is removed at the
    end. As many chunks are read together as fit into `memory` bytes, and at least one. Images that are not stored in
    chunks are copied to memory if they fit into `memory` bytes together, else read on demand. If the stacks are
    `shared` with workers, which read files, arrays in memory are copied to the file, too.
    """
    shape, chunked = frames.shape, bool(frames.planes.chunk_sizes)
    if unfinished is not None and (chunked or (shared and frames.planes.source is None)):
        place = unfinished.place
        with atomic.scratch_folder(unfinished.scratch) as folder:
            path = folder / "planes"
            stacks = [_FileStack(path, shape[1:], frames.dtype) for _ in range(shape[0])]
            with atomic.closed(lambda: path.open("wb"), place) as file:
                for channel, plane, rows, columns, part in _parts(frames, memory) if chunked else _planes(frames):
                    with atomic.as_path_error(place):
                        stacks[channel].append(file, plane, rows, columns, part)
            yield stacks
    elif not chunked and not shared and math.prod(shape) * frames.dtype.itemsize <= memory:
        yield list(frames[...])
    elif not chunked:
        yield [frames.one_of("C", channel) for channel in range(shape[0])]
    else:
        values = np.empty(shape, frames.dtype)
        for channel, plane, rows, columns, part in _parts(frames, memory):
            values[channel, plane, rows, columns] = part
        yield list(values)


class _FileStack:
    """A stack whose planes are in a file, in the parts in which they were read."""

    def __init__(self, path: Path, shape: tuple[int, ...], dtype: np.dtype[Any]) -> None:
        self._path, self.shape, self.dtype = path, shape, dtype
        # Rows, columns, and position in the file, of the parts of each plane.
        self._parts: list[list[tuple[slice, slice, int]]] = [[] for _ in range(shape[0])]

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)
        if not self._path.is_file():
            raise RecordingError(executors.unseen(self._path.parents[2]))

    def __len__(self) -> int:
        return self.shape[0]

    def append(self, file: BinaryIO, plane: int, rows: slice, columns: slice, values: Values) -> None:
        """Write a part of a plane at the end of the file."""
        self._parts[plane].append((rows, columns, file.tell()))
        file.write(np.ascontiguousarray(values).data)

    def __getitem__(self, index: PlanePart) -> Values:
        plane, *slices = index if isinstance(index, tuple) else (index,)
        (top, bottom, _), (left, right, _) = (
            part.indices(side)
            for part, side in zip((*slices, slice(None), slice(None)), self.shape[1:], strict=False)
        )
        values = np.empty((bottom - top, right - left), self.dtype)
        with self._path.open("rb") as file:
            for rows, columns, position in self._parts[plane]:
                first, end = max(rows.start, top), min(rows.stop, bottom)
                start, stop = max(columns.start, left), min(columns.stop, right)
                if first < end and start < stop:
                    width = columns.stop - columns.start
                    file.seek(position + (first - rows.start) * width * self.dtype.itemsize)
                    data = file.read((end - first) * width * self.dtype.itemsize)
                    part = np.frombuffer(data, self.dtype).reshape(-1, width)
                    inner = part[:, start - columns.start : stop - columns.start]
                    values[first - top : end - top, start - left : stop - left] = inner
        return values


def _planes(frames: Frames) -> Iterator[tuple[int, int, slice, slice, Values]]:
    """Yield channel, plane, rows, columns and values of all planes."""
    rows, columns = (slice(0, side) for side in frames.planes.sides)
    for channel, plane in np.ndindex(frames.shape[:2]):
        yield channel, plane, rows, columns, frames[channel, plane]


def _parts(frames: Frames, memory: float) -> Iterator[tuple[int, int, slice, slice, Values]]:
    """Yield channel, plane, rows, columns and values of the parts of all planes, as they are stored."""
    planes, count = frames.planes, frames.shape[1]
    stack_shape = tuple(map(sum, planes.chunk_sizes[:-2]))
    # Place of each stored image in the stacks, -1 for images of other channels and times.
    places = np.full(math.prod(stack_shape), -1)
    places[frames.numbers.ravel()] = np.arange(frames.numbers.size)
    places = places.reshape(stack_shape)
    ranges = [range(k.min(), k.max() + 1) for k in np.nonzero(places >= 0)] + [range(side) for side in planes.sides]
    sizes = zip(planes.chunk_sizes, ranges, strict=True)
    limit = int(min(memory, _BLOCK_BYTES)) // frames.dtype.itemsize
    for *images, rows, columns in itertools.product(*_joined([_chunks(*axis) for axis in sizes], limit)):
        wanted = places[tuple(images)].ravel()
        values = planes.block((*images, rows, columns)).reshape(len(wanted), rows.stop - rows.start, -1)
        for place, part in zip(wanted.tolist(), values, strict=True):
            if place >= 0:
                yield *divmod(place, count), rows, columns, part


def _chunks(sizes: Sequence[int], within: range) -> list[slice]:
    """Return the chunks along an axis, of consecutive sizes, or their parts within a range."""
    ends = list(itertools.accumulate(sizes))
    slices = [
        slice(max(end - size, within.start), min(end, within.stop)) for end, size in zip(ends, sizes, strict=True)
    ]
    return [part for part in slices if part.start < part.stop]


def _joined(axes: list[list[slice]], limit: int) -> list[list[slice]]:
    """Join consecutive slices, along the last axis first, while blocks have at most `limit` values."""
    longest = [max(part.stop - part.start for part in parts) for parts in axes]
    for axis in reversed(range(len(axes))):
        most = limit // math.prod(longest[:axis] + longest[axis + 1 :])
        joined = axes[axis][:1]
        for part in axes[axis][1:]:
            if part.stop - joined[-1].start <= most:
                joined[-1] = slice(joined[-1].start, part.stop)
            else:
                joined.append(part)
        axes[axis], longest[axis] = joined, max(part.stop - part.start for part in joined)
    return axes
