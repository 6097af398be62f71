"""Every term of the bound of the chordal rule, a second time: docs/certificate.md 8."""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass

import mpmath as mp
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from core_tests import UNIT, WIDER, _core_tests, instructions
from digits import same
from log_amplitudes import log_amplitude
from lommel import _core
from lommel.core.engine import DiskStack

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


def exponents(c: list[float], light: list[float], low: float, high: float, terms=LIST) -> dict[str, list[mp.mpf]]:
    """Return the logarithms of what either sum errs by, times e^(2nb), on each curve."""
    reach, rise, found = farthest(c, low, high), abs(mp.mpf(c[1])), {"chords": [], "nodes": []}
    for b in CURVES:
        phase = sum((w * mp.sinh(n * b) for w, n in amplitudes(c, terms)), log_amplitude(light, mp.cosh(2 * b)))
        found["chords"].append(phase + reach * mp.sinh(b) + mp.log(1 + mp.exp(-4 * b)))
        found["nodes"].append(phase + rise * mp.sinh(b) + mp.log(mp.mpf(32) / 15 / (1 - mp.exp(-2 * b))))
    return found


def error_of(nodes: bool, curve: int, exponent: mp.mpf, size: int) -> mp.mpf:
    """Return the bound on the error of a sum by one curve."""
    b = CURVES[curve]
    error = mp.exp(exponent - 2 * size * b)
    return error if nodes else error / (1 - mp.exp(-2 * (size + 1) * b))


def steady_rounding(c: list[float], low: float, high: float, terms=LIST) -> mp.mpf:
    """Return what does not depend on the numbers of chords and nodes."""
    degree = max(n for n, _ in terms)
    size = sum(abs(mp.mpf(value)) for value in c)
    far = farthest(c, low, high)
    return UNIT * (36 + (len(terms) + degree + 7) * size + 3 * far) + coarse(terms, c, far)


def rounding_of_sums(chords: int, nodes: int) -> mp.mpf:
    return UNIT * (2 * chords + nodes + (0 if WIDER else nodes))


def coarse(terms: list[tuple[int, int]], c: list[float], far: mp.mpf) -> mp.mpf:
    """Return what tables add that are made in double."""
    bent = sum(n * n * abs(mp.mpf(value)) for (n, _), value in zip(terms, c, strict=True))
    return mp.mpf(0) if WIDER else UNIT * (3 * bent + 6 * far)


@few
@given(coefficients, lights, st.floats(-40, 10), st.floats(0, 60))
def test_what_bounds_both_sums_on_every_curve_and_rounding(c, light, low, width):
    found = _core_tests.chordal_bounds(TERMS, np.array(c), np.array(light), low, low + width)
    expected = exponents(c, light, low, low + width)
    for name in ("chords", "nodes"):
        # sinh is cut off where no bound is of use.
        for mine, theirs in zip(found[name], expected[name], strict=True):
            assert mine == pytest.approx(float(theirs), rel=1e-9, abs=1e-12)
    edges = {"chords": farthest(c, low, low + width), "nodes": abs(mp.mpf(c[1]))}
    for name, edge in edges.items():
        for mine, b in zip(found[f"{name}_bend"], CURVES, strict=True):
            bend = sum((n * n * w * mp.sinh(n * b) for w, n in amplitudes(c, LIST)), edge * mp.sinh(b))
            assert mine == pytest.approx(float(bend), rel=1e-9, abs=1e-12)
    assert same(found["rounding"], steady_rounding(c, low, low + width))


@few
@given(
    st.booleans(), st.integers(0, 63), st.floats(-3, 300), st.integers(4, 900), st.sampled_from([1e-3, 1e-6, 1e-10])
)
# Close to its first size the factor of the sum over chords matters.
@example(False, 20, math.log(1e-3) + 0.5, 40, 1e-3)
def test_the_error_by_one_curve_and_what_is_enough_for_it(nodes, curve, exponent, size, error):
    found = _core_tests.chordal_line(nodes, curve, exponent, size, error)
    assert same(found["bound"], error_of(nodes, curve, mp.mpf(exponent), size))
    enough = int(found["enough"])
    assert enough > 1024 or error_of(nodes, curve, mp.mpf(exponent), enough) <= error * (1 + 1e-12)
    below = max([n for n in SIZES[nodes] if n < enough], default=0)
    assert below < 8 or error_of(nodes, curve, mp.mpf(exponent), below) > error * (1 - 1e-12)


