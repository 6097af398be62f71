"""The remaining time of a command, beside a clock of our own."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from lommel.cli import output


@pytest.mark.parametrize(
    ("share", "expected", "elsewhere"),
    [(1.0, 30.0, False), (0.25, 120.0, False), (0.01, 40.0, False), (0.25, 75.0, True)],
)
def test_the_remaining_time_is_that_of_the_processor_at_the_recent_share(share, expected, elsewhere, monkeypatch):
    clock = [0.0, 0.0]
    monkeypatch.setattr(output.Steps, "_clock", staticmethod(lambda: tuple(clock)))
    steps = output.Steps(None, "reading", None, elsewhere=elsewhere)
    clock[:] = 50.0, 3.0
    steps("fitting")  # the time before does not count
    for k in range(1, 11):
        clock[:] = 50.0 + k, 3.0 + k * (1.0 if share > 0.1 else share)
        left = steps.left(0.02 * k)
    if share < 0.1:  # other processes work: the clock tells
        assert left == pytest.approx(expected)
        return
    for k in range(1, 11):  # other programs take their part
        clock[:] = 60.0 + k / share, 13.0 + k
        left = steps.left(0.4)
    assert left == pytest.approx(expected, rel=1e-6)


def test_what_an_earlier_call_did_counts_as_done_and_not_as_quick(monkeypatch):
    clock, shown = [0.0, 0.0], []
    monkeypatch.setattr(output.Steps, "_clock", staticmethod(lambda: tuple(clock)))
    bar = SimpleNamespace(add_task=lambda *_, **__: 0, update=lambda _, **now: shown.append(now))
    steps = output.Steps(bar, "reading", None)
    for seconds, fraction in ((20.0, 0.5), (30.0, 0.6), (70.0, 1.0)):
        clock[:] = seconds, seconds
        steps("frame", fraction)
    assert [(now["completed"], now["left"]) for now in shown] == [
        (0.5, "-:--:--"),
        (0.6, "0:00:40"),
        (1.0, "0:00:00"),
    ]


def test_a_time_is_in_hours_minutes_and_seconds():
    assert (output._in_time(None), output._in_time(90.4)) == ("-:--:--", "0:01:30")


def test_without_a_terminal_the_time_that_is_left_is_printed_once_of_long_steps(monkeypatch, capsys):
    clock = [0.0, 0.0]
    monkeypatch.setattr(output.Steps, "_clock", staticmethod(lambda: tuple(clock)))
    steps = output.Steps(None, "reading", None)
    steps("fitting")
    for seconds in range(30):  # one of a hundred steps in a second, after preparations
        clock[:] = 40 + seconds, 40 + seconds
        steps("chi2 2", 0.01 * seconds)
    assert capsys.readouterr().err == "chi2 2: about 0:01:28 left.\n"
