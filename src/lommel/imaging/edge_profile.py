"""Location of a slanted edge in a picture, correction of uneven light, and the response of its profile.

The light as a function of the signed distance from the edge is called the profile (edge spread function); its
derivative is the line spread function, whose Fourier transform is the response.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray
from scipy.ndimage import uniform_filter
from scipy.special import sici

from lommel.base.arrays import Array
from lommel.base.cached import cached_property
from lommel.base.threads import product

Mask = NDArray[np.bool_]

_BINS_PER_PIXEL = 16  # number of bins per pixel; a bin holds the mean position and the mean value of its samples
_MAX_GAP = 0.25  # largest distance between samples of the profile, pixels: the width of the bins of ISO 12233
_MARGIN = 5.0  # smallest distance of the edge from the sides of the picture, pixels
MIN_ANGLE, MAX_ANGLE = 2.0, 45.0
"""Angle between the edge and the rows or columns, degrees."""
_MIN_CONTRAST = 5.0  # smallest step at the edge divided by the standard deviation of the noise of a pixel
_PLATEAU = 0.5  # fraction of the profile over which its window function is 1; it falls to 0 like cos^2 at both ends
_FEW = 24  # least number of pixels of a side
_FAR_OFF = 8.0  # mean absolute deviations of pixels of a side that are left out of its plane
_TAIL = 0.35  # fraction of the profile beyond which its approach to the sides is fitted
_OUTER, _STEEP = 0.6, 2.0  # the same, of those that fall faster by these standard errors
_UNSURE = 0.5  # relative error of the fitted light: other blurs, and halos of other edges, at two reaches
FAR = 0.6
"""Fraction of the profile beyond which pixels show the uniform sides."""
_STEPS, _TERMS = 3, 4  # of the fit of the edge, and number of its Legendre polynomials
# Where the response is 0.5: size of the part fitted around it, relative to its frequency; number of fits, each around
# the last one; least fall of its logarithm there with that of frequency (1.4 of Gaussians, 1.3 of apertures); least
# value in logarithms.
_NEAR, _LEAST_NEAR, _REFITS, _LEAST_FALL, _FAINT = 0.3, 2.5, 3, 0.6, 0.05
# Fraction of what a response lacks at 1 / reach, step _PERIOD of its frequencies, that a trend hides: its slope at 60
# to 100 % of the reach, and the light beyond.
_HALO, _PERIOD = 0.36, 4
SIGMA = 4.5
"""Standard errors from which a curvature, a trend of the light and other faults count."""
_SETTLED = 0.01  # change in a step at which the fit of the edge ends, pixels
_MIN_CURVATURE = 0.01  # smallest that is corrected, pixels
_REST = 3.0  # standard errors of the slope of both sides beside that of a trend
_FALL = 2.0  # the same where both sides would fall, as by no blur: the black level was not subtracted
_INSIDE = 0.75  # mean of the window function
_ALIKE = 4.0  # largest ratio of the quadratic fall-off of light across and along an edge
MIN_TREND = 0.02
"""Smallest trend of the light over the picture, as a fraction, that is corrected: it changes responses by 0.007."""
_GENTLE = 0.2  # slope beside an edge, of its largest, at which noise is measured
_OUTLIER, _SLOPE, _LEAST = 6.0, 0.3, 0.02  # of outliers: standard deviations, pixels, fraction of the step


@dataclass(frozen=True, eq=False)
class Edge:
    """A nearly vertical edge in a picture; distances are in pixels.

    `light` is corrected for uneven light, `used` are the pixels that are known and no outliers, `distance` is signed,
    from the edge to each pixel, and `reach` the distance to which the profile extends. `levels` and `variances` are
    the light on the sides of negative and of positive distance, and the variance of its noise. `line` has the
    coefficients of the Legendre polynomials of the column of the edge, from the first to the last row.
    `trend` is the fitted change of the light across the picture, `tail` the change of both sides towards the edge,
    both as fractions; `unsure` is the relative error of the response by that of a trend that was removed.
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
    unsure: float
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

    @cached_property
    def profile(self) -> tuple[Array, Array, Array, Array]:
        """Positions, values, numbers of samples and variances of the profile."""
        inside = self.used & (np.abs(self.distance) <= self.reach)
        position, profile, counts = _bin_profile(self.distance[inside], self.light[inside])
        dark, bright = self.variances
        share = np.clip((profile - self.levels[0]) / (self.levels[1] - self.levels[0]), 0.0, 1.0)
        return position, profile, counts, (dark + (bright - dark) * share) / counts

    @cached_property
    def beside(self) -> tuple[float, float, float]:
        """Sums of squares of noise beside the edge, where light changes little, and by the sides; degrees of freedom.

        Degrees of freedom are pixels less bins of the profile.
        """
        position, profile, counts, variances = self.profile
        inside = self.used & (np.abs(self.distance) <= self.reach)
        d, light = self.distance[inside], self.light[inside]
        slopes = np.gradient(profile, position)
        bins = np.floor(4.0 * (position - position[0])).astype(int)
        total = np.bincount(bins, counts)
        slope = (np.bincount(bins, counts * slopes) / np.maximum(total, 1.0))[bins]
        near = (np.abs(position) < self.width + 2.0) & (np.abs(slope) < _GENTLE * np.abs(slope).max()) & (counts > 1)
        index = np.searchsorted(0.5 * (position[1:] + position[:-1]), d)
        off = np.square(light - profile[index] - slope[index] * (d - position[index]))
        degrees = counts[near] - 1.0
        white = degrees @ (counts[near] * variances[near])
        return float(off[near[index]].sum()), float(white), float(degrees.sum())


