"""Score tests (Rao): effects that a model lacks, and the Bayes factors by which the data favour them.

A candidate is an effect with coefficients c that the model lacks, or one of its parameters with a prior. I is the
Fisher information and U the gradient of the log-likelihood at the estimate. Elimination of the estimated parameters t
gives ``S = I_cc - I_ct I_tt^-1 I_tc`` and ``V = U_c - I_ct I_tt^-1 U_t``. The estimate of c is ``S^-1 V``, with the
covariance ``S^-1`` (C. R. Rao, doi:10.1017/S0305004100023987).

The Bayes factor compares two priors of c: N(0, tau^2) if the effect is present, and N(0, sigma^2) in the model, where
sigma is 0 for effects that the model lacks. It is the ratio of the densities of ``S^-1 V`` under N(0, tau^2 + S^-1)
and N(0, sigma^2 + S^-1). A larger tau reduces the density at small estimates, and so the Bayes factor of weak
effects. If c cannot be negative, the prior is the positive half of N(0, tau^2), which multiplies the factor by
``2 Phi(m / s)``: m and s are mean and standard deviation of c given the data, and Phi is the normal distribution.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
import scipy

from lommel.base.arrays import Array
from lommel.base.units import with_error
from lommel.fit.findings import Finding, Severity, untested_finding
from lommel.fit.goodness_of_fit import largest_plausible_chi2, smallest_plausible_chi2
from lommel.fit.scoring import covariance

SEEN = 3.0  # a candidate is significant if the log of its Bayes factor exceeds SEEN + ln(number of candidates)
RIVAL = 5.0  # largest difference of log Bayes factors between candidates that explain the data equally well
# Difference between rival answers, standard errors, below which they agree, and above which a linear estimate fails.
CLOSED, _OPEN = 1.0, 3.0
_EXPLAINED = 0.5  # fraction of (chi2 - 1) above which a candidate explains a misfit
_MIN_INFORMATION = 1e-9  # least eigenvalue of S, relative to the diagonal of I, that is not due to rounding


@dataclass(frozen=True)
class Candidate:
    """An effect that a model may lack, or an estimated parameter whose prior may be too narrow.

    `columns` are the indices of its coefficients in the information matrix, and `scale` is their prior standard
    deviation tau. For an estimated parameter, `known` is the standard deviation sigma of the prior that the
    information matrix and the slope include, and `offset` is the estimate minus the mean of this prior, for each
    column. A `positive` effect has one coefficient, which cannot be negative.
    """

    name: str
    columns: tuple[int, ...]
    scale: float
    known: float = 0.0
    offset: float | Array = 0.0
    positive: bool = False

    def widened(self, information: Array, slope: Array) -> tuple[Array, Array]:
        """Return information and slope after the prior's standard deviation changes from `known` to `scale`."""
        columns, difference = list(self.columns), self.known**-2 - self.scale**-2
        information, slope = information.copy(), slope.copy()
        # The information on a parameter with a prior includes 1 / known^2.
        information[columns, columns] -= difference
        slope[columns] += difference * np.asarray(self.offset)
        return information, slope


@dataclass(frozen=True)
class ScoreTest:
    """The result of a score test.

    Attributes
    ----------
    name : str
        Name of the candidate.
    size, errors : ndarray, shape (q,)
        Estimates of the q coefficients from the data alone (one step of Fisher scoring) minus the mean of the prior,
        and their standard errors.
    sigmas : float
        `size` in standard deviations of data and prior together; for q > 1, the deviation of a normal variable that
        is equally improbable.
    log_bayes : float
        Natural logarithm of the Bayes factor for the candidate.
    """

    name: str
    size: Array
    errors: Array
    sigmas: float
    log_bayes: float

    def __str__(self) -> str:
        """Return the result as text, for example "sample: 0.057 +- 0.004 (14 sigma, ln B 95)"."""
        estimates = ", ".join(" +- ".join(pair) for pair in map(with_error, self.size, self.errors))
        return f"{self.name}: {estimates} ({abs(self.sigmas):.2g} sigma, ln B {self.log_bayes:.3g})"


