"""The transfer function of the pixels of a window, by a direct sum: what measures of the image tend to."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

import lommel as lm
from lommel.measures.energy import energy_per_pixel


def window_transform(psf: lm.PSF, fx: ArrayLike, fy: ArrayLike = 0.0) -> np.ndarray:
    """Return ``sum values exp(-2 pi i (fx x + fy y))``, with the values as shares of all light."""
    fx, fy = np.broadcast_arrays(fx, fy)
    columns, rows = (np.exp(-2j * np.pi * np.outer(p, f)) for p, f in ((psf.grid.x, fx), (psf.grid.y, fy)))
    sums = np.einsum("...yf,yf->...f", energy_per_pixel(psf) @ columns, rows)
    return sums.reshape(psf.pupil.shape + fx.shape)