def locate(image: Array, known: Mask, line: Array | None = None) -> Edge:
    """Return the nearly vertical edge in a picture, near `line` if given; ValueError if there is none."""
    height = len(image)
    is_new = line is None
    line = _fit_edge(_filled(image, known)) if line is None else line.copy()
    terms, _ = _polynomials(height)
    first = 0 if is_new else _STEPS  # a stated line is near the edge
    used, count = known, 2 if is_new else _TERMS
    distance, reach = _distances(line, image.shape)
    light, trend, tail, unsure, levels, variances = _evened(image, distance, reach, used)
    for step in range(first, 4 * _STEPS):
        line[count:] = 0.0
        distance, reach = _distances(line, image.shape)
        if is_new and step == _STEPS:
            light, trend, tail, unsure, levels, variances = _evened(image, distance, reach, used)
        nodes, values = _smooth_profile(distance, light, used, height)
        expected = np.interp(distance, nodes, values)
        gradient = np.interp(distance, 0.5 * (nodes[1:] + nodes[:-1]), np.diff(values) / np.diff(nodes))
        size = abs(levels[1] - levels[0])
        share = np.clip((expected - levels[0]) / (levels[1] - levels[0] or 1.0), 0.0, 1.0)
        sigma = np.sqrt(variances[0] + (variances[1] - variances[0]) * share)
        residual = light - expected
        used = known & (np.abs(residual) <= _OUTLIER * sigma + _SLOPE * np.abs(gradient) + _LEAST * size)
        width = _width(nodes, values, levels)
        near = used & (np.abs(distance) <= min(width, reach))
        if near.sum() < _FEW or not gradient[near].any():
            raise ValueError("image must show both sides of an edge, got too few known pixels")
        weight = np.where(near, gradient, 0.0)
        basis = terms[:, :count]
        # Columns move by residual / -gradient; `weight` is the gradient per pixel of distance, which is close.
        inverse = _inverse((basis * np.square(weight).sum(axis=1)[:, None]).T @ basis)
        change = inverse @ (basis.T @ (weight * residual).sum(axis=1))
        line[:count] -= change
        if step == _STEPS - 1:  # the straight edge has settled
            count = _TERMS
        elif step == _STEPS:
            errors = np.sqrt(np.diag(inverse) * float(np.mean(np.square(sigma[near]))))[2:]
            bent = (np.abs(line[2:]) > SIGMA * errors) & (np.abs(line[2:]) > _MIN_CURVATURE)
            count = _TERMS if bent.any() else 2
        elif step > _STEPS and np.abs(change).max() < _SETTLED:
            break
    distance, reach = _distances(line, image.shape)
    outliers = int((known & ~used).sum())
    return Edge(light, used, distance, reach, levels, variances, line, outliers, trend, tail, unsure, width)


