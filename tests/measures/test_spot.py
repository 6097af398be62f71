"""Widths, diameters and centroids of PSFs, and differences of two."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import integrate, optimize, special
from scipy.optimize import brentq

import lommel as lm
from lommel import Pupil, Wavefront
from lommel.measures import energy, spot
from lommel.measures.errors import mse
from lommel.methods import Hankel, NijboerZernike
from lommel.paper import ClosedForm, Fraunhofer

FINE = Fraunhofer(samples=256, edge="grey")
EXACT = NijboerZernike(1e-11)


def airy(v: float) -> float:
    return (2 * special.j1(v) / v) ** 2 if v else 1.0


def test_the_airy_pattern_is_1_029_lambda_N_wide():
    expected = 2 * brentq(lambda v: airy(v) - 0.5, 1.0, 2.5, xtol=1e-14) / math.pi
    assert expected == pytest.approx(1.02899, abs=1e-5)
    for pixel in (0.1, 3.0):
        answer = lm.psf(lm.Pupil(), 5, pixel, method=EXACT)
        assert [answer.fwhm(along) for along in ("mean", "x", "y")] == pytest.approx([expected] * 3, abs=1e-9)
    metric = lm.psf(lm.Pupil(wavelength=500e-9, f_number=4.0), 5, 1e-6, method=EXACT)
    assert metric.fwhm(of="optics") == pytest.approx(expected * 2e-6, rel=1e-9)
    # Behind pixels of half a lambda*N it is wider.
    assert expected * 2e-6 < metric.fwhm() < 1.1 * 2e-6


@pytest.mark.parametrize(("eps", "g"), [(0.0, 0.0), (0.5, 0.0), (0.95, 0.0), (0.0, 2.0)])
@pytest.mark.parametrize("defocus", [0.0, 2.0, 3.3, 25.0])
def test_at_half_of_its_width_the_profile_is_half_of_its_largest_value_and_beyond_it_less(eps, g, defocus):
    answer = lm.psf(lm.Pupil(lm.Wavefront(defocus), obscuration=eps, apodization=g), 5, 0.2, method="hankel")
    half = 0.5 * answer.fwhm()
    reach = float(answer.pupil.geometric_radius()) + 8
    values = answer.profile(np.linspace(0, reach, 20001))[1]
    assert answer.profile(half)[1] == pytest.approx(0.5 * values.max(), rel=1e-5)
    assert answer.profile(half + np.linspace(1e-3, reach, 2000))[1].max() < 0.5 * values.max()


def test_the_width_of_a_large_defocus_is_about_that_of_the_geometric_blur_where_the_axis_is_dark():
    answer = lm.psf(lm.Pupil(lm.Wavefront(64 * math.pi)), 5, 0.2)
    assert answer.fwhm() == pytest.approx(2 * answer.pupil.geometric_radius(), rel=0.1)


@pytest.mark.parametrize("fraction", [0.01, 0.5, 0.8, 0.95])
def test_the_diameters_of_the_airy_pattern_hold_what_rayleigh_says(fraction):
    answer = lm.psf(lm.Pupil(), 5, 0.2, method=EXACT)
    v = 0.5 * math.pi * answer.energy_diameter(fraction)
    assert 1 - special.j0(v) ** 2 - special.j1(v) ** 2 == pytest.approx(fraction, abs=1e-9)


@given(st.floats(-30, 30), st.floats(0.02, 0.97), st.sampled_from([0.0, 0.6]))
def test_a_diameter_holds_the_light_it_was_asked_for(defocus, fraction, eps):
    answer = lm.psf(lm.Pupil(lm.Wavefront(defocus), obscuration=eps), 5, 0.2, method=NijboerZernike(1e-9))
    assert answer.encircled_energy(0.5 * answer.energy_diameter(fraction)) == pytest.approx(fraction, abs=1e-8)


def test_images_of_a_method_without_a_profile_come_near_those_of_one_with():
    pupil = lm.Pupil(lm.Wavefront([0.0, 1.5]))
    exact = lm.psf(pupil, 129, 0.25, method=EXACT)
    errors = []
    for pixel in (0.25, 0.125):
        image = lm.psf(pupil, round(32 / pixel) + 1, pixel, method=FINE)
        assert image.fwhm() == pytest.approx(exact.fwhm(), rel=1e-2)
        assert image.fwhm("x") == pytest.approx(image.fwhm("y"), rel=1e-6)
        errors.append(np.abs(image.energy_diameter(0.8) - exact.energy_diameter(0.8)).max())
    # What is left is the aperture that is made of samples; the pixels of the window do not matter.
    assert errors[0] < 5e-3
    assert errors[1] == pytest.approx(errors[0], rel=1e-2)


def test_astigmatism_is_wider_along_one_axis_and_turns_with_its_sign():
    widths = []
    for sign in (1, -1):
        pupil = lm.Pupil(lm.Wavefront(1.0, nonradial={(2, 2): sign * 2.0}))
        image = lm.psf(pupil, 65, 0.25, method=FINE)
        widths.append([image.fwhm("x"), image.fwhm("y")])
        assert image.fwhm() == pytest.approx(np.mean(widths[-1]))
    # 2 C_d rho^2 and 2 rho^2 cos(2 theta) cancel along y, and add along x.
    assert widths[0][0] > 1.5 * widths[0][1]
    assert widths[0] == pytest.approx(widths[1][::-1], rel=1e-4)


@pytest.mark.parametrize(("across", "down"), [(2.0, 0.0), (-1.3, 4.7), (0.0, -3.0)])
def test_a_tilt_moves_peak_and_centroid_and_leaves_the_rest(across, down):
    still = lm.psf(lm.Pupil(lm.Wavefront(nonradial={(2, 2): 1.0})), 257, 0.25, method=FINE, dtype="float64")
    wavefront = lm.Wavefront(nonradial={(2, 2): 1.0, (1, 1): math.pi * across, (1, -1): math.pi * down})
    moved = lm.psf(lm.Pupil(wavefront), 257, 0.25, method=FINE, dtype="float64")
    assert lm.centroid(moved.pupil) == pytest.approx([across, down], abs=1e-12)
    assert moved.centroid == pytest.approx([across, down], abs=1e-12)
    # The window cuts more on the side to which the light has moved.
    assert energy.window_centroid(moved) == pytest.approx([across, down], rel=0.06, abs=1e-6)
    assert moved.fwhm() == pytest.approx(still.fwhm(), rel=1e-3)
    # The two definitions of the Strehl ratio.
    assert moved.strehl < 0.05
    assert moved.peak_strehl == pytest.approx(still.strehl, rel=0.06)
    assert still.peak_strehl == pytest.approx(still.strehl, rel=2e-3)
    away = math.hypot(across, down)
    around = moved.encircled_energy([0.5, 2.0], about="centroid")
    assert around == pytest.approx(still.encircled_energy([0.5, 2.0]), abs=2e-3)
    assert moved.encircled_energy(0.3 * away) < 0.2
    sides = moved.ensquared_energy([0.5, 2.0], about="centroid")
    assert sides == pytest.approx(still.ensquared_energy([0.5, 2.0]), abs=2e-3)
    assert moved.energy_diameter(0.7, about="centroid") == pytest.approx(still.energy_diameter(0.7), rel=5e-3)


def test_the_centroid_of_a_window_approaches_that_of_the_wavefront():
    pupil = lm.Pupil(lm.Wavefront(nonradial={(3, 1): 1.0}), obscuration=0.2)
    errors = []
    for side in (65, 129, 257):
        image = lm.psf(pupil, side, 0.25, method=FINE, dtype="float64")
        errors.append(np.abs(energy.window_centroid(image) - lm.centroid(pupil)).max())
        np.testing.assert_allclose(image.centroid, lm.centroid(pupil), atol=1e-15)
    assert errors[0] > 1.5 * errors[1] > 2.25 * errors[2]


def test_squares_of_a_radial_psf_are_exact_and_those_of_its_pixels_come_near():
    pupil = lm.Pupil(lm.Wavefront([0.0, 4.0]), obscuration=0.3)
    half = np.array([0.0, 0.6, 1.0, 3.1])
    exact = lm.psf(pupil, 5, 0.3, method=EXACT).ensquared_energy(half)
    # A square of whole pixels is a window.
    window = lm.psf(pupil, 31, 0.2, integrate=True, method=EXACT).values.sum(axis=(1, 2))
    assert exact[:, 3] == pytest.approx(window, abs=1e-8)
    assert np.all(exact[:, 0] == 0)
    image = lm.psf(pupil, 101, 0.1, method=Fraunhofer(samples=256, edge="grey"))
    assert image.ensquared_energy(half) == pytest.approx(exact, abs=3e-3)


@settings(max_examples=12)
@given(st.floats(0.01, 20), st.floats(-10, 10))
def test_a_square_holds_no_less_than_its_inner_circle_and_no_more_than_its_outer(half, defocus):
    answer = lm.psf(lm.Pupil(lm.Wavefront(defocus)), 3, 0.3, method=NijboerZernike(1e-9))
    inner, outer = answer.encircled_energy([half, half * math.sqrt(2)])
    assert inner - 1e-8 <= answer.ensquared_energy(half) <= outer + 1e-8


def test_a_stack_gives_what_each_of_its_pupils_gives():
    for wavefront, method in (
        (lm.Wavefront([[0.0, 1.0, 3.0]]), EXACT),
        (lm.Wavefront([[0.0, 1.0, 3.0]], nonradial={(3, 1): 1.0}), FINE),
    ):
        stack = lm.psf(lm.Pupil(wavefront), (33, 41), 0.25, method=method)
        numbers = {
            "fwhm": lambda a: a.fwhm(),
            "diameter": lambda a: a.energy_diameter(0.5),
            "square": lambda a: a.ensquared_energy([0.5, 1.5]),
            "circle": lambda a: a.encircled_energy([0.5, 1.5], about="centroid"),
            "strehl": lambda a: a.strehl,
            "peak": lambda a: a.peak_strehl,
            "centroid": lambda a: a.centroid,
            "mtf": lambda a: a.mtf([0.1, 0.2]),
        }
        for name, number in numbers.items():
            whole = number(stack)
            assert whole.shape[:2] == (1, 3), name
            for i in range(3):
                assert whole[0, i] == pytest.approx(number(stack[0, i]), rel=1e-6, abs=1e-9), name


def test_of_long_pixels_a_diameter_may_reach_the_corners_of_the_window():
    psf = lm.psf(lm.Pupil(lm.Wavefront(nonradial={(3, 1): 1.0})), (9, 33), (0.25, 1.5), integrate=True)
    for radius in (1.0, 24.0):
        within = float(energy.encircled_energy(psf, radius))
        found = float(spot.energy_diameter(psf, within))
        assert energy.encircled_energy(psf, 0.5 * found) == pytest.approx(within, rel=3e-8)
        assert found == pytest.approx(2.0 * radius, rel=0.05)


images = st.lists(st.floats(0.0, 10.0), min_size=4, max_size=4)


@given(images, images)
def test_the_error_measures_are_what_the_paper_defines(one: list[float], other: list[float]) -> None:
    values, reference = np.array(one).reshape(2, 2), np.array(other).reshape(2, 2) + 0.5
    peak = max(other) + 0.5
    squares = [(a - b - 0.5) ** 2 for a, b in zip(one, other, strict=True)]
    assert mse(values, reference) == pytest.approx(sum(squares) / 4 / peak**2, rel=1e-12)
    assert lm.peak_error(values, reference) == pytest.approx(math.sqrt(max(squares)) / peak, rel=1e-12)
    assert mse(values, reference) <= lm.peak_error(values, reference) ** 2 * (1 + 1e-12)
    assert mse(reference, reference) == lm.peak_error(reference, reference) == 0.0


def test_the_error_measures_take_psfs_and_do_not_depend_on_their_scale() -> None:
    pupil, method = Pupil(Wavefront(5.0)), ClosedForm()
    pairs = [
        [lm.psf(pupil, 33, 0.4, method=m, normalize=n, dtype=np.float64) for m in (method, Hankel())]
        for n in ("energy", "strehl")
    ]
    for measure in (mse, lm.peak_error):
        assert measure(*pairs[0]) == pytest.approx(measure(*pairs[1]), rel=1e-12)
        assert measure(*pairs[0]) > 1e-4


@pytest.mark.parametrize(
    ("values", "reference", "message"),
    [
        ([1.0, 2.0], [1.0], "must have the same shape"),
        ([1.0, 2.0], [0.0, 0.0], "a positive value"),
    ],
)
def test_errors_of_nothing_are_refused(values: list[float], reference: list[float], message: str) -> None:
    for measure in (mse, lm.peak_error):
        with pytest.raises(ValueError, match=message):
            measure(values, reference)


APERTURES = {
    "annulus": lm.Pupil(lm.Wavefront(nonradial={(2, 2): 1.0}), obscuration=0.3),
    "vlt": lm.Pupil(stop=lm.telescopes.vlt()),
    "jwst": lm.Pupil(stop=lm.telescopes.jwst()),
    "tilted": lm.Pupil(lm.Wavefront(nonradial={(1, 1): 20.0}), spider=lm.Spider.equal(4, 0.03)),
}


@pytest.mark.parametrize("name", APERTURES)
@pytest.mark.parametrize("strength", [4, 30, 60])
def test_the_light_in_a_pixel_and_at_half_of_the_peak(name, strength):
    pupil, side, air = APERTURES[name], 0.8 * strength, lm.Seeing(1.0 / strength)
    pixel = lm.psf(pupil, 3, side, integrate=True, blur=air, tol=1e-6, normalize="energy", dtype="float64")
    exact = pixel.values[1, 1]
    energy = pixel.ensquared_energy(0.5 * side, of="optics")
    assert energy == pytest.approx(exact, abs=1e-5)
    assert pixel.encircled_energy(0.5 * side, of="optics") < energy
    diameter = pixel.energy_diameter(0.5, of="optics", about="centroid")
    assert pixel.encircled_energy(0.5 * diameter, of="optics", about="centroid") == pytest.approx(0.5, abs=1e-5)
    if name == "vlt":  # symmetric about both axes
        for along, shape in (("x", (1, 3)), ("y", (3, 1))):
            step = 0.5 * pixel.fwhm(along, of="optics")
            line = lm.psf(pupil, shape, step, integrate=False, blur=air, tol=1e-6, dtype="float64").values.ravel()
            assert line[0] / line[1] == pytest.approx(0.5, abs=1e-5)


@pytest.mark.parametrize("strength", [30, 150, 1000])
@pytest.mark.parametrize("outer", [None, 3.0])
def test_the_width_of_a_disc_in_any_seeing(strength, outer):
    psf = lm.psf(lm.Pupil(), 9, strength / 9.0, blur=lm.Seeing(1.0 / strength, outer_scale=outer), tol=1e-4)
    air = psf.blur[0]

    def light(r):
        def wave(x):
            f = x**3
            otf = 2.0 / math.pi * (math.acos(f) - f * math.sqrt(1.0 - f * f))
            return otf * float(air.transfer(f)) * special.j0(2.0 * math.pi * f * r) * 3.0 * x**5

        return integrate.quad(wave, 0.0, min(1.0, 6.0 / strength) ** (1 / 3), epsabs=1e-14, limit=400)[0]

    half = optimize.brentq(lambda r: light(r) - 0.5 * light(0.0), 0.1 * strength, strength, xtol=1e-9)
    assert psf.fwhm(of="optics") == pytest.approx(2.0 * half, rel=2e-8)
