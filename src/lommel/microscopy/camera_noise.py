"""Gain, offset and read noise of a camera, estimated from a stack that it recorded."""

from __future__ import annotations

from typing import Any

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.estimation.noise import Noise

_BINS = 24
_LEAST = 500  # pixels of a bin
_PLANES = 24  # that are looked at
_READ = 1.6  # rms electrons, where the offset cannot be told from the read noise
_SPAN = 1.5  # of the variance of the brightest bin over that of the dimmest, for a slope


def estimate_noise(stack: Any, *, read: float = _READ) -> Noise:
    """Estimate gain and offset of the camera from a stack (photon transfer within the images).

    Parameters
    ----------
    stack : array_like, shape (planes, height, width)
        As recorded, neither smoothed nor resampled.
    read : float, default 1.6
        Read noise, rms electrons, as of a data sheet: a stack alone does not separate it from the offset.

    Returns
    -------
    Noise
        Of the unit of `stack`. In simulated stacks gains were 0.5 to 13 % low, and 21 % in one of bright beads;
        detail finer than two pixels counts as noise. It is not as good as a calibration.

    Raises
    ------
    TypeError, ValueError
        If `stack` is of another shape, or hardly differs in brightness, so that a gain cannot be found.

    Notes
    -----
    The variance in the highest spatial frequencies, which an image in focus hardly has (Immerkaer 1996,
    doi:10.1006/cviu.1996.0060), against the local mean: a line of slope ``1 / white``, whose zero is
    ``offset - read**2 / white``. A robust width (of quartiles) is used in each of 24 bins of the mean.
    """
    sigma = validation.real("read", read, least=0.0)
    means, variances, counts = _points(stack)
    if len(means) < 3 or variances.max() < _SPAN * variances[0]:
        raise ValueError(
            "the noise cannot be estimated from a stack that is as bright everywhere; give noise=, such as "
            "lommel.Noise(white=0.46, read=1.6, offset=100) from the data sheet of the camera"
        )
    slope, constant = _line(means, variances, counts)
    if not slope > 0.0:
        raise ValueError(
            "the noise cannot be estimated: its variance does not grow with the light, as that of photons does; give "
            "noise=, and a stack that was not filtered"
        )
    offset = -constant / slope + sigma**2 * slope
    lowest = float(means[0])
    return Noise(white=1.0 / slope, read=sigma, offset=min(offset, lowest))


def _points(stack: Any) -> tuple[Array, Array, Array]:
    """Return local means, and the variances of the noise at these, of bins."""
    from scipy.ndimage import uniform_filter

    shape = np.shape(stack)
    if len(shape) != 3:
        raise ValueError(f"stack must have the shape (planes, height, width), got {shape}")
    places = np.unique(np.linspace(0, shape[0] - 1, min(_PLANES, shape[0])).astype(int))
    found: list[Array] = []
    for place in places:
        plane = np.asarray(stack[int(place)], np.float64)
        high = plane - np.roll(plane, 1, 0)
        high = high - np.roll(high, 1, 1)
        high = (high - np.roll(high, -1, 0))[2:-2, 2:-2]
        # Of differences (1, -2, 1) down and (1, -1) across: 6 times 2 the variance of a pixel.
        mean = uniform_filter(plane, 5)[2:-2, 2:-2]
        # Where it is flat, for sharp detail is no noise.
        rough = np.abs(uniform_filter(plane, 3)[2:-2, 2:-2] - mean)
        known = np.isfinite(high) & np.isfinite(mean)
        found.append(np.stack([mean[known], high[known] / np.sqrt(12.0), rough[known]]))
    mean, high, rough = np.concatenate(found, axis=1)
    if not mean.size:
        raise ValueError("stack must have 6 rows and columns or more whose values are known")
    low, top = np.quantile(mean, [0.001, 0.9995])
    edges = low + (top - low) * np.linspace(0.0, 1.0, _BINS + 1) ** 2.5  # most pixels are dark
    number = np.clip(np.digitize(mean, edges) - 1, 0, _BINS - 1)
    inside = (mean >= low) & (mean <= top)
    rows = []
    for each in range(_BINS):
        chosen = inside & (number == each)
        if chosen.sum() < _LEAST:
            continue
        calm = chosen & (rough <= np.quantile(rough[chosen], 0.2))
        quarters = np.quantile(high[calm], [0.25, 0.75])
        rows.append((mean[calm].mean(), (np.ptp(quarters) / 1.3489795) ** 2, calm.sum()))
    means, variances, counts = np.array(rows).reshape(-1, 3).T
    return means, variances, counts


def _line(means: Array, variances: Array, counts: Array) -> tuple[float, float]:
    """Return slope and constant of the line through variances, whose own errors grow with them."""
    keep = np.ones(len(means), dtype=bool)
    slope = constant = 0.0
    for _ in range(4):
        weight = np.sqrt(counts) / np.maximum(variances, 1e-30)
        slope, constant = np.polyfit(means[keep], variances[keep], 1, w=weight[keep])
        line = slope * means + constant
        # Structure adds to the variance, and nothing takes from it.
        keep = variances < 1.25 * np.maximum(line, 1e-30)
        if keep.sum() < 3:
            break
    return float(slope), float(constant)
