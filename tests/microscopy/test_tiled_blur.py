"""Specimens larger than their recording: convolution by tiles against plain sums, and its transpose."""

from __future__ import annotations

import weakref

import numpy as np
import pytest
from scipy.signal import convolve

import lommel as lm
from lommel.microscopy import stack_blur
from lommel.microscopy.stack_blur import TiledBlur, kernel_of
from objectives import OIL_60X

# Neither as many planes above the point as below it, nor alike in rows and columns.
PSF = lm.psf(OIL_60X.pupil(depth=5e-6, z=np.arange(-2, 4) * 0.3e-6, wavelength=520e-9), (7, 10), 6e-6, tol=1e-4)
# Alike in rows and columns about its middle pixel.
EVEN = lm.psf(OIL_60X.pupil(depth=5e-6, z=np.arange(-2, 4) * 0.3e-6, wavelength=520e-9), (7, 9), 6e-6, tol=1e-4)


def _gathered(operator, values, shape):
    """Return the whole of its pieces, and fail where one is missing or there twice."""
    out, times = np.zeros(shape), np.zeros(shape, int)

    def take(plane, rows, columns, found):
        out[plane, rows, columns] = found
        times[plane, rows, columns] += 1

    operator(values, take)
    assert (times == 1).all()
    return out


@pytest.mark.parametrize("psf", [PSF, EVEN], ids=["uneven", "even"])
@pytest.mark.parametrize("small", [2**23, 2000])
@pytest.mark.parametrize(
    ("shape", "margin"), [((5, 30, 20), (3, 5)), ((5, 21, 27), (1, 2)), ((3, 22, 20), (0, 0)), ((1, 25, 20), (9, 9))]
)
def test_tiles_are_the_plain_sum_over_a_specimen_that_goes_on_along_z(monkeypatch, psf, small, shape, margin):
    monkeypatch.setattr(stack_blur, "_MIN_VALUES", small)
    blur = TiledBlur([kernel_of(psf)], shape, margin)
    rng = np.random.default_rng(0)
    specimen, recording = (rng.random(size).astype(np.float32) for size in (blur.whole, shape))
    made = _gathered(blur.forward, specimen, shape)
    kernel, point = psf.values.astype(float) / psf.values.sum(dtype=float), [2, *(n // 2 for n in psf.shape[1:])]
    known = convolve(np.pad(specimen.astype(float), ((6, 6), (0, 0), (0, 0)), mode="edge"), kernel, method="direct")
    first = [6 + margin[0] + point[0], margin[1] + point[1], margin[1] + point[2]]
    known = known[tuple(slice(at, at + side) for at, side in zip(first, shape, strict=True))]
    np.testing.assert_allclose(made, known, atol=2e-6)
    back = _gathered(blur.adjoint, recording, blur.whole)
    assert np.vdot(made, recording) == pytest.approx(np.vdot(specimen, back), rel=1e-6)


@pytest.mark.parametrize("margin", [(0, 0), (1, 2), (4, 7)])
def test_what_is_seen_of_a_point_is_the_transpose_of_ones(margin):
    shape = (4, 14, 18)
    blur = TiledBlur([kernel_of(PSF)], shape, margin)
    known = _gathered(blur.adjoint, np.ones(shape, np.float32), blur.whole)
    found = [blur.seen(plane, slice(0, blur.whole[1]), slice(0, blur.whole[2])) for plane in range(blur.whole[0])]
    np.testing.assert_allclose(found, known, atol=2e-6)
    part = blur.seen(0, slice(2, 9), slice(3, 4))
    np.testing.assert_array_equal(part, found[0][2:9, 3:4])


def test_several_psfs_are_the_sum_of_weighted_specimens_and_its_transpose():
    others = [
        lm.psf(OIL_60X.pupil(depth=d, z=np.arange(-2, 4) * 0.3e-6, wavelength=520e-9), (7, 9), 6e-6, tol=1e-4)
        for d in (3e-6, 8e-6, 20e-6)
    ]
    shape, margin = (5, 20, 17), (2, 3)
    rng = np.random.default_rng(4)
    weights = rng.dirichlet(np.ones(3), shape[0] + 2 * margin[0]).T.astype(np.float32)
    blur = TiledBlur(map(kernel_of, others), shape, margin, weights=weights)
    specimen, recording = (rng.random(size).astype(np.float32) for size in (blur.whole, shape))
    made = _gathered(blur.forward, specimen, shape)
    known = sum(
        _gathered(TiledBlur([kernel_of(psf)], shape, margin).forward, specimen * w[:, None, None], shape)
        for psf, w in zip(others, weights, strict=True)
    )
    np.testing.assert_allclose(made, known, atol=2e-6)
    back = _gathered(blur.adjoint, recording, blur.whole)
    assert np.vdot(made, recording) == pytest.approx(np.vdot(specimen, back), rel=1e-6)
    ones = _gathered(blur.adjoint, np.ones(shape, np.float32), blur.whole)
    found = [blur.seen(plane, slice(0, blur.whole[1]), slice(0, blur.whole[2])) for plane in range(blur.whole[0])]
    np.testing.assert_allclose(found, ones, atol=2e-6)


@pytest.mark.parametrize("psf", [PSF, EVEN], ids=["uneven", "even"])
def test_threads_change_no_bit(psf):
    shape, rng = (5, 33, 30), np.random.default_rng(1)
    one, four = (TiledBlur([kernel_of(psf)], shape, (2, 4), threads=n) for n in (1, 4))
    specimen = rng.random(one.whole).astype(np.float32)
    np.testing.assert_array_equal(*(_gathered(blur.forward, specimen, shape) for blur in (one, four)))


def test_tails_are_in_memory_one_after_the_other():
    alive = []

    def tails(count=6):
        for _ in range(count):
            tail = np.full((3, 5, 5), 1e-3)
            alive.append(weakref.ref(tail))
            assert sum(each() is not None for each in alive) <= 3  # the first one, whose shape is needed, and two
            yield tail

    weights = np.full((6, 4), 1.0 / 6.0)
    windows = TiledBlur([np.full((3, 3, 3), 1e-2)], (2, 6, 6), (1, 2))
    stack_blur.WideBlur(windows, tails(), 3, weights=weights)
    assert len(alive) == 6
