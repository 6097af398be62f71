"""Tables in CSV and other files: Zernike coefficients over the field, spectral sensitivities of colour channels."""

from __future__ import annotations

import math
import re
from array import array
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from os import PathLike
from typing import Any

import numpy as np

from lommel.base import reading, validation
from lommel.base.arrays import Array
from lommel.base.quantities import LENGTHS
from lommel.base.units import parse_length
from lommel.field.maps import FieldMap
from lommel.io import fits_images, text_files
from lommel.optics.colour.spectrum import Channels, checked_paths
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special import zernike

_MAX_COLUMNS = 1000  # largest number of columns of a field table; there are fewer Zernike terms
_PATH = str | PathLike[str]
_HEAD = re.compile(r"(?:wavelengths?|wave|lambda|wl|λ)?[\s_(\[]*([^\s_()\[\]]+)[\s)\]]*", re.IGNORECASE)
_PERCENT = re.compile(r"(.*?)[\s_(\[]*(?:%|percent|per cent)[\s)\]]*", re.IGNORECASE)
_SHORTEST, _LONGEST = 1e-7, 2e-5  # range of wavelengths, metres; other wavelengths are probably in a wrong unit
_MAX_POINTS = 200_000  # number of wavelengths above which curves are not refined further
_MIN_RELATIVE = -0.01  # least (value / largest value) that counts as 0: dark measurements may be negative


@dataclass(frozen=True)
class FieldTable:
    """Zernike coefficients at positions of the sensor.

    Attributes
    ----------
    positions : dict of str to tuple of float
        Either ``"height"``, or ``"x"`` and ``"y"``: distances from the axis, metres.
    terms : dict of int to tuple of float
        Coefficients at all positions for each Zernike index.
    order : str
        Order of the Zernike indices: "noll", "ansi" or "fringe".
    """

    positions: dict[str, tuple[float, ...]]
    terms: dict[int, tuple[float, ...]]
    order: str

    def field_map(self, pupil: Pupil, *, unit: str, normalization: str | None, direction: str) -> FieldMap:
        """Return the field map, with the aperture and the scale of `pupil`.

        Heights are along x (by columns) or y (by rows, downwards). Coefficients always refer to the axes of the
        sensor: the coma of heights along y is a sine term. Wavefronts are interpolated by bicubic splines if the
        positions x and y are a full rectangular grid of at least four columns and four rows. For other positions x
        and y, radial basis functions are used.
        """
        wavefront = Wavefront.zernike(
            self.terms, order=self.order, unit=unit, normalization=normalization, wavelength=pupil.wavelength
        )
        aperture = pupil.unaberrated()
        if "height" in self.positions:
            azimuth = 0.0 if direction == "x" else 0.5 * math.pi
            return FieldMap.radial(self.positions["height"], wavefront, azimuth=azimuth, aperture=aperture)
        x, y = (np.array(self.positions[name]) for name in ("x", "y"))
        columns, rows = np.unique(x), np.unique(y)
        order = np.lexsort((x, y))
        grid = np.meshgrid(columns, rows)
        # Bicubic splines need at least four points along each axis.
        is_full = min(columns.size, rows.size) >= 4 and x.size == grid[0].size
        if is_full and (x[order] == grid[0].ravel()).all() and (y[order] == grid[1].ravel()).all():
            return FieldMap.on_grid(columns, rows, wavefront[order.reshape(grid[0].shape)], aperture=aperture)
        return FieldMap.scattered(x, y, wavefront, aperture=aperture)


def read_csv(path: str | PathLike[str], order: str) -> FieldTable:
    """Read a table from a CSV file: a line of column names, then a line for each position; see :func:`read_rows`.

    Lines that are empty or begin with ``#`` are skipped. ValueError with all errors of the file, each with its line.
    """
    source = validation.path("path", path)
    try:
        numbered = text_files.rows(reading.decoded(reading.contents(source, reading.MAX_TEXT)))
        _, columns = next(numbered, (0, None))
        if columns is None:
            raise ValueError(f"{source.name} is empty; its first line must name the columns")
        return _table(columns, numbered, order, f"{source.name} line")
    except ValueError as error:
        raise error if source.name in str(error) else ValueError(f"{source.name}: {error}") from None


