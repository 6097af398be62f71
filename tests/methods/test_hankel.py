"""Plain quadrature, the reference of all else: its tolerance, its stacks and its limits."""

from __future__ import annotations

import itertools
import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial.legendre import legval
from numpy.typing import NDArray
from scipy import special

from lommel import Pupil, Wavefront
from lommel.methods import Hankel, hankel
from lommel.special.legendre import gauss_legendre

V = np.array([0.0, 1e-3, 0.7, 3.0, 10.0, 41.7, 160.0])


@pytest.mark.parametrize("obscuration", [0.0, 0.4, 0.97])
@pytest.mark.parametrize(("defocus", "spherical", "higher"), [(0, 0, ()), (-9, 12, ()), (3, 1, (-5, 2, 1, -1))])
def test_it_is_the_diffraction_integral(
    defocus: float, spherical: float, higher: tuple[float, ...], obscuration: float
) -> None:
    """Against adaptive quadrature over rho, where Hankel uses nodes in rho^2."""
    pupil = Pupil(Wavefront(defocus, spherical, higher), obscuration=obscuration)
    powers = [2 * defocus, spherical, *higher]

    def integral(v: float) -> complex:
        def integrand(rho: mp.mpf) -> mp.mpc:
            phase = sum(c * rho ** (2 * k + 2) for k, c in enumerate(powers))
            return 2 * rho * mp.expj(phase) * mp.j0(v * rho)

        panels = 2 + int((v + 40) * (1 - obscuration) / 12)
        return complex(mp.quad(integrand, mp.linspace(obscuration, 1, panels + 1)))

    at = V[:5]
    assert Hankel().field(pupil, at) == pytest.approx(np.array([integral(v) for v in at]), abs=2e-15, rel=0)


@pytest.mark.parametrize("obscuration", [0.0, 0.33, 0.9])
@pytest.mark.parametrize("wavefront", [Wavefront(), Wavefront(200.0), Wavefront(-150, 170), Wavefront(5, -20, [30])])
def test_the_error_falls_with_the_tolerance_and_stays_below_it(wavefront: Wavefront, obscuration: float) -> None:
    pupil = Pupil(wavefront, obscuration=obscuration)
    exact = Hankel(tol=1e-15).field(pupil, V)
    for tol in 10.0 ** -np.arange(2.25, 14.1, 0.5):
        values, bound = Hankel(tol=tol).evaluate(pupil, V)
        assert bound is not None
        assert np.abs(values[0] - exact).max() <= bound[0]
        # What is left is the estimate of the rounding.
        assert bound[0] <= tol * pupil.area + 1e-15 * (np.abs(pupil.coefficients()).sum() + 20)


def test_its_intensity_error_bound_is_relative_to_the_largest_value() -> None:
    pupil = Pupil(Wavefront(20.0))
    intensity, bound = Hankel(tol=1e-5).profile(pupil, V)[:2]
    exact = Hankel().profile(pupil, V).values
    assert bound is not None
    assert np.abs(intensity - exact).max() <= bound[0] * exact.max()
    assert bound[0] <= 2.1e-5 / math.sqrt(exact.max())


def test_as_few_nodes_as_it_takes_reach_the_answer_at_great_phases() -> None:
    """At 5000 rad, a rule with three times the nodes finds the same."""
    pupil, v = Pupil(Wavefront(5000.0)), np.array([0.0, 10.0, 1000.0])
    t, w = gauss_legendre(12_000)
    direct = [np.sum(w * np.exp(1e4j * t) * special.j0(at * np.sqrt(t))) for at in v]
    assert np.abs(Hankel().field(pupil, v) - direct).max() <= 1e-13


# Rounding of the measurement itself: a few units for each of some hundred radians.
FLOOR = 1e-13

ETA = np.geomspace(1e-3, 4.0, 96)

sizes = st.sampled_from([0.01, 1.0, 30.0, 400.0])
pupils = st.builds(
    lambda size, parts: size * np.array(parts), sizes, st.lists(st.floats(-1, 1), min_size=1, max_size=4)
)
lows = st.one_of(st.just(0.0), st.floats(1e-4, 0.9))
radii = st.one_of(st.just(0.0), st.floats(0.01, 20), st.floats(20, 700))


def _phase(coefficients: NDArray[np.float64], t: NDArray[np.complex128]) -> NDArray[np.complex128]:
    return legval(2 * t - 1, [0.0, *coefficients])


