"""Run scenarios, print a table, write docs/trust.md: `python -m tests.world --seeds 25 -o runs.json`."""

from __future__ import annotations

import argparse
import json
import math
import os
import sys
import textwrap
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "shared"))

from tests.world.scenarios import SCENARIOS
from tests.world.verdicts import Judgement, Run, attempt, judge

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "trust.md"
BEGIN, END = "<!-- written by python -m tests.world: do not edit -->", "<!-- end -->"
BY_ROW = {scenario.row: scenario for scenario in SCENARIOS}
MUST = {"R": "right", "T": "told", "RT": "right or told", "N": "named"}


def runs_of(row: str, seeds: range) -> list[Run]:
    """Return the runs of a scenario."""
    return [attempt(BY_ROW[row], seed) for seed in seeds]


def judged(stored: dict[str, list[Run]]) -> Iterator[tuple[str, Judgement]]:
    """Yield rows and what their runs amount to."""
    return ((row, judge(BY_ROW[row], stored[row])) for row in BY_ROW if stored.get(row))


def line(row: str, one: Judgement) -> str:
    """Return a row of the table that is printed."""
    told = ", ".join(f"{code} {count}" for code, count in sorted(one.codes.items(), key=lambda pair: -pair[1])[:3])
    scenario = BY_ROW[row]
    return (
        f"{row:4} {scenario.estimator:10} {scenario.name[:44]:44} {scenario.must:2} {one.runs:4} {one.good:4} "
        f"{one.told:4} {one.wrong_and_good:4} {one.rms:6.2f} {one.largest:7.1f} {one.seconds:6.2f}  "
        f"{told[:60]:60} {'; '.join(one.faults)}"
    )


def page(stored: dict[str, list[Run]]) -> str:
    """Return the table of the page."""
    head = "| world | estimator | must be | runs | good | told | wrong and good | rms | largest | codes |"
    rows = [head, "|---|---|---|---:|---:|---:|---:|---:|---:|---|"]
    for row, one in judged(stored):
        scenario = BY_ROW[row]
        often = sorted(one.codes.items(), key=lambda pair: -pair[1])[:3]
        codes = ", ".join(f"`{code}`" for code, _ in often)
        rms, largest = (f"{size:.2f}" if math.isfinite(size) else "–" for size in (one.rms, one.largest))
        rows.append(
            f"| {scenario.name} | {scenario.estimator} | {MUST[scenario.must]} | {one.runs} | {one.good} "
            f"| {one.told} | {one.wrong_and_good} | {rms} | {largest} | {codes} |"
        )
    every = [(BY_ROW[row].must == "N", BY_ROW[row].name, one) for row, one in judged(stored)]
    runs, good = (sum(getattr(one, name) for _, _, one in every) for name in ("runs", "good"))
    named, wrong = (sum(one.wrong_and_good for is_named, _, one in every if is_named is n) for n in (True, False))
    other = sum(one.good for is_named, _, one in every if not is_named)
    twice = [name for is_named, name, one in every if not is_named and one.wrong_and_good > 1]
    first = (
        f"{runs} results of {len(every)} worlds: {good} called good, {wrong + named} of them wrong "
        f"({_percent(wrong + named, good)}).\n{named} of these are in rows *named*, whose results name it among what "
        f"they cannot test.\nOf {other} in the other rows {wrong} are wrong ({_percent(wrong, other)}), "
        + (f"twice or more in {', '.join(twice)}." if twice else "no world twice.")
    )
    rates = [f"{BY_ROW[row].name} ({one.rms:.2f})" for row, one in judged(stored) if "rms" in " ".join(one.faults)]
    second = f"Errors are not 0.8 to 1.15 standard errors, as far as the runs show, in {len(rates) or 'no'} worlds"
    second = textwrap.fill(f"{second}: {'; '.join(rates)}." if rates else f"{second}.", 138)
    return "\n\n".join((first, second, "\n".join(rows)))


def _percent(part: int, whole: int) -> str:
    return f"{100 * part / max(whole, 1):.2g} %"


def read(path: Path) -> dict[str, list[Run]]:
    """Return stored runs."""
    kept = json.loads(path.read_text(encoding="utf-8"))
    return {row: [Run(*run) for run in runs] for row, runs in kept.items()}


def write_page(stored: dict[str, list[Run]]) -> None:
    """Write the table of the page between its marks."""
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(BEGIN)
    after = rest.partition(END)[2]
    PAGE.write_text(f"{before}{BEGIN}\n\n{page(stored)}\n\n{END}{after}", encoding="utf-8")


def main() -> None:
    """Run what the command line asks for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=1, help="runs of each scenario")
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--only", action="append", help="an estimator or a row; may be repeated")
    parser.add_argument("--jobs", type=int, default=1, help="processes")
    parser.add_argument("-o", "--output", type=Path, help="keep the runs in a file .json, beside those that it has")
    parser.add_argument("--page", type=Path, help="write docs/trust.md from a file of runs that were kept")
    given = parser.parse_args()
    if given.page:
        write_page(read(given.page))
        return
    wanted = [one for one in SCENARIOS if not given.only or {one.row, one.estimator} & set(given.only)]
    seeds = range(given.first, given.first + given.seeds)
    kept = read(given.output) if given.output and given.output.exists() else {}
    print(f"{'row':4} {'estimator':10} {'world':44} {'':2} runs good told W&G     rms largest  CPU s  codes")
    with ProcessPoolExecutor(given.jobs) as pool:
        every = pool.map(runs_of, [one.row for one in wanted], [seeds] * len(wanted))
        for scenario, runs in zip(wanted, every, strict=True):
            old = [run for run in kept.get(scenario.row, []) if run.seed not in seeds]
            kept[scenario.row] = sorted([*old, *runs], key=lambda run: run.seed)
            print(line(scenario.row, judge(scenario, runs)), flush=True)
            if given.output:
                brief = {row: [run._replace(text=run.text[:300]) for run in runs] for row, runs in kept.items()}
                given.output.write_text(json.dumps(brief), encoding="utf-8")


if __name__ == "__main__":
    main()
