"""Area of a rectangle covered by a disk, for grey pupil edges and exact pixel averages."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from lommel.base.arrays import Array


def disk_overlap(radius: ArrayLike, left: ArrayLike, right: ArrayLike, low: ArrayLike, high: ArrayLike) -> Array:
    """Return the area of ``[left, right] x [low, high]`` inside a disk around the origin.

    Elementary geometry, exact to rounding: inclusion and exclusion of rectangles with one corner at the centre.

    Parameters
    ----------
    radius : array_like
        Radius of the disk, >= 0.
    left, right, low, high : array_like
        Sides of the rectangle, ``left <= right`` and ``low <= high``.

    Returns
    -------
    ndarray
        Area, of the shape that all broadcast to.
    """
    r = np.asarray(radius, dtype=np.float64)
    x0, x1, y0, y1 = (np.asarray(e, dtype=np.float64) for e in (left, right, low, high))
    return _corner(r, x1, y1) - _corner(r, x0, y1) - _corner(r, x1, y0) + _corner(r, x0, y0)


def _corner(r: Array, x: Array, y: Array) -> Array:
    """Return the area of the disk within the rectangle from the origin to (x, y), signed like x y."""
    # A disk that holds the whole rectangle may be smaller, lest squares overflow.
    r = np.minimum(r, 2.0 * (np.abs(x) + np.abs(y)))
    a, b = np.minimum(np.abs(x), r), np.minimum(np.abs(y), r)
    # The circle leaves the rectangle's far side at this x; from there on it is the boundary.
    leaves = np.minimum(a, np.sqrt((r - b) * (r + b)))
    area = leaves * b + _under_arc(r, a) - _under_arc(r, leaves)
    return np.asarray(np.sign(x) * np.sign(y) * area)


def _under_arc(r: Array, x: Array) -> Array:
    """Return ``int_0^x sqrt(r^2 - s^2) ds``."""
    height = np.sqrt((r - x) * (r + x))
    # The angle by its tangent: near x = r its sine would lose half the digits.
    return np.asarray(0.5 * (x * height + r * r * np.arctan2(x, height)))
