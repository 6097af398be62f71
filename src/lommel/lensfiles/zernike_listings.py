"""Zernike coefficients as lens designers' programs list them: OpticStudio's text, and Code V's interferograms."""

from __future__ import annotations

import codecs
import math
import re

from lommel.base import reading, validation
from lommel.base.units import LENGTHS
from lommel.io import code_v
from lommel.io.zernike_tables import ZernikeTable
from lommel.special import annular, zernike

_KIND = re.compile(r"^\s*(?:Listing of|Using)\b.*?\b(Standard|Fringe|Annular)\b", re.MULTILINE | re.IGNORECASE)
_WAVES = re.compile(r"^\s*(?:Peak to Valley|RMS|Maximum fit)\b.*?:\s*[\d.,eE+-]+\s+waves\s*$", re.MULTILINE)
_WAVELENGTH = re.compile(r"^\s*Wavelength\s*:\s*([\d.,]+)\s*(\S+)\s*$", re.MULTILINE)
_RATIO = re.compile(r"^\s*(?:Obscuration|Epsilon|Annular ratio)[\w ]*:\s*([\d.,]+)\s*$", re.MULTILINE | re.IGNORECASE)
_TERM = re.compile(r"^\s*Z\s*(\d{1,4})\s*[:=]?\s*([+-]?[\d.,]+(?:[eE][+-]?\d+)?)\s*(?::.*)?$", re.ASCII)
_ENTRY = re.compile(r"^\s*Z\s*\d", re.ASCII)
_BOMS = {codecs.BOM_UTF16_LE: "utf-16", codecs.BOM_UTF16_BE: "utf-16", codecs.BOM_UTF8: "utf-8-sig"}


def read(data: bytes) -> tuple[ZernikeTable | None, list[str]]:
    """Return the coefficients of a listing by OpticStudio, or every fault in it."""
    text, found = _text(data), []
    kinds = {kind.lower() for kind in _KIND.findall(text)}
    if len(kinds) != 1:
        told = f"got {' and '.join(sorted(kinds))}" if kinds else "which the line 'Listing of Zernike ...' states"
        found.append(f"the terms must be Standard, Fringe or Annular, {told}")
    if not _WAVES.search(text):
        found.append("the unit is not stated; listings have 'Peak to Valley ... waves'")
    wavelength = None
    if waves := _WAVELENGTH.search(text):
        if waves[2] in LENGTHS:
            wavelength = validation.wavelength(_number(waves[1]) * LENGTHS[waves[2]])
        else:
            found.append(f"the wavelength has the unknown unit {validation.shown(waves[2])}")
    annulus, kind = _RATIO.search(text), "".join(kinds)
    if kind == "annular" and not annulus:
        found.append("the obscuration of the annulus is not stated")
    terms: dict[int, float] = {}
    for place, line in enumerate(text.splitlines(), 1):
        entry = _TERM.match(line)
        if not entry:
            if _ENTRY.match(line):
                found.append(f"line {place}: a term must have a number and a value, got {validation.shown(line)}")
            continue
        index, value = int(entry[1]), _number(entry[2])
        if index in terms:
            found.append(f"line {place}: the term {index} was given before")
        elif not math.isfinite(value):
            found.append(f"line {place}: the term {index} must be a finite number, got {validation.shown(entry[2])}")
        terms[index] = value
    if not terms:
        found.append("it lists no term, such as 'Z   4     0.25'")
    if found:
        return None, found
    if kind == "fringe":
        return ZernikeTable(terms, "fringe", "waves", "edge", wavelength), []
    if annulus and kind == "annular":
        inner = validation.real("the obscuration", _number(annulus[1]), least=0.0, below=1.0)
        disc = annular.over_disc({zernike.term(j, "noll"): c for j, c in terms.items()}, inner)
        terms = {zernike.index_of(n, m, "noll"): c for (n, m), c in disc.items()}
    return ZernikeTable(dict(sorted(terms.items())), "noll", "waves", "rms", wavelength), []


def read_code_v(data: bytes) -> tuple[ZernikeTable | None, list[str]]:
    """Return the coefficients in a file of Code V; ValueError for what is wrong."""
    held = code_v.parse(_text(data))
    if held.kind == "GRD":
        raise ValueError("it holds a grid, no coefficients; load_opd reads it")
    if held.missing.any():
        raise ValueError(f"the term {held.missing.argmax() + 1} has no value (NDA)")
    indexed = dict(enumerate(held.values.tolist(), 1))
    if held.kind == "ZFR":
        return ZernikeTable(indexed, "fringe", "waves", "edge", held.wavelength), []
    pairs = {code_v.term(j): c for j, c in indexed.items()}
    return ZernikeTable(pairs, "nm", "waves", "edge", held.wavelength), []


def _text(data: bytes) -> str:
    """Return a text in UTF-16 or UTF-8, as it says at its start, or else in UTF-8 or Windows' own."""
    named = next((name for start, name in _BOMS.items() if data.startswith(start)), None)
    if named is None:
        try:
            return reading.decoded(data)
        except ValueError:
            named = "latin-1"
    try:
        return "\n".join(data.decode(named).splitlines())
    except UnicodeDecodeError as error:
        raise ValueError(f"not {named} text: {error}") from None


def _number(text: str) -> float:
    """Return a number whose decimal point may be a comma; NaN if it is none."""
    try:
        return float(text.replace(",", ".") if text.count(",") == 1 and "." not in text else text)
    except ValueError:
        return math.nan