def read_rows(columns: Sequence[str], rows: Sequence[Sequence[object]], order: str) -> FieldTable:
    """Return a table from names of columns and rows of cells; ValueError with all errors, each with its row.

    The first column is ``height``, or the first two columns are ``x`` and ``y``. Their cells are lengths: strings
    with a unit, or 0. The names of all other columns are Zernike indices such as ``Z4``, and their cells are numbers.
    """
    return _table(columns, enumerate(rows, 1), order, "row")


def _table(
    columns: Sequence[str], rows: Iterable[tuple[int, Sequence[object]]], order: str, row_name: str
) -> FieldTable:
    """Return a table from numbered rows; in error messages a row is `row_name` and its number."""
    places = ("height",) if columns and columns[0] == "height" else ("x", "y")
    if tuple(columns[: len(places)]) != places:
        got = validation.brief(validation.line(", ".join(columns[:2]))) or "none"
        raise ValueError(f"the first columns must be height, or x and y, got {got}")
    errors: list[str] = []
    indices: list[int] = []
    if len(columns) > _MAX_COLUMNS:
        raise ValueError(f"there must be at most {_MAX_COLUMNS} columns, got {len(columns)}")
    for name in columns[len(places) :]:
        try:
            if not (match := re.fullmatch(r"Z(\d{1,5})", name)):
                raise ValueError(f"column {validation.shown(name)} must be a Zernike index such as Z4")
            zernike.term(int(match[1]), order)
            if int(match[1]) in indices:
                raise ValueError(f"column {name} occurs twice")
            indices.append(int(match[1]))
        except ValueError as error:
            errors.append(str(error))
    if len(columns) == len(places):
        errors.append("there must be a column for a Zernike coefficient, such as Z4")
    count = len(places)
    converters = [*[_length] * count, *[_coefficient] * (len(columns) - count)]
    values = [tuple(column) for column in _numbers(columns, rows, converters, row_name, errors)]
    return FieldTable(
        dict(zip(places, values[:count], strict=True)), dict(zip(indices, values[count:], strict=True)), order
    )


def _numbers(
    columns: Sequence[str],
    rows: Iterable[tuple[int, Sequence[object]]],
    converters: Sequence[Callable[[Any], float]],
    row_name: str,
    errors: list[str],
) -> list[array[float]]:
    """Return the numbers in each column of numbered rows; ValueError for earlier `errors` and errors of cells."""
    # Compact arrays need a thirtieth of the memory of Python numbers.
    numbers, number = [array("d") for _ in columns], 0
    for number, row in rows:
        if len(errors) > text_files.MANY:
            break
        if len(row) != len(columns):
            errors.append(f"{row_name} {number} must have {len(columns)} cells, one for each column, got {len(row)}")
            continue
        for values, cell, convert, name in zip(numbers, row, converters, columns, strict=True):
            try:
                values.append(convert(cell))
            except ValueError as error:
                errors.append(f"{row_name} {number}, {name}: {error}")
    if not number:
        errors.append("there must be a row for each position or wavelength, got none")
    text_files.refuse(errors)
    return numbers


def _length(cell: str | float) -> float:
    """Return a length in metres from 0 or a string with a unit."""
    return (
        _length_from_text(cell)
        if isinstance(cell, str)
        else validation.real("a position", parse_length(cell), unit="metres")
    )


@lru_cache(maxsize=1024)  # positions on a grid repeat
def _length_from_text(cell: str) -> float:
    return validation.real("a position", parse_length(cell), unit="metres")


def _coefficient(cell: object) -> float:
    """Return a finite number from a number or a string."""
    value = text_files.number(cell) if isinstance(cell, str) else cell
    if isinstance(value, float) and math.isfinite(value):
        return value
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise ValueError(f"must be a number, got {validation.shown(cell)}")
    return validation.real("a value", value)


