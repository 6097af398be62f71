r"""The kernel of atmospheric turbulence, sampled: its wings fall as r^(-11/3).

With w in units in which the image ends at 2, ``c(r) = (1 / 2 pi) int T(w) G(w) J0(w r) w dw``, G a gate that is 1
up to 2 and 0 where samples h apart would confuse w with less than that. With ``w = u^3`` both ``w^(5/3)`` and von
Karman's structure function are entire, so that Gauss's rule converges geometrically from 0 on.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import scipy

from lommel.base.arrays import Array
from lommel.blur.blurs import Blur, Seeing
from lommel.core.engine import product
from lommel.special.interpolation import steps
from lommel.special.legendre import gauss_legendre

_BAND = 1.2  # radians from one entry of a table to the next
_NODES, _PHASE = 40, 40.0  # nodes of a panel, and the radians of J0 that it holds at most
_DARK = 1e-22  # response below which the rule ends
_KEPT = 2**20  # values of J0 that are kept


class Gate(NamedTuple):
    """A response of 1 up to ``w = 2`` and 0 from ``2 pi / h - 2`` on, each within `error`."""

    h: float
    middle: float
    width: float
    error: float

    @classmethod
    def of(cls, h: float, error: float) -> Gate:
        """Return the gate for samples `h` apart that errs by at most `error`."""
        # The nearest copy of the band 2 begins at 2 pi / h - 2 (Poisson); the gate falls in the middle between both.
        far = 2.0 * math.pi / h - 2.0
        return cls(h, 0.5 * (2.0 + far), 0.5 * (far - 2.0) / float(scipy.special.erfcinv(0.5 * error)), error)

    def round(self, w: Array) -> Array:
        """Return the rotationally symmetric response at frequencies of modulus w, smooth in w^2."""
        # In w^2, which is smooth on the plane of frequencies; w itself has a kink at 0.
        middle, half, fall = self._squared
        return np.asarray(0.5 * scipy.special.erfc((w * w - middle) / half * (fall / self.width)))

    @property
    def end(self) -> float:
        """Frequency beyond which the round response is below 1e-30."""
        middle, half, fall = self._squared
        # erfc(8.3) = 8e-32.
        return math.sqrt(middle + 8.3 * half * self.width / fall)

    @property
    def _squared(self) -> tuple[float, float, float]:
        # Middle and half of the fall in w^2, and half of it in w.
        far = 2.0 * math.pi / self.h - 2.0
        return 0.5 * (4.0 + far * far), 0.5 * (far * far - 4.0), 0.5 * (far - 2.0)


class Halo(NamedTuple):
    """Rotationally symmetric blur by turbulence as a kernel."""

    several: tuple[Seeing, ...]
    scale: float
    wavelength: float | None
    gate: Gate

    @classmethod
    def of(cls, several: tuple[Blur, ...], scale: float, wavelength: float | None, gate: Gate) -> Halo:
        """Return the seeing of several blurs in light of a wavelength, of which one lambda*N is `scale`."""
        return cls(tuple(blur for blur in several if isinstance(blur, Seeing)), scale, wavelength, gate)

    def response(self, w: Array) -> Array:
        """Return the transfer function at w, without the gate."""
        found = np.ones(w.shape)
        for blur in self.several:
            found *= blur.transfer(w / (2.0 * self.scale), wavelength=self.wavelength)
        return found

    @property
    def finest(self) -> float:
        """Least scale in w over which the response changes."""
        found = 0.5
        for blur in self.several:
            outer = math.inf if blur.outer_scale is None else blur.outer_scale / (2.0 * math.pi * blur.r0)
            found = min(found, self.scale * blur.coherence(self.wavelength) * min(1.0, outer))
        return found

    def at(self, r: Array) -> Array:
        """Return the kernel at radii in v, directly."""
        w, weight = _rule(self, float(np.max(r, initial=1.0)))
        return _transformed(weight, w, r)

    def bound(self, far: float) -> float:
        """Bound the density of the shifts, ungated, beyond the radius `far`."""
        # Seeing is a mixture of Gaussians, and so is its density b: it falls with r, and a Gaussian of the variance t
        # is at R at most 1 / (1 - 2 s / R^2) times one of the variance t + s. So b(R) is bounded by the transform of
        # T exp(-s w^2 / 2), which ends soon (certificate, section 17).
        s = min(2.0, 0.02 * far * far)
        w, weight = _rule(self, far, gated=False)
        soft = weight * np.exp(-0.5 * s * w * w)
        rounding = 2.0**-46 * float(np.abs(soft).sum())
        return (max(float(scipy.special.j0(far * w) @ soft), 0.0) + rounding) / (1.0 - 2.0 * s / far**2)

    def gated_bound(self, far: float) -> float:
        """Bound the modulus of the gated kernel, the density convolved with the transform of the gate."""
        # abs(c(r)) <= b(R - rho) int abs(g) + max abs(g) beyond rho: certificate, section 17; rho up to 45, where g
        # is dark.
        near = far - min(0.25 * far, 45.0)
        smear, left = _gate_norm(self.gate, far - near)
        return smear * self.bound(near) + left


@lru_cache(maxsize=8)
def _rule(halo: Halo, far: float, *, gated: bool = True) -> tuple[Array, Array]:
    """Return nodes in w, and weights of ``(1 / 2 pi) T G w dw`` for waves up to the radius `far`."""
    w, weight = _nodes(*_panels(halo, far, gated=gated))
    found = weight * halo.response(w)
    return w, found * halo.gate.round(w) if gated else found


def _panels(halo: Halo, far: float, *, gated: bool = True) -> tuple[float, int]:
    """Return the end of the rule in w and its number of panels, rounded up so that seeing shares nodes."""
    # Ungated, exp(-s w^2 / 2) with s = 2 ends the integral: exp(-121) at w = 11.
    end = halo.gate.end if gated else 11.0
    probe = np.linspace(0.0, end, 4097)
    # Beyond a response of 1e-22 nothing adds to a double.
    dark = np.flatnonzero(halo.response(probe) < _DARK)
    end = min(end, 0.25 * math.ceil(4.0 * float(probe[dark[0]]))) if dark.size else end
    return end, 4 * math.ceil(0.25 * end / min(_PHASE / max(far, 1.0), halo.finest))


@lru_cache(maxsize=8)
def _nodes(end: float, panels: int) -> tuple[Array, Array]:
    """Return nodes in w from 0 to `end`, and their weights of ``(1 / 2 pi) w dw``."""
    edges = np.cbrt(np.linspace(0.0, end, panels + 1))
    # The first panel, over which w varies from 0 on, is cut twice: there the cube root has its singularity.
    edges = np.concatenate([edges[:1], edges[1] * np.array([0.5, 0.75]), edges[1:]])
    x, weight = gauss_legendre(_NODES)
    wide = np.diff(edges)[:, None]
    u = (edges[:-1, None] + wide * x).ravel()
    # w = u^3, w dw = 3 u^5 du.
    return u**3, (wide * weight).ravel() * 3.0 * u**5 / (2.0 * math.pi)


@lru_cache(maxsize=4)
def _waves(end: float, panels: int, step: float, count: int) -> Array:
    """Return J0 at `count` equal steps of r and all nodes, shared by all seeing."""
    w, _ = _nodes(end, panels)
    return np.asarray(scipy.special.j0(np.multiply.outer(step * np.arange(float(count)), w)))


def _transformed(weight: Array, w: Array, r: Array) -> Array:
    out = np.empty(r.shape)
    # Blocks of 2^21 values, 16 MB, bound the memory.
    many = max(1, 2**21 // w.size)
    for start in range(0, r.size, many):
        part = slice(start, start + many)
        out[part] = _summed(scipy.special.j0(np.multiply.outer(r[part], w)), weight)
    return out


def _summed(waves: Array, weight: Array) -> Array:
    # By the core: of sums this short, threads of BLAS wait for each other longer than they take.
    return product(waves, weight[:, None], 1)[:, 0]


@lru_cache(maxsize=4)
def table(halo: Halo, far: float, error: float) -> tuple[Array, float, float]:
    """Return the kernel at equal steps of r to beyond `far`, the step, and the interpolation error over ``c(0)``."""
    w, weight = _rule(halo, far)
    step = _BAND / float(w.max())
    rule = steps(_BAND, error)
    beyond = rule.filter.size - 1
    count = math.ceil(far / step) + rule.taps.size + 1 + beyond
    if count * w.size <= _KEPT:
        found = _summed(_waves(*_panels(halo, far), step, count), weight)
    else:
        found = _transformed(weight, w, step * np.arange(float(count)))
    # The kernel is even in r: the filter sees its mirror image below 0.
    mirrored = np.concatenate([found[beyond:0:-1], found])
    filtered = np.convolve(mirrored, np.concatenate([rule.filter[:0:-1], rule.filter]), "valid")
    return filtered, step, rule.error


def between(known: Array, step: float, error: float, r: Array) -> Array:
    """Return the kernel at radii `r` within a :func:`table`."""
    taps = steps(_BAND, error).taps
    half = taps.size // 2
    mirrored = np.concatenate([known[half:0:-1], known])
    # The last cells take the taps of the one before: the table ends there.
    cell = np.minimum((r / step).astype(np.int64), known.size - half - 1)
    found = np.zeros(r.shape)
    weights = taps.at((r / step - cell).ravel()).reshape(*r.shape, taps.size)
    for k in range(taps.size):
        found += weights[..., k] * mirrored[cell + k + 1]
    return found


@lru_cache(maxsize=16)
def _gate_norm(gate: Gate, far: float) -> tuple[float, float]:
    """Return the integral of the modulus of the transform of a gate, and its largest value from `far` on."""
    x, weight = gauss_legendre(400)
    w, weight = gate.end * x, gate.end * weight
    r: Array = np.linspace(0.0, 60.0, 4001)
    g = np.abs(_transformed(weight * w * gate.round(w) / (2.0 * math.pi), w, r))
    # It falls faster than exponentially; the part beyond 60 is below 1 %.
    return 1.01 * float(2.0 * math.pi * np.trapezoid(g * r, r)), float(g[r >= min(far, 45.0)].max())
