"""What the method that is chosen costs over the better one, on random questions about round pupils, or apertures.

    python benchmarks/choice.py [--first 0] [--count 300] [--averages] [--write tests/methods/choice.csv "Zen 5"]
    python benchmarks/choice.py --apertures [--first 0] [--count 250] [--write ...]

Each question is asked by a prepared computation, on one thread, of the chordal rule, of the series, and of what is
chosen, in turn; behind other apertures of NonuniformFFT instead of the series, by each of its ways: samples by the
moment rule or from rows, or nodes of the window. Prints quantiles of the processor time of
what is chosen over that of the best, and the worst questions, with vectors of 512 and of 256 bits where the processor
has both. With `--write` the times of both methods
are written, in microseconds, beside those of other processors than the one of that name: the tests hold the choice to
them.
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
from lommel import _core
from lommel.core.answers import Declined
from lommel.methods import nonuniform_fft

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests" / "shared"))

from disk_questions import DiskQuestion, aperture_question, disk_question

_ENOUGH = 0.04  # seconds of calls
_SHORT = 2e-3  # seconds of a call that what others left in caches makes longer,
_WARMING = 3  # for so many calls
_SLOW = 8.0  # times the least, beyond which a few calls are enough
_FEWEST, _MOST = 3, 50  # calls

Call = Callable[[], object]


class _NoRows(nonuniform_fft._Times):
    def transforms(self, height: float, width: float) -> float:
        return math.inf


# Ways of NonuniformFFT, and what of it makes the choice.
_WAYS: dict[str | None, dict[str, object]] = {
    None: {name: getattr(nonuniform_fft, name) for name in ("_Times", "_nodes_are_faster", "moment_rule_is_faster")},
    "nodes": {"_nodes_are_faster": lambda *_: True},
    "moments": {"_nodes_are_faster": lambda *_: False, "_Times": _NoRows},
    "rows": {"_nodes_are_faster": lambda *_: False, "moment_rule_is_faster": lambda *_: False},
}


def prepared(question: DiskQuestion, method: lm.methods.Method | None, way: str | None = None) -> Call | None:
    """Return what asks the question on one thread, by this way of NonuniformFFT; None where the method refuses."""
    pupil, grid, tol = question
    forced = _WAYS[None] | _WAYS[way]
    named = None if method is None else method.with_tol(tol)
    plan = lm.Plan(
        grid.shape,
        grid.side,
        method=named,
        tol=tol,
        center=grid.center,
        integrate=grid.integrate,
        normalize="strehl",
        threads=1,
    )

    def ask() -> None:
        vars(nonuniform_fft).update(forced)
        plan(pupil)

    try:
        ask()
    except (lm.ToleranceError, Declined):
        return None
    return ask


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


def asked(first: int, count: int, *, averages: bool) -> list[tuple[float, float, float, int]]:
    """Ask, and print; return the seconds of chords, of the series and of what is chosen, and the number."""
    found = []
    for index in range(first, first + count):
        question = disk_question(index, averages=averages)
        chords, series, chosen = seconds(
            [prepared(question, method) for method in (lm.methods.ChordalGauss(), lm.methods.NijboerZernike(), None)]
        )
        if min(chords, series) < math.inf:
            found.append((chords, series, chosen, index))
    ratios = np.array([chosen / min(chords, series) for chords, series, chosen, _ in found])
    print(
        f"{_core.instructions()}, {len(found)} questions; at most 1.25 of the better: {np.mean(ratios <= 1.25):.1%}"
    )
    print("quantiles 50, 90, 95, 99 %, largest:", *np.round(np.quantile(ratios, [0.5, 0.9, 0.95, 0.99, 1.0]), 2))
    for k in np.argsort(-ratios)[:10]:
        chords, series, _, index = found[k]
        question = disk_question(index, averages=averages)
        print(f"{ratios[k]:6.2f}  chords {1e3 * chords:.3g} ms, series {1e3 * series:.3g} ms: {index}, {question}")
    return found


def asked_of_apertures(first: int, count: int) -> list[str]:
    """Ask about apertures of telescopes, and print; return the times of chords and of the best other way as text."""
    found = []
    for index in range(first, first + count):
        kind, question = aperture_question(index)
        calls = {"chosen": prepared(question, None)}
        if kind in ("annulus", "vanes", "three vanes", "vlt"):
            calls["chords"] = prepared(question, lm.methods.ChordalGauss())
        if kind == "annulus":
            calls["series"] = prepared(question, lm.methods.NijboerZernike())
        else:
            calls |= {way: prepared(question, lm.methods.NonuniformFFT(), way) for way in list(_WAYS)[1:]}
        times = dict(zip(calls, seconds(list(calls.values())), strict=True))
        found.append((times["chosen"] / min(times.values()), index, kind, question, times))
    vars(nonuniform_fft).update(_WAYS[None])
    ratios = np.array([ratio for ratio, *_ in found])
    print(f"{_core.instructions()}, {len(found)} questions; at most 1.5 times the best: {np.mean(ratios <= 1.5):.1%}")
    print("mean, 95 %, 97 %, largest:", *np.round([ratios.mean(), *np.quantile(ratios, [0.95, 0.97, 1.0])], 2))
    for ratio, index, kind, question, times in sorted(found, key=lambda one: -one[0])[:10]:
        print(f"{ratio:6.2f}  {index}, {kind}: {question};", *(f"{w} {1e3 * t:.3g} ms" for w, t in times.items()))
    rows = []
    for _, index, _, _, times in found:
        if "chords" in times:
            other = min(time for way, time in times.items() if way in ("series", *_WAYS))
            rows.append(f"aperture {index},{1e6 * times['chords']:.1f},{1e6 * other:.1f}")
    return rows


def main() -> None:
    """Ask with the vectors of each width that the processor has."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--averages", action="store_true")
    parser.add_argument("--apertures", action="store_true", help="of telescopes")
    parser.add_argument("--write", nargs=2, metavar=("FILE", "PROCESSOR"))
    options = parser.parse_args()
    widest, rows = _core.instructions(), []
    for level in [widest] if widest != "avx512" else ["avx512", "avx2"]:
        _core.limit_instructions(level)
        if options.apertures:
            rows += [f"{level},{row}" for row in asked_of_apertures(options.first, options.count)]
            continue
        found = asked(options.first, options.count, averages=options.averages)
        rows += [f"{level},{index},{1e6 * chords:.1f},{1e6 * series:.1f}" for chords, series, _, index in found]
    if options.write:
        file, name = Path(options.write[0]), options.write[1]
        header, *others = file.read_text(encoding="utf-8").splitlines()
        kept = [
            line for line in others if not line.startswith(f"{name},") or (",aperture " in line) != options.apertures
        ]
        lines = [header, *kept, *(f"{name},{row}" for row in rows)]
        file.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
