"""Masks sampled with several points in each cell."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm


def test_cells_are_means_of_their_points():
    mask = lm.Mask.sample(lambda x, y: 0.5 + 0.3 * x + 0.1 * y * y, side=6, oversample=4)
    fine = lm.Mask.sample(lambda x, y: 0.5 + 0.3 * x + 0.1 * y * y, side=24)
    np.testing.assert_allclose(mask.values, fine.values.reshape(6, 4, 6, 4).mean(axis=(1, 3)))
    assert lm.Mask.sample(lambda x, y: np.exp(1j * x), side=6, oversample=2).values.dtype.kind == "c"
    assert lm.Mask.sample(lambda x, y: x > y, side=4, oversample=1) == lm.Mask.sample(lambda x, y: x > y, side=4)


def test_many_points_are_taken_in_bands(monkeypatch):
    whole = lm.Mask.sample(lambda x, y: np.hypot(x, y) < 0.7, side=32, oversample=8)
    monkeypatch.setattr(lm.optics.aperture.mask, "_BAND", 5000)
    assert lm.Mask.sample(lambda x, y: np.hypot(x, y) < 0.7, side=32, oversample=8) == whole


@pytest.mark.parametrize(("angle", "most"), [(0.2, 1e-5), (0.0, 2e-4)])
def test_partly_clear_cells_bring_a_hexagon_of_pixels_closer(angle, most):
    shape = lm.Polygon.regular(6, radius=0.9, angle=angle)
    exact = lm.psf(lm.Pupil(stop=shape), 33, 0.25, normalize="strehl")

    def error(oversample: int) -> float:
        mask = lm.Mask.sample(lambda x, y: shape.margin(x, y) >= 0.0, side=512, oversample=oversample)
        return lm.peak_error(lm.psf(lm.Pupil(mask=mask), 33, 0.25, normalize="strehl"), exact)

    assert error(8) < most
    assert error(8) < 0.2 * error(1)


@pytest.mark.parametrize("times", [0, 65])
def test_a_number_of_points_out_of_range_is_refused(times):
    with pytest.raises(ValueError, match=f"oversample must be from 1 to 64, got {times}"):
        lm.Mask.sample(lambda x, y: x > y, side=4, oversample=times)
