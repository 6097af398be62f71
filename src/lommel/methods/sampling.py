"""What the methods on a Cartesian lattice share: the transmission of its cells, and how fine it must be."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil


def blur_and_window(pupil: Pupil, grid: Grid) -> tuple[float, float]:
    """Return how far from the axis light falls by ray optics, and how far the window reaches along x or y, in v."""
    step = grid.step(pupil)
    blur = float(pupil.v(pupil.geometric_radius()).max())
    window = max(float(np.abs(part).max()) for part in (grid.x, grid.y)) * step / grid.pixel + 0.5 * step
    return blur, window


def samples_needed(pupil: Pupil, grid: Grid) -> int:
    """Return the fewest samples across the aperture for which no light wraps around into the window.

    Images of n samples repeat at ``pi n`` in v: that of the blur on the other side must not reach the window.
    """
    return math.ceil(sum(blur_and_window(pupil, grid)) / math.pi)


def transmission(pupil: Pupil, x: NDArray[np.float64], half: float, edge: str) -> NDArray[np.float64]:
    """Return the amplitude, without apodization, of square cells of side ``2 half`` centred at ``(x, x)``.

    "binary": that at the centre of the cell. "grey": times the part of the cell that the aperture leaves clear; see
    :meth:`lommel.optics.opening.Opening.coverage`.
    """
    across, down = x[None, :], x[:, None]
    if edge == "grey":
        part = pupil.opening.coverage(across, down, half)
    else:
        part = (pupil.opening.margin(across, down) >= 0.0).astype(np.float64)
    return part if pupil.mask is None else part * pupil.mask.at(across, down)


def illuminated(pupil: Pupil, x: NDArray[np.float64], part: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return `part` times the apodization at ``(x, x)``."""
    if pupil.illumination.uniform:
        return part
    square, clear = x * x, part > 0.0
    out = part.copy()
    out[clear] *= pupil.illumination.at((square[:, None] + square)[clear])
    return out
