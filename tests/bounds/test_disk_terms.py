"""Every term of the bound on U of pupils that are not radially symmetric, a second time: docs/certificate.md 7."""

from __future__ import annotations

import math
from functools import cache

import mpmath as mp
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.special import jv

import lommel as lm
from core_tests import UNIT, _core_tests, instructions
from digits import same
from log_amplitudes import log_amplitude
from lommel import _core
from lommel.core.engine import DiskStack

CURVES = [mp.mpf("0.002") * mp.mpf(2000) ** (mp.mpf(i) / 63) for i in range(64)]
LIST = [(2, 0), (2, 2), (2, -2), (3, 1), (3, -3), (4, 0), (6, 2), (9, -5)]

few = settings(max_examples=15)
parts = st.lists(st.floats(-1, 1), min_size=len(LIST), max_size=len(LIST))
sizes = st.sampled_from([0.01, 1.0, 6.0])
# g_0, g_1, ...: none, Gaussian, and any polynomial.
lights = st.one_of(
    st.just([0.0]),
    st.floats(0.01, 9.0).map(lambda g: [0.0, g]),
    st.lists(st.floats(-1.5, 1.5), min_size=2, max_size=6),
)
TERMS = np.array(LIST)


def amplitudes(coefficients: list[float]) -> list[tuple[mp.mpf, int, int]]:
    """Return (W, n, |m|), sine and cosine of one order together."""
    squares: dict[tuple[int, int], mp.mpf] = {}
    for c, (n, m) in zip(coefficients, LIST, strict=True):
        squares[n, abs(m)] = squares.get((n, abs(m)), mp.mpf(0)) + mp.mpf(c) ** 2
    return [(mp.sqrt(square), n, m) for (n, m), square in squares.items()]


def within(light: list[float], area: float) -> list[float]:
    return [g * area**k for k, g in enumerate(light)]


@cache
def size(coefficients: tuple[float, ...], light: tuple[float, ...], b: mp.mpf) -> mp.mpf:
    """Return log(M(b) (1 + e^(-2b)))."""
    phase = sum(w * mp.sinh(n * b) for w, n, _ in amplitudes(coefficients))
    return phase + log_amplitude(light, mp.cosh(2 * b)) + mp.log(1 + mp.exp(-2 * b))


Saved = dict[int, float]  # on some curves, of the logarithm, by samples


def sizes_on_curves(
    coefficients: list[float], light: list[float], saved: Saved | None
) -> list[tuple[mp.mpf, mp.mpf]]:
    return [(b, size(tuple(coefficients), tuple(light), b) - (saved or {}).get(i, 0.0)) for i, b in enumerate(CURVES)]


def tail(coefficients: list[float], light: list[float], n: int, saved: Saved | None = None) -> mp.mpf:
    curves = sizes_on_curves(coefficients, light, saved)
    return min(mp.exp(top - n * b) / (1 - mp.exp(-b)) for b, top in curves)


def orders_tail(coefficients: list[float], m: int) -> mp.mpf:
    def one(b: mp.mpf) -> mp.mpf:
        return 2 * mp.exp(sum(w * mp.sinh(k * b) for w, _, k in amplitudes(coefficients)) - m * b) / (1 - mp.exp(-b))

    return min(map(one, CURVES))


def distance(coefficients: list[float], light: list[float], d: int, saved: Saved | None = None) -> mp.mpf:
    """Bound sum over n > d of (n+1)^(3/2) M(b) (1 + e^(-2b)) e^(-n b) by a geometric series."""
    found = []
    for b, top in sizes_on_curves(coefficients, light, saved):
        ratio = mp.exp(-b) * (mp.mpf(d + 3) / (d + 2)) ** mp.mpf(1.5)
        if ratio < 1:
            first = mp.mpf(d + 2) ** mp.mpf(1.5) * mp.exp(top - (d + 1) * b)
            found.append(first / (1 - ratio))
    return min(found)


