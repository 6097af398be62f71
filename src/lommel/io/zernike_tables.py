"""Read and write tables of Zernike coefficients: JSON, TOML, CSV, and (read only) files of lens design programs."""

from __future__ import annotations

import codecs
import io
import json
import math
import re
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from os import PathLike
from typing import Any, TypeAlias

from lommel.base import atomic, display, reading, validation
from lommel.base.arrays import Json
from lommel.base.options import near
from lommel.base.quantities import LENGTHS
from lommel.base.units import parse_length
from lommel.io import registry, text_files
from lommel.io.registry import Format
from lommel.optics.wavefront.wavefront import NORMALIZATIONS, UNITS, Wavefront, same_path
from lommel.special import zernike

Index: TypeAlias = int | tuple[int, int]

UNIT_NAMES = {"wave": "waves", "rad": "radians", "radian": "radians", "meter": "m", "meters": "m"}
UNIT_NAMES |= dict.fromkeys(("micron", "microns", "micrometer", "micrometers"), "um")
UNIT_NAMES |= {"nanometer": "nm", "nanometers": "nm", "millimeters": "mm", "inches": "in"}
"""Units of this package, by their names in other programs."""


@dataclass(frozen=True)
class ZernikeTable:
    """Zernike coefficients of a single wavefront in the order, unit and normalization of their source.

    Parameters
    ----------
    terms : mapping of index to float
        Coefficients by index: an integer, or a pair (n, m) if `order` is "nm".
    order : {"nm", "noll", "ansi", "fringe"}
    unit : str
        Unit of the coefficients: "radians", "waves", or a unit of path length ("metres", "nm", "um", ...).
    normalization : {"rms", "edge"}
        As in :meth:`lommel.Wavefront.zernike`.
    wavelength : float, optional
        Wavelength (metres) at which the waves or radians were measured.
    obscuration : float, default 0
        Obscuration of annular Zernike terms, as in :meth:`lommel.Wavefront.zernike`.

    Raises
    ------
    TypeError, ValueError
        If a term, the order, the unit or the normalization is unknown, or a number is not finite or out of range.
    """

    terms: Mapping[int, float] | Mapping[Index, float] | Mapping[tuple[int, int], float]
    order: str
    unit: str
    normalization: str
    wavelength: float | None = None
    obscuration: float = 0.0

    def __post_init__(self) -> None:
        zernike.check_order(self.order)
        validation.choice("unit", self.unit, UNITS)
        validation.choice("normalization", self.normalization, NORMALIZATIONS)
        if self.wavelength is not None:
            object.__setattr__(self, "wavelength", validation.wavelength(self.wavelength))
        if not isinstance(self.terms, Mapping):
            raise TypeError(f"terms must map indices to coefficients, got {validation.shown(self.terms)}")
        terms = {i: validation.real(f"the Zernike coefficient {i!r}", c) for i, c in self.terms.items()}
        object.__setattr__(self, "terms", terms)
        # This raises an error that names unknown terms.
        Wavefront.zernike(terms, order=self.order, normalization=self.normalization, obscuration=self.obscuration)

    @classmethod
    def from_wavefront(
        cls,
        wavefront: Wavefront,
        *,
        order: str = "noll",
        unit: str = "waves",
        normalization: str = "rms",
        wavelength: float | None = None,
        obscuration: float = 0.0,
    ) -> ZernikeTable:
        """Return the table of a single wavefront; units of length need `wavelength`, in metres.

        Parameters
        ----------
        wavefront : Wavefront
        order, unit, normalization : str
            Attributes of the table.
        wavelength : float, optional
            Metres.
        obscuration : float, default 0
            Obscuration of annular terms; 0 for terms on the disc.

        Returns
        -------
        ZernikeTable

        Raises
        ------
        TypeError, ValueError
            If `wavefront` is a stack, an argument is unknown or out of range, or the unit needs a wavelength.
        """
        if validation.instance("wavefront", wavefront, Wavefront).shape != ():
            raise ValueError(f"wavefront must be a single one, got a stack of shape {wavefront.shape}")
        terms = wavefront.to_zernike(
            order=order, unit=unit, normalization=normalization, wavelength=wavelength, obscuration=obscuration
        )
        return cls({i: float(c) for i, c in terms.items()}, order, unit, normalization, wavelength, obscuration)

    def wavefront(self, wavelength: float | None = None) -> Wavefront:
        """Return the wavefront at a wavelength in metres, by default the wavelength of the table.

        Path lengths are assumed not to depend on the wavelength (no dispersion): waves and radians are multiplied by
        ``table.wavelength / wavelength``.

        Parameters
        ----------
        wavelength : float, optional
            Metres.

        Returns
        -------
        Wavefront

        Raises
        ------
        ValueError
            If the unit is a length and neither the table nor `wavelength` states a wavelength; or if the unit is
            waves or radians, `wavelength` is given, and the table states no wavelength.
        """
        is_path = self.unit not in ("radians", "waves")
        target = self.wavelength if wavelength is None else validation.wavelength(wavelength)
        if is_path and target is None:
            raise ValueError(f"wavelength must be given, since the unit of the table is {self.unit!r}")
        if not is_path and wavelength is not None and self.wavelength is None:
            raise ValueError(f"the table must state the wavelength at which its {self.unit} were measured")
        wavefront_of_table = Wavefront.zernike(
            self.terms,
            order=self.order,
            unit=self.unit,
            normalization=self.normalization,
            wavelength=target,
            obscuration=self.obscuration,
        )
        if is_path or target is None or self.wavelength is None or target == self.wavelength:
            return wavefront_of_table
        return same_path(wavefront_of_table, self.wavelength, target)


