"""Discs of the complex plane: every number of an operand ends up in the result."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest

from lommel.special.disc_arithmetic import Disc, cosine_and_sinc, disc, windings

RNG = np.random.default_rng(7)


def some(count: int, centre: complex = 0.0, size: float = 2.0, radius: float = 0.5) -> Disc:
    around = RNG.normal(size=(2, count)) * size
    return Disc(centre + around[0] + 1j * around[1], RNG.uniform(0.0, radius, count))


def inside(of: Disc, edge: bool) -> np.ndarray:
    """One number of each disc, on its edge or anywhere."""
    share = 1.0 if edge else np.sqrt(RNG.uniform(size=of.centre.shape))
    return of.centre + share * of.radius * np.exp(2j * np.pi * RNG.uniform(size=of.centre.shape))


def holds(of: Disc, values: np.ndarray) -> np.ndarray:
    return np.abs(values - of.centre) <= of.radius * (1 + 1e-12)


@pytest.mark.parametrize("edge", [True, False])
@pytest.mark.parametrize(
    "operation",
    [
        lambda x, y: x + y,
        lambda x, y: x - y,
        lambda x, y: x * y,
        lambda x, y: x / y,
        lambda x, y: 2j - x * (1.0 - 3.0j) / y + 1.0 / y,
    ],
)
def test_what_is_computed_of_numbers_is_within_what_is_computed_of_discs(operation, edge):
    one, two = some(2000), some(2000, 3.0, 1.0)
    found = operation(one, two)
    known = np.isfinite(found.radius)  # where no divisor may be 0
    assert holds(found, operation(inside(one, edge), inside(two, edge)))[known].all()
    assert known.mean() > 0.9


def test_a_root_is_within_its_disc_wherever_the_real_part_is_positive():
    square = some(4000, 1.5, 0.7)
    root = square.sqrt()
    right = square.centre.real > square.radius
    assert 0.5 < right.mean() < 1.0
    assert (np.isfinite(root.radius) == right).all()
    for edge in (True, False):
        values = inside(square, edge)
        assert holds(root, np.sqrt(values))[right].all()


def test_cosine_and_sinc_are_within_their_discs():
    square = some(4000, 1.0, 2.0, radius=8.0)
    cosine, sinc = cosine_and_sinc(square)
    values = inside(square, edge=True)
    z = np.sqrt(values)
    assert holds(cosine, np.cos(z)).all()
    assert holds(sinc, np.sin(z) / z).all()


def test_sinc_near_zero_is_its_series():
    square = Disc(np.array([0.0, 1e-12, -1e-9 + 1e-10j, 1e-7], complex), np.zeros(4))
    for found, function in zip(cosine_and_sinc(square), (mp.cos, mp.sinc), strict=True):
        exact = [complex(function(mp.sqrt(mp.mpc(z)))) for z in square.centre]
        assert holds(found, np.array(exact)).all()
        assert found.radius.max() < 1e-10


def test_largest_and_least_moduli_are_those_of_the_disc():
    one = Disc(np.array([3.0 + 4.0j, 0.5]), np.array([1.0, 1.0]))
    assert one.largest == pytest.approx([6.0, 1.5])
    assert one.least == pytest.approx([4.0, 0.0])


def test_what_may_be_divided_by_zero_is_unknown():
    assert np.isinf(disc(0.0).inverse().radius)
    assert not np.isfinite((1.0 / Disc(np.array([1.0 + 0j]), np.array([1.0]))).radius).any()
    unknown = disc(0.0) * Disc(np.array([1.0 + 0j]), np.array([np.inf]))
    assert not np.isfinite(unknown.radius).any()


def circle(radius: float, arcs: int) -> Disc:
    angle = 2.0 * np.pi * (np.arange(arcs) + 0.5) / arcs
    return Disc(radius * np.exp(1j * angle), np.full(arcs, radius * np.pi / arcs))


@pytest.mark.parametrize("zeros", [[], [0.3], [0.3, -0.4 + 0.2j], [0.1, 0.1j, -0.1, 2.0]])
def test_curves_wind_as_often_as_there_are_zeros_inside(zeros):
    x = circle(1.0, 256)
    value = disc(1.0 + 0j) * x * 0.0 + 1.0
    for zero in zeros:
        value = value * (x - zero)
    assert windings(value) == sum(abs(zero) < 1 for zero in zeros)


def test_a_curve_that_may_meet_zero_has_no_number_of_windings():
    x = circle(1.0, 64)
    assert windings(x - 1.0) == -1
    assert windings(x - 1.2) == 0


@pytest.mark.parametrize("turns", [-2, -1, 0, 1, 3])
@pytest.mark.parametrize("start", [0.0, 1.0, np.pi])
def test_windings_count_turns_of_either_sense_from_anywhere(turns, start):
    theta = 2.0 * np.pi * np.arange(40) / 40.0
    centre = (1.5 + np.cos(3.0 * theta + start)) * np.exp(1j * (turns * theta + start + 0.3 * np.sin(theta)))
    curves = Disc(np.stack([centre, centre + 4.0]), np.full((2, 40), 1e-3))
    assert windings(curves).tolist() == [turns, 0]
