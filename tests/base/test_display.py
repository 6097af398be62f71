"""What is registered for things by modules that stand above them."""

from __future__ import annotations

from functools import singledispatch

import pytest

import lommel as lm
from lommel.base import display


class Child(lm.Wavefront):
    pass


@pytest.mark.parametrize("thing", [lm.Pupil(), lm.Wavefront(), Child()])
def test_what_is_registered_for_a_class_is_found_for_those_that_inherit_from_it(thing):
    assert "<table" in thing._repr_html_()


@pytest.mark.parametrize("view", [display.html, display.plot, display.save])
def test_what_is_not_registered_is_refused(view):
    with pytest.raises(TypeError, match=r"there is no (table|plot|file) of a str"):
        view("a text")


def test_modules_that_register_are_imported_when_the_first_is_asked_for(monkeypatch):
    asked = []
    view = singledispatch(display.html.dispatch(object))
    monkeypatch.setattr(display, "html", view)
    monkeypatch.setattr(display, "load", lambda: asked.append(view.register(int, str)))
    assert (display.html(3), display.html(4)) == ("3", "4")
    assert len(asked) == 1
