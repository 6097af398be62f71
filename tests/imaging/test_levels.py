"""Levels of stored images and light on a sensor."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.base.encoding import clipped_fraction, from_light, to_light
from lommel.core import engine
from lommel.imaging.photograph import encode_light


def around(values: np.ndarray, ulps: int) -> np.ndarray:
    """Each of some floats, and those so many after it."""
    return (values.astype(np.float32).view(np.int32) + np.int32(ulps)).view(np.float32)


@pytest.mark.parametrize("encoding", ["srgb", "linear"])
def test_bytes_are_those_of_the_formula_beside_every_edge(encoding):
    edges = to_light("edges", (np.arange(255) + 0.5) / 255.0, encoding, np.float64)
    light = np.concatenate([around(edges, ulps) for ulps in (-3000, -6, 6, 3000)])
    values, clipped = encode_light(light, encoding, np.uint8)
    assert values.dtype == np.uint8
    assert np.array_equal(values, from_light(light.astype(np.float64), encoding, np.uint8))
    assert clipped == 0.0


@pytest.mark.parametrize("encoding", ["srgb", "linear"])
def test_bytes_of_an_image_are_those_of_the_formula_but_between_two_levels(encoding):
    rng = np.random.default_rng(0)
    light = np.concatenate([rng.uniform(-0.1, 1.2, 150_000), 10.0 ** rng.uniform(-40.0, 4.0, 49_998), [0.0, -0.0]])
    light = light.astype(np.float32).reshape(2, -1, 5)[:, ::2]
    values, clipped = encode_light(light, encoding, np.uint8)
    wanted = from_light(light, encoding, np.uint8)
    differ = values != wanted
    assert differ.mean() <= 1e-4
    assert np.abs(values[differ].astype(int) - wanted[differ]).max(initial=0) <= 1
    assert clipped == clipped_fraction(light, np.uint8)
    assert clipped > 0.1


@pytest.mark.parametrize(
    ("dtype", "kind"), [(np.float64, np.uint8), (np.float32, np.uint16), (np.float32, np.float32)]
)
def test_other_types_are_those_of_the_formula(dtype, kind):
    light = np.linspace(-0.1, 1.1, 99, dtype=dtype)
    values, clipped = encode_light(light, "srgb", kind)
    assert np.array_equal(values, from_light(light, "srgb", kind))
    assert clipped == clipped_fraction(light, kind)


@pytest.mark.parametrize("shape", [(1, 1, 1), (3, 30, 100), (8, 7, 48), (17, 5, 33), (130, 40, 70)])
def test_matrix_products_are_those_of_numpy_with_any_number_of_threads(shape):
    rows, count, sums = shape
    draw = np.random.default_rng(0)
    left, right = draw.standard_normal((rows, count)), draw.standard_normal((count, sums))
    made = engine.product(left, right, 1)
    np.testing.assert_allclose(made, left @ right, rtol=0.0, atol=1e-13)
    assert np.array_equal(engine.product(left, right, 3), made)
