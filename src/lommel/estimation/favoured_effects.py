"""Effects that the images favour and a model lacks: refits estimate them besides what was asked for.

An estimator states its score tests, and how a candidate becomes a parameter of its model. Here are the rules: which
candidates are estimated, what a refit must gain, which effects are rivals, and what the result notes.
"""

from __future__ import annotations

import itertools
import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Generic, NamedTuple, Protocol, TypeVar

import numpy as np

from lommel.base.arrays import Array
from lommel.base.units import with_error
from lommel.core.answers import Declined, ToleranceError
from lommel.fit.findings import Finding, Severity
from lommel.fit.model_error import MAX_PHASE_ERROR, MIN_GAIN, ModelError, is_correlated, model_error
from lommel.fit.score_tests import CLOSED, RIVAL, ScoreTest, seen
from lommel.fit.scoring import RowModel, Scores

# Effects that are added, refits in turn, and candidates of which each refit is the best.
_MAX_EFFECTS, _MAX_ROUNDS, _MAX_CANDIDATES = 2, 5, 4
_MIN_GAIN = 0.5  # smallest gain of lnL, divided by the logarithm of the Bayes factor
# Refits are compared after further steps if they gain less than the best by this many times RIVAL, or by this part.
_NEAR, _NEAR_SHARE = 2.0, 0.1
_SAME_GAIN = 0.5  # difference of lnL up to which the first of two candidates is preferred
_SETTLED = 0.3  # distance of an estimated effect from its best value, standard errors, that needs no more refits
# Largest log Bayes factor of an effect that is compared with a model error, which takes about as long as a refit.
_CLEAR = 50.0
_NEARLY = 0.5  # part of this logarithm that the gain of a model error exceeds if it explains the images as well
_SAME = (
    2.0  # difference of a term between rivals, standard errors, up to which the answer is good: its error includes it
)
_MAX_ESTIMATES = 3  # largest number of estimates, or of rivals, in a message


class ModelOfImages(RowModel, Protocol):
    """A model of images with derivatives."""

    def columns(self, x: Array) -> Array:
        """Return the derivatives of electrons by the parameters `x` (1, p), shape (p, n, h, w)."""


M = TypeVar("M", bound=ModelOfImages)


@dataclass
class Fit(ABC, Generic[M]):
    """A fit: the model, the parameters `x` (1, p), their scores, and whether the search settled."""

    model: M
    x: Array
    scores: Scores
    settled: bool

    @property
    def deviance(self) -> float:
        """Minus the log-likelihood."""
        return float(self.scores.deviance[0])

    @property
    def quality(self) -> tuple[float, float]:
        """Chi2 and its standard deviation."""
        return float(self.scores.chi2[0]), float(self.scores.spread[0])

    @property
    @abstractmethod
    def residual_parts(self) -> tuple[Array, Array, Array]:
        """Residual (NaN where unknown), variance of noise, and light without background, each (n, h, w)."""

    @property
    def linear_range(self) -> float:
        """Phase, radians rms, within which images are linear."""
        return MAX_PHASE_ERROR

    @cached_property
    def model_error(self) -> ModelError | None:
        """The model error, whether significant or not; None if there are too few pixels."""
        residual, variance, light = self.residual_parts
        return model_error(residual, self.model.columns(self.x), variance, light)

    def valid_model_error(self, codes: Sequence[str], tests: Sequence[ScoreTest]) -> ModelError | None:
        """Return the model error, if no finding in `codes` explains it and standard errors can include it."""
        is_misfit = "misfit" in codes
        if not {"excess_noise", "gain", "hot_pixels", "too_quiet"}.isdisjoint(codes):
            return None
        if not is_misfit and (not is_correlated(*self.residual_parts) or self.stands_out(seen(tests))):
            return None
        error, (step,) = self.model_error, self.model.steps(self.scores, np.full(1, 1e-9))[0]
        return error if error is not None and error.holds(self.model.rms, step, self.linear_range) else None

    def stands_out(self, favoured: Sequence[ScoreTest]) -> bool:
        """Return whether the first of the effects explains the images far better than a model error."""
        least = _NEARLY * max(favoured[0].log_bayes, MIN_GAIN) if favoured else MIN_GAIN
        return self.model_error is None or self.model_error.gain < least


