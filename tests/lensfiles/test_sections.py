"""Sections of lens files: sensor, colour, shading, field and its tables, aperture."""

from __future__ import annotations

import dataclasses
import math
import re
from pathlib import Path

import numpy as np
import pytest
from astropy.io import fits
from PIL import Image

import lommel as lm
from lommel.field.maps import Shading, Vignetting
from lommel.lensfiles.tables import FieldTable, read_csv, read_rows
from lommel.lensfiles.toml_files import LensFileError

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
    lens = load(TABLE).lens.pupil(1.9).wavefront
    edge = load(TABLE).field().pupil(22e-3, 0.0).wavefront
    assert same(edge, lens + lm.Wavefront.zernike({4: 0.5, 8: 0.3}, order="noll", unit="waves"))


def test_order_unit_normalization_and_direction_are_what_the_table_says(load):
    text = TABLE + 'order = "fringe"\nunit = "metres"\nnormalization = "edge"\ndirection = "y"\n'
    text = text.replace("0.1, 0]", "1e-7, 0]").replace("0.5, 0.3", "3e-7, 2e-7")
    found = load(text).field().pupil(0.0, 22e-3).wavefront - load(text).lens.pupil(1.9).wavefront
    # Coefficients belong to the axes of the sensor, whatever direction the heights are along.
    expected = lm.Wavefront.zernike({4: 3e-7, 8: 2e-7}, order="fringe", unit="metres", normalization="edge",
                                    wavelength=550e-9)  # fmt: skip
    assert same(found, expected)


TRACED = TABLE + 'order = "fringe"\nnormalization = "edge"\n'


def strehl_by_sums(x: float, y: float) -> float:
    """Return the Strehl ratio of TRACED, in focus, by sums over the pupil: Z4, and Z8 by its axis of the sensor."""
    radii, weights = np.polynomial.legendre.leggauss(40)
    rho, theta = np.meshgrid(0.5 * (radii + 1.0), np.arange(64) * math.tau / 64, indexing="ij")
    height = math.hypot(x, y) / 22e-3
    waves = (0.1 + 0.4 * height**2) * (2.0 * rho**2 - 1.0)  # even in the height
    waves += 0.3 * height * (3.0 * rho**3 - 2.0 * rho) * np.sin(theta)  # odd
    waves += 0.25 * rho**4  # W040 of the lens
    field = (np.exp(2j * math.pi * waves) * rho * weights[:, None]).sum() / 64
    return float(abs(field) ** 2)


def test_the_pupil_has_the_aberrations_of_the_field_at_its_place_by_default_on_the_axis(load):
    instrument = dataclasses.replace(load(TRACED + 'direction = "y"\n'), object_distance=2.0)
    assert lm.strehl(instrument.pupil()) == pytest.approx(strehl_by_sums(0.0, 0.0), abs=1e-9)
    assert instrument.pupil().radial
    corner = dataclasses.replace(instrument, place=(0.0, 22e-3))
    assert lm.strehl(corner.pupil()) == pytest.approx(strehl_by_sums(0.0, 22e-3), abs=1e-9)
    assert same(corner.pupil().wavefront, instrument.field().pupil(0.0, 22e-3).wavefront)
    stack = corner.pupil([1.8, 2.0])
    assert stack.shape == (2,)
    assert same(stack.wavefront[1], corner.pupil().wavefront)
    assert "on the axis" in repr(instrument)
    assert "0 m and 22 mm from the middle" in repr(corner)


def test_the_pupil_at_a_place_has_its_vignetting_and_its_colour(load):
    text = SEIDEL + '[field.vignetting]\nheight = ["0 mm", "22 mm"]\nshift = [0.0, 0.5]\nradius = 1.1\n'
    text += '[colour]\nwavelengths = ["500 nm", "600 nm"]\nlateral = ["9 um", "0 um"]\nheights = "22 mm"\n'
    instrument = load(text)
    corner, expected = dataclasses.replace(instrument, place=(12e-3, 9e-3)), instrument.field().pupil(12e-3, 9e-3)
    assert corner.pupil().vignetting == expected.vignetting
    assert corner.pupil().colour == expected.colour
    assert same(corner.pupil().in_light(500e-9).wavefront, expected.in_light(500e-9).wavefront)
    assert corner.pupil([1.8, 1.9]).in_light(500e-9).shape == (2,)