def steps(count: float) -> float:
    """Return how often a term of a sum is rounded: half of its steps or, by blocks of 16, of those and all blocks."""
    return count / 2 if count < 32 else 16 / 2 + math.ceil(count / 16) - 1


@pytest.mark.parametrize(("chords", "nodes", "terms"), [(8, 8, 1), (52, 40, 15), (63, 64, 9), (500, 1000, 300)])
def test_the_rounding_of_sums(chords, nodes, terms):
    found = _core_tests.chordal_rounding(chords, nodes, terms)
    assert same(found["double"], rounding_of_sums(chords, nodes))
    assert same(
        found["single"], 2.0**-24 * (30 + 1.5 * steps(chords / 2) + 2 * steps(nodes / 2)) + 7.4e-10 * (terms + 4)
    )


def test_waves_of_turns_are_within_five_roundings_to_float():
    rng = np.random.default_rng(4)
    corners = np.arange(-40, 40, dtype=np.int64)[:, None] + (np.arange(8, dtype=np.int64) << 29)
    turns = np.concatenate([rng.integers(0, 1 << 32, 1 << 19), corners.ravel() % (1 << 32)]).astype(np.uint32)
    turns = turns[: turns.size // 32 * 32]
    angle = turns.astype(np.float64) * (2 * math.pi / 2**32)
    for level in ("avx512", "avx2", "portable"):
        with instructions(level):
            cosine, sine = np.array(_core_tests.turned_waves(turns)).reshape(-1, 2).T
        worst = np.hypot(cosine - np.cos(angle), sine - np.sin(angle)).max() * 2.0**24
        assert 1.0 < worst < 5.0


@few
@given(coefficients)
def test_the_variance_that_the_first_error_rests_on(c):
    found = _core_tests.chordal_bounds(TERMS, np.array(c), np.zeros(1), 0.0, 1.0)["variance"]
    expected = sum(
        mp.mpf(value) ** 2 / ((n + 1) * (1 if m == 0 else 2)) for value, (n, m) in zip(c, LIST, strict=True) if n > 1
    )
    assert same(found, expected)


LARGE = [*range(68, 129, 4), *range(136, 257, 8), *range(272, 513, 16), *range(544, 1025, 32)]
# Of chords, and of nodes.
SIZES = np.array([*range(8, 65, 2), *LARGE]), np.array([*range(8, 25, 2), *range(28, 65, 4), *LARGE])
SAMPLE_STEPS = 5  # of the degree, a half turn


@dataclass
class Disk:
    """The phase of one disk on a window of one row: what bounds its sums, at first and for less error."""

    terms: list[tuple[int, int]]
    phase: list[float]
    light: list[float]
    low: float
    high: float

    def __post_init__(self) -> None:
        values = dict(zip(self.terms, self.phase, strict=True))
        # The first two are the tilts; a term that is 0 counts for nothing but its place.
        ours = [(1, 1), (1, -1), *(term for term in self.terms if term[0] != 1)]
        padded = [values.get(term, 0.0) for term in ours]
        whole = exponents(padded, self.light, self.low, self.high, ours)
        none = exponents([0.0, 0.0], self.light, 0.0, 0.0, ours[:2])
        self.whole = {kind: np.array(values, dtype=float) for kind, values in whole.items()}
        self.still = {kind: np.array(values, dtype=float) for kind, values in none.items()}
        degree = max(n for n, _ in self.terms)
        far = farthest(padded, self.low, self.high)
        steady = 36 + 3 * far + (len(self.terms) + degree + 7) * sum(abs(mp.mpf(x)) for x in self.phase)
        self.steady = float(UNIT * steady + coarse(self.terms, self.phase, far))
        self.side = (SAMPLE_STEPS * max(2, degree) + 1) // 2 + 1
        self.least = 0

    def choose(self, error: float, columns: int) -> bool:
        """Find the lines for the first error, and whether samples were worth their work."""
        b, plain, likely = np.array(CURVES, dtype=float), {}, {}
        for kind, share in (("chords", 0.4), ("nodes", 0.25)):
            sizes = self.still[kind] + share * (self.whole[kind] - self.still[kind])
            at = int(np.argmin((sizes - math.log(error)) / b))
            likely[kind] = at, 0.5 * (sizes[at] - math.log(error)) / b[at]
            at = int(np.argmin((self.whole[kind] - math.log(error)) / b))
            plain[kind] = at, 0.5 * (self.whole[kind][at] - math.log(error)) / b[at]
        self.lines = {kind: (at, self.whole[kind][at]) for kind, (at, _) in plain.items()}

        def work(of: dict[str, tuple[int, float]]) -> float:
            chords, nodes = of["chords"][1], of["nodes"][1]
            return chords * nodes * (45 + len(self.terms) + 2) + 2 * chords * columns

        worth = work(plain) - work(likely) > 1.5 * self.side**2 * (len(self.terms) + 110)
        for kind in ("chords", "nodes") if worth else ():
            curve = likely[kind][0]
            window = np.array([self.low, self.high, 0.0, 0.0])
            given = np.array(self.terms, np.int64), np.array(self.phase), curve, kind == "nodes", window, True
            found = _core_tests.chordal_mean(*given)
            exponent = self.still[kind][curve] + found["mean"] + found["margin"]
            if 0.5 * (exponent - math.log(error)) / b[curve] < plain[kind][1]:
                self.lines[kind] = curve, exponent
                self.least = 16 if kind == "nodes" else 0
        return worth

    def needed(self, kind: str, error: float) -> float:
        curve, exponent = self.lines[kind]
        return 0.5 * (exponent - math.log(error)) / float(CURVES[curve])

    def errors(self, asked: np.ndarray, part: float, single: bool = False) -> np.ndarray:
        """Return the error for each that may be asked for, of which this disk has a part."""
        b = np.array(CURVES, dtype=float)
        total, left, sums = np.full(asked.size, self.steady), part * asked, np.zeros(asked.size)
        for kind, share, each, singly in (("chords", 0.7, 2, 1.5), ("nodes", 1.0, 1 if WIDER else 2, 2.0)):
            curve, exponent = self.lines[kind]
            best = np.argmin((self.whole[kind] - np.log(asked)[:, None]) / b, axis=1)
            better = (self.whole[kind][best] - np.log(asked)) / b[best] < (exponent - np.log(asked)) / b[curve]
            better &= not single  # tried once, by the lines for the first error
            at = np.where(better, best, curve)
            size = np.where(better, self.whole[kind][best], exponent)
            n = enough(kind == "nodes", size, b[at], share * left)
            n = np.maximum(n, self.least) if kind == "chords" else n
            error = np.exp(size - 2 * n * b[at]) / (1 if kind == "nodes" else -np.expm1(-2 * (n + 1) * b[at]))
            left = left - error
            total = total + error + float(UNIT) * each * n
            sums += singly * np.vectorize(steps)(n / 2)
        return total + (2.0**-24 * (30 + sums) + 7.4e-10 * (len(self.terms) + 4) if single else 0.0)


def first_error(terms: list[tuple[int, int]], phase: list[float], light: list[float], obscuration: float, tol: float):
    """Return the error that is asked for at first: a part of the tolerance, times half of a likely peak.

    Less of it where the variance of the phase is more than 4: images may be dimmer there.
    """
    edge = dict(zip(terms, phase, strict=True))
    variance = sum(mp.mpf(value) ** 2 / ((n + 1) * (1 if m == 0 else 2)) for (n, m), value in edge.items() if n > 1)
    part = mp.mpf("0.3") if variance > 4 else mp.mpf("0.4")
    return float(part * mp.mpf(tol) / 2 * amount(light, obscuration) / mp.sqrt(1 + variance))


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
    # Strong phases are worth samples.
    st.sampled_from([0.1, 0.7]),
)
@example([8.0, -3.0, 4.0, 7.0, -5.0, 6.0, 8.0, 5.0], [0.0, 1.5], 1e-6, False, 0.5, 3.0, 0.7)
# Tables of samples for other windows and other terms.
@pytest.mark.quick
@example([8.0, -3.0, 4.0, 7.0, -5.0, 6.0, 8.0, 5.0], [0.0], 1e-6, False, 0.0, 3.0, 0.7)
@example([8.0, -3.0, 4.0, 7.0, -5.0, 6.0, 8.0, 5.0], [0.0], 1e-6, False, 0.0, 4.0, 0.7)
@example([8.0, -3.0, 4.0, 7.0, 0.0, 6.0, 8.0, 6.0], [0.0], 1e-6, False, 0.0, 4.0, 0.7)
@example([8.0, -3.0, 4.0, 7.0, -5.0, 6.0, 0.0, 6.0], [0.0], 1e-6, False, 0.0, 4.0, 0.7)
def test_the_bound_of_an_image_is_made_of_these(c, light, tol, divided, obscuration, column, strength):
    c = [strength * value for value in c]
    images, numbers, step = np.empty((1, 1, 8)), np.empty((3, 1)), 1.2
    scales, bounds, peaks = numbers
    disk, request = (
        DiskStack(TERMS.astype(np.int32), np.array([c]), obscuration, np.array(light)),
        (tol, 1, float(not divided)),
    )
    unmet = _core.chordal_images(disk, ((1, 8), (0.0, column), step), request, images, numbers)
    if unmet:
        assert unmet > tol
        return
    peak = 1.0 / scales[0] if divided else images.max()
    assert peaks[0] == pytest.approx(peak, rel=1e-12)
    low, high, area = -column * step, (7 - column) * step, obscuration**2
    stack = _core_tests.disk_stack(TERMS, np.array(c), obscuration, 0.0, column, step, moved=False)
    terms = stack["terms"]
    lost = float(stack["lost"][0])
    assert (lost > 0) == (obscuration > 0 and any(c))
    first = first_error(terms, stack["outer"], light, obscuration, tol)
    columns = len({abs(j - column) for j in range(8)})
    # Later ones follow from peaks that were found.
    asked = first * np.geomspace(1.0, 1e-9, 4000)
    outer = Disk(terms, stack["outer"], light, low, high)
    worth = outer.choose(first, columns)
    assert worth or min(map(abs, c)) < 2
    candidates = lost + outer.errors(asked, 0.6 if obscuration else 1.0)
    if obscuration:
        within = [g * area**k for k, g in enumerate(light)]
        inner = Disk(terms, stack["inner"], within, obscuration * low, obscuration * high)
        inner.choose(first, columns)
        candidates = candidates + area * inner.errors(asked, 0.4 / area)
    candidates = np.unique(candidates[candidates < math.sqrt(peak)])
    name = "normalized" if divided else "relative"
    expected = [
        _core_tests.stored_bound(_core_tests.intensity_bounds(peak, float(e))[name], False, divided)
        for e in candidates
    ]
    assert np.abs(np.array(expected) / bounds[0] - 1).min() < 1e-9
    assert bounds[0] <= tol