class Round(NamedTuple):
    """A fit with its checks, of which the score tests are the first, and the effects that it estimates besides.

    `rivals` explain the images as well as these effects; `others` are their refits instead of this one, as far as
    the model can estimate them. `tried` are the candidates of a further refit, the best first: each with its refit
    (None if the model cannot estimate it) and the gain of lnL.
    """

    fit: Any
    checks: Any
    names: tuple[str, ...] = ()
    rivals: tuple[str, ...] = ()
    tried: Sequence[tuple[ScoreTest, Any, float]] = ()
    others: Sequence[tuple[ScoreTest, Any, float]] = ()


def rounds_of(
    fit: Any,
    tested: Callable[[Any, Sequence[str], Sequence[str]], Any],
    refit: Callable[[Any, ScoreTest], tuple[Any, float] | None],
    favoured: Callable[[Sequence[ScoreTest]], Sequence[ScoreTest]] = seen,
    jointly: Callable[[Any, Sequence[str]], Any] | None = None,
    revised: Callable[[Any, ScoreTest, bool], Any] | None = None,
) -> list[Round]:
    """Return the round of a fit, and rounds in which refits estimate one more of the effects that the images favour.

    ``tested(fit, names, rivals)`` returns the checks of a fit that estimates effects `names`. ``refit(fit, test)``
    returns the fit that estimates the effect of `test`, and its gain of lnL. If rivals can be estimated together with
    the best effect, ``jointly(fit, names)`` does so, or returns None. Otherwise an effect is estimated only if it
    stands out: no model error explains the images nearly as well. ``revised(fit, test, compared)`` chooses anew what
    may have stood for the effect of `test` before it was estimated; the search settles if fits are `compared`.
    """
    rounds = [Round(fit, tested(fit, (), ()))]
    while len(rounds) <= _MAX_ROUNDS:
        (fit, checks, names, rivals, *_), others = rounds[-1], list[tuple[ScoreTest, Any, float]]()
        moved = [] if jointly else [t for t in checks[0] if t.name in names and abs(t.sigmas) > _SETTLED]
        is_last = len({one.names for one in rounds}) > _MAX_EFFECTS
        candidates = moved[:1] or (() if is_last else favoured(checks[0])[:_MAX_CANDIDATES])
        if not candidates:
            break
        if not (names or jointly or candidates[0].log_bayes > _CLEAR or fit.stands_out(candidates)):
            break
        tried = [(test, *_attempt(refit, fit, test)) for test in candidates]
        if jointly is not None:
            tried.sort(key=lambda one: -one[2])
            added = tuple(test.name for test, _, gain in tried if gain >= tried[0][2] - RIVAL)
            rounds[-1] = rounds[-1]._replace(tried=tried[: len(added)])
            if (new := jointly(fit, added)) is None:
                break
        else:
            good = [one for one in tried if one[1] and one[2] > max(_MIN_GAIN * one[0].log_bayes, 0.0)]
            if tried[0][1] is None or not good:  # another effect explains the images at least as well
                break
            if revised is not None and not moved:
                good = _contenders(good, revised)
            best = max(gain for *_, gain in good)
            test, new, _ = next(one for one in good if one[2] > best - _SAME_GAIN)
            added = (test.name,) if test.name not in names else ()
            others = [one for one in good if one[0] is not test and one[2] >= best - RIVAL]
            gains = {one[0].name: one[2] for one in (*tried, *good) if one[1]}
            shown = [one.name for one in seen(checks[0])]
            rivals = (*rivals, *(name for name in shown if not -math.inf < gains.get(name, math.inf) < best - RIVAL))
            rivals = tuple(dict.fromkeys(rivals))
        names += added
        rivals = tuple(name for name in rivals if name not in names)
        rounds.append(Round(new, tested(new, names, rivals), names, rivals, others=others))
    return rounds


def _contenders(
    good: Sequence[tuple[ScoreTest, Any, float]], revised: Callable[[Any, ScoreTest, bool], Any]
) -> list[tuple[ScoreTest, Any, float]]:
    """Return the refits that may be the best, revised, with their gains."""
    best, found = max(gain for *_, gain in good), list[tuple[ScoreTest, Any, float]]()
    near = [one for one in good if one[2] > best - max(_NEAR * RIVAL, _NEAR_SHARE * best)]
    for test, fit, gain in near:
        new = revised(fit, test, len(near) > 1)
        found.append((test, new, gain + fit.deviance - new.deviance))
    return found