def score_tests(
    information: Array, slope: Array, unknowns: Sequence[int], candidates: Sequence[Candidate]
) -> tuple[ScoreTest, ...]:
    """Return the tests of candidates, sorted by decreasing Bayes factors.

    Candidates that the data do not determine, or that no prior restricts, are left out. `information` (p, p) and
    `slope` (p,) are the Fisher information and the gradient of the log-likelihood at its maximum, including priors;
    `unknowns` are the columns that the fit estimates.
    """
    estimated, candidates = {*unknowns}, [item for item in candidates if math.isfinite(item.known)]
    # All candidates that are not estimated share one elimination.
    eliminated_columns = [j for item in candidates if estimated.isdisjoint(item.columns) for j in item.columns]
    squares, gradients = _eliminated(information, slope, unknowns, eliminated_columns)
    # Candidates of equally many coefficients are tested together.
    groups, start = dict[int, list[tuple[Candidate, Array, Array]]](), 0
    for candidate in candidates:
        index, count = list(candidate.columns), len(candidate.columns)
        if estimated.isdisjoint(index):
            part = slice(start, start + count)
            square, gradient = squares[part, part], gradients[part]
            start += count
        else:
            square, gradient = _eliminated(information, slope, [j for j in unknowns if j not in index], index)
        groups.setdefault(count, []).append((candidate, square, gradient))
    tests = [test for group in groups.values() for test in _tested_together(information, *zip(*group, strict=True))]
    return tuple(sorted(tests, key=lambda test: -test.log_bayes))


def _tested_together(
    information: Array, candidates: Sequence[Candidate], squares: Sequence[Array], gradients: Sequence[Array]
) -> list[ScoreTest]:
    """Return the tests of candidates of q coefficients each, given S (q, q) and V (q,) of each."""
    diagonal = np.maximum(np.diag(information)[[list(candidate.columns) for candidate in candidates]], 1e-300)
    square, gradient, eye = np.stack(squares), np.stack(gradients), np.eye(diagonal.shape[1])
    known, scale = np.array([(candidate.known, candidate.scale) for candidate in candidates], dtype=np.float64).T
    offset = np.array([np.zeros(len(eye)) + candidate.offset for candidate in candidates])
    # Subtract the prior of an estimated parameter: the test is of the data alone.
    prior = np.where(known > 0.0, 1.0 / np.square(np.where(known > 0.0, known, 1.0)), 0.0)[:, None]
    square, gradient = square - prior[..., None] * eye, gradient + prior * offset
    # S is rounding error if the data do not determine c, such as blur that varies over the field, for one star.
    least = np.linalg.eigvalsh(square / np.sqrt(diagonal[:, :, None] * diagonal[:, None]))[:, 0]
    chosen = np.flatnonzero(least > _MIN_INFORMATION)
    known, scale, variance = known[chosen], scale[chosen], np.asarray(np.linalg.inv(square[chosen]), np.float64)
    size = (variance @ gradient[chosen, :, None])[..., 0] + offset[chosen]
    errors = np.sqrt(variance.diagonal(axis1=1, axis2=2))
    distances, log_bayes = _distances_and_factors(size, variance, known, scale)
    positive = np.array([candidates[k].positive for k in chosen.tolist()], dtype=bool)
    if positive.any():
        ratio = size[:, 0] / errors[:, 0] / np.sqrt(1.0 + (errors[:, 0] / scale) ** 2)
        log_bayes = log_bayes + positive * (math.log(2.0) + scipy.special.log_ndtr(ratio))
    if size.shape[1] == 1:
        sigmas = np.copysign(np.sqrt(distances), size[:, 0])
    else:
        sigmas = np.array([sigmas_of(distance, size.shape[1]) for distance in distances])
    names = [candidates[k].name for k in chosen.tolist()]
    return list(map(ScoreTest, names, size, errors, sigmas.tolist(), log_bayes.tolist()))


class Marginal(NamedTuple):
    """Changes of u estimates (u,) and their covariance (u, u), marginalized over effects that the model lacks.

    `gain` is the increase of the log-posterior that these changes and those of the effects predict.
    """

    shift: Array
    covariance: Array
    gain: float = 0.0


