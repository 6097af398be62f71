"""Spatial frequency response of a camera from a picture of a slanted edge (ISO 12233), and an edge to render."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, numbers, plain
from lommel.base.units import per_mm

_FINE = 32  # groups per pixel in which samples of the profile are averaged, values and places
_GAP = 0.25  # pixels, largest distance between samples of the profile: the bins of ISO 12233
_MARGIN = 5.0  # pixels that an edge must be away from the sides of the picture
_LEAST, _MOST = 2.0, 40.0  # degrees between the edge and the rows or columns
_CONTRAST = 5.0  # least step over the noise of a pixel
_FLAT = 0.5  # share of the window over the profile that is 1; its ends fall as a cosine


@dataclass(frozen=True, eq=False)
class EdgeResponse:
    """The spatial frequency response (SFR) that :func:`lommel.sfr` measures.

    Attributes
    ----------
    frequencies : ndarray
        Cycles per metre across the edge, from 0 to the Nyquist frequency of the pixels.
    values : ndarray
        Modulation at each frequency, 1 at frequency 0.
    errors : ndarray
        Standard error of each value by the noise of the picture.
    angle : float
        Direction of the frequencies, radians from the axis along columns (x) to that along rows (y): of the normal of
        the edge. ``lm.mtf(pupil, f * cos(angle), f * sin(angle), pixel=pixel)`` is the same of a lens.
    contrast : float
        Step of the edge over the sum of both sides, as of Michelson.
    """

    frequencies: Array
    values: Array
    errors: Array
    angle: float
    contrast: float

    def __call__(self, frequency: ArrayLike) -> Numbers:
        """Return the response at a `frequency`, cycles per metre, interpolated; ValueError beyond Nyquist's."""
        asked = validation.real_array("frequency", frequency, least=0.0)
        if asked.size and asked.max() > self.frequencies[-1] * (1.0 + 1e-12):
            raise ValueError(
                f"frequency must be at most that of Nyquist, {per_mm(float(self.frequencies[-1]))}, "
                f"got {per_mm(float(asked.max()))}"
            )
        return numbers(np.interp(asked, self.frequencies, self.values), asked.shape)

    def __repr__(self) -> str:
        half = np.flatnonzero(self.values < 0.5)
        said = f"0.5 at {per_mm(float(self.frequencies[half[0]]))}" if half.size else "above 0.5"
        return f"<EdgeResponse {said}, {self.values[-1]:.3f} at Nyquist, {per_mm(float(self.frequencies[-1]))}>"

    def to_dict(self) -> dict[str, object]:
        """Return all as plain data."""
        return {name: plain(value) for name, value in vars(self).items()}


