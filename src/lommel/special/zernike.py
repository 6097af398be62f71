"""Zernike circle polynomials and their index conventions (Noll, ANSI, Fringe)."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array

ORDERS = ("nm", "noll", "ansi", "fringe")
NAMES_ELSEWHERE = {"osa": "OSA's is 'ansi'", "OSA": "OSA's is 'ansi'", "standard": "Zernike Standard is 'noll'"}
MAX_DEGREE = 60
"""Highest degree n of a term."""


def check_term(n: object, m: object) -> tuple[int, int]:
    """Return (n, m) if these are the indices of a Zernike term; otherwise raise ValueError."""
    try:
        degree = validation.integer("n", n, least=0, most=MAX_DEGREE)
        order = validation.integer("m", m, least=-MAX_DEGREE, most=MAX_DEGREE)
    except ValueError as error:
        # The message about one index alone would not contain the whole term.
        raise ValueError(f"there is no Zernike term (n, m) = ({n}, {m}): {error}") from None
    if abs(order) > degree or (degree - order) % 2:
        raise ValueError(f"there is no Zernike term (n, m) = ({n}, {m}): abs(m) must be at most n, and n - m even")
    return degree, order


def check_order(order: object) -> None:
    """Raise ValueError unless the order of Zernike terms is known, with the name that it has here."""
    if isinstance(order, str) and order in NAMES_ELSEWHERE:
        raise ValueError(
            f"order must be one of {', '.join(map(repr, ORDERS))}, got {order!r}; {NAMES_ELSEWHERE[order]}"
        )
    validation.choice("order", order, ORDERS)


def term(index: object, order: str) -> tuple[int, int]:
    """Return (n, m) from a pair ("nm") or from an integer; TypeError or ValueError if there is no such term."""
    # R. J. Noll, J. Opt. Soc. Am. 66, 207 (1976), doi:10.1364/JOSA.66.000207; ANSI Z80.28; J. C. Wyant and K. Creath,
    # "Basic wavefront aberration theory", Applied Optics and Optical Engineering XI (1992), Table III (Fringe).
    check_order(order)
    if order == "nm":
        if not isinstance(index, tuple | list) or len(index) != 2:
            is_number = isinstance(index, int | np.integer) and not isinstance(index, bool)
            hint = '; for terms by number use order="noll", "ansi" or "fringe"' if is_number else ""
            raise TypeError(f'a term in the order "nm" must be a pair (n, m), got {validation.shown(index)}{hint}')
        return check_term(*index)
    lowest = 0 if order == "ansi" else 1
    largest = 37 if order == "fringe" else lowest + (MAX_DEGREE + 1) * (MAX_DEGREE + 2) // 2 - 1
    if isinstance(index, tuple | list):
        raise TypeError(f'a term in the order "{order}" must be an integer, got {validation.shown(index)}')
    j = validation.integer(f"a Zernike index in the order {order!r}", index, least=lowest, most=largest)
    if order == "ansi":
        # Degree n begins at j = n (n + 1) / 2, which is solved for n in exact integers.
        n = (math.isqrt(8 * j + 1) - 1) // 2
        return n, 2 * j - n * (n + 2)
    if order == "noll":
        n = (math.isqrt(8 * j - 7) - 1) // 2
        # Within a degree, Noll indices rise with abs(m); even indices are cosines, and odd indices are sines.
        place = j - n * (n + 1) // 2  # 1 ... n + 1 within the degree
        m = 2 * (place // 2) if n % 2 == 0 else 2 * ((place - 1) // 2) + 1
        return n, m if j % 2 == 0 else -m
    return _FRINGE[j]


def index_of(n: int, m: int, order: str) -> Any:
    """Return the index of (n, m) in the given order of terms; the inverse of :func:`term`."""
    n, m = check_term(n, m)
    check_order(order)
    if order == "nm":
        return n, m
    if order == "ansi":
        return (n * (n + 2) + m) // 2
    if order == "noll":
        start = n * (n + 1) // 2 + abs(m)
        # Even indices are cosines, odd indices are sines.
        return start + (1 if (m == 0 or (m > 0) == (start % 2 == 1)) else 0)
    if (n, m) not in _FRINGE_INDEX:
        raise ValueError(
            f'the order "fringe" ends with 37 terms and has no (n, m) = ({n}, {m}): take order="noll", or a '
            "wavefront fitted to a degree of at most 5"
        )
    return _FRINGE_INDEX[n, m]


# Fringe: groups g = (n + abs(m)) / 2; within a group abs(m) falls, and cosine precedes sine. Term 37 has n = 12.
_GROUPS = ((2 * g - m, m) for g in range(6) for m in range(g, -1, -1))
_FRINGE = dict(enumerate([*((n, s) for n, m in _GROUPS for s in ((m, -m) if m else (0,))), (12, 0)], 1))
_FRINGE_INDEX = {term: j for j, term in _FRINGE.items()}


@lru_cache(maxsize=1024)
def rms_factor(n: int, m: int) -> float:
    """Return the value at the edge of the pupil (rho = 1) of a term normalized to unit rms.

    ``Z = sqrt((2 - delta_m0) (n + 1)) R(rho) cos(m theta)`` has unit variance (Noll, Eq. 1).

    Parameters
    ----------
    n, m : int
        A term; m < 0 is a sine.

    Returns
    -------
    float
    """
    return math.sqrt((n + 1) * (1 if m == 0 else 2))


def name(n: int, m: int) -> str:
    """Return the name of a term: ``"coma x"``, ``"secondary astigmatism 45"``, ``"spherical"``.

    x and y denote cosine and sine; astigmatism has its axes at 0 and 45 degrees.

    Parameters
    ----------
    n, m : int
        A term; m < 0 is a sine.

    Returns
    -------
    str
    """
    n, m = check_term(n, m)
    if n <= 2 and m in (0, 1, -1):
        return {(0, 0): "piston", (1, 1): "tilt x", (1, -1): "tilt y", (2, 0): "defocus"}[n, m]
    # Names count from the lowest degree of a kind: spherical from n = 4, coma from n = 3, others from n = abs(m).
    order = abs(m)
    rank = (n - max(order, {0: 4, 1: 3}.get(order, 0))) // 2
    kind = ("spherical", "coma", "astigmatism", "trefoil", "tetrafoil", "pentafoil", "hexafoil")
    noun = kind[order] if order < len(kind) else f"{order}-foil"
    grade = ("", "secondary ", "tertiary ", "quaternary ")
    prefix = grade[rank] if rank < len(grade) else f"{rank + 1}th "
    if m == 0:
        return prefix + noun
    if order == 2:
        return f"{prefix}{noun} {0 if m > 0 else 45}"
    return f"{prefix}{noun} {'x' if m > 0 else 'y'}"


def radial(n: int, m: int, rho: Array) -> Array:
    """Return ``R_n^abs(m)(rho) = rho^abs(m) P_k^(0,abs(m))(2 rho^2 - 1)``, 1 at rho = 1; ``k = (n - abs(m)) / 2``."""
    # The last polynomial of the recurrence has the degree n.
    (highest,) = deque(_jacobi(abs(m), n, rho), maxlen=1)
    return np.asarray(rho ** abs(m) * highest)


def radials(m: int, highest: int, rho: Array) -> list[Array]:
    """Return ``R_n^abs(m)(rho)`` for ``n = abs(m), abs(m) + 2, ...`` up to `highest`, at least ``abs(m)``."""
    power = rho ** abs(m)
    return [np.asarray(power * factor) for factor in _jacobi(abs(m), highest, rho)]


def _jacobi(m: int, highest: int, rho: Array) -> Iterator[Array]:
    """Yield ``P_k^(0,m)(2 rho^2 - 1)`` for k = 0, 1, ..., (highest - m) / 2, by recurrence (DLMF 18.9.1-2)."""
    a, x = float(m), 2.0 * rho * rho - 1.0
    previous, current = np.zeros_like(x), np.ones_like(x)
    yield current
    for k in range((highest - m) // 2):
        s = 2 * k + a
        if k == 0:  # the general factors are 0 / 0 if m = 0
            previous, current = current, 0.5 * ((a + 2.0) * x - a)
        else:
            scale = 2.0 * (k + 1) * (k + 1 + a) * s
            slope = (s + 1) * (s + 2) * s
            shift = -(s + 1) * a * a
            weight = 2.0 * k * (k + a) * (s + 2)
            previous, current = current, ((slope * x + shift) * current - weight * previous) / scale
        yield current


def normalized(terms: Sequence[tuple[int, int]], rho: Array, theta: Array) -> Array:
    """Return the rms-normalized terms (n, m) at points, shape (terms, points); m < 0 is a sine."""
    radii = {key: rms_factor(*key) * radial(*key, rho) for key in {(n, abs(m)) for n, m in terms}}
    azimuths = {m: np.cos(m * theta) if m >= 0 else np.sin(-m * theta) for m in {m for _, m in terms}}
    return np.array([radii[n, abs(m)] * azimuths[m] for n, m in terms])


def polynomial(n: int, m: int, rho: Array, theta: Array) -> Array:
    """Return ``R_n^abs(m)(rho)`` times ``cos(m theta)`` or, for m < 0, ``sin(abs(m) theta)``; its modulus is <= 1.

    Parameters
    ----------
    n, m : int
        A term; m < 0 is a sine.
    rho, theta : ndarray
        Radius divided by the radius of the pupil, and angle in radians; both broadcast.

    Returns
    -------
    ndarray
    """
    # Cosines for m >= 0, sines for m < 0: docs/conventions.md.
    azimuth = np.cos(m * theta) if m >= 0 else np.sin(-m * theta)
    return np.asarray(radial(n, m, rho) * azimuth)


def scaled(terms: Mapping[tuple[int, int], Array], radius: Array | float) -> dict[tuple[int, int], Array]:
    """Return the coefficients, with the constant, on a concentric disk of `radius` (in units of the pupil radius)."""
    # A. J. E. M. Janssen and P. Dirksen, J. Microlith. Microfab. Microsyst. 5, 030501 (2006): ``R_n^m(a rho) = sum_k
    # (R_n^k(a) - R_n^(k+2)(a)) R_k^m(rho)``, k = m, m + 2, ..., n.
    radii = np.asarray(radius, dtype=np.float64)
    results: dict[tuple[int, int], Array] = {}
    for (n, m), c in terms.items():
        # Certificate, section 5: s_jk = R_n^k(eps) - R_n^(k+2)(eps).
        values = [radial(n, k, radii) for k in range(abs(m), n + 1, 2)] + [np.zeros(())]
        for i, k in enumerate(range(abs(m), n + 1, 2)):
            results[k, m] = results.get((k, m), np.zeros(())) + (values[i] - values[i + 1]) * c
    return results


def rotated(terms: Mapping[tuple[int, int], Array], angle: Array) -> dict[tuple[int, int], Array]:
    """Return the coefficients of the function rotated by `angle` from x to y: ``f(rho, theta - angle)``."""
    zero = np.zeros(())
    coefficients: dict[tuple[int, int], Array] = {}
    for n, m in sorted({(n, abs(m)) for n, m in terms}):
        # Expansion of a cos m(theta - angle) + b sin m(theta - angle). Rotation mixes the cosine and the sine of a
        # term; if one of the two is missing, its coefficient is 0.
        a, b = terms.get((n, m), zero), terms.get((n, -m), zero)
        cosine, sine = np.cos(m * angle), np.sin(m * angle)
        coefficients[n, m] = np.asarray(a * cosine - b * sine)
        if m:
            coefficients[n, -m] = np.asarray(a * sine + b * cosine)
    return coefficients


def legendre_sum(coefficients: Array, x: Array) -> Array:
    """Return ``sum_j a_j (P_j(x) - P_j(-1))``, j = 1, 2, ..., of shape ``a.shape[:-1] + x.shape``."""
    series = _series(coefficients)
    # The value at the centre, P_j(-1), is subtracted: the phase is 0 on the axis.
    legval = np.polynomial.legendre.legval  # imported lazily by NumPy
    return np.asarray(legval(x, series) - legval(np.full((1,) * x.ndim, -1.0), series))


def legendre_slope(coefficients: Array, x: Array) -> Array:
    """Return the derivative by x of :func:`legendre_sum`."""
    legendre = np.polynomial.legendre
    return np.asarray(legendre.legval(x, legendre.legder(_series(coefficients))))


def _series(coefficients: Array) -> Array:
    """Return the coefficients of P_0, P_1, ... along the first axis, as numpy.polynomial requires."""
    return np.insert(np.moveaxis(coefficients, -1, 0), 0, 0.0, axis=0)


def edge_of_powers(powers: Array) -> Array:
    """Return the coefficients of R_2^0, R_4^0, ... from coefficients of t, t^2, ..., t = rho^2: ``(..., terms)``."""
    if powers.shape[-1] == 2:
        # 2 t = 1 + P_1 and 6 t^2 = 2 + 3 P_1 + P_2: one or two rounding errors per coefficient.
        edge = np.empty_like(powers)
        edge[..., 0] = 0.5 * (powers[..., 0] + powers[..., 1])
        edge[..., 1] = powers[..., 1] / 6.0
        return edge
    return (powers @ powers_to_legendre(powers.shape[-1])[1:].T).astype(np.float64)


def conversion_error(powers: Array) -> Array:
    """Bound the sum of the errors of :func:`edge_of_powers`, except the last rounding of each coefficient."""
    # On [0, 1] each power is at most 1, and its Legendre coefficients are positive with a sum of 1.
    # The bound is (K + 3) u' sum abs(c_k) for K powers with coefficients c_k, u' the unit of extended precision:
    # certificate, "Model error of a wavefront".
    unit = float(np.finfo(np.longdouble).eps)
    return np.asarray((powers.shape[-1] + 3) * unit * np.abs(powers).sum(axis=-1))


def powers_of_edge(coefficients: Array) -> Array:
    """Return the coefficients of t, t^2, ... from coefficients of R_2^0, R_4^0, ...; moduli grow like 5.8^terms."""
    return (coefficients @ legendre_to_powers(coefficients.shape[-1]).T).astype(np.float64)


@lru_cache(maxsize=32)
def powers_to_legendre(terms: int) -> NDArray[np.longdouble]:
    """Return the matrix ``(terms + 1, terms)`` from powers of t = rho^2 to R_0^0, R_2^0, ..., constant first."""
    # t^k = sum_j (2 j + 1) k!^2 / ((k - j)! (k + j + 1)!) R_2j^0; in extended precision, since high powers cancel.
    f = math.factorial

    def fraction(j: int, k: int) -> tuple[int, int]:
        return ((2 * j + 1) * f(k) ** 2, f(k - j) * f(k + j + 1)) if j <= k else (0, 1)

    return _matrix(fraction, range(terms + 1), terms)


@lru_cache(maxsize=32)
def legendre_to_powers(terms: int) -> NDArray[np.longdouble]:
    """Return the matrix ``(terms, terms)`` from R_2^0, R_4^0, ... to powers of t = rho^2."""

    def fraction(k: int, j: int) -> tuple[int, int]:
        return (-1) ** (j + k) * math.comb(j, k) * math.comb(j + k, k), 1

    return _matrix(fraction, range(1, terms + 1), terms)


def _matrix(fraction: Callable[[int, int], tuple[int, int]], rows: range, terms: int) -> NDArray[np.longdouble]:
    pairs = [[fraction(row, k) for k in range(1, terms + 1)] for row in rows]
    # Quotients of exact integers, rounded once to extended precision.
    matrix = np.array(
        [[np.longdouble(numerator) / np.longdouble(denominator) for numerator, denominator in row] for row in pairs]
    )
    matrix.flags.writeable = False
    return matrix


@lru_cache(maxsize=64)
def annular(m: int, highest: int, obscuration: float) -> Array:
    r"""Return rms coefficients over the disc, a row per n, of annular Zernike terms of order `m` up to `highest`.

    Annular terms are orthonormal over ``obscuration <= rho <= 1``: V. N. Mahajan, J. Opt. Soc. Am. 71, 75 (1981),
    doi:10.1364/JOSA.71.000075, by QR factors instead of Gram-Schmidt sums. The matrix is upper triangular, with rows
    and columns n = abs(m), abs(m) + 2, ...

    Raises
    ------
    ValueError
        If rounding errors would cost more than seven of sixteen digits.
    """
    orders = range(abs(m), highest + 1, 2)
    t_min = obscuration * obscuration
    x, w = np.polynomial.legendre.leggauss(orders[-1] + 1)  # exact: the integrands are polynomials of rho^2
    rho = np.sqrt(t_min + (1.0 - t_min) * 0.5 * (1.0 + x))
    # The mean of cos^2 over the azimuth is 1/2, which rms_factor, normalised for the disc, contains.
    weight = np.sqrt((0.5 if m == 0 else 0.25) * w)
    basis = np.stack([rms_factor(n, m) * radial(n, m, rho) * weight for n in orders], axis=1)
    # R of the QR factors is the triangular matrix of Gram-Schmidt orthogonalization.
    factor = np.linalg.qr(basis, mode="r")
    # QR factors have arbitrary signs: with positive diagonal elements, terms become Zernike's for no obscuration.
    factor *= np.sign(np.diag(factor))[:, None]
    if not float(np.linalg.cond(factor)) < 1e7:
        raise ValueError(
            f"annular Zernike terms of order m = {m} up to n = {orders[-1]} over an obscuration of {obscuration:g} "
            "are nearly linearly dependent; use a lower degree"
        )
    # The columns of the inverse express annular terms by terms of the disc: basis = Q R, so that Q = basis R^-1.
    matrix: Array = np.linalg.inv(factor)
    matrix.flags.writeable = False
    return matrix


def annular_edge(n: int, m: int, obscuration: float) -> float:
    """Return the value of an annular term of rms 1 at the edge of the pupil, largest over the azimuth."""
    orders = range(abs(m), n + 1, 2)
    return float(annular(m, n, obscuration)[:, -1] @ [rms_factor(k, m) for k in orders])


def over_disc(terms: Mapping[tuple[int, int], Array], obscuration: float) -> dict[tuple[int, int], Array]:
    """Return rms coefficients over the disc from annular Zernike coefficients (rms over the annulus), or stacks."""
    return _by_orders(terms, lambda m, highest: annular(m, highest, obscuration))


def over_annulus(terms: Mapping[tuple[int, int], Array], obscuration: float) -> dict[tuple[int, int], Array]:
    """Return rms coefficients over an annulus from Zernike coefficients (rms over the disc): inverse of over_disc."""

    def matrix(m: int, highest: int) -> Array:
        return np.asarray(np.linalg.inv(annular(m, highest, obscuration)), dtype=np.float64)

    return _by_orders(terms, matrix)


def _by_orders(
    terms: Mapping[tuple[int, int], Array], matrix: Callable[[int, int], Array]
) -> dict[tuple[int, int], Array]:
    results: dict[tuple[int, int], Array] = {}
    for m in {m for _, m in terms}:
        orders = range(abs(m), max(n for n, k in terms if k == m) + 1, 2)
        columns_of_orders = [np.asarray(terms.get((n, m), 0.0)) for n in orders]
        columns = np.stack(np.broadcast_arrays(*columns_of_orders), axis=-1)
        for n, row in zip(orders, matrix(m, orders[-1]), strict=True):
            results[n, m] = columns @ row
    return results
