"""Every term of the bound on averages over pixels of a radial PSF, a second time: mpmath, docs/certificate.md 9."""

from __future__ import annotations

import math
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.special import j0

from core_tests import _core_tests
from digits import same
from lommel import _core
from pixel_tables import Table, U, Window, averages, fewest, gauss, harmonics, interpolation, lebesgue

K = 16  # Chebyshev points across a ring with harmonics


@given(st.floats(1e-3, 1.3), st.integers(1, 900))
def test_interpolation(share, n):
    assert same(_core_tests.interpolation_error(share * n, n), interpolation(share * n, n))


@given(st.floats(1e-3, 300.0), st.integers(1, 300))
def test_gauss_rules_over_a_square(side, q):
    assert same(_core.gauss_error(side, q), gauss(side, q))


@given(st.floats(1e-3, 300.0), st.integers(1, 150))
def test_harmonics(side, angles):
    assert same(_core_tests.harmonics_error(side, angles), harmonics(side, angles))


def test_pixels_that_sample_have_nothing_to_average():
    assert (
        _core_tests.interpolation_error(0.0, 1)
        == _core.gauss_error(0.0, 1)
        == _core_tests.harmonics_error(0.0, 1)
        == 0.0
    )


def table_of(window: Window, level: int) -> Table:
    """Return what the certificate says of a table, from the rings, nodes and harmonics that the core chose."""
    return expected_of(_core_tests.pixel_bounds(*window, level), window.side)


def expected_of(made: dict[str, Any], a: float) -> Table:
    if not made["rings"]:
        return Table(mp.mpf(0), mp.mpf(1), mp.mpf(1), mp.mpf(0))
    n, j = max(ring[4] for ring in made["rings"]), made["harmonics"]
    # Near the axis nodes are those of an even function, half of twice as many.
    worst = max(
        interpolation(high, 2 * count) if even else interpolation((high - low) / 2, count)
        for _, _, low, high, count, even, _ in made["rings"]
    )
    of_nodes, of_grid = lebesgue(n), lebesgue(j) * lebesgue(K) if j else mp.mpf(1)
    error = of_grid * (worst + (gauss(a, made["gauss"]) if a else 0))
    rounding = of_grid * of_nodes * (6 * n + 40)
    if j:
        near, far, *_ = made["rings"][0]
        error += lebesgue(j) * interpolation((far - near) / 2, K) + (harmonics(a, j) if a else 0)
        rounding += of_nodes * 64 * j * (n + j + 20)
    return Table(error, of_nodes, of_grid, rounding)


