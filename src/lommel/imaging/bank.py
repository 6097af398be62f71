"""A bank of pixel-averaged PSFs over defocus, close enough for what lies between to be interpolated."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.imaging.defocus_nodes import DefocusNodes, Parabola
from lommel.imaging.pixel_rule import pixel_rule, quarters, sums_of_windows
from lommel.imaging.remainder import Remainder, fit, inner_energy, reach_of
from lommel.methods.choice import of_profiles
from lommel.optics.pupil import Pupil
from lommel.optics.spectrum import in_light
from lommel.optics.wavefront import Wavefront

_MAX_WINDOWS = 20_000
_MAX_VALUES = 2**27  # of a bank, 1 GiB in double precision
_GAPS = 12  # between the windows that are tried first, or twice as many and so on: a radian apart at most
_METHOD = of_profiles(1e-7)


@dataclass(frozen=True)
class Bank:
    """Windows of one channel, equally spaced in defocus.

    Attributes
    ----------
    start, spacing : float
        Defocus C_d (radians at the wavelength of the lens) of the first window, and from one to the next.
    windows : ndarray, shape (count + 1, half + 1, stride)
        Share of the light of a point that each pixel receives, from the middle row down and the middle column on: the
        other quadrants mirror this one. Columns beyond the window and the last window are room for the compiled core.
    halves : ndarray, shape (count,)
        How many pixels from the middle are used, a real number h, interpolated linearly between windows: of the
        ring at the Chebyshev distance k the share ``h + 1 - k``, from 0 to 1. So nothing jumps as a point moves.
    energies : ndarray, shape (count, side // 2 + 1)
        Sum of each window up to a whole distance; what is used is divided by its sum. Ones where there is a
        remainder: then nothing is divided.
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
    windows: NDArray[np.floating[Any]]
    halves: NDArray[np.float64]
    energies: NDArray[np.float64]
    lost: float
    error: float
    remainder: Remainder | None = None
    filled: NDArray[np.floating[Any]] | None = None

    @property
    def count(self) -> int:
        """Number of windows."""
        return len(self.energies)

    @property
    def half(self) -> int:
        """Pixels from the middle of the largest window to its edge."""
        return int(self.energies.shape[1]) - 1

    @property
    def beyond(self) -> tuple[int, int]:
        """Rows and columns that the compiled core needs beyond the image, on either side."""
        return self.half, self.windows.shape[2]

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
        positions = np.asarray(defocus, dtype=np.float64) - self.start
        positions /= self.spacing
        return positions

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
        away = np.abs(np.arange(-self.half, self.half + 1))
        mixed = np.tensordot(weights, self.windows[first : first + 4].astype(np.float64), axes=1)
        made = mixed[away[:, None], away] * self.used(defocus)
        return np.asarray(made if self.remainder else made / made.sum())


@dataclass(frozen=True)
class _Channel:
    """The light of a point on the pixels of a sensor, at any defocus: what :func:`build_bank` is given of it."""

    pupil: Pupil
    phase: Callable[[NDArray[np.float64]], Wavefront]
    spectrum: Sequence[tuple[float, float]]
    pixel: float
    threads: int

    def defocused(self, defocus: NDArray[np.float64]) -> Pupil:
        """Return the pupil at each defocus."""
        return self.pupil.carrying(self.phase(defocus) + self.pupil.wavefront, None)

    def shares(self, pupil: Pupil, half: int) -> NDArray[np.float64]:
        """Return the share of the light of a point in each pixel of the octant, shape ``(n, cells)``."""
        total: Any = 0.0
        for wavelength, weight in self.spectrum:
            there = in_light(pupil, wavelength)
            step = math.pi * self.pixel / there.scale
            rule = pixel_rule(half, step)
            share = weight * step**2 / (4.0 * math.pi * there.transmission)
            total += share * _METHOD.means(there, step * rule.radii, rule.matrix, self.threads)
        return np.asarray(total)

    def enough(self, defocus: tuple[float, float], energy: float, largest: int) -> tuple[int, Parabola]:
        """Return half of a window that holds `energy` of the light at both ends of the range and in its middle.

        And what is nearly 1 over the peaks.
        """
        ends = np.linspace(*defocus, 3)
        pupil = self.defocused(ends)
        half = math.ceil(float(pupil.geometric_radius().max()) / self.pixel) + 1
        while True:
            if half > largest:
                raise ValueError(
                    f"the blur takes windows of more than {2 * largest + 1} pixels a side to hold {energy:g} of "
                    f"the light; stop down, allow larger windows (largest={half} or more), or ask for less of it "
                    "(energy=)"
                )
            shares = self.shares(pupil, half)
            sums = sums_of_windows(shares, half)
            if sums[:, -1].min() >= energy:
                half = int((sums >= energy).argmax(axis=1).max()) + 1
                return half, Parabola.through(ends, shares.max(axis=1))
            half = math.ceil(1.3 * half) + 1


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
    rate: Callable[[float], float] = lambda _: 2.0,
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
        Share of light that the pixels used must hold; 1 for as much as is best, and a remainder that holds the rest.
    largest : int
        Largest half width allowed, pixels.
    dtype : float32 or float64
    threads : int
        At most so many, 0 for as many as there are processors. The result does not depend on it.
    rate : callable, optional
        As :meth:`lommel.Lens.phase_rate`, of `phase`; by default that of a paraxial lens.

    Returns
    -------
    Bank

    Raises
    ------
    ValueError
        If windows would exceed `largest`, or if the bank would hold more than 20 000 windows or 2^28 values.
    """
    low, high = defocus
    channel = _Channel(pupil, phase, spectrum, pixel, threads)
    assert pupil.wavelength is not None
    per_radian = pupil.wavelength / min(wavelength for wavelength, _ in spectrum)
    whole = energy == 1.0
    step = math.pi * per_radian * pixel / pupil.scale
    inner = inner_energy(step) if whole else energy
    half, parabola = channel.enough(defocus, inner, largest)
    reach = reach_of(half, step) if whole else half
    # A window beyond either end, so that every pixel is in the middle of four.
    spacing = max((high - low) / _GAPS, 0.05)
    spacing *= 0.5 ** max(0, math.ceil(math.log2(spacing)))
    at = DefocusNodes.of(
        lambda nodes: channel.shares(channel.defocused(nodes), reach),
        low - spacing,
        high + 2.0 * spacing,
        parabola,
        rate=lambda reach: per_radian * rate(reach),
        bound=math.pi * (pixel * per_radian / pupil.scale) ** 2 / 4.0,
        threads=threads,
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
    # The windows are cut to what holds `energy`, and leave the compiled core the room it needs.
    sums = sums_of_windows(exact, half)
    enough = np.pad(_enough_of(sums, inner + 1e-12), 1, mode="edge")  # rounding is not to leave less
    # Those on either side count, so that what is interpolated holds enough as well.
    halves = np.maximum(np.maximum(enough[:-2], enough[2:]), enough[1:-1])
    used = math.ceil(halves.max())
    shape = (len(exact) + 1, used + 1, (used // 16 + 1) * 16)
    if whole:
        cells = (used + 1) * (used + 2) // 2
        exact, middle = exact[:, :cells], together[3:-3:2, :cells]
        remainder, within = fit(everywhere, start, spacing, exact, middle, halves, reach, tol)
        windows, filled = (_stored(quarters(part.astype(dtype), used), shape) for part in (exact - within, within))
        return Bank(start, spacing, windows, halves, np.ones((len(exact), used + 1)), 0.0, error, remainder, filled)
    windows = _stored(quarters(exact.astype(dtype), used), shape)
    kept = np.ascontiguousarray(sums[:, : used + 1])
    # Half-way between windows the sums and the half widths are what the core makes of them.
    between = (9.0 * (kept[1:-2] + kept[2:-1]) - kept[:-3] - kept[3:]) / 16.0
    held = min(_held(kept, halves), _held(between, 0.5 * (halves[1:-2] + halves[2:-1])))
    return Bank(start, spacing, windows, halves, kept, 1.0 - held, error)


def energies_of(bank: Bank) -> NDArray[np.float64]:
    """Return what :attr:`Bank.energies` are where windows are divided by what they hold."""
    once = np.where(np.arange(bank.half + 1) == 0, 1.0, 2.0)
    windows = bank.windows[:-1, :, : bank.half + 1].astype(np.float64) * (once[:, None] * once)
    return np.ascontiguousarray(np.diagonal(windows.cumsum(axis=1).cumsum(axis=2), axis1=1, axis2=2))


def _held(sums: NDArray[np.float64], halves: NDArray[np.float64]) -> float:
    """Return the least that so much of a window holds, from the sums up to whole distances."""
    rows, outer = np.arange(len(sums)), np.ceil(halves).astype(np.int64)
    ring = sums[rows, outer] - sums[rows, outer - 1]
    return float((sums[rows, outer] - (outer - halves) * ring).min())


def _enough_of(sums: NDArray[np.float64], energy: float) -> NDArray[np.float64]:
    """Return the half width of each window that holds `energy`, or all of it where it holds less."""
    asked = np.minimum(energy, sums[:, -1])
    rows, outer = np.arange(len(sums)), (sums >= asked[:, None]).argmax(axis=1)
    ring = sums[rows, outer] - sums[rows, outer - 1]
    return np.asarray(outer - np.divide(sums[rows, outer] - asked, ring, out=np.zeros(len(sums)), where=outer > 0))


def _stored(quarter: NDArray[Any], shape: tuple[int, int, int]) -> NDArray[Any]:
    """Return windows, zeros after them; rows begin at cache lines where the stride lets them: loading is faster."""
    size = math.prod(shape) * quarter.itemsize
    room = np.zeros(size + 64, dtype=np.uint8)
    first = -room.ctypes.data % 64
    made = room[first : first + size].view(quarter.dtype).reshape(shape)
    count, height, width = quarter.shape
    made[:count, :height, :width] = quarter
    return made


def _interpolation_error(exact: NDArray[np.float64], middle: NDArray[np.float64]) -> float:
    """Return the largest difference half-way between windows, over the peak there; not in the first and last gap."""
    off = exact[1:-2] + exact[2:-1]
    off *= 9.0
    off -= exact[:-3]
    off -= exact[3:]
    off /= 16.0
    inner = middle[1:-1]
    off -= inner
    return float((np.abs(off, out=off).max(axis=1) / inner.max(axis=1)).max())
