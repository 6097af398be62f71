"""Score tests (Rao): what a model does not have, and how likely the data make it.

Of unknowns t and a candidate c, with information I and slope U of the log-likelihood at the answer, the part of the
candidate that no unknown takes up is ``S = I_cc - I_ct I_tt^-1 I_tc``, ``V = U_c - I_ct I_tt^-1 U_t``. The candidate
has then the size ``S^-1 V`` with the covariance ``S^-1`` (C. R. Rao, doi:10.1017/S0305004100023987), and the Bayes
factor for a size of N(0, tau^2) against N(0, sigma^2), sigma being what is known of it beforehand, is that of these
two normal distributions widened by the covariance: a candidate that could be anything pays for it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy import special

from lommel.base.arrays import Array
from lommel.base.units import with_error
from lommel.fit.findings import Finding
from lommel.fit.scoring import covariance

SEEN = 3.0  # log of the Bayes factor of a seen candidate, besides that of the number of candidates
RIVAL = 5.0  # difference of logs of Bayes factors within which candidates explain the data as well
_EXPLAINED = 0.5  # of chi2's excess over its expectation
_BLIND = 1e-9  # of the information of a candidate: less is rounding


@dataclass(frozen=True)
class Candidate:
    """What a model may lack.

    `columns` are its places in information and slope, `scale` the size (tau) that it may have. Of an unknown with a
    prior, `known` is the standard deviation of that prior, which information and slope hold, and `offset` how far the
    answer is from its middle, of each column.
    """

    name: str
    columns: tuple[int, ...]
    scale: float
    known: float = 0.0
    offset: float | Array = 0.0

    def widened(self, information: Array, slope: Array) -> tuple[Array, Array]:
        """Return information and slope with a prior of the standard deviation `scale` in place of the known one."""
        at, less = list(self.columns), self.known**-2 - self.scale**-2
        information, slope = information.copy(), slope.copy()
        # Information on an unknown with a prior holds 1 / known^2.
        information[at, at] -= less
        slope[at] += less * np.asarray(self.offset)
        return information, slope


@dataclass(frozen=True)
class ScoreTest:
    """The result of a score test.

    Attributes
    ----------
    name : str
        Of the candidate.
    size, errors : ndarray, shape (q,)
        What the data alone want, one step of Fisher scoring from the answer, and the standard errors.
    sigmas : float
        Distance from what was stated, in standard deviations of both; of several columns of that chance.
    log_bayes : float
        Natural logarithm of the Bayes factor for the candidate.
    """

    name: str
    size: Array
    errors: Array
    sigmas: float
    log_bayes: float

    def __str__(self) -> str:
        """Return such as "sample: 0.057 +- 0.004 (14 sigma, ln B 95)"."""
        each = ", ".join(" +- ".join(pair) for pair in map(with_error, self.size, self.errors))
        return f"{self.name}: {each} ({abs(self.sigmas):.2g} sigma, ln B {self.log_bayes:.3g})"


def score_tests(
    information: Array, slope: Array, unknowns: Sequence[int], candidates: Sequence[Candidate]
) -> tuple[ScoreTest, ...]:
    """Return the tests of candidates, the most likely first; those of which the data say nothing are left out.

    `information` (p, p) and `slope` (p,) are of the log-likelihood at its maximum, with priors; `unknowns` are the
    columns that the fit estimates.
    """
    found = []
    free = [one for one in candidates if not {*one.columns} & {*unknowns}]
    together = [j for one in free for j in one.columns]
    # All candidates that are not estimated share one elimination.
    squares, slopes = _eliminated(information, slope, unknowns, together)
    first = 0
    for one in candidates:
        at, scale = list(one.columns), np.maximum(np.diag(information)[list(one.columns)], 1e-300)
        if one in free:  # what is not estimated is beside the same unknowns
            own = slice(first, first + len(at))
            square, pull = squares[own, own], slopes[own]
            first += len(at)
        else:
            square, pull = _eliminated(information, slope, [j for j in unknowns if j not in at], at)
        if one.known:  # what the prior says is not what the data say
            square = square - np.eye(len(at)) / one.known**2
            pull = pull + one.offset / one.known**2
        # Of columns that the data do not tell apart, as of one star how blur varies over the field, rounding is left.
        if np.linalg.eigvalsh(square / np.sqrt(np.outer(scale, scale)))[0] <= _BLIND:
            continue
        spread = np.asarray(np.linalg.inv(square))
        size = spread @ pull + one.offset
        # Prior and data are independent: variances add.
        near = spread + np.eye(len(at)) * one.known**2
        away = float(size @ np.linalg.solve(near, size))
        sigmas = math.copysign(math.sqrt(away), size[0]) if len(at) == 1 else sigmas_of(away, len(at))
        evidence = log_bayes_factor(size, spread, one.known, one.scale)
        found.append(ScoreTest(one.name, size, np.sqrt(np.diag(spread)), sigmas, evidence))
    return tuple(sorted(found, key=lambda test: -test.log_bayes))


class Marginal(NamedTuple):
    """Steps of unknowns (u,) and their covariance (u, u), where what a model lacks is unknown within its scale."""

    shift: Array
    covariance: Array


def marginalized(
    information: Array, slope: Array, unknowns: Sequence[int], lacking: Sequence[Candidate], count: int
) -> Marginal:
    """Return the steps and the covariance of the first `count` unknowns, which allow for what the model lacks."""
    free = [*unknowns, *(column for one in lacking for column in one.columns)]
    # A normal prior of mean 0 for what the model lacks.
    known = [0.0] * len(unknowns) + [one.scale**-2 for one in lacking for _ in one.columns]
    wide = covariance(information[np.ix_(free, free)] + np.diag(known))[:count]
    determined = np.isfinite(np.diag(wide))
    shift = np.where(determined, np.where(determined[:, None], wide, 0.0) @ slope[free], 0.0)
    return Marginal(shift, wide[:, :count])


def untested(
    information: Array,
    unknowns: Sequence[int],
    shown: Mapping[str, int],
    stated: Sequence[Candidate],
    tests: Sequence[ScoreTest],
) -> dict[str, tuple[str, float]]:
    """Return the stated numbers that the data do not test within their scales.

    For each of these the unknown that such an error changes most, and by how much. `shown` has the places of unknowns
    among `unknowns`; changes below a standard error are left out.
    """
    rest, found = list(unknowns), {}
    square = information[np.ix_(rest, rest)]
    errors = np.sqrt(np.diag(covariance(square)))
    for one in stated:
        error = next((float(test.errors[0]) for test in tests if test.name == one.name), math.inf)
        if error <= one.scale or not shown:
            continue
        changes = np.abs(one.scale * _solved(square, information[np.ix_(rest, one.columns)])[:, 0])
        name = max(shown, key=lambda name: changes[shown[name]] / errors[shown[name]])
        if changes[shown[name]] > errors[shown[name]]:
            found[one.name] = name, float(changes[shown[name]])
    return found


def untested_findings(
    changes: Mapping[str, tuple[str, float]],
    sizes: Mapping[str, str],
    priors: Sequence[str] = (),
    never: Sequence[str] = (),
) -> list[Finding]:
    """Return the finding of stated numbers that the data do not test.

    `changes` is by :func:`untested`, `sizes` are of its errors, in words; `priors` are unknowns of which these say
    more than the data, and `never` what no data test.
    """
    each = [f"{name} ({sizes[name]} changes {term} by {by:.2g} rad)" for name, (term, by) in changes.items()]
    if priors:
        each.append(f"{', '.join(priors)} ({'known by their priors' if len(priors) > 1 else 'known by its prior'})")
    numbers: dict[str, dict[str, float]] = {name: {term: by} for name, (term, by) in changes.items()}
    numbers |= {name: {} for name in (*priors, *never)}
    text = f"not tested: {', '.join((*each, *never))}"
    return [Finding("untested", "note", text, numbers)] if numbers else []


def _eliminated(information: Array, slope: Array, unknowns: Sequence[int], at: Sequence[int]) -> tuple[Array, Array]:
    """Return information and slope of columns with the unknowns eliminated (Schur's complement)."""
    rest = list(unknowns)
    mixed = information[np.ix_(rest, at)]
    carried = _solved(information[np.ix_(rest, rest)], mixed)
    return information[np.ix_(at, at)] - mixed.T @ carried, slope[list(at)] - carried.T @ slope[rest]


def log_bayes_factor(size: Array, covariance: Array, known: float, scale: float) -> float:
    """Return the log of the Bayes factor of a size (q,), N(0, scale^2) against N(0, known^2)."""
    found = 0.0
    # Twice minus the logarithm of a normal density, but for its constant: distance squared plus log determinant.
    for width, sign in ((known, 0.5), (max(scale, known), -0.5)):
        each = covariance + np.eye(len(size)) * width**2
        found += sign * (float(size @ np.linalg.solve(each, size)) + float(np.linalg.slogdet(each)[1]))
    return found


def favoured(tests: Sequence[ScoreTest]) -> set[str]:
    """Return the names of candidates with Bayes factors above 1, beyond chance or not."""
    return {test.name for test in tests if test.log_bayes > 0.0}


def seen(tests: Sequence[ScoreTest]) -> tuple[ScoreTest, ...]:
    """Return the best candidate, if it is beyond chance, and its rivals."""
    # The best of n candidates is larger by ln n by chance.
    if not tests or tests[0].log_bayes <= SEEN + math.log(len(tests)):
        return ()
    return tuple(test for test in tests if test.log_bayes >= max(tests[0].log_bayes - RIVAL, 0.0))


def causes_of_misfit(causes: str, chi2: float, spread: float, tests: Sequence[ScoreTest]) -> str:
    """Return causes in words, or "" where what the data favour explains more than half of the excess of chi2."""
    # The standard deviation of chi2 over n degrees of freedom is sqrt(2 / n): n = 2 / spread^2.
    excess = (chi2 - 1.0) * 2.0 / max(spread, 1e-9) ** 2  # over all degrees of freedom
    return "" if any(test.sigmas**2 > _EXPLAINED * excess for test in seen(tests)) else causes


def other_explanation(rivals: Sequence[ScoreTest], words: Sequence[str]) -> Finding:
    """Return the finding on seen candidates, each in words."""
    first, *others = words
    text = f"the data favour {first}"
    if others:
        text += f", or as well {' or '.join(others[:3])}, which they cannot tell apart"
    keys = ("size", "errors", "sigmas", "log_bayes")
    numbers = {one.name: {key: getattr(one, key) for key in keys} for one in rivals}
    return Finding("other_explanation", "doubt", text, numbers)


def _solved(square: Array, right: Array) -> Array:
    """Return the solution of equations scaled to a diagonal of 1."""
    scale = 1.0 / np.sqrt(np.maximum(np.diag(square), 1e-300))
    alike = square * np.outer(scale, scale) + 1e-12 * np.eye(len(scale))
    return np.asarray(scale[:, None] * np.linalg.solve(alike, scale[:, None] * right))


def sigmas_of(square: float, count: int) -> float:
    """Return the standard deviations that are as rare for one normal number as a sum of `count` squares is."""
    chance = special.gammaincc(0.5 * count, 0.5 * square)
    return float(-special.ndtri(0.5 * chance)) if chance > 1e-300 else math.sqrt(square)
