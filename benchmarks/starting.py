"""What the first call of a process takes, calls whose caches others emptied, and the import before them."""

from __future__ import annotations

from functools import cache, partial

import numpy as np

from benchmarks import fresh
from benchmarks.settings import Settings
from benchmarks.targets import Measured
from benchmarks.timing import Contender, Spread, race


def importing(settings: Settings) -> Measured:
    """Measure a process that imports the package over one that imports NumPy."""
    both = [Contender(name, partial(fresh.process, f"import {name}"), "") for name in ("lommel", "numpy")]
    result = race(both, settings.rounds, budget=10.0, keep=False)
    return Measured(result.ratio("lommel", "numpy"), None, "whole processes, their modules compiled beforehand")


@cache
def _once(settings: Settings) -> list[list[float]]:
    return [fresh.once(settings) for _ in range(3 if settings.quick else 11)]


def first(settings: Settings) -> Measured:
    """Measure the first call of processes that have imported the package, over the first copy."""
    note = "memory that is new for both; modules that are loaded late, tables"
    return Measured(Spread.of(np.array(_once(settings))[:, 0]), None, note)


def between(settings: Settings) -> Measured:
    """Measure calls between others that empty the caches, over copies of such arrays there."""
    return Measured(Spread.of(np.array(_once(settings))[:, 1]), None, "into `out`; the others add 1 to 128 MiB")
