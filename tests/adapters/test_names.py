"""Adapters are names of the package, without the packages that they are for."""

from __future__ import annotations

import pytest

from lommel import adapters


@pytest.mark.parametrize("name", ["batoid", "optiland", "rayoptics"])
def test_an_adapter_is_there_when_it_is_asked_for(name):
    assert name in dir(adapters)
    assert getattr(adapters, name).pupil.__module__ == f"lommel.adapters.{name}"
    assert adapters.optiland.pupil is not adapters.rayoptics.pupil


def test_what_is_no_adapter_is_none():
    with pytest.raises(AttributeError, match="has no attribute 'zemax'"):
        adapters.zemax  # noqa: B018
