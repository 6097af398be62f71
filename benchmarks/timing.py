"""Contenders take turns in one process; what counts is the ratio of two neighbours in time."""

from __future__ import annotations

import gc
import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

_SLOW = 1.0  # seconds: what takes longer may have one turn only
_PATIENCE = 5.0  # and is not even called twice to warm up


def nothing(count: int) -> Sequence[Any]:
    """Return `count` times None: the arguments of a contender that needs none."""
    return (None,) * count


def no_values(_: object) -> NDArray[np.float64]:
    """Return no values: what is judged of a contender that is only timed."""
    return np.empty(0)


@dataclass(frozen=True)
class Contender:
    """One way to do the work.

    Attributes
    ----------
    name : str
    call : callable
        Does the work once, given an argument of `fresh`.
    config : str
        What was chosen, in words.
    fresh : callable
        Makes that many new arguments, outside of the timer, so that nothing remembered from one call helps the
        next. The first one is the nominal case, whose result is judged.
    values : callable
        Turns what `call` returned into the array to judge.
    """

    name: str
    call: Callable[[Any], Any]
    config: str = ""
    fresh: Callable[[int], Sequence[Any]] = nothing
    values: Callable[[Any], NDArray[Any]] = np.asarray


@dataclass(frozen=True)
class Spread:
    """Median of several rounds, and the extremes."""

    median: float
    low: float
    high: float
    rounds: int

    @classmethod
    def of(cls, samples: NDArray[np.float64]) -> Spread:
        """Summarise one number a round."""
        return cls(float(np.median(samples)), float(samples.min()), float(samples.max()), len(samples))


@dataclass
class Race:
    """What was measured: seconds a call in each round, and the first result of each contender."""

    seconds: dict[str, NDArray[np.float64]] = field(default_factory=dict)
    values: dict[str, NDArray[Any]] = field(default_factory=dict)

    def ratio(self, over: str, under: str) -> Spread:
        """Summarise the ratio of two contenders, taken in each round."""
        return Spread.of(self.seconds[over] / self.seconds[under])

    def median(self, name: str) -> float:
        """Return the median seconds of a call."""
        return float(np.median(self.seconds[name]))


def race(
    contenders: Sequence[Contender], rounds: int, *, budget: float = 20.0, sample: float = 2e-3, keep: bool = True
) -> Race:
    """Let the contenders take turns, A B C A B C ..., warm.

    Parameters
    ----------
    contenders : sequence of Contender
    rounds : int
        How often each has its turn; fewer (but three, or one where a call takes seconds) to stay within `budget`.
    budget : float
        Seconds for all.
    sample : float
        A turn is the fastest of three batches, each of as many calls as take this long (s), so that a call that
        another program interrupts does not count. Of calls beyond 0.1 s it is a single one.
    keep : bool
        Keep the values of the first, untimed call of each.
    """
    result = Race()
    plans: dict[str, tuple[int, int]] = {}
    known: dict[str, float] = {}
    total = 0.0
    for one in contenders:
        argument = one.fresh(1)[0]
        start = time.perf_counter()
        first = one.call(argument)
        once = time.perf_counter() - start
        if keep:
            # A copy: the next call may write to the same array.
            result.values[one.name] = np.array(one.values(first))
        del first
        # The first call may have compiled something or built a table.
        if once < _PATIENCE:
            once = _turn(one, 1)
        if once > _SLOW:
            known[one.name] = once
        batches = 3 if once < 0.1 else 1
        plans[one.name] = batches, max(1, min(20_000, math.ceil(sample / max(once, 1e-7))))
        total += max(once, sample) * batches
    rounds = max(1 if known else 3, min(rounds, int(budget / total)))
    samples: dict[str, list[float]] = {one.name: [] for one in contenders}
    for number in range(rounds):
        for one in contenders:
            batches, count = plans[one.name]
            if number == 0 and one.name in known:
                # What has been timed already will do.
                samples[one.name].append(known[one.name])
            else:
                samples[one.name].append(min(_turn(one, count) for _ in range(batches)))
    result.seconds = {name: np.array(taken) for name, taken in samples.items()}
    return result


def _turn(one: Contender, count: int) -> float:
    """Return the mean seconds of a batch of calls."""
    arguments, call = one.fresh(count), one.call
    gc.collect(0)
    gc.disable()
    try:
        start = time.perf_counter()
        for argument in arguments:
            call(argument)
        return (time.perf_counter() - start) / count
    finally:
        gc.enable()


@dataclass(frozen=True)
class Settings:
    """Handed to every section.

    Attributes
    ----------
    quick : bool
        Fewer cases, sizes and rounds.
    tick : callable
        Told what is being measured now.
    """

    quick: bool
    tick: Callable[[str], None]

    @property
    def rounds(self) -> int:
        """Turns of each contender."""
        return 5 if self.quick else 15


@dataclass(frozen=True)
class Measured:
    """What was found, in the worst of the cases of a row."""

    value: Spread
    error: float | None
    note: str


def worst(found: list[Measured], *, more: bool) -> Measured:
    """Return the least favourable case, with the largest error of all."""
    ranked = sorted(found, key=lambda m: m.value.median if more else -m.value.median)
    errors = [m.error for m in found if m.error is not None]
    note = ranked[0].note
    if len(found) > 1:
        note = f"worst of {len(found)} cases, {note}. The best came to {ranked[-1].value.median:.3g}"
    return Measured(ranked[0].value, max(errors, default=None), note)
