r"""The clear part of an aperture, and quadrature over it that converges geometrically.

Every shape here is cut by a ray from the axis in one interval ``[low, high]``: obscuration, vanes and the near edge
of a cat's eye raise its beginning, the rim and the far edge of a cat's eye lower its end. So one rule serves them
all: Gauss-Legendre in the radius, and Gauss-Legendre in the angle between the kinks of low and high. All weights are
positive and all nodes where light passes. An ellipse is the unit disc in a skewed frame, in which vanes stay
straight.
"""

from __future__ import annotations

import cmath
import math
from bisect import bisect_left
from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.optics.aperture.apodization import Apodization
from lommel.optics.aperture.obstructions import CatEye, Ellipse, Spider
from lommel.special.disk import disk_overlap
from lommel.special.legendre import gauss_legendre

_NEAR = 1e-9


def _kinks(
    obscuration: float, spider: Spider | None, vignetting: Ellipse | CatEye | None
) -> tuple[Array, list[float], list[complex], list[float]]:
    """Return the frame, the angles where edges have kinks, and the poles and roots, which slow convergence."""
    ellipse = vignetting if isinstance(vignetting, Ellipse) else None
    eye = vignetting if isinstance(vignetting, CatEye) else None
    frame = np.eye(2) if ellipse is None else ellipse.frame
    back = np.linalg.inv(frame)
    kinks: list[float] = []
    poles: list[complex] = []
    roots: list[float] = []

    def angle_of(place: Array) -> float:
        u, w = back @ place
        return math.atan2(w, u)

    def cross(p: Array, d: Array, radius: float, start: Array, along: Array) -> None:
        """Add where the line ``p + s d`` crosses a circle around the origin; s leads along the vane from `start`."""
        a, b, c = d @ d, p @ d, p @ p - radius**2
        if b * b >= a * c:
            for sign in (-1.0, 1.0):
                s = (-b + sign * math.sqrt(b * b - a * c)) / a
                if s > 0.0:
                    kinks.append(angle_of(start + s * along))

    circles = [((0.0, 0.0), 1.0)] if ellipse is None else []
    circles += [((0.0, 0.0), obscuration)] if obscuration > 0.0 else []
    circles += [(eye.shift, eye.radius)] if eye is not None else []
    edges: list[tuple[Array, Array]] = []
    half, angles = (0.0, ()) if spider is None else (0.5 * spider.width, spider.angles)
    for angle in angles:
        d = np.array([math.cos(angle), math.sin(angle)])
        n = np.array([-d[1], d[0]])
        poles.append(angle_of(d))
        kinks += [angle_of(n), angle_of(-n)]
        edges += [(half * n, d), (-half * n, d)]
    for start, d in edges:
        for center, radius in circles:
            cross(start - center, d, radius, start, d)
        if ellipse is not None:
            cross(back @ start, back @ d, 1.0, start, d)
    for i, (p, d) in enumerate(edges):
        for q, e in edges[:i]:
            turn = d[0] * e[1] - d[1] * e[0]
            if abs(turn) > 1e-12:
                kinks.append(angle_of(p + ((q - p)[0] * e[1] - (q - p)[1] * e[0]) / turn * d))
    if ellipse is not None and obscuration > 0.0 and ellipse.a != ellipse.b:
        # Where the middle is obscured, ``obscuration / |e(theta)|`` is the edge of that in the frame.
        a, b = ellipse.a, ellipse.b
        depth, base = math.atanh(min(a, b) / max(a, b)), 0.5 * math.pi if a > b else 0.0
        poles += [base + k * math.pi + sign * 1j * depth for k in (0, 1) for sign in (-1, 1)]
        square = (obscuration**2 - b**2) / (a**2 - b**2)
        if 0.0 <= square <= 1.0:
            angle = math.acos(math.sqrt(square))
            kinks += [angle, math.pi - angle, math.pi + angle, -angle]
    distance = 0.0 if eye is None else math.hypot(*eye.shift)
    if eye is not None and distance >= 1e-15:  # less no angle can tell from none
        toward = math.atan2(eye.shift[1], eye.shift[0])
        for radius in (1.0, obscuration):
            cosine = (distance**2 + radius**2 - eye.radius**2) / (2.0 * distance * radius) if radius > 0.0 else 2.0
            if abs(cosine) <= 1.0:
                kinks += [toward + math.acos(cosine), toward - math.acos(cosine)]
        # Branch points of sqrt(radius^2 - distance^2 sin^2): the tangents from the axis, if it is outside.
        tangent = cmath.asin(eye.radius / distance)
        turns = [tangent, -tangent, math.pi - tangent, math.pi + tangent]
        poles += [toward + angle for angle in [*turns, *(angle.conjugate() for angle in turns)]]
        if eye.radius <= distance:
            roots += [toward + tangent.real, toward - tangent.real]
    return frame, kinks, poles, roots


