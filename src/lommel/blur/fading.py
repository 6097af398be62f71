r"""Transfer function of isotropic blur in the complex plane, and how much of it is left beyond a frequency.

Frequencies f are over the cutoff of the optics, ``f = F x^3``: in x Kolmogorov's ``f^(5/3)`` and von Karman's
structure function are entire (docs/certificate.md, section 17). A disc of x is given by its centre and radius.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.blur.blurs import KOLMOGOROV, Blur, Jitter, Seeing, karman

_NU = 5.0 / 6.0
_NEAR = 4.0  # up to which the series of z^nu K_nu is summed
_TERMS = 30
_STEPS: Array = 1.01 ** np.arange(-1600.0, 1.0)  # of f over the cutoff
FURTHER: Array = 1.01 ** np.arange(-1600.0, 141.0)
"""Frequencies up to 4 times the cutoff."""


class Karman(NamedTuple):
    """Half of von Karman's structure function, ``size (all - z^nu K_nu(z))``, ``z = rate f``."""

    size: float
    rate: float

    def least(self, z: NDArray[np.complex128], power: NDArray[np.complex128], wide: Array) -> Array:
        """Bound its real part from below on discs of x; `power` is ``z^(5/3)``, `wide` the largest abs(z)."""
        far = self.size * math.gamma(_NU) * 2.0 ** (_NU - 1.0)
        inside = np.minimum(wide, _NEAR)
        with np.errstate(over="ignore", invalid="ignore"):
            # All coefficients in x count by their moduli in what changes between the centre and the rim.
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
        first, second = np.zeros(square.shape, complex), np.zeros(square.shape, complex)
        for a, b in zip(rising[::-1], even[::-1], strict=True):
            first, second = first * square + a, second * square + b
        return np.asarray(self.size * (2.0**-_NU * power * first + sign * 2.0**_NU * second))


@lru_cache(maxsize=1)
def _coefficients() -> tuple[Array, Array]:
    k, factor = np.arange(_TERMS), 0.5 * math.pi / math.sin(math.pi * _NU)
    gamma = scipy.special.gamma
    even = factor / (gamma(k + 1.0) * gamma(k + 1.0 - _NU))
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
        """Return that of several blurs, None where they depend on the direction; one lambda*N is `scale`."""
        kolmogorov = gauss = 0.0
        outer = []
        for blur in several:
            (xx, xy), (_, yy) = blur.covariance
            if blur.streak != (0.0, 0.0) or abs(xy) > 1e-15 * xx or abs(xx - yy) > 1e-15 * xx:
                return None
            gauss += 2.0 * math.pi**2 * float(xx) / scale**2
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
        """Return isotropic blur whose transfer function is nowhere below the modulus of that of several blurs."""
        covariance = sum((blur.covariance for blur in several), np.zeros((2, 2)))
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
        # The step to the first counts as well: T is at most 1 there.
        pieces = 0.5 * self.at(steps[:-1]) * (steps[1:] ** 2 - steps[:-1] ** 2)
        return np.append(np.cumsum(pieces[::-1])[::-1], 0.0)

    @property
    def light(self) -> float:
        """Bound on ``int T f df`` from 0 to 1."""
        return float(self.remaining()[0] + 0.5 * _STEPS[0] ** 2)

    def end(self, left: float, steps: Array = _STEPS) -> tuple[float, float]:
        """Return from where on ``int T f df`` up to the last step is at most `left`, and a bound on that."""
        remaining = self.remaining(steps)
        first = int(np.argmax(remaining <= left))
        return float(steps[first]), float(remaining[first])
