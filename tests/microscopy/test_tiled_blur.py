"""Specimens larger than their recording: convolution by tiles against plain sums, and its transpose."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import convolve

import lommel as lm
from lommel.microscopy import stack_blur
from lommel.microscopy.stack_blur import TiledBlur
from objectives import OIL_60X

# Neither as many planes above the point as below it, nor alike in rows and columns.
PSF = lm.psf(OIL_60X.pupil(depth=5e-6, z=np.arange(-2, 4) * 0.3e-6, wavelength=520e-9), (7, 10), 6e-6, tol=1e-4)
POINT = (2, 3, 5)


def _gathered(pieces, shape):
    """Return the whole of its pieces, and fail where one is missing or there twice."""
    out, times = np.zeros(shape), np.zeros(shape, int)
    for plane, rows, columns, values in pieces:
        out[plane, rows, columns] = values
        times[plane, rows, columns] += 1
    assert (times == 1).all()
    return out


def _parts(values):
    return lambda plane, rows, columns: values[plane, rows, columns]


@pytest.mark.parametrize("small", [2**21, 2000])
@pytest.mark.parametrize(
    ("shape", "margin"), [((5, 30, 20), (3, 5)), ((5, 21, 27), (1, 2)), ((3, 22, 20), (0, 0)), ((1, 25, 20), (9, 9))]
)
def test_tiles_are_the_plain_sum_over_a_specimen_that_goes_on_along_z(monkeypatch, small, shape, margin):
    monkeypatch.setattr(stack_blur, "_SMALL", small)
    blur = TiledBlur(PSF, shape, margin)
    rng = np.random.default_rng(0)
    specimen, recording = (rng.random(size).astype(np.float32) for size in (blur.whole, shape))
    made = _gathered(blur.forward(_parts(specimen)), shape)
    kernel = PSF.values.astype(float) / PSF.values.sum(dtype=float)
    known = convolve(np.pad(specimen.astype(float), ((6, 6), (0, 0), (0, 0)), mode="edge"), kernel, method="direct")
    first = [6 + margin[0] + POINT[0], margin[1] + POINT[1], margin[1] + POINT[2]]
    known = known[tuple(slice(at, at + side) for at, side in zip(first, shape, strict=True))]
    np.testing.assert_allclose(made, known, atol=2e-6)
    back = _gathered(blur.adjoint(_parts(recording)), blur.whole)
    assert np.vdot(made, recording) == pytest.approx(np.vdot(specimen, back), rel=1e-6)


@pytest.mark.parametrize("margin", [(0, 0), (1, 2), (4, 7)])
def test_what_is_seen_of_a_point_is_the_transpose_of_ones(margin):
    shape = (4, 14, 18)
    blur = TiledBlur(PSF, shape, margin)
    known = _gathered(blur.adjoint(_parts(np.ones(shape, np.float32))), blur.whole)
    found = [blur.seen(plane, slice(0, blur.whole[1]), slice(0, blur.whole[2])) for plane in range(blur.whole[0])]
    np.testing.assert_allclose(found, known, atol=2e-6)
    part = blur.seen(0, slice(2, 9), slice(3, 4))
    np.testing.assert_array_equal(part, found[0][2:9, 3:4])


def test_a_small_recording_is_one_tile_and_a_large_one_many():
    assert len(list(TiledBlur(PSF, (5, 40, 40), (2, 4))._cores((5, 40, 40)))) == 1
    large = TiledBlur(PSF, (4, 900, 1000), (2, 4))
    planes, (height, width) = large._depth, large._tile
    assert len(list(large._cores(large.shape))) > 1
    assert 2 * planes * height * width <= 1.6 * 4 * 900 * 1000
