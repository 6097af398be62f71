"""Tables of Zernike coefficients in JSON, TOML and CSV: nothing about them is guessed, every error told at once."""

from __future__ import annotations

import json
import re
import tomllib
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from typing import Any

from lommel.base import reading, validation
from lommel.base.options import near
from lommel.base.units import parse_length
from lommel.io.zernike_tables import SUFFIXES, UNITS, ZernikeTable
from lommel.lensfiles import cells, messages
from lommel.optics.descriptions import NORMALIZATIONS
from lommel.optics.wavefront import Wavefront
from lommel.special import zernike

SETTINGS = ("order", "unit", "normalization", "wavelength")
_INDICES, _VALUES = ("index", "term", "j"), ("value", "coefficient", "coeff", "c")  # names of columns
_MOST_TERMS = 4096  # more than there are
_PAIR = re.compile(r"\(?\s*([+-]?\d+)\s*,\s*([+-]?\d+)\s*\)?", re.ASCII)

_Index = int | tuple[int, int]
_Where = Callable[[str], str]


class ZernikeFileError(ValueError):
    """A table that cannot be used; the message names every fault with its key or line."""


def load_zernike(path: str | PathLike[str]) -> ZernikeTable:
    """Read a table of Zernike coefficients from a ``.json``, ``.toml`` or ``.csv`` file.

    ``order`` (nm, noll, ansi, fringe), ``unit`` (waves, radians, or a length: nm, um, m, ...) and ``normalization``
    (rms, edge) must be stated; ``wavelength``, a length with a unit, may be. TOML::

        order = "noll"
        unit = "nm"
        normalization = "rms"
        wavelength = "632.8 nm"

        [terms]
        4 = -12.5
        7 = 31.0

    JSON: ``{"order": "nm", "unit": "waves", "normalization": "edge", "terms": {"3,1": 0.25}}``. CSV, where other
    lines that begin with ``#`` and hold no colon are comments::

        # order: nm
        # unit: waves
        # normalization: rms
        n, m, value
        3, 1, 0.25

    For the other orders, the columns are ``index,value``. An index may also be called term, j, or by its order, and a
    value coefficient, coeff or c.

    Parameters
    ----------
    path : path

    Returns
    -------
    ZernikeTable

    Raises
    ------
    ZernikeFileError
        For every missing, unknown, doubled or impossible entry, with key or line.
    ValueError
        If the suffix is unknown.
    OSError
        If the file cannot be read.
    """
    source = validation.path("path", path)
    read = {".json": _read_json, ".toml": _read_toml, ".csv": _read_csv}.get(source.suffix.lower())
    if read is None:
        raise ValueError(f"path must end in {', '.join(SUFFIXES)}, got {validation.shown(str(path))}")
    try:
        table, found = read(reading.text(source))
    except ValueError as error:
        raise ZernikeFileError(f"{validation.line(source)}: {reading.reason(error)}") from None
    if table is None:
        raise ZernikeFileError(messages.together(source, found))
    return table


def build(
    settings: Mapping[str, Any], terms: Sequence[tuple[str, Any, str]], where: _Where
) -> tuple[ZernikeTable | None, list[str]]:
    """Build a table from what a file says, or tell every fault in it.

    Parameters
    ----------
    settings : mapping
        By the names of `SETTINGS`; others are faults.
    terms : sequence of (str, object, str)
        Index as text, value, and where it stands.
    where : callable
        From the name of a setting to where it stands.
    """
    stray = [key for key in settings if key not in SETTINGS]
    found = [f"{where(key)}: unknown key; {near(key, (*SETTINGS, 'terms'))}" for key in stray[: messages.TOLD]]
    found += ["unknown keys"] * len(stray[messages.TOLD :])
    allowed = {"order": zernike.ORDERS, "unit": UNITS, "normalization": NORMALIZATIONS}
    for key, options in allowed.items():
        if key not in settings:
            found.append(f"{where(key)}: is missing; it is one of {', '.join(options)}")
        elif settings[key] not in options:
            found.append(f"{where(key)}: must be one of {', '.join(options)}, got {validation.shown(settings[key])}")
    wavelength = None
    if "wavelength" in settings:
        try:
            wavelength = validation.wavelength(parse_length(settings["wavelength"]))
        except ValueError as error:
            found.append(f"{where('wavelength')}: {error}")
    order = settings.get("order")
    known = order if isinstance(order, str) and order in zernike.ORDERS else None
    if len(terms) > _MOST_TERMS:
        found.append(f"{where('terms')}: must be at most {_MOST_TERMS} coefficients, got {len(terms)}")
        terms = terms[:1]
    values: dict[_Index, float] = {}
    places: dict[tuple[int, int], str] = {}
    for text, value, at in terms:
        try:
            coefficient = validation.real("the coefficient", value)
        except (ValueError, TypeError) as error:
            found.append(f"{at}: {error}")
            coefficient = 0.0
        if known is None:
            continue  # What an index means is not known.
        try:
            index = _index(text, known)
            term = zernike.term(index, known)
            if term in places:
                raise ValueError(f"the term {text} was given before, {places[term]}")
            Wavefront.zernike({index: coefficient}, order=known)
        except (ValueError, TypeError) as error:
            found.append(f"{at}: {error}")
            continue
        values[index], places[term] = coefficient, at
    if not terms:
        found.append(f"{where('terms')}: is missing or empty; it holds the coefficients by index")
    if found:
        return None, found
    return ZernikeTable(values, settings["order"], settings["unit"], settings["normalization"], wavelength), []