def save_zernike(path: str | PathLike[str], table: ZernikeTable | Wavefront) -> None:
    """Write a table; the suffix chooses the format, and :func:`lommel.load_zernike` returns the same numbers.

    A single wavefront is written as a table of Noll terms in waves rms; for other orders and units use
    :meth:`~lommel.io.zernike_tables.ZernikeTable.from_wavefront`. The file is written under a temporary name and
    moved into place.

    Parameters
    ----------
    path : path
        Ending in .json, .toml or .csv.
    table : ZernikeTable or Wavefront

    Raises
    ------
    TypeError, ValueError
        If `table` is of another type, is a stack of wavefronts, or if the suffix is unknown.
    OSError
        If the file cannot be written.
    """
    if isinstance(table, Wavefront):
        table = ZernikeTable.from_wavefront(table)
    if not isinstance(table, ZernikeTable):
        raise TypeError(f"table must be a ZernikeTable or a Wavefront, got {validation.shown(table)}")
    save_table(path, table, {})


def save_table(path: str | PathLike[str], table: ZernikeTable, errors: Mapping[int, float]) -> None:
    """Write a table with standard errors of some terms in its unit; :func:`load_zernike` ignores the errors."""
    settings: Json = {"order": table.order, "unit": table.unit, "normalization": table.normalization}
    if table.wavelength is not None:
        settings["wavelength"] = f"{table.wavelength!r} m"
    if table.obscuration:
        settings["obscuration"] = table.obscuration
    ordered_terms: list[tuple[Index, float]] = [*table.terms.items()]
    ordered_terms.sort(key=lambda term: (isinstance(term[0], tuple), term[0]))
    terms = {(",".join(map(str, i)) if isinstance(i, tuple) else str(i)): value for i, value in ordered_terms}
    finite_errors = {str(i): error for i, error in sorted(errors.items()) if math.isfinite(error)}
    atomic.write(validation.path("path", path), find(path).write(settings, terms, finite_errors).encode())


