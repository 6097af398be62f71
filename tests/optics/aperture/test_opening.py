"""Openings: their rules, their coverage of cells."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st
from scipy.special import j1, jv

import lommel as lm
from lommel.measures.continuous_image import phased_cells
from lommel.optics.aperture.mask import cell_centers
from lommel.optics.aperture.opening import Opening, degree_needed
from lommel.optics.aperture.shapes import CatEye, Ellipse, Spider
from lommel.special import zernike


def lens_area(d: float, r: float) -> float:
    """Area of the unit disc within a circle of radius r at the distance d, over pi (elementary geometry)."""
    if d <= abs(1.0 - r):
        return min(1.0, r) ** 2
    root = math.sqrt((-d + 1 + r) * (d + 1 - r) * (d - 1 + r) * (d + 1 + r))
    first = math.acos((d * d + 1 - r * r) / (2 * d))
    return (first + r * r * math.acos((d * d + r * r - 1) / (2 * d * r)) - 0.5 * root) / math.pi


def segment(width: float, radius: float) -> float:
    """Area of one half of a bar of a width across a disc, over pi."""
    h = 0.5 * width / radius
    return radius**2 * (math.asin(h) + h * math.sqrt(1.0 - h * h)) / math.pi


@pytest.mark.parametrize("degree", [0, 1, 2, 5, 8, 13])
@pytest.mark.parametrize("eps", [0.0, 0.37])
def test_on_discs_and_annuli_all_moments_up_to_the_degree_are_exact(degree, eps):
    x, y, w = Opening(eps).rule(degree)
    for i in range(degree + 1):
        for j in range(degree + 1 - i):
            n = i + j
            even = i % 2 == 0 == j % 2
            gamma = math.gamma
            ring = 2 * gamma((i + 1) / 2) * gamma((j + 1) / 2) / gamma(n / 2 + 1) if even else 0.0
            exact = ring * (1 - eps ** (n + 2)) / (n + 2) / math.pi
            assert w @ (x**i * y**j) == pytest.approx(exact, abs=2e-16 + 2e-15 * exact)


@given(st.floats(0.1, 1), st.floats(0.1, 1), st.floats(-4, 4))
def test_an_ellipse_has_its_area_and_its_moments_of_inertia(a, b, angle):
    x, y, w = Opening(0.0, None, Ellipse(a, b, angle)).rule(4)
    s, t = x * math.cos(angle) + y * math.sin(angle), y * math.cos(angle) - x * math.sin(angle)
    assert w.sum() == pytest.approx(a * b, rel=1e-13)
    assert w @ s**2 == pytest.approx(a**3 * b / 4, rel=1e-12)
    assert w @ t**2 == pytest.approx(a * b**3 / 4, rel=1e-12)
    assert w @ (s * t) == pytest.approx(0.0, abs=1e-15)


@given(st.floats(0, 2.5), st.floats(-4, 4), st.floats(0.05, 3))
@example(1.5, 0.0, 2.5)  # touches from outside, but for rounding
def test_a_cat_eye_has_the_area_of_two_circles_that_overlap(distance, direction, radius):
    assume(distance < 1 + radius - 1e-6)
    eye = CatEye((distance * math.cos(direction), distance * math.sin(direction)), radius)
    x, y, w = Opening(0.0, None, eye).rule(12)
    assert w.sum() == pytest.approx(lens_area(math.hypot(*eye.shift), radius), rel=1e-9, abs=1e-13)
    # By symmetry its centre of gravity lies towards the second circle.
    assert w @ (x * math.sin(direction) - y * math.cos(direction)) == pytest.approx(0.0, abs=1e-13)


@pytest.mark.parametrize("direction", [0.0, 1.0, 2.609375])
@pytest.mark.parametrize("radius", [0.4, 1.0, 2.0])
@pytest.mark.parametrize("off", [-1e-7, -1e-15, 0.0, 1e-15, 1e-12, 1e-7])
def test_the_rim_of_the_second_circle_may_pass_by_or_through_the_axis(off, radius, direction):
    shift = (radius + off) * math.cos(direction), (radius + off) * math.sin(direction)
    rule = Opening(0.0, None, CatEye(shift, radius)).rule(40)
    assert rule.weight.sum() == pytest.approx(lens_area(radius + off, radius), rel=1e-12)


@given(st.floats(1e-4, 0.2), st.floats(0.3, 0.9), st.floats(-4, 4), st.integers(1, 6))
def test_vanes_on_an_annulus_take_away_their_area(width, eps, first, count):
    rule = Opening(eps, Spider.equal(count, width, first)).rule(6)
    vane = segment(width, 1.0) - segment(width, eps)
    assert rule.weight.sum() == pytest.approx(1 - eps**2 - count * vane, rel=1e-13)


spiders = st.none() | st.builds(
    Spider.equal, st.integers(1, 5), st.floats(1e-3, 0.6), st.floats(-3, 3)
) | st.builds(Spider, st.floats(1e-3, 0.4), st.lists(st.floats(-3, 3), min_size=1, max_size=4))  # fmt: skip
edges = (
    st.none()
    | st.builds(Ellipse, st.floats(0.2, 1), st.floats(0.2, 1), st.floats(-3, 3))
    | st.builds(CatEye, st.tuples(st.floats(-0.8, 0.8), st.floats(-0.8, 0.8)), st.floats(0.2, 2))
)
openings = st.builds(Opening, st.just(0.0) | st.floats(0.02, 0.8), spiders, edges)


@given(openings, st.floats(0, 6.3), st.integers(20, 90))
def test_every_rule_is_positive_lies_where_light_passes_and_integrates_what_it_promises(opening, direction, degree):
    x, y, w = opening.rule(degree)
    fine = opening.rule(2 * degree + 30)
    assert np.all(w >= 0)
    if w.size:
        assert opening.margin(x, y).min() >= -1e-9
    # A plane wave that polynomials of the degree reach, by the bound for discs.
    v = 2.0
    while degree_needed([], 1.1 * v, lm.Apodization(), 1e-11) <= degree:
        v *= 1.1

    def field(x, y, w):
        return w @ np.exp(1j * v * (x * math.cos(direction) + y * math.sin(direction)))

    assert abs(field(x, y, w) - field(*fine)) <= 1e-11


def test_a_degree_suffices_for_all_wavefronts_of_a_stack():
    sizes = {2: np.array([3.0, 0.0, 1.0]), 5: np.array([0.0, 2.0, 0.5])}
    each = [degree_needed([(n, size[i]) for n, size in sizes.items()], 7.0, lm.Apodization(), 1e-7) for i in range(3)]
    both = degree_needed(list(sizes.items()), 7.0, lm.Apodization(), 1e-7)
    most = degree_needed([(n, size.max()) for n, size in sizes.items()], 7.0, lm.Apodization(), 1e-7)
    assert max(each) <= both < most
    assert both <= max(each) + 1
    twice = degree_needed([(2, 1.0), (2, 2.0), (5, 0.0)], 7.0, lm.Apodization(), 1e-7)
    assert twice == each[0]


def test_likely_strehl_ratios_fall_with_phases_of_segments():
    segments = lm.Segments.hexagonal(1)
    tilted, scattered = segments.phased(tip=4.0), segments.phased(np.linspace(0.0, 2.0 * np.pi, 7)[:6])
    assert Opening(0.3).likely_strehl == Opening(stop=segments).likely_strehl == 1.0
    assert Opening(stop=scattered).likely_strehl == pytest.approx(1.0 / 6.0)
    assert Opening(stop=tilted).likely_strehl < 0.7


def covered(opening, side):
    at = cell_centers(side)
    return opening.coverage(at[None, :], at[:, None], 1.0 / side)


@given(openings, st.integers(2, 24))
def test_coverage_is_the_part_of_each_cell_that_is_clear(opening, side):
    part = covered(opening, side)
    assert np.all((part >= -1e-11) & (part <= 1.0 + 1e-11))
    assert part.sum() * 4 / side**2 == pytest.approx(math.pi * opening.rule(8).weight.sum(), abs=1e-12)
    # Of a cell cut in four it is the mean.
    np.testing.assert_allclose(
        part, covered(opening, 2 * side).reshape(side, 2, side, 2).mean(axis=(1, 3)), atol=1e-11
    )


def test_a_vane_much_narrower_than_a_cell_covers_what_it_is_wide():
    strip = lm.Polygon([(-0.9, -2e-4), (0.9, -2e-4), (0.9, 2e-4), (-0.9, 2e-4)])
    for stop in (lm.Disc() - strip, lm.Disc() - strip.turned(0.5)):
        area = covered(Opening(stop=stop), 64).sum() * 4 / 64**2
        assert math.pi - area == pytest.approx(1.8 * 4e-4, rel=1e-9)


@pytest.mark.parametrize("operation", ["|", "&", "-"])
def test_cells_know_what_parts_are_none_and_all_of_them(operation):
    square = lm.Polygon([(-0.7, -0.7), (0.7, -0.7), (0.7, 0.7), (-0.7, 0.7)])
    first, second = square.turned(0.2), lm.Ellipse(0.8, 0.3, 0.4)
    stop = {"|": first | second, "&": first & second, "-": first - second}[operation]
    for side, shape in ((5, stop), (40, stop), (40, lm.Disc() - stop), (11, (lm.Disc(0.5) | stop) - lm.Disc(0.2))):
        opening = Opening(stop=shape)
        at = cell_centers(side * 40)
        points = opening.margin(at[None, :], at[:, None]) >= 0.0
        np.testing.assert_allclose(
            covered(opening, side), points.reshape(side, 40, side, 40).mean(axis=(1, 3)), atol=0.03
        )
        area = covered(opening, side).sum() * 4 / side**2
        assert area == pytest.approx(math.pi * opening.rule(8).weight.sum(), abs=1e-12)


@given(st.floats(0.1, 400), st.floats(2, 13))
def test_the_degree_for_a_plane_wave_is_enough_and_not_much_too_high(v, digits):
    degree = degree_needed([], v, lm.Apodization(), 10.0**-digits)
    x, y, w = Opening().rule(degree)
    assert abs(w @ np.exp(1j * v * (0.6 * x + 0.8 * y)) - 2 * j1(v) / v) <= 10.0**-digits + 1e-15
    # Below v the Bessel functions that are left out are not small.
    assert v <= degree + 8 <= v + 6 * v ** (1 / 3) * digits ** (2 / 3) + 3 * digits + 24


@given(
    st.sampled_from([(2, 0), (2, 2), (3, 1), (4, 0), (5, -3), (8, 2)]),
    st.floats(0, 30),
    st.floats(0, 40),
    st.floats(0, 3),
)
def test_the_degree_for_an_aberration_is_enough(term, amplitude, v, gaussian):
    n, m = term
    degree = degree_needed([(n, amplitude)], v, lm.Apodization.gaussian(gaussian), 1e-9)
    found = []
    for rule in (Opening().rule(degree), Opening().rule(2 * degree + 40)):
        rho, theta = np.hypot(rule.x, rule.y), np.arctan2(rule.y, rule.x)
        phase = amplitude * zernike.polynomial(n, m, rho, theta) - v * rule.x
        found.append(rule.weight @ np.exp(1j * phase - gaussian * rho**2))
    assert abs(found[0] - found[1]) <= 1e-9


def test_astigmatism_in_the_middle_is_a_bessel_function():
    # (1/pi) int exp(i a rho^2 cos 2 theta) = int_0^1 J0(a t) dt.
    a = 25.0
    x, y, w = Opening().rule(degree_needed([(2, a)], 0.0, lm.Apodization(), 1e-13))
    t, u = np.polynomial.legendre.leggauss(60)
    exact = 0.5 * u @ jv(0, 0.5 * a * (t + 1))
    assert w @ np.exp(1j * a * (x * x - y * y)) == pytest.approx(exact, abs=1e-13)


OPENINGS = {
    "annulus": {"obscuration": 0.3},
    "vanes": {"vignetting": lm.Ellipse(0.9, 0.5, 0.4), "spider": lm.Spider.equal(3, 0.05)},
    "cat-eye": {"vignetting": lm.CatEye((0.3, 0.2), 1.0)},
    "vlt": {"stop": lm.telescopes.vlt()},
    "jwst": {"stop": lm.telescopes.jwst()},
}


@pytest.mark.parametrize("name", OPENINGS)
def test_each_cell_is_covered_as_points_say(name):
    opening, at = lm.Pupil(**OPENINGS[name]).opening, cell_centers(64)
    fine = cell_centers(64 * 32)
    points = (opening.margin(fine[None, :], fine[:, None]) >= 0.0).reshape(64, 32, 64, 32).mean(axis=(1, 3))
    np.testing.assert_allclose(phased_cells(opening, 64).real, points, atol=0.05)
    if opening.circular:
        exact = opening.coverage(at[None, :], at[:, None], 1.0 / 64)
        np.testing.assert_allclose(phased_cells(opening, 64).real, exact, atol=0.02)


def test_segments_turn_the_phase_of_their_cells():
    stop = lm.Segments.hexagonal(1, 0.02).phased([0.3, 0.5, 0, 0, 0, -0.7], [2.0, 0, 0, 0, 0, 1.0], unit="radians")
    opening, at = lm.Pupil(stop=stop).opening, cell_centers(256)
    x, y = np.meshgrid(at, at)
    whole = phased_cells(lm.Pupil(stop=stop.scaled(0.0)).opening, 256).real > 1.0 - 1e-12
    exact = np.exp(1j * opening.phase(x, y))
    np.testing.assert_allclose(phased_cells(opening, 256)[whole], exact[whole], atol=2e-5)