def graded(a: float, b: float, poles: list[complex], roots: list[float]) -> list[tuple[float, float, int]]:
    """Split an interval of angles until each part is no longer than its distance from every singularity."""
    ends = [any(abs(math.remainder(end - root, 2.0 * math.pi)) < _NEAR for root in roots) for end in (a, b)]
    felt = [end for end, root in zip((a, b), ends, strict=True) if root]  # by the square root alone
    turned = [pole + 2.0 * math.pi * turn for pole in poles for turn in (-2, -1, 0, 1, 2)]
    others = [z for z in turned if all(abs(z - end) >= 2 * _NEAR for end in felt)]
    done, todo = [], [(a, b, ends[0], ends[1])]
    while todo:
        low, high, left, right = todo.pop()
        length = high - low
        near = min((abs(z - min(max(z.real, low), high)) for z in others), default=math.inf)
        if length > 1e-12 and (near < length or length > 0.5 * math.pi or (left and right)):
            middle = 0.5 * (low + high)
            todo += [(low, middle, left, False), (middle, high, False, right)]
        else:
            done.append((low, high, -1 if left else 1 if right else 0))
    return done


_SUB = 16  # points along each side of a cell at an edge
_DIGITS = 30.0  # log(1e13): what the rules converge to
MAX_DEGREE = 2**12
"""Highest degree of a quadrature rule."""


class Rule(NamedTuple):
    """Nodes and weights of ``(1/pi) int dx dy`` over a clear aperture; the weights sum to its area over pi.

    Parameters
    ----------
    x, y : ndarray, shape (n,)
        In units of the radius of the pupil.
    weight : ndarray, shape (n,)
    """

    x: Array
    y: Array
    weight: Array


_B = np.geomspace(1e-3, 4.0, 192)


