r"""Values of pixels of any size and position from samples on a square lattice, along rows, then columns.

The transform of ``box(w) exp(-(w / s)^2 / 2)``, boxes being convolved with the Gaussian, is
``g(x) = sin(m x) / (pi x) exp(-(s x)^2 / 2)``: a gate from ``-m`` to ``m`` whose fall is an error function. So
``h sum_k g(x - k h) exp(i w k h) = exp(i w x)`` for ``abs(w) <= 2`` but for the error of the gate (Poisson's sum),
and g averaged over a pixel gives averages. The sum truncated after some samples errs by an exponential integral.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.blur.turbulence import Gate
from lommel.special.legendre import gauss_legendre


class Readout(NamedTuple):
    """A sparse matrix from samples, from `first` on, to pixels; `error` bounds its response for ``abs(w) <= 2``."""

    matrix: Any
    first: int
    error: float
    gain: float
    low: float  # of the least pixel, in v
    high: float  # of the greatest

    def ends(self, reach: float) -> tuple[float, float]:
        """Return the ends of all pixels and the axis, and of what is within a `reach` of the pixels."""
        return min(self.low - reach, 0.0), max(self.high + reach, 0.0)

    @property
    def samples(self) -> int:
        """How many there are."""
        return int(self.matrix.shape[1])


@lru_cache(maxsize=8)
def readout(places: tuple[float, ...], active: float, gate: Gate) -> Readout:
    """Return what averages over `active` around each of rising `places`, all in v; 0 samples there."""
    from scipy import sparse

    at = np.array(places)
    h, (beyond, cut) = gate.h, ends(gate)
    taps = 2 * math.ceil((beyond + 0.5 * active) / h) + 1
    start = np.rint(at / h).astype(np.int64) - taps // 2
    k = start[:, None] + np.arange(taps)
    weights = h * _averaged(at[:, None] - h * k, active, gate)
    first = int(start.min())
    rows = np.repeat(np.arange(at.size), taps)
    shape = at.size, int(start.max()) + taps - first
    matrix = sparse.csr_array((weights.ravel(), (rows, (k - first).ravel())), shape=shape)
    low, high = float(at.min()) - 0.5 * active, float(at.max()) + 0.5 * active
    rounding = 2.0**-50 * math.sqrt(taps)
    return Readout(matrix, first, gate.error + cut + rounding, float(np.abs(weights).sum(axis=1).max()), low, high)


@lru_cache(maxsize=16)
def ends(gate: Gate) -> tuple[float, float]:
    """Return a distance in v, and what h times the sum of abs(g) over all samples farther than that is at most."""
    from scipy.special import exp1

    large = -math.log(gate.error)
    s = _fall(gate)
    beyond = math.sqrt(2.0 * (large - math.log(large + 1.0))) / s
    # Each side is below the integral from one step nearer on, and abs(g) <= exp(-(s x)^2 / 2) / (pi x).
    return beyond + gate.h, float(exp1(0.5 * (s * beyond) ** 2)) / math.pi


@lru_cache(maxsize=16)
def gained(gate: Gate) -> float:
    """Bound h times the sum of abs(g) over samples anywhere."""
    return 1.02 * readout(tuple(np.linspace(0.0, gate.h, 65)), 0.0, gate).gain


def _fall(gate: Gate) -> float:
    return gate.width / math.sqrt(2.0)


def _averaged(x: Array, active: float, gate: Gate) -> Array:
    """Return g averaged over a pixel around x."""
    if active == 0.0:
        return _gate(x, gate)
    return np.asarray((_passed(x + 0.5 * active, gate) - _passed(x - 0.5 * active, gate)) / active)


def _passed(x: Array, gate: Gate) -> Array:
    """Return the integral of g from 0 to x."""
    far = 9.0 / _fall(gate)  # beyond which there is 1e-18 of it
    nodes, weights = gauss_legendre(math.ceil(0.5 * far * gate.middle) + 40)
    flat = np.clip(x, -far, far).ravel()
    found = np.empty(flat.size)
    for start in range(0, flat.size, 2**14):
        part = flat[start : start + 2**14]
        found[start : start + 2**14] = part * (_gate(np.multiply.outer(part, nodes), gate) @ weights)
    return found.reshape(x.shape)


def _gate(x: Array, gate: Gate) -> Array:
    rate = gate.middle / math.pi
    return np.asarray(rate * np.sinc(rate * x) * np.exp(-0.5 * (_fall(gate) * x) ** 2))
