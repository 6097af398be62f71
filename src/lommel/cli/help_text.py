"""Layout of help: paragraphs, sections of two columns, and examples."""

from __future__ import annotations

import re
import shutil
import textwrap
from collections.abc import Iterable

_LABEL, _HELP, _EXAMPLE = 28, 100, 76  # largest widths of the column of options, of the help, of lines of examples


def width() -> int:
    """Return the width of the help."""
    return min(shutil.get_terminal_size().columns, _HELP)


def paragraphs(text: str) -> str:
    """Return a text whose paragraphs are wrapped."""
    return "\n\n".join(textwrap.fill(part, width(), break_on_hyphens=False) for part in text.split("\n\n"))


def section(title: str, rows: Iterable[tuple[str, str]]) -> str:
    """Return a heading, and labels with their texts in two columns."""
    rows, lines = list(rows), [f"{title}:"]
    indent = 2 + min(max(len(label) for label, _ in rows), _LABEL) + 2
    for label, text in rows:
        fits = len(label) <= indent - 4
        lines += [] if fits else [f"  {label}"]
        first = f"  {label}".ljust(indent) if fits else " " * indent
        lines += textwrap.wrap(
            text, width(), initial_indent=first, subsequent_indent=" " * indent, break_on_hyphens=False
        ) or [first.rstrip()]
    return "\n".join(lines)


def examples(rows: str) -> str:
    """Return the section of examples; lines wider than the help at 80 columns are continued before an option."""
    return "Examples:\n" + "\n".join(map(continued, rows.rstrip().split("\n")))


def continued(row: str) -> str:
    """Return a command, indented by two blanks, of which lines wider than the help are continued before an option."""
    if not row.startswith("  lommel ") or len(row) <= _EXAMPLE:
        return row
    rows, current = [], ""
    for word in re.split(r" (?=-[-a-zA-Z])", row):
        if current and len(f"{current} {word} \\") > _EXAMPLE:
            rows.append(f"{current} \\")
            current = f"      {word}"
        else:
            current = f"{current} {word}" if current else word
    return "\n".join([*rows, current])
