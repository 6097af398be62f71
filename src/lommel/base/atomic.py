"""Atomic writes of files and folders: written under a temporary name beside the target, then renamed."""

from __future__ import annotations

import errno
import io
import os
import secrets
import shutil
import stat
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import lru_cache
from pathlib import Path
from typing import Any, Protocol, TypeVar

from lommel.base.validation import line

# Short, so that it fits wherever the name asked for does, and such that nobody else's file is called so.
_PREFIX = ".lommel-"
_DAY = 86400.0
_NEW = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)  # of Windows, which else changes line ends


class _Closing(Protocol):
    def close(self) -> object: ...


_Open = TypeVar("_Open", bound=_Closing)


def contents(save: Callable[..., object], *args: Any, **options: Any) -> bytes:
    """Return what a function writes into the file that is its first argument."""
    file = io.BytesIO()
    save(file, *args, **options)
    return file.getvalue()


def write(target: Path, data: bytes) -> None:
    """Write a file; see :func:`together`."""
    with together() as put:
        put(target, data)


@contextmanager
def together(room: Path | None = None) -> Iterator[Callable[[Path, bytes | memoryview], None]]:
    """Yield a writer of paths and contents; at the end all files move into place, or none after an error.

    Until then they are in the folder of each, or in a `room`.
    """
    with _made(room) as make:

        def put(target: Path, data: bytes | memoryview) -> None:
            with told_as(target):
                make(target).write_bytes(data)

        yield put


@contextmanager
def _made(room: Path | None = None, *, new: bool = False) -> Iterator[Callable[[Path], Path]]:
    """Yield what makes an empty file for a target, and returns its path; at the end they get the names of these."""
    # Links are followed, permissions kept; a hard link is cut, since the other name keeps the old contents. Contents
    # are on the disk before a name is given to them. Remains of a killed process are removed a day later, by the
    # next write.
    made: list[tuple[Path, Path, int | None]] = []
    if room is not None:
        _sweep(room)

    def make(target: Path) -> Path:
        with told_as(target):
            place = _place(target)
            temporary = (room or place.parent) / (_PREFIX + secrets.token_hex(8))
            mode = stat.S_IMODE(place.stat().st_mode) if place.exists() else None
            made.append((temporary, place, mode))  # first, lest an interrupt come between
            # 0o666 is what the umask, which belongs to the whole process, takes from.
            os.close(os.open(temporary, _NEW, 0o666 if mode is None else 0o600))
        return temporary

    try:
        yield make
        for temporary, place, mode in made:
            with told_as(place):
                _settle(temporary)
                if mode is not None:
                    temporary.chmod(mode)
        for temporary, place, _ in made:
            with told_as(place):
                _link(temporary, place) if new else temporary.replace(place)
        for folder in {place.parent for _, place, _ in made}:
            _settle(folder)
    finally:
        for temporary, _, _ in made:
            with suppress(OSError):  # there is none, or nothing can be removed where nothing could be written
                temporary.unlink()


def write_by(target: Path, fill: Callable[[Path], None]) -> None:
    """Write a file through `fill`, which gets a temporary path."""
    with placed(target) as temporary, told_as(target):
        fill(temporary)


@contextmanager
def placed(target: Path, *, new: bool = False) -> Iterator[Path]:
    """Yield the path of an empty file, which gets the name of `target` at the end; after an error there is none.

    FileExistsError if `new` and there is a file of that name.
    """
    with _made(new=new) as make:
        yield make(target)


def _link(temporary: Path, place: Path) -> None:
    """Give a file a name that nothing has."""
    try:
        os.link(temporary, place)
    except OSError:
        if place.exists():
            raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST)) from None
        temporary.replace(place)  # on a file system without hard links


def write_folder(target: Path, fill: Callable[[Path], None], *, new: bool = False) -> None:
    """Write a folder that `fill` makes at the path it is given, as `write_by` writes a file."""
    with told_as(target):
        place = Path(os.path.realpath(target))
        _sweep(place.parent)
        room = place.with_name(_PREFIX + secrets.token_hex(8))
        room.mkdir()
        try:
            fill(room / "new")
            move_folder(room, place, new=new)
        finally:
            shutil.rmtree(room, ignore_errors=True)


def move_folder(room: Path, place: Path, *, new: bool = False) -> None:
    """Move the folder `new` of a room into place; what was there is then `old` in the room, if it need not be new."""
    try:
        mode = stat.S_IMODE((place if place.exists() else room).stat().st_mode)
        for path in (room / "new", *(room / "new").rglob("*")):
            path.chmod(mode if path.is_dir() else mode & 0o666)
            _settle(path)
        if place.exists() and not new:
            # Two renames: there is no moment at which neither folder exists.
            place.replace(room / "old")
        (room / "new").replace(place)
        _settle(place.parent)
    finally:
        put_back(room, place)


