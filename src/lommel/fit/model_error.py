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
from typing import NamedTuple

import numpy as np
import scipy

from lommel.base.arrays import Array
from lommel.fit.findings import Finding
from lommel.fit.score_tests import Marginal

MIN_GAIN = 10.0
"""Increase of the restricted ln(likelihood) above which a model error is significant although chi2 is plausible."""
MAX_MISSED = 0.3
"""Part of the light above which a model that misses it does not describe the images at all."""
_MAX_PHASE_ERROR = 0.5  # largest step and standard error of a wavefront, radians rms
_MIN_PIXELS = 10.0  # smallest number of pixels for each parameter
_MAX_SIDE = 18  # largest side of a binned image: V of an image has at most this number to the fourth elements
_LENGTHS = 0.0, 0.7, 1.4  # correlation lengths l, bins
_SMOOTHING = 1.0  # standard deviation of the Gaussian by which light is smoothed, bins
_KAPPAS = 1e-4, 10.0  # range of kappa
_SECTORS = 8  # number of parts of an image for the jackknife
# Part of the light above which the jackknife is not used: residuals of a sector are then alike, and leaving it out
# changes estimates by more than their errors.
_MOST_FOR_JACKKNIFE = 0.05
_GATE = 4.0  # significance of correlated residuals, standard deviations, above which REML is computed
_RIDGE = 1e-10  # is added to normal matrices of diagonal 1, such that undetermined parameters have no effect


class ModelError(NamedTuple):
    """Result of :func:`model_error`.

    `shift` (p,) is the step of generalized least squares, and `covariance` (p, p) that of the parameters after this
    step, increased to the variances of the jackknife or, if much light is missed, of estimates without the step.
    `missed` is the rms residual beyond noise, relative to the rms light; `kappa` and `length` (pixels) are those of
    V; `gain` is the increase of the restricted ln(likelihood) by kappa; `bins` is the side of the squares of pixels
    that were summed.
    """

    shift: Array
    covariance: Array
    missed: float
    kappa: float
    length: float
    gain: float
    bins: int

    def holds(self, rms: Callable[[Array], Array], step: Array) -> bool:
        """Return whether the errors describe the fit; `rms` returns the rms phase of steps (1, p), radians.

        The further `step` (p,) of the fit must be within the errors: a misfit gains likelihood until the last digit.
        """
        errors = np.sqrt(np.diag(self.covariance))
        sizes = [float(rms(row[None])[0]) for row in (self.shift, errors)]
        is_settled = bool((np.abs(step) <= errors).all())
        return is_settled and self.missed <= MAX_MISSED and max(sizes) <= _MAX_PHASE_ERROR

    def marginal(self, noise: Array) -> Marginal:
        """Return shift and covariance of the first parameters, with at least the variances in `noise` (k, k)."""
        count = len(noise)
        return Marginal(self.shift[:count], larger(self.covariance[:count, :count], noise))


def part_missed(residual: Array, variance: Array, light: Array) -> float:
    """Return the rms residual beyond noise, relative to the rms light; residuals are NaN at pixels left out."""
    valid = np.isfinite(residual)
    excess = float((residual[valid] ** 2 - variance[valid]).sum())
    return math.sqrt(max(excess, 0.0) / max(float((light[valid] ** 2).sum()), 1e-300))


def with_errors_of_model(findings: Sequence[Finding], error: ModelError | float) -> list[Finding]:
    """Return findings in which a misfit is a doubt, with its causes: errors include the model error.

    `error` is the model error, or the part of the light that is missed.
    """
    numbers = {}
    if isinstance(error, ModelError):
        numbers = {"kappa": error.kappa, "length": error.length, "log_likelihood": error.gain}
        error = error.missed
    text = f"the model misses {100.0 * error:.2g} % of the light; errors hold between exposures of this set-up"
    text = "; ".join((text, *(finding.text for finding in findings if finding.code == "misfit")))
    others = [finding for finding in findings if finding.code not in ("misfit", "rare_chi2")]
    return [Finding("missed_light", "doubt", text, {"missed": error, **numbers}), *others]


