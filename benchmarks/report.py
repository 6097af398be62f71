"""Tables: plain data that is printed, written to JSON, and turned into a page."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from typing import Any

from benchmarks.timing import Spread


@dataclass
class Table:
    """Rows under headings.

    Attributes
    ----------
    key : str
        Short name, for ``--only``.
    title, about : str
        `about` is a paragraph of Markdown.
    columns : dict of str to str
        Headings, each with the format of its column: text, ratio, times, error or number.
    rows : list of dict
        A missing value means that there is nothing to say.
    notes : list of str
    """

    key: str
    title: str
    about: str
    columns: dict[str, str]
    rows: list[dict[str, Any]] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    def add(self, *values: Any) -> dict[str, Any]:
        """Append a row, in the order of the columns."""
        row = {
            name: asdict(value) if isinstance(value, Spread) else value
            for name, value in zip(self.columns, values, strict=True)
            if value is not None
        }
        self.rows.append(row)
        return row

    def cells(self) -> list[list[str]]:
        """Return the rows as text."""
        return [
            [_FORMATS[kind](row[name]) if name in row else "–" for name, kind in self.columns.items()]
            for row in self.rows
        ]

    def to_dict(self) -> dict[str, Any]:
        """Return everything in plain types."""
        return asdict(self)


def number(value: float) -> str:
    """Write a number with two or three digits."""
    if not math.isfinite(value):
        return "–"
    if value >= 100:
        return f"{value:,.0f}".replace(",", " ")
    return f"{value:.3g}" if value < 1 else f"{value:.1f}"


def _median(value: float | dict[str, Any]) -> str:
    return number(value["median"] if isinstance(value, dict) else value)


def _spread(value: float | dict[str, Any]) -> str:
    if not isinstance(value, dict):
        return number(value)
    return f"{number(value['median'])} ({number(value['low'])} to {number(value['high'])})"


def _error(value: float) -> str:
    return f"{value:.1e}" if math.isfinite(value) else "–"


_FORMATS: dict[str, Callable[[Any], str]] = {
    "text": str,
    "number": _median,
    "spread": _spread,
    "error": _error,
}


def markdown(table: Table) -> str:
    """Write a table as a section of a Markdown page."""
    lines = [f"## {table.title}", "", table.about, ""]
    if not table.rows:
        return "\n".join(lines)
    lines.append("| " + " | ".join(table.columns) + " |")
    lines.append("|" + "|".join("---" if kind == "text" else "---:" for kind in table.columns.values()) + "|")
    lines += ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in table.cells()]
    if table.notes:
        lines += ["", *(f"- {note}" for note in table.notes)]
    return "\n".join(lines) + "\n"


def show(console: Any, table: Table) -> None:
    """Print a table to a terminal."""
    from rich import box
    from rich.table import Table as RichTable

    styles = {"aim": "green", "must": "yellow", "MISSED": "bold red"}
    rich = RichTable(title=table.title, box=box.SIMPLE_HEAD, title_justify="left", title_style="bold")
    for name, kind in table.columns.items():
        rich.add_column(name, justify="left" if kind == "text" else "right", overflow="fold")
    for row in table.cells():
        rich.add_row(*(f"[{styles[cell]}]{cell}[/]" if cell in styles else _plain(cell) for cell in row))
    console.print(rich)
    for note in table.notes:
        console.print(f"  {_plain(note)}", style="dim", highlight=False)


def _plain(text: str) -> str:
    from rich.markup import escape

    return escape(text.replace("`", ""))
