"""The list of deliberate faults is true: each pattern is in its file, once (the faults themselves: make mutants).

And those that chance draws are faults: of code, that compiles, the same ones for the same seed.
"""

from __future__ import annotations

import ast
import importlib.util
import io
import itertools
import re
import shutil
import subprocess
import sys
import tokenize
from pathlib import Path

import pytest

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


def test_a_pattern_that_does_not_fit_is_told(mutants):
    there = mutants.load()[0]
    gone = mutants.Fault(1, "x:1", there.file, "no such text", "y", ("tests/no_such_test.py",), "")
    assert len(mutants.misfits([gone])) == 2


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("+ sine * 2.0 * x * y", "0.0"),
        (" + sine * 2.0 * x * y", "0.0"),
        ("sine * 2.0 * x * y", ""),
        ("f(x,", "f(y,"),
        ("const bool b = x;", "const bool b = y;"),
    ],
)
def test_a_pattern_that_is_no_expression_is_told(mutants, old, new):
    found = mutants.misfits([mutants.Fault(1, "x:1", "cpp/include/lommel/stratified/windows.hpp", old, new, (), "")])
    assert "no expression" in found[-1]


def test_every_fault_of_one_place_has_its_own_switch(mutants):
    faults = [mutants.Fault(k, f"x:{k}", "cpp/x", old, new, (), "") for k, old, new in
              [(1, "a + b", "a"), (2, "a + b", "b"), (3, "return c;", "return d;")]]  # fmt: skip
    assert mutants.switched("x = a + b; return c;", faults) == (
        "x = (lommel_mutant(2) ? (b) : ((lommel_mutant(1) ? (a) : (a + b)))); "
        "if (lommel_mutant(3)) { return d; } else { return c; }"
    )


# What no fault may touch says 777.
PYTHON = '''"""A docstring with 777."""
from __future__ import annotations
from typing import TYPE_CHECKING, Literal
if TYPE_CHECKING:
    N = 777
__all__ = ["x777"]
def f(a: Literal[777], b: int | 777 = 3) -> list[777]:
    """Another with 777."""
    # A comment with 777 < 778.
    if not a or b <= 0x10:
        raise ValueError(f"777 and {a + 777}")
    check(a)
    total = -min(a, 2.5) ** 2  # 777
    return "ö777" + "", [total for each in a if each is not None and total in each]
class C:
    def __repr__(self):
        return self.x + 777
'''
CPP = """// 777 + 777
#include <algorithm>
#define N (777 + 777)
constexpr int fixed = 777;
/* 777 < 777 */
inline double f(const double* x, int n = 3) {
    static_assert(777 > 776);
    if (n <= 1 && !(x[0] == 0.5)) {
        throw "777 * 777";
    }
    double sum = 0.0, most = std::max(x[0], 2e-3f + x[1]);
    for (int i = 0; i < n; ++i) {
        sum -= x[i] * (most - 1.5);
    }
    auto twice = [&](double y) { return y + y; };
    return n % 2 != 0 ? sum / 2.0 : twice(sum);
}
"""


BRANCH = "n <= 1 && !(x[0] == 0.5)"
BRANCH_CHANGES = [("<=", "<"), ("<=", ">"), ("1", "2"), ("1", "0"), ("&&", "||"), ("!", "")]


def altered(text, changes):
    return {(text[start:end], new) for start, end, new in changes}


def test_faults_of_python_are_of_operators_constants_conditions_and_checks(mutants):
    changes = mutants.draw.in_python(PYTHON)
    assert altered(PYTHON, changes) == {
        ("3", "4"), ("3", "2"), ("not a", "(a)"), ("or", "and"), ("<=", "<"), ("<=", ">"), ("0x10", "17"),
        ("0x10", "15"), ("not a or b <= 0x10", "(not (not a or b <= 0x10))"), ("check(a)", "pass"),
        ('raise ValueError(f"777 and {a + 777}")', "pass"), ("-min(a, 2.5) ** 2", "(min(a, 2.5) ** 2)"),
        ("min", "max"), ("2.5", "5.0"), ("2.5", "1.25"), ("**", "*"), ("2", "3"), ("2", "1"), ("is not", "is"),
        ("and", "or"), ("in", "not in"),
    }  # fmt: skip
    assert all(mutants.draw.differs(PYTHON, change) for change in changes)


def test_faults_of_cpp_are_of_expressions_that_a_switch_can_stand_for(mutants):
    changes = mutants.draw.in_cpp(CPP)
    assert altered(CPP, changes) == {
        *((BRANCH, BRANCH.replace(*change)) for change in BRANCH_CHANGES),
        ("3", "4"), ("3", "2"), ("0", "1"), ("1", "2"), ("1", "0"), ('throw "777 * 777";', ";"), ("0.0", "1.0"),
        ("x[0] == 0.5", "x[0] != 0.5"), ("x[0] == 0.5", "x[0] == 1.0"), ("x[0] == 0.5", "x[0] == 0.25"),
        ("std::max(x[0], 2e-3f + x[1])", "std::min(x[0], 2e-3f + x[1])"), ("2e-3f + x[1]", "2e-3f - x[1]"),
        ("2e-3f + x[1]", "0.004f + x[1]"), ("2e-3f + x[1]", "0.001f + x[1]"), ("i < n", "i <= n"),
        ("i < n", "i >= n"), ("sum -= x[i] * (most - 1.5);", "sum += x[i] * (most - 1.5);"),
        ("x[i] * (most - 1.5)", "x[i] / (most - 1.5)"), ("most - 1.5", "most + 1.5"), ("most - 1.5", "most - 3.0"),
        ("most - 1.5", "most - 0.75"), ("y + y", "y - y"),
        ("n % 2 != 0", "n * 2 != 0"), ("n % 2 != 0", "n % 3 != 0"), ("n % 2 != 0", "n % 1 != 0"),
        ("n % 2 != 0", "n % 2 == 0"), ("n % 2 != 0", "n % 2 != 1"), ("sum / 2.0", "sum * 2.0"),
        ("sum / 2.0", "sum / 4.0"), ("sum / 2.0", "sum / 1.0"),
    }  # fmt: skip


