"""What is imaged: balls, stacks of points and filaments, and textures in layers that hide each other."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np
from scipy.interpolate import CubicSpline

from tests.world.optics import Objective, Transfer, Waves, disc

FINE = 8  # subpixels along a pixel of a texture
Profile: TypeAlias = Callable[[np.ndarray, float, np.ndarray], np.ndarray]  # of radii, a depth and foci
Point: TypeAlias = tuple[float, float, float, float]  # row, column (pixels), depth (metres), photons a plane


def ball(objective: Objective, diameter: float, depth: float, focus: float, waves: Waves = ()) -> Transfer:
    """Return the transfer function of an evenly filled ball: discs at three heights (exact to degree 5)."""
    radius = diameter / 2
    parts = []
    for height, weight in ((-np.sqrt(3 / 7), 7 / 30), (0.0, 8 / 15), (np.sqrt(3 / 7), 7 / 30)):
        one = objective.transfer(depth + height * radius, focus, waves)
        parts.append(weight * one.times(disc(radius * np.sqrt(1 - height**2), one.radius)).values)
    return Transfer(np.sum(parts, axis=0), one.frequency)


def volume(
    objective: Objective, points: Sequence[Point], foci: np.ndarray, side: int, pixel: float, nodes: int = 12,
    profile: Profile | None = None, samples: int = 3,
) -> np.ndarray:  # fmt: skip
    """Return a stack (foci, side, side) of points, each seen from its own depth: between nodes light is linear.

    `profile` is that of an image, by default of `objective`; `samples` are those along a side of a pixel.
    """
    profile = profile or objective.profile
    depths = np.array([point[2] for point in points])
    at = np.linspace(depths.min() - 1e-9, depths.max() + 1e-9, nodes)
    r = np.arange(0, 1.5 * side * pixel, 10e-9)
    profiles = [CubicSpline(r, profile(r, depth, foci).T) for depth in at]
    made = np.zeros((len(foci), side, side))
    for row, column, depth, photons in points:
        k = min(int((depth - at[0]) / (at[1] - at[0])), nodes - 2)
        share = (depth - at[k]) / (at[1] - at[0])
        for one, part in ((profiles[k], 1 - share), (profiles[k + 1], share)):
            made += photons * part * _pixels(one, side, row, column, pixel, samples)
    return made


def confocal(emission: Objective, excitation: Objective, pinhole: float) -> Profile:
    """Return the part of the light that a scan records; `pinhole` is the radius in the sample."""
    across, weight = np.polynomial.legendre.leggauss(8)
    turn = np.pi * (np.arange(12) + 0.5) / 12
    rings = pinhole * np.sqrt(0.5 * (across + 1))  # equal areas

    def profile(r: np.ndarray, depth: float, foci: np.ndarray) -> np.ndarray:
        seen = CubicSpline(fine := np.append(r, r[-1] + pinhole), emission.profile(fine, depth, foci), axis=1)
        apart = np.sqrt(r**2 + rings[:, None, None] ** 2 - 2 * r * rings[:, None, None] * np.cos(turn[:, None]))
        passed = np.einsum("zktr,k->zr", seen(apart), weight / 24) * np.pi * pinhole**2
        spot = excitation.profile(r, depth, foci)
        return passed * spot / excitation.profile(np.zeros(1), depth, [excitation.brightest(depth)])

    return profile


def sheet(emission: Objective, thickness: float) -> Profile:
    """Return the light per area of a point in a Gaussian light sheet, which stays in the focal plane."""
    return lambda r, depth, foci: lit(emission, thickness, depth, foci)[:, None] * emission.profile(r, depth, foci)


def lit(emission: Objective, thickness: float, depth: float, foci: np.ndarray) -> np.ndarray:
    """Return the light on a point at a depth, relative to the middle of such a sheet."""
    stage, step = emission.brightest(depth), 0.5e-6
    rate = (emission.brightest(depth + step) - emission.brightest(depth - step)) / (2 * step)
    return np.exp(-4 * np.log(2) * ((foci - stage) / rate / thickness) ** 2)


def _pixels(profile: CubicSpline, side: int, row: float, column: float, pixel: float, samples: int) -> np.ndarray:
    x, w = np.polynomial.legendre.leggauss(samples)
    y, q = (((np.arange(side)[:, None] + x / 2).ravel() - place) * pixel for place in (row, column))
    light = profile(np.hypot(y[:, None], q[None])).reshape(side, samples, side, samples, -1)
    return np.einsum("asbtz,s,t->zab", light, w / 2, w / 2) * pixel**2


def beads(count: int, side: int, depths: tuple[float, float], draw: np.random.Generator) -> list[Point]:
    """Return points of 4e3 to 2e4 photons a plane."""
    return [(*draw.uniform(6, side - 7, 2), draw.uniform(*depths), draw.uniform(4e3, 2e4)) for _ in range(count)]


def filaments(count: int, side: int, depths: tuple[float, float], draw: np.random.Generator) -> list[Point]:
    """Return curves of 60 points, 2.5e4 photons a plane each."""
    points: list[Point] = []
    for _ in range(count):
        start, end, bow = draw.uniform(4, side - 5, 2), draw.uniform(4, side - 5, 2), draw.uniform(-6, 6, 2)
        first, last = draw.uniform(*depths, 2)
        for t in np.linspace(0, 1, 60):
            row, column = start + (end - start) * t + bow * np.sin(np.pi * t)
            points.append((row, column, first + (last - first) * t, 2.5e4 / 60))
    return points


def texture(shape: tuple[int, int], size: float, seed: int, contrast: float = 0.15) -> np.ndarray:
    """Return a texture at FINE x FINE subpixels: Gaussian noise, smooth over `size` pixels, about 0.5."""
    fine = tuple(FINE * side for side in shape)
    down, across = (np.fft.fftfreq(side) * FINE for side in fine)
    smooth = np.exp(-2 * (np.pi * size) ** 2 * (down[:, None] ** 2 + across[None] ** 2))
    made = np.fft.ifft2(np.fft.fft2(np.random.default_rng(seed).normal(size=fine)) * smooth).real
    return np.clip(0.5 + contrast * made / made.std(), 0.02, 1.0)


def photograph(
    layers: Sequence[tuple[np.ndarray, np.ndarray, Callable[[np.ndarray, np.ndarray], np.ndarray]]],
) -> np.ndarray:
    """Return the light on pixels of layers, the nearest first: texture, where it is opaque, transfer function.

    A transfer function takes frequencies along rows and columns, cycles per pixel. Behind a layer there is as much
    light as the blur of its cover leaves, which is not exact within the blur of its edges.
    """
    light, left = 0.0, 1.0
    for picture, cover, transfer in layers:
        fine = picture.shape
        down, across = np.fft.fftfreq(fine[0])[:, None] * FINE, np.fft.rfftfreq(fine[1])[None] * FINE
        factor = transfer(down, across)
        blurred, covered = (
            np.fft.irfft2(np.fft.rfft2(one) * factor, fine) for one in (picture * cover, cover.astype(float))
        )
        light, left = light + left * blurred, left * (1 - np.clip(covered, 0, 1))
    rows, columns = (side // FINE for side in fine)
    return light.reshape(rows, FINE, columns, FINE).mean((1, 3))
