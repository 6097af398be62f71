"""Series of the amplitudes of a microscope's pupil: the error of their derivatives."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.optics.layers import debye, projection
from objectives import oil


@pytest.mark.parametrize("degree", [0, 8])
@pytest.mark.parametrize(("depth", "error"), [(0.1e-6, 1e-2), (2e-6, 1e-4), (20e-6, 1e-2)])
def test_derivatives_are_within_their_error_whatever_they_are_divided_by(degree, depth, error, monkeypatch):
    """By a millionth of what bounds them they are a million times as large, and take more angles."""
    pupil, steepest = oil().pupil(depth=depth, z=0.5e-6, wavelength=520e-9), debye.steepest
    exact = projection.amplitudes(pupil, degree, 1e-11, (0, 1)).coefficients
    monkeypatch.setattr(debye, "steepest", lambda *of: tuple(1e-6 * bound for bound in steepest(*of)))
    # Rules are kept by what they are asked for, of which this is no part.
    projection._integrals.cache_clear()
    found = projection.amplitudes(pupil, degree, error, (0, 1))
    projection._integrals.cache_clear()
    missed = np.abs(found.coefficients - np.array([1.0, 1e6, 1e6])[:, None, None] * exact).max(axis=(1, 2))
    assert found.error <= 1.01 * error
    assert (missed <= found.error).all()
