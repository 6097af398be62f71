"""Photographs of textured planes, by the PSFs of points alone, and the cameras that take them."""

from __future__ import annotations

import numpy as np
from scipy.signal import fftconvolve

import lommel as lm

PIXEL = 4e-6
LENS = lm.Lens(focal_length=35e-3, f_number=8.0, focus_distance=1.35, wavelength=540e-9)
PAIR = [LENS, LENS.focused(1.8)]
NOISE = lm.Noise(white=1e4, read=3.0)
CAMERA = {"encoding": "linear", "noise": NOISE, "between": (1.2, 2.0)}


def texture(side=112, contrast=0.35, seed=0, mean=0.5):
    """Light whose power falls as the squared frequency."""
    f = np.fft.fftfreq(side)
    square = f[:, None] ** 2 + f**2
    square[0, 0] = np.inf
    noise = np.fft.fft2(np.random.default_rng(seed).normal(size=(side, side)))
    values = np.fft.ifft2(noise / np.sqrt(square)).real
    return np.maximum(mean * (1.0 + contrast * values / values.std()), 0.01)


def shoot(scene, distance, lenses, seed=1, exposures=None, noise=NOISE):
    """Photographs of a plane, 16 pixels less on each side, by the PSF itself."""
    out = []
    for k, lens in enumerate(lenses):
        psf = lm.psf(lens.pupil(distance), 41, PIXEL, integrate=True, dtype=np.float64).values
        light = fftconvolve(scene, psf / psf.sum(), mode="same")[16:-16, 16:-16]
        share = 1.0 if exposures is None else exposures[k]
        out.append(noise.record(noise.white * share * np.maximum(light, 0.0), seed=seed + k))
    return out
