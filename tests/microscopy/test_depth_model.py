"""The PSFs of a stack: points between voxels have the image of the light of voxels near them."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import BSpline
from scipy.ndimage import convolve

import lommel as lm
from lommel.microscopy.depth_model import DepthModel
from objectives import OIL_60X

WAVE, PIXEL, STEP = 520e-9, 6e-6, 0.25e-6


@pytest.mark.parametrize("off", [(0.0, 0.0), (0.5, 0.0), (0.0, 0.5), (0.5, 0.5)])
def test_a_point_anywhere_between_voxels_has_the_image_of_voxels_near_it(off):
    model = DepthModel(OIL_60X, WAVE, PIXEL, STEP, 6e-6, 16, (21, 31))
    assert model.splines == (3, 3)
    z, x = off
    planes = (np.arange(21) - 10 - z) * STEP
    pupil = OIL_60X.pupil(depth=6e-6, z=planes, wavelength=WAVE)
    known = lm.psf(pupil, 31, PIXEL, center=(15, 15 + x), tol=1e-4).values
    cubic = BSpline.basis_element(np.arange(-2.0, 3.0), extrapolate=False)
    spread = np.ones(())
    for place in (z, 0.0, x):
        spread = np.multiply.outer(spread, np.nan_to_num(cubic(np.arange(-3.0, 4.0) - place)))
    made = convolve(next(model.kernels(np.array([6e-6]))), spread, mode="constant")
    whole = model.window_part(6e-6)
    between = 0.5 * (whole + np.roll(whole, 1, axis=2))

    def apart(image):
        """Return by how much it differs from the PSF, both as bright, over the peak."""
        inner = np.s_[6:-6, 9:-9, 9:-9]
        share = image[inner] / image[inner].sum() - known[inner] / known[inner].sum()
        return float(np.abs(share).max() / known[inner].max() * known[inner].sum())

    assert apart(made) < 0.03
    if off == (0.0, 0.5):
        assert apart(between) > 0.06  # the mean of both voxels


def test_planes_too_far_apart_for_a_spline_have_none():
    assert DepthModel(OIL_60X, WAVE, PIXEL, 1e-6, 6e-6, 16, (21, 31)).splines == (0, 3)
    assert DepthModel(OIL_60X, WAVE, PIXEL, STEP, 6e-6, 16, (21, 31), degrees=(2, 0)).splines == (2, 0)
