"""Averages by rings, and large windows."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import j0

import lommel as lm

QUESTIONS = [
    (33, (16.3, 15.8), 0.5, 1e-6),
    (33, (15.9, 16.4), 2.24, 1e-6),
    ((40, 25), (3.2, 24.0), 3.9, 1e-4),
    ((90, 160), (88.7, 0.25), 1.1, 1e-6),
    ((120, 30), (60.5, 29.1), 3.3, 1e-9),
    (21, (9.8, 10.4), 1.7, 1e-11),
]


def exact(pupil: lm.Pupil, v: np.ndarray) -> np.ndarray:
    """Return I over the peak without aberration, by Gauss's rule across the pupil."""
    x, w = np.polynomial.legendre.leggauss(600)
    t = 0.5 * ((1 - pupil.obscuration**2) * x + 1 + pupil.obscuration**2)
    phase = 2 * pupil.wavefront.defocus * t + pupil.wavefront.spherical * t**2
    return np.abs(j0(np.outer(v, np.sqrt(t))) @ (0.5 * w * np.exp(1j * phase))) ** 2


@pytest.mark.parametrize(("shape", "center", "pixel", "tol"), QUESTIONS)
@pytest.mark.parametrize("obscuration", [0.0, 0.45])
def test_pixels_are_averages(shape, center, pixel, tol, obscuration):
    pupil = lm.Pupil(lm.Wavefront(6.0, -4.0), obscuration=obscuration)
    found = lm.psf(pupil, shape, pixel, center=center, integrate=True, tol=tol, normalize="strehl")
    assert isinstance(found.method, lm.methods.NijboerZernike)
    assert found.error_bound <= tol
    height, width = found.values.shape
    rng = np.random.default_rng(3)
    rows = np.append(rng.integers(height, size=12), [0, height - 1, round(center[0])])
    columns = np.append(rng.integers(width, size=12), [0, width - 1, round(center[1])])
    x, w = np.polynomial.legendre.leggauss(12 + math.ceil(4 * pixel))
    down, across = (
        (rows - center[0])[:, None, None] + 0.5 * x[:, None],
        (columns - center[1])[:, None, None] + 0.5 * x,
    )
    values = exact(pupil, np.pi * pixel * np.hypot(down, across).ravel()).reshape(len(rows), len(x), len(x))
    averages = np.einsum("pyx,y,x->p", values, 0.5 * w, 0.5 * w)
    # A window may miss the peak, to which the bound is related: not these.
    assert np.abs(found.values[rows, columns] - averages).max() <= found.error_bound * found.values.max() * (1 + 1e-6)


def test_pupils_with_axes_of_their_own_are_those_alone():
    pupils = lm.Pupil(lm.Wavefront(np.linspace(0.0, 12.0, 5), 1.0))
    rows, columns = np.array([16.2, 15.7, 16.0, 17.1, 14.4]), np.array([16.0, 15.1, 16.5, 16.2, 17.3])
    together = lm.psf(pupils, 33, 2.5, center=(rows, columns), integrate=True, normalize="strehl")
    for k, one in enumerate(together.values):
        alone = lm.psf(pupils[k], 33, 2.5, center=(rows[k], columns[k]), integrate=True, normalize="strehl", tol=1e-9)
        assert np.abs(one - alone.values).max() <= 1.01e-6 * alone.values.max()


def test_threads_change_no_bit():
    pupil = lm.Pupil(lm.Wavefront(6.0, -4.0))
    one, two = (
        lm.psf(pupil, 190, 1.3, center=(95.2, 94.4), integrate=True, threads=threads).values for threads in (1, 2)
    )
    np.testing.assert_array_equal(one, two)


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


def test_threads_change_no_bit_of_large_windows():
    one, two = (lm.psf(PUPIL, (2950, 2950), 0.4, threads=threads).values for threads in (1, 2))
    np.testing.assert_array_equal(one, two)
