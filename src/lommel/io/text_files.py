"""Text files: rows of CSV tables, INT files of Code V, line numbers of TOML keys, and joined error messages."""

from __future__ import annotations

import csv
import io
import math
import re
from array import array
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lommel.base import reading, validation
from lommel.base.arrays import Array
from lommel.base.validation import brief, key, line

_SIZE_COUNTS = {"GRD": 2, "ZRN": 1, "ZFR": 1}
_NUMBERS = ("WVL", "SSZ", "NDA", "XSC")
_FLAGS = ("NNB",)  # ignored words: how to interpolate between the points of a grid
_CONTENTS = {"WFR": "a wavefront", "SUR": "the shape of a surface", "FIL": "a filter of intensity"}
_DESIGN_READERS = {
    ".zmx": "load_zemax_file",
    ".seq": "load_codev_file",
    ".len": "load_oslo_file",
    ".json": "load_optiland_file",
}


def design_note(source: Path) -> str:
    """Return how to use the file of a lens design; "" for other files."""
    suffix = source.suffix.lower()
    is_design = suffix in _DESIGN_READERS
    if suffix == ".json":
        start = reading.start(source, 2**16)
        is_design = all(key in start for key in (b'"aperture"', b'"fields"', b'"wavelengths"'))
    return is_design * (
        f"{line(source)} is a lens design: load it with optiland.fileio.{_DESIGN_READERS.get(suffix)}, and compute "
        "its pupils with lommel.adapters.optiland"
    )


class Interferogram(NamedTuple):
    """Contents of an INT file: a grid (GRD), Zernike terms in Code V's order (ZRN), or Fringe Zernike terms (ZFR)."""

    kind: str  # "GRD", "ZRN" or "ZFR"
    size: tuple[int, ...]  # columns and rows of a grid, or the number of terms
    wavelength: float  # metres
    values: Array  # waves at this wavelength
    missing: NDArray[np.bool_]  # True for points without data, whose stored value is NDA


def parse(text: str) -> Interferogram:
    """Parse an INT file; ValueError if it is damaged or does not contain a wavefront."""
    # The first line is a title. The second line is, for example, ZFR 37 WFR WVL 0.6328 SSZ 1000 NDA 32767. Lines that
    # begin with ! are comments. The wavefront is value / SSZ, in waves at the wavelength WVL in micrometres.
    lines = (line for line in io.StringIO(text) if line.strip() and not line.lstrip().startswith("!"))
    title, sizes = next(lines, ""), next(lines, "")
    values = np.array(
        array("d", (_parse_number(word[0], "a value") for line in lines for word in re.finditer(r"\S+", line)))
    )
    if not title or not sizes or not values.size:
        raise ValueError("it lacks a title, a line of sizes, or values")
    kind, *words = sizes.upper().split()
    if kind not in _SIZE_COUNTS:
        raise ValueError(f"its second line must begin with {', '.join(_SIZE_COUNTS)}, got {validation.shown(kind)}")
    count = _SIZE_COUNTS[kind]
    size = tuple(_parse_size(word) for word in words[:count])
    stated_values = _parse_settings(words[count:])
    wavelength = validation.wavelength(1e-6 * stated_values["WVL"])
    if len(size) != count or values.size != math.prod(size):
        raise ValueError(f"it states {' x '.join(map(str, size))} values, got {values.size}")
    missing = values == stated_values["NDA"] if "NDA" in stated_values else np.zeros(values.shape, np.bool_)
    return Interferogram(kind, size, wavelength, values / stated_values["SSZ"], missing)


def _parse_settings(words: Sequence[str]) -> dict[str, float]:
    """Return the numbers of the second line by name; ValueError without WVL or SSZ, or if it is not a wavefront."""
    remaining_words, contents, stated_values = list(words), [], dict[str, float]()
    while remaining_words:
        word = remaining_words.pop(0)
        if word in _CONTENTS:
            contents.append(word)
        elif word in _NUMBERS and remaining_words:
            stated_values[word] = _parse_number(remaining_words.pop(0), word)
        elif word not in _FLAGS:
            raise ValueError(f"its second line holds {validation.shown(word)}, which is unknown")
    if contents != ["WFR"]:
        contents_text = " and ".join(_CONTENTS[word] for word in contents) or "a second line without WFR"
        raise ValueError(f"it must hold a wavefront (WFR), got {contents_text}")
    if names := [word for word in ("WVL", "SSZ") if not stated_values.get(word, 0.0) > 0.0]:
        raise ValueError(f"it lacks a positive {' and '.join(names)} (WVL: wavelength, SSZ: value of one wave)")
    return stated_values


