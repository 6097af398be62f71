"""The command ``lommel examples``: list and copy example files: lenses, objectives, cameras, exercises."""

from __future__ import annotations

import errno
import json
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.table import Column, Table
from rich.text import Text

from lommel.base import atomic
from lommel.base.options import near
from lommel.base.validation import shown
from lommel.cli.options import JSON, argument, command, option
from lommel.cli.output import Report, written
from lommel.lensfiles import toml_files

if TYPE_CHECKING:
    from rich.console import RenderableType
from lommel.lensfiles.example_files import KINDS, example_files


@command(JSON)
def examples(
    names: tuple[str, ...] = argument("names", nargs=-1),
    folder: Path = option("-o", "--output", default=".", type=click.Path(file_okay=False, path_type=Path),
        show_default="current folder", help="Folder to copy to, created if needed."),
    everything: bool = option("--all", is_flag=True, help="Copy all examples."),
    text: str | None = option("--find", metavar="TEXT",
        help='List only examples with these words in kind, name or description: "nikon water", "camera".'),
) -> Report:  # fmt: skip
    """List or copy example files of lenses, objectives, cameras.

    NAMES are the names of the files to copy. Notebooks are for Jupyter; the other files describe real instruments and
    state the source of their numbers. Cameras need no copy: --camera takes their names. Existing files are not
    overwritten: unchanged copies are left alone, and files that differ are refused.

    Examples
    --------
      lommel examples                      # list them
      lommel examples --find "nikon oil"   # those with both words
      lommel examples phone                # copy phone.toml to the current folder
      lommel examples exercises            # a Jupyter notebook for class
      lommel examples first-psf            # a notebook to start with
      lommel examples --all -o lenses
    """
    there = example_files()
    if text is not None and (names or everything):
        raise ValueError("--find lists examples: leave it out to copy them")
    if not names and not everything:
        return _listed(there, (text or "").lower().split())
    wanted = list(there) if everything else [name.removesuffix(".toml").removesuffix(".ipynb") for name in names]
    for name in wanted:
        if name not in there:
            raise ValueError(f"NAMES must be those of examples, got {shown(name)}; {_meant(name, there)}")
    copies = {folder / there[name].name: there[name].read_bytes() for name in wanted}
    present = [path for path in copies if path.exists()]
    for path in present:
        if path.is_dir() or path.read_bytes() != copies[path]:
            raise FileExistsError(errno.EEXIST, "File exists and differs from the example", str(path))
    folder.mkdir(parents=True, exist_ok=True)
    with atomic.together() as put:
        for path in copies.keys() - present:
            put(path, copies[path])
    report = written(path for path in copies if path not in present)
    return Report(report.facts, [*report.parts, *(f"{path} is already there, unchanged" for path in present)])


def _listed(there: dict[str, Path], words: list[str]) -> Report:
    """Return the list of the examples with all of these words, a table for each kind."""
    rows: list[dict[str, str]] = []
    tables: dict[str, Table] = {}
    for name, path in there.items():
        kind, what = KINDS[path.parent.name][0], _title(path)
        if not all(word in f"{kind} {name} {what}".lower() for word in words):
            continue
        rows.append({"name": name, "kind": kind, "what": what})
        columns = Column(width=max(map(len, there)), no_wrap=True), Column()
        tables.setdefault(kind, Table(*columns, box=None, pad_edge=False, show_header=False)).add_row(name, what)
    parts: list[RenderableType] = []
    for kind, table in tables.items():
        parts += [*([""] if parts else []), Text(_HEADINGS[kind], "bold"), table]
    return Report({"examples": rows}, parts or ["No example has these words."])


_HEADINGS = {"lens": "Lenses", "objective": "Objectives", "camera": "Cameras", "notebook": "Notebooks"}


def _meant(name: str, there: dict[str, Path]) -> str:
    """Return the example that a name was meant to be, or how to list them."""
    found = near(name, there)
    return found if found.startswith("did") else "`lommel examples` lists them"


def _title(path: Path) -> str:
    """Return the name in a lens or objective file, or the heading of a notebook."""
    if path.suffix == ".toml":
        return str(toml_files.parsed(path)[1]["name"])
    heading: str = json.loads(path.read_bytes())["cells"][0]["source"][0]
    return heading.lstrip("# ").rstrip()
