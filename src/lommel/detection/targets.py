"""Isolated stars, beads, pinholes and crossings of a checkerboard in images: windows around each, others refused."""

from __future__ import annotations

import math
from collections import Counter, deque
from contextlib import suppress
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import ndimage
from scipy.spatial import cKDTree

from lommel import show
from lommel.base import validation
from lommel.base.arrays import Array, Json, Values
from lommel.detection.molecules import APART, Kernel, box_pixels, brightest, filled, image_counts, smoothed
from lommel.recorded.counts import Counts
from lommel.recorded.noise import Noise

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# In the order in which they are tried: a pixel of the window is saturated, it extends beyond the image, a quarter
# of it is masked or NaN, another target is within its reach, all light is in one pixel.
_REASONS = ("saturated", "edge", "masked", "neighbor", "defect")
_STRUCTURE = 0.25  # of a window: maxima closer than this belong to one image
# Share of the light of a spot above the background that one pixel holds, at least: sharp images hold less of theirs.
_INSIDE = 0.55  # of a window: half of it, and a pixel
_ONE_PIXEL = 0.8
_HIT = 0.25  # share of a window, or of its middle half, of left-out pixels that rejects it
_CANDIDATE = 1.0  # standard deviations above which the highest maximum is reported where there is no spot
# Of crossings.
_LEAST, _MOST = 9, 21  # smallest and largest side of a chosen window, pixels
_RING = 3.0  # radius, in standard deviations of the smoothing, on which a crossing changes its sign four times
_POINTS = 64  # points on the ring
_ALIKE = 0.55  # share of the ring's variance in its second harmonic: at least 0.68 for a square wave
_CONTRAST = 0.25  # of the usual contrast: four squares of less are print, not the chart
_SPACED = 10.0  # percent of crossings whose windows may overlap others
_STEPS = ((1, 0), (-1, 0), (0, 1), (0, -1))
_NEAR = 0.25  # of a step: largest distance of a point from where its neighbour predicts it
_SEEDS = 20  # crossings that a grid is started from


class Refused(NamedTuple):
    """A spot that was refused: place, brightness in standard deviations, and one of the reasons."""

    row: int
    column: int
    score: float
    reason: str


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Targets:
    """Places of targets in an image or several, windows around them, and what was refused.

    Attributes
    ----------
    places, centers, windows, refused, shape, left_out
        As of :class:`lommel.PointSources`.
    """

    places: NDArray[np.int64]
    centers: Array
    windows: Values
    refused: tuple[Refused, ...]
    shape: tuple[int, int]
    left_out: int
    _image: Array = field(repr=False)

    @property
    def message(self) -> str:
        """How many were found, and how many refused for each reason."""
        raise NotImplementedError

    def _refusal_note(self, noun: str, apart: str = "") -> str:
        """Return how many were found, and how many refused for each of the reasons."""
        counts = Counter(each.reason for each in self.refused)
        refused = ", ".join(f"{counts[reason]} {reason}" for reason in _REASONS if counts[reason]) or "none"
        text = f"{len(self)} {noun}{'s' * (len(self) != 1)} found{apart}; refused: {refused}"
        lost = self.left_out
        return text + f"; {lost} pixel{'s' * (lost != 1)} left out (masked or NaN)" * (lost > 0)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Return matplotlib axes with the image, the windows, and the refused ones by reason.

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
        refused = [(each.row, each.column, each.reason) for each in self.refused]
        return show.estimates.spots(self._image, self.places, (rows, columns), refused, self.message, ax)

    def __len__(self) -> int:
        return len(self.places)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.message}>"


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class PointSources(Targets):
    """Isolated point sources in an image or stack: the answer of :func:`lommel.find_spots`.

    Attributes
    ----------
    places : ndarray of int, shape (n, 2)
        Row and column, in the image, of the middle pixel ``(rows // 2, columns // 2)`` of each window, brightest
        first.
    centers : ndarray, shape (n, 2)
        Row and column of the centroid of the light of each, in the image.
    windows : ndarray, shape (n, rows, columns), of a stack (n, planes, rows, columns)
        Cut from the image, in its unit and type; a masked array if pixels of the image are left out.
    score : ndarray, shape (n,)
        Height above the background in standard deviations of its noise.
    flux : ndarray, shape (n,)
        Electrons above the background in the window, of all planes; a rough estimate.
    refused : tuple of Refused
        Row, column, score and reason of the others: "saturated", "edge", "masked", "neighbor" or "defect".
    shape : (int, int)
        Of the image.
    left_out : int
        Number of pixels of all planes that are masked, NaN or infinite.
    candidate : Refused or None
        Where there is no spot at all: the highest maximum, which is below the threshold.
    """

    score: Array
    flux: Array
    candidate: Refused | None

    @property
    def message(self) -> str:
        """How many were found, and how many refused for each reason."""
        text = self._refusal_note("spot")
        if (best := self.candidate) is not None:
            where = f"at row {best.row}, column {best.column}"
            text += f"; the highest maximum, {where}, is {best.score:.3g} standard deviations high"
        return text