def require_measurable(edge: Edge, pitch: float) -> None:
    """Raise ValueError if an edge is too near to a side, at another angle, or leaves gaps in its profile."""
    degrees = math.degrees(math.atan(abs(edge.slope)))  # above 45 if columns and rows are near alike
    if degrees < MIN_ANGLE:
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
    gap = float(np.diff(edge.profile[0]).max(initial=0.0))
    if gap > _MAX_GAP * pitch:
        raise ValueError(
            f"image must have an edge whose slope is not a simple fraction such as 1/3, got a slope of "
            f"{edge.slope:.4g} with gaps of {gap:.2g} pixels in the profile; turn the edge by a degree"
        )


@dataclass(frozen=True, eq=False)
class Transform:
    """Transform from profiles at positions to responses at frequencies from 0 to `most` cycles per pixel."""

    position: Array
    most: float = 0.5

    @cached_property
    def reach(self) -> float:
        """Largest distance from the edge."""
        return float(np.abs(self.position).max())

    @cached_property
    def frequencies(self) -> Array:
        """Frequencies of responses."""
        return np.linspace(0.0, self.most, max(int(self.reach * 4.0 * self.most), 2))

    @cached_property
    def _waves(self) -> tuple[Array, Array]:
        """Cosines and sines of the middles of differences, by frequency, times the window function."""
        gaps, middle = np.diff(self.position), 0.5 * (self.position[1:] + self.position[:-1])
        wave, row = np.exp(-2j * math.pi * self.frequencies[1] * middle), _window(middle / self.reach).astype(complex)
        shape = self.frequencies.size, middle.size
        cosines, sines = np.empty(shape), np.empty(shape)
        for k in range(len(cosines)):
            cosines[k], sines[k], row = row.real, row.imag, row * wave
        square = np.square(np.outer(math.pi * self.frequencies, gaps))
        square *= (1.0 + square * 7.0 / 60.0) / 6.0  # 1 / sinc - 1, of differences, within 1e-5
        cosines += cosines * square
        sines += sines * square
        return cosines, sines

    def response(
        self,
        profile: Array,
        variances: Array,
        tail: float = 0.0,
        unsure: float = 0.0,
        power: Callable[[Array], Array] = np.ones_like,
        added: Array | float = 0.0,
    ) -> tuple[Array, Array]:
        """Return the response of a profile and its covariance.

        The `power` of the noise at frequencies across the edge is relative to its mean; white noise of the variances
        `added` adds to it.

        The effect of the light beyond the profile is estimated and subtracted; errors contain the noise and half of
        it. With a `tail`, which may be uneven light as well, it is not subtracted, and errors contain all of it.
        """
        power_of = power(self.frequencies)
        values, derivative = self._values(profile, variances, power_of, added)
        parts = [derivative * np.sqrt(power_of)[:, None] * np.sqrt(variances)]
        if np.any(added):
            parts.append(derivative * np.sqrt(added))
        noise = np.hstack(parts)
        covariance = product(noise, noise.T)
        beyond, error = self._beyond(profile, variances + added, values)
        covariance += np.outer(error, error)
        of_trend = values * math.hypot(unsure, halo_share(values) if tail < 0.0 else 0.0) * (self.frequencies > 0.0)
        covariance += np.outer(of_trend, of_trend)
        if tail:
            return values, covariance + np.outer(beyond, beyond)
        return values - beyond, covariance

    def values(self, profile: Array, variances: Array, tail: float = 0.0) -> Array:
        """Return the response of a profile with white noise."""
        values, _ = self._values(profile, variances, np.ones_like(self.frequencies), 0.0)
        return values if tail else values - self._beyond(profile, variances, values)[0]

    def _values(self, profile: Array, variances: Array, power: Array, added: Array | float) -> tuple[Array, Array]:
        """Return the response without that of the light beyond, and its derivatives by the samples of the profile."""
        cosines, sines = self._waves
        real, imaginary = (np.einsum("kn,n->k", part, np.diff(profile)) for part in (cosines, sines))
        size = np.hypot(real, imaginary)
        # The final `derivative` is that of abs(response) / abs(response[0]).
        along = np.zeros((size.size, self.position.size + 1))
        along[:, 1:-1] = cosines * (real / size)[:, None]
        along[:, 1:-1] += sines * (imaginary / size)[:, None]
        derivative = along[:, :-1] - along[:, 1:]
        values: Array = size / size[0]
        derivative -= np.outer(values, derivative[0])
        derivative /= size[0]
        squares = np.square(derivative)
        of_noise = power * np.einsum("kn,n->k", squares, variances)  # by which squares of responses are larger
        if np.any(added):
            of_noise += np.einsum("kn,n->k", squares, np.broadcast_to(added, variances.shape))
        return np.sqrt(np.maximum(np.square(values) - of_noise, 0.0)), derivative

    @cached_property
    def _lost(self) -> Array:
        """What the window function hides of 1 / distance^2 on both sides, at each frequency, times the reach / 2."""
        x = np.linspace(_PLATEAU, 1.0, 65)
        ends = np.where((x == _PLATEAU) | (x == 1.0), 0.5, 1.0)
        weight = (1.0 - _window(x)) / np.square(x) * ends * (x[1] - x[0])
        phase = 2.0 * math.pi * self.reach * self.frequencies
        return np.asarray(
            np.cos(np.outer(phase, x)) @ weight + np.cos(phase) - phase * (0.5 * math.pi - sici(phase)[0])
        )

    def _beyond(self, profile: Array, variances: Array, values: Array) -> tuple[Array, Array]:
        """Return the change of the response by light that the window function hides, and its error.

        Line spread functions of apertures fall like a / distance^2, and the profile approaches its sides like a /
        distance; a is fitted to its outer parts.
        """
        position, reach = self.position, self.reach
        step = float(np.median(profile[position > _TAIL * reach]) - np.median(profile[position < -_TAIL * reach]))
        fits = []
        for start in (_TAIL, _OUTER):
            total, square = 0.0, 0.0
            for sign in (-1.0, 1.0):
                outer = sign * position > start * reach
                if outer.sum() < _FEW:
                    return np.zeros_like(values), np.zeros_like(values)
                weights = 1.0 / np.maximum(variances[outer], 1e-12 * float(np.ptp(profile)) ** 2)
                inverse = 1.0 / position[outer]
                inverse -= weights @ inverse / weights.sum()
                weight = float(weights @ np.square(inverse))
                # Opposite on both sides, times the step.
                total += float(weights @ (inverse * profile[outer])) / weight
                square += 1.0 / weight
            fits.append((-0.5 * total / step, 0.5 * math.sqrt(square) / abs(step)))
        (size, error), (outer_size, outer_error) = fits
        unsure = _UNSURE
        if size - outer_size > _STEEP * outer_error:  # the profile falls faster
            size, error, unsure = outer_size, outer_error, 1.0
        if size <= 0.0:
            return np.zeros_like(values), np.zeros_like(values)
        size *= (likely := size**2 / (size**2 + error**2))
        change = 2.0 / reach * (values * self._lost[0] - self._lost)
        return size * change, np.abs(change) * math.hypot(likely * error, unsure * size)


