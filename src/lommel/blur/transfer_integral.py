"""Images of radial pupils through isotropic blur, from the product of both transfer functions.

``e(v) = (8 / pi) int O(f) T(f) J0(2 f v) f df``, f over the cutoff, O the autocorrelation of the pupil function and T
the transfer function of the blur, which for seeing ends early: a few hundred nodes in place of a lattice as wide as
the halo. What is left out is bounded (docs/certificate.md, section 17).

Transfer function of isotropic blur in the complex plane, and how much of it is left beyond a frequency.
Frequencies f are over the cutoff of the optics, ``f = F x^3``: in x Kolmogorov's ``f^(5/3)`` and von Karman's
structure function are entire (docs/certificate.md, section 17). A disc of x is given by its centre and radius.

Autocorrelation of radial pupils at frequencies of a rule, with proven bounds on all that is left out.
With f over the cutoff and pupil coordinates over the radius of the aperture, ``O(f) = int P(r - f) conj(P(r + f))``
is an integral over a lens of two discs of radius 1, less twice one over the disc of an obscuration, plus one over a
lens of two such discs. Every rule is of Gauss and Legendre but for the azimuth of a disc, and errs by what the
integrand is at most where one variable is complex (docs/certificate.md, section 17).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.blur.blurs import KOLMOGOROV, Blur, Jitter, Seeing, karman
from lommel.core.answers import Declined, Intensities, not_met
from lommel.methods.method import RadialMethod
from lommel.optics.aperture.apodization import Apodization
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre

_NU = 5.0 / 6.0
_NEAR = 4.0  # abs(z) up to which the series of z^nu K_nu(z) is summed
_TERMS = 30
_STEPS: Array = 1.01 ** np.arange(-1600.0, 1.0)  # rising frequencies over the cutoff, 1e-7 to 1
FURTHER: Array = 1.01 ** np.arange(-1600.0, 141.0)
"""Frequencies up to 4 times the cutoff."""


class Karman(NamedTuple):
    """Half of von Karman's structure function, ``size (limit - z^nu K_nu(z))``, ``z = rate f``."""

    size: float
    rate: float

    def least(self, z: NDArray[np.complex128], power: NDArray[np.complex128], wide: Array) -> Array:
        # Certificate, section 17, "Over frequencies": by the series up to abs(z) = 4, by the real part of z beyond.
        """Bound its real part from below on discs of x; `power` is ``z^(5/3)``, `wide` the largest abs(z)."""
        far = self.size * math.gamma(_NU) * 2.0 ** (_NU - 1.0)
        inside = np.minimum(wide, _NEAR)
        with np.errstate(over="ignore", invalid="ignore"):
            # Between centre and rim of a disc the series changes by at most the difference of its sums of moduli.
            at = self._series(z, power, -1.0).real
            grown = self._series(inside, inside ** (5.0 / 3.0), 1.0) - self._series(
                np.abs(z), np.abs(z) ** (5.0 / 3.0), 1.0
            )
            near = np.where(wide <= _NEAR, at - grown.real, -np.inf)
            # abs(K(z)) <= K(Re z), and y^nu K_nu(y) falls.
            right = z.real - (wide - np.abs(z))
            ratio = np.divide(wide, right, out=np.full(wide.shape, np.inf), where=right > 0.0)
            return np.asarray(np.maximum(near, far * (1.0 - ratio**_NU)))

    def _series(self, z: NDArray[np.generic], power: NDArray[np.generic], sign: float) -> NDArray[np.complex128]:
        square = 0.25 * np.where(np.abs(z) <= _NEAR, z, 0.0) ** 2
        rising, even = _coefficients()
        # Horner's rule in z^2 / 4, both series at once.
        first, second = np.zeros(square.shape, complex), np.zeros(square.shape, complex)
        for a, b in zip(rising[::-1], even[::-1], strict=True):
            first, second = first * square + a, second * square + b
        return np.asarray(self.size * (2.0**-_NU * power * first + sign * 2.0**_NU * second))