def window_tail(degrees: int, v: float) -> mp.mpf:
    m = degrees + 1
    x = mp.mpf(v) / m
    root = mp.sqrt(1 - x * x)
    top = (x * mp.exp(root) / (1 + root)) ** m
    rate = mp.log((1 + root) / x)
    return 2 * m / mp.mpf(v) * top / (1 - mp.exp(-rate) * mp.mpf(m + 1) / m)


@few
@given(parts, sizes, lights, st.integers(1, 500))
def test_degrees_and_orders_left_out_and_the_distance_from_polynomials(shares, scale, light, count):
    c = [scale * s for s in shares]
    found = _core_tests.disk_bounds(TERMS, np.array(c), np.array(light), count)
    for name, expected in (
        ("tail", tail(c, light, count)),
        ("orders_tail", orders_tail(c, count)),
        ("distance", distance(c, light, count)),
    ):
        assert same(found[name], expected)


@given(st.integers(1, 600), st.floats(1e-3, 0.99))
@example(4, 0.975)
@example(9, 0.99)
def test_degrees_left_out_by_the_window(degrees, share):
    reach = share * (degrees + 1)
    found = _core_tests.window_bounds(degrees, reach)["disk"]
    m, x = degrees + 1, mp.mpf(reach) / (degrees + 1)
    rate = mp.log((1 + mp.sqrt(1 - x * x)) / x)
    # A hair's breadth is left to rounding.
    if rate * m > 1.2001 and mp.exp(-rate) * mp.mpf(m + 1) / m < 0.9999:
        assert same(found, window_tail(degrees, reach))
    elif rate * m < 1.1999:
        assert found == 1e300


@given(st.integers(0, 200), st.floats(1.0, 3.0))
def test_nothing_is_promised_of_degrees_below_the_window_nor_lost_of_an_empty_one(degrees, times):
    assert _core_tests.window_bounds(degrees, times * (degrees + 1))["disk"] == 1e300
    assert _core_tests.window_bounds(degrees, 0.0)["disk"] == (0.0 if degrees else 1.0)


def transform_rounding(n: int) -> mp.mpf:
    """Return what a transform rounds, of the mean modulus: section 11; and half an angle more, and two sums."""
    units, rest, root = mp.mpf(2), n // 4, 1 + 3 * mp.mpf("6.2832")
    units += 2 + mp.mpf("2.24") + root
    rest //= 4
    for radix, own in ((4, 2), (3, mp.mpf("4.7")), (2, 1)):
        while rest % radix == 0:
            units += own + mp.mpf("2.24") + root
            rest //= radix
    assert rest == 1
    return units + 25


def expansion(c: list[float], light: list[float], reach: float, error: float) -> mp.mpf:
    """Return the bound on a disk, each term of it from the choices that the core made."""
    made = _core_tests.zernike_bounds(TERMS, np.array(c), np.array(light), reach, error)
    degrees, orders, exact = made["degrees"], made["orders"], made["exact"]
    saved = {made["curve"]: made["saved"]}
    if made["saved"]:
        found = _core_tests.sampled_growth(TERMS, np.array(c), made["curve"])
        most = sum(w * mp.sinh(n * CURVES[made["curve"]]) for w, n, _ in amplitudes(c))
        assert same(made["saved"], most - mp.mpf(found["mean"]) - mp.mpf(found["margin"]))
    ends = [tail(c, light, degrees, saved)] + ([window_tail(degrees, reach)] if degrees + 1 > reach else [])
    # Without orders, too, the tail is magnified by a Lebesgue constant.
    totals = [5 * end + orders_tail(c, orders) if orders < degrees else end for end in ends]
    assert any(same(made["truncation"], total) for total in totals)
    # The rule is a product of Gauss and equal angles; its tables come in steps.
    assert exact == 4 * (made["rings"] - 1) or exact < 4 * made["rings"]
    assert exact < made["angles"]
    assert same(made["quadrature"], 2 * distance(c, light, exact - degrees, saved))
    sensitivity = sum(w * (3 * n + 6) for w, n, _ in amplitudes(c)) + sum(
        (3 * k + 1) * abs(mp.mpf(g)) for k, g in enumerate(light)
    )
    assert same(made["transform"], transform_rounding(made["angles"]))
    sums = mp.mpf(made["transform"]) + made["rings"] + 4 * degrees
    rounding = UNIT * (sensitivity + 8 + mp.mpf("0.71") * degrees * sums)
    assert same(made["error"], made["truncation"] + made["quadrature"] + rounding)
    assert made["truncation"] + made["quadrature"] <= error
    return mp.mpf(made["error"])