def load_channels(
    path: _PATH,
    *,
    filters: _PATH | Sequence[_PATH] = (),
    illuminant: _PATH | None = None,
    light: str = "photons",
    detector: str = "photons",
    unit: str | None = None,
    tol: float = 1e-3,
    paths: float = 5e-6,
) -> Channels:
    """Read spectral sensitivities of colour channels from CSV, ASCII or FITS tables, times filters and a spectrum.

    The first line of a CSV table has the names of the columns. The first name is the wavelength with its unit, such
    as ``wavelength (nm)``, ``lambda_um`` or ``nm``; the other columns are channels, such as ``red`` or
    ``red (%)``. The other lines are numbers, with wavelengths in any order. Lines that are empty or begin with ``#``
    are skipped. Cells are separated by commas, tabs or semicolons; if there are semicolons, numbers may have a
    decimal comma. Negative values down to -1 % of the largest value count as 0.

    In files without commas, tabs and semicolons, columns are separated by blanks, and the line of names is optional.
    In FITS files, the first table is read; its first numeric column is the wavelength, in the unit TUNIT.

    Parameters
    ----------
    path : path
        Quantum efficiency of each channel, electrons per photon; or the throughput of a telescope's passband.
    filters : path or sequence of paths, optional
        Transmissions of filters; each table has one column in addition to the wavelength.
    illuminant : path, optional
        Spectrum of the light source or of a star, in any unit; constant by default.
    light : {"photons", "energy", "frequency"}, default "photons"
        Quantity in `illuminant`: photons or energy per wavelength (F_lambda), or energy per frequency (F_nu).
    detector : {"photons", "energy"}, default "photons"
        Quantity that pixels count. `light` and `detector` determine a power of the wavelength, by which the product
        of the tables is multiplied.
    unit : str, optional
        Unit of wavelengths, such as "angstrom" or "nm", for files that do not state it.
    tol : float, default 1e-3
        Tolerance of the spectral sampling, see :meth:`lommel.Channels.from_curves`.
    paths : float, default 5e-6
        Largest path difference for which the tolerance holds, metres.

    Returns
    -------
    Channels
        The attribute ``error`` is a bound on the error of the spectral sampling. Tables are interpolated linearly;
        light at wavelengths that are not in all tables is ignored. A product of tables is approximated by straight
        lines between closer points. The error of this approximation is estimated, not proven, and included in
        ``error``; it is at most a tenth of `tol`.

    Raises
    ------
    TypeError, ValueError
        If a file is not a valid table (errors are reported with line numbers), if the tables have no wavelengths in
        common, if a channel has no light, or if :meth:`lommel.Channels.from_curves` raises an error.
    OSError
        If a file cannot be read.

    Examples
    --------
    A star of a measured spectrum in energy, through a filter, on a detector that counts energy:

    >>> import lommel as lm
    >>> band = lm.load_channels(  # doctest: +SKIP
    ...     "V.dat", illuminant="vega.fits", light="energy", detector="energy", unit="angstrom"
    ... )
    """
    checked_paths(paths, tol)
    power = {"photons": 0.0, "energy": 1.0, "frequency": -1.0}[
        validation.choice("light", light, ("photons", "energy", "frequency"))
    ]
    power -= float(validation.choice("detector", detector, ("photons", "energy")) == "energy")
    if unit is not None:
        unit = validation.choice("unit", unit, LENGTHS)
    names, waves, curves = _curves(path, unit)
    tables = [(waves, curves)]
    filter_paths = [filters] if isinstance(filters, str | PathLike) else list(filters)
    for factor_path in [*filter_paths, *([] if illuminant is None else [illuminant])]:
        columns, table_waves, values = _curves(factor_path, unit)
        if len(columns) != 1:
            raise ValueError(
                f"{validation.line(factor_path)} must have one column besides the wavelength, got "
                f"{', '.join(columns)}"
            )
        tables.append((table_waves, values))
    low, high = max(waves[0] for waves, _ in tables), min(waves[-1] for waves, _ in tables)
    if not low < high:
        spans = ", ".join(f"{waves[0] * 1e9:g} to {waves[-1] * 1e9:g} nm" for waves, _ in tables)
        raise ValueError(f"tables must have wavelengths in common, got {spans}")
    wavelengths = np.unique(np.concatenate([waves for waves, _ in tables]))
    wavelengths = wavelengths[(wavelengths >= low) & (wavelengths <= high)]
    # Equal wavelengths in different units differ by rounding errors: only one is kept.
    wavelengths = wavelengths[np.append(True, np.diff(wavelengths) > 1e-9 * high)]
    longest = wavelengths[-1]

    def product_at(wavelengths: Array) -> Array:
        product = np.ones((len(names), wavelengths.size)) * (wavelengths / longest) ** power
        for waves, values in tables:
            product *= np.stack([np.interp(wavelengths, waves, row) for row in values])
        return np.asarray(product)

    product, product_error = product_at(wavelengths), 0.0
    if len(tables) > 1 or power:
        wavelengths, product, product_error = _refined(product_at, wavelengths, 0.1 * tol)
    empty = [name for name, row in zip(names, product, strict=True) if not row.max() > 0.0]
    if empty:
        raise ValueError(f"{validation.line(path)}: channels must have light, got none for {', '.join(empty)}")
    try:
        channels = Channels.from_curves(wavelengths, product, names, tol=max(tol - product_error, 1e-6), paths=paths)
        if channels.error + product_error > tol:
            raise ValueError(f"tol={tol:g} is too small for products of these tables; give {2.0 * tol:.1g}")
        vars(channels).update(error=channels.error + product_error)
        return channels
    except ValueError as error:
        raise ValueError(f"{validation.line(path)}: {reading.reason(error)}") from None


