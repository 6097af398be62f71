"""Pixel-integrated PSFs at any defocus with a proven error bound, and their windows."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Self

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.core import engine
from lommel.methods.choice import of_large_phases, of_profiles
from lommel.methods.hankel import growth, quadrature_nodes
from lommel.methods.pixel_rule import local_rule, pixel_rule, quarters, sums_of_windows
from lommel.optics.aperture.shapes import Segments
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront

_METHOD = of_profiles(1e-7)
_QUADRATURE = of_large_phases(1e-13)
_LOCAL = 600.0  # half widths in v above which sparse rules are faster than dense ones


@dataclass(frozen=True)
class SensorLight:
    """The pixel-integrated PSF of one channel, as shares of the light of a point, at any defocus."""

    pupil: Pupil  # in focus, radially symmetric, at the wavelength of the lens
    phase: Callable[[Array], Wavefront]
    spectrum: Sequence[tuple[float, float]]
    pixel: float
    threads: int = 0
    rate: Callable[[float], float] | None = None  # as Lens.phase_rate; by default that of a paraxial lens

    @classmethod
    def of(cls, lens: Lens, spectrum: Sequence[tuple[float, float]], pixel: float, threads: int = 0) -> Self:
        """Return the light that a lens of radially symmetric aberrations makes of one channel."""
        pupil = Pupil(
            lens.aberrations,
            obscuration=lens.obscuration,
            wavelength=lens.wavelength,
            f_number=lens.working_f_number,
            apodization=lens.illumination,
            colour=lens.pupil_colour,
        )
        return cls(pupil, lens.phase, spectrum, pixel, threads, lens.phase_rate)

    def defocused(self, defocus: Array) -> Pupil:
        """Return the stack of pupils at values of the defocus C_d, radians at the wavelength of the pupil."""
        return self.pupil.carrying(self.phase(defocus) + self.pupil.wavefront, None)

    def shares(self, pupil: Pupil, half: int) -> Array:
        """Return the share of the light in each pixel of the octant, shape (n, cells), up to `half` pixels."""
        total: Array | float = 0.0
        for wavelength, weight in self.spectrum:
            there = pupil.in_light(wavelength)
            step = math.pi * self.pixel / there.scale
            # I is relative to the peak without aberrations: the share of a pixel is the integral of I over its square
            # in v,
            # over 4 pi times the transmission.
            share = weight * step**2 / (4.0 * math.pi * there.transmission)
            if half * step > _LOCAL:
                local = local_rule(half, step)
                total += share * (local.matrix @ _profiles(there, local.v).T).T
                continue
            rule = pixel_rule(half, step)
            total += share * _METHOD.means(there, step * rule.radii, rule.matrix, self.threads)
        return np.asarray(total)

    def enough(self, defocus: tuple[float, float], energy: float, largest: int) -> tuple[int, Parabola]:
        """Return the half width of windows that hold `energy` of the light, and nearly 1 over their peaks."""
        # Three defocus values determine the parabola.
        ends = np.linspace(*defocus, 3)
        pupil = self.defocused(ends)
        half = math.ceil(float(pupil.geometric_radius().max()) / self.pixel) + 1
        if half > largest:
            raise too_large(largest, energy, pupil, self.spectrum, self.pixel)
        while True:
            shares = self.shares(pupil, half)
            sums = sums_of_windows(shares, half)
            held = float(sums[:, -1].min())
            if held >= energy:
                half = int((sums >= energy).argmax(axis=1).max()) + 1
                return half, Parabola.through(ends, shares.max(axis=1))
            # Beyond the shadow of the aperture the light outside falls as the reciprocal of the distance or faster.
            # The light within a square costs far less than that of each of its pixels.
            likely = (half + 0.5) * (1.0 - held) / (1.0 - energy)
            if half == largest or (likely > largest and (held := self._held(pupil, largest)) < energy):
                raise too_large(largest, energy, pupil, self.spectrum, self.pixel, held)
            # Half widths grow by 30 %: few tries, and little that is computed and not needed.
            half = min(math.ceil(1.3 * half) + 1, largest)

    def _held(self, pupil: Pupil, half: int) -> float:
        """Return the least share of the light that windows hold."""
        from lommel.measures.energy import radial_square_energy  # which few scenes need

        side = np.array((half + 0.5) * self.pixel)
        each = ((weight, pupil.in_light(wavelength)) for wavelength, weight in self.spectrum)
        return float(np.min(sum(weight * radial_square_energy(_METHOD, light, side) for weight, light in each)))


_BLOCKS = 18  # blocks of values of U computed together
_APART = 4  # steps of v from one computed value of U to the next
_TAPS = 28  # values of U that interpolation uses
_DEAR = 8.0  # cost of a value of J0 over that of a term of the series at one radius


def _profiles(pupil: Pupil, v: Array) -> Array:
    """Return I at equally spaced v from 0 on, at most 0.4 apart, for a stack of pupils."""
    terms = pupil.radial_terms()
    low, reach = pupil.obscuration**2, float(v[-1])
    nodes = quadrature_nodes(growth(terms, low, reach, pupil.illumination), _QUADRATURE.tol, low)
    if np.abs(terms).sum() < _DEAR * nodes:
        return _METHOD.profile(pupil, v).values
    # For many pupils of large phases the series takes many times as long as matrix products with values of J0, of
    # which every fourth is enough.
    before, after = _between(_APART * float(v[1]))
    made = np.empty((len(terms), v.size))
    wide = _TAPS * _APART  # values of I that a block makes
    for start in range(0, v.size, _BLOCKS * wide):
        blocks = min(_BLOCKS, -(-(v.size - start) // wide))
        at = start // _APART + np.arange(_TAPS * (blocks + 1)) - (_TAPS // 2 - 1)
        rising, place = np.unique(np.abs(at), return_inverse=True)  # U is even
        field = _QUADRATURE.evaluate(pupil, _APART * v[1] * rising).values[:, place]
        squares = np.zeros(())
        for part in (field.real, field.imag):
            each = np.ascontiguousarray(part).reshape(-1, _TAPS)
            left, right = (
                engine.product(each, taps, 1).reshape(len(terms), blocks + 1, wide) for taps in (before, after)
            )
            here = left[:, :-1]
            here += right[:, 1:]
            here *= here
            squares = squares + here
        made[:, start : start + blocks * wide] = squares.reshape(len(terms), -1)[:, : v.size - start]
    return made


# U is of exponential type 1 in v: with the cardinal series times sinh(b sqrt(1 - (x / m)^2)) / sinh(b), m values on
# either side, h apart, and b = m (pi - h), those between them err by about exp(-b) of the largest. M. Kircheis,
# D. Potts, M. Tasche, "On regularized Shannon sampling formulas with localized sampling", Sampl. Theory Signal
# Process. Data Anal. 20, 20 (2022), doi:10.1007/s43670-022-00039-1.
@lru_cache(maxsize=4)
def _between(spacing: float) -> tuple[Array, Array]:
    """Return the weights of interpolation, of values of U in a block and in the next one; shape (taps, values)."""
    half = _TAPS // 2
    at = half - 1 + np.arange(_TAPS * _APART) / _APART
    x = at - np.arange(2 * _TAPS)[:, None]
    steep = half * (math.pi - spacing)
    inside = np.sqrt(np.maximum(0.0, 1.0 - (x / half) ** 2))
    made = np.sinc(x) * np.sinh(steep * inside) / math.sinh(steep)
    return np.ascontiguousarray(made[:_TAPS]), np.ascontiguousarray(made[_TAPS:])


MAX_HALF = 2048
"""Largest half width of windows that may be allowed, in pixels."""


def too_large(
    largest: int,
    energy: float,
    pupil: Pupil,
    spectrum: Sequence[tuple[float | None, float]],
    pixel: float,
    held: float | None = None,
) -> ValueError:
    """Return the error for too large windows, with a half width that suffices for a stack of pupils."""
    # Beyond the shadow each edge diffracts light whose mean falls as r^-3 from there on: of a round aperture
    # lambda N / (pi^3 r^3), which adds up to 8 sin(pi / 4) / pi^3 lambda N / a outside of a square of the sides 2 a.
    edges = 1.0 + pupil.obscuration + (len(pupil.spider.angles) / math.pi if pupil.spider else 0.0)
    stops = pupil.stop.shapes if isinstance(pupil.stop, Segments) else (pupil.stop,)
    for line in (line for stop in stops if stop is not None for line in stop.outline(256)):
        edges += float(np.hypot(*(line - np.roll(line, 1, axis=0)).T).sum()) / (2.0 * math.pi)
    diffracted = shadow = 0.0
    for wavelength, weight in spectrum:
        light = pupil if wavelength is None else pupil.in_light(wavelength)
        shadow = max(shadow, float(light.geometric_radius().max()))
        diffracted += weight * light.scale * edges / float(np.min(light.transmission))
    # Of the two summands, the geometric shadow and what its edges diffract.
    far = shadow + 1.05 * 8.0 * math.sin(0.25 * math.pi) / math.pi**3 * diffracted / (1.0 - energy)
    enough = max(math.ceil(far / pixel), largest) + 1
    larger = f"allow larger windows (largest={enough} or more), " if enough <= MAX_HALF else ""
    known = "" if held is None else f", of which these hold {math.floor(1e6 * held) / 1e6:g}"
    return ValueError(
        f"the blur takes windows of more than {2 * largest + 1} pixels a side to hold {energy:g} of the light{known}"
        f"; stop down, {larger}or ask for less of it (energy=)"
    )


_ERROR = 1e-9  # bound of the polynomial's error, for windows whose peaks are about 1
_MOST = 20_000  # largest number of Chebyshev nodes


@dataclass(frozen=True)
class Parabola:
    """Parabola ``curvature (C - middle)^2 + least`` in the defocus C, curvature >= 0 and least > 0."""

    curvature: float
    middle: float
    least: float

    @classmethod
    def through(cls, defocus: Array, values: Array) -> Parabola:
        """Return the parabola closest to 1 / `values`, none above 1, at three equally spaced defocus values."""
        step, (before, here, after) = 0.5 * float(defocus[2] - defocus[0]), (1.0 / values).tolist()
        bend = 0.5 * (before + after) - here
        # Almost equal peaks need no parabola, and the division by bend would amplify rounding.
        if not bend > 1e-3 * here:
            return cls(0.0, 0.0, 1.0)
        shift = 0.25 * (after - before) / bend
        return cls(bend / step**2, float(defocus[1]) - shift * step, max(1.0, here - bend * shift**2))

    def __call__(self, defocus: Array) -> Array:
        """Return its values."""
        return self.curvature * (defocus - self.middle) ** 2 + self.least


# The field at a point is the integral over the pupil of A exp(i Phi), A real, and in the complex plane of the
# defocus C I(C) = U(C) conj(U(conj(C))). There Im Phi differs by at most rate |Im C| from one place of the pupil to
# another, so that by the inequality of Cauchy and Schwarz I is at most exp(rate |Im C|) times the light that the
# pupil lets through, and the share in a pixel at most `bound` as much. Let M be the largest of that on the ellipse
# with the foci -1 and 1 (the ends of the range) and semi-axes that sum up to rho: a polynomial through n nodes errs
# by at most 4 M rho^(1 - n) / (rho - 1) (Trefethen, Approximation Theory and Approximation Practice, 2013, Theorem
# 8.2). Little more than rate times half of the range are enough. Errors of the windows at the nodes themselves grow
# by a factor of at most 1 + 2 log(n) / pi. The peak of a defocused point is a small part of that of one in focus,
# and errors are to be small beside either: so the polynomial is through the windows times a parabola, nearly that of
# 1 over their peaks, and is divided by it.
@dataclass(frozen=True)
class DefocusNodes:
    """Windows at any defocus of a range, as Chebyshev polynomials with an error bound."""

    low: float
    high: float
    parabola: Parabola  # factor of the windows
    coefficients: Array  # (n, cells): of the Chebyshev polynomials, for these windows
    threads: int = 0

    @classmethod
    def of(
        cls,
        windows: Callable[[Array], Array],
        low: float,
        high: float,
        parabola: Parabola,
        *,
        rate: Callable[[float], float],
        bound: float,
        threads: int = 0,
    ) -> DefocusNodes:
        """Compute as many windows as the bound asks for, with its `rate` for C up to a distance, and its `bound`."""
        middle, reach = 0.5 * (low + high), 0.5 * (high - low)
        axis = np.geomspace(1e-3, max(1.0, 20.0 / reach), 200)  # beyond the foci
        # rho = sum of the semi-axes of the ellipse with foci -1 and 1 whose major semi-axis is 1 + axis.
        rho = 1.0 + axis + np.sqrt(axis * (axis + 2.0))
        beyond = reach * (1.0 + float(axis[-1]))
        fastest = rate(abs(middle) + beyond)
        # |Im C| is at most the minor semi-axis, (rho - 1 / rho) / 2, times half of the range.
        growth = fastest * reach * 0.5 * (rho - 1.0 / rho)
        most = parabola.curvature * (abs(middle - parabola.middle) + beyond) ** 2 + parabola.least
        # Solved for n: 4 M rho^(1 - n) / (rho - 1) = _ERROR, at the rho that needs the fewest nodes.
        count = float((1.0 + (np.log(4.0 * bound * most / (_ERROR * (rho - 1.0))) + growth) / np.log(rho)).min())
        if not count <= _MOST:
            raise ValueError(
                f"depth spans C_d from {low:.4g} to {high:.4g} rad, which takes {count:.4g} PSFs, more than {_MOST}"
            )
        # Angles are odd multiples of half of pi / n, and their cosines come again and again.
        odd = 2 * np.arange(math.ceil(count)) + 1
        cosines = np.cos(np.arange(4 * odd.size) * (0.5 * math.pi / odd.size))
        transform = cosines[np.outer(np.arange(odd.size), odd) % cosines.size] * (2.0 / odd.size)
        # The Chebyshev coefficient of order 0 is the mean, half of the formula of the others.
        transform[0] *= 0.5
        at = middle + reach * cosines[odd]
        return cls(
            low, high, parabola, engine.product(transform, parabola(at)[:, None] * windows(at), threads), threads
        )

    def __call__(self, defocus: Array) -> tuple[Array, float]:
        """Return the windows at values of the defocus, and a bound on their errors over their peaks."""
        made = self.values(defocus)
        return made, _ERROR / float((self.parabola(defocus) * made.max(axis=1)).min())

    def values(self, defocus: Array) -> Array:
        """Return the windows at values of the defocus."""
        # Chebyshev polynomials are T_n(x) = cos(n arccos x); rounding may place x beyond 1.
        angle = np.arccos(np.clip((2.0 * defocus - self.low - self.high) / (self.high - self.low), -1.0, 1.0))
        basis = _cosines(angle, len(self.coefficients))
        basis /= self.parabola(defocus)
        return engine.product(np.ascontiguousarray(basis.T), self.coefficients, self.threads)

    def of_first(self, cells: int) -> Self:
        """Return the interpolation of the first pixels only."""
        return replace(self, coefficients=np.ascontiguousarray(self.coefficients[:, :cells]))

    def sums(self, weights: Array) -> Self:
        """Return the interpolation of sums over the last pixels times weights, shape (sums, pixels)."""
        last = self.coefficients[:, self.coefficients.shape[1] - weights.shape[1] :]
        return replace(self, coefficients=np.ascontiguousarray(last @ weights.T))


def _cosines(angle: Array, count: int) -> Array:
    """Return cos(k angle) for k < count, shape (count, n)."""
    # Powers of exp(i angle) by doubling: each is a product of two, which loses an ulp.
    powers = np.empty((count, angle.size), dtype=np.complex128)
    powers[0], known = 1.0, 1
    if count > 1:
        powers[1], known = np.exp(1j * angle), 2
    while known < count:
        more = min(known - 1, count - known)
        np.multiply(powers[1 : more + 1], powers[known - 1], out=powers[known : known + more])
        known += more
    return np.ascontiguousarray(powers.real)


# A window that reaches h pixels from the middle, a real number, uses of the ring at the Chebyshev distance k the
# share h + 1 - k, from 0 to 1, averaged over the neighbouring windows, so that nothing jumps as a point moves.
def find_cuts(octants: Array, half: int, energy: float) -> Array:
    """Return the reach h of each window, so that it, and those interpolated from it and the next, hold `energy`."""
    sums = sums_of_windows(octants, half)
    enough = sums >= np.clip(energy, sums[:, :1], sums[:, -1:])
    rows, outer = np.arange(len(sums)), enough.argmax(axis=1)
    ring = sums[rows, outer] - sums[rows, outer - 1]
    over = np.maximum(0.0, sums[rows, outer] - energy)
    own = outer - np.divide(over, ring, out=np.zeros(len(sums)), where=outer > 0)
    # What the neighbours take counts: those between are to hold enough as well.
    return of_neighbours(own)


def of_neighbours(values: Array) -> Array:
    """Return the largest of each value or row and its two neighbours."""
    padded = np.concatenate([values[:1], values, values[-1:]])
    return np.asarray(np.maximum(np.maximum(padded[:-2], padded[2:]), values))


def ring_shares(cuts: Array, half: int) -> Array:
    """Return the share used of each ring of pixels, 0 to 1, the mean over neighbours: 1/6, 2/3, 1/6."""
    padded, away = np.pad(cuts, 1, mode="edge"), np.arange(half + 1)
    ring = np.clip(padded[:, None] + 1.0 - away, 0.0, 1.0)
    return np.asarray((ring[:-2] + 4.0 * ring[1:-1] + ring[2:]) / 6.0)


def shares_used(cuts: Array, half: int) -> Array:
    """Return the share used of each pixel, 0 to 1, from the middle row and column on."""
    away = np.arange(half + 1)
    return ring_shares(cuts, half)[:, np.maximum(away[:, None], away)]


def cut(octants: Array, cuts: Array) -> Array:
    """Return windows cut at their reach, from the middle row down and the middle column on."""
    used = math.ceil(cuts.max())
    return np.asarray(quarters(octants, used) * shares_used(cuts, used))


def sums_of_quarters(quarter: Values) -> Array:
    """Return the sums of windows that are given from the middle row down and the middle column on."""
    # Rows and columns away from the middle stand for two each.
    down, across = (np.where(np.arange(side) == 0, 1.0, 2.0) for side in quarter.shape[1:])
    return np.asarray(quarter @ across @ down)
