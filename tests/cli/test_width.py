"""Output of the command line: its width, and its bar."""

from __future__ import annotations

import io
import re

import pytest
from rich.console import Console

from lommel.cli import output as bars
from lommel.cli.main import COMMANDS


@pytest.mark.parametrize("name", ["", *COMMANDS])
def test_help_fits_80_columns_without_a_broken_word(name, call_lommel, tmp_path, monkeypatch):
    shown = {}
    for width in (100, 80):
        monkeypatch.setenv("COLUMNS", str(width))
        shown[width] = call_lommel(*name.split(), "--help", folder=tmp_path).stdout
    assert max(map(len, shown[80].splitlines())) <= 80
    # Words with a hyphen may go on behind it, but not the names of options.
    assert set(re.split(r"[\s-]+", shown[80])) <= set(re.split(r"[\s-]+", shown[100]))
    assert not re.search(r"--[a-z-]*-$", shown[80], re.MULTILINE)
    summaries = shown[80].partition("Commands:")[2]
    assert "..." not in summaries


def drawn(*calls, total=None):
    console = Console(file=io.StringIO(), force_terminal=True, width=120)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("rich.console.Console", lambda **_: console)
        with bars.progress("first", total) as started:
            for call in calls:
                started(*call)
    return re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", console.file.getvalue())


def test_the_bar_shows_what_is_done_its_share_and_the_time_that_is_left():
    last = drawn(("blurring", 0.25)).rstrip().splitlines()[-1]
    assert "blurring" in last
    assert "25%" in last
    assert re.search(r"left \S*:", last)


def test_a_step_counts_once_it_is_over():
    assert "50%" in drawn(("one",), ("two",), total=2)
    assert "100%" not in drawn(("one",), ("two",), total=2)
