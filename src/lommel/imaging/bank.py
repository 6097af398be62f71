"""Banks: tables of PSF windows over defocus, between which the compiled core interpolates.

A window is the pixel-integrated PSF on a square of pixels. A remainder is the light of the PSF outside its window. A
ring is the set of pixels at one Chebyshev distance from the centre. The reach is the half width, in pixels, of the
table of the remainder.

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
    neighbour_maxima,
    pixel_factors,
    ring_factors,
    sums_of_quarters,
)
from lommel.methods.pixel_rule import cells_alike, octant, quarters

_MAX_WINDOWS = 20_000
_MAX_VALUES = 2**27  # largest number of values in a bank: 1 GiB in double precision
_GAPS = 12  # initial number of gaps between windows; doubled until a gap is at most 1 rad wide


@dataclass(frozen=True, eq=False)
class Bank:
    """PSF windows of one channel, equally spaced in defocus.

    Attributes
    ----------
    start, spacing : float
        Defocus C_d of the first window, and the step of C_d between windows (rad at the wavelength of the lens).
    windows : ndarray, shape (count + 1, half + 1, stride)
        Fraction of the light of a point source on each pixel of one quadrant; row 0 and column 0 are the central row
        and column. The last window, and the columns after the first half + 1, are padding for the compiled core.
    cuts : ndarray, shape (count,)
        Half width h of each window, a real number of pixels. The ring at the Chebyshev distance k is multiplied by
        ``h + 1 - k``, clipped to [0, 1] and averaged over adjacent windows with the weights 1/6, 2/3, 1/6. The blur
        therefore changes continuously with defocus.
    energies : ndarray, shape (count,)
        Sum of each window. An interpolated window is divided by the interpolated sum. With a remainder windows are
        not divided, and `energies` are 1.
    lost : float
        Largest fraction of the light of a point outside its window; this light is spread over the window.
    error : float
        Largest difference between an interpolated and a computed window, half-way between two windows, plus the error
        bound of the computed window; relative to the peak of the window.
    remainder : Remainder, optional
        Light outside the windows, for ``energy=1``; `windows` then hold the PSF minus the remainder.
    remainder_windows : ndarray, optional
        Values of the remainder on the pixels of the windows, in the layout of `windows`.
    """

    start: float
    spacing: float
    windows: Values
    cuts: Array
    energies: Array
    lost: float
    error: float
    remainder: Remainder | None = None
    remainder_windows: Values | None = None

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
        """Half width of each window and its two neighbours, rounded up to whole pixels, shape (count,)."""
        return neighbour_maxima(np.ceil(self.cuts)).astype(np.int64)

    @property
    def beyond(self) -> tuple[int, int]:
        """Margin that the compiled core needs around an image: rows above and below, columns left and right."""
        return self.half, self.windows.shape[2]

    def positions(self, defocus: ArrayLike) -> Array:
        """Return the positions in the bank of defocus values C_d (rad): 0 at the first window, 1 at the second."""
        positions = np.asarray(defocus, dtype=np.float64) - self.start
        positions /= self.spacing
        return positions

    def pixel_weights(self, defocus: float) -> Array:
        """Return the truncation factor of each pixel, about 0 to 1, at a `defocus` C_d (rad), shape (side, side)."""
        # Cubic interpolation from four windows, as in the compiled core.
        first, weights = self._mixture(defocus)
        return self._mirror(np.tensordot(weights, pixel_factors(self.cuts, self.half)[first : first + 4], axes=1))

    def window(self, defocus: float) -> Array:
        """Return the window that the compiled core interpolates at one `defocus` C_d (rad), shape (side, side)."""
        first, weights = self._mixture(defocus)
        quarter = np.tensordot(weights, self.windows[first : first + 4].astype(np.float64), axes=1)
        return self._mirror(quarter) / (weights @ self.energies[first : first + 4])

    def with_kernels(self, kernels: Array, cuts: Array | None = None) -> Bank:
        """Return a bank of other `kernels` (count, side, side), truncated to `cuts`, by default ``self.cuts``."""
        ends = self.cuts if cuts is None else cuts
        quarter = kernels[:, self.half :, self.half :] * pixel_factors(ends, self.half)
        windows, energies = stored_windows(quarter, self.windows.dtype), sums_of_quarters(quarter)
        return replace(self, windows=windows, cuts=ends, energies=energies)

    def split(self) -> tuple[Bank, Bank]:
        """Return two banks: the whole PSF on the pixels of its windows, and the remainder on these pixels."""
        assert self.remainder_windows is not None
        remainder = self.remainder_windows
        return replace(self, windows=self.windows + remainder), replace(self, windows=remainder)

    def _mixture(self, defocus: float) -> tuple[int, Array]:
        """Return the index of the first of four consecutive windows, and their weights in the interpolation."""
        # Positions outside the bank are clipped to its first or last window.
        position = float(np.clip(self.positions(defocus), 0.0, self.count - 1))
        interval = min(int(position), self.count - 2)
        first = min(max(interval - 1, 0), self.count - 4)
        # Near an end of the bank the four outermost windows are used, and the interpolation is one-sided.
        t = position - first
        return first, np.array([math.prod((t - k) / (j - k) for k in range(4) if k != j) for j in range(4)])

    def _mirror(self, quarter: Array) -> Array:
        """Return the whole window whose lower right quadrant is `quarter`."""
        distance = np.abs(np.arange(-self.half, self.half + 1))
        return quarter[distance[:, None], distance]


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
    # The shortest wavelength has the largest defocus in radians: the windows must resolve it.
    per_radian = light.pupil.wavelength / min(wavelength for wavelength, _ in light.spectrum)
    with_remainder = energy == 1.0
    step = math.pi * per_radian * light.pixel / light.pupil.scale
    inner = inner_energy(step) if with_remainder else energy
    half, parabola = light.sufficient_half(defocus, inner, largest)
    reach = reach_of(half, step) if with_remainder else half
    # The bank extends beyond the range on both sides: every point then lies between the inner two of four windows.
    spacing = max((high - low) / _GAPS, 0.05)
    spacing *= 0.5 ** max(0, math.ceil(math.log2(spacing)))
    interpolation = DefocusNodes.of(
        lambda nodes: light.shares(light.defocused(nodes), reach),
        low - spacing,
        high + 2.0 * spacing,
        parabola,
        rate=lambda reach: per_radian * (2.0 if light.rate is None else light.rate(reach)),
        bound=math.pi * (light.pixel * per_radian / light.pupil.scale) ** 2 / 4.0,
        threads=light.threads,
    )
    all_nodes = interpolation
    if with_remainder:
        interpolation = interpolation.first_cells((half + 1) * (half + 2) // 2)
    while True:
        count, side = max(1, math.ceil((high - low) / spacing)) + 3, 2 * half + 1
        if count > _MAX_WINDOWS or count * side * side > _MAX_VALUES:
            raise ValueError(
                f"a bank of {count} windows of {side} x {side} pixels, for C_d from {low:.4g} to {high:.4g} rad, "
                f"exceeds the limits of {_MAX_WINDOWS} windows and {_MAX_VALUES} values; choose a larger tol "
                f"than {tol:g}"
            )
        start = low - spacing
        all_windows, truncated = interpolation(start + 0.5 * spacing * np.arange(2.0 * count - 1.0))
        exact = all_windows[::2]
        error = _interpolation_error(exact, all_windows[1::2]) + truncated
        if error <= tol:
            break
        # Cubic interpolation: halving a small spacing divides the error by 16; halving a large one, by less.
        spacing *= 0.5 ** max(1, math.ceil(math.log(error / tol, 16.0)))
    cuts = find_cuts(exact, half, inner + 1e-12)  # despite rounding, windows hold at least the energy requested
    if with_remainder:
        max_half = math.ceil(cuts.max())
        cells = (max_half + 1) * (max_half + 2) // 2
        exact, middle = exact[:, :cells], all_windows[3:-3:2, :cells]
        remainder, inside = fit(all_nodes, start, spacing, exact, middle, cuts, reach, tol)
        windows, stored = (stored_windows(cut(part, cuts), np.dtype(dtype)) for part in (exact - inside, inside))
        return Bank(start, spacing, windows, cuts, np.ones(count), 0.0, error, remainder, stored)
    quarter = cut(exact, cuts)
    energies = sums_of_quarters(quarter)
    # The weights (-1, 9, 9, -1) / 16 interpolate the sums half-way between two windows by a cubic.
    middle_sums = (9.0 * (energies[1:-2] + energies[2:-1]) - energies[:-3] - energies[3:]) / 16.0
    least_sum = min(float(energies.min()), float(middle_sums.min()))
    return Bank(start, spacing, stored_windows(quarter, np.dtype(dtype)), cuts, energies, 1.0 - least_sum, error)


def stored_windows(quarter: Array, dtype: np.dtype[np.floating]) -> Values:
    """Return windows, shape (count + 1, half + 1, stride), with the padding that the compiled core needs."""
    count, side, _ = quarter.shape
    shape = count + 1, side, ((side - 1) // 16 + 1) * 16
    # Rows begin at cache lines where the stride allows it, for faster vector loads.
    size = math.prod(shape) * dtype.itemsize
    room = np.zeros(size + 64, dtype=np.uint8)
    offset = -room.ctypes.data % 64
    windows = room[offset : offset + size].view(dtype).reshape(shape)
    windows[:-1, :, :side] = quarter
    return windows


def _interpolation_error(exact: Array, middle: Array) -> float:
    """Return the largest (interpolation error / peak), half-way in every gap except the first and the last one."""
    # Weights (-1, 9, 9, -1) / 16, applied in place: the arrays are as large as the bank.
    error = exact[1:-2] + exact[2:-1]
    error *= 9.0
    error -= exact[:-3]
    error -= exact[3:]
    error /= 16.0
    inner = middle[1:-1]
    error -= inner
    return float((np.abs(error, out=error).max(axis=1) / inner.max(axis=1)).max())


_GAP = 3.0  # approximate distance, in pixels, from the geometric shadow of the aperture to the edge of a window
_MAX_RANK = 16  # largest number of products a_r g_r
_TOLERANCE_RATIO = 1.2  # error allowed for the products / tol; each product adds 5 % to the time of a photograph
_ITERATIONS = 4  # iterations of alternating least squares; a fifth one reduces the error less than another product
_SAMPLES = 4  # defocus values used in the fit, for each pixel of difference between the half widths of windows


def inner_energy(step: float) -> float:
    """Return the fraction of light in the windows of a bank with a remainder; `step` is the pixel pitch in v."""
    # The light farther than v = _GAP * step outside the shadow is of the order of 1 / (pi v).
    return float(np.clip(1.0 - 1.0 / (math.pi * _GAP * step), 0.98, 0.9975))


def reach_of(half: int, step: float) -> int:
    """Return the reach (radius of the remainder's table, pixels) for windows of half width up to `half`."""
    return max((3 * half) // 2 + 6, min(96, int(math.cbrt(7e6 / step**2))))


# Outside the geometric shadow of the aperture a PSF hardly depends on defocus: it is nearly sum_r a_r(c) g_r(q) at
# the defocus c and the pixel q. A window holds the exact PSF minus this sum. Alternating least squares yield the g_r
# up to the reach; a pixel counts only at defocus values whose windows exclude it. Beyond the reach each g_r is a sum
# of (r^2 + s^2)^(-3/2 - j), j = 0, 1, 2, with Fourier transforms in closed form. This sum describes the mean tail of
# an aperture without its fine diffraction rings, and has the total light of g_r beyond the reach. The a_r minimise
# the error under the condition that no light is lost (certificate, section 13).
@dataclass(frozen=True, eq=False)
class Remainder:
    """Light outside the windows of one channel, as the sum of products a_r g_r."""

    knots: Array  # (count, rank): a_r at the defocus of each window, interpolated by the cubics of the windows
    table: Array  # (rank, reach + 1, reach + 1): g_r minus its smooth part; one quadrant, from its centre on
    smooth: Array  # (rank, 3): coefficients of s^(2 j) (r^2 + s^2)^(-3/2 - j), r in pixels
    scale: float  # s, pixels
    gap_errors: NDArray[np.float32]  # (count - 3, cells): largest error of K in each gap, on pixels inside windows
    far_errors: Array  # largest error of K, at any defocus, on each pixel between the largest window and the reach
    ring_error: float  # estimated sum over pixels of the fine diffraction rings beyond the reach, which are omitted
    tail_error: float  # largest error of the total light beyond the reach

    def error(self, positions: ArrayLike | None = None, shape: tuple[int, int] | None = None) -> float:
        """Return the sum over pixels of the largest error of K at `positions`, within an image of `shape`."""
        errors = self.gap_errors
        if positions is not None:
            gaps = np.clip(np.asarray(positions).astype(np.int32).ravel() - 1, 0, len(errors) - 1)
            errors = errors[np.flatnonzero(np.bincount(gaps))]
        reach = self.table.shape[1] - 1
        table = quarters(np.append(errors.max(axis=0), self.far_errors)[None], reach)[0]
        # A row or column of the quadrant counts for its mirror image as well, unless it is the central one.
        multiplicity = np.where(np.arange(reach + 1) == 0, 1.0, 2.0)
        height, width = (reach + 1, reach + 1) if shape is None else shape
        tabulated_error = float(multiplicity[:height] @ table[:height, :width] @ multiplicity[:width])
        if shape is None:
            return tabulated_error + self.ring_error + self.tail_error
        if max(shape) - 1 <= reach:
            return tabulated_error
        # The diffraction rings fall like r^-3, whose integral over the part of a quadrant outside an a by b rectangle
        # is hypot(a, b) / (a b).
        sides = height - 0.5, width - 0.5
        tabulated = min(sides[0], reach + 0.5), min(sides[1], reach + 0.5)
        begin, end, full_tail = (math.hypot(a, b) / (a * b) for a, b in (tabulated, sides, (reach + 0.5,) * 2))
        return tabulated_error + self.ring_error * (begin - end) / full_tail + self.tail_error

    def factors(
        self, positions: ArrayLike, dtype: DTypeLike = np.float64, *, slopes: bool = False, threads: int = 1
    ) -> Values:
        """Return the a_r at positions in the bank, shape (rank, ...); with `slopes` da_r / dposition."""
        cubics, rank = self._cubics, self.knots.shape[1]
        if slopes:
            cubics = np.concatenate([cubics[:, 1:] * np.arange(1.0, 4.0)[:, None], 0.0 * cubics[:, :1]], axis=1)
        padded = np.pad(cubics.astype(dtype), ((0, 0), (0, 0), (0, -rank % 16)))
        points = np.asarray(positions, dtype=np.float64)
        out = np.empty((rank, points.size), dtype=dtype)
        engine.remainder_factors(padded, np.ascontiguousarray(points).reshape(-1), threads, out)
        return out.reshape(rank, *points.shape)

    @cached_property
    def _cubics(self) -> Array:
        """Coefficients (gaps, 4, rank) of cubics through four knots, in powers of the distance from the second."""
        powers = np.linalg.inv(np.vander(np.arange(-1.0, 3.0), increasing=True))
        quadruples = np.lib.stride_tricks.sliding_window_view(self.knots, 4, axis=0)  # (gaps, rank, 4)
        return np.ascontiguousarray(np.moveaxis(quadruples @ powers.T, 2, 1))

    def values(self, half: int) -> Array:
        """Return a quadrant of each g_r, (rank, half + 1, half + 1); `half` may exceed the reach."""
        distance = np.arange(half + 1.0)
        quadrants = np.tensordot(self.smooth, _smooth(distance[:, None] ** 2 + distance**2, self.scale), axes=1)
        side = min(half + 1, self.table.shape[1])
        quadrants[:, :side, :side] += self.table[:, :side, :side]
        return np.asarray(quadrants)


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
    """Return the remainder of a bank, and its values on the pixels of the windows, (count, cells)."""
    # PSFs are arrays over one octant of pixels (cells); `multiplicity` is the number of pixels of each cell.
    cells, distance, multiplicity = exact.shape[1], octant(reach)[0], cells_alike(reach)
    defocus = start + spacing * np.arange(len(exact), dtype=np.float64)
    # Samples include the smallest and the largest window: some pixels lie outside the smallest window only.
    samples = np.linspace(0, len(exact) - 1, 32 + math.ceil(_SAMPLES * np.ptp(cuts))).astype(np.int64)
    samples = np.unique(np.append(samples, [cuts.argmin(), cuts.argmax()]))
    factors_outside = 1.0 - ring_factors(cuts, reach)
    psfs, outside = nodes.values(defocus[samples]), factors_outside[samples][:, distance]
    # Errors are weighted by 1 / typical brightness of each pixel, which falls like r^-3.
    typical = np.maximum((outside * psfs).sum(axis=0), 1e-300) / np.maximum(outside.sum(axis=0), 1e-300)
    weights: Array = multiplicity / typical
    kernels, factors = _fit_products(psfs, outside, weights, multiplicity, _TOLERANCE_RATIO * tol)
    # The total light beyond the reach is fitted like the light of one more pixel, outside all windows.
    beyond = 1.0 - psfs @ multiplicity
    far_light = np.asarray(np.linalg.lstsq(factors, beyond, rcond=None)[0], dtype=np.float64)
    # Outside the largest window every pixel counts at every defocus: sums over these pixels suffice.
    g_inner, g_outer = kernels[:, :cells], kernels[:, cells:]
    outer_products = nodes.sums(g_outer * weights[cells:]).values(defocus)
    outside = factors_outside[:, distance[:cells]]
    knots = _conserve_light(
        _normal_matrices(outside**2 * weights[:cells], g_inner) + (g_outer * weights[cells:]) @ g_outer.T,
        (outside**2 * weights[:cells] * exact) @ g_inner.T + outer_products,
        (outside * multiplicity[:cells]) @ g_inner.T + g_outer @ multiplicity[cells:] + far_light,
        1.0 - ((1.0 - outside) * exact) @ multiplicity[:cells],
    )
    begin = (3 * reach) // 4
    outer_ring = distance > begin
    smooth, scale = _fit_tail(kernels, far_light, outer_ring, multiplicity, reach)
    column, row = octant(reach)
    squared = (column**2 + row**2).astype(np.float64)
    table = quarters(kernels - smooth @ _smooth(squared, scale), reach)
    # Errors are evaluated at each window and half-way between windows; outside the largest window, at the samples.
    within, halfway = knots @ g_inner, _halfway(knots)
    errors = outside * (within - exact)
    between = np.abs(_halfway(exact + errors) - middle)
    np.abs(errors, out=errors)
    gap_errors = neighbour_maxima(np.maximum(np.maximum(errors[1:-2], errors[2:-1]), between)).astype(np.float32)
    inner = samples[(samples > 0) & (samples < len(defocus) - 2)]
    far_midway = nodes.values(defocus[inner] + 0.5 * spacing)[:, cells:]
    far_errors = np.vstack([knots[samples] @ g_outer - psfs[:, cells:], halfway[inner - 1] @ g_outer - far_midway])
    # The outer ring begins at the radius `begin`. Beyond the reach the misfit falls like r^-3 or faster, and (sum
    # beyond the reach) / (sum over the ring) = (1 / reach) / (1 / begin - 1 / reach) (certificate, section 13).
    misfit = knots[samples] @ (smooth @ _smooth(squared[outer_ring], scale)) - psfs[:, outer_ring]
    # The largest of the sums over pixels, not the sum of the largest misfits: diffraction rings vary with defocus.
    ring_error = float((np.abs(misfit) @ multiplicity[outer_ring]).max()) * begin / (reach - begin)
    tail_error = float(np.abs(knots[samples] @ far_light - beyond).max())
    far_error = np.abs(far_errors).max(axis=0)
    return Remainder(knots, table, smooth, scale, gap_errors, far_error, ring_error, tail_error), within


def _fit_products(psfs: Array, outside: Array, scales: Array, multiplicity: Array, tol: float) -> tuple[Array, Array]:
    """Return the g_r on the octant, (rank, cells), and the a_r at the sampled defocus values, (samples, rank)."""
    counted, everywhere = outside.max(axis=0) > 0.0, outside.min(axis=0) == 1.0
    partly = counted & ~everywhere
    values, parts, scale = psfs[:, partly], outside[:, partly], scales[partly]
    weights = parts**2 * scale
    # Pixels outside all windows have equal weights in all samples: their Gram matrix replaces them.
    far_psfs = psfs[:, everywhere]
    common = far_psfs * np.sqrt(scales[everywhere])
    gram = common @ common.T
    # The alternation starts from the principal components of the far pixels; `eigh` sorts them in ascending order.
    sizes, basis = np.linalg.eigh(gram)
    basis = basis[:, ::-1]
    max_rank, factors = min(_MAX_RANK, len(psfs)), basis[:, :0]
    for rank in range(1, max_rank + 1):
        # Ranks whose largest omitted component exceeds 10 tol cannot reach tol: they are skipped.
        if rank < max_rank and sizes[-rank - 1] > (10.0 * tol) ** 2:
            factors = basis[:, :rank]
            continue
        factors = np.column_stack([factors, basis[:, rank - 1]])
        for _ in range(_ITERATIONS):
            # Alternating least squares (Gabriel and Zamir): for fixed a_r, linear in the g_r, and conversely.
            found = _solve_rows(_normal_matrices(weights.T, factors.T, 1e-10), (weights * values).T @ factors).T
            dual = np.linalg.solve(_normal_matrices(np.ones((1, len(psfs))), factors.T, 1e-10)[0], factors.T)
            factors = _solve_rows(
                _normal_matrices(weights, found, 1e-14, dual @ gram @ dual.T),
                (weights * values) @ found.T + gram @ dual.T,
            )
            error = float(np.abs((factors @ found - values) * parts).max(axis=0) @ multiplicity[partly])
            error += float(np.abs((factors @ dual) @ far_psfs - far_psfs).max(axis=0) @ multiplicity[everywhere])
            if error <= tol:
                break
            factors = np.linalg.qr(factors)[0]
        if error <= tol:
            break
    kernels = np.zeros((rank, psfs.shape[1]))
    kernels[:, partly], kernels[:, everywhere] = found, dual @ far_psfs
    return kernels, factors


def _normal_matrices(weights: Array, basis: Array, ridge: float = 0.0, constant: Array | float = 0.0) -> Array:
    """Return ``basis @ diag(w) @ basis.T + constant`` for each row w of `weights`, shape (rows, rank, rank)."""
    rank = len(basis)
    normal = (weights @ (basis[:, None] * basis).reshape(rank * rank, -1).T).reshape(-1, rank, rank) + constant
    # A tiny ridge keeps the matrix invertible where rows of the basis coincide.
    normal += (ridge / rank) * np.trace(normal, axis1=1, axis2=2)[:, None, None] * np.eye(rank)
    return np.asarray(normal)


def _solve_rows(normal: Array, right_sides: Array) -> Array:
    return np.asarray(np.linalg.solve(normal, right_sides[..., None])[..., 0])


def _conserve_light(normal: Array, right_sides: Array, sums: Array, totals: Array) -> Array:
    """Return for each row the least-squares solution x with ``x @ sums = totals``, by a Lagrange multiplier."""
    rank = sums.shape[1]
    normal = normal + (1e-14 / rank) * np.trace(normal, axis1=1, axis2=2)[:, None, None] * np.eye(rank)
    solutions = np.linalg.solve(normal, np.stack([right_sides, sums], axis=-1))
    unconstrained, correction = solutions[..., 0], solutions[..., 1]
    multiplier = (totals - (unconstrained * sums).sum(axis=1)) / (correction * sums).sum(axis=1)
    return np.asarray(unconstrained + multiplier[:, None] * correction)


def _fit_tail(kernels: Array, total: Array, ring: NDArray[np.bool_], cells: Array, reach: int) -> tuple[Array, float]:
    """Return the smooth coefficients with least error on `ring` and the light `total` beyond the reach; and s."""
    scale = max(8.0, reach / 8.0)  # so large that sums over pixels equal integrals (certificate, section 13)
    column, row = octant(reach)
    smooth = _smooth((column**2 + row**2).astype(np.float64), scale)
    totals = smooth_transforms(np.zeros(1), scale)[:, 0] - smooth @ cells
    basis = smooth[:, ring]
    weighted = basis * (cells[ring] / basis[0] ** 2)
    # Least squares with a Lagrange multiplier for the total light.
    system = np.block([[weighted @ basis.T, totals[:, None]], [totals, np.zeros(1)]])
    solution = np.linalg.solve(system, np.vstack([weighted @ kernels[:, ring].T, total]))
    return np.ascontiguousarray(solution[:-1].T), scale


def _smooth(squared: Array, scale: float) -> Array:
    """Return ``s^(2 j) (r^2 + s^2)^(-3/2 - j)`` for j = 0, 1, 2, shape (3, ...)."""
    inverse = 1.0 / (squared + scale * scale)
    base = inverse * np.sqrt(inverse)
    inverse *= scale * scale
    return np.stack([base, base * inverse, base * inverse * inverse])


def smooth_transforms(frequency: Array, scale: float) -> Array:
    """Return the 2-D Fourier transforms of the three smooth terms at a `frequency` up to 1/2 cycle per pixel.

    Transforms of their samples differ by less than ``exp(-pi s)`` of the largest, except at frequencies near 1/2.
    """
    phase = (2.0 * math.pi * scale) * frequency
    base = (2.0 * math.pi / scale) * np.exp(-phase)
    return np.stack([base, base * (1.0 + phase) / 3.0, base * (3.0 + phase * (3.0 + phase)) / 15.0])


def _halfway(knots: Array) -> Array:
    return (9.0 * (knots[1:-2] + knots[2:-1]) - knots[:-3] - knots[3:]) / 16.0


_LATTICE_SUM = 9.04  # at least the sum of abs(k)^-3 over all points k != 0 of the square lattice, 9.0336


# For an image that is mirrored half a pixel outside its first and last pixel, the discrete cosine transform of type
# II diagonalises convolution with an even kernel of any width. The eigenvalue of the index k is
# sum_q g(q) cos(pi k q / n), the kernel's transform at the frequency k / (2 n) (Martucci 1994). For the other borders
# the image is first padded: for "extend" with copies of its edges over half of height and width on each side, for
# "zero" with so many dark pixels that the light from mirror images is below half of the tolerance.
class MirroredKernels:
    """Convolutions with the g_r of a remainder, for images of one shape and border."""

    def __init__(
        self, remainder: Remainder, shape: tuple[int, int], border: str, dtype: np.dtype[np.floating], tol: float
    ) -> None:
        self.remainder, self.border, self.dtype, self.error = remainder, border, dtype, 0.0
        self._around = [(0, 0), (0, 0)]
        if border == "extend":
            self._around = [(max(1, side // 2),) * 2 for side in shape]
        elif border == "zero":
            from scipy.fft import next_fast_len

            amplitude = float(np.abs(remainder.knots @ remainder.smooth[:, 0]).max())
            light = _LATTICE_SUM * math.prod(shape) * amplitude
            # The margin m solves A n 9.04 / (2 m)^3 = tol / 2: certificate, section 13, "Between mirrors".
            margin = max(math.ceil(0.5 * math.cbrt(light / (0.5 * tol))), remainder.table.shape[1])
            self._around = [(margin, next_fast_len(side + 2 * margin, real=True) - side - margin) for side in shape]
            self.error = light / (2.0 * margin) ** 3
        (top, _), (left, _) = self._around
        self._image = slice(top, top + shape[0]), slice(left, left + shape[1])
        self._sides = [side + sum(margins) for side, margins in zip(shape, self._around, strict=True)]

    @cached_property
    def eigenvalues(self) -> Values:
        """Transforms of the g_r, shape (rank, height, width) of the padded image; cached."""
        table, scale = self.remainder.table.astype(self.dtype), self.remainder.scale
        rows, columns = (_cosines(side, table.shape[1] - 1, self.dtype.char) for side in self._sides)
        eigenvalues = rows @ table @ columns.T
        smooth_terms = _smooth_spectra(*self._sides, scale, self.dtype.char)
        for plane, coefficients in zip(eigenvalues, self.remainder.smooth.astype(self.dtype), strict=True):
            for coefficient, transform in zip(coefficients, smooth_terms, strict=True):
                plane += coefficient * transform
        return np.asarray(eigenvalues)

    def transformed(self, r: int, plane: Values) -> Values:
        """Return the transform of a plane convolved with g_r."""
        from scipy.fft import dctn

        if self.border != "reflect":
            plane = np.pad(plane, self._around, mode="edge" if self.border == "extend" else "constant")
        transform = dctn(plane, overwrite_x=True)
        transform *= self.eigenvalues[r]
        return np.asarray(transform)

    def image(self, transform: Values, threads: int = 1) -> Values:
        """Return the inverse of `transform`, cropped to the image."""
        from scipy.fft import idctn

        return np.asarray(idctn(transform, overwrite_x=True, workers=threads)[self._image])

    def padded_transform(self, plane: Values, threads: int = 1) -> Values:
        """Return the transform of a plane padded with zeros: the transpose of :meth:`image` up to a factor."""
        from scipy.fft import dctn

        return np.asarray(dctn(np.pad(plane, self._around), workers=threads))

    def transposed(self, r: int, transform: Values) -> Values:
        """Return the transpose of :meth:`transformed` applied to a `transform`, up to the inverse factor."""
        from scipy.fft import idctn

        plane = idctn(self.eigenvalues[r] * transform, overwrite_x=True)
        if self.border == "extend":
            # The transpose of repeating the edges: values on the copies are added to the edges.
            for lines, (before, after) in zip((plane, plane.T), self._around, strict=True):
                lines[before] += lines[:before].sum(axis=0)
                lines[-after - 1] += lines[-after:].sum(axis=0)
        return np.asarray(plane[self._image])


@lru_cache(maxsize=8)
def _cosines(side: int, reach: int, dtype: str) -> Values:
    """Return the matrix (side, reach + 1) that transforms the non-negative half of an even kernel."""
    # Multiples are reduced modulo the period: the cosine of a large argument would lose digits.
    multiples = np.outer(np.arange(side), np.arange(reach + 1)) % (2 * side)
    matrix = 2.0 * np.cos((math.pi / side) * multiples)
    matrix[:, 0] = 1.0
    matrix.flags.writeable = False
    return np.asarray(matrix.astype(dtype))


@lru_cache(maxsize=4)
def _smooth_spectra(height: int, width: int, scale: float, dtype: str) -> Values:
    """Return the transforms of the three smooth terms, shape (3, height, width)."""
    rows, columns = ((np.arange(side) / (2.0 * side)).astype(dtype) for side in (height, width))
    return smooth_transforms(np.hypot(rows[:, None], columns), scale)
