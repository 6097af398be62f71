"""Sharpening and denoising of pictures of slanted edges, by the noise of neighbours and the overshoot of profiles.

The noise of light is white. Filters of the picture correlate it, and their gain, by which they also change the
response, is the root of its power spectrum. Evidence is summed over all edges of a picture: the correlations of N
pixels have a standard error of 1 / sqrt(N).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import scipy
from numpy.polynomial import legendre
from numpy.typing import NDArray
from scipy import ndimage

from lommel.base.arrays import Array
from lommel.base.encoding import Encoding, from_light, to_light
from lommel.base.threads import product
from lommel.fit.findings import Finding, untested_finding
from lommel.imaging.edge_checks import CURVE, UNTESTED
from lommel.imaging.edge_profile import FAR, SIGMA, Edge, Mask

_PADDING = 6  # zeros between rows and between images: the largest lag, of pixels two apart (of a mosaic)
_LAGS = np.array([(down, right) for down in range(4) for right in range(-3, 4) if down > 0 or right > 0])
_RADII = np.array([0.6, 1.0, 1.6, 2.5])  # of the correlations that are tested: exp(-lag^2 / (2 radius^2)), pixels
_DEGREE, _ACROSS, _ALONG_EDGE = 4, 12, 10  # of polynomials of the light of each side: of both directions, and of one
_FEW = 120  # pixels of a side from which noise is tested
_ROUNDING = 0.3  # smallest noise in units of integers that is tested
_CLIPPED = 4.0  # standard deviations
_CORRELATED, _SHARP = 3.5, -3.0  # standard errors from which noise is correlated; light leaves no negative ones
_COLORED = 6.0  # standard deviations of the sum of squares of correlations from which errors contain them
_OF_LIGHT = 0.01  # largest correlation that light may leave that is not quite the fitted one
_LEAST_POWER = 0.02  # of noise at a frequency, relative to its mean
_HINTS = 1.5, 2.0  # standard errors of noise and of overshoot that count together
_NARROW = 1.6  # largest radius of a filter whose effect noise limits; wider sharpening overshoots
_TREND = 0.05  # of the light, which steps may mimic
_BRIGHTER = 0.002  # fraction of pixels, of hot ones, that exceed a clipped value
_UNEVEN = 0.002  # least noise beside an edge that is told, fraction of the step
_BESIDE = 2.0  # ratio of the squares of noise beside an edge
_ALONG = 2.0  # power of that noise along edges of JPEG, of which neighbours have correlations of 0.3 to 0.5
_EFFECT = 0.02  # change of the response that is told
_BINS, _PER_PIXEL = 24, 2  # of the overshoot
_BOTH, _ONE = 0.006, 0.03  # overshoot that is told if it is on both sides, and on one, fractions of the step
_SIDE = 3.5  # standard errors of the overshoot of each side
_CURVES = np.linspace(-0.5, 1.0, 7)  # strengths of tone curves that are tested, as CURVE
_CURVED, _LEVELS = 6.0, 12  # least gain in chi-squared / 2 by a tone curve, and least number of sides of edges


@dataclass(frozen=True, eq=False)
class Evidence:
    """Evidence of an edge.

    `excess` and `weights` are the overshoot of the profile by side and distance, fractions of the step, and 1 /
    variance; `beside` are squares of noise beside the edge, and of the areas; `encoding` is the evidence of
    ``edge_findings``; `above` is the response above 1 beyond errors; `response` are its frequencies, cycles per
    pixel, values and errors. `untested` tells that rounding hides the noise,
    `uneven` that a large trend of the light was removed; `top` is the stored value that few pixels exceed; `noise` is
    that of both sides, as of ``_noise_of_light``.
    """

    neighbours: Neighbours
    excess: Array
    weights: Array
    beside: tuple[float, float]
    encoding: tuple[float, float, float]
    above: float
    response: tuple[Array, Array, Array]
    untested: bool
    uneven: bool
    top: float
    noise: Array


@dataclass(frozen=True, eq=False)
class Neighbours:
    """Sums of products of the noise of neighbours at lags, 0 for white noise, and their numbers, beside an edge."""

    products: Array
    pairs: Array
    normal: Array
    spacing: int

    @classmethod
    def of(cls, edge: Edge, stored: Array, pitch: float, shared: list[Areas], *, rounded: bool) -> Neighbours:
        """Return those of an edge, by the stored values; its areas are added to those that other colours share."""
        spacing = 2 if pitch == 2.0 else 1
        areas = next((one for one in shared if np.array_equal(one.used, edge.used)), None)
        if areas is None:
            shared.append(areas := Areas.of(edge, spacing))
        normal = np.array([-edge.slope, 1.0]) / math.hypot(1.0, edge.slope)
        return cls(*areas.products(stored, spacing, rounded=rounded), normal, spacing)

    def power(self, frequencies: Array) -> Array:
        """Return the power of noise at frequencies across the edge, cycles per pixel, relative to its mean.

        It is 1 unless noise is clearly correlated.
        """
        found = self.pairs > 0.0
        squares = float((np.square(self.products[found]) / self.pairs[found]).sum())
        if squares < found.sum() + _COLORED * math.sqrt(2.0 * found.sum()) or not found.any():
            return np.ones_like(frequencies)
        return self.spectrum(frequencies, np.where(found, self.products / np.maximum(self.pairs, 1.0), 0.0))

    def spectrum(self, frequencies: Array, correlations: Array) -> Array:
        """Return the power of noise of these correlations at lags, at frequencies across the edge."""
        phase = 2.0 * math.pi * self.spacing * frequencies[:, None] * (_LAGS @ self.normal)
        return np.maximum(1.0 + 2.0 * np.cos(phase) @ correlations, _LEAST_POWER)


def evidence_of(
    edge: Edge,
    neighbours: Neighbours,
    stored: Array,
    found: tuple[Array, Array],
    encoding: tuple[float, float, float],
    pitch: float,
    stated: Encoding,
    *,
    rounded: bool,
) -> Evidence:
    """Return the evidence of an edge, by the stored values and by its response and errors at the pixels' pitch."""
    values, errors = found
    above = float(np.max(values[1:] - 1.0 - SIGMA * errors[1:]))
    response = np.linspace(0.0, 0.5 / pitch, values.size), values, errors
    excess, weights = _excess(edge)
    untested = rounded and not neighbours.pairs.any()
    measured, white, degrees = edge.beside
    beside = measured, white + degrees * (_UNEVEN * edge.step) ** 2  # of light that changes along the edge
    top = float(np.quantile(stored[edge.used], 1.0 - _BRIGHTER))
    uneven = max(edge.trend, abs(edge.tail)) > _TREND
    noise = _noise_of_light(edge, stored, stated, rounded=rounded)
    return Evidence(neighbours, excess, weights, beside, encoding, above, response, untested, uneven, top, noise)


