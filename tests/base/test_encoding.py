"""Between stored values and light."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.base.encoding import clipped_fraction, from_light, to_light

WHOLE = {np.uint8: np.arange(2**8, dtype=np.uint8), np.uint16: np.arange(2**16, dtype=np.uint16)}


@pytest.mark.parametrize("encoding", ["srgb", "linear"])
@pytest.mark.parametrize("kind", WHOLE)
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_every_integer_comes_back_as_it_was(encoding, kind, dtype):
    light = to_light("image", WHOLE[kind], encoding, dtype)
    assert light.dtype == dtype
    assert np.all(np.diff(light) > 0)
    assert (light[0], light[-1]) == (0.0, pytest.approx(1.0, abs=1e-7))
    back = from_light(light, encoding, kind)
    assert back.dtype == kind
    assert np.array_equal(back, WHOLE[kind])


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
def test_images_of_more_values_than_levels_are_decoded_like_small_ones(kind):
    values = np.random.default_rng(0).integers(0, np.iinfo(kind).max + 1, (300, 300), dtype=kind)
    whole = to_light("image", values, "srgb", np.float32)
    rows = [to_light("image", values[0, k : k + 50], "srgb", np.float32) for k in range(0, 300, 50)]
    assert np.array_equal(whole[0], np.concatenate(rows))


@pytest.mark.parametrize(("kind", "allowed"), [(np.float16, 1e-3), (np.float32, 1e-6), (np.float64, 1e-14)])
@pytest.mark.parametrize("encoding", ["srgb", "linear"])
def test_floats_come_back_in_their_type_even_brighter_than_white(kind, allowed, encoding):
    values = np.linspace(0.0, 3.0, 500).astype(kind)
    back = from_light(to_light("image", values, encoding, np.float64), encoding, kind)
    assert back.dtype == kind
    assert back.astype(float) == pytest.approx(values.astype(float), rel=allowed, abs=1e-12)


def test_srgb_is_that_of_the_standard():
    # IEC 61966-2-1; 0.5 and 0.735357 by the formula ((x + 0.055) / 1.055)^2.4, 0.04 in its straight part.
    stored = np.array([0.0, 0.04, 0.5, 0.735356983052449, 1.0])
    light = to_light("image", stored, "srgb", np.float64)
    assert light == pytest.approx([0.0, 0.04 / 12.92, 0.21404114048223255, 0.5, 1.0], abs=1e-12)


def test_srgb_is_continuous_where_its_parts_meet():
    light = to_light("image", np.array([0.04045 * (1 - 1e-9), 0.04045 * (1 + 1e-9)]), "srgb", np.float64)
    assert np.ptp(light) < 1e-7
    stored = from_light(np.array([0.0031308 * (1 - 1e-9), 0.0031308 * (1 + 1e-9)]), "srgb", np.float64)
    assert np.ptp(stored) < 1e-7


def test_linear_light_may_be_negative():
    values = np.array([-0.5, 0.25])
    assert np.array_equal(from_light(to_light("image", values, "linear", np.float64), "linear", np.float64), values)


@pytest.mark.parametrize(("light", "stored"), [(1.01, 1.0), (300.0, 1.0), (-0.02, 0.0)])
@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
def test_integers_clip_what_they_cannot_hold_and_the_share_is_told(light, stored, kind):
    both = np.array([0.5, light])
    assert from_light(both, "linear", kind)[1] == stored * np.iinfo(kind).max
    assert clipped_fraction(both, kind) == 0.5
    assert clipped_fraction(both, np.float32) == 0.0
    assert clipped_fraction(np.array([0.0, 1.0]), kind) == 0.0


def test_rounding_at_white_is_forgiven():
    assert list(from_light(np.array([1.0 + 1e-6, -1e-6]), "linear", np.uint8)) == [255, 0]


@pytest.mark.parametrize(
    ("values", "encoding", "error", "message"),
    [
        (np.array([0.1, np.nan]), "linear", ValueError, "image must be finite, got nan"),
        (np.array([0.1, -0.2]), "srgb", ValueError, "image must be >= 0 to be sRGB, got -0.2"),
        (np.array([1, 2]), "linear", TypeError, "image must hold unsigned integers or floats, got int64"),
    ],
)
def test_what_is_no_light_is_refused_by_name(values, encoding, error, message):
    with pytest.raises(error, match=message):
        to_light("image", values, encoding, np.float64)
