"""The image that values are samples of: by two roads, against averages around any axis, and continuous."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import integrate, optimize, special

import lommel as lm
from lommel.measures.continuous_image import (
    ImageModel,
    cartesian_images,
    images,
    polar_images,
    sampled_transfer,
)
from lommel.methods import NijboerZernike, NonuniformFFT, Polychromatic
from window_transform import window_transform

LAMBDA, F_NUMBER = 550e-9, 4.0
BLURS = {
    "none": (),
    "jitter": (lm.Jitter(1.1, across=0.4, angle=0.5),),
    "motion": (lm.Motion(3.0, angle=1.0), lm.Jitter(0.3)),
}
RADII = np.array([0.0, 0.4, 1.3, 3.0, 6.0, 20.0])


def camera(defocus=2.0, **nonradial):
    coma = {(3, 1): nonradial.get("coma", 0.0)}
    return lm.Pupil(lm.Wavefront(defocus, nonradial=coma), wavelength=LAMBDA, f_number=F_NUMBER)


# Two roads to one image: the overlap of the aperture with itself, and samples of the intensity.


@pytest.mark.parametrize("blur", BLURS)
@pytest.mark.parametrize("active", [(0.0, 0.0), (2.0, 3.45)])
@pytest.mark.parametrize("eps", [0.0, 0.35])
@pytest.mark.parametrize("defocus", [0.0, 2.0, 17.0])
def test_transfer_functions_and_samples_give_one_image(defocus, eps, active, blur):
    model = ImageModel(lm.Pupil(lm.Wavefront(defocus), obscuration=eps), NijboerZernike(1e-10), BLURS[blur], active)
    polar, cartesian = next(polar_images(model, 20.0)), next(cartesian_images(model, 20.0))
    np.testing.assert_allclose(polar.circles(RADII), cartesian.circles(RADII), rtol=0, atol=2e-9)
    for low, high in (((-2.0, -1.5), (1.0, 3.0)), ((0.5, -4.0), (6.0, -1.0))):
        assert polar.rectangle(low, high) == pytest.approx(cartesian.rectangle(low, high), abs=2e-9)


def test_seeing_has_no_end_and_is_within_what_is_said_of_it():
    model = ImageModel(lm.Pupil(lm.Wavefront(1.0)), NijboerZernike(), (lm.Seeing(0.12),), (1.0, 1.0))
    polar, cartesian = next(polar_images(model, 60.0)), next(cartesian_images(model, 60.0))
    radii = np.array([3.0, 10.0, 30.0, 60.0])
    np.testing.assert_allclose(polar.circles(radii), cartesian.circles(radii), rtol=0, atol=1e-5)


def test_white_light_is_the_sum_of_its_wavelengths():
    pupil = camera(1.5)
    white = Polychromatic([450e-9, 550e-9, 650e-9], [1.0, 2.0, 1.0])
    for blur in ((), (lm.Seeing(0.05, focal_length=1.0, wavelength=500e-9),)):
        model = ImageModel(pupil, white, blur, (2e-6, 2e-6))
        found = next(images(model, 8.0)).circles(RADII[1:5])
        parts = [ImageModel(pupil.in_light(w), NijboerZernike(), blur, (2e-6, 2e-6)) for w in white.wavelengths]
        # Lengths are in lambda*N of each light.
        each = [next(images(p, 12.0)).circles(RADII[1:5] * pupil.scale / p.pupil.scale) for p in parts]
        np.testing.assert_allclose(found, np.tensordot(white.weights, each, 1), rtol=0, atol=1e-8)
        np.testing.assert_allclose(next(cartesian_images(model, 8.0)).circles(RADII[1:5]), found, rtol=0, atol=1.1e-5)


# What the image is, from elsewhere.


@pytest.mark.parametrize("side", [0.6, 3.45])
def test_the_image_at_a_point_is_what_a_pixel_there_averages(side):
    """Pixels around other axes, by engines that know neither transforms nor transfer functions of an image."""
    pupil = lm.Pupil(lm.Wavefront(2.0, nonradial={(3, 1): 1.5, (2, -2): 0.7}), obscuration=0.2)
    (image,) = cartesian_images(ImageModel(pupil, NijboerZernike(1e-9), (), (side, side)), 6.0)
    for x, y in ((0.0, 0.0), (0.3, -1.1), (2.2, 1.7)):
        value = lm.psf(pupil, 1, side, integrate=True, center=(-y / side, -x / side), tol=1e-9).values[0, 0]
        assert image.on(np.array([x]), np.array([y]))[0, 0] * side**2 == pytest.approx(value, abs=1e-8)
        assert image.derivatives(x, y)[0, 0] == pytest.approx(image.on(np.array([x]), np.array([y]))[0, 0], rel=1e-9)


def test_derivatives_are_limits_of_differences():
    (image,) = cartesian_images(ImageModel(lm.Pupil(lm.Wavefront(nonradial={(3, 1): 1.0})), NijboerZernike()), 4.0)
    here, h = image.derivatives(0.4, -0.3), 1e-4
    right, left = image.derivatives(0.4 + h, -0.3), image.derivatives(0.4 - h, -0.3)
    below, above = image.derivatives(0.4, -0.3 + h), image.derivatives(0.4, -0.3 - h)
    np.testing.assert_allclose(here[:, 1:], ((right - left) / (2 * h))[:, :2], rtol=1e-5, atol=1e-5)
    np.testing.assert_allclose(here[1:], ((below - above) / (2 * h))[:2], rtol=1e-5, atol=1e-5)


@pytest.mark.parametrize("radius", [1.0, 3.0])
def test_the_light_in_a_circle_is_an_integral_of_textbook_transfer_functions(radius):
    """The Airy pattern behind square pixels: adaptive quadrature of Hopkins' closed form times the pixel's sinc."""
    side = 2.5
    angles = np.linspace(0.0, 0.5 * math.pi, 401)

    def integrand(f):
        otf = 2.0 / math.pi * (math.acos(f) - f * math.sqrt(1.0 - f * f))
        pixel = integrate.simpson(np.sinc(f * side * np.cos(angles)) * np.sinc(f * side * np.sin(angles)), x=angles)
        return otf * pixel / (0.5 * math.pi) * 2.0 * math.pi * radius * special.j1(2.0 * math.pi * radius * f)

    expected = integrate.quad(integrand, 0.0, 1.0, epsabs=1e-11, limit=200)[0]
    psf = lm.psf(lm.Pupil(), 5, side, integrate=True)
    assert psf.encircled_energy(radius) == pytest.approx(expected, abs=1e-8)


def test_a_gaussian_much_wider_than_the_optics_has_its_own_width_and_energies():
    sigma = 20.0
    psf = lm.psf(lm.Pupil(), 3, 20.0, blur=lm.Jitter(sigma), integrate=False, tol=1e-3)
    assert psf.fwhm() == pytest.approx(2.0 * math.sqrt(2.0 * math.log(2.0)) * sigma, rel=5e-3)
    radius = np.array([5.0, 20.0, 40.0])
    np.testing.assert_allclose(psf.encircled_energy(radius), 1 - np.exp(-(radius**2) / (2 * sigma**2)), atol=7e-3)
    assert psf.energy_diameter(0.5) == pytest.approx(2 * sigma * math.sqrt(2 * math.log(2)), rel=1e-2)


def test_a_jitter_along_x_leaves_what_is_fine_along_y():
    sigma, x = 2.0, np.linspace(-18.0, 18.0, 36_001)
    weight = np.exp(-((x / sigma) ** 2) / 2.0)

    def light(y):
        v = math.pi * np.hypot(x, y)
        return weight @ (2.0 * special.j1(v) / v) ** 2

    half = optimize.brentq(lambda y: light(y) - 0.5 * light(1e-12), 0.1, 2.0)
    psf = lm.psf(lm.Pupil(), 5, 0.25, blur=lm.Jitter(sigma, 0.0))
    assert psf.fwhm("y") == pytest.approx(2.0 * half, rel=1e-8)


def test_transfer_functions_from_samples_are_those_of_the_wavefront():
    f = np.array([0.0, 0.02, 0.07, 0.2, 0.5, 0.9, 1.2])
    for wavefront in (lm.Wavefront(), lm.Wavefront(3.0, nonradial={(3, 1): 2.0})):
        pupil = lm.Pupil(wavefront, obscuration=0.2)
        found = sampled_transfer(ImageModel(pupil, NijboerZernike()), f, 0.3 * f)[0]
        difference = np.abs(found - lm.otf(pupil, f, 0.3 * f))
        assert difference[0] < 1e-12
        assert difference[1:3].max() < 3e-4
        assert difference[3:].max() < 3e-5


# What an engineer, an astronomer and a microscopist ask.


def test_the_contrast_of_a_lens_in_focus_on_a_sensor():
    lens = lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
    psf = lm.psf(lens.pupil(2.0), 81, 3.45e-6)
    assert psf.mtf(0.5 / 3.45e-6) == pytest.approx(0.518, abs=1e-3)
    assert psf.mtf(50e3) == pytest.approx(0.890, abs=1e-3)
    # A perfect lens, by Hopkins' closed form and the pixel's sinc.
    phone, pixel = lm.Pupil(wavelength=550e-9, f_number=1.8), 1.22e-6
    f = 0.5 / pixel * phone.scale
    exact = 2 / math.pi * (math.acos(f) - f * math.sqrt(1 - f * f)) * 2 / math.pi
    assert lm.psf(phone, 257, pixel).mtf(0.5 / pixel) == pytest.approx(exact, abs=1e-9)
    assert exact == pytest.approx(0.317, abs=1e-3)


@pytest.mark.parametrize("options", ["round", "coma", "vanes", "blurred", "white", "mask"])
@pytest.mark.parametrize("pixel", [0.3, 0.5, 1.0, 2.0, 5.0])
def test_contrast_does_not_alias_whatever_the_pixel(pixel, options):
    pupil = {
        "coma": camera(coma=1.0),
        "vanes": lm.Pupil(spider=lm.Spider.equal(3, width=0.02), wavelength=LAMBDA, f_number=F_NUMBER),
        "mask": lm.Pupil(mask=lm.Mask.sample(lambda x, y: 1 - x**2, 128), wavelength=LAMBDA, f_number=F_NUMBER),
    }.get(options, camera())
    how = {
        "blurred": {"blur": lm.Jitter(1e-6)},
        "white": {"method": Polychromatic([500e-9, 600e-9], [1, 1])},
    }.get(options, {})
    side = pixel * pupil.scale
    psf = lm.psf(pupil, 9, side, tol=1e-4 if options == "blurred" else None, **how)
    f = np.array([0.1, 0.37]) / pupil.scale
    if options == "mask":
        fine = lm.psf(pupil, 513, 0.25 * pupil.scale, integrate=False)
        np.testing.assert_allclose(psf.mtf(f), np.abs(window_transform(fine, f) * np.sinc(f * side)), atol=2e-3)
        return
    blur, spectrum = how.get("blur", ()), how.get("method")
    exact = lm.mtf(pupil, f, pixel=side, blur=blur, spectrum=spectrum, tol=1e-6)
    np.testing.assert_allclose(psf.mtf(f), exact, atol=2e-6)
    np.testing.assert_allclose(lm.mtf(psf, f, tol=1e-6), exact, atol=2e-6)
    np.testing.assert_allclose(psf.mtf(f, of="optics") * np.abs(np.sinc(f * side)), exact, atol=2e-6)


def test_a_star_in_seeing_has_its_light_beyond_the_window():
    """0.8 m at f/10 with a third obscured, 1.2 arcsec: the circle of 0.5 mm holds 99.5 % whatever the window."""
    telescope = lm.Pupil(obscuration=0.3, wavelength=550e-9, f_number=10.0)
    air = lm.Seeing.from_fwhm(1.2 * math.pi / 648000, focal_length=8.0, wavelength=550e-9)
    model = ImageModel(telescope, NijboerZernike(), (air,))

    def exact(radius):  # Hankel quadrature of its own, over Gauss nodes
        x, w = np.polynomial.legendre.leggauss(600)
        f = 0.25 * (x + 1)  # what seeing leaves ends before half of the cutoff
        otf = lm.otf(telescope, f / telescope.scale).real * air.transfer(f / telescope.scale, wavelength=550e-9)
        r = radius / telescope.scale
        return 0.25 * w @ (otf * 2 * math.pi * r * special.j1(2 * math.pi * r * f))

    radii = np.array([100e-6, 200e-6, 500e-6])
    found = next(images(model, 500e-6 / telescope.scale)).circles(radii / telescope.scale)
    np.testing.assert_allclose(found, [exact(r) for r in radii], atol=1e-6)
    assert found[2] == pytest.approx(0.995, abs=1e-3)
    small = lm.psf(telescope, 33, 3.8e-6, blur=air, tol=1e-3)
    np.testing.assert_allclose(small.encircled_energy(radii, of="optics"), found, atol=1e-6)


def test_vanes_and_seeing_answer_far_out():
    vanes = lm.Pupil(obscuration=0.3, spider=lm.Spider.equal(4, width=0.02), wavelength=600e-9, f_number=8.0)
    air = lm.Seeing.from_fwhm(0.4 * math.pi / 648000, focal_length=8.0, wavelength=600e-9)
    model = ImageModel(vanes, NonuniformFFT(1e-5), (air,))
    plain = ImageModel(lm.Pupil(obscuration=0.3), NijboerZernike())
    (image,) = cartesian_images(model, 160.0)
    # Far out the light beyond falls as the reciprocal, more of it where edges are straight.
    missing = 1.0 - image.circles(np.array([80.0, 160.0]))
    assert missing[0] == pytest.approx(2.0 * missing[1], rel=0.1)
    assert missing[1] > 1.0 - next(polar_images(plain, 160.0)).circles(np.array([160.0]))[0]


def test_channels_have_the_contrast_of_their_own_light():
    lens = lm.Lens(focal_length=4.3e-3, f_number=1.8, focus_distance=1.2, wavelength=550e-9)
    rgb = lm.colour_psf(lens.pupil(1.2), 65, 1.22e-6)
    assert [one.pupil.wavelength for one in rgb] == list(lm.Channels.rgb().wavelengths)
    assert [lm.mtf(one.pupil, 300e3) for one in rgb] == pytest.approx([0.593, 0.6325, 0.6855], abs=1e-3)
    np.testing.assert_allclose(rgb.mtf(300e3, of="optics"), [lm.mtf(one.pupil, 300e3) for one in rgb], rtol=1e-9)
    np.testing.assert_allclose(lm.mtf(rgb, 300e3), rgb.mtf(300e3), rtol=1e-12)
    assert rgb.fwhm().shape == rgb.energy.shape == rgb.strehl.shape == (3,)
    assert np.all(np.diff(rgb.fwhm(of="optics")) < 0)
    # In focus the peak is that without aberration in each light, and the values sum to the light in the window.
    np.testing.assert_allclose(rgb.strehl, 1.0, atol=1e-9)
    np.testing.assert_allclose(rgb.energy, rgb.values.sum(axis=(1, 2)), rtol=1e-6)
    for one in rgb:
        exact = 2 / math.pi * (np.arccos(f := 300e3 * one.pupil.scale) - f * math.sqrt(1 - f * f))
        assert one.mtf(300e3, of="optics") == pytest.approx(exact, abs=1e-6)


def test_a_grid_answers_for_every_place_and_channel():
    field = lm.FieldMap.from_seidel(20e-3, W131=1.0, W222=0.6, wavelength=550e-9, f_number=2.0)
    grid = field.grid(2, 3, sensor=(20e-3, 30e-3), shape=17, pixel=2e-6)
    assert grid.mtf([50e3, 100e3]).shape == (2, 3, 2)
    assert grid.mtf(50e3)[1, 2] == pytest.approx(lm.mtf(grid.psf.pupil[1, 2], 50e3, pixel=2e-6), abs=1e-9)
    assert grid.encircled_energy(4e-6)[0, 1] == pytest.approx(grid[0, 1].encircled_energy(4e-6), rel=1e-9)
    colour = field.grid(2, 3, sensor=(20e-3, 30e-3), shape=17, pixel=2e-6, channels=lm.Channels.rgb())
    assert colour.mtf(50e3).shape == (2, 3, 3)
    assert colour.fwhm("x")[1, 0, 2] == pytest.approx(colour.psf["blue"][1, 0].fwhm("x"), rel=1e-9)


# Continuity: what physics does not change does not change.


@settings(max_examples=12, deadline=None)
@given(st.floats(-12.0, 12.0), st.floats(0.5e-6, 8e-6), st.sampled_from([0.0, 0.4]))
def test_nor_does_it_for_any_defocus_and_pixel(defocus, pixel, eps):
    made = [
        lm.Pupil(
            lm.Wavefront(defocus, nonradial={(3, 1): c} if c else {}),
            obscuration=eps,
            wavelength=LAMBDA,
            f_number=F_NUMBER,
        )
        for c in (0.0, 1e-9)
    ]
    radial, coma = (lm.psf(pupil, 9, pixel) for pupil in made)
    for measure in (
        lambda p: p.encircled_energy(3e-6),
        lambda p: p.mtf(40e3),
        lambda p: p.fwhm("y") / p.pupil.scale,
    ):
        assert measure(coma) == pytest.approx(measure(radial), rel=1e-5, abs=1e-6)
    # Near a dark ring the energy hardly changes with the diameter: each has 0.8 within the diameter of the other.
    for one, other in ((coma, radial), (radial, coma)):
        assert one.encircled_energy(0.5 * other.energy_diameter(0.8)) == pytest.approx(0.8, abs=1e-6)


@pytest.mark.parametrize("coma", [0.0, 1.3])
def test_of_the_optics_neither_pitch_nor_window_matter(coma):
    first, *others = (
        lm.psf(camera(coma=coma), side, pixel, integrate=averaged)
        for side, pixel, averaged in ((65, 0.5e-6, True), (5, 0.5e-6, False), (3, 9e-6, True), (4, 9e-6, False))
    )
    for measure in (
        lambda p: p.fwhm(of="optics"),
        lambda p: p.encircled_energy([1e-6, 5e-6, 80e-6], of="optics"),
        lambda p: p.ensquared_energy(4e-6, about="centroid", of="optics"),
        lambda p: p.energy_diameter(0.8, of="optics"),
        lambda p: p.centroid + 1e-6,
        lambda p: p.mtf(77e3, of="optics"),
    ):
        for other in others:
            np.testing.assert_allclose(measure(other), measure(first), rtol=1e-6)


def test_a_dipole_that_wobbles_all_but_freely_is_as_wide_as_one_that_does():
    objective = lm.Objective(
        NA=1.4,
        magnification=60,
        immersion=1.518,
        working_distance=0.19e-3,
        coverslip=lm.Layer(1.5255, 170e-6),
        sample=1.33,
    )
    free, nearly = (
        lm.psf(objective.pupil(depth=1e-6, wavelength=520e-9, emitter=emitter), 25, 6.5e-6)
        for emitter in ("isotropic", lm.Dipole(0.4, 0.3, wobble=0.999999))
    )
    assert free.fwhm() / 60 == pytest.approx(242.1e-9, rel=1e-3)
    assert nearly.fwhm() == pytest.approx(free.fwhm(), rel=1e-4)
    assert nearly.encircled_energy(20e-6) == pytest.approx(free.encircled_energy(20e-6), abs=1e-5)
    assert nearly.mtf(20e3) == pytest.approx(free.mtf(20e3), abs=1e-5)
    z = np.linspace(-1e-6, 1e-6, 15)
    deep = [
        lm.psf(objective.pupil(depth=1e-6, z=z, wavelength=520e-9, emitter=emitter), 9, 6.5e-6)
        for emitter in ("isotropic", lm.Dipole(0.4, 0.3, wobble=0.999999))
    ]
    assert deep[1].axial_fwhm() == pytest.approx(deep[0].axial_fwhm(), rel=1e-4)
    assert deep[1].axial_fwhm(of="optics") == pytest.approx(deep[0].axial_fwhm(of="optics"), rel=1e-4)
    # Pixels mix light of rings with that of the axis.
    assert deep[0].axial_fwhm() != pytest.approx(deep[0].axial_fwhm(of="optics"), rel=1e-3)


def test_a_dark_middle_does_not_make_the_width_jump():
    for defocus in (math.pi, 2 * math.pi, 3.3):
        radial, coma = (lm.psf(camera(defocus, coma=c), 33, 0.5e-6) for c in (0.0, 1e-9))
        assert coma.fwhm("x") == pytest.approx(radial.fwhm("x"), rel=1e-5)
        assert radial.fwhm("x", of="optics") == pytest.approx(coma.fwhm("y", of="optics"), rel=1e-6)


def test_the_width_is_the_extent_of_what_is_brighter_than_half():
    """Astigmatism at 45 degrees: a tilted spot, whose extent along x is found by brute force."""
    pupil = lm.Pupil(lm.Wavefront(0.5, nonradial={(2, -2): 2.0, (3, 1): 1.0}))
    fine = lm.psf(pupil, 401, 0.02, tol=1e-8).values
    bright = fine >= 0.5 * fine.max()
    across, down = np.flatnonzero(bright.any(axis=0)), np.flatnonzero(bright.any(axis=1))
    psf = lm.psf(pupil, 5, 0.25)
    assert psf.fwhm("x") == pytest.approx(0.02 * (np.ptp(across) + 1), abs=0.04)
    assert psf.fwhm("y") == pytest.approx(0.02 * (np.ptp(down) + 1), abs=0.04)
    assert psf.fwhm() == pytest.approx(0.5 * (psf.fwhm("x") + psf.fwhm("y")), rel=1e-12)


def test_rays_have_a_width_and_no_energies():
    psf = lm.psf(lm.Pupil(lm.Wavefront(12.0)), 65, 0.5, method="geometric")
    assert psf.fwhm() == pytest.approx(2 * 4 * 12.0 / math.pi, rel=2e-3)
    with pytest.raises(ValueError, match="method must compute diffraction"):
        psf.encircled_energy(3.0)


def test_what_makes_no_sense_is_refused():
    psf = lm.psf(camera(coma=1.0), 9, 1e-6)
    with pytest.raises(
        ValueError, match=r"a distance of 0\.01 m from the axis .* use a smaller distance of at most 0\.0016"
    ):
        psf.encircled_energy(1e-2)
    with pytest.raises(ValueError, match="pixel must be left out for a PSF, which includes it; or pass"):
        lm.mtf(psf, 1e4, pixel=1e-6)
    with pytest.raises(ValueError, match="spectrum must be left out for a PSF"):
        lm.otf(psf, 1e4, spectrum=Polychromatic([5e-7], [1.0]))


def test_the_frequency_of_half_contrast_is_that_of_the_image():
    psf = lm.psf(camera(coma=1.0), 9, 3.45e-6, blur=lm.Jitter(0.5e-6), tol=1e-4)
    f = lm.mtf_frequency(psf, 0.3)
    assert psf.mtf(f) == pytest.approx(0.3, abs=1e-8)
    white = lm.psf(camera(), 9, 1e-6, method=Polychromatic([450e-9, 650e-9], [1, 1]))
    assert white.mtf(lm.mtf_frequency(white)) == pytest.approx(0.5, abs=1e-8)