def added_variance(edge: Edge) -> float:
    """Return the variance of the noise beside an edge that exceeds that of its sides, as of denoised pictures."""
    measured, white, degrees = edge.beside
    expected = white + degrees * (_UNEVEN * edge.step) ** 2
    exceeds = measured > expected * (1.0 + SIGMA * math.sqrt(2.0 / max(degrees, 1.0)))
    return _ALONG * (measured - white) / degrees if exceeds else 0.0


def processing_findings(edges: Sequence[Evidence], *, compressed: bool) -> list[Finding]:
    """Return the findings on sharpening, denoising and compression by the evidence of all edges of a picture."""
    overshoot, both = _overshoot(edges)
    above = float(np.median([edge.above for edge in edges]))
    tested = _correlation(edges)
    significant = not _SHARP <= tested.strength <= _CORRELATED and tested.change > 1.0
    significant = significant and not 0.0 < tested.correlation < _OF_LIGHT
    together = tested.strength < -_HINTS[0] and both > _HINTS[1]
    numbers = {"overshoot": overshoot, "correlation": tested.correlation, "strength": tested.strength}
    size = f"{tested.correlation:.2g} ({abs(tested.strength):.0f} standard errors)"
    noise = f"noise of neighbours has the correlation {size}"
    negative = significant and tested.correlation < 0.0
    if overshoot > 0.0 and not negative and not together and 2 * sum(edge.uneven for edge in edges) > len(edges):
        text = (
            f"the light near the edge differs from its trend by {100 * overshoot:.1f} % of the step: it is not "
            "smooth, or the picture was sharpened"
        )
        return [Finding("uneven_light", "doubt", text, numbers)]
    if overshoot > 0.0 or above > _EFFECT or negative or together:
        signs = [f"the profile overshoots by {100 * overshoot:.1f} % of the step"] * (overshoot > 0.0)
        signs += [f"the response exceeds 1 by {above:.2g}"] * (above > _EFFECT)
        signs += [f"the profile overshoots on both sides ({both:.0f} standard errors)"] * (together and not overshoot)
        signs += [noise] * (significant or together)
        if compressed:
            text = f"by compression, or the picture was sharpened before: {', '.join(signs)}"
            return [Finding("correlated_noise", "doubt", text, numbers)]
        return [Finding("sharpened", "doubt", f"the picture was sharpened: {', '.join(signs)}", numbers)]
    if significant:
        text = f"{noise}: the picture was denoised, demosaiced, resized or compressed, which changes the response"
        return [Finding("correlated_noise", "doubt", text, numbers)]
    beside, expected = (sum(edge.beside[k] for edge in edges) for k in (0, 1))
    if beside > _BESIDE * expected:
        ratio = math.sqrt(beside / expected)
        text = f"noise beside the edge is {ratio:.2g} times that of the areas, which were denoised: errors contain it"
        return [Finding("correlated_noise", "doubt", text, {"ratio": ratio})]
    items = []
    if all(edge.untested for edge in edges):
        text = (
            "the noise is below the rounding of the values, as of pictures that were denoised, averaged or drawn: "
            "filters that change the response are not tested"
        )
        return [Finding("too_quiet", "doubt", text)]
    change = float(np.median([edge.encoding[1] for edge in edges]))
    if sum(edge.encoding[0] for edge in edges) < UNTESTED and change > _EFFECT and tested.pairs:
        items.append(f"encoding (MTF ±{change:.1g})")
    if (curve := float(np.median([edge.encoding[2] for edge in edges]))) > _EFFECT:
        misfits = 0.5 * _tone_misfits(edges)
        likely, none, usual = misfits.argmin(), *(np.abs(_CURVES - size).argmin() for size in (0.0, CURVE))
        moved = curve * abs(float(_CURVES[likely])) / CURVE
        if misfits[none] - misfits[likely] > _CURVED and moved > _EFFECT:
            text = (
                "noise of dark and bright areas is that of light behind a tone curve (contrast, a picture style), "
                f"which changes the response by about {moved:.1g}: take a raw picture, or "
                "state another encoding"
            )
            numbers = {"curve": moved, "gain": float(misfits[none] - misfits[likely])}
            return [Finding("tone_curve", "doubt", text, numbers)]
        if misfits[usual] - misfits[likely] < _CURVED:
            items.append(f"tone curve (MTF ±{curve:.1g})")
    if tested.hidden > _EFFECT:
        items.append(f"sharpening or denoising (MTF ±{tested.hidden:.1g})")
    sizes = {"encoding": change, "curve": curve, "filter": tested.hidden}
    return [untested_finding(items, sizes, "not excluded")] if items else []


