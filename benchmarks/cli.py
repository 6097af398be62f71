"""The command line: which tables, how thoroughly, and where the results go."""

from __future__ import annotations

import argparse
import datetime as dt
import json
import time
from collections.abc import Callable
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

from benchmarks import (
    apertures,
    beads,
    beside,
    camera,
    closed_forms,
    costs,
    features,
    fields,
    fresh,
    instructions,
    limits,
    localization,
    microscopes,
    page,
    peers,
    seeing,
    sizes,
    sweeps,
)
from benchmarks.machine import ROOT, clean, describe
from benchmarks.report import Table, show
from benchmarks.settings import Settings

TABLES: dict[str, Callable[[Settings], Table]] = {
    "targets": limits.run,
    "camera": camera.run,
    "sizes": sizes.run,
    "paper": closed_forms.run,
    "costs": costs.costs,
    "physical": costs.physical,
    "changes": beside.changes,
    "aberrations": sweeps.aberrations,
    "tolerances": sweeps.tolerances,
    "accuracy": sweeps.accuracy,
    "numpy": sweeps.numpy,
    "stacks": sweeps.stacks,
    "features": features.features,
    "apertures": apertures.apertures,
    "seeing": seeing.seeing,
    "microscopes": microscopes.microscopes,
    "localization": localization.localization,
    "beads": beads.table,
    "fields": fields.table,
    "threads": sweeps.threads,
    "instructions": instructions.limited,
    "cold": fresh.cold,
    "peers": peers.images,
    "peers-nonradial": peers.nonradial,
    "peers-stack": peers.stacks,
}

_FIRST, _SECOND = ROOT / "benchmarks" / "results.json", ROOT / "benchmarks" / "second.json"


def main() -> int:
    """Run what is asked for; return 1 if a target is missed."""
    parser = argparse.ArgumentParser(prog="benchmarks/run.py", description="Measure lommel beside other ways.")
    parser.add_argument("--quick", action="store_true", help="fewer cases, sizes and rounds: under a minute")
    parser.add_argument("--only", action="append", choices=TABLES, metavar="NAME", help="one table; may be repeated")
    parser.add_argument("--list", action="store_true", help="name the tables and end")
    parser.add_argument("--write", action="store_true", help="write benchmarks/results.json and docs/benchmarks.*")
    parser.add_argument(
        "--second",
        metavar="DESCRIPTION",
        help="of this machine: measure the tables that show a second one, and write them to benchmarks/second.json",
    )
    options = parser.parse_args()
    if options.list:
        print("\n".join(TABLES))
        return 0
    if (options.write or options.second) and (options.quick or options.only):
        parser.error("--write and --second need whole runs: neither --quick nor --only")
    if options.second:
        options.only = page.WITH_SECOND
    chosen = [name for name in TABLES if not options.only or name in options.only]
    console, start = Console(), time.monotonic()
    done = _run(chosen, quick=options.quick, console=console)
    console.print(f"{time.monotonic() - start:.0f} s")
    if options.write or options.second:
        path = _SECOND if options.second else _FIRST
        described = {"description": options.second} if options.second else {}
        _keep(path, described, done)
        _publish()
        written = f"{path.relative_to(ROOT)}, docs/benchmarks.md, docs/benchmarks.png, docs/benchmarks-costs.png"
        console.print(f"Written: {written}", highlight=False)
    missed = [row for table in done for row in limits.missed(table)]
    for row in missed:
        console.print(f"[bold red]MISSED[/] {row}", highlight=False)
    return 1 if missed else 0


def _run(chosen: list[str], *, quick: bool, console: Console) -> list[Table]:
    done = []
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task("", total=len(chosen))
        for name in chosen:

            def tick(now: str, name: str = name) -> None:
                progress.update(task, description=f"{name}: {now}"[:70].ljust(70))

            table = TABLES[name](Settings(quick=quick, tick=tick))
            show(console, table)
            done.append(table)
            progress.advance(task)
    return done


def _keep(path: Path, described: dict[str, str], done: list[Table]) -> None:
    plain = described | {
        "date": dt.datetime.now(tz=dt.UTC).date().isoformat(),
        "machine": describe(),
        "tables": [table.to_dict() for table in done],
    }
    path.write_text(clean(json.dumps(plain, indent=1, ensure_ascii=False)) + "\n", encoding="utf-8")


def _publish() -> None:
    """Write the page and its figures from the results that are kept."""
    from benchmarks import figure

    results, second = (json.loads(path.read_text(encoding="utf-8")) for path in (_FIRST, _SECOND))
    docs = ROOT / "docs"
    docs.mkdir(exist_ok=True)
    (docs / "benchmarks.md").write_text(page.write(results, second), encoding="utf-8")
    tables = {table["key"]: table for table in results["tables"]}
    figure.draw(tables["sizes"], docs / "benchmarks.png")
    figure.draw_costs(tables["costs"], docs / "benchmarks-costs.png")
