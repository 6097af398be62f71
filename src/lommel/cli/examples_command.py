"""The command for files to begin with: ``lommel examples``."""

from __future__ import annotations

import errno
from pathlib import Path

import click

from lommel.base.validation import shown
from lommel.cli.parts import one_line_errors, print_json


@click.command()
@click.argument("names", nargs=-1)
@click.option("-o", "--output", "folder", default=".", type=click.Path(file_okay=False, path_type=Path),
              show_default="this one", help="Folder to copy to; made if it is not there.")  # fmt: skip
@click.option("--all", "everything", is_flag=True, help="Copy all of them.")
@click.option("--json", "as_json", is_flag=True, help="Print the table, or what was written, as JSON.")
@one_line_errors
def examples(names: tuple[str, ...], folder: Path, everything: bool, as_json: bool) -> None:
    """List files of real lenses and objectives, to begin with; or copy those of these NAMES.

    Each says where its figures come from. A file that is there is not written over.

    \b
    Examples:
      lommel examples                      # what there is
      lommel examples phone                # copies phone.toml here
      lommel examples --all -o lenses
    """  # noqa: D301 (\b is meant)
    from lommel.base import atomic
    from lommel.cli import tables
    from lommel.lensfiles import examples as known

    there = known.files()
    if not names and not everything:
        rows = [
            {"name": name, "kind": known.KINDS[path.parent.name], "what": known.title(path)}
            for name, path in there.items()
        ]
        if as_json:
            print_json({"examples": rows})
        else:
            tables.print_examples(rows)
        return
    wanted = list(there) if everything else [name.removesuffix(".toml") for name in names]
    for name in wanted:
        if name not in there:
            raise ValueError(f"NAMES must be among {', '.join(there)}, got {shown(name)}")
    written = [folder / there[name].name for name in wanted]
    for path in written:
        if path.exists():
            raise FileExistsError(errno.EEXIST, "is there already", str(path))
    folder.mkdir(parents=True, exist_ok=True)
    with atomic.together() as put:
        for name, path in zip(wanted, written, strict=True):
            put(path, there[name].read_bytes())
    if as_json:
        print_json({"files": [str(path) for path in written]})
        return
    for path in written:
        click.echo(f"wrote {path}")
