"""Averages of a radial PSF over square pixels of any size, from values at few radii."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core import engine
from lommel.core.answers import Pixels
from lommel.special.legendre import gauss_legendre


class PixelRule(NamedTuple):
    """A quadrature rule for the mean of a radial intensity I(v) over each pixel of a centred window of odd side.

    ``mean = I(step * radii) @ matrix`` has one value for each pixel of the octant; see :func:`octant`.

    Attributes
    ----------
    radii : ndarray, shape (n,)
        Radii at which I is needed, ascending, in pixels.
    matrix : ndarray, shape (n, cells)
        Weights of the radii for each pixel of the octant.
    """

    radii: Array
    matrix: Array


@lru_cache(maxsize=16)
def octant(half: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return column and row of the pixels of an octant (0 <= row <= column), called its cells.

    Cells are ordered by column: the first cells are the octant of a smaller window.

    Parameters
    ----------
    half : int
        Half width of the window, without the middle pixel: its side is ``2 half + 1`` pixels.

    Returns
    -------
    column, row : ndarray of int, shape (cells,)
        Column and row of each cell, counted from the middle pixel.
    """
    column, row = np.tril_indices(half + 1)
    column.flags.writeable = row.flags.writeable = False
    return column, row


def sums_of_windows(means: Array, half: int) -> Array:
    """Return the sums over centred square windows of all sizes up to half width `half`.

    Parameters
    ----------
    means : ndarray, shape (n, cells)
        Values of the pixels of the octant.
    half : int
        Half width of the largest window, without the middle pixel.

    Returns
    -------
    ndarray, shape (n, half + 1)
        Sums over the windows of half width 0, 1, ... pixels.
    """
    copies, column_starts = _cell_copies(half)
    return np.asarray(np.cumsum(np.add.reduceat(means * copies, column_starts, axis=1), axis=1))


def cells_alike(half: int) -> Array:
    """Return the number of pixels of a window that are equal by symmetry to each cell of the octant.

    Parameters
    ----------
    half : int
        Half width of the window, without the middle pixel.

    Returns
    -------
    ndarray, shape (cells,)
        8, or 4 on an axis or a diagonal, or 1 in the middle.
    """
    return _cell_copies(half)[0]


@lru_cache(maxsize=16)
def _cell_copies(half: int) -> tuple[Array, NDArray[np.int64]]:
    """Return the number of equal pixels for each cell of the octant, and the first cell of each column."""
    column, row = octant(half)
    copies = np.where(column == 0, 1.0, np.where((row == 0) | (row == column), 4.0, 8.0))
    return copies, np.flatnonzero(row == 0)


def quarters(means: Pixels, half: int) -> Pixels:
    """Return a quadrant of each window, with the middle row and column, shape ``(n, half + 1, half + 1)``.

    Parameters
    ----------
    means : ndarray, shape (n, cells)
        Values of the pixels of the octant.
    half : int
        Half width of the windows, at most the half width of the octant.

    Returns
    -------
    ndarray
    """
    return np.asarray(means[:, cells_of_quarter(half)])


def cells_of_quarter(half: int) -> NDArray[np.int64]:
    """Return the index of the cell of the octant for each pixel of a quadrant, shape (half + 1, half + 1)."""
    column, row = octant(half)
    cell = np.empty((half + 1, half + 1), dtype=np.int64)
    cell[row, column] = cell[column, row] = np.arange(row.size)
    return cell


def averaging_error(width: float, count: int) -> float:
    """Bound the error, relative to the peak, of means over a pixel from `count` by `count` Gauss nodes.

    `width` is the side of the pixel in v.
    """
    # I(v) = U(v) conj(U(conj(v))) is an entire function of either coordinate, and at most exp(2 |Im v|) times the
    # square of the amplitude of the pupil. On the Bernstein ellipse of parameter b around a pixel, this factor is at
    # most exp(width sinh b). The error of p = `count` Gauss nodes along either side is therefore at most
    # 2 (32/15) exp(width sinh b - 2 p b) / (1 - exp(-2 b)) for every b; the smallest of several bounds is used.
    b = np.linspace(0.05, 5.0, 200)
    exponent = width * np.sinh(b) - 2.0 * count * b - np.log(-np.expm1(-2.0 * b))
    return 64.0 / 15.0 * math.exp(min(float(exponent.min()), 600.0))


