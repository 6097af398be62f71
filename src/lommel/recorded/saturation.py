"""Saturation of recorded images: the value from which on pixels are full, and flat tops that suggest another."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Values
from lommel.recorded.noise import Noise

_BITS = (8, 10, 12, 14, 16)  # of the converters of cameras, whose largest values are full
_LEAST = 3  # pixels of the same largest value
_COUNTS = 3.0  # standard deviation of the noise, from which on equal values are rare
_OFTEN = 2.0  # times the pixels that noise puts below it


def full_value(planes: Sequence[Values], stated: float | None, *, name: str = "pixels") -> tuple[float, str]:
    """Return the value from which on pixels are saturated, infinity for none, and what was assumed of it, or "".

    It is the one that was stated; else the largest of the integer type; or of a camera of 8, 10, 12, 14 or 16 bits,
    where it is the largest value of all `planes` and more pixels have it than noise explains.
    """
    if stated is not None:
        return validation.real("saturation", stated, infinite=True), ""
    kind = planes[0].dtype
    most = float(np.iinfo(kind).max) if kind.kind in "iu" else math.inf
    with np.errstate(invalid="ignore"):
        top = max((float(np.fmax.reduce(plane, axis=None)) for plane in planes if plane.size), default=math.nan)
        if top + 1.0 not in [2.0**bits for bits in _BITS] or top >= most:
            return most, ""
        spread = max(math.sqrt(top), _COUNTS)  # at most that of a camera that counts each electron, or several
        least = min(float(np.fmin.reduce(plane, axis=None)) for plane in planes if plane.size)
        count = sum(int((plane == top).sum()) for plane in planes)
        near = sum(int(((plane < top) & (plane >= top - spread)).sum()) for plane in planes)
    if count < _LEAST or count <= _OFTEN * near or top - least <= spread:
        return most, ""
    return top, (
        f"{count} {name} have exactly the largest value, {top:.10g}, that of {math.log2(top + 1.0):.0f} bits: they "
        "were taken as saturated; saturation= states another"
    )


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
    noise = noise.poisson
    gain = 1.0 if noise.white is None else noise.white
    white, read, offset = (float(np.median(part)) for part in (gain, noise.read, noise.offset))
    spread = float(np.sqrt(max((top - offset) * white, 0.0) + read**2)) / white
    # Where noise is hardly more than a count, many pixels have the same one.
    if spread < _COUNTS and bool((seen == np.rint(seen)).all()):
        return np.nan, 0
    near = int(((seen < top) & (seen >= top - spread)).sum())
    return (top, count) if count > _OFTEN * near else (np.nan, 0)
