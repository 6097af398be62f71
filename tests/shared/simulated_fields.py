"""Stars and corners of a checkerboard over a field by matrix Fourier transforms, apart from the package."""

from __future__ import annotations

from math import factorial

import numpy as np
from scipy import ndimage, signal


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


def through_turbulence(telescope, waves, place, pixel, side, fwhm, sigma=0.0):
    """Return fractions of all light in pixels, blurred by Kolmogorov's turbulence (Fried 1966) and a Gaussian."""
    n = len(telescope.grid)
    padded = np.zeros((2 * n, 2 * n), complex)
    padded[:n, :n] = telescope.aperture * np.exp(1j * np.tensordot(waves, telescope.terms, 1))
    transfer = np.fft.ifft2(np.abs(np.fft.fft2(padded)) ** 2)
    lag = np.fft.fftfreq(2 * n, 1.0 / 2.0)  # frequency in 1 / (lambda N): lag in diameters
    f = np.hypot(lag[:, None], lag)
    transfer = transfer / transfer[0, 0] * np.exp(-3.44 * (f * fwhm * pixel / 0.9759) ** (5 / 3))
    transfer *= np.exp(-2.0 * (np.pi * f * sigma * pixel) ** 2)
    y, x = (pixel * (np.arange(side) - side // 2 - at) for at in place)
    area = np.sinc(lag * pixel)
    down, across = (np.exp(-2j * np.pi * np.outer(part, lag)) * area for part in (y, x))
    return (down @ transfer @ across.T).real * (pixel / n) ** 2


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


def extended(covered, telescope, waves, pixel, side, sigma, *, over=7, reach=20.0):
    """Return an object seen through a telescope, mean values of pixels: `covered(y, x)` in pixels from the middle.

    The object is sampled four times along each of the `over` points of a pixel, and convolved with a PSF as far as
    `reach` (lambda*N).
    """
    step = pixel / over
    half = int(np.ceil(reach / step))
    points = step * np.arange(-half, half + 1)
    wave = np.exp(-1j * np.pi * np.outer(points, telescope.grid))
    field = wave @ (telescope.aperture * np.exp(1j * np.tensordot(waves, telescope.terms, 1))) @ wave.T
    light = np.abs(field) ** 2 * step**2 / (telescope.aperture.sum() * len(telescope.grid) ** 2)
    pad = half + 2 * over
    at = (np.arange(-pad, side * over + pad) + 0.5) / over - 0.5 - side // 2
    drawn = np.zeros((len(at), len(at)))
    for shift in np.ndindex(4, 4):
        down, across = ((part + 0.5) / 4 - 0.5 for part in shift)
        drawn += covered((at + down / over)[:, None], (at + across / over)[None]) / 16
    if sigma:
        drawn = ndimage.gaussian_filter(drawn, sigma * over, truncate=6)
    made = signal.fftconvolve(drawn, light, mode="valid")[2 * over : -2 * over, 2 * over : -2 * over]
    return made.reshape(side, over, side, over).mean((1, 3))


def board(place, angles, pitch):
    """Return a checkerboard, -1 and 1: a corner at a place, two angles of normals of its lines, squares of a side."""

    def covered(y, x):
        y, x = y - place[0], x - place[1]
        lines = [np.sin(np.pi * (x * np.cos(angle) + y * np.sin(angle)) / pitch) for angle in angles]
        return np.sign(lines[0]) * np.sign(lines[1])

    return covered


def corners(draw, rows, columns, waves, telescope, *, side, pixel, sigma, pitch, light=(5000.0, 500.0)):
    """Return places, electrons (n, side, side) and true wavefronts of corners of a board on 4000 x 4000 pixels."""
    cell = 4000 / rows, 4000 / columns
    middle = [(np.arange(n) + 0.5) * size for n, size in zip((rows, columns), cell, strict=True)]
    places = np.rint(np.stack(np.meshgrid(*middle, indexing="ij"), axis=-1).reshape(-1, 2))
    places += draw.integers(-50, 51, places.shape)
    v, u = ((places + 0.5) / 2000 - 1).T
    true = waves(u, v)
    turned, images = draw.uniform(0, np.pi / 2), []
    white, black = light
    for one in true:
        first = turned + 0.01 * draw.normal() + draw.integers(2) * np.pi / 2
        angles = first, first + np.pi / 2 + 0.01 * draw.normal()
        drawn = board(draw.uniform(-0.5, 0.5, 2), angles, pitch)
        mean = 0.5 * (white + black) + 0.5 * (white - black) * extended(drawn, telescope, one, pixel, side, sigma)
        images.append(draw.poisson(mean) + draw.normal(size=mean.shape) * 2.0)
    return places, np.array(images), true


def chart(draw, shape, waves, telescope, *, pixel, sigma, pitch, angle=0.08, vignetting=0.0, light=(5000.0, 500.0)):
    """Return the electrons of a checkerboard all over a sensor, and the true places (row, column) of its crossings.

    Each crossing and the halves of squares around it are seen through the wavefront `waves(u, v)` at the crossing.
    Light falls towards the corners by the share `vignetting`.
    """
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    middle = (np.array(shape) - 1) / 2
    reach = int(np.hypot(*shape) / pitch) + 1
    steps = np.stack(np.meshgrid(*(np.arange(-reach, reach + 1),) * 2), axis=-1).reshape(-1, 2)
    places = middle + pitch * (steps + 0.25) @ turn
    half = int(np.ceil(0.75 * pitch))
    inside = ((places > -half) & (places < np.array(shape) + half)).all(axis=1)
    steps, places = steps[inside], places[inside]
    row, column = (np.arange(side) for side in shape)
    nearest = ((row[:, None, None] - places[:, 0]) ** 2 + (column[None, :, None] - places[:, 1]) ** 2).argmin(axis=-1)
    mean, white, black = np.zeros(shape), *light
    for k, (step, place) in enumerate(zip(steps, places, strict=True)):
        own = nearest == k
        if not own.any():
            continue
        at = np.rint(place).astype(int)
        v, u = 2.0 * (np.clip(place, 0, np.array(shape) - 1) + 0.5) / shape - 1.0
        drawn = board(place - at, (angle, angle + np.pi / 2), pitch)
        tile = extended(drawn, telescope, waves(u, v), pixel, 2 * half + 1, sigma, over=5, reach=12.0)
        tile *= (-1.0) ** (step.sum() % 2)
        rows, columns = np.nonzero(own)
        mean[rows, columns] = tile[rows - at[0] + half, columns - at[1] + half]
    mean = 0.5 * (white + black) + 0.5 * (white - black) * mean
    v, u = np.meshgrid(*(2.0 * (np.arange(side) + 0.5) / side - 1.0 for side in shape), indexing="ij")
    mean *= 1.0 - 0.5 * vignetting * (u * u + v * v)
    return draw.poisson(mean) + draw.normal(size=mean.shape) * 2.0, places