@display.save.register(Wavefront)
def save_wavefront(wavefront: Wavefront, path: str | PathLike[str], **options: Any) -> None:
    """Write a wavefront as :meth:`~lommel.io.zernike_tables.ZernikeTable.from_wavefront` tabulates it.

    Parameters
    ----------
    wavefront : Wavefront
    path : path
        Ending in .json, .toml or .csv.
    **options
        Options of :meth:`~lommel.io.zernike_tables.ZernikeTable.from_wavefront`.

    Raises
    ------
    TypeError, ValueError
        If `wavefront` is a stack, an option is unknown or out of range, the unit needs a wavelength, or the suffix
        is unknown.
    OSError
        If the file cannot be written.
    """
    find(path)  # raises an error for an unknown suffix before any computation
    save_zernike(path, ZernikeTable.from_wavefront(wavefront, **options))


SETTINGS = ("order", "unit", "normalization", "wavelength", "obscuration")
_MAX_TERMS = 4096  # maximum number of terms in a file; more than there are supported terms
_PAIR = re.compile(r"\(?\s*([+-]?\d+)\s*,\s*([+-]?\d+)\s*\)?", re.ASCII)


def build(
    settings: Json, terms: Sequence[tuple[str, object, str]], where: Callable[[str], str], example: str = ""
) -> tuple[ZernikeTable | None, list[str]]:
    """Build a table from settings and terms (index, value, place in the file), or return all errors.

    `where` maps the name of a setting to its place in the file; `example`, formatted with a name and a value, is how
    the file states it.
    """
    errors = _setting_errors(settings, where, example)
    wavelength, obscuration = None, 0.0
    if "wavelength" in settings:
        with text_files.collected(errors, where("wavelength")):
            wavelength = validation.wavelength(parse_length(settings["wavelength"]))
    if "obscuration" in settings:
        with text_files.collected(errors, where("obscuration")):
            stated_value = settings["obscuration"]
            value = text_files.number(stated_value) if isinstance(stated_value, str) else stated_value
            obscuration = validation.real("it", value, least=0.0, below=1.0)
    if len(terms) > _MAX_TERMS:
        errors.append(f"{where('terms')}: must be at most {_MAX_TERMS} coefficients, got {len(terms)}")
        terms = terms[:1]
    values = _read_terms(terms, settings.get("order"), errors)
    if not terms:
        errors.append(f"{where('terms')}: is missing or empty; it holds the coefficients by index")
    if errors:
        return None, errors
    try:
        return ZernikeTable(
            values, settings["order"], settings["unit"], settings["normalization"], wavelength, obscuration
        ), []
    except ValueError as error:  # the degree of annular terms is too high
        return None, [f"{where('obscuration')}: {error}"]


def _setting_errors(settings: Json, where: Callable[[str], str], example: str) -> list[str]:
    """Return errors for unknown keys, and for order, unit and normalization if they are missing or not allowed."""
    keys = [key for key in settings if key not in SETTINGS]
    errors = [
        f"{where(key)}: unknown key; {near(key, (*SETTINGS, 'terms'))}" for key in keys[: text_files.MAX_MESSAGES]
    ]
    errors += ["unknown keys"] * len(keys[text_files.MAX_MESSAGES :])
    allowed = {"order": zernike.ORDERS, "unit": UNITS, "normalization": NORMALIZATIONS}
    for key, options in allowed.items():
        if key not in settings:
            stated = example.format(key, options[0])
            errors.append(f"{where(key)}: is missing; it is one of {', '.join(options)}{stated}")
        elif settings[key] not in options:
            name = zernike.NAMES_ELSEWHERE.get(str(settings[key]), "") if key == "order" else ""
            text = f"must be one of {', '.join(options)}, got {validation.shown(settings[key])}"
            errors.append(f"{where(key)}: {text}{name and f'; {name}'}")
    return errors


