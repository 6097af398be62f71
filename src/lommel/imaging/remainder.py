r"""The light beyond the windows of a bank: a sum of few products of a function of defocus and one of place.

Beyond the shadow of the aperture a PSF hardly depends on defocus. So where a window does not reach, the PSF is,
closely, ``sum_r a_r(c) g_r(q)``; within, the window holds exactly the PSF less this sum, whatever that is there. The
g_r are values on pixels up to a `reach`, from alternating least squares in which every pixel counts only for those
defocus whose windows leave it out. Farther away they are sums of ``(r^2 + s^2)^(-3/2 - j)``, j = 0, 1, 2, the mean of
the tail of an aperture without its fine rings; these have Fourier transforms in closed form, and the light beyond the
reach, which is known, is held exactly. So is all light: the a_r are those of least error among those that lose none.

References
----------
K. R. Gabriel and S. Zamir, "Lower rank approximation of matrices by least squares with any choice of weights",
Technometrics 21, 489 (1979), doi:10.1080/00401706.1979.10489819.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base.arrays import Array
from lommel.imaging.defocus_nodes import DefocusNodes
from lommel.imaging.window_sizes import ring_shares
from lommel.methods.pixels.rule import cells_alike, octant, quarters

_GAP = 3.0  # pixels between the shadow of the aperture and the edges of windows, about
_MOST = 16  # products
_LOOSE = 1.2  # tolerances that products may be off together: one more costs a twentieth of a photograph
_TURNS = 4  # of the alternation: more change the error by less than one product more does
_SAMPLES = 4  # defocus that the products are found from, for each pixel that windows reach


def inner_energy(step: float) -> float:
    """Return the share of the light that windows hold if a remainder holds the rest, for pixels `step` in v wide.

    Of each of the two edges of a shadow there is a share of ``1 / (pi v)`` farther than v from it. So windows end
    about as many pixels from it, where the tail has become smooth enough for few products.
    """
    return float(np.clip(1.0 - 1.0 / (math.pi * _GAP * step), 0.98, 0.9975))


def reach_of(half: int, step: float) -> int:
    """Return how many pixels from the middle the remainder is known pixel by pixel, for windows up to `half`.

    Farther away its fine rings are left out, of which fine pixels see more, and know more at the same cost.
    """
    return max((3 * half) // 2 + 6, min(96, int(math.cbrt(7e6 / step**2))))


@dataclass(frozen=True)
class Remainder:
    """What lies beyond the windows of one channel.

    Attributes
    ----------
    knots : ndarray, shape (count, rank)
        The factors a_r at the windows of the bank; between these they follow the same cubics as the windows.
    spacing : float
        Defocus from window to window, radians.
    table : ndarray, shape (rank, reach + 1, reach + 1)
        The g_r less their smooth part, from the middle row down and the middle column on.
    smooth : ndarray, shape (rank, 3)
        Of ``s^(2 j) (r^2 + s^2)^(-3/2 - j)``, r in pixels.
    scale : float
        s, pixels.
    off : ndarray, shape (count - 3, near)
        The most that K is off where windows reach, on the first pixels of the octant: around each gap between windows
        in which defocus may lie, as checked at the windows and half-way between them.
    far : ndarray
        The same of the pixels after these up to the reach, of any defocus.
    rings, held : float
        Sums over all pixels beyond the reach, of any defocus: of the fine rings, which are left out there, estimated;
        and of the light, as it differs from what it should be.
    """

    knots: Array
    spacing: float
    table: Array
    smooth: Array
    scale: float
    off: NDArray[np.float32]
    far: Array
    rings: float
    held: float

    def error(self, positions: ArrayLike | None = None, shape: tuple[int, int] | None = None) -> float:
        """Return the sum of the most that K is off, over all pixels that points are from each other.

        Times the brightest point of a scene, it bounds what any pixel is off.

        Parameters
        ----------
        positions : array_like, optional
            As of :meth:`factors`: those of the points of a scene; by default all are possible.
        shape : (int, int), optional
            Height and width of an image with nothing beyond its edges; by default light comes from everywhere.

        Returns
        -------
        float
        """
        off = self.off
        if positions is not None:
            gaps = np.clip(np.asarray(positions).astype(np.int32).ravel() - 1, 0, len(off) - 1)
            off = off[np.flatnonzero(np.bincount(gaps))]
        reach = self.table.shape[1] - 1
        table = quarters(np.append(off.max(axis=0), self.far)[None], reach)[0]
        once = np.where(np.arange(reach + 1) == 0, 1.0, 2.0)
        height, width = (reach + 1, reach + 1) if shape is None else shape
        near = float(once[:height] @ table[:height, :width] @ once[:width])
        if shape is None:
            return near + self.rings + self.held
        if max(shape) - 1 <= reach:
            return near
        # Rings fall as the tail does: the integral of r^-3 outside of a rectangle of a by b is hypot(a, b) / a b.
        sides = height - 0.5, width - 0.5
        known = min(sides[0], reach + 0.5), min(sides[1], reach + 0.5)
        some, others, all_ = (math.hypot(a, b) / (a * b) for a, b in (known, sides, (reach + 0.5,) * 2))
        return near + self.rings * (some - others) / all_ + self.held

    @property
    def rank(self) -> int:
        """How many products there are."""
        return int(self.knots.shape[1])

    @property
    def sums(self) -> Array:
        """Sum of each g_r over all pixels, shape (rank,)."""
        once = np.where(np.arange(self.table.shape[1]) == 0, 1.0, 2.0)
        everywhere = self.smooth @ smooth_transforms(np.zeros(1), self.scale)[:, 0]
        return np.asarray(np.einsum("rij,i,j->r", self.table, once, once) + everywhere)

    def factors(self, positions: ArrayLike, dtype: DTypeLike = np.float64) -> NDArray[Any]:
        """Return the a_r.

        Parameters
        ----------
        positions : array_like
            Where defocus lies in the bank, as :meth:`lommel.imaging.bank.Bank.positions` has it.
        dtype : float32 or float64

        Returns
        -------
        ndarray, shape ``(rank, *positions.shape)``
        """
        return _between(self.knots, positions, 0, dtype)

    def slopes(self, positions: ArrayLike, dtype: DTypeLike = np.float64) -> NDArray[Any]:
        """Return the derivatives of the a_r by defocus, a radian.

        Parameters
        ----------
        positions : array_like
            As of :meth:`factors`.
        dtype : float32 or float64

        Returns
        -------
        ndarray, shape ``(rank, *positions.shape)``
        """
        return _between(self.knots / self.spacing, positions, 1, dtype)

    def values(self, half: int) -> Array:
        """Return the g_r from the middle row and column on, up to `half` pixels; shape (rank, half + 1, half + 1).

        Parameters
        ----------
        half : int
            May exceed the reach.

        Returns
        -------
        ndarray
        """
        away = np.arange(half + 1.0)
        made = np.tensordot(self.smooth, _smooth(away[:, None] ** 2 + away**2, self.scale), axes=1)
        known = min(half + 1, self.table.shape[1])
        made[:, :known, :known] += self.table[:, :known, :known]
        return np.asarray(made)


def fit(
    nodes: DefocusNodes,
    start: float,
    spacing: float,
    exact: Array,
    middle: Array,
    cuts: Array,
    reach: int,
    tol: float,
) -> tuple[Remainder, Array]:
    """Find the remainder of a bank.

    Parameters
    ----------
    nodes : DefocusNodes
        Of the octant up to `reach`.
    start, spacing : float
        Defocus of the first window, and from one to the next, radians.
    exact : ndarray, shape (count, cells)
        Windows, on the octant up to the largest of `cuts`.
    middle : ndarray, shape (count - 3, cells)
        The same half-way from the second window to the third, and so on.
    cuts : ndarray, shape (count,)
        How far the windows reach, as of a bank.
    reach : int
        Pixels.
    tol : float
        There are as many products as it takes for the most that PSFs are off beyond their windows to sum to little
        more than this, up to 16.

    Returns
    -------
    remainder : Remainder
    within : ndarray, shape (count, cells)
        What it holds of the octant: to be left out of the windows.
    """
    near, distance, alike = exact.shape[1], octant(reach)[0], cells_alike(reach)
    at = start + spacing * np.arange(len(exact), dtype=np.float64)
    some = np.linspace(0, len(exact) - 1, 32 + math.ceil(_SAMPLES * np.ptp(cuts))).astype(np.int64)
    some = np.unique(np.append(some, [cuts.argmin(), cuts.argmax()]))
    all_left = 1.0 - ring_shares(cuts, reach)
    shown, left = nodes.values(at[some]), all_left[some][:, distance]
    typical = np.maximum((left * shown).sum(axis=0), 1e-300) / np.maximum(left.sum(axis=0), 1e-300)
    weights: Array = alike / typical
    kernels, factors = _products(shown, left, weights, alike, _LOOSE * tol)
    # What is beyond the reach is like one more pixel, that no window holds.
    beyond = 1.0 - shown @ alike
    held = np.asarray(np.linalg.lstsq(factors, beyond, rcond=None)[0], dtype=np.float64)
    # Farther than any window reaches, sums over pixels are all that matters.
    first, last = kernels[:, :near], kernels[:, near:]
    rest = nodes.sums(last * weights[near:]).values(at)
    left = all_left[:, distance[:near]]
    knots = _all_light(
        _normal(left**2 * weights[:near], first) + (last * weights[near:]) @ last.T,
        (left**2 * weights[:near] * exact) @ first.T + rest,
        (left * alike[:near]) @ first.T + last @ alike[near:] + held,
        1.0 - ((1.0 - left) * exact) @ alike[:near],
    )
    begin = (3 * reach) // 4
    ring = distance > begin
    smooth, scale = _far(kernels, held, ring, alike, reach)
    column, row = octant(reach)
    squared = (column**2 + row**2).astype(np.float64)
    table = quarters(kernels - smooth @ _smooth(squared, scale), reach)
    # What is off is looked for at each window and half-way between them; far away, where all is smooth, at some.
    within, halfway = knots @ first, _halfway(knots)
    missed = left * (within - exact)
    between = np.abs(_halfway(exact + missed) - middle)
    np.abs(missed, out=missed)
    off = _of_neighbours(np.maximum(np.maximum(missed[1:-2], missed[2:-1]), between)).astype(np.float32)
    inner = some[(some > 0) & (some < len(at) - 2)]
    there = nodes.values(at[inner] + 0.5 * spacing)
    off_far = _largest(knots[some] @ last - shown[:, near:], halfway[inner - 1] @ last - there[:, near:])
    # Beyond the reach the misfit falls with r as the tail does, or faster: its sum is to that of a ring as 1 / reach
    # to 1 / begin - 1 / reach.
    misfit = knots[some] @ (smooth @ _smooth(squared[ring], scale)) - shown[:, ring]
    # Points so far away are of many defocus, whose rings differ: no one of them is the worst everywhere.
    rings = float((np.abs(misfit) @ alike[ring]).max()) * begin / (reach - begin)
    lacking = float(np.abs(knots[some] @ held - beyond).max())
    return Remainder(knots, spacing, table, smooth, scale, off, off_far, rings, lacking), within


def _of_neighbours(values: Array) -> Array:
    """Return the largest of each row, the one before and the one after."""
    padded = np.pad(values, ((1, 1), (0, 0)), mode="edge")
    return np.asarray(np.maximum(np.maximum(padded[:-2], padded[2:]), values))


def _largest(*wrong: Array) -> Array:
    """Return the most that each pixel is wrong by, of all defocus."""
    return np.asarray(np.max([np.abs(part).max(axis=0) for part in wrong if len(part)], axis=0))


def _products(shown: Array, left: Array, scales: Array, alike: Array, tol: float) -> tuple[Array, Array]:
    """Return the g_r on the octant, shape (rank, cells), and the a_r of these samples, shape (samples, rank)."""
    seen = left.max(axis=0) > 0.0
    values, parts, many = shown[:, seen], left[:, seen], alike[seen]
    weights = parts**2 * scales[seen]
    common = values[:, parts.min(axis=0) == 1.0] * np.sqrt(scales[seen][parts.min(axis=0) == 1.0])
    # Those of greatest weight come last.
    sizes, basis = np.linalg.eigh(common @ common.T)
    basis = basis[:, ::-1]
    most, factors = min(_MOST, len(shown)), basis[:, :0]
    for rank in range(1, most + 1):
        # A product that is left out is missed by little less than its size.
        if rank < most and sizes[-rank - 1] > (10.0 * tol) ** 2:
            factors = basis[:, :rank]
            continue
        factors = np.column_stack([factors, basis[:, rank - 1]])
        for _ in range(_TURNS):
            # Turn by turn the one is linear in the other.
            found = _solved(_normal(weights.T, factors.T, 1e-10), (weights * values).T @ factors).T
            factors = _solved(_normal(weights, found, 1e-14), (weights * values) @ found.T)
            wrong = float(np.abs((factors @ found - values) * parts).max(axis=0) @ many)
            if wrong <= tol:
                break
            factors = np.linalg.qr(factors)[0]
        if wrong <= tol:
            break
    kernels = np.zeros((rank, shown.shape[1]))
    kernels[:, seen] = found
    return kernels, factors


def _normal(weights: Array, basis: Array, ridge: float = 0.0) -> Array:
    """Return the normal matrix of each row of weights for a basis of shape (rank, n): shape (rows, rank, rank)."""
    rank = len(basis)
    normal = (weights @ (basis[:, None] * basis).reshape(rank * rank, -1).T).reshape(-1, rank, rank)
    normal += (ridge / rank) * np.trace(normal, axis1=1, axis2=2)[:, None, None] * np.eye(rank)
    return np.asarray(normal)


def _solved(normal: Array, right: Array) -> Array:
    return np.asarray(np.linalg.solve(normal, right[..., None])[..., 0])


def _all_light(normal: Array, right: Array, sums: Array, light: Array) -> Array:
    """Return the least squares of each row whose product with `sums` is `light`, by Lagrange's multiplier."""
    rank = sums.shape[1]
    normal = normal + (1e-14 / rank) * np.trace(normal, axis1=1, axis2=2)[:, None, None] * np.eye(rank)
    both = np.linalg.solve(normal, np.stack([right, sums], axis=-1))
    free, along = both[..., 0], both[..., 1]
    lacking = (light - (free * sums).sum(axis=1)) / (along * sums).sum(axis=1)
    return np.asarray(free + lacking[:, None] * along)