def _refined(curves: Callable[[Array], Array], points: Array, max_error: float) -> tuple[Array, Array, float]:
    """Return points between which curves are nearly straight, values there, and an estimate of the relative error.

    It is the error of an image computed from straight lines between the points. Refinement stops when the error is at
    most `max_error`.
    """
    while True:
        middle = 0.5 * (points[1:] + points[:-1])
        values, step = curves(points), np.diff(points)
        # The deviation at the middle is used for the whole step; for a parabola, the mean deviation is 2/3 of it.
        deviation = (np.abs(curves(middle) - 0.5 * (values[:, 1:] + values[:, :-1])) * step).sum(axis=1)
        light = np.maximum(np.trapezoid(values, points, axis=1), 1e-300)
        error = float((deviation / light).max()) if values.max(axis=1).all() else 0.0
        # The error counts twice: in the image, and in the light by which it is divided.
        if 2.0 * error <= max_error or points.size > _MAX_POINTS:
            return points, values, 2.0 * error
        points = np.sort(np.concatenate([points, middle]))


def _curves(path: _PATH, unit: str | None = None) -> tuple[list[str], Array, Array]:
    """Return names of columns, increasing wavelengths in metres, and values, shape (columns, wavelengths)."""
    source = validation.path("path", path)
    try:
        data = reading.contents(source, reading.MAX_TEXT)
        if fits_images.may_be_fits(data):
            return _fits_table(fits_images.read_columns(data, reading.MAX_TEXT), unit)
        if len(data) > reading.MAX_LIST:
            raise ValueError(f"is larger than {reading.MAX_LIST} bytes")
        text = reading.decoded(data)
        # Without commas or semicolons, blanks separate columns.
        if not any(re.search("[,;\t]", line) for line in text.splitlines() if not line.lstrip().startswith("#")):
            return _blank_separated_table(text, source.stem, unit)
        # If the comma is the decimal sign, semicolons separate columns.
        if ";" in text:
            text = text.replace(",", ".").replace(";", ",")
        return _spectral_table(text_files.rows(text.replace("\t", ",")))
    except ValueError as error:
        raise ValueError(f"{validation.line(source)}: {reading.reason(error)}") from None