def _read_terms(terms: Sequence[tuple[str, object, str]], order: object, errors: list[str]) -> dict[Index, float]:
    """Return the coefficients by index; append the errors of the terms to `errors`."""
    values: dict[Index, float] = {}
    places: dict[tuple[int, int], str] = {}
    for text, value, place in terms:
        coefficient = 0.0
        with text_files.collected(errors, place):
            coefficient = validation.real("the coefficient", value)
        if not isinstance(order, str) or order not in zernike.ORDERS:
            continue  # the meaning of an index is unknown
        with text_files.collected(errors, place):
            index = _parse_index(text, order)
            term = zernike.term(index, order)
            if term in places:
                raise ValueError(f"the term {text} was given before, {places[term]}")
            Wavefront.zernike({index: coefficient}, order=order, normalization="rms")
            values[index], places[term] = coefficient, place
    return values


def build_section(
    raw: Mapping[str, object], where: Callable[[Sequence[str]], str]
) -> tuple[ZernikeTable | None, list[str]]:
    """Build a table from a section of a TOML or JSON file, or return all errors; `where` maps keys to places."""
    settings = {key: value for key, value in raw.items() if key not in ("terms", _ERRORS)}
    terms = raw.get("terms", {})
    entries = terms.items() if isinstance(terms, Mapping) else ()
    table, errors = build(settings, [(k, c, where(["terms", k])) for k, c in entries], lambda key: where([key]))
    if not isinstance(terms, Mapping):
        errors[-1] = f"{where(['terms'])}: must map indices to coefficients, got {validation.shown(terms)}"
    return table, errors


def _parse_index(text: str, order: str) -> Index:
    if order == "nm":
        pair = _PAIR.fullmatch(text.strip())
        if not pair:
            raise ValueError(f'an index of the order "nm" is written "n,m", got {validation.shown(text)}')
        return int(pair[1]), int(pair[2])
    if not re.fullmatch(r"\s*[+-]?\d+\s*", text, re.ASCII):
        raise ValueError(f"an index of the order {order!r} is an integer, got {validation.shown(text)}")
    return int(text)


_INDEX_COLUMNS = ("index", "term", "j", "z", "zernike")  # names of columns
_VALUE_COLUMNS = ("value", "coefficient", "coeff", "c")
_NAME_COLUMNS = ("name", "aberration", "description")  # names of ignored columns
_COLUMN = re.compile(r"([a-z]+)(?:\s*[(\[]\s*([^)\]]+?)\s*[)\]]|_([^\s_]+))?")
_NUMBERED_NAME = re.compile(r"z\s*_?(\d+)", re.IGNORECASE | re.ASCII)


class _CsvSettings:
    """The settings in the comment lines of a CSV text, with their line numbers and errors."""

    def __init__(self, text: str) -> None:
        self.values: dict[str, str] = {}
        self.lines: dict[str, int] = {}
        self.errors: list[str] = []
        for place, key, value in text_files.settings(text):
            if key in self.values:
                first = self.lines[key]
                self.errors.append(f"{validation.key(key)} (line {place}): is given twice, first in line {first}")
            else:
                self.values[key], self.lines[key] = value, place
        if "unit" in self.values:
            self.values["unit"] = UNIT_NAMES.get(self.values["unit"].lower(), self.values["unit"])

    def add(self, key: str, value: str, place: int) -> None:
        """Add a setting that the column names state; append an error if a comment line states another value."""
        if (stated_value := self.values.setdefault(key, value)) != value:
            self.errors.append(
                f"line {place}: the columns state the {key} {value}, line {self.lines[key]} states "
                f"{validation.key(stated_value)}"
            )
        self.lines.setdefault(key, place)

    def where(self, key: str) -> str:
        """Return the name of a setting, with its line number if the text contains it."""
        return f"{validation.key(key)} (line {self.lines[key]})" if key in self.lines else validation.key(key)


