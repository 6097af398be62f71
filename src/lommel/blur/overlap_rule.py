r"""Autocorrelation of radial pupils at frequencies of a rule, with proven bounds on all that is left out.

With f over the cutoff and pupil coordinates over the radius of the aperture, ``O(f) = int P(r - f) conj(P(r + f))``
is an integral over a lens of two discs of radius 1, less twice one over the disc of an obscuration, plus one over a
lens of two such discs. Every rule is of Gauss and Legendre but for the azimuth of a disc, and errs by what the
integrand is at most where one variable is complex (docs/certificate.md, section 17).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.optics.aperture.apodization import Apodization
from lommel.optics.pupil import Pupil
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre

ETAS = np.geomspace(0.02, 6.0, 40)
"""Logarithms of the sums of the semi-axes of ellipses that are tried."""
_AT_ONCE = 2**20  # pupil values
_U = 2.0**-53


class Slopes(NamedTuple):
    """The largest slopes of phase and amplitude of a stack of radial pupils, displaced to complex places."""

    terms: tuple[float, ...]  # moduli of the coefficients of P_0, P_1, ... in 2t - 1, the largest of the stack
    light: Apodization

    @classmethod
    def of(cls, pupil: Pupil) -> Slopes:
        """Return those of a stack."""
        return cls((0.0, *np.abs(pupil.radial_terms()).max(axis=0).tolist()), pupil.illumination)

    def at(self, far: Array) -> tuple[Array, Array, Array]:
        """Bound gradient, second derivatives and log amplitude at complex places up to `far` from the unit disc."""
        legval, legder = np.polynomial.legendre.legval, np.polynomial.legendre.legder
        # t = r.r is at most 2 far + far^2 from [0, 1], and P_n and its derivatives largest at the end of an ellipse.
        t = far * (2.0 + far)
        first, second = (legval(1.0 + 2.0 * t, legder(self.terms, k)) for k in (1, 2))
        first, second = 2.0 * first, 4.0 * second
        gradient = 2.0 * (1.0 + far) * first
        growth = np.zeros(np.shape(far)) if self.light.uniform else self.light.growth(1.0 + 2.0 * t)
        return gradient, 2.0 * first + 4.0 * (1.0 + far) ** 2 * second, growth


def gauss_nodes(log_size: Array, allowed: Array, etas: Array = ETAS) -> Array:
    """Return how many Gauss nodes keep a mean within `allowed` if its integrand is at most that on each ellipse."""
    # Exact up to the degree 2 n - 1, with positive weights: off by at most 4 M rho^(1 - 2 n) / (rho - 1).
    log = np.where(np.isfinite(log_size), log_size, np.inf)
    needed = 0.5 + 0.5 * (math.log(4.0) + log - np.log(np.expm1(etas)) - np.log(allowed)[..., None]) / etas
    return np.asarray(np.maximum(np.ceil(needed.min(axis=-1)), 2.0))


class Part(NamedTuple):
    """One of the integrals that an autocorrelation is the sum of, for f from 0 to `end`."""

    kind: str  # "lens" of two discs of a radius, or "disc": within the obscuration of one, anywhere in the other
    radius: float
    end: float

    def log_bound(self, slopes: Slopes, far: Array, off: Array) -> Array:
        """Bound the logarithm of its modulus at frequencies at most `off` from the real ones up to `far`."""
        if self.kind == "disc":
            gradient, _, growth = slopes.at(2.0 * off)
            return np.asarray(math.log(2.0 * math.pi * self.radius**2) + off * 2.0 * gradient + growth)
        ratio = (far + off) / self.radius
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            root = 1.0 / np.sqrt(np.maximum(1.0 - ratio**2, 0.0))
            turn = root * off / self.radius
            cosh = np.cosh(np.minimum(turn, 300.0))
            moved = np.hypot(cosh * root + 1.0, cosh * root)
            gradient, second, growth = slopes.at((moved + 1.0) * off)
            swing = off * (2.0 * (far + off) * second * moved + 2.0 * gradient)
            size = 4.0 * self.radius**2 * (0.5 * math.pi + turn) * cosh * (cosh + ratio)
            found = np.log(size) + swing + 2.0 * growth
        return np.where((ratio < 1.0) & np.isfinite(found), found, np.inf)

    def counts(self, slopes: Slopes, low: float, high: float, allowed: float) -> tuple[int, int]:
        """Return how many nodes along both coordinates keep it within `allowed` for f from `low` to `high`."""
        a, sinh = self.radius, np.sinh(ETAS)
        if self.kind == "disc":
            return self._disc_counts(slopes, high, 0.25 * allowed / (2.0 * math.pi * a * a))
        # f c is at most this, c = 1 - f / a the longest half of a line.
        middle = min(max(0.5 * a, low), high)
        product = middle * (a - middle)
        with np.errstate(over="ignore", invalid="ignore"):
            _, second, growth = slopes.at((a - low) * sinh)
            along = gauss_nodes(
                sinh * 2.0 * product * second + 2.0 * growth, np.array(0.5 * allowed / (2 * math.pi * a * a))
            )
            opening = math.acos(min(low / a, 1.0))
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
        """Return it at frequencies for the flattened stack, shape ``(n, len(f))``."""
        along, across, weight = self._nodes(counts)
        out = np.empty((math.prod(pupil.shape), f.size))
        many = max(1, _AT_ONCE // (len(out) * weight.size))
        for start in range(0, f.size, many):
            some = f[start : start + many, None]
            s, t, share = self._places(some, along, across, weight)
            out[:, start : start + many] = np.einsum("nfk,fk->nf", _product(pupil, s, t), share)
        return out

    def _nodes(self, counts: tuple[int, int]) -> tuple[Array, Array, Array]:
        """Return both coordinates of all nodes, and weights."""
        x, w = gauss_legendre(counts[0], -1.0, 1.0) if self.kind == "lens" else gauss_legendre(counts[0])
        if self.kind == "lens":
            y, v = gauss_legendre(counts[1])
        else:
            half = counts[1] // 2  # the other half is the same
            y, v = math.pi / half * (np.arange(float(half)) + 0.5), np.full(half, 1.0 / half)
        grid = np.broadcast_arrays(x[:, None], y)
        return grid[0].ravel(), grid[1].ravel(), np.multiply.outer(w, v).ravel()

    def _places(self, f: Array, along: Array, across: Array, weight: Array) -> tuple[Array, Array, Array]:
        """Return rho^2 in both pupils, and weights: arrays (frequencies, nodes)."""
        a = self.radius
        if self.kind == "disc":
            x, y2 = a * along * np.cos(across), (a * along * np.sin(across)) ** 2
            share = -4.0 * math.pi * a * a * along * weight  # one of either pupil
            first = np.broadcast_to(x * x + y2, (f.size, x.size))
            return first, (x + 2.0 * f) ** 2 + y2, np.broadcast_to(share, first.shape)
        ratio = f / a
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
    """Return the integrals that the autocorrelation of a radial pupil is the sum of."""
    eps = pupil.obscuration
    if eps == 0.0:
        return [Part("lens", 1.0, 1.0)]
    return [Part("lens", 1.0, 1.0), Part("disc", eps, 0.5 * (1.0 - eps)), Part("lens", eps, eps)]


def rounding(pupil: Pupil, nodes: int) -> float:
    """Bound what an autocorrelation is off by in double precision, over the light."""
    terms = np.abs(pupil.radial_terms())
    size, slope = float(terms.sum(axis=1).max()), float(pupil.illumination.slope)
    return float(_U * (4.0 * (terms.shape[1] + 10.0) * size + 6.0 * slope + nodes + 60.0))
