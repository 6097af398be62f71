"""Images of radial pupils through isotropic blur, by quadrature over the product of the two transfer functions.

The image is ``e(v) = (8 / pi) int O(f) T(f) J0(2 f v) f df``. f is the frequency / the cutoff of the optics, O the
autocorrelation of the pupil function, and T the transfer function of the blur. For seeing T is negligible above a low
f: a few hundred nodes replace a lattice as wide as the halo. All truncation errors are bounded (docs/certificate.md,
section 17).

Error bounds of the quadrature over f require bounds on T in the complex plane. With ``f = F x^3``, F the end of the
range, Kolmogorov's ``f^(5/3)`` and von Karman's structure function are entire in x. They are bounded on discs of
complex x, each with a centre and a radius.

With pupil coordinates r / the radius of the aperture, ``O(f) = int P(r - f) conj(P(r + f)) dr`` is a sum of parts: an
integral over the overlap of two discs of radius 1 (a lens), minus twice an integral over the disc of the obscuration,
plus an integral over the overlap of two such discs. Each part is computed by Gauss-Legendre rules (for the azimuth of
a disc, by equal steps). The error follows from the maximum of the integrand for one complex variable.
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

_NU = 5.0 / 6.0  # order nu of the Bessel function in von Karman's structure function
_NEAR = 4.0  # abs(z) up to which the series of z^nu K_nu(z) is used
_TERMS = 30  # number of terms of this series
_STEPS: Array = 1.01 ** np.arange(-1600.0, 1.0)  # increasing frequencies / cutoff, 1e-7 to 1
FURTHER: Array = 1.01 ** np.arange(-1600.0, 141.0)
"""Increasing frequencies / cutoff, 1e-7 to 4."""


class Karman(NamedTuple):
    """Half of von Karman's structure function, ``size (limit - z^nu K_nu(z))``, ``z = rate f``."""

    size: float
    rate: float

    def least(self, z: NDArray[np.complex128], power: NDArray[np.complex128], largest: Array) -> Array:
        """Return a lower bound on the real part over discs of x: `power` = ``z^(5/3)`` and z at the centres.

        `largest` is the largest abs(z) of each disc.
        """
        # Certificate, section 17, "Over frequencies": the series for abs(z) <= 4, otherwise the real part of z.
        limit = self.size * math.gamma(_NU) * 2.0 ** (_NU - 1.0)
        clipped = np.minimum(largest, _NEAR)
        with np.errstate(over="ignore", invalid="ignore"):
            # From centre to rim the series changes by at most the difference of its sums of absolute terms.
            center = self._series(z, power, -1.0).real
            change = self._series(clipped, clipped ** (5.0 / 3.0), 1.0) - self._series(
                np.abs(z), np.abs(z) ** (5.0 / 3.0), 1.0
            )
            series = np.where(largest <= _NEAR, center - change.real, -np.inf)
            # abs(K_nu(z)) <= K_nu(Re z), and y^nu K_nu(y) decreases.
            real = z.real - (largest - np.abs(z))
            ratio = np.divide(largest, real, out=np.full(largest.shape, np.inf), where=real > 0.0)
            return np.asarray(np.maximum(series, limit * (1.0 - ratio**_NU)))

    def _series(self, z: NDArray[np.generic], power: NDArray[np.generic], sign: float) -> NDArray[np.complex128]:
        square = 0.25 * np.where(np.abs(z) <= _NEAR, z, 0.0) ** 2
        fractional, even = _coefficients()
        # Horner's rule in z^2 / 4, for the two series together.
        fractional_sum, even_sum = np.zeros(square.shape, complex), np.zeros(square.shape, complex)
        for a, b in zip(fractional[::-1], even[::-1], strict=True):
            fractional_sum, even_sum = fractional_sum * square + a, even_sum * square + b
        return np.asarray(self.size * (2.0**-_NU * power * fractional_sum + sign * 2.0**_NU * even_sum))