class Grade(NamedTuple):
    """Significance of effects that the data favour for u estimates, in standard errors.

    `move` is the largest change of an estimate if one of the rival effects is allowed for instead of ignored. `rest`
    is the largest difference between an answer that allows for one rival and `marginal`, which allows for all
    effects, and whose covariance contains these differences. `worst` is the index of the estimate of the largest
    `rest`. `left` is chi2 after the predicted gain, which is plausible between the `limits` of noise.
    """

    marginal: Marginal
    move: float
    rest: float
    worst: int
    left: float
    limits: tuple[float, float]

    @property
    def explained(self) -> bool:
        """Whether noise and the favoured effects explain chi2."""
        return self.limits[0] < self.left < self.limits[1]

    @property
    def severity(self) -> Severity:
        """The severity of a finding on the effects: how far they affect the estimates."""
        if not self.explained or self.rest > _OPEN:
            return "error"
        # A large correction by linear equations is not exact.
        return "doubt" if self.rest > CLOSED or self.move > _OPEN else "note"


def marginalized(
    information: Array, slope: Array, unknowns: Sequence[int], effects: Sequence[Candidate], count: int
) -> Marginal:
    """Return changes and covariance of the first `count` unknowns, marginalized over `effects` that the model lacks.

    Each effect has a normal prior of mean 0 and standard deviation `scale`.
    """
    columns = [*unknowns, *(column for effect in effects for column in effect.columns)]
    prior_information = [0.0] * len(unknowns) + [effect.scale**-2 for effect in effects for _ in effect.columns]
    matrix = covariance(information[np.ix_(columns, columns)] + np.diag(prior_information))
    determined = np.isfinite(np.diag(matrix))
    shift = np.where(determined & determined[:, None], matrix, 0.0) @ slope[columns]
    return Marginal(shift[:count], matrix[:count, :count], 0.5 * float(shift @ slope[columns]))


def graded(
    information: Array, slope: Array, unknowns: Sequence[int], effects: Sequence[Candidate], count: int,
    tests: Sequence[ScoreTest], quality: tuple[float, float],
) -> Grade:  # fmt: skip
    """Return the grade of the first `count` unknowns by the rival effects in `tests` (see `seen`).

    `effects` are those to marginalize, including all that the data favour. `quality` is chi2 per degree of freedom
    and its standard deviation.
    """
    chi2, spread = quality
    rivals = seen(tests)
    # The prior of an effect that is seen must not shrink it.
    sizes = {test.name: 2.0 * float(np.abs(test.size).max()) for test in tests if rivals and test.log_bayes > 0.0}
    wide = {e.name: replace(e, scale=max(e.scale, sizes.get(e.name, 0.0))) for e in effects}

    def allowing(names: Collection[str]) -> Marginal:
        chosen = [effect for name, effect in wide.items() if name in names or name not in sizes]
        return marginalized(information, slope, unknowns, chosen, count)

    none = allowing(())
    every = allowing(sizes) if sizes else none
    answers = [every, *(allowing((test.name,)) for test in rivals)]
    shifts = np.array([answer.shift for answer in answers])
    errors, differences = np.sqrt(np.diag(every.covariance)), shifts - every.shift
    move = np.abs(shifts[1:] - none.shift).max(axis=0, initial=0.0) / np.sqrt(np.diag(none.covariance))
    rest = np.abs(differences).max(axis=0) / errors
    # Mixture of the answers about the one that is reported, weighted by their Bayes factors.
    weights = np.exp([0.0, *(test.log_bayes - rivals[0].log_bayes for test in rivals)])
    parts = [answer.covariance + np.outer(d, d) for answer, d in zip(answers, differences, strict=True)]
    mixture = np.tensordot(weights / weights.sum(), parts, 1)
    is_open = np.flatnonzero(rest > CLOSED)
    mixture[is_open, is_open] += (0.5 * rest[is_open] * errors[is_open]) ** 2
    worst = int((rest if (rest > CLOSED).any() else move).argmax()) if count else 0
    left = chi2 - every.gain * spread**2  # noise has 2 / spread^2 degrees of freedom
    limits = float(smallest_plausible_chi2(spread)), float(largest_plausible_chi2(spread))
    rest_of_all, move_of_all = (float(part.max(initial=0.0)) for part in (rest, move))
    return Grade(every._replace(covariance=mixture), move_of_all, rest_of_all, worst, left, limits)


