"""Point spread functions with a proven error bound, for cameras, microscopes and telescopes."""

from __future__ import annotations

import os
import re
from functools import cache
from importlib import import_module

from lommel.base import display, imports

imports.guard()


@cache
def _modules() -> dict[str, str]:
    """Return the module of each public name, read from the type stub `__init__.pyi`."""
    # Without pathlib, whose import takes longer than reading the file.
    with open(f"{os.path.splitext(__file__)[0]}.pyi", encoding="utf-8") as stub:  # noqa: PTH122, PTH123
        statements = re.findall(r"^from (\S+) import (\([^)]*\)|.*)$", stub.read(), re.MULTILINE)
    return {name: module for module, names in statements for name in re.findall(r"(\w+) as \1", names)}


def __getattr__(name: str) -> object:
    if name == "__version__":
        from lommel.base.optional import version

        return version()
    modules = _modules()
    if name == "__all__":
        return sorted(public for public, module in modules.items() if module != "lommel")
    if name not in modules:
        raise AttributeError(f"module 'lommel' has no attribute {name!r}")
    if modules[name] == "lommel":
        return import_module(f"lommel.{name}")
    try:
        module = import_module(modules[name])
    except ModuleNotFoundError as error:
        if error.name != "pydantic":
            raise
        from lommel.base.optional import how_to_get

        raise ImportError(f"lommel.{name} needs {how_to_get('pydantic', 'cli')}") from None
    value = globals()[name] = getattr(module, name)
    return value


def __dir__() -> list[str]:
    return sorted({*_modules(), "__all__", "__version__", *(name for name in globals() if name.startswith("__"))})


def _register_displays(kind: str) -> None:
    """Import the modules that write files if `kind` is "file", average "beads", or draw plots and tables."""
    if kind == "file":
        from lommel.io import psf_files, zernike_tables  # noqa: F401
    elif kind == "beads":
        from lommel.microscopy import bead_average  # noqa: F401
    else:
        from lommel.show import curves, notebook, plot, pupils  # noqa: F401


display.load = _register_displays

# Imported here and not on first use, so that `lommel.psf` is the function and not the module of the same name.
from lommel.psf import psf as psf  # noqa: E402
