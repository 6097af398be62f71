"""Derivatives of blur, and the operator that solvers take."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.sparse.linalg import lsqr

import lommel as lm
from lommel import Lens
from lommel.imaging import BlurSlopes, DepthBlur, LinearBlur, Occlusion

LENS = lm.Lens(focal_length=35e-3, f_number=4.0, focus_distance=2.2, wavelength=540e-9)
SINE = lm.Lens(
    focal_length=35e-3,
    f_number=4.0,
    focus_distance=2.2,
    wavelength=540e-9,
    obscuration=0.3,
    aberrations=lm.Wavefront(0.0, 2.0),
    model="aplanatic",
)
CHANNELS = (600e-9, ((540e-9, 0.5), (500e-9, 0.5)))
SHAPE = (30, 41)


def scene(lens: lm.Lens, border: str = "reflect", **options: float) -> tuple[DepthBlur, np.ndarray, np.ndarray]:
    """A blur of points at random depths, the depths, and the light of two channels."""
    rng = np.random.default_rng(0)
    depth = rng.uniform(1.6, 4.7, SHAPE)
    ends = np.array([[1.5, 5.5]] * 200)
    blur = DepthBlur(ends, lens, 6e-6, channels=CHANNELS, border=border, largest=60, dtype=np.float64, **options)
    blur.place(depth)
    return blur, depth, rng.random((*SHAPE, 2))


@pytest.mark.parametrize(
    ("lens", "border", "options"),
    [
        (LENS, "reflect", {}),
        (LENS, "zero", {"energy": 0.9}),
        (SINE, "extend", {"tol": 1e-6}),
        (LENS.stopped(8.0), "reflect", {"energy": 0.995, "tol": 1e-3}),
        (LENS, "reflect", {"energy": 1.0}),
        (LENS, "zero", {"energy": 1.0}),
    ],
)
def test_what_is_left_of_a_change_of_depth_is_of_second_order(lens, border, options):
    """Steps of C_d from 0.1 to 0.001 rad, at random at each point."""
    blur, depth, light = scene(lens, border, **options)
    slopes, before = BlurSlopes(light, blur), blur.forward(light)
    rate = float(lens.defocus(1.0) - lens.defocus(np.inf))
    change = np.random.default_rng(1).standard_normal(SHAPE)
    # To first order in C_d, which is what the blur is a function of.
    predicted, left = slopes.forward(-change * depth**2 / rate), []
    for step in (1e-1, 1e-2, 1e-3):
        blur.place(1.0 / (1.0 / depth + step * change / rate))
        left.append(np.linalg.norm(blur.forward(light) - before - step * predicted))
    assert left[0] < 0.03 * np.linalg.norm(predicted)
    assert np.log10(left[0] / left[1]) >= 1.95
    assert np.log10(left[1] / left[2]) >= 1.95


@pytest.mark.parametrize("lens", [LENS, SINE])
def test_what_is_left_of_a_change_of_focus_is_of_second_order(lens):
    blur, depth, light = scene(lens, tol=1e-6)
    slope = BlurSlopes(light, blur).focus()

    def seen(sensor_distance: float) -> np.ndarray:
        there = replace(lens, sensor_distance=sensor_distance)
        options = {"channels": CHANNELS, "largest": 60, "dtype": np.float64, "tol": 1e-7}
        return DepthBlur(depth, there, 6e-6, **options).forward(light)

    at = lens.sensor_distance
    left = [np.linalg.norm((seen(at * (1.0 + step)) - seen(at)) / (at * step) - slope) for step in (1e-4, 1e-5)]
    assert left[0] <= 0.1 * np.linalg.norm(slope)
    assert left[1] <= 0.2 * left[0]


def test_the_focus_moves_as_the_lens_says():
    """Distances in focus, by the chain rule that the docstring states."""
    blur, depth, light = scene(LENS, tol=1e-6)
    by_sensor = BlurSlopes(light, blur).focus()
    by_distance = -((LENS.sensor_distance / LENS.focus_distance) ** 2) * by_sensor
    options = {"channels": CHANNELS, "largest": 60, "dtype": np.float64, "tol": 1e-7}
    near, far = (DepthBlur(depth, LENS.focused(2.2 + step), 6e-6, **options) for step in (-2e-4, 2e-4))
    found = (far.forward(light) - near.forward(light)) / 4e-4
    assert np.abs(found - by_distance).max() <= 3e-3 * np.abs(by_distance).max()


@pytest.mark.parametrize("border", ["reflect", "extend", "zero"])
@pytest.mark.parametrize("energy", [0.98, 1.0])
def test_the_transpose_is_exact_and_solvers_take_both(border, energy):
    blur, _, light = scene(LENS, border, energy=energy)
    slopes, rng = BlurSlopes(light, blur), np.random.default_rng(2)
    change, other = rng.standard_normal(SHAPE), rng.standard_normal((*SHAPE, 2))
    one, two = np.vdot(slopes.forward(change), other), np.vdot(change, slopes.adjoint(other))
    assert one == pytest.approx(two, rel=1e-11)
    operator = slopes.as_linear_operator()
    assert operator.shape == (2 * SHAPE[0] * SHAPE[1], SHAPE[0] * SHAPE[1])
    np.testing.assert_array_equal(operator @ change.ravel(), slopes.forward(change).ravel())
    np.testing.assert_array_equal(operator.T @ other.ravel(), slopes.adjoint(other).ravel())


def test_what_is_at_infinity_does_not_move_and_darkness_neither():
    depth = np.where(np.arange(20) < 9, np.inf, 3.0) * np.ones((20, 1))
    blur = DepthBlur(depth, LENS, 6e-6, dtype=np.float64, largest=20)
    slopes = BlurSlopes(np.where(np.arange(20) < 14, 1.0, 0.0) * np.ones((20, 1)), blur)
    gradient = slopes.adjoint(np.random.default_rng(3).random((20, 20)))
    assert not gradient[:, :9].any()
    assert gradient[:, 9:14].all()
    assert not gradient[:, 14:].any()


def test_the_operator_keeps_the_depth_and_the_light_that_it_was_made_with():
    blur, depth, light = scene(LENS)
    slopes, change = BlurSlopes(light, blur), np.ones(SHAPE)
    before = slopes.forward(change)
    light[:] = 0.0
    blur.place(depth + 0.2)
    np.testing.assert_array_equal(slopes.forward(change), before)


def test_what_does_not_fit_is_refused():
    blur, _, light = scene(LENS)
    slopes = BlurSlopes(light, blur)
    with pytest.raises(ValueError, match="energy must be below 1 for the derivative by focus"):
        BlurSlopes(light, scene(LENS, energy=1.0)[0]).focus()
    with pytest.raises(TypeError, match="blur must be"):
        BlurSlopes(light, lm.imaging.Occlusion(blur))
    with pytest.raises(ValueError, match=r"image must have the shape \(30, 41, 2\)"):
        BlurSlopes(light[..., 0], blur)
    with pytest.raises(ValueError, match=r"change must have the shape of the depth, \(30, 41\), got \(30, 40\)"):
        slopes.forward(np.ones((30, 40)))
    with pytest.raises(ValueError, match="change must be finite"):
        slopes.forward(np.full(SHAPE, np.nan))
    with pytest.raises(ValueError, match="image must be finite"):
        slopes.adjoint(np.full((*SHAPE, 2), np.inf))


LENS_LINEAR = Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
DEPTH = np.full((24, 30), 2.6)
DEPTH[:, 12:] = 1.9


def _blur(channels: int = 1, dtype: type = np.float64, **options: str) -> DepthBlur:
    colours = [450e-9 + 100e-9 * place for place in range(channels)]
    return DepthBlur(DEPTH, LENS_LINEAR, 8e-6, channels=colours, dtype=dtype, **options)


@pytest.mark.parametrize("border", ["reflect", "extend", "zero"])
@pytest.mark.parametrize("channels", [1, 3])
@pytest.mark.parametrize("hiding", [False, True])
def test_the_operator_does_what_the_blur_does_both_ways(border: str, channels: int, hiding: bool) -> None:
    """Vectors are images, row by row, and a matrix has one in each column."""
    blur: LinearBlur = _blur(channels, border=border)
    blur = Occlusion(blur) if hiding else blur
    operator = blur.as_linear_operator()
    assert operator.dims == ((24, 30) if channels == 1 else (24, 30, channels))
    assert operator.shape == (720 * channels,) * 2
    assert operator.dtype == np.float64
    images = np.random.default_rng(0).random((2, *operator.dims))
    columns = images.reshape(2, -1).T
    np.testing.assert_array_equal((operator @ columns).T, [blur.forward(image).ravel() for image in images])
    np.testing.assert_array_equal((operator.H @ columns).T, [blur.adjoint(image).ravel() for image in images])
    a, b = columns.T
    assert (operator @ a) @ b == pytest.approx(a @ (operator.T @ b), rel=1e-12)


def test_least_squares_find_the_light() -> None:
    """A solver of SciPy undoes a mild blur."""
    operator = DepthBlur(np.full((24, 30), 2.05), LENS_LINEAR, 16e-6, dtype=np.float64).as_linear_operator()
    light = np.random.default_rng(1).random(operator.shape[0])
    found = lsqr(operator, operator @ light, atol=1e-14, btol=1e-14, iter_lim=4000)[0]
    assert abs(found - light).max() < 1e-6


def test_vectors_of_other_types_are_taken() -> None:
    """Solvers begin with zeros of any type."""
    operator = _blur(dtype=np.float32).as_linear_operator()
    assert operator.dtype == np.float32
    assert not np.any(operator @ np.zeros(720, dtype=np.int64))
    with pytest.raises(ValueError, match="finite"):
        operator @ np.full(720, np.nan)
