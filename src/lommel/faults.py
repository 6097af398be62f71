"""How the faults of a file are told: with key and line, all at once."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Sequence
from pathlib import Path


def line_of(text: str, keys: Sequence[str]) -> int | None:
    """Return the number of the line of a TOML file that sets `keys`, where it is written in the plain way."""
    wanted = list(keys)
    section: list[str] = []
    for number, line in enumerate(text.splitlines(), 1):
        if header := re.match(r"\s*\[\s*([\w.\"-]+)\s*\]", line):
            section = header[1].replace('"', "").split(".")
            if section == wanted:
                return number
        elif (entry := re.match(r"\s*(\"[^\"]*\"|[\w-]+)\s*=", line)) and [*section, entry[1].strip('"')] == wanted:
            return number
    return None


def place(text: str, keys: Sequence[str]) -> str:
    """Return ``"lens.wavelength (line 8)"``; the line is that of the table around it where a key has none."""
    lines = (line_of(text, keys[:count]) for count in range(len(keys), 0, -1))
    line = next((number for number in lines if number), None)
    return f"{'.'.join(keys)}{f' (line {line})' if line else ''}"


def unknown_key(key: str, known: Iterable[str]) -> str:
    """Return what to say about a key that is not among those known."""
    near = difflib.get_close_matches(key, known := list(known), n=1)
    return "unknown key" + (f"; did you mean {near[0]}?" if near else f"; known are {', '.join(known)}")


def together(path: Path, faults: Sequence[str]) -> str:
    """Return one message about all faults of a file, in one line if there is one."""
    return f"{path}: " + (faults[0] if len(faults) == 1 else "".join(f"\n  {fault}" for fault in faults))