def read_csv(text: str) -> tuple[ZernikeTable | None, list[str]]:
    """Return the table of a CSV text, or all errors in the text."""
    settings = _CsvSettings(text)
    errors, order, separator = settings.errors, settings.values.get("order"), _find_separator(text)
    (head, columns), *rows = [*text_files.rows(text, separator)] or [(0, [])]
    names = [cell.lower() for cell in columns]
    columns_used = [k for k, name in enumerate(names) if name not in _NAME_COLUMNS]
    index, stated = _find_columns([names[k] for k in columns_used], order)
    if columns and not index:
        expected = "n,m,value" if order == "nm" else "index,value"
        others = (
            ""
            if order == "nm"
            else "; index may be called term, j, z, noll, ansi (OSA) or fringe, value coeff (waves rms)"
        )
        return None, [*errors, f"line {head}: the columns must be {expected}, got {_shorten_row(columns)}{others}"]
    for key, value in stated.items():
        settings.add(key, value, head)
    terms = []
    for place, row in rows:
        if len(row) != len(names):
            errors.append(f"line {place}: must have {len(names)} cells, got {len(row)}: {_shorten_row(row)}")
            continue
        *index_cells, number = (row[k] for k in columns_used)
        if separator != "," and "." not in number:
            number = number.replace(",", ".")  # a decimal comma
        match = _NUMBERED_NAME.fullmatch(index_cells[0])
        terms.append((match[1] if match else ",".join(index_cells), text_files.number(number), f"line {place}"))
    table, table_errors = build(settings.values, terms, settings.where, ": state it in a line # {}: {}")
    return (None if errors else table), [*errors, *table_errors]


def _find_columns(columns: Sequence[str], order: str | None) -> tuple[list[str], dict[str, str]]:
    """Return the index columns and the settings that the names state; no columns if one is unknown."""
    *index, value_column = columns or [""]
    value = _COLUMN.fullmatch(value_column)
    pair = index == ["n", "m"] and order in (None, "nm")
    one_index = len(index) == 1 and order != "nm" and index[0] in (*_INDEX_COLUMNS, *zernike.ORDERS[1:])
    if not value or value[1] not in _VALUE_COLUMNS or not (pair or one_index):
        return [], {}
    stated = {"order": "nm"} if pair else {"order": index[0]} if index[0] in zernike.ORDERS else {}
    for word in (value[2] or value[3] or "").split():
        if word in NORMALIZATIONS:
            stated["normalization"] = word
        elif (unit := UNIT_NAMES.get(word, word)) in UNITS and "unit" not in stated:
            stated["unit"] = unit
        else:
            return [], {}
    return index, stated


def _shorten_row(row: Sequence[str]) -> str:
    return validation.brief(", ".join(row[:60]))


def _find_separator(text: str) -> str:
    """Return the separator of cells: a semicolon or tab if the first row contains it and no comma, else a comma."""
    first_row = next((line for line in io.StringIO(text) if line.strip() and not line.lstrip().startswith("#")), "")
    return next((mark for mark in ";\t" if mark in first_row and "," not in first_row), ",")


_KIND_LINE = re.compile(r"^\s*(?:Listing of|Using)\b.*?\b(Standard|Fringe|Annular)\b", re.MULTILINE | re.IGNORECASE)
_WAVES_LINE = re.compile(r"^\s*(?:Peak to Valley|RMS|Maximum fit)\b.*?:\s*[\d.,eE+-]+\s+waves\s*$", re.MULTILINE)
_WAVELENGTH_LINE = re.compile(
    r"^[^\S\n]*Wavelength[^\S\n]*:[^\S\n]*([\d.,]+)[^\S\n]*([^\s\d]\S*)?[^\S\n]*$", re.MULTILINE
)
_RATIO = re.compile(r"^\s*(?:Obscuration|Epsilon|Annular ratio)[\w ]*:\s*([\d.,]+)\s*$", re.MULTILINE | re.IGNORECASE)
_TERM_LINE = re.compile(r"^\s*Z\s*(\d{1,4})\s*[:=]?\s*([+-]?[\d.,]+(?:[eE][+-]?\d+)?)\s*(?::.*)?$", re.ASCII)
_COUNT_LINE = re.compile(r"^\s*(?:Number of|Maximum)\s+(?:\w+\s+)*terms?\s*:\s*(\d{1,4})\s*$", re.IGNORECASE)
_TERM_START = re.compile(r"^\s*Z\s*\d", re.ASCII)
# Formula of spherical aberration in a listing; the index of this term must fit the kind that the heading states.
_SPHERICAL = re.compile(r":.*\(\s*6\s*p\^4\s*-\s*6\s*p\^2\s*\+\s*1\s*\)\s*$", re.IGNORECASE)
_BOMS = {codecs.BOM_UTF16_LE: "utf-16", codecs.BOM_UTF16_BE: "utf-16", codecs.BOM_UTF8: "utf-8-sig"}


