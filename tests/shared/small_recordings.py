"""Small recordings of each kind: stars, a bead, a stack, a sky, a movie and photographs, with their cameras."""

from __future__ import annotations

from functools import cache

import numpy as np

import lommel as lm
import simulated_movies as simulated
from lommel.base.encoding import from_light
from objectives import OIL
from planes import PAIR, shoot, texture

DEPTH = np.where(np.arange(28) < 13, 2.5, 1.75) * np.ones((24, 1))
NOISES = {
    "retrieve": lm.Noise(white=0.5, read=2.0, offset=100.0),
    "beads": lm.Noise(read=1.6, offset=100.0),
    "deconvolve": lm.Noise(white=1.0, read=1.6, offset=100.0),
    "fit-field": lm.Noise(read=2.0, offset=50.0),
    "localize": lm.Noise(white=0.46, read=1.6, offset=100.0),
}


@cache
def stars() -> np.ndarray:
    """Three images of a star, at -4, 0 and 4 radians of defocus."""
    light = lm.Pupil(lm.Wavefront([-4.0, 0.0, 4.0], nonradial={(3, 1): 0.6}), wavelength=550e-9, f_number=4.0)
    mean = 5e4 * lm.psf(light, (24, 26), 1.1e-6).values + 5.0
    return counts(mean, lm.Noise(white=0.5, read=2.0, offset=100.0))


@cache
def bead() -> np.ndarray:
    """A bead in planes 250 nm apart."""
    pupil = OIL.pupil(depth=2e-6, z=(np.arange(5) - 2) * 250e-9, wavelength=600e-9)
    method = lm.methods.Bead(0.1e-6, 1e-4)
    light = lm.psf(pupil, (11, 13), 6.5e-6, method=method, integrate=True).values
    return counts(1e3 * light + 10.0, lm.Noise(read=1.6, offset=100.0))


@cache
def stack() -> np.ndarray:
    """A spot in planes 250 nm apart."""
    z, y, x = np.indices((5, 16, 20)) - np.array([2, 8, 11])[:, None, None, None]
    return counts(20.0 + 500.0 * np.exp(-(x**2 + y**2) / 8.0 - z**2 / 6.0), lm.Noise(read=1.6, offset=100.0))


@cache
def sky() -> np.ndarray:
    """Four stars at -2.5, 0 and 2.5 radians of defocus."""
    mean = np.full((3, 65, 67), 20.0)
    for plane, defocus in zip(mean, (-2.5, 0.0, 2.5), strict=True):
        wave = lm.Wavefront([defocus], nonradial={(3, 1): 0.5})
        star = lm.psf(lm.Pupil(wave, wavelength=550e-9, f_number=8.0), 25, 2.2e-6).values[0]
        for row, column in ((16, 17), (16, 49), (48, 17), (48, 49)):
            plane[row - 12 : row + 13, column - 12 : column + 13] += 4e4 * star
    return counts(mean, lm.Noise(read=2.0, offset=50.0))


@cache
def movie() -> np.ndarray:
    """Five frames of a molecule."""
    molecules = simulated.spread(5, 48, each=1, apart=20, seed=5)
    return simulated.recorded(simulated.light(molecules, 5, 48, 6.0), NOISES["localize"], 6)[:, :, :47]


def counts(mean: np.ndarray, noise: lm.Noise) -> np.ndarray:
    return np.clip(np.round(noise.record(mean, seed=1)), 0, 65535).astype(np.uint16)


@cache
def grey() -> np.ndarray:
    """A photograph of two planes, in sRGB of 8 bits."""
    scene = np.random.default_rng(0).uniform(0.05, 0.8, (6, 7)).repeat(4, axis=0).repeat(4, axis=1)
    lens = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
    light = lm.imaging.depth_of_field(scene, DEPTH, lens, 30e-6, encoding="linear").values
    seen = lm.Noise(white=5000.0, read=3.0).record(5000.0 * light, seed=1)
    return np.asarray(from_light(np.clip(seen, 0.0, 1.0), "srgb", np.uint8))


@cache
def coloured() -> np.ndarray:
    """The same, a third as bright in red and two thirds in blue."""
    return np.stack([grey() // 3, grey(), 2 * (grey() // 3)], axis=-1)


@cache
def light_of_pair() -> np.ndarray:
    """Photographs of a plane at two focus distances, in linear light."""
    return np.clip(shoot(texture(72), 1.5, PAIR), 0.0, 1.0)


@cache
def pair() -> np.ndarray:
    """The same, in sRGB of 8 bits."""
    return np.asarray(from_light(light_of_pair(), "srgb", np.uint8))
