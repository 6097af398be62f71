"""Photographs of continuous scenes, made without this package.

8 x 8 points a pixel, the defocused transfer function by its own quadrature of Hopkins's integral, thin-lens formulas,
photons and read noise, integers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
import scipy.fft

POINTS = 8  # a pixel, along either axis
_X, _W = np.polynomial.legendre.leggauss(120)


def hopkins(d: np.ndarray, defocus: float, spherical: float = 0.0) -> np.ndarray:
    """The OTF of a circular pupil with the phase 2 C rho^2 + 2 pi W040 rho^4, at frequencies over the cut-off."""
    out = np.zeros(d.shape)
    inside = d < 1.0
    s = d[inside][:, None]
    t = 0.5 * (_X + 1.0)
    # Points of the overlap at x = (1 - s)(1 - t^2) from the middle: no root at the end.
    x = (1.0 - s) * (1.0 - t * t)
    height = np.sqrt(np.maximum(1.0 - (x + s) ** 2, 0.0))
    share = np.cos(8.0 * defocus * s * x)
    if spherical:
        # The mean over y, from -height to height, of the cosine of the difference of the phases at x + s and x - s.
        y, weight = np.polynomial.legendre.leggauss(40)
        bend = x[..., None] ** 2 + s[..., None] ** 2 + (height[..., None] * y) ** 2
        phases = 8.0 * (s * x)[..., None] * (defocus + 2.0 * np.pi * spherical * bend)
        share = 0.5 * np.cos(phases) @ weight
    out[inside] = (4.0 / np.pi * height * share * (1.0 - s) * t * _W).sum(axis=1)
    return out


@dataclass(frozen=True)
class ThinLens:
    """A lens focused at `focus`: metres."""

    focal_length: float
    f_number: float
    focus: float
    wavelength: float
    pixel: float
    spherical: float = 0.0  # W040, waves

    def defocus(self, distance: float) -> float:
        """C_d in radians: half the quadratic phase at the edge of the pupil."""
        radius = 0.5 * self.focal_length / self.f_number
        return float(np.pi * radius**2 / (2.0 * self.wavelength) * (1.0 / distance - 1.0 / self.focus))

    def working(self) -> float:
        """The image-side f-number."""
        return self.f_number / (1.0 - self.focal_length / self.focus)

    def transfer(self, distance: float, side: int) -> np.ndarray:
        """The OTF at the frequencies of a transform of side x side points."""
        return _transfer(self, distance, side)


@lru_cache(maxsize=32)
def _transfer(lens: ThinLens, distance: float, side: int) -> np.ndarray:
    down, across = np.fft.fftfreq(side, 1.0 / POINTS), np.fft.rfftfreq(side, 1.0 / POINTS)
    f = np.hypot(down[:, None], across)
    cutoff = lens.pixel / (lens.wavelength * lens.working())
    nodes = np.linspace(0.0, cutoff, 1500)
    return np.interp(f, nodes, hopkins(nodes / cutoff, lens.defocus(distance), lens.spherical), right=0.0)


@lru_cache(maxsize=16)
def texture(kind: str, side: int, seed: int = 0, contrast: float = 0.2) -> np.ndarray:
    """A periodic texture of mean 1 on points.

    "pink" of spectrum 1/f^2, "steep" of 1/f^3, opaque "leaves", "soft", "fine" noise of a third of a pixel, "dots" of
    1 to 3 pixels, and "text", squares of a pixel.
    """
    draw, points = np.random.default_rng(seed), side * POINTS
    if kind in ("pink", "steep", "soft", "fine"):
        f = np.hypot(np.fft.fftfreq(points, 1.0 / POINTS)[:, None], np.fft.rfftfreq(points, 1.0 / POINTS))
        spectrum = scipy.fft.rfft2(draw.standard_normal((points, points)))
        shaped = (
            spectrum / np.maximum(f, 1.0 / 64.0) ** {"pink": 1.0, "steep": 1.5}[kind]
            if kind in ("pink", "steep")
            else spectrum * np.exp(-2.0 * ((1.2 if kind == "soft" else 0.33) * np.pi * f) ** 2)
        )
        shaped[0, 0] = 0.0
        values = scipy.fft.irfft2(shaped, s=(points, points))
    elif kind == "leaves":
        values = np.zeros((points, points))
        for _ in range(20 * side):
            size = min(2.0 * POINTS / np.sqrt(1.0 - draw.random()), 40.0 * POINTS)
            height, width = (max(2, int(size * draw.uniform(0.4, 1.6))) for _ in range(2))
            top, left = draw.integers(0, points, 2)
            rows, columns = (top + np.arange(height)) % points, (left + np.arange(width)) % points
            values[np.ix_(rows, columns)] = draw.random()
    elif kind == "dots":
        values = np.zeros((points, points))
        for _ in range(side * side // 25):
            radius, top, left = POINTS * draw.uniform(0.5, 1.5), *draw.integers(0, points, 2)
            reach = int(radius) + 1
            rows, columns = np.arange(top - reach, top + reach + 1), np.arange(left - reach, left + reach + 1)
            inside = np.hypot(rows[:, None] - top, columns - left) < radius
            place = np.ix_(rows % points, columns % points)
            values[place] = np.maximum(values[place], inside)
    else:
        values = np.kron(draw.random((side, side)) < 0.35, np.ones((POINTS, POINTS))).astype(float)
    values = values - values.mean()
    return np.clip(1.0 + contrast / values.std() * values, 0.05, None)


def averaged(points: np.ndarray) -> np.ndarray:
    """Averages over pixels."""
    side = points.shape[0] // POINTS
    return points.reshape(side, POINTS, side, POINTS).mean(axis=(1, 3))


def blurred(points: np.ndarray, lens: ThinLens, distance: float) -> np.ndarray:
    """The light of a plane, on points."""
    spectrum = scipy.fft.rfft2(points)
    return scipy.fft.irfft2(spectrum * lens.transfer(distance, len(points)), s=points.shape)


def plane(points: np.ndarray, lenses: Sequence[ThinLens], distance: float, light: float) -> list[np.ndarray]:
    """Electrons of the pixels of a plane, in frames of each lens."""
    return [light * averaged(blurred(points, lens, distance)) for lens in lenses]


def before(
    front: np.ndarray,
    mask: np.ndarray,
    near: float,
    back: np.ndarray,
    far: float,
    lenses: Sequence[ThinLens],
    light: float,
) -> list[np.ndarray]:
    """Electrons where a plane, there where the mask is 1, hides another."""
    out = []
    for lens in lenses:
        hidden, seen = blurred(mask, lens, near), blurred(front * mask, lens, near)
        out.append(light * averaged(seen + (1.0 - hidden) * blurred(back, lens, far)))
    return out


def record(electrons: Sequence[np.ndarray], seed: int, read: float = 3.0, offset: float = 100.0) -> list[np.ndarray]:
    """What a camera of 1 electron a count stores, uint16."""
    draw = np.random.default_rng(seed)
    noisy = [draw.poisson(np.maximum(one, 0.0)) + draw.normal(0.0, read, one.shape) + offset for one in electrons]
    return [np.clip(np.round(one), 0, 65535).astype(np.uint16) for one in noisy]


def lommel_lens(lens: ThinLens) -> Any:
    """The same lens, as this package has it."""
    import lommel as lm

    return lm.Lens(
        focal_length=lens.focal_length,
        f_number=lens.f_number,
        focus_distance=lens.focus,
        wavelength=lens.wavelength,
        aberrations=lm.Wavefront.from_seidel(W040=lens.spherical),
    )
