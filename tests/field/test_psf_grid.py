"""Grids of PSFs over the field: one call, and each PSF in its place."""

from __future__ import annotations

import numpy as np

import lommel as lm

FIELD = lm.FieldMap.from_seidel(
    20e-3, W131=1.5, W222=-0.8, W040=0.4, wavelength=550e-9, f_number=2.8, obscuration=0.2
)
FFT = lm.paper.Fraunhofer(samples=64, edge="grey")


def test_a_grid_is_one_call_and_equals_single_ones():
    grid = FIELD.grid(3, 5, sensor=(18e-3, 30e-3), shape=(9, 11), pixel=2e-6, method=FFT, normalize="strehl")
    assert isinstance(grid.psf, lm.PSF)
    assert grid.values.shape == (3, 5, 9, 11)
    np.testing.assert_allclose(grid.x, [-12e-3, -6e-3, 0.0, 6e-3, 12e-3], atol=1e-18)
    np.testing.assert_allclose(grid.y, [-6e-3, 0.0, 6e-3], atol=1e-18)
    assert grid.x[2] == grid.y[1] == 0.0
    for i, j in [(0, 0), (1, 2), (2, 4), (0, 3)]:
        single = FIELD.psf(grid.x[j], grid.y[i], (9, 11), 2e-6, method=FFT, normalize="strehl")
        # The stack shares the sampling that its widest member needs.
        np.testing.assert_allclose(grid[i, j].values, single.values, atol=1e-6)
        assert np.abs((grid[i, j].pupil.wavefront - single.pupil.wavefront).edge).max() < 1e-13
