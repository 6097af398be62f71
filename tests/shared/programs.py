"""The CMake and the Ninja that compile the core, of .venv or from PATH: scikit-build-core's choice.

And how often a program allocates memory.
"""

from __future__ import annotations

import os
import shlex
import subprocess
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from scikit_build_core.program_search import best_program, get_cmake_programs, get_ninja_programs

# Notes every allocation of a program, and says at its end how many there were.
_COUNTER = """
#include <stddef.h>
#include <stdio.h>
extern void *__libc_malloc(size_t);
extern void *__libc_calloc(size_t, size_t);
extern void *__libc_memalign(size_t, size_t);
static long count;
static void *noted(void *made) { __atomic_add_fetch(&count, 1, __ATOMIC_RELAXED); return made; }
void *malloc(size_t size) { return noted(__libc_malloc(size)); }
void *calloc(size_t many, size_t size) { return noted(__libc_calloc(many, size)); }
void *aligned_alloc(size_t to, size_t size) { return noted(__libc_memalign(to, size)); }
__attribute__((destructor)) static void tell(void) { fprintf(stderr, "%ld", count); }
"""


def cmake() -> Path:
    """Return the path of a CMake that works."""
    return _first("CMake", get_cmake_programs(module=True))


def ninja() -> Path:
    """Return the path of a Ninja that works."""
    return _first("Ninja", get_ninja_programs(module=True))


def allocation_counter(folder: Path) -> dict[str, str]:
    """Return the environment in which a program writes at its end, to stderr, how often it has allocated memory."""
    source, library = folder / "count.c", folder / "count.so"
    source.write_text(_COUNTER)
    compiler = shlex.split(os.environ.get("CC", "cc"))
    subprocess.run([*compiler, "-shared", "-fPIC", str(source), "-o", str(library)], check=True)
    return {"LD_PRELOAD": str(library)}


def _first(name: str, programs: Iterable[Any]) -> Path:
    found = best_program(programs, version=None)
    if found is None:
        raise FileNotFoundError(f"no {name} in .venv or on PATH")
    return found.path
