"""Every term of the bound on windows around an axis for each pupil, a second time: mpmath, docs/certificate.md 9.

And of what they change by as the axis moves: its error by mpmath, its values by sides of pixels.
"""

from __future__ import annotations

import math
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from scipy.special import j0, j1

from core_tests import _core_tests, instructions
from pixel_tables import U, averages, fewest, gauss, harmonics, interpolation, lebesgue


def questions(count: int):
    rng = np.random.default_rng(12)
    for i in range(count):
        pitch = 10.0 ** rng.uniform(-1.2, 0.8)
        yield (
            pitch,
            bool(i % 2),
            float(rng.integers(1, 1 + max(1, min(90, int(100 / pitch))))),
            int(rng.integers(3, 15)),
        )


def test_what_a_table_leaves_and_magnifies():
    for pitch, averaged, farthest, level in questions(60):
        made: dict[str, Any] = _core_tests.anywhere_bounds(pitch, averaged, farthest, level)
        reach, a, allowed = farthest * pitch, pitch if averaged else 0.0, mp.mpf(10) ** -level
        j, k, radii = made["harmonics"], made["degree"], np.array(made["radii"])
        n, far = len(radii), reach + a / math.sqrt(2)
        x = np.cos(np.pi * (np.arange(n)[::-1] + 0.5) / n)
        assert radii == pytest.approx(far * np.sqrt((1 + x) / 2), rel=1e-12)
        along = interpolation(reach, 2 * k)
        if averaged:
            of_nodes, of_grid = lebesgue(n), lebesgue(j) * lebesgue(k)
            at_nodes = interpolation(far, 2 * n)
            error = of_grid * (at_nodes + gauss(a, made["gauss"])) + lebesgue(j) * along + harmonics(a, j)
            assert fewest(made["gauss"], 0.1 * allowed, gauss, a)
            assert fewest(j, 0.2 * allowed, harmonics, a)
            assert lebesgue(j) * along <= 0.3 * allowed
            assert of_grid * at_nodes <= 0.2 * allowed * (1 + 1e-9)
        else:
            assert (n, j) == (k, 1)
            of_nodes, of_grid, error = mp.mpf(1), lebesgue(k), along
            assert along <= 0.5 * allowed
        rounding = of_grid * of_nodes * (2 * n * n + 6 * n + 40) + of_nodes * 4 * j * k * (n + j + k + 4)
        expected = {"error": error, "of_nodes": of_nodes, "of_grid": of_grid, "rounding": rounding}
        for name, one in expected.items():
            assert made[name] == pytest.approx(float(one), rel=1e-9, abs=0.0), name
        penalty = [1.5 * (m + 1) * (m + 2) + 15 * m * m + 10 * i * i + 4 * j for i in range(j) for m in range(k)]
        assert made["penalty"][: j * k] == penalty
        assert not any(made["penalty"][j * k :])


def odd_harmonics(side: float, angles: int) -> mp.mpf:
    a, order = mp.sqrt(2) * mp.mpf(side), 2 * angles + 1
    if order <= a:
        return mp.inf
    b = mp.acosh(order / a)
    return 8 * mp.exp(a * mp.sinh(b) - order * b) / (1 - mp.exp(-2 * b))


def test_what_a_table_of_changes_leaves_and_magnifies():
    for pitch, _, farthest, level in questions(40):
        made: dict[str, Any] = _core_tests.anywhere_bounds(pitch, True, farthest, level)
        j, k, error, of_grid, rounding, growth, penalty = _core_tests.shift_bounds(pitch, farthest, level)
        reach, allowed, n = farthest * pitch, mp.mpf(10) ** -level, len(made["radii"])
        far, by_angle = reach + pitch / math.sqrt(2), lebesgue(2 * j)
        assert fewest(j, 0.2 * allowed, odd_harmonics, pitch)
        along = interpolation(reach, 2 * k)
        assert by_angle * along <= 0.15 * allowed
        grid = by_angle * lebesgue(2 * k)
        at_nodes = interpolation(far, 2 * n) + gauss(pitch, made["gauss"])
        expected = 2 * (grid * at_nodes + by_angle * along) + odd_harmonics(pitch, j)
        assert error == pytest.approx(float(expected), rel=1e-9, abs=0.0)
        assert of_grid == pytest.approx(float(grid), rel=1e-12)
        of_nodes = lebesgue(n)
        rounded = 2 * (grid * of_nodes * (2 * n * n + 6 * n + 40) + of_nodes * 4 * j * k * (n + j + k + 4))
        assert rounding == pytest.approx(float(rounded), rel=1e-9)
        assert growth == pytest.approx(2 * (far + max(n, made["degree"], made["gauss"], 4 * made["harmonics"])))
        each = [
            (m + 1) * (m + 2) * (2 * m + 3) / 2
            + 5 * m * (m + 1) * (2 * m + 1)
            + (2 * i + 1) * (10 * (i + 1) ** 2 + 4 * j)
            for i in range(j)
            for m in range(k)
        ]
        assert penalty[: j * k] == each
        assert not any(penalty[j * k :])