def opened(change: Array, errors: Array) -> Array:
    """Return what is added to variances, such that errors contain changes that exceed them; 0 for smaller changes."""
    return np.where(np.abs(change) > CLOSED * errors, np.square(change), 0.0)


def unsure(rounds: Sequence[Round]) -> set[str]:
    """Return the estimated effects that have a rival: another effect explains the images as well without them."""
    last, found = rounds[-1], set[str]()
    for before, one in itertools.pairwise(rounds):
        if {*one.rivals} & {*last.rivals} - {*before.rivals}:
            found |= {*one.names} - {*before.names}
    return found


def _attempt(refit: Callable[..., tuple[Any, float] | None], fit: Any, test: ScoreTest) -> tuple[Any, float]:
    """Return the refit with an effect (None if the model has no such parameter) and its gain, -inf if it fails."""
    with suppress(Declined, ToleranceError):
        return refit(fit, test) or (None, test.log_bayes)
    return fit, -math.inf


class Estimate(NamedTuple):
    """An effect that was estimated besides: value, standard error, and the value in the model without it.

    Messages show them multiplied by `factor`, in `unit`. If the effect is `unsure`, the images may show another one
    instead, and the value may be the stated one.
    """

    name: str
    value: float
    error: float
    stated: float
    unit: str = ""
    factor: float = 1.0
    unsure: bool = False

    def __str__(self) -> str:
        """Return the estimate as text, for example "f_number 10.3 +- 0.01 (stated 10)"."""
        numbers = " +- ".join(with_error(self.factor * self.value, self.factor * self.error))
        note = f"stated {self.factor * self.stated:.6g}" + ", with this pixel and wavelength" * (
            self.name == "f_number"
        )
        return f"{self.name} {numbers} {self.unit.strip()}".rstrip() + f" ({note})"

    @property
    def numbers(self) -> dict[str, float]:
        """Value, a standard error that contains the stated value if the effect is unsure, and the stated value."""
        return {"value": self.value, "error": self.whole_error, "stated": self.stated}

    @property
    def whole_error(self) -> float:
        """The standard error, which contains the stated value if the effect is unsure."""
        change = float(opened(np.array(self.value - self.stated), np.array(self.error))) if self.unsure else 0.0
        return math.sqrt(self.error**2 + change)


def estimated_findings(
    estimates: Sequence[Estimate], moves: Mapping[str, float], rivals: Sequence[str] = (),
    others: Sequence[Estimate] = (), differences: Mapping[str, float] | None = None,
) -> list[Finding]:  # fmt: skip
    """Return the finding on effects that were estimated because the images favour them.

    `moves` are the changes of other estimates, in standard errors; `rivals` explain the images as well, and `others`
    are estimates of them instead, with which the other estimates differ by `differences`, in standard errors.
    Estimates within one standard error of 0 are left out where 0 is stated.
    """
    shown = [one for one in estimates if one.stated or abs(one.value) > one.error]
    told = {one.name for one in others}
    words = [*map(str, shown[:_MAX_ESTIMATES]), *["..."][: len(shown) - _MAX_ESTIMATES]]
    instead = [*map(str, others), *(name for name in rivals if name not in told)][:_MAX_ESTIMATES]
    found, either = ", ".join(words), "it"
    if instead:
        either = "either"
        found += (
            f", or instead {' or '.join(instead)}, each if the others are as stated: the images do not tell which"
        )
    numbers: dict[str, Any] = {one.name: one.numbers for one in (*shown, *others)}
    (name, move), (open_name, difference) = (
        max(changes.items(), key=lambda pair: pair[1], default=("", 0.0)) for changes in (moves, differences or {})
    )
    moved = f" (it moves {name} by {move:.2g} standard errors)" if name else ""
    text = f"estimated besides: {found}: terms allow for {either}{moved}"
    severity: Severity = "note"
    if difference > CLOSED:
        severity = "doubt" if difference > _SAME else "note"
        text += f", but {open_name} differs by {difference:.2g} standard errors, which its error includes"
    return [Finding("estimated", severity, text, numbers | {"move": move})] if shown else []
