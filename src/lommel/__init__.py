"""Point spread functions of defocused and aberrated lenses, exact to a tolerance you name, without an FFT."""

from __future__ import annotations

import ast
from importlib import import_module
from pathlib import Path
from typing import Any

# Imported at once, because the function must win over the module of the same name.
from lommel.psf import psf as psf

# Where each name lives, as the stub has it.
_HOME = {
    name.name: node.module
    for node in ast.parse(Path(__file__).with_suffix(".pyi").read_text(encoding="utf-8")).body
    if isinstance(node, ast.ImportFrom) and node.module
    for name in node.names
}

__all__ = sorted(name for name, module in _HOME.items() if module != "lommel")  # noqa: PLE0605 (a list it is)


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from lommel.base.version import version

        return version()
    if name not in _HOME:
        raise AttributeError(f"module 'lommel' has no attribute {name!r}")
    if _HOME[name] == "lommel":
        return import_module(f"lommel.{name}")
    value = globals()[name] = getattr(import_module(_HOME[name]), name)
    return value


def __dir__() -> list[str]:
    return sorted({*_HOME, "__version__", *(name for name in globals() if name.startswith("__"))})
