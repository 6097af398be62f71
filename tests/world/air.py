"""What air and tracking do to light: transfer functions of long exposures, and phase screens of short ones."""

from __future__ import annotations

import numpy as np
from scipy.special import gamma, kv

ARCSECOND = np.pi / 648000
# Fried's: half of 6.88, in full (24/5 Gamma(6/5))^(5/6); and the width of a long exposure in lambda/r0.
HALF, WIDTH = (24 / 5 * gamma(6 / 5)) ** (5 / 6), 0.9758634


def kolmogorov(frequency: np.ndarray, fwhm: float) -> np.ndarray:
    """Return exp(-D/2) of Kolmogorov's turbulence; `fwhm` in the units of 1 / frequency."""
    return np.exp(-HALF * (frequency * fwhm / WIDTH) ** (5 / 3))


def von_karman(frequency: np.ndarray, fwhm: float, ratio: float) -> np.ndarray:
    """Return that with an outer scale of `ratio` times r0; `fwhm` is that of Kolmogorov's of the same r0."""
    x = np.maximum(2 * np.pi * frequency * fwhm / WIDTH / ratio, 1e-12)
    constant = 2 ** (1 / 6) * gamma(11 / 6) / np.pi ** (8 / 3) * HALF
    structure = constant * ratio ** (5 / 3) * (gamma(5 / 6) / 2 ** (1 / 6) - x ** (5 / 6) * kv(5 / 6, x))
    return np.exp(-structure / 2)


def gaussian(frequency: np.ndarray, sigma: float) -> np.ndarray:
    """Return the transform of a Gaussian of a standard deviation."""
    return np.exp(-2 * (np.pi * frequency * sigma) ** 2)


def moffat(frequency: np.ndarray, fwhm: float, beta: float) -> np.ndarray:
    """Return the transform of Moffat's profile."""
    x = np.maximum(np.pi * frequency * fwhm / np.sqrt(2 ** (1 / beta) - 1), 1e-9)
    return np.where(x > 500, 0.0, 2 * (x / 2) ** (beta - 1) / gamma(beta - 1) * kv(beta - 1, np.minimum(x, 500)))


def tracking(down: np.ndarray, across: np.ndarray, length: float, angle: float) -> np.ndarray:
    """Return the transform of an even line of a length."""
    return np.sinc(length * (across * np.cos(angle) + down * np.sin(angle)))


def screens(side: int, ratio: float, count: int, draw: np.random.Generator) -> np.ndarray:
    """Return phases over `side` cells across an aperture of `ratio` r0 by Kolmogorov: (count, side, side).

    By FFTs four apertures wide, with seven levels of lower frequencies (Lane 1992).
    """
    wide = 4 * side
    power = 0.0229 * ratio ** (5 / 3)
    frequency = np.fft.fftfreq(wide, 1 / side)  # of an aperture
    f = np.hypot(frequency[:, None], frequency[None])
    f[0, 0] = np.inf
    for p, q in np.ndindex(3, 3):
        if p != 1 or q != 1:
            f[p - 1, q - 1] *= _around(p - 1, q - 1) ** (-3 / 11)
    made = np.empty((count, side, side))
    x = np.arange(side) / side
    for k in range(0, count, 2):
        noise = draw.normal(size=(2, wide, wide))
        whole = np.fft.fft2((noise[0] + 1j * noise[1]) * np.sqrt(power) * f ** (-11 / 6) / 4)[:side, :side]
        for level in range(1, 8):
            step = 0.25 / 3**level
            for p, q in ((p, q) for p in (-1, 0, 1) for q in (-1, 0, 1) if p or q):
                size = np.sqrt(power * _around(p, q)) * (step * np.hypot(p, q)) ** (-11 / 6) * step
                wave = np.exp(2j * np.pi * step * (p * x[:, None] + q * x[None]))
                whole = whole + size * complex(*draw.normal(size=2)) * wave
        made[k : k + 2] = np.array([whole.real, whole.imag])[: count - k]
    return made


def _around(p: int, q: int) -> float:
    """Return the mean of what frequencies around (p, q) move light by, over that of the middle: f^(-5/3)."""
    x = (np.arange(40) + 0.5) / 40 - 0.5
    return float((np.hypot(p + x[:, None], q + x[None]) ** (-5 / 3)).mean() / np.hypot(p, q) ** (-5 / 3))
