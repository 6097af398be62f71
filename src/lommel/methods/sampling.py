"""Pupils sampled on a Cartesian lattice: transmission of the cells, and number of samples needed."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Declined
from lommel.methods.method import Method
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil

MAX_SAMPLES = 8192
"""Across the aperture, at most."""


def samples_needed(pupil: Pupil, grid: Grid) -> tuple[int, str]:
    """Return the fewest samples across the aperture for which no light wraps around into the window, and why so many.

    Images of n samples repeat at ``pi n`` in v: that of the blur on the other side must not reach the window.
    """
    step = grid.step(pupil)
    blur = float(pupil.v(pupil.geometric_radius()).max())
    window = max(float(np.abs(part).max()) for part in (grid.x, grid.y)) * step / grid.side + 0.5 * step
    why = f"the geometric blur (v = {blur:.4g}) and the window (v = {window:.4g})"
    return math.ceil((blur + window) / math.pi), why


def require_samples(method: Method, samples: int, pupil: Pupil, grid: Grid) -> None:
    """Raise ValueError where light would wrap around into the window, or each pupil has an axis of its own."""
    grid.require_one_axis()
    needed, why = samples_needed(pupil, grid)
    if needed > samples:
        advice = (
            f"at least samples={needed}" if needed <= MAX_SAMPLES else f"{needed:.3g} samples, over {MAX_SAMPLES}"
        )
        raise Declined(f"{type(method).__name__}(samples={samples}) would alias: {why} need {advice}")


def pupil_functions(pupil: Pupil, x: Array, half: float, edge: str) -> Iterator[NDArray[np.complex128]]:
    """Yield the field in square cells of side ``2 half`` centred at ``(x, x)``, for each of the flattened stack."""
    rho, theta = np.hypot(x[:, None], x), np.arctan2(x[:, None], x)
    amplitude = illuminated(pupil, x, transmission(pupil, x, half, edge))
    wavefronts = pupil.wavefront.flattened()
    for i in range(wavefronts.shape[0]):
        yield amplitude * np.exp(1j * wavefronts[i].phase(rho, theta))


def transmission(pupil: Pupil, x: Array, half: float, edge: str) -> Array:
    """Return the amplitude, without apodization, of square cells of side ``2 half`` centred at ``(x, x)``.

    "binary": that at the centre of the cell. "grey": times the part of the cell that the aperture leaves clear; see
    :meth:`lommel.optics.aperture.opening.Opening.coverage`.
    """
    across, down = x[None, :], x[:, None]
    if edge == "grey":
        part = pupil.opening.coverage(across, down, half)
    else:
        part = (pupil.opening.margin(across, down) >= 0.0).astype(np.float64)
    return part if pupil.mask is None else part * pupil.mask.at(across, down)


def illuminated(pupil: Pupil, x: Array, part: Array) -> Array:
    """Return `part` times the apodization at ``(x, x)``."""
    if pupil.illumination.uniform:
        return part
    square, clear = x * x, part > 0.0
    out = part.copy()
    out[clear] *= pupil.illumination.at((square[:, None] + square)[clear])
    return out