@lru_cache(maxsize=1)
def _coefficients() -> tuple[Array, Array]:
    k, factor = np.arange(_TERMS), 0.5 * math.pi / math.sin(math.pi * _NU)
    gamma = scipy.special.gamma
    even = factor / (gamma(k + 1.0) * gamma(k + 1.0 - _NU))
    # The first term of the even series is the limit, which the structure function does not have.
    even[0] = 0.0
    return factor / (gamma(k + 1.0) * gamma(k + 1.0 + _NU)), even


class Fading(NamedTuple):
    """Isotropic blur at frequencies over the cutoff: ``exp(-kolmogorov f^(5/3) - gauss f^2 - von Karman's)``."""

    several: tuple[Blur, ...]
    scale: float
    wavelength: float | None
    kolmogorov: float
    gauss: float
    karman: tuple[Karman, ...]

    @classmethod
    def of(cls, several: tuple[Blur, ...], scale: float, wavelength: float | None) -> Fading | None:
        """Return the Fading of several blurs, None where they depend on the direction; `scale` is one lambda*N."""
        kolmogorov = gauss = 0.0
        outer = []
        for blur in several:
            if not blur.isotropic:
                return None
            gauss += 2.0 * math.pi**2 * float(blur.covariance[0, 0]) / scale**2
            if not isinstance(blur, Seeing):
                continue
            at = blur.coherence(wavelength) * scale
            if blur.outer_scale is None:
                kolmogorov += KOLMOGOROV * at ** (-5.0 / 3.0)
            else:
                size, rate = karman(blur, wavelength)
                outer.append(Karman(size, rate / at))
        return cls(several, scale, wavelength, kolmogorov, gauss, tuple(outer))

    @classmethod
    def above(cls, several: tuple[Blur, ...], scale: float, wavelength: float | None) -> Fading:
        """Return isotropic blur with a transfer function nowhere below the modulus of that of several blurs."""
        covariance = sum((blur.covariance for blur in several), np.zeros((2, 2)))
        # exp(-w.C w / 2) is at most that of the least eigenvalue of C; streaks, abs(sinc) <= 1, are left out.
        least = max(float(np.linalg.eigvalsh(covariance)[0]) - 1e-12 * float(np.trace(covariance)), 0.0)
        air = (blur for blur in several if isinstance(blur, Seeing))
        found = cls.of((*air, Jitter(math.sqrt(least))), scale, wavelength)
        assert found is not None
        return found

    def at(self, f: Array) -> Array:
        """Return the transfer function."""
        found = np.ones(f.shape)
        for blur in self.several:
            found *= blur.transfer(f / self.scale, wavelength=self.wavelength)
        return found

    def log_bound(self, x: NDArray[np.complex128], radius: Array, end: float) -> Array:
        """Bound the logarithm of its modulus on discs of x, where ``f = end x^3``."""
        size = np.abs(x)
        # Re x^5 at the centre less the largest change to the rim, w^5 - s^5, bounds it on the disc from below.
        wide = size + radius
        fifth = x**5
        found = -self.kolmogorov * end ** (5.0 / 3.0) * (fifth.real - (wide**5 - size**5))
        found -= self.gauss * end**2 * ((x**6).real - (wide**6 - size**6))
        for one in self.karman:
            z = one.rate * end
            found -= one.least(z * x**3, z ** (5.0 / 3.0) * fifth, z * wide**3)
        return np.asarray(found)

    def remaining(self, steps: Array = _STEPS) -> Array:
        """Bound ``int T f df`` from each of rising frequencies to the last, T falling."""
        # Sums at the left ends of steps: T falls, so that they are upper sums.
        pieces = 0.5 * self.at(steps[:-1]) * (steps[1:] ** 2 - steps[:-1] ** 2)
        return np.append(np.cumsum(pieces[::-1])[::-1], 0.0)

    @property
    def light(self) -> float:
        """Bound on ``int T f df`` from 0 to 1."""
        # T <= 1 below the first step.
        return float(self.remaining()[0] + 0.5 * _STEPS[0] ** 2)

    def end(self, left: float, steps: Array = _STEPS) -> tuple[float, float]:
        """Return the first step beyond which ``int T f df`` is at most `left`, and that integral's bound."""
        remaining = self.remaining(steps)
        first = int(np.argmax(remaining <= left))
        return float(steps[first]), float(remaining[first])


