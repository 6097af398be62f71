"""Noise of a camera from a stack: gain, offset and read noise, hot voxels and cosmic rays."""

from __future__ import annotations

import math
from itertools import product
from typing import Any

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.units import with_error
from lommel.fit.findings import Finding
from lommel.recorded.counts import PlanePart, Stack, plane_of
from lommel.recorded.noise import Noise

_MIN_SIGMA = 10.0  # least excess of a hot voxel, standard deviations of the noise
_MIN_SHARPNESS = 2.0  # least excess of a hot voxel over its neighbours, relative to the image of a point
MAX_HOT_FRACTION = 1e-3
"""Largest fraction of hot voxels: more are points of light, sharper than a PSF that is too wide."""

_PERSISTENT = 8.0  # least mean excess of a hot pixel over the median of its neighbours, standard errors
_MOSTLY = 0.75  # least fraction of the planes in which a hot pixel exceeds the median of its neighbours
_MIN_ABOVE = 0.6  # least fraction of the planes in which a hot pixel exceeds all neighbours, unless _BUT_ONE applies
_BUT_ONE = 0.5  # least mean excess over all neighbours but one, relative to the mean excess over their median
_BAND = 16  # rows of a plane that are compared together: they stay in the cache
_PLANES_COMPARED = 32  # largest number of planes that are compared, evenly spaced
_MIN_PLANES = 5  # smallest number of planes in which hot pixels are detected
_PASSES = 3  # largest number of passes, each without the hot pixels found before
# Offsets of the eight neighbours, of the four that share a side, and of eight pixels at twice the distance.
_NEIGHBOURS = [(y, x) for y, x in product((-1, 0, 1), (-1, 0, 1)) if y or x]
_SIDES = [(y, x) for y, x in _NEIGHBOURS if 0 in (y, x)]
_FARTHER = [(2 * y, 2 * x) for y, x in _NEIGHBOURS]
# Comparisons that sort eight values, or the first four of them alone (Batcher 1968, doi:10.1145/1468075.1468121).
_COMPARISONS = (
    (0, 1), (2, 3), (0, 2), (1, 3), (1, 2), (4, 5), (6, 7), (4, 6), (5, 7), (5, 6),
    (0, 4), (1, 5), (2, 6), (3, 7), (2, 4), (3, 5), (1, 2), (3, 4), (5, 6),
)  # fmt: skip


def sharpness(psf: Array) -> float:
    """Return the ratio of the brightest voxel of a PSF to its brightest neighbour in the same plane."""
    plane, row, column = np.unravel_index(int(psf.argmax()), psf.shape)
    neighbours = psf[plane, max(row - 1, 0) : row + 2, max(column - 1, 0) : column + 2].copy()
    top = float(neighbours.max())
    neighbours[neighbours == top] = 0.0
    return top / max(float(neighbours.max()), 1e-12 * top)


def hot_pixels(stack: Stack, noise: Noise, sharpest: float, limit: float = math.inf) -> NDArray[np.bool_]:
    """Return a mask of hot pixels, which exceed all of their neighbours in most planes, whatever is in focus.

    A hot pixel exceeds the median of its eight neighbours by more than eight standard errors in the mean over the
    planes, and in three quarters of the planes. It also exceeds all neighbours in 60 % of the planes; or, since two
    hot pixels may be adjacent, its mean excess over all neighbours but one is more than half of its mean excess over
    the median. A point of light exceeds its neighbours only in the planes near its focus. A line of light along the
    axis exceeds them in all planes, but also lights them: the excess of a hot pixel is more than twice what
    the PSF allows for a point. Values from `limit` on, and NaN, are unknown.
    """
    noise = noise.poisson
    planes = np.unique(np.linspace(0, len(stack) - 1, min(len(stack), _PLANES_COMPARED)).astype(int))
    # A Gaussian that falls by the factor q from pixel to pixel falls by q^4 over two pixels. Its ratio of differences
    # is about q - 1 if pixels are coarse, and 1/3 if they are fine, where q - 1 would be far too small.
    point_ratio = sharpest**3 / (sharpest**2 + sharpest + 1.0)
    hot = np.zeros(stack.shape[1:], dtype=bool)
    if len(planes) < _MIN_PLANES:
        return hot
    for _ in range(_PASSES):
        new_hot = _further_hot_pixels(stack, planes, noise, limit, hot, _MIN_SHARPNESS * point_ratio)
        if not new_hot.any():
            break
        hot |= new_hot
    return hot