def find_spots(
    images: ArrayLike,
    *,
    noise: Noise,
    window: int | tuple[int, int] = 33,
    threshold: float = 8.0,
    width: float = 2.0,
    apart: float = 1.0,
    faintest: float = 0.02,
    mask: ArrayLike | None = None,
    saturation: float | None = None,
    most: int | None = None,
) -> PointSources:
    """Find isolated stars, beads or pinholes, and cut a window around each.

    Parameters
    ----------
    images : array_like, shape (height, width) or (planes, height, width)
        As recorded, in the unit of `noise`; a stack is of one field, such as the planes of a z stack or exposures at
        several defoci, and spots are found in its sum. NaN, infinite and masked values are left out.
    noise : Noise
        Gain, offset and read noise of the camera, each a number or a map of the image.
    window : int or (int, int), default 33
        Rows and columns of the windows, at least 5. A window should hold the image of a point and some background.
    threshold : float, default 8.0
        Least height of a spot in standard deviations of the background noise, at least 3.
    width : float, default 2.0
        Standard deviation of the smoothing in pixels, at most a quarter of the window: about that of the images. Of
        defocused stars (rings) about the radius of the ring, so that it is found as one spot.
    apart : float, default 1.0
        Least distance from the middle of a window to other spots, along rows or columns, in windows; at 0.5 other
        spots are outside of it, at 1.0 windows of the same size do not overlap.
    faintest : float, default 0.02
        Spots dimmer than this share of another do not count as its neighbours. Maxima within a quarter of a window
        are parts of one image.
    mask : array_like of bool, shape of `images` or (height, width), optional
        True where a pixel is to be left out, such as defects.
    saturation : float, optional
        Values from here on, in the unit of the images, are saturated. In images of integers the largest value of
        their type always is.
    most : int, optional
        Keep only so many, the brightest.

    Returns
    -------
    PointSources
        Places, windows, and the spots refused with the reason of each.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, an image is smaller than the window, or all of its pixels are left out.

    Notes
    -----
    Detection by a difference of Gaussians, the wide one a third of the window, as of :func:`lommel.localize.find`. A
    window is centred on the pixel nearest to the centroid of the light above three standard deviations of the
    background within a quarter of a window of the maximum. For the search, pixels that are left out have the mean of
    those around.

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
    validation.instance("noise", noise, Noise)
    level = validation.real("threshold", threshold, least=3.0, most=1e3)
    narrow = validation.real("width", width, least=0.5, most=min(rows, columns) / 4.0)
    far = validation.real("apart", apart, least=0.0, most=100.0)
    faint = validation.real("faintest", faintest, least=0.0, most=1.0)
    count = None if most is None else validation.integer("most", most, least=1, most=10**9)
    shape = f"(height, width) or (planes, height, width), at least the window of {rows} x {columns}"
    counts, single = image_counts("images", images, shape, box, mask=mask, saturation=saturation)
    alike = noise.poisson
    electrons = alike.electrons(filled(counts.values, counts.hidden, narrow))
    variance = alike.variance(np.zeros_like(electrons)).sum(axis=0)
    light = electrons.sum(axis=0)
    kernel = Kernel(light.shape, narrow, min(rows, columns) / 3.0)
    spread = kernel.squared(variance)
    row, column, score = kernel.maxima(light, spread, level)
    candidate = None
    if not row.size:
        lower = zip(*(each.tolist() for each in kernel.maxima(light, spread, _CANDIDATE)), strict=True)
        below = [Refused(row, column, high, "below the threshold") for row, column, high in lower]
        candidate = max(below, key=lambda one: one.score, default=None)
    own = brightest(np.column_stack([row, column]), score, _STRUCTURE * min(box))
    row, column, score = row[own], column[own], score[own]
    background = _level(light, box)
    bright = (smoothed(light, narrow) - background)[row, column]
    center, flux, peak = np.zeros((row.size, 2)), np.zeros(row.size), np.zeros(row.size)
    for k, at in enumerate(zip(row.tolist(), column.tolist(), strict=True)):
        center[k], flux[k], peak[k] = _centroid(light, background, variance, at, box)
    middle = np.rint(center).astype(np.int64)
    near = _neighbors(middle / box, bright, peak > _ONE_PIXEL, far, faint)
    reasons = unusable(middle, counts, box)
    for k, share in enumerate(peak.tolist()):
        reasons[k] = reasons[k] or ("defect" if share > _ONE_PIXEL else "neighbor" if near[k] else "")
    order = np.array([k for k in np.argsort(-score, kind="stable").tolist() if not reasons[k]][:count], np.intp)
    return PointSources(
        score=score[order],
        flux=noise.excess * flux[order],
        candidate=candidate,
        _image=np.where(counts.hidden.any(axis=0), np.nan, noise.excess * light),
        **target_windows(counts, single, center, order, box, score, reasons),
    )


def checked_window(window: int | tuple[int, int]) -> tuple[int, int]:
    """Return rows and columns of a window; ValueError if it is under 5 x 5 pixels."""
    rows, columns = validation.image_shape(window)
    if min(rows, columns) < 5:
        raise ValueError(f"window must be at least 5 x 5 pixels, got {rows} x {columns}")
    return rows, columns


def target_windows(
    counts: Counts, single: bool, center: Array, order: Values, box: tuple[int, int], score: Array, reasons: list[str]
) -> Json:
    """Return the fields of :class:`Targets`: windows in an order, masked if pixels are left out anywhere."""
    (rows, columns), left, middle = box, counts.hidden, np.rint(center).astype(np.int64)
    at = np.s_[:, *box_pixels(middle[order] - np.array([rows // 2, columns // 2]), box)]
    values, out = (np.ascontiguousarray(np.moveaxis(part[at], 0, 1)) for part in (counts.values, left))
    cut = np.ma.MaskedArray(values, mask=out) if left.any() else values
    each = zip(middle.tolist(), score.tolist(), reasons, strict=True)
    refused = [Refused(row, column, height, reason) for (row, column), height, reason in each if reason]
    return {
        "places": middle[order],
        "centers": center[order],
        "windows": cut[:, 0] if single else cut,
        "refused": tuple(sorted(refused, key=lambda one: -one.score)),
        "shape": left.shape[1:],
        "left_out": int(left.sum()),
    }


def unusable(middle: NDArray[np.int64], counts: Counts, box: tuple[int, int]) -> list[str]:
    """Return for each place why its window cannot be fitted: "saturated", "edge" or "masked"; or ""."""
    (rows, columns), full, found = box, np.asarray(counts.full.any(axis=0)), list[str]()
    for top, first in (middle - [rows // 2, columns // 2]).tolist():
        window = full[max(top, 0) : max(top + rows, 0), max(first, 0) : max(first + columns, 0)]
        part = counts.hidden[:, max(top, 0) : top + rows, max(first, 0) : first + columns]
        # Masked pixels near the target matter more than at the edge of the window.
        inner = part[:, rows // 4 : rows - rows // 4, columns // 4 : columns - columns // 4]
        if window.any():
            found.append("saturated")
        elif window.shape != box or min(top, first) < 0:
            found.append("edge")
        else:
            found.append("masked" if max(part.mean(), inner.mean()) >= _HIT else "")
    return found


def _level(light: Array, box: tuple[int, int]) -> Array:
    """Return the background: the median over cells of about a window, which few pixels of a spot do not shift."""
    cells = tuple(max(1, round(side / size)) for side, size in zip(light.shape, box, strict=True))
    edges = [np.linspace(0, side, n + 1).astype(int) for side, n in zip(light.shape, cells, strict=True)]
    found = np.array(
        [[np.median(light[a:b, c:d]) for c, d in zip(edges[1], edges[1][1:], strict=False)]
         for a, b in zip(edges[0], edges[0][1:], strict=False)]
    )  # fmt: skip
    # A cell that a spot fills is as its neighbours are.
    smooth = ndimage.median_filter(found, size=3, mode="nearest")
    at = [(np.arange(side) + 0.5) * n / side - 0.5 for side, n in zip(light.shape, cells, strict=True)]
    return np.asarray(ndimage.map_coordinates(smooth, np.meshgrid(*at, indexing="ij"), order=1, mode="nearest"))


def _centroid(
    light: Array, background: Array, variance: Array, at: tuple[int, int], box: tuple[int, int]
) -> tuple[Array, float, float]:
    """Return the centroid of a spot, its electrons in a window, and the share of the brightest pixel in them."""
    middle = np.array(at, dtype=np.float64)
    for turn in range(3):  # twice near the middle, then the whole window for its light
        share = 0.5 if turn == 2 else _STRUCTURE
        reach = [max(1, int(share * side)) for side in box]
        low = np.clip(np.rint(middle).astype(int) - reach, 0, np.array(light.shape) - 1)
        high = np.minimum(np.rint(middle).astype(int) + reach + 1, light.shape)
        part = np.s_[low[0] : high[0], low[1] : high[1]]
        above = light[part] - background[part]
        noise = np.sqrt(np.maximum(background[part], 0.0) + variance[part] + 1e-12)
        # Pixels above the noise alone: those of the background would pull the centroid to the middle of the window.
        bright = np.where(above > 3.0 * noise, above, 0.0)
        total = float(bright.sum())
        if turn < 2 and total > 0.0:
            rows, columns = np.mgrid[low[0] : high[0], low[1] : high[1]]
            middle = np.array([(bright * rows).sum() / total, (bright * columns).sum() / total])
    return middle, float(above.sum()), float(bright.max()) / total if total > 0.0 else 0.0


def _neighbors(places: Array, bright: Array, single: NDArray[np.bool_], reach: float, faint: float) -> list[bool]:
    """Return which places, in windows, have another within reach that is not much dimmer.

    A `single` pixel that is a defect has no light around it: it counts within the window alone.
    """
    found = [False] * len(places)
    if len(places) > 1 and reach > 0.0:
        for pair in cKDTree(places).query_pairs(reach * (1.0 - 1e-9), p=math.inf):
            outside = np.abs(places[pair[0]] - places[pair[1]]).max() > _INSIDE
            for one, other in (pair, pair[::-1]):
                found[one] |= bool(bright[other] >= faint * bright[one]) and not (single[other] and outside)
    return found


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Crossings(Targets):
    """Crossings of a checkerboard in an image or several exposures: the answer of :func:`lommel.find_crossings`.

    Attributes
    ----------
    places : ndarray of int, shape (n, 2)
        Row and column, in the image, of the middle pixel ``(rows // 2, columns // 2)`` of each window, row by row.
    centers : ndarray, shape (n, 2)
        Row and column of the saddle of the smoothed image, to a tenth of a pixel or so.
    windows : ndarray, shape (n, rows, columns), of exposures (n, exposures, rows, columns)
        Cut from the image, in its unit and type; a masked array if pixels of the image are left out.
    indices : ndarray, shape (n, 2)
        Row and column of each on the board, as of :func:`lommel.grid_indices`: ideal places, but for distortion. NaN
        where not known.
    contrast : ndarray, shape (n,)
        White less black squares, electrons a pixel in all exposures together; a rough estimate.
    square : float
        Side of a square in the image, pixels: the median distance between neighbours; NaN of fewer than two.
    refused : tuple of Refused
        Row, column, score (standard deviations of the noise) and reason of the others: "saturated", "edge",
        "masked" or "neighbor".
    shape : (int, int)
        Of the image.
    left_out : int
        Number of pixels of all exposures that are masked, NaN or infinite.
    """

    indices: Array
    contrast: Array
    square: float

    @property
    def message(self) -> str:
        """How many were found, and how many refused for each reason."""
        apart = f", {self.square:.3g} pixels apart" if math.isfinite(self.square) else ""
        return self._refusal_note("crossing", apart)


def find_crossings(
    images: ArrayLike,
    *,
    noise: Noise,
    window: int | tuple[int, int] | None = None,
    threshold: float = 8.0,
    width: float = 2.0,
    mask: ArrayLike | None = None,
    saturation: float | None = None,
    most: int | None = None,
) -> Crossings:
    """Find the crossings of a checkerboard, where four squares meet, and cut a window around each.

    Parameters
    ----------
    images : array_like, shape (height, width) or (exposures, height, width)
        As recorded, in the unit of `noise`; exposures are of one chart that did not move.
        NaN, infinite and masked values are left out.
    noise : Noise
        Gain, offset and read noise of the camera, each a number or a map of the image.
    window : int or (int, int), optional
        Rows and columns of the windows, at least 5. By default as large as squares allow without overlap, 9 to 21.
    threshold : float, default 8.0
        Least height of a crossing in standard deviations of the noise, at least 3.
    width : float, default 2.0
        Standard deviation of the smoothing in pixels, at least 1: about that of the blur of edges. Squares must be
        larger than four of these.
    mask : array_like of bool, shape of `images` or (height, width), optional
        True where a pixel is to be left out, such as defects.
    saturation : float, optional
        Values from here on, in the unit of the images, are saturated. In images of integers the largest value of
        their type always is.
    most : int, optional
        Keep only so many, spread over the image.

    Returns
    -------
    Crossings
        Places and windows for ``fit_field(..., targets="crossing")``, and those refused with the reason of each.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, an image is smaller than the window, or all of its pixels are left out.

    Notes
    -----
    Maxima of minus the determinant of the Hessian of the smoothed image, where it is a saddle (Rufli, Scaramuzza and
    Siegwart 2008, doi:10.1109/IROS.2008.4650703, compare detectors). Around a crossing brightness changes between
    white and black four times: the second harmonic on a ring has most of the variance there. Borders of a chart,
    where three squares or two meet, ends of lines and print do not.

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
    validation.instance("noise", noise, Noise)
    level = validation.real("threshold", threshold, least=3.0, most=1e3)
    sigma = validation.real("width", width, least=1.0, most=50.0)
    count = None if most is None else validation.integer("most", most, least=1, most=10**9)
    rows, columns = least = box or (_LEAST, _LEAST)
    shape = f"(height, width) or (exposures, height, width), at least the window of {rows} x {columns}"
    counts, single = image_counts("images", images, shape, least, mask=mask, saturation=saturation)
    electrons = noise.electrons(filled(counts.values, counts.hidden, sigma))
    light, variance = electrons.sum(axis=0), noise.variance(np.maximum(electrons, 0.0)).sum(axis=0)
    center, score, contrast = _saddles(light, variance, sigma, level)
    apart = _nearest(center)
    square = float(np.median(np.sqrt((apart**2).sum(axis=1)))) if len(center) > 1 else math.nan
    if box is None:
        room = float(np.percentile(np.abs(apart).max(axis=1), _SPACED)) if len(center) > 1 else float(_MOST)
        side = int(min(max(room, _LEAST), _MOST, *light.shape))
        box = (side - 1 + side % 2,) * 2
    middle = np.rint(center).astype(np.int64)
    reasons = unusable(middle, counts, box)
    usable = np.flatnonzero([not reason for reason in reasons])
    kept = brightest(middle[usable] / box, contrast[usable], APART)
    for k in usable[~kept]:
        reasons[k] = "neighbor"
    order = _spread(center, usable[kept], count)
    order = order[np.lexsort((middle[order, 1], middle[order, 0]))]
    indices = np.full_like(center, np.nan)
    with suppress(ValueError):
        indices = grid_indices(center)
    return Crossings(
        indices=indices[order],
        contrast=contrast[order],
        square=square,
        _image=np.where(counts.hidden.any(axis=0), np.nan, light),
        **target_windows(counts, single, center, order, box, score, reasons),
    )


def _saddles(light: Array, variance: Array, sigma: float, level: float) -> tuple[Array, Array, Array]:
    """Return places (n, 2) of crossings, heights in standard deviations, and their contrast in electrons."""

    def derived(rows: int, columns: int) -> Array:
        return np.asarray(ndimage.gaussian_filter(light, sigma, order=(rows, columns), mode="nearest"))

    across, along, mixed = derived(0, 2), derived(2, 0), derived(1, 1)
    # Of white noise of variance v the mixed derivative has v / (16 pi sigma^6), and the others three times that.
    noise = ndimage.gaussian_filter(variance, sigma / math.sqrt(2.0), mode="nearest") / (16.0 * math.pi * sigma**6)
    saddle = np.maximum(mixed * mixed - across * along, 0.0)
    height = np.sqrt(saddle / np.maximum(noise, 1e-12))
    near = 2 * math.ceil(sigma) + 1
    peak = (saddle == ndimage.maximum_filter(saddle, size=near, mode="nearest")) & (height >= level)
    peak[[0, -1]] = peak[:, [0, -1]] = False
    row, column = np.nonzero(peak)
    center = np.column_stack([row, column]).astype(np.float64)
    for axis, step in ((0, (1, 0)), (1, (0, 1))):  # the vertex of a parabola through three values
        low, high = saddle[row - step[0], column - step[1]], saddle[row + step[0], column + step[1]]
        bend = 2.0 * saddle[row, column] - low - high
        center[:, axis] += np.clip(0.5 * (high - low) / np.maximum(bend, 1e-300), -0.5, 0.5)
    turn = 2.0 * math.pi * np.arange(_POINTS) / _POINTS
    at = center[:, :, None] + _RING * sigma * np.stack([np.sin(turn), np.cos(turn)])
    # Brightness outside of the image is not known: such points are at its border.
    ring = ndimage.map_coordinates(
        ndimage.gaussian_filter(light, 0.5 * sigma, mode="nearest"), at.swapaxes(0, 1), order=1, mode="nearest"
    )
    power = np.abs(np.fft.rfft(ring, axis=1)[:, 1:]) ** 2 if len(ring) else np.zeros((0, _POINTS // 2))
    power[:, -1:] *= 0.5
    contrast = np.pi * np.sqrt(power[:, 1]) / _POINTS  # of a square wave
    good = power[:, 1] > _ALIKE * np.maximum(power.sum(axis=1), 1e-300)
    if good.any():
        good &= contrast > _CONTRAST * np.percentile(contrast[good], 75.0)
    return center[good], height[row, column][good], contrast[good]


def _spread(center: Array, kept: NDArray[np.intp], most: int | None) -> NDArray[np.intp]:
    """Return at most so many of the places kept, each as far from those before as any."""
    if most is None or most >= len(kept):
        return kept
    places = center[kept]
    chosen, far = [int(np.argmax(((places - places.mean(axis=0)) ** 2).sum(axis=1)))], np.full(len(kept), math.inf)
    while len(chosen) < most:
        far = np.minimum(far, ((places - places[chosen[-1]]) ** 2).sum(axis=1))
        chosen.append(int(np.argmax(far)))
    return kept[chosen]


def _nearest(center: Array) -> Array:
    """Return the distance of each place to the nearest other, (n, 2)."""
    if len(center) < 2:
        return np.zeros_like(center)
    _, at = cKDTree(center).query(center, k=2)
    return np.asarray(center[at[:, 1]] - center)


def grid_indices(places: ArrayLike) -> Array:
    """Return the row and column, on a square grid, of points in an image.

    Parameters
    ----------
    places : array_like, shape (n, 2)
        Row and column of each point, such as `centers` of :func:`lommel.find_spots`, in any order; n at least 4.

    Returns
    -------
    ndarray, shape (n, 2)
        Whole numbers from 0 on, that grow downwards and to the right in an image turned by less than 45 degrees; NaN
        of points without a neighbour on the grid.

    Raises
    ------
    TypeError, ValueError
        If there are fewer points, they are not finite, or no two steps of a grid are among them.

    Notes
    -----
    From a point in the middle each neighbour is looked for a step away, and steps are measured anew there: distortion
    and perspective may change them slowly. Points may be missing, as long as there is a way around.

    Examples
    --------
    >>> import lommel as lm
    >>> lm.grid_indices([[11.0, 20.0], [10.0, 10.2], [20.1, 9.8], [20.3, 20.0]]).tolist()
    [[0.0, 1.0], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]
    """
    at = validation.real_array("places", places)
    if at.ndim != 2 or at.shape[1] != 2 or len(at) < 4:
        raise ValueError(f"places must be the rows and columns of at least 4 points, got shape {at.shape}")
    tree = cKDTree(at)
    best: dict[int, tuple[int, int]] = {}
    for seed in np.argsort(((at - np.median(at, axis=0)) ** 2).sum(axis=1))[:_SEEDS].tolist():
        if seed in best or (steps := _steps(at, tree, seed)) is None:
            continue
        found = _grown(at, tree, seed, steps)
        if len(found) > len(best):
            best = found
        if len(best) > len(at) // 2:
            break
    if len(best) < 4:
        raise ValueError(f"places must be of a square grid, got {len(at)} points of which no 4 are")
    known = np.full(at.shape, np.nan)
    known[list(best)] = list(best.values())
    return np.asarray(known - np.nanmin(known, axis=0))


def _steps(places: Array, tree: cKDTree, seed: int) -> Array | None:
    """Return the steps (2, 2) downwards and to the right beside a point, None without two at about right angles."""
    away, near = tree.query(places[seed], k=min(5, len(places)))
    offsets = (places[near] - places[seed])[away > 0.0]
    unit = offsets / np.linalg.norm(offsets, axis=1)[:, None]
    down = int(np.argmax(np.abs(unit[:, 0])))
    across = int(np.argmin(np.abs(unit @ unit[down])))
    if abs(unit[across] @ unit[down]) > 0.4:
        return None
    steps = np.stack([offsets[down] * np.sign(unit[down, 0]), offsets[across]])
    if np.linalg.det(steps) < 0.0:
        steps[1] *= -1.0
    return np.asarray(steps)


def _grown(places: Array, tree: cKDTree, seed: int, steps: Array) -> dict[int, tuple[int, int]]:
    """Return the indices of points that steps lead to."""
    found, taken = {seed: (0, 0)}, {(0, 0)}
    waiting = deque([(seed, steps)])
    while waiting:
        point, own = waiting.popleft()
        for step in _STEPS:
            index = (found[point][0] + step[0], found[point][1] + step[1])
            away = np.asarray(step) @ own
            distance, other = tree.query(places[point] + away)
            if index in taken or other in found or distance > _NEAR * np.linalg.norm(away):
                continue
            found[int(other)] = index
            taken.add(index)
            changed = own.copy()
            changed[0 if step[0] else 1] = sum(step) * (places[other] - places[point])
            waiting.append((int(other), changed))
    return found