def _far(kernels: Array, held: Array, ring: NDArray[np.bool_], alike: Array, reach: int) -> tuple[Array, float]:
    """Return the smooth parts that are least off on a ring, of those that hold the light beyond the reach; and s."""
    scale = max(8.0, reach / 8.0)  # so large that sums over pixels are integrals
    first, second = octant(reach)
    smooth = _smooth((first**2 + second**2).astype(np.float64), scale)
    totals = smooth_transforms(np.zeros(1), scale)[:, 0] - smooth @ alike
    basis = smooth[:, ring]
    weighted = basis * (alike[ring] / basis[0] ** 2)
    # Least squares, and Lagrange's multiplier for the light.
    system = np.block([[weighted @ basis.T, totals[:, None]], [totals, np.zeros(1)]])
    found = np.linalg.solve(system, np.vstack([weighted @ kernels[:, ring].T, held]))
    return np.ascontiguousarray(found[:-1].T), scale


def _smooth(squared: Array, scale: float) -> Array:
    """Return ``s^(2 j) (r^2 + s^2)^(-3/2 - j)`` for j = 0, 1, 2, shape (3, ...)."""
    inverse = 1.0 / (squared + scale * scale)
    near = inverse * np.sqrt(inverse)
    inverse *= scale * scale
    return np.stack([near, near * inverse, near * inverse * inverse])


