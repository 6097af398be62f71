"""Files and folders that get their name when they are complete: written beside it, or part by part.

Folders that are computed part by part and get their name when they are complete; a call goes on with the parts.
Until then all is in a hidden folder beside the name: `request.json`, which says what is made, and which the call that
writes holds; a checksum of each part, of its values and of what they were computed from; and the folder, `new`.
"""

from __future__ import annotations

import errno
import io
import json
import os
import secrets
import shutil
import stat
import sys
import time
import zlib
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from lommel.base import reading
from lommel.base.arrays import Json, Values
from lommel.base.validation import line

# The prefix also says which files a later process may remove as remains of a killed one (`_sweep`).
# Short, so that it fits wherever the name asked for does, and such that nobody else's file is called so.
_PREFIX = ".lommel-"
_DAY = 86400.0
_NEW = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)  # O_BINARY: Windows converts line ends


class _Closing(Protocol):
    def close(self) -> object: ...


_Open = TypeVar("_Open", bound=_Closing)


def contents(save: Callable[..., object], *args: object, **options: object) -> bytes:
    """Return the bytes that `save` writes into the file object that is its first argument."""
    file = io.BytesIO()
    save(file, *args, **options)
    return file.getvalue()


def write(target: Path, data: bytes) -> None:
    """Write a file; see :func:`whole_files`."""
    with whole_files() as put:
        put(target, data)


@contextmanager
def whole_files(room: Path | None = None) -> Iterator[Callable[[Path, bytes | memoryview], None]]:
    """Yield a writer of paths and contents; at the end all files move into place, or none after an error.

    Until then they lie in the folder of each, or in `room`.
    """
    with _temporaries(room) as make:

        def put(target: Path, data: bytes | memoryview) -> None:
            with as_path_error(target):
                make(target).write_bytes(data)

        yield put


@contextmanager
def _temporaries(room: Path | None = None, *, new: bool = False) -> Iterator[Callable[[Path], Path]]:
    """Yield a function that makes an empty temporary file for a target; at the end the files get those names."""
    # Links are followed, permissions kept; a hard link is cut, since the other name keeps the old contents. Contents
    # are on the disk before a name is given to them. Remains of a killed process are removed a day later, by the
    # next write.
    made: list[tuple[Path, Path, int | None]] = []
    if room is not None:
        _sweep(room)

    def make(target: Path) -> Path:
        with as_path_error(target):
            place = _place(target)
            temporary = (room or place.parent) / (_PREFIX + secrets.token_hex(8))
            mode = stat.S_IMODE(place.stat().st_mode) if place.exists() else None
            made.append((temporary, place, mode))  # first, lest an interrupt come between
            # 0o666 is what the umask, which belongs to the whole process, takes from.
            os.close(os.open(temporary, _NEW, 0o666 if mode is None else 0o600))
        return temporary

    try:
        yield make
        # First all files are on the disk, then all are renamed: an error on the way, a full disk say, leaves no
        # target.
        for temporary, place, mode in made:
            with as_path_error(place):
                _settle(temporary)
                if mode is not None:
                    temporary.chmod(mode)
        for temporary, place, _ in made:
            with as_path_error(place):
                _link(temporary, place) if new else temporary.replace(place)
        # A rename survives a power cut only once the folder that holds the name is synchronised too.
        for folder in {place.parent for _, place, _ in made}:
            _settle(folder)
    finally:
        for temporary, _, _ in made:
            with suppress(OSError):  # there is none, or nothing can be removed where nothing could be written
                temporary.unlink()


def write_by(target: Path, fill: Callable[[Path], None]) -> None:
    """Write a file through `fill`, which gets a temporary path."""
    with temporary_for(target) as temporary, as_path_error(target):
        fill(temporary)


@contextmanager
def temporary_for(target: Path, *, new: bool = False) -> Iterator[Path]:
    """Yield the path of an empty file, which gets the name of `target` at the end; after an error there is none.

    FileExistsError if `new` and there is a file of that name.
    """
    with _temporaries(new=new) as make:
        yield make(target)


