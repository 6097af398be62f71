"""Restored values: an array, or an OME-Zarr folder that is written chunk by chunk and renamed when complete."""

from __future__ import annotations

import hashlib
import tempfile
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from os import PathLike
from pathlib import Path
from typing import Any, Literal

import numpy as np

from lommel.base import atomic, reading, validation
from lommel.base.arrays import Values
from lommel.base.atomic import Unfinished
from lommel.base.optional import version
from lommel.base.validation import line, shown
from lommel.io import zarr_folders
from lommel.recorded import stack_files
from lommel.recorded.counts import Stack
from lommel.recorded.frames import Frames

Chunk = tuple[Any, ...]
"""The place of a chunk: time in a series, channel, planes, rows, columns."""


class Target:
    """Destination of restored values: an array, or an OME-Zarr folder that is renamed to `out` when complete."""

    def __init__(self, shape: tuple[int, ...], unfinished: Unfinished | None) -> None:
        self.shape, self.unfinished = shape, unfinished
        self._array: Any = None
        if unfinished is None and len(shape) > 4:  # of a time series one time point is in memory
            with tempfile.TemporaryFile() as file:
                self._array = np.memmap(file, np.float32, "w+", shape=shape)
        elif unfinished is None:
            self._array = np.zeros(shape, np.float32)
        else:
            with _zarr_errors(unfinished):
                self._array = _open_group(unfinished.new, "r+")["0"]
                if getattr(self._array, "shape", None) != shape:
                    raise ValueError("its array is missing or has another shape")
        self._complete_chunks: list[tuple[str, Chunk]] = []

    def has(self, request: str, chunk: Chunk) -> bool:
        """Return whether a chunk is unchanged since it was written for `request`, a checksum of its inputs."""
        if self.unfinished is None or not self._is_unchanged(request, chunk):
            return False
        self._complete_chunks.append((request, chunk))
        return True

    def _is_unchanged(self, request: str, chunk: Chunk) -> bool:
        assert self.unfinished is not None
        with _zarr_errors(self.unfinished):
            return self.unfinished.is_complete(_chunk_name(chunk), request, self._stored(chunk))

    def _stored(self, chunk: Chunk) -> Values:
        return np.asarray(zarr_folders.awaited(lambda: self._array.async_array.getitem(chunk), _Immediate()))

    def put(self, request: str, chunk: Chunk, values: Values) -> None:
        """Write a chunk, and record its request."""
        if self.unfinished is None:
            self._array[chunk] = values
            return
        self.unfinished.require_there()
        with _zarr_errors(self.unfinished):
            zarr_folders.awaited(lambda: self._array.async_array.setitem(chunk, values), _Immediate())
        self.unfinished.record(_chunk_name(chunk), request, values)
        self._complete_chunks.append((request, chunk))

    def finish(self, description: str, channels: int) -> Any:
        """Return the values of the restored channels, or times; a folder is renamed to its final name before."""
        if self.unfinished is None and len(self.shape) > 4:
            times, rest = divmod(channels, self.shape[1])
            if rest:  # interrupted
                self._array[times, rest:] = np.nan
            return self._array[: times + bool(rest)]
        if self.unfinished is None:
            values = self._array[:channels]
            return values[0] if self.shape[0] == 1 else values
        # Check again: another process may have replaced chunks since this call checked or wrote them.
        if not all(self._is_unchanged(*entry) for entry in self._complete_chunks):
            raise ValueError(f"chunks in {line(self.unfinished.scratch)} were changed by another process; call again")
        stack_files.require_own(self.unfinished.place)
        with _zarr_errors(self.unfinished):
            _open_group(self.unfinished.new, "r+").attrs["lommel"] = {"description": description}
        self.unfinished.finish()
        return _open_group(self.unfinished.place, "r")["0"]  # with an axis of channels, as stored


class _Immediate(ThreadPoolExecutor):
    """Executor that calls functions at once: each of the threads of zarr, some per processor, keeps freed memory."""

    def submit(self, function: Callable[..., Any], /, *given: Any, **options: Any) -> Future[Any]:
        future: Future[Any] = Future()
        try:
            future.set_result(function(*given, **options))
        except Exception as error:
            future.set_exception(error)
        return future


@contextmanager
def _zarr_errors(unfinished: Unfinished) -> Iterator[None]:
    """Convert errors of zarr to a ValueError that names the hidden folder; zarr has one chunk in memory at a time."""
    import zarr

    try:
        with atomic.as_path_error(unfinished.place), zarr.config.set({"async.concurrency": 1}):
            yield
    except Exception as error:  # zarr raises many types on damaged files
        if isinstance(error, OSError | MemoryError) or "can't start new thread" in str(error):
            raise
        raise ValueError(f"{line(unfinished.scratch)} is damaged ({reading.reason(error)}); remove it") from None


def _chunk_name(chunk: Chunk) -> str:
    return ".".join(map(str, (*chunk[:-3], chunk[-2].start, chunk[-1].start)))


@contextmanager
def destination(out: str | PathLike[str] | None, shape: tuple[int, ...], recording: Frames) -> Iterator[Target]:
    """Yield the destination of values: an array, or with `out` a folder that an earlier call may have begun."""
    if out is None:
        yield Target(shape, None)
        return
    place = validation.path("out", out)
    if stack_files.kind_of(place, recording.path) != "zarr":
        raise ValueError(f"out must end in .zarr, which is written chunk by chunk, got {shown(place.name)}")
    if not place.parent.is_dir():
        raise FileNotFoundError(2, "No such file or directory", str(place.parent))
    metadata = {name: recording.metadata[name] for name in ("pixel", "step", "names", "emission")}
    request = {"software": f"lommel {version()}", "shape": shape} | metadata
    with atomic.unfinished_folder(
        place, request, lambda folder: stack_files.new_zarr(folder, shape, recording, place.stem)
    ) as unfinished:
        yield Target(shape, unfinished)


def _open_group(folder: Path, mode: Literal["r", "r+"]) -> Any:
    """Open the Zarr group in a folder."""
    import zarr

    return zarr.open(str(folder), mode=mode)


def checksum(stack: Stack) -> str:
    """Return the checksum of all values of a stack, plane by plane."""
    digest = hashlib.sha256()
    for plane in range(len(stack)):
        digest.update(np.ascontiguousarray(stack[plane]).reshape(-1).data)
    return digest.hexdigest()
