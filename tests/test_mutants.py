"""The list of deliberate faults is true: each pattern is in its file, once (the faults themselves: make mutants)."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).with_name("mutants") / "run.py"


@pytest.fixture(scope="module")
def mutants():
    spec = importlib.util.spec_from_file_location("mutants_run", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def test_there_are_a_hundred_faults_and_each_fits_its_file_once(mutants):
    faults = mutants.load()
    assert len(faults) >= 100
    assert len({fault.name for fault in faults}) == len(faults)
    assert mutants.misfits(faults) == []


def test_a_pattern_that_does_not_fit_is_told(mutants):
    there = mutants.load()[0]
    gone = mutants.Fault(1, "x:1", there.file, "no such text", "y", ("tests/no_such_test.py",), "")
    assert len(mutants.misfits([gone])) == 2


def test_a_pattern_that_is_no_expression_is_told(mutants):
    file, old = "cpp/include/lommel/stratified/windows.hpp", "+ sine * 2.0 * x * y"
    assert "no expression" in mutants.misfits([mutants.Fault(1, "x:1", file, old, "0.0", (), "")])[0]


def test_every_fault_of_one_place_has_its_own_switch(mutants):
    faults = [mutants.Fault(k, f"x:{k}", "cpp/x", old, new, (), "") for k, old, new in
              [(1, "a + b", "a"), (2, "a + b", "b"), (3, "return c;", "return d;")]]  # fmt: skip
    assert mutants.switched("x = a + b; return c;", faults) == (
        "x = (lommel_mutant(2) ? (b) : ((lommel_mutant(1) ? (a) : (a + b)))); "
        "if (lommel_mutant(3)) { return d; } else { return c; }"
    )
