"""Crossings of a checkerboard in images of a chart: windows around each, and why others are refused."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import ndimage
from scipy.spatial import cKDTree

from lommel import show
from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.localize.detection import filled
from lommel.localize.lattice import grid_indices
from lommel.localize.point_sources import Refused, field_counts, refusals, told, unusable, windows_around
from lommel.recorded.noise import Noise

if TYPE_CHECKING:
    from matplotlib.axes import Axes

REASONS = {
    "saturated": "a pixel of the window is saturated in an exposure",
    "edge": "the window extends beyond the image",
    "masked": "a quarter of the window, or of its middle, is masked or NaN",
    "neighbor": "the windows of two crossings would overlap, and the other has more contrast",
}
"""Why crossings are refused, in the order in which the reasons are tried."""

_LEAST, _MOST = 9, 21  # pixels of a window that is chosen
_RING = 3.0  # radius, in standard deviations of the smoothing, on which a crossing changes its sign four times
_POINTS = 64  # on it
_ALIKE = 0.55  # share of the variance on the ring that is in its second harmonic: of a square wave at least 0.68
_CONTRAST = 0.25  # of the usual, below which four squares are a print, not the chart
_SPACED = 10.0  # percent of crossings whose windows may overlap those of others


@dataclass(frozen=True, eq=False, repr=False)
class Crossings:
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

    places: NDArray[np.int64]
    centers: Array
    indices: Array
    windows: Values
    contrast: Array
    square: float
    refused: tuple[Refused, ...]
    shape: tuple[int, int]
    left_out: int
    _image: Array = field(repr=False)

    @property
    def message(self) -> str:
        """How many were found, and how many refused for each reason."""
        counts = Counter(each.reason for each in self.refused)
        left = ", ".join(f"{counts[reason]} {reason}" for reason in REASONS if counts[reason])
        apart = f", {self.square:.3g} pixels apart" if math.isfinite(self.square) else ""
        said = f"{len(self)} crossing{'s' * (len(self) != 1)} found{apart}; refused: {left or 'none'}"
        return said + told(self.left_out)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Return matplotlib axes with the image, the windows, and the refused crossings by reason.

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
        return f"<Crossings: {self.message}>"


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
    box = None if window is None else validation.image_shape(window)
    if box is not None and min(box) < 5:
        raise ValueError(f"window must be at least 5 x 5 pixels, got {box[0]} x {box[1]}")
    validation.instance("noise", noise, Noise)
    level = validation.real("threshold", threshold, least=3.0, most=1e3)
    sigma = validation.real("width", width, least=1.0, most=50.0)
    count = None if most is None else validation.integer("most", most, least=1, most=10**9)
    counts, single = field_counts(images, "exposures", box or (_LEAST, _LEAST), mask, saturation)
    planes, left, full = counts.values, counts.hidden, np.asarray(counts.full.any(axis=0))
    electrons = noise.electrons(filled(planes, left, sigma))
    light, variance = electrons.sum(axis=0), noise.variance(np.maximum(electrons, 0.0)).sum(axis=0)
    center, score, contrast = _saddles(light, variance, sigma, level)
    apart = _nearest(center)
    square = float(np.median(np.sqrt((apart**2).sum(axis=1)))) if len(center) > 1 else math.nan
    if box is None:
        room = float(np.percentile(np.abs(apart).max(axis=1), _SPACED)) if len(center) > 1 else float(_MOST)
        side = int(min(max(room, _LEAST), _MOST, *light.shape))
        box = (side - 1 + side % 2,) * 2
    middle = np.rint(center).astype(np.int64)
    reasons = _reasons(middle, contrast, full, left, box)
    kept = np.array([not reason for reason in reasons], dtype=bool)
    order = _spread(center, np.flatnonzero(kept), count)
    order = order[np.lexsort((middle[order, 1], middle[order, 0]))]
    cut = windows_around(planes, left, middle[order], box)
    return Crossings(
        places=middle[order],
        centers=center[order],
        indices=_indices(center)[order],
        windows=cut[:, 0] if single else cut,
        contrast=contrast[order],
        square=square,
        refused=refusals(middle, score, reasons),
        shape=(light.shape[0], light.shape[1]),
        left_out=int(left.sum()),
        _image=np.where(left.any(axis=0), np.nan, light),
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


def _indices(center: Array) -> Array:
    """Return the row and column of each crossing on the board, NaN where there is none."""
    try:
        return grid_indices(center)
    except ValueError:
        return np.full_like(center, np.nan)


def _nearest(center: Array) -> Array:
    """Return the distance of each place to the nearest other, (n, 2)."""
    if len(center) < 2:
        return np.zeros_like(center)
    _, at = cKDTree(center).query(center, k=2)
    return np.asarray(center[at[:, 1]] - center)


def _reasons(
    middle: NDArray[np.int64],
    contrast: Array,
    full: NDArray[np.bool_],
    left: NDArray[np.bool_],
    box: tuple[int, int],
) -> list[str]:
    """Return the reason why each crossing is refused, or ""."""
    rows, columns = box
    found = [unusable(row, column, full, left, box) for row, column in middle.tolist()]
    usable = [k for k in np.argsort(-contrast, kind="stable").tolist() if not found[k]]
    taken: list[int] = []
    for k in usable:
        beside = np.abs(middle[taken] - middle[k]) < [rows, columns] if taken else np.zeros((0, 2), dtype=bool)
        if beside.all(axis=1).any():
            found[k] = "neighbor"
        else:
            taken.append(k)
    return found
