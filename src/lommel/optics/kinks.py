"""Where the edges of an opening have kinks, seen from the axis, and what slows rules between them."""

from __future__ import annotations

import cmath
import math

import numpy as np

from lommel.base.arrays import Array
from lommel.optics.aperture import CatEye, Ellipse, Spider

_NEAR = 1e-9


class Kinks:
    """Angles in the frame of an opening where its edges have kinks, and the singularities that slow convergence."""

    def __init__(self, obscuration: float, spider: Spider | None, vignetting: Ellipse | CatEye | None) -> None:
        ellipse = vignetting if isinstance(vignetting, Ellipse) else None
        eye = vignetting if isinstance(vignetting, CatEye) else None
        self.frame = np.eye(2) if ellipse is None else ellipse.frame
        self.back = np.linalg.inv(self.frame)
        self.kinks: list[float] = []
        self.poles: list[complex] = []
        self.roots: list[float] = []
        circles = [((0.0, 0.0), 1.0)] if ellipse is None else []
        circles += [((0.0, 0.0), obscuration)] if obscuration > 0.0 else []
        circles += [(eye.shift, eye.radius)] if eye is not None else []
        if spider is not None:
            self._vanes(spider, circles, ellipse is not None)
        if ellipse is not None and obscuration > 0.0:
            self._ellipse(ellipse.a, ellipse.b, obscuration)
        if eye is not None and any(eye.shift):
            self._eye(eye, obscuration)

    def _point(self, x: float, y: float) -> float:
        u, w = self.back @ (x, y)
        return math.atan2(w, u)

    def _vanes(self, spider: Spider, circles: list[tuple[tuple[float, float], float]], skewed: bool) -> None:
        half = 0.5 * spider.width
        edges = []
        for angle in spider.angles:
            d = np.array([math.cos(angle), math.sin(angle)])
            n = np.array([-d[1], d[0]])
            self.poles.append(self._point(*d))
            self.kinks += [self._point(*n), self._point(*-n)]
            edges += [(half * n, d), (-half * n, d)]
        for start, d in edges:
            for center, radius in circles:
                self._crossings(start - center, d, radius, start)
            if skewed:
                self._crossings(self.back @ start, self.back @ d, 1.0, start, d)
        for i, (p, d) in enumerate(edges):
            for q, e in edges[:i]:
                turn = d[0] * e[1] - d[1] * e[0]
                if abs(turn) > 1e-12:
                    s = ((q - p)[0] * e[1] - (q - p)[1] * e[0]) / turn
                    self.kinks.append(self._point(*(p + s * d)))

    def _crossings(self, p: Array, d: Array, radius: float, start: Array, along: Array | None = None) -> None:
        """Add where the line ``p + s d`` crosses a circle around the origin; s leads along the vane from `start`."""
        a, b, c = d @ d, p @ d, p @ p - radius**2
        if b * b >= a * c:
            for sign in (-1.0, 1.0):
                s = (-b + sign * math.sqrt(b * b - a * c)) / a
                if s > 0.0:
                    self.kinks.append(self._point(*(start + s * (d if along is None else along))))

    def _ellipse(self, a: float, b: float, eps: float) -> None:
        """Add what obscuring the middle of an ellipse brings: ``eps / |e(theta)|`` is its edge in the frame."""
        if a == b:
            return
        depth = math.atanh(min(a, b) / max(a, b))
        base = 0.5 * math.pi if a > b else 0.0
        self.poles += [base + k * math.pi + sign * 1j * depth for k in (0, 1) for sign in (-1, 1)]
        square = (eps**2 - b**2) / (a**2 - b**2)
        if 0.0 <= square <= 1.0:
            angle = math.acos(math.sqrt(square))
            self.kinks += [angle, math.pi - angle, math.pi + angle, -angle]

    def _eye(self, eye: CatEye, eps: float) -> None:
        distance, toward = math.hypot(*eye.shift), math.atan2(eye.shift[1], eye.shift[0])
        if distance < 1e-15:  # which no angle can tell from none
            return
        for radius in (1.0, eps):
            cosine = (distance**2 + radius**2 - eye.radius**2) / (2.0 * distance * radius) if radius > 0.0 else 2.0
            if abs(cosine) <= 1.0:
                self.kinks += [toward + math.acos(cosine), toward - math.acos(cosine)]
        # Branch points of sqrt(radius^2 - distance^2 sin^2): the tangents from the axis, if it is outside.
        tangent = cmath.asin(eye.radius / distance)
        turns = [tangent, -tangent, math.pi - tangent, math.pi + tangent]
        self.poles += [toward + angle for angle in [*turns, *(angle.conjugate() for angle in turns)]]
        if eye.radius <= distance:
            self.roots += [toward + tangent.real, toward - tangent.real]


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
