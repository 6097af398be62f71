"""A plan answers as depth_of_field() does, and computes only what changed."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.imaging import RED_GREEN_BLUE, DepthBlur, FocusPlan, depth_of_field

LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
PIXEL = 8e-6


def scene(dtype=np.uint8):
    rng = np.random.default_rng(0)
    image = rng.random((40, 50, 3))
    image = (image * 200).astype(dtype) if np.dtype(dtype).kind == "u" else image.astype(dtype)
    return image, 1.7 + 0.6 * rng.random((40, 50))


@pytest.mark.parametrize(("dtype", "encoding"), [(np.uint8, "srgb"), (np.uint16, "linear"), (np.float32, "linear")])
@pytest.mark.parametrize(
    "change", [{}, {"focus_distance": 2.2}, {"f_number": 8.0}, {"focus_distance": 1.9, "f_number": 5.6}]
)
def test_a_plan_gives_what_depth_of_field_gives_bit_for_bit(dtype, encoding, change):
    image, depth = scene(dtype)
    plan = FocusPlan(image, depth, LENS, PIXEL, encoding=encoding)
    plan(focus_distance=2.1)
    settings = {"focal_length": 50e-3, "wavelength": 550e-9, "f_number": 4.0} | change
    if "focus_distance" not in change:
        settings["sensor_distance"] = LENS.sensor_distance
    expected = depth_of_field(image, depth, lm.Lens(**settings), PIXEL, encoding=encoding)
    for out in (None, np.empty_like(image)):
        made = plan(**change, out=out)
        assert made.values.tobytes() == expected.values.tobytes()
        assert (made.lost, made.error, made.window) == (expected.lost, expected.error, expected.window)
        assert out is None or made.values is out


def test_what_is_done_to_the_inputs_afterwards_does_not_matter():
    image, depth = scene(np.float32)
    plan = FocusPlan(image, depth, LENS, PIXEL, encoding="linear")
    before = plan().values.copy()
    image[:], depth[:] = 0.0, 1.0
    assert np.array_equal(plan().values, before)
    assert plan(f_number=5.6).values.max() > 0.5


def test_light_is_added_without_occlusion():
    image, depth = scene(np.float32)
    plan = FocusPlan(image, depth, LENS, PIXEL, encoding="linear", occlusion=False)
    blur = DepthBlur(depth, LENS, PIXEL, channels=RED_GREEN_BLUE)
    assert np.array_equal(plan().values, blur.forward(image))
    assert np.abs(plan().values - depth_of_field(image, depth, LENS, PIXEL, encoding="linear").values).max() > 0.1