def term(index: int) -> tuple[int, int]:
    """Return (n, m) of term `index` >= 1 in Code V's order (ZRN): n increasing, for each n from m = n to m = -n."""
    n = 0
    while index > (n + 1) * (n + 2) // 2:
        n += 1
    return n, n - 2 * (index - n * (n + 1) // 2 - 1)


def _parse_size(word: str) -> int:
    if not word.isdecimal() or not 0 < int(word) <= validation.MAX_SIDE:
        raise ValueError(f"a size must be an integer from 1 to {validation.MAX_SIDE}, got {validation.shown(word)}")
    return int(word)


def _parse_number(word: str, name: str) -> float:
    try:
        value = float(word.replace("D", "E"))
        return value if math.isfinite(value) else validation.real(name, value)
    except ValueError:
        raise ValueError(f"{name} must be a finite number, got {validation.shown(word)}") from None


MAX_MESSAGES = 12
"""Maximum number of errors of a file in one message."""


def rows(text: str, separator: str = ",") -> Iterator[tuple[int, list[str]]]:
    """Yield the line number and the cells of each line that is neither empty nor a comment (``#``)."""
    for place, text_line in enumerate(io.StringIO(text), 1):  # no list of all lines, since the text may be long
        try:
            quoted = '"' in text_line or len(text_line) > csv.field_size_limit()
            cells = next(csv.reader([text_line], delimiter=separator), []) if quoted else text_line.split(separator)
        except csv.Error as error:  # a quote without an end
            raise ValueError(f"{error} in line {place}") from None
        cells = list(map(str.strip, cells))
        if any(cells) and not text_line.lstrip().startswith("#"):
            yield place, cells


def settings(text: str) -> Iterator[tuple[int, str, str]]:
    """Yield the line number, the name and the value of each comment of the form ``# unit: nm``."""
    for place, text_line in enumerate(io.StringIO(text), 1):
        comment, colon, value = text_line.partition(":")
        if colon and comment.lstrip().startswith("#"):
            yield place, comment.strip().removeprefix("#").strip(), value.strip()


def number(text: str) -> float | str:
    """Return the number in a cell, or the text itself if it is not a number: later validation reports the error."""
    try:
        return float(text)
    except ValueError:
        return text


def line_of(text: str, keys: Sequence[str]) -> int | None:
    """Return the number of the line of a TOML file that sets the key `keys`; None if the line is not recognised."""
    return _line_numbers(text).get(tuple(keys))


@lru_cache(maxsize=2)
def _line_numbers(text: str) -> dict[tuple[str, ...], int]:
    """Return the line numbers of the keys and tables of a TOML file."""
    line_numbers: dict[tuple[str, ...], int] = {}
    numbers: Counter[tuple[str, ...]] = Counter()
    section: tuple[str, ...] = ()
    for number, text_line in enumerate(text.splitlines(), 1):
        if header := re.match(r"\s*\[(\[?)\s*([\w.\"-]+)\s*\]", text_line):
            section = tuple(header[2].replace('"', "").split("."))
            line_numbers.setdefault(section, number)
            if header[1]:  # one table of an array of tables: append its index
                numbers[section] += 1
                section = (*section, str(numbers[section] - 1))
                line_numbers.setdefault(section, number)
        elif entry := re.match(r"\s*(\"[^\"]*\"|[\w-]+)\s*=", text_line):
            line_numbers.setdefault((*section, entry[1].strip('"')), number)
    return line_numbers


def nearest_line(text: str, keys: Sequence[str]) -> int | None:
    """Return the number of the line that sets the key `keys`; if unknown, the line of the surrounding table."""
    lines = _line_numbers(text)
    return next((lines[part] for k in range(len(keys), 0, -1) if (part := tuple(keys[:k])) in lines), None)


def place(text: str, keys: Sequence[str]) -> str:
    """Return the key and the number of :func:`nearest_line` as text, such as ``"lens.wavelength (line 8)"``."""
    number = nearest_line(text, keys)
    return f"{'.'.join(map(key, keys))}{f' (line {number})' if number else ''}"


def joined_errors(path: Path, errors: Sequence[str], count: int | None = None) -> str:
    """Return one message with the first errors of a file, one error per line; `count` is the number of all errors."""
    count, messages = len(errors) if count is None else count, [line(error) for error in errors[:MAX_MESSAGES]]
    if count > MAX_MESSAGES:
        messages.append(f"and {count - MAX_MESSAGES} more")
    return f"{line(path)}: " + (messages[0] if count == 1 else "".join(f"\n  {error}" for error in messages))


MANY = 1000
"""Number of errors after which a reader of a table may stop."""


@contextmanager
def collected(errors: list[str], place: str) -> Iterator[None]:
    """Append the message of a ValueError or TypeError to `errors`, preceded by `place`, instead of raising it."""
    try:
        yield
    except (ValueError, TypeError) as error:
        errors.append(f"{place}: {error}")


def refuse(errors: Sequence[str]) -> None:
    """Raise ValueError with the first errors of a table, if there are any."""
    if errors:
        further = len(errors) - MAX_MESSAGES
        ending = f"; and {'at least ' if len(errors) > MANY else ''}{further} more" if further > 0 else ""
        raise ValueError("; ".join(brief(error, 200) for error in errors[:MAX_MESSAGES]) + ending)
