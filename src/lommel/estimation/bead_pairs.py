"""Pairs of beads that touch: their images are the sum of two, nearer to each other than a search for spots resolves.

The power of the spatial frequencies of a stack, summed over its planes, is that of one bead times the fringes of two
points, ``|1 + r exp(2 pi i f . d)|^2``. Aberrations change the power smoothly, and drift not at all.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import scipy

from lommel.base.arrays import Array
from lommel.estimation.bead_images import Setup, Stack

_BAND = 0.65  # of the frequencies that pass the objective: beyond, aberrations leave little light
_LEAST_POWER = 2e-3  # of a bead without aberrations, relative to frequency 0
_MODEL_ERROR = 0.05  # relative error of the power, besides noise
_LEAST_LIGHT = 10.0  # power of the light over that of its noise below which there is nothing to see
_DISTANCES = np.arange(1.0, 4.1, 0.25)  # at which the search starts, in periods of the finest fringes that pass
_ANGLES = np.linspace(0.0, np.pi, 12, endpoint=False)
_SHARES = 0.4, 0.8  # light of the fainter bead over that of the brighter one
_LEAST_SHARE = 0.3  # below, strong aberrations look alike
_GAIN = (
    0.35  # largest sum of squares of a pair, over that of a bead with a smooth power; of aberrations: 0.5 and more
)


class Pair(NamedTuple):
    """Distance of the beads of a pair, metres, and the light of the fainter one relative to the brighter."""

    distance: float
    share: float


def touching(stack: Stack, bead: Array, setup: Setup) -> Pair | None:
    """Return the pair of beads that a stack shows, None for a single bead.

    `bead` is the image (planes, height, width) of a bead with the aberrations that are known before the fit.
    """
    counted, read, valid = stack.planes
    sides = [scipy.fft.next_fast_len(2 * side, real=True) for side in stack.shape]
    edges = [1.0 - (1.0 - np.hanning(side + 2)[1:-1]) ** 4 for side in stack.shape]
    window = np.outer(*edges)
    levels = [
        float(np.median(light[known])) if known.any() else 0.0 for light, known in zip(counted, valid, strict=True)
    ]
    images = np.where(valid, counted - np.reshape(levels, (-1, 1, 1)), 0.0)
    power, ideal = (
        (np.abs(np.fft.rfft2((part - np.median(part, axis=(1, 2), keepdims=True)) * window, sides)) ** 2).sum(axis=0)
        for part in (images, bead)
    )
    noise = float((np.maximum(counted + read, 0.0) * valid * window**2).sum())
    total = float(power[0, 0]) - noise
    if total < _LEAST_LIGHT * noise:
        return None
    pitch = setup.pixel / setup.objective.magnification
    finest = 2.0 * setup.objective.NA / setup.wavelength
    axes = np.fft.fftfreq(sides[0]), np.fft.rfftfreq(sides[1])
    y, x = np.meshgrid(*(axis / (pitch * finest) for axis in axes), indexing="ij")
    square, ideal = x * x + y * y, ideal / ideal[0, 0]
    used = (square < _BAND**2) & (square > 0.0) & (ideal > _LEAST_POWER)
    y, x, square, ideal = y[used], x[used], square[used], ideal[used]
    found, noise = (power[used] - noise) / total, noise / total
    ratio = found / ideal
    errors = np.sqrt(2.0 * np.maximum(found, noise) * noise + noise**2) / ideal + _MODEL_ERROR * np.maximum(
        ratio, 0.02
    )

    def smooth(p: Array) -> Array:
        return np.asarray((np.exp(-p[0] * x * x - p[1] * y * y - p[2] * x * y) - ratio) / errors)

    def pair(p: Array) -> Array:
        fringes = 1.0 + p[0] ** 2 + 2.0 * p[0] * np.cos(2.0 * np.pi * (p[1] * y + p[2] * x))
        return np.asarray((fringes / (1.0 + p[0]) ** 2 * np.exp(-p[3] * square) - ratio) / errors)

    starts = [
        np.array([share, distance * np.sin(angle), distance * np.cos(angle), 3.0])
        for share in _SHARES for distance in _DISTANCES for angle in _ANGLES
    ]  # fmt: skip
    start = min(starts, key=lambda p: float(pair(p) @ pair(p)))
    bounds = [0.0, -9.0, -9.0, -2.0], [1.0, 9.0, 9.0, 90.0]
    two = scipy.optimize.least_squares(pair, start, bounds=bounds)
    one = scipy.optimize.least_squares(smooth, [3.0, 3.0, 0.0])
    if two.x[0] < _LEAST_SHARE or two.cost > _GAIN * one.cost:
        return None
    return Pair(float(np.hypot(two.x[1], two.x[2])) / finest, float(two.x[0]))
