"""Options of photographs: the same checks in every function that takes them."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.imaging import BlurOptions, RestoreOptions, depth_of_field
from lommel.imaging.settings import OperatorOptions, channel_spectra, spectra

LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
IMAGE, DEPTH = np.random.default_rng(0).random((20, 24)).astype(np.float32), np.full((20, 24), 2.1)
SCENE = {"lens": LENS, "pixel": 8e-6, "encoding": "linear"}


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


def test_spectra_have_one_form():
    assert spectra("channels", [5e-7, [(5e-7, 1.0), (6e-7, 3.0)]]) == (((5e-7, 1.0),), ((5e-7, 0.25), (6e-7, 0.75)))
    assert channel_spectra((4, 5), 5e-7) == (5e-7,)
    assert channel_spectra((4, 5, 3), 5e-7) == lm.imaging.RED_GREEN_BLUE
    with pytest.raises(ValueError, match="each channel must have a wavelength of weight above 0"):
        spectra("channels", [[(5e-7, 0.0)]])