def read_listing(data: bytes) -> tuple[ZernikeTable | None, list[str]]:
    """Return the table of a listing of OpticStudio, or all errors in the listing."""
    text = _decode_text(data)
    kinds = {kind.lower() for kind in _KIND_LINE.findall(text)}
    kind, annulus = "".join(kinds), _RATIO.search(text)
    errors: list[str] = []
    if len(kinds) != 1:
        got = f"got {' and '.join(sorted(kinds))}" if kinds else "which the line 'Listing of Zernike ...' states"
        errors.append(f"the terms must be Standard, Fringe or Annular, {got}")
    if not _WAVES_LINE.search(text):
        errors.append("the unit is not stated; listings have 'Peak to Valley ... waves'")
    wavelength = _find_wavelength(text, errors)
    if kind == "annular" and not annulus:
        errors.append("the obscuration of the annulus is not stated")
    terms = _find_terms(text, kind, errors)
    if not terms:
        # If no part of a listing was recognised, one message is clearer than a list of all missing parts.
        message = "is no listing of Zernike coefficients of OpticStudio, which begins with 'Listing of Zernike ...'"
        message += " and has lines such as 'Z   4     0.25'"
        errors = [*errors, "it lists no term, such as 'Z   4     0.25'"] if kinds else [message]
    if errors:
        return None, errors
    if kind == "fringe":
        return ZernikeTable(terms, "fringe", "waves", "edge", wavelength), []
    inner = _parse_number(annulus[1]) if annulus and kind == "annular" else 0.0
    return ZernikeTable(dict(sorted(terms.items())), "noll", "waves", "rms", wavelength, inner), []


def _find_wavelength(text: str, errors: list[str]) -> float | None:
    """Return the wavelength (metres) that a listing states, or None; append an error for an unknown unit."""
    waves = _WAVELENGTH_LINE.search(text)
    if waves and waves[2] is None:
        errors.append(f"the wavelength {waves[1]} has no unit; OpticStudio writes {waves[1]} µm")
    elif waves and waves[2] in LENGTHS:
        return validation.wavelength(_parse_number(waves[1]) * LENGTHS[waves[2]])
    elif waves:
        errors.append(f"the wavelength has the unknown unit {validation.shown(waves[2])}")
    return None


def _find_terms(text: str, kind: str, errors: list[str]) -> dict[int, float]:
    """Return the coefficients of a listing by index; append the errors of its lines to `errors`."""
    terms: dict[int, float] = {}
    spherical = {"standard": 11, "fringe": 9}.get(kind)
    last, count, formulas = 0, (0, 0), False
    for place, line in enumerate(text.splitlines(), 1):
        entry = _TERM_LINE.match(line)
        if not entry:
            if stated := _COUNT_LINE.match(line):
                count = place, int(stated[1])
            if _TERM_START.match(line):
                errors.append(f"line {place}: a term must have a number and a value, got {validation.shown(line)}")
            continue
        index, value = int(entry[1]), _parse_number(entry[2])
        if spherical and _SPHERICAL.search(line) and index != spherical:
            errors.append(
                f"line {place}: 6p^4 - 6p^2 + 1 is the term {spherical} of Zernike {kind.capitalize()}, which "
                f"the heading states, got the term {index}; correct the heading"
            )
        if index in terms:
            errors.append(f"line {place}: the term {index} was given before")
        elif not math.isfinite(value):
            errors.append(f"line {place}: the term {index} must be a finite number, got {validation.shown(entry[2])}")
        elif index != last + 1:
            errors.append(
                f"line {place}: the term {last + 1} is missing, got {index}; a listing has all terms from 1"
            )
        has_formula = ":" in line[entry.end(2) :]
        if formulas and not has_formula:
            errors.append(f"line {place}: the term {index} is cut off, without the formula that the others have")
        terms[index], last, formulas = value, index, has_formula
    if count[1] > last:
        errors.append(f"line {count[0]}: states {count[1]} terms, and the listing ends at {last}")
    return terms


