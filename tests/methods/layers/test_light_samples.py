"""Scanning microscopes and beads with aberrations: sums of plane waves over pinholes, balls and pixels."""

from __future__ import annotations

import itertools
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scipy.special import j1

import lommel as lm
from lommel.methods import Bead, Confocal, Sted, TwoPhoton
from lommel.methods.layers.samples import disc_filter
from lommel.optics.layers.emitter import Absorbed
from lommel.special.legendre import gauss_legendre
from objectives import FIVE, OIL
from plane_waves import intensity

PIXEL = 6.1e-6
OTHER = lm.Wavefront.zernike({6: 0.12, 8: -0.1}, unit="waves", order="noll")


@pytest.mark.parametrize("error", [1e-4, 1e-8])
@pytest.mark.parametrize("step", [0.3, 0.9, 1.5, 2.4])
@pytest.mark.parametrize("radius", [0.05, 1.4, 3.83, 12.0])
def test_filters_have_the_response_of_a_disc(radius, step, error):
    made = disc_filter(step, radius, error)
    w = np.linspace(-2.0, 2.0, 41)
    total, gain = 0.0, 0.0
    for rows, columns in made.parts:
        k = np.arange(rows.weights.size) - rows.weights.size // 2
        waves = np.cos(np.outer(w, step / rows.stride * k))
        total = total + np.outer(waves @ rows.weights, waves @ columns.weights)
        gain += np.abs(rows.weights).sum() * np.abs(columns.weights).sum()
    q = radius * np.hypot(w, w[:, None])
    exact = np.where(q > 0.0, 2.0 * j1(q) / np.where(q > 0.0, q, 1.0), 1.0)
    off = np.abs(total - exact)[np.hypot(w, w[:, None]) <= 2.0].max()
    assert 1e-4 * made.error <= off <= made.error <= error
    assert made.gain == pytest.approx(gain)


def colours(beam, emitter, exciting, emitting):
    """Return excitation and emission in two planes."""
    z = np.array([-0.4e-6, 0.1e-6])
    emission = OIL.pupil(depth=0.2e-6, z=z, wavelength=525e-9, emitter=emitter, aberrations=emitting)
    planes = {"depth": 0.2e-6, "z": emission.focus, "origin": "coverslip"}
    return OIL.pupil(**planes, wavelength=488e-9, emitter=beam, aberrations=exciting), emission


def seen_from(pupil, emitter, x, y):
    """Exact light at points of the camera in metres, over that of the emitter of the pupil."""
    light = intensity(OIL, replace(pupil, emitter=emitter), x.ravel(), y.ravel(), 44, 84)
    return light.reshape(-1, *x.shape) / pupil.power.reshape(-1, *(1 for _ in x.shape))


def product(excitation, emission, x, y):
    """Exact excitation times what passes a pinhole of an Airy unit."""
    dipole = emission.emitter
    felt = excitation.emitter
    if dipole.wobble < 1.0:
        felt = Absorbed(felt.polarization, dipole)
    s, w = gauss_legendre(9, 0.0, 0.61 * 525e-9 / OIL.NA * OIL.magnification)
    theta = 2.0 * np.pi * (np.arange(18) + 0.5) / 18
    across = x[..., None, None] + s[:, None] * np.cos(theta), y[..., None, None] + s[:, None] * np.sin(theta)
    passed = (np.pi / emission.scale) ** 2 / 2.0 * (seen_from(emission, dipole, *across).mean(axis=-1) @ (w * s))
    return seen_from(excitation, felt, x, y) * passed


@pytest.mark.parametrize(
    ("beam", "emitter", "exciting", "emitting"),
    [
        (lm.Beam("x"), "isotropic", FIVE, None),
        (lm.Beam(), "isotropic", FIVE, OTHER),
        (lm.Beam((0.3, 0.8 - 0.2j)), lm.Dipole(1.3, -2.0, wobble=0.4), None, OTHER),
        (lm.Beam("azimuthal"), lm.Dipole(0.7, 0.4), OTHER, FIVE),
    ],
    ids=["excitation", "both", "emission", "dipole"],
)
def test_confocal_light_is_the_product_of_sums_of_plane_waves(beam, emitter, exciting, emitting):
    excitation, emission = colours(beam, emitter, exciting, emitting)
    y, x = np.mgrid[-1:1, -1:2] * PIXEL
    known = product(excitation, emission, x, y)
    for tol in (1e-3, 1e-6, 1e-8):
        made = lm.microscopy.confocal(excitation, emission, (2, 3), PIXEL, tol=tol)
        off = np.abs(made.values - known).max(axis=(1, 2))
        assert np.all(off <= made.error_bound * known.max(axis=(1, 2)) + 1e-10)
        assert made.error_bound <= tol


