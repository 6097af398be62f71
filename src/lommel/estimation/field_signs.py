"""Wavefronts over a field from fits of single stars: polynomials, and the signs of even parts of one focus.

One focus leaves the sign of the even part of the phase of each star open. Neighbours are alike: the signs are those
of the first eigenvector of a matrix of their similarities (angular synchronisation in Z_2: Singer 2011,
doi:10.1016/j.acha.2010.02.001), then alternately polynomials and the nearer sign.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from lommel.base.arrays import Array

_REACHES = 0.25, 0.4, 0.7  # half fields over which wavefronts are alike
_WALLS = 3  # candidates in which one side of a line has the other sign
_TURNS = 25
_LEAST = 0.03  # radians rms: residuals below count as that


def monomials(u: Array, v: Array, degree: int) -> Array:
    """Return products of Legendre polynomials of total degree up to `degree` at u and v, shape (..., m)."""
    first, second = (
        legendre.legvander(np.ravel(part), degree).reshape(*np.shape(part), degree + 1) for part in (u, v)
    )
    return np.stack([first[..., i] * second[..., j] for i, j in powers(degree)], axis=-1)


def with_errors(u: Array, v: Array, degree: int, coefficients: Array, covariance: Array) -> tuple[Array, Array]:
    """Return polynomials (..., k) at positions and their standard errors, of coefficients (k, m) row by row.

    The covariance may be that of further parameters after these.
    """
    basis = monomials(u, v, degree)
    k, m = coefficients.shape
    blocks = covariance[: k * m, : k * m].reshape(k, m, k, m)[np.arange(k), :, np.arange(k)]
    variance = np.einsum("...i,kij,...j->...k", basis, blocks, basis)
    return np.asarray(basis @ coefficients.T), np.sqrt(np.maximum(variance, 0.0))


def powers(degree: int) -> list[tuple[int, int]]:
    """Return the degrees in u and v of each polynomial, the constant first."""
    return [(total - j, j) for total in range(degree + 1) for j in range(total + 1)]


def highest_degree(most: int, count: int) -> int:
    """Return the highest degree up to `most` whose polynomials have two of `count` points each, at least 0."""
    return max((d for d in range(most + 1) if (d + 1) * (d + 2) <= count), default=0)


def robust(basis: Array, waves: Array, quality: Array, metric: Array) -> tuple[Array, Array]:
    """Return polynomials (k, m) through wavefronts (n, k), and the distance of each star from them, radians rms.

    `quality` (n,) weighs the stars, and those far from the others count little (Geman and McClure).
    """
    weight = quality.copy()
    for _ in range(_TURNS):
        root = np.sqrt(weight)[:, None]
        found = np.linalg.lstsq(root * basis, root * waves, rcond=1e-8)[0]
        distance = _rms(waves - basis @ found, metric)
        scale = max(1.5 * float(np.median(distance)), _LEAST)
        weight = quality / (1.0 + (distance / scale) ** 2) ** 2
    return np.asarray(found.T), distance


def _rms(waves: Array, metric: Array) -> Array:
    return np.asarray(np.sqrt(np.maximum(np.einsum("ni,ij,nj->n", waves, metric, waves), 0.0)))


def candidates(
    places: Array,
    waves: Array,
    even: Array,
    negated: Callable[[Array], Array],
    bases: list[Array],
    quality: Array,
    metric: Array,
    draw: np.random.Generator,
) -> Iterator[tuple[Array, Array]]:
    """Yield polynomials (k, m) of the last basis and wavefronts of consistent sign, those that fit best first.

    `places` (n, 2) are in half fields; `even` (n, j) is the even part of each wavefront, radians rms; `negated`
    changes its sign; `bases` (n, m) are polynomials of rising degree.
    """
    other = negated(waves)
    length = np.maximum(np.linalg.norm(even, axis=1), 1e-9)
    unit = even / length[:, None]
    apart = ((places[:, None] - places[None]) ** 2).sum(axis=-1)
    # Where there is hardly an even part, there is no sign either.
    weight = quality * np.minimum(length / np.median(length), 1.0)
    signs: list[NDArray[np.float64]] = []
    for reach in _REACHES:
        alike = np.exp(-apart / (2.0 * reach**2)) * (unit @ unit.T) * np.outer(weight, weight)
        np.fill_diagonal(alike, 0.0)
        signs.append(np.where(np.linalg.eigh(alike)[1][:, -1] < 0.0, -1.0, 1.0))
    for _ in range(_WALLS):
        across = draw.normal(size=2)
        wall = places @ (across / np.linalg.norm(across)) - draw.uniform(-0.5, 0.5)
        signs.append(signs[1] * np.where(wall < 0.0, -1.0, 1.0))
    found = []
    for sign in signs:
        chosen = np.where(sign[:, None] > 0.0, waves, other)
        for basis in bases:
            for _ in range(_TURNS):
                polynomials, distance = robust(basis, chosen, quality, metric)
                model = basis @ polynomials.T
                nearer = _rms(waves - model, metric) <= _rms(other - model, metric)
                changed = np.where(nearer[:, None], waves, other)
                if (changed == chosen).all():
                    break
                chosen = changed
        found.append((float(np.median(distance)), polynomials, chosen))
    tried: list[Array] = []
    for _, polynomials, chosen in sorted(found, key=lambda each: each[0]):
        mirrored = negated(chosen)
        if not any(_share(chosen, old) > 0.97 or _share(mirrored, old) > 0.97 for old in tried):
            tried.append(chosen)
            yield polynomials, chosen


def _share(one: Array, other: Array) -> float:
    return float((one == other).all(axis=1).mean())
