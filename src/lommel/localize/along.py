"""Images of a molecule along z: Chebyshev series in pieces, whose errors are proven from the waves they are made of.

Along the stage an image is a sum of waves ``exp(i w z)``, ``abs(w) <= k (n_i - sqrt(n_i^2 - NA^2))``, whose moduli
add up to at most the light collected; along the depth one of ``exp(i k n_s d (c - c'*))``, over the light there,
which falls as that beyond the critical angle fades. Both are analytic in ellipses, on which they are bounded:
L. N. Trefethen, Approximation Theory and Approximation Practice, theorem 8.2.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.core import engine
from lommel.optics.layers import debye
from lommel.optics.layers.objective_pupil import ObjectivePupil

_MOST_PLANES, _MOST_PIECES = 400, 200
_INNER = 24  # points of a piece
_ETA = np.geomspace(0.02, 6.0, 300)  # semiaxes of ellipses are cosh and sinh of these


class Bounds(NamedTuple):
    """Bounds on an error of images and of their slopes by z, over the light collected."""

    value: float
    slope: float


@dataclass(frozen=True)
class Waves:
    """What images of a pupil are made of along "z" or "depth": how large they are away from the real axis.

    Intensities are over the light collected, as of an :class:`ObjectivePupil`.
    """

    pupil: ObjectivePupil
    along: str

    def at(self, places: Array) -> ObjectivePupil:
        """Return a stack of the pupil at places along this axis, metres."""
        pupil, still = self.pupil, np.zeros(places.shape)
        if self.along == "depth":
            return replace(pupil, depth=places, focus=pupil.focus + still, z=pupil.z + still)
        return replace(pupil, depth=pupil.depth + still, z=places, focus=pupil.focus + (places - pupil.z))

    @cached_property
    def rate(self) -> float:
        """Largest rate of a phase difference, radians a metre."""
        layers = self.pupil.layers
        index = layers.immersion if self.along == "z" else layers.sample
        return layers.wavenumber * (index - math.sqrt(max(0.0, index**2 - layers.NA**2)))

    @cached_property
    def fading(self) -> float:
        """Largest rate at which light fades with the depth, nepers a metre; 0 along z."""
        layers = self.pupil.layers
        if self.along == "z":
            return 0.0
        return 2.0 * layers.wavenumber * math.sqrt(max(0.0, layers.NA**2 - layers.sample**2))

    def light(self, places: Array) -> Array:
        """Return the light collected at places, over that far from the glass; 1 along z."""
        if self.fading == 0.0:
            return np.ones(places.shape)
        shares = self.pupil.light.shares
        near, far = debye.power(self.pupil.layers, places.ravel(), self.pupil.light.model)
        return np.asarray((near @ shares) / float(far @ shares)).reshape(places.shape)

    def most(self, low: float, high: float) -> Array:
        """Bound the logarithm of intensities times :meth:`light` on ellipses around places from `low` to `high`."""
        half, middle = 0.5 * (high - low), 0.5 * (high + low)
        nearest = middle - half * np.cosh(_ETA)
        # Above the glass fading light grows.
        above = np.maximum(0.0, -nearest) * self.fading
        return np.asarray(self.rate * half * np.sinh(_ETA) + above + np.log(self.light(np.maximum(0.0, nearest))))

    def most_of_quotients(self, low: float, high: float) -> Array:
        """Bound the logarithm of intensities there; infinite where light might be 0."""
        # Where what fades turns by less than a quarter its real part is positive, and light at least what stays.
        turned = self.fading * 0.5 * (high - low) * np.sinh(_ETA)
        return np.asarray(np.where(turned <= 0.5 * math.pi, self.most(low, high), np.inf))

    @property
    def steepest(self) -> float:
        """Bound on the sum of moduli of the derivative, 1/metres, over the light collected."""
        # Of waves exp((i a - b) d), and of 1 over the light, which changes by the part that fades.
        return (self.rate + self.fading) + self.fading


def _tail(most: Array, count: int) -> Bounds:
    """Bound Chebyshev coefficients from `count` on, and their slopes over half the length."""
    x = np.exp(-_ETA)
    left = 1.0 - x
    size = np.exp(np.minimum(most - count * _ETA, 600.0)) * 2.0
    slope = count**2 / left + 2.0 * count * x / left**2 + x * (1.0 + x) / left**3
    return Bounds(float((size / left).min()), float((size * slope).min()))


class Pieces(NamedTuple):
    """Chebyshev series in pieces from values at `places`, whole-range Chebyshev points.

    Coefficients (pieces, terms) are `matrix` times values, shape (pieces, terms, places); errors of what they are of
    exact values, and what errors of values grow by in images and slopes.
    """

    places: Array
    matrix: Array
    error: Bounds
    gain: Bounds


def pieces(waves: Waves, low: float, high: float, error: float) -> Pieces:
    """Return the fewest pieces that are off by at most `error`; ValueError if too many are needed."""
    terms, length = engine.MoleculeTable.terms, high - low
    for count in range(1, _MOST_PIECES + 1):
        half = 0.5 * length / count
        # Along the depth light of the first piece fades, and grows above it, most.
        most = waves.most_of_quotients(low, low + length / count)
        local = _tail(most, terms)
        if local.value <= 0.9 * error:
            break
    else:
        raise ValueError(f"z must span less: {length:.3g} m take more than {_MOST_PIECES} pieces")
    whole = waves.most(low, high)
    for planes in range(terms, _MOST_PLANES):
        if (first := 2.0 * _tail(whole, planes).value) * terms * 2.0 <= 0.05 * error:
            break
    else:
        raise ValueError(f"z must span less: {length:.3g} m take more than {_MOST_PLANES} planes")
    # Coefficients of what the interpolating polynomial is off by are at most twice that, light being at least 1.
    through = first * 2.0 + _tail(most, _INNER).value
    value = local.value + through * terms
    slope = local.slope / half + through * sum(k * k for k in range(terms)) / half
    matrix = _matrix(waves, low, high, planes, count)
    return Pieces(_nodes(planes, low, high), matrix, Bounds(value, slope), _gains(matrix, half))


def _nodes(count: int, low: float, high: float) -> Array:
    x = np.cos((np.arange(count) + 0.5) * (math.pi / count))[::-1]
    return np.asarray(0.5 * (low + high) + 0.5 * (high - low) * x)


def _series(count: int) -> Array:
    """Return the matrix from values at Chebyshev points to coefficients."""
    angles = (np.arange(count)[::-1] + 0.5) * (math.pi / count)
    matrix = np.cos(np.outer(np.arange(count), angles)) * (2.0 / count)
    matrix[0] *= 0.5
    return matrix


def _matrix(waves: Waves, low: float, high: float, planes: int, pieces: int) -> Array:
    """Return the matrix from values at the planes to coefficients of the pieces, by way of one polynomial."""
    vander, whole = np.polynomial.chebyshev.chebvander, _series(planes)
    cut = _series(_INNER)[: engine.MoleculeTable.terms]
    length = (high - low) / pieces
    made = []
    for k in range(pieces):
        inner = _nodes(_INNER, low + k * length, low + (k + 1) * length)
        x = (2.0 * inner - (low + high)) / (high - low)
        made.append((cut / waves.light(inner)) @ vander(x, planes - 1) @ whole)
    return np.stack(made) * waves.light(_nodes(planes, low, high))


def _gains(matrix: Array, half: float) -> Bounds:
    """Return the largest sums of moduli of what each value counts, by polynomials at four times as many points."""
    terms = matrix.shape[1]
    x = _nodes(8 * terms, -1.0, 1.0)
    values = np.polynomial.chebyshev.chebvander(x, terms - 1)
    slopes = np.polynomial.chebyshev.chebval(x, np.polynomial.chebyshev.chebder(np.eye(terms), axis=1).T).T
    between = 1.0 / math.cos(math.pi / 16.0)
    value, slope = (between * float(np.abs(at @ matrix).sum(axis=2).max()) for at in (values, slopes))
    return Bounds(value, slope / half)
