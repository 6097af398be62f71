"""Tables in CSV: their lines, and what stands in their cells."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator


def rows(text: str, between: str = ",") -> Iterator[tuple[int, list[str]]]:
    """Yield the number of each line and its cells; lines that are empty or begin with ``#`` are left out.

    ValueError if a cell has no end.
    """
    for place, line in enumerate(io.StringIO(text), 1):  # not all of them at once: the text may be long
        try:
            quoted = '"' in line or len(line) > csv.field_size_limit()
            cells = next(csv.reader([line], delimiter=between), []) if quoted else line.split(between)
        except csv.Error as error:  # of an endless cell
            raise ValueError(f"{error} in line {place}") from None
        cells = list(map(str.strip, cells))
        if any(cells) and not line.lstrip().startswith("#"):
            yield place, cells


def number(text: str) -> float | str:
    """Return the number that a cell holds; what is none stays as it is, to be told."""
    try:
        return float(text)
    except ValueError:
        return text