@lru_cache(maxsize=1)
def _coefficients() -> tuple[Array, Array]:
    k, factor = np.arange(_TERMS), 0.5 * math.pi / math.sin(math.pi * _NU)
    gamma = scipy.special.gamma
    even = factor / (gamma(k + 1.0) * gamma(k + 1.0 - _NU))
    # The first term of the even series cancels `limit` in the structure function.
    even[0] = 0.0
    return factor / (gamma(k + 1.0) * gamma(k + 1.0 + _NU)), even


class Fading(NamedTuple):
    """Transfer function of isotropic blur, ``exp(-kolmogorov f^(5/3) - gauss f^2 - sum of Karman)``."""

    blurs: tuple[Blur, ...]
    scale: float
    wavelength: float | None
    kolmogorov: float
    gauss: float
    karman: tuple[Karman, ...]

    @classmethod
    def of(cls, blurs: tuple[Blur, ...], scale: float, wavelength: float | None) -> Fading | None:
        """Return the Fading of several blurs; None if one depends on the direction; `scale` is one lambda*N."""
        kolmogorov = gauss = 0.0
        outer = []
        for blur in blurs:
            if not blur.isotropic:
                return None
            gauss += 2.0 * math.pi**2 * float(blur.covariance[0, 0]) / scale**2
            if not isinstance(blur, Seeing):
                continue
            coherence = blur.coherence(wavelength) * scale
            if blur.outer_scale is None:
                kolmogorov += KOLMOGOROV * coherence ** (-5.0 / 3.0)
            else:
                size, rate = karman(blur, wavelength)
                outer.append(Karman(size, rate / coherence))
        return cls(blurs, scale, wavelength, kolmogorov, gauss, tuple(outer))

    @classmethod
    def above(cls, blurs: tuple[Blur, ...], scale: float, wavelength: float | None) -> Fading:
        """Return isotropic blur whose transfer function bounds the absolute transfer function of several blurs."""
        covariance = sum((blur.covariance for blur in blurs), np.zeros((2, 2)))
        # exp(-w.C w / 2) is bounded by the smallest eigenvalue of C; streaks are omitted, as abs(sinc) <= 1.
        least = max(float(np.linalg.eigvalsh(covariance)[0]) - 1e-12 * float(np.trace(covariance)), 0.0)
        seeings = (blur for blur in blurs if isinstance(blur, Seeing))
        isotropic = cls.of((*seeings, Jitter(math.sqrt(least))), scale, wavelength)
        assert isotropic is not None
        return isotropic

    def at(self, f: Array) -> Array:
        """Return the transfer function."""
        transfer = np.ones(f.shape)
        for blur in self.blurs:
            transfer *= blur.transfer(f / self.scale, wavelength=self.wavelength)
        return transfer

    def log_bound(self, x: NDArray[np.complex128], radius: Array, end: float) -> Array:
        """Return an upper bound on log(abs(T)) over discs of x, with ``f = end x^3``."""
        size = np.abs(x)
        # On a disc, Re x^5 is at least Re x^5 at the centre minus largest^5 - size^5, the maximum change to the rim.
        largest = size + radius
        fifth = x**5
        log_bound = -self.kolmogorov * end ** (5.0 / 3.0) * (fifth.real - (largest**5 - size**5))
        log_bound -= self.gauss * end**2 * ((x**6).real - (largest**6 - size**6))
        for term in self.karman:
            z = term.rate * end
            log_bound -= term.least(z * x**3, z ** (5.0 / 3.0) * fifth, z * largest**3)
        return np.asarray(log_bound)

    def remaining(self, steps: Array = _STEPS) -> Array:
        """Return bounds on ``int T f df`` from each of the increasing frequencies `steps` to the last one."""
        # T decreases: sums with the values at the left ends of the steps are upper bounds.
        integrals = 0.5 * self.at(steps[:-1]) * (steps[1:] ** 2 - steps[:-1] ** 2)
        return np.append(np.cumsum(integrals[::-1])[::-1], 0.0)

    @property
    def light(self) -> float:
        """Bound on ``int T f df`` from 0 to 1, with T <= 1 below the first step."""
        return float(self.remaining()[0] + 0.5 * _STEPS[0] ** 2)

    def end(self, allowed: float, steps: Array = _STEPS) -> tuple[float, float]:
        """Return the first step above which ``int T f df`` is at most `allowed`, and the bound on this integral."""
        remaining = self.remaining(steps)
        index = int(np.argmax(remaining <= allowed))
        return float(steps[index]), float(remaining[index])


