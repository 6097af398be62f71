"""Text files: the cells of CSV tables, and errors named by key and line, all of a file at once."""

from __future__ import annotations

import csv
import io
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import lru_cache
from pathlib import Path

from lommel.base.validation import brief, key, line

TOLD = 12
"""Maximum number of errors of a file in one message."""


def rows(text: str, between: str = ",") -> Iterator[tuple[int, list[str]]]:
    """Yield the number and the cells of each line that is neither empty nor a comment (``#``)."""
    for place, text_line in enumerate(io.StringIO(text), 1):  # not all of them at once: the text may be long
        try:
            quoted = '"' in text_line or len(text_line) > csv.field_size_limit()
            cells = next(csv.reader([text_line], delimiter=between), []) if quoted else text_line.split(between)
        except csv.Error as error:  # a quote without an end
            raise ValueError(f"{error} in line {place}") from None
        cells = list(map(str.strip, cells))
        if any(cells) and not text_line.lstrip().startswith("#"):
            yield place, cells


def settings(text: str) -> Iterator[tuple[int, str, str]]:
    """Yield the line, the name and the value of each comment such as ``# unit: nm``."""
    for place, text_line in enumerate(io.StringIO(text), 1):
        comment, colon, value = text_line.partition(":")
        if colon and comment.lstrip().startswith("#"):
            yield place, comment.strip().removeprefix("#").strip(), value.strip()


def number(text: str) -> float | str:
    """Return the number in a cell, or its text, for the error message."""
    try:
        return float(text)
    except ValueError:
        return text


def line_of(text: str, keys: Sequence[str]) -> int | None:
    """Return the number of the line of a TOML file that sets `keys`, if it is written in the usual way."""
    return _lines(text).get(tuple(keys))


@lru_cache(maxsize=2)
def _lines(text: str) -> dict[tuple[str, ...], int]:
    found: dict[tuple[str, ...], int] = {}
    numbers: Counter[tuple[str, ...]] = Counter()
    section: tuple[str, ...] = ()
    for number, written in enumerate(text.splitlines(), 1):
        if header := re.match(r"\s*\[(\[?)\s*([\w.\"-]+)\s*\]", written):
            section = tuple(header[2].replace('"', "").split("."))
            found.setdefault(section, number)
            if header[1]:  # a table of an array, counted
                numbers[section] += 1
                section = (*section, str(numbers[section] - 1))
                found.setdefault(section, number)
        elif entry := re.match(r"\s*(\"[^\"]*\"|[\w-]+)\s*=", written):
            found.setdefault((*section, entry[1].strip('"')), number)
    return found


def nearest_line(text: str, keys: Sequence[str]) -> int | None:
    """Return the number of the line that sets `keys`, or of the surrounding table where these have none."""
    lines = (line_of(text, keys[:count]) for count in range(len(keys), 0, -1))
    return next((number for number in lines if number), None)


def place(text: str, keys: Sequence[str]) -> str:
    """Return ``"lens.wavelength (line 8)"``, with the line of the surrounding table where a key has none."""
    number = nearest_line(text, keys)
    return f"{'.'.join(map(key, keys))}{f' (line {number})' if number else ''}"


def together(path: Path, errors: Sequence[str], count: int | None = None) -> str:
    """Return one message about the first errors of a file, on one line if there is one; `count` is the total."""
    count, shown = len(errors) if count is None else count, [line(error) for error in errors[:TOLD]]
    if count > TOLD:
        shown.append(f"and {count - TOLD} more")
    return f"{line(path)}: " + (shown[0] if count == 1 else "".join(f"\n  {error}" for error in shown))


MANY = 1000
"""Number of errors in a table after which the rest need not be read."""


def refuse(errors: Sequence[str]) -> None:
    """Raise ValueError with the first errors of a table, if there are any."""
    if errors:
        rest = len(errors) - TOLD
        more = f"; and {rest} {'or more' if len(errors) > MANY else 'more'}" if rest > 0 else ""
        raise ValueError("; ".join(brief(error, 200) for error in errors[:TOLD]) + more)