@pytest.mark.skipif(shutil.which("c++") is None, reason="no compiler named c++")
def test_all_faults_of_one_cpp_file_compile_together_where_none_overlaps_another(mutants, tmp_path):
    # Inner ones last, of which the outer ones are left out.
    chosen, spans = [], []
    for number, (start, end, new) in enumerate(sorted(mutants.draw.in_cpp(CPP), key=lambda c: c[1] - c[0]), 1):
        if all((start, end) == span or end <= span[0] or span[1] <= start for span in spans):
            spans.append((start, end))
            chosen.append(mutants.Fault(number, "x", "cpp/x.hpp", CPP[start:end], new, (), "", start))
    assert len(chosen) > 20
    (tmp_path / "x.cpp").write_text(mutants.SWITCH.replace("#pragma once\n", "") + mutants.switched(CPP, chosen))
    done = subprocess.run(["c++", "-fsyntax-only", tmp_path / "x.cpp"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_no_fault_touches_a_comment_or_a_text(mutants):
    def comments(text):
        starts = [0, *itertools.accumulate(map(len, text.splitlines(keepends=True)))]
        for token in tokenize.generate_tokens(io.StringIO(text).readline):
            if token.type in {tokenize.COMMENT, tokenize.STRING}:
                yield starts[token.start[0] - 1] + token.start[1], starts[token.end[0] - 1] + token.end[1]

    for path in sorted((ROOT / "src" / "lommel" / "optics").glob("s*.py")):
        text = path.read_text(encoding="utf-8")
        spared = list(comments(text))
        for start, end, new in mutants.draw.in_python(text):
            ast.parse(text[:start] + new + text[end:])
            assert not any(first < start < last for first, last in spared), (path, text[start:end], new)
    for path in sorted((ROOT / "cpp" / "include").rglob("*.hpp")):
        text = path.read_text(encoding="utf-8")
        for start, end, new in mutants.draw.in_cpp(text):
            line = text.rfind("\n", 0, start) + 1
            assert "//" not in text[line:start], (path, text[start:end], new)
            # The code changes, beside its comments.
            codes = [[word for _, _, word in mutants.draw.cpp_tokens(code)] for code in (text[start:end], new)]
            assert codes[0] != codes[1], (path, text[start:end], new)


def test_a_seed_draws_the_same_faults_each_on_its_own_line(mutants):
    texts = {"a.py": PYTHON, "b.hpp": CPP}
    drawn = {seed: list(mutants.draw.draw(texts, seed)) for seed in (1, 2)}
    assert drawn[1] == list(mutants.draw.draw(dict(reversed(texts.items())), 1))
    assert drawn[1] != drawn[2]
    for faults in drawn.values():
        lines = [(file, texts[file].count("\n", 0, start)) for file, (start, _, _) in faults]
        assert (
            len(set(lines))
            == len(lines)
            == len({*lines} | {(f, texts[f].count("\n", 0, s)) for f, (s, _, _) in drawn[1]})
        )


def test_every_file_has_tests_of_its_subject_and_its_own_come_first(mutants):
    own = "tests/optics/test_grid.py"
    assert mutants.subject("src/lommel/optics/grid.py", {})[0] == own
    listed = {"src/lommel/optics/grid.py": ["tests/x.py"]}
    assert mutants.subject("src/lommel/optics/grid.py", listed)[:2] == ("tests/x.py", own)
    # Of what a package hands on.
    assert "tests/imaging/test_beyond_windows.py" in mutants.subject("src/lommel/imaging/occlusion.py", {})
    # Which no test names: that of what imports it.
    assert mutants.subject("src/lommel/optics/lens.py", {})
    header = "cpp/include/lommel/base/wide.hpp"
    assert mutants.subject(header, {"cpp/include/lommel/zernike/pupil_growth.hpp": ["tests/y.py"]}) == ("tests/y.py",)
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


def test_a_survivor_is_shown_with_its_line(mutants):
    file = "cpp/include/lommel/base/simd.hpp"
    text = (ROOT / file).read_text(encoding="utf-8")
    match = re.search(r"widest_step = (32)", text)
    shown = mutants.shown(mutants.Fault(1, "x", file, "32", "33", (), "", match.start(1)))
    line = text.count("\n", 0, match.start()) + 1
    assert shown.startswith(f"{file}:{line}: NOT ARGUED\n  - constexpr std::size_t widest_step = 32;")
    assert "\n  + constexpr std::size_t widest_step = 33;" in shown


def test_faults_of_cpp_are_of_headers_that_are_compiled(mutants):
    bound = mutants._bound()
    assert "cpp/include/lommel/radial/field.hpp" in bound
    # What the page alone has.
    assert "cpp/include/lommel/imaging/convolution.hpp" not in bound
    assert all((ROOT / header).exists() for header in bound)


def test_what_is_listed_for_its_argument_has_one_and_need_be_no_expression(mutants):
    file = "cpp/include/lommel/base/simd.hpp"
    entry = mutants.Fault(1, "x:1", file, "constexpr std::size_t widest_step = 32", "+ 1", (), "because", drawn=True)
    assert mutants.misfits([entry]) == []
    assert "has none" in mutants.misfits([mutants.replace(entry, argued="")])[0]
