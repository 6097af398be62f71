"""Autocorrelations from cells, against quadrature over the aperture with a proven error."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.measures.continuous_image import transfer

ABERRATED = lm.Wavefront(5.0, nonradial={(3, 1): 3.0, (1, -1): 4.0})
PUPILS = {
    "apodized": lm.Pupil(ABERRATED, obscuration=0.3, apodization=0.4),
    "vlt": lm.Pupil(stop=lm.telescopes.vlt()),
    "aberrated": lm.Pupil(ABERRATED, stop=lm.telescopes.vlt()),
    "phased": lm.Pupil(
        stop=lm.Segments.hexagonal(1, 0.05).phased([0.3, 0.5, 0, 0, 0, 0], [0, 4.0, 0, 0, 0, 0], unit="radians")
    ),
}


@pytest.mark.parametrize("end", [0.9, 0.05])
@pytest.mark.parametrize("name", PUPILS)
def test_shifts_by_parts_of_cells(name, end):
    rng = np.random.default_rng(3)
    f, angle = end * np.sqrt(rng.uniform(0.01, 1.0, 6)), rng.uniform(-np.pi, np.pi, 6)
    fx, fy = f * np.cos(angle), f * np.sin(angle)
    exact = lm.otf(PUPILS[name], fx, fy, tol=1e-7)
    # Shifts along gaps between segments open and close them within a cell.
    np.testing.assert_allclose(transfer(PUPILS[name], end, fx, fy), exact, atol=2e-4 if name == "phased" else 2e-5)


def test_a_mask_of_squares_is_exact():
    pupil = lm.Pupil(mask=lm.Mask.sample(lambda x, y: np.exp(2j * x * y), side=20, squares=True))
    fx, fy = np.array([[0.1, 0.21]]), np.array([[0.03, -0.4]])
    np.testing.assert_array_equal(transfer(pupil, 0.5, fx, fy), lm.otf(pupil, fx, fy))
