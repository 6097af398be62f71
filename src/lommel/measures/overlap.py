r"""What two apertures share, one shifted against the other: the autocorrelation of the pupil function P.

With f in units of the cutoff ``1 / (lambda N)`` and pupil coordinates over the radius of the aperture,

    OTF(f) = int P(rho - f) conj(P(rho + f)) d^2 rho / int abs(P)^2 d^2 rho .

In coordinates (u, y) along and across f, ``y = sin(theta)`` makes the ends of
the lens-shaped overlap of two discs, ``u = +-(cos(theta) - f)``, entire functions of theta, so Gauss-Legendre nodes
in theta and u converge spectrally. An obscured aperture is cut where its arcs meet, with ``y = eps sin(theta)``
beside the obscuration.

References
----------
H. H. Hopkins, "The frequency response of a defocused optical system", Proc. R. Soc. A 231, 91 (1955),
doi:10.1098/rspa.1955.0158. E. L. O'Neill, "Transfer function for an annular aperture", J. Opt. Soc. Am. 46, 285
(1956), doi:10.1364/JOSA.46.000285.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import ToleranceError
from lommel.optics.pupil import Pupil
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre

_CHUNK = 2**20
"""Pupil values held at once."""
_MAX_NODES = 4096


def autocorrelation(pupil: Pupil, f: Array, tol: float) -> NDArray[np.complex128]:
    """Return the OTF at frequencies f over the cutoff, shape (points, 2), for the flattened stack."""
    if pupil.radial:
        # It depends on the length of f only.
        canonical = np.stack([np.hypot(f[:, 0], f[:, 1]), np.zeros(len(f))], axis=-1)
        mirrored = np.zeros(len(f), dtype=bool)
    else:
        # OTF(-f) is the conjugate of OTF(f).
        mirrored = (f[:, 1] < 0) | ((f[:, 1] == 0) & (f[:, 0] < 0))
        canonical = np.where(mirrored[:, None], -f, f)
    points, where = np.unique(canonical, axis=0, return_inverse=True)
    where = where.reshape(-1)
    shift = np.hypot(points[:, 0], points[:, 1])
    values = np.zeros((math.prod(pupil.shape), len(points)), dtype=np.complex128)
    # Nearer to 0 than this nothing changes, and quotients overflow.
    values[:, shift <= 1e-100] = 1.0
    within = np.flatnonzero((shift > 1e-100) & (shift < 1))
    blur = float(pupil.v(pupil.geometric_radius()).max())
    # Alike frequencies take alike many nodes.
    for group in (
        np.array_split(within[np.argsort(shift[within])], math.ceil(len(within) / 32)) if len(within) else []
    ):
        values[:, group] = _refined(pupil, points[group], shift[group], blur, tol)
    values = values[:, where]
    return np.where(mirrored, values.conj(), values)


def _refined(pupil: Pupil, f: Array, shift: Array, blur: float, tol: float) -> NDArray[np.complex128]:
    """Return the OTF at few frequencies with as many nodes as it takes."""
    # Half of the phase that a line of the overlap sees, about; too few nodes are found out by those that follow.
    swing = 2.0 * blur * (1.0 - float(shift.min())) * min(1.0, 2.0 * float(shift.max()))
    nodes = 16 + math.ceil(0.25 * swing + 0.25 * pupil.illumination.slope)
    before: NDArray[np.complex128] | None = None
    while nodes <= _MAX_NODES:
        value = _overlap_integral(pupil, f, shift, nodes)
        if before is not None and np.abs(value - before).max() <= tol + 1e-15 * blur:
            return value
        before, nodes = value, math.ceil(1.4 * nodes)
    raise ToleranceError(f"the OTF to tol={tol:g} takes more than {_MAX_NODES} nodes along a line")


def _overlap_integral(pupil: Pupil, f: Array, shift: Array, nodes: int) -> NDArray[np.complex128]:
    """Return the autocorrelation at f by `nodes` Gauss nodes along and across each part of the overlap."""
    x, w = gauss_legendre(nodes)
    which, y, low, width, weight = _lines(shift, pupil.obscuration, x, w)
    if not pupil.radial:
        which, low, width, weight = (np.tile(part, 2) for part in (which, low, width, 0.5 * weight))
        y = np.concatenate([y, -y])
    out = np.zeros((math.prod(pupil.shape), len(f)), dtype=np.complex128)
    many = max(1, _CHUNK // (len(out) * nodes))
    for start in range(0, y.size, many):
        part = slice(start, start + many)
        at = which[part]
        along = low[part, None] + width[part, None] * x
        cos, sin = (f[at].T / shift[at])[:, :, None]
        px = along * cos - y[part, None] * sin
        py = along * sin + y[part, None] * cos
        fx, fy = f[at].T[:, :, None]
        if pupil.radial:
            product = _radial_product(pupil, (px - fx) ** 2 + (py - fy) ** 2, (px + fx) ** 2 + (py + fy) ** 2)
        else:
            product = pupil.values(px - fx, py - fy) * pupil.values(px + fx, py + fy).conj()
        np.add.at(out.T, at, ((product @ w) * (width[part] * weight[part])).T)
    return out / (math.pi * pupil.transmission)


def _radial_product(pupil: Pupil, s: Array, t: Array) -> NDArray[Any]:
    """Return the real part of ``P(s) conj(P(t))``, s and t being rho^2; the imaginary one is odd in u."""
    terms = pupil.radial_terms()
    product = np.cos(zernike.legendre_sum(terms, 2.0 * s - 1.0) - zernike.legendre_sum(terms, 2.0 * t - 1.0))
    if not pupil.illumination.uniform:
        product *= pupil.illumination.at(s) * pupil.illumination.at(t)
    return np.asarray(product)


def _lines(shift: Array, eps: float, x: Array, w: Array) -> tuple[NDArray[Any], ...]:
    """Return the lines of constant y > 0 that cover the overlaps: frequency, y, begin in u, length, weight in y.

    Each overlap is symmetric in y, and its upper half covered with twice the weight. Within a panel its ends are
    analytic functions of the angle.
    """
    end = 2.0 * np.arcsin(np.sqrt(0.5 * (1.0 - shift)))  # arccos(shift), exact near 1
    top = np.sqrt((1.0 - shift) * (1.0 + shift))
    found = [_panel(np.arcsin(np.minimum(eps, top)), end, 1.0, shift, eps, x, w)]
    if eps > 0:
        # Where the rim of one aperture meets the obscuration of the other, and both obscurations one another.
        meets = shift - (1.0 - eps**2) / (4.0 * shift)
        last = np.arcsin(np.minimum(1.0, top / eps))
        rim = np.arccos(np.minimum(1.0, np.abs(meets) / eps))
        both = np.arccos(np.minimum(1.0, shift / eps))
        edges = np.sort(np.minimum([np.zeros_like(last), rim, both, last], last), axis=0)
        found += [_panel(a, b, eps, shift, eps, x, w) for a, b in pairwise(edges)]
    which, y, low, width, weight = (np.concatenate(part) for part in zip(*found, strict=True))
    kept = width * weight > 0
    which, y, low, width, weight = (part[kept] for part in (which, y, low, width, weight))
    return which, y, low, width, 2.0 * weight


def _panel(
    first: Array,
    last: Array,
    radius: float,
    shift: Array,
    eps: float,
    x: Array,
    w: Array,
) -> tuple[NDArray[Any], ...]:
    """Return the lines with ``y = radius sin(theta)``, theta from `first` to `last`, one of each a frequency."""
    theta = first[:, None] + (last - first)[:, None] * x
    y = radius * np.sin(theta)
    weight = (last - first)[:, None] * w * radius * np.cos(theta)
    f = shift[:, None]
    rim = np.sqrt((1.0 - y) * (1.0 + y))
    if radius == 1.0:  # beside the obscurations
        pieces = [(f - rim, rim - f)]
    else:
        hole = eps * np.cos(theta)
        right = [(f - rim, f - hole), (f + hole, f + rim)]
        left = [(-f - rim, -f - hole), (-f + hole, -f + rim)]
        pieces = [(np.maximum(a, c), np.minimum(b, d)) for a, b in right for c, d in left]
    which = np.broadcast_to(np.arange(shift.size)[:, None], y.shape).ravel()
    lines = (which, y.ravel(), weight.ravel())
    parts = [(*lines[:2], low.ravel(), np.maximum(high - low, 0.0).ravel(), lines[2]) for low, high in pieces]
    return tuple(np.concatenate(part) for part in zip(*parts, strict=True))