def _noise_of_light(edge: Edge, stored: Array, encoding: Encoding, *, rounded: bool) -> Array:
    """Return light, variance, variance of rounding, and number of pixels, by tone curve and side of an edge.

    The shape is (4, curves, 2), or (4, curves, 0) if values are linear: a tone curve is one of encoded values.
    """
    if isinstance(encoding, str) and encoding == "linear":
        return np.zeros((4, _CURVES.size, 0))
    far = edge.used & (np.abs(edge.distance) > FAR * edge.reach)
    sides = [far & (sign * edge.distance > 0.0) for sign in (-1.0, 1.0)]
    codes = np.array([from_light(np.array(level), encoding, np.float64) for level in edge.levels]).clip(0.01, 0.99)
    scale = max(float(np.median(stored[side])) for side in sides) / float(codes.max())  # stored values at 1
    grid = np.linspace(0.0, 1.0, 1025)

    def slope(values: Array) -> Array:
        """Return the change of light with that of encoded values."""
        low, high = (to_light("values", values + change, encoding, np.float64) for change in (-1e-3, 1e-3))
        return np.asarray(500.0 * (high - low), float)

    variances = np.array(edge.variances) / np.square(slope(codes))
    found = np.zeros((4, _CURVES.size, 2))
    for k, size in enumerate(_CURVES):
        before = np.interp(codes, (1.0 - size) * grid + size * grid**2 * (3.0 - 2.0 * grid), grid)
        gain = np.square(slope(before) / (1.0 - size + 6.0 * size * before * (1.0 - before)))
        found[0, k] = to_light("values", before, encoding, np.float64)
        found[1:3, k] = variances * gain, (float(rounded) / 12.0 / scale**2) * gain
        found[3, k] = [int(side.sum()) for side in sides]
    return found


