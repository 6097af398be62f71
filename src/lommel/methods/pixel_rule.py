"""Averages of a radial PSF over square pixels, however large, from its values at few radii."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core import engine
from lommel.core.answers import Pixels

if TYPE_CHECKING:
    from scipy.sparse import csr_array
from lommel.special.legendre import gauss_legendre


class PixelRule(NamedTuple):
    """A rule for the mean of I over each pixel of a centred window of odd side.

    ``mean = I(step * radii) @ matrix`` gives one value for each pixel of the octant; see :func:`octant`.

    Attributes
    ----------
    radii : ndarray, shape (n,)
        Where I must be known, rising, in pixels.
    matrix : ndarray, shape (n, cells)
    """

    radii: Array
    matrix: Array


@lru_cache(maxsize=16)
def octant(half: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return column and row, 0 <= row <= column, of the pixels of an octant; those of a smaller window come first.

    Parameters
    ----------
    half : int
        Pixels from the middle one to the edge.

    Returns
    -------
    column, row : ndarray of int, shape (cells,)
        From the middle pixel.
    """
    column, row = np.tril_indices(half + 1)
    column.flags.writeable = row.flags.writeable = False
    return column, row


def sums_of_windows(means: Array, half: int) -> Array:
    """Return the sum over 0, 1, 2, ... pixels from the middle, shape ``(n, half + 1)`` from ``(n, cells)``.

    Parameters
    ----------
    means : ndarray, shape (n, cells)
        Of the pixels of the octant.
    half : int
        Pixels from the middle one to the edge.

    Returns
    -------
    ndarray
    """
    alike, rings = _rings(half)
    return np.asarray(np.cumsum(np.add.reduceat(means * alike, rings, axis=1), axis=1))


def cells_alike(half: int) -> Array:
    """Return the number of pixels of a window for each cell of the octant, shape ``(cells,)``.

    Parameters
    ----------
    half : int
        Pixels from the middle one to the edge.

    Returns
    -------
    ndarray
    """
    return _rings(half)[0]


@lru_cache(maxsize=16)
def _rings(half: int) -> tuple[Array, NDArray[np.int64]]:
    """Return the number of pixels of the window for each cell of the octant, and the first cell of each column."""
    column, row = octant(half)
    # Eight symmetries; pixels on an axis or a diagonal have four images, the middle one is alone.
    alike = np.where(column == 0, 1.0, np.where((row == 0) | (row == column), 4.0, 8.0))
    return alike, np.flatnonzero(row == 0)


def quarters(means: Pixels, half: int) -> Pixels:
    """Return the pixels of windows from the middle row and column on, shape ``(n, half + 1, half + 1)``.

    Parameters
    ----------
    means : ndarray, shape (n, cells)
        Of the pixels of the octant.
    half : int
        At most that of the octant.

    Returns
    -------
    ndarray
    """
    return np.asarray(means[:, cells_of_quarter(half)])


def cells_of_quarter(half: int) -> NDArray[np.int64]:
    """Return the cell of the octant for each pixel from the middle row and column on."""
    column, row = octant(half)
    cell = np.empty((half + 1, half + 1), dtype=np.int64)
    cell[row, column] = cell[column, row] = np.arange(row.size)
    return cell


def averaging_error(width: float, count: int) -> float:
    """Bound the error of means over a pixel, `width` in v, by `count` Gauss nodes a side, over the peak."""
    # I(v) = U(v) conj(U(conj(v))) is entire in either coordinate, and at most exp(2 |Im v|) times the square of the
    # amplitude of the pupil. On the ellipse of b round a pixel that is exp(width sinh b), so that p Gauss nodes a
    # side err by at most 2 (32/15) exp(width sinh b - 2 p b) / (1 - exp(-2 b)), here for the best b of some.
    b = np.linspace(0.05, 5.0, 200)
    exponent = width * np.sinh(b) - 2.0 * count * b - np.log(-np.expm1(-2.0 * b))
    return 64.0 / 15.0 * math.exp(min(float(exponent.min()), 600.0))


