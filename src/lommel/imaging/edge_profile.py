"""Location of a slanted edge in a picture, correction of uneven light, and the response of its profile.

The light as a function of the signed distance from the edge is called the profile (edge spread function); its
derivative is the line spread function, whose Fourier transform is the response.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray
from scipy.ndimage import uniform_filter

from lommel.base.arrays import Array

Mask = NDArray[np.bool_]

_BINS_PER_PIXEL = 32  # number of bins per pixel; a bin holds the mean position and the mean value of its samples
_MAX_GAP = 0.25  # largest distance between samples of the profile, pixels: the width of the bins of ISO 12233
_MARGIN = 5.0  # smallest distance of the edge from the sides of the picture, pixels
MIN_ANGLE, MAX_ANGLE = 2.0, 40.0
"""Angle between the edge and the rows or columns, degrees."""
_MIN_CONTRAST = 5.0  # smallest step at the edge divided by the standard deviation of the noise of a pixel
_PLATEAU = 0.5  # fraction of the profile over which its window function is 1; it falls to 0 like cos^2 at both ends
_FAR = 0.6  # fraction of the profile beyond which pixels show the uniform sides
_STEPS, _TERMS = 5, 4  # of the fit of the edge, and number of its Legendre polynomials
SIGMA = 4.5
"""Standard errors from which a curvature, a trend of the light and other faults count."""
_MIN_CURVATURE = 0.01  # smallest that is corrected, pixels
MIN_TREND = 0.02
"""Smallest trend of the light over the picture, as a fraction, that is corrected: it changes responses by 0.007."""
_OUTLIER, _SLOPE, _LEAST = 6.0, 0.3, 0.02  # of outliers: standard deviations, pixels, fraction of the step


class Edge(NamedTuple):
    """A nearly vertical edge in a picture; distances are in pixels.

    `light` is corrected for uneven light, `used` are the pixels that are known and no outliers, `distance` is signed,
    from the edge to each pixel, and `reach` the distance to which the profile extends. `levels` and `variances` are
    the light on the sides of negative and of positive distance, and the variance of its noise. `line` has the
    coefficients of the Legendre polynomials of the column of the edge, from the first to the last row.
    `trend` is the fitted change of the light across the picture, `tail` the change of both sides towards the edge,
    both as fractions.
    """

    light: Array
    used: Mask
    distance: Array
    reach: float
    levels: tuple[float, float]
    variances: tuple[float, float]
    line: Array
    outliers: int
    trend: float
    tail: float
    width: float

    @property
    def step(self) -> float:
        """Difference of the light on both sides."""
        return abs(self.levels[1] - self.levels[0])

    @property
    def slope(self) -> float:
        """Mean slope of the edge, columns per row."""
        return float(2.0 * self.line[1] / (len(self.light) - 1))

    @property
    def curvature(self) -> float:
        """Largest distance of the edge from a straight line, pixels, about."""
        return float(1.5 * np.abs(self.line[2:]).max())

    def profile(self) -> tuple[Array, Array, Array, Array]:
        """Return positions, values, numbers of samples and variances of the profile."""
        inside = self.used & (np.abs(self.distance) <= self.reach)
        position, profile, counts = _bin_profile(self.distance[inside], self.light[inside])
        dark, bright = self.variances
        share = np.clip((profile - self.levels[0]) / (self.levels[1] - self.levels[0]), 0.0, 1.0)
        return position, profile, counts, (dark + (bright - dark) * share) / counts


def locate(image: Array, known: Mask) -> Edge:
    """Return the nearly vertical edge in a picture; ValueError if there is none."""
    height = len(image)
    start, slope = _fit_edge(_filled(image, known))
    t = np.linspace(-1.0, 1.0, height)
    line = np.array([start + 0.5 * slope * (height - 1), 0.5 * slope * (height - 1), *[0.0] * (_TERMS - 2)])
    light, used = image, known
    trend = tail = 0.0
    distance, reach = _distances(line, image.shape)
    levels, variances = _sides(light, distance, reach, used)
    count = 2
    for step in range(2 * _STEPS):
        line[count:] = 0.0
        distance, reach = _distances(line, image.shape)
        if step in (1, _STEPS):
            light, trend, tail = _evened(image, distance, reach, used)
            levels, variances = _sides(light, distance, reach, used)
        nodes, values = _smooth_profile(distance, light, used, height)
        expected = np.interp(distance, nodes, values)
        gradient = np.interp(distance, 0.5 * (nodes[1:] + nodes[:-1]), np.diff(values) / np.diff(nodes))
        size = abs(levels[1] - levels[0])
        share = np.clip((expected - levels[0]) / (levels[1] - levels[0] or 1.0), 0.0, 1.0)
        sigma = np.sqrt(variances[0] + (variances[1] - variances[0]) * share)
        residual = light - expected
        used = known & (np.abs(residual) <= _OUTLIER * sigma + _SLOPE * np.abs(gradient) + _LEAST * size)
        near = np.abs(distance) <= min(_width(nodes, values, levels), reach)
        weight = np.where(used & near, gradient, 0.0)
        basis = legendre.legvander(t, _TERMS - 1)[:, :count]
        normal = (basis * np.square(weight).sum(axis=1)[:, None]).T @ basis
        # Columns move by residual / -gradient; `weight` is the gradient per pixel of distance, which is close.
        inverse = np.linalg.pinv(normal)
        line[:count] -= inverse @ (basis.T @ (weight * residual).sum(axis=1))
        if step == _STEPS - 1:  # the straight edge has settled
            count = _TERMS
        elif step == 2 * _STEPS - 3 and count == _TERMS:
            errors = np.sqrt(np.diag(inverse) * float(np.mean(np.square(sigma[near]))))[2:]
            bent = (np.abs(line[2:]) > SIGMA * errors) & (np.abs(line[2:]) > _MIN_CURVATURE)
            count = _TERMS if bent.any() else 2
    distance, reach = _distances(line, image.shape)
    levels, variances = _sides(light, distance, reach, used)
    outliers = int((known & ~used).sum())
    width = _width(*_smooth_profile(distance, light, used, height), levels)
    return Edge(light, used, distance, reach, levels, variances, line, outliers, trend, tail, width)


def require_measurable(edge: Edge, pitch: float) -> None:
    """Raise ValueError if an edge is too near to a side, at another angle, or leaves gaps in its profile."""
    degrees = math.degrees(math.atan(abs(edge.slope)))
    if not MIN_ANGLE <= degrees <= MAX_ANGLE:
        raise ValueError(
            f"image must have an edge at {MIN_ANGLE:g} to {MAX_ANGLE:g} degrees to its rows or columns, "
            f"got {degrees:.2g}"
        )
    width = edge.light.shape[1]
    ends = legendre.legval([-1.0, 1.0], edge.line)
    if min(ends) < _MARGIN or max(ends) > width - 1 - _MARGIN:
        raise ValueError(
            f"image must show the edge from end to end, at least {_MARGIN:g} pixels from the parallel sides, got an "
            f"edge from column {ends[0]:.1f} to {ends[1]:.1f} of {width} (rows for a horizontal edge)"
        )
    gap = float(np.diff(edge.profile()[0]).max(initial=0.0))
    if gap > _MAX_GAP * pitch:
        raise ValueError(
            f"image must have an edge whose slope is not a simple fraction such as 1/3, got a slope of "
            f"{edge.slope:.4g} with gaps of {gap:.2g} pixels in the profile; turn the edge by a degree"
        )


def response(position: Array, profile: Array, variances: Array, most: float = 0.5) -> tuple[Array, Array]:
    """Return the response at frequencies from 0 to `most` cycles per pixel, and its standard errors."""
    reach, gaps, middle = float(np.abs(position).max()), np.diff(position), 0.5 * (position[1:] + position[:-1])
    window = np.sin(0.5 * math.pi * np.clip((1.0 - np.abs(middle) / reach) / (1.0 - _PLATEAU), 0.0, 1.0)) ** 2
    frequencies = np.linspace(0.0, most, max(int(reach * 2.0 * most), 2))
    wave, row = np.exp(-2j * math.pi * frequencies[1] * middle), window.astype(complex)
    waves = np.empty((frequencies.size, middle.size), complex)
    for k in range(frequencies.size):
        waves[k], row = row, row * wave
    square = np.square(np.outer(math.pi * frequencies, gaps))
    waves *= 1.0 - square / 6.0 * (1.0 - square / 20.0)  # sinc, within 1e-5 for gaps of a quarter pixel
    found = waves @ np.diff(profile)
    # Propagate the noise: the final `derivative` is that of abs(response) / abs(response[0]) with respect to
    # each sample of the profile, times abs(response[0]).
    edges = np.zeros((frequencies.size, 1))
    differences = -np.diff(np.hstack([edges, waves, edges]), axis=1)
    derivative = np.real(differences * np.exp(-1j * np.angle(found))[:, None])
    values = np.abs(found) / abs(found[0])
    derivative -= np.outer(values, derivative[0])
    return values, np.sqrt(derivative**2 @ variances) / abs(found[0])


def _bin_profile(distance: Array, samples: Array) -> tuple[Array, Array, Array]:
    """Return mean positions, mean values and numbers of the samples in each nonempty bin of the profile."""
    bins = np.floor(_BINS_PER_PIXEL * (distance - distance.min())).astype(int)
    counts = np.bincount(bins).astype(float)
    nonempty = counts > 0
    position, values = (np.bincount(bins, part)[nonempty] / counts[nonempty] for part in (distance, samples))
    return position, values, counts[nonempty]


def _smooth_profile(distance: Array, light: Array, used: Mask, height: int) -> tuple[Array, Array]:
    """Return positions and values of medians of successive samples, about a quarter pixel wide."""
    order = np.argsort(distance[used], kind="stable")
    size = max(5, round(0.25 * height * float(used.mean()))) | 1
    parts = [values[used][order][: order.size // size * size].reshape(-1, size) for values in (distance, light)]
    nodes = parts[0].mean(axis=1)
    middle = np.median(parts[1], axis=1)  # which hot pixels do not move
    rising, first = np.unique(nodes, return_index=True)
    return rising, middle[first]


def _distances(line: Array, shape: tuple[int, ...]) -> tuple[Array, float]:
    """Return the distance of each pixel from the edge, and the least distance of its ends from the sides."""
    height, width = shape
    t = np.linspace(-1.0, 1.0, height)
    columns = legendre.legval(t, line)
    cosine = 1.0 / np.hypot(1.0, legendre.legval(t, legendre.legder(line)) * 2.0 / (height - 1))
    distance = (np.arange(width) - columns[:, None]) * cosine[:, None]
    return distance, float(max(min((columns * cosine).min(), ((width - 1 - columns) * cosine).min()), 1.0))


def _width(nodes: Array, values: Array, levels: tuple[float, float]) -> float:
    """Return the distance within which the light of a profile changes, pixels."""
    share = (values - levels[0]) / (levels[1] - levels[0] or 1.0)
    inside = nodes[(share > 0.05) & (share < 0.95)]
    return 2.0 + 1.5 * float(np.percentile(np.abs(inside), 90)) if inside.size else 4.0


def _sides(
    light: Array, distance: Array, reach: float, used: Mask
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the mean light on both sides of an edge, and the variances of planes through it."""
    planes = [_plane(light, distance, reach, used, side) for side in (-1.0, 1.0)]
    return (planes[0][0], planes[1][0]), (planes[0][1], planes[1][1])


