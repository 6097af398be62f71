"""Differences, transfer functions, light within circles, rays and the light about the focus: what is drawn."""

from __future__ import annotations

import math

import matplotlib.pyplot as plt
import numpy as np
import pytest
from scipy.special import j0, j1

import lommel as lm
from lommel.measures.errors import mse
from lommel.show import curves, plot
from lommel.show.curves import moved, section

CAMERA = {"wavelength": 550e-9, "f_number": 4.0}
COMA = lm.Wavefront(1.0, nonradial={(3, 1): 1.5})


def lines(axes) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    return {line.get_label(): line.get_data() for line in axes.get_lines() if line.get_label()[0] != "_"}


@pytest.fixture
def psf() -> lm.PSF:
    return lm.psf(lm.Pupil(COMA, **CAMERA), (31, 41), 0.5e-6)


@pytest.fixture
def few(monkeypatch) -> None:
    monkeypatch.setattr(curves, "_PLANES", 9)


# Differences.


def test_a_difference_is_drawn_over_the_peak_on_a_scale_that_is_the_same_both_ways(psf):
    other = lm.psf(psf.pupil, (31, 41), 0.5e-6, method=lm.methods.MatrixFourier(64))
    axes = lm.show.difference(other, psf)
    (image,) = axes.get_images()
    away = (other.values.astype(float) - psf.values) / psf.values.max()
    np.testing.assert_allclose(image.get_array(), away, rtol=1e-6, atol=1e-12)
    assert image.norm.vmax == -image.norm.vmin == np.abs(away).max()
    assert image.get_extent() == pytest.approx((-10.25, 10.25, 7.75, -7.75))
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x (µm)", "y (µm)")
    rms = math.sqrt(mse(other, psf))
    assert axes.get_title() == f"largest difference {lm.peak_error(other, psf):.2g} of the peak, rms {rms:.2g}"
    assert axes.figure.axes[1].get_ylabel() == "difference / peak"
    axes.figure.canvas.draw()


def test_a_difference_may_be_that_of_an_array_and_may_be_nothing(psf):
    axes = lm.show.difference(psf.values + 0.25 * psf.values.max(), psf)
    np.testing.assert_allclose(axes.get_images()[0].get_array(), 0.25, rtol=1e-5)
    same = lm.show.difference(psf, psf)
    assert same.get_title() == "largest difference 0 of the peak, rms 0"
    same.figure.canvas.draw()


# Transfer functions.


def test_the_mtf_of_a_perfect_lens_is_that_of_the_textbook():
    found = lines(lm.show.mtf(lm.Pupil()))
    f, values = found["MTF"]
    exact = 2.0 / math.pi * (np.arccos(f) - f * np.sqrt(1.0 - f * f))
    np.testing.assert_allclose(values, exact, atol=2e-6)
    np.testing.assert_allclose(found["without aberration"][1], exact, atol=2e-6)
    assert (f[0], f[-1]) == (0.0, 1.0)


def test_the_mtf_of_a_psf_has_its_pixels_and_both_directions(psf):
    axes = psf.plot_mtf()
    found = lines(axes)
    f = np.linspace(0.0, psf.pupil.cutoff, 129)
    np.testing.assert_allclose(found["along x"][0], 1e-3 * f)
    np.testing.assert_allclose(found["along x"][1], lm.mtf(psf.pupil, f, pixel=0.5e-6), atol=2e-6)
    np.testing.assert_allclose(found["along y"][1], lm.mtf(psf.pupil, 0.0, f, pixel=0.5e-6), atol=2e-6)
    np.testing.assert_allclose(found["pixel alone"][1], np.abs(np.sinc(f * 0.5e-6)))
    exact = lm.mtf(lm.Pupil(**CAMERA), f, pixel=0.5e-6)
    np.testing.assert_allclose(found["without aberration"][1], exact, atol=2e-6)
    assert axes.get_title() == "modulation transfer function with pixels of 0.5 µm"


def test_a_psf_that_samples_has_no_pixel_and_one_in_white_light_its_spectrum():
    sampled = lm.psf(lm.Pupil(lm.Wavefront(2.0), **CAMERA), 33, 0.5e-6, integrate=False)
    assert "pixel alone" not in lines(sampled.plot_mtf())
    white = lm.methods.Polychromatic((450e-9, 650e-9), (1.0, 2.0))
    found = lines(lm.psf(sampled.pupil, 33, 0.5e-6, integrate=False, method=white).plot_mtf())["MTF"]
    f = 1e3 * found[0]
    np.testing.assert_allclose(found[1], lm.mtf(sampled.pupil, f, spectrum=white), atol=2e-6)
    # Up to where the shortest light ends.
    assert f[-1] == pytest.approx(sampled.pupil.cutoff * 550 / 450)