def _tone_misfits(edges: Sequence[Evidence]) -> Array:
    """Return chi-squared of the noise of all sides as that of light behind each tone curve; 0 if there are few sides.

    The variance of light is that of reading, a multiple of the light, and one of its square (uneven pixels).
    """
    light, variance, rounding, count = np.concatenate([edge.noise for edge in edges], axis=2)
    if light.shape[1] < _LEVELS:
        return np.zeros(_CURVES.size)
    misfits = np.zeros(_CURVES.size)
    for k in range(_CURVES.size):
        terms, expected = np.stack([np.ones_like(light[k]), light[k], light[k] ** 2], axis=1), variance[k]
        for _ in range(3):
            weights = np.sqrt(0.5 * count[k]) / np.maximum(expected, 1e-300)
            sizes = scipy.optimize.nnls(terms * weights[:, None], (variance[k] - rounding[k]) * weights)[0]
            expected = terms @ sizes + rounding[k]
        misfits[k] = float(np.square((variance[k] - expected) * weights).sum())
    # Noise that is no such light, as of gains over the field, scatters more.
    return np.asarray(misfits / max(1.0, float(misfits.min()) / (light.shape[1] - 4)))


class _Area(NamedTuple):
    """One side of an edge: its pixels in a box, an orthonormal basis of their light, polynomials, and sums at lags.

    The halo of the edge is no noise: it is in the polynomials. `pairs` are the numbers of pixels at each lag, and
    `fitted` the sums of the covariance that the fit takes from white noise: Q Q^T.
    """

    box: tuple[slice, slice]
    pixels: Mask
    basis: Array
    pairs: Array
    fitted: Array


@dataclass(frozen=True, eq=False)
class Areas:
    """The areas beside an edge in which noise is tested, by `used` pixels; colours of one edge share them."""

    used: Mask
    sides: list[_Area]

    @classmethod
    def of(cls, edge: Edge, spacing: int) -> Areas:
        """Return the areas beside an edge, of sides that are large enough."""
        far = min(edge.width, 0.7 * edge.reach)
        v = np.broadcast_to(np.linspace(-1.0, 1.0, len(edge.used))[:, None], edge.used.shape)
        sides = []
        for sign in (-1.0, 1.0):
            side = edge.used & (sign * edge.distance > far)
            if side.sum() < _FEW:
                continue
            box = ndimage.find_objects(side.astype(np.int8))[0]
            pixels = side[box]
            d = sign * edge.distance[side]
            u = 2.0 * (d - d.min()) / max(float(np.ptp(d)), 1e-12) - 1.0
            powers = legendre.legvander(u, _ACROSS).T, legendre.legvander(v[side], _ALONG_EDGE).T
            terms = [powers[0][i] * powers[1][j] for i in range(_DEGREE + 1) for j in range(_DEGREE + 1 - i)]
            # Halos of this edge, and of others at its ends.
            terms += [*powers[0][_DEGREE + 1 :], *powers[1][_DEGREE + 1 :]]
            design = np.stack(terms)
            normal = product(design, design.T)
            normal.flat[:: len(normal) + 1] *= 1.0 + 1e-12
            basis = product(np.linalg.inv(np.linalg.cholesky(normal)), design)
            pairs, fitted = (_at_lags(_spread(part, pixels), spacing) for part in (np.ones((1, len(d))), basis))
            sides.append(_Area(box, pixels, basis, pairs, fitted))
        return cls(edge.used, sides)

    def products(self, stored: Array, spacing: int, *, rounded: bool) -> tuple[Array, Array]:
        """Return sums of products of noise, 1 rms, at lags, 0 for white noise, and their numbers, 0 without noise."""
        sums = np.zeros((2, len(_LAGS)))
        for area in self.sides:
            values = stored[area.box][area.pixels]
            part = values - np.einsum("k,kn->n", np.einsum("kn,n->k", area.basis, values), area.basis)
            sigma = math.sqrt(float(part @ part) / (values.size - len(area.basis)))
            if sigma > (_ROUNDING if rounded else 1e-4 * abs(float(values.mean()))):
                noise = np.clip(part / sigma, -_CLIPPED, _CLIPPED)
                sums += _at_lags(_spread(noise[None], area.pixels), spacing) + area.fitted, area.pairs
        return sums[0], sums[1]


def _spread(values: Array, pixels: Mask) -> NDArray[np.float32]:
    """Return images of values at pixels, parted by zeros."""
    height, width = pixels.shape
    images = np.zeros((len(values), height + _PADDING, width + _PADDING), np.float32)
    images[:, :height, :width][:, pixels] = values
    return images


def _at_lags(images: NDArray[np.float32], spacing: int) -> Array:
    """Return the sums of products of pixels of images, parted by zeros, at each lag."""
    flat, width = images.ravel(), images.shape[-1]
    lags = [int(down * width + right) for down, right in spacing * _LAGS]
    return np.array([np.einsum("n,n->", flat[:-lag], flat[lag:]) for lag in lags], float)


