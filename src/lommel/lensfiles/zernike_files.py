"""Zernike coefficients in JSON, TOML, CSV and the listings of lens designers: nothing about them is guessed."""

from __future__ import annotations

from collections import Counter
from functools import partial
from os import PathLike
from pathlib import Path
from typing import Any

from lommel.base import reading, validation
from lommel.io import registry
from lommel.io.registry import Format
from lommel.io.zernike_tables import ZernikeTable
from lommel.lensfiles import messages, zernike_csv, zernike_listings
from lommel.lensfiles.zernike_entries import build_section


class ZernikeFileError(ValueError):
    """A table that cannot be used; the message names every fault with its key or line."""


def load_zernike(path: str | PathLike[str]) -> ZernikeTable:
    """Read Zernike coefficients: ``.json``, ``.toml``, ``.csv``, OpticStudio's ``.txt``, Code V's ``.int``.

    In the first three, ``order`` (nm, noll, ansi, fringe), ``unit`` (waves, radians, or a length: nm, um, m, ...) and
    ``normalization`` (rms, edge) must be stated; ``wavelength``, a length with a unit, may be. TOML::

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

    For the other orders, the columns are ``index,value``. An index may also be called term, j, or by its order, which
    states it, and be written Z4; a value coefficient, coeff or c, with its unit behind it: ``coeff (waves)``. A
    column of names is left out, and one row below Z1, Z2, ... does as well.

    ``.txt``: a listing of Zernike Standard, Fringe or Annular coefficients as OpticStudio writes it, UTF-16 or not.
    Annular ones become those over the disc, of the same function. ``.int``, ``.zfr``: a wavefront in Code V's ZRN or
    ZFR, in waves by its SSZ and WVL. Order, normalisation, unit and wavelength are those that the file names; what it
    does not is refused. Signs and directions are as they stand there.

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
    form, source = registry.find("zernike", path, verb="read"), Path(path)
    table: ZernikeTable | None
    try:
        table, found = form.read(reading.contents(source, reading.MAX_LIST))
    except ValueError as error:
        raise ZernikeFileError(f"{validation.line(source)}: {reading.reason(error)}") from None
    if table is None:
        raise ZernikeFileError(messages.together(source, found))
    return table


def _read_toml(data: bytes) -> tuple[ZernikeTable | None, list[str]]:
    text = reading.decoded(data)
    try:
        raw = reading.toml(text)
    except ValueError as error:
        return None, [f"not valid TOML: {reading.reason(error)}"]
    return build_section(raw, lambda keys: messages.place(text, keys))


def _read_json(data: bytes) -> tuple[ZernikeTable | None, list[str]]:
    twice: list[str] = []

    def once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        counts = Counter(key for key, _ in pairs)
        twice.extend(f"{validation.key(key)}: is given twice" for key, count in counts.items() if count > 1)
        return dict(pairs)

    try:
        raw = reading.json(reading.decoded(data), once)
    except ValueError as error:
        return None, [f"not valid JSON: {reading.reason(error)}"]
    if not isinstance(raw, dict):
        return None, [f"must hold an object, got {type(raw).__name__}"]
    table, found = build_section(raw, lambda keys: ".".join(map(validation.key, keys)))
    return (None if twice else table), [*twice, *found]


_form = partial(Format, "zernike")
registry.register(
    _form((".json",), read=_read_json),
    _form((".toml",), read=_read_toml),
    _form((".csv",), read=lambda data: zernike_csv.read(reading.decoded(data))),
    _form((".txt",), read=zernike_listings.read),
    _form((".int", ".zfr"), read=zernike_listings.read_code_v),
)