def put_back(room: Path, place: Path) -> None:
    """Give the folder `old` of a room its name again, if nothing has taken it."""
    if (room / "old").exists() and not place.exists():
        (room / "old").replace(place)


def _place(target: Path) -> Path:
    """Return the path that a file is to have, links followed."""
    place = Path(os.path.realpath(target))
    if place.exists() and not place.is_file():
        # A device, say, that is not to become a file.
        raise IsADirectoryError(21, "is a directory") if place.is_dir() else OSError(22, "is no regular file")
    _sweep(place.parent)
    return place


@contextmanager
def told_as(target: Path) -> Iterator[None]:
    """Tell an error of the operating system with the name that was asked for."""
    try:
        yield
    except OSError as error:
        if error.errno == errno.ENOTEMPTY:  # a folder is there, which none takes the place of
            error = FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST))
        elif error.errno is None:  # of NumPy, that less was written than it asked for
            error = OSError(errno.ENOSPC, f"could not be written whole, as on a disk that is full ({error})")
        raise type(error)(error.errno, error.strerror, str(target)) from None


@contextmanager
def opened(target: Path, mode: str = "wb", **options: Any) -> Iterator[Any]:
    """Yield a file that gets the name of `target` at the end; errors of closing it are told with that, too."""
    with placed(target) as temporary, closed(lambda: temporary.open(mode, **options), target) as file:
        yield file


@contextmanager
def closed(make: Callable[[], _Open], target: Path) -> Iterator[_Open]:
    """Yield what is made to write a file, and close it; errors of both are told with the name of `target`."""
    with told_as(target):
        file = make()
    try:
        yield file
    except BaseException:
        with suppress(OSError):  # of what is left to write, where a write failed
            file.close()
        raise
    with told_as(target):
        file.close()


def _settle(path: Path) -> None:
    """Have what a file, or a folder of names, holds on the disk."""
    try:
        handle = os.open(path, os.O_RDWR if sys.platform == "win32" else os.O_RDONLY)
    except PermissionError:
        return  # Windows opens no folders.
    try:
        os.fsync(handle)
    except OSError as error:
        if error.errno in (errno.ENOSPC, errno.EIO):
            raise
        # Some file systems do not know this of folders.
    finally:
        os.close(handle)


@lru_cache(maxsize=64)
def _sweep(folder: Path) -> None:
    """Remove, once a process, what others left in a folder a day ago; but never the only copy of anything."""
    try:
        with os.scandir(folder) as entries:
            ours = [entry for entry in entries if entry.name.startswith(_PREFIX)]
            old = [Path(one.path) for one in ours if time.time() - one.stat(follow_symlinks=False).st_mtime > _DAY]
    except OSError:
        return  # What is wrong with the folder, the write will tell.
    for path in old:
        if not path.is_dir():
            with suppress(OSError):  # of somebody else
                path.unlink()
        elif not (path / "old").exists():
            shutil.rmtree(path, ignore_errors=True)


if sys.platform != "win32":
    import fcntl

_held: set[int] = set()
# Errors of file systems without locks, such as some network drives.
_NO_LOCKS = {errno.ENOLCK, errno.ENOSYS, errno.ENOTSUP, errno.EOPNOTSUPP, errno.EINVAL, errno.EBADF}


@contextmanager
def in_use(mark: Path, place: Path, *, alone: bool = True) -> Iterator[bool]:
    """Hold the file by which calls write to a place, alone or shared with others; ValueError if that cannot be.

    Yield whether the file system tells. Nothing is written for it, so nothing of a killed process has to be judged or
    cleared away.
    """
    if sys.platform == "win32" and alone:
        yield True  # nothing takes the place of a file that is open, not even who holds it
        return
    with told_as(place):
        handle = os.open(mark, os.O_RDWR)
    _held.add(handle)
    known = True
    try:
        try:
            if sys.platform != "win32":
                fcntl.flock(handle, (fcntl.LOCK_EX if alone else fcntl.LOCK_SH) | fcntl.LOCK_NB)
        except BlockingIOError:
            raise ValueError(
                f"{line(place)} is being written by another call; wait until that has ended, or name another"
            ) from None
        except OSError as error:
            if error.errno not in _NO_LOCKS:
                raise
            known = False
        yield known
    finally:
        if handle in _held:  # of this process, not of a parent
            _held.discard(handle)
            os.close(handle)


def unsure(place: Path) -> ValueError:
    """Return the error for a place that may not be begun anew, since another call may write to it."""
    return ValueError(
        f"{line(place)} was begun by another call, and its file system does not tell whether that goes on; remove it "
        "if it does not, or name another"
    )


def _let_go() -> None:
    """In a child, close what its parent holds: else the child would hold it too, for as long as it lives."""
    while _held:
        os.close(_held.pop())


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_let_go)
