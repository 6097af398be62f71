"""Point spread functions with a proven error bound, for cameras, microscopes and telescopes."""

from __future__ import annotations

import os
import re
from functools import cache
from importlib import import_module

from lommel.base import display, imports

imports.guard()


@cache
def _homes() -> dict[str, str]:
    """Return where each name lives, as the stub has it."""
    # pathlib takes longer to import than this takes to read.
    with open(f"{os.path.splitext(__file__)[0]}.pyi", encoding="utf-8") as stub:  # noqa: PTH122, PTH123
        found = re.findall(r"^from (\S+) import (\([^)]*\)|.*)$", stub.read(), re.MULTILINE)
    return {name: home for home, names in found for name in re.findall(r"(\w+) as \1", names)}


def __getattr__(name: str) -> object:
    if name == "__version__":
        from lommel.base.optional import version

        return version()
    homes = _homes()
    if name == "__all__":
        return sorted(public for public, home in homes.items() if home != "lommel")
    if name not in homes:
        raise AttributeError(f"module 'lommel' has no attribute {name!r}")
    if homes[name] == "lommel":
        return import_module(f"lommel.{name}")
    value = globals()[name] = getattr(import_module(homes[name]), name)
    return value


def __dir__() -> list[str]:
    return sorted({*_homes(), "__all__", "__version__", *(name for name in globals() if name.startswith("__"))})


def _register_displays(what: str) -> None:
    """Import the modules that draw, tabulate or write PSFs, pupils, lenses and wavefronts."""
    if what == "file":
        from lommel.io import psf_files, zernike_tables  # noqa: F401
    else:
        from lommel.show import curves, notebook, plot, pupils  # noqa: F401


display.load = _register_displays

# Imported at once, because the function must win over the module of the same name.
from lommel.psf import psf as psf  # noqa: E402
