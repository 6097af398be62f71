"""The section [sensor] of lens files: pixels of two sides, and what of them is active."""

from __future__ import annotations

import re

import pytest

import lommel as lm


def test_pixels_may_have_two_sides_and_an_active_part(tmp_path, lenses):
    text = lenses["phone"].read_text(encoding="utf-8")
    given = re.sub(r"(?m)^pixel = .*$", 'pixel = ["4 um", "6 um"]\nfill = [0.9, 0.5]', text)
    (tmp_path / "oblong.toml").write_text(given, encoding="utf-8")
    found = lm.load_instrument(tmp_path / "oblong.toml")
    assert found.pixel == (4e-6, 6e-6)
    assert found.pitch == (4e-6, 6e-6)
    assert found.sensor_options == {"integrate": None, "fill": (0.9, 0.5)}
    with pytest.raises(ValueError, match="pixel must be square"):
        _ = found.side
    for wrong, message in (
        ('pixel = ["4 um", "6"]', "sensor.pixel"),
        ('pixel = ["4 um", "6 um", "8 um"]', "pixel must be one number"),
        ('pixel = "4 m"', "must be at most 0.1"),
        ('pixel = "4 um"\nfill = 1.2', "fill must be at most 1"),
        ('pixel = "4 um"\nfill = "half"', "fill must be a real number"),
    ):
        (tmp_path / "wrong.toml").write_text(re.sub(r"(?m)^pixel = .*$", wrong, text), encoding="utf-8")
        with pytest.raises(ValueError, match=message):
            lm.load_instrument(tmp_path / "wrong.toml")
