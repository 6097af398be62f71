"""No estimator is wrong and calls its result good, in worlds that are not its model: one run of each.

`python -m tests.world --seeds 25` runs them more often, and prints a table.
"""

from __future__ import annotations

import json
from types import SimpleNamespace

import numpy as np
import pytest

from lommel.fit import Finding, Findings
from tests.world import __main__ as table
from tests.world.scenarios import SCENARIOS
from tests.world.verdicts import Run, Scenario, Trial, attempt, judge, verdict


@pytest.mark.parametrize("scenario", [pytest.param(one, id=one.row) for one in SCENARIOS])
def test_a_result_is_right_or_told(scenario):
    run = attempt(scenario, 0)
    assert judge(scenario, [run]).faults == [], run.text


@pytest.mark.parametrize("row", ["24n", "49c", "51e", "52c"])
def test_a_verdict_has_at_most_twelve_lines(row):
    printed = repr(next(one for one in SCENARIOS if one.row == row).run(0).result)
    assert sum(1 + len(one) // 100 for one in printed.splitlines()) <= 12
    assert printed.startswith("<")


def answer(*findings, z=0.0, **more):
    return Trial(SimpleNamespace(findings=Findings(findings), message=""), np.array([z]), **more)


MISFIT, NOTE = Finding("misfit", "error", "bad"), Finding("flat_top", "note", "flat")
CASES = [
    ("R", answer(z=1.0), []),
    ("R", answer(NOTE, z=1.0), []),
    ("R", answer(MISFIT), ["good: 0 of 1"]),
    ("R", answer(z=4.5), ["wrong and called good: 1 of 1"]),
    ("R", answer(z=np.nan), ["wrong and called good: 1 of 1"]),
    ("R", answer(wrong=True), ["wrong and called good: 1 of 1"]),
    ("R", answer(extras={"light": (1.2, 0.01)}), ["light 1.2 +- 0.01, not 0.9 to 1.1"]),
    ("R", answer(extras={"light": (1.2, 0.1)}), []),
    ("R", answer(seconds=3.0), ["more than 2 s"]),
    ("T", answer(MISFIT, z=9.0), []),
    ("T", answer(z=1.0), ["told by misfit: 0 of 1"]),
    ("T", answer(Finding("no_light", "error", "dark"), z=9.0), ["told by misfit: 0 of 1"]),
    ("RT", answer(z=1.0), []),
    ("RT", answer(MISFIT, z=9.0), []),
    ("RT", answer(z=9.0), ["wrong and called good: 1 of 1"]),
    ("N", answer(z=9.0), ["told by misfit: 0 of 1"]),
    ("N", answer(Finding("misfit", "note", "bad"), z=9.0), []),
]


@pytest.mark.parametrize(("must", "trial", "faults"), CASES)
def test_what_must_come_of_a_world_is_held_against_what_comes(must, trial, faults):
    one = Scenario("0", "a world", "fit", lambda seed: trial, must, ("misfit",), None, {"light": (0.9, 1.1)}, 2.0)
    assert judge(one, [attempt(one, 0)]).faults == faults


def test_many_runs_show_standard_errors_that_are_too_small_or_too_large():
    rows = [Scenario("0", "a world", "fit", lambda seed: answer(), must) for must in ("R", "RT")]
    for size, fault in ((1.0, False), (1.6, True), (0.5, True)):
        z = size * np.random.default_rng(1).normal(size=(25, 5))
        runs = [Run(k, True, [], "", row.tolist(), [], {}, False, 0.1) for k, row in enumerate(z)]
        assert [bool(judge(row, runs).faults) for row in rows] == [fault, fault]


def test_results_that_name_what_is_wrong_are_counted_as_wrong():
    one = Scenario(
        "0", "a world", "fit", lambda seed: answer(Finding("misfit", "note", "bad"), z=9.0), "N", ("misfit",)
    )
    assert judge(one, [attempt(one, 0)]).wrong_and_good == 1


def test_a_refusal_is_told_and_an_error_is_a_fault():
    def refuses(seed):
        raise ValueError("no")

    def breaks(seed):
        raise ZeroDivisionError

    told = Scenario("0", "a world", "fit", refuses, "T", ("refused",))
    assert judge(told, [attempt(told, 0)]).faults == []
    with pytest.raises(ZeroDivisionError):
        attempt(Scenario("0", "a world", "fit", breaks), 0)


def test_the_verdict_is_that_of_findings():
    field = SimpleNamespace(findings=Findings([Finding("sign_open", "doubt", "open")]), degree=0)
    assert verdict(field).good
    restored = SimpleNamespace(channels=(SimpleNamespace(findings=Findings([MISFIT, NOTE])),))
    assert verdict(restored)[:2] == (False, ("misfit", "flat_top"))


def test_every_row_is_there_once_and_says_what_must_come_of_it():
    rows = [one.row for one in SCENARIOS]
    assert len(set(rows)) == len(rows)
    assert {int(row[:2].rstrip("abcdef")) for row in rows} == set(range(1, 55))
    assert all(one.codes for one in SCENARIOS if one.must in ("T", "N"))


def test_runs_are_kept_and_become_a_table(tmp_path, monkeypatch):
    run = Run(3, True, ["flat_top"], "flat", [0.5, -1.0], [], {"light": (1.0, 0.1)}, False, 0.5)
    kept = tmp_path / "runs.json"
    kept.write_text(json.dumps({"11": [run]}), encoding="utf-8")
    stored = table.read(kept)
    assert stored["11"][0].z == [0.5, -1.0]
    ((row, one),) = table.judged(stored)
    assert "Gaussian" in table.line(row, one)
    page = tmp_path / "trust.md"
    page.write_text(f"before\n{table.BEGIN}\nwhat was here\n{table.END}\nafter\n", encoding="utf-8")
    monkeypatch.setattr(table, "PAGE", page)
    table.write_page(stored)
    text = page.read_text(encoding="utf-8")
    assert text.startswith("before\n")
    assert text.endswith("after\n")
    assert "1 results of 1 worlds: 1 called good, 0 of them wrong (0 %).\n0 of these" in text
    assert "no world twice" in text
    assert "what was here" not in text


def test_named_rows_are_counted_and_worlds_that_are_wrong_twice_are_listed():
    wrong, right = (Run(k, True, ["untested"], "", [9.0 * (k < 2)], [], {}, k < 2, 0.5) for k in (1, 3))
    text = table.page({"11": [right, right], "37g": [wrong, right], "32": [wrong, wrong]})
    assert "6 results of 3 worlds: 6 called good, 3 of them wrong (50 %).\n1 of these" in text
    assert f"\nOf 4 in the other rows 2 are wrong (50 %), twice or more in {table.BY_ROW['32'].name}." in text
