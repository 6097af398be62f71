r"""Detection of molecules: spots of light above the background, and boxes around them.

Frames of electrons d are smoothed by a kernel k of sum 0, a narrow Gaussian N minus a wide one W. For molecules, k is
``N - (1 + a) W + a W * W``, where * is a convolution and ``a = 1 - (width of N / width of W)^2``: its second moment
is 0, so that backgrounds with the shape of a parabola, as in the middle of a smooth hump, yield 0. In a region of
background, e = sum k d has the variance ``m sum k^2`` and the third moment ``m sum k^3``, where m is the background
(smoothed by the wide Gaussian) plus the read variance, in electrons. A scaled Poisson variable has the same moments
if its mean is ``lambda = m sum k^2 / a^2`` and its scale ``a = sum k^3 / sum k^2``. The score of a spot is the signed
root of the likelihood ratio of this variable (Cash 1979, doi:10.1086/156922):

.. math:: s = \sqrt{2 \bigl((\lambda + e/a) \ln(1 + e/(a \lambda)) - e/a\bigr)}

for e > 0. The score is nearly normal even for a few electrons per pixel, unlike e divided by its standard deviation.
For a smooth normal field, the expected number of maxima above a threshold u, per pixel, is (Adler 1981, The Geometry
of Random Fields, 6.9)

.. math:: \Lambda \, (2 \pi)^{-3/2} \, u \, e^{-u^2 / 2}, \qquad
          \Lambda = \int (\partial_x k)^2 \big/ \int k^2 .
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, reduce
from typing import Any

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.threads import product, side_by_side
from lommel.recorded.counts import Counts, counts_of
from lommel.recorded.noise import Noise

_MIN_MEAN = 1e-3  # smallest mean of a pixel, electrons
_TRUNCATION = 4.0  # half-width of kernels, standard deviations
_MIN_KNOWN = 1e-3  # fraction of the kernel's weight on known pixels, below which a pixel has no known neighbours
_BLOCK = 32  # columns of an image that are smoothed together
APART = 1.0 - 1e-9  # smallest distance of boxes that do not overlap, in sides of a box
_NEIGHBOR, _ISOLATED = 4.0, 0.75  # smallest score of a neighbour, and its largest distance in boxes
_MIN_FRAMES, _MAX_FRAMES = 10, 20  # numbers of frames whose median is the background that stays
DEFECT = 1e3  # smallest read noise of a defective pixel, electrons


@dataclass(frozen=True, eq=False)
class Spots:
    """Molecules found in frames, and the boxes around them.

    Attributes
    ----------
    frame : ndarray of int, shape (n,)
        Number of the frame, counted from `first` of :func:`lommel.localize.find`; in increasing order.
    row, column : ndarray of int, shape (n,)
        First pixel of the box; its centre is pixel ``rows // 2, columns // 2`` of the box.
    score : ndarray, shape (n,)
        Height above the background in standard deviations of the background noise.
    images : ndarray, shape (n, rows, columns)
        Boxes cut from the frames, in the unit and type of the frames. If frames have saturated or unknown pixels,
        boxes are floats, with NaN at these pixels.
    borders, overlapping : int
        Numbers of spots left out because the box extends beyond the frame, or overlaps the box of a brighter spot
        (another molecule, or another part of the same image).
    saturated, left_out : int
        Numbers of pixels of the boxes that are saturated, and that are NaN, infinite or masked.
    false_spots : float
        Expected number of spots in a frame from noise alone.
    isolated : ndarray of bool, shape (n,)
        False for a spot with another maximum above four standard deviations within three quarters of a box.
    """

    frame: NDArray[np.int64]
    row: NDArray[np.int64]
    column: NDArray[np.int64]
    score: Array
    images: Values
    borders: int
    overlapping: int
    saturated: int
    left_out: int
    false_spots: float
    isolated: NDArray[np.bool_]

    @property
    def corners(self) -> NDArray[np.int64]:
        """Row and column of the first pixel of each box, shape (n, 2), for fits with maps of the camera."""
        return np.column_stack([self.row, self.column])

    def __len__(self) -> int:
        return self.frame.size

    def __repr__(self) -> str:
        omitted = f"{self.borders} at borders and {self.overlapping} overlapping left out"
        return f"<Spots: {len(self)} in boxes of {' x '.join(map(str, self.images.shape[1:]))}; {omitted}>"


def find(
    frames: ArrayLike | Counts,
    box: int | tuple[int, int] = 15,
    *,
    noise: Noise | None = None,
    threshold: float = 6.0,
    width: float = 2.0,
    first: int = 0,
    threads: int | None = None,
) -> Spots:
    """Find spots of light above the background, and cut a box around each.

    Parameters
    ----------
    frames : array_like or Counts, shape (frames, rows, columns) or (rows, columns)
        Recorded frames, in the unit of `noise`. NaN, infinite and masked values are ignored. Saturated pixels are
        used in the search, and are NaN in boxes: by default those with the largest value of the integer type or, if
        many pixels have the largest value of 8 to 16 bits, with this value; :class:`lommel.Counts` state another.
    box : int or (int, int), default 15
        Rows and columns of the boxes.
    noise : Noise, optional
        Gain, offset and read noise of the camera, each a number or a map of the frame. By default frames are in
        electrons without read noise. Pixels with a read noise of 1000 electrons or more are defects, and ignored.
    threshold : float, default 6.0
        Minimum height of a spot in standard deviations of the background noise, at least 3.
    width : float, default 2.0
        Standard deviation of the smoothing in pixels, at most a quarter of the box. It should be about that of the
        images of molecules, so that an elongated image has a single maximum, in the middle. The background is
        smoothed with a standard deviation of a third of the box.
    first : int, default 0
        Number of the first frame.
    threads : int, optional
        Maximum number of threads; by default the number of processors.

    Returns
    -------
    Spots
        If the boxes of two spots overlap, only the brighter spot is kept. A background without structure yields at
        most `false_spots` spots per frame: for a threshold of 6.0, one in 3700 frames of 512 x 512 pixels.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or frames are smaller than the box or have no valid pixel.

    Notes
    -----
    Detection uses a difference of Gaussians and the likelihood ratio of a Poisson variable, so that a threshold has
    the same meaning for dim and bright backgrounds and for any read noise. Equations and references are in the
    docstring of the module. Of 10 frames or more, the response to the median frame is subtracted where it is above
    the noise of a frame: a hump of background is no spot, and a bead stays one. An image with several bright parts,
    due to strong aberrations, is one spot if a box contains all parts.

    Examples
    --------
    >>> rng = np.random.default_rng(1)
    >>> frames = rng.poisson(5.0, (2, 64, 64))
    >>> frames[1, 30:33, 40:43] += 60
    >>> spots = find(frames, 15)
    >>> spots.frame, spots.row + 7, spots.column + 7
    (array([1]), array([31]), array([41]))
    """
    rows, columns = box = validation.image_shape(box, "box")
    counts = frame_counts(frames, box)
    start = validation.integer("first", first, least=0, most=validation.MAX_VALUES)
    thread_count = 0 if threads is None else validation.integer("threads", threads, least=1, most=1024)
    level = validation.real("threshold", threshold, least=3.0, most=1e3)
    narrow = validation.real("width", width, least=0.5, most=min(rows, columns) / 4.0)
    validation.optional("noise", noise, Noise)
    camera_noise = (noise or counts.noise or Noise(read=0.0)).require_shape(counts.values.shape)
    # With a third of the box, a molecule hardly increases its own background.
    camera, wide = camera_noise.poisson, min(rows, columns) / 3.0
    electrons, read = camera.electrons(filled(counts.values, counts.hidden, narrow)), camera.read
    defects = np.zeros(electrons.shape[1:], bool)
    if not isinstance(read, float):
        defects = np.asarray(camera_noise.read) >= DEFECT
        if defects.all():
            raise ValueError(
                f"read must be below {DEFECT:g} electrons for pixels that are not defects, got no such pixel"
            )
        read = np.where(defects, np.median(read[~defects]), read)
    kernel = Kernel(electrons.shape[1:], narrow, wide, flat=False)
    variance = np.full(electrons.shape[1:], read**2) if isinstance(read, float) else kernel.squared(read**2)

    known_fraction, steady = smoothed(1.0 - defects, narrow), np.zeros(())
    if len(electrons) >= _MIN_FRAMES:
        # The background that stays, without structure as narrow as a bead; molecules blink. Its excess is taken off
        # from one standard deviation on, all from two: that is nowhere in a background without structure.
        median = np.median(electrons[:: -(-len(electrons) // _MAX_FRAMES)], axis=0)
        still = smoothed(filled(median[None], defects[None], narrow, known_fraction)[0], math.sqrt(narrow * wide))
        excess, mean = kernel.excess(still, variance)
        steady = np.clip(2.0 * (excess - np.sqrt(kernel.squares * mean)), 0.0, np.maximum(excess, 0.0))

    def maxima(frame: Array) -> tuple[Values, Values, Array]:
        # Dimmer maxima are not spots, but spots near them are not isolated.
        light = filled(frame[None], defects[None], narrow, known_fraction)[0]
        return kernel.maxima(light, variance, min(level, _NEIGHBOR), steady)

    spots = side_by_side(maxima, list(electrons), thread_count)
    frame = np.repeat(np.arange(len(electrons)), [part[0].size for part in spots])
    row, column, score = (np.concatenate([part[k] for part in spots] or [np.empty(0, int)]) for k in range(3))
    # With twice the frame number as a coordinate, spots of different frames are at least 2 boxes apart.
    places, bright = np.column_stack([row / rows, column / columns, 2.0 * frame]), score >= level
    near = scipy.spatial.cKDTree(places).query_ball_point(places, _ISOLATED, p=np.inf, return_length=True)
    frame, row, column, near = (part[bright] for part in (frame, row, column, near))
    places, score = places[bright], score[bright]
    kept = brightest(places, score, APART)
    overlapping = int(score.size - kept.sum())
    corners = np.column_stack([row - rows // 2, column - columns // 2])
    in_frame = ((corners >= 0) & (corners + box <= electrons.shape[1:])).all(axis=1)
    borders = int((kept & ~in_frame).sum())
    kept &= in_frame
    frame, corners = frame[kept], corners[kept]
    boxes = frame[:, None, None], *box_pixels(corners, box)
    saturated, left_out = (int(pixels[boxes].sum()) for pixels in (counts.full, counts.hidden))
    false_spots = _density(level, narrow, wide, kernel.weight) * electrons.shape[1] * electrons.shape[2]
    (row, column), omitted = corners.T, (borders, overlapping, saturated, left_out, false_spots)
    return Spots(frame + start, row, column, score[kept], counts.marked()[boxes], *omitted, near[kept] < 2)


def frame_counts(frames: ArrayLike | Counts, box: tuple[int, int], **options: Any) -> Counts:
    """Return frames as counts (n, rows, columns); ValueError if they are smaller than a box."""
    shape = f"(frames, rows, columns), at least the box of {box[0]} x {box[1]}"
    return image_counts("frames", frames, shape, box, empty=True, **options)[0]


def image_counts(
    name: str,
    images: ArrayLike | Counts,
    shape: str,
    box: tuple[int, int],
    noise: Noise | None = None,
    **options: Any,
) -> tuple[Counts, bool]:
    """Return images as counts (n, rows, columns), and whether `images` is a single image of shape (rows, columns).

    ValueError if images are smaller than a box, or if an image has no valid pixel; `shape` is the required shape as
    text.
    """
    counts = counts_of(name, images, noise, sides=(2, 3), shape=shape, **options)
    if counts.values.shape[-2] < box[0] or counts.values.shape[-1] < box[1]:
        raise ValueError(f"{name} must have the shape {shape}, got {counts.values.shape}")
    if len(counts.values):
        counts.require_known(name)
    single = counts.values.ndim == 2
    return (counts[None] if single else counts), single


def filled(
    planes: Values, left_out: NDArray[np.bool_], width: float, known_fraction: Array | None = None,
    level: Callable[[int], float] | None = None,
) -> Values:  # fmt: skip
    """Return images in which pixels that are left out have the weighted mean of the others, by a Gaussian of `width`.

    `known_fraction` is the smoothed fraction of pixels that are not left out, if it is the same for all images.
    `level` returns the median of an image, by its number, if `planes` are parts of images.
    """
    if not left_out.any():
        return planes
    images = np.where(left_out, 0.0, planes).astype(np.float64)
    for k, (image, hidden) in enumerate(zip(images, left_out, strict=True)):
        if hidden.any():
            extent = scipy.ndimage.find_objects(hidden.view(np.int8))[0]
            near = tuple(slice(max(axis.start - reach(width), 0), axis.stop + reach(width)) for axis in extent)
            light, dark = image[near], hidden[near]
            fraction = smoothed(1.0 - dark, width) if known_fraction is None else known_fraction[near]
            # Left-out pixels are 0: smoothed light / smoothed fraction is the mean over the other pixels.
            light[dark] = (smoothed(light, width) / np.maximum(fraction, 1e-300))[dark]
            if (isolated := dark & (fraction <= _MIN_KNOWN)).any():
                light[isolated] = np.median(image[~hidden]) if level is None else level(k)
    return images


class Kernel:
    """The kernel (module docstring) for frames of a given shape; `flat` if backgrounds have no curvature."""

    def __init__(self, shape: tuple[int, ...], narrow: float, wide: float, *, flat: bool = True) -> None:
        self.narrow, self.wide, self.weight = narrow, wide, 0.0 if flat else 1.0 - (narrow / wide) ** 2
        self.squares, self.cubes = _moments(shape[0], shape[1], narrow, wide, self.weight)

    def excess(self, light: Array, variance: Array) -> tuple[Array, Array]:
        """Return e (module docstring) of a frame, and the mean m; `variance` is the read variance, electrons^2."""
        background = smoothed(light, self.wide)
        excess = smoothed(light, self.narrow) - background
        if self.weight:
            # Around a bright spot the kernel is positive where N - W is negative: a maximum must be one of both.
            excess -= self.weight * np.maximum(background - smoothed(background, self.wide), 0.0)
        return excess, np.maximum(np.maximum(background, 0.0) + variance, _MIN_MEAN)

    def maxima(
        self, light: Array, variance: Array, level: float, steady: Array | float = 0.0
    ) -> tuple[Values, Values, Array]:
        """Return rows, columns and scores (module docstring) of the maxima of a frame whose score is >= `level`.

        `variance` is the read variance of pixels, electrons^2; `steady` is taken off e.
        """
        excess, mean = self.excess(light, variance)
        excess -= steady
        # The score is less than (excess / standard deviation): it is computed only for pixels where that is at least
        # `level`. The product x abs(x) has the sign of x, which rejects pixels below the background.
        candidates = np.nonzero(excess * np.abs(excess) >= level**2 * self.squares * mean)
        radius = math.ceil(self.narrow)
        heights = np.zeros((light.shape[0] + 2 * radius, light.shape[1] + 2 * radius))
        scores = _heights(excess[candidates], mean[candidates], self.squares[candidates], self.cubes[candidates])
        row, column = candidates[0] + radius, candidates[1] + radius
        heights[row, column] = scores
        peak = scores >= level
        for dy in range(-radius, radius + 1):
            # A maximum is not below any pixel within one standard deviation of the narrow Gaussian.
            for dx in range(-radius, radius + 1):
                peak &= scores >= heights[row + dy, column + dx]
        return candidates[0][peak], candidates[1][peak], scores[peak]

    def squared(self, variance: Array) -> Array:
        """Return the mean variance of pixels, weighted by the square of the narrow Gaussian."""
        # The square of a Gaussian is a Gaussian with the standard deviation divided by sqrt(2).
        return smoothed(variance, self.narrow / math.sqrt(2.0))


def _heights(excess: Array, mean: Array, squares: Array, cubes: Array) -> Array:
    """Return the scores s (module docstring): heights above the background in standard deviations of its noise."""
    size = cubes / squares
    expected, above = mean * squares / size**2, np.maximum(excess / size, 0.0)
    # log1p loses no digits for small excess.
    ratio = (expected + above) * np.log1p(above / expected) - above
    return np.asarray(np.sqrt(2.0 * np.maximum(ratio, 0.0)))


def reach(sigma: float) -> int:
    """Return the number of pixels on each side over which a Gaussian smooths."""
    return int(_TRUNCATION * sigma + 0.5)


def smoothed(light: Array, sigma: float) -> Array:
    """Return an image convolved with a Gaussian of this standard deviation, with reflection at the edges."""
    if light.dtype == np.float32:  # products of blocks with a band matrix then take a third of the time
        margin = reach(sigma)
        offset = np.subtract.outer(np.arange(_BLOCK + 2 * margin), np.arange(_BLOCK) + margin)
        band = np.where(np.abs(offset) <= margin, np.exp(-0.5 * (offset / sigma) ** 2), 0.0).astype(np.float32)
        band /= band[:, 0].sum()
        for _ in range(2):  # along rows, then along columns
            padded, count = np.pad(light, ((0, 0), (margin, margin + _BLOCK)), "symmetric"), light.shape[1]
            blocks = [product(padded[:, k : k + len(band)], band) for k in range(0, count, _BLOCK)]
            light = np.concatenate(blocks, axis=1)[:, :count].T
        return light
    return np.asarray(scipy.ndimage.gaussian_filter(light, sigma, mode="reflect", truncate=_TRUNCATION))


@lru_cache(maxsize=2)
def _moments(rows: int, columns: int, narrow: float, wide: float, weight: float = 0.0) -> tuple[Array, Array]:
    """Return the sums of squares and of cubes of the kernel at each pixel, with reflection at the edges."""
    of_rows, of_columns = (_sums(side, narrow, wide, curved=weight > 0.0) for side in (rows, columns))
    moments = np.zeros((2, rows, columns))
    # Multinomial expansion of (N - (1 + a) W + a W * W)^power; each term is separable in rows and columns.
    for powers in of_rows:
        factor = math.factorial(sum(powers)) / math.prod(map(math.factorial, powers)) * (-1.0 - weight) ** powers[1]
        moments[sum(powers) - 2] += factor * weight ** powers[2] * np.outer(of_rows[powers], of_columns[powers])
    return moments[0], moments[1]


def _sums(side: int, narrow: float, wide: float, *, curved: bool) -> dict[tuple[int, ...], Array]:
    """Return, for powers (i, j, k), the sums of N^i W^j (W * W)^k along one axis at each pixel (k = 0 if flat)."""
    reach = math.ceil(2.0 * _TRUNCATION * wide) + 2
    count = min(side, 2 * reach + 1)
    narrow_weights, wide_weights = (
        scipy.ndimage.gaussian_filter1d(np.eye(count), sigma, axis=0, mode="reflect", truncate=_TRUNCATION)
        for sigma in (narrow, wide)
    )
    # Pixels farther than `reach` from both edges have equal sums.
    index = np.minimum(np.arange(side), np.maximum(reach, np.arange(side) + count - side))
    powers = [of for of in itertools.product(range(4), range(4), range(4 if curved else 1)) if sum(of) in (2, 3)]
    weights = narrow_weights, wide_weights, wide_weights @ wide_weights
    # Products take a fraction of the time of powers.
    factors = ((w for w, power in zip(weights, of, strict=True) for _ in range(power)) for of in powers)
    sums = (reduce(np.multiply, each).sum(axis=1)[index] for each in factors)
    return dict(zip(powers, sums, strict=True))


def _density(threshold: float, narrow: float, wide: float, weight: float = 0.0) -> float:
    """Return the expected number of maxima of noise above a threshold, per pixel (module docstring)."""
    parts = (1.0, narrow**2), (-1.0 - weight, wide**2), (weight, 2.0 * wide**2)
    # Integrals of (dk/dx)^2 and k^2, up to common factors: a product of two Gaussians depends on the sum of
    # variances.
    gradients, squares = (
        math.fsum(f * g / (u + v) ** power for f, u in parts for g, v in parts) for power in (2.0, 1.0)
    )
    return gradients / squares * threshold * math.exp(-0.5 * threshold**2) / math.sqrt(2.0 * math.pi) ** 3


def brightest(places: Array, score: Array, near: float) -> NDArray[np.bool_]:
    """Return a mask of the positions (n, axes) to keep: those without a kept one of higher score within `near`.

    `near` is the distance along each axis.
    """
    kept = np.ones(score.size, bool)
    neighbors = scipy.spatial.cKDTree(places).query_ball_point(places, near, p=np.inf) if score.size > 1 else []
    isolated = np.array([len(indices) < 2 for indices in neighbors], bool)
    for spot in np.argsort(-score, kind="stable")[: len(neighbors)].tolist():
        if kept[spot] and not isolated[spot]:
            kept[neighbors[spot]] = False
            kept[spot] = True
    return kept


def box_pixels(corners: NDArray[np.int64], box: tuple[int, ...]) -> tuple[Values, Values]:
    """Return the rows (n, height, 1) and columns (n, 1, width) of boxes from their first pixels (n, 2)."""
    first_pixel = corners[:, :, None, None]
    return first_pixel[:, 0] + np.arange(box[0])[:, None], first_pixel[:, 1] + np.arange(box[1])
