r"""The clear region of an aperture, and quadrature over it with a proven error bound.

An aperture is a disc minus an obscuration and vanes, limited by vignetting and other shapes. Lines of constant y cut
the aperture into intervals. Gauss-Legendre rules along the intervals and, in y, between the intersections of
edges, converge geometrically (`cpp/include/lommel/aperture`). All weights are positive, and all nodes are clear.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import combinations
from typing import NamedTuple, cast

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.core import engine
from lommel.optics.aperture.apodization import Apodization
from lommel.optics.aperture.shapes import (
    CatEye,
    Combined,
    Disc,
    Ellipse,
    Polygon,
    Segments,
    Shape,
    Spider,
    covered,
    disk_overlap,
    listed,
    require_reach,
)

_EXACT = 1e-14  # relative error of rules for measures
_OVERLAP = 1e-10  # largest overlap of segments (area / pi) that is treated as a rounding error
_STEP = 16  # degrees are rounded up to multiples of this, so that similar requests share nodes
MAX_DEGREE = 2**12
"""Highest degree of a quadrature rule."""


class Rule(NamedTuple):
    """Nodes and weights of ``(1/pi) int dx dy`` over a clear aperture; the sum of the weights is its area / pi.

    Parameters
    ----------
    x, y : ndarray, shape (n,)
        Nodes, in units of the radius of the pupil.
    weight : ndarray, shape (n,)
    """

    x: Array
    y: Array
    weight: Array


# Sizes b of the complex neighbourhood: each size gives a bound, and the smallest bound is used.
_B = np.geomspace(1e-3, 4.0, 192)


def degree_needed(
    terms: Iterable[tuple[int, float | Array]],
    v: float,
    light: Apodization,
    error: float,
    *,
    power: float = 1.0,
    radius: float = 1.0,
    mean: tuple[float, float] | None = None,
) -> int:
    r"""Return the total degree to which a rule must be exact for a proven error of U below `error`.

    On the disc, and on any region within it, the integrand ``A exp(i Phi - i v.rho)`` with Phi a sum of Zernike
    terms of degree n_j and amplitude W_j at the edge is bounded by
    ``M(b) = exp(sum_j W_j sinh(n_j b) + v sinh(b) + a(cosh 2 b))``, b > 0 the size of the complex neighbourhood and
    a the growth of the amplitude A, :meth:`lommel.Apodization.growth`. A rule with positive weights that is exact to
    degree E has an error of U of at most ``2 sum_{n > E} (n + 1)^1.5 M(b) (1 + e^{-2 b}) e^{-n b}``; the best b is
    used. A relative error r of the rule increases an error e of U to ``e + r + r e``.

    Parameters
    ----------
    terms : iterable of (int, float or ndarray)
        Degree n_j and amplitude W_j in radians of each Zernike term; for a cosine and a sine together, the amplitude
        is the root of the sum of squares. Arrays of equal shape have the amplitudes of several wavefronts; the degree
        suffices for all of them.
    v : float
        Largest abs(v) of the image.
    light : Apodization
        Amplitude across the pupil.
    error : float
        Largest error of U, relative to U(0) = 1 of the unaberrated disc.
    power : float, default 1
        Power of the amplitude.
    radius : float, default 1
        Radius of the disc around the axis of the amplitude that contains the unit disc of the integrand.
    mean : (float, float), optional
        Another b, and a bound on the logarithm of the mean of ``|exp(i Phi - i v.rho)|`` over chords, which may take
        the place of its largest value in M(b).

    Returns
    -------
    int

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or if no degree up to `MAX_DEGREE` suffices.
    """
    v, light = validation.real("v", v, least=0.0), validation.instance("light", light, Apodization)
    error = validation.real("error", error, above=0.0)
    # M(b) of certificate, sections 7 and 18; a larger radius makes |x|^2 + |y|^2, and so cosh 2b, larger.
    b, growth = _B, v * np.sinh(_B)
    if not isinstance(terms, Iterable):
        raise TypeError(f"terms must be pairs (n, amplitude), got {validation.shown(terms)}")
    sizes: dict[int, float | Array] = {}
    for n, amplitude in terms:
        sizes[n] = sizes.get(n, 0.0) + amplitude
    if sizes:
        with np.errstate(over="ignore"):  # phases so large that no degree suffices
            each = np.stack([np.ravel(size) for size in sizes.values()], axis=-1)
            growth = growth + (each @ np.sinh(np.minimum(np.multiply.outer(list(sizes), _B), 700.0))).max(axis=0)

    if mean is not None:
        b, growth = np.append(b, mean[0]), np.append(growth, mean[1])
    growth = growth + power * light.growth(radius**2 * (1.0 + np.cosh(2.0 * b)) - 1.0)

    excess = math.log(2.0) + np.log1p(np.exp(-2.0 * b)) + growth - math.log(error)

    def lacking(degree: float) -> Array:
        """Return for each b how much the degree should be larger for the bound to be the error."""
        # Sum of (n + 1)^(3/2) exp(-n b) from degree + 1 on: a geometric series with this ratio bounds it.
        ratio = (1.0 + 1.0 / (degree + 2.0)) ** 1.5 * np.exp(-b)
        with np.errstate(divide="ignore", invalid="ignore"):
            logarithm = np.where(ratio < 1.0, 1.5 * math.log(degree + 2.0) - np.log1p(-ratio), np.inf)
        return (excess + logarithm) / b - (degree + 1.0)

    # Degrees near the solution first, then steps: the bound falls with the degree.
    degree, least = 64.0, 5
    for _ in range(2):
        degree = float(np.clip(degree + lacking(degree).min(), least, MAX_DEGREE))
    found = math.ceil(degree)
    while found > least and lacking(found - 1).min() <= 0.0:
        found -= 1
    while found <= MAX_DEGREE and lacking(found).min() > 0.0:
        found += 1
    if found > MAX_DEGREE:
        raise ValueError(
            f"{f'a window up to v = {v:.4g} and ' if v else ''}aberrations this large need polynomials of a degree "
            f"above {MAX_DEGREE}; use {'fewer or smaller pixels, or ' if v else ''}smaller aberrations"
        )
    return found


@dataclass(frozen=True)
class Opening:
    """The clear region: the unit disc minus obscuration and vanes, limited by vignetting and a stop.

    Parameters
    ----------
    obscuration : float, default 0
        Radius of the central obscuration divided by the radius of the pupil, 0 to below 1.
    spider : Spider, optional
    vignetting : Ellipse or CatEye, optional
    stop : Shape or Segments, optional

    Raises
    ------
    TypeError, ValueError
        If a part is of another type or out of range.
    """

    obscuration: float = 0.0
    spider: Spider | None = None
    vignetting: Ellipse | CatEye | None = None
    stop: Shape | Segments | None = None

    def __post_init__(self) -> None:
        eps = validation.real("obscuration", self.obscuration, least=0.0, below=1.0)
        object.__setattr__(self, "obscuration", eps)
        validation.optional("spider", self.spider, Spider)
        validation.optional("vignetting", self.vignetting, Ellipse, CatEye)
        validation.optional("stop", self.stop, Shape, Segments)
        if isinstance(self.stop, Segments):
            _require_apart(self.stop.shapes)
        elif self.stop is not None:
            _require_reach(self.stop)

    @property
    def circular(self) -> bool:
        """True if the region is a disc or an annulus."""
        return self.spider is None and self.vignetting is None and self.stop is None

    @property
    def strips(self) -> tuple[float, Array] | None:
        """Radius of an annulus' obscuration, and disjoint strips that vanes cut out of it, (strips, 9), or None.

        Vanes are those of a spider, and strips (:meth:`lommel.Polygon.strip`) that a stop lacks. Of each strip:
        cosine and sine of its direction; the range of distances across; 1 if its mirror image across, 2 if the strip
        turned by half a turn belongs to it, too; 1 if it lies ahead, behind the axis; 0 if it begins at a circle, 1
        at lines t = kappa abs(s), 2 at the opposite rim; radius or kappa.
        """
        return _strips(self)

    @property
    def regions(self) -> tuple[Shape, ...]:
        """Regions of the aperture; several only for segments."""
        stops = self.stop.shapes if isinstance(self.stop, Segments) else (self.stop,)
        return tuple(self._clear_region(stop) for stop in stops)

    def _clear_region(self, stop: Shape | None) -> Shape:
        # The unit disc limits every aperture.
        clear: Shape = Disc() if stop is None else Disc() & stop
        if self.vignetting is not None:
            clear = clear & self.vignetting
        if self.obscuration > 0.0:
            clear = clear - Disc(self.obscuration)
        return clear if self.spider is None else clear - self.spider

    @property
    def phases(self) -> Array:
        """Phase of each region extrapolated to the axis, and its slopes along x and y; radians, (regions, 3)."""
        return self.stop.phases if isinstance(self.stop, Segments) else np.zeros((1, 3))

    @cached_property
    def likely_strehl(self) -> float:
        """Estimate of the Strehl ratio that the phases of segments leave."""
        if not isinstance(self.stop, Segments):
            return 1.0
        count = len(self.stop.shapes)
        # Beside the light in phase, segments out of phase add their intensities; tilts move light away from the axis.
        in_phase = float(abs(np.exp(1j * np.array(self.stop.piston)).mean())) ** 2 + 1.0 / count
        tilts = float(np.hypot(self.stop.tip, self.stop.tilt).mean()) / math.sqrt(count)
        return min(1.0, in_phase) / (1.0 + 0.25 * tilts**2)

    def phase(self, x: Array, y: Array) -> Array | float:
        """Return the phase of the segments at points (`x`, `y`), radians; 0 without segments."""
        return self.tilted(x, y)[0] if isinstance(self.stop, Segments) else 0.0

    def tilted(self, x: Array, y: Array) -> Array:
        """Return the phase of the segments at points (`x`, `y`), and its slopes along x and y, shape ``(3, ...)``.

        Points between segments have the phase of the nearest segment.
        """
        index, largest = np.zeros((2, *np.broadcast_shapes(x.shape, y.shape)))
        # The margin of the nearest segment is the largest: positive inside, minus the distance outside.
        if isinstance(self.stop, Segments):
            largest -= np.inf
            for i, part in enumerate(self.stop.shapes):
                margin = part.margin(x, y)
                index, largest = np.where(margin > largest, i, index), np.maximum(margin, largest)
        return _phased(self.phases[index.astype(np.intp)], x, y)

    def tilted_nodes(self, degree: int) -> Array:
        """Return :meth:`tilted` at the nodes of the :meth:`rule` for a `degree`, shape (3, nodes)."""
        nodes = [rule.nodes for rule in _exact_rows(self, degree)]
        x, y, _ = np.concatenate(nodes, axis=1)
        return _phased(np.repeat(self.phases, [part.shape[1] for part in nodes], axis=0), x, y)

    def margin(self, x: Array, y: Array) -> Array:
        """Return the signed margin at (`x`, `y`): positive in the clear region, slope at most 1; or ValueError."""
        return self._margin(validation.real_array("x", x), validation.real_array("y", y))

    def _margin(self, x: Array, y: Array) -> Array:
        rho = np.hypot(x, y)
        least = np.minimum(1.0 - rho, rho - self.obscuration) if self.obscuration > 0.0 else 1.0 - rho
        for part in (self.vignetting, self.stop):
            if part is not None:
                least = np.minimum(least, part.margin(x, y))
        return np.asarray(least if self.spider is None else np.minimum(least, -self.spider.margin(x, y)))

    def coverage(self, x: Array, y: Array, half: float) -> Array:
        """Return the clear fraction of square cells with centres (`x`, `y`) and side twice `half`.

        Exact up to rounding. TypeError or ValueError if an argument is not real and finite, or `half` not above 0.
        """
        x, y = validation.real_array("x", x), validation.real_array("y", y)
        half = validation.real("half", half, above=0.0)
        if self.circular:
            margin = self._margin(x, y)
            # Half a diagonal is sqrt(2) half.
            at_edge, clear = np.abs(margin) < 1.5 * half, np.asarray(np.heaviside(margin, 0.0))
            x, y = (part[at_edge] for part in np.broadcast_arrays(x, y))
            cell = (x - half, x + half, y - half, y + half)
            inner = disk_overlap(self.obscuration, *cell) if self.obscuration > 0.0 else 0.0
            clear[at_edge] = (disk_overlap(1.0, *cell) - inner) / (4.0 * half * half)
            return clear
        x_cells, y_cells = np.broadcast_arrays(x, y)
        parts = (covered(region, x_cells.ravel(), y_cells.ravel(), half) for region in self.regions)
        return np.asarray(sum(parts)).reshape(x_cells.shape)

    def rule(self, degree: int) -> Rule:
        """Return nodes and weights for polynomials in x and y of a total `degree`; ValueError if it is too large.

        For polynomials of modulus at most 1 on the unit disc the error is at most 1e-14 of the clear area / pi, plus
        rounding errors.
        """
        return _nodes(self, validation.integer("degree", degree, least=0, most=4 * MAX_DEGREE))

    def rows(self, degree: int, error: float) -> tuple[engine.RowRule, ...]:
        """Return the rule of each region, with at most this `error` for polynomials of modulus <= 1 on the unit disc.

        `degree` is rounded up to a multiple of 16, `error` down to a power of ten.
        """
        return _rows(self, -(-degree // _STEP) * _STEP, math.floor(math.log10(error)))

    def raster(self) -> Array:
        """Return points that fill the clear region up to its edges, with slopes of segments at the points, (4, n)."""
        return _raster(self)


_FARTHEST = 0.8  # largest distance of a vane's edge from the axis, over the radius of the obscuration


class _Vane(NamedTuple):
    """Part of a strip: points ``t (cosine, sine) + s (-sine, cosine)`` with s from `low` to `high` and t > 0."""

    cosine: float
    sine: float
    low: float
    high: float

    def meets(self, other: _Vane, radius: float) -> bool:
        """Return whether the vanes may have points in common farther than `radius` from the axis."""
        turn = self.cosine * other.sine - self.sine * other.cosine
        if abs(turn) < 1e-6:
            same = self.cosine * other.cosine + self.sine * other.sine > 0.0
            return same and max(self.low, other.low) < min(self.high, other.high) + 1e-6
        # The part with t > 0 of both of the parallelogram in which the strips cross: convex, so corners are farthest.
        across = [(self.low, other.low), (self.low, other.high), (self.high, other.high), (self.high, other.low)]
        normals = np.array([(-self.sine, self.cosine), (-other.sine, other.cosine)])
        corners = [np.linalg.solve(normals, pair) for pair in across]
        for ahead in (np.array([self.cosine, self.sine]), np.array([other.cosine, other.sine])):
            kept = []
            for first, second in zip(corners, corners[1:] + corners[:1], strict=True):
                t, u = first @ ahead, second @ ahead
                kept += [first] if t > 0.0 else []
                kept += [first + t / (t - u) * (second - first)] if t * u < 0.0 else []
            corners = kept
        return any(float(np.hypot(*corner)) > radius for corner in corners)


@lru_cache(maxsize=32)
def _strips(opening: Opening) -> tuple[float, Array] | None:
    if opening.vignetting is not None or isinstance(opening.stop, Segments):
        return None
    blocked = [] if opening.stop is None else _blocked(opening.stop)
    if blocked is None:
        return None
    blocked += [] if opening.spider is None else [opening.spider]
    discs = [part.radius for part in blocked if isinstance(part, Disc)]
    start = max([opening.obscuration, *discs])
    vanes: list[_Vane] = []
    for part in blocked:
        found = [] if isinstance(part, Disc) else _vanes(part, start)
        if found is None:
            return None
        vanes += found
    if start == 0.0:
        strips = _whole_strips(vanes) or _sectors(vanes)
    else:
        apart = not any(a.meets(b, start * (1.0 - 1e-9)) for a, b in combinations(vanes, 2))
        within = all(max(-vane.low, vane.high) <= _FARTHEST * start for vane in vanes)
        strips = [_Strip(*vane, start=start) for vane in vanes] if apart and within else []
    if not strips:
        return None
    array = np.array(_joined(strips))
    array.flags.writeable = False
    return start, array


class _Strip(NamedTuple):
    """Numbers of a strip as in `Opening.strips`; at first it lies ahead, without its mirror image."""

    cosine: float
    sine: float
    low: float
    high: float
    mirrored: float = 0.0
    ahead: float = 1.0
    behind: float = 0.0
    begins: float = 0.0
    start: float = 0.0


def _sectors(vanes: list[_Vane]) -> list[_Strip]:
    """Return the strips of vanes from the axis, of one width: each vane owns the points nearest to its direction.

    Halves of a vane begin at lines t = kappa abs(s), which they share with the next vane. Empty if widths differ or
    vanes meet far from the axis.
    """
    half, angles = vanes[0].high, [math.atan2(vane.sine, vane.cosine) for vane in vanes]
    if any(max(abs(vane.high - half), abs(vane.low + half)) > 1e-14 for vane in vanes):
        return []
    order = sorted(range(len(vanes)), key=angles.__getitem__)
    gaps = [(angles[b] - angles[a]) % (2.0 * math.pi) for a, b in zip(order, order[1:] + order[:1], strict=True)]
    # A gap of half a turn or more leaves the end of the vane as it is, at t = 0.
    slopes = [max(0.0, 1.0 / math.tan(0.5 * gap)) if 0.0 < gap < math.pi - 1e-14 else 0.0 for gap in gaps]
    if (len(vanes) > 1 and min(gaps) < 1e-6) or half * math.hypot(1.0, max(slopes)) > _FARTHEST:
        return []
    strips: list[_Strip] = []
    for at, before, after in zip(order, slopes[-1:] + slopes, slopes, strict=False):
        cosine, sine = vanes[at][:2]
        if abs(before - after) < 1e-13 * (1.0 + after):
            strips.append(_Strip(cosine, sine, 0.0, half, mirrored=1.0, begins=1.0, start=after))
        else:
            strips.append(_Strip(cosine, sine, 0.0, half, begins=1.0, start=after))
            strips.append(_Strip(cosine, sine, -half, 0.0, begins=1.0, start=before))
    return strips


def _whole_strips(vanes: list[_Vane]) -> list[_Strip]:
    """Return the strips of parallel bars across the disc; empty if a vane ends within it or bars overlap."""
    bars, others = vanes[::2], vanes[1::2]
    if len(bars) != len(others) or not np.allclose(others, [_opposite(bar) for bar in bars], rtol=0.0, atol=1e-14):
        return []
    apart = not any(a.meets(b, 0.0) for a, b in combinations(vanes, 2))
    within = all(max(-bar.low, bar.high) <= _FARTHEST for bar in bars)
    return [_Strip(*bar, behind=1.0, begins=2.0) for bar in bars] if apart and within else []


def _joined(strips: list[_Strip]) -> list[_Strip]:
    """Return strips of which opposite ones, and those that half a turn maps onto each other, are one."""
    joined: list[_Strip] = []
    for strip in strips:
        cosine, sine, low, high = strip.cosine, strip.sine, strip.low, strip.high
        across = (low, high) if strip.mirrored else (-high, -low)
        begins = (strip.begins, strip.start)
        for i, other in enumerate(joined):
            plain = other.behind == 0.0 and np.allclose((other.begins, other.start), begins, rtol=1e-13, atol=1e-14)
            if plain and other.mirrored == strip.mirrored and _near(other, (-cosine, -sine, *across)):
                joined[i] = other._replace(behind=1.0)
                break
            if plain and other.mirrored == strip.mirrored == 0.0 and _near(other, (-cosine, -sine, low, high)):
                joined[i] = other._replace(mirrored=2.0)
                break
        else:
            joined.append(strip)
    return joined


def _near(strip: _Strip, place: tuple[float, ...]) -> bool:
    return bool(np.allclose((strip.cosine, strip.sine, strip.low, strip.high), place, rtol=0.0, atol=1e-14))


def _opposite(vane: _Vane) -> tuple[float, float, float, float]:
    """Return numbers of the strip in which a vane lies at t < 0."""
    return -vane.cosine, -vane.sine, -vane.high, -vane.low


def _blocked(shape: Shape) -> list[Shape] | None:
    """Return what a shape lacks of the unit disc: discs around the axis, polygons and spiders; None if more."""
    if isinstance(shape, Combined) and shape.kind in "&-":
        first = _blocked(shape.first)
        second = _blocked(shape.second) if shape.kind == "&" else _united(shape.second)
        return None if first is None or second is None else first + second
    return [] if isinstance(shape, Disc) and shape.center == (0.0, 0.0) and shape.radius >= 1.0 else None


def _united(shape: Shape) -> list[Shape] | None:
    """Return the parts of a union, which are as of :func:`_blocked`."""
    if isinstance(shape, Combined) and shape.kind == "|":
        first, second = _united(shape.first), _united(shape.second)
        return None if first is None or second is None else first + second
    central = isinstance(shape, Disc) and shape.center == (0.0, 0.0)
    return [shape] if central or isinstance(shape, Polygon | Spider) else None


def _vanes(part: Shape, start: float) -> list[_Vane] | None:
    """Return the vanes of a spider or a rectangle that begin within `start` and end beyond the rim; None if not."""
    if isinstance(part, Spider):
        half = 0.5 * part.width
        return [_Vane(math.cos(angle), math.sin(angle), -half, half) for angle in np.mod(part.angles, 2.0 * math.pi)]
    corners = np.array(cast("Polygon", part).corners)
    sides = np.roll(corners, -1, axis=0) - corners
    if len(corners) != 4 or np.abs(sides[:2] + sides[2:]).max() > 1e-14 or abs(sides[0] @ sides[1]) > 1e-14:
        return None
    for cosine, sine in (side / np.hypot(*side) for side in sides):
        t, s = corners @ (cosine, sine), corners @ (-sine, cosine)
        vane = _Vane(float(cosine), float(sine), float(s.min()), float(s.max()))
        if start == 0.0 and t.max() >= 1.0 and (t.min() <= -1.0 or abs(t.min()) <= 1e-14):
            return [vane, _Vane(*_opposite(vane))] if t.min() <= -1.0 else [vane]
        within = start * start - max(vane.low**2, vane.high**2)
        if within > 0.0 and t.max() >= 1.0 and t.min() <= math.sqrt(within):
            other = _Vane(*_opposite(vane))
            return [vane, other] if t.min() <= -1.0 else [vane] if t.min() >= -math.sqrt(within) else None
    return None


@lru_cache(maxsize=4)
def _raster(opening: Opening) -> Array:
    lines = [line for part in opening.regions for line in part.outline(256)]
    x, y = np.concatenate([*lines, np.stack(_nodes(opening, 64)[:2], axis=-1)]).T
    clear = opening.margin(x, y) >= -1e-9
    x, y = x[clear], y[clear]
    points = np.stack([x, y, *(opening.tilted(x, y)[1:] if opening.phases.any() else np.zeros((2, x.size)))])
    points.flags.writeable = False
    return points


def _phased(phases: Array, x: Array, y: Array) -> Array:
    piston, tip, tilt = np.moveaxis(phases, -1, 0)
    return np.stack([piston + tip * x + tilt * y, tip, tilt])


@lru_cache(maxsize=32)
def _rows(opening: Opening, degree: int, power: int) -> tuple[engine.RowRule, ...]:
    regions = opening.regions
    return tuple(listed(region).rule(degree, 10.0**power / len(regions)) for region in regions)


def _exact_rows(opening: Opening, degree: int) -> tuple[engine.RowRule, ...]:
    """Return rules with errors of at most `_EXACT` of the clear area / pi."""
    rules = opening.rows(degree, _EXACT)
    # The error is absolute. For a small opening the rules are computed again, with an error relative to the area.
    area = sum(rule.weight for rule in rules)
    return opening.rows(degree, _EXACT * area) if 0.0 < area < 0.1 else rules


@lru_cache(maxsize=32)
def _require_reach(stop: Shape) -> None:
    require_reach("stop", stop)


@lru_cache(maxsize=8)
def _require_apart(shapes: tuple[Shape, ...]) -> None:
    """Raise ValueError if segments overlap, or have no point within the rim."""
    for i, part in enumerate(shapes):
        if not listed(Disc() & part).rule(0, _OVERLAP).weight > 0.0:
            raise ValueError(
                "segments must have points within the unit disc; leave out "
                f"shapes[{i}] = {validation.shown(part)}, which has none"
            )
    # Outlines are points on edges: an arc extends beyond the box of 48 points by less than a hundredth of its size.
    boxes = np.array([[f(np.concatenate(part.outline(48)), axis=0) for f in (np.min, np.max)] for part in shapes])
    enlargement = 0.01 * (boxes[:, 1] - boxes[:, 0])
    low, high = boxes[:, 0] - enlargement, boxes[:, 1] + enlargement
    # Only pairs with overlapping boxes: each pair needs a quadrature over its intersection.
    for i, part in enumerate(shapes):
        overlapping = np.all((low[i] <= high[:i]) & (low[:i] <= high[i]), axis=-1)
        for j in np.flatnonzero(overlapping):
            common = listed(Disc() & part & shapes[j]).rule(0, _OVERLAP).weight
            if common > _OVERLAP:
                raise ValueError(
                    f"segments must not overlap, got shapes[{j}] and shapes[{i}] with an area of "
                    f"{common * math.pi:.3g} in common"
                )


@lru_cache(maxsize=4)
def _nodes(opening: Opening, degree: int) -> Rule:
    x, y, weight = np.concatenate([rule.nodes for rule in _exact_rows(opening, degree)], axis=1)
    for array in (x, y, weight):
        array.flags.writeable = False
    return Rule(x, y, weight)
