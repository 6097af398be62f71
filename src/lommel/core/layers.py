"""Arguments and results of the compiled core for microscope stacks through plane layers."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array


class Layered(NamedTuple):
    """Planes through layers: angles, and the fields of their light."""

    rho: Array  # (q,)
    parts: NDArray[np.complex128]  # (m, q), of orders 0, 1, ..., with the weights of the rule
    rates: NDArray[np.complex128]  # (3, q), the phase, and its derivatives by depth and focus
    error: float  # bound on the error of each part of the field
    planes: Array  # (3, n), depth, focus and power
    forms: NDArray[np.complex128]  # (k, m, m), Hermitian, of each order of the azimuth
    turns: Array  # (k, 3), that order, and the factors of its cosine and its sine; order 0 first


class LayeredSlopes(NamedTuple):
    """Variables that images of such planes are differentiated by."""

    by: Array  # (k, 2), BY_DEPTH, ... of the engine, and a factor of that derivative of I
    own: Array  # (k, n), factor of I itself in each
    of_fields: Array  # (4,), errors of fields in derivatives by depth, focus, v and ln k
    turning: NDArray[np.complex128]  # (3, q), as `rates`, less a real number each
    changes: NDArray[np.complex128] | None  # (m, q), derivatives of `parts` by ln k


class Rings(NamedTuple):
    """Planes with any wavefront: fields on circles, and their interpolation to pixels."""

    bessel: Array  # (orders, circles, nodes)
    parts: NDArray[np.complex128]  # (n or 1, 2 orders - 1, fields, nodes)
    waves: NDArray[np.complex128]  # (n, nodes)
    power: Array  # (n,)
    angles: int  # on each circle, an fft_length
    filter: Array  # weights of a circle, of those on either side, ...
    along: Array  # (terms, 16), taps as polynomials, the highest power first
    around: Array  # likewise
    taps: tuple[int, int]  # numbers of taps along and around
    gains: Array  # (2, 2 orders - 1), factors of orders of the intensity, and their errors


class Ringed(NamedTuple):
    """Sizes that bound the errors of such planes."""

    squares: Array  # (fields, n), the largest of each field on circles
    top: Array  # (n,), the largest intensity on circles
    aliases: Array  # (n,), the error of the orders of one between angles, filtered
    sums: Array  # (n,), the sum of their moduli, filtered
    pixel: Array  # (n,), the largest pixel
