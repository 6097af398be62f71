"""Samples, spread and read: each part of the bound by what it is to cover."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.blur.blurs import KOLMOGOROV
from lommel.blur.recorded import Asked, summed
from lommel.optics.grid import Grid


def on_axis(ratio: float) -> float:
    """Return the long exposure in the middle, over the unaberrated peak."""
    x, w = np.polynomial.legendre.leggauss(400)
    u, w = 0.5 * (x + 1.0), 0.5 * w
    f, weight = u**3, w * 3.0 * u**5
    otf = 2.0 / np.pi * (np.arccos(f) - f * np.sqrt(1.0 - f * f))
    blurred = otf * np.exp(-KOLMOGOROV * (ratio * f) ** (5.0 / 3.0))
    return float(weight @ blurred / (weight @ otf))


@pytest.mark.parametrize("margin", [22.0, 40.0])
@pytest.mark.parametrize("ratio", [1.0, 3.0])
def test_light_beyond_a_lattice_that_is_too_small_is_counted(ratio, margin):
    asked = Asked(None, 0, 1e-11, 1e-12, margin)
    made = summed(asked, lm.Pupil(), Grid(1, 0.5), (lm.Seeing(1.0 / ratio),))
    off = abs(float(made.values[0, 0, 0]) - on_axis(ratio))
    assert made.given is not None
    assert off > 10.0 * float(made.given[0] + made.response[0])
    assert off <= float(made.missing[0])


def test_errors_of_samples_and_of_responses_are_as_asked():
    for error in (1e-5, 1e-8):
        made = summed(Asked(None, 0, error, error, 0.0), lm.Pupil(), Grid(3, 0.5), (lm.Jitter(0.4),))
        assert made.given is not None
        assert 0.0 < float(made.response[0]) < 60.0 * error
        assert 0.0 < float(made.given[0]) < 8.0 * error
        assert float(made.missing[0]) == 0.0
