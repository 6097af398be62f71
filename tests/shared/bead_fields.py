"""Fields of points by a simulator of its own: vectorial light of isotropic dipoles by a Cartesian grid of pupil."""

from __future__ import annotations

import numpy as np

NA, INDEX, MAGNIFICATION, PIXEL = 1.1, 1.333, 60.0, 6.5e-6
_SIDE, _FINE = 72, 8  # cells of the pupil, and of the disc's edge in a cell
_AT, _WEIGHT = np.array([-0.5, 0.0, 0.5]) * np.sqrt(0.6), np.array([5.0, 8.0, 5.0]) / 18.0  # of Gauss in a pixel


def pupil():
    """Return x, y of the cells of the pupil and the part of each in the disc."""
    at = (np.arange(_SIDE) + 0.5) * 2.0 / _SIDE - 1.0
    fine = (np.arange(_SIDE * _FINE) + 0.5) * 2.0 / (_SIDE * _FINE) - 1.0
    inside = (np.hypot(fine[:, None], fine) < 1.0).reshape(_SIDE, _FINE, _SIDE, _FINE).mean(axis=(1, 3))
    return at, inside


def zernike(terms, y, x):
    """Return the phase of astigmatism, coma and spherical aberration, radians rms by name."""
    r2 = x * x + y * y
    shapes = {
        "astigmatism": np.sqrt(6.0) * (x * x - y * y), "oblique": 2.0 * np.sqrt(6.0) * x * y,
        "coma": np.sqrt(8.0) * (3.0 * r2 - 2.0) * x, "spherical": np.sqrt(5.0) * (6.0 * r2 * r2 - 6.0 * r2 + 1.0),
    }  # fmt: skip
    return sum(size * shapes[name] for name, size in terms.items())


def intensity(z, rows, columns, terms, wave):
    """Return the light of a point at z (planes), at rows and columns in metres of the sample, (planes, y, x)."""
    at, inside = pupil()
    y, x = at[:, None], at
    rho = np.minimum(np.hypot(y, x), 1.0)
    sine = NA * rho / INDEX
    cosine = np.sqrt(1.0 - sine**2)
    cos, sin = x / np.maximum(rho, 1e-9), y / np.maximum(rho, 1e-9)
    amplitude = inside * np.exp(1j * zernike(terms, y, x)) / np.sqrt(cosine)
    k = 2.0 * np.pi * NA / wave
    along, across = np.exp(-1j * k * np.outer(rows, at)), np.exp(-1j * k * np.outer(at, columns))
    one = np.ones_like(rho)
    fields = [cosine * cos, cosine * sin, -sine * one], [-sin * one, cos * one, 0.0 * one]
    total = np.zeros((len(z), len(rows), len(columns)))
    for p, s in zip(*fields, strict=True):  # of dipoles along x, y and z
        for light in (p * cos - s * sin, p * sin + s * cos):
            for k_plane, height in enumerate(z):
                wavefront = amplitude * light * np.exp(2j * np.pi * INDEX / wave * cosine * height)
                total[k_plane] += np.abs(along @ wavefront @ across) ** 2
    return total


def point(z, place, size, terms, wave):
    """Return the light in each pixel (planes, size, size) of a point at `place`, row and column, pixels."""
    at, pitch = (np.arange(size)[:, None] + _AT).ravel(), PIXEL / MAGNIFICATION
    light = intensity(np.asarray(z), (at - place[0]) * pitch, (at - place[1]) * pitch, terms, wave)
    return np.einsum("zaibj,i,j->zab", light.reshape(len(z), size, 3, size, 3), _WEIGHT, _WEIGHT)


def field(z, beads, shape, window, photons, background, wave):
    """Return the mean electrons of a field (planes, *shape) of beads, each (row, column, height in metres, terms)."""
    image = np.full((len(z), *shape), float(background))
    for row, column, height, terms in beads:
        corner = round(row) - window // 2, round(column) - window // 2
        light = point(np.asarray(z) - height, (row - corner[0], column - corner[1]), window, terms, wave)
        part = np.s_[:, corner[0] : corner[0] + window, corner[1] : corner[1] + window]
        image[part] += photons * light / light[len(z) // 2].sum()
    return image
