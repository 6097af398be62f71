"""Noise of a camera from a stack: gain, offset and read noise, hot voxels and cosmic rays."""

from __future__ import annotations

import math
from itertools import product

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.units import with_error
from lommel.recorded.counts import PlanePart, Stack, plane_of
from lommel.recorded.noise import Noise

_SURE = 10.0  # standard deviations of the noise that the excess of a hot voxel has at least,
_SHARPER = 2.0  # and times the largest excess of a point over its neighbours that the PSF allows
MOST = 1e-3
"""Of all voxels, that single events are: more are points of light, sharper than PSFs that are too wide."""

_PERSISTENT = 8.0  # standard errors of the mean excess over all planes above the neighbours
_MOSTLY = 0.75  # share of the planes in which a hot pixel exceeds the median of its neighbours,
_ABOVE = 0.6  # and share in which it exceeds them all;
_BUT_ONE = 0.5  # or mean excess above all but one, which may be hot too, over that above the median
_PLANES_COMPARED = 32  # planes that are compared, evenly spaced
_FEW = 5  # planes: with fewer nothing counts as persistent
_PASSES = 3  # passes, each without the hot pixels of the last
# The eight neighbours, those of them that share a side, and the ring at twice the distance.
_NEAR = [(y, x) for y, x in product((-1, 0, 1), (-1, 0, 1)) if y or x]
_SIDES = [(y, x) for y, x in _NEAR if 0 in (y, x)]
_NEXT = [(2 * y, 2 * x) for y, x in _NEAR]


def sharpness(psf: Array) -> float:
    """Return the brightest voxel of a PSF over the next brightest around it in its plane."""
    plane, row, column = np.unravel_index(int(psf.argmax()), psf.shape)
    around = psf[plane, max(row - 1, 0) : row + 2, max(column - 1, 0) : column + 2].copy()
    top = float(around.max())
    around[around == top] = 0.0
    return top / max(float(around.max()), 1e-12 * top)


def hot_pixels(stack: Stack, noise: Noise, sharpest: float, limit: float = math.inf) -> NDArray[np.bool_]:
    """Return which pixels are hot: above all of their neighbours in most planes, whatever is in focus there.

    A pixel exceeds the median of its eight neighbours by more than eight standard errors in the mean over the planes;
    it is above that median in three quarters of the planes, and above all neighbours in 60 %, or exceeds all
    but one of them by half as much as the median: two hot pixels may be beside each other. A point of light is so
    in the planes near its focus alone. A line of light along the optical axis is so in all, but lights its
    neighbours, too: a hot pixel exceeds these by more than twice what the PSF lets a point exceed them.
    Values from the `limit` on, and NaN, are unknown.
    """
    planes = np.unique(np.linspace(0, len(stack) - 1, min(len(stack), _PLANES_COMPARED)).astype(int))
    hot = np.zeros(stack.shape[1:], dtype=bool)
    if len(planes) < _FEW:
        return hot
    for _ in range(_PASSES):
        found = _persistent(stack, planes, noise, limit, hot, _SHARPER * (sharpest - 1.0))
        if not found.any():
            break
        hot |= found
    return hot


def _persistent(
    stack: Stack, planes: Array, noise: Noise, limit: float, hot: NDArray[np.bool_], steepest: float
) -> NDArray[np.bool_]:
    """Return hot pixels besides the known ones."""
    gain = np.asarray(1.0 if noise.white is None else noise.white)
    total, steps, slopes, seen, positive, above, but_one = (np.zeros(hot.shape) for _ in range(7))
    for plane in planes:
        given = np.asarray(stack[int(plane)], np.float64)
        known = np.isfinite(given) & (given < limit) & ~hot
        light = gain * (given - noise.offset)
        light = np.where(known, light, np.median(light[known]) if known.any() else 0.0)
        height, width = light.shape
        # Two pixels for the ring at twice the distance.
        padded = np.pad(light, 2, mode="reflect")
        at = {(y, x): padded[2 + y : 2 + y + height, 2 + x : 2 + x + width] for y, x in _NEAR + _NEXT}
        near = np.sort([at[place] for place in _NEAR], axis=0)
        middle = 0.5 * (near[3] + near[4])
        # That of the median of eight is a fifth of that of one.
        noisy = np.sqrt(1.2 * (np.maximum(middle, 1.0) + np.asarray(noise.read) ** 2))
        # Medians, as one of these may be hot, too.
        sides, beyond = (np.median([at[place] for place in places], axis=0) for places in (_SIDES, _NEXT))
        for values, sums in (
            ((light - middle) / noisy, total), (light - sides, steps), (sides - beyond, slopes), (1.0, seen),
            (light > middle, positive), (light > near[-1], above), ((light - near[-2]) / noisy, but_one),
        ):  # fmt: skip
            sums += np.where(known, values, 0.0)
    # A sum of n unit deviates has the standard deviation sqrt(n).
    sure = total > _PERSISTENT * np.sqrt(seen)
    often = (positive >= _MOSTLY * seen) & ((above > _ABOVE * seen) | (but_one > _BUT_ONE * total))
    return np.asarray(sure & often & (steps > steepest * slopes) & (seen >= _FEW))


