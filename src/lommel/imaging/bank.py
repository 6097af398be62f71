"""A bank of pixel-integrated PSFs over defocus, close enough to interpolate those between."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base.arrays import Array, Values
from lommel.imaging.remainder import Remainder, fit, inner_energy, reach_of
from lommel.imaging.sensor_light import DefocusNodes, SensorLight, cut, find_cuts, shares_used, sums_of_quarters

_MAX_WINDOWS = 20_000
_MAX_VALUES = 2**27  # of a bank, 1 GiB in double precision
_GAPS = 12  # between the windows that are tried first, or twice as many and so on: a radian apart at most


@dataclass(frozen=True, eq=False)
class Bank:
    """Windows of one channel, equally spaced in defocus.

    Attributes
    ----------
    start, spacing : float
        Defocus C_d (radians at the wavelength of the lens) of the first window, and from one to the next.
    windows : ndarray, shape (count + 1, half + 1, stride)
        Share of the light of a point that each pixel receives, from the middle row down and the middle column on: the
        other quadrants mirror this one. Columns beyond the window and the last window are room for the compiled core.
    cuts : ndarray, shape (count,)
        How many pixels from the middle are used of each window, a real number h: of the ring at the Chebyshev
        distance k the share ``h + 1 - k``, from 0 to 1, averaged over the neighbours (1/6, 2/3, 1/6). So nothing
        jumps as a point moves.
    energies : ndarray, shape (count,)
        What each window sums to; what is interpolated is divided by its sum. Ones where there is a remainder: then
        nothing is divided.
    lost : float
        Largest share of light beyond the pixels used, spread over these instead.
    error : float
        Largest difference found between interpolated windows and exact ones half-way, over the peak of these.
    remainder : Remainder, optional
        What lies beyond the windows, if nothing is to be lost; the windows then hold the PSF less this.
    filled : ndarray, optional
        What the remainder holds where the windows are, as `windows` are stored.
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
        """Pixels from the middle of the largest window to its edge."""
        return int(self.windows.shape[1]) - 1

    @property
    def halves(self) -> NDArray[np.int64]:
        """Pixels from the middle of each window to the last one used, shape (count,)."""
        padded = np.ceil(np.pad(self.cuts, 1, mode="edge")).astype(np.int64)
        return np.maximum(np.maximum(padded[:-2], padded[2:]), padded[1:-1])

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
        """Return the share used of each pixel, about 0 to 1, at one `defocus` C_d (radians), shape (side, side)."""
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
        position = float(np.clip(self.positions(defocus), 0.0, self.count - 1))
        interval = min(int(position), self.count - 2)
        first = min(max(interval - 1, 0), self.count - 4)
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
    per_radian = light.pupil.wavelength / min(wavelength for wavelength, _ in light.spectrum)
    whole = energy == 1.0
    step = math.pi * per_radian * light.pixel / light.pupil.scale
    inner = inner_energy(step) if whole else energy
    half, parabola = light.enough(defocus, inner, largest)
    reach = reach_of(half, step) if whole else half
    # A window beyond either end, so that every pixel is in the middle of four.
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
        # The error falls sixteenfold where windows are twice as close, more slowly where they are far apart.
        spacing *= 0.5 ** max(1, math.ceil(math.log(error / tol, 16.0)))
    cuts = find_cuts(exact, half, inner + 1e-12)  # rounding is not to leave less
    if whole:
        used = math.ceil(cuts.max())
        cells = (used + 1) * (used + 2) // 2
        exact, middle = exact[:, :cells], together[3:-3:2, :cells]
        remainder, within = fit(everywhere, start, spacing, exact, middle, cuts, reach, tol)
        windows, filled = (stored_windows(cut(part, cuts), np.dtype(dtype)) for part in (exact - within, within))
        return Bank(start, spacing, windows, cuts, np.ones(count), 0.0, error, remainder, filled)
    quarter = cut(exact, cuts)
    energies = sums_of_quarters(quarter)
    between = (9.0 * (energies[1:-2] + energies[2:-1]) - energies[:-3] - energies[3:]) / 16.0
    held = min(float(energies.min()), float(between.min()))
    return Bank(start, spacing, stored_windows(quarter, np.dtype(dtype)), cuts, energies, 1.0 - held, error)


def stored_windows(quarter: Array, dtype: np.dtype[np.floating]) -> Values:
    """Return windows, shape (count + 1, half + 1, stride), with the padding that the compiled core needs."""
    count, side, _ = quarter.shape
    shape = count + 1, side, ((side - 1) // 16 + 1) * 16
    # Rows begin at cache lines where the stride lets them: vectors then are loaded faster.
    size = math.prod(shape) * dtype.itemsize
    room = np.zeros(size + 64, dtype=np.uint8)
    first = -room.ctypes.data % 64
    windows = room[first : first + size].view(dtype).reshape(shape)
    windows[:-1, :, :side] = quarter
    return windows


def _interpolation_error(exact: Array, middle: Array) -> float:
    """Return the largest difference half-way between windows, over the peak there; not in the first and last gap."""
    off = exact[1:-2] + exact[2:-1]
    off *= 9.0
    off -= exact[:-3]
    off -= exact[3:]
    off /= 16.0
    inner = middle[1:-1]
    off -= inner
    return float((np.abs(off, out=off).max(axis=1) / inner.max(axis=1)).max())
