r"""Nodes of a window: few samples, shared by all of its pixels, that give the average over each.

Pixels of pitch a, their middles at X_j, fill a window of half width L. At nodes x_k within it a pixel has weights c
with

.. math:: r_j(w) = \sum_k c_{jk} e^{i w x_k} - \mathrm{sinc}(a w / 2)\, e^{i w X_j}

small for ``|w| <= 2``, where light has frequencies; there are about as many as the Shannon number of the window,
``4 L / pi``, less than half of what a filter takes that is the same for all pixels, and reaches beyond the window.
Nodes are the zeros of a prolate spheroidal function of bandwidth 2 L (H. Xiao, V. Rokhlin and N. Yarvin 2001,
doi:10.1088/0266-5611/17/4/315), which no bound depends on; weights are by least squares.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.core.engine import least_squares
from lommel.methods.pixels.transfer_rule import band_points, mean_rule

_LARGEST = 450.0  # bandwidth 2 L: larger windows have filters
_GAIN, _HIGHEST = 2.0, 5.0  # sum of the magnitudes of weights, from which on more nodes are tried, and none serve
_TRIED = 8  # numbers of nodes, two more each


class WindowNodes(NamedTuple):
    """Nodes along one axis of a window, and the weights of its pixels."""

    places: Array  # (n,), v about the middle of the window, rising, of either sign
    weights: Array  # (pixels, n)
    error: float  # bound on the mean error of the response, that the largest transfer function of a disc weighs
    gain: float  # largest sum of magnitudes of the weights of a pixel
    spread: float  # largest modulus of a weight over the sum of those of all pixels at its node


@lru_cache(maxsize=64)
def window_nodes(step: float, pixels: int, error: float) -> WindowNodes | None:
    """Return nodes for pixels of pitch `step` in v, off by `error` in the mean at most.

    None where the window is too large, or its pixels so small that weights of either sign would magnify errors.
    """
    bandwidth = step * pixels
    if bandwidth > _LARGEST:
        return None
    count = bandwidth * 2.0 / math.pi + math.log(bandwidth + 3.0) * math.log(0.3 / error) / math.pi**2
    least = 2 * max(2, math.floor(0.5 * count))
    best = None
    for more in range(_TRIED):
        made = _weighed(step, pixels, least + 2 * more)
        if made.error <= error and (best is None or made.gain < best.gain):
            best = made
            if best.gain <= _GAIN:
                break
    return best if best is not None and best.gain <= _HIGHEST else None


@lru_cache(maxsize=64)
def _weighed(step: float, pixels: int, count: int) -> WindowNodes:
    """Return so many nodes, even, with weights and bounds."""
    half = 0.5 * step * pixels
    x = half * prolate_zeros(count, 2.0 * half)
    middles: Array = step * (np.arange(pixels, dtype=np.float64) - 0.5 * (pixels - 1))
    # Weights that are even make the real part of r, which is even, and odd ones its imaginary part.
    w = band_points(half)
    at, rule = mean_rule(w.size)
    root = np.sqrt(rule)[:, None]
    parts = list[Array]()
    squares, most = np.zeros(pixels), np.zeros(pixels)
    for wave in (np.cos, np.sin):
        basis, aim = root * 2.0 * wave(np.outer(at, x)), root * _wanted(wave, at, step, middles)
        c = least_squares(basis, aim)
        parts.append(c)
        squares += ((basis @ c - aim) ** 2).sum(axis=0)
        off = np.abs(2.0 * wave(np.outer(w, x)) @ c - _wanted(wave, w, step, middles)).max(axis=0)
        most = np.hypot(most, off)
    even, odd = parts
    weights = np.concatenate([(even - odd)[::-1], even + odd]).T
    gain = float(np.abs(weights).sum(axis=1).max())
    rounding = 2.0**-52 * (count + 3) * gain
    largest = math.sqrt(2.0) * (float(most.max()) + 2.0 * rounding) + 1e-17
    mean = float(np.sqrt(squares.max())) + 4.0 * rounding + 1e-17
    # One of the two factors of an average is off by this in the mean, the other at most by `largest`.
    together = weights.sum(axis=0)
    spread = float((np.abs(weights) / together).max()) if together.min() > 0.0 else math.inf
    places = np.concatenate([-x[::-1], x])
    return WindowNodes(places, np.ascontiguousarray(weights), (1.0 + 0.5 * largest) * mean, gain, spread)


def _wanted(wave: np.ufunc, w: Array, step: float, middles: Array) -> Array:
    return np.asarray(np.sinc(0.5 * step / math.pi * w)[:, None] * wave(np.outer(w, middles)))


def prolate_zeros(degree: int, bandwidth: float) -> Array:
    """Return the positive zeros of the prolate spheroidal function of an even degree, rising.

    The function is a sum of even Legendre polynomials whose coefficients are an eigenvector of a symmetric matrix of
    three diagonals (Xiao, Rokhlin and Yarvin 2001, section 3).
    """
    k = 2.0 * np.arange((degree + 60) // 2 + math.ceil(0.35 * bandwidth))
    square = bandwidth * bandwidth
    diagonal = k * (k + 1.0) + (2.0 * k * (k + 1.0) - 1.0) / ((2.0 * k + 3.0) * (2.0 * k - 1.0)) * square
    beside = (k + 2.0) * (k + 1.0) / ((2.0 * k + 3.0) * np.sqrt((2.0 * k + 1.0) * (2.0 * k + 5.0))) * square
    vector = eigenvector(diagonal, beside[:-1], degree // 2)
    terms = np.zeros(2 * k.size)
    terms[::2] = vector * np.sqrt(k + 0.5)
    x = np.sin(np.linspace(0.0, 0.5 * math.pi, 8 * degree))
    values = np.polynomial.legendre.legval(x, terms)
    left = np.flatnonzero(np.signbit(values[:-1]) != np.signbit(values[1:]))
    low, high, below, above = x[left], x[left + 1], values[left], values[left + 1]
    # By the rule of false position, twice, which is exact enough: no bound depends on where nodes are.
    for _ in range(2):
        middle = (low * above - high * below) / (above - below)
        value = np.polynomial.legendre.legval(middle, terms)
        same = np.signbit(value) == np.signbit(below)
        low, below = np.where(same, middle, low), np.where(same, value, below)
        high, above = np.where(same, high, middle), np.where(same, above, value)
    return np.asarray((low * above - high * below) / (above - below))


def eigenvector(diagonal: Array, beside: Array, index: int) -> Array:
    """Return an eigenvector of a symmetric matrix of three diagonals, by the number of smaller eigenvalues.

    Eigenvalues by bisection, for as many are below a shift as pivots are negative; the vector from the pivots of both
    directions, which meet where they leave least (I. S. Dhillon and B. N. Parlett 2004,
    doi:10.1016/j.laa.2003.12.028, section 3).
    """
    reach = 2.0 * float(beside.max())
    low, high = float(diagonal.min()) - reach, float(diagonal.max()) + reach
    while high - low > 4e-16 * max(abs(low), abs(high)):
        middle = 0.5 * (low + high)
        if not low < middle < high:
            break
        below = sum(pivot < 0.0 for pivot in _pivots(diagonal - middle, beside))
        low, high = (low, middle) if below > index else (middle, high)
    shifted = diagonal - 0.5 * (low + high)
    down, up = np.array(_pivots(shifted, beside)), np.array(_pivots(shifted[::-1], beside[::-1]))[::-1]
    meet = int(np.abs(down + up - shifted).argmin())
    vector = np.ones(diagonal.size)
    vector[meet + 1 :] = np.cumprod(-beside[meet:] / up[meet + 1 :])
    vector[:meet] = np.cumprod((-beside[:meet] / down[:meet])[::-1])[::-1]
    return np.asarray(vector / np.linalg.norm(vector))


def _pivots(diagonal: Array, beside: Array) -> list[float]:
    """Return the pivots of Gauss's elimination of a symmetric matrix of three diagonals, none of them 0."""
    pivots = [float(diagonal[0]) or 1e-290]
    for own, square in zip(diagonal[1:].tolist(), (beside * beside).tolist(), strict=True):
        pivots.append(own - square / pivots[-1] or 1e-290)
    return pivots
