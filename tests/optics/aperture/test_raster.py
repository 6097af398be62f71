"""The clear part of square cells, against areas and against the overlap of discs with squares."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.measures.continuous_image import phased_cells
from lommel.optics.aperture.mask import cell_centers

OPENINGS = {
    "annulus": {"obscuration": 0.3},
    "vanes": {"vignetting": lm.Ellipse(0.9, 0.5, 0.4), "spider": lm.Spider.equal(3, 0.05)},
    "cat-eye": {"vignetting": lm.CatEye((0.3, 0.2), 1.0)},
    "vlt": {"stop": lm.telescopes.vlt()},
    "jwst": {"stop": lm.telescopes.jwst()},
}


@pytest.mark.parametrize("name", OPENINGS)
def test_cells_add_up_to_the_area(name):
    pupil = lm.Pupil(**OPENINGS[name])
    found = phased_cells(pupil.opening, 512)
    assert found.real.sum() * 4.0 / (np.pi * 512**2) == pytest.approx(pupil.area, rel=5e-7)
    assert not found.imag.any()
    assert found.real.min() > -1e-12
    assert found.real.max() < 1.0 + 1e-12


@pytest.mark.parametrize("name", OPENINGS)
def test_each_cell_is_covered_as_points_say(name):
    opening, at = lm.Pupil(**OPENINGS[name]).opening, cell_centers(64)
    fine = cell_centers(64 * 32)
    points = (opening.margin(fine[None, :], fine[:, None]) >= 0.0).reshape(64, 32, 64, 32).mean(axis=(1, 3))
    np.testing.assert_allclose(phased_cells(opening, 64).real, points, atol=0.05)
    if opening.circular:
        exact = opening.coverage(at[None, :], at[:, None], 1.0 / 64)
        np.testing.assert_allclose(phased_cells(opening, 64).real, exact, atol=0.02)


def test_segments_turn_the_phase_of_their_cells():
    stop = lm.Segments.hexagonal(1, 0.02).phased([0.3, 0.5, 0, 0, 0, -0.7], [2.0, 0, 0, 0, 0, 1.0], unit="radians")
    opening, at = lm.Pupil(stop=stop).opening, cell_centers(256)
    x, y = np.meshgrid(at, at)
    whole = phased_cells(lm.Pupil(stop=stop.scaled(0.0)).opening, 256).real > 1.0 - 1e-12
    exact = np.exp(1j * opening.phase(x, y))
    np.testing.assert_allclose(phased_cells(opening, 256)[whole], exact[whole], atol=2e-5)
