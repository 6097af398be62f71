"""An optical axis off the pixels, and pixels that average."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm


def by_quadrature(pupil: lm.Pupil, shape: tuple[int, int], pixel: float, center, nodes: int) -> np.ndarray:
    """Return the average of I over each pixel, by Gauss quadrature of the reference."""
    x, w = np.polynomial.legendre.leggauss(nodes)
    rows = (np.arange(shape[0]) - center[0])[:, None] + 0.5 * x
    columns = (np.arange(shape[1]) - center[1])[:, None] + 0.5 * x
    radii = np.hypot(rows[:, None, :, None], columns[None, :, None, :])
    intensity = np.abs(lm.Hankel(1e-13).field(pupil, np.pi * pixel * radii)) ** 2
    return np.einsum("yxab,a,b->yx", intensity, 0.5 * w, 0.5 * w)


@given(st.floats(-3, 30), st.floats(-3, 30), st.floats(-60, 60), st.floats(-40, 40))
def test_off_the_centre_every_pixel_has_the_intensity_at_its_own_distance(row, column, defocus, spherical):
    pupil = lm.Pupil(lm.Wavefront(defocus, spherical))
    answer = lm.psf(pupil, (24, 27), 0.4, center=(row, column), normalize="strehl", dtype=np.float64)
    radii = np.hypot((np.arange(24) - row)[:, None], np.arange(27) - column)
    exact = np.abs(lm.Hankel().field(pupil, np.pi * 0.4 * radii)) ** 2
    assert np.abs(answer.values - exact).max() <= answer.error_bound * exact.max() + 1e-13


@pytest.mark.parametrize("method", [lm.NijboerZernike(1e-8), lm.Hankel(), lm.LommelSeries(), lm.Fraunhofer()])
def test_a_centre_named_is_the_centre_left_out(method):
    pupil = lm.Pupil(lm.Wavefront(5.0))
    left_out = lm.psf(pupil, (30, 21), 0.4, method=method)
    named = lm.psf(pupil, (30, 21), 0.4, method=method, center=(15, 10))
    assert np.array_equal(named.values, left_out.values)


@pytest.mark.parametrize("method", [lm.Hankel(), lm.Geometric(), lm.Fraunhofer(512, edge="grey")])
def test_moving_the_axis_by_whole_pixels_moves_the_image(method):
    # Fraunhofer: both windows ask for the same pitch, hence for the same transform.
    pupil = lm.Pupil(lm.Wavefront(8.0))
    wide = lm.psf(pupil, 61, 0.5, method=method, dtype=np.float64)
    moved = lm.psf(pupil, 31, 0.5, method=method, dtype=np.float64, center=(9, 25))
    assert np.allclose(moved.values, wide.values[21:52, 5:36], atol=1e-9 * wide.values.max())


def test_a_large_image_off_centre_is_interpolated_within_the_bound():
    pupil = lm.Pupil(lm.Wavefront(30.0, 10.0))
    answer = lm.psf(pupil, 700, 0.1, center=(300.25, 410.5), normalize="strehl", dtype=np.float64)
    rows, columns = np.arange(0, 700, 9), np.arange(0, 700, 11)
    radii = np.hypot((rows - 300.25)[:, None], columns - 410.5)
    exact = np.abs(lm.Hankel().field(pupil, np.pi * 0.1 * radii)) ** 2
    assert np.abs(answer.values[np.ix_(rows, columns)] - exact).max() / exact.max() <= answer.error_bound <= 1.1e-6


@pytest.mark.parametrize("pixel", [0.3, 1.0, 3.4])
@pytest.mark.parametrize(("defocus", "spherical"), [(0.0, 0.0), (20.0, 10.0), (-100.0, 0.0)])
@pytest.mark.parametrize("center", [None, (7.3, 10.9)])
def test_pixel_averages_agree_with_quadrature_over_each_pixel(pixel, defocus, spherical, center):
    pupil = lm.Pupil(lm.Wavefront(defocus, spherical), obscuration=0.2)
    method = lm.NijboerZernike(1e-8)
    answer = lm.psf(pupil, (17, 20), pixel, method=method, integrate=True, center=center, normalize="strehl")
    exact = by_quadrature(pupil, (17, 20), pixel, center or (8, 10), 24 if pixel < 2 else 44) / pupil.area**2
    assert lm.peak_error(answer, exact) <= answer.error_bound <= 1.01e-8


def test_pixel_averages_sum_to_the_energy_in_the_window():
    for shape in ((40, 31), (9, 9)):
        answer = lm.psf(lm.Pupil(lm.Wavefront(9.0)), shape, 2.7, integrate=True, dtype=np.float64)
        assert answer.values.sum() == pytest.approx(answer.energy, abs=1e-6)
        moved = lm.psf(lm.Pupil(lm.Wavefront(9.0)), shape, 2.7, integrate=True, dtype=np.float64, center=(1.2, 30.0))
        assert moved.values.sum() == pytest.approx(moved.energy, abs=1e-6)


def test_what_a_method_cannot_average_is_refused():
    pupil = lm.Lens(focal_length=0.05, f_number=8, wavelength=5e-7).pupil(9.0)
    with pytest.raises(ValueError, match="integrate must not be False for Geometric, which has no point values"):
        lm.psf(pupil, 9, 1e-6, method=lm.Geometric(), integrate=False)
    with pytest.raises(TypeError, match="integrate must be True, False or None, got 1"):
        lm.psf(pupil, 9, 1e-6, integrate=1)  # type: ignore[arg-type]
    for center in (3, (1,), (1, np.nan), (1, 1e9)):
        with pytest.raises(ValueError, match="center"):
            lm.psf(pupil, 9, 1e-6, center=center)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="derivatives"):
        lm.psf(pupil, 9, 1e-6, center=(1.0, 2.0), derivatives=("defocus",))
