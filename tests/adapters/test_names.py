"""Adapters are names of the package, without the packages that they are for."""

from __future__ import annotations

import sys

import pytest

from lommel import adapters
from lommel.adapters import ray_tracing


@pytest.mark.parametrize("name", ["batoid", "optiland", "rayoptics"])
def test_an_adapter_is_there_when_it_is_asked_for(name):
    assert name in dir(adapters)
    assert getattr(adapters, name).pupil.__module__ == f"lommel.adapters.{name}"
    assert adapters.optiland.pupil is not adapters.rayoptics.pupil


def test_what_is_no_adapter_is_none():
    with pytest.raises(AttributeError, match="has no attribute 'zemax'"):
        adapters.zemax  # noqa: B018


@pytest.mark.parametrize(
    ("name", "module"),
    [("batoid", "batoid"), ("optiland", "optiland.optic"), ("rayoptics", "rayoptics.optical.opticalmodel")],
)
def test_without_its_package_an_adapter_names_what_to_install(name, module, monkeypatch):
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(ImportError, match=f"pip install {name}"):
        getattr(adapters, name).pupil(None, wavelength=550e-9)


@pytest.mark.parametrize("name", ["batoid", "optiland", "rayoptics"])
def test_an_adapter_traces_at_each_wavelength_to_a_hundredth_of_a_radian(name, monkeypatch):
    adapter = getattr(adapters, name)
    traced = ("rays", 1e-6, 0.0) if name == "batoid" else ("rays", 1e-6)
    monkeypatch.setattr(adapter, "_tracer", lambda *_: traced)
    monkeypatch.setattr(ray_tracing, "single_pupil", lambda tracer, *given, **_: (tracer(1e-6), given[3]))
    monkeypatch.setattr(ray_tracing, "field_map", lambda *given, **_: (given[0], given[5]))
    assert adapter.pupil(None, wavelength=1e-6) == ("rays", 0.01)
    assert adapter.field_map(None, *[0.1] * (name == "batoid"), wavelength=1e-6) == ("rays", 0.01)
