"""Wavefronts over a field from fits of single stars: polynomials, and the signs of even parts in one focus.

In one focus the image of a star does not determine the sign of the even part of its phase. Wavefronts of neighbouring
stars are similar: the initial signs are those of the leading eigenvector of the matrix of similarities (angular
synchronisation in Z_2: Singer 2011, doi:10.1016/j.acha.2010.02.001). Then two steps alternate: polynomials are fitted
to the wavefronts, and the sign of each star is set such that its wavefront is nearer to the polynomials. Positions
are in half fields, -1 to 1 across the sensor. k is the number of wavefront terms, m the number of polynomials, and n
the number of stars.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import product

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from lommel.base.arrays import Array

_RADII = 0.25, 0.4, 0.7  # standard deviations, half fields, of the Gaussian weights of similarities by distance
_REVERSED_CANDIDATES = 3  # number of candidates in which all signs on one side of a random line are reversed
_MAX_ITERATIONS = 25
_MIN_SCALE = 0.03  # smallest scale of the residuals in robust fits, radians rms


def monomials(u: Array, v: Array, degree: int) -> Array:
    """Return products of Legendre polynomials of total degree up to `degree` at u and v, shape (..., m)."""
    by_u, by_v = (legendre.legvander(np.ravel(part), degree).reshape(*np.shape(part), degree + 1) for part in (u, v))
    return np.stack([by_u[..., i] * by_v[..., j] for i, j in powers(degree)], axis=-1)


def with_errors(u: Array, v: Array, degree: int, coefficients: Array, covariance: Array) -> tuple[Array, Array]:
    """Return the values (..., k) of k polynomials at positions u, v, and their standard errors.

    The first k * m rows of `covariance` belong to the flattened `coefficients` (k, m); further rows are ignored.
    """
    basis = monomials(u, v, degree)
    k, m = coefficients.shape
    blocks = covariance[: k * m, : k * m].reshape(k, m, k, m)[np.arange(k), :, np.arange(k)]
    variance = np.einsum("...i,kij,...j->...k", basis, blocks, basis)
    return np.asarray(basis @ coefficients.T), np.sqrt(np.maximum(variance, 0.0))


def powers(degree: int) -> list[tuple[int, int]]:
    """Return the degrees in u and v of each product of two Legendre polynomials, the constant first."""
    return [(total - j, j) for total in range(degree + 1) for j in range(total + 1)]


def highest_degree(max_degree: int, count: int) -> int:
    """Return the highest degree <= `max_degree` with at most `count` / 2 products of polynomials; 0 if none has."""
    return max((d for d in range(max_degree + 1) if (d + 1) * (d + 2) <= count), default=0)


def robust(basis: Array, waves: Array, quality: Array, metric: Array) -> tuple[Array, Array]:
    """Return polynomials (k, m) fitted to wavefronts (n, k), and the residual of each star, radians rms.

    `quality` (n,) are weights of the stars. The fit is robust: a star with a large residual has a smaller weight
    (Geman and McClure). The mean square phase of coefficients w is w @ `metric` @ w, with `metric` (k, k).
    """
    weight = quality.copy()
    for _ in range(_MAX_ITERATIONS):
        root = np.sqrt(weight)[:, None]
        polynomials = np.linalg.lstsq(root * basis, root * waves, rcond=1e-8)[0]
        distance = _rms(waves - basis @ polynomials, metric)
        scale = max(1.5 * float(np.median(distance)), _MIN_SCALE)
        weight = quality / (1.0 + (distance / scale) ** 2) ** 2
    return np.asarray(polynomials.T), distance


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
    """Yield polynomials (k, m) of the last basis, and wavefronts of consistent sign, the best fits first.

    `places` (n, 2) are in half fields. `even` (n, j) is the even part of each wavefront, radians rms; `negated`
    negates the even part. `bases` are values (n, m) of polynomials, of increasing degree.
    """
    negated_waves = negated(waves)
    even_rms = np.maximum(np.linalg.norm(even, axis=1), 1e-9)
    unit_even = even / even_rms[:, None]
    squares = ((places[:, None] - places[None]) ** 2).sum(axis=-1)
    # The sign of a small even part is uncertain: its weight is small.
    weight = quality * np.minimum(even_rms / np.median(even_rms), 1.0)
    signs: list[NDArray[np.float64]] = []
    for radius in _RADII:
        similarity = np.exp(-squares / (2.0 * radius**2)) * (unit_even @ unit_even.T) * np.outer(weight, weight)
        np.fill_diagonal(similarity, 0.0)
        signs.append(np.where(np.linalg.eigh(similarity)[1][:, -1] < 0.0, -1.0, 1.0))
    for _ in range(_REVERSED_CANDIDATES):
        normal = draw.normal(size=2)
        distance_from_line = places @ (normal / np.linalg.norm(normal)) - draw.uniform(-0.5, 0.5)
        signs.append(signs[1] * np.where(distance_from_line < 0.0, -1.0, 1.0))
    fits = []
    for sign in signs:
        signed_waves = np.where(sign[:, None] > 0.0, waves, negated_waves)
        for basis in bases:
            for _ in range(_MAX_ITERATIONS):
                polynomials, distance = robust(basis, signed_waves, quality, metric)
                model = basis @ polynomials.T
                is_nearer = _rms(waves - model, metric) <= _rms(negated_waves - model, metric)
                updated_waves = np.where(is_nearer[:, None], waves, negated_waves)
                if (updated_waves == signed_waves).all():
                    break
                signed_waves = updated_waves
        fits.append((float(np.median(distance)), polynomials, signed_waves))
    earlier_waves: list[Array] = []
    for _, polynomials, signed_waves in sorted(fits, key=lambda fit: fit[0]):
        opposite_waves = negated(signed_waves)
        # Skip a candidate if, for more than 97 % of the stars, its signs equal or oppose those of an earlier one.
        pairs = product((signed_waves, opposite_waves), earlier_waves)
        if all((a == b).all(axis=1).mean() <= 0.97 for a, b in pairs):
            earlier_waves.append(signed_waves)
            yield polynomials, signed_waves
