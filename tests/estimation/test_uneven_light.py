"""Derivatives by uneven light of a pupil, against differences of images by plain sums over many points."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.estimation.uneven_light import OVAL, SHIFT, SLANT, UnevenLight, changes_of
from lommel.optics.grid import Grid

SIDE, PITCH = 25, 0.45
AT = (np.arange(600) + 0.5) / 300 - 1
X, Y = np.meshgrid(AT, AT)
RHO, THETA = np.hypot(X, Y), np.arctan2(Y, X)
PHASE = 0.6 * (2 * RHO**2 - 1) + 0.8 * (3 * RHO**3 - 2 * RHO) * np.cos(THETA) + 0.4 * RHO**2 * np.cos(2 * THETA)


def image(clear, blocked, inside):
    """Return the image of an aperture of the stated light of an annulus; `clear` is an amplitude."""
    wave = np.exp(-1j * np.pi * PITCH * np.multiply.outer(np.arange(SIDE) - SIDE // 2, AT))
    field = wave @ (clear * ~blocked * np.exp(1j * PHASE)) @ wave.T
    return np.abs(field * (2 / len(AT)) ** 2 * PITCH / 2) ** 2 / (np.pi * (1 - inside**2))


def changed(name, way, inside):
    """Return an image for a change of a size along rows, or along columns."""
    size = {SLANT: 0.01, SHIFT: 0.04, OVAL: 0.02}[name]
    made = []
    for step in (size, -size):
        clear, down, across = RHO < 1, 0.0, 0.0
        if name == SLANT:
            clear = clear * np.exp(-step * (Y if way == 0 else X))
        elif name == SHIFT:
            down, across = (step, 0.0) if way == 0 else (0.0, step)
        else:
            angle = 2 * THETA if way == 0 else 2 * THETA - np.pi / 2
            clear = 1 + step * np.cos(angle) > RHO
        made.append(image(clear, np.hypot(Y - down, X - across) < inside, inside))
    return (made[0] - made[1]) / (2 * size)


@pytest.mark.parametrize("inside", [0.0, 0.3])
def test_derivatives_are_differences_of_images(inside):
    wavefront = lm.Wavefront.zernike({(2, 0): 0.6, (3, 1): 0.8, (2, 2): 0.4}, normalization="edge")
    pupil = lm.Pupil(wavefront, obscuration=inside)
    terms = sorted(wavefront.edge_terms())
    edge = np.array([[wavefront.edge_terms()[term] for term in terms]])
    grid = Grid((SIDE, SIDE), PITCH, integrate=False)
    made = UnevenLight(pupil, grid, terms).images(edge)
    names = changes_of(pupil)
    assert names == ((SLANT, SHIFT, OVAL) if inside else (SLANT, OVAL))
    assert len(made) == 2 * len(names)
    values = np.asarray(lm.psf(pupil, SIDE, PITCH, integrate=False).values)
    assert np.abs(image(RHO < 1, inside > RHO, inside) - values).max() < 2e-3 * values.max()
    for k, found in enumerate(made):
        true = changed(names[k // 2], k % 2, inside)
        assert np.abs(found[0] - true).max() < 0.1 * np.abs(true).max(), (names[k // 2], k % 2)


def test_apertures_that_are_not_round_have_no_such_changes():
    assert changes_of(lm.Pupil(spider=lm.Spider(0.05, (0.0, 1.0)))) == ()
    assert changes_of(lm.Pupil(mask=lm.Mask(np.ones((64, 64))))) == ()
