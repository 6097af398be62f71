"""Tables of Zernike coefficients in CSV: whatever their columns are called, as long as they say what they hold."""

from __future__ import annotations

import io
import re
from collections.abc import Sequence

from lommel.base import validation
from lommel.io import cells
from lommel.io.zernike_tables import UNITS, ZernikeTable
from lommel.lensfiles.zernike_entries import build
from lommel.special import zernike

_INDICES = ("index", "term", "j", "zernike")  # names of columns
_VALUES = ("value", "coefficient", "coeff", "c")
_NAMES = ("name", "aberration", "description")  # which are left out
_COLUMN = re.compile(r"([a-z]+)\s*(?:[(\[]\s*(\S+?)\s*[)\]])?")
_NUMBERED = re.compile(r"z\s*_?(\d+)", re.IGNORECASE | re.ASCII)
_ALSO = {"wave": "waves", "rad": "radians", "radian": "radians", "meters": "metres", "micron": "um", "microns": "um"}

_Row = tuple[int, list[str]]


def read(text: str) -> tuple[ZernikeTable | None, list[str]]:
    """Return the table that a text holds, or every fault in it."""
    settings: dict[str, str] = {}
    lines: dict[str, int] = {}
    found: list[str] = []
    for place, line in enumerate(io.StringIO(text), 1):
        comment, colon, value = line.partition(":")
        key = comment.strip().removeprefix("#").strip()
        if colon and comment.lstrip().startswith("#"):
            if key in settings:
                found.append(f"{validation.key(key)} (line {place}): is given twice, first in line {lines[key]}")
            else:
                settings[key], lines[key] = value.strip(), place

    def stated(key: str, value: str, place: int) -> None:
        if settings.setdefault(key, value) != value:
            found.append(
                f"line {place}: the columns say the {key} {value}, line {lines[key]} {validation.key(settings[key])}"
            )
        lines.setdefault(key, place)

    if "unit" in settings:
        settings["unit"] = _ALSO.get(settings["unit"].lower(), settings["unit"])
    (head, columns), *rows = [*cells.rows(text, _between(text))] or [(0, [])]
    plain = [cell.lower() for cell in columns]
    if plain and all(map(_NUMBERED.fullmatch, plain)):
        rows = _standing(rows, plain, found)
        plain = ["index", "value"]
    kept = [k for k, name in enumerate(plain) if name not in _NAMES]
    index, value, unit = _told([plain[k] for k in kept], settings.get("order"))
    if columns and not index:
        wanted = "n,m,value" if settings.get("order") == "nm" else "index,value"
        found.append(f"line {head}: the columns must be {wanted}, got {_brief(columns)}")
        rows = []
    if index == ["n", "m"]:
        stated("order", "nm", head)
    elif index and index[0] in zernike.ORDERS:
        stated("order", index[0], head)
    if unit:
        stated("unit", unit, head)
    terms = []
    for place, row in rows:
        if len(row) != len(plain):
            found.append(f"line {place}: must have {len(plain)} cells, got {len(row)}: {_brief(row)}")
            continue
        *at, number = (row[k] for k in kept)
        numbered = _NUMBERED.fullmatch(at[0])
        terms.append((numbered[1] if numbered else ",".join(at), cells.number(number), f"line {place}"))

    def where(key: str) -> str:
        return f"{validation.key(key)} (line {lines[key]})" if key in lines else validation.key(key)

    table, more = build(settings, terms, where)
    return (None if found else table), [*found, *more]


def _told(columns: Sequence[str], order: str | None) -> tuple[list[str], str, str]:
    """Return the columns of the index, that of the value, and the unit that it names; none if they are others."""
    *index, last = columns or [""]
    value = _COLUMN.fullmatch(last)
    pair = index == ["n", "m"] and order in (None, "nm")
    single = len(index) == 1 and order != "nm" and index[0] in (*_INDICES, *zernike.ORDERS[1:])
    if not value or value[1] not in _VALUES or not (pair or single):
        return [], "", ""
    unit = _ALSO.get(value[2] or "", value[2] or "")
    return (index, value[1], unit) if not unit or unit in UNITS else ([], "", "")


def _brief(row: Sequence[str]) -> str:
    return validation.brief(", ".join(row[:60]))


def _between(text: str) -> str:
    """Return what separates cells: a semicolon or a tab where the first row has it and no comma."""
    first = next((line for line in io.StringIO(text) if line.strip() and not line.lstrip().startswith("#")), "")
    return next((mark for mark in ";\t" if mark in first and "," not in first), ",")


def _standing(rows: Sequence[_Row], names: Sequence[str], found: list[str]) -> list[_Row]:
    """Return one row below Z1, Z2, ... as rows of an index and a value."""
    for place, row in rows[1:]:
        found.append(f"line {place}: one row of values is a table, got another: {validation.shown(', '.join(row))}")
    for place, row in rows[:1]:
        if len(row) != len(names):
            found.append(f"line {place}: must have {len(names)} cells, got {len(row)}: {_brief(row)}")
    return [(place, [name, cell]) for place, row in rows[:1] for name, cell in zip(names, row, strict=False)]
