"""Where the windows of a bank end: such that each holds enough, and that nothing jumps as a point moves."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.methods.pixels.rule import quarters, sums_of_windows


def find_cuts(octants: NDArray[np.float64], half: int, energy: float) -> NDArray[np.float64]:
    """Return up to where each window must reach so that it, and what lies between it and the next, holds enough.

    Parameters
    ----------
    octants : ndarray, shape (count, cells)
        What the pixels of the octant hold of the light.
    half : int
        Pixels from the middle one to the edge.
    energy : float
        What each window is to hold of it, if it does.

    Returns
    -------
    ndarray, shape (count,)
        Pixels from the middle, a real number h: of the ring at the Chebyshev distance k the share ``h + 1 - k``.
    """
    sums = sums_of_windows(octants, half)
    enough = sums >= np.clip(energy, sums[:, :1], sums[:, -1:])
    rows, outer = np.arange(len(sums)), enough.argmax(axis=1)
    ring = sums[rows, outer] - sums[rows, outer - 1]
    over = np.maximum(0.0, sums[rows, outer] - energy)
    own = outer - np.divide(over, ring, out=np.zeros(len(sums)), where=outer > 0)
    # What the neighbours take counts: those between are to hold enough as well.
    return np.asarray(np.max([own[np.clip(rows + k, 0, len(own) - 1)] for k in (-1, 0, 1)], axis=0))


def ring_shares(cuts: NDArray[np.float64], half: int) -> NDArray[np.float64]:
    """Return how much is used of each ring of pixels, 0 to 1: the mean over neighbours, 1/6, 2/3 and 1/6.

    Parameters
    ----------
    cuts : ndarray, shape (count,)
        As of :func:`find_cuts`.
    half : int

    Returns
    -------
    ndarray, shape (count, half + 1)
        By the Chebyshev distance from the middle.
    """
    padded, away = np.pad(cuts, 1, mode="edge"), np.arange(half + 1)
    ring = np.clip(padded[:, None] + 1.0 - away, 0.0, 1.0)
    return np.asarray((ring[:-2] + 4.0 * ring[1:-1] + ring[2:]) / 6.0)


def shares_used(cuts: NDArray[np.float64], half: int) -> NDArray[np.float64]:
    """Return how much is used of each pixel, 0 to 1, from the middle row and column on.

    Parameters
    ----------
    cuts : ndarray, shape (count,)
        As of :func:`find_cuts`.
    half : int

    Returns
    -------
    ndarray, shape (count, half + 1, half + 1)
    """
    away = np.arange(half + 1)
    return ring_shares(cuts, half)[:, np.maximum(away[:, None], away)]


def cut(octants: NDArray[np.float64], cuts: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return windows cut.

    Parameters
    ----------
    octants : ndarray, shape (count, cells)
        What the pixels of the octant hold, up to the largest of the cuts or farther.
    cuts : ndarray, shape (count,)
        As of :func:`find_cuts`.

    Returns
    -------
    ndarray, shape (count, used + 1, used + 1)
        From the middle row down and the middle column on.
    """
    used = math.ceil(cuts.max())
    return np.asarray(quarters(octants, used) * shares_used(cuts, used))


def sums_of_quarters(quarter: NDArray[np.floating[Any]]) -> NDArray[np.float64]:
    """Return the sums of windows.

    Parameters
    ----------
    quarter : ndarray, shape (count, rows, columns)
        From the middle row down and the middle column on.

    Returns
    -------
    ndarray, shape (count,)
    """
    down, across = (np.where(np.arange(side) == 0, 1.0, 2.0) for side in quarter.shape[1:])
    return np.asarray(quarter @ across @ down)
