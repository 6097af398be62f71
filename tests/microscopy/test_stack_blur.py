"""Stacks of planes as a linear operator: against sums over all points."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import convolve

import lommel as lm
from objectives import OIL_60X

Z = np.arange(-3, 4) * 0.3e-6
PIXEL = 6e-6


def kernel(z=Z, shape=(7, 9), **given):
    return lm.psf(OIL_60X.pupil(depth=5e-6, z=z, wavelength=520e-9), shape, PIXEL, tol=1e-4, **given)


PSF = kernel()


def test_a_point_is_spread_as_the_psf_is():
    blur = lm.microscopy.StackBlur(PSF, (9, 12, 14), np.float64)
    image = np.zeros((12, 14, 9))
    image[6, 7, 4] = 1.0
    found = blur.forward(image)
    assert found[3:10, 3:12, 1:8] == pytest.approx(np.moveaxis(PSF.values / PSF.values.sum(), 0, 2), rel=1e-6)
    assert found.sum() == pytest.approx(1.0)


def test_what_is_outside_is_dark_and_nothing_wraps_around():
    blur = lm.microscopy.StackBlur(PSF, (4, 5, 6), np.float64)
    specimen = np.random.default_rng(0).random((4, 5, 6))
    known = convolve(specimen, PSF.values.astype(float) / PSF.values.sum(dtype=float), mode="full", method="direct")
    found = blur.forward(np.moveaxis(specimen, 0, 2))
    assert np.moveaxis(found, 2, 0) == pytest.approx(known[3:7, 3:8, 4:10], abs=1e-12)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_the_adjoint_is_the_transpose(dtype):
    blur = lm.microscopy.StackBlur(PSF, (4, 10, 8), dtype)
    a, b = np.random.default_rng(1).random((2, 10, 8, 4)).astype(dtype)
    one, other = (np.vdot(x.astype(float), y) for x, y in ((blur.forward(a), b), (blur.adjoint(b), a)))
    assert one == pytest.approx(other, rel=1e-5 if dtype == np.float32 else 1e-12)
    assert blur.forward(a).dtype == dtype


@pytest.mark.parametrize(
    ("psf", "shape", "said"),
    [
        (PSF[[0, 1, 3]], (4, 5, 5), "even steps of z"),
        (PSF[:3], (4, 5, 5), "psf must have a plane at the brightest focus, the nearest is -3e-07 m off"),
        (kernel(center=(1, 1)), (4, 5, 5), "psf must have its axis in the middle pixel"),
    ],
)
def test_what_spreads_no_stack_is_refused(psf, shape, said):
    with pytest.raises((TypeError, ValueError), match=said):
        lm.microscopy.StackBlur(psf, shape)