def pixel_rule(half: int, step: float, margin: int = 12) -> PixelRule:
    r"""Return the rule for windows of ``2 half + 1`` pixels a side, each `step` in v wide.

    The integral over a pixel is ``int I(r) r Theta(r) dr``, Theta the angle of the circle of radius r that lies in
    the pixel. Between the distances of its corners Theta is made of ``arccos(x / r)`` and ``arcsin(y / r)``; in
    ``u = sqrt(r^2 - x^2)``, x that of the edge which the circle has just touched, it is smooth even where the circle
    is tangent, and ``r dr = u du``. I is even and of exponential type 2 in v, so half a node a unit of its phase, and
    `margin` more, make an error near rounding. That takes dozens of nodes a pixel; but being of that type, I is a sum
    of Chebyshev polynomials of even degree up to little more than ``2 v`` on the whole window, and it is their
    integrals that the rule is made of (measured: 1e-12 of the largest I with the default).

    A rule that is good for a step is good for smaller ones: steps within an eighth of an octave share one.

    Parameters
    ----------
    half : int
        Pixels from the middle one to the edge.
    step : float
        Pixel pitch in v.
    margin : int, default 12
        Nodes beyond those that the phase takes, in each of three intervals of each pixel.

    Returns
    -------
    PixelRule
    """
    return _rule(half, math.ceil(8.0 * math.log2(step)), margin)


@lru_cache(maxsize=16)
def _rule(half: int, eighths: int, margin: int) -> PixelRule:
    # Steps within an eighth of an octave share the rule of the largest.
    step = 2.0 ** (eighths / 8.0)
    radii, weights, starts = _nodes(half, step, margin)
    reach = math.sqrt(2.0) * (half + 0.5)
    # Coefficients of exp(i phase x) are Bessel functions of the phase, negligible soon beyond it (Airy's cube root).
    phase = 2.0 * step * reach
    count = math.ceil(0.5 * (phase + 10.0 * math.cbrt(phase) + 2.0 * margin))
    angle = np.arccos(np.minimum(1.0, radii / reach))
    moments = _moments(2.0 * np.cos(2.0 * angle), weights, starts, count)
    # Values at the positive half of 2 count Chebyshev nodes to coefficients of even degree: a cosine transform.
    at = (np.arange(count, dtype=np.float64)[::-1] + 0.5) * (0.5 * math.pi / count)
    transform = np.cos(2.0 * np.outer(at, np.arange(count))) * (2.0 / count)
    transform[:, 0] *= 0.5
    return PixelRule(reach * np.cos(at), engine.product(transform, moments, 1))


class LocalRule(NamedTuple):
    """A rule for the mean of I over each pixel of a centred window, from equally spaced values of I.

    ``mean = matrix @ I(v)`` gives one value for each pixel of the octant; see :func:`octant`.

    Attributes
    ----------
    v : ndarray, shape (n,)
        Where I must be known, rising.
    matrix : scipy.sparse array, shape (cells, n)
    """

    v: Array
    matrix: csr_array


_SPACING, _STENCIL = 0.4, 16  # spacing of values in v, and number of values of an interpolation


