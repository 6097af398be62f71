"""Fisher scoring: damped steps (Levenberg and Marquardt) to the parameters of maximum likelihood.

Steps use the Fisher information in place of the Hessian; its inverse at the maximum is the covariance. The search is
from several sets of parameters (starts) in parallel. A model whose parameters are a matrix, with one row for each
set, computes images and their derivatives (:class:`RowModel`). Other models compute their steps themselves
(:class:`Problem`).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import suppress
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Declined, ToleranceError
from lommel.fit import goodness_of_fit

# Gain predicted by the next step below which a search has converged; the predicted gain is the squared length of the
# step in standard errors. A fast search takes this last step, an exact search does not.
_CONVERGED, _CONVERGED_FAST = 1e-2, 1.0
_OSCILLATION_DAMPING = 0.5  # least damping after a step that overshoots
_MAX_PHASE_STEP = 2.0  # radians rms: largest change of the wavefront in a step
# Damping relative to the diagonal of the information; above the maximum a search fails.
_FIRST_DAMPING, _MIN_DAMPING, _MAX_DAMPING = 1e-2, 1e-6, 1e8
_MAX_STRETCH = 16.0  # largest factor by which a step is lengthened
# A search is in a local minimum if its fit is bad and _PATIENCE steps in a row gain less than the fraction _STALLED
# of (chi2 in excess of its limit) * (degrees of freedom).
_STALLED, _PATIENCE = 1e-4, 3
_STEP_SHARE = 0.02  # least part of the remaining fraction of the progress that a step takes

Report = Callable[[int, float], object]
"""Function of the number of a step and of the best chi2 before this step."""


class Progress:
    """Report of the steps of searches, however many follow; `begin` states what is known about the next steps.

    `function`, if any, is called with the fraction of the time that has passed, and with chi2. The fraction decreases
    if a refit follows, see `resume`.
    """

    def __init__(self, function: Callable[[float, float], object] | None) -> None:
        self.function, self.done, self.end, self.left, self.chi2 = function, 0.0, 1.0, math.inf, math.nan

    def begin(self, share: float, steps: int) -> None:
        """Begin a phase of about `steps` steps, which takes a part `share` of the remaining time."""
        self.done = self.done if self.left == math.inf else self.end  # a phase may have had fewer steps
        self.end, self.left = self.done + share * (1.0 - self.done), steps

    def resume(self, most: float) -> None:
        """State that at most the fraction `most` of the time has passed, as another fit follows."""
        self.done, self.left = min(self.done, most), math.inf

    def __call__(self, step: int, chi2: float | None = None) -> None:
        """Report a step of any of the searches; chi2 is by default that of the step before."""
        self.done += (self.end - self.done) * max(_STEP_SHARE, 1.0 / max(self.left, 2.0))
        self.left, self.chi2 = self.left - 1, self.chi2 if chi2 is None else chi2
        if self.function is not None:
            self.function(self.done, self.chi2)


class Scores(NamedTuple):
    """Quality of the fit for s sets of p parameters.

    `deviance` (s,) is minus the log-likelihood L, `slope` (s, p) the gradient of L, and `information` (s, p, p) the
    Fisher information. `chi2` (s,) is Pearson's chi2 divided by its expectation, and `spread` (s,) the standard
    deviation of `chi2` for a correct model.
    """

    deviance: Array
    slope: Array
    information: Array
    chi2: Array
    spread: Array


class RowModel(Protocol):
    """A model of images with parameters `x`, shape (s, p): one row for each set of parameters."""

    size: int  # number p of parameters
    degrees_of_freedom: int  # of a row: pixels minus parameters
    alternatives: bool  # whether rows are starts for the same images: the search then ends when one row fits

    def images(self, x: Array, *, fast: bool = False) -> tuple[Any, Any]:
        """Return the PSFs of all images for parameters `x`, and their derivatives.

        If `fast`, images are computed only with the accuracy that a search needs.
        """

    def scores(self, x: Array, *, fast: bool = False, rows: NDArray[np.intp] | None = None) -> Scores:
        """Return the quality of the fit for parameters `x`; `rows` are the indices of these sets among all sets."""
        return self.scores_of(x, *self.images(x, fast=fast))

    def scores_of(self, x: Array, values: Any, slopes: Any) -> Scores:
        """Return the quality of the fit from the results of :meth:`images`."""

    def with_flux_background(self, x: Array, values: Any) -> Array:
        """Return parameters with the least-squares flux and background, unless the model prescribes these."""
        return x

    def within(self, x: Array, before: Array) -> Array:
        """Limit parameters `x` to their valid range in place, given those before the step, and return them."""

    def rms(self, steps: Array) -> Array:
        """Return the rms change of the phase by each step (radians); 0 without wavefront parameters."""
        return np.zeros(len(steps))

    def steps(self, scores: Scores, damping: Array) -> tuple[Array, Array]:
        """Return damped steps (s, p) and the decrease of the deviance that is predicted for each step."""
        return damped_steps(scores, damping)


Rows = NDArray[np.intp]


class Problem(Protocol):
    """A maximisation of the likelihood from s sets of parameters `x`, with their `scores`.

    Sets are the rows of an array or, for s = 1, an object of any type. `rows` are the indices of the sets whose
    search has not ended.
    """

    degrees_of_freedom: int  # pixels minus parameters
    alternatives: bool  # whether the search ends when the first set fits

    def step(self, x: Any, scores: Scores, rows: Rows, damping: Array) -> tuple[Array, Array]:
        """Return damped steps of these rows and the decrease of the deviance that is predicted for each step."""

    @property
    def rms(self) -> Callable[[Array], Array] | None:
        """Function that returns the rms phase (radians) of steps; None if steps are not lengthened."""

    def attempt(self, x: Any, scores: Scores, rows: Rows, step: Array, factor: Array) -> tuple[Any, Scores | None]:
        """Return parameters after steps multiplied by `factor`, and their scores (None if not computable)."""


class Ascent(NamedTuple):
    """Result of a search: parameters, their scores, a mask of the converged sets, and the number of steps tried."""

    x: Any
    scores: Scores
    settled: NDArray[np.bool_]
    steps: int


def fisher_scoring(
    problem: Problem,
    x: Any,
    scores: Scores,
    max_steps: int,
    report: Report,
    *,
    settled_gain: float = _CONVERGED,
    max_damping: float = _MAX_DAMPING,
    stalled: float = _STALLED,
    last: Callable[[Any, Array, Rows, NDArray[np.bool_]], object] | None = None,
) -> Ascent:
    """Take at most `max_steps` damped steps from parameters `x` until all sets have converged or one of them fits.

    A set has converged if the predicted gain is below `settled_gain`. Its search fails if the damping exceeds
    `max_damping`, or after several slow steps in a row without a good fit. A slow step gains less than the fraction
    `stalled` of what is missing for a good fit.
    At the end, ``last(x, step, rows, converged)`` is called with the next steps of the sets `rows`; this function
    does not take them.
    """
    count = len(scores.chi2)
    damping, stretch = np.full(count, _FIRST_DAMPING), np.ones(count)
    settled, moving = np.zeros(count, dtype=bool), np.ones(count, dtype=bool)
    tried_steps, slow_steps = 0, np.zeros(count, dtype=int)
    for step_number in range(max_steps + 1):
        report(step_number, float(scores.chi2.min()))
        rows = np.flatnonzero(moving)
        step, predicted = problem.step(x, scores, rows, damping[rows])
        # A strongly damped step is short at any point: a small predicted gain is then no sign of convergence.
        converged = (predicted < settled_gain) & (damping[rows] <= 1.0)
        settled[rows] = converged
        moving[rows] = ~converged & (damping[rows] <= max_damping) & (slow_steps[rows] < _PATIENCE)
        ended = rows[converged]  # of which one that fits ends the search for alternatives
        limits = goodness_of_fit.largest_plausible_chi2(scores.spread[ended], goodness_of_fit.SURE)
        fits = problem.alternatives and bool((scores.chi2[ended] < limits).any())
        if step_number == max_steps or not moving.any() or fits:
            if last is not None and converged.any():
                last(x, step, rows, converged)
            break
        still_moving = moving[rows]
        rows, predicted, step = rows[still_moving], predicted[still_moving], step[still_moving]
        factor = np.ones(rows.size)
        if problem.rms is not None:
            factor = np.minimum(stretch[rows], _MAX_PHASE_STEP / np.maximum(problem.rms(step), 1e-300))
        new_x, new_scores = problem.attempt(x, scores, rows, step, factor)
        tried_steps += rows.size
        gain = np.full(rows.size, -np.inf) if new_scores is None else scores.deviance[rows] - new_scores.deviance
        predicted = predicted * factor
        gained, stretched = gain > 0.0, stretch[rows] > 1.0
        # After a lengthened step that failed, the factor is reset first, and the damping stays.
        damping[rows] *= np.where(gained, 0.1, np.where(stretched, 1.0, 6.0))
        if problem.rms is not None:
            # Steps are lengthened if the last step gained nearly the predicted amount: far from the maximum, the
            # information is larger than the curvature of the likelihood.
            linear, curved = gain > 0.65 * predicted, gain < 0.3 * predicted
            lengthened = np.minimum(2.0 * np.maximum(factor, 1.0), _MAX_STRETCH)
            stretch[rows] = np.where(linear, lengthened, np.where(curved, 1.0, stretch[rows]))
            # Near the maximum, a step that gains much less than predicted overshoots: without damping, steps would
            # oscillate.
            overshoots = gained & (predicted < 1.0) & (gain < 0.25 * predicted)
            damping[rows[overshoots]] = np.maximum(damping[rows[overshoots]], _OSCILLATION_DAMPING)
        np.maximum(damping, _MIN_DAMPING, out=damping)
        excess = scores.chi2[rows] - goodness_of_fit.largest_plausible_chi2(scores.spread[rows])
        slow = gained & (gain < stalled * problem.degrees_of_freedom * excess)
        slow_steps[rows] = np.where(slow, slow_steps[rows] + 1, np.where(gained, 0, slow_steps[rows]))
        if new_scores is None or not gained.any():
            continue
        if gained.all() and rows.size == count:
            x, scores = new_x, new_scores
            continue
        x[rows[gained]] = new_x[gained]
        for values, new_values in zip(scores, new_scores, strict=True):
            values[rows[gained]] = new_values[gained]
    return Ascent(x, scores, settled, tried_steps)


class _RowProblem:
    """Problem for a model with parameters in rows; if `fast`, images have only the accuracy that a search needs."""

    def __init__(self, model: RowModel, fast: bool) -> None:
        self.model, self.fast, self.rms = model, fast, model.rms
        self.degrees_of_freedom, self.alternatives = model.degrees_of_freedom, model.alternatives

    def step(self, x: Array, scores: Scores, rows: Rows, damping: Array) -> tuple[Array, Array]:
        row_scores = scores if rows.size == len(x) else Scores(*(values[rows] for values in scores))
        step, predicted = self.model.steps(row_scores, damping)
        # At a limit the slope is not 0: the predicted gain includes only the part of the step within the limits.
        allowed = self.model.within(x[rows] + step, x[rows]) - x[rows]
        return step, np.minimum(predicted, np.maximum((allowed * row_scores.slope).sum(axis=1), 0.0))

    def attempt(
        self, x: Array, scores: Scores, rows: Rows, step: Array, factor: Array
    ) -> tuple[Array, Scores | None]:
        new_x = self.model.within(x[rows] + factor[:, None] * step, x[rows])
        with suppress(Declined, ToleranceError):  # a wavefront that is too strong to be computed counts as no gain
            return new_x, self.model.scores(new_x, fast=self.fast, rows=rows)
        return new_x, None

    def take(self, x: Array, step: Array, rows: Rows, converged: NDArray[np.bool_]) -> None:
        """Add the last steps to converged sets, in place, without updating their scores."""
        x[rows[converged]] = self.model.within(x[rows[converged]] + step[converged], x[rows[converged]])


def search_rows(
    model: RowModel, x: Array, max_steps: int, report: Report, *, fast: bool
) -> tuple[Array, Scores, NDArray[np.bool_], int]:
    """Take damped steps from starts `x` (s, p) until all have converged or one of them fits.

    Return parameters, their scores, a mask of the converged starts, and the number of steps of all starts. A `fast`
    search starts with the least-squares flux and background; its scores are those before the last step.
    """
    problem = _RowProblem(model, fast)
    values, derivatives = model.images(x, fast=fast)
    if fast:
        x = model.with_flux_background(x, values)
    scores = model.scores_of(x, values, derivatives)
    end: dict[str, Any] = {"settled_gain": _CONVERGED_FAST, "last": problem.take} if fast else {}
    return fisher_scoring(problem, x, scores, max_steps, report, **end)


def reduced_chi2(square: Any, total: Any, variance: Any, fraction: Any) -> tuple[Any, Any]:
    """Return chi2 per degree of freedom and its standard deviation for a correct model.

    `square` is the sum of squared residuals, `total` its expectation for known parameters, and `variance` the
    variance of `square`. `fraction` is (degrees of freedom) / (number of pixels), by which the fit reduces the
    expectation. An expectation below 1, for images below 0, is replaced by 1: any residual is then a misfit.
    """
    expected = np.maximum(total * fraction, 1.0)
    return square / expected, np.sqrt(variance * fraction) / expected


def flux_background(psf: Array, counted: Array, read: Array, valid: Array) -> tuple[Array, Array]:
    """Return the weighted least-squares flux (at least 1) and background, electrons, shape (...,).

    `psf`, the counts `counted` (electrons), the read variance `read` and `valid` have the shape (..., pixels). The
    weight of a valid pixel is the inverse of its estimated variance, 1 / (counted + read + 1).
    """
    # The summand 1 limits the weight of dark pixels.
    flux, mean_counted, mean_psf = weighted_light(psf, counted, valid / (np.maximum(counted, 0.0) + read + 1.0))
    flux = np.maximum(flux, 1.0)
    return flux, mean_counted - flux * mean_psf


def weighted_light(psf: Array, counted: Array, weight: Array) -> tuple[Array, Array, Array]:
    """Return the weighted least-squares flux, and the weighted means of counts and of the PSF, shape (...,) each.

    The background is (mean of the counts) - flux (mean of the PSF). Arguments have the shape (..., pixels).
    """
    total, data = weight.sum(axis=-1), weight * counted
    mean_psf, mean_counted = (weight * psf).sum(axis=-1) / total, data.sum(axis=-1) / total
    # Sums about the weighted means separate the flux from the background.
    square = (weight * psf * psf).sum(axis=-1) - total * mean_psf * mean_psf
    flux = ((data * psf).sum(axis=-1) - total * mean_psf * mean_counted) / np.maximum(square, 1e-300)
    return flux, mean_counted, mean_psf


def damped_steps(scores: Scores, damping: Array) -> tuple[Array, Array]:
    """Return Levenberg-Marquardt steps (s, p), and the decrease (s,) of the deviance predicted to first order."""
    scale = information_roots(scores.information)
    matrix = scores.information / (scale[:, :, None] * scale[:, None, :])
    diagonal = np.arange(scale.shape[1])
    # Damping is relative to the diagonal, and so independent of the units of parameters.
    matrix[:, diagonal, diagonal] += damping[:, None]
    step = np.linalg.solve(matrix, (scores.slope / scale)[..., None])[..., 0] / scale
    # Slope times step is the gain to first order: twice the gain of an undamped step in a quadratic function.
    return step, np.einsum("si,si->s", step, scores.slope)


def covariance(information: Array) -> Array:
    """Return the inverse (p, p) of an information matrix, with infinite variances for undetermined parameters."""
    scale = information_roots(information[None])[0]
    scaled = information / np.outer(scale, scale)
    # For more than 25 parameters, eigenvectors take ten times as long as the inverse, and use all threads of BLAS.
    with suppress(np.linalg.LinAlgError):
        inverse = np.linalg.inv(scaled)
        if np.linalg.norm(inverse) < 1e8:  # no eigenvalue of `scaled` is below 1e-8
            return np.asarray(0.5 * (inverse + inverse.T) / np.outer(scale, scale))
    values, vectors = np.linalg.eigh(scaled)
    # Derivatives have errors of 1e-6 of the peak: an eigenvalue of 0 may be computed as 1e-10.
    undetermined = values < 1e-10
    affected = (np.abs(vectors[:, undetermined]) > 1e-3).any(axis=1)
    values = np.where(undetermined, np.inf, values)
    inverse = (vectors / values) @ vectors.T / np.outer(scale, scale)
    inverse[affected] = inverse[:, affected] = 0.0
    inverse[affected, affected] = np.inf
    return np.asarray(inverse)


def information_roots(information: Array) -> Array:
    """Return the square roots (s, p) of the diagonal of information (s, p, p), or 1 where it is 0."""
    diagonal = information.diagonal(axis1=1, axis2=2)
    return np.asarray(np.sqrt(np.where(diagonal > 0.0, diagonal, 1.0)))