def hot_voxels(stack: Stack, noise: Noise, sharpest: float, limit: float = math.inf) -> Array:
    """Return plane, row and column of the hot voxels of a stack, shape ``(n, 3)``.

    A voxel is one where its excess over the median of the plane is more than twice `sharpest` times that of the
    brightest of its eight neighbours, and ten standard deviations of the noise besides. Values from the `limit` on,
    and NaN, are unknown.
    """
    noise = noise.poisson
    gain = np.asarray(1.0 if noise.white is None else noise.white)
    found = []
    # The largest of eight neighbours; beyond the edge there is none.
    for plane in range(len(stack)):
        given = np.asarray(stack[plane], dtype=np.float64)
        known = np.isfinite(given)
        values = np.where(known, given, -np.inf)
        height, width = values.shape
        padded = np.pad(values, 1, constant_values=-np.inf)
        near = np.full_like(values, -np.inf)
        for y, x in product(range(3), range(3)):
            if (y, x) != (1, 1):
                np.maximum(near, padded[y : y + height, x : x + width], out=near)
        base = float(np.median(given[known])) if known.any() else 0.0
        # Photon noise of the voxel itself, not below that of the background.
        counted = np.maximum(gain * (np.maximum(values, base) - noise.offset), 0.0)
        sure = _SURE * np.sqrt(counted + np.asarray(noise.read) ** 2) / gain
        hot = (values < limit) & (values - base > _SHARPER * sharpest * np.maximum(near - base, 0.0) + sure)
        found.append(np.column_stack([np.full(np.count_nonzero(hot), plane), *np.nonzero(hot)]))
    return np.concatenate(found)


class LeftOut:
    """A stack with unknown voxels: NaN, or, of integers, not below `limit`.

    These are `voxels`, an array of their planes, rows and columns, and those of a `mask` of all planes, or of each.
    """

    def __init__(
        self, stack: Stack, limit: float, *, voxels: Array | None = None, mask: NDArray[np.bool_] | None = None
    ) -> None:
        self.shape, self.dtype = stack.shape, stack.dtype
        self._stack, self._voxels = stack, np.zeros((0, 3), int) if voxels is None else voxels
        self._mask = np.broadcast_to(False if mask is None else mask, self.shape)
        whole = self.dtype.kind in "iu"
        # Integers have no NaN: the largest value marks unknown voxels, as saturation does.
        self.limit = min(limit, float(np.iinfo(self.dtype).max)) if whole else limit
        self._unknown = self.dtype.type(self.limit if whole else math.nan)

    def __len__(self) -> int:
        return int(self.shape[0])

    def __getitem__(self, at: PlanePart) -> Values:
        plane, *rest = at if isinstance(at, tuple) else (at,)
        part: Values = np.array(self._stack[at])
        part[self._mask[at]] = self._unknown
        here = self._voxels[self._voxels[:, 0] == plane][:, 1:]
        for axis, each in enumerate(rest):
            first, end, _ = each.indices(self.shape[1 + axis])
            here = here[(here[:, axis] >= first) & (here[:, axis] < end)]
            here[:, axis] -= first
        part[here[:, 0], here[:, 1]] = self._unknown
        return part


