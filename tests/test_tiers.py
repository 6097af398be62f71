"""The two tiers of tests: which tests `make test` leaves out, and how the list of them is written."""

from __future__ import annotations

from typing import NamedTuple

import pytest

import tiers


class Item(NamedTuple):
    """What the choice of tests asks of one."""

    nodeid: str
    marker: str = ""

    def get_closest_marker(self, name: str) -> bool:
        return name == self.marker


@pytest.fixture
def listed(monkeypatch):
    """A list of three lines, and a commit."""
    rows = {"tests/a.py::test_one": 0.3, "tests/a.py::test_two[x-1]": 2.0, "tests/b.py::test_three": 0.5}
    monkeypatch.setattr(tiers, "slow_tests", lambda: rows)
    monkeypatch.setattr(tiers, "commit", lambda: "0123456789ab")


def test_every_line_of_the_list_names_a_test_that_is_there():
    assert len(tiers.slow_tests()) > 100
    assert [name for name in tiers.slow_tests() if not tiers.is_there(name)] == []
    assert not tiers.is_there("tests/test_tiers.py::test_that_is_not_there")
    assert not tiers.is_there("tests/no_file.py::test_every_line_of_the_list_names_a_test_that_is_there")


def test_the_list_is_as_it_would_be_written():
    rows = tiers.slow_tests()
    assert tiers.LIST.read_text(encoding="utf-8") == tiers.HEADER + "".join(tiers.lines({}, rows))
    assert min(rows.values()) >= tiers.SLOW


def test_listed_tests_are_left_out_and_a_function_stands_for_its_cases(listed):
    names = [
        "a.py::test_one",
        "a.py::test_one[1]",
        "a.py::test_two[x-1]",
        "a.py::test_two[x-2]",
        "a.py::test_on",
        "live/a.py::t",
    ]
    assert [name for name in names if tiers.is_quick(Item(f"tests/{name}"), 0.0)] == [
        "a.py::test_two[x-2]",
        "a.py::test_on",
    ]


def test_a_measured_test_replaces_its_line_and_tests_that_are_gone_lose_theirs():
    here = "tests/test_tiers.py::test_a_measured_test_replaces_its_line_and_tests_that_are_gone_lose_theirs"
    before = {
        "tests/test_tiers.py::test_gone": 1.0,
        here: 2.0,
        "tests/test_tiers.py::listed": 0.3,
        "tests/x.py::test_y": 1.0,
    }
    assert tiers.lines({}, before) == [f"  2.0 {here}\n", "  0.3 tests/test_tiers.py::listed\n"][::-1]
    assert tiers.lines({here: 0.1}, before) == ["  0.3 tests/test_tiers.py::listed\n"]
    assert tiers.lines({here: 0.26}, {}) == [f"  0.3 {here}\n"]
