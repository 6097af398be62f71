"""Every term of the bound on derivatives by the chordal rule, a second time: docs/certificate.md 8."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import lommel as lm
from core_tests import WIDER, _core_tests
from lommel.core.answers import Samples, Slopes, Wanted
from lommel.core.engine import DiskStack, Window, chordal_images, least_average
from lommel.methods.averaging import _cheapest_filter, averaged_images, pixel_averages
from lommel.optics.grid import Grid
from lommel.special import zernike

UNIT, SINGLE = 2.0**-53, 2.0**-24
CURVES = [0.002 * 2000.0 ** (k / 63) for k in range(64)]


@settings(max_examples=30)
@given(st.booleans(), st.integers(0, 63), st.floats(-3, 60), st.integers(8, 200), st.integers(0, 40))
def test_a_factor_of_degree_n_grows_like_its_hyperbolic_cosine(nodes, curve, exponent, size, degree):
    found = _core_tests.chordal_line(nodes, curve, exponent, size, 1e-6, degree)["bound"]
    b = mp.mpf(CURVES[curve])
    expected = mp.exp(exponent - 2 * size * b) * mp.cosh(degree * b)
    expected /= 1 if nodes else 1 - mp.exp(-2 * (size + 1) * b)
    if 1e-280 < expected < 1e220:
        assert found == pytest.approx(float(expected), rel=1e-9, abs=0.0)


@pytest.mark.theorem
@pytest.mark.parametrize("nodes", [False, True], ids=["chords", "nodes"])
@pytest.mark.parametrize("b", [0.05, 0.4, 1.1])
def test_terms_on_the_curves_are_at_most_that(nodes, b):
    one, two = (np.linspace(0.0, 2.0 * np.pi, 181)[:, None], np.linspace(0.0, np.pi, 91))
    angle, place = one + (0 if nodes else 1j * b), two + (1j * b if nodes else 0)
    x, y = np.cos(angle) + 0 * two, np.sin(angle) * np.cos(place)
    square = x * x + y * y
    for n, m in [(1, 1), (1, -1), (2, 0), (3, -1), (5, 5), (6, 0), (7, -3)]:
        k = abs(m)
        radial = sum(
            (-1) ** j * math.comb(n - j, j) * math.comb(n - 2 * j, (n - k) // 2 - j) * square ** ((n - k) // 2 - j)
            for j in range((n - k) // 2 + 1)
        )
        plus, minus = (x + 1j * y) ** k, (x - 1j * y) ** k
        value = np.abs(radial * ((plus + minus) / 2 if m >= 0 else (plus - minus) / 2j)).max()
        assert value <= math.cosh(n * b) * (1 + 1e-12)
        # The cosine of n reaches it; across chords only, for on them x is real.
        assert nodes or (n, m) != (5, 5) or value > 0.999 * math.cosh(n * b)


@pytest.mark.parametrize("degree", [0, 1, 7])
def test_what_a_factor_rounds(degree):
    found = _core_tests.chordal_rounding(30, 20, 4, degree)
    expected = UNIT * (6 + (0 if WIDER else 6 * degree**2)) if degree else 0.0
    assert found["factor"] == pytest.approx(expected, rel=1e-12, abs=0.0)
    assert found["single_factor"] == pytest.approx(expected + (4 * SINGLE if degree else 0.0), rel=1e-12, abs=0.0)


@pytest.mark.parametrize(("tol", "kind"), [(1e-4, np.float64), (1e-8, np.float64), (1e-4, np.float32)])
@pytest.mark.parametrize("obscuration", [0.0, 0.5])
def test_the_bound_of_a_derivative_is_made_of_those_of_both_fields(tol, kind, obscuration):
    """Along the axis of x the field of Z P is real without aberration, or 0 for a sine: what it adds is known."""
    degrees, step, center = (2, 8), 1.3, 4.0
    terms = tuple((n, m) for n in degrees for m in (2, -2))
    stack = DiskStack(np.array([[2, 0]], np.int32), np.zeros((1, 1)), obscuration, np.zeros(1))
    window = Window((1, 9), (0.0, center), step)
    made = chordal_images(stack, window, tol, Wanted(3.0, kind, terms=terms))
    peak, storing = float(made.peak[0]), 6 * UNIT + (SINGLE if kind == np.float32 else 0.0)
    u, relative = math.sqrt(peak), (float(made.error[0]) - storing) / (1 + storing)
    # relative (u - e)^2 = 2 u e + e^2
    error = float(np.sort(np.roots([relative - 1, -2 * u * (relative + 1), relative * peak]))[-1])
    exact = (u - error) ** 2
    share = obscuration**2
    asked = 0.4 * tol * 0.5 * (1 - share)
    asked *= 1.5 if kind == np.float32 else 1.0
    found = {}
    for n, (cosine, sine) in zip(degrees, made.slopes.error.reshape(2, 2), strict=True):
        wrong = sine * exact / (2 * (u + error))
        factor = _core_tests.chordal_rounding(8, 8, 1, n)["single_factor" if kind == np.float32 else "factor"]
        assert error <= wrong - (1 - 1e-6) * (1 + share) * factor <= error + asked
        fields = [_field(n, 2, v, obscuration) for v in step * (np.arange(9) - center)]
        rounding = storing + (2 * SINGLE if kind == np.float32 else 0.0)
        more = 2 * max(map(abs, fields)) * (error + u * rounding) / exact
        assert cosine - sine == pytest.approx(more, rel=1e-4, abs=0.0)
        found[n] = wrong - (1 + share) * factor - error
    # Both take as many nodes, and on these a high degree is farther off.
    assert found[8] > 1.5 * found[2] or tol < 1e-6


def _field(n: int, m: int, v: float, obscuration: float) -> float:
    """Return the field of a term of even degree on an annulus, along the axis of x, by quadrature."""
    rho = mp.mpf
    if v == 0.0:
        return 0.0

    def part(t: mp.mpf) -> mp.mpf:
        radial = mp.mpf(float(zernike.radial(n, m, np.array(float(t)))))
        return 2 * radial * mp.besselj(m, rho(v) * t) * t

    with mp.workdps(15):
        return float(mp.quad(part, [obscuration, 1.0]))


def test_averages_of_derivatives_claim_twice_what_those_of_the_intensity_do():
    pupil, tol, terms = lm.Pupil(obscuration=0.3), 1e-6, ((2, 0), (3, 1))
    grid, slope, top = Grid(3, 0.4, integrate=True), 0.7, 0.6

    def sample(one, fine, least, wanted):
        values = np.full((1, *fine.shape), 0.5)
        sizes = np.stack([slope * np.ones_like(values), -slope * np.ones_like(values)])
        errors = 0.01 * least * np.array([[3.0], [5.0]])
        return Samples(values, np.ones(1), np.array([0.01 * least]), Slopes(sizes, errors), np.array([top]))

    made = pixel_averages(sample, pupil, grid, tol, Wanted(terms=terms))
    whole = averaged_images(sample, pupil, grid, tol, Wanted(2.0, np.float32, terms=terms))
    assert whole.slopes.values == pytest.approx(2.0 * made.values[1:], rel=1e-6)
    assert made.values[1:, 0] == pytest.approx(
        slope * np.array([1.0, -1.0])[:, None, None] * np.ones((2, 3, 3)), rel=1e-6
    )
    for answer, kind in ((made.error[1:], np.float64), (whole.slopes.error, np.float32)):
        storing = 6 * UNIT + (SINGLE if kind == np.float32 else 0.0)
        aim = tol - (1 + tol) * storing
        lowest = least_average(grid.step(pupil))
        easier = 2.0 ** math.floor(math.log2(64.0 * pupil.amplitude**2))
        taps = _cheapest_filter(grid.step(pupil), easier * 2e-3 * aim * lowest, (3, 3), in_mean=True)
        finer = 0.5 * aim * min(4 * lowest, 1.0) / taps.gain**2
        rounding = (2 * taps.weights.shape[-1] + 8) * UNIT * taps.gain**2 * pupil.amplitude**2
        own = (2 + taps.error) * taps.error + rounding
        found = float(made.peak[0])
        for k, times in enumerate((3.0, 5.0)):
            relative = (taps.gain**2 * 0.01 * finer * times * top + 2 * own) / found
            expected = relative + (slope / found + relative) * storing
            assert answer[k, 0] == pytest.approx(expected, rel=1e-5)
