"""Image quality of lenses: attributes are what the measures of the library say, and plain data are the same."""

from __future__ import annotations

import dataclasses
import json
import math

import pytest

import lommel as lm


@pytest.fixture(scope="module")
def quality(lenses):
    phone = dataclasses.replace(lm.load_instrument(lenses["phone"]), object_distance=1.2, pixel=(2e-6, 3e-6))
    return lm.ImageQuality(phone)


def test_attributes_are_those_of_the_library_in_both_directions(quality):
    pupil = quality.instrument.pupil()
    assert quality.strehl == float(lm.strehl(pupil))
    assert quality.rms_waves == float(lm.rms(pupil, unit="waves"))
    assert quality.mtf50(0.5 * math.pi) == pytest.approx(float(lm.mtf_frequency(pupil, angle=0.5 * math.pi)))
    along_x, along_y = (quality.mtf(1e5, angle, pixel=True) for angle in (0.0, 0.5 * math.pi))
    assert along_x / along_y == pytest.approx(math.sin(0.3 * math.pi) / 1.5 / math.sin(0.2 * math.pi), rel=1e-6)
    near, far = quality.depth_of_field
    blur = [2.0 * float(quality.lens.pupil(end).geometric_radius()) for end in (near, far)]
    assert blur == pytest.approx([6e-6, 6e-6])


def test_plain_data_have_the_attributes_and_the_reasons_of_what_is_missing(quality, monkeypatch):
    def refuse(self, angle=0.0):
        raise ValueError("takes too long")

    monkeypatch.setattr(lm.ImageQuality, "mtf50", refuse)
    found = json.loads(json.dumps(quality.to_dict(), allow_nan=False))
    assert found["refused"] == ["takes too long"]
    assert found["mtf50"] is found["mtf50_y"] is None
    assert found["strehl_at_peak"] == quality.strehl_at_peak
    assert found["fwhm_with_pixel"] == quality.fwhm(pixel=True) != quality.fwhm()
    assert found["in_focus"] == {"near": quality.depth_of_field[0], "far": quality.depth_of_field[1], "blur": 6e-6}
    assert [row["fraction"] for row in found["encircled_energy"]] == quality.encircled_energy()[0]
    assert found["wavelength"] == quality.lens.wavelength


def test_telescopes_and_microscopes_have_no_depth_of_field(lenses):
    for name in ("hubble-1990", "microscope-20x"):
        quality = lm.ImageQuality(lm.load_instrument(lenses[name]))
        assert quality.depth_of_field is quality.hyperfocal_distance is None
