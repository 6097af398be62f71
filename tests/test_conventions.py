"""The conventions of the package, one test each: what the numbers mean, and which way they grow."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import j0

import lommel as lm
from lommel.methods import METHODS, ChordalGauss, Hankel, NijboerZernike, NonuniformFFT
from lommel.optics.grid import Grid
from lommel.paper import Fraunhofer, LommelSeries

METHOD = pytest.mark.parametrize("method", [kind() for kind in METHODS.values()], ids=list(METHODS))


def focused_at_two_metres(**options: float) -> lm.Lens:
    return lm.Lens(focal_length=50e-3, f_number=2.0, focus_distance=2.0, wavelength=500e-9, **options)


def round_lens(**options: float) -> lm.Lens:
    """A lens of which 0.02 dioptres of defocus are two waves: R^2 / (2 lambda) is 100 m."""
    return lm.Lens(focal_length=0.1, aperture_diameter=0.02, wavelength=500e-9, **options)


@METHOD
@pytest.mark.parametrize("shape", [(5, 7), (6, 8), (5, 8), (8, 5), (2, 2), (1, 1)])
def test_the_centre_of_an_image_is_the_middle_of_pixel_half_the_height_half_the_width(method, shape):
    pupil = focused_at_two_metres().pupil(2.0)
    values = lm.psf(pupil, shape, 0.4 * pupil.scale, method=method, dtype="float64").values
    height, width = shape
    row, column = height // 2, width // 2
    assert np.unravel_index(values.argmax(), shape) == (row, column)
    above, below = values[:row][::-1], values[row + 1 :]
    left, right = values[:, :column][:, ::-1], values[:, column + 1 :]
    # Nodes that are not symmetric about the axis make images as symmetric as they are exact.
    atol = 1e-9 if isinstance(method, NonuniformFFT | ChordalGauss) else 1e-12
    np.testing.assert_allclose(above[: len(below)], below, rtol=0, atol=atol)
    np.testing.assert_allclose(left[:, : right.shape[1]], right, rtol=0, atol=atol)


@pytest.mark.parametrize("method", [NijboerZernike(), Hankel(), LommelSeries()], ids=repr)
def test_values_sample_the_intensity_at_pixel_centres(method):
    pupil = lm.Pupil(lm.Wavefront(defocus=4.0))
    image = lm.psf(pupil, (6, 9), 0.7, method=method, normalize="strehl", dtype="float64")
    rows, columns = np.indices(image.shape)
    v = math.pi * 0.7 * np.hypot(rows - 3, columns - 4)
    t, weights = np.polynomial.legendre.leggauss(60)
    t, weights = 0.5 + 0.5 * t, 0.5 * weights
    field = j0(v[..., None] * np.sqrt(t)) @ (weights * np.exp(8j * t))
    np.testing.assert_allclose(image.values, np.abs(field) ** 2, rtol=0, atol=1e-7)
    assert method.sampling == "center"


def test_the_fourier_transform_samples_the_same_points_as_quadrature():
    pupil = lm.Pupil(lm.Wavefront(defocus=4.0))
    reference = lm.psf(pupil, (6, 9), 0.7, method="hankel")
    errors = [
        lm.peak_error(lm.psf(pupil, (6, 9), 0.7, method=Fraunhofer(samples=n, edge="grey")), reference)
        for n in (64, 256)
    ]
    assert errors[0] < 5e-2
    assert errors[1] < 2e-3


def test_the_geometric_method_averages_over_pixels():
    blur_of_ten_pixels = lm.Pupil(lm.Wavefront(defocus=10.0 * math.pi / 4))
    image = lm.psf(blur_of_ten_pixels, 23, 1.0, method="geometric", dtype="float64")
    assert image.method.sampling == "pixel"
    assert image.values.sum() == pytest.approx(1.0, abs=1e-12)
    assert image.values[11, 11] == pytest.approx(1 / (math.pi * 100), rel=1e-3)
    rim = image.values[11, 21]
    assert 0.2 < rim / image.values[11, 11] < 0.6


@pytest.mark.parametrize("center", [(3.0, 4.0), (0.0, 0.0), (2.25, 7.5), (-3.0, 12.0)])
def test_pixels_that_integrate_hold_the_light_in_the_window_wherever_the_axis_is(center):
    pupil = lm.Pupil(lm.Wavefront(defocus=5.0), obscuration=0.2)
    image = lm.psf(pupil, (7, 9), 0.8, center=center, integrate=True, dtype="float64")
    assert image.sampling == "pixel"
    assert image.values.sum() == pytest.approx(image.energy, rel=1e-5)


def test_a_centre_is_a_row_and_a_column_counted_from_the_middle_of_the_first_pixel():
    image = lm.psf(lm.Pupil(), (8, 9), 0.4, center=(2, 6))
    assert np.unravel_index(image.values.argmax(), (8, 9)) == (2, 6)
    between = lm.psf(lm.Pupil(), (8, 9), 0.4, center=(2.5, 6)).values
    np.testing.assert_allclose(between[2], between[3], rtol=1e-5)
    assert between[2, 6] > between[1, 6]


def test_rows_go_down_and_columns_to_the_right():
    grid = Grid((3, 5), 2.0)
    assert grid.y.tolist() == [-2.0, 0.0, 2.0]
    assert grid.x.tolist() == [-4.0, -2.0, 0.0, 2.0, 4.0]
    image = lm.psf(lm.Pupil(), (3, 5), 0.25)
    assert image.values.shape == (3, 5)
    top, bottom = image.plot().get_ylim()[::-1]
    assert top < bottom


def test_the_phase_is_two_C_d_rho_squared_plus_C_s_rho_to_the_fourth():
    wavefront = lm.Wavefront(defocus=3.0, spherical=5.0, higher=(7.0, 11.0))
    assert wavefront.phase(1.0) == 2 * 3.0 + 5.0 + 7.0 + 11.0
    assert wavefront.phase(0.5) == pytest.approx(2 * 3 / 4 + 5 / 16 + 7 / 64 + 11 / 256)
    assert wavefront.phase(0.0) == 0.0


def test_W020_is_C_d_over_pi_and_W040_is_C_s_over_two_pi():
    waves = lm.Wavefront(defocus=3.0, spherical=5.0, higher=(7.0,)).waves
    assert waves == {
        "W020": pytest.approx(3 / math.pi),
        "W040": pytest.approx(5 / (2 * math.pi)),
        "W060": pytest.approx(7 / (2 * math.pi)),
    }


@pytest.mark.parametrize("name", ["W020", "W040", "W060", "W080"])
def test_one_wave_of_a_seidel_coefficient_is_two_pi_at_the_edge_of_the_pupil(name):
    assert lm.Wavefront.from_seidel(**{name: 1.0}).phase(1.0) == pytest.approx(2 * math.pi)


def test_C_d_is_positive_where_the_sensor_lies_between_the_lens_and_its_focus():
    assert round_lens(sensor_distance=0.099).defocus(math.inf) > 0
    assert round_lens(sensor_distance=0.1).defocus(math.inf) == 0
    assert round_lens(sensor_distance=0.101).defocus(math.inf) < 0


def test_an_object_nearer_than_the_focus_gives_a_positive_C_d():
    lens = focused_at_two_metres()
    nearer, farther = lens.defocus([1.9, 2.1])
    assert nearer > 0
    assert farther < 0
    assert lens.defocus(2.0) == pytest.approx(0.0, abs=1e-9)


def test_equation_3_holds_for_an_object_at_infinity():
    assert round_lens(sensor_distance=1 / 10.02).defocus(math.inf) == pytest.approx(2 * math.pi)
    assert round_lens(sensor_distance=1 / 9.99).defocus(math.inf) == pytest.approx(-math.pi)


def test_equation_3_has_the_term_one_over_s_for_an_object_at_a_finite_distance():
    assert round_lens(sensor_distance=0.1).defocus(50.0) == pytest.approx(2 * math.pi)
    assert round_lens(sensor_distance=1 / 9.98).defocus([50.0, 100.0]) == pytest.approx([0.0, -math.pi], abs=1e-9)


def test_distances_are_measured_from_the_lens():
    lens = lm.Lens(focal_length=0.1, f_number=4.0, focus_distance=0.2, wavelength=500e-9)
    assert lens.sensor_distance == pytest.approx(0.2)
    assert lens.defocus(0.2) == pytest.approx(0.0, abs=1e-9)


def test_a_positive_C_s_focuses_the_rim_beyond_the_middle():
    lens = round_lens(sensor_distance=0.1, aberrations=lm.Wavefront(spherical=20.0))
    spot = lens.pupil().airy_radius
    nearer, farther = (
        lm.psf(
            round_lens(sensor_distance=1 / vergence, aberrations=lens.aberrations).pupil(math.inf), 3, 1e-6
        ).encircled_energy(spot)
        for vergence in (10.05, 9.95)
    )
    assert farther > 3 * nearer
    assert lm.best_focus(lens.pupil(), spot) < -5.0


def test_the_N_of_lambda_N_is_the_sensor_distance_over_the_aperture():
    life_size = lm.Lens(focal_length=0.1, f_number=4.0, focus_distance=0.2, wavelength=500e-9)
    assert life_size.f_number == pytest.approx(4.0)
    assert life_size.pupil(0.2).f_number == pytest.approx(8.0)
    assert life_size.pupil(0.2).scale == pytest.approx(8.0 * 500e-9)


def test_the_optical_coordinate_is_pi_radius_over_lambda_N():
    pupil = lm.Pupil(wavelength=500e-9, f_number=4.0)
    assert pupil.v(2e-6) == pytest.approx(math.pi)
    assert lm.Pupil().v(1.0) == pytest.approx(math.pi)


def test_lengths_in_lambda_N_and_in_metres_give_the_same_image():
    wavefront = lm.Wavefront(defocus=9.0, spherical=-4.0)
    metric = lm.Pupil(wavefront, obscuration=0.2, wavelength=633e-9, f_number=5.6)
    one = lm.psf(lm.Pupil(wavefront, obscuration=0.2), 15, 0.4, dtype="float64")
    two = lm.psf(metric, 15, 0.4 * 633e-9 * 5.6, dtype="float64", integrate=False)
    np.testing.assert_allclose(one.values, two.values, rtol=1e-9, atol=0)
    assert (one.unit, two.unit) == ("lambda*N", "m")
    assert one.encircled_energy(2.0) == pytest.approx(two.encircled_energy(2.0 * metric.scale))


def test_a_pixel_in_metres_averages_over_its_area_and_one_in_lambda_N_samples_its_centre():
    wavefront = lm.Wavefront(defocus=2.0)
    metric = lm.Pupil(wavefront, wavelength=500e-9, f_number=2.0)
    one, two = lm.psf(lm.Pupil(wavefront), 9, 2.0), lm.psf(metric, 9, 2e-6)
    assert (one.sampling, two.sampling) == ("center", "pixel")
    sampled = lm.psf(metric, 9, 2e-6, integrate=False)
    averaged = lm.psf(lm.Pupil(wavefront), 9, 2.0, integrate=True)
    np.testing.assert_allclose(one.values, sampled.values, rtol=1e-5, atol=1e-7)
    np.testing.assert_allclose(two.values, averaged.values, rtol=1e-5, atol=1e-7)
    assert two.values.sum() == pytest.approx(two.energy, abs=1e-5)
    assert abs(one.values.sum() - one.energy) > 0.1


def test_the_image_does_not_change_when_every_length_grows_alike():
    def image(k):
        lens = lm.Lens(focal_length=k * 0.05, f_number=2.8, focus_distance=k * 2.0, wavelength=k * 500e-9)
        return lm.psf(lens.pupil(k * 1.9), 9, k * 2e-6, dtype="float64").values

    np.testing.assert_allclose(image(1.0), image(8.0), rtol=1e-6)


@pytest.mark.parametrize("pixel", [0.25, 0.5, 1.0])
@pytest.mark.parametrize("eps", [0.0, 0.4])
def test_energy_means_that_an_infinite_window_of_fine_pixels_sums_to_one(pixel, eps):
    half_width = 64.0
    side = 2 * round(half_width / pixel) + 1
    image = lm.psf(lm.Pupil(obscuration=eps), side, pixel, normalize="energy", dtype="float64")
    # Outside of the circle with this radius is about 2 / (pi v) of the light, and more the longer the edges are.
    outside = 2 / (math.pi * math.pi * half_width) / (1 - eps)
    assert 1.0 - 1.01 * outside < image.values.sum() < 1.0


def test_strehl_means_that_one_is_the_peak_of_the_same_aperture_without_aberration():
    for eps in (0.0, 0.5):
        image = lm.psf(lm.Pupil(obscuration=eps), 3, 0.5, normalize="strehl")
        assert image.values[1, 1] == pytest.approx(1.0)
        assert lm.psf(lm.Pupil(obscuration=eps), 3, 0.5, normalize="energy").strehl == pytest.approx(1.0)
    defocused = lm.psf(lm.Pupil(lm.Wavefront(defocus=2.0)), 3, 0.5, normalize="strehl")
    assert defocused.values[1, 1] == pytest.approx((math.sin(2.0) / 2.0) ** 2, rel=1e-6)


def test_peak_means_that_the_largest_value_of_each_image_is_one():
    dark_in_the_middle = lm.Pupil(lm.Wavefront(defocus=[math.pi, 0.0]))
    images = lm.psf(dark_in_the_middle, 31, 0.25, normalize="peak")
    assert images.values.max(axis=(1, 2)).tolist() == [1.0, 1.0]
    assert images.values[0, 15, 15] < 1e-6


def test_no_intensity_depends_on_the_sign_of_the_whole_wavefront():
    wavefront = lm.Wavefront(defocus=6.0, spherical=3.0)
    one, two = (lm.psf(lm.Pupil(w), 11, 0.5, dtype="float64").values for w in (wavefront, -wavefront))
    np.testing.assert_allclose(one, two, rtol=0, atol=1e-7 * one.max())


def test_the_obscuration_is_a_ratio_of_radii():
    assert lm.Pupil(obscuration=0.5).area == 0.75
    # A thin ring has the field J0(v) of its rim.
    ring = lm.psf(lm.Pupil(obscuration=0.999), (1, 9), 0.3, normalize="strehl")
    np.testing.assert_allclose(ring.values[0, 4:], j0(math.pi * 0.3 * np.arange(5)) ** 2, atol=3e-3)


def test_the_axes_of_a_stack_come_before_those_of_the_image():
    stack = lm.Pupil(lm.Wavefront(defocus=np.zeros((2, 1)), spherical=np.zeros(3)))
    assert lm.psf(stack, (4, 5), 0.5).values.shape == (2, 3, 4, 5)


def slope(make, h: float) -> np.ndarray:
    """Return the derivative of the values of what makes a PSF, by differences."""
    return (8.0 * (make(h).values - make(-h).values) - make(2 * h).values + make(-2 * h).values) / (12.0 * h)


def given(pupil: lm.Pupil, name: object, **asked) -> tuple[np.ndarray, float]:
    answer = lm.psf(pupil, 9, 1e-6, derivatives=(name,), tol=1e-9, **asked)
    return answer.derivatives[name], 1e-5 * float(np.abs(answer.derivatives[name]).max())


def test_derivatives_by_the_wavefront_are_by_C_d_C_s_and_radians_at_the_edge():
    known, light = lm.Wavefront(1.0, 0.5, nonradial={(3, 1): 0.7}), {"wavelength": 5e-7, "f_number": 4.0}
    for name, one in (
        ("defocus", lm.Wavefront(1.0)),
        ("spherical", lm.Wavefront(0.0, 1.0)),
        ("rho^6", lm.Wavefront(higher=(1.0,))),
        ("rho^8", lm.Wavefront(higher=(0.0, 1.0))),
        ((2, -2), lm.Wavefront(nonradial={(2, -2): 1.0})),
        ("noll 8", lm.Wavefront(nonradial={(3, 1): 1.0})),
        ("fringe 8", lm.Wavefront(nonradial={(3, -1): 1.0})),
    ):
        found, off = given(lm.Pupil(known, **light), name)
        exact = slope(lambda h, one=one: lm.psf(lm.Pupil(known + h * one, **light), 9, 1e-6, tol=1e-10), 1e-2)
        assert found == pytest.approx(exact, abs=off)


def test_derivatives_by_row_and_column_are_by_the_place_of_the_axis():
    pupil = lm.Pupil(lm.Wavefront(1.0, nonradial={(3, 1): 0.7}), wavelength=5e-7, f_number=4.0)
    for name, place in (("row", lambda h: (4.2 + h, 3.7)), ("column", lambda h: (4.2, 3.7 + h))):
        found, off = given(pupil, name, center=place(0.0))
        exact = slope(lambda h, place=place: lm.psf(pupil, 9, 1e-6, tol=1e-10, center=place(h)), 1e-2)
        assert found == pytest.approx(exact, abs=off)


def test_the_derivative_by_the_wavelength_keeps_path_differences_and_the_f_number():
    path = lm.Wavefront(1.0, nonradial={(3, 1): 0.7})

    def at(longer: float) -> lm.Pupil:
        return lm.Pupil(path * (5e-7 / (5e-7 + longer)), wavelength=5e-7 + longer, f_number=4.0)

    found, off = given(at(0.0), "wavelength")
    assert found == pytest.approx(slope(lambda h: lm.psf(at(h), 9, 1e-6, tol=1e-10), 1e-9), abs=off)


def test_the_derivative_by_the_f_number_keeps_phases():
    def at(more: float) -> lm.Pupil:
        return lm.Pupil(lm.Wavefront(1.0, nonradial={(3, 1): 0.7}), wavelength=5e-7, f_number=4.0 + more)

    found, off = given(at(0.0), "f_number")
    assert found == pytest.approx(slope(lambda h: lm.psf(at(h), 9, 1e-6, tol=1e-10), 1e-2), abs=off)


def test_the_derivative_by_the_object_distance_keeps_the_sensor(camera):
    found, off = given(camera.pupil(2.02), "object_distance")
    exact = slope(lambda h: lm.psf(camera.pupil(2.02 + h), 9, 1e-6, tol=1e-10), 1e-4)
    assert found == pytest.approx(exact, abs=off)


def test_the_derivative_by_the_focus_distance_moves_the_sensor(camera):
    found, off = given(camera.pupil(2.02), "focus_distance")
    exact = slope(lambda h: lm.psf(camera.focused(2.0 + h).pupil(2.02), 9, 1e-6, tol=1e-10), 1e-4)
    assert found == pytest.approx(exact, abs=off)


def test_the_derivative_by_the_obscuration_counts_the_light_that_it_takes():
    def at(more: float) -> lm.Pupil:
        wavefront = lm.Wavefront(1.0, nonradial={(3, 1): 0.7})
        return lm.Pupil(wavefront, wavelength=5e-7, f_number=4.0, obscuration=0.4 + more)

    for normalize in ("energy", "strehl"):
        found, off = given(at(0.0), "obscuration", normalize=normalize)
        exact = slope(lambda h, n=normalize: lm.psf(at(h), 9, 1e-6, tol=1e-10, normalize=n), 1e-3)
        assert found == pytest.approx(exact, abs=off)


@pytest.mark.parametrize("unit", [{}, {"wavelength": 500e-9, "f_number": 4.0}], ids=["lambda*N", "metres"])
def test_a_pair_of_sides_is_height_and_width_of_a_pixel(unit):
    pupil = lm.Pupil(lm.Wavefront(1.0), **unit)
    one = pupil.scale
    oblong = lm.psf(pupil, (5, 7), (0.4 * one, 0.2 * one), integrate=False, dtype="float64")
    square = lm.psf(pupil, (9, 7), 0.2 * one, integrate=False, dtype="float64")
    assert oblong.grid.y == pytest.approx(square.grid.y[::2])
    assert oblong.grid.x == pytest.approx(square.grid.x)
    # Fractions of the light per pixel, which is twice as large.
    assert oblong.values == pytest.approx(2.0 * square.values[::2], abs=2e-6 * oblong.values.max())


def test_values_of_partly_active_pixels_still_sum_to_all_light():
    whole, partly = (lm.psf(lm.Pupil(), 65, 0.4, integrate=True, fill=fill) for fill in (1.0, (0.7, 0.5)))
    assert float(partly.values.sum()) == pytest.approx(float(whole.values.sum()), abs=1e-4)
    assert partly.values.max() > whole.values.max()


def test_motion_and_jitter_run_along_their_angle_from_columns_to_rows():
    for blur in (lm.Motion(3.0, 0.25 * math.pi), lm.Jitter(1.0, 0.0, 0.25 * math.pi)):
        values = lm.psf(lm.Pupil(), 9, 0.5, blur=blur).values
        # Down and to the right, as x and y rise.
        assert values[7, 7] > 5.0 * values[7, 1]


def test_r0_grows_with_the_wavelength_to_the_power_of_six_fifths():
    air = lm.Seeing(0.1, focal_length=2.0, wavelength=500e-9)
    longer = lm.Seeing(0.1 * 1.4**1.2, focal_length=2.0, wavelength=700e-9)
    assert air.transfer(3e4, wavelength=700e-9) == pytest.approx(longer.transfer(3e4))
