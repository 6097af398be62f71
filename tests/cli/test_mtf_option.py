"""`lommel psf --mtf`: contrast at the frequencies that the pixels end at, over the field and in every channel."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest

import lommel as lm

LENS = """\
[lens]
focal_length = "4.3 mm"
f_number = 1.8
wavelength = "550 nm"

[sensor]
pixel = ["1.22 um", "2.44 um"]
shape = 9
"""


@pytest.fixture
def told(call_lommel, tmp_path):
    """Return what --mtf says as JSON, of a file or of a text."""

    def ask(lens: str | Path, *options: object) -> dict:
        if isinstance(lens, str):
            (tmp_path / "lens.toml").write_text(lens, encoding="utf-8")
        file = "lens.toml" if isinstance(lens, str) else lens
        result = call_lommel("psf", file, "--mtf", "--json", *options, folder=tmp_path)
        assert result.returncode == 0, result.stderr
        return json.loads(result.stdout)["mtf"]

    return ask


def perfect(frequency: float, cutoff: float) -> float:
    f = frequency / cutoff
    return 2.0 / math.pi * (math.acos(f) - f * math.sqrt(1.0 - f * f))


def test_a_perfect_lens_has_the_contrast_of_overlapping_discs_and_of_its_pixels(told):
    found, cutoff = told(LENS), 1.0 / (550e-9 * 1.8)
    down, across = 0.5 / 1.22e-6, 0.5 / 2.44e-6
    assert found["frequency"] == pytest.approx([across, down])
    (row,) = found["rows"]
    assert (row["x"], row["y"], row["channel"]) == (None, None, None)
    for name, share in (("nyquist", 1.0), ("half_nyquist", 0.5)):
        pixel = math.sin(0.5 * math.pi * share) / (0.5 * math.pi * share)
        expected = [pixel * perfect(share * frequency, cutoff) for frequency in (across, down)]
        assert row[name] == pytest.approx(expected, abs=1e-6)


def test_there_is_a_row_for_each_place_and_each_channel(told, lenses, call_lommel, tmp_path):
    file = lenses["camera-field"]
    found = told(file, "--field", "2x3", "--colour", "--shape", "5")
    instrument, channels = lm.load_instrument(file), lm.Channels.rgb()
    field, pixel = instrument.field(), instrument.pixel
    assert [row["channel"] for row in found["rows"]] == list(channels.names) * 6
    for row in found["rows"][3:9]:
        pairs = dict(channels)[row["channel"]]
        light = lm.Polychromatic([w for w, _ in pairs], [share for _, share in pairs])
        expected = lm.mtf(field.pupil(row["x"], row["y"]), 0.0, 0.25 / pixel, pixel=pixel, spectrum=light)
        assert row["half_nyquist"][1] == pytest.approx(float(expected), abs=2e-6)
    shown = call_lommel("psf", file, "--mtf", "--field", "2x3", "--shape", "5", folder=tmp_path).stdout
    assert sum(" mm, " in line for line in shown[shown.index("MTF, pixel") :].splitlines()) == 6
