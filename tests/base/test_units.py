"""Unit strings, as they are written on the command line and in lens files."""

from __future__ import annotations

import math
import re
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lommel.base.units import (
    camera_wavelength,
    format_length,
    parse_angle,
    parse_length,
    parse_radius,
    with_error,
    with_units,
)

LENGTHS = {
    "m": 1.0, "km": 1e3, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "µm": 1e-6, "μm": 1e-6, "nm": 1e-9, "pm": 1e-12,
    "angstrom": 1e-10, "in": 0.0254, "inch": 0.0254,
}  # fmt: skip
ANGLES = {
    "rad": 1.0,
    "mrad": 1e-3,
    "deg": math.pi / 180,
    "arcmin": math.pi / 180 / 60,
    "arcsec": math.pi / 180 / 3600,
    "mas": math.pi / 180 / 3600e3,
}
GARBAGE = [
    "", " ", "um", "abc", "1 2", "1,5 mm", "1.2.3 m", "--1 m", "1e m", "0x10 m", "1_000 m", "nan", "nan m", "1 m m",
    "1 m^2", "m 1", "٣ m", "1/2 m", "infinite", "1 m\x00", "½ m",
]  # fmt: skip
NO_TEXTS = (None, True, [1], {"m": 1}, 1j, b"1 m")


def test_every_unit_is_read_with_or_without_a_space():
    for unit, metres in LENGTHS.items():
        for text in ("{} {}", "{}{}", "  {}   {} ", "\t{}\n{}"):
            assert parse_length(text.format("2.5", unit)) == pytest.approx(2.5 * metres, rel=1e-15)
    for unit, radians in ANGLES.items():
        assert parse_angle(f"2.5 {unit}") == pytest.approx(2.5 * radians, rel=1e-15)


def test_numbers_are_written_as_usual():
    numbers = {"0": 0, "+1 m": 1, "-1 m": -1, ".5 m": 0.5, "5. m": 5, "1e-3 m": 1e-3, "1.5E+2 mm": 0.15}
    numbers |= dict.fromkeys(("inf", "+inf", "infinity", "inf m", math.inf), math.inf) | {"-inf": -math.inf, 0: 0}
    for text, metres in numbers.items():
        assert parse_length(text) == pytest.approx(metres)


@given(st.floats(-12.56, 12.56) | st.integers(-12, 12))
def test_a_plain_number_is_an_angle_in_radians(number):
    assert parse_angle(number) == number


def test_a_decimal_comma_is_told_to_be_a_point():
    with pytest.raises(ValueError, match=r"'50,5 mm' is not a length; write '50\.5 mm', with a decimal point"):
        parse_length("50,5 mm")


@pytest.mark.parametrize("number", [45, -12.6, 1e300])
def test_a_plain_number_beyond_two_turns_is_refused_as_degrees(number):
    message = re.escape(f'within two turns, 4 pi, got {number:g}; for degrees write "{number:g} deg"')
    with pytest.raises(ValueError, match="an angle without a unit must") as error:
        parse_angle(number)
    assert re.search(message, with_units(str(error.value)))


@given(st.integers(-(10**17), 10**17), st.integers(-30, 30), st.sampled_from(sorted(set(LENGTHS) - {"in", "inch"})))
def test_a_length_is_the_float_nearest_to_what_is_written(digits, power, unit):
    exact = Fraction(digits) * Fraction(10) ** power * Fraction(f"{LENGTHS[unit]:e}")
    assert parse_length(f"{digits}e{power} {unit}") == float(exact)
    assert parse_length("3.99 mm") == 3.99e-3


@given(st.integers(1, 9999), st.integers(-9, 2))
def test_four_digits_read_back_exactly(digits, power):
    metres = float(Fraction(digits) * Fraction(10) ** power)
    assert parse_length(format_length(metres)) == pytest.approx(metres, rel=1e-15)


