"""Blur that varies with depth, against the brute-force sum of exact windows."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.imaging import DepthBlur
from point_sums import sum_over_points

LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
PIXEL = 8e-6


def scene(height: int = 20, width: int = 26, seed: int = 0) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    return rng.random((height, width)), 1.8 + 0.5 * rng.random((height, width))


def test_every_point_spreads_the_psf_of_its_own_depth():
    image, depth = scene()
    blur = DepthBlur(depth, LENS, PIXEL, dtype=np.float64, tol=1e-6, energy=0.95, largest=30)
    half = blur.banks[0].half
    exact = lm.psf(LENS.pupil(depth), 2 * half + 1, PIXEL, integrate=True, dtype=np.float64).values

    def window(row: int, column: int) -> np.ndarray:
        used = blur.banks[0].pixel_weights(LENS.defocus(depth[row, column])) * exact[row, column]
        return used / used.sum()

    out = blur.forward(image)
    assert np.abs(out - sum_over_points(image, window, 2 * half + 1)).max() <= 1e-5 * out.max()


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_the_adjoint_is_the_transpose(dtype):
    rng = np.random.default_rng(1)
    _, depth = scene()
    blur = DepthBlur(depth, LENS, PIXEL, dtype=dtype, energy=0.95, channels=(600e-9, 500e-9))
    a, b = (rng.random((20, 26, 2)).astype(dtype) for _ in range(2))
    one, two = np.vdot(blur.forward(a), b), np.vdot(a, blur.adjoint(b))
    assert one == pytest.approx(two, rel=1e-12 if dtype == np.float64 else 1e-5)


def test_the_light_of_one_plane_is_conserved_and_a_white_wall_stays_white():
    blur = DepthBlur(np.full((60, 70), 1.9), LENS, PIXEL, dtype=np.float64)
    assert np.abs(blur.forward(np.ones((60, 70))) - 1.0).max() < 1e-12
    point = np.zeros((60, 70))
    point[30, 35] = 1.0
    assert blur.forward(point).sum() == pytest.approx(1.0, abs=1e-12)
    assert 0.0 < blur.lost <= 0.02


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_threads_do_not_change_a_bit(threads):
    image, depth = scene(100, 90)
    blur = DepthBlur(depth, LENS, PIXEL, threads=1)
    first = blur.forward(image.astype(np.float32))
    blur.threads = threads
    assert blur.forward(image.astype(np.float32)).tobytes() == first.tobytes()