@pytest.mark.quick
@few
@given(coefficients, st.sampled_from([1e-2, 1e-3]), st.booleans(), st.sampled_from([0.0, 0.5]))
def test_the_bound_of_an_image_in_single_precision_has_its_rounding(c, tol, divided, obscuration):
    c = [0.1 * value for value in c]
    images, numbers, step, light = np.empty((1, 1, 8), np.float32), np.empty((3, 1)), 1.2, [0.0]
    _, bounds, peaks = numbers
    disk, request = (
        DiskStack(TERMS.astype(np.int32), np.array([c]), obscuration, np.array(light)),
        (tol, 1, float(not divided)),
    )
    assert _core.chordal_images(disk, ((1, 8), (0.0, 3.0), step), request, images, numbers) == 0.0
    low, high, area = -3 * step, 4 * step, obscuration**2
    stack = _core_tests.disk_stack(TERMS, np.array(c), obscuration, 0.0, 3.0, step, moved=False)
    terms = stack["terms"]
    first = first_error(terms, stack["outer"], light, obscuration, tol)
    outer = Disk(terms, stack["outer"], light, low, high)
    outer.choose(first, 5)
    chords, nodes = outer.needed("chords", first), outer.needed("nodes", first)
    rounded = 2.0**-24 * (30 + 1.5 * steps(chords / 2) + 2 * steps(nodes / 2)) + 7.4e-10 * (len(terms) + 4)
    rounded *= 1 + area
    whole = first * 1.5 * (0.5 if divided else 1.0)
    assert rounded < 0.85 * whole
    asked = np.array([min(first, whole - rounded)])
    error = float(stack["lost"][0]) + outer.errors(asked, 0.6 if obscuration else 1.0, single=True)[0]
    if obscuration:
        inner = Disk(terms, stack["inner"], light, obscuration * low, obscuration * high)
        inner.choose(first, 5)
        error += area * inner.errors(asked, 0.4 / area, single=True)[0]
    name = "normalized" if divided else "relative"
    expected = _core_tests.stored_bound(_core_tests.intensity_bounds(peaks[0], float(error))[name], True, divided)
    assert bounds[0] == pytest.approx(expected, rel=1e-9)