def test_blur_is_in_the_curve_without_aberration_too():
    seen = lm.psf(lm.Pupil(COMA, **CAMERA), 33, 0.5e-6, blur=lm.Jitter(2e-6), tol=1e-4)
    found = lines(seen.plot_mtf())
    f = 1e3 * found["without aberration"][0]
    exact = lm.mtf(lm.Pupil(**CAMERA), f, pixel=0.5e-6, blur=lm.Jitter(2e-6))
    np.testing.assert_allclose(found["without aberration"][1], exact, atol=2e-6)
    assert np.all(found["along x"][1] <= exact + 2e-6)


@pytest.mark.parametrize(("pixel", "drawn"), [(1.001 * 1.1e-6, True), (0.999 * 1.1e-6, False)])
def test_the_pixels_are_in_both_curves_and_their_nyquist_frequency_up_to_the_cutoff(pixel, drawn, monkeypatch):
    monkeypatch.setattr(curves, "_POINTS", 3)
    pupil = lm.Pupil(COMA, **CAMERA)
    axes = lm.show.mtf(pupil, pixel=pixel)
    found, f = lines(axes), pupil.cutoff * np.array([0.0, 0.5, 1.0])
    for name, place in (("along x", (f, 0.0)), ("along y", (0.0, f))):
        np.testing.assert_allclose(found[name][1], lm.mtf(pupil, *place) * np.sinc(f * pixel), atol=2e-6)
    assert ("Nyquist of pixels" in found) == drawn
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("spatial frequency (cycles/mm)", "MTF")
    assert axes.get_xlim() == (0.0, pytest.approx(1e-3 * f[2]))


# Light within circles.


@pytest.mark.parametrize("center", [(1, 10), (3, 10)])
def test_light_is_drawn_up_to_the_circle_that_the_window_holds(center):
    psf = lm.psf(lm.Pupil(**CAMERA), (5, 21), (2e-6, 1e-6), center=center)
    assert curves._window_radius(psf) == pytest.approx(2e-6 + 0.5e-6, rel=1e-12)


def test_the_light_within_circles_is_that_of_airy():
    axes = lm.psf(lm.Pupil(), 33, 0.25).plot_encircled_energy()
    found = lines(axes)
    radius, values = found["PSF"]
    v = math.pi * radius
    np.testing.assert_allclose(values, 1.0 - j0(v) ** 2 - j1(v) ** 2, atol=2e-6)
    np.testing.assert_allclose(found["without aberration"][1], values, atol=1e-12)
    assert radius[-1] == pytest.approx(16.5 * 0.25)  # to the edges of the outer pixels
    assert axes.get_xlim() == (0.0, radius[-1])
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("radius (λN)", "fraction of all light")
    assert axes.get_title() == "encircled energy, 50 % within 0.535 λN, 80 % within 0.897 λN"


@pytest.mark.parametrize("options", [{}, {"spider": lm.Spider.equal(3, width=0.1)}], ids=["round", "spider"])
def test_of_any_other_psf_it_is_that_of_its_pixels(options):
    psf = lm.psf(lm.Pupil(COMA, **CAMERA, **options), 41, 0.5e-6)
    axes = psf.plot_encircled_energy()
    found = lines(axes)
    radius, values = found["PSF"]
    np.testing.assert_allclose(values, psf.encircled_energy(1e-6 * radius), rtol=1e-9)
    ideal = lm.psf(psf.pupil.unaberrated(), 41, 0.5e-6, method=psf.method)
    np.testing.assert_allclose(found["without aberration"][1], ideal.encircled_energy(1e-6 * radius), atol=1e-5)
    assert axes.get_xlim() == pytest.approx((0.0, 10.25))
    half = float(axes.get_title().split("50 % within ")[1].split()[0])
    assert psf.encircled_energy(1e-6 * half) == pytest.approx(0.5, abs=3e-3)


def test_a_stack_has_a_curve_of_light_for_each(camera):
    psf = lm.psf(camera.pupil([1.9, 2.0, 2.2]), 33, 3e-6)
    found = lines(psf.plot_encircled_energy())
    assert [*found] == ["object at 1.9 m", "object at 2 m", "object at 2.2 m"]
    for one, (radius, values) in zip(psf, found.values(), strict=True):
        np.testing.assert_allclose(values, one.encircled_energy(1e-6 * radius))


# Rays.


def test_rays_are_drawn_over_the_psf_where_they_meet_the_sensor(psf):
    axes = psf.plot_spots()
    (dots,) = axes.collections
    np.testing.assert_allclose(dots.get_offsets(), 1e6 * plot.ray_positions(psf.pupil))
    np.testing.assert_array_equal(axes.get_images()[0].get_array(), psf.values)
    circle = next(line for line in axes.get_lines() if line.get_label() == "Airy circle")
    np.testing.assert_allclose(np.hypot(*circle.get_data()), 1e6 * psf.pupil.airy_radius)
    radius = 1e6 * float(lm.spot_radius(psf.pupil))
    assert axes.get_title() == f"rays: rms radius {radius:.3g} µm; Airy radius {1e6 * psf.pupil.airy_radius:.3g} µm"
    assert axes.get_xlim() == pytest.approx((-10.25, 10.25))


