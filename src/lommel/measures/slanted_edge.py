"""Spatial frequency response of a camera from a picture of a slanted edge (ISO 12233), and a synthetic edge.

The light as a function of the signed distance from the edge is called the profile (edge spread function); its
derivative is the line spread function, whose Fourier transform is the response.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, numbers, plain
from lommel.base.units import per_mm

_BINS_PER_PIXEL = 32  # number of bins per pixel; a bin holds the mean position and the mean value of its samples
_MAX_GAP = 0.25  # largest distance between samples of the profile, pixels: the width of the bins of ISO 12233
_MARGIN = 5.0  # smallest distance of the edge from the sides of the picture, pixels
_MIN_ANGLE, _MAX_ANGLE = 2.0, 40.0  # angle between the edge and the rows or columns, degrees
_MIN_CONTRAST = 5.0  # smallest step at the edge divided by the standard deviation of the noise of a pixel
_PLATEAU = 0.5  # fraction of the profile over which its window function is 1; it falls to 0 like cos^2 at both ends
_MAX_FULL = 0.01  # largest fraction of pixels with the largest integer


@dataclass(frozen=True, eq=False)
class EdgeResponse:
    """The spatial frequency response (SFR) that :func:`lommel.sfr` measures.

    Attributes
    ----------
    frequencies : ndarray
        Spatial frequencies perpendicular to the edge, cycles per metre, from 0 to the Nyquist frequency of the
        pixels.
    values : ndarray
        Modulation at each frequency, 1 at frequency 0.
    errors : ndarray
        Standard error of each value due to the noise of the picture.
    angle : float
        Direction of the normal of the edge, radians from x (increasing columns) to y (increasing rows). The MTF of a
        lens in this direction is ``lm.mtf(pupil, f * cos(angle), f * sin(angle), pixel=pixel)``.
    contrast : float
        Michelson contrast of the edge, (bright - dark) / (bright + dark).
    """

    frequencies: Array
    values: Array
    errors: Array
    angle: float
    contrast: float

    def __call__(self, frequency: ArrayLike) -> Numbers:
        """Interpolate the response at `frequency`, cycles per metre; ValueError above the Nyquist frequency."""
        f = validation.real_array("frequency", frequency, least=0.0, unit="1/metres")
        if f.size and f.max() > self.frequencies[-1] * (1.0 + 1e-12):
            raise ValueError(
                f"frequency must be at most the Nyquist frequency, {per_mm(float(self.frequencies[-1]))}, "
                f"got {per_mm(float(f.max()))}"
            )
        return numbers(np.interp(f, self.frequencies, self.values), f.shape)

    def __repr__(self) -> str:
        below_half = np.flatnonzero(self.values < 0.5)
        mtf50 = f"0.5 at {per_mm(float(self.frequencies[below_half[0]]))}" if below_half.size else "above 0.5"
        return f"<EdgeResponse {mtf50}, {self.values[-1]:.3f} at Nyquist, {per_mm(float(self.frequencies[-1]))}>"

    def to_dict(self) -> dict[str, object]:
        """Return all attributes as plain numbers and lists."""
        return {name: plain(value) for name, value in vars(self).items()}


def sfr(image: ArrayLike, pixel: float) -> EdgeResponse:
    """Return the spatial frequency response of a camera from its picture of a slanted edge.

    The picture shows one straight, nearly vertical or nearly horizontal edge between two uniform areas. In each row
    (or column), the centroid of the differences between neighbouring pixels estimates the position of the edge. A
    straight line fitted to these positions defines the signed distance of each pixel from the edge. Differences
    between pixels in the order of this distance sample the line spread function, whose Fourier transform is the
    response.

    Parameters
    ----------
    image : array_like, shape (height, width)
        One channel in linear light, not sharpened, of at least 20 x 20 pixels.
    pixel : float
        Pixel pitch, metres.

    Returns
    -------
    EdgeResponse
        Response of optics, pixels and processing. Its values have three errors. The first is due to noise, estimated
        by `errors`. The second, below 0.001, is due to the fit of the line. The third is due to light that falls
        outside the picture: all values are too large by about its fraction. Diffraction alone spreads about 0.3 % of
        the light beyond 45 pixels if pixels are 2 lambda*N wide.

    Raises
    ------
    TypeError, ValueError
        If the image has another shape or is not finite; if it is overexposed; if the edge does not exceed the noise,
        is nearer than 5 pixels to a side or is not at 2 to 40 degrees to the rows or columns; or if its slope is a
        simple fraction such as 1/3, for which gaps in the profile exceed a quarter pixel.

    Notes
    -----
    ISO 12233:2017, e-SFR; P. D. Burns, Proc. IS&T PICS, 135 (2000). Their algorithms average the profile in bins of a
    quarter pixel, which can change the response by up to 0.05 if the bins are filled unevenly. This function avoids
    this error by bins of 1/32 pixel and by the mean position of the samples in each bin. In place of a Hamming
    window, which would suppress the halo of the blur, the window function is 1 over the middle half of the profile.

    Examples
    --------
    >>> edge = lm.imaging.slanted_edge((64, 64), angle=5.0, supersample=8)
    >>> lens = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    >>> depth = np.full(edge.shape, 2.0)
    >>> photo = lm.imaging.depth_of_field(edge, depth, lens, 4e-6, encoding="linear", supersample=8)
    >>> lm.sfr(photo.values, 4e-6)
    <EdgeResponse above 0.5, 0.547 at Nyquist, 125 cycles/mm>
    """
    values = validation.real_array("image", image, unit="counts")
    side = validation.pixel(pixel, metric=True)
    if values.ndim != 2 or min(values.shape) < 20:
        raise ValueError(f"image must have the shape (height, width) of 20 x 20 pixels or more, got {values.shape}")
    if (integers := np.asarray(image).dtype).kind in "iu" and np.mean(values == np.iinfo(integers).max) > _MAX_FULL:
        raise ValueError(
            "image must not be overexposed, got pixels with the largest value of their type: expose less"
        )
    # A nearly horizontal edge is transposed to a nearly vertical one.
    horizontal = np.ptp(values.mean(axis=1)) > np.ptp(values.mean(axis=0))
    vertical = values.T if horizontal else values
    start, slope = _fit_edge(vertical)
    degrees = math.degrees(math.atan(abs(slope)))
    if not _MIN_ANGLE <= degrees <= _MAX_ANGLE:
        raise ValueError(
            f"image must have an edge at {_MIN_ANGLE:g} to {_MAX_ANGLE:g} degrees to its rows or columns, "
            f"got {degrees:.2g}"
        )
    height, width = vertical.shape
    ends = start, start + slope * (height - 1)
    if min(ends) < _MARGIN or max(ends) > width - 1 - _MARGIN:
        raise ValueError(
            f"image must show the edge from end to end, at least {_MARGIN:g} pixels from the parallel sides, got an "
            f"edge from column {ends[0]:.1f} to {ends[1]:.1f} of {width} (rows for a horizontal edge)"
        )
    rows, columns = np.indices((height, width))
    cosine = math.cos(math.atan(slope))
    distance = ((columns - start - slope * rows) * cosine).ravel()  # pixels
    reach = min(*ends, width - 1 - max(ends)) * cosine
    is_used = np.abs(distance) <= reach
    distance, samples = distance[is_used], vertical.ravel()[is_used]
    position, profile, counts = _bin_profile(distance, samples)
    if np.diff(position).max() > _MAX_GAP:
        raise ValueError(
            f"image must have an edge whose slope is not a simple fraction such as 1/3, got a slope of {slope:.4g} "
            f"with gaps of {np.diff(position).max():.2g} pixels in the profile; turn the edge by a degree"
        )
    response, errors = _response(position, profile, _noise(distance, samples, reach) ** 2 / counts)
    frequencies = np.linspace(0.0, 0.5, response.size) / side
    # The normal of the line x = start + slope y is along (1, -slope).
    angle = math.atan2(1.0, -slope) if horizontal else math.atan2(-slope, 1.0)
    sides = [samples[mask].mean() for mask in (distance < -0.8 * reach, distance > 0.8 * reach)]
    contrast = abs(sides[1] - sides[0]) / max(sides[0] + sides[1], 1e-300)
    return EdgeResponse(frequencies, response, errors, angle, float(contrast))


def _bin_profile(distance: Array, samples: Array) -> tuple[Array, Array, Array]:
    """Return mean positions, mean values and numbers of the samples in each nonempty bin of the profile."""
    bins = np.floor(_BINS_PER_PIXEL * (distance - distance.min())).astype(int)
    counts = np.bincount(bins).astype(float)
    nonempty = counts > 0
    position, values = (np.bincount(bins, part)[nonempty] / counts[nonempty] for part in (distance, samples))
    return position, values, counts[nonempty]


def _fit_edge(values: Array) -> tuple[float, float]:
    """Return the column of a nearly vertical edge in the first row, and its slope, columns per row."""
    height, width = values.shape
    differences = np.diff(values, axis=1)
    noise = 1.4826 * np.median(np.abs(differences)) / math.sqrt(2.0)
    differences = differences * np.sign(differences.sum())
    rows, positions = np.arange(height), np.arange(width - 1) + 0.5
    line, reach = np.array([0.0, 0.5 * (width - 1)]), float(width)
    # Noise in all columns pulls the centroids towards the middle column: the second and third fit use columns near
    # the edge only.
    for _ in range(3):
        is_near = np.abs(positions - np.polyval(line, rows)[:, None]) <= reach
        steps = np.where(is_near, differences, 0.0)
        step = steps.sum(axis=1)
        if not np.median(step) > _MIN_CONTRAST * noise:
            raise ValueError("image must show an edge whose step exceeds the noise of its pixels")
        is_clear = step > 0.5 * np.median(step)
        line = np.polyfit(rows[is_clear], ((steps * positions).sum(axis=1)[is_clear]) / step[is_clear], 1)
        reach = max(8.0, 0.25 * width)
    return float(line[1]), float(line[0])


def _noise(distance: Array, samples: Array, reach: float) -> float:
    """Return the standard deviation of pixel values from lines fitted to both outer thirds of the profile."""
    squares, count = 0.0, 0
    for third in (distance < -0.67 * reach, distance > 0.67 * reach):
        line = np.polyfit(distance[third], samples[third], 1)
        squares += float(np.square(samples[third] - np.polyval(line, distance[third])).sum())
        count += int(third.sum()) - 2
    return math.sqrt(squares / max(count, 1))


def _response(position: Array, profile: Array, variances: Array) -> tuple[Array, Array]:
    """Return the response at frequencies from 0 to 0.5 cycles per pixel, and its standard errors."""
    reach, gaps, middle = float(np.abs(position).max()), np.diff(position), 0.5 * (position[1:] + position[:-1])
    window = np.sin(0.5 * math.pi * np.clip((1.0 - np.abs(middle) / reach) / (1.0 - _PLATEAU), 0.0, 1.0)) ** 2
    frequencies = np.linspace(0.0, 0.5, max(int(reach), 2))
    waves = window * np.exp(-2j * math.pi * np.outer(frequencies, middle)) * np.sinc(np.outer(frequencies, gaps))
    response = waves @ np.diff(profile)
    # Propagate the noise: the final `derivative` is that of abs(response) / abs(response[0]) with respect to
    # each sample of the profile, times abs(response[0]).
    edges = np.zeros((frequencies.size, 1))
    differences = -np.diff(np.hstack([edges, waves, edges]), axis=1)
    derivative = np.real(differences * np.exp(-1j * np.angle(response))[:, None])
    values = np.abs(response) / abs(response[0])
    derivative -= np.outer(values, derivative[0])
    return values, np.sqrt(derivative**2 @ variances) / abs(response[0])


def slanted_edge(
    shape: tuple[int, int],
    *,
    angle: float = 5.0,
    supersample: int = 8,
) -> NDArray[np.float32]:
    """Return a synthetic slanted edge in linear light, 0.1 on the left and 0.9 on the right.

    Parameters
    ----------
    shape : (int, int)
        Height and width, in pixels, of the photograph that is to be rendered from the edge.
    angle : float, default 5.0
        Angle between the edge and the columns, degrees, 2 to 40.
    supersample : int, default 8
        Number of pixels of the result along the side of a pixel of the photograph, 1 to 16.

    Returns
    -------
    ndarray, shape (height supersample, width supersample)
        Light of each pixel. The edge is blurred to the width of one pixel of the result, so that it has the response
        ``sinc(f pixel / supersample)``: 0.9936 at the Nyquist frequency of the photograph for a `supersample` of 8.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.
    """
    height, width = validation.image_shape(shape)
    factor = validation.integer("supersample", supersample, least=1, most=16)
    radians = math.radians(validation.real("angle", angle, least=_MIN_ANGLE, most=_MAX_ANGLE))
    y, x = (np.arange(side * factor) - 0.5 * (side * factor - 1) for side in (height, width))
    covered = np.clip((x + np.tan(radians) * y[:, None]) * math.cos(radians) + 0.5, 0.0, 1.0)
    return np.asarray(0.1 + (0.9 - 0.1) * covered, dtype=np.float32)
