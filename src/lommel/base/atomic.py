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
from contextlib import AbstractContextManager, contextmanager, suppress
from functools import lru_cache
from pathlib import Path
from typing import Any, Protocol, TypeVar

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
    """Yield a writer of paths and contents; at the end all files move into place, or none after an error."""
    # Links are followed, permissions kept; a hard link is cut, since the other name keeps the old contents. Contents
    # are on the disk before a name is given to them. Remains of a killed process are removed a day later, by the
    # next write.
    made: list[tuple[Path, Path]] = []
    if room is not None:
        _sweep(room)

    def put(target: Path, data: bytes | memoryview) -> None:
        with told_as(target):
            place = _place(target)
            temporary, mode = (room or place.parent) / (_PREFIX + secrets.token_hex(8)), _mode(place)
            # 0o666 is what the umask, which belongs to the whole process, takes from.
            made.append((temporary, place))  # first, lest an interrupt come between
            handle = os.open(temporary, _NEW, 0o666 if mode is None else 0o600)
            with os.fdopen(handle, "wb") as file:
                if mode is not None and hasattr(os, "fchmod"):
                    os.fchmod(handle, mode)
                file.write(data)
                file.flush()
                os.fsync(handle)

    try:
        yield put
        for temporary, place in made:
            with told_as(place):
                temporary.replace(place)
        for folder in {place.parent for _, place in made}:
            _settle(folder)
    except BaseException:
        for temporary, _ in made:
            temporary.unlink(missing_ok=True)
        raise


def write_by(target: Path, fill: Callable[[Path], None], *, new: bool = False) -> None:
    """Write a file through `fill`, which gets a temporary path; FileExistsError if `new` and there is one."""
    with told_as(target), placed(target, new=new) as temporary:
        fill(temporary)


@contextmanager
def placed(target: Path, *, new: bool = False) -> Iterator[Path]:
    """Yield a temporary path, whose file gets the name of `target` at the end; after an error there is none.

    FileExistsError if `new` and there is a file of that name.
    """
    with told_as(target):
        place = _place(target)
        temporary, mode = place.with_name(_PREFIX + secrets.token_hex(8)), _mode(place)
    try:
        yield temporary
        with told_as(target):
            if mode is not None:
                temporary.chmod(mode)
            _settle(temporary)
            if new:
                _link(temporary, place)
            else:
                temporary.replace(place)
            _settle(place.parent)
    finally:
        temporary.unlink(missing_ok=True)


def _link(temporary: Path, place: Path) -> None:
    """Give a file a name that nothing has."""
    try:
        os.link(temporary, place)
    except FileExistsError:
        raise
    except OSError:  # of a file system without hard links
        if place.exists():
            raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST)) from None
        temporary.replace(place)


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


def _mode(place: Path) -> int | None:
    try:
        return stat.S_IMODE(place.stat().st_mode)
    except FileNotFoundError:
        return None


@contextmanager
def told_as(target: Path) -> Iterator[None]:
    """Tell an error of the operating system with the name that was asked for."""
    try:
        yield
    except OSError as error:
        if error.errno == errno.ENOTEMPTY:  # a folder is there, which none takes the place of
            error = FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST))
        raise type(error)(error.errno, error.strerror or str(error), str(target)) from None


def opened(temporary: Path, target: Path, mode: str = "wb", **options: Any) -> AbstractContextManager[Any]:
    """Yield a new file under a temporary name; errors of opening and closing it are told with that of `target`."""
    return closed(lambda: temporary.open(mode, **options), target)


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
        handle = os.open(path, os.O_RDONLY)
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


# Nothing is written for it, so nothing of a killed process has to be judged or cleared away.

if sys.platform != "win32":
    import fcntl

_held: set[int] = set()
# Errors of file systems without locks, such as some network drives.
_NO_LOCKS = {errno.ENOLCK, errno.ENOSYS, errno.ENOTSUP, errno.EOPNOTSUPP, errno.EINVAL, errno.EBADF}


@contextmanager
def in_use(path: Path, *, alone: bool = False) -> Iterator[bool]:
    """Hold a file, shared or alone; BlockingIOError if another process holds it. Yield whether one can tell that."""
    if sys.platform == "win32" and alone:
        yield True  # nothing takes the place of a file that is open, not even who holds it
        return
    handle = os.open(path, os.O_RDWR)
    _held.add(handle)
    known = True
    try:
        try:
            if sys.platform != "win32":
                fcntl.flock(handle, (fcntl.LOCK_EX if alone else fcntl.LOCK_SH) | fcntl.LOCK_NB)
        except OSError as error:
            if error.errno not in _NO_LOCKS:
                raise
            known = False
        yield known
    finally:
        if handle in _held:  # of this process, not of a parent
            _held.discard(handle)
            os.close(handle)


def _let_go() -> None:
    """In a child, close what its parent holds: else the child would hold it too, for as long as it lives."""
    while _held:
        os.close(_held.pop())


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_let_go)