def hot_pixel_findings(hot: NDArray[np.bool_]) -> list[Finding]:
    """Return the finding on the hot pixels of a mask; none if there are none."""
    count, fraction = int(hot.sum()), float(hot.mean())
    verb = "exceeds its" if count == 1 else "exceed their"
    subject = f"{count} pixel{'s' * (count != 1)} ({100.0 * fraction:.2g} %)"
    text = f"{subject} {verb} neighbours in most planes, whatever is in focus: left out as hot"
    return [Finding("hot_pixels", "note", text, {"pixels": count, "share": fraction})] if count else []


def _further_hot_pixels(
    stack: Stack, planes: Array, noise: Noise, limit: float, hot: NDArray[np.bool_], max_ratio: float
) -> NDArray[np.bool_]:
    """Return a mask of hot pixels that are not in the mask `hot` yet."""
    gain = np.asarray(1.0 if noise.white is None else noise.white)
    total, steps, far_steps, counts, positive, above, but_one = (np.zeros(hot.shape) for _ in range(7))
    for plane in planes:
        recorded = np.asarray(stack[int(plane)], np.float64)
        known = np.isfinite(recorded) & (recorded < limit) & ~hot
        electrons = gain * (recorded - noise.offset)
        electrons = np.where(known, electrons, np.median(electrons[known]) if known.any() else 0.0)
        height, width = electrons.shape
        # Two pixels, for the neighbours at twice the distance.
        padded = np.pad(electrons, 2, mode="reflect")
        for top in range(0, height, _BAND):  # the neighbours of a whole plane would take a lot of memory
            band = np.s_[top : top + _BAND]
            here, rows = electrons[band], len(electrons[band])
            shifted = {
                (y, x): padded[top + 2 + y : top + 2 + y + rows, 2 + x : 2 + x + width]
                for y, x in _NEIGHBOURS + _FARTHER
            }
            near, sides, farther = (
                _sorted([shifted[place] for place in places]) for places in (_NEIGHBOURS, _SIDES, _FARTHER)
            )
            median, side, far = (_middle(values) for values in (near, sides, farther))
            # The variance of the median of eight values is about a fifth of the variance of one value.
            read = np.broadcast_to(noise.read, hot.shape)[band]
            sigma = np.sqrt(1.2 * (np.maximum(median, 1.0) + read**2))
            # Medians, because one of the neighbours may be hot, too.
            for values, sums in (
                ((here - median) / sigma, total), (here - side, steps), (side - far, far_steps),
                (1.0, counts), (here > median, positive), (here > near[-1], above),
                ((here - near[-2]) / sigma, but_one),
            ):  # fmt: skip
                sums[band] += np.where(known[band], values, 0.0)
    # A sum of n unit deviates has the standard deviation sqrt(n).
    is_significant = total > _PERSISTENT * np.sqrt(counts)
    is_frequent = (positive >= _MOSTLY * counts) & ((above > _MIN_ABOVE * counts) | (but_one > _BUT_ONE * total))
    return np.asarray(is_significant & is_frequent & (steps > max_ratio * far_steps) & (counts >= _MIN_PLANES))


def _sorted(values: list[Array]) -> list[Array]:
    """Sort the values of four or eight arrays at each place; `numpy.sort` takes four times as long."""
    for low, high in _COMPARISONS:
        if high < len(values):
            lower, higher = values[low], values[high]
            values[low], values[high] = np.minimum(lower, higher), np.maximum(lower, higher)
    return values


def _middle(values: list[Array]) -> Array:
    """Return the medians of an even number of sorted arrays."""
    half = len(values) // 2
    return np.asarray(0.5 * (values[half - 1] + values[half]))


