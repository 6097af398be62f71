"""Edges that are curved, unevenly lit or have hot pixels, located within hundredths of a pixel."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.imaging.edge_profile import locate, response
from slanted_edges import gaussian, picture

KNOWN = np.ones((80, 80), bool)
EDGE = picture(5.0, 0.6, (80, 80), 8)
F = np.linspace(0.0, 0.5, 6)


def measured(edge):
    position, profile, _, variances = edge.profile
    values, _ = response(position, profile, variances)
    return np.interp(F, np.linspace(0.0, 0.5, values.size), values)


def expected(degrees):
    return gaussian(F, np.radians(degrees), 0.6)


@pytest.mark.parametrize("bent", [0.0, 0.5, 2.0])  # pixels at the ends of the edge
def test_a_curved_edge_is_followed(bent):
    edge = locate(picture(5.0, 0.6, (80, 80), 8, curvature=bent / 1600), KNOWN)
    assert edge.curvature == pytest.approx(bent, abs=0.02 + 0.05 * bent)
    np.testing.assert_allclose(measured(edge), expected(5.0), atol=3e-3)


def test_noise_bends_no_edge():
    draw = np.random.default_rng(3)
    edges = [locate(EDGE + draw.normal(0.0, 0.03, EDGE.shape), KNOWN) for _ in range(5)]
    assert [edge.curvature for edge in edges] == [0.0] * 5
    assert np.std([edge.slope for edge in edges]) < 2e-3


@pytest.mark.parametrize(("across", "along"), [(0.4, 0.0), (-0.2, 0.1), (0.0, 0.3)])
def test_a_linear_trend_of_the_light_is_divided_out(across, along):
    x = (np.arange(80) - 39.5) / 80.0
    edge = locate(EDGE * (1.0 + across * x + along * x[:, None]), KNOWN)
    assert edge.trend == pytest.approx(max(abs(across), abs(along)), rel=0.2)
    np.testing.assert_allclose(measured(edge), expected(5.0), atol=3e-3)


def test_light_that_is_added_is_subtracted():
    x, turn = (np.arange(80) - 39.5) / 80.0, np.radians(5.0)
    edge = locate(EDGE - 0.1 * (np.cos(turn) * x + np.sin(turn) * x[:, None]), KNOWN)
    np.testing.assert_allclose(measured(edge), expected(5.0), atol=5e-3)


def test_pixels_far_from_the_profile_are_left_out():
    image = EDGE.copy()
    image[[10, 40, 41, 70], [5, 44, 38, 45]] = [0.9, 10.0, -3.0, 2.0]
    edge = locate(image, KNOWN)
    assert edge.outliers == 4
    np.testing.assert_allclose(measured(edge), expected(5.0), atol=3e-3)


def test_unknown_pixels_do_not_count():
    y, x = np.indices(EDGE.shape)
    known = (x + y) % 2 == 0
    np.testing.assert_allclose(measured(locate(np.where(known, EDGE, 7.0), known)), expected(5.0), atol=3e-3)


@pytest.mark.parametrize(("across", "along"), [(0.02, 0.02), (0.12, 0.08), (-0.06, -0.06)])
def test_light_that_falls_off_along_and_across_the_edge_is_divided_out(across, along):
    x = (np.arange(80) - 39.5) / 40.0
    image = EDGE * (1.0 - across * x**2 - along * x[:, None] ** 2)
    edge = locate(np.random.default_rng(0).normal(image, 1e-3), KNOWN)
    assert edge.tail == 0.0
    np.testing.assert_allclose(measured(edge), expected(5.0), atol=5e-3)


@pytest.mark.parametrize("degrees", [41.3, 43.6, -44.2])
def test_an_edge_near_45_degrees_is_measured(degrees):
    edge = locate(picture(degrees, 0.6, (80, 120), 8), np.ones((80, 120), bool))
    np.testing.assert_allclose(measured(edge), expected(degrees), atol=3e-3)


@pytest.mark.parametrize("sigma", [3.0, 4.0])
def test_a_wide_gaussian_blur_has_no_halo_beyond_the_picture(sigma):
    edge = locate(picture(5.0, sigma, (64, 50), 8), np.ones((64, 50), bool))
    values, covariance = response(*[edge.profile[k] for k in (0, 1, 3)])
    f = np.linspace(0.0, 0.5, values.size)
    # An approach to the sides like 1 / distance, fitted to the foot of the edge, changes values by 0.01 and 0.04.
    assert np.abs(values - gaussian(f, np.radians(5.0), sigma))[1:].max() < 4e-3
    assert np.sqrt(np.diag(covariance)).max() < 2e-3
