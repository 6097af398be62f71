"""Windows through few nodes of defocus: as exact as they say, anywhere, in focus and far from it."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.imaging.sensor_light import DefocusNodes, Parabola
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.methods.pixels.rule import pixel_rule
from lommel.optics.wavefront import wavefront

LENS = lm.Lens(focal_length=50e-3, f_number=1.4, focus_distance=1.0, wavelength=550e-9, model="aplanatic")
CASES = {
    "paraxial": (lm.Wavefront, lambda _: 2.0, 0.0),
    "spherical": (lambda c: lm.Wavefront(c) + lm.Wavefront(0.0, 9.0), lambda _: 2.0, 0.3),
    "aplanatic": (LENS.phase, LENS.phase_rate, 0.0),
}
STEP, HALF = 16.0, 14


def exact(phase, obscuration, defocus):
    rule = pixel_rule(HALF, STEP)
    pupil = lm.Pupil(phase(defocus), obscuration=obscuration)
    means = NijboerZernike(1e-8).means(pupil, STEP * rule.radii, rule.matrix)
    return STEP**2 / (4.0 * np.pi * (1.0 - obscuration**2)) * means


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize(("low", "high"), [(-30.0, 50.0), (3.0, 3.15), (20.0, 55.0)])
def test_windows_are_exact_anywhere_beside_their_own_peaks(name, low, high):
    phase, rate, obscuration = CASES[name]
    ends = np.array([low, 0.5 * (low + high), high])
    parabola = Parabola.through(ends, exact(phase, obscuration, ends).max(axis=1))
    asked = []

    def windows(defocus):
        asked.append(defocus.size)
        return exact(phase, obscuration, defocus)

    nodes = DefocusNodes.of(windows, low, high, parabola, rate=rate, bound=STEP**2 / (4.0 * np.pi))
    defocus = np.append(np.random.default_rng(0).uniform(low, high, 60), [low, high])
    made, error = nodes(defocus)
    true = exact(phase, obscuration, defocus)
    assert error <= 1e-7
    assert (np.abs(made - true).max(axis=1) / true.max(axis=1)).max() <= error + 1e-8
    assert asked == [pytest.approx(high - low + 30.0, abs=25.0)]


def test_as_many_nodes_as_the_error_takes():
    """Of a cosine that grows as fast as a window may: fewer would not do."""
    nodes = DefocusNodes.of(
        lambda c: np.cos(2.0 * c)[:, None] + 2.0, 0.0, 60.0, Parabola(0.0, 0.0, 1.0), rate=lambda _: 2.0, bound=3.0
    )
    defocus = np.linspace(0.0, 60.0, 777)
    made, error = nodes(defocus)
    assert np.abs(made[:, 0] - np.cos(2.0 * defocus) - 2.0).max() <= error * made.max()
    assert np.abs(nodes.coefficients[60:]).max() > 1e-2
    assert 1e-13 < np.abs(nodes.coefficients[-1]).max() < 1e-8


@pytest.mark.parametrize("vergence", [0.02, 3.0, 15.0])
@pytest.mark.parametrize("sphere", [-20.0, 0.0, 20.0])
def test_phases_of_complex_defocus_differ_by_no_more_than_is_said(vergence, sphere):
    radius = 18e-3
    most = wavefront.growth(radius, sphere, vergence)
    angle = np.linspace(0.0, 2.0 * np.pi, 400)[1:-1]
    delta = vergence * np.concatenate([np.exp(1j * angle), 0.5 * np.exp(1j * angle)])
    delta = delta[np.abs(delta.imag) > 1e-9 * vergence]
    path = wavefront.path(np.linspace(0.0, 1.0, 101), radius, sphere, delta).imag / delta.imag[:, None]
    found = (path.max(axis=1) - path.min(axis=1)).max()
    assert found <= most * (1.0 + 1e-12)
    assert most <= 2.5 * found


def test_what_no_lens_does_is_refused():
    assert wavefront.growth(18e-3, 20.0, 200.0) == np.inf
    with pytest.raises(
        ValueError, match=r"depth spans C_d from 0 to 1e.05 rad, which takes .* PSFs, more than 20000"
    ):
        DefocusNodes.of(lambda c: c[:, None], 0.0, 1e5, Parabola(0.0, 0.0, 1.0), rate=lambda _: 2.0, bound=1.0)
