"""Tables of Zernike coefficients over the field, as lens files and CSV files write them."""

from __future__ import annotations

import math
import re
from array import array
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from os import PathLike
from typing import Any

import numpy as np

from lommel.base import reading, validation
from lommel.base.units import parse_length
from lommel.field.maps import FieldMap
from lommel.io import text_files
from lommel.optics.pupil import Pupil, checked
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special import zernike

_MOST_COLUMNS = 1000  # more than there are terms


@dataclass(frozen=True)
class FieldTable:
    """Zernike coefficients at positions of the sensor.

    Attributes
    ----------
    positions : dict of str to tuple of float
        Either ``"height"`` or ``"x"`` and ``"y"``: metres from the axis.
    terms : dict of int to tuple of float
        Coefficients by index, each as long as the positions.
    order : str
        Of the indices: "noll", "ansi" or "fringe".

    Raises
    ------
    TypeError, ValueError
        If they have other types or differ in length.
    """

    positions: dict[str, tuple[float, ...]]
    terms: dict[int, tuple[float, ...]]
    order: str

    def __post_init__(self) -> None:
        validation.choice("order", self.order, ("noll", "ansi", "fringe"))
        places = self.positions.keys() if isinstance(self.positions, dict) else None
        if places not in ({"height"}, {"x", "y"}):
            raise TypeError(
                f'positions must be a dict of "height", or "x" and "y", got {validation.shown(self.positions)}'
            )
        if not isinstance(self.terms, dict) or not self.terms:
            raise TypeError(f"terms must be a dict of indices to coefficients, got {validation.shown(self.terms)}")
        columns = [validation.real_array(f"positions[{name!r}]", at) for name, at in self.positions.items()]
        for index, values in self.terms.items():
            zernike.term(index, self.order)
            columns.append(validation.real_array(f"terms[{validation.shown(index)}]", values))
        if any(column.ndim != 1 or column.size == 0 or column.size != columns[0].size for column in columns):
            raise ValueError(f"positions and terms must be equally long, got shapes {[c.shape for c in columns]}")

    def field_map(self, pupil: Pupil, *, unit: str, normalization: str, direction: str) -> FieldMap:
        """Return the map, with the aperture and the scale of `pupil`.

        Parameters
        ----------
        pupil : Pupil
        unit, normalization : str
            As of :meth:`lommel.Wavefront.zernike`.
        direction : {"x", "y"}
            Direction of the heights: along rising columns, or along rising rows (downwards). Coefficients are in the
            axes of the sensor in either case: the coma of heights along y is a sine.

        Returns
        -------
        FieldMap

        Raises
        ------
        TypeError, ValueError
            If a unit or a direction does not exist, or as :meth:`lommel.FieldMap.radial` and
            :meth:`lommel.FieldMap.scattered`.
        """
        validation.choice("direction", direction, ("x", "y"))
        checked(pupil)
        wavefront = Wavefront.zernike(
            self.terms, order=self.order, unit=unit, normalization=normalization, wavelength=pupil.wavelength
        )
        aperture = pupil.unaberrated()
        if "height" in self.positions:
            azimuth = 0.0 if direction == "x" else 0.5 * math.pi
            return FieldMap.radial(self.positions["height"], wavefront, azimuth=azimuth, aperture=aperture)
        x, y = (np.array(self.positions[name]) for name in ("x", "y"))
        return FieldMap.scattered(x, y, wavefront, aperture=aperture)


def read_csv(path: str | PathLike[str], order: str) -> FieldTable:
    """Read a table from a CSV file: a line of column names, then a line for each position.

    Lines that are empty or begin with ``#`` are skipped. Columns and cells are those of :func:`read_rows`.

    Parameters
    ----------
    path : path
    order : {"noll", "ansi", "fringe"}
        Of the indices.

    Returns
    -------
    FieldTable

    Raises
    ------
    ValueError
        For all errors together, each with its line.
    OSError
        If the file cannot be read.
    """
    source = validation.path("path", path)
    validation.choice("order", order, ("noll", "ansi", "fringe"))
    try:
        numbered = text_files.rows(reading.text(source))
        _, columns = next(numbered, (0, None))
        if columns is None:
            raise ValueError(f"{source.name} is empty; its first line must name the columns")
        return _table(columns, numbered, order, f"{source.name} line")
    except ValueError as error:
        raise error if source.name in str(error) else ValueError(f"{source.name}: {error}") from None


