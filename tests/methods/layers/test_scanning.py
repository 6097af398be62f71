"""Confocal and two-photon microscopes: products of what direct quadrature gives."""

from __future__ import annotations

import itertools
import json
from dataclasses import replace

import numpy as np
import pytest

import lommel as lm
from lommel.methods import Confocal, DebyeWolf, TwoPhoton, method_from_dict
from lommel.optics.layers.emitter import Absorbed
from lommel.special.legendre import gauss_legendre
from objectives import WATER_60X
from plane_waves import intensity

WATER = WATER_60X
TIRF = lm.Objective(
    NA=1.49,
    magnification=100,
    immersion=1.518,
    working_distance=0.12e-3,
    coverslip=lm.Layer(1.518, 17e-5),
    sample=1.33,
)


def colours(objective=WATER, depth=20e-6, z=0.0, emitter="isotropic"):
    emission = objective.pupil(depth=depth, z=z, wavelength=525e-9, emitter=emitter)
    beam = {"wavelength": 488e-9, "emitter": lm.Beam("circular"), "origin": "coverslip"}
    return objective.pupil(depth=depth, z=emission.focus, **beam), emission


def passed(pupil, v, pinhole):
    """The share of light that passes a pinhole, by polar coordinates around its own middle."""
    radius = 2.0 * np.pi * 0.61 * pinhole
    s, w = gauss_legendre(20, 0.0, radius)
    theta = 2.0 * np.pi * (np.arange(48) + 0.5) / 48
    at = np.hypot(v[:, None, None] + s[:, None] * np.cos(theta), s[:, None] * np.sin(theta))
    places, where = np.unique(at.ravel(), return_inverse=True)
    values = DebyeWolf(1e-11).profile(pupil, places).values[:, where].reshape(-1, *at.shape)
    return 0.5 * (values.mean(axis=-1) @ (w * s))


@pytest.mark.parametrize(("objective", "depth"), [(WATER, 20e-6), (TIRF, 0.1e-6)], ids=["water", "tirf"])
@pytest.mark.parametrize("pinhole", [0.2, 1.0, 2.5])
def test_a_confocal_profile_is_the_product_within_its_bound(objective, depth, pinhole):
    excitation, emission = colours(objective, depth, np.array([-0.6e-6, 0.0]))
    v = np.array([0.0, 2.0, 7.7])
    excited = DebyeWolf(1e-11).profile(excitation, v * 525 / 488).values
    known = excited * passed(emission, v, pinhole)
    for tol in (1e-3, 1e-6, 1e-9):
        made = Confocal(excitation, pinhole, tol).profile(emission, v)
        assert np.all(np.abs(made.values - known) <= (made.error * made.peak)[:, None] + 1e-11)
        assert np.all(made.error <= tol)
        assert made.peak == pytest.approx(known.max(axis=1), rel=2e-3)


def seen_from(pupil, emitter, x, y):
    """Exact light at points of the camera in metres, over that of the emitter of the pupil."""
    return intensity(TIRF, replace(pupil, emitter=emitter), x.ravel(), y.ravel(), 40, 64).reshape(-1, *x.shape) / (
        pupil.power.reshape(-1, *(1 for _ in x.shape))
    )


@pytest.mark.parametrize(
    ("beam", "emitter"),
    [
        (lm.Beam("x"), "isotropic"),
        (lm.Beam("x"), lm.Dipole(0.7, 0.4)),
        (lm.Beam((0.3, 0.8 - 0.2j)), lm.Dipole(1.3, -2.0, wobble=0.4)),
        (lm.Beam("radial"), lm.Dipole(0.7, 0.4)),
        (lm.Beam("azimuthal"), lm.Dipole(0.7, 0.4)),
    ],
    ids=repr,
)
def test_light_that_depends_on_the_direction_passes_as_the_sum_of_plane_waves_does(beam, emitter):
    _, emission = colours(TIRF, 0.2e-6, np.array([-0.4e-6, 0.1e-6]), emitter)
    excitation = TIRF.pupil(depth=0.2e-6, z=emission.focus, origin="coverslip", wavelength=488e-9, emitter=beam)
    dipole = emission.emitter
    felt = beam if dipole.wobble == 1.0 else Absorbed(beam.polarization, dipole)
    pixel = 7.1e-6
    y, x = np.mgrid[-1:1, -1:2] * pixel
    radius = 0.61 * 525e-9 / TIRF.NA * 100.0
    s, w = gauss_legendre(9, 0.0, radius)
    theta = 2.0 * np.pi * (np.arange(18) + 0.5) / 18
    across = x[..., None, None] + s[:, None] * np.cos(theta), y[..., None, None] + s[:, None] * np.sin(theta)
    passed = (np.pi / emission.scale) ** 2 / 2.0 * (seen_from(emission, dipole, *across).mean(axis=-1) @ (w * s))
    known = seen_from(excitation, felt, x, y) * passed
    for tol in (1e-3, 1e-6, 1e-9):
        made = lm.psf(
            emission, (2, 3), pixel, method=Confocal(excitation, 1.0, tol), integrate=False, normalize="strehl"
        )
        off = np.abs(made.values - known).max(axis=(1, 2))
        assert np.all(off <= made.error_bound * known.max(axis=(1, 2)) + 1e-10)
        assert made.error_bound <= tol