def test_a_place_beyond_the_map_or_without_a_map_is_refused(load):
    off_axis = SENSOR + 'columns = ["x", "y", "Z4"]\nrows = [["1 mm", "1 mm", 0.1], ["9 mm", "1 mm", 0.2], '
    off_axis += '["1 mm", "9 mm", 0.3]]\n'
    with pytest.raises(ValueError, match=r"place=\(0\.0, 0\.0\) must lie in the map of 'camera': .* lies outside"):
        load(off_axis).pupil()
    assert dataclasses.replace(load(off_axis), place=(2e-3, 2e-3)).pupil().shape == ()
    flat = dataclasses.replace(load(SEIDEL), aberrations_of_field=None, place=(1e-3, 0.0))
    with pytest.raises(ValueError, match="must have a section"):
        flat.pupil()


def test_a_wavelength_in_the_far_infrared_is_used_and_named(tmp_path):
    file = tmp_path / "lens.toml"
    file.write_text((LENS + SEIDEL).replace("550 nm", "550 um"))
    with pytest.warns(UserWarning, match=r"550 um, is in the far infrared, .* was it 550 nm\?"):
        assert lm.load_instrument(file).lens.wavelength == pytest.approx(550e-6)
    file.write_text((LENS + SEIDEL).replace("550 nm", "10.6 um"))
    assert lm.load_instrument(file).lens.wavelength == pytest.approx(10.6e-6)


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


@pytest.mark.parametrize(
    ("text", "what"),
    [
        (TABLE + 'order = "fringe"\n', 'needs normalization with order = "fringe": "edge"'),
        (TABLE + 'edge = "1 mm"\n', "edge has no meaning with rows"),
        (TABLE.replace("0 mm", "1 mm"), "field: height must begin with 0, the axis, got 0.001"),
        (TABLE + 'direction = "y"\n', 'it is that of heights along x: direction = "x"'),
        (TABLE.replace("0.1, 0]", "0.1, 1]"), "field: the wavefront at height 0 must be radially symmetric"),
    ],
)  # fmt: skip
def test_a_fault_is_told_with_its_key_and_line(load, text, what):
    with pytest.raises(LensFileError) as caught:
        load(text)
    assert what in str(caught.value)


PUPIL = lm.Pupil(wavelength=550e-9, f_number=2.0, obscuration=0.1)
PLAIN = {"unit": "waves", "normalization": "rms", "direction": "x"}


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
    coma = {"x": 8, "y": 7}[direction]
    table = FieldTable({"height": (0.0, 4e-3)}, {4: (0.1, 0.3), coma: (0.0, 0.2)}, "noll")
    field = table.field_map(PUPIL, unit=unit, normalization=normalization, direction=direction)
    found = field.pupil(*at)
    expected = lm.Wavefront.zernike(
        {4: 0.3, coma: 0.2}, order="noll", unit=unit, normalization=normalization, wavelength=550e-9
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
        (["y", "x", "Z4"], [[0, 0, 1]], "must be height, or x and y, got y, x"),
        (["height", "Z4", "Z4"], [[0, 1, 1]], "column Z4 occurs twice"),
        (["height", "Z4"], [[0]], "row 1 must have 2 cells, one for each column, got 1"),
    ],
)
def test_a_fault_is_told_with_its_row_and_column(columns, rows, what):
    with pytest.raises(ValueError, match=re.escape(what)):
        read_rows(columns, rows, "noll")


PLAIN_APERTURE_SECTION = """\
name = "a"
[lens]
focal_length = "800 mm"
f_number = 4.0
wavelength = "550 nm"
[sensor]
pixel = "1 um"
shape = 9
"""