def _link(temporary: Path, place: Path) -> None:
    """Give a file a name that nothing has."""
    try:
        # A hard link fails where the name exists, and a rename would replace that file.
        os.link(temporary, place)
    except OSError:
        if place.exists():
            raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST)) from None
        temporary.replace(place)  # on a file system without hard links


def write_folder(target: Path, fill: Callable[[Path], None], *, new: bool = False) -> None:
    """Write a folder that `fill` makes at the path it gets; the folder gets its name when it is complete."""
    with as_path_error(target):
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
    """Move the folder `new` of a room into place; unless it must be `new` there, the former one becomes `old`."""
    try:
        # A temporary folder is made readable by its owner alone; the result has the permissions of the one it
        # replaces.
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
        restore_old(room, place)


def restore_old(room: Path, place: Path) -> None:
    """Give the folder `old` of a room its name again, if the name is free."""
    if (room / "old").exists() and not place.exists():
        (room / "old").replace(place)


def _place(target: Path) -> Path:
    """Return the real path of a target, links followed."""
    place = Path(os.path.realpath(target))
    if place.exists() and not place.is_file():
        # A device, say, that is not to become a file.
        raise IsADirectoryError(21, "is a directory") if place.is_dir() else OSError(22, "is no regular file")
    _sweep(place.parent)
    return place


@contextmanager
def as_path_error(target: Path) -> Iterator[None]:
    """Raise an error of the operating system again, with the path that the caller named."""
    try:
        yield
    # The temporary name in the original message would mean nothing to the reader.
    except OSError as error:
        if error.errno == errno.ENOTEMPTY:  # a folder is there, which none takes the place of
            error = FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST))
        elif error.errno is None:  # of NumPy, that less was written than it asked for
            error = OSError(errno.ENOSPC, f"could not be written whole, as on a disk that is full ({error})")
        raise type(error)(error.errno, error.strerror, str(target)) from None


@contextmanager
def opened(target: Path, mode: str = "wb", **options: Any) -> Iterator[Any]:
    """Yield a file that gets the name of `target` at the end; errors of closing it name that path, too."""
    with temporary_for(target) as temporary, closed(lambda: temporary.open(mode, **options), target) as file:
        yield file


@contextmanager
def closed(make: Callable[[], _Open], target: Path) -> Iterator[_Open]:
    """Yield a writer and close it at the end; errors of both name the path of `target`."""
    with as_path_error(target):
        file = make()
    try:
        yield file
    except BaseException:
        with suppress(OSError):  # of what is left to write, where a write failed
            file.close()
        raise
    with as_path_error(target):
        file.close()


def _settle(path: Path) -> None:
    """Synchronise a file, or the names in a folder, with the disk."""
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
    """Remove files that other processes left in a folder a day ago, once a process; never the only copy of data."""
    try:
        with os.scandir(folder) as entries:
            ours = [entry for entry in entries if entry.name.startswith(_PREFIX)]
            old = [Path(one.path) for one in ours if time.time() - one.stat(follow_symlinks=False).st_mtime > _DAY]
    except OSError:
        return  # What is wrong with the folder, the write will tell.
    for path in old:
        # A running call may still hold a young file: only those a day old are certain remains.
        if not path.is_dir():
            with suppress(OSError):  # of somebody else
                path.unlink()
        # `old` is what the place held before; a process killed between two renames leaves its only copy there.
        elif not (path / "old").exists():
            shutil.rmtree(path, ignore_errors=True)


if sys.platform != "win32":
    import fcntl

_held: set[int] = set()
# Errors of file systems without locks, such as some network drives.
_NO_LOCKS = {errno.ENOLCK, errno.ENOSYS, errno.ENOTSUP, errno.EOPNOTSUPP, errno.EINVAL, errno.EBADF}