def pixel_rule(half: int, step: float, margin: int = 12) -> PixelRule:
    r"""Return the rule for windows of ``2 half + 1`` pixels a side, each `step` in v wide.

    The integral over a pixel is ``int I(r) r Theta(r) dr``, where Theta is the angle of the part of the circle of
    radius r that lies in the pixel. For r between the distances of two corners of the pixel, Theta is a difference of
    ``arccos(x / r)`` and ``arcsin(y / r)`` with the coordinates x and y of its edges. Theta is not smooth where the
    circle touches an edge x as a tangent, but is a smooth function of ``u = sqrt(r^2 - x^2)``, with ``r dr = u du``.
    I is even and of exponential type 2 in v: the error is near rounding with half a Gauss node per radian of the
    phase ``2 v``, and `margin` more nodes.

    A pixel thus needs dozens of nodes. On the whole window, however, I is almost a sum of Chebyshev polynomials of
    even degrees up to little more than ``2 v``. The rule therefore interpolates I by these polynomials, and contains
    their integrals over the pixels (measured error: 1e-12 of the largest I with the default).

    A rule is accurate for smaller steps, too: steps within an eighth of an octave share one rule.

    Parameters
    ----------
    half : int
        Half width of the window, without the middle pixel.
    step : float
        Pixel pitch in v.
    margin : int, default 12
        Number of nodes in addition to the nodes for the phase, in each of the three intervals of a pixel.

    Returns
    -------
    PixelRule
    """
    return _rule(half, math.ceil(8.0 * math.log2(step)), margin)


@lru_cache(maxsize=16)
def _rule(half: int, eighths: int, margin: int) -> PixelRule:
    """Return the rule for the step of ``2^(eighths / 8)`` in v."""
    step = 2.0 ** (eighths / 8.0)
    radii, weights, starts = _nodes(half, step, margin)
    reach = math.sqrt(2.0) * (half + 0.5)
    # The Chebyshev coefficients of exp(i phase x) are Bessel functions J_n(phase), negligible for degrees n beyond
    # the phase and a transition of width phase^(1/3).
    phase = 2.0 * step * reach
    count = math.ceil(0.5 * (phase + 10.0 * math.cbrt(phase) + 2.0 * margin))
    angle = np.arccos(np.minimum(1.0, radii / reach))
    moments = _moments(2.0 * np.cos(2.0 * angle), weights, starts, count)
    # Cosine transform from values at the positive half of 2 count Chebyshev nodes to coefficients of even degrees.
    angles = (np.arange(count, dtype=np.float64)[::-1] + 0.5) * (0.5 * math.pi / count)
    transform = np.cos(2.0 * np.outer(angles, np.arange(count))) * (2.0 / count)
    transform[:, 0] *= 0.5
    return PixelRule(reach * np.cos(angles), engine.product(transform, moments, 1))


class LocalRule(NamedTuple):
    """A sparse rule for the mean of I over each pixel of a centred window, from equally spaced values of I.

    ``mean = matrix @ I(v)`` has one value for each pixel of the octant; see :func:`octant`.

    Attributes
    ----------
    v : ndarray, shape (n,)
        Radii at which I is needed, ascending.
    matrix : scipy.sparse array, shape (cells, n)
    """

    v: Array
    matrix: scipy.sparse.csr_array


_SPACING, _STENCIL = 0.4, 16  # spacing of values in v, and number of values of an interpolation


