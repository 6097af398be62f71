"""Copies of stacks that are stored in chunks: each chunk is read once, to memory or to a temporary file."""

from __future__ import annotations

import itertools
import math
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from threading import Lock
from typing import Any, BinaryIO

import numpy as np

from lommel.base import atomic
from lommel.base.arrays import Values
from lommel.recorded.counts import PlanePart, Stack
from lommel.recorded.frames import Frames

_BLOCK_BYTES = 2**28  # largest size of a part that is read together


@contextmanager
def local_stacks(frames: Frames, place: Path | None, memory: float) -> Iterator[Sequence[Stack]]:
    """Yield the channels of images along C, Z, Y, X; reading the planes of these stacks loads no chunk again.

    Chunks are copied to memory or, for an output in the folder `place`, to a temporary file beside it, which is
    removed at the end. As many chunks are read together as fit into `memory` bytes, and at least one. Images that are
    not stored in chunks are copied to memory if they fit into `memory` bytes together, else read on demand.
    """
    shape = frames.shape
    if not frames.planes.chunk_sizes and math.prod(shape) * frames.dtype.itemsize <= memory:
        yield list(frames[...])
    elif not frames.planes.chunk_sizes:
        yield [frames.one_of("C", channel) for channel in range(shape[0])]
    elif place is None:
        values = np.empty(shape, frames.dtype)
        for channel, plane, rows, columns, part in _parts(frames, memory):
            values[channel, plane, rows, columns] = part
        yield list(values)
    else:
        with atomic.closed(lambda: tempfile.TemporaryFile(dir=place.parent), place) as file:
            stacks = [_FileStack(file, Lock(), shape[1:], frames.dtype) for _ in range(shape[0])]
            for channel, plane, rows, columns, part in _parts(frames, memory):
                with atomic.as_path_error(place):
                    stacks[channel].append(plane, rows, columns, part)
            yield stacks


class _FileStack:
    """A stack whose planes are in a file, in the parts in which they were read."""

    def __init__(self, file: BinaryIO, lock: Lock, shape: tuple[int, ...], dtype: np.dtype[Any]) -> None:
        self._file, self._lock, self.shape, self.dtype = file, lock, shape, dtype
        # Rows, columns, and position in the file, of the parts of each plane.
        self._parts: list[list[tuple[slice, slice, int]]] = [[] for _ in range(shape[0])]

    def __len__(self) -> int:
        return self.shape[0]

    def append(self, plane: int, rows: slice, columns: slice, values: Values) -> None:
        """Write a part of a plane at the end of the file."""
        self._parts[plane].append((rows, columns, self._file.tell()))
        self._file.write(np.ascontiguousarray(values).data)

    def __getitem__(self, index: PlanePart) -> Values:
        plane, *slices = index if isinstance(index, tuple) else (index,)
        (top, bottom, _), (left, right, _) = (
            part.indices(side)
            for part, side in zip((*slices, slice(None), slice(None)), self.shape[1:], strict=False)
        )
        values = np.empty((bottom - top, right - left), self.dtype)
        for rows, columns, position in self._parts[plane]:
            first, end = max(rows.start, top), min(rows.stop, bottom)
            start, stop = max(columns.start, left), min(columns.stop, right)
            if first < end and start < stop:
                width = columns.stop - columns.start
                with self._lock:
                    self._file.seek(position + (first - rows.start) * width * self.dtype.itemsize)
                    data = self._file.read((end - first) * width * self.dtype.itemsize)
                part = np.frombuffer(data, self.dtype).reshape(-1, width)
                inner = part[:, start - columns.start : stop - columns.start]
                values[first - top : end - top, start - left : stop - left] = inner
        return values


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
