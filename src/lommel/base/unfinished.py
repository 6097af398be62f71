"""Folders that are computed part by part and get their name when they are complete; a call goes on with the parts.

Until then all is in a hidden folder beside the name: `request.json`, which says what is made, and which the call that
writes holds; a checksum of each part, of its values and of what they were computed from; and the folder, `new`.
"""

from __future__ import annotations

import json
import os
import secrets
import shutil
import stat
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from lommel.base import atomic, reading
from lommel.base.arrays import Values
from lommel.base.checksums import checksum, crc32, plain, sealed
from lommel.base.validation import line

_MARK = "request.json"
_IDENTITY = "identity"
_TIMES = 8  # that what another call has just finished is begun anew


@dataclass(frozen=True)
class Unfinished:
    """The folder of a place until it is complete."""

    place: Path
    room: Path
    said: dict[str, Any]

    @property
    def new(self) -> Path:
        """The folder that gets the name."""
        return self.room / "new"

    @property
    def _parts(self) -> Path:
        return self.room / str(self.said[_IDENTITY])  # which no other call has: it cannot write into a newer room

    def has(self, name: str, request: str, values: Values) -> bool:
        """Return whether a part is done, and these are its values."""
        try:
            return reading.contents(self._parts / name, 99) == self._sum(name, request, values)
        except OSError:
            return False

    def put(self, name: str, request: str, values: Values) -> None:
        """Tell that a part is done, of which the values are written."""
        self.require_there()
        with atomic.told_as(self.place):
            atomic.write(self._parts / name, self._sum(name, request, values))

    def require_there(self) -> None:
        """Raise ValueError if the folder was removed."""
        if not self._parts.is_dir():
            raise ValueError(f"{line(self.room)} was removed while it was written; call again")

    def finish(self) -> None:
        """Give the folder its name, in place of what has it."""
        self.require_there()
        atomic.move_folder(self.room, self.place)
        self.remove()

    def remove(self) -> None:
        """Remove what is there, that which tells whose it is at last."""
        atomic.put_back(self.room, self.place)  # of a process that was killed between two renames
        for path in self.room.iterdir():
            if path.name != _MARK:
                shutil.rmtree(path)
        (self.room / _MARK).unlink()
        self.room.rmdir()

    def _sum(self, name: str, request: str, values: Values) -> bytes:
        described = {"part": name, "of": self.said[_IDENTITY], "request": request}
        return f"crc32 {crc32(described, {'values': np.asarray(values)}):08x}".encode()


@contextmanager
def begun(target: Path, request: Mapping[str, Any], fill: Callable[[Path], object]) -> Iterator[Unfinished]:
    """Yield the folder of a request that is unfinished, or that `fill` begins at the path it is given.

    ValueError if another call writes it, or the hidden folder is damaged or not ours. What is unfinished of another
    request is removed; so is, after an error, what has no part yet.
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
                known = hold.enter_context(atomic.in_use(room / _MARK, place))
            except FileNotFoundError:
                continue  # the other one has just ended
            if _opened(place, room) != there:
                continue
            if there.said["request"] != asked or not there.new.is_dir():
                if not known:
                    raise atomic.unsure(room)
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


def _create(place: Path, room: Path, request: dict[str, Any], fill: Callable[[Path], object]) -> None:
    identity = secrets.token_hex(16)
    said = {_IDENTITY: identity, "request": request}

    def make(folder: Path) -> None:
        (folder / identity).mkdir(parents=True)
        fill(folder / "new")
        (folder / _MARK).write_text(json.dumps(sealed(said, {})), encoding="utf-8")

    with atomic.told_as(place):
        atomic.write_folder(room, make, new=True)


def _opened(place: Path, room: Path) -> Unfinished | None:
    """Return what is unfinished, None if nothing is; ValueError if there is something else."""
    try:
        ours = room.lstat()
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
