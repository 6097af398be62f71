"""Detection of isolated stars, beads, pinholes and checkerboard crossings in images, and windows around them.

Targets that cannot be fitted are refused, with a reason. In this file, distances "in windows" are divided by the
sides of a window, and places are rows and columns.
"""

from __future__ import annotations

import math
from collections import Counter, deque
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel import show
from lommel.base import validation
from lommel.base.arrays import Array, Json, Values
from lommel.detection.molecules import APART, Kernel, box_pixels, brightest, filled, image_counts, reach, smoothed
from lommel.recorded.counts import Counts
from lommel.recorded.noise import Noise

__all__ = ["Crossings", "PointSources", "Targets", "find_crossings", "find_spots", "grid_indices"]

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# In order: a pixel of the window is saturated; the window extends beyond the image; too many of its pixels are
# masked or NaN; another target is too near; one pixel has nearly all the light.
_REASONS = ("saturated", "edge", "masked", "neighbor", "defect")
_STRUCTURE = 0.25  # windows: maxima closer than this belong to one image
_FAINTEST = 0.02  # spots dimmer than this fraction of another spot do not count as its neighbours
_INSIDE = 0.55  # windows: a target farther than this from the middle of a window is outside it
_ONE_PIXEL = 0.8  # fraction of a spot's light in one pixel above which it is a defect; the sharpest images have less
_MAX_MASKED = 0.25  # largest fraction of masked pixels of a usable window, and of its middle half
_STRIP = 256  # number of rows of an image that are smoothed together
_CANDIDATE = 1.0  # height, standard deviations, from which the highest maximum is reported if there is no spot
# For crossings:
_MIN_WINDOW, _MAX_WINDOW = 9, 21  # smallest and largest side of an automatic window, pixels
_CIRCLE = 3.0  # radius of a circle around a crossing, standard deviations of the smoothing
_POINTS = 64  # number of points on this circle
_SECOND_HARMONIC = 0.55  # least fraction of the variance on the circle in its second harmonic: ideally 0.81
_CONTRAST = 0.25  # least contrast relative to the 75th percentile: weaker crossings are print, not the chart
_OVERLAPPING = 10.0  # percentage of crossings whose automatic windows may overlap others
_STEPS = ((1, 0), (-1, 0), (0, 1), (0, -1))
_MAX_OFFSET = 0.25  # largest distance of a point from its predicted place, relative to a step of the grid
_SEEDS = 20  # number of points from which a grid is grown


