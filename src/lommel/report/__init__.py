"""Reports on lenses, microscopes and PSFs: results as plain data (facts, for JSON) and as printed text and tables."""

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
"""Lines of text and tables of a report, in the order of printing."""

Facts: TypeAlias = Json
"""Data that JSON can represent: strings, numbers, None, and lists and dictionaries of such values."""


@dataclass(frozen=True)
class Report:
    """Result of a command: facts, which ``--json`` prints, and lines and tables with the same content.

    `succeeded` is False if the result is wrong or incomplete, such as a fit that did not converge or a data set
    without some of its pictures.
    """

    facts: Facts
    parts: Sequence[RenderableType]
    succeeded: bool = True

    def __add__(self, other: Report) -> Report:
        succeeded = self.succeeded and other.succeeded
        return Report(self.facts | other.facts, [*self.parts, *other.parts], succeeded)

    @property
    def exit_code(self) -> int:
        """Exit code of the command: 3 if it did not succeed, 4 if its facts state that the result is not reliable."""
        if not self.succeeded:
            return 3
        return 4 if self.facts.get("reliable") is False else 0

    def print(self, *, as_json: bool = False) -> None:
        """Print the facts as JSON, or the parts, on standard output."""
        if as_json:
            print(json.dumps(self.facts, indent=2, allow_nan=False))
            return
        from rich.console import Console

        # A pipe has no width: 160 columns are enough for all tables. Brackets in names are not markup.
        width = None if sys.stdout.isatty() or "COLUMNS" in os.environ else 160
        console = Console(width=width, markup=False, emoji=False, highlight=False)
        with console.capture() as captured:
            for part in self.parts:
                if isinstance(part, str):
                    console.print(Wrapped(part), crop=False)  # do not cut long paths
                else:
                    console.print(part)
        # Remove the blanks with which tables fill their columns.
        print(re.sub(r" +$", "", captured.get(), flags=re.MULTILINE), end="")


@dataclass(frozen=True)
class Wrapped:
    """A text that is broken into lines between words only, with all lines but the first indented."""

    text: str
    style: str = ""

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> Iterator[Text]:
        from rich.text import Text

        lines = textwrap.wrap(
            self.text, options.max_width, subsequent_indent="  ", break_long_words=False, break_on_hyphens=False
        )
        # Do not break words longer than a line, such as paths.
        yield from (Text(line, self.style, no_wrap=True, overflow="ignore") for line in lines or [""])


def table_of(
    names: Iterable[str], rows: Iterable[Sequence[str]], left: Iterable[int] = (0,), title: str | None = None
) -> Table:
    """Return a table with a title and named columns, right-aligned except for the columns of the indices `left`."""
    from rich.table import Column, Table

    columns = [Column(name, justify="left" if k in left else "right") for k, name in enumerate(names)]
    table = Table(*columns, box=None, pad_edge=False, title=title, title_justify="left")
    for row in rows:
        table.add_row(*row)
    return table


def list_of(rows: Iterable[tuple[str, str]]) -> Table:
    """Return a table of names and values."""
    table = table_of(("", ""), rows, (0, 1))
    table.show_header, table.columns[0].style = False, "cyan"
    return table


def finite(distance: float) -> float | str:
    """Return a distance for JSON, "infinity" if it is infinite."""
    return distance if math.isfinite(distance) else "infinity"
