"""Crossings of a checkerboard in images of a chart, why others are refused, and indices on a square grid."""

from __future__ import annotations

import math
from collections import deque
from contextlib import suppress
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import ndimage
from scipy.spatial import cKDTree

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.localize.detection import APART, brightest, filled, image_counts
from lommel.localize.point_sources import Targets, checked_window, target_windows, unusable
from lommel.recorded.noise import Noise

_LEAST, _MOST = 9, 21  # pixels of a window that is chosen
_RING = 3.0  # radius, in standard deviations of the smoothing, on which a crossing changes its sign four times
_POINTS = 64  # on it
_ALIKE = 0.55  # share of the variance on the ring that is in its second harmonic: of a square wave at least 0.68
_CONTRAST = 0.25  # of the usual, below which four squares are a print, not the chart
_SPACED = 10.0  # percent of crossings whose windows may overlap those of others
_STEPS = ((1, 0), (-1, 0), (0, 1), (0, -1))
_NEAR = 0.25  # of a step: how far a point may be from where its neighbour says
_SEEDS = 20


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
        return self._told("crossing", apart)


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
    far = ((places - places.mean(axis=0)) ** 2).sum(axis=1)
    chosen = []
    for k in range(most):
        chosen.append(int(np.argmax(far)))
        away = ((places - places[chosen[-1]]) ** 2).sum(axis=1)
        far = np.minimum(far, away) if k else away
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
