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


def logged(monkeypatch, capsys, *calls, total=None):
    """Return the lines of a log, of calls at given seconds."""
    seconds = [0.0]
    monkeypatch.setattr(bars.time, "monotonic", lambda: seconds[0])
    with bars.progress("first", total) as started:
        for at, *call in calls:
            seconds[0] = at
            started(*call)
    return capsys.readouterr().err.splitlines()


def test_a_log_gets_a_line_now_and_then_with_the_time_that_is_left(monkeypatch, capsys):
    calls = [(float(at), f"trial {at // 30}", at / 600.0) for at in range(300)]
    lines = logged(monkeypatch, capsys, *calls)
    assert lines[0] == "30 s, 5 %, about 10 min left: trial 1"
    assert 4 < len(lines) < 9
    counted = logged(monkeypatch, capsys, (1.0, "one"), (40.0, "two"), (75.0, "three"), total=4)
    assert counted == ["40 s, 25 %, about 2 min left: two", "75 s, 50 %, about 75 s left: three"]


def test_a_short_command_leaves_nothing_in_a_log(monkeypatch, capsys):
    assert logged(monkeypatch, capsys, (1.0, "one"), (29.0, "two", 0.9)) == []
