"""STED: how much is left on the crest, how sharp spots become, what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel import microscopy as room

WATER = lm.Objective(
    NA=1.2,
    magnification=60,
    immersion=1.333,
    working_distance=0.28e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.333,
)


def three(z=0.0, depth=2e-6, depleting="vortex", **other):
    emission = WATER.pupil(depth=depth, z=z, wavelength=680e-9)
    planes = {"depth": depth, "z": emission.focus, "origin": "coverslip"}
    excitation = WATER.pupil(**planes, wavelength=640e-9, emitter=lm.Beam(**other))
    return excitation, WATER.pupil(**planes, wavelength=775e-9, emitter=lm.Beam(depleting)), emission


def test_half_is_left_on_the_crest_at_a_saturation_of_1():
    excitation, doughnut, emission = three()
    window = {"shape": 65, "pixel": 1e-6, "tol": 1e-8}
    crest = lm.psf(doughnut, 65, 1e-6, integrate=False, normalize="strehl").values.argmax()
    confocal = lm.microscopy.confocal(excitation, emission, **window).values.ravel()
    for saturation in (1.0, 3.0):
        left = lm.microscopy.sted(excitation, doughnut, emission, **window, saturation=saturation).values.ravel()
        assert left[crest] / confocal[crest] == pytest.approx(0.5**saturation, rel=1e-3)
        assert left.max() == pytest.approx(confocal.max(), rel=1e-6)


def test_spots_become_sharper_like_the_root_of_the_saturation():
    made = [lm.microscopy.sted(*three(), 9, 1e-6, saturation=s) for s in (0.0, 30.0, 90.0)]
    none, some, more = (float(each.fwhm()) / 60 for each in made)
    assert none == pytest.approx(285.4e-9, abs=0.1e-9)
    # With widths added as those of Gaussians: 1 / w^2 grows by as much for every unit.
    slopes = (some**-2 - none**-2) / 30.0, (more**-2 - none**-2) / 90.0
    assert slopes[0] == pytest.approx(slopes[1], rel=0.01)
    assert max(each.error_bound for each in made) <= 1e-6


def test_planes_out_of_focus_are_dark_for_longer_and_a_polarised_laser_serves():
    # A doughnut leaves all of the axis: the spot is a needle, as long as that of the confocal microscope.
    z = np.linspace(-1e-6, 1e-6, 9)
    excitation, doughnut, emission = three(z, polarization="x")
    needle = lm.microscopy.sted(excitation, doughnut, emission, 17, 2e-6, saturation=10.0)
    plain = lm.microscopy.confocal(excitation, emission, 17, 2e-6)
    assert needle.axial_fwhm() == pytest.approx(float(plain.axial_fwhm()), rel=0.01)
    assert needle.values[:, 8, 8] == pytest.approx(plain.values[:, 8, 8], rel=1e-4)
    assert float(needle[4].fwhm("x")) < 0.45 * float(plain[4].fwhm("x"))


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda ex, de, em: room.sted(ex, de[:1], em, 9, 1e-6, saturation=1.0), r"depletion must have the planes"),
        (
            lambda ex, de, em: room.sted(ex, de[::-1], em, 9, 1e-6, saturation=1.0),
            "depletion must have",
        ),
        (
            lambda ex, de, em: room.sted(ex[::-1], de, em, 9, 1e-6, saturation=1.0),
            "excitation must have",
        ),
        (
            lambda ex, de, em: room.sted(ex, 775e-9, em, 9, 1e-6, saturation=1.0),
            "depletion must be an Obj",
        ),
        (lambda ex, de, em: room.sted(ex, de, em, 9, 1e-6, saturation="strong"), "saturation must be a real number"),
        (lambda ex, de, em: room.sted(ex, de, em, 9, 1e-6, saturation=1e9), "saturation must be >= 0 and <= 10000"),
    ],
)
def test_what_makes_no_psf_is_refused(make, said):
    with pytest.raises((TypeError, ValueError), match=said):
        make(*three(np.array([0.0, 1e-6])))


def test_a_doughnut_without_symmetry_is_refused():
    with pytest.raises(ValueError, match="depletion must not depend on the direction"):
        lm.microscopy.sted(*three(depleting="x"), 9, 1e-6, saturation=1.0)
