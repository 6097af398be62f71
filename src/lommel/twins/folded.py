r"""Sums over a rule that is symmetric about both axes, for a window that mostly is: a quarter of either is enough.

At the four images ``(+-x, +-y)`` of a node the waves have parts that are even and odd in either coordinate. With
these the kernel is a product of a cosine or sine of ``v_x x`` and one of ``v_y y``, real, and the same at the images
of a pixel but for signs. Pupils stand last throughout: all products are of small tables with long rows.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.twins.namespaces import Namespace

IMAGES = ((1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0))  # of a node: signs of x and y


class Axis(NamedTuple):
    """How the places of a window along one axis follow from those on one side of its middle.

    Attributes
    ----------
    first : int
        Of those, the first with an image: 1 where the middle is a place itself.
    negative, positive : int
        How many are on either side; none is negative where places are no images of each other, and all are kept.
    """

    first: int
    negative: int
    positive: int

    def whole(self, ns: Namespace, below: Any, above: Any, axis: int) -> Any:
        """Return values at all places, along an axis, from those at the images and at the places that are kept."""
        here: list[Any] = [slice(None)] * 3
        here[axis] = slice(0, self.positive)
        above = above[tuple(here)]
        if not self.negative:
            return above
        here[axis] = slice(self.first, self.first + self.negative)
        return ns.xp.concat([ns.flip(below[tuple(here)], axis), above], axis=axis)


def axis_of(v: Array) -> tuple[Axis, Array]:
    """Return the axis of increasing places, and the places that are kept."""
    half = np.unique(np.abs(v))
    first, negative = int(half[0] == 0.0), int(np.sum(v < 0.0))
    positive = len(v) - negative
    if np.array_equal(v, np.concatenate([-half[first : first + negative][::-1], half[:positive]])):
        return Axis(first, negative, positive), half
    return Axis(0, 0, len(v)), v


def tables(x: Array, y: Array, weights: Array, columns: Array, rows: Array) -> dict[str, Array]:
    """Return the real kernels of chords x and of nodes y on them, with their weights ``(chords, nodes)``."""
    down, over = rows[:, None] * y[:, None, :], columns[:, None] * x
    return {
        "along even": np.cos(down) * weights[:, None, :],
        "along odd": np.sin(down) * weights[:, None, :],
        "across even": np.cos(over),
        "across odd": np.sin(over),
    }


def intensity(ns: Namespace, kernels: dict[str, Any], waves: list[tuple[Any, Any]], axes: tuple[Axis, Axis]) -> Any:
    """Return the squared modulus of the sum, shape ``(n, columns * rows)``, columns one after another.

    Parameters
    ----------
    ns : Namespace
    kernels : dict
        Those of :func:`tables`.
    waves : list of (array, array)
        Cosine and sine at each of :data:`IMAGES`, chord by chord, ``(nodes, n)``.
    axes : (Axis, Axis)
        Of columns and rows.
    """
    parts = [part for images in zip(*waves, strict=True) for part in _transformed(ns, kernels, images)]
    image = ns.apart(_assembled(ns, axes), *ns.apart(_quadrants(axes), *parts))
    across, down, count = image.shape
    return ns.xp.permute_dims(ns.xp.reshape(image, (across * down, count)), (1, 0))


def _transformed(ns: Namespace, kernels: dict[str, Any], images: tuple[Any, ...]) -> list[Any]:
    """Return the sums of parts even in both, odd in y, odd in x and odd in both, each ``(columns, rows, n)``."""
    found = []
    for across in ("across even", "across odd"):
        for along in ("along even", "along odd"):
            part, given = _part(ns, along, across), (kernels[along], kernels[across], *images)
            # One after the other, lest what is between two products go to the memory and come back.
            found.append(ns.apart(part, *given))
    return found


@cache
def _part(ns: Namespace, along: str, across: str) -> Callable[..., Any]:
    """Return what sums that part of values at four images which is even or odd in y and x, as kernels are called."""

    def made(rows: Any, columns: Any, a: Any, b: Any, c: Any, d: Any) -> Any:
        one, other = (a + b, c + d) if along == "along even" else (a - b, c - d)
        part = one + other if across == "across even" else one - other
        chords, places, nodes = rows.shape
        count = part.shape[-1]
        of_chords = ns.matmul(rows, ns.xp.reshape(part, (chords, nodes, count)))
        total = ns.matmul(columns, ns.xp.reshape(of_chords, (chords, places * count)))
        return ns.xp.reshape(total, (columns.shape[0], places, count))

    return made


@cache
def _quadrants(axes: tuple[Axis, Axis]) -> Callable[..., tuple[Any, ...]]:
    """Return what makes values at images of the places that are kept, of the parts of a sum, real and imaginary."""

    def made(*parts: Any) -> tuple[Any, ...]:
        real, imaginary = parts[:4], parts[4:]
        alike = real[0] - real[3], imaginary[1] + imaginary[2], imaginary[0] - imaginary[3], real[1] + real[2]
        other = real[0] + real[3], imaginary[2] - imaginary[1], imaginary[0] + imaginary[3], real[2] - real[1]
        # In the order of IMAGES: signs are alike in the first and the last.
        there = [(alike, True), *([(other, True)] * down), *([(other, False)] * across)]
        there += [(alike, False)] * (across and down)
        return tuple(_square(a + b, c - d) if add else _square(a - b, c + d) for (a, b, c, d), add in there)

    across, down = (axis.negative > 0 for axis in axes)
    return made


def _square(real: Any, imaginary: Any) -> Any:
    return real * real + imaginary * imaginary


@cache
def _assembled(ns: Namespace, axes: tuple[Axis, Axis]) -> Callable[..., Any]:
    """Return what makes images ``(columns, rows, n)`` of the quadrants that there are."""

    def made(*quadrants: Any) -> Any:
        across, down = axes
        each = 2 if down.negative else 1
        sides = [down.whole(ns, quadrants[k + each - 1], quadrants[k], 1) for k in range(0, len(quadrants), each)]
        return across.whole(ns, sides[-1], sides[0], 0)

    return made