@pytest.mark.parametrize(
    ("metres", "text"),
    [
        (0.0, "0 m"),
        (3.45e-6, "3.45 um"),
        (550e-9, "550 nm"),
        (1e-6, "1 um"),
        (0.9999999e-6, "1 um"),
        (0.05, "50 mm"),
        (2.0, "2 m"),
        (57.6, "57.6 m"),
        (-3e-3, "-3 mm"),
        (1e-10, "0.1 nm"),
        (math.inf, "infinity"),
        (-math.inf, "-infinity"),
    ],
)
def test_lengths_are_shown_with_a_unit_that_suits_them(metres, text):
    assert format_length(metres) == text
    assert parse_length(text) == pytest.approx(metres, rel=1e-6)


@pytest.mark.parametrize(
    ("parse", "values", "message"),
    [
        (parse_length, GARBAGE, " length"),
        (parse_angle, GARBAGE, " angle"),
        (parse_length, ("50", "1", "-2.5e-3", 50, 0.05), "is a length without a unit; write for example '550 nm'"),
        (parse_length, ("1 kg", "1 MM", "1 furlong", "1 deg", "1 Nm"), "unknown unit '"),
        (parse_angle, ("1 um",), "unknown unit 'um'; an? angle is in rad, mrad, deg, arcmin, arcsec, mas"),
        (parse_length, NO_TEXTS, "is a number with a unit, a text such as"),
        (parse_angle, NO_TEXTS, "is a number with a unit, a text such as"),
        (parse_length, ("1e400 m", "-1e999", "1e308 km"), "exceeds the range of numbers"),
    ],
)
def test_what_is_no_length_or_angle_is_refused(parse, values, message):
    for value in values:
        with pytest.raises(ValueError, match=message) as caught:
            parse(value)
        assert "unknown" in message or str(value) in str(caught.value) or repr(value) in str(caught.value)


@given(st.text(max_size=12))
def test_any_text_is_a_number_of_metres_or_a_value_error(text):
    message = ""
    try:
        assert not math.isnan(parse_length(text))
    except ValueError as error:
        message = str(error)
    # A message shows several spaces in a row as one.
    assert not message or " ".join(repr(text).split()) in message


def test_a_radius_on_the_sensor_is_a_length_or_an_angle_on_the_sky():
    assert parse_radius("28 um", 57.6) == pytest.approx(28e-6)
    assert parse_radius("0.1 arcsec", 57.6) == pytest.approx(57.6 * 0.1 * math.pi / 648000)
    assert parse_radius("1 mrad", 2.0) == pytest.approx(2e-3)


@pytest.mark.parametrize(
    ("value", "error", "texts"),
    [
        (1.23456, 0.0123, ("1.235", "0.012")),
        (-1.23456, 0.99, ("-1.23", "0.99")),
        (123.4, 23.4, ("123", "23")),
        (1.23456, 3.4, ("1.2", "3.4")),
        (1.2345678, 0.0, ("1.23457", "0")),
        (1.2345678, math.inf, ("1.23457", "inf")),
        (0.5, 4e-308, (f"0.5{'0' * 299}", f"0.{'0' * 300}")),
    ],
)
def test_a_number_has_as_many_digits_as_its_error_allows(value, error, texts):
    assert with_error(value, error) == texts
    assert with_error(value, error, most=1)[0] == (f"{value:.1f}" if 0.0 < error < 10.0 else texts[0])


@pytest.mark.parametrize("symbol", ["\u00c5", "\u212b"])
def test_the_symbol_of_the_angstrom_is_a_unit(symbol):
    assert parse_length(f"5875.6 {symbol}") == 5875.6e-10


@pytest.mark.parametrize(("metres", "likely"), [(550e-6, "550 nm"), (0.55, "550 nm"), (5.5e-10, "550 nm")])
def test_a_wavelength_that_no_camera_records_is_refused_with_the_likely_one(metres, likely):
    with pytest.raises(ValueError, match=rf"a must be from 10 nm to 100 um, .*; did you mean {likely}\?"):
        camera_wavelength("a", metres)
    assert camera_wavelength("a", 10e-6) == 10e-6
