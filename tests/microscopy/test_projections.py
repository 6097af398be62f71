"""Projections of restored stacks, and their picture."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from objectives import OIL_60X

CAMERA = lm.Noise(white=0.5, read=1.5, offset=100.0)
GIVEN = {"pixel": 6e-6, "step": 0.3e-6, "wavelength": 520e-9, "depth": 8e-6, "noise": CAMERA, "psf_shape": (9, 15)}


@pytest.fixture(scope="module")
def stack():
    light = np.full((10, 28, 36), 20.0)
    light[3, 7:10, 9:12] = light[7, 19:22, 29:32] = 900.0
    return CAMERA.record(light, seed=1)


def restored(stack, **more):
    way = lm.imaging.RichardsonLucy(steps=3, target=0.0)
    return lm.microscopy.restore(
        stack, OIL_60X, method=way, **(GIVEN | {"direction": "up", "diagnosis": False} | more)
    )


@pytest.mark.parametrize("more", [{}, {"direction": "down"}, {"tile": 18}], ids=str)
def test_projections_are_the_maxima_of_recording_and_result(stack, more):
    found = restored(stack, **more)
    recorded, after, _ = found.channels[0].projections
    light = np.maximum(stack - 100.0, 0.0)
    for axis, before, later in zip((0, 1), recorded, after, strict=True):
        np.testing.assert_allclose(before, light.max(axis=axis), atol=0.01)
        np.testing.assert_array_equal(later, np.asarray(found).max(axis=axis))


def test_residuals_have_unit_variance_where_the_model_is_right_and_unknown_voxels_have_none():
    flat = CAMERA.record(np.full((12, 48, 48), 50.0), seed=2)
    flat[:, 5, :7] = np.nan
    found = restored(flat)
    for residual in found.channels[0].projections.residual:
        assert np.nanstd(residual) == pytest.approx(1.0, abs=0.12)
    assert np.isnan(found.channels[0].projections.residual[0][5, :7]).all()
    assert np.isfinite(found.channels[0].projections.residual[0][6]).all()
    np.testing.assert_array_equal(*(np.isnan(found.channels[0].projections[k][0]) for k in (0, 2)))


def test_a_wrong_psf_leaves_a_pattern_in_the_residual(stack):
    (xy, xz) = restored(stack).channels[0].projections.residual  # light in one plane is no image of a point
    assert np.abs(xy[6:11, 8:13]).max() > 10.0
    assert np.abs(xz[3, 8:13]).max() > 10.0
