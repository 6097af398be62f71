"""A disk that can only be read."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, NoReturn

import pytest


@contextmanager
def read_only() -> Iterator[None]:
    """Nothing can be made, renamed or removed, nor opened to write, as where a file system is mounted read-only."""

    def refused(path: Any, *_: object, **__: object) -> NoReturn:
        raise OSError(errno.EROFS, os.strerror(errno.EROFS), os.fspath(path))

    def opened(path: Any, flags: int, *rest: Any, **more: Any) -> int:
        return refused(path) if flags & (os.O_WRONLY | os.O_RDWR | os.O_CREAT) else true(path, flags, *rest, **more)

    true = os.open
    with pytest.MonkeyPatch.context() as patch:
        for name in ("mkdir", "rename", "replace", "unlink", "rmdir", "link"):
            patch.setattr(os, name, refused)
        patch.setattr(os, "open", opened)
        yield
