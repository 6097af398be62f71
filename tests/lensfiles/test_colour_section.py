"""The sections [colour] and [channels] of lens files."""

from __future__ import annotations

import pytest

import lommel as lm

LENS = """
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


def load(tmp_path, text, **options):
    path = tmp_path / "lens.toml"
    path.write_text(LENS + text)
    return lm.load_instrument(path, **options)


def test_the_colour_of_a_file_is_that_of_its_lens(tmp_path):
    expected = lm.Colour([450e-9, 550e-9, 650e-9], [60e-6, 0.0, 40e-6], [4e-6, 0.0, -3e-6], 20e-3)
    assert load(tmp_path, COLOUR).lens.colour == expected
    assert load(tmp_path, "").lens.colour is None


def test_lateral_colour_may_be_known_at_several_heights(tmp_path):
    several = COLOUR.replace('["4 um", "0 um", "-3 um"]', '[["1 um", "0 um", "0 um"], ["4 um", "0 um", "-3 um"]]')
    found = load(tmp_path, several.replace('"20 mm"', '["10 mm", "20 mm"]')).lens.colour
    assert found.lateral == ((1e-6, 0.0, 0.0), (4e-6, 0.0, -3e-6))


def test_the_field_of_a_file_has_its_lateral_colour(tmp_path):
    field = '[field]\nsensor = ["24 mm", "32 mm"]\nW222 = 0.3\n'
    pupil = load(tmp_path, COLOUR + field).field().pupil(10e-3, 0.0)
    assert lm.centroid(pupil.in_light(450e-9)) == pytest.approx([2e-6, 0.0], abs=1e-10)


def test_channels_are_wavelengths_weights_or_a_table(tmp_path):
    waves = '[channels]\nwavelengths = ["500 nm", "600 nm"]\n'
    assert load(tmp_path, waves).channels == lm.Channels.of_wavelengths([500e-9, 600e-9])
    weights = waves + "[channels.weights]\nwarm = [1, 3]\ncold = [1, 0]\n"
    assert load(tmp_path, weights).channels == lm.Channels([500e-9, 600e-9], [[1, 3], [1, 0]], ["warm", "cold"])
    (tmp_path / "s.csv").write_text("nm,a,b\n400,1,0\n500,1,1\n600,0,1\n")
    (tmp_path / "f.csv").write_text("nm,t\n400,1\n600,0.5\n")
    table = '[channels]\nfile = "s.csv"\nfilters = ["f.csv"]\npaths = "2 um"\ntol = 1e-2\n'
    expected = lm.load_channels(tmp_path / "s.csv", filters=tmp_path / "f.csv", paths=2e-6, tol=1e-2)
    assert load(tmp_path, table).channels == expected
    assert load(tmp_path, "").channels is None


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('[colour]\nwavelengths = ["450 nm"]\n', "wavelengths"),
        (
            '[colour]\nwavelengths = ["450 nm", "550 nm"]\nfocus_shift = ["1 um"]\n',
            "focus_shift must be one for each of 2",
        ),
        ('[colour]\nwavelengths = ["600 nm", "650 nm"]\n', "known from 600 to 650 nm, got 550"),
        ("[channels]\n", "needs file"),
        ('[channels]\nfile = "none.csv"\n', "none.csv"),
        ('[channels]\nwavelengths = ["500 nm"]\nfilters = ["f.csv"]\n', "filters has no meaning with wavelengths"),
        ('[channels]\nwavelengths = ["500 nm"]\nweights.red = [1, 2]\n', "one for each of 1 wavelengths"),
    ],
)
def test_faults_are_told(tmp_path, text, message):
    with pytest.raises(lm.lensfiles.lens_files.LensFileError, match=message):
        load(tmp_path, text)


def test_tables_elsewhere_are_refused_where_the_folder_is_all(tmp_path):
    (tmp_path / "s.csv").write_text("nm,a\n400,1\n500,1\n")
    (tmp_path / "in").mkdir()
    for keys in ('file = "../s.csv"', 'file = "s.csv"\nfilters = ["../s.csv"]'):
        with pytest.raises(lm.lensfiles.lens_files.LensFileError, match="must lie in the folder"):
            load(tmp_path / "in", f"[channels]\n{keys}\n", folder_only=True)
