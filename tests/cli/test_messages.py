"""Errors and notes of a command: one line each, and the exit code."""

from __future__ import annotations

import pytest

from lommel.cli import messages

SHORT = "memory, or the number of threads, is short: "


@pytest.mark.parametrize(
    ("error", "told", "code"),
    [
        (OSError(28, "No space left on device"), "No space left on device", 2),
        (OSError("it is too large"), "it is too large", 2),
        (ValueError(), "ValueError\n", 2),
        (RuntimeError("can't start new thread"), f"{SHORT}can't start new thread\n", 2),
        (ImportError("it failed to map segment from it"), f"{SHORT}it failed to map", 2),
        (KeyError("tol"), "this is a bug in lommel", 1),
    ],
)
def test_an_error_is_one_line_and_its_code_says_whose_it_is(error, told, code, capsys):
    assert messages.report_error(error, ["a note"]) == code
    lines = capsys.readouterr().err
    assert lines.startswith(f"Note: a note\nError: {told}")
    assert lines.count("\n") == 2


@pytest.mark.parametrize("headed", [True, False])
def test_a_cause_is_printed_once_in_the_first_line_or_with_the_findings(headed):
    finding = {"code": "exchanged", "severity": "error", "text": "the photographs seem exchanged"}
    facts = {
        "message": f"exchanged: {finding['text']}; 2 planes", "reliable": False, "converged": False,
        "findings": [finding], "notes": [],
    }  # fmt: skip
    lines = [part.text for part in messages.report_findings(facts, headed=headed).parts]
    assert lines == ([] if headed else ["exchanged: the photographs seem exchanged"])
