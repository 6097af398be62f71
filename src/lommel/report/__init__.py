"""Reports on lenses, microscopes and PSFs: facts for JSON, and lines and tables that say the same."""

from __future__ import annotations

import json
import math
import os
import re
import sys
import textwrap
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from lommel.base.arrays import Json

if TYPE_CHECKING:
    from rich.console import Console, ConsoleOptions, RenderableType
    from rich.table import Table
    from rich.text import Text


Parts: TypeAlias = "list[RenderableType]"
"""Lines and tables of a report."""

Facts: TypeAlias = Json
"""Plain data as JSON has it: texts, numbers, lists and dictionaries of these, None."""


@dataclass(frozen=True)
class Report:
    """Result of a command: facts, which ``--json`` prints, and lines and tables that say the same.

    The exit code is 3 where a result is not to be trusted or not whole: a fit that did not converge, a data set
    without some of its pictures.
    """

    facts: Facts
    parts: Sequence[RenderableType]
    converged: bool = True

    def __add__(self, other: Report) -> Report:
        both = self.converged and other.converged
        return Report(self.facts | other.facts, [*self.parts, *other.parts], both)

    def print(self, *, as_json: bool = False) -> None:
        """Print the facts as JSON, or the parts, on standard output."""
        import click  # late: image quality without the command line does not need it

        if as_json:
            click.echo(json.dumps(self.facts, indent=2, allow_nan=False))
            return
        from rich.console import Console

        # A pipe has no width; tables are then as wide as they need to be. Brackets in names are no markup.
        width = None if sys.stdout.isatty() or "COLUMNS" in os.environ else 160
        console = Console(width=width, markup=False, emoji=False, highlight=False)
        with console.capture() as captured:
            for part in self.parts:
                if isinstance(part, str):
                    console.print(Wrapped(part), crop=False)  # paths stay whole
                else:
                    console.print(part)
        # Tables fill their columns with blanks.
        click.echo(re.sub(r" +$", "", captured.get(), flags=re.MULTILINE), nl=False)


@dataclass(frozen=True)
class Wrapped:
    """A line that is broken between words only, with the rest indented."""

    text: str
    style: str = ""

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> Iterator[Text]:
        from rich.text import Text

        lines = textwrap.wrap(
            self.text, options.max_width, subsequent_indent="  ", break_long_words=False, break_on_hyphens=False
        )
        # Words longer than a line, as paths are, stay whole.
        yield from (Text(line, self.style, no_wrap=True, overflow="ignore") for line in lines or [""])


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


def paragraphs(*parts: Iterable[RenderableType]) -> Parts:
    """Return parts with a blank line between those that hold something."""
    found: Parts = []
    for part in map(list, parts):
        found += ["", *part] if found and part else part
    return found


def refused(facts: Facts) -> Parts:
    """Return the reasons why some results are missing."""
    return [Wrapped(f"not computed: {reason}", "dim") for reason in facts["refused"]]


def finite(distance: float) -> float | str:
    """Return a distance as JSON can hold it."""
    return distance if math.isfinite(distance) else "infinity"
