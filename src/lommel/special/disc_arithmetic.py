"""Circular arithmetic on discs of the complex plane: a result contains the results for all numbers in the discs.

The radius of the disc of a function is the largest slope of the function times the radius of the argument. Every
radius is widened by 1e-13 of the magnitudes from which it is computed, more than the rounding errors.

References
----------
I. Gargantini and P. Henrici, Numer. Math. 18, 305 (1972), doi:10.1007/BF01404681.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.base.cached import cached_property

_ROUNDING = 1e-13  # relative widening of radii, some hundred units of double precision


@dataclass(frozen=True, eq=False)
class Disc:
    """Discs of the complex plane: centres and radii >= 0; the radius is infinite or NaN if there is no bound."""

    centre: NDArray[np.complex128]
    radius: Array

    # Makes NumPy arrays defer to the operators of this class.
    __array_ufunc__ = None

    @cached_property
    def size(self) -> Array:
        """Modulus of each centre; without protection from overflow, and thus five times as fast as numpy.abs."""
        with np.errstate(over="ignore", invalid="ignore"):
            return np.asarray(np.sqrt(self.centre.real**2 + self.centre.imag**2))

    @property
    def largest(self) -> Array:
        """Largest modulus on each disc."""
        return np.asarray((self.size + self.radius) * (1.0 + _ROUNDING))

    @property
    def least(self) -> Array:
        """Smallest modulus on each disc; 0 if the disc contains 0."""
        return np.maximum(self.size * (1.0 - _ROUNDING) - self.radius, 0.0)

    def __add__(self, other: Disc | complex) -> Disc:
        other = disc(other)
        centre = self.centre + other.centre
        return Disc(centre, self.radius + other.radius + _ROUNDING * (self.size + other.size))

    def __mul__(self, other: Disc | complex) -> Disc:
        other = disc(other)
        size, other_size = self.size, other.size
        with np.errstate(invalid="ignore", over="ignore"):  # 0 times infinity is NaN: no bound
            # Exact factors, such as 0.5 and 1j, are frequent and need no second radius.
            if other_size.ndim == 0 and not other.radius:
                return Disc(self.centre * other.centre, other_size * (self.radius + _ROUNDING * size))
            # abs(z w - c d) <= abs(c) r_w + (abs(d) + r_w) r_z.
            radius = size * (other.radius + _ROUNDING * other_size) + (other_size + other.radius) * self.radius
            return Disc(self.centre * other.centre, radius)

    def __neg__(self) -> Disc:
        return Disc(-self.centre, self.radius)

    def __sub__(self, other: Disc | complex) -> Disc:
        return self + -disc(other)

    def __rsub__(self, other: complex) -> Disc:
        return -self + other

    def __truediv__(self, other: Disc | complex) -> Disc:
        return self * disc(other).inverse()

    def __rtruediv__(self, other: complex) -> Disc:
        return disc(other) * self.inverse()

    __radd__, __rmul__ = __add__, __mul__

    def inverse(self) -> Disc:
        """Return discs of 1/z, with an infinite radius for discs that contain 0."""
        size = self.size
        with np.errstate(divide="ignore", invalid="ignore"):
            is_nonzero = self.least > 0.0
            # abs(1/z - 1/c) = abs(z - c) / (abs(c) abs(z)).
            radius = np.where(is_nonzero, self.radius / (size * self.least) + _ROUNDING / self.least, np.inf)
            return Disc(np.where(is_nonzero, 1.0 / self.centre, 0.0), radius)

    def sqrt(self) -> Disc:
        """Return discs of the root with a positive real part; the radius is infinite unless real parts are > 0."""
        # In the right half plane the principal root is analytic: certificate, section 14, "Discs".
        is_right = self.centre.real * (1.0 - _ROUNDING) > self.radius
        root = np.sqrt(np.where(is_right, self.centre, 1.0))
        # sqrt(a) - sqrt(b) = (a - b) / (sqrt(a) + sqrt(b)). Both roots are within 45 degrees of the real axis, so
        # that the modulus of their sum is at least the modulus of the root at the centre.
        radius = np.where(is_right, self.radius / np.abs(root) + _ROUNDING * np.abs(root), np.inf)
        return Disc(root, radius)


def disc(value: Disc | complex | NDArray[np.complex128]) -> Disc:
    """Return a disc unchanged, or numbers as discs of radius 0."""
    if isinstance(value, Disc):
        return value
    centre = np.asarray(value, dtype=np.complex128)
    return Disc(centre, np.zeros(centre.shape))


def cosine_and_sinc(square: Disc) -> tuple[Disc, Disc]:
    """Return discs of ``cos(z)`` and ``sin(z) / z`` from discs of ``z^2``; both are entire functions of z^2."""
    # The derivatives by z^2 are -sinc(z) / 2 and -int_0^1 s^2 sinc(s z) ds / 2, with
    # abs(sinc z) <= exp(abs(Im z)) min(1, 1 / abs(z)).
    z = np.sqrt(square.centre)
    # Near 0, sin(z) / z is computed by two terms of its series, exact to 1e-17, to avoid 0 / 0.
    is_small = np.abs(z) < 1e-4
    divisor = np.where(is_small, 1.0, z)
    sinc = np.where(is_small, 1.0 - square.centre / 6.0, np.sin(divisor) / divisor)
    # abs(Im z) = sqrt((abs(z^2) - Re z^2) / 2); within the disc, (Im z)^2 is larger by at most the radius.
    height = np.exp(np.sqrt(z.imag**2 + square.radius) * (1.0 + _ROUNDING))
    extent = height * (square.radius + 4.0 * _ROUNDING * (1.0 + np.abs(square.centre)))
    size = np.maximum(np.sqrt(square.least), 1.0)
    slope = np.minimum(1.0 / 6.0, (1.0 + 1.0 / size) / (2.0 * size**2))
    return Disc(np.cos(z), 0.5 * extent / size), Disc(sinc, extent * slope + _ROUNDING * height)


def windings(values: Disc) -> NDArray[np.int_]:
    """Return the winding numbers around 0 of closed curves covered by discs along the last axis; -1 if unknown."""
    # Neighbouring discs share a point of the curve. If no disc contains 0, the argument changes by less than pi
    # between neighbouring centres. For a function analytic inside the curve, the result is the number of zeros.
    is_known = np.asarray((values.least > 0.0).all(axis=-1))
    x, y = values.centre.real, values.centre.imag
    with np.errstate(invalid="ignore", over="ignore"):
        next_x, next_y = np.roll(x, -1, axis=-1), np.roll(y, -1, axis=-1)
        rotation = x * next_y - y * next_x  # its sign is the sign of the change of the argument
        # Crossings of the negative real axis, in both directions.
        downward = (y >= 0.0) & (next_y < 0.0) & (rotation > 0.0)
        upward = (y < 0.0) & (next_y >= 0.0) & (rotation < 0.0)
    return np.where(is_known, downward.sum(axis=-1) - upward.sum(axis=-1), -1)
