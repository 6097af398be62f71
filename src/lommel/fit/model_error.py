r"""Model error: standard errors of a fit whose model misses a part of the light.

The residuals of such a fit grow with the light, and those of adjacent pixels are correlated. Their covariance matrix
in an image is modelled as

    V = diag(v) + kappa^2 s s' o exp(-d^2 / (2 l^2)),

where v is the variance of noise, s the smoothed light of the star, d the distance of two pixels and o the product of
elements; images are independent. Restricted maximum likelihood (REML; Patterson and Thompson 1971,
doi:10.1093/biomet/58.3.545) determines kappa and l from the residuals, without bias from the p fitted parameters:
``-2 lnL = ln det V + ln det A' V^-1 A + r' P r``, where A are the derivatives of electrons by the parameters, and P
projects the residuals r. Generalized least squares then gives a step of the parameters, and the covariance
``(A' V^-1 A)^-1``. The estimates without this step have the covariance ``C A' W V W A C`` for the weights
W = diag(1 / v), with ``C = (A' W A)^-1``. Both assume that V is right. The delete-one jackknife does not: it is the
scatter of the estimates if one part of the data after the other is left out.

An error of the model that resembles a change of a parameter is in no residual. The errors are therefore valid for
differences between exposures of the same instrument.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
import scipy

from lommel.base.arrays import Array
from lommel.fit.findings import Finding, Findings
from lommel.fit.goodness_of_fit import excess_test

MIN_GAIN = 10.0
"""Increase of the restricted ln(likelihood) above which a model error is significant although chi2 is plausible."""
MAX_MISSED = 0.3
"""Part of the light above which a model that misses it does not describe the images at all."""
MAX_PHASE_ERROR = 0.5
"""Largest step and standard error of a wavefront, radians rms, within which images near focus are linear enough."""
# A wave rms of coma changes the light of a star, W waves out of focus, by 17 / W rms: relative to the radius, it
# moves rays by its gradient over 2 W, and the light by its Laplacian, sqrt(8) 24 rho cos(theta), over 2 W.
_LIGHT_OF_COMA = 17.0
_MIN_WAVES = 1.5  # least defocus of a star for which this holds, waves between centre and edge
_BETWEEN = "errors hold between exposures of this set-up"
_FEW = 0.01  # part of the light below which light that is missed where images are faint is told in electrons
_MOST_COVERED = 0.03  # part of the light up to which errors that include the model error are reliable
_MIN_PIXELS = 10.0  # smallest number of pixels for each parameter
_MAX_SIDE = 18  # largest side of a binned image: V of an image has at most this number to the fourth elements
_LENGTHS = 0.1, 0.7, 1.4  # correlation lengths l, bins
_SMOOTHING = 1.0  # standard deviation of the Gaussian by which light is smoothed, bins
_LOG_KAPPAS = -9.0, 2.5  # range of ln(kappa)
_SECTORS = 8  # number of parts of an image for the jackknife
# Part of the light above which the jackknife is not used: residuals of a sector are then alike, and leaving it out
# changes estimates by more than their errors.
_MOST_FOR_JACKKNIFE = 0.05
# Significance of correlated residuals, standard deviations, above which REML is computed, and their length, pixels.
_GATE, _GATE_LENGTH = 4.0, 2.0
_RIDGE = 1e-10  # is added to normal matrices of diagonal 1, such that undetermined parameters have no effect


class ModelError(NamedTuple):
    """Result of :func:`model_error`.

    `shift` (p,) is the step of generalized least squares, and `covariance` (p, p) that of the parameters after this
    step, increased to the variances of the jackknife or, if much light is missed, of estimates without the step.
    `missed` is the rms residual beyond noise, relative to the rms light; `kappa` and `length` (pixels) are those of
    V; `gain` is the increase of the restricted ln(likelihood) by kappa.
    """

    shift: Array
    covariance: Array
    missed: float
    kappa: float
    length: float
    gain: float

    def holds(self, rms: Callable[[Array], Array], step: Array, most: float = MAX_PHASE_ERROR) -> bool:
        """Return whether the errors describe the fit; `rms` returns the rms phase of steps (1, p), radians.

        Images are linear within a phase of `most` radians rms.

        The further `step` (p,) of the fit must be within the errors: a misfit gains likelihood until the last digit.
        """
        errors = np.sqrt(np.diag(self.covariance))
        sizes = np.concatenate([rms(row[None]) for row in (self.shift, errors)])
        return self.missed <= MAX_MISSED and bool(sizes.max() <= most and (np.abs(step) <= errors).all())


def part_missed(residual: Array, variance: Array, light: Array) -> float:
    """Return the rms residual beyond noise, relative to the rms light; residuals are NaN at pixels left out."""
    total = max(float((light[np.isfinite(residual)] ** 2).sum()), 1e-300)
    return math.sqrt(max(float(np.nansum(residual**2 - variance)), 0.0) / total)


def with_errors_of_model(
    findings: Sequence[Finding], residual: Array, variance: Array, light: Array, causes: str
) -> list[Finding]:
    """Return findings in which a misfit is a doubt, with its `causes`: errors include residuals beyond noise."""
    missed = part_missed(residual, variance, light)
    text, numbers = f"the model misses {100.0 * missed:.2g} % of the light", {"missed": missed}
    known = np.isfinite(residual)
    excess, noise = (residual**2 - variance)[known], variance[known]
    # Of two sums of squares beyond noise, the one weighed by 1 / v^2 is that of faint pixels.
    faint = float((excess / noise**2).sum())
    if faint / math.sqrt(float((1.0 / noise**2).sum())) > excess.sum() / math.sqrt(float((noise**2).sum())):
        numbers["faint"] = math.sqrt(max(faint, 0.0) / float((1.0 / noise**2).sum()))
        if missed < _FEW:
            text = f"the model misses light where images are faint, {numbers['faint']:.2g} electrons per pixel rms"
    text = "; ".join(filter(None, (text, _BETWEEN, causes)))
    others = [finding for finding in findings if finding.code not in ("misfit", "rare_chi2")]
    return [Finding("missed_light", "doubt", text, numbers), *others]


def covered(findings: Sequence[Finding]) -> list[Finding]:
    """Return findings in which doubts that a small model error includes, in proportion to the light, are notes."""
    numbers = next((one.numbers for one in findings if one.code == "missed_light"), {"missed": 1.0})
    is_covered = numbers["missed"] < _MOST_COVERED and "faint" not in numbers
    codes = ("missed_light", "other_explanation") if is_covered else ()
    return [replace(one, severity="note") if one.code in codes else one for one in findings]


def shared_error(missed: float, waves: float) -> float:
    """Return the error of an aberration, waves rms, if light that is missed of a star out of focus is due to it."""
    return missed * waves / _LIGHT_OF_COMA


def with_shared_error(findings: Sequence[Finding], defoci: Array) -> Findings:
    """Return findings in which the doubt on missed light of stars out of focus states what it may move in all.

    `defoci` are the known C_d, radians.
    """
    waves, found = float(np.abs(defoci).max()) / math.pi, list[Finding]()
    for one in findings:
        if one.code == "missed_light" and one.severity == "doubt" and waves >= _MIN_WAVES:
            radians = 2.0 * math.pi * shared_error(one.numbers["missed"], waves)
            words = f"{_BETWEEN}; what all of them share may move each term by up to {radians:.2g} rad rms"
            numbers = {**one.numbers, "shared": radians}
            found.append(replace(one, text=one.text.replace(_BETWEEN, words), numbers=numbers))
        else:
            found.append(one)
    return Findings(found)


def is_correlated(residual: Array, variance: Array, light: Array) -> bool:
    """Return whether products of residuals (n, height, width) of adjacent pixels show a significant model error.

    This is the score test of kappa = 0 for one correlation length, without the effect of the fit. Residuals
    are NaN at pixels left out.
    """
    ratio = np.where(np.isfinite(residual), np.maximum(light, 0.0), 0.0) / np.sqrt(variance)
    score, square = ratio * np.nan_to_num(residual) / np.sqrt(variance), ratio**2
    # exp(-d^2 / (2 w^2)) is a normalized Gaussian times 2 pi w^2; its square is one of width w / sqrt(2).
    sums = [
        2.0 * math.pi * w**2 * float((part * scipy.ndimage.gaussian_filter(part, (0.0, w, w), mode="constant")).sum())
        for part, w in ((score, _GATE_LENGTH), (square, _GATE_LENGTH / math.sqrt(2.0)))
    ]
    return sums[0] - float(square.sum()) > _GATE * math.sqrt(2.0 * sums[1])


def noise_findings(residual: Array, mean: Array, read: Array, background: Array, excess: float) -> list[Finding]:
    """Return the finding on noise that is not the stated one: electron multiplication, or another gain.

    Arrays have the shape (..., height, width). Noise of another gain is not correlated, unlike light that the model
    misses.
    """
    found, size = excess_test(residual, mean, read).findings(excess), (-1, *residual.shape[-2:])
    if "gain" not in Findings(found).codes:
        return found
    variance = (mean + read) * float(np.nanmean(residual**2 / (mean + read)))
    parts = (residual, variance, mean - background)
    return [] if is_correlated(*(np.broadcast_to(part, residual.shape).reshape(size) for part in parts)) else found


def with_noise(
    findings: Sequence[Finding], effects: list[Any], parts: tuple[Array, Array, Array], read: Array, excess: float
) -> tuple[list[Finding], list[Any]]:
    """Return findings with that of :func:`noise_findings` first, if chi2 is not that of noise, and `effects`.

    `parts` are residual, variance and light, and `effects` those that the images favour: none with another gain, as
    they were tested by another noise.
    """
    if {"misfit", "too_quiet"}.isdisjoint(Findings(findings).codes):
        return [*findings], effects
    residual, variance, light = parts
    of_noise = noise_findings(residual, variance - read, read, variance - read - light, excess)
    kept = [] if "gain" in Findings(of_noise).codes else effects
    return [*(() if kept else of_noise), *findings], kept


def model_error(residual: Array, derivatives: Array, variance: Array, light: Array) -> ModelError | None:
    """Return the model error of a fit, and standard errors that include it; None if there are too few pixels.

    Parameters
    ----------
    residual, variance, light : ndarray, shape (n, height, width)
        Residuals (electrons; NaN at pixels left out), variance of noise (electrons^2), and light without background.
    derivatives : ndarray, shape (p, n, height, width)
        Derivatives of the electrons by the p parameters.
    """
    valid, bins, p = np.isfinite(residual), -(-max(residual.shape[1:]) // _MAX_SIDE), len(derivatives)
    if valid.sum() < _MIN_PIXELS * p:
        return None
    missed = part_missed(residual, variance, light)
    y, noise, s = (_binned(np.where(valid, part, 0.0), bins) for part in (residual, variance, np.maximum(light, 0.0)))
    sectors = _sectors(s)
    deviation = np.sqrt(np.where(noise > 0.0, noise, math.inf))
    s = scipy.ndimage.gaussian_filter(s, (0.0, _SMOOTHING, _SMOOTHING)) / deviation
    y, columns = y / deviation, _binned(np.where(valid, derivatives, 0.0), bins) / deviation
    # Normal matrices have a diagonal of 1.
    scale = 1.0 / np.sqrt(np.maximum((columns**2).sum(axis=(1, 2, 3)), 1e-300))
    columns *= scale[:, None, None, None]
    fits, images = [], np.concatenate([y[None], columns])
    for length in _LENGTHS:
        rotated = _rotated(images, s, length)
        found = scipy.optimize.minimize_scalar(
            lambda t, rotated=rotated: -_estimate(rotated, math.exp(t))[0], bounds=_LOG_KAPPAS, method="bounded"
        )
        fits.append((-float(found.fun), math.exp(found.x), length, rotated))
    likelihood, kappa, length, rotated = max(fits, key=lambda fit: fit[0])
    _, inverse, shift = _estimate(rotated, kappa)
    noise_likelihood, plain, _ = _estimate(rotated, 0.0)
    if missed > _MOST_FOR_JACKKNIFE:
        flat = rotated[2:]
        other = plain @ (flat * (1.0 + kappa**2 * rotated[0])) @ flat.T @ plain
    else:
        parts = [np.where(sectors == k, columns, 0.0).reshape(p, -1) for k in np.unique(sectors)]
        slopes = np.array([part @ y.ravel() for part in parts])
        other = jackknife(np.array([part @ part.T for part in parts]), slopes)
    covariance = larger(inverse, other) * np.outer(scale, scale)
    return ModelError(scale * shift, covariance, missed, kappa, length * bins, likelihood - noise_likelihood)


def jackknife(information: Array, slope: Array, whole: tuple[Array, Array] | None = None) -> Array:
    """Return the covariance (p, p) of estimates by the delete-one jackknife, from one step of scoring each.

    `information` (g, p, p) and `slope` (g, p), the gradient of the log-likelihood at the estimate, are those of g
    parts of the data; `whole` are those of all data and the priors, by default the sums over the parts.
    """
    total, gradient = (information.sum(axis=0), slope.sum(axis=0)) if whole is None else whole
    scale = 1.0 / np.sqrt(np.maximum(np.diag(total), 1e-300))
    matrices = (total - information) * np.outer(scale, scale) + _RIDGE * np.eye(len(scale))
    steps = np.linalg.solve(matrices, (scale * (gradient - slope))[..., None])[..., 0] * scale
    steps -= steps.mean(axis=0)
    return np.asarray((1.0 - 1.0 / len(steps)) * steps.T @ steps)


def larger(covariance: Array, other: Array) -> Array:
    """Return `covariance`, scaled such that no variance is smaller than that of `other`."""
    ratio = np.diag(other) / np.maximum(np.diag(covariance), 1e-300)
    scale = np.sqrt(np.where(np.isfinite(ratio), np.maximum(ratio, 1.0), 1.0))
    return np.asarray(covariance * np.outer(scale, scale))


def _rotated(images: Array, s: Array, length: float) -> Array:
    """Return images (q, n, height, width) in coordinates in which V is diagonal, after its eigenvalues, (q + 1, m).

    Images are whitened; the coordinates are eigenvectors of ``s s' o exp(-d^2 / (2 length^2))`` for each of the n.
    """
    rows, columns = (grid.ravel() for grid in np.indices(s.shape[1:]))
    distance2 = np.subtract.outer(rows, rows) ** 2 + np.subtract.outer(columns, columns) ** 2
    correlation, parts = np.exp(-0.5 * distance2 / length**2), []
    for k, amplitude in enumerate(s):
        powers, vectors = scipy.linalg.eigh(correlation * np.outer(amplitude, amplitude), driver="evd")
        parts.append(np.vstack([np.maximum(powers, 0.0), images[:, k].reshape(len(images), -1) @ vectors]))
    return np.concatenate(parts, axis=1)


def _estimate(rotated: Array, kappa: float) -> tuple[float, Array, Array]:
    """Return the restricted ln(likelihood) without its constant, and covariance and step of the parameters."""
    powers, residual, columns = rotated[0], rotated[1], rotated[2:]
    weight = 1.0 / (1.0 + kappa**2 * powers)
    weighted = columns * weight
    matrix, slope = weighted @ columns.T + _RIDGE * np.eye(len(weighted)), weighted @ residual
    inverse = np.linalg.inv(matrix)
    step = np.asarray(inverse @ slope)
    square = float(residual**2 @ weight - slope @ step)
    likelihood = 0.5 * (float(np.log(weight).sum()) - float(np.linalg.slogdet(matrix)[1]) - square)
    return likelihood, np.asarray(inverse), step


def _binned(images: Array, bins: int) -> Array:
    """Return sums of images (..., height, width) over squares of pixels, which are smaller at the end."""
    for axis in (-2, -1):
        images = np.add.reduceat(images, range(0, images.shape[axis], bins), axis=axis)
    return images


def _sectors(light: Array) -> Array:
    """Return the number of the sector of each pixel (n, height, width), about the centroid of each image's light."""
    grid = np.indices(light.shape[1:])
    centers = np.einsum("nyx,kyx->kn", light, grid) / np.maximum(light.sum(axis=(1, 2)), 1e-300)
    y, x = grid[:, None] - centers[:, :, None, None]
    part = np.arctan2(y, x) / (2.0 * math.pi) % 1.0
    return np.asarray(np.floor(part * _SECTORS) % _SECTORS + _SECTORS * np.arange(len(light))[:, None, None])
