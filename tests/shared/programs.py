"""The CMake and the Ninja that compile the core, of .venv or from PATH: scikit-build-core's choice."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from scikit_build_core.program_search import best_program, get_cmake_programs, get_ninja_programs


def cmake() -> Path:
    """Return the path of a CMake that works."""
    return _first("CMake", get_cmake_programs(module=True))


def ninja() -> Path:
    """Return the path of a Ninja that works."""
    return _first("Ninja", get_ninja_programs(module=True))


def _first(name: str, programs: Iterable[Any]) -> Path:
    found = best_program(programs, version=None)
    if found is None:
        raise FileNotFoundError(f"no {name} in .venv or on PATH")
    return found.path