@pytest.mark.parametrize("level", ["portable", "avx2", "avx512"])
def test_windows_of_a_function_of_the_same_type_are_within_it(level):
    nodes, weights = np.polynomial.legendre.leggauss(24)
    with instructions(level):
        rng = np.random.default_rng(5)
        for pitch, averaged, farthest, digits in questions(50):
            side = max(1, int(farthest / 1.5))
            made: dict[str, Any] = _core_tests.anywhere_bounds(pitch, averaged, farthest, digits)
            center, kappa = (side - 1) * rng.uniform(0.45, 0.55, 2), rng.uniform(0.5, 2.0)
            out, changes = np.empty((side, side)), np.empty((2, side, side))
            profile = j0(kappa * np.array(made["radii"]))
            units = _core_tests.anywhere_values(profile, *center, pitch, averaged, farthest, digits, out)
            y, x = np.meshgrid(*(pitch * (np.arange(side) - c) for c in center), indexing="ij")
            exact = averages(x, y, pitch if averaged else 0.0, kappa)
            most = made["error"] + float(U) * (made["rounding"] + units) + made["of_grid"] * made["of_nodes"] * 4e-15
            assert np.abs(out - exact).max() <= most + 20 * float(U) * farthest * pitch
            if not averaged:
                continue

            def along(x, y, s=0.5 * pitch * nodes, kappa=kappa):
                return j0(kappa * np.hypot(x[..., None], y[..., None] + s)) @ (0.5 * weights)

            *_, error, of_grid, rounding, _, _ = _core_tests.shift_bounds(pitch, farthest, digits)
            units = _core_tests.shift_values(profile, *center, pitch, farthest, digits, changes)
            half = 0.5 * pitch
            exact = along(y - half, x) - along(y + half, x), along(x - half, y) - along(x + half, y)
            most = error + float(U) * (rounding + units) + 2 * of_grid * made["of_nodes"] * 4e-15
            assert np.abs(changes - exact).max() <= most + 40 * float(U) * farthest * pitch


def test_what_grows_errs_as_is_said():
    nodes, weights = np.polynomial.legendre.leggauss(24)
    for pitch, _, farthest, digits in questions(40):
        made: dict[str, Any] = _core_tests.anywhere_bounds(pitch, True, farthest, digits)
        growth = _core_tests.shift_bounds(pitch, farthest, digits)[5]
        side, kappa, radii = max(1, int(farthest / 1.5)), 2.0, np.array(made["radii"])
        center, out = (side - 1) / 2 + 0.1, np.empty((side, side))
        profile = -kappa * radii * j1(kappa * radii)
        units = _core_tests.anywhere_values(profile, center, center, pitch, True, farthest, digits, out)
        y, x = np.meshgrid(*2 * [pitch * (np.arange(side) - center)], indexing="ij")
        s = 0.5 * pitch * nodes
        far = np.hypot(x[..., None, None] + s, y[..., None, None] + s[:, None])
        exact = np.einsum("...ab,a,b->...", -kappa * far * j1(kappa * far), 0.5 * weights, 0.5 * weights)
        size = kappa * radii[-1]
        most = growth * made["error"] + float(U) * (size * made["rounding"] + units)
        assert np.abs(out - exact).max() <= most + size * made["of_grid"] * made["of_nodes"] * 1e-14


def test_a_tilt_to_an_axis_and_what_it_loses():
    rng = np.random.default_rng(6)
    for _ in range(200):
        given, center, axis = rng.uniform(-30, 30, 2), rng.uniform(-90, 90, 2), rng.uniform(-90, 90, 2)
        step = 10.0 ** rng.uniform(-2, 1)
        terms = np.array([(1, -1), (1, 1)])
        made: dict[str, Any] = _core_tests.tilted_stack(terms, given, center, *axis, step)
        lost = mp.mpf(0)
        for tilt, to, at, found in zip(given, center, axis, made["tilts"], strict=True):
            way = (mp.mpf(to) - mp.mpf(at)) * mp.mpf(step)
            lost += U * (2 * abs(way) + abs(mp.mpf(tilt)))
            # A tilt that is off by so much moves U by half as much.
            assert abs(mp.mpf(found) - mp.mpf(tilt) - way) / 2 <= U * (2 * abs(way) + abs(mp.mpf(tilt)))
        assert made["lost"][0] == pytest.approx(float(lost), rel=1e-9, abs=0.0)
