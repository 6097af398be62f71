"""The light beyond the windows of a field: far from its middle a PSF is nearly the same all over the field."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.imaging.field.light import PointLight, Span, overview

_BEYOND = 2.5  # times the window: as far the far light is known pixel by pixel, at least
_ELSEWHERE = 1.2  # times what is off at places that were looked at, for those that were not


@dataclass(frozen=True)
class FarLight:
    """What a point spreads beyond its window, but for how much of its light that is.

    Attributes
    ----------
    kernel : ndarray, shape (side, side)
        The mean over the field; 0 where the window is, of the sum 1.
    half : int
        Pixels from the middle of the windows to their edges.
    error : float
        Largest sum of absolute differences to the light that points spread there, with some room for points that were
        not looked at.
    lost : float
        Largest share of light beyond the kernel, which is within it instead.
    """

    kernel: NDArray[np.float64]
    half: int
    error: float
    lost: float

    @property
    def reach(self) -> int:
        """Pixels from the middle of the kernel to its edge."""
        return len(self.kernel) // 2


def far_light(light: PointLight, spans: Sequence[Span], tol: float, largest: int, farthest: int) -> FarLight:
    """Find the least windows beyond which all points spread their light alike.

    Parameters
    ----------
    light : PointLight
    spans : sequence of three (float, float)
        Ranges of y, x and defocus.
    tol : float
        Bound on the sum of absolute differences.
    largest : int
        Largest half width of windows, pixels.
    farthest : int
        Pixels that the kernel reaches, if it must.

    Returns
    -------
    FarLight

    Raises
    ------
    ValueError
        If it takes larger windows.
    """
    places = overview(spans)
    half = 8
    while True:
        half = min(half, largest)
        reach = int(np.ceil(_BEYOND * half))
        windows = light.windows(places, reach)
        found = _least(windows, half, tol)
        if found is not None:
            break
        if half == largest:
            raise ValueError(
                f"light farther than {largest} pixels from its point is not alike to {tol:.2g} all over the field; "
                f"allow larger windows than largest={largest}, ask for a larger tol, or for less light (energy=)"
            )
        half *= 2
    least, error = found
    tails = windows.copy()
    tails[:, reach - least : reach + least + 1, reach - least : reach + least + 1] = 0.0
    beyond = 1.0 - windows.sum(axis=(1, 2))
    # The share beyond a square falls as one over its side, which that of one over r^3 does.
    enough = int(np.ceil(4.0 * float(beyond.max()) / tol * (reach + 0.5)))
    side = max(reach, min(farthest, enough))
    kernel = np.pad(tails.sum(axis=0), side - reach)
    if side > reach:
        away = np.arange(-side, side + 1.0)
        ring = np.hypot(away[:, None], away)
        ring[side - reach : side + reach + 1, side - reach : side + reach + 1] = np.inf
        ring = ring**-3.0
        kernel += ring * (float(beyond.sum()) * (1.0 - (reach + 0.5) / (side + 0.5)) / ring.sum())
    lost = float(beyond.max()) * (reach + 0.5) / (side + 0.5)
    return FarLight(kernel / kernel.sum(), least, _ELSEWHERE * error, lost)


def _least(windows: NDArray[np.float64], most: int, tol: float) -> tuple[int, float] | None:
    """Return half of the least windows beyond which the light of all points is alike, and how far it is not."""
    low, high, known = 0, most, _off(windows, most)
    if _ELSEWHERE * known > tol:
        return None
    while high - low > 1:  # The smaller the window, the more there is to be off.
        half = (low + high) // 2
        error = _off(windows, half)
        if _ELSEWHERE * error <= tol:
            high, known = half, error
        else:
            low = half
    return high, known


def _off(windows: NDArray[np.float64], half: int) -> float:
    """Return the largest sum of absolute differences between tails and the mean, made as bright."""
    reach = windows.shape[-1] // 2
    inner = slice(reach - half, reach + half + 1)
    outside = np.ones(windows.shape[1:], dtype=np.bool_)
    outside[inner, inner] = False
    tails: NDArray[Any] = windows[:, outside]
    bright = tails.sum(axis=1)
    mean = tails.sum(axis=0) / bright.sum()
    return float(np.abs(tails - bright[:, None] * mean).sum(axis=1).max())