def is_correlated(residual: Array, variance: Array, light: Array) -> bool:
    """Return whether products of residuals (n, height, width) of adjacent pixels show a significant model error.

    This is the score test of kappa = 0 for a correlation length of a bin, without the effect of the fit. Residuals
    are NaN at pixels left out.
    """
    valid = np.isfinite(residual)
    length = float(_bins_of(residual.shape))
    ratio = np.where(valid, np.maximum(light, 0.0), 0.0) / variance
    slope = ratio * np.where(valid, residual, 0.0)
    square = ratio * ratio * variance

    def correlated(images: Array, width: float) -> float:
        # The kernel exp(-d^2 / (2 width^2)) is a normalized Gaussian times 2 pi width^2.
        blurred = scipy.ndimage.gaussian_filter(images, (0.0, width, width), mode="constant")
        return float(2.0 * math.pi * width**2 * (images * blurred).sum())

    excess = correlated(slope, length) - float(square.sum())
    return excess > _GATE * math.sqrt(2.0 * correlated(square, length / math.sqrt(2.0)))


def model_error(residual: Array, derivatives: Array, variance: Array, light: Array) -> ModelError | None:
    """Return the model error of a fit, and standard errors that include it; None if there are too few pixels.

    Parameters
    ----------
    residual, variance, light : ndarray, shape (n, height, width)
        Residuals (electrons; NaN at pixels left out), variance of noise (electrons^2), and light without background.
    derivatives : ndarray, shape (p, n, height, width)
        Derivatives of the electrons by the p parameters.
    """
    valid, bins, p = np.isfinite(residual), _bins_of(residual.shape), len(derivatives)
    if valid.sum() < _MIN_PIXELS * p:
        return None
    missed = part_missed(residual, variance, light)
    light = np.where(valid, np.maximum(light, 0.0), 0.0)
    y, noise, s = (_binned(np.where(valid, part, 0.0), bins) for part in (residual, variance, light))
    columns = _binned(np.where(valid, derivatives, 0.0), bins)
    shape = y.shape
    deviation = np.sqrt(noise)
    whitening = np.divide(1.0, deviation, out=np.zeros_like(deviation), where=deviation > 0.0)
    s = scipy.ndimage.gaussian_filter(s, (0.0, _SMOOTHING, _SMOOTHING)) * whitening
    y, columns = y * whitening, columns * whitening
    # Normal matrices have a diagonal of 1.
    scale = 1.0 / np.sqrt(np.maximum((columns**2).sum(axis=(1, 2, 3)), 1e-300))
    columns *= scale[:, None, None, None]
    flat = y.reshape(len(y), -1), columns.reshape(p, len(y), -1), s.reshape(len(y), -1)
    best: tuple[float, float, float, _Rotated] | None = None
    for length in _LENGTHS:
        rotated = _Rotated.of(*flat, length, shape[1:])
        found = scipy.optimize.minimize_scalar(
            lambda t, rotated=rotated: -rotated.likelihood(math.exp(t)),
            bounds=tuple(map(math.log, _KAPPAS)), method="bounded", options={"xatol": 0.02},
        )  # fmt: skip
        if best is None or -found.fun > best[0]:
            best = -float(found.fun), math.exp(found.x), length, rotated
    assert best is not None
    likelihood, kappa, length, rotated = best
    inverse, shift = rotated.solve(kappa)
    if missed > _MOST_FOR_JACKKNIFE:
        plain, _ = rotated.solve(0.0)
        other = plain @ rotated.moment(kappa) @ plain
    else:
        sectors = _sectors(light, bins)
        parts = [np.where(sectors == k, columns, 0.0).reshape(p, -1) for k in np.unique(sectors)]
        slopes = np.array([part @ y.ravel() for part in parts])
        other = jackknife(np.array([part @ part.T for part in parts]), slopes)
    covariance = larger(inverse, other) * np.outer(scale, scale)
    gain = likelihood - rotated.likelihood(0.0)
    return ModelError(scale * shift, covariance, missed, kappa, length * bins, gain, bins)


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


