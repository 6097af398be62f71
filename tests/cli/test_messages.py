"""Errors and notes of a command: one line each, and the exit code."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from lommel.cli import messages

GONE, SHORT = "No such file or directory", "memory, or the number of threads, is short: "
KEYS = ValueError("tol must be positive")
KEYS.names_keys = True


@pytest.mark.parametrize(
    ("error", "told", "code"),
    [
        (OSError(28, "No space left on device"), "No space left on device", 2),
        (OSError("it is too large"), "it is too large", 2),
        (FileNotFoundError(2, GONE, "my/phone.toml"), f"my/phone.toml: {GONE}; `lommel examples phone` copies", 2),
        (FileNotFoundError(2, GONE, "mine.toml"), f"mine.toml: {GONE}\n", 2),
        (PermissionError(13, "Permission denied", "phone.toml"), "phone.toml: Permission denied\n", 2),
        (ValueError("tol must be positive"), "--tol must be positive\n", 2),
        (KEYS, "tol must be positive\n", 2),
        (ValueError(), "ValueError\n", 2),
        (RuntimeError("can't start new thread"), f"{SHORT}can't start new thread\n", 2),
        (ImportError("it failed to map segment from it"), f"{SHORT}it failed to map", 2),
        (KeyError("tol"), "this is a bug in lommel, not in your input: KeyError: 'tol'; please report it", 1),
    ],
)
def test_an_error_is_one_line_and_its_code_says_whose_it_is(error, told, code, monkeypatch, capsys):
    monkeypatch.setattr(messages, "_running", [({"tol": "--tol"}, {"tol"})])
    assert messages.report_error(error, ["a note"]) == code
    lines = capsys.readouterr().err
    assert lines.startswith(f"Note: a note\nError: {told}")
    assert lines.count("\n") == 2


@pytest.mark.parametrize("asked", [{}, {"LOMMEL_TRACEBACK": "1"}])
def test_a_reader_that_goes_away_is_told_nothing_and_a_traceback_is_shown_if_asked_for(asked, monkeypatch, capsys):
    closed, errors = [], [BrokenPipeError(32, "Broken pipe"), ValueError("tol")]

    def job():
        raise errors.pop(0)

    monkeypatch.setattr(messages, "discard", closed.append)
    monkeypatch.setattr(messages.os, "environ", asked)
    monkeypatch.setattr(messages.sys, "stdout", SimpleNamespace(fileno=lambda: 9, flush=lambda: None))
    assert messages.run_job(job, {}, [], as_json=False) == 1
    assert (closed, capsys.readouterr().err) == ([9], "")
    if asked:
        with pytest.raises(ValueError, match="tol"):
            messages.run_job(job, {}, [], as_json=False)
    else:
        assert messages.run_job(job, {}, [], as_json=False) == 2