def sfr(image: ArrayLike, pixel: float) -> EdgeResponse:
    """Return the spatial frequency response of a camera from its picture of a slanted edge.

    The picture shows one straight edge between two even areas, nearly upright or nearly level. The place of the edge
    in each row (or column) is the centroid of the differences; a line through these places projects all pixels onto
    the normal of the edge. In the order of their distance from it, differences of neighbours are the light of the
    line spread function between them, whose Fourier transform is the response.

    Parameters
    ----------
    image : array_like, shape (height, width)
        In linear light, of one channel: decoded, not sharpened; at least 20 pixels on either side.
    pixel : float
        Pixel pitch, metres.

    Returns
    -------
    EdgeResponse
        Of optics, pixels and all processing. Its values are off by noise (`errors`), by less than 0.001 as the line
        is fitted, and by the share of the light that the picture cuts off: diffraction alone sends some 0.3 % of it
        farther than 45 pixels of 2 lambda*N, and all values are too large by that.

    Raises
    ------
    TypeError, ValueError
        If the picture is no such image; the edge has less contrast than noise, is nearer than 5 pixels to a side, or
        its angle to rows and columns is not between 2 and 40 degrees; or its slope is a fraction such as 1/3, whose
        samples of the profile are farther apart than a quarter pixel.

    Notes
    -----
    ISO 12233:2017, e-SFR; P. D. Burns, Proc. IS&T PICS, 135 (2000). These average the profile in bins of a quarter
    pixel and correct for the differences of bins; bins that a slope fills unevenly change the response by up to 0.05.
    Samples at their own places, as here, need no correction. The window is 1 over the middle half of the profile in
    place of Hamming's, which leaves the halo of blur in.

    Examples
    --------
    >>> edge = lm.imaging.slanted_edge((64, 64), angle=5.0, supersample=8)
    >>> lens = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    >>> depth = np.full(edge.shape, 2.0)
    >>> photo = lm.imaging.depth_of_field(edge, depth, lens, 4e-6, encoding="linear", supersample=8)
    >>> lm.sfr(photo.values, 4e-6)
    <EdgeResponse above 0.5, 0.547 at Nyquist, 125 cycles/mm>
    """
    values = validation.real_array("image", image)
    side = validation.pixel(pixel, metric=True)
    if values.ndim != 2 or min(values.shape) < 20:
        raise ValueError(f"image must have the shape (height, width), 20 pixels or more each, got {values.shape}")
    # As if the edge were nearly upright.
    level = np.ptp(values.mean(axis=1)) > np.ptp(values.mean(axis=0))
    upright = values.T if level else values
    start, slope = _edge(upright)
    degrees = math.degrees(math.atan(abs(slope)))
    if not _LEAST <= degrees <= _MOST:
        raise ValueError(
            f"image must have an edge at {_LEAST:g} to {_MOST:g} degrees to its rows or columns, got {degrees:.2g}"
        )
    height, width = upright.shape
    ends = start, start + slope * (height - 1)
    if min(ends) < _MARGIN or max(ends) > width - 1 - _MARGIN:
        raise ValueError(f"image must hold the whole edge, {_MARGIN:g} pixels from its sides; it leaves them")
    rows, columns = np.indices((height, width))
    cosine = math.cos(math.atan(slope))
    distance = ((columns - start - slope * rows) * cosine).ravel()  # pixels
    reach = min(*ends, width - 1 - max(ends)) * cosine
    inside = np.abs(distance) <= reach
    distance, light = distance[inside], upright.ravel()[inside]
    place, profile, weights = _averaged(distance, light)
    if np.diff(place).max() > _GAP:
        raise ValueError(
            f"image must have an edge whose slope is no fraction such as 1/3: that of {slope:.4g} leaves gaps of "
            f"{np.diff(place).max():.2g} pixels in the profile; turn it by a degree"
        )
    values_at, errors = _response(place, profile, _noise(distance, light, reach) ** 2 / weights)
    frequencies = np.linspace(0.0, 0.5, values_at.size) / side
    # The normal of the line x = start + slope y is along (1, -slope).
    angle = math.atan2(1.0, -slope) if level else math.atan2(-slope, 1.0)
    far = [light[where].mean() for where in (distance < -0.8 * reach, distance > 0.8 * reach)]
    contrast = abs(far[1] - far[0]) / max(far[0] + far[1], 1e-300)
    return EdgeResponse(frequencies, values_at, errors, angle, float(contrast))


def _averaged(distance: Array, light: Array) -> tuple[Array, Array, Array]:
    """Return places, values and numbers of samples, averaged in groups that are narrow against a pixel."""
    groups = np.floor(_FINE * (distance - distance.min())).astype(int)
    counts = np.bincount(groups).astype(float)
    filled = counts > 0
    place, values = (np.bincount(groups, part)[filled] / counts[filled] for part in (distance, light))
    return place, values, counts[filled]