_PLANES = 24  # planes that are used, evenly spaced
_POINTS = 4_000_000  # points of these that are used, evenly spaced: enough, and little memory
_READ = 1.6  # rms electrons: default, as the offset cannot be separated from the read noise
_KERNEL = np.array([1.0, -2.0, 1.0])
_WINDOW = 5  # pixels a side of the local mean, whose planes have the weights of the variance
_STRUCTURE = 16.0  # times the variance: larger squares are details, not noise
_SATURATED = 8  # voxels at the largest value of a plane from which on it counts as saturation
_MEDIAN = 0.4549  # median of the square of a normal deviate
_DIFFERENT = 0.3  # difference of the logarithms of variances that details and rounding may cause
_UNSURE = 0.3  # relative standard error above which the gain is of no use


def estimate_noise(stack: Stack, *, read: float = _READ, excess: float = 1.0) -> Noise:
    """Estimate gain and offset of the camera from a stack (photon transfer within the images).

    Parameters
    ----------
    stack : array_like, shape (planes, height, width)
        As recorded, neither smoothed nor resampled.
    read : float, default 1.6
        Read noise, rms electrons, as of a data sheet: a stack alone does not separate it from the offset.
    excess : float, default 1.0
        As of :class:`lommel.Noise`: a stack alone does not separate it from the gain.

    Returns
    -------
    Noise
        Of the unit of `stack`. In simulated stacks of beads gains were within their standard errors: 5 % with
        250 000 voxels, 13 % with 33 000. It is not as good as a calibration.

    Raises
    ------
    TypeError, ValueError
        If `stack` is of another shape, or hardly differs in brightness, so that a gain cannot be found.

    Notes
    -----
    The variance in the highest spatial frequencies along all three axes, which an image of a microscope hardly has
    (second differences; of planes alone Immerkaer 1996, doi:10.1006/cviu.1996.0060), against the local mean: the most
    likely line of slope ``1 / white``, whose zero is ``offset - read**2 / white``.
    """
    factor = validation.real("excess", excess, least=1.0, most=100.0)
    found = measured_noise(stack, validation.real("read", read, least=0.0) / factor)[0]
    # Electrons after multiplication have `excess` times the variance of Poisson's: gain and read noise by it.
    assert found.white is not None
    return Noise(white=found.white * factor, read=read, offset=found.offset, excess=factor)


def measured_noise(stack: Stack, read: float = _READ) -> tuple[Noise, float]:
    """Return the noise, and the relative standard error of the gain."""
    sigma = validation.real("read", read, least=0.0)
    return _fitted(*_points(stack), sigma)


def _fitted(mean: Array, squares: Array, independent: float, sigma: float) -> tuple[Noise, float]:
    """Return the noise of points of a photon transfer curve, and the relative standard error of the gain."""
    # Light from the lowest on: the constant of the line is then a variance within the data.
    lowest = float(np.quantile(mean, 1e-3))
    constant, slope, error = _line(mean - lowest, squares)
    error /= math.sqrt(independent)
    if not slope > 0.0 or error > _UNSURE * slope:
        raise ValueError(
            "the noise cannot be estimated: its variance does not clearly grow with the light, as that of photons "
            "does; give a stack that was not filtered and has brighter and darker places, or noise=, such as "
            "lommel.Noise(white=0.46, read=1.6, offset=100) from the data sheet of the camera"
        )
    # variance = (mean - offset) / gain + (read / gain)^2, solved for the offset; slope is 1 / gain.
    offset = lowest - constant / slope + sigma**2 * slope
    return Noise(white=1.0 / slope, read=sigma, offset=min(offset, lowest)), error / slope


