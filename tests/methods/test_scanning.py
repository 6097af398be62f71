"""Confocal and two-photon microscopes: products of what direct quadrature gives."""

from __future__ import annotations

import json

import numpy as np
import pytest

import lommel as lm
from lommel.methods import Confocal, DebyeWolf, TwoPhoton, method_from_dict
from lommel.special.legendre import gauss_legendre

WATER = lm.Objective(
    NA=1.2,
    magnification=60,
    immersion=1.333,
    working_distance=0.28e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
    sample=1.36,
)
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


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: Confocal("laser"), "excitation must be an ObjectivePupil"),
        (lambda: Confocal(colours()[0], 0.0), "pinhole must be > 0, got 0"),
        (lambda: Confocal(colours()[0], 1e3), "pinhole must be at most 100 Airy units"),
        (lambda: Confocal(colours()[0], tol=0.5), "tol must be >= 1e-12 and < 0.1"),
        (lambda: Confocal(colours(emitter=lm.Dipole(0.7, 0.0))[1]), "excitation must not depend on the direction"),
        (lambda: TwoPhoton(float("nan")), "tol must be finite"),
    ],
)
def test_what_makes_no_method_is_refused(make, said):
    with pytest.raises((TypeError, ValueError), match=said):
        make()


def test_pupils_of_others_are_refused():
    excitation, emission = colours()
    with pytest.raises(ValueError, match="magnification 100, and a pupil of 60"):
        lm.psf(emission, 9, 6.5e-6, method=Confocal(colours(TIRF, 1e-6)[0]))
    with pytest.raises(ValueError, match="pupils of an Objective only"):
        lm.psf(lm.Pupil(lm.Wavefront()), 9, 0.3, method=TwoPhoton())
    with pytest.raises(ValueError, match="radially symmetric pupils only"):
        lm.psf(colours(emitter=lm.Dipole(0.7, 0.0))[1], 9, 6.5e-6, method=Confocal(excitation))


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
