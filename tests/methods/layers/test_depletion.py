"""STED: the product of three lights as sums of plane waves give them, and what lies between radii."""

from __future__ import annotations

import dataclasses
import json

import numpy as np
import pytest

import lommel as lm
from lommel.methods import Confocal, Sted, method_from_dict
from lommel.methods.layers.scanning import crest
from lommel.special.legendre import gauss_legendre
from objectives import WATER_60X
from plane_waves import intensity

WATER = dataclasses.replace(WATER_60X, sample=1.333)
DEPTH, PIXEL = 2e-6, 3.1e-6


def three(polarization="circular", z=(-0.3e-6, 0.0), depth=DEPTH, depleting="vortex"):
    emission = WATER.pupil(depth=depth, z=np.array(z), wavelength=680e-9)
    planes = {"depth": depth, "z": emission.focus, "origin": "coverslip"}
    excitation = WATER.pupil(**planes, wavelength=640e-9, emitter=lm.Beam(polarization))
    return excitation, WATER.pupil(**planes, wavelength=775e-9, emitter=lm.Beam(depleting)), emission


def sted(saturation, tol=1e-6, polarization="circular", **given):
    excitation, depletion, emission = three(polarization, **given)
    return Sted(excitation, 1.0, tol, depletion=depletion, saturation=saturation), emission


@pytest.mark.parametrize("tol", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("polarization", ["circular", "x"])
@pytest.mark.parametrize("saturation", [3.0, 200.0])
def test_what_is_left_is_that_of_plane_waves(saturation, polarization, tol):
    way, emission = sted(saturation, tol, polarization)
    made = lm.psf(emission, 5, PIXEL, method=way, integrate=False, normalize="strehl")
    y, x = np.mgrid[-2:3, -2:3] * PIXEL
    _, doughnut, _ = three()
    depleting = intensity(WATER, doughnut, x.ravel(), y.ravel(), 40, 64).reshape(2, 5, 5) / doughnut.power[0]
    confocal = Confocal(way.excitation, 1.0, 1e-10)
    before = lm.psf(emission, 5, PIXEL, method=confocal, integrate=False, normalize="strehl").values
    exact = before * 2.0 ** (-saturation * depleting)
    off = np.abs(made.values - exact).max(axis=(1, 2))
    assert np.all(off <= made.error_bound * exact.max(axis=(1, 2)) + 1e-10)
    assert made.error_bound <= tol


def test_nothing_depletes_where_there_is_no_saturation():
    for polarization in ("circular", "x"):
        way, emission = sted(0.0, polarization=polarization)
        made = lm.psf(emission, 7, PIXEL, method=way, integrate=False, normalize="strehl")
        plain = lm.psf(emission, 7, PIXEL, method=Confocal(way.excitation), integrate=False, normalize="strehl")
        assert made.values == pytest.approx(plain.values, abs=2e-6)
        assert way.stretch(emission) == Confocal(way.excitation).stretch(emission)


def test_averages_over_pixels_are_those_of_what_is_left():
    way, emission = sted(60.0, 1e-7, z=(0.0,))
    made = lm.psf(emission, 3, PIXEL, method=way, normalize="strehl", integrate=True)
    x, w = gauss_legendre(16, -0.5, 0.5)
    at = (np.arange(-1, 2)[:, None] + x).ravel() * PIXEL
    radius, where = np.unique(np.hypot(at[:, None], at).round(15).ravel(), return_inverse=True)
    fine = way.profile(emission, emission.v(radius)).values[0, where].reshape(3, 16, 3, 16)
    known = np.einsum("aibj,i,j->ab", fine, w, w)
    assert np.abs(made.values[0] - known).max() <= 2e-7 * known.max()


def test_the_crest_is_that_of_the_doughnut_in_focus():
    _, doughnut, _ = three(z=(0.0,))
    lit = lm.psf(doughnut, 65, 1e-6, integrate=False, normalize="strehl", tol=1e-8)
    assert crest(doughnut) == pytest.approx(float(lit.values.max()), rel=1e-4)
    deep = three(z=(0.0,), depth=0.5 * DEPTH)[1]
    assert crest(deep) == pytest.approx(crest(doughnut), rel=1e-9)


def test_it_comes_back_from_what_files_say_of_it():
    way, emission = sted(5.0)
    back = method_from_dict(json.loads(json.dumps(way.to_dict())))
    assert back == way
    made = [lm.psf(emission, 5, PIXEL, method=each, normalize="strehl").values for each in (way, back)]
    assert np.array_equal(*made)
