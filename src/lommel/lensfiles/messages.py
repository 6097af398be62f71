"""How the faults of a file are told: with key and line, all at once."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path

from lommel.base.validation import key, line

TOLD = 12
"""How many faults of a file are told at once."""


def line_of(text: str, keys: Sequence[str]) -> int | None:
    """Return the number of the line of a TOML file that sets `keys`, where it is written in the plain way."""
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
            if header[1]:  # one of several, each with its number
                numbers[section] += 1
                section = (*section, str(numbers[section] - 1))
                found.setdefault(section, number)
        elif entry := re.match(r"\s*(\"[^\"]*\"|[\w-]+)\s*=", written):
            found.setdefault((*section, entry[1].strip('"')), number)
    return found


def place(text: str, keys: Sequence[str]) -> str:
    """Return ``"lens.wavelength (line 8)"``; the line is that of the table around it where a key has none."""
    lines = (line_of(text, keys[:count]) for count in range(len(keys), 0, -1))
    line = next((number for number in lines if number), None)
    return f"{'.'.join(map(key, keys))}{f' (line {line})' if line else ''}"


def together(path: Path, faults: Sequence[str], count: int | None = None) -> str:
    """Return one message about the first faults of a file, in one line if there is one; `count` is of all of them."""
    count, told = len(faults) if count is None else count, [line(fault) for fault in faults[:TOLD]]
    if count > TOLD:
        told.append(f"and {count - TOLD} more")
    return f"{line(path)}: " + (told[0] if count == 1 else "".join(f"\n  {fault}" for fault in told))