@pytest.mark.parametrize("kind", ["confocal", "two-photon", "bead"])
def test_averages_over_pixels_are_those_of_samples(kind):
    excitation, emission = colours(lm.Beam("x"), "isotropic", FIVE, OTHER)
    way, pupil = {
        "confocal": (Confocal(excitation, 2.5, 1e-7), emission),
        "two-photon": (TwoPhoton(1e-7), excitation),
        "bead": (Bead(0.2e-6, 1e-7), emission),
    }[kind]
    made = lm.psf(pupil, 3, 12e-6, method=way, normalize="strehl", integrate=True)
    assert made.error_bound <= 1e-7
    x, w = gauss_legendre(7, -0.5, 0.5)
    known = np.zeros((2, 3, 3))
    for (a, u), (b, t) in itertools.product(zip(x, w, strict=True), repeat=2):
        shifted = {"center": (1.0 - a, 1.0 - b), "integrate": False, "normalize": "strehl"}
        known += u * t * lm.psf(pupil, 3, 12e-6, method=way, **shifted).values
    assert np.abs(made.values - known).max() <= 2e-7 * known.max()


@pytest.mark.parametrize("tol", [1e-3, 1e-8])
def test_two_photon_light_is_the_square_of_sums_of_plane_waves(tol):
    excitation, _ = colours(lm.Beam("x"), "isotropic", FIVE, None)
    y, x = np.mgrid[-2:3, -1:2] * PIXEL
    known = seen_from(excitation, excitation.emitter, x, y) ** 2
    made = lm.microscopy.two_photon(excitation, (5, 3), PIXEL, tol=tol)
    off = np.abs(made.values - known).max(axis=(1, 2))
    assert np.all(off <= made.error_bound * known.max(axis=(1, 2)) + 1e-10)
    assert made.error_bound <= tol


SPOTS = np.mgrid[-2:3, -2:3] * 2e-6


@cache
def confocal_spot():
    """Return excitation and emission, and their exact light at the points of SPOTS."""
    excitation, emission = colours(lm.Beam(), "isotropic", OTHER, OTHER)
    return excitation, emission, product(excitation, emission, *SPOTS[::-1])


@cache
def ring(aberrated):
    """Return a depletion, with or without aberrations, and its exact light at the points of SPOTS."""
    _, emission, _ = confocal_spot()
    planes = {"depth": 0.2e-6, "z": emission.focus, "origin": "coverslip"}
    aberrations = FIVE if aberrated else None
    doughnut = OIL.pupil(**planes, wavelength=775e-9, emitter=lm.Beam("vortex"), aberrations=aberrations)
    return doughnut, seen_from(doughnut, doughnut.emitter, *SPOTS[::-1])


@pytest.mark.parametrize("tol", [1e-3, 1e-7])
@pytest.mark.parametrize("saturation", [3.0, 200.0])
@pytest.mark.parametrize("aberrated", [True, False], ids=["aberrated", "perfect"])
def test_what_depletion_leaves_is_that_of_plane_waves(aberrated, saturation, tol):
    (excitation, emission, lit), (doughnut, depleting) = confocal_spot(), ring(aberrated)
    known = lit * 2.0 ** (-saturation * depleting)
    way = Sted(excitation, 1.0, tol, depletion=doughnut, saturation=saturation)
    made = lm.psf(emission, 5, 2e-6, method=way, integrate=False, normalize="strehl")
    off = np.abs(made.values - known).max(axis=(1, 2))
    assert np.all(off <= made.error_bound * known.max(axis=(1, 2)) + 1e-10)
    assert made.error_bound <= tol
    spot = lm.microscopy.sted(excitation, doughnut, emission, 5, 2e-6, saturation=5.0, tol=tol)
    assert spot.error_bound <= tol


def test_small_aberrations_change_light_without_by_little():
    tiny = lm.Wavefront.zernike({(2, 2): 1e-9})
    excitation, emission = colours(lm.Beam(), "isotropic", None, None)
    ways = [(Confocal(excitation, 1.0, 1e-8), emission), (TwoPhoton(1e-8), excitation), (Bead(2e-7, 1e-8), emission)]
    for way, pupil in ways:
        asked = {"method": way, "normalize": "strehl", "integrate": False}
        one, other = (lm.psf(p, 9, PIXEL, **asked) for p in (pupil, replace(pupil, aberrations=tiny)))
        assert np.abs(one.values - other.values).max() <= 3e-8 * one.values.max()


def test_one_set_of_aberrations_excites_and_depletes_all_planes():
    own = lm.Wavefront.zernike({6: [0.3, -0.5]}, order="noll")
    excitation, emission = colours(lm.Beam(), "isotropic", own, None)
    with pytest.raises(ValueError, match="excitation must have one set of aberrations for all planes"):
        Confocal(excitation)
    plain, _ = colours(lm.Beam(), "isotropic", None, None)
    doughnut = replace(excitation, emitter=lm.Beam("vortex"))
    with pytest.raises(ValueError, match="depletion must have one set of aberrations for all planes"):
        Sted(plain, depletion=doughnut, saturation=1.0)
    made = lm.psf(emission, 5, PIXEL, method=Confocal(replace(plain, aberrations=FIVE)), normalize="strehl")
    with pytest.raises(ValueError, match="compute an image, and measure that"):
        made.method.profile(emission, np.array([0.0, 1.0]))