ETAS = np.geomspace(0.02, 6.0, 40)
"""Logarithms of the sums of the semi-axes of ellipses that are tried."""
_VALUES_AT_ONCE = 2**20  # pupil values
_U = 2.0**-53


class Slopes(NamedTuple):
    """Largest slopes of phase and amplitude of a stack of radial pupils, at complex places."""

    terms: tuple[float, ...]  # moduli of the coefficients of P_0, P_1, ... in 2t - 1, the largest of the stack
    light: Apodization

    @classmethod
    def of(cls, pupil: Pupil) -> Slopes:
        """Return those of a stack."""
        return cls((0.0, *np.abs(pupil.radial_terms()).max(axis=0).tolist()), pupil.illumination)

    def at(self, far: Array) -> tuple[Array, Array, Array]:
        """Bound gradient, second derivatives and log amplitude at complex places up to `far` from the unit disc."""
        legval, legder = np.polynomial.legendre.legval, np.polynomial.legendre.legder
        # t = r.r is within 2 far + far^2 of [0, 1]; on an ellipse P_n and derivatives are largest at the right end.
        t = far * (2.0 + far)
        first, second = (legval(1.0 + 2.0 * t, legder(self.terms, k)) for k in (1, 2))
        # Derivatives by t: P_n has the argument 2 t - 1. By r, dt = 2 r dr.
        first, second = 2.0 * first, 4.0 * second
        gradient = 2.0 * (1.0 + far) * first
        growth = np.zeros(np.shape(far)) if self.light.uniform else self.light.growth(1.0 + 2.0 * t)
        return gradient, 2.0 * first + 4.0 * (1.0 + far) ** 2 * second, growth


def gauss_nodes(log_size: Array, allowed: Array, etas: Array = ETAS) -> Array:
    """Return the number of Gauss nodes that keep a mean within `allowed`; `log_size`: log of M on each ellipse."""
    # Exact up to the degree 2 n - 1, with positive weights: off by at most 4 M rho^(1 - 2 n) / (rho - 1).
    log = np.where(np.isfinite(log_size), log_size, np.inf)
    needed = 0.5 + 0.5 * (math.log(4.0) + log - np.log(np.expm1(etas)) - np.log(allowed)[..., None]) / etas
    return np.asarray(np.maximum(np.ceil(needed.min(axis=-1)), 2.0))


