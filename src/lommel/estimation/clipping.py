"""Flat tops of images: many pixels at exactly the largest value, as of saturation that was not stated."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Values
from lommel.estimation.noise import Noise

_LEAST = 3  # pixels of the same largest value
_COUNTS = 3.0  # standard deviation of the noise, from which on equal values are rare
_OFTEN = 2.0  # times the pixels that noise puts below it


def flat_top(values: Values, valid: NDArray[np.bool_], noise: Noise) -> tuple[float, int]:
    """Return the largest valid value and how many pixels have it, if noise does not explain so many; else (nan, 0).

    Without saturation, pixels are at least as frequent in the range of the noise below the largest value as at it.
    """
    seen = values[valid]
    if seen.size == 0:
        return np.nan, 0
    top = float(seen.max())
    count = int((seen == top).sum())
    if count < _LEAST:
        return np.nan, 0
    gain = 1.0 if noise.white is None else noise.white
    white, read, offset = (float(np.median(part)) for part in (gain, noise.read, noise.offset))
    spread = float(np.sqrt(max((top - offset) * white, 0.0) + read**2)) / white
    # Where noise is hardly more than a count, many pixels have the same one.
    if spread < _COUNTS and bool((seen == np.rint(seen)).all()):
        return np.nan, 0
    near = int(((seen < top) & (seen >= top - spread)).sum())
    return (top, count) if count > _OFTEN * near else (np.nan, 0)


def remark(values: Sequence[Values], valid: Sequence[NDArray[np.bool_]], noise: Noise, name: str) -> str:
    """Return what is to be said of flat tops of images, each with a largest value of its own, or ""."""
    for k, (image, good) in enumerate(zip(values, valid, strict=True)):
        top, count = flat_top(image, good, noise)
        if count:
            where = f" of {name} {k}" if len(values) > 1 else ""
            return (
                f"; {count} pixels{where} have exactly the largest value, {top:.10g}: if they are saturated, state "
                f"it (saturation={top:.10g}, --saturation {top:.10g})"
            )
    return ""


def left_out(valid: Sequence[NDArray[np.bool_]]) -> str:
    """Return how many pixels are not fitted, or ""."""
    every = sum(part.size for part in valid)
    count = every - sum(int(part.sum()) for part in valid)
    return f"; {count} of {every} pixels left out (masked, saturated or NaN)" if count else ""