class _Rotated(NamedTuple):
    """Residuals (n, m) and derivatives (p, n, m) in coordinates in which V is diagonal: 1 + kappa^2 `powers`."""

    powers: Array
    residual: Array
    columns: Array

    @classmethod
    def of(cls, y: Array, columns: Array, s: Array, length: float, shape: tuple[int, ...]) -> _Rotated:
        """Return whitened images in the coordinates of the eigenvectors of ``s s' o exp(-d^2 / (2 length^2))``."""
        if length == 0.0:
            return cls((s * s).ravel(), y.ravel(), columns.reshape(len(columns), -1))
        rows, cols = np.divmod(np.arange(s.shape[1]), shape[1])
        distance2 = np.subtract.outer(rows, rows) ** 2 + np.subtract.outer(cols, cols) ** 2
        correlation = np.exp(-0.5 * distance2 / length**2)
        powers, residual, derivatives = np.empty_like(s), np.empty_like(y), np.empty_like(columns)
        for i, amplitude in enumerate(s):
            values, vectors = scipy.linalg.eigh(correlation * np.outer(amplitude, amplitude), driver="evd")
            powers[i], residual[i] = np.maximum(values, 0.0), y[i] @ vectors
            derivatives[:, i] = columns[:, i] @ vectors
        return cls(powers.ravel(), residual.ravel(), derivatives.reshape(len(columns), -1))

    def _normal(self, kappa: float) -> tuple[Array, Array, Array]:
        weight = 1.0 / (1.0 + kappa**2 * self.powers)
        weighted = self.columns * weight
        return weight, weighted @ self.columns.T + _RIDGE * np.eye(len(weighted)), weighted @ self.residual

    def solve(self, kappa: float) -> tuple[Array, Array]:
        """Return covariance and step of generalized least squares."""
        _, matrix, slope = self._normal(kappa)
        inverse = np.asarray(np.linalg.inv(matrix), np.float64)
        return inverse, inverse @ slope

    def moment(self, kappa: float) -> Array:
        """Return ``A' W V W A``, the covariance of the gradient for weights that neglect the model error."""
        return np.asarray((self.columns * (1.0 + kappa**2 * self.powers)) @ self.columns.T)

    def likelihood(self, kappa: float) -> float:
        """Return the restricted ln(likelihood), without its constant."""
        weight, matrix, slope = self._normal(kappa)
        square = float(self.residual**2 @ weight - slope @ np.linalg.solve(matrix, slope))
        return 0.5 * (float(np.log(weight).sum()) - float(np.linalg.slogdet(matrix)[1]) - square)


def _bins_of(shape: tuple[int, ...]) -> int:
    """Return the side of the squares of pixels that are summed, for images of this shape (n, height, width)."""
    return -(-max(shape[1:]) // _MAX_SIDE)


def _binned(images: Array, bins: int) -> Array:
    """Return sums of images (..., height, width) over squares of pixels; images are extended by zeros."""
    height, width = images.shape[-2:]
    padded = np.pad(images, [(0, 0)] * (images.ndim - 2) + [(0, -height % bins), (0, -width % bins)])
    height, width = padded.shape[-2] // bins, padded.shape[-1] // bins
    return np.asarray(padded.reshape(*images.shape[:-2], height, bins, width, bins).sum(axis=(-3, -1)))


def _sectors(light: Array, bins: int) -> Array:
    """Return the number of the sector of each bin (n, height, width), about the centroid of each image's light."""
    binned = _binned(light, bins)
    grid = np.indices(binned.shape[1:])
    centers = np.einsum("nyx,kyx->kn", binned, grid) / np.maximum(binned.sum(axis=(1, 2)), 1e-300)
    y, x = grid[:, None] - centers[:, :, None, None]
    sector = np.floor(np.arctan2(y, x) / (2.0 * math.pi) % 1.0 * _SECTORS).clip(0, _SECTORS - 1).astype(int)
    return np.asarray(sector + _SECTORS * np.arange(len(light))[:, None, None])
