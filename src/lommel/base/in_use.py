"""Files that are in use, as the operating system knows it: until they are closed, or their process has ended.

Nothing is written for it, so nothing of a killed process has to be judged or cleared away.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

if sys.platform != "win32":
    import fcntl

_held: set[int] = set()


@contextmanager
def in_use(path: Path, *, alone: bool = False) -> Iterator[None]:
    """Hold a file, as one of several who do, or alone.

    Raises
    ------
    BlockingIOError
        If somebody holds it, and one of both alone.
    OSError
        If there is no such file that may be written, or the file system knows nothing like this.
    """
    if sys.platform == "win32" and alone:
        yield  # nothing takes the place of a file that is open, not even who holds it
        return
    handle = os.open(path, os.O_RDWR)
    _held.add(handle)
    try:
        if sys.platform != "win32":
            fcntl.flock(handle, (fcntl.LOCK_EX if alone else fcntl.LOCK_SH) | fcntl.LOCK_NB)
        yield
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
