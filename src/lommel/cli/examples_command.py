"""The command ``lommel examples``: list and copy example files: lenses, objectives and exercises for class."""

from __future__ import annotations

import errno
import json
from pathlib import Path

import click
from rich.table import Column, Table

from lommel.base import atomic
from lommel.base.validation import shown
from lommel.cli.example_files import KINDS, files
from lommel.cli.options import JSON, Option, command
from lommel.cli.output import Report, written
from lommel.lensfiles import toml_files


@command(
    click.Argument(["names"], nargs=-1),
    Option("-o", "--output", "folder", default=".", type=click.Path(file_okay=False, path_type=Path),
           show_default="current folder", help="Folder to copy to, created if needed."),
    Option("--all", "everything", is_flag=True, help="Copy all examples."),
    JSON,
)  # fmt: skip
def examples(names: tuple[str, ...], folder: Path, everything: bool) -> Report:
    """List or copy example lenses, objectives and exercises.

    NAMES are the names of the files to copy. Exercises are notebooks; the lens and objective files describe real
    instruments and state the source of their numbers. Existing files are not overwritten: unchanged copies are
    left alone, and files that differ are refused.

    Examples
    --------
      lommel examples                      # list them
      lommel examples phone                # copy phone.toml to the current folder
      lommel examples exercises            # a Jupyter notebook for class
      lommel examples --all -o lenses
    """
    there = files()
    if not names and not everything:
        columns = Column("name", no_wrap=True), Column("kind", no_wrap=True), "description"
        table = Table(*columns, box=None, pad_edge=False)
        rows = []
        for name, path in there.items():
            kind, what = KINDS[path.parent.name][0], _title(path)
            rows.append({"name": name, "kind": kind, "what": what})
            table.add_row(name, kind, what)
        return Report({"examples": rows}, [table])
    wanted = list(there) if everything else [name.removesuffix(".toml").removesuffix(".ipynb") for name in names]
    for name in wanted:
        if name not in there:
            raise ValueError(f"NAMES must be among {', '.join(there)}, got {shown(name)}")
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


def _title(path: Path) -> str:
    """Return the name in a lens or objective file, or the heading of a notebook."""
    if path.suffix == ".toml":
        return str(toml_files.parsed(path)[1]["name"])
    heading: str = json.loads(path.read_bytes())["cells"][0]["source"][0]
    return heading.lstrip("# ").rstrip()
