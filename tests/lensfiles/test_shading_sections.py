"""The sections [field.vignetting] and [field.shading] of lens files."""

from __future__ import annotations

import pytest

import lommel as lm

VIGNETTING = """
[field.vignetting]
height = ["0 mm", "10 mm", "22 mm"]
shift = [0.0, 0.2, 0.8]
radius = 1.1
"""
TABLE = """
[field.shading]
height = ["0 mm", "22 mm"]
light = [1.0, 0.5]
"""


def test_places_of_a_lens_file_see_what_its_field_says(tmp_path, lenses):
    text = lenses["camera-field"].read_text(encoding="utf-8")
    (tmp_path / "eyes.toml").write_text(text + VIGNETTING + TABLE, encoding="utf-8")
    field = lm.load_instrument(tmp_path / "eyes.toml").field()
    assert field.vignetting == lm.Vignetting([0.0, 10e-3, 22e-3], [0.0, 0.2, 0.8], 1.1)
    assert field.pupil(5e-3, 0.0).vignetting is None
    assert field.pupil(10e-3, 0.0).vignetting == lm.CatEye((0.2, 0.0), 1.1)
    expected = field.pupil(10e-3, 0.0).transmission * (1.0 - 0.5 * 10.0 / 22.0) / field.pupil(0.0, 0.0).transmission
    assert float(field.illumination(10e-3, 0.0)) == pytest.approx(expected)
    (tmp_path / "cos.toml").write_text(text + '[field.shading]\ndistance = "50 mm"\n', encoding="utf-8")
    assert lm.load_instrument(tmp_path / "cos.toml").field().shading == lm.Shading.cos4(50e-3)


@pytest.mark.parametrize(
    ("section", "message"),
    [
        (VIGNETTING.replace("0.2", "4.0"), "field.vignetting"),
        (VIGNETTING.replace('"0 mm", ', ""), "height must begin with 0, the axis"),
        ("[field.shading]\n", "needs distance"),
        (TABLE + 'distance = "5 mm"\n', "one of the two"),
        (TABLE.replace("1.0", "0.9"), "1 for the first"),
    ],
)
def test_what_cannot_be_is_told_with_its_section(tmp_path, lenses, section, message):
    text = lenses["camera-field"].read_text(encoding="utf-8")
    (tmp_path / "wrong.toml").write_text(text + section, encoding="utf-8")
    with pytest.raises(ValueError, match=message):
        lm.load_instrument(tmp_path / "wrong.toml")