def untested(
    information: Array,
    unknowns: Sequence[int],
    reported: Mapping[str, int],
    stated: Sequence[Candidate],
    tests: Sequence[ScoreTest],
) -> dict[str, tuple[str, float]]:
    """Return the `stated` numbers that the data do not test: an error of `scale` biases a fit but cannot be detected.

    The value for each number is the estimate with the largest bias relative to its standard error, and this bias.
    Numbers are left out if no bias exceeds the standard error. `reported` maps the names of estimates that may be
    reported to their indices in `unknowns`.
    """
    estimated, biases = list(unknowns), {}
    square = information[np.ix_(estimated, estimated)]
    errors = np.sqrt(np.diag(covariance(square)))
    for number in stated:
        error = next((float(test.errors[0]) for test in tests if test.name == number.name), math.inf)
        if error <= number.scale or not reported:
            continue
        bias = np.abs(number.scale * _solved(square, information[np.ix_(estimated, number.columns)])[:, 0])
        name = max(reported, key=lambda name: bias[reported[name]] / errors[reported[name]])
        if bias[reported[name]] > errors[reported[name]]:
            biases[number.name] = name, float(bias[reported[name]])
    return biases


def untested_findings(
    changes: Mapping[str, tuple[str, float]],
    sizes: Mapping[str, str],
    priors: Sequence[str] = (),
    never: Sequence[str] = (),
) -> list[Finding]:
    """Return the finding on stated numbers that the data do not test.

    `changes` is the result of :func:`untested`, and `sizes` describes the error of each number in words. `priors` are
    parameters that their priors determine better than the data do; `never` are numbers that no data can test.
    """
    items = [f"{name} ({sizes[name]} changes {term} by {by:.2g} rad)" for name, (term, by) in changes.items()]
    if priors:
        items.append(f"{', '.join(priors)} ({'only by their priors' if len(priors) > 1 else 'only by its prior'})")
    numbers: dict[str, dict[str, float]] = {name: {term: by} for name, (term, by) in changes.items()}
    numbers |= {name: {} for name in (*priors, *never)}
    return [untested_finding([*items, *never], numbers, "not determined")] if numbers else []


def _eliminated(information: Array, slope: Array, unknowns: Sequence[int], c: Sequence[int]) -> tuple[Array, Array]:
    """Return S and V of the columns `c` after elimination of the `unknowns` (Schur complement)."""
    t = list(unknowns)
    cross = information[np.ix_(t, c)]
    solution = _solved(information[np.ix_(t, t)], cross)
    return information[np.ix_(c, c)] - cross.T @ solution, slope[list(c)] - solution.T @ slope[t]


def log_bayes_factor(size: Array, covariance: Array, known: float | Array, scale: float | Array) -> Any:
    """Return the log Bayes factor of N(0, scale^2) against N(0, known^2), for estimates (..., q) with a covariance.

    `covariance` has the shape (..., q, q); `known` and `scale` are numbers, or one for each estimate (...,).
    """
    return _distances_and_factors(size, covariance, known, scale)[1]


def _distances_and_factors(size: Array, covariance: Array, known: Any, scale: Any) -> tuple[Any, Any]:
    """Return squared distances from N(0, known^2), and the log Bayes factors of :func:`log_bayes_factor`."""
    # Prior and data are independent: their variances add.
    widths = np.square([known, np.maximum(scale, known)])[..., None, None]
    totals = covariance + np.eye(size.shape[-1]) * widths
    distances = (size * np.linalg.solve(totals, np.broadcast_to(size, totals.shape[:-1])[..., None])[..., 0]).sum(-1)
    # Without its constant, a normal log density is -(squared distance + log determinant) / 2.
    costs = 0.5 * (distances + np.linalg.slogdet(totals)[1])
    return distances[0], costs[0] - costs[1]