def smooth_transforms(frequency: Array, scale: float) -> Array:
    """Return the Fourier transforms of the smooth parts over the plane, shape (3, ...).

    Those of their values on pixels differ by less than ``exp(-pi s)`` of the largest: by all that is
    at a frequency of 1/2 and more.

    Parameters
    ----------
    frequency : ndarray
        Cycles a pixel, at most 1/2 in either direction.
    scale : float
        s, pixels.

    Returns
    -------
    ndarray
    """
    phase = (2.0 * math.pi * scale) * frequency
    near = (2.0 * math.pi / scale) * np.exp(-phase)
    return np.stack([near, near * (1.0 + phase) / 3.0, near * (3.0 + phase * (3.0 + phase)) / 15.0])


def _halfway(knots: Array) -> Array:
    return (9.0 * (knots[1:-2] + knots[2:-1]) - knots[:-3] - knots[3:]) / 16.0


def _between(knots: Array, positions: ArrayLike, order: int, dtype: DTypeLike) -> NDArray[Any]:
    """Return cubics through four windows each, or their derivatives by the position; shape (rank, ...)."""
    at = np.clip(np.asarray(positions, dtype=np.float64), 0.0, len(knots) - 1.0)
    first = np.clip(at.astype(np.int32) - 1, 0, len(knots) - 4)
    at = at - first
    weights = [weight.deriv(order)(at).astype(dtype) for weight in _lagrange()]
    rows = np.ascontiguousarray(knots.T, dtype=dtype)
    out = np.zeros((len(rows), *at.shape), dtype=dtype)
    for r, row in enumerate(rows):
        for j, weight in enumerate(weights):
            out[r, ...] += weight * row[j:][first]
    return out


@lru_cache(maxsize=1)
def _lagrange() -> list[Any]:
    """Return the cubics that are 1 at one of 0, 1, 2, 3 and 0 at the others."""
    from numpy.polynomial import Polynomial

    made = []
    for j in range(4):
        others = [k for k in range(4) if k != j]
        made.append(Polynomial.fromroots(others) / math.prod(j - k for k in others))
    return made
