"""Banks of pixel-integrated PSFs over defocus: windows to interpolate between, and a remainder of the light beyond.

References
----------
K. R. Gabriel and S. Zamir, "Lower rank approximation of matrices by least squares with any choice of weights",
Technometrics 21, 489 (1979), doi:10.1080/00401706.1979.10489819. S. A. Martucci, "Symmetric convolution and the
discrete sine and cosine transforms", IEEE Trans. Signal Process. 42, 1038 (1994), doi:10.1109/78.295213.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base.arrays import Array, Values
from lommel.core import engine
from lommel.imaging.sensor_light import (
    DefocusNodes,
    SensorLight,
    cut,
    find_cuts,
    of_neighbours,
    ring_shares,
    shares_used,
    sums_of_quarters,
)
from lommel.methods.pixel_rule import cells_alike, octant, quarters

_MAX_WINDOWS = 20_000
_MAX_VALUES = 2**27  # of a bank, 1 GiB in double precision
_GAPS = 12  # gaps between the windows tried first (doubled until at most a radian wide)


@dataclass(frozen=True, eq=False)
class Bank:
    """PSF windows of one channel, equally spaced in defocus.

    Attributes
    ----------
    start, spacing : float
        Defocus C_d of the first window, and its step between windows (radians at the wavelength of the lens).
    windows : ndarray, shape (count + 1, half + 1, stride)
        Fraction of the light of a point on each pixel, for the quadrant from the central row and column on; the other
        quadrants mirror it. Columns beyond the window, and the last window, are padding for the compiled core.
    cuts : ndarray, shape (count,)
        Half width in use of each window, a real number h: the ring at the Chebyshev distance k has the weight
        ``h + 1 - k``, clipped to 0 to 1 and averaged over the neighbours (1/6, 2/3, 1/6), so that the blur changes
        continuously as a point moves.
    energies : ndarray, shape (count,)
        Sum of each window; interpolated windows are divided by their sums. Ones with a remainder, where nothing is
        divided.
    lost : float
        Largest fraction of the light beyond the pixels in use, which is spread over these instead.
    error : float
        Largest difference found between interpolated and exact windows half-way between nodes, relative to the peak.
    remainder : Remainder, optional
        Light beyond the windows, for ``energy=1``; the windows then hold the PSF minus this.
    filled : ndarray, optional
        The remainder within the windows, stored like `windows`.
    """

    start: float
    spacing: float
    windows: Values
    cuts: Array
    energies: Array
    lost: float
    error: float
    remainder: Remainder | None = None
    filled: Values | None = None

    @property
    def count(self) -> int:
        """Number of windows."""
        return len(self.cuts)

    @property
    def half(self) -> int:
        """Half width of the largest window, pixels."""
        return int(self.windows.shape[1]) - 1

    @property
    def halves(self) -> NDArray[np.int64]:
        """Half width in use of each window, pixels, shape (count,)."""
        return of_neighbours(np.ceil(self.cuts)).astype(np.int64)

    @property
    def beyond(self) -> tuple[int, int]:
        """Rows and columns that the compiled core needs beyond the image, on either side."""
        return self.half, self.windows.shape[2]

    def positions(self, defocus: ArrayLike) -> Array:
        """Return the position in the bank of a `defocus` C_d in radians, 0 at the first window, 1 at the second."""
        positions = np.asarray(defocus, dtype=np.float64) - self.start
        positions /= self.spacing
        return positions

    def used(self, defocus: float) -> Array:
        """Return the weight of each pixel, about 0 to 1, at one `defocus` C_d (radians), shape (side, side)."""
        # Cubic interpolation over four windows, as the compiled core has it.
        first, weights = self._mixture(defocus)
        return self._spread_out(np.tensordot(weights, shares_used(self.cuts, self.half)[first : first + 4], axes=1))

    def window(self, defocus: float) -> Array:
        """Return the window that the compiled core interpolates at a `defocus` C_d in radians, shape (side, side)."""
        first, weights = self._mixture(defocus)
        made = self._spread_out(np.tensordot(weights, self.windows[first : first + 4].astype(np.float64), axes=1))
        return made / (weights @ self.energies[first : first + 4])

    def holding(self, kernels: Array, cuts: Array | None = None) -> Bank:
        """Return a bank of other `kernels` (count, side, side) that end at `cuts`, by default as here."""
        ends = self.cuts if cuts is None else cuts
        quarter = kernels[:, self.half :, self.half :] * shares_used(ends, self.half)
        windows, energies = stored_windows(quarter, self.windows.dtype), sums_of_quarters(quarter)
        return replace(self, windows=windows, cuts=ends, energies=energies)

    def apart(self) -> tuple[Bank, Bank]:
        """Return banks of the PSF within its windows, and of the remainder there."""
        assert self.filled is not None
        return replace(self, windows=self.windows + self.filled), replace(self, windows=self.filled)

    def _mixture(self, defocus: float) -> tuple[int, Array]:
        """Return the first of the four windows that one defocus is interpolated from, and their weights."""
        # Positions outside of the bank are clipped to its ends.
        position = float(np.clip(self.positions(defocus), 0.0, self.count - 1))
        interval = min(int(position), self.count - 2)
        first = min(max(interval - 1, 0), self.count - 4)
        # At either end the four are the outermost ones, which makes the interpolation one-sided there.
        t = position - first
        return first, np.array([math.prod((t - k) / (j - k) for k in range(4) if k != j) for j in range(4)])

    def _spread_out(self, quarter: Array) -> Array:
        """Return all quadrants of one that is stored."""
        away = np.abs(np.arange(-self.half, self.half + 1))
        return quarter[away[:, None], away]


def build_bank(
    light: SensorLight,
    defocus: tuple[float, float],
    *,
    tol: float,
    energy: float,
    largest: int,
    dtype: type[np.floating] | np.dtype[np.floating] = np.float32,
) -> Bank:
    """Return the bank of one channel over a range of C_d; ValueError if it would be too large."""
    low, high = defocus
    assert light.pupil.wavelength is not None
    # Shorter wavelengths have more radians of defocus: windows must resolve the fastest.
    per_radian = light.pupil.wavelength / min(wavelength for wavelength, _ in light.spectrum)
    whole = energy == 1.0
    step = math.pi * per_radian * light.pixel / light.pupil.scale
    inner = inner_energy(step) if whole else energy
    half, parabola = light.enough(defocus, inner, largest)
    reach = reach_of(half, step) if whole else half
    # One window beyond either end, so that every point lies in the middle gap of four.
    spacing = max((high - low) / _GAPS, 0.05)
    spacing *= 0.5 ** max(0, math.ceil(math.log2(spacing)))
    at = DefocusNodes.of(
        lambda nodes: light.shares(light.defocused(nodes), reach),
        low - spacing,
        high + 2.0 * spacing,
        parabola,
        rate=lambda reach: per_radian * (2.0 if light.rate is None else light.rate(reach)),
        bound=math.pi * (light.pixel * per_radian / light.pupil.scale) ** 2 / 4.0,
        threads=light.threads,
    )
    everywhere, at = at, at.of_first((half + 1) * (half + 2) // 2) if whole else at
    while True:
        count, side = max(1, math.ceil((high - low) / spacing)) + 3, 2 * half + 1
        if count > _MAX_WINDOWS or count * side * side > _MAX_VALUES:
            raise ValueError(
                f"a bank of {count} windows of {side} x {side} pixels, for C_d from {low:.4g} to {high:.4g} rad, "
                f"exceeds the limits of {_MAX_WINDOWS} windows and {_MAX_VALUES} values; ask for a larger tol "
                f"than {tol:g}"
            )
        start = low - spacing
        together, truncated = at(start + 0.5 * spacing * np.arange(2.0 * count - 1.0))
        exact = together[::2]
        error = _interpolation_error(exact, together[1::2]) + truncated
        if error <= tol:
            break
        # Cubic interpolation: the error falls sixteenfold where windows are twice as close, less far apart.
        spacing *= 0.5 ** max(1, math.ceil(math.log(error / tol, 16.0)))
    cuts = find_cuts(exact, half, inner + 1e-12)  # rounding must not leave less than requested
    if whole:
        used = math.ceil(cuts.max())
        cells = (used + 1) * (used + 2) // 2
        exact, middle = exact[:, :cells], together[3:-3:2, :cells]
        remainder, within = fit(everywhere, start, spacing, exact, middle, cuts, reach, tol)
        windows, filled = (stored_windows(cut(part, cuts), np.dtype(dtype)) for part in (exact - within, within))
        return Bank(start, spacing, windows, cuts, np.ones(count), 0.0, error, remainder, filled)
    quarter = cut(exact, cuts)
    energies = sums_of_quarters(quarter)
    # Sums are interpolated with the weights (-1, 9, 9, -1) / 16 of a cubic half-way.
    between = (9.0 * (energies[1:-2] + energies[2:-1]) - energies[:-3] - energies[3:]) / 16.0
    held = min(float(energies.min()), float(between.min()))
    return Bank(start, spacing, stored_windows(quarter, np.dtype(dtype)), cuts, energies, 1.0 - held, error)


def stored_windows(quarter: Array, dtype: np.dtype[np.floating]) -> Values:
    """Return windows, shape (count + 1, half + 1, stride), with the padding that the compiled core needs."""
    count, side, _ = quarter.shape
    shape = count + 1, side, ((side - 1) // 16 + 1) * 16
    # Rows begin at cache lines where the stride allows: vector loads are faster then.
    size = math.prod(shape) * dtype.itemsize
    room = np.zeros(size + 64, dtype=np.uint8)
    first = -room.ctypes.data % 64
    windows = room[first : first + size].view(dtype).reshape(shape)
    windows[:-1, :, :side] = quarter
    return windows


def _interpolation_error(exact: Array, middle: Array) -> float:
    """Return the largest error half-way between windows, over the peak there, without the first and last gap."""
    # (-1, 9, 9, -1) / 16, in place: the arrays are as large as the bank.
    off = exact[1:-2] + exact[2:-1]
    off *= 9.0
    off -= exact[:-3]
    off -= exact[3:]
    off /= 16.0
    inner = middle[1:-1]
    off -= inner
    return float((np.abs(off, out=off).max(axis=1) / inner.max(axis=1)).max())


_GAP = 3.0  # pixels between the shadow of the aperture and the edges of windows, about
_MOST = 16  # most products
_LOOSE = 1.2  # error of all products over the tolerance: one product more costs a twentieth of a photograph
_TURNS = 4  # alternations: further ones change the error by less than one product more does
_SAMPLES = 4  # values of defocus, per pixel of the windows, from which the products are found


def inner_energy(step: float) -> float:
    """Return the share of light held by windows that have a remainder, for pixels `step` in v wide."""
    # Encircled energy 1 - 2 / (pi v) of a disc, at about three pixels beyond the shadow.
    return float(np.clip(1.0 - 1.0 / (math.pi * _GAP * step), 0.98, 0.9975))


def reach_of(half: int, step: float) -> int:
    """Return the radius in pixels up to which the remainder is tabulated, for windows up to `half`."""
    return max((3 * half) // 2 + 6, min(96, int(math.cbrt(7e6 / step**2))))


# Beyond the shadow of the aperture a PSF hardly depends on defocus: it is nearly sum_r a_r(c) g_r(q) there; a window
# holds the exact PSF less this sum. The g_r are tabulated up to a reach, by alternating least squares in which a
# pixel counts only for those values of defocus whose windows exclude it. Farther out they are sums of
# (r^2 + s^2)^(-3/2 - j), j = 0, 1, 2, the mean tail of an aperture without its fine rings, with Fourier transforms in
# closed form; the light beyond the reach is known and held exactly. The a_r minimise the error under the condition
# that no light is lost (certificate, section 13).
@dataclass(frozen=True, eq=False)
class Remainder:
    """Light beyond the windows of one channel."""

    knots: Array  # (count, rank): a_r at the windows of the bank, interpolated by the same cubics
    table: Array  # (rank, reach + 1, reach + 1): g_r less the smooth part, from the middle row and column on
    smooth: Array  # (rank, 3): factors of s^(2 j) (r^2 + s^2)^(-3/2 - j), r in pixels
    scale: float  # s, pixels
    off: NDArray[np.float32]  # (count - 3, near): largest errors of K in each gap between windows
    far: Array  # largest errors of the further pixels up to the reach, at any defocus
    rings: float  # estimated sum of the fine rings beyond the reach, which are left out
    held: float  # largest error of the light beyond the reach

    def error(self, positions: ArrayLike | None = None, shape: tuple[int, int] | None = None) -> float:
        """Return the sum over pixels of the largest error of K at `positions`, within an image of `shape`."""
        off = self.off
        if positions is not None:
            gaps = np.clip(np.asarray(positions).astype(np.int32).ravel() - 1, 0, len(off) - 1)
            off = off[np.flatnonzero(np.bincount(gaps))]
        reach = self.table.shape[1] - 1
        table = quarters(np.append(off.max(axis=0), self.far)[None], reach)[0]
        # Each pixel of the quadrant stands for its mirror images, those on an axis once.
        once = np.where(np.arange(reach + 1) == 0, 1.0, 2.0)
        height, width = (reach + 1, reach + 1) if shape is None else shape
        near = float(once[:height] @ table[:height, :width] @ once[:width])
        if shape is None:
            return near + self.rings + self.held
        if max(shape) - 1 <= reach:
            return near
        # Rings fall as the tail does: the integral of r^-3 outside of an a by b rectangle is hypot(a, b) / (a b).
        sides = height - 0.5, width - 0.5
        known = min(sides[0], reach + 0.5), min(sides[1], reach + 0.5)
        some, others, all_ = (math.hypot(a, b) / (a * b) for a, b in (known, sides, (reach + 0.5,) * 2))
        return near + self.rings * (some - others) / all_ + self.held

    def factors(
        self, positions: ArrayLike, dtype: DTypeLike = np.float64, *, slopes: bool = False, threads: int = 1
    ) -> Values:
        """Return the a_r at positions in the bank, shape (rank, ...), or their derivatives by these."""
        cubics, rank = self._cubics, self.knots.shape[1]
        if slopes:
            cubics = np.concatenate([cubics[:, 1:] * np.arange(1.0, 4.0)[:, None], 0.0 * cubics[:, :1]], axis=1)
        padded = np.pad(cubics.astype(dtype), ((0, 0), (0, 0), (0, -rank % 16)))
        at = np.asarray(positions, dtype=np.float64)
        out = np.empty((rank, at.size), dtype=dtype)
        engine.remainder_factors(padded, np.ascontiguousarray(at).reshape(-1), threads, out)
        return out.reshape(rank, *at.shape)

    @cached_property
    def _cubics(self) -> Array:
        """Coefficients of the cubics through four knots, in the distance from the second, shape (gaps, 4, rank)."""
        powers = np.linalg.inv(np.vander(np.arange(-1.0, 3.0), increasing=True))
        four = np.lib.stride_tricks.sliding_window_view(self.knots, 4, axis=0)  # (gaps, rank, 4)
        return np.ascontiguousarray(np.moveaxis(four @ powers.T, 2, 1))

    def values(self, half: int) -> Array:
        """Return the g_r from the middle row and column on, up to `half` pixels, possibly beyond the reach."""
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
    """Return the remainder of a bank, and its part within the windows (count, cells), to be subtracted there."""
    near, distance, alike = exact.shape[1], octant(reach)[0], cells_alike(reach)
    at = start + spacing * np.arange(len(exact), dtype=np.float64)
    # The extremes of the reach are always among the samples: there pixels count for one defocus only.
    some = np.linspace(0, len(exact) - 1, 32 + math.ceil(_SAMPLES * np.ptp(cuts))).astype(np.int64)
    some = np.unique(np.append(some, [cuts.argmin(), cuts.argmax()]))
    all_left = 1.0 - ring_shares(cuts, reach)
    shown, left = nodes.values(at[some]), all_left[some][:, distance]
    # Errors count relative to the typical brightness of each pixel, which falls as r^-3.
    typical = np.maximum((left * shown).sum(axis=0), 1e-300) / np.maximum(left.sum(axis=0), 1e-300)
    weights: Array = alike / typical
    kernels, factors = _products(shown, left, weights, alike, _LOOSE * tol)
    # The light beyond the reach is treated as one more pixel, which no window holds.
    beyond = 1.0 - shown @ alike
    held = np.asarray(np.linalg.lstsq(factors, beyond, rcond=None)[0], dtype=np.float64)
    # Farther than any window reaches all pixels count, and sums over them replace the pixels.
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
    # Errors are evaluated at each window and half-way between; farther out, where all is smooth, at some.
    within, halfway = knots @ first, _halfway(knots)
    missed = left * (within - exact)
    between = np.abs(_halfway(exact + missed) - middle)
    np.abs(missed, out=missed)
    off = of_neighbours(np.maximum(np.maximum(missed[1:-2], missed[2:-1]), between)).astype(np.float32)
    inner = some[(some > 0) & (some < len(at) - 2)]
    there = nodes.values(at[inner] + 0.5 * spacing)
    wrong = np.vstack([knots[some] @ last - shown[:, near:], halfway[inner - 1] @ last - there[:, near:]])
    # Beyond the reach the misfit falls as the tail r^-3 or faster: its sum is to that of the ring as 1 / reach to
    # 1 / begin - 1 / reach (certificate, section 13).
    misfit = knots[some] @ (smooth @ _smooth(squared[ring], scale)) - shown[:, ring]
    # Rings of points with different defocus differ: no single misfit is the worst everywhere.
    rings = float((np.abs(misfit) @ alike[ring]).max()) * begin / (reach - begin)
    lacking = float(np.abs(knots[some] @ held - beyond).max())
    return Remainder(knots, table, smooth, scale, off, np.abs(wrong).max(axis=0), rings, lacking), within


def _products(shown: Array, left: Array, scales: Array, alike: Array, tol: float) -> tuple[Array, Array]:
    """Return the g_r on the octant, (rank, cells), and the a_r of the samples, (samples, rank)."""
    seen, far = left.max(axis=0) > 0.0, left.min(axis=0) == 1.0
    near = seen & ~far
    values, parts, scale = shown[:, near], left[:, near], scales[near]
    weights = parts**2 * scale
    # Pixels outside of all windows count for all samples alike: their Gram matrix replaces them.
    beyond = shown[:, far]
    common = beyond * np.sqrt(scales[far])
    gram = common @ common.T
    # Principal components of the far pixels, largest last, as the start of the alternation.
    sizes, basis = np.linalg.eigh(gram)
    basis = basis[:, ::-1]
    most, factors = min(_MOST, len(shown)), basis[:, :0]
    for rank in range(1, most + 1):
        # An omitted component is missed by little less than its size: below ten tolerances products suffice.
        if rank < most and sizes[-rank - 1] > (10.0 * tol) ** 2:
            factors = basis[:, :rank]
            continue
        factors = np.column_stack([factors, basis[:, rank - 1]])
        for _ in range(_TURNS):
            # Alternating least squares: each factor is linear given the other (Gabriel and Zamir).
            found = _solved(_normal(weights.T, factors.T, 1e-10), (weights * values).T @ factors).T
            onto = np.linalg.solve(_normal(np.ones((1, len(shown))), factors.T, 1e-10)[0], factors.T)
            factors = _solved(
                _normal(weights, found, 1e-14, onto @ gram @ onto.T),
                (weights * values) @ found.T + gram @ onto.T,
            )
            wrong = float(np.abs((factors @ found - values) * parts).max(axis=0) @ alike[near])
            wrong += float(np.abs((factors @ onto) @ beyond - beyond).max(axis=0) @ alike[far])
            if wrong <= tol:
                break
            factors = np.linalg.qr(factors)[0]
        if wrong <= tol:
            break
    kernels = np.zeros((rank, shown.shape[1]))
    kernels[:, near], kernels[:, far] = found, onto @ beyond
    return kernels, factors


def _normal(weights: Array, basis: Array, ridge: float = 0.0, more: Array | float = 0.0) -> Array:
    """Return the normal matrices, (rows, rank, rank), of rows of weights for a basis (rank, n), each plus `more`."""
    rank = len(basis)
    normal = (weights @ (basis[:, None] * basis).reshape(rank * rank, -1).T).reshape(-1, rank, rank) + more
    # A tiny ridge keeps the matrix invertible where products coincide.
    normal += (ridge / rank) * np.trace(normal, axis1=1, axis2=2)[:, None, None] * np.eye(rank)
    return np.asarray(normal)


def _solved(normal: Array, right: Array) -> Array:
    return np.asarray(np.linalg.solve(normal, right[..., None])[..., 0])


def _all_light(normal: Array, right: Array, sums: Array, light: Array) -> Array:
    """Return the least-squares solution of each row whose product with `sums` is `light` (Lagrange multiplier)."""
    rank = sums.shape[1]
    normal = normal + (1e-14 / rank) * np.trace(normal, axis1=1, axis2=2)[:, None, None] * np.eye(rank)
    both = np.linalg.solve(normal, np.stack([right, sums], axis=-1))
    free, along = both[..., 0], both[..., 1]
    lacking = (light - (free * sums).sum(axis=1)) / (along * sums).sum(axis=1)
    return np.asarray(free + lacking[:, None] * along)


def _far(kernels: Array, held: Array, ring: NDArray[np.bool_], alike: Array, reach: int) -> tuple[Array, float]:
    """Return the smooth parts with the least error on a ring that hold the light beyond the reach; and s."""
    scale = max(8.0, reach / 8.0)  # large enough that sums over pixels equal integrals (certificate, section 13)
    first, second = octant(reach)
    smooth = _smooth((first**2 + second**2).astype(np.float64), scale)
    totals = smooth_transforms(np.zeros(1), scale)[:, 0] - smooth @ alike
    basis = smooth[:, ring]
    weighted = basis * (alike[ring] / basis[0] ** 2)
    # Least squares with a Lagrange multiplier for the light.
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
    """Return the Fourier transforms of the smooth parts over the plane, at up to 1/2 cycle per pixel.

    Those of values on pixels differ by less than ``exp(-pi s)`` of the largest, except at frequencies near 1/2.
    """
    phase = (2.0 * math.pi * scale) * frequency
    near = (2.0 * math.pi / scale) * np.exp(-phase)
    return np.stack([near, near * (1.0 + phase) / 3.0, near * (3.0 + phase * (3.0 + phase)) / 15.0])


def _halfway(knots: Array) -> Array:
    return (9.0 * (knots[1:-2] + knots[2:-1]) - knots[:-3] - knots[3:]) / 16.0


_COPIES = 9.04  # sum of |k|^-3 over a square lattice without its origin: 9.0336


# For an image between two mirrors, half a pixel beyond its first and last pixel, convolution with an even kernel is
# diagonal in the discrete cosine transform of type II, however far the kernel reaches: it multiplies by
# sum_q g(q) cos(pi k q / n), the kernel's transform at the frequencies k / 2 n (Martucci 1994). Without mirrors the
# image is first continued: "extend" repeats the last pixels over half of height and width, and "zero" adds darkness
# wide enough that light from the mirrors is below half of the tolerance.
class MirroredKernels:
    """The g_r of a remainder as convolutions of images of one shape and border."""

    def __init__(
        self, remainder: Remainder, shape: tuple[int, int], border: str, dtype: np.dtype[np.floating], tol: float
    ) -> None:
        self.remainder, self.border, self.dtype, self.error = remainder, border, dtype, 0.0
        self._around = [(0, 0), (0, 0)]
        if border == "extend":
            self._around = [(max(1, side // 2),) * 2 for side in shape]
        elif border == "zero":
            from scipy.fft import next_fast_len

            tail = float(np.abs(remainder.knots @ remainder.smooth[:, 0]).max())
            light = _COPIES * math.prod(shape) * tail
            # A n 9.04 / (2 m)^3 <= tol / 2, solved for m: certificate, section 13, "Between mirrors".
            dark = max(math.ceil(0.5 * math.cbrt(light / (0.5 * tol))), remainder.table.shape[1])
            self._around = [(dark, next_fast_len(side + 2 * dark, real=True) - side - dark) for side in shape]
            self.error = light / (2.0 * dark) ** 3
        (top, _), (left, _) = self._around
        self._image = slice(top, top + shape[0]), slice(left, left + shape[1])
        self._sides = [side + sum(more) for side, more in zip(shape, self._around, strict=True)]

    @cached_property
    def eigenvalues(self) -> Values:
        """Transforms of the g_r, shape (rank, height, width) of the continued image; kept."""
        table, scale = self.remainder.table.astype(self.dtype), self.remainder.scale
        down, across = (_cosines(side, table.shape[1] - 1, self.dtype.char) for side in self._sides)
        made = down @ table @ across.T
        known = _smooth_spectra(*self._sides, scale, self.dtype.char)
        for each, parts in zip(made, self.remainder.smooth.astype(self.dtype), strict=True):
            for part, transform in zip(parts, known, strict=True):
                each += part * transform
        return np.asarray(made)

    def transformed(self, r: int, plane: Values) -> Values:
        """Return the transform of a plane convolved with g_r."""
        from scipy.fft import dctn

        if self.border != "reflect":
            plane = np.pad(plane, self._around, mode="edge" if self.border == "extend" else "constant")
        made = dctn(plane, overwrite_x=True)
        made *= self.eigenvalues[r]
        return np.asarray(made)

    def image(self, transform: Values, threads: int = 1) -> Values:
        """Return the image of a transform, without its continuation."""
        from scipy.fft import idctn

        return np.asarray(idctn(transform, overwrite_x=True, workers=threads)[self._image])

    def known(self, plane: Values, threads: int = 1) -> Values:
        """Return the transform of a plane surrounded by darkness: the transpose of :meth:`image` up to a scale."""
        from scipy.fft import dctn

        return np.asarray(dctn(np.pad(plane, self._around), workers=threads))

    def taken(self, r: int, known: Values) -> Values:
        """Return the transpose of :meth:`transformed` (up to that scale) applied to a transform."""
        from scipy.fft import idctn

        taken = idctn(self.eigenvalues[r] * known, overwrite_x=True)
        if self.border == "extend":
            # The transpose of repeating edges: what the copies collected is added to the edges.
            for lines, (before, after) in zip((taken, taken.T), self._around, strict=True):
                lines[before] += lines[:before].sum(axis=0)
                lines[-after - 1] += lines[-after:].sum(axis=0)
        return np.asarray(taken[self._image])


@lru_cache(maxsize=8)
def _cosines(side: int, reach: int, kind: str) -> Values:
    """Return the cosines of an even kernel, doubled where a value stands for two."""
    # Modulo a period: large arguments would lose digits in the cosine.
    turns = np.outer(np.arange(side), np.arange(reach + 1)) % (2 * side)
    made = 2.0 * np.cos((math.pi / side) * turns)
    made[:, 0] = 1.0
    made.flags.writeable = False
    return np.asarray(made.astype(kind))


@lru_cache(maxsize=4)
def _smooth_spectra(height: int, width: int, scale: float, kind: str) -> Values:
    """Return the transforms of the smooth parts, shape (3, height, width)."""
    down, across = ((np.arange(side) / (2.0 * side)).astype(kind) for side in (height, width))
    return smooth_transforms(np.hypot(down[:, None], across), scale)
