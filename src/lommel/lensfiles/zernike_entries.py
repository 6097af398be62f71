"""What tables of Zernike coefficients must say: from keys and terms to a table, or every fault in them."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from lommel.base import validation
from lommel.base.options import near
from lommel.base.units import parse_length
from lommel.io.zernike_tables import UNITS, ZernikeTable
from lommel.lensfiles import messages
from lommel.optics.descriptions import NORMALIZATIONS
from lommel.optics.wavefront import Wavefront
from lommel.special import zernike

SETTINGS = ("order", "unit", "normalization", "wavelength")
_MOST_TERMS = 4096  # more than there are
_PAIR = re.compile(r"\(?\s*([+-]?\d+)\s*,\s*([+-]?\d+)\s*\)?", re.ASCII)

_Index = int | tuple[int, int]
_Where = Callable[[str], str]


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


def _index(text: str, order: str) -> _Index:
    if order == "nm":
        pair = _PAIR.fullmatch(text.strip())
        if not pair:
            raise ValueError(f'an index of the order "nm" is written "n,m", got {validation.shown(text)}')
        return int(pair[1]), int(pair[2])
    if not re.fullmatch(r"\s*[+-]?\d+\s*", text, re.ASCII):
        raise ValueError(f"an index of the order {order!r} is an integer, got {validation.shown(text)}")
    return int(text)
