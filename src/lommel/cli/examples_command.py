"""The command ``lommel examples``: list and copy the example files of lenses and objectives."""

from __future__ import annotations

import errno
from pathlib import Path

import click
from rich.table import Column, Table

from lommel.base import atomic
from lommel.base.validation import shown
from lommel.cli.options import JSON, Option, command
from lommel.cli.output import Report, written
from lommel.lensfiles import toml_files

_KINDS = {"lenses": "lens", "objectives": "objective"}


@command(
    click.Argument(["names"], nargs=-1),
    Option("-o", "--output", "folder", default=".", type=click.Path(file_okay=False, path_type=Path),
           show_default="current folder", help="Folder to copy to, created if needed."),
    Option("--all", "everything", is_flag=True, help="Copy all examples."),
    JSON,
)  # fmt: skip
def examples(names: tuple[str, ...], folder: Path, everything: bool) -> Report:
    """List example files of lenses and objectives, or copy them.

    NAMES are the names of the files to copy. The files describe real instruments and state the source of their
    numbers. Existing files are not overwritten.

    Examples
    --------
      lommel examples                      # list them
      lommel examples phone                # copy phone.toml to the current folder
      lommel examples --all -o lenses
    """
    there = files()
    if not names and not everything:
        columns = Column("name", no_wrap=True), Column("kind", no_wrap=True), "description"
        table = Table(*columns, box=None, pad_edge=False)
        rows = []
        for name, path in there.items():
            kind, what = _KINDS[path.parent.name], str(toml_files.parsed(path)[1]["name"])
            rows.append({"name": name, "kind": kind, "what": what})
            table.add_row(name, kind, what)
        return Report({"examples": rows}, [table])
    wanted = list(there) if everything else [name.removesuffix(".toml") for name in names]
    for name in wanted:
        if name not in there:
            raise ValueError(f"NAMES must be among {', '.join(there)}, got {shown(name)}")
    copies = [folder / there[name].name for name in wanted]
    for path in copies:
        if path.exists():
            raise FileExistsError(errno.EEXIST, "File exists", str(path))
    folder.mkdir(parents=True, exist_ok=True)
    with atomic.together() as put:
        for name, path in zip(wanted, copies, strict=True):
            put(path, there[name].read_bytes())
    return written(copies)


def files() -> dict[str, Path]:
    """Return the example files by their names without suffix, lenses first."""
    here = Path(__file__).resolve()
    # A wheel has them within the package; in the sources they stand at the top.
    for folder in (here.parents[1] / "examples", here.parents[3] / "examples"):
        found = [path for kind in _KINDS for path in sorted((folder / kind).glob("*.toml"))]
        if found:
            return {path.stem: path for path in found}
    raise FileNotFoundError(f"the examples are missing ({here.parents[1] / 'examples'}): wheels bring them")
