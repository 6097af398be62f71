"""The modulation transfer of a pupil as its overlap with itself, summed on a grid: for all that has an MTF."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

Array = np.ndarray


def overlap(pupil: Callable[[Array, Array], Array], along: float, across: float) -> float:
    """Return the MTF at frequencies over the cutoff along x and y; `pupil` is 0 beyond the unit circle.

    About 1e-3 for smooth phases, by the staircase at the rim.
    """
    side = np.linspace(-1.0, 1.0, 1601)
    x, y = np.meshgrid(side, side)
    shifted = pupil(x + along, y + across) * pupil(x - along, y - across).conj()
    return float(abs(shifted.sum()) / (np.abs(pupil(x, y)) ** 2).sum())