ETAS = np.geomspace(0.02, 6.0, 40)
"""Logarithms of (sum of semi-axes) of the Bernstein ellipses for which errors are bounded."""
_VALUES_AT_ONCE = 2**20  # largest number of pupil values computed together
_U = 2.0**-53  # unit roundoff of double precision


class Slopes(NamedTuple):
    """Bounds on the derivatives of phase and amplitude of a stack of radial pupils at complex positions."""

    terms: tuple[float, ...]  # largest absolute coefficients, over the stack, of the Legendre P_0, P_1, ... in 2t - 1
    light: Apodization

    @classmethod
    def of(cls, pupil: Pupil) -> Slopes:
        """Return the bounds for a stack."""
        return cls((0.0, *np.abs(pupil.radial_terms()).max(axis=0).tolist()), pupil.illumination)

    def at(self, distance: Array) -> tuple[Array, Array, Array]:
        """Return bounds on gradient, second derivatives and log amplitude up to a `distance` from the disc."""
        legval, legder = np.polynomial.legendre.legval, np.polynomial.legendre.legder
        # t = r.r is within 2 d + d^2 of [0, 1], d: distance; P_n and its derivatives are largest at an ellipse's end.
        t = distance * (2.0 + distance)
        first, second = (legval(1.0 + 2.0 * t, legder(self.terms, k)) for k in (1, 2))
        # Derivatives with respect to t, for the argument 2 t - 1 of P_n; then with respect to r, dt = 2 r dr.
        first, second = 2.0 * first, 4.0 * second
        gradient = 2.0 * (1.0 + distance) * first
        growth = np.zeros(np.shape(distance)) if self.light.uniform else self.light.growth(1.0 + 2.0 * t)
        return gradient, 2.0 * first + 4.0 * (1.0 + distance) ** 2 * second, growth


def gauss_nodes(log_size: Array, allowed: Array, etas: Array = ETAS) -> Array:
    """Return the number of Gauss nodes for an error `allowed` of a mean; `log_size` is log(M) on each ellipse."""
    # M bounds the absolute integrand. The rule is exact up to the degree 2 n - 1, with positive weights: its error is
    # at most 4 M rho^(1 - 2 n) / (rho - 1).
    log = np.where(np.isfinite(log_size), log_size, np.inf)
    counts = 0.5 + 0.5 * (math.log(4.0) + log - np.log(np.expm1(etas)) - np.log(allowed)[..., None]) / etas
    return np.asarray(np.maximum(np.ceil(counts.min(axis=-1)), 2.0))


