"""Every bound that is computed in Python, a second time: quadrature of the reference, averages, any aperture."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import lommel as lm
from core_tests import _core_tests
from digits import same
from lommel.core.answers import Intensities, Samples, Wanted
from lommel.core.engine import least_average
from lommel.methods import hankel
from lommel.methods.averaging import _cheapest_filter, averaging_filter, pixel_averages
from lommel.methods.matrix_fourier import gauss_pixel, pixel_error, pixel_nodes
from lommel.methods.method import stored
from lommel.optics.aperture.opening import degree_needed
from lommel.optics.grid import Grid

UNIT = mp.mpf(2) ** -53
few = settings(max_examples=15)
ETAS = [mp.mpf("0.001") * mp.mpf(4000) ** (mp.mpf(i) / 95) for i in range(96)]
phases = st.lists(st.floats(-60, 60), min_size=1, max_size=3)
lows = st.one_of(st.just(0.0), st.floats(0.01, 0.9))
lights = st.one_of(
    st.floats(0, 9).map(lm.Apodization.gaussian),
    st.lists(st.floats(-3, 3), min_size=2, max_size=4).map(lm.Apodization),
)


@mp.workdps(40)
def log_amplitude(light: lm.Apodization, low: mp.mpf, cosh: mp.mpf) -> mp.mpf:
    """Return the growth of an amplitude on an ellipse around [low, 1], from its Chebyshev coefficients."""
    powers = [mp.mpf(float(g)) for g in light.exponent]
    count = len(powers) + 1
    angles = [mp.pi * (j + mp.mpf(1) / 2) / count for j in range(count)]
    values = [sum(g * (low + (1 - low) * (1 + mp.cos(a)) / 2) ** k for k, g in enumerate(powers)) for a in angles]
    total = -sum(values) / count
    for k in range(1, len(powers)):
        part = 2 * sum(f * mp.cos(k * a) for f, a in zip(values, angles, strict=True)) / count
        total += abs(part) * mp.cosh(k * mp.acosh(cosh))
    return total


@settings(max_examples=6)
@given(phases, st.floats(0, 5), lows, st.floats(0, 90), lights)
def test_the_growth_of_the_integrand(phase, spread, low, v, light):
    stack = np.array([[c - spread for c in phase], [c + spread for c in phase]])
    found = hankel.growth(stack, low, v, light)
    low, half = mp.mpf(low), (1 - mp.mpf(low)) / 2
    # Of an annulus abs(Im sqrt t) is largest at this angle; of a disc at pi, the last of the points.
    root = mp.sqrt(low)
    for i in (0, 40, 95):
        eta, sizes, kernel = ETAS[i], [], []
        top = mp.acos(max(mp.mpf(-1), -mp.cosh(eta) * (1 - root) / (1 + root)))
        for angle in [*(mp.pi * j / 128 for j in range(129)), top]:
            t = low + half * (1 + mp.cos(mp.mpc(angle, eta)))
            x = 2 * t - 1
            p = [x, (3 * x**2 - 1) / 2, (5 * x**3 - 3 * x) / 2]
            phase_part = sum(mp.mpf(c) * p[k].imag for k, c in enumerate(stack.mean(axis=0)))
            sides = sum(mp.mpf(s) * abs(p[k].imag) for k, s in enumerate(np.ptp(stack, axis=0) / 2))
            sizes.append(abs(phase_part) + sides)
            kernel.append(mp.mpf(v) * abs(mp.sqrt(t).imag))
        most, widening = kernel.pop(), 1 / mp.cos(mp.pi * len(phase) / 256)
        phase_alone = max(sizes[:129])
        if low == 0:
            largest = max(map(sum, zip(sizes[:129], kernel, strict=True))) * widening
        else:
            here = min(int(top * 128 / mp.pi), 127)
            parts = [most if j == here else max(kernel[j : j + 2]) for j in range(128)]
            largest = max(max(sizes[j : j + 2]) + part for j, part in enumerate(parts))
            largest += (len(phase) * mp.pi / 128) ** 2 / 8 * widening * phase_alone
        assert same(float(found[i]), largest + log_amplitude(light, low, mp.cosh(eta)))


@given(st.floats(0, 50), st.floats(-9, 0.0), lows, st.integers(1, 300), st.floats(1e-12, 1e-2))
def test_the_error_and_the_nodes_of_the_reference(slope, start, low, n, error):
    g = slope * np.linspace(0, 1, 96) ** 2 + start
    logs = [
        mp.log(mp.mpf(32) / 15 * (1 - mp.mpf(low))) + mp.mpf(float(x)) - mp.log(1 - mp.exp(-2 * eta))
        for x, eta in zip(g, ETAS, strict=True)
    ]
    expected = min(mp.exp(one - 2 * n * eta) for one, eta in zip(logs, ETAS, strict=True))
    assert same(hankel.quadrature_error(g, n, low), expected)
    nodes = min((one - mp.log(mp.mpf(error))) / (2 * eta) for one, eta in zip(logs, ETAS, strict=True))
    assert hankel.quadrature_nodes(g, error, low) == max(1, int(mp.ceil(nodes)))


@given(phases, lows, st.integers(1, 400))
def test_the_estimate_of_rounding(phase, low, nodes):
    expected = (2 * sum(abs(mp.mpf(c)) for c in phase) + 4 * mp.sqrt(nodes) + 16) * UNIT * (1 - mp.mpf(low))
    assert same(float(hankel.rounding_error(np.array([phase]), low, nodes)[0]), expected)


@few
@given(phases, st.sampled_from([0.0, 0.4]), st.floats(0.1, 50.0))
def test_the_reference_claims_quadrature_and_rounding(phase, obscuration, v):
    pupil = lm.Pupil(lm.Wavefront(phase[0] / 2, sum(phase[1:2]), tuple(phase[2:])), obscuration=obscuration)
    low, terms = obscuration**2, pupil.radial_terms()
    g = hankel.growth(terms, low, v)
    n = hankel.quadrature_nodes(g, 1e-8 * (1 - low), low)
    expected = hankel.quadrature_error(g, n, low) + hankel.rounding_error(terms, low, n)[0]
    assert lm.methods.Hankel(1e-8).evaluate(pupil, np.array([0.0, v])).error[0] == pytest.approx(
        expected, rel=1e-12, abs=0.0
    )


@given(st.floats(0.01, 40.0), st.integers(1, 60))
def test_the_error_of_an_average_over_a_pixel(width, q):
    a = mp.mpf(width)
    expected = a ** (2 * q) * mp.factorial(q) ** 4 * mp.mpf(2) ** (2 * q - 1) / (2 * q + 1) / mp.factorial(2 * q) ** 3
    assert same(pixel_error(width, q), expected)


@given(st.floats(0.01, 40.0), st.floats(1e-13, 0.1))
def test_the_nodes_of_an_average_are_the_fewest_that_do(width, error):
    q = pixel_nodes(width, error)
    assert pixel_error(width, q) <= error
    assert q == 1 or pixel_error(width, q - 1) > error
    offset, weight = gauss_pixel(width, error)
    assert len(offset) == len(weight) == q
    assert abs(offset).max() <= 0.5 * width
    assert weight.sum() == pytest.approx(1.0, rel=1e-12)


@pytest.mark.parametrize("q", [1, 2, 3, 5])
@pytest.mark.parametrize("width", [0.05, 0.3])
def test_an_average_of_the_fastest_intensity_there_is_reaches_its_bound(q, width):
    """cos(v)^2 is of exponential type 2 and at most 1; its derivative of order 2 q is 2^(2q - 1) at the middle."""
    with mp.workdps(40):
        w = mp.mpf(width)
        exact = mp.mpf(1) / 2 + mp.sin(w) / (2 * w)
        # The roots of the polynomial of Legendre, and the weights that go with them.
        nodes = [
            mp.findroot(lambda x: mp.legendre(q, x), mp.mpf(float(x))) for x in np.polynomial.legendre.leggauss(q)[0]
        ]
        weights = [2 / (1 - x * x) / mp.diff(lambda y: mp.legendre(q, y), x) ** 2 for x in nodes]
        average = sum(c * mp.cos(w * x / 2) ** 2 for x, c in zip(nodes, weights, strict=True)) / 2
        missed = float(abs(average - exact))
    assert missed <= pixel_error(width, q) <= 2 * missed


@pytest.mark.theorem
@pytest.mark.parametrize("h", [0.01, 0.1, 0.2])
def test_cubic_interpolation_of_the_fastest_intensity_there_is_reaches_its_bound(h):
    """Between the middle two of four samples h apart: 3 h^4 / 16, and a Lebesgue constant of 1.25."""
    x = np.linspace(0.0, 1.0, 101)
    outer, inner = x * (x - 1) / 6, (x + 1) * (x - 2) / 2
    lagrange = np.stack([-outer * (x - 2), inner * (x - 1), -inner * x, outer * (x + 1)])
    through = np.cos(h * (np.arange(-1, 3) - 0.5)) ** 2 @ lagrange
    missed = np.abs(through - np.cos(h * (x - 0.5)) ** 2).max()
    assert missed <= 3 / 16 * h**4 <= 2 * missed
    assert np.abs(lagrange).sum(axis=0).max() == pytest.approx(1.25, rel=1e-3)


@few
@given(
    st.lists(st.tuples(st.integers(2, 9), st.floats(0.01, 5.0)), max_size=4),
    st.floats(0.0, 60.0),
    lights,
    st.floats(1e-13, 1e-2),
)
def test_the_degree_to_which_a_rule_over_any_aperture_must_be_exact(terms, v, light, error):
    curves = np.geomspace(1e-3, 4.0, 200)
    degree = degree_needed(terms, v, light, error)

    def bound(e: int) -> mp.mpf:
        found = []
        for b in map(mp.mpf, map(float, curves)):
            ratio = mp.exp(-b) * (mp.mpf(e + 3) / (e + 2)) ** mp.mpf(1.5)
            if ratio < 1:
                log_m = sum(mp.mpf(w) * mp.sinh(n * b) for n, w in terms) + mp.mpf(v) * mp.sinh(b)
                log_m += log_amplitude(light, mp.mpf(0), mp.cosh(2 * b))
                total = mp.exp(log_m - (e + 1) * b) * mp.mpf(e + 2) ** mp.mpf(1.5) / (1 - ratio)
                found.append(2 * (1 + mp.exp(-2 * b)) * total)
        return min(found)

    # On curves that are not those of the implementation the bound is nearly the same.
    assert bound(degree) <= 1.1 * error
    assert degree <= 5 or bound(degree - 1) >= 0.9 * error


@pytest.mark.parametrize("light", [lm.Apodization(), lm.Apodization.gaussian(1.0)])
def test_a_mean_on_one_curve_may_take_the_place_of_the_largest_value(light):
    b, logarithm, error = 0.6, 25.0, 1e-8
    terms = [(2, 3.0), (5, 4.0)]
    degree = degree_needed(terms, 20.0, light, error, mean=(b, logarithm))

    def bound(e: int) -> float:
        ratio = math.exp(-b) * ((e + 3) / (e + 2)) ** 1.5
        grown = logarithm + light.growth(np.array([math.cosh(2 * b)]))[0] - (e + 1) * b
        return 2 * (1 + math.exp(-2 * b)) * math.exp(grown) * (e + 2) ** 1.5 / (1 - ratio)

    assert bound(degree) <= error < bound(degree - 1)
    assert degree < degree_needed(terms, 20.0, light, error)
    assert degree_needed(terms, 20.0, light, error, mean=(b, 1e3)) == degree_needed(terms, 20.0, light, error)


def test_a_spectrum_adds_the_errors_of_its_parts_by_their_weight():
    class Known(lm.methods.NijboerZernike):
        def profile(self, pupil, v):
            n = 1 if pupil.wavelength < 5e-7 else 3
            return Intensities(np.full((1, v.size), 0.5 * n), np.array([1e-8 * n]), np.array([2.0 * n]))

    pupil = lm.Pupil(wavelength=5e-7, f_number=4.0)
    method = lm.methods.Polychromatic([4e-7, 1e-6], [3.0, 1.0], method=Known())
    found = method.profile(pupil, np.linspace(0, 1, 3))
    # Weights 3/4 and 1/4 times (reference / wavelength)^2; bounds are over each peak; no part outshines the sum.
    shares = [0.75 * 1.25**2, 0.25 * 0.5**2]
    total = shares[0] * 0.5 + shares[1] * 1.5
    # Roundings: four of a weight, one of a product, one of the sum of two, and some to spare.
    error = shares[0] * 1e-8 * 2.0 + shares[1] * 3e-8 * 6.0 + 10 * 2.0**-53 * total
    assert np.allclose(found.values, total)
    assert found.peak[0] == pytest.approx(max(total, shares[0] * 2.0, shares[1] * 6.0) - error, rel=1e-12)
    assert found.error[0] == pytest.approx(error / found.peak[0], rel=1e-9, abs=0.0)


@given(st.floats(0.0, 0.5), st.sampled_from([np.float32, np.float64]))
def test_what_storing_adds_is_what_the_compiled_core_takes_it_for(relative, kind):
    expected = _core_tests.stored_bound(relative, kind == np.float32, False)
    assert stored(np.array([relative]), kind)[0] == pytest.approx(expected, rel=1e-12, abs=0.0)


@given(st.floats(1e-3, 60.0))
def test_the_least_average_around_a_peak(step):
    """The average of cos(s)^2 over the disc in the pixel, in polar coordinates."""
    far = min(mp.mpf(step) / 2, mp.pi / 2)
    expected = mp.quad(lambda s: 2 * mp.pi * s * mp.cos(s) ** 2, [0, far]) / mp.mpf(step) ** 2
    assert least_average(step) == pytest.approx(float(expected), rel=1e-8, abs=0.0)


@few
@given(st.floats(0.05, 20.0), st.sampled_from([1e-3, 1e-6, 1e-9]))
def test_the_response_of_a_filter_errs_by_what_is_claimed_and_not_much_less(step, error):
    taps = averaging_filter(step, error)
    k = np.arange(len(taps.weights)) - len(taps.weights) // 2
    assert np.array_equal(taps.weights, taps.weights[::-1])
    assert taps.gain == pytest.approx(np.abs(taps.weights).sum(), rel=1e-12)
    # Not at the points at which it was fitted.
    w = np.linspace(0.0, 2.0, 4001)
    missed = np.abs(
        np.cos(np.outer(w, k * step / taps.stride)) @ taps.weights - np.sinc(0.5 * step / math.pi * w)
    ).max()
    assert missed <= taps.error <= error
    # A root of 2 for what lies between the points, and rounding.
    rounding = 2.0**-52 * (len(k) // 2 + 4) * taps.gain
    half, h = len(k) // 2, step / taps.stride
    degree = math.ceil(2.36 * half * h) + 48
    points = 2.0 * np.cos((np.arange(degree) + 0.5) * (0.5 * math.pi / degree))
    there = np.abs(np.cos(np.outer(points, h * k)) @ taps.weights - np.sinc(0.5 * step / math.pi * points)).max()
    assert taps.error == pytest.approx(math.sqrt(2.0) * (there + rounding) + 1e-17, rel=1e-3, abs=1e-15)
    assert taps.gain <= 1.5


@pytest.mark.parametrize("in_mean", [False, True])
@pytest.mark.parametrize("normalize", [False, True])
@pytest.mark.parametrize(("step", "value"), [(0.4, 0.5), (7.0, 0.5), (7.0, 0.01)])
def test_an_average_claims_the_errors_of_samples_and_of_the_filter(step, value, normalize, in_mean):
    # A sampled mask leaves the largest error of a response, an aperture the mean one.
    aperture = {} if in_mean else {"mask": lm.Mask(np.ones((16, 16)))}
    pupil, tol, top = lm.Pupil(obscuration=0.3, **aperture), 1e-6, 0.6
    grid = Grid(3, step / math.pi)
    asked = []

    def sample(one, fine, least, wanted):
        asked.append(0.01 * least)
        return Samples(np.full((1, *fine.shape), value), np.ones(1), np.array(asked[-1:]), None, np.array([top]))

    made = pixel_averages(sample, pupil, grid, tol, Wanted(scale=None if normalize else 1.0))
    lowest = least_average(step)
    error = 2e-3 * (0.4 if normalize else 1.0) * tol * lowest
    ceiling = pupil.amplitude**2
    if in_mean:
        error, ceiling = 2.0 ** math.floor(math.log2(64.0 * ceiling)) * error, 1.0
    taps = _cheapest_filter(grid.step(pupil), error, (3, 3), in_mean=in_mean)
    own = (2 + taps.error) * taps.error * ceiling
    own += (2 * taps.weights.shape[-1] + 8) * 2.0**-53 * taps.gain**2 * top * (1 - asked[-1])
    if asked[-1] >= 0.01 * 2e-7:
        # Dark samples may be summed in single precision, for a tenth of what the least average allows.
        own += 1.01 * 0.1 * (0.4 if normalize else 1.0) * tol * lowest * top * (1 - asked[-1])
    found = made.values.max() if normalize else max(made.values.max(), lowest * top * (1 - asked[-1]))
    relative = (taps.gain**2 * asked[-1] * top + own) / found
    whole = _core_tests.stored_bound(2 * relative / (1 - relative) if normalize else relative, False, False)
    assert made.error[0, 0] == pytest.approx(whole, rel=1e-7, abs=0.0)
    assert made.error[0, 0] <= tol
