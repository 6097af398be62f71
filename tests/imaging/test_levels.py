"""Light as bytes: the levels of the formula, however close to the edge between two."""

from __future__ import annotations

import numpy as np
import pytest

from lommel import _core
from lommel.base.encoding import clipped_share, from_light, to_light
from lommel.imaging.photograph import stored


def around(values: np.ndarray, ulps: int) -> np.ndarray:
    """Each of some floats, and those so many after it."""
    return (values.astype(np.float32).view(np.int32) + np.int32(ulps)).view(np.float32)


@pytest.mark.parametrize("encoding", ["srgb", "linear"])
@pytest.mark.parametrize("threads", [0, 1])
def test_bytes_are_those_of_the_formula_beside_every_edge(encoding, threads):
    edges = to_light("edges", (np.arange(255) + 0.5) / 255.0, encoding, np.float64)
    light = np.concatenate([around(edges, ulps) for ulps in (-3000, -6, 6, 3000)])
    values, clipped = stored(light, encoding, np.uint8, threads)
    assert values.dtype == np.uint8
    assert np.array_equal(values, from_light(light.astype(np.float64), encoding, np.uint8))
    assert clipped == 0.0


@pytest.mark.parametrize("encoding", ["srgb", "linear"])
def test_bytes_of_an_image_are_those_of_the_formula_but_between_two_levels(encoding):
    rng = np.random.default_rng(0)
    light = np.concatenate([rng.uniform(-0.1, 1.2, 150_000), 10.0 ** rng.uniform(-40.0, 4.0, 49_998), [0.0, -0.0]])
    light = light.astype(np.float32).reshape(2, -1, 5)[:, ::2]
    values, clipped = stored(light, encoding, np.uint8)
    wanted = from_light(light, encoding, np.uint8)
    differ = values != wanted
    assert differ.mean() <= 1e-4
    assert np.abs(values[differ].astype(int) - wanted[differ]).max(initial=0) <= 1
    assert clipped == clipped_share(light, np.uint8)
    assert clipped > 0.1


@pytest.mark.parametrize(
    ("dtype", "kind"), [(np.float64, np.uint8), (np.float32, np.uint16), (np.float32, np.float32)]
)
def test_other_types_are_those_of_the_formula(dtype, kind):
    light = np.linspace(-0.1, 1.1, 99, dtype=dtype)
    values, clipped = stored(light, "srgb", kind)
    assert np.array_equal(values, from_light(light, "srgb", kind))
    assert clipped == clipped_share(light, kind)


@pytest.mark.parametrize("edges", [[0.5], [1e-30, 1.0], [1.0, 1.0001, 3.0]])
def test_any_edges_that_rise_will_do(edges):
    edges = np.array(edges, np.float32)
    light = np.concatenate([around(edges, -1), edges, around(edges, 1), [-1.0, 0.0, 1e9, np.inf, np.nan]]).astype(
        np.float32
    )
    values = np.empty(light.shape, np.uint8)
    assert _core.levels(light, edges, 0.0, 5.0, 1, values) == 3
    assert np.array_equal(values[:-1], np.searchsorted(edges, light[:-1], side="right"))
    assert values[-1] == 0  # of what is no number


def test_what_does_not_fit_is_refused():
    light, values, edges = np.ones(5, np.float32), np.empty(5, np.uint8), np.array([0.25, 0.5], np.float32)
    for wrong in (edges[:0], -edges, np.linspace(0.1, 1.0, 256, dtype=np.float32), np.array([0.5, np.inf], "f4")):
        with pytest.raises(ValueError, match="edges must be 1 to 255, above 0 and finite"):
            _core.levels(light, wrong, 0.0, 1.0, 0, values)
    with pytest.raises(ValueError, match="edges must rise"):
        _core.levels(light, edges[::-1].copy(), 0.0, 1.0, 0, values)
    with pytest.raises(ValueError, match="out must match the light"):
        _core.levels(light, edges, 0.0, 1.0, 0, values[1:])
