"""Methods of deconvolution: options of Richardson-Lucy and total variation, stopping rules, and a search."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from lommel.base import validation

# Why a method stopped.
NOISE, STEPS, MISFIT, ONE_PASS = "noise", "steps", "misfit: depth, lens or noise do not fit", "one pass"

# Called with the number of a step, its discrepancy, and about how many seconds are left.
Tell = Callable[[int, float, float], object]


def silent(*_: object) -> None:
    """Report no progress."""


EARLIEST = 20  # steps after which a misfit can be detected


@dataclass(frozen=True, kw_only=True)
class RichardsonLucy:
    r"""Richardson-Lucy deconvolution: ``x <- x / (A^T w) * A^T[w (y + s) / (A x + s)]``, from a uniform scene.

    Each step raises the likelihood; since late steps fit the noise, stopping early keeps the result smooth. It stops
    when the discrepancy (about 1 for the true scene) reaches `target`. A discrepancy that stays above 1 shows a
    misfit of depth, lens or noise, which further steps would turn into artefacts. The discrepancy D falls less at
    each doubling of the number k of steps: a misfit is detected from step 20 on where it would stay above 1, by more
    than its own noise s, until the last of n steps if it fell as much at each, and at one more at least,
    ``D(k) - (D(k/2) - D(k)) max(log2(n/k), 1) > 1 + s``.

    Parameters
    ----------
    steps : int, default 200
        Maximum number of steps, 1 to 100000.
    target : float, default 0.9
        Discrepancy at which to stop. The default is below 1 because the result also fits part of the noise. 0 takes
        all `steps`.
    accelerate : bool, default True
        Whether to extrapolate the steps, which saves about two thirds of them.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.

    Notes
    -----
    Richardson 1972, doi:10.1364/JOSA.62.000055; Lucy 1974, doi:10.1086/111605; s, the read variance, after
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


class StoppingRule:
    """Course of an iteration: its discrepancies, when to stop, and how far steps are extrapolated."""

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
        """Return the reason to stop at this discrepancy, if any, and call `tell`."""
        self._history.append(discrepancy)
        self._tell(self.steps, discrepancy, self._left(time.perf_counter() - self._start))
        step, target, most = self.steps, self._method.target, 1.0 + self._slack
        # A flat scene that explains all has nothing to be found in it.
        if target > 0.0 and (discrepancy <= target or (step == 0 and discrepancy <= most)):
            return NOISE
        if target > 0.0 and step >= EARLIEST and discrepancy > most:
            # It falls the less the longer it goes on: at no doubling of the steps by more than at the last one.
            fall = self._history[step // 2] - discrepancy
            if discrepancy - fall * max(math.log2(self._method.steps / step), 1.0) > most:
                return MISFIT
        return STEPS if step == self._method.steps else None

    def extrapolate_by(self, size: float, overlap: float) -> None:
        """Set the pace: the product of the last two changes over the square of the earlier one."""
        # Below 1: at 1 a geometric series of changes would have no limit.
        self.pace = min(max(overlap / size, 0.0), 0.999) if size > 0.0 else 0.0

    def _left(self, spent: float) -> float:
        """Return about how many seconds are left, if the discrepancy goes on falling as it did."""
        step, history, target = self.steps, self._history, self._method.target
        total = float(self._method.steps)
        if step >= 2 and target > 0.0 and history[step] < history[step // 2]:
            # Discrepancies fall about as a power of the number of steps: its exponent is the slope in logarithms.
            rate = np.log(history[step // 2] / history[step]) / np.log(step / (step // 2))
            total = min(total, step * max(history[step] / target, 1.0) ** min(1.0 / rate, 8.0))
        return max(total - step, 0.0) * spent / max(step, 1)


_SEARCHES = 6  # largest number of strengths that are tried
_NEAR = (-0.1, 0.03)  # logarithm of the discrepancy over the target: range that ends the search


@dataclass(frozen=True, kw_only=True)
class TotalVariation:
    r"""Deblurring with total variation, which preserves edges.

    The minimum of ``sum w (m - y ln m) + strength * sum |grad x|`` over ``x >= 0``, with ``m = A x + s``. The
    gradient is that of all channels together, so that they share their edges. The `strength` is found from the noise,
    such that the discrepancy of the result is `target`.

    Parameters
    ----------
    strength : float, optional
        Dimensionless weight of the total variation, typically ``0.15 / sqrt(electrons per pixel)``.
    steps : int, default 150
        Maximum number of steps of each `strength`, 1 to 100000: they end where the objective hardly falls.
    target : float, default 0.9
        Discrepancy to reach, above 0. Less than 1, since the result follows some of the noise.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range.

    Notes
    -----
    Steps of De Pierro 1995, doi:10.1109/42.370409, in closed form for each pixel, extrapolated. Gradients
    below 0.01 of the mean light count by their squares. Each strength starts from the result of the last one.
    """

    strength: float | None = None
    steps: int = 150
    target: float = 0.9

    def __post_init__(self) -> None:
        if self.strength is not None:
            validation.real("strength", self.strength, above=0.0)
        validation.integer("steps", self.steps, least=1, most=100_000)
        validation.real("target", self.target, above=0.0)


def search(settle: Callable[[float], float], first: float, target: float, least: float) -> tuple[float, float]:
    """Return the discrepancy and the strength with which `settle`, called with strengths, ended near the target.

    Strengths are sought on a line of their logarithms, from the `first` one on, between the `least` and 64 times the
    first, until a discrepancy is near the target; the light is that of the last.
    """
    tried: list[tuple[float, float]] = []
    strength = first
    while True:
        found = settle(strength)
        tried.append((math.log(strength), math.log(found / target)))
        if len(tried) == _SEARCHES or _NEAR[0] <= tried[-1][1] <= _NEAR[1]:
            return found, strength
        following = min(max(_next(tried), least), 64.0 * first)
        if math.isclose(following, strength, rel_tol=1e-6):
            return found, strength
        strength = following


def _next(tried: list[tuple[float, float]]) -> float:
    """Return the next strength, from logarithms of strengths and of discrepancies over the target, which rise."""
    at, off = tried[-1]
    below = [point for point in tried if point[1] < 0.0]
    above = [point for point in tried if point[1] >= 0.0]
    if below and above:
        (a, u), (b, v) = max(below), min(above)
        # Between the bracket's ends by the secant, but not near either end, so that the bracket shrinks by 30 % or
        # more.
        share = min(max(-u / (v - u), 0.3), 0.7) if b > a else 0.5
        return math.exp(a + share * (b - a))
    slope = 0.3  # usual increase of the discrepancy's logarithm with that of the strength
    if len(tried) > 1 and tried[-1][0] != tried[-2][0]:
        slope = max((off - tried[-2][1]) / (at - tried[-2][0]), 1e-3)
    # At most a factor of 4 at a time: the slope is known at the last points alone.
    return math.exp(at - min(max(off / slope, -math.log(4.0)), math.log(4.0)))
