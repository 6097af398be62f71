"""Blur as an operator that solvers take."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.sparse.linalg import lsqr

from lommel import Lens
from lommel.imaging import DepthBlur, LinearBlur, Occlusion

LENS = Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
DEPTH = np.full((24, 30), 2.6)
DEPTH[:, 12:] = 1.9


def _blur(channels: int = 1, dtype: type = np.float64, **options: str) -> DepthBlur:
    colours = [450e-9 + 100e-9 * place for place in range(channels)]
    return DepthBlur(DEPTH, LENS, 8e-6, channels=colours, dtype=dtype, **options)


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
    operator = DepthBlur(np.full((24, 30), 2.05), LENS, 16e-6, dtype=np.float64).as_linear_operator()
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
