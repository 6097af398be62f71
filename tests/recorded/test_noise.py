"""How electrons become values, and how uncertain these are."""

from __future__ import annotations

import math
import pickle

import numpy as np
import pytest

import lommel as lm

MAP = np.linspace(1.0, 3.0, 12).reshape(3, 4)


@pytest.mark.parametrize(
    "noise", [lm.Noise(white=0.46, read=1.6, offset=100), lm.Noise(white=MAP, read=1, offset=MAP)]
)
def test_values_are_electrons_over_white_above_the_offset(noise):
    image = np.arange(24.0).reshape(2, 3, 4)
    assert noise.electrons(image) == pytest.approx((image - noise.offset) * noise.white, rel=1e-15)
    assert noise.image(noise.electrons(image)) == pytest.approx(image, abs=1e-12)


def test_without_white_and_offset_images_are_in_electrons():
    assert np.array_equal(lm.Noise(read=3).electrons(MAP), MAP)
    assert np.array_equal(lm.Noise(read=3).image(MAP), MAP)


def test_what_is_recorded_has_the_mean_and_the_variance_that_are_said():
    noise = lm.Noise(white=0.5, read=MAP, offset=7.0)
    mean = 20.0 * MAP
    images = noise.electrons(noise.record(np.broadcast_to(mean, (100_000, 3, 4)), seed=1))
    assert images.mean(axis=0) == pytest.approx(mean, rel=0.005)
    assert images.var(axis=0) == pytest.approx(noise.variance(mean), rel=0.02)
    assert noise.variance(mean) == pytest.approx(mean + MAP**2, rel=1e-15)


def test_one_seed_draws_one_noise():
    noise = lm.Noise(read=2.0)
    assert np.array_equal(noise.record(MAP, 5), noise.record(MAP, 5))
    assert not np.array_equal(noise.record(MAP, 5), noise.record(MAP, 6))


@pytest.mark.parametrize("noise", [lm.Noise(read=2), lm.Noise(white=5000, read=MAP, offset=-0.01)])
def test_noise_comes_back_from_plain_types_and_from_a_pickle(noise):
    for back in (lm.Noise(**noise.to_dict()), pickle.loads(pickle.dumps(noise))):
        assert back == noise
        assert hash(back) == hash(noise)
    assert noise != lm.Noise(read=2.5)
    assert noise != "noise"


def test_a_map_is_a_copy_that_cannot_be_changed():
    given = MAP.copy()
    noise = lm.Noise(read=given)
    given[:] = 0.0
    assert np.array_equal(noise.read, MAP)
    with pytest.raises(ValueError, match="read-only"):
        noise.read[0, 0] = 1.0


@pytest.mark.parametrize(
    ("options", "error", "said"),
    [
        ({}, TypeError, "read"),
        ({"read": None}, TypeError, "read must hold real numbers, got None"),
        ({"read": "3"}, TypeError, "read must hold real numbers, got '3'"),
        ({"read": -1.0}, ValueError, "read must be finite and >= 0, got -1.0"),
        ({"read": math.nan}, ValueError, "read must be finite and >= 0, got nan"),
        ({"read": [1.0, 2.0]}, ValueError, r"read must be a number or have the shape .*, got shape \(2,\)"),
        ({"read": 1, "white": 0}, ValueError, "white must be > 0 electrons, got 0"),
        ({"read": 1, "white": math.inf}, ValueError, "white must be finite, got inf"),
        ({"read": 1, "white": np.zeros((0, 4))}, ValueError, r"white must be a number or .*, got shape \(0, 4\)"),
        ({"read": 1, "offset": math.nan}, ValueError, "offset must be finite, got nan"),
    ],
)
def test_what_is_no_noise_is_refused(options, error, said):
    with pytest.raises(error, match=said):
        lm.Noise(**options)


def test_images_that_do_not_fit_are_refused():
    noise = lm.Noise(white=2.0, read=MAP)
    with pytest.raises(
        ValueError, match=r"read, of shape \(3, 4\), must have a value for each pixel, got .*\(4, 3\)"
    ):
        noise.variance(MAP.T)
    with pytest.raises(ValueError, match="image must be finite, got nan"):
        noise.electrons(math.nan)
    with pytest.raises(ValueError, match=r"electrons must be finite and >= 0, got -1.0"):
        noise.record(-np.ones((3, 4)), 0)
