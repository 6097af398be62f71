"""Kernels that reach beyond the image: against sums over mirrored images, one by one."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.imaging.bank import MirroredKernels, Remainder, build_bank
from lommel.imaging.sensor_light import SensorLight


@pytest.fixture(scope="module")
def remainder() -> Remainder:
    """That of a small lens over some radians."""
    pupil = lm.Pupil(wavelength=540e-9, f_number=8.0)
    given = {"tol": 1e-4, "energy": 1.0, "largest": 60}
    made = build_bank(SensorLight(pupil, lm.Wavefront, ((540e-9, 1.0),), 6e-6), (-4.0, 1.0), **given).remainder
    assert made is not None
    return made


@pytest.mark.parametrize("shape", [(6, 9), (7, 7), (1, 5), (1, 1), (13, 2)])
def test_a_kernel_acts_on_an_image_between_mirrors_that_are_mirrored_without_end(remainder, shape):
    kernels = MirroredKernels(remainder, shape, "reflect", np.dtype(np.float64), 1e-4)
    assert kernels.error == 0.0
    image = np.random.default_rng(0).random(shape)
    half = 160
    away = np.abs(np.arange(-half, half + 1))
    endless = np.pad(image, half, mode="symmetric")
    for r, quarter in enumerate(remainder.values(half)):
        kernel = quarter[away[:, None], away]
        made = kernels.image(kernels.transformed(r, image.copy()))
        # So far away the mirrored image is as bright as it is in the mean.
        rest = (kernels.eigenvalues[r, 0, 0] - kernel.sum()) * image.mean()
        wanted = np.array(
            [
                [(endless[y : y + 2 * half + 1, x : x + 2 * half + 1] * kernel).sum() + rest for x in range(shape[1])]
                for y in range(shape[0])
            ]
        )
        assert np.abs(made - wanted).max() <= 1e-4 * np.abs(wanted).max()


@pytest.mark.parametrize("border", ["reflect", "extend", "zero"])
def test_what_is_taken_is_the_transpose_of_what_is_spread(remainder, border):
    rng = np.random.default_rng(1)
    kernels = MirroredKernels(remainder, (6, 9), border, np.dtype(np.float64), 1e-4)
    a, b = rng.standard_normal((2, 6, 9))
    for r in range(len(remainder.table)):
        spread = kernels.image(kernels.transformed(r, a.copy()))
        taken = kernels.taken(r, kernels.known(b))
        assert np.vdot(spread, b) == pytest.approx(np.vdot(a, taken), rel=1e-12)


def test_darkness_is_as_wide_as_the_tolerance_asks_for(remainder):
    sides = {}
    for tol in (1e-3, 1e-5):
        kernels = MirroredKernels(remainder, (40, 50), "zero", np.dtype(np.float32), tol)
        assert 0.05 * tol < kernels.error <= 0.5 * tol
        sides[tol] = kernels.eigenvalues.shape
    assert sides[1e-5][1] > 2 * sides[1e-3][1] > 200
    assert sides[1e-3][0] == len(remainder.table)
