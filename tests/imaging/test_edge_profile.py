"""Edges that are curved, unevenly lit or have hot pixels, located within hundredths of a pixel."""

from __future__ import annotations

import numpy as np
import pytest

from lommel.imaging.edge_profile import Transform, locate
from slanted_edges import gaussian, picture

KNOWN = np.ones((80, 80), bool)
EDGE = picture(5.0, 0.6, (80, 80), 8)
F = np.linspace(0.0, 0.5, 6)


def measured(edge):
    position, profile, _, variances = edge.profile
    values, _ = Transform(position).response(profile, variances)
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


def test_noise_hides_less_that_both_sides_fall_than_that_they_change():
    # Nothing but added light makes both fall: two standard errors tell it, any other slope takes three.
    x, turn = (np.arange(80) - 39.5) / 80.0, np.radians(5.0)
    image = EDGE * (1.0 + 0.2 * x) - 0.05 * (np.cos(turn) * x + np.sin(turn) * x[:, None])
    found = [locate(image + np.random.default_rng(k).normal(0.0, 0.05, image.shape), KNOWN) for k in (0, 1, 4)]
    assert all(-0.1 < edge.tail < -0.03 for edge in found)


def test_what_lies_beyond_is_not_subtracted_where_both_sides_slope():
    # The slope may be uneven light as well: errors contain all of the correction, of which they contain half else.
    d = np.arange(-30.0, 30.0, 1 / 16)
    profile, variances = 0.5 + np.arctan(d / 0.3) / np.pi, np.full(d.size, 1e-10)
    (values, covariance), (kept, larger) = (Transform(d).response(profile, variances, tail) for tail in (0.0, 0.05))
    change = kept - values
    assert change[10] > 5e-3
    right = np.exp(-2.0 * np.pi * 0.3 * np.linspace(0.0, 0.5, values.size))
    np.testing.assert_allclose(values, right, atol=1e-3)
    errors = [np.sqrt(np.diag(part))[5:] for part in (covariance, larger)]
    assert np.all(errors[0] < 0.7 * np.abs(change[5:]))
    assert np.all(errors[1] >= np.abs(change[5:]))


@pytest.mark.parametrize("sigma", [3.0, 4.0])
def test_a_wide_gaussian_blur_has_no_halo_beyond_the_picture(sigma):
    edge = locate(picture(5.0, sigma, (64, 50), 8), np.ones((64, 50), bool))
    values, covariance = Transform(edge.profile[0]).response(edge.profile[1], edge.profile[3])
    f = np.linspace(0.0, 0.5, values.size)
    # An approach to the sides like 1 / distance, fitted to the foot of the edge, changes values by 0.01 and 0.04.
    assert np.abs(values - gaussian(f, np.radians(5.0), sigma))[1:].max() < 4e-3
    assert np.sqrt(np.diag(covariance)).max() < 2e-3


def test_errors_contain_that_of_a_trend_that_was_divided_out():
    x = (np.arange(60) - 29.5) / 60.0
    light = (0.3 + 0.5 * picture(5.0, 0.6, (60, 60), 8)) * (1.0 + 0.25 * x)
    off = []
    for seed in range(12):
        edge = locate(np.random.default_rng(seed).normal(light, 0.01), np.ones((60, 60), bool))
        values, covariance = Transform(edge.profile[0]).response(edge.profile[1], edge.profile[3], unsure=edge.unsure)
        at = round(0.06 * 2.0 * (values.size - 1))
        right = gaussian(0.5 * at / (values.size - 1), np.radians(5.0), 0.6)
        off.append((values[at] - right) / np.sqrt(covariance[at, at]))
    assert 0.6 < np.sqrt(np.mean(np.square(off))) < 1.4  # 2.4 without it