class _Correlation(NamedTuple):
    """Correlation of neighbours, its standard errors, and the change of the response, in its errors, that follows.

    `hidden` is the change of the response by the strongest sharpening or denoising within two standard errors, and
    `pairs` the number of pairs of neighbours.
    """

    correlation: float
    strength: float
    change: float
    hidden: float
    pairs: float


def _correlation(edges: Sequence[Evidence]) -> _Correlation:
    """Return the correlation of the noise of neighbours by the evidence of all edges."""
    products, pairs = (sum(getattr(edge.neighbours, name) for edge in edges) for name in ("products", "pairs"))
    shapes = np.exp(-0.5 * np.square(_LAGS).sum(axis=1) / _RADII[:, None] ** 2)
    # Light that is not quite the fitted one adds as much at all lags, which negative sums of them exclude.
    contrasts = shapes - shapes @ pairs[:, None] / max(float(pairs.sum()), 1.0)
    every = np.concatenate([contrasts, shapes])
    variances = np.square(every) @ pairs
    if not variances.all():
        return _Correlation(0.0, 0.0, 0.0, 0.0, 0.0)
    sizes, errors = every @ products / variances, 1.0 / np.sqrt(variances)
    strengths = sizes / errors
    strengths[len(shapes) :] = np.minimum(strengths[len(shapes) :], 0.0)
    best = int(np.abs(strengths).argmax())
    shape = shapes[best % len(shapes)]

    def change(edge: Evidence, size: float, shape: Array) -> Array:
        """Return the change of the response by the filter that made noise of this correlation."""
        f, values, _ = edge.response
        power = edge.neighbours.spectrum(f, size * shape)
        return np.asarray(values * (1.0 - np.sqrt(power[0] / power)))

    relative = [
        float(np.max(np.abs(change(edge, sizes[best], shape)[1:]) / np.maximum(edge.response[2][1:], 1e-12)))
        for edge in edges
    ]
    hidden = [
        float(np.median([np.abs(change(edge, size + sign * error, narrow)).max() for edge in edges]))
        for radius, size, error, narrow in zip(_RADII, sizes, errors, shapes, strict=False)
        for sign in (-2.0, 2.0)
        if radius <= _NARROW
    ]
    strength = float(sizes[best] / errors[best])
    correlation = min(max(float(sizes[best] * np.exp(-0.5 / _RADII[best % len(shapes)] ** 2)), -1.0), 1.0)
    return _Correlation(correlation, strength, float(np.median(relative)), max(hidden), float(pairs.sum()))


def _excess(edge: Edge) -> tuple[Array, Array]:
    """Return by how much a profile exceeds its sides, by side and half pixels of distance, and 1 / variances."""
    position, profile, counts, variances = edge.profile
    share = (profile - edge.levels[0]) / (edge.levels[1] - edge.levels[0])
    excess, weights = np.zeros((2, _BINS)), np.zeros((2, _BINS))
    reach = min(edge.width + 6.0, 0.9 * edge.reach)
    for k, sign in enumerate((-1.0, 1.0)):
        near = (sign * position > 0.0) & (sign * position < min(reach, _BINS / _PER_PIXEL))
        bins = (_PER_PIXEL * sign * position[near]).astype(int)
        total = np.bincount(bins, counts[near], _BINS)
        over = share[near] - 1.0 if k else -share[near]
        excess[k] = np.bincount(bins, counts[near] * over, _BINS) / np.maximum(total, 1.0)
        variance = np.bincount(bins, np.square(counts[near]) * variances[near], _BINS) / np.maximum(total, 1.0) ** 2
        weights[k] = np.where(total > 0.0, edge.step**2 / np.maximum(variance, 1e-12 * edge.step**2), 0.0)
    return excess, weights


def _overshoot(edges: Sequence[Evidence]) -> tuple[float, float]:
    """Return the mean overshoot of profiles, fraction of the step, 0 within noise, and that of both sides in errors.

    Light that is not even has an overshoot on one side.
    """
    weights = sum(edge.weights for edge in edges)
    excess = sum(edge.weights * edge.excess for edge in edges) / np.maximum(weights, 1e-12)
    strengths = excess * np.sqrt(weights)
    sizes = np.where(strengths > _SIDE, excess, 0.0).max(axis=1)
    both = float(strengths.min(axis=0).max())
    if sizes.min() > _BOTH or sizes.max() > _ONE:
        return float(sizes.max()), both
    return 0.0, both
