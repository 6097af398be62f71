"""What an estimator says of its own result, and whether it may say so."""

from __future__ import annotations

import math
import signal
import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from scipy.stats import chi2, norm

RMS = 0.8, 1.15  # of errors over standard errors, where results are right
WRONG, NEVER = 4.0, 5.0  # standard errors: a result that is off by more is wrong, and one that should be right failed
RARE = 1e-3
LIMIT = 120  # CPU seconds


class Trial(NamedTuple):
    """One result: errors over standard errors `z` of what noise alone decides, and `held` of what was known before.

    `extras` are other numbers with standard errors of their own. `wrong` says so where no standard error does.
    """

    result: Any
    z: np.ndarray
    seconds: float = 0.0
    held: np.ndarray = np.zeros(0)
    extras: Mapping[str, tuple[float, float]] = {}
    wrong: bool = False


class Verdict(NamedTuple):
    """Whether a result calls itself good (reliable), and the codes of its findings, the gravest first."""

    good: bool
    codes: tuple[str, ...]
    text: str


def verdict(result: Any) -> Verdict:
    """Return what a result, or the first channel of a restored stack, says of itself."""
    said = result if hasattr(result, "findings") else result.channels[0]
    # The sign of a field of one focus is open, and its twin is given: errors are those of the nearer of both.
    twin = {"sign_open"} if hasattr(said, "degree") else set[str]()
    doubts = {one.code for one in said.findings if one.severity != "note"}
    return Verdict(doubts <= twin, said.findings.codes, said.findings.text)


@dataclass(frozen=True)
class Scenario:
    """A world, an estimator, and what must come of it.

    `must` is "R": right, in at least `share` of all runs; "T": told, by one of `codes` among the first three, in at
    least `share`; "RT": either; "N": named by one of `codes`, a note being enough.
    """

    row: str
    name: str
    estimator: str
    run: Callable[[int], Trial]
    must: str = "R"
    codes: tuple[str, ...] = ()
    share: float | None = None
    limits: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    seconds: float = math.inf

    @property
    def at_least(self) -> float:
        """The share of runs."""
        return self.share or {"R": 0.8, "T": 0.95}.get(self.must, 1.0)


class Run(NamedTuple):
    """What is kept of a run."""

    seed: int
    good: bool
    codes: list[str]
    text: str
    z: list[float]
    held: list[float]
    extras: dict[str, tuple[float, float]]
    wrong: bool
    seconds: float


def attempt(scenario: Scenario, seed: int) -> Run:
    """Run a scenario once. Refusals (ValueError) are told, and so is what did not end; other errors are faults."""
    begun = time.process_time()
    try:
        with _at_most(LIMIT):
            trial = scenario.run(seed)
    except (ValueError, TimeoutError) as error:
        code = "not_ended" if isinstance(error, TimeoutError) else "refused"
        return Run(seed, False, [code], str(error), [], [], {}, False, time.process_time() - begun)
    said = verdict(trial.result)
    z, held = (np.asarray(one, dtype=float).ravel() for one in (trial.z, trial.held))
    every = np.abs(np.concatenate([z, held]))
    wrong = trial.wrong or bool((~(every <= _limit(WRONG, every.size))).any())
    extras = {name: (float(value), float(error)) for name, (value, error) in trial.extras.items()}
    return Run(seed, said.good, list(said.codes), said.text, z.tolist(), held.tolist(), extras, wrong, trial.seconds)


def _limit(least: float, count: int) -> float:
    """Return by how much the largest of many numbers may be off: no less than one of a few."""
    return max(least, float(norm.isf(RARE / 2 / max(count, 1))))


@contextmanager
def _at_most(seconds: float) -> Any:
    def ended(*_: object) -> None:
        raise TimeoutError(f"not ended after {seconds} s of a processor")

    before = signal.signal(signal.SIGPROF, ended)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


class Judgement(NamedTuple):
    """A row of the table."""

    runs: int
    good: int
    told: int  # with a right code among the first three, or named, as the scenario has it
    wrong_and_good: int
    rms: float
    largest: float
    codes: dict[str, int]
    seconds: float
    faults: list[str]


def judge(scenario: Scenario, runs: Sequence[Run]) -> Judgement:
    """Return what runs amount to, and what is wrong with it."""
    good = [run for run in runs if run.good]
    first = [run for run in runs if set(run.codes[:3] if scenario.must != "N" else run.codes) & set(scenario.codes)]
    told = [run for run in first if scenario.must == "N" or not run.good]
    wrong = [run for run in good if run.wrong]
    z = np.array([one for run in good for one in run.z])
    every = np.abs([one for run in good for one in (*run.z, *run.held)])
    rms = float(np.sqrt(np.mean(z**2))) if z.size else math.nan
    largest = float(every.max()) if every.size else math.nan
    faults, count = [], len(runs)
    # What its data cannot test may be off in a row "N", where the result names it; it is counted nevertheless.
    if wrong and scenario.must != "N":
        faults.append(f"wrong and called good: {len(wrong)} of {count}")
    if scenario.must in ("T", "N") and len(told) < scenario.at_least * count:
        faults.append(f"told by {' or '.join(scenario.codes) or 'any code'}: {len(told)} of {count}")
    if scenario.must == "R":
        if len(good) < scenario.at_least * count:
            faults.append(f"good: {len(good)} of {count}")
        if every.size and largest > _limit(NEVER, every.size):
            faults.append(f"off by {largest:.1f} standard errors")
    if scenario.must != "N" and z.size >= 10:
        low, high = np.sqrt(chi2.ppf([RARE / 2, 1 - RARE / 2], z.size) / z.size)
        if not min(RMS[0], low) <= rms <= max(RMS[1], high):
            faults.append(f"errors are {rms:.2f} standard errors rms")
    for name, (least, most) in scenario.limits.items():
        values = np.array([run.extras[name] for run in good if name in run.extras])
        if values.size:
            mean, error = values[:, 0].mean(), np.hypot.reduce(values[:, 1]) / len(values)
            if not least - 3 * error <= mean <= most + 3 * error:
                faults.append(f"{name} {mean:.4g} +- {error:.2g}, not {least:g} to {most:g}")
    seconds = float(np.median([run.seconds for run in runs])) if runs else math.nan
    if max((run.seconds for run in runs), default=0.0) > scenario.seconds:
        faults.append(f"more than {scenario.seconds:g} s")
    codes = Counter(code for run in runs for code in run.codes[:3])
    return Judgement(count, len(good), len(told), len(wrong), rms, largest, dict(codes), seconds, faults)