class Refused(NamedTuple):
    """A target that was refused: row and column, height in standard deviations of the noise, and reason."""

    row: int
    column: int
    score: float
    reason: str


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Targets:
    """Windows around stars, pinholes or crossings, to which :func:`lommel.fit_field` fits wavefronts.

    :func:`lommel.detection.find_spots` and :func:`lommel.detection.find_crossings` return them; of places that were
    found by other means they are made by ``Targets(windows=..., places=..., shape=..., noise=...)``.

    Parameters
    ----------
    windows : array_like or Counts, shape (n, height, width) or (n, e, height, width)
        Images of n targets in e exposures.
    places : array_like, shape (n, 2)
        Row and column on the sensor of the middle pixel ``(height // 2, width // 2)`` of each window.
    shape : (int, int)
        Rows and columns of the sensor.
    noise : Noise, optional
        Noise of arrays; :class:`lommel.Counts` have their own.
    kind : {"star", "crossing"}, default "star"
        Point sources and pinholes, or corners of a checkerboard.
    """

    windows: Any
    places: Any
    shape: tuple[int, int]
    noise: Noise | None = None
    kind: Literal["star", "crossing"] = "star"


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class _Found(Targets):
    """Targets found in one or several images, and refused targets; see :class:`lommel.detection.PointSources`."""

    centers: Array
    refused: tuple[Refused, ...]
    left_out: int
    _counts: Counts = field(repr=False)

    @property
    def message(self) -> str:
        """Number of targets found, and number refused for each reason."""
        raise NotImplementedError

    def _summary(self, noun: str, distance: str = "") -> str:
        """Return the number of targets found and the numbers refused for each reason, as text."""
        counts = Counter(target.reason for target in self.refused)
        refused = ", ".join(f"{counts[reason]} {reason}" for reason in _REASONS if counts[reason]) or "none"
        text = f"{len(self)} {noun}{'s' * (len(self) != 1)} found{distance}; refused: {refused}"
        excluded = self.left_out
        return text + f"; {excluded} pixel{'s' * (excluded != 1)} left out (masked or NaN)" * (excluded > 0)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Return matplotlib axes with the image, the windows, and the refused targets marked by reason.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Axes to draw into; by default those of a new figure.

        Returns
        -------
        matplotlib Axes

        Raises
        ------
        ImportError
            If matplotlib is not installed.
        """
        rows, columns = self.windows.shape[-2:]
        refused = [(target.row, target.column, target.reason) for target in self.refused]
        counts = self._counts
        electrons = counts.known_noise().electrons(np.where(counts.hidden, 0, counts.values)).sum(axis=0)
        image = np.where(counts.hidden.any(axis=0), np.nan, electrons)
        return show.estimates.spots(image, self.places, (rows, columns), refused, self.message, ax)

    def __len__(self) -> int:
        return len(self.places)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.message}>"


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class PointSources(_Found):
    """Isolated point sources in an image or stack, returned by :func:`lommel.detection.find_spots`.

    Attributes
    ----------
    places : ndarray of int, shape (n, 2)
        Row and column in the image of the middle pixel ``(rows // 2, columns // 2)`` of each window, in the order of
        falling `score`.
    centers : ndarray, shape (n, 2)
        Row and column in the image of the centroid of each spot.
    windows : ndarray, shape (n, rows, columns), or (n, planes, rows, columns) for a stack
        Windows cut from the image, in its unit and type; a masked array if pixels of the image are left out.
    score : ndarray, shape (n,)
        Height above the background in standard deviations of the background noise.
    flux : ndarray, shape (n,)
        Electrons above the background in the window, sum of all planes; a rough estimate.
    refused : tuple of Refused
        Row, column, score and reason of each refused spot. Reasons are "saturated", "edge", "masked", "neighbor" and
        "defect".
    shape : (int, int)
        Shape of the image.
    noise : Noise
        Noise of the camera.
    kind : str
        "star".
    left_out : int
        Number of pixels in all planes that are masked, NaN or infinite.
    candidate : Refused or None
        The highest maximum, which is below the threshold, if no maximum is above it.
    """

    score: Array
    flux: Array
    candidate: Refused | None

    @property
    def message(self) -> str:
        """Number of spots found, and number refused for each reason."""
        text = self._summary("spot")
        if (candidate := self.candidate) is not None:
            place = f"at row {candidate.row}, column {candidate.column}"
            text += f"; the highest maximum, {place}, is {candidate.score:.3g} standard deviations high"
        return text


def find_spots(
    images: ArrayLike | Counts,
    *,
    noise: Noise | None = None,
    window: int | tuple[int, int] = 33,
    threshold: float = 8.0,
    width: float = 2.0,
    most: int | None = None,
) -> PointSources:
    """Find isolated stars, beads or pinholes, and cut a window around each.

    Parameters
    ----------
    images : array_like or Counts, shape (height, width) or (planes, height, width)
        Recorded images, in the unit of `noise`. A stack shows one field, such as the planes of a z stack or exposures
        at several defoci; spots are detected in the sum of its images. NaN, infinite and masked values are left out.
        The largest value of an integer type is saturated; :class:`lommel.Counts` state a mask and a saturation.
    noise : Noise, optional
        Gain, offset and read noise of arrays, each a number or a map of the image; Counts have their own.
    window : int or (int, int), default 33
        Rows and columns of the windows, at least 5. A window should contain the image of a point and some background.
    threshold : float, default 8.0
        Minimum height of a spot in standard deviations of the background noise, at least 3.
    width : float, default 2.0
        Standard deviation of the smoothing in pixels, at most a quarter of the window. It should be about that of the
        images. For a defocused star, whose image is a ring, it should be about the radius of the ring: the ring is
        then detected as one spot.
    most : int, optional
        Maximum number of spots; those of the highest score are kept.

    Returns
    -------
    PointSources
        Places and windows of spots, and refused spots with reasons.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, an image is smaller than the window, or all of its pixels are left out.

    Notes
    -----
    Spots are detected by a difference of Gaussians, as in :func:`lommel.localize.find`; the standard deviation of the
    wide Gaussian is a third of the window. A window is centred on the pixel nearest to the centroid of the spot. The
    centroid includes pixels within a quarter of a window of the maximum that are more than three standard deviations
    above the background. Maxima within a quarter of a window are parts of one image. A spot is refused if its window
    overlaps that of another spot with at least 2 % of its brightness. For detection, pixels that are left out are
    replaced by the mean of pixels around them.

    Examples
    --------
    >>> noise = Noise(read=2.0)
    >>> sky = np.full((100, 200), 20.0)
    >>> sky[48:53, 60:65] += 400.0
    >>> sky[70:75, 2:7] += 400.0
    >>> spots = find_spots(noise.record(sky, seed=1), noise=noise, window=21)
    >>> spots.places, spots.message
    (array([[50, 62]]), '1 spot found; refused: 1 edge')
    """
    rows, columns = box = checked_window(window)
    level = validation.real("threshold", threshold, least=3.0, most=1e3)
    sigma = validation.real("width", width, least=0.5, most=min(rows, columns) / 4.0)
    count = None if most is None else validation.integer("most", most, least=1, most=10**9)
    shape = f"(height, width) or (planes, height, width), at least the window of {rows} x {columns}"
    counts, single = image_counts("images", images, shape, box, noise)
    noise = counts.known_noise()
    signal, wide = _Signal(counts, noise.poisson, sigma), min(rows, columns) / 3.0
    row, column, score = _maxima(signal, wide, level)
    candidate = None
    if not row.size:
        maxima = zip(*(part.tolist() for part in _maxima(signal, wide, _CANDIDATE)), strict=True)
        below_threshold = [Refused(row, column, height, "below the threshold") for row, column, height in maxima]
        candidate = max(below_threshold, key=lambda maximum: maximum.score, default=None)
    separate = brightest(np.column_stack([row, column]), score, _STRUCTURE * min(box))
    row, column, score = row[separate], column[separate], score[separate]
    background = _background(signal, box)
    brightness, margin = -background(np.stack([row, column])), reach(sigma)
    center, flux, peak = np.zeros((row.size, 2)), np.zeros(row.size), np.zeros(row.size)
    for k, pixel in enumerate(zip(row.tolist(), column.tolist(), strict=True)):
        first = [max(place - margin, 0) for place in pixel]
        near = signal[first[0] : pixel[0] + margin + 1, first[1] : pixel[1] + margin + 1]
        brightness[k] += smoothed(near, sigma)[pixel[0] - first[0], pixel[1] - first[1]]
        center[k], flux[k], peak[k] = _centroid(signal, background, pixel, box)
    middle = np.rint(center).astype(np.int64)
    neighbor = _neighbors(middle / box, brightness, peak > _ONE_PIXEL)
    reasons = unusable(middle, counts, box)
    for k, fraction in enumerate(peak.tolist()):
        reasons[k] = reasons[k] or ("defect" if fraction > _ONE_PIXEL else "neighbor" if neighbor[k] else "")
    order = np.array([k for k in np.argsort(-score, kind="stable").tolist() if not reasons[k]][:count], np.intp)
    return PointSources(
        score=score[order],
        flux=noise.excess * flux[order],
        candidate=candidate,
        _counts=counts,
        **target_windows(counts, single, center, order, box, score, reasons),
    )


def checked_window(window: int | tuple[int, int]) -> tuple[int, int]:
    """Return rows and columns of a window; ValueError if it is under 5 x 5 pixels."""
    rows, columns = validation.image_shape(window, "window")
    if min(rows, columns) < 5:
        raise ValueError(f"window must be at least 5 x 5 pixels, got {rows} x {columns}")
    return rows, columns


def target_windows(
    counts: Counts, single: bool, center: Array, order: Values, box: tuple[int, int], score: Array, reasons: list[str]
) -> Json:
    """Return the fields of targets that were found: windows of those in `order`, and those with a reason as refused.

    Windows are masked arrays if any pixel of the images is left out.
    """
    (rows, columns), hidden, middle = box, counts.hidden, np.rint(center).astype(np.int64)
    pixels = np.s_[:, *box_pixels(middle[order] - np.array([rows // 2, columns // 2]), box)]
    values, masks = (np.ascontiguousarray(np.moveaxis(part[pixels], 0, 1)) for part in (counts.values, hidden))
    windows = np.ma.MaskedArray(values, mask=masks) if hidden.any() else values
    targets = zip(middle.tolist(), score.tolist(), reasons, strict=True)
    refused = [Refused(row, column, height, reason) for (row, column), height, reason in targets if reason]
    return {
        "places": middle[order],
        "centers": center[order],
        "windows": windows[:, 0] if single else windows,
        "refused": tuple(sorted(refused, key=lambda target: -target.score)),
        "shape": hidden.shape[1:],
        "noise": counts.noise,
        "left_out": int(hidden.sum()),
    }


def unusable(middle: NDArray[np.int64], counts: Counts, box: tuple[int, int]) -> list[str]:
    """Return for each place the reason to refuse its window ("saturated", "edge" or "masked"), or "" if usable."""
    (rows, columns), saturated, reasons = box, np.asarray(counts.full.any(axis=0)), list[str]()
    for top, left in (middle - [rows // 2, columns // 2]).tolist():
        window = saturated[max(top, 0) : max(top + rows, 0), max(left, 0) : max(left + columns, 0)]
        part = counts.hidden[:, max(top, 0) : top + rows, max(left, 0) : left + columns]
        # The middle half is tested separately because masked pixels near the target matter most.
        inner = part[:, rows // 4 : rows - rows // 4, columns // 4 : columns - columns // 4]
        if window.any():
            reasons.append("saturated")
        elif window.shape != box or min(top, left) < 0:
            reasons.append("edge")
        else:
            reasons.append("masked" if max(part.mean(), inner.mean()) >= _MAX_MASKED else "")
    return reasons


class _Signal:
    """Sum of the electrons of all images, with hidden pixels filled by a Gaussian of `width`.

    Parts of it are views of one array in single precision.
    """

    def __init__(self, counts: Counts, camera: Noise, width: float) -> None:
        self.width, self.shape = width, counts.shape[1:]
        self.read: Array = np.broadcast_to(len(counts) * np.square(camera.read), self.shape)  # variance
        self._light, margin = np.empty(self.shape, np.float32), reach(width)
        values, hidden = counts.values, counts.hidden
        level = cache(lambda k: float(np.median(values[k][~hidden[k]])))
        for first in range(0, self.shape[0], _STRIP):
            rows, start = slice(first, first + _STRIP), max(first - margin, 0)
            wider = np.s_[:, start : rows.stop + margin]
            image = filled(values[wider], hidden[wider], width, level=level)[:, first - start :][:, :_STRIP]
            self._light[rows] = camera.part(rows, slice(None)).electrons(image).sum(axis=0)

    def __getitem__(self, part: tuple[slice, slice]) -> Values:
        return self._light[part]


def _maxima(signal: _Signal, wide: float, level: float) -> tuple[Values, Values, Array]:
    """Return rows, columns and scores of the maxima of an image whose score is at least `level`."""
    (rows, columns), parts, margin = signal.shape, [], reach(wide) + math.ceil(signal.width)
    height = min(_STRIP + 2 * margin, rows)
    for first in range(0, rows, _STRIP):
        start = min(max(first - margin, 0), rows - height)  # all strips have the same height
        light, variance = signal[start : start + height, 0:columns], signal.read[start : start + height]
        kernel = Kernel(light.shape, signal.width, wide)
        if signal.read.strides[0]:
            variance = kernel.squared(variance)
        row, column, score = kernel.maxima(light, variance, level)
        kept = (row >= first - start) & (row < first - start + _STRIP)
        parts.append((row[kept] + start, column[kept], score[kept]))
    row, column, score = (np.concatenate(part) for part in zip(*parts, strict=True))
    return row, column, score


def _background(signal: _Signal, box: tuple[int, int]) -> Callable[[Array], Array]:
    """Return the background at places: medians over cells of about a window's size, interpolated linearly."""
    cells = tuple(max(1, round(side / size)) for side, size in zip(signal.shape, box, strict=True))
    edges = [np.linspace(0, side, n + 1).astype(int) for side, n in zip(signal.shape, cells, strict=True)]
    medians, sizes = np.empty(cells), np.diff(edges[1])
    for band, top, bottom in zip(medians, edges[0], edges[0][1:], strict=False):
        light = signal[top:bottom, 0 : signal.shape[1]]
        for size in np.unique(sizes):  # cells of one size together
            columns = edges[1][:-1][sizes == size, None] + np.arange(size)
            band[sizes == size] = np.median(light[:, columns], axis=(0, 2))
    # A cell that a spot fills has the background of its neighbours.
    smooth = scipy.ndimage.median_filter(medians, size=3, mode="nearest")

    def at(places: Array) -> Array:
        cells_at = [(part + 0.5) * n / side - 0.5 for part, side, n in zip(places, signal.shape, cells, strict=True)]
        return np.asarray(scipy.ndimage.map_coordinates(smooth, cells_at, order=1, mode="nearest"))

    return at


def _centroid(
    signal: _Signal, background: Callable[[Array], Array], pixel: tuple[int, int], box: tuple[int, int]
) -> tuple[Array, float, float]:
    """Return the centroid of a spot, its electrons in a window, and the fraction of its light in one pixel."""
    middle = np.array(pixel, dtype=np.float64)
    for step in range(3):  # two iterations of the centroid near the maximum, then the electrons of the whole window
        half_window = 0.5 if step == 2 else _STRUCTURE
        radius = [max(1, int(half_window * side)) for side in box]
        low = np.clip(np.rint(middle).astype(int) - radius, 0, np.array(signal.shape) - 1)
        high = np.minimum(np.rint(middle).astype(int) + radius + 1, signal.shape)
        part = np.s_[low[0] : high[0], low[1] : high[1]]
        places = np.mgrid[part]
        sky = background(places)
        excess, noise = signal[part] - sky, np.sqrt(np.maximum(sky, 0.0) + signal.read[part] + 1e-12)
        # Only pixels above the noise: pixels of the background would move the centroid to the middle of the window.
        significant = np.where(excess > 3.0 * noise, excess, 0.0)
        total = float(significant.sum())
        if step < 2 and total > 0.0:
            middle = np.array([(significant * place).sum() / total for place in places])
    return middle, float(excess.sum()), float(significant.max()) / total if total > 0.0 else 0.0


def _neighbors(places: Array, light: Array, defect: NDArray[np.bool_]) -> list[bool]:
    """Return for each place, in windows, whether the window of another one overlaps that is not far dimmer.

    A `defect` counts only inside a window because it has no light around it.
    """
    has_neighbor = [False] * len(places)
    if len(places) > 1:
        for pair in scipy.spatial.cKDTree(places).query_pairs(APART, p=math.inf):
            outside = np.abs(places[pair[0]] - places[pair[1]]).max() > _INSIDE
            for k, other in (pair, pair[::-1]):
                has_neighbor[k] |= bool(light[other] >= _FAINTEST * light[k]) and not (defect[other] and outside)
    return has_neighbor


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Crossings(_Found):
    """Crossings of a checkerboard in one or several exposures, returned by :func:`lommel.detection.find_crossings`.

    Attributes
    ----------
    places : ndarray of int, shape (n, 2)
        Row and column in the image of the middle pixel ``(rows // 2, columns // 2)`` of each window, sorted by rows.
    centers : ndarray, shape (n, 2)
        Row and column of the saddle point of the smoothed image, accurate to about a tenth of a pixel.
    windows : ndarray, shape (n, rows, columns), or (n, exposures, rows, columns) for several exposures
        Windows cut from the image, in its unit and type; a masked array if pixels of the image are left out.
    indices : ndarray, shape (n, 2)
        Row and column of each crossing on the board, from :func:`lommel.detection.grid_indices`; NaN if unknown. They
        are the places of the crossings without distortion, in squares.
    contrast : ndarray, shape (n,)
        White minus black level, electrons per pixel, sum of all exposures; a rough estimate.
    square : float
        Side of a square in the image, pixels: the median distance between neighbours; NaN if there are none.
    refused : tuple of Refused
        Row, column, score (standard deviations of the noise) and reason of each refused crossing. Reasons are
        "saturated", "edge", "masked" and "neighbor".
    shape : (int, int)
        Shape of the image.
    noise : Noise
        Noise of the camera.
    kind : str
        "crossing".
    left_out : int
        Number of pixels in all exposures that are masked, NaN or infinite.
    """

    kind: Literal["star", "crossing"] = "crossing"

    indices: Array
    contrast: Array
    square: float

    @property
    def message(self) -> str:
        """Number of crossings found, their distance, and number refused for each reason."""
        distance = f", {self.square:.3g} pixels apart" if math.isfinite(self.square) else ""
        return self._summary("crossing", distance)


def find_crossings(
    images: ArrayLike | Counts,
    *,
    noise: Noise | None = None,
    window: int | tuple[int, int] | None = None,
    threshold: float = 8.0,
    width: float = 2.0,
    most: int | None = None,
) -> Crossings:
    """Find the crossings of a checkerboard, where four squares meet, and cut a window around each.

    Parameters
    ----------
    images : array_like or Counts, shape (height, width) or (exposures, height, width)
        Recorded images, in the unit of `noise`; several exposures show one chart that did not move. NaN, infinite and
        masked values are left out. The largest value of an integer type is saturated; :class:`lommel.Counts` state a
        mask and a saturation.
    noise : Noise, optional
        Gain, offset and read noise of arrays, each a number or a map of the image; Counts have their own.
    window : int or (int, int), optional
        Rows and columns of the windows, at least 5. The default is a square of 9 to 21 pixels, chosen so that at
        most about a tenth of the windows overlap.
    threshold : float, default 8.0
        Minimum height of a crossing in standard deviations of the noise, at least 3.
    width : float, default 2.0
        Standard deviation of the smoothing in pixels, at least 1. It should be about that of the blur of edges; the
        sides of squares must be larger than four of these.
    most : int, optional
        Maximum number of crossings, which are chosen evenly over the image.

    Returns
    -------
    Crossings
        Places and windows for :func:`lommel.fit_field`, and refused crossings with reasons.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, an image is smaller than the window, or all of its pixels are left out.

    Notes
    -----
    Crossings are saddle points of the smoothed image: maxima of minus the determinant of the Hessian (Rufli,
    Scaramuzza and Siegwart 2008, doi:10.1109/IROS.2008.4650703, compare detectors). On a circle around a crossing,
    brightness changes between white and black four times, and most of its variance is in the second harmonic. This
    test rejects the border of a chart, where two or three squares meet, and also ends of lines and print.

    Examples
    --------
    >>> noise = Noise(read=2.0)
    >>> row, column = np.mgrid[:120, :160]
    >>> board = np.where((row // 30 + column // 30) % 2, 3000.0, 300.0)
    >>> found = find_crossings(noise.record(board, seed=1), noise=noise)
    >>> found.message
    '15 crossings found, 30 pixels apart; refused: none'
    """
    box = None if window is None else checked_window(window)
    level = validation.real("threshold", threshold, least=3.0, most=1e3)
    sigma = validation.real("width", width, least=1.0, most=50.0)
    count = None if most is None else validation.integer("most", most, least=1, most=10**9)
    rows, columns = smallest = box or (_MIN_WINDOW, _MIN_WINDOW)
    shape = f"(height, width) or (exposures, height, width), at least the window of {rows} x {columns}"
    counts, single = image_counts("images", images, shape, smallest, noise)
    noise = counts.known_noise()
    electrons = noise.electrons(filled(counts.values, counts.hidden, sigma))
    signal, variance = electrons.sum(axis=0), noise.variance(np.maximum(electrons, 0.0)).sum(axis=0)
    center, score, contrast = _saddles(signal, variance, sigma, level)
    offset = _nearest_offsets(center)
    square = float(np.median(np.sqrt((offset**2).sum(axis=1)))) if len(center) > 1 else math.nan
    if box is None:
        spacings = np.abs(offset).max(axis=1)
        spacing = float(np.percentile(spacings, _OVERLAPPING)) if len(center) > 1 else float(_MAX_WINDOW)
        side = int(min(max(spacing, _MIN_WINDOW), _MAX_WINDOW, *signal.shape))
        box = (side - 1 + side % 2,) * 2  # an odd number of pixels
    middle = np.rint(center).astype(np.int64)
    reasons = unusable(middle, counts, box)
    usable = np.flatnonzero([not reason for reason in reasons])
    separate = brightest(middle[usable] / box, contrast[usable], APART)
    for k in usable[~separate]:
        reasons[k] = "neighbor"
    order = _evenly_chosen(center, usable[separate], count)
    order = order[np.lexsort((middle[order, 1], middle[order, 0]))]
    indices = np.full_like(center, np.nan)
    with suppress(ValueError):
        indices = grid_indices(center)
    return Crossings(
        indices=indices[order],
        contrast=contrast[order],
        square=square,
        _counts=counts,
        **target_windows(counts, single, center, order, box, score, reasons),
    )


def _saddles(signal: Array, variance: Array, sigma: float, level: float) -> tuple[Array, Array, Array]:
    """Return places (n, 2) of crossings, heights in standard deviations of the noise, and contrasts in electrons."""

    def derivative(rows: int, columns: int) -> Array:
        return np.asarray(scipy.ndimage.gaussian_filter(signal, sigma, order=(rows, columns), mode="nearest"))

    xx, yy, xy = derivative(0, 2), derivative(2, 0), derivative(1, 1)
    # White noise of variance v gives the mixed derivative a variance of v / (16 pi sigma^6).
    noise = scipy.ndimage.gaussian_filter(variance, sigma / math.sqrt(2.0), mode="nearest") / (
        16.0 * math.pi * sigma**6
    )
    saddle = np.maximum(xy * xy - xx * yy, 0.0)
    height = np.sqrt(saddle / np.maximum(noise, 1e-12))
    size = 2 * math.ceil(sigma) + 1
    peak = (saddle == scipy.ndimage.maximum_filter(saddle, size=size, mode="nearest")) & (height >= level)
    peak[[0, -1]] = peak[:, [0, -1]] = False
    row, column = np.nonzero(peak)
    center = np.column_stack([row, column]).astype(np.float64)
    for axis, step in ((0, (1, 0)), (1, (0, 1))):  # the vertex of a parabola through three values
        low, high = saddle[row - step[0], column - step[1]], saddle[row + step[0], column + step[1]]
        curvature = 2.0 * saddle[row, column] - low - high
        center[:, axis] += np.clip(0.5 * (high - low) / np.maximum(curvature, 1e-300), -0.5, 0.5)
    angle = 2.0 * math.pi * np.arange(_POINTS) / _POINTS
    points = center[:, :, None] + _CIRCLE * sigma * np.stack([np.sin(angle), np.cos(angle)])
    # Points outside the image have the brightness of the nearest pixel at its border.
    circle = scipy.ndimage.map_coordinates(
        scipy.ndimage.gaussian_filter(signal, 0.5 * sigma, mode="nearest"),
        points.swapaxes(0, 1),
        order=1,
        mode="nearest",
    )
    power = np.abs(np.fft.rfft(circle, axis=1)[:, 1:]) ** 2 if len(circle) else np.zeros((0, _POINTS // 2))
    power[:, -1:] *= 0.5  # the highest frequency has no negative counterpart
    contrast = np.pi * np.sqrt(power[:, 1]) / _POINTS  # peak to peak of a square wave with this second harmonic
    accepted = power[:, 1] > _SECOND_HARMONIC * np.maximum(power.sum(axis=1), 1e-300)
    if accepted.any():
        accepted &= contrast > _CONTRAST * np.percentile(contrast[accepted], 75.0)
    return center[accepted], height[row, column][accepted], contrast[accepted]


def _evenly_chosen(center: Array, candidates: NDArray[np.intp], most: int | None) -> NDArray[np.intp]:
    """Return at most `most` of the places `candidates`; each is the one farthest from all places chosen before."""
    if most is None or most >= len(candidates):
        return candidates
    places = center[candidates]
    chosen = [int(np.argmax(((places - places.mean(axis=0)) ** 2).sum(axis=1)))]
    squared_distance = np.full(len(candidates), math.inf)
    while len(chosen) < most:
        squared_distance = np.minimum(squared_distance, ((places - places[chosen[-1]]) ** 2).sum(axis=1))
        chosen.append(int(np.argmax(squared_distance)))
    return candidates[chosen]


def _nearest_offsets(center: Array) -> Array:
    """Return the offset (row, column) from each place to its nearest neighbour, shape (n, 2)."""
    if len(center) < 2:
        return np.zeros_like(center)
    _, nearest = scipy.spatial.cKDTree(center).query(center, k=2)
    return np.asarray(center[nearest[:, 1]] - center)


def grid_indices(places: ArrayLike) -> Array:
    """Return the row and column of image points in a square grid.

    Parameters
    ----------
    places : array_like, shape (n, 2)
        Row and column of each point, such as `centers` of :func:`lommel.detection.find_spots`, in any order; n at
        least 4.

    Returns
    -------
    ndarray, shape (n, 2)
        Whole numbers from 0; NaN for points that are not connected to the grid. If the grid is rotated by less than
        45 degrees, the row index increases downwards and the column index to the right.

    Raises
    ------
    TypeError, ValueError
        If there are fewer than 4 points, points are not finite, or fewer than 4 points form a grid.

    Notes
    -----
    The grid is grown from a point in the middle: the neighbours of a point are one step of the grid away from it. The
    steps are measured again at each point, because distortion and perspective change them slowly. Points may be
    missing if the others are still connected by steps.

    Examples
    --------
    >>> import lommel as lm
    >>> lm.detection.grid_indices([[11.0, 20.0], [10.0, 10.2], [20.1, 9.8], [20.3, 20.0]]).tolist()
    [[0.0, 1.0], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]
    """
    points = validation.real_array("places", places, unit="pixels")
    if points.ndim != 2 or points.shape[1] != 2 or len(points) < 4:
        raise ValueError(f"places must be the rows and columns of at least 4 points, got shape {points.shape}")
    tree = scipy.spatial.cKDTree(points)
    largest: dict[int, tuple[int, int]] = {}
    for seed in np.argsort(((points - np.median(points, axis=0)) ** 2).sum(axis=1))[:_SEEDS].tolist():
        if seed in largest or (steps := _steps(points, tree, seed)) is None:
            continue
        grid = _grow_grid(points, tree, seed, steps)
        if len(grid) > len(largest):
            largest = grid
        if len(largest) > len(points) // 2:
            break
    if len(largest) < 4:
        raise ValueError(f"places must be on a square grid, got {len(points)} points; fewer than 4 form a grid")
    indices = np.full(points.shape, np.nan)
    indices[list(largest)] = list(largest.values())
    return np.asarray(indices - np.nanmin(indices, axis=0))


def _steps(places: Array, tree: scipy.spatial.cKDTree, seed: int) -> Array | None:
    """Return the steps (2, 2) from a point to the next one downwards and to the right.

    Return None if no two of the nearest points are at about right angles.
    """
    distance, nearest = tree.query(places[seed], k=min(5, len(places)))
    offsets = (places[nearest] - places[seed])[distance > 0.0]
    unit = offsets / np.linalg.norm(offsets, axis=1)[:, None]
    down = int(np.argmax(np.abs(unit[:, 0])))
    across = int(np.argmin(np.abs(unit @ unit[down])))
    if abs(unit[across] @ unit[down]) > 0.4:
        return None
    steps = np.stack([offsets[down] * np.sign(unit[down, 0]), offsets[across]])
    if np.linalg.det(steps) < 0.0:
        steps[1] *= -1.0
    return np.asarray(steps)


def _grow_grid(places: Array, tree: scipy.spatial.cKDTree, seed: int, steps: Array) -> dict[int, tuple[int, int]]:
    """Return the grid indices of all points that are connected to the point `seed` by steps of the grid."""
    indices, occupied = {seed: (0, 0)}, {(0, 0)}
    queue = deque([(seed, steps)])
    while queue:
        point, point_steps = queue.popleft()
        for step in _STEPS:
            index = (indices[point][0] + step[0], indices[point][1] + step[1])
            offset = np.asarray(step) @ point_steps
            distance, neighbor = tree.query(places[point] + offset)
            if index in occupied or neighbor in indices or distance > _MAX_OFFSET * np.linalg.norm(offset):
                continue
            indices[int(neighbor)] = index
            occupied.add(index)
            new_steps = point_steps.copy()
            new_steps[0 if step[0] else 1] = sum(step) * (places[neighbor] - places[point])
            queue.append((int(neighbor), new_steps))
    return indices