@contextmanager
def locked(mark: Path, place: Path, *, alone: bool = True) -> Iterator[bool]:
    """Hold an exclusive or shared lock on the mark file of a place; ValueError if another call has it.

    Yield whether the file system has locks. The lock is one of the system, not a file: it ends with its process, and
    a killed process leaves nothing to judge or clear away.
    """
    if sys.platform == "win32" and alone:
        yield True  # nothing takes the place of a file that is open, not even who holds it
        return
    with as_path_error(place):
        handle = os.open(mark, os.O_RDWR)
    _held.add(handle)
    known = True
    try:
        try:
            # Without waiting (LOCK_NB): a call that writes for hours is told at once.
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
        if handle in _held:  # opened by this process, not inherited from its parent
            _held.discard(handle)
            os.close(handle)


def unknown_use(place: Path) -> ValueError:
    """Return the error for a place that another call may still be writing, on a file system without locks."""
    return ValueError(
        f"{line(place)} was begun by another call, and its file system does not tell whether that goes on; remove it "
        "if it does not, or name another"
    )


def _let_go() -> None:
    """Close the locks of the parent in a forked child, which would otherwise hold them for as long as it lives."""
    while _held:
        os.close(_held.pop())


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_let_go)


_MARK = "request.json"
_IDENTITY = "identity"
_TIMES = 8  # attempts to begin anew after another call has finished or removed the folder


@dataclass(frozen=True)
class Unfinished:
    """Hidden folder of a place until the result is complete."""

    place: Path
    room: Path
    said: Json

    @property
    def new(self) -> Path:
        """Folder that gets the name of the place."""
        return self.room / "new"

    @property
    def _parts(self) -> Path:
        return self.room / str(self.said[_IDENTITY])  # unique: a late call cannot write into a newer folder

    def has(self, name: str, request: str, values: Values) -> bool:
        """Return whether a part is complete and was computed from these values."""
        try:
            return reading.contents(self._parts / name, 99) == self._sum(name, request, values)
        except OSError:
            return False

    def put(self, name: str, request: str, values: Values) -> None:
        """Record that a part, whose values are written, is complete."""
        self.require_there()
        with as_path_error(self.place):
            write(self._parts / name, self._sum(name, request, values))

    def require_there(self) -> None:
        """Raise ValueError if the folder was removed."""
        if not self._parts.is_dir():
            raise ValueError(f"{line(self.room)} was removed while it was written; call again")

    def finish(self) -> None:
        """Give the folder its name, replacing a folder of that name."""
        self.require_there()
        move_folder(self.room, self.place)
        self.remove()

    def remove(self) -> None:
        """Remove the hidden folder, its mark last: until then a killed removal is recognised as ours."""
        restore_old(self.room, self.place)  # of a process that was killed between two renames
        for path in self.room.iterdir():
            if path.name != _MARK:
                shutil.rmtree(path)
        (self.room / _MARK).unlink()
        self.room.rmdir()

    def _sum(self, name: str, request: str, values: Values) -> bytes:
        described = {"part": name, "of": self.said[_IDENTITY], "request": request}
        return f"crc32 {crc32(described, {'values': np.asarray(values)}):08x}".encode()


@contextmanager
def unfinished_folder(
    target: Path, request: Mapping[str, object], fill: Callable[[Path], object]
) -> Iterator[Unfinished]:
    """Yield the unfinished folder of a request, begun by `fill` at the path it gets if there is none.

    ValueError if another call writes it, or if the hidden folder is damaged or not ours. An unfinished folder of
    another request is removed; so is, after an error, one without any complete part.
    """
    place = Path(os.path.realpath(target))
    room = place.with_name(f".{place.name}.unfinished")
    asked = plain(request)
    for _ in range(_TIMES):
        if (there := _opened(place, room)) is None:
            with suppress(FileExistsError):  # another call may have begun at the same time
                _create(place, room, asked, fill)
            continue
        with ExitStack() as hold:
            try:
                known = hold.enter_context(locked(room / _MARK, place))
            except FileNotFoundError:
                continue  # the other one has just ended
            # Between the check and the lock another call may have replaced the folder: compared again under the lock.
            if _opened(place, room) != there:
                continue
            if there.said["request"] != asked or not there.new.is_dir():
                if not known:
                    raise unknown_use(room)
                there.remove()
                continue
            try:
                yield there
            finally:
                if there._parts.is_dir() and not any(there._parts.iterdir()):
                    with suppress(OSError):  # which must not take the place of another error
                        there.remove()
            return
    raise ValueError(f"{line(place)} is written by other calls again and again; name another")


