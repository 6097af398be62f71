"""Results on measured and foreign data: ``python -m benchmarks.real_data`` writes docs/real-data.md.

The sets are those of real_data.toml. Pooch fetches each file by its public address, at a fixed commit and with a
checksum, into a cache outside the repository, or into the folder LOMMEL_REAL_DATA. Commands run as a user would type
them, in an empty folder. Numbers are kept in real_data.json: ``--only KEY`` measures one set and writes the whole
page, and ``--page`` writes it without measuring.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import argparse
import json
import math
import re
import resource
import shlex
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Iterable
from contextlib import chdir
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import quote

from benchmarks.real_sets import MEASURE, PREPARE, Facts, Row, linked

ROOT = Path(__file__).resolve().parent.parent
PAGE, PICTURES = ROOT / "docs" / "real-data.md", ROOT / "docs" / "real"
SOURCES, KEPT = (ROOT / "benchmarks" / f"real_data.{kind}" for kind in ("toml", "json"))
FOLDER = "LOMMEL_REAL_DATA"
LIMIT = 4.0
"""Standard errors beyond which a number is wrong, as in tests/world."""


class File(NamedTuple):
    """A file of a public repository at one commit."""

    repository: str
    commit: str
    path: str
    sha256: str

    @property
    def name(self) -> str:
        """Its place in the cache."""
        return f"{self.repository}/{self.path}"

    @property
    def url(self) -> str:
        """Its public address."""
        return f"https://raw.githubusercontent.com/{self.repository}/{self.commit}/{quote(self.path)}"


@dataclass(frozen=True)
class Set:
    """A set of real_data.toml, with the repositories of its files."""

    key: str
    title: str
    task: str
    unit: str
    data: str
    picture: str
    steps: list[str]
    says: list[str]
    files: dict[str, File]
    lenses: dict[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Result:
    """What came of a set; `said` are the first reasons of verdicts that are not good."""

    rows: list[Row]
    statuses: list[str]
    reliable: bool
    said: list[str] = field(default_factory=list)
    seconds: float = math.nan

    @property
    def worst(self) -> float:
        """The largest error in standard errors, of rows that state one; nan of none."""
        return max((abs(row.off) for row in self.rows if math.isfinite(row.off)), default=math.nan)

    @property
    def is_wrong_and_good(self) -> bool:
        """Whether a verdict was good and a number is off by more than LIMIT standard errors, or has none."""
        return self.reliable and not all(abs(row.off) <= LIMIT for row in self.rows)


def load() -> list[Set]:
    """Return the sets of real_data.toml, links to repositories written out."""
    told = tomllib.loads(SOURCES.read_text(encoding="utf-8"))
    places = {key: (one["name"], one["commit"]) for key, one in told["repositories"].items()}

    def address(link: re.Match[str]) -> str:
        name, commit = places[link[1]]
        return f"](https://github.com/{name}/tree/{commit})"

    sets = []
    for one in told["set"]:
        files = {name: File(*places[key], path, digest) for name, (key, path, digest) in one["files"].items()}
        lenses = {name: text.lstrip("\n") for name, text in one.get("lenses", {}).items()}
        steps = [step.strip() for step in one["steps"]]
        data = re.sub(r"\]\((\w+)\)", address, one["data"])
        sets.append(Set(**one | {"data": data, "steps": steps, "files": files, "lenses": lenses}))
    return sets


def fetched(files: Iterable[File]) -> list[Path]:
    """Return the places of files in the cache, where they are fetched to if they are not there."""
    try:
        import pooch
    except ImportError:
        raise SystemExit("real_data: pooch fetches the data: make .venv/real.stamp installs it") from None
    files = list(files)
    cache = pooch.create(
        path=pooch.os_cache("lommel-real-data"),
        base_url="",
        registry={one.name: one.sha256 for one in files},
        urls={one.name: one.url for one in files},
        env=FOLDER,
    )
    places = []
    for one in files:
        try:
            places.append(Path(cache.fetch(one.name)))
        except (OSError, ValueError) as error:  # no network, or another content
            raise SystemExit(
                f"real_data: {one.url} cannot be fetched ({error}); offline, set {FOLDER} to a folder that has "
                f"{one.name}"
            ) from None
    return places


def command(line: str) -> Facts:
    """Run a command of the package in the current folder, and return what it prints with --json."""
    words = shlex.split(line.replace("\\\n", " "))
    program = Path(sys.executable).parent / words[0]
    done = subprocess.run(
        [str(program), *words[1:], "--json"], capture_output=True, encoding="utf-8", check=False, env=_environment()
    )
    if done.returncode not in (0, 3, 4):
        text = " ".join(done.stderr.split()).removeprefix("Error: ")
        return {"status": "refused", "reliable": False, "findings": [{"severity": "error", "text": text}]}
    return dict(json.loads(done.stdout))


def _environment() -> dict[str, str]:
    return os.environ | {"MPLBACKEND": "Agg", "PYTHONUTF8": "1"}


def code(text: str) -> Facts:
    """Run Python code in the current folder, and return its names."""
    names: Facts = {}
    exec(compile(text, "real-data.md", "exec"), names)
    found = names["found"]
    facts = {name: getattr(found, name) for name in ("status", "reliable")}
    findings = [{"severity": one.severity, "text": one.text} for one in found.findings]
    return names | facts | {"findings": findings}


def measured(one: Set, pictures: Path | None) -> Result:
    """Fetch the files of a set, run its steps in an empty folder, and compare; keep the picture in a folder."""
    places = dict(zip(one.files, fetched(one.files.values()), strict=True))
    start = _seconds()
    with tempfile.TemporaryDirectory() as empty, chdir(empty):
        PREPARE.get(one.key, linked)(places)
        for name, text in one.lenses.items():
            Path(name).write_text(text, encoding="utf-8")
        facts = [(command if step.startswith("lommel ") else code)(step) for step in one.steps]
        took = _seconds() - start
        rows = list(MEASURE[one.key](facts))
        if pictures is not None and Path(one.picture).exists():
            shrink(Path(one.picture), pictures / f"{one.key}.png")
    return judged(rows, facts, took)


def judged(rows: list[Row], facts: list[Facts], seconds: float = math.nan) -> Result:
    """Return what rows and the verdicts of commands amount to; results without a verdict count as good."""
    verdicts = [fact for fact in facts if "status" in fact]
    said = []
    for fact in verdicts:
        grave = [one for one in fact.get("findings", ()) if one["severity"] in ("error", "doubt")]
        said += [brief(one["text"]) for one in sorted(grave, key=lambda one: one["severity"] != "error")[:1]]
    statuses = list(dict.fromkeys(str(fact["status"]) for fact in verdicts))
    return Result(
        rows, statuses, not verdicts or any(fact["reliable"] for fact in verdicts), list(dict.fromkeys(said)), seconds
    )


def brief(text: str) -> str:
    """Return the first clause of a finding, of at most 160 characters."""
    clause = text.partition("; ")[0]
    return clause if len(clause) <= 160 else f"{clause[:160].rpartition(' ')[0].rstrip(',:')} ..."


def _seconds() -> float:
    """Return the processor time of this process and of those that it ran."""
    return sum(sum(resource.getrusage(whose)[:2]) for whose in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))


def shrink(source: Path, target: Path) -> None:
    """Write a figure as a PNG of 64 colours, at most 800 pixels across, or 1100 where it is wide and low."""
    from PIL import Image

    with Image.open(source) as figure:
        plain = figure.convert("RGB")
    width = min(plain.width, 1100 if plain.width > 2 * plain.height else 800)
    plain = plain.resize((width, round(plain.height * width / plain.width)), Image.Resampling.LANCZOS)
    target.parent.mkdir(exist_ok=True)
    plain.quantize(64, dither=Image.Dither.NONE).save(target, optimize=True)


def number(value: float, error: float = math.nan) -> str:
    """Write a number with as many decimals as give its error two digits, or with four digits."""
    if not math.isfinite(value):
        return "–"
    if not (math.isfinite(error) and error > 0.0):
        return f"{value:.4g}"
    decimals = max(0, 1 - math.floor(math.log10(error)))
    return f"{value:.{decimals}f}"


def table(result: Result, unit: str) -> list[str]:
    """Return the rows of a set in Markdown."""
    lines = [f"| {unit} | reference | lommel | off / standard error |", "|---|---:|---:|---:|"]
    for row in result.rows:
        error = f" ± {number(row.error, row.error)}" if math.isfinite(row.error) else ""
        off = f"{row.off:.1f}" if math.isfinite(row.off) else "–"
        lines.append(
            f"| {row.what} | {number(row.reference, row.error)} | {number(row.value, row.error)}{error} | {off} |"
        )
    return lines


_MEANS = {
    "converged": "good",
    "doubtful": "in doubt",
    "no_light": "refused",
}


def verdict(result: Result) -> str:
    """Return the verdicts in words; without one a result counts as good."""
    return (
        ", ".join(dict.fromkeys(_MEANS.get(status, status.replace("_", " ")) for status in result.statuses))
        or "none, counts as good"
    )


def summary(sets: Iterable[Set], results: dict[str, Result]) -> list[str]:
    """Return the headline, which counts every set, and the table of all."""
    lines, done = [], [(one, results[one.key]) for one in sets if one.key in results]
    for one, result in done:
        anchor = one.title.lower().replace(" ", "-").replace(",", "").replace(".", "").replace("/", "")
        worst = f"{result.worst:.1f}" if math.isfinite(result.worst) else "–"
        lines.append(
            f"| [{one.title}](#{anchor}) | {one.task} | {len(result.rows)} | {worst} | {verdict(result)} "
            f"| {'**yes**' if result.is_wrong_and_good else 'no'} |"
        )
    wrong = sum(result.is_wrong_and_good for _, result in done)
    good = sum(result.reliable for _, result in done)
    numbers = sum(len(result.rows) for _, result in done)
    beyond = sum(result.worst > LIMIT for _, result in done)
    head = (
        f"{len(done)} sets, {numbers} numbers: {good} called good, {wrong or 'none'} of them wrong. "
        f"In {beyond or 'none'} a number is off by more than four standard errors."
    )
    columns = "| data | task | numbers | largest error / standard error | verdict | wrong and good |"
    return [head, "", columns, "|---|---|---:|---:|---|---|", *lines]


def section(one: Set, result: Result) -> list[str]:
    """Return what the page says of a set."""
    blocks = []
    for step in one.steps:
        language = "sh" if step.startswith("lommel ") else "python"
        if blocks and language == blocks[-1][0] == "sh":
            blocks[-1][1].append(step)
        else:
            blocks.append((language, [step]))
    shown = [part for language, steps in blocks for part in (f"```{language}", *steps, "```", "")]
    said = [f"- lommel: {text}{'' if text.endswith('...') else '.'}" for text in result.said]
    picture = [f"![{one.title}: {one.task}](real/{one.key}.png)", ""]
    return [
        f"### {one.title}", "", one.data, "", *shown, *picture, *table(result, one.unit), "",
        *said, *([""] if said else []), " ".join(one.says), "",
    ]  # fmt: skip


_HEAD = """# Real data

