"""Sharpness of edges; scenes are drawn on 8 x 8 points a pixel and blurred by a disc that is drawn there, too."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import j1

from lommel.imaging.blur_spectrum import FREQUENCIES
from lommel.imaging.edge_spread import sharper_edges

FINE, SIDE, WHITE = 8, 96, 20000.0


def seen(scene: np.ndarray, diameter: float) -> np.ndarray:
    """Return the counts of a scene behind a disc of so many pixels, as a fraction of white."""
    radius = 0.5 * diameter * FINE
    y, x = np.mgrid[-FINE : FINE + 1, -FINE : FINE + 1]
    kernel = np.clip(radius + 0.5 - np.hypot(y, x), 0.0, 1.0)
    padded = np.pad(scene, FINE, mode="reflect")
    transfer = np.fft.rfft2(kernel / kernel.sum(), padded.shape)
    blurred = np.fft.irfft2(np.fft.rfft2(padded) * transfer, padded.shape)[2 * FINE :, 2 * FINE :]
    mean = blurred.reshape(SIDE, FINE, SIDE, FINE).mean(axis=(1, 3))
    return np.random.default_rng(1).poisson(WHITE * np.maximum(mean, 0.0)) / WHITE


def bars() -> np.ndarray:
    """Return bars of 5 to 12 pixels in two directions that are not those of pixels."""
    y, x = np.mgrid[: SIDE * FINE, : SIDE * FINE] / FINE
    draw, steps = np.random.default_rng(2), []
    for angle in (0.35, 1.2):
        along = np.abs(x * np.cos(angle) + y * np.sin(angle))
        steps.append(draw.uniform(0.2, 0.8, 40)[np.searchsorted(np.cumsum(draw.uniform(5.0, 12.0, 39)), along)])
    return np.where(y < x, *steps)


def texture() -> np.ndarray:
    """Return Gaussian noise of power f^-2."""
    f = np.hypot(np.fft.fftfreq(SIDE * FINE)[:, None], np.fft.rfftfreq(SIDE * FINE))
    f[0, 0] = 1.0
    noise = np.fft.irfft2(np.fft.rfft2(np.random.default_rng(3).standard_normal((SIDE * FINE, SIDE * FINE))) / f)
    return np.clip(0.5 + 0.12 * noise / noise.std(), 0.02, 0.98)


def evidence(light: np.ndarray, stated: float) -> float:
    """Return the evidence for less blur than a disc of the stated diameter."""
    x = np.pi * FREQUENCIES * stated * np.array([0.3, 0.6, 1.0])[:, None]
    return sharper_edges(2.0 * j1(x) / x, light, light.clip(0.01) / WHITE)


@pytest.mark.parametrize(("diameter", "stated"), [(0.05, 1.0), (0.05, 1.5), (0.6, 1.5)])
def test_edges_that_are_sharper_than_stated_are_counted(diameter, stated):
    assert evidence(seen(bars(), diameter), stated) > 20.0


@pytest.mark.parametrize(("diameter", "stated"), [(1.0, 1.0), (1.5, 1.5), (2.0, 1.5)])
def test_edges_that_are_as_soft_as_stated_speak_against_less_blur(diameter, stated):
    assert evidence(seen(bars(), diameter), stated) < -20.0


def test_texture_and_uniform_light_say_nothing():
    assert abs(evidence(seen(texture(), 0.05), 1.25)) < 2.5
    assert evidence(np.full((SIDE, SIDE), 0.5), 1.25) == 0.0
    assert evidence(np.full((9, 9), 0.5), 1.25) == 0.0
