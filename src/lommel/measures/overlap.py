r"""Autocorrelation of the pupil function P, over the overlap of two shifted apertures.

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
from collections.abc import Callable
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.core.answers import ToleranceError
from lommel.optics.aperture.shapes import CatEye, Ellipse
from lommel.optics.pupil import Pupil
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre

_CHUNK = 2**20
"""Pupil values held at once."""
_MAX_NODES = 4096


def autocorrelation(pupil: Pupil, f: Array, tol: float) -> NDArray[np.complex128]:
    """Return the OTF at frequencies f over the cutoff, shape (points, 2), for the flattened stack."""
    if pupil.circular and pupil.radial:
        # It depends on the length of f only.
        canonical = np.stack([np.hypot(f[:, 0], f[:, 1]), np.zeros(len(f))], axis=-1)
        mirrored = np.zeros(len(f), dtype=bool)
    else:
        # OTF(-f) is the conjugate of OTF(f).
        mirrored = (f[:, 1] < 0) | ((f[:, 1] == 0) & (f[:, 0] < 0))
        canonical = np.where(mirrored[:, None], -f, f)
    points, where = np.unique(canonical, axis=0, return_inverse=True)
    shift = np.hypot(points[:, 0], points[:, 1])
    values = np.zeros((math.prod(pupil.shape), len(points)), dtype=np.complex128)
    # Nearer to 0 than this nothing changes: quotients overflow, or edges are known to rounding only.
    least = 1e-100 if pupil.circular else 1e-14
    values[:, shift <= least] = 1.0
    within = np.flatnonzero((shift > least) & (shift < 1))
    blur = float(pupil.v(pupil.geometric_radius()).max())
    # Alike frequencies take alike many nodes; the lines across other apertures are those of one frequency.
    together = 32 if pupil.circular else 1
    within = within[np.argsort(shift[within])]
    integral = _of_discs if pupil.circular else _of_clear_parts
    for group in np.array_split(within, math.ceil(len(within) / together)) if len(within) else ():
        values[:, group] = integral(pupil, points[group], shift[group], blur, tol)
    values = values[:, where.reshape(-1)]
    return np.where(mirrored, values.conj(), values)


def _of_discs(pupil: Pupil, f: Array, shift: Array, blur: float, tol: float) -> NDArray[np.complex128]:
    """Return the OTF of circular or annular apertures at few frequencies."""
    # Half of the phase that a line of the overlap sees, about; too few nodes are found out by those that follow.
    swing = 2.0 * blur * (1.0 - float(shift.min())) * min(1.0, 2.0 * float(shift.max()))
    nodes = 16 + math.ceil(0.25 * swing + 0.25 * pupil.illumination.slope)
    return _settled(lambda nodes: _overlap_integral(pupil, f, shift, nodes), nodes, tol, tol + 1e-15 * blur)


def _of_clear_parts(pupil: Pupil, f: Array, shift: Array, blur: float, tol: float) -> NDArray[np.complex128]:
    """Return the OTF of other apertures at one frequency, with more nodes along the lines until two sums agree."""
    swing = 2.0 * blur * min(1.0, 2.0 * float(shift[0]))
    nodes, overlap = 12 + math.ceil(0.25 * (swing + pupil.illumination.slope)), _Overlap(pupil, f[0])
    found = _settled(lambda nodes: overlap.across(nodes, 0.25 * tol), nodes, tol, 0.5 * tol + 1e-15 * blur)
    return found[:, None]


def _settled(
    integral: Callable[[int], NDArray[np.complex128]], nodes: int, tol: float, least: float
) -> NDArray[np.complex128]:
    """Return an integral with as many nodes as it takes until two differ by no more than `least`."""
    before: NDArray[np.complex128] | None = None
    while nodes <= _MAX_NODES:
        value = integral(nodes)
        if before is not None and np.abs(value - before).max() <= least:
            return value
        before, nodes = value, math.ceil(1.4 * nodes)
    raise ToleranceError(f"the OTF to tol={tol:g} takes more than {_MAX_NODES} nodes along a line")


def _overlap_integral(pupil: Pupil, f: Array, shift: Array, nodes: int) -> NDArray[np.complex128]:
    """Return the autocorrelation at f by `nodes` Gauss nodes along and across each part of the overlap."""
    x, w = gauss_legendre(nodes)
    which, y, low, width, weight = _lines(shift, pupil.obscuration, x, w)
    if pupil.radial and pupil.illumination.uniform and not pupil.radial_terms()[:, 1:].any():
        lines = _defocused_lines(pupil.radial_terms()[:, :1] * shift[which], low, width) * weight
        return _summed(lines, which, len(f)) / (math.pi * pupil.transmission)
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


def _defocused_lines(slope: Array, low: Array, width: Array) -> Array:
    """Return the integrals along lines for defocus alone, shape (n, lines): the phase differs by ``8 slope u``."""
    return np.asarray(width * np.cos(8.0 * slope * (low + 0.5 * width)) * np.sinc(4.0 / math.pi * slope * width))


def _summed(lines: Array, which: NDArray[np.intp], count: int) -> NDArray[np.complex128]:
    """Return the sums of the integrals along the lines of each of `count` frequencies."""
    return np.array([np.bincount(which, each, count) for each in lines], dtype=np.complex128)


def _radial_product(pupil: Pupil, s: Array, t: Array) -> Values:
    """Return the real part of ``P(s) conj(P(t))``, s and t being rho^2; the imaginary one is odd in u."""
    terms = pupil.radial_terms()
    product = np.cos(zernike.legendre_sum(terms, 2.0 * s - 1.0) - zernike.legendre_sum(terms, 2.0 * t - 1.0))
    if not pupil.illumination.uniform:
        product *= pupil.illumination.at(s) * pupil.illumination.at(t)
    return np.asarray(product)


def _lines(shift: Array, eps: float, x: Array, w: Array) -> tuple[Values, ...]:
    """Return lines of constant y > 0 that cover the overlaps: frequency, y, start in u, length, weight in y."""
    # Overlaps are symmetric in y, so the upper half counts twice. Within a panel the ends are analytic in the angle.
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
    first: Array, last: Array, radius: float, shift: Array, eps: float, x: Array, w: Array
) -> tuple[Values, ...]:
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


# Along a line across the overlap every edge is met at the roots of a line or a quadratic, so the clear pieces are
# known exactly, and Gauss nodes in each converge spectrally. Across the lines the integrand has kinks where edges of
# one aperture cross those of the other: panels are halved there, and wherever two rules differ, until the sum of what
# they differ by is below the tolerance.

_ACROSS = 10  # nodes of a panel, and of each of its halves
_MOST = 4096  # panels halved at once
_LEVELS = 48  # times that a panel is halved: then it is as wide as rounding
_CUT_CHUNK = 2**19  # pupil values held at once


class _Overlap:
    """Two copies of an aperture, moved by f and -f, in coordinates u along f and y across."""

    def __init__(self, pupil: Pupil, f: Array) -> None:
        self.pupil, self.f = pupil, f
        self.shift = math.hypot(*f)
        self.cos, self.sin = f / self.shift
        self.scale = math.pi * pupil.transmission
        self.top = math.sqrt((1.0 - self.shift) * (1.0 + self.shift))  # where the overlap of the rims ends

    def across(self, nodes: int, tol: float) -> NDArray[np.complex128]:
        """Return the sum over panels in the angle theta, y = top sin(theta), halved until they err by less."""
        edges = np.unique(np.concatenate([np.linspace(-1.0, 1.0, 9), self._corners()]))
        low, high = np.arcsin(edges[:-1]), np.arcsin(edges[1:])
        whole = self._panels(low, high, nodes)
        total = np.zeros(len(whole), dtype=np.complex128)
        for _ in range(_LEVELS):
            middle = 0.5 * (low + high)
            left, right = np.split(self._panels(np.append(low, middle), np.append(middle, high), nodes), 2, axis=1)
            finer = left + right
            off = np.abs(finer - whole).max(axis=0)
            # The finer sum errs by a fraction of what it changed; where all are good the sum of them is.
            bad = off > tol / 64.0 if off.sum() > tol else np.zeros(off.size, dtype=bool)
            total += finer[:, ~bad].sum(axis=1)
            if not bad.any():
                return np.asarray(total / self.scale)
            if 2 * int(bad.sum()) > _MOST:
                raise ToleranceError(f"the OTF to tol={tol:g} takes more than {_MOST} panels")
            low, high = np.append(low[bad], middle[bad]), np.append(middle[bad], high[bad])
            whole = np.concatenate([left[:, bad], right[:, bad]], axis=1)
        return np.asarray((total + whole.sum(axis=1)) / self.scale)

    def _corners(self) -> Array:
        """Return y / top of corners and ends of the edges of one aperture, which both have, for vanes along f."""
        found = [self.pupil.obscuration]
        for angle in self.pupil.spider.angles if self.pupil.spider else ():
            half = 0.5 * self.pupil.spider.width  # type: ignore[union-attr]
            along = np.array(
                [0.0, math.sqrt(max(self.pupil.obscuration**2 - half**2, 0.0)), math.sqrt(1.0 - half**2)]
            )
            s, c = math.sin(angle) * self.cos - math.cos(angle) * self.sin, math.cos(angle) * self.cos
            c += math.sin(angle) * self.sin
            found += [*(along * s + half * c), *(along * s - half * c)]
        edge = self.pupil.vignetting
        if isinstance(edge, CatEye):
            across = edge.shift[1] * self.cos - edge.shift[0] * self.sin
            found += [across - edge.radius, across + edge.radius]
        elif isinstance(edge, Ellipse):
            found.append(float(np.linalg.norm(edge.frame.T @ np.array([-self.sin, self.cos]))))
        y = np.concatenate([found, np.negative(found)]) / self.top
        return y[np.abs(y) < 1.0]

    def _panels(self, low: Array, high: Array, nodes: int) -> NDArray[np.complex128]:
        """Return the integral over each panel of theta, shape (n, panels), with so many nodes along each piece."""
        x, w = gauss_legendre(_ACROSS)
        theta = low[:, None] + (high - low)[:, None] * x
        lines = self._lines(self.top * np.sin(theta).ravel(), nodes)
        weight = (w * (high - low)[:, None]) * self.top * np.cos(theta)
        return np.asarray((lines.reshape(len(lines), *weight.shape) * weight).sum(axis=-1))

    def _lines(self, y: Array, nodes: int) -> NDArray[np.complex128]:
        """Return the integral of both pupil functions along each line, shape (n, lines)."""
        half = np.sqrt((1.0 - y) * (1.0 + y))
        begin, end = self.shift - half, half - self.shift
        cuts = [begin, end]
        for center in (self.shift, -self.shift):
            cuts += [np.clip(np.nan_to_num(center + at, nan=2.0), begin, end) for at in self._crossings(y)]
        edges = np.sort(cuts, axis=0)
        first, width = edges[:-1], np.diff(edges, axis=0)
        middle = first + 0.5 * width
        px, py = middle * self.cos - y * self.sin, middle * self.sin + y * self.cos
        opening = self.pupil.opening
        clear = (width > 0.0) & (opening.margin(px - self.f[0], py - self.f[1]) > 0.0)
        clear &= opening.margin(px + self.f[0], py + self.f[1]) > 0.0
        piece, line = np.nonzero(clear)
        x, w = gauss_legendre(nodes)
        out = np.zeros((math.prod(self.pupil.shape), y.size), dtype=np.complex128)
        many = max(1, _CUT_CHUNK // (len(out) * nodes))
        for start in range(0, line.size, many):
            at = (piece[start : start + many], line[start : start + many])
            u = first[at][:, None] + width[at][:, None] * x
            across = y[at[1]][:, None]
            px, py = u * self.cos - across * self.sin, u * self.sin + across * self.cos
            product = self._function(px - self.f[0], py - self.f[1])
            product *= self._function(px + self.f[0], py + self.f[1]).conj()
            np.add.at(out.T, at[1], ((product @ w) * width[at]).T)
        return out

    def _function(self, x: Array, y: Array) -> NDArray[np.complex128]:
        """Return the pupil function as it goes on behind its edges: pieces end at these, and rounding is not to."""
        rho = np.hypot(x, y)
        phase = self.pupil.wavefront.phase(np.minimum(rho, 1.0), np.arctan2(y, x)).reshape(-1, *rho.shape)
        return np.asarray(self.pupil.illumination.at(rho**2) * np.exp(1j * phase))

    def _crossings(self, y: Array) -> list[Array]:
        """Return where lines meet each edge of an aperture around the origin; NaN, or far away, where they do not."""
        pupil, found = self.pupil, []
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            root = np.sqrt(pupil.obscuration**2 - y * y)
            found += [-root, root, -np.sqrt(1.0 - y * y), np.sqrt(1.0 - y * y)]
            for angle in pupil.spider.angles if pupil.spider else ():
                c = math.cos(angle) * self.cos + math.sin(angle) * self.sin
                s = math.sin(angle) * self.cos - math.cos(angle) * self.sin
                half = 0.5 * pupil.spider.width  # type: ignore[union-attr]
                found += [np.divide(y * c - half, s), np.divide(y * c + half, s), np.divide(-y * s, c)]
            edge = pupil.vignetting
            if isinstance(edge, CatEye):
                a = edge.shift[0] * self.cos + edge.shift[1] * self.sin
                root = np.sqrt(edge.radius**2 - (y - edge.shift[1] * self.cos + edge.shift[0] * self.sin) ** 2)
                found += [a - root, a + root]
            elif isinstance(edge, Ellipse):
                back = np.linalg.inv(edge.frame)
                along, across = back @ [self.cos, self.sin], (back @ [-self.sin, self.cos])[:, None] * y
                square, cross = along @ along, along @ across
                root = np.sqrt(cross**2 - square * ((across**2).sum(axis=0) - 1.0))
                found += [(-cross - root) / square, (-cross + root) / square]
        return found
