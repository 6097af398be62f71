"""Every term of the bound of the chordal rule, a second time: docs/certificate.md 8."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from lommel import _core

UNIT = mp.mpf(2) ** -53
# At 1, of the numbers that tables are made with; where these are doubles, that is counted.
SPACING = mp.mpf(_core.window_bounds(1, 1.0)["spacing"])
WIDER = SPACING < 2 * UNIT
CURVES = [mp.mpf("0.002") * mp.mpf(2000) ** (mp.mpf(k) / 63) for k in range(64)]
LIST = [(1, 1), (1, -1), (2, 0), (2, 2), (2, -2), (3, 1), (4, 0), (5, -3)]
TERMS = np.array(LIST, np.int64)

few = settings(max_examples=20)
coefficients = st.builds(
    lambda size, parts: [size * p for p in parts],
    st.sampled_from([0.01, 1.0, 8.0]),
    st.lists(st.floats(-1, 1), min_size=len(LIST), max_size=len(LIST)),
)
# g_0, g_1, ...: none, Gaussian, and any polynomial.
lights = st.one_of(
    st.just([0.0]),
    st.floats(0.01, 9.0).map(lambda g: [0.0, g]),
    st.lists(st.floats(-1.5, 1.5), min_size=2, max_size=6),
)


def same(found: float, expected: mp.mpf) -> bool:
    """Compare to nine digits, where neither has left the range of double precision: logarithms are cut off."""
    if not mp.mpf("1e-290") < expected < mp.mpf("1e230"):
        return found <= 1e-280 or found >= 1e220
    return found == pytest.approx(float(expected), rel=1e-9, abs=0.0)


def amplitudes(c: list[float], terms: list[tuple[int, int]]) -> list[tuple[mp.mpf, int]]:
    """Return (W, n) of the terms from degree 2 on: sine and cosine of one order together."""
    squares: dict[tuple[int, int], mp.mpf] = {}
    for value, (n, m) in zip(c, terms, strict=True):
        if n >= 2:
            squares[n, abs(m)] = squares.get((n, abs(m)), mp.mpf(0)) + mp.mpf(value) ** 2
    return [(mp.sqrt(square), n) for (n, _), square in squares.items()]


def farthest(c: list[float], low: float, high: float) -> mp.mpf:
    """Return the largest distance of the window from the tilt."""
    x, y = mp.mpf(c[0]), mp.mpf(c[1])
    return mp.hypot(max(abs(mp.mpf(low) - x), abs(mp.mpf(high) - x)), y)


@mp.workdps(40)
def log_amplitude(light: list[float], cosh: mp.mpf) -> mp.mpf:
    """Return the growth of exp(-(g_0 + g_1 t + ...)) on an ellipse, from its Chebyshev coefficients."""
    count = len(light) + 1
    angles = [mp.pi * (j + mp.mpf(1) / 2) / count for j in range(count)]
    values = [sum(mp.mpf(g) * ((1 + mp.cos(a)) / 2) ** k for k, g in enumerate(light)) for a in angles]
    total = -sum(values) / count
    for k in range(1, len(light)):
        part = 2 * sum(f * mp.cos(k * a) for f, a in zip(values, angles, strict=True)) / count
        total += abs(part) * mp.cosh(k * mp.acosh(cosh))
    return total


def sizes(c: list[float], light: list[float], low: float, high: float, terms=LIST) -> list[mp.mpf]:
    """Return the logarithm of M(b) (1 + e^(-2b)) on each curve."""
    reach = farthest(c, low, high)
    return [
        sum((w * mp.sinh(n * b) for w, n in amplitudes(c, terms)), reach * mp.sinh(b))
        + log_amplitude(light, mp.cosh(2 * b))
        + mp.log(1 + mp.exp(-2 * b))
        for b in CURVES
    ]


def quadrature(logs: list[mp.mpf], chords: int) -> mp.mpf:
    """Return the least bound of the curves on which the series converges."""
    first, found = mp.mpf(2 * chords + 1), []
    for log_m, b in zip(logs, CURVES, strict=True):
        q = mp.exp(-b) * ((first + 1) / first) ** mp.mpf(1.5)
        if q < 1:
            found.append(mp.exp(log_m - 2 * chords * b) * first ** mp.mpf(1.5) / (1 - q))
    return min(found)


def rounding(c: list[float], low: float, high: float, chords: int, terms=LIST) -> mp.mpf:
    degree = max(n for n, _ in terms)
    size = sum(abs(mp.mpf(value)) for value in c)
    return UNIT * (3 * (chords + 12) + (len(terms) + degree + 7) * size + 3 * farthest(c, low, high)) + coarse(
        terms, c, farthest(c, low, high)
    )


def coarse(terms: list[tuple[int, int]], c: list[float], far: mp.mpf) -> mp.mpf:
    """Return what tables add that are made in double."""
    bent = sum(n * n * abs(mp.mpf(value)) for (n, _), value in zip(terms, c, strict=True))
    return mp.mpf(0) if WIDER else UNIT * (3 * bent + 6 * far)


@few
@given(coefficients, lights, st.floats(-40, 10), st.floats(0, 60), st.integers(4, 400))
def test_quadrature_and_rounding(c, light, low, width, chords):
    found = _core.chordal_bounds(TERMS, np.array(c), np.array(light), low, low + width, chords)
    expected = quadrature(sizes(c, light, low, low + width), chords)
    assert same(found["quadrature"], expected)
    assert same(found["rounding"], rounding(c, low, low + width, chords))


@few
@given(coefficients)
def test_the_variance_that_the_first_error_rests_on(c):
    found = _core.chordal_bounds(TERMS, np.array(c), np.zeros(1), 0.0, 1.0, 8)["variance"]
    expected = sum(
        mp.mpf(value) ** 2 / ((n + 1) * (1 if m == 0 else 2)) for value, (n, m) in zip(c, LIST, strict=True) if n > 1
    )
    assert same(found, expected)


@few
@given(
    coefficients,
    # At most 1, as an image asks for.
    st.sampled_from([[0.0], [0.0, 1.5], [0.0, 9.0], [0.3, -1.2, 1.2, 0.1]]),
    st.sampled_from([1e-3, 1e-6, 1e-10]),
    st.booleans(),
    st.sampled_from([0.0, 0.5]),
    # Beside the light, the first error does not do.
    st.sampled_from([3.0, 20.0]),
)
def test_the_bound_of_an_image_is_made_of_these(c, light, tol, divided, obscuration, column):
    c = [0.1 * value for value in c]
    images, numbers, step = np.empty((1, 1, 8)), np.empty((3, 1)), 1.2
    scales, bounds, peaks = numbers
    disk, places = (np.array([c]), obscuration, np.array(light)), (0.0 if divided else 1.0, images, numbers)
    unmet = _core.chordal_images(TERMS.astype(np.int32), *disk, 0.0, column, step, tol, 1, *places)
    if unmet:
        assert unmet > tol
        return
    peak = 1.0 / scales[0] if divided else images.max()
    assert peaks[0] == pytest.approx(peak, rel=1e-12)
    low, high, area = -column * step, (7 - column) * step, obscuration**2
    stack = _core.disk_stack(TERMS, np.array(c), obscuration, 0.0, column, step, moved=False)
    terms = list(zip(map(int, stack["n"]), map(int, stack["m"]), strict=True))
    lost = mp.mpf(stack["lost"][0])
    assert (lost > 0) == (obscuration > 0 and any(c))

    def bounds_of(phase: list[float], share: float, fall: list[float]) -> list[mp.mpf]:
        window = (share * low, share * high)
        # The first two are the tilts; a term that is 0 counts for nothing but its place.
        edge = dict(zip(terms, phase, strict=True))
        ours = [(1, 1), (1, -1), *(term for term in terms if term[0] != 1)]
        padded = [edge.get(term, 0.0) for term in ours]
        logs = sizes(padded, fall, *window, ours)
        degree = max(n for n, _ in terms)
        far = UNIT * 3 * farthest(padded, *window)
        size = UNIT * (len(terms) + degree + 7) * sum(abs(mp.mpf(x)) for x in phase)
        size += coarse(terms, phase, farthest(padded, *window))
        return [quadrature(logs, n) + 3 * UNIT * (n + 12) + size + far for n in range(8, 65, 2)]

    candidates = [lost + e for e in bounds_of(stack["outer"], 1.0, light)]
    if obscuration:
        within = [
            area * e for e in bounds_of(stack["inner"], obscuration, [g * area**k for k, g in enumerate(light)])
        ]
        candidates = [outer + part for outer in candidates for part in within]
    name = "normalized" if divided else "relative"
    expected = [_core.stored_bound(_core.intensity_bounds(peak, float(e))[name], False, divided) for e in candidates]
    assert any(bounds[0] == pytest.approx(e, rel=1e-9, abs=0.0) for e in expected)
    assert bounds[0] <= tol


def test_the_sampled_growth_of_a_phase_is_that_of_all_chords():
    """The largest sample over whole turns of theta and phi and all of eta, times what lies between samples."""
    rng, b = np.random.default_rng(5), 0.3
    terms = [(2, -2), (3, 1), (3, -3), (4, 2), (5, 5)]
    edge, degree = rng.normal(size=len(terms)), 5
    across = (7 * degree + 1) // 2
    half = turns = (across + 1) // 2
    angle = math.pi * np.arange(2 * across) / across + 1j * b
    eta = np.cos(math.pi * (2 * np.arange(2 * half) + 1) / (4 * half))
    turn = 2 * math.pi * np.arange(4 * turns) / (4 * turns)
    along, beside = np.cos(angle)[:, None, None], np.sin(angle)[:, None, None] * eta[:, None]
    x, y = along * np.cos(turn) - beside * np.sin(turn), along * np.sin(turn) + beside * np.cos(turn)
    total = np.zeros(x.shape, dtype=complex)
    for c, (n, m) in zip(edge, terms, strict=True):
        k, square = abs(m), x * x + y * y
        radial = sum(
            (-1) ** j * math.factorial(n - j) * square ** ((n - k) // 2 - j)
            / (math.factorial(j) * math.factorial((n + k) // 2 - j) * math.factorial((n - k) // 2 - j))
            for j in range((n - k) // 2 + 1)
        )  # fmt: skip
        plus, minus = (x + 1j * y) ** k, (x - 1j * y) ** k
        total += c * radial * ((plus + minus) / 2 if m >= 0 else (plus - minus) / 2j)
    quarter = 0.5 * math.pi * degree
    margin = math.cos(quarter / across) * math.cos(quarter / (2 * half)) * math.cos(quarter / (2 * turns))
    found = _core.chordal_growth(np.array(terms), edge, b)
    assert found == pytest.approx(np.abs(total.imag).max() / margin, rel=2e-9)


# The theorems are reached to within a factor of 2, where they can be.


@given(st.integers(4, 400), st.floats(0.1, 2.9))
def test_the_sum_over_the_components_is_bounded_closely(chords, b):
    n = np.arange(2 * chords, 2 * chords + math.ceil(80 / b))
    exact = ((n + 1) ** 1.5 * np.exp(-(n - 2 * chords) * b)).sum()
    first = 2 * chords + 1
    q = math.exp(-b) * ((first + 1) / first) ** 1.5
    if q < 0.8:
        bound = first**1.5 / (1 - q)
        assert exact <= bound * (1 + 1e-12)
        assert bound <= 2 * exact


@pytest.mark.parametrize("chords", [8, 13])
def test_the_rule_mistakes_the_first_component_that_it_does_not_integrate_for_a_constant(chords):
    """U_2N on the ridge along x: its integral is 0, and the rule makes of it what its alias has."""
    angle = math.pi * np.arange(1, chords + 1) / (chords + 1)
    weights = np.sin(angle) ** 2 / (chords + 1) * 2
    ridge = np.sin((2 * chords + 1) * angle) / np.sin(angle)
    assert abs((weights * ridge).sum()) >= 0.5
    below = np.sin((2 * chords) * angle) / np.sin(angle)
    assert abs((weights * below).sum()) < 1e-12


@pytest.mark.parametrize("tilt", [3.0, -7.0])
def test_a_tilt_reaches_its_growth(tilt):
    """exp(i c x) at x = cos(a + ib) is exp(c sinh b) at most."""
    b, a = 0.8, np.linspace(0, 2 * np.pi, 2001)
    assert np.imag(-tilt * np.cos(a + 1j * b)).max() == pytest.approx(abs(tilt) * math.sinh(b), rel=1e-5)