def halo_share(values: Array) -> float:
    """Return the largest fraction by which a halo that a linear trend of both sides hides makes a response too large.

    A halo that falls like 1 / distance^2 gives a response its slope at frequency 0, which that at 1 / reach bounds.
    """
    return _HALO * (1.0 - float(values[min(_PERIOD, values.size - 1)]))


def half(values: Array, covariance: Array) -> tuple[float, float]:
    """Return where a response falls to 0.5, in steps of its frequencies, and its standard error; else infinity.

    Noise makes the first crossing early and steep; that of a parabola through the logarithm of values around it is
    neither, and the error is that of the parabola.
    """
    below = np.flatnonzero(values < 0.5)
    if not below.size:
        return math.inf, math.inf
    k = int(below[0])
    at = k - (0.5 - values[k]) / (values[k - 1] - values[k])
    steps, error = np.arange(values.size), math.inf
    for _ in range(_REFITS):
        near = np.abs(steps - at) <= max(_NEAR * at, _LEAST_NEAR)
        if near.sum() < 4:
            return math.inf, math.inf
        x, weights = steps[near] / at - 1.0, np.maximum(values[near], _FAINT)
        inverse = np.linalg.pinv(np.vander(x, 3) * weights[:, None]) * weights
        bend, slope, value = inverse @ np.log(weights)
        value += math.log(2.0)
        square = slope * slope - 4.0 * bend * value
        fall = math.sqrt(max(square, 0.0))
        if slope >= 0.0 or square <= 0.0:
            break
        gradient = inverse[2] / weights
        error = math.sqrt(float(gradient @ covariance[np.ix_(near, near)] @ gradient)) / max(fall, _LEAST_FALL) * at
        at *= 1.0 - 2.0 * value / (slope - fall)
    return (float(at), error) if 1.0 < at < values.size - 1 else (math.inf, math.inf)


