"""Encircled energy of any pupil: against quadrature of profiles, and against the light of every direction."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.measures.energy import encircled, radial_energy

RADII = np.array([0.0, 0.3, 1.0, 2.5, 6.0, 15.0])


@pytest.mark.parametrize("eps", [0.0, 0.4])
@pytest.mark.parametrize("tol", [1e-5, 1e-8, 1e-10])
def test_weights_on_pixels_integrate_a_radial_image_within_the_bound(eps, tol):
    radial = lm.Pupil(lm.Wavefront(4.0, 2.0), obscuration=eps)
    # So little astigmatism that it changes nothing, but that the pupil goes the way of all others.
    nearly = lm.Pupil(radial.wavefront + lm.Wavefront(nonradial={(2, 2): 1e-14}), obscuration=eps)
    exact = radial_energy(lm.Hankel(), radial, RADII)
    found = encircled(nearly, RADII, method=lm.NijboerZernike(tol))
    assert np.abs(found.fraction - exact).max() <= found.error
    assert found.error < 3.1e-8 + 2e3 * tol
    assert found.fraction[0] == 0.0
    if tol == 1e-10:
        # What is claimed of the weights themselves.
        np.testing.assert_allclose(found.fraction, exact, atol=3e-8)


def test_a_radial_pupil_takes_no_image():
    found = encircled(lm.Pupil(lm.Wavefront(4.0)), RADII)
    np.testing.assert_allclose(
        found.fraction, radial_energy(lm.Hankel(), lm.Pupil(lm.Wavefront(4.0)), RADII), atol=1e-6
    )


def test_a_tilted_airy_pattern_has_the_energy_of_a_circle_off_its_centre():
    shift, radius = 0.8, 1.5
    pupil = lm.Pupil(lm.Wavefront(nonradial={(1, 1): np.pi * shift}))
    found = encircled(pupil, [radius], method=lm.NijboerZernike(1e-10))
    # In polar coordinates about the peak: the arc of each ring that the circle holds.
    x, w = np.polynomial.legendre.leggauss(400)
    low, high = radius - shift, radius + shift
    r = low + (high - low) * (0.5 - 0.5 * np.cos(0.5 * np.pi * (x + 1)))
    jacobian = 0.25 * np.pi * (high - low) * np.sin(0.5 * np.pi * (x + 1))
    arc = np.arccos(np.clip((r**2 + shift**2 - radius**2) / (2 * r * shift), -1, 1)) / np.pi
    intensity = lm.Hankel().profile(lm.Pupil(), np.pi * np.sort(r)).values[0]
    ring = w * jacobian * 0.5 * np.pi**2 * r * intensity[np.argsort(np.argsort(r))]
    inner = float(radial_energy(lm.Hankel(), lm.Pupil(), low))
    assert found.fraction[0] == pytest.approx(inner + float(ring @ arc), abs=1e-7)


def test_metres_and_units_of_lambda_n_agree():
    coma = lm.Wavefront(nonradial={(3, 1): 1.5})
    plain = encircled(lm.Pupil(coma), [2.0])
    metric = encircled(lm.Pupil(coma, wavelength=5e-7, f_number=4.0), [2.0 * 2e-6])
    np.testing.assert_allclose(metric.fraction, plain.fraction, rtol=1e-6)


def test_an_aperture_with_vanes_has_energies_with_a_bound():
    pupil = lm.Pupil(obscuration=0.3, spider=lm.Spider.equal(4, 0.1))
    found = encircled(pupil, [1.0, 3.0])
    tighter = encircled(pupil, [1.0, 3.0], method=lm.NonuniformFFT(1e-10))
    assert np.abs(found.fraction - tighter.fraction).max() < found.error < 1e-4
    # The middle of pixels of a twentieth, summed as if each held its value all over it.
    image = lm.psf(pupil, 161, 0.05, method=lm.NonuniformFFT(1e-8))
    within = np.hypot(*np.meshgrid(image.grid.x, image.grid.y)) < np.array([1.0, 3.0])[:, None, None]
    np.testing.assert_allclose(found.fraction, (image.values * within).sum(axis=(1, 2)), atol=1e-2)


@pytest.mark.parametrize(
    ("radius", "what"),
    [(-1.0, "radius must be finite and >= 0, got -1"), (np.nan, "radius must be finite"), (251.0, "at most 250")],
)
def test_what_makes_no_sense_is_refused(radius, what):
    with pytest.raises(ValueError, match=what):
        encircled(lm.Pupil(lm.Wavefront(nonradial={(3, 1): 1.0})), [radius])


def test_a_stack_is_refused():
    with pytest.raises(ValueError, match="pupil must be a single one"):
        encircled(lm.Pupil(lm.Wavefront([1.0, 2.0])), [1.0])


@pytest.mark.parametrize(
    "pupil", [lm.Pupil(), lm.Pupil(lm.Wavefront(nonradial={(3, 1): 1.0}))], ids=["round", "coma"]
)
def test_what_is_no_method_is_refused_by_name_for_every_pupil(pupil):
    with pytest.raises(TypeError, match="method must be a Method"):
        encircled(pupil, [1.0], method="NijboerZernike")
