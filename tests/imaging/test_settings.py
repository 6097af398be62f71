"""The settings of photographs: the same list, texts, defaults and checks at every door, and at the command line."""

from __future__ import annotations

from dataclasses import fields

import numpy as np
import pytest

import lommel as lm
from lommel.cli.photo_commands import blur, restore
from lommel.imaging import DepthBlur, FocusPlan, depth_of_field
from lommel.imaging.photograph import TileBlur
from lommel.imaging.settings import Settings

LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
IMAGE, DEPTH = np.random.default_rng(0).random((20, 24)).astype(np.float32), np.full((20, 24), 2.1)
DEFAULTS = {field.name: field.default for field in fields(Settings)}


@pytest.mark.parametrize(("command", "needed"), [(blur, ""), (restore, "--white 1 --read 1")])
def test_the_command_line_has_the_defaults_of_python(command, needed):
    parsed = command.make_context("lommel", f"photo depth -o out.png {needed}".split()).params
    named = DEFAULTS.keys() - {"dtype", "threads"}
    assert {name: parsed[name] for name in named} == {name: DEFAULTS[name] for name in named}


def doors(**given):
    yield lambda: depth_of_field(IMAGE, DEPTH, LENS, 8e-6, encoding="linear", **given)
    yield lambda: FocusPlan(IMAGE, DEPTH, LENS, 8e-6, encoding="linear", **given)
    yield lambda: depth_of_field(IMAGE, DEPTH, LENS, 8e-6, encoding="linear", tile=16, **given)
    if not given.keys() & {"occlusion", "missing", "wavelengths"}:
        yield lambda: DepthBlur(DEPTH, LENS, 8e-6, **given)
    da = pytest.importorskip("dask.array")
    image, depth = da.from_array(IMAGE), da.from_array(DEPTH)
    yield lambda: depth_of_field(image, depth, LENS, 8e-6, encoding="linear", **given)


@pytest.mark.parametrize(
    ("given", "error", "message"),
    [
        ({"engery": 0.9}, TypeError, r"\(\) has no option 'engery'; did you mean energy\?"),
        ({"strength": 0.9}, TypeError, r"\(\) has no option 'strength'; known are .*energy, tol, largest"),
        ({"border": "wrap"}, ValueError, "border must be one of 'reflect', 'extend', 'zero', got 'wrap'"),
        ({"energy": 0.4}, ValueError, "energy must be >= 0.5"),
        ({"energy": 0.99995}, ValueError, "energy must be <= 0.9999, or 1 for the whole PSF, got 0.99995"),
        ({"tol": 1e-8}, ValueError, "tol must be >= 1e-07"),
        ({"tol": 0.15}, ValueError, "tol must be"),
        ({"tol": "fine"}, TypeError, "tol must be a real number"),
        ({"largest": 2049}, ValueError, "largest must be from 1 to 2048, got 2049"),
        ({"threads": 0}, ValueError, "threads must be from 1 to 1024, got 0"),
        ({"dtype": np.float16}, TypeError, "dtype must be float32 or float64"),
        ({"missing": "zero"}, ValueError, "missing must be one of 'raise', .*'infinity', got 'zero'"),
        ({"occlusion": 1}, TypeError, "occlusion must be True or False, got 1"),
        ({"wavelengths": 5e-7}, TypeError, "wavelengths must be a sequence with one entry per channel, got 5e-07"),
        ({"wavelengths": [5e-7, 6e-7]}, ValueError, "must have one entry for each of the 1 channels, got 2"),
    ],
)
def test_every_door_refuses_the_same_in_the_same_words(given, error, message):
    for make in doors(**given):
        with pytest.raises(error, match=message):
            make()


def test_every_door_takes_what_settings_takes():
    given = {"border": "zero", "energy": 0.9, "tol": 1e-3, "largest": 9, "dtype": np.float64, "threads": 1}
    assert sum(make() is not None for make in doors(**given)) == 5
    assert sum(make() is not None for make in doors(**given, occlusion=False, wavelengths=[5e-7])) == 4


def test_chunks_are_computed_by_one_thread_each_unless_told_otherwise(monkeypatch):
    da, seen = pytest.importorskip("dask.array"), []

    def tile(*arguments):
        seen.append(arguments[-1].threads)
        return TileBlur(*arguments)

    monkeypatch.setattr("lommel.imaging.photograph.TileBlur", tile)
    for given in ({}, {"threads": 2}):
        depth_of_field(da.from_array(IMAGE), da.from_array(DEPTH), LENS, 8e-6, encoding="linear", **given)
    assert seen == [1, 2]


def test_every_door_makes_what_depends_on_points_farther_away():
    for given in ({"occlusion": True}, {"missing": "nearest"}):
        assert all(make() is not None for make in list(doors(**given)))


def test_near_points_hide_far_ones_unless_told_otherwise():
    depth = np.where(np.arange(24) < 12, 1.8, 3.0) * np.ones((20, 1))
    default, on, off = (
        depth_of_field(IMAGE, depth, LENS, 8e-6, encoding="linear", **given).values
        for given in ({}, {"occlusion": True}, {"occlusion": False})
    )
    assert np.array_equal(default, on)
    assert np.abs(on - off).max() > 0.1


def test_settings_hold_what_was_asked_in_one_form():
    made = Settings(wavelengths=[5e-7, [(5e-7, 1.0), (6e-7, 3.0)]], dtype="float64", largest=np.int64(5))
    assert made.wavelengths == (((5e-7, 1.0),), ((5e-7, 0.25), (6e-7, 0.75)))
    assert (made.dtype, made.largest) == (np.float64, 5)
    assert made == Settings(**vars(made))
    assert hash(made) == hash(Settings(**vars(made)))
