"""Lommel's two series meet at the edge of the shadow and agree with quadrature on both sides."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

import lommel as lm
from lommel import Pupil, Wavefront
from lommel.methods import Hankel
from lommel.paper import LommelSeries
from lommel.special.bessel import bessel_sequence

defocuses = st.one_of(st.floats(-300, 300), st.floats(-1, 1), st.floats(-1e-6, 1e-6))


@given(defocuses, st.lists(st.floats(0, 1500, allow_subnormal=False), min_size=1, max_size=10))
def test_it_is_exact_to_rounding_in_light_and_shadow(defocus: float, v: list[float]) -> None:
    pupil, at = Pupil(Wavefront(defocus)), np.unique(v)
    series, (quadrature, bound) = LommelSeries().evaluate(pupil, at), Hankel().evaluate(pupil, at)
    assert bound is not None
    assert np.abs(series.values - quadrature).max() <= 2e-14 + bound[0]
    assert series.error is None


@pytest.mark.parametrize("step", [0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3])
@pytest.mark.parametrize("defocus", [1e-9, 1e-4, 2.5e-4, 0.2499999, 0.25, 0.2500001, 1.0, 50.0, 200.0])
def test_the_two_series_join_without_a_step_at_the_edge_of_the_shadow(defocus: float, step: float) -> None:
    edge = 4 * defocus
    at = np.array([edge * (1 - step), edge, edge * (1 + step)])
    field = LommelSeries().field(Pupil(Wavefront(defocus)), at)
    # |dU/dv| is at most 1 (Bernstein).
    assert np.abs(np.diff(field)).max() <= 2 * edge * step + 3e-15
    assert np.abs(field - Hankel().field(Pupil(Wavefront(defocus)), at)).max() <= 1e-13


@pytest.mark.parametrize("defocus", [0.0, 1e-300, 1e-12, 0.1, 10.0, -200.0])
@pytest.mark.parametrize("v", [0.0, 1e-300, 1e-9, 9.999e-4, 1e-3, 1.001e-3])
def test_nothing_is_divided_by_a_vanishing_radius_or_defocus(defocus: float, v: float) -> None:
    pupil = Pupil(Wavefront(defocus))
    assert abs(LommelSeries().field(pupil, v) - Hankel().field(pupil, v)) <= 1e-14


@pytest.mark.parametrize("defocus", [0.3, 5.0, 40.0])
def test_it_is_what_born_and_wolf_print(defocus: float) -> None:
    """Principles of Optics, section 8.8.1: C - iS, with the sums written out."""
    u = 4 * defocus
    for v in (0.4 * u, 0.95 * u, 1.05 * u, 3 * u):
        orders = np.arange(2 * int(u + 60))
        j = bessel_sequence([v], orders.size)[0]
        signs = (-1.0) ** np.arange(orders.size // 2)

        def function(n: int, ratio: float, v: float = v, j: NDArray[np.float64] = j, signs=signs) -> float:
            m = n + 2 * np.arange(signs.size - 2)
            return float(np.sum(signs[:-2] * ratio**m * j[m]))

        sin, cos = math.sin(u / 2), math.cos(u / 2)
        if v > u:
            u1, u2 = function(1, u / v), function(2, u / v)
            c, s = 2 / u * (cos * u1 + sin * u2), 2 / u * (sin * u1 - cos * u2)
        else:
            v0, v1 = function(0, v / u), function(1, v / u)
            edge = v * v / (2 * u)
            c, s = 2 / u * (math.sin(edge) + sin * v0 - cos * v1), 2 / u * (math.cos(edge) - cos * v0 - sin * v1)
        assert abs(LommelSeries().field(Pupil(Wavefront(defocus)), v) - (c + 1j * s)) <= 1e-13


@given(defocuses, st.floats(0.001, 0.99), st.lists(st.floats(0, 500, allow_subnormal=False), min_size=1, max_size=8))
def test_an_obscured_aperture_is_the_difference_of_two(defocus: float, obscuration: float, v: list[float]) -> None:
    pupil, at = Pupil(Wavefront(defocus), obscuration=obscuration), np.unique(v)
    assert np.abs(LommelSeries().field(pupil, at) - Hankel().field(pupil, at)).max() <= 1e-13


def test_aberrations_that_are_zero_are_no_aberrations() -> None:
    pupils = Pupil(Wavefront([3.0, -4.0], [0.0, 0.0], [[0.0, 0.0], 0.0]))
    exact = lm.psf(pupils, 9, 0.5, method=Hankel(), normalize="strehl").values
    answer = lm.psf(pupils, 9, 0.5, method=LommelSeries(), normalize="strehl", dtype=np.float64)
    assert answer.values == pytest.approx(exact, rel=0, abs=1e-14)
    assert answer.error_bound is None
