"""Autocorrelations of radial pupils: nodes as many as are proven, and bounds off the real axis."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mpmath import mp

import lommel as lm
from lommel.blur.transfer_integral import Part, Slopes, parts, rounding

PUPILS = {
    "focus": lm.Pupil(),
    "defocus": lm.Pupil(lm.Wavefront(4.0)),
    "stack": lm.Pupil(lm.Wavefront(np.array([1.0, -6.0]), 3.0)),
    "annulus": lm.Pupil(lm.Wavefront(2.0, -1.5), obscuration=0.35),
    "apodized": lm.Pupil(lm.Wavefront(1.0), apodization=1.7, obscuration=0.2),
}
DISCS = [Part("lens", 1.0, 1.0), Part("disc", 0.3, 0.35), Part("lens", 0.3, 0.3)]


@pytest.mark.parametrize("name", PUPILS)
@pytest.mark.parametrize("allowed", [1e-4, 1e-8, 1e-12])
def test_parts_add_up_to_the_transfer_function(name, allowed):
    pupil = PUPILS[name]
    of, slopes = parts(pupil), Slopes.of(pupil)
    for low, high in ((0.0, 0.02), (0.1, 0.2), (0.2, 0.29)):
        f = np.linspace(low, high, 7)
        found = np.zeros((math.prod(pupil.shape), f.size))
        for part in of:
            seen = f < part.end
            if seen.any():
                counts = part.counts(slopes, low, high, allowed)
                found[:, seen] += part.at(pupil, f[seen], counts)
                least = part.at(pupil, f[seen], tuple(2 * k for k in counts))
                assert np.abs(part.at(pupil, f[seen], counts) - least).max() <= allowed
        exact = np.real(lm.otf(pupil, f, tol=1e-13)).reshape(found.shape) * math.pi * pupil.transmission
        assert np.abs(found - exact).max() <= len(of) * allowed + 4.0 * rounding(pupil, 400) + 1e-12


def continued(part: Part, pupil: lm.Pupil, f: complex) -> complex:
    """Return a part of the autocorrelation at a complex frequency, by Gauss nodes of its own."""
    x, w = np.polynomial.legendre.leggauss(60)
    a, f = part.radius, complex(f)
    c, d = pupil.coefficients()[0][:2] if pupil.coefficients().shape[1] > 1 else (pupil.coefficients()[0][0], 0.0)

    def phase(t):
        return c * t + d * t * t

    if part.kind == "disc":
        r, angle = 0.5 * (x + 1.0), np.pi * (np.arange(240) + 0.5) / 240
        px, py = a * np.outer(r, np.cos(angle)), a * np.outer(r, np.sin(angle))
        turn = phase(px**2 + py**2) - phase((px + 2.0 * f) ** 2 + py**2)
        # Both that are each other's conjugates on the axis.
        values = np.exp(1j * turn) + np.exp(-1j * turn)
        return complex(-2.0 * math.pi * a * a * np.einsum("i,ij->", 0.5 * w * r, values) / angle.size)
    opening = complex(mp.acos(mp.mpc(f / a)))
    theta = opening * x
    half = np.cos(theta) - f / a
    px = a * np.outer(x, half)
    turn = phase((px - f) ** 2 + (a * np.sin(theta)) ** 2) - phase((px + f) ** 2 + (a * np.sin(theta)) ** 2)
    return complex(a * a * opening * (w @ (np.exp(1j * turn) @ (w * np.cos(theta) * half))))


@pytest.mark.parametrize("part", DISCS, ids=["rim", "obscuration in rim", "obscurations"])
@pytest.mark.parametrize("name", ["focus", "defocus", "spherical"])
def test_bounds_off_the_axis_are_above_what_they_bound(part, name):
    pupil = {
        "focus": lm.Pupil(),
        "defocus": lm.Pupil(lm.Wavefront(3.0)),
        "spherical": lm.Pupil(lm.Wavefront(1.0, 4.0)),
    }
    one, rng = pupil[name], np.random.default_rng(5)
    slopes, least = Slopes.of(one), math.inf
    for _ in range(60):
        far, off = rng.uniform(0.05, 0.6) * part.end, 10.0 ** rng.uniform(-3.0, -0.9) * part.end
        bound = float(part.log_bound(slopes, np.array([far]), np.array([off]))[0])
        f = rng.uniform(0.0, far) + off * np.exp(1j * rng.uniform(0.0, 2.0 * np.pi))
        found = math.log(abs(continued(part, one, f)))
        assert found <= bound
        least = min(least, bound - found)
    # It is not so far above that nodes are wasted: a factor of e^4.
    assert least < 4.0


def test_the_reference_off_the_axis_is_the_rule_on_it():
    for part in DISCS:
        pupil = lm.Pupil(lm.Wavefront(1.0, 4.0))
        assert continued(part, pupil, 0.2).real == pytest.approx(
            float(part.at(pupil, np.array([0.2]), (60, 80))[0, 0]), rel=1e-11
        )
