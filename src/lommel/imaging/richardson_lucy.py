"""Richardson-Lucy deconvolution, stopped at the noise level (discrepancy principle)."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np

from lommel.base import validation
from lommel.imaging.observed import MISFIT, NOISE, STEPS, Observed, Solution, Tell

_FIRST = 20  # steps after which a misfit can be told


@dataclass(frozen=True, kw_only=True)
class RichardsonLucy:
    r"""Richardson-Lucy deconvolution: ``x <- x / (A^T w) * A^T[w (y + s) / (A x + s)]``, from a uniform scene.

    Each step raises the likelihood; in the end the steps fit the noise too, and stopping early keeps the result
    smooth. It stops once the discrepancy (about 1 for the scene itself) is `target`. A discrepancy that stays above 1
    shows a misfit of depth, lens or noise, which further steps would turn into artefacts. Where the blur is right the
    discrepancy D falls faster than ``c + d / k`` with the steps k: a misfit is detected from step 20 on where such a
    curve would end above the target, ``2 D(k) - D(k/2) > target``.

    Parameters
    ----------
    steps : int, default 200
        Maximum number of steps, 1 to 100000.
    target : float, default 0.9
        Discrepancy to stop at; below 1, since the result follows some of the noise. 0 takes all `steps`.
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
        """Return the light behind the counts `observed`; `tell` gets step, discrepancy and seconds left."""
        light = before = observed.flat
        # What no known pixel sees stays as it is.
        unseen = observed.seen <= 1e-6
        per = 1.0 / np.where(unseen, 1.0, observed.seen)
        some_unseen, smallest = bool(unseen.any()), observed.smallest
        # Kept for all steps: new memory costs more than what is done in it.
        extrapolated, change, earlier = (np.empty_like(light) for _ in range(3))
        course = Course(self, observed.slack, tell)
        while True:
            guess = light
            if course.pace > 0.0:
                guess = np.subtract(light, before, out=extrapolated)
                guess *= course.pace
                guess += light
                np.maximum(guess, smallest, out=guess)
            model = observed.model(guess)
            ratio = observed.ratio(model)
            if stopped := course.judge(observed.discrepancy(model, ratio)):
                return Solution(guess, course.steps, stopped)
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
                if course.steps > 0:
                    course.go_on(float(np.vdot(earlier, earlier)), float(np.vdot(change, earlier)))


class Course:
    """The course of an iteration: its discrepancies, whether to stop, and how far steps are extrapolated."""

    def __init__(self, method: RichardsonLucy, slack: float, tell: Tell) -> None:
        self._method, self._slack, self._tell = method, slack, tell
        self._history: list[float] = []
        self._start = time.perf_counter()
        self.pace = 0.0

    @property
    def steps(self) -> int:
        """Number of steps."""
        return len(self._history) - 1

    def judge(self, discrepancy: float) -> str | None:
        """Return the reason to stop at this discrepancy, if there is one, and call `tell`."""
        self._history.append(discrepancy)
        self._tell(self.steps, discrepancy, self._left(time.perf_counter() - self._start))
        return self._stopped() or (STEPS if self.steps == self._method.steps else None)

    def go_on(self, size: float, overlap: float) -> None:
        """Set the pace, from the square of the last change but one, and its product with the last."""
        self.pace = min(max(overlap / size, 0.0), 0.999) if size > 0.0 else 0.0

    def _stopped(self) -> str | None:
        """Return the reason to stop that the discrepancy gives, if any."""
        step, history, target = self.steps, self._history, self._method.target
        found = history[-1]
        if target == 0.0:
            return None
        # A flat scene that explains all has nothing to be found in it.
        if found <= target or (step == 0 and found <= 1.0 + self._slack):
            return NOISE
        if step >= _FIRST and found > 1.0 + self._slack and 2.0 * found - history[step // 2] > target:
            return MISFIT
        return None

    def _left(self, spent: float) -> float:
        """Return about how many seconds the rest takes, as the discrepancy fell until now."""
        step, history, target = self.steps, self._history, self._method.target
        total = float(self._method.steps)
        if step >= 2 and target > 0.0 and history[step] < history[step // 2]:
            rate = np.log(history[step // 2] / history[step]) / np.log(step / (step // 2))
            total = min(total, step * max(history[step] / target, 1.0) ** min(1.0 / rate, 8.0))
        return max(total - step, 0.0) * spent / max(step, 1)
