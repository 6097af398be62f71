"""Movies of cameras, of any length, read in blocks of frames."""

from __future__ import annotations

from collections.abc import Iterator
from os import PathLike
from pathlib import Path
from types import TracebackType
from typing import Self

from lommel.base import validation
from lommel.base.arrays import Values
from lommel.recorded.frames import Frames, RecordingError, open_frames

BLOCK = 2**22
"""Pixels of a block of frames, unless it says otherwise: 32 MB of them in float64."""


MovieError = RecordingError


class Movie:
    """The frames of a file, which stay on the disk.

    Made by :func:`lommel.localize.open_movie`; closed by ``with`` or `close`.

    Parameters
    ----------
    frames : Frames
        With one axis before the last two.
    path : Path

    Attributes
    ----------
    shape : tuple of int
        Frames, rows, columns.
    dtype : dtype
        Integers or floats, as they are stored, in the byte order of this machine.
    path : Path
    said : dict
        What the file says of its camera.
    notes : tuple of str
        What was chosen of the file, in sentences.

    Raises
    ------
    MovieError
        By all methods, where the file is damaged.
    """

    def __init__(self, frames: Frames, path: Path) -> None:
        self._frames = frames
        self.path, self.dtype, self.said, self.notes = path, frames.dtype, frames.said, frames.notes
        self.shape: tuple[int, int, int] = (len(frames), *frames.planes.sides)

    def __repr__(self) -> str:
        count, rows, columns = self.shape
        return f"<Movie {self.path.name!r}: {count} frames of {rows} x {columns}, {self.dtype}>"

    def __len__(self) -> int:
        return self.shape[0]

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Close the file."""
        self._frames.close()

    def frames(self, first: int, last: int) -> Values:
        """Return frames from `first` until before `last`, shape ``(last - first, rows, columns)``.

        Parameters
        ----------
        first, last : int
            Counted from 0.

        Returns
        -------
        ndarray
            A copy.

        Raises
        ------
        TypeError, ValueError
            If there are no such frames; MovieError if one is damaged or missing.
        """
        begin = validation.integer("first", first, least=0, most=len(self))
        end = validation.integer("last", last, least=begin, most=len(self))
        return self._frames[begin:end]

    def blocks(self, size: int | None = None) -> Iterator[Values]:
        """Yield all frames in blocks of consecutive ones.

        Parameters
        ----------
        size : int, optional
            Frames of a block, of which the last may have fewer; by default as many as have four million pixels.

        Yields
        ------
        ndarray, shape (size, rows, columns)

        Raises
        ------
        TypeError, ValueError
            If `size` is out of range; MovieError if a frame is damaged or missing.
        """
        count, rows, columns = self.shape
        each = max(1, BLOCK // (rows * columns)) if size is None else size
        validation.integer("size", each, least=1, most=validation.MAX_VALUES)
        for first in range(0, count, each):
            yield self.frames(first, min(first + each, count))


def open_movie(path: str | PathLike[str]) -> Movie:
    """Open a movie: a file of grey frames, of which only those asked for are read.

    TIFF and OME-TIFF files of any length, also BigTIFF and the one long image of ImageJ, uncompressed or with
    deflate, PackBits or LZW; OME-Zarr, FITS and NPY. Frames in one piece are mapped into memory.

    Parameters
    ----------
    path : path

    Returns
    -------
    Movie

    Raises
    ------
    MovieError
        If the file is of another format or damaged, or holds colours or several series of images.
    OSError
        If it cannot be read.
    ImportError
        If tifffile is missing.

    Examples
    --------
    >>> with open_movie("movie.tif") as movie:  # doctest: +SKIP
    ...     for block in movie.blocks(100):
    ...         print(block.shape)
    """
    source = validation.path("path", path)
    frames = open_frames(source)
    try:
        if frames.left_out:
            raise MovieError(f"{frames.name} cannot be read as a movie: it holds {frames.left_out}; save it again")
        if frames.dtype.kind not in "iuf":
            raise MovieError(f"{frames.name} cannot be read as a movie: it holds {frames.dtype}, no numbers")
        return Movie(frames.as_stack(), source)
    except BaseException:
        frames.close()
        raise