@lru_cache(maxsize=4)
def local_rule(half: int, step: float) -> LocalRule:
    r"""Return a sparse rule for windows of ``2 half + 1`` pixels a side of many lambda*N each.

    The quadrature is the same as in :func:`pixel_rule`, but I at its nodes is interpolated by polynomials through the
    nearest values. As I is of exponential type 2 in v, the interpolation error is ``sin(spacing)^16`` times a
    fraction of the largest I: less than 1e-7. The mean over a pixel depends on values near the pixel only; with
    :func:`pixel_rule` it depends on all values.

    Parameters
    ----------
    half : int
        Half width of the window, without the middle pixel.
    step : float
        Pixel pitch in v.

    Returns
    -------
    LocalRule
    """
    radii, weights, starts = _nodes(half, step, 8)
    t = radii * (step / _SPACING)
    start = np.floor(t).astype(np.int64) - (_STENCIL // 2 - 1)
    t -= start
    counts = np.diff(starts, append=radii.size)
    nearest, farthest = np.minimum.reduceat(start, starts), np.maximum.reduceat(start, starts) + _STENCIL
    # The row of a pixel in the matrix has entries for all values from its nearest to its farthest node.
    ends = np.cumsum(farthest - nearest)
    entry = np.repeat(ends - (farthest - nearest) - nearest, counts) + start
    # Lagrange weights prod_(k != j) (t - k) / (j - k), from the products over k < j and over k > j.
    products_above = np.ones((_STENCIL, radii.size))
    for j in range(_STENCIL - 1, 0, -1):
        products_above[j - 1] = products_above[j] * (t - j)
    products_below, sums = weights, np.zeros(ends[-1])
    for j in range(_STENCIL):
        scale = math.prod(j - k for k in range(_STENCIL) if k != j)
        sums += np.bincount(entry + j, products_below * products_above[j] / scale, ends[-1])
        products_below = products_below * (t - j)
    # I is even: a negative radius uses the value at the positive radius.
    column = np.abs(np.arange(ends[-1]) - np.repeat(ends - farthest, farthest - nearest))
    count = int(farthest.max())
    matrix = scipy.sparse.csr_array((sums, column, np.concatenate([[0], ends])), shape=(starts.size, count))
    return LocalRule(_SPACING * np.arange(count, dtype=np.float64), matrix)


def _moments(two_cos: Array, weights: Array, starts: NDArray[np.int64], count: int) -> Array:
    """Return the sums over each cell of weights times T_0, T_2, ..., T_{2 count - 2}, shape (count, cells).

    `two_cos` (nodes,) is 2 cos(2 theta) for the Chebyshev polynomials T_k = cos(k theta), `starts` the first node of
    each cell.
    """
    # Recurrence T_{2k+2} = 2 cos(2 theta) T_{2k} - T_{2k-2}.
    moments = np.empty((count, starts.size))
    previous, current = 0.5 * two_cos * weights, weights
    for k in range(count):
        moments[k] = np.add.reduceat(current, starts)
        previous, current = current, two_cos * current - previous
    return moments


def _nodes(half: int, step: float, margin: int) -> tuple[Array, Array, NDArray[np.int64]]:
    """Return radii (pixels) and weights for the integrals over all cells, and the first node of each cell."""
    column, row = octant(half)
    # Only the part of a pixel in the first quadrant is integrated: half of it on an axis, a quarter in the middle.
    x0, y0, x1, y1 = np.maximum(0.0, column - 0.5), np.maximum(0.0, row - 0.5), column + 0.5, row + 0.5
    copies = np.where(column == 0, 2.0, 1.0) * np.where(row == 0, 2.0, 1.0)
    # Three intervals of the radius for each cell, between the distances of its corners.
    corners = np.stack([np.hypot(x0, y0), np.hypot(x0, y1), np.hypot(x1, y0), np.hypot(x1, y1)], axis=1)
    low, high = corners[:, :-1], corners[:, 1:]
    edge = np.stack([x0, np.zeros_like(x0), x1], axis=1)
    a, b = (np.sqrt(np.maximum(0.0, r * r - edge * edge)) for r in (low, high))
    # The phase 2 v of I changes fastest at the outer end: dv/du = step u / r.
    counts = np.ceil(0.5 * step * 2.0 * (b / high) * (b - a)).astype(np.int64) + margin
    counts[high - low < 1e-12 * high] = 0
    rules = {n: gauss_legendre(n) for n in np.unique(counts).tolist() if n > 0}
    interval_rules = [rules[n] for n in counts.ravel().tolist() if n > 0]
    interval = np.repeat(np.arange(counts.size), counts.ravel())  # of each node, over all cells
    cell, piece = interval // 3, interval % 3
    length = (b - a).ravel()[interval]
    u = a.ravel()[interval] + length * np.concatenate([nodes for nodes, _ in interval_rules])
    r = np.sqrt(edge.ravel()[interval] ** 2 + u * u)
    inverse = 1.0 / r

    def angle(arc: Callable[[Array], Array], edges: Pixels) -> Array:
        return np.asarray(arc(np.minimum(1.0, edges[cell] * inverse)))

    # Angles at which the circle enters the pixel, through y0 or x1, and leaves it, through x0 or y1.
    entry_angle = np.where(piece < 2, angle(np.arcsin, y0), angle(np.arccos, x1))
    exit_angle = np.where(piece < 1, angle(np.arccos, x0), angle(np.arcsin, y1))
    w = copies[cell] * length * np.concatenate([weights for _, weights in interval_rules])
    return r, w * u * np.maximum(0.0, exit_angle - entry_angle), np.cumsum(counts.sum(axis=1)) - counts.sum(axis=1)
