"""Recorded images: which pixels are known, full, or left out, and what is said of them."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.fit import Findings
from lommel.recorded.counts import Counts, recording_findings

NOISE = lm.Noise(white=0.46, read=1.6, offset=100.0)
IMAGES = np.round(NOISE.record(np.full((3, 8, 9), 400.0), seed=1)).astype(np.uint16)


def counted(images, **options):
    return Counts.of("images", images, sides=(2, 3), shape="(height, width) or (n, height, width)", **options)


def told(images):
    return Findings(recording_findings(images, NOISE, "image")).text


@pytest.mark.parametrize("kind", [np.uint16, np.int32, np.float32])
def test_pixels_are_known_full_or_hidden(kind):
    images = IMAGES.astype(kind)
    images[0, 2, 3] = images[1, 2, 4] = 2000
    mask = np.zeros((8, 9), dtype=bool)
    mask[2, 4] = True
    found = counted(images, saturation=2000, mask=mask)
    assert np.argwhere(found.full).tolist() == [[0, 2, 3]]
    assert np.argwhere(found.hidden).tolist() == [[0, 2, 4], [1, 2, 4], [2, 2, 4]]
    assert (~found.known).sum() == 4
    assert found.marked().dtype == (np.float64 if kind == np.int32 else np.float32)
    np.testing.assert_array_equal(np.isnan(found.marked()), ~found.known)
    np.testing.assert_array_equal(found.filled(), np.where(found.known, images, 0.0))
    assert counted(IMAGES).marked() is IMAGES
    assert "4 of 216 pixels left out (masked, saturated or NaN)" in told([found])
    assert told([counted(IMAGES)]) == ""


def test_infinities_are_left_out_and_the_largest_of_a_type_is_full():
    images = IMAGES.astype(np.float64)
    images[0, 0, :3] = np.nan, np.inf, -np.inf
    assert (~counted(images).known).sum() == 3
    images = IMAGES.copy()
    images[2, 1, 1] = 65535
    assert np.argwhere(counted(images).full).tolist() == [[2, 1, 1]]
    assert counted(images, saturation=np.inf).known.all()


def test_what_was_assumed_or_may_be_saturated_is_said_once():
    bright = np.clip(np.arange(216.0).reshape(3, 8, 9) * 10.0, 100, 1023)
    found = counted(bright.astype(np.uint16))
    assert found.saturation == 1023
    said = told([found[0], found[1], found[2]])
    assert said.count("that of 10 bits: they were taken as saturated; saturation= states another") == 1
    other = counted(np.minimum(bright, 1000.0))
    said = told([other[k] for k in range(3)])
    assert "pixels of image 1 have exactly the largest value, 1000: if they are saturated, state it" in said


def test_images_without_light_or_known_pixels_are_refused():
    dark = IMAGES.copy()
    dark[1] = 7
    with pytest.raises(ValueError, match=r"images\[1\] must show a star, got the value 7 everywhere"):
        counted(dark).require_light("images", "a star")
    blind = np.where(np.arange(3)[:, None, None] == 2, np.nan, IMAGES)
    with pytest.raises(ValueError, match=r"images\[2\] must have pixels that are neither .*, got none"):
        counted(blind).require_known("images")
    half = np.where(np.arange(9) < 6, np.nan, IMAGES)
    counted(half).require_known("images", 0.3)
    with pytest.raises(ValueError, match=r"images\[0\] must have pixels .*, got 24"):
        counted(half).require_known("images", 0.5)
    with pytest.raises(ValueError, match="images must have pixels"):
        counted(blind[2]).require_known("images")


@pytest.mark.parametrize(
    ("given", "kind", "said"),
    [
        ({"images": np.zeros((2, 0, 3))}, ValueError, r"images must have the shape .*, got \(2, 0, 3\)"),
        ({"images": np.zeros((0, 4, 3))}, ValueError, r"images must have the shape .*, got \(0, 4, 3\)"),
        ({"images": np.zeros(3)}, ValueError, r"got \(3,\)"),
        ({"images": "bright"}, TypeError, "images must hold real numbers"),
        (
            {"images": IMAGES, "mask": np.zeros((8, 9))},
            ValueError,
            r"mask must be True or False .* float64 of \(8, 9\)",
        ),
        ({"images": IMAGES, "mask": np.zeros((9, 8), bool)}, ValueError, "mask must be True or False"),
        ({"images": IMAGES, "saturation": np.nan}, ValueError, "saturation must be finite"),
    ],
)
def test_bad_arguments_are_refused(given, kind, said):
    with pytest.raises(kind, match=said):
        counted(**given)
