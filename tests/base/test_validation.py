"""The checks that every public entry shares: what they let through, and what their messages say."""

from __future__ import annotations

import math
import os
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lommel.base import validation

NUMBERS = [1, 1.0, Fraction(1), np.float32(1), np.float64(1), np.int8(1), np.uint64(1), np.array(1.0)]


def test_every_kind_of_number_is_taken():
    for value in NUMBERS:
        number = validation.real("x", value)
        assert type(number) is float
        assert number == 1.0
    for value in (3, np.int64(3), np.uint8(3)):
        number = validation.integer("n", value, least=1, most=3)
        assert type(number) is int
        assert number == 3
    for value, sides in ((5, (5, 5)), ((5, 7), (5, 7)), ([5, 7], (5, 7)), (np.array([5, 7]), (5, 7))):
        assert validation.image_shape(value) == sides
    assert validation.choice("mode", "b", ("a", "b")) == "b"


@pytest.mark.parametrize(
    ("check", "values", "error", "message"),
    [
        (lambda x: validation.integer("n", x, least=1, most=5), (0, 6, -1, 10**30), ValueError, "n must be"),
        (lambda x: validation.fill("f", x), ((0.9,), (0.9, 0.8, 0.7), []), ValueError, "f must be one number, or"),
        (lambda x: validation.kind("d", x, np.uint8), (np.float32(np.nan), np.uint8(3)), TypeError, "d must be "),
        (validation.wavelength, (1e-13, 0.011, 1e6), ValueError, r"wavelength .* from 1e-12 to 1e-2, got \S+$"),
        (lambda x: validation.wavelength(x, "centers"), (2.5,), ValueError, "centers is in metres and must be from"),
    ],
)
def test_nothing_else_is(check, values, error, message):
    for value in values:
        with pytest.raises(error, match=message):
            check(value)


def test_infinity_is_a_distance_where_that_is_allowed_and_minus_infinity_never_is():
    assert validation.real("x", math.inf, above=0.0, infinite=True) == math.inf
    assert validation.real("x", math.inf, below=1.0, infinite=True) == math.inf
    with pytest.raises(ValueError, match="x must not be -infinity"):
        validation.real("x", -math.inf, infinite=True)
    with pytest.raises(ValueError, match="x must be finite, got nan"):
        validation.real("x", math.nan, infinite=True)


@given(st.lists(st.floats(-1e300, 1e300), min_size=1, max_size=5))
def test_arrays_of_real_numbers_are_copied_and_read_only(values):
    given_array = np.array(values)
    array = validation.real_array("a", given_array)
    assert array.dtype == np.float64
    np.testing.assert_array_equal(array, given_array)
    assert not array.flags.writeable
    assert given_array.flags.writeable
    assert not np.shares_memory(array, given_array)


@pytest.mark.parametrize("metres", [1e-12, 13.5e-9, 550e-9, 10.6e-6, 1e-2])
def test_wavelengths_from_gamma_rays_to_microwaves_are_wavelengths(metres):
    assert validation.wavelength(metres) == metres


@pytest.mark.parametrize(
    ("value", "fix"),
    [(550, "for 550 nm give 550e-9"), (1064.0, "1064e-9"), (0.55, "for 0.55 um give 0.55e-6"), (10.6, "10.6e-6")],
)
def test_a_wavelength_that_was_meant_in_another_unit_is_refused_with_the_fix(value, fix):
    with pytest.raises(ValueError, match=f"wavelength is in metres .* got {value:g}; .*{fix}"):
        validation.wavelength(value)


@pytest.mark.parametrize(("value", "fix"), [(3.45, "for 3.45 um give 3.45e-6"), (12, "12e-6")])
def test_a_pixel_that_was_meant_in_micrometres_is_refused_with_the_fix(value, fix):
    with pytest.raises(ValueError, match=f"pixel is in metres .* got {value:g}; .*{fix}"):
        validation.pixel(value, metric=True)
    assert validation.pixel(value, metric=False) == value


def test_the_active_part_of_a_pixel_is_a_part_of_its_area_or_of_both_sides():
    assert validation.fill("fill", 0.25) == (0.5, 0.5)
    assert validation.fill("fill", (0.9, 1.0)) == (0.9, 1.0)


def test_names_of_files_are_readable_in_a_locale_that_does_not_know_their_letters():
    name = "/data/\udcc3\udcbc.toml"  # as Python keeps bytes that it cannot decode
    assert validation.line(name) == "/data/ü.toml"
    assert validation.shown(name) == "'/data/ü.toml'"
    assert validation.line("a\udcff\nb") == "a\ufffd\\nb"
    assert validation.line("a\ud800") == "a\\ud800"  # of no file


@pytest.mark.parametrize("more", [{}, {"PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}], ids=["utf-8", "ascii"])
def test_an_error_names_the_file_in_the_locale_of_plain_c(more, tmp_path):
    (tmp_path / "bäd.toml").write_text("x =\n")
    call = (
        "import lommel, sys\ntry: lommel.load_instrument(sys.argv[1])\nexcept ValueError as e: print(ascii(str(e)))"
    )
    command = [sys.executable, "-c", call, str(tmp_path / "bäd.toml")]
    env = {name: value for name, value in os.environ.items() if not name.startswith("LC_")} | {"LC_ALL": "C"} | more
    found = subprocess.run(command, env=env, capture_output=True, text=True, check=True).stdout
    assert "b\\xe4d.toml: not valid TOML" in found
