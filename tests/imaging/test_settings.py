"""Options of photographs: the same checks in every function that takes them."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.imaging import BlurOptions, DepthBlur, RestoreOptions, depth_of_field, restore
from lommel.imaging.photograph import TileBlur
from lommel.imaging.settings import OperatorOptions, channel_spectra, spectra

LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
IMAGE, DEPTH = np.random.default_rng(0).random((20, 24)).astype(np.float32), np.full((20, 24), 2.1)
SCENE = {"lens": LENS, "pixel": 8e-6, "encoding": "linear"}


def doors(**given):
    yield lambda: depth_of_field(IMAGE, DEPTH, **SCENE, **given)
    yield lambda: depth_of_field(IMAGE, DEPTH, **SCENE, tile=16, **given)
    if "tol" not in given:
        yield lambda: restore(IMAGE, DEPTH, **SCENE, noise=lm.Noise(white=1e3, read=1.0), **given)
    yield lambda: DepthBlur(DEPTH, LENS, 8e-6, **given)
    da = pytest.importorskip("dask.array")
    yield lambda: depth_of_field(da.from_array(IMAGE), da.from_array(DEPTH), **SCENE, **given)


@pytest.mark.parametrize(
    ("given", "error", "message"),
    [
        ({"engery": 0.9}, TypeError, r"\(\) has no option 'engery'; did you mean energy\?"),
        ({"strength": 0.9}, TypeError, r"\(\) has no option 'strength'; known are energy"),
        ({"energy": 0.4}, ValueError, "energy must be >= 0.5"),
        ({"energy": 0.99995}, ValueError, "energy must be >= 0.5 and <= 0.9999, got 0.99995"),
        ({"tol": 1e-8}, ValueError, "tol must be >= 1e-07"),
        ({"tol": 0.15}, ValueError, "tol must be"),
        ({"tol": "fine"}, TypeError, "tol must be a real number"),
    ],
)
def test_every_function_refuses_the_same_in_the_same_words(given, error, message):
    for make in doors(**given):
        with pytest.raises(error, match=message):
            make()


@pytest.mark.parametrize(
    ("given", "error", "message"),
    [
        ({"largest": 2049}, ValueError, "largest must be from 1 to 2048, got 2049"),
        ({"threads": 0}, ValueError, "threads must be from 1 to 1024, got 0"),
        ({"dtype": np.float16}, TypeError, "dtype must be float32 or float64"),
    ],
)
def test_operators_refuse_what_is_out_of_range(given, error, message):
    with pytest.raises(error, match=message):
        DepthBlur(DEPTH, LENS, 8e-6, **given)


def test_options_may_be_an_object_that_keywords_change():
    coarse = depth_of_field(IMAGE, DEPTH, **SCENE, energy=0.9, tol=1e-3).values
    for options in (
        {"options": BlurOptions(energy=0.9, tol=1e-3)},
        {"options": BlurOptions(energy=0.9), "tol": 1e-3},
    ):
        assert np.array_equal(depth_of_field(IMAGE, DEPTH, **SCENE, **options).values, coarse)
    with pytest.raises(TypeError, match="options must be a BlurOptions, got RestoreOptions"):
        depth_of_field(IMAGE, DEPTH, **SCENE, options=RestoreOptions())
    assert OperatorOptions(dtype="float64", largest=np.int64(5)).dtype == np.float64


def test_chunks_are_computed_by_one_thread_each(monkeypatch):
    da, seen = pytest.importorskip("dask.array"), []

    def tile(*arguments, **given):
        seen.append(TileBlur(*arguments, **given))
        return seen[-1]

    monkeypatch.setattr("lommel.imaging.photograph.TileBlur", tile)
    depth_of_field(da.from_array(IMAGE), da.from_array(DEPTH), **SCENE)
    assert [blur.whole.threads for blur in seen] == [1]


def test_spectra_have_one_form():
    assert spectra("channels", [5e-7, [(5e-7, 1.0), (6e-7, 3.0)]]) == (((5e-7, 1.0),), ((5e-7, 0.25), (6e-7, 0.75)))
    assert channel_spectra((4, 5), 5e-7) == (5e-7,)
    assert channel_spectra((4, 5, 3), 5e-7) == lm.imaging.RED_GREEN_BLUE
    with pytest.raises(ValueError, match="must have one entry for each of the 1 channels, got 2"):
        channel_spectra((4, 5), 5e-7, [5e-7, 6e-7])
    with pytest.raises(TypeError, match="wavelengths must be a sequence with one entry per channel, got 5e-07"):
        channel_spectra((4, 5), 5e-7, 5e-7)
    with pytest.raises(ValueError, match="each channel must have a wavelength of weight above 0"):
        spectra("channels", [[(5e-7, 0.0)]])
