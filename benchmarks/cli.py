"""The command line: which tables, how thoroughly, where the results go, and on what machine they were measured."""

from __future__ import annotations

import argparse
import datetime as dt
import json
import os
import platform
import sys
import time
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

from benchmarks import (
    camera,
    costs,
    features,
    fields,
    localization,
    microscopes,
    paper,
    peers,
    processes,
    report,
    targets,
)
from benchmarks.contenders import copy, fft
from benchmarks.peers import peer_versions
from benchmarks.report import Table, show
from benchmarks.timing import Settings, race

ROOT = Path(__file__).resolve().parent.parent
_FIRST, _SECOND = ROOT / "benchmarks" / "results.json", ROOT / "benchmarks" / "second.json"

TABLES: dict[str, Callable[[Settings], Table]] = {
    "targets": targets.targets,
    "camera": camera.camera,
    "sizes": paper.sizes,
    "paper": paper.paper,
    "costs": costs.costs,
    "physical": costs.physical,
    "changes": costs.changes,
    "aberrations": costs.aberrations,
    "tolerances": costs.tolerances,
    "accuracy": costs.accuracy,
    "numpy": costs.numpy,
    "stacks": costs.stacks,
    "features": features.features,
    "apertures": features.apertures,
    "seeing": features.seeing,
    "microscopes": microscopes.microscopes,
    "localization": localization.localization,
    "beads": microscopes.beads,
    "fields": fields.fields,
    "threads": costs.threads,
    "instructions": processes.limited,
    "cold": processes.cold,
    "peers": peers.images,
    "peers-nonradial": peers.nonradial,
    "peers-stack": peers.stacks,
}


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
        options.only = report.WITH_SECOND
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
    missed = [row for table in done for row in targets.missed(table)]
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
    results, second = (json.loads(path.read_text(encoding="utf-8")) for path in (_FIRST, _SECOND))
    docs = ROOT / "docs"
    docs.mkdir(exist_ok=True)
    (docs / "benchmarks.md").write_text(report.write(results, second), encoding="utf-8")
    tables = {table["key"]: table for table in results["tables"]}
    report.draw(tables["sizes"], docs / "benchmarks.png", results["machine"])
    report.draw_costs(tables["costs"], docs / "benchmarks-costs.png")


def describe() -> dict[str, Any]:
    """Return processor, system, versions, and two yardsticks in microseconds."""
    build = np.show_config(mode="dicts")
    blas = build.get("Build Dependencies", {}).get("blas", {}) if isinstance(build, dict) else {}
    yards = race([fft(), copy((512, 512), np.float64)], 15, keep=False)
    return {
        "processor": processor(),
        "processors in use": _processors(),
        "memory": f"{_memory_gib():.0f} GiB",
        "system": f"{platform.system()}, {platform.machine()}",
        "versions": {
            "Python": platform.python_version(),
            "lommel": version("lommel"),
            "NumPy": np.__version__,
            "SciPy": version("scipy"),
            "BLAS": f"{blas.get('name', 'unknown')} {blas.get('version', '')}".strip(),
        }
        | peer_versions(),
        "yardsticks": {name: 1e6 * yards.median(name) for name in yards.seconds},
    }


def processor() -> str:
    """Return the name of the processor, with its family and model: names such as AMD EPYC stand for several."""
    try:
        first, *_ = Path("/proc/cpuinfo").read_text().split("\n\n")
    except OSError:
        first = ""
    parts = (line.partition(":") for line in first.splitlines())
    known = {name.strip(): " ".join(value.split()) for name, _, value in parts}
    if "model name" not in known:
        return platform.processor() or platform.machine()
    which = ", ".join(f"{name.split()[-1]} {known[name]}" for name in ("cpu family", "model") if name in known)
    name = known["model name"].replace("(R)", "").replace("(TM)", "").removesuffix(" Processor")
    return f"{name} ({which})" if which else name


def _processors() -> int:
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _memory_gib() -> float:
    try:
        return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / 2**30
    except (AttributeError, ValueError, OSError):
        return float("nan")


def clean(text: str) -> str:
    """Take the names of folders and of the host out of a text, wherever a message brought them in."""
    private = {str(ROOT): "…", sys.prefix: "…", str(Path.home()): "~", platform.node(): "host"}
    for name, instead in private.items():
        if len(name) > 3:
            text = text.replace(name, instead)
    return text
