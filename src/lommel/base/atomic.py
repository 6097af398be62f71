"""Atomic writing of files and folders: a file or folder gets its name only when it is complete.

A file is written under a temporary name in the folder of its final path ("target"), and then renamed.

A recording (:func:`recording`) cannot be repeated: until it is complete, its file has a name that users recognise,
and it is kept after an error or if the process is killed.

A folder that is computed part by part (:class:`Unfinished`) can be continued by a later call. Until it is complete, a
hidden folder beside the target ("scratch folder") holds `request.json`, which describes the request and is locked by
the writing call; a checksum file for each complete part; and the unfinished folder itself, named `new`.
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
import warnings
import zlib
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from functools import lru_cache
from itertools import count
from pathlib import Path
from typing import Any, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from lommel.base import reading
from lommel.base.arrays import Json, Values
from lommel.base.validation import line

# Prefix of temporary names, by which `_sweep` recognises files that a killed process has left. It is short, since
# file names have a maximum length, and no other program uses it.
_PREFIX = ".lommel-"
_SCRATCH = f"{_PREFIX}scratch-"
_DAY = 86400.0  # seconds
_MAX_NAME = 255  # maximum length of a file name, bytes
_FLAGS = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)  # no conversion of line ends


class _Closing(Protocol):
    def close(self) -> object: ...


_Open = TypeVar("_Open", bound=_Closing)


def contents(save: Callable[..., object], *args: object, **options: object) -> bytes:
    """Return the bytes that ``save(file, *args, **options)`` writes to `file`."""
    file = io.BytesIO()
    save(file, *args, **options)
    return file.getvalue()


def write(target: Path, data: bytes) -> None:
    """Write a file; see :func:`whole_files`."""
    with whole_files() as put:
        put(target, data)


@contextmanager
def whole_files(scratch: Path | None = None) -> Iterator[Callable[[Path, bytes | memoryview], None]]:
    """Yield a function (path, contents) that writes a file; at the end move all into place, after an error none.

    The temporary files are in `scratch`, by default in the folder of each target.
    """
    with _temporary_files(scratch) as create:

        def put(target: Path, data: bytes | memoryview) -> None:
            with as_path_error(target):
                create(target).write_bytes(data)

        yield put


@contextmanager
def _temporary_files(scratch: Path | None = None, *, exclusive: bool = False) -> Iterator[Callable[[Path], Path]]:
    """Yield a function that creates an empty temporary file for a target; at the end rename each to its target.

    Links are followed and permissions kept. Other hard links to the target keep the old contents. The contents are
    synchronised with the disk before the renames. Temporary files that a killed process has left are removed by a
    write that is at least a day later.
    """
    renames: list[tuple[Path, Path, int | None]] = []
    if scratch is not None:
        _sweep(scratch)

    def create(target: Path) -> Path:
        with as_path_error(target):
            place = _resolve_target(target)
            temporary = (scratch or place.parent) / (_PREFIX + secrets.token_hex(8))
            mode = stat.S_IMODE(place.stat().st_mode) if place.exists() else None
            renames.append((temporary, place, mode))  # before creating the file, since an interrupt may follow that
            # The system subtracts the umask of the process from 0o666.
            os.close(os.open(temporary, _FLAGS, 0o666 if mode is None else 0o600))
        return temporary

    try:
        yield create
        _move_into_place(renames, exclusive=exclusive)
    finally:
        for temporary, _, _ in renames:
            with suppress(OSError):  # already renamed, or in a folder without write permission
                temporary.unlink()


@contextmanager
def scratch_folder(folder: Path, kind: str = "") -> Iterator[Path]:
    """Yield a new folder in `folder`, for files that workers write before they move them into place.

    It is removed at the end: a worker that outlives the call, or of a call that was killed before this one, can no
    longer write. The caller holds the lock of `folder`, and uses one folder of a `kind` at a time.
    """
    name = f"{_SCRATCH}{kind}-"
    with as_path_error(folder):
        for left in folder.glob(f"{name}*"):
            shutil.rmtree(left, ignore_errors=True)
        scratch = folder / (name + secrets.token_hex(8))
        scratch.mkdir()
    try:
        yield scratch
    finally:
        shutil.rmtree(scratch, ignore_errors=True)


def _move_into_place(renames: list[tuple[Path, Path, int | None]], *, exclusive: bool = False) -> None:
    """Rename complete files: temporary path, final path, permissions (None: those of a new file)."""
    # All files are synchronised before the first is renamed: after an error (full disk) no file is replaced.
    for temporary, place, mode in renames:
        with as_path_error(place):
            _synchronise(temporary)
            if mode is not None:
                temporary.chmod(mode)
    for temporary, place, _ in renames:
        with as_path_error(place):
            _rename_new(temporary, place) if exclusive else temporary.replace(place)
    # A rename survives a power cut only if the folder is synchronised too.
    for folder in {place.parent for _, place, _ in renames}:
        _synchronise(folder)


@contextmanager
def temporary_for(target: Path, *, exclusive: bool = False) -> Iterator[Path]:
    """Yield the path of an empty temporary file; at the end rename it to `target`, or remove it after an error.

    FileExistsError if `exclusive` and `target` exists.
    """
    with _temporary_files(exclusive=exclusive) as create:
        yield create(target)


@dataclass
class Recording:
    """A file that is being recorded: `path` is its name until it is complete, `started` tells if it is worth keeping.

    It is synchronised with the disk at the end: a killed process loses nothing that was flushed.
    """

    path: Path
    started: bool = False


@contextmanager
def recording(target: Path) -> Iterator[Recording]:
    """Yield the new file NAME.unfinished.EXT beside `target`; at the end rename it to `target`.

    Unlike a temporary file it is kept after an error, with a warning, once a frame or row has been added. A further
    recording to the same target is NAME.unfinished-2.EXT.
    """
    with as_path_error(target):
        place = _resolve_target(target)
        mode = stat.S_IMODE(place.stat().st_mode) if place.exists() else None
        file = Recording(_create_unfinished_file(place, 0o666 if mode is None else 0o600))
    try:
        _synchronise(place.parent)  # a new name survives a power cut only then
        yield file
        _move_into_place([(file.path, place, mode)])
    except BaseException:
        if file.started:
            warnings.warn(f"{line(file.path)} keeps what was recorded", stacklevel=3)
        else:
            with suppress(OSError):
                file.path.unlink()
        raise


def _create_unfinished_file(place: Path, mode: int) -> Path:
    for number in count(1):
        ending = f".unfinished{'' if number == 1 else f'-{number}'}{place.suffix}"
        stem = os.fsencode(place.stem)[: _MAX_NAME - len(os.fsencode(ending))].decode(errors="ignore")
        path = place.with_name(stem + ending)
        with suppress(FileExistsError):  # it is being recorded by another process, or a killed one has left it
            os.close(os.open(path, _FLAGS, mode))
            break
    return path


def _rename_new(temporary: Path, place: Path) -> None:
    """Rename a file to a name that does not exist yet; FileExistsError if it exists."""
    try:
        # A hard link fails if the name exists, whereas a rename would replace the existing file.
        os.link(temporary, place)
    except OSError:
        if place.exists():
            raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST)) from None
        temporary.replace(place)  # on a file system without hard links


def write_folder(target: Path, fill: Callable[[Path], None], *, exclusive: bool = False) -> None:
    """Write a folder: `fill` creates it at a temporary path, and it is renamed to `target` when it is complete.

    FileExistsError if `exclusive` and `target` is a folder that is not empty.
    """
    with as_path_error(target):
        place = Path(os.path.realpath(target))
        _sweep(place.parent)
        scratch = place.with_name(_PREFIX + secrets.token_hex(8))
        scratch.mkdir()
        try:
            fill(scratch / "new")
            move_folder(scratch, place, exclusive=exclusive)
        finally:
            shutil.rmtree(scratch, ignore_errors=True)


def move_folder(scratch: Path, place: Path, *, exclusive: bool = False) -> None:
    """Move scratch/new to `place`; unless `exclusive`, first move an existing folder at `place` to scratch/old."""
    try:
        # The result gets the permissions of the folder that it replaces, or else of the scratch folder.
        mode = stat.S_IMODE((place if place.exists() else scratch).stat().st_mode)
        for path in (scratch / "new", *(scratch / "new").rglob("*")):
            path.chmod(mode if path.is_dir() else mode & 0o666)
            _synchronise(path)
        if place.exists() and not exclusive:
            # Two renames: at any moment the old or the new folder exists.
            place.replace(scratch / "old")
        (scratch / "new").replace(place)
        _synchronise(place.parent)
    finally:
        restore_old(scratch, place)


def restore_old(scratch: Path, place: Path) -> None:
    """Move scratch/old back to `place` if nothing exists at `place`."""
    if (scratch / "old").exists() and not place.exists():
        (scratch / "old").replace(place)


def _resolve_target(target: Path) -> Path:
    """Return the path of a target with links resolved; OSError if it is a folder, device or pipe."""
    place = Path(os.path.realpath(target))
    if place.exists() and not place.is_file():
        raise IsADirectoryError(21, "is a directory") if place.is_dir() else OSError(22, "is no regular file")
    _sweep(place.parent)
    return place


@contextmanager
def as_path_error(target: Path) -> Iterator[None]:
    """Raise an OSError again with the path `target` in place of a temporary path."""
    try:
        yield
    except OSError as error:
        if error.errno == errno.ENOTEMPTY:  # renaming a folder to an existing folder
            error = FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST))
        elif error.errno is None:  # raised by NumPy if fewer bytes were written than requested
            error = OSError(errno.ENOSPC, f"could not be written completely; the disk may be full ({error})")
        raise type(error)(error.errno, error.strerror, str(target)) from None


@contextmanager
def opened(target: Path, mode: str = "wb", **options: Any) -> Iterator[Any]:
    """Yield an open temporary file, which is renamed to `target` at the end; all errors name the path `target`."""
    with temporary_for(target) as temporary, closed(lambda: temporary.open(mode, **options), target) as file:
        yield file


@contextmanager
def closed(open_file: Callable[[], _Open], target: Path) -> Iterator[_Open]:
    """Yield the file that `open_file` opens, and close it at the end; errors of opening and closing name `target`."""
    with as_path_error(target):
        file = open_file()
    try:
        yield file
    except BaseException:
        with suppress(OSError):  # closing writes the buffer, which fails again after a failed write
            file.close()
        raise
    with as_path_error(target):
        file.close()


def _synchronise(path: Path) -> None:
    """Synchronise a file, or the directory entries of a folder, with the disk."""
    try:
        handle = os.open(path, os.O_RDWR if sys.platform == "win32" else os.O_RDONLY)
    except PermissionError:
        return  # Windows cannot open folders.
    try:
        os.fsync(handle)
    except OSError as error:
        if error.errno in (errno.ENOSPC, errno.EIO):
            raise
        # Other errors are ignored: some file systems cannot synchronise folders.
    finally:
        os.close(handle)


@lru_cache(maxsize=64)
def _sweep(folder: Path) -> None:
    """Remove temporary files older than a day from a folder; run only once per process and folder (cached)."""
    try:
        with os.scandir(folder) as entries:
            items = [entry for entry in entries if entry.name.startswith(_PREFIX)]
            # Younger files are kept, since they may belong to a running call.
            expired = [
                Path(item.path) for item in items if time.time() - item.stat(follow_symlinks=False).st_mtime > _DAY
            ]
    except OSError:
        return  # the following write reports the error
    for path in expired:
        if not path.is_dir():
            with suppress(OSError):  # a file of another user
                path.unlink()
        # A folder with `old` is kept: `old` is the only copy of the data if a process was killed between two renames.
        elif not (path / "old").exists():
            shutil.rmtree(path, ignore_errors=True)


if sys.platform != "win32":
    import fcntl

_locked_handles: set[int] = set()
# Errors of file systems without locks, such as some network drives.
_UNSUPPORTED_LOCK_ERRORS = {errno.ENOLCK, errno.ENOSYS, errno.ENOTSUP, errno.EOPNOTSUPP, errno.EINVAL, errno.EBADF}


@contextmanager
def locked(lock_file: Path, place: Path) -> Iterator[bool]:
    """Hold an exclusive lock on `lock_file`; ValueError if another call holds it.

    Yield True if the file system supports locks. Error messages name `place`, the folder that is written. The lock is
    a lock of the operating system, which ends with the process, so that a killed process leaves no lock.
    """
    if sys.platform == "win32":
        yield True  # no lock: Windows cannot replace an open file, not even for the process that opened it
        return
    with as_path_error(place):
        handle = os.open(lock_file, os.O_RDWR)
    _locked_handles.add(handle)
    supported = True
    try:
        try:
            # LOCK_NB: raise an error instead of waiting, since the other call may take hours.
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise ValueError(
                f"{line(place)} is being written by another call; wait until that has ended, or choose another path"
            ) from None
        except OSError as error:
            if error.errno not in _UNSUPPORTED_LOCK_ERRORS:
                raise
            supported = False
        yield supported
    finally:
        if handle in _locked_handles:  # False in a forked child, which has closed the handle already
            _locked_handles.discard(handle)
            os.close(handle)


def _release_inherited_locks() -> None:
    """In a forked child, close the lock files inherited from the parent; otherwise the child would keep the locks."""
    while _locked_handles:
        os.close(_locked_handles.pop())


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_release_inherited_locks)


_REQUEST_FILE = "request.json"
_IDENTITY = "identity"
_MAX_ATTEMPTS = 8  # attempts to open or create the scratch folder while other calls finish or remove it


@dataclass(frozen=True)
class Unfinished:
    """A folder that is being computed part by part, in `scratch`; its final path is `place`."""

    place: Path
    scratch: Path
    description: Json

    @property
    def new(self) -> Path:
        """Folder that is moved to `place` when it is complete."""
        return self.scratch / "new"

    @property
    def _parts(self) -> Path:
        # The name is unique, so that a call that began with an older folder cannot write into a newer folder.
        return self.scratch / str(self.description[_IDENTITY])

    def is_complete(self, name: str, request: str, values: Values) -> bool:
        """Return True if a part was recorded as complete with the same `request` and `values`."""
        try:
            return reading.contents(self._parts / name, 99) == self._part_checksum(name, request, values)
        except OSError:
            return False

    def record(self, name: str, request: str, values: Values) -> None:
        """Record that a part is complete; its values must have been written before."""
        self.require_there()
        with as_path_error(self.place):
            write(self._parts / name, self._part_checksum(name, request, values))

    def require_there(self) -> None:
        """Raise ValueError if the scratch folder was removed or replaced."""
        if not self._parts.is_dir():
            raise ValueError(f"{line(self.scratch)} was removed while it was written; repeat the call")

    def finish(self) -> None:
        """Move the complete folder to `place`, where it replaces an existing folder."""
        self.require_there()
        move_folder(self.scratch, self.place)
        self.remove()

    def remove(self) -> None:
        """Remove the scratch folder, `request.json` last: a later call can complete an interrupted removal."""
        restore_old(self.scratch, self.place)  # a process may have been killed between two renames
        for path in self.scratch.iterdir():
            if path.name != _REQUEST_FILE:
                shutil.rmtree(path)
        (self.scratch / _REQUEST_FILE).unlink()
        self.scratch.rmdir()

    def _part_checksum(self, name: str, request: str, values: Values) -> bytes:
        part = {"part": name, "of": self.description[_IDENTITY], "request": request}
        return f"crc32 {crc32(part, {'values': np.asarray(values)}):08x}".encode()


@contextmanager
def unfinished_folder(
    target: Path, request: Mapping[str, object], fill: Callable[[Path], object]
) -> Iterator[Unfinished]:
    """Yield the unfinished folder of a request; if it does not exist, ``fill(path)`` creates it at `path`.

    ValueError if another call is writing it, or if the scratch folder is damaged or of another user or program.
    An unfinished folder of another request is removed first. At the end a folder without a complete part is removed.
    """
    place = Path(os.path.realpath(target))
    scratch = place.with_name(f".{place.name}.unfinished")
    plain_request = plain(request)
    for _ in range(_MAX_ATTEMPTS):
        if (existing := _open_unfinished(place, scratch)) is None:
            with suppress(FileExistsError):  # another call may have created it at the same time
                _create_unfinished(place, scratch, plain_request, fill)
            continue
        with ExitStack() as stack:
            try:
                lockable = stack.enter_context(locked(scratch / _REQUEST_FILE, place))
            except FileNotFoundError:
                continue  # another call has just finished or removed the folder
            # Another call may have replaced the folder before this call locked it.
            if _open_unfinished(place, scratch) != existing:
                continue
            if existing.description["request"] != plain_request or not existing.new.is_dir():
                if not lockable:
                    raise ValueError(
                        f"{line(scratch)} was begun by another call, which may still be running (its file system has "
                        "no locks); remove it if that call has ended, or choose another path"
                    )
                existing.remove()
                continue
            try:
                yield existing
            finally:
                if existing._parts.is_dir() and not any(existing._parts.iterdir()):
                    with suppress(OSError):  # an error here must not replace an earlier one
                        existing.remove()
            return
    raise ValueError(f"{line(place)} is repeatedly written by other calls; choose another path")


def _create_unfinished(place: Path, scratch: Path, request: Json, fill: Callable[[Path], object]) -> None:
    identity = secrets.token_hex(16)
    description = {_IDENTITY: identity, "request": request}

    def fill_scratch(folder: Path) -> None:
        (folder / identity).mkdir(parents=True)
        fill(folder / "new")
        (folder / _REQUEST_FILE).write_text(json.dumps(sealed(description, {})), encoding="utf-8")

    with as_path_error(place):
        write_folder(scratch, fill_scratch, exclusive=True)


def _open_unfinished(place: Path, scratch: Path) -> Unfinished | None:
    """Return the unfinished folder, None if it does not exist; ValueError if `scratch` is not valid."""
    try:
        status = scratch.lstat()
        # In a shared folder another user may have created this name: refuse links and folders of other users.
        if not stat.S_ISDIR(status.st_mode) or (hasattr(os, "getuid") and status.st_uid != os.getuid()):
            raise ValueError("it is a link, a file, or belongs to another user")
        if not (paths := list(scratch.iterdir())):
            return None
        if any(path.is_symlink() for path in paths):
            raise ValueError("it holds links")
        description = reading.json(reading.contents(scratch / _REQUEST_FILE))
        if not isinstance(description, dict) or description.pop("checksum", "") != checksum(description, {}):
            raise ValueError(f"its {_REQUEST_FILE} is damaged")
    except (FileNotFoundError, ValueError) as error:
        if not os.path.lexists(scratch):  # it does not exist, or has just been removed
            return None
        reason = f"it lacks {_REQUEST_FILE}" if isinstance(error, FileNotFoundError) else reading.reason(error)
        raise ValueError(f"{line(scratch)} holds no unfinished result: {reason}; move or remove it") from None
    return Unfinished(place, scratch, description)


def plain(description: Mapping[str, object]) -> Json:
    """Return a description as JSON represents it (tuples as lists, keys as strings)."""
    result: Json = json.loads(json.dumps(description))
    return result


def sealed(description: Json, arrays: Mapping[str, NDArray[np.generic]]) -> Json:
    """Return a description with the entry "checksum" added: a checksum of the arrays and of all other entries."""
    return description | {"checksum": checksum(description, arrays)}


def checksum(description: Mapping[str, object], arrays: Mapping[str, NDArray[np.generic]]) -> str:
    """Return the checksum, as text, of a description (without its entry "checksum") and of arrays by name."""
    return f"crc32 {crc32(description, arrays):08x}"


def size_and_checksum_of_bytes(data: bytes) -> str:
    """Return the size and the checksum of the contents of a file as text."""
    return f"{len(data)} bytes, crc32 {zlib.crc32(data):08x}"


def size_and_checksum_of_file(path: Path) -> str:
    """Return the size and the checksum of a file as text; OSError if the file does not exist."""
    size, total = reading.size(path), 0  # raises an error for a pipe, on which reading would wait
    with path.open("rb") as file:
        while part := file.read(2**20):
            total = zlib.crc32(part, total)
    return f"{size} bytes, crc32 {total:08x}"


def crc32(description: Mapping[str, object], arrays: Mapping[str, NDArray[np.generic]]) -> int:
    """Return the checksum of :func:`checksum` as an integer."""
    entries = {key: value for key, value in description.items() if key != "checksum"}
    total = zlib.crc32(json.dumps(entries, sort_keys=True, allow_nan=False).encode())
    for name in sorted(arrays):
        values = arrays[name]
        # Use little-endian bytes in C order: the checksum does not depend on the machine or the memory layout.
        contiguous = np.ascontiguousarray(values, dtype=values.dtype.newbyteorder("<"))
        total = zlib.crc32(contiguous.data.cast("B") if contiguous.size else b"", zlib.crc32(name.encode(), total))
    return total
