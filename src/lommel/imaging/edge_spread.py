"""Sharpness of the edges of a photograph, compared with those behind a stated blur.

A texture behind a weak blur looks like another texture, but the spectrum of a step is known. In windows around the
strongest edges, a step or a bar (two parallel steps) is fitted by least squares, seen through the stated blur and
smaller ones. Windows that are neither do not count, and the log-likelihood ratio of each is limited.
"""

from __future__ import annotations

import numpy as np
import scipy

from lommel.base.arrays import Array
from lommel.imaging.blur_spectrum import FREQUENCIES

_RADIUS, _MOST = 3, 150  # radius (pixels) and largest number of windows
_SMOOTH, _STRONG = 0.7, 8.0  # rms (pixels) of the Gaussian before gradients; least gradient / noise of an edge
_WIDTHS = np.array([0.0, 3.0, -3.0])  # widths of bars (pixels) from which fits start; 0 is a step
_STEPS, _LONGEST = 4, 0.6  # Gauss-Newton steps, and the longest of them, pixels (of the angle, half as many radians)
_NARROWEST, _WIDEST = 0.4, 4.5  # bars, pixels
_REACH, _SPACING = 8.0, 0.05  # half of the table of an edge, and its spacing, pixels
_DIAGONAL = np.pi / 8.0  # direction for which the pixel blurs edges; its variance is that of all directions
_NOISE, _CONTRAST = 2.0, 0.05  # largest variance of residuals / noise, or largest rms / contrast of the window
_LIMIT = 10.0  # largest log-likelihood ratio of a window, times 2
_RIDGE = 1e-7


def sharper_edges(curves: Array, plane: Array, variance: Array) -> float:
    """Return the number of edges of a `plane` that are sharper than behind the stated blur, less that of others.

    Each counts by its log-likelihood ratio, and by at most 1. `curves` are the transfer functions at FREQUENCIES of
    smaller blurs and, last, of the stated one.
    """
    down, across = np.mgrid[-_RADIUS : _RADIUS + 1, -_RADIUS : _RADIUS + 1]
    inside = down**2 + across**2 <= (_RADIUS + 0.6) ** 2
    y, x = down[inside], across[inside]
    rows, columns, angles = _edges(plane, variance)
    if not rows.size:
        return 0.0
    windows = plane[rows[:, None] + y, columns[:, None] + x]
    noise = variance[rows, columns]
    free = len(y) - 5
    squares = _misfits(_profiles(curves), windows, angles, y, x)  # (blurs, windows)
    least = squares.min(axis=0) / free
    clean = least < np.maximum(_NOISE * noise, np.square(_CONTRAST * np.ptp(windows, axis=1)))
    ratios = (squares[-1] - squares[:-1].min(axis=0)) / np.maximum(np.maximum(noise, least), 1e-30)
    return float(np.clip(ratios[clean] / _LIMIT, -1.0, 1.0).sum())


def _edges(plane: Array, variance: Array) -> tuple[Array, Array, Array]:
    """Return rows, columns and gradient directions of the strongest edges, at the maxima across them."""
    gradient = np.stack([scipy.ndimage.gaussian_filter(plane, _SMOOTH, order=order) for order in ((1, 0), (0, 1))])
    height = np.hypot(*gradient)
    relative = height / np.sqrt(np.maximum(variance, 1e-30) / (8.0 * np.pi * _SMOOTH**4))
    border = _RADIUS + 4
    strong = np.zeros(plane.shape, dtype=bool)
    strong[border:-border, border:-border] = relative[border:-border, border:-border] > _STRONG
    rows, columns = np.nonzero(strong)
    step = np.rint(gradient[:, rows, columns] / height[rows, columns]).astype(np.intp)
    here = height[rows, columns]
    top = (here >= height[rows + step[0], columns + step[1]]) & (here > height[rows - step[0], columns - step[1]])
    rows, columns = rows[top], columns[top]
    order = np.argsort(-relative[rows, columns], kind="stable")[:_MOST]
    rows, columns = rows[order], columns[order]
    return rows, columns, np.arctan2(*gradient[:, rows, columns])


def _profiles(curves: Array) -> Array:
    """Return the edges of blurs and their slopes, (2, blurs, points), as pixels see them."""
    t = np.arange(-_REACH, _REACH + 0.5 * _SPACING, _SPACING)
    seen = curves * np.sinc(FREQUENCIES * np.cos(_DIAGONAL)) * np.sinc(FREQUENCIES * np.sin(_DIAGONAL))
    spacing = FREQUENCIES[1] - FREQUENCIES[0]
    edge = 0.5 + (seen / (np.pi * FREQUENCIES)) @ np.sin(2.0 * np.pi * FREQUENCIES[:, None] * t) * spacing
    return np.stack([edge, np.gradient(edge, _SPACING, axis=1)])


def _misfits(profiles: Array, windows: Array, angles: Array, y: Array, x: Array) -> Array:
    """Return the sums of squared residuals of the best steps or bars, (blurs, windows)."""
    count, blurs = len(windows), profiles.shape[1]
    blur = np.repeat(np.arange(blurs), count)[:, None]
    values = np.tile(windows, (blurs, 1))
    least = np.full(blurs * count, np.inf)

    def profile(which: int, place: Array) -> Array:
        at = np.clip((place + _REACH) / _SPACING, 0.0, profiles.shape[2] - 1.001)
        first = at.astype(np.intp)
        table = profiles[which]
        below = table[blur, first]
        return np.asarray(below + (at - first) * (table[blur, first + 1] - below))

    for start in _WIDTHS:
        angle, place, width = np.tile(angles, blurs), np.zeros(blurs * count), np.full(blurs * count, start)
        for k in range(_STEPS + 1):
            cosine, sine = np.cos(angle)[:, None], np.sin(angle)[:, None]
            across = x * cosine + y * sine - place[:, None]
            turned = y * cosine - x * sine
            linear = [np.ones_like(across), profile(0, across)]
            if start:
                linear.append(profile(0, across - width[:, None]))
            design = np.stack(linear, axis=-1)
            factors = _solved(design, values)
            residual = values - np.einsum("nmi,ni->nm", design, factors)
            if k == _STEPS:
                break
            slope = factors[:, 1:2] * profile(1, across)
            moved = slope
            if start:
                far = factors[:, 2:3] * profile(1, across - width[:, None])
                moved = slope + far
            change = [-moved, moved * turned] + ([-far] if start else [])
            step = _solved(np.stack(linear + change, axis=-1), residual)[:, len(linear) :]
            place = np.clip(place + np.clip(step[:, 0], -_LONGEST, _LONGEST), -1.5, 1.5)
            angle = angle + np.clip(step[:, 1], -0.5 * _LONGEST, 0.5 * _LONGEST)
            if start:
                width = np.abs(width + np.clip(step[:, 2], -_LONGEST, _LONGEST)).clip(_NARROWEST, _WIDEST)
                width *= np.sign(start)
        least = np.minimum(least, np.square(residual).sum(axis=1))
    return least.reshape(blurs, count)


def _solved(design: Array, values: Array) -> Array:
    """Return the least squares solutions of designs (fits, points, parameters) for values (fits, points)."""
    products = np.swapaxes(design, 1, 2) @ design
    size = products.shape[-1]
    ridge = _RIDGE * np.trace(products, axis1=1, axis2=2) / size
    products[:, np.arange(size), np.arange(size)] += ridge[:, None]
    return np.asarray(np.linalg.solve(products, np.einsum("nmi,nm->ni", design, values)[..., None])[..., 0])
