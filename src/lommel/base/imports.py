"""Imports of modules: those of a package on first use (PEP 562), and none while a process forks.

Imports and forks: a process does not fork while another of its threads imports a module.
A child process has only the thread that forked. A module that another thread was importing stays locked in the child
(the import system has a lock for each module), and any import of it waits for ever. Python protects the tables of the
import system from forks, but not the import of a module, and most of this package is imported on first use. So a fork
waits until no import is under way.
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
"""Seconds after which a fork waits no longer: an import may itself wait for the thread that forks."""

# Weak references to the lock of each module being imported, by name; Python has no public list of these.
_locks: dict[str, Any] = _bootstrap._module_locks  # type: ignore[attr-defined]


def _importers() -> dict[str, int | None]:
    """Return the modules being imported and the threads that import them; None where an import is about to begin."""
    _imp.acquire_lock()
    try:
        return {name: lock.owner for name, ref in _locks.items() if (lock := ref()) is not None}
    finally:
        _imp.release_lock()


def _wait() -> None:
    """Wait for imports of other threads, unless this thread imports too: they may be waiting for it."""
    me, until = threading.get_ident(), time.monotonic() + PATIENCE
    while (under_way := _importers()) and me not in under_way.values() and time.monotonic() < until:
        time.sleep(0.001)


def _let_go() -> None:
    """In the child, forget imports of threads that it does not have."""
    for name, owner in _importers().items():
        if owner != threading.get_ident():
            # Begun between the end of the wait and the fork; a module half initialised must be imported anew.
            _locks.pop(name, None)
            if getattr(getattr(sys.modules.get(name), "__spec__", None), "_initializing", False):
                del sys.modules[name]


def guard() -> None:
    """Make all forks of this process wait for imports; one call is enough."""
    if hasattr(os, "register_at_fork"):
        os.register_at_fork(before=_wait, after_in_child=_let_go)


def parts(package: str, exports: str | None = None) -> tuple[Callable[[str], object], Callable[[], list[str]]]:
    """Return ``__getattr__`` and ``__dir__`` of a package: its modules, and the names that `exports` lists."""

    def attribute(name: str) -> object:
        if not name.startswith("_"):
            try:
                return import_module(f"{package}.{name}")
            except ModuleNotFoundError as error:
                if error.name != f"{package}.{name}":  # the module exists, and one of its own imports is missing
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
