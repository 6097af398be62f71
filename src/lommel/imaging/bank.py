"""A bank of pixel-averaged PSFs over defocus, close enough for what lies between to be interpolated."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.imaging.pixel_rule import PixelRule, pixel_rule
from lommel.methods.choice import of_profiles
from lommel.optics.pupil import Pupil
from lommel.optics.spectrum import in_light
from lommel.optics.wavefront import Wavefront

_MAX_WINDOWS = 20_000
_MAX_VALUES = 2**27  # of a bank, 1 GiB in double precision
_METHOD = of_profiles(1e-7)


@dataclass(frozen=True)
class Bank:
    """Windows of one channel, equally spaced in defocus.

    Attributes
    ----------
    start, spacing : float
        Defocus C_d (radians at the wavelength of the lens) of the first window, and from one to the next.
    windows : ndarray, shape (count + 1, half + 1, stride)
        Share of the light of a point that each pixel receives, from the middle row down: the rows above mirror those
        below. Columns beyond the window and the last window are room for the compiled core.
    halves : ndarray, shape (count,)
        How many pixels from the middle are used, a real number h, interpolated linearly between windows: of the
        ring at the Chebyshev distance k the share ``h + 1 - k``, from 0 to 1. So nothing jumps as a point moves.
    energies : ndarray, shape (count, side // 2 + 1)
        Sum of each window up to a whole distance; what is used is divided by its sum.
    lost : float
        Largest share of light beyond the pixels used, spread over these instead.
    error : float
        Largest difference found between interpolated windows and exact ones half-way, over the peak of these.
    """

    start: float
    spacing: float
    windows: NDArray[np.floating[Any]]
    halves: NDArray[np.float64]
    energies: NDArray[np.float64]
    lost: float
    error: float

    @property
    def count(self) -> int:
        """Number of windows."""
        return len(self.energies)

    @property
    def half(self) -> int:
        """Pixels from the middle of the largest window to its edge."""
        return int(self.energies.shape[1]) - 1

    def positions(self, defocus: ArrayLike) -> NDArray[np.float64]:
        """Return where defocus C_d lies in the bank, 0 at its first window, 1 at its second.

        Parameters
        ----------
        defocus : array_like
            Radians at the wavelength of the lens.

        Returns
        -------
        ndarray
        """
        return (np.asarray(defocus, dtype=np.float64) - self.start) / self.spacing

    def used(self, defocus: float) -> NDArray[np.float64]:
        """Return how much of each pixel is used for one defocus, 0 to 1, shape (side, side).

        Parameters
        ----------
        defocus : float
            C_d, radians at the wavelength of the lens.

        Returns
        -------
        ndarray
        """
        half = np.interp(self.positions(defocus), np.arange(self.count), self.halves)
        away = np.abs(np.arange(-self.half, self.half + 1))
        return np.asarray(np.clip(half + 1.0 - np.maximum(away[:, None], away), 0.0, 1.0))

    def window(self, defocus: float) -> NDArray[np.float64]:
        """Return the window that the compiled core makes of the bank for one defocus, shape (side, side).

        Parameters
        ----------
        defocus : float
            C_d, radians at the wavelength of the lens.

        Returns
        -------
        ndarray
        """
        position = float(np.clip(self.positions(defocus), 0.0, self.count - 1))
        interval = min(int(position), self.count - 2)
        first = min(max(interval - 1, 0), self.count - 4)
        t = position - first
        weights = [math.prod((t - k) / (j - k) for k in range(4) if k != j) for j in range(4)]
        side = 2 * self.half + 1
        lower = np.tensordot(weights, self.windows[first : first + 4, :, :side].astype(np.float64), axes=1)
        half = np.interp(position, np.arange(self.count), self.halves)
        energy = weights @ _held(self.energies[first : first + 4], np.full(4, half))
        return np.asarray(np.concatenate([lower[:0:-1], lower]) * self.used(defocus) / energy)


def build_bank(
    pupil: Pupil,
    phase: Callable[[NDArray[np.float64]], Wavefront],
    spectrum: Sequence[tuple[float, float]],
    pixel: float,
    defocus: tuple[float, float],
    *,
    tol: float,
    energy: float,
    largest: int,
    dtype: DTypeLike = np.float32,
    threads: int = 0,
) -> Bank:
    """Compute the bank of one channel.

    Parameters
    ----------
    pupil : Pupil
        In focus, with the aberrations of the lens, at its wavelength; radially symmetric.
    phase : callable
        Makes wavefronts of defocus, as :meth:`lommel.Lens.phase`.
    spectrum : sequence of (wavelength, weight)
        Of the channel; weights sum to 1.
    pixel : float
        Metres.
    defocus : (float, float)
        Range of C_d, radians at the wavelength of the pupil.
    tol : float
        Windows are put closer together until interpolation errs by less, over the peak.
    energy : float
        Share of light that the pixels used must hold.
    largest : int
        Largest half width allowed, pixels.
    dtype : float32 or float64
    threads : int
        At most so many, 0 for as many as there are processors. The result does not depend on it.

    Returns
    -------
    Bank

    Raises
    ------
    ValueError
        If windows would exceed `largest`, or if the bank would hold more than 20 000 windows or 2^28 values.
    """
    low, high = defocus
    half = _enough(pupil, phase, spectrum, pixel, defocus, energy, largest, threads)
    # A window beyond either end, so that every pixel is in the middle of four.
    spacing = max((high - low) / 6.0, 0.05)
    start = low - spacing

    def means(positions: NDArray[np.float64]) -> NDArray[np.float64]:
        return _means(pupil, phase, spectrum, pixel, start + spacing * positions, half, threads)[1]

    exact = means(np.arange(math.ceil((high - start) / spacing) + 3, dtype=np.float64))
    while True:
        middle = means(np.arange(len(exact) - 1, dtype=np.float64) + 0.5)
        error = _interpolation_error(exact, middle)
        if error <= tol:
            break
        # Those half-way are windows of the next bank; the error falls sixteenfold.
        count, side = 2 * len(exact) - 1, 2 * half + 1
        if count > _MAX_WINDOWS or count * side * side > _MAX_VALUES:
            raise ValueError(
                f"a bank of {count} windows of {side} x {side} pixels, for C_d from {low:.4g} to {high:.4g} rad, "
                f"exceeds the limits of {_MAX_WINDOWS} windows and {_MAX_VALUES} values; ask for a larger tol "
                f"than {tol:g}"
            )
        finer = np.empty((count, exact.shape[1]))
        finer[::2], finer[1::2] = exact, middle
        exact, spacing = finer, 0.5 * spacing
    first = max(0, math.floor((low - start) / spacing) - 1)
    last = min(len(exact), math.ceil((high - start) / spacing) + 3)
    first = max(0, min(first, last - 4))
    rule = _means(pupil, phase, spectrum, pixel, np.empty(0), half, threads)[0]
    return _packed(rule, exact[first:last], start + first * spacing, spacing, error, energy, dtype)


def _packed(
    rule: PixelRule,
    exact: NDArray[np.float64],
    start: float,
    spacing: float,
    error: float,
    energy: float,
    dtype: DTypeLike,
) -> Bank:
    """Cut the windows to what holds `energy`, and leave the compiled core the room it needs."""
    sums = rule.sums(exact)
    enough = np.pad(_enough_of(sums, energy + 1e-12), 1, mode="edge")  # rounding is not to leave less
    # Those on either side count, so that what is interpolated holds enough as well.
    halves = np.maximum(np.maximum(enough[:-2], enough[2:]), enough[1:-1])
    used = math.ceil(halves.max())
    side = 2 * used + 1
    stride = max(-(-side // 16) * 16, -(-64 // (used + 1)))
    windows = _at_cache_lines((len(exact) + 1, used + 1, stride), np.dtype(dtype))
    windows[:-1, :, :side] = rule.unfold(exact.astype(dtype), used)[:, used:]
    kept = np.ascontiguousarray(sums[:, : used + 1])
    # Half-way between windows the sums and the half widths are what the core makes of them.
    between = (9.0 * (kept[1:-2] + kept[2:-1]) - kept[:-3] - kept[3:]) / 16.0
    held = min(_held(kept, halves).min(), _held(between, 0.5 * (halves[1:-2] + halves[2:-1])).min())
    return Bank(start, spacing, windows, halves, kept, float(1.0 - held), error)


def _held(sums: NDArray[np.float64], halves: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the sum of so much of each window, from the sums up to whole distances."""
    outer = np.ceil(halves).astype(np.int64)
    rows = np.arange(len(sums))
    rim = halves + 1.0 - outer
    return np.asarray(rim * sums[rows, outer] + (1.0 - rim) * sums[rows, np.maximum(outer - 1, 0)])


def _enough_of(sums: NDArray[np.float64], energy: float) -> NDArray[np.float64]:
    """Return the half width of each window that holds `energy`, or all of it where it holds less."""
    outer = np.where(sums[:, -1] >= energy, (sums >= energy).argmax(axis=1), sums.shape[1] - 1)
    rows, inner = np.arange(len(sums)), np.maximum(outer - 1, 0)
    ring = sums[rows, outer] - sums[rows, inner]
    share = np.divide(energy - sums[rows, inner], ring, out=np.ones(len(sums)), where=ring > 0.0)
    return np.asarray(inner + np.where(outer > 0, np.clip(share, 0.0, 1.0), 0.0))


def _at_cache_lines(shape: tuple[int, ...], dtype: np.dtype[Any]) -> NDArray[Any]:
    """Return zeros whose rows begin at cache lines where the stride lets them: vectors then are loaded faster."""
    size = math.prod(shape) * dtype.itemsize
    room = np.zeros(size + 64, dtype=np.uint8)
    first = -room.ctypes.data % 64
    return room[first : first + size].view(dtype).reshape(shape)


def _enough(
    pupil: Pupil,
    phase: Callable[[NDArray[np.float64]], Wavefront],
    spectrum: Sequence[tuple[float, float]],
    pixel: float,
    defocus: tuple[float, float],
    energy: float,
    largest: int,
    threads: int,
) -> int:
    """Return half of a window that holds `energy` of the light at both ends of the range and in its middle."""
    ends = np.array([defocus[0], 0.5 * (defocus[0] + defocus[1]), defocus[1]])
    blur = pupil.carrying(phase(ends) + pupil.wavefront, None).geometric_radius().max()
    half = math.ceil(float(blur) / pixel) + 1
    while True:
        if half > largest:
            raise ValueError(
                f"the blur takes windows of more than {2 * largest + 1} pixels a side to hold {energy:g} of the "
                f"light; stop down, allow larger windows (largest={half} or more), or ask for less of it (energy=)"
            )
        rule, means = _means(pupil, phase, spectrum, pixel, ends, half, threads)
        sums = rule.sums(means)
        if sums[:, -1].min() >= energy:
            return int(max((row >= energy).argmax() for row in sums)) + 1
        half = math.ceil(1.3 * half) + 1


def _means(
    pupil: Pupil,
    phase: Callable[[NDArray[np.float64]], Wavefront],
    spectrum: Sequence[tuple[float, float]],
    pixel: float,
    defocus: NDArray[np.float64],
    half: int,
    threads: int,
) -> tuple[PixelRule, NDArray[np.float64]]:
    """Return the share of the light of a point in each pixel of the octant, shape ``(n, cells)``, and its rule."""
    assert pupil.wavelength is not None
    total: Any = 0.0
    for wavelength, weight in spectrum:
        step = math.pi * pixel * pupil.wavelength / (wavelength * pupil.scale)
        rule = pixel_rule(half, step)
        if defocus.size == 0:
            break
        there = in_light(pupil.carrying(phase(defocus) + pupil.wavefront, None), wavelength)
        share = weight * step**2 / (4.0 * math.pi * there.transmission)
        total += share * _METHOD.means(there, step * rule.radii, rule.matrix, threads)
    return rule, total


def _interpolation_error(exact: NDArray[np.float64], middle: NDArray[np.float64]) -> float:
    """Return the largest difference half-way between windows, over the peak there; not in the first and last gap."""
    guess = (9.0 * (exact[1:-2] + exact[2:-1]) - exact[:-3] - exact[3:]) / 16.0
    inner = middle[1:-1]
    return float((np.abs(guess - inner).max(axis=1) / inner.max(axis=1)).max())