def hot_voxels(stack: Stack, noise: Noise, sharpest: float, limit: float = math.inf) -> Array:
    """Return plane, row and column of the hot voxels of a stack, shape ``(n, 3)``.

    The excess of a hot voxel over the median of its plane is larger than twice `sharpest` times the excess of its
    brightest neighbour, plus ten standard deviations of the noise. Values from `limit` on, and NaN, are unknown.
    """
    noise = noise.poisson
    gain = np.asarray(1.0 if noise.white is None else noise.white)
    positions = []
    # The maximum of the eight neighbours is computed with -inf beyond the edge of a plane.
    for plane in range(len(stack)):
        recorded = np.asarray(stack[plane], dtype=np.float64)
        known = np.isfinite(recorded)
        values = np.where(known, recorded, -np.inf)
        height, width = values.shape
        padded = np.pad(values, 1, constant_values=-np.inf)
        neighbour = np.full_like(values, -np.inf)
        for y, x in product(range(3), range(3)):
            if (y, x) != (1, 1):
                np.maximum(neighbour, padded[y : y + height, x : x + width], out=neighbour)
        median = float(np.median(recorded[known])) if known.any() else 0.0
        # Photon noise of the voxel itself, but at least the noise of the background.
        electrons = np.maximum(gain * (np.maximum(values, median) - noise.offset), 0.0)
        threshold = _MIN_SIGMA * np.sqrt(electrons + np.asarray(noise.read) ** 2) / gain
        hot = (values < limit) & (
            values - median > _MIN_SHARPNESS * sharpest * np.maximum(neighbour - median, 0.0) + threshold
        )
        positions.append(np.column_stack([np.full(np.count_nonzero(hot), plane), *np.nonzero(hot)]))
    return np.concatenate(positions)


class StackView:
    """A stack whose unknown voxels are NaN or, in a stack of integers, have the value `limit`.

    Unknown voxels are listed in `voxels` (planes, rows and columns), or are True in a `mask`. With `is_reversed` its
    planes, masked in their own order, are in the reverse order.
    """

    def __init__(
        self,
        stack: Stack,
        limit: float,
        *,
        voxels: Array | None = None,
        mask: NDArray[np.bool_] | None = None,
        is_reversed: bool = False,
    ) -> None:
        self._is_reversed = is_reversed
        self.shape, self.dtype = stack.shape, stack.dtype
        self._stack, self._voxels = stack, np.zeros((0, 3), int) if voxels is None else voxels
        self._mask = np.broadcast_to(False if mask is None else mask, self.shape)
        is_integer = self.dtype.kind in "iu"
        # Integers have no NaN: the largest value marks unknown voxels, as saturation does.
        largest = int(np.iinfo(self.dtype).max) if is_integer else 0
        self.limit = min(limit, float(largest)) if is_integer else limit
        # The largest integer of 64 bits is not a float: as one it would be too large.
        self._unknown = self.dtype.type(min(math.ceil(self.limit), largest) if is_integer else math.nan)

    def __getstate__(self) -> dict[str, object]:
        return vars(self) | {"_mask": unrepeated(self._mask)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)
        self._mask = np.broadcast_to(self._mask, self.shape)

    def __len__(self) -> int:
        return int(self.shape[0])

    def __getitem__(self, index: PlanePart) -> Values:
        plane, *slices = index if isinstance(index, tuple) else (index,)
        plane = len(self) - 1 - plane if self._is_reversed else plane
        index = (plane, *slices)
        part: Values = np.array(self._stack[index])
        part[self._mask[index]] = self._unknown
        unknown = self._voxels[self._voxels[:, 0] == plane][:, 1:]
        for axis, part_slice in enumerate(slices):
            first, end, _ = part_slice.indices(self.shape[1 + axis])
            unknown = unknown[(unknown[:, axis] >= first) & (unknown[:, axis] < end)]
            unknown[:, axis] -= first
        part[unknown[:, 0], unknown[:, 1]] = self._unknown
        return part