class Part(NamedTuple):
    """One of the integrals whose sum is the autocorrelation O, for f from 0 to `end`."""

    kind: str  # "lens": overlap of two discs of this radius; "disc": obscuration of one pupil, inside the other pupil
    radius: float
    end: float

    def log_bound(self, slopes: Slopes, last: Array, distance: Array) -> Array:
        """Return a bound on log(abs(part)) at complex f within a `distance` of the real interval [0, last]."""
        # Only the position r + 2 f in the second pupil depends on f: q' = 2 in the table of section 17.
        if self.kind == "disc":
            gradient, _, growth = slopes.at(2.0 * distance)
            return np.asarray(math.log(2.0 * math.pi * self.radius**2) + distance * 2.0 * gradient + growth)
        ratio = (last + distance) / self.radius
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            root = 1.0 / np.sqrt(np.maximum(1.0 - ratio**2, 0.0))
            # A = (1 - (f / a + delta)^2)^(-1/2) and d = A delta of the table's third row.
            d = root * distance / self.radius
            cosh = np.cosh(np.minimum(d, 300.0))
            shift = np.hypot(cosh * root + 1.0, cosh * root)
            gradient, second, growth = slopes.at((shift + 1.0) * distance)
            phase_growth = distance * (2.0 * (last + distance) * second * shift + 2.0 * gradient)
            size = 4.0 * self.radius**2 * (0.5 * math.pi + d) * cosh * (cosh + ratio)
            bound = np.log(size) + phase_growth + 2.0 * growth
        return np.where((ratio < 1.0) & np.isfinite(bound), bound, np.inf)

    def counts(self, slopes: Slopes, low: float, high: float, allowed: float) -> tuple[int, int]:
        """Return the numbers of nodes along the two coordinates for an error of `allowed`, f from `low` to `high`."""
        a, sinh = self.radius, np.sinh(ETAS)
        if self.kind == "disc":
            return self._disc_counts(slopes, high, 0.25 * allowed / (2.0 * math.pi * a * a))
        # The largest half length of a chord of the lens is c = a - f; the product f c is largest at f = a / 2.
        middle = min(max(0.5 * a, low), high)
        product = middle * (a - middle)
        with np.errstate(over="ignore", invalid="ignore"):
            _, second, growth = slopes.at((a - low) * sinh)
            # Half of `allowed` for each coordinate, divided by the area that multiplies the mean.
            line_count = gauss_nodes(
                sinh * 2.0 * product * second + 2.0 * growth,
                np.array(0.5 * allowed / (2 * math.pi * a * a)),
            )
            opening = math.acos(min(low / a, 1.0))
            # theta = tau arccos(f / a): an ellipse in theta is an ellipse in tau times half of the opening angle.
            turn = 0.5 * opening * sinh
            cosh, stretch = np.cosh(turn), np.sqrt(np.cosh(2.0 * turn))
            _, second, growth = slopes.at(a * turn * stretch)
            log = np.log(cosh * (cosh + 1.0)) + turn * 2.0 * high * second * a * stretch + 2.0 * growth
            angle_count = gauss_nodes(log, np.array(0.5 * allowed / (4.0 * a * a * max(opening, 1e-9))))
        return int(line_count), int(angle_count)

    def _disc_counts(self, slopes: Slopes, high: float, allowed: float) -> tuple[int, int]:
        eps, sinh = self.radius, np.sinh(ETAS)
        with np.errstate(over="ignore", invalid="ignore"):
            d = 0.5 * sinh
            _, second, growth = slopes.at(eps * d)
            log = d * 2.0 * high * second * eps + 2.0 * growth + np.log1p(d)
            radial_count = gauss_nodes(log, np.array(allowed))
            stretch = np.sqrt(np.cosh(2.0 * ETAS))
            _, second, growth = slopes.at(eps * ETAS * stretch)
            log = ETAS * 2.0 * high * second * eps * stretch + 2.0 * growth
            # Error of a rule with n equal steps: 2 M / (e^(n b) - 1).
            log = np.where(np.isfinite(log), log, np.inf)
            angle_count = (np.log(2.0) + log - math.log(2.0 * min(allowed, 0.05)) + 0.1) / ETAS
        return int(radial_count), 2 * max(1, math.ceil(0.5 * float(angle_count.min())))

    def at(self, pupil: Pupil, f: Array, counts: tuple[int, int]) -> Array:
        """Return the integral at frequencies `f` for the flattened stack, shape ``(n, len(f))``."""
        linear, angular, weight = self._nodes(counts)
        values = np.empty((math.prod(pupil.shape), f.size))
        block = max(1, _VALUES_AT_ONCE // (len(values) * weight.size))
        for start in range(0, f.size, block):
            block_f = f[start : start + block, None]
            s, t, node_weights = self._places(block_f, linear, angular, weight)
            values[:, start : start + block] = np.einsum("nfk,fk->nf", radial_product(pupil, s, t), node_weights)
        return values

    def _nodes(self, counts: tuple[int, int]) -> tuple[Array, Array, Array]:
        """Return flat arrays of all nodes: coordinates along a line and in angle, relative to the range; weights."""
        x, w = gauss_legendre(counts[0], -1.0, 1.0) if self.kind == "lens" else gauss_legendre(counts[0])
        if self.kind == "lens":
            y, v = gauss_legendre(counts[1])
        else:
            half_count = counts[1] // 2  # the integrand is even in the azimuth
            y, v = math.pi / half_count * (np.arange(float(half_count)) + 0.5), np.full(half_count, 1.0 / half_count)
        nodes = np.broadcast_arrays(x[:, None], y)
        return nodes[0].ravel(), nodes[1].ravel(), np.multiply.outer(w, v).ravel()

    def _places(self, f: Array, linear: Array, angular: Array, weight: Array) -> tuple[Array, Array, Array]:
        """Return rho^2 in the first and in the second pupil, and weights, each (frequencies, nodes)."""
        a = self.radius
        if self.kind == "disc":
            x, y2 = a * linear * np.cos(angular), (a * linear * np.sin(angular)) ** 2
            # -2 for the obscurations of the two pupils; 2 pi a^2 converts the mean to an integral over a disc.
            weights = -4.0 * math.pi * a * a * linear * weight
            first = np.broadcast_to(x * x + y2, (f.size, x.size))
            return first, (x + 2.0 * f) ** 2 + y2, np.broadcast_to(weights, first.shape)
        ratio = f / a
        # arccos(ratio) by the half angle, without loss of digits near ratio = 1.
        opening = 2.0 * np.arcsin(np.sqrt(np.maximum(0.5 * (1.0 - ratio), 0.0)))
        angle = opening * angular
        cos = np.cos(angle)
        # cos(angle) - cos(opening), without loss of digits near angle = opening.
        half = 2.0 * np.sin(0.5 * (opening + angle)) * np.sin(0.5 * (opening - angle))
        x, y2 = linear * half, np.sin(angle) ** 2
        weights = 2.0 * a * a * opening * cos * half * weight
        return a * a * ((x - ratio) ** 2 + y2), a * a * ((x + ratio) ** 2 + y2), weights


def radial_product(pupil: Pupil, s: Array, t: Array) -> Array:
    """Return Re ``P(s) conj(P(t))``, s and t being rho^2; the imaginary part is odd, and its integral is 0."""
    terms, illumination = pupil.radial_terms(), pupil.illumination
    if not terms.any():
        product = np.ones((len(terms), *s.shape))
    else:
        product = np.cos(zernike.legendre_sum(terms, 2.0 * s - 1.0) - zernike.legendre_sum(terms, 2.0 * t - 1.0))
    if not illumination.uniform:
        product *= np.exp(-(illumination.exponent_at(s) + illumination.exponent_at(t)))
    return np.asarray(product)


def parts(pupil: Pupil) -> list[Part]:
    """Return the integrals whose sum is the autocorrelation of a radial pupil."""
    eps = pupil.obscuration
    if eps == 0.0:
        return [Part("lens", 1.0, 1.0)]
    return [Part("lens", 1.0, 1.0), Part("disc", eps, 0.5 * (1.0 - eps)), Part("lens", eps, eps)]


def rounding(pupil: Pupil, nodes: int) -> float:
    """Return a bound on (rounding error of an autocorrelation in double precision) / (light)."""
    terms = np.abs(pupil.radial_terms())
    size, slope = float(terms.sum(axis=1).max()), float(pupil.illumination.slope)
    return float(_U * (4.0 * (terms.shape[1] + 10.0) * size + 6.0 * slope + nodes + 60.0))


_ARCS = 64  # number of discs that cover half of an ellipse
_PHASE = 40.0  # approximate phase of J0 across a panel (an interval of f), radians
_MANY_RADII = 1000  # number of distinct radii above which pixels are interpolated from a table
_AT_ONCE = 2**21  # largest number of values of J0 computed together
_TRIES = 6  # largest number of computations with tightened tolerances
_ETAS = ETAS[(ETAS > 0.1) & (ETAS < 3.0)]


class Panel(NamedTuple):
    """Nodes of one part of the autocorrelation in an interval of f."""

    part: Part
    f: Array
    weight: Array  # includes (8 / pi) T f df
    counts: tuple[int, int]  # numbers of nodes along the two coordinates of the part


class Rule(NamedTuple):
    """Quadrature rule over f."""

    panels: tuple[Panel, ...]
    error: float  # bound on the error below `end`
    end: float  # largest f
    tail: float  # bound on the integral of T f df above `end`


@lru_cache(maxsize=16)
def rule(fading: Fading, pieces: tuple[Part, ...], slopes: Slopes, tail: float, v: float, allowed: float) -> Rule:
    """Return the rule for radii up to `v` with the error `allowed`; `tail` bounds ``int T f df`` above its end."""
    end, tail = fading.end(tail)
    if any(part.kind == "disc" and part.end < end for part in pieces):
        # Above `part.end` the disc of the obscuration crosses the edge of the other pupil.
        raise Declined("an obscuration has no proven rule if blur ends above (1 - obscuration) / 2 of the cutoff")
    # Of `allowed`, 0.25 is for nodes inside the parts, 0.65 for nodes over f, 0.1 for the truncated end of a lens.
    piece_error, panels, error = allowed / len(pieces), [], 0.0
    node_error = 0.25 * piece_error * math.pi / (8.0 * fading.light)
    phase_rate = v + 2.0 * float(slopes.at(np.zeros(1))[0][0])
    for part in pieces:
        edges, truncation = _edges(part, min(end, part.end), phase_rate, 0.1 * piece_error)
        error += truncation
        for f, weight, low, high in _panels(fading, part, slopes, edges, v, 0.65 * piece_error):
            panels.append(Panel(part, f, weight, part.counts(slopes, low, high, node_error)))
    return Rule(tuple(panels), error + 0.9 * allowed, end, tail)


def _edges(part: Part, end: float, phase_rate: float, allowed: float) -> tuple[Array, float]:
    """Return the edges of panels in f, and a bound on the integral above the last edge."""
    truncation = 0.0
    near_branch = end > 0.7 * part.end and part.kind == "lens"
    if near_branch and end > part.end * (
        1.0 - (least := 2.0 ** math.floor(0.4 * math.log2(allowed / 15.0 / part.radius**4)))
    ):
        # Near f = a, the area of a lens is below 4 sqrt(2) a^2 (1 - f / a)^(3/2): certificate, section 17.
        end, truncation = part.end * (1.0 - least), 32.0 * math.sqrt(2.0) / math.pi * part.radius**4 * least**2.5
    edges = np.linspace(0.0, end, max(2, math.ceil(end * 2.0 * phase_rate / _PHASE)) + 1)
    if near_branch:
        # Panels halve towards the branch point f = a: no panel is longer than its distance from this point.
        graded = part.end * (1.0 - 0.5 ** np.arange(0.0, 60.0))
        edges = np.unique(np.concatenate([edges, graded[(graded > 0.0) & (graded < end)]]))
    return edges, truncation


def _panels(
    fading: Fading, part: Part, slopes: Slopes, edges: Array, v: float, allowed: float
) -> Iterator[tuple[Array, Array, float, float]]:
    """Yield nodes, weights and ends of panels whose errors sum to at most `allowed`."""
    end = float(edges[-1])
    # The variable is x = (f / F)^(1/3), in which Kolmogorov's f^(5/3) is entire.
    ends = np.cbrt(edges / end)
    lengths = np.diff(ends)
    # Discs around 64 points cover half of each ellipse; the other half is the mirror image.
    angle = math.pi / _ARCS * (np.arange(_ARCS) + 0.5)
    half_length, eta = 0.5 * lengths[:, None, None], _ETAS[:, None]
    middle: NDArray[np.complex128] = (ends[:-1, None, None] + half_length).astype(np.complex128)
    x = middle + half_length * np.cosh(eta + 1j * angle)
    radius = np.broadcast_to(half_length * np.cosh(eta) * (0.5 * math.pi / _ARCS), x.shape)
    size = np.abs(x)
    f, change = end * x**3, end * ((size + radius) ** 3 - size**3)
    upper = edges[1:, None, None]
    distance = np.abs(f - np.clip(f.real, 0.0, upper)) + change
    with np.errstate(over="ignore", invalid="ignore"):
        log = fading.log_bound(x, radius, end) + part.log_bound(slopes, upper, distance)
        # abs(J0(2 f v)) <= exp(2 v abs(Im f)), and 24 / pi end^2 x^5 is (8 / pi) f df/dx.
        log += 2.0 * v * (np.abs(f.imag) + change) + np.log(24.0 / math.pi * end**2 * (size + radius) ** 5)
    log = np.where(np.isnan(log), np.inf, log).max(axis=-1)
    counts = gauss_nodes(log, allowed / len(lengths) / lengths, _ETAS)
    for k, count in enumerate(counts.astype(int)):
        x_at, weight = gauss_legendre(int(count), float(ends[k]), float(ends[k + 1]))
        f_at = end * x_at**3
        yield f_at, 24.0 / math.pi * end**2 * x_at**5 * weight * fading.at(f_at), float(edges[k]), float(edges[k + 1])


class Summed(NamedTuple):
    """Sum of ``terms J0(2 f v)`` for a flattened stack, valid for radii v up to `v_max`."""

    f: Array
    terms: Array  # (n, len(f))
    v_max: float
    allowed: float
    error: float  # bound on the error of the rule below its end
    tail: float  # bound on the integral of T f df above the end of the rule
    rounded: float  # bound on the relative rounding errors of the terms

    @classmethod
    def of(cls, rule: Rule, pupil: Pupil, v_max: float, allowed: float) -> Summed:
        """Return the sum for a stack of pupils by a `rule`."""
        f = np.concatenate([panel.f for panel in rule.panels])
        terms = [panel.part.at(pupil, panel.f, panel.counts) * panel.weight for panel in rule.panels]
        rounded = max(rounding(pupil, math.prod(panel.counts)) for panel in rule.panels)
        return cls(f, np.concatenate(terms, axis=1), v_max, allowed, rule.error, rule.tail, rounded)

    @property
    def size(self) -> float:
        """Largest sum, over pupils, of the absolute terms."""
        return float(np.abs(self.terms).sum(axis=1).max())

    def rounding(self, v: float) -> float:
        """Return a bound on (rounding error of a sum at radii up to v) / :attr:`size`."""
        return self.rounded + _U * (self.f.size + 60.0 + 4.0 * float(self.f.max()) * v)

    def at(self, v: Array) -> Array:
        """Return the sums at radii v, shape ``(n, len(v))``."""
        values = np.empty((len(self.terms), v.size))
        block = max(1, _AT_ONCE // self.f.size)
        for start in range(0, v.size, block):
            part = slice(start, start + block)
            values[:, part] = self.terms @ scipy.special.j0(np.multiply.outer(2.0 * self.f, v[part]))
        return values


@dataclass(frozen=True)
class TransferIntegral(RadialMethod[Pupil]):
    """Blurred images of radial pupils by quadrature over the product of transfer functions, to `tol` of the peak."""

    tol: float = RadialMethod.tol
    blur: tuple[Blur, ...] = ()
    # The last sum of each pupil, from which other radii of its image are computed.
    sums: dict[int, tuple[Pupil, Summed]] = field(default_factory=dict, init=True, repr=False, compare=False)

    apodized = True

    def fading(self, pupil: Pupil) -> Fading:
        """Return the blur at the wavelength of a pupil; raise Declined if it depends on the direction."""
        fading = Fading.of(self.blur, pupil.scale, pupil.wavelength)
        if fading is None:
            raise Declined("blur depends on the direction")
        return fading

    def _ceiling(self, pupil: Pupil) -> float:
        """Return an upper bound on the image."""
        # The quadrature may exceed the image by its error.
        return (1.0 + 2.0 * self.tol) * min(pupil.amplitude**2, 8.0 * pupil.transmission * self.fading(pupil).light)

    def _likely_peak(self, pupil: Pupil) -> float:
        """Return an estimate of the lowest peak: light / (area of the diffraction pattern + area of the blur)."""
        light = pupil.transmission
        return light / (light / pupil.likely_peak + 1.0 / (8.0 * self.fading(pupil).light))

    def stretch(self, pupil: Pupil) -> float:
        """Return (bandwidth of the image) / (bandwidth of the optics)."""
        end, _ = self.fading(pupil).end(self._allowed_tail(pupil))
        return end

    def seconds(self, pupil: Pupil, grid: Grid) -> float:
        """Return the estimated time of images on a `grid`, in seconds."""
        end, (gradient, second, _) = self.stretch(pupil), Slopes.of(pupil).at(np.zeros(1))
        panels = max(2.0, end * (grid.reach(pupil) + 2.0 * float(gradient[0])) / 20.0) + (12.0 if end > 0.7 else 0.0)
        nodes = (3.0 + 1.2 * min(end, 0.5) * (1.0 - min(end, 0.5)) * second[0]) * (8.0 + 0.6 * end * second[0])
        radii = min(grid.height * grid.width / 8.0, _MANY_RADII)
        sums = 6e-8 * float(nodes) * math.prod(pupil.shape) + 3e-8 * radii
        return 2e-3 + panels * (4e-4 + 25.0 * sums)

    def _allowed_tail(self, pupil: Pupil) -> float:
        return 0.02 * self.tol * self._likely_peak(pupil) / (8.0 * pupil.transmission)

    def intensity(self, pupil: Pupil, grid: Grid, threads: int = 0) -> Intensities:
        """Return the image at the distinct radii of `grid`, or on its pixels if there are too many or no radii."""
        if not grid.symmetric or grid.radii.size > _MANY_RADII:
            return self.on_pixels(pupil, grid, threads)
        profile = self.profile(pupil, grid.v(pupil))
        # Clamp to 0: an intensity is not negative, and clamping does not increase the error.
        return profile._replace(values=np.maximum(profile.values, 0.0))

    def profile(self, pupil: Pupil, v: Array) -> Intensities:
        """Return the image at increasing `v` for the flattened stack, with an error bound relative to the peak."""
        fading = self.fading(pupil)
        allowed = 0.12 * self.tol * self._likely_peak(pupil)
        # The peak may lie anywhere between the axis and the last geometric ray: sample this range as well.
        near_axis = np.linspace(0.0, float(pupil.v(pupil.geometric_radius()).max()) + 4.0, 9)
        radii = np.concatenate([v, near_axis])
        v_max = float(radii.max())
        # Each try divides `allowed` by twice the excess; rounded to powers of two, similar tolerances share a rule.
        for _ in range(_TRIES):
            summed = self._summed(pupil, fading, v_max, 2.0 ** math.floor(math.log2(allowed)))
            values, size = summed.at(radii), summed.size
            left_out = pupil.left_out[0] + 2.0 * pupil.left_out[1]
            # abs(O(f)) <= O(0) = pi tau: above the end the integral is at most 8 tau int T f df.
            error = summed.error + 8.0 * pupil.transmission * summed.tail
            error += size * (left_out * (2.0 + left_out) + summed.rounding(v_max))
            peak = values.max(axis=1) - error
            relative = np.divide(error, peak, out=np.full(peak.shape, np.inf), where=peak > 0.0)
            if relative.max() <= self.tol:
                break
            allowed *= 0.5 * max(self.tol / float(relative.max()), 1e-4)
        else:
            raise not_met(self.tol, float(relative.max()), "the peak")
        return Intensities(values[:, : v.size], relative, peak)

    def _summed(self, pupil: Pupil, fading: Fading, v_max: float, allowed: float) -> Summed:
        """Return the sum over frequencies for radii up to `v_max` with an error of at most `allowed`."""
        owner, cached = self.sums.get(id(pupil), (None, None))
        tail = fading.end(self._allowed_tail(pupil))[1]
        usable = cached is not None and cached.v_max >= v_max and cached.allowed <= allowed and cached.tail == tail
        if cached is not None and owner is pupil and usable:
            return cached
        quadrature = rule(fading, tuple(parts(pupil)), Slopes.of(pupil), self._allowed_tail(pupil), v_max, allowed)
        summed = Summed.of(quadrature, pupil, v_max, allowed)
        self.sums[id(pupil)] = pupil, summed
        return summed
