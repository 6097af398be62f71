"""Sharpening and denoising of pictures of slanted edges, by the noise of neighbours and the overshoot of profiles.

The noise of light is white. Filters of the picture correlate it, and their gain, by which they also change the
response, is the root of its power spectrum. Evidence is summed over all edges of a picture: the correlations of N
pixels have a standard error of 1 / sqrt(N).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre

from lommel.base.arrays import Array
from lommel.fit.findings import Finding
from lommel.imaging.edge_profile import SIGMA, Edge, Mask

_LARGEST_LAG = 3
_LAGS = np.array([(down, right) for down in range(4) for right in range(-3, 4) if down > 0 or right > 0])
_RADII = np.array([0.6, 1.0, 1.6, 2.5])  # of the correlations that are tested: exp(-lag^2 / (2 radius^2)), pixels
_DEGREE = 6  # of the polynomials of the light of each side
_FEW = 120  # pixels of a side from which noise is tested
_ROUNDING = 0.3  # smallest noise in units of integers that is tested
_CLIPPED = 4.0  # standard deviations
_CORRELATED = 4.0  # standard errors from which noise is correlated
_LEAST_POWER = 0.02  # of noise at a frequency, relative to its mean
_EFFECT = 0.02  # response above 1 that is told
_BINS, _PER_PIXEL = 24, 2  # of the overshoot
_BOTH, _ONE = 0.006, 0.03  # overshoot that is told if it is on both sides, and on one, fractions of the step
_SIDE = 3.5  # standard errors of the overshoot of each side


@dataclass(frozen=True, eq=False)
class Evidence:
    """Evidence of an edge: sums of products of noise at lags, 0 for white noise, and their numbers.

    `excess` and `weights` are the overshoot of the profile by side and distance, fractions of the step, and 1 /
    variance; `above` is the response above 1 beyond errors; `response` are its frequencies, cycles per pixel, values
    and errors along the `normal` (down, right). `untested` tells that rounding hides the noise.
    """

    products: Array
    pairs: Array
    excess: Array
    weights: Array
    above: float
    response: tuple[Array, Array, Array]
    normal: Array
    spacing: int
    untested: bool


def evidence_of(edge: Edge, stored: Array, found: tuple[Array, Array], pitch: float, *, rounded: bool) -> Evidence:
    """Return the evidence of an edge, by the stored values and by its response and errors at the pixels' pitch."""
    values, errors = found
    above = float(np.max(values[1:] - 1.0 - SIGMA * errors[1:]))
    response = np.linspace(0.0, 0.5 / pitch, values.size), values, errors
    normal = np.array([-edge.slope, 1.0]) / math.hypot(1.0, edge.slope)
    spacing = 2 if pitch == 2.0 else 1
    noise = _noise(edge, stored, rounded)
    products, pairs = (np.zeros(len(_LAGS)),) * 2 if noise is None else _products(*noise, spacing)
    excess, weights = _excess(edge)
    untested = rounded and noise is None
    return Evidence(products, pairs, excess, weights, above, response, normal, spacing, untested)


def processing_findings(edges: Sequence[Evidence]) -> list[Finding]:
    """Return the findings on sharpening and denoising by the evidence of all edges of a picture."""
    overshoot = _overshoot(edges)
    above = float(np.median([edge.above for edge in edges]))
    correlation, strength, changes = _correlation(edges)
    significant = abs(strength) > _CORRELATED and float(np.median(changes)) > 1.0
    numbers = {"overshoot": overshoot, "correlation": correlation, "strength": strength}
    noise = f"noise of neighbours has the correlation {correlation:.2g} ({abs(strength):.0f} standard errors)"
    if overshoot > 0.0 or above > _EFFECT or (significant and correlation < 0.0):
        signs = [f"the profile overshoots by {100 * overshoot:.1f} % of the step"] * (overshoot > 0.0)
        signs += [f"the response exceeds 1 by {above:.2g}"] * (above > _EFFECT)
        signs += [noise] * significant
        return [Finding("sharpened", "doubt", f"the picture was sharpened: {', '.join(signs)}", numbers)]
    if significant:
        text = f"{noise}: the picture was denoised, demosaiced, resized or compressed, which changes the response"
        return [Finding("correlated_noise", "doubt", text, numbers)]
    if all(edge.untested for edge in edges):
        text = "not tested: whether the picture was denoised, since its noise is below the rounding of its values"
        return [Finding("untested", "note", text, {"what": ["denoising"]})]
    return []


