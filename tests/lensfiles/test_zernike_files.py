"""Tables of Zernike coefficients: what they may say, how every fault is told, and that they come back unchanged."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm
from lommel.io.zernike_tables import ZernikeFileError, ZernikeTable
from lommel.special import zernike

SUFFIXES = (".json", ".toml", ".csv")

TOML = """\
order = "noll"
unit = "nm"
normalization = "rms"
wavelength = "632.8 nm"

[terms]
4 = -12.5
7 = 31
"""
JSON = """\
{
  "order": "noll", "unit": "nm", "normalization": "rms", "wavelength": "632.8 nm",
  "terms": {"4": -12.5, "7": 31}
}
"""
CSV = """\
# a comment
# order: noll
# unit: nm
# normalization: rms
# wavelength: 632.8 nm

index, value
4, -12.5
7, 31
"""
TEXTS = {".toml": TOML, ".json": JSON, ".csv": CSV}


@pytest.fixture
def load(tmp_path: Path):
    def write_and_load(suffix: str, text: str) -> ZernikeTable:
        file = tmp_path / f"table{suffix}"
        file.write_text(text, encoding="utf-8")
        return lm.load_zernike(file)

    return write_and_load


def faults(load, suffix: str, text: str) -> list[str]:
    """The faults that are told about a table."""
    with pytest.raises(ZernikeFileError) as caught:
        load(suffix, text)
    message = str(caught.value).split(f"table{suffix}: ", 1)[-1]
    return [line.strip() for line in message.strip().split("\n")]


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_every_format_holds_the_same_table(load, suffix):
    table = load(suffix, TEXTS[suffix])
    assert table == ZernikeTable({4: -12.5, 7: 31.0}, "noll", "nm", "rms", 632.8e-9)
    assert table == load(suffix, "\ufeff" + TEXTS[suffix].replace("\n", "\r\n"))
    options = {"order": "noll", "wavelength": 632.8e-9}
    assert table.wavefront() == lm.Wavefront.zernike({4: -12.5, 7: 31.0}, unit="nm", **options)
    expected = lm.Wavefront.zernike({4: 1e-9 * -12.5, 7: 1e-9 * 31}, unit="metres", **options)
    found = table.wavefront().edge_terms()
    assert {term: float(c) for term, c in found.items()} == pytest.approx(
        {term: float(c) for term, c in expected.edge_terms().items()}, rel=1e-14
    )


def test_semicolons_separate_decimal_commas(load):
    text = "# order: noll\n# unit: waves\n# normalization: rms\nindex;value\n4;0,25\n7;-1,5e-3\n8;0.5\n"
    assert load(".csv", text).terms == {4: 0.25, 7: -1.5e-3, 8: 0.5}
    assert "line 5" in faults(load, ".csv", text.replace("0,25", "1.000,25"))[0]


def test_the_order_nm_has_two_columns_or_a_pair_for_a_key(load):
    text = "# order: nm\n# unit: waves\n# normalization: edge\nn,m,value\n3,1,0.25\n2,-2,1e-3\n"
    expected = ZernikeTable({(3, 1): 0.25, (2, -2): 1e-3}, "nm", "waves", "edge")
    assert load(".csv", text) == expected
    head = 'order = "nm"\nunit = "waves"\nnormalization = "edge"\n[terms]\n'
    assert load(".toml", f'{head}"3,1" = 0.25\n"(2, -2)" = 1e-3\n') == expected


def test_a_table_of_annular_terms_states_the_obscuration(load, tmp_path):
    text = "# order: noll\n# unit: waves\n# normalization: rms\n# obscuration: 0.61\nindex,value\n7,0.2\n11,-0.1\n"
    table = load(".csv", text)
    assert table.obscuration == 0.61
    expected = lm.Wavefront.zernike({7: 0.2, 11: -0.1}, order="noll", unit="waves", obscuration=0.61)
    assert table.wavefront() == expected
    expected.save(tmp_path / "again.toml", obscuration=0.61)
    again = lm.load_zernike(tmp_path / "again.toml")
    assert again.terms == pytest.approx({7: 0.2, 11: -0.1}, rel=1e-12)
    for value in ("1.0", "wide", "-0.1", "nan"):
        with pytest.raises(ZernikeFileError, match=r"obscuration \(line 4\): it must be .*, got"):
            load(".csv", text.replace("0.61", value))
    with pytest.raises(ZernikeFileError, match=r"up to n = 60 .* nearly linearly dependent"):
        load(".csv", text.replace("noll", "ansi").replace("0.61", "0.9").replace("7,0.2", "1860,0.2"))


coefficient = st.floats(-1e3, 1e3)


@given(
    st.sampled_from(zernike.ORDERS),
    st.sampled_from(["waves", "radians", "metres", "um", "nm"]),
    st.sampled_from(["rms", "edge"]),
    st.one_of(st.none(), st.floats(1e-7, 1e-5)),
    st.dictionaries(st.integers(2, 37), coefficient, min_size=1, max_size=6),
    st.one_of(st.just(0.0), st.floats(1e-3, 0.7)),
    st.sampled_from(SUFFIXES),
)
def test_what_is_written_is_read_back_to_the_last_digit(
    tmp_path_factory, order, unit, normalization, wavelength, terms, obscuration, suffix
):
    indexed = {zernike.index_of(*zernike.term(j, "fringe"), order): c for j, c in terms.items()}
    table = ZernikeTable(indexed, order, unit, normalization, wavelength, obscuration)
    file = tmp_path_factory.getbasetemp() / f"again{suffix}"
    lm.save_zernike(file, table)
    assert lm.load_zernike(file) == table


@pytest.mark.parametrize(
    ("line", "instead", "told"),
    [
        ('order = "noll"\n', "", "order: is missing; it is one of nm, noll, ansi, fringe"),
        ('unit = "nm"\n', "", "unit: is missing; it is one of radians, waves, metres"),
        ('normalization = "rms"\n', "", "normalization: is missing; it is one of rms, edge"),
        ('"632.8 nm"', '"632.8 ns"', "wavelength (line 4): '632.8 ns' has the unknown unit 'ns'"),
        ("normalization", "normalisation", "normalisation (line 3): unknown key; did you mean normalization?"),
        ("7 = 31", "04 = 31", "terms.04 (line 8): the term 04 was given before, terms.4 (line 7)"),
    ],
)
def test_a_fault_is_told_with_its_key_and_line(load, line, instead, told):
    assert TOML.count(line) == 1
    assert any(fault.startswith(told) for fault in faults(load, ".toml", TOML.replace(line, instead)))


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ('"4": -12.5', '"4": -12.5, "4": 1', "4: is given twice"),
        ('"unit": "nm"', '"unit": "nm", "unit": "nm"', "unit: is given twice"),
        ('"4": -12.5', '"4": NaN', "terms.4: the coefficient must be finite, got nan"),
        ('"unit": "nm"', '"unit": "kg"', "unit: must be one of radians, waves, metres"),
        ('"terms": {', '"terms": {}, "not": {', "terms: is missing or empty; it holds the coefficients by index"),
        ('"terms": {', '"terms": 5, "not": {', "terms: must map indices to coefficients, got 5"),
        (
            '"4": -12.5',
            ", ".join(f'"{k}a": 0' for k in range(1, 4097)),
            "terms: must be at most 4096 coefficients, got 4097",
        ),
    ],
)
def test_a_fault_of_json_is_told_with_its_key(load, old, new, told):
    assert old in JSON
    assert any(fault.startswith(told) for fault in faults(load, ".json", JSON.replace(old, new)))


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("# unit: nm\n", "", "unit: is missing"),
        ("# unit: nm", "# unit: nm\n# unit: um", "unit (line 4): is given twice, first in line 3"),
        ("index, value", "ansi, value", "line 7: the columns state the order ansi, line 2 states noll"),
        ("7, 31", "7, 31, 5", "line 9: must have 2 cells, got 3: 7, 31, 5"),
        ("7, 31", "4, 31", "line 9: the term 4 was given before, line 8"),
        ("noll", "nm", "line 7: the columns must be n,m,value, got index, value"),
    ],
)
def test_a_fault_of_csv_is_told_with_its_line(load, old, new, told):
    assert old in CSV
    assert any(fault.startswith(told) for fault in faults(load, ".csv", CSV.replace(old, new)))


@pytest.mark.parametrize("stated", ["(waves rms)", "[rms waves]", "_waves"])
def test_columns_may_state_unit_and_normalization(load, stated):
    text = f"noll,coeff {stated}\n4,0.25\n".replace(" _", "_")
    if "rms" not in stated:
        told = faults(load, ".csv", text)
        assert told == ["normalization: is missing; it is one of rms, edge: state it in a line # normalization: rms"]
        text = told[0].rpartition("a line ")[2] + "\n" + text
    assert load(".csv", text) == ZernikeTable({4: 0.25}, "noll", "waves", "rms")
    # One wave of Noll's defocus is 2 sqrt(3) rho^2 less its mean.
    phase = load(".csv", text).wavefront().phase([0.0, 1.0], 0.0)
    assert phase[1] - phase[0] == pytest.approx(0.25 * 2 * math.pi * 2 * math.sqrt(3))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("osa,value (waves rms)\n4,1\n", ["line 1: the columns must be index,value, got osa, value (waves rms)"]),
        ("noll,value (waves nm)\n4,1\n", ["line 1: the columns must be index,value, got noll, value (waves nm)"]),
        ("noll,value (waves peak)\n4,1\n", ["line 1: the columns must be index,value, got noll, value (waves peak)"]),
        ("# order: osa\nj,c (um rms)\n4,1\n", ["order (line 1): must be one of nm, noll, ansi, fringe, got 'osa'"]),
        (
            "# normalization: edge\nnoll,c (um rms)\n4,1\n",
            ["line 2: the columns state the normalization rms, line 1"],
        ),
    ],
)
def test_names_of_other_programs_are_told_once_with_the_name_here(load, text, told):
    found = faults(load, ".csv", text)
    assert len(found) == len(told)
    assert found[0].startswith(told[0])
    if "osa" in text:
        assert "OSA" in found[0]
        assert "ansi" in found[0]
