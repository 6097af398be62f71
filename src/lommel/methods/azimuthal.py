"""Pupils that are not radially symmetric, for the spectral engine: their terms, their axis, their images."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel import _core
from lommel.grid import Grid
from lommel.methods.averaging import Rendered
from lommel.methods.method import not_met
from lommel.pupil import Pupil
from lommel.special import zernike

_FARTHEST = 1e6  # pixels from the window to the axis
_BLOCK = 2**20  # values between two looks at the keyboard


class Terms(NamedTuple):
    """Zernike terms of a stack of phases on the aperture and, over its own radius, on the obscuration.

    Attributes
    ----------
    n, m : ndarray of int32, shape (terms,)
    outer, inner : ndarray, shape (n, terms)
        Coefficients in radians at the edge, the constant among them, which the two disks must share.
    rows, columns : ndarray of int64, shape (n,)
        The pixel on which the axis of each lies: whole pixels of tilt move the image instead.
    rounding : ndarray, shape (n,)
        Bound on the error of U from what rounding does to the place of the axis.
    """

    n: NDArray[np.int32]
    m: NDArray[np.int32]
    outer: NDArray[np.float64]
    inner: NDArray[np.float64]
    rows: NDArray[np.int64]
    columns: NDArray[np.int64]
    rounding: NDArray[np.float64]


def expand(pupil: Pupil, grid: Grid) -> Terms:
    """Return the terms of a stack, its tilt as a move of the axis."""
    wavefront = pupil.wavefront.flattened()
    powers = wavefront.coefficients
    piston = (powers @ zernike.powers_to_legendre(powers.shape[-1])[0]).astype(np.float64)
    found = {(0, 0): piston} | {term: c for term, c in wavefront.edge_terms().items() if np.any(c)}
    step, flat = grid.step(pupil), (len(powers),)
    axes, rounding = [], np.zeros(flat)
    for axis, term in ((0, (1, -1)), (1, (1, 1))):
        # A tilt of `step` radians moves the image by a pixel.
        given, tilt = grid.center[axis], np.broadcast_to(found.get(term, np.zeros(())), flat)
        with np.errstate(over="ignore"):
            at = given + tilt / step
        if not np.all(np.abs(at) <= _FARTHEST):
            far = at[~(np.abs(at) <= _FARTHEST)][0]
            raise ValueError(
                f"tilt and center put the axis at {('row', 'column')[axis]} {far:.3g}, more than the limit of "
                f"{_FARTHEST:.0e} pixels away"
            )
        axes.append(np.rint(at).astype(np.int64))
        if np.any(tilt):
            # Step, quotient and sum are rounded, relative to what may cancel; |dU/dv| < 1/2.
            rounding += 3.0 * 2.0**-53 * (np.abs(tilt) + abs(given) * step)
        rest = (at - axes[-1]) * step
        found.pop(term, None)
        if np.any(rest):
            found[term] = rest
    outer = {term: np.broadcast_to(c, flat) for term, c in found.items()}
    inner = zernike.scaled(outer, pupil.obscuration) if pupil.obscuration else outer
    terms = list(inner)
    zero = np.zeros(flat)
    n, m = (np.array([term[i] for term in terms], dtype=np.int32) for i in (0, 1))
    outermost, innermost = (
        np.ascontiguousarray(np.stack([c.get(t, zero) for t in terms], axis=-1)) for c in (outer, inner)
    )
    return Terms(n, m, outermost, innermost, axes[0], axes[1], rounding)


def phase_rounding(
    pupil: Pupil, peaks: NDArray[np.float64], further: NDArray[np.float64] | float = 0.0
) -> NDArray[np.float64]:
    """Bound, over the peak of I, what rounding does when powers of rho become Zernike terms; shape (n,).

    A wavefront keeps its radial part as powers, which cancel where their degree is high. An error of the phase
    reaches U undiminished at most, to which `further` errors of U are added, and I doubled over the root of the peak.
    """
    powers = pupil.coefficients()
    # No entry is negative.
    matrix = zernike.powers_to_legendre(powers.shape[1]).astype(np.float64)
    products = (powers.shape[1] + 3) * float(np.finfo(np.longdouble).eps) * (np.abs(powers) @ matrix.T)
    # What they add up to is rounded once more, to double precision.
    error = (products + 2.0**-50 * np.abs(powers @ matrix.T)).sum(axis=1) + further
    return np.asarray(error * (2.0 / np.sqrt(peaks) + error / peaks))


def render(
    pupil: Pupil,
    grid: Grid,
    scale: float | None,
    dtype: DTypeLike,
    tol: float,
    out: NDArray[Any] | None = None,
    threads: int = 0,
) -> Rendered:
    """Return images at the pixel centres.

    Raises
    ------
    ToleranceError
        If the bound stays above `tol`.
    """
    terms = expand(pupil, grid)
    count = len(terms.rows)
    values = np.empty((count, *grid.shape), dtype) if out is None else out
    scales, bounds, peaks = np.empty(count), np.empty(count), np.empty(count)
    block = max(1, _BLOCK // (grid.height * grid.width))
    left = tol
    while True:
        # The compiled core takes 0 for "divide by the largest value".
        scales.fill(0.0 if scale is None else scale)
        for first in range(0, count, block):
            part = slice(first, first + block)
            unmet = _core.render_zernike(
                terms.n,
                terms.m,
                terms.outer[part],
                terms.inner[part],
                pupil.obscuration,
                pupil.illumination.exponent,
                terms.rows[part],
                terms.columns[part],
                grid.step(pupil),
                left,
                threads,
                values[part],
                scales[part],
                bounds[part],
                peaks[part],
            )
            if unmet:
                raise not_met(tol, unmet, "the peak")
        added = (2.0 if scale is None else 1.0) * phase_rounding(pupil, peaks, terms.rounding)
        if (bounds + added).max() <= tol:
            return Rendered(values, scales, bounds + added, peaks)
        # Proven with nothing to spare: what is added is now known.
        left -= 1.1 * float(added.max())
        if left < 0.2 * tol:
            raise not_met(tol, float((bounds + added).max()), "the peak")
