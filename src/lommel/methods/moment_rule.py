r"""Quadrature over the whole disc with the moments of an aperture: few nodes, whatever its edges.

A rule for an aperture is a functional L of polynomials. On polynomials up to a degree D it is the integral of these
times one polynomial g, so that the nodes of a rule of the disc that is exact to the degree 2 D, times g, give the
same: D + 1 chords with D + 1 nodes each, for any number of vanes or segments. The weights may be negative or complex;
their moduli sum to at most ``sqrt(sum omega) sqrt(sum omega |g|^2)``, about the root of the transmitted area.

g is the sum of ``L(phi) phi`` over an orthonormal basis of products of Gegenbauer polynomials of y and Legendre
polynomials along the chord at y (Koornwinder 1975), which take one recurrence along each axis.

References
----------
T. Koornwinder, "Two-variable analogues of the classical orthogonal polynomials", in Theory and Application of Special
Functions, Academic Press (1975), 435.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.optics.aperture.opening import Opening, degree_needed
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre

Complexes = NDArray[np.complex128]

_UNIT = 2.0**-53
_VALUES = 2**21  # amplitudes at once
_MOST_TERM = 12  # degree of terms up to which products of polynomials of x and y lose little by cancellation
_LEAST_FIELDS = 4  # from which on it is worth while to make the rule
_LEAST_ERROR = 3e-12  # of the field over its amplitude, below which roundings are in the way
_MOST_WAVES = 2**22  # values of waves that are kept
_STEP = 32  # of degrees


def worth(pupil: Pupil, grid: Grid, terms: tuple[tuple[int, int], ...], degree: int, fine: int, error: float) -> bool:
    """Return whether these sums take less time than transforms of rows; the rest as for :func:`moment_rule`."""
    count, highest = math.prod(pupil.shape), max((n for n, _ in terms), default=0)
    fields, most, (height, width) = 1 + len(terms), 1 + highest, grid.shape
    rows = degree + _STEP / 2
    if count * fields < _LEAST_FIELDS or highest > _MOST_TERM or error < _LEAST_ERROR * pupil.amplitude:
        return False
    if most * rows**2 / 4 * max(height, width) > _MOST_WAVES:
        return False
    # Costs per PSF, in the time of one sample of a Fourier transform, fitted to stacks of 1 to 27 PSFs of 17 to 257
    # pixels a side; four stacks or steps of a fit take the same rule.
    _, sampled, power = _rounded(degree, fine, error)
    samples = _samples(pupil.opening, sampled, power)
    making = 0.16 * samples * rows / (4 * count)
    sums = 1.6 * rows**2 + most * rows**2 * width / 300 + (most**2 * rows / 240 + fields / 3) * height * width
    return making + sums < (fields + 0.3) * samples + fields * (0.8 * height * width + 1700.0)


class MomentRule(NamedTuple):
    """Weights of the nodes of the disc rule of so many `rows`, of as many nodes, shape (rows, rows)."""

    weight: Complexes
    total: float  # of their moduli
    lost: float  # by edges that are misplaced by rounding

    @property
    def rows(self) -> int:
        """Number of rows, even."""
        return len(self.weight)


class Nodes(NamedTuple):
    """A rule of the disc: rows at `y`, nodes `x`, (rows, rows), and the weight of each."""

    y: Array
    x: Array
    along: Array  # x over half of the chord
    weight: Array


@lru_cache(maxsize=8)
def nodes(rows: int) -> Nodes:
    """Return the rule of the disc, which is exact to the degree ``2 rows - 1``; it is symmetric about both axes."""
    theta = (np.arange(rows) + 1.0) * (math.pi / (rows + 1))
    half, (along, each) = np.sin(theta), gauss_legendre(rows, -1.0, 1.0)
    return Nodes(np.cos(theta), np.outer(half, along), np.asarray(along), np.outer(half**2 / (rows + 1), each))


def moment_rule(opening: Opening, degree: int, fine: int, error: float) -> MomentRule:
    """Return the rule that for polynomials up to a `degree` gives what that of :meth:`Opening.rows` for `fine` does.

    Segments have their phases in the weights, which `fine` has to allow for.
    """
    return _made(opening, *_rounded(degree, fine, error))


def degrees_and_error(pupil: Pupil, reach: float, aim: float) -> tuple[int, int, float]:
    """Return the degrees that :func:`moment_rule` takes for v up to `reach`, and what U is off by then.

    Polynomials are off by `aim`. The degree of a term that multiplies the pupil function is added to the first two.
    """
    terms = [(n, w) for (n, _), w in pupil.wavefront.amplitudes().items()]
    phases = pupil.opening.phases
    steepest = float(np.hypot(phases[:, 1], phases[:, 2]).max())
    degree = degree_needed(terms, reach, pupil.illumination, aim)
    # The waves of segments are within the error of a polynomial, which multiplies those of this degree.
    fine = degree + (degree_needed([], steepest, pupil.illumination, aim, power=0.0) if steepest else 0)
    # Polynomials close to the integrand are at most 1 + aim by size, and so twice as far off.
    return degree, fine, 1.1 * aim + (1.0 + aim) * aim + phase_roundings(pupil)


def phase_roundings(pupil: Pupil) -> float:
    """Return what roundings of the phases of segments change U by, however many turns there are."""
    return 8.0 * _UNIT * float(np.abs(pupil.opening.phases).sum(axis=1).max()) * math.sqrt(pupil.amplitude)


def _rounded(degree: int, fine: int, error: float) -> tuple[int, int, int]:
    """Return degrees rounded up and the power of ten of the error rounded down, so that searches make few rules."""
    first, second = (_STEP * math.ceil(each / _STEP) for each in (degree, max(fine, degree)))
    return first, second, 2 * math.floor(0.5 * math.log10(error))


@lru_cache(maxsize=16)
def _samples(opening: Opening, fine: int, power: int) -> int:
    """Return the number of nodes of the rows that a Fourier transform takes."""
    return sum(rule.nodes.shape[1] for rule in opening.rows(fine, 10.0**power))


@lru_cache(maxsize=16)
def _made(opening: Opening, degree: int, fine: int, power: int) -> MomentRule:
    moments = np.zeros((degree + 1, degree + 1), dtype=np.complex128)
    for rule, phase in zip(opening.rows(fine, 10.0**power), opening.phases, strict=True):
        x, y, weight = rule.nodes
        if not x.size:
            continue
        firsts = np.flatnonzero(np.diff(y, prepend=np.nan) != 0.0)
        half = np.sqrt((1.0 - y) * (1.0 + y))
        still = math.remainder(phase[0], 2.0 * math.pi)
        turned = weight * np.exp(1j * (still + phase[1] * x + phase[2] * y))
        along = np.clip(x / half, -1.0, 1.0)
        sums = np.array([np.add.reduceat(turned * part, firsts) for part in _legendre(degree, along)])
        for m, part in enumerate(_across(degree, y[firsts])):
            moments[: len(part), m] += np.einsum("kr,kr->k", part, sums[: len(part)])
    at = nodes(degree + 2)
    values = np.zeros((degree + 1, at.y.size), dtype=np.complex128)
    for m, part in enumerate(_across(degree, at.y)):
        values[: len(part)] += part * moments[: len(part), m, None]
    weight = np.ascontiguousarray(values.T @ np.array(list(_legendre(degree, at.along))) * (math.pi * at.weight))
    weight.flags.writeable = False
    lost = sum(rule.lost for rule in opening.rows(fine, 10.0**power))
    return MomentRule(weight, float(np.abs(weight).sum()), lost)


def _legendre(degree: int, x: Array) -> Iterator[Array]:
    """Yield the orthonormal Legendre polynomials on [-1, 1] up to a degree."""
    before, here = np.zeros_like(x), np.ones_like(x)
    for k in range(degree + 1):
        yield math.sqrt(k + 0.5) * here
        before, here = here, ((2 * k + 1) * x * here - k * before) / (k + 1)


def _across(degree: int, y: Array) -> Iterator[Array]:
    """Yield for m = 0, 1, ... the functions of y of the basis, [k, y] for all k up to ``degree - m``."""
    # (1 - y^2)^(k / 2) times polynomials orthonormal for the weight (1 - y^2)^(k + 1/2).
    k = np.arange(degree + 1.0)[:, None]
    area = np.cumprod(np.concatenate([[0.5 * math.pi], (k[1:, 0] + 0.5) / (k[1:, 0] + 1.0)]))
    half = np.sqrt((1.0 - y) * (1.0 + y))
    here = half**k / np.sqrt(area)[:, None]
    before = np.zeros_like(here)

    def beside(m: int) -> Array:
        return np.sqrt(m * (m + 2.0 * k + 1.0) / (4.0 * (m + k + 1.0) * (m + k)))

    for m in range(degree + 1):
        yield here
        count = degree - m
        last = beside(m)[:count] * before[:count] if m else 0.0
        before, here = here, (y * here[:count] - last) / beside(m + 1)[:count]
        k = k[:count]


def field_sums(
    rule: MomentRule, pupil: Pupil, grid: Grid, terms: tuple[tuple[int, int], ...]
) -> tuple[Array, Array, Array]:
    """Return I (n, h, w), its derivatives by terms (k, n, h, w), and what roundings change U and its slopes by."""
    # Waves are even or odd along x and along y, as Chebyshev polynomials of these are, of whose products terms are
    # sums. That leaves a quarter of the nodes and of the pixels, and along the rows one sum for each power of x.
    at, q, edge, count = nodes(rule.rows), rule.rows // 2, pupil.wavefront.flattened().edge, math.prod(pupil.shape)
    light = rule.weight
    if not pupil.illumination.uniform:
        light = light * pupil.illumination.at(at.x**2 + at.y[:, None] ** 2)
    phases, shares = _polynomials(pupil.wavefront.terms, rule.rows), _products(((0, 0), *terms))
    most, (height, width) = shares.shape[1], grid.shape
    step = grid.step(pupil) / grid.side
    (right, column), (down, row) = (np.unique(np.abs(part), return_inverse=True) for part in (grid.x, grid.y))
    across, upward = _waves(rule.rows, step, tuple(right.tolist()), most), _rows(rule.rows, step, down, most)
    signs = (np.ones(width), np.sign(grid.x)), (np.ones((height, 1)), np.sign(grid.y)[:, None])
    values, slopes = np.empty((count, height, width)), np.empty((len(terms), count, height, width))
    many = max(1, _VALUES // (4 * most * q * q))
    for first in range(0, count, many):
        part = slice(first, min(first + many, count))
        # Products row by row are too small for threads of BLAS, which would wait for each other.
        angle = edge[part] @ phases
        wave = _turned(light[:, None], np.cos(angle), np.sin(angle))
        parts = _parts(wave, q)
        size = len(edge[part])
        field = np.zeros((1 + len(terms), size, height, width), dtype=np.complex128)
        for i in range(2):
            # Of both parts along y [term, row of pixels, pupil, real or imaginary, column].
            sums = np.zeros((2, len(shares), down.size, size, 2, right.size))
            for a in range(most):
                for c in range(2):
                    along = parts[i ^ (a & 1), c].reshape(q, -1, q) @ across[i][a]
                    found = upward[c][: most - a] @ along.reshape(q, -1)
                    found = found.reshape(most - a, *sums.shape[2:])
                    for b in range(min(2, most - a)):
                        sums[c ^ b] += np.tensordot(shares[:, a, b : most - a : 2], found[b::2], 1)
            for j in range(2):
                both = (sums[j, :, :, :, 0] + 1j * sums[j, :, :, :, 1]).swapaxes(1, 2)[:, :, row[:, None], column]
                field += ((-1j) ** (i + j) * signs[0][i] * signs[1][j]) * both
        u, others = field[0], field[1:]
        values[part] = u.real**2 + u.imag**2
        slopes[:, part] = 2.0 * (u.imag * others.real - u.real * others.imag)
    reach = step * math.hypot(np.abs(grid.x).max(), np.abs(grid.y).max())
    lost = roundings(rule, pupil, reach) * np.array([1.0, float(np.abs(shares).sum(axis=(1, 2)).max())])
    return values, slopes, lost


def roundings(rule: MomentRule, pupil: Pupil, reach: float, *, single: bool = False) -> float:
    """Return what roundings change U by, up to `reach` in v; where all sums are in `single` precision with those."""
    # Phases of terms and of waves, sums along both axes, and the weights.
    edge = pupil.wavefront.flattened().edge
    size_of = np.array([4.0 * n * n + 14.0 + len(edge[0]) for n, _ in pupil.wavefront.terms])
    turned = float((np.abs(edge) @ size_of).max()) + 6.0 * reach + 20.0 * rule.rows + pupil.illumination.slope + 40.0
    # Sums of pairs of chords and nodes, and phases in multiples of 2^-32 turns.
    more = 2.0**-24 * (36.0 + 0.875 * rule.rows) + 7.4e-10 * (len(edge[0]) + 6) if single else 0.0
    return (_UNIT * turned + more) * rule.total + rule.lost


@lru_cache(maxsize=8)
def _products(terms: tuple[tuple[int, int], ...]) -> Array:
    """Return terms as sums of products T_a(x) T_b(y), shape (terms, a, b)."""
    from numpy.polynomial.chebyshev import chebvander

    count = 1 + max(n for n, _ in terms)
    x = np.cos((np.arange(count) + 0.5) * (math.pi / count))
    back = np.linalg.inv(chebvander(x, count - 1))
    rho, theta = np.hypot(x[:, None], x), np.arctan2(x, x[:, None])
    found = np.array([back @ zernike.polynomial(n, m, rho, theta) @ back.T for n, m in terms])
    return np.where(np.abs(found) > 1e-14 * np.abs(found).max(), found, 0.0)


def _turned(light: Complexes, cosine: Array, sine: Array) -> Array:
    """Return the product of light and a wave, [row, pupil, real or imaginary, node]."""
    if not light.imag.any():
        return np.stack([light.real * cosine, light.real * sine], axis=2)
    return np.stack([light.real * cosine - light.imag * sine, light.real * sine + light.imag * cosine], axis=2)


def _parts(wave: Array, q: int) -> dict[tuple[int, int], Array]:
    """Return for a quarter of the nodes, [row, ..., node], sums of four mirrored ones, odd or even along x and y."""
    y = [wave[:q] + sign * wave[: q - 1 : -1] for sign in (1.0, -1.0)]
    mirrored = [part[..., : q - 1 : -1] for part in y]
    return {
        (i, j): np.ascontiguousarray(y[j][..., :q] + sign * mirrored[j])
        for i, sign in enumerate((1.0, -1.0))
        for j in range(2)
    }


@lru_cache(maxsize=8)
def _polynomials(terms: tuple[tuple[int, int], ...], rows: int) -> Array:
    """Return Zernike terms, 1 at the edge, at the nodes of a rule, shape (rows, terms, rows)."""
    at = nodes(rows)
    y = np.broadcast_to(at.y[:, None], at.x.shape)
    rho, theta = np.hypot(at.x, y), np.arctan2(y, at.x)
    return np.stack([zernike.polynomial(n, m, rho, theta) for n, m in terms], axis=1)


@lru_cache(maxsize=4)
def _waves(rows: int, step: float, at: tuple[float, ...], most: int) -> tuple[Array, Array]:
    """Return cosines and sines of a quarter of the nodes at columns times T_a(x), shape (a, row, node, column)."""
    q = rows // 2
    x = nodes(rows).x[:q, :q]
    turn = step * x[:, :, None] * np.array(at)
    powers = np.moveaxis(np.polynomial.chebyshev.chebvander(x, most - 1), -1, 0)[..., None]
    return powers * np.cos(turn), powers * np.sin(turn)


def _rows(rows: int, step: float, at: Array, most: int) -> tuple[Array, Array]:
    """Return the same of the rows, shape (b, row of pixels, node row), of the other kind where b is odd."""
    y = nodes(rows).y[: rows // 2]
    turn = step * np.outer(at, y)
    powers = np.polynomial.chebyshev.chebvander(y, most - 1).T[:, None]
    even, odd = powers * np.cos(turn), powers * np.sin(turn)
    swapped = np.arange(most)[:, None, None] % 2 == 1
    return np.where(swapped, odd, even), np.where(swapped, even, odd)
