"""Samples, spread and read: each part of the bound by what it is to cover."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.blur.blurs import KOLMOGOROV
from lommel.blur.readout import ends
from lommel.blur.recorded import Asked, Band, Gather, summed
from lommel.blur.turbulence import Gate
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


@pytest.mark.parametrize("margin", [20.0, 60.0])
@pytest.mark.parametrize("ratio", [8.0, 30.0])
def test_light_beyond_a_lattice_that_is_gathered_is_counted(ratio, margin):
    asked = Asked(None, 0, 1e-11, 1e-13, margin)
    made = summed(asked, lm.Pupil(), Grid(1, 0.5), (lm.Seeing(1.0 / ratio),))
    off = on_axis(ratio) - float(made.values[0, 0, 0])
    assert off > 10.0 * float(made.given[0] + made.response[0])
    assert off <= float(made.missing[0]) < 2000.0 * off


@pytest.mark.parametrize("error", [1e-4, 1e-7, 1e-10])
def test_light_is_gathered_so_that_waves_of_the_band_are_what_they_were(error):
    gate = Gate.of(0.8, error)
    made = Gather.of(0.17, -40, 90, gate)
    at = gate.h * (made.first + np.arange(made.matrix.shape[1]))
    w = np.linspace(-2.0, 2.0, 101)
    expected = np.exp(1j * np.outer(0.17 * np.arange(-40, 50), w))
    assert np.abs(made.matrix @ np.exp(1j * np.outer(at, w)) - expected).max() <= made.error < 4.0 * error
    # Samples far from a place are all that it lacks.
    beyond, cut = ends(gate)
    many = Gather.of(0.17, -4000, 8001, gate)
    place = -many.first
    far = np.abs(0.17 * np.arange(-4000, 4001)) > beyond
    assert 0.17 / gate.h * np.abs(many.matrix[far, place]).sum() <= cut
    assert 0.17 / gate.h * np.abs(many.matrix[:, place]).sum() <= many.sums


@pytest.mark.parametrize(
    "blur", [(lm.Seeing(1.0 / 8.0),), (lm.Jitter(1.5, 3.0),), (lm.Seeing(0.1, outer_scale=20.0), lm.Motion(4.0))]
)
@pytest.mark.parametrize("error", [1e-6, 1e-10])
def test_bounds_on_spectra_are_above_their_integrals(blur, error):
    pupil = lm.Pupil(obscuration=0.4)
    band = Band.of(pupil, blur, error)
    assert 0.0 < band.share < 0.8
    assert band.tail <= error * pupil.amplitude**2
    x, w = np.polynomial.legendre.leggauss(1200)
    angle = np.linspace(0.0, np.pi, 16, endpoint=False)

    def integral(low: float, high: float, seen: bool) -> float:
        f, weight = low + 0.5 * (high - low) * (x + 1.0), 0.5 * (high - low) * w
        size = np.abs(lm.otf(pupil, f)) if high <= 1.0 else 1.0
        mean = 1.0
        if seen:
            mean = np.mean(
                [np.prod([np.abs(b.transfer(f * np.cos(t), f * np.sin(t))) for b in blur], axis=0) for t in angle],
                axis=0,
            )
        return 8.0 * pupil.transmission * float(np.sum(weight * f * size * mean))

    assert integral(band.share, 3.0, True) <= band.tail
    assert integral(0.0, 1.0, True) <= band.blurred
    assert integral(0.0, band.share, False) <= band.clear