def _window(share: Array) -> Array:
    """Return the window function at fractions of the reach of a profile."""
    return np.asarray(np.sin(0.5 * math.pi * np.clip((1.0 - np.abs(share)) / (1.0 - _PLATEAU), 0.0, 1.0)) ** 2)


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
    middle = np.partition(parts[1], size // 2, axis=1)[:, size // 2]  # the median, which hot pixels do not move
    rising, first = np.unique(nodes, return_index=True)
    return rising, middle[first]


@lru_cache(maxsize=64)
def _polynomials(height: int) -> tuple[Array, Array]:
    """Return Legendre polynomials of the rows, from -1 to 1, and their slopes per row."""
    t = np.linspace(-1.0, 1.0, height)
    slopes = [legendre.legval(t, legendre.legder(one)) * 2.0 / (height - 1) for one in np.eye(_TERMS)]
    return np.asarray(legendre.legvander(t, _TERMS - 1), np.float64), np.stack(slopes, axis=1)


def _distances(line: Array, shape: tuple[int, ...]) -> tuple[Array, float]:
    """Return the distance of each pixel from the edge, and the least distance of its ends from the sides."""
    height, width = shape
    terms, slopes = _polynomials(height)
    columns, cosine = terms @ line, 1.0 / np.hypot(1.0, slopes @ line)
    distance = (np.arange(width) - columns[:, None]) * cosine[:, None]
    return distance, float(max(min((columns * cosine).min(), ((width - 1 - columns) * cosine).min()), 1.0))


def _inverse(normal: Array) -> Array:
    """Return the inverse of a normal matrix."""
    normal = normal.copy()
    normal.flat[:: len(normal) + 1] *= 1.0 + 1e-12
    return np.asarray(np.linalg.inv(normal))


def _width(nodes: Array, values: Array, levels: tuple[float, float]) -> float:
    """Return the distance within which the light of a profile changes, pixels."""
    share = (values - levels[0]) / (levels[1] - levels[0] or 1.0)
    inside = np.sort(np.abs(nodes[(share > 0.05) & (share < 0.95)]))
    return 2.0 + 1.5 * float(inside[int(0.9 * inside.size)]) if inside.size else 4.0


def _sides(
    light: Array, distance: Array, reach: float, used: Mask
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the mean light on both sides of an edge, and the variances of its noise."""
    planes = [_side(light, distance, reach, used, side) for side in (-1.0, 1.0)]
    return (planes[0].mean, planes[1].mean), (planes[0].variance, planes[1].variance)


class _Side(NamedTuple):
    """Light of one side of an edge, and its fit.

    `terms` and `errors` (squares) are those of the light at the edge, the slopes across and along it, per pixel, and
    the Legendre polynomial of degree 2 along it. `place` is the mean distance of the pixels.
    """

    mean: float
    variance: float
    terms: Array
    errors: Array
    place: float


def _side(light: Array, distance: Array, reach: float, used: Mask, side: float) -> _Side:
    """Return the light of one side (sign of the distance) of an edge, far from it."""
    chosen = used & (side * distance > FAR * reach)
    rows = np.arange(len(light)) - 0.5 * (len(light) - 1)
    bend = _bend(len(light))
    values, far, index = light[chosen], distance[chosen], np.nonzero(chosen)[0]
    if values.size < _FEW:
        raise ValueError(f"image must show both sides of an edge, got {values.size} known pixels on one")
    off = np.abs(values - np.partition(values, values.size // 2)[values.size // 2])
    kept = off <= _FAR_OFF * max(float(off.mean()), 1e-12)
    values, far, index = values[kept], far[kept], index[kept]
    design = np.stack([np.ones(values.size), far, rows[index], bend[index]])
    inverse = _inverse(design @ design.T)
    terms = inverse @ (design @ values)
    residual = values - terms @ design
    variance = float(residual @ residual) / max(values.size - len(terms), 1)
    return _Side(float(values.mean()), variance, terms, variance * np.diag(inverse), abs(float(far.mean())))


def _bend(height: int) -> Array:
    """Return the Legendre polynomial of degree 2 of the rows."""
    return np.asarray(1.5 * np.square(np.linspace(-1.0, 1.0, height)) - 0.5)


def _evened(
    image: Array, distance: Array, reach: float, used: Mask
) -> tuple[Array, float, float, float, tuple[float, float], tuple[float, float]]:
    """Return the light divided by its trend, the trend over the picture, the change, its effect, levels and noise.

    Where the illumination is 1 + g d, sides of the light a and b have the slopes a g and b g; the tails of a blur,
    and light that is added, change both sides by one slope. A quadratic fall-off across the edge, 1 + q d^2, changes
    them alike: it is taken for one if the light falls off alike along the edge.
    """
    sides = [_side(image, distance, reach, used, side) for side in (-1.0, 1.0)]
    dark, bright = (side.terms for side in sides)
    dark_errors, bright_errors = (side.errors for side in sides)
    levels = (sides[0].mean, sides[1].mean), (sides[0].variance, sides[1].variance)
    step = float(bright[0] - dark[0])
    if not abs(step) > 0.0:
        return image, 0.0, 0.0, 0.0, *levels
    height = len(image)
    across = float(bright[1] - dark[1]) / step
    across_error = math.sqrt(float(dark_errors[1] + bright_errors[1])) / abs(step)

    def along_edge(term: int) -> tuple[float, float]:
        """Return a term along the edge that both sides have, relative to their light, and its error."""
        weights = np.array([dark[0], bright[0]]) / np.array([dark_errors[term], bright_errors[term]]).clip(1e-300)
        total = float(weights @ [dark[0], bright[0]])
        return float(weights @ [dark[term], bright[term]]) / total, 1.0 / math.sqrt(max(total, 1e-300))

    along, along_error = along_edge(2)
    bend, bend_error = along_edge(3)
    # The slope that a trend of any size, on the brighter side most, does not explain.
    rest = float(dark[1] - dark[0] * across)
    rest_error = math.hypot(across_error * float(dark[0]), math.sqrt(float(dark_errors[1])))
    across *= float(abs(across) * 2.0 * reach > max(SIGMA * across_error * 2.0 * reach, MIN_TREND))
    along *= float(abs(along) * height > max(SIGMA * along_error * height, MIN_TREND))
    bend *= float(abs(bend) > SIGMA * bend_error)
    if across:
        common, common_error = float(dark[1] - dark[0] * across), across_error * abs(float(dark[0]))
    else:
        common = 0.5 * float(dark[1] + bright[1])
        common_error = 0.5 * math.sqrt(float(dark_errors[1] + bright_errors[1]))
    tail = common * 2.0 * reach / step
    is_common = abs(common) > SIGMA * common_error and abs(rest) > _REST * rest_error
    is_common |= bool(across) and tail < -_FALL * abs(rest_error * 2.0 * reach / step)
    tail *= float(is_common)
    square, along_square = 0.0, 1.5 * bend / (0.5 * height) ** 2
    if tail and along_square and min(dark[0], bright[0]) > 0.0:
        slopes = float(dark[1] / dark[0]), float(bright[1] / bright[0])
        square = (slopes[1] - slopes[0]) / (2.0 * (sides[0].place + sides[1].place))
        if 1.0 / _ALIKE < square / along_square < _ALIKE:
            across, tail = 0.5 * (slopes[0] + slopes[1]), 0.0
        else:
            square = 0.0
    tail *= float(abs(tail) > MIN_TREND)
    if not (across or along or bend or square or tail < 0.0):
        return image, 0.0, tail, 0.0, *levels
    rows = (np.arange(height) - 0.5 * (height - 1))[:, None]
    light = image / np.maximum(
        1.0 + across * distance + along * rows + bend * _bend(height)[:, None] + square * np.square(distance), 0.1
    )
    if tail < 0.0:  # no blur has such tails: light was added
        light = light - common * distance
    trend = max(abs(across) * 2.0 * reach, abs(along) * height, 1.5 * abs(bend), abs(square) * reach**2)
    # What remains of a slope changes the response by the light that it adds within the window function.
    slope_error = common_error if tail else across_error * 0.5 * float(dark[0] + bright[0])
    unsure = _INSIDE * 2.0 * reach * slope_error / abs(step) if across or tail else 0.0
    return light, trend, tail, unsure, *_sides(light, distance, reach, used)


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


def _fit_edge(values: Array) -> Array:
    """Return the line of a nearly vertical edge by the centroids of differences in rows; ValueError without edge."""
    height, width = values.shape
    differences = np.diff(values, axis=1)
    noise = 1.4826 * np.median(np.abs(differences)) / math.sqrt(2.0)
    differences = differences * np.sign(np.median(differences.sum(axis=1)))
    t, positions = np.linspace(-1.0, 1.0, height), np.arange(width - 1) + 0.5
    start, rise, reach = 0.5 * (width - 1), 0.0, float(width)
    # Noise in all columns pulls the centroids towards the middle column: the second and third fit use columns near
    # the edge only.
    for _ in range(3):
        is_near = np.abs(positions - (start + rise * t)[:, None]) <= reach
        steps = np.where(is_near, differences, 0.0)
        step = steps.sum(axis=1)
        middle = float(np.median(step))
        if not middle > _MIN_CONTRAST * noise:
            raise ValueError(
                "image must show one edge between two uniform areas, whose step exceeds the noise of its pixels, "
                "from end to end; lm.imaging.sfr_chart finds edges beside corners and other edges"
            )
        kept = step > 0.5 * middle
        centroids = (steps @ positions) / np.where(kept, step, 1.0)
        for _ in range(3):  # without rows that have a hot pixel
            mean = float(t[kept].mean()), float(centroids[kept].mean())
            rise = float((t[kept] - mean[0]) @ (centroids[kept] - mean[1])) / float(
                np.square(t[kept] - mean[0]).sum()
            )
            start = mean[1] - rise * mean[0]
            off = np.abs(centroids - (start + rise * t))
            kept = kept & (off <= max(5.0 * float(np.median(off[kept])), 0.5))
        reach = max(8.0, 0.25 * width)
    return np.array([start, rise, *[0.0] * (_TERMS - 2)])