def read_code_v(data: bytes) -> tuple[ZernikeTable | None, list[str]]:
    """Return the table of a Code V file, and an empty list of errors."""
    file = text_files.parse(_decode_text(data))
    if file.kind == "GRD":
        raise ValueError("it holds a grid; load_opd reads it")
    if file.missing.any():
        raise ValueError(f"the term {file.missing.argmax() + 1} has no value (NDA)")
    indexed = dict(enumerate(file.values.tolist(), 1))
    if file.kind == "ZFR":
        return ZernikeTable(indexed, "fringe", "waves", "edge", file.wavelength), []
    pairs = {text_files.term(j): c for j, c in indexed.items()}
    return ZernikeTable(pairs, "nm", "waves", "edge", file.wavelength), []


def _decode_text(data: bytes) -> str:
    """Decode text as UTF-16 or UTF-8 if it has a byte order mark, else as UTF-8, or Latin-1 if it is not UTF-8."""
    encoding = next((name for start, name in _BOMS.items() if data.startswith(start)), None)
    if encoding is None:
        try:
            return reading.decoded(data)
        except ValueError:
            encoding = "latin-1"
    try:
        return "\n".join(data.decode(encoding).splitlines())
    except UnicodeDecodeError as error:
        raise ValueError(f"not {encoding} text: {error}") from None


def _parse_number(text: str) -> float:
    """Return a number with a decimal point or comma; NaN if the text is not a number."""
    try:
        return float(text.replace(",", ".") if text.count(",") == 1 and "." not in text else text)
    except ValueError:
        return math.nan


class ZernikeFileError(ValueError):
    """A table that cannot be used; the message names every error with its key or line."""


def load_zernike(path: str | PathLike[str]) -> ZernikeTable:
    """Read Zernike coefficients: ``.json``, ``.toml``, ``.csv``, OpticStudio's ``.txt``, Code V's ``.int``.

    JSON, TOML and CSV files must state ``order`` (nm, noll, ansi, fringe), ``unit`` (waves, radians, or a length: nm,
    um, m, ...) and ``normalization`` (rms, edge). They may state ``wavelength``, a length with its unit, and
    ``obscuration``, 0 to below 1, of annular terms. TOML::

        order = "noll"
        unit = "nm"
        normalization = "rms"
        wavelength = "632.8 nm"

        [terms]
        4 = -12.5
        7 = 31.0

    JSON: ``{"order": "nm", "unit": "waves", "normalization": "edge", "terms": {"3,1": 0.25}}``. CSV, where a line
    that begins with ``#`` is a setting if it contains a colon, and otherwise a comment::

        # order: nm
        # unit: waves
        # normalization: rms
        n, m, value
        3, 1, 0.25

    For the other orders, the columns are ``index,value``. The index column may also be called term, j, or noll, ansi
    or fringe, which states the order; its cells may be written Z4. The value column may be called coefficient, coeff
    or c, and may state the unit, and the normalization: ``coeff (waves rms)``. A column of names is ignored.

    ``.txt``: a listing of Zernike Standard, Fringe or Annular coefficients as OpticStudio writes it.
    ``.int``, ``.zfr``: a wavefront of Code V (ZRN or ZFR), converted to waves by the SSZ and WVL of the file. These
    files must state order, normalization, unit and wavelength. Signs and axis directions are not changed.

    Parameters
    ----------
    path : path

    Returns
    -------
    ZernikeTable

    Raises
    ------
    ZernikeFileError
        If an entry is missing, unknown, duplicate or invalid; one message lists all errors by key or line.
    ValueError
        If the suffix is unknown.
    OSError
        If the file cannot be read.
    """
    source = validation.path("path", path)
    if note := text_files.design_note(source):
        raise ZernikeFileError(note)
    form = find(source, verb="read")
    table: ZernikeTable | None
    try:
        table, errors = form.read(reading.contents(source, reading.MAX_LIST))
    except ValueError as error:
        raise ZernikeFileError(f"{validation.line(source)}: {reading.reason(error)}") from None
    if table is None:
        raise ZernikeFileError(text_files.joined_errors(source, errors))
    return table


