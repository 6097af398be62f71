"""Widths along z: against Newton's method on the axis, and what is no stack over z."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm

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
        (lm.psf(lm.Pupil(lm.Wavefront()), 5, 0.3), "this is the PSF of a lens"),
        (made(depth=0.0), "a stack of planes, got one of shape"),
        (made(depth=[0.0, 1e-6], z=0.0), "several depths"),
        (made(depth=[0.0, 1e-6], z=z[:2]), "several depths"),
        (made(depth=0.0, z=z[::-1]), "z must rise"),
        (made(depth=0.0, z=[0.0, 0.0, 1e-7, 2e-7]), "z must rise"),
    ):
        for ask in (lambda of: of.z, lambda of: of.axial_fwhm()):
            with pytest.raises(ValueError, match=said):
                ask(answer)
    with pytest.raises(ValueError, match="takes at least 4 planes, got 3"):
        made(depth=0.0, z=z[:3]).axial_fwhm()
    with pytest.raises(ValueError, match="do not fall to half of the largest on both sides within the stack"):
        made(depth=0.0, z=0.5 * z).axial_fwhm()


def test_rings_beside_the_peak_do_not_count():
    # Deep below the glass there is a second maximum beyond the first, more than half as bright.
    far = np.arange(-20, 60) * STEP
    stack = lm.psf(OIL.pupil(depth=100e-6, z=far, wavelength=WAVE), 3, PIXEL, tol=1e-3, integrate=False)
    line = stack.profile([0.0])[1][:, 0]
    assert np.count_nonzero(np.diff(line > 0.5 * line.max())) == 4
    assert stack.axial_fwhm() == pytest.approx(OIL.focus(100e-6, wavelength=WAVE).axial_fwhm, rel=0.01)