def some_window(rng: np.random.Generator, largest: int) -> Window:
    step = 10.0 ** rng.uniform(-1.2, 0.9)
    side = min(largest, int(250 / step))
    height, width = (int(n) for n in rng.integers(1, side + 1, 2))
    row, column = [
        (float(height // 2), float(width // 2)),
        tuple(rng.uniform(-0.5, 1.5, 2) * side),
        (0.5 * (height - 1), rng.uniform(-200, 200) / step),
    ][rng.integers(3)]
    return Window(height, width, row, float(column), step, bool(rng.integers(4)))


def test_every_kind_of_table():
    rng, seen = np.random.default_rng(9), set()
    for i in range(160):
        window, level = some_window(rng, 120 if i % 2 else 12), int(rng.integers(3, 15))
        made: dict[str, Any] = _core_tests.pixel_bounds(*window, level)
        expected = table_of(window, level)
        for name, one in expected._asdict().items():
            assert made[name] == pytest.approx(float(one), rel=1e-9, abs=0.0), name
        assert _core.pixel_radii(*window, level, 1)[1:] == tuple(made[name] for name in expected._fields)
        rings, j, away, nodes = made["rings"], made["harmonics"], window.distances(), []
        one = len(rings) == 1 and rings[0][-1]
        seen.add((window.integrate, bool(j), one, bool(rings)))
        if not rings:
            found = np.unique(np.round(window.radii(level), 8))
            assert found == pytest.approx(np.unique(np.round(away, 8)), abs=2e-8)
            continue
        for r0, r1, low, high, count, even, _ in rings:
            # All points of the squares of the ring.
            assert low <= max(0.0, r0 - window.side / math.sqrt(2)) * (1 + 1e-12)
            assert high >= (r1 + window.side / math.sqrt(2)) * (1 - 1e-12)
            assert low == 0.0 or not even
            x = np.cos(np.pi * (np.arange(count) + 0.5) / count)
            nodes.append(high * np.sqrt((1 + x) / 2) if even else (low + high + (high - low) * x) / 2)
        ends = np.array([ring[:2] for ring in rings])
        at = np.searchsorted(ends[:, 0], away * (1 + 1e-12), side="right") - 1
        assert np.all(away <= ends[at, 1] * (1 + 1e-12) + 1e-12)
        assert window.radii(level) == pytest.approx(np.sort(np.concatenate(nodes)), rel=1e-12)
        # Each choice is the least that takes no more than its share.
        allowed = mp.mpf(10) ** -level
        if window.side:
            assert fewest(made["gauss"], 0.1 * allowed, gauss, window.side)
        if j:
            width = rings[0][1] - rings[0][0]
            assert lebesgue(j) * interpolation(width / 2, K) <= 0.3 * allowed
            assert width >= 11.99 or lebesgue(j) * interpolation(width / 2 / 0.98, K) > 0.3 * allowed
            assert window.side == 0.0 or fewest(j, 0.2 * allowed, harmonics, window.side)
            share = 0.2 * allowed / (lebesgue(j) * lebesgue(K))
            assert (
                max(interpolation(h, 2 * n) if e else interpolation((h - l) / 2, n) for _, _, l, h, n, e, _ in rings)
                <= share
            )
        # By harmonic and degree.
        assert made["penalty"] == [1.5 * (k + 1) * (k + 2) + 10 * m * m + 4 * j for m in range(j) for k in range(K)]
    # Averages and samples; harmonics, one ring, rings with a row a pixel, no table at all.
    assert {(True, True, False, True), (False, True, False, True), (True, False, True, True)} <= seen
    assert {(False, False, True, True), (True, False, False, True), (False, False, False, False)} <= seen


def test_rings_around_any_axis():
    rng = np.random.default_rng(4)
    for _ in range(60):
        pitch, level = 10.0 ** rng.uniform(-1.2, 1.1), int(rng.integers(3, 15))
        farthest = float(rng.integers(1, max(2, int(10.0 ** rng.uniform(0.5, 3.2) / pitch))))
        made: dict[str, Any] = _core_tests.ring_bounds(pitch, farthest, level)
        expected, rings = expected_of(made, pitch), made["rings"]
        for name, one in expected._asdict().items():
            assert made[name] == pytest.approx(float(one), rel=1e-9, abs=0.0), name
        # From the axis to the farthest pixel without a gap, all points of their squares.
        width, slack = rings[0][1], pitch / math.sqrt(2)
        assert rings[-1][0] <= farthest * pitch < rings[-1][1]
        for i, (near, far, low, high, count, even, direct) in enumerate(rings):
            assert (near, far) == pytest.approx((i * width, (i + 1) * width), rel=1e-12, abs=1e-12)
            assert low <= max(0.0, near - slack) * (1 + 1e-12)
            assert high >= (far + slack) * (1 - 1e-12)
            assert not direct
            off = interpolation(high, 2 * count) if even else interpolation((high - low) / 2, count)
            assert off <= mp.mpf(10) ** -level / 5 / (lebesgue(made["harmonics"]) * lebesgue(K))
        assert fewest(made["gauss"], mp.mpf(10) ** -level / 10, gauss, pitch)
        assert fewest(made["harmonics"], mp.mpf(10) ** -level / 5, harmonics, pitch)
        assert lebesgue(made["harmonics"]) * interpolation(width / 2, K) <= mp.mpf("0.3") * mp.mpf(10) ** -level


@pytest.mark.parametrize(
    ("window", "level"),
    [
        (Window(90, 90, 45.0, 45.0, 0.8, True), 12),
        (Window(70, 80, 12.3, -4.6, 1.7, True), 13),
        (Window(300, 300, 150.2, 150.4, 0.6, False), 11),
    ],
)
def test_the_rounding_of_harmonics_is_that_of_their_coefficients(window, level):
    """The coefficients again, from averages at the Chebyshev points of a ring and of cos 4 theta."""
    kappa, made = 1.9, _core_tests.pixel_bounds(*window, level)
    _, found = window.values(level, j0(kappa * window.radii(level)))
    j, worst = made["harmonics"], 0.0
    assert j >= 1
    transforms = []
    for n in (j, K):
        c = 2.0 / n * np.cos(np.outer(np.arange(n), np.pi * (np.arange(n) + 0.5) / n))
        c[0] /= 2
        transforms.append(c)
    x, z = (np.cos(np.pi * (np.arange(n) + 0.5) / n) for n in (K, j))
    for near, far, *_, direct in made["rings"]:
        if not direct:
            r, theta = 0.5 * (near + far + (far - near) * x), 0.25 * np.arccos(z)[:, None]
            at = averages(r * np.cos(theta), r * np.sin(theta), window.side, kappa)
            size = np.abs(transforms[0] @ at @ transforms[1].T)
            k, m = np.arange(K), np.arange(j)[:, None]
            worst = max(worst, float((size * (1.5 * (k + 1) * (k + 2) + 10 * m**2 + 4 * j)).sum()))
    assert float(found) == pytest.approx(worst, rel=1e-9, abs=0.0)


# Where a theorem can be reached it is, nearly: a bound much weakened would be broken.


@pytest.mark.parametrize(
    ("window", "level"),
    [
        (Window(1, 40, 0.0, -200.0, 0.05, False), 3),
        (Window(1, 40, 0.0, -200.0, 0.05, False), 6),
        (Window(1, 60, 0.0, -200.0, 0.1, False), 9),
    ],
)
def test_the_fastest_waves_and_the_worst_errors_reach_what_a_ring_claims(window, level):
    v, expected = window.radii(level), table_of(window, level)
    away = window.step * (np.arange(window.width) - window.column)
    worst = max(
        float(np.abs(window.values(level, np.cos(2 * v + phase))[0] - np.cos(2 * away + phase)).max())
        for phase in np.linspace(0, np.pi, 8)
    )
    assert worst <= expected.error <= 2 * worst
    weights = np.array([window.values(level, one)[0] for one in np.eye(v.size)])
    total = np.abs(weights).sum(axis=0).max()
    assert total <= expected.magnification * (1 + 1e-12) <= 1.05 * total


@pytest.mark.parametrize(
    ("window", "level"),
    [
        (Window(6, 9, 3.0, 4.0, 0.8, True), 6),
        (Window(5, 5, 2.2, -31.7, 1.9, True), 13),
        (Window(3, 2, 1.0, 1.0, 9.0, True), 9),
        (Window(70, 80, 12.3, -4.6, 1.7, True), 7),
        (Window(70, 80, 12.3, -4.6, 1.7, False), 7),
    ],
)
def test_a_constant_is_averaged_to_the_roundings(window, level):
    expected, (values, rounded) = table_of(window, level), window.values(level, np.ones_like(window.radii(level)))
    assert np.abs(values - 1.0).max() <= U * (expected.rounding + rounded)


@pytest.mark.parametrize("q", [1, 2, 3])
@pytest.mark.parametrize("side", [0.1, 0.5, 1.0])
def test_gauss_rules_over_the_square_on_the_axis_miss_what_is_claimed_for_the_fastest_radial_function(q, side):
    """J0(2 v) is of type 2 and between -0.41 and 1."""
    rules = [np.polynomial.legendre.leggauss(n) for n in (q, 30)]
    rule, exact = (np.einsum("ab,a,b", j0(side * np.hypot(x[:, None], x)), w / 2, w / 2) for x, w in rules)
    missed = abs(rule - exact)
    assert missed <= 0.71 * gauss(side, q) + 1e-15
    assert gauss(side, q) <= 4 * missed