def _plane(
    light: Array, distance: Array, reach: float, used: Mask, side: float
) -> tuple[float, float, Array, Array, Array]:
    """Return mean, variance, coefficients (light at the edge, slopes per pixel), errors^2 and the fit of one side."""
    chosen = used & (side * distance > _FAR * reach)
    rows = np.broadcast_to((np.arange(len(light)) - 0.5 * (len(light) - 1))[:, None], light.shape)
    values, design = light[chosen], np.stack([np.ones(int(chosen.sum())), distance[chosen], rows[chosen]])
    if values.size < 8:
        return math.nan, math.nan, np.full(3, math.nan), np.full(3, math.inf), values
    off = np.abs(values - np.median(values))
    kept = off <= 8.0 * max(1.4826 * float(np.median(off)), float(off.mean()))
    inverse = np.linalg.pinv(design[:, kept] @ design[:, kept].T)
    coefficients = inverse @ (design[:, kept] @ values[kept])
    residual = values[kept] - coefficients @ design[:, kept]
    variance = float(np.square(residual).sum()) / max(int(kept.sum()) - 3, 1)
    return float(values[kept].mean()), variance, coefficients, variance * np.diag(inverse), residual


def _evened(image: Array, distance: Array, reach: float, used: Mask) -> tuple[Array, float, float]:
    """Return the light divided by its linear trend, the trend over the picture, and the change of both sides.

    Where the illumination is 1 + g d, sides of the light a and b have the slopes a g and b g; the tails of a blur,
    and light that is added, change both sides by one slope.
    """
    (_, _, dark, dark_errors, _), (_, _, bright, bright_errors, _) = (
        _plane(image, distance, reach, used, side) for side in (-1.0, 1.0)
    )
    step = float(bright[0] - dark[0])
    if not abs(step) > 0.0 or not np.isfinite(step):
        return image, 0.0, 0.0
    height = len(image)
    across = float(bright[1] - dark[1]) / step
    across_error = math.sqrt(float(bright_errors[1] + dark_errors[1])) / abs(step)
    weights = np.array([dark[0], bright[0]]) / np.array([dark_errors[2], bright_errors[2]]).clip(1e-300)
    total = float(weights @ [dark[0], bright[0]])
    along, along_error = float(weights @ [dark[2], bright[2]]) / total, 1.0 / math.sqrt(max(total, 1e-300))
    rows = (np.arange(height) - 0.5 * (height - 1))[:, None]
    across *= float(abs(across) * 2.0 * reach > max(SIGMA * across_error * 2.0 * reach, MIN_TREND))
    along *= float(abs(along) * height > max(SIGMA * along_error * height, MIN_TREND))
    if across:
        common, common_error = float(dark[1] - dark[0] * across), across_error * abs(float(dark[0]))
    else:
        common = 0.5 * float(dark[1] + bright[1])
        common_error = 0.5 * math.sqrt(float(dark_errors[1] + bright_errors[1]))
    tail = common * 2.0 * reach / step
    tail *= float(abs(common) > SIGMA * common_error and abs(tail) > MIN_TREND)
    light = image / np.maximum(1.0 + across * distance + along * rows, 0.1)
    if tail < 0.0:  # no blur has such tails: light was added
        light = light - common * distance
    return light, max(abs(across) * 2.0 * reach, abs(along) * height), tail