@pytest.fixture
def load_of_aperture_section(tmp_path):
    def load_of_aperture_section(section: str) -> lm.Instrument:
        (tmp_path / "lens.toml").write_text(PLAIN_APERTURE_SECTION + section, encoding="utf-8")
        return lm.load_instrument(tmp_path / "lens.toml")

    return load_of_aperture_section


def test_vanes_have_a_width_in_metres_and_equal_angles(load_of_aperture_section):
    pupil = load_of_aperture_section('[aperture.spider]\nvanes = 3\nwidth = "2 mm"\nfirst = "90 deg"\n').pupil()
    assert pupil.spider == lm.Spider.equal(3, 0.02, math.pi / 2)


def test_vanes_may_lie_at_any_angles(load_of_aperture_section):
    pupil = load_of_aperture_section('[aperture.spider]\nangles = ["0 deg", "45 deg"]\nwidth = "2 mm"\n').pupil()
    assert pupil.spider.angles == pytest.approx((0.0, math.pi / 4))


def test_vignetting_is_an_ellipse_or_a_cats_eye(load_of_aperture_section):
    assert load_of_aperture_section(
        '[aperture.ellipse]\na = 1\nb = 0.8\nangle = "30 deg"\n'
    ).pupil().vignetting == lm.Ellipse(1.0, 0.8, math.pi / 6)
    assert load_of_aperture_section("[aperture.cat_eye]\nshift = [0.4, 0.2]\n").pupil().vignetting == lm.CatEye(
        (0.4, 0.2)
    )


@pytest.mark.parametrize("suffix", [".npy", ".png", ".tif", ".fits", ".fits.gz"])
@pytest.mark.parametrize("holds", ["amplitude", "intensity"])
def test_a_mask_is_read_from_beside_the_lens_file_its_rows_downwards(
    load_of_aperture_section, tmp_path, suffix, holds
):
    levels = np.zeros((8, 8), np.uint8)
    levels[5:, :], levels[5, 2] = 255, 51
    if suffix == ".npy":
        np.save(tmp_path / "mask.npy", levels / 255)
    elif ".fits" in suffix:
        fits.PrimaryHDU(levels / 255).writeto(tmp_path / f"mask{suffix}")
    else:
        Image.fromarray(levels).save(tmp_path / f"mask{suffix}")
    pupil = load_of_aperture_section(f'[aperture.mask]\nfile = "mask{suffix}"\nholds = "{holds}"\n').pupil()
    expected = levels / 255 if holds == "amplitude" else np.sqrt(levels / 255)
    np.testing.assert_allclose(pupil.mask.values, expected)
    # y rises with the rows: light passes where it is positive.
    assert abs(pupil.values(0.1, 0.6)[0]) == 1.0
    assert pupil.values(0.1, -0.6)[0] == 0.0


@pytest.mark.parametrize(
    ("section", "what"),
    [
        ('[aperture.spider]\nwidth = "2 mm"\nvanes = 3\nangles = [0.0]\n', "exactly one of the two"),
        ('[aperture.spider]\nwidth = "2 mm"\nfirst = 0.1\nangles = [0.0]\n', "first has no meaning with angles"),
        ('[aperture.mask]\nfile = "colour.png"\n', "must be a grey picture, got one in colour"),
        ('[aperture.mask]\nfile = "nan.npy"\n', "values"),
    ],
)
def test_a_fault_is_told_where_it_is(load_of_aperture_section, tmp_path, section, what):
    Image.new("RGB", (4, 4)).save(tmp_path / "colour.png")
    np.save(tmp_path / "nan.npy", np.full((4, 4), np.nan))
    with pytest.raises(LensFileError) as caught:
        load_of_aperture_section(section)
    assert what in str(caught.value)


