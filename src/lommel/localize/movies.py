"""Movies of cameras: TIFF and OME-TIFF files of any length, read in blocks of frames."""

from __future__ import annotations

import re
import threading
from collections.abc import Iterator
from os import PathLike
from pathlib import Path
from types import TracebackType
from typing import Any, NoReturn, Self

import numpy as np

from lommel.base import optional, reading, validation
from lommel.base.arrays import Values

BLOCK = 2**22
"""Pixels of a block of frames, unless it says otherwise: 32 MB of them in float64."""


class MovieError(ValueError):
    """A file that cannot be read as a movie; the message names it and says why."""


class Movie:
    """The frames of a TIFF file, which stay on the disk.

    Made by :func:`lommel.localize.open_movie`; closed by ``with`` or `close`.

    Attributes
    ----------
    shape : tuple of int
        Frames, rows, columns.
    dtype : dtype
        Integers or floats, as they are stored, in the byte order of this machine.
    path : Path

    Raises
    ------
    MovieError
        By all methods, where the file is damaged.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._file: Any = None
        self._lock = threading.Lock()  # pages share a handle
        try:
            self._open()
        except BaseException:
            self.close()
            raise

    def _open(self) -> None:
        try:
            self._file, errors = reading.tiff_on_disk(self.path)
            series = self._file.series
        except Exception as error:  # of tifffile's parser among others
            self._refuse(reading.reason(error), error)
        if errors:  # tifffile goes on with the pages before
            self._refuse(f"it is cut off or damaged: {validation.brief(re.sub('^<.*?> ', '', errors[0]))}")
        if len(series) != 1:
            shapes = " and ".join(" x ".join(map(str, one.shape)) for one in series[:3])
            self._refuse(f"it holds {len(series)} series of images, {shapes}; save the movie alone")
        if words := reading.tiff_left_out(self._file):
            self._refuse(f"it holds {words}; save it again")
        (self._series,) = series
        axes, shape = self._series.axes, self._series.shape
        if "S" in axes or axes[-2:] != "YX" or len(axes) > 3:
            way = "write it with photometric='minisblack'" if "S" in axes else "save one channel and plane as a movie"
            sizes = " x ".join(map(str, shape))
            self._refuse(f"its axes are {axes} ({sizes}), not frames, rows and columns in grey: {way}")
        self.dtype = np.dtype(self._series.dtype).newbyteorder("=")
        if self.dtype.kind not in "iuf":
            self._refuse(f"it holds {self.dtype}, neither integers nor floats")
        self.shape: tuple[int, int, int] = (shape[0] if len(shape) == 3 else 1, *shape[-2:])
        self._mapped: Values | None = None
        try:
            self._mapped = reading.tiff_mapped(self._file, self._series, self.path, len(self))
        except ValueError as error:
            self._refuse(str(error))

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
        self._mapped = None
        if self._file is not None:
            self._file.close()

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
        if self._mapped is not None:
            found = np.array(self._mapped[begin:end], self.dtype)
        else:
            found = np.empty((end - begin, *self.shape[1:]), self.dtype)
            for k in range(begin, end):
                found[k - begin] = self._frame(k)
        return found

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

    def _frame(self, k: int) -> Values:
        """Return one frame of a file in pieces."""
        try:
            with reading.quietly(), self._lock:
                if (page := self._series.pages[k]) is None:
                    raise ValueError("it is missing; are all files of this OME-TIFF in one folder?")
                found: Values = reading.tiff_values(page, self.shape[1:], self.dtype)
        except Exception as error:  # of tifffile, zlib and others
            self._refuse(f"frame {k} cannot be read: {reading.reason(error)}", error)
        return found

    def _refuse(self, why: str, error: BaseException | None = None) -> NoReturn:
        if isinstance(error, OSError) and error.filename is not None:  # which says why itself
            raise error
        raise MovieError(f"{validation.line(self.path)} cannot be read as a movie: {why}") from error


def open_movie(path: str | PathLike[str]) -> Movie:
    """Open a movie: a TIFF or OME-TIFF file of grey frames, of which only those asked for are read.

    Files of any length, also BigTIFF and the one long image of ImageJ, uncompressed or with deflate, PackBits or
    (where imagecodecs is installed) LZW; frames of integers or floats. Frames in one piece are mapped into memory.

    Parameters
    ----------
    path : path

    Returns
    -------
    Movie

    Raises
    ------
    MovieError
        If the file is no TIFF file or damaged, or holds colours or several series of images.
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
    optional.require("tifffile", "movies need", "images")
    return Movie(source)
