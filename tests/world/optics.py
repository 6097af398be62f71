"""Images of points by plain quadrature over the pupil: scalar with vanes, and dipoles under layers by plane waves.

Light on pixels is computed by transfer functions: the autocorrelation of the pupil, on which air, beads and pixels
are factors. Nothing here is of lommel, nor of its tests.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from math import factorial
from typing import TypeAlias

import numpy as np
from scipy.special import j1, jv

Waves: TypeAlias = tuple[tuple[int, float], ...]  # Noll's index and radians rms
FINE = 8  # points along a cell of the pupil, by which its share of light is known


def noll(j: int) -> tuple[int, int]:
    """Return (n, m) of Noll's index, m > 0 a cosine."""
    n, rest = 0, j - 1
    while rest > n:
        n += 1
        rest -= n
    return n, (-1) ** j * ((n % 2) + 2 * ((rest + ((n + 1) % 2)) // 2))


def zernike(j: int, rho: np.ndarray, theta: np.ndarray) -> np.ndarray:
    """Return a Zernike polynomial of unit rms."""
    n, m = noll(j)
    a = abs(m)
    radial = np.zeros_like(rho)
    for s in range((n - a) // 2 + 1):
        below = factorial(s) * factorial((n + a) // 2 - s) * factorial((n - a) // 2 - s)
        radial += (-1) ** s * factorial(n - s) / below * rho ** (n - 2 * s)
    if m == 0:
        return np.sqrt(n + 1) * radial
    return np.sqrt(2 * (n + 1)) * radial * (np.cos(a * theta) if m > 0 else np.sin(a * theta))


def cells(side: int) -> np.ndarray:
    """Return the middles of `side` cells from -1 to 1."""
    return (np.arange(side) + 0.5) / side * 2 - 1


def disc(radius: float, frequency: np.ndarray) -> np.ndarray:
    """Return the transform of an even disc of unit light."""
    argument = np.maximum(2 * np.pi * radius * frequency, 1e-9)
    return 2 * j1(argument) / argument


@dataclass(frozen=True, eq=False)
class Transfer:
    """Transfer function on a square grid of frequencies, cycles per metre, in the order of FFTs."""

    values: np.ndarray
    frequency: np.ndarray

    @property
    def radius(self) -> np.ndarray:
        """Length of each frequency."""
        return np.hypot(self.frequency[:, None], self.frequency[None])

    def times(self, factor: np.ndarray) -> Transfer:
        """Return it with another factor of the light."""
        return Transfer(self.values * factor, self.frequency)

    def image(self, side: int, pixel: float, row: float, column: float) -> np.ndarray:
        """Return the light of a point on pixels, as parts of all; `row` and `column` count from the first pixel."""
        step = self.frequency[1] - self.frequency[0]
        own = np.sinc(self.frequency * pixel) * step * pixel
        down, across = (
            np.exp(-2j * np.pi * np.outer((np.arange(side) - place) * pixel, self.frequency)) * own
            for place in (row, column)
        )
        return (down @ self.values @ across.T).real


def autocorrelation(fields: Iterable[tuple[float, np.ndarray]], share: np.ndarray, cutoff: float) -> Transfer:
    """Return the transfer function of fields in the square around the pupil, each with the weight of its light.

    `share` is how much of each cell is open: a cell that is half open has half of the amplitude, and half of the
    light. `cutoff` is the largest frequency, that of two edges of the pupil.
    """
    side, light, total = len(share), 0.0, 0.0
    for weight, field in fields:
        light = light + weight * np.abs(np.fft.fft2(share * field, (2 * side, 2 * side))) ** 2
        total = total + weight * (share * np.abs(field) ** 2).sum()
    return Transfer(np.fft.ifft2(light) / total, np.fft.fftfreq(2 * side) * 2 * cutoff)


@dataclass(frozen=True)
class Telescope:
    """A round, obscured aperture with crossed vanes, their width in radii; scalar, in focus where C_d is 0.

    Its amplitude falls by exp(-dimmed rho^2), and along rows by exp(-slanted y). The obscuration is `off` the middle
    by radii along rows, and the edge `squeezed` there by a part of the diameter: its mean radius is that of 1.
    """

    wavelength: float = 1.0
    f_number: float = 1.0
    obscuration: float = 0.0
    vanes: float = 0.0
    side: int = 128
    dimmed: float = 0.0
    slanted: float = 0.0
    off: float = 0.0
    squeezed: float = 0.0

    @property
    def cutoff(self) -> float:
        """The largest frequency that it lets through, cycles per metre."""
        return 1 / (self.wavelength * self.f_number * (1 - self.squeezed / 2))

    def transfer(self, waves: Waves = (), defocus: float = 0.0, screen: np.ndarray | float = 0.0) -> Transfer:
        """Return the transfer function of a wavefront, C_d (radians at the edge) and a screen of phases."""
        share, rho, theta = self.aperture
        phase = sum((size * zernike(j, rho, theta) for j, size in waves), start=defocus * rho**2 + screen)
        fall = self.dimmed * rho**2 + self.slanted * rho * np.sin(theta)
        return autocorrelation([(1.0, np.exp(1j * phase - fall))], share, self.cutoff)

    @property
    def aperture(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """How much of each cell is open, and radius and angle of the middle of what is open."""
        return aperture(self.side, self.obscuration, self.vanes, self.off, self.squeezed)


@cache
def aperture(
    side: int, obscuration: float = 0.0, vanes: float = 0.0, off: float = 0.0, squeezed: float = 0.0
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return how much of each cell is open, and radius and angle of the middle of what is open."""
    x = cells(FINE * side)
    y = x[:, None]
    mean = 1 - squeezed / 2
    inside = ((y / (1 - squeezed)) ** 2 + x**2 < 1) & ((y - off) ** 2 + x**2 >= (mean * obscuration) ** 2)
    inside &= (np.abs(x)[:, None] >= vanes / 2) & (np.abs(x)[None] >= vanes / 2)
    share, row, column = (
        (inside * part).reshape(side, FINE, side, FINE).mean((1, 3)) for part in (1.0, x[:, None], x[None])
    )
    some = np.maximum(share, 1e-9)
    return share, np.hypot(row, column) / some / mean, np.arctan2(row, column)


@dataclass(frozen=True)
class Objective:
    """Dipoles that turn freely, below a cover glass under oil, by plane waves (Mortensen 2010, Axelrod 2012).

    `thicker` is by how much the glass is thicker than the design has it, metres. Lengths are those in the sample.
    Dipoles along the axis radiate `axial` of the light of others.
    """

    NA: float = 1.4
    immersion: float = 1.518
    glass: float = 1.5255
    sample: float = 1.33
    wavelength: float = 600e-9
    thicker: float = 0.0
    axial: float = 1.0
    side: int = 96

    @property
    def wavenumber(self) -> float:
        """Of the vacuum."""
        return 2 * np.pi / self.wavelength

    def amplitudes(self, rho: np.ndarray, depth: float) -> tuple[np.ndarray, ...]:
        """Return s and p amplitudes of a dipole at a depth, and the cosines in oil and sample."""
        oil, glass, water = (np.sqrt(1 - (self.NA * rho / n) ** 2 + 0j) for n in self._indices)
        n_oil, n_glass, n_water = self._indices
        path = depth * n_water * water + self.thicker * n_glass * glass
        common = np.sqrt(oil) / water * np.exp(1j * self.wavenumber * path)
        pairs = (n_water, water, n_glass, glass), (n_glass, glass, n_oil, oil)
        s = np.prod([2 * a * ca / (a * ca + b * cb) for a, ca, b, cb in pairs], axis=0)
        p = np.prod([2 * a * ca / (b * ca + a * cb) for a, ca, b, cb in pairs], axis=0)
        return common * s, common * p, oil, water

    @property
    def _indices(self) -> tuple[float, float, float]:
        return self.immersion, self.glass, self.sample

    def transfer(self, depth: float, focus: float, waves: Waves = ()) -> Transfer:
        """Return the transfer function of a point, the stage `focus` metres nearer than where it is at the glass."""
        share, rho, theta = aperture(self.side)
        s, p, oil, water = self.amplitudes(rho, depth)
        phase = sum((size * zernike(j, rho, theta) for j, size in waves), start=0.0)
        common = np.exp(1j * (phase - self.wavenumber * focus * self.immersion * oil))
        cos, sin, along = np.cos(theta), np.sin(theta), self.NA * rho / self.sample
        fields = (
            (1.0, s * sin**2 + p * water * cos**2),
            (2.0, (p * water - s) * sin * cos),
            (1.0, s * cos**2 + p * water * sin**2),
            (self.axial, p * along * cos),
            (self.axial, p * along * sin),
        )
        return autocorrelation(
            ((weight, common * one) for weight, one in fields), share, 2 * self.NA / self.wavelength
        )

    def profile(self, r: np.ndarray, depth: float, foci: Iterable[float]) -> np.ndarray:
        """Return the light per area at radii, as parts of all: (foci, radii), without aberrations."""
        rho, weight = _rings(min(1.0, self.sample / self.NA))
        s, p, oil, water = self.amplitudes(rho, depth)
        phase = np.exp(-1j * self.wavenumber * self.immersion * np.outer(list(foci), oil)) * weight * rho
        parts = s + p * water, s - p * water, np.sqrt(2) * p * self.NA * rho / self.sample
        scale = self.wavenumber * self.NA
        bessel = _bessel(rho.tobytes(), (scale * np.asarray(r)).tobytes())
        light = sum(np.abs((phase * part) @ bessel[k]) ** 2 for k, part in zip((0, 2, 1), parts, strict=True))
        total = sum((weight * rho * np.abs(part) ** 2).sum() for part in parts)
        return light / (2 * np.pi / scale**2 * total)

    def brightest(self, depth: float) -> float:
        """Return the stage at which a point is brightest."""
        return _brightest(self, depth)


@cache
def _brightest(objective: Objective, depth: float) -> float:
    least, most = 0.9 * objective.thicker, 1.3 * objective.thicker  # thick glass moves the focus by about as much
    foci = np.linspace(least - 0.5e-6, most + 2 * depth + 1e-6, 1000)
    light = objective.profile(np.zeros(1), depth, foci)[:, 0]
    k = int(np.clip(light.argmax(), 1, len(foci) - 2))
    a, b, _ = np.polyfit(foci[k - 1 : k + 2] - foci[k], light[k - 1 : k + 2], 2)
    return float(foci[k] - b / (2 * a)) if a < 0 else float(foci[k])


@cache
def _rings(critical: float, nodes: int = 260) -> tuple[np.ndarray, np.ndarray]:
    """Return radii of the pupil and their weights, with the root at the critical angle taken out."""
    x, w = np.polynomial.legendre.leggauss(nodes)
    u, w = (x + 1) / 2, w / 2
    inner = critical * (1 - u**2), w * 2 * u * critical
    outer = critical + (1 - critical) * u**2, w * 2 * u * (1 - critical)
    parts = [inner, outer] if critical < 1 else [(u, w)]
    return np.concatenate([r for r, _ in parts]), np.concatenate([w for _, w in parts])


@cache
def _bessel(rho: bytes, v: bytes) -> tuple[np.ndarray, ...]:
    argument = np.outer(np.frombuffer(rho), np.frombuffer(v))
    return tuple(jv(order, argument) for order in range(3))


def as_waves(sizes: Mapping[int, float]) -> Waves:
    """Return a wavefront as what can be looked up."""
    return tuple(sorted(sizes.items()))
