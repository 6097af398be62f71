"""The best focus, light through focus, and widths along z."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel import Pupil, Wavefront
from lommel.show.curves import moved, section


@pytest.mark.parametrize("obscuration", [0.0, 0.5])
@pytest.mark.parametrize("radius", [0.5, 1.2, 3.0])
@pytest.mark.parametrize("defocus", [0.0, 0.3, -4.0, 31.7])
def test_the_best_focus_of_a_defocused_lens_takes_the_defocus_away(
    defocus: float, radius: float, obscuration: float
) -> None:
    found = lm.best_focus(Pupil(Wavefront(defocus), obscuration=obscuration), radius)
    assert found == pytest.approx(-defocus, abs=2e-6)


@pytest.mark.parametrize("rms", [0.3, -0.3])
def test_the_best_focus_of_little_spherical_aberration_balances_it(rms: float) -> None:
    """For small aberrations and a small spot, least variance is most light: the Zernike balance."""
    balanced = Wavefront.balanced_spherical(rms)
    found = lm.best_focus(Pupil(Wavefront(0.0, balanced.spherical)), 0.05)
    assert found == pytest.approx(float(balanced.defocus), rel=0.01)


def test_what_is_not_round_has_no_best_focus_in_a_circle_and_no_profile():
    coma = lm.Pupil(lm.Wavefront(2.0, nonradial={(3, 1): 4.0}))
    for pupil in (coma, lm.Pupil(stop=lm.Polygon.regular(6, 1.0))):
        with pytest.raises(ValueError, match="pupil must be radially symmetric, got a wavefront or an aperture"):
            lm.best_focus(pupil, 1.0)
    with pytest.raises(ValueError, match="radius must be None for a pupil that is not radial"):
        lm.psf(coma, 5, 0.1).profile(1.0)


X = np.linspace(-3.0, 3.0, 13)


def test_the_light_on_the_axis_is_that_of_defocus():
    shifts, stack = moved(lm.Pupil(), reach=6.0, count=25)
    values = section(stack, X)
    assert values.shape == (25, 13)
    np.testing.assert_array_equal(shifts, np.linspace(-6.0, 6.0, 25))
    np.testing.assert_allclose(values[:, 6], np.sinc(shifts / math.pi) ** 2, atol=2e-6)
    airy = lm.psf(lm.Pupil(), (1, 13), 0.5, normalize="strehl").values[0]
    np.testing.assert_allclose(values[12], airy, atol=2e-6)


def test_the_defocus_of_a_sensor_that_moves_little_is_that_of_the_lens(camera):
    shifts, stack = moved(camera.pupil(1.9), reach=20e-6, count=5)
    # C_d = (pi / (2 lambda)) (1/d - 1/f + 1/s) R^2 with the sensor at d.
    d, radius = camera.sensor_distance + shifts, 0.5 * camera.aperture_diameter
    exact = math.pi / (2.0 * 550e-9) * (1.0 / d - 1.0 / 50e-3 + 1.0 / 1.9) * radius**2
    np.testing.assert_allclose(stack.wavefront.defocus, exact, rtol=1e-3)


@pytest.mark.parametrize("options", [{}, {"spider": lm.Spider.equal(3, width=0.1)}], ids=["round", "spider"])
def test_light_of_any_wavefront_is_that_of_its_psf(options):
    coma = lm.Pupil(lm.Wavefront(0.5, nonradial={(3, 1): 1.0}), wavelength=500e-9, f_number=4.0, **options)
    _, stack = moved(coma, reach=40e-6, count=3)
    values = section(stack, 1e-6 * X)
    exact = lm.psf(stack, (1, 13), 0.5e-6, integrate=False, normalize="strehl").values[:, 0]
    np.testing.assert_allclose(values, exact, atol=3e-6)
    # The focus of the sensor moved away from the lens is that of more defocus.
    np.testing.assert_allclose(
        stack.wavefront.defocus, 0.5 + np.array([1, 0, -1]) * math.pi * 40e-6 / (8 * 5e-7 * 16)
    )


@pytest.mark.parametrize("wavefront", [lm.Wavefront(), lm.Wavefront(20.0), lm.Wavefront(-15.0, 10.0)], ids=str)
def test_by_default_each_zone_has_its_focus_in_between_and_so_has_the_sensor(wavefront):
    _, stack = moved(lm.Pupil(wavefront), count=41)
    added = stack.wavefront.defocus - wavefront.defocus
    assert added.min() < 0.0 < added.max()
    middle, rim = -wavefront.defocus, -wavefront.defocus - wavefront.spherical
    assert added.min() < min(middle, rim)
    assert added.max() > max(middle, rim)


OIL = lm.Objective(
    NA=1.4,
    magnification=63,
    immersion=1.515,
    working_distance=0.19e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.33,
)
WAVE, PIXEL = 610e-9, 6.5e-6
STEP = 0.5 * OIL.nyquist(wavelength=WAVE).axial


@pytest.mark.parametrize("shift", [0.0, 0.23, 0.5])
@pytest.mark.parametrize(("depth", "planes"), [(1e-6, 16), (5e-6, 24)])
def test_the_width_along_z_is_that_of_the_focus(depth, planes, shift):
    z = (np.arange(planes) - planes // 2 + shift) * STEP
    stack = lm.psf(OIL.pupil(depth=depth, z=z, wavelength=WAVE), 3, PIXEL, tol=1e-4)
    assert stack.axial_fwhm() == pytest.approx(OIL.focus(depth, wavelength=WAVE).axial_fwhm, rel=0.01)
    assert stack.z == pytest.approx(z)


def test_several_stacks_have_a_width_each():
    z = np.arange(-12, 13) * STEP
    stack = lm.psf(OIL.pupil(depth=[[1e-6], [5e-6]], z=z, wavelength=WAVE), 3, PIXEL, tol=1e-4)
    assert stack.axial_fwhm() == pytest.approx([757e-9, 1131e-9], rel=0.01)
    assert stack.z.shape == (2, 25)
    assert stack[1].axial_fwhm() == pytest.approx(stack.axial_fwhm()[1])


def test_a_dipole_is_measured_by_its_brightest_pixel():
    z = np.arange(-10, 11) * STEP
    # Upright, it is dark on the axis.
    pupil = OIL.pupil(depth=1e-6, z=z, wavelength=WAVE, emitter=lm.Dipole(0.2, 0.0))
    stack = lm.psf(pupil, 15, PIXEL, tol=1e-3)
    width = float(stack.axial_fwhm())
    k = np.unravel_index(stack.values.argmax(), stack.shape)
    line = stack.values[:, k[1], k[2]]
    inside = np.flatnonzero(line > 0.5 * line.max())
    assert abs(width - STEP * (np.ptp(inside) + 1.0)) < STEP


def test_what_is_no_stack_over_z_is_refused():
    def made(**given):
        return lm.psf(OIL.pupil(wavelength=WAVE, **given), 3, PIXEL, tol=1e-3)

    z = np.arange(-3, 4) * 0.1e-6
    for answer, said in (
        (lm.psf(lm.Pupil(lm.Wavefront()), 5, 0.3), "got the PSF of a lens"),
        (made(depth=0.0), "at least two planes z, got one of shape"),
        (made(depth=[0.0, 1e-6], z=0.0), "several depths"),
        (made(depth=[0.0, 1e-6], z=z[:2]), "several depths"),
        (made(depth=0.0, z=z[::-1]), "z must increase"),
        (made(depth=0.0, z=[0.0, 0.0, 1e-7, 2e-7]), "z must increase"),
    ):
        for ask in (lambda of: of.z, lambda of: of.axial_fwhm()):
            with pytest.raises(ValueError, match=said):
                ask(answer)
    with pytest.raises(ValueError, match="needs at least 4 planes, got 3"):
        made(depth=0.0, z=z[:3]).axial_fwhm()
    with pytest.raises(ValueError, match="must extend in z until the light falls to half of its maximum"):
        made(depth=0.0, z=0.5 * z).axial_fwhm()


def test_rings_beside_the_peak_do_not_count():
    # Deep below the glass there is a second maximum beyond the first, more than half as bright.
    far = np.arange(-20, 60) * STEP
    stack = lm.psf(OIL.pupil(depth=100e-6, z=far, wavelength=WAVE), 3, PIXEL, tol=1e-3, integrate=False)
    line = stack.profile([0.0])[1][:, 0]
    assert np.count_nonzero(np.diff(line > 0.5 * line.max())) == 4
    assert stack.axial_fwhm() == pytest.approx(OIL.focus(100e-6, wavelength=WAVE).axial_fwhm, rel=0.01)
