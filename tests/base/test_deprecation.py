"""Names on their way out: who calls them is warned, at the line that does, and no debt outlives its version."""

from __future__ import annotations

import inspect
import pkgutil
from importlib import import_module
from importlib.metadata import version
from pathlib import Path

import pytest

import lommel
from lommel.base import deprecation
from lommel.base.deprecation import deprecate, reordered

WHEN = {"since": "0.2", "until": "0.4"}


def due(now: str) -> list[str]:
    """What was to go in this version or before."""
    release = [tuple(map(int, text.split(".")[:2])) for text in (now, *(until for _, until in deprecation.DEBTS))]
    return [what for (what, _), until in zip(deprecation.DEBTS, release[1:], strict=True) if until <= release[0]]


def test_nothing_is_kept_past_the_version_that_it_was_to_go_in():
    for module in pkgutil.walk_packages(lommel.__path__, "lommel."):
        if not module.name.startswith(("lommel.adapters.", "lommel.__main__")):
            import_module(module.name)
    assert due(version("lommel")) == []


@pytest.fixture
def debts(monkeypatch):
    monkeypatch.setattr(deprecation, "DEBTS", [])
    return deprecation.DEBTS


def test_a_debt_is_due_in_its_version_and_not_before(debts):
    deprecate(use="x", **WHEN)(len)
    assert due("0.3.9") == []
    assert due("0.4.0") == due("1.0") == ["builtins.len"]


def test_a_function_warns_at_the_line_of_its_caller_and_still_works(debts):
    @deprecate(use="lommel.new", **WHEN)
    def old(x):
        """Double it.

        At once.
        """
        return 2 * x

    with pytest.warns(
        DeprecationWarning, match=r"old is deprecated since lommel 0\.2 and goes in 0\.4; use lommel\.new"
    ) as seen:
        assert old(3) == 6
    assert seen[0].filename == __file__
    assert old.__doc__.startswith("Double it.\n\nAt once.\n\n.. deprecated:: 0.2\n    ")


@pytest.mark.parametrize(("args", "kwargs"), [((1, 2), {}), ((1,), {"y": 2})])
def test_an_argument_warns_however_it_is_given_and_only_then(args, kwargs, debts):
    @deprecate(argument="y", use="x alone", **WHEN)
    def f(x, y=0):
        return x + y

    with pytest.warns(DeprecationWarning, match=r"y= of .*f is deprecated"):
        assert f(*args, **kwargs) == 3
    assert f(3) == 3
    assert f(x=3) == 3


def test_an_argument_that_was_renamed_is_taken_by_its_old_name(debts):
    @deprecate(argument="old", renamed="new", use="new=", **WHEN)
    def f(new=0):
        return new

    with pytest.warns(DeprecationWarning, match="old= of"):
        assert f(old=5) == 5
    assert f(new=5) == f(5) == 5
    for call in (lambda: f(1, old=2), lambda: f(new=1, old=2)):
        with (
            pytest.warns(DeprecationWarning, match="old= of"),
            pytest.raises(TypeError, match="got new= and, under its old name, old="),
        ):
            call()
    assert list(inspect.signature(f).parameters) == ["new"]


@pytest.mark.parametrize("marks", [{"argument": "z"}, {"argument": "x", "renamed": "z"}])
def test_an_argument_that_is_not_there_cannot_be_marked(marks, debts):
    with pytest.raises(ValueError, match="has no argument z"):
        deprecate(use="x", **WHEN, **marks)(lambda x: x)


def test_the_changelog_is_about_the_version_of_the_package():
    first = next(
        line
        for line in (Path(__file__).parents[2] / "CHANGELOG.md").read_text(encoding="utf-8").splitlines()
        if line.startswith("## ")
    )
    assert first.split()[1].rstrip(",") == version("lommel")


def test_the_old_order_of_two_arguments_is_taken_and_warned_of(debts):
    @reordered(**WHEN, was=lambda first: isinstance(first, str))
    def paint(number, name, where=0):
        """Paint."""
        return number, name, where

    class Painter:
        @reordered(**WHEN, was=lambda first: isinstance(first, str))
        def __init__(self, number, name, where=0):
            self.made = number, name, where

    said = r"\(name, number, \.\.\.\) is deprecated since lommel 0\.2 .* 0\.4; the order is number, name, where"
    for call in (paint, lambda *given, **named: Painter(*given, **named).made):
        assert (
            call(1, "red", 2) == call(1, name="red", where=2) == call(number=1, name="red", where=2) == (1, "red", 2)
        )
        with pytest.warns(DeprecationWarning, match=said) as seen:
            assert call("red", 1, 2) == (1, "red", 2)
        assert seen[0].filename == __file__
        with pytest.warns(DeprecationWarning, match=said):
            assert call("red", number=1, where=2) == (1, "red", 2)
    assert due("0.3") == []
    assert len(due("0.4")) == 2
