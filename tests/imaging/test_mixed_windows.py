"""Windows mixed for each point, against sums over points."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.imaging.spline_nodes import Nodes
from lommel.imaging.window_blur import WindowBlur
from point_sums import sum_over_points

HEIGHT, WIDTH = 37, 29


def made(
    counts: tuple[int, int, int], side: int = 5, degree: int = 5, **given: object
) -> tuple[WindowBlur, np.ndarray]:
    """Return a blur with a bank of random windows, and the exact window of each point."""
    axes = tuple(Nodes(0.0, float(count > 1), count, degree) for count in counts)
    rng = np.random.default_rng(0)
    bank = rng.random((*counts, side, side))
    bank /= bank.sum(axis=(3, 4), keepdims=True)
    y, x = np.linspace(0.0, 0.9, HEIGHT), np.linspace(0.1, 1.0, WIDTH)
    defocus = rng.uniform(0.0, 1.0, (HEIGHT, WIDTH)) * (counts[2] > 1)
    more = {"threads": 2, "allowed": 1e-2, "dtype": np.float64} | given
    blur = WindowBlur(bank.astype(more.pop("dtype")), axes, y, x, defocus, **more)
    down, across = axes[0].weights(y), axes[1].weights(x)
    focus = axes[2].weights(defocus.ravel()).reshape(HEIGHT, WIDTH, -1)
    return blur, np.einsum("ya,xb,yxc,abcuv->yxuv", down, across, focus, bank, optimize=True)


def by_points(windows: np.ndarray, light: np.ndarray) -> np.ndarray:
    return sum_over_points(light, lambda row, column: windows[row, column], windows.shape[-1])


@pytest.mark.parametrize("deep", [1, 2, 3, 4, 5, 6, 9])
@pytest.mark.parametrize("side", [1, 5, 19])
def test_where_splines_are_parabolas_images_are_sums_over_points(deep, side):
    blur, windows = made((4, 3, deep), side)
    assert blur.error < 1e-14
    light, image = np.random.default_rng(1).standard_normal((2, HEIGHT, WIDTH))
    light[3:7, 5:9] = 0.0
    out = blur.forward(light)
    assert np.abs(out - by_points(windows, light)).max() < 1e-13
    assert np.vdot(out, image) == pytest.approx(np.vdot(light, blur.adjoint(image)), rel=1e-11)


@pytest.mark.parametrize("degree", [3, 5])
@pytest.mark.parametrize("allowed", [0.3, 0.02])
def test_parabolas_err_by_no_more_than_is_said(degree, allowed):
    blur, windows = made((3, 9, 4), degree=degree, allowed=allowed)
    assert blur.error <= allowed
    apart = 0.0
    for row, column in np.random.default_rng(2).integers(2, (HEIGHT - 2, WIDTH - 2), (60, 2)):
        star = np.zeros((HEIGHT, WIDTH))
        star[row, column] = 1.0
        apart = max(apart, np.abs(blur.forward(star) - by_points(windows, star)).sum())
    assert 0.02 * blur.error < apart <= blur.error


def test_windows_that_change_too_fast_are_refused():
    with pytest.raises(ArithmeticError, match="not close enough"):
        made((3, 20, 1), allowed=1e-9)


def test_threads_do_not_change_a_bit_and_types_are_kept():
    light = np.random.default_rng(1).random((HEIGHT, WIDTH)).astype(np.float32)
    one, other = (made((4, 3, 6), 19, threads=threads, dtype=np.float32) for threads in (1, 5))
    first, second = one[0].forward(light), other[0].forward(light)
    assert first.dtype == np.float32
    assert first.tobytes() == second.tobytes()
    assert one[0].adjoint(light).tobytes() == other[0].adjoint(light).tobytes()
    assert np.abs(first - by_points(one[1], light)).max() < 2e-6
