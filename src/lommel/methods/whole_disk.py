"""The compiled engines of the whole disk, the series and the chordal rule: pupils that are not radially symmetric."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from lommel.grid import Grid
from lommel.methods.averaging import Rendered
from lommel.methods.method import not_met
from lommel.pupil import Pupil


def render(
    engine: Callable[..., float],
    pupil: Pupil,
    grid: Grid,
    scale: float | None,
    dtype: DTypeLike,
    tol: float,
    over: str,
    out: NDArray[Any] | None = None,
    threads: int = 0,
) -> Rendered:
    """Return images at the pixel centres, by an engine of the compiled core.

    Raises
    ------
    ToleranceError
        If the bound stays above `tol`, over what `over` says.
    """
    wavefront = pupil.wavefront.flattened()
    count = len(wavefront.edge)
    values = np.empty((count, *grid.shape), dtype) if out is None else out
    # The compiled core takes 0 for "divide by the largest value".
    scales, bounds, peaks = np.full(count, 0.0 if scale is None else scale), np.empty(count), np.empty(count)
    unmet = engine(
        wavefront.indices,
        wavefront.edge,
        pupil.obscuration,
        pupil.illumination.exponent,
        *grid.center,
        grid.step(pupil),
        tol,
        threads,
        values,
        scales,
        bounds,
        peaks,
    )
    if unmet:
        raise not_met(tol, unmet, over)
    return Rendered(values, scales, bounds, peaks)
