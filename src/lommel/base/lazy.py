"""Lazy import of the modules of a package (PEP 562)."""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib import import_module


def parts(package: str, exports: str | None = None) -> tuple[Callable[[str], object], Callable[[], list[str]]]:
    """Return ``__getattr__`` and ``__dir__`` of a package: its modules, and the names that one `exports`."""

    def attribute(name: str) -> object:
        if not name.startswith("_"):
            try:
                return import_module(f"{package}.{name}")
            except ModuleNotFoundError as error:
                if error.name != f"{package}.{name}":  # a part that is there, and lacks another
                    raise
        if exports is not None:
            source = import_module(f"{package}.{exports}")
            if name in ("__all__", *getattr(source, "__all__", ())):  # none while it imports
                return getattr(source, name)
        raise AttributeError(f"module {package!r} has no attribute {name!r}")

    def names() -> list[str]:
        from pkgutil import iter_modules

        module = sys.modules[package]
        exported = () if exports is None else import_module(f"{package}.{exports}").__all__
        return sorted({*vars(module), *exported, *(file.name for file in iter_modules(module.__path__))})

    return attribute, names