<!-- Written by `python -m benchmarks.real_data` from benchmarks/real_data.json: do not edit this page. -->

<!-- index: ! real data, ! measured data -->

Measured data, and data that other programs made, with the numbers of another program or a known truth beside
lommel's. All other figures of these pages are of simulations ([the proving ground](trust.md)).
"""

_DETAILS = """## Details

The error of a number is its difference from the reference, over the standard error that lommel states. Wrong is an
error of more than four, or a number of a good result without a standard error, as on
[the page of simulations](trust.md). All commands took {minutes:.0f} minutes of one core.

`make real-data` fetches the {count} files, each with a checksum, into a cache outside the repository, runs the
commands and writes this page; without a network set `LOMMEL_REAL_DATA` to a folder that has them. None of these
files is part of this package.
"""


def page(sets: Iterable[Set], results: dict[str, Result]) -> str:
    """Return the page."""
    done = [one for one in sets if one.key in results]
    lenses = {name: text for one in done for name, text in one.lenses.items()}
    blocks = "\n\n".join(f"```toml\n# {name}\n{text}```" for name, text in lenses.items())
    minutes = sum(result.seconds for result in results.values()) / 60.0
    details = _DETAILS.format(minutes=minutes, count=sum(len(one.files) for one in done))
    sections = [line for one in done for line in section(one, results[one.key])]
    return "\n".join([_HEAD, *summary(done, results), "", details, *sections, "### Lens files", "", blocks, ""])


def kept() -> dict[str, Result]:
    """Return the results that are stored."""
    stored = json.loads(KEPT.read_text(encoding="utf-8")) if KEPT.exists() else {}
    return {
        key: Result(
            **each | {"rows": [Row(*(math.nan if part is None else part for part in row)) for row in each["rows"]]}
        )
        for key, each in stored.items()
    }


def keep(results: dict[str, Result]) -> None:
    """Store results, numbers with ten digits."""

    def plain(value: Any) -> Any:
        return value if isinstance(value, str) else float(f"{value:.10g}") if math.isfinite(value) else None

    stored = {
        key: vars(one) | {"rows": [[plain(part) for part in row] for row in one.rows], "seconds": round(one.seconds)}
        for key, one in results.items()
    }
    KEPT.write_text(json.dumps(stored, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def main() -> None:
    """Measure, and write the page."""
    sets = load()
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", action="append", choices=[one.key for one in sets], help="a set; may be repeated")
    parser.add_argument("--page", action="store_true", help="measure nothing, write the page from what is stored")
    given = parser.parse_args()
    results = kept()
    for one in sets:
        if not given.page and (not given.only or one.key in given.only):
            results[one.key] = measured(one, PICTURES)
            print(one.key, verdict(results[one.key]), *table(results[one.key], one.unit), sep="\n", flush=True)
            keep({each.key: results[each.key] for each in sets if each.key in results})
    PAGE.write_text(page(sets, results), encoding="utf-8")


if __name__ == "__main__":
    main()