def degree_needed(
    terms: Iterable[tuple[int, float]], v: float, light: Apodization, error: float, *, power: float = 1.0
) -> int:
    r"""Return the total degree to which a rule must be exact for a proven error of U below `error`.

    On the disc, and on any region within it, the integrand ``A exp(i Phi - i v.rho)`` with Phi a sum of Zernike
    terms of degree n_j and amplitude W_j at the edge is bounded by
    ``M(b) = exp(sum_j W_j sinh(n_j b) + v sinh(b) + a(cosh 2 b))``, b > 0 the size of the complex neighbourhood and
    a the growth of the amplitude A, :meth:`lommel.Apodization.growth`. A rule with positive weights that is exact to
    the degree E errs in U by at most ``2 sum_{n > E} (n + 1)^1.5 M(b) (1 + e^{-2 b}) e^{-n b}``; the best b is taken.

    Parameters
    ----------
    terms : iterable of (int, float)
        Degree n_j and amplitude W_j in radians of each Zernike term; of cosine and sine together the root of the
        sum of squares.
    v : float
        The largest ``|v|`` of the image.
    light : Apodization
        The amplitude.
    error : float
        Largest error of U, relative to U(0) = 1 of the unaberrated disc.
    power : float, default 1
        Power of the amplitude.

    Returns
    -------
    int

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or no degree up to the largest suffices.
    """
    v, light = validation.real("v", v, least=0.0), validation.instance("light", light, Apodization)
    error = validation.real("error", error, above=0.0)
    growth = v * np.sinh(_B) + power * light.growth(np.cosh(2.0 * _B))
    if not isinstance(terms, Iterable):
        raise TypeError(f"terms must be pairs (n, amplitude), got {validation.shown(terms)}")
    for n, amplitude in terms:
        growth = growth + amplitude * np.sinh(np.minimum(n * _B, 700.0))

    def holds(degree: int) -> bool:
        # From one term of the sum to the next is at most this factor.
        ratio = (1.0 + 1.0 / (degree + 2)) ** 1.5 * np.exp(-_B)
        with np.errstate(divide="ignore", invalid="ignore"):
            tail = np.where(ratio < 1.0, 1.5 * math.log(degree + 2) - (degree + 1) * _B - np.log1p(-ratio), np.inf)
        bound = math.log(2.0) + np.log1p(np.exp(-2.0 * _B)) + growth + tail
        return bool(bound.min() <= math.log(error))

    high = next((2**k for k in range(3, MAX_DEGREE.bit_length()) if holds(2**k)), None)
    if high is None:
        raise ValueError(
            f"aberrations and a window of v = {v:.4g} this large take polynomials of a degree over {MAX_DEGREE}"
        )
    return bisect_left(range(high), True, lo=high // 2 + 1, key=holds)


@dataclass(frozen=True)
class Opening:
    """The region where light passes: the unit disc less obscuration, vanes and vignetting.

    Parameters
    ----------
    obscuration : float, default 0
        Radius of the central obscuration divided by that of the pupil, 0 to below 1.
    spider : Spider, optional
    vignetting : Ellipse or CatEye, optional

    Raises
    ------
    TypeError, ValueError
        If a part is of another type or out of range.
    """

    obscuration: float = 0.0
    spider: Spider | None = None
    vignetting: Ellipse | CatEye | None = None

    def __post_init__(self) -> None:
        eps = validation.real("obscuration", self.obscuration, least=0.0, below=1.0)
        object.__setattr__(self, "obscuration", eps)
        validation.optional("spider", self.spider, Spider)
        validation.optional("vignetting", self.vignetting, Ellipse, CatEye)

    @property
    def circular(self) -> bool:
        """Whether it is a disc or an annulus."""
        return self.spider is None and self.vignetting is None

    def margin(self, x: Array, y: Array) -> Array:
        """Return the signed margin at (`x`, `y`), positive where light passes, slope at most 1; or a ValueError."""
        return self._margin(validation.real_array("x", x), validation.real_array("y", y))

    def _margin(self, x: Array, y: Array) -> Array:
        rho = np.hypot(x, y)
        least = np.minimum(1.0 - rho, rho - self.obscuration) if self.obscuration > 0.0 else 1.0 - rho
        for part in (self.spider, self.vignetting):
            if part is not None:
                least = np.minimum(least, part.margin(x, y))
        return np.asarray(least)

    def coverage(self, x: Array, y: Array, half: float) -> Array:
        """Return the clear fraction of square cells with centres (`x`, `y`) and side twice `half`.

        Exact for circular and annular apertures; else by 16 x 16 points of each cell that an edge may cross, smoothed
        at the edge. TypeError or ValueError if an argument is not real and finite, or `half` not above 0.
        """
        x, y = validation.real_array("x", x), validation.real_array("y", y)
        half = validation.real("half", half, above=0.0)
        if self.circular:
            cell = (x - half, x + half, y - half, y + half)
            inner = disk_overlap(self.obscuration, *cell) if self.obscuration > 0.0 else 0.0
            return np.asarray((disk_overlap(1.0, *cell) - inner) / (4.0 * half * half))
        across, down = np.broadcast_arrays(x, y)
        margin = self._margin(across, down)
        part = (margin >= 0.0).astype(np.float64)
        cut = np.abs(margin) < math.sqrt(2.0) * half
        place = half * ((2.0 * np.arange(_SUB) + 1.0) / _SUB - 1.0)
        # Counting whole points alone would favour one side of an edge along a diagonal of their lattice.
        round_part, soft = Opening(self.obscuration, None, self.vignetting), 2.0 * half / _SUB
        xs, ys = across[cut], down[cut]
        count = np.zeros(xs.size)
        for dy in place:
            for dx in place:
                here = 0.5 + round_part._margin(xs + dx, ys + dy) / soft
                if self.spider is not None:
                    # A softer edge than a vane is wide would fill it in.
                    vanes = self.spider.margin(xs + dx, ys + dy) / min(soft, self.spider.width)
                    here = np.minimum(here, 0.5 + vanes)
                count += np.clip(here, 0.0, 1.0)
        part[cut] = count / _SUB**2
        return part

    def rule(self, degree: int) -> Rule:
        """Return nodes and weights for polynomials in x and y of a total `degree`; ValueError if that is too large.

        Exact to rounding for circular and annular apertures and full ellipses; otherwise converged to about 1e-13,
        without a proof.
        """
        return _rule(self, validation.integer("degree", degree, least=0, most=4 * MAX_DEGREE))

    def raster(self) -> tuple[Array, Array]:
        """Return points that fill the clear region up to its edges."""
        frame, panels = self._panels()
        theta = np.concatenate([np.linspace(a + 1e-12, b - 1e-12, 33) for a, b, _ in panels] or [np.zeros(0)])
        low, high = self._interval(frame, theta)
        kept = high > low
        r = low[kept] + (high - low)[kept] * np.linspace(0.0, 1.0, 33)[:, None]
        e = frame @ np.stack([np.cos(theta[kept]), np.sin(theta[kept])])
        return r * e[0], r * e[1]

    def _interval(self, frame: Array, theta: Array) -> tuple[Array, Array]:
        """Return where the ray in each direction enters and leaves the clear region; low > high if nowhere."""
        ex, ey = frame @ np.stack([np.cos(theta), np.sin(theta)])
        low, high = self.obscuration / np.hypot(ex, ey), np.ones_like(theta)
        if self.spider is not None:
            for angle in self.spider.angles:
                c, s = math.cos(angle), math.sin(angle)
                across = np.maximum(np.abs(ey * c - ex * s), 1e-300)
                low = np.where(ex * c + ey * s > 0.0, np.maximum(low, 0.5 * self.spider.width / across), low)
        if isinstance(self.vignetting, CatEye):
            (dx, dy), radius = self.vignetting.shift, self.vignetting.radius
            along, across = ex * dx + ey * dy, ey * dx - ex * dy
            root = np.sqrt(np.maximum((radius - across) * (radius + across), 0.0))
            distance = math.hypot(dx, dy)
            product = (distance - radius) * (distance + radius)  # of the two crossings
            behind = along < 0.0
            far = np.where(behind, -product / np.where(behind, root - along, 1.0), along + root)
            high = np.minimum(high, far)
            if product > 0.0:
                low = np.maximum(low, product / np.maximum(far, 1e-300))
        return low, high

    def _panels(self) -> tuple[Array, list[tuple[float, float, int]]]:
        """Return the frame, and clear panels ``(from, to, end)``, end being where a square root begins, or 0."""
        frame, kinks, poles, roots = _kinks(self.obscuration, self.spider, self.vignetting)
        full = 2.0 * math.pi
        edges = np.unique(np.mod([*kinks, *roots, 0.0 if not kinks else kinks[0]], full))
        edges = edges[np.append(True, np.diff(edges) > 1e-14)]
        panels = []
        for a, b in zip(edges, np.append(edges[1:], edges[0] + full), strict=True):
            # Between kinks a ray stays clear or blocked, but a sliver may close at one point only.
            low, high = self._interval(frame, a + (b - a) * np.array([0.1, 0.3, 0.5, 0.7, 0.9]))
            if np.any(high > low):
                arcs = bool(np.all(high == 1.0)) and np.ptp(low) < 1e-13  # around the axis: no singularity is felt
                panels += [(float(a), float(b), 0)] if arcs else graded(float(a), float(b), poles, roots)
        return frame, panels


def _count(rate: float) -> int:
    """Return how many Gauss-Legendre nodes integrate ``exp(i rate x)`` over [-1, 1] to about 1e-13."""
    return math.ceil(0.5 * rate + 0.587 * math.cbrt(_DIGITS**2 * rate) + 0.2 * _DIGITS + 5.0)


@lru_cache(maxsize=4)
def _rule(opening: Opening, degree: int) -> Rule:
    eps = opening.obscuration
    full_ellipse = isinstance(opening.vignetting, Ellipse) and opening.spider is None and eps == 0.0
    if opening.circular or full_ellipse:
        # The trapezoidal rule leaves the terms without theta, polynomials in t = rho^2 of half the degree.
        count = degree + 1
        t, w = gauss_legendre((degree // 2 + 2) // 2, eps**2, 1.0)
        theta = (np.arange(count) + 0.5) * (2.0 * math.pi / count)
        frame = opening.vignetting.frame if isinstance(opening.vignetting, Ellipse) else np.eye(2)
        parts = [(np.sqrt(t)[:, None] * np.stack([np.cos(theta), np.sin(theta)])[:, None], w[:, None] / count)]
    else:
        frame, panels = opening._panels()
        parts = [part for panel in panels if (part := _panel(opening, frame, panel, degree)) is not None]
    scale = abs(float(np.linalg.det(frame)))
    x, y = frame @ np.concatenate([np.zeros((2, 0)), *(p.reshape(2, -1) for p, _ in parts)], axis=1)
    weight = np.concatenate([np.zeros(0), *(np.broadcast_to(scale * w, p.shape[1:]).ravel() for p, w in parts)])
    for array in (x, y, weight):
        array.flags.writeable = False
    return Rule(x, y, weight)


def _panel(
    opening: Opening, frame: Array, panel: tuple[float, float, int], degree: int
) -> tuple[Array, Array] | None:
    """Return points in the frame, shape (2, radii, angles), and their weights."""
    a, b, root = panel
    theta = np.linspace(a, b, 19)[1:-1]
    low, high = opening._interval(frame, theta)
    if not np.any(high > low):
        return None
    # The fastest that a polynomial of this degree on the unit disc turns along the two edges of the panel.
    rate = 0.5 * degree * (b - a) if np.all(high == 1.0) else 0.0
    for edge in (low, high):
        edge = np.clip(edge, 0.0, 1.0)
        length = float(np.hypot(np.diff(edge * np.cos(theta)), np.diff(edge * np.sin(theta))).sum()) * 18.0 / 16.0
        inside = math.sqrt(max(1.0 - float(edge.max()) ** 2, 1e-300))
        if not np.all(edge == 1.0):
            rate = max(rate, degree * min(0.5 * length / inside, math.sqrt(0.5 * length)))
    s, w = gauss_legendre(_count(2.0 * rate if root else rate))
    if root == 0:
        theta, w = a + (b - a) * s, (b - a) * w
    elif root < 0:
        theta, w = a + (b - a) * s * s, 2.0 * (b - a) * s * w
    else:
        theta, w = b - (b - a) * s * s, 2.0 * (b - a) * s * w
    low, high = opening._interval(frame, theta)
    width = np.maximum(high - low, 0.0)
    t, u = gauss_legendre(min((degree + 3) // 2, _count(degree * math.sqrt(0.5 * float(width.max())))))
    r = low + width * t[:, None]
    weights = u[:, None] * (width * w / math.pi) * r
    return np.stack([r * np.cos(theta), r * np.sin(theta)]), weights
