"""What is proven about averages over pixels, each bound on its own, and the tables that rest on them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import j0

from core_tests import _core_tests
from lommel import _core
from lommel.methods.matrix_fourier import gauss_pixel, pixel_error, pixel_nodes
from rendering import rendered

ROUNDOFF = 2.0**-53


def chebyshev(n: int) -> np.ndarray:
    return np.cos(np.pi * (np.arange(n) + 0.5) / n)


def interpolated(values: np.ndarray, at: np.ndarray) -> np.ndarray:
    """Interpolate values at Chebyshev points: cosine transform, then the sum of T_k."""
    n = len(values)
    k = np.arange(n)
    c = 2.0 / n * np.cos(np.outer(k, np.pi * (np.arange(n) + 0.5) / n)) @ values
    c[0] *= 0.5
    return np.cos(np.outer(np.arccos(np.clip(at, -1, 1)), k)) @ c


def bessel_means(x: np.ndarray, y: np.ndarray, kappa: float, side: float) -> np.ndarray:
    """The means of J0(kappa r): it is the mean of plane waves over their direction, and theirs are sincs."""
    count = 2 * int(kappa * (np.hypot(x, y).max() + side)) + 80
    angles = np.pi * (np.arange(count) + 0.5) / count
    a, b = kappa * np.cos(angles), kappa * np.sin(angles)
    size = np.sinc(a * side / (2 * np.pi)) * np.sinc(b * side / (2 * np.pi)) / angles.size
    return np.cos(np.multiply.outer(x, a) + np.multiply.outer(y, b)) @ size


@pytest.mark.parametrize("seed", range(40))
def test_no_wave_of_type_2_is_interpolated_worse_than_the_bound(seed: int) -> None:
    rng = np.random.default_rng(seed)
    half = 10.0 ** rng.uniform(-1, 1.7)
    points = int(2 * half * rng.uniform(1.0, 1.4) + rng.integers(2, 14))
    at, nodes = np.linspace(-1, 1, 701), chebyshev(points)
    bound = _core_tests.interpolation_error(half, points)
    worst = 0.0
    for phase in np.linspace(0, np.pi, 8, endpoint=False):
        found = interpolated(np.cos(2 * half * nodes + phase), at)
        worst = max(worst, float(np.abs(found - np.cos(2 * half * at + phase)).max()))
    assert worst <= bound + 1e-12
    # The largest frequency there is comes near: a bound a thousand times too small would be seen.
    assert bound < 1e-10 or bound >= 1.0 or worst > 1e-3 * bound


@pytest.mark.parametrize("side", [0.2, 1.0, 3.14, 10.7, 31.0])
def test_no_wave_of_type_2_is_averaged_worse_than_the_bound(side: float) -> None:
    for points in range(1, math.ceil(0.8 * side) + 6):
        bound = _core.gauss_error(side, points)
        assert pixel_error(side, points) == pytest.approx(0.25 * bound, rel=1e-12)
        x, w = np.polynomial.legendre.leggauss(points)
        worst = 0.0
        for angle in np.linspace(0, np.pi / 4, 7):
            a, b = side * np.cos(angle), side * np.sin(angle)
            rule = (0.5 * w @ np.cos(a * x)) * (0.5 * w @ np.cos(b * x))
            worst = max(worst, abs(float(rule - np.sinc(a / np.pi) * np.sinc(b / np.pi))))
        assert worst <= bound + 1e-14
        assert bound < 1e-12 or bound >= 1e-2 or worst > 1e-3 * bound
    offsets, weights = gauss_pixel(side, 1e-9)
    assert weights @ np.cos(2 * offsets) == pytest.approx(np.sinc(side / np.pi), abs=2e-9)
    assert pixel_error(side, pixel_nodes(side, 1e-9)) <= 1e-9


@pytest.mark.parametrize("side", [0.05, 0.8, 1.57, 3.14, 10.7])
def test_no_average_is_resolved_by_harmonics_worse_than_the_bound(side: float) -> None:
    theta = np.linspace(0, np.pi / 4, 64)
    for angles in range(1, math.ceil(0.36 * side) + 8):
        bound = _core_tests.harmonics_error(side, angles)
        if bound > 1e100:  # too few to say anything
            continue
        nodes = np.arccos(chebyshev(angles)) / 4
        worst = 0.0
        for radius in np.linspace(0.0, 4 * side + 6, 25):
            at_nodes = bessel_means(radius * np.cos(nodes), radius * np.sin(nodes), 2.0, side)
            exactly = bessel_means(radius * np.cos(theta), radius * np.sin(theta), 2.0, side)
            worst = max(worst, float(np.abs(interpolated(at_nodes, np.cos(4 * theta)) - exactly).max()))
        # J0 is between -0.41 and 1: within 0.71 of a constant.
        assert worst <= 0.71 * bound + 1e-13
        assert bound < 1e-11 or bound >= 1e-2 or worst > 1e-6 * bound


def window_error(place, shape, kappa: float, level: int, threads: int = 1) -> tuple[float, float, int]:
    """Return the worst error of a window of J0(kappa v), what is proven, and the number of radii."""
    row, column, step, integrate = place
    args = (row, column, step, integrate, level, threads)
    v, error, of_nodes, of_grid, rounding = _core.pixel_radii(*shape, *args)
    assert np.all(np.diff(v) >= 0)
    out = np.empty((1, *shape))
    penalties = _core.pixel_values(j0(kappa * v)[None], *args, out)
    # Of large windows some rows are judged.
    rows = np.unique(np.linspace(0, shape[0] - 1, 12).astype(int))
    y, x = step * (rows - row), step * (np.arange(shape[1]) - column)
    if integrate:
        exact = bessel_means(np.tile(x, y.size), np.repeat(y, x.size), kappa, step).reshape(y.size, x.size)
    else:
        exact = j0(kappa * np.hypot(y[:, None], x))
    places = v[-1] * (3 * of_grid * of_nodes + 6 * of_grid + 4)
    bound = 0.71 * error + ROUNDOFF * (rounding + penalties[0] + places)
    # scipy's own J0 is off by some units, more where its argument is large.
    return float(np.abs(out[0, rows] - exact).max()), bound + 4e-15 * of_grid * of_nodes, v.size


@pytest.mark.parametrize("seed", range(60))
def test_windows_of_a_bessel_function_are_within_what_is_proven(seed: int) -> None:
    """Every kind of table: one ring, rings with and without harmonics, the pixels themselves; axes anywhere."""
    rng = np.random.default_rng(seed)
    step = 10.0 ** rng.uniform(-1.2, 1.0)
    side = int(min(90, 250 / step) if seed % 2 else 12)
    shape = tuple(int(n) for n in rng.integers(1, side + 1, 2))
    row, column = [(n // 2) for n in shape]
    if seed % 3 == 1:
        row, column = rng.uniform(-0.5, 1.5, 2) * side
    elif seed % 3 == 2:
        row, column = 0.5 * (shape[0] - 1), float(rng.uniform(-200, 200) / step)
    level = int(rng.integers(3, 14))
    worst, bound, _ = window_error((float(row), float(column), step, bool(seed % 5)), shape, 2.0 - 1e-9, level)
    assert worst <= bound
    assert bound <= 10.0**-level + 3e-10


@pytest.mark.parametrize(("integrate", "step", "shape"), [(True, 0.8, 257), (True, 3.1, 130), (False, 0.8, 200)])
def test_large_windows_take_few_radii_and_any_number_of_threads(integrate: bool, step: float, shape: int) -> None:
    row = shape // 2 + (0.0 if integrate else 0.3)
    for threads in (1, 3):
        place = (row, float(shape // 2), step, integrate)
        worst, bound, radii = window_error(place, (shape, shape), 2.0 - 1e-9, 9, threads)
        assert worst <= bound <= 1.1e-9
    assert radii < (0.5 if integrate else 0.2) * shape**2


def test_the_largest_value_is_one_in_the_window() -> None:
    # Rings are padded; what pads them must not outshine the pixels.
    for step, row in ((0.4, 40.0), (3.0, -7.5)):
        place = {"center": (row, row), "integrate": True}
        made = rendered(np.zeros((1, 2)), 0.0, [0.0], (3, 2), step, 1e-3, divided=True, **place)
        assert made.unmet == 0
        assert made.images.max() == pytest.approx(1.0, abs=1e-15)