class Part(NamedTuple):
    """One of the integrals whose sum is the autocorrelation, for f from 0 to `end`."""

    kind: str  # "lens" of two discs of a radius, or "disc": within the obscuration of one, anywhere in the other
    radius: float
    end: float

    def log_bound(self, slopes: Slopes, far: Array, off: Array) -> Array:
        """Bound the logarithm of its modulus at frequencies at most `off` from the real ones up to `far`."""
        # Only the place r + 2 f in the other pupil moves with f, twice as far: q' = 2 in the table of section 17.
        if self.kind == "disc":
            gradient, _, growth = slopes.at(2.0 * off)
            return np.asarray(math.log(2.0 * math.pi * self.radius**2) + off * 2.0 * gradient + growth)
        ratio = (far + off) / self.radius
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            root = 1.0 / np.sqrt(np.maximum(1.0 - ratio**2, 0.0))
            # A = (1 - (f / a + delta)^2)^(-1/2) and d = A delta of the table's third row.
            turn = root * off / self.radius
            cosh = np.cosh(np.minimum(turn, 300.0))
            moved = np.hypot(cosh * root + 1.0, cosh * root)
            gradient, second, growth = slopes.at((moved + 1.0) * off)
            swing = off * (2.0 * (far + off) * second * moved + 2.0 * gradient)
            size = 4.0 * self.radius**2 * (0.5 * math.pi + turn) * cosh * (cosh + ratio)
            found = np.log(size) + swing + 2.0 * growth
        return np.where((ratio < 1.0) & np.isfinite(found), found, np.inf)

    def counts(self, slopes: Slopes, low: float, high: float, allowed: float) -> tuple[int, int]:
        """Return the numbers of nodes along both coordinates for an error of `allowed`, f from `low` to `high`."""
        a, sinh = self.radius, np.sinh(ETAS)
        if self.kind == "disc":
            return self._disc_counts(slopes, high, 0.25 * allowed / (2.0 * math.pi * a * a))
        # f c = f (1 - f / a), c the longest half of a chord of the lens, is largest at f = a / 2.
        middle = min(max(0.5 * a, low), high)
        product = middle * (a - middle)
        with np.errstate(over="ignore", invalid="ignore"):
            _, second, growth = slopes.at((a - low) * sinh)
            # Half of `allowed` for either coordinate, over the area that the mean is multiplied by.
            along = gauss_nodes(
                sinh * 2.0 * product * second + 2.0 * growth,
                np.array(0.5 * allowed / (2 * math.pi * a * a)),
            )
            opening = math.acos(min(low / a, 1.0))
            # theta = tau arccos(f / a): an ellipse in tau is one in theta times half of the opening.
            turn = 0.5 * opening * sinh
            cosh, long = np.cosh(turn), np.sqrt(np.cosh(2.0 * turn))
            _, second, growth = slopes.at(a * turn * long)
            log = np.log(cosh * (cosh + 1.0)) + turn * 2.0 * high * second * a * long + 2.0 * growth
            around = gauss_nodes(log, np.array(0.5 * allowed / (4.0 * a * a * max(opening, 1e-9))))
        return int(along), int(around)

    def _disc_counts(self, slopes: Slopes, high: float, allowed: float) -> tuple[int, int]:
        eps, sinh = self.radius, np.sinh(ETAS)
        with np.errstate(over="ignore", invalid="ignore"):
            d = 0.5 * sinh
            _, second, growth = slopes.at(eps * d)
            log = d * 2.0 * high * second * eps + 2.0 * growth + np.log1p(d)
            along = gauss_nodes(log, np.array(allowed))
            long = np.sqrt(np.cosh(2.0 * ETAS))
            _, second, growth = slopes.at(eps * ETAS * long)
            log = ETAS * 2.0 * high * second * eps * long + 2.0 * growth
            # Equal steps: 2 M / (e^(n b) - 1).
            log = np.where(np.isfinite(log), log, np.inf)
            around = (np.log(2.0) + log - math.log(2.0 * min(allowed, 0.05)) + 0.1) / ETAS
        return int(along), 2 * max(1, math.ceil(0.5 * float(around.min())))

    def at(self, pupil: Pupil, f: Array, counts: tuple[int, int]) -> Array:
        """Return the integral at frequencies `f` for the flattened stack, shape ``(n, len(f))``."""
        along, across, weight = self._nodes(counts)
        out = np.empty((math.prod(pupil.shape), f.size))
        many = max(1, _VALUES_AT_ONCE // (len(out) * weight.size))
        for start in range(0, f.size, many):
            some = f[start : start + many, None]
            s, t, share = self._places(some, along, across, weight)
            out[:, start : start + many] = np.einsum("nfk,fk->nf", _product(pupil, s, t), share)
        return out

    def _nodes(self, counts: tuple[int, int]) -> tuple[Array, Array, Array]:
        """Return both coordinates of all nodes, flattened, and their weights."""
        x, w = gauss_legendre(counts[0], -1.0, 1.0) if self.kind == "lens" else gauss_legendre(counts[0])
        if self.kind == "lens":
            y, v = gauss_legendre(counts[1])
        else:
            half = counts[1] // 2  # the integrand is even in the azimuth
            y, v = math.pi / half * (np.arange(float(half)) + 0.5), np.full(half, 1.0 / half)
        grid = np.broadcast_arrays(x[:, None], y)
        return grid[0].ravel(), grid[1].ravel(), np.multiply.outer(w, v).ravel()

    def _places(self, f: Array, along: Array, across: Array, weight: Array) -> tuple[Array, Array, Array]:
        """Return rho^2 in both pupils, and weights: arrays (frequencies, nodes)."""
        a = self.radius
        if self.kind == "disc":
            x, y2 = a * along * np.cos(across), (a * along * np.sin(across)) ** 2
            # Minus twice the disc of the obscuration of one pupil within the other: -2 times 2 pi a^2.
            share = -4.0 * math.pi * a * a * along * weight  # one of either pupil
            first = np.broadcast_to(x * x + y2, (f.size, x.size))
            return first, (x + 2.0 * f) ** 2 + y2, np.broadcast_to(share, first.shape)
        ratio = f / a
        # arccos(ratio) by half the angle, without loss near ratio = 1.
        opening = 2.0 * np.arcsin(np.sqrt(np.maximum(0.5 * (1.0 - ratio), 0.0)))
        angle = opening * across
        cos = np.cos(angle)
        # cos(angle) - cos(opening), without loss near the end.
        half = 2.0 * np.sin(0.5 * (opening + angle)) * np.sin(0.5 * (opening - angle))
        x, y2 = along * half, np.sin(angle) ** 2
        share = 2.0 * a * a * opening * cos * half * weight
        return a * a * ((x - ratio) ** 2 + y2), a * a * ((x + ratio) ** 2 + y2), share


def _product(pupil: Pupil, s: Array, t: Array) -> Array:
    """Return the real part of ``P(s) conj(P(t))``, s and t being rho^2; the imaginary one is odd."""
    terms, light = pupil.radial_terms(), pupil.illumination
    if not terms.any():
        product = np.ones((len(terms), *s.shape))
    else:
        product = np.cos(zernike.legendre_sum(terms, 2.0 * s - 1.0) - zernike.legendre_sum(terms, 2.0 * t - 1.0))
    if not light.uniform:
        product *= np.exp(-(light.exponent_at(s) + light.exponent_at(t)))
    return np.asarray(product)


def parts(pupil: Pupil) -> list[Part]:
    """Return the integrals whose sum is the autocorrelation of a radial pupil."""
    eps = pupil.obscuration
    if eps == 0.0:
        return [Part("lens", 1.0, 1.0)]
    return [Part("lens", 1.0, 1.0), Part("disc", eps, 0.5 * (1.0 - eps)), Part("lens", eps, eps)]


def rounding(pupil: Pupil, nodes: int) -> float:
    """Bound the rounding errors of an autocorrelation in double precision, over the light."""
    terms = np.abs(pupil.radial_terms())
    size, slope = float(terms.sum(axis=1).max()), float(pupil.illumination.slope)
    return float(_U * (4.0 * (terms.shape[1] + 10.0) * size + 6.0 * slope + nodes + 60.0))


_ARCS = 64  # discs that cover half of an ellipse
_PHASE = 40.0  # radians of J0 in a panel, about
_MANY_RADII = 1000  # distinct radii above which pixels are averaged from a table
_AT_ONCE = 2**21
_TRIES = 6
_ETAS = ETAS[(ETAS > 0.1) & (ETAS < 3.0)]


class Panel(NamedTuple):
    """Nodes of one part of the autocorrelation over a range of f (over the cutoff), with inner numbers of nodes."""

    part: Part
    f: Array
    weight: Array  # of (8 / pi) T f df
    counts: tuple[int, int]


class Rule(NamedTuple):
    """Panels, a bound on what they leave out, the frequency that they end at, and ``int T f df`` beyond."""

    panels: tuple[Panel, ...]
    error: float
    end: float
    left: float


@lru_cache(maxsize=16)
def rule(fading: Fading, of: tuple[Part, ...], slopes: Slopes, left: float, v: float, allowed: float) -> Rule:
    """Return the rule for radii up to `v` that errs by `allowed` below the frequency beyond which `left` remains."""
    end, left = fading.end(left)
    if any(part.kind == "disc" and part.end < end for part in of):
        # Beyond it the disc of the obscuration leaves the other pupil's annulus, and the integrand has edges.
        raise Declined("an obscuration has no proven rule where blur ends beyond (1 - obscuration) / 2 of the cutoff")
    # A quarter for the nodes within each part, 0.65 for those over f, a tenth for the end of a lens: below 1.
    share, panels, error = allowed / len(of), [], 0.0
    own = 0.25 * share * math.pi / (8.0 * fading.light)
    turning = v + 2.0 * float(slopes.at(np.zeros(1))[0][0])
    for part in of:
        edges, missing = _edges(part, min(end, part.end), turning, 0.1 * share)
        error += missing
        for f, weight, low, high in _panels(fading, part, slopes, edges, v, 0.65 * share):
            panels.append(Panel(part, f, weight, part.counts(slopes, low, high, own)))
    return Rule(tuple(panels), error + 0.9 * allowed, end, left)


def _edges(part: Part, end: float, turning: float, allowed: float) -> tuple[Array, float]:
    """Return the edges of panels in f, and a bound on the integral beyond the last."""
    missing = 0.0
    close = end > 0.7 * part.end and part.kind == "lens"
    if close and end > part.end * (
        1.0 - (least := 2.0 ** math.floor(0.4 * math.log2(allowed / 15.0 / part.radius**4)))
    ):
        # Near f = a a lens is below 4 sqrt(2) a^2 (1 - f / a)^(3/2): certificate, section 17.
        end, missing = part.end * (1.0 - least), 32.0 * math.sqrt(2.0) / math.pi * part.radius**4 * least**2.5
    edges = np.linspace(0.0, end, max(2, math.ceil(end * 2.0 * turning / _PHASE)) + 1)
    if close:
        # Panels halve towards the branch point f = a, none longer than its distance from it.
        finer = part.end * (1.0 - 0.5 ** np.arange(0.0, 60.0))
        edges = np.unique(np.concatenate([edges, finer[(finer > 0.0) & (finer < end)]]))
    return edges, missing


def _panels(
    fading: Fading, part: Part, slopes: Slopes, edges: Array, v: float, allowed: float
) -> Iterator[tuple[Array, Array, float, float]]:
    """Yield nodes, weights and ends of panels that together err by at most `allowed`."""
    end = float(edges[-1])
    # In x = (f / F)^(1/3), in which Kolmogorov's f^(5/3) is entire.
    ends = np.cbrt(edges / end)
    wide = np.diff(ends)
    # Discs around 64 points of half of each ellipse cover it; the other half is its mirror image.
    angle = math.pi / _ARCS * (np.arange(_ARCS) + 0.5)
    half, eta = 0.5 * wide[:, None, None], _ETAS[:, None]
    middle: NDArray[np.complex128] = (ends[:-1, None, None] + half).astype(np.complex128)
    x = middle + half * np.cosh(eta + 1j * angle)
    radius = np.broadcast_to(half * np.cosh(eta) * (0.5 * math.pi / _ARCS), x.shape)
    size = np.abs(x)
    f, around = end * x**3, end * ((size + radius) ** 3 - size**3)
    far = edges[1:, None, None]
    off = np.abs(f - np.clip(f.real, 0.0, far)) + around
    with np.errstate(over="ignore", invalid="ignore"):
        log = fading.log_bound(x, radius, end) + part.log_bound(slopes, far, off)
        # abs(J0(2 f v)) <= exp(2 v abs(Im f)), and 24 / pi end^2 x^5 is (8 / pi) f df/dx.
        log += 2.0 * v * (np.abs(f.imag) + around) + np.log(24.0 / math.pi * end**2 * (size + radius) ** 5)
    log = np.where(np.isnan(log), np.inf, log).max(axis=-1)
    counts = gauss_nodes(log, allowed / len(wide) / wide, _ETAS)
    for k, count in enumerate(counts.astype(int)):
        at, weight = gauss_legendre(int(count), float(ends[k]), float(ends[k + 1]))
        f_at = end * at**3
        yield f_at, 24.0 / math.pi * end**2 * at**5 * weight * fading.at(f_at), float(edges[k]), float(edges[k + 1])


class Summed(NamedTuple):
    """Sum of ``terms J0(2 f v)`` for a flattened stack, valid for radii v up to `far`."""

    f: Array
    terms: Array  # (n, len(f))
    far: float
    allowed: float
    error: float  # bound on the error of the rule below its end
    left: float  # bound on int T f df beyond its end
    rounded: float  # bound on the relative rounding errors of the terms

    @classmethod
    def of(cls, made: Rule, pupil: Pupil, far: float, allowed: float) -> Summed:
        """Return that of a stack by a rule."""
        f = np.concatenate([panel.f for panel in made.panels])
        terms = [panel.part.at(pupil, panel.f, panel.counts) * panel.weight for panel in made.panels]
        own = max(rounding(pupil, math.prod(panel.counts)) for panel in made.panels)
        return cls(f, np.concatenate(terms, axis=1), far, allowed, made.error, made.left, own)

    @property
    def size(self) -> float:
        """Largest sum of the moduli of the terms."""
        return float(np.abs(self.terms).sum(axis=1).max())

    def rounding(self, v: float) -> float:
        """Bound the rounding error of a sum at radii up to v, over :attr:`size`."""
        return self.rounded + _U * (self.f.size + 60.0 + 4.0 * float(self.f.max()) * v)

    def at(self, v: Array) -> Array:
        """Return the sums at radii v, shape ``(n, len(v))``."""
        values = np.empty((len(self.terms), v.size))
        many = max(1, _AT_ONCE // self.f.size)
        for start in range(0, v.size, many):
            some = slice(start, start + many)
            values[:, some] = self.terms @ scipy.special.j0(np.multiply.outer(2.0 * self.f, v[some]))
        return values


@dataclass(frozen=True)
class TransferIntegral(RadialMethod[Pupil]):
    """Blurred images of radial pupils by quadrature over the product of transfer functions, to `tol` of the peak."""

    tol: float = 1e-6
    blur: tuple[Blur, ...] = ()
    # The last sum of each pupil, from which further radii of the same image are computed.
    kept: dict[int, tuple[Pupil, Summed]] = field(default_factory=dict, init=True, repr=False, compare=False)

    apodized = True

    def fading(self, pupil: Pupil) -> Fading:
        """Return the blur in the light of a pupil; Declined where it depends on the direction."""
        found = Fading.of(self.blur, pupil.scale, pupil.wavelength)
        if found is None:
            raise Declined("blur depends on the direction")
        return found

    def _ceiling(self, pupil: Pupil) -> float:
        """Return an upper bound on the image."""
        # The quadrature may exceed the image by its error.
        return (1.0 + 2.0 * self.tol) * min(pupil.amplitude**2, 8.0 * pupil.transmission * self.fading(pupil).light)

    def _likely_peak(self, pupil: Pupil) -> float:
        """Estimate the lowest peak: the light spread over the sum of the areas of diffraction and blur."""
        light = pupil.transmission
        return light / (light / pupil.likely_peak + 1.0 / (8.0 * self.fading(pupil).light))

    def stretch(self, pupil: Pupil) -> float:
        """Return the bandwidth of the image over that of the optics."""
        end, _ = self.fading(pupil).end(self._left(pupil))
        return end

    def seconds(self, pupil: Pupil, grid: Grid) -> float:
        """Estimate the time of images on a `grid`."""
        end, (gradient, second, _) = self.stretch(pupil), Slopes.of(pupil).at(np.zeros(1))
        panels = max(2.0, end * (grid.reach(pupil) + 2.0 * float(gradient[0])) / 20.0) + (12.0 if end > 0.7 else 0.0)
        nodes = (3.0 + 1.2 * min(end, 0.5) * (1.0 - min(end, 0.5)) * second[0]) * (8.0 + 0.6 * end * second[0])
        radii = min(grid.height * grid.width / 8.0, _MANY_RADII)
        sums = 6e-8 * float(nodes) * math.prod(pupil.shape) + 3e-8 * radii
        return 2e-3 + panels * (4e-4 + 25.0 * sums)

    def _left(self, pupil: Pupil) -> float:
        return 0.02 * self.tol * self._likely_peak(pupil) / (8.0 * pupil.transmission)

    def intensity(self, pupil: Pupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return the image at the distinct radii of `grid`, or on its pixels where there are very many or none."""
        if not grid.symmetric or grid.radii.size > _MANY_RADII:
            return self.on_pixels(pupil, grid, threads)
        made = self.profile(pupil, grid.v(pupil))
        # Clamp to 0: an intensity is not negative, and clamping does not increase the error.
        return made._replace(values=np.maximum(made.values, 0.0))

    def profile(self, pupil: Pupil, v: Array) -> Intensities:
        """Return the image at rising v for the flattened stack, with a bound on its error over its peak."""
        fading = self.fading(pupil)
        allowed = 0.12 * self.tol * self._likely_peak(pupil)
        # The peak may lie between the axis and the last geometric ray, beside the requested radii.
        near = np.linspace(0.0, float(pupil.v(pupil.geometric_radius()).max()) + 4.0, 9)
        places = np.concatenate([v, near])
        far = float(places.max())
        # Each try reduces what is allowed by half of the excess; a power of two lets similar tolerances share a rule.
        for _ in range(_TRIES):
            summed = self._summed(pupil, fading, far, 2.0 ** math.floor(math.log2(allowed)))
            values, size = summed.at(places), summed.size
            left_out = pupil.left_out[0] + 2.0 * pupil.left_out[1]
            # abs(O(f)) <= O(0) = pi tau: beyond the end at most 8 tau int T f df.
            off = summed.error + 8.0 * pupil.transmission * summed.left
            off += size * (left_out * (2.0 + left_out) + summed.rounding(far))
            peak = values.max(axis=1) - off
            relative = np.divide(off, peak, out=np.full(peak.shape, np.inf), where=peak > 0.0)
            if relative.max() <= self.tol:
                break
            allowed *= 0.5 * max(self.tol / float(relative.max()), 1e-4)
        else:
            raise not_met(self.tol, float(relative.max()), "the peak")
        return Intensities(values[:, : v.size], relative, peak)

    def _summed(self, pupil: Pupil, fading: Fading, far: float, allowed: float) -> Summed:
        """Return the sum over frequencies for radii up to `far` that leaves out at most `allowed`."""
        of, kept = self.kept.get(id(pupil), (None, None))
        left = fading.end(self._left(pupil))[1]
        if kept is not None and of is pupil and kept.far >= far and kept.allowed <= allowed and kept.left == left:
            return kept
        made = rule(fading, tuple(parts(pupil)), Slopes.of(pupil), self._left(pupil), far, allowed)
        found = Summed.of(made, pupil, far, allowed)
        self.kept[id(pupil)] = pupil, found
        return found
