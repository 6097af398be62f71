"""Lens files: what they may say, and how every fault in them is told with its key and line."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import lommel as lm
from lommel.lensfiles.lens_files import LensFileError

PLAIN = """\
name = "camera"
source = "nobody"

[lens]
focal_length = "50 mm"
f_number = 2.0
focus_distance = "2 m"
wavelength = "550 nm"

[object]
distance = "1.5 m"

[sensor]
pixel = "3.45 um"
shape = 33
"""


@pytest.fixture
def load(tmp_path: Path):
    """Write a lens file and load it; a change replaces the line of its key, or is added as the last of [lens]."""

    def write_and_load(*changes: str, text: str = PLAIN) -> lm.Instrument:
        for change in changes:
            key = change.partition(" =")[0]
            old = next((line for line in text.splitlines() if line.startswith(f"{key} =")), None)
            text = (
                text.replace("\n\n[object]", f"\n{change}\n\n[object]") if old is None else text.replace(old, change)
            )
        file = tmp_path / "lens.toml"
        file.write_text(text, encoding="utf-8")
        return lm.load_instrument(file)

    return write_and_load


def test_every_example_loads_and_says_where_its_figures_come_from(lens_file):
    instrument = lm.load_instrument(lens_file)
    assert len(instrument.name) > 10
    assert len(instrument.source) > 40
    assert instrument.pupil() == instrument.lens.pupil(instrument.object_distance)
    assert lm.load_instrument(str(lens_file)).lens == instrument.lens


def test_a_file_says_what_the_python_would(load):
    instrument = load()
    assert instrument.lens == lm.Lens(focal_length=0.05, f_number=2.0, focus_distance=2.0, wavelength=550e-9)
    assert instrument.object_distance == 1.5
    assert instrument.pixel == pytest.approx(3.45e-6)
    assert instrument.shape == (33, 33)
    assert (instrument.name, instrument.source, instrument.radii) == ("camera", "nobody", {})


@pytest.mark.parametrize(
    ("change", "example"),
    [
        ("focal_length = 0.05", "50 mm"),
        ('focus_distance = "2"', "2 m"),
        ("pixel = 3.45e-6", "3.45 um"),
        ('distance = "1"', "2 m"),
    ],
)
def test_a_length_without_a_unit_is_a_fault(load, change, example):
    assert f"is a length without a unit; write for example '{example}'" in fault(load, change)


def test_a_lens_has_a_model(load):
    lens = load('model = "aplanatic"', 'corrected_for = "focus"').lens
    assert (lens.model, lens.corrected_for) == ("aplanatic", "focus")
    with pytest.raises(LensFileError, match="the sine of the angle of the marginal ray would be"):
        load(
            'model = "aplanatic"',
            "f_number = 0.6",
            text=PLAIN.replace('focus_distance = "2 m"', 'sensor_distance = "30 mm"'),
        )
    with pytest.raises(LensFileError, match=r"f_number, .*, must be >= 0\.5, the limit in air"):
        load("f_number = 0.1")


def test_a_lens_has_an_amplitude(load):
    assert load().lens.apodization == 0.0
    assert load("apodization = 0.5").lens.apodization == load("apodization = 0.5").pupil().apodization == 0.5
    lens = load('apodization = "aplanatic"', 'model = "aplanatic"').lens
    assert lens.apodization == "aplanatic"
    assert not lens.pupil().illumination.uniform
    edge = '\n[field]\nsensor = ["24 mm", "36 mm"]\nW131 = 1.0\n'
    lit = load(text=PLAIN.replace("[lens]", "[lens]\napodization = 0.5") + edge)
    assert lit.field().pupil(1e-3, 2e-3).apodization == 0.5
    ringed = load("apodization = [1.0, -1.6, 0.37]").lens
    assert ringed.apodization == ringed.pupil().apodization == lm.Apodization((1.0, -1.6, 0.37))
    with pytest.raises(LensFileError, match="apodization 'aplanatic' needs model='aplanatic'"):
        load('apodization = "aplanatic"')


def test_an_object_is_in_focus_unless_told_otherwise(load):
    without = PLAIN.replace('[object]\ndistance = "1.5 m"\n', "")
    assert load(text=without).object_distance == load().lens.focus_distance == pytest.approx(2.0)
    assert load('distance = "inf"').object_distance == math.inf
    inside = without.replace('focus_distance = "2 m"', 'sensor_distance = "10 mm"')
    with pytest.raises(LensFileError, match=r"object.distance: must be given for a sensor closer than the focal"):
        load(text=inside)


def test_a_sensor_has_a_side_or_a_height_and_a_width(load):
    assert load("shape = [48, 64]").shape == (48, 64)


def test_the_sensor_distance_and_the_aperture_may_be_given_instead(load):
    text = PLAIN.replace("f_number = 2.0", 'aperture_diameter = "20 mm"').replace("focus_distance", "sensor_distance")
    lens = load(text=text.replace('"2 m"', '"51 mm"')).lens
    assert lens.aperture_diameter == pytest.approx(0.02)
    assert lens.sensor_distance == pytest.approx(0.051)


def test_all_aberrations_of_a_file_add(load):
    everything = (
        "[aberrations]\ndefocus = 1.0\nspherical = 2\nW020 = 0.5\nW040 = -0.25\nW060 = 0.125\nW080 = 1\n"
        'spherical_rms = "-55 nm"\n'
    )
    text = PLAIN.replace("f_number = 2.0", "f_number = 2.0\nobscuration = 0.3") + everything
    expected = (
        lm.Wavefront(1.0, 2.0)
        + lm.Wavefront.from_seidel(0.5, -0.25, 0.125, 1.0)
        + lm.Wavefront.balanced_spherical(-2 * math.pi * 0.1, 0.3)
    )
    found = load(text=text).lens.aberrations
    np.testing.assert_allclose(found.coefficients, expected.coefficients)


def test_radii_are_lengths_on_the_sensor_or_angles_on_the_sky(load):
    text = PLAIN + '[report]\nencircled_energy = ["5 um", "10 arcsec"]\n'
    radii = load(text=text).radii
    assert radii["5 um"] == pytest.approx(5e-6)
    assert radii["10 arcsec"] == pytest.approx(0.05 * 10 * math.pi / 648000)


def fault(load, *changes: str, text: str = PLAIN) -> str:
    """The message about a faulty file, which begins with its path, after that path."""
    with pytest.raises(LensFileError) as caught:
        load(*changes, text=text)
    path, message = str(caught.value).split("lens.toml: ", 1)
    assert Path(path).is_dir()
    return message


@pytest.mark.parametrize(
    ("change", "where", "what"),
    [
        ('focal_length = "50 kg"', "lens.focal_length (line 5)", "unknown unit 'kg'; a length is in m, km, cm"),
        ('focal_length = "-50 mm"', "lens.focal_length (line 5)", "must be positive, got -0.05 m"),
        ("fnumber = 2.0", "lens.fnumber (line 9)", "unknown key; did you mean f_number?"),
        ('wavelength = "550 m"', "lens.wavelength (line 8)", 'for 550 nm write "550 nm"'),
        ('pixel = "3.45 m"', "sensor.pixel (line 14)", 'for 3.45 um write "3.45 um"'),
    ],
    ids=lambda text: text if " = " in text else "",
)
def test_a_bad_entry_is_told_with_its_key_and_line(load, change, where, what):
    message = fault(load, change)
    assert message.startswith(where + ": ")
    assert what in message
    assert "\n" not in message


@pytest.mark.parametrize("distance", ["1.5 m", "1.9 m", "2 m"])
def test_a_file_without_a_shape_has_a_window_for_about_98_per_cent_of_the_light(load, distance):
    found = load(text=PLAIN.replace("shape = 33", "").replace("1.5 m", distance))
    assert found.shape is None
    assert found.window[0] == found.window[1] >= 33
    assert 0.975 < lm.psf(found.pupil(), found.window, found.pixel, integrate=True).energy < 0.999
    assert load().window == (33, 33)


@pytest.mark.parametrize(
    ("change", "what"),
    [
        ('aperture_diameter = "25 mm"', "exactly one of f_number and aperture_diameter"),
        ('sensor_distance = "51 mm"', "at most one of focus_distance and sensor_distance"),
        ('focus_distance = "49 mm"', "focus_distance must exceed the focal length"),
    ],
)
def test_entries_that_contradict_each_other_are_named(load, change, what):
    assert what in fault(load, change)


def test_a_spider_wider_than_its_aperture_is_refused_and_never_left_out(load):
    wide = PLAIN + '[aperture.spider]\nwidth = "60 mm"\nvanes = 4\n'  # the aperture has 25 mm
    assert "aperture.spider.width" in fault(load, text=wide)


def test_an_angle_in_degrees_without_a_unit_and_a_key_angle_of_a_spider_are_told_the_way_out(load):
    message = fault(load, text=PLAIN + '[aperture.spider]\nwidth = "1 mm"\nvanes = 4\nfirst = 45\nangle = 45\n')
    assert "aperture.spider.first (line 19): an angle without a unit must be in radians" in message
    assert 'for degrees write "45 deg"' in message
    assert "aperture.spider.angle (line 20): unknown key; first is the angle of the first vane" in message
    spider = load(text=PLAIN + '[aperture.spider]\nwidth = "1 mm"\nvanes = 4\nfirst = "405 deg"\n').lens.spider
    assert spider.angles[0] == pytest.approx(math.pi / 4)


@pytest.mark.parametrize("text", ["[lens", "a = ", PLAIN + "[lens]\n", PLAIN + "\x00", "a = " + "[" * 5000])
def test_what_is_no_toml_is_told(load, text):
    assert fault(load, text=text).startswith("not valid TOML: ")


ZERNIKE = """\
[aberrations.zernike]
order = "noll"
unit = "nm"
normalization = "rms"

