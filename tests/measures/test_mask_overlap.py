"""Transfer functions and centroids of pupils with a mask, against sums over cells and over the image."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel.measures import overlap as autocorrelation
from lommel.optics.aperture.mask import cell_centers

SIDE = 24


def screen(*, squares: bool = False, side: int = SIDE) -> lm.Mask:
    """Return a mask of random phases and amplitudes."""
    rng = np.random.default_rng(5)
    values = rng.uniform(0.3, 1.0, (side, side)) * np.exp(1j * rng.uniform(-1.5, 1.5, (side, side)))
    return lm.Mask(values, squares=squares)


def field(pupil: lm.Pupil, wavefront: lm.Wavefront) -> np.ndarray:
    """Return the pupil function of each cell of an annulus, its clear part from 200 x 200 points."""
    at = cell_centers(SIDE)
    fine = cell_centers(SIDE * 200)
    rho = np.hypot(fine, fine[:, None])
    clear = ((rho <= 1.0) & (rho >= pupil.obscuration)).reshape(SIDE, 200, SIDE, 200).mean(axis=(1, 3))
    phase = wavefront.phase(np.hypot(at, at[:, None]), np.arctan2(at[:, None], np.broadcast_to(at, (SIDE, SIDE))))
    return clear * pupil.mask.values * np.exp(1j * phase.reshape(SIDE, SIDE))


def overlap(cells: np.ndarray, x: int, y: int) -> complex:
    """Return the autocorrelation of an array at a shift, by a sum."""
    total = 0j
    for i in range(len(cells)):
        for j in range(len(cells)):
            if 0 <= i + y < len(cells) and 0 <= j + x < len(cells):
                total += cells[i, j] * np.conj(cells[i + y, j + x])
    return total / np.sum(np.abs(cells) ** 2)


@pytest.mark.parametrize("squares", [False, True])
def test_cells_of_a_mask_overlap_at_every_shift(squares, monkeypatch):
    wavefront = lm.Wavefront(1.0, nonradial={(3, 1): 0.7})
    pupil = lm.Pupil(wavefront, mask=screen(squares=squares), obscuration=0.3)
    cells = field(pupil, wavefront)
    # Thirds of a cell are whole shifts of cells a third as wide.
    finer = np.repeat(np.repeat(cells, 3, axis=0), 3, axis=1)
    shifts = [(1, 0), (0, -2), (7, 5), (-16, 3), (45, 2), (71, 0), (80, 0)]
    exact = np.array([overlap(finer, *shift) for shift in shifts])
    fx, fy = np.transpose(shifts) / (3.0 * SIDE)
    found = lm.otf(pupil, fx, fy)
    # Parts of cells are those of points.
    np.testing.assert_allclose(found, exact, atol=2e-5)
    np.testing.assert_array_equal(lm.otf(lm.psf(pupil, 9, 0.25, dtype="float64"), fx, fy), found)
    assert lm.otf(pupil, 0.0) == pytest.approx(1.0, abs=1e-14)
    autocorrelation.cells.cache_clear()
    monkeypatch.setattr(autocorrelation, "_MAX_TABLE", 1)
    np.testing.assert_allclose(lm.otf(pupil, fx, fy), found, rtol=0.0, atol=1e-14)
    autocorrelation.cells.cache_clear()


def test_at_whole_cells_it_is_the_transform_of_one_period_of_the_image():
    pupil = lm.Pupil(lm.Wavefront(0.5), mask=screen())
    # Below twice the cutoff a period of 96 samples is summed without error.
    image = lm.psf(pupil, 4 * SIDE, 0.25, dtype="float64", tol=1e-9, normalize="energy")
    shift = np.array([[1, 0], [2, 3], [-4, 9], [0, 20]]) / SIDE
    sums = lm.measures.transfer.sampled_otf(image, *shift.T)
    np.testing.assert_allclose(image.otf(*shift.T), sums, atol=1e-7)


def test_stacks_wavelengths_pixels_and_curves_of_a_mask():
    mask = lm.Mask.sample(lambda x, y: 1.0 - 0.5 * x**2, side=32)
    stack = lm.Pupil(lm.Wavefront([[0.0], [2.0]]), mask=mask, wavelength=500e-9, f_number=8.0)
    f = 0.1 * stack.cutoff
    found = lm.mtf(stack, f, pixel=2e-6)
    assert found.shape == (2, 1)
    assert found[1, 0] == pytest.approx(lm.mtf(stack[1, 0], f) * np.sinc(f * 2e-6), rel=1e-12)
    several = lm.Polychromatic([500e-9, 600e-9], [1.0, 1.0])
    parts = [lm.mtf(stack[0, 0].in_light(w), f) for w in (500e-9, 600e-9)]
    both = lm.otf(stack[0, 0], f, spectrum=several)
    shares = np.array([part.share for part in several.components(stack[0, 0])])
    assert both.real == pytest.approx(shares @ parts, rel=1e-12)
    for thing in (stack[1, 0], lm.psf(stack[1, 0], 9, 1e-6)):
        at = lm.mtf_frequency(thing)
        assert lm.mtf(thing, at) == pytest.approx(0.5, abs=1e-7)


def test_the_centroid_of_a_phase_mask_is_that_of_its_image():
    screened = lm.Pupil(lm.Wavefront(nonradial={(1, 1): 0.7}), mask=screen())
    image = lm.psf(screened, (2 * SIDE, 512 * SIDE), (0.5, 1.0 / 512), dtype="float64", tol=1e-9)
    # A sum over x, which is not periodic, by the trapezoidal rule; over y without error.
    light, x = image.values.sum(axis=0), image.grid.x
    ends = np.append(light, light[0]), np.append(x, x[0] + SIDE)
    exact = np.trapezoid(ends[0] * ends[1], ends[1]) / np.trapezoid(*ends)
    assert image.centroid[0] == pytest.approx(exact, abs=1e-5)
    squares = lm.Pupil(mask=screen(squares=True))
    slope = -lm.otf(squares, [1e-4, 0.0], [0.0, 1e-4]).imag / (2.0 * math.pi * 1e-4)
    np.testing.assert_allclose(lm.psf(squares, 9, 0.25).centroid, slope, atol=1e-9)
    assert lm.psf(squares, 9, 0.25).encircled_energy(2.0, about="centroid") > 0.0
    tilt = lm.Mask.sample(lambda x, y: np.exp(1j * (0.8 * x * y + x)), side=256)
    np.testing.assert_allclose(math.pi * lm.centroid(lm.Pupil(mask=tilt)), [1.0, 0.0], atol=4e-4)
