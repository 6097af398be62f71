"""Lommel's series (1885): the exact field of a defocused circular aperture."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import FieldValues
from lommel.methods.method import FieldMethod, annulus
from lommel.optics.pupil import Pupil
from lommel.special.bessel import bessel_sequence

_BLOCK = 2**20  # values of J in memory at a time: 8 MiB
_NEAR_FOCUS = 1.0  # largest u = 4 |C_d| for which U_n is used in the geometric image (v < u), where V_n would cancel


@dataclass(frozen=True)
class LommelSeries(FieldMethod[Pupil]):
    r"""Lommel's functions U_n and V_n, for defocus alone; exact to rounding on both sides of u = v.

    Supports uniformly illuminated circular and annular pupils with defocus alone. An obscured pupil is the difference
    of two disks.

    Notes
    -----
    With ``u = 4 abs(C_d)``, ``U_n(u, v) = sum_s (-1)^s (u/v)^(n+2s) J_{n+2s}(v)`` is used in the geometric shadow
    (v >= u) and ``V_n(u, v) = sum_s (-1)^s (v/u)^(n+2s) J_{n+2s}(v)`` in the geometric image (v < u), so that all
    ratios are at most 1. Near focus (u <= 1), ``(u/v)^m J_m(v)`` is computed in the geometric image, where V_n would
    cancel, as ``(u/2)^m / m! 0F1(; m+1; -v^2/4)``. Measured error: below 2e-14.

    References
    ----------
    E. Lommel, Abh. Bayer. Akad. 15, 233 (1885). M. Born and E. Wolf, *Principles of Optics*, 7th ed.,
    section 8.8.1 (whose C - iS is the conjugate of the field U for positive defocus).
    """

    def unsupported(self, pupil: Pupil) -> str | None:
        """Return the reason if the pupil has aberrations other than defocus, else None."""
        w = pupil.wavefront
        if np.any(w.spherical) or any(np.any(c) for c in w.higher):
            return "supports defocus only; this pupil has spherical aberration"
        return None

    def evaluate(self, pupil: Pupil, v: Array) -> FieldValues:
        """Return U at rising v, without an error bound."""
        return annulus(_disk, pupil, v)


def _disk(coefficients: Array, v: Array) -> FieldValues:
    values = np.empty((coefficients.shape[0], v.size), dtype=np.complex128)
    for row, slope in zip(values, coefficients[:, 0], strict=True):
        # coefficients[:, 0] = 2 C_d, and u = 4 |C_d|; negative defocus has the conjugate field.
        row[:] = _field(2.0 * abs(float(slope)), v)
        if slope < 0:
            np.conjugate(row, out=row)
    return FieldValues(values, None)


def _field(u: float, v: Array) -> NDArray[np.complex128]:
    """Return U = C + iS for C_d = u/4 >= 0."""
    field = np.empty(v.size, dtype=np.complex128)
    shadow = v >= max(u, 1e-3)
    field[~shadow] = _near_focus(u, v[~shadow]) if u <= _NEAR_FOCUS else _geometric_image(u, v[~shadow])
    field[shadow] = _shadow(u, v[shadow])
    return field


def _from_u(u: float, u1: Array, u2: Array) -> NDArray[np.complex128]:
    """Return the field from ``U_1 / u`` and ``U_2 / u``."""
    c, s = math.cos(0.5 * u), math.sin(0.5 * u)
    return np.asarray(2.0 * ((c * u1 + s * u2) + 1j * (s * u1 - c * u2)))


def _shadow(u: float, v: Array) -> NDArray[np.complex128]:
    """Return the field for v >= u by U_1 and U_2, both divided by u."""
    field = np.empty(v.size, dtype=np.complex128)
    for block, u1, u2 in _sums(v, u / v, first=1):
        field[block] = _from_u(u, u1 / v[block], u2 / v[block])
    return field


def _geometric_image(u: float, v: Array) -> NDArray[np.complex128]:
    """Return the field for v < u by V_0 and V_1."""
    field = np.empty(v.size, dtype=np.complex128)
    c, s = math.cos(0.5 * u), math.sin(0.5 * u)
    for block, v0, v1 in _sums(v, v / u, first=0):
        edge = 0.5 * v[block] ** 2 / u
        field[block] = 2.0 / u * ((np.sin(edge) + s * v0 - c * v1) + 1j * (np.cos(edge) - c * v0 - s * v1))
    return field


def _near_focus(u: float, v: Array) -> NDArray[np.complex128]:
    """Return the field for v, u <= 1 by U_1 and U_2 without division by v."""
    sums = [np.zeros(v.size), np.zeros(v.size)]
    for m in range(1, 17):
        term = 0.5 * (0.5 * u) ** (m - 1) / math.factorial(m) * scipy.special.hyp0f1(m + 1, -0.25 * v * v)
        sums[(m + 1) % 2] += (-1.0) ** ((m - 1) // 2) * term
    return _from_u(u, sums[0], sums[1])


def _sums(v: Array, ratio: Array, first: int) -> Iterator[tuple[slice, Array, Array]]:
    """Yield slices of v, each with ``sum_s (-1)^s ratio^(n + 2s - first) J_{n+2s}(v)``, n = first and first + 1."""
    if not v.size:
        return
    largest_v = float(v.max())
    # J_n(v) is negligible for n beyond v + O(v^(1/3)), the width of the Airy transition (DLMF 10.19.8).
    count = int(largest_v + 12.0 * (largest_v + 1.0) ** (1.0 / 3.0)) + 40
    rows = max(1, _BLOCK // count)
    power = np.arange(count - first)
    sign = np.where(power // 2 % 2 == 0, 1.0, -1.0)
    for start in range(0, v.size, rows):
        block = slice(start, start + rows)
        with np.errstate(under="ignore"):
            weighted = sign * bessel_sequence(v[block], count)[:, first:] * ratio[block, None] ** power
        yield block, weighted[:, 0::2].sum(axis=1), weighted[:, 1::2].sum(axis=1)
