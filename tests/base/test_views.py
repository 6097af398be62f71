"""What is offered of things by files that stand above them."""

from __future__ import annotations

import pytest

import lommel as lm
from lommel.base import views


def test_what_is_offered_for_a_class_is_found_for_those_that_inherit_from_it(monkeypatch):
    monkeypatch.setattr(views, "_PLACES", {})
    views.offer({"int.bits": "math:sqrt", "bool.bits": "math:floor"})
    assert views.view(int, "bits")(9) == 3.0
    assert views.view(bool, "bits")(True) == 1
    with pytest.raises(TypeError, match="there is no ends of a int"):
        views.view(int, "ends")
    with pytest.raises(TypeError, match="there is no bits of a str"):
        views.view(str, "bits")


def test_all_that_the_package_offers_is_there():
    for place in views._PLACES:
        name, _, view = place.partition(".")
        kind = getattr(lm, name, None) or next(
            base for each in (lm.Pupil, lm.Wavefront) for base in each.__mro__ if base.__name__ == name
        )
        assert callable(views.view(kind, view))
        assert callable(getattr(kind, view))