def _quadrature(coefficients: NDArray[np.float64], low: float, v: float, n: int) -> complex:
    t, weights = gauss_legendre(n, low)
    return complex(np.sum(weights * np.exp(1j * _phase(coefficients, t)) * special.j0(v * np.sqrt(t))))


@given(pupils, lows, radii)
def test_growth_bounds_the_integrand_on_every_ellipse(
    coefficients: NDArray[np.float64], low: float, v: float
) -> None:
    g = hankel.growth(coefficients[None], low, v)
    # Angles that are not those of the grid on which the maximum is looked for.
    theta = np.linspace(0.0, 2 * math.pi, 1009)
    half = 0.5 * (1 - low)
    for exponent, eta in list(zip(g, ETA, strict=True))[::5]:
        t = 0.5 * (1 + low) + half * np.cos(theta + 1j * eta)
        # log|J0(z)| <= |Im z|, and J0 itself overflows long before.
        z = v * np.sqrt(t)
        log_j0 = np.log(np.maximum(np.abs(special.jve(0, z)), 1e-300)) + np.abs(z.imag)
        assert np.all(-_phase(coefficients, t).imag + log_j0 <= exponent + 1e-9 * (1 + exponent))


def test_the_kernel_of_an_annulus_is_largest_between_points_and_the_bound_says_so() -> None:
    low, steps = 0.05, 7
    at = np.abs(np.sqrt(hankel.ellipses(ETA, low, steps)).imag).max(axis=1)
    fine = np.abs(np.sqrt(hankel.ellipses(ETA, low, 7000)).imag).max(axis=1)
    assert np.any(at < 0.999 * fine)
    assert np.all(hankel.rise(ETA, low, steps).max(axis=1) >= fine * (1 - 1e-12))


@given(st.lists(st.floats(-1, 1), min_size=1, max_size=4), st.floats(0, 1))
def test_between_points_a_phase_and_a_kernel_together_are_below_their_bound(parts: list[float], turn: float) -> None:
    degree, steps = len(parts), 3 * len(parts)
    fine = np.linspace(0.0, math.pi, 50 * steps + 1)
    phase = np.abs(sum(a * np.sin(k * fine) for k, a in enumerate(parts, 1)))
    kernel = turn * np.arange(1.0, steps + 1)
    largest = max((phase[50 * k : 50 * k + 51].max() + kernel[k]) for k in range(steps))
    told = hankel.between(phase[None, ::50], kernel[None], degree, 0.1)
    assert largest <= told[0] * (1 + 1e-12) + 1e-15


def test_a_phase_that_is_largest_between_two_points_is_not_missed() -> None:
    phase = np.sin(np.linspace(0.0, math.pi, 4))[None]
    assert hankel.between(phase, np.zeros((1, 3)), 1, 0.1)[0] >= 1.0 > phase.max()


@given(pupils, lows, radii, st.integers(3, 12))
def test_gauss_quadrature_is_as_accurate_as_promised_with_few_nodes_to_spare(
    coefficients: NDArray[np.float64], low: float, v: float, digits: int
) -> None:
    g, error = hankel.growth(coefficients[None], low, v), 10.0**-digits
    n = hankel.quadrature_nodes(g, error, low)
    exact = _quadrature(coefficients, low, v, 2 * n + 40)
    for m in sorted({*np.geomspace(1, n, 24).astype(int).tolist(), *range(max(1, n - 4), n + 1)}):
        promised = hankel.quadrature_error(g, m, low)
        assert abs(_quadrature(coefficients, low, v, m) - exact) <= promised + FLOOR
        assert (promised <= error) == (m >= n)
    # n is 1.15 times the smallest count that does, and 14 more, at most: one of not much fewer fails.
    fewest = max(1, math.ceil((n - 14) / 1.15) - 1)
    failing = (abs(_quadrature(coefficients, low, v, m) - exact) > error for m in range(fewest, n))
    assert fewest == 1 or any(failing)


@pytest.mark.parametrize("v", [0.0, 3.0, 500.0])
@pytest.mark.parametrize("coefficients", [[0.0, 0.0], [400.0, 200.0], [-400.0, 200.0]])
def test_more_nodes_never_promise_less(coefficients: list[float], v: float) -> None:
    g = hankel.growth(np.array([coefficients]), 0.0, v)
    errors = [hankel.quadrature_error(g, n, 0.0) for n in range(1, 700)]
    assert all(later <= earlier for earlier, later in itertools.pairwise(errors))
    assert errors[-1] < 1e-15