def _create(place: Path, room: Path, request: Json, fill: Callable[[Path], object]) -> None:
    identity = secrets.token_hex(16)
    said = {_IDENTITY: identity, "request": request}

    def make(folder: Path) -> None:
        (folder / identity).mkdir(parents=True)
        fill(folder / "new")
        (folder / _MARK).write_text(json.dumps(sealed(said, {})), encoding="utf-8")

    with as_path_error(place):
        write_folder(room, make, new=True)


def _opened(place: Path, room: Path) -> Unfinished | None:
    """Return the unfinished folder, None if there is none; ValueError if something else has its name."""
    try:
        ours = room.lstat()
        # Names in a shared folder may be planted by others: nothing is followed or removed that is not our own.
        if not stat.S_ISDIR(ours.st_mode) or (hasattr(os, "getuid") and ours.st_uid != os.getuid()):
            raise ValueError("it is a link, a file, or of another user")
        if not (found := list(room.iterdir())):
            return None
        if any(path.is_symlink() for path in found):
            raise ValueError("it holds links")
        said = reading.json(reading.contents(room / _MARK))
        if not isinstance(said, dict) or said.pop("checksum", "") != checksum(said, {}):
            raise ValueError(f"its {_MARK} is damaged")
    except (FileNotFoundError, ValueError) as error:
        if not os.path.lexists(room):  # or not any more
            return None
        why = f"it lacks {_MARK}" if isinstance(error, FileNotFoundError) else reading.reason(error)
        raise ValueError(f"{line(room)} holds no unfinished result: {why}; move or remove it") from None
    return Unfinished(place, room, said)


def plain(description: Mapping[str, object]) -> Json:
    """Return a description as JSON represents it (tuples as lists, keys as strings)."""
    found: Json = json.loads(json.dumps(description))
    return found


def sealed(description: Json, arrays: Mapping[str, NDArray[np.generic]]) -> Json:
    """Return a description with the checksum of the arrays of a file and of its other entries."""
    return description | {"checksum": checksum(description, arrays)}


def checksum(description: Mapping[str, object], arrays: Mapping[str, NDArray[np.generic]]) -> str:
    """Return the checksum of arrays by name and of their description."""
    return f"crc32 {crc32(description, arrays):08x}"


def of_bytes(data: bytes) -> str:
    """Return the size and checksum of the bytes of a file."""
    return f"{len(data)} bytes, crc32 {zlib.crc32(data):08x}"


def of_file(path: Path) -> str:
    """Return the size and the checksum of a file; OSError if there is none."""
    size, total = reading.size(path), 0  # refuses a pipe, which would be waited for
    with path.open("rb") as file:
        while part := file.read(2**20):
            total = zlib.crc32(part, total)
    return f"{size} bytes, crc32 {total:08x}"


def crc32(description: Mapping[str, object], arrays: Mapping[str, NDArray[np.generic]]) -> int:
    """Return the number of :func:`checksum`."""
    said = {key: value for key, value in description.items() if key != "checksum"}
    total = zlib.crc32(json.dumps(said, sort_keys=True, allow_nan=False).encode())
    for name in sorted(arrays):
        values = arrays[name]
        # Little-endian bytes in C order, so that all machines and memory layouts have the same checksum.
        plain = np.ascontiguousarray(values, dtype=values.dtype.newbyteorder("<"))
        total = zlib.crc32(plain.data.cast("B") if plain.size else b"", zlib.crc32(name.encode(), total))
    return total
