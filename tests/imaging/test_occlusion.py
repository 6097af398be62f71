"""The operator of what hides what: a sum over layers in plain NumPy, its matrix, and its transpose."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import lommel as lm
from lommel.imaging import DepthBlur, Occlusion
from lommel.imaging.occlusion import MAX_LAYERS, _layering, _radii

LENS = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
PIXEL = 20e-6


def torn(rng: np.random.Generator, shape: tuple[int, int] = (17, 22)) -> np.ndarray:
    """Depth with edges, slants and single points; it reaches from 1.3 to 6 m in every scene."""
    y, x = np.indices(shape)
    depth = 2.5 + 0.1 * rng.random() * x + (y > rng.integers(4, 12)) * 1.5 * rng.random()
    depth[rng.integers(0, 9) :, rng.integers(3, 16) :] = 1.3 + 0.3 * rng.random()
    depth[rng.random(shape) < 0.05] = 1.4
    depth[0, 0], depth[-1, -1] = 1.3, 6.0
    return depth


def layers_of(blur: DepthBlur) -> tuple[np.ndarray, np.ndarray]:
    """Layers of half a pixel of blur radius, or more, from the largest on, and the radii."""
    defocus, radii = _radii(blur, (float(blur.defocus.min()), float(blur.defocus.max())))
    radius = np.interp(blur.defocus, defocus, radii)
    thickness = max(0.5, np.ptp(radii) / MAX_LAYERS)
    return np.minimum((radii.max() - radius) / thickness, MAX_LAYERS - 1).astype(np.int64), radius


def behind_of(layer: np.ndarray, radius: np.ndarray) -> np.ndarray:
    """What stands for the light behind each point, or -1: other points are tried by distance, one by one."""
    (height, width), behind = layer.shape, np.full(layer.shape, -1)
    rows, columns = np.indices(layer.shape)
    for y, x in np.ndindex(height, width):
        squared, passed = (rows - y) ** 2 + (columns - x) ** 2, layer[y, x]
        near = np.flatnonzero(squared < (radius[y, x] - radius.min()) ** 2)
        for at in near[np.argsort(squared.ravel()[near], kind="stable")]:
            row, column = divmod(int(at), width)
            if layer[row, column] > passed:
                if np.sqrt(squared[row, column]) < radius[y, x] - radius[row, column]:
                    there = 2 * row - y, 2 * column - x
                    inside = 0 <= there[0] < height and 0 <= there[1] < width
                    row, column = there if inside and layer[there] > passed else (row, column)
                    behind[y, x] = row * width + column
                    break
                passed = layer[row, column]
    return behind


def by_layers(blur: DepthBlur, light: np.ndarray) -> np.ndarray:
    """Layer after layer from the front, each point a window of its own: the definition, for grey light."""
    layer, radius = layers_of(blur)
    behind, bank, (height, width) = behind_of(layer, radius), blur.banks[0], blur.shape
    half = bank.half
    rows, columns = (np.pad(np.arange(side), half, mode="symmetric") for side in blur.shape)
    out, taken = np.zeros(blur.shape), np.zeros(blur.shape)
    for index in np.unique(layer):
        spread, covered = np.zeros((2, height + 4 * half, width + 4 * half))
        for i, y in enumerate(rows):
            for j, x in enumerate(columns):
                point = y * width + x
                if layer[y, x] != index:
                    point = behind[y, x]
                    if point < 0 or layer.flat[point] != index:
                        continue
                window, at = bank.window(blur.defocus.flat[point]), np.s_[i : i + 2 * half + 1, j : j + 2 * half + 1]
                spread[at] += light.flat[point] * window
                covered[at] += window
        middle = np.s_[2 * half : 2 * half + height, 2 * half : 2 * half + width]
        spread, covered = spread[middle], np.maximum(covered[middle], 0.0)
        share = np.minimum(1.0, np.maximum(1.0 - taken, 0.0) / np.maximum(covered, 1e-300))
        out += share * spread
        taken += share * covered
    return (out + 1e-9 * light) / (taken + 1e-9)


@pytest.mark.parametrize(("dtype", "allowed"), [(np.float64, 1e-11), (np.float32, 4e-6)])
def test_it_is_the_sum_over_layers(dtype, allowed):
    rng = np.random.default_rng(5)
    blur = DepthBlur(torn(rng), LENS, PIXEL, dtype=dtype, largest=20)
    light = rng.random(blur.shape).astype(dtype)
    wanted = by_layers(blur, light.astype(np.float64))
    assert len(np.unique(layers_of(blur)[0])) > 4
    assert np.abs(blur.forward(light) - wanted).max() > 0.1
    operator, adjoined = Occlusion(blur), Occlusion(blur)
    adjoined.adjoint(light)
    # At once, again, with what pixels see kept, and that found without light: the same to the last bit.
    first, *others = (
        operator.forward(light),
        operator.forward(light),
        operator.forward(light),
        adjoined.forward(light),
    )
    assert all(np.array_equal(first, other) for other in others)
    for made in (first,):
        assert (made.dtype, made.shape) == (dtype, light.shape)
        assert np.abs(made - wanted).max() <= allowed


def test_its_transpose_is_that_of_its_matrix():
    rng = np.random.default_rng(6)
    blur = DepthBlur(torn(rng, (9, 11)), LENS, PIXEL, dtype=np.float64, largest=20)
    operator, size = Occlusion(blur), 99
    matrix, back = (
        np.array([apply(unit.reshape(9, 11)).ravel() for unit in np.eye(size)])
        for apply in (operator.forward, operator.adjoint)
    )
    assert np.abs(matrix - back.T).max() < 1e-15
    sources = _layering(blur).edges()[1]
    assert len(np.unique(sources)) < sources.size  # one point stands for several
    light = rng.random((9, 11))
    assert np.abs(light.ravel() @ matrix - operator.forward(light).ravel()).max() < 1e-14


@given(st.integers(0, 2**32 - 1), st.sampled_from([(np.float64, 1e-13), (np.float32, 1e-5)]))
def test_the_product_of_two_images_does_not_tell_which_was_blurred(seed, precision):
    rng, (dtype, allowed) = np.random.default_rng(seed), precision
    blur = DepthBlur(torn(rng), LENS, PIXEL, dtype=dtype, channels=(6e-7, 5e-7, 6e-7), largest=20)
    operator = Occlusion(blur)
    a, b, c = rng.standard_normal((3, *blur.shape, 3)).astype(dtype)
    forth, back = operator.forward(a), operator.adjoint(b)
    assert abs(np.vdot(forth, b) - np.vdot(a, back)) <= allowed * np.linalg.norm(a) * np.linalg.norm(b)
    both = operator.forward(a + 2 * c) - 2 * operator.forward(c)
    assert np.abs(both - forth).max() <= allowed * 30.0


@pytest.mark.parametrize("mirrored", [False, True])
def test_what_is_behind_is_found_on_the_side_where_it_is(mirrored):
    depth = np.full((80, 70), 2.0)
    depth[72:77, 60:] = 6.0
    blur = DepthBlur(depth[:, ::-1] if mirrored else depth, LENS, PIXEL, largest=40)
    layer, radius = layers_of(blur)
    assert np.array_equal(_layering(blur).behind, behind_of(layer, radius))


@settings(max_examples=25)
@given(st.integers(0, 2**32 - 1), st.integers(1, 20), st.integers(1, 20))
def test_layers_and_what_they_hide_are_those_of_their_definition(seed, height, width):
    rng = np.random.default_rng(seed)
    depth = rng.choice([1.3, 1.45, 1.8, 2.0, 2.6, 6.0], (height, width))
    depth[: rng.integers(0, height + 1), : rng.integers(0, width + 1)] = rng.uniform(1.3, 6.0)
    if rng.random() < 0.5:
        depth = np.sort(depth, axis=int(rng.integers(2)))
    blur = DepthBlur(depth, LENS, PIXEL, largest=40)
    layer, radius = layers_of(blur)
    made = _layering(blur)
    assert np.array_equal(made.layers, np.unique(layer, return_inverse=True)[1].reshape(layer.shape))
    assert made.number == len(np.unique(layer))
    behind = np.full(layer.shape, -1) if made.behind is None else made.behind
    assert np.array_equal(behind, behind_of(layer, radius))


@settings(max_examples=15)
@given(st.integers(0, 2**32 - 1), st.integers(1, 90), st.integers(1, 200))
def test_threads_and_tiles_change_nothing(seed, height, width):
    rng = np.random.default_rng(seed)
    depth = rng.choice([1.3, 1.8, 2.6, 6.0], (height, width))
    blur = [DepthBlur(depth, LENS, PIXEL, largest=40, threads=threads) for threads in (1, 3)]
    light = rng.random(depth.shape, np.float32)
    one, other = (Occlusion(each).forward(light) for each in blur)
    assert np.array_equal(one, other)
    white = Occlusion(blur[0]).forward(np.ones_like(light))
    assert np.abs(white - 1.0).max() < 1e-5


def test_what_is_kept_is_that_of_the_depth_map():
    rng = np.random.default_rng(7)
    one, other = torn(rng), torn(rng)
    blur = DepthBlur(one, LENS, PIXEL, dtype=np.float64, channels=(6e-7, 5e-7, 6e-7), largest=20)
    light, operator = rng.random((*one.shape, 3)), Occlusion(blur)
    first = operator.forward(light)
    assert np.array_equal(operator.forward(light), first)
    blur.place(other)
    assert np.array_equal(operator.forward(light), Occlusion(blur).forward(light))
    assert np.abs(operator.forward(light) - first).max() > 0.1
