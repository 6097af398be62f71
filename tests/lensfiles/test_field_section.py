"""The section [field] of lens files: three ways to say what changes over the sensor, and how faults are told."""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path

import numpy as np
import pytest

import lommel as lm
from lommel.lensfiles.lens_files import LensFileError

LENS = """\
name = "camera"

[lens]
focal_length = "50 mm"
f_number = 2.0
focus_distance = "2 m"
wavelength = "550 nm"

[aberrations]
W040 = 0.25

[object]
distance = "1.9 m"

[sensor]
pixel = "3.45 um"
shape = 33

[field]
"""
SENSOR = 'sensor = ["24 mm", "36 mm"]\n'
SEIDEL = SENSOR + "W131 = 2.0\nW222 = -1\n"
TABLE = SENSOR + 'columns = ["height", "Z4", "Z8"]\nrows = [["0 mm", 0.1, 0], ["22 mm", 0.5, 0.3]]\n'


@pytest.fixture
def load(tmp_path: Path):
    def write_and_load(text: str) -> lm.Instrument:
        (tmp_path / "lens.toml").write_text(LENS + text, encoding="utf-8")
        return lm.load_instrument(tmp_path / "lens.toml")

    return write_and_load


def same(one: lm.Wavefront, other: lm.Wavefront) -> bool:
    rest = one - other
    return all(np.abs(c).max() < 1e-10 for c in (rest.coefficients, *rest.nonradial.values()))


def test_seidel_coefficients_hold_at_the_corner_of_the_sensor_unless_told_otherwise(load):
    instrument = load(SEIDEL)
    assert instrument.sensor == pytest.approx((0.024, 0.036))
    corner = math.hypot(12e-3, 18e-3)
    expected = instrument.pupil().wavefront + lm.Wavefront.from_seidel(W131=2.0, W222=-1.0)
    assert same(instrument.field().pupil(corner, 0.0).wavefront, expected)
    assert load(SEIDEL + 'edge = "30 mm"\n').field().reach == pytest.approx(0.03)


def test_what_the_field_adds_comes_to_the_defocus_and_the_aberrations_of_the_lens(load):
    instrument = load(SEIDEL)
    pupil = instrument.field().pupil(0.0, 0.0)
    assert same(pupil.wavefront, instrument.pupil().wavefront)
    assert (pupil.wavelength, pupil.f_number) == (550e-9, instrument.lens.working_f_number)
    nearer = dataclasses.replace(instrument, object_distance=1.5)
    assert same(nearer.field().pupil(0.0, 0.0).wavefront, instrument.lens.pupil(1.5).wavefront)


def test_a_table_in_the_file_and_one_beside_it_say_the_same(load, tmp_path):
    inside = load(TABLE).field().pupil(10e-3, 5e-3)
    (tmp_path / "field.csv").write_text("height,Z4,Z8\n0 mm,0.1,0\n22 mm,0.5,0.3\n")
    assert same(load(SENSOR + 'file = "field.csv"\n').field().pupil(10e-3, 5e-3).wavefront, inside.wavefront)
    lens = load(TABLE).pupil().wavefront
    edge = load(TABLE).field().pupil(22e-3, 0.0).wavefront
    assert same(edge, lens + lm.Wavefront.zernike({4: 0.5, 8: 0.3}, order="noll", unit="waves"))


def test_order_unit_normalization_and_direction_are_what_the_table_says(load):
    text = TABLE + 'order = "fringe"\nunit = "metres"\nnormalization = "edge"\ndirection = "y"\n'
    text = text.replace("0.1, 0]", "1e-7, 0]").replace("0.5, 0.3", "3e-7, 2e-7")
    found = load(text).field().pupil(0.0, 22e-3).wavefront - load(text).pupil().wavefront
    # Coefficients belong to the axes of the sensor, whatever direction the heights are along.
    expected = lm.Wavefront.zernike({4: 3e-7, 8: 2e-7}, order="fringe", unit="metres", normalization="edge",
                                    wavelength=550e-9)  # fmt: skip
    assert same(found, expected)


APERTURE = """
[aperture.spider]
vanes = 3
width = "2 mm"
[aperture.ellipse]
a = 0.9
b = 0.8
angle = "30 deg"
"""