def enough(nodes: bool, exponent: np.ndarray, b: np.ndarray, error: np.ndarray) -> np.ndarray:
    """Return the least number in use for each error by a curve."""
    sizes = SIZES[nodes]
    bounds = np.exp(exponent[:, None] - 2 * sizes * b[:, None])
    if not nodes:
        bounds /= -np.expm1(-2 * (sizes + 1) * b[:, None])
    return sizes[np.argmax(bounds <= error[:, None], axis=1)]


def amount(light: list[float], obscuration: float) -> mp.mpf:
    """Return the integral of the amplitude over t, exact for a Gaussian, else by sixteen nodes, as it is guessed."""
    low = mp.mpf(obscuration) ** 2
    if len(light) <= 2:
        return mp.quad(lambda t: mp.exp(-sum(mp.mpf(g) * t**k for k, g in enumerate(light))), [low, 1])
    x, w = np.polynomial.legendre.leggauss(16)
    t = float(low) + 0.5 * (1 - float(low)) * (1 + x)
    return mp.mpf(0.5 * (1 - float(low)) * (w * np.exp(-np.polynomial.polynomial.polyval(t, light))).sum())


def imaginary(terms: list[tuple[int, int]], edge: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return the imaginary part of a phase at complex points, from its powers of x + iy and x - iy."""
    total, square = np.zeros(np.broadcast(x, y).shape, dtype=complex), x * x + y * y
    for c, (n, m) in zip(edge, terms, strict=True):
        k = abs(m)
        radial = sum(
            (-1) ** j * math.factorial(n - j) * square ** ((n - k) // 2 - j)
            / (math.factorial(j) * math.factorial((n + k) // 2 - j) * math.factorial((n - k) // 2 - j))
            for j in range((n - k) // 2 + 1)
        )  # fmt: skip
        plus, minus = (x + 1j * y) ** k, (x - 1j * y) ** k
        total += c * radial * ((plus + minus) / 2 if m >= 0 else (plus - minus) / 2j)
    return total.imag


def whole_curve(nodes: bool, b: float, one: np.ndarray, two: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the points x, y of a curve at all values of its two angles."""
    x = np.cos(one[:, None] + (0 if nodes else 1j * b)) + 0 * two
    return x, np.sin(one[:, None] + (0 if nodes else 1j * b)) * np.cos(two + (1j * b if nodes else 0))


@functools.cache
def shares(nodes: bool, steps: int, b: float) -> tuple[np.ndarray, np.ndarray]:
    """Return what hats around `steps` samples a half turn have of the mean, by fine sums over all of a curve."""
    step = math.pi / steps
    hats = lambda at, count: np.maximum(0.0, 1.0 - np.abs(at[:, None] / step - np.arange(count)))  # noqa: E731
    fine = (np.arange(200 * steps) + 0.5) * step / 200
    if not nodes:
        around = np.concatenate([fine, math.pi + fine])
        weight = np.sin(around) ** 2 + math.sinh(b) ** 2
        first = (hats(around, 2 * steps + 1) * weight[:, None]).sum(0) / weight.sum()
        first[0] += first[-1]
        half = np.sin(fine) / 2
        return first[:-1], (hats(fine, steps + 1) * half[:, None]).sum(0) / half.sum()
    first = np.zeros(steps + 1)
    for chords in SIZES[0][SIZES[0] >= 16]:
        angle = math.pi * np.arange(1, chords + 1) / (chords + 1)
        weight = 2 * np.sin(angle) ** 2 / (chords + 1)
        first = np.maximum(first, (hats(angle, steps + 1) * weight[:, None]).sum(0))
    return first, np.full(2 * steps, 0.5 / steps)


SAMPLED = [(1, 1), (2, -2), (3, 1), (3, -3), (4, 0), (4, 2), (5, 5)]


@pytest.mark.parametrize("lone", [False, True], ids=["batch", "lone"])
@pytest.mark.parametrize("nodes", [False, True], ids=["chords", "nodes"])
@pytest.mark.parametrize("curve", [30, 44, 52])
@pytest.mark.parametrize("box", [(-9.0, 9.0, -9.0, 9.0), (-3.0, 11.0, -5.0, 2.0)])
def test_the_sampled_mean_is_that_of_the_whole_curve_at_the_worst_corner(lone, nodes, curve, box):
    rng, b = np.random.default_rng(5), float(CURVES[curve])
    edge, steps = rng.normal(size=len(SAMPLED)), 2 * math.ceil(2.5 * 5)
    first, second = shares(nodes, steps, b)
    one, two = (math.pi / steps * np.arange(values.size) for values in (first, second))
    x, y = whole_curve(nodes, b, one, two)
    phase, weight = imaginary(SAMPLED, edge, x, y), first[:, None] * second
    corners = [(v, w) for v in box[:2] for w in box[2:]]
    expected = max(math.log((weight * np.exp(-phase + v * x.imag + w * y.imag)).sum()) for v, w in corners)
    given = np.array(SAMPLED), edge, curve, nodes, np.array(box), lone
    for level in ("avx512", "avx2", "portable"):
        with instructions(level):
            found = _core_tests.chordal_mean(*given)
        # Chords above the exponential, at most 1.0615 of it.
        assert expected - 1e-4 <= found["mean"] <= expected + math.log(1.0616)
    bound = _core_tests.chordal_bounds(np.array(SAMPLED), edge, np.zeros(1), *box[:2])
    rise = max(abs(box[2]), abs(box[3]))
    reach = math.hypot(max(abs(box[0] - edge[0]), abs(box[1] - edge[0])), rise)
    far = max(abs(box[0] - edge[0]), abs(box[1] - edge[0]))
    bend = bound["nodes_bend" if nodes else "chords_bend"][curve] + (
        (rise - 0.0) if nodes else reach - far
    ) * math.sinh(b)
    size = sum(abs(c) * math.sinh(n * b) for c, (n, _) in zip(edge, SAMPLED, strict=True))
    samples = (steps // 2 + 1) ** 2
    margin = (math.pi / steps) ** 2 / 4 * bend + 1e-3 + 2.0**-24 * ((len(SAMPLED) + 10) * size + 8 * samples)
    assert found["margin"] == pytest.approx(margin, rel=1e-9)


@pytest.mark.parametrize("nodes", [False, True], ids=["chords", "nodes"])
@pytest.mark.parametrize("strength", [0.3, 3.0, 30.0])
def test_the_sampled_mean_and_its_margin_are_above_the_mean_anywhere_in_the_window_and_not_far(nodes, strength):
    rng, box = np.random.default_rng(int(10 * strength)), (-6.0, 8.0, -3.0, 5.0)
    one = math.pi * (np.arange(600) + 0.5) / 300
    turn = math.pi * (np.arange(400) + 0.5) / (200 if nodes else 400)
    for curve in (28, 38, 48):
        b, edge = float(CURVES[curve]), strength * rng.normal(size=len(SAMPLED)) * [0.1] + 0.0
        x, y = whole_curve(nodes, b, one, turn)
        # Where chords lie counts by sin^2; where the sums over them go, by the weight of the first sum, and by dy.
        weight = np.sin(one)[:, None] ** 2 + (0 * turn if nodes else math.sinh(b) ** 2 + 0 * turn)
        weight = weight * (1.0 if nodes else np.sin(turn))
        phase = imaginary(SAMPLED, edge, x, y)
        inside = [(v, w) for v in np.linspace(*box[:2], 4) for w in np.linspace(*box[2:], 4)]
        means = [
            math.log((weight * np.exp(-phase + v * x.imag + w * y.imag)).sum() / weight.sum()) for v, w in inside
        ]
        found = _core_tests.chordal_mean(np.array(SAMPLED), edge, curve, nodes, np.array(box), True)
        assert max(means) <= found["mean"] + found["margin"]
        # What sums over few chords have more than integrals included.
        assert found["mean"] <= max(means) + 0.6
    assert (found["margin"] > 0.1) == (strength > 1)


# The theorems are reached to within a factor of 2, where they can be.


@pytest.mark.theorem
@pytest.mark.parametrize("chords", [8, 13])
def test_the_sum_over_chords_takes_the_first_wave_that_it_does_not_know_for_a_constant(chords):
    angle = math.pi * np.arange(2 * chords + 2) / (chords + 1)
    assert np.cos((2 * chords + 2) * angle).mean() == pytest.approx(1.0)
    assert abs(np.cos(2 * chords * angle).mean()) < 1e-12


@pytest.mark.theorem
@pytest.mark.parametrize("nodes", [4, 8, 40])
def test_the_sum_over_nodes_is_off_by_most_of_what_is_allowed(nodes):
    """T_2K is taken for its value at the nodes, which is at most 32/15 away from its integral, and more than 1."""
    eta, w = np.polynomial.legendre.leggauss(nodes)
    for degree in range(2 * nodes, 6 * nodes, 2):
        wrong = abs((w * np.cos(degree * np.arccos(eta))).sum() + 2 / (degree**2 - 1))
        assert wrong <= 32 / 15
        assert degree > 2 * nodes or wrong > 1.4
    # Weights rise towards the middle, on which the rounding of sums rests.
    assert (np.diff(w[: nodes // 2]) > 0).all()


@pytest.mark.theorem
@pytest.mark.parametrize("b", [0.2, 0.7])
@pytest.mark.parametrize("v", [3.0, 12.0])
def test_a_wave_across_chords_has_an_error_close_to_its_bound(b, v):
    """The error of N chords for e^(-ivx), against the mean of its size on the curve."""
    a = math.pi * np.arange(4000) / 2000
    chords = 2 * math.ceil((v * math.sinh(b) + 8.0) / (4 * b))

    def wave(angle: np.ndarray) -> np.ndarray:
        return np.sin(angle) ** 2 * 2 * np.exp(-1j * v * np.cos(angle))

    nodes = math.pi * np.arange(2 * chords + 2) / (chords + 1)
    error = abs(wave(nodes).mean() - wave(a).mean())
    mean = np.abs(wave(a + 1j * b)).mean() / math.cosh(2 * b)
    bound = (1 + math.exp(-4 * b)) * mean * math.exp(-2 * chords * b) / (1 - math.exp(-2 * (chords + 1) * b))
    assert error <= bound + 1e-15


@pytest.mark.theorem
@pytest.mark.parametrize("tilt", [3.0, -7.0])
def test_a_tilt_reaches_its_growth(tilt):
    """exp(i c x) at x = cos(a + ib) is exp(c sinh b) at most."""
    b, a = 0.8, np.linspace(0, 2 * np.pi, 2001)
    assert np.imag(-tilt * np.cos(a + 1j * b)).max() == pytest.approx(abs(tilt) * math.sinh(b), rel=1e-5)
