"""Spectral sensitivities of colour channels from CSV tables, with filters and an illuminant."""

from __future__ import annotations

import re
from collections.abc import Sequence
from os import PathLike

import numpy as np

from lommel.base import reading, validation
from lommel.base.arrays import Array
from lommel.base.units import LENGTHS
from lommel.io import text_files
from lommel.optics.colour.spectrum import Channels, checked_paths

_PATH = str | PathLike[str]
_HEAD = re.compile(r"(?:wavelengths?|wave|lambda|wl|λ)?[\s_(\[]*([^\s_()\[\]]+)[\s)\]]*", re.IGNORECASE)
_PERCENT = re.compile(r"(.*?)[\s_(\[]*(?:%|percent|per cent)[\s)\]]*", re.IGNORECASE)
_SHORTEST, _LONGEST = 1e-7, 2e-5  # metres; other wavelengths are typing errors
_LEAST = -0.01  # of the largest value: dark measurements, which count as 0


def load_channels(
    path: _PATH,
    *,
    filters: _PATH | Sequence[_PATH] = (),
    illuminant: _PATH | None = None,
    tol: float = 1e-3,
    paths: float = 5e-6,
) -> Channels:
    """Read the spectral sensitivities of colour channels from CSV files, times filters and an illuminant.

    The first line names the columns: the wavelength with its unit, as ``wavelength (nm)``, ``lambda_um`` or ``nm``,
    then one for each channel, as ``red`` or ``red (%)``. The other lines hold numbers, in any order. Lines that are
    empty or begin with ``#`` are skipped; cells end with commas, tabs or semicolons (numbers may then have a decimal
    comma). Values down to -1 % of the largest count as 0.

    Parameters
    ----------
    path : path
        Quantum efficiency of each channel, electrons per photon.
    filters : path or sequence of paths, optional
        Transmissions, each with one column beside the wavelength.
    illuminant : path, optional
        Photons at each wavelength, in any unit; constant by default.
    tol : float, default 1e-3
    paths : float, default 5e-6
        Tolerance of the spectral sampling, and the path differences it holds for; see
        :meth:`lommel.Channels.from_curves`.

    Returns
    -------
    Channels
        With ``error``, a bound on the error of the spectral sampling. Tables are interpolated linearly, and light
        beyond any of the tables is ignored.

    Raises
    ------
    TypeError, ValueError
        If a file is not such a table, with the numbers of its lines; if the tables have no wavelengths in common or a
        channel has no light; or as :meth:`lommel.Channels.from_curves`.
    OSError
        If a file cannot be read.
    """
    names, waves, curves = _table(path)
    tables = [(waves, curves)]
    single = [filters] if isinstance(filters, str | PathLike) else list(filters)
    for other in [*single, *([] if illuminant is None else [illuminant])]:
        columns, at, values = _table(other)
        if len(columns) != 1:
            raise ValueError(
                f"{validation.line(other)} must have one column beside the wavelength, got {', '.join(columns)}"
            )
        tables.append((at, values))
    low, high = max(at[0] for at, _ in tables), min(at[-1] for at, _ in tables)
    if not low < high:
        spans = ", ".join(f"{at[0] * 1e9:g} to {at[-1] * 1e9:g} nm" for at, _ in tables)
        raise ValueError(f"tables must have wavelengths in common, got {spans}")
    every = np.unique(np.concatenate([at for at, _ in tables]))
    every = every[(every >= low) & (every <= high)]
    if len(tables) > 1:  # a product of straight lines is nearly one between closer points
        every = np.interp(np.linspace(0.0, 1.0, 4 * every.size - 3), np.linspace(0.0, 1.0, every.size), every)
    product = np.ones((len(names), every.size))
    for at, values in tables:
        product *= np.stack([np.interp(every, at, row) for row in values])
    dark = [name for name, row in zip(names, product, strict=True) if not row.max() > 0.0]
    if dark:
        raise ValueError(f"{validation.line(path)}: channels must have light, got none for {', '.join(dark)}")
    checked_paths(paths, tol)  # before errors of the file
    try:
        return Channels.from_curves(every, product, names, tol=tol, paths=paths)
    except ValueError as error:
        raise ValueError(f"{validation.line(path)}: {reading.reason(error)}") from None


def _table(path: _PATH) -> tuple[list[str], Array, Array]:
    """Return names of columns, rising wavelengths in metres, and values, shape (columns, wavelengths)."""
    source = validation.path("path", path)
    try:
        text = reading.text(source, reading.MAX_LIST).removeprefix("\ufeff")
        if ";" in text:
            text = text.replace(",", ".").replace(";", ",")
        lines = list(text_files.rows(text.replace("\t", ",")))
        return _columns(lines)
    except ValueError as error:
        told = reading.reason(error)
        raise ValueError(f"{validation.line(source)}: {told}") from None


def _columns(lines: list[tuple[int, list[str]]]) -> tuple[list[str], Array, Array]:
    if not lines:
        raise ValueError("is empty; its first line must name the columns, such as wavelength (nm), red")
    place, head = lines[0]
    unit = _HEAD.fullmatch(head[0]) if head[0] else None
    if unit is None or unit[1].lower() not in LENGTHS:
        raise ValueError(
            f"line {place}: the first column must be the wavelength with its unit, such as wavelength (nm), got "
            f"{validation.shown(head[0])}"
        )
    shares = [_PERCENT.fullmatch(name) for name in head[1:]]
    names = [share[1] if share else name for share, name in zip(shares, head[1:], strict=True)]
    if not names or not all(names) or len(set(names)) != len(names):
        raise ValueError(f"line {place}: columns must have names that differ, got {validation.shown(head[1:])}")
    found, errors = [], list[str]()
    for place, row in lines[1:]:
        numbers = [text_files.number(cell) for cell in row]
        bad = [n for n in numbers if isinstance(n, str) or not np.isfinite(n)]
        if len(row) != len(head):
            errors.append(f"line {place} must have {len(head)} cells, got {len(row)}")
        elif bad:
            errors.append(f"line {place} must hold numbers, got {validation.shown(bad[0])}")
        else:
            found.append(numbers)
        if len(errors) > text_files.MANY:
            break
    text_files.refuse(errors)
    if len(found) < 2:
        raise ValueError(f"must have two wavelengths or more, got {len(found)}")
    table = np.array(sorted(found, key=lambda row: row[0]), dtype=np.float64)
    assert unit is not None
    waves, curves = table[:, 0] * LENGTHS[unit[1].lower()], np.ascontiguousarray(table[:, 1:].T)
    if same := np.flatnonzero(np.diff(waves) <= 0.0).tolist():
        raise ValueError(f"wavelength {table[same[0], 0]:g} {unit[1]} comes twice")
    for wave, said in ((waves[0], table[0, 0]), (waves[-1], table[-1, 0])):
        if not _SHORTEST * (1.0 - 1e-9) <= wave <= _LONGEST * (1.0 + 1e-9):
            raise ValueError(f"wavelength {said:g} {unit[1]} must be from 100 nm to 20 um")
    for name, row in zip(names, curves, strict=True):
        if row.min() < _LEAST * abs(row.max()):
            raise ValueError(f"{name} must be >= 0, got {row.min():g}")
    percent = np.array([0.01 if share else 1.0 for share in shares])[:, None]
    return names, waves, np.maximum(curves, 0.0) * percent