def test_averages_over_pixels_of_such_light_are_those_of_the_product():
    _, emission = colours(TIRF, 0.2e-6, np.array([0.1e-6]), lm.Dipole(0.7, 0.4))
    beam = {"origin": "coverslip", "wavelength": 488e-9, "emitter": lm.Beam("x")}
    way, pixel = Confocal(TIRF.pupil(depth=0.2e-6, **beam), 2.5, 1e-8), 14e-6
    made = lm.psf(emission, 3, pixel, method=way, normalize="strehl", integrate=True)
    # Samples of each pixel by the rule of Gauss.
    x, w = gauss_legendre(8, -0.5, 0.5)
    known = np.zeros((3, 3))
    for (a, u), (b, t) in itertools.product(zip(x, w, strict=True), repeat=2):
        shifted = {"center": (1.0 - a, 1.0 - b), "integrate": False, "normalize": "strehl"}
        known += u * t * lm.psf(emission, 3, pixel, method=way, **shifted).values[0]
    assert np.abs(made.values[0] - known).max() <= 2e-8 * known.max()


def test_a_slow_beam_excites_by_the_squared_cosine():
    slow = lm.Objective(NA=0.05, magnification=5, immersion=1.0, working_distance=1e-2, coverslip=None, sample=1.0)
    beam = slow.pupil(depth=0.0, wavelength=488e-9, emitter=lm.Beam("x"))
    for azimuth in (0.0, 0.7, np.pi / 2):
        emission = slow.pupil(depth=0.0, wavelength=525e-9, emitter=lm.Dipole(np.pi / 2, azimuth))
        made = lm.psf(emission, 1, 1e-6, method=Confocal(beam, 3.0), integrate=False, normalize="strehl")
        free = lm.psf(
            replace(emission, emitter=lm.Dipole(0.0, 0.0, 1.0)),
            1,
            1e-6,
            method=Confocal(beam, 3.0),
            integrate=False,
            normalize="strehl",
        )
        assert float(made.values[0, 0] / free.values[0, 0]) == pytest.approx(3.0 * np.cos(azimuth) ** 2, abs=2e-3)


def test_a_two_photon_profile_is_the_square_within_its_bound():
    pupil = TIRF.pupil(depth=2e-6, z=[-0.5e-6, 0.0], wavelength=800e-9, emitter=lm.Beam())
    v = np.linspace(0.0, 9.0, 30)
    known = DebyeWolf(1e-11).profile(pupil, v).values ** 2
    for tol in (1e-3, 1e-6, 1e-9):
        made = TwoPhoton(tol).profile(pupil, v)
        assert np.all(np.abs(made.values - known) <= (made.error * made.peak)[:, None] + 1e-12)
        assert np.all(made.error <= tol)


def test_averages_over_pixels_are_those_of_the_product():
    # Finer samples, each a pixel of its own.
    excitation, emission = colours(z=[0.0, 0.5e-6])
    way, pixel = Confocal(excitation, 1.0, 1e-7), 9e-6
    made = lm.psf(emission, 5, pixel, method=way, normalize="strehl", integrate=True)
    x, w = gauss_legendre(8, -0.5, 0.5)
    y = (np.arange(-2, 3)[:, None] + x).ravel() * pixel
    radius, where = np.unique(np.hypot(y[:, None], y).round(15).ravel(), return_inverse=True)
    fine = way.profile(emission, emission.v(radius)).values[:, where].reshape(2, 5, 8, 5, 8)
    known = np.einsum("najbk,j,k->nab", fine, w, w)
    assert np.abs(made.values - known).max() <= 2e-7 * known.max()


@pytest.mark.parametrize(
    ("method", "pupil"), [(Confocal(colours()[0], 0.7, 1e-5), colours()[1]), (TwoPhoton(1e-5), colours()[0])]
)
def test_methods_come_back_from_what_files_say_of_them(method, pupil):
    back = method_from_dict(json.loads(json.dumps(method.to_dict())))
    assert back == method
    made = [lm.psf(pupil, 5, 6.5e-6, method=way, normalize="strehl").values for way in (method, back)]
    assert np.array_equal(*made)


def test_part_of_a_confocal_stack_is_one():
    excitation, emission = colours(z=np.array([0.0, 0.3e-6]))
    stack = lm.microscopy.confocal(excitation, emission, 9, 6.5e-6)
    one = stack[1]
    assert one.profile([0.0, 1e-5])[1] == pytest.approx(stack.profile([0.0, 1e-5])[1][1])


def test_products_have_the_frequencies_of_both():
    excitation, emission = colours()
    for way, pupil, most in (
        (Confocal(excitation, 1.0, 1e-9), emission, 2.0 * (1.0 + 525 / 488)),
        (TwoPhoton(1e-9), excitation, 4.0),
    ):
        assert 2.0 * way.stretch(pupil) == pytest.approx(most)
        # Along a line, with a window that leaves little beside each frequency.
        v = np.arange(512) * 0.25
        line = way.profile(pupil, v).values[0] * np.cos(0.5 * np.pi * v / v[-1]) ** 2
        power = np.abs(np.fft.rfft(np.concatenate([line, line[:0:-1]])))
        frequency = 2.0 * np.pi * np.fft.rfftfreq(2 * v.size - 1, 0.25)
        assert power[frequency > most + 0.2].max() < 1e-6 * power[0]
        assert power[frequency > 0.8 * most].max() > 1e-5 * power[0]
