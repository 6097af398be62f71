"""prysm: psf.fwhm of an Airy pattern, whose full width at half maximum is 1.0290 lambda N."""

import numpy as np
from prysm import psf
from prysm.coordinates import uniform_cart_to_polar
from scipy.special import j1


def airy(dx):
    """Return an Airy pattern with samples dx apart."""
    half = int(6.4 / dx)
    y, x = np.mgrid[-half:half, -half:half] * dx
    v = np.pi * np.hypot(x, y)
    v[half, half] = 1.0
    image = (2 * j1(v) / v) ** 2
    image[half, half] = 1.0
    return image


def crossing(image, dx):
    """Return the width by linear interpolation between the samples on both sides of half the maximum."""
    y, x = ((np.arange(n) - n // 2) * dx for n in image.shape)
    r, _, polar = uniform_cart_to_polar(x, y, image)
    half = polar.max() / 2
    last = polar.shape[1] - 1 - np.argmax((polar > half)[:, ::-1], axis=1)
    rows = np.arange(len(polar))
    above, below = polar[rows, last], polar[rows, last + 1]
    return 2 * np.mean(r[last] + (above - half) / (above - below) * r[1])


for dx in (0.05, 0.1, 0.2):
    for criteria in ("last", "first"):
        width = float(psf.fwhm(airy(dx), dx=dx, criteria=criteria))
        print(f"dx={dx}, criteria={criteria!r}: {width:.4f}, exact 1.0290")
for dx in (0.05, 0.1, 0.2):
    print(f"dx={dx}, interpolated: {crossing(airy(dx), dx):.4f}")