def favoured(tests: Sequence[ScoreTest]) -> set[str]:
    """Return the names of candidates with Bayes factors above 1, whether significant or not."""
    return {test.name for test in tests if test.log_bayes > 0.0}


def seen(tests: Sequence[ScoreTest]) -> tuple[ScoreTest, ...]:
    """Return the candidate of the largest Bayes factor, if significant, and candidates with factors near it."""
    # ln n corrects for n tests: the largest of n Bayes factors may be n times as large by chance.
    if not tests or tests[0].log_bayes <= SEEN + math.log(len(tests)):
        return ()
    return tuple(test for test in tests if test.log_bayes >= max(tests[0].log_bayes - RIVAL, 0.0))


def causes_of_misfit(causes: str, chi2: float, spread: float, tests: Sequence[ScoreTest]) -> str:
    """Return `causes` of a misfit, or "" if a significant candidate explains more than half of chi2 - 1."""
    # `chi2` is per degree of freedom. For n of them, its standard deviation is sqrt(2 / n): n = 2 / spread^2.
    excess = (chi2 - 1.0) * 2.0 / max(spread, 1e-9) ** 2  # of the sum of squares
    return "" if any(test.sigmas**2 > _EXPLAINED * excess for test in seen(tests)) else causes


def graded_explanation(
    rivals: Sequence[ScoreTest], words: Sequence[str], grade: Grade, names: Sequence[str]
) -> Finding:
    """Return the finding on significant candidates with its grade; `names` are those of the estimates."""
    finding, name, rest = other_explanation(rivals, words), names[grade.worst], grade.rest
    if not grade.explained:
        low, high = grade.limits
        text = f"allowing for it, chi2 is {grade.left:.3g}, not within the {low:.3g} to {high:.3g} of noise"
        if grade.left < 0.0:  # the model is not linear so far: no sum of squares is negative
            text = "the misfit is too large for a linear correction, and so for its size"
    elif rest > CLOSED:
        text = f"{name} remains open by {rest:.2g} standard errors" + ", which its error includes" * (rest <= _OPEN)
    else:
        text = f"estimates allow for it, and it moves {name} by {grade.move:.2g} standard errors"
        text += ", too far for a linear correction" * (grade.move > _OPEN)
    numbers = {**finding.numbers, "move": grade.move, "rest": rest, "left": grade.left}
    return replace(finding, severity=grade.severity, text=f"{finding.text}: {text}", numbers=numbers)


def other_explanation(rivals: Sequence[ScoreTest], words: Sequence[str]) -> Finding:
    """Return the finding on significant candidates (`rivals`); `words` describes each of them."""
    first, *alternatives = words
    text = f"the data favour {first}"
    if alternatives:
        text += f", or as well {' or '.join(alternatives[:3])}, which they cannot tell apart"
    keys = ("size", "errors", "sigmas", "log_bayes")
    numbers = {rival.name: {key: getattr(rival, key) for key in keys} for rival in rivals}
    return Finding("other_explanation", "doubt", text, numbers)


def _solved(square: Array, right_side: Array) -> Array:
    """Return the solution of linear equations, which are scaled to a diagonal of 1 to reduce rounding."""
    scale = 1.0 / np.sqrt(np.maximum(np.diag(square), 1e-300))
    scaled = square * np.outer(scale, scale) + 1e-12 * np.eye(len(scale))
    return np.asarray(scale[:, None] * np.linalg.solve(scaled, scale[:, None] * right_side))


def sigmas_of(square: float, count: int) -> float:
    """Return the deviation of a normal variable, in sigma, that is as improbable as a chi-squared of `square`.

    The chi-squared distribution has `count` degrees of freedom.
    """
    probability = scipy.special.gammaincc(0.5 * count, 0.5 * square)
    return float(-scipy.special.ndtri(0.5 * probability)) if probability > 1e-300 else math.sqrt(square)
