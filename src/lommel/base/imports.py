"""Lazy imports: modules of a package are imported on first use (PEP 562), and forks wait for imports.

Forks: a child process has only the thread that forked. A module that another thread was importing would stay locked
in the child (the import system has a lock for each module), and any import of that module would wait forever. Python
protects the tables of the import system during a fork, but not the import of a module. Since most modules of this
package are imported on first use, possibly in threads, a fork waits until no other thread is importing.
"""

from __future__ import annotations

import _imp
import os
import sys
import threading
import time
from collections.abc import Callable
from importlib import _bootstrap, import_module
from typing import Any

PATIENCE = 10.0
"""Seconds after which a fork stops waiting, since an import may wait for the thread that forks."""

# Weak references to the lock of each module being imported, by name. There is no public interface to these.
_locks: dict[str, Any] = _bootstrap._module_locks  # type: ignore[attr-defined]


def _importers() -> dict[str, int | None]:
    """Return the importing thread of each module being imported; None if its import is about to begin."""
    _imp.acquire_lock()
    try:
        return {name: lock.owner for name, ref in _locks.items() if (lock := ref()) is not None}
    finally:
        _imp.release_lock()


def _wait_for_imports() -> None:
    """Wait for imports by other threads, unless this thread is importing too: they may be waiting for its import."""
    this_thread, deadline = threading.get_ident(), time.monotonic() + PATIENCE
    while (importers := _importers()) and this_thread not in importers.values() and time.monotonic() < deadline:
        time.sleep(0.001)


def _release_locks() -> None:
    """Release, in a child process, the locks of modules that threads of the parent were importing."""
    for name, owner in _importers().items():
        if owner != threading.get_ident():
            # The import began after the wait. A partly initialised module is removed, so that it is imported again.
            _locks.pop(name, None)
            if getattr(getattr(sys.modules.get(name), "__spec__", None), "_initializing", False):
                del sys.modules[name]


def guard() -> None:
    """Make all future forks of this process wait for imports; must be called only once."""
    if hasattr(os, "register_at_fork"):
        os.register_at_fork(before=_wait_for_imports, after_in_child=_release_locks)


def parts(package: str, exports: str | None = None) -> tuple[Callable[[str], object], Callable[[], list[str]]]:
    """Return functions ``__getattr__`` and ``__dir__`` for a package whose contents are imported on first use.

    The contents are its modules and, if `exports` is given, the names in ``__all__`` of its module `exports`.
    """

    def attribute(name: str) -> object:
        if not name.startswith("_"):
            try:
                return import_module(f"{package}.{name}")
            except ModuleNotFoundError as error:
                if error.name != f"{package}.{name}":  # the module exists, but a module that it imports is missing
                    raise
        if exports is not None:
            source = import_module(f"{package}.{exports}")
            if name in ("__all__", *getattr(source, "__all__", ())):  # missing while the module is being imported
                return getattr(source, name)
        raise AttributeError(f"module {package!r} has no attribute {name!r}")

    def names() -> list[str]:
        from pkgutil import iter_modules

        module = sys.modules[package]
        exported = () if exports is None else import_module(f"{package}.{exports}").__all__
        return sorted({*vars(module), *exported, *(file.name for file in iter_modules(module.__path__))})

    return attribute, names
