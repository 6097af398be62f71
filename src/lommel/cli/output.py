"""What the commands print and write: reports, tables and figures."""

from __future__ import annotations

import errno
import json
import os
import sys
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import click

from lommel.base import atomic, optional
from lommel.base.validation import shown

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from rich.console import RenderableType
    from rich.table import Table

Facts: TypeAlias = dict[str, Any]
"""Plain data as JSON has it: texts, numbers, lists and dictionaries of these, None."""


@dataclass(frozen=True)
class Report:
    """What a command has found: the facts that ``--json`` prints, and lines and tables that say the same."""

    facts: Facts
    parts: Sequence[RenderableType]

    def __add__(self, other: Report) -> Report:
        return Report(self.facts | other.facts, [*self.parts, *other.parts])

    def print(self, *, as_json: bool = False) -> None:
        """Print the facts as JSON, or the parts, on standard output."""
        if as_json:
            click.echo(json.dumps(self.facts, indent=2, allow_nan=False))
            return
        from rich.console import Console

        # A pipe has no width; tables are then as wide as they need to be. Brackets in names are no markup.
        width = None if sys.stdout.isatty() else 160
        console = Console(width=width, markup=False, emoji=False, highlight=False)
        for part in self.parts:
            if isinstance(part, str):  # which is not wrapped, for programs to read
                click.echo(part)
            else:
                console.print(part)


def written(paths: Iterable[Path | None], note: Callable[[Path], str] = lambda _: "") -> Report:
    """Return the report of the files that were written, each with a note."""
    files = [path for path in paths if path is not None]
    return Report({"files": [str(path) for path in files]}, [f"wrote {path}{note(path)}" for path in files])


def table_of(
    names: Iterable[str],
    rows: Iterable[Sequence[str]],
    left: int = 0,
    no_wrap: bool = False,
    title: str | None = None,
) -> Table:
    """Return a table with columns of these names, numbers but for the column at `left`, which holds words."""
    from rich.table import Column, Table

    columns = [
        Column(name, justify="left" if place == left else "right", no_wrap=no_wrap)
        for place, name in enumerate(names)
    ]
    table = Table(*columns, box=None, pad_edge=False, title=title, title_justify="left")
    for row in rows:
        table.add_row(*row)
    return table


def list_of(rows: Iterable[tuple[str, str | None]], title: str = "") -> Table:
    """Return a table of names and values, without the names that have no value."""
    from rich.table import Column, Table

    columns = Column(style="cyan"), Column()
    table = Table(*columns, box=None, pad_edge=False, title=title, title_justify="left", show_header=False)
    for name, value in rows:
        if value is not None:
            table.add_row(name, value)
    return table


def figure_format(path: Path) -> str:
    """Return the format of a figure by its suffix; an error where it cannot be drawn or written."""
    suffix = path.suffix.lower().lstrip(".")
    if suffix not in ("png", "pdf", "svg"):
        raise ValueError(f"a figure must end in .png, .pdf or .svg, got {shown(str(path))}")
    optional.require("matplotlib", "plots need", "plot")
    require_folder(path)
    return suffix


def require_folder(path: Path) -> None:
    """Raise FileNotFoundError if the folder of a file does not exist, before any file is written."""
    if not path.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(path))


def save_figure(figure: Figure, path: Path) -> None:
    """Write a figure."""
    atomic.write(path, atomic.contents(figure.savefig, format=figure_format(path), dpi=150))
