"""Banks: tables of PSF windows over defocus, between which the compiled core interpolates.

A window is the pixel-integrated PSF on a square of pixels. A ring is the set of pixels at one Chebyshev distance from
the centre.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base.arrays import Array, Values
from lommel.imaging.sensor_light import (
    DefocusNodes,
    SensorLight,
    cut,
    find_cuts,
    neighbour_maxima,
    pixel_factors,
    sums_of_quarters,
)

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
        Sum of each window. An interpolated window is divided by the interpolated sum.
    lost : float
        Largest fraction of the light of a point outside its window; this light is spread over the window.
    error : float
        Largest difference between an interpolated and a computed window, half-way between two windows, plus the error
        bound of the computed window; relative to the peak of the window.
    """

    start: float
    spacing: float
    windows: Values
    cuts: Array
    energies: Array
    lost: float
    error: float

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
    half, parabola = light.sufficient_half(defocus, energy, largest)
    # The bank extends beyond the range on both sides: every point then lies between the inner two of four windows.
    spacing = max((high - low) / _GAPS, 0.05)
    spacing *= 0.5 ** max(0, math.ceil(math.log2(spacing)))
    interpolation = DefocusNodes.of(
        lambda nodes: light.shares(light.defocused(nodes), half),
        low - spacing,
        high + 2.0 * spacing,
        parabola,
        rate=lambda reach: per_radian * (2.0 if light.rate is None else light.rate(reach)),
        bound=math.pi * (light.pixel * per_radian / light.pupil.scale) ** 2 / 4.0,
        threads=light.threads,
    )
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
    cuts = find_cuts(exact, half, energy + 1e-12)  # despite rounding, windows hold at least the energy requested
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