[aberrations.zernike.terms]
7 = 55.0
11 = -11.0
"""
TABLE = "# order: noll\n# unit: waves\n# normalization: rms\n# wavelength: 1100 nm\nindex,value\n7,0.05\n11,-0.01\n"


def same(one: lm.Wavefront, two: lm.Wavefront) -> bool:
    return all(np.all(np.abs(c) < 1e-12) for c in (one - two).to_zernike().values())


def test_zernike_terms_are_those_of_the_wavelength_of_the_lens(load):
    expected = lm.Wavefront.zernike({7: 0.1, 11: -0.02}, order="noll", unit="waves")
    assert same(load(text=PLAIN + ZERNIKE).lens.aberrations, expected)
    in_waves = ZERNIKE.replace('"nm"', '"waves"').replace("55.0", "0.1").replace("-11.0", "-0.02")
    assert same(load(text=PLAIN + in_waves).lens.aberrations, expected)
    elsewhere = in_waves.replace("\n\n", '\nwavelength = "1100 nm"\n\n')
    assert same(load(text=PLAIN + elsewhere).lens.aberrations, 2.0 * expected)


def test_zernike_terms_may_stand_in_a_table_beside_the_lens_file(load, tmp_path):
    (tmp_path / "tables").mkdir()
    (tmp_path / "tables" / "a.csv").write_text(TABLE, encoding="utf-8")
    text = PLAIN + '[aberrations]\nW040 = 0.5\n[aberrations.zernike]\nfile = "tables/a.csv"\n'
    expected = lm.Wavefront.zernike({7: 0.1, 11: -0.02}, order="noll", unit="waves")
    assert same(load(text=text).lens.aberrations, expected + lm.Wavefront.from_seidel(W040=0.5))


def test_seidel_terms_have_a_field(load):
    text = PLAIN + "[aberrations]\nW131 = 0.5\nW222 = 0.25\nW220 = 1\nW311 = -2.0\nfield = [0.6, -0.3]\n"
    expected = lm.Wavefront.from_seidel(W131=0.5, W222=0.25, W220=1, W311=-2.0, field=(0.6, -0.3))
    assert same(load(text=text).lens.aberrations, expected)


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ('unit = "nm"\n', "", "aberrations.zernike.unit (line 16): is missing; it is one of radians, waves"),
        ("11 = -11.0", "07 = 1.0", "aberrations.zernike.terms.07 (line 23): the term 07 was given before"),
        (ZERNIKE, '[aberrations.zernike]\nfile = "a.csv"\nunit = "nm"\n', "aberrations.zernike.file (line 17):"),
    ],
)
def test_a_fault_among_zernike_terms_is_told_with_its_key_and_line(load, old, new, told):
    text = PLAIN + ZERNIKE
    assert old in text
    message = fault(load, text=text.replace(old, new))
    assert any(line.strip().startswith(told) for line in message.split("\n")), message


@pytest.mark.parametrize(
    ("table", "told"),
    [
        (None, "No such file or directory"),
        (TABLE.replace("# wavelength: 1100 nm\n", ""), "a.csv: must state the wavelength, as its unit is waves"),
    ],
)
def test_a_fault_of_a_table_is_told_with_its_name_and_that_of_the_lens_file(load, tmp_path, table, told):
    if table is not None:
        (tmp_path / "a.csv").write_text(table, encoding="utf-8")
    message = fault(load, text=PLAIN + '[aberrations.zernike]\nfile = "a.csv"\n')
    assert message.startswith("aberrations.zernike.file (line 17): ")
    assert "a.csv" in message
    assert told in message


@pytest.mark.parametrize(
    ("section", "told"),
    [
        ("[aperture.spider]\nwidth = 5", "exactly one of the two"),
        ("[aperture.ellipse]\na = 1.0\n[aperture.cat_eye]\nshift = [0.1, 0.0]", "one of ellipse and cat_eye"),
        ("[field]\nW131 = 1.0\nrows = [[0.0]]", "one of them, got rows and W131"),
        ("[field]\nsensor = 5\nW131 = 1.0\n[field.shading]\nlight = 5", "height and light: one of the two"),
        ("[channels]\nwavelengths = 5\nfile = 'c.csv'", "exactly one of the two"),
        ("[channels]\nwavelengths = ['550 nm']\ntol = 'a'", "tol has no meaning with wavelengths"),
    ],
)
def test_which_keys_exclude_each_other_is_told_together_with_what_is_wrong_in_any_section(load, section, told):
    with pytest.raises(LensFileError) as caught:
        load("f_number = 0", "aperture_diameter = '5 mm'", 'sensor_distance = "51 mm"', text=f"{PLAIN}{section}\n")
    message = str(caught.value)
    assert told in message
    assert "lens.f_number (line 6)" in message
    assert "lens (line 4): give exactly one of f_number and aperture_diameter, got both" in message
    assert message.count("\n  ") >= 3