@lru_cache(maxsize=4)
def local_rule(half: int, step: float) -> LocalRule:
    r"""Return a sparse rule for pixels of many lambda*N, `step` wide in v, of windows of ``2 half + 1`` a side.

    The quadrature is that of :func:`pixel_rule`, but I at its nodes is interpolated by polynomials through the
    nearest values. I is of exponential type 2 in v, so that they err by ``sin(spacing)^16`` times a fraction of the
    largest I: less than 1e-7. A pixel depends on the values within it; in :func:`pixel_rule` it depends on all.

    Parameters
    ----------
    half : int
        Pixels from the middle one to the edge.
    step : float
        Pixel pitch in v.

    Returns
    -------
    LocalRule
    """
    from scipy.sparse import csr_array

    radii, weights, starts = _nodes(half, step, 8)
    t = radii * (step / _SPACING)
    first = np.floor(t).astype(np.int64) - (_STENCIL // 2 - 1)
    t -= first
    counts = np.diff(starts, append=radii.size)
    low, high = np.minimum.reduceat(first, starts), np.maximum.reduceat(first, starts) + _STENCIL
    # Values from the nearest to the farthest node of a pixel form its row of the matrix.
    ends = np.cumsum(high - low)
    place = np.repeat(ends - (high - low) - low, counts) + first
    # Lagrange weights prod (t - k) / (j - k), as products before and after j.
    after = np.ones((_STENCIL, radii.size))
    for j in range(_STENCIL - 1, 0, -1):
        after[j - 1] = after[j] * (t - j)
    before, sums = weights, np.zeros(ends[-1])
    for j in range(_STENCIL):
        scale = math.prod(j - k for k in range(_STENCIL) if k != j)
        sums += np.bincount(place + j, before * after[j] / scale, ends[-1])
        before = before * (t - j)
    column = np.abs(np.arange(ends[-1]) - np.repeat(ends - high, high - low))  # I is even: mirrored at the axis
    count = int(high.max())
    made = csr_array((sums, column, np.concatenate([[0], ends])), shape=(starts.size, count))
    return LocalRule(_SPACING * np.arange(count, dtype=np.float64), made)


def _moments(twice: Array, weights: Array, starts: NDArray[np.int64], count: int) -> Array:
    """Return the sums over each cell of weights times ``T_0, T_2, ..., T_{2 count - 2}``, by their recurrence."""
    # T_{2k+2}(x) = 2 cos(2 theta) T_{2k} - T_{2k-2}: `twice` is 2 cos(2 theta).
    moments = np.empty((count, starts.size))
    before, now = 0.5 * twice * weights, weights
    for k in range(count):
        moments[k] = np.add.reduceat(now, starts)
        before, now = now, twice * now - before
    return moments


def _nodes(half: int, step: float, margin: int) -> tuple[Array, Array, NDArray[np.int64]]:
    """Return radii (pixels) and weights for the integrals over all cells, and the first node of each."""
    column, row = octant(half)
    # Pixels on an axis are halved there, the middle one quartered; `share` restores the whole.
    x0, y0, x1, y1 = np.maximum(0.0, column - 0.5), np.maximum(0.0, row - 0.5), column + 0.5, row + 0.5
    share = np.where(column == 0, 2.0, 1.0) * np.where(row == 0, 2.0, 1.0)
    # Three pieces of each cell, between the distances of its corners.
    corners = np.stack([np.hypot(x0, y0), np.hypot(x0, y1), np.hypot(x1, y0), np.hypot(x1, y1)], axis=1)
    low, high = corners[:, :-1], corners[:, 1:]
    edge = np.stack([x0, np.zeros_like(x0), x1], axis=1)
    a, b = (np.sqrt(np.maximum(0.0, r * r - edge * edge)) for r in (low, high))
    # The phase 2 v of I changes fastest at the outer end: dv/du = step u / r.
    counts = np.ceil(0.5 * step * 2.0 * (b / high) * (b - a)).astype(np.int64) + margin
    counts[high - low < 1e-12 * high] = 0
    rules = {n: gauss_legendre(n) for n in np.unique(counts).tolist() if n > 0}
    each = [rules[n] for n in counts.ravel().tolist() if n > 0]
    place = np.repeat(np.arange(counts.size), counts.ravel())
    cell, piece = place // 3, place % 3
    length = (b - a).ravel()[place]
    u = a.ravel()[place] + length * np.concatenate([nodes for nodes, _ in each])
    r = np.sqrt(edge.ravel()[place] ** 2 + u * u)
    inverse = 1.0 / r

    def angle(arc: Callable[[Array], Array], at: Pixels) -> Array:
        return np.asarray(arc(np.minimum(1.0, at[cell] * inverse)))

    # Angle of the arc in the pixel: it enters through the nearer edge and leaves through the farther one.
    first = np.where(piece < 2, angle(np.arcsin, y0), angle(np.arccos, x1))
    last = np.where(piece < 1, angle(np.arccos, x0), angle(np.arcsin, y1))
    w = share[cell] * length * np.concatenate([weights for _, weights in each])
    return r, w * u * np.maximum(0.0, last - first), np.cumsum(counts.sum(axis=1)) - counts.sum(axis=1)
