"""Beads: against sums over the points of a ball, and what their bound is made of."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import lommel as lm
from lommel.methods import Bead, DebyeWolf, method_from_dict
from lommel.special.legendre import gauss_legendre
from objectives import FIVE, OIL
from plane_waves import intensity

EACH = lm.Wavefront.zernike({6: [0.3, -0.5], 8: [0.4, 0.1]}, order="noll")


def ball(pupil, v, diameter):
    """The mean over a ball, its points by cylindrical coordinates about the axis of each."""
    layers, radius = pupil.layers, 0.5 * diameter
    u, share = gauss_legendre(11, -1.0, 1.0)
    t, w = gauss_legendre(9)
    theta = 2.0 * np.pi * (np.arange(30) + 0.5) / 30
    light, power = 0.0, 0.0
    for height, part in zip(u, share * (1.0 - u * u) * 0.75, strict=True):
        s = layers.wavenumber * layers.NA * radius * np.sqrt((1.0 - height**2) * t)[:, None]
        at = np.hypot(v[:, None, None] + s * np.cos(theta), s * np.sin(theta))
        places, where = np.unique(at.ravel(), return_inverse=True)
        deep = type(pupil)(
            layers, pupil.magnification, pupil.depth + radius * height, pupil.focus, pupil.z, pupil.emitter
        )
        values = DebyeWolf(1e-11).profile(deep, places).values[:, where].reshape(-1, *at.shape)
        light = light + part * deep.power[:, None] * (values.mean(axis=-1) @ w)
        power = power + part * deep.power
    return light / power[:, None]


@pytest.mark.parametrize(("diameter", "depth"), [(50e-9, 25e-9), (200e-9, 0.1e-6), (300e-9, 2e-6)])
@pytest.mark.parametrize("emitter", ["isotropic", "scalar"])
def test_the_image_of_a_bead_is_the_mean_over_it_within_its_bound(diameter, depth, emitter):
    pupil = OIL.pupil(depth=depth, z=np.array([-0.4e-6, 0.0]), wavelength=520e-9, emitter=emitter)
    v = np.array([0.0, 1.1, 6.4])
    known = ball(pupil, v, diameter)
    for tol in (1e-3, 1e-6, 1e-9):
        made = Bead(diameter, tol).profile(pupil, v)
        assert np.all(np.abs(made.values - known) <= (made.error * made.peak)[:, None] + 1e-11)
        assert np.all(made.error <= tol)


@pytest.mark.parametrize("emitter", ["isotropic", lm.Dipole(0.7, 0.4), lm.Dipole(1.3, -2.0, wobble=0.4)], ids=repr)
@pytest.mark.parametrize("aberrations", [None, FIVE, EACH], ids=["none", "one for all planes", "one a plane"])
def test_a_bead_is_the_sum_of_its_plane_waves(emitter, aberrations):
    given = {"wavelength": 520e-9, "emitter": emitter, "aberrations": aberrations}
    pupil = OIL.pupil(depth=0.1e-6, z=np.array([-0.3e-6, 0.1e-6]), **given)
    radius, pixel = 0.1e-6, 7.1e-6
    y, x = np.mgrid[-1:1, -1:2] * pixel
    u, share = gauss_legendre(7, -1.0, 1.0)
    t, w = gauss_legendre(6)
    theta = 2.0 * np.pi * (np.arange(14) + 0.3) / 14
    known, power = 0.0, 0.0
    # Of layers as far above the middle as below the plane waves are the same.
    for height, part in sorted(zip(u, share * (1.0 - u * u) * 0.75, strict=True), key=lambda layer: abs(layer[0])):
        s = radius * OIL.magnification * np.sqrt((1.0 - height**2) * t)[:, None]
        across = x[..., None, None] + s * np.cos(theta), y[..., None, None] + s * np.sin(theta)
        deep = replace(pupil, depth=pupil.depth + radius * height)
        values = intensity(OIL, deep, *(axis.ravel() for axis in across), 40, 72).reshape(2, *across[0].shape)
        known = known + part * (values.mean(axis=-1) @ w)
        power = power + part * deep.power
    known = known / power[:, None, None]
    for tol in (1e-3, 1e-6, 1e-8):
        made = lm.microscopy.bead(pupil, 2.0 * radius, (2, 3), pixel, tol=tol, integrate=False)
        off = np.abs(made.values / made.scale[:, None, None] - known).max(axis=(1, 2))
        assert np.all(off <= made.error_bound * known.max(axis=(1, 2)) + 1e-9)
        assert made.error_bound <= tol


def test_a_small_bead_is_a_point_and_a_large_one_is_not():
    pupil = OIL.pupil(depth=2e-6, wavelength=520e-9)
    point = lm.psf(pupil, 15, 6.5e-6).values

    def apart(diameter):
        made = lm.microscopy.bead(pupil, diameter, 15, 6.5e-6).values
        return np.abs(made / made.max() - point / point.max()).max()

    assert apart(2e-9) < 1e-5
    # Second moments add: the difference grows with the square.
    assert apart(50e-9) / apart(25e-9) == pytest.approx(4.0, rel=0.05)
    assert apart(200e-9) > 0.03


def test_all_light_of_a_bead_is_in_its_image():
    pupil = OIL.pupil(depth=0.3e-6, wavelength=520e-9)
    image = lm.microscopy.bead(pupil, 200e-9, 21, 13e-6, tol=1e-4)
    assert image.encircled_energy(5e-4) > 0.98
    assert image.values.sum() == pytest.approx(float(image.energy), abs=1e-3)


def test_a_bead_comes_back_from_what_files_say_of_it():
    assert method_from_dict(Bead(1e-7, 1e-5).to_dict()) == Bead(1e-7, 1e-5)
