"""From the table of a window to the bounds of its images, again: docs/certificate.md 9, tables as they are."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import mpmath as mp
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.special import j1

import edge_light
import lommel as lm
import rendering
from core_tests import WIDER, _core_tests
from lommel.core.answers import Intensities
from lommel.optics.grid import Grid
from pixel_tables import Table, U, Window, lebesgue

SINGLE = mp.mpf(2) ** -24
few = settings(max_examples=12)
phases = st.lists(st.floats(-12, 12), min_size=1, max_size=3)
gaussians = st.one_of(st.just(0.0), st.floats(0.01, 5.0))
obscurations = st.one_of(st.just(0.0), st.floats(0.05, 0.9))


def chebyshev_points(count: int) -> np.ndarray:
    return np.cos(np.pi * (np.arange(count)[::-1] + 0.5) / count)


def by_slopes(half: mp.mpf, points: int, reach: mp.mpf) -> mp.mpf:
    """Return what interpolation by r^2 over `half` each way is off by, from `reach` on."""
    n = points - 1
    squares = sum(
        mp.factorial(n + j) / (mp.factorial(j) * mp.factorial(n - j)) / (4 * reach) ** j for j in range(points)
    )
    return 2 * half**points / mp.factorial(points) * squares


class Pieces(NamedTuple):
    """Samples by polynomials of the distance, or of its square, on pieces, and by shorter ones on parts of them."""

    window: Window
    level: int

    @property
    def error(self) -> mp.mpf:
        """What pieces, as parts magnify it, and parts may be off by, where squares begin: ten to one."""
        return mp.mpf(10) ** -self.level / 2 / mp.mpf("1.1")

    @property
    def width(self) -> mp.mpf:
        return 2 * (self.error / lebesgue(8) / by_slopes(mp.mpf(1), 16, mp.mpf(32))) ** (mp.mpf(1) / 16)

    @property
    def parts(self) -> int:
        """Of a piece, in double precision."""
        half = (self.error / 10 / by_slopes(mp.mpf(1), 8, mp.mpf(32))) ** (mp.mpf(1) / 8)
        return 2 * int(mp.ceil(self.width / 4 / half))

    @property
    def equal(self) -> int:
        """How many from the axis on have this width: the least even number that reaches 32."""
        return 2 * int(mp.ceil(16 / self.width))

    def places(self, distances: np.ndarray) -> np.ndarray:
        """Return in which piece distances are: linear up to so many, then in squares from R to 2 R."""
        found = distances / float(self.width)
        of_squares = np.zeros_like(found)
        begin = start = float(self.equal)
        for _ in range(40):
            within = (found >= begin) & (found < 2 * begin)
            of_squares[within] = (start + (found**2 - begin**2) / (2 * begin))[within]
            start += 1.5 * begin
            begin *= 2
        return np.where(found < self.equal, found, of_squares)

    def ends(self) -> tuple[int, int]:
        """Return the first piece and the one after the last, both even."""
        sides = (self.window.row, self.window.height), (self.window.column, self.window.width)
        within = [max(0.0, -c, c - n + 1) for c, n in sides]
        nearest = math.hypot(*within) * self.window.step
        first, last = self.places(np.array([nearest, self.window.distances()[-1]])) / 2
        return int(first) * 2, (int(last) + 1) * 2

    def pays(self) -> bool:
        first, last = self.ends()
        return 16 * (last - first) <= self.window.height * self.window.width + 1024

    def distances(self, places: np.ndarray) -> np.ndarray:
        """Return where pieces and parts of them are, as places() has them."""
        found, begin, start = places * 1.0, float(self.equal), float(self.equal)
        for _ in range(40):
            within = (places >= start) & (places < start + 1.5 * begin)
            found[within] = np.sqrt(begin**2 + 2 * begin * (places[within] - start))
            start += 1.5 * begin
            begin *= 2
        return float(self.width) * found

    def radii(self) -> np.ndarray:
        """Return Chebyshev points of what pieces are equal in: of distances or of squares."""
        return self.distances(np.ravel(np.arange(*self.ends())[:, None] + (1 + chebyshev_points(16)) / 2))

    def series(self, profile: np.ndarray) -> np.ndarray:
        values = np.polynomial.chebyshev.chebvander(chebyshev_points(16), 15)
        return np.linalg.solve(values, profile.reshape(-1, 16).T)

    def values(self, profile: np.ndarray) -> tuple[np.ndarray, mp.mpf]:
        y, x = np.arange(self.window.height) - self.window.row, np.arange(self.window.width) - self.window.column
        place = self.places(self.window.step * np.hypot(y[:, None], x)) - self.ends()[0]
        part = np.floor(self.parts * place).astype(int)
        powers = self.coefficients(profile, self.parts, 8).reshape(-1, 8)[part]
        values = np.polynomial.polynomial.polyval(
            self.parts * place - part - 0.5, np.moveaxis(powers, -1, 0), tensor=False
        )
        return values, mp.mpf(0)

    def astray(self, parts: int, room: mp.mpf) -> tuple[float, int]:
        """Return what places of so many pixels are off by, in parts: less than `room` in v, or 0."""
        scale = self.window.step / float(self.width)
        sides = (self.window.row, self.window.height), (self.window.column, self.window.width)

        def squares(center: float, count: int) -> tuple[float, float]:
            ends = center, count - 1 - center
            return (scale * max(0, -ends[0], -ends[1])) ** 2, (scale * max(map(abs, ends))) ** 2

        near, far = squares(*sides[0])
        zones = [float(self.equal)]
        while 2 * zones[-1] * float(self.width) <= self.radii()[-1]:
            zones.append(2 * zones[-1])
        zones = zones if zones[0] * float(self.width) <= self.radii()[-1] else []
        for together in (128, 64, 32):
            worst = 0.0
            for start in range(0, self.window.width, together):
                least, most = squares(self.window.column - start, min(together, self.window.width - start))
                for zone in zones:
                    end = 16 * zone**2 if 2 * zone in zones[:-1] else math.inf
                    if zone**2 <= far + most and most + near < end and most - least <= end - zone**2:
                        span = (most - least) * parts / (2 * zone)
                        worst = max(worst, 2.0 ** (max(7, math.floor(math.log2(1.5 * span + 4))) - 31))
            if worst * float(self.width) / parts < room:
                return worst, together
        return 0.0, 128

    def bends(self, profile: np.ndarray, order: int, points: int) -> np.ndarray:
        """Return a bound on a derivative of each piece, from what it is at so many points."""
        derivative = np.polynomial.chebyshev.chebder(self.series(profile), order)
        seen = np.abs(np.polynomial.chebyshev.chebval(chebyshev_points(points), derivative)).max(1)
        return seen / np.cos(np.pi * (15 - order) / (2 * points))

    def coefficients(self, profile: np.ndarray, parts: int, terms: int) -> np.ndarray:
        """Return those of powers of the place in a part, from -1/2 to 1/2: [piece, part, power]."""
        y = chebyshev_points(terms)
        x = (2 * np.arange(parts)[:, None] + 1 + y) / parts - 1
        values = np.polynomial.chebyshev.chebval(x, self.series(profile))
        return values @ np.linalg.inv(np.vander(y, increasing=True).T) * 2.0 ** np.arange(terms)

    def singly(self, profile: np.ndarray, top: float, room: mp.mpf, places: mp.mpf) -> mp.mpf:
        """Return what cubics and lines, off by about `room`, add with their roundings, and the largest value."""
        allowed, pieces = float(room), profile.reshape(-1, 16)
        bent = self.bends(profile, 4, 16).max()
        parts = min(64, 2 * max(1, math.ceil((bent / (192 * allowed)) ** 0.25 / 2)))
        curves = self.bends(profile, 2, 32)
        curved = curves > 4 * parts**2 * allowed
        straight = len(curves) - int(np.argmax(curved[::-1])) if curved.any() else 0
        astray, together = self.astray(parts, places)
        first = self.ends()[0]
        begins = self.distances(np.array([first + straight + 1e-4]))[0]
        reach = begins + together * self.window.step
        bends = min(len(pieces), int(self.places(np.array([reach]))[0] + 1e-4) + 1 - first)

        def rough(some: np.ndarray, terms: int) -> float:
            if some.size == 0:
                return 0.0
            powers = np.pad(np.abs(self.coefficients(some, parts, terms)).max((0, 1)), (0, 4 - terms))
            rounded = float(SINGLE) * powers @ [1, 6 / 2, 9 / 4, 12 / 8]
            return 1.01 * (rounded + astray * powers @ [0, 1, 2 / 2, 3 / 4])

        return SINGLE * mp.mpf(top) + max(
            mp.mpf(bent) / (192 * parts**4) + rough(pieces[:bends], 4),
            mp.mpf(curves[straight:].max(initial=0.0)) / (4 * parts**2) + rough(pieces[straight:], 2),
        )

    def table(self) -> Table:
        y, x = chebyshev_points(8), chebyshev_points(16)
        places = (2 * np.arange(self.parts // 2)[:, None] + 1 + y) / self.parts
        basis = np.linalg.inv(np.polynomial.chebyshev.chebvander(x, 15))
        through = np.abs(np.polynomial.chebyshev.chebval(places, basis))
        pairs = 2 * np.maximum(through, through[::-1])[:8].sum(0)
        sizes = (pairs @ np.abs(np.linalg.inv(np.vander(y))).T).max(0).sum()
        reach, half = self.equal * self.width, self.width / 2
        error = lebesgue(8) * by_slopes(half, 16, reach) + by_slopes(half / self.parts, 8, reach)
        # Of a polynomial of degree 15 the eighth derivative is largest at 1 for Chebyshev's (Markov).
        steepest = np.polynomial.chebyshev.chebval(1.0, np.polynomial.chebyshev.chebder([0] * 15 + [1], 8))
        bent = mp.mpf(steepest) / (2**7 * mp.factorial(8) * self.parts**8)
        return Table(error, lebesgue(16), min(lebesgue(8), 1 + bent), 24 * mp.mpf(sizes))


class Tabulated(NamedTuple):
    """Values by weights, as a table has them."""

    window: Window
    level: int

    def radii(self) -> np.ndarray:
        return self.window.radii(self.level)

    def values(self, profile: np.ndarray) -> tuple[np.ndarray, mp.mpf]:
        return self.window.values(self.level, profile)

    def table(self) -> Table:
        return table_of(self.window, self.level)


Way = type[Pieces] | type[Tabulated]


def table_of(window: Window, level: int) -> Table:
    """Return the terms of a table, each of which test_pixel_terms.py computes again."""
    made: dict[str, Any] = _core_tests.pixel_bounds(*window, level)
    return Table(*(mp.mpf(made[name]) for name in Table._fields))


class Lens(NamedTuple):
    phase: list[float]
    gaussian: float
    obscuration: float

    def amplitude(self, power: float, gaussian: float) -> mp.mpf:
        return mp.quad(lambda t: t**power * mp.exp(-gaussian * t), [mp.mpf(self.obscuration) ** 2, 1])

    @property
    def most(self) -> mp.mpf:
        """Of |U|."""
        return self.amplitude(0, self.gaussian)

    @property
    def likely(self) -> mp.mpf:
        """The guess at the peak of |U|."""
        return self.most / (4 * sum(map(abs, map(mp.mpf, self.phase))) + 1)

    def most_of(self, power: int) -> mp.mpf:
        return min(self.most, self.amplitude(power, 0.0))

    def field(self, power: int, radii: np.ndarray, error: float) -> tuple[np.ndarray, mp.mpf]:
        """Return U as it is computed, and the bound of sections 1 to 5, which has tests of its own."""
        args = (np.array(self.phase), np.array([0.0, self.gaussian]), power, self.obscuration)
        found: dict[str, Any] = _core_tests.field_values(*args, radii, error)
        return np.array(found["re"]) + 1j * np.array(found["im"]), mp.mpf(found["error"])


class Judged(NamedTuple):
    way: Pieces | Tabulated
    table: Table
    radii: np.ndarray
    of_field: mp.mpf
    size: float
    top: float
    off: mp.mpf
    by_field: mp.mpf
    singly: mp.mpf  # how much of the error, also of `top`, is that of single precision


def judged(
    lens: Lens, way: Pieces | Tabulated, error: float, singly: mp.mpf | None = None, *, divided: bool = False
) -> Judged:
    """`singly`: by sums in single precision, to that tolerance."""
    v, table = way.radii(), way.table()
    u, e = lens.field(0, v, error)
    intensity = np.abs(u) ** 2
    values, rounded = way.values(intensity)
    size, top = float(intensity.max()), float(values.max())
    given = 2 * mp.sqrt(size) * e + e * e
    off = table.window(v[-1], size, given, mp.sqrt(table.of_nodes * size), lens.most**2 / 2, rounded)
    by_cubics = singly is not None and isinstance(way, Pieces)
    room = mp.mpf("0.15") if divided else mp.mpf("0.3")
    rough = way.singly(intensity, top, room * singly * size, singly / 4) if by_cubics else mp.mpf(0)
    return Judged(way, table, v, e, size, top, off + rough, table.magnification * given, rough)


def storing(relative: mp.mpf, single: bool) -> mp.mpf:
    s = 6 * U + (SINGLE if single else 0)
    return relative + (1 + relative) * s


def likely_value(lens: Lens, window: Window) -> mp.mpf:
    spread_out = mp.mpf(window.side) ** 2 / (4 * mp.pi * lens.amplitude(0, 2 * lens.gaussian))
    return 1 / (1 / lens.likely**2 + spread_out)


def asked(lens: Lens, window: Window, allowed: mp.mpf) -> tuple[float, int]:
    """Return the error of U and the level of the table that a call begins with."""
    value, likely = likely_value(lens, window), lens.likely
    level = int(mp.ceil(-mp.log10(allowed * value / (2 * lens.most**2))))
    return max(float(allowed * value / likely / 50), 8 * float(U)), min(max(level, 3), 15)


def related(off: mp.mpf, peak: mp.mpf, divided: bool, single: bool, stored_first: bool = False) -> mp.mpf:
    relative = off / peak if peak > 0 else mp.inf
    if divided:
        relative = 2 * relative / (1 - relative) if relative < 1 else mp.inf
    once = storing(relative, single)
    return once + (1 + relative) * SINGLE if single and divided and stored_first else once


class Answer(NamedTuple):
    bound: mp.mpf
    peak: mp.mpf
    found: Judged
    error: float

    @property
    def close(self) -> float:
        """How closely it is known: the core divides by a largest value that may be one in single precision."""
        return float(1e-9 + 1.01 * self.found.singly / self.peak)


def answered(lens: Lens, window: Window, tol: float, divided: bool, single: bool) -> Answer | None:
    """Follow a call through its attempts; return None where roundings leave none."""
    level = asked(lens, window, mp.mpf(tol) - mp.mpf(1.1) * storing(mp.mpf(0), single))[1]
    # Pixels that are wide, or of which a table would have to be as exact as it can be.
    if window.integrate and (window.step >= 7.4 or (window.step >= 2 and level >= 14)):
        found = across_edges(lens, window, tol, divided, single)
    elif not window.integrate and Pieces(window, level).pays():
        found = attempted(lens, window, tol, divided, single, Pieces)
    else:
        found = None
    return found or attempted(lens, window, tol, divided, single, Tabulated)


def across_edges(lens: Lens, window: Window, tol: float, divided: bool, single: bool) -> Answer | None:
    """Return averages by the light that crosses edges of pixels, or None; derivatives take a table all the same."""
    allowed = mp.mpf(tol) - mp.mpf(1.1) * storing(mp.mpf(0), single)
    first, level = asked(lens, window, allowed)
    field, least = max(8 * float(U), first / 10), 8 * float(U)
    seen = allowed * likely_value(lens, window) / (2 if divided else 1)
    request = edge_light.Asked(mp.mpf("0.6") * seen, field, mp.mpf("0.4") * seen)
    pupil = np.array(lens.phase), np.array([0.0, lens.gaussian]), lens.obscuration
    light = edge_light.Light(pupil, lens.most, lens.amplitude(0, 2 * lens.gaussian))
    pixels = min(512, math.ceil(spread(lens) / window.step)) + 1
    line = Window(1, pixels, 0.0, 0.0, window.step, True)

    def averages(window: Window) -> edge_light.Averages:
        return edge_light.averaged(light, lambda v, error: lens.field(0, v, error), window, request)

    elsewhere, looked = mp.mpf(0), divided
    while True:
        found = averages(window)
        if related(found.off, max(found.top - found.off, elsewhere), divided, single) > tol and not looked:
            along = averages(line)
            looked, elsewhere = True, along.top - along.off
        peak = max(found.top - found.off, elsewhere)
        bound = related(found.off, peak, divided, single)
        if bound <= tol:
            return Answer(bound, peak, judged(lens, Tabulated(window, level), first), first)
        seen = max(found.top, elsewhere, found.off / 1000)
        room, before = (0.1 if divided else 0.2) * allowed * seen, request
        if found.rings > room:
            request = request._replace(rings=min(request.rings / 2, room))
        if found.error > room:
            share = min(mp.mpf(0.1), room / found.error)
            request = request._replace(
                field=max(least, float(request.field * share)), sums=max(least * seen, request.sums * share)
            )
        if all(new >= old for new, old in zip(request, before, strict=True)):
            return None


def attempted(lens: Lens, window: Window, tol: float, divided: bool, single: bool, way: Way) -> Answer | None:
    allowed = mp.mpf(tol) - mp.mpf(1.1) * storing(mp.mpf(0), single)
    error, level = asked(lens, window, allowed)
    elsewhere, looked = mp.mpf(0), divided
    singly = single and way is Pieces and allowed >= mp.mpf("5e-7")
    while True:
        found = judged(lens, way(window, level), error, allowed if singly else None, divided=divided)
        if (
            related(found.off, max(found.top - found.off, elsewhere), divided, single, way is Pieces) > tol
            and not looked
        ):
            looked, elsewhere = True, peak_on_a_line(lens, window, level, error)
        if singly and related(found.off, max(found.top - found.off, elsewhere), divided, single, True) > tol:
            singly, found = False, judged(lens, way(window, level), error)
        peak = max(found.top - found.off, elsewhere)
        bound = related(found.off, peak, divided, single, way is Pieces)
        if bound <= tol:
            return Answer(bound, peak, found, error)
        room = (0.1 if divided else 0.2) * allowed * max(found.top, elsewhere, found.off / 1000)
        by_table, before = found.table.error * lens.most**2 / 2, (error, level)
        if found.by_field > room:
            error = max(8 * float(U), float(error * min(mp.mpf(0.1), room / found.by_field)))
        if by_table > room:
            level = min(15, level + int(mp.ceil(mp.log10(by_table / room))))
        if (error, level) == before:
            return None


def spread(lens: Lens) -> float:
    """Rays reach |dPhi / drho| <= sum 2 j (j + 1) |a_j|; to 4 beyond."""
    return 4 + 2 * sum(j * (j + 1) * abs(a) for j, a in enumerate(lens.phase, 1))


def peak_on_a_line(lens: Lens, window: Window, level: int, error: float) -> mp.mpf:
    """From the axis to where rays arrive, 512 steps at most."""
    blur = spread(lens)
    step = window.step if window.integrate else blur / 512
    line = Window(1, min(512, math.ceil(blur / step)) + 1, 0.0, 0.0, step, window.integrate)
    there = judged(lens, Tabulated(line, level), error)
    return there.top - there.off


def rendered(lens: Lens, window: Window, tol: float, divided: bool, single: bool, powers: list[int]):
    """Return what the core proves: the bound, the peak, those of derivatives; its caches full of what it needs."""
    pupil, kind = ([lens.phase], lens.obscuration, [0.0, lens.gaussian]), np.float32 if single else np.float64
    for _ in range(2):
        made = of_window(*pupil, window, tol, divided=divided, powers=powers, dtype=kind)
    return None if made.unmet else (made.bounds[0], made.peaks[0], made.slope_bounds[:, 0])


def of_window(pupils, obscuration: float, light: list[float], window: Window, tol: float, **options: Any):
    height, width, row, column, step, integrate = window
    place = {"center": (row, column), "integrate": integrate}
    return rendering.rendered(pupils, obscuration, light, (height, width), step, tol, **place, **options)


WINDOWS = [
    Window(6, 9, 3.0, 4.0, 0.8, True),
    Window(5, 5, 2.2, -31.7, 1.9, True),
    Window(7, 4, 9.3, 1.6, 0.5, False),
    Window(9, 150, 20.3, -61.6, 0.9, False),
    Window(3, 310, -2.3, 140.2, 1.7, False),
    Window(3, 2, 1.0, 1.0, 7.3, True),
    Window(4, 3, 1.0, 5.3, 12.6, True),
]


@few
@given(phases, gaussians, obscurations, st.sampled_from([1e-3, 1e-6, 1e-9]), st.booleans(), st.booleans())
# Averages of 7.3 by the light that crosses edges.
@example(phase=[6.0, 12.0], gaussian=0.0, obscuration=0.0, tol=1e-9, divided=False, single=False)
@pytest.mark.parametrize("window", WINDOWS)
def test_the_bound_of_an_image(window, phase, gaussian, obscuration, tol, divided, single):
    tol = max(tol, 1e-6) if single else tol
    lens = Lens(phase, gaussian, obscuration)
    found = rendered(lens, window, tol, divided, single, [])
    expected = answered(lens, window, tol, divided, single)
    assert (found is None) == (expected is None)
    if found is not None and expected is not None:
        assert found[0] == pytest.approx(float(expected.bound), rel=expected.close, abs=0.0)
        assert found[1] == pytest.approx(float(expected.peak), rel=expected.close, abs=0.0)


def of_derivative(lens: Lens, window: Window, power: int, answer: Answer, single: bool = False) -> mp.mpf:
    table, v, e = answer.found.table, answer.found.radii, answer.found.of_field
    (u, _), (t, own) = lens.field(0, v, answer.error), lens.field(power, v, answer.error)
    slopes = 2 * (u.conj() * 1j * t).real
    steepest, root, other = np.abs(slopes).max(), mp.sqrt(answer.found.size), mp.mpf(float(np.abs(t).max()))
    _, rounded = answer.found.way.values(slopes)
    given = 2 * (root * own + other * e + own * e)
    slope, swing = mp.sqrt(table.of_nodes) * (root + other), 2 * lens.most * lens.most_of(power)
    off = table.window(v[-1], steepest, given, slope, swing, rounded)
    return (off + storing(mp.mpf(0), single) * steepest * table.magnification) / answer.peak


@few
@given(phases, gaussians, obscurations, st.integers(1, 4), st.sampled_from([1e-4, 1e-8]), st.booleans())
@pytest.mark.parametrize("window", WINDOWS)
def test_the_bound_of_a_derivative(window, phase, gaussian, obscuration, power, tol, single):
    tol = max(tol, 1e-6) if single else tol
    lens = Lens(phase, gaussian, obscuration)
    found, answer = rendered(lens, window, tol, False, single, [power]), answered(lens, window, tol, False, single)
    if found is not None and answer is not None:
        expected = of_derivative(lens, window, power, answer, single)
        assert found[2][0] == pytest.approx(float(expected), rel=answer.close, abs=0.0)


@pytest.mark.parametrize("tol", [1e-4, 1e-9])
@pytest.mark.parametrize(
    "window",
    [
        Window(140, 120, 60.0, 2.0, 0.8, True),
        Window(80, 70, 12.5, 4.0, 1.7, True),
        Window(300, 300, 150.2, 150.4, 0.4, False),
    ],
)
def test_the_bounds_of_a_large_image(window, tol):
    lens = Lens([5.0, -3.0], 0.5, 0.3)
    found, answer = rendered(lens, window, tol, False, False, [2]), answered(lens, window, tol, False, False)
    assert found is not None
    assert answer is not None
    assert isinstance(answer.found.way, Pieces) != window.integrate
    assert answer.found.table.of_grid > 1
    assert found[0] == pytest.approx(float(answer.bound), rel=1e-9, abs=0.0)
    assert found[2][0] == pytest.approx(float(of_derivative(lens, window, 2, answer)), rel=1e-9, abs=0.0)


def test_the_largest_average_may_lie_outside_the_window():
    """A window where no light is: errors are divided by what is found on a line from the axis."""
    lens = Lens([9.0], 0.0, 0.0)
    for integrate in (True, False):
        window = Window(4, 4, 1.5, -90.0, 0.9, integrate)
        tol = 1e-9 if integrate else 1e-11  # more than the window alone could prove
        found, answer = rendered(lens, window, tol, False, False, []), answered(lens, window, tol, False, False)
        assert found is not None
        assert answer is not None
        assert answer.peak > 100 * answer.found.top
        assert found[0] == pytest.approx(float(answer.bound), rel=1e-9, abs=0.0)
        assert found[1] == pytest.approx(float(answer.peak), rel=1e-9, abs=0.0)
        # Values divided by their own largest are judged by the window alone.
        alone, own = rendered(lens, window, 1e-6, True, False, []), answered(lens, window, 1e-6, True, False)
        assert alone is not None
        assert own is not None
        assert alone[0] == pytest.approx(float(own.bound), rel=1e-9, abs=0.0)


@few
@given(
    st.lists(st.tuples(st.floats(-9, 9), st.floats(-5, 5)), min_size=4, max_size=9),
    st.sampled_from([1e-8, 1e-9]),
    st.booleans(),
)
@pytest.mark.parametrize("window", [WINDOWS[0], WINDOWS[2]])
def test_the_bounds_of_a_stack(window, rows, tol, divided):
    """One table of Bessel functions for all: terms that do for the whole box, and no pieces."""
    pupils, gaussian = np.array(rows), 0.3
    unmet, _, _, bounds, *_ = of_window(pupils, 0.0, [0.0, gaussian], window, tol, divided=divided)
    if unmet:
        return
    allowed = mp.mpf(tol) - mp.mpf(1.1) * storing(mp.mpf(0), False)
    error, level = asked(Lens(list(np.abs(pupils).max(axis=0)), gaussian, 0.0), window, allowed)
    v, table = window.radii(level), table_of(window, level)
    box = np.array([pupils.min(axis=0), pupils.max(axis=0)])
    plans: list[tuple[int, int, mp.mpf]] = []
    for terms in range(1, 80):
        ends = [
            _core_tests.ellipse_bounds(box, np.array([0.0, gaussian]), 0, terms, 400)["tail"],
            _core_tests.window_bounds(terms, v[-1])["legendre"],
        ]
        for nodes in range(16, 113, 16):
            missed = _core_tests.ellipse_bounds(box, np.array([0.0, gaussian]), 0, terms, nodes)["quadrature"]
            if missed <= 0.1 * error:
                plans += [(terms, nodes, mp.mpf(end) + missed) for end in ends if end <= 0.5 * error]
                break
        if len(plans) > 8:  # the core takes the fewest terms that do
            break
    of_radii = 6 * min(v[-1] / 2, 0.661 * math.sqrt(v[-1]))
    for i, row in enumerate(rows):
        lens = Lens(list(row), gaussian, 0.0)
        intensity = np.abs(lens.field(0, v, 1e-13)[0]) ** 2
        values, rounded = window.values(level, intensity)
        expected, size = [], float(intensity.max())
        for terms, nodes, left in plans:
            used = np.count_nonzero(row)
            rounding = (
                (used + 6) * abs(row[0])
                + (used + 7) * abs(row[1])
                + 4 * gaussian
                + 8
                + math.sqrt(terms) * (nodes / 4 + 16 + (0.0 if WIDER else 1.5 * math.sqrt(nodes)))
            )
            e = left + U * (rounding + terms + 16 + of_radii)
            given = 2 * mp.sqrt(size) * e + e * e
            off = table.window(v[-1], size, given, mp.sqrt(table.of_nodes * size), lens.most**2 / 2, rounded)
            expected.append(float(related(off, values.max() - off, divided, False)))
        if max(expected) > tol:  # it was done again on its own
            again = answered(lens, window, tol, divided, False)
            assert again is not None
            expected.append(float(again.bound))
        # Computed once to the error asked of U, once to 1e-13.
        assert any(bounds[i] == pytest.approx(e, rel=1e-8, abs=0.0) for e in expected)


@few
@given(st.floats(0.5, 3.0), st.floats(0.3, 4.0), st.sampled_from([1.0, 1.7]), st.sampled_from([1e-4, 1e-6]))
@pytest.mark.parametrize("center", [(3.0, 4.0), (2.3, -5.0)])
def test_the_bound_of_a_profile_that_a_method_knows(center, ceiling, step, faster, tol):
    class Known(lm.methods.NijboerZernike):
        def profile(self, pupil, v):
            return Intensities(ceiling * airy(v)[None], np.array([1e-8 * tol]), np.array([ceiling]))

        def unaberrated_peak(self, pupil):
            return ceiling

        def stretch(self, pupil):
            return faster

        def tightened(self):
            return self

    pupil, grid = lm.Pupil(), Grid((7, 8), step / math.pi, center=center, integrate=True)
    found = Known(tol).on_pixels(pupil, grid, 1, window=True)
    window, expected = Window(7, 8, *center, faster * grid.step(pupil), True), []
    for level in range(3, 16):
        v, table = window.radii(level), table_of(window, level)
        profile = ceiling * airy(v / faster)
        values, rounded = window.values(level, profile)
        slope = mp.sqrt(table.of_nodes * float(profile.max()) * max(1.0, ceiling))
        off = table.window(v[-1], profile.max(), 1e-8 * tol * mp.mpf(ceiling), slope, mp.mpf(ceiling) / 2, rounded)
        expected.append(float(off / (values.max() - off)))
    assert any(found.error[0] == pytest.approx(e, rel=1e-9, abs=0.0) for e in expected)


def airy(v: np.ndarray) -> np.ndarray:
    return np.where(v > 0, 2 * j1(v) / np.where(v > 0, v, 1.0), 1.0) ** 2
