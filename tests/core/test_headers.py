"""The headers of the core: each compiles with nothing before it, and all of them together in any order."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
from pathlib import Path

import pytest

INCLUDE = Path(__file__).resolve().parents[2] / "cpp" / "include"
HEADERS = sorted(path.relative_to(INCLUDE).as_posix() for path in INCLUDE.rglob("*.hpp"))
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


def test_every_header_compiles_alone(prepared):
    said = {header: complaint("c++", "-fsyntax-only", "-include", prepared, INCLUDE / header) for header in HEADERS}
    assert {header: text for header, text in said.items() if text} == {}
    # And what a header lacks is found.
    missing = '#include "lommel/base/tasks.hpp"\nauto gone() { return lommel::DiskStack(); }\n'
    assert "DiskStack" in complaint("c++", "-fsyntax-only", "-include", prepared, "-", source=missing)


@pytest.mark.parametrize("backwards", [False, True], ids=["forwards", "backwards"])
def test_all_headers_compile_together(backwards, prepared):
    source = "".join(f'#include "{header}"\n' for header in sorted(HEADERS, reverse=backwards))
    assert complaint("c++", "-fsyntax-only", "-include", prepared, "-", source=source) == ""