def _read_toml(data: bytes) -> tuple[ZernikeTable | None, list[str]]:
    text = reading.decoded(data)
    try:
        raw = reading.toml(text)
    except ValueError as error:
        return None, [f"not valid TOML: {reading.reason(error)}"]
    return build_section(raw, lambda keys: text_files.place(text, keys))


def _read_json(data: bytes) -> tuple[ZernikeTable | None, list[str]]:
    duplicates: list[str] = []

    def unique_keys(pairs: list[tuple[str, object]]) -> dict[str, object]:
        counts = Counter(key for key, _ in pairs)
        duplicates.extend(f"{validation.key(key)}: is given twice" for key, count in counts.items() if count > 1)
        return dict(pairs)

    try:
        raw = reading.json(reading.decoded(data), unique_keys)
    except ValueError as error:
        return None, [f"not valid JSON: {reading.reason(error)}"]
    if not isinstance(raw, dict):
        return None, [f"must hold an object, got {type(raw).__name__}"]
    table, errors = build_section(raw, lambda keys: ".".join(map(validation.key, keys)))
    return (None if duplicates else table), [*duplicates, *errors]


_ERRORS = "standard_errors"  # key for other programs; readers of this package ignore it


def _write_json(settings: Mapping[str, str], terms: Mapping[str, float], errors: Mapping[str, float]) -> str:
    contents = {**settings, "terms": terms} | ({_ERRORS: errors} if errors else {})
    return json.dumps(contents, indent=2, allow_nan=False) + "\n"


def _write_toml(settings: Mapping[str, str], terms: Mapping[str, float], errors: Mapping[str, float]) -> str:
    lines = [f'{key} = "{value}"' for key, value in settings.items()]
    for name, numbers in (("terms", terms), (_ERRORS, errors)):
        if numbers or name == "terms":
            lines += ["", f"[{name}]", *(f'"{key}" = {c!r}' for key, c in numbers.items())]
    return "\n".join([*lines, ""])


def _write_csv(settings: Mapping[str, str], terms: Mapping[str, float], errors: Mapping[str, float]) -> str:
    head = [f"# {key}: {value}" for key, value in settings.items()]
    # These comments contain no colon, so that they are not read as settings.
    head += [f"# standard error of {key} = {error!r}" for key, error in errors.items()]
    columns = "n,m,value" if settings["order"] == "nm" else "index,value"
    return "\n".join([*head, columns, *(f"{key},{c!r}" for key, c in terms.items()), ""])


_form = partial(Format, "zernike")
registry.register(
    _form((".json",), _write_json, _read_json),
    _form((".toml",), _write_toml, _read_toml),
    _form((".csv",), _write_csv, lambda data: read_csv(reading.decoded(data))),
    _form((".txt",), read=read_listing, what="listing of OpticStudio"),
    _form((".int", ".zfr"), read=read_code_v, what="Code V, ZRN or ZFR"),
)
find = partial(registry.find, "zernike")
