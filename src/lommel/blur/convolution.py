"""Sampled images convolved with blur by FFT, on a lattice that is proven wide enough, with values of any pixels.

There are two kinds of kernels. Jitter, diffusion and motion are negligible beyond their `reach`: the response
``P(w) = sum_m (T G)(w + 2 pi m / h)`` multiplies the transform of the lattice, and the errors by wrapping around and
by truncation are those of the kernel beyond the reach. Seeing has a wide halo: its kernel is tabulated, the lattice
holds all of it, and the error is the light beyond the lattice times the kernel there (turbulence.py).

Values of pixels of any size and position from samples on a square lattice, along rows, then columns.
The transform of ``box(w) exp(-(w / s)^2 / 2)``, boxes being convolved with the Gaussian, is
``g(x) = sin(m x) / (pi x) exp(-(s x)^2 / 2)``: a gate from ``-m`` to ``m`` whose fall is an error function. So
``h sum_k g(x - k h) exp(i w k h) = exp(i w x)`` for ``abs(w) <= 2`` but for the error of the gate (Poisson's sum),
and g averaged over a pixel gives averages. The sum truncated after some samples errs by an exponential integral.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.blur.blurs import Blur
from lommel.blur.turbulence import Gate, Halo, between, table
from lommel.core.engine import distinct_radii
from lommel.special.legendre import gauss_legendre

if TYPE_CHECKING:
    from scipy.sparse import csr_array


class Readout(NamedTuple):
    """Sparse matrix from samples, from index `first` on, to pixels; `error` bounds its response up to w = 2."""

    matrix: csr_array
    first: int
    error: float
    gain: float
    low: float  # lower edge of the first pixel, in v
    high: float  # upper edge of the last pixel, in v

    def ends(self, reach: float) -> tuple[float, float]:
        """Return the interval in v that holds the axis and all places within `reach` of the pixels."""
        return min(self.low - reach, 0.0), max(self.high + reach, 0.0)

    @property
    def samples(self) -> int:
        """Number of samples."""
        return int(self.matrix.shape[1])


@lru_cache(maxsize=8)
def readout(places: tuple[float, ...], active: float, gate: Gate) -> Readout:
    """Return the weights of samples for averages over `active` around rising `places`, in v; point values for 0."""
    from scipy import sparse

    at = np.array(places)
    h, (beyond, cut) = gate.h, ends(gate)
    # An odd number of taps, symmetric about the sample nearest to the pixel's middle.
    taps = 2 * math.ceil((beyond + 0.5 * active) / h) + 1
    start = np.rint(at / h).astype(np.int64) - taps // 2
    k = start[:, None] + np.arange(taps)
    weights = h * _averaged(at[:, None] - h * k, active, gate)
    first = int(start.min())
    rows = np.repeat(np.arange(at.size), taps)
    shape = at.size, int(start.max()) + taps - first
    matrix = sparse.csr_array((weights.ravel(), (rows, (k - first).ravel())), shape=shape)
    low, high = float(at.min()) - 0.5 * active, float(at.max()) + 0.5 * active
    # Weights are rounded, sums of `taps` products too; sqrt(taps) as of errors of random sign.
    rounding = 2.0**-50 * math.sqrt(taps)
    return Readout(matrix, first, gate.error + cut + rounding, float(np.abs(weights).sum(axis=1).max()), low, high)


@lru_cache(maxsize=16)
def ends(gate: Gate) -> tuple[float, float]:
    """Return a truncation distance in v, and a bound on h times the sum of abs(g) over all samples beyond it."""
    from scipy.special import exp1

    # Where exp(-(s x)^2 / 2) / (pi x) sums to about the error of the gate: E1(y) ~ exp(-y) / y.
    large = -math.log(gate.error)
    s = _fall(gate)
    beyond = math.sqrt(2.0 * (large - math.log(large + 1.0))) / s
    # Each side is below the integral from one step nearer on, and abs(g) <= exp(-(s x)^2 / 2) / (pi x).
    return beyond + gate.h, float(exp1(0.5 * (s * beyond) ** 2)) / math.pi


@lru_cache(maxsize=16)
def gained(gate: Gate) -> float:
    """Bound h times the sum of abs(g) over samples anywhere."""
    # Over one step all positions of samples occur; 2 % cover what lies between 65 of them.
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
    # Gauss nodes for half a wave of sin(middle x) each, and 40 for the Gaussian factor.
    far = 9.0 / _fall(gate)  # beyond which there is 1e-18 of it
    nodes, weights = gauss_legendre(math.ceil(0.5 * far * gate.middle) + 40)
    flat = np.clip(x, -far, far).ravel()
    found = np.empty(flat.size)
    # Blocks bound the memory of the product of places and nodes.
    for start in range(0, flat.size, 2**14):
        part = flat[start : start + 2**14]
        found[start : start + 2**14] = part * (_gate(np.multiply.outer(part, nodes), gate) @ weights)
    return found.reshape(x.shape)


def _gate(x: Array, gate: Gate) -> Array:
    rate = gate.middle / math.pi
    return np.asarray(rate * np.sinc(rate * x) * np.exp(-0.5 * (_fall(gate) * x) ** 2))


_U = 2.0**-53


class Short(NamedTuple):
    """The Gaussian covariance (x, y) and the streaks, shape (k, 2), of blur of finite extent, in v."""

    covariance: Array
    streaks: Array

    @classmethod
    def of(cls, several: tuple[Blur, ...], scale: float) -> Short:
        """Return those of several blurs; `scale` is one lambda*N in their unit."""
        to_v = math.pi / scale
        covariance = sum((blur.covariance for blur in several), np.zeros((2, 2)))
        streaks = [blur.streak for blur in several if blur.streak != (0.0, 0.0)]
        return cls(to_v**2 * covariance, to_v * np.array(streaks).reshape(-1, 2))

    @property
    def nothing(self) -> bool:
        """Whether there is no such blur."""
        return not (self.covariance.any() or self.streaks.size)

    def reach(self, left: float) -> tuple[float, float]:
        """Return the distances along x and y that all but a part `left` of the light moves at most."""
        deviations = np.sqrt(np.diag(self.covariance))
        # Half of `left` for the Gaussian's tails; a streak ends at half its length on either side.
        far = math.sqrt(2.0) * float(scipy.special.erfcinv(min(0.5 * left, 1.0)))
        x, y = far * deviations + 0.5 * np.abs(self.streaks).sum(axis=0)
        return float(x), float(y)

    def response(self, x: Array, y: Array) -> Array:
        """Return the transfer function at w = (x, y)."""
        (xx, xy), (_, yy) = self.covariance
        found = np.exp(-0.5 * (xx * x * x + 2.0 * xy * x * y + yy * y * y))
        for dx, dy in self.streaks:
            # np.sinc has the factor pi in it, and w = 2 pi f.
            found *= np.sinc((dx * x + dy * y) / (2.0 * math.pi))
        return np.asarray(found)


class Spread(NamedTuple):
    """The response of blur on a lattice, shape (rows, columns // 2 + 1), with bounds on its errors."""

    response: NDArray[np.generic]
    size: tuple[int, ...]  # of the padded lattice
    gain: float  # sum of the moduli of the kernel
    norm: float  # root of the sum of its squares
    error: float  # bound on the error of the response for abs(w) <= 2
    missing: float  # bound on the blur, in v, that light beyond the lattice would arrive with
    off: float  # bound on the error of the kernel, in v
    core: float  # the largest value of the kernel of a halo, 0 without
    blind: float  # bound on the sum of its moduli beyond its reach, wrapped around or absent

    def on(self, samples: Array, threads: int) -> Array:
        """Return a stack of samples, shape (n, rows, columns), spread."""
        workers = threads or -1
        out = np.empty(samples.shape)
        for one, place in zip(samples, out, strict=True):
            turned = scipy.fft.rfft2(one, self.size, workers=workers)
            turned *= self.response
            place[:] = scipy.fft.irfft2(turned, self.size, workers=workers)[: one.shape[0], : one.shape[1]]
        return out

    def rounding(self, samples: Array) -> float:
        """Bound what transforms in double precision add to any value of these samples."""
        size = float(np.sqrt((samples**2).sum(axis=(1, 2)).max()))
        return 20.0 * math.log2(math.prod(self.size)) * _U * self.norm * size


def spread(short: Short, halo: Halo, least: tuple[int, int], margin: float, *, ended: bool) -> Spread:
    """Return the response on a lattice of at least `least` samples.

    Light spreads up to `margin` (v) beyond the pixels if all blur has `ended` at ``abs(w) = 2``, otherwise beyond the
    samples that the gate of the readout takes.
    """
    gate, seen = halo.gate, bool(halo.several)
    # Lengths with small prime factors: transforms of others take several times as long.
    size = tuple(scipy.fft.next_fast_len(side, real=True) for side in least)
    y = 2.0 * math.pi / gate.h * scipy.fft.fftfreq(size[0])[:, None]
    x = 2.0 * math.pi / gate.h * scipy.fft.rfftfreq(size[1])
    response: NDArray[np.generic] = np.ones((size[0], x.size))
    error = blind = missing = off = core = 0.0
    gain = norm = 1.0
    if not short.nothing:
        response, error = _periodic(short, gate, x, y), 3.0 * gate.error
        # The sum of moduli of a kernel of finite extent beyond its reach and that of the gate, twice.
        blind = 2.0 * gained(gate) * (gate.error * gained(gate) + 2.0 * ends(gate)[1])
        kernel = scipy.fft.irfft2(response, size)
        gain, norm = float(np.abs(kernel).sum()), float(np.sqrt((kernel**2).sum()))
    if seen:
        # Relative to the density in v^-2; the table holds weights per sample, h^2 times that.
        tabulated, apart = _kernel(halo, size)
        core = float(tabulated.max()) / gate.h**2
        # Light that finite blur moves farther than its reach is at most this part of the brightest value.
        far = halo.bound(margin) + (0.0 if short.nothing else gate.error * core)
        missing = far if ended else gain * halo.gated_bound(margin) + blind * core
        off = gain * apart * core
        response = scipy.fft.rfft2(tabulated) * response
        kernel = scipy.fft.irfft2(response, size)
        error += gate.error
        gain, norm = float(np.abs(kernel).sum()), float(np.sqrt((kernel**2).sum()))
    return Spread(response, size, gain, norm, error, missing, off, core, blind)


def _periodic(short: Short, gate: Gate, x: Array, y: Array) -> Array:
    # Copies at whole periods 2 pi / h are what sampling adds (Poisson); beyond the nearest, the gate is 0.
    """Return the response of samples: that of the plane, gated along both axes, and its copies."""
    period = 2.0 * math.pi / gate.h
    found = np.zeros((y.size, x.size))
    for i in (-1.0, 0.0, 1.0):
        for j in (-1.0, 0.0, 1.0):
            across, down = x + i * period, y + j * period
            found += short.response(across, down) * _gated(across, gate) * _gated(down, gate)
    return found


def _gated(w: Array, gate: Gate) -> Array:
    erfc = scipy.special.erfc
    return np.asarray(0.5 * (erfc((w - gate.middle) / gate.width) - erfc((w + gate.middle) / gate.width)))


def _kernel(halo: Halo, size: tuple[int, ...]) -> tuple[Array, float]:
    """Return the kernel of a halo on a lattice, its centre at the first corner, and its error over its peak."""
    h, half = halo.gate.h, (size[0] // 2 + 1, size[1] // 2 + 1)
    # About what the gate makes of the light of the band.
    error = max(0.1 * halo.gate.error / float(halo.at(np.zeros(1))[0]), 1e-12)
    filtered, step, off = table(halo, h * math.hypot(*half), error)
    # By symmetry one octant has all distances: tabulated once, then mirrored to the whole lattice.
    squares, index = distinct_radii(half[0] - 1, half[1] - 1)
    quadrant = h * h * between(filtered, step, error, h * np.sqrt(squares))[index]
    # The kernel wraps around: index n - k is the distance k on the other side.
    rows, columns = (np.minimum(k := np.arange(n), n - k) for n in size)
    return quadrant[rows[:, None], columns], off
