"""Terms of the certificate of apertures of shapes, from the formulas of its section 18."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lommel import Disc, Ellipse, Polygon
from lommel.optics.aperture.opening import Opening
from lommel.special import zernike

complexes = st.complex_numbers(max_magnitude=3.0, allow_nan=False, allow_infinity=False)


def growth(x, y):
    """Lundin's formula for b."""
    return 0.5 * np.arccosh(np.maximum(1.0, abs(x) ** 2 + abs(y) ** 2 + abs(x * x + y * y - 1.0)))


def of_interval(z):
    return np.arccosh(np.maximum(1.0, 0.5 * (abs(z - 1.0) + abs(z + 1.0))))


@pytest.mark.theorem
@given(complexes, complexes)
def test_growth_off_the_disc_is_the_largest_of_those_of_intervals(x, y):
    # Baran: convex where below a limit, since each is.
    angles = np.linspace(0.0, math.pi, 20001)
    along = of_interval(x * np.cos(angles) + y * np.sin(angles))
    assert growth(x, y) == pytest.approx(along.max(), abs=2e-3)
    assert along.max() <= growth(x, y) + 1e-7


@pytest.mark.theorem
@given(st.floats(-0.999, 0.999), complexes)
def test_growth_along_a_row_is_that_of_its_chord_at_most(y, xi):
    h = math.sqrt(1.0 - y * y)
    b1 = of_interval(xi)
    assert growth(h * xi, y) == pytest.approx(math.asinh(h * math.sinh(b1)), abs=1e-6)
    assert growth(h * xi, y) <= b1 + 1e-7


@pytest.mark.theorem
@given(complexes, complexes, complexes, st.floats(0, 1))
def test_between_two_points_growth_is_at_most_that_of_the_worse(first, second, y, part):
    assert growth((1 - part) * first + part * second, y) <= max(growth(first, y), growth(second, y)) + 1e-7


@pytest.mark.theorem
@given(st.integers(0, 12), st.integers(0, 24), st.floats(-1.5, 1.5), st.floats(-1.5, 1.5), st.floats(0, 1))
def test_polynomials_grow_no_faster(degree, m, real, imaginary, size):
    n = m + 2 * min(degree, (24 - m) // 2)
    x, y = real + 1j * size * imaginary, imaginary - 1j * size * real * 0.7
    # rho^m cos(m theta) R(rho^2) at complex points.
    with mpmath.workdps(40):
        t = mpmath.mpc(x) ** 2 + mpmath.mpc(y) ** 2
        angular = ((mpmath.mpc(x) + 1j * mpmath.mpc(y)) ** m + (mpmath.mpc(x) - 1j * mpmath.mpc(y)) ** m) / 2
        value = abs(angular * mpmath.jacobi((n - m) // 2, 0, m, 2 * t - 1))
    assert float(mpmath.log(value + mpmath.mpf(10) ** -300)) <= n * growth(x, y) + 1e-6


@pytest.mark.theorem
@pytest.mark.parametrize("nodes", [1, 2, 3, 7, 20])
def test_gauss_errs_by_at_most_the_constant(nodes):
    x, w = np.polynomial.legendre.leggauss(nodes)
    for k in range(2 * nodes, 12 * nodes + 40, 2):
        error = abs(w @ np.cos(k * np.arccos(x)) - 2.0 / (1.0 - k * k))
        assert 2.0 * error <= 64.0 / 15.0 + 1e-12


@pytest.mark.theorem
@given(st.floats(0.05, 3), st.floats(-3.1, 3.1), st.floats(0.01, 4), st.floats(0, 1), st.floats(-3.2, 3.2))
def test_the_root_of_a_disc_holds_roots(size, angle, radius, part, turn):
    centre = size * np.exp(1j * angle)
    z = centre + part * radius * np.exp(1j * turn)
    if radius >= size:
        assert abs(np.sqrt(z)) <= math.sqrt(size + radius) + 1e-12
        return
    root = np.sqrt(centre)
    # The branch that is continuous from the centre.
    there = root * np.sqrt(z / centre)
    assert abs(there - root) <= math.sqrt(size) - math.sqrt(size - radius) + 1e-12


def chebyshev(degree, x, y, angle):
    return np.cos(degree * np.arccos(np.clip(x * math.cos(angle) + y * math.sin(angle), -1, 1)))


@pytest.mark.parametrize("degree", [1, 15, 48, 96])
@pytest.mark.parametrize(
    "shape", [Disc(), Polygon.regular(5, 0.8, (0.1, 0.1)), Ellipse(0.9, 0.2, 0.4)], ids=["d", "p", "e"]
)
def test_rules_of_few_nodes_are_within_their_error(shape, degree):
    # What grows fastest off the disc, along any direction; against a rule that is exact to rounding.
    rounded = -(-degree // 16) * 16
    (exact,) = Opening(stop=shape).rows(rounded, 1e-15)
    for error in (1e-1, 1e-2, 1e-4, 1e-8):
        (rule,) = Opening(stop=shape).rows(degree, error)
        assert rule.nodes.shape[1] <= exact.nodes.shape[1]
        worst = 0.0
        for angle in np.linspace(0.0, math.pi, 9):
            for n in (rounded, rounded - 1, rounded // 2):
                found, known = (r.nodes[2] @ chebyshev(n, *r.nodes[:2], angle) for r in (rule, exact))
                worst = max(worst, abs(found - known))
        assert worst <= error + 1e-13


@pytest.mark.parametrize(("n", "m"), [(8, 0), (20, 4), (31, 3), (40, 40)])
def test_terms_change_by_at_most_the_square_of_their_degree(n, m):
    rng = np.random.default_rng(n)
    rho, theta = np.sqrt(rng.uniform(0, 0.999, 400)), rng.uniform(-3, 3, 400)
    x, y = rho * np.cos(theta), rho * np.sin(theta)

    def at(dx, dy):
        return zernike.polynomial(n, m, np.hypot(x + dx, y + dy), np.arctan2(y + dy, x + dx))

    h = 1e-6
    slope = np.hypot(at(h, 0) - at(-h, 0), at(0, h) - at(0, -h)) / (2 * h)
    assert slope.max() <= n * n + 1e-4


def test_the_roundings_of_a_turned_ellipse_are_counted():
    # The same circle turned: sines, cosines and the difference in the slope of its middles are rounded as well.
    lost = []
    for angle in (0.0, 0.6):
        (rule,) = Opening(stop=Ellipse(900.0, 900.0, angle, (0.0, -900.2))).rows(0, 1e-15)
        assert rule.weight == pytest.approx(
            Opening(stop=Disc(900.0, (0.0, -900.2))).rows(0, 1e-15)[0].weight, rel=1e-11
        )
        lost.append(rule.lost)
    # The slope is 2 sin cos - 2 cos sin; both sides of about 0.8 of rows, 900 from the centre.
    assert (
        lost[1] - lost[0] > 0.8 * 20.0 * 1.1e-16 * 2.0 * math.sin(0.6) * math.cos(0.6) * 900.0 * 2.0 * 0.8 / math.pi
    )
