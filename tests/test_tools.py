"""Tools of the tests: deliberate faults, tiers, and many cases in one test."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

import pytest

import tiers

ROOT = Path(__file__).resolve().parent.parent
SCRIPT = Path(__file__).with_name("mutants") / "run.py"


@pytest.fixture(scope="module")
def mutants():
    spec = importlib.util.spec_from_file_location("mutants_run", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    sys.path.insert(0, str(SCRIPT.parent))
    try:
        spec.loader.exec_module(module)
    finally:
        sys.path.remove(str(SCRIPT.parent))
    return module


def test_there_are_a_hundred_faults_and_each_fits_its_file_once(mutants):
    faults = mutants.load()
    assert len(faults) >= 100
    assert len({fault.name for fault in faults}) == len(faults)
    assert mutants.misfits(faults) == []


def test_every_file_has_tests_of_its_subject_and_its_own_come_first(mutants):
    own = "tests/optics/test_grid.py"
    assert mutants.subject("src/lommel/optics/grid.py", {})[0] == own
    listed = {"src/lommel/optics/grid.py": ["tests/x.py"]}
    assert mutants.subject("src/lommel/optics/grid.py", listed)[:2] == ("tests/x.py", own)
    # Of what a package hands on.
    assert "tests/imaging/test_layers.py" in mutants.subject("src/lommel/imaging/occlusion.py", {})
    header = "cpp/include/lommel/base/wide.hpp"
    assert mutants.subject(header, {"cpp/include/lommel/base/narrow.hpp": ["tests/y.py"]}) == ("tests/y.py",)
    for path in (ROOT / "src" / "lommel").rglob("*.py"):
        for test in mutants.subject(path.relative_to(ROOT).as_posix(), {}):
            assert (ROOT / test).exists()


def test_a_run_goes_on_where_it_ended_and_judges_survivors_again(mutants, tmp_path):
    faults = [mutants.Fault(k, "x", "x.py", "a", "b", (), "", k) for k in (1, 2, 3)]
    first = mutants.Found(tmp_path / "list.jsonl")
    first.keep(faults[0], "tests/test_x.py::test_a")
    first.keep(faults[1], "")
    again = mutants.Found(tmp_path / "list.jsonl")
    assert [again.noticed(fault) for fault in faults] == ["tests/test_x.py::test_a", "", ""]


@pytest.fixture
def listed(monkeypatch):
    """A list of three lines, and a commit."""
    rows = {"tests/a.py::test_one": 0.3, "tests/a.py::test_two[x-1]": 2.0, "tests/b.py::test_three": 0.5}
    monkeypatch.setattr(tiers, "slow_tests", lambda: rows)
    monkeypatch.setattr(tiers, "commit", lambda: "0123456789ab")


def test_every_line_of_the_list_names_a_test_that_is_there():
    assert len(tiers.slow_tests()) > 100
    assert [name for name in tiers.slow_tests() if not tiers.is_there(name)] == []
    assert not tiers.is_there("tests/test_tools.py::test_that_is_not_there")
    assert not tiers.is_there("tests/no_file.py::test_every_line_of_the_list_names_a_test_that_is_there")


def test_the_list_is_as_it_would_be_written():
    rows = tiers.slow_tests()
    written = tiers.HEADER.format(tiers.loop_listed()) + "".join(tiers.lines({}, rows))
    assert tiers.LIST.read_text(encoding="utf-8") == written
    assert min(rows.values()) >= tiers.SLOW
