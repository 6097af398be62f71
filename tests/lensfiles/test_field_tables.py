"""Tables of Zernike coefficients over the field: what they say, and how every fault in them is told."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

import lommel as lm
from lommel.lensfiles.tables import FieldTable, read_csv, read_rows

PUPIL = lm.Pupil(wavelength=550e-9, f_number=2.0, obscuration=0.1)
PLAIN = {"unit": "waves", "normalization": "rms", "direction": "x"}


def test_a_table_has_heights_as_lengths_and_coefficients_by_index():
    table = read_rows(["height", "Z4", "Z8"], [["0 mm", 0.5, 0], ["5 mm", 0.25, 1], ["1 cm", -1, "0.3"]], "noll")
    assert table == FieldTable({"height": (0.0, 0.005, 0.01)}, {4: (0.5, 0.25, -1.0), 8: (0.0, 1.0, 0.3)}, "noll")


def test_a_csv_file_says_the_same(tmp_path):
    file = tmp_path / "field.csv"
    file.write_text(
        '\ufeff# a lens\nx, y, Z4\r\n0 mm,0,1e-1\n\n1 mm, 2 mm ,0.2\n"-3 mm",1000 um,-.3\n', encoding="utf-8"
    )
    table = read_csv(file, "fringe")
    assert table == FieldTable({"x": (0.0, 1e-3, -3e-3), "y": (0.0, 2e-3, 1e-3)}, {4: (0.1, 0.2, -0.3)}, "fringe")


@pytest.mark.parametrize(("direction", "at"), [("x", (4e-3, 0.0)), ("y", (0.0, 4e-3))])
@pytest.mark.parametrize("unit", ["waves", "radians", "metres"])
@pytest.mark.parametrize("normalization", ["rms", "edge"])
def test_heights_are_along_the_direction_and_coefficients_in_their_unit(direction, at, unit, normalization):
    table = FieldTable({"height": (0.0, 4e-3)}, {4: (0.1, 0.3), 8: (0.0, 0.2)}, "noll")
    field = table.field_map(PUPIL, unit=unit, normalization=normalization, direction=direction)
    found = field.pupil(*at)
    expected = lm.Wavefront.zernike(
        {4: 0.3, 8: 0.2}, order="noll", unit=unit, normalization=normalization, wavelength=550e-9
    )
    difference = found.wavefront - expected
    size = abs(float(expected.defocus))
    assert abs(float(difference.defocus)) < 1e-12 * size
    assert all(abs(float(c)) < 1e-12 * size for c in difference.nonradial.values())
    assert (found.wavelength, found.f_number, found.obscuration) == (550e-9, 2.0, 0.1)


def test_positions_anywhere_make_a_scattered_map():
    table = read_rows(["x", "y", "Z4"], [[0, 0, 0.0], ["1 mm", 0, 1.0], [0, "1 mm", 2.0]], "noll")
    field = table.field_map(PUPIL, **PLAIN)
    found = field.pupil(np.array([0.5e-3, 0.0]), np.array([0.0, 0.5e-3])).wavefront.to_zernike(unit="waves")
    np.testing.assert_allclose(found[2, 0], [0.5, 1.0])


@pytest.mark.parametrize(
    ("columns", "rows", "what"),
    [
        (["Z4"], [[1]], "the first columns must be height, or x and y, got Z4"),
        (["y", "x", "Z4"], [[0, 0, 1]], "must be height, or x and y, got y, x"),
        (["x"], [[0]], "must be height, or x and y, got x"),
        (["height"], [[0]], "there must be a column for a Zernike coefficient"),
        (["height", "4"], [[0, 1]], "column '4' must be a Zernike index such as Z4"),
        (["height", "Z0"], [[0, 1]], "a Zernike index in the order 'noll' must be from 1 to 1891, got 0"),
        (["height", "Z4", "Z4"], [[0, 1, 1]], "column Z4 comes twice"),
        (["height", "Z4"], [], "there must be a row for each position or wavelength, got none"),
        (["height", "Z4"], [[0]], "row 1 must have 2 cells, as there are columns, got 1"),
        (["height", "Z4"], [[0, 1], ["5 kg", 2]], "row 2, height: '5 kg' has the unknown unit 'kg'"),
        (["height", "Z4"], [["inf", 2]], "row 1, height: a position must be finite, got inf"),
        (["height", "Z4"], [[0, "a"]], "row 1, Z4: must be a number, got 'a'"),
        (["height", "Z4"], [[0, True]], "row 1, Z4: must be a number, got True"),
        (["height", "Z4"], [[0, math.nan]], "row 1, Z4: a value must be finite, got nan"),
        (["height", "Z4"], [[0, "nan"]], "row 1, Z4: a value must be finite, got nan"),
    ],
)
def test_a_fault_is_told_with_its_row_and_column(columns, rows, what):
    with pytest.raises(ValueError, match=re.escape(what)):
        read_rows(columns, rows, "noll")


@pytest.mark.parametrize(
    ("data", "what"),
    [
        (b"", "field.csv is empty; its first line must name the columns"),
        (b"# nothing\n\n", "field.csv is empty"),
        (b"height,Z4\n0,1\n\n1 mm,x\n", "field.csv line 4, Z4: must be a number, got 'x'"),
        (b"height,Z4\n\xff,1\n", "field.csv: not UTF-8 text"),
    ],
)
def test_a_faulty_file_is_told_with_its_name_and_line(data, what, tmp_path):
    (tmp_path / "field.csv").write_bytes(data)
    with pytest.raises(ValueError, match=re.escape(what)):
        read_csv(tmp_path / "field.csv", "noll")