def _noise(edge: Edge, stored: Array, rounded: bool) -> tuple[Array, list[Array]] | None:
    """Return the noise, 1 rms, of the areas beside an edge, and orthonormal images of what was fitted; None without.

    The light of each side, with the halo of the edge, is a polynomial.
    """
    height, width = stored.shape
    flat = edge.used & (np.abs(edge.distance) > max(0.5 * edge.reach, min(edge.width, 0.7 * edge.reach)))
    noise = np.zeros((height, width + _LARGEST_LAG * 2))  # zeros part the rows
    fitted: list[Array] = []
    v = np.broadcast_to(np.linspace(-1.0, 1.0, height)[:, None], stored.shape)
    for sign in (-1.0, 1.0):
        side: Mask = flat & (sign * edge.distance > 0.0)
        if (size := int(side.sum())) < _FEW:
            return None
        d = sign * edge.distance[side]
        u = 2.0 * (d - d.min()) / max(float(np.ptp(d)), 1e-12) - 1.0
        powers = legendre.legvander(u, _DEGREE), legendre.legvander(v[side], _DEGREE)
        design = [powers[0][:, i] * powers[1][:, j] for i in range(_DEGREE + 1) for j in range(_DEGREE + 1 - i)]
        basis = np.linalg.qr(np.stack(design, axis=1))[0]
        values = stored[side]
        part = values - basis @ (basis.T @ values)
        sigma = math.sqrt(float(part @ part) / (size - basis.shape[1]))
        if sigma <= (_ROUNDING if rounded else 1e-4 * abs(float(values.mean()))):
            return None
        noise[:, :width][side] = np.clip(part / sigma, -_CLIPPED, _CLIPPED)
        for column in basis.T:
            image = np.zeros_like(noise)
            image[:, :width][side] = column
            fitted.append(image.ravel())
    return noise, fitted


def _products(noise: Array, fitted: list[Array], spacing: int) -> tuple[Array, Array]:
    """Return sums of products of noise at each lag, less those of the fit of white noise, and their numbers.

    The fit Q Q^T of white noise leaves residuals of the covariance 1 - Q Q^T.
    """
    known, flat = (noise != 0.0).ravel().astype(float), noise.ravel()
    products, pairs = np.zeros(len(_LAGS)), np.zeros(len(_LAGS))
    for k, (down, right) in enumerate(spacing * _LAGS):
        lag = int(down * noise.shape[1] + right)
        if 0 < lag < flat.size:
            pairs[k] = known[:-lag] @ known[lag:]
            products[k] = flat[:-lag] @ flat[lag:] + sum(float(image[:-lag] @ image[lag:]) for image in fitted)
    return products, pairs


def _correlation(edges: Sequence[Evidence]) -> tuple[float, float, list[float]]:
    """Return the correlation of neighbours, its standard errors, and the changes of each response in its errors."""
    products, pairs = (sum(getattr(edge, name) for edge in edges) for name in ("products", "pairs"))
    shapes = np.exp(-0.5 * np.square(_LAGS).sum(axis=1) / _RADII[:, None] ** 2)
    # Light that is not quite the fitted one adds as much at all lags.
    contrasts = shapes - shapes @ pairs[:, None] / max(float(pairs.sum()), 1.0)
    variances = np.maximum(np.square(contrasts) @ pairs, 1e-12)
    strengths = contrasts @ products / np.sqrt(variances)
    best = int(np.abs(strengths).argmax())
    size = float(contrasts[best] @ products / variances[best])
    changes = []
    for edge in edges:
        f, values, errors = edge.response
        phase = 2.0 * math.pi * edge.spacing * f[:, None] * (_LAGS @ edge.normal)
        power = np.maximum(1.0 + 2.0 * size * (np.cos(phase) @ shapes[best]), _LEAST_POWER)
        change = values * (1.0 - np.sqrt(power[0] / power))
        changes.append(float(np.max(np.abs(change[1:]) / np.maximum(errors[1:], 1e-12))))
    return size * float(np.exp(-0.5 / _RADII[best] ** 2)), float(strengths[best]), changes


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


def _overshoot(edges: Sequence[Evidence]) -> float:
    """Return the mean overshoot of profiles, as a fraction of the step; 0 within noise.

    Light that is not even has an overshoot on one side.
    """
    weights = sum(edge.weights for edge in edges)
    excess = sum(edge.weights * edge.excess for edge in edges) / np.maximum(weights, 1e-12)
    above = excess * np.sqrt(weights) > _SIDE
    sizes = np.where(above, excess, 0.0).max(axis=1)
    if sizes.min() > _BOTH or sizes.max() > _ONE:
        return float(sizes.max())
    return 0.0
