"""Planes through the layers of a microscope as the compiled core takes them, and what it says of them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array


class Layered(NamedTuple):
    """Planes through layers: angles, and what their light is made of.

    Attributes
    ----------
    rho : ndarray, shape (q,)
    parts : ndarray of complex, shape (m, q)
        Of orders 0, 1, ..., with the weights of the rule.
    rates : ndarray of complex, shape (3, q)
        The phase, and its derivatives by depth and focus.
    error : float
        What each part of the field is proven to err by.
    planes : ndarray, shape (3, n)
        Depth, focus and power.
    forms : ndarray of complex, shape (k, m, m)
        Hermitian, of each order of the azimuth.
    turns : ndarray, shape (k, 3)
        That order, and the factors of its cosine and its sine; order 0 first.
    """

    rho: Array
    parts: NDArray[np.complex128]
    rates: NDArray[np.complex128]
    error: float
    planes: Array
    forms: NDArray[np.complex128]
    turns: Array


class LayeredSlopes(NamedTuple):
    """By what images of such planes are differentiated.

    Attributes
    ----------
    by : ndarray, shape (k, 2)
        BY_DEPTH, BY_FOCUS, BY_AXIS (two derivatives, by row and by column, of light that is radially symmetric) or
        BY_WAVENUMBER (by ln k, where light is radially symmetric at the same place in metres, else at the same v);
        and a factor of that derivative of I.
    own : ndarray, shape (k, n)
        What I itself counts in each, and plane.
    of_fields : ndarray, shape (4,)
        What each part of the field is proven to err by in its derivatives by depth, focus, v and ln k.
    turning : ndarray of complex, shape (3, q)
        As `rates` of :class:`Layered`, less a real number each.
    changes : ndarray of complex, shape (m, q), or None
        The derivatives of `parts` by ln k.
    """

    by: Array
    own: Array
    of_fields: Array
    turning: NDArray[np.complex128]
    changes: NDArray[np.complex128] | None


class Rings(NamedTuple):
    """Planes with any wavefront: what fields on circles are summed from, and how these become pixels.

    Attributes
    ----------
    bessel : ndarray, shape (orders, circles, nodes)
    parts : ndarray of complex, shape (n or 1, 2 orders - 1, fields, nodes)
    waves : ndarray of complex, shape (n, nodes)
    power : ndarray, shape (n,)
    angles : int
        On each circle, a :func:`fft_length`.
    filter : ndarray
        Weights of a circle, of those on either side, ...
    along, around : ndarray, shape (terms, 16)
        Taps as polynomials, the highest power first.
    taps : (int, int)
        How many of these there are.
    gains : ndarray, shape (2, 2 orders - 1)
        What orders of the intensity are multiplied by before the latter, and what each is off by thereafter.
    """

    bessel: Array
    parts: NDArray[np.complex128]
    waves: NDArray[np.complex128]
    power: Array
    angles: int
    filter: Array
    along: Array
    around: Array
    taps: tuple[int, int]
    gains: Array


class Ringed(NamedTuple):
    """What bounds on errors of such planes are made of.

    Attributes
    ----------
    squares : ndarray, shape (fields, n)
        The largest of each field on circles.
    top, aliases, sums, pixel : ndarray, shape (n,)
        The largest intensity on circles; what the orders of one may be off by between angles, and the sum of their
        moduli, both once they are filtered; the largest pixel.
    """

    squares: Array
    top: Array
    aliases: Array
    sums: Array
    pixel: Array
