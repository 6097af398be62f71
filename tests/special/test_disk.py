"""How much of a rectangle a disk covers, from cases that need no formula."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lommel.special.disk import disk_overlap

NODES, WEIGHTS = np.polynomial.legendre.leggauss(60)

places = st.floats(-3, 3)
radii = st.floats(0, 4)


def _rectangle(a: float, b: float, c: float, d: float) -> tuple[float, float, float, float]:
    return min(a, b), max(a, b), min(c, d), max(c, d)


@given(radii)
def test_a_rectangle_around_the_disk_holds_all_of_it(radius: float) -> None:
    assert float(disk_overlap(radius, -4.0, 5.0, -6.0, 4.0)) == pytest.approx(math.pi * radius**2, rel=1e-14)


@given(places, places, places, places)
def test_a_disk_around_the_rectangle_covers_all_of_it(a: float, b: float, c: float, d: float) -> None:
    left, right, low, high = _rectangle(a, b, c, d)
    area = (right - left) * (high - low)
    assert float(disk_overlap(4.25, left, right, low, high)) == pytest.approx(area, rel=1e-14, abs=2e-14)


@given(st.floats(0.1, 4))
def test_half_planes_and_quadrants_through_the_centre_hold_halves_and_quarters(radius: float) -> None:
    area = math.pi * radius**2
    assert float(disk_overlap(radius, 0.0, 9.0, -9.0, 9.0)) == pytest.approx(area / 2, rel=1e-14)
    assert float(disk_overlap(radius, -9.0, 9.0, -9.0, 0.0)) == pytest.approx(area / 2, rel=1e-14)
    assert float(disk_overlap(radius, -9.0, 0.0, 0.0, 9.0)) == pytest.approx(area / 4, rel=1e-14)


@given(st.floats(0.1, 4), st.floats(0, math.pi / 2))
def test_a_half_plane_off_the_centre_cuts_a_circular_segment(radius: float, angle: float) -> None:
    """The segment of half-angle phi, beyond ``r cos phi``, is ``r^2 (phi - sin(2 phi) / 2)``."""
    area = float(disk_overlap(radius, radius * math.cos(angle), 9.0, -9.0, 9.0))
    assert area == pytest.approx(radius**2 * (angle - 0.5 * math.sin(2 * angle)), rel=0, abs=4e-15 * radius**2)


def test_a_square_inscribed_in_the_circle_leaves_four_segments() -> None:
    side = math.sqrt(0.5)
    assert float(disk_overlap(1.0, -side, side, -side, side)) == pytest.approx(2.0, rel=1e-15)
    assert float(disk_overlap(1.0, side, 2.0, -side, side)) == pytest.approx((math.pi - 2) / 4, rel=1e-14)
    assert float(disk_overlap(1.0, side, 2.0, side, 2.0)) == 0.0


@pytest.mark.parametrize("radius", [0.0, 1e-300, 1e-12, 1e-3])
def test_a_tiny_disk_is_inside_or_outside(radius: float) -> None:
    assert float(disk_overlap(radius, -1.0, 1.0, -1.0, 1.0)) == pytest.approx(math.pi * radius**2, rel=1e-14)
    assert float(disk_overlap(radius, 0.5, 1.0, -1.0, 1.0)) == 0.0
    assert float(disk_overlap(radius, 0.0, 1.0, 0.0, 1.0)) == pytest.approx(math.pi * radius**2 / 4, rel=1e-14)


@given(radii, places, places, places, places, st.floats(0, 1), st.floats(0, 1))
def test_the_parts_of_a_rectangle_add(
    radius: float, a: float, b: float, c: float, d: float, across: float, down: float
) -> None:
    left, right, low, high = _rectangle(a, b, c, d)
    x, y = left + across * (right - left), low + down * (high - low)
    whole = disk_overlap(radius, left, right, low, high)
    parts = disk_overlap(radius, [left, x, left, x], [x, right, x, right], [low, low, y, y], [y, y, high, high])
    assert float(parts.sum()) == pytest.approx(float(whole), rel=0, abs=1e-13)


@given(radii, places, places, places, places)
def test_turning_and_mirroring_changes_nothing(radius: float, a: float, b: float, c: float, d: float) -> None:
    left, right, low, high = _rectangle(a, b, c, d)
    area = float(disk_overlap(radius, left, right, low, high))
    for turned in ((-right, -left, low, high), (left, right, -high, -low), (low, high, left, right)):
        assert float(disk_overlap(radius, *turned)) == pytest.approx(area, rel=0, abs=5e-14)


@given(radii, radii, places, places, places, places)
def test_a_larger_disk_covers_no_less_and_never_more_than_there_is(
    one: float, other: float, a: float, b: float, c: float, d: float
) -> None:
    rectangle = _rectangle(a, b, c, d)
    small, large = (float(disk_overlap(r, *rectangle)) for r in (min(one, other), max(one, other)))
    area = (rectangle[1] - rectangle[0]) * (rectangle[3] - rectangle[2])
    assert -1e-13 <= small <= large + 1e-13
    assert large <= min(area, math.pi * max(one, other) ** 2) + 1e-13


def test_it_is_the_integral_of_the_chord() -> None:
    """A rectangle that the circle enters and leaves, by quadrature of its height at each x."""
    radius, left, right, low, high = 1.3, -0.4, 1.2, -0.9, 0.75
    bends = sorted({left, right, *(s * math.sqrt(radius**2 - y**2) for s in (-1, 1) for y in (low, high))})
    total = 0.0
    for start, stop in itertools.pairwise(bends):
        if left <= start and stop <= right:
            at = start + 0.5 * (stop - start) * (1 + NODES)
            arc = np.sqrt(radius**2 - at**2)
            total += float(0.5 * (stop - start) * WEIGHTS @ (np.minimum(high, arc) - np.maximum(low, -arc)))
    assert float(disk_overlap(radius, left, right, low, high)) == pytest.approx(total, rel=0, abs=1e-12)


@pytest.mark.parametrize("radius", [10.3, 256.2, 4000.4, 11000.1])
def test_far_from_the_centre_a_pixel_is_still_cut_to_rounding(radius: float) -> None:
    """A pixel on the axis: the arc enters and leaves through its sides, ``x = sqrt(r^2 - y^2)``."""
    left = math.floor(radius) - 0.5
    y, w = 0.5 * NODES, 0.5 * WEIGHTS
    # sqrt(r^2 - y^2) - r without cancellation; the polynomial rule is exact to rounding for an arc so flat.
    sag = -(y**2) / (radius + np.sqrt(radius**2 - y**2))
    exact = float(w @ (radius - left + sag))
    assert float(disk_overlap(radius, left, left + 2.0, -0.5, 0.5)) == pytest.approx(exact, abs=1e-15 * radius**2)


def test_everything_broadcasts() -> None:
    edges = np.linspace(-1.5, 1.5, 7)
    cells = disk_overlap(
        np.array([0.5, 1.4])[:, None, None], edges[:-1], edges[1:], edges[:-1, None], edges[1:, None]
    )
    assert cells.shape == (2, 6, 6)
    assert cells.sum(axis=(1, 2)) == pytest.approx(math.pi * np.array([0.25, 1.96]), rel=1e-14)