def contradiction(stack: Stack, noise: Noise) -> str | None:
    """Return in words how the noise of a stack differs from that of a camera by more than their errors, or None."""
    try:
        mean, squares, independent = _points(stack)
    except ValueError:  # too small
        return None
    plain = noise.poisson
    given = plain.white, plain.read, plain.offset
    white, read, offset = (float(np.mean(1.0 if each is None else each)) for each in given)
    # Variance of rounding to integers: 1 / 12.
    rounded = 1.0 / 12.0 if np.dtype(stack.dtype).kind in "iu" else 0.0
    expected = np.maximum(mean - offset, 0.0) / white + (read / white) ** 2 + rounded
    # The median is not that of details, which are no noise.
    ratio = float(np.median(squares / expected)) / _MEDIAN
    # The standard error of the median of squared normal deviates, over it, is about 2.3 / sqrt(n).
    error = ratio * 2.3 / math.sqrt(mean.size * independent)
    if abs(math.log(ratio)) < max(_DIFFERENT, 4.0 * error):
        return None
    said = (
        f"The noise of the stack has {ratio:.2g} times the variance that gain, read noise and offset imply: are "
        "these right?"
    )
    try:
        found, relative = _fitted(mean, squares, independent, read)
    except ValueError:
        return said
    gain = noise.excess * float(1.0 if found.white is None else found.white)
    alone = " +- ".join(with_error(gain, gain * relative))
    return f"{said} The stack alone gives {alone} electrons per count and an offset of {float(found.offset):.4g}."


def _points(stack: Stack) -> tuple[Array, Array, float]:
    """Return local means, squares of the noise there, and the share of independent squares."""
    from scipy.ndimage import convolve1d, uniform_filter

    stack = validation.computed(stack)
    validation.refuse_masked("stack", stack)
    shape = np.shape(stack)
    if len(shape) != 3:
        raise ValueError(f"stack must have the shape (planes, height, width), got {shape}")
    beside = 1 if shape[0] >= 3 else 0
    places = np.linspace(beside, shape[0] - 1 - beside, min(_PLANES, shape[0] - 2 * beside)).astype(int)
    axes = (0, 1, 2) if beside else (1, 2)
    found: list[Array] = []
    for place in np.unique(places):
        planes = np.array([plane_of(stack, int(k)) for k in range(place - beside, place + beside + 1)], float)
        top = np.nanmax(planes)
        if (planes == top).sum() >= _SATURATED:
            planes[planes == top] = np.nan
        high = planes
        for axis in axes:
            # Second differences along each axis remove smooth light; divided by the norm, the noise keeps its
            # variance.
            high = convolve1d(high, _KERNEL, axis=axis) / math.sqrt(float(_KERNEL @ _KERNEL))
        mean = uniform_filter(planes, (1, _WINDOW, _WINDOW))
        if beside:
            # The variance is that of three planes with the weights 1, 4, 1: the mean as well.
            mean = convolve1d(mean, _KERNEL**2 / (_KERNEL @ _KERNEL), axis=0)
        pair = np.stack([mean[beside, 2:-2, 2:-2], high[beside, 2:-2, 2:-2] ** 2])
        known = pair[:, np.isfinite(pair).all(axis=0)]
        found.append(known[:, :: max(1, math.ceil(known.shape[1] * len(places) / _POINTS))].copy())
    mean, squares = np.concatenate(found, axis=1)
    if not mean.size:
        raise ValueError("stack must have 6 rows and columns or more whose values are known")
    shared = np.correlate(_KERNEL, _KERNEL, "full")
    # Neighbouring second differences are correlated: the squares count as fewer independent ones.
    return mean, squares, float((shared.max() ** 2 / (shared @ shared)) ** len(axes))


def _line(light: Array, squares: Array) -> tuple[float, float, float]:
    """Return constant and slope of the likeliest variance as a line in light, and the slope's standard error."""
    constant, slope = float(squares.mean()), 0.0
    error = math.inf
    for _ in range(50):
        variance = constant + slope * light
        # A square has the variance 2 variance^2: weights of maximum likelihood, without details.
        weight = (squares < _STRUCTURE * variance) / variance**2
        normal = np.array([[weight.sum(), weight @ light], [weight @ light, weight @ light**2]])
        try:
            covariance = 2.0 * np.linalg.inv(normal)
        except np.linalg.LinAlgError:  # light is the same everywhere
            return constant, 0.0, math.inf
        before, error = slope, math.sqrt(covariance[1, 1])
        constant, slope = 0.5 * covariance @ [weight @ squares, weight @ (light * squares)]
        # Positive, so that the variance of the darkest points stays so.
        constant = max(constant, 1e-3 * float(squares.mean()))
        slope = max(slope, 0.0)
        if abs(slope - before) <= 1e-6 * abs(slope):
            break
    return constant, float(slope), error
