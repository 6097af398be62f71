"""Which other PSFs a stack follows better than the given ones: whatever is wrong is named."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel.microscopy import refinement
from lommel.microscopy.depth_model import DepthModel
from objectives import OIL_60X

CAMERA = lm.Noise(white=0.5, read=1.5, offset=100.0)
RIGHT = DepthModel(OIL_60X, 520e-9, 6e-6, 0.3e-6, 8e-6, 8, (15, 15))
BEAD = 7, 8, 9  # between two planes, in planes of half a step


@pytest.fixture(autouse=True)
def one_psf(monkeypatch):
    """Take the PSF of the middle everywhere, in a small part."""
    psfs = DepthModel.psfs
    monkeypatch.setattr(DepthModel, "psfs", lambda model, margin, slabs=1: psfs(model, margin, slabs))
    for name, value in {"_NARROWEST": 15, "_ROUGH": 18}.items():
        monkeypatch.setattr(refinement, name, value)


@pytest.fixture
def stack():
    """Return beads on planes and between them, of the right PSFs."""
    fine = DepthModel(OIL_60X, 520e-9, 6e-6, 0.15e-6, 8e-6, 16, (29, 15))
    truth = np.zeros((16, 18, 18), np.float32)
    truth[BEAD] = 4e6
    blur, image = fine.blur(truth.shape, (0, 0), threads=1), np.zeros(truth.shape)
    blur.outside[...] = 0.0
    blur.forward(lambda *at: truth[at], lambda p, r, c, v: image.__setitem__((p, r, c), v))
    return CAMERA.record(np.maximum(image[::2], 0.0) + 10.0, seed=3)


@pytest.mark.parametrize(
    ("name", "wrong", "said"),
    [
        ("sample", OIL_60X.sample + 0.02, "a smaller index of the sample"),
        ("NA", 0.94, "a larger NA"),
        ("depth", 9.5e-6, "a smaller depth"),
        ("step", 1.08, "a smaller step of z"),
        ("wavelength", 0.93, "a larger wavelength"),
    ],
)
def test_what_is_wrong_is_among_the_psfs_that_are_named(stack, name, wrong, said):
    looked = refinement.Looked(stack, RIGHT.changed(name, wrong), CAMERA, math.inf, 1)
    found = refinement.better(looked, lambda *_: None, turned=False)
    assert any(each.startswith(said) for each in found)


def test_a_line_is_followed_downhill_to_its_minimum_with_few_costs():
    asked = []

    def cost(value):
        asked.append(value)
        return 3.0 + (value - 0.61) ** 2 if value < 1.0 else math.inf

    place, found = refinement._downhill(cost, 0.0, 0.06, 3.0 + 0.61**2)
    assert place == pytest.approx(0.61)
    assert found == pytest.approx(3.0)
    assert len(asked) == 5
    assert refinement._downhill(cost, 0.0, -0.2, 3.0 + 0.61**2)[0] == 0.8  # 1.6 is out of range
    assert refinement._downhill(cost, 0.61, 0.1, 3.0) == (0.61, 3.0)


@pytest.mark.parametrize("share", [1.0, 1e-3])
def test_a_parameter_is_where_deviances_are_least_and_its_standard_error_is_a_rise_by_one(share):
    """Of discrepancies that bend by any amount, whose least does not move with more steps."""
    middle, apart, known = np.array([0.7, -0.4]), np.array([0.5, 2.0]), 4000
    bend = share * np.array([[2.0, 0.5], [0.5, 1.0]])

    def course(place):
        off = (place - middle) / apart
        return [9.0, 1.2 + off @ bend @ off, 1.2 + 0.5 * off @ bend @ off]

    wide = np.full(2, 50.0)
    found, errors = refinement._minimum(course, np.zeros(2), apart, (-wide, wide), known)
    assert found == pytest.approx(middle, rel=1e-8)
    assert errors == pytest.approx(np.sqrt(2.0 * 1.2 / known * np.diag(np.linalg.inv(bend))) * apart, rel=1e-6)
