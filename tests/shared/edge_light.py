"""Averages over pixels as the light that crosses their edges, with bounds: docs/certificate.md 9, coarse pixels."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import mpmath as mp
import numpy as np
from scipy.integrate import quad

from core_tests import _core_tests
from pixel_tables import U, Window, gauss, interpolation, lebesgue

# From radii and an error to U there, and the bound on its error.
Field = Callable[[np.ndarray, float], tuple[np.ndarray, mp.mpf]]


class Light(NamedTuple):
    """A pupil: phase, amplitude and obscuration as the core takes them; the largest |U|; the integral of E_0^2."""

    pupil: tuple[np.ndarray, np.ndarray, float]
    most: mp.mpf
    passed: mp.mpf


class Asked(NamedTuple):
    """Errors of averages without rings, of U, and of the sums along edges."""

    rings: mp.mpf
    field: float
    sums: mp.mpf


class Averages(NamedTuple):
    top: float
    rings: mp.mpf
    error: mp.mpf

    @property
    def off(self) -> mp.mpf:
        return max(self.rings, self.error)


def ringless(light: Light, step: float, asked: mp.mpf) -> tuple[float, mp.mpf]:
    """Return from where on pixels do without rings, and what they are off by then."""

    def left(r: float) -> mp.mpf:
        tail: dict[str, Any] = _core_tests.tail_bounds(*light.pupil, r)
        return mp.mpf("3.1416") * tail["rings"] / (r * step) + mp.mpf("1.6") * tail["curved"]

    low, high = 1.0, 1e8
    while high > 1.01 * low:
        middle = math.sqrt(low * high)
        low, high = (low, middle) if left(middle) <= asked else (middle, high)
    return high, left(high)


def fewest(enough: Callable[[int], bool]) -> int:
    return next(n for n in range(4, 10000) if enough(n))


def steepness(order: int, swing: mp.mpf) -> mp.mpf:
    """Return |derivative of this order| / 2^order of the intensity along a line, by Bernstein or from the pupil."""
    return min(swing, 64 / (mp.pi * (order + 2) ** 2 * (order + mp.mpf("1.25"))))


def along_edge(step: float, q: int, reach: float, swing: mp.mpf) -> mp.mpf:
    """Return what `q` nodes along an edge that ends at `reach` are off by."""
    return reach * step * gauss(step, q) * steepness(2 * q, swing) / (4 * (q + 1))


def between_points(n: int, swing: mp.mpf) -> tuple[mp.mpf, mp.mpf]:
    """Return what the energy on a part of a panel and on all of it is off by, over the distance of its end."""
    part = whole = mp.mpf(0)
    for k in range(n, 3 * n):
        size = 2 * steepness(k, swing) / mp.factorial(k)
        for order in (k, abs(2 * n - k)) if k > n else (k,):
            part += size * (2 if order < 3 else mp.mpf(1) / (order - 2))
            whole += size * (2 if order < 3 else mp.mpf(2) / (order * (order - 2)))
    rest = 10 * steepness(3 * n, swing) / mp.factorial(3 * n)
    return part + rest, whole + rest


class Energy:
    """The light within a circle over 2 pi, by polynomials on panels that are 2 wide."""

    def __init__(self, light: Light, field: Field, reach: float, step: float, asked: Asked) -> None:
        swing = light.most**2 / 2

        def beside(n: int) -> mp.mpf:
            part, whole = between_points(n, swing)
            return mp.mpf("1.1") * whole + 3 * part / step

        n = fewest(lambda n: bool(beside(n) <= asked.sums))
        self.missed, whole = between_points(n, swing)
        self.panels = math.ceil(reach / 2) + 1
        points = np.polynomial.chebyshev.chebpts1(n)
        radii = 2 * np.arange(self.panels)[:, None] + 1 + points
        u, e = field(radii.ravel(), asked.field)
        intensity = np.abs(u.reshape(radii.shape)) ** 2
        series = np.linalg.solve(np.polynomial.chebyshev.chebvander(points, n - 1), intensity.T).T
        monomials = [np.polynomial.chebyshev.cheb2poly([0] * k + [1]) for k in range(n + 2)]
        sizes = np.array([np.abs(m) @ (2 * np.arange(m.size) + n + 8) for m in monomials])
        between = swing * interpolation(1.0, n)
        self.series, self.begins, self.rates, self.rounding = [], [mp.mpf(0)], [], mp.mpf(0)
        before = 0.0
        for k in range(self.panels):
            moment = np.polynomial.chebyshev.chebmul(series[k], [2 * k + 1, 1])
            energy = np.polynomial.chebyshev.chebint(moment, lbnd=-1, k=before)
            self.series.append(np.pad(energy, (0, n + 2 - energy.size)))
            inside = np.polynomial.chebyshev.chebval(1.0, self.series[-1])
            top, end = float(intensity[k].max()), 2 * k + 2
            evaluated = 4 * end**2 * (lebesgue(n) * top + between) + sizes @ np.abs(self.series[-1])
            self.rounding = max(self.rounding, U * evaluated)
            given = lebesgue(n) * (2 * mp.sqrt(top) * e + e * e)
            self.rates.append(given + U * 2 * n * (n + 8) * top)
            area = (end**2 - (end - 2) ** 2) / 2
            self.begins.append(
                self.begins[-1] + self.rates[-1] * area + end * whole + U * (n + 8) * (before + inside)
            )
            before = inside

    def panel(self, r: Any) -> Any:
        return np.minimum(self.panels - 1, np.asarray(r) // 2).astype(int)

    def within(self, r: np.ndarray) -> np.ndarray:
        k = self.panel(r)
        return np.polynomial.chebyshev.chebval(r - 2 * k - 1, np.array(self.series).T[:, k], tensor=False)

    def part(self, r: float) -> mp.mpf:
        return self.missed * (r + 2)

    def off(self, r: float) -> mp.mpf:
        k = int(self.panel(r))
        return self.begins[k] + self.rates[k] * (mp.mpf(r) ** 2 - 4 * k * k) / 2


def sides(dx: float, dy: float) -> list[tuple[int, float, float]]:
    """Return sign, distance from the axis and start of the four edges of a pixel, in pixels."""
    return [(1, dx + 0.5, dy - 0.5), (-1, dx - 0.5, dy - 0.5), (1, dy + 0.5, dx - 0.5), (-1, dy - 0.5, dx - 0.5)]


def averaged(light: Light, field: Field, window: Window, asked: Asked) -> Averages:
    step, square, swing = window.step, window.step**2, light.most**2 / 2
    high, left = ringless(light, step, asked.rings)
    mean = _core_tests.tail_bounds(*light.pupil, high)["mean"]
    whole = 4 * mp.pi * light.passed / square
    y, x = np.arange(window.height) - window.row, np.arange(window.width) - window.column
    pixels = {(abs(float(across)), abs(float(down))) for down in y for across in x}

    def nearest(dx: float, dy: float) -> float:
        if max(dx, dy) < 0.5:
            return step * (0.5 - max(dx, dy))
        return step * math.hypot(max(0.0, dx - 0.5), max(0.0, dy - 0.5))

    def farthest(dx: float, dy: float) -> float:
        return step * math.hypot(dx + 0.5, dy + 0.5)

    near = [pixel for pixel in pixels if nearest(*pixel) < high]
    tops, rings, error = [], mp.mpf(0), mp.mpf(0)
    for dx, dy in pixels.difference(near):
        # r^-3 is the divergence of -r / r^3.
        flux = sum(
            sign
            * (quad(lambda t, at=at: at / math.hypot(at, t) ** 3, start, start + 1.0, epsabs=0.0)[0] if at else 0.0)
            for sign, at, start in sides(dx, dy)
        )
        tops.append(float(-flux * mean / step**3 + (whole if max(dx, dy) < 0.5 else 0)))
        factor = mean / step**3 / max(1e-3, min(1.0, high / step))
        rings = left + 64 * U * (factor + whole)
    if near:
        reach = max(farthest(*pixel) for pixel in near)
        least = fewest(lambda q: bool(along_edge(step, q, reach, swing) <= asked.sums * square / 4))
        q = 8 * math.ceil(least / 8)
        energy = Energy(light, field, reach, step, asked)
        nodes, weights = np.polynomial.legendre.leggauss(q)
        for dx, dy in near:
            crossed, turn, turns, off = 0.0, 0.0, 0.0, mp.mpf(0)
            for sign, at, start in sides(dx, dy):
                t = start + 0.5 + 0.5 * nodes
                share = 0.5 * weights * at / (at * at + t * t)
                crossed += sign * float(share @ energy.within(step * np.hypot(at, t)))
                turn += sign * share.sum()
                turns += abs(share.sum())
                end = step * math.hypot(at, max(abs(start), abs(start + 1.0)))
                off += abs(share.sum()) * (energy.off(end) + energy.part(end))
            tops.append(crossed / square)
            first, last, part = (
                energy.off(nearest(dx, dy)),
                energy.off(farthest(dx, dy)),
                energy.part(farthest(dx, dy)),
            )
            given = min(off, ((last - first) / 2 + part) * turns + (last + first) * abs(turn) / 2)
            rounded = (energy.rounding + U * (q + 24) * 2 * light.passed) * turns
            error = max(error, (given + rounded + 4 * along_edge(step, q, reach, swing)) / square)
    return Averages(max(0.0, *tops), rings, error)
