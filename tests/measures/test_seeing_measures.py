"""Widths and energies of images in seeing, against images with a proven bound and closed transfer functions."""

from __future__ import annotations

import math

import pytest
from scipy import integrate, optimize, special

import lommel as lm

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


def test_pixels_and_wavelengths_count():
    telescope = lm.Pupil(stop=lm.telescopes.vlt(), wavelength=600e-9, f_number=15.0)
    air = lm.Seeing(0.2, 120.0, 500e-9, outer_scale=22.0)
    white = lm.Polychromatic([500e-9, 700e-9], [1.0, 2.0])
    several = lm.psf(telescope, 3, 300e-6, blur=(air, lm.Motion(1e-4, 0.3)), method=white, tol=1e-5, dtype="float64")
    assert several.ensquared_energy(150e-6, of="optics") == pytest.approx(several.values[1, 1], abs=2e-5)
    one = lm.psf(telescope, 3, 300e-6, blur=air, tol=1e-4)
    assert one.fwhm() > 1.05 * one.fwhm(of="optics")
    stack = lm.psf(
        lm.Pupil(lm.Wavefront([0.0, 9.0]), stop=lm.telescopes.vlt()), 3, 9.0, blur=lm.Seeing(0.1), tol=1e-4
    )
    assert stack.fwhm()[1] > stack.fwhm()[0]
    assert stack.fwhm()[0] == stack[0].fwhm()


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
