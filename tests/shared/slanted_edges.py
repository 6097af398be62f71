"""Pictures of slanted edges by the integral of a Gaussian, and their responses."""

from __future__ import annotations

import numpy as np
from scipy.special import erf


def picture(degrees, sigma=0.5, shape=(80, 120), fine=16, curvature=0.0):
    """Return an edge blurred by a Gaussian (pixels rms); each pixel is the mean of many points of the integral.

    A curved edge is displaced by `curvature` (1 / pixels) times the square of the row from the middle.
    """
    y, x = ((np.arange(side * fine) + 0.5) / fine - 0.5 * side for side in shape)
    turn = np.radians(degrees)
    points = 0.5 + 0.4 * erf(
        (x + np.tan(turn) * y[:, None] + curvature * y[:, None] ** 2) * np.cos(turn) / sigma / np.sqrt(2.0)
    )
    return points.reshape(shape[0], fine, shape[1], fine).mean(axis=(1, 3))


def gaussian(frequencies, angle, sigma=0.5):
    """Return the response of this blur and of the pixel, at cycles per pixel."""
    pixel = np.sinc(frequencies * np.cos(angle)) * np.sinc(frequencies * np.sin(angle))
    return np.exp(-2.0 * (np.pi * sigma * frequencies) ** 2) * pixel


TURN = np.radians(6.0)


def across(d, sigma):
    """Return the profile of an edge; the pixel is a Gaussian of equal variance."""
    return 0.5 * (1.0 + erf(d / np.sqrt(2.0 * (sigma**2 + 1.0 / 12.0))))


def squares(shape, places, side, sigma):
    """Return dark squares on white, turned by 6 degrees, with middles at places from the middle (right, down)."""
    y, x = np.ogrid[: shape[0], : shape[1]]
    x, y = x - 0.5 * (shape[1] - 1), y - 0.5 * (shape[0] - 1)
    light = np.full(shape, 0.9)
    for right, down in places:
        u = (x - right) * np.cos(TURN) + (y - down) * np.sin(TURN)
        v = (y - down) * np.cos(TURN) - (x - right) * np.sin(TURN)
        covered = [across(d + side / 2, sigma) - across(d - side / 2, sigma) for d in (u, v)]
        light -= 0.8 * covered[0] * covered[1]
    return light
