"""Likelihood of a blur by the power spectrum; textures are filtered noise, without this package."""

from __future__ import annotations

import numpy as np
from scipy.special import j1

from lommel.imaging.blur_spectrum import FREQUENCIES, BlurSpectrum


def disc(f: np.ndarray, diameter: np.ndarray | float) -> np.ndarray:
    """Return the transfer function of a uniform disc."""
    x = np.pi * f * diameter
    return 2.0 * j1(x) / x


def test_window_does_not_bias_the_likeliest_diameter():
    """The window and the rings fill the zeros of the spectrum, which without their average gave 7.92 pixels."""
    side, count, diameter = 96, 4, 8.0
    draw = np.random.default_rng(0)
    sides = (side * count, side * count)
    fy, fx = np.fft.fftfreq(sides[0])[:, None], np.fft.rfftfreq(sides[1])
    f = np.maximum(np.hypot(fy, fx), 0.5 / side)
    spectrum = np.fft.rfft2(draw.standard_normal(sides)) * disc(f, diameter) * np.sinc(fy) * np.sinc(fx) / f**1.25
    texture = np.fft.irfft2(spectrum, sides)
    photo = texture / texture.std() * 30.0 + draw.standard_normal(sides)
    diameters = np.linspace(7.7, 8.3, 25)
    curves, unit = disc(FREQUENCIES, diameters[:, None]), np.ones((1, side, side))
    likelihood = np.zeros(len(diameters))
    for tile in photo.reshape(count, side, count, side).swapaxes(1, 2).reshape(-1, 1, side, side):
        likelihood += BlurSpectrum.windowed(tile, unit).likelihood(curves, 0, 1.0)
    assert abs(diameters[np.argmax(likelihood)] - diameter) < 0.04
