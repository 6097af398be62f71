"""Pairs of beads that touch, in images of another simulator, and single beads that are only aberrated or blurred."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import scipy

import bead_fields
import lommel as lm
from lommel.estimation.bead_images import Setup, Stack
from lommel.estimation.bead_pairs import touching
from lommel.optics.layers.emitter import emitter_of

WAVE, SIDE, Z = 520e-9, 19, (np.arange(7) - 3) * 350e-9
PITCH = bead_fields.PIXEL / bead_fields.MAGNIFICATION
OBJECTIVE = lm.Objective(NA=bead_fields.NA, magnification=60, immersion=1.333, sample=1.333)
SETUP = Setup(OBJECTIVE, WAVE, emitter_of("isotropic"), bead_fields.PIXEL, 0.0)
CAMERA = lm.Noise(read=1.6, offset=100, white=0.5)


@cache
def light(row, column, **terms):
    return bead_fields.point(Z, (row, column), SIDE, terms, WAVE)


def pair(row, column, share, **terms):
    """Return the light of a bead and of another one `row` and `column` pixels away."""
    first, second = light(9.2, 8.9, **terms), light(9.2 + row, 8.9 + column, **terms)
    return first + share * second


def recorded(image, photons=3e4, seed=1):
    return CAMERA.record(photons * image / image[3].sum() + 10.0, seed=seed)


def found_in(image, seed=1):
    stack = Stack.of(lm.Counts.of(recorded(image, seed=seed), noise=CAMERA), CAMERA, Z)
    return touching(stack, light(9.0, 9.0), SETUP)


@pytest.mark.parametrize(
    ("row", "column", "share"), [(2.6, 1.5, 0.6), (0.0, 3.2, 1.0), (-2.5, 2.5, 0.45), (4.0, 1.0, 0.8)]
)
def test_pairs_are_found_with_their_distance_and_share(row, column, share):
    found = found_in(pair(row, column, share, coma=0.3, astigmatism=0.2))
    assert found.distance == pytest.approx(np.hypot(row, column) * PITCH, rel=0.1)
    assert found.share == pytest.approx(share, abs=0.15)


@pytest.mark.parametrize("name", ["astigmatism", "coma", "spherical"])
@pytest.mark.parametrize("size", [0.4, 1.0])
def test_single_beads_of_strong_aberrations_are_no_pairs(name, size):
    assert found_in(light(9.2, 8.9, **{name: size})) is None


def test_a_bead_that_vibrates_along_one_axis_is_no_pair():
    assert found_in(scipy.ndimage.gaussian_filter1d(light(9.2, 8.9), 1.2, axis=2)) is None


def test_a_pair_is_left_out_of_a_fit_and_named_and_pairs_alone_are_refused():
    microscope = lm.Microscope(OBJECTIVE, WAVE, bead_fields.PIXEL)
    stacks = [recorded(pair(2.6, 1.5, 0.6), seed=k) for k in range(2)]
    with pytest.raises(ValueError, match=r"all 2 show two that touch \(the first: 3[0-9]0 nm apart, light [5-7]\d %"):
        lm.fit_beads(np.array(stacks), microscope, z=Z, noise=CAMERA, terms=3)
    stacks.insert(1, recorded(light(9.2, 8.9)))
    fit = lm.fit_beads(np.array(stacks), microscope, z=Z, noise=CAMERA, terms=3, priors={}, diameter=0.0)
    assert fit.converged
    assert [bead.used for bead in fit.beads] == [False, True, False]
    assert "two beads that touch: bead 0, 3" in fit.findings.get("left_out").text
    assert "; bead 2, 3" in fit.findings.get("left_out").text
