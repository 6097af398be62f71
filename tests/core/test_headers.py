"""The headers of the core: each includes what it needs, and all of them compile together, in any order."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
from collections import Counter
from functools import cache
from pathlib import Path

import pytest

INCLUDE = Path(__file__).resolve().parents[2] / "cpp" / "include"
HEADERS = sorted(path.relative_to(INCLUDE).as_posix() for path in INCLUDE.rglob("*.hpp"))
# Words before a bracket that no header declares for others.
NO_NAMES = {"double", "final", "float", "lommel", "static_cast", "std", "template"}
COMPILER = [*shlex.split(os.environ.get("CXX", "c++")), "-std=c++17", "-O0", "-Wno-psabi", f"-I{INCLUDE}", "-x"]


def complaint(*arguments: str | Path, source: str = "") -> str:
    command = [*COMPILER, *(str(part) for part in arguments)]
    done = subprocess.run(command, input=source, capture_output=True, text=True, check=False)
    return done.stderr if done.returncode else ""


@pytest.fixture(scope="module")
def prepared(tmp_path_factory) -> Path:
    """Precompile the standard headers, which are most of the work (make sanitize does without)."""
    texts = [(INCLUDE / header).read_text(encoding="utf-8") for header in HEADERS]
    names = sorted({name for text in texts for name in re.findall(r"^#include <(\w+)>$", text, re.MULTILINE)})
    place = tmp_path_factory.mktemp("headers") / "standard.hpp"
    place.write_text("".join(f"#include <{name}>\n" for name in names))
    assert not complaint("c++-header", place, "-o", f"{place}.gch")
    return place


@cache
def included(header: str) -> set[str]:
    """Return what a header includes of the others, by way of these too."""
    return direct(header).union(*map(included, direct(header)))


def direct(header: str) -> set[str]:
    text = (INCLUDE / header).read_text(encoding="utf-8")
    return set(re.findall(r'^#include "(.*)"$', text, re.MULTILINE))


@cache
def names(header: str) -> tuple[set[str], set[str]]:
    """Return the names that the code of a header has, and those that it declares outside of all but namespaces."""
    text = re.sub(r"//.*|^#include.*", "", (INCLUDE / header).read_text(encoding="utf-8"), flags=re.MULTILINE)
    used = set(re.findall(r"[A-Za-z_]\w+", re.sub(r"(std::|\.|->)\w+", "", text)))
    macros = re.findall(r"^ *#define (\w+)", text, re.MULTILINE)
    outside, last, inside = [], "", list[bool]()
    for part in re.split(r"([{}])", re.sub(r"^ *#.*", "", text, flags=re.MULTILINE)):
        if part == "{":
            inside.append(not re.search(r"\bnamespace\s*[\w:]*\s*$", last))
        elif part == "}" and inside:
            inside.pop()
        elif not any(inside):
            outside.append(part)
        last = part
    rest, count = ";".join(outside), 1
    while count:
        rest, count = re.subn(r"\([^()]*\)|<[^<>]*>", "(", rest)
    return used, {*macros, *re.findall(r"([A-Za-z_]\w+)\s*(?=[({=;[:])", rest)} - NO_NAMES


def needs(one: str, other: str) -> bool:
    """Whether the code of a header has a name that another declares."""
    return bool(names(one)[0] & names(other)[1])


def revealing() -> list[str]:
    """Return the headers in an order, each after what it includes, in which the most lacking includes are missed.

    That a header lacks an include is hidden by what declares a name that it has, if that stands before it.
    """
    hiding = {(a, b) for a in HEADERS for b in HEADERS if b not in included(a) | {a} and needs(a, b)}
    order, left = [], set(HEADERS)
    while left:
        ready = sorted(header for header in left if not included(header) & left)
        gain = Counter(a for a, b in hiding if b in left)
        gain.subtract(b for a, b in hiding if a in left)
        order.append(max(ready, key=lambda header: gain[header]))
        left.remove(order[-1])
    return order


def test_all_headers_compile_where_little_hides_what_one_lacks(prepared):
    """In one order; `make sanitize`, which every pull request runs, compiles each alone."""
    # What makes the order finds what headers need: names of nearly all that they include.
    found = [needs(header, other) for header in HEADERS for other in direct(header)]
    assert sum(found) > 0.9 * len(found)
    source = "".join(f'#include "{header}"\n' for header in revealing())
    assert complaint("c++", "-fsyntax-only", "-include", prepared, "-", source=source) == ""
    # And what a header lacks is found.
    missing = '#include "lommel/base/tasks.hpp"\nauto gone() { return lommel::DiskStack(); }\n'
    assert "DiskStack" in complaint("c++", "-fsyntax-only", "-include", prepared, "-", source=missing)