def read_rows(columns: Sequence[str], rows: Sequence[Sequence[object]], order: str) -> FieldTable:
    """Return a table from names of columns and rows of cells.

    The first column is ``height``, or the first two are ``x`` and ``y``: lengths, texts with a unit, or 0. The
    others are Zernike indices such as ``Z4``, with numbers.

    Parameters
    ----------
    columns : list of str
    rows : list of lists
    order : {"noll", "ansi", "fringe"}
        Of the indices.

    Returns
    -------
    FieldTable

    Raises
    ------
    TypeError
        If these are not lists, or a column name is not a text.
    ValueError
        For all errors together, each with its row.
    """
    for name, value in (("columns", columns), ("rows", rows)):
        if not isinstance(value, list | tuple):
            raise TypeError(f"{name} must be a list, got {validation.shown(value)}")
    if not all(isinstance(name, str) for name in columns):
        raise TypeError(f"columns must be names, got {validation.shown(columns)}")
    if not all(isinstance(row, list | tuple) for row in rows):
        raise TypeError(f"rows must be lists of cells, got {validation.shown(rows)}")
    validation.choice("order", order, ("noll", "ansi", "fringe"))
    return _table(columns, enumerate(rows, 1), order, "row")


def _table(
    columns: Sequence[str], rows: Iterable[tuple[int, Sequence[object]]], order: str, called: str
) -> FieldTable:
    """Return a table of numbered rows, which error messages name by their number behind `called`."""
    places = ("height",) if columns and columns[0] == "height" else ("x", "y")
    if tuple(columns[: len(places)]) != places:
        got = validation.brief(validation.line(", ".join(columns[:2]))) or "none"
        raise ValueError(f"the first columns must be height, or x and y, got {got}")
    errors: list[str] = []
    indices: list[int] = []
    if len(columns) > _MOST_COLUMNS:
        raise ValueError(f"there must be at most {_MOST_COLUMNS} columns, got {len(columns)}")
    for name in columns[len(places) :]:
        try:
            if not (found := re.fullmatch(r"Z(\d{1,5})", name)):
                raise ValueError(f"column {validation.shown(name)} must be a Zernike index such as Z4")
            zernike.term(int(found[1]), order)
            if int(found[1]) in indices:
                raise ValueError(f"column {name} comes twice")
            indices.append(int(found[1]))
        except ValueError as error:
            errors.append(str(error))
    if len(columns) == len(places):
        errors.append("there must be a column for a Zernike coefficient, such as Z4")
    kinds = [*(_length for _ in places), *(_coefficient for _ in columns[len(places) :])]
    # Compact arrays: Python numbers would take thirty times the memory.
    read = [array("d") for _ in columns]
    number = 0
    for number, row in rows:
        if len(errors) > text_files.MANY:
            break
        if len(row) != len(columns):
            errors.append(f"{called} {number} must have {len(columns)} cells, as there are columns, got {len(row)}")
            continue
        for values, cell, convert, name in zip(read, row, kinds, columns, strict=True):
            try:
                values.append(convert(cell))
            except ValueError as error:
                errors.append(f"{called} {number}, {name}: {error}")
    if not number:
        errors.append("there must be a row for each position, got none")
    text_files.refuse(errors)
    whole = [tuple(values) for values in read]
    count = len(places)
    return FieldTable(
        dict(zip(places, whole[:count], strict=True)), dict(zip(indices, whole[count:], strict=True)), order
    )


def _length(cell: Any) -> float:
    """Return a length in metres from a number or a text."""
    return _known(cell) if isinstance(cell, str) else validation.real("a position", parse_length(cell), unit="metres")


@lru_cache(maxsize=1024)  # positions on a grid repeat
def _known(cell: str) -> float:
    return validation.real("a position", parse_length(cell), unit="metres")


def _coefficient(cell: object) -> float:
    """Return a number from a number or a text."""
    value = text_files.number(cell) if isinstance(cell, str) else cell
    if isinstance(value, float) and math.isfinite(value):
        return value
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise ValueError(f"must be a number, got {validation.shown(cell)}")
    return validation.real("a coefficient", value)
