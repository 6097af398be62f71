"""Moments of a linear chirp: the one primitive that the closed form is made of."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base.arrays import Array
from lommel.special.erf import Erf, FresnelErf
from lommel.special.fresnel import HALF
from lommel.special.legendre import gauss_legendre, gauss_panels

_NEARLY_LINEAR = 0.1  # a h^2 below which the closed form loses more digits than quadrature costs
_BLOCK = 2**20


def chirp_moments(
    a: float, b: ArrayLike, low: ArrayLike, high: ArrayLike, *, erf: Erf | None = None
) -> NDArray[np.complex128]:
    r"""Return ``int_low^high R^m exp(i (a R^2 + b R)) dR`` for m = 0, 1, 2.

    The m = 0 moment is the error function of the paper's Eq. (13); the others follow by parts:
    ``M_1 = [e]/(2ia) - (b/2a) M_0`` and ``M_2 = [R e]/(2ia) - M_0/(2ia) - (b/2a) M_1``. The error function is
    written through its non-oscillating part G, so that no phase b^2/4a of a distant stationary point appears.
    Where ``|a| (high - low)^2 < 0.1`` the formulas cancel and Gauss-Legendre quadrature with enough nodes for
    the whole phase takes over, exact to rounding.

    Parameters
    ----------
    a : float
        Curvature of the phase, either sign or zero.
    b, low, high : array_like
        Slope and limits, ``low <= high``, broadcast together.
    erf : Erf, default FresnelErf()

    Returns
    -------
    ndarray of complex, shape ``(3,) + b.shape``
    """
    slope, start, end = np.broadcast_arrays(*(np.asarray(x, dtype=np.float64) for x in (b, low, high)))
    if a < 0:
        return np.conj(chirp_moments(-a, -slope, start, end, erf=erf))
    flat = a * (end - start) ** 2 < _NEARLY_LINEAR
    out = np.empty((3, *slope.shape), dtype=np.complex128)
    if np.any(flat):
        out[:, flat] = _by_quadrature(a, slope[flat], start[flat], end[flat])
    if not np.all(flat):
        bent = ~flat
        out[:, bent] = _by_erf(a, slope[bent], start[bent], end[bent], erf or FresnelErf())
    return out


def _by_erf(a: float, b: Array, low: Array, high: Array, erf: Erf) -> NDArray[np.complex128]:
    root = math.sqrt(a)
    s = root * (np.stack([low, high]) + b / (2.0 * a))
    side = np.where(s < 0, -1.0, 1.0)
    ends = np.exp(1j * (a * np.stack([low**2, high**2]) + b * np.stack([low, high])))
    parts = side * ends * erf.auxiliary(np.abs(s))
    # The stationary point -b/2a adds the full integral where it lies inside.
    whole = HALF * (side[1] - side[0]) * np.exp(-1j * b * b / (4.0 * a))
    zeroth = (parts[0] - parts[1] + whole) / root
    first = (ends[1] - ends[0]) / (2j * a) - b / (2.0 * a) * zeroth
    second = (high * ends[1] - low * ends[0] - zeroth) / (2j * a) - b / (2.0 * a) * first
    return np.stack([zeroth, first, second])


def _by_quadrature(a: float, b: Array, low: Array, high: Array) -> NDArray[np.complex128]:
    length = high - low
    span = (a * (low + high) + np.abs(b)) * length
    nodes = int(0.5 * span.max() + 3.0 * span.max() ** (1.0 / 3.0)) + 20
    x, w = gauss_panels(nodes)
    nodes = x.size
    out = np.empty((3, b.size), dtype=np.complex128)
    rows = max(1, _BLOCK // nodes)
    for first in range(0, b.size, rows):
        block = slice(first, first + rows)
        radius = low[block, None] + length[block, None] * x
        wave = w * length[block, None] * np.exp(1j * radius * (a * radius + b[block, None]))
        for m in range(3):
            out[m, block] = wave.sum(axis=1)
            wave = wave * radius
    return out


def disk_moments(alpha: float, limit: ArrayLike, count: int) -> NDArray[np.complex128]:
    r"""Return ``int_0^T R^(2m+1) exp(i alpha R^2) dR`` for m = 0, ..., count-1.

    The paper's Eq. (18)-(20) and their continuation: ``T^(2m+2)`` times :func:`unit_moments` of ``alpha T^2``.

    Parameters
    ----------
    alpha : float
        Radians, either sign or zero.
    limit : array_like
        T, >= 0.
    count : int

    Returns
    -------
    ndarray of complex, shape ``(count,) + T.shape``
    """
    square = np.asarray(limit, dtype=np.float64) ** 2
    powers = square ** np.arange(1, count + 1).reshape(-1, *(1,) * square.ndim)
    return np.asarray(powers * unit_moments(alpha * square, count))


def unit_moments(phase: Array, count: int) -> NDArray[np.complex128]:
    r"""Return ``int_0^1 x^(2m+1) exp(i phase x^2) dx`` for m = 0, ..., count-1.

    With u = x^2, ``int_0^1 u^m e^{i phase u} du / 2``. By parts, ``J_m = (e^{i phase}/2 - m J_{m-1}) / (i phase)``,
    where the phase exceeds the number of moments; by Gauss-Legendre quadrature below, where that recurrence cancels.

    Parameters
    ----------
    phase : ndarray
        Radians.
    count : int

    Returns
    -------
    ndarray of complex, shape ``(count,) + phase.shape``
    """
    turns = np.abs(phase)
    out = np.empty((count, *phase.shape), dtype=np.complex128)
    slow = turns <= max(32.0, 2.0 * count)
    if np.any(slow):
        u, w = gauss_legendre(24 + count // 2 + int(turns[slow].max()))
        wave = 0.5 * w * np.exp(1j * phase[slow][:, None] * u)
        for m in range(count):
            out[m, slow] = wave.sum(axis=1)
            wave = wave * u
    fast = ~slow
    if np.any(fast):
        p = phase[fast]
        end = np.exp(1j * p)
        value = (end - 1.0) / (2j * p)
        out[0, fast] = value
        for m in range(1, count):
            value = (0.5 * end - m * value) / (1j * p)
            out[m, fast] = value
    return out
