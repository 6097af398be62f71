"""Every term of the bound on windows around an axis for each pupil, a second time: mpmath, docs/certificate.md 9."""

from __future__ import annotations

import math
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from scipy.special import j0

from core_tests import _core_tests
from pixel_tables import averages, fewest, gauss, harmonics, interpolation, lebesgue

UNIT = mp.mpf(2) ** -53


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


@pytest.mark.parametrize("level", ["portable", "avx2", "avx512"])
def test_windows_of_a_function_of_the_same_type_are_within_it(level):
    _core_tests.limit_instructions(level)
    try:
        rng = np.random.default_rng(5)
        for pitch, averaged, farthest, digits in questions(50):
            side = max(1, int(farthest / 1.5))
            made: dict[str, Any] = _core_tests.anywhere_bounds(pitch, averaged, farthest, digits)
            center = (side - 1) * rng.uniform(0.45, 0.55, 2)
            out = np.empty((side, side))
            kappa = rng.uniform(0.5, 2.0)
            profile = j0(kappa * np.array(made["radii"]))
            units = _core_tests.anywhere_values(profile, *center, pitch, averaged, farthest, digits, out)
            y, x = (pitch * (np.arange(side) - c) for c in center)
            place = np.meshgrid(y, x, indexing="ij")
            exact = averages(place[1], place[0], pitch if averaged else 0.0, kappa)
            most = (
                made["error"] + float(UNIT) * (made["rounding"] + units) + made["of_grid"] * made["of_nodes"] * 4e-15
            )
            assert np.abs(out - exact).max() <= most + 20 * float(UNIT) * farthest * pitch
    finally:
        _core_tests.limit_instructions("avx512")


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
            lost += UNIT * (2 * abs(way) + abs(mp.mpf(tilt)))
            # A tilt that is off by so much moves U by half as much.
            assert abs(mp.mpf(found) - mp.mpf(tilt) - way) / 2 <= UNIT * (2 * abs(way) + abs(mp.mpf(tilt)))
        assert made["lost"][0] == pytest.approx(float(lost), rel=1e-9, abs=0.0)