BLOCKED = """\
[[aperture.blocked]]
type = "disc"
radius = "30 mm"
[[aperture.blocked]]
type = "strip"
start = ["0 m", 0.1]
end = ["300 mm", 0.1]
width = "2 mm"
[[aperture.blocked]]
type = "ellipse"
a = 0.1
b = "5 mm"
angle = "90 deg"
center = [0.5, "-20 mm"]
"""


def test_blocked_parts_are_taken_from_the_disc_in_metres_or_over_the_radius(load_of_aperture_section):
    lens = load_of_aperture_section(BLOCKED).lens  # of a radius of 100 mm
    parts = (
        lm.Disc(0.3)
        | lm.Polygon.strip((0.0, 0.1), (3.0, 0.1), 0.02)
        | lm.Ellipse(0.1, 0.05, math.pi / 2, (0.5, -0.2))
    )
    stop = lm.Disc() - parts
    assert lm.Pupil(stop=lens.stop).area == pytest.approx(lm.Pupil(stop=stop).area, rel=1e-12)
    at = np.linspace(-1, 1, 41)
    np.testing.assert_allclose(lens.stop.margin(at, at[:, None]), stop.margin(at, at[:, None]), atol=1e-12)


def test_clear_parts_are_joined(load_of_aperture_section):
    text = '[[aperture.clear]]\ntype = "disc"\nradius = 0.2\ncenter = [-0.5, 0]\n'
    text += '[[aperture.clear]]\ntype = "polygon"\ncorners = [[0.2, -0.2], [0.6, -0.2], [0.6, 0.2]]\n'
    text += '[[aperture.clear]]\ntype = "hexagon"\nradius = "10 mm"\ncenter = [0, 0.5]\n'
    area = math.pi * 0.2**2 + 0.08 + 1.5 * math.sqrt(3.0) * 0.1**2
    assert load_of_aperture_section(text).pupil().area == pytest.approx(area / math.pi, rel=1e-12)


def test_segments_have_phases_in_waves(load_of_aperture_section):
    text = '[aperture.segments]\nrings = 1\ngap = "1 mm"\n'
    bare = lm.Segments.hexagonal(1, 0.001 / 0.1)
    assert load_of_aperture_section(text).lens.stop == bare
    listed = load_of_aperture_section(
        text + "piston = [0.5, 0, 0, 0, 0, 0]\ntilt = [0, 0.25, 0, 0, 0, 0]\n"
    ).lens.stop
    assert listed == bare.phased([math.pi, 0, 0, 0, 0, 0], 0.0, [0, math.pi / 2, 0, 0, 0, 0])


@pytest.mark.parametrize("name", sorted(lm.telescopes.DIAMETERS))
def test_a_telescope_is_named(load_of_aperture_section, name):
    lens = load_of_aperture_section(f'[aperture]\ntelescope = "{name}"\n').lens
    assert lens.stop == getattr(lm.telescopes, name)()


@pytest.mark.parametrize(
    ("section", "what"),
    [
        ('[[aperture.clear]]\ntype = "disc"\nradius = 1\nwidth = 1\n', "width has no meaning for a disc"),
        ('[[aperture.clear]]\ntype = "disc"\nradius = "1"\n', "aperture.clear.radius (line 11): '1' is a length"),
        ("[aperture.segments]\ngap = 0.1\n", "aperture.segments (line 9): gap has no meaning without rings"),
        ("[aperture.segments]\npiston = [0.1]\n", "segments needs rings or a telescope with segments"),
        ('[aperture]\ntelescope = "keck"\n[aperture.segments]\nrings = 2\n', "exactly one of them"),
        ('[aperture]\ntelescope = "vlt"\n[aperture.segments]\nrings = 2\n', "takes one of segments and telescope"),
        ("[aperture.segments]\nrings = 1\npiston = [0.1]\n", "aperture.segments.piston (line 11): must have one"),
    ],
)  # fmt: skip
def test_a_fault_of_a_shape_names_its_entry(load_of_aperture_section, section, what):
    with pytest.raises(LensFileError) as caught:
        load_of_aperture_section(section)
    assert what in str(caught.value)


