"""Every bad input of a microscope: a sentence that names the argument, the value, and the way out."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

import lommel as lm
from cases import each
from lommel.optics.layers.stratified import Design

GLASS = lm.Layer(1.5255, 170e-6)
OBJECTIVE = {
    "NA": 1.4,
    "magnification": 63,
    "immersion": 1.518,
    "working_distance": 0.19e-3,
    "coverslip": GLASS,
    "sample": 1.33,
}
PUPIL = {"depth": 2e-6, "z": 0.0, "wavelength": 520e-9, "origin": "paraxial", "emitter": "scalar"}
WINDOW = {"shape": 3, "pixel": 6.5e-6}


def psf(**changes) -> lm.PSF:
    """The PSF of a microscope with other arguments, each in its place."""

    def of(plain: dict) -> dict:
        return {name: changes.pop(name, value) for name, value in plain.items()}

    kept = {name: changes.pop(name) for name in ("films", "design") if name in changes}
    pupil = lm.Objective(**of(OBJECTIVE), **kept).pupil(**of(PUPIL))
    return lm.psf(pupil, **of(WINDOW), **changes)


TABLE = [
    ("depth", -1e-6, "depth is in metres and must be at least 0 and at most 0.01, got -1e-06"),
    ("depth", 2.0, "must be at least 0 and at most 0.01, got 2; for 2 um give 2e-6, for 2 mm 2e-3"),
    ("depth", [], "depth must not be empty, got shape (0,)"),
    ("depth", 180e-6, "the stage position, set by focus or by depth and z, must be at most 190 um, where the"),
    ("z", [], "z must not be empty, got shape (0,)"),
    ("z", 1e-3, "the stage position, set by focus or by depth and z, must be at most 190 um, where the"),
    ("z", -2.0, "the stage position, set by focus or by depth and z, must be at least -10 mm, got -2 m"),
    ("wavelength", 520, "wavelength is in metres and must be from 1e-12 to 1e-2, got 520; for 520 nm give 520e-9"),
    ("wavelength", 0.52, "must be from 1e-12 to 1e-2, got 0.52; for 0.52 um give 0.52e-6"),
    ("emitter", "dipole", 'emitter must be "isotropic", "scalar", a Dipole, a Beam or a Scalar, got \'dipole\''),
    ("pixel", 6.5, "pixel is in metres for a pupil with a wavelength and must be at most 0.1, got 6.5"),
    ("method", lm.methods.NijboerZernike(), "NijboerZernike supports the pupils of a lens only, got the pupil of an"),
    ("tol", 1e-30, "tol must be >= 1e-12 and < 0.1, got 1e-30"),
]  # fmt: skip


@each("name, value, said", TABLE)
def test_a_bad_argument_is_told_in_one_sentence(name, value, said):
    with pytest.raises((TypeError, ValueError), match=re.escape(said)) as caught:
        psf(**{name: value})
    assert "\n" not in str(caught.value)


@each(
    ("make", "said"),
    [
        (lambda: lm.Dipole(0.0, 0.0, wobble=1.5), "wobble must be from 0 to 1, got 1.5"),
        (lambda: lm.Beam((0, 0)), "polarization must be a name or two finite numbers, not both 0, got (0, 0)"),
        (lambda: lm.Beam((1, math.nan)), "polarization must be a name or two finite numbers, not both 0, got"),
        (lambda: lm.Beam((1, 0, 0)), "polarization must be a name or two finite numbers, not both 0, got (1, 0, 0)"),
        (lambda: lm.Layer(0.5, 1e-4), "index must be a refractive index from 1 to 4, got 0.5"),
        (lambda: lm.Layer(1.5, 170), "for 170 um give 170e-6, for 170 mm 170e-3"),
    ],
)
def test_bad_parts_of_a_microscope_are_told_where_they_are_made(make, said):
    with pytest.raises((TypeError, ValueError), match=re.escape(said)):
        make()


def test_a_glass_that_leaves_no_room_is_told_with_how_far_it_reaches():
    with pytest.raises(ValueError, match="working_distance must leave room for the cover glass, got 0"):
        psf(coverslip=lm.Layer(1.5255, 5e-3), design=Design(1.518, GLASS))


def test_depths_and_planes_that_do_not_go_together_are_told():
    with pytest.raises(ValueError, match=r"depth.* and .*must broadcast, got shapes \(2,\) and \(3,\)"):
        psf(depth=np.array([1e-6, 2e-6]), z=np.zeros(3))
    with pytest.raises(TypeError, match="z must not be masked; fill the masked values, or omit them"):
        psf(z=np.ma.masked_array([0.0, 1e-7], [True, False]))


@each(
    ("take", "said"),
    [
        (lambda one: lm.psf(one, 3, 6.5e-6), r"an Objective; objective.pupil\(depth=..., wavelength=...\) is its"),
        (lambda one: lm.mtf(one.pupil(**PUPIL), 0.1), "the pupil of an Objective, which has no single wavefront"),
        (lambda one: lm.strehl(one.pupil(**PUPIL)), "pass it to lommel.psf and measure the PSF"),
    ],
)
def test_what_takes_the_pupil_of_a_lens_says_what_to_do_with_another(take, said):
    with pytest.raises(TypeError, match=said):
        take(lm.Objective(**OBJECTIVE))


def test_what_only_microscopes_have_is_refused_of_lenses_with_the_other_way():
    with pytest.raises(ValueError, match='"emitted" is for the pupils of an Objective; for a lens use "energy"'):
        lm.psf(lm.Pupil(), 3, 0.5, normalize="emitted")
    with pytest.raises(ValueError, match="Stratified supports the pupils of an objective only, got the pupil of"):
        lm.psf(lm.Pupil(), 3, 0.5, method="stratified")