def _edge(values: Array) -> tuple[float, float]:
    """Return the place of an upright edge in the first row, and its slope, pixels per row."""
    height, width = values.shape
    differences = np.diff(values, axis=1)
    noise = 1.4826 * np.median(np.abs(differences)) / math.sqrt(2.0)
    differences = differences * np.sign(differences.sum())
    rows, places = np.arange(height), np.arange(width - 1) + 0.5
    line, reach = np.array([0.0, 0.5 * (width - 1)]), float(width)
    # The noise of all columns pulls centroids to the middle: the second and third time near the edge alone.
    for _ in range(3):
        near = np.abs(places - np.polyval(line, rows)[:, None]) <= reach
        steps = np.where(near, differences, 0.0)
        step = steps.sum(axis=1)
        if not np.median(step) > _CONTRAST * noise:
            raise ValueError("image must show an edge that exceeds the noise of its pixels")
        good = step > 0.5 * np.median(step)
        line = np.polyfit(rows[good], ((steps * places).sum(axis=1)[good]) / step[good], 1)
        reach = max(8.0, 0.25 * width)
    return float(line[1]), float(line[0])


def _noise(distance: Array, light: Array, reach: float) -> float:
    """Return the standard deviation of pixels about straight lines through the outer thirds of the profile."""
    squares, count = 0.0, 0
    for far in (distance < -0.67 * reach, distance > 0.67 * reach):
        line = np.polyfit(distance[far], light[far], 1)
        squares += float(np.square(light[far] - np.polyval(line, distance[far])).sum())
        count += int(far.sum()) - 2
    return math.sqrt(squares / max(count, 1))


def _response(place: Array, profile: Array, variances: Array) -> tuple[Array, Array]:
    """Return the response of a profile at places in pixels, up to half a cycle per pixel, and standard errors."""
    reach, gaps, middle = float(np.abs(place).max()), np.diff(place), 0.5 * (place[1:] + place[:-1])
    window = np.sin(0.5 * math.pi * np.clip((1.0 - np.abs(middle) / reach) / (1.0 - _FLAT), 0.0, 1.0)) ** 2
    frequencies = np.linspace(0.0, 0.5, max(int(reach), 2))
    waves = window * np.exp(-2j * math.pi * np.outer(frequencies, middle)) * np.sinc(np.outer(frequencies, gaps))
    response = waves @ np.diff(profile)
    # Derivative of the modulus over that at frequency 0, by each sample, for their noise.
    edges = np.zeros((frequencies.size, 1))
    slopes = -np.diff(np.hstack([edges, waves, edges]), axis=1)
    along = np.real(slopes * np.exp(-1j * np.angle(response))[:, None])
    values = np.abs(response) / abs(response[0])
    along -= np.outer(values, along[0])
    return values, np.sqrt(along**2 @ variances) / abs(response[0])


def slanted_edge(
    shape: tuple[int, int],
    *,
    angle: float = 5.0,
    supersample: int = 8,
    dark: float = 0.1,
    bright: float = 0.9,
) -> NDArray[np.float32]:
    """Return a slanted edge in linear light, dark to the left, to render by :func:`lommel.imaging.depth_of_field`.

    Parameters
    ----------
    shape : (int, int)
        Height and width of the photograph that is to be rendered, pixels.
    angle : float, default 5.0
        Degrees of the edge from upright, 2 to 40.
    supersample : int, default 8
        Pixels of the edge along a side of a pixel of the photograph, 1 to 16.
    dark, bright : float, default 0.1, 0.9
        Light of both sides, white being 1.

    Returns
    -------
    ndarray, shape (height supersample, width supersample)
        The edge is as wide as one of these pixels, by the share that it covers: it has the response
        ``sinc(f pixel / supersample)``, 0.9936 at the Nyquist frequency of the photograph with 8.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.
    """
    height, width = validation.image_shape(shape)
    more = validation.integer("supersample", supersample, least=1, most=16)
    turn = math.radians(validation.real("angle", angle, least=_LEAST, most=_MOST))
    low, high = (validation.real(name, value, least=0.0) for name, value in (("dark", dark), ("bright", bright)))
    if not low < high:
        raise ValueError(f"bright must exceed dark, got {high:g} and {low:g}")
    y, x = (np.arange(side * more) - 0.5 * (side * more - 1) for side in (height, width))
    covered = np.clip((x + np.tan(turn) * y[:, None]) * math.cos(turn) + 0.5, 0.0, 1.0)
    return np.asarray(low + (high - low) * covered, dtype=np.float32)