def build_section(
    raw: Mapping[str, Any], where: Callable[[Sequence[str]], str]
) -> tuple[ZernikeTable | None, list[str]]:
    """Build a table from a section of a TOML or JSON file; `where` turns keys into where they stand."""
    settings = {key: value for key, value in raw.items() if key != "terms"}
    terms = raw.get("terms", {})
    entries = terms.items() if isinstance(terms, Mapping) else ()
    table, found = build(settings, [(k, c, where(["terms", k])) for k, c in entries], lambda key: where([key]))
    if not isinstance(terms, Mapping):
        # Instead of the last fault, that it is empty.
        found[-1] = f"{where(['terms'])}: must map indices to coefficients, got {validation.shown(terms)}"
    return table, found


def _read_toml(text: str) -> tuple[ZernikeTable | None, list[str]]:
    try:
        raw = tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        return None, [f"not valid TOML: {reading.reason(error)}"]
    return build_section(raw, lambda keys: messages.place(text, keys))


def _read_json(text: str) -> tuple[ZernikeTable | None, list[str]]:
    twice: list[str] = []

    def once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        counts = Counter(key for key, _ in pairs)
        twice.extend(f"{key}: is given twice" for key, count in counts.items() if count > 1)
        return dict(pairs)

    try:
        raw = json.loads(text, object_pairs_hook=once)
    except (ValueError, RecursionError) as error:
        return None, [f"not valid JSON: {reading.reason(error)}"]
    if not isinstance(raw, dict):
        return None, [f"must hold an object, got {type(raw).__name__}"]
    table, found = build_section(raw, ".".join)
    return (None if twice else table), [*twice, *found]


def _read_csv(text: str) -> tuple[ZernikeTable | None, list[str]]:
    settings: dict[str, str] = {}
    lines: dict[str, int] = {}
    found: list[str] = []
    columns: list[str] | None = None
    terms: list[tuple[str, Any, str]] = []
    for place, line in enumerate(text.splitlines(), 1):
        comment, colon, value = line.partition(":")
        key = comment.strip().removeprefix("#").strip()
        if colon and comment.lstrip().startswith("#"):
            if key in settings:
                found.append(f"{key} (line {place}): is given twice, first in line {lines[key]}")
            else:
                settings[key], lines[key] = value.strip(), place
    for place, row in cells.rows(text):
        if columns is None:
            columns = row
            *index, value = (cell.lower() for cell in row)
            order = settings.get("order")
            known = index == ["n", "m"] if order == "nm" else index in [[name] for name in (*_INDICES, str(order))]
            if not (known and value in _VALUES):
                wanted = "n,m,value" if order == "nm" else "index,value"
                found.append(f"line {place}: the columns must be {wanted}, got {', '.join(row)}")
            continue
        if len(row) != len(columns):
            found.append(f"line {place}: must have {len(columns)} cells, got {len(row)}: {', '.join(row)}")
            continue
        terms.append((",".join(row[:-1]), cells.number(row[-1]), f"line {place}"))

    def where(key: str) -> str:
        return f"{key} (line {lines[key]})" if key in lines else key

    table, more = build(settings, terms, where)
    return (None if found else table), [*found, *more]


def _index(text: str, order: str) -> _Index:
    if order == "nm":
        pair = _PAIR.fullmatch(text.strip())
        if not pair:
            raise ValueError(f'an index of the order "nm" is written "n,m", got {validation.shown(text)}')
        return int(pair[1]), int(pair[2])
    if not re.fullmatch(r"\s*[+-]?\d+\s*", text, re.ASCII):
        raise ValueError(f"an index of the order {order!r} is an integer, got {validation.shown(text)}")
    return int(text)
