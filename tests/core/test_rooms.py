"""Which way the headers of the compiled core depend on each other, as tests/test_import.py has it of the modules."""

from __future__ import annotations

import re
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

HEADERS = Path(__file__).parents[2] / "cpp" / "include"
FILES = sorted(path.relative_to(HEADERS).as_posix() for path in HEADERS.rglob("*.hpp"))

# Each room includes only from those before it, and from itself; rooms of one line know nothing of each other.
ORDER = [
    {"question.hpp"},
    {"base"},
    {"bounds"},
    {"special"},
    {"pixels"},
    {"radial"},
    {"zernike"},
    {"chordal"},
    {"paper", "imaging"},
]
RANK = {room: rank for rank, rooms in enumerate(ORDER) for room in rooms}


def room(header: str) -> str:
    return header.split("/")[1]


def included(text: str) -> list[str]:
    """The headers of the core that a text includes."""
    return re.findall(r'^\s*#\s*include\s*["<](lommel/[^">]+)[">]', text, flags=re.MULTILINE)


def upward(header: str, text: str) -> list[str]:
    """What a header includes from rooms that do not stand before its own."""
    return [
        other for other in included(text) if room(other) != room(header) and RANK[room(other)] >= RANK[room(header)]
    ]


TEXTS = {name: (HEADERS / name).read_text(encoding="utf-8") for name in FILES}


def test_every_header_has_a_place_in_the_order():
    assert {room(name) for name in FILES} == set(RANK)


@pytest.mark.parametrize("name", FILES)
def test_headers_include_one_way(name):
    assert upward(name, TEXTS[name]) == []
    assert set(included(TEXTS[name])) <= set(FILES)


def test_no_header_needs_itself_by_way_of_others():
    assert set(TopologicalSorter({name: included(text) for name, text in TEXTS.items()}).static_order()) == set(FILES)


@pytest.mark.parametrize(
    "line", ['#include "lommel/radial/field.hpp"', " # include <lommel/zernike/disk.hpp>  // why"]
)
def test_an_include_that_runs_upward_is_found_however_it_is_written(line):
    assert upward("lommel/bounds/chords.hpp", f"#pragma once\n{line}\n")
    assert not upward("lommel/chordal/images.hpp", f"#pragma once\n{line}\n")


@pytest.mark.parametrize("name", FILES)
def test_no_header_is_long_enough_to_be_two(name):
    assert TEXTS[name].count("\n") <= 400
