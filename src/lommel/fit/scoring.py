"""Fisher scoring: damped steps (Levenberg and Marquardt) to the parameters of maximum likelihood.

Steps are by Fisher's information, whose inverse at the end is the covariance. A model states its images and their
derivatives (:class:`RowModel`); one whose parameters are no rows of numbers states its steps (:class:`Problem`).
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Array
from lommel.core.answers import Declined, ToleranceError
from lommel.fit import goodness_of_fit

_SETTLED = 1e-2  # squared length of a step, in standard errors, below which it is not taken
_NEARLY = 1.0  # the same for a fast search, whose last step is taken
_SWINGS = 0.5  # damping of steps that swing
_LONGEST = 2.0  # radians rms: largest change of the wavefront in a step
_FIRST, _LEAST, _MOST = 1e-2, 1e-6, 1e8  # damping: first, least, and where a search gives up
_STRETCH = 16.0  # largest factor of a step's length
_STALLED = 1e-4  # of the excess deviance: steps that gain less lead to a local minimum that does not fit
_PATIENCE = 3  # number of such steps in a row that ends a search

Report = Callable[[int, float], object]
"""Called with the number of a step and the best chi2 before it."""


class Scores(NamedTuple):
    """Quality of the fit for several sets of parameters.

    `deviance` (s,) is minus the log-likelihood, `slope` (s, p) minus its gradient, `information` (s, p, p) Fisher's;
    `chi2` (s,) is Pearson's over its expectation, and `spread` (s,) its standard deviation where the model is right.
    """

    deviance: Array
    slope: Array
    information: Array
    chi2: Array
    spread: Array


class RowModel(Protocol):
    """A model of images whose parameters are rows of numbers."""

    size: int
    tested: int  # pixels less parameters, of a row
    alternatives: bool  # whether rows are starts for the same images, of which the first that fits ends the search

    def images(self, x: Array, *, fast: bool = False) -> tuple[Any, Any]:
        """Return the PSFs of images, and their derivatives."""

    def scores(self, x: Array, *, fast: bool = False, rows: NDArray[np.intp] | None = None) -> Scores:
        """Return the quality of the fit for parameters `x`, which stand in these rows of the search."""
        return self.scores_of(x, *self.images(x, fast=fast))

    def scores_of(self, x: Array, values: Any, slopes: Any) -> Scores:
        """Return the same from images and derivatives."""

    def with_flux_background(self, x: Array, values: Any) -> Array:
        """Return the parameters with flux and background from least squares; as they are where these are given."""
        return x

    def within(self, x: Array, before: Array) -> Array:
        """Limit parameters in place."""

    def rms(self, steps: Array) -> Array:
        """Return the rms phase of steps; 0 where none changes a wavefront."""
        return np.zeros(len(steps))

    def steps(self, scores: Scores, damping: Array) -> tuple[Array, Array]:
        """Return damped steps and the gain in deviance that their slopes promise."""
        return damped_steps(scores, damping)


Rows = NDArray[np.intp]


class Problem(Protocol):
    """What a search asks: `x` are several sets of parameters, `now` their scores, `at` those that move.

    Sets are the rows of an array, or `x` is a single one of any type.
    """

    tested: int
    alternatives: bool  # whether the first set that fits ends the search

    def step(self, x: Any, now: Scores, at: Rows, damping: Array) -> tuple[Array, Array]:
        """Return damped steps and the gain in deviance that they promise."""

    @property
    def rms(self) -> Callable[[Array], Array] | None:
        """The rms phase of steps, radians; None where steps do not stretch."""

    def attempt(self, x: Any, now: Scores, at: Rows, step: Array, factor: Array) -> tuple[Any, Scores | None]:
        """Return parameters after steps times `factor` and their scores; None if these cannot be computed."""


@dataclass(frozen=True)
class Policy:
    """Rules for the course of a search.

    `settled` is the squared length of a step, in standard errors, that is not worth taking; a search gives up at a
    damping above `most`. A search of infinite `patience` goes on in a minimum that does not fit.
    """

    settled: float = _SETTLED
    most: float = _MOST
    patience: float = _PATIENCE


class Ascent(NamedTuple):
    """The end of a search: parameters, their scores, which have settled, how many steps were tried."""

    x: Any
    now: Scores
    settled: NDArray[np.bool_]
    steps: int


def fisher_scoring(
    problem: Problem,
    x: Any,
    now: Scores,
    most: int,
    report: Report,
    policy: Policy,
    last: Callable[[Any, Array, Rows, NDArray[np.bool_]], object] | None = None,
) -> Ascent:
    """Take at most so many damped steps from parameters `x`, worth `now`, until they settle or one is enough.

    `last` gets the steps of those that have settled, which are not taken.
    """
    count = len(now.chi2)
    damping, stretch = np.full(count, _FIRST), np.ones(count)
    settled, moving = np.zeros(count, dtype=bool), np.ones(count, dtype=bool)
    taken, stalled = 0, np.zeros(count, dtype=int)
    for turn in range(most + 1):
        report(turn, float(now.chi2.min()))
        at = np.flatnonzero(moving)
        step, promised = problem.step(x, now, at, damping[at])
        done = (promised < policy.settled) & (damping[at] <= 1.0)
        settled[at] = done
        moving[at] = ~done & (damping[at] <= policy.most) & (stalled[at] < policy.patience)
        fits = done & (now.chi2[at] < goodness_of_fit.most(now.spread[at], goodness_of_fit.SURE))
        if turn == most or not moving.any() or (problem.alternatives and fits.any()):
            if last is not None and done.any():
                last(x, step, at, done)
            break
        go = moving[at]
        at, promised, step = at[go], promised[go], step[go]
        factor = np.ones(at.size)
        if problem.rms is not None:
            factor = np.minimum(stretch[at], _LONGEST / np.maximum(problem.rms(step), 1e-300))
        tried, new = problem.attempt(x, now, at, step, factor)
        taken += at.size
        gain = np.full(at.size, -np.inf) if new is None else now.deviance[at] - new.deviance
        promised = promised * factor
        better, stretched = gain > 0.0, stretch[at] > 1.0
        damping[at] *= np.where(better, 0.1, np.where(stretched, 1.0, 6.0))
        if problem.rms is not None:
            # Steps grow where the last one gained nearly all that its slope promised: far from the answer the
            # information overstates the curvature of the likelihood.
            straight, bent = gain > 0.65 * promised, gain < 0.3 * promised
            longer = np.minimum(2.0 * np.maximum(factor, 1.0), _STRETCH)
            stretch[at] = np.where(straight, longer, np.where(bent, 1.0, stretch[at]))
            # Near the end, steps that gain little of what they promise go to and fro beside the answer.
            swings = better & (promised < 1.0) & (gain < 0.25 * promised)
            damping[at[swings]] = np.maximum(damping[at[swings]], _SWINGS)
        np.maximum(damping, _LEAST, out=damping)
        excess = now.chi2[at] - goodness_of_fit.most(now.spread[at])
        slow = better & (gain < _STALLED * problem.tested * excess)
        stalled[at] = np.where(slow, stalled[at] + 1, np.where(better, 0, stalled[at]))
        if new is None or not better.any():
            continue
        if better.all() and at.size == count:
            x, now = tried, new
            continue
        x[at[better]] = tried[better]
        for mine, theirs in zip(now, new, strict=True):
            mine[at[better]] = theirs[better]
    return Ascent(x, now, settled, taken)


class _RowProblem:
    """The problem of a model of rows; a `fast` one computes images only as exactly as a search needs."""

    def __init__(self, model: RowModel, fast: bool) -> None:
        self.model, self.fast, self.rms = model, fast, model.rms
        self.tested, self.alternatives = model.tested, model.alternatives

    def step(self, x: Array, now: Scores, at: Rows, damping: Array) -> tuple[Array, Array]:
        there = now if at.size == len(x) else Scores(*(part[at] for part in now))
        step, promised = self.model.steps(there, damping)
        # What is at a limit, such as the place of a star that its window does not show, is at its best there.
        allowed = self.model.within(x[at] + step, x[at]) - x[at]
        # Not below 0: a promise is an increase.
        return step, np.minimum(promised, np.maximum((allowed * there.slope).sum(axis=1), 0.0))

    def attempt(self, x: Array, now: Scores, at: Rows, step: Array, factor: Array) -> tuple[Array, Scores | None]:
        tried = self.model.within(x[at] + factor[:, None] * step, x[at])
        with suppress(Declined, ToleranceError):  # wavefronts too strong to be computed are no better
            return tried, self.model.scores(tried, fast=self.fast, rows=at)
        return tried, None

    def take(self, x: Array, step: Array, at: Rows, done: NDArray[np.bool_]) -> None:
        """Take steps of rows that are done, in place; their scores stay."""
        x[at[done]] = self.model.within(x[at[done]] + step[done], x[at[done]])


def search_rows(
    model: RowModel, x: Array, most: int, report: Report, *, fast: bool
) -> tuple[Array, Scores, NDArray[np.bool_], int]:
    """Take damped steps from starts `x` (s, p) until they settle or one fits.

    Return the ends, their scores, whether they settled, and the number of all steps. A `fast` search begins with the
    flux and background of least squares, and takes its last step, which it does not score.
    """
    problem = _RowProblem(model, fast)
    values, slopes = model.images(x, fast=fast)
    if fast:
        x = model.with_flux_background(x, values)
    policy = Policy(settled=_NEARLY if fast else _SETTLED)
    now = model.scores_of(x, values, slopes)
    return fisher_scoring(problem, x, now, most, report, policy, problem.take if fast else None)


def reduced_chi2(square: Any, total: Any, spread: Any, share: Any) -> tuple[Any, Any]:
    """Return chi2 per degree of freedom and its standard deviation, of sums of squares, expectations and variances.

    Beside parameters a `share` of the pixels is left. Where less than 1 is expected (images below 0), any square is a
    misfit.
    """
    expected = np.maximum(total * share, 1.0)
    return square / expected, np.sqrt(spread * share) / expected


def flux_background(psf: Array, counted: Array, read: Array, valid: Array) -> tuple[Array, Array]:
    """Return flux (at least 1) and background (...,) of weighted least squares, of PSFs and pixels (..., pixels).

    Weights are those of the counts themselves: 1 / (counted + read + 1) of valid pixels.
    """
    # 1 electron more keeps dark pixels from an infinite weight.
    flux, level, middle = weighted_light(psf, counted, valid / (np.maximum(counted, 0.0) + read + 1.0))
    flux = np.maximum(flux, 1.0)
    return flux, level - flux * middle


def weighted_light(psf: Array, counted: Array, weight: Array) -> tuple[Array, Array, Array]:
    """Return the flux of least squares, and the weighted means of counts and PSF, (...,) each.

    The background of a flux is the mean of the counts less flux times that of the PSF.
    """
    total, data = weight.sum(axis=-1), weight * counted
    middle, level = (weight * psf).sum(axis=-1) / total, data.sum(axis=-1) / total
    # Sums about the weighted mean: flux and background are uncorrelated.
    square = (weight * psf * psf).sum(axis=-1) - total * middle * middle
    return ((data * psf).sum(axis=-1) - total * middle * level) / np.maximum(square, 1e-300), level, middle


def damped_steps(scores: Scores, damping: Array) -> tuple[Array, Array]:
    """Return steps of Levenberg and Marquardt (s, p), and the gain in deviance that their slopes promise."""
    scale = information_roots(scores.information)
    matrix = scores.information / (scale[:, :, None] * scale[:, None, :])
    diagonal = np.arange(scale.shape[1])
    # Relative to the diagonal: damping does not depend on the units of parameters.
    matrix[:, diagonal, diagonal] += damping[:, None]
    step = np.linalg.solve(matrix, (scores.slope / scale)[..., None])[..., 0] / scale
    # Slope times step: to first order, and twice the gain of a full step in a quadratic function.
    return step, np.einsum("si,si->s", step, scores.slope)


def covariance(information: Array) -> Array:
    """Return the inverse (p, p) of an information matrix, with infinite variances for undetermined parameters."""
    scale = information_roots(information[None])[0]
    alike = information / np.outer(scale, scale)
    # Eigenvectors of more than 25 parameters take ten times as long as the inverse, and all threads of BLAS.
    with suppress(np.linalg.LinAlgError):
        found = np.linalg.inv(alike)
        if np.linalg.norm(found) < 1e8:  # so that no eigenvalue is below 1e-8
            return np.asarray(0.5 * (found + found.T) / np.outer(scale, scale))
    values, vectors = np.linalg.eigh(alike)
    # Derivatives in error by 1e-6 of the peak make of an eigenvalue 0 one as small as this.
    blind = values < 1e-10
    unknown = (np.abs(vectors[:, blind]) > 1e-3).any(axis=1)
    values = np.where(blind, np.inf, values)
    found = (vectors / values) @ vectors.T / np.outer(scale, scale)
    found[unknown] = found[:, unknown] = 0.0
    found[unknown, unknown] = np.inf
    return np.asarray(found)


def information_roots(information: Array) -> Array:
    """Return the square roots (s, p) of the diagonal of information (s, p, p), or 1 where it is 0."""
    diagonal = information.diagonal(axis1=1, axis2=2)
    return np.asarray(np.sqrt(np.where(diagonal > 0.0, diagonal, 1.0)))
