"""What the method that is chosen costs over the better one, on random questions about round pupils.

    python benchmarks/choice.py [--first 0] [--count 300] [--averages] [--write tests/methods/choice.csv]

Each question is asked by a prepared computation, on one thread, of the chordal rule, of the series, and of what is
chosen, in turn. Prints quantiles of the processor time of the last over that of the better one, and the worst
questions. With `--write` the times of both methods are written, in microseconds, which the tests hold the choice to.
"""

from __future__ import annotations

import argparse
import math
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

import lommel as lm
from lommel.core.answers import Declined

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests" / "shared"))

from disk_questions import DiskQuestion, disk_question

_ENOUGH = 0.04  # seconds of calls
_SHORT = 2e-3  # seconds of a call that what others left in caches makes longer,
_WARMING = 3  # for so many calls
_SLOW = 8.0  # times the least, beyond which a few calls are enough
_FEWEST, _MOST = 3, 50  # calls

Call = Callable[[], object]


def prepared(question: DiskQuestion, method: lm.Method | None) -> Call | None:
    """Return what asks the question on one thread; None where the method refuses."""
    pupil, grid, tol = question
    named = None if method is None else method.with_tol(tol)
    plan = lm.Plan(
        grid.shape,
        grid.side,
        method=named,
        tol=tol,
        center=grid.axis,
        integrate=grid.integrate,
        normalize="strehl",
        threads=1,
    )
    try:
        plan(pupil)
    except (lm.ToleranceError, Declined):
        return None
    return lambda: plan(pupil)


def seconds(calls: Sequence[Call | None]) -> list[float]:
    """Return the least processor time of each of some calls, which are made in turn; infinity for None."""
    least, spent, count = [math.inf] * len(calls), 0.0, 0
    while count < _FEWEST or (spent < _ENOUGH * len(calls) and count < _MOST):
        for k, call in enumerate(calls):
            if call is None or (count >= _FEWEST and _SLOW * min(least) < least[k]):
                continue
            for _ in range(0 if _SHORT < least[k] < math.inf else _WARMING):
                call()
            begin = time.process_time()
            call()
            took = time.process_time() - begin
            least[k], spent = min(least[k], took), spent + took
        count += 1
    return least


def main() -> None:
    """Ask, and print."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--averages", action="store_true")
    parser.add_argument("--write", type=Path)
    options = parser.parse_args()
    rows, ratios = [], []
    for index in range(options.first, options.first + options.count):
        question = disk_question(index, averages=options.averages)
        chords, series, chosen = seconds(
            [prepared(question, method) for method in (lm.ChordalGauss(), lm.NijboerZernike(), None)]
        )
        if min(chords, series) == math.inf:
            continue
        rows.append(f"{index},{1e6 * chords:.1f},{1e6 * series:.1f}")
        ratios.append((chosen / min(chords, series), chords, series, question))
    found = np.array([ratio for ratio, *_ in ratios])
    print(f"{len(found)} questions; at most 1.25 of the better method: {np.mean(found <= 1.25):.1%}")
    print("quantiles 50, 90, 95, 99 %, largest:", *np.round(np.quantile(found, [0.5, 0.9, 0.95, 0.99, 1.0]), 2))
    for ratio, chords, series, question in sorted(ratios, key=lambda each: -each[0])[:10]:
        print(f"{ratio:6.2f}  chords {1e3 * chords:.3g} ms, series {1e3 * series:.3g} ms: {question}")
    if options.write:
        options.write.write_text("question,chords,series\n" + "\n".join(rows) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