def unrepeated(mask: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return a mask with length 1 along axes along which it is broadcast, which would be written out in pickles."""
    return mask[tuple(slice(0, 1) if step == 0 else slice(None) for step in mask.strides)]


_PLANES = 24  # largest number of planes that are used, evenly spaced
_POINTS = 4_000_000  # largest number of points in these planes that are used, evenly spaced
_READ = 1.6  # default read noise, rms electrons: it cannot be separated from the offset
_KERNEL = np.array([1.0, -2.0, 1.0])
_WINDOW = 5  # side of the window of a local mean, pixels
_STRUCTURE = 16.0  # squares that exceed this multiple of the variance are details, not noise
_SATURATED = 8  # least number of voxels with the largest value of a plane for which it counts as saturated
_MEDIAN = 0.4549  # median of the square of a normal deviate
_MAX_LOG_RATIO = 0.3  # difference of the logarithms of variances that details and rounding may cause
_MIN_NOISE = 1e-4  # least noise / light of an image: others are computed, not recorded
_MAX_ERROR = 0.3  # largest accepted relative standard error of the gain


def estimate_noise(stack: Stack, *, read: float = _READ, excess: float = 1.0) -> Noise:
    """Estimate gain and offset of the camera from a stack (photon transfer within the images).

    Parameters
    ----------
    stack : array_like, shape (planes, height, width)
        Recorded stack, neither smoothed nor resampled.
    read : float, default 1.6
        Read noise, rms electrons, from the data sheet: it cannot be separated from the offset in a stack alone.
    excess : float, default 1.0
        Excess noise factor, as in :class:`lommel.Noise`: it cannot be separated from the gain in a stack alone.

    Returns
    -------
    Noise
        Noise in the unit of `stack`. In simulated stacks of beads gains were right within their standard errors: 5 %
        with 250 000 voxels, 13 % with 33 000 voxels. A calibration is more accurate.

    Raises
    ------
    TypeError, ValueError
        If `stack` is of another shape, or its brightness varies too little to estimate a gain.

    Notes
    -----
    The variance is estimated from second differences along all three axes (of planes alone: Immerkaer 1996,
    doi:10.1006/cviu.1996.0060), because images of a microscope contain little of these high spatial frequencies. The
    most likely line of variance against local mean has the slope ``1 / white``, and is zero at
    ``offset - read**2 / white``.
    """
    factor = validation.real("excess", excess, least=1.0, most=100.0)
    fitted_noise = measured_noise(stack, validation.real("read", read, least=0.0) / factor)[0]
    # After multiplication electrons have `factor` times the Poisson variance: the fit has gain / factor.
    assert fitted_noise.white is not None
    return Noise(white=fitted_noise.white * factor, read=read, offset=fitted_noise.offset, excess=factor)


def measured_noise(stack: Stack, read: float = _READ) -> tuple[Noise, float]:
    """Return the noise, and the relative standard error of the gain."""
    sigma = validation.real("read", read, least=0.0)
    return _fit_noise(*_local_variances(stack), sigma)


def image_noise(image: Array) -> tuple[float, float, float]:
    """Return mean light and its noise variance in one image without offset, and the fraction of this for dark pixels.

    NaN pixels are unknown. Fine details count as noise. The fraction is 0 where it cannot be separated.
    """
    mean, squares, independent = _local_variances(image[None])
    constant, slope, error = _fit_line(mean, squares)
    light = float(mean.mean())
    variance = max(constant + slope * light, (_MIN_NOISE * light) ** 2)
    is_clear = slope * math.sqrt(independent) * _MAX_ERROR > error
    return light, variance, constant / variance if is_clear else 0.0


def _fit_noise(mean: Array, squares: Array, independent: float, sigma: float) -> tuple[Noise, float]:
    """Return the noise of points of a photon transfer curve, and the relative standard error of the gain."""
    # Light relative to the lowest mean: the constant of the line is then a variance within the data.
    lowest = float(np.quantile(mean, 1e-3))
    constant, slope, error = _fit_line(mean - lowest, squares)
    error /= math.sqrt(independent)
    if not slope > 0.0 or error > _MAX_ERROR * slope:
        raise ValueError(
            "the noise cannot be estimated: its variance does not clearly grow with the light, as photon "
            "noise does; give a stack that was not filtered and has brighter and darker regions, or the noise of the "
            "camera from its data sheet, such as white=0.46, read=1.6, offset=100"
        )
    # variance = (mean - offset) / gain + (read / gain)^2, solved for the offset; slope is 1 / gain.
    offset = lowest - constant / slope + sigma**2 * slope
    return Noise(white=1.0 / slope, read=sigma, offset=min(offset, lowest)), error / slope


def contradiction(stack: Stack, noise: Noise) -> str | None:
    """Return a sentence if the noise of a stack differs significantly from the noise of a camera, else None."""
    try:
        mean, squares, independent = _local_variances(stack)
    except ValueError:  # too small
        return None
    poisson = noise.poisson
    parameters = poisson.white, poisson.read, poisson.offset
    white, read, offset = (float(np.mean(1.0 if value is None else value)) for value in parameters)
    # Variance of rounding to integers: 1 / 12.
    rounding = 1.0 / 12.0 if np.dtype(stack.dtype).kind in "iu" else 0.0
    expected = np.maximum(mean - offset, 0.0) / white + (read / white) ** 2 + rounding
    # The median is hardly affected by details, which are not noise.
    ratio = float(np.median(squares / expected)) / _MEDIAN
    # The relative standard error of the median of squared normal deviates is about 2.3 / sqrt(n).
    error = ratio * 2.3 / math.sqrt(mean.size * independent)
    if ratio > 0.0 and abs(math.log(ratio)) < max(_MAX_LOG_RATIO, 4.0 * error):
        return None
    text = (
        f"The noise of the stack has {ratio:.2g} times the variance that gain, read noise and offset imply: check "
        "these values."
    )
    try:
        fitted_noise, relative_error = _fit_noise(mean, squares, independent, read)
    except ValueError:
        return text
    gain = noise.excess * float(1.0 if fitted_noise.white is None else fitted_noise.white)
    gain_text = " +- ".join(with_error(gain, gain * relative_error))
    offset_text = f"an offset of {float(fitted_noise.offset):.4g}"
    return f"{text} The estimate from the stack alone is {gain_text} electrons per count and {offset_text}."


def _local_variances(stack: Stack) -> tuple[Array, Array, float]:
    """Return local means, squares of the noise at the same points, and the fraction of independent squares."""
    stack = validation.computed(stack)
    validation.refuse_masked("stack", stack)
    shape = np.shape(stack)
    if len(shape) != 3:
        raise ValueError(f"stack must have the shape (planes, height, width), got {shape}")
    adjacent = 1 if shape[0] >= 3 else 0
    places = np.linspace(adjacent, shape[0] - 1 - adjacent, min(_PLANES, shape[0] - 2 * adjacent)).astype(int)
    axes = (0, 1, 2) if adjacent else (1, 2)
    pairs: list[Array] = []
    for place in np.unique(places):
        planes = np.array([plane_of(stack, int(k)) for k in range(place - adjacent, place + adjacent + 1)], float)
        top = np.fmax.reduce(planes, axis=None)  # NaN if all values are unknown
        if (planes == top).sum() >= _SATURATED:
            planes[planes == top] = np.nan
        differences = planes
        for axis in axes:
            # Second differences along each axis remove smooth light; divided by the norm, the noise keeps its
            # variance.
            differences = scipy.ndimage.convolve1d(differences, _KERNEL, axis=axis) / math.sqrt(
                float(_KERNEL @ _KERNEL)
            )
            if axis == 0:
                differences = differences[1:2]
        mean = planes
        for axis in (1, 2):  # not by running sums, which carry an unknown value on to the end of its row
            mean = scipy.ndimage.convolve1d(mean, np.full(_WINDOW, 1.0 / _WINDOW), axis=axis)
        if adjacent:
            # Second differences weight the variances of three planes by 1, 4, 1: weight the mean in the same way.
            mean = scipy.ndimage.convolve1d(mean, _KERNEL**2 / (_KERNEL @ _KERNEL), axis=0)
        pair = np.stack([mean[adjacent, 2:-2, 2:-2], differences[0, 2:-2, 2:-2] ** 2])
        known = pair[:, np.isfinite(pair).all(axis=0)]
        pairs.append(known[:, :: max(1, math.ceil(known.shape[1] * len(places) / _POINTS))].copy())
    mean, squares = np.concatenate(pairs, axis=1)
    if not mean.size:
        raise ValueError(
            "stack must have 6 rows and columns or more whose values are known: pixels with the largest value of a "
            "plane, if there are several, count as saturated"
        )
    correlation = np.correlate(_KERNEL, _KERNEL, "full")
    # Neighbouring second differences are correlated, which reduces the number of independent squares.
    return mean, squares, float((correlation.max() ** 2 / (correlation @ correlation)) ** len(axes))


def _fit_line(light: Array, squares: Array) -> tuple[float, float, float]:
    """Return constant and slope of the most likely line of variance against light, and the error of the slope."""
    constant, slope = float(squares.mean()), 0.0
    error = math.inf
    if constant == 0.0:  # equal planes
        return constant, slope, error
    for _ in range(50):
        variance = constant + slope * light
        # A squared deviate has the variance 2 variance^2, hence these weights; details have the weight 0.
        weight = (squares < _STRUCTURE * variance) / variance**2
        normal = np.array([[weight.sum(), weight @ light], [weight @ light, weight @ light**2]])
        try:
            covariance = 2.0 * np.linalg.inv(normal)
        except np.linalg.LinAlgError:  # light is the same everywhere
            return constant, 0.0, math.inf
        previous_slope, error = slope, math.sqrt(covariance[1, 1])
        constant, slope = 0.5 * covariance @ [weight @ squares, weight @ (light * squares)]
        # Positive, so that the variance of the darkest points is positive.
        constant = max(constant, 1e-3 * float(squares.mean()))
        slope = max(slope, 0.0)
        if abs(slope - previous_slope) <= 1e-6 * abs(slope):
            break
    return constant, float(slope), error
