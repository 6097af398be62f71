"""What pictures share: words for values, scales of brightness, and matplotlib, imported when the first is drawn."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.base.optional import library

MEANING = {
    "energy": "fraction of all light per pixel",
    "emitted": "light per pixel over all that is collected far from the glass",
    "strehl": "1 = unaberrated peak",
    "peak": "1 = largest value",
}
"""What a value is, by the normalisation."""

HOW = {"pixel": "averaged over each pixel", "center": "sampled at pixel centres"}
"""How values see their pixels, by :attr:`lommel.PSF.sampling`."""

USER = ("plots need", "plot")
"""What needs a library, and the extra that brings it."""

_FLOOR = 1e-5  # of the peak: the bottom of logarithmic scales


def norm_of(stretch: str, peak: float) -> Any:
    """Return the scale of brightness of values up to `peak`."""
    from matplotlib.colors import LogNorm, Normalize, PowerNorm

    if stretch == "log":
        return LogNorm(_FLOOR * peak, peak, clip=True)
    return PowerNorm(0.5, 0.0, peak) if stretch == "sqrt" else Normalize(0.0, peak)


def stretched(light: NDArray[Any], stretch: str) -> NDArray[np.float64]:
    """Return levels from 0 to 1 of light from 0 to 1."""
    if stretch == "log":
        return np.asarray(1.0 - np.log10(np.maximum(light, _FLOOR)) / np.log10(_FLOOR))
    return np.asarray(np.sqrt(light) if stretch == "sqrt" else light, dtype=np.float64)


def pyplot() -> Any:
    """Return ``matplotlib.pyplot``; ImportError if it is not installed."""
    return library("matplotlib.pyplot", *USER)
