"""How well depth can be known, against the trace of covariances, by transfer functions of the wavefront."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm

PIXEL = 4e-6
LENS = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.35, wavelength=540e-9)
PAIR = [LENS, LENS.focused(1.8)]
NOISE = lm.Noise(white=1e4, read=3.0)


def test_read_noise_of_a_multiplying_register_counts_by_its_excess():
    noises = [
        lm.Noise(white=200.0, read=40.0, excess=2.0),
        lm.Noise(white=100.0, read=20.0),
        lm.Noise(white=200.0, read=20.0),
    ]
    found = [lm.depth_precision(PAIR, 1.6, PIXEL, noise=noise) for noise in noises]
    assert found[0] == pytest.approx(found[1], rel=1e-12)
    assert found[2] < 0.8 * found[0]


def bound(lenses, distance, photons, contrast=0.35, window=4.0, side=160):
    """Standard error of the distance by what the ratio of two photographs tells."""
    f = (np.arange(side) + 0.5) / side - 0.5
    fx, fy = np.meshgrid(f, f)
    noise = (photons + 3.0**2) / photons**2
    radius = np.linspace(0.0, 3.6, 1500)
    step = 2e-4

    def power(fx, fy):
        return contrast**2 / (2.0 * np.pi * np.log(64.0)) / np.maximum(fx**2 + fy**2, 128.0**-2)

    def transfer(lens, u, fx, fy):
        on_axis = lm.otf(lens.pupil(1.0 / u), radius / PIXEL, tol=1e-8).real
        return np.interp(np.hypot(fx, fy), radius, on_axis) * np.sinc(fx) * np.sinc(fy)

    def known(lens, u):
        return transfer(lens, u, fx, fy)

    u = 1.0 / distance
    h = np.array([known(lens, u) for lens in lenses])
    slope = np.array([(known(lens, u + step) - known(lens, u - step)) / (2.0 * step) for lens in lenses])
    # Texture of higher frequencies comes down as noise.
    aliases = [(a, b) for a in (-1, 0, 1) for b in (-1, 0, 1) if a or b]
    n = [
        noise + sum(power(fx + a, fy + b) * transfer(lens, u, fx + a, fy + b) ** 2 for a, b in aliases)
        for lens in lenses
    ]
    h, slope = (np.array([each / np.sqrt(m) for each, m in zip(several, n, strict=True)]) for several in (h, slope))
    s = power(fx, fy)
    ratio = h[0] * slope[1] - h[1] * slope[0]
    compared = (s**2 * ratio**2 / (1.0 + s * (h**2).sum(axis=0))).mean()
    return distance**2 / math.sqrt(compared * 4.0 * math.pi * window**2)


@pytest.mark.parametrize(("f_number", "distance"), [(8.0, 1.5), (8.0, 1.7), (4.0, 1.45)])
def test_it_is_the_bound_of_the_covariances(f_number, distance):
    pair = [lens.stopped(f_number) for lens in PAIR]
    assert lm.depth_precision(pair, distance, PIXEL, noise=NOISE) == pytest.approx(
        bound(pair, distance, 1e4), rel=4e-3
    )


def test_arrays_of_distances_give_arrays_and_light_counts_as_it_should():
    here = lm.depth_precision(PAIR, [[1.4], [1.6]], PIXEL, noise=NOISE)
    assert here.shape == (2, 1)
    # Without reading noise, more light and more contrast are alike: S over noise is contrast^2 photons.
    bright = lm.depth_precision(PAIR, 1.5, PIXEL, noise=lm.Noise(white=4e4, read=0.0))
    more = lm.depth_precision(PAIR, 1.5, PIXEL, noise=lm.Noise(white=1e4, read=0.0), contrast=0.7)
    assert more == pytest.approx(bright)


def test_what_cannot_be_known_is_infinite():
    for nothing in (
        lm.depth_precision(PAIR, np.inf, PIXEL, noise=NOISE),
        lm.depth_precision(PAIR, 1.5, PIXEL, noise=NOISE, contrast=0.0),
        lm.depth_precision([LENS, LENS], 1.5, PIXEL, noise=NOISE),
        lm.depth_precision([LENS], 1.5, PIXEL, noise=NOISE),
        lm.depth_precision([LENS, LENS.stopped(16.0)], 1.35, PIXEL, noise=NOISE),  # both in focus
    ):
        assert nothing == math.inf
    assert lm.depth_precision([LENS, LENS.stopped(16.0)], 1.5, PIXEL, noise=NOISE) < 0.01


def test_lenses_that_are_not_round_and_foci_that_there_are_none_of_are_told():
    astigmatic = lm.Lens(
        focal_length=35e-3, f_number=8.0, wavelength=540e-9, aberrations=lm.Wavefront(nonradial={(2, 2): 1.0})
    )
    with pytest.raises(ValueError, match="radially symmetric"):
        lm.depth_precision([astigmatic, astigmatic], 1.5, PIXEL, noise=NOISE)
    with pytest.raises(ValueError, match="no pair of foci"):
        lm.best_depth_foci(LENS, 0.02, PIXEL, noise=NOISE)


def test_nothing_is_asked_for_beyond_infinity():
    phone = lm.Lens(focal_length=5e-3, f_number=1.8, focus_distance=1.5, wavelength=540e-9)
    pair = [phone, phone.focused(4.0)]
    found = lm.depth_precision(pair, [1.0, 10.0, 1e3, 1e5], 1.2e-6, noise=NOISE)
    assert np.all(np.isfinite(found))
    assert np.all(np.diff(found) > 0.0)
    # There the standard error of 1 / distance is nearly that at infinity.
    assert found[3] / found[2] == pytest.approx(1e4, rel=0.1)