# The light about the focus.


def test_the_section_through_the_focus_is_drawn_with_the_sensor_at_0(camera):
    pupil = camera.pupil(1.95)
    axes = lm.show.through_focus(pupil)
    (image,) = axes.get_images()
    shifts, stack = moved(pupil)
    left, right, low, high = image.get_extent()
    x = np.linspace(-240.0, 240.0, 241) / 241.0 * 0.5e-6 * (high - low)
    np.testing.assert_allclose(image.get_array(), section(stack, x).T, atol=1e-12)
    half = 0.5e6 * (shifts[1] - shifts[0])
    assert (left, right) == pytest.approx((1e6 * shifts[0] - half, 1e6 * shifts[-1] + half))
    assert axes.get_ylim() == pytest.approx((low, high))  # x rises upwards
    assert image.origin == "lower"
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("sensor moved away from the lens (µm)", "x (µm)")
    assert axes.get_title() == f"f/{pupil.f_number:.3g}, 550 nm; dashed: the sensor"
    assert axes.figure.axes[1].get_ylabel() == "irradiance (1 = unaberrated peak)\n(colours: square root)"
    # The object is nearer than what is in focus: its image is behind the sensor.
    assert shifts[int(image.get_array()[120].argmax())] > 0.0
    axes.figure.canvas.draw()


def test_a_pupil_without_a_wavelength_is_drawn_over_its_defocus():
    axes = lm.show.through_focus(lm.Pupil(lm.Wavefront(2.0)))
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("added defocus C_d (rad)", "x (λN)")
    (image,) = axes.get_images()
    left, right, *_ = image.get_extent()
    places = left + (np.arange(161) + 0.5) * (right - left) / 161
    assert places[int(image.get_array()[120].argmax())] == pytest.approx(-2.0, abs=0.5)


def test_curves_about_the_focus_are_those_of_strehl_and_mtf():
    axes = lm.show.focus_curves(lm.Pupil())
    found = lines(axes)
    c, values = found["Strehl ratio"]
    np.testing.assert_allclose(values, np.sinc(c / math.pi) ** 2, atol=1e-9)
    exact = lm.mtf(lm.Pupil(lm.Wavefront(c)), [0.1, 0.5])
    np.testing.assert_allclose(found["MTF at 0.1 cycles/λN"][1], exact[:, 0], atol=2e-6)
    np.testing.assert_allclose(found["MTF at 0.5 cycles/λN"][1], exact[:, 1], atol=2e-6)
    assert axes.get_ylabel() == "Strehl ratio, MTF"
    metric = lm.show.focus_curves(lm.Pupil(wavelength=550e-9, f_number=32.0))
    assert metric.get_xlabel() == "sensor moved away from the lens (mm)"
    assert metric.get_title() == "f/32, 550 nm; dashed: the sensor"


@pytest.mark.usefixtures("few")
def test_of_coma_both_directions_are_drawn_and_of_a_mask_the_strehl_ratio_alone():
    both = [*lines(lm.show.focus_curves(lm.Pupil(COMA)))]
    assert both[1::3] == ["MTF at 0.1 cycles/λN", "MTF at 0.1 cycles/λN, along y"]
    masked = lm.Pupil(COMA, mask=lm.Mask(np.ones((64, 64))))
    assert [*lines(lm.show.focus_curves(masked))] == ["Strehl ratio"]


# What all have.


def draw(psf: lm.PSF) -> dict[str, object]:
    pupil, field = psf.pupil, lm.FieldMap.from_seidel(20e-3, W131=1.0, **CAMERA)
    return {
        "plot": psf.plot,
        "grid": field.grid(1, 2, sensor=(20e-3, 30e-3), shape=5, pixel=1e-6).plot,
        "difference": lambda ax: lm.show.difference(psf, psf, ax),
        "mtf": lambda ax: lm.show.mtf(psf, ax),
        "encircled_energy": psf.plot_encircled_energy,
        "spots": psf.plot_spots,
        "through_focus": lambda ax: lm.show.through_focus(pupil, ax),
        "focus_curves": lambda ax: lm.show.focus_curves(pupil, ax),
    }


@pytest.mark.usefixtures("few")
@pytest.mark.parametrize(
    "name", ["plot", "grid", "difference", "mtf", "encircled_energy", "spots", "through_focus", "focus_curves"]
)
def test_each_draws_on_axes_of_ones_own_and_leaves_their_figure_as_it_is(name, psf):
    figure, own = plt.subplots()
    assert draw(psf)[name](own) is own
    assert own.has_data()
    assert (own.get_title(), figure.axes) == ("", [own])
    assert "(" in own.get_xlabel()
    # A ratio has no unit.
    assert ("(" in own.get_ylabel()) == (name not in ("mtf", "encircled_energy", "focus_curves"))
    with pytest.raises(TypeError, match="ax must be axes of matplotlib or None, got 3"):
        draw(psf)[name](3)