@pytest.mark.parametrize("section", [SEIDEL, TABLE])
def test_what_narrows_the_aperture_and_its_amplitude_are_those_of_every_position(load, section):
    instrument = load(section + APERTURE)
    lit = dataclasses.replace(instrument, lens=dataclasses.replace(
        instrument.lens, aperture_diameter=None, f_number=2.0, sensor_distance=None, focus_distance=2.0,
        apodization=lm.Apodization((0.5, -0.2))))  # fmt: skip
    for made in (instrument, lit):
        pupil, there = made.pupil(), made.field().pupil(10e-3, 5e-3)
        assert there.spider == lm.Spider.equal(3, 2e-3 / 12.5e-3)
        assert there.vignetting == lm.Ellipse(0.9, 0.8, math.pi / 6)
        assert dataclasses.replace(pupil, wavefront=there.wavefront, geometry=None) == there
        # What the field adds is the same with and without.
        bare = load(section)
        assert same(
            there.wavefront - pupil.wavefront, bare.field().pupil(10e-3, 5e-3).wavefront - bare.pupil().wavefront
        )


def test_psfs_over_the_field_of_a_narrowed_aperture_are_those_of_its_pupils(load):
    instrument = load(SEIDEL + APERTURE)
    grid = instrument.field().grid(2, 2, sensor=instrument.sensor, shape=9, pixel=2e-6)
    by_hand = dataclasses.replace(
        instrument.lens.pupil(1.9),
        wavefront=instrument.pupil().wavefront
        + lm.Wavefront.from_seidel(W131=2.0, W222=-1.0, field=(9e-3 / 21.633307652784e-3, 6e-3 / 21.633307652784e-3)),
    )
    expected = lm.psf(by_hand, 9, 2e-6).values
    assert np.abs(grid[1, 1].values - expected).max() <= 2e-6 * expected.max()


def test_a_lens_without_a_field_says_so(load):
    instrument = dataclasses.replace(load(SEIDEL), aberrations_of_field=None)
    with pytest.raises(ValueError, match=r"the lens file of 'camera' must have a section \[field\]"):
        instrument.field()


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("W131 = 1\n", "field.sensor: is missing"),
        ('sensor = ["24 mm"]\nW131 = 1\n', "field.sensor (line 20): "),
        ('sensor = ["24 kg", "36 mm"]\nW131 = 1\n', "field.sensor (line 20): '24 kg' has the unknown unit 'kg'"),
        ('sensor = ["24 mm", "-36 mm"]\nW131 = 1\n', "field.sensor (line 20): must be positive"),
        (SENSOR, "field (line 19): needs Seidel coefficients (W131, W222, W220, W311), rows, or file: one of"),
        (SEIDEL + 'file = "lens.toml"\n', "field.file (line 23): lens.toml: the first columns must be"),
        (TABLE + "W131 = 1\n", "one of them, got rows and W131, W222, W220, W311"),
        (SEIDEL + "W132 = 1\n", "field.W132 (line 23): unknown key; did you mean"),
        (SENSOR + "W131 = inf\n", "field.W131 (line 21): must be finite"),
        (SEIDEL + 'order = "noll"\n', "order has no meaning with W131"),
        (TABLE + 'edge = "1 mm"\n', "edge has no meaning with rows"),
        (TABLE.replace("columns", "#"), 'field.rows (line 22): needs columns, such as columns = ["height", "Z4"]'),
        (SENSOR + "rows = 5\n", "field.rows (line 21): must be a list of lists"),
        (SENSOR + "file = 5\n", "field.file (line 21): must be the name of a CSV file, got 5"),
        (SENSOR + 'file = "no.csv"\n', "field.file (line 21): 'no.csv' cannot be read: No such file or directory"),
        (TABLE + 'order = "ansi2"\n', "field.order (line 23): "),
        (TABLE.replace("0.5, 0.3", '"a", "b"'), "field.rows (line 22): row 2, Z4: must be a number, got 'a'; row 2"),
        (TABLE.replace("0 mm", "1 mm"), "field: height must begin with 0, the axis, got 0.001"),
        (TABLE.replace("0.1, 0]", "0.1, 1]"), "field: the wavefront at height 0, on the axis"),
    ],
)  # fmt: skip
def test_a_fault_is_told_with_its_key_and_line(load, text, what):
    with pytest.raises(LensFileError) as caught:
        load(text)
    assert what in str(caught.value)