def test_complex_numbers_are_no_intensity(load_of_aperture_section, tmp_path):
    np.save(tmp_path / "phase.npy", np.full((8, 8), 1j))
    load_of_aperture_section('[aperture.mask]\nfile = "phase.npy"\n')
    with pytest.raises(ValueError, match=r'must hold real numbers with holds = "intensity", got complex numbers'):
        load_of_aperture_section('[aperture.mask]\nfile = "phase.npy"\nholds = "intensity"\n')


LENS_COLOUR_SECTION = """
[lens]
focal_length = "50 mm"
f_number = 2.8
focus_distance = "2 m"
wavelength = "550 nm"
[sensor]
pixel = "3.45 um"
"""
COLOUR = """
[colour]
wavelengths = ["450 nm", "550 nm", "650 nm"]
focus_shift = ["60 um", "0 um", "40 um"]
lateral = ["4 um", "0 um", "-3 um"]
heights = "20 mm"
"""


def load_of_colour_section(tmp_path, text, **options):
    path = tmp_path / "lens.toml"
    path.write_text(LENS_COLOUR_SECTION + text)
    return lm.load_instrument(path, **options)


def test_the_colour_of_a_file_is_that_of_its_lens(tmp_path):
    expected = lm.Colour([450e-9, 550e-9, 650e-9], [60e-6, 0.0, 40e-6], [4e-6, 0.0, -3e-6], 20e-3)
    assert load_of_colour_section(tmp_path, COLOUR).lens.colour == expected
    assert load_of_colour_section(tmp_path, "").lens.colour is None


def test_lateral_colour_may_be_known_at_several_heights(tmp_path):
    several = COLOUR.replace('["4 um", "0 um", "-3 um"]', '[["1 um", "0 um", "0 um"], ["4 um", "0 um", "-3 um"]]')
    found = load_of_colour_section(tmp_path, several.replace('"20 mm"', '["10 mm", "20 mm"]')).lens.colour
    assert found.lateral == ((1e-6, 0.0, 0.0), (4e-6, 0.0, -3e-6))


def test_the_field_of_a_file_has_its_lateral_colour(tmp_path):
    field = '[field]\nsensor = ["24 mm", "32 mm"]\nW222 = 0.3\n'
    pupil = load_of_colour_section(tmp_path, COLOUR + field).field().pupil(10e-3, 0.0)
    assert lm.centroid(pupil.in_light(450e-9)) == pytest.approx([2e-6, 0.0], abs=1e-10)


def test_channels_are_wavelengths_weights_or_a_table(tmp_path):
    waves = '[channels]\nwavelengths = ["500 nm", "600 nm"]\n'
    assert load_of_colour_section(tmp_path, waves).channels == lm.Channels.of_wavelengths([500e-9, 600e-9])
    weights = waves + "[channels.weights]\nwarm = [1, 3]\ncold = [1, 0]\n"
    assert load_of_colour_section(tmp_path, weights).channels == lm.Channels(
        [500e-9, 600e-9], [[1, 3], [1, 0]], ["warm", "cold"]
    )
    (tmp_path / "s.csv").write_text("nm,a,b\n400,1,0\n500,1,1\n600,0,1\n")
    (tmp_path / "f.csv").write_text("nm,t\n400,1\n600,0.5\n")
    table = '[channels]\nfile = "s.csv"\nfilters = ["f.csv"]\npaths = "2 um"\ntol = 1e-2\n'
    expected = lm.load_channels(tmp_path / "s.csv", filters=tmp_path / "f.csv", paths=2e-6, tol=1e-2)
    assert load_of_colour_section(tmp_path, table).channels == expected
    assert load_of_colour_section(tmp_path, "").channels is None


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('[colour]\nwavelengths = ["450 nm", "550 nm"]\nfocus_shift = ["1 um"]\n', "focus_shift must be one for"),
        ('[colour]\nwavelengths = ["600 nm", "650 nm"]\n', "known from 600 to 650 nm, got 550"),
        ('[channels]\nwavelengths = ["500 nm"]\nfilters = ["f.csv"]\n', "filters has no meaning with wavelengths"),
        ('[channels]\nwavelengths = ["500 nm"]\nweights.red = [1, 2]\n', "one for each of 1 wavelengths"),
    ],
)
def test_faults_are_told(tmp_path, text, message):
    with pytest.raises(LensFileError, match=message):
        load_of_colour_section(tmp_path, text)


