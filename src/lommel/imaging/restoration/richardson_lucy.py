"""Restoration by the iteration of Richardson and Lucy, which the noise stops."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np

from lommel.base import validation
from lommel.imaging.restoration.observed import MISFIT, NOISE, STEPS, Observed, Solution, Tell

_FIRST = 20  # steps after which a misfit can be told


@dataclass(frozen=True, kw_only=True)
class RichardsonLucy:
    r"""Restoration by likelihood alone: ``x <- x / (A^T w) * A^T[w (y + s) / (A x + s)]``, from a flat scene.

    Each step explains the photograph better, its noise too in the end: where to stop is what keeps the result smooth.
    It stops once the discrepancy (about 1 for the scene itself) is `target`. One that stays above 1 shows that
    something else than noise is left, that depth, lens or noise do not fit, and further steps would draw it into the
    picture. Where the blur is right the discrepancy D falls faster than ``c + d / k`` with the steps k: a misfit is
    told from step 20 on where such a curve would end above the target, ``2 D(k) - D(k/2) > target``.

    Parameters
    ----------
    steps : int, default 200
        At most so many, 1 to 100000.
    target : float, default 0.9
        Discrepancy to stop at. Less than 1, for what is restored follows some of the noise. 0 takes all `steps`.
    accelerate : bool, default True
        Whether steps are extrapolated, which saves about two of three.

    Raises
    ------
    TypeError, ValueError
        If one of them is of another type or out of range.

    Notes
    -----
    Richardson 1972, doi:10.1364/JOSA.62.000055; Lucy 1974, doi:10.1086/111605; s, the variance of reading, after
    Snyder et al. 1993, doi:10.1364/JOSAA.10.001014; acceleration after Biggs and Andrews 1997,
    doi:10.1364/AO.36.001766; stopping after Bertero et al. 2010, doi:10.1088/0266-5611/26/10/105004.
    """

    steps: int = 200
    target: float = 0.9
    accelerate: bool = True

    def __post_init__(self) -> None:
        validation.integer("steps", self.steps, least=1, most=100_000)
        validation.real("target", self.target, least=0.0)
        validation.truth("accelerate", self.accelerate)

    def solve(self, observed: Observed, tell: Tell) -> Solution:
        """Return the sharp light behind what was observed.

        Parameters
        ----------
        observed : Observed
        tell : callable
            Called as ``tell(step, discrepancy, seconds_left)`` at each step.

        Returns
        -------
        Solution
        """
        light = before = observed.flat
        # What no known pixel sees stays as it is.
        unseen = observed.seen <= 1e-6
        per = 1.0 / np.where(unseen, 1.0, observed.seen)
        some_unseen, smallest = bool(unseen.any()), observed.smallest
        # Kept for all steps: new memory costs more than what is done in it.
        extrapolated, change, earlier = (np.empty_like(light) for _ in range(3))
        size = overlap = 0.0  # of the squares of the earlier change; and of its products with the last one
        history: list[float] = []
        start = time.perf_counter()
        while True:
            step, guess = len(history), light
            pace = min(max(overlap / size, 0.0), 0.999) if size > 0.0 else 0.0
            if pace > 0.0:
                guess = np.subtract(light, before, out=extrapolated)
                guess *= pace
                guess += light
                np.maximum(guess, smallest, out=guess)
            model = observed.model(guess)
            ratio = observed.ratio(model)
            history.append(observed.discrepancy(model, ratio))
            tell(step, history[-1], self._left(history, time.perf_counter() - start))
            if (stopped := self._stopped(history, observed.slack)) or step == self.steps:
                return Solution(guess, step, stopped or STEPS)
            ratio *= observed.weight
            found = observed.blur.adjoint(ratio)
            found *= per
            found *= guess
            if some_unseen:
                np.copyto(found, guess, where=unseen)
            np.maximum(found, 0.0, out=found)
            before, light = light, found
            if self.accelerate:
                earlier, change = change, np.subtract(found, guess, out=earlier)
                if step > 0:
                    size, overlap = float(np.vdot(earlier, earlier)), float(np.vdot(change, earlier))

    def _stopped(self, history: list[float], slack: float) -> str | None:
        """Return why to stop here, if there is a reason."""
        step, found = len(history) - 1, history[-1]
        if self.target == 0.0:
            return None
        # A flat scene that explains all has nothing to be found in it.
        if found <= self.target or (step == 0 and found <= 1.0 + slack):
            return NOISE
        if step >= _FIRST and found > 1.0 + slack and 2.0 * found - history[step // 2] > self.target:
            return MISFIT
        return None

    def _left(self, history: list[float], spent: float) -> float:
        """Return about how many seconds the rest takes, as the discrepancy fell until now."""
        step = len(history) - 1
        total = float(self.steps)
        if step >= 2 and self.target > 0.0 and history[step] < history[step // 2]:
            rate = np.log(history[step // 2] / history[step]) / np.log(step / (step // 2))
            total = min(total, step * max(history[step] / self.target, 1.0) ** min(1.0 / rate, 8.0))
        return max(total - step, 0.0) * spent / max(step, 1)