def _filled(values: Array, known: Mask) -> Array:
    """Return values with the mean of known neighbours at unknown pixels."""
    filled, missing, side = np.where(known, values, 0.0), ~known, 3
    while missing.any():
        weights = uniform_filter(known.astype(float), side, mode="constant")
        means = uniform_filter(np.where(known, values, 0.0), side, mode="constant") / np.maximum(weights, 1e-12)
        found = missing & (weights > 1e-9)
        filled[found] = means[found]
        missing, side = missing & ~found, 2 * side + 1
    return filled


def _fit_edge(values: Array) -> tuple[float, float]:
    """Return the column of a nearly vertical edge in the first row, and its slope, columns per row."""
    height, width = values.shape
    differences = np.diff(values, axis=1)
    noise = 1.4826 * np.median(np.abs(differences)) / math.sqrt(2.0)
    differences = differences * np.sign(np.median(differences.sum(axis=1)))
    rows, positions = np.arange(height), np.arange(width - 1) + 0.5
    line, reach = np.array([0.0, 0.5 * (width - 1)]), float(width)
    # Noise in all columns pulls the centroids towards the middle column: the second and third fit use columns near
    # the edge only.
    for _ in range(3):
        is_near = np.abs(positions - np.polyval(line, rows)[:, None]) <= reach
        steps = np.where(is_near, differences, 0.0)
        step = steps.sum(axis=1)
        if not np.median(step) > _MIN_CONTRAST * noise:
            raise ValueError(
                "image must show an edge between two uniform areas, whose step exceeds the noise of its pixels"
            )
        is_clear = step > 0.5 * np.median(step)
        centroids = (steps * positions).sum(axis=1)[is_clear] / step[is_clear]
        line = np.polyfit(rows[is_clear], centroids, 1)
        for _ in range(2):  # without rows that have a hot pixel
            distance = np.abs(centroids - np.polyval(line, rows[is_clear]))
            is_kept = distance <= max(5.0 * float(np.median(distance)), 0.5)
            line = np.polyfit(rows[is_clear][is_kept], centroids[is_kept], 1)
        reach = max(8.0, 0.25 * width)
    return float(line[1]), float(line[0])
