"""Windows so large that samples are interpolated, though the axis is in the middle of a pixel or between two."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm

PUPIL = lm.Pupil(lm.Wavefront(10.0, 3.0), obscuration=0.3)


def _part(center, row, column, tol):
    """Return some pixels of a window by a window of their own, to a hundredth of the tolerance."""
    axis = center[0] - row, center[1] - column
    return lm.psf(PUPIL, 24, 0.3, center=axis, tol=tol / 100, normalize="strehl").values


@pytest.mark.parametrize(
    ("shape", "center"),
    [((3000, 2990), (1500.0, 1495.0)), ((1600, 3300), (12.0, 1649.5)), ((2950, 2951), (1474.5, 1475.5))],
)
@pytest.mark.parametrize("tol", [1e-6, 1e-9])
def test_pixels_are_those_of_small_windows(shape, center, tol):
    whole = lm.psf(PUPIL, shape, 0.3, center=center, tol=tol, normalize="strehl", threads=2)
    assert whole.error_bound <= tol
    height, width = shape
    top = whole.values.max()
    for row in (0, max(0, int(center[0]) - 13), height // 3, height - 24):
        for column in (0, int(center[1]) - 11, 2 * width // 3, width - 24):
            exact = _part(center, row, column, tol)
            found = whole.values[row : row + 24, column : column + 24]
            assert np.abs(found - exact).max() <= 1.02 * tol * top


def test_threads_change_no_bit():
    one, two = (lm.psf(PUPIL, (2950, 2950), 0.4, threads=threads).values for threads in (1, 2))
    np.testing.assert_array_equal(one, two)