def test_tables_elsewhere_are_refused_where_the_folder_is_all(tmp_path):
    (tmp_path / "s.csv").write_text("nm,a\n400,1\n500,1\n")
    (tmp_path / "in").mkdir()
    for keys in ('file = "../s.csv"', 'file = "s.csv"\nfilters = ["../s.csv"]'):
        with pytest.raises(LensFileError, match="must lie in the folder"):
            load_of_colour_section(tmp_path / "in", f"[channels]\n{keys}\n", folder_only=True)


def test_pixels_may_have_two_sides_and_an_active_part(tmp_path, lenses):
    text = lenses["phone"].read_text(encoding="utf-8")
    given = re.sub(r"(?m)^pixel = .*$", 'pixel = ["4 um", "6 um"]\nfill = [0.9, 0.5]', text)
    (tmp_path / "oblong.toml").write_text(given, encoding="utf-8")
    found = lm.load_instrument(tmp_path / "oblong.toml")
    assert found.pixel == (4e-6, 6e-6)
    assert found.pitch == (4e-6, 6e-6)
    assert found.sensor_options == {"integrate": None, "fill": (0.9, 0.5)}
    with pytest.raises(ValueError, match="pixels must be square"):
        _ = found.side


VIGNETTING = """
[field.vignetting]
height = ["0 mm", "10 mm", "22 mm"]
shift = [0.0, 0.2, 0.8]
radius = 1.1
"""
TABLE_SHADING_SECTIONS = """
[field.shading]
height = ["0 mm", "22 mm"]
light = [1.0, 0.5]
"""


def test_places_of_a_lens_file_see_what_its_field_says(tmp_path, lenses):
    text = lenses["camera-field"].read_text(encoding="utf-8")
    (tmp_path / "eyes.toml").write_text(text + VIGNETTING + TABLE_SHADING_SECTIONS, encoding="utf-8")
    field = lm.load_instrument(tmp_path / "eyes.toml").field()
    assert field.vignetting == Vignetting([0.0, 10e-3, 22e-3], [0.0, 0.2, 0.8], 1.1)
    assert field.pupil(5e-3, 0.0).vignetting is None
    assert field.pupil(10e-3, 0.0).vignetting == lm.CatEye((0.2, 0.0), 1.1)
    expected = field.pupil(10e-3, 0.0).transmission * (1.0 - 0.5 * 10.0 / 22.0) / field.pupil(0.0, 0.0).transmission
    assert float(field.illumination(10e-3, 0.0)) == pytest.approx(expected)
    (tmp_path / "cos.toml").write_text(text + '[field.shading]\ndistance = "50 mm"\n', encoding="utf-8")
    assert lm.load_instrument(tmp_path / "cos.toml").field().shading == Shading.cos4(50e-3)


@pytest.mark.parametrize(
    ("section", "message"),
    [
        (VIGNETTING.replace('"0 mm", ', ""), "height must begin with 0, the axis"),
        (TABLE_SHADING_SECTIONS.replace("1.0", "0.9"), "the first 1"),
    ],
)
def test_what_cannot_be_is_told_with_its_section(tmp_path, lenses, section, message):
    text = lenses["camera-field"].read_text(encoding="utf-8")
    (tmp_path / "wrong.toml").write_text(text + section, encoding="utf-8")
    with pytest.raises(ValueError, match=message):
        lm.load_instrument(tmp_path / "wrong.toml")