def _blank_separated_table(text: str, name: str, unit: str | None) -> tuple[list[str], Array, Array]:
    """Return the table of blank-separated columns; `unit` is required if there is no line of column names.

    A single column without a name is called `name`; several columns are numbered.
    """
    lines = [(place, line[0].split()) for place, line in text_files.rows(text, "\n")]
    try:
        float(lines[0][1][0])
    except (ValueError, IndexError):
        return _spectral_table(iter(lines))  # the first line has names
    count = len(lines[0][1]) - 1
    names = [name] if count == 1 else [str(k + 1) for k in range(count)]
    return _spectral_table(iter([(0, [_stated_unit(unit), *names]), *lines]))


def _fits_table(columns: list[tuple[str, str, Array]], unit: str | None) -> tuple[list[str], Array, Array]:
    """Return the table of the columns (name, unit, values) of a FITS file; the first is the wavelength."""
    if len(columns) < 2:
        raise ValueError(f"must have at least two numeric columns, for wavelength and values, got {len(columns)}")
    tunit = columns[0][1].lower().rstrip("s")
    tunit = {"micron": "um", "a": "angstrom", "ang": "angstrom"}.get(tunit, tunit)
    head = [tunit if tunit in LENGTHS else _stated_unit(unit), *(name for name, _, _ in columns[1:])]
    rows = zip(*(values for _, _, values in columns), strict=True)
    return _spectral_table(iter([(0, head), *((k, [repr(float(x)) for x in row]) for k, row in enumerate(rows, 1))]))


def _stated_unit(unit: str | None) -> str:
    if unit is None:
        raise ValueError('states no unit of wavelengths; pass unit="nm" or "angstrom"')
    return unit


def _spectral_table(rows: Iterator[tuple[int, list[str]]]) -> tuple[list[str], Array, Array]:
    """Return names, wavelengths and values (see `_curves`) from a row of column names and rows of numbers."""
    place, head = next(rows, (0, []))
    if not head:
        raise ValueError("is empty; its first line must name the columns, such as wavelength (nm), red")
    unit = _HEAD.fullmatch(head[0])
    if unit is None or unit[1].lower() not in LENGTHS:
        raise ValueError(
            f"line {place}: the first column must be the wavelength with its unit, such as wavelength (nm), got "
            f"{validation.shown(head[0])}"
        )
    percents = [_PERCENT.fullmatch(name) for name in head[1:]]
    names = [match[1] if match else name for match, name in zip(percents, head[1:], strict=True)]
    if not names or not all(names) or len(set(names)) != len(names):
        raise ValueError(f"line {place}: columns must have different names, got {validation.shown(head[1:])}")
    table = np.array(_numbers(head, rows, [_coefficient] * len(head), "line", [])).T
    if len(table) < 2:
        raise ValueError(f"must have at least two wavelengths, got {len(table)}")
    table = table[np.argsort(table[:, 0], kind="stable")]
    waves, curves = table[:, 0] * LENGTHS[unit[1].lower()], np.ascontiguousarray(table[:, 1:].T)
    if repeated := np.flatnonzero(np.diff(waves) <= 0.0).tolist():
        raise ValueError(f"wavelength {table[repeated[0], 0]:g} {unit[1]} occurs twice")
    for metres, number in ((waves[0], table[0, 0]), (waves[-1], table[-1, 0])):
        if not _SHORTEST * (1.0 - 1e-9) <= metres <= _LONGEST * (1.0 + 1e-9):
            raise ValueError(f"wavelengths must be from 100 nm to 20 um, got {number:g} {unit[1]}")
    for name, row in zip(names, curves, strict=True):
        if row.min() < _MIN_RELATIVE * abs(row.max()):
            raise ValueError(f"{name} must be >= 0, got {row.min():g}")
    factor = np.array([0.01 if match else 1.0 for match in percents])[:, None]
    return names, waves, np.maximum(curves, 0.0) * factor
