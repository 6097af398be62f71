"""Averages over discs: against means that are known in closed form, and what bounds them."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import j0, j1, jv

from lommel.methods.layers.samples import ETA, between, disc_means, gauss_error, growth
from lommel.special.legendre import gauss_legendre

V = np.array([0.0, 0.3, 1.7, 5.0, 17.3, 120.0])


@pytest.mark.parametrize("radius", [1e-3, 0.4, 3.8, 25.0])
@pytest.mark.parametrize("error", [1e-3, 1e-6, 1e-10])
@pytest.mark.parametrize("frequency", [2.0, 1.3, 0.0])
def test_means_of_a_wave_are_within_the_bound(radius, error, frequency):
    # (1 + J0(q v)) / 2 lies between 0 and 1; its mean over a disc is that times 2 J1(q a) / (q a).
    means = disc_means(V, radius, error)
    at = frequency * radius
    known = 0.5 * (1.0 + j0(frequency * V) * (2.0 * j1(at) / at if at else 1.0))
    found = 0.5 * (1.0 + j0(frequency * means.places)) @ means.weights[0]
    assert np.abs(found - known).max() <= means.error
    assert means.error <= 1.01 * error


@pytest.mark.parametrize("radius", [0.4, 3.8])
@pytest.mark.parametrize("error", [1e-3, 1e-10])
def test_means_of_orders_of_the_azimuth_are_within_the_bound(radius, error):
    # J_m(q r) cos(m phi), too, is a sum of waves of the frequency q, whose means over discs are alike.
    means = disc_means(V, radius, error, 4)
    orders = np.abs(np.arange(-4, 5))
    found = means.of(0.1 * jv(orders[:, None], 2.0 * means.places)[None])[0]
    known = 0.1 * jv(orders[:, None], 2.0 * V) * j1(2.0 * radius) / radius
    assert np.abs(found - known).max() <= means.error


def test_the_bound_is_met_within_three_orders():
    # No means are so exact that the bound could be a formality.
    worst = 0.0
    for radius in np.linspace(0.2, 6.0, 30):
        means = disc_means(V, radius, 1e-4)
        known = 0.5 * (1.0 + j0(2.0 * V) * j1(2.0 * radius) / radius)
        worst = max(worst, np.abs(0.5 * (1.0 + j0(2.0 * means.places)) @ means.weights[0] - known).max())
    assert 1e-7 < worst <= 1e-4


def test_errors_of_values_grow_as_told():
    means = disc_means(V, 2.0, 1e-6)
    signs = np.random.default_rng(0).choice([-1.0, 1.0], size=(500, means.places.size))
    assert np.abs(signs @ means.weights[0]).max() <= means.gain
    assert 1.0 <= means.gain < 4.0
    assert np.ones(means.places.size) @ means.weights[0] == pytest.approx(1.0, abs=1e-14)


def test_errors_between_even_places_grow_most_midway():
    sums = np.abs(between(np.linspace(3.0, 4.0, 2001))[1]).sum(axis=1)
    assert sums.max() <= growth() * (1.0 + 1e-14)
    assert sums.argmax() == 1000


def test_far_discs_take_no_values_elsewhere():
    assert disc_means(np.array([1e5]), 1.0, 1e-6).places.min() > 1e5 - 10.0


@pytest.mark.parametrize("nodes", [1, 2, 4])
def test_the_bound_on_gauss_rules_holds_for_exponentials(nodes):
    x, w = gauss_legendre(nodes)
    exact = np.expm1(1.5) / 1.5
    # exp(1.5 t) grows like exp(0.75 (1 + cosh(eta))) around [0, 1].
    bound = gauss_error(0.75 * (1.0 + np.cosh(ETA)), nodes)
    assert abs(np.exp(1.5 * x) @ w - exact) <= bound
    assert bound < 2e4 * abs(np.exp(1.5 * x) @ w - exact)
