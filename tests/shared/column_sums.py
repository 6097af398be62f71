"""Fields of apertures of any shape by plain quadrature, with nothing in common with the compiled rules.

The aperture is cut by lines in a direction of its own into every interval between the edges of any two parts; what is
clear is found anew on every line. Across lines tanh-sinh rules take roots at the ends of panels; two resolutions are
compared.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel import CatEye, Disc, Ellipse, Polygon, Pupil, Segments, Spider
from lommel.optics.aperture.shapes import Combined, Shape

Array = NDArray[np.float64]
Inside = Callable[[list[NDArray[np.bool_]]], NDArray[np.bool_]]


class Round(NamedTuple):
    """Centre, and the images of two unit vectors."""

    centre: Array
    first: Array
    second: Array


def _parts(shape: Shape, parts: list[Round | Array], angle: float) -> Inside:
    """Append the parts of a shape, turned by `angle`; return what is inside from what is inside of each."""
    turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    if isinstance(shape, Combined):
        one, two = _parts(shape.first, parts, angle), _parts(shape.second, parts, angle)
        if shape.kind == "|":
            return lambda inside: one(inside) | two(inside)
        return (lambda i: one(i) & two(i)) if shape.kind == "&" else (lambda i: one(i) & ~two(i))
    first = len(parts)
    if isinstance(shape, Spider):
        for at in shape.angles:
            d, n = np.array([math.cos(at), math.sin(at)]), 0.5 * shape.width * np.array([-math.sin(at), math.cos(at)])
            parts.append(np.array([n, -n, 4 * d - n, 4 * d + n]) @ turn.T)
        count = len(shape.angles)
        return lambda inside: np.any(inside[first : first + count], axis=0)
    if isinstance(shape, Polygon):
        parts.append(np.array(shape.corners) @ turn.T)
    elif isinstance(shape, CatEye):
        parts.append(Round(turn @ shape.shift, turn[:, 0] * shape.radius, turn[:, 1] * shape.radius))
    elif isinstance(shape, Disc):
        parts.append(Round(turn @ shape.center, turn[:, 0] * shape.radius, turn[:, 1] * shape.radius))
    elif isinstance(shape, Ellipse):
        c, s = math.cos(shape.angle), math.sin(shape.angle)
        axes = shape.a * turn @ [c, s], shape.b * turn @ [-s, c]
        parts.append(Round(turn @ shape.center, *axes))
    else:
        raise AssertionError(shape)
    return lambda inside: inside[first]


def _square(part: Round) -> tuple[Array, Array]:
    back = np.linalg.inv(np.stack([part.first, part.second], axis=1))
    return back, back @ part.centre


def _breaks(parts: list[Round | Array]) -> Array:
    """Every s at which an edge begins, ends, or may cross another; some more do no harm."""
    found: list[float] = []
    for i, a in enumerate(parts):
        if isinstance(a, Round):
            half = math.hypot(a.first[0], a.second[0])
            found += [a.centre[0] - half, a.centre[0] + half]
        else:
            found += a[:, 0].tolist()
        for b in parts[:i]:
            found += _crossings(a, b)
    inside = np.clip(np.array(found), -1.0, 1.0)
    inside.sort()
    return inside


def _crossings(a: Round | Array, b: Round | Array) -> list[float]:
    if not isinstance(a, Round):
        if isinstance(b, Round):
            return _crossings(b, a)
        out = []
        for p, q in zip(a, np.roll(a, -1, axis=0), strict=True):
            for r, s in zip(b, np.roll(b, -1, axis=0), strict=True):
                d, e = q - p, s - r
                turn = d[0] * e[1] - d[1] * e[0]
                if turn:
                    t = ((r - p)[0] * e[1] - (r - p)[1] * e[0]) / turn
                    if -0.1 <= t <= 1.1:
                        out.append(float((p + t * d)[0]))
        return out
    if not isinstance(b, Round):
        back, at = _square(a)
        out = []
        for p, q in zip(b, np.roll(b, -1, axis=0), strict=True):
            u, d = back @ p - at, back @ (q - p)
            middle, size = -(u @ d) / (d @ d), float(np.hypot(*(d)))
            off = (u[0] * d[1] - u[1] * d[0]) / size
            half = math.sqrt(max(0.0, (1.0 - off) * (1.0 + off))) / size
            out += [float(p[0] + t * (q - p)[0]) for t in (middle - half, middle, middle + half)]
        return out
    if math.hypot(*a.first, *a.second) > math.hypot(*b.first, *b.second):
        a, b = b, a
    back, at = _square(b)
    centre, first, second = back @ a.centre - at, back @ a.first, back @ a.second
    # |centre + first cos t + second sin t|^2 = 1, a quartic of exp(i t).
    rim = 0.5 * (first - 1j * second)
    two, one = rim @ rim, 2.0 * (centre @ rim)
    none = centre @ centre - 1.0 + 2.0 * (rim @ rim.conj()).real
    roots = np.roots([two, one, none, np.conj(one), np.conj(two)])
    angles = np.angle(roots[np.abs(np.abs(roots) - 1.0) < 0.02])
    for _ in range(3):
        turns = np.exp(1j * angles)
        value = none + 2.0 * (one * turns + two * turns**2).real
        slope = -2.0 * (one * turns + 2.0 * two * turns**2).imag
        angles = angles - np.where(np.abs(slope) > 1e-6, value / np.where(slope == 0.0, 1.0, slope), 0.0)
    return [float(a.centre[0] + a.first[0] * math.cos(t) + a.second[0] * math.sin(t)) for t in angles]


def _ends(part: Round | Array, s: Array) -> tuple[Array, Array]:
    """The interval of t within a part on each line, of length 0 where there is none."""
    if isinstance(part, Round):
        half = math.hypot(part.first[0], part.second[0])
        u = (s - part.centre[0]) / half
        # On the line first cos t + second sin t has the first coordinate u half.
        root = np.sqrt(np.maximum(0.0, (1.0 - u) * (1.0 + u)))
        c, d = part.first[0] / half, part.second[0] / half
        middle = part.centre[1] + u * (part.first[1] * c + part.second[1] * d)
        reach = abs(part.first[1] * d - part.second[1] * c) * root
        return middle - reach, middle + reach
    low, high = np.full(s.shape, np.inf), np.full(s.shape, -np.inf)
    for p, q in zip(part, np.roll(part, -1, axis=0), strict=True):
        if p[0] != q[0]:
            t = (s - p[0]) / (q[0] - p[0])
            at = p[1] + t * (q[1] - p[1])
            here = (t >= 0.0) & (t <= 1.0)
            low, high = np.where(here, np.minimum(low, at), low), np.where(here, np.maximum(high, at), high)
    none = low > high
    return np.where(none, 0.0, low), np.where(none, 0.0, high)


def nodes(shape: Shape, fine: float = 1.0, angle: float = 0.7331) -> tuple[Array, Array, Array]:
    """Return x, y and weights over pi of the points of a shape within the unit disc."""
    parts: list[Round | Array] = []
    clear = _parts(Disc() & shape, parts, angle)
    breaks = _breaks(parts)
    step = 0.11 / fine
    k = step * np.arange(-math.ceil(3.4 / step), math.ceil(3.4 / step) + 1)
    # The part of a panel on the near side of each node, and its weight.
    near = 1.0 / (1.0 + np.exp(-math.pi * np.sinh(k)))
    share = step * math.pi * np.cosh(k) * near * (1.0 / (1.0 + np.exp(math.pi * np.sinh(k))))
    low, high = breaks[:-1], breaks[1:]
    keep = high - low > 1e-15
    low, high = low[keep, None], high[keep, None]
    s, ws = (
        (np.where(near < 0.5, low + (high - low) * near, high - (high - low) * near[::-1])).ravel(),
        ((high - low) * share).ravel(),
    )
    ends = [_ends(part, s) for part in parts]
    edges = np.sort(np.concatenate([np.stack(pair) for pair in ends]), axis=0)
    g, wg = np.polynomial.legendre.leggauss(round(22 * fine))
    xs, ys, weights = [], [], []
    for start, end in itertools.pairwise(edges):
        middle, half = 0.5 * (start + end), 0.5 * (end - start)
        here = clear([(a < middle) & (middle < b) for a, b in ends]) & (half > 0.0)
        if not here.any():
            continue
        t = middle[here, None] + half[here, None] * g
        across = np.broadcast_to(s[here, None], t.shape)
        c, d = math.cos(angle), math.sin(angle)
        xs.append((across * c + t * d).ravel())
        ys.append((t * c - across * d).ravel())
        weights.append((ws[here, None] * half[here, None] * wg / math.pi).ravel())
    if not xs:
        return np.zeros(0), np.zeros(0), np.zeros(0)
    x, y, w = np.concatenate(xs), np.concatenate(ys), np.concatenate(weights)
    keep = w > 1e-22
    return x[keep], y[keep], w[keep]


def regions(pupil: Pupil) -> list[Shape]:
    """The clear regions of a pupil, from its own parts."""
    stops = pupil.stop.shapes if isinstance(pupil.stop, Segments) else [Disc() if pupil.stop is None else pupil.stop]
    out = []
    for stop in stops:
        clear: Shape = stop
        if pupil.vignetting is not None:
            clear = Combined("&", clear, pupil.vignetting)
        if pupil.obscuration:
            clear = Combined("-", clear, Disc(pupil.obscuration))
        out.append(clear if pupil.spider is None else Combined("-", clear, pupil.spider))
    return out


def phases(pupil: Pupil) -> Array:
    """Of each region what its segment adds to the phase: constant, by x, by y."""
    stop = pupil.stop
    if not isinstance(stop, Segments):
        return np.zeros((1, 3))
    out = np.array([stop.piston, stop.tip, stop.tilt]).T
    out[:, 0] -= (out[:, 1:] * stop.centers).sum(axis=1)
    return out


def field(
    pupil: Pupil, vx: Array, vy: Array, fine: float = 1.0, factor: Callable[[Array, Array], Array] | None = None
) -> tuple[NDArray[np.complex128], float]:
    """Return U of a single pupil where rows have vy and columns vx, and what U(0) without aberration is."""
    total, amplitude = np.zeros((len(vy), len(vx)), dtype=np.complex128), 0.0
    for shape, (piston, tip, tilt) in zip(regions(pupil), phases(pupil), strict=True):
        x, y, w = nodes(shape, fine)
        light = w * pupil.illumination.at(x * x + y * y)
        amplitude += float(light.sum())
        phase = np.asarray(pupil.wavefront.phase(np.hypot(x, y), np.arctan2(y, x))).ravel()
        waves = light * np.exp(1j * (phase + piston + tip * x + tilt * y))
        if factor is not None:
            waves = waves * factor(x, y)
        total += (np.exp(-1j * np.outer(vy, y)) * waves) @ np.exp(-1j * np.outer(x, vx))
    return total, amplitude
