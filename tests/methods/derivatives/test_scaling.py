"""How images change as they grow: against quadrature over pixels and pupil, and the filter of growing pixels."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from disk_quadrature import exact_lattice
from lommel.core.answers import Wanted
from lommel.methods import ChordalGauss, NijboerZernike
from lommel.methods.averaging import averaging_filter, slope_filter
from lommel.methods.derivatives import TILTS, scaling_derivative, tilted
from lommel.optics.grid import Grid

PUPIL = lm.Pupil(lm.Wavefront(1.5, 0.7, nonradial={(3, 1): 0.8, (2, -2): 0.5}), obscuration=0.25, apodization=0.4)


@pytest.mark.parametrize("step", [0.05, 0.785, 1.6, 3.0, 11.0, 60.0])
@pytest.mark.parametrize("error", [1e-5, 1e-9, 1e-12])
def test_the_response_of_a_growing_pixel_is_the_derivative_of_that_of_a_pixel(step, error):
    taps = averaging_filter(step, error, by_pitch=True)
    k = np.arange(taps.weights.size) - taps.weights.size // 2
    w = np.linspace(0.0, 2.0, 8001)
    response = np.cos(np.outer(w, k * step / taps.stride)) @ taps.weights
    half = 0.5 * step * w
    off = np.abs(response - (np.cos(half) - np.sinc(half / math.pi))).max()
    assert off <= taps.error <= error
    assert np.abs(taps.weights).sum() == pytest.approx(taps.gain)
    assert taps.gain <= 3.0


@pytest.mark.parametrize("step", [0.157, 0.785, 3.0, 11.0])
@pytest.mark.parametrize("error", [1e-5, 1e-9, 1e-12])
@pytest.mark.parametrize("averages", [False, True])
def test_the_response_to_slopes_is_odd_and_that_of_a_derivative(step, error, averages):
    taps = slope_filter(step, error, averages=averages)
    k = np.arange(taps.weights.size) - taps.weights.size // 2
    w = np.linspace(0.0, 2.0, 4001)
    wave = np.exp(1j * np.outer(w, k * step / taps.stride)) @ taps.weights
    wanted = w * (np.sinc(0.5 * step * w / math.pi) if averages else 1.0)
    assert np.abs(wave - 1j * wanted).max() <= taps.error <= error
    assert np.abs(taps.weights).sum() == pytest.approx(taps.gain)


@pytest.mark.parametrize("integrate", [False, True])
@pytest.mark.parametrize("pixel", [0.05, 0.5, 1.3])
@pytest.mark.parametrize("tol", [1e-4, 1e-9])
def test_slopes_from_samples_are_those_by_tilts(integrate, pixel, tol):
    pupil = lm.Pupil(lm.Wavefront([2.0, -9.0], [1.0, 4.0]), obscuration=0.3, apodization=0.4)
    for center in ((1.3, 2.6), (np.array([1.0, -3.0]), np.array([2.2, 9.0]))):
        grid = Grid((4, 5), pixel, center=center, integrate=integrate)
        truth = ChordalGauss(1e-9).images(pupil, grid, Wanted(terms=TILTS))
        found = tilted(NijboerZernike(tol), pupil, grid)
        for (values, error), exact, known in zip(found, *truth.slopes, strict=True):
            assert np.all(np.abs(values - exact).max(axis=(1, 2)) <= error + known * truth.peak)
            assert np.all(error <= 20.0 * tol)


@pytest.mark.parametrize("integrate", [False, True])
@pytest.mark.parametrize("tol", [1e-5, 1e-11])
def test_growth_is_that_of_quadrature(integrate, tol):
    grid = Grid((4, 5), 0.55, center=(1.3, 2.6), integrate=integrate)
    step, method = grid.step(PUPIL), ChordalGauss(tol)
    rule, weight = np.polynomial.legendre.leggauss(9) if integrate else (np.zeros(1), np.array([2.0]))
    vx, vy = (
        (step * (np.arange(side)[:, None] - c + 0.5 * rule)).ravel()
        for side, c in ((5, grid.axis[1]), (4, grid.axis[0]))
    )
    # v . grad I by differences of the length of v: exact to 1e-12 for a function of type 2.
    h = 2e-2 / math.hypot(np.abs(vx).max(), np.abs(vy).max())
    longer = (1.0 + k * h for k in (-3, -2, -1, 1, 2, 3))
    i = [np.abs(exact_lattice(PUPIL, vx * by, vy * by, 30, 120)) ** 2 for by in longer]
    change = (0.75 * (i[3] - i[2]) - 0.15 * (i[4] - i[1]) + (i[5] - i[0]) / 60.0) / h
    weights = 0.25 * np.multiply.outer(weight, weight)
    exact = np.einsum("iajb,ab->ij", change.reshape(4, rule.size, 5, rule.size), weights)
    made = method.images(PUPIL, grid, Wanted(terms=TILTS))
    tilts = [(slope, error * made.peak) for slope, error in zip(*made.slopes, strict=True)]
    found, bound = scaling_derivative(method, PUPIL, grid, tilts)
    off = np.abs(found[0] - exact).max()
    assert off <= bound[0] + 2e-11
    assert bound[0] <= 20.0 * tol
