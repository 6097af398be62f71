"""Stars over a field by a Cartesian matrix Fourier transform, which shares nothing with the package."""

from __future__ import annotations

from math import factorial

import numpy as np
from scipy import ndimage


def noll(j):
    """Return (n, m) of Noll's index, m > 0 a cosine."""
    n, rest = 0, j - 1
    while rest > n:
        n += 1
        rest -= n
    return n, (-1) ** j * ((n % 2) + 2 * ((rest + ((n + 1) % 2)) // 2))


def zernike(n, m, r, t):
    """Return a Zernike polynomial of unit rms over the disc."""
    a = abs(m)
    radial = sum(
        (-1) ** s * factorial(n - s) * r ** (n - 2 * s)
        / (factorial(s) * factorial((n + a) // 2 - s) * factorial((n - a) // 2 - s))
        for s in range((n - a) // 2 + 1)
    )  # fmt: skip
    if m == 0:
        return np.sqrt(n + 1) * radial
    return np.sqrt(2 * (n + 1)) * radial * (np.cos(a * t) if m > 0 else np.sin(a * t))


class Telescope:
    """An aperture on a grid of `side` points, and images of stars through Noll's terms 4, ..., 3 + `terms`."""

    def __init__(self, terms=11, side=160, obscuration=0.0, vanes=()):
        fine = (np.arange(8 * side) + 0.5) / (8 * side) * 2 - 1
        x, y = np.meshgrid(fine, fine)
        inside = (np.hypot(x, y) <= 1) & (np.hypot(x, y) >= obscuration)
        for angle, width in vanes:
            along, across = x * np.cos(angle) + y * np.sin(angle), y * np.cos(angle) - x * np.sin(angle)
            inside &= (along < 0) | (np.abs(across) > width / 2)
        self.aperture = inside.reshape(side, 8, side, 8).mean((1, 3))
        self.grid = (np.arange(side) + 0.5) / side * 2 - 1
        x, y = np.meshgrid(self.grid, self.grid)
        self.rho = np.hypot(x, y)
        self.terms = np.array([zernike(*noll(j), self.rho, np.arctan2(y, x)) for j in range(4, 4 + terms)])

    def image(self, waves, place, pixel, side, sigma, defocus=0.0):
        """Return fractions of all light in pixels, blurred by `sigma` pixels, `place` from the middle pixel."""
        over = 2 * int(np.ceil(pixel / 0.23)) + 1
        pad = int(np.ceil(5 * sigma)) + 1
        pixels = np.arange(-(side // 2) - pad, side - side // 2 + pad)
        points = (pixels[:, None] + (np.arange(over) - (over - 1) / 2) / over).ravel()
        y, x = (pixel * (points - part) for part in place)
        field = self.aperture * np.exp(1j * (np.tensordot(waves, self.terms, 1) + 2 * defocus * self.rho**2))
        made = np.exp(-1j * np.pi * np.outer(y, self.grid)) @ field @ np.exp(-1j * np.pi * np.outer(self.grid, x))
        light = np.abs(made) ** 2 * (pixel / over) ** 2 / (self.aperture.sum() * len(self.grid) ** 2)
        if sigma:
            light = ndimage.gaussian_filter(light, sigma * over, truncate=6, mode="constant")
        summed = light.reshape(len(pixels), over, len(pixels), over).sum((1, 3))
        return summed[pad:-pad, pad:-pad]


def field(draw, terms=11, scale=1.0, degree=3):
    """Return a function of u and v in [-1, 1]: curvature, tilt of the sensor, astigmatism, coma, spherical, more."""
    curvature, astigmatism, coma, spherical = draw.normal(size=4) * [0.20, 0.15, 0.10, 0.08]
    middle, tilt, offset = draw.normal(size=2) * 0.15, draw.normal(size=2) * 0.10, draw.normal() * 0.1
    own = draw.normal(size=4) * [0.05, 0.05, 0.03, 0.03]
    more = draw.normal(size=(terms, 10)) * 0.0047
    more[:, (degree + 1) * (degree + 2) // 2 :] = 0.0

    def waves(u, v):
        a, b = u - middle[0], v - middle[1]
        made = np.stack([u ** (t - j) * v**j for t in range(4) for j in range(t + 1)], axis=-1) @ more.T
        made[..., 0] += offset + curvature * (a * a + b * b) + tilt[0] * u + tilt[1] * v
        made[..., 1] += 2 * astigmatism * a * b + own[2]
        made[..., 2] += astigmatism * (a * a - b * b) + own[3]
        made[..., 3] += coma * b + own[0]
        made[..., 4] += coma * a + own[1]
        if terms > 7:
            made[..., 7] += spherical
        return 2 * np.pi * scale * made

    return waves


def stars(draw, count, waves, telescope, *, side=33, pixel=0.5, sigma=0.6, defocus=(0.0,), doubles=0, snr=(30, 300)):
    """Return places (row, column) on a sensor of 4000 x 4000, electrons (n, e, side, side), and true wavefronts."""
    cells = int(np.ceil(np.sqrt(count)))
    size = 4000 / cells
    corner = np.stack(np.divmod(draw.permutation(cells * cells)[:count], cells), axis=1) * size
    places = np.rint(corner + draw.uniform(side / 2 + 1, size - side / 2 - 1, (count, 2)))
    v, u = ((places + 0.5) / 2000 - 1).T
    true = waves(u, v)
    noise = np.exp(draw.uniform(*np.log(snr), count))
    flux = 1.3 * noise**2 + 20 * noise
    images = np.zeros((count, len(defocus), side, side))
    for k in range(count):
        for e, known in enumerate(defocus):
            place = draw.uniform(-0.5, 0.5, 2)
            light = telescope.image(true[k], place, pixel, side, sigma, known)
            if k < doubles:
                angle = draw.uniform(0, 2 * np.pi)
                beside = place + draw.uniform(3, 6) * np.array([np.cos(angle), np.sin(angle)])
                light += draw.uniform(0.4, 1) * telescope.image(true[k], beside, pixel, side, sigma, known)
            images[k, e] = draw.poisson(flux[k] * light + 20.0) + draw.normal(size=(side, side)) * 2.0
    return places, images, true