@few
@given(parts, sizes, lights, st.floats(0.1, 60.0), st.floats(3, 11))
def test_the_whole_of_a_disk(shares, scale, light, reach, digits):
    expansion([scale * s for s in shares], light, reach, 10.0**-digits)


def test_samples_serve_large_expansions_and_no_small_ones():
    for size, light in ((0.1, [0.0]), (20.0, [0.0]), (20.0, [0.0, 1.5])):
        c = [size * (1 + 0.1 * k) for k in range(len(LIST))]
        made = _core_tests.zernike_bounds(TERMS, np.array(c), np.array(light), 500.0, 1e-8)
        assert (made["saved"] > 1.0) == (size > 1.0)
        expansion(c, light, 500.0, 1e-8)


def on_chords(c: list[float], b: float, turn: np.ndarray, a: np.ndarray, tau: np.ndarray) -> np.ndarray:
    """Return -Im Phi at [direction, a, tau], R_n^m by the factorial sum."""
    x, y = np.cos(a + 1j * b)[:, None] + 0 * tau, np.sin(a + 1j * b)[:, None] * np.cos(tau)
    total = np.zeros((turn.size, a.size, tau.size))
    for value, (n, signed) in zip(c, LIST, strict=True):
        m, square = abs(signed), x * x + y * y
        radial = sum(
            (-1) ** k * math.comb(n - k, k) * math.comb(n - 2 * k, (n - m) // 2 - k) * square ** ((n - m) // 2 - k)
            for k in range((n - m) // 2 + 1)
        )
        wave = np.exp(1j * m * turn)[:, None, None]
        over, back = wave * (radial * (x + 1j * y) ** m), wave.conj() * (radial * (x - 1j * y) ** m)
        total -= value * ((over + back) / 2 if signed >= 0 else (over - back) / 2j).imag
    return total


@pytest.mark.parametrize("curve", [28, 38, 46])
@pytest.mark.parametrize("scale", [0.3, 3.0])
def test_the_sampled_growth_is_the_mean_over_chords_at_the_worst_direction(curve, scale):
    rng, b, last, directions = np.random.default_rng(curve), float(CURVES[curve]), 4 * 9, 16 * 3
    c = list(scale * rng.normal(size=len(LIST)))
    step, turn = math.pi / (2 * last), math.pi / directions
    # Hats around samples have as much of the mean as fine sums over them.
    fine = (np.arange(400 * last) + 0.5) * math.pi / (400 * last)
    hats = np.maximum(0.0, 1.0 - np.abs(fine[:, None] / step - np.arange(2 * last + 1)))
    along = (hats * np.sin(fine)[:, None]).sum(0) / np.sin(fine).sum()
    h = on_chords(c, b, turn * np.arange(directions), step * np.arange(4 * last), step * np.arange(2 * last + 1))
    expected = np.log((np.exp(h).mean(axis=1) * along).sum(axis=1).max())
    pairs = amplitudes(c)
    most = float(sum(w * mp.sinh(n * b) for w, n, _ in pairs))
    bends = [
        float(sum(w * mp.sinh(n * b) * power**2 for w, power, n in found))
        for found in ([(w, n, n) for w, n, _ in pairs], [(w, m, n) for w, n, m in pairs])
    ]
    samples, terms = (last + 1) ** 2, 2 * len(pairs)
    margin = step**2 / 4 * bends[0] + turn**2 / 8 * bends[1] + 1e-3
    margin += 5.97e-8 * (1.5 * (terms + 10) * most + 8 * samples)
    for level in ("avx512", "avx2", "portable"):
        with instructions(level):
            found = _core_tests.sampled_growth(TERMS, np.array(c), curve)
        # Chords above the exponential, at most 1.0615 of it.
        assert expected - 1e-4 <= found["mean"] <= expected + math.log(1.0616)
        assert found["margin"] == pytest.approx(margin, rel=1e-6)
    # Between the samples, too, it is no larger, and not much less than they say.
    a, tau = (np.arange(240) + 0.5) * math.pi / 120, (np.arange(240) + 0.5) * math.pi / 240
    means = (
        np.exp(on_chords(c, b, np.linspace(0, math.pi, 23), a, tau)).mean(axis=1) @ np.sin(tau) / np.sin(tau).sum()
    )
    assert np.log(means.max()) <= found["mean"] + found["margin"]
    assert found["mean"] <= np.log(means.max()) + 0.3


@pytest.mark.parametrize("curve", [28, 46])
def test_the_samples_of_growth_have_all_of_the_mean(curve):
    assert _core_tests.sampled_growth(TERMS, np.zeros(len(LIST)), curve)["mean"] == pytest.approx(0.0, abs=1e-5)


def circles_of(c, inner, obscuration, light, reach, error, step=0.5, tol=1e-6):
    return _core_tests.circle_errors(
        TERMS, np.array(c), np.array(inner), obscuration, np.array(light), reach, error, step, tol
    )


@few
@given(parts, sizes, lights, st.sampled_from([0.0, 0.3, 0.9]), st.floats(1.0, 40.0), st.sampled_from([1e-4, 1e-8]))
def test_the_whole_of_a_pupil(shares, scale, light, obscuration, reach, error):
    c = [scale * s for s in shares]
    inner = [0.5 * a for a in c]
    found = circles_of(c, inner, obscuration, light, reach, error)
    area = mp.mpf(obscuration) ** 2
    expected = expansion(c, light, reach, 0.5 * error) + 3 * UNIT * mp.mpf(reach)
    if obscuration:
        expected += area * expansion(inner, within(light, float(area)), obscuration * reach, 0.5 * error)
    # Coefficients that turn out to be small are left out, which is added: at most a tenth of the error a disk.
    assert expected * (1 - mp.mpf("1e-9")) <= found["expanded"] <= expected + mp.mpf(0.2 * error)
    # Circles add rounding of positions, and more.
    assert min(map(min, found["errors"])) > found["expanded"] + 32 * float(UNIT) * (reach + 64)


@pytest.mark.parametrize("term", [3, 4, 5])
def test_a_term_that_is_left_out_is_added_to_the_bound(term):
    """exp(i a Z) = 1 + i a Z: a coefficient a of degree n, whose transform is at most 1 / (n + 1)."""
    n, _ = LIST[term]
    c = [0.0] * len(LIST)
    c[term], error, reach = 1e-10, 1e-7, 20.0
    without = expansion(c, [0.0], reach, 0.5 * error) + 3 * UNIT * mp.mpf(reach)
    found = circles_of(c, c, 0.0, [0.0], reach, error)
    assert found["expanded"] - float(without) == pytest.approx(c[term] / (n + 1), rel=1e-4, abs=0.0)


@pytest.mark.parametrize("normalize", ["strehl", "peak"])
@pytest.mark.parametrize(
    ("side", "step", "obscuration", "tol"),
    [(5, 0.3, 0.0, 1e-4), (5, 0.3, 0.0, 1e-7), (15, 0.37, 0.0, 1e-3), (15, 0.37, 0.3, 1e-3)],
)
def test_the_bound_of_an_image_is_made_of_these(normalize, side, step, obscuration, tol):
    """The error of U in the one tile of the window is that of one of its circles."""
    c = {(2, 2): 1.3, (3, 1): -0.8, (4, 0): 0.5}
    terms, middle = np.array(list(c)), side // 2
    disks = _core_tests.disk_stack(terms, np.array(list(c.values())), obscuration, middle, middle, step, moved=True)
    outer, lost = np.array(disks["outer"]), disks["lost"][0]
    inner = np.array(disks["inner"] or disks["outer"])
    assert (lost > 0.0) == (obscuration > 0.0)
    images, numbers = np.empty((1, side, side)), np.empty((3, 1))
    scale, (_, bounds, peaks) = 0.0 if normalize == "peak" else 1.0, numbers
    stack = DiskStack(terms.astype(np.int32), np.array([list(c.values())]), obscuration, np.zeros(1))
    window = (side, side), (middle, middle), step
    assert _core.series_images(stack, window, (tol, 1, scale), images, numbers) == 0.0
    size = sum(abs(x) for x in c.values())
    variance = sum(x * x / (n + 1) / (2 if m else 1) for (n, m), x in c.items())
    dimmest = min(size + 1.0, 2.5 * math.sqrt(1.0 + variance))
    # Storing takes its part of the tolerance first.
    rest = tol - (_core_tests.stored_bound(tol, False, normalize == "peak") - tol)
    rest = 0.4 * rest if normalize == "peak" else rest
    found = _core_tests.circle_errors(
        np.array(disks["terms"]), outer, inner, obscuration, np.zeros(1), step * middle * math.sqrt(2),
        0.1 * rest * (1 - obscuration**2) / dimmest, step, rest,
    )  # fmt: skip
    assert found["likely"]
    expected = []
    for error in np.concatenate(found["errors"]):
        whole = _core_tests.intensity_bounds(peaks[0], lost + error)
        relative = whole["normalized" if normalize == "peak" else "relative"]
        expected.append(_core_tests.stored_bound(relative, False, normalize == "peak"))
    assert any(bounds[0] == pytest.approx(e, rel=1e-9, abs=0.0) for e in expected)


@few
@given(parts, st.sampled_from([0.05, 1.0]), st.sampled_from([0.0, 0.4]), st.sampled_from([1e-3, 1e-6]), st.booleans())
def test_the_bound_of_an_image_is_its_error_over_its_peak(shares, scale, obscuration, tol, divided):
    """The whole of section 6 cannot be better than the error of one value, nor worse than the tolerance."""
    terms = {term: scale * s for term, s in zip(LIST, shares, strict=True) if term[1]}
    pupil = lm.Pupil(lm.Wavefront(nonradial=terms), obscuration=obscuration)
    answer = lm.psf(
        pupil,
        9,
        0.4,
        method=lm.methods.NijboerZernike(tol),
        dtype=np.float64,
        normalize="peak" if divided else "strehl",
    )
    exact = lm.psf(pupil, 9, 0.4, method=lm.methods.ChordalGauss(1e-11), dtype=np.float64, normalize="strehl")
    values = answer.values / answer.scale * exact.scale
    true = np.abs(values - exact.values).max() / exact.values.max()
    assert true <= answer.error_bound <= tol + float(UNIT)


# The theorems are reached to within a factor of 2, where they can be.


@pytest.mark.theorem
@pytest.mark.parametrize(("n", "b"), [(2, 0.3), (5, 0.1), (9, 1.0)])
def test_a_term_at_the_edge_reaches_its_growth(n, b):
    """Z_n^n on the chords through the edge is cos(n phi), whose imaginary part at a + ib is at most sinh(n b)."""
    a = np.linspace(0, 2 * np.pi, 4001)
    assert np.abs(np.cos(n * (a + 1j * b)).imag).max() == pytest.approx(math.sinh(n * b), rel=1e-4)


@pytest.mark.theorem
def test_the_gaussian_reaches_its_growth_on_the_middle_chord():
    b, g = 0.7, 1.5
    # Where eta = 0 and a is a quarter turn, rho^2 = cos(a + ib)^2.
    square = np.cos(np.linspace(0, np.pi, 2001) + 1j * b) ** 2
    assert (-g * square.real).max() == pytest.approx(g * (math.cosh(2 * b) - 1) / 2, rel=1e-6)


@pytest.mark.theorem
@given(st.integers(0, 400), st.floats(0.2, 4.0))
def test_the_sum_over_the_degrees_of_the_remainder_is_bounded_closely(d, b):
    n = np.arange(d + 1, d + 1 + math.ceil(80 / b))
    exact = ((n + 1) ** 1.5 * np.exp(-(n - d - 1) * b)).sum()
    ratio = math.exp(-b) * ((d + 3) / (d + 2)) ** 1.5
    if ratio < 0.8:
        bound = (d + 2) ** 1.5 / (1 - ratio)
        assert exact <= bound * (1 + 1e-12)
        assert bound <= 2 * exact


@pytest.mark.theorem
def test_no_transform_exceeds_what_is_taken_for_its_size():
    """|2 (n+1) J_(n+1)(v) / v| <= 1, reached on the axis, and |J_n(v)| < 0.7858 v^(-1/3) (Landau), closely."""
    assert 2 * jv(1, 1e-6) / 1e-6 == pytest.approx(1.0, rel=1e-9)
    v = np.geomspace(0.01, 300.0, 1500)[:, None]
    n = np.arange(120)
    assert np.all(2 * (n + 1) * np.abs(jv(n + 1, v)) / v <= 1.0 + 1e-12)
    share = np.abs(jv(n, v)) * np.cbrt(v) / 0.7858
    assert 0.99 < share.max() < 1.0


@pytest.mark.parametrize("curve", [30, 42])
@pytest.mark.parametrize("scale", [0.0, 0.3, 3.0])
def test_growth_with_the_waves_of_a_window_is_that_at_its_worst_corner(curve, scale):
    rng, b, reach = np.random.default_rng(curve), float(CURVES[curve]), np.array([9.0, 4.0])
    stack = scale * rng.normal(size=(2, len(LIST)))
    found = _core.stack_growth(TERMS.astype(np.int32), stack, curve, tuple(reach), 1)
    a, tau = (np.arange(40) + 0.5) * math.pi / 20, (np.arange(20) + 0.5) * math.pi / 20
    turn = np.append(math.pi / 16 * np.arange(32), rng.uniform(0, 2 * math.pi, 4))
    x, y = (np.cos(a + 1j * b).imag[:, None] + 0 * tau), (np.sin(a + 1j * b).imag[:, None] * np.cos(tau))
    c, s = np.cos(turn)[:, None, None], np.sin(turn)[:, None, None]
    places = [(i, j) for i in (-1, 1) for j in (-1, 1)] + [tuple(v) for v in rng.uniform(-1, 1, (2, 2))]
    logs = []
    for pupil in stack:
        h = on_chords(list(pupil), b, turn, a, tau)
        for v in places:
            grown = h + v[0] * reach[0] * (c * x - s * y) + v[1] * reach[1] * (s * x + c * y)
            top = grown.max()
            means = (np.exp(grown - top).mean(axis=1) * np.sin(tau)).sum(axis=1) / np.sin(tau).sum()
            logs.append(top + math.log(means.max()))
    wave = np.hypot(*reach) * math.sinh(b)
    bends = np.zeros(2)
    for pupil in stack:
        each = [(float(w) * math.sinh(n * b), n, m) for w, n, m in amplitudes(list(pupil))]
        bends = np.maximum(bends, [wave + sum(w * k[i] ** 2 for w, *k in each) for i in (0, 1)])
    step, around = math.pi / (6 * 9), math.pi / 32
    assert max(logs) <= found
    assert found <= max(logs) + math.log(4 * 1.07) + step**2 / 4 * bends[0] + around**2 / 8 * bends[1] + 0.3
    with pytest.raises(ValueError, match="no such curve"):
        _core.stack_growth(TERMS.astype(np.int32), stack, 64, tuple(reach), 1)
