r"""Azimuthal Fourier orders of a measured wavefront in a microscope's pupil, with bounds.

``P = exp(i W) = sum_m P_m(rho) exp(i m theta)``. Moved into the complex plane, theta + i b, a term of W of order m
gains an imaginary part of at most ``w sinh(m b)``, w being its size at the edge, so that for any b > 0

.. math:: |P_m(\rho)| \le \exp\Bigl(\sum_j w_j \sinh(m_j b) - |m| b\Bigr), \quad 0 \le \rho \le 1 .

At complex rho, ``P_m`` is at most ``exp(sum_j w_j abs(Im R_j(rho)))``. See docs/certificate.md.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.optics.layers.debye import Rule
from lommel.optics.layers.quadrature_bounds import Piece
from lommel.optics.wavefront.wavefront import Wavefront

DEGREE_MOST = 30  # powers of rho^2 lose 5.8^(n / 2) roundings
_ORDERS_MOST = 250
_HEIGHTS = np.geomspace(1e-2, 6.0, 200)
Sizes = tuple[tuple[tuple[int, int], float], ...]
"""n and m >= 0 of terms, and the largest amplitude of m and -m together, radians at the edge."""


class Orders(NamedTuple):
    """Orders -most to most, from equally spaced angles; error bounds the sum of all others and of aliases."""

    most: int
    angles: int
    error: float


def checked(wavefront: Wavefront | None) -> Wavefront | None:
    """Return a supported wavefront, None for none or a flat one; TypeError or ValueError otherwise."""
    validation.optional("aberrations", wavefront, Wavefront)
    if wavefront is None or wavefront.flat:
        return None
    for (n, m), c in wavefront.edge_terms().items():
        if n > DEGREE_MOST and np.any(c):
            raise ValueError(f"aberrations must have terms up to degree {DEGREE_MOST}, got (n, m) = ({n}, {m})")
    return wavefront


@lru_cache(maxsize=64)
def orders(terms: Sizes, error: float) -> Orders:
    """Return the orders needed for an error of at most `error`; ValueError if they are too many."""
    strip = sum((w * np.sinh(m * _HEIGHTS) for (_, m), w in terms), np.zeros(_HEIGHTS.shape))

    def beyond(m: int) -> float:
        """Bound the sum of all orders beyond m, on both sides."""
        if not strip.any():
            return 0.0
        exponent = strip - (m + 1) * _HEIGHTS - np.log(-np.expm1(-_HEIGHTS))
        return 2.0 * math.exp(min(float(exponent.min()), 700.0))

    for most in range(_ORDERS_MOST + 1):
        if beyond(most) <= 0.5 * error:
            # Of angles so many, order m is that plus those at m + k angles, the first from angles - most on.
            return Orders(most, 2 * most + 2, beyond(most) + beyond(most + 1))
    largest = max(terms, key=lambda term: term[0][1] * term[1])
    raise ValueError(
        f"aberrations must be smaller: they have more than {_ORDERS_MOST} orders of the azimuth; the largest term, "
        f"(n, m) = {largest[0]}, has {largest[1] / (2.0 * math.pi):.3g} waves at the edge"
    )


def samples(wavefront: Wavefront, rho: Array, kept: Orders) -> NDArray[np.complex128]:
    """Return P_m at each rho, shape ``(n, 2 most + 1, len(rho))``, m from -most on, of a flattened stack."""
    theta = 2.0 * np.pi / kept.angles * np.arange(kept.angles)
    phases = wavefront.flattened().phase(np.minimum(rho[:, None], 1.0), theta)
    found = np.fft.fft(np.exp(1j * phases), axis=-1) / kept.angles
    return np.moveaxis(found[..., np.arange(-kept.most, kept.most + 1)], -1, 1)


def components(wavefront: Wavefront, terms: Sizes, rule: Rule, error: float) -> tuple[NDArray[np.complex128], float]:
    """Return as few P_m, m from -most to most, as sums by a rule within `error` need, and a bound on their error."""
    size = max(float(np.abs(part).sum()) for part in rule.parts)
    kept = orders(terms, 0.01 * error / size)
    found = samples(wavefront, rule.rho, kept)
    # The most that orders m and -m add in any part and pupil, then all orders from m on.
    weights = np.abs(np.stack(rule.parts))
    each = (np.abs(found) @ weights.T).max(axis=-1)
    each = (each + each[:, ::-1])[:, kept.most :].max(axis=0)
    beyond = np.append(np.cumsum(each[::-1])[::-1], 0.0)[1:]
    most = int(np.flatnonzero(beyond <= error)[0])
    return found[:, kept.most - most : kept.most + most + 1], float(beyond[most] + kept.error * size)


@lru_cache(maxsize=16)
def growth(piece: Piece, terms: Sizes) -> Array:
    """Return the log of a bound on ``abs(exp(i W))`` at any azimuth, on each disc around a section."""
    height = piece.covered.height
    square = piece.covered.square * piece.layers.NA**-2
    root = np.sqrt(square.largest)
    total = np.zeros(height.shape)
    for (n, m), w in terms:
        middle, spread = _taylor(n, m, square.centre, square.radius)
        imaginary = np.abs(middle.imag) + spread
        total += w * (root * imaginary + height * (np.abs(middle) + spread) if m % 2 else imaginary)
    return total


def _taylor(n: int, m: int, centre: NDArray[np.complex128], radius: Array) -> tuple[NDArray[np.complex128], Array]:
    """Return ``R_n^m``, or over rho where m is odd, at centres of rho^2, and how far it is from that on discs."""
    half, low = (n + m) // 2, m // 2
    f = math.factorial
    powers = np.zeros(n // 2 + 1)
    for s in range((n - m) // 2 + 1):
        powers[(n - m) // 2 - s + low] = (-1) ** s * f(n - s) // (f(s) * f(half - s) * f((n - m) // 2 - s))
    poly = np.polynomial.Polynomial(powers)
    size = np.polynomial.Polynomial(np.abs(powers))
    spread = 2.0**-50 * size(np.abs(centre) + radius)
    step = np.ones(radius.shape)
    slope = poly
    for k in range(1, powers.size):
        slope = slope.deriv()
        step = step * radius / k
        spread = spread + np.abs(slope(centre)) * step
    return np.asarray(poly(centre)), np.asarray(spread)
